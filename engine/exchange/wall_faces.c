#include "exchange/wall_faces.h"

#include <math.h>
#include <stdint.h>

#include "exchange/wall_pieces.h"
#include "exchange/wall_strip.h"
#include "mechanics/broadphase.h"

static const double MOST_ARE_FACES = 0.4;        /* 1: share of faces in the length of all lines of such a drawing */
static const double EQUAL = 3e-3;                /* m: thicknesses and lines closer than this are equal */
static const double LOOSE = 0.02;                /* m: drawn ends may miss each other by this */
static const double BESIDE = 5e-3;               /* m: a line this near to a wall belongs to it */
static const double REACH = 0.7;                 /* m: a piece is extended by at most this */
static const double STRAIGHT = 0.02;             /* 1: sine of the largest angle between pieces in one line */
static const double NARROWEST = 0.4, WIDEST = 3; /* m: openings */
static const double FILLED = 0.9;                /* 1: share of a gap that lines or a thinner piece close */
static const double FRAME = 0.1;                 /* m: widest frame beside the lines of a window */
static const double WINDOW = 0.6;                /* 1: smallest share of a gap that the lines of a window fill */
static const double NEAR_WALL = 0.05;            /* m: a window line this near to a wall belongs to it */
static const double WIDER = 2;                   /* 1: lines this much nearer or farther may be faces of odd walls */
static const double ROUNDED = 1e5;               /* per m, for thicknesses */
static const double CROSSING = 0.3; /* 1: sine of the smallest angle between a wall and a line that meets it */
static const double SPECK = 0.01;   /* m: a shorter rest of a line is dropped */

enum {
    MOST_PARTS = 64, /* stretches of a line covered by walls */
    MOST_COMPARED = 3000
};

#define NONE SIZE_MAX

/* The end of a piece: 2 * piece + (0 or 1). */
typedef struct End {
    Vec2 at;      /* extended */
    size_t link;  /* the end of the piece that continues this one, or NONE */
    double cover; /* m, length beyond the end that belongs to the wall met there; 0: a free end */
} End;

typedef struct Joiner {
    const WallPiece *pieces; /* (count) */
    size_t count;
    End *ends; /* (2 * count) */
    Broadphase *tree;
    const WallLines *lines, *windows;
    Broadphase *line_tree, *window_tree;
    Vec2 origin;
    WallFaces *faces;
    bool outlines; /* the pieces are the lines with a thickness, which they replace */
    bool *done;    /* (count) */
    size_t current;
    double nearest; /* of the search in progress */
    size_t found;
    bool blocked;
} Joiner;

static Vec2 end_of(const Joiner *joiner, size_t end) {
    const WallPiece *piece = &joiner->pieces[end / 2];
    return end & 1 ? piece->b : piece->a;
}

/* Returns the unit vector that points out of the piece at this end. */
static Vec2 outward(const Joiner *joiner, size_t end) {
    return vec2_unit(vec2_sub(end_of(joiner, end), end_of(joiner, end ^ 1)));
}

static Box box_of_ends(Vec2 a, Vec2 b) {
    return box_include(box_include(box_empty(), a), b);
}

/* Continuing pieces ----------------------------------------------------------------------------------------------- */

/* Finds the distance at which a piece continues beyond an end, in one line and as thick; false if it does not. */
static bool continues(const Joiner *joiner, size_t end, size_t piece, size_t *other, double *distance) {
    const WallPiece *own = &joiner->pieces[end / 2], *next = &joiner->pieces[piece];
    if (piece == end / 2 || fabs(own->thickness - next->thickness) > EQUAL)
        return false;
    Vec2 at = end_of(joiner, end), out = outward(joiner, end);
    Vec2 a = vec2_unturn(vec2_sub(next->a, at), out), b = vec2_unturn(vec2_sub(next->b, at), out);
    *other = 2 * piece + (a.x < b.x ? 0 : 1);
    *distance = fmin(a.x, b.x);
    return fabs(a.y) < EQUAL && fabs(b.y) < EQUAL && fabs(a.y - b.y) <= STRAIGHT * fabs(a.x - b.x) &&
           *distance > -LOOSE;
}

static bool shares_face(const WallPiece *one, const WallPiece *two) {
    return one->faces[0] == two->faces[0] || one->faces[0] == two->faces[1] || one->faces[1] == two->faces[0] ||
           one->faces[1] == two->faces[1];
}

