/* Parameter tables: each number that a person may give is described once, by one row: name, unit, range, meaning,
 * provenance. Reading and writing files, the texts of faults, `--set NAME=VALUE` and the JSON Schema all follow from
 * the rows; to add a parameter is to add one field and one row. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/vec2.h"

typedef enum ParameterKind {
    PARAMETER_NUMBER, /* double, in the row's unit, low to high */
    PARAMETER_WHOLE,  /* int, low to high */
    PARAMETER_FLAG,   /* bool */
    PARAMETER_CHOICE, /* int: the place of the word in `choices` */
    PARAMETER_TEXT,   /* const char * */
    PARAMETER_ID,     /* const char *, of letters, digits, - and _ */
    PARAMETER_IDS,    /* Ids */
    PARAMETER_POINT,  /* Vec2, m */
    PARAMETER_POINTS, /* Points, m, at least `low` of them */
    PARAMETER_TABLE,  /* a struct with a table of its own; left out of a file where it is at its fallbacks */
} ParameterKind;

typedef struct Points {
    Vec2 *at; /* (count), owned by the arena of what holds them */
    size_t count;
} Points;

typedef struct Ids {
    const char **at; /* (count) */
    size_t count;
} Ids;

typedef struct Parameter {
    const char *name;
    ParameterKind kind;
    size_t offset; /* of the field in the struct that the table describes */
    const char *unit;
    double low, high;    /* both allowed */
    double fallback;     /* when absent; a choice's place in `choices`; a flag's 0 or 1 */
    bool needed;         /* absent is a fault */
    const char *choices; /* "open|closed|locked" */
    const struct ParameterTable *table;
    const char *meaning;    /* a sentence's beginning, for help, schema and tooltips */
    const char *provenance; /* where the fallback comes from, when it is a number that somebody chose */
} Parameter;

typedef struct ParameterTable {
    const char *what; /* "door" */
    const Parameter *rows;
    size_t count;
} ParameterTable;

/* Coordinates and lengths that a plan may hold, m: beyond a town, a double still resolves a micrometre. */
#define PARAMETER_FARTHEST 1e5

/* Sets every field that has a row to its fallback. */
void parameters_reset(const ParameterTable *table, void *object);

/* Reads the members of a JSON object into `object`, reset first; texts and points go to `arena`. Unknown keys, wrong
 * types, values out of range and missing ones each add a fault. */
bool parameters_read(const ParameterTable *table, void *object, const JsonNode *node, Arena *arena, Fault *fault);

/* Reads one value; false with a fault, and the field (unless it has a table of its own) as it was, if it does not fit
 * the row. */
bool parameters_read_value(const Parameter *row, void *object, const JsonNode *node, Arena *arena, Fault *fault);

/* A new JSON object of the fields that differ from their fallbacks, in the table's order. */
json_t *parameters_write(const ParameterTable *table, const void *object);

/* The value in words: "0.9", "open", "[1, 2]", "yes", or "never" for a time without end;
 * memory_free it. */
char *parameters_words(const Parameter *row, const void *object);

/* The row called `name`: the whole name or, when only one row ends so, what follows its last dot. NULL: none. */
const Parameter *parameters_find(const ParameterTable *table, const char *name);

/* Adds "unknown NAME, did you mean ...?" pointing at `node`. */
void parameters_fault_unknown(const ParameterTable *table, const char *name, const JsonNode *node, Fault *fault);

/* The unit as it is written behind a number; "": a pure number. */
const char *parameters_unit(const Parameter *row);
