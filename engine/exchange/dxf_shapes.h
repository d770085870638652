/* A drawing's lines as they lie in the plan, blocks put in their places, arcs as straight lines. In the drawing's own
 * unit. Only for the files of dxf.c. */
#pragma once

#include "exchange/dxf_layers.h"

typedef struct DxfShape {
    DxfRole role;
    size_t point, count; /* in the list of all */
    bool closed;
    bool arc; /* of a circle about `centre`, from its first point to its last */
    Vec2 centre;
    double sweep;    /* rad, of an arc */
    double width;    /* of the line */
    size_t instance; /* of a block that is furniture, or SIZE_MAX */
    int line;        /* of the file */
} DxfShape;

/* A block that is one piece of furniture. */
typedef struct DxfInstance {
    const char *block;
    Vec2 x; /* unit vector, where the block's own x axis points to */
} DxfInstance;

typedef struct DxfShapes {
    DxfShape *list; /* (count) */
    Vec2 *points;
    DxfInstance *instances;
    size_t count, point_count, instance_count;
    size_t capacity, point_capacity, instance_capacity;
} DxfShapes;

/* Takes over what is in the model on layers with a role, and reports what is not. False: a fault. dxf_shapes_clear
 * releases them. */
bool dxf_shapes_find(DxfShapes *shapes, const DxfFile *file, HouseBuilder *builder);
void dxf_shapes_clear(DxfShapes *shapes);
