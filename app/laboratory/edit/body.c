#include "laboratory/edit/body.h"

#include <math.h>

#include "base/text.h"
#include "laboratory/edit/select.h"
#include "laboratory/edit/tool_items.h"
#include "plan/overlap.h"
#include "plan/plan_geometry.h"

static const double TOUCH = 0.001; /* m: deeper overlaps touch */

/* Returns the chosen profile, read once; NULL: it cannot be read. */
static const Profile *chosen_profile(Editor *edit) {
    size_t row = edit->chosen_rows[TOOL_PERSON];
    edit_tool_items_stock(edit);
    if (row >= edit->profile_count)
        return NULL;
    if (edit->body_known && edit->body_row == row)
        return edit->body.length > 0 ? &edit->body : NULL;
    Fault none = {0};
    Arena arena = {0};
    edit_body_clear(edit);
    bool read = profile_read(&edit->body, profile_find(edit->options.profiles, edit->profiles[row], &arena), &none);
    edit->body_known = true;
    edit->body_row = row;
    arena_clear(&arena);
    fault_clear(&none);
    return read ? &edit->body : NULL;
}

void edit_body_clear(Editor *edit) {
    if (edit->body_known)
        profile_free(&edit->body);
    edit->body = (Profile){0};
    edit->body_known = false;
}

static bool is_disc(const Profile *profile) {
    return profile->driving != DRIVING_DRIVER;
}

/* Returns the rectangle of a body, or the square within its disc, as a piece of furniture. */
static Furniture piece_of(const Profile *profile, Vec2 at, double heading, double turned) {
    Furniture piece = {.id = "", .angle = heading + turned, .topples = TOPPLE_NO};
    if (is_disc(profile)) {
        piece.centre = at;
        piece.size = vec2(profile->width * M_SQRT1_2, profile->width * M_SQRT1_2);
    } else {
        piece.centre = vec2_along(at, profile->length / 2 - profile->axle, snap_heading(heading));
        piece.size = vec2(profile->length, profile->width);
    }
    return piece;
}

size_t edit_body_outline(Editor *edit, Vec2 at, double heading, Vec2 points[BODY_POINTS]) {
    const Profile *profile = chosen_profile(edit);
    if (!profile)
        return 0;
    if (!is_disc(profile)) {
        Furniture piece = piece_of(profile, at, heading, 0);
        plan_geometry_corners(&piece, points);
        return 4;
    }
    for (int i = 0; i < BODY_POINTS; i++)
        points[i] = vec2_along(at, profile->width / 2, vec2_heading(2 * M_PI * i / BODY_POINTS));
    return BODY_POINTS;
}

/* True if the corners (4 each) of two rectangles overlap: no side of either separates them. */
static bool overlap(const Vec2 *a, const Vec2 *b) {
    for (int turn = 0; turn < 2; turn++) {
        const Vec2 *own = turn ? b : a, *other = turn ? a : b;
        for (int i = 0; i < 4; i++) {
            Vec2 out = vec2_scale(vec2_left(vec2_unit(vec2_sub(own[(i + 1) % 4], own[i]))), -1);
            double least = HUGE_VAL;
            for (int j = 0; j < 4; j++)
                least = fmin(least, vec2_dot(vec2_sub(other[j], own[i]), out));
            if (least > -TOUCH)
                return false;
        }
    }
    return true;
}

static bool touches(Editor *edit, const Plan *plan, const Furniture *body, char name[EDIT_NAME]) {
    Vec2 corners[4], other[4];
    size_t wall;
    plan_geometry_corners(body, corners);
    if (plan->wall_count && overlap_depth(plan, body, &wall) > TOUCH) {
        edit_select_name(edit, plan->walls[wall].id, name);
        return true;
    }
    for (size_t f = 0; f < plan->furniture_count; f++) {
        plan_geometry_corners(&plan->furniture[f], other);
        if (!overlap(corners, other))
            continue;
        edit_select_name(edit, plan->furniture[f].id, name);
        return true;
    }
    return false;
}

bool edit_body_touches(Editor *edit, const Plan *plan, Vec2 at, double heading, char name[EDIT_NAME]) {
    const Profile *profile = chosen_profile(edit);
    if (!profile)
        return false;
    for (int turn = 0; turn <= is_disc(profile); turn++) { /* a disc: two squares within it */
        Furniture piece = piece_of(profile, at, heading, 45 * turn);
        if (touches(edit, plan, &piece, name))
            return true;
    }
    return false;
}
