#include "paint/drawing_solid.h"

#include <math.h>

#include "paint/drawing_pen.h"
#include "paint/paint_sizes.h"

/* The direction of the light, along the floor from the left and from the viewer; the rest of the unit vector, 0.79, is
 * up. */
#define LIGHT_LEFT 0.50
#define LIGHT_NEAR 0.36

const float drawing_solid_light[3] = {-0.50f, -0.08f, 0.86f}; /* seen at the usual elevation, 60 degrees */

#define DARK 0.05         /* relative luminance: darker sides are lightened */
#define DARK_LEAST 0.18   /* the share without light */
#define DARK_GAIN 0.42    /* the gain up to full light */
#define BRIGHT_LEAST 0.52 /* the share that brighter colours keep without light */
#define BRIGHT_GAIN 0.40

#define SHADOW_OPACITY 0.13
#define SHADOW_LENGTH 0.35 /* m per metre of height: long ones would darken rooms */
#define EDGE_WIDTH 1.0     /* design points, of edges without a width of their own */
#define EDGE_SHADE 0.62    /* share of the face's colour, for such edges */
#define EDGE_NEARER 1e-3   /* of the depth: makes lines visible on the faces that they bound */
#define SHARP 0.5          /* rad: rounder corners have no edge */

typedef struct Solid {
    Drawing *drawing;
    const Layout *layout;
    const Primitive *primitive;
    Vec2 ahead, right; /* on the floor, unit, relative to the camera */
} Solid;

static InkPoint solid_point(const Solid *solid, Vec2 at, double height) {
    return drawing_pen_point(solid->drawing, solid->layout, at, height);
}

static double solid_top(const Solid *solid) {
    return solid->primitive->base + solid->primitive->height;
}

/* Light -------------------------------------------------------------------------------------------------------------*/

static Colour mixed(Colour from, Colour to, double part) {
    return (Colour){from.red + part * (to.red - from.red), from.green + part * (to.green - from.green),
                    from.blue + part * (to.blue - from.blue)};
}

/* Returns the colour of a face that receives this share of the light, 0 to 1. */
static Colour lit(Colour colour, double light) {
    const Colour black = {0, 0, 0}, white = {1, 1, 1};
    if (palette_contrast(colour, black) < (DARK + 0.05) / 0.05)
        return mixed(colour, white, DARK_LEAST + DARK_GAIN * light);
    return mixed(black, colour, BRIGHT_LEAST + BRIGHT_GAIN * light);
}

/* Returns the light on an upright face with that unit normal. */
static double side_light(const Solid *solid, Vec2 normal) {
    return fmax(0, -LIGHT_LEFT * vec2_dot(normal, solid->right) - LIGHT_NEAR * vec2_dot(normal, solid->ahead)) /
           hypot(LIGHT_LEFT, LIGHT_NEAR);
}

static Colour fill_colour(const Solid *solid) {
    return palette_colour(solid->drawing->theme, solid->primitive->fill);
}

static InkColour side_colour(const Solid *solid, Colour colour, Vec2 normal) {
    return (InkColour){lit(colour, side_light(solid, normal)), solid->primitive->fill_opacity};
}

static InkPen edge_pen(const Solid *solid) {
    const Primitive *primitive = solid->primitive;
    if (primitive->width > 0)
        return drawing_pen_make(solid->drawing,
                                drawing_pen_colour(solid->drawing, primitive->edge, primitive->edge_opacity),
                                primitive->style, primitive->width);
    InkColour thin = {mixed((Colour){0, 0, 0}, fill_colour(solid), EDGE_SHADE), primitive->fill_opacity};
    return drawing_pen_make(solid->drawing, thin, LINE_SOLID, EDGE_WIDTH);
}

static InkPen thin_pen(const Solid *solid) {
    InkPen pen = edge_pen(solid);
    pen.width = fmin(pen.width, EDGE_WIDTH * solid->drawing->unit);
    return pen;
}

/* Returns where the shadow of a point at that height falls. */
static InkPoint shadow_point(const Solid *solid, Vec2 at, double height) {
    double length = SHADOW_LENGTH * height / hypot(LIGHT_LEFT, LIGHT_NEAR);
    return solid_point(
        solid, vec2_along(vec2_along(at, LIGHT_LEFT * length, solid->right), LIGHT_NEAR * length, solid->ahead), 0);
}

