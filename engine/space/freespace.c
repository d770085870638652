#include "space/freespace.h"

#include <stdint.h>
#include <stdlib.h>

#include "base/memory.h"

/* Distances to faces.
 *
 * Grid: every face lowers the squared distance of the points within FREESPACE_FARTHEST of it, row by row; the solids'
 * rings, filled by the even-odd rule, then give the sign.
 *
 * Rectangle against face, in the rectangle's frame (half sides h_x, h_y; the face from p to q with unit normal n): the
 * separations along the three axes on which two convex shapes can part (separating axes; Gottschalk 1996),
 *
 *     s_x = max(min(p_x, q_x) - h_x, -h_x - max(p_x, q_x)),   s_y alike,   s_n = |n . p| - (h_x |n_x| + h_y |n_y|).
 *
 * If all are negative, the two overlap, and the largest of the three is minus the least shift that separates them.
 * Otherwise the distance is the least one between an end and the rectangle, or between a corner and the face. A
 * rectangle grown by m on every side has separations s_x - m, s_y - m, s_n - m (|n_x| + |n_y|): it touches at m =
 * max(s_x, s_y, s_n /
 * (|n_x| + |n_y|)). */

enum {
    FEW_ENTRIES = 64,            /* entries of a bucket: fewer are sorted faster by insertion */
    LANES = 8,                   /* points of a row processed at once */
    MOST_BUCKETS = 4000000,      /* buckets are made larger rather than exceed this number */
    MOST_BUCKET_FACES = 16000000 /* approximate largest number of faces in all buckets */
};

#define SMALLEST_BUCKET 0.35 /* m: smaller buckets take longer to fill than they save */

#define HAIR 1e-6 /* m, above the rounding errors of places */

static double least(double a, double b) {
    return a < b ? a : b;
}

static double greatest(double a, double b) {
    return a > b ? a : b;
}

static int whole(double value, int low, int high) {
    return value <= low ? low : value >= high ? high : (int)value;
}

static double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
    return vec2_distance(p, vec2_nearest_on_segment(p, a, b));
}

/* Finds the range of x within `reach` of the part of a face that is within `reach` of the line y. */
static bool row_span(const Face *face, double y, double reach, double *low, double *high) {
    Vec2 down = face->a, up = face->b;
    if (down.y > up.y) {
        down = face->b;
        up = face->a;
    }
    if (y < down.y - reach || y > up.y + reach)
        return false;
    double rise = up.y - down.y, first = 0, last = 1;
    if (rise > 0) {
        first = greatest(0, (y - reach - down.y) / rise);
        last = least(1, (y + reach - down.y) / rise);
    }
    double one = down.x + first * (up.x - down.x), other = down.x + last * (up.x - down.x);
    *low = least(one, other) - reach;
    *high = greatest(one, other) + reach;
    return true;
}

/* LANES points of a row, and those of them in memory. */
typedef float Lanes __attribute__((vector_size(LANES * sizeof(float))));
typedef Lanes LanesAt __attribute__((aligned(sizeof(float)), may_alias));
typedef int Mask __attribute__((vector_size(LANES * sizeof(int))));
#define CHOSEN(where, yes, no) ((Lanes)(((Mask)(yes) & (where)) | ((Mask)(no) & ~(where))))

/* Lowers the squared distances of points first to last - 1 of a row, in whole lanes, to those from a face. */
static inline __attribute__((always_inline)) void lower_row(float *row, int first, int last, Vec2 from, double cell,
                                                            const Face *face) {
    Vec2 along = vec2_sub(face->b, face->a);
    double square = vec2_dot(along, along);
    float ex = (float)along.x, ey = (float)along.y, inverse = square > 0 ? (float)(1 / square) : 0;
    float dy = (float)(from.y - face->a.y), ey_dy = ey * dy;
    const Lanes steps = (Lanes){0, 1, 2, 3, 4, 5, 6, 7} * (float)cell, one = {1, 1, 1, 1, 1, 1, 1, 1};
    for (int i = first; i < last; i += LANES) {
        Lanes dx = (float)(from.x + i * cell - face->a.x) + steps, before = *(LanesAt *)(row + i);
        Lanes t = (dx * ex + ey_dy) * inverse;
        t = (Lanes)((Mask)t & ~(t < 0));
        t = CHOSEN(t > 1, one, t);
        Lanes px = dx - t * ex, py = dy - t * ey, d = px * px + py * py;
        *(LanesAt *)(row + i) = CHOSEN(d < before, d, before);
    }
}

