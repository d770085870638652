/* The file of a draft: reading, saving, comparing and resetting. */
#pragma once

#include "plan/draft.h"

/* Reads the house of a file with settings, as plan_read does; the settings count as saved. NULL: an error. */
Draft *draft_file_read(const char *path, const char *const *settings, size_t setting_count, Fault *fault);

/* Returns a draft of a house's text with settings; `path` names it in faults. It has no file. NULL: an error. */
Draft *draft_file_of_text(const char *path, const char *text, const char *const *settings, size_t setting_count,
                          Fault *fault);

/* Returns the path of the file that was read or saved last; NULL: none. */
const char *draft_file_path(const Draft *draft);

/* True if the plan differs from that file. */
bool draft_file_is_changed(Draft *draft);

/* Writes the plan to a temporary file, then renames it; the original bytes are written if they still describe the plan.
 * The path becomes the draft's file. Returns false after an error. */
bool draft_file_save(Draft *draft, const char *path, Fault *fault);

/* Restores the content of the file, as a step. */
void draft_file_reset(Draft *draft, const char *name);
