#include "route/disc_route.h"

#include <stdint.h>

#include "base/memory.h"
#include "base/real.h"

/* Descends the field of times from grid point to grid point, then pulls the path taut: from each point on, the farthest
 * point that is visible along a straight line with the clearance COMFORT, or with the clearance of the skipped points
 * if that is less, replaces all points between. Where the disc finds no way between the points of the grid, those
 * within a cell of a way count as well, and are moved to it. Lines are checked by sphere tracing (Hart 1996): where the
 * nearest obstacle is d away from the disc, the next d of the line are free. */

#define COMFORT 0.05        /* m, clearance that is preserved where there is that much */
#define TIGHT 0.002         /* m, clearance at grid points: the chords between them round a corner lose at most 1 mm */
#define SMALLEST_STEP 0.002 /* m, smallest step of sphere tracing */
#define SPACING 0.05        /* m, between poses */
#define BEYOND 0.3          /* m, straight continuation across an exit's line */
#define FINER 4.0           /* 1, refinement of the grid for the second search */

#define CLEAR 0.002 /* m, from an obstacle that the disc overlapped */

enum { PASSES = 4, LIFTS = 4 };

typedef struct Line {
    Vec2 *at; /* (count) */
    size_t count, capacity;
} Line;

static void line_add(Line *line, Vec2 at) {
    line->at = memory_reserve(line->at, &line->capacity, line->count + 1, sizeof *line->at);
    line->at[line->count++] = at;
}

/* Returns the least distance to an obstacle on a straight line, m, at most FREESPACE_FARTHEST; stops as soon as it is
 * below `enough`. */
static double least_distance(const FreeSpace *space, Vec2 from, Vec2 to, double enough) {
    double length = vec2_distance(from, to), least = FREESPACE_FARTHEST;
    Vec2 along = vec2_unit(vec2_sub(to, from));
    for (double gone = 0;;) {
        double distance = freespace_exact(space, vec2_along(from, gone, along), FREESPACE_FARTHEST, NULL);
        least = fmin(least, distance);
        if (least < enough || gone >= length)
            return least;
        gone = fmin(gone + fmax(distance - enough, SMALLEST_STEP), length);
    }
}

static Vec2 grid_place(const FreeSpace *space, int i, int j) {
    return vec2(space->origin.x + i * space->cell, space->origin.y + j * space->cell);
}

/* Collects the grid points downhill from a place to where the field is 0. */
static bool walk_down(const Field *field, Vec2 start, double radius, Line *line) {
    const FreeSpace *space = field->ground->space;
    int i = (int)floor((start.x - space->origin.x) / space->cell),
        j = (int)floor((start.y - space->origin.y) / space->cell);
    double best = HUGE_VAL;
    int at_x = -1, at_y = -1;
    line_add(line, start);
    for (int n = 0; n < 16; n++) { /* the start lies between grid points: choose the best one around it */
        int x = i - 1 + n % 4, y = j - 1 + n / 4;
        if (x < 0 || y < 0 || x >= space->nx || y >= space->ny)
            continue;
        Vec2 at = grid_place(space, x, y);
        field_know(field, x, y, x + 1, y + 1);
        double time = (double)field->time[(size_t)y * (size_t)space->nx + (size_t)x] +
                      vec2_distance(start, at) / field->ground->profile->free_speed;
        if (time < best && least_distance(space, start, at, radius) >= radius) {
            best = time;
            at_x = x;
            at_y = y;
        }
    }
    if (at_x < 0)
        return false;
    for (;;) {
        Vec2 here = grid_place(space, at_x, at_y);
        line_add(line, here);
        double time = (double)field->time[(size_t)at_y * (size_t)space->nx + (size_t)at_x];
        if (time <= 0)
            return true;
        int next_x = -1, next_y = -1;
        best = HUGE_VAL;
        for (int y = at_y - 1; y <= at_y + 1; y++)
            for (int x = at_x - 1; x <= at_x + 1; x++) {
                if (x < 0 || y < 0 || x >= space->nx || y >= space->ny || (x == at_x && y == at_y))
                    continue;
                field_know(field, x, y, x + 1, y + 1);
                double there = (double)field->time[(size_t)y * (size_t)space->nx + (size_t)x];
                if (!(there < time))
                    continue;
                Vec2 to = grid_place(space, x, y);
                double slope = (there - time + field_delay(field->ground, here, to)) / vec2_distance(here, to);
                if (slope < best) {
                    best = slope;
                    next_x = x;
                    next_y = y;
                }
            }
        if (next_x < 0)
            return false;
        at_x = next_x;
        at_y = next_y;
    }
}

