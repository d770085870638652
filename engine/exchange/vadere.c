#include "exchange/vadere.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/json.h"
#include "base/text.h"
#include "exchange/bounding_rectangle.h"

static const double SLENDER = 3;         /* 1: a rectangle at least this many times longer than wide is a wall */
static const double OBSTACLE_HEIGHT = 2; /* m: assumed height, too high to look over */
static const double CLEARLY_LONGER =
    1.2;                              /* 1: a target with a larger ratio of sides is crossed along its shorter side */
static const double ROOM_EACH = 0.35; /* m2 per person, the limit of random placement */

enum {
    CIRCLE_SIDES = 24,
    SHAPE_POINTS = 10000, /* points in a shape */
    VIA_MOST = 50,        /* targets of a route */
};

/* The outline of a shape. */
typedef struct Shape {
    Vec2 *points; /* (count); released by memory_free */
    size_t count;
} Shape;

typedef struct Target {
    int id;
    size_t place; /* among all targets of the file */
    Vec2 middle;
    size_t exit; /* SIZE_MAX: an intermediate target */
} Target;

typedef struct Reader {
    HouseBuilder *builder;
    JsonFile file;
    Arena arena;
    double unit;     /* m */
    Vec2 sources;    /* mean position of the sources */
    Target *targets; /* (target_count) sorted by id, then by place */
    size_t target_count;
    size_t later; /* number of sources that add people later */
} Reader;

/* Values ---------------------------------------------------------------------------------------------------------- */

