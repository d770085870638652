#include "exchange/dxf.h"

#include <math.h>
#include <stdint.h>

#include "base/real.h"
#include "exchange/dxf_shapes.h"
#include "exchange/bounding_rectangle.h"
#include "exchange/wall_chains.h"

static const double LEAST = 3, MOST = 200;    /* m: range of the longer side of a house */
static const double USUAL = 12;               /* m: typical longer side of a house */
static const double THICKEST = 0.6;           /* m: a rectangle at most this wide ... */
static const double SLENDER = 2;              /* 1: ... and at least this many times longer is a piece of wall */
static const double DOOR_LEAST = 0.4;         /* m, smallest door leaf */
static const double DOOR_MOST = 2.5;          /* m */
static const double SWING_LEAST = M_PI / 4;   /* rad, range of the arc that a leaf's free end draws */
static const double SWING_MOST = 0.75 * M_PI; /* rad */
static const double JAMB = 0.3;               /* m: largest distance of a shut leaf's free end from the walls */
static const double AS_NEAR = 0.05;           /* m: both ends of an arc count as equally near to a wall */
static const double IN_WALL = 0.15;           /* m: largest offset of a shut leaf from the axis of its wall */

enum { LEAF_POINTS = 50000 /* lines on door layers; with more, leaves are not looked for among them */ };

typedef struct Drawing {
    HouseBuilder *builder;
    DxfFile file;
    DxfShapes shapes;
    double unit;        /* m */
    size_t leaf_points; /* lines on door layers */
} Drawing;

/* The unit -------------------------------------------------------------------------------------------------------- */

typedef struct Unit {
    int code; /* $INSUNITS */
    const char *name;
    double metres;
} Unit;

static const Unit units[] = {
    {4, "mm", 0.001},  {5, "cm", 0.01}, {6, "m", 1},        {1, "inch", 0.0254},
    {2, "ft", 0.3048}, {14, "dm", 0.1}, {10, "yd", 0.9144}, {7, "km", 1000},
};
enum {
    UNITS = sizeof units / sizeof *units,
    LIKELY = 5 /* the first of them: units that plans are usually drawn in */
};

static const Unit *said_unit(const DxfFile *file) {
    for (size_t u = 0; u < UNITS; u++)
        if (units[u].code == file->unit)
            return &units[u];
    return NULL;
}

/* Returns the extent of the walls, in the drawing's unit. */
static Vec2 size_of(const DxfShapes *shapes) {
    Box box = box_empty();
    for (size_t s = 0; s < shapes->count; s++)
        for (size_t i = 0; i < shapes->list[s].count && shapes->list[s].role == DXF_WALLS; i++)
            box = box_include(box, shapes->points[shapes->list[s].point + i]);
    return vec2_sub(box.high, box.low);
}

static bool is_plausible(double longer) {
    return longer >= LEAST && longer <= MOST;
}

/* Returns the most common unit that gives a plausible house size, or NULL. */
static const Unit *likely_unit(double longer) {
    const Unit *best = NULL;
    for (size_t u = 0; u < LIKELY; u++)
        if (is_plausible(longer * units[u].metres) &&
            (!best || fabs(real_log(longer * units[u].metres / USUAL)) < fabs(real_log(longer * best->metres / USUAL))))
            best = &units[u];
    return best;
}

/* Chooses the unit: from the options, else from the file unless the size would be implausible for a house, else by
 * size. */
static void choose_unit(Drawing *drawing) {
    ImportReport *report = drawing->builder->report;
    Vec2 size = size_of(&drawing->shapes);
    double longer = fmax(size.x, size.y);
    const Unit *said = said_unit(&drawing->file), *likely = likely_unit(longer);
    drawing->unit = drawing->builder->options->unit;
    if (drawing->unit > 0 || !(longer > 0))
        return;
    if (said && (!likely || is_plausible(longer * said->metres))) {
        drawing->unit = said->metres;
        import_report_note(report, "the unit is %s, as the file says: the plan is %.4g m by %.4g m", said->name,
                           size.x * drawing->unit, size.y * drawing->unit);
        return;
    }
    likely = likely ? likely : &units[0];
    drawing->unit = likely->metres;
    if (said)
        import_report_note(report,
                           "the file says that its unit is %s, which would make the plan %.4g m by %.4g m: %s is "
                           "assumed, %.4g m by %.4g m; clearance import --unit overrides",
                           said->name, size.x * said->metres, size.y * said->metres, likely->name,
                           size.x * drawing->unit, size.y * drawing->unit);
    else
        import_report_note(
            report,
            "the file does not say its unit: %s is assumed, the plan is %.4g m by %.4g m; clearance import "
            "--unit overrides",
            likely->name, size.x * drawing->unit, size.y * drawing->unit);
}

