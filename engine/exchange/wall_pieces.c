#include "exchange/wall_pieces.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "mechanics/broadphase.h"

static const double THINNEST = 0.04, THICKEST = 0.6; /* m: distance of a wall's faces */
static const double PARALLEL = 2e-3;                 /* m: largest difference of the distances at both ends */
static const double SHORTEST = 0.01;                 /* m: a shorter line is ignored */
static const double STOUTEST = 3;                    /* 1: a piece is at most this many times thicker than long */
static const double USUAL = 1;     /* m: pieces longer than thick of at least this length have a wall's thickness */
static const double SAME = 1e-3;   /* m: lines with ends closer than this are one */
static const double TURN = 0.01;   /* 1: sine of the largest turn between lines that continue each other */
static const double NIB = 0.03;    /* m: shortest piece next to a corner */
static const double EQUAL = 3e-3;  /* m: thicknesses and axes closer than this are equal */
static const double IN_LINE = 3;   /* m: such a piece is confirmed by one in line with it, at most this far away */
static const double TOUCH = 0.02;  /* m: stretches of a line closer than this touch */
static const double SKIN = 5e-3;   /* m: a line this near to a face is not between the faces */
static const double CAVITY = 0.25; /* m: parallel lines closer than this are layers of one wall */
static const double LAYERED = 0.9; /* 1: share of a pair's length along which lines between its faces run */
static const double CLASS = 0.005; /* m: distances are counted in classes of this width */

enum {
    CLASSES = 130,
    MOST_LINES = 20000,
    MOST_MEETINGS = 2000000, /* pairs of lines with boxes that meet */
    MOST_PARTS = 32,         /* stretches into which a pair is cut */
    MOST_LAYERS = 16,        /* lines between two faces */
    MOST_PARTNERS = 64       /* pairs of a line that are compared */
};

/* A stretch of a line that is already a face; `next` is an index, or SIZE_MAX. */
typedef struct Taken {
    double low, high;
    double offset; /* m, of the other face: positive to the left; 0: within a wall */
    size_t next;
} Taken;

typedef struct Face {
    Vec2 a, b, along;
    double length;
    size_t taken; /* first stretch, or SIZE_MAX */
    bool spare;
} Face;

/* Two lines side by side: the first is the longer one, and `low` to `high` is measured along it. */
typedef struct Pair {
    int one, other;
    double low, high, offset; /* m; the offset is positive to the left of `one` */
    double support;           /* m: length of all pairs of this distance */
    size_t layers;            /* number of lines between the two, if all are layers of one wall */
    bool is_space;            /* both lines have a nearer partner on their other sides */
} Pair;

typedef struct Finder {
    Face *faces; /* (count) */
    size_t count;
    Pair *pairs;
    size_t pair_count, pair_capacity;
    Taken *taken;
    size_t taken_count, taken_capacity;
    Broadphase *tree;
    int current, found;
    size_t met;
    WallPieces *pieces;
    size_t doubled;
} Finder;

static void collect(Finder *finder, const WallLines *lines, double scale) {
    finder->faces = memory_zeroed(lines->count, sizeof *finder->faces);
    for (size_t l = 0; l < lines->count; l++) {
        const WallLine *line = &lines->list[l];
        Face *face = &finder->faces[l];
        Vec2 origin = lines->list[0].a; /* keeps the digits of a plan in the coordinates of a survey */
        face->a = vec2_scale(vec2_sub(line->a, origin), scale);
        face->b = vec2_scale(vec2_sub(line->b, origin), scale);
        face->length = vec2_distance(face->a, face->b);
        face->along = vec2_unit(vec2_sub(face->b, face->a));
        face->taken = SIZE_MAX;
        face->spare = line->thickness > 0 || face->length < SHORTEST || !(face->length < 1e6);
    }
    finder->count = lines->count;
}

static Box box_of(const Face *face) {
    return box_include(box_include(box_empty(), face->a), face->b);
}

static bool are_same(const Face *face, const Face *other) {
    return (vec2_distance(face->a, other->a) < SAME && vec2_distance(face->b, other->b) < SAME) ||
           (vec2_distance(face->a, other->b) < SAME && vec2_distance(face->b, other->a) < SAME);
}

/* Lines that repeat or continue others ---------------------------------------------------------------------------- */

