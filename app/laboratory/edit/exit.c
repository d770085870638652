#include "laboratory/edit/exit.h"

#include <stdio.h>
#include <string.h>

#include "laboratory/edit/door.h"
#include "laboratory/edit/field.h"
#include "laboratory/edit/marks.h"
#include "plan/plan_geometry.h"

static const double NEW_DOOR = 0.90;               /* m, width of the door that a solid wall gets */
static const double LEAST_GAP = 0.3, MOST_GAP = 8; /* m between the ends of walls */
static const double SAME = 1e-6;                   /* m: points closer than this coincide */

enum { FIELD_X, FIELD_Y, FIELD_WIDTH };

/* Doors ----------------------------------------------------------------------------------------------------------- */

/* Returns the index of the door whose opening, enlarged by a reach, contains a place; SIZE_MAX: none. */
static size_t door_at(const Plan *plan, Vec2 at, double reach) {
    size_t nearest = SIZE_MAX;
    double least = HUGE_VAL;
    for (size_t d = 0; d < plan->door_count; d++) {
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        double half = plan->walls[plan->doors[d].wall_index].thickness / 2;
        double distance = vec2_distance(at, vec2_nearest_on_segment(at, from, to));
        if (distance > real_max(half, reach) || distance >= least)
            continue;
        least = distance;
        nearest = d;
    }
    return nearest;
}

/* Gaps ------------------------------------------------------------------------------------------------------------ */

/* An end of a wall, and the direction in which the wall would go on. */
typedef struct WallEnd {
    Vec2 at, on;
} WallEnd;

static size_t wall_ends(const Wall *wall, WallEnd ends[2]) {
    const Vec2 *at = wall->points.at;
    size_t last = wall->points.count - 1;
    if (vec2_distance(at[0], at[last]) < SAME)
        return 0;
    ends[0] = (WallEnd){at[0], vec2_unit(vec2_sub(at[0], at[1]))};
    ends[1] = (WallEnd){at[last], vec2_unit(vec2_sub(at[last], at[last - 1]))};
    return 2;
}

/* Returns where along a ray, m, it meets a wall beyond its origin; HUGE_VAL: nowhere. */
static double next_wall(const Plan *plan, Vec2 from, Vec2 on) {
    double least = HUGE_VAL;
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t s = 0; s + 1 < plan->walls[w].points.count; s++) {
            Vec2 a = plan->walls[w].points.at[s], way = vec2_sub(plan->walls[w].points.at[s + 1], a);
            double across = vec2_cross(on, way);
            if (fabs(across) < SAME * vec2_length(way))
                continue;
            double along = vec2_cross(vec2_sub(a, from), way) / across;
            double part = vec2_cross(vec2_sub(a, from), on) / across;
            if (along > SAME && part > -SAME && part < 1 + SAME)
                least = fmin(least, along);
        }
    return least;
}

/* A gap that is being looked for. */
typedef struct Gap {
    Vec2 at; /* m, the pointer */
    double reach, width;
    Vec2 from, to;
} Gap;

/* Takes a gap if it is at the pointer, is narrower than the best one, and no wall lies across it. */
static void offer_gap(const Plan *plan, Gap *gap, Vec2 from, Vec2 to) {
    double width = vec2_distance(from, to);
    if (width < LEAST_GAP || width > MOST_GAP || width >= gap->width ||
        vec2_distance(gap->at, vec2_nearest_on_segment(gap->at, from, to)) > gap->reach)
        return;
    if (next_wall(plan, from, vec2_scale(vec2_sub(to, from), 1 / width)) < width - SAME)
        return;
    gap->width = width;
    gap->from = from;
    gap->to = to;
}

/* Finds the narrowest gap at the pointer: between two ends of walls, or from an end straight on to the next wall. */
static bool find_gap(const Plan *plan, Gap *gap) {
    WallEnd own[2], other[2];
    gap->width = HUGE_VAL;
    for (size_t w = 0; w < plan->wall_count; w++) {
        size_t count = wall_ends(&plan->walls[w], own);
        for (size_t e = 0; e < count; e++) {
            Vec2 far = vec2_along(own[e].at, MOST_GAP, own[e].on);
            if (vec2_distance(gap->at, vec2_nearest_on_segment(gap->at, own[e].at, far)) <= gap->reach) {
                double along = next_wall(plan, own[e].at, own[e].on);
                if (along < MOST_GAP)
                    offer_gap(plan, gap, own[e].at, vec2_along(own[e].at, along, own[e].on));
            }
            for (size_t v = w; v < plan->wall_count; v++) {
                size_t others = wall_ends(&plan->walls[v], other);
                for (size_t f = 0; f < others; f++)
                    offer_gap(plan, gap, own[e].at, other[f].at);
            }
        }
    }
    return gap->width < HUGE_VAL;
}

