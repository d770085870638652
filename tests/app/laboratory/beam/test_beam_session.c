/* Tests the running beam: its record equals the motion computed without a window, regardless of the order in which
 * it is shown. */

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/stopwatch.h"
#include "base/digest.h"
#include "beam/lanes.h"
#include "beam/response.h"
#include "check.h"
#include "scratch.h"
#include "laboratory/beam/sweep.h"
#include "laboratory/beam/tape.h"
#include "laboratory/laboratory.h"
#include "oscillator.h"
#include "study/study.h"

#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__
#define SANITIZED true
#else
#define SANITIZED false
#endif

static void *open_beam(const char *name, const char *const *settings, size_t count) {
    char path[100];
    Fault fault = {0};
    LaboratoryOptions options = {.settings = settings, .setting_count = count, .driving = -1, .jobs = 2};
    snprintf(path, sizeof path, "assets/beams/%s.json", name);
    void *live = beam_laboratory.open(scratch_source(path), &options, &fault);
    CHECK(live != NULL);
    check_say(&fault);
    return live;
}

/* True once the session has shown times up to the given one, s, as far as reachable. */
static void show_at(void *live, double time) {
    while (beam_laboratory.reach(live, time) <= time && !beam_laboratory.span(live).complete) {
    }
    beam_laboratory.show(live, fmin(time, beam_laboratory.span(live).end));
}

static void play(void *live, double from, double to, double step) {
    for (size_t i = 0; from + (double)i * step < to; i++) {
        beam_laboratory.update(live, from + (double)i * step);
        show_at(live, from + (double)i * step);
    }
    show_at(live, to);
}

static uint64_t digest_scene(uint64_t digest, const Scene *scene) {
    for (size_t p = 0; p < scene->count; p++) {
        const Primitive *primitive = &scene->primitives[p];
        for (size_t i = 0; i < primitive->count; i++)
            digest = digest_pair(digest, primitive->points[i]);
        if (primitive->text)
            digest = digest_text(digest, primitive->text);
    }
    return digest;
}

static uint64_t digest_picture(void *live) {
    return digest_scene(digest_scene(DIGEST_START, beam_laboratory.still(live)), beam_laboratory.moving(live));
}

static size_t find_plot(const char *name) {
    static const char *const names[] = {"phase", "poincare", "force", "spectrum", "orbit"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(names[i], name) == 0)
            return i;
    return 0;
}

static uint64_t digest_plot(void *live, const char *name, double time) {
    size_t index = find_plot(name);
    LaboratoryPlot plot = beam_laboratory.plot(live, index);
    uint64_t digest = DIGEST_START;
    CHECK_TEXT(plot.name, name);
    for (size_t s = 0; s < plot.plot->series_count; s++) {
        size_t count = beam_laboratory.points_until(live, index, s, time);
        CHECK(count <= plot.plot->series[s].count);
        for (size_t i = 0; i < count; i++)
            digest = digest_pair(digest, plot_value(&plot.plot->series[s], i));
    }
    return digest;
}

/* Record ----------------------------------------------------------------------------------------------------------- */

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
    volatile sig_atomic_t stop = 0;
    beam.cycles = 1;
    response_run(&response, &rig, &beam, NULL, &stop);
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
    CHECK(SANITIZED || memory_used() - before < 1e6);
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

/* Pictures --------------------------------------------------------------------------------------------------------- */

TEST(a_time_looks_the_same_whenever_it_is_shown) {
    enum { TIMES = 12 };
    static const size_t order[TIMES] = {7, 0, 11, 3, 3, 9, 1, 10, 2, 8, 4, 6};
    void *live = open_beam("ibs", NULL, 0), *other = open_beam("ibs", NULL, 0);
    uint64_t pictures[TIMES], phases[TIMES];
    double period = 1 / 300., end = 50 * period;
    for (size_t i = 0; i < TIMES; i++) {
        double time = end * ((double)i + 0.37) / TIMES;
        play(live, i ? end * ((double)i - 0.63) / TIMES : 0, time, period / 9);
        pictures[i] = digest_picture(live);
        phases[i] = digest_plot(live, "phase", time);
    }
    beam_laboratory.reach(other, end);
    for (size_t i = 0; i < TIMES; i++) {
        double time = end * ((double)order[i] + 0.37) / TIMES;
        for (int again = 0; again < 2; again++) {
            void *shown = again ? other : live;
            show_at(shown, time + 1e-4);
            show_at(shown, time); /* backwards: pages of single cycles */
            CHECK(digest_picture(shown) == pictures[order[i]]);
            CHECK(digest_plot(shown, "phase", time) == phases[order[i]]);
        }
    }
    beam_laboratory.close(live);
    beam_laboratory.close(other);
}