static bool visit_same(void *context, int item) {
    Finder *finder = context;
    finder->faces[finder->current].spare |= are_same(&finder->faces[finder->current], &finder->faces[item]);
    return !finder->faces[finder->current].spare;
}

static void drop_doubled(Finder *finder) {
    finder->tree = broadphase_create();
    for (size_t f = 0; f < finder->count; f++) {
        Face *face = &finder->faces[f];
        if (face->spare)
            continue;
        finder->current = (int)f;
        broadphase_visit(finder->tree, box_expand(box_of(face), SAME), visit_same, finder);
        finder->doubled += face->spare;
        if (!face->spare)
            broadphase_insert(finder->tree, box_of(face), (int)f);
    }
    broadphase_destroy(finder->tree);
}

/* True if a line from `at` to `far` continues the face beyond its end `end`. */
static bool goes_on(Vec2 end, Vec2 out, Vec2 at, Vec2 far) {
    Vec2 way = vec2_sub(far, end);
    double across = fabs(vec2_cross(out, way));
    return vec2_distance(end, at) < SAME && vec2_dot(out, way) > 0 && across < SAME &&
           across <= TURN * vec2_length(way);
}

/* Extends the face by a line that continues it. Returns false if the line does not. */
static bool absorb(Face *face, const Face *line) {
    Vec2 back = vec2_scale(face->along, -1);
    if (goes_on(face->b, face->along, line->a, line->b))
        face->b = line->b;
    else if (goes_on(face->b, face->along, line->b, line->a))
        face->b = line->a;
    else if (goes_on(face->a, back, line->a, line->b))
        face->a = line->b;
    else if (goes_on(face->a, back, line->b, line->a))
        face->a = line->a;
    else
        return false;
    face->length = vec2_distance(face->a, face->b);
    face->along = vec2_unit(vec2_sub(face->b, face->a));
    return true;
}

static bool visit_touching(void *context, int item) {
    Finder *finder = context;
    Face face = finder->faces[finder->current];
    if (!finder->faces[item].spare && item != finder->current && absorb(&face, &finder->faces[item]) &&
        (finder->found < 0 || item < finder->found))
        finder->found = item;
    return true;
}

/* Joins lines that continue each other into one face: a face may be drawn in parts. */
static void join_parts(Finder *finder) {
    finder->tree = broadphase_create();
    for (size_t f = 0; f < finder->count; f++) {
        Face *face = &finder->faces[f];
        if (face->spare)
            continue;
        do {
            finder->current = (int)f;
            finder->found = -1;
            broadphase_visit(finder->tree, box_expand(box_of(face), SAME), visit_touching, finder);
            if (finder->found >= 0) {
                absorb(face, &finder->faces[finder->found]);
                finder->faces[finder->found].spare = true;
            }
        } while (finder->found >= 0);
        broadphase_insert(finder->tree, box_of(face), (int)f);
    }
    broadphase_destroy(finder->tree);
}

/* Pairs ----------------------------------------------------------------------------------------------------------- */

/* Keeps the pair of the current line and an earlier one if both run side by side. */
static bool visit(void *context, int item) {
    Finder *finder = context;
    Face *current = &finder->faces[finder->current], *face = &finder->faces[item];
    if (++finder->met > MOST_MEETINGS)
        return false;
    bool longer = current->length > face->length;
    const Face *one = longer ? current : face, *other = longer ? face : current;
    Vec2 from = vec2_unturn(vec2_sub(other->a, one->a), one->along);
    Vec2 to = vec2_unturn(vec2_sub(other->b, one->a), one->along);
    double offset = (from.y + to.y) / 2, low = fmax(fmin(from.x, to.x), 0),
           high = fmin(fmax(from.x, to.x), one->length);
    if (fabs(from.y - to.y) > PARALLEL || fabs(offset) < THINNEST || fabs(offset) > THICKEST ||
        !(high - low > SHORTEST) || (fabs(offset) > STOUTEST * (high - low) && high - low < NIB))
        return true;
    finder->pairs =
        memory_reserve(finder->pairs, &finder->pair_capacity, finder->pair_count + 1, sizeof *finder->pairs);
    finder->pairs[finder->pair_count++] = (Pair){.one = longer ? finder->current : item,
                                                 .other = longer ? item : finder->current,
                                                 .low = low,
                                                 .high = high,
                                                 .offset = offset};
    return true;
}

