/* The obstacles near a body, kept from step to step. */
#pragma once

#include <stdbool.h>

#include "base/vec2.h"
#include "space/body.h"
#include "space/outline.h"

enum { NEIGHBOURS_MOST = 96 /* features kept near a body; when there are more, the nearest */ };

/* A face near a body, ready for dot products. */
typedef struct NeighbourFace {
    Vec2 normal;
    double offset;     /* m: normal . p = offset on the face */
    double begin, end; /* m: tangent . p on the face, the tangent is the normal turned left */
    double depth;      /* m: how far behind the face its solid may be touched from */
    int id;
} NeighbourFace;

typedef struct NeighbourCorner {
    Vec2 at, in, out;
    int id;
} NeighbourCorner;

/* The obstacles that a body may touch before it has moved NEIGHBOUR_SKIN m, and among them, gathered more often and
 * looked at in every step, those that it may touch before any part of it has moved NEIGHBOUR_SLACK m. */
typedef struct NeighbourList {
    Vec2 centre; /* m, the core's middle when it was gathered */
    int faces, corners;
    int doors; /* changes of doors that had been seen then */
    NeighbourFace face[NEIGHBOURS_MOST];
    NeighbourCorner corner[NEIGHBOURS_MOST];
    Vec2 slack_centre, slack_axis; /* the same for the closer lists */
    int close_faces, close_corners;
    short close_face[NEIGHBOURS_MOST], close_corner[NEIGHBOURS_MOST];
} NeighbourList;

/* The face or corner `index` of an outline, made ready. */
NeighbourFace neighbour_list_face(const Outline *outline, const Plan *plan, size_t index);
NeighbourCorner neighbour_list_corner(const Outline *outline, size_t index);

/* Does a point, on the way from one place to another, go through the face into its solid? */
static inline bool neighbour_list_crosses(const NeighbourFace *face, Vec2 before, Vec2 after) {
    double from = vec2_dot(face->normal, before) - face->offset, to = vec2_dot(face->normal, after) - face->offset;
    if (from < 0 || to >= 0)
        return false;
    Vec2 where = vec2_along(before, from / (from - to), vec2_sub(after, before));
    double along = vec2_dot(vec2_left(face->normal), where);
    return along > face->begin && along < face->end;
}

/* m: how far a body may move before its neighbours are gathered anew. */
#define NEIGHBOUR_SKIN 0.25

/* m: and any part of it before the close ones are chosen anew. */
#define NEIGHBOUR_SLACK 0.03

/* Gathers what a body that stands at `centre` with heading `axis` may touch soon, unless what was gathered still holds.
 * `door_open` (one per door) says which leaves are where, `door_changes` counts how often one has changed; zero is a
 * NeighbourList that holds nothing. */
void neighbour_list_update(NeighbourList *neighbours, const Body *body, Vec2 centre, Vec2 axis, const Outline *outline,
                           const Plan *plan, const bool *door_open, int door_changes);
