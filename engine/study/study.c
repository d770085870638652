#include "study/study.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "base/digest.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/stop.h"

const char *study_pass_name(StudyPass pass) {
    static const char *const names[] = {[STUDY_RESET] = "reset", [STUDY_UP] = "up", [STUDY_DOWN] = "down"};
    return names[pass];
}

double study_value(const StudyAxis *axis, size_t i) {
    if (i + 1 == axis->steps && i)
        return axis->to;
    double share = axis->steps > 1 ? (double)i / (double)(axis->steps - 1) : 0;
    return axis->from + (axis->to - axis->from) * share;
}

/* What is asked -------------------------------------------------------------------------------------------------- */

/* Returns the parameter of that name if it can be varied; `option` is the option that names it. */
static const Parameter *check_name(const Study *study, const char *option, const char *name, Fault *fault) {
    const Experiment *experiment = study->experiment;
    const Parameter *parameter = experiment->parameter(experiment->given, name);
    char place[200];
    snprintf(place, sizeof place, "%s %.150s: ", option, name);
    if (!parameter && experiment->unknown)
        experiment->unknown(experiment->given, name, place, fault);
    else if (!parameter)
        fault_add(fault, "%sunknown parameter of a %s", place, experiment->kind);
    return parameter;
}

static void check_whole_steps(const StudyAxis *axis, Fault *fault) {
    for (size_t i = 0; i < axis->steps; i++) {
        double value = study_value(axis, i);
        if (value == floor(value))
            continue;
        double apart = fabs(axis->to - axis->from);
        if (axis->from == floor(axis->from) && axis->to == floor(axis->to))
            fault_add(fault, "--vary %s: one of the %zu values is %g, must be an integer; use %.0f steps", axis->name,
                      axis->steps, value, apart + 1);
        else
            fault_add(fault, "--vary %s: one of the values is %g, must be an integer", axis->name, value);
        return;
    }
}

/* Checks the number of steps; true if it fits the range. */
static bool check_steps(const StudyAxis *axis, Fault *fault) {
    size_t before = fault->total;
    if (axis->steps < 1 || axis->steps > STUDY_STEPS_MOST)
        fault_add(fault, "--vary %s: %zu steps, must be from 1 to %d", axis->name, axis->steps, STUDY_STEPS_MOST);
    else if (axis->steps == 1 && axis->from != axis->to)
        fault_add(fault, "--vary %s: one step cannot be at %g and at %g, must be 2 or more", axis->name, axis->from,
                  axis->to);
    else if (axis->steps > 1 && axis->from == axis->to)
        fault_add(fault, "--vary %s: all %zu steps are at %g, FROM and TO must differ", axis->name, axis->steps,
                  axis->from);
    return fault->total == before;
}

static bool check_range(const StudyAxis *axis, const Parameter *parameter, Fault *fault) {
    const double ends[] = {axis->from, axis->to};
    for (size_t e = 0; e < 2; e++)
        if (!(ends[e] >= parameter->low && ends[e] <= parameter->high)) {
            fault_add(fault, "--vary %s: %g is out of range, must be from %g to %g%s%s", axis->name, ends[e],
                      parameter->low, parameter->high, strcmp(parameter->unit, "1") ? " " : "",
                      strcmp(parameter->unit, "1") ? parameter->unit : "");
            return false;
        }
    return true;
}

/* Adds the first error of an axis. */
static void check_axis(const Study *study, size_t a, Fault *fault) {
    const StudyAxis *axis = &study->axes[a];
    const Parameter *parameter = check_name(study, "--vary", axis->name, fault);
    if (!parameter)
        return;
    for (size_t k = 0; k < a; k++)
        if (strcmp(study->axes[k].name, axis->name) == 0) {
            fault_add(fault, "--vary %s: is given twice, the second must be another parameter", axis->name);
            return;
        }
    if (check_steps(axis, fault) && check_range(axis, parameter, fault) && parameter->kind == PARAMETER_WHOLE)
        check_whole_steps(axis, fault);
}