/* Returns false if there are too many lines side by side. The tree holds the faces afterwards. */
static bool find_pairs(Finder *finder) {
    finder->tree = broadphase_create();
    for (size_t f = 0; f < finder->count && finder->met <= MOST_MEETINGS; f++) {
        Face *face = &finder->faces[f];
        if (face->spare)
            continue;
        finder->current = (int)f;
        broadphase_visit(finder->tree, box_expand(box_of(face), THICKEST), visit, finder);
        broadphase_insert(finder->tree, box_of(face), (int)f);
    }
    return finder->met <= MOST_MEETINGS;
}

static int compare_pairs(const void *a, const void *b) {
    const Pair *p = a, *q = b;
    double length = p->high - p->low, other = q->high - q->low;
    if (p->is_space != q->is_space)
        return p->is_space ? 1 : -1;
    if ((p->layers > 0) != (q->layers > 0))
        return p->layers ? -1 : 1;
    if (p->layers && fabs(p->offset) != fabs(q->offset))
        return fabs(p->offset) > fabs(q->offset) ? -1 : 1;
    if (lround(p->support / SAME) != lround(q->support / SAME))
        return p->support > q->support ? -1 : 1;
    if (lround(fabs(p->offset) / CLASS) != lround(fabs(q->offset) / CLASS)) /* the nearer partner */
        return fabs(p->offset) < fabs(q->offset) ? -1 : 1;
    if (length != other)
        return length > other ? -1 : 1;
    return p->one != q->one ? (p->one < q->one ? -1 : 1) : p->other < q->other ? -1 : p->other > q->other;
}

/* Layers of one wall ---------------------------------------------------------------------------------------------- */

/* The lines between the faces of a pair. */
typedef struct Layers {
    Finder *finder;
    const Pair *pair;
    int lines[MOST_LAYERS];
    double offsets[MOST_LAYERS]; /* m, rising */
    size_t count;
} Layers;

static bool visit_layer(void *context, int item) {
    Layers *layers = context;
    const Pair *pair = layers->pair;
    const Face *one = &layers->finder->faces[pair->one], *face = &layers->finder->faces[item];
    if (++layers->finder->met > MOST_MEETINGS || layers->count == MOST_LAYERS)
        return false;
    Vec2 from = vec2_unturn(vec2_sub(face->a, one->a), one->along);
    Vec2 to = vec2_unturn(vec2_sub(face->b, one->a), one->along);
    double offset = copysign(1, pair->offset) * (from.y + to.y) / 2;
    double shared = fmin(fmax(from.x, to.x), pair->high) - fmax(fmin(from.x, to.x), pair->low);
    if (item == pair->one || item == pair->other || fabs(from.y - to.y) > PARALLEL || offset < SKIN ||
        offset > fabs(pair->offset) - SKIN || shared < LAYERED * (pair->high - pair->low))
        return true;
    size_t at = layers->count++;
    for (; at > 0 && layers->offsets[at - 1] > offset; at--) {
        layers->offsets[at] = layers->offsets[at - 1];
        layers->lines[at] = layers->lines[at - 1];
    }
    layers->offsets[at] = offset;
    layers->lines[at] = item;
    return true;
}

/* Finds the lines between the faces; none if two of all lines are so far apart that there is space between them. */
static Layers find_layers(Finder *finder, const Pair *pair) {
    Layers layers = {.finder = finder, .pair = pair};
    const Face *one = &finder->faces[pair->one];
    Vec2 across = vec2_scale(vec2_left(one->along), pair->offset);
    Vec2 from = vec2_along(one->a, pair->low, one->along), to = vec2_along(one->a, pair->high, one->along);
    Box box = box_include(box_include(box_empty(), from), to);
    box = box_include(box_include(box, vec2_add(from, across)), vec2_add(to, across));
    broadphase_visit(finder->tree, box, visit_layer, &layers);
    double before = 0, widest = 0;
    for (size_t i = 0; i < layers.count; before = layers.offsets[i++])
        widest = fmax(widest, layers.offsets[i] - before);
    widest = fmax(widest, fabs(pair->offset) - before);
    layers.count = widest < CAVITY ? layers.count : 0;
    return layers;
}

/* Returns the offset of the other face of a pair to the left of one of its faces. */
static double offset_from(const Finder *finder, const Pair *pair, int face) {
    bool same = vec2_dot(finder->faces[pair->one].along, finder->faces[pair->other].along) > 0;
    return face == pair->one || !same ? pair->offset : -pair->offset;
}

