#include "study/types.h"

#include <assert.h>
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "base/order.h"
#include "base/parallel.h"
#include "base/real.h"
#include "base/stop.h"
#include "study/batch.h"

const char *types_kind_name(TypesKind kind) {
    static const char *const names[] = {"unresolved", "I", "II", "III", "interrupted"};
    return names[kind];
}

/* State of a classification. */
typedef struct Work {
    const TypesTask *task;
    Types *types;
    Batch window; /* (points x starts) */
    pthread_mutex_t mutex;
    size_t done, all; /* trials */
} Work;

static bool is_stopped(const TypesTask *task) {
    return stop_requested(task->stop);
}

static void tell_done(void *context, size_t trials) {
    Work *work = context;
    pthread_mutex_lock(&work->mutex);
    work->done += trials;
    if (work->task->progress)
        work->task->progress(work->task->context, work->done, work->all);
    pthread_mutex_unlock(&work->mutex);
}

/* The window ------------------------------------------------------------------------------------------------------ */

static void lay_out_points(Types *types) {
    size_t centre = types->parameter_count;
    types->points[0] = (TypesPoint){.parameter = centre, .value = NAN};
    types->point_count = 1;
    for (size_t p = 0; p < types->parameter_count; p++)
        for (int side = -1; side <= 1 && types->parameters[p].nominal != 0; side += 2)
            types->points[types->point_count++] =
                (TypesPoint){.parameter = p, .value = types->parameters[p].nominal * (1 + side * TYPES_WINDOW)};
}

static void run_piece(void *context, size_t piece) {
    Work *work = context;
    const Experiment *experiment = work->task->experiment;
    size_t first = piece * experiment->batch, rest = work->window.count - first;
    size_t count = rest < experiment->batch ? rest : experiment->batch;
    experiment->run(experiment->given, work->task->names, work->task->name_count, work->window.trials + first, count,
                    false, work->task->stop);
    tell_done(work, count);
}

static size_t starts_of(const TypesTask *task) {
    return task->starts ? task->starts : TYPES_STARTS;
}

static bool carries(const TypesTask *task) {
    return task->experiment->carries && !task->starts;
}

static void run_window(Work *work) {
    Types *types = work->types;
    const TypesTask *task = work->task;
    work->window = batch_create(task->experiment, task->names, task->name_count, types->point_count * starts_of(task));
    for (size_t i = 0; i < work->window.count; i++) {
        const TypesPoint *point = &types->points[i / starts_of(task)];
        size_t start = i % starts_of(task);
        uint64_t special = work->task->experiment->special;
        work->window.trials[i].seed = special && start == TYPES_STARTS - 1 ? special : start;
        if (point->parameter < types->parameter_count)
            batch_set(&work->window, i, point->parameter, point->value);
    }
    size_t batch = task->experiment->batch;
    parallel_for(task->jobs, (work->window.count + batch - 1) / batch, run_piece, work);
    for (size_t i = 0; i < work->window.count; i++)
        types->runs += work->window.trials[i].done && !work->window.trials[i].fault;
}

static double decided_regular(const Work *work, size_t trial) {
    return work->window.trials[trial].observed[work->task->experiment->regular];
}

static void forget(const Work *work, size_t trial) {
    work->window.trials[trial].observed[work->task->experiment->regular] = NAN;
}

/* Trials that are repeated thoroughly. */
typedef struct Again {
    const TypesTask *task;
    Batch batch;
} Again;

static void run_again(void *context, size_t i) {
    Again *again = context;
    const TypesTask *task = again->task;
    task->thorough->run(task->thorough->given, task->names, task->name_count, &again->batch.trials[i], 1, false,
                        task->stop);
}

/* Repeats the trials `of` (count) of the window and copies the results. */
static void make_again(Work *work, const size_t *of, size_t count) {
    const TypesTask *task = work->task;
    Again again = {.task = task, .batch = batch_create(task->thorough, task->names, task->name_count, count)};
    for (size_t i = 0; i < count; i++) {
        const Trial *trial = &work->window.trials[of[i]];
        again.batch.trials[i].seed = trial->seed;
        for (size_t n = 0; n < task->name_count; n++)
            batch_set(&again.batch, i, n, trial->at[n]);
    }
    parallel_for(task->jobs, count, run_again, &again);
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < task->experiment->observable_count; k++)
            work->window.trials[of[i]].observed[k] = again.batch.trials[i].observed[k];
        if (!again.batch.trials[i].done)
            forget(work, of[i]);
    }
    work->types->thorough += count;
    batch_clear(&again.batch);
}

