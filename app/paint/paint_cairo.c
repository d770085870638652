#include "paint/paint_cairo.h"

#include <cairo.h>

#include "paint/cairo_file.h"
#include "draw/layout.h"
#include "paint/paint_sizes.h"
#include "draw/text.h"

typedef struct Painter {
    cairo_t *cairo;
    const Layout *layout;
    Theme theme;
} Painter;

static void use_colour(const Painter *painter, Colour colour, double opacity) {
    if (opacity < 1)
        cairo_set_source_rgba(painter->cairo, colour.red, colour.green, colour.blue, opacity);
    else
        cairo_set_source_rgb(painter->cairo, colour.red, colour.green, colour.blue);
}

static void use_role(const Painter *painter, Role role, double opacity) {
    use_colour(painter, palette_colour(painter->theme, role), opacity);
}

static void use_dashes(cairo_t *cairo, LineStyle style, double width, double begun) {
    double scale = paint_dash_scale(width), dashes[4];
    for (int i = 0; i < 4; i++)
        dashes[i] = paint_dashes[style][i] * scale;
    cairo_set_dash(cairo, dashes, style == LINE_SOLID ? 0 : 4, begun);
}

void paint_cairo_line(cairo_t *cairo, LineStyle style, double width) {
    use_dashes(cairo, style, width, 0);
    cairo_set_line_cap(cairo, style == LINE_SOLID || style == LINE_DASHED ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(cairo, width);
}

static void use_line(const Painter *painter, LineStyle style, double width) {
    paint_cairo_line(painter->cairo, style, width);
}

static void path_point(const Painter *painter, Vec2 metres) {
    Vec2 at = layout_point(painter->layout, metres);
    cairo_line_to(painter->cairo, at.x, at.y);
}

static void path_box(const Painter *painter, Box box) {
    cairo_rectangle(painter->cairo, box.low.x, box.low.y, box_width(box), box_height(box));
}

static void path_segment(const Painter *painter, Vec2 from, Vec2 to) {
    cairo_move_to(painter->cairo, from.x, from.y);
    cairo_line_to(painter->cairo, to.x, to.y);
}

static void path_disc(const Painter *painter, Vec2 centre, double radius) {
    cairo_new_sub_path(painter->cairo);
    cairo_arc(painter->cairo, centre.x, centre.y, radius, 0, 2 * M_PI);
}

/* Lines at 45 degrees over the current path. */
static void hatch(const Painter *painter, Role role) {
    double left, top, right, bottom;
    cairo_path_extents(painter->cairo, &left, &top, &right, &bottom);
    cairo_save(painter->cairo);
    cairo_clip_preserve(painter->cairo);
    cairo_path_t *outline = cairo_copy_path(painter->cairo);
    cairo_new_path(painter->cairo);
    for (double x = left - (bottom - top); x < right; x += PAINT_HATCH_GAP)
        path_segment(painter, vec2(x, bottom), vec2(x + bottom - top, top));
    use_line(painter, LINE_SOLID, PAINT_HATCH_WIDTH);
    use_role(painter, role, 1);
    cairo_stroke(painter->cairo);
    cairo_restore(painter->cairo);
    cairo_append_path(painter->cairo, outline);
    cairo_path_destroy(outline);
}

/* Fills and strokes the current path by the primitive's style, and clears the path. */
static void finish_path(const Painter *painter, const Primitive *primitive) {
    if (primitive->fill_opacity > 0) {
        use_role(painter, primitive->fill, primitive->fill_opacity);
        cairo_fill_preserve(painter->cairo);
    }
    if (primitive->hatched)
        hatch(painter, primitive->edge);
    if (primitive->width > 0) {
        use_line(painter, primitive->style, primitive->width);
        use_dashes(painter->cairo, primitive->style, primitive->width, primitive->begun * painter->layout->metre);
        use_role(painter, primitive->edge, primitive->edge_opacity);
        cairo_stroke_preserve(painter->cairo);
    }
    cairo_new_path(painter->cairo);
}

static void paint_polygon(const Painter *painter, const Primitive *polygon) {
    cairo_set_fill_rule(painter->cairo, polygon->united ? CAIRO_FILL_RULE_WINDING : CAIRO_FILL_RULE_EVEN_ODD);
    for (size_t r = 0; r < polygon->ring_count; r++) {
        cairo_new_sub_path(painter->cairo);
        for (size_t i = polygon->starts[r]; i < polygon->starts[r + 1]; i++)
            path_point(painter, polygon->points[i]);
        cairo_close_path(painter->cairo);
    }
    finish_path(painter, polygon);
}

static void paint_line(const Painter *painter, const Primitive *line) {
    for (size_t i = 0; i < line->count; i++)
        path_point(painter, line->points[i]);
    finish_path(painter, line);
}

static void paint_tick(const Painter *painter, const Primitive *tick) {
    Vec2 ends[2];
    paint_tick_ends(painter->layout, tick, ends);
    path_segment(painter, ends[0], ends[1]);
    finish_path(painter, tick);
}

static void path_corners(const Painter *painter, const Vec2 *corners, size_t count) {
    for (size_t i = 0; i < count; i++)
        cairo_line_to(painter->cairo, corners[i].x, corners[i].y);
    cairo_close_path(painter->cairo);
}

static void paint_head(const Painter *painter, const Primitive *dimension, Vec2 tip, Vec2 way) {
    Vec2 corners[3];
    paint_head_corners(tip, way, corners);
    path_corners(painter, corners, 3);
    use_role(painter, dimension->edge, 1);
    cairo_fill(painter->cairo);
}

static void paint_dimension(const Painter *painter, const Primitive *dimension) {
    Vec2 a = layout_point(painter->layout, dimension->points[0]),
         b = layout_point(painter->layout, dimension->points[1]);
    Vec2 way = vec2_unit(vec2_sub(b, a));
    bool outside = vec2_distance(a, b) < 3 * PAINT_HEAD_LENGTH;
    double shaft = outside ? PAINT_HEAD_SHAFT : 0;
    path_segment(painter, vec2_along(a, -shaft, way), vec2_along(b, shaft, way));
    finish_path(painter, dimension);
    paint_head(painter, dimension, a, vec2_scale(way, outside ? 1 : -1));
    paint_head(painter, dimension, b, vec2_scale(way, outside ? -1 : 1));
}

static void path_point_disc(const Painter *painter, Vec2 metres, double radius) {
    path_disc(painter, layout_point(painter->layout, metres), radius * painter->layout->metre);
}

static void paint_discs(const Painter *painter, const Primitive *discs) {
    cairo_set_fill_rule(painter->cairo, CAIRO_FILL_RULE_WINDING);
    for (size_t i = 0; i < discs->count; i++)
        path_point_disc(painter, discs->points[i], discs->radius);
    finish_path(painter, discs);
}

static void paint_wheel(const Painter *painter, const Primitive *wheel) {
    Vec2 corners[4];
    paint_wheel_corners(wheel, corners);
    for (size_t i = 0; i < 4; i++)
        corners[i] = layout_point(painter->layout, corners[i]);
    path_corners(painter, corners, 4);
    finish_path(painter, wheel);
}

static void paint_primitive(const Painter *painter, const Primitive *primitive) {
    static void (*const paint[])(const Painter *, const Primitive *) = {
        [PRIMITIVE_POLYGON] = paint_polygon,    [PRIMITIVE_LINE] = paint_line,  [PRIMITIVE_DISC] = paint_discs,
        [PRIMITIVE_WHEEL] = paint_wheel,        [PRIMITIVE_BALL] = paint_discs, [PRIMITIVE_TICK] = paint_tick,
        [PRIMITIVE_DIMENSION] = paint_dimension};
    if (primitive->kind != PRIMITIVE_LABEL)
        paint[primitive->kind](painter, primitive);
}

static void paint_tag(const Painter *painter, const Caption *caption) {
    Vec2 low = vec2_scale(caption->extent, -0.5);
    path_box(painter, (Box){low, vec2_scale(low, -1)});
    use_role(painter, caption->fill, 1);
    cairo_fill_preserve(painter->cairo);
    use_line(painter, LINE_SOLID, PAINT_TAG_ROUNDING); /* round joins at the corners */
    cairo_stroke(painter->cairo);
}

static void paint_disc(const Painter *painter, const Caption *caption) {
    path_disc(painter, vec2(0, 0), caption->extent.x / 2 - PAINT_DISC_RIM / 2);
    use_role(painter, caption->fill, 1);
    cairo_fill_preserve(painter->cairo);
    use_line(painter, LINE_SOLID, PAINT_DISC_RIM);
    use_role(painter, ROLE_WALL, 1);
    cairo_stroke(painter->cairo);
}

static void paint_halo(const Painter *painter, const Caption *caption) {
    text_path(painter->cairo, caption->text, caption->size, caption->bold, vec2(0, 0));
    use_line(painter, LINE_SOLID, PAINT_HALO_WIDTH);
    use_role(painter, caption->fill, PAINT_HALO_OPACITY);
    cairo_stroke(painter->cairo);
}

static void paint_leader(const Painter *painter, const Caption *caption) {
    path_segment(painter, caption->pointed, paint_caption_edge(caption));
    use_line(painter, LINE_SOLID, PAINT_LEADER_WIDTH + PAINT_HALO_WIDTH);
    use_role(painter, ROLE_PAPER, PAINT_HALO_OPACITY);
    cairo_stroke_preserve(painter->cairo);
    use_line(painter, LINE_SOLID, PAINT_LEADER_WIDTH);
    use_role(painter, ROLE_WALL, 1);
    cairo_stroke(painter->cairo);
    path_disc(painter, caption->pointed, PAINT_LEADER_DOT);
    cairo_fill(painter->cairo);
}

static void paint_caption(const Painter *painter, const Caption *caption) {
    cairo_save(painter->cairo);
    cairo_translate(painter->cairo, caption->centre.x, caption->centre.y);
    if (caption->turned)
        cairo_rotate(painter->cairo, -M_PI / 2);
    if (caption->shape == LABEL_TAG)
        paint_tag(painter, caption);
    if (caption->shape == LABEL_DISC)
        paint_disc(painter, caption);
    if (caption->halo)
        paint_halo(painter, caption);
    Colour ink = caption->shape == LABEL_BARE ? palette_colour(painter->theme, caption->role)
                                              : palette_ink(painter->theme, caption->fill);
    use_colour(painter, ink, 1);
    text_show(painter->cairo, caption->text, caption->size, caption->bold, vec2(0, 0));
    cairo_restore(painter->cairo);
}

static void path_symbol(const Painter *painter, Symbol symbol, Vec2 at) {
    if (symbol == SYMBOL_DISC)
        path_disc(painter, at, PAINT_SYMBOL_HALF);
    if (symbol == SYMBOL_BOX)
        path_box(painter, (Box){{at.x - PAINT_SYMBOL_BOX_LENGTH / 2, at.y - PAINT_SYMBOL_HALF},
                                {at.x + PAINT_SYMBOL_BOX_LENGTH / 2, at.y + PAINT_SYMBOL_HALF}});
    if (symbol == SYMBOL_DIAMOND) {
        Vec2 corners[4];
        paint_diamond_corners(at, corners);
        path_corners(painter, corners, 4);
    }
    if (symbol == SYMBOL_TRIANGLE) {
        Vec2 corners[3];
        paint_triangle_corners(at, PAINT_SYMBOL_DIAMOND_HALF, corners);
        path_corners(painter, corners, 3);
    }
}

static void paint_sample(const Painter *painter, const Sample *sample) {
    use_role(painter, sample->role, 1);
    if (sample->width > 0) {
        path_segment(painter, sample->from, sample->to);
        use_line(painter, sample->style, sample->width);
        cairo_stroke(painter->cairo);
    }
    if (sample->symbol != SYMBOL_NONE) {
        path_symbol(painter, sample->symbol, vec2_scale(vec2_add(sample->from, sample->to), 0.5));
        cairo_fill(painter->cairo);
    }
}

/* Paper, and the list's panel with a rule around it. */
static void paint_ground(const Painter *painter) {
    const Layout *layout = painter->layout;
    use_role(painter, ROLE_PAPER, 1);
    path_box(painter, (Box){{0, 0}, layout->page});
    cairo_fill(painter->cairo);
    use_role(painter, ROLE_PANEL, 1);
    path_box(painter, layout->list);
    cairo_fill(painter->cairo);
    use_line(painter, LINE_SOLID, PAINT_RULE_WIDTH);
    use_role(painter, ROLE_GRID, 1);
    path_box(painter, layout->list);
    path_segment(painter, vec2(0, layout->band.high.y), vec2(layout->page.x, layout->band.high.y));
    cairo_stroke(painter->cairo);
}

void paint_cairo_grid(cairo_t *cairo, const Layout *layout, Theme theme) {
    Painter painter = {cairo, layout, theme};
    for (size_t i = 0; i < layout->grid_count; i++)
        path_segment(&painter, layout->grid[2 * i], layout->grid[2 * i + 1]);
    use_line(&painter, LINE_SOLID, PAINT_RULE_WIDTH);
    use_role(&painter, ROLE_GRID, 1);
    cairo_stroke(cairo);
}

static void paint_primitives(const Painter *painter, const Scene *scene) {
    cairo_save(painter->cairo);
    path_box(painter, painter->layout->frame);
    cairo_clip(painter->cairo);
    for (size_t i = 0; i < scene->count; i++)
        paint_primitive(painter, &scene->primitives[i]);
    cairo_restore(painter->cairo);
}

void paint_cairo_captions(cairo_t *cairo, const Layout *layout, Theme theme) {
    Painter painter = {cairo, layout, theme};
    for (size_t i = 0; i < layout->caption_count; i++)
        if (layout->captions[i].leader)
            paint_leader(&painter, &layout->captions[i]);
    for (size_t i = 0; i < layout->sample_count; i++)
        paint_sample(&painter, &layout->samples[i]);
    for (size_t i = 0; i < layout->caption_count; i++)
        paint_caption(&painter, &layout->captions[i]);
}

void paint_cairo_layers(cairo_t *cairo, const Layer *layers, size_t count, Theme theme) {
    paint_ground(&(Painter){cairo, layers[0].layout, theme});
    paint_cairo_grid(cairo, layers[0].layout, theme);
    for (size_t i = 0; i < count; i++)
        paint_primitives(&(Painter){cairo, layers[i].layout, theme}, layers[i].scene);
    for (size_t i = 0; i < count; i++)
        paint_cairo_captions(cairo, layers[i].layout, theme);
}

void paint_cairo_scene(cairo_t *cairo, const Scene *scene, Vec2 page, Theme theme) {
    Layout layout;
    layout_make(&layout, scene, page);
    paint_cairo_layers(cairo, &(Layer){scene, &layout}, 1, theme);
    layout_clear(&layout);
}

/* A scene in its colours, for cairo_file_write. */
typedef struct Picture {
    const Scene *scene;
    Theme theme;
} Picture;

static void paint_picture(cairo_t *cairo, Vec2 page, const void *what) {
    const Picture *picture = what;
    paint_cairo_scene(cairo, picture->scene, page, picture->theme);
}

int paint_cairo_file(CairoFileKind kind, const Scene *scene, const char *path, int width, int height, Theme theme) {
    return cairo_file_write(kind, path, width, height, layout_unit(width, height), paint_picture,
                            &(Picture){scene, theme});
}
