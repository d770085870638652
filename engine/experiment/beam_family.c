#include "experiment/beam_family.h"

#include <math.h>

#include "base/parameters_number.h"
#include "beam/beam_cycle.h"
#include "experiment/beam_numbers.h"

static void forget_own(BeamFamily *family) {
    if (family->shares)
        rig_clear_shared(&family->own);
    else if (family->built)
        rig_clear(&family->own);
    family->shares = family->built = false;
}

static Cycle at_value(void *context, double value) {
    BeamFamily *family = context;
    Beam beam = family->beam;
    Fault fault = {0};
    forget_own(family);
    bool good = parameters_set_number(family->row, &beam, value, &fault);
    if (good && beam_numbers_same_rig(&beam, &family->beam)) {
        family->own = rig_share(&family->rig, beam.frequency, beam.force, beam.clearance);
        family->shares = true;
    } else if (good) {
        family->built = beam_check(&beam, beam.name, &fault) &&
                        rig_build_like(&family->own, &beam, &family->rig, family->beam.name, &fault);
        good = family->built && family->own.modes.count == family->rig.modes.count;
    }
    fault_clear(&fault);
    return good ? beam_cycle_of(&family->own) : (Cycle){0};
}

/* Adds an error unless the beam can have the value. */
static bool check_end(const BeamFamily *family, double value, const char *place, Fault *fault) {
    Beam beam = family->beam;
    return parameters_set_number(family->row, &beam, value, fault) && beam_check(&beam, place, fault);
}

bool beam_family_open(BeamFamily *family, const Beam *beam, const char *name, double from, double to, const char *place,
                      Fault *fault) {
    *family = (BeamFamily){.beam = *beam, .row = parameters_find(beam_table(), name)};
    family->follow = (FollowFamily){at_value, family, from, to, .rough = true};
    if (!family->row || family->row->kind != PARAMETER_NUMBER) {
        fault_add(fault, "%s: %s is not a number that changes continuously; drive.frequency is one", place, name);
        return false;
    }
    Beam other = *beam;
    if (!check_end(family, from, place, fault) || !check_end(family, to, place, fault) ||
        !rig_build(&family->rig, beam, place, fault))
        return false;
    parameters_set_number(family->row, &other, from, fault);
    family->follow.rough = !beam_numbers_same_rig(&other, beam);
    return true;
}

bool beam_family_set(BeamFamily *family, const Parameter *row, double value) {
    Beam beam = family->beam;
    Fault fault = {0};
    Rig rig = {0};
    forget_own(family);
    bool good = parameters_set_number(row, &beam, value, &fault) && beam_check(&beam, beam.name, &fault);
    bool same = good && beam_numbers_same_rig(&beam, &family->beam);
    if (good && !same)
        good = rig_build_like(&rig, &beam, &family->rig, family->beam.name, &fault);
    if (good && !same) {
        rig_clear(&family->rig);
        family->rig = rig;
    }
    if (good)
        family->beam = beam;
    fault_clear(&fault);
    return good;
}

void beam_family_close(BeamFamily *family) {
    forget_own(family);
    rig_clear(&family->rig);
}

double beam_family_value(const BeamFamily *family) {
    return parameters_number_get(family->row, &family->beam);
}
