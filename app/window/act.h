/* What each action does. */
#pragma once

#include "window/window_state.h"

/* Does it, as asked for by a key (its code and mods) or, with 0, by a menu or a button. */
void act_do(Window *window, Action action, int32_t key, int mods);

/* Opens a file in the laboratory it is of, and shows that; NULL: a new house. A fault goes to the messages, and what is
 * open stays. What is open is let go unsaved: see files_leave. */
bool act_open(Window *window, const char *path);

/* The same, of a house that no file of its own holds, as `mark` says: it has no path, and is not remembered. `origin`:
 * as in LaboratoryOptions. */
bool act_open_copy(Window *window, const char *path, const char *origin, const char *mark);

/* Shows a laboratory, with its default file when nothing is open in it. */
void act_enter(Window *window, size_t tab);

/* Changes a number; a fault goes to the messages. */
bool act_set(Window *window, const char *name, double value);

/* Says something: a line above the strip, and in the log. */
void act_say(Window *window, const char *format, ...) __attribute__((format(printf, 2, 3)));
void act_complain(Window *window, Fault *fault, double time);

/* Opens a sheet, closes what is open. */
void act_show_dialog(Window *window, Dialog dialog);
void act_close_dialog(Window *window);

/* The first row that has a place, the most dangerous one; NULL: there is none. Selects it, shows it from near and goes
 * to its time. */
const PanelRow *act_first_place(const Tab *tab);
void act_show_place(Window *window);

/* The chart that has the focus; NULL: none. */
PlotPane *act_focused_pane(Window *window);

/* The folder into which pictures go; NULL: a fault was said. memory_free it. */
char *act_folder(Window *window);
