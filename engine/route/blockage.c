#include "route/blockage.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "plan/plan_geometry.h"
#include "route/neck.h"
#include "route/widen.h"
#include "space/outline.h"
#include "space/passage.h"

/* The width of a passage is the shortest chord from obstacle to obstacle across both long sides of the body, at most 30
 * degrees from square, or the distance between the two faces at its ends where that is about the same, or where they
 * are parallel: a body on the slant between two walls is across them. A body that lacks a margin m on either side needs
 * 2 m more than that, and its own width at least; a disc needs its own. Without any passage, something bars it
 * whole: then the path through the fewest solids, which prefers furniture to locked doors and those to walls, names the
 * place. */

#define RAY_REACH 20.0      /* m: a passage wider than this has no width worth reporting */
#define DEEPEST_OVERLAP 0.2 /* m, of a track */
#define CHORD_SPACING 0.05  /* m, along the body's axis */

/* m: an exit's line in a doorway is this near to where a body sticks there. */
#define AT_CLOSED_LINE 0.25

enum { NECK_FACES = 16 };

/* Cost per cell of free space, of furniture, of a locked door and of any other solid, 1: a piece of furniture is better
 * than a locked door, that is better than any detour in a house, and a wall is worse than any number of them. */
enum { STEP_FREE = 1, STEP_PIECE = 200, STEP_DOOR = 2000, STEP_SOLID = 40000 };

#define SAME_WIDTH 0.05 /* 1, of a chord: the distance between the faces at its ends differs by no more */
#define PARALLEL 0.05   /* 1, the sine of the angle between two faces that are parallel, at most */

typedef struct Chord {
    double width;    /* m */
    Vec2 middle;     /* m */
    int left, right; /* the faces at its ends, or -1 */
} Chord;

/* The two sides of a body between which chords are drawn. */
typedef struct Flanks {
    Vec2 centre;                  /* m */
    double heading;               /* rad, along the sides */
    double half_length, half_gap; /* m */
} Flanks;

/* Returns the sides of the body where it is free: shrunk by the margin that it lacks. */
static Flanks flanks_of(const Rectangle *body, const FitPlace *place, double heading) {
    double shrunk = fmin(place->margin, 0);
    return (Flanks){place->centre, heading, fmax(body->half_length + shrunk, 0), fmax(body->half_width + shrunk, 0)};
}

/* Replaces `best` by the shortest chord through a point of the body's axis, `along` m ahead of its middle, if that is
 * shorter. Chords that leave the body by its front or back do not measure the passage. */
static void try_chords(const RouteQuery *query, const Flanks *flanks, double along, Chord *best) {
    const Outline *outline = query->space->outline;
    Vec2 at = vec2_along(flanks->centre, along, vec2_heading(flanks->heading));
    if (freespace_distance(query->space, at) <= 0)
        return;
    for (int tilt = -3; tilt <= 3; tilt++) {
        Vec2 tilted = vec2_heading(radians(10.0 * tilt)), axis = vec2_heading(flanks->heading);
        if (tilt && fabs(along) + flanks->half_gap * fabs(tilted.y / tilted.x) > flanks->half_length)
            continue;
        Vec2 across = vec2_left(vec2_turn(tilted, axis));
        Chord chord;
        double left = outline_ray(outline, at, across, RAY_REACH, &chord.left);
        double right = outline_ray(outline, at, vec2_scale(across, -1), RAY_REACH, &chord.right);
        chord.width = left + right;
        chord.middle = vec2_along(at, (left - right) / 2, across);
        if (chord.width < best->width)
            *best = chord;
    }
}

/* Finds the shortest chord across a body whose long side has the given heading; infinite when its axis lies in an
 * obstacle. */
static void find_chord(const RouteQuery *query, const Rectangle *body, const FitPlace *place, double heading,
                       Chord *best) {
    Flanks flanks = flanks_of(body, place, heading);
    Vec2 axis = vec2_heading(heading);
    int parts = (int)ceil(2 * flanks.half_length / CHORD_SPACING);
    for (int i = 0; i <= parts; i++)
        try_chords(query, &flanks, parts ? flanks.half_length * (2.0 * i / parts - 1) : 0, best);
    /* A jamb may be thinner than the spacing, so chords level with the ends of the deciding face are tried, too. */
    for (int end = 0; end < 4 && place->face >= 0; end++) {
        const Face *face = &query->space->outline->faces[place->face];
        double along = vec2_dot(vec2_sub(end & 1 ? face->a : face->b, place->centre), axis) + (end & 2 ? 1e-4 : -1e-4);
        if (fabs(along) <= flanks.half_length)
            try_chords(query, &flanks, along, best);
    }
}