static void scale_all(Drawing *drawing) {
    DxfShapes *shapes = &drawing->shapes;
    for (size_t i = 0; i < shapes->point_count; i++)
        shapes->points[i] = vec2_scale(shapes->points[i], drawing->unit);
    for (size_t s = 0; s < shapes->count; s++) {
        shapes->list[s].centre = vec2_scale(shapes->list[s].centre, drawing->unit);
        shapes->list[s].width *= drawing->unit;
    }
}

/* Walls and exits ------------------------------------------------------------------------------------------------- */

static const Vec2 *points_of(const Drawing *drawing, const DxfShape *shape) {
    return drawing->shapes.points + shape->point;
}

/* If the shape is the outline of a piece of wall (a slender rectangle), adds a wall of that thickness and returns
 * true. */
static bool keep_slender(const Drawing *drawing, const DxfShape *shape, WallLines *lines) {
    if (!shape->closed || shape->count != 5 || shape->width > 0)
        return false;
    const Vec2 *corners = points_of(drawing, shape);
    Rectangle box = bounding_rectangle_of(corners, 4);
    double area = fabs(vec2_cross(vec2_sub(corners[2], corners[0]), vec2_sub(corners[3], corners[1]))) / 2;
    bool is_rectangle = fabs(area - box.size.x * box.size.y) < 1e-6 * area;
    if (!is_rectangle || box.size.y > THICKEST || box.size.x < SLENDER * box.size.y)
        return false;
    Vec2 half = vec2_scale(vec2_heading(radians(box.angle)), box.size.x / 2);
    wall_chains_append(lines, (WallLine){vec2_sub(box.centre, half), vec2_add(box.centre, half), box.size.y, 0});
    return true;
}

static void add_walls(Drawing *drawing) {
    const DxfShapes *shapes = &drawing->shapes;
    WallLines lines = {0};
    for (size_t s = 0; s < shapes->count; s++) {
        const DxfShape *shape = &shapes->list[s];
        const Vec2 *points = points_of(drawing, shape);
        if (shape->role != DXF_WALLS || keep_slender(drawing, shape, &lines))
            continue;
        for (size_t i = 0; i + 1 < shape->count; i++)
            wall_chains_append(&lines, (WallLine){points[i], points[i + 1], shape->width, 0});
    }
    wall_chains_add(drawing->builder, lines.list, lines.count);
    memory_free(lines.list);
}

/* Adds exits: a line, or the centre line of an outline along its longer side. */
static void add_exits(Drawing *drawing) {
    const DxfShapes *shapes = &drawing->shapes;
    for (size_t s = 0; s < shapes->count; s++) {
        const DxfShape *shape = &shapes->list[s];
        if (shape->role != DXF_EXITS || shape->count < 2)
            continue;
        const Vec2 *points = points_of(drawing, shape);
        if (shape->count == 2) {
            house_builder_exit(drawing->builder, points[0], points[1]);
            continue;
        }
        Rectangle box = bounding_rectangle_of(points, shape->count);
        Vec2 half = vec2_scale(vec2_heading(radians(box.angle)), box.size.x / 2);
        house_builder_exit(drawing->builder, vec2_sub(box.centre, half), vec2_add(box.centre, half));
    }
}

/* Furniture ------------------------------------------------------------------------------------------------------- */

/* Turns the bounding box of a block's lines, along the block's own axes, into a piece of furniture. The shapes of
 * one instance are consecutive. */