static void check_spread(const Study *study, size_t s, Fault *fault) {
    const StudySpread *spread = &study->spreads[s];
    const Experiment *experiment = study->experiment;
    const Parameter *parameter = check_name(study, "--spread", spread->name, fault);
    bool varied = false;
    for (size_t a = 0; a < study->axis_count; a++)
        varied |= strcmp(study->axes[a].name, spread->name) == 0;
    for (size_t k = 0; k < s; k++)
        if (strcmp(study->spreads[k].name, spread->name) == 0)
            fault_add(fault, "--spread %s: is given twice", spread->name);
    if (!(spread->share > 0 && spread->share <= 1))
        fault_add(fault, "--spread %s: %g, must be greater than 0 and at most 1, as a fraction of the value",
                  spread->name, spread->share);
    if (parameter && parameter->kind == PARAMETER_WHOLE)
        fault_add(fault, "--spread %s: is an integer, a tolerance needs a real number", spread->name);
    else if (parameter && !varied && experiment->nominal(experiment->given, spread->name) == 0)
        fault_add(fault, "--spread %s: the value is 0, so a relative spread has no effect; set it with --set %s=VALUE",
                  spread->name, spread->name);
    if (study->runs < 2)
        fault_add(fault, "--spread %s: a spread needs several runs, --runs must be at least 2", spread->name);
}

static void check_passes(const Study *study, Fault *fault) {
    for (size_t p = 0; p < study->pass_count; p++) {
        const char *name = study_pass_name(study->passes[p]);
        for (size_t k = 0; k < p; k++)
            if (study->passes[k] == study->passes[p])
                fault_add(fault, "--sweep: %s is named twice", name);
        if (study->passes[p] == STUDY_RESET)
            continue;
        if (!study->experiment->carries)
            fault_add(fault, "--sweep %s: runs of a %s always restart, must be reset", name, study->experiment->kind);
        else if (!study->axis_count)
            fault_add(fault, "--sweep %s: needs --vary", name);
    }
}

bool study_check(const Study *study, Fault *fault) {
    size_t before = fault->total;
    for (size_t a = 0; a < study->axis_count; a++)
        check_axis(study, a, fault);
    for (size_t s = 0; s < study->spread_count; s++)
        check_spread(study, s, fault);
    check_passes(study, fault);
    if (study->runs < 1 || study->runs > STUDY_RUNS_MOST)
        fault_add(fault, "--runs %zu: must be from 1 to %d", study->runs, STUDY_RUNS_MOST);
    if (study->seed > (uint64_t)(INT64_MAX - STUDY_RUNS_MOST))
        fault_add(fault, "--seed %" PRIu64 ": is too large for the seeds of all runs, must be at most %" PRId64,
                  study->seed, INT64_MAX - STUDY_RUNS_MOST);
    double trials =
        (double)study->pass_count * (double)study->runs * (double)study_steps(study, 0) * (double)study_steps(study, 1);
    if (fault->total == before && trials > STUDY_TRIALS_MOST)
        fault_add(fault, "the study has %.0f runs (steps times steps times runs times sweeps), must be at most %d",
                  trials, STUDY_TRIALS_MOST);
    return fault->total == before;
}

/* Making the trials ---------------------------------------------------------------------------------------------- */

/* Returns the index of a name in the study, adding the name if it is new. */
static size_t take_name(Study *study, const char *name) {
    for (size_t n = 0; n < study->name_count; n++)
        if (strcmp(study->names[n], name) == 0)
            return n;
    study->names[study->name_count] = name;
    return study->name_count++;
}

/* Returns the deviation of a parameter for a seed, in standard deviations. */
static double deviate(uint64_t seed, const char *name) {
    Random random = random_seed(seed, digest_text(DIGEST_START, name));
    return random_normal(&random, 0, 1);
}

/* Draws the values of a run's parameters that no axis varies, and the factor of each deviation. */
static void draw_run(const Study *study, uint64_t seed, const size_t *places, double *fixed, double *factors) {
    const Experiment *experiment = study->experiment;
    for (size_t n = 0; n < study->name_count; n++) {
        fixed[n] = n < study->axis_count ? (double)NAN : experiment->nominal(experiment->given, study->names[n]);
        factors[n] = 1;
    }
    for (size_t s = 0; s < study->spread_count && seed; s++)
        factors[places[s]] *= 1 + study->spreads[s].share * deviate(seed, study->spreads[s].name);
}

