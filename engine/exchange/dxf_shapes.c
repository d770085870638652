#include "exchange/dxf_shapes.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/real.h"
#include "base/text.h"

enum {
    DEEPEST = 16,         /* nesting depth of blocks */
    MOST_VISITS = 500000, /* entities, those of a block counted at each insertion */
    MOST_POINTS = 1000000,
    ARC_MOST = 72 /* straight lines per circle */
};

/* x' = a x + c y + e, y' = b x + d y + f. */
typedef struct Affine {
    double a, b, c, d, e, f;
} Affine;

typedef struct Walker {
    DxfShapes *shapes;
    const DxfFile *file;
    HouseBuilder *builder;
    size_t visits;
} Walker;

/* The place and context of an entity. */
typedef struct Place {
    Affine affine;
    size_t layer;    /* layer of the block's INSERT, which layer 0 stands for; SIZE_MAX outside blocks */
    DxfRole role;    /* role of the enclosing block, or DXF_UNKNOWN */
    size_t instance; /* index of the furniture instance, or SIZE_MAX */
    int depth;
} Place;

static Vec2 apply(const Affine *affine, Vec2 at) {
    return vec2(affine->a * at.x + affine->c * at.y + affine->e, affine->b * at.x + affine->d * at.y + affine->f);
}

/* Returns the transformation that applies `inner`, then `outer`. */
static Affine compose(const Affine *outer, const Affine *inner) {
    Vec2 x = vec2(outer->a * inner->a + outer->c * inner->b, outer->b * inner->a + outer->d * inner->b);
    Vec2 y = vec2(outer->a * inner->c + outer->c * inner->d, outer->b * inner->c + outer->d * inner->d);
    Vec2 origin = apply(outer, vec2(inner->e, inner->f));
    return (Affine){x.x, x.y, y.x, y.y, origin.x, origin.y};
}

static Affine of_entity(const Place *place, const DxfEntity *entity) {
    static const Affine mirror = {.a = -1, .d = 1};
    return entity->mirrored ? compose(&place->affine, &mirror) : place->affine;
}

/* Returns the layer of an entity; layer 0 in a block stands for the layer of the block's INSERT. */
static size_t layer_of(const Walker *walker, const DxfEntity *entity, const Place *place) {
    bool of_block = place->layer != SIZE_MAX && strcmp(walker->file->layers[entity->layer].name, "0") == 0;
    return of_block ? place->layer : entity->layer;
}

/* Shapes ---------------------------------------------------------------------------------------------------------- */

static bool add_point(Walker *walker, Vec2 at) {
    DxfShapes *shapes = walker->shapes;
    if (shapes->point_count == MOST_POINTS)
        return house_builder_fail(walker->builder, "more than %d points, must be fewer", MOST_POINTS);
    shapes->points =
        memory_reserve(shapes->points, &shapes->point_capacity, shapes->point_count + 1, sizeof *shapes->points);
    shapes->points[shapes->point_count++] = at;
    shapes->list[shapes->count - 1].count++;
    return true;
}

static DxfShape *add_shape(Walker *walker, const DxfEntity *entity, const Place *place, DxfRole role) {
    DxfShapes *shapes = walker->shapes;
    size_t layer = layer_of(walker, entity, place);
    shapes->list = memory_reserve(shapes->list, &shapes->capacity, shapes->count + 1, sizeof *shapes->list);
    DxfShape *shape = &shapes->list[shapes->count++];
    *shape = (DxfShape){.role = role,
                        .point = shapes->point_count,
                        .closed = entity->closed,
                        .window = walker->file->layers[layer].window,
                        .instance = place->instance,
                        .line = entity->line};
    return shape;
}

/* Adds the points of an arc after its first, in the entity's own axes. */
static bool add_arc_points(Walker *walker, const Affine *affine, Vec2 centre, Vec2 from, double sweep) {
    Vec2 arm = vec2_sub(from, centre);
    double pieces = real_clamp(ceil(fabs(sweep) * ARC_MOST / (2 * M_PI) - 1e-9), 1, ARC_MOST);
    bool good = true;
    for (double i = 1; i <= pieces && good; i++)
        good = add_point(walker, apply(affine, vec2_add(centre, vec2_turn(arm, vec2_heading(sweep * i / pieces)))));
    return good;
}