static InkColour shadow_colour(const Solid *solid) {
    return (InkColour){{0, 0, 0}, SHADOW_OPACITY * solid->primitive->fill_opacity};
}

/* Faces and edges ---------------------------------------------------------------------------------------------------*/

/* True if a face with these corners, in order as seen from outside, shows its outside. */
static bool faces_viewer(const InkPoint corners[3]) {
    return vec2_cross(vec2_sub(corners[1].at, corners[0].at), vec2_sub(corners[2].at, corners[0].at)) < 0;
}

static void add_edge(const Solid *solid, const InkPoint *points, size_t count, bool closed, InkPen pen) {
    Drawing *drawing = solid->drawing;
    InkPoint *line = drawing->line =
        memory_reserve(drawing->line, &drawing->line_capacity, count, sizeof *drawing->line);
    for (size_t i = 0; i < count; i++)
        line[i] = (InkPoint){points[i].at, points[i].depth - EDGE_NEARER};
    ink_add_line(&drawing->over, line, count, closed, pen);
}

/* Adds an upright face over a -> b, its outside to the right. */
static void add_side(const Solid *solid, Vec2 a, Vec2 b, double base, double top, bool both) {
    InkPoint corners[] = {solid_point(solid, a, base), solid_point(solid, b, base), solid_point(solid, b, top),
                          solid_point(solid, a, top)};
    bool outside = faces_viewer(corners);
    if (!outside && !both)
        return;
    Vec2 normal = vec2_scale(vec2_left(vec2_unit(vec2_sub(b, a))), outside ? -1 : 1);
    ink_add_face(&solid->drawing->faces, corners, 4, side_colour(solid, fill_colour(solid), normal));
}

static void add_side_shadow(const Solid *solid, Vec2 a, Vec2 b, double base, double top) {
    InkPoint corners[] = {shadow_point(solid, a, base), shadow_point(solid, b, base), shadow_point(solid, b, top),
                          shadow_point(solid, a, top)};
    ink_add_face(&solid->drawing->shadows, corners, 4, shadow_colour(solid));
}

/* Prisms ------------------------------------------------------------------------------------------------------------*/

static void add_level(const Solid *solid, const Triangle *triangle, double height) {
    InkPoint corners[3], shadow[3];
    for (int i = 0; i < 3; i++) {
        corners[i] = solid_point(solid, triangle->corners[i], height);
        shadow[i] = shadow_point(solid, triangle->corners[i], height);
    }
    InkColour colour = {fill_colour(solid), solid->primitive->fill_opacity};
    ink_add_face(&solid->drawing->faces, corners, 3, colour);
    ink_add_face(&solid->drawing->shadows, shadow, 3, shadow_colour(solid));
}

static void add_hatch(const Solid *solid, const Triangle *triangle, double height) {
    const Primitive *primitive = solid->primitive;
    double unit = solid->drawing->unit;
    Vec2 begin = solid_point(solid, primitive->points[0], height).at;
    InkHatch hatch = {PAINT_HATCH_WIDTH * unit, PAINT_HATCH_GAP * unit, begin.x + begin.y};
    InkPoint corners[3];
    for (int i = 0; i < 3; i++) {
        corners[i] = solid_point(solid, triangle->corners[i], height);
        corners[i].depth -= EDGE_NEARER;
    }
    ink_add_triangle(&solid->drawing->over, corners, (bool[3]){0},
                     drawing_pen_colour(solid->drawing, primitive->edge, 1), &hatch);
}

/* Adds the upright edges at a ring's sharp corners. */
static void add_upright_edges(const Solid *solid, const Vec2 *ring, size_t count) {
    InkPen pen = thin_pen(solid);
    for (size_t i = 0; i < count; i++) {
        Vec2 in = vec2_sub(ring[i], ring[(i + count - 1) % count]), out = vec2_sub(ring[(i + 1) % count], ring[i]);
        if (fabs(atan2(vec2_cross(in, out), vec2_dot(in, out))) < SHARP)
            continue;
        InkPoint ends[] = {solid_point(solid, ring[i], solid->primitive->base),
                           solid_point(solid, ring[i], solid_top(solid))};
        add_edge(solid, ends, 2, false, pen);
    }
}

