#include "route/fit.h"

#include <stdint.h>

#include "base/heap.h"
#include "base/key_table.h"
#include "base/memory.h"
#include "base/real.h"
#include "base/stop.h"

/* Certified subdivision of the poses (x, y, heading) of the body's middle (Brooks and Lozano-Perez 1985).
 *
 * A cell is a box of half sides h, h and d. With the half sides A and B of the body, its heading u in the middle of the
 * cell, and t = h (|u_x| + |u_y|), the body in the cell's middle with half sides
 *
 *     A + t + B sin d, B + t + A sin d   contains every placement of the cell,
 *     A - t - B sin d, B - t - A sin d   is contained in every placement.
 *
 * The body grows by m on every side until it touches something. If the first of the two may grow by g, all placements
 * may grow by at least g / (1 + sin d); if the second may grow by g, none may grow by more than g / (1 - sin d): those
 * are the cell's bounds `low` and `high`. Where the second has no area left, it proves nothing below that growth.
 *
 * The widest path (maximin; Pollack 1960) over the bounds `high` shows that no path is wider. It is confirmed within
 * FIT_RESOLUTION where the `low` of its cells is enough, or else by its motions from middle to middle: if no point of
 * the body moves farther than D between two placements, all placements in between may grow by m when those two together
 * may grow by 2 m + D; otherwise the motion is halved. Cells that are not confirmed are split in eight with their
 * neighbours, and the search goes on: what it has settled stays settled, but for what it had reached through a cell
 * that was split. Since a split only lowers bounds, no other path gets wider by it. A body and its half turn are one
 * placement, so the headings span half a turn, and a goal is reached if either of the two axles can reach it. Few cells
 * are needed where the walls are parallel to them, as they are in the frame of frame.c. Any rigid motion may be undone,
 * so that several goals can be passed in order if each one can be reached from the start. */

#define ROOT_HALF 0.08         /* m, half a side of the largest cells */
#define ROOT_TURN (M_PI / 24)  /* rad, half of their headings */
#define ON_THE_LINE 1e-6       /* m, so that rounding does not decide what lies on a cell's face */
#define THINNEST 0.8           /* 1, of the lesser half side: a body shrunk by more hardly has an area to prove with */
#define UNDECIDED_LENGTH 30.0F /* 1, factor on the lengths of cells with an open answer: others are preferred */
#define WIDE_ENOUGH 0.2        /* m: growth at one placement is known up to this much more than the cap */

enum { STEPS = 6, ROOT_TURNS = 12, MOST_LEVEL = 9, MOST_HALVINGS = 6, MOST_CELLS = 1 << 21, KEY_OFFSET = 1 << 20 };

typedef enum Seen { SEEN_NOT, SEEN_OPEN, SEEN_SETTLED } Seen;

typedef struct Cell {
    int x, y, turn;  /* place among the cells of its level */
    int level;       /* 0: largest; a cell of the next level is half as large in each of the three directions */
    int child;       /* first of eight, 0: not split */
    int top;         /* the largest cell around it, as an index of `tops` */
    Vec2 at;         /* m, its middle */
    float low, high; /* m, bounds of the growth of all placements */
    Seen seen;       /* in the search for this goal */
    float widest;    /* m, least bound on its path from the start */
    float length;    /* m, of that path */
    int from;        /* the cell before it, -1: the start */
    int place;       /* in the order in which cells were settled */
} Cell;

typedef struct Root {
    uint64_t key; /* 0: empty */
    int top;
} Root;

/* A cell from which the search continues. */
typedef struct Frontier {
    float widest; /* m */
    float whole;  /* m, length of the path to here plus the least remaining length */
    int cell;
} Frontier;

typedef struct Ints {
    int *at; /* (count) */
    size_t count, capacity;
} Ints;

