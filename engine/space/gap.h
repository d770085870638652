/* The geometry of contact: the gaps between a body and its surroundings. The contact law computes the forces.
 *
 * The distance between a segment and a rectangle lies between a corner of the rectangle and the inside of the segment,
 * or between an end of the segment and the rectangle, so two kinds of feature suffice. An obstacle's corner counts only
 * within the wedge of its two faces' normals, where the corner is nearer than any face.
 *
 * Several gaps to one surface are one contact: each one has the share delta_i / sum_j delta_j max(0, n_i . n_j)^2 of
 * the contact, so that a side against a wall, a wall in two pieces, or a corner next to its face push as one, and walls
 * at right angles or on opposite sides push in full. delta is the compression of the personal space, continuous as gaps
 * come and go. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"
#include "space/body.h"
#include "space/neighbour_list.h"

/* One gap. The normal points from the other to the body; the arm points from the body's mass centre to the contact
 * point. */
typedef struct Gap {
    double gap; /* m, negative: overlap */
    Vec2 normal;
    Vec2 arm;     /* m */
    double share; /* 1, share of this gap in the contact with its surface */
    int key;      /* feature * GAP_PARTS + part of the body: constant from step to step */
    bool deep;    /* True if a corner of the core has sunk behind the face */
} Gap;

/* The state of the two tangential springs in a gap, stored as long as body and other are near each other. */
typedef struct Slip {
    int key;
    double body, ring; /* m */
    bool touches;      /* True if the body itself touches */
} Slip;

/* Returns the slip with the key among `count`, or NULL. */
static inline const Slip *gap_find_slip(const Slip *slips, int count, int key) {
    for (int k = 0; k < count; k++)
        if (slips[k].key == key)
            return &slips[k];
    return NULL;
}

enum {
    GAP_PARTS = 8,
    GAPS_MOST = 24, /* gaps of one body at once: the nearest ones leave no space for more contacts */
};

/* Computes the gaps smaller than `body->sight` between a body at `centre` with heading `axis` (unit) and its
 * neighbours, at most GAPS_MOST, with their shares. A corner of the core may sink behind a face by half of the solid;
 * `held` (held_count keys) are the contacts of the previous step, which stay however deep they are, so that no body is
 * driven through a wall. */
size_t gap_to_obstacles(Gap gaps[GAPS_MOST], const Body *body, Vec2 centre, Vec2 axis, const NeighbourList *neighbours,
                        const int *held, size_t held_count);

/* Does the same for a disc and the given faces and corners. */
size_t gap_of_disc(Gap gaps[GAPS_MOST], Vec2 centre, double radius, double sight, const NeighbourFace *const *faces,
                   size_t face_count, const NeighbourCorner *const *corners, size_t corner_count, const int *held,
                   size_t held_count);

/* Computes the gaps smaller than `reach` between bodies a and b; normals point to a, arms start at a's mass centre. */
size_t gap_to_body(Gap gaps[GAPS_MOST], const Body *a, Vec2 centre_a, Vec2 axis_a, const Body *b, Vec2 centre_b,
                   Vec2 axis_b, double reach);

/* Returns the force, N, of one law in one gap, scaled by the gap's share. `compression_gap` (m) is measured to the
 * law's own outline, `rate` and `sliding` (m/s) are the body's velocity along the normal and to its left, `*slip` (m)
 * is the tangential spring. `*normal` (N) is the part along the gap's normal. */
Vec2 gap_force(const ContactLaw *law, const Gap *gap, double compression_gap, double rate, double sliding, double dt,
               double *slip, double *normal);