/* The trial at a place. */
static Trial *placed(const Study *study, size_t place) {
    if (study->large)
        file_memory_touch(study->large);
    return &study->trials[place];
}

/* The trial to write to. */
static Trial *nth(Study *study, size_t trial) {
    return (Trial *)study_nth(study, trial);
}

static void clear_observed(const Study *study, Trial *trial) {
    for (size_t o = 0; o < study->experiment->observable_count; o++)
        trial->observed[o] = (double)NAN;
}

static void fill_run(Study *study, size_t pass, size_t run, const double *fixed, const double *factors) {
    double *at = study->values, *observed = at + study_room(study) * study->name_count;
    for (size_t i1 = 0; i1 < study_steps(study, 1); i1++) {
        for (size_t i0 = 0; i0 < study_steps(study, 0); i0++) {
            const size_t steps[STUDY_AXES_MOST] = {i0, i1};
            size_t index = study_index(study, pass, run, i1, i0);
            if (!study_has(study, index))
                continue;
            size_t place = study_place(study, index);
            double *own = at + place * study->name_count;
            for (size_t n = 0; n < study->name_count; n++) {
                double value = n < study->axis_count ? study_value(&study->axes[n], steps[n]) : fixed[n];
                own[n] = factors[n] == 1 ? value : value * factors[n];
            }
            Trial *trial = nth(study, index);
            trial->at = own;
            trial->seed = study->seed + run;
            trial->observed = observed + place * study->experiment->observable_count;
            clear_observed(study, trial);
        }
    }
}

size_t study_size(const Study *study) {
    return study->pass_count * study->runs * study_steps(study, 1) * study_steps(study, 0);
}

/* Lists the names, and returns in `places` those of the spreads. */
static void name_all(Study *study, size_t places[STUDY_SPREADS_MOST]) {
    study->name_count = 0;
    for (size_t a = 0; a < study->axis_count; a++)
        take_name(study, study->axes[a].name);
    for (size_t s = 0; s < study->spread_count; s++)
        places[s] = take_name(study, study->spreads[s].name);
    study->trial_count = study_size(study);
}

static size_t values_of(const Study *study) {
    return study_room(study) * (study->name_count + study->experiment->observable_count);
}

static void fill_all(Study *study, const size_t *places) {
    for (size_t run = 0; run < study->runs; run++) {
        double fixed[STUDY_NAMES_MOST], factors[STUDY_NAMES_MOST];
        draw_run(study, study->seed + run, places, fixed, factors);
        for (size_t pass = 0; pass < study->pass_count; pass++)
            fill_run(study, pass, run, fixed, factors);
    }
}

void study_begin(Study *study) {
    size_t places[STUDY_SPREADS_MOST];
    name_all(study, places);
    study->trials = memory_zeroed(study_room(study), sizeof *study->trials);
    study->values = memory_zeroed(values_of(study), sizeof *study->values);
    fill_all(study, places);
}

static void add_no_room(const Study *study, const char *folder, Fault *fault) {
    fault_add(fault, "%s cannot hold the results of %zu runs: %s; set TMPDIR to a directory with more room", folder,
              study_room(study), strerror(errno));
}

bool study_begin_in(Study *study, const char *folder, Fault *fault) {
    size_t places[STUDY_SPREADS_MOST];
    name_all(study, places);
    study->folder = folder;
    study->large = file_memory_create(folder);
    if (study->large)
        study->trials = file_memory_take(study->large, study_room(study) * sizeof *study->trials);
    if (study->trials)
        study->values = file_memory_take(study->large, values_of(study) * sizeof *study->values);
    if (!study->values) {
        add_no_room(study, folder, fault);
        study_clear(study);
        return false;
    }
    fill_all(study, places);
    return true;
}

