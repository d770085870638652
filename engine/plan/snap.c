#include "plan/snap.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/real.h"
#include "plan/plan_geometry.h"

enum { LINES_MOST = 24 /* lines near the pointer at once; further ones are ignored */ };

/* A line that can be snapped to. */
typedef struct Line {
    Vec2 origin, axis;            /* m; unit */
    double low, high;             /* m, extent along the axis */
    double cost;                  /* 1, in reaches: handicap against another line at the same distance */
    Vec2 guide;                   /* m, where the displayed guide begins; for an existing line: its origin */
    bool drawn;                   /* True if the line exists in the plan */
    char text[SNAP_TEXT / 2 - 1]; /* two of them and ", " fit into SNAP_TEXT */
} Line;

typedef struct Search {
    const Plan *plan;
    const SnapAsk *ask;
    Line lines[LINES_MOST];
    size_t line_count;
    double best; /* of the best point */
    Snap snap;
} Search;

static const double COST_RAY = 0.0, COST_WALL = 0.05, COST_AXIS = 0.3;
static const double STEEP = 0.2; /* 1: sine of the least angle at which two lines form a crossing */

/* Numbers --------------------------------------------------------------------------------------------------------- */

double snap_tidy(double value) {
    return round(value * 1e10) / 1e10 + 0.0; /* no -0 */
}

static Vec2 tidy(Vec2 at) {
    return vec2(snap_tidy(at.x), snap_tidy(at.y));
}

static double to_grid(double value, double grid) {
    return snap_tidy(round(value / grid) * grid);
}

Vec2 snap_heading(double degrees) {
    double quarters = degrees / 90;
    if (quarters != floor(quarters))
        return vec2_heading(radians(degrees));
    static const Vec2 axes[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return axes[((int)fmod(quarters, 4) + 4) % 4];
}

double snap_angle(Vec2 along) {
    if (along.y == 0)
        return along.x < 0 ? 180 : 0;
    if (along.x == 0)
        return along.y < 0 ? -90 : 90;
    return snap_tidy(degrees(real_atan2(along.y, along.x)));
}

double snap_turn(double angle, bool free) {
    double step = free ? 0.1 : SNAP_TURN;
    double turned = snap_tidy(remainder(round(angle / step) * step, 360));
    return turned <= -180 ? 180 : turned;
}

/* Points ---------------------------------------------------------------------------------------------------------- */

static bool is_without(const SnapAsk *ask, const char *id) {
    for (size_t i = 0; i < ask->without_count; i++)
        if (strcmp(ask->without[i], id) == 0)
            return true;
    return false;
}

void snap_name(const Plan *plan, const SnapAsk *ask, const char *id, Vec2 at, char name[SNAP_NAME]) {
    if (ask->names)
        ask->names(plan, id, at, name);
    else
        snprintf(name, SNAP_NAME, "%s", id);
}

static void offer_point(Search *search, Vec2 at, const char *what, const char *id) {
    char name[SNAP_NAME] = "";
    double distance = vec2_distance(at, search->ask->at);
    if (distance > search->ask->reach || distance >= search->best)
        return;
    search->best = distance;
    search->snap = (Snap){.at = at};
    if (*id)
        snap_name(search->plan, search->ask, id, at, name);
    snprintf(search->snap.text, sizeof search->snap.text, "%s%s", what, name);
}

static void offer_points(Search *search) {
    const SnapAsk *ask = search->ask;
    const Plan *plan = search->plan;
    if (ask->closes && ask->own_count > 1)
        offer_point(search, ask->own[0], "first point", "");
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Points *points = &plan->walls[w].points;
        for (size_t i = 0; i < points->count && !is_without(ask, plan->walls[w].id); i++)
            offer_point(search, points->at[i], i == 0 || i + 1 == points->count ? "end of " : "corner of ",
                        plan->walls[w].id);
    }
    for (size_t d = 0; ask->doors && d < plan->door_count; d++) {
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        offer_point(search, tidy(from), "edge of ", plan->doors[d].id);
        offer_point(search, tidy(to), "edge of ", plan->doors[d].id);
    }
    for (size_t f = 0; ask->faces && f < plan->furniture_count; f++) {
        Vec2 corners[4];
        plan_geometry_corners(&plan->furniture[f], corners);
        for (int i = 0; i < 4 && !is_without(ask, plan->furniture[f].id); i++)
            offer_point(search, tidy(corners[i]), "corner of ", plan->furniture[f].id);
    }
}

