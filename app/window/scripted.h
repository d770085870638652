/* Runs a script, command by command. */
#pragma once

#include "window/script.h"
#include "window/window_state.h"

enum { SCRIPTED_EVENTS = 8 };

typedef struct Scripted {
    Script script;
    SdlWindowEvent *events; /* (event_count) still to come, one a frame */
    size_t event_count, event_at;
    double waits;               /* frames */
    const ScriptCommand *until; /* NULL: it waits for nothing */
    double since;               /* s of wall time, when waiting began */
} Scripted;

/* Opens a script. False: faults say why not. */
bool scripted_open(Scripted *scripted, const char *path, Fault *fault);
void scripted_close(Scripted *scripted);

/* Advances the script; call it after a frame has been drawn and before it is shown. A command that fails is reported on
 * standard error and ends the window with exit code 1. After its end the window stays open, unless the script quits. */
void scripted_advance(Scripted *scripted, Window *window);

/* True if the script has not ended. */
bool scripted_is_busy(const Scripted *scripted);
