#include "route/march.h"

#include <stdint.h>

#include "base/memory.h"
#include "route/fast_marching.h"
#include "space/outline.h"

/* Times are those of a front (front.c) that starts at the goal. The slowness, s/m, of a place is
 *
 *     s = (1 + k (1 - c / m)^2) / v        for a clearance c = d - r below m, else 1 / v,
 *
 * v the speed, m/s, d the distance of the nearest obstacle, r the disc's radius, m MARCH_MARGIN, all m, and k
 * MARCH_DISCOMFORT, 1. h is the grid's cell, m.
 *
 * Passable points: d > r; also r - h/2 < d <= r where the disc, moved straight away from what is nearest until it just
 * touches, is free. So no gap narrower than the disc by more than about h^2 / (4 r) is passed, and every one 5 cm wider
 * has a chain of neighbours through it at any angle for h up to 0.11 m. Squeezed: any other with d > h/2. Blocked: the
 * rest. As an edge of the grid that crosses a wall has an end within h/2 of it, no time goes through a wall, however
 * thin.
 *
 * Doors that can be opened add to the slowness b(x) delay, b the hat function of the distance from the door's line,
 * 2 DOOR_BAND h wide: its sum over grid points times h is 1 wherever the line lies.
 *
 * Exits are lines that have to be crossed:
 *
 *              outside   ^  ^  ^        T is 0 on the line. NeighbourList the line, directions are straight across it,
 * away from
 *     ------+- - e1 - - - - - +------   the side on which the place is, however near: so nobody turns back before it.
 *           |  inside    ^    |         Where only one side is outside, they go on for MARCH_BEYOND behind it. */

#define DOOR_BAND 2.0  /* cells, half the width of the hat function */
#define EXIT_BAND 1.5  /* cells, about an exit's line where directions are across it */
#define SEEDED 2.5     /* cells, about an exit's line where times are given: both orders then begin on one side */
#define SQUEEZED 3.0   /* 1, times the slowness beside a wall: the way out of a squeeze is the short one */
#define PUSHED_OFF 1.5 /* cells: from so far off a wall, no neighbour in the grid lies behind it */
#define KINK 0.8       /* 1, length of a mean direction below which its parts are two different ways */
#define OUTSIDE 5.0    /* m, from the edge of the grid: a side of an exit that is reached within this is outside */
#define CLEARLY 2.0    /* m, by which the other side must be farther away */
#define TOUCHING 1e-4  /* m, rounding of the grid of distances */

enum { UNIT = 127, BLOCKED = INT8_MIN, BLOCKED_WALL = 0, BLOCKED_EXIT = 1, MOST_PUSHES = 3 };