/* Lines ----------------------------------------------------------------------------------------------------------- */

/* Returns the position of the pointer along a line, m. */
static double along_of(const Line *line, Vec2 at) {
    return vec2_dot(vec2_sub(at, line->origin), line->axis);
}

static double distance_to(const Line *line, Vec2 at) {
    double along = real_clamp(along_of(line, at), line->low, line->high);
    return vec2_distance(at, vec2_along(line->origin, along, line->axis));
}

static Line *offer_line(Search *search, Line line) {
    if (search->line_count == LINES_MOST || distance_to(&line, search->ask->at) > search->ask->reach)
        return NULL;
    search->lines[search->line_count] = line;
    return &search->lines[search->line_count++];
}

static void offer_segment(Search *search, Vec2 a, Vec2 b, const char *id) {
    double length = vec2_distance(a, b);
    Line *line = offer_line(search, (Line){.origin = a,
                                           .axis = vec2_unit(vec2_sub(b, a)),
                                           .high = length,
                                           .cost = COST_WALL,
                                           .guide = a,
                                           .drawn = true});
    if (!line)
        return;
    char name[SNAP_NAME];
    snap_name(search->plan, search->ask, id, vec2_nearest_on_segment(search->ask->at, a, b), name);
    snprintf(line->text, sizeof line->text, "on %s", name);
}

static void offer_wall(Search *search, const Wall *wall) {
    for (size_t s = 0; s + 1 < wall->points.count; s++) {
        Vec2 a = wall->points.at[s], b = wall->points.at[s + 1];
        Vec2 side = vec2_scale(vec2_left(vec2_unit(vec2_sub(b, a))), wall->thickness / 2);
        if (!search->ask->faces) {
            offer_segment(search, a, b, wall->id);
            continue;
        }
        offer_segment(search, vec2_add(a, side), vec2_add(b, side), wall->id);
        offer_segment(search, vec2_sub(a, side), vec2_sub(b, side), wall->id);
    }
}

/* The nearest ends in line with an upright and a level line. */
typedef struct Aligned {
    const char *ids[2]; /* of the level line and of the upright one; NULL: none */
    bool own[2];        /* the end is a point of what is drawn, and the id says which */
    Vec2 ends[2];
    double best[2];
} Aligned;

static void offer_end(const SnapAsk *ask, Aligned *aligned, Vec2 end, const char *id, bool own) {
    Vec2 to = vec2_sub(ask->at, end);
    double off[2] = {fabs(to.y), fabs(to.x)};
    for (int k = 0; k < 2; k++) {
        double far = off[k] + 1e-3 * vec2_length(to); /* of ends equally in line, the nearest */
        if (off[k] > ask->reach || far >= aligned->best[k])
            continue;
        aligned->best[k] = far;
        aligned->ends[k] = end;
        aligned->ids[k] = id;
        aligned->own[k] = own;
    }
}