typedef struct Tree {
    const RouteQuery *query;
    const Rectangle *body;
    const Goal *goal;
    Vec2 origin;  /* m, the middle of the body at the start, a corner of cells that lie along x and y */
    double cap;   /* m: more growth than this counts as this */
    double floor; /* m: cells with less are never entered */
    Cell *cells;  /* [0] is not used */
    size_t count, capacity;
    Ints tops;   /* the largest cells */
    Ints beside; /* (STEPS for each of them) those next to it, as indices of `tops`; -1: not looked for yet */
    Root *roots; /* where each top is */
    size_t root_count, root_capacity;
    Frontier *heap;
    size_t heap_count, heap_capacity;
    Ints settled;  /* the cells with a widest path from the start, in the order in which they were found */
    Ints changed;  /* cells that were split since the last search */
    double turned; /* rad, the body's heading at the start, 0 to half a turn */
} Tree;

KEY_TABLE_DEFINE(root, Root)

static double half_side(const Cell *cell) {
    return ROOT_HALF / (1 << cell->level);
}

static double half_turn(const Cell *cell) {
    return ROOT_TURN / (1 << cell->level);
}

static Vec2 middle_of(const Tree *tree, const Cell *cell) {
    double side = 2 * half_side(cell);
    return vec2_add(tree->origin, vec2((cell->x + 0.5) * side, (cell->y + 0.5) * side));
}

static double heading_of(const Cell *cell) {
    return (2 * cell->turn + 1) * half_turn(cell);
}

/* True if the place is on the grid of distances. Beyond the grid all space is free and leads nowhere. */
static bool is_on_the_grid(const FreeSpace *space, Vec2 at) {
    Vec2 from = vec2_sub(at, space->origin);
    return from.x >= 0 && from.y >= 0 && from.x <= space->cell * (space->nx - 1) &&
           from.y <= space->cell * (space->ny - 1);
}

static double growth(const Tree *tree, Vec2 centre, Vec2 axis, double half_length, double half_width, double reach) {
    return freespace_growth(tree->query->space, centre, axis, half_length, half_width, reach, NULL);
}

/* Sets the bounds of a cell, which are never farther apart than those of the cell around it. */
static void bound(const Tree *tree, Cell *cell, const Cell *around) {
    const Rectangle *body = tree->body;
    double heading = heading_of(cell), swing = real_sin(half_turn(cell)), half = half_side(cell);
    Vec2 axis = vec2_heading(heading);
    cell->at = middle_of(tree, cell);
    if (!is_on_the_grid(tree->query->space, cell->at)) {
        cell->low = cell->high = -HUGE_VALF;
        return;
    }
    double shift = half * (fabs(axis.x) + fabs(axis.y));
    double longer = shift + body->half_width * swing, wider = shift + body->half_length * swing;
    double low =
        growth(tree, cell->at, axis, body->half_length + longer, body->half_width + wider, tree->cap * (1 + swing)) /
        (1 + swing);
    double high = tree->cap;
    if (low < tree->cap) {
        double short_by = fmax(fmax(longer - body->half_length, wider - body->half_width), 0);
        high = (growth(tree, cell->at, axis, fmax(body->half_length - longer, 0), fmax(body->half_width - wider, 0),
                       tree->cap * (1 - swing)) +
                short_by) /
               (1 - swing);
        double none = fmax(wider - body->half_width, longer - body->half_length) / (1 - swing);
        high = fmin(fmax(high, none), tree->cap);
    }
    cell->low = (float)fmin(low, tree->cap) - 1e-7F;
    cell->high = (float)high + 1e-7F;
    if (around) {
        cell->low = fmaxf(cell->low, around->low);
        cell->high = fminf(cell->high, around->high);
    }
}

static void ints_add(Ints *ints, int value) {
    ints->at = memory_reserve(ints->at, &ints->capacity, ints->count + 1, sizeof *ints->at);
    ints->at[ints->count++] = value;
}

static int add_cell(Tree *tree, const Cell *cell) {
    tree->cells = memory_reserve(tree->cells, &tree->capacity, tree->count + 1, sizeof *tree->cells);
    tree->cells[tree->count] = *cell;
    return (int)tree->count++;
}

