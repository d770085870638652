/* The geometry of contact: which gaps there are between a body and what surrounds it. It makes gaps; forces are the
 * contact law's business.
 *
 * Distance of a segment and a rectangle: it is taken at a corner of the rectangle and the inside of the segment, or at
 * an end of the segment and the rectangle; so two kinds of feature say everything. An obstacle's corner counts only
 * from within the wedge of its two faces' normals, where it, and no face, is nearest.
 *
 * Several gaps to one surface are one contact: each has the share delta_i / sum_j delta_j max(0, n_i . n_j)^2 of it, so
 * that a side against a wall, a wall in two pieces, or a corner beside its face push as one, and walls at right angles
 * or on opposite sides push in full. delta is the compression of the personal space, continuous as gaps come and go. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"
#include "space/body.h"
#include "space/neighbour_list.h"

/* One gap. The normal points from the other to the body; the arm from the body's mass centre to where they meet. */
typedef struct Gap {
    double gap; /* m, negative: overlap */
    Vec2 normal;
    Vec2 arm;     /* m */
    double share; /* 1, of the contact with this surface */
    int key;      /* feature * GAP_PARTS + part of the body: the same from step to step */
    bool deep;    /* a corner of the core has sunk behind the face */
} Gap;

/* The memory of the two tangential springs in a gap, as long as body and other are near. */
typedef struct Slip {
    int key;
    double body, ring; /* m */
    bool touches;      /* the body itself */
} Slip;

/* The one with the key among `count`, or NULL. */
static inline const Slip *gap_find_slip(const Slip *slips, int count, int key) {
    for (int k = 0; k < count; k++)
        if (slips[k].key == key)
            return &slips[k];
    return NULL;
}

enum {
    GAP_PARTS = 8,
    GAPS_MOST = 24, /* at once, of one body: beyond the nearest ones no room is left to touch more */
};

/* The gaps smaller than `body->sight` between a body at `centre` with heading `axis` (unit) and its neighbours; at most
 * GAPS_MOST, shares filled in. A corner of the core may sink behind a face by half of the solid; `held` (held_count
 * keys) are the contacts of the step before, which are not let go however deep they are, so that nobody is driven
 * through a wall. */
size_t gap_to_obstacles(Gap gaps[GAPS_MOST], const Body *body, Vec2 centre, Vec2 axis, const NeighbourList *neighbours,
                        const int *held, size_t held_count);

/* The same for a disc beside the faces and corners that are given. */
size_t gap_of_disc(Gap gaps[GAPS_MOST], Vec2 centre, double radius, double sight, const NeighbourFace *const *faces,
                   size_t face_count, const NeighbourCorner *const *corners, size_t corner_count, const int *held,
                   size_t held_count);

/* The gaps smaller than `reach` between body a and body b; normals point to a, arms are a's. */
size_t gap_to_body(Gap gaps[GAPS_MOST], const Body *a, Vec2 centre_a, Vec2 axis_a, const Body *b, Vec2 centre_b,
                   Vec2 axis_b, double reach);

/* What one law does in one gap, of which the body has the share, N: `compression_gap` (m) is where the law's own
 * outline is, `rate` and `sliding` (m/s) how the body moves along the normal and to its left, `*slip` (m) the
 * tangential spring. `*normal` (N) is the part along the gap's normal. */
Vec2 gap_force(const ContactLaw *law, const Gap *gap, double compression_gap, double rate, double sliding, double dt,
               double *slip, double *normal);
