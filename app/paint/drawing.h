/* A layer's primitives as ink: what lies flat as it is painted, what has height in perspective, lit. */
#pragma once

#include "paint/ink.h"
#include "draw/layout.h"
#include "paint/tessellation.h"

/* The parts of a picture, each drawn over the ones before; depths hide what is behind solids. Zero is empty;
 * drawing_clear releases it. */
typedef struct Drawing {
    Ink floor;   /* flat things on the floor, in painting order: they hide nothing by depth */
    Ink shadows; /* on the floor: each place is darkened once */
    Ink faces;   /* of things with height: they hide and are hidden; nothing but ink_add_face */
    Ink balls;   /* likewise */
    Ink over;    /* on solids: their edges, and what lies flat above the floor */
    Tessellation tessellation;
    InkPoint *line; /* (line_capacity) a line on its way */
    size_t line_capacity;
    Theme theme;
    double unit; /* pixels a design point */
} Drawing;

void drawing_clear(Drawing *drawing);

/* Forgets what was drawn and keeps the memory. */
void drawing_reset(Drawing *drawing);

/* Adds a layer's primitives, without its labels. */
void drawing_add(Drawing *drawing, Layer layer);
