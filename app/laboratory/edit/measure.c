#include "laboratory/edit/measure.h"

#include <math.h>
#include <stdio.h>

#include "plan/plan_geometry.h"

double edit_measure_chair(const Editor *edit) {
    double width = HUGE_VAL;
    const House *house = edit->scene.scenery.house;
    for (size_t i = 0; house && i < house->profile_count; i++) {
        const Profile *profile = &house->profiles[i];
        if (profile->driving != DRIVING_WALKER)
            width = fmin(width, profile->width);
    }
    return width;
}

void edit_measure_format(double length, double chair, char *text, size_t size) {
    if (!isfinite(chair))
        snprintf(text, size, "%.2f m", length);
    else if (length >= chair)
        snprintf(text, size, "%.2f m: %.2f m to spare", length, length - chair);
    else
        snprintf(text, size, "%.2f m: %.2f m too narrow", length, chair - length);
}

/* The side of an item that is nearest to a place, within reach. */
typedef struct Side {
    Vec2 from, to;
    double distance; /* m */
} Side;

static void offer(Side *side, Vec2 at, Vec2 from, Vec2 to) {
    double distance = vec2_distance(at, vec2_nearest_on_segment(at, from, to));
    if (distance < side->distance)
        *side = (Side){from, to, distance};
}

bool edit_measure_side(Editor *edit) {
    const Plan *plan = draft_plan(edit->draft);
    Side side = {.distance = edit->pointer.reach};
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t s = 0; s + 1 < plan->walls[w].points.count; s++) {
            const Vec2 *ends = plan->walls[w].points.at + s;
            Vec2 out = vec2_scale(vec2_left(vec2_unit(vec2_sub(ends[1], ends[0]))), plan->walls[w].thickness / 2);
            offer(&side, edit->pointer.at, vec2_add(ends[0], out), vec2_add(ends[1], out));
            offer(&side, edit->pointer.at, vec2_sub(ends[0], out), vec2_sub(ends[1], out));
        }
    for (size_t f = 0; f < plan->furniture_count; f++) {
        Vec2 corners[4];
        plan_geometry_corners(&plan->furniture[f], corners);
        for (int i = 0; i < 4; i++)
            offer(&side, edit->pointer.at, corners[i], corners[(i + 1) % 4]);
    }
    if (!(side.distance < edit->pointer.reach))
        return false;
    edit_measure_store(edit, side.from, side.to);
    return true;
}

void edit_measure_store(Editor *edit, Vec2 from, Vec2 to) {
    if (edit->measure_count == EDIT_MEASURES) {
        for (size_t i = 1; i < EDIT_MEASURES; i++)
            edit->measures[i - 1] = edit->measures[i];
        edit->measure_count--;
    }
    edit->measures[edit->measure_count++] = (EditMeasure){from, to};
}