static inline __attribute__((always_inline)) void lower_distances(FreeSpace *space, const Face *face) {
    double reach = FREESPACE_FARTHEST, bottom = least(face->a.y, face->b.y) - reach - space->origin.y;
    double top = greatest(face->a.y, face->b.y) + reach - space->origin.y;
    int last_row = whole(floor(top / space->cell), -1, space->ny - 1);
    for (int j = whole(ceil(bottom / space->cell), 0, space->ny); j <= last_row; j++) {
        double y = space->origin.y + j * space->cell, low, high;
        if (!row_span(face, y, reach, &low, &high))
            continue;
        int first = whole(floor((low - space->origin.x) / space->cell), 0, space->nx) / LANES * LANES;
        int last = whole(ceil((high - space->origin.x) / space->cell) + 1, 0, space->nx);
        last = (last + LANES - 1) / LANES * LANES;
        lower_row(space->distance + (size_t)j * (size_t)space->nx, first, last, vec2(space->origin.x, y), space->cell,
                  face);
    }
}

static inline __attribute__((always_inline)) void lower_by_all(FreeSpace *space) {
    for (size_t f = 0; f < space->outline->face_count; f++)
        if (outline_planned(space->outline->faces[f].presence))
            lower_distances(space, &space->outline->faces[f]);
}

/* The same code compiled for wider vectors, chosen at run time. */
#if defined __x86_64__
__attribute__((target("avx2"))) static void lower_eight(FreeSpace *space) {
    lower_by_all(space);
}
#endif

static void lower_all(FreeSpace *space) {
#if defined __x86_64__
    if (__builtin_cpu_supports("avx2")) {
        lower_eight(space);
        return;
    }
#endif
    lower_by_all(space);
}

/* Marks, in each row that the edge crosses, the first point beyond it. */
static void mark_edge(const FreeSpace *space, unsigned char *marks, Vec2 a, Vec2 b) {
    if (a.y == b.y)
        return;
    if (a.y > b.y) {
        Vec2 other = a;
        a = b;
        b = other;
    }
    int first = whole(ceil((a.y - space->origin.y) / space->cell), 0, space->ny);
    int last = whole(ceil((b.y - space->origin.y) / space->cell), 0, space->ny);
    for (int j = first; j < last; j++) {
        double y = space->origin.y + j * space->cell, x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
        int i = whole(floor((x - space->origin.x) / space->cell) + 1, 0, space->nx);
        if (i < space->nx)
            marks[(size_t)j * (size_t)space->nx + (size_t)i] ^= 1;
    }
}

static void negate_inside(FreeSpace *space) {
    const Outline *outline = space->outline;
    unsigned char *marks = memory_zeroed((size_t)space->nx * (size_t)space->ny, 1);
    for (size_t r = 0; r < outline->rings.count; r++) {
        size_t first = outline->rings.starts[r], end = outline->rings.starts[r + 1];
        for (size_t i = first; i < end; i++)
            mark_edge(space, marks, outline->rings.points[i], outline->rings.points[i + 1 < end ? i + 1 : first]);
    }
    for (int j = 0; j < space->ny; j++) {
        size_t row = (size_t)j * (size_t)space->nx;
        unsigned char inside = 0;
        for (size_t i = row; i < row + (size_t)space->nx; i++) {
            inside ^= marks[i];
            if (inside)
                space->distance[i] = -space->distance[i];
        }
    }
    memory_free(marks);
}

static void build_distances(FreeSpace *space) {
    size_t points = (size_t)space->nx * (size_t)space->ny;
    space->distance = memory_zeroed(points, sizeof *space->distance);
    for (size_t i = 0; i < points; i++)
        space->distance[i] = (float)(FREESPACE_FARTHEST * FREESPACE_FARTHEST);
    lower_all(space);
    for (size_t i = 0; i < points; i++)
        space->distance[i] = sqrtf(space->distance[i]);
    negate_inside(space);
}

