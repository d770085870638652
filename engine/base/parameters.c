#include "base/parameters.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/choice.h"
#include "base/parameters_number.h"
#include "base/text.h"

enum { NAMES_MOST = 64 /* rows of the longest table, choices of the longest list */ };

static void *field(const Parameter *row, void *object) {
    return (char *)object + row->offset;
}

static const void *const_field(const Parameter *row, const void *object) {
    return (const char *)object + row->offset;
}

void parameters_reset(const ParameterTable *table, void *object) {
    for (size_t i = 0; i < table->count; i++) {
        const Parameter *row = &table->rows[i];
        void *place = field(row, object);
        switch (row->kind) {
        case PARAMETER_NUMBER:
            *(double *)place = row->fallback;
            break;
        case PARAMETER_WHOLE:
        case PARAMETER_CHOICE:
            *(int *)place = (int)row->fallback;
            break;
        case PARAMETER_FLAG:
            *(bool *)place = row->fallback != 0;
            break;
        case PARAMETER_TEXT:
        case PARAMETER_ID:
            *(const char **)place = "";
            break;
        case PARAMETER_IDS:
            *(Ids *)place = (Ids){0};
            break;
        case PARAMETER_NUMBERS:
            *(NumberList *)place = (NumberList){0};
            break;
        case PARAMETER_POINT:
            *(Vec2 *)place = (Vec2){0, 0};
            break;
        case PARAMETER_POINTS:
            *(Points *)place = (Points){0};
            break;
        case PARAMETER_TABLE:
            parameters_reset(row->table, place);
            break;
        }
    }
}

const char *parameters_unit(const Parameter *row) {
    return row->unit[0] && strcmp(row->unit, "1") != 0 ? row->unit : "";
}

static bool read_number(const Parameter *row, const JsonNode *node, double *value, Fault *fault) {
    const char *unit = parameters_unit(row);
    if (!json_is_number(node->value)) {
        json_fault(node, fault, "%s must be a number%s%s", row->name, *unit ? " in " : "", unit);
        return false;
    }
    double read = json_number_value(node->value);
    if (!(read >= row->low && read <= row->high)) {
        if (row->high < HUGE_VAL)
            json_fault(node, fault, "%s is %g, must be from %g to %g%s%s", row->name, read, row->low, row->high,
                       *unit ? " " : "", unit);
        else
            json_fault(node, fault, "%s is %g, must be at least %g%s%s", row->name, read, row->low, *unit ? " " : "",
                       unit);
        return false;
    }
    *value = read;
    return true;
}

static bool read_point(const JsonNode *node, const char *name, Vec2 *value, Fault *fault) {
    const json_t *x = json_array_get(node->value, 0), *y = json_array_get(node->value, 1);
    if (json_array_size(node->value) != 2 || !json_is_number(x) || !json_is_number(y)) {
        json_fault(node, fault, "%s must be a point [x, y] in m", name);
        return false;
    }
    Vec2 read = {json_number_value(x), json_number_value(y)};
    if (!(fabs(read.x) <= PARAMETER_FARTHEST && fabs(read.y) <= PARAMETER_FARTHEST)) {
        json_fault(node, fault, "%s is (%g, %g), coordinates must be from %g to %g m", name, read.x, read.y,
                   -PARAMETER_FARTHEST, PARAMETER_FARTHEST);
        return false;
    }
    *value = read;
    return true;
}

static bool read_points(const Parameter *row, const JsonNode *node, Points *value, Arena *arena, Fault *fault) {
    size_t count = json_array_size(node->value);
    bool flat = count && !json_is_array(json_array_get(node->value, 0));
    if (!json_is_array(node->value) || flat || (double)count < row->low) {
        json_fault(node, fault, "%s must be a list of at least %g points [x, y] in m", row->name, row->low);
        return false;
    }
    Points read = {arena_allocate(arena, count * sizeof(Vec2)), count};
    bool good = true;
    for (size_t i = 0; i < count; i++) {
        JsonNode element = json_element(node, i);
        char name[80];
        snprintf(name, sizeof name, "%.40s %zu", row->name, i + 1);
        good &= read_point(&element, name, &read.at[i], fault);
    }
    if (good)
        *value = read;
    return good;
}

