#include "route/floor_field.h"

#include <stdint.h>

#include "base/memory.h"
#include "plan/plan_geometry.h"
#include "route/fast_marching.h"
#include "space/outline.h"

/* Times are those of a front (fast_marching.c) that starts at the goal. The slowness, s/m, of a place is
 *
 *     s = (1 + k (1 - c / m)^2) / v        for a clearance c = d - r below m, else 1 / v,
 *
 * v the speed, m/s, d the distance of the nearest obstacle, r the disc's radius, m FLOOR_FIELD_MARGIN, all m, and k
 * FLOOR_FIELD_DISCOMFORT, 1. h is the grid's cell, m.
 *
 * Passable points: d > r; also r - h/2 < d <= r where the disc is free after it is moved straight away from the nearest
 * obstacle until it just touches it; in a gap less than about h wider than the disc, r - 3h/4 < d <= r, since the
 * points within h / sqrt(2) of a line are a chain of neighbours at any angle. So no gap narrower than the disc by more
 * than about h^2 / (4 r) is passed, and every wider one is. Squeezed: any other with d > h/2. Blocked: the rest. As an
 * edge of the grid that crosses a wall has an end within h/2 of it, no time goes through a wall, however thin.
 *
 * Doors that can be opened add to the slowness b(x) delay, b the hat function of the distance from the door's line,
 * 2 DOOR_BAND h wide: its sum over grid points times h is 1 wherever the line lies.
 *
 * Exits are lines that have to be crossed:
 *
 *              outside   ^  ^  ^        T is 0 on the line. Near the line, directions lead straight across, away from
 *     ------+- - e1 - - - - - +------   the side on which the place is, however near: so no walker turns back.
 *           |  inside    ^    |         Where only one side is outside, they go on for FLOOR_FIELD_BEYOND behind it. */

#define DOOR_BAND 2.0  /* cells, half the width of the hat function */
#define EXIT_BAND 1.5  /* cells, about an exit's line where directions are perpendicular to it */
#define SEEDED 2.5     /* cells, about an exit's line where times are given: both orders then begin on one side */
#define SQUEEZED 3.0   /* 1, times the slowness next to a wall: makes the path out of a squeeze the short one */
#define DOUBTFUL 0.75  /* cells, by which a passable point may lack room */
#define OPPOSITE 0.5   /* 1, cosine of the angle up to which two obstacles are opposite: those of a corner are not */
#define PUSHED_OFF 1.5 /* cells: at this distance from a wall, no neighbouring grid point lies behind it */
#define KINK 0.8       /* 1, length of a mean direction below which its parts are two different paths */
#define OUTSIDE 5.0   /* m, from the edge of the grid: a side of an exit that reaches the edge within this is outside */
#define CLEARLY 2.0   /* m, by which the other side must be farther away */
#define TOUCHING 1e-4 /* m, rounding of the grid of distances */
#define ROUNDED 1e-6  /* m, of a distance: so that a wall midway between two grid points blocks both */

enum { UNIT = 127, BLOCKED = INT8_MIN, BLOCKED_WALL = 0, BLOCKED_EXIT = 1, MOST_PUSHES = 3 };

