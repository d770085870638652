/* Free space: the distance of each place, and of a body, from the nearest obstacle.
 *
 * The distances at grid points are exact, computed from the faces rather than from painted pixels; between grid points
 * they are interpolated. Inside solids they are negative. Doors that can be opened count as open. */
#pragma once

#include <stdbool.h>

#include "base/vec2.h"
#include "space/outline.h"
#include "space/reads.h"

/* m: distances are exact up to this value and are clipped to it. */
#define FREESPACE_FARTHEST 1.5

/* m: margin added to the plan's box on every side, as room in front of the exits. */
#define FREESPACE_MARGIN 1.6

/* m: obstacles within this distance of a body's middle are found without the broad phase. */
#define FREESPACE_BUCKET_REACH 1.5

/* The grid is made coarser rather than exceed this number of points. */
#define FREESPACE_MOST_POINTS 16000000

typedef struct FreeSpace {
    const Outline *outline; /* not owned */
    Vec2 origin;            /* m, of grid point (0, 0) */
    double cell;            /* m */
    int nx, ny;
    float *distance; /* (ny x nx) m, signed, row by row */
    /* The planned faces that may be within FREESPACE_BUCKET_REACH of a point, by bucket, the nearest first. */
    int bucket_nx, bucket_ny;
    double bucket;      /* m */
    int *bucket_starts; /* (bucket_nx * bucket_ny + 1) */
    int *bucket_faces;  /* (bucket_starts[last]) */
    float *bucket_near; /* m, as many: a lower bound of the face's distance from any point of the bucket */
    Reads *reads;       /* of a copy that one thread uses: notes what is read, a bucket as a list; NULL: not noted */
} FreeSpace;

/* Computes the distances on a grid of about `cell` m. freespace_free releases it. */
void freespace_build(FreeSpace *space, const Outline *outline, double cell);
void freespace_free(FreeSpace *space);

/* Sets the marks (ny x nx) of the grid points within a box to 1. */
void freespace_mark(const FreeSpace *space, Box box, unsigned char *marks);

/* Returns the distance to the nearest obstacle, m, interpolated between grid points; FREESPACE_FARTHEST outside the
 * grid. The error is at most 0.5 cell near obstacles. */
double freespace_distance(const FreeSpace *space, Vec2 at);

/* Returns the exact distance, m, to the nearest planned face within `reach` m (at most FREESPACE_FARTHEST), or `reach`.
 * The distance is positive inside solids, too. `*face` (may be NULL) is that face, or -1. */
double freespace_exact(const FreeSpace *space, Vec2 at, double reach, int *face);

/* Returns the exact clearance of a rectangle, m: its distance from the nearest planned face, up to `reach` m; negative
 * when they overlap, by the depth of the overlap (the least shift along an axis of the rectangle or a face's normal
 * that frees it from that face). The rectangle's centre is `centre`, its half sides are `half_length` along `axis`
 * (unit) and `half_width` across. `*face` (may be NULL): the face that decides, or -1. */
double freespace_clearance(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width,
                           double reach, int *face);

/* Returns the clearance, and fills in those of the rectangle's left and right half from the faces on that side, m, up
 * to `reach`: faces across the axis, before or behind the rectangle, are on both sides. */
double freespace_sides(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width,
                       double reach, double *left, double *right);

/* Returns the same clearance if it is at least `least` m, and otherwise some value below that, sooner. */
double freespace_clearance_from(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width,
                                double least, double reach);

/* Returns how much, m, the rectangle may grow on every side (its corners stay sharp) before it touches a planned face,
 * up to `reach`; negative: how much it must shrink to be free. The result has the sign of freespace_clearance. */
double freespace_growth(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width,
                        double reach, int *face);

/* Fills in the planned faces, at most `most`, whose clearance from the rectangle is less than `reach` m, and returns
 * their number. */
int freespace_faces(const FreeSpace *space, Vec2 centre, Vec2 axis, double half_length, double half_width, double reach,
                    int *faces, int most);

/* Returns the clearance of the rectangle from one face alone, m, as freespace_clearance; with `reach` m or more, at
 * least `reach`. */
double freespace_face_clearance(const FreeSpace *space, int face, Vec2 centre, Vec2 axis, double half_length,
                                double half_width, double reach);

/* True if there is only free space between two places. Decided on the grid, so exact to about half a cell. */
bool freespace_sees(const FreeSpace *space, Vec2 from, Vec2 to);
