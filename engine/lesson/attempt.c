#include "lesson/attempt.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/parallel.h"
#include "house/run.h"
#include "lesson/difference.h"
#include "lesson/names.h"

enum { OBSERVABLES_MOST = 64 };

/* Values ----------------------------------------------------------------------------------------------------------- */

/* The settings of a state with more added. */
typedef struct Settings {
    const char *at[LESSON_SETTINGS_MOST];
    size_t count;
    Arena arena;
} Settings;

/* Adds settings; an earlier one of the same name counts no more. */
static void add_settings(Settings *settings, const char *const *more, size_t count) {
    for (size_t i = 0; i < count; i++) {
        size_t length = strcspn(more[i], "="), kept = 0;
        for (size_t s = 0; s < settings->count; s++)
            if (strncmp(settings->at[s], more[i], length + 1) != 0)
                settings->at[kept++] = settings->at[s];
        settings->count = kept;
        if (settings->count < LESSON_SETTINGS_MOST)
            settings->at[settings->count++] = more[i];
    }
}

static void add_set(Settings *settings, const char *set) {
    const char *more[LESSON_SETTINGS_MOST];
    size_t count = lesson_add_settings(set, more, 0, &settings->arena);
    add_settings(settings, more, count);
}

static Settings settings_of(const Lesson *lesson, const AttemptState *state, const char *set, const char *than) {
    Settings settings = {.count = 0};
    add_set(&settings, lesson->set);
    add_settings(&settings, state->settings, state->setting_count);
    add_set(&settings, set);
    add_set(&settings, than);
    return settings;
}

/* True if both hold the same settings, in any order: no name occurs twice in either. */
static bool are_same(const Settings *a, const Settings *b) {
    for (size_t i = 0; i < a->count; i++) {
        size_t other = 0;
        while (other < b->count && strcmp(a->at[i], b->at[other]) != 0)
            other++;
        if (other == b->count)
            return false;
    }
    return a->count == b->count;
}

/* What was run of one set of settings; each part only once something needs it. */
typedef struct Shown {
    const Lesson *lesson;
    const AttemptState *state;
    Settings settings;
    House house;
    Observation observation;
    bool read, ran, shaken;
    double shakes_out; /* earthquakes after which all are out */
    double observed[OBSERVABLES_MOST];
    Experiment experiment;
} Shown;

static bool read_house(House *house, const Shown *shown, uint64_t shake, Fault *fault) {
    HouseOptions options = {.profiles = shown->state->profiles,
                            .settings = shown->settings.at,
                            .setting_count = shown->settings.count,
                            .seed = shake ? shake : 1,
                            .driving = -1,
                            .shake = shake > 0};
    const char *text = shown->state->text, *file = shown->lesson->file;
    return text ? house_read_text(house, file, text, &options, fault) : house_read(house, file, &options, fault);
}

static bool is_stopped(const Shown *shown) {
    return stop_requested(shown->state->stop);
}

static bool run_shown(Shown *shown, Fault *fault) {
    if (shown->ran)
        return true;
    if (!shown->read && !read_house(&shown->house, shown, 0, fault))
        return false;
    shown->read = true;
    RunOptions options = {.route = SIZE_MAX, .jobs = shown->state->jobs, .stop = shown->state->stop};
    run_house(&shown->observation, &shown->house, &options);
    shown->ran = true;
    return !shown->observation.interrupted;
}

/* One earthquake for each seed. */
typedef struct Shakes {
    const Shown *shown;
    bool out[ATTEMPT_SHAKES], failed[ATTEMPT_SHAKES];
} Shakes;

static void run_shake(void *context, size_t index) {
    Shakes *shakes = context;
    House house = {0};
    Fault fault = {0};
    Observation observation;
    shakes->failed[index] =
        is_stopped(shakes->shown) || !read_house(&house, shakes->shown, (uint64_t)index + 1, &fault);
    fault_clear(&fault);
    if (shakes->failed[index])
        return;
    RunOptions options = {.route = SIZE_MAX, .jobs = 1, .stop = shakes->shown->state->stop};
    run_house(&observation, &house, &options);
    shakes->failed[index] = observation.interrupted;
    shakes->out[index] = observation.completed;
    observation_free(&observation);
    house_free(&house);
}

static bool shake_shown(Shown *shown, Fault *fault) {
    if (shown->shaken)
        return true;
    if (!shown->read && !read_house(&shown->house, shown, 0, fault))
        return false;
    shown->read = true;
    Shakes shakes = {.shown = shown};
    parallel_for(shown->state->jobs, ATTEMPT_SHAKES, run_shake, &shakes);
    for (size_t i = 0; i < ATTEMPT_SHAKES; i++) {
        if (shakes.failed[i])
            return false;
        shown->shakes_out += shakes.out[i];
    }
    return shown->shaken = true;
}

static double parameter_value(const Parameter *row, const void *object) {
    const char *field = (const char *)object + row->offset;
    return row->kind == PARAMETER_WHOLE ? *(const int *)field : *(const double *)field;
}