/* True if the line has a nearer partner on its other side, along most of the pair. */
static bool has_nearer(const Finder *finder, const Pair *pair, int face, const size_t *pairs, size_t count) {
    double own = offset_from(finder, pair, face);
    for (size_t i = 0; i < count && i < MOST_PARTNERS; i++) {
        const Pair *next = &finder->pairs[pairs[i]];
        double offset = offset_from(finder, next, face);
        if (offset * own < 0 && fabs(offset) < fabs(own) - EQUAL && next->support >= USUAL &&
            next->high - next->low >= LAYERED * (pair->high - pair->low))
            return true;
    }
    return false;
}

/* True if a longer and thicker pair has the line on the same side: the layers fill a part of its wall, as a window. */
static bool has_longer(const Finder *finder, const Pair *pair, int face, const size_t *pairs, size_t count) {
    double own = offset_from(finder, pair, face);
    for (size_t i = 0; i < count && i < MOST_PARTNERS; i++) {
        const Pair *next = &finder->pairs[pairs[i]];
        double offset = offset_from(finder, next, face);
        if (offset * own > 0 && fabs(offset) > fabs(own) + EQUAL && next->support >= USUAL &&
            LAYERED * (next->high - next->low) > pair->high - pair->low)
            return true;
    }
    return false;
}

/* Marks pairs whose lines both belong to a wall on their other sides, such as the sides of a shaft, and forgets the
 * layers of pairs that are a part of a longer wall. */
static void find_spaces(Finder *finder) {
    size_t *first = memory_zeroed(finder->count + 1, sizeof *first);
    size_t *list = memory_zeroed(2 * finder->pair_count, sizeof *list);
    for (size_t p = 0; p < finder->pair_count; p++) {
        first[finder->pairs[p].one]++;
        first[finder->pairs[p].other]++;
    }
    for (size_t f = 0, sum = 0; f <= finder->count; f++) {
        sum += first[f];
        first[f] = sum;
    }
    for (size_t p = finder->pair_count; p-- > 0;) {
        list[--first[finder->pairs[p].one]] = p;
        list[--first[finder->pairs[p].other]] = p;
    }
    for (size_t p = 0; p < finder->pair_count; p++) {
        Pair *pair = &finder->pairs[p];
        int one = pair->one, other = pair->other;
        const size_t *near_one = list + first[one], *near_other = list + first[other];
        size_t ones = first[one + 1] - first[one], others = first[other + 1] - first[other];
        pair->is_space =
            has_nearer(finder, pair, one, near_one, ones) && has_nearer(finder, pair, other, near_other, others);
        if (pair->layers &&
            (has_longer(finder, pair, one, near_one, ones) || has_longer(finder, pair, other, near_other, others)))
            pair->layers = 0;
    }
    memory_free(first);
    memory_free(list);
}

/* Puts the pairs first that have layers, then those whose distance most lines keep. */
static void sort_pairs(Finder *finder) {
    double lengths[CLASSES + 2] = {0};
    for (size_t p = 0; p < finder->pair_count; p++) {
        double length = finder->pairs[p].high - finder->pairs[p].low, offset = fabs(finder->pairs[p].offset);
        lengths[1 + (int)(offset / CLASS)] += length > offset ? length : 0;
    }
    finder->met = 0;
    for (size_t p = 0; p < finder->pair_count; p++) {
        Pair *pair = &finder->pairs[p];
        int class = 1 + (int)(fabs(pair->offset) / CLASS);
        pair->support = lengths[class - 1] + lengths[class] + lengths[class + 1];
        bool is_long = pair->high - pair->low > fabs(pair->offset);
        pair->layers = is_long && finder->met <= MOST_MEETINGS ? find_layers(finder, pair).count : 0;
    }
    find_spaces(finder);
    if (finder->pair_count)
        qsort(finder->pairs, finder->pair_count, sizeof *finder->pairs, compare_pairs);
}

/* Pieces ---------------------------------------------------------------------------------------------------------- */

static void take(Finder *finder, Face *face, double low, double high, double offset) {
    finder->taken =
        memory_reserve(finder->taken, &finder->taken_capacity, finder->taken_count + 1, sizeof *finder->taken);
    finder->taken[finder->taken_count] = (Taken){fmin(low, high), fmax(low, high), offset, face->taken};
    face->taken = finder->taken_count++;
}