/* Remembers the nearest piece that continues the current end. */
static bool visit_next(void *context, int item) {
    Joiner *joiner = context;
    size_t other;
    double distance;
    if (continues(joiner, joiner->current, (size_t)item, &other, &distance) && distance < joiner->nearest) {
        joiner->nearest = distance;
        joiner->found = other;
    }
    return true;
}

/* Finds the end of the nearest piece that continues the end within `reach`, or NONE. */
static size_t find_next(Joiner *joiner, size_t end, double reach) {
    Vec2 at = end_of(joiner, end);
    joiner->current = end;
    joiner->nearest = reach;
    joiner->found = NONE;
    broadphase_visit(joiner->tree, box_expand(box_of_ends(at, vec2_along(at, reach, outward(joiner, end))), LOOSE),
                     visit_next, joiner);
    return joiner->found;
}

static void link_ends(Joiner *joiner, size_t one, size_t other) {
    joiner->ends[one].link = other;
    joiner->ends[other].link = one;
}

/* Corners and Ts -------------------------------------------------------------------------------------------------- */

/* Where the ray from an end meets the centre line of another piece. */
typedef struct Meeting {
    double along;  /* m, along the ray */
    double beyond; /* m, from the middle of the two centre lines' crossing to the far face, along the ray */
    size_t end;    /* the other piece's end there, if it is a corner; otherwise NONE */
} Meeting;

static bool meets(const Joiner *joiner, size_t end, size_t piece, Meeting *meeting) {
    const WallPiece *own = &joiner->pieces[end / 2], *other = &joiner->pieces[piece];
    Vec2 at = end_of(joiner, end), out = outward(joiner, end);
    Vec2 along = vec2_unit(vec2_sub(other->b, other->a));
    double sine = fabs(vec2_cross(out, along)), cosine = fabs(vec2_dot(out, along));
    if (piece == end / 2 || sine < STRAIGHT)
        return false;
    double reach = fmin((other->thickness + own->thickness * cosine) / (2 * sine), REACH) + LOOSE;
    double aside = fmin((own->thickness + other->thickness * cosine) / (2 * sine), REACH) + LOOSE;
    double t = vec2_cross(vec2_sub(other->a, at), along) / vec2_cross(out, along);
    double length = vec2_distance(other->a, other->b);
    double s = vec2_dot(vec2_sub(vec2_along(at, t, out), other->a), along);
    if (t < -reach || t > reach || s < -aside || s > length + aside)
        return false;
    meeting->along = t;
    meeting->beyond = other->thickness / (2 * sine);
    meeting->end = s < aside && s < length / 2 ? 2 * piece : s > length - aside ? 2 * piece + 1 : NONE;
    return true;
}

static bool visit_meeting(void *context, int item) {
    Joiner *joiner = context;
    Meeting meeting;
    if (meets(joiner, joiner->current, (size_t)item, &meeting) && fabs(meeting.along) < joiner->nearest) {
        joiner->nearest = fabs(meeting.along);
        joiner->found = (size_t)item;
    }
    return true;
}

/* Extends an end to the centre line of the wall that it meets. At a corner of walls of different thickness one of them
 * continues to the far face of the other, so that no notch remains. */
static void extend(Joiner *joiner, size_t end) {
    Meeting meeting;
    joiner->current = end;
    joiner->nearest = HUGE_VAL;
    joiner->found = NONE;
    broadphase_visit(joiner->tree, box_expand(box_of_ends(end_of(joiner, end), end_of(joiner, end)), 2 * REACH),
                     visit_meeting, joiner);
    if (joiner->found == NONE || !meets(joiner, end, joiner->found, &meeting))
        return;
    const WallPiece *own = &joiner->pieces[end / 2], *other = &joiner->pieces[joiner->found];
    Vec2 out = outward(joiner, end);
    bool corner = meeting.end != NONE && joiner->ends[meeting.end].link == NONE &&
                  find_next(joiner, meeting.end, own->thickness + LOOSE) == NONE;
    bool square = fabs(vec2_dot(out, outward(joiner, (size_t)(other - joiner->pieces) * 2))) < 1e-3;
    bool goes_on = corner && square && fabs(own->thickness - other->thickness) > EQUAL && own < other;
    double by = meeting.along + (goes_on ? meeting.beyond : 0);
    joiner->ends[end].cover = fmax(meeting.beyond, LOOSE) + LOOSE;
    if (by > 0)
        joiner->ends[end].at = vec2_along(end_of(joiner, end), by, out);
}