/* Adds the face to each bucket that it may be near; only counts entries in `starts` when `near` is NULL. */
static void bucket_face(FreeSpace *space, int index, int *cursors, bool fill) {
    const Face *face = &space->outline->faces[index];
    double size = space->bucket, half = size * M_SQRT1_2, reach = FREESPACE_BUCKET_REACH + half;
    int last_row =
        whole(floor((greatest(face->a.y, face->b.y) + reach - space->origin.y) / size), 0, space->bucket_ny - 1);
    for (int j = whole((least(face->a.y, face->b.y) - reach - space->origin.y) / size, 0, space->bucket_ny - 1);
         j <= last_row; j++) {
        double low, high;
        Vec2 middle = {0, space->origin.y + (j + 0.5) * size};
        if (!row_span(face, middle.y, reach, &low, &high))
            continue;
        int last = whole(floor((high - space->origin.x) / size), -1, space->bucket_nx - 1);
        for (int i = whole((low - space->origin.x) / size, 0, space->bucket_nx); i <= last; i++) {
            middle.x = space->origin.x + (i + 0.5) * size;
            double near = distance_to_segment(middle, face->a, face->b) - half;
            if (near > FREESPACE_BUCKET_REACH)
                continue;
            size_t bucket = (size_t)j * (size_t)space->bucket_nx + (size_t)i;
            int place = cursors[bucket]++;
            if (!fill)
                continue;
            space->bucket_near[place] = near > 0 ? (float)near : 0;
            space->bucket_faces[place] = index;
        }
    }
}

typedef struct BucketEntry {
    float near;
    int face;
} BucketEntry;

static int compare_entries(const void *a, const void *b) {
    const BucketEntry *p = a, *q = b;
    if (p->near != q->near)
        return p->near < q->near ? -1 : 1;
    return p->face < q->face ? -1 : p->face > q->face;
}

/* Sorts the entries from `first` to `end` - 1 by distance, and equally near ones by face, which is their original
 * order; `room` has space for as many. */
static void sort_bucket(FreeSpace *space, int first, int end, BucketEntry *room) {
    for (int i = first; end - first <= FEW_ENTRIES && i < end;
         i++) { /* insertion sort: usual houses have few entries */
        float near = space->bucket_near[i];
        int face = space->bucket_faces[i], place = i;
        for (; place > first && space->bucket_near[place - 1] > near; place--) {
            space->bucket_near[place] = space->bucket_near[place - 1];
            space->bucket_faces[place] = space->bucket_faces[place - 1];
        }
        space->bucket_near[place] = near;
        space->bucket_faces[place] = face;
    }
    if (end - first <= FEW_ENTRIES)
        return;
    for (int i = first; i < end; i++)
        room[i - first] = (BucketEntry){space->bucket_near[i], space->bucket_faces[i]};
    qsort(room, (size_t)(end - first), sizeof *room, compare_entries);
    for (int i = first; i < end; i++) {
        space->bucket_near[i] = room[i - first].near;
        space->bucket_faces[i] = room[i - first].face;
    }
}

/* Estimates the number of entries for buckets of this size. */
static double bucket_entries(const Outline *outline, double size) {
    double entries = 0, reach = 2 * FREESPACE_BUCKET_REACH + size;
    for (size_t f = 0; f < outline->face_count; f++)
        if (outline_planned(outline->faces[f].presence))
            entries += (vec2_distance(outline->faces[f].a, outline->faces[f].b) + reach) * reach / (size * size);
    return entries;
}

