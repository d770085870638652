#include "experiment/beam_frequencies.h"

#include <math.h>

#include "base/parameters_number.h"
#include "base/text.h"
#include "beam/modes.h"

static const Observable observables[BEAM_FREQUENCIES] = {
    {"frequency_1", "Hz", "first natural frequency"},   {"frequency_2", "Hz", "second natural frequency"},
    {"frequency_3", "Hz", "third natural frequency"},   {"frequency_4", "Hz", "fourth natural frequency"},
    {"frequency_5", "Hz", "fifth natural frequency"},   {"frequency_6", "Hz", "sixth natural frequency"},
    {"frequency_7", "Hz", "seventh natural frequency"}, {"frequency_8", "Hz", "eighth natural frequency"},
};

static const Parameter *find_parameter(const void *given, const char *name) {
    (void)given;
    const Parameter *row = parameters_find(beam_table(), name);
    return row && (row->kind == PARAMETER_NUMBER || row->kind == PARAMETER_WHOLE) ? row : NULL;
}

static double nominal(const void *given, const char *name) {
    const Parameter *row = find_parameter(given, name);
    return row ? parameters_number_get(row, given) : (double)NAN;
}

static void set(Beam *beam, const char *name, double value, Fault *fault) {
    const Parameter *row = find_parameter(beam, name);
    JsonFile file = {.path = "", .root = json_number(value)};
    JsonNode node = json_root(&file);
    Arena none = {0}; /* numbers need no memory */
    if (row)
        parameters_read_value(row, beam, &node, &none, fault);
    else
        fault_add(fault, "%s is not a numeric parameter of a beam", name);
    json_decref(file.root);
}

static void run_one(const Beam *nominal_beam, const char *const *names, size_t name_count, Trial *trial) {
    Beam beam = *nominal_beam;
    Fault fault = {0};
    Modes modes;
    for (size_t i = 0; i < name_count; i++)
        set(&beam, names[i], trial->at[i], &fault);
    if (!fault.total && beam_check(&beam, beam.name, &fault) && modes_of_beam(&modes, &beam)) {
        for (size_t m = 0; m < BEAM_FREQUENCIES; m++)
            trial->observed[m] = m < modes.count ? modes.frequency[m] / (2 * M_PI) : (double)NAN;
        modes_clear(&modes);
    } else {
        trial->fault = text_copy(fault.count ? fault.lines[0] : "the beam has no modes");
    }
    trial->done = true;
    fault_clear(&fault);
}

static void run(const void *given, const char *const *names, size_t name_count, Trial *trials, size_t count, bool carry,
                const Stop *stop) {
    (void)carry; /* nothing moves */
    for (size_t i = 0; i < count && !stop_requested(stop); i++)
        run_one(given, names, name_count, &trials[i]);
}

static void tell_unknown(const void *given, const char *name, const char *place, Fault *fault) {
    (void)given;
    JsonFile file = {.path = place, .root = json_null()};
    JsonNode node = json_root(&file);
    parameters_fault_unknown(beam_table(), name, &node, fault);
}

void beam_frequencies_open(Experiment *experiment, const Beam *beam) {
    *experiment = (Experiment){.kind = "beam",
                               .observables = observables,
                               .observable_count = BEAM_FREQUENCIES,
                               .batch = 1,
                               .given = (void *)beam,
                               .parameter = find_parameter,
                               .unknown = tell_unknown,
                               .nominal = nominal,
                               .run = run};
}
