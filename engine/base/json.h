/* JSON by jansson, with the line and column of every value, so that a fault can point at it.
 *
 * Jansson checks the syntax and holds the values; it forgets where they stood. A place is found again, only when a
 * fault needs it, by walking the text (known to be valid) along the keys and indices that lead to the value. */
#pragma once

#include <jansson.h>
#include <stdbool.h>

#include "base/fault.h"
#include "base/memory.h"

/* A file's text and values. Owned by the caller of json_read; json_free releases it. */
typedef struct JsonFile {
    char *path; /* as given */
    char *text; /* UTF-8, ended by 0; NULL: the value is of no file, and a fault begins with `path` alone */
    json_t *root;
} JsonFile;

/* One value and the way to it; lives on the stack of whoever descends. */
typedef struct JsonNode {
    const JsonFile *file;
    json_t *value;
    const struct JsonNode *parent; /* NULL at the root */
    const char *key;               /* in an object; NULL in an array */
    size_t index;                  /* in an array */
} JsonNode;

enum { JSON_LARGEST_FILE = 64 * 1024 * 1024 /* bytes: a house of a hundred thousand walls has a sixth of it */ };

bool json_read(JsonFile *file, const char *path, Fault *fault);

/* The same of a text of `size` bytes, ended by 0, which is taken over also when it is no JSON; `path` is for faults. */
bool json_take(JsonFile *file, const char *path, char *text, size_t size, Fault *fault);

void json_free(JsonFile *file);

JsonNode json_root(const JsonFile *file);

/* The member `key` of an object, or a node whose value is NULL. */
JsonNode json_member(const JsonNode *object, const char *key);

/* The element `index` of an array, index below its length. */
JsonNode json_element(const JsonNode *array, size_t index);

typedef struct JsonPlace {
    int line, column; /* from 1 */
} JsonPlace;

/* Where each element of an array, or each member's value of an object, stands in its file: as many, found in one walk.
 * Of no use when the value is of no file. memory_free them. */
JsonPlace *json_places(const JsonNode *node);

/* Adds `file:line:column: what`, pointing at the node's value. */
void json_fault(const JsonNode *node, Fault *fault, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Adds a fault, pointing at the key, for every key of the object that `known` (ended by NULL) does not list, and
 * names the nearest one that it does. */
void json_check_keys(const JsonNode *object, const char *const *known, Fault *fault);

/* Checks that a file says what it is: `format` and version 1; `what` names it in faults, "house". False: it says that
 * it is something else, so that no more can be said about it. */
bool json_check_header(const JsonNode *root, const char *what, const char *format, Fault *fault);

/* The text of the member `key`, kept by `arena`; "" when it is absent or, with a fault, no text. */
const char *json_read_text(const JsonNode *object, const char *key, Arena *arena, Fault *fault);

/* The value on one line, every number with the fewest digits that give the same bits again; memory_free it. */
char *json_line(const json_t *value);

/* A number as JSON: whole numbers without a decimal point. */
json_t *json_number(double value);