typedef struct Stretch {
    double low, high;
} Stretch;

/* Cuts a stretch out of a list, and returns the new length of the list. */
static size_t cut(Stretch list[MOST_PARTS], size_t count, double low, double high) {
    size_t all = count;
    for (size_t i = 0; i < count; i++) {
        double end = list[i].high;
        if (high <= list[i].low || low >= end)
            continue;
        list[i].high = fmax(low, list[i].low);
        if (high < end && all < MOST_PARTS)
            list[all++] = (Stretch){high, end};
    }
    return all;
}

/* Returns the place along `one` of a place along `other`. */
static double along_one(const Face *one, const Face *other, double at) {
    return vec2_dot(vec2_sub(vec2_along(other->a, at, other->along), one->a), one->along);
}

static void take_layers(Finder *finder, const Pair *pair, const WallPiece *piece) {
    Layers layers = find_layers(finder, pair);
    for (size_t i = 0; i < layers.count; i++) {
        Face *face = &finder->faces[layers.lines[i]];
        take(finder, face, vec2_dot(vec2_sub(piece->a, face->a), face->along),
             vec2_dot(vec2_sub(piece->b, face->a), face->along), 0);
    }
}

static void add_piece(Finder *finder, const Pair *pair, Stretch part) {
    Face *one = &finder->faces[pair->one], *other = &finder->faces[pair->other];
    Vec2 side = vec2_scale(vec2_left(one->along), pair->offset / 2);
    WallPiece piece = {.a = vec2_add(vec2_along(one->a, part.low, one->along), side),
                       .b = vec2_add(vec2_along(one->a, part.high, one->along), side),
                       .thickness = fabs(pair->offset),
                       .faces = {pair->one, pair->other}};
    double start = vec2_dot(vec2_sub(piece.a, other->a), other->along);
    double stop = vec2_dot(vec2_sub(piece.b, other->a), other->along);
    take(finder, one, part.low, part.high, offset_from(finder, pair, pair->one));
    take(finder, other, start, stop, offset_from(finder, pair, pair->other));
    if (pair->layers)
        take_layers(finder, pair, &piece);
    finder->pieces->share += (double)(2 + pair->layers) * (part.high - part.low);
    finder->pieces->list =
        memory_reserve(finder->pieces->list, &finder->pieces->capacity, finder->pieces->count + 1, sizeof piece);
    finder->pieces->list[finder->pieces->count++] = piece;
}

/* True if a stretch of this length is a piece of wall, and not a column or the space between the sides of an opening.
 */
static bool is_wall(const Pair *pair, double length) {
    return pair->support >= USUAL && fabs(pair->offset) <= STOUTEST * length;
}

/* Short pieces ---------------------------------------------------------------------------------------------------- */

typedef struct Search {
    const Finder *finder;
    Vec2 at, along;
    double thickness;
    bool found;
} Search;

static bool visit_in_line(void *context, int item) {
    Search *search = context;
    const WallPiece *piece = &search->finder->pieces->list[item];
    Vec2 a = vec2_unturn(vec2_sub(piece->a, search->at), search->along);
    Vec2 b = vec2_unturn(vec2_sub(piece->b, search->at), search->along);
    search->found |= fabs(piece->thickness - search->thickness) < EQUAL && fabs(a.y) < EQUAL && fabs(b.y) < EQUAL;
    return !search->found;
}

/* True if a piece of the same thickness lies in line with the stretch, as across a door from a nib. */
static bool is_in_line(const Finder *finder, const Broadphase *pieces, const Pair *pair, Stretch part) {
    const Face *one = &finder->faces[pair->one];
    Vec2 side = vec2_scale(vec2_left(one->along), pair->offset / 2);
    Search search = {finder, vec2_add(vec2_along(one->a, part.low, one->along), side), one->along, fabs(pair->offset),
                     false};
    Box box = box_include(box_empty(), vec2_along(search.at, -IN_LINE, one->along));
    box = box_include(box, vec2_along(search.at, part.high - part.low + IN_LINE, one->along));
    broadphase_visit(pieces, box, visit_in_line, &search);
    return search.found;
}