TEST(the_magnification_changes_seldom) {
    void *live = open_beam("ibs", NULL, 0);
    double period = 1 / 300.;
    int changes = 0;
    play(live, 0, 20 * period, period / 4);
    for (double time = 20 * period; time < 200 * period; time += period / 4) {
        show_at(live, time);
        changes += (beam_laboratory.update(live, time) & LABORATORY_VIEW) != 0;
    }
    CHECK(changes <= 3);
    beam_laboratory.close(live);
}

TEST(plots_at_speed_hold_more_cycles) {
    void *live = open_beam("ibs", NULL, 0);
    double period = 1 / 300., time = 0;
    size_t force = find_plot("force");
    for (int i = 0; i < 300; i++, time += 11.4 * period)
        show_at(live, time);
    LaboratoryPlot plot = beam_laboratory.plot(live, force);
    CHECK(plot.plot->x.high > 1000 * 1000 * period);
    CHECK(beam_laboratory.points_until(live, force, 0, time) > 0);
    unsigned before = plot.revision;
    for (int i = 0; i < 20; i++, time += 11.4 * period)
        show_at(live, time);
    CHECK(beam_laboratory.plot(live, force).revision - before <= 1);
    beam_laboratory.close(live);
}

/* Jumps over more than the record holds, between beams with different modes, at the very beginning of the record. */
TEST(what_is_forgotten_is_not_looked_for) {
    const char *const settings[] = {"beam.modes=1"};
    void *live = open_beam("ibs", settings, 1);
    Fault fault = {0};
    double time = 0;
    for (int jump = 0; jump < 6; jump++) {
        time += (jump % 2 ? 30000 : 11000) / 300.;
        show_at(live, time);
        beam_laboratory.update(live, time);
        RecordSpan span = beam_laboratory.span(live);
        for (int i = 0; i < 8; i++)
            show_at(live, span.begin + (span.end - span.begin) * i / 7);
        show_at(live, span.begin);
        CHECK(beam_laboratory.set(live, "beam.modes", 1 + jump % 3, &fault));
        time = beam_laboratory.span(live).end;
    }
    beam_laboratory.close(live);
}

TEST(layers_and_camera_make_another_picture) {
    void *live = open_beam("ibs", NULL, 0);
    show_at(live, 0.01);
    beam_laboratory.update(live, 0.01);
    uint64_t whole = digest_picture(live);
    size_t count = beam_laboratory.still(live)->count;
    beam_laboratory.set_layers(live, 0);
    CHECK(beam_laboratory.update(live, 0.01) & LABORATORY_VIEW);
    CHECK(beam_laboratory.still(live)->count < count);
    beam_laboratory.set_layers(live, 7);
    CHECK(digest_picture(live) == whole);
    beam_laboratory.set_camera(live, (Camera){.zoom = 3});
    CHECK_NEAR(beam_laboratory.still(live)->camera.zoom, 3, 0);
    beam_laboratory.close(live);
}

/* Changes ---------------------------------------------------------------------------------------------------------- */

