#include "experiment/crank_experiment.h"

#include <math.h>
#include <string.h>

#include "base/digest.h"
#include "base/parameters_number.h"
#include "base/random.h"
#include "base/real.h"
#include "base/text.h"
#include "crank/crank_cycle.h"
#include "cycle/motion_class.h"

/* Part of the clearance within which the ball begins at random. */
static const double START_WITHIN = 0.9;
/* Evaluations of the right side that any quick trial may take: half a minute. */
enum { QUICK_WORK = 200000000 };

static const Observable observables[CRANK_OBSERVABLES] = {
    [CRANK_REGULAR] = {"regular", "1", "periodic (1) or not within the revolutions seen (0)"},
    [CRANK_PERIOD] = {"period", "1", "period in revolutions, 0 for none"},
    [CRANK_PEAK_MIN] = {"peak_min", "N", "smallest peak force"},
    [CRANK_PEAK_MAX] = {"peak_max", "N", "largest peak force"},
    [CRANK_PEAK_MEAN] = {"peak_mean", "N", "mean peak force"},
    [CRANK_TOUCHES] = {"touches", "1", "touches a revolution"},
    [CRANK_CLEARANCE_RATIO] = {"clearance_ratio", "1", "clearance by the crank's radius, c/r"},
    [CRANK_MOTION] = {"motion", "1", "kind of motion"},
    [CRANK_LYAPUNOV] = {"lyapunov", "1", "largest exponent a revolution"},
    [CRANK_LYAPUNOV_ERROR] = {"lyapunov_error", "1", "standard error of the largest exponent"},
    [CRANK_ZERO_ONE] = {"zero_one", "1", "K of the 0-1 test"},
    [CRANK_ROTATION] = {"rotation", "1", "rotation number of a quasi-periodic motion"},
    [CRANK_HALF_LIFE] = {"half_life", "1", "half-life of a transient in revolutions"},
    [CRANK_ATTRACTOR_PEAK] = {"attractor_peak", "N", "largest force on the orbit where it settles"},
};

static const Observable series = {"peak", "N", "peak force of each revolution"};

const char *const crank_experiment_window[CRANK_EXPERIMENT_WINDOW] = {"drive.frequency", "joint.clearance",
                                                                      "coupler.length", "slider.mass"};

typedef struct Given {
    Crank crank;
    bool owned; /* the crank's texts */
    bool thorough;
    size_t lanes, lane_cycles; /* that are watched in thorough trials */
} Given;

/* Parameters ------------------------------------------------------------------------------------------------------- */

static const Parameter *find_parameter(const void *given, const char *name) {
    (void)given;
    const Parameter *row = parameters_find(crank_table(), name);
    return row && (row->kind == PARAMETER_NUMBER || row->kind == PARAMETER_WHOLE) ? row : NULL;
}

static void tell_unknown(const void *given, const char *name, const char *place, Fault *fault) {
    (void)given;
    JsonFile file = {.path = place, .root = json_null()};
    JsonNode node = json_root(&file);
    const Parameter *row = parameters_find(crank_table(), name);
    if (row)
        fault_add(fault, "%s%s is not a number: %s", place, row->name, row->meaning);
    else
        parameters_fault_unknown(crank_table(), name, &node, fault);
}

static double nominal(const void *given, const char *name) {
    const Parameter *row = find_parameter(given, name);
    return row ? parameters_number_get(row, &((const Given *)given)->crank) : 0;
}

/* Trials ----------------------------------------------------------------------------------------------------------- */

/* Draws where the ball and the slider begin: uniform in a sphere, by trying points of the cube around it. */
static void draw_start(Crank *crank, uint64_t seed) {
    Random random = random_seed(seed, 0);
    double at[3], square;
    do {
        square = 0;
        for (size_t i = 0; i < 3; i++) {
            at[i] = 2 * random_uniform(&random) - 1;
            square += at[i] * at[i];
        }
    } while (square > 1);
    crank->start_along = START_WITHIN * crank->clearance * at[0];
    crank->start_across = START_WITHIN * crank->clearance * at[1];
    crank->start_up = START_WITHIN * crank->clearance * at[2];
    crank->start_velocity = (2 * random_uniform(&random) - 1) * crank->clearance * 2 * M_PI * crank->frequency;
}

/* Sets the trial's values in the nominal crank, whose texts it shares. False: the trial has the reason. */
static bool make_crank(const Given *given, const char *const *names, size_t name_count, Trial *trial, Crank *crank) {
    Fault fault = {0};
    Arena none = {0}; /* numbers need no memory */
    *crank = given->crank;
    for (size_t i = 0; i < name_count; i++) {
        const Parameter *row = find_parameter(given, names[i]);
        JsonFile file = {.path = "", .root = json_number(trial->at[i])};
        JsonNode node = json_root(&file);
        if (row)
            parameters_read_value(row, crank, &node, &none, &fault);
        else
            fault_add(&fault, "%s is not a numeric parameter of a crank", names[i]);
        json_decref(file.root);
    }
    if (!fault.total)
        crank_check(crank, given->crank.name, &fault);
    if (fault.total) {
        trial->fault = text_copy(fault.lines[0]);
        trial->done = true;
        fault_clear(&fault);
        return false;
    }
    if (trial->seed)
        draw_start(crank, trial->seed);
    return true;
}

