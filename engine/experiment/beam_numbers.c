#include "experiment/beam_numbers.h"

#include "base/parameters_number.h"

bool beam_numbers_same_rig(const Beam *a, const Beam *b) {
    Beam like = *b;
    like.frequency = a->frequency;
    like.force = a->force;
    like.clearance = a->clearance;
    return parameters_number_same(beam_table(), a, &like);
}

bool beam_numbers_followed(const Beam *beam, const Rig *rig) {
    return 1 / (beam->frequency * rig->cell) <= RIG_CELLS_MOST;
}