/* Links the pieces on both sides of a wall that crosses them. */
static void link_crossed(Joiner *joiner) {
    for (size_t end = 0; end < 2 * joiner->count; end++) {
        size_t other =
            joiner->ends[end].link == NONE && joiner->ends[end].cover > 0 ? find_next(joiner, end, 2 * REACH) : NONE;
        if (other != NONE && joiner->ends[other].link == NONE && joiner->ends[other].cover > 0 &&
            vec2_distance(joiner->ends[end].at, joiner->ends[other].at) < LOOSE)
            link_ends(joiner, end, other);
    }
}

/* Openings -------------------------------------------------------------------------------------------------------- */

/* True if the lines of a window fill the gap from a to b, except for its frame. */
static bool is_window(const Joiner *joiner, Vec2 a, Vec2 b, double thickness) {
    double width = vec2_distance(a, b);
    double closed =
        wall_strip_closed(joiner->windows, joiner->window_tree, joiner->origin, a, b, thickness / 2 + NEAR_WALL);
    return closed >= fmax(WINDOW * width, fmin(FILLED * width, width - 2 * FRAME));
}

typedef struct Filling {
    const Joiner *joiner;
    WallStrip strip;
} Filling;

static bool visit_piece(void *context, int item) {
    Filling *filling = context;
    const WallPiece *piece = &filling->joiner->pieces[item];
    if (piece->thickness / 2 < filling->strip.half - EQUAL)
        wall_strip_cover(&filling->strip, piece->a, piece->b);
    return true;
}

/* True if thinner pieces of wall fill the gap from a to b: the wall has a niche there. */
static bool is_niche(const Joiner *joiner, Vec2 a, Vec2 b, double thickness) {
    Filling filling = {joiner, wall_strip_between(a, b, thickness / 2)};
    broadphase_visit(joiner->tree, box_expand(box_of_ends(a, b), thickness / 2), visit_piece, &filling);
    return wall_strip_length(&filling.strip) >= FILLED * filling.strip.width;
}

/* True if the segments cross. */
static bool cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    Vec2 along = vec2_sub(b, a), other = vec2_sub(d, c);
    return vec2_cross(along, vec2_sub(c, a)) * vec2_cross(along, vec2_sub(d, a)) < 0 &&
           vec2_cross(other, vec2_sub(a, c)) * vec2_cross(other, vec2_sub(b, c)) < 0;
}

static bool visit_between(void *context, int item) {
    Joiner *joiner = context;
    const Vec2 from = end_of(joiner, joiner->current), to = end_of(joiner, joiner->found);
    joiner->blocked |= cross(from, to, joiner->pieces[item].a, joiner->pieces[item].b);
    return !joiner->blocked;
}

static void add_opening(Joiner *joiner, Vec2 a, Vec2 b, double thickness) {
    WallFaces *faces = joiner->faces;
    faces->openings =
        memory_reserve(faces->openings, &faces->opening_capacity, faces->opening_count + 1, sizeof *faces->openings);
    faces->openings[faces->opening_count++] =
        (WallOpening){vec2_add(a, joiner->origin), vec2_add(b, joiner->origin), thickness};
}

/* Closes the gap between two ends in one line: with a window, with an opening if both faces are interrupted, or
 * without one where a face continues. A gap that a face closes in part, and a niche, stay as drawn. */
static void close_gap(Joiner *joiner, size_t end, size_t other) {
    Vec2 a = end_of(joiner, end), b = end_of(joiner, other);
    double thickness = joiner->pieces[end / 2].thickness, width = vec2_distance(a, b);
    joiner->blocked = false;
    joiner->current = end;
    joiner->found = other;
    broadphase_visit(joiner->tree, box_of_ends(a, b), visit_between, joiner);
    if (joiner->blocked || is_niche(joiner, a, b, thickness))
        return;
    bool window = is_window(joiner, a, b, thickness);
    double closed =
        window ? 0 : wall_strip_closed(joiner->lines, joiner->line_tree, joiner->origin, a, b, thickness / 2 + BESIDE);
    bool opening = !window && closed < LOOSE;
    if ((opening && width < NARROWEST) || (closed >= LOOSE && closed < FILLED * width))
        return;
    link_ends(joiner, end, other);
    joiner->faces->windows += window;
    if (opening)
        add_opening(joiner, a, b, thickness);
}

