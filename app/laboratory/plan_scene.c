#include "laboratory/plan_scene.h"

#include <string.h>

/* Design points. */
#define WALL_EDGE 1.5 /* keeps thin walls of large plans visible */
#define THIN_WALL 3.0 /* walls without thickness */
#define FURNITURE_EDGE 2.0
#define LEAF 4.0
#define SWING 1.5
#define EXIT_BAND 10.0
#define EXIT_RIM 14.0
#define CROSS_EDGE 3.0
#define TAG_LETTERS 17.0
#define NAME_LETTERS 17.0
#define ROOM_LETTERS 18.0
#define DOOR_LETTERS 15.0

/* How much labels avoid them. */
#define KEEP_WALL 1.0
#define KEEP_FURNITURE 0.4
#define KEEP_DOOR 1.0
#define KEEP_EXIT 3.0

#define CROSS_HALF 0.11 /* m, of the x on a locked door: within a wall's depth of the opening */

enum {
    ARC_PIECES = 16, /* of a quarter circle */
    RASTER = 24,     /* points each way that are tried for a room's middle */
};

static void add_walls(Scene *scene, const House *house) {
    const Outline *outline = &house->outline;
    if (outline->ring_count) {
        Primitive *solids =
            scene_add_rings(scene, ROLE_WALL, outline->ring_points, outline->ring_starts, outline->ring_count);
        solids->width = WALL_EDGE;
        solids->keep_clear = KEEP_WALL;
    }
    for (size_t i = 0; i < outline->face_count; i++) {
        const Face *face = &outline->faces[i];
        if (face->owner != OWNER_WALL || house->plan.walls[face->index].thickness > 0)
            continue;
        Primitive *wall = scene_add_line(scene, ROLE_WALL, THIN_WALL, (Vec2[]){face->a, face->b}, 2);
        wall->keep_clear = KEEP_WALL;
    }
}

static void add_furniture(Scene *scene, const Furniture *piece) {
    Vec2 corners[4];
    plan_furniture_corners(piece, corners);
    Primitive *body = scene_add_polygon(scene, ROLE_FURNITURE, corners, 4);
    body->edge = ROLE_FURNITURE_LINE;
    body->width = FURNITURE_EDGE;
    body->hatched = piece->toppled;
    body->keep_clear = KEEP_FURNITURE;
    if (!piece->toppled)
        return;
    Furniture standing = *piece;
    standing.toppled = false;
    plan_furniture_corners(&standing, corners);
    Primitive *before = scene_add_polygon(scene, ROLE_FURNITURE, corners, 4);
    before->edge = ROLE_WALL;
    before->width = FURNITURE_EDGE;
    before->style = LINE_DASHED;
}

/* A door's opening: its ends, the unit direction between them and the one to which it swings. */
typedef struct Opening {
    Vec2 hinge, latch;
    Vec2 along; /* from the hinge to the latch */
    Vec2 out;
    double half; /* m, half the wall's thickness */
} Opening;

static Opening opening_of(const Plan *plan, const Door *door) {
    Vec2 from, to;
    plan_door_ends(plan, door, &from, &to);
    Vec2 left = vec2_left(vec2_unit(vec2_sub(to, from)));
    bool at_start = door->hinge == HINGE_START;
    Opening opening = {.hinge = at_start ? from : to, .latch = at_start ? to : from};
    opening.along = vec2_unit(vec2_sub(opening.latch, opening.hinge));
    opening.out = door->swing == SWING_LEFT ? left : vec2_scale(left, -1);
    opening.half = plan->walls[door->wall_index].thickness / 2;
    return opening;
}

static void add_door_line(Scene *scene, Vec2 from, Vec2 to, double width, LineStyle style) {
    Primitive *line = scene_add_line(scene, ROLE_DOOR, width, (Vec2[]){from, to}, 2);
    line->style = style;
    line->keep_clear = KEEP_DOOR;
}

/* The quarter circle on which the leaf's edge goes from shut to open. */
static void add_swing(Scene *scene, const Opening *opening, double width, LineStyle style) {
    Vec2 arc[ARC_PIECES + 1], centre = vec2_along(opening->hinge, opening->half, opening->out);
    for (int i = 0; i <= ARC_PIECES; i++) {
        double turn = M_PI / 2 * i / ARC_PIECES;
        arc[i] = vec2_along(vec2_along(centre, width * cos(turn), opening->along), width * sin(turn), opening->out);
    }
    Primitive *swing = scene_add_line(scene, ROLE_DOOR, SWING, arc, ARC_PIECES + 1);
    swing->style = style;
    swing->keep_clear = KEEP_DOOR / 2;
}

