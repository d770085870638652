#include "visual/machine/pieces.h"

/* Design points. */
#define SPRING_WIDTH 2.5
#define GROUND_WIDTH 3.0
#define EDGE 1.5

/* 1 */
#define SPRING_END 0.12 /* of a spring, straight at either end */
#define SPIRAL_TURNS 2.25
#define HEAD_LENGTH 4.0 /* of an arrow's head, in half shaft widths */
#define HEAD_HALF 2.4   /* of an arrow's head, in half shaft widths */

enum { SPRING_COILS = 5, SPIRAL_POINTS = 48 };

void machine_pieces_spring(Scene *scene, Vec2 from, Vec2 to, double half) {
    Vec2 points[2 * SPRING_COILS + 4], way = vec2_sub(to, from), across = vec2_scale(vec2_left(vec2_unit(way)), half);
    size_t count = 0;
    points[count++] = from;
    points[count++] = vec2_along(from, SPRING_END, way);
    for (int i = 0; i < 2 * SPRING_COILS; i++) {
        double part = SPRING_END + (1 - 2 * SPRING_END) * (i + 0.5) / (2 * SPRING_COILS);
        points[count++] = vec2_along(vec2_along(from, part, way), i % 2 ? -1 : 1, across);
    }
    points[count++] = vec2_along(from, 1 - SPRING_END, way);
    points[count++] = to;
    scene_add_line(scene, ROLE_FURNITURE_LINE, SPRING_WIDTH, points, count);
}

void machine_pieces_spiral(Scene *scene, Vec2 middle, double radius) {
    Vec2 points[SPIRAL_POINTS];
    for (int i = 0; i < SPIRAL_POINTS; i++) {
        double part = (i + 1.0) / SPIRAL_POINTS;
        points[i] = vec2_along(middle, part * radius, vec2_heading(-2 * M_PI * SPIRAL_TURNS * part));
    }
    scene_add_line(scene, ROLE_FURNITURE_LINE, SPRING_WIDTH, points, SPIRAL_POINTS);
}

void machine_pieces_dashpot(Scene *scene, Vec2 from, Vec2 to, double half) {
    Vec2 way = vec2_sub(to, from), across = vec2_scale(vec2_left(vec2_unit(way)), half);
    Vec2 piston = vec2_along(from, 0.55, way), mouth = vec2_along(from, 0.4, way), bottom = vec2_along(from, 0.8, way);
    Vec2 cylinder[] = {vec2_add(mouth, across), vec2_add(bottom, across), vec2_sub(bottom, across),
                       vec2_sub(mouth, across)};
    scene_add_line(scene, ROLE_FURNITURE_LINE, SPRING_WIDTH, (Vec2[]){from, piston}, 2);
    scene_add_line(scene, ROLE_FURNITURE_LINE, 2 * SPRING_WIDTH,
                   (Vec2[]){vec2_along(piston, 0.8, across), vec2_along(piston, -0.8, across)}, 2);
    scene_add_line(scene, ROLE_FURNITURE_LINE, SPRING_WIDTH, cylinder, 4);
    scene_add_line(scene, ROLE_FURNITURE_LINE, SPRING_WIDTH, (Vec2[]){bottom, to}, 2);
}

void machine_pieces_ground(Scene *scene, Vec2 left, Vec2 right, double depth) {
    Vec2 corners[] = {left, right, vec2(right.x, right.y + depth), vec2(left.x, left.y + depth)};
    Primitive *behind = scene_add_polygon(scene, ROLE_PAPER, corners, 4);
    behind->fill_opacity = 0;
    behind->edge = ROLE_FURNITURE_LINE;
    behind->hatched = true;
    scene_add_line(scene, ROLE_WALL, GROUND_WIDTH, (Vec2[]){left, right}, 2);
}

Primitive *machine_pieces_block(Scene *scene, Role fill, Box box) {
    Vec2 corners[] = {box.low, vec2(box.high.x, box.low.y), box.high, vec2(box.low.x, box.high.y)};
    Primitive *block = scene_add_polygon(scene, fill, corners, 4);
    block->edge = ROLE_WALL;
    block->width = EDGE;
    return block;
}

void machine_pieces_arrow(Scene *scene, Role role, Vec2 foot, Vec2 point, double half) {
    Vec2 way = vec2_sub(point, foot);
    double length = vec2_length(way), head = fmin(HEAD_LENGTH * half, length);
    if (!(length > 0))
        return;
    Vec2 along = vec2_unit(way), across = vec2_left(along), neck = vec2_along(point, -head, along);
    double wide = HEAD_HALF * half * head / (HEAD_LENGTH * half), shaft = head < length ? half : 0;
    Vec2 outline[] = {
        vec2_along(foot, shaft, across), vec2_along(neck, shaft, across),  vec2_along(neck, wide, across),  point,
        vec2_along(neck, -wide, across), vec2_along(neck, -shaft, across), vec2_along(foot, -shaft, across)};
    Primitive *arrow = scene_add_polygon(scene, role, outline, sizeof outline / sizeof *outline);
    arrow->edge = ROLE_WALL;
    arrow->width = EDGE;
}

void machine_pieces_star(Scene *scene, Vec2 at, double radius) {
    Primitive *star = scene_add_star(scene, ROLE_DANGER_MIDDLE, radius, at);
    star->edge = ROLE_WALL;
    star->width = EDGE;
}