static bool house_value(double *value, Shown *shown, Condition *condition, Fault *fault) {
    const char *name = condition->measure_name;
    if (strcmp(name, NAMES_SHAKES_OUT) == 0) {
        bool good = shake_shown(shown, fault);
        *value = shown->shakes_out;
        return good;
    }
    if (condition->measure) {
        MeasureAnswer answer = {0};
        if (!run_shown(shown, fault))
            return false;
        condition->measure->take(&answer, &shown->house, &shown->observation, &condition->question);
        memcpy(condition->note, answer.note, sizeof condition->note);
        *value = answer.value;
        return true;
    }
    if (!shown->read && !read_house(&shown->house, shown, 0, fault))
        return false;
    shown->read = true;
    if (difference_unit(name)) {
        const AttemptState begin = {.text = NULL};
        Settings settings = settings_of(shown->lesson, &begin, "", "");
        Plan before = {0};
        bool good = plan_read(&before, shown->lesson->file, settings.at, settings.count, fault);
        *value = good ? difference_value(name, &before, &shown->house.plan) : 0;
        plan_free(&before);
        arena_clear(&settings.arena);
        return good;
    }
    const void *object;
    const Parameter *row = plan_parameter(&shown->house.plan, name, &object, "", fault);
    *value = row ? parameter_value(row, object) : (double)NAN;
    return row;
}

static bool machine_value(double *value, Shown *shown, const Condition *condition, Fault *fault) {
    if (!shown->read &&
        !names_open_experiment(&shown->experiment, shown->lesson, shown->settings.at, shown->settings.count, fault))
        return false;
    shown->read = true;
    const Experiment *experiment = &shown->experiment;
    size_t o = names_find_observable(experiment, condition->measure_name);
    if (o == experiment->observable_count) {
        *value = experiment->nominal(experiment->given, condition->measure_name);
        return true;
    }
    if (!shown->ran) {
        Trial trial = {.at = NULL, .seed = 0, .observed = shown->observed};
        experiment->run(experiment->given, NULL, 0, &trial, 1, false, shown->state->stop);
        if (trial.fault)
            fault_add(fault, "%s", trial.fault);
        bool good = trial.done && !trial.fault;
        trial_clear(&trial);
        if (!good)
            return false;
        shown->ran = true;
    }
    *value = shown->observed[o];
    return true;
}

static bool value_of(double *value, Shown *shown, Condition *condition, Fault *fault) {
    *value = 0;
    return shown->lesson->laboratory == LESSON_HOUSE ? house_value(value, shown, condition, fault)
                                                     : machine_value(value, shown, condition, fault);
}

static void shown_end(Shown *shown) {
    if (shown->lesson->laboratory != LESSON_HOUSE) {
        if (shown->read)
            names_close_experiment(&shown->experiment, shown->lesson);
    } else {
        if (shown->ran)
            observation_free(&shown->observation);
        house_free(&shown->house);
    }
    arena_clear(&shown->settings.arena);
    memory_free(shown);
}

/* Runs of different settings, so that equal settings run once. */
typedef struct Runs {
    const Lesson *lesson;
    const AttemptState *state;
    Shown **at; /* (count) */
    size_t count, capacity;
} Runs;

static Shown *runs_find(Runs *runs, const char *set, const char *than) {
    Settings settings = settings_of(runs->lesson, runs->state, set, than);
    for (size_t i = 0; i < runs->count; i++)
        if (are_same(&runs->at[i]->settings, &settings)) {
            arena_clear(&settings.arena);
            return runs->at[i];
        }
    Shown *shown = memory_zeroed(1, sizeof *shown);
    *shown = (Shown){.lesson = runs->lesson, .state = runs->state, .settings = settings};
    runs->at = memory_reserve(runs->at, &runs->capacity, runs->count + 1, sizeof *runs->at);
    return runs->at[runs->count++] = shown;
}

static void runs_clear(Runs *runs) {
    for (size_t i = 0; i < runs->count; i++)
        shown_end(runs->at[i]);
    memory_free(runs->at);
}

/* Takes the value of a condition with the settings `set`; with `than`, divided by that with these settings, too. */
static bool take_value(double *value, Runs *runs, const char *set, const char *than, Condition *condition,
                       Fault *fault) {
    *condition->note = 0;
    if (!value_of(value, runs_find(runs, set, ""), condition, fault))
        return false;
    if (!*than)
        return true;
    double divisor = 0;
    char note[sizeof condition->note];
    memcpy(note, condition->note, sizeof note);
    bool good = value_of(&divisor, runs_find(runs, set, than), condition, fault);
    memcpy(condition->note, *note ? note : condition->note, sizeof note);
    *value /= divisor;
    return good;
}

bool attempt_goal(const Lesson *lesson, LessonStep *step, const AttemptState *state, Fault *fault) {
    Runs runs = {.lesson = lesson, .state = state};
    double values[LESSON_OPTIONS_MOST];
    bool good = true;
    for (size_t g = 0; g < step->goal_count && good; g++)
        if (person_has(step->goals[g].condition.measure_name))
            values[g] = person_value(&step->goals[g], &state->person);
        else
            good = take_value(&values[g], &runs, "", step->goals[g].than, &step->goals[g].condition, fault);
    runs_clear(&runs);
    for (size_t g = 0; g < step->goal_count && good; g++)
        condition_judge(&step->goals[g].condition, values[g]);
    return good;
}

bool attempt_numbers(Lesson *lesson, const AttemptState *state, Fault *fault) {
    Runs runs = {.lesson = lesson, .state = state};
    bool good = true;
    for (size_t n = 0; n < lesson->number_count && good; n++) {
        LessonNumber *number = &lesson->numbers[n];
        double value;
        good = take_value(&value, &runs, number->set, number->than, &number->condition, fault);
        if (good)
            condition_judge(&number->condition, value);
        if (good && state->note)
            state->note(state->context, n + 1);
    }
    runs_clear(&runs);
    return good;
}
