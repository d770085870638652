#include "route/blockage.h"

#include <stdio.h>

#include "base/memory.h"
#include "plan/plan_geometry.h"
#include "space/outline.h"

/* The width of a passage is the shortest chord from obstacle to obstacle across the body, through a point of its long
 * axis, at most 30 degrees from square. A body that lacks a margin m on either side needs 2 m more than that. If there
 * is no passage at all, a wall blocks the path or a door is locked: then the path through the fewest solids, which
 * prefers locked doors to walls, names the place. */

#define RAY_REACH 20.0     /* m: a passage wider than this has no width worth reporting */
#define CHORD_SPACING 0.05 /* m, along the body's axis */
#define NO_PASSAGE 0.2     /* m: with this margin missing on either side, another passage is needed, not a wider one */

/* Cost per metre through free space, through a locked door and through any other solid, 1: a locked door is better than
 * any detour in a house, and a wall is worse than any number of doors. */
enum { STEP_FREE = 1, STEP_DOOR = 2000, STEP_SOLID = 40000 };

typedef struct Chord {
    double width; /* m */
    Vec2 middle;  /* m */
} Chord;

/* Replaces `best` by the shortest chord through a point of the body's axis, if that is shorter. */
static void try_chords(const RouteQuery *query, Vec2 at, double heading, Chord *best) {
    if (freespace_distance(query->space, at) <= 0)
        return;
    for (int tilt = -3; tilt <= 3; tilt++) {
        Vec2 across = vec2_heading(heading + M_PI_2 + radians(10.0 * tilt));
        double left = outline_ray(query->space->outline, at, across, RAY_REACH, NULL);
        double right = outline_ray(query->space->outline, at, vec2_scale(across, -1), RAY_REACH, NULL);
        if (left + right < best->width)
            *best = (Chord){left + right, vec2_along(at, (left - right) / 2, across)};
    }
}

/* Finds the shortest chord across a body whose long side has the given heading; infinite when its axis lies in an
 * obstacle. */
static void find_chord(const RouteQuery *query, const Rectangle *body, const FitPlace *place, double heading,
                       Chord *best) {
    Vec2 axis = vec2_heading(heading);
    int parts = (int)ceil(2 * body->half_length / CHORD_SPACING);
    for (int i = 0; i <= parts; i++) {
        double along = body->half_length * (2.0 * i / parts - 1);
        try_chords(query, vec2_along(place->centre, along, axis), heading, best);
    }
    /* A jamb may be thinner than the spacing, so chords level with the ends of the deciding face are tried, too. */
    for (int end = 0; end < 4 && place->face >= 0; end++) {
        const Face *face = &query->space->outline->faces[place->face];
        double along = vec2_dot(vec2_sub(end & 1 ? face->a : face->b, place->centre), axis) + (end & 2 ? 1e-4 : -1e-4);
        if (fabs(along) <= body->half_length)
            try_chords(query, vec2_along(place->centre, along, axis), heading, best);
    }
}