static void build_buckets(FreeSpace *space) {
    const Outline *outline = space->outline;
    double across = (space->nx - 1) * space->cell, up = (space->ny - 1) * space->cell;
    space->bucket = SMALLEST_BUCKET;
    while (across / space->bucket * (up / space->bucket) > MOST_BUCKETS ||
           (bucket_entries(outline, space->bucket) > MOST_BUCKET_FACES && space->bucket < greatest(across, up)))
        space->bucket *= 2;
    space->bucket_nx = (int)(across / space->bucket) + 1;
    space->bucket_ny = (int)(up / space->bucket) + 1;
    size_t buckets = (size_t)space->bucket_nx * (size_t)space->bucket_ny;
    space->bucket_starts = memory_zeroed(buckets + 1, sizeof *space->bucket_starts);
    int *cursors = memory_zeroed(buckets, sizeof *cursors);
    for (size_t f = 0; f < outline->face_count; f++)
        if (outline_planned(outline->faces[f].presence))
            bucket_face(space, (int)f, cursors, false);
    int most = 0;
    for (size_t b = 0; b < buckets; b++) {
        most = cursors[b] > most ? cursors[b] : most;
        space->bucket_starts[b + 1] = space->bucket_starts[b] + cursors[b];
        cursors[b] = space->bucket_starts[b];
    }
    size_t entries = (size_t)space->bucket_starts[buckets];
    space->bucket_faces = memory_zeroed(entries, sizeof *space->bucket_faces);
    space->bucket_near = memory_zeroed(entries, sizeof *space->bucket_near);
    for (size_t f = 0; f < outline->face_count; f++)
        if (outline_planned(outline->faces[f].presence))
            bucket_face(space, (int)f, cursors, true);
    BucketEntry *room = memory_zeroed((size_t)most, sizeof *room);
    for (size_t b = 0; b < buckets; b++)
        sort_bucket(space, space->bucket_starts[b], space->bucket_starts[b + 1], room);
    memory_free(room);
    memory_free(cursors);
}

void freespace_build(FreeSpace *space, const Outline *outline, double cell) {
    Box box = box_expand(outline->box, FREESPACE_MARGIN);
    double across = box_width(box), up = box_height(box);
    *space = (FreeSpace){.outline = outline, .origin = box.low, .cell = cell};
    if (!(across > 0 && up > 0)) { /* an empty plan */
        across = up = 2 * FREESPACE_MARGIN;
        space->origin = vec2(-FREESPACE_MARGIN, -FREESPACE_MARGIN);
    }
    while ((across / space->cell + 2 + LANES) * (up / space->cell + 2) > FREESPACE_MOST_POINTS)
        space->cell *= 1.1;
    space->nx = ((int)ceil(across / space->cell) + LANES) / LANES * LANES;
    space->ny = (int)ceil(up / space->cell) + 1;
    /* Centre the grid, so that a mirrored plan has the mirrored grid. */
    space->origin.x -= ((space->nx - 1) * space->cell - across) / 2;
    space->origin.y -= ((space->ny - 1) * space->cell - up) / 2;
    build_distances(space);
    build_buckets(space);
}

void freespace_free(FreeSpace *space) {
    memory_free(space->distance);
    memory_free(space->bucket_starts);
    memory_free(space->bucket_faces);
    memory_free(space->bucket_near);
    *space = (FreeSpace){0};
}

void freespace_mark(const FreeSpace *space, Box box, unsigned char *marks) {
    int first_x = (int)fmax((box.low.x - space->origin.x) / space->cell, 0);
    int last_x = (int)fmin((box.high.x - space->origin.x) / space->cell, space->nx - 1);
    int first_y = (int)fmax((box.low.y - space->origin.y) / space->cell, 0);
    int last_y = (int)fmin((box.high.y - space->origin.y) / space->cell, space->ny - 1);
    for (int j = first_y; j <= last_y; j++)
        for (int i = first_x; i <= last_x; i++)
            marks[(size_t)j * (size_t)space->nx + (size_t)i] = 1;
}

double freespace_distance(const FreeSpace *space, Vec2 at) {
    double x = (at.x - space->origin.x) / space->cell, y = (at.y - space->origin.y) / space->cell;
    if (!(x >= 0 && y >= 0 && x <= space->nx - 1 && y <= space->ny - 1))
        return FREESPACE_FARTHEST;
    int i = whole(x, 0, space->nx - 2), j = whole(y, 0, space->ny - 2);
    if (space->reads)
        reads_note_point(space->reads, i, j);
    const float *low = space->distance + (size_t)j * (size_t)space->nx + (size_t)i, *high = low + space->nx;
    double u = x - i, v = y - j;
    return (1 - v) * ((1 - u) * (double)low[0] + u * (double)low[1]) +
           v * ((1 - u) * (double)high[0] + u * (double)high[1]);
}

