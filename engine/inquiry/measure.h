/* What public tests of evacuation programs ask of a run: times, flows, densities, speeds, who left by which exit, who
 * overtook whom. Each is one row of a table, a function of the house and of what was observed in it.
 *
 * Flow: (b - a) / (t_b - t_a) / width between the a-th and the b-th who passes, in persons/(m s). Density: the mean
 * number of people in an area over a time, divided by the area (the classical one). Speed in an area: way covered in it
 * divided by time spent in it, of all together. All from positions as the trace has them, every Observation.sample s.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/parameters.h"
#include "house/house.h"
#include "house/observation.h"

/* What is asked; what a measure does not need is left out. */
typedef struct MeasureQuestion {
    Ids of;           /* people and crowds; none: everybody */
    Ids past;         /* people and crowds who are overtaken */
    const char *exit; /* id, or "" */
    Points line;      /* m, two points to pass between, instead of an exit */
    Points area;      /* m, an outline */
    double width;     /* m, of a neck; 0: the length of the exit or line */
    double from;      /* s */
    double until;     /* s */
    double first;     /* 1, share of those who pass before a flow counts */
    double last;      /* 1, share of those who pass until it no longer counts */
} MeasureQuestion;

typedef struct MeasureAnswer {
    double value;   /* in the measure's unit; NAN: there is none */
    char note[200]; /* why there is none, or "" */
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
    int needs;        /* MEASURE_..., together */
    const char *meaning;
    void (*take)(MeasureAnswer *answer, const House *house, const Observation *observation,
                 const MeasureQuestion *question);
} Measure;

/* All measures; `*count` of them. */
const Measure *measure_table(size_t *count);

/* The one called `name`, or NULL. */
const Measure *measure_find(const char *name);

/* The person is one of `ids`, or a member of one of them (crowds' members are called NAME-1, NAME-2, ...); true for
 * everybody when `ids` is empty. */
bool measure_is_of(const House *house, size_t person, const Ids *ids);
