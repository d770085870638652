/* Saves the open file, asks before edits are lost, and recovers edits after a crash. */
#pragma once

#include "window/window_state.h"

/* Save to the tab's own file, or ask for a name if there is none that may be written to. */
void files_save(Window *window);
void files_ask_name(Window *window);

/* Returns the folder in which the open dialog begins: that of the open file, else that of the last one. */
const char *files_open_folder(Window *window);

/* Saves to another file, which must not exist yet. False: a fault was posted, and nothing was saved. */
bool files_save_as(Window *window, const char *path);

/* Quits or opens something else (`path` for LEAVE_OPEN), and asks first if edits would be lost. */
void files_leave(Window *window, Leave leave, const char *path);

/* Quits or opens what files_leave was asked for, after the answer. */
void files_finish_leaving(Window *window);

/* Opens a found recovery file; removes one for good. */
void files_recover(Window *window, size_t found);
void files_forget(Window *window, size_t found);

/* Looks for recovery files at the start; removes the own one at a clean end. */
void files_start(Window *window);
void files_end(Window *window);