/* Returns the signed distance at the nearest grid point: wrong by at most 0.71 cell. */
static double rough_distance(const FreeSpace *space, Vec2 at) {
    double x = (at.x - space->origin.x) / space->cell + 0.5, y = (at.y - space->origin.y) / space->cell + 0.5;
    if (!(x >= 0 && y >= 0 && x < space->nx && y < space->ny))
        return FREESPACE_FARTHEST;
    if (space->reads)
        reads_note_point(space->reads, (int)x, (int)y);
    return (double)space->distance[(size_t)y * (size_t)space->nx + (size_t)x];
}

/* Candidate faces within some distance of a point. */
typedef struct Nearby {
    const int *faces;  /* (count) */
    const float *near; /* (count) m, rising, or NULL */
    int count;
    int *owned; /* memory that nearby_release frees */
} Nearby;

/* Returns the bucket that has all faces within `radius` of a point, or SIZE_MAX. */
static inline size_t bucket_at(const FreeSpace *space, Vec2 at, double radius) {
    double x = (at.x - space->origin.x) / space->bucket, y = (at.y - space->origin.y) / space->bucket;
    if (radius <= FREESPACE_BUCKET_REACH && x >= 0 && y >= 0 && x < space->bucket_nx && y < space->bucket_ny)
        return (size_t)y * (size_t)space->bucket_nx + (size_t)x;
    return SIZE_MAX;
}

static Nearby nearby_find(const FreeSpace *space, Vec2 at, double radius) {
    size_t bucket = bucket_at(space, at, radius);
    if (bucket != SIZE_MAX) {
        int first = space->bucket_starts[bucket];
        return (Nearby){space->bucket_faces + first, space->bucket_near + first,
                        space->bucket_starts[bucket + 1] - first, NULL};
    }
    if (space->reads)
        space->reads->beyond = true;
    const Outline *outline = space->outline;
    size_t found = broadphase_query(outline->broadphase, box_around(at, radius), NULL, 0);
    int *items = memory_zeroed(found, sizeof *items), count = 0;
    broadphase_query(outline->broadphase, box_around(at, radius), items, found);
    for (size_t i = 0; i < found; i++)
        if ((size_t)items[i] < outline->face_count && outline_planned(outline->faces[items[i]].presence))
            items[count++] = items[i];
    return (Nearby){items, NULL, count, items};
}

static void nearby_release(Nearby *nearby) {
    memory_free(nearby->owned);
}

/* Notes that faces within `reach` of a rectangle are read, whether or not the grid tells that there are none. */
static void note_faces(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width,
                       double reach) {
    double x = fabs(axis.x), y = fabs(axis.y), far = reach + HAIR;
    double half_x = half_length * x + half_width * y + far, half_y = half_length * y + half_width * x + far;
    size_t bucket = bucket_at(space, centre, vec2_length(vec2(half_length, half_width)) + reach);
    if (bucket != SIZE_MAX)
        reads_note_box(space->reads, bucket, centre, half_x, half_y);
}

double freespace_exact(const FreeSpace *space, Vec2 at, double reach, int *face) {
    double best = least(reach, FREESPACE_FARTHEST);
    if (space->reads)
        note_faces(space, at, vec2(1, 0), 0, 0, best);
    if (face)
        *face = -1;
    if (rough_distance(space, at) - 0.71 * space->cell > best)
        return best;
    Nearby nearby = nearby_find(space, at, best);
    for (int k = 0; k < nearby.count; k++) {
        if (nearby.near && (double)nearby.near[k] >= best)
            break;
        const Face *candidate = &space->outline->faces[nearby.faces[k]];
        double distance = distance_to_segment(at, candidate->a, candidate->b);
        if (distance < best) {
            best = distance;
            if (face)
                *face = nearby.faces[k];
        }
    }
    nearby_release(&nearby);
    return best;
}

