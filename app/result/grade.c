#include "result/grade.h"

#include <stdint.h>
#include <string.h>

/* True of a driver whose grade is known or, without grades, will be. */
static bool is_known(const House *house, const Grade *grades, size_t person) {
    return house->people[person].profile->driving == DRIVING_DRIVER && !(grades && grades[person].interrupted);
}

const char *result_grade_place(const char *what, Arena *arena) {
    static const char start[] = "start, ";
    if (strncmp(what, start, strlen(start)) == 0)
        return text_in_arena(arena, "at the start, %s", what + strlen(start));
    return text_in_arena(arena, "at %s", what);
}

/* Returns "grade" or, of several people, "worst grade". */
static const char *noun(size_t known) {
    return known > 1 ? "worst grade" : "grade";
}

static size_t count_known(const House *house, const Grade *grades) {
    size_t known = 0;
    for (size_t i = 0; i < house->person_count; i++)
        known += is_known(house, grades, i);
    return known;
}

const char *result_grade_phrase(const House *house, const Grade *grades, Arena *arena) {
    size_t worst = grade_worst(house, grades);
    if (worst == SIZE_MAX)
        return "";
    const Grade *grade = &grades[worst];
    const char *said = text_in_arena(arena, "%s %s, %s", noun(count_known(house, grades)), grade_letter(grade->letter),
                                     grade_words(grade->letter));
    if (grade->weak)
        return text_in_arena(arena, "%s, driver too weak", said);
    if (!grade->has_place)
        return said;
    return text_in_arena(arena, "%s, %s", said, result_grade_place(grade->what, arena));
}

void result_grade_add(const char **title, const char **detail, const House *house, const Grade *grades, Arena *arena) {
    size_t known = count_known(house, grades);
    if (!known)
        return;
    const Grade *worst = grades ? &grades[grade_worst(house, grades)] : NULL;
    if (worst)
        *title = text_in_arena(arena, "%s, %s %s", *title, noun(known), grade_letter(worst->letter));
    *detail = text_in_arena(arena, **detail ? "%s; %s" : "%s%s",
                            worst ? grade_words(worst->letter) : "working out the grade", *detail);
}
