/* Parameter tables: one row describes each number that a user may set: name, unit, range, meaning, provenance. Reading
 * and writing files, error texts, `--set NAME=VALUE` and the JSON Schema all follow from the rows. To add a parameter,
 * add one field and one row. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/vec2.h"

typedef enum ParameterKind {
    PARAMETER_NUMBER,  /* double, in the row's unit, low to high */
    PARAMETER_WHOLE,   /* int, low to high */
    PARAMETER_FLAG,    /* bool */
    PARAMETER_CHOICE,  /* int: the index of the word in `choices` */
    PARAMETER_TEXT,    /* const char * */
    PARAMETER_ID,      /* const char *, of letters, digits, - and _ */
    PARAMETER_IDS,     /* Ids */
    PARAMETER_NUMBERS, /* NumberList, each low to high */
    PARAMETER_POINT,   /* Vec2, m */
    PARAMETER_POINTS,  /* Points, m, at least `low` of them */
    PARAMETER_TABLE,   /* a struct with its own table; omitted from a file when all its fields have their fallbacks */
} ParameterKind;

typedef struct Points {
    Vec2 *at; /* (count), owned by the arena of the containing object */
    size_t count;
} Points;

typedef struct Ids {
    const char **at; /* (count) */
    size_t count;
} Ids;

typedef struct NumberList {
    double *at; /* (count) in the row's unit */
    size_t count;
} NumberList;

typedef struct Parameter {
    const char *name;
    ParameterKind kind;
    size_t offset; /* offset of the field in the struct that the table describes */
    const char *unit;
    double low, high;    /* both inclusive */
    double fallback;     /* value when absent; a choice's index in `choices`; a flag's 0 or 1 */
    bool needed;         /* True if the parameter must be present */
    const char *choices; /* "open|closed|locked" */
    const struct ParameterTable *table;
    const char *meaning;    /* beginning of a sentence, for help, schema and tooltips */
    const char *provenance; /* source of the fallback, when a person chose the number */
} Parameter;

typedef struct ParameterTable {
    const char *what; /* "door" */
    const Parameter *rows;
    size_t count;
} ParameterTable;

/* Largest coordinate or length in a plan, m: larger than a town, where a double still resolves a micrometre. */
#define PARAMETER_FARTHEST 1e5

/* Sets every field that has a row to its fallback. */
void parameters_reset(const ParameterTable *table, void *object);

/* Reads the members of a JSON object into `object`, which is reset first; texts and points are allocated in `arena`.
 * Unknown keys, wrong types, missing values and values out of range each add an error. */
bool parameters_read(const ParameterTable *table, void *object, const JsonNode *node, Arena *arena, Fault *fault);

/* Reads one value. Returns false after an error if the value does not fit the row; the field is then unchanged unless
 * it has a table of its own. */
bool parameters_read_value(const Parameter *row, void *object, const JsonNode *node, Arena *arena, Fault *fault);

/* Sets a field that is one number (parameters_number.h). Returns false, with a fault and the object unchanged, if the
 * value is invalid. */
bool parameters_set_number(const Parameter *row, void *object, double value, Fault *fault);

/* Returns a new JSON object of the fields that differ from their fallbacks, in the table's order. */
json_t *parameters_write(const ParameterTable *table, const void *object);

/* Returns the value as text: "0.9", "open", "[1, 2]", "yes", or "never" for an infinite time; memory_free it. */
char *parameters_words(const Parameter *row, const void *object);

/* Returns the row called `name`: the full name or, if it is unique, the part after the last dot. NULL: none. */
const Parameter *parameters_find(const ParameterTable *table, const char *name);

/* Adds "unknown NAME, did you mean ...?" pointing at `node`. */
void parameters_fault_unknown(const ParameterTable *table, const char *name, const JsonNode *node, Fault *fault);

/* Returns the unit as it is written after a number; "": a pure number. */
const char *parameters_unit(const Parameter *row);
