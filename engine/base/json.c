#include "base/json.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"

bool json_read(JsonFile *file, const char *path, Fault *fault) {
    size_t size = 0;
    char *text = text_read_file(path, JSON_LARGEST_FILE, &size);
    if (!text) {
        fault_add(fault, "%s:1:1: cannot be read: %s", path, strerror(errno));
        return false;
    }
    json_error_t error;
    json_t *root = json_loadb(text, size, JSON_REJECT_DUPLICATES, &error);
    if (!root) {
        int line = error.line > 0 ? error.line : 1, column = error.column > 0 ? error.column : 1;
        fault_add(fault, "%s:%d:%d: not JSON: %s", path, line, column, error.text);
        memory_free(text);
        return false;
    }
    file->path = memory_allocate(strlen(path) + 1, 1);
    strcpy(file->path, path);
    file->text = text;
    file->root = root;
    return true;
}

void json_free(JsonFile *file) {
    json_decref(file->root);
    memory_free(file->text);
    memory_free(file->path);
    *file = (JsonFile){0};
}

JsonNode json_root(const JsonFile *file) {
    return (JsonNode){.file = file, .value = file->root};
}

JsonNode json_member(const JsonNode *object, const char *key) {
    return (JsonNode){.file = object->file, .value = json_object_get(object->value, key), .parent = object, .key = key};
}

JsonNode json_element(const JsonNode *array, size_t index) {
    return (JsonNode){
        .file = array->file, .value = json_array_get(array->value, index), .parent = array, .index = index};
}

/* The walk over the text. It relies on jansson having accepted it. */

static const char *skip_space(const char *at) {
    return at + strspn(at, " \t\r\n");
}

static const char *skip_string(const char *at) {
    for (at++; *at && *at != '"'; at++)
        if (*at == '\\' && at[1])
            at++;
    return *at ? at + 1 : at;
}

static const char *skip_value(const char *at) {
    int depth = 0;
    do {
        at = skip_space(at);
        if (*at == '"') {
            at = skip_string(at);
        } else if (*at == '{' || *at == '[') {
            depth++;
            at++;
        } else if (*at == '}' || *at == ']') {
            depth--;
            at++;
        } else if (*at == ',' || *at == ':') {
            at++;
        } else {
            at += strcspn(at, " \t\r\n,:]}");
        }
    } while (depth > 0 && *at);
    return at;
}

/* Is the string that starts at `at` the key? Keys with escapes are decoded by jansson. */
static bool string_is(const char *at, const char *key) {
    size_t length = (size_t)(skip_string(at) - at);
    if (!memchr(at, '\\', length))
        return length == strlen(key) + 2 && memcmp(at + 1, key, length - 2) == 0;
    json_t *decoded = json_loadb(at, length, JSON_DECODE_ANY, NULL);
    const char *value = json_string_value(decoded);
    bool same = value && strcmp(value, key) == 0;
    json_decref(decoded);
    return same;
}

static const char *find_key(const char *at, const char *key) {
    at = skip_space(at + 1);
    while (*at == '"') {
        if (string_is(at, key))
            return at;
        at = skip_space(skip_value(skip_space(skip_space(skip_string(at)) + 1)));
        if (*at == ',')
            at = skip_space(at + 1);
    }
    return NULL;
}

static const char *find_value(const JsonNode *node) {
    if (!node->parent)
        return skip_space(node->file->text);
    const char *at = find_value(node->parent);
    if (node->key) {
        const char *found = *at == '{' ? find_key(at, node->key) : NULL;
        return found ? skip_space(skip_space(skip_string(found)) + 1) : at;
    }
    if (*at != '[')
        return at;
    at = skip_space(at + 1);
    for (size_t i = 0; i < node->index && *at && *at != ']'; i++) {
        at = skip_space(skip_value(at));
        if (*at == ',')
            at = skip_space(at + 1);
    }
    return at;
}

static void fault_at(const JsonFile *file, const char *at, Fault *fault, const char *what) {
    int line = 1, column = 1;
    for (const char *c = file->text; c < at; c++) {
        if (*c == '\n') {
            line++;
            column = 1;
        } else if (((unsigned char)*c & 0xc0) != 0x80) { /* count characters, not the bytes of one */
            column++;
        }
    }
    fault_add(fault, "%s:%d:%d: %s", file->path, line, column, what);
}

void json_fault(const JsonNode *node, Fault *fault, const char *format, ...) {
    if (fault->count >= FAULT_MOST)
        return;
    char what[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    fault_at(node->file, find_value(node), fault, what);
}

void json_check_keys(const JsonNode *object, const char *const *known, Fault *fault) {
    size_t count = 0;
    while (known[count])
        count++;
    const char *key;
    json_t *value;
    json_object_foreach(object->value, key, value) {
        bool found = false;
        for (size_t i = 0; i < count && !found; i++)
            found = strcmp(key, known[i]) == 0;
        if (found || fault->count >= FAULT_MOST)
            continue;
        const char *nearest = text_nearest(key, known, count);
        char what[256], list[160] = "";
        if (nearest) {
            snprintf(what, sizeof what, "unknown key \"%.60s\", did you mean \"%s\"?", key, nearest);
        } else {
            for (size_t i = 0, used = 0; i < count && used + strlen(known[i]) + 3 < sizeof list; i++)
                used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", known[i]);
            snprintf(what, sizeof what, "unknown key \"%.60s\", known are %s", key, list);
        }
        fault_at(object->file, find_key(find_value(object), key), fault, what);
    }
}

char *json_line(const json_t *value) {
    char *line = NULL;
    for (size_t digits = 15; digits <= 17; digits++) {
        json_t *again;
        memory_free(line);
        line = json_dumps(value, JSON_ENCODE_ANY | JSON_REAL_PRECISION(digits));
        if (!line)
            line = memory_allocate(1, 1);
        again = json_loads(line, JSON_DECODE_ANY, NULL);
        bool same = json_equal(again, value);
        json_decref(again);
        if (same)
            break;
    }
    return line;
}

json_t *json_number(double value) {
    if (fabs(value) < 1e15 && value == floor(value))
        return json_integer((json_int_t)value);
    return json_real(value);
}
