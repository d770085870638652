/* Polygons as triangles: the shapes that a graphics card fills. A ring that is seen whole from the mean of
 * its points, as convex ones and personal spaces are, is a fan round that point; anything else goes through GEOS:
 * overlapping rings are united or cancelled, then a constrained Delaunay triangulation follows. Triangles are used
 * rather than a stencil, since their edges are known: smooth edges, upright sides and drawn edges need to know which
 * edges belong to the outline. What went through GEOS lately is kept: walls are the same in one picture after another
 * while a piece is dragged. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"

typedef struct Triangle {
    Vec2 corners[3]; /* counter-clockwise */
    bool border[3];  /* true if the edge from corner i to the next one belongs to the outline */
} Triangle;

enum {
    TESSELLATION_KEPT = 32,
    TESSELLATION_LARGEST = 8192 /* points: larger shapes, such as thousands of people, would take too much memory */
};

/* The triangles of rings that went through GEOS. */
typedef struct Tessellated {
    Vec2 *points;   /* (starts[ring_count]) */
    size_t *starts; /* (ring_count + 1) */
    size_t ring_count;
    bool united;
    Triangle *triangles; /* (count) */
    size_t count;
} Tessellated;

/* Zero is empty; tessellation_clear releases it. */
typedef struct Tessellation {
    Triangle *triangles; /* (count) */
    size_t count, capacity;
    void *geos;   /* GEOS's context, made when needed */
    void *sorted; /* edges, while they are matched */
    size_t sorted_capacity;
    Tessellated kept[TESSELLATION_KEPT]; /* the oldest is replaced */
    size_t kept_count;                   /* of all that were ever kept */
} Tessellation;

void tessellation_clear(Tessellation *tessellation);

/* Replaces the triangles by those of the rings (starts: ring_count + 1): united where they overlap, or even-odd. */
void tessellation_make(Tessellation *tessellation, const Vec2 *points, const size_t *starts, size_t ring_count,
                       bool united);