static const int neighbours[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

static Vec2 point_place(const FloorField *field, int i, int j) {
    return vec2(field->origin.x + i * field->cell, field->origin.y + j * field->cell);
}

static size_t point_at(const FloorField *field, int i, int j) {
    return (size_t)j * (size_t)field->nx + (size_t)i;
}

static bool inside_grid(const FloorField *field, int i, int j) {
    return i >= 0 && j >= 0 && i < field->nx && j < field->ny;
}

/* Finds the nearest obstacle from `at`: the unit vector away from its nearest point, and its distance, m, negative
 * inside solids. Returns false if there is none within `reach` m. */
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

/* True if another obstacle is opposite to the one that a place is moved away from, less than a cell farther than the
 * disc needs. */
static bool is_tight(const FloorField *field, Vec2 touching, Vec2 away) {
    double half = field->cell / 2, distance;
    Vec2 back;
    return nearest_obstacle(field->space, vec2_along(touching, half, away), field->radius + half - TOUCHING, &back,
                            &distance) &&
           vec2_dot(back, away) < -OPPOSITE;
}

/* True if the disc is free when it is moved off the obstacle that it overlaps at this place; by more than half a cell
 * only in a gap that is hardly wider than the disc. */
static bool almost_passable(const FloorField *field, Vec2 at) {
    Vec2 away;
    double distance;
    if (!nearest_obstacle(field->space, at, field->radius, &away, &distance))
        return true;
    Vec2 off = vec2_along(at, field->radius - distance, away);
    return freespace_exact(field->space, off, field->radius, NULL) > field->radius - TOUCHING &&
           (distance > field->radius - field->cell / 2 || is_tight(field, off, away));
}

static void classify(const FloorField *field, FastMarching *front, int stride) {
    const FreeSpace *space = field->space;
    double blocked = field->cell / 2 + ROUNDED, doubtful = fmax(field->radius - DOUBTFUL * field->cell, blocked);
    for (int j = 0; j < field->ny; j++)
        for (int i = 0; i < field->nx; i++) {
            size_t point = point_at(field, i, j);
            double distance = (double)space->distance[(size_t)(j * stride) * (size_t)space->nx + (size_t)(i * stride)];
            bool passable = distance > doubtful && (distance > fmax(field->radius, blocked) ||
                                                    almost_passable(field, point_place(field, i, j)));
            double lack = fmin(fmax(1 - (distance - field->radius) / FLOOR_FIELD_MARGIN, 0), 1);
            front->states[point] = passable             ? FAST_MARCHING_PASSABLE
                                   : distance > blocked ? FAST_MARCHING_SQUEEZED
                                                        : FAST_MARCHING_BLOCKED;
            front->slowness[point] = (float)((1 + FLOOR_FIELD_DISCOMFORT * lack * lack) / field->speed);
            if (!passable)
                front->slowness[point] *= (float)SQUEEZED;
        }
}

/* The grid points in a box: first to last in both coordinates; none when last < first. */
typedef struct Range {
    int first_x, last_x, first_y, last_y;
} Range;

static Range range_of(const FloorField *field, Box box) {
    double nx = field->nx, ny = field->ny;
    return (Range){(int)fmin(fmax(ceil((box.low.x - field->origin.x) / field->cell), 0), nx),
                   (int)fmax(fmin(floor((box.high.x - field->origin.x) / field->cell), nx - 1), -1),
                   (int)fmin(fmax(ceil((box.low.y - field->origin.y) / field->cell), 0), ny),
                   (int)fmax(fmin(floor((box.high.y - field->origin.y) / field->cell), ny - 1), -1)};
}

static Range range_about(const FloorField *field, Vec2 from, Vec2 to, double reach) {
    return range_of(field, box_expand(box_include(box_include(box_empty(), from), to), reach));
}

static void slow_at_doors(const FloorField *field, FastMarching *front, const Plan *plan) {
    double band = DOOR_BAND * field->cell;
    for (size_t d = 0; d < plan->door_count; d++) {
        if (!outline_door_moves(&plan->doors[d]))
            continue;
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        Range range = range_about(field, from, to, band);
        for (int j = range.first_y; j <= range.last_y; j++)
            for (int i = range.first_x; i <= range.last_x; i++) {
                Vec2 at = point_place(field, i, j);
                double away = vec2_distance(at, vec2_nearest_on_segment(at, from, to)) / band;
                if (away < 1)
                    front->slowness[point_at(field, i, j)] += (float)((1 - away) / band * plan->doors[d].opening_time);
            }
    }
}

/* True if a disc's centre is free of obstacles along a straight line. */
static bool sees(const FreeSpace *space, Vec2 from, Vec2 to, double distance) {
    int parts = (int)ceil(vec2_distance(from, to) / space->cell);
    for (int part = 0; part <= parts; part++)
        if (freespace_distance(space, vec2_along(from, (double)part / fmax(parts, 1), vec2_sub(to, from))) < distance)
            return false;
    return true;
}

/* Seeds the points within half the goal's radius that see the goal, which excludes points on the other side of a wall.
 */
static void seed_place(const FloorField *field, FastMarching *front) {
    const Goal *goal = &field->goal;
    double reach = fmax(goal->radius / 2, 2 * field->cell);
    Range range = range_about(field, goal->at, goal->at, reach);
    for (int j = range.first_y; j <= range.last_y; j++)
        for (int i = range.first_x; i <= range.last_x; i++) {
            Vec2 at = point_place(field, i, j);
            double away = vec2_distance(at, goal->at);
            if (away <= reach && sees(field->space, at, goal->at, 0))
                fast_marching_seed(front, i, j, (away - goal->radius) / field->speed);
        }
}

/* Returns how far a place is along an exit's line and to the left of it, m. */
static Vec2 exit_frame(const FloorFieldExit *exit, Vec2 at) {
    return vec2_unturn(vec2_sub(at, exit->from), exit->along);
}

/* True if the place is in front of or behind the line, excluding a part of its ends. */
static bool before_line(const FloorFieldExit *exit, Vec2 frame, double end, double reach) {
    double margin = fmin(end, exit->length / 4);
    return fabs(frame.y) <= reach && frame.x >= margin && frame.x <= exit->length - margin;
}

static void seed_exit(const FloorField *field, FastMarching *front, const FloorFieldExit *exit) {
    double reach = SEEDED * field->cell;
    Range range = range_about(field, exit->from, vec2_along(exit->from, exit->length, exit->along), reach);
    for (int j = range.first_y; j <= range.last_y; j++)
        for (int i = range.first_x; i <= range.last_x; i++) {
            Vec2 at = point_place(field, i, j), frame = exit_frame(exit, at);
            if (before_line(exit, frame, field->cell, reach) &&
                sees(field->space, vec2_along(exit->from, frame.x, exit->along), at, 0))
                fast_marching_seed(front, i, j, fabs(frame.y) / field->speed);
        }
}

static FloorFieldExit exit_make(const Exit *line) {
    Vec2 along = vec2_sub(line->to, line->from);
    return (FloorFieldExit){.from = line->from, .along = vec2_unit(along), .length = vec2_length(along)};
}

/* Returns the distance, in steps, of the points within OUTSIDE of the grid's edge from that edge without crossing any
 * exit; infinite elsewhere. Breadth first. */
static float *steps_outside(const FloorField *field, const FastMarching *front, const Plan *plan) {
    size_t points = (size_t)field->nx * (size_t)field->ny, count = 0, capacity = 0;
    float *steps = memory_zeroed(points, sizeof *steps), most = (float)(OUTSIDE / field->cell);
    int *queue = NULL;
    for (size_t p = 0; p < points; p++)
        steps[p] = HUGE_VALF;
    for (size_t e = 0; e < plan->exit_count; e++) {
        FloorFieldExit exit = exit_make(&plan->exits[e]);
        Range range = range_about(field, plan->exits[e].from, plan->exits[e].to, field->cell);
        for (int j = range.first_y; j <= range.last_y; j++)
            for (int i = range.first_x; i <= range.last_x; i++)
                if (before_line(&exit, exit_frame(&exit, point_place(field, i, j)), 0, 0.75 * field->cell))
                    steps[point_at(field, i, j)] = -1;
    }
    for (int p = 0; p < (int)points; p++) {
        int i = p % field->nx, j = p / field->nx;
        bool edge = i == 0 || j == 0 || i == field->nx - 1 || j == field->ny - 1;
        if (!edge || front->states[p] != FAST_MARCHING_PASSABLE || steps[p] < 0)
            continue;
        queue = memory_reserve(queue, &capacity, count + 1, sizeof *queue);
        queue[count++] = p;
        steps[p] = 0;
    }
    for (size_t taken = 0; taken < count && steps[queue[taken]] < most; taken++)
        for (int n = 0; n < 4; n++) {
            int i = queue[taken] % field->nx + neighbours[n][0], j = queue[taken] / field->nx + neighbours[n][1];
            if (!inside_grid(field, i, j))
                continue;
            size_t point = point_at(field, i, j);
            if (front->states[point] != FAST_MARCHING_PASSABLE || steps[point] < HUGE_VALF)
                continue;
            steps[point] = steps[queue[taken]] + 1;
            queue = memory_reserve(queue, &capacity, count + 1, sizeof *queue);
            queue[count++] = (int)point;
        }
    memory_free(queue);
    return steps;
}

/* Returns the outer side of the line: the one that is clearly nearer to the edge of the grid. */
static int outward_side(const FloorField *field, const FloorFieldExit *exit, const float *steps) {
    double left = HUGE_VAL, right = HUGE_VAL, reach = 3 * field->cell;
    Range range = range_about(field, exit->from, vec2_along(exit->from, exit->length, exit->along), reach);
    for (int j = range.first_y; j <= range.last_y; j++)
        for (int i = range.first_x; i <= range.last_x; i++) {
            Vec2 frame = exit_frame(exit, point_place(field, i, j));
            double away = (double)steps[point_at(field, i, j)] * field->cell;
            if (away < 0 || !before_line(exit, frame, field->cell, reach))
                continue;
            double *side = frame.y > 0 ? &left : &right;
            *side = fmin(*side, away);
        }
    return left + CLEARLY < right ? 1 : right + CLEARLY < left ? -1 : 0;
}

static void find_exits(FloorField *field, const FastMarching *front, const Plan *plan) {
    field->exits = memory_zeroed(plan->exit_count, sizeof *field->exits);
    for (size_t e = 0; e < plan->exit_count; e++)
        if (field_exit_usable(&field->goal, plan, e))
            field->exits[field->exit_count++] = exit_make(&plan->exits[e]);
    float *steps = steps_outside(field, front, plan);
    for (size_t e = 0; e < field->exit_count; e++)
        field->exits[e].outward = outward_side(field, &field->exits[e], steps);
    memory_free(steps);
}

static void set_direction(FloorField *field, size_t point, Vec2 direction) {
    field->directions[point][0] = (signed char)lrint(UNIT * direction.x);
    field->directions[point][1] = (signed char)lrint(UNIT * direction.y);
}

static bool is_directed(const FloorField *field, size_t point) {
    return field->directions[point][0] || field->directions[point][1];
}

static void find_directions(FloorField *field, const FastMarching *front) {
    for (int j = 0; j < field->ny; j++)
        for (int i = 0; i < field->nx; i++) {
            size_t point = point_at(field, i, j);
            if (front->states[point] == FAST_MARCHING_BLOCKED) {
                field->directions[point][0] = BLOCKED;
                field->directions[point][1] = BLOCKED_WALL;
            } else {
                set_direction(field, point, fast_marching_downhill(front, i, j));
            }
        }
}

static int side_of(double left) {
    return left > 0 ? 1 : -1;
}

/* Returns the direction straight across the line, away from the side of the place, or outwards. */
static Vec2 across(const FloorFieldExit *exit, Vec2 frame) {
    return vec2_scale(vec2_left(exit->along), exit->outward ? exit->outward : -side_of(frame.y));
}

static void direct_exit(FloorField *field, const FloorFieldExit *exit) {
    double beyond = exit->outward ? FLOOR_FIELD_BEYOND : 0, seeded = SEEDED * field->cell, reach = fmax(beyond, seeded);
    Range range = range_about(field, exit->from, vec2_along(exit->from, exit->length, exit->along), reach);
    for (int j = range.first_y; j <= range.last_y; j++)
        for (int i = range.first_x; i <= range.last_x; i++) {
            size_t point = point_at(field, i, j);
            Vec2 at = point_place(field, i, j), frame = exit_frame(exit, at);
            if (!isfinite(field->time[point]) || !before_line(exit, frame, 0, reach))
                continue;
            double behind = frame.y * exit->outward;
            bool passed = exit->outward && behind > 0 && behind <= beyond &&
                          sees(field->space, vec2_along(exit->from, frame.x, exit->along), at, field->cell);
            if (passed) {
                field->time[point] = (float)(-behind / field->speed);
                set_direction(field, point, across(exit, frame));
            } else if (!is_directed(field, point) && fabs(frame.y) <= seeded) {
                /* Its time was given, and no passable point is nearer to the line. */
                set_direction(field, point, across(exit, frame));
            }
            if (fabs(frame.y) <= field->cell) {
                field->directions[point][0] = BLOCKED;
                field->directions[point][1] = BLOCKED_EXIT;
            }
        }
}

static void grid_make(FloorField *field, int *stride) {
    const FreeSpace *space = field->space;
    *stride = 1;
    while ((double)(space->nx / *stride) * (space->ny / *stride) > FLOOR_FIELD_MOST_POINTS &&
           (*stride + 1) * space->cell <= FLOOR_FIELD_COARSEST)
        ++*stride;
    field->cell = *stride * space->cell;
    field->per_metre = 1 / field->cell;
    field->nx = (space->nx - 1) / *stride + 1;
    field->ny = (space->ny - 1) / *stride + 1;
    field->origin = space->origin;
    size_t points = (size_t)field->nx * (size_t)field->ny;
    field->time = memory_zeroed(points, sizeof *field->time);
    field->directions = memory_zeroed(points, sizeof *field->directions);
}

bool floor_field_init(FloorField *field, const Plan *plan, const FreeSpace *space, double radius, double speed,
                      const Goal *goal) {
    int stride;
    *field = (FloorField){.space = space, .goal = *goal, .radius = radius, .speed = speed};
    grid_make(field, &stride);
    FastMarching front;
    fast_marching_init(&front, field->nx, field->ny, field->cell, field->time);
    classify(field, &front, stride);
    slow_at_doors(field, &front, plan);
    if (goal->radius > 0)
        seed_place(field, &front);
    else
        find_exits(field, &front, plan);
    for (size_t e = 0; e < field->exit_count; e++)
        seed_exit(field, &front, &field->exits[e]);
    bool reachable = fast_marching_run(&front);
    fast_marching_squeeze(&front, (int)fmin(ceil(2 * radius / field->cell) + 1, FAST_MARCHING_MOST_STEPS));
    find_directions(field, &front);
    for (size_t e = 0; e < field->exit_count; e++)
        direct_exit(field, &field->exits[e]);
    fast_marching_clear(&front);
    return reachable;
}

void floor_field_clear(FloorField *field) {
    memory_free(field->time);
    memory_free(field->directions);
    memory_free(field->exits);
    *field = (FloorField){0};
}

/* The cell of the grid that contains a place, and the position in the cell. */
typedef struct Spot {
    size_t low;  /* the lower left point */
    double u, v; /* 1, from 0 to 1 */
} Spot;

static inline bool spot_find(const FloorField *field, Vec2 at, Spot *spot) {
    double x = (at.x - field->origin.x) * field->per_metre, y = (at.y - field->origin.y) * field->per_metre;
    if (!(x >= 0 && y >= 0 && x < field->nx - 1 && y < field->ny - 1))
        return false;
    int i = (int)x, j = (int)y;
    *spot = (Spot){point_at(field, i, j), x - i, y - j};
    return true;
}

static inline void spot_weights(const Spot *spot, double weights[4]) {
    weights[0] = (1 - spot->u) * (1 - spot->v);
    weights[1] = spot->u * (1 - spot->v);
    weights[2] = (1 - spot->u) * spot->v;
    weights[3] = spot->u * spot->v;
}

static inline bool spot_blocked(const FloorField *field, const Spot *spot) {
    const signed char(*low)[2] = field->directions + spot->low, (*high)[2] = low + field->nx;
    return (low[0][0] == BLOCKED) | (low[1][0] == BLOCKED) | (high[0][0] == BLOCKED) | (high[1][0] == BLOCKED);
}

/* Returns the mean direction of a cell's points, not of unit length; blocked points count with their stored values. */
static inline Vec2 spot_mean(const FloorField *field, const Spot *spot) {
    const signed char(*low)[2] = field->directions + spot->low, (*high)[2] = low + field->nx;
    double u = spot->u, v = spot->v;
    double x = (1 - v) * (low[0][0] + u * (low[1][0] - low[0][0])) + v * (high[0][0] + u * (high[1][0] - high[0][0]));
    double y = (1 - v) * (low[0][1] + u * (low[1][1] - low[0][1])) + v * (high[0][1] + u * (high[1][1] - high[0][1]));
    return vec2(x, y);
}

/* Returns the mean direction of a cell's points without blocked ones; the direction of the heaviest point where they
 * disagree. */
static Vec2 spot_direction(const FloorField *field, const Spot *spot) {
    const signed char(*low)[2] = field->directions + spot->low, (*high)[2] = low + field->nx;
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

static double spot_time(const FloorField *field, const Spot *spot) {
    const float *low = field->time + spot->low, *high = low + field->nx;
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

/* Returns the exit whose line is next to the place, or NULL. */
static const FloorFieldExit *exit_beside(const FloorField *field, Vec2 at, Vec2 *frame) {
    for (size_t e = 0; e < field->exit_count; e++) {
        *frame = exit_frame(&field->exits[e], at);
        if (before_line(&field->exits[e], *frame, 0, EXIT_BAND * field->cell))
            return &field->exits[e];
    }
    return NULL;
}

/* Moves a place away from the nearest walls until all points of its cell lie on its side of them. `*away` and
 * `*distance` belong to the first wall. Returns false if no wall is that near. */
static bool push_off(const FloorField *field, Vec2 *at, Vec2 *away, double *distance) {
    bool pushed = false;
    for (int n = 0; n < MOST_PUSHES; n++) {
        Vec2 direction;
        double off;
        if (!nearest_obstacle(field->space, *at, PUSHED_OFF * field->cell, &direction, &off))
            break;
        if (!pushed) {
            *away = direction;
            *distance = off;
        }
        pushed = true;
        *at = vec2_along(*at, PUSHED_OFF * field->cell - off, direction);
    }
    return pushed;
}

/* Returns the direction where a wall or an exit passes through the cell. */
static Vec2 careful_direction(const FloorField *field, Vec2 at) {
    Vec2 frame = {0, 0}, away = {0, 0}, off = at;
    double distance = 0;
    Spot spot;
    const FloorFieldExit *exit = exit_beside(field, at, &frame);
    bool pushed = push_off(field, &off, &away, &distance);
    if (!spot_find(field, off, &spot))
        return vec2(0, 0);
    Vec2 direction = spot_direction(field, &spot);
    if (exit && isfinite(spot_time(field, &spot)))
        direction = across(exit, frame);
    if (!pushed || !(vec2_dot(direction, direction) > 0))
        return direction;
    double towards = real_min(vec2_dot(direction, away), 0);
    direction = vec2_along(direction, -towards, away);
    if (!exit || distance < 0)
        direction = vec2_along(direction, real_clamp(1 - distance / field->radius, 0, 1), away);
    direction = vec2_unit(direction);
    return vec2_dot(direction, direction) > 0 ? direction : away;
}

Vec2 floor_field_direction(const FloorField *field, Vec2 at) {
    Spot spot;
    if (!spot_find(field, at, &spot))
        return vec2(0, 0);
    if (spot_blocked(field, &spot))
        return careful_direction(field, at);
    Vec2 mean = spot_mean(field, &spot);
    double square = vec2_dot(mean, mean);
    if (square < KINK * UNIT * KINK * UNIT)
        return spot_direction(field, &spot);
    return vec2_scale(mean, 1 / sqrt(square));
}

double floor_field_time(const FloorField *field, Vec2 at) {
    Spot spot;
    Vec2 away;
    double distance;
    if (!spot_find(field, at, &spot))
        return HUGE_VAL;
    if (spot_blocked(field, &spot) && push_off(field, &at, &away, &distance) && !spot_find(field, at, &spot))
        return HUGE_VAL;
    return spot_time(field, &spot);
}
