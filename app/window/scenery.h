/* A laboratory's layers as a picture on the window: painted when they change, added to as loci grow, and moved under
 * the hand. */
#pragma once

#include "paint/paint_gl.h"
#include "live/live.h"

typedef struct Scenery {
    PaintGl *paint; /* NULL: there is no place for it yet */
    int width, height;
    double unit; /* pixels a design point */
    Theme theme;
    bool painted; /* what stays is on it */
    Layout still, added, moving;
} Scenery;

/* Makes it that large; of another size than before it is empty. */
void scenery_fit(Scenery *scenery, const Gl *gl, int width, int height, double unit, Theme theme);
void scenery_clear(Scenery *scenery);

/* What stays has changed. */
void scenery_forget(Scenery *scenery);

/* Draws the laboratory at a time; there is a place for it. */
void scenery_show(Scenery *scenery, const LiveKind *kind, void *live, double time);

/* The place on the floor, m, under a point of the picture, and back; design points. */
Vec2 scenery_floor(const Scenery *scenery, Vec2 at);
Vec2 scenery_point(const Scenery *scenery, Vec2 metres);
