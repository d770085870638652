#include "route/search.h"

#include <stdint.h>

#include "base/heap.h"
#include "base/key_table.h"
#include "base/memory.h"
#include "base/stop.h"
#include "base/real.h"
#include "route/pace.h"

/* Hybrid A* (Dolgov, Thrun, Montemerlo and Diebel 2010): poses are real numbers, moved by primitives; of the poses in
 * one cell of the grid over (x, y, heading, direction) only the cheapest is expanded, and another one only with fewer
 * changes of direction than all before it.
 *
 * Primitives: straight, arcs, both forwards and backwards, and turns on the spot; where skids are allowed, also turns
 * about the body's middle, in which the drive axle moves sideways. Cost, s: the time under the speed
 * law, the time to stop and start again around a turn on the spot, to change direction and to open a door, and the
 * time once more in proportion to the lack of clearance.
 *
 * A motion is swept exactly: no point of the body moves farther than D during it, so that it is free when the
 * clearances at its two ends add up to D or more; otherwise its two halves are checked. As every checked pose has
 * SEARCH_CLEARANCE, this ends after a few steps, and accepted motions are proven free. */

#define SWEEP_REACH 0.25 /* m, larger clearance is not computed */

#define HAIR 1e-6 /* m, above the rounding errors of places */

#define SAMPLE 0.04 /* m, between the poses of a finished track */

static const double radii[] = {0.35, 0.6, 1.0, 2.0}; /* m: the median turning radius of drivers is 1.09 */
enum { RADII = sizeof radii / sizeof *radii, MOST_PRIMITIVES = 4 * RADII + 6, REVERSAL_LEVELS = 21 };

enum { PARTS = 16 /* of a motion, a power of two: what is reached after each is known in advance */ };

/* The displacement of a pose along a part of a motion. */
typedef struct Part {
    double chord;  /* m */
    Vec2 bearing;  /* unit vector, of the chord, in the frame of the beginning */
    double turn;   /* rad */
    Vec2 rotation; /* unit vector of `turn` */
} Part;

typedef struct Primitive {
    double length;     /* m, along the path, negative backwards */
    double turn;       /* rad */
    double pivot;      /* m, ahead of the axle: the place about which a turn on the spot turns */
    Vec2 chord;        /* m, from beginning to end, in the frame of the beginning */
    Vec2 rotation;     /* unit vector of `turn` */
    double reach;      /* m, upper bound of the motion of any point of the body */
    double slowest;    /* s, least duration */
    int direction;     /* +1, -1, 0 on the spot */
    int units;         /* of turn */
    Part parts[PARTS]; /* after k / PARTS of the motion */
} Primitive;

typedef struct Node {
    Vec2 at;
    double heading;    /* rad */
    Vec2 axis;         /* its unit vector */
    double cost;       /* s, cost so far */
    float clearance;   /* m, up to SWEEP_REACH */
    float slowness;    /* s/m, of the speed law */
    int parent;        /* -1: the start */
    short primitive;   /* primitive that led here */
    signed char last;  /* direction of the last motion that was not on the spot */
    signed char count; /* changes of direction */
    int exit;          /* exit crossed; -1: none, -2: the goal was a point */
} Node;

typedef struct Open {
    double estimate; /* s */
    int node;
} Open;

/* The best known path through a cell, and the changes of direction of the best expanded one. Paths are compared by the
 * sum of cost and remaining time, since poses in one cell differ in progress. */
typedef struct Cell {
    uint64_t key;   /* 0: empty */
    float estimate; /* s */
    signed char count, expanded;
} Cell;

typedef struct Search {
    const Field *field;
    const Goal *goal;
    const Rectangle *body;
    const SearchGrain *grain;
    const FreeSpace *space;
    Reads *times; /* notes which times to the goal are read; NULL: not noted */
    const Profile *profile;
    Primitive primitives[MOST_PRIMITIVES];
    int primitive_count;
    int turns;        /* number of headings in a full turn */
    double longest;   /* m, between the ends of a motion */
    double stop_time; /* s, lost by stopping or by starting */
    Vec2 origin;      /* m, the start */
    double bearing;   /* rad */
    int least_reversals, most_reversals;
    Node *nodes;
    size_t node_count, node_capacity;
    Open *open; /* binary heap */
    size_t open_count, open_capacity;
    Cell *cells;
    size_t cell_count, cell_capacity;
} Search;