static void list_peaks(Trial *trial, const double *peak, size_t stride, size_t count) {
    trial->series = memory_zeroed(count + 1, sizeof *trial->series);
    double sum = 0, smallest = HUGE_VAL, largest = 0;
    for (size_t i = 0; i < count; i++) {
        double force = peak[i * stride];
        trial->series[trial->series_count++] = force;
        sum += force;
        smallest = real_min(smallest, force);
        largest = real_max(largest, force);
    }
    trial->observed[CRANK_PEAK_MIN] = count ? smallest : (double)NAN;
    trial->observed[CRANK_PEAK_MAX] = count ? largest : (double)NAN;
    trial->observed[CRANK_PEAK_MEAN] = count ? sum / (double)count : (double)NAN;
}

static void tell_regular(Trial *trial, bool regular, size_t period) {
    trial->observed[CRANK_REGULAR] = regular;
    trial->observed[CRANK_PERIOD] = (double)period;
}

/* Records of a quick trial: one number a revolution each. */
typedef struct Record {
    size_t count;
    double *along, *rate, *peak; /* (count) m, m/s, N */
} Record;

static void note(Record *record, Turn *turn) {
    double tip[2];
    crank_cycle_tip(turn, tip);
    record->along[record->count] = tip[0];
    record->rate[record->count] = tip[1];
    record->peak[record->count++] = turn->peak[0];
    turn->peak[0] = 0;
}

static void tell_record(Trial *trial, const Crank *crank, const Record *record, bool touches) {
    int period = section_period(record->along, record->rate, record->count, 2 * M_PI * crank->frequency,
                                CRANK_REST * crank->clearance);
    trial->observed[CRANK_MOTION] = motion_class_of_record(CYCLE_GOOD, period, touches);
    if (period != SECTION_UNDECIDED)
        tell_regular(trial, period != SECTION_NONE, (size_t)period);
}

/* Returns how many evaluations a quick trial may take: more than its revolutions usually do. */
static size_t quick_work(const Crank *crank) {
    size_t usual = CRANK_DEAR * ((size_t)crank->transient_cycles + (size_t)crank->cycles);
    return usual > QUICK_WORK ? usual : QUICK_WORK;
}

static void run_quickly(Trial *trial, const Crank *crank, const Tree *tree, CrankCarry *carry, const Stop *stop) {
    size_t cycles = (size_t)crank->cycles;
    double *room = memory_zeroed(3 * cycles, sizeof *room);
    Record record = {0, room, room + cycles, room + 2 * cycles};
    Turn turn = turn_create(tree, TURN_QUICK);
    turn.stop = stop;
    turn.evaluations_most = quick_work(crank);
    if (carry && carry->states == 2 * tree->coordinates)
        crank_cycle_set_state(&turn, carry->state);
    turn.unwatched = true;
    for (int i = 0; i < crank->transient_cycles && turn.status == CYCLE_GOOD && !stop_requested(stop); i++)
        turn_cycle(&turn);
    turn.unwatched = false;
    size_t before = turn.touches, touches = before; /* until the end of the last whole revolution */
    while (record.count < cycles && !stop_requested(stop) && turn_cycle(&turn) == CYCLE_GOOD) {
        note(&record, &turn);
        touches = turn.touches;
    }
    list_peaks(trial, record.peak, 1, record.count);
    if (record.count)
        trial->observed[CRANK_TOUCHES] = (double)(touches - before) / (double)record.count;
    bool fails = turn.status != CYCLE_GOOD && turn.status != CYCLE_INTERRUPTED;
    trial->done = record.count == cycles || fails;
    if (fails)
        trial->observed[CRANK_MOTION] = motion_class_of_record(turn.status, SECTION_UNDECIDED, true);
    else if (record.count == cycles)
        tell_record(trial, crank, &record, trial->observed[CRANK_PEAK_MAX] > 0);
    if (carry) {
        carry->states = turn.status == CYCLE_GOOD ? 2 * tree->coordinates : 0;
        crank_cycle_state(&turn, carry->state);
    }
    memory_free(room);
}

