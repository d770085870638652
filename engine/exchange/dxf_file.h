/* The contents of a DXF drawing: the entities used in plans, of the model and of its blocks, in the drawing's own
 * unit. Private to the DXF importer. */
#pragma once

#include "exchange/house_builder.h"

typedef enum DxfKind {
    DXF_LINES, /* LINE, LWPOLYLINE, POLYLINE */
    DXF_ARC,   /* ARC, CIRCLE */
    DXF_INSERT,
    DXF_OTHER, /* this kind and the following ones are not part of the plan */
    DXF_DIMENSION,
    DXF_TEXT, /* TEXT, MTEXT */
} DxfKind;

/* A corner of a polyline; bulge is the tangent of a quarter of the arc's angle to the next corner, 0 for a straight
 * line. */
typedef struct DxfVertex {
    Vec2 at;
    double bulge;
} DxfVertex;

typedef struct DxfEntity {
    DxfKind kind;
    const char *type;  /* "LWPOLYLINE" */
    const char *block; /* block name of an INSERT; of a DIMENSION, the block that shows it */
    const char *text;  /* of a TEXT; of a DIMENSION, the text instead of the measured length */
    size_t layer;      /* index into the file's layers */
    size_t vertex, vertex_count;
    bool closed;
    bool mirrored; /* seen from below: x points left */
    bool on_paper; /* belongs to a paper sheet, not to the model */
    double width;  /* of a polyline, where it is constant */
    Vec2 at;       /* centre, or the place of a block's base point or of a text, where NAN: not given */
    double radius;
    double start, end;   /* degree, of an arc */
    Vec2 scale, spacing; /* of an INSERT */
    double turned;       /* degree; of a DIMENSION, the direction that it measures */
    Vec2 from, to;       /* points that a DIMENSION measures; NAN: not given */
    double measured;     /* length stored in a DIMENSION */
    int flags;           /* of a DIMENSION */
    int columns, rows;   /* grid of an INSERT */
    int line;            /* line in the file */
} DxfEntity;

typedef struct DxfBlock {
    const char *name;
    Vec2 base;
    size_t first, count; /* range of entities */
    int role;            /* DxfRole, for dxf_layers.c */
} DxfBlock;

typedef struct DxfLayer {
    const char *name;
    unsigned hash;
    bool hidden; /* off or frozen */
    bool window; /* for dxf_layers.c: a layer of walls that holds windows */
    int role;    /* DxfRole, for dxf_layers.c */
} DxfLayer;

typedef struct DxfFile {
    char *text;          /* file text; names point into it */
    DxfEntity *entities; /* (entity_count) */
    DxfVertex *vertices;
    DxfBlock *blocks; /* sorted by name once all are read */
    DxfLayer *layers;
    size_t entity_count, vertex_count, block_count, layer_count;
    size_t entity_capacity, vertex_capacity, block_capacity, layer_capacity;
    size_t model, model_count; /* entities outside blocks */
    int unit;                  /* $INSUNITS; 0: none */
    int notation;              /* $LUNITS, how lengths are written; 0: none */
} DxfFile;

/* Reads the builder's file. Returns false after an error, which the builder holds: for instance if the drawing does
 * not end with the group 0 EOF, or if an entity of the plan lacks a group without default value, such as the end of a
 * LINE. dxf_file_clear releases the result. */
bool dxf_file_read(DxfFile *file, HouseBuilder *builder);
void dxf_file_clear(DxfFile *file);

/* Returns the block of that name, or NULL. */
const DxfBlock *dxf_file_block(const DxfFile *file, const char *name);