Rectangle search_body(const Profile *profile) {
    return (Rectangle){profile->length / 2, profile->width / 2, profile->length / 2 - profile->axle};
}

double search_farthest(const Rectangle *body) {
    double ahead = fabs(body->ahead) + body->half_length;
    return sqrt(ahead * ahead + body->half_width * body->half_width);
}

double search_clearance(const FreeSpace *space, const Rectangle *body, Vec2 at, double heading, double reach,
                        int *face) {
    Vec2 axis = vec2_heading(heading);
    return freespace_clearance(space, vec2_along(at, body->ahead, axis), axis, body->half_length, body->half_width,
                               reach, face);
}

void search_track_add(SearchTrack *track, Pose pose) {
    track->poses = memory_reserve(track->poses, &track->capacity, track->count + 1, sizeof *track->poses);
    track->poses[track->count++] = pose;
}

void search_track_clear(SearchTrack *track) {
    memory_free(track->poses);
    *track = (SearchTrack){0};
}

/* Returns the longest distance that a point of the body travels in a motion: its distance from the turning point times
 * the turn. */
static double motion_reach(const Rectangle *body, double length, double turn, double pivot) {
    if (fabs(turn) < 1e-9)
        return fabs(length);
    double ahead = fabs(body->ahead - pivot) + body->half_length, radius = fabs(length / turn) + body->half_width;
    return fabs(turn) * sqrt(ahead * ahead + radius * radius);
}

/* Returns what moves a pose along a fraction, 0 to 1, of a motion. */
static Part part_of(const Primitive *primitive, double fraction) {
    double length = primitive->length * fraction, turn = primitive->turn * fraction, half = turn / 2;
    double chord = fabs(half) > 1e-9 ? length * real_sin(half) / half : length;
    return (Part){chord, vec2_heading(half), turn, vec2_heading(turn)};
}

/* Moves a pose along a part of a motion. */
static void move_along(const Primitive *primitive, const Part *part, Vec2 *at, Vec2 *axis) {
    Vec2 end = vec2_turn(part->rotation, *axis);
    if (primitive->pivot > 0)
        *at = vec2_along(vec2_along(*at, primitive->pivot, *axis), -primitive->pivot, end);
    else
        *at = vec2_along(*at, part->chord, vec2_turn(part->bearing, *axis));
    *axis = end;
}

/* Returns the node after a fraction, 0 to 1, of a motion. */
static Node moved(const Node *from, const Primitive *primitive, double fraction) {
    Node to = *from;
    Part part = part_of(primitive, fraction);
    move_along(primitive, &part, &to.at, &to.axis);
    to.heading = from->heading + part.turn;
    return to;
}

/* Returns the node after the whole motion; faster than moved(). */
static Node moved_whole(const Node *from, const Primitive *primitive) {
    Node to = *from;
    to.at = vec2_add(from->at, vec2_turn(primitive->chord, from->axis));
    to.heading = from->heading + primitive->turn;
    to.axis = vec2_turn(primitive->rotation, from->axis);
    return to;
}

static void add_primitive(Search *search, int direction, double length, double turn, double pivot) {
    const Profile *profile = search->profile;
    double time = fabs(turn) / profile->turn_rate + fabs(turn) * pivot * profile->skid_time;
    if (direction) {
        double speed = direction > 0 ? profile->free_speed : fmin(profile->free_speed, profile->reversing_speed);
        if (turn != 0)
            speed = fmin(speed, sqrt(profile->lateral_acceleration * fabs(length / turn)));
        time = fmax(time, fabs(length) / speed);
    }
    Primitive *primitive = &search->primitives[search->primitive_count++];
    *primitive = (Primitive){
        .length = direction * length, .turn = turn, .pivot = pivot, .slowest = time, .direction = direction};
    primitive->reach = motion_reach(search->body, length, turn, pivot);
    Node begin = {.axis = {1, 0}}, end = moved(&begin, primitive, 1);
    primitive->chord = end.at;
    primitive->rotation = end.axis;
    primitive->units = (int)round(turn / search->grain->turn);
    search->longest = fmax(search->longest, vec2_length(end.at));
    for (int k = 1; k < PARTS; k++)
        primitive->parts[k] = part_of(primitive, (double)k / PARTS);
}

