#include "visual/house/plan_scene.h"

#include <stdint.h>
#include <string.h>

#include "plan/plan_geometry.h"
#include "result/headline.h"

/* Design points. */
#define WALL_EDGE 1.5 /* keeps thin walls of large plans visible */
#define THIN_WALL 3.0 /* walls without thickness */
#define FURNITURE_EDGE 2.0
#define FALLEN_EDGE 3.0
#define LEAF 4.0
#define SWING 1.5
#define EXIT_BAND 10.0
#define EXIT_RIM 14.0
#define CROSS_EDGE 3.0
#define TAG_TEXT 16.0
#define NAME_TEXT 16.0
#define ROOM_TEXT 16.0

/* Weights against being covered by labels. */
#define KEEP_WALL 1.0
#define KEEP_FURNITURE 0.4
#define KEEP_DOOR 1.0
#define SIGN_ASIDE 0.4 /* m, of a sign beyond an end of its exit whose place beside it is taken */
#define KEEP_EXIT 3.0

#define CROSS_HALF 0.11 /* m, of the x on a locked door: within the depth of the wall around the opening */

#define LEAF_SECONDS 0.8 /* share of a door's opening time during which the leaf moves */

enum {
    ARC_PIECES = 16, /* of a quarter circle */
    ALIKE_MOST = 2,  /* pieces of one name that are named */
    RASTER = 24,     /* points per side that are tried for the middle of a room */
    SLICES = 48,     /* of a leaning piece */
};

static void add_walls(Scene *scene, const House *house, PlanWalls *kept) {
    const Outline *outline = &house->outline;
    const Plan *plan = &house->plan;
    plan_walls_update(kept, plan, PLAN_SCENE_CUT);
    for (size_t b = 0; b < kept->count; b++) {
        const Rings *rings = &kept->bands[b].rings;
        Primitive *walls = scene_add_rings(scene, ROLE_WALL, rings->points, rings->starts, rings->count);
        walls->width = WALL_EDGE;
        walls->keep_clear = KEEP_WALL;
        walls->height = kept->bands[b].shown;
    }
    for (size_t i = 0; i < outline->face_count; i++) {
        const Face *face = &outline->faces[i];
        if (face->owner != OWNER_WALL || plan->walls[face->index].thickness > 0)
            continue;
        Primitive *wall = scene_add_line(scene, ROLE_WALL, THIN_WALL, (Vec2[]){face->a, face->b}, 2);
        wall->height = fmin(plan->walls[face->index].height, PLAN_SCENE_CUT);
        wall->keep_clear = KEEP_WALL;
    }
}

/* Returns the area that a piece covers at a share of its fall. */
static Primitive *add_body(Scene *scene, const Furniture *piece, double share) {
    Vec2 corners[4];
    furniture_fall_corners(piece, share, corners);
    Primitive *body = scene_add_polygon(scene, ROLE_FURNITURE, corners, 4);
    body->edge = ROLE_FURNITURE_LINE;
    body->width = FURNITURE_EDGE;
    body->keep_clear = KEEP_FURNITURE;
    return body;
}

static void add_furniture(Scene *scene, const Furniture *piece) {
    Primitive *body = add_body(scene, piece, piece->toppled);
    body->height = fmin(furniture_fall_height(piece, piece->toppled), PLAN_SCENE_STOREY);
    if (!piece->toppled)
        return;
    body->hatched = true;
    body->edge = ROLE_ERROR;
    body->width = FALLEN_EDGE;
    Vec2 corners[4];
    furniture_fall_corners(piece, 0, corners);
    Primitive *before = scene_add_polygon(scene, ROLE_FURNITURE, corners, 4);
    before->edge = ROLE_ERROR;
    before->width = FURNITURE_EDGE;
    before->style = LINE_DASHED;
}

/* Returns a rectangle of the piece's width between two distances, m, beyond the face to which it falls. */
static Furniture part_beyond(const Furniture *piece, double from, double to) {
    static const Vec2 ways[] = {
        [TOPPLE_FRONT] = {0, -1}, [TOPPLE_BACK] = {0, 1}, [TOPPLE_LEFT] = {-1, 0}, [TOPPLE_RIGHT] = {1, 0}};
    Furniture part = *piece;
    part.toppled = false;
    Vec2 way = ways[piece->topples];
    double half = (fabs(way.x) > 0 ? piece->size.x : piece->size.y) / 2;
    part.size = fabs(way.x) > 0 ? vec2(to - from, piece->size.y) : vec2(piece->size.x, to - from);
    part.centre =
        vec2_along(piece->centre, half + (from + to) / 2, vec2_turn(way, vec2_heading(radians(piece->angle))));
    return part;
}