/* Links free ends that face each other across a gap. */
static void link_openings(Joiner *joiner) {
    for (size_t end = 0; end < 2 * joiner->count; end++) {
        bool is_free = joiner->ends[end].link == NONE && joiner->ends[end].cover == 0;
        size_t other = is_free ? find_next(joiner, end, WIDEST) : NONE;
        if (other != NONE && joiner->ends[other].link == NONE && joiner->ends[other].cover == 0)
            close_gap(joiner, end, other);
    }
}

/* Links pieces with a face in common: another wall interrupts the other face there. */
static void link_through(Joiner *joiner) {
    for (size_t end = 0; end < 2 * joiner->count; end++) {
        size_t other = joiner->ends[end].link == NONE ? find_next(joiner, end, REACH) : NONE;
        if (other != NONE && joiner->ends[other].link == NONE &&
            (joiner->nearest < LOOSE ||
             (shares_face(&joiner->pieces[end / 2], &joiner->pieces[other / 2]) &&
              !is_niche(joiner, end_of(joiner, end), end_of(joiner, other), joiner->pieces[end / 2].thickness))))
            link_ends(joiner, end, other);
    }
}

/* Walls and remaining lines --------------------------------------------------------------------------------------- */

typedef struct FoundWall {
    Vec2 a, b;
    double thickness, before, after; /* m; lines within these distances beyond the ends belong to other walls */
} FoundWall;

typedef struct FoundWalls {
    FoundWall *list;
    size_t count, capacity;
} FoundWalls;

/* Walks along the links from one end of a chain of pieces to the other. */
static FoundWall follow(Joiner *joiner, size_t begin) {
    size_t end = begin ^ 1;
    joiner->done[end / 2] = true;
    for (; joiner->ends[end].link != NONE; joiner->done[end / 2] = true)
        end = joiner->ends[end].link ^ 1;
    double thickness = round(joiner->pieces[begin / 2].thickness * ROUNDED) / ROUNDED; /* equal in connected walls */
    return (FoundWall){joiner->ends[begin].at, joiner->ends[end].at, thickness, joiner->ends[begin].cover,
                       joiner->ends[end].cover};
}

/* Collects the chains; every chain is straight, so it has two ends. */
static FoundWalls find_walls(Joiner *joiner) {
    FoundWalls walls = {0};
    for (size_t end = 0; end < 2 * joiner->count; end++) {
        if (joiner->done[end / 2] || joiner->ends[end].link != NONE)
            continue;
        FoundWall wall = follow(joiner, end);
        walls.list = memory_reserve(walls.list, &walls.capacity, walls.count + 1, sizeof wall);
        walls.list[walls.count++] = wall;
    }
    return walls;
}

typedef struct Covering {
    const FoundWalls *walls;
    Vec2 a, b;
    double beside; /* m: the line belongs to a wall this near */
    double parts[MOST_PARTS][2];
    int walls_of[MOST_PARTS];
    size_t count;
} Covering;

static bool visit_wall(void *context, int item) {
    Covering *covering = context;
    const FoundWall *wall = &covering->walls->list[item];
    Vec2 axis = vec2_unit(vec2_sub(wall->b, wall->a));
    double length = vec2_distance(wall->a, wall->b);
    if (covering->count < MOST_PARTS &&
        wall_strip_clip(covering->a, covering->b, wall->a, axis, -fmax(wall->before, SPECK),
                        length + fmax(wall->after, SPECK), wall->thickness / 2 + covering->beside,
                        covering->parts[covering->count]))
        covering->walls_of[covering->count++] = item;
    return true;
}

/* Returns the place, as a fraction of the line, where a rest that begins or ends at a wall meets the wall's centre
 * line, so that nothing is open between them; `at` for a line along the wall. */
static double meet_axis(const Covering *covering, size_t part, double at) {
    const FoundWall *wall = &covering->walls->list[covering->walls_of[part]];
    Vec2 axis = vec2_unit(vec2_sub(wall->b, wall->a)), way = vec2_sub(covering->b, covering->a);
    double across = vec2_cross(way, axis), length = vec2_length(way);
    if (fabs(across) < CROSSING * length)
        return at;
    double meeting = vec2_cross(vec2_sub(wall->a, covering->a), axis) / across;
    return fabs(meeting - at) * length <= REACH ? meeting : at;
}

