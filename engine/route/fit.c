#include "route/fit.h"

#include <stdint.h>

#include "base/heap.h"
#include "base/key_table.h"
#include "base/memory.h"
#include "base/stop.h"

/* The widest path (maximin; Pollack 1960) of the rectangle's growth over a lattice of the body's middle and heading,
 * six neighbours a node: the growth of a path is the least on it, and the search always goes on from the node with the
 * largest, so that the first arrival is the best. Growth above a cap counts as the cap; of equal nodes the one nearer
 * to the goal goes first.
 *
 * The lattice starts coarse. Where its path is tight, the lattice is halved repeatedly in a tube of one coarse cell
 * about the path; the nodes of each lattice are nodes of the next, so that the margin can only grow. The margin is low
 * by about half a cell, 1.5 mm on the finest lattice. If the margin of a path becomes negative, the path is blocked at
 * its tightest place and another one is searched, as long as the coarse lattice allows a better one. */

#define FINEST_CELL 0.004 /* m: the lattice is halved while its cell is larger */
#define ALMOST 0.006      /* m, missing margin */
#define COARSE_CELL 0.1   /* m */
#define COARSE_TURNS 24   /* in a full turn */
#define BLOCKED_REACH 0.2 /* m, about a tightest place that is too tight */

enum { MOST_STATES = 4000000, MOST_ALTERNATIVES = 3, KEY_OFFSET = 1 << 24 };

typedef struct State {
    int x, y, turn; /* lattice, from the start's middle and heading */
    float growth;   /* m */
    float widest;   /* m, widest growth along the path to here */
    float length;   /* m, length of the path to here, with turns counted by the motion of the body's ends */
    int parent;     /* -1: the start */
} State;

typedef struct Slot {
    uint64_t key; /* 0: empty */
    int state;
} Slot;

/* A state from which the search continues. */
typedef struct Frontier {
    float widest; /* m */
    float whole;  /* m, length of the path to here plus the least remaining length */
    int state;
} Frontier;

/* States by their lattice coordinates. */
typedef struct Table {
    Slot *slots;
    size_t count, capacity;
} Table;

typedef struct Lattice {
    const RouteQuery *query;
    const Rectangle *body;
    const Goal *goal;
    Vec2 origin;         /* m */
    double bearing;      /* rad */
    double cell;         /* m */
    int turns;           /* in a full turn */
    double cap;          /* m */
    const Table *tube;   /* cells of the lattice twice as coarse that may be entered, or NULL */
    const State *end;    /* state of that lattice that replaces `goal`, or NULL */
    const Vec2 *blocked; /* (blocked_count) m */
    size_t blocked_count;
    State *states;
    size_t state_count, state_capacity;
    Frontier *heap;
    size_t heap_count, heap_capacity;
    Table table;
} Lattice;

static uint64_t key_of(int x, int y, int turn) {
    return ((uint64_t)(x + KEY_OFFSET) << 38) ^ ((uint64_t)(y + KEY_OFFSET) << 12) ^ (uint64_t)turn ^
           ((uint64_t)1 << 63);
}

KEY_TABLE_DEFINE(slot, Slot)

/* Returns the slot of a key; `*fresh` is true if the slot is new. */
static Slot *table_take(Table *table, uint64_t key, bool *fresh) {
    return slot_enter(&table->slots, &table->count, &table->capacity, key, fresh);
}

static bool table_holds(const Table *table, uint64_t key) {
    return table->capacity && slot_find(table->slots, table->capacity, key)->key == key;
}

static void table_clear(Table *table) {
    memory_free(table->slots);
    *table = (Table){0};
}

static int wrapped(int turn, int turns) {
    return turn < 0 ? turn + turns : turn >= turns ? turn - turns : turn;
}

static Vec2 centre_of(const Lattice *lattice, int x, int y) {
    return vec2(lattice->origin.x + x * lattice->cell, lattice->origin.y + y * lattice->cell);
}

static double heading_of(const Lattice *lattice, int turn) {
    return lattice->bearing + turn * (2 * M_PI / lattice->turns);
}

static double growth_at(const Lattice *lattice, Vec2 centre, double heading, int *face) {
    return freespace_growth(lattice->query->space, centre, vec2_heading(heading), lattice->body->half_length,
                            lattice->body->half_width, lattice->cap, face);
}

