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

static Settings settings_of(const Lesson *lesson, const AttemptState *state, const char *set, const char *than) {
    Settings settings = {.count = 0};
    settings.count = lesson_add_settings(lesson->set, settings.at, 0, &settings.arena);
    for (size_t i = 0; i < state->setting_count && settings.count < LESSON_SETTINGS_MOST; i++)
        settings.at[settings.count++] = state->settings[i];
    settings.count = lesson_add_settings(set, settings.at, settings.count, &settings.arena);
    settings.count = lesson_add_settings(than, settings.at, settings.count, &settings.arena);
    return settings;
}

/* What was run of one set of settings; each part only once something needs it. */
typedef struct Shown {
    const Lesson *lesson;
    const AttemptState *state;
    Settings settings;
    House house;
    Observation observation;
    bool read, ran, shaken;
    double share;
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
        shown->share += shakes.out[i] / (double)ATTEMPT_SHAKES;
    }
    return shown->shaken = true;
}

static double parameter_value(const Parameter *row, const void *object) {
    const char *field = (const char *)object + row->offset;
    return row->kind == PARAMETER_WHOLE ? *(const int *)field : *(const double *)field;
}

static bool house_value(double *value, Shown *shown, Condition *condition, Fault *fault) {
    const char *name = condition->measure_name;
    if (strcmp(name, NAMES_SHAKE_SHARE) == 0) {
        bool good = shake_shown(shown, fault);
        *value = shown->share;
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

static void shown_begin(Shown *shown, const Lesson *lesson, const AttemptState *state, const char *set,
                        const char *than) {
    *shown = (Shown){.lesson = lesson, .state = state, .settings = settings_of(lesson, state, set, than)};
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
}

/* Divides the value by that of the same measure with the settings `than`, if there are any. */
static bool compare(double *value, const Lesson *lesson, const AttemptState *state, const char *set, const char *than,
                    Condition *condition, Fault *fault) {
    if (!*than)
        return true;
    Shown other;
    double divisor = 0;
    char note[sizeof condition->note];
    memcpy(note, condition->note, sizeof note);
    shown_begin(&other, lesson, state, set, than);
    bool good = value_of(&divisor, &other, condition, fault);
    shown_end(&other);
    memcpy(condition->note, *note ? note : condition->note, sizeof note);
    *value /= divisor;
    return good;
}

bool attempt_goal(const Lesson *lesson, LessonStep *step, const AttemptState *state, Fault *fault) {
    Shown shown;
    double values[LESSON_OPTIONS_MOST];
    bool good = true;
    shown_begin(&shown, lesson, state, "", "");
    for (size_t g = 0; g < step->goal_count && good; g++) {
        Condition *condition = &step->goals[g].condition;
        *condition->note = 0;
        good = value_of(&values[g], &shown, condition, fault) &&
               compare(&values[g], lesson, state, "", step->goals[g].than, condition, fault);
    }
    shown_end(&shown);
    for (size_t g = 0; g < step->goal_count && good; g++)
        condition_judge(&step->goals[g].condition, values[g]);
    return good;
}

bool attempt_numbers(Lesson *lesson, const AttemptState *state, Fault *fault) {
    Shown shown;
    bool good = true, open = false;
    for (size_t n = 0; n < lesson->number_count && good; n++) {
        LessonNumber *number = &lesson->numbers[n];
        double value;
        bool same = open && strcmp(number->set, lesson->numbers[n - 1].set) == 0;
        if (open && !same)
            shown_end(&shown);
        if (!same)
            shown_begin(&shown, lesson, state, number->set, "");
        open = true;
        good = value_of(&value, &shown, &number->condition, fault) &&
               compare(&value, lesson, state, number->set, number->than, &number->condition, fault);
        if (good)
            condition_judge(&number->condition, value);
    }
    if (open)
        shown_end(&shown);
    return good;
}