void study_clear(Study *study) {
    size_t held = study->trials && !study->large ? study_room(study) : 0;
    for (size_t place = 0; place < held; place++)
        trial_clear(&study->trials[place]);
    if (!study->large) {
        memory_free(study->trials);
        memory_free(study->values);
    }
    file_memory_destroy(study->large);
    study->large = NULL;
    study->trials = NULL;
    study->values = NULL;
    study->trial_count = 0;
    study->full = false;
}

/* Copies bytes to the file. Returns NULL where there are none, or no room for them. */
static void *copy_to_file(const Study *study, const void *bytes, size_t count) {
    void *copy = count ? file_memory_take(study->large, count) : NULL;
    if (copy)
        memcpy(copy, bytes, count);
    return copy;
}

static char *text_to_file(const Study *study, const char *text) {
    return copy_to_file(study, text, text ? strlen(text) + 1 : 0);
}

/* Moves what a result holds to the file. */
static bool move_to_file(const Study *study, Trial *result) {
    size_t count = result->series_count;
    double *series = copy_to_file(study, result->series, count * sizeof *series);
    char *fault = text_to_file(study, result->fault), *note = text_to_file(study, result->note);
    if ((count && !series) || (result->fault && !fault) || (result->note && !note))
        return false;
    trial_clear(result);
    result->series = series;
    result->series_count = count;
    result->fault = fault;
    result->note = note;
    return true;
}

bool study_take(Study *study, size_t index, Trial *result) {
    Trial *trial = nth(study, index);
    if (study->large && !move_to_file(study, result)) {
        trial_clear(result);
        __atomic_store_n(&study->full, true, __ATOMIC_RELAXED);
        return false;
    }
    if (!study->large)
        trial_clear(trial);
    if (study->experiment->observable_count)
        memcpy(trial->observed, result->observed, study->experiment->observable_count * sizeof *trial->observed);
    trial->series = result->series;
    trial->series_count = result->series_count;
    trial->fault = result->fault;
    trial->note = result->note;
    trial->done = true;
    return true;
}

void study_forget(Study *study) {
    size_t room = study_room(study);
    for (size_t place = 0; place < room; place++) {
        Trial *trial = placed(study, place);
        if (!study->large)
            trial_clear(trial);
        trial->series = NULL;
        trial->series_count = 0;
        trial->fault = trial->note = NULL;
        trial->done = false;
        clear_observed(study, trial);
    }
}

size_t study_done(const Study *study) {
    size_t done = 0, room = study_room(study);
    for (size_t place = 0; place < room; place++)
        done += placed(study, place)->done;
    return done;
}

/* Shards --------------------------------------------------------------------------------------------------------- */

/* The trials of a pass that stay together in one shard: a chain, or a single one. */
static size_t unit_of(const Study *study, size_t pass) {
    return study->passes[pass] == STUDY_RESET ? 1 : study_steps(study, 0);
}

/* Returns how many of the units before the `unit`-th one the shard has. */
static size_t units_before(StudyShard shard, size_t unit) {
    return (unit + shard.count - shard.number) / shard.count;
}

/* Returns the number of the shard's trials that come before one at the beginning of a unit of this pass. */
static size_t room_before(const Study *study, size_t pass, size_t trial) {
    size_t unit = unit_of(study, pass), each = study->trial_count / study->pass_count;
    return (units_before(study->shard, trial / unit) - units_before(study->shard, pass * each / unit)) * unit;
}

size_t study_shard_of(const Study *study, size_t count, size_t trial) {
    return trial / unit_of(study, study_pass_of(study, trial)) % count + 1;
}

bool study_has(const Study *study, size_t trial) {
    return !study->shard.count || study_shard_of(study, study->shard.count, trial) == study->shard.number;
}

size_t study_room(const Study *study) {
    size_t room = 0;
    if (!study->shard.count)
        return study->trial_count;
    size_t each = study->trial_count / study->pass_count;
    for (size_t pass = 0; pass < study->pass_count; pass++)
        room += room_before(study, pass, (pass + 1) * each);
    return room;
}