static void offer_axes(Search *search) {
    const Plan *plan = search->plan;
    const SnapAsk *ask = search->ask;
    Aligned aligned = {.best = {HUGE_VAL, HUGE_VAL}};
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t i = 0; i < plan->walls[w].points.count && !is_without(ask, plan->walls[w].id); i++)
            offer_end(ask, &aligned, plan->walls[w].points.at[i], plan->walls[w].id, false);
    for (size_t i = 0; i + 1 < ask->own_count; i++)
        offer_end(ask, &aligned, ask->own[i], i ? "a point of it" : "the first point", true);
    for (int k = 0; k < 2; k++) {
        Line *line = aligned.ids[k] ? offer_line(search, (Line){.origin = aligned.ends[k],
                                                                .axis = snap_heading(90 * k),
                                                                .low = -HUGE_VAL,
                                                                .high = HUGE_VAL,
                                                                .cost = COST_AXIS,
                                                                .guide = aligned.ends[k]})
                                    : NULL;
        if (!line)
            continue;
        char name[SNAP_NAME];
        snprintf(name, sizeof name, "%s", aligned.ids[k]);
        if (!aligned.own[k])
            snap_name(plan, ask, aligned.ids[k], aligned.ends[k], name);
        snprintf(line->text, sizeof line->text, "in line with %s", name);
    }
}

static void offer_ray(Search *search, double angle) {
    const Vec2 from = *search->ask->from;
    if (vec2_distance(from, search->ask->at) <= search->ask->reach)
        return;
    Line *line = offer_line(
        search, (Line){.origin = from, .axis = snap_heading(angle), .high = HUGE_VAL, .cost = COST_RAY, .guide = from});
    if (line)
        snprintf(line->text, sizeof line->text, "%g degrees", angle);
}

static void offer_rays(Search *search) {
    const SnapAsk *ask = search->ask;
    double angle = snap_angle(vec2_sub(ask->at, *ask->from)), near = snap_turn(angle, false);
    offer_ray(search, near);
    if (!isfinite(ask->along))
        return;
    double turned = remainder(ask->along + snap_turn(angle - ask->along, false), 360);
    if (fabs(remainder(turned - near, 360)) > 0.01)
        offer_ray(search, snap_tidy(turned));
}

static void offer_lines(Search *search) {
    const SnapAsk *ask = search->ask;
    const Plan *plan = search->plan;
    if (ask->from && !ask->straight)
        offer_rays(search);
    for (size_t w = 0; w < plan->wall_count; w++)
        if (!is_without(ask, plan->walls[w].id))
            offer_wall(search, &plan->walls[w]);
    for (size_t f = 0; ask->faces && f < plan->furniture_count; f++) {
        Vec2 corners[4];
        plan_geometry_corners(&plan->furniture[f], corners);
        for (int i = 0; i < 4 && !is_without(ask, plan->furniture[f].id); i++)
            offer_segment(search, corners[i], corners[(i + 1) % 4], plan->furniture[f].id);
    }
    offer_axes(search);
}

/* Choosing -------------------------------------------------------------------------------------------------------- */

static void add_guide(Snap *snap, const Line *line) {
    if (line->drawn || snap->guide_count == SNAP_GUIDES)
        return;
    snap->guides[snap->guide_count][0] = line->guide;
    snap->guides[snap->guide_count++][1] = snap->at;
}

/* Finds the crossing of two lines, within both. */
static bool cross(const Line *a, const Line *b, Vec2 *at) {
    double turn = vec2_cross(a->axis, b->axis);
    if (fabs(turn) < STEEP)
        return false;
    double s = vec2_cross(vec2_sub(b->origin, a->origin), b->axis) / turn;
    *at = vec2_along(a->origin, s, a->axis);
    double t = along_of(b, *at);
    return s >= a->low && s <= a->high && t >= b->low && t <= b->high;
}

static bool choose_crossing(Search *search) {
    const SnapAsk *ask = search->ask;
    double least = HUGE_VAL;
    for (size_t i = 0; i < search->line_count; i++)
        for (size_t j = i + 1; j < search->line_count; j++) {
            const Line *a = &search->lines[i], *b = &search->lines[j];
            Vec2 at;
            if (!cross(a, b, &at) || vec2_distance(at, ask->at) > ask->reach)
                continue;
            double cost = vec2_distance(at, ask->at) / ask->reach + a->cost + b->cost;
            if (cost >= least)
                continue;
            least = cost;
            search->snap = (Snap){.at = tidy(at)};
            snprintf(search->snap.text, SNAP_TEXT, "%s, %s", b->text, a->text);
            add_guide(&search->snap, a);
            add_guide(&search->snap, b);
        }
    return least < HUGE_VAL;
}

