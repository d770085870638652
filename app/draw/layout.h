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
    Box band, plan, list; /* the list's box is empty when the scene has no rows */
    double metre;         /* design points a metre of the plan */
    Vec2 origin;          /* where (0, 0) m is */
    double grid;          /* m, between the lines; 0: none */
    Sample bar;           /* the scale bar */
    Caption *captions;    /* (caption_count) */
    Sample *samples;      /* (sample_count) */
    size_t caption_count, caption_capacity, sample_count, sample_capacity;
    Arena arena; /* holds shortened words */
} Layout;

/* The smallest letters on a picture: their capitals are 11 pixels high at 1280 x 720. */
#define LAYOUT_SMALLEST_LETTERS 15

/* Lays out a scene, which must outlive the layout, on a page of that size. layout_clear releases it. */
void layout_make(Layout *layout, const Scene *scene, Vec2 page);
void layout_clear(Layout *layout);

/* Adds words in the middle of a box of their own size; good until the next addition. */
Caption *layout_add_caption(Layout *layout, const char *text, double size, bool bold, Vec2 centre);

/* A place of the plan on the page. */
static inline Vec2 layout_point(const Layout *layout, Vec2 metres) {
    return vec2(layout->origin.x + layout->metre * metres.x, layout->origin.y - layout->metre * metres.y);
}