/* Moves the points of a line that lack room towards the middle between what is near and what is opposite. Returns false
 * if a motion from point to point is not free then. */
static bool lift(Line *line, const FreeSpace *space, double radius) {
    for (size_t i = 1; i < line->count; i++)
        for (int n = 0; n < LIFTS; n++) {
            int near, opposite;
            Vec2 *at = &line->at[i];
            double lack = radius + TIGHT - freespace_exact(space, *at, radius + TIGHT, &near);
            if (!(lack > 0) || near < 0)
                break;
            const Face *face = &space->outline->faces[near];
            Vec2 off = vec2_sub(*at, vec2_nearest_on_segment(*at, face->a, face->b)), away = vec2_unit(off);
            double room = outline_ray(space->outline, *at, away, FREESPACE_FARTHEST, &opposite);
            *at = vec2_along(*at, fmin(lack, (room - vec2_length(off)) / 2), away);
        }
    for (size_t i = 1; i < line->count; i++)
        if (least_distance(space, line->at[i - 1], line->at[i], radius) < radius)
            return false;
    return true;
}

/* Continues straight across the exit at the end of the line. */
static bool cross_exit(Line *line, const FreeSpace *space, const Plan *plan, const Goal *goal, double radius) {
    Vec2 last = line->at[line->count - 1], across = {0, 0}, foot = last;
    double nearest = HUGE_VAL;
    for (size_t e = 0; e < plan->exit_count; e++) {
        if (!field_exit_usable(goal, plan, e))
            continue;
        Vec2 on = vec2_nearest_on_segment(last, plan->exits[e].from, plan->exits[e].to);
        if (vec2_distance(last, on) < nearest) {
            nearest = vec2_distance(last, on);
            across = vec2_unit(vec2_left(vec2_sub(plan->exits[e].to, plan->exits[e].from)));
            /* Direction away from the earlier part of the line. */
            Vec2 before = line->at[line->count > 8 ? line->count - 8 : 0];
            if (vec2_dot(across, vec2_sub(before, on)) > 0)
                across = vec2_scale(across, -1);
            foot = on;
        }
    }
    /* The field is 0 on both sides of the exit's line: drop points that are already beyond. */
    while (line->count > 1 && vec2_dot(across, vec2_sub(line->at[line->count - 1], foot)) > 0)
        line->count--;
    last = line->at[line->count - 1];
    for (double beyond = BEYOND; beyond > 0.01; beyond /= 2) {
        Vec2 out = vec2_along(foot, beyond, across);
        size_t exit;
        if (field_goal_reached(goal, plan, last, out, &exit) && least_distance(space, last, out, radius) >= radius) {
            line_add(line, out);
            return true;
        }
    }
    return false;
}

static Line pulled(const Line *line, const FreeSpace *space, double radius) {
    Line taut = {0};
    line_add(&taut, line->at[0]);
    /* The ends may stand close to an obstacle; other points need not. */
    size_t first = 0, last = line->count - 1;
    while (first < last && freespace_exact(space, line->at[first], FREESPACE_FARTHEST, NULL) < radius + COMFORT)
        line_add(&taut, line->at[++first]);
    while (last > first && freespace_exact(space, line->at[last], FREESPACE_FARTHEST, NULL) < radius + COMFORT)
        last--;
    for (size_t from = first; from < last;) {
        size_t to = from + 1;
        double kept = least_distance(space, line->at[from], line->at[to], radius);
        while (to < last) {
            double next = fmin(kept, least_distance(space, line->at[to], line->at[to + 1], radius));
            double enough = fmin(next, radius + COMFORT);
            if (least_distance(space, line->at[from], line->at[to + 1], enough) < enough)
                break;
            kept = next;
            to++;
        }
        line_add(&taut, line->at[to]);
        from = to;
    }
    while (last + 1 < line->count)
        line_add(&taut, line->at[++last]);
    return taut;
}

static Line spaced(const Line *line) {
    Line result = {0};
    line_add(&result, line->at[0]);
    for (size_t i = 1; i < line->count; i++) {
        int parts = (int)fmax(ceil(vec2_distance(line->at[i - 1], line->at[i]) / SPACING), 1);
        for (int part = 1; part <= parts; part++)
            line_add(&result,
                     vec2_along(line->at[i - 1], (double)part / parts, vec2_sub(line->at[i], line->at[i - 1])));
    }
    return result;
}

static Line line_reversed(const Line *line) {
    Line result = {0};
    for (size_t i = line->count; i > 0; i--)
        line_add(&result, line->at[i - 1]);
    return result;
}

static void line_replace(Line *line, Line by) {
    memory_free(line->at);
    *line = by;
}

