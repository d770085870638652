#include "experiment/house_experiment.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/digest.h"
#include "base/stop.h"
#include "base/parameters_number.h"
#include "base/text.h"
#include "experiment/drivers.h"
#include "experiment/grade_record.h"
#include "house/run.h"
#include "inquiry/grade.h"
#include "experiment/shake_record.h"

typedef struct HouseGiven {
    const char *path;
    const char *text; /* of the house file, or NULL: it is read from `path` */
    HouseOptions options;
    const char *route;
    House house; /* with nominal values, before any shake */
    ShakeRecord shake;
    LocusRecord locus;
    GradeRecord *grades;   /* NULL: nothing is graded */
    Population population; /* without rows: nobody is drawn */
    Arena arena;           /* holds the descriptions of more observables */
} HouseGiven;

static bool read_given(House *house, const HouseGiven *given, const HouseOptions *options, Fault *fault) {
    return given->text ? house_read_text(house, given->path, given->text, options, fault)
                       : house_read(house, given->path, options, fault);
}

static const Observable observables[HOUSE_OBSERVABLES] = {
    [HOUSE_COMPLETED] = {"completed", "1", "all people are out"},
    [HOUSE_TIME] = {"time", "s", "time until all people are out"},
    [HOUSE_NARROWEST] = {"narrowest", "m", "least clearance of a body"},
    [HOUSE_PEAK_FORCE] = {"peak_force", "N", "hardest contact of a body"},
    [HOUSE_CONTACTS] = {"contacts", "1", "contacts of bodies"},
    [HOUSE_RING_TIME] = {"ring_time", "s", "time with the personal space pressed, of all together"},
    [HOUSE_LOST_TIME] = {"lost_time", "s", "time lost against the free speed, of all together"},
    [HOUSE_NOT_OUT] = {"not_out", "1", "people who are not out"},
    [HOUSE_WAY] = {"way", "1", "way taken: another number is other exits or changes of direction"},
};

/* Names ---------------------------------------------------------------------------------------------------------- */

static const Parameter *find_number(const House *house, const char *name, const void **object, const char *place,
                                    Fault *fault) {
    const Parameter *row = house_parameter(house, name, object, place, fault);
    bool number = row && (row->kind == PARAMETER_NUMBER || row->kind == PARAMETER_WHOLE);
    if (row && row->kind == PARAMETER_POINT)
        fault_add(fault, "%s%s is a point, must be %s.x or %s.y", place, row->name, row->name, row->name);
    else if (row && !number)
        fault_add(fault, "%s%s is not a number", place, row->name);
    return number ? row : NULL;
}

static const Parameter *find_parameter(const void *given, const char *name) {
    Fault fault = {0};
    const void *object;
    const Parameter *row = find_number(&((const HouseGiven *)given)->house, name, &object, "", &fault);
    fault_clear(&fault);
    return row;
}

static void tell_unknown(const void *given, const char *name, const char *place, Fault *fault) {
    const void *object;
    find_number(&((const HouseGiven *)given)->house, name, &object, place, fault);
}

static double nominal(const void *given, const char *name) {
    Fault fault = {0};
    const void *object;
    const Parameter *row = find_number(&((const HouseGiven *)given)->house, name, &object, "", &fault);
    fault_clear(&fault);
    return row ? parameters_number_get(row, object) : (double)NAN;
}

/* Runs ----------------------------------------------------------------------------------------------------------- */

/* Combines the exits and changes of direction of the plan's own people; members of a crowd take different paths each
 * time. The value is exact in a double. */
static double way_of(const House *house, const Observation *observation) {
    uint64_t digest = DIGEST_START;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        if (!person->took_part || plan_find_person(&house->plan, house->people[i].id) == SIZE_MAX)
            continue;
        digest = digest_mix(digest_mix(digest, (double)person->exit), person->reversals);
    }
    return (double)(digest % 1000000);
}

static void observe(Trial *trial, const HouseGiven *given, const House *house, const Observation *observation) {
    double *observed = trial->observed;
    if (given->options.shake)
        shake_record_observe(&given->shake, &given->house.plan, house, observation, observed);
    for (size_t o = 0; o < HOUSE_OBSERVABLES; o++)
        observed[o] = 0;
    observed[HOUSE_COMPLETED] = observation->completed;
    observed[HOUSE_TIME] = observation->completed ? observation->time : (double)NAN;
    observed[HOUSE_NARROWEST] = HUGE_VAL;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        if (!person->took_part)
            continue;
        observed[HOUSE_NARROWEST] = fmin(observed[HOUSE_NARROWEST], person->narrowest);
        observed[HOUSE_PEAK_FORCE] = fmax(observed[HOUSE_PEAK_FORCE], person->peak_force);
        observed[HOUSE_CONTACTS] += person->contacts;
        observed[HOUSE_RING_TIME] += person->ring_time;
        observed[HOUSE_LOST_TIME] += person->lost_time;
        observed[HOUSE_NOT_OUT] += !person->completed;
    }
    if (!observation->completed)
        observed[HOUSE_LOST_TIME] = NAN;
    if (observed[HOUSE_NARROWEST] == HUGE_VAL)
        observed[HOUSE_NARROWEST] = NAN;
    observed[HOUSE_WAY] = way_of(house, observation);
    if (given->locus.count)
        locus_record_observe(&given->locus, house, observation, observed);
}

