#include "route/frame.h"

#include <stdint.h>
#include <string.h>

#include "base/memory.h"
#include "base/real.h"

/* The search for a route has a grid of distances, a grid of times, cells of places and headings, and a subdivision, and
 * which of several nearly equal paths it finds depends on how the house lies among them. The exact problem has no such
 * preference: it is the same after any congruence (turn, shift, mirror image). So the route is searched in a copy of
 * the plan that is the same for all congruent plans, and is carried back.
 *
 * Its x axis lies along the longest straight piece of a wall, which leaves four directions and two mirror images. Of
 * these eight senses the frame has the one whose x axis is nearest to the person's heading and in which the exit is
 * farthest to the left of the start. If these are undecided, the points on the way decide in the same manner, then the
 * moments of the plan about the middle of the walls' box: of the walls (by length), of the exits and of the furniture;
 * at last it is not mirrored. The origin is the lower left corner of the walls' box.
 *
 * Numbers are rounded, above the rounding errors of a congruence and of a file that has nanometres, and below
 * everything that matters, so that copies are equal to the last bit: places to 0.1 um and angles to 1e-6 degrees. Where
 * a start is so near to an exit's line that it could change sides, all but the solids are rounded to 0.1 nm. The solids
 * are united in the copy, because GEOS rounds to a grid as well.
 *
 * The direction in which walls and exits are drawn does not matter, and how they are split hardly does. A plan that is
 * symmetric about the line ahead has a mirror image with the same answer, but not with the mirrored path: people who
 * meet in a corridor must prefer the same side of their own, or neither can pass. */

#define SOLID_PARTS 1e7 /* 1/m */
#define EXACT_PARTS 1e10
#define ANGLE_PARTS 1e6 /* 1/degree */
#define NEXT_TO 1e-6    /* m, to an exit's line */
#define SAME 1e-6       /* m, by which lengths and moments must differ to decide */

/* The points of a plan in a frame whose x axis is along the longest wall. */
typedef struct Marks {
    Vec2 *at;                       /* those of the walls, then of the furniture, then of the exits */
    size_t walls, furniture, exits; /* number of points of each */
    Vec2 middle;                    /* m, of the box around the first kind of points that occurs */
    Vec2 of_walls;                  /* m, the walls' mean point by length */
} Marks;

/* Rounds to a whole number of parts; never to a negative 0. */
static double rounded(double value, double parts) {
    return round(value * parts) / parts + 0.0;
}

/* Brings an angle in degrees into (-half, half] in steps of 2 half, and rounds it. */
static double rounded_angle(double angle, double half) {
    double result = rounded(remainder(angle, 2 * half), ANGLE_PARTS);
    return result <= -half ? result + 2 * half : result;
}

/* Choosing the frame -------------------------------------------------------------------------------------------- */

/* Replaces the longest vector so far. Of equal ones the first in the plan stays. */
static void try_longest(Vec2 *longest, Vec2 vector) {
    if (vec2_length(vector) > vec2_length(*longest) + SAME)
        *longest = vector;
}

/* Returns the direction of the longest piece of a wall; without walls, of the longest side of furniture; without both,
 * of the longest exit. */
static Vec2 longest_direction(const Plan *plan) {
    Vec2 longest = {0, 0};
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Points *points = &plan->walls[w].points;
        for (size_t i = 1; i < points->count; i++)
            try_longest(&longest, vec2_sub(points->at[i], points->at[i - 1]));
    }
    for (size_t f = 0; !plan->wall_count && f < plan->furniture_count; f++) {
        const Furniture *piece = &plan->furniture[f];
        try_longest(&longest, vec2_scale(vec2_heading(radians(piece->angle)), fmax(piece->size.x, piece->size.y)));
    }
    for (size_t e = 0; !plan->wall_count && !plan->furniture_count && e < plan->exit_count; e++)
        try_longest(&longest, vec2_sub(plan->exits[e].to, plan->exits[e].from));
    return vec2_length(longest) > 0 ? vec2_unit(longest) : vec2(1, 0);
}

static Vec2 any_point(const Plan *plan) {
    return plan->wall_count        ? plan->walls[0].points.at[0]
           : plan->furniture_count ? plan->furniture[0].centre
           : plan->exit_count      ? plan->exits[0].from
                                   : vec2(0, 0);
}

