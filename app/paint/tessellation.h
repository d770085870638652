/* Polygons as triangles: what a graphics card fills. One convex ring is a fan round its middle; anything else goes
 * through GEOS, rings that overlap united or cancelled first, then a constrained Delaunay triangulation. Triangles
 * rather than a stencil, since their edges are known: which of them are the outline's is what smooth edges, upright
 * sides and drawn edges need. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"

typedef struct Triangle {
    Vec2 corners[3]; /* counter-clockwise */
    bool border[3];  /* is the edge from corner i to the next one of the outline? */
} Triangle;

/* Zero is empty; tessellation_clear releases it. */
typedef struct Tessellation {
    Triangle *triangles; /* (count) */
    size_t count, capacity;
    void *geos;   /* GEOS's context, made when it is needed */
    void *sorted; /* edges, while they are matched */
    size_t sorted_capacity;
} Tessellation;

void tessellation_clear(Tessellation *tessellation);

/* Replaces the triangles by those of the rings (starts: ring_count + 1): united where they overlap, or even-odd. */
void tessellation_make(Tessellation *tessellation, const Vec2 *points, const size_t *starts, size_t ring_count,
                       bool united);