TEST(a_change_while_it_runs_leads_into_chaos_and_the_record_before_stays) {
    const char *const settings[] = {"drive.frequency=190"};
    void *live = open_beam("ibs", settings, 1);
    Fault fault = {0};
    double change = 150 / 190.;
    play(live, 0, change, 1 / 190.);
    beam_laboratory.update(live, change);
    CHECK_TEXT(beam_laboratory.answer(live).title, "Periodic, period 1");
    show_at(live, change / 2);
    uint64_t before = digest_picture(live);
    show_at(live, change);
    CHECK(beam_laboratory.set(live, "drive.frequency", 300, &fault));
    play(live, change, change + 1, 1 / 100.);
    beam_laboratory.update(live, change + 1);
    CHECK_TEXT(beam_laboratory.answer(live).title, "Not periodic so far");
    size_t count;
    const TimelineMark *ticks = beam_laboratory.marks(live, &count);
    CHECK(count == 1 && ticks[0].kind == TIMELINE_CHANGE);
    CHECK(ticks[0].time > change && ticks[0].time <= change + 1 / 190. + 1e-12);
    show_at(live, change / 2);
    CHECK(digest_picture(live) == before);
    beam_laboratory.close(live);
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

TEST(a_change_of_what_was_goes_on_from_there) {
    void *live = open_beam("ibs", NULL, 0);
    Fault fault = {0};
    show_at(live, 0.2);
    show_at(live, 0.1);
    CHECK(beam_laboratory.set(live, "joint.clearance", 0.2e-3, &fault));
    CHECK(beam_laboratory.span(live).end < 0.1 + 1 / 300. + 1e-9);
    show_at(live, 0.2);
    CHECK(beam_laboratory.span(live).end >= 0.2);
    beam_laboratory.close(live);
}

TEST(a_bad_value_is_a_fault_and_changes_nothing) {
    static const struct {
        const char *name;
        double value;
    } bad[] = {{"drive.frequency", 1e9}, {"drive.frequency", NAN}, {"drive.frequency", -1}, {"beam.modes", 2.5},
               {"beam.modes", 60},       {"joint.release", 2},     {"pivot.position", 5},   {"shaker.position", 1e-5},
               {"no.such", 1},           {"drive.force", HUGE_VAL}};
    void *live = open_beam("ibs", NULL, 0);
    show_at(live, 0.05);
    uint64_t before = digest_picture(live);
    size_t count, words;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        Fault fault = {0};
        CHECK(!beam_laboratory.set(live, bad[i].name, bad[i].value, &fault));
        CHECK(fault.count >= 1);
        fault_clear(&fault);
    }
    const PanelParameter *parameters = beam_laboratory.parameters(live, &count);
    for (size_t i = 0; i < count; i++)
        CHECK_NEAR(parameters[i].value, parameters[i].initial, 0);
    beam_laboratory.command(live, &words);
    CHECK(words == 2);
    show_at(live, 0.07);
    show_at(live, 0.05);
    CHECK(digest_picture(live) == before);
    beam_laboratory.marks(live, &count);
    CHECK(count == 0);
    beam_laboratory.close(live);
}

TEST(every_number_can_be_set_to_the_ends_of_its_slider) {
    void *live = open_beam("ibs", NULL, 0);
    size_t count;
    const PanelParameter *parameters = beam_laboratory.parameters(live, &count);
    for (size_t i = 0; i < count; i++) {
        CHECK(parameters[i].low < parameters[i].high);
        CHECK(parameters[i].low >= parameters[i].row->low || parameters[i].row->kind == PARAMETER_CHOICE);
        CHECK(parameters[i].initial >= parameters[i].low && parameters[i].initial <= parameters[i].high);
        const double values[] = {parameters[i].low, parameters[i].high, parameters[i].initial};
        for (int v = 0; v < 3; v++) {
            Fault fault = {0};
            if (!beam_laboratory.set(live, parameters[i].name, values[v], &fault))
                printf("%s = %g: %s\n", parameters[i].name, values[v], fault.lines[0]);
            fault_clear(&fault);
        }
    }
    beam_laboratory.close(live);
}

