/* The file of a draft: where it was read, how it differs, and how it comes back to it. */
#pragma once

#include "plan/draft.h"

/* The house of a file with some settings, as plan_read has it, which count as being in the file. NULL: faults say why
 * not. */
Draft *draft_file_read(const char *path, const char *const *settings, size_t setting_count, Fault *fault);

/* Of the file that was read or saved last; NULL: none. */
const char *draft_file_path(const Draft *draft);

/* Does the plan differ from that file? */
bool draft_file_is_changed(const Draft *draft);

/* Writes the plan beside and renames; the very bytes that were read where they are still what the plan is. From then on
 * it is the draft's file. False: a fault says why not. */
bool draft_file_save(Draft *draft, const char *path, Fault *fault);

/* Puts everything as in the file, as a step. */
void draft_file_reset(Draft *draft, const char *name);
