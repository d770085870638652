#include "visual/house/grades_scene.h"

#include <math.h>

#include "result/names.h"

/* Design points. */
static const double LETTERS = 13;
/* m: labels of different people nearer to each other than this are one. */
static const double SAME_PLACE = 0.3;

static Role role_of(int letter) {
    return letter >= GRADE_E ? ROLE_DANGER_HIGH : letter == GRADE_D ? ROLE_DANGER_MIDDLE : ROLE_DANGER_LOW;
}

/* True if the same place with the same letter was already labelled for a person before. */
static bool is_repeated(const Grade *grades, size_t person, const GradePlace *place) {
    for (size_t i = 0; i < person; i++)
        for (size_t p = 0; p < grades[i].place_count; p++)
            if (vec2_distance(grades[i].places[p].at, place->at) < SAME_PLACE)
                return true;
    return false;
}

static const char *missing_of(Scene *scene, int letter, double to_next) {
    return letter > GRADE_A && isfinite(to_next) ? scene_text(scene, "%.1f cm", 100 * to_next) : "";
}

static void add_label(Scene *scene, const GradePlace *place) {
    const char *letter = grade_letter(place->letter), *missing = missing_of(scene, place->letter, place->to_next);
    Primitive *label = scene_add_label(scene, role_of(place->letter), LETTERS, place->at,
                                       *missing ? scene_text(scene, "grade %s +%s", letter, missing)
                                                : scene_text(scene, "grade %s", letter));
    label->shape = LABEL_TAG;
    label->fill = role_of(place->letter);
    label->bold = label->leader = true;
}

void grades_scene_add(Scene *scene, const House *house, const Grade *grades) {
    bool any = false;
    for (size_t i = 0; i < house->person_count; i++) {
        const Grade *grade = &grades[i];
        if (house->people[i].profile->driving != DRIVING_DRIVER || grade->interrupted)
            continue;
        if (!any)
            scene_add_row(scene, ROW_HEADING, "How tight, to the next grade");
        any = true;
        SceneRow *row = scene_add_row(scene, ROW_PLAIN, names_person(house, i, &scene->arena));
        row->role = role_of(grade->letter);
        row->cells[1] = scene_text(scene, "grade %s %s", grade_letter(grade->letter),
                                   grade_words(grade->letter)); /* no disc: those are people */
        row->cells[2] = missing_of(scene, grade->letter, grade->to_next);
        for (size_t p = 0; p < grade->place_count; p++)
            if (!is_repeated(grades, i, &grade->places[p]))
                add_label(scene, &grade->places[p]);
    }
}