/* Returns the largest cell at a place, as an index of `tops`. */
static int top_of(Tree *tree, int x, int y, int turn) {
    bool fresh;
    uint64_t key =
        ((uint64_t)(x + KEY_OFFSET) << 32) ^ ((uint64_t)(y + KEY_OFFSET) << 4) ^ (uint64_t)turn ^ ((uint64_t)1 << 63);
    Root *root = root_enter(&tree->roots, &tree->root_count, &tree->root_capacity, key, &fresh);
    if (fresh) {
        Cell cell = {.x = x, .y = y, .turn = turn};
        bound(tree, &cell, NULL);
        cell.top = root->top = (int)tree->tops.count;
        ints_add(&tree->tops, add_cell(tree, &cell));
        for (int s = 0; s < STEPS; s++)
            ints_add(&tree->beside, -1);
    }
    return root->top;
}

static void split(Tree *tree, int index) {
    Cell parent = tree->cells[index];
    int first = 0;
    for (int part = 0; part < 8; part++) {
        Cell cell = {.x = 2 * parent.x + (part & 1),
                     .y = 2 * parent.y + (part >> 1 & 1),
                     .turn = 2 * parent.turn + (part >> 2 & 1),
                     .level = parent.level + 1,
                     .top = parent.top};
        bound(tree, &cell, &parent);
        int added = add_cell(tree, &cell);
        first = first ? first : added;
    }
    tree->cells[index].child = first;
    ints_add(&tree->changed, index);
}

/* Returns the cell at a place of a level within a largest one, or the larger one around it that is not split. */
static int cell_within(const Tree *tree, int top, int x, int y, int turn, int level) {
    int cell = tree->tops.at[top];
    for (int l = level - 1; l >= 0 && tree->cells[cell].child; l--)
        cell = tree->cells[cell].child + ((x >> l & 1) | (y >> l & 1) << 1 | (turn >> l & 1) << 2);
    return cell;
}

/* Returns the cell of the start, which is the tree's origin. */
static int start_cell(Tree *tree) {
    int turns = ROOT_TURNS << MOST_LEVEL, turn = (int)(tree->turned / ldexp(2 * ROOT_TURN, -MOST_LEVEL));
    turn = turn < turns ? turn : turns - 1;
    return cell_within(tree, top_of(tree, 0, 0, turn >> MOST_LEVEL), 0, 0, turn, MOST_LEVEL);
}

/* The steps to the neighbours of a cell. */
static const struct Step {
    int x, y, turn;
} steps[STEPS] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

static int neighbour(Tree *tree, int index, const struct Step *step) {
    const Cell *cell = &tree->cells[index];
    int level = cell->level, turns = ROOT_TURNS << level, top = cell->top;
    int x = cell->x + step->x, y = cell->y + step->y, turn = (cell->turn + step->turn + turns) % turns;
    if (x >> level != cell->x >> level || y >> level != cell->y >> level || turn >> level != cell->turn >> level) {
        int place = STEPS * top + (int)(step - steps), beside = tree->beside.at[place];
        top = beside < 0 ? top_of(tree, x >> level, y >> level, turn >> level) : beside;
        tree->beside.at[place] = top;
    }
    return cell_within(tree, top, x, y, turn, level);
}

static bool is_undecided(const Cell *cell, double width) {
    return (double)cell->low < width && cell->level < MOST_LEVEL &&
           (double)(cell->high - cell->low) > FIT_RESOLUTION / 2;
}

/* The goal ------------------------------------------------------------------------------------------------------- */

typedef enum Reach { REACH_NOT, REACH_PERHAPS, REACH_SURELY } Reach;

/* True if a segment meets the square about `centre` with sides of 2 `half`. */
static bool meets_square(Vec2 from, Vec2 to, Vec2 centre, double half) {
    double first = 0, last = 1;
    for (int axis = 0; axis < 2; axis++) {
        double at = axis ? from.y - centre.y : from.x - centre.x, along = axis ? to.y - from.y : to.x - from.x;
        if (along == 0 && fabs(at) > half)
            return false;
        if (along != 0) {
            double one = (-half - at) / along, other = (half - at) / along;
            first = fmax(first, fmin(one, other));
            last = fmin(last, fmax(one, other));
        }
    }
    return first <= last;
}

