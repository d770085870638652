/* Other programs' files: each becomes a new house that no file holds yet. */
#pragma once

#include "window/window_state.h"

/* Does the name end as one that can be read so? */
bool files_import_knows(const char *path);

/* False: faults were said, and what is open stays. What could not be taken over is said. */
bool files_import_open(Window *window, const char *path);
