/* Tests the record of a running beam: it equals the motion computed without a window, and its memory is limited. */

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "base/stop.h"
#include "beam/beam_cycle.h"
#include "beam/lanes.h"
#include "check.h"
#include "laboratory/beam/tape.h"
#include "oscillator.h"
#include "running_beam.h"

TEST(the_record_is_the_motion_from_rest_to_the_bit) {
    enum { CYCLES = 60 };
    Beam beam = oscillator_beam("ibs", NULL);
    Rig rig = oscillator_beam_rig("ibs", NULL);
    Fault fault = {0};
    BeamTape tape;
    CHECK(beam_tape_open(&tape, &beam, "ibs", &fault));
    size_t transient = (size_t)beam.transient_cycles;
    for (size_t i = 0; i < transient + CYCLES; i++)
        CHECK(beam_tape_advance(&tape));
    double deflection[CYCLES], velocity[CYCLES], peak[2 * CYCLES];
    LanesRun lane = {.frequency = beam.frequency,
                     .force = beam.force,
                     .clearance = beam.clearance,
                     .transient_cycles = beam.transient_cycles,
                     .cycles = CYCLES,
                     .peak = peak,
                     .deflection = deflection,
                     .velocity = velocity};
    lanes_run(&rig, &lane, 1, NULL);
    for (size_t i = 0; i < CYCLES; i++) {
        CHECK_NEAR(beam_tape_cycle(&tape, transient + i + 1)->deflection, deflection[i], 0);
        CHECK_NEAR(beam_tape_cycle(&tape, transient + i + 1)->velocity, velocity[i], 0);
        CHECK_NEAR(beam_tape_cycle(&tape, transient + i)->peak[0], peak[2 * i], 0);
        CHECK_NEAR(beam_tape_cycle(&tape, transient + i)->peak[1], peak[2 * i + 1], 0);
    }
    beam_tape_close(&tape);
    rig_clear(&rig);
    beam_free(&beam);
}

TEST(the_record_goes_through_the_state_in_which_the_response_is_recorded) {
    Beam beam = oscillator_beam("ibs-r", "run.cycles=1");
    Rig rig = oscillator_beam_rig("ibs-r", NULL);
    Fault fault = {0};
    BeamTape tape;
    Response response;
    Stop stop = {0};
    beam.cycles = 1;
    beam_cycle_respond(&response, &rig, &beam, NULL, &stop);
    CHECK(beam_tape_open(&tape, &beam, "ibs-r", &fault));
    for (int i = 0; i < beam.transient_cycles; i++)
        beam_tape_advance(&tape);
    double *state = memory_zeroed(rig.free.states, sizeof *state);
    motion_state(&tape.motion, state);
    for (size_t i = 0; i < rig.free.states; i++)
        CHECK_NEAR(state[i], response.start[i], 0);
    memory_free(state);
    response_clear(&response);
    beam_tape_close(&tape);
    rig_clear(&rig);
    beam_free(&beam);
}

/* A repeated cycle ends where the next one begins. */
TEST(a_cycle_that_is_seen_again_is_the_same) {
    Beam beam = oscillator_beam("ibs", NULL);
    Fault fault = {0};
    BeamTape tape;
    BeamSight sight = {0};
    CHECK(beam_tape_open(&tape, &beam, "ibs", &fault));
    for (int i = 0; i < 30; i++)
        beam_tape_advance(&tape);
    for (size_t cycle = 29; cycle > 3; cycle -= 13) {
        double end = beam_tape_begin(&tape, cycle) + tape.parts[0]->rig.period;
        beam_tape_seek(&tape, &sight, nextafter(end, 0));
        CHECK(sight.cycle == cycle);
        CHECK_NEAR(motion_deflection(&sight.motion), beam_tape_cycle(&tape, cycle + 1)->deflection, 1e-15);
        CHECK_NEAR(motion_velocity(&sight.motion), beam_tape_cycle(&tape, cycle + 1)->velocity, 1e-9);
    }
    beam_tape_close_sight(&sight);
    beam_tape_close(&tape);
    beam_free(&beam);
}

static double memory_used(void) {
    double pages = 0, size;
    FILE *file = fopen("/proc/self/statm", "r");
    if (file && fscanf(file, "%lf %lf", &size, &pages) != 2)
        pages = 0;
    if (file)
        fclose(file);
    return pages * (double)sysconf(_SC_PAGESIZE);
}

TEST(memory_is_flat_however_long_it_runs) {
    enum { ALL = 60000 };
    Beam beam = oscillator_beam("ibs", "beam.modes=2");
    Fault fault = {0};
    BeamTape tape;
    CHECK(beam_tape_open(&tape, &beam, "ibs", &fault));
    double before = 0;
    while (tape.front < ALL) {
        CHECK(beam_tape_advance(&tape));
        if (tape.front == ALL / 2)
            before = memory_used();
    }
    CHECK(tape.front - tape.first == BEAM_TAPE_CYCLES);
    CHECK(RUNNING_BEAM_SANITIZED || memory_used() - before < 1e6);
    double phase;
    CHECK(beam_tape_cycle_at(&tape, 0, &phase) == tape.first);
    CHECK(beam_tape_cycle_at(&tape, HUGE_VAL, &phase) == tape.front - 1);
    beam_tape_close(&tape);
    beam_free(&beam);
}

TEST(only_the_last_changes_are_kept) {
    Beam beam = oscillator_beam("ibs", NULL);
    Fault fault = {0};
    BeamTape tape;
    CHECK(beam_tape_open(&tape, &beam, "ibs", &fault));
    for (size_t i = 0; i < 3 * BEAM_TAPE_PARTS; i++) {
        beam_tape_advance(&tape);
        beam_tape_advance(&tape);
        beam.frequency = 200 + (double)i / 10;
        CHECK(beam_tape_change(&tape, &beam, tape.front, &fault));
        beam.frequency += 0.05; /* within the same cycle: the earlier change is merged */
        CHECK(beam_tape_change(&tape, &beam, tape.front, &fault));
    }
    CHECK(tape.part_count == BEAM_TAPE_PARTS);
    CHECK(tape.first == tape.parts[0]->first);
    for (size_t p = 1; p < tape.part_count; p++) {
        CHECK(tape.parts[p]->first == tape.parts[p - 1]->first + 2);
        CHECK_NEAR(tape.parts[p]->begin, tape.parts[p - 1]->begin + 2 * tape.parts[p - 1]->rig.period, 1e-12);
    }
    beam_tape_close(&tape);
    beam_free(&beam);
}

/* The tip continues at its place with its velocity. */
TEST(the_motion_is_carried_on_through_a_change) {
    Beam beam = oscillator_beam("ibs", NULL);
    Fault fault = {0};
    BeamTape tape;
    CHECK(beam_tape_open(&tape, &beam, "ibs", &fault));
    for (int i = 0; i < 40; i++)
        beam_tape_advance(&tape);
    double deflection = motion_deflection(&tape.motion), velocity = motion_velocity(&tape.motion);
    beam.length *= 1.01;
    CHECK(beam_tape_change(&tape, &beam, tape.front, &fault));
    beam_tape_advance(&tape);
    CHECK_NEAR(beam_tape_cycle(&tape, 40)->deflection, deflection, 1e-12);
    CHECK_NEAR(beam_tape_cycle(&tape, 40)->velocity, velocity, 1e-9);
    CHECK(tape.part_count == 2);
    beam_tape_close(&tape);
    beam_free(&beam);
}
