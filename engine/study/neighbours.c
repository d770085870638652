#include "study/neighbours.h"

#include <math.h>

#include "base/parallel.h"
#include "base/stop.h"
#include "study/batch.h"

static const double FINE = 0.005, COARSE = 0.01;

double neighbours_share(size_t step) {
    size_t fine = step + 1 < NEIGHBOURS_FINE ? step + 1 : NEIGHBOURS_FINE;
    return FINE * (double)fine + COARSE * (double)(step + 1 - fine);
}

/* True if the condition holds at a step, given its trials (NEIGHBOURS_STARTS); false also when undetermined. */
static bool is_found(const NeighboursTask *task, const Trial *trials) {
    size_t regular = 0, irregular = 0;
    for (size_t s = 0; s < NEIGHBOURS_STARTS; s++) {
        double answer = trials[s].observed[task->experiment->regular];
        regular += answer == 1;
        irregular += answer == 0;
    }
    return task->sought == NEIGHBOURS_TROUBLE ? irregular > 0 : regular == NEIGHBOURS_STARTS;
}

static bool is_possible(const Trial *trials) {
    for (size_t s = 0; s < NEIGHBOURS_STARTS; s++)
        if (trials[s].fault || !trials[s].done)
            return false;
    return true;
}

/* Examines the steps from `first` up to but excluding `last`. Returns false once the condition is found or the range
 * ends. */
static bool look(const NeighboursTask *task, size_t name, double side, size_t first, size_t last,
                 Neighbour *neighbour) {
    const Experiment *experiment = task->experiment;
    double nominal = experiment->nominal(experiment->given, task->names[name]);
    Batch batch = batch_create(experiment, &task->names[name], 1, (last - first) * NEIGHBOURS_STARTS);
    for (size_t i = 0; i < batch.count; i++) {
        batch_set(&batch, i, 0, nominal * (1 + side * neighbours_share(first + i / NEIGHBOURS_STARTS)));
        batch.trials[i].seed = i % NEIGHBOURS_STARTS;
    }
    experiment->run(experiment->given, &task->names[name], 1, batch.trials, batch.count, false, task->stop);
    bool on = true;
    for (size_t step = first; step < last && on; step++) {
        const Trial *trials = batch.trials + (step - first) * NEIGHBOURS_STARTS;
        on = is_possible(trials);
        neighbour->reached = on ? neighbours_share(step) : neighbour->reached;
        neighbour->runs += on ? NEIGHBOURS_STARTS : 0;
        if (on && is_found(task, trials)) {
            neighbour->answer = NEIGHBOUR_FOUND;
            neighbour->share = side * neighbours_share(step);
            neighbour->value = trials[0].at[0];
            on = false;
        }
    }
    batch_clear(&batch);
    return on;
}

static void tell_done(const NeighboursTask *task, size_t steps) {
    if (task->done)
        task->done(task->context, steps * NEIGHBOURS_STARTS);
}

typedef struct Sides {
    const NeighboursTask *task;
    Neighbour *sides;
} Sides;

static void look_outwards(void *context, size_t i) {
    const Sides *all = context;
    const NeighboursTask *task = all->task;
    const Experiment *experiment = task->experiment;
    Neighbour *neighbour = &all->sides[i];
    *neighbour = (Neighbour){.value = NAN, .share = NAN};
    size_t at_once = experiment->batch > NEIGHBOURS_STARTS ? experiment->batch / NEIGHBOURS_STARTS : 1, step = 0;
    bool on = experiment->nominal(experiment->given, task->names[i / 2]) != 0;
    while (on && step < NEIGHBOURS_STEPS) {
        size_t last = step + at_once < NEIGHBOURS_STEPS ? step + at_once : NEIGHBOURS_STEPS;
        on = look(task, i / 2, i % 2 ? 1 : -1, step, last, neighbour);
        tell_done(task, last - step);
        step = last;
    }
    if (neighbour->answer == NEIGHBOUR_NONE && stop_requested(task->stop))
        *neighbour = (Neighbour){NEIGHBOUR_INTERRUPTED, NAN, NAN, NAN, neighbour->runs};
    tell_done(task, NEIGHBOURS_STEPS - step);
}

void neighbours_find(const NeighboursTask *task, Neighbour *sides) {
    Sides all = {task, sides};
    parallel_for(task->jobs, 2 * task->name_count, look_outwards, &all);
}
