/* A followed orbit as lines of the orbit diagram: stable and unstable ones, and the located points. */
#pragma once

#include "laboratory/machine/sweep.h"

typedef enum MachineLine {
    MACHINE_LINE_STABLE,
    MACHINE_LINE_UNSTABLE,
    MACHINE_LINE_LOCATED,
    MACHINE_LINES
} MachineLine;

enum { MACHINE_LOCATED_MOST = 24, MACHINE_STATES_MOST = 2 * 64 };

/* A located point. */
typedef struct MachineLocated {
    const char *kind;   /* "fold" */
    double value, peak; /* parameter's unit, N */
} MachineLocated;

struct MachineLines {
    MachineSweepPoints points[MACHINE_LINES]; /* values that are not numbers break the lines */
    MachineLocated located[MACHINE_LOCATED_MOST];
    size_t located_count; /* of the orbit itself */
    size_t period;        /* cycles; 0: nothing was followed, since `why` */
    const char *why;      /* a sentence without its full stop */
};
typedef struct MachineLines MachineLines;

static inline void machine_lines_clear(MachineLines *lines) {
    for (int line = 0; line < MACHINE_LINES; line++)
        machine_sweep_points_clear(&lines->points[line]);
    *lines = (MachineLines){.period = 0};
}