/* The gesture ------------------------------------------------------------------------------------------------------ */

static Vec2 tidy(Vec2 at) {
    return vec2(snap_tidy(at.x), snap_tidy(at.y));
}

static void take_door(Editor *edit, size_t door) {
    EditTarget *now = &edit->now;
    plan_geometry_door_ends(&edit->plan_before, &edit->plan_before.doors[door], &now->from, &now->to);
    now->ground = EXIT_ON_DOOR;
    now->door = door;
}

/* Lays the exit where it can lie at a place. */
static void find_ground(Editor *edit, Vec2 at) {
    EditTarget *now = &edit->now;
    const Plan *plan = &edit->plan_before;
    double reach = edit->pointer.reach;
    Gap gap = {.at = at, .reach = reach};
    size_t door = door_at(plan, at, reach);
    SnapWall wall;
    now->ground = EXIT_NOWHERE;
    if (door != SIZE_MAX) {
        take_door(edit, door);
    } else if (snap_wall(plan, at, &wall) && wall.distance <= real_max(plan->walls[wall.wall].thickness / 2, reach)) {
        edit_door_update(edit);
        now->ground = EXIT_ON_WALL;
    } else if (find_gap(plan, &gap)) {
        now->ground = EXIT_ON_GAP;
        now->from = gap.from;
        now->to = gap.to;
    }
}

void edit_exit_update(Editor *edit) {
    EditTarget *now = &edit->now;
    Vec2 at = edit->pointer.at;
    edit_field_typed(edit, FIELD_X, &at.x);
    edit_field_typed(edit, FIELD_Y, &at.y);
    edit_field_show(edit, FIELD_X, at.x);
    edit_field_show(edit, FIELD_Y, at.y);
    now->amount = NEW_DOOR;
    edit_field_typed(edit, FIELD_WIDTH, &now->amount);
    edit_field_show(edit, FIELD_WIDTH, now->amount);
    find_ground(edit, at);
    if (now->ground != EXIT_ON_WALL)
        now->at = now->ground ? vec2_scale(vec2_add(now->from, now->to), 0.5) : at;
    *edit->snap.text = 0;
    edit->snap.at = now->at;
    snprintf(edit->name, sizeof edit->name, now->ground == EXIT_ON_WALL ? "Place door and exit" : "Place exit");
}

/* True if an exit of the plan already lies there. */
static bool is_taken(const Editor *edit) {
    const EditTarget *now = &edit->now;
    for (size_t e = 0; now->ground != EXIT_ON_WALL && e < edit->plan_before.exit_count; e++) {
        const Exit *exit = &edit->plan_before.exits[e];
        Vec2 middle = vec2_scale(vec2_add(now->from, now->to), 0.5);
        if (vec2_distance(middle, vec2_nearest_on_segment(middle, exit->from, exit->to)) < LEAST_GAP / 2)
            return true;
    }
    return false;
}

const char *edit_exit_refuse(const Editor *edit) {
    if (!edit->now.ground)
        return "exits lie on doors and openings";
    return is_taken(edit) ? "there is an exit already" : NULL;
}

static json_t *point(Vec2 at) {
    return json_pack("[o, o]", json_number(at.x), json_number(at.y));
}

void edit_exit_make(Editor *edit) {
    EditTarget *now = &edit->now;
    if (now->ground == EXIT_ON_WALL) {
        const Wall *wall = &edit->plan_before.walls[now->wall];
        const Vec2 *ends = wall->points.at + now->segment;
        Vec2 along = vec2_unit(vec2_sub(ends[1], ends[0]));
        now->from = vec2_along(ends[0], now->along - now->amount / 2, along);
        now->to = vec2_along(ends[0], now->along + now->amount / 2, along);
        draft_add(edit->draft, DRAFT_DOORS,
                  json_pack("{s:s, s:I, s:o, s:o, s:s}", "wall", wall->id, "segment", (json_int_t)now->segment, "at",
                            json_number(now->along), "width", json_number(now->amount), "kind", "hinged"));
    }
    snprintf(edit->added_id, EDIT_NAME, "%s",
             draft_add(edit->draft, DRAFT_EXITS,
                       json_pack("{s:o, s:o}", "from", point(tidy(now->from)), "to", point(tidy(now->to)))));
}

bool edit_exit_limit(Editor *edit) {
    return edit->now.ground == EXIT_ON_WALL && edit_door_limit(edit);
}