/* Returns the shortest line with poses' spacing into which a line can be pulled. */
static Line tautened(const Line *line, const FreeSpace *space, double radius) {
    Line taut = spaced(line);
    for (int pass = 0; pass < PASSES; pass++) { /* alternately forwards and backwards */
        line_replace(&taut, pulled(&taut, space, radius));
        line_replace(&taut, line_reversed(&taut));
        line_replace(&taut, spaced(&taut));
    }
    return taut;
}

/* Returns the exit that a line crosses last, or SIZE_MAX. */
static size_t exit_crossed(const Line *line, const Plan *plan, const Goal *goal) {
    size_t crossed = SIZE_MAX, exit;
    for (size_t i = 1; i < line->count; i++)
        if (field_goal_reached(goal, plan, line->at[i - 1], line->at[i], &exit))
            crossed = exit;
    return crossed;
}

/* Tautens a line that ends across an exit. If it would then pass beside the exit, only the part before the last motion,
 * which crosses the exit, is tautened. */
static void tauten_across(Line *line, const FreeSpace *space, const Plan *plan, const Goal *goal, double radius) {
    Line taut = tautened(line, space, radius);
    if (exit_crossed(&taut, plan, goal) == SIZE_MAX) {
        Vec2 out = line->at[--line->count];
        line_replace(&taut, tautened(line, space, radius));
        line_add(&taut, out);
        line_replace(&taut, spaced(&taut));
    }
    line_replace(line, taut);
}

static void write_poses(SearchTrack *track, const Line *line, const FreeSpace *space, double radius) {
    double heading = track->poses[track->count - 1].heading;
    for (size_t i = 1; i < line->count; i++) {
        Vec2 along = vec2_sub(line->at[i], line->at[i - 1]);
        if (vec2_length(along) > 1e-9)
            heading += vec2_wrap_angle(real_atan2(along.y, along.x) - heading);
        double clearance = freespace_exact(space, line->at[i], radius + ROUTE_CLEARANCE_REACH, NULL) - radius;
        search_track_add(track, (Pose){line->at[i], heading, clearance, 1});
    }
}

bool disc_route_leg(SearchTrack *track, Fields *fields, const Plan *plan, const FreeSpace *space,
                    const Profile *profile, double radius, const Goal *goal, bool lifts) {
    Vec2 start = track->poses[track->count - 1].at;
    Line line = {0};
    FieldKey key = {plan, space, profile, lifts ? radius : radius + TIGHT, !lifts, *goal, NULL, {.count = 0}};
    const Field *field = fields_acquire(fields, &key);
    bool found = walk_down(field, start, lifts ? fmax(radius - space->cell, 0) : radius, &line) &&
                 (!lifts || lift(&line, space, radius)) &&
                 (goal->radius > 0 || cross_exit(&line, space, plan, goal, radius));
    if (found) {
        if (goal->radius > 0) {
            line_replace(&line, tautened(&line, space, radius));
        } else {
            tauten_across(&line, space, plan, goal, radius);
            track->exit = exit_crossed(&line, plan, goal);
        }
        write_poses(track, &line, space, radius);
    }
    memory_free(line.at);
    fields_release(fields, field);
    return found;
}

/* Plans all legs on one grid. */
static bool find_on(SearchTrack *track, Fields *fields, const FreeSpace *space, const RouteQuery *query,
                    const Goal *goals, size_t goal_count, double radius, bool lifts) {
    double clearance = freespace_exact(space, query->at, radius + ROUTE_CLEARANCE_REACH, NULL) - radius;
    search_track_clear(track);
    search_track_add(track, (Pose){query->at, query->heading, clearance, 0});
    for (size_t leg = 0; leg < goal_count; leg++)
        if (!disc_route_leg(track, fields, query->plan, space, query->profile, radius, &goals[leg], lifts))
            return false;
    return true;
}

bool disc_route_find(SearchTrack *track, const RouteQuery *query, const Goal *goals, size_t goal_count, double radius) {
    if (find_on(track, query->fields, query->space, query, goals, goal_count, radius, false))
        return true;
    if (stop_requested(query->stop))
        return false;
    FreeSpace fine;                /* gaps hardly wider than the disc slip between the points of a coarse grid */
    Fields *own = fields_create(); /* `fine` does not outlive this */
    freespace_build(&fine, query->space->outline, query->space->cell / FINER);
    bool found = find_on(track, own, &fine, query, goals, goal_count, radius, false) ||
                 (!stop_requested(query->stop) && find_on(track, own, &fine, query, goals, goal_count, radius, true));
    fields_destroy(own);
    freespace_free(&fine);
    return found;
}
