#include "base/json.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"

/* Reports a syntax error found by jansson. Jansson points at the end of a token; a reader looks for its beginning. */
static void fault_syntax(const char *path, const char *text, const json_error_t *error, Fault *fault) {
    if (!text[strspn(text, " \t\r\n")]) {
        fault_add(fault, "%s:1:1: empty, must hold one object { ... }", path);
        return;
    }
    int line = error->line > 0 ? error->line : 1, column = error->column > 0 ? error->column : 1;
    const char *near = strstr(error->text, " near '"), *what = error->text;
    const char *end = near ? strrchr(near, '\'') : NULL;
    for (const char *c = near ? near + strlen(" near '") + 1 : NULL; c && c < end && column > 1; c++)
        column -= ((unsigned char)*c & 0xc0) != 0x80;
    near = near ? near : "";
    switch (json_error_code(error)) {
    case json_error_duplicate_key:
        fault_add(fault, "%s:%d:%d: key given twice%s, must be there once", path, line, column, near);
        break;
    case json_error_numeric_overflow:
        fault_add(fault, "%s:%d:%d: number too large%s", path, line, column, near);
        break;
    case json_error_stack_overflow:
        fault_add(fault, "%s:%d:%d: nested too deeply%s", path, line, column, near);
        break;
    case json_error_null_character:
        fault_add(fault, "%s:%d:%d: a text must not hold \\u0000%s", path, line, column, near);
        break;
    case json_error_invalid_utf8:
        fault_add(fault, "%s:%d:%d: not UTF-8: %s", path, line, column, what);
        break;
    default:
        fault_add(fault, "%s:%d:%d: not JSON: %s", path, line, column, what);
    }
}

/* Parses a text. The file owns the text from then on; after an error the text is released. */
static bool read_values(JsonFile *file, const char *path, char *text, size_t size, Fault *fault) {
    static const char mark[] = "\xef\xbb\xbf"; /* byte order mark, which some editors write before UTF-8 */
    if (strncmp(text, mark, strlen(mark)) == 0) {
        size -= strlen(mark);
        memmove(text, text + strlen(mark), size + 1);
    }
    json_error_t error;
    json_t *root = json_loadb(text, size, JSON_REJECT_DUPLICATES, &error);
    if (!root) {
        fault_syntax(path, text, &error, fault);
        memory_free(text);
        return false;
    }
    file->path = file->own_path = text_copy(path);
    file->text = text;
    file->root = root;
    return true;
}

static void *take(size_t size) {
    return memory_zeroed(1, size);
}

void json_use_memory(void) {
    json_set_alloc_funcs(take, memory_free);
}

bool json_read(JsonFile *file, const char *path, Fault *fault) {
    size_t size = 0;
    char *text = text_read_file(path, JSON_LARGEST_FILE, &size);
    if (!text) {
        fault_add(fault, "%s:1:1: cannot be read: %s", path, text_read_reason(errno));
        return false;
    }
    return read_values(file, path, text, size, fault);
}

bool json_read_memory(JsonFile *file, const char *path, const char *text, Fault *fault) {
    return read_values(file, path, text_copy(text), strlen(text), fault);
}

void json_free(JsonFile *file) {
    json_decref(file->root);
    memory_free(file->text);
    memory_free(file->own_path);
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

/* Functions that walk over the text. They rely on jansson having accepted it. */

static bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/* Skips white space without strspn: memory checkers inspect the whole text at each call of strspn. */
static const char *skip_space(const char *at) {
    while (is_space(*at))
        at++;
    return at;
}

static const char *skip_scalar(const char *at) {
    while (*at && !is_space(*at) && *at != ',' && *at != ':' && *at != ']' && *at != '}')
        at++;
    return at;
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
            at = skip_scalar(at);
        }
    } while (depth > 0 && *at);
    return at;
}

/* True if the string that starts at `at` is the key. Jansson decodes keys with escapes. */
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

/* Advances the position to `at`, counting characters rather than bytes. */
static void move_on(JsonPlace *place, const char *from, const char *at) {
    for (const char *c = from; c < at; c++) {
        if (*c == '\n') {
            place->line++;
            place->column = 1;
        } else if (((unsigned char)*c & 0xc0) != 0x80) {
            place->column++;
        }
    }
}

static void fault_at(const JsonFile *file, const char *at, Fault *fault, const char *what) {
    if (!file->text) {
        fault_add(fault, "%s%s", file->path, what);
        return;
    }
    JsonPlace place = {1, 1};
    move_on(&place, file->text, at);
    fault_add(fault, "%s:%d:%d: %s", file->path, place.line, place.column, what);
}

static size_t children_of(const JsonNode *node) {
    return json_is_array(node->value) ? json_array_size(node->value) : json_object_size(node->value);
}

