#include "result/study_grades.h"

#include <string.h>

#include "inquiry/grade.h"
#include "result/grade.h"
#include "result/study_number.h"
#include "study/summary.h"

enum { RANGES_MOST = 6 /* ranges that are listed one by one */ };

/* Returns the run of a point that has its grade, or NULL. Houses have one pass. */
static const Trial *graded_at(const Study *study, size_t i1, size_t i0) {
    return summary_worst_rank(study, 0, i1, i0);
}

static int letter_of(const Study *study, const Trial *trial) {
    return (int)trial->observed[study->experiment->rank];
}

const char *study_grades_letter(const Study *study, size_t i1, size_t i0) {
    const Trial *worst = graded_at(study, i1, i0);
    return worst ? grade_letter(letter_of(study, worst)) : NULL;
}

static size_t points_of(const Study *study) {
    return study_steps(study, 0) * study_steps(study, 1);
}

static const Trial *graded_point(const Study *study, size_t point) {
    return graded_at(study, point / study_steps(study, 0), point % study_steps(study, 0));
}

bool study_grades_exist(const Study *study) {
    if (!study->experiment->rank_count)
        return false;
    size_t point = 0;
    while (point < points_of(study) && !graded_point(study, point))
        point++;
    return point < points_of(study);
}

/* Ranges ---------------------------------------------------------------------------------------------------------- */

/* Neighbouring values of the only axis with one grade. */
typedef struct Range {
    size_t first, last; /* steps */
    const Trial *worst; /* a run with that grade */
    bool places;        /* True if its place differs within the range */
} Range;

static bool same_place(const Trial *a, const Trial *b) {
    return strcmp(a->note ? a->note : "", b->note ? b->note : "") == 0;
}

/* Returns the ranges (count) of the only axis, without values that have no grade. The caller releases them. */
static Range *list_ranges(const Study *study, size_t *count) {
    Range *ranges = memory_zeroed(study_steps(study, 0), sizeof *ranges);
    *count = 0;
    for (size_t i = 0; i < study_steps(study, 0); i++) {
        const Trial *worst = graded_at(study, 0, i);
        Range *range = *count ? &ranges[*count - 1] : NULL;
        if (!worst)
            continue;
        if (range && range->last + 1 == i && letter_of(study, range->worst) == letter_of(study, worst)) {
            range->last = i;
            range->places |= !same_place(range->worst, worst);
        } else {
            ranges[(*count)++] = (Range){.first = i, .last = i, .worst = worst};
        }
    }
    return ranges;
}

/* Adds "grade D" and, where there is only one, its place: "grade D, at door d3". */
static void say_grade(Text *text, const Study *study, const Trial *worst, bool places) {
    Arena arena = {0};
    text_format(text, "grade %s", grade_letter(letter_of(study, worst)));
    if (worst->note && !places)
        text_format(text, ", %s,", result_grade_place(worst->note, &arena));
    arena_clear(&arena);
}

static void say_range(Text *text, const Study *study, const Range *range) {
    size_t last = study_steps(study, 0) - 1;
    char from[STUDY_NUMBER], to[STUDY_NUMBER];
    study_number_step(study, 0, range->first, range->first == range->last || range->last == last, from);
    study_number_step(study, 0, range->last, true, to);
    say_grade(text, study, range->worst, range->places);
    if (range->first == 0 && range->last == last)
        text_add(text, " throughout");
    else if (range->first == range->last)
        text_format(text, " at %s", to);
    else if (range->first == 0)
        text_format(text, " up to %s", to);
    else if (range->last == last)
        text_format(text, " from %s on", from);
    else
        text_format(text, " from %s to %s", from, to);
}

/* Adds the grade of a point with its values: "grade D, at door d3, at door.d3.width 0.82 m". */
static void say_point(Text *text, const Study *study, size_t point) {
    const size_t steps[STUDY_AXES_MOST] = {point % study_steps(study, 0), point / study_steps(study, 0)};
    say_grade(text, study, graded_point(study, point), false);
    for (size_t a = 0; a < study->axis_count; a++) {
        char value[STUDY_NUMBER];
        study_number_step(study, a, steps[a], true, value);
        text_format(text, a ? " and %s %s" : " at %s %s", study->axes[a].name, value);
    }
}