void edit_exit_describe(const Editor *edit, Text *text) {
    const EditTarget *now = &edit->now;
    if (now->ground == EXIT_ON_WALL)
        text_format(text, "Exit with a new door, %.2f m wide.", now->amount);
    else if (now->ground)
        text_format(text, "Exit, %.2f m wide.", vec2_distance(now->from, now->to));
    else
        text_add(text, "Exits lie on doors and openings.");
    if (edit->keys)
        text_add(text, " Press Enter to place it, or Tab for the next number.");
}

void edit_exit_promise(const Editor *edit, Text *text) {
    const EditTarget *now = &edit->now;
    if (now->ground == EXIT_ON_DOOR)
        text_add(text, "door: exit");
    else if (now->ground == EXIT_ON_GAP)
        text_add(text, "opening: exit");
    else if (now->ground == EXIT_ON_WALL)
        text_format(text, "solid wall: click makes a door %.2f m with the exit", now->amount);
}

void edit_exit_show(Editor *edit) {
    const EditTarget *now = &edit->now;
    const Plan *plan = draft_plan(edit->draft);
    if (!now->ground)
        return;
    if (now->ground == EXIT_ON_WALL && edit->has_good && plan->door_count > edit->plan_before.door_count)
        edit_marks_door(edit, plan, &plan->doors[plan->door_count - 1]);
    if (now->ground != EXIT_ON_WALL || edit->has_good)
        edit_marks_exit(edit, now->from, now->to);
}

/* A house without exits -------------------------------------------------------------------------------------------- */

enum { OPENINGS_MOST = 8 };

typedef struct Opening {
    Vec2 from, to; /* m */
} Opening;

/* True if straight on, on one side of an opening, no wall follows: it leads outside. */
static bool leads_outside(const Plan *plan, Vec2 from, Vec2 to) {
    Vec2 middle = vec2_scale(vec2_add(from, to), 0.5), out = vec2_left(vec2_unit(vec2_sub(to, from)));
    return next_wall(plan, vec2_along(middle, LEAST_GAP, out), out) == HUGE_VAL ||
           next_wall(plan, vec2_along(middle, -LEAST_GAP, out), vec2_scale(out, -1)) == HUGE_VAL;
}

/* Lists doors and gaps that lead outside, at most a few. */
static size_t list_openings(const Plan *plan, Opening openings[OPENINGS_MOST]) {
    size_t count = 0;
    for (size_t d = 0; d < plan->door_count && count < OPENINGS_MOST; d++) {
        Opening *opening = &openings[count];
        plan_geometry_door_ends(plan, &plan->doors[d], &opening->from, &opening->to);
        count += leads_outside(plan, opening->from, opening->to);
    }
    Vec2 last = {NAN, NAN};
    for (size_t w = 0; w < plan->wall_count; w++) {
        WallEnd ends[2];
        size_t end_count = wall_ends(&plan->walls[w], ends);
        for (size_t e = 0; e < end_count && count < OPENINGS_MOST; e++) {
            Gap gap = {.at = vec2_along(ends[e].at, LEAST_GAP / 2, ends[e].on), .reach = SAME};
            if (!find_gap(plan, &gap) || !leads_outside(plan, gap.from, gap.to))
                continue;
            Vec2 middle = vec2_scale(vec2_add(gap.from, gap.to), 0.5);
            if (vec2_distance(middle, last) < SAME)
                continue; /* the other end of the same gap */
            last = middle;
            openings[count++] = (Opening){gap.from, gap.to};
        }
    }
    return count;
}

bool edit_exit_only(const Editor *edit, Vec2 *at) {
    Opening openings[OPENINGS_MOST];
    const Plan *plan = draft_plan(edit->draft);
    if (plan->exit_count || list_openings(plan, openings) != 1)
        return false;
    *at = vec2_scale(vec2_add(openings[0].from, openings[0].to), 0.5);
    return true;
}

static void add_ring(Editor *edit, Vec2 from, Vec2 to) {
    enum { RING = 24 };
    Vec2 ring[RING], middle = vec2_scale(vec2_add(from, to), 0.5);
    double radius = vec2_distance(from, to) * 0.75;
    for (int i = 0; i < RING; i++)
        ring[i] = vec2_along(middle, radius, vec2_heading(2 * M_PI * i / RING));
    edit_marks_ring(edit, ring, RING, "here?");
}

void edit_exit_rings(Editor *edit) {
    Opening openings[OPENINGS_MOST];
    const Plan *plan = draft_plan(edit->draft);
    if (plan->exit_count || (edit->tool != TOOL_SELECT && edit->tool != TOOL_EXIT))
        return;
    size_t count = list_openings(plan, openings);
    for (size_t k = 0; k < count; k++)
        add_ring(edit, openings[k].from, openings[k].to);
}