/* Returns a lower bound of the distance to the goal, m. */
static double distance_to_go(const Lattice *lattice, Vec2 at) {
    if (lattice->end)
        return vec2_distance(at, vec2(lattice->origin.x + 2 * lattice->cell * lattice->end->x,
                                      lattice->origin.y + 2 * lattice->cell * lattice->end->y));
    if (lattice->goal->radius > 0)
        return vec2_distance(at, lattice->goal->at);
    const Plan *plan = lattice->query->plan;
    double nearest = HUGE_VAL;
    for (size_t e = 0; e < plan->exit_count; e++)
        if (field_exit_usable(lattice->goal, plan, e))
            nearest =
                fmin(nearest, vec2_distance(at, vec2_nearest_on_segment(at, plan->exits[e].from, plan->exits[e].to)));
    return nearest;
}

static bool before(Frontier a, Frontier b) {
    if (a.widest > b.widest || a.widest < b.widest)
        return a.widest > b.widest;
    return a.whole < b.whole || (a.whole <= b.whole && a.state > b.state);
}

HEAP_DEFINE(heap, Frontier, before)

static bool is_blocked(const Lattice *lattice, Vec2 centre) {
    for (size_t i = 0; i < lattice->blocked_count; i++)
        if (vec2_distance(lattice->blocked[i], centre) < BLOCKED_REACH)
            return true;
    return false;
}

/* Enters a lattice point for the first time, along a widest path, which is also its best one. */
/* True if the place is on the grid of distances. Beyond the grid all space is free and leads nowhere. */
static bool is_on_the_grid(const FreeSpace *space, Vec2 at) {
    Vec2 from = vec2_sub(at, space->origin);
    return from.x >= 0 && from.y >= 0 && from.x <= space->cell * (space->nx - 1) &&
           from.y <= space->cell * (space->ny - 1);
}

static void enter(Lattice *lattice, int x, int y, int turn, int parent, double step) {
    if (lattice->tube && !table_holds(lattice->tube, key_of(x >> 1, y >> 1, turn >> 1)))
        return;
    bool fresh;
    Slot *slot = table_take(&lattice->table, key_of(x, y, turn), &fresh);
    if (!fresh)
        return;
    Vec2 centre = centre_of(lattice, x, y);
    if (!is_on_the_grid(lattice->query->space, centre) || (lattice->blocked_count && is_blocked(lattice, centre)))
        return;
    size_t index = lattice->state_count;
    slot->state = (int)index;
    lattice->states = memory_reserve(lattice->states, &lattice->state_capacity, index + 1, sizeof(State));
    State state = {x, y, turn, (float)growth_at(lattice, centre, heading_of(lattice, turn), NULL), 0, 0, parent};
    state.widest = state.growth;
    if (parent >= 0) {
        state.widest = fminf(state.growth, lattice->states[parent].widest);
        state.length = lattice->states[parent].length + (float)step;
    }
    lattice->states[index] = state;
    lattice->state_count++;
    heap_put(&lattice->heap, &lattice->heap_count, &lattice->heap_capacity,
             (Frontier){state.widest, state.length + (float)distance_to_go(lattice, centre), (int)index});
}

/* True if the path to this state ends there. */
static bool arrived(const Lattice *lattice, const State *state) {
    if (lattice->end)
        return state->x == 2 * lattice->end->x && state->y == 2 * lattice->end->y &&
               state->turn == 2 * lattice->end->turn;
    const State *from = state->parent >= 0 ? &lattice->states[state->parent] : state;
    double ahead = lattice->body->ahead;
    Vec2 before_it =
        vec2_along(centre_of(lattice, from->x, from->y), -ahead, vec2_heading(heading_of(lattice, from->turn)));
    Vec2 here =
        vec2_along(centre_of(lattice, state->x, state->y), -ahead, vec2_heading(heading_of(lattice, state->turn)));
    size_t exit;
    return field_goal_reached(lattice->goal, lattice->query->plan, before_it, here, &exit);
}

