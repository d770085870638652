/* Free space: how far each place is from the nearest obstacle, and how near a body comes to one.
 *
 * The distances on the grid are exact: taken from the faces themselves, not from painted pixels; between grid points
 * they are interpolated. Inside solids they are negative. Doors that can be opened count as open. */
#pragma once

#include <stdbool.h>

#include "base/vec2.h"
#include "space/outline.h"

/* Distances are exact up to this many metres, and this where they are larger. */
#define FREESPACE_FARTHEST 1.5

/* The plan's box grows by this many metres on every side: room to come out of the door. */
#define FREESPACE_MARGIN 1.6

/* Obstacles of a body are looked for up to this many metres from its middle without asking the broad phase. */
#define FREESPACE_BUCKET_REACH 1.5

/* Grids are made coarser rather than hold more points than this. */
#define FREESPACE_MOST_POINTS 16000000

typedef struct FreeSpace {
    const Outline *outline; /* not owned */
    Vec2 origin;            /* m, of grid point (0, 0) */
    double cell;            /* m */
    int nx, ny;
    float *distance; /* (ny x nx) m, signed, row by row */
    /* Which planned faces may be within FREESPACE_BUCKET_REACH of a point, bucket by bucket, the nearest first. */
    int bucket_nx, bucket_ny;
    double bucket;      /* m */
    int *bucket_starts; /* (bucket_nx * bucket_ny + 1) */
    int *bucket_faces;  /* (bucket_starts[last]) */
    float *bucket_near; /* m, as many: a lower bound of the face's distance from any point of the bucket */
} FreeSpace;

/* Builds the distances on a grid of about `cell` m. freespace_free releases it. */
void freespace_build(FreeSpace *space, const Outline *outline, double cell);
void freespace_free(FreeSpace *space);

/* Sets the marks (ny x nx) of the grid's points within a box to 1. */
void freespace_mark(const FreeSpace *space, Box box, unsigned char *marks);

/* The distance to the nearest obstacle, m, interpolated between grid points; outside the grid FREESPACE_FARTHEST. It
 * may be wrong by up to 0.5 cell near obstacles. */
double freespace_distance(const FreeSpace *space, Vec2 at);

/* The exact distance, m, to the nearest planned face within `reach` m (at most FREESPACE_FARTHEST), or `reach`. Always
 * positive: a point inside a solid is as far from its faces. `*face` (may be NULL) is that face, or -1. */
double freespace_exact(const FreeSpace *space, Vec2 at, double reach, int *face);

/* The exact clearance of a rectangle, m: how far it is from the nearest planned face, up to `reach` m; negative when it
 * overlaps, by the depth of the overlap (the least shift along an axis of the rectangle or a face's normal that frees
 * it from that face). The rectangle's centre is `centre`, its half sides are `half_length` along `axis` (unit) and
 * `half_width` across. `*face` (may be NULL): the face that decides, or -1. */
double freespace_clearance(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width,
                           double reach, int *face);

/* By how much, m, the rectangle may grow on every side (its corners stay sharp) before it touches a planned face, up to
 * `reach`; negative: by how much it must shrink to be free. It has the sign of freespace_clearance. */
double freespace_growth(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width,
                        double reach, int *face);

/* Is there nothing but free space between two places? Told from the grid: right to about half a cell. */
bool freespace_sees(const FreeSpace *space, Vec2 from, Vec2 to);
