#include "lesson/difference.h"

#include <jansson.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/memory.h"

/* What the difference of two plans counts. */
typedef struct Difference {
    double doors_wider, furniture_moved; /* m */
    size_t doors, furniture, door_shapes, others;
} Difference;

static const struct {
    const char *name, *unit;
} rows[] = {
    {"change.doors_wider", "m"}, {"change.doors", "1"},     {"change.furniture_moved", "m"},
    {"change.furniture", "1"},   {"change.not_doors", "1"}, {"change.not_furniture", "1"},
    {"change.count", "1"},
};
enum { ROWS = sizeof rows / sizeof *rows };

const char *difference_unit(const char *name) {
    for (size_t r = 0; r < ROWS; r++)
        if (strcmp(rows[r].name, name) == 0)
            return rows[r].unit;
    return NULL;
}

const char *const *difference_names(size_t *count) {
    static const char *names[ROWS];
    for (size_t r = 0; r < ROWS; r++)
        names[r] = rows[r].name;
    *count = ROWS;
    return names;
}

static json_t *values_of(const Plan *plan) {
    char *text = plan_text(plan);
    json_t *values = json_loads(text, 0, NULL);
    memory_free(text);
    return values;
}

static json_t *find(json_t *list, const char *id) {
    size_t i;
    json_t *element;
    json_array_foreach(list, i, element) {
        const char *name = json_string_value(json_object_get(element, "id"));
        if (name && strcmp(name, id) == 0)
            return element;
    }
    return NULL;
}

/* Counts the elements of a list that are changed, added or removed. */
static size_t count_changed(json_t *before, json_t *now) {
    size_t i, count = 0;
    json_t *element;
    json_array_foreach(before, i, element) {
        json_t *other = find(now, json_string_value(json_object_get(element, "id")));
        count += !other || !json_equal(element, other);
    }
    json_array_foreach(now, i, element) count += !find(before, json_string_value(json_object_get(element, "id")));
    return count;
}

/* Counts the changed elements of all members but doors and furniture. */
static size_t count_others(json_t *before, json_t *now) {
    size_t count = 0;
    const char *key;
    json_t *value;
    json_object_foreach(before, key, value) {
        json_t *other = json_object_get(now, key);
        if (strcmp(key, "doors") == 0 || strcmp(key, "furniture") == 0)
            continue;
        count += json_is_array(value) ? count_changed(value, other) : !json_equal(value, other);
    }
    json_object_foreach(now, key, value) {
        if (strcmp(key, "doors") != 0 && strcmp(key, "furniture") != 0 && !json_object_get(before, key))
            count += json_is_array(value) ? json_array_size(value) : 1;
    }
    return count;
}

static void forget_widths(json_t *doors) {
    size_t i;
    json_t *door;
    json_array_foreach(doors, i, door) json_object_del(door, "width");
}

static Difference difference_of(const Plan *before, const Plan *now) {
    json_t *a = values_of(before), *b = values_of(now);
    Difference difference = {.doors = count_changed(json_object_get(a, "doors"), json_object_get(b, "doors")),
                             .furniture =
                                 count_changed(json_object_get(a, "furniture"), json_object_get(b, "furniture")),
                             .others = count_others(a, b)};
    for (size_t d = 0; d < now->door_count; d++) {
        size_t old = plan_find_door(before, now->doors[d].id);
        if (old != SIZE_MAX)
            difference.doors_wider += fmax(0, now->doors[d].width - before->doors[old].width);
    }
    for (size_t f = 0; f < now->furniture_count; f++)
        for (size_t o = 0; o < before->furniture_count; o++)
            if (strcmp(before->furniture[o].id, now->furniture[f].id) == 0)
                difference.furniture_moved += vec2_distance(before->furniture[o].centre, now->furniture[f].centre);
    forget_widths(json_object_get(a, "doors"));
    forget_widths(json_object_get(b, "doors"));
    difference.door_shapes = count_changed(json_object_get(a, "doors"), json_object_get(b, "doors"));
    json_decref(a);
    json_decref(b);
    return difference;
}

double difference_value(const char *name, const Plan *before, const Plan *now) {
    Difference difference = difference_of(before, now);
    const double values[ROWS] = {
        difference.doors_wider,
        (double)difference.doors,
        difference.furniture_moved,
        (double)difference.furniture,
        (double)(difference.others + difference.furniture + difference.door_shapes),
        (double)(difference.others + difference.doors),
        (double)(difference.others + difference.furniture + difference.doors),
    };
    for (size_t r = 0; r < ROWS; r++)
        if (strcmp(rows[r].name, name) == 0)
            return values[r];
    return (double)NAN;
}