/* Returns the last state of the widest path from a lattice point to the goal, or -1. */
static int widest_way(Lattice *lattice, int x, int y, int turn) {
    double swing = 2 * M_PI / lattice->turns * lattice->body->half_length, cell = lattice->cell;
    enter(lattice, x, y, turn, -1, 0);
    const Stop *stop = lattice->query->stop;
    while (lattice->heap_count > 0 && lattice->state_count < MOST_STATES && !stop_requested(stop)) {
        int index = heap_take(lattice->heap, &lattice->heap_count).state;
        State state = lattice->states[index];
        if (arrived(lattice, &state))
            return index;
        enter(lattice, state.x + 1, state.y, state.turn, index, cell);
        enter(lattice, state.x - 1, state.y, state.turn, index, cell);
        enter(lattice, state.x, state.y + 1, state.turn, index, cell);
        enter(lattice, state.x, state.y - 1, state.turn, index, cell);
        enter(lattice, state.x, state.y, wrapped(state.turn + 1, lattice->turns), index, swing);
        enter(lattice, state.x, state.y, wrapped(state.turn - 1, lattice->turns), index, swing);
    }
    return -1;
}

static void lattice_clear(Lattice *lattice) {
    memory_free(lattice->states);
    memory_free(lattice->heap);
    table_clear(&lattice->table);
}

/* A path on one lattice. */
typedef struct Way {
    State *states; /* (count), from the start */
    size_t count;
    float widest;
    bool cut; /* True if the path ends before the goal, where the rest is wide enough */
} Way;

static Way way_take(const Lattice *lattice, int last) {
    Way way = {.widest = lattice->states[last].widest};
    for (int s = last; s >= 0; s = lattice->states[s].parent)
        way.count++;
    way.states = memory_zeroed(way.count, sizeof *way.states);
    size_t place = way.count;
    for (int s = last; s >= 0; s = lattice->states[s].parent)
        way.states[--place] = lattice->states[s];
    return way;
}

/* Returns the cells within one cell of a path. */
static Table tube_about(const State *states, size_t count, int turns) {
    Table tube = {0};
    bool fresh;
    for (size_t i = 0; i < count; i++) {
        const State *at = &states[i], *last = &states[i > 0 ? i - 1 : 0];
        /* One step from the last state, only the side that faces forwards is new. */
        int x = at->x - last->x, y = at->y - last->y, turn = at->turn - last->turn;
        turn = turn > 1 ? -1 : turn < -1 ? 1 : turn;
        for (int n = 0; n < 27; n++) {
            int dx = n % 3 - 1, dy = n / 3 % 3 - 1, dt = n / 9 - 1;
            if (i == 0 || dx * x + dy * y + dt * turn > 0)
                table_take(&tube, key_of(at->x + dx, at->y + dy, wrapped(at->turn + dt, turns)), &fresh);
        }
    }
    return tube;
}

/* Halves the lattice about the tight stretch of a path and replaces the path by the widest one there. The lattice then
 * has the new cell size. */
static bool refine(Lattice *lattice, Way *way) {
    double swing = 2 * M_PI / lattice->turns * lattice->body->half_length;
    double cap = fmin(FIT_MOST, (double)way->widest + 0.75 * lattice->cell + 0.5 * swing);
    size_t low = 0, high = way->count - 1;
    while (low < high && (double)way->states[low].growth >= cap)
        low++;
    while (high > low && (double)way->states[high].growth >= cap)
        high--;
    low = low >= 2 ? low - 2 : 0;
    high = high + 2 < way->count ? high + 2 : way->count - 1;
    Table tube = tube_about(way->states + low, high - low + 1, lattice->turns);
    Lattice fine = {.query = lattice->query,
                    .body = lattice->body,
                    .goal = lattice->goal,
                    .origin = lattice->origin,
                    .bearing = lattice->bearing,
                    .cell = lattice->cell / 2,
                    .turns = lattice->turns * 2,
                    .cap = cap,
                    .tube = &tube,
                    .end = high + 1 < way->count || way->cut ? &way->states[high] : NULL};
    const State *start = &way->states[low];
    int last = widest_way(&fine, 2 * start->x, 2 * start->y, 2 * start->turn);
    if (last >= 0) {
        Way better = way_take(&fine, last);
        better.cut = fine.end != NULL;
        memory_free(way->states);
        *way = better;
        lattice->cell = fine.cell;
        lattice->turns = fine.turns;
    }
    lattice_clear(&fine);
    table_clear(&tube);
    return last >= 0;
}

