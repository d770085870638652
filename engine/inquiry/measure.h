/* Measures used by public tests of evacuation programs: times, flows, densities, speeds, people by exit, overtaking.
 * Each one is a row of a table, a function of the house and its observation.
 *
 * Flow: (b - a) / (t_b - t_a) / width between the a-th and the b-th person who passes, in persons/(m s). Density: the
 * mean number of people in an area over a time, divided by the area (the classical one). Speed in an area: the total
 * distance covered in it divided by the total time spent in it. All are computed from the positions of the trace, every
 * Observation.sample s.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/parameters.h"
#include "house/house.h"
#include "house/observation.h"

/* The arguments of a measure; unused ones stay empty. */
typedef struct MeasureQuestion {
    Ids of;           /* people and crowds; empty: all people */
    Ids past;         /* people and crowds to be overtaken */
    const char *exit; /* id, or "" */
    Points line;      /* m, two points of a line to cross, instead of an exit */
    Points area;      /* m, an outline */
    double width;     /* m, of a bottleneck; 0: the length of the exit or line */
    double from;      /* s */
    double until;     /* s */
    double first;     /* 1, share of people who pass before the flow is measured */
    double last;      /* 1, share of people who pass until the flow is no longer measured */
} MeasureQuestion;

typedef struct MeasureAnswer {
    double value;   /* in the measure's unit; NAN: there is none */
    char note[200]; /* why there is no value, or "" */
} MeasureAnswer;

typedef enum MeasureNeed {
    MEASURE_GATE = 1, /* an exit or a line */
    MEASURE_EXIT = 2,
    MEASURE_AREA = 4,
    MEASURE_WINDOW = 8, /* from and until */
    MEASURE_PAST = 16,
} MeasureNeed;

typedef struct Measure {
    const char *name;
    const char *unit; /* "1" for pure numbers */
    int needs;        /* combination of MEASURE_... */
    const char *meaning;
    void (*take)(MeasureAnswer *answer, const House *house, const Observation *observation,
                 const MeasureQuestion *question);
} Measure;

/* Returns all measures; `*count` is their number. */
const Measure *measure_table(size_t *count);

/* Returns the measure called `name`, or NULL. */
const Measure *measure_find(const char *name);

/* True if the person is one of `ids`, or a member of one of them (members of crowds are called NAME-1, NAME-2, ...), or
 * if `ids` is empty. */
bool measure_is_of(const House *house, size_t person, const Ids *ids);
