#include "laboratory/machine/sweep.h"

#include <math.h>
#include <stdlib.h>

#include "base/order.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "study/batch.h"
#include "study/study.h"

static const double ALIKE = 1e-3; /* 1, share of a value's largest peak: peaks closer than this are drawn as one */

void machine_sweep_points_add(MachineSweepPoints *points, double value, double peak) {
    size_t at = points->count++;
    points->value = memory_reserve(points->value, &points->value_capacity, points->count, sizeof *points->value);
    points->peak = memory_reserve(points->peak, &points->peak_capacity, points->count, sizeof *points->peak);
    points->value[at] = value;
    points->peak[at] = peak;
}

void machine_sweep_points_clear(MachineSweepPoints *points) {
    memory_free(points->value);
    memory_free(points->peak);
    *points = (MachineSweepPoints){0};
}

bool machine_sweep_open(MachineSweep *sweep, const MachineSweepTask *task, Fault *fault) {
    *sweep = (MachineSweep){.task = *task};
    return task->kind->open_experiment(&sweep->experiment, &sweep->task.machine, fault);
}

void machine_sweep_close(MachineSweep *sweep) {
    sweep->task.kind->close_experiment(&sweep->experiment);
    sweep->task.kind->clear_carry(&sweep->carry);
}

size_t machine_sweep_values(const MachineSweepTask *task) {
    return task->carried ? 2 * task->kind->carried_steps : task->kind->steps;
}

/* Returns the nth step in the order from coarse to fine: every `coarse`th step, then the steps midway between two of
 * them, and so on. */
static size_t step_of(const MachineKind *kind, size_t nth) {
    size_t stride = kind->coarse, coarse = (kind->steps - 1) / stride + 1;
    if (nth < coarse)
        return nth * stride;
    nth -= coarse;
    while (nth >= (kind->steps - 1) / stride) {
        nth -= (kind->steps - 1) / stride;
        stride /= 2;
    }
    return nth * stride + stride / 2;
}

double machine_sweep_value(const MachineSweepTask *task, size_t nth, MachineSweepPass *pass) {
    const MachineKind *kind = task->kind;
    StudyAxis axis = {task->name, task->from, task->to, task->carried ? kind->carried_steps : kind->steps};
    *pass = !task->carried ? MACHINE_SWEEP_REST : nth < axis.steps ? MACHINE_SWEEP_UP : MACHINE_SWEEP_DOWN;
    size_t step = *pass == MACHINE_SWEEP_REST ? step_of(kind, nth) : nth < axis.steps ? nth : 2 * axis.steps - 1 - nth;
    return study_value(&axis, step);
}

/* The data shared by the threads. */
typedef struct Share {
    MachineSweep *sweep;
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

static void take_trial(Trial *trial, double value, MachineSweepPoints *points) {
    size_t count = trial->series_count;
    if (count)
        qsort(trial->series, count, sizeof *trial->series, order_rising);
    double apart = count ? ALIKE * trial->series[count - 1] : 0, last = -HUGE_VAL;
    for (size_t i = 0; i < count; i++)
        if (trial->series[i] - last > apart)
            machine_sweep_points_add(points, value, last = trial->series[i]);
}

/* Returns the number of values to compute next, all from the same pass. */
static size_t count_next(const MachineSweep *sweep, int jobs) {
    size_t all = machine_sweep_values(&sweep->task), together = sweep->task.kind->together;
    size_t count = together * (size_t)(jobs > 1 ? jobs : 1), pass = sweep->task.kind->carried_steps;
    if (sweep->task.carried && sweep->done < pass)
        all = pass;
    return count < all - sweep->done ? count : all - sweep->done;
}

bool machine_sweep_advance(MachineSweep *sweep, int jobs, const Stop *stop,
                           MachineSweepPoints points[MACHINE_SWEEP_PASSES]) {
    const MachineSweepTask *task = &sweep->task;
    size_t count = count_next(sweep, jobs);
    if (!count)
        return false;
    MachineSweepPass pass;
    Share share = {.sweep = sweep,
                   .batch = batch_create(&sweep->experiment, &task->name, 1, count),
                   .per_thread = (count + (size_t)(jobs > 1 ? jobs : 1) - 1) / (size_t)(jobs > 1 ? jobs : 1),
                   .stop = stop};
    for (size_t i = 0; i < count; i++)
        batch_set(&share.batch, i, 0, machine_sweep_value(task, sweep->done + i, &pass));
    if (task->carried && sweep->done == task->kind->carried_steps)
        task->kind->clear_carry(&sweep->carry);
    if (task->carried)
        task->kind->run_on(&sweep->experiment, task->name, share.batch.trials, count, &sweep->carry, stop);
    else
        parallel_for(jobs, (count + share.per_thread - 1) / share.per_thread, run_part, &share);
    bool whole = !stop_requested(stop);
    for (size_t i = 0; i < count && whole; i++) {
        double value = machine_sweep_value(task, sweep->done + i, &pass);
        take_trial(&share.batch.trials[i], value, &points[pass]);
    }
    sweep->done += whole ? count : 0;
    batch_clear(&share.batch);
    return whole;
}
