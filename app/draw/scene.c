#include "draw/scene.h"

#include <string.h>

#include "base/text.h"

void scene_clear(Scene *scene) {
    memory_free(scene->primitives);
    memory_free(scene->rows);
    arena_clear(&scene->arena);
    *scene = (Scene){0};
}

void scene_reset(Scene *scene) {
    arena_clear(&scene->arena);
    *scene = (Scene){.primitives = scene->primitives,
                     .capacity = scene->capacity,
                     .rows = scene->rows,
                     .row_capacity = scene->row_capacity};
}

static void *scene_copy(Scene *scene, const void *from, size_t count, size_t size) {
    return memcpy(arena_allocate(&scene->arena, count * size), from, count * size);
}

static Primitive *scene_add(Scene *scene, PrimitiveKind kind, const Vec2 *points, size_t count) {
    scene->primitives =
        memory_reserve(scene->primitives, &scene->capacity, scene->count + 1, sizeof *scene->primitives);
    Primitive *primitive = &scene->primitives[scene->count++];
    *primitive = (Primitive){.kind = kind,
                             .edge_opacity = 1,
                             .points = scene_copy(scene, points, count, sizeof *points),
                             .count = count,
                             .text = ""};
    return primitive;
}

Primitive *scene_add_rings(Scene *scene, Role fill, const Vec2 *points, const size_t *starts, size_t ring_count) {
    Primitive *polygon = scene_add(scene, PRIMITIVE_POLYGON, points, starts[ring_count]);
    polygon->fill = polygon->edge = fill;
    polygon->fill_opacity = 1;
    polygon->starts = scene_copy(scene, starts, ring_count + 1, sizeof *starts);
    polygon->ring_count = ring_count;
    return polygon;
}

Primitive *scene_add_polygon(Scene *scene, Role fill, const Vec2 *points, size_t count) {
    return scene_add_rings(scene, fill, points, (size_t[]){0, count}, 1);
}

static Primitive *scene_add_round(Scene *scene, PrimitiveKind kind, Role fill, double radius, const Vec2 *points,
                                  size_t count) {
    Primitive *round = scene_add(scene, kind, points, count);
    round->fill = round->edge = fill;
    round->fill_opacity = 1;
    round->radius = radius;
    return round;
}

Primitive *scene_add_discs(Scene *scene, Role fill, double radius, const Vec2 *centres, size_t count) {
    return scene_add_round(scene, PRIMITIVE_DISC, fill, radius, centres, count);
}

Primitive *scene_add_wheel(Scene *scene, Role fill, double radius, Vec2 from, Vec2 to) {
    return scene_add_round(scene, PRIMITIVE_WHEEL, fill, radius, (Vec2[]){from, to}, 2);
}

Primitive *scene_add_ball(Scene *scene, Role fill, double radius, Vec2 at) {
    return scene_add_round(scene, PRIMITIVE_BALL, fill, radius, &at, 1);
}

static Primitive *scene_add_stroke(Scene *scene, PrimitiveKind kind, Role edge, double width, const Vec2 *points,
                                   size_t count) {
    Primitive *stroke = scene_add(scene, kind, points, count);
    stroke->edge = edge;
    stroke->width = width;
    return stroke;
}

Primitive *scene_add_line(Scene *scene, Role edge, double width, const Vec2 *points, size_t count) {
    return scene_add_stroke(scene, PRIMITIVE_LINE, edge, width, points, count);
}

Primitive *scene_add_star(Scene *scene, Role fill, double radius, Vec2 at) {
    enum { POINTS = 16 };
    Vec2 star[POINTS];
    for (int k = 0; k < POINTS; k++)
        star[k] = vec2_along(at, k % 2 ? radius / 2 : radius, vec2_heading(2 * M_PI * k / POINTS));
    return scene_add_polygon(scene, fill, star, POINTS);
}

Primitive *scene_add_tick(Scene *scene, Role edge, double width, double size, Vec2 at, Vec2 towards) {
    Primitive *tick = scene_add_stroke(scene, PRIMITIVE_TICK, edge, width, (Vec2[]){at, towards}, 2);
    tick->size = size;
    return tick;
}

Primitive *scene_add_dimension(Scene *scene, Role edge, double width, Vec2 from, Vec2 to) {
    return scene_add_stroke(scene, PRIMITIVE_DIMENSION, edge, width, (Vec2[]){from, to}, 2);
}

Primitive *scene_add_label(Scene *scene, Role role, double size, Vec2 at, const char *text) {
    Primitive *label = scene_add(scene, PRIMITIVE_LABEL, &at, 1);
    label->fill = ROLE_PAPER;
    label->edge = role;
    label->size = size;
    label->text = arena_text(&scene->arena, text);
    return label;
}

void scene_add_all(Scene *scene, const Scene *other) {
    for (size_t i = 0; i < other->count; i++) {
        const Primitive *from = &other->primitives[i];
        Primitive *copy = scene_add(scene, from->kind, from->points, from->count);
        const Vec2 *points = copy->points;
        *copy = *from;
        copy->points = points;
        copy->text = arena_text(&scene->arena, from->text);
        if (from->starts)
            copy->starts = scene_copy(scene, from->starts, from->ring_count + 1, sizeof *from->starts);
    }
}

void scene_bind_label(Scene *scene, Primitive *label, const Vec2 *outline, size_t count) {
    Vec2 *points = arena_allocate(&scene->arena, (count + 1) * sizeof *points);
    points[0] = label->points[0];
    memcpy(points + 1, outline, count * sizeof *points);
    label->points = points;
    label->count = count + 1;
}

SceneRow *scene_add_row(Scene *scene, RowKind kind, const char *first) {
    scene->rows = memory_reserve(scene->rows, &scene->row_capacity, scene->row_count + 1, sizeof *scene->rows);
    SceneRow *row = &scene->rows[scene->row_count++];
    *row = (SceneRow){.kind = kind, .cells = {arena_text(&scene->arena, first)}};
    return row;
}

const char *scene_text(Scene *scene, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const char *kept = text_vin_arena(&scene->arena, format, arguments);
    va_end(arguments);
    return kept;
}