static void note_tightest(const Lattice *lattice, const Way *way, FitPlace *place) {
    const State *tightest = &way->states[0];
    for (size_t i = 1; i < way->count; i++)
        if (way->states[i].growth < tightest->growth)
            tightest = &way->states[i];
    place->centre = centre_of(lattice, tightest->x, tightest->y);
    place->heading = heading_of(lattice, tightest->turn);
    place->margin = growth_at(lattice, place->centre, place->heading, &place->face);
}

/* Computes the margin on a lattice of `cell` and `turns`, halved down to FINEST_CELL. Returns false if the coarse
 * lattice already excludes `needed`. The leg's end is returned in `centre` and `heading`. */
static bool fit_from(const RouteQuery *query, const Rectangle *body, const Goal *goal, double cell, int turns,
                     const Vec2 *blocked, size_t blocked_count, double needed, Vec2 *centre, double *heading,
                     FitPlace *place) {
    Lattice lattice = {.query = query,
                       .body = body,
                       .goal = goal,
                       .origin = *centre,
                       .bearing = *heading,
                       .cell = cell,
                       .turns = turns,
                       .cap = FIT_MOST,
                       .blocked = blocked,
                       .blocked_count = blocked_count};
    int last = widest_way(&lattice, 0, 0, 0);
    double slack = 0.75 * cell + 0.5 * (2 * M_PI / turns) * body->half_length;
    bool promising = last >= 0 && (double)lattice.states[last].widest + slack > needed;
    if (promising) {
        Way way = way_take(&lattice, last);
        const State *end = &way.states[way.count - 1];
        *centre = centre_of(&lattice, end->x, end->y);
        *heading = heading_of(&lattice, end->turn);
        note_tightest(&lattice, &way, place);
        while (lattice.cell > FINEST_CELL && place->margin < FIT_MOST && refine(&lattice, &way))
            note_tightest(&lattice, &way, place);
        memory_free(way.states);
    }
    lattice_clear(&lattice);
    return promising;
}

/* Computes one leg from a pose of the body's middle, and moves the pose to the leg's end. */
static FitPlace fit_leg(const RouteQuery *query, const Rectangle *body, const Goal *goal, Vec2 *centre,
                        double *heading) {
    FitPlace best = {*centre, *heading, -HUGE_VAL, -1};
    Vec2 blocked[MOST_ALTERNATIVES], end = *centre;
    double final = *heading;
    for (size_t attempt = 0; attempt < MOST_ALTERNATIVES && best.margin < 0; attempt++) {
        FitPlace place = best;
        /* If the margin is almost sufficient, retry from a lattice twice as fine, whose tube may lie better. */
        for (int halved = 0;
             halved < 2 && (!halved || (place.margin < 0 && place.margin > -ALMOST && place.margin >= best.margin));
             halved++) {
            Vec2 there = *centre;
            double turned = *heading;
            if (!fit_from(query, body, goal, COARSE_CELL / (1 + halved), COARSE_TURNS * (1 + halved), blocked, attempt,
                          best.margin, &there, &turned, &place))
                break;
            if (place.margin > best.margin) {
                best = place;
                end = there;
                final = turned;
            }
        }
        if (!(place.margin > -HUGE_VAL))
            break;
        blocked[attempt] = place.centre;
    }
    *centre = end;
    *heading = final;
    return best;
}

FitAnswer fit_margin(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count,
                     FitPlace *tightest) {
    Vec2 centre = vec2_along(query->at, body->ahead, vec2_heading(query->heading));
    double heading = query->heading;
    *tightest = (FitPlace){centre, heading, FIT_MOST, -1};
    for (size_t g = 0; g < goal_count; g++) {
        FitPlace place = fit_leg(query, body, &goals[g], &centre, &heading);
        if (place.margin < tightest->margin)
            *tightest = place;
        if (!(place.margin > -HUGE_VAL))
            break; /* the house is too large to decide */
    }
    return stop_requested(query->stop) ? FIT_INTERRUPTED : FIT_KNOWN;
}