/* Joins the options' settings and a NAME=VALUE for each varied name; the caller releases both with memory_free. */
static char *join_settings(const HouseOptions *options, const char **settings, const char *const *names,
                           size_t name_count, const double *at) {
    enum { NUMBER = 32 /* characters of "=" and a number with all digits */ };
    size_t room = 1;
    for (size_t n = 0; n < name_count; n++)
        room += strlen(names[n]) + NUMBER;
    char *texts = memory_zeroed(room, 1), *end = texts;
    for (size_t i = 0; i < options->setting_count; i++)
        settings[i] = options->settings[i];
    for (size_t n = 0; n < name_count; n++) {
        settings[options->setting_count + n] = end;
        end += sprintf(end, "%s=%.17g", names[n], at[n]) + 1;
    }
    return texts;
}

static void run_one(const HouseGiven *given, const char *const *names, size_t name_count, Trial *trial,
                    const Stop *stop) {
    const char **settings = memory_zeroed(given->options.setting_count + name_count, sizeof *settings);
    char *texts = join_settings(&given->options, settings, names, name_count, trial->at);
    HouseOptions options = given->options;
    options.settings = settings;
    options.setting_count += name_count;
    bool drawn = given->population.count > 0;
    options.seed = trial->seed && !drawn ? trial->seed : options.seed;
    size_t driver = trial->seed > options.seed ? (size_t)(trial->seed - options.seed) + 1 : 1;
    House house = {0};
    Fault fault = {0};
    if (read_given(&house, given, &options, &fault)) {
        size_t route = given->route ? plan_find_route(&house.plan, given->route) : SIZE_MAX;
        Observation observation;
        if (drawn)
            drivers_run_one(&observation, &house, &given->population, driver, route, stop);
        else
            run_house(&observation, &house,
                      &(RunOptions){.route = route, .brief = !given->locus.count, .jobs = 1, .stop = stop});
        trial->done = !observation.interrupted;
        if (trial->done)
            observe(trial, given, &house, &observation);
        if (trial->done && given->grades)
            trial->done = grade_record_observe(given->grades, &house, &observation, names, name_count, trial, stop);
        observation_free(&observation);
        house_free(&house);
    } else {
        trial->fault = text_copy(fault.lines[0]);
        trial->done = true;
    }
    fault_clear(&fault);
    memory_free(texts);
    memory_free(settings);
}

static void run(const void *given, const char *const *names, size_t name_count, Trial *trials, size_t count, bool carry,
                const Stop *stop) {
    (void)carry; /* all people begin at their start */
    for (size_t i = 0; i < count && !stop_requested(stop); i++)
        run_one(given, names, name_count, &trials[i], stop);
}

/* Opening -------------------------------------------------------------------------------------------------------- */

/* Returns the digest of inputs outside the house file. */
static uint64_t identity_of(const HouseGiven *given) {
    uint64_t digest = digest_mix(DIGEST_START, (double)given->options.seed);
    digest = digest_text(digest, given->route ? given->route : "");
    digest = digest_text(digest, given->options.shake ? "shake" : "");
    for (size_t p = 0; p < given->house.profile_count; p++) {
        const Profile *profile = &given->house.profiles[p];
        digest = digest_mix(digest_text(digest, profile->name), profile->driving);
        for (size_t r = 0; r < profile_table()->count; r++)
            digest = digest_mix(digest, *(const double *)((const char *)profile + profile_table()->rows[r].offset));
    }
    return digest;
}

static bool find_route(const HouseGiven *given, Fault *fault) {
    const Plan *plan = &given->house.plan;
    if (!given->route || plan_find_route(plan, given->route) != SIZE_MAX)
        return true;
    if (!plan->route_count) {
        fault_add(fault, "%s has no route \"%s\", since it has no routes", given->path, given->route);
        return false;
    }
    char known[300] = "";
    for (size_t r = 0, used = 0; r < plan->route_count && used < sizeof known; r++)
        used += (size_t)snprintf(known + used, sizeof known - used, "%s%s", r ? ", " : "", plan->routes[r].id);
    fault_add(fault, "%s has no route \"%s\", its routes are %s", given->path, given->route, known);
    return false;
}

