#include "paint/drawing.h"

#include "paint/drawing_pen.h"
#include "paint/drawing_solid.h"
#include "paint/paint_sizes.h"

void drawing_clear(Drawing *drawing) {
    ink_clear(&drawing->floor);
    ink_clear(&drawing->shadows);
    ink_clear(&drawing->faces);
    ink_clear(&drawing->balls);
    ink_clear(&drawing->over);
    tessellation_clear(&drawing->tessellation);
    memory_free(drawing->line);
    *drawing = (Drawing){0};
}

void drawing_reset(Drawing *drawing) {
    Ink *const inks[] = {&drawing->floor, &drawing->shadows, &drawing->faces, &drawing->balls, &drawing->over};
    for (size_t i = 0; i < sizeof inks / sizeof *inks; i++)
        inks[i]->count = inks[i]->index_count = 0;
}

/* Flat things -------------------------------------------------------------------------------------------------------*/

/* A primitive that is being added. */
typedef struct Sheet {
    Drawing *drawing;
    const Layout *layout;
    const Primitive *primitive;
    Ink *ink;
} Sheet;

static InkPoint sheet_point(const Sheet *sheet, Vec2 at) {
    return drawing_pen_point(sheet->drawing, sheet->layout, at, sheet->primitive->base);
}

static InkColour sheet_fill(const Sheet *sheet) {
    return drawing_pen_colour(sheet->drawing, sheet->primitive->fill, sheet->primitive->fill_opacity);
}

static InkPen sheet_pen(const Sheet *sheet) {
    const Primitive *primitive = sheet->primitive;
    InkColour colour = drawing_pen_colour(sheet->drawing, primitive->edge, primitive->edge_opacity);
    InkPen pen = drawing_pen_make(sheet->drawing, colour, primitive->style, primitive->width);
    pen.begun = primitive->begun * sheet->layout->metre * sheet->drawing->unit;
    return pen;
}

/* Returns room for the points of a line. */
static InkPoint *line_room(const Sheet *sheet, size_t count) {
    Drawing *drawing = sheet->drawing;
    drawing->line = memory_reserve(drawing->line, &drawing->line_capacity, count, sizeof *drawing->line);
    return drawing->line;
}

static void stroke(const Sheet *sheet, const Vec2 *points, size_t count, bool closed) {
    if (sheet->primitive->width <= 0 || sheet->primitive->edge_opacity <= 0)
        return;
    InkPoint *line = line_room(sheet, count);
    for (size_t i = 0; i < count; i++)
        line[i] = sheet_point(sheet, points[i]);
    ink_add_line(sheet->ink, line, count, closed, sheet_pen(sheet));
}

/* True if an opaque line covers the edge of the filling, which then need not be smooth. */
static bool edge_is_hidden(const Sheet *sheet) {
    const Primitive *primitive = sheet->primitive;
    return primitive->edge_opacity >= 1 && primitive->style == LINE_SOLID &&
           primitive->width * sheet->drawing->unit >= 1.5;
}

static void cover(const Sheet *sheet, InkColour colour, const InkHatch *hatch, bool smooth) {
    const Tessellation *tessellation = &sheet->drawing->tessellation;
    for (size_t i = 0; i < tessellation->count; i++) {
        const Triangle *triangle = &tessellation->triangles[i];
        InkPoint corners[3];
        for (int k = 0; k < 3; k++)
            corners[k] = sheet_point(sheet, triangle->corners[k]);
        if (smooth || hatch)
            ink_add_triangle(sheet->ink, corners, smooth ? triangle->border : (bool[3]){0}, colour, hatch);
        else
            ink_add_face(sheet->ink, corners, 3, colour);
    }
}

