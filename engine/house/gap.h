/* The geometry of contact: which gaps there are between a body and what surrounds it. It makes gaps; forces are the
 * contact law's business.
 *
 * A body is a rounded rectangle: all points within `radius` of a core rectangle. A round body has a core of no size.
 *
 *       .-----------------.
 *      ( o---------------o )      o  the core's corners, in contact with faces
 *      | |     core    +x| |      sides of the core in contact with corners of obstacles
 *      ( o---------------o )      the frame's origin is the mass centre, x along the heading
 *       '-----------------'
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
#include "house/outline.h"
#include "house/profile.h"

typedef struct Body {
    Vec2 core_low, core_high; /* m, in the body's frame */
    Vec2 core[4];             /* m, its corners, counter-clockwise from the right rear; all alike for a disc */
    Vec2 middle, half;        /* m, of the core: its middle and its half sides */
    int core_count;           /* 4, or 1 for a disc */
    double radius;            /* m, of the rounding */
    double reach;             /* m, of the personal space beyond the body */
    double outer;             /* m, radius about the core's middle that holds the body and its personal space */
    double swing;             /* m, radius about the mass centre that holds the core: what turning moves */
} Body;

Body body_of(const Profile *profile);

/* One gap. The normal points from the other to the body; the arm from the body's mass centre to where they meet. */
typedef struct Gap {
    double gap; /* m, negative: overlap */
    Vec2 normal;
    Vec2 arm;     /* m */
    double share; /* 1, of the contact with this surface */
    int key;      /* feature * GAP_PARTS + part of the body: the same from step to step */
} Gap;

enum {
    GAP_PARTS = 8,
    GAPS_MOST = 24, /* at once, of one body: beyond the nearest ones no room is left to touch more */
    NEAR_MOST = 96, /* features kept near a body; when there are more, the nearest */
};

/* A face near a body, ready for dot products. */
typedef struct NearFace {
    Vec2 normal;
    double offset;     /* m: normal . p = offset on the face */
    double begin, end; /* m: tangent . p on the face, the tangent is the normal turned left */
    double depth;      /* m: how far behind the face its solid may be touched from */
    double distance;   /* m, from where it was gathered; the list rises by it */
    int id;
} NearFace;

typedef struct NearCorner {
    Vec2 at, in, out;
    int id;
} NearCorner;

/* The obstacles that a body may touch before it has moved NEAR_SKIN m, and among them, gathered more often and looked
 * at in every step, those that it may touch before any part of it has moved NEAR_SLACK m. */
typedef struct Near {
    Vec2 centre; /* m, the core's middle when it was gathered */
    int faces, corners;
    int doors; /* changes of doors that had been seen then */
    NearFace face[NEAR_MOST];
    NearCorner corner[NEAR_MOST];
    Vec2 slack_centre, slack_axis; /* the same for the closer lists */
    int close_faces, close_corners;
    short close_face[NEAR_MOST], close_corner[NEAR_MOST];
} Near;

/* m: how far a body may move before its neighbours are gathered anew. */
#define NEAR_SKIN 0.25

/* m: and any part of it before the close ones are chosen anew. */
#define NEAR_SLACK 0.03

/* Gathers what a body that stands at `centre` with heading `axis` may touch soon, unless what was gathered still holds.
 * `door_open` (one per door) says which leaves are where, `door_changes` counts how often one has changed; zero is a
 * Near that holds nothing. */
void near_update(Near *near, const Body *body, Vec2 centre, Vec2 axis, const Outline *outline, const Plan *plan,
                 const bool *door_open, int door_changes);

/* The gaps smaller than `body->reach` between a body at `centre` with heading `axis` (unit) and its neighbours; at most
 * GAPS_MOST, shares filled in. */
size_t gap_to_obstacles(Gap gaps[GAPS_MOST], const Body *body, Vec2 centre, Vec2 axis, const Near *near);

/* The gaps smaller than `reach` between body a and body b; normals point to a, arms are a's. */
size_t gap_to_body(Gap gaps[GAPS_MOST], const Body *a, Vec2 centre_a, Vec2 axis_a, const Body *b, Vec2 centre_b,
                   Vec2 axis_b, double reach);
