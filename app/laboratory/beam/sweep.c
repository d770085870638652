#include "laboratory/beam/sweep.h"

#include <math.h>
#include <stdlib.h>

#include "base/order.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "study/batch.h"
#include "study/study.h"

enum { TOGETHER = 16 /* values that each thread computes at a time */ };

static const double ALIKE = 1e-3; /* 1, share of a value's largest peak: peaks closer than this are drawn as one */

void beam_sweep_points_add(BeamSweepPoints *points, double value, double peak) {
    size_t at = points->count++;
    points->value = memory_reserve(points->value, &points->value_capacity, points->count, sizeof *points->value);
    points->peak = memory_reserve(points->peak, &points->peak_capacity, points->count, sizeof *points->peak);
    points->value[at] = value;
    points->peak[at] = peak;
}

void beam_sweep_points_clear(BeamSweepPoints *points) {
    memory_free(points->value);
    memory_free(points->peak);
    *points = (BeamSweepPoints){0};
}

bool beam_sweep_open(BeamSweep *sweep, const BeamSweepTask *task, Fault *fault) {
    *sweep = (BeamSweep){.task = *task};
    return beam_experiment_of(&sweep->experiment, &sweep->task.beam, task->beam.name, fault);
}

void beam_sweep_close(BeamSweep *sweep) {
    beam_experiment_close(&sweep->experiment);
    beam_carry_clear(&sweep->carry);
}

size_t beam_sweep_values(const BeamSweepTask *task) {
    return task->carried ? 2 * BEAM_SWEEP_CARRIED_STEPS : BEAM_SWEEP_STEPS;
}

/* Returns the nth step in the order from coarse to fine: every sixteenth step, then the steps midway between two of
 * them, and so on. */
static size_t step_of(size_t nth) {
    size_t stride = BEAM_SWEEP_COARSE, coarse = (BEAM_SWEEP_STEPS - 1) / stride + 1;
    if (nth < coarse)
        return nth * stride;
    nth -= coarse;
    while (nth >= (BEAM_SWEEP_STEPS - 1) / stride) {
        nth -= (BEAM_SWEEP_STEPS - 1) / stride;
        stride /= 2;
    }
    return nth * stride + stride / 2;
}

double beam_sweep_value(const BeamSweepTask *task, size_t nth, BeamSweepPass *pass) {
    StudyAxis axis = {task->name, task->from, task->to, task->carried ? BEAM_SWEEP_CARRIED_STEPS : BEAM_SWEEP_STEPS};
    *pass = !task->carried ? BEAM_SWEEP_REST : nth < axis.steps ? BEAM_SWEEP_UP : BEAM_SWEEP_DOWN;
    size_t step = *pass == BEAM_SWEEP_REST ? step_of(nth) : nth < axis.steps ? nth : 2 * axis.steps - 1 - nth;
    return study_value(&axis, step);
}

/* The data shared by the threads. */
typedef struct Share {
    BeamSweep *sweep;
    Batch batch;
    size_t per_thread; /* trials */
    const Stop *stop;
} Share;

static void run_part(void *context, size_t i) {
    Share *share = context;
    const Experiment *experiment = &share->sweep->experiment;
    size_t from = i * share->per_thread, rest = share->batch.count - from;
    experiment->run(experiment->given, &share->sweep->task.name, 1, share->batch.trials + from,
                    rest < share->per_thread ? rest : share->per_thread, false, share->stop);
}

static void take_trial(Trial *trial, double value, BeamSweepPoints *points) {
    size_t count = trial->series_count;
    if (count)
        qsort(trial->series, count, sizeof *trial->series, order_rising);
    double apart = count ? ALIKE * trial->series[count - 1] : 0, last = -HUGE_VAL;
    for (size_t i = 0; i < count; i++)
        if (trial->series[i] - last > apart)
            beam_sweep_points_add(points, value, last = trial->series[i]);
}

/* Returns the number of values to compute next, all from the same pass. */
static size_t count_next(const BeamSweep *sweep, int jobs) {
    size_t all = beam_sweep_values(&sweep->task), count = TOGETHER * (size_t)(jobs > 1 ? jobs : 1);
    if (sweep->task.carried && sweep->done < BEAM_SWEEP_CARRIED_STEPS)
        all = BEAM_SWEEP_CARRIED_STEPS;
    return count < all - sweep->done ? count : all - sweep->done;
}

bool beam_sweep_advance(BeamSweep *sweep, int jobs, const Stop *stop, BeamSweepPoints points[BEAM_SWEEP_PASSES]) {
    const BeamSweepTask *task = &sweep->task;
    size_t count = count_next(sweep, jobs);
    if (!count)
        return false;
    BeamSweepPass pass;
    Share share = {.sweep = sweep,
                   .batch = batch_create(&sweep->experiment, &task->name, 1, count),
                   .per_thread = (count + (size_t)(jobs > 1 ? jobs : 1) - 1) / (size_t)(jobs > 1 ? jobs : 1),
                   .stop = stop};
    for (size_t i = 0; i < count; i++)
        batch_set(&share.batch, i, 0, beam_sweep_value(task, sweep->done + i, &pass));
    if (task->carried && sweep->done == BEAM_SWEEP_CARRIED_STEPS)
        beam_carry_clear(&sweep->carry);
    if (task->carried)
        beam_experiment_run_on(&sweep->experiment, task->name, share.batch.trials, count, &sweep->carry, stop);
    else
        parallel_for(jobs, (count + share.per_thread - 1) / share.per_thread, run_part, &share);
    bool whole = !stop_requested(stop);
    for (size_t i = 0; i < count && whole; i++) {
        double value = beam_sweep_value(task, sweep->done + i, &pass);
        take_trial(&share.batch.trials[i], value, &points[pass]);
    }
    sweep->done += whole ? count : 0;
    batch_clear(&share.batch);
    return whole;
}
