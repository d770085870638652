/* Opens files, each in the tab of its laboratory, and goes from tab to tab. */
#pragma once

#include "window/window_state.h"

/* Opens a file in the tab of its laboratory and shows that tab; NULL: a new house. A file of another program becomes a
 * new house that no file holds yet; if its unit is in doubt, a dialog asks for it first. False: faults were posted, and
 * what was open stays open. What was open is closed unsaved: see files_leave. */
bool opening_file(Window *window, const char *path);

/* Opens a file of another program whose unit (m in one) was chosen. */
bool opening_import(Window *window, const char *path, double unit);

/* Opens a house that no file of its own holds, as `mark` says: it has no path and is not listed as recent. `origin`: as
 * in LaboratoryOptions. */
bool opening_copy(Window *window, const char *path, const char *origin, const char *mark);

/* Opens a lesson's file in a tab with these settings (count) NAME=VALUE, and shows the tab. */
bool opening_with(Window *window, size_t tab, const char *path, const char *const *settings, size_t count);

/* Shows a tab, with the default file of its laboratory when nothing is open in it. */
void opening_tab(Window *window, size_t tab);
