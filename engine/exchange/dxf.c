#include "exchange/dxf.h"

#include <math.h>
#include <stdint.h>
#include <strings.h>

#include "base/real.h"
#include "exchange/block_name.h"
#include "exchange/bounding_rectangle.h"
#include "exchange/dxf_shapes.h"
#include "exchange/dxf_unit.h"
#include "exchange/wall_faces.h"

static const double THICKEST = 0.6;           /* m: a rectangle at most this wide ... */
static const double SLENDER = 2;              /* 1: ... and at least this many times longer is a piece of wall */
static const double SQUARE = 1e-4;            /* 1: largest difference of the area from that of a rectangle */
static const double PIER = 3e-3;              /* m, or 1: largest difference of a pier from its wall */
static const double PIER_GAP = 3;             /* m: largest opening next to a pier */
static const double DOOR_LEAST = 0.4;         /* m, smallest door leaf */
static const double DOOR_MOST = 2.5;          /* m */
static const double SWING_LEAST = M_PI / 4;   /* rad, range of the arc that a leaf's free end draws */
static const double SWING_MOST = 0.75 * M_PI; /* rad */
static const double QUARTER = 0.1;            /* rad: difference of such an arc from a quarter of a circle */
static const double JAMB = 0.3;               /* m: largest distance of a shut leaf's free end from the walls */
static const double AS_NEAR = 0.05;           /* m: both ends of an arc count as equally near to a wall */
static const double IN_WALL = 0.15;           /* m: largest offset of a shut leaf from the axis of its wall */

enum { LEAF_POINTS = 50000 /* lines on door layers; with more, leaves are not looked for among them */ };

typedef struct Drawing {
    HouseBuilder *builder;
    DxfFile file;
    DxfShapes shapes;
    double unit; /* m */
    WallFaces faces;
    size_t leaf_points;  /* lines on door layers */
    const char *renamed; /* the first block whose piece of furniture has another name, */
    size_t renamed_count;
} Drawing;

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

/* Finds the rectangle of a closed outline of four right corners; false if the shape is another one. */
static bool find_rectangle(const Drawing *drawing, const DxfShape *shape, Rectangle *box) {
    if (shape->role != DXF_WALLS || shape->window || !shape->closed || shape->count != 5 || shape->width > 0)
        return false;
    const Vec2 *corners = points_of(drawing, shape);
    *box = bounding_rectangle_of(corners, 4);
    double area = fabs(vec2_cross(vec2_sub(corners[2], corners[0]), vec2_sub(corners[3], corners[1]))) / 2;
    return fabs(area - box->size.x * box->size.y) < SQUARE * area && box->size.y <= THICKEST;
}

static WallLine line_through(Vec2 centre, Vec2 along, double length, double thickness) {
    return (WallLine){vec2_along(centre, -length / 2, along), vec2_along(centre, length / 2, along), thickness, 0};
}

/* Collects the slender rectangles: each is a piece of wall. */
static WallLines find_slender(const Drawing *drawing) {
    WallLines slender = {0};
    Rectangle box;
    for (size_t s = 0; s < drawing->shapes.count; s++)
        if (find_rectangle(drawing, &drawing->shapes.list[s], &box) && box.size.x >= SLENDER * box.size.y)
            wall_chains_append(&slender,
                               line_through(box.centre, vec2_heading(radians(box.angle)), box.size.x, box.size.y));
    return slender;
}

