#include "laboratory/beam/controls.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/parameters_number.h"
#include "experiment/beam_numbers.h"

/* The display of a parameter. */
typedef struct Looks {
    const char *name, *label;
    const char *unit; /* NULL: the unit of the parameter's row */
    double factor;    /* displayed value = value x factor */
    double low, high; /* range of the slider as multiples of the value in the file; 0 and 0: from `least` to `most` */
    double least, most;
    double from, to; /* range of an orbit diagram as multiples of the value in the file; 0 and 0: the slider's range */
    bool logarithmic, first;
} Looks;

/* The main parameters come first. The orbit diagram over the frequency covers the published one, figure 8, and the
 * range below it. */
static const Looks all_looks[] = {
    {"drive.frequency", "Excitation", NULL, 1, 0, 0, 20, 400, 1 / 15., 16 / 15., false, true},
    {"drive.force", "Force", NULL, 1, 0, 2, 0, 0, 0.1, 2, false, true},
    {"joint.clearance", "Gap", "mm", 1e3, 0, 2, 0, 0.25e-3, 0, 2, false, true},
    {"beam.length", "Length", "mm", 1e3, 0.9, 1.1, 0, 0, 0.95, 1.05, false, true},
    {"joint.stiffness", "Contact stiffness", "MN/m", 1e-6, 0.01, 100, 0, 0, 0.1, 3, true, true},
    {"joint.damping", "Contact damping", NULL, 1, 0, 4, 0, 1000, 0, 3, false, true},
    {"joint.release", "Contact release", NULL, 1, 0, 0, 0, 1, 0, 0, false, true},
    {"beam.width", "Width", "mm", 1e3, 0.5, 2, 0, 0, 0, 0, false, false},
    {"beam.thickness", "Thickness", "mm", 1e3, 0.8, 1.25, 0, 0, 0, 0, false, false},
    {"beam.youngs_modulus", "Young's modulus", "GPa", 1e-9, 0.5, 2, 0, 0, 0, 0, false, false},
    {"beam.density", "Density", NULL, 1, 0.5, 2, 0, 0, 0, 0, false, false},
    {"beam.damping_ratio", "Damping of the modes", "%", 100, 0, 3, 0, 0.1, 0, 0, false, false},
    {"beam.modes", "Natural modes", NULL, 1, 0, 0, 1, 24, 0, 0, false, false},
    {"beam.elements", "Finite elements", NULL, 1, 0, 0, 8, 60, 0, 0, false, false},
    {"pivot.position", "Place", "mm", 1e3, 0, 0, 0, 0.1, 0, 0, false, false},
    {"pivot.translational_stiffness", "Stiffness", "MN/m", 1e-6, 0.1, 10, 0, 0, 0, 0, true, false},
    {"pivot.rotational_stiffness", "Rotational stiffness", NULL, 1, 0, 3, 0, 100, 0, 0, false, false},
    {"shaker.position", "Place", "mm", 1e3, 0.5, 1.5, 0, 0, 0, 0, false, false},
    {"shaker.moving_mass", "Moving mass", "g", 1e3, 0, 3, 0, 0.1, 0, 0, false, false},
    {"shaker.stiffness", "Stiffness", "kN/m", 1e-3, 0, 3, 0, 1e5, 0, 0, false, false},
    {"shaker.damping", "Damping", NULL, 1, 0, 3, 0, 50, 0, 0, false, false},
    {"run.transient_cycles", "Skipped cycles", NULL, 1, 0, 0, 0, 2000, 0, 0, false, false},
    {"run.cycles", "Recorded cycles", NULL, 1, 0, 0, 10, 1000, 0, 0, false, false},
};
enum { LOOKS = sizeof all_looks / sizeof *all_looks };
_Static_assert((int)LOOKS <= (int)BEAM_VALUES, "a parameter for each");

static const char set_here[] = "assumed: set in the window";

static const char *group_of(const char *name) {
    static const char *const groups[] = {"Drive", "Joint", "Beam", "Pivot", "Shaker", "Run"};
    for (size_t g = 0; g < sizeof groups / sizeof *groups; g++)
        if (strncmp(groups[g] + 1, name + 1, strlen(groups[g]) - 1) == 0)
            return groups[g];
    return "";
}

static const Looks *looks_of(const char *name) {
    for (size_t i = 0; i < LOOKS; i++)
        if (strcmp(all_looks[i].name, name) == 0)
            return &all_looks[i];
    return NULL;
}

/* Sets the useful part of the range: around the value in the file if that is positive. */
static void set_range(PanelParameter *parameter, const Looks *looks) {
    double value = parameter->initial;
    bool about = looks->high > 0 && value > 0;
    parameter->low = fmax(about ? looks->low * value : looks->least, parameter->row->low);
    parameter->high = fmax(about ? looks->high * value : 0, looks->most);
    if (parameter->row->kind != PARAMETER_CHOICE)
        parameter->high = fmin(parameter->high, parameter->row->high);
    if (!about) {
        parameter->low = fmin(parameter->low, value);
        parameter->high = fmax(parameter->high, value);
    }
}