/* Adds the side from a to b, an arc if it bulges. */
static bool add_side(Walker *walker, const Affine *affine, const DxfVertex *a, const DxfVertex *b) {
    double sweep = 4 * real_atan(a->bulge);
    Vec2 across = vec2_sub(b->at, a->at);
    if (fabs(sweep) > 1e-3) {
        SineCosine half = real_sincos(sweep / 2);
        double off = half.cosine / (2 * half.sine);
        Vec2 centre = vec2_along(vec2_along(a->at, 0.5, across), off, vec2_left(across));
        if (!add_arc_points(walker, affine, centre, a->at, sweep))
            return false;
        walker->shapes->points[walker->shapes->point_count - 1] =
            apply(affine, b->at); /* set exactly, without rounding */
        return true;
    }
    return add_point(walker, apply(affine, b->at));
}

static bool add_lines(Walker *walker, const DxfEntity *entity, const Place *place, DxfRole role) {
    if (entity->vertex_count < 2)
        return true;
    const DxfVertex *vertices = walker->file->vertices + entity->vertex;
    Affine affine = of_entity(place, entity);
    DxfShape *shape = add_shape(walker, entity, place, role);
    shape->width = entity->width * sqrt(fabs(affine.a * affine.d - affine.b * affine.c));
    bool good = add_point(walker, apply(&affine, vertices[0].at));
    for (size_t v = 1; v < entity->vertex_count && good; v++)
        good = add_side(walker, &affine, &vertices[v - 1], &vertices[v]);
    if (good && entity->closed)
        good = add_side(walker, &affine, &vertices[entity->vertex_count - 1], &vertices[0]);
    return good;
}

static bool add_arc(Walker *walker, const DxfEntity *entity, const Place *place, DxfRole role) {
    Affine affine = of_entity(place, entity);
    double start = radians(entity->start), sweep = fmod(radians(entity->end) - start, 2 * M_PI);
    sweep += sweep <= 1e-9 ? 2 * M_PI : 0;
    Vec2 from = vec2_along(entity->at, entity->radius, vec2_heading(start));
    DxfShape *shape = add_shape(walker, entity, place, role);
    shape->closed = sweep > 2 * M_PI - 1e-6;
    shape->arc = !shape->closed;
    shape->centre = apply(&affine, entity->at);
    shape->sweep = sweep;
    return add_point(walker, apply(&affine, from)) && add_arc_points(walker, &affine, entity->at, from, sweep);
}

/* Blocks ---------------------------------------------------------------------------------------------------------- */

static bool visit_all(Walker *walker, size_t first, size_t count, const Place *place);

static Affine of_insert(const DxfEntity *insert, const DxfBlock *block, int column, int row) {
    Vec2 axis = vec2_heading(radians(insert->turned));
    Vec2 x = vec2_scale(axis, insert->scale.x), y = vec2_scale(vec2_left(axis), insert->scale.y);
    Vec2 cell = vec2_turn(vec2(column * insert->spacing.x, row * insert->spacing.y), axis);
    Affine turned = {x.x, x.y, y.x, y.y, insert->at.x + cell.x, insert->at.y + cell.y};
    Vec2 base = apply(&turned, vec2_scale(block->base, -1));
    turned.e = base.x;
    turned.f = base.y;
    return turned;
}

/* Begins a piece of furniture if the block lies on a furniture layer or is named like furniture. */
static void begin_instance(Walker *walker, const DxfBlock *block, DxfRole role, Place *inside) {
    DxfShapes *shapes = walker->shapes;
    DxfRole called = (DxfRole)block->role;
    if (inside->role != DXF_UNKNOWN)
        return;
    inside->role = called != DXF_UNKNOWN && role != DXF_NOTHING ? called
                   : role == DXF_FURNITURE || role == DXF_DOORS ? role
                                                                : DXF_UNKNOWN;
    if (inside->role != DXF_FURNITURE)
        return;
    shapes->instances = memory_reserve(shapes->instances, &shapes->instance_capacity, shapes->instance_count + 1,
                                       sizeof *shapes->instances);
    inside->instance = shapes->instance_count;
    shapes->instances[shapes->instance_count++] =
        (DxfInstance){block->name, vec2_unit(vec2(inside->affine.a, inside->affine.b))};
}