/* The outline takes a locked door for wall: shows it as an opening again. */
static void add_recess(Scene *scene, const Opening *opening) {
    Vec2 side = vec2_scale(opening->out, opening->half);
    Vec2 corners[] = {vec2_sub(opening->hinge, side), vec2_sub(opening->latch, side), vec2_add(opening->latch, side),
                      vec2_add(opening->hinge, side)};
    scene_add_polygon(scene, ROLE_PAPER, corners, 4)->width = WALL_EDGE;
}

static void add_cross(Scene *scene, const Opening *opening) {
    Vec2 middle = vec2_scale(vec2_add(opening->hinge, opening->latch), 0.5);
    for (int sign = -1; sign <= 1; sign += 2) {
        Vec2 arm = vec2_scale(vec2_along(opening->along, sign, opening->out), CROSS_HALF);
        add_door_line(scene, vec2_sub(middle, arm), vec2_add(middle, arm), CROSS_EDGE, LINE_SOLID);
    }
}

static void add_door(Scene *scene, const Plan *plan, const Door *door) {
    Opening opening = opening_of(plan, door);
    bool open = door->state == DOOR_OPEN;
    if (open && door->kind == DOOR_OPENING)
        return;
    if (door->state == DOOR_LOCKED)
        add_recess(scene, &opening);
    if (!open)
        add_door_line(scene, opening.hinge, opening.latch, LEAF, LINE_SOLID);
    if (door->state == DOOR_LOCKED)
        add_cross(scene, &opening);
    if (door->kind == DOOR_HINGED && door->state != DOOR_LOCKED)
        add_swing(scene, &opening, door->width, open ? LINE_SOLID : LINE_DASHED);
    if (door->kind == DOOR_HINGED && open)
        add_door_line(scene, opening.hinge, vec2_along(opening.hinge, opening.half + door->width, opening.out), LEAF,
                      LINE_SOLID);
    if (door->kind == DOOR_SLIDING && open)
        add_door_line(scene, opening.hinge, vec2_along(opening.hinge, -door->width, opening.along), LEAF / 2,
                      LINE_DASHED);
}

static void add_exit(Scene *scene, const Exit *exit) {
    Vec2 ends[] = {exit->from, exit->to};
    scene_add_line(scene, ROLE_WALL, EXIT_RIM, ends, 2);
    Primitive *band = scene_add_line(scene, ROLE_EXIT, EXIT_BAND, ends, 2);
    band->keep_clear = KEEP_EXIT;
}

void plan_scene_solids(Scene *scene, const House *house) {
    const Plan *plan = &house->plan;
    add_walls(scene, house);
    for (size_t i = 0; i < plan->furniture_count; i++)
        add_furniture(scene, &plan->furniture[i]);
    for (size_t i = 0; i < plan->door_count; i++)
        add_door(scene, plan, &plan->doors[i]);
    for (size_t i = 0; i < plan->exit_count; i++)
        add_exit(scene, &plan->exits[i]);
}

static Primitive *add_tag(Scene *scene, Role fill, Vec2 at, const char *text) {
    Primitive *tag = scene_add_label(scene, ROLE_TEXT, TAG_LETTERS, at, text);
    tag->fill = fill;
    tag->bold = true;
    tag->shape = LABEL_TAG;
    return tag;
}

/* Where a toppled piece lies: what its footprint has grown by. */
static Furniture fallen_part(const Furniture *piece) {
    static const Vec2 ways[] = {
        [TOPPLE_FRONT] = {0, -1}, [TOPPLE_BACK] = {0, 1}, [TOPPLE_LEFT] = {-1, 0}, [TOPPLE_RIGHT] = {1, 0}};
    Furniture fallen = *piece;
    fallen.toppled = false;
    Vec2 way = ways[piece->topples];
    double half = (fabs(way.x) > 0 ? piece->size.x : piece->size.y) / 2;
    fallen.size = fabs(way.x) > 0 ? vec2(piece->height, piece->size.y) : vec2(piece->size.x, piece->height);
    fallen.centre =
        vec2_along(piece->centre, half + piece->height / 2, vec2_turn(way, vec2_heading(radians(piece->angle))));
    return fallen;
}