/* Repeats trials that are not regular, from the centre outwards, until one is certainly irregular. If none is,
 * results that only the quick run found irregular become undetermined. */
static void confirm(Work *work) {
    const TypesTask *task = work->task;
    bool sure = !task->thorough;
    size_t undecided = 0;
    for (size_t i = 0; i < work->window.count && !sure && work->types->thorough < TYPES_THOROUGH_MOST &&
                       undecided < TYPES_UNDECIDED_MOST;) {
        size_t of[TYPES_THOROUGH_AT_ONCE], count = 0;
        for (; i < work->window.count && count < TYPES_THOROUGH_AT_ONCE; i++)
            if (work->window.trials[i].done && !work->window.trials[i].fault && decided_regular(work, i) != 1)
                of[count++] = i;
        make_again(work, of, count);
        for (size_t k = 0; k < count; k++) {
            sure |= decided_regular(work, of[k]) == 0;
            undecided += isnan(decided_regular(work, of[k])) ? 1 : 0;
        }
    }
    for (size_t i = 0; i < work->window.count && !sure; i++)
        if (decided_regular(work, i) == 0)
            forget(work, i);
}

/* Answers --------------------------------------------------------------------------------------------------------- */

static int compare_answers(const void *a, const void *b) {
    const TypesAnswer *x = a, *y = b;
    int outcome = order_rising(&x->outcome, &y->outcome);
    return outcome ? outcome : order_rising(&x->measure, &y->measure);
}

static bool is_same(const TypesAnswer *a, const TypesAnswer *b) {
    return a->outcome == b->outcome && fabs(a->measure - b->measure) <= TYPES_SAME * fabs(b->measure);
}

/* Groups the regular trials of a point by response; the first one's measure is the group's. */
static void gather_answers(const Work *work, size_t at) {
    const Experiment *experiment = work->task->experiment;
    TypesPoint *point = &work->types->points[at];
    TypesAnswer found[TYPES_STARTS];
    size_t count = 0, starts = starts_of(work->task);
    point->possible = true;
    for (size_t s = 0; s < starts; s++) {
        const Trial *trial = &work->window.trials[at * starts + s];
        double regular = trial->observed[experiment->regular];
        point->possible &= !trial->fault;
        point->irregular += regular == 0;
        point->undecided += isnan(regular) ? 1 : 0;
        if (regular == 0 && !point->verdict && experiment->verdict_count &&
            trial->observed[experiment->verdict] < (double)experiment->verdict_quick)
            point->verdict = trial_verdict(trial, experiment);
        if (regular == 1)
            found[count++] =
                (TypesAnswer){trial->observed[experiment->outcome], trial->observed[experiment->measure], 1, 0};
    }
    qsort(found, count, sizeof *found, compare_answers);
    for (size_t i = 0; i < count; i++)
        if (i && is_same(&found[i - 1], &found[i]))
            point->answers[point->answer_count - 1].starts++;
        else
            point->answers[point->answer_count++] = found[i];
}

/* Carried motions --------------------------------------------------------------------------------------------------
 */

enum { CHAIN = 3 /* points: an end of the window, its centre, the other end */ };

/* Chains of trials, each continuing from the one before: two for each parameter, upwards and downwards. */
typedef struct Chains {
    Work *work;
    const Experiment *experiment;
    size_t low[TYPES_PARAMETERS_MOST]; /* (count / 2) index of the lower end of each parameter, before the upper one */
    size_t count;
    Batch batch; /* (count x CHAIN) */
} Chains;

static size_t chain_point(const Chains *chains, size_t trial) {
    size_t chain = trial / CHAIN, low = chains->low[chain / 2], along = trial % CHAIN;
    bool up = chain % 2 == 0;
    return along == 1 ? 0 : (along == 0) == up ? low : low + 1;
}

static void run_chain(void *context, size_t chain) {
    const Chains *chains = context;
    const TypesTask *task = chains->work->task;
    chains->experiment->run(chains->experiment->given, task->names, task->name_count,
                            chains->batch.trials + CHAIN * chain, CHAIN, true, task->stop);
    if (chains->experiment == task->experiment)
        tell_done(chains->work, CHAIN);
}

