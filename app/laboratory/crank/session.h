/* A running slider crank: its laboratory's state. The motion is computed on the caller's thread into a record, as far
 * as it is reached for; pictures and plots are made from the record; a worker does the longer computations. */
#pragma once

#include "laboratory/crank/crank_machine.h"
#include "laboratory/crank/traces.h"
#include "laboratory/crank/view.h"
#include "laboratory/laboratory.h"
#include "laboratory/machine/session.h"

typedef struct CrankSession {
    MachineSession machine; /* first: see session.h of that folder */
    Crank opened;           /* the file's crank, changed by the settings; holds texts */
    Crank file;             /* the file's crank; holds texts, too */
    CrankTape tape;
    CrankView view;
    CrankTraces traces;
    char error[200];
    TimelineMark marks[CRANK_TAPE_PARTS + 1];
    char clock[64];
} CrankSession;
