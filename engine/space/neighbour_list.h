/* The obstacles near a body, stored from step to step (a Verlet list). */
#pragma once

#include <stdbool.h>

#include "base/vec2.h"
#include "space/body.h"
#include "space/outline.h"

enum { NEIGHBOURS_MOST = 96 /* features stored per body; the nearest, if there are more */ };

/* A face near a body, prepared for dot products. */
typedef struct NeighbourFace {
    Vec2 normal;
    double offset;     /* m: normal . p = offset on the face */
    double begin, end; /* m: tangent . p on the face, the tangent is the normal turned left */
    double depth;      /* m: how far behind the face its solid may be touched */
    int id;
} NeighbourFace;

typedef struct NeighbourCorner {
    Vec2 at, in, out;
    int id;
} NeighbourCorner;

/* The obstacles that a body may touch before it has moved NEIGHBOUR_SKIN m. A subset, rebuilt more often and examined
 * in every step, holds those that the body may touch before any part of it has moved NEIGHBOUR_SLACK m. */
typedef struct NeighbourList {
    Vec2 centre; /* m, the core's middle when the list was built */
    int faces, corners;
    int doors; /* 1 + number of door changes when the list was built; 0: never built */
    NeighbourFace face[NEIGHBOURS_MOST];
    NeighbourCorner corner[NEIGHBOURS_MOST];
    Vec2 slack_centre, slack_axis; /* position and heading when the subset was built */
    int close_faces, close_corners;
    short close_face[NEIGHBOURS_MOST], close_corner[NEIGHBOURS_MOST];
} NeighbourList;

/* Return the face or corner `index` of an outline, prepared for contact. */
NeighbourFace neighbour_list_face(const Outline *outline, const Plan *plan, size_t index);
NeighbourCorner neighbour_list_corner(const Outline *outline, size_t index);

/* True if a point that moves from `before` to `after` passes through the face into its solid. */
static inline bool neighbour_list_crosses(const NeighbourFace *face, Vec2 before, Vec2 after) {
    double from = vec2_dot(face->normal, before) - face->offset, to = vec2_dot(face->normal, after) - face->offset;
    if (from < 0 || to >= 0)
        return false;
    Vec2 where = vec2_along(before, from / (from - to), vec2_sub(after, before));
    double along = vec2_dot(vec2_left(face->normal), where);
    return along > face->begin && along < face->end;
}

/* m: motion of a body after which its neighbours are collected again. */
#define NEIGHBOUR_SKIN 0.25

/* m: motion of any part of the body after which the subset is selected again. */
#define NEIGHBOUR_SLACK 0.03

/* Collects the obstacles that a body at `centre` with heading `axis` may touch soon, unless the list is still valid.
 * `door_open` (one per door) gives the state of the doors, `door_changes` the number of changes so far. A zeroed list
 * is empty. */
void neighbour_list_update(NeighbourList *neighbours, const Body *body, Vec2 centre, Vec2 axis, const Outline *outline,
                           const Plan *plan, const bool *door_open, int door_changes);
