#include "lesson/person.h"

#include <math.h>
#include <string.h>

#include "lesson/names.h"

#define ANSWER "answer"
#define SELECTED "selected"

bool person_has(const char *measure) {
    return strcmp(measure, ANSWER) == 0 || strcmp(measure, SELECTED) == 0;
}

static bool is_selected(const LessonGoal *goal) {
    return strcmp(goal->condition.measure_name, SELECTED) == 0;
}

static void read_is(LessonGoal *goal, Lesson *lesson, const JsonNode *is, Fault *fault) {
    Condition *condition = &goal->condition;
    if (condition->low > -HUGE_VAL || condition->high < HUGE_VAL)
        json_fault(is, fault, "\"is\" takes the place of \"low\" and \"high\"");
    else if (is_selected(goal) != json_is_string(is->value) ||
             !(json_is_string(is->value) || json_is_number(is->value)))
        json_fault(is, fault, "is must be a %s", is_selected(goal) ? "text, the name of a thing" : "number");
    condition->low = condition->high = is_selected(goal) ? 1 : json_number_value(is->value);
    goal->is =
        is_selected(goal) && json_is_string(is->value) ? arena_text(&lesson->arena, json_string_value(is->value)) : "";
}

/* Checks a condition on the guess of the last step "predict" before this one. */
static void check_answer(const Condition *condition, const Lesson *lesson, const LessonStep *step, const JsonNode *node,
                         Fault *fault) {
    JsonNode name = json_member(node, "measure"), is = json_member(node, "is");
    const LessonStep *guess = step;
    while (guess > lesson->steps && guess->kind != LESSON_PREDICT)
        guess--;
    if (guess->kind != LESSON_PREDICT) {
        json_fault(&name, fault, "\"" ANSWER "\" needs a step \"predict\" before this one");
        return;
    }
    size_t count = guess->options.count;
    condition_check_unit(condition, *guess->unit ? guess->unit : "1", node, fault);
    if (is.value && !*guess->unit && !(condition->low >= 1 && condition->low <= (double)count))
        json_fault(&is, fault, "is is %g, must be an option, 1 to %zu", condition->low, count);
}

void person_read(LessonGoal *goal, Lesson *lesson, const LessonStep *step, const struct Names *names,
                 const JsonNode *node, Fault *fault) {
    JsonNode is = json_member(node, "is"), than = json_member(node, "than"), name = json_member(node, "measure");
    goal->is = "";
    if (is.value)
        read_is(goal, lesson, &is, fault);
    if (!person_has(goal->condition.measure_name))
        return;
    if (*goal->than)
        json_fault(&than, fault, "a ratio of \"%s\" has no meaning", goal->condition.measure_name);
    if (!is_selected(goal)) {
        check_answer(&goal->condition, lesson, step, node, fault);
        return;
    }
    condition_check_unit(&goal->condition, "1", node, fault);
    if (!is.value)
        json_fault(&name, fault, "\"" SELECTED "\" needs \"is\", the name of a thing");
    else if (names && *goal->is)
        names_check_thing(names, lesson, goal->is, false, &is, fault);
}

double person_value(const LessonGoal *goal, const PersonState *state) {
    if (is_selected(goal))
        return state->selected && strcmp(state->selected, goal->is) == 0;
    return state->answer;
}