/* Adds the parts of a line that no wall covers. */
static void add_rest(const Joiner *joiner, Covering *covering, Broadphase *tree, const WallLine *line,
                     WallLines *rest) {
    covering->a = vec2_sub(line->a, joiner->origin);
    covering->b = vec2_sub(line->b, joiner->origin);
    covering->count = 0;
    broadphase_visit(tree, box_expand(box_of_ends(covering->a, covering->b), REACH), visit_wall, covering);
    Vec2 way = vec2_sub(line->b, line->a);
    double length = vec2_length(way), at = 0;
    size_t before = NONE, after = NONE; /* parts that cover the line up to `at` and from `next` */
    while (at < 1) {
        double covered = at, next = 1;
        after = NONE;
        for (size_t i = 0; i < covering->count; i++) {
            const double *part = covering->parts[i];
            if (part[0] <= at && part[1] > covered) {
                covered = part[1];
                before = i;
            } else if (part[0] > at && part[0] < next) {
                next = part[0];
                after = i;
            }
        }
        if (covered <= at && (next - at) * length > SPECK) {
            WallLine left = *line;
            if (before != NONE)
                left.a = vec2_along(line->a, meet_axis(covering, before, at), way);
            if (after != NONE)
                left.b = vec2_along(line->a, meet_axis(covering, after, next), way);
            wall_chains_append(rest, left);
        }
        at = covered > at ? covered : next;
    }
}

/* True if a thicker wall contains the wall, as the glass of a window drawn among the walls. */
static bool is_inside(const FoundWalls *walls, const FoundWall *wall) {
    bool inside = false;
    for (size_t w = 0; w < walls->count && !inside; w++) {
        const FoundWall *other = &walls->list[w];
        Vec2 axis = vec2_unit(vec2_sub(other->b, other->a));
        double length = vec2_distance(other->a, other->b), part[2];
        inside = other->thickness > wall->thickness + EQUAL &&
                 wall_strip_clip(wall->a, wall->b, other->a, axis, -fmax(other->before, BESIDE),
                                 length + fmax(other->after, BESIDE), (other->thickness - wall->thickness) / 2 + BESIDE,
                                 part) &&
                 part[0] <= 0 && part[1] >= 1;
    }
    return inside;
}

/* Drops such walls, unless there are very many: each is compared with all. */
static void drop_insides(FoundWalls *walls) {
    size_t kept = 0;
    for (size_t w = 0; w < walls->count && walls->count <= MOST_COMPARED; w++) {
        FoundWall wall = walls->list[w];
        if (!is_inside(walls, &wall))
            walls->list[kept++] = wall;
    }
    walls->count = walls->count <= MOST_COMPARED ? kept : walls->count;
}

/* Replaces the lines by walls and by the parts of lines and window lines that no wall covers. */
static void replace_lines(Joiner *joiner, WallLines *lines) {
    FoundWalls walls = find_walls(joiner);
    drop_insides(&walls);
    WallFaces *faces = joiner->faces;
    WallLines made = {0};
    Broadphase *tree = broadphase_create();
    faces->walls = joiner->outlines ? 0 : walls.count;
    faces->thinnest = HUGE_VAL;
    for (size_t w = 0; w < walls.count; w++) {
        const FoundWall *wall = &walls.list[w];
        faces->thinnest = fmin(faces->thinnest, wall->thickness);
        faces->thickest = fmax(faces->thickest, wall->thickness);
        broadphase_insert(tree, box_of_ends(wall->a, wall->b), (int)w);
        wall_chains_append(&made, (WallLine){vec2_add(wall->a, joiner->origin), vec2_add(wall->b, joiner->origin),
                                             wall->thickness, 0});
    }
    Covering covering = {.walls = &walls};
    for (int glass = 0; glass < 2; glass++) {
        const WallLines *all = glass ? joiner->windows : lines;
        covering.beside = glass ? NEAR_WALL : BESIDE;
        for (size_t l = 0; l < all->count; l++) {
            if (all->list[l].thickness > 0 && (glass || !joiner->outlines))
                wall_chains_append(&made, all->list[l]);
            else if (!(all->list[l].thickness > 0))
                add_rest(joiner, &covering, tree, &all->list[l], &made);
        }
    }
    broadphase_destroy(tree);
    memory_free(walls.list);
    memory_free(lines->list);
    *lines = made;
}