static bool segments_cross(Vec2 a, Vec2 b, Vec2 from, Vec2 to) {
    Vec2 along = vec2_sub(b, a), across = vec2_sub(to, from);
    return vec2_cross(along, vec2_sub(from, a)) * vec2_cross(along, vec2_sub(to, a)) < 0 &&
           vec2_cross(across, vec2_sub(a, from)) * vec2_cross(across, vec2_sub(b, from)) < 0;
}

/* Replaces `best` by the opening of a door in which the body stands, if that is narrower: beside the opening a body on
 * the slant may have its jambs on one side. */
static void try_door(const Plan *plan, const Door *door, const Rectangle *body, const FitPlace *place, Chord *best) {
    Vec2 from, to, axis = vec2_heading(place->heading);
    plan_geometry_door_ends(plan, door, &from, &to);
    if (door->state == DOOR_LOCKED || door->width >= best->width)
        return;
    for (int side = -1; side <= 1; side++) {
        Vec2 middle = vec2_along(place->centre, side * body->half_width, vec2_left(axis));
        Vec2 rear = vec2_along(middle, -body->half_length, axis), front = vec2_along(middle, body->half_length, axis);
        if (segments_cross(rear, front, from, to))
            *best = (Chord){door->width, vec2_scale(vec2_add(from, to), 0.5), -1, -1};
    }
}

static Chord chord_at(const RouteQuery *query, const Rectangle *body, const FitPlace *place) {
    Chord best = {HUGE_VAL, place->centre, -1, -1};
    find_chord(query, body, place, place->heading, &best);
    if (body->half_length < 1.2 * body->half_width) /* find the long side */
        find_chord(query, body, place, place->heading + M_PI_2, &best);
    for (size_t d = 0; d < query->plan->door_count; d++)
        try_door(query->plan, &query->plan->doors[d], body, place, &best);
    if (!(best.width < HUGE_VAL))
        return (Chord){0, place->centre, -1, -1};
    if (best.left >= 0 && best.right >= 0) {
        const Face *left = &query->space->outline->faces[best.left], *right = &query->space->outline->faces[best.right];
        Vec2 middle = best.middle;
        double width = passage_between(left, right, &middle), least = 2 * flanks_of(body, place, 0).half_gap;
        bool same = fabs(width - best.width) <= SAME_WIDTH * best.width;
        if (width >= least && (same || fabs(vec2_cross(left->normal, right->normal)) < PARALLEL)) {
            best.width = width;
            best.middle = middle;
        }
    }
    return best;
}

void blockage_of_start(Blockage *blockage, const RouteQuery *query, const Rectangle *body) {
    int face;
    char name[sizeof blockage->what - sizeof "start, inside "];
    search_clearance(query->space, body, query->at, query->heading, FREESPACE_FARTHEST, &face);
    if (face >= 0) {
        const Face *touched = &query->space->outline->faces[face];
        outline_name(query->plan, touched->owner, touched->index, name, sizeof name);
    } else {
        outline_place_name(query->space->outline, query->plan, query->at, name, sizeof name);
    }
    *blockage = (Blockage){.at = query->at};
    snprintf(blockage->what, sizeof blockage->what, "start, inside %s", name);
}

/* A grid of steps for the path through the fewest solids. */
typedef struct Breach {
    const RouteQuery *query;
    const FreeSpace *space;
    unsigned short *solid; /* (ny x nx) the step there where it is solid */
    float *cost;           /* (ny x nx) */
    int *parent;           /* (ny x nx) neighbour towards the start, or -1 */
    int *heap;
    size_t heap_count, heap_capacity;
} Breach;

static void breach_put(Breach *breach, int point) {
    breach->heap = memory_reserve(breach->heap, &breach->heap_capacity, breach->heap_count + 1, sizeof(int));
    size_t i = breach->heap_count++;
    for (; i > 0 && breach->cost[point] < breach->cost[breach->heap[(i - 1) / 2]]; i = (i - 1) / 2)
        breach->heap[i] = breach->heap[(i - 1) / 2];
    breach->heap[i] = point;
}