/* Appends a rectangle that is a pier between openings: in line with a slender one, as thick and near. */
static bool keep_pier(const Rectangle *box, const WallLines *slender, WallLines *lines) {
    for (size_t l = 0; l < slender->count && l < HOUSE_BUILDER_FEW; l++) {
        const WallLine *wall = &slender->list[l];
        Vec2 along = vec2_unit(vec2_sub(wall->b, wall->a)), own = vec2_heading(radians(box->angle));
        Vec2 a = vec2_unturn(vec2_sub(wall->a, box->centre), along),
             b = vec2_unturn(vec2_sub(wall->b, box->centre), along);
        bool lengthways = fabs(vec2_dot(own, along)) > 0.5;
        double length = lengthways ? box->size.x : box->size.y, thickness = lengthways ? box->size.y : box->size.x;
        double skew = fmin(fabs(vec2_cross(own, along)), fabs(vec2_dot(own, along)));
        double gap = fmax(a.x, -b.x) - length / 2;
        if (skew > PIER || fabs(a.y) > PIER || fabs(thickness - wall->thickness) > PIER || gap > PIER_GAP)
            continue;
        wall_chains_append(lines, line_through(box->centre, along, length, wall->thickness));
        return true;
    }
    return false;
}

/* If the shape is the outline of a piece of wall, adds a wall of that thickness and returns true. */
static bool keep_outline(const Drawing *drawing, const DxfShape *shape, const WallLines *slender, WallLines *lines) {
    Rectangle box;
    if (!find_rectangle(drawing, shape, &box))
        return false;
    if (box.size.x < SLENDER * box.size.y)
        return keep_pier(&box, slender, lines);
    wall_chains_append(lines, line_through(box.centre, vec2_heading(radians(box.angle)), box.size.x, box.size.y));
    return true;
}

