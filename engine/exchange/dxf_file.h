/* What a DXF drawing holds, as it holds it: the entities that plans are drawn with, of the model and of its blocks, in
 * the drawing's own unit. Only for the files of dxf.c. */
#pragma once

#include "exchange/house_builder.h"

typedef enum DxfKind {
    DXF_LINES, /* LINE, LWPOLYLINE, POLYLINE */
    DXF_ARC,   /* ARC, CIRCLE */
    DXF_INSERT,
    DXF_OTHER,
} DxfKind;

/* A corner of a polyline; bulge is the tangent of a quarter of the arc's angle to the next one, 0: straight. */
typedef struct DxfVertex {
    Vec2 at;
    double bulge;
} DxfVertex;

typedef struct DxfEntity {
    DxfKind kind;
    const char *type;  /* "LWPOLYLINE" */
    const char *block; /* of an INSERT: its name */
    size_t layer;      /* of the file's layers */
    size_t vertex, vertex_count;
    bool closed;
    bool mirrored; /* seen from below: x points to the left */
    bool on_paper; /* no part of the model */
    double width;  /* of a polyline, as far as it is the same everywhere */
    Vec2 at;       /* centre, or where a block's base comes to lie */
    double radius;
    double start, end;   /* degree, of an arc */
    Vec2 scale, spacing; /* of an INSERT */
    double turned;       /* degree */
    int columns, rows;   /* of an INSERT that is a grid of them */
    int line;            /* of the file */
} DxfEntity;

typedef struct DxfBlock {
    const char *name;
    Vec2 base;
    size_t first, count; /* of the entities */
    int role;            /* DxfRole, for dxf_layers.c */
} DxfBlock;

typedef struct DxfLayer {
    const char *name;
    unsigned hash;
    bool hidden; /* off or frozen */
    int role;    /* DxfRole, for dxf_layers.c */
} DxfLayer;

typedef struct DxfFile {
    char *text;          /* names point into it */
    DxfEntity *entities; /* (entity_count) */
    DxfVertex *vertices;
    DxfBlock *blocks; /* by name, once all are read */
    DxfLayer *layers;
    size_t entity_count, vertex_count, block_count, layer_count;
    size_t entity_capacity, vertex_capacity, block_capacity, layer_capacity;
    size_t model, model_count; /* the entities that are no block's */
    int unit;                  /* $INSUNITS; 0: none */
} DxfFile;

/* Reads the builder's file. False: a fault, of the builder. dxf_file_clear releases what is read. */
bool dxf_file_read(DxfFile *file, HouseBuilder *builder);
void dxf_file_clear(DxfFile *file);

/* The block of that name, or NULL. */
const DxfBlock *dxf_file_block(const DxfFile *file, const char *name);