/* Counts as paint_cairo.c does: from the upper left corner of the outline's box. */
static InkHatch hatch_of(const Sheet *sheet) {
    Box box = box_empty();
    for (size_t i = 0; i < sheet->primitive->count; i++)
        box = box_include(box, sheet_point(sheet, sheet->primitive->points[i]).at);
    double unit = sheet->drawing->unit;
    return (InkHatch){.width = PAINT_HATCH_WIDTH * unit, .gap = PAINT_HATCH_GAP * unit, .begin = box.low.x + box.low.y};
}

static void fill_rings(const Sheet *sheet, const Vec2 *points, const size_t *starts, size_t ring_count, bool united) {
    const Primitive *primitive = sheet->primitive;
    if (primitive->fill_opacity <= 0 && !primitive->hatched)
        return;
    tessellation_make(&sheet->drawing->tessellation, points, starts, ring_count, united);
    bool smooth = !edge_is_hidden(sheet) && !primitive->joined;
    if (primitive->fill_opacity > 0)
        cover(sheet, sheet_fill(sheet), NULL, smooth);
    if (primitive->hatched) {
        InkHatch hatch = hatch_of(sheet);
        cover(sheet, drawing_pen_colour(sheet->drawing, primitive->edge, 1), &hatch, smooth);
    }
}

static void add_polygon(const Sheet *sheet) {
    const Primitive *polygon = sheet->primitive;
    fill_rings(sheet, polygon->points, polygon->starts, polygon->ring_count, polygon->united);
    for (size_t r = 0; r < polygon->ring_count; r++)
        stroke(sheet, polygon->points + polygon->starts[r], polygon->starts[r + 1] - polygon->starts[r], true);
}

static void add_line(const Sheet *sheet) {
    const Primitive *line = sheet->primitive;
    fill_rings(sheet, line->points, (size_t[]){0, line->count}, 1, false);
    stroke(sheet, line->points, line->count, false);
}

static void add_wheel(const Sheet *sheet) {
    Vec2 corners[4];
    paint_wheel_corners(sheet->primitive, corners);
    fill_rings(sheet, corners, (size_t[]){0, 4}, 1, false);
    stroke(sheet, corners, 4, true);
}

static void add_tick(const Sheet *sheet) {
    Vec2 ends[2];
    paint_tick_ends(sheet->layout, sheet->primitive, ends);
    InkPoint line[2];
    for (int i = 0; i < 2; i++) {
        line[i] = drawing_pen_page(sheet->drawing, ends[i]);
        line[i].depth = sheet_point(sheet, sheet->primitive->points[0]).depth;
    }
    ink_add_line(sheet->ink, line, 2, false, sheet_pen(sheet));
}

static void add_head(const Sheet *sheet, Vec2 tip, Vec2 way, double depth) {
    static const bool smooth[] = {true, true, true};
    Vec2 corners[3];
    InkPoint points[3];
    paint_head_corners(tip, way, corners);
    for (int i = 0; i < 3; i++) {
        points[i] = drawing_pen_page(sheet->drawing, corners[i]);
        points[i].depth = depth;
    }
    ink_add_triangle(sheet->ink, points, smooth, drawing_pen_colour(sheet->drawing, sheet->primitive->edge, 1), NULL);
}

static void add_dimension(const Sheet *sheet) {
    const Primitive *dimension = sheet->primitive;
    Vec2 a = layout_point(sheet->layout, dimension->points[0]), b = layout_point(sheet->layout, dimension->points[1]);
    Vec2 way = vec2_unit(vec2_sub(b, a));
    bool outside = vec2_distance(a, b) < 3 * PAINT_HEAD_LENGTH;
    double shaft = outside ? PAINT_HEAD_SHAFT : 0, depth = sheet_point(sheet, dimension->points[0]).depth;
    InkPoint line[] = {drawing_pen_page(sheet->drawing, vec2_along(a, -shaft, way)),
                       drawing_pen_page(sheet->drawing, vec2_along(b, shaft, way))};
    line[0].depth = line[1].depth = depth;
    ink_add_line(sheet->ink, line, 2, false, sheet_pen(sheet));
    add_head(sheet, a, vec2_scale(way, outside ? 1 : -1), depth);
    add_head(sheet, b, vec2_scale(way, outside ? -1 : 1), depth);
}