/* Tells whether a cell has a placement with an axle on the exit's line. */
static Reach reach_line(const Cell *cell, Vec2 axle, double sway, Vec2 from, Vec2 to) {
    double half = half_side(cell) + ON_THE_LINE;
    if (!meets_square(from, to, axle, half + sway))
        return REACH_NOT;
    return meets_square(from, to, axle, half) ? REACH_SURELY : REACH_PERHAPS;
}

static Reach reach_point(const Cell *cell, Vec2 axle, double sway, Vec2 at, double radius) {
    double half = half_side(cell) + ON_THE_LINE;
    Vec2 apart = vec2_sub(at, axle);
    double least = vec2_length(vec2(fmax(fabs(apart.x) - half, 0), fmax(fabs(apart.y) - half, 0)));
    return least <= radius ? REACH_SURELY : least <= radius + sway ? REACH_PERHAPS : REACH_NOT;
}

/* Returns a lower bound of the distance to the goal, m. */
static double distance_to_go(const Tree *tree, Vec2 at) {
    if (tree->goal->radius > 0)
        return fmax(vec2_distance(at, tree->goal->at) - tree->goal->radius, 0);
    const Plan *plan = tree->query->plan;
    double nearest = HUGE_VAL;
    for (size_t e = 0; e < plan->exit_count; e++)
        if (field_exit_usable(tree->goal, plan, e))
            nearest =
                fmin(nearest, vec2_distance(at, vec2_nearest_on_segment(at, plan->exits[e].from, plan->exits[e].to)));
    return nearest;
}

static Reach reach_goal(const Tree *tree, const Cell *cell) {
    const Plan *plan = tree->query->plan;
    const Goal *goal = tree->goal;
    Reach best = REACH_NOT;
    double ahead = fabs(tree->body->ahead), sway = ahead * half_turn(cell);
    if (distance_to_go(tree, cell->at) > ahead + sway + 2 * half_side(cell))
        return REACH_NOT;
    Vec2 axis = vec2_heading(heading_of(cell));
    for (int end = -1; end <= 1; end += 2) {
        Vec2 axle = vec2_along(cell->at, end * ahead, axis);
        Reach reach = REACH_NOT;
        if (goal->radius > 0)
            reach = reach_point(cell, axle, sway, goal->at, goal->radius);
        for (size_t e = 0; !(goal->radius > 0) && e < plan->exit_count; e++)
            if (field_exit_usable(goal, plan, e)) {
                Reach line = reach_line(cell, axle, sway, plan->exits[e].from, plan->exits[e].to);
                reach = line > reach ? line : reach;
            }
        best = reach > best ? reach : best;
    }
    return best;
}

/* The search ----------------------------------------------------------------------------------------------------- */

static bool before(Frontier a, Frontier b) {
    if (a.widest > b.widest || a.widest < b.widest)
        return a.widest > b.widest;
    return a.whole < b.whole || (a.whole <= b.whole && a.cell > b.cell);
}

HEAP_DEFINE(heap, Frontier, before)

/* Enters a cell from a settled one (-1: the start), unless it is settled or open along a path that is as good. */
static void enter(Tree *tree, int index, int from) {
    Cell *cell = &tree->cells[index];
    if (cell->seen == SEEN_SETTLED || (double)cell->high < tree->floor)
        return;
    float widest = fminf(cell->high, (float)tree->cap), length = 0;
    if (from >= 0) {
        const Cell *last = &tree->cells[from];
        float step = (float)vec2_distance(cell->at, last->at);
        if (cell->turn != last->turn || cell->level != last->level)
            step += (float)((half_turn(cell) + half_turn(last)) * tree->body->half_length);
        widest = fminf(widest, last->widest);
        length = last->length + step * ((double)cell->low < tree->cap - FIT_RESOLUTION ? UNDECIDED_LENGTH : 1);
    }
    if (cell->seen == SEEN_OPEN && !(widest > cell->widest || (widest >= cell->widest && length < cell->length)))
        return;
    cell->seen = SEEN_OPEN;
    cell->from = from;
    cell->widest = widest;
    cell->length = length;
    heap_put(&tree->heap, &tree->heap_count, &tree->heap_capacity,
             (Frontier){widest, length + (float)distance_to_go(tree, cell->at), index});
}