static Chord chord_at(const RouteQuery *query, const Rectangle *body, const FitPlace *place) {
    Chord best = {HUGE_VAL, place->centre};
    find_chord(query, body, place, place->heading, &best);
    if (body->half_length < 1.2 * body->half_width) /* find the long side */
        find_chord(query, body, place, place->heading + M_PI_2, &best);
    return best.width < HUGE_VAL ? best : (Chord){0, place->centre};
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
    unsigned char *locked; /* (ny x nx) 1: in a locked door's opening */
    float *cost;           /* (ny x nx) */
    int *parent;           /* (ny x nx) neighbour towards the start */
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

static void mark_locked(Breach *breach) {
    const Plan *plan = breach->query->plan;
    const FreeSpace *space = breach->space;
    for (size_t d = 0; d < plan->door_count; d++) {
        if (plan->doors[d].state != DOOR_LOCKED)
            continue;
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        double reach = plan->walls[plan->doors[d].wall_index].thickness / 2 + space->cell;
        freespace_mark(space, box_expand(box_include(box_include(box_empty(), from), to), reach), breach->locked);
    }
}

/* Returns the last point of the cheapest path from the start across a usable exit, or -1. */
static int breach_search(Breach *breach) {
    const FreeSpace *space = breach->space;
    Goal goal = {.exit = breach->query->exit, .time = breach->query->time};
    double x = (breach->query->at.x - space->origin.x) / space->cell + 0.5;
    double y = (breach->query->at.y - space->origin.y) / space->cell + 0.5;
    if (!(x >= 0 && y >= 0 && x < space->nx && y < space->ny))
        return -1;
    int start = (int)y * space->nx + (int)x;
    breach->cost[start] = 0;
    breach->parent[start] = -1;
    breach_put(breach, start);
    static const int steps[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    while (breach->heap_count > 0) {
        int point = breach_take(breach);
        int i = point % space->nx, j = point / space->nx;
        size_t exit;
        if (breach->parent[point] >= 0 &&
            field_goal_reached(&goal, breach->query->plan, breach_place(breach, breach->parent[point]),
                               breach_place(breach, point), &exit))
            return point;
        for (int s = 0; s < 4; s++) {
            int to_x = i + steps[s][0], to_y = j + steps[s][1], to = to_y * space->nx + to_x;
            if (to_x < 0 || to_y < 0 || to_x >= space->nx || to_y >= space->ny)
                continue;
            float step = !breach_solid(breach, to) ? STEP_FREE : breach->locked[to] ? STEP_DOOR : STEP_SOLID;
            if (breach->cost[point] + step < breach->cost[to]) {
                breach->cost[to] = breach->cost[point] + step;
                breach->parent[to] = point;
                breach_put(breach, to);
            }
        }
    }
    return -1;
}

/* Finds the middle of the first solid on the path through the fewest solids. Returns false if there is none. */
static bool find_breach(const RouteQuery *query, Vec2 *at) {
    const FreeSpace *space = query->space;
    size_t points = (size_t)space->nx * (size_t)space->ny;
    Breach breach = {.query = query, .space = space};
    breach.locked = memory_zeroed(points, 1);
    breach.cost = memory_zeroed(points, sizeof *breach.cost);
    breach.parent = memory_zeroed(points, sizeof *breach.parent);
    for (size_t i = 0; i < points; i++)
        breach.cost[i] = HUGE_VALF;
    mark_locked(&breach);
    bool found = false;
    Vec2 sum = {0, 0};
    int in_it = 0;
    /* Walk back from the exit: the last solid seen is the first on the path out. */
    bool inside = false;
    for (int point = breach_search(&breach); point >= 0; point = breach.parent[point]) {
        if (breach_solid(&breach, point)) {
            if (!inside) {
                sum = vec2(0, 0);
                in_it = 0;
            }
            sum = vec2_add(sum, breach_place(&breach, point));
            in_it++;
            found = true;
        }
        inside = breach_solid(&breach, point);
    }
    if (found)
        *at = vec2_scale(sum, 1.0 / in_it);
    memory_free(breach.locked);
    memory_free(breach.cost);
    memory_free(breach.parent);
    memory_free(breach.heap);
    return found;
}

void blockage_of_fit(Blockage *blockage, const RouteQuery *query, const Rectangle *body, const FitPlace *place) {
    *blockage = (Blockage){.at = place->centre};
    Vec2 at;
    if (place->margin < -NO_PASSAGE && find_breach(query, &at)) {
        blockage->at = at;
        blockage->needs = 2 * body->half_width;
    } else {
        double missing = fmax(-place->margin, 0);
        Chord chord = chord_at(query, body, place);
        blockage->at = chord.middle;
        blockage->has = chord.width;
        blockage->needs = blockage->has > 0 ? blockage->has + 2 * missing : 2 * body->half_width;
    }
    outline_place_name(query->space->outline, query->plan, blockage->at, blockage->what, sizeof blockage->what);
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
            place = (FitPlace){centre, pose->heading, margin, face};
    }
    place.margin = fmax(place.margin, -NO_PASSAGE);
    blockage_of_fit(blockage, query, body, &place);
}