static void add_ring_edges(const Solid *solid, const Vec2 *ring, size_t count) {
    InkPoint *points = memory_zeroed(count, sizeof *points);
    for (size_t i = 0; i < count; i++)
        points[i] = solid_point(solid, ring[i], solid_top(solid));
    add_edge(solid, points, count, true, edge_pen(solid));
    add_upright_edges(solid, ring, count);
    memory_free(points);
}

static void add_prism_of(const Solid *solid, const Vec2 *points, const size_t *starts, size_t ring_count, bool united) {
    const Tessellation *tessellation = &solid->drawing->tessellation;
    double base = solid->primitive->base, top = solid_top(solid);
    tessellation_make(&solid->drawing->tessellation, points, starts, ring_count, united);
    for (size_t i = 0; i < tessellation->count; i++) {
        const Triangle *triangle = &tessellation->triangles[i];
        add_level(solid, triangle, top);
        if (solid->primitive->hatched)
            add_hatch(solid, triangle, top);
        for (int k = 0; k < 3; k++) {
            Vec2 a = triangle->corners[k], b = triangle->corners[(k + 1) % 3];
            if (!triangle->border[k])
                continue;
            add_side(solid, a, b, base, top, false);
            add_side_shadow(solid, a, b, base, top);
            if (united)
                add_edge(solid, (InkPoint[]){solid_point(solid, a, top), solid_point(solid, b, top)}, 2, false,
                         edge_pen(solid));
        }
    }
    for (size_t r = 0; r < ring_count && !united; r++)
        add_ring_edges(solid, points + starts[r], starts[r + 1] - starts[r]);
}

static void add_prism(const Solid *solid) {
    const Primitive *prism = solid->primitive;
    add_prism_of(solid, prism->points, prism->starts, prism->ring_count, prism->united);
}

/* Sheets ------------------------------------------------------------------------------------------------------------*/

static void add_sheet(const Solid *solid) {
    const Primitive *line = solid->primitive;
    Solid faces = *solid;
    Primitive filled = *line;
    filled.fill = line->edge;
    filled.fill_opacity = line->edge_opacity;
    faces.primitive = &filled;
    InkPoint *points = memory_zeroed(line->count, sizeof *points);
    for (size_t i = 0; i < line->count; i++) {
        points[i] = solid_point(solid, line->points[i], solid_top(solid));
        if (i + 1 == line->count)
            break;
        add_side(&faces, line->points[i], line->points[i + 1], line->base, solid_top(solid), true);
        add_side_shadow(&faces, line->points[i], line->points[i + 1], line->base, solid_top(solid));
    }
    add_edge(solid, points, line->count, false, edge_pen(solid));
    memory_free(points);
}

/* Round things ------------------------------------------------------------------------------------------------------*/

static double page_length(const Solid *solid, Vec2 at, double height, double metres) {
    return metres * view_scale(&solid->layout->view, at, height) * solid->drawing->unit;
}

/* Adds the shadow of a round upright primitive: as wide as the primitive, as long as it is high. */
static void add_round_shadow(const Solid *solid, Vec2 at) {
    InkPoint line[] = {shadow_point(solid, at, solid->primitive->base), shadow_point(solid, at, solid_top(solid))};
    double width = 2 * page_length(solid, at, 0, solid->primitive->radius);
    InkPen pen = {.colour = shadow_colour(solid), .width = width};
    ink_add_capsule(&solid->drawing->shadows, line, pen);
}

static size_t round_corners(const Solid *solid, Vec2 at) {
    return drawing_pen_circle(page_length(solid, at, 0, solid->primitive->radius));
}