/* Calls `visit` with each cell that is not split within a cell, on the side that a step comes from. */
static void visit_side(Tree *tree, int index, const struct Step *step, int from,
                       void (*visit)(Tree *tree, int index, int from)) {
    int child = tree->cells[index].child;
    if (!child) {
        visit(tree, index, from);
        return;
    }
    if ((double)tree->cells[index].high < tree->floor)
        return;
    for (int part = 0; part < 8; part++) {
        int x = part & 1, y = part >> 1 & 1, turn = part >> 2 & 1;
        if (step->x * (2 * x - 1) <= 0 && step->y * (2 * y - 1) <= 0 && step->turn * (2 * turn - 1) <= 0)
            visit_side(tree, child + part, step, from, visit);
    }
}

static void visit_neighbours(Tree *tree, int index, void (*visit)(Tree *tree, int index, int from)) {
    for (int s = 0; s < STEPS; s++)
        visit_side(tree, neighbour(tree, index, &steps[s]), &steps[s], index, visit);
}

static void enter_from_settled(Tree *tree, int settled, int index) {
    if (tree->cells[settled].seen == SEEN_SETTLED)
        enter(tree, index, settled);
}

/* Enters a cell from those of its neighbours that are settled. */
static void enter_again(Tree *tree, int index) {
    if (!tree->cells[index].child && tree->cells[index].seen == SEEN_NOT)
        visit_neighbours(tree, index, enter_from_settled);
}

/* Forgets a cell that was reached through a cell that is not settled any more. */
static void forget_lost(Tree *tree, int index, Ints *lost) {
    Cell *cell = &tree->cells[index];
    if (cell->seen == SEEN_NOT || (!cell->child && (cell->from < 0 || tree->cells[cell->from].seen == SEEN_SETTLED)))
        return;
    cell->seen = SEEN_NOT;
    ints_add(lost, index);
}

/* After cells were split: forgets them and all that was reached through them, and enters what lies beside the rest. */
static void mend(Tree *tree) {
    Ints lost = {0};
    size_t first = tree->settled.count, kept;
    for (size_t i = 0; i < tree->changed.count; i++) {
        const Cell *cell = &tree->cells[tree->changed.at[i]];
        if (cell->seen == SEEN_SETTLED && (size_t)cell->place < first)
            first = (size_t)cell->place;
    }
    kept = first;
    for (size_t i = first; i < tree->settled.count; i++) {
        int index = tree->settled.at[i];
        forget_lost(tree, index, &lost);
        if (tree->cells[index].seen == SEEN_SETTLED) {
            tree->cells[index].place = (int)kept;
            tree->settled.at[kept++] = index;
        }
    }
    tree->settled.count = kept;
    for (size_t i = 0; i < tree->heap_count; i++)
        if (tree->cells[tree->heap[i].cell].seen == SEEN_OPEN)
            forget_lost(tree, tree->heap[i].cell, &lost);
    for (size_t i = 0; i < lost.count; i++)
        enter_again(tree, lost.at[i]);
    for (size_t i = 0; i < tree->changed.count; i++)
        for (int part = 0; part < 8; part++)
            enter_again(tree, tree->cells[tree->changed.at[i]].child + part);
    tree->changed.count = 0;
    memory_free(lost.at);
}

/* Takes the next open cell, or -1; what stands in the heap along a path that is not the cell's any more is passed. */
static int take(Tree *tree) {
    while (tree->heap_count > 0) {
        Frontier next = heap_take(tree->heap, &tree->heap_count);
        const Cell *cell = &tree->cells[next.cell];
        if (cell->seen == SEEN_OPEN && !cell->child && next.widest <= cell->widest)
            return next.cell;
    }
    return -1;
}