/* Discs -------------------------------------------------------------------------------------------------------------*/

/* Adds circles as rings of corners: where they are ellipses, unite, or have dashes. */
static void add_discs_by_corners(const Sheet *sheet) {
    const Primitive *discs = sheet->primitive;
    size_t corners = drawing_pen_circle(discs->radius * sheet->layout->metre * sheet->drawing->unit);
    Vec2 *points = memory_zeroed(discs->count * corners, sizeof *points);
    size_t *starts = memory_zeroed(discs->count + 1, sizeof *starts);
    for (size_t i = 0; i < discs->count * corners; i++) {
        double turn = -2 * M_PI * (double)(i % corners) / (double)corners;
        points[i] = vec2_along(discs->points[i / corners], discs->radius, vec2_heading(turn));
        starts[i / corners + 1] = i + 1;
    }
    fill_rings(sheet, points, starts, discs->count, true);
    for (size_t i = 0; i < discs->count; i++)
        stroke(sheet, points + starts[i], corners, true);
    memory_free(points);
    memory_free(starts);
}

static void add_discs(const Sheet *sheet) {
    const Primitive *discs = sheet->primitive;
    bool unite = discs->count > 1 && discs->fill_opacity > 0 && discs->fill_opacity < 1;
    if (sheet->layout->view.raised || unite || discs->hatched || (discs->width > 0 && discs->style != LINE_SOLID)) {
        add_discs_by_corners(sheet);
        return;
    }
    double radius = discs->radius * sheet->layout->metre * sheet->drawing->unit;
    InkPen pen = sheet_pen(sheet);
    for (size_t i = 0; i < discs->count && discs->fill_opacity > 0; i++)
        ink_add_disc(sheet->ink, sheet_point(sheet, discs->points[i]), radius, sheet_fill(sheet));
    for (size_t i = 0; i < discs->count && pen.width > 0; i++)
        ink_add_ring(sheet->ink, sheet_point(sheet, discs->points[i]), radius, pen.width, pen.colour);
}

static void add_flat(Drawing *drawing, const Layout *layout, const Primitive *primitive) {
    static void (*const add[])(const Sheet *) = {
        [PRIMITIVE_POLYGON] = add_polygon,    [PRIMITIVE_LINE] = add_line,  [PRIMITIVE_DISC] = add_discs,
        [PRIMITIVE_WHEEL] = add_wheel,        [PRIMITIVE_BALL] = add_discs, [PRIMITIVE_TICK] = add_tick,
        [PRIMITIVE_DIMENSION] = add_dimension};
    bool above = layout->view.raised && primitive->base > 0;
    Sheet sheet = {drawing, layout, primitive, above ? &drawing->over : &drawing->floor};
    add[primitive->kind](&sheet);
}

static bool is_solid(const Layout *layout, const Primitive *primitive) {
    bool upright = primitive->kind == PRIMITIVE_WHEEL || primitive->kind == PRIMITIVE_BALL;
    bool rises = primitive->kind <= PRIMITIVE_DISC && primitive->height > 0;
    return layout->view.raised && (upright || rises);
}

void drawing_add(Drawing *drawing, Layer layer) {
    for (size_t i = 0; i < layer.scene->count; i++) {
        const Primitive *primitive = &layer.scene->primitives[i];
        double top = primitive->base + primitive->height;
        if (primitive->kind == PRIMITIVE_LABEL ||
            !view_sees(&layer.layout->view, primitive->points, primitive->count, top))
            continue;
        if (is_solid(layer.layout, primitive))
            drawing_solid_add(drawing, layer.layout, primitive);
        else
            add_flat(drawing, layer.layout, primitive);
    }
}