static int breach_take(Breach *breach) {
    int first = breach->heap[0], last = breach->heap[--breach->heap_count];
    size_t i = 0;
    for (size_t child = 1; child < breach->heap_count; child = 2 * i + 1) {
        if (child + 1 < breach->heap_count && breach->cost[breach->heap[child + 1]] < breach->cost[breach->heap[child]])
            child++;
        if (breach->cost[breach->heap[child]] >= breach->cost[last])
            break;
        breach->heap[i] = breach->heap[child];
        i = child;
    }
    breach->heap[i] = last;
    return first;
}

static Vec2 breach_place(const Breach *breach, int point) {
    return vec2(breach->space->origin.x + point % breach->space->nx * breach->space->cell,
                breach->space->origin.y + point / breach->space->nx * breach->space->cell);
}

static bool breach_solid(const Breach *breach, int point) {
    return breach->space->distance[point] < (float)(0.6 * breach->space->cell);
}

/* Marks the points between two places, up to `beside` m beside the line and `beyond` m beyond its ends. */
static void mark_strip(Breach *breach, Vec2 from, Vec2 to, double beside, double beyond, int step) {
    const FreeSpace *space = breach->space;
    double length = vec2_distance(from, to);
    Vec2 along = vec2_unit(vec2_sub(to, from));
    Box box = box_expand(box_include(box_include(box_empty(), from), to), fmax(beside, beyond));
    for (int j = 0; j < space->ny; j++) {
        double y = space->origin.y + j * space->cell;
        for (int i = 0; i < space->nx && y >= box.low.y && y <= box.high.y; i++) {
            int point = j * space->nx + i;
            Vec2 at = vec2_sub(breach_place(breach, point), from);
            double gone = vec2_dot(at, along);
            if (gone > -beyond && gone < length + beyond && fabs(vec2_cross(along, at)) <= beside)
                breach->solid[point] = (unsigned short)step;
        }
    }
}

static void mark_solids(Breach *breach) {
    const Plan *plan = breach->query->plan;
    double cell = breach->space->cell;
    for (size_t p = 0; p < (size_t)breach->space->nx * (size_t)breach->space->ny; p++)
        breach->solid[p] = STEP_SOLID;
    for (size_t f = 0; f < plan->furniture_count; f++) {
        Vec2 corners[4];
        plan_geometry_corners(&plan->furniture[f], corners);
        Vec2 from = vec2_scale(vec2_add(corners[0], corners[3]), 0.5);
        Vec2 to = vec2_scale(vec2_add(corners[1], corners[2]), 0.5);
        mark_strip(breach, from, to, vec2_distance(corners[0], corners[3]) / 2 + cell, cell, STEP_PIECE);
    }
    for (size_t w = 0; w < plan->wall_count; w++) /* what stands at a wall is not the wall */
        for (size_t p = 0; p + 1 < plan->walls[w].points.count; p++)
            mark_strip(breach, plan->walls[w].points.at[p], plan->walls[w].points.at[p + 1],
                       plan->walls[w].thickness / 2, 0, STEP_SOLID);
    for (size_t d = 0; d < plan->door_count; d++) {
        if (plan->doors[d].state != DOOR_LOCKED)
            continue;
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        mark_strip(breach, from, to, plan->walls[plan->doors[d].wall_index].thickness / 2 + cell, 0, STEP_DOOR);
    }
}

/* Returns the last point before the exit's line of the cheapest path from the start across a usable exit, or -1; the
 * point `*behind` follows it. All steps from a point are looked at, as in neck.c. */
