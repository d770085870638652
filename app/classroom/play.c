#include "classroom/play.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "lesson/look.h"

const LessonStep *play_step(const Play *play) {
    return &play->lesson.steps[play->step];
}

LessonLook play_look(const Play *play) {
    return look_of_step(&play->lesson, play_step(play));
}

bool play_hides(const Play *play) {
    bool predicts = false;
    for (size_t s = 0; s < play->lesson.step_count; s++) {
        int kind = play->lesson.steps[s].kind;
        predicts |= kind == LESSON_PREDICT;
        if (s >= play->step && kind == LESSON_PREDICT)
            return true;
        if (s >= play->step && kind != LESSON_READ)
            return false;
    }
    return !predicts;
}

bool play_asks(const Play *play) {
    const LessonStep *step = play_step(play);
    return step->kind == LESSON_OBSERVE && step->options.count && !play->steps[play->step].chosen;
}

bool play_restarts(const Play *play) {
    int kind = play_step(play)->kind;
    return kind == LESSON_OBSERVE || kind == LESSON_TASK;
}

const char *play_question(const Play *play) {
    return play_asks(play)                           ? "What do you see?"
           : play_step(play)->kind == LESSON_PREDICT ? "What do you think?"
                                                     : play->lesson.title;
}

const char *play_reason(const Play *play, PlayKey key) {
    const PlayStep *shown = &play->steps[play->step];
    const LessonStep *step = play_step(play);
    switch (key) {
    case PLAY_BACK:
        return play->step ? NULL : "This is the first step";
    case PLAY_HINT:
        return (size_t)shown->hints < step->hints.count ? NULL : "This step has no more hints";
    case PLAY_VOTE:
        return step->kind == LESSON_PREDICT && !shown->vote ? NULL : "There is nothing to vote on again";
    default:
        return NULL;
    }
}

bool play_takes(const Play *play, PlayKey key) {
    const LessonStep *step = play_step(play);
    switch (key) {
    case PLAY_DIGIT:
        return step->options.count > 0 || *step->unit;
    case PLAY_POINT:
        return *step->unit;
    case PLAY_ADD:
        return *step->unit && *play->steps[play->step].typed;
    case PLAY_VOTE:
    case PLAY_UNDO:
        return step->kind == LESSON_PREDICT;
    default:
        return true;
    }
}

bool play_is_begun(const Play *play) {
    return play->step > 0 || play_hands(&play->steps[0], 0) > 0;
}

static const struct {
    const char *name;
    PlayKey key;
    int digit;
} keys[] = {{"PageDown", PLAY_NEXT, 0},    {"PageUp", PLAY_BACK, 0},    {"?", PLAY_HINT, 0},
            {"0", PLAY_DIGIT, 0},          {"Keypad 0", PLAY_DIGIT, 0}, {".", PLAY_POINT, 0},
            {",", PLAY_POINT, 0},          {"Keypad .", PLAY_POINT, 0}, {"Return", PLAY_ADD, 0},
            {"Keypad Enter", PLAY_ADD, 0}, {"Backspace", PLAY_UNDO, 0}, {"1", PLAY_DIGIT, 1},
            {"2", PLAY_DIGIT, 2},          {"3", PLAY_DIGIT, 3},        {"4", PLAY_DIGIT, 4},
            {"5", PLAY_DIGIT, 5},          {"6", PLAY_DIGIT, 6},        {"7", PLAY_DIGIT, 7},
            {"8", PLAY_DIGIT, 8},          {"9", PLAY_DIGIT, 9},        {"Keypad 1", PLAY_DIGIT, 1},
            {"Keypad 2", PLAY_DIGIT, 2},   {"Keypad 3", PLAY_DIGIT, 3}, {"Keypad 4", PLAY_DIGIT, 4},
            {"Keypad 5", PLAY_DIGIT, 5},   {"Keypad 6", PLAY_DIGIT, 6}, {"Keypad 7", PLAY_DIGIT, 7},
            {"Keypad 8", PLAY_DIGIT, 8},   {"Keypad 9", PLAY_DIGIT, 9}};
enum { KEYS = sizeof keys / sizeof *keys };

const char *const *play_key_names(size_t *count) {
    static const char *names[KEYS];
    for (size_t k = 0; k < KEYS; k++)
        names[k] = keys[k].name;
    *count = KEYS;
    return names;
}

bool play_read_key(const char *name, PlayKey *key, int *digit) {
    for (size_t k = 0; k < KEYS; k++)
        if (strcmp(name, keys[k].name) == 0) {
            *key = keys[k].key;
            *digit = keys[k].digit;
            return true;
        }
    return false;
}

void play_judge(Play *play) {
    const LessonStep *step = play_step(play);
    PlayGoal goal = step->goal_count ? PLAY_GOAL_YES : PLAY_GOAL_OPEN;
    for (size_t g = 0; g < step->goal_count; g++)
        if (step->goals[g].condition.verdict != VERDICT_PASSED)
            goal = PLAY_GOAL_NO;
    play->steps[play->step].goal = goal;
}

int play_hands(const PlayStep *step, int vote) {
    int all = step->number_count[vote];
    for (size_t o = 0; o < LESSON_OPTIONS_MOST; o++)
        all += step->hands[vote][o];
    return all;
}

size_t play_guessed(const Play *play) {
    for (size_t s = play->step; s-- > 0;)
        if (play->lesson.steps[s].kind == LESSON_PREDICT)
            return s;
    return SIZE_MAX;
}