size_t study_place(const Study *study, size_t trial) {
    if (!study->shard.count)
        return trial;
    size_t at = study_pass_of(study, trial), place = 0, each = study->trial_count / study->pass_count;
    for (size_t pass = 0; pass < at; pass++)
        place += room_before(study, pass, (pass + 1) * each);
    return place + room_before(study, at, trial) + trial % unit_of(study, at);
}

/* Running -------------------------------------------------------------------------------------------------------- */

/* Trials that are put in order at a time: more than any number of threads needs, and few beside the largest studies. */
enum { BLOCK = 1 << 20 };

/* The trials of one call of the experiment. */
typedef struct Piece {
    size_t first, count; /* in Work.order */
    bool carry;
} Piece;

typedef struct Work {
    Study *study;
    const StudyOptions *options;
    size_t *order; /* (ordered) indices of the trials of a block */
    size_t ordered, order_capacity;
    Piece *pieces; /* (piece_count) of the block */
    size_t piece_count, capacity;
    size_t done, all;     /* trials of the shard */
    pthread_mutex_t lock; /* protects `done`, the results, the progress report and the keeper */
} Work;

static bool stopped(const Work *work) {
    return __atomic_load_n(&work->study->full, __ATOMIC_RELAXED) || stop_requested(work->options->stop);
}

static void add_trial(Work *work, size_t trial) {
    work->order = memory_reserve(work->order, &work->order_capacity, work->ordered + 1, sizeof *work->order);
    work->order[work->ordered++] = trial;
}

static void add_piece(Work *work, size_t first, size_t count, bool carry) {
    if (!count)
        return;
    work->pieces = memory_reserve(work->pieces, &work->capacity, work->piece_count + 1, sizeof *work->pieces);
    work->pieces[work->piece_count++] = (Piece){first, count, carry};
}

static void run_piece(void *context, size_t index);

static void run_block(Work *work) {
    if (!stopped(work))
        parallel_for(work->options->jobs, work->piece_count, run_piece, work);
    work->ordered = work->piece_count = 0;
}

/* Divides the trials from `begin` on into batches small enough to occupy all threads. */
static void add_batches(Work *work, size_t begin) {
    size_t end = work->ordered, jobs = work->options->jobs > 1 ? (size_t)work->options->jobs : 1;
    size_t batch = work->study->experiment->batch, share = (end - begin + jobs - 1) / jobs;
    batch = batch < 1 ? 1 : batch > share ? share : batch;
    for (size_t first = begin; first < end; first += batch)
        add_piece(work, first, first + batch < end ? batch : end - first, false);
}

/* Adds the trials of a pass. */
static void add_reset(Work *work, size_t pass) {
    const Study *study = work->study;
    size_t each = study->trial_count / study->pass_count, begin = work->ordered;
    for (size_t t = pass * each; t < (pass + 1) * each; t++) {
        if (study_has(study, t) && !study_nth(study, t)->done)
            add_trial(work, t);
        if (work->ordered < BLOCK)
            continue;
        add_batches(work, begin);
        run_block(work);
        begin = 0;
    }
    add_batches(work, begin);
}

/* Adds the trials along axis 0, one after another, if the shard has them and any is missing. */
static void add_chain(Work *work, size_t pass, size_t run, size_t i1) {
    const Study *study = work->study;
    size_t steps = study_steps(study, 0), first = work->ordered;
    bool missing = false;
    if (!study_has(study, study_index(study, pass, run, i1, 0)))
        return;
    for (size_t i0 = 0; i0 < steps; i0++)
        missing |= !study_trial(study, pass, run, i1, i0)->done;
    for (size_t i = 0; i < steps && missing; i++) {
        size_t i0 = study->passes[pass] == STUDY_DOWN ? steps - 1 - i : i;
        add_trial(work, study_index(study, pass, run, i1, i0));
    }
    add_piece(work, first, work->ordered - first, true);
    if (work->ordered >= BLOCK)
        run_block(work);
}

static void run_blocks(Work *work) {
    const Study *study = work->study;
    for (size_t pass = 0; pass < study->pass_count; pass++) {
        if (study->passes[pass] == STUDY_RESET) {
            add_reset(work, pass);
            continue;
        }
        for (size_t run = 0; run < study->runs; run++)
            for (size_t i1 = 0; i1 < study_steps(study, 1); i1++)
                add_chain(work, pass, run, i1);
    }
    run_block(work);
}