static PanelParameter make_parameter(const BeamControls *controls, const Looks *looks) {
    const ParameterTable *table = beam_table();
    const Parameter *row = parameters_find(table, looks->name);
    PanelParameter parameter = {.name = looks->name,
                                .group = group_of(looks->name),
                                .label = looks->label,
                                .row = row,
                                .meaning = row->meaning,
                                .provenance = controls->file.provenance[row - table->rows],
                                .unit = looks->unit,
                                .factor = looks->factor,
                                .initial = parameters_number_get(row, &controls->file),
                                .logarithmic = looks->logarithmic,
                                .first = looks->first};
    set_range(&parameter, looks);
    return parameter;
}

/* Presets -----------------------------------------------------------------------------------------------------------*/

/* The published cases; the type is added to a preset's name once it is determined. */
static const struct {
    const char *name, *meaning;
    double frequency; /* Hz */
    double longer;    /* 1 */
} presets[BEAM_PRESETS] = {
    {"160 Hz", "the lower end of the published sweeps", 160, 1},
    {"190 Hz", "the published periodic case", 190, 1},
    {"245 Hz", "near the resonance, where forces change fast", 245, 1},
    {"290 Hz", "the case of the published longer beam, before it is made longer", 290, 1},
    {"300 Hz", "the published chaotic case", 300, 1},
    {"290 Hz, 1 % longer", "the beam is made 1 % longer at 290 Hz", 290, 1.01},
};

void beam_controls_prefer(const BeamControls *controls, size_t preset, Beam *beam) {
    *beam = controls->file;
    Fault none = {0};
    beam_controls_set(controls, beam, "drive.frequency", presets[preset].frequency, &none);
    beam_controls_set(controls, beam, "beam.length", controls->file.length * presets[preset].longer, &none);
    fault_clear(&none);
}

bool beam_controls_name_type(BeamControls *controls, const Beam *beam, const char *type) {
    bool named = false;
    for (size_t p = 0; p < BEAM_PRESETS; p++) {
        Beam preferred;
        beam_controls_prefer(controls, p, &preferred);
        if (controls->typed[p] || !beam_numbers_same(&preferred, beam))
            continue;
        snprintf(controls->names[p], BEAM_PRESET_NAME, "%s  %s", type, presets[p].name);
        named = controls->typed[p] = true;
    }
    return named;
}

/* -------------------------------------------------------------------------------------------------------------------*/

void beam_controls_open(BeamControls *controls, Beam *file) {
    *controls = (BeamControls){.file = *file, .count = LOOKS};
    *file = (Beam){0};
    for (size_t i = 0; i < LOOKS; i++)
        controls->parameters[i] = make_parameter(controls, &all_looks[i]);
    for (size_t p = 0; p < BEAM_PRESETS; p++) {
        snprintf(controls->names[p], BEAM_PRESET_NAME, "%s", presets[p].name);
        controls->presets[p] = (Preset){controls->names[p], presets[p].meaning};
    }
}

void beam_controls_close(BeamControls *controls) {
    beam_free(&controls->file);
}

void beam_controls_show(BeamControls *controls, const Beam *beam) {
    for (size_t i = 0; i < controls->count; i++) {
        PanelParameter *parameter = &controls->parameters[i];
        parameter->value = parameters_number_get(parameter->row, beam);
        parameter->provenance = beam->provenance[parameter->row - beam_table()->rows];
    }
}

const PanelParameter *beam_controls_find(const BeamControls *controls, const char *name) {
    for (size_t i = 0; i < controls->count; i++)
        if (strcmp(controls->parameters[i].name, name) == 0)
            return &controls->parameters[i];
    return NULL;
}

bool beam_controls_set(const BeamControls *controls, Beam *beam, const char *name, double value, Fault *fault) {
    const PanelParameter *parameter = beam_controls_find(controls, name);
    if (!parameter) {
        fault_add(fault, "a beam has no parameter \"%.60s\"", name);
        return false;
    }
    if (!beam_numbers_set(parameter->row, beam, value, fault))
        return false;
    size_t at = (size_t)(parameter->row - beam_table()->rows);
    beam->provenance[at] = value == parameter->initial ? controls->file.provenance[at] : set_here;
    return true;
}

void beam_controls_words(const PanelParameter *parameter, double value, char *text, size_t size) {
    double factor = parameter->factor, most = fmax(fabs(factor * parameter->high), fabs(factor * value));
    int digits = most > 0 ? (int)fmax(1, 2 - floor(log10(most))) : 1;
    if (parameter->row->kind != PARAMETER_NUMBER)
        digits = 0;
    const char *unit = parameter->unit ? parameter->unit : parameter->row->unit;
    bool bare = !*unit || strcmp(unit, "1") == 0;
    snprintf(text, size, "%.*f%s%s", digits, factor * value, bare ? "" : " ", bare ? "" : unit);
}

void beam_controls_sweep(const PanelParameter *parameter, double *from, double *to) {
    const Looks *looks = looks_of(parameter->name);
    bool about = looks->to > 0 && parameter->initial > 0;
    *from = fmax(about ? looks->from * parameter->initial : parameter->low, parameter->row->low);
    *to = fmin(about ? looks->to * parameter->initial : parameter->high, parameter->row->high);
    double spare = (*to - *from) / 10;
    if (parameter->value < *from)
        *from = fmax(parameter->value - spare, parameter->row->low);
    if (parameter->value > *to)
        *to = fmin(parameter->value + spare, parameter->row->high);
}