static int compare_numbers(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double play_answer(const Play *play) {
    size_t guessed = play_guessed(play);
    if (guessed == SIZE_MAX)
        return (double)NAN;
    const PlayStep *step = &play->steps[guessed];
    int vote = play_hands(step, 1) ? 1 : 0, count = step->number_count[vote], most = step->chosen;
    if (!play_hands(step, vote))
        return (double)NAN;
    if (count) {
        double numbers[PLAY_NUMBERS_MOST];
        memcpy(numbers, step->numbers[vote], (size_t)count * sizeof *numbers);
        qsort(numbers, (size_t)count, sizeof *numbers, compare_numbers);
        return numbers[(count - 1) / 2];
    }
    for (int o = 1; o <= LESSON_OPTIONS_MOST; o++)
        if (!most || step->hands[vote][o - 1] > step->hands[vote][most - 1])
            most = o;
    return most;
}

static bool go_on(Play *play) {
    PlayStep *shown = &play->steps[play->step];
    if (play_step(play)->kind == LESSON_EXPLAIN && !shown->model)
        return shown->model = true;
    if (play->step + 1 >= play->lesson.step_count)
        return false;
    play->step++;
    return true;
}

static bool count_hand(Play *play, int digit) {
    const LessonStep *step = play_step(play);
    PlayStep *shown = &play->steps[play->step];
    if (digit < 1 || (size_t)digit > step->options.count)
        return false;
    shown->chosen = digit;
    if (step->kind == LESSON_PREDICT && shown->hands[shown->vote][digit - 1] < PLAY_HANDS_MOST)
        shown->hands[shown->vote][digit - 1]++;
    return true;
}

/* Types a character of a guess that is a number. */
static bool type_character(PlayStep *shown, char character) {
    size_t length = strlen(shown->typed);
    if (length == PLAY_TYPED_MOST || (character == '.' && strchr(shown->typed, '.')))
        return false;
    shown->typed[length] = character;
    shown->typed[length + 1] = 0;
    return true;
}

static bool add_number(PlayStep *shown) {
    int *count = &shown->number_count[shown->vote];
    bool good = strcmp(shown->typed, ".") != 0 && *shown->typed && *count < PLAY_NUMBERS_MOST;
    if (good)
        shown->numbers[shown->vote][(*count)++] = strtod(shown->typed, NULL);
    *shown->typed = 0;
    return good;
}

static bool take_back_number(PlayStep *shown) {
    size_t length = strlen(shown->typed);
    if (!length && !shown->number_count[shown->vote])
        return false;
    if (length)
        shown->typed[length - 1] = 0;
    else
        shown->number_count[shown->vote]--;
    return true;
}

static bool vote_again(Play *play) {
    PlayStep *shown = &play->steps[play->step];
    if (play_step(play)->kind != LESSON_PREDICT || shown->vote)
        return false;
    shown->vote = 1;
    return true;
}

static bool take_back(Play *play) {
    PlayStep *shown = &play->steps[play->step];
    if (*play_step(play)->unit)
        return take_back_number(shown);
    if (play_step(play)->kind != LESSON_PREDICT || !shown->chosen || !shown->hands[shown->vote][shown->chosen - 1])
        return false;
    shown->hands[shown->vote][shown->chosen - 1]--;
    return true;
}

bool play_key(Play *play, PlayKey key, int digit) {
    PlayStep *shown = &play->steps[play->step];
    switch (key) {
    case PLAY_NEXT:
        return go_on(play);
    case PLAY_BACK:
        if (!play->step)
            return false;
        play->step--;
        return true;
    case PLAY_HINT:
        if ((size_t)shown->hints >= play_step(play)->hints.count)
            return false;
        shown->hints++;
        return true;
    case PLAY_VOTE:
        return vote_again(play);
    case PLAY_UNDO:
        return take_back(play);
    case PLAY_POINT:
        return *play_step(play)->unit && type_character(shown, '.');
    case PLAY_ADD:
        return add_number(shown);
    default:
        return *play_step(play)->unit ? type_character(shown, (char)('0' + digit))
               : digit == 0           ? vote_again(play)
                                      : count_hand(play, digit);
    }
}

json_t *play_state(const Play *play) {
    static const char *const goals[] = {[PLAY_GOAL_OPEN] = "open", [PLAY_GOAL_NO] = "no", [PLAY_GOAL_YES] = "yes"};
    const PlayStep *shown = &play->steps[play->step];
    const LessonStep *step = play_step(play);
    json_t *hands = json_array();
    for (size_t o = 0; o < step->options.count; o++)
        json_array_append_new(hands, json_integer(shown->hands[shown->vote][o]));
    json_t *numbers = json_array();
    for (int n = 0; n < shown->number_count[shown->vote]; n++)
        json_array_append_new(numbers, json_real(shown->numbers[shown->vote][n]));
    return json_pack("{s:s, s:i, s:i, s:s, s:s, s:i, s:o, s:o, s:s, s:i, s:i, s:b, s:b, s:b}", "title",
                     play->lesson.title, "step", (int)play->step + 1, "steps", (int)play->lesson.step_count, "kind",
                     lesson_kind_word((LessonKind)step->kind), "goal", goals[shown->goal], "hints", shown->hints,
                     "hands", hands, "numbers", numbers, "typed", shown->typed, "vote", shown->vote + 1, "chosen",
                     shown->chosen, "model", shown->model, "hides", play_hides(play), "numbered", play->numbered);
}