TEST(what_cannot_be_followed_ends_the_record_until_it_is_changed) {
    void *live = open_beam("ibs", NULL, 0);
    Fault fault = {0};
    show_at(live, 0.1);
    uint64_t before = digest_picture(live);
    CHECK(beam_laboratory.set(live, "drive.frequency", 1, &fault)); /* rattling through a slow cycle */
    CHECK(beam_laboratory.set(live, "joint.clearance", 1e-6, &fault));
    CHECK(beam_laboratory.set(live, "joint.damping", 0, &fault));
    CHECK(beam_laboratory.set(live, "beam.damping_ratio", 0, &fault));
    show_at(live, 10);
    RecordSpan span = beam_laboratory.span(live);
    double time;
    size_t count;
    CHECK(span.complete && !span.endless);
    CHECK(beam_laboratory.update(live, span.end) & LABORATORY_ERROR);
    const char *trouble = beam_laboratory.error(live, &time);
    CHECK(trouble && strstr(trouble, "switches more than"));
    CHECK_NEAR(time, span.end, 0);
    CHECK_TEXT(beam_laboratory.answer(live).title, "Chatter");
    CHECK(beam_laboratory.marks(live, &count)[0].kind == TIMELINE_ERROR || count > 0);
    show_at(live, 0.1);
    CHECK(digest_picture(live) == before);
    show_at(live, span.end);
    beam_laboratory.reset(live);
    CHECK(!beam_laboratory.error(live, &time));
    show_at(live, span.end + 0.1);
    CHECK(beam_laboratory.span(live).end > span.end + 0.1);
    beam_laboratory.close(live);
}

TEST(run_again_begins_from_rest) {
    void *live = open_beam("ibs", NULL, 0);
    Fault fault = {0};
    show_at(live, 0.03);
    uint64_t before = digest_picture(live);
    show_at(live, 0.5);
    beam_laboratory.restart(live);
    CHECK(beam_laboratory.span(live).end < 0.01);
    show_at(live, 0.03);
    CHECK(digest_picture(live) == before);
    CHECK(beam_laboratory.set(live, "drive.force", 100, &fault));
    show_at(live, 0.2);
    CHECK(beam_laboratory.set(live, "drive.force", 225, &fault));
    beam_laboratory.restart(live);
    show_at(live, 0.03);
    CHECK(digest_picture(live) == before);
    beam_laboratory.close(live);
}

TEST(the_command_makes_what_is_shown) {
    const char *const settings[] = {"drive.frequency=245"};
    void *live = open_beam("ibs", settings, 1);
    Fault fault = {0};
    size_t count;
    CHECK(beam_laboratory.set(live, "joint.clearance", 0.1e-3, &fault));
    CHECK(beam_laboratory.set(live, "joint.release", 1, &fault));
    const char *const *words = beam_laboratory.command(live, &count);
    CHECK(count == 8);
    CHECK_TEXT(words[0], "run");
    CHECK_TEXT(words[3], "drive.frequency=245");
    CHECK_TEXT(words[5], "joint.clearance=0.0001");
    CHECK_TEXT(words[7], "joint.release=gap");
    beam_laboratory.apply_preset(live, 1);
    words = beam_laboratory.command(live, &count);
    CHECK(count == 4);
    CHECK_TEXT(words[3], "drive.frequency=190");
    beam_laboratory.close(live);
}

/* Traces ----------------------------------------------------------------------------------------------------------- */

TEST(what_is_kept_stays_and_what_is_cleared_is_gone) {
    void *live = open_beam("ibs", NULL, 0);
    size_t phase = find_plot("phase"), points = find_plot("poincare");
    play(live, 0, 0.05, 1e-3);
    size_t drawn = beam_laboratory.points_until(live, phase, 1, 0.05);
    CHECK(beam_laboratory.points_until(live, phase, 0, 0.05) == 0);
    CHECK(beam_laboratory.points_until(live, points, 0, 0.05) == 16);
    beam_laboratory.save_run(live, 0.05);
    CHECK(beam_laboratory.points_until(live, phase, 0, 0) == drawn);
    CHECK(beam_laboratory.plot(live, phase).plot->series[0].role == ROLE_GHOST);
    beam_laboratory.clear_runs(live, 0.05);
    CHECK(beam_laboratory.points_until(live, phase, 0, 0.05) == 0);
    CHECK(beam_laboratory.points_until(live, phase, 1, 0.05) < drawn);
    CHECK(beam_laboratory.points_until(live, points, 0, 0.05) == 1);
    show_at(live, 0.07);
    CHECK(beam_laboratory.points_until(live, points, 0, 0.07) == 7);
    beam_laboratory.close(live);
}

