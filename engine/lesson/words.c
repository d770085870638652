#include "lesson/words.h"

#include <math.h>
#include <string.h>

#include "base/text.h"

#define SLACK 0.06 /* cm, by which a limit may differ from a whole centimetre and yet be said as that */

const char *words_value(double value, int digits, const char *unit, Arena *arena) {
    const char *between = strcmp(unit, "1") == 0 ? "" : " ", *shown = *between ? unit : "";
    if (isnan(value))
        return "none";
    if (digits < 0)
        return text_in_arena(arena, "%.4g%s%s", value, between, shown);
    return text_in_arena(arena, "%.*f%s%s", digits, value, between, shown);
}

static const LessonNumber *find(const Lesson *lesson, const char *name, size_t length) {
    for (size_t n = 0; n < lesson->number_count; n++)
        if (strlen(lesson->numbers[n].name) == length && strncmp(lesson->numbers[n].name, name, length) == 0)
            return &lesson->numbers[n];
    return NULL;
}

/* Returns the next "{name}" in the text; NULL: there is none. */
static const char *next_number(const char *text, size_t *length) {
    const char *open = strchr(text, '{'), *close = open ? strchr(open, '}') : NULL;
    *length = close ? (size_t)(close - open) - 1 : 0;
    return close ? open : NULL;
}

bool words_has_number(const char *text) {
    size_t length;
    return next_number(text, &length);
}

const char *words_unknown(const Lesson *lesson, const char *text, Arena *arena) {
    size_t length;
    for (const char *at; (at = next_number(text, &length)); text = at + length + 2)
        if (!find(lesson, at + 1, length))
            return text_in_arena(arena, "%.*s", (int)length, at + 1);
    return NULL;
}

const char *words_fill(const Lesson *lesson, const char *text, Arena *arena) {
    Text all = {0};
    size_t length;
    for (const char *at; (at = next_number(text, &length)); text = at + length + 2) {
        const LessonNumber *number = find(lesson, at + 1, length);
        text_format(&all, "%.*s", (int)(at - text), text);
        if (number && number->condition.verdict != VERDICT_NOT_RUN)
            text_add(&all, words_value(number->condition.value, number->digits, number->condition.unit, arena));
        else
            text_add(&all, "(being worked out)");
    }
    text_add(&all, text);
    const char *filled = text_in_arena(arena, "%s", all.text ? all.text : "");
    memory_free(all.text);
    return filled;
}

/* Returns the digits behind the point: two of limits in metres that are whole centimetres but for a slack, which
 * absorbs rounding; otherwise as few as tell 4 places. */
static int digits_of(const Condition *condition) {
    const double limits[] = {condition->low, condition->high};
    bool metres = strcmp(condition->unit, "m") == 0;
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++)
        metres = metres && (isinf(limits[i]) || fabs(100 * limits[i] - round(100 * limits[i])) < SLACK);
    return metres ? 2 : -1;
}

const char *words_limits(const LessonGoal *goal, Arena *arena) {
    const Condition *condition = &goal->condition;
    const char *low = words_value(condition->low, digits_of(condition), condition->unit, arena);
    const char *high = words_value(condition->high, digits_of(condition), condition->unit, arena);
    if (*goal->is)
        return text_in_arena(arena, "must be %s", goal->is);
    if (condition->low == condition->high)
        return text_in_arena(arena, "must be %s", low);
    if (condition->low == -HUGE_VAL)
        return text_in_arena(arena, "at most %s", high);
    if (condition->high == HUGE_VAL)
        return text_in_arena(arena, "at least %s", low);
    return text_in_arena(arena, "from %s to %s", low, high);
}

const char *words_goal(const LessonGoal *goal, Arena *arena) {
    const Condition *condition = &goal->condition;
    const char *title = *condition->title ? condition->title : condition->measure_name;
    if (condition->verdict == VERDICT_NOT_RUN)
        return title;
    if (strcmp(condition->measure_name, "regular") == 0 || *goal->is)
        return text_in_arena(arena, "%s: %s", title, condition->value > 0.5 ? "yes" : "no");
    return text_in_arena(arena, "%s: %s, %s", title,
                         words_value(condition->value, digits_of(condition), condition->unit, arena),
                         words_limits(goal, arena));
}