/* Returns the mean of points, or `otherwise` if there are none. */
static Vec2 mean(const Vec2 *at, size_t count, Vec2 otherwise) {
    Vec2 sum = {0, 0};
    for (size_t i = 0; i < count; i++)
        sum = vec2_add(sum, at[i]);
    return count ? vec2_scale(sum, 1.0 / (double)count) : otherwise;
}

/* Collects the points of a plan, relative to `origin` in the frame of `axis`. memory_free the points. */
static Marks collect(const Plan *plan, Vec2 origin, Vec2 axis) {
    Marks marks = {.furniture = plan->furniture_count, .exits = 2 * plan->exit_count};
    for (size_t w = 0; w < plan->wall_count; w++)
        marks.walls += plan->walls[w].points.count;
    marks.at = memory_zeroed(marks.walls + marks.furniture + marks.exits, sizeof *marks.at);
    size_t count = 0;
    Vec2 sum = {0, 0};
    double total = 0;
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t i = 0; i < plan->walls[w].points.count; i++, count++) {
            marks.at[count] = vec2_unturn(vec2_sub(plan->walls[w].points.at[i], origin), axis);
            double length = i > 0 ? vec2_distance(marks.at[count], marks.at[count - 1]) : 0;
            if (length > 0)
                sum = vec2_along(sum, length / 2, vec2_add(marks.at[count], marks.at[count - 1]));
            total += length;
        }
    for (size_t f = 0; f < plan->furniture_count; f++)
        marks.at[count++] = vec2_unturn(vec2_sub(plan->furniture[f].centre, origin), axis);
    for (size_t e = 0; e < plan->exit_count; e++) {
        marks.at[count++] = vec2_unturn(vec2_sub(plan->exits[e].from, origin), axis);
        marks.at[count++] = vec2_unturn(vec2_sub(plan->exits[e].to, origin), axis);
    }
    size_t first = marks.walls ? marks.walls : marks.furniture ? marks.furniture : marks.exits;
    Box box = box_around(first ? marks.at[0] : vec2(0, 0), 0);
    for (size_t i = 1; i < first; i++)
        box = box_include(box, marks.at[i]);
    marks.middle = vec2_scale(vec2_add(box.low, box.high), 0.5);
    marks.of_walls = total > 0 ? vec2_scale(sum, 1 / total) : marks.middle;
    return marks;
}

/* Returns a vector as seen in one of the senses: after a turn by quarters, and mirrored in the upper four. */
static Vec2 seen(Vec2 vector, int sense) {
    for (int quarter = 0; quarter < sense % 4; quarter++)
        vector = vec2(vector.y, -vector.x);
    return vec2(vector.x, sense < 4 ? vector.y : -vector.y);
}

/* Drops the senses, one bit each, in which a vector's x (axis 0) or y (axis 1) is not the largest. Returns the rest. */
static unsigned narrowed(unsigned senses, Vec2 vector, int axis) {
    double values[FRAME_LAYS], largest = -HUGE_VAL;
    for (int s = 0; s < FRAME_LAYS; s++) {
        values[s] = axis ? seen(vector, s).y : seen(vector, s).x;
        if (senses >> s & 1)
            largest = fmax(largest, values[s]);
    }
    for (int s = 0; s < FRAME_LAYS; s++)
        if (values[s] < largest - SAME)
            senses &= ~(1U << s);
    return senses;
}

static unsigned narrowed_by_moment(unsigned senses, Vec2 moment) {
    return narrowed(narrowed(senses, moment, 0), moment, 1);
}

/* Returns those of the senses in which the moments of the plan are largest. */
static unsigned narrowed_by_plan(unsigned senses, const Plan *plan, Vec2 along) {
    Marks marks = collect(plan, any_point(plan), along);
    const Vec2 *furniture = marks.at + marks.walls, *exits = furniture + marks.furniture;
    Vec2 middle = marks.middle;
    senses = narrowed_by_moment(senses, vec2_sub(marks.of_walls, middle));
    senses = narrowed_by_moment(senses, vec2_sub(mean(exits, marks.exits, middle), middle));
    senses = narrowed_by_moment(senses, vec2_sub(mean(furniture, marks.furniture, middle), middle));
    memory_free(marks.at);
    return senses;
}

