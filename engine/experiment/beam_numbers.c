#include "experiment/beam_numbers.h"

#include <math.h>

#include "base/parameters_number.h"

bool beam_numbers_set(const Parameter *row, Beam *beam, double value, Fault *fault) {
    if (!isfinite(value)) {
        fault_add(fault, "%s must be a number", row->name);
        return false;
    }
    char place[] = "";
    Arena none = {0}; /* numbers need no memory */
    JsonFile file = {.path = place, .root = parameters_number_json(row, value)};
    JsonNode node = json_root(&file);
    bool good = parameters_read_value(row, beam, &node, &none, fault);
    json_decref(file.root);
    return good;
}

bool beam_numbers_same_rig(const Beam *a, const Beam *b) {
    Beam like = *b;
    like.frequency = a->frequency;
    like.force = a->force;
    like.clearance = a->clearance;
    const ParameterTable *table = beam_table();
    for (size_t i = 0; i < table->count; i++)
        if (parameters_number_get(&table->rows[i], a) != parameters_number_get(&table->rows[i], &like))
            return false;
    return true;
}

bool beam_numbers_followed(const Beam *beam, const Rig *rig) {
    return 1 / (beam->frequency * rig->cell) <= RIG_CELLS_MOST;
}

bool beam_numbers_same(const Beam *a, const Beam *b) {
    return a->frequency == b->frequency && a->force == b->force && a->clearance == b->clearance &&
           beam_numbers_same_rig(a, b);
}