JsonPlace *json_places(const JsonNode *node) {
    size_t count = children_of(node);
    JsonPlace *places = memory_zeroed(count, sizeof *places), here = {1, 1};
    const char *from = node->file->text, *at = from ? find_value(node) + 1 : NULL;
    for (size_t i = 0; i < count && at; i++) {
        at = skip_space(at);
        if (json_is_object(node->value))
            at = skip_space(skip_space(skip_string(at)) + 1);
        move_on(&here, from, at);
        places[i] = here;
        from = at;
        at = skip_space(skip_value(at));
        at += *at == ',';
    }
    return places;
}

void json_fault(const JsonNode *node, Fault *fault, const char *format, ...) {
    if (fault->count >= FAULT_MOST) {
        fault_add(fault, "%s", ""); /* counts the error; its position is not needed */
        return;
    }
    char what[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    fault_at(node->file, node->file->text ? find_value(node) : NULL, fault, what);
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
        if (found)
            continue;
        if (fault->count >= FAULT_MOST) {
            fault_add(fault, "%s", ""); /* counts the error, as in json_fault */
            continue;
        }
        const char *nearest = text_nearest(key, known, count);
        char what[256], list[160] = "";
        if (nearest) {
            snprintf(what, sizeof what, "unknown key \"%.60s\", did you mean \"%s\"?", key, nearest);
        } else {
            for (size_t i = 0, used = 0; i < count && used + strlen(known[i]) + 3 < sizeof list; i++)
                used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", known[i]);
            snprintf(what, sizeof what, "unknown key \"%.60s\", known are %s", key, list);
        }
        fault_at(object->file, object->file->text ? find_key(find_value(object), key) : NULL, fault, what);
    }
}

bool json_check_header(const JsonNode *root, const char *what, const char *format, Fault *fault) {
    size_t before = fault->total;
    if (!json_is_object(root->value)) {
        json_fault(root, fault, "a %s must be an object { ... }", what);
        return false;
    }
    JsonNode said = json_member(root, "format"), version = json_member(root, "version");
    const char *word = json_string_value(said.value);
    if (!said.value)
        json_fault(root, fault, "a %s has no \"format\", must be \"%s\"", what, format);
    else if (!word)
        json_fault(&said, fault, "format must be \"%s\"", format);
    else if (strcmp(word, format) != 0)
        json_fault(&said, fault, "format is \"%.40s\", must be \"%s\"", word, format);
    if (!version.value)
        json_fault(root, fault, "a %s has no \"version\", must be 1", what);
    else if (json_number_value(version.value) != 1)
        json_fault(&version, fault, "version must be 1");
    return fault->total == before || !said.value || !version.value;
}

const char *json_read_text(const JsonNode *object, const char *key, Arena *arena, Fault *fault) {
    JsonNode node = json_member(object, key);
    if (json_is_string(node.value))
        return arena_text(arena, json_string_value(node.value));
    if (node.value)
        json_fault(&node, fault, "%s must be a text", key);
    return "";
}

/* Appends the fewest digits that give the same bits, always recognisable as a real number. */
static void line_add_real(Text *line, double value) {
    char number[TEXT_NUMBER];
    text_of_number(number, value, 15);
    text_add(line, number);
    if (!number[strcspn(number, ".e")])
        text_add(line, ".0");
}

static void line_add_scalar(Text *line, const json_t *value) {
    if (json_is_real(value)) {
        line_add_real(line, json_real_value(value));
        return;
    }
    char *text = json_dumps(value, JSON_ENCODE_ANY);
    if (text)
        text_add(line, text);
    memory_free(text);
}

static void line_add_value(Text *line, const json_t *value) {
    bool array = json_is_array(value);
    if (!array && !json_is_object(value)) {
        line_add_scalar(line, value);
        return;
    }
    text_add(line, array ? "[" : "{");
    for (size_t i = 0; array && i < json_array_size(value); i++) {
        text_add(line, i ? ", " : "");
        line_add_value(line, json_array_get(value, i));
    }
    const char *between = "", *key;
    json_t *member;
    json_object_foreach((json_t *)(uintptr_t)value, key, member) {
        json_t *name = json_string(key);
        text_add(line, between);
        line_add_scalar(line, name);
        text_add(line, ": ");
        line_add_value(line, member);
        json_decref(name);
        between = ", ";
    }
    text_add(line, array ? "]" : "}");
}

char *json_line(const json_t *value) {
    Text line = {0};
    text_add(&line, "");
    line_add_value(&line, value);
    return line.text;
}

json_t *json_number(double value) {
    if (fabs(value) < 1e15 && value == floor(value))
        return json_integer((json_int_t)value);
    return json_real(value);
}