static void make_primitives(Search *search) {
    double step = search->grain->step, unit = search->grain->turn;
    for (int direction = 1; direction >= -1; direction -= 2) {
        add_primitive(search, direction, step, 0, 0);
        for (int r = RADII - 1; r >= 0; r--) {
            /* Whole units of turn, so that a chair that starts in line with the walls is in line again after its turns.
             */
            double turn = unit * fmax(round(step / (radii[r] * unit)), 1);
            add_primitive(search, direction, radii[r] * turn, turn, 0);
            add_primitive(search, direction, radii[r] * turn, -turn, 0);
        }
    }
    bool turns = search->profile->turning_moment >= pace_spot_moment(search->profile);
    for (int side = 1; side >= -1 && turns; side -= 2) {
        add_primitive(search, 0, 0, side * unit, 0);
        if (search->grain->skids && search->body->ahead > 0)
            add_primitive(search, 0, 0, side * unit, search->body->ahead);
    }
}

static float node_slowness(const Search *search, const Node *node) {
    Vec2 middle = vec2_along(node->at, search->body->ahead, node->axis);
    return (float)(1 / field_speed(search->profile, freespace_distance(search->space, middle)));
}

/* Returns the clearance at a pose, m; below SEARCH_CLEARANCE, any such value. */
static double pose_clearance(const Search *search, Vec2 at, Vec2 axis) {
    const Rectangle *body = search->body;
    return freespace_clearance_from(search->space, vec2_along(at, body->ahead, axis), axis, body->half_length,
                                    body->half_width, SEARCH_CLEARANCE, SWEEP_REACH);
}

/* Returns the clearance after a fraction, 0 to 1, of a motion. */
static double clearance_between(const Search *search, const Node *from, const Primitive *primitive, double fraction) {
    Vec2 at = from->at, axis = from->axis;
    int k = (int)(fraction * PARTS);
    Part part;
    if (k < fraction * PARTS)
        part = part_of(primitive, fraction);
    move_along(primitive, k < fraction * PARTS ? &part : &primitive->parts[k], &at, &axis);
    return pose_clearance(search, at, axis);
}

/* True if the motion is free between two fractions of it, whose clearances are known. `*narrowest` is lowered to the
 * clearances met. */
static bool swept(const Search *search, const Node *from, const Primitive *primitive, double first, double at_first,
                  double last, double at_last, double *narrowest) {
    if (at_first + at_last >= primitive->reach * (last - first))
        return true;
    double middle = (first + last) / 2, clearance = clearance_between(search, from, primitive, middle);
    if (clearance < SEARCH_CLEARANCE)
        return false;
    *narrowest = fmin(*narrowest, clearance);
    return swept(search, from, primitive, first, at_first, middle, clearance, narrowest) &&
           swept(search, from, primitive, middle, clearance, last, at_last, narrowest);
}

/* Rounds half away from 0, so that a mirrored house is searched alike. */
static int64_t rounded(double value) {
    return (int64_t)(value < 0 ? value - 0.5 : value + 0.5);
}

/* Returns which of the headings of a full turn a node has. */
static int heading_index(const Search *search, const Node *node) {
    int all = search->turns, turns = (int)rounded((node->heading - search->bearing) / search->grain->turn) % all;
    return turns < 0 ? turns + all : turns;
}

/* True if a node has as many changes of direction as the way must have. */
static bool is_enough(const Search *search, const Node *node) {
    return node->count >= search->least_reversals;
}

static uint64_t key_of(const Search *search, const Node *node, int turns) {
    double cell = search->grain->cell;
    int64_t x = rounded((node->at.x - search->origin.x) / cell), y = rounded((node->at.y - search->origin.y) / cell);
    uint64_t turn = (uint64_t)turns, side = (uint64_t)(node->last + 1), enough = is_enough(search, node);
    return ((uint64_t)(x + (1 << 24)) << 38) ^ (enough << 37) ^ ((uint64_t)(y + (1 << 23)) << 12) ^ (turn << 2) ^ side ^
           ((uint64_t)1 << 63);
}