static Broadphase *tree_of(const Joiner *joiner, const WallLines *lines) {
    Broadphase *tree = broadphase_create();
    for (size_t l = 0; l < lines->count; l++)
        broadphase_insert(
            tree, box_of_ends(vec2_sub(lines->list[l].a, joiner->origin), vec2_sub(lines->list[l].b, joiner->origin)),
            (int)l);
    return tree;
}

static void join(Joiner *joiner, WallLines *lines) {
    joiner->lines = lines;
    joiner->line_tree = tree_of(joiner, lines);
    joiner->window_tree = tree_of(joiner, joiner->windows);
    joiner->ends = memory_zeroed(2 * joiner->count, sizeof *joiner->ends);
    joiner->done = memory_zeroed(joiner->count, sizeof *joiner->done);
    joiner->tree = broadphase_create();
    for (size_t p = 0; p < joiner->count; p++)
        broadphase_insert(joiner->tree, box_of_ends(joiner->pieces[p].a, joiner->pieces[p].b), (int)p);
    for (size_t end = 0; end < 2 * joiner->count; end++)
        joiner->ends[end] = (End){.at = end_of(joiner, end), .link = NONE};
    link_through(joiner);
    for (size_t end = 0; end < 2 * joiner->count; end++)
        if (joiner->ends[end].link == NONE)
            extend(joiner, end);
    link_crossed(joiner);
    link_openings(joiner);
    if (!joiner->outlines || joiner->faces->opening_count)
        replace_lines(joiner, lines);
    broadphase_destroy(joiner->tree);
    broadphase_destroy(joiner->line_tree);
    broadphase_destroy(joiner->window_tree);
    memory_free(joiner->ends);
    memory_free(joiner->done);
}

double wall_faces_likely(const WallLines *lines, double scale) {
    WallPieces pieces = wall_pieces_find(lines, scale);
    double thickest = 0;
    for (size_t p = 0; p < pieces.count && pieces.share >= MOST_ARE_FACES; p++)
        thickest = fmax(thickest, pieces.list[p].thickness);
    memory_free(pieces.list);
    return thickest;
}

/* Returns the distance of the lines if most of them run in pairs that are too near or too far for a wall; otherwise 0.
 */
static double distance_of_pairs(const WallLines *lines) {
    double far = wall_faces_likely(lines, 1 / WIDER) * WIDER, near = wall_faces_likely(lines, WIDER) / WIDER;
    return far > 0 ? far : near;
}

/* Joins walls that are drawn with a thickness, such as rectangles, across openings, if there are any. Returns true if
 * it does: then the window lines are part of the lines. */
static bool join_outlines(WallLines *lines, const WallLines *windows, WallFaces *faces) {
    WallPiece *pieces = memory_zeroed(lines->count, sizeof *pieces);
    Joiner joiner = {.pieces = pieces, .windows = windows, .faces = faces, .outlines = true};
    if (lines->count)
        joiner.origin = lines->list[0].a;
    for (size_t l = 0; l < lines->count; l++) {
        const WallLine *line = &lines->list[l];
        int own = (int)joiner.count;
        if (line->thickness > 0 && vec2_distance(line->a, line->b) > SPECK)
            pieces[joiner.count++] = (WallPiece){vec2_sub(line->a, joiner.origin),
                                                 vec2_sub(line->b, joiner.origin),
                                                 line->thickness,
                                                 {2 * own, 2 * own + 1}};
    }
    if (joiner.count)
        join(&joiner, lines);
    memory_free(pieces);
    return faces->opening_count > 0;
}

WallFaces wall_faces_join(WallLines *lines, const WallLines *windows) {
    WallFaces faces = {0};
    WallPieces pieces = wall_pieces_find(lines, 1);
    faces.too_many = pieces.too_many;
    if (pieces.count && pieces.share >= MOST_ARE_FACES) {
        faces.doubled = pieces.doubled;
        Joiner joiner = {.pieces = pieces.list,
                         .count = pieces.count,
                         .windows = windows,
                         .origin = lines->list[0].a,
                         .faces = &faces};
        join(&joiner, lines);
    } else {
        faces.apart = pieces.too_many ? 0 : distance_of_pairs(lines);
        bool joined = join_outlines(lines, windows, &faces);
        for (size_t w = 0; w < windows->count && !joined; w++)
            wall_chains_append(lines, windows->list[w]);
        faces.windows = joined ? faces.windows : 0;
    }
    memory_free(pieces.list);
    return faces;
}

void wall_faces_clear(WallFaces *faces) {
    memory_free(faces->openings);
    *faces = (WallFaces){0};
}