/* Adds the error at the node, once. */
static bool fail_at(Reader *reader, const JsonNode *node, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
static bool fail_at(Reader *reader, const JsonNode *node, const char *format, ...) {
    if (reader->builder->failed)
        return false;
    reader->builder->failed = true;
    va_list arguments;
    va_start(arguments, format);
    char *what = text_printed(format, arguments);
    va_end(arguments);
    json_fault(node, reader->builder->fault, "%s", what);
    memory_free(what);
    return false;
}

/* Returns a finite number, or `fallback` if the key is absent. */
static double number(const json_t *object, const char *key, double fallback) {
    const json_t *value = json_object_get(object, key);
    return json_is_number(value) && isfinite(json_number_value(value)) ? json_number_value(value) : fallback;
}

static Vec2 point(const Reader *reader, const json_t *object) {
    return vec2_scale(vec2(number(object, "x", NAN), number(object, "y", NAN)), reader->unit);
}

/* Returns the length of that key in m, NAN after an error; `what` names the object in errors, "the CIRCLE". */
static double read_length(Reader *reader, const JsonNode *object, const char *what, const char *key) {
    JsonNode node = json_member(object, key);
    double length = json_number_value(node.value) * reader->unit;
    if (!node.value)
        fail_at(reader, object, "%s has no \"%s\", must have one", what, key);
    else if (!json_is_number(node.value))
        fail_at(reader, &node, "%s must be a number", key);
    else if (!(fabs(length) < PARAMETER_FARTHEST))
        fail_at(reader, &node, "%s is %g m, must be within %g m", key, length, PARAMETER_FARTHEST);
    else
        return length;
    return NAN;
}

/* Reads a length that must be positive. */
static double read_size(Reader *reader, const JsonNode *object, const char *what, const char *key) {
    double size = read_length(reader, object, what, key);
    JsonNode node = json_member(object, key);
    if (size <= 0)
        fail_at(reader, &node, "%s is %g, must be more than 0", key, json_number_value(node.value));
    return size;
}

static Vec2 read_point(Reader *reader, const JsonNode *object, const char *what) {
    double x = read_length(reader, object, what, "x");
    return vec2(x, read_length(reader, object, what, "y"));
}

static Vec2 read_extent(Reader *reader, const JsonNode *object, const char *what) {
    double width = read_size(reader, object, what, "width");
    return vec2(width, read_size(reader, object, what, "height"));
}

static size_t list_size(const JsonNode *node) {
    return json_array_size(node->value);
}

/* Shapes ---------------------------------------------------------------------------------------------------------- */

static void set_rectangle(Shape *shape, Vec2 low, Vec2 high) {
    shape->points = memory_zeroed(4, sizeof *shape->points);
    Vec2 corners[4] = {low, {high.x, low.y}, high, {low.x, high.y}};
    memcpy(shape->points, corners, sizeof corners);
    shape->count = 4;
}

static void set_circle(Shape *shape, Vec2 centre, double radius) {
    shape->points = memory_zeroed(CIRCLE_SIDES, sizeof *shape->points);
    for (size_t i = 0; i < CIRCLE_SIDES; i++)
        shape->points[i] = vec2_along(centre, radius, vec2_heading(2 * M_PI * (double)i / CIRCLE_SIDES));
    shape->count = CIRCLE_SIDES;
}

static bool set_polygon(Reader *reader, Shape *shape, const JsonNode *node) {
    JsonNode points = json_member(node, "points");
    size_t count = list_size(&points);
    if (count < 3 || count > SHAPE_POINTS)
        return fail_at(reader, node,
                       count < 3 ? "a polygon must have three points or more"
                                 : "a polygon has more than 10000 points, must have fewer");
    shape->points = memory_zeroed(count, sizeof *shape->points);
    for (size_t i = 0; i < count && !reader->builder->failed; i++) {
        JsonNode corner = json_element(&points, i);
        shape->points[i] = read_point(reader, &corner, "the point");
    }
    shape->count = count;
    return true;
}

static bool set_round(Reader *reader, Shape *shape, const JsonNode *node) {
    JsonNode centre = json_member(node, "center");
    if (!centre.value)
        return fail_at(reader, node, "the CIRCLE has no \"center\", must have one");
    Vec2 middle = read_point(reader, &centre, "the center");
    set_circle(shape, middle, read_size(reader, node, "the CIRCLE", "radius"));
    return true;
}

static bool is_somewhere(Reader *reader, const Shape *shape, const JsonNode *node) {
    for (size_t i = 0; i < shape->count && !reader->builder->failed; i++)
        if (!(fabs(shape->points[i].x) < PARAMETER_FARTHEST && fabs(shape->points[i].y) < PARAMETER_FARTHEST))
            fail_at(reader, node, "the shape must lie within %g m", PARAMETER_FARTHEST);
    return !reader->builder->failed;
}

/* Reads the member "shape" of an element. False after an error. */
static bool read_shape(Reader *reader, const JsonNode *element, Shape *shape) {
    JsonNode node = json_member(element, "shape");
    const char *type = json_string_value(json_object_get(node.value, "type"));
    *shape = (Shape){0};
    if (type && strcmp(type, "RECTANGLE") == 0) {
        Vec2 low = read_point(reader, &node, "the RECTANGLE");
        set_rectangle(shape, low, vec2_add(low, read_extent(reader, &node, "the RECTANGLE")));
    } else if (type && strcmp(type, "CIRCLE") == 0) {
        if (!set_round(reader, shape, &node))
            return false;
    } else if (type && strcmp(type, "POLYGON") == 0) {
        if (!set_polygon(reader, shape, &node))
            return false;
    } else {
        return fail_at(reader, element, "has no shape of type RECTANGLE, POLYGON or CIRCLE");
    }
    if (is_somewhere(reader, shape, &node))
        return true;
    memory_free(shape->points);
    return false;
}

static Vec2 middle_of(const Shape *shape) {
    Vec2 sum = {0, 0};
    for (size_t i = 0; i < shape->count; i++)
        sum = vec2_add(sum, shape->points[i]);
    return vec2_scale(sum, 1 / (double)shape->count);
}

static double area_of(const Shape *shape) {
    double area = 0;
    for (size_t i = 0; i < shape->count; i++)
        area += vec2_cross(vec2_sub(shape->points[i], shape->points[0]),
                           vec2_sub(shape->points[(i + 1) % shape->count], shape->points[0])) /
                2;
    return fabs(area);
}

/* True if the shape is its own bounding rectangle. */
static bool is_rectangle(const Shape *shape, const Rectangle *box) {
    return fabs(area_of(shape) - box->size.x * box->size.y) < 1e-6 * box->size.x * box->size.y;
}

/* Calls `take` with each element of a topography list and its shape. False after an error. */
static bool each(Reader *reader, const JsonNode *topography, const char *key,
                 void (*take)(Reader *reader, const JsonNode *element, const Shape *shape)) {
    JsonNode list = json_member(topography, key);
    bool good = true;
    for (size_t i = 0; i < list_size(&list) && good; i++) {
        JsonNode element = json_element(&list, i);
        Shape shape;
        good = read_shape(reader, &element, &shape);
        if (good) {
            take(reader, &element, &shape);
            memory_free(shape.points);
        }
        good &= !reader->builder->failed;
    }
    return good;
}

/* Walls ----------------------------------------------------------------------------------------------------------- */

static void add_rectangle(HouseBuilder *builder, const Rectangle *box) {
    if (box->size.y > 0 && box->size.x < SLENDER * box->size.y) {
        house_builder_piece(builder, "obstacle", box->centre, box->size, box->angle, OBSTACLE_HEIGHT);
        return;
    }
    Vec2 half = vec2_scale(vec2_heading(radians(box->angle)), box->size.x / 2);
    Vec2 ends[2] = {vec2_sub(box->centre, half), vec2_add(box->centre, half)};
    house_builder_wall(builder, ends, 2, box->size.y, OBSTACLE_HEIGHT);
}

static void add_outline(HouseBuilder *builder, const Shape *shape) {
    Vec2 *ring = memory_zeroed(shape->count + 1, sizeof *ring);
    memcpy(ring, shape->points, shape->count * sizeof *ring);
    ring[shape->count] = ring[0];
    house_builder_wall(builder, ring, shape->count + 1, 0, OBSTACLE_HEIGHT);
    memory_free(ring);
}

static void take_obstacle(Reader *reader, const JsonNode *element, const Shape *shape) {
    (void)element;
    Rectangle box = bounding_rectangle_of(shape->points, shape->count);
    if (is_rectangle(shape, &box))
        add_rectangle(reader->builder, &box);
    else
        add_outline(reader->builder, shape);
}

/* Adds the frame, which lies inside the bounds. */
static bool add_frame(Reader *reader, const JsonNode *topography) {
    JsonNode attributes = json_member(topography, "attributes"), bounds = json_member(&attributes, "bounds");
    if (!json_is_object(bounds.value))
        return fail_at(reader, topography, "the topography has no attributes with bounds");
    if (json_is_false(json_object_get(attributes.value, "bounded")))
        return true;
    double thick = number(attributes.value, "boundingBoxWidth", 0) * reader->unit;
    Vec2 low = read_point(reader, &bounds, "the bounds object");
    Vec2 size = read_extent(reader, &bounds, "the bounds object");
    if (reader->builder->failed)
        return false;
    if (!(size.x > 2 * thick && size.y > 2 * thick && thick >= 0))
        return fail_at(reader, &bounds, "the bounds must be wider and higher than twice the boundingBoxWidth");
    Vec2 a = vec2_add(low, vec2(thick / 2, thick / 2)), b = vec2_sub(vec2_add(low, size), vec2(thick / 2, thick / 2));
    Vec2 ring[5] = {a, {b.x, a.y}, b, {a.x, b.y}, a};
    house_builder_wall(reader->builder, ring, 5, thick, 0);
    return !reader->builder->failed;
}

/* Targets --------------------------------------------------------------------------------------------------------- */

/* Adds an exit: a line across the middle of the target along its longer side, or for a square across the direction
 * from the sources. */
static size_t add_exit(Reader *reader, const Shape *shape) {
    Rectangle box = bounding_rectangle_of(shape->points, shape->count);
    Vec2 along = vec2_heading(radians(box.angle));
    double half = box.size.x / 2;
    if (box.size.x < CLEARLY_LONGER * box.size.y) {
        Vec2 way = vec2_sub(box.centre, reader->sources);
        if (fabs(vec2_dot(way, along)) > fabs(vec2_cross(along, way))) {
            along = vec2_left(along);
            half = box.size.y / 2;
        }
    }
    return house_builder_exit(reader->builder, vec2_along(box.centre, -half, along),
                              vec2_along(box.centre, half, along));
}

static bool absorbs(const json_t *target) {
    const json_t *absorber = json_object_get(target, "absorber");
    const json_t *before = json_object_get(target, "absorbing"); /* up to release 2.1 */
    return absorber ? json_is_true(json_object_get(absorber, "enabled")) : !json_is_false(before);
}

static void take_target(Reader *reader, const JsonNode *element, const Shape *shape) {
    Target target = {.id = (int)json_integer_value(json_object_get(element->value, "id")),
                     .place = reader->target_count,
                     .middle = middle_of(shape),
                     .exit = SIZE_MAX};
    const json_t *waiter = json_object_get(element->value, "waiter");
    if (absorbs(element->value))
        target.exit = add_exit(reader, shape);
    else
        import_report_leave(reader->builder->report, 1,
                            "non-absorbing targets, except as intermediate points of routes");
    if (json_is_true(json_object_get(waiter, "enabled")) || number(element->value, "waitingTime", 0) > 0)
        import_report_leave(reader->builder->report, 1, "waiting at targets");
    reader->targets[reader->target_count++] = target;
}

static int compare_targets(const void *a, const void *b) {
    const Target *p = a, *q = b;
    if (p->id != q->id)
        return p->id < q->id ? -1 : 1;
    return p->place < q->place ? -1 : p->place > q->place;
}

static int compare_target_ids(const void *a, const void *b) {
    const Target *p = a, *q = b;
    return p->id < q->id ? -1 : p->id > q->id;
}

/* Returns the first target of that id, or NULL. */
static const Target *find_target(const Reader *reader, int id) {
    Target wanted = {.id = id};
    const Target *found = bsearch(&wanted, reader->targets, reader->target_count, sizeof wanted, compare_target_ids);
    while (found && found > reader->targets && found[-1].id == id)
        found--;
    return found;
}

static bool read_targets(Reader *reader, const JsonNode *topography) {
    JsonNode list = json_member(topography, "targets");
    reader->targets = arena_allocate(&reader->arena, (list_size(&list) + 1) * sizeof *reader->targets);
    if (!each(reader, topography, "targets", take_target))
        return false;
    qsort(reader->targets, reader->target_count, sizeof *reader->targets, compare_targets);
    return true;
}

/* Adds the route of a person through a list of targets; the last absorbing target is the exit. */
static void add_way(Reader *reader, const char *who, const json_t *ids) {
    Vec2 via[VIA_MOST];
    size_t count = 0, exit = SIZE_MAX;
    for (size_t i = 0; i < json_array_size(ids) && exit == SIZE_MAX; i++) {
        const Target *target = find_target(reader, (int)json_integer_value(json_array_get(ids, i)));
        if (target && target->exit != SIZE_MAX)
            exit = target->exit;
        else if (target && count < VIA_MOST)
            via[count++] = target->middle;
    }
    if (exit != SIZE_MAX || count)
        house_builder_route(reader->builder, who, via, count, exit);
}

/* People ---------------------------------------------------------------------------------------------------------- */

/* The people of a source, in the keys of its release. */
typedef struct Spawning {
    double count, begin, end;
} Spawning;

static Spawning spawning_of(const json_t *source) {
    const json_t *spawner = json_object_get(source, "spawner"); /* from release 2.3 */
    if (spawner)
        return (Spawning){number(spawner, "eventElementCount", 1), number(spawner, "constraintsTimeStart", 0),
                          number(spawner, "constraintsTimeEnd", 0)};
    return (Spawning){number(source, "spawnNumber", 1), number(source, "startTime", 0), number(source, "endTime", 0)};
}

static void take_source(Reader *reader, const JsonNode *element, const Shape *shape) {
    Spawning spawning = spawning_of(element->value);
    double room = floor(area_of(shape) / ROOM_EACH), count = fmax(fmin(spawning.count, room), 1);
    if (!(spawning.count >= 1))
        return;
    if (spawning.count > count)
        import_report_leave(reader->builder->report, (size_t)fmin(spawning.count - count, 1e9),
                            "people for whom their source is too small");
    reader->later += spawning.end > spawning.begin;
    if (count > HOUSE_BUILDER_CROWD) {
        fail_at(reader, element, "a source gives more than 20000 people, must give fewer");
        return;
    }
    size_t crowd = house_builder_crowd(reader->builder, shape->points, shape->count, (size_t)count, spawning.begin);
    if (crowd != SIZE_MAX)
        add_way(reader, reader->builder->plan.crowds[crowd].id, json_object_get(element->value, "targetIds"));
}

static bool read_people(Reader *reader, const JsonNode *topography) {
    JsonNode list = json_member(topography, "dynamicElements");
    for (size_t i = 0; i < list_size(&list); i++) {
        JsonNode element = json_element(&list, i);
        const char *type = json_string_value(json_object_get(element.value, "type"));
        if (type && strcmp(type, "PEDESTRIAN") != 0) {
            import_report_leave(reader->builder->report, 1, "moving agents that are not pedestrians");
            continue;
        }
        Vec2 at = point(reader, json_object_get(element.value, "position"));
        if (!(fabs(at.x) < PARAMETER_FARTHEST && fabs(at.y) < PARAMETER_FARTHEST))
            return fail_at(reader, &element, "a pedestrian's position must be there, and within 100000 m");
        size_t person = house_builder_person(reader->builder, at, 0, number(element.value, "freeFlowSpeed", 0));
        if (person == SIZE_MAX)
            return false;
        add_way(reader, reader->builder->plan.people[person].id, json_object_get(element.value, "targetIds"));
    }
    return true;
}

/* The whole ------------------------------------------------------------------------------------------------------- */

static void take_middle(Reader *reader, const JsonNode *element, const Shape *shape) {
    (void)element;
    reader->sources = vec2_add(reader->sources, middle_of(shape));
}

static bool find_sources(Reader *reader, const JsonNode *topography) {
    JsonNode list = json_member(topography, "sources");
    bool good = each(reader, topography, "sources", take_middle);
    if (list_size(&list))
        reader->sources = vec2_scale(reader->sources, 1 / (double)list_size(&list));
    return good;
}

static void leave_the_rest(Reader *reader, const JsonNode *topography) {
    static const char *const lists[][2] = {
        {"stairs", "stairs"},
        {"measurementAreas", "measurement areas"},
        {"targetChangers", "target changers"},
        {"absorbingAreas", "absorbing areas"},
        {"aerosolClouds", "aerosol clouds"},
        {"droplets", "droplets"},
    };
    ImportReport *report = reader->builder->report;
    for (size_t l = 0; l < sizeof lists / sizeof *lists; l++)
        import_report_leave(report, json_array_size(json_object_get(topography->value, lists[l][0])), "%s",
                            lists[l][1]);
    import_report_leave(report, reader->later, "sources that spawn people later: only the first people are imported");
    if (reader->builder->plan.person_count || reader->builder->plan.crowd_count)
        import_report_note(report,
                           "people are walkers of the profile adult, not with the scenario's radius and speeds");
    if (reader->builder->plan.exit_count)
        import_report_note(report, "an exit is a line across the middle of its target");
}

static bool read_topography(Reader *reader, const JsonNode *root) {
    JsonNode scenario = json_member(root, "scenario");
    const JsonNode *above = scenario.value ? &scenario : root; /* a topography may also be the root */
    JsonNode topography = json_member(above, "topography");
    if (!json_is_object(topography.value))
        return fail_at(reader, root, "no Vadere scenario: it has no scenario with a topography");
    bool good = add_frame(reader, &topography) && each(reader, &topography, "obstacles", take_obstacle) &&
                find_sources(reader, &topography) && read_targets(reader, &topography) &&
                each(reader, &topography, "sources", take_source) && read_people(reader, &topography);
    if (good)
        leave_the_rest(reader, &topography);
    return good;
}

bool vadere_read(HouseBuilder *builder) {
    Reader reader = {.builder = builder, .unit = builder->options->unit > 0 ? builder->options->unit : 1};
    if (!json_read(&reader.file, builder->path, builder->fault))
        return false;
    JsonNode root = json_root(&reader.file);
    const char *name = json_string_value(json_object_get(root.value, "name"));
    const char *release = json_string_value(json_object_get(root.value, "release"));
    if (name)
        house_builder_name(builder, name);
    if (release)
        import_report_note(builder->report, "the scenario was written by Vadere %.20s", release);
    bool good = read_topography(&reader, &root);
    json_free(&reader.file);
    arena_clear(&reader.arena);
    return good;
}