static const int neighbours[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

static Vec2 point_place(const March *march, int i, int j) {
    return vec2(march->origin.x + i * march->cell, march->origin.y + j * march->cell);
}

static size_t point_at(const March *march, int i, int j) {
    return (size_t)j * (size_t)march->nx + (size_t)i;
}

static bool inside_grid(const March *march, int i, int j) {
    return i >= 0 && j >= 0 && i < march->nx && j < march->ny;
}

/* Where the nearest obstacle's nearest point is, from `at`: the unit vector away from it and its distance, m, negative
 * inside of solids; false: none within `reach` m. */
static bool nearest_obstacle(const FreeSpace *space, Vec2 at, double reach, Vec2 *away, double *distance) {
    int index;
    *distance = freespace_exact(space, at, reach, &index);
    if (index < 0)
        return false;
    const Face *face = &space->outline->faces[index];
    *away = vec2_unit(vec2_sub(at, vec2_nearest_on_segment(at, face->a, face->b)));
    if (*distance < TOUCHING)
        *away = face->normal;
    else if (freespace_distance(space, at) < 0 && vec2_dot(*away, face->normal) < 0) {
        *away = vec2_scale(*away, -1);
        *distance = -*distance;
    }
    return true;
}

/* Is the disc free when it is moved off what it overlaps at this place? */
static bool almost_passable(const March *march, Vec2 at) {
    Vec2 away;
    double distance;
    if (!nearest_obstacle(march->space, at, march->radius, &away, &distance))
        return true;
    Vec2 off = vec2_along(at, march->radius - distance, away);
    return freespace_exact(march->space, off, march->radius, NULL) > march->radius - TOUCHING;
}

static void classify(const March *march, FastMarching *front, int stride) {
    const FreeSpace *space = march->space;
    double blocked = march->cell / 2, doubtful = fmax(march->radius - march->cell / 2, blocked);
    for (int j = 0; j < march->ny; j++)
        for (int i = 0; i < march->nx; i++) {
            size_t point = point_at(march, i, j);
            double distance = (double)space->distance[(size_t)(j * stride) * (size_t)space->nx + (size_t)(i * stride)];
            bool passable = distance > doubtful && (distance > fmax(march->radius, blocked) ||
                                                    almost_passable(march, point_place(march, i, j)));
            double lack = fmin(fmax(1 - (distance - march->radius) / MARCH_MARGIN, 0), 1);
            front->states[point] = passable             ? FAST_MARCHING_PASSABLE
                                   : distance > blocked ? FAST_MARCHING_SQUEEZED
                                                        : FAST_MARCHING_BLOCKED;
            front->slowness[point] = (float)((1 + MARCH_DISCOMFORT * lack * lack) / march->speed);
            if (!passable)
                front->slowness[point] *= (float)SQUEEZED;
        }
}

/* The grid points in a box: first to last in both coordinates; none when last < first. */
typedef struct Range {
    int first_x, last_x, first_y, last_y;
} Range;

static Range range_of(const March *march, Box box) {
    double nx = march->nx, ny = march->ny;
    return (Range){(int)fmin(fmax(ceil((box.low.x - march->origin.x) / march->cell), 0), nx),
                   (int)fmax(fmin(floor((box.high.x - march->origin.x) / march->cell), nx - 1), -1),
                   (int)fmin(fmax(ceil((box.low.y - march->origin.y) / march->cell), 0), ny),
                   (int)fmax(fmin(floor((box.high.y - march->origin.y) / march->cell), ny - 1), -1)};
}

static Range range_about(const March *march, Vec2 from, Vec2 to, double reach) {
    return range_of(march, box_expand(box_include(box_include(box_empty(), from), to), reach));
}

static void slow_at_doors(const March *march, FastMarching *front, const Plan *plan) {
    double band = DOOR_BAND * march->cell;
    for (size_t d = 0; d < plan->door_count; d++) {
        if (!outline_door_moves(&plan->doors[d]))
            continue;
        Vec2 from, to;
        plan_door_ends(plan, &plan->doors[d], &from, &to);
        Range range = range_about(march, from, to, band);
        for (int j = range.first_y; j <= range.last_y; j++)
            for (int i = range.first_x; i <= range.last_x; i++) {
                Vec2 at = point_place(march, i, j);
                double away = vec2_distance(at, vec2_nearest_on_segment(at, from, to)) / band;
                if (away < 1)
                    front->slowness[point_at(march, i, j)] += (float)((1 - away) / band * plan->doors[d].opening_time);
            }
    }
}

/* Is a disc's centre free of obstacles all along a straight line? */
static bool sees(const FreeSpace *space, Vec2 from, Vec2 to, double distance) {
    int parts = (int)ceil(vec2_distance(from, to) / space->cell);
    for (int part = 0; part <= parts; part++)
        if (freespace_distance(space, vec2_along(from, (double)part / fmax(parts, 1), vec2_sub(to, from))) < distance)
            return false;
    return true;
}

/* The points within half the goal's radius that see it, which keeps those on the other side of a wall out. */
static void seed_place(const March *march, FastMarching *front) {
    const Goal *goal = &march->goal;
    double reach = fmax(goal->radius / 2, 2 * march->cell);
    Range range = range_about(march, goal->at, goal->at, reach);
    for (int j = range.first_y; j <= range.last_y; j++)
        for (int i = range.first_x; i <= range.last_x; i++) {
            Vec2 at = point_place(march, i, j);
            double away = vec2_distance(at, goal->at);
            if (away <= reach && sees(march->space, at, goal->at, 0))
                fast_marching_give(front, i, j, (away - goal->radius) / march->speed);
        }
}

/* How far along an exit's line and to the left of it a place is, m. */
static Vec2 exit_frame(const MarchExit *exit, Vec2 at) {
    return vec2_unturn(vec2_sub(at, exit->from), exit->along);
}

/* A place that has the line, but for a bit of its ends, before it. */
static bool before_line(const MarchExit *exit, Vec2 frame, double end, double reach) {
    double margin = fmin(end, exit->length / 4);
    return fabs(frame.y) <= reach && frame.x >= margin && frame.x <= exit->length - margin;
}

static void seed_exit(const March *march, FastMarching *front, const MarchExit *exit) {
    double reach = SEEDED * march->cell;
    Range range = range_about(march, exit->from, vec2_along(exit->from, exit->length, exit->along), reach);
    for (int j = range.first_y; j <= range.last_y; j++)
        for (int i = range.first_x; i <= range.last_x; i++) {
            Vec2 at = point_place(march, i, j), frame = exit_frame(exit, at);
            if (before_line(exit, frame, march->cell, reach) &&
                sees(march->space, vec2_along(exit->from, frame.x, exit->along), at, 0))
                fast_marching_give(front, i, j, fabs(frame.y) / march->speed);
        }
}

static MarchExit exit_make(const Exit *line) {
    Vec2 along = vec2_sub(line->to, line->from);
    return (MarchExit){.from = line->from, .along = vec2_unit(along), .length = vec2_length(along)};
}

/* How far, in steps, the points within OUTSIDE of the grid's edge are from it without crossing any exit; infinite
 * elsewhere. Breadth first. */
static float *steps_outside(const March *march, const FastMarching *front, const Plan *plan) {
    size_t points = (size_t)march->nx * (size_t)march->ny, count = 0, capacity = 0;
    float *steps = memory_zeroed(points, sizeof *steps), most = (float)(OUTSIDE / march->cell);
    int *queue = NULL;
    for (size_t p = 0; p < points; p++)
        steps[p] = HUGE_VALF;
    for (size_t e = 0; e < plan->exit_count; e++) {
        MarchExit exit = exit_make(&plan->exits[e]);
        Range range = range_about(march, plan->exits[e].from, plan->exits[e].to, march->cell);
        for (int j = range.first_y; j <= range.last_y; j++)
            for (int i = range.first_x; i <= range.last_x; i++)
                if (before_line(&exit, exit_frame(&exit, point_place(march, i, j)), 0, 0.75 * march->cell))
                    steps[point_at(march, i, j)] = -1;
    }
    for (int p = 0; p < (int)points; p++) {
        int i = p % march->nx, j = p / march->nx;
        bool edge = i == 0 || j == 0 || i == march->nx - 1 || j == march->ny - 1;
        if (!edge || front->states[p] != FAST_MARCHING_PASSABLE || steps[p] < 0)
            continue;
        queue = memory_reserve(queue, &capacity, count + 1, sizeof *queue);
        queue[count++] = p;
        steps[p] = 0;
    }
    for (size_t taken = 0; taken < count && steps[queue[taken]] < most; taken++)
        for (int n = 0; n < 4; n++) {
            int i = queue[taken] % march->nx + neighbours[n][0], j = queue[taken] / march->nx + neighbours[n][1];
            if (!inside_grid(march, i, j))
                continue;
            size_t point = point_at(march, i, j);
            if (front->states[point] != FAST_MARCHING_PASSABLE || steps[point] < HUGE_VALF)
                continue;
            steps[point] = steps[queue[taken]] + 1;
            queue = memory_reserve(queue, &capacity, count + 1, sizeof *queue);
            queue[count++] = (int)point;
        }
    memory_free(queue);
    return steps;
}

/* Which side of the line is outside: the one from which it is clearly nearer to the edge of the grid. */
static int outward_side(const March *march, const MarchExit *exit, const float *steps) {
    double left = HUGE_VAL, right = HUGE_VAL, reach = 3 * march->cell;
    Range range = range_about(march, exit->from, vec2_along(exit->from, exit->length, exit->along), reach);
    for (int j = range.first_y; j <= range.last_y; j++)
        for (int i = range.first_x; i <= range.last_x; i++) {
            Vec2 frame = exit_frame(exit, point_place(march, i, j));
            double away = (double)steps[point_at(march, i, j)] * march->cell;
            if (away < 0 || !before_line(exit, frame, march->cell, reach))
                continue;
            double *side = frame.y > 0 ? &left : &right;
            *side = fmin(*side, away);
        }
    return left + CLEARLY < right ? 1 : right + CLEARLY < left ? -1 : 0;
}

static void find_exits(March *march, const FastMarching *front, const Plan *plan) {
    march->exits = memory_zeroed(plan->exit_count, sizeof *march->exits);
    for (size_t e = 0; e < plan->exit_count; e++)
        if (field_exit_usable(&march->goal, plan, e))
            march->exits[march->exit_count++] = exit_make(&plan->exits[e]);
    float *steps = steps_outside(march, front, plan);
    for (size_t e = 0; e < march->exit_count; e++)
        march->exits[e].outward = outward_side(march, &march->exits[e], steps);
    memory_free(steps);
}

static void set_direction(March *march, size_t point, Vec2 direction) {
    march->directions[point][0] = (signed char)lrint(UNIT * direction.x);
    march->directions[point][1] = (signed char)lrint(UNIT * direction.y);
}

static void find_directions(March *march, const FastMarching *front) {
    for (int j = 0; j < march->ny; j++)
        for (int i = 0; i < march->nx; i++) {
            size_t point = point_at(march, i, j);
            if (front->states[point] == FAST_MARCHING_BLOCKED) {
                march->directions[point][0] = BLOCKED;
                march->directions[point][1] = BLOCKED_WALL;
            } else {
                set_direction(march, point, fast_marching_downhill(front, i, j));
            }
        }
}

static int side_of(double left) {
    return left > 0 ? 1 : -1;
}

/* Straight across the line, away from the side on which the place is, or out. */
static Vec2 across(const MarchExit *exit, Vec2 frame) {
    return vec2_scale(vec2_left(exit->along), exit->outward ? exit->outward : -side_of(frame.y));
}

static void direct_exit(March *march, const MarchExit *exit) {
    double beyond = exit->outward ? MARCH_BEYOND : 0, reach = fmax(beyond, march->cell);
    Range range = range_about(march, exit->from, vec2_along(exit->from, exit->length, exit->along), reach);
    for (int j = range.first_y; j <= range.last_y; j++)
        for (int i = range.first_x; i <= range.last_x; i++) {
            size_t point = point_at(march, i, j);
            Vec2 at = point_place(march, i, j), frame = exit_frame(exit, at);
            if (!isfinite(march->time[point]) || !before_line(exit, frame, 0, reach))
                continue;
            double behind = frame.y * exit->outward;
            bool passed = exit->outward && behind > 0 && behind <= beyond &&
                          sees(march->space, vec2_along(exit->from, frame.x, exit->along), at, march->cell);
            if (passed) {
                march->time[point] = (float)(-behind / march->speed);
                set_direction(march, point, across(exit, frame));
            }
            if (fabs(frame.y) <= march->cell) {
                march->directions[point][0] = BLOCKED;
                march->directions[point][1] = BLOCKED_EXIT;
            }
        }
}

static void grid_make(March *march, int *stride) {
    const FreeSpace *space = march->space;
    *stride = 1;
    while ((double)(space->nx / *stride) * (space->ny / *stride) > MARCH_MOST_POINTS &&
           (*stride + 1) * space->cell <= MARCH_COARSEST)
        ++*stride;
    march->cell = *stride * space->cell;
    march->per_metre = 1 / march->cell;
    march->nx = (space->nx - 1) / *stride + 1;
    march->ny = (space->ny - 1) / *stride + 1;
    march->origin = space->origin;
    size_t points = (size_t)march->nx * (size_t)march->ny;
    march->time = memory_zeroed(points, sizeof *march->time);
    march->directions = memory_zeroed(points, sizeof *march->directions);
}

bool march_init(March *march, const Plan *plan, const FreeSpace *space, double radius, double speed, const Goal *goal) {
    int stride;
    *march = (March){.space = space, .goal = *goal, .radius = radius, .speed = speed};
    grid_make(march, &stride);
    FastMarching front;
    fast_marching_init(&front, march->nx, march->ny, march->cell, march->time);
    classify(march, &front, stride);
    slow_at_doors(march, &front, plan);
    if (goal->radius > 0)
        seed_place(march, &front);
    else
        find_exits(march, &front, plan);
    for (size_t e = 0; e < march->exit_count; e++)
        seed_exit(march, &front, &march->exits[e]);
    bool reachable = fast_marching_run(&front);
    fast_marching_squeeze(&front, (int)fmin(ceil(2 * radius / march->cell) + 1, FAST_MARCHING_MOST_STEPS));
    find_directions(march, &front);
    for (size_t e = 0; e < march->exit_count; e++)
        direct_exit(march, &march->exits[e]);
    fast_marching_clear(&front);
    return reachable;
}

void march_clear(March *march) {
    memory_free(march->time);
    memory_free(march->directions);
    memory_free(march->exits);
    *march = (March){0};
}

/* The cell of the grid that a place lies in, and where in it. */
typedef struct Spot {
    size_t low;  /* the lower left point */
    double u, v; /* 1, from 0 to 1 */
} Spot;

static inline bool spot_find(const March *march, Vec2 at, Spot *spot) {
    double x = (at.x - march->origin.x) * march->per_metre, y = (at.y - march->origin.y) * march->per_metre;
    if (!(x >= 0 && y >= 0 && x < march->nx - 1 && y < march->ny - 1))
        return false;
    int i = (int)x, j = (int)y;
    *spot = (Spot){point_at(march, i, j), x - i, y - j};
    return true;
}

static inline void spot_weights(const Spot *spot, double weights[4]) {
    weights[0] = (1 - spot->u) * (1 - spot->v);
    weights[1] = spot->u * (1 - spot->v);
    weights[2] = (1 - spot->u) * spot->v;
    weights[3] = spot->u * spot->v;
}

static inline bool spot_blocked(const March *march, const Spot *spot) {
    const signed char(*low)[2] = march->directions + spot->low, (*high)[2] = low + march->nx;
    return (low[0][0] == BLOCKED) | (low[1][0] == BLOCKED) | (high[0][0] == BLOCKED) | (high[1][0] == BLOCKED);
}

/* The mean direction of a cell's points, not of unit length; blocked ones count as they are written. */
static inline Vec2 spot_mean(const March *march, const Spot *spot) {
    const signed char(*low)[2] = march->directions + spot->low, (*high)[2] = low + march->nx;
    double u = spot->u, v = spot->v;
    double x = (1 - v) * (low[0][0] + u * (low[1][0] - low[0][0])) + v * (high[0][0] + u * (high[1][0] - high[0][0]));
    double y = (1 - v) * (low[0][1] + u * (low[1][1] - low[0][1])) + v * (high[0][1] + u * (high[1][1] - high[0][1]));
    return vec2(x, y);
}

/* The mean direction of a cell's points, blocked ones left out; that of the heaviest where they disagree. */
static Vec2 spot_direction(const March *march, const Spot *spot) {
    const signed char(*low)[2] = march->directions + spot->low, (*high)[2] = low + march->nx;
    const signed char *four[4] = {low[0], low[1], high[0], high[1]};
    double weights[4], whole = 0, most = -1;
    spot_weights(spot, weights);
    Vec2 sum = {0, 0}, heaviest = {0, 0};
    for (int n = 0; n < 4; n++) {
        Vec2 direction = {four[n][0], four[n][1]};
        if (four[n][0] == BLOCKED || !(four[n][0] | four[n][1]))
            continue;
        whole += weights[n];
        sum = vec2_along(sum, weights[n], direction);
        if (weights[n] > most) {
            most = weights[n];
            heaviest = direction;
        }
    }
    return vec2_unit(vec2_length(sum) < KINK * UNIT * whole ? heaviest : sum);
}

static double spot_time(const March *march, const Spot *spot) {
    const float *low = march->time + spot->low, *high = low + march->nx;
    const float four[4] = {low[0], low[1], high[0], high[1]};
    double weights[4], whole = 0, sum = 0, least = HUGE_VAL;
    spot_weights(spot, weights);
    for (int n = 0; n < 4; n++) {
        if (!isfinite(four[n]))
            continue;
        whole += weights[n];
        sum += weights[n] * (double)four[n];
        least = real_min(least, (double)four[n]);
    }
    double time = whole > 1e-6 ? sum / whole : least;
    return time < 0 ? 0 : time;
}

/* The exit's line that the place is next to, or NULL. */
static const MarchExit *exit_beside(const March *march, Vec2 at, Vec2 *frame) {
    for (size_t e = 0; e < march->exit_count; e++) {
        *frame = exit_frame(&march->exits[e], at);
        if (before_line(&march->exits[e], *frame, 0, EXIT_BAND * march->cell))
            return &march->exits[e];
    }
    return NULL;
}

/* A place moved so far off the nearest walls that its cell's points all lie on its side of them. `*away` and
 * `*distance` are those of the first wall; false: there is none so near. */
static bool push_off(const March *march, Vec2 *at, Vec2 *away, double *distance) {
    bool pushed = false;
    for (int n = 0; n < MOST_PUSHES; n++) {
        Vec2 direction;
        double off;
        if (!nearest_obstacle(march->space, *at, PUSHED_OFF * march->cell, &direction, &off))
            break;
        if (!pushed) {
            *away = direction;
            *distance = off;
        }
        pushed = true;
        *at = vec2_along(*at, PUSHED_OFF * march->cell - off, direction);
    }
    return pushed;
}

/* The direction where a wall or an exit passes through the cell. */
static Vec2 careful_direction(const March *march, Vec2 at) {
    Vec2 frame = {0, 0}, away, off = at;
    double distance;
    Spot spot;
    const MarchExit *exit = exit_beside(march, at, &frame);
    bool pushed = push_off(march, &off, &away, &distance);
    if (!spot_find(march, off, &spot))
        return vec2(0, 0);
    Vec2 direction = spot_direction(march, &spot);
    if (exit && isfinite(spot_time(march, &spot)))
        direction = across(exit, frame);
    if (!pushed || !(vec2_dot(direction, direction) > 0))
        return direction;
    double towards = real_min(vec2_dot(direction, away), 0);
    direction = vec2_along(direction, -towards, away);
    if (!exit || distance < 0)
        direction = vec2_along(direction, real_clamp(1 - distance / march->radius, 0, 1), away);
    direction = vec2_unit(direction);
    return vec2_dot(direction, direction) > 0 ? direction : away;
}

Vec2 march_direction(const March *march, Vec2 at) {
    Spot spot;
    if (!spot_find(march, at, &spot))
        return vec2(0, 0);
    if (spot_blocked(march, &spot))
        return careful_direction(march, at);
    Vec2 mean = spot_mean(march, &spot);
    double square = vec2_dot(mean, mean);
    if (square < KINK * UNIT * KINK * UNIT)
        return spot_direction(march, &spot);
    return vec2_scale(mean, 1 / sqrt(square));
}

double march_time(const March *march, Vec2 at) {
    Spot spot;
    Vec2 away;
    double distance;
    if (!spot_find(march, at, &spot))
        return HUGE_VAL;
    if (spot_blocked(march, &spot) && push_off(march, &at, &away, &distance) && !spot_find(march, at, &spot))
        return HUGE_VAL;
    return spot_time(march, &spot);
}