/* Adds level slices, since primitives cannot lean. */
static void add_leaning(Scene *scene, const Furniture *piece, double share) {
    double thickness = furniture_fall_height(piece, share) / SLICES;
    for (int i = 0; i < SLICES && (i + 1) * thickness <= PLAN_SCENE_STOREY; i++) {
        double from, to;
        furniture_fall_cut(piece, share, (i + 0.5) * thickness, &from, &to);
        Furniture part = part_beyond(piece, from, to);
        Vec2 corners[4];
        plan_geometry_corners(&part, corners);
        Primitive *slice = scene_add_polygon(scene, ROLE_FURNITURE, corners, 4);
        slice->edge_opacity = 0; /* no edges between them */
        slice->width = FURNITURE_EDGE;
        slice->base = i * thickness;
        slice->height = thickness;
    }
}

void plan_scene_falling(Scene *scene, const FurnitureFall *fall, bool raised) {
    double share = furniture_fall_share(fall);
    Furniture piece = fall->piece;
    piece.toppled = share >= 1;
    if (share <= 0 || share >= 1) {
        add_furniture(scene, &piece);
        return;
    }
    add_body(scene, &piece, share);
    if (raised)
        add_leaning(scene, &piece, share);
}

void plan_scene_place(Scene *scene, const Furniture *piece) {
    Vec2 corners[4];
    plan_geometry_corners(piece, corners);
    Primitive *place = scene_add_polygon(scene, ROLE_FURNITURE, corners, 4);
    place->fill_opacity = 0;
    place->keep_clear = KEEP_FURNITURE;
}

/* The opening of a door: its ends, the unit direction between them and the direction to which it swings. */
typedef struct Opening {
    Vec2 hinge, latch;
    Vec2 along; /* from the hinge to the latch */
    Vec2 out;
    double half; /* m, half the wall's thickness */
} Opening;

static Opening opening_of(const Plan *plan, const Door *door) {
    Vec2 from, to;
    plan_geometry_door_ends(plan, door, &from, &to);
    Vec2 left = vec2_left(vec2_unit(vec2_sub(to, from)));
    bool at_start = door->hinge == HINGE_START;
    Opening opening = {.hinge = at_start ? from : to, .latch = at_start ? to : from};
    opening.along = vec2_unit(vec2_sub(opening.latch, opening.hinge));
    opening.out = door->swing == SWING_LEFT ? left : vec2_scale(left, -1);
    opening.half = plan->walls[door->wall_index].thickness / 2;
    return opening;
}

static Primitive *add_door_line(Scene *scene, Vec2 from, Vec2 to, double width, LineStyle style) {
    Primitive *line = scene_add_line(scene, ROLE_DOOR, width, (Vec2[]){from, to}, 2);
    line->style = style;
    line->keep_clear = KEEP_DOOR;
    return line;
}

/* Adds a leaf with its free end at this share of its turn: 0 shut, 1 at a right angle. */
static void add_leaf(Scene *scene, const Opening *opening, double width, double open) {
    double turn = M_PI / 2 * open;
    Vec2 root = vec2_along(opening->hinge, open * opening->half, opening->out);
    Vec2 tip = vec2_along(vec2_along(root, width * cos(turn), opening->along), width * sin(turn), opening->out);
    add_door_line(scene, open < 1 ? root : opening->hinge, tip, LEAF, LINE_SOLID)->height = PLAN_SCENE_CUT;
}

/* Adds the quarter circle of the leaf's edge from shut to open. */
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

/* Adds a locked door as a wall with a sign on it. */
static void add_locked(Scene *scene, const Opening *opening) {
    Vec2 side = vec2_scale(opening->out, opening->half);
    Vec2 corners[] = {vec2_sub(opening->hinge, side), vec2_sub(opening->latch, side), vec2_add(opening->latch, side),
                      vec2_add(opening->hinge, side)};
    Primitive *recess = scene_add_polygon(scene, ROLE_PAPER, corners, 4);
    recess->width = WALL_EDGE;
    recess->base = PLAN_SCENE_CUT;
    add_door_line(scene, opening->hinge, opening->latch, LEAF, LINE_SOLID)->base = PLAN_SCENE_CUT;
    Vec2 middle = vec2_scale(vec2_add(opening->hinge, opening->latch), 0.5);
    for (int sign = -1; sign <= 1; sign += 2) {
        Vec2 arm = vec2_scale(vec2_along(opening->along, sign, opening->out), CROSS_HALF);
        add_door_line(scene, vec2_sub(middle, arm), vec2_add(middle, arm), CROSS_EDGE, LINE_SOLID)->base =
            PLAN_SCENE_CUT;
    }
}

/* Adds a leaf that slides along its wall, next to the opening. */
static void add_sliding(Scene *scene, const Opening *opening, double width, double open) {
    Vec2 root = vec2_along(opening->hinge, -open * width, opening->along);
    Primitive *leaf = add_door_line(scene, root, vec2_along(root, width, opening->along), open > 0 ? LEAF / 2 : LEAF,
                                    open > 0 ? LINE_DASHED : LINE_SOLID);
    leaf->height = PLAN_SCENE_CUT;
}