static Batch lay_out_chains(const Chains *chains, const Experiment *experiment) {
    const Work *work = chains->work;
    Batch batch = batch_create(experiment, work->task->names, work->task->name_count, CHAIN * chains->count);
    for (size_t i = 0; i < batch.count; i++) {
        const TypesPoint *point = &work->types->points[chain_point(chains, i)];
        if (point->parameter < work->types->parameter_count)
            batch_set(&batch, i, point->parameter, point->value);
    }
    return batch;
}

/* Adds the answer of a carried trial to those of its point. */
static void add_carried(const Work *work, TypesPoint *point, const Trial *trial) {
    const Experiment *experiment = work->task->experiment;
    double regular = trial->observed[experiment->regular];
    if (!trial->done || trial->fault)
        return;
    point->carried_irregular += regular == 0;
    point->carried_undecided += isnan(regular) ? 1 : 0;
    if (regular != 1)
        return;
    const TypesAnswer made = {
        .outcome = trial->observed[experiment->outcome], .measure = trial->observed[experiment->measure], .carried = 1};
    for (size_t a = 0; a < point->answer_count; a++)
        if (is_same(&point->answers[a], &made)) {
            point->answers[a].carried++;
            return;
        }
    if (point->answer_count < TYPES_ANSWERS_MOST)
        point->answers[point->answer_count++] = made;
}

static bool all_regular(const Chains *chains, size_t chain) {
    for (size_t i = CHAIN * chain; i < CHAIN * (chain + 1); i++) {
        const Trial *trial = &chains->batch.trials[i];
        if (trial->done && !trial->fault && trial->observed[chains->work->task->experiment->regular] != 1)
            return false;
    }
    return true;
}

/* Repeats each chain that is not regular throughout with the full analysis, one after the other until one is certainly
 * irregular. Adds the answers. */
static void take_chains(Chains *quick, Chains *thorough) {
    Work *work = quick->work;
    bool sure = false;
    for (size_t c = 0; c < quick->count && !is_stopped(work->task); c++) {
        bool regular = all_regular(quick, c);
        Chains *from = regular || !thorough ? quick : thorough;
        if (sure && !regular)
            continue; /* the type is known */
        if (from == thorough) {
            run_chain(thorough, c);
            work->types->thorough += CHAIN;
        }
        for (size_t i = CHAIN * c + 1; i < CHAIN * (c + 1); i++) {
            TypesPoint *point = &work->types->points[chain_point(quick, i)];
            add_carried(work, point, &from->batch.trials[i]);
            sure |= point->carried_irregular > 0;
        }
    }
}

/* Carries motions through the window, unless it is known to be irregular somewhere. */
static void carry_through(Work *work) {
    const TypesTask *task = work->task;
    Types *types = work->types;
    Chains quick = {.work = work, .experiment = task->experiment}, thorough = {.experiment = task->thorough};
    for (size_t i = 0; i < types->point_count; i++)
        if (types->points[i].irregular)
            return;
    for (size_t i = 1; i + 1 < types->point_count; i += 2) {
        quick.low[quick.count / 2] = i;
        quick.count += 2;
    }
    quick.batch = lay_out_chains(&quick, task->experiment);
    parallel_for(task->jobs, quick.count, run_chain, &quick);
    for (size_t i = 0; i < quick.batch.count; i++)
        types->carried_runs += quick.batch.trials[i].done && !quick.batch.trials[i].fault && i % CHAIN;
    if (task->thorough) {
        thorough = quick;
        thorough.experiment = task->thorough;
        thorough.batch = lay_out_chains(&quick, task->thorough);
    }
    take_chains(&quick, task->thorough ? &thorough : NULL);
    batch_clear(&quick.batch);
    if (task->thorough)
        batch_clear(&thorough.batch);
}

/* Returns the response of a point with the same outcome and the nearest measure, or NULL. */
static const TypesAnswer *find_answer(const TypesPoint *point, const TypesAnswer *like) {
    const TypesAnswer *nearest = NULL;
    for (size_t a = 0; a < point->answer_count; a++)
        if (point->answers[a].outcome == like->outcome &&
            (!nearest || fabs(point->answers[a].measure - like->measure) < fabs(nearest->measure - like->measure)))
            nearest = &point->answers[a];
    return nearest;
}

/* Returns d ln P / d ln p from the centre to an end of the window. */
static double slope(const TypesAnswer *centre, const TypesAnswer *end, double share) {
    if (centre->measure == end->measure)
        return 0;
    if (centre->measure == 0 || end->measure == 0)
        return HUGE_VAL;
    return real_log(end->measure / centre->measure) / real_log1p(share);
}

