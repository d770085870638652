/* Where everything on a picture is: the answer across the top, the plan, the list beside or below it, whichever leaves
 * the plan larger, and a place for each label on which it hides nothing. All in design points, y down, so that a larger
 * picture of the same shape is the same picture. Knows no cairo: every painter draws the same layout.
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

/* Words with a place. */
typedef struct Caption {
    const char *text;
    Vec2 centre;
    Vec2 extent; /* width and height of the box that holds the words, before turning */
    double size; /* of the letters */
    bool bold;
    bool turned; /* a quarter, read from below */
    bool halo;   /* bare words on the plan: a rim keeps the lines away */
    Role role;   /* of bare words */
    LabelShape shape;
    Role fill;   /* of the tag, disc or halo */
    bool leader; /* a thin line goes from `pointed` to it */
    Vec2 pointed;
} Caption;

/* A piece of line in the list, as it looks on the plan. */
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
    Box frame;      /* what is left; nothing of the scene is seen outside it */
    Box plan;       /* within the frame, what holds the scene's box */
    View view;
    double metre;             /* design points a metre of the plan; of the raised view, in its middle */
    Box panels[SCENE_PANELS]; /* (scene.panels) */
    Vec2 *grid;               /* (2 grid_count) ends of the faint lines */
    Caption *captions;        /* (caption_count) */
    Sample *samples;          /* (sample_count) the list's, and the scale bar of a plan */
    size_t grid_count, grid_capacity, caption_count, caption_capacity, sample_count, sample_capacity;
    Arena arena; /* holds shortened words */
} Layout;

/* A scene and where everything of it is on the page: painters are given one or several, one over the other. Captions of
 * all layers are above all else. */
typedef struct Layer {
    const Scene *scene;
    const Layout *layout;
} Layer;

/* Pixels a design point of a page of this size: letters and widths grow with the smaller of its sides. */
double layout_unit(int width, int height);

/* The smallest letters on a picture: their capitals are 11 pixels high at 1280 x 720. */
#define LAYOUT_SMALLEST_TEXT 15

/* Lays out a scene, which must outlive the layout, on a page of that size. layout_clear releases it. */
void layout_make(Layout *layout, const Scene *scene, Vec2 page);
void layout_clear(Layout *layout);

/* Lays out a layer over another one: its clock and its labels, which are all fixed. Zero is an empty layout; one that
 * has been used is used again. */
void layout_make_over(Layout *layout, const Layout *under, const Scene *scene);

/* A piece of line among the words, and one of the faint lines; all on the page. */
void layout_add_sample(Layout *layout, Sample sample);
void layout_add_grid_line(Layout *layout, Vec2 from, Vec2 to);

/* A place on the floor, or so many m above it, on the page. */
static inline Vec2 layout_point(const Layout *layout, Vec2 metres) {
    return view_point(&layout->view, metres, 0);
}

static inline Vec2 layout_raised(const Layout *layout, Vec2 metres, double height) {
    return view_point(&layout->view, metres, layout->view.raised ? height : 0);
}