/* Adds the walls. Window lines are walls to people inside. */
static void add_walls(Drawing *drawing) {
    const DxfShapes *shapes = &drawing->shapes;
    WallLines lines = {0}, windows = {0}, slender = find_slender(drawing);
    for (size_t s = 0; s < shapes->count; s++) {
        const DxfShape *shape = &shapes->list[s];
        const Vec2 *points = points_of(drawing, shape);
        if (shape->role != DXF_WALLS || keep_outline(drawing, shape, &slender, &lines))
            continue;
        for (size_t i = 0; i + 1 < shape->count; i++)
            wall_chains_append(shape->window ? &windows : &lines,
                               (WallLine){points[i], points[i + 1], shape->width, 0});
    }
    drawing->faces = wall_faces_join(&lines, &windows);
    drawing->faces.doubled += wall_chains_add(drawing->builder, lines.list, lines.count);
    memory_free(lines.list);
    memory_free(windows.list);
    memory_free(slender.list);
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
    const char *name = block_name_of(instance->block);
    size_t piece = house_builder_piece(drawing->builder, name, centre, vec2_sub(box.high, box.low),
                                       degrees(real_atan2(instance->x.y, instance->x.x)), 0);
    if (piece == SIZE_MAX)
        import_report_leave(drawing->builder->report, 1, "furniture blocks narrower than 1 cm");
    if (piece == SIZE_MAX || strcasecmp(name, instance->block) == 0)
        return;
    drawing->renamed = drawing->renamed_count++ ? drawing->renamed : instance->block;
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
    if (drawing->renamed_count)
        import_report_note(drawing->builder->report, "pieces of furniture are called by their kind (%zu): %s became %s",
                           drawing->renamed_count, drawing->renamed, block_name_of(drawing->renamed));
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

/* Adds a piece of wall for a door in a gap: on the axis of the wall that ends there, and as thick. */
static size_t fill_gap(HouseBuilder *builder, Vec2 hinge, Vec2 shut) {
    Vec2 gap[2] = {hinge, shut}, along = vec2_unit(vec2_sub(shut, hinge));
    double thickness = 0;
    for (int end = 0; end < 2 && thickness == 0; end++) {
        size_t wall;
        int segment;
        if (!house_builder_nearest(builder, gap[end], along, THICKEST / 2, &wall, &segment))
            continue;
        const Wall *next = &builder->plan.walls[wall];
        double aside = vec2_cross(along, vec2_sub(next->points.at[segment], gap[end]));
        if (fabs(aside) > next->thickness / 2 + AS_NEAR)
            continue;
        thickness = next->thickness;
        for (int i = 0; i < 2 && thickness > 0; i++)
            gap[i] = vec2_along(gap[i], aside, vec2_left(along));
    }
    return house_builder_wall(builder, gap, 2, thickness, 0);
}

/* Joins a leaf with the leaf of a door that it meets: a door with two leaves becomes an opening. */
static bool join_leaves(HouseBuilder *builder, const Door *leaf) {
    for (size_t d = 0; d < builder->plan.door_count; d++) {
        Door *door = &builder->plan.doors[d];
        double apart = fabs(door->at - leaf->at) - (door->width + leaf->width) / 2;
        if (door->wall_index != leaf->wall_index || door->segment != leaf->segment || door->hinge == leaf->hinge ||
            door->kind != DOOR_HINGED || fabs(apart) > AS_NEAR)
            continue;
        double low = fmin(door->at - door->width / 2, leaf->at - leaf->width / 2);
        double high = fmax(door->at + door->width / 2, leaf->at + leaf->width / 2);
        door->at = house_builder_rounded(vec2((low + high) / 2, 0)).x;
        door->width = house_builder_rounded(vec2(high - low, 0)).x;
        door->kind = DOOR_OPENING;
        import_report_leave(builder->report, 1, "further leaves of doors: such doors became openings");
        return true;
    }
    return false;
}

/* Places the door in the wall that continues there, or in a wall piece of its own that fills the gap. */
static size_t place_door(Drawing *drawing, Vec2 hinge, Vec2 shut, Vec2 open) {
    HouseBuilder *builder = drawing->builder;
    Vec2 way = vec2_sub(shut, hinge);
    Door door = {.width = vec2_length(way), .kind = DOOR_HINGED};
    double reach = fmax(IN_WALL, drawing->faces.thickest / 2 + AS_NEAR);
    if (!house_builder_nearest(builder, vec2_along(hinge, 0.5, way), vec2_unit(way), reach, &door.wall_index,
                               &door.segment)) {
        door.wall_index = fill_gap(builder, hinge, shut);
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
    return join_leaves(builder, &door) ? door.wall_index : house_builder_door(builder, &door);
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

/* Hangs an opening where both lines of a wall are interrupted and no door has been found. */
static void add_openings(Drawing *drawing) {
    HouseBuilder *builder = drawing->builder;
    size_t before = builder->plan.door_count;
    for (size_t o = 0; o < drawing->faces.opening_count && !builder->failed; o++) {
        const WallOpening *opening = &drawing->faces.openings[o];
        Vec2 middle = vec2_scale(vec2_add(opening->a, opening->b), 0.5);
        Vec2 way = vec2_unit(vec2_sub(opening->b, opening->a));
        Door door = {.width = vec2_distance(opening->a, opening->b), .kind = DOOR_OPENING};
        if (!house_builder_nearest(builder, middle, way, opening->thickness / 2, &door.wall_index, &door.segment))
            continue;
        const Vec2 *ends = builder->plan.walls[door.wall_index].points.at + door.segment;
        door.at = vec2_dot(vec2_sub(middle, ends[0]), vec2_unit(vec2_sub(ends[1], ends[0])));
        house_builder_door(builder, &door);
    }
    if (builder->plan.door_count > before)
        import_report_note(builder->report, "gaps in both lines of a wall became openings (%zu)",
                           builder->plan.door_count - before);
}

static bool has_thickness(const Plan *plan) {
    bool found = false;
    for (size_t w = 0; w < plan->wall_count && !found; w++)
        found = plan->walls[w].thickness > 0;
    return found;
}

static void note_walls(const Drawing *drawing) {
    ImportReport *report = drawing->builder->report;
    const WallFaces *faces = &drawing->faces;
    if (faces->walls)
        import_report_note(report,
                           "walls drawn as two lines became walls of %.4g m to %.4g m thickness (%zu); heights are "
                           "assumed",
                           faces->thinnest, faces->thickest, faces->walls);
    else if (has_thickness(&drawing->builder->plan))
        import_report_note(report, "walls are the lines and rectangles that are drawn; heights are assumed");
    else
        import_report_note(report, "walls are the lines that are drawn, of no thickness; heights are assumed");
    if (faces->apart > 0)
        import_report_note(
            report,
            "most lines of walls run in pairs, up to %.4g m apart, which is unusual for the two lines of "
            "a wall: each line became a wall, and the space between them is free. Use --unit if the "
            "unit is wrong",
            faces->apart);
    if (faces->too_many)
        import_report_note(report, "walls drawn as two lines were not looked for: the layers of walls have too many "
                                   "lines; choose fewer with --layers");
    if (faces->windows)
        import_report_note(report, "windows became wall (%zu)", faces->windows);
    if (faces->doubled)
        import_report_note(report, "lines of walls drawn more than once count once (%zu)", faces->doubled);
}

/* Doors among the walls ------------------------------------------------------------------------------------------- */

static bool ends_at(const Drawing *drawing, const DxfShape *line, Vec2 one, Vec2 other, double near) {
    const Vec2 *points = points_of(drawing, line);
    return line->count == 2 && ((vec2_distance(points[0], one) < near && vec2_distance(points[1], other) < near) ||
                                (vec2_distance(points[1], one) < near && vec2_distance(points[0], other) < near));
}

/* Moves a quarter of a circle and the leaf that ends at it from the walls to the doors. */
static bool move_door(Drawing *drawing, DxfShape *arc) {
    DxfShapes *shapes = &drawing->shapes;
    const Vec2 *ends = points_of(drawing, arc);
    double near = 0.02 * vec2_distance(ends[0], arc->centre);
    bool found = false;
    for (size_t s = 0; s < shapes->count; s++) {
        DxfShape *line = &shapes->list[s];
        if (line->role != DXF_WALLS || line->arc || line->window ||
            (!ends_at(drawing, line, arc->centre, ends[0], near) &&
             !ends_at(drawing, line, arc->centre, ends[arc->count - 1], near)))
            continue;
        line->role = DXF_DOORS;
        found = true;
    }
    arc->role = found ? DXF_DOORS : arc->role;
    return found;
}

/* Finds doors in a drawing without layers of doors: quarters of circles with a leaf from the centre to one end. */
static void find_doors(Drawing *drawing) {
    DxfShapes *shapes = &drawing->shapes;
    size_t arcs = 0, moved = 0;
    for (size_t s = 0; s < shapes->count; s++) {
        if (shapes->list[s].role == DXF_DOORS)
            return;
        arcs += shapes->list[s].arc;
    }
    for (size_t s = 0; s < shapes->count && arcs <= HOUSE_BUILDER_FEW && shapes->count <= LEAF_POINTS; s++) {
        DxfShape *shape = &shapes->list[s];
        if (shape->role == DXF_WALLS && shape->arc && !shape->window && fabs(shape->sweep - M_PI / 2) < QUARTER)
            moved += move_door(drawing, shape);
    }
    if (moved)
        import_report_note(drawing->builder->report,
                           "quarters of circles with a leaf, on layers of walls, became doors (%zu)", moved);
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
    find_doors(drawing);
    if (!dxf_unit_choose(&drawing->file, &drawing->shapes, builder, &drawing->unit))
        return false;
    scale_all(drawing);
    if (!are_good(drawing))
        return false;
    add_walls(drawing);
    if (!builder->failed && !builder->plan.wall_count)
        return house_builder_fail(builder, "no layer has walls: name their layer with --layers walls=NAME");
    add_doors(drawing);
    add_openings(drawing);
    add_furniture(drawing);
    add_exits(drawing);
    note_walls(drawing);
    return !builder->failed;
}

bool dxf_read(HouseBuilder *builder) {
    Drawing drawing = {.builder = builder};
    bool good = dxf_file_read(&drawing.file, builder) && convert(&drawing);
    wall_faces_clear(&drawing.faces);
    dxf_shapes_clear(&drawing.shapes);
    dxf_file_clear(&drawing.file);
    return good;
}