/* `open` from 0, shut, to 1. */
static void add_door(Scene *scene, const Plan *plan, const Door *door, double open) {
    Opening opening = opening_of(plan, door);
    if (door->state == DOOR_LOCKED) {
        add_locked(scene, &opening);
    } else if (door->kind == DOOR_HINGED) {
        add_swing(scene, &opening, door->width, open < 1 ? LINE_DASHED : LINE_SOLID);
        add_leaf(scene, &opening, door->width, open);
    } else if (door->kind == DOOR_SLIDING) {
        add_sliding(scene, &opening, door->width, open);
    } else if (door->state != DOOR_OPEN) {
        add_leaf(scene, &opening, door->width, 0);
    }
}

static void add_exit(Scene *scene, const Exit *exit) {
    Vec2 ends[] = {exit->from, exit->to};
    scene_add_line(scene, ROLE_WALL, EXIT_RIM, ends, 2);
    Primitive *band = scene_add_line(scene, ROLE_EXIT, EXIT_BAND, ends, 2);
    band->keep_clear = KEEP_EXIT;
}

static void add_solids(Scene *scene, const House *house, bool all_doors, PlanWalls *kept) {
    const Plan *plan = &house->plan;
    add_walls(scene, house, kept);
    for (size_t i = 0; i < plan->furniture_count; i++)
        add_furniture(scene, &plan->furniture[i]);
    for (size_t i = 0; i < plan->door_count; i++)
        if (all_doors || !outline_door_moves(&plan->doors[i]))
            add_door(scene, plan, &plan->doors[i], plan->doors[i].state == DOOR_OPEN);
    for (size_t i = 0; i < plan->exit_count; i++)
        add_exit(scene, &plan->exits[i]);
}

void plan_scene_solids(Scene *scene, const House *house) {
    PlanWalls walls = {0};
    add_solids(scene, house, true, &walls);
    plan_walls_clear(&walls);
}

void plan_scene_still(Scene *scene, const House *house, PlanWalls *kept) {
    PlanWalls own = {0};
    add_solids(scene, house, false, kept ? kept : &own);
    plan_walls_clear(&own);
}

/* A leaf reaches its end when its door counts as open; an exit that is shut is grey. */
void plan_scene_moving(Scene *scene, const House *house, const double *door_opened, double time) {
    const Plan *plan = &house->plan;
    for (size_t i = 0; i < plan->door_count; i++) {
        const Door *door = &plan->doors[i];
        double takes = fmax(1e-3, fmin(LEAF_SECONDS, door->opening_time));
        if (outline_door_moves(door))
            add_door(scene, plan, door, real_clamp(1 + (time - door_opened[i]) / takes, 0, 1));
    }
    for (size_t e = 0; e < plan->exit_count; e++)
        if (plan_geometry_bars(plan, e, time))
            scene_add_line(scene, ROLE_DIM_TEXT, EXIT_BAND, (Vec2[]){plan->exits[e].from, plan->exits[e].to}, 2);
}

static Primitive *add_tag(Scene *scene, Role fill, Vec2 at, const char *text) {
    Primitive *tag = scene_add_label(scene, ROLE_TEXT, TAG_TEXT, at, text);
    tag->fill = fill;
    tag->bold = true;
    tag->shape = LABEL_TAG;
    return tag;
}

static void bind_to_furniture(Scene *scene, Primitive *label, const Furniture *piece) {
    Vec2 corners[4];
    plan_geometry_corners(piece, corners);
    scene_bind_label(scene, label, corners, 4);
}

/* Returns "EXIT", the id where there are several, and the times of an exit that is not always open. */
static const char *exit_name(Scene *scene, const Plan *plan, const Exit *exit) {
    const char *name = plan->exit_count > 1 ? scene_text(scene, "EXIT %s", exit->id) : "EXIT";
    if (exit->opens > 0)
        name = scene_text(scene, "%s from %.4g s", name, exit->opens);
    return exit->closes < HUGE_VAL ? scene_text(scene, "%s until %.4g s", name, exit->closes) : name;
}

static void add_toppled_tags(Scene *scene, const Plan *plan) {
    for (size_t i = 0; i < plan->furniture_count; i++) {
        if (!plan->furniture[i].toppled)
            continue;
        Furniture fallen = part_beyond(&plan->furniture[i], 0, plan->furniture[i].height);
        bind_to_furniture(scene, add_tag(scene, ROLE_PAPER, fallen.centre, "fallen"), &fallen);
    }
}