/* True if thicker pieces of the same face, on the same side, touch both ends of the stretch: it is a niche. */
static bool is_between(const Finder *finder, const Face *face, double low, double high, double offset) {
    bool before = false, after = false;
    for (size_t t = face->taken; t != SIZE_MAX; t = finder->taken[t].next) {
        const Taken *taken = &finder->taken[t];
        if (taken->offset * offset < 0 || fabs(taken->offset) < fabs(offset) + EQUAL)
            continue;
        before |= fabs(taken->high - low) < TOUCH;
        after |= fabs(taken->low - high) < TOUCH;
    }
    return before && after;
}

/* True if other pieces make a wall of a stretch that alone would not be one. */
static bool is_confirmed(const Finder *finder, const Broadphase *pieces, const Pair *pair, Stretch part) {
    const Face *one = &finder->faces[pair->one], *other = &finder->faces[pair->other];
    double low = vec2_dot(vec2_sub(vec2_along(one->a, part.low, one->along), other->a), other->along);
    double high = vec2_dot(vec2_sub(vec2_along(one->a, part.high, one->along), other->a), other->along);
    return (part.high - part.low >= NIB && is_in_line(finder, pieces, pair, part)) ||
           is_between(finder, one, part.low, part.high, offset_from(finder, pair, pair->one)) ||
           is_between(finder, other, fmin(low, high), fmax(low, high), offset_from(finder, pair, pair->other));
}

/* The whole ------------------------------------------------------------------------------------------------------- */

/* Adds the stretches of a pair that are free; `pieces` holds those that may confirm short ones, or is NULL. */
static void add_pair(Finder *finder, const Pair *pair, const Broadphase *pieces) {
    const Face *one = &finder->faces[pair->one], *other = &finder->faces[pair->other];
    Stretch parts[MOST_PARTS] = {{pair->low, pair->high}};
    size_t count = 1;
    for (size_t t = one->taken; t != SIZE_MAX; t = finder->taken[t].next)
        count = cut(parts, count, finder->taken[t].low, finder->taken[t].high);
    for (size_t t = other->taken; t != SIZE_MAX; t = finder->taken[t].next) {
        double low = along_one(one, other, finder->taken[t].low), high = along_one(one, other, finder->taken[t].high);
        count = cut(parts, count, fmin(low, high), fmax(low, high));
    }
    for (size_t i = 0; i < count; i++) {
        double length = parts[i].high - parts[i].low;
        if (length > SHORTEST && (pieces ? is_confirmed(finder, pieces, pair, parts[i]) : is_wall(pair, length)))
            add_piece(finder, pair, parts[i]);
    }
}

/* Adds the pieces that are walls by themselves, then those that they confirm. */
static void add_pairs(Finder *finder) {
    for (size_t p = 0; p < finder->pair_count; p++)
        add_pair(finder, &finder->pairs[p], NULL);
    Broadphase *pieces = broadphase_create();
    for (size_t p = 0; p < finder->pieces->count; p++) {
        const WallPiece *piece = &finder->pieces->list[p];
        broadphase_insert(pieces, box_include(box_include(box_empty(), piece->a), piece->b), (int)p);
    }
    for (size_t p = 0; p < finder->pair_count; p++)
        add_pair(finder, &finder->pairs[p], pieces);
    broadphase_destroy(pieces);
}

WallPieces wall_pieces_find(const WallLines *lines, double scale) {
    WallPieces pieces = {0};
    Finder finder = {.pieces = &pieces};
    size_t used = 0;
    double length = 0;
    collect(&finder, lines, scale);
    for (size_t f = 0; f < finder.count; f++)
        used += !finder.faces[f].spare;
    pieces.too_many = used > MOST_LINES;
    if (used && !pieces.too_many) {
        drop_doubled(&finder);
        join_parts(&finder);
        pieces.too_many = !find_pairs(&finder);
        if (!pieces.too_many) {
            sort_pairs(&finder);
            add_pairs(&finder);
        }
        broadphase_destroy(finder.tree);
    }
    for (size_t f = 0; f < finder.count; f++)
        length += finder.faces[f].spare ? 0 : finder.faces[f].length;
    pieces.share = length > 0 ? fmin(pieces.share / length, 1) : 0;
    pieces.doubled = finder.doubled;
    memory_free(finder.faces);
    memory_free(finder.pairs);
    memory_free(finder.taken);
    return pieces;
}