TEST(the_sound_is_the_velocity_of_the_tip) {
    enum { COUNT = 200 };
    void *live = open_beam("ibs", NULL, 0);
    float samples[COUNT], again[COUNT];
    show_at(live, 0.5);
    CHECK(beam_laboratory.sound(live, 0.1, 0.12, samples, COUNT));
    float least = 0, most = 0;
    for (int i = 0; i < COUNT; i++) {
        least = fminf(least, samples[i]);
        most = fmaxf(most, samples[i]);
    }
    CHECK(least >= -1 && most <= 1 && most - least > 0.5f);
    CHECK(beam_laboratory.sound(live, 0.1, 0.12, again, COUNT));
    CHECK(memcmp(samples, again, sizeof samples) == 0);
    CHECK(!beam_laboratory.sound(live, 0.49, 1, samples, COUNT));
    beam_laboratory.close(live);
}

/* In the background ------------------------------------------------------------------------------------------------ */

/* Returns the points of a pass at one value. */
static size_t count_points(const BeamSweepPoints *points, double value, const Trial *trial, size_t *alike) {
    size_t count = 0;
    for (size_t i = 0; i < points->count; i++) {
        if (points->value[i] != value)
            continue;
        count++;
        for (size_t p = 0; p < trial->series_count; p++)
            if (trial->series[p] == points->peak[i]) {
                ++*alike;
                break;
            }
    }
    return count;
}

static void check_sweep(BeamSweepTask task, size_t values, size_t steps, const StudyPass *passes, size_t pass_count) {
    Experiment experiment;
    Fault fault = {0};
    BeamSweep sweep;
    BeamSweepPoints points[BEAM_SWEEP_PASSES] = {{0}};
    CHECK(beam_experiment_of(&experiment, &task.beam, "ibs", &fault));
    Study study = {.experiment = &experiment,
                   .axes = {{task.name, task.from, task.to, steps}},
                   .axis_count = 1,
                   .pass_count = pass_count,
                   .runs = 1};
    memcpy(study.passes, passes, pass_count * sizeof *passes);
    study_begin(&study);
    for (size_t t = 0; t < study.trial_count && !task.carried; t++)
        study.trials[t].done = t % BEAM_SWEEP_COARSE != 0;
    study_run(&study, &(StudyOptions){.jobs = 2});
    CHECK(beam_sweep_open(&sweep, &task, &fault));
    while (sweep.done < values)
        CHECK(beam_sweep_go_on(&sweep, 2, NULL, points));
    size_t alike = 0, seen = 0;
    for (size_t pass = 0; pass < pass_count; pass++)
        for (size_t i = 0; i < steps; i++) {
            const Trial *trial = study_trial(&study, pass, 0, 0, i);
            double value = study_value(&study.axes[0], i);
            if (trial->series_count)
                seen += count_points(&points[task.carried ? pass + BEAM_SWEEP_UP : 0], value, trial, &alike);
        }
    CHECK(seen > values && alike == seen);
    for (int pass = 0; pass < BEAM_SWEEP_PASSES; pass++)
        beam_sweep_points_clear(&points[pass]);
    beam_sweep_close(&sweep);
    study_clear(&study);
    beam_experiment_close(&experiment);
}

TEST(the_orbit_diagram_is_a_study) {
    Beam beam = oscillator_beam("ibs", "beam.modes=4");
    beam.transient_cycles = 60;
    beam.cycles = 20;
    const StudyPass reset = STUDY_RESET, both[] = {STUDY_UP, STUDY_DOWN};
    check_sweep((BeamSweepTask){beam, "drive.frequency", 150, 320, false}, 32, BEAM_SWEEP_STEPS, &reset, 1);
    beam.transient_cycles = 10;
    beam.cycles = 4;
    check_sweep((BeamSweepTask){beam, "drive.frequency", 250, 320, true}, 2 * BEAM_SWEEP_CARRIED_STEPS,
                BEAM_SWEEP_CARRIED_STEPS, both, 2);
    beam_free(&beam);
}

