#include "visual/house/grades_scene.h"

#include <math.h>

/* Design points. */
static const double LETTERS = 13;

static Role role_of(int letter) {
    return letter >= GRADE_E ? ROLE_DANGER_HIGH : letter == GRADE_D ? ROLE_DANGER_MIDDLE : ROLE_DANGER_LOW;
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
        const char *letter = grade_letter(grade->letter);
        bool more = grade->letter > GRADE_A && isfinite(grade->to_next);
        const char *missing = more ? scene_text(scene, "%.1f cm", 100 * grade->to_next) : "";
        SceneRow *row = scene_add_row(scene, ROW_DISC,
                                      scene_text(scene, "%s  %s", house->people[i].id, grade_words(grade->letter)));
        row->role = role_of(grade->letter);
        row->mark = letter;
        row->cells[2] = missing;
        if (!grade->has_place || grade->letter == GRADE_A)
            continue;
        Primitive *label = scene_add_label(scene, role_of(grade->letter), LETTERS, grade->at,
                                           more ? scene_text(scene, "%s +%s", letter, missing) : letter);
        label->shape = LABEL_TAG;
        label->fill = role_of(grade->letter);
        label->bold = label->leader = true;
    }
}