static bool read_text(const Parameter *row, const JsonNode *node, const char **value, Arena *arena, Fault *fault) {
    const char *text = json_string_value(node->value);
    if (!text) {
        json_fault(node, fault, "%s%s must be a text", row->kind == PARAMETER_IDS ? "each of " : "", row->name);
        return false;
    }
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
    if (row->kind != PARAMETER_TEXT && (!*text || text[strspn(text, letters)])) {
        json_fault(node, fault, "%s is \"%.60s\", must be one or more letters, digits, - or _", row->name, text);
        return false;
    }
    *value = arena_text(arena, text);
    return true;
}

static bool read_ids(const Parameter *row, const JsonNode *node, Ids *value, Arena *arena, Fault *fault) {
    if (!json_is_array(node->value)) {
        json_fault(node, fault, "%s must be a list of ids", row->name);
        return false;
    }
    size_t count = json_array_size(node->value);
    Ids read = {arena_allocate(arena, count * sizeof(char *)), count};
    bool good = true;
    for (size_t i = 0; i < count; i++) {
        JsonNode element = json_element(node, i);
        good &= read_text(row, &element, &read.at[i], arena, fault);
    }
    if (good)
        *value = read;
    return good;
}

static bool read_numbers(const Parameter *row, const JsonNode *node, NumberList *value, Arena *arena, Fault *fault) {
    const char *unit = parameters_unit(row);
    if (!json_is_array(node->value)) {
        json_fault(node, fault, "%s must be a list of numbers%s%s", row->name, *unit ? " in " : "", unit);
        return false;
    }
    size_t count = json_array_size(node->value);
    NumberList read = {arena_allocate(arena, count * sizeof(double)), count};
    bool good = true;
    for (size_t i = 0; i < count; i++) {
        JsonNode element = json_element(node, i);
        char name[80];
        snprintf(name, sizeof name, "%.40s %zu", row->name, i + 1);
        Parameter one = *row;
        one.name = name;
        good &= read_number(&one, &element, &read.at[i], fault);
    }
    if (good)
        *value = read;
    return good;
}

static bool read_choice(const Parameter *row, const JsonNode *node, int *value, Fault *fault) {
    const char *word = json_string_value(node->value);
    int place = word ? choice_place(row->choices, word) : -1;
    if (place < 0) {
        char list[200];
        choice_list(row->choices, list, sizeof list);
        if (word)
            json_fault(node, fault, "%s is \"%.40s\", must be %s", row->name, word, list);
        else
            json_fault(node, fault, "%s must be %s", row->name, list);
        return false;
    }
    *value = place;
    return true;
}

bool parameters_read_value(const Parameter *row, void *object, const JsonNode *node, Arena *arena, Fault *fault) {
    void *place = field(row, object);
    switch (row->kind) {
    case PARAMETER_NUMBER:
        return read_number(row, node, place, fault);
    case PARAMETER_WHOLE: {
        double read;
        if (!read_number(row, node, &read, fault))
            return false;
        if (read != floor(read)) {
            json_fault(node, fault, "%s is %g, must be a whole number", row->name, read);
            return false;
        }
        *(int *)place = (int)read;
        return true;
    }
    case PARAMETER_FLAG:
        if (!json_is_boolean(node->value)) {
            json_fault(node, fault, "%s must be true or false", row->name);
            return false;
        }
        *(bool *)place = json_is_true(node->value);
        return true;
    case PARAMETER_CHOICE:
        return read_choice(row, node, place, fault);
    case PARAMETER_TEXT:
    case PARAMETER_ID:
        return read_text(row, node, place, arena, fault);
    case PARAMETER_IDS:
        return read_ids(row, node, place, arena, fault);
    case PARAMETER_NUMBERS:
        return read_numbers(row, node, place, arena, fault);
    case PARAMETER_POINT:
        return read_point(node, row->name, place, fault);
    case PARAMETER_POINTS:
        return read_points(row, node, place, arena, fault);
    case PARAMETER_TABLE:
        return parameters_read(row->table, place, node, arena, fault);
    }
    return false;
}

