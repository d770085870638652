/* Sizes of a picture's small parts, for every painter: in design points. */
#pragma once

#include "draw/layout.h"

#define PAINT_HATCH_GAP 9.0
#define PAINT_HATCH_WIDTH 1.3
#define PAINT_HEAD_LENGTH 11.0 /* of the arrow heads of a dimension */
#define PAINT_HEAD_WIDTH 8.0
#define PAINT_HEAD_SHAFT 20.0 /* of arrows that come from outside */
#define PAINT_TAG_ROUNDING 3.0
#define PAINT_DISC_RIM 2.0
#define PAINT_LEADER_WIDTH 1.5
#define PAINT_LEADER_DOT 3.0
#define PAINT_HALO_WIDTH 4.0
#define PAINT_HALO_OPACITY 0.85
#define PAINT_RULE_WIDTH 1.0
#define PAINT_SYMBOL_HALF 5.0 /* of the list's symbols: the radius of a disc, half the width of a box */
#define PAINT_SYMBOL_BOX_LENGTH 17.0
#define PAINT_SYMBOL_DIAMOND_HALF 7.0

/* Lengths of ink and gap, twice, for a line 4 wide. */
static const double paint_dashes[LINE_STYLES][4] = {
    [LINE_DASHED] = {14, 7, 14, 7}, [LINE_DOTTED] = {0.1, 9, 0.1, 9}, [LINE_DASH_DOT] = {16, 8, 0.1, 8}};

/* Returns the scale of dashes: it grows with the line's width. */
static inline double paint_dash_scale(double width) {
    return fmax(0.5, width / 4);
}

/* True if the ends of the line and of its dashes have round caps. */
static inline bool paint_is_round(LineStyle style) {
    return style == LINE_DOTTED || style == LINE_DASH_DOT;
}

/* Returns the ends of a tick, on the page. */
static inline void paint_tick_ends(const Layout *layout, const Primitive *tick, Vec2 ends[2]) {
    Vec2 at = layout_point(layout, tick->points[0]), to = layout_point(layout, tick->points[1]);
    Vec2 half = vec2_scale(vec2_left(vec2_unit(vec2_sub(to, at))), tick->size / 2);
    ends[0] = vec2_sub(at, half);
    ends[1] = vec2_add(at, half);
}

/* Returns the triangle of an arrow head. */
static inline void paint_head_corners(Vec2 tip, Vec2 way, Vec2 corners[3]) {
    Vec2 foot = vec2_along(tip, -PAINT_HEAD_LENGTH, way), side = vec2_scale(vec2_left(way), PAINT_HEAD_WIDTH / 2);
    corners[0] = tip;
    corners[1] = vec2_add(foot, side);
    corners[2] = vec2_sub(foot, side);
}

/* Returns a wheel seen from above: as long as it is high, as wide as its axle is long; m. */
static inline void paint_wheel_corners(const Primitive *wheel, Vec2 corners[4]) {
    Vec2 from = wheel->points[0], to = wheel->points[1];
    Vec2 way = vec2_scale(vec2_left(vec2_unit(vec2_sub(to, from))), wheel->radius);
    corners[0] = vec2_add(from, way);
    corners[1] = vec2_sub(from, way);
    corners[2] = vec2_sub(to, way);
    corners[3] = vec2_add(to, way);
}

static inline void paint_diamond_corners(Vec2 at, Vec2 corners[4]) {
    static const Vec2 ways[] = {{-1, 0}, {0, -1}, {1, 0}, {0, 1}};
    for (int i = 0; i < 4; i++)
        corners[i] = vec2_along(at, PAINT_SYMBOL_DIAMOND_HALF, ways[i]);
}

/* Returns the corners of a triangle with the centre of the disc around it. */
static inline void paint_triangle_corners(Vec2 at, double radius, Vec2 corners[3]) {
    static const Vec2 ways[] = {{0, -1}, {0.866, 0.5}, {-0.866, 0.5}};
    for (int i = 0; i < 3; i++)
        corners[i] = vec2_along(at, radius, ways[i]);
}

/* Returns the point where the line from the caption's target meets the caption's box. */
static inline Vec2 paint_caption_edge(const Caption *caption) {
    Vec2 way = vec2_sub(caption->pointed, caption->centre), half = vec2_scale(caption->extent, 0.5);
    return vec2_along(caption->centre, 1 / fmax(1, fmax(fabs(way.x) / half.x, fabs(way.y) / half.y)), way);
}
