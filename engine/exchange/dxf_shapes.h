/* The lines of a drawing in plan coordinates, with blocks inserted and arcs as straight lines, in the drawing's own
 * unit. Private to the DXF importer. */
#pragma once

#include "exchange/dxf_layers.h"

typedef struct DxfShape {
    DxfRole role;
    size_t point, count; /* index of the first point in the list of all points, number of points */
    bool closed;
    bool window; /* on a layer of windows */
    bool arc;    /* part of a circle about `centre`, from its first to its last point */
    Vec2 centre;
    double sweep;    /* rad, of an arc */
    double width;    /* width of the line */
    size_t instance; /* index of the furniture instance, or SIZE_MAX */
    int line;        /* line in the file */
} DxfShape;

/* A block that is one piece of furniture. */
typedef struct DxfInstance {
    const char *block;
    Vec2 x; /* unit vector of the block's x axis */
} DxfInstance;

typedef struct DxfShapes {
    DxfShape *list; /* (count) */
    Vec2 *points;
    DxfInstance *instances;
    size_t count, point_count, instance_count;
    size_t capacity, point_capacity, instance_capacity;
} DxfShapes;

/* Collects the shapes of the model on layers with a role, and reports the others. Returns false after an error.
 * dxf_shapes_clear releases the shapes. */
bool dxf_shapes_find(DxfShapes *shapes, const DxfFile *file, HouseBuilder *builder);
void dxf_shapes_clear(DxfShapes *shapes);