/* Returns the last cell of the widest path, or -1. */
static int widest_way(Tree *tree) {
    mend(tree);
    int start = start_cell(tree);
    if (tree->cells[start].seen == SEEN_NOT)
        enter(tree, start, -1);
    while (tree->count < MOST_CELLS && !stop_requested(tree->query->stop)) {
        int index = take(tree);
        if (index < 0)
            break;
        Reach reach = reach_goal(tree, &tree->cells[index]);
        if (reach == REACH_SURELY || (reach == REACH_PERHAPS && tree->cells[index].level == MOST_LEVEL)) {
            tree->cells[index].seen = SEEN_NOT;
            enter(tree, index, tree->cells[index].from); /* it stays open for the next search */
            return index;
        }
        if (reach == REACH_PERHAPS) {
            split(tree, index);
            tree->changed.count--; /* it is not settled, and its children are entered here */
            int from = tree->cells[index].from, child = tree->cells[index].child;
            for (int part = 0; part < 8; part++)
                enter(tree, child + part, from);
            continue;
        }
        tree->cells[index].seen = SEEN_SETTLED;
        tree->cells[index].place = (int)tree->settled.count;
        ints_add(&tree->settled, index);
        visit_neighbours(tree, index, enter);
    }
    return -1;
}

/* A placement of the body, and by how much it may grow there. */
typedef struct Placement {
    Vec2 at;              /* m, of the middle */
    double heading, wide; /* rad, m */
} Placement;

static Placement placement(const Tree *tree, Vec2 at, double heading) {
    return (Placement){at, heading,
                       growth(tree, at, vec2_heading(heading), tree->body->half_length, tree->body->half_width,
                              tree->cap + WIDE_ENOUGH)};
}

/* True if the body may grow by `width` all the way from one placement to another. */
static bool is_motion_wide(const Tree *tree, const Placement *a, const Placement *b, double width, int halvings) {
    double corner = vec2_length(vec2(tree->body->half_length + width, tree->body->half_width + width));
    double farthest = vec2_distance(a->at, b->at) + fabs(a->heading - b->heading) * corner;
    if (a->wide < width || b->wide < width)
        return false;
    if (a->wide + b->wide - 2 * width >= farthest)
        return true;
    if (halvings == MOST_HALVINGS)
        return false;
    Placement middle = placement(tree, vec2_scale(vec2_add(a->at, b->at), 0.5), (a->heading + b->heading) / 2);
    return is_motion_wide(tree, a, &middle, width, halvings + 1) &&
           is_motion_wide(tree, &middle, b, width, halvings + 1);
}

/* True if the body may grow by `width` all the way from the middle of a cell to that of a neighbour. */
static bool is_step_wide(const Tree *tree, const Cell *from, const Cell *to, double width) {
    double heading = heading_of(from), turn = heading_of(to) - heading;
    turn -= M_PI * round(turn / M_PI);
    Placement a = placement(tree, from->at, heading), b = placement(tree, to->at, heading + turn);
    return is_motion_wide(tree, &a, &b, width, 0);
}

/* Collects the cells of a path at which neither their bound nor the motion through them confirms the width. */
static int *doubtful_cells(const Tree *tree, int last, double width, size_t *count) {
    int *doubtful = NULL;
    size_t capacity = 0;
    bool wide_on = false; /* the motion to the next cell is wide; at the last cell it would be one within it */
    *count = 0;
    for (int index = last; index >= 0; index = tree->cells[index].from) {
        const Cell *cell = &tree->cells[index], *before = cell->from >= 0 ? &tree->cells[cell->from] : NULL;
        bool undecided = is_undecided(cell, width);
        bool wide_to = before && (undecided || is_undecided(before, width)) && is_step_wide(tree, before, cell, width);
        if (undecided && !(wide_to && wide_on)) {
            doubtful = memory_reserve(doubtful, &capacity, *count + 1, sizeof *doubtful);
            doubtful[(*count)++] = index;
        }
        wide_on = wide_to;
    }
    return doubtful;
}

