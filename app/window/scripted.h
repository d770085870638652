/* Carries out a script, command by command. */
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
    double since;               /* s on the wall, when that began */
} Scripted;

/* False: faults, and there is no script. */
bool scripted_open(Scripted *scripted, const char *path, Fault *fault);
void scripted_close(Scripted *scripted);

/* After a frame has been drawn and before it is shown. What cannot be done, or is not as expected, goes to standard
 * error and ends the window with exit code 1. At the end of the script it goes on as if there had been none, unless the
 * script quits. */
void scripted_advance(Scripted *scripted, Window *window);

/* Is there anything left to do? */
bool scripted_is_busy(const Scripted *scripted);