static void add_instance(Drawing *drawing, size_t first, size_t end) {
    const DxfShapes *shapes = &drawing->shapes;
    const DxfInstance *instance = &shapes->instances[shapes->list[first].instance];
    Box box = box_empty();
    for (size_t s = first; s < end; s++)
        for (size_t i = 0; i < shapes->list[s].count; i++)
            box = box_include(box, vec2_unturn(points_of(drawing, &shapes->list[s])[i], instance->x));
    Vec2 centre = vec2_turn(vec2_scale(vec2_add(box.low, box.high), 0.5), instance->x);
    size_t piece = house_builder_piece(drawing->builder, instance->block, centre, vec2_sub(box.high, box.low),
                                       degrees(real_atan2(instance->x.y, instance->x.x)), 0);
    if (piece == SIZE_MAX)
        import_report_leave(drawing->builder->report, 1, "furniture blocks narrower than 1 cm");
}

static void add_furniture(Drawing *drawing) {
    const DxfShapes *shapes = &drawing->shapes;
    for (size_t s = 0, end; s < shapes->count && !drawing->builder->failed; s = end) {
        const DxfShape *shape = &shapes->list[s];
        for (end = s + 1;
             end < shapes->count && shape->instance != SIZE_MAX && shapes->list[end].instance == shape->instance;)
            end++;
        drawing->builder->line = shape->line;
        if (shape->role != DXF_FURNITURE)
            continue;
        if (shape->instance != SIZE_MAX)
            add_instance(drawing, s, end);
        else if (!shape->closed)
            import_report_leave(drawing->builder->report, 1, "open lines on furniture layers");
        else if (house_builder_piece_around(drawing->builder, "furniture", points_of(drawing, shape), shape->count,
                                            0) == SIZE_MAX)
            import_report_leave(drawing->builder->report, 1, "furniture outlines narrower than 1 cm");
    }
}

/* Doors ----------------------------------------------------------------------------------------------------------- */

static double distance_to_walls(const Drawing *drawing, Vec2 at) {
    size_t wall;
    int segment;
    if (!house_builder_nearest(drawing->builder, at, vec2(0, 0), JAMB, &wall, &segment))
        return HUGE_VAL;
    const Vec2 *ends = drawing->builder->plan.walls[wall].points.at + segment;
    return vec2_distance(at, vec2_nearest_on_segment(at, ends[0], ends[1]));
}

/* True if a line of a door (an open leaf) joins the two points. */
static bool is_leaf(const Drawing *drawing, Vec2 hinge, Vec2 end) {
    const DxfShapes *shapes = &drawing->shapes;
    double near = 0.1 * vec2_distance(hinge, end);
    for (size_t s = 0; s < shapes->count && drawing->leaf_points < LEAF_POINTS; s++) {
        const DxfShape *shape = &shapes->list[s];
        const Vec2 *points = points_of(drawing, shape);
        for (size_t i = 0; i + 1 < shape->count && shape->role == DXF_DOORS && !shape->arc; i++) {
            bool there = vec2_distance(points[i], hinge) < near && vec2_distance(points[i + 1], end) < near;
            bool back = vec2_distance(points[i + 1], hinge) < near && vec2_distance(points[i], end) < near;
            if (there || back)
                return true;
        }
    }
    return false;
}

/* Finds the leaf's free end in the shut position: the end of the arc that lies at a wall or, if both do, the end to
 * which no leaf is drawn. False: neither end lies at a wall. */
static bool shut_end(const Drawing *drawing, Vec2 hinge, Vec2 one, Vec2 other, bool *first) {
    double d = distance_to_walls(drawing, one), e = distance_to_walls(drawing, other);
    if (d == HUGE_VAL && e == HUGE_VAL)
        return false;
    *first = d < e;
    if (fabs(d - e) < AS_NEAR && is_leaf(drawing, hinge, *first ? one : other))
        *first = !*first;
    return true;
}

