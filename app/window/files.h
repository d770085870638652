/* What is open and its file: saving, what is not saved yet, and what there is of it after a crash. */
#pragma once

#include "window/window_state.h"

/* To its file; asks for a name where there is none, or none that may be written to. */
void files_save(Window *window);
void files_ask_name(Window *window);

/* To another file, which must not be there. False: a fault was said, and it is as unsaved as before. */
bool files_save_as(Window *window, const char *path);

/* Quits, or opens something else (`path`, of LEAVE_OPEN); where something would be lost, asks before. */
void files_leave(Window *window, Leave leave, const char *path);

/* What was asked about is saved, or need not be. */
void files_finish_leaving(Window *window);

/* Opens what was left behind; puts it away for good. */
void files_recover(Window *window, size_t found);
void files_forget(Window *window, size_t found);

/* Looks for what was left behind; a clean end. */
void files_start(Window *window);
void files_end(Window *window);
