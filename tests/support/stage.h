/* Pictures by both painters, and their differences. */
#pragma once

#include "paint/offscreen.h"
#include "paint/paint_gl.h"

typedef struct Picture {
    unsigned char *pixels; /* (height x width x 4) blue, green, red; memory_free it */
    int width, height;
} Picture;

Picture picture_make(int width, int height);
const unsigned char *picture_at(const Picture *picture, int x, int y);
bool picture_equals(const Picture *a, const Picture *b);

/* Returns the box of the pixels that differ by more than `least` of 255. */
Box picture_changed(const Picture *picture, const Picture *ground, int least);

/* Returns the mean colour of the pixels around a place. */
void picture_mean(const Picture *picture, Vec2 at, int reach, double mean[3]);

/* A painter with its context; without OpenGL the test is skipped. stage_end releases it. */
typedef struct Stage {
    Offscreen *offscreen;
    PaintGl *paint;
    Vec2 page;
    Picture picture; /* the last one shown */
} Stage;

Stage stage_begin(OffscreenKind kind, int width, int height, Theme theme);
void stage_end(Stage *stage);

/* Combines two layers. */
void stage_show(Stage *stage, const Scene *still, const Scene *moving);
void stage_show_by_cairo(Picture *picture, const Scene *still, const Scene *moving, Theme theme);
