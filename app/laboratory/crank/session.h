/* A running slider crank: its laboratory's state. The motion is computed on the caller's thread into a record, as far
 * as it is reached for; pictures and plots are made from the record; a worker does the longer computations. */
#pragma once

#include "laboratory/crank/crank_machine.h"
#include "laboratory/crank/traces.h"
#include "laboratory/crank/view.h"
#include "laboratory/laboratory.h"
#include "laboratory/machine/answer.h"
#include "laboratory/machine/diagram.h"

enum { CRANK_CHOICES = 3 };

typedef struct CrankSession {
    char *path;
    Crank opened; /* the file's crank, changed by the settings; holds texts */
    Crank file;   /* the file's crank; holds texts, too */
    Machine now;  /* the present crank */
    MachineControls controls;
    CrankTape tape;
    CrankView view;
    CrankTraces traces;
    MachineDiagram diagram;
    MachineWorker *worker;
    MachineAnswer answer;
    MachineVerdict verdict;
    bool has_verdict; /* the verdict is known */
    size_t looked;    /* front of the record when the answer was last written */
    double shown;     /* s, the displayed time */
    unsigned news;    /* LABORATORY_... bits of the next update */
    Scene added;      /* always empty */
    char error[200];
    TimelineMark marks[CRANK_TAPE_PARTS + 1];
    PanelChoice choices[CRANK_CHOICES];
    Arena command_words;
    const char *command[3 + 2 * CRANK_VALUES];
    char clock[64], where[64];
} CrankSession;
