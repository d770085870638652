/* The picture of a laboratory's layers: the static layer is painted when it changes, added parts as they grow, and the
 * moving layer in each frame. */
#pragma once

#include "paint/paint_gl.h"
#include "laboratory/laboratory.h"

typedef struct ViewLayers {
    PaintGl *paint; /* NULL: its size is not known yet */
    int width, height;
    double unit; /* pixels a design point */
    Theme theme;
    bool painted; /* the static layer is painted */
    bool plain;   /* for a presentation: only the most dangerous place has its disc, without scale bar and grid */
    Box taken;    /* design points of the picture, by a button over it: labels keep off */
    Layout still, added, moving;
} ViewLayers;

/* Sets the size; a picture of another size is empty. */
void view_layers_fit(ViewLayers *view_layers, const Gl *gl, int width, int height, double unit, Theme theme);
void view_layers_clear(ViewLayers *view_layers);

/* Sets the place that labels keep off. */
void view_layers_take(ViewLayers *view_layers, Box taken);

/* Marks the static layer as changed. */
void view_layers_invalidate(ViewLayers *view_layers);

/* Draws the laboratory at a time; view_layers_fit must have been called. */
void view_layers_show(ViewLayers *view_layers, const Laboratory *laboratory, void *session, double time);

/* Convert between a point of the picture, design points, and the place on the floor under it, m. */
Vec2 view_layers_floor(const ViewLayers *view_layers, Vec2 at);
Vec2 view_layers_point(const ViewLayers *view_layers, Vec2 metres);