/* Takes the results of a piece; `fresh` lists the trials that were not done before. */
static size_t take_results(Study *study, const size_t *order, Trial *own, size_t count, size_t *fresh) {
    size_t fresh_count = 0;
    for (size_t i = 0; i < count; i++) {
        if (!study->experiment->series) {
            memory_free(own[i].series);
            own[i].series = NULL;
            own[i].series_count = 0;
        }
        bool before = study_nth(study, order[i])->done;
        if (!own[i].done && !own[i].fault)
            trial_clear(&own[i]);
        else if (study_take(study, order[i], &own[i]) && !before)
            fresh[fresh_count++] = order[i];
    }
    return fresh_count;
}

static void run_piece(void *context, size_t index) {
    Work *work = context;
    Study *study = work->study;
    const Experiment *experiment = study->experiment;
    const StudyOptions *options = work->options;
    const Piece *piece = &work->pieces[index];
    const size_t *order = work->order + piece->first;
    if (stopped(work))
        return;
    size_t observables = experiment->observable_count;
    Trial *own = memory_zeroed(piece->count, sizeof *own);
    double *observed = memory_zeroed(piece->count * observables, sizeof *observed);
    size_t *fresh = memory_zeroed(piece->count, sizeof *fresh);
    for (size_t i = 0; i < piece->count * observables; i++)
        observed[i] = (double)NAN;
    for (size_t i = 0; i < piece->count; i++) {
        const Trial *trial = study_nth(study, order[i]);
        own[i] = (Trial){.at = trial->at, .seed = trial->seed, .observed = observed + i * observables};
    }
    experiment->run(experiment->given, study->names, study->name_count, own, piece->count, piece->carry, options->stop);
    pthread_mutex_lock(&work->lock);
    size_t fresh_count = take_results(study, order, own, piece->count, fresh);
    work->done += fresh_count;
    if (options->keep && fresh_count)
        options->keep(options->keeper, study, fresh, fresh_count);
    if (options->progress)
        options->progress(options->context, work->done, work->all);
    pthread_mutex_unlock(&work->lock);
    memory_free(fresh);
    memory_free(observed);
    memory_free(own);
}

void study_run(Study *study, const StudyOptions *options) {
    Work work = {.study = study,
                 .options = options,
                 .done = study_done(study),
                 .all = study_room(study),
                 .lock = PTHREAD_MUTEX_INITIALIZER};
    run_blocks(&work);
    memory_free(work.pieces);
    memory_free(work.order);
}

/* Identity ------------------------------------------------------------------------------------------------------- */

uint64_t study_digest(const Study *study, uint64_t given) {
    const Experiment *experiment = study->experiment;
    uint64_t digest = digest_text(digest_chain(DIGEST_START, given), experiment->kind);
    digest = digest_chain(digest, experiment->identity);
    for (size_t o = 0; o < experiment->observable_count; o++)
        digest = digest_text(digest_text(digest, experiment->observables[o].name), experiment->observables[o].unit);
    digest = digest_text(digest, experiment->series ? experiment->series->name : "");
    digest = digest_mix(digest, (double)study->axis_count);
    for (size_t a = 0; a < study->axis_count; a++) {
        const StudyAxis *axis = &study->axes[a];
        digest = digest_mix(digest_mix(digest_text(digest, axis->name), axis->from), axis->to);
        digest = digest_mix(digest, (double)axis->steps);
    }
    digest = digest_mix(digest, (double)study->spread_count);
    for (size_t s = 0; s < study->spread_count; s++)
        digest = digest_mix(digest_text(digest, study->spreads[s].name), study->spreads[s].share);
    for (size_t p = 0; p < study->pass_count; p++)
        digest = digest_text(digest, study_pass_name(study->passes[p]));
    digest = digest_mix(digest, (double)study->runs);
    return digest_bytes(digest, &study->seed, sizeof study->seed);
}