static bool choose_line(Search *search) {
    const SnapAsk *ask = search->ask;
    const Line *best = NULL;
    double least = HUGE_VAL;
    for (size_t i = 0; i < search->line_count; i++) {
        double cost = distance_to(&search->lines[i], ask->at) / ask->reach + search->lines[i].cost;
        if (cost < least) {
            least = cost;
            best = &search->lines[i];
        }
    }
    if (!best)
        return false;
    double along = real_clamp(to_grid(along_of(best, ask->at), SNAP_GRID), best->low, best->high);
    search->snap = (Snap){.at = tidy(vec2_along(best->origin, along, best->axis))};
    snprintf(search->snap.text, SNAP_TEXT, "%s", best->text);
    add_guide(&search->snap, best);
    return true;
}

/* Snaps along one axis: to a whole centimetre, or in line with an end. */
static Snap snap_straight(Search *search) {
    const SnapAsk *ask = search->ask;
    Vec2 to = vec2_sub(ask->at, *ask->from);
    bool upright = fabs(to.y) > fabs(to.x);
    Snap snap = {.at = *ask->from};
    double *moves = upright ? &snap.at.y : &snap.at.x, wanted = upright ? ask->at.y : ask->at.x;
    *moves = to_grid(wanted, ask->free ? SNAP_FREE_GRID : SNAP_GRID);
    snprintf(snap.text, sizeof snap.text, upright ? "straight up" : "straight across");
    if (ask->free)
        return snap;
    double least = ask->reach;
    char name[SNAP_NAME];
    for (size_t w = 0; w < search->plan->wall_count; w++)
        for (size_t i = 0; i < search->plan->walls[w].points.count; i++) {
            const Wall *wall = &search->plan->walls[w];
            double end = upright ? wall->points.at[i].y : wall->points.at[i].x;
            if (is_without(ask, wall->id) || fabs(end - wanted) >= least)
                continue;
            least = fabs(end - wanted);
            *moves = end;
            snap.guide_count = 1;
            snap.guides[0][0] = wall->points.at[i];
            snap_name(search->plan, ask, wall->id, wall->points.at[i], name);
            snprintf(snap.text, sizeof snap.text, "in line with %s", name);
        }
    snap.guides[0][1] = snap.at;
    return snap;
}

Snap snap_point(const Plan *plan, const SnapAsk *ask) {
    Search search = {.plan = plan, .ask = ask, .best = HUGE_VAL};
    if (ask->straight && ask->from)
        return snap_straight(&search);
    double grid = ask->free ? SNAP_FREE_GRID : SNAP_GRID;
    Snap quiet = {.at = vec2(to_grid(ask->at.x, grid), to_grid(ask->at.y, grid))};
    if (ask->free)
        return quiet;
    offer_points(&search);
    if (search.best < HUGE_VAL)
        return search.snap;
    offer_lines(&search);
    return choose_crossing(&search) || choose_line(&search) ? search.snap : quiet;
}

bool snap_wall(const Plan *plan, Vec2 at, SnapWall *nearest) {
    nearest->distance = HUGE_VAL;
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t s = 0; s + 1 < plan->walls[w].points.count; s++) {
            const Vec2 *ends = plan->walls[w].points.at + s;
            Vec2 foot = vec2_nearest_on_segment(at, ends[0], ends[1]);
            double distance = vec2_distance(at, foot);
            if (distance < nearest->distance)
                *nearest = (SnapWall){w, s, vec2_distance(ends[0], foot), vec2_distance(ends[0], ends[1]), distance};
        }
    return nearest->distance < HUGE_VAL;
}