bool parameters_read(const ParameterTable *table, void *object, const JsonNode *node, Arena *arena, Fault *fault) {
    parameters_reset(table, object);
    if (!json_is_object(node->value)) {
        json_fault(node, fault, "%s must be an object { ... }", table->what);
        return false;
    }
    size_t before = fault->total;
    const char *names[NAMES_MOST + 1] = {0};
    for (size_t i = 0; i < table->count; i++)
        names[i] = table->rows[i].name;
    json_check_keys(node, names, fault);
    bool good = fault->total == before;
    for (size_t i = 0; i < table->count; i++) {
        const Parameter *row = &table->rows[i];
        JsonNode member = json_member(node, row->name);
        if (member.value) {
            good &= parameters_read_value(row, object, &member, arena, fault);
        } else if (row->needed) {
            json_fault(node, fault, "%s has no \"%s\" (%s)", table->what, row->name, row->meaning);
            good = false;
        }
    }
    return good;
}

static json_t *write_point(Vec2 point) {
    return json_pack("[o,o]", json_number(point.x), json_number(point.y));
}

static bool at_fallback(const Parameter *row, const void *object) {
    const void *place = const_field(row, object);
    switch (row->kind) {
    case PARAMETER_NUMBER:
        return *(const double *)place == row->fallback;
    case PARAMETER_WHOLE:
    case PARAMETER_CHOICE:
        return *(const int *)place == (int)row->fallback;
    case PARAMETER_FLAG:
        return *(const bool *)place == (row->fallback != 0);
    case PARAMETER_TEXT:
    case PARAMETER_ID:
        return !**(const char *const *)place;
    case PARAMETER_IDS:
        return !((const Ids *)place)->count;
    case PARAMETER_NUMBERS:
        return !((const NumberList *)place)->count;
    case PARAMETER_POINT:
        return false;
    case PARAMETER_POINTS:
        return !((const Points *)place)->count;
    case PARAMETER_TABLE:
        for (size_t i = 0; i < row->table->count; i++)
            if (!at_fallback(&row->table->rows[i], place))
                return false;
        return true;
    }
    return false;
}

static json_t *write_value(const Parameter *row, const void *object) {
    const void *place = const_field(row, object);
    switch (row->kind) {
    case PARAMETER_NUMBER:
        return json_number(*(const double *)place);
    case PARAMETER_WHOLE:
        return json_integer(*(const int *)place);
    case PARAMETER_FLAG:
        return json_boolean(*(const bool *)place);
    case PARAMETER_CHOICE:
        return parameters_number_json(row, *(const int *)place);
    case PARAMETER_TEXT:
    case PARAMETER_ID:
        return json_string(*(const char *const *)place);
    case PARAMETER_IDS: {
        const Ids *ids = place;
        json_t *written = json_array();
        for (size_t i = 0; i < ids->count; i++)
            json_array_append_new(written, json_string(ids->at[i]));
        return written;
    }
    case PARAMETER_NUMBERS: {
        const NumberList *numbers = place;
        json_t *written = json_array();
        for (size_t i = 0; i < numbers->count; i++)
            json_array_append_new(written, json_number(numbers->at[i]));
        return written;
    }
    case PARAMETER_POINT:
        return write_point(*(const Vec2 *)place);
    case PARAMETER_POINTS: {
        const Points *points = place;
        json_t *written = json_array();
        for (size_t i = 0; i < points->count; i++)
            json_array_append_new(written, write_point(points->at[i]));
        return written;
    }
    case PARAMETER_TABLE:
        return parameters_write(row->table, place);
    }
    return NULL;
}