static uint64_t node_key(const Search *search, const Node *node) {
    return key_of(search, node, heading_index(search, node));
}

KEY_TABLE_DEFINE(cell, Cell)

/* Returns the cell's entry, created if it is new. */
static Cell *cell_of(Search *search, uint64_t key) {
    bool fresh;
    Cell *cell = cell_enter(&search->cells, &search->cell_count, &search->cell_capacity, key, &fresh);
    if (fresh)
        *cell = (Cell){key, HUGE_VALF, INT8_MAX, INT8_MAX};
    return cell;
}

/* Orders by estimate. Of equal estimates the later one goes first, since it is nearer to the goal. */
static bool before(Open a, Open b) {
    return a.estimate < b.estimate || (a.estimate <= b.estimate && a.node > b.node);
}

HEAP_DEFINE(open, Open, before)

static void add_node(Search *search, const Node *node, double to_go) {
    search->nodes = memory_reserve(search->nodes, &search->node_capacity, search->node_count + 1, sizeof *node);
    search->nodes[search->node_count] = *node;
    open_put(&search->open, &search->open_count, &search->open_capacity,
             (Open){node->cost + search->grain->weight * to_go, (int)search->node_count++});
}

/* Returns the cost of a motion from `from` to `to`, s. */
static double motion_cost(const Search *search, const Node *from, const Node *to, const Primitive *primitive,
                          double narrowest) {
    const Profile *profile = search->profile;
    double time = fmax(primitive->slowest, fabs(primitive->length) * (double)(from->slowness + to->slowness) / 2);
    time *= field_discomfort(narrowest);
    bool was_moving = from->parent >= 0 && search->primitives[from->primitive].direction != 0;
    if (from->parent >= 0 && was_moving != (primitive->direction != 0))
        time += search->stop_time;
    if (to->count > from->count)
        time += profile->reversing_time + search->stop_time;
    return time + field_delay(search->field->ground, from->at, to->at);
}

/* Returns the time to the goal from a place, s. */
static double time_from(const Search *search, Vec2 at) {
    if (search->times)
        field_note_time(search->field, at, search->times);
    return field_time(search->field, at);
}

/* True if a motion from a place may end the leg. */
static bool is_near_goal(const Search *search, Vec2 at) {
    const Goal *goal = search->goal;
    const Plan *plan = search->field->ground->plan;
    for (size_t e = 0; e < plan->exit_count && !(goal->radius > 0); e++) {
        const Exit *exit = &plan->exits[e];
        if (field_exit_usable(goal, plan, e) &&
            vec2_distance(at, vec2_nearest_on_segment(at, exit->from, exit->to)) <= search->longest + HAIR)
            return true;
    }
    return goal->radius > 0;
}

/* A motion that may be tried, and the cell that it leads to. */
typedef struct Trial {
    Node to;
    uint64_t key;
} Trial;

/* Fills in the motion of a primitive from a node, which has the heading `turns`. Returns false if it is not allowed. */
static bool begin_trial(const Search *search, const Node *from, int turns, int parent, int which, Trial *trial) {
    const Primitive *primitive = &search->primitives[which];
    Node *to = &trial->to;
    *to = moved_whole(from, primitive);
    to->parent = parent;
    to->primitive = (short)which;
    if (primitive->direction) {
        if (from->last && from->last != primitive->direction && ++to->count > search->most_reversals)
            return false;
        to->last = (signed char)primitive->direction;
    } else if (from->parent >= 0) {
        /* Skip a turn that reverses the previous one, unless the two shift the body sideways. */
        const Primitive *previous = &search->primitives[from->primitive];
        if (!previous->direction && previous->turn * primitive->turn < 0 && previous->pivot == primitive->pivot)
            return false;
    }
    turns += primitive->units;
    trial->key = key_of(search, to, turns < 0 ? turns + search->turns : turns % search->turns);
    return true;
}

/* Adds the node that a motion leads to, unless an obstacle blocks the motion or a better node is known. The motion may
 * reach the goal only if it begins near to it. */