static void bind_to_furniture(Scene *scene, Primitive *label, const Furniture *piece) {
    Vec2 corners[4];
    plan_furniture_corners(piece, corners);
    scene_bind_label(scene, label, corners, 4);
}

void plan_scene_tags(Scene *scene, const House *house, const size_t *left) {
    const Plan *plan = &house->plan;
    for (size_t i = 0; i < plan->exit_count; i++) {
        const Exit *exit = &plan->exits[i];
        const char *text = plan->exit_count > 1 ? scene_text(scene, "EXIT %s", exit->id) : "EXIT";
        if (left)
            text = scene_text(scene, "%s: %zu", text, left[i]);
        add_tag(scene, ROLE_EXIT_TAG, vec2_scale(vec2_add(exit->from, exit->to), 0.5), text)->leader = left;
    }
    for (size_t i = 0; i < plan->furniture_count; i++) {
        if (!plan->furniture[i].toppled)
            continue;
        Furniture fallen = fallen_part(&plan->furniture[i]);
        bind_to_furniture(scene, add_tag(scene, ROLE_PAPER, fallen.centre, "toppled"), &fallen);
    }
}

static double edge_distance(const Points *outline, Vec2 p) {
    double nearest = HUGE_VAL;
    for (size_t i = 0; i < outline->count; i++) {
        Vec2 a = outline->at[i], b = outline->at[(i + 1) % outline->count];
        nearest = fmin(nearest, vec2_distance(p, vec2_nearest_on_segment(p, a, b)));
    }
    return nearest;
}

static bool outline_contains(const Points *outline, Vec2 p) {
    bool inside = false;
    for (size_t i = 0, j = outline->count - 1; i < outline->count; j = i++) {
        Vec2 a = outline->at[i], b = outline->at[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

/* A point of the room that is far from its walls, for an L as for a rectangle: the centroid lies outside an L. */
static Vec2 room_middle(const Points *outline) {
    Box box = box_empty();
    for (size_t i = 0; i < outline->count; i++)
        box = box_include(box, outline->at[i]);
    Vec2 size = vec2_sub(box.high, box.low), best = vec2_along(box.low, 0.5, size);
    double farthest = outline_contains(outline, best) ? edge_distance(outline, best) : 0;
    for (int i = 0; i < RASTER * RASTER; i++) {
        Vec2 part = vec2((i % RASTER + 0.5) / RASTER, (double)(i / RASTER) / RASTER + 0.5 / RASTER);
        Vec2 at = vec2(box.low.x + part.x * size.x, box.low.y + part.y * size.y);
        double distance = outline_contains(outline, at) ? edge_distance(outline, at) : 0;
        if (distance > farthest) {
            farthest = distance;
            best = at;
        }
    }
    return best;
}

static void add_furniture_name(Scene *scene, const Furniture *piece, bool needed) {
    const char *name = *piece->name ? piece->name : piece->id;
    Primitive *label = scene_add_label(scene, ROLE_TEXT, NAME_LETTERS, piece->centre, name);
    label->fill = ROLE_FURNITURE;
    label->leader = true;
    label->close = !needed;
    Furniture standing = *piece;
    standing.toppled = false;
    bind_to_furniture(scene, label, &standing);
}

void plan_scene_names(Scene *scene, const House *house, bool needed) {
    const Plan *plan = &house->plan;
    for (size_t i = 0; i < plan->furniture_count && plan->furniture_count <= PLAN_SCENE_NAMES; i++)
        add_furniture_name(scene, &plan->furniture[i], needed);
    for (size_t i = 0; i < plan->room_count; i++) {
        const Points *outline = &plan->rooms[i].outline;
        Primitive *label = scene_add_label(scene, ROLE_ROOM, ROOM_LETTERS, room_middle(outline), plan->rooms[i].name);
        label->optional = true;
        scene_bind_label(scene, label, outline->at, outline->count);
    }
    for (size_t i = 0; i < plan->door_count && plan->door_count <= PLAN_SCENE_NAMES; i++) {
        Opening opening = opening_of(plan, &plan->doors[i]);
        Vec2 middle = vec2_scale(vec2_add(opening.hinge, opening.latch), 0.5);
        Primitive *label = scene_add_label(scene, ROLE_DOOR, DOOR_LETTERS, middle, plan->doors[i].id);
        label->close = label->optional = !needed;
    }
}
