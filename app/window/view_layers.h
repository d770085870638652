/* A laboratory's layers as a picture on the window: painted when they change, added to as loci grow, and moved under
 * the hand. */
#pragma once

#include "paint/paint_gl.h"
#include "laboratory/laboratory.h"

typedef struct ViewLayers {
    PaintGl *paint; /* NULL: there is no place for it yet */
    int width, height;
    double unit; /* pixels a design point */
    Theme theme;
    bool painted; /* what stays is on it */
    Layout still, added, moving;
} ViewLayers;

/* Makes it that large; of another size than before it is empty. */
void view_layers_fit(ViewLayers *view_layers, const Gl *gl, int width, int height, double unit, Theme theme);
void view_layers_clear(ViewLayers *view_layers);

/* What stays has changed. */
void view_layers_invalidate(ViewLayers *view_layers);

/* Draws the laboratory at a time; there is a place for it. */
void view_layers_show(ViewLayers *view_layers, const Laboratory *kind, void *live, double time);

/* The place on the floor, m, under a point of the picture, and back; design points. */
Vec2 view_layers_floor(const ViewLayers *view_layers, Vec2 at);
Vec2 view_layers_point(const ViewLayers *view_layers, Vec2 metres);