static void try_motion(Search *search, const Node *from, bool near, Trial *trial) {
    Node *to = &trial->to;
    const Primitive *primitive = &search->primitives[to->primitive];
    size_t exit = SIZE_MAX;
    bool reached = near && is_enough(search, to) &&
                   field_goal_reached(search->goal, search->field->ground->plan, from->at, to->at, &exit);
    const Cell *known = cell_find(search->cells, search->cell_capacity, trial->key);
    if (!reached && known->key == trial->key && known->expanded <= to->count)
        return;
    double to_go = reached ? 0 : time_from(search, to->at);
    if (!isfinite(to_go))
        return;
    Cell *cell = cell_of(search, trial->key);
    if (!reached &&
        (cell->expanded <= to->count || (cell->count <= to->count && (double)cell->estimate <= from->cost + to_go)))
        return;
    to->slowness = node_slowness(search, to);
    /* A motion is never cheaper than if the body had as much room all along as at its beginning. */
    if (!reached && cell->count <= to->count &&
        (double)cell->estimate <=
            from->cost + motion_cost(search, from, to, primitive, (double)from->clearance) + to_go)
        return;
    double clearance = pose_clearance(search, to->at, to->axis), narrowest = fmin(clearance, (double)from->clearance);
    if (clearance < SEARCH_CLEARANCE ||
        !swept(search, from, primitive, 0, fmax((double)from->clearance, SEARCH_CLEARANCE), 1, clearance, &narrowest))
        return;
    to->clearance = (float)clearance;
    to->cost = from->cost + motion_cost(search, from, to, primitive, narrowest);
    to->exit = !reached ? -1 : exit == SIZE_MAX ? -2 : (int)exit;
    if (!reached) {
        double estimate = to->cost + to_go;
        if (cell->count <= to->count && (double)cell->estimate <= estimate)
            return;
        if (to->count < cell->count || estimate < (double)cell->estimate) {
            cell->estimate = (float)estimate;
            cell->count = to->count;
        }
    }
    add_node(search, to, to_go);
}

/* Tries all motions from a node. The table of cells is large, so that the cells are fetched before they are needed. */
static void expand(Search *search, int parent) {
    const Node from = search->nodes[parent];
    Trial trials[MOST_PRIMITIVES];
    int count = 0, turns = heading_index(search, &from);
    bool near = is_near_goal(search, from.at);
    for (int p = 0; p < search->primitive_count; p++)
        if (begin_trial(search, &from, turns, parent, p, &trials[count]))
            __builtin_prefetch(&search->cells[cell_first(search->cell_capacity, trials[count++].key)]);
    for (int t = 0; t < count; t++)
        try_motion(search, &from, near, &trials[t]);
}

/* Adds the poses of the motions that led to `last`, without the start's. */
static void write_track(const Search *search, SearchTrack *track, int last) {
    size_t count = 0;
    for (int n = last; search->nodes[n].parent >= 0; n = search->nodes[n].parent)
        count++;
    int *chain = memory_zeroed(count, sizeof *chain);
    for (int n = last, i = (int)count - 1; i >= 0; n = search->nodes[n].parent, i--)
        chain[i] = n;
    for (size_t i = 0; i < count; i++) {
        const Node *to = &search->nodes[chain[i]], *from = &search->nodes[to->parent];
        const Primitive *primitive = &search->primitives[to->primitive];
        int parts = (int)ceil(fmax(fabs(primitive->length) / SAMPLE, fabs(primitive->turn) / radians(5)) - 1e-9);
        for (int part = 1; part <= parts; part++) {
            Node at = moved(from, primitive, (double)part / parts);
            search_track_add(track, (Pose){at.at, at.heading, 0, primitive->direction});
        }
        track->skid += fabs(primitive->turn) * primitive->pivot;
    }
    memory_free(chain);
    const Node *end = &search->nodes[last];
    track->reversals = end->count;
    track->direction = end->last;
    track->exit = end->exit >= 0 ? (size_t)end->exit : SIZE_MAX;
}

static void prefetch_node(const Node *node) {
    __builtin_prefetch(node);
    __builtin_prefetch((const char *)(node + 1) - 1);
}