static void find_sensitivities(Types *types) {
    for (size_t p = 0; p < types->parameter_count; p++)
        types->parameters[p].sensitivity = NAN;
    for (size_t i = 1; i < types->point_count; i++) {
        const TypesPoint *centre = &types->points[0], *point = &types->points[i];
        TypesParameter *parameter = &types->parameters[point->parameter];
        for (size_t a = 0; a < centre->answer_count; a++) {
            const TypesAnswer *end = find_answer(point, &centre->answers[a]);
            double steep = end ? slope(&centre->answers[a], end, point->value / parameter->nominal - 1) : (double)NAN;
            if (isnan(parameter->sensitivity) || fabs(steep) > fabs(parameter->sensitivity))
                parameter->sensitivity = steep;
        }
    }
}

/* The verdict ----------------------------------------------------------------------------------------------------- */

static bool has_outcome(const TypesPoint *point, double outcome) {
    for (size_t a = 0; a < point->answer_count; a++)
        if (point->answers[a].outcome == outcome)
            return true;
    return false;
}

/* True if a period at one point doubles at the other, with neither point having both. */
static bool flips(const TypesPoint *a, const TypesPoint *b) {
    for (size_t k = 0; k < a->answer_count; k++) {
        double period = a->answers[k].outcome;
        if (period > 0 && has_outcome(b, 2 * period) && !has_outcome(b, period) && !has_outcome(a, 2 * period))
            return true;
    }
    return false;
}

static bool decide(Types *types, TypesKind kind, TypesReason reason, size_t worst) {
    types->kind = kind;
    types->reason = reason;
    types->worst = worst;
    return true;
}

static bool decide_irregular(Types *types) {
    for (size_t i = 0; i < types->point_count; i++)
        if (types->points[i].irregular || types->points[i].carried_irregular)
            return decide(types, TYPES_III, TYPES_NOT_REGULAR, i);
    return false;
}

static bool decide_flips(Types *types) {
    for (size_t i = 0; i < types->point_count; i++)
        for (size_t k = 0; k < types->point_count; k++)
            if (flips(&types->points[k], &types->points[i]))
                return decide(types, TYPES_II, TYPES_FLIPS, i ? i : k);
    return false;
}

static bool decide_untold(Types *types) {
    for (size_t i = 0; i < types->point_count; i++)
        if ((types->points[i].possible || i == 0) && (types->points[i].undecided || types->points[i].carried_undecided))
            return decide(types, TYPES_UNRESOLVED, TYPES_UNDECIDED, i);
    return false;
}

static bool decide_several(Types *types) {
    const TypesPoint *centre = &types->points[0];
    for (size_t i = 0; i < types->point_count; i++)
        if (types->points[i].answer_count > 1)
            return decide(types, TYPES_II, TYPES_SEVERAL, i);
    for (size_t i = 1; i < types->point_count; i++)
        if (types->points[i].answer_count && !find_answer(&types->points[i], &centre->answers[0]))
            return decide(types, TYPES_II, TYPES_SEVERAL, i);
    return false;
}

static bool decide_steep(Types *types) {
    size_t steepest = 0;
    double most = TYPES_STEEP;
    for (size_t i = 1; i < types->point_count; i++) {
        double steep = fabs(types->parameters[types->points[i].parameter].sensitivity);
        if (steep >= most) {
            most = steep;
            steepest = i;
        }
    }
    return steepest && decide(types, TYPES_II, TYPES_STEEP_ANSWER, steepest);
}

static void decide_kind(Types *types, bool periods) {
    for (size_t i = 0; i < types->point_count; i++)
        if (types->points[i].answer_count > types->answers)
            types->answers = types->points[i].answer_count;
    if (!decide_irregular(types) && !decide_untold(types) && !(periods && decide_flips(types)) &&
        !decide_several(types) && !decide_steep(types))
        decide(types, TYPES_I, TYPES_ALL_WELL, 0);
}

/* Beyond the window ----------------------------------------------------------------------------------------------- */

static bool is_unknown(const Neighbour *side) {
    return side->answer == NEIGHBOUR_INTERRUPTED;
}

