#include "oscillator.h"

#include <stdio.h>

#include "base/memory.h"
#include "base/random.h"
#include "check.h"
#include "scratch.h"

static double *one_number(double number) {
    double *room = memory_zeroed(1, sizeof *room);
    *room = number;
    return room;
}

Rig oscillator_rig(const Oscillator *oscillator) {
    Modes modes = {.count = 1,
                   .freedoms = 1,
                   .frequency = one_number(oscillator->omega),
                   .shape = one_number(1),
                   .damping = one_number(2 * oscillator->damping_ratio * oscillator->omega),
                   .tip = one_number(1),
                   .shaker = one_number(1)};
    Beam beam = {.frequency = 0.01,
                 .clearance = oscillator->clearance,
                 .contact = {.normal_stiffness = oscillator->stiffness, .normal_damping = oscillator->damping},
                 .release = oscillator->release};
    Rig rig;
    CHECK(rig_of_modes(&rig, &modes, &beam));
    return rig;
}

Beam oscillator_beam(const char *name, const char *setting) {
    char path[100];
    Beam beam = {0};
    Fault fault = {0};
    snprintf(path, sizeof path, "assets/beams/%s.json", name);
    CHECK(beam_read(&beam, scratch_source(path), &setting, setting ? 1 : 0, &fault));
    check_say(&fault);
    return beam;
}

Rig oscillator_beam_rig(const char *name, const char *setting) {
    Beam beam = oscillator_beam(name, setting);
    Fault fault = {0};
    Rig rig;
    CHECK(rig_build(&rig, &beam, name, &fault));
    fault_clear(&fault);
    beam_free(&beam);
    return rig;
}

void oscillator_start(const Rig *rig, unsigned which, double *state) {
    Random random = random_seed(which, 0);
    size_t n = rig->modes.count;
    for (size_t i = 0; i < 2 * n; i++)
        state[i] = which ? random_normal(&random, 0, 0.05 / (double)(1 + i % n)) : 0;
}