/* True if chairs may leave by an exit: they come to rest just outside its middle. */
static bool chairs_leave_by(const House *house, const Exit *exit) {
    for (size_t i = 0; i < house->person_count; i++) {
        const Inhabitant *person = &house->people[i];
        size_t wanted = person->route ? person->route->exit_index : SIZE_MAX;
        if (person->profile->driving != DRIVING_WALKER && (wanted == SIZE_MAX || exit == &house->plan.exits[wanted]))
            return true;
    }
    return false;
}

/* Adds the sign of an exit, and on it how many have left by it, if `left` is given, always equally wide: outside the
 * middle of the exit unless chairs come there, otherwise next to one of its ends or beyond it, otherwise inside. */
static void add_sign(Scene *scene, const House *house, const Exit *exit, const size_t *left) {
    const char *name = exit_name(scene, &house->plan, exit);
    const char *count = left ? headline_count(*left, house->person_count, &scene->arena) : NULL;
    Vec2 middle = vec2_scale(vec2_add(house->outline.box.low, house->outline.box.high), 0.5);
    Vec2 at = vec2_scale(vec2_add(exit->from, exit->to), 0.5), along = vec2_sub(exit->to, exit->from);
    Vec2 out = vec2_left(along);
    out = vec2_dot(out, vec2_sub(at, middle)) < 0 ? vec2_scale(out, -1) : out;
    Vec2 low = exit->to.y <= exit->from.y ? exit->to : exit->from,
         high = exit->to.y <= exit->from.y ? exit->from : exit->to;
    Vec2 below = vec2_add(out, vec2_sub(low, high)), above = vec2_add(out, vec2_sub(high, low));
    Vec2 lower = vec2_along(low, SIGN_ASIDE, vec2_unit(vec2_sub(low, high)));
    Vec2 higher = vec2_along(high, SIGN_ASIDE, vec2_unit(vec2_sub(high, low)));
    Vec2 places[] = {at,    vec2_add(at, out),                                       /* outside */
                     low,   vec2_add(low, below),   high,   vec2_add(high, above),   /* ends */
                     lower, vec2_add(lower, below), higher, vec2_add(higher, above), /* beyond */
                     at,    vec2_add(at, out),      at,     vec2_sub(at, out)};
    size_t skipped = chairs_leave_by(house, exit) ? 2 : 0;
    Primitive *sign = add_tag(scene, ROLE_EXIT_TAG, at, left ? scene_text(scene, "%s: %s", name, count) : name);
    scene_bind_label(scene, sign, places + skipped, sizeof places / sizeof *places - skipped);
    sign->brief = left ? scene_text(scene, "%s: %s", house->plan.exit_count > 1 ? exit->id : "out", count) : "EXIT";
    sign->fixed = true;
}

void plan_scene_signs(Scene *scene, const House *house, const size_t *left) {
    for (size_t i = 0; i < house->plan.exit_count; i++)
        add_sign(scene, house, &house->plan.exits[i], left ? &left[i] : NULL);
}

void plan_scene_tags(Scene *scene, const House *house, const size_t *left) {
    plan_scene_signs(scene, house, left);
    add_toppled_tags(scene, &house->plan);
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

/* Returns a point of the room far from its walls, for an L as well as for a rectangle: the centroid of an L may lie
 * outside. */
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

/* Returns the number of pieces with the name of a piece. */
static size_t count_alike(const Plan *plan, const char *name) {
    size_t count = 0;
    for (size_t i = 0; i < plan->furniture_count; i++)
        count += strcmp(plan->furniture[i].name, name) == 0;
    return count;
}

/* Adds the name of a piece; `close`: only where there is room within or right next to it. */
static void add_furniture_name(Scene *scene, const Furniture *piece, bool close) {
    Primitive *label = scene_add_label(scene, ROLE_TEXT, NAME_TEXT, piece->centre, piece->name);
    label->fill = ROLE_FURNITURE;
    label->close = close;
    label->leader = !close;
    Furniture standing = *piece;
    standing.toppled = false;
    bind_to_furniture(scene, label, &standing);
}

static void add_names(Scene *scene, const House *house, bool close) {
    const Plan *plan = &house->plan;
    for (size_t i = 0; i < plan->room_count; i++) {
        const Points *outline = &plan->rooms[i].outline;
        Primitive *label = scene_add_label(scene, ROLE_ROOM, ROOM_TEXT, room_middle(outline), plan->rooms[i].name);
        label->optional = label->level = true;
        scene_bind_label(scene, label, outline->at, outline->count);
    }
    for (size_t i = 0; i < plan->furniture_count; i++)
        if (*plan->furniture[i].name && count_alike(plan, plan->furniture[i].name) <= ALIKE_MOST)
            add_furniture_name(scene, &plan->furniture[i], close);
}

void plan_scene_names(Scene *scene, const House *house) {
    add_names(scene, house, true);
}

void plan_scene_all_names(Scene *scene, const House *house) {
    add_names(scene, house, false);
}