static void find_neighbours(Work *work) {
    const TypesTask *task = work->task;
    Types *types = work->types;
    Neighbour sides[2 * TYPES_PARAMETERS_MOST];
    bool regular = types->points[0].answer_count > 0 && !types->points[0].irregular && !types->points[0].undecided;
    types->sought = regular ? NEIGHBOURS_TROUBLE : NEIGHBOURS_REGULAR;
    neighbours_find(&(NeighboursTask){.experiment = task->experiment,
                                      .names = task->names,
                                      .name_count = task->name_count,
                                      .sought = types->sought,
                                      .jobs = task->jobs,
                                      .stop = task->stop,
                                      .done = tell_done,
                                      .context = work},
                    sides);
    for (size_t p = 0; p < types->parameter_count; p++) {
        types->parameters[p].below = sides[2 * p];
        types->parameters[p].above = sides[2 * p + 1];
        types->neighbour_runs += sides[2 * p].runs + sides[2 * p + 1].runs;
        types->stopped |= is_unknown(&sides[2 * p]) || is_unknown(&sides[2 * p + 1]);
    }
}

static void tell_unknown(const Experiment *experiment, const char *name, Fault *fault) {
    if (experiment->unknown)
        experiment->unknown(experiment->given, name, "types: ", fault);
    else
        fault_add(fault, "types: %s: unknown parameter of a %s", name, experiment->kind);
}

bool types_check(const Experiment *experiment, const char *const *names, size_t name_count, Fault *fault) {
    size_t before = fault->total;
    if (name_count > TYPES_PARAMETERS_MOST)
        fault_add(fault, "types: %zu parameters, must be at most %d", name_count, TYPES_PARAMETERS_MOST);
    for (size_t n = 0; n < name_count && fault->total == before; n++) {
        const Parameter *parameter = experiment->parameter(experiment->given, names[n]);
        if (!parameter)
            tell_unknown(experiment, names[n], fault);
        else if (parameter->kind == PARAMETER_WHOLE)
            fault_add(fault, "types: %s is an integer, so a window of 1 %% contains only its centre", names[n]);
        for (size_t m = 0; m < n; m++)
            if (strcmp(names[m], names[n]) == 0)
                fault_add(fault, "types: %s is named twice", names[n]);
    }
    return fault->total == before;
}

static void take_names(Types *types, const TypesTask *task) {
    const Experiment *experiment = task->experiment;
    for (size_t n = 0; n < task->name_count; n++)
        types->parameters[n] =
            (TypesParameter){.name = task->names[n], .nominal = experiment->nominal(experiment->given, task->names[n])};
    types->parameter_count = task->name_count;
}

/* Decides, once all runs of the window are made. */
static void decide_all(Work *work) {
    Types *types = work->types;
    find_sensitivities(types);
    decide_kind(types, work->task->experiment->periods);
    if (!work->task->window_only)
        find_neighbours(work);
}

/* Without the whole window nothing is known of any point. */
static void interrupt(Types *types) {
    const Neighbour unknown = {NEIGHBOUR_INTERRUPTED, NAN, NAN, NAN, 0};
    types->kind = TYPES_KIND_INTERRUPTED;
    types->reason = TYPES_INTERRUPTED;
    types->point_count = 0;
    for (size_t p = 0; p < types->parameter_count; p++) {
        types->parameters[p].sensitivity = NAN;
        types->parameters[p].below = types->parameters[p].above = unknown;
    }
}

bool types_classify(Types *types, const TypesTask *task, Fault *fault) {
    assert(!task->thorough || task->thorough->observable_count == task->experiment->observable_count);
    *types = (Types){0};
    if (!types_check(task->experiment, task->names, task->name_count, fault))
        return false;
    take_names(types, task);
    lay_out_points(types);
    Work work = {.task = task, .types = types};
    work.all = types->point_count * starts_of(task) + (carries(task) ? 2 * CHAIN * types->parameter_count : 0) +
               2 * types->parameter_count * NEIGHBOURS_STEPS * NEIGHBOURS_STARTS;
    pthread_mutex_init(&work.mutex, NULL);
    run_window(&work);
    confirm(&work);
    for (size_t i = 0; i < types->point_count && !is_stopped(task); i++)
        gather_answers(&work, i);
    if (carries(task) && !is_stopped(task))
        carry_through(&work);
    types->stopped = is_stopped(task);
    if (types->stopped)
        interrupt(types);
    else
        decide_all(&work);
    batch_clear(&work.window);
    pthread_mutex_destroy(&work.mutex);
    return true;
}