static int breach_search(Breach *breach, int *behind) {
    const FreeSpace *space = breach->space;
    Goal goal = {.exit = breach->query->exit, .time = breach->query->time};
    double x = (breach->query->at.x - space->origin.x) / space->cell + 0.5;
    double y = (breach->query->at.y - space->origin.y) / space->cell + 0.5;
    if (!(x >= 0 && y >= 0 && x < space->nx && y < space->ny))
        return -1;
    int start = (int)y * space->nx + (int)x, last = -1;
    float least = HUGE_VALF;
    breach->cost[start] = 0;
    breach->parent[start] = -1;
    breach_put(breach, start);
    static const int steps[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    while (breach->heap_count > 0) {
        int point = breach_take(breach);
        int i = point % space->nx, j = point / space->nx;
        Vec2 before = point == start ? breach->query->at : breach_place(breach, point);
        if (breach->cost[point] >= least)
            break;
        for (int s = 0; s < 4; s++) {
            int to_x = i + steps[s][0], to_y = j + steps[s][1], to = to_y * space->nx + to_x;
            if (to_x < 0 || to_y < 0 || to_x >= space->nx || to_y >= space->ny)
                continue;
            float step = breach_solid(breach, to) ? breach->solid[to] : STEP_FREE;
            float cost = breach->cost[point] + step;
            size_t exit;
            if (cost < least &&
                field_goal_reached(&goal, breach->query->plan, before, breach_place(breach, to), &exit)) {
                least = cost;
                last = point;
                *behind = to;
            }
            if (cost < breach->cost[to]) {
                breach->cost[to] = cost;
                breach->parent[to] = point;
                breach_put(breach, to);
            }
        }
    }
    return last;
}

/* Finds the middle of the first solid on the path through the fewest solids. Returns false if there is none. */
static bool find_breach(const RouteQuery *query, Vec2 *at) {
    const FreeSpace *space = query->space;
    size_t points = (size_t)space->nx * (size_t)space->ny;
    Breach breach = {.query = query, .space = space};
    breach.solid = memory_zeroed(points, sizeof *breach.solid);
    breach.cost = memory_zeroed(points, sizeof *breach.cost);
    breach.parent = memory_zeroed(points, sizeof *breach.parent);
    for (size_t i = 0; i < points; i++)
        breach.cost[i] = HUGE_VALF;
    mark_solids(&breach);
    bool found = false;
    Vec2 sum = {0, 0};
    int in_it = 0;
    /* Walk back from the exit: the last solid seen is the first on the path out. */
    bool inside = false, first = true;
    unsigned short kind = 0;
    int behind = -1, last = breach_search(&breach, &behind);
    for (int point = behind; point >= 0; point = first ? last : breach.parent[point], first = false) {
        if (breach_solid(&breach, point)) {
            if (!inside || breach.solid[point] != kind) { /* another solid begins */
                sum = vec2(0, 0);
                in_it = 0;
            }
            kind = breach.solid[point];
            sum = vec2_add(sum, breach_place(&breach, point));
            in_it++;
            found = true;
        }
        inside = breach_solid(&breach, point);
    }
    if (found)
        *at = vec2_scale(sum, 1.0 / in_it);
    memory_free(breach.solid);
    memory_free(breach.cost);
    memory_free(breach.parent);
    memory_free(breach.heap);
    return found;
}

/* Returns the piece of furniture in which a place lies, or less than `near` m from it, or -1. */
static int piece_at(const Plan *plan, Vec2 at, double near) {
    for (size_t f = 0; f < plan->furniture_count; f++) {
        Vec2 corners[4];
        plan_geometry_corners(&plan->furniture[f], corners);
        bool inside = true;
        for (int c = 0; c < 4 && inside; c++)
            inside =
                vec2_cross(vec2_unit(vec2_sub(corners[(c + 1) % 4], corners[c])), vec2_sub(at, corners[c])) > -near;
        if (inside)
            return (int)f;
    }
    return -1;
}

static bool owned_alike(const Face *a, const Face *b) {
    return a->owner == b->owner && a->index == b->index;
}

/* Returns the wall that stands for the line of a closed exit at a place, or -1. */
static int closed_line_at(const Plan *plan, Vec2 at) {
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Vec2 *ends = plan->walls[w].points.at;
        if (plan->walls[w].closed_exit &&
            vec2_distance(at, vec2_nearest_on_segment(at, ends[0], ends[1])) < AT_CLOSED_LINE)
            return (int)w;
    }
    return -1;
}

/* Names what narrows the place, and what it leaves the room to. Of the faces on its sides, a piece of furniture comes
 * before a wall, and before a door in whose opening the place lies unless its jambs are the narrow place. */