static void tell_response(Trial *trial, const Response *response) {
    double *observed = trial->observed;
    list_peaks(trial, response->section.peak, CYCLE_SIDES, response->section.count);
    size_t period = motion_class_attractor(response, &observed[CRANK_ATTRACTOR_PEAK]);
    if (response_is_told(response->verdict))
        tell_regular(trial, motion_class_is_regular(response), period);
    observed[CRANK_MOTION] = motion_class_of(response);
    observed[CRANK_ROTATION] = response->rotation.value;
    if (response->verdict == RESPONSE_TRANSIENT)
        observed[CRANK_HALF_LIFE] = motion_class_life(response);
    observed[CRANK_LYAPUNOV] = response->exponent.value;
    observed[CRANK_LYAPUNOV_ERROR] = response->exponent.error;
    observed[CRANK_ZERO_ONE] = response->zero_one;
}

static void run_thoroughly(const Given *given, Trial *trial, const Crank *crank, const Tree *tree, CrankCarry *carry,
                           const Stop *stop) {
    Response response;
    bool carried = carry && carry->states == 2 * tree->coordinates;
    response_run(&response, crank_cycle_of(tree), crank->transient_cycles, crank->cycles, carried ? carry->state : NULL,
                 stop);
    response_confirm(&response, crank_cycle_of(tree), &(SurvivalTask){given->lanes, given->lane_cycles, 1, stop});
    tell_response(trial, &response);
    trial->done = response.verdict != RESPONSE_INTERRUPTED && !(given->lanes && response_is_quick(&response));
    if (carry && response.section.count) {
        carry->states = response.section.states;
        memcpy(carry->state, section_last(&response.section), carry->states * sizeof(double));
    }
    response_clear(&response);
}

static void run_trials(const Given *given, const char *const *names, size_t name_count, Trial *trials, size_t count,
                       CrankCarry *carry, const Stop *stop) {
    for (size_t i = 0; i < count && !stop_requested(stop); i++) {
        Crank crank;
        for (size_t k = 0; k < CRANK_OBSERVABLES; k++)
            trials[i].observed[k] = NAN;
        if (!make_crank(given, names, name_count, &trials[i], &crank))
            continue;
        Tree tree = tree_of(&crank);
        trials[i].observed[CRANK_CLEARANCE_RATIO] = crank.clearance / crank.radius;
        if (given->thorough)
            run_thoroughly(given, &trials[i], &crank, &tree, carry, stop);
        else
            run_quickly(&trials[i], &crank, &tree, carry, stop);
    }
}

static void run(const void *context, const char *const *names, size_t name_count, Trial *trials, size_t count,
                bool carry, const Stop *stop) {
    CrankCarry carried = {0};
    run_trials(context, names, name_count, trials, count, carry ? &carried : NULL, stop);
}

void crank_experiment_run_on(const Experiment *experiment, const char *name, Trial *trials, size_t count,
                             CrankCarry *carry, const Stop *stop) {
    run_trials(experiment->given, &name, 1, trials, count, carry, stop);
}

/* Opening ---------------------------------------------------------------------------------------------------------- */

static void begin(Experiment *experiment, Given *given) {
    *experiment = (Experiment){.kind = "crank",
                               .observables = observables,
                               .observable_count = CRANK_OBSERVABLES,
                               .series = &series,
                               .regular = CRANK_REGULAR,
                               .outcome = CRANK_PERIOD,
                               .periods = true,
                               .measure = CRANK_PEAK_MAX,
                               .verdict = CRANK_MOTION,
                               .verdicts = motion_class_names,
                               .verdict_count = MOTION_CLASSES,
                               .verdict_quick = MOTION_CLASS_NOT_PERIODIC,
                               .turning = "drive.frequency",
                               .cycle = "revolution",
                               .carries = true,
                               .batch = 1,
                               .given = given,
                               .parameter = find_parameter,
                               .unknown = tell_unknown,
                               .nominal = nominal,
                               .run = run};
}

bool crank_experiment_open(Experiment *experiment, const char *path, const char *const *settings, size_t setting_count,
                           Fault *fault) {
    Given *given = memory_zeroed(1, sizeof *given);
    if (!crank_read(&given->crank, path, settings, setting_count, fault)) {
        memory_free(given);
        return false;
    }
    given->owned = true;
    begin(experiment, given);
    return true;
}

void crank_experiment_of(Experiment *experiment, const Crank *crank) {
    Given *given = memory_zeroed(1, sizeof *given);
    given->crank = *crank;
    begin(experiment, given);
}

void crank_experiment_be_thorough(Experiment *experiment, size_t lanes, size_t cycles) {
    Given *given = experiment->given;
    given->thorough = true;
    given->lanes = lanes;
    given->lane_cycles = cycles;
    experiment->identity = digest_chain(digest_chain(digest_chain(experiment->identity, 1), lanes), cycles);
}

void crank_experiment_close(Experiment *experiment) {
    Given *given = experiment->given;
    if (given->owned)
        crank_free(&given->crank);
    memory_free(given);
    *experiment = (Experiment){0};
}