static SearchAnswer search_run(Search *search, SearchTrack *track) {
    const Stop *stop = search->field->ground->stop;
    for (size_t expanded = 0; search->open_count > 0;) {
        if (stop_requested(stop))
            return SEARCH_INTERRUPTED;
        int node = open_take(search->open, &search->open_count).node;
        if (search->open_count > 0) /* most likely the next one */
            prefetch_node(&search->nodes[search->open[0].node]);
        if (search->nodes[node].exit != -1) {
            write_track(search, track, node);
            return SEARCH_FOUND;
        }
        Cell *cell = cell_of(search, node_key(search, &search->nodes[node]));
        if (cell->expanded <= search->nodes[node].count)
            continue;
        cell->expanded = search->nodes[node].count;
        if (++expanded > search->grain->most_nodes)
            return SEARCH_GAVE_UP;
        expand(search, node);
    }
    return SEARCH_NONE;
}

SearchAnswer search_leg(SearchTrack *track, const Field *field, const FreeSpace *space, Reads *times, const Goal *goal,
                        const Rectangle *body, const SearchGrain *grain, int least_reversals, int most_reversals) {
    const Pose *start = &track->poses[track->count - 1];
    const Profile *profile = field->ground->profile;
    Search search = {.field = field,
                     .goal = goal,
                     .body = body,
                     .grain = grain,
                     .space = space,
                     .times = times,
                     .profile = profile,
                     .origin = start->at,
                     .bearing = start->heading,
                     .least_reversals = least_reversals,
                     .most_reversals = most_reversals < REVERSAL_LEVELS ? most_reversals : REVERSAL_LEVELS - 1};
    search.stop_time = profile->free_speed * (1 / profile->acceleration + 1 / profile->deceleration) / 4;
    search.turns = (int)rounded(2 * M_PI / grain->turn);
    make_primitives(&search);
    Node first = {.at = start->at,
                  .heading = start->heading,
                  .axis = vec2_heading(start->heading),
                  .parent = -1,
                  .primitive = -1,
                  .last = (signed char)track->direction,
                  .count = (signed char)track->reversals,
                  .exit = -1};
    first.clearance = (float)search_clearance(space, body, first.at, first.heading, SWEEP_REACH, NULL);
    first.slowness = node_slowness(&search, &first);
    SearchAnswer answer = SEARCH_NONE;
    size_t none;
    double to_go = time_from(&search, first.at);
    if (is_enough(&search, &first) && goal->radius > 0 &&
        field_goal_reached(goal, field->ground->plan, first.at, first.at, &none)) {
        answer = SEARCH_FOUND; /* the start is at the goal */
    } else if (isfinite(to_go)) {
        add_node(&search, &first, to_go);
        answer = search_run(&search, track);
    }
    memory_free(search.nodes);
    memory_free(search.open);
    memory_free(search.cells);
    return answer;
}

const Field *search_field(const RouteQuery *query, const Goal *goal, double radius) {
    const FreeSpace *shared = query->watched ? query->watched : query->space;
    FieldKey key = {query->plan, shared, query->profile, radius, .goal = *goal, .stop = query->stop};
    if (query->bars)
        key.bars = *query->bars;
    return fields_acquire(query->fields, &key);
}

SearchAnswer search_legs(const RouteQuery *query, const Goal *goals, size_t goal_count, const Rectangle *body,
                         double radius, const SearchGrain *grain, int most_reversals, SearchTrack *track,
                         size_t *pins) {
    search_track_clear(track);
    search_track_add(track, (Pose){query->at, query->heading, 0, 0});
    SearchAnswer answer = SEARCH_FOUND;
    for (size_t leg = 0; leg < goal_count && answer == SEARCH_FOUND; leg++) {
        const Field *field = search_field(query, &goals[leg], radius);
        answer = search_leg(track, field, query->space, query->times ? &query->times[leg] : NULL, &goals[leg], body,
                            grain, leg + 1 == goal_count ? grain->least_reversals : 0, most_reversals);
        if (pins)
            pins[leg] = track->count - 1;
        fields_release(query->fields, field);
    }
    return answer;
}