/* Splits the cells of a path that may be narrower than it, and their neighbours. Returns false if there is none. */
static bool refine(Tree *tree, int last) {
    double width = (double)tree->cells[last].widest - FIT_RESOLUTION;
    size_t count;
    int *doubtful = doubtful_cells(tree, last, width, &count);
    for (size_t i = 0; i < count; i++) {
        int level = tree->cells[doubtful[i]].level;
        for (int s = 0; s < STEPS; s++) {
            int beside = neighbour(tree, doubtful[i], &steps[s]);
            const Cell *cell = &tree->cells[beside];
            if (!cell->child && cell->level <= level && is_undecided(cell, width) && (double)cell->high >= tree->floor)
                split(tree, beside);
        }
        if (!tree->cells[doubtful[i]].child)
            split(tree, doubtful[i]);
    }
    memory_free(doubtful);
    return count > 0;
}

void fit_find_face(const FreeSpace *space, const Rectangle *body, FitPlace *place) {
    FreeSpace unnoted = *space;
    unnoted.reads = NULL; /* the face is found again where the place is recalled */
    if (place->far)
        freespace_growth(&unnoted, place->centre, vec2_heading(place->heading), body->half_length, body->half_width,
                         FREESPACE_FARTHEST, &place->face);
}

/* Lowers `place` to the tightest cell of a path. */
static void note_tightest(const Tree *tree, int last, FitPlace *place) {
    int tightest = last;
    for (int cell = last; cell >= 0; cell = tree->cells[cell].from)
        if (tree->cells[cell].high < tree->cells[tightest].high)
            tightest = cell;
    const Cell *cell = &tree->cells[tightest];
    *place = (FitPlace){cell->at, heading_of(cell), (double)tree->cells[last].widest, place->face, true};
    fit_find_face(tree->query->space, tree->body, place);
}

/* Finds the tightest place on the way to one goal, if it is tighter than the cap. */
static void fit_goal(Tree *tree, const Goal *goal, FitPlace *tightest) {
    tree->goal = goal;
    tree->settled.count = tree->changed.count = tree->heap_count = 0;
    for (size_t i = 0; i < tree->count; i++)
        tree->cells[i].seen = SEEN_NOT;
    for (;;) {
        int last = widest_way(tree);
        if (stop_requested(tree->query->stop))
            return;
        if (last < 0) {
            tightest->margin = tree->count < MOST_CELLS ? -HUGE_VAL : tightest->margin;
            return;
        }
        if (!refine(tree, last)) {
            if ((double)tree->cells[last].widest < tree->cap)
                note_tightest(tree, last, tightest);
            return;
        }
    }
}

FitAnswer fit_margin(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count, double least,
                     double most, FitPlace *tightest) {
    Vec2 axis = vec2_heading(query->heading), centre = vec2_along(query->at, body->ahead, axis);
    *tightest = (FitPlace){centre, query->heading, most, -1, false};
    tightest->margin =
        freespace_growth(query->space, centre, axis, body->half_length, body->half_width, most, &tightest->face);
    Tree tree = {.query = query, .body = body, .origin = centre, .cap = tightest->margin, .count = 1};
    tree.turned = query->heading - M_PI * floor(query->heading / M_PI);
    tree.floor = fmax(least, -THINNEST * fmin(body->half_length, body->half_width));
    tree.cells = memory_reserve(NULL, &tree.capacity, 1024, sizeof *tree.cells);
    for (size_t g = 0; g < goal_count && tightest->margin > -HUGE_VAL; g++) {
        fit_goal(&tree, &goals[g], tightest);
        tree.cap = tightest->margin;
    }
    memory_free(tree.cells);
    memory_free(tree.settled.at);
    memory_free(tree.changed.at);
    memory_free(tree.roots);
    memory_free(tree.tops.at);
    memory_free(tree.beside.at);
    memory_free(tree.heap);
    tightest->margin -= FIT_RESOLUTION;
    return stop_requested(query->stop) ? FIT_INTERRUPTED : FIT_KNOWN;
}
