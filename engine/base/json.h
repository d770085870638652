/* JSON by jansson, with the line and column of every value, so that an error can point at it.
 *
 * Jansson checks the syntax and holds the values, but not their positions. A position is found only when an error needs
 * it, by walking the text (known to be valid) along the keys and indices that lead to the value. */
#pragma once

#include <jansson.h>
#include <stdbool.h>

#include "base/fault.h"
#include "base/memory.h"

/* A file's text and values. Owned by the caller of json_read; json_free releases it. */
typedef struct JsonFile {
    const char *path; /* as given */
    char *own_path;   /* the copy that json_free releases, or NULL */
    char *text;       /* UTF-8, ended by 0; NULL: the value belongs to no file, and an error begins with `path` alone */
    json_t *root;
} JsonFile;

/* One value and the path to it. A node lives on the stack of the function that descends. */
typedef struct JsonNode {
    const JsonFile *file;
    json_t *value;
    const struct JsonNode *parent; /* NULL at the root */
    const char *key;               /* in an object; NULL in an array */
    size_t index;                  /* in an array */
} JsonNode;

enum { JSON_LARGEST_FILE = 64 * 1024 * 1024 /* bytes: a house of a hundred thousand walls takes a sixth of this */ };

/* Lets jansson take its memory here, so that a value never lacks a part for want of memory. To be called before any
 * other function of jansson. */
void json_use_memory(void);

bool json_read(JsonFile *file, const char *path, Fault *fault);

/* Does the same with `text`, ended by 0, which need not be on disk: errors begin with `path` and point into the text.
 */
bool json_read_memory(JsonFile *file, const char *path, const char *text, Fault *fault);

void json_free(JsonFile *file);

JsonNode json_root(const JsonFile *file);

/* Returns the member `key` of an object, or a node whose value is NULL. */
JsonNode json_member(const JsonNode *object, const char *key);

/* Returns the element `index` of an array; the index must be below its length. */
JsonNode json_element(const JsonNode *array, size_t index);

typedef struct JsonPlace {
    int line, column; /* from 1 */
} JsonPlace;

/* Returns the position of each array element or object member's value in its file, found in one walk; as many as there
 * are elements. The value must belong to a file. memory_free them. */
JsonPlace *json_places(const JsonNode *node);

/* Adds `file:line:column: what`, pointing at the node's value. */
void json_fault(const JsonNode *node, Fault *fault, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Adds an error that points at the key for every key of the object that is not listed in `known` (ended by NULL), and
 * names the nearest known key. */
void json_check_keys(const JsonNode *object, const char *const *known, Fault *fault);

/* Checks that a file is an object with `format` and version 1; `what` names the kind of file in errors, "house".
 * Returns false if the file is not an object or declares another format, so that nothing more can be checked. */
bool json_check_header(const JsonNode *root, const char *what, const char *format, Fault *fault);

/* Returns the text of the member `key`, copied into `arena`; "" when it is absent or, after an error, not a text. */
const char *json_read_text(const JsonNode *object, const char *key, Arena *arena, Fault *fault);

/* Returns the value on one line, every number with the fewest digits that give the same bits; memory_free it. */
char *json_line(const json_t *value);

/* Returns a number as JSON, a whole number without a decimal point. */
json_t *json_number(double value);