/* Returns the middle of an exit, or of all exits for SIZE_MAX. */
static Vec2 way_out(const Plan *plan, size_t exit, Vec2 otherwise) {
    Vec2 sum = {0, 0};
    size_t count = 0;
    for (size_t e = 0; e < plan->exit_count; e++)
        if (exit == SIZE_MAX || exit == e) {
            sum = vec2_add(sum, vec2_scale(vec2_add(plan->exits[e].from, plan->exits[e].to), 0.5));
            count++;
        }
    return count ? vec2_scale(sum, 1.0 / (double)count) : otherwise;
}

/* True if a start is so near to the straight line of an exit that it could change sides when it is rounded. */
static bool is_next_to_exit(const Plan *plan, Vec2 at) {
    bool next = false;
    for (size_t e = 0; e < plan->exit_count; e++) {
        Vec2 along = vec2_unit(vec2_sub(plan->exits[e].to, plan->exits[e].from));
        next |= fabs(vec2_cross(along, vec2_sub(at, plan->exits[e].from))) < NEXT_TO;
    }
    return next;
}

int frame_sense(const Plan *plan, Vec2 at, double heading, const Vec2 *via, size_t via_count, size_t exit) {
    Vec2 along = longest_direction(plan);
    unsigned left = narrowed((1U << FRAME_LAYS) - 1, vec2_unturn(vec2_heading(heading), along), 0);
    left = narrowed(left, vec2_unturn(vec2_sub(way_out(plan, exit, at), at), along), 1);
    for (size_t i = 0; i < via_count; i++)
        left = narrowed(left, vec2_unturn(vec2_sub(via[i], at), along), 1);
    if (left & (left - 1))
        left = narrowed_by_plan(left, plan, along);
    int sense = 0;
    while (!(left >> sense & 1))
        sense++;
    return is_next_to_exit(plan, at) ? sense | FRAME_EXACT : sense;
}

/* Lays the frame's axes and origin. */
static void lay(RouteFrame *frame, const Plan *plan, int sense) {
    Vec2 from = any_point(plan), along = longest_direction(plan);
    Marks marks = collect(plan, from, along);
    frame->mirrored = sense >= 4;
    frame->axis = along;
    for (int quarter = 0; quarter < sense % 4; quarter++)
        frame->axis = vec2_left(frame->axis);
    frame->angle = degrees(real_atan2(frame->axis.y, frame->axis.x));
    size_t first = marks.walls ? marks.walls : marks.furniture ? marks.furniture : marks.exits;
    Box box = box_around(first ? seen(marks.at[0], sense) : vec2(0, 0), 0);
    for (size_t i = 1; i < first; i++)
        box = box_include(box, seen(marks.at[i], sense));
    frame->origin = from;
    frame->origin = frame_place_in_plan(frame, box.low);
    memory_free(marks.at);
}

/* Converting ---------------------------------------------------------------------------------------------------- */

static Vec2 place_in_parts(const RouteFrame *frame, Vec2 at, double parts) {
    Vec2 own = vec2_unturn(vec2_sub(at, frame->origin), frame->axis);
    return vec2(rounded(own.x, parts), rounded(frame->mirrored ? -own.y : own.y, parts));
}

Vec2 frame_place(const RouteFrame *frame, Vec2 at) {
    return place_in_parts(frame, at, frame->parts);
}

Vec2 frame_place_in_plan(const RouteFrame *frame, Vec2 at) {
    return vec2_add(frame->origin, vec2_turn(vec2(at.x, frame->mirrored ? -at.y : at.y), frame->axis));
}

/* Converts an angle in degrees that repeats after 2 half. */
static double own_angle(const RouteFrame *frame, double angle, double half) {
    return rounded_angle(frame->mirrored ? frame->angle - angle : angle - frame->angle, half);
}

double frame_heading(const RouteFrame *frame, double heading) {
    return radians(own_angle(frame, degrees(heading), 180));
}

double frame_heading_in_plan(const RouteFrame *frame, double heading) {
    return radians(frame->angle) + (frame->mirrored ? -heading : heading);
}