/* Makes each trial a shake, with more observables. */
static void observe_shakes(Experiment *experiment, HouseGiven *given) {
    const Plan *plan = &given->house.plan;
    given->shake = shake_record_of(plan, HOUSE_OBSERVABLES);
    Observable *all = arena_allocate(&given->arena, given->shake.count * sizeof *all);
    memcpy(all, observables, sizeof observables);
    shake_record_describe(&given->shake, plan, all, &given->arena);
    experiment->observables = all;
    experiment->observable_count = given->shake.count;
}

bool house_experiment_open(Experiment *experiment, const char *path, const HouseOptions *options, const char *route,
                           Fault *fault) {
    return house_experiment_open_text(experiment, path, NULL, options, route, fault);
}

bool house_experiment_open_text(Experiment *experiment, const char *path, const char *text, const HouseOptions *options,
                                const char *route, Fault *fault) {
    HouseGiven *given = memory_zeroed(1, sizeof *given);
    given->path = path;
    given->text = text;
    given->options = *options;
    given->route = route;
    HouseOptions before = *options;
    before.shake = false;
    if (!read_given(&given->house, given, &before, fault) || !find_route(given, fault)) {
        house_free(&given->house);
        memory_free(given);
        return false;
    }
    *experiment = (Experiment){.kind = "house",
                               .observables = observables,
                               .observable_count = HOUSE_OBSERVABLES,
                               .regular = HOUSE_COMPLETED,
                               .outcome = HOUSE_WAY,
                               .measure = HOUSE_TIME,
                               .batch = 1,
                               .given = given,
                               .identity = identity_of(given),
                               .parameter = find_parameter,
                               .unknown = tell_unknown,
                               .nominal = nominal,
                               .run = run};
    if (options->shake)
        observe_shakes(experiment, given);
    return true;
}

void house_experiment_drive(Experiment *experiment, Population *population) {
    HouseGiven *given = experiment->given;
    uint64_t digest = digest_mix(digest_text(experiment->identity, population->profile), population->correlation);
    for (size_t r = 0; r < population->count; r++) {
        const PopulationRow *row = &population->rows[r];
        digest = digest_text(digest_text(digest_text(digest, row->name), row->level), row->group ? row->group : "");
        digest = digest_mix(digest_mix(digest, row->middle), row->spread);
        digest = digest_mix(digest_mix(digest_mix(digest, row->law), row->low), row->high);
    }
    experiment->identity = digest;
    experiment->chance = "drivers";
    given->population = *population;
    *population = (Population){0};
}

const LocusRecord *house_experiment_follow(Experiment *experiment, const Locus *measured, size_t person) {
    HouseGiven *given = experiment->given;
    given->locus = locus_record_of(measured, person, HOUSE_OBSERVABLES, &given->arena);
    const LocusRecord *record = &given->locus;
    experiment->observable_count = HOUSE_OBSERVABLES + 2 * record->count;
    Observable *all = arena_allocate(&given->arena, experiment->observable_count * sizeof *all);
    memcpy(all, observables, sizeof observables);
    locus_record_describe(record, all, &given->arena);
    experiment->observables = all;
    for (size_t k = 0; k < record->count; k++) {
        experiment->identity = digest_mix(digest_mix(experiment->identity, record->at[k].x), record->at[k].y);
        experiment->identity = digest_mix(experiment->identity, record->speed[k]);
    }
    return record;
}

void house_experiment_grade(Experiment *experiment, size_t few) {
    HouseGiven *given = experiment->given;
    given->grades = grade_record_create(few, HOUSE_OBSERVABLES);
    Observable *all = arena_allocate(&given->arena, (HOUSE_OBSERVABLES + 1) * sizeof *all);
    memcpy(all, observables, sizeof observables);
    all[HOUSE_OBSERVABLES] = grade_record_describe();
    experiment->observables = all;
    experiment->observable_count = HOUSE_OBSERVABLES + 1;
    experiment->rank = HOUSE_OBSERVABLES;
    experiment->ranks = grade_letters();
    experiment->rank_count = GRADES;
    experiment->note = "grade_place";
}

const House *house_experiment_house(const Experiment *experiment) {
    return &((const HouseGiven *)experiment->given)->house;
}

const ShakeRecord *house_experiment_shake(const Experiment *experiment) {
    return &((const HouseGiven *)experiment->given)->shake;
}

void house_experiment_close(Experiment *experiment) {
    HouseGiven *given = experiment->given;
    if (given) {
        house_free(&given->house);
        population_free(&given->population);
        grade_record_free(given->grades);
        arena_clear(&given->arena);
        memory_free(given);
    }
    *experiment = (Experiment){0};
}
