/* The session of a running beam: its state, for the files of this folder. */
#pragma once

#include "laboratory/beam/beam_machine.h"
#include "laboratory/beam/lately.h"
#include "laboratory/machine/diagram.h"
#include "laboratory/beam/traces.h"
#include "laboratory/beam/view.h"
#include "laboratory/laboratory.h"

/* A running beam. The motion is computed on the caller's thread into a record, as far as it is reached for; pictures
 * and plots are made from the record; a worker does the longer computations. */
typedef struct BeamSession {
    char *path;
    Beam opened; /* the file's beam, changed by the settings; holds texts */
    Beam file;   /* the file's beam; holds texts, too */
    Machine now; /* the present beam */
    MachineControls controls;
    BeamTape tape;
    BeamView view;
    BeamTraces traces;
    MachineDiagram diagram;
    MachineWorker *worker;
    MachineAnswer answer;
    MachineVerdict verdict;
    bool has_verdict; /* the verdict is known */
    size_t looked;    /* front of the record when the answer was last written */
    double shown;     /* s, the displayed time */
    unsigned news;    /* LABORATORY_... bits of the next update */
    Scene added;      /* always empty */
    const char *error;
    TimelineMark marks[BEAM_TAPE_PARTS + 1];
    PanelChoice choices[2];
    Arena command_words;
    const char *command[3 + 2 * BEAM_VALUES];
    char where[40];    /* "300.0 Hz, gap 0.25 mm" */
    Arena error_texts; /* holds the texts of errors */
    char clock[64];
} BeamSession;

/* True if the record has ended and can only grow after a change. */
static inline bool beam_session_has_ended(const BeamSession *session) {
    return session->tape.status != CYCLE_GOOD && !session->tape.next;
}
