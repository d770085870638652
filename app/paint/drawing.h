/* Turns a layer's primitives into ink: flat ones as they are painted, ones with height in perspective, lit. */
#pragma once

#include "paint/ink.h"
#include "draw/layout.h"
#include "paint/tessellation.h"

/* The parts of a picture, each drawn over the ones before; depths hide what lies behind solids. A zeroed drawing is
 * empty; drawing_clear releases it. */
typedef struct Drawing {
    Ink floor;   /* flat primitives on the floor, in painting order: they hide nothing by depth */
    Ink shadows; /* on the floor: each place is darkened once */
    Ink faces;   /* of primitives with height: they hide and are hidden; nothing but ink_add_face */
    Ink balls;   /* likewise */
    Ink over;    /* on solids: their edges, and flat primitives above the floor */
    Tessellation tessellation;
    InkPoint *line; /* (line_capacity) the line that is being added */
    size_t line_capacity;
    Theme theme;
    double unit; /* pixels per design point */
} Drawing;

void drawing_clear(Drawing *drawing);

/* Empties a drawing but keeps its memory. */
void drawing_reset(Drawing *drawing);

/* Adds a layer's primitives, without its labels. */
void drawing_add(Drawing *drawing, Layer layer);
