/* Places all parts of a picture: the answer across the top, the plan, the list next to it or below it, whichever
 * leaves the plan larger, and each label where it hides nothing. All lengths are design points, y down, so that a
 * larger picture of the same shape is the same picture. The layout does not know cairo: every painter draws the same
 * layout.
 *
 *        +------------------------------------------------+
 *        | title  detail                                  |
 *        +----------------------------------+-------------+
 *        | name  note                       | heading     |
 *        |                                  | (1) cell  1 |
 *        |  plan                            | heading     |
 *        |                                  | -A- cell  2 |
 *        | clock                      scale |             |
 *        +----------------------------------+-------------+                                                      */
#pragma once

#include "draw/scene.h"

/* A text with its place. */
typedef struct Caption {
    const char *text;
    Vec2 centre;
    Vec2 extent; /* width and height of the box around the text, before turning */
    double size; /* of the text */
    bool bold;
    bool turned; /* by a quarter, read from below */
    bool halo;   /* bare text on the plan: a rim keeps lines away */
    Role role;   /* of bare text */
    LabelShape shape;
    Role fill;   /* of the tag, disc or halo */
    bool leader; /* draws a thin line from `pointed` to the caption */
    Vec2 pointed;
} Caption;

/* A line sample of the list, drawn as the line on the plan. */
typedef struct Sample {
    Vec2 from, to;
    Role role;
    LineStyle style;
    double width; /* 0: no line */
    Symbol symbol;
} Sample;

typedef struct Layout {
    Vec2 page;
    Box band, list; /* empty when the scene has no answer, no rows and no panels */
    Box frame;      /* the rest of the page; clips the scene */
    Box plan;       /* within the frame, around the scene's box */
    Box taken;      /* the scene's, in which no label lies */
    View view;
    double metre;             /* design points per metre of the plan; in a raised view, at its middle */
    Box panels[SCENE_PANELS]; /* (scene.panels) */
    Vec2 *grid;               /* (2 grid_count) ends of the faint lines */
    Caption *captions;        /* (caption_count) */
    Sample *samples;          /* (sample_count) of the list, and the scale bar of a plan */
    size_t grid_count, grid_capacity, caption_count, caption_capacity, sample_count, sample_capacity;
    Arena arena; /* holds the captions' texts: a scene may be rebuilt while its captions are still read */
} Layout;

/* A scene and its layout on the page: painters draw one layer, or several over each other. The captions of all layers
 * are on top. */
typedef struct Layer {
    const Scene *scene;
    const Layout *layout;
} Layer;

/* Returns the pixels of a design point on a page of this size: texts and widths grow with its smaller side. */
double layout_unit(int width, int height);

/* The smallest text on a picture: its capitals are 11.7 pixels high at 1280 x 720. */
#define LAYOUT_SMALLEST_TEXT 16

/* Lays out a scene, which must outlive the layout, on a page of that size. layout_clear releases it. */
void layout_make(Layout *layout, const Scene *scene, Vec2 page);
void layout_clear(Layout *layout);

/* Lays out a layer over another one: its clock and its labels, which are all fixed. A zeroed layout is empty; a used
 * one is reused. */
void layout_make_over(Layout *layout, const Layout *under, const Scene *scene);

/* Adds a line sample, and one of the faint lines; all on the page. */
void layout_add_sample(Layout *layout, Sample sample);
void layout_add_grid_line(Layout *layout, Vec2 from, Vec2 to);

/* Returns the page point of a place on the floor, and of one `height` m above it. */
static inline Vec2 layout_point(const Layout *layout, Vec2 metres) {
    return view_point(&layout->view, metres, 0);
}

static inline Vec2 layout_raised(const Layout *layout, Vec2 metres, double height) {
    return view_point(&layout->view, metres, layout->view.raised ? height : 0);
}