/* Returns a copy of an array in the arena of the frame's plan. */
static void *copied(RouteFrame *frame, const void *array, size_t count, size_t size) {
    if (!count)
        return NULL;
    void *copy = arena_allocate(&frame->plan.arena, count * size);
    memcpy(copy, array, count * size);
    return copy;
}

static void place_points(RouteFrame *frame, Points *points, double parts) {
    points->at = copied(frame, points->at, points->count, sizeof *points->at);
    for (size_t i = 0; i < points->count; i++)
        points->at[i] = place_in_parts(frame, points->at[i], parts);
}

static void place_furniture(const RouteFrame *frame, Furniture *piece) {
    piece->centre = place_in_parts(frame, piece->centre, SOLID_PARTS);
    piece->angle = own_angle(frame, piece->angle, piece->toppled ? 180 : 90);
    if (frame->mirrored && piece->topples == TOPPLE_FRONT)
        piece->topples = TOPPLE_BACK;
    else if (frame->mirrored && piece->topples == TOPPLE_BACK)
        piece->topples = TOPPLE_FRONT;
}

/* Copies an exit so that it begins at its left end, or else at the lower one, in whatever order the ends were drawn. */
static void place_exit(const RouteFrame *frame, Exit *exit) {
    Vec2 from = frame_place(frame, exit->from), to = frame_place(frame, exit->to);
    bool swapped = to.x < from.x || (!(from.x < to.x) && to.y < from.y);
    exit->from = swapped ? to : from;
    exit->to = swapped ? from : to;
}

/* Copies the plan into the frame. */
static void copy_plan(RouteFrame *frame, const Plan *plan) {
    Plan *own = &frame->plan;
    *own = *plan;
    own->arena = (Arena){0};
    own->index = NULL;
    own->rooms = NULL;
    own->overrides = NULL;
    own->room_count = own->override_count = 0;
    own->background = (Background){0};
    own->walls = copied(frame, plan->walls, plan->wall_count, sizeof *plan->walls);
    own->doors = copied(frame, plan->doors, plan->door_count, sizeof *plan->doors);
    own->furniture = copied(frame, plan->furniture, plan->furniture_count, sizeof *plan->furniture);
    own->exits = copied(frame, plan->exits, plan->exit_count, sizeof *plan->exits);
    own->people = copied(frame, plan->people, plan->person_count, sizeof *plan->people);
    own->crowds = copied(frame, plan->crowds, plan->crowd_count, sizeof *plan->crowds);
    own->routes = copied(frame, plan->routes, plan->route_count, sizeof *plan->routes);
    for (size_t w = 0; w < own->wall_count; w++)
        place_points(frame, &own->walls[w].points, SOLID_PARTS);
    for (size_t d = 0; frame->mirrored && d < own->door_count; d++)
        own->doors[d].swing = own->doors[d].swing == SWING_LEFT ? SWING_RIGHT : SWING_LEFT;
    for (size_t f = 0; f < own->furniture_count; f++)
        place_furniture(frame, &own->furniture[f]);
    for (size_t e = 0; e < own->exit_count; e++)
        place_exit(frame, &own->exits[e]);
    for (size_t p = 0; p < own->person_count; p++) {
        own->people[p].at = frame_place(frame, own->people[p].at);
        own->people[p].heading = own_angle(frame, own->people[p].heading, 180);
    }
    for (size_t c = 0; c < own->crowd_count; c++)
        place_points(frame, &own->crowds[c].area, frame->parts);
    for (size_t r = 0; r < own->route_count; r++)
        place_points(frame, &own->routes[r].via, frame->parts);
}

bool frame_build(RouteFrame *frame, const Plan *plan, int sense) {
    *frame = (RouteFrame){.axis = {1, 0}, .parts = sense & FRAME_EXACT ? EXACT_PARTS : SOLID_PARTS};
    lay(frame, plan, sense & ~FRAME_EXACT);
    copy_plan(frame, plan);
    Fault fault = {0};
    bool good = outline_build(&frame->outline, &frame->plan, &fault);
    fault_clear(&fault);
    if (good)
        freespace_build(&frame->space, &frame->outline, frame->plan.run.cell);
    else
        frame_free(frame);
    return good;
}

void frame_free(RouteFrame *frame) {
    freespace_free(&frame->space);
    outline_free(&frame->outline);
    arena_clear(&frame->plan.arena);
    *frame = (RouteFrame){0};
}
