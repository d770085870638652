/* Tests the background work of a running beam: its orbit diagram is a study, the verdict arrives by itself, and the
 * newest question wins. */

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "base/stopwatch.h"
#include "check.h"
#include "experiment/beam_experiment.h"
#include "laboratory/beam/beam_machine.h"
#include "laboratory/machine/diagram.h"
#include "oscillator.h"
#include "running_beam.h"
#include "study/study.h"

/* Returns the points of a pass at one value. */
static size_t count_points(const MachineSweepPoints *points, double value, const Trial *trial, size_t *alike) {
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

static void check_sweep(MachineSweepTask task, size_t values, size_t steps, const StudyPass *passes,
                        size_t pass_count) {
    Experiment experiment;
    Fault fault = {0};
    MachineSweep sweep;
    MachineSweepPoints points[MACHINE_SWEEP_PASSES] = {{0}};
    CHECK(beam_experiment_of(&experiment, &task.machine.beam, "ibs", &fault));
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
    CHECK(machine_sweep_open(&sweep, &task, &fault));
    while (sweep.done < values)
        CHECK(machine_sweep_advance(&sweep, 2, NULL, points));
    size_t alike = 0, seen = 0;
    for (size_t pass = 0; pass < pass_count; pass++)
        for (size_t i = 0; i < steps; i++) {
            const Trial *trial = study_trial(&study, pass, 0, 0, i);
            double value = study_value(&study.axes[0], i);
            if (trial->series_count)
                seen += count_points(&points[task.carried ? pass + MACHINE_SWEEP_UP : 0], value, trial, &alike);
        }
    CHECK(seen > values && alike == seen);
    for (int pass = 0; pass < MACHINE_SWEEP_PASSES; pass++)
        machine_sweep_points_clear(&points[pass]);
    machine_sweep_close(&sweep);
    study_clear(&study);
    beam_experiment_close(&experiment);
}

TEST(the_orbit_diagram_is_a_study) {
    Beam beam = oscillator_beam("ibs", "beam.modes=4");
    beam.transient_cycles = 60;
    beam.cycles = 20;
    const StudyPass reset = STUDY_RESET, both[] = {STUDY_UP, STUDY_DOWN};
    check_sweep((MachineSweepTask){&beam_machine, {beam}, "drive.frequency", 150, 320, false}, 32, BEAM_SWEEP_STEPS,
                &reset, 1);
    beam.transient_cycles = 10;
    beam.cycles = 4;
    check_sweep((MachineSweepTask){&beam_machine, {beam}, "drive.frequency", 250, 320, true},
                2 * BEAM_SWEEP_CARRIED_STEPS, BEAM_SWEEP_CARRIED_STEPS, both, 2);
    beam_free(&beam);
}

TEST(an_orbit_diagram_has_each_value_once) {
    MachineSweepTask task = {.kind = &beam_machine, .name = "drive.frequency", .from = 0, .to = BEAM_SWEEP_STEPS - 1};
    bool seen[BEAM_SWEEP_STEPS] = {false};
    MachineSweepPass pass;
    for (size_t i = 0; i < machine_sweep_values(&task); i++) {
        size_t value = (size_t)lround(machine_sweep_value(&task, i, &pass));
        CHECK(i >= 31 || value % BEAM_SWEEP_COARSE == 0);
        CHECK(!seen[value]);
        seen[value] = true;
    }
}

#define QUICK "run.transient_cycles=60", "run.cycles=20", "beam.modes=3"

#define PATIENCE 1000 /* s, longest wait for a state, even on a busy machine and with the sanitizers */

static bool wait_for(void *session, bool (*what)(void *session)) {
    for (double until = stopwatch_now() + PATIENCE; stopwatch_now() < until; usleep(5000)) {
        beam_laboratory.update(session, 0);
        if (what(session))
            return true;
    }
    return false;
}

static bool is_decided(void *session) {
    return !beam_laboratory.answer(session).stale;
}

static bool is_typed(void *session) {
    return is_decided(session) && strstr(beam_laboratory.answer(session).detail, "type ");
}

static bool is_swept(void *session) {
    LaboratoryPlot plot = beam_laboratory.plot(session, running_beam_find_plot("orbit"));
    return plot.plot->series[1].count > BEAM_SWEEP_STEPS / 2;
}

static bool is_idle(void *session) {
    return is_typed(session) && !beam_laboratory.answer(session).doing;
}

static bool is_banded(void *session) {
    return beam_laboratory.plot(session, running_beam_find_plot("orbit")).plot->area_count > 0;
}

enum { STABLE = MACHINE_DIAGRAM_LINES, UNSTABLE, LOCATED };

static const PlotSeries *orbit_series(void *session, size_t series) {
    return &beam_laboratory.plot(session, running_beam_find_plot("orbit")).plot->series[series];
}

static bool is_followed(void *session) {
    return orbit_series(session, STABLE)->count > 0;
}

static bool tells(void *session, const char *words) {
    size_t count;
    const PanelRow *rows = beam_laboratory.rows(session, &count);
    for (size_t i = 0; i < count; i++)
        if (rows[i].row.cells[0] && strstr(rows[i].row.cells[0], words))
            return true;
    return false;
}

static bool tells_why(void *session) {
    return tells(session, "no stable orbit");
}

TEST(an_orbit_is_followed_along_the_diagram_removed_and_forgotten_with_other_numbers) {
    const char *const settings[] = {QUICK, "drive.frequency=230"};
    void *session = running_beam_open("ibs", settings, 4);
    Fault fault = {0};
    CHECK(beam_laboratory.follow(session));
    CHECK(wait_for(session, is_followed));
    CHECK(orbit_series(session, UNSTABLE)->count > 0 && orbit_series(session, LOCATED)->count > 0);
    CHECK_TEXT(orbit_series(session, STABLE)->name, "stable");
    CHECK(wait_for(session, is_decided) && tells(session, "Followed (period 1)") && tells(session, "fold"));
    CHECK(!beam_laboratory.follow(session)); /* removes it */
    CHECK(!is_followed(session));
    CHECK(beam_laboratory.follow(session) && wait_for(session, is_followed));
    CHECK(beam_laboratory.set(session, "joint.damping", 150, &fault));
    CHECK(!is_followed(session));
    beam_laboratory.close(session);
}

TEST(without_a_stable_orbit_the_window_says_so) {
    const char *const settings[] = {"run.transient_cycles=60", "run.cycles=20"}; /* chaotic at 300 Hz */
    void *session = running_beam_open("ibs", settings, 2);
    CHECK(beam_laboratory.follow(session));
    CHECK(wait_for(session, tells_why) && !is_followed(session));
    beam_laboratory.close(session);
}

LONG_TEST(verdict_type_and_orbit_diagram_come_by_themselves) {
    const char *const settings[] = {QUICK};
    void *session = running_beam_open("ibs", settings, 3);
    running_beam_show_at(session, 0.1);
    CHECK(!is_decided(session));
    CHECK(wait_for(session, is_decided));
    CHECK(wait_for(session, is_swept));
    CHECK(wait_for(session, is_typed));
    CHECK(wait_for(session, is_banded) && wait_for(session, is_idle));
    size_t count;
    const PanelRow *rows = beam_laboratory.rows(session, &count);
    CHECK(count > 6 && rows[0].row.kind == ROW_HEADING);
    LaboratoryPlot orbit = beam_laboratory.plot(session, running_beam_find_plot("orbit"));
    CHECK_NEAR(orbit.cursor, 300, 1e-9);
    CHECK_TEXT(orbit.cursor_text, "300.0 Hz");
    CHECK_TEXT(orbit.cursor_parameter, "drive.frequency");
    CHECK(orbit.plot->x.low < orbit.cursor && orbit.cursor < orbit.plot->x.high);
    Fault fault = {0};
    CHECK(beam_laboratory.set(session, "drive.frequency", 290, &fault)); /* the cursor moves, the diagram stays */
    beam_laboratory.update(session, 0);
    CHECK(!is_decided(session));
    CHECK(is_swept(session) &&
          beam_laboratory.plot(session, running_beam_find_plot("orbit")).revision == orbit.revision);
    CHECK_NEAR(beam_laboratory.plot(session, running_beam_find_plot("orbit")).cursor, 290, 1e-9);
    CHECK(wait_for(session, is_decided));
    beam_laboratory.close(session);
}

static bool is_renewed(void *session) {
    return orbit_series(session, MACHINE_DIAGRAM_OLDER)->count == 0;
}

TEST(points_of_other_numbers_stay_pale_until_there_are_new_ones) {
    const char *const settings[] = {QUICK};
    void *session = running_beam_open("ibs", settings, 3);
    Fault fault = {0};
    CHECK(wait_for(session, is_swept) && is_renewed(session));
    size_t before = orbit_series(session, MACHINE_DIAGRAM_PASSES)->count;
    CHECK(beam_laboratory.set(session, "joint.damping", 150, &fault));
    const PlotSeries *older = orbit_series(session, MACHINE_DIAGRAM_OLDER);
    CHECK(older->count == before && orbit_series(session, MACHINE_DIAGRAM_PASSES)->count == 0);
    CHECK_TEXT(older->name, "updating");
    CHECK(wait_for(session, is_renewed) && orbit_series(session, MACHINE_DIAGRAM_PASSES)->count > 0);
    beam_laboratory.close(session);
}

TEST(the_newest_question_wins_and_closing_does_not_wait) {
    void *session = running_beam_open("ibs", NULL, 0);
    Fault fault = {0};
    for (int i = 0; i < 40; i++) {
        CHECK(beam_laboratory.set(session, "joint.damping", 100 + i, &fault));
        beam_laboratory.choose(session, 1, (size_t)i % 6);
        beam_laboratory.choose(session, 0, (size_t)(i / 3) % 2);
        running_beam_show_at(session, 0.01 * i);
        beam_laboratory.update(session, 0.01 * i);
        usleep(i % 10 == 9 ? 400000 : 10000);
    }
    double before = stopwatch_now();
    beam_laboratory.close(session);
    CHECK(stopwatch_now() - before < (RUNNING_BEAM_SANITIZED ? 10 : 1));
}
