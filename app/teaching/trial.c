#include "teaching/trial.h"

#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "lesson/attempt.h"
#include "lesson/names.h"
#include "lesson/words.h"
#include "window/script.h"

/* The settings that a pupil has made, and how many there were when each step was left. */
typedef struct Tryout {
    Play *play;
    const TrialOptions *options;
    const char *settings[LESSON_SETTINGS_MOST];
    size_t count, left[LESSON_STEPS_MOST];
    const char *selected; /* name of the thing that is selected, or NULL */
    bool stale;           /* the goal is not judged for these settings and this selection yet */
    Arena arena;
} Tryout;

/* Adds the settings with which a step begins. */
static void begin_step(Tryout *trial) {
    const char *set = play_step(trial->play)->set;
    trial->count = lesson_add_settings(set, trial->settings, trial->count, &trial->arena);
    trial->stale = true;
}

static void press(Tryout *trial, const char *name) {
    Play *play = trial->play;
    size_t step = play->step;
    PlayKey key;
    int digit;
    if (play_read_key(name, &key, &digit))
        play_key(play, key, digit);
    if (strcmp(name, "Ctrl+Z") == 0 && trial->count) {
        trial->count--;
        trial->stale = true;
    }
    if (play->step > step) {
        trial->left[step] = trial->count;
        begin_step(trial);
    } else if (play->step < step) {
        trial->count = trial->left[play->step] < trial->count ? trial->left[play->step] : trial->count;
        trial->stale = true;
    }
}

static bool judge(Tryout *trial, Fault *fault) {
    Play *play = trial->play;
    LessonStep *step = &play->lesson.steps[play->step];
    if (!trial->stale || !step->goal_count)
        return true;
    AttemptState state = {.settings = trial->settings,
                          .setting_count = trial->count,
                          .profiles = trial->options->profiles,
                          .jobs = trial->options->jobs,
                          .stop = trial->options->stop,
                          .person = {.answer = play_answer(play), .selected = trial->selected}};
    if (!attempt_goal(&play->lesson, step, &state, fault))
        return false;
    play_judge(play);
    trial->stale = false;
    return true;
}

static void count_goal(TrialResult *result, const Play *play) {
    PlayGoal goal = play->steps[play->step].goal;
    for (size_t t = 0; t < result->task_count; t++)
        if (result->tasks[t].step == play->step) {
            result->tasks[t].no += goal == PLAY_GOAL_NO;
            result->tasks[t].yes += goal == PLAY_GOAL_YES;
        }
}

/* Says what each condition of the goal gave. */
static void say_goal(Tryout *trial, Fault *fault) {
    const LessonStep *step = play_step(trial->play);
    for (size_t g = 0; g < step->goal_count; g++) {
        const Condition *condition = &step->goals[g].condition;
        fault_add(fault, "    %s%s%s", words_goal(&step->goals[g], &trial->arena), *condition->note ? ": " : "",
                  condition->note);
    }
}

/* Compares what a script expects; false: a fault says what is so. */
static bool expect(Tryout *trial, TrialResult *result, const Script *script, const ScriptCommand *command,
                   Fault *fault) {
    if (strncmp(command->words[0], "lesson.", 7) != 0)
        return true;
    size_t before = fault->total;
    if (!judge(trial, fault)) {
        result->interrupted = fault->total == before;
        return false;
    }
    json_t *state = json_pack("{s:o}", "lesson", play_state(trial->play));
    bool good = script_expect(script, command, state, fault), of_goal = strcmp(command->words[0], "lesson.goal") == 0;
    json_decref(state);
    result->expected++;
    if (good && of_goal)
        count_goal(result, trial->play);
    else if (of_goal)
        say_goal(trial, fault);
    return good;
}

static bool follow(Tryout *trial, TrialResult *result, const Script *script, const ScriptCommand *command,
                   Fault *fault) {
    switch (command->kind) {
    case SCRIPT_KEY:
        press(trial, command->words[0]);
        return true;
    case SCRIPT_SET:
        if (names_locked(&trial->play->lesson, command->words[0])) {
            script_fault(script, command, fault, "%s is locked in this lesson: %s", command->words[0],
                         names_locked(&trial->play->lesson, command->words[0]));
            return false;
        }
        if (trial->count < LESSON_SETTINGS_MOST)
            trial->settings[trial->count++] =
                text_in_arena(&trial->arena, "%s=%s", command->words[0], command->words[1]);
        trial->stale = true;
        return true;
    case SCRIPT_SELECT:
        trial->selected = command->words[0];
        trial->stale = true;
        return true;
    case SCRIPT_EXPECT:
        return expect(trial, result, script, command, fault);
    default:
        return true;
    }
}

static void check_tasks(const TrialResult *result, const Play *play, Fault *fault) {
    const char *script = play->lesson.script;
    for (size_t t = 0; t < result->task_count; t++) {
        const TrialTask *task = &result->tasks[t];
        if (!task->no)
            fault_add(fault, "%s:1:1: no attempt at the task of step %zu fails; must hold the obvious wrong way",
                      script, task->step + 1);
        if (!task->yes)
            fault_add(fault, "%s:1:1: no attempt at the task of step %zu reaches the goal", script, task->step + 1);
    }
    if (play->step + 1 != play->lesson.step_count)
        fault_add(fault, "%s:1:1: the script ends at step %zu, must come to the last one, %zu", script, play->step + 1,
                  play->lesson.step_count);
}

TrialResult trial_run(Play *play, const TrialOptions *options, Fault *fault) {
    Tryout trial = {.play = play, .options = options};
    TrialResult result = {.task_count = 0};
    Script script = {.path = NULL};
    if (!script_read(&script, play->lesson.script, fault))
        return result;
    for (size_t s = 0; s < play->lesson.step_count; s++)
        if (play->lesson.steps[s].kind == LESSON_TASK)
            result.tasks[result.task_count++].step = s;
    begin_step(&trial);
    bool good = true;
    for (const ScriptCommand *command; good && (command = script_next(&script));)
        good = follow(&trial, &result, &script, command, fault);
    if (good)
        check_tasks(&result, play, fault);
    script_free(&script);
    arena_clear(&trial.arena);
    return result;
}

void trial_check_numbers(const Lesson *lesson, Fault *fault) {
    Arena arena = {0};
    for (size_t n = 0; n < lesson->number_count; n++) {
        const LessonNumber *number = &lesson->numbers[n];
        const LessonGoal goal = {.condition = number->condition, .than = number->than, .is = ""};
        if (number->condition.verdict != VERDICT_PASSED)
            fault_add(fault, "%s:1:1: the number \"%s\" is %s; the lesson holds only if it is %s", lesson->path,
                      number->name, words_value(number->condition.value, -1, number->condition.unit, &arena),
                      words_limits(&goal, &arena));
    }
    arena_clear(&arena);
}