json_t *parameters_write(const ParameterTable *table, const void *object) {
    json_t *written = json_object();
    for (size_t i = 0; i < table->count; i++) {
        const Parameter *row = &table->rows[i];
        if (row->needed || !at_fallback(row, object))
            json_object_set_new(written, row->name, write_value(row, object));
    }
    return written;
}

char *parameters_words(const Parameter *row, const void *object) {
    json_t *value = write_value(row, object);
    char *words = !value                   ? text_copy("never") /* infinite: JSON has no such number */
                  : json_is_boolean(value) ? text_copy(json_is_true(value) ? "yes" : "no")
                  : json_is_string(value)  ? text_copy(json_string_value(value))
                                           : json_line(value);
    json_decref(value);
    return words;
}

static const char *leaf(const char *name) {
    const char *dot = strrchr(name, '.');
    return dot ? dot + 1 : name;
}

const Parameter *parameters_find(const ParameterTable *table, const char *name) {
    const Parameter *found = NULL;
    size_t leaves = 0;
    for (size_t i = 0; i < table->count; i++) {
        if (strcmp(table->rows[i].name, name) == 0)
            return &table->rows[i];
        if (strcmp(leaf(table->rows[i].name), name) == 0) {
            found = &table->rows[i];
            leaves++;
        }
    }
    return leaves == 1 ? found : NULL;
}

/* Lists the rows whose last part is `name`, as "space.friction or contact.friction". Returns false if there are none.
 */
static bool list_namesakes(const ParameterTable *table, const char *name, char *list, size_t size) {
    size_t used = 0;
    for (size_t i = 0; i < table->count && used < size; i++)
        if (strcmp(leaf(table->rows[i].name), name) == 0)
            used += (size_t)snprintf(list + used, size - used, "%s%s", used ? " or " : "", table->rows[i].name);
    return used;
}

void parameters_fault_unknown(const ParameterTable *table, const char *name, const JsonNode *node, Fault *fault) {
    if (fault->count >= FAULT_MOST) {
        json_fault(node, fault, "%s", ""); /* counts the error */
        return;
    }
    const char *names[2 * NAMES_MOST];
    size_t count = 0;
    for (size_t i = 0; i < table->count; i++) {
        names[count++] = table->rows[i].name;
        names[count++] = leaf(table->rows[i].name);
    }
    const char *nearest = text_nearest(name, names, count);
    char namesakes[200];
    if (list_namesakes(table, name, namesakes, sizeof namesakes))
        json_fault(node, fault, "%s parameter \"%.60s\" must be %s", table->what, name, namesakes);
    else if (nearest)
        json_fault(node, fault, "%s has no parameter \"%.60s\", did you mean \"%s\"?", table->what, name, nearest);
    else {
        char known[300] = "";
        for (size_t i = 0, used = 0; i < table->count && used + strlen(table->rows[i].name) + 3 < sizeof known; i++)
            used += (size_t)snprintf(known + used, sizeof known - used, "%s%s", i ? ", " : "", table->rows[i].name);
        json_fault(node, fault, "%s has no parameter \"%.60s\", it has %s", table->what, name, known);
    }
}

bool parameters_set_number(const Parameter *row, void *object, double value, Fault *fault) {
    if (!isfinite(value)) {
        fault_add(fault, "%s must be a number", row->name);
        return false;
    }
    char place[] = "";
    Arena none = {0}; /* numbers need no memory */
    JsonFile file = {.path = place, .root = parameters_number_json(row, value)};
    JsonNode node = json_root(&file);
    bool good = parameters_read_value(row, object, &node, &none, fault);
    json_decref(file.root);
    return good;
}
