/* Writes edits that no file holds yet to a recovery file, 2 s after the last of them, and removes that file as soon as
 * they are saved or given up. See platform/recovery.h. */
#pragma once

#include "window/window_state.h"

/* Returns the tab whose edits are written: the first one whose laboratory has an editor. */
Tab *autosave_tab(Window *window);

/* Begins watching what has just been opened in a tab, and drops the recovery file of what was open there. */
void autosave_restart(Window *window, Tab *tab);

/* Writes the recovery file if it is due; call it between frames. */
void autosave_update(Window *window);

/* Drops the recovery file: what it held is saved. */
void autosave_drop(Window *window);

/* Returns Laboratory.command with a file that holds what is shown: if no other does, one that is written now to the
 * folder of the exports, so that the command stays good. */
const char *const *autosave_command(Window *window, const char *folder, size_t *count);