static void add_cylinder(const Solid *solid, Vec2 at) {
    const Primitive *primitive = solid->primitive;
    size_t count = round_corners(solid, at);
    InkPoint rim[DRAWING_PEN_CORNERS];
    Vec2 last = vec2_along(at, primitive->radius, vec2(1, 0));
    for (size_t i = 0; i < count; i++) {
        Vec2 next = vec2_along(at, primitive->radius, vec2_heading(2 * M_PI * (double)(i + 1) / (double)count));
        rim[i] = solid_point(solid, last, solid_top(solid));
        add_side(solid, last, next, primitive->base, solid_top(solid), false);
        last = next;
    }
    ink_add_face(&solid->drawing->faces, rim, count, (InkColour){fill_colour(solid), primitive->fill_opacity});
    add_edge(solid, rim, count, true, edge_pen(solid));
    add_round_shadow(solid, at);
}

static void add_cylinders(const Solid *solid) {
    for (size_t i = 0; i < solid->primitive->count; i++)
        add_cylinder(solid, solid->primitive->points[i]);
}

/* Adds heads without shadows: these would lie in the shadows of the bodies. */
static void add_balls(const Solid *solid) {
    const Primitive *balls = solid->primitive;
    Colour bright = mixed(fill_colour(solid), (Colour){1, 1, 1}, 0.15), dark = lit(fill_colour(solid), 0);
    for (size_t i = 0; i < balls->count; i++) {
        double radius = page_length(solid, balls->points[i], balls->base, balls->radius);
        ink_add_ball(&solid->drawing->balls, solid_point(solid, balls->points[i], balls->base), radius, bright, dark);
    }
}

/* Lists the corners of one side of the wheel, counter-clockwise as seen from the end of the axle. */
static void wheel_side(const Solid *solid, Vec2 centre, Vec2 along, InkPoint *rim, size_t count) {
    const Primitive *wheel = solid->primitive;
    for (size_t i = 0; i < count; i++) {
        double turn = 2 * M_PI * (double)i / (double)count;
        rim[i] = solid_point(solid, vec2_along(centre, wheel->radius * cos(turn), along),
                             wheel->base + wheel->radius * sin(turn));
    }
}

/* Adds the tread between the rims, darker than the sides. */
static void add_tread(const Solid *solid, const InkPoint *left, const InkPoint *right, size_t count) {
    InkColour colour = {lit(fill_colour(solid), 0.5), 1};
    for (size_t i = 0; i < count; i++) {
        size_t next = (i + 1) % count;
        InkPoint corners[] = {left[i], left[next], right[next], right[i]};
        ink_add_face(&solid->drawing->faces, corners, 4, colour);
    }
}

static void add_wheel(const Solid *solid) {
    const Primitive *wheel = solid->primitive;
    Vec2 axle = vec2_unit(vec2_sub(wheel->points[1], wheel->points[0])), along = vec2_left(axle);
    size_t count = round_corners(solid, wheel->points[0]);
    InkPoint rims[2][DRAWING_PEN_CORNERS];
    for (int side = 0; side < 2; side++)
        wheel_side(solid, wheel->points[side], along, rims[side], count);
    add_tread(solid, rims[0], rims[1], count);
    bool second = faces_viewer((InkPoint[]){rims[0][0], rims[0][count / 3], rims[0][2 * count / 3]});
    const InkPoint *shown = rims[second];
    InkColour colour = side_colour(solid, fill_colour(solid), vec2_scale(axle, second ? 1 : -1));
    colour.opacity = 1;
    ink_add_face(&solid->drawing->faces, shown, count, colour);
    add_edge(solid, shown, count, true, edge_pen(solid));
}

void drawing_solid_add(Drawing *drawing, const Layout *layout, const Primitive *primitive) {
    static void (*const add[])(const Solid *) = {[PRIMITIVE_POLYGON] = add_prism,
                                                 [PRIMITIVE_LINE] = add_sheet,
                                                 [PRIMITIVE_DISC] = add_cylinders,
                                                 [PRIMITIVE_WHEEL] = add_wheel,
                                                 [PRIMITIVE_BALL] = add_balls};
    Vec2 ahead = vec2_unit(vec2(layout->view.rows[3][0], layout->view.rows[3][1]));
    if (vec2_dot(ahead, ahead) == 0)
        ahead = vec2(0, 1); /* straight from above */
    Solid solid = {drawing, layout, primitive, ahead, vec2_scale(vec2_left(ahead), -1)};
    add[primitive->kind](&solid);
}
