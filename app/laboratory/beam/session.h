/* The session of a running beam: its state, for the files of this folder. */
#pragma once

#include "laboratory/beam/beam_machine.h"
#include "laboratory/beam/lately.h"
#include "laboratory/beam/traces.h"
#include "laboratory/beam/view.h"
#include "laboratory/laboratory.h"
#include "laboratory/machine/session.h"

/* A running beam. The motion is computed on the caller's thread into a record, as far as it is reached for; pictures
 * and plots are made from the record; a worker does the longer computations. */
typedef struct BeamSession {
    MachineSession machine; /* first: see session.h of that folder */
    Beam opened;            /* the file's beam, changed by the settings; holds texts */
    Beam file;              /* the file's beam; holds texts, too */
    BeamTape tape;
    BeamView view;
    BeamTraces traces;
    const char *error;
    TimelineMark marks[BEAM_TAPE_PARTS + 1];
    Arena error_texts; /* holds the texts of errors */
    char clock[64];
} BeamSession;

/* True if the record has ended and can only grow after a change. */
static inline bool beam_session_has_ended(const BeamSession *session) {
    return session->tape.status != CYCLE_GOOD && !session->tape.next;
}
