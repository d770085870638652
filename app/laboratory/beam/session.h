/* The session of a running beam: its state, for the files of this folder. */
#pragma once

#include "laboratory/beam/answer.h"
#include "laboratory/beam/diagram.h"
#include "laboratory/beam/traces.h"
#include "laboratory/beam/view.h"
#include "laboratory/laboratory.h"

/* The beam at work. The motion runs on the caller's thread, as far as it is reached for, into a record; pictures and
 * plots are made of the record; what takes longer is a worker's. */
typedef struct BeamSession {
    char *path;
    Beam opened; /* the file's, changed by the settings; holds texts */
    Beam beam;   /* as it is now */
    BeamControls controls;
    BeamTape tape;
    BeamView view;
    BeamTraces traces;
    BeamDiagram diagram;
    BeamWorker *worker;
    BeamAnswer answer;
    BeamVerdict verdict;
    bool told;     /* the verdict is known */
    size_t looked; /* at the front when the answer was written */
    double shown;  /* s */
    unsigned news; /* LABORATORY_... bits of the next update */
    Scene added;   /* nothing */
    const char *trouble;
    TimelineMark ticks[BEAM_TAPE_PARTS + 1];
    PanelChoice choices[2];
    Arena command_words;
    const char *command[3 + 2 * BEAM_VALUES];
    Arena troubles; /* texts */
    char clock[64];
} BeamSession;

/* True if the record has ended and grows only after a change. */
static inline bool beam_session_has_ended(const BeamSession *session) {
    return session->tape.status != MOTION_GOOD && !session->tape.next;
}