/* Adds the best and the worst grade of all points, each with the first point that has it. */
static void say_extremes(Text *text, const Study *study) {
    size_t best = 0, worst = 0;
    const Trial *of_best = NULL, *of_worst = NULL;
    for (size_t point = 0; point < points_of(study); point++) {
        const Trial *trial = graded_point(study, point);
        if (!trial)
            continue;
        int letter = letter_of(study, trial);
        if (!of_worst || letter > letter_of(study, of_worst)) {
            of_worst = trial;
            worst = point;
        }
        if (!of_best || letter < letter_of(study, of_best)) {
            of_best = trial;
            best = point;
        }
    }
    if (letter_of(study, of_best) == letter_of(study, of_worst)) {
        say_grade(text, study, of_worst, true);
        text_add(text, " wherever all are out");
        return;
    }
    text_add(text, "worst ");
    say_point(text, study, worst);
    text_add(text, "; best ");
    say_point(text, study, best);
}

void study_grades_say(Text *text, const Study *study) {
    if (!study_grades_exist(study))
        return;
    size_t count = 0;
    Range *ranges = study->axis_count == 1 ? list_ranges(study, &count) : NULL;
    for (size_t r = 0; r < count && count <= RANGES_MOST; r++) {
        text_add(text, r ? "; " : "");
        say_range(text, study, &ranges[r]);
    }
    if (!study->axis_count) {
        Arena arena = {0};
        const Trial *worst = graded_at(study, 0, 0);
        int letter = letter_of(study, worst);
        text_format(text, "grade %s, %s%s%s", grade_letter(letter), grade_words(letter), worst->note ? ", " : "",
                    worst->note ? result_grade_place(worst->note, &arena) : "");
        arena_clear(&arena);
    } else if (!count || count > RANGES_MOST) {
        say_extremes(text, study);
    }
    memory_free(ranges);
    text_add(text, "\n");
}

/* Tables ---------------------------------------------------------------------------------------------------------- */

static void add_grade(ResultTable *table, const Study *study, const Trial *worst, const char *place) {
    int letter = letter_of(study, worst);
    result_add(table, (ResultRow){.key = "grade", .text = grade_letter(letter)});
    result_add(table,
               (ResultRow){.key = "said",
                           .label = "grade",
                           .text = text_in_arena(&table->arena, "%s, %s", grade_letter(letter), grade_words(letter))});
    result_add(table, (ResultRow){.key = "what", .label = "place", .text = place, .omitted = !place});
}

ResultTable study_grades_table(const Study *study) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    for (size_t point = 0; point < points_of(study); point++) {
        const size_t steps[STUDY_AXES_MOST] = {point % study_steps(study, 0), point / study_steps(study, 0)};
        const Trial *worst = graded_point(study, point);
        if (!worst)
            continue;
        for (size_t a = 0; a < study->axis_count; a++)
            result_add(&table, (ResultRow){.key = text_in_arena(&table.arena, "at.%s", study->axes[a].name),
                                           .label = study->axes[a].name,
                                           .kind = RESULT_NUMBER,
                                           .number = study_value(&study->axes[a], steps[a])});
        add_grade(&table, study, worst, worst->note);
        result_end(&table);
    }
    return table;
}

ResultTable study_grades_ranges(const Study *study) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    size_t count = 0;
    Range *ranges = study->axis_count == 1 && study_grades_exist(study) ? list_ranges(study, &count) : NULL;
    for (size_t r = 0; r < count; r++) {
        char from[STUDY_NUMBER], to[STUDY_NUMBER];
        study_number_step(study, 0, ranges[r].first, true, from);
        study_number_step(study, 0, ranges[r].last, true, to);
        result_add(&table, (ResultRow){.label = "from", .text = arena_text(&table.arena, from)});
        result_add(&table, (ResultRow){.label = "to", .text = arena_text(&table.arena, to)});
        add_grade(&table, study, ranges[r].worst, ranges[r].places ? "several" : ranges[r].worst->note);
        result_end(&table);
    }
    memory_free(ranges);
    return table;
}