static double square_to_rectangle(Vec2 p, double half_length, double half_width) {
    double x = greatest(fabs(p.x) - half_length, 0), y = greatest(fabs(p.y) - half_width, 0);
    return x * x + y * y;
}

/* Returns the distance of a rectangle about the origin from a segment that does not meet it: the root of the least
 * square, which is the least root to the bit. Corners that are clearly farther than another one from the line, abreast
 * of the segment, or that lie before its begin, are left out. */
static double rectangle_distance(Vec2 p, Vec2 q, double half_length, double half_width) {
    double best =
        least(square_to_rectangle(p, half_length, half_width), square_to_rectangle(q, half_length, half_width));
    Vec2 along = vec2_sub(q, p);
    double square = vec2_dot(along, along), nearest = sqrt(best * square); /* times the segment's length, as `away` */
    double passed[4], away[4];
    for (int corner = 0; corner < 4; corner++) {
        Vec2 from = {(corner & 1 ? half_length : -half_length) - p.x, (corner & 2 ? half_width : -half_width) - p.y};
        passed[corner] = vec2_dot(from, along);
        away[corner] = fabs(vec2_cross(from, along));
        if (passed[corner] > 0 && passed[corner] < square)
            nearest = least(nearest, away[corner]);
    }
    for (int corner = 0; corner < 4; corner++) {
        if (!(passed[corner] > 0) || away[corner] > nearest * (1 + HAIR))
            continue;
        Vec2 at = {corner & 1 ? half_length : -half_length, corner & 2 ? half_width : -half_width};
        double part = passed[corner] / square;
        Vec2 from = vec2_sub(at, vec2_along(p, part > 1 ? 1 : part, along));
        best = least(best, vec2_dot(from, from));
    }
    return sqrt(best);
}

/* Returns the clearance of a rectangle from one face, or how much it may grow; at least `best`: at least as much. */
static inline double face_measure(const Face *face, Vec2 centre, Vec2 axis, double half_length, double half_width,
                                  double best, bool growth) {
    Vec2 p = vec2_unturn(vec2_sub(face->a, centre), axis);
    Vec2 q = vec2_unturn(vec2_sub(face->b, centre), axis);
    double along =
        p.x < q.x ? greatest(p.x - half_length, -half_length - q.x) : greatest(q.x - half_length, -half_length - p.x);
    double across =
        p.y < q.y ? greatest(p.y - half_width, -half_width - q.y) : greatest(q.y - half_width, -half_width - p.y);
    double apart = greatest(along, across);
    if (apart >= best)
        return apart;
    Vec2 normal = vec2_unturn(face->normal, axis);
    double nx = fabs(normal.x), ny = fabs(normal.y);
    double facing = fabs(vec2_dot(normal, p)) - (half_length * nx + half_width * ny);
    apart = greatest(apart, growth ? facing / (nx + ny) : facing);
    if (apart > 0 && apart < best && !growth)
        apart = rectangle_distance(p, q, half_length, half_width);
    return apart;
}

/* The loop of freespace_clearance and freespace_growth, which differ in their measure. It may end with any value below
 * `enough`. */
static inline double measure(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width,
                             double enough, double reach, int *face, bool growth) {
    double inner = least(half_length, half_width), radius = sqrt(half_length * half_length + half_width * half_width);
    double rough = rough_distance(space, centre), slack = 0.71 * space->cell, best = reach;
    double stretch = growth ? M_SQRT2 : 1;
    if (face)
        *face = -1;
    if (space->reads)
        note_faces(space, centre, axis, half_length, half_width, stretch * greatest(reach, 0));
    if (rough - slack > radius + stretch * greatest(reach, 0))
        return reach;
    Nearby nearby = nearby_find(space, centre, radius + stretch * greatest(reach, 0));
    for (int k = 0; k < nearby.count; k++) {
        if (nearby.near && (double)nearby.near[k] >= radius + (best > 0 ? stretch * best : growth ? 0 : best))
            break;
        double apart =
            face_measure(&space->outline->faces[nearby.faces[k]], centre, axis, half_length, half_width, best, growth);
        if (apart < best) {
            best = apart;
            if (face)
                *face = nearby.faces[k];
            if (best < enough)
                break;
        }
    }
    nearby_release(&nearby);
    /* Deep inside a solid there may be no face nearby. */
    if (rough < -slack && rough - inner < best)
        best = rough - inner;
    return best;
}