TEST(an_orbit_diagram_has_each_value_once) {
    BeamSweepTask task = {.name = "drive.frequency", .from = 0, .to = BEAM_SWEEP_STEPS - 1};
    bool seen[BEAM_SWEEP_STEPS] = {false};
    BeamSweepPass pass;
    for (size_t i = 0; i < beam_sweep_values(&task); i++) {
        size_t value = (size_t)lround(beam_sweep_value(&task, i, &pass));
        CHECK(i >= 31 || value % BEAM_SWEEP_COARSE == 0);
        CHECK(!seen[value]);
        seen[value] = true;
    }
}

#define QUICK "run.transient_cycles=60", "run.cycles=20", "beam.modes=3"

static bool wait_for(void *live, bool (*what)(void *live), double seconds) {
    for (double until = stopwatch_now() + seconds; stopwatch_now() < until; usleep(5000)) {
        beam_laboratory.update(live, 0);
        if (what(live))
            return true;
    }
    return false;
}

static bool is_told(void *live) {
    return !beam_laboratory.answer(live).stale;
}

static bool is_typed(void *live) {
    return is_told(live) && strstr(beam_laboratory.answer(live).detail, "type ");
}

static bool is_swept(void *live) {
    LaboratoryPlot plot = beam_laboratory.plot(live, find_plot("orbit"));
    return plot.plot->series[1].count > BEAM_SWEEP_STEPS / 2;
}

static bool is_idle(void *live) {
    return is_typed(live) && !beam_laboratory.answer(live).doing;
}

TEST(verdict_type_and_orbit_diagram_come_by_themselves) {
    const char *const settings[] = {QUICK};
    void *live = open_beam("ibs", settings, 3);
    show_at(live, 0.1);
    CHECK(!is_told(live));
    CHECK(wait_for(live, is_told, 60));
    CHECK(wait_for(live, is_swept, 100));
    CHECK(wait_for(live, is_typed, 200));
    CHECK(wait_for(live, is_idle, 20));
    size_t count;
    const PanelRow *rows = beam_laboratory.rows(live, &count);
    CHECK(count > 6 && rows[0].row.kind == ROW_HEADING);
    LaboratoryPlot orbit = beam_laboratory.plot(live, find_plot("orbit"));
    CHECK_NEAR(orbit.cursor, 300, 1e-9);
    CHECK_TEXT(orbit.cursor_text, "300.0 Hz");
    CHECK_TEXT(orbit.cursor_parameter, "drive.frequency");
    CHECK(orbit.plot->x.low < orbit.cursor && orbit.cursor < orbit.plot->x.high);
    Fault fault = {0};
    CHECK(beam_laboratory.set(live, "drive.frequency", 290, &fault)); /* the cursor moves, the diagram stays */
    beam_laboratory.update(live, 0);
    CHECK(!is_told(live));
    CHECK(is_swept(live) && beam_laboratory.plot(live, find_plot("orbit")).revision == orbit.revision);
    CHECK_NEAR(beam_laboratory.plot(live, find_plot("orbit")).cursor, 290, 1e-9);
    CHECK(wait_for(live, is_told, 60));
    beam_laboratory.close(live);
}

TEST(the_newest_question_wins_and_closing_does_not_wait) {
    void *live = open_beam("ibs", NULL, 0);
    Fault fault = {0};
    for (int i = 0; i < 40; i++) {
        CHECK(beam_laboratory.set(live, "joint.damping", 100 + i, &fault));
        beam_laboratory.choose(live, 1, (size_t)i % 6);
        beam_laboratory.choose(live, 0, (size_t)(i / 3) % 2);
        show_at(live, 0.01 * i);
        beam_laboratory.update(live, 0.01 * i);
        usleep(i % 10 == 9 ? 400000 : 10000);
    }
    double before = stopwatch_now();
    beam_laboratory.close(live);
    CHECK(stopwatch_now() - before < (SANITIZED ? 10 : 1));
}
