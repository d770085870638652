/* The answer of a running machine: at once from the last returns of the motion, later from the verdict on the motion
 * from its start. */
#pragma once

#include "laboratory/laboratory.h"
#include "laboratory/machine/worker.h"

enum { MACHINE_ANSWER_LATELY = 128 /* cycles that are examined */ };

/* Facts of the last cycles of the last part. */
typedef struct MachineLately {
    size_t cycles;      /* cycles since the last change */
    int period;         /* period as returned by section_period */
    SectionPeaks peaks; /* peaks of the later half of the examined cycles */
} MachineLately;

/* The record at its end. */
typedef struct MachineNow {
    const MachineKind *kind;
    CycleStatus status;
    bool changed;      /* another machine follows with the next cycle */
    const char *where; /* "300.0 Hz, gap 0.25 mm" */
} MachineNow;

typedef struct MachineAnswer {
    char title[64], doing[80];
    Result result;
    const MachineLines *lines; /* a followed orbit, or NULL */
    PanelRow *rows;            /* (row_count) */
    size_t row_count, row_capacity;
    Arena arena; /* holds the detail and the texts of the rows */
} MachineAnswer;

/* Writes the answer; `verdict` must belong to the present machine, or be NULL. */
void machine_answer_write(MachineAnswer *answer, const MachineNow *now, const MachineLately *lately,
                          const MachineVerdict *verdict);
void machine_answer_clear(MachineAnswer *answer);

/* Reports in the result the work in progress, if there is any. */
void machine_answer_note_doing(MachineAnswer *answer, const MachineKind *kind, const MachineNews *news);