static void name_sides(Blockage *blockage, const RouteQuery *query, const int *sides, int count) {
    const Face *faces = query->space->outline->faces, *piece = NULL, *other = NULL;
    int closed = closed_line_at(query->plan, blockage->at);
    if (closed >= 0) { /* no width helps there */
        outline_name(query->plan, OWNER_WALL, closed, blockage->what, sizeof blockage->what);
        blockage->has = blockage->needs = 0;
        blockage->estimated = blockage->posed = false;
        return;
    }
    outline_place_name(query->space->outline, query->plan, blockage->at, blockage->what, sizeof blockage->what);
    for (int i = 0; i < count && !piece; i++)
        if (sides[i] >= 0 && faces[sides[i]].owner == OWNER_FURNITURE)
            piece = &faces[sides[i]];
    for (int i = 0; i < count && !other && piece; i++)
        if (sides[i] >= 0 && !owned_alike(&faces[sides[i]], piece))
            other = &faces[sides[i]];
    if (!piece)
        return;
    char name[sizeof blockage->what];
    outline_name(query->plan, OWNER_FURNITURE, piece->index, name, sizeof name);
    if (widen_door_at(blockage, query) >= 0) {
        snprintf(blockage->beside, sizeof blockage->beside, "%s", name);
        return;
    }
    if (outline_door_at(query->plan, blockage->at) >= 0)
        snprintf(blockage->beside, sizeof blockage->beside, "%s", blockage->what);
    else if (other)
        outline_name(query->plan, other->owner, other->index, blockage->beside, sizeof blockage->beside);
    snprintf(blockage->what, sizeof blockage->what, "%s", name);
}

void blockage_of_fit(Blockage *blockage, const RouteQuery *query, const Rectangle *body, const FitPlace *place) {
    double missing = fmax(-place->margin, 0), own = 2 * body->half_width;
    Chord chord = chord_at(query, body, place);
    *blockage = (Blockage){.at = chord.middle, .has = chord.width, .estimated = true};
    blockage->posed = blockage->has > 0;
    blockage->middle = place->centre;
    blockage->heading = place->heading;
    blockage->needs = blockage->has > 0 ? fmax(blockage->has + 2 * missing, own) : own;
    name_sides(blockage, query, (const int[]){chord.left, chord.right}, blockage->has > 0 ? 2 : 0);
}

bool blockage_of_disc(Blockage *blockage, const RouteQuery *query, double radius, const Goal *goals,
                      size_t goal_count) {
    Neck neck;
    NeckAnswer answer = neck_find(&neck, query, goals, goal_count);
    if (answer == NECK_INTERRUPTED)
        return false;
    *blockage = (Blockage){.at = neck.at, .needs = 2 * radius, .estimated = true};
    if (answer != NECK_FOUND) {
        find_breach(query, &blockage->at);
    } else {
        blockage->has = neck.width;
    }
    int faces[NECK_FACES], count = 0;
    double reach = blockage->has / 2 + query->space->cell;
    if (blockage->has > 0 && reach < FREESPACE_FARTHEST)
        count = freespace_faces(query->space, blockage->at, vec2(1, 0), 0, 0, reach, faces, NECK_FACES);
    name_sides(blockage, query, faces, count);
    bool closed = closed_line_at(query->plan, blockage->at) >= 0;
    int piece = blockage->has > 0 || closed ? -1 : piece_at(query->plan, blockage->at, query->space->cell);
    if (piece >= 0)
        outline_name(query->plan, OWNER_FURNITURE, piece, blockage->what, sizeof blockage->what);
    return true;
}

void blockage_of_track(Blockage *blockage, const RouteQuery *query, const Rectangle *body, const SearchTrack *track) {
    FitPlace place = {.margin = HUGE_VAL, .face = -1};
    for (size_t i = 0; i < track->count; i++) {
        const Pose *pose = &track->poses[i];
        int face;
        Vec2 axis = vec2_heading(pose->heading), centre = vec2_along(pose->at, body->ahead, axis);
        double margin = freespace_growth(query->space, centre, axis, body->half_length, body->half_width,
                                         FREESPACE_FARTHEST, &face);
        if (margin < place.margin)
            place = (FitPlace){centre, pose->heading, margin, face, false};
    }
    place.margin = fmax(place.margin, -DEEPEST_OVERLAP);
    blockage_of_fit(blockage, query, body, &place);
}