double freespace_clearance(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width,
                           double reach, int *face) {
    return measure(space, centre, axis, half_length, half_width, -HUGE_VAL, reach, face, false);
}

double freespace_clearance_from(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width,
                                double least, double reach) {
    return measure(space, centre, axis, half_length, half_width, least, reach, NULL, false);
}

double freespace_sides(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width,
                       double reach, double *left, double *right) {
    double radius = sqrt(half_length * half_length + half_width * half_width), half = half_width / 2;
    double rough = rough_distance(space, centre), slack = 0.71 * space->cell, best = reach;
    *left = *right = reach;
    if (space->reads)
        note_faces(space, centre, axis, half_length, half_width, greatest(reach, 0));
    if (rough - slack > radius + greatest(reach, 0))
        return reach;
    Nearby nearby = nearby_find(space, centre, radius + greatest(reach, 0));
    for (int k = 0; k < nearby.count; k++) {
        if (nearby.near && (double)nearby.near[k] >= radius + greatest(greatest(*left, *right), 0))
            break;
        const Face *face = &space->outline->faces[nearby.faces[k]];
        double apart = face_measure(face, centre, axis, half_length, half_width, greatest(*left, *right), false);
        best = least(best, apart);
        if (apart >= *left && apart >= *right)
            continue;
        double p = vec2_cross(axis, vec2_sub(face->a, centre)), q = vec2_cross(axis, vec2_sub(face->b, centre));
        if (p > 0 && q > 0) {
            *left = least(*left, apart);
        } else if (p < 0 && q < 0) {
            *right = least(*right, apart);
        } else { /* before or behind the body */
            Vec2 aside = vec2_scale(vec2_left(axis), half);
            *left = least(*left, face_measure(face, vec2_add(centre, aside), axis, half_length, half, *left, false));
            *right = least(*right, face_measure(face, vec2_sub(centre, aside), axis, half_length, half, *right, false));
        }
    }
    nearby_release(&nearby);
    double inner = rough - least(half_length, half_width);
    if (rough < -slack && inner < best)
        best = *left = *right = inner;
    return best;
}

double freespace_growth(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width,
                        double reach, int *face) {
    return measure(space, centre, axis, half_length, half_width, -HUGE_VAL, reach, face, true);
}

int freespace_faces(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width, double reach,
                    int *faces, int most) {
    double radius = sqrt(half_length * half_length + half_width * half_width) + reach;
    int count = 0;
    if (space->reads)
        note_faces(space, centre, axis, half_length, half_width, reach);
    if (rough_distance(space, centre) - 0.71 * space->cell > radius)
        return 0;
    Nearby nearby = nearby_find(space, centre, radius);
    for (int k = 0; k < nearby.count && count < most; k++) {
        if (nearby.near && (double)nearby.near[k] >= radius)
            break;
        const Face *face = &space->outline->faces[nearby.faces[k]];
        if (face_measure(face, centre, axis, half_length, half_width, reach, false) < reach)
            faces[count++] = nearby.faces[k];
    }
    nearby_release(&nearby);
    return count;
}

double freespace_face_clearance(const FreeSpace *space, int face, Vec2 centre, Vec2 axis, double half_length,
                                double half_width, double reach) {
    return face_measure(&space->outline->faces[face], centre, axis, half_length, half_width, reach, false);
}

bool freespace_sees(const FreeSpace *space, Vec2 from, Vec2 to) {
    double whole = vec2_distance(from, to), done = 0, thin = space->cell / 2;
    Vec2 along = whole > 0 ? vec2_scale(vec2_sub(to, from), 1 / whole) : vec2(1, 0);
    while (done < whole) {
        double free = freespace_distance(space, vec2_along(from, done, along));
        if (free >= whole - done)
            return true;
        if (free < thin && done > 0)
            return false;
        done += real_max(free, thin);
    }
    return true;
}