/* Places the door in the wall that continues there, or in a wall piece of its own that fills the gap. */
static size_t place_door(Drawing *drawing, Vec2 hinge, Vec2 shut, Vec2 open) {
    HouseBuilder *builder = drawing->builder;
    Vec2 way = vec2_sub(shut, hinge);
    Door door = {.width = vec2_length(way), .kind = DOOR_HINGED};
    if (!house_builder_nearest(builder, vec2_along(hinge, 0.5, way), vec2_unit(way), IN_WALL, &door.wall_index,
                               &door.segment)) {
        Vec2 gap[2] = {hinge, shut};
        door.wall_index = house_builder_wall(builder, gap, 2, 0, 0);
        if (door.wall_index == SIZE_MAX)
            return SIZE_MAX;
        door.segment = 0;
    }
    const Vec2 *ends = builder->plan.walls[door.wall_index].points.at + door.segment;
    Vec2 along = vec2_unit(vec2_sub(ends[1], ends[0]));
    double from = vec2_dot(vec2_sub(hinge, ends[0]), along), to = vec2_dot(vec2_sub(shut, ends[0]), along);
    door.at = (from + to) / 2;
    door.hinge = from < to ? HINGE_START : HINGE_END;
    door.swing = vec2_cross(along, vec2_sub(open, hinge)) > 0 ? SWING_LEFT : SWING_RIGHT;
    return house_builder_door(builder, &door);
}

static void add_door(Drawing *drawing, const DxfShape *shape) {
    const Vec2 *points = points_of(drawing, shape);
    Vec2 one = points[0], other = points[shape->count - 1];
    double radius = vec2_distance(one, shape->centre);
    ImportReport *report = drawing->builder->report;
    bool first;
    if (radius < DOOR_LEAST || radius > DOOR_MOST || shape->sweep < SWING_LEAST || shape->sweep > SWING_MOST)
        import_report_leave(report, 1, "arcs on door layers that are not door swings");
    else if (!shut_end(drawing, shape->centre, one, other, &first))
        import_report_leave(report, 1, "doors that are not at a wall");
    else if (place_door(drawing, shape->centre, first ? one : other, first ? other : one) == SIZE_MAX)
        import_report_leave(report, 1, "doors that do not fit into their wall");
}

static void add_doors(Drawing *drawing) {
    const DxfShapes *shapes = &drawing->shapes;
    size_t arcs = 0, lines = 0;
    for (size_t s = 0; s < shapes->count; s++) {
        bool line = shapes->list[s].role == DXF_DOORS && !shapes->list[s].arc;
        lines += line;
        drawing->leaf_points += line ? shapes->list[s].count : 0;
    }
    for (size_t s = 0; s < shapes->count && !drawing->builder->failed; s++) {
        const DxfShape *shape = &shapes->list[s];
        drawing->builder->line = shape->line;
        if (shape->role != DXF_DOORS)
            continue;
        arcs += shape->arc;
        if (arcs > HOUSE_BUILDER_FEW)
            house_builder_fail(drawing->builder, "more than %d arcs on door layers, must be fewer", HOUSE_BUILDER_FEW);
        else if (shape->arc)
            add_door(drawing, shape);
    }
    if (lines && !drawing->builder->plan.door_count)
        import_report_leave(drawing->builder->report, lines, "lines on door layers without a swing arc");
}

/* The whole ------------------------------------------------------------------------------------------------------- */

static bool are_good(const Drawing *drawing) {
    for (size_t i = 0; i < drawing->shapes.point_count; i++)
        if (!house_builder_good(drawing->builder, drawing->shapes.points[i]))
            return false;
    return true;
}

static bool convert(Drawing *drawing) {
    HouseBuilder *builder = drawing->builder;
    if (!dxf_layers_choose(&drawing->file, builder) || !dxf_shapes_find(&drawing->shapes, &drawing->file, builder))
        return false;
    choose_unit(drawing);
    scale_all(drawing);
    if (!are_good(drawing))
        return false;
    add_walls(drawing);
    if (!builder->failed && !builder->plan.wall_count)
        return house_builder_fail(builder, "no layer has walls: name their layer with --layers walls=NAME");
    add_doors(drawing);
    add_furniture(drawing);
    add_exits(drawing);
    import_report_note(builder->report, "walls are the lines that are drawn: those drawn double stay so, of no "
                                        "thickness; heights are assumed");
    return !builder->failed;
}

bool dxf_read(HouseBuilder *builder) {
    Drawing drawing = {.builder = builder};
    bool good = dxf_file_read(&drawing.file, builder) && convert(&drawing);
    dxf_shapes_clear(&drawing.shapes);
    dxf_file_clear(&drawing.file);
    return good;
}