static bool insert_block(Walker *walker, const DxfEntity *insert, const Place *place, size_t layer) {
    const DxfBlock *block = dxf_file_block(walker->file, insert->block);
    DxfRole role = (DxfRole)walker->file->layers[layer].role;
    if (!block) {
        import_report_leave(walker->builder->report, 1, "blocks missing from the file");
        return true;
    }
    if (place->depth == DEEPEST) {
        walker->builder->line = insert->line;
        return house_builder_fail(walker->builder, "blocks are nested too deeply: \"%.*s\" may contain itself",
                                  text_fitting(insert->block, 60), insert->block);
    }
    Affine outer = of_entity(place, insert);
    bool good = true;
    for (int row = 0; row < (insert->rows > 1 ? insert->rows : 1) && good; row++)
        for (int column = 0; column < (insert->columns > 1 ? insert->columns : 1) && good; column++) {
            Affine own = of_insert(insert, block, column, row);
            Place inside = {compose(&outer, &own), layer, place->role, place->instance, place->depth + 1};
            begin_instance(walker, block, role, &inside);
            walker->visits++;
            good = visit_all(walker, block->first, block->count, &inside);
        }
    return good;
}

/* All of it ------------------------------------------------------------------------------------------------------- */

static bool visit(Walker *walker, const DxfEntity *entity, const Place *place) {
    ImportReport *report = walker->builder->report;
    size_t layer = layer_of(walker, entity, place);
    const DxfLayer *own = &walker->file->layers[layer];
    DxfRole role = place->role != DXF_UNKNOWN ? place->role : (DxfRole)own->role;
    if (entity->on_paper || own->hidden) {
        import_report_leave(report, 1, "things on %s", own->hidden ? "layers that are off or frozen" : "paper");
        return true;
    }
    if (entity->kind == DXF_INSERT)
        return insert_block(walker, entity, place, layer);
    if (strcmp(entity->type, "SEQEND") == 0) /* the end of an entity of several parts */
        return true;
    if (entity->kind >= DXF_OTHER) {
        const char *type = *entity->type ? entity->type : "entities without a name";
        import_report_leave(report, 1, "%.*s", text_fitting(type, 30), type);
        return true;
    }
    if (role == DXF_UNKNOWN || role == DXF_NOTHING) {
        import_report_leave(report, 1, "lines on layer %.*s", text_fitting(own->name, 40), own->name);
        return true;
    }
    return entity->kind == DXF_ARC ? add_arc(walker, entity, place, role) : add_lines(walker, entity, place, role);
}

static bool visit_all(Walker *walker, size_t first, size_t count, const Place *place) {
    bool good = true;
    for (size_t e = first; e < first + count && good; e++)
        good = ++walker->visits <= MOST_VISITS
                   ? visit(walker, &walker->file->entities[e], place)
                   : house_builder_fail(walker->builder, "blocks hold more than %d things in all, must hold fewer",
                                        MOST_VISITS);
    return good &&
           (walker->visits <= MOST_VISITS ||
            house_builder_fail(walker->builder, "blocks are put in more than %d places, must be fewer", MOST_VISITS));
}

bool dxf_shapes_find(DxfShapes *shapes, const DxfFile *file, HouseBuilder *builder) {
    Walker walker = {.shapes = shapes, .file = file, .builder = builder};
    Place model = {.affine = {.a = 1, .d = 1}, .layer = SIZE_MAX, .instance = SIZE_MAX};
    return visit_all(&walker, file->model, file->model_count, &model);
}

void dxf_shapes_clear(DxfShapes *shapes) {
    memory_free(shapes->list);
    memory_free(shapes->points);
    memory_free(shapes->instances);
    *shapes = (DxfShapes){0};
}
