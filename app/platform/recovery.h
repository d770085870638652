/* Keeps unsaved edits for the next start, in case the program crashes, in
 *
 *     $XDG_STATE_HOME/clearance/recovery/PID-START.json    the house, a valid file by itself
 *     $XDG_STATE_HOME/clearance/recovery/PID-START.about   path of the edited file, title, number of edits, time
 *
 * Each is written to a temporary file and then renamed, the house first, so that the files are complete at every
 * moment. The edited file itself is never touched. PID and START (of the process) identify a process: files of a
 * process that is still alive are not offered to another one. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct Recovery Recovery;

typedef struct RecoveryAbout {
    const char *origin; /* path of the edited file; NULL: it has none yet */
    const char *name;
    size_t edits;
    int64_t when; /* s since 1970 */
} RecoveryAbout;

/* A recovery file of a process that has ended. */
typedef struct RecoveryFound {
    char *path, *about_path; /* of the house and of the .about file, which may be missing */
    char *origin, *name;     /* the origin is NULL if there was none */
    size_t edits;
    int64_t when, origin_when; /* s since 1970; 0: unknown, or the file is gone */
} RecoveryFound;

/* Creates the recovery of this process. NULL: there is no writable folder. */
Recovery *recovery_create(void);
void recovery_destroy(Recovery *recovery); /* leaves the files in place */

/* Writes both files. Returns 0, or errno, and then the previous ones are still there. */
int recovery_write(Recovery *recovery, const char *text, const RecoveryAbout *about);
void recovery_remove(Recovery *recovery);

/* Returns the path of this process's recovery file. */
const char *recovery_path(const Recovery *recovery);

/* Returns the recovery files of processes that have ended, `*count` of them, newest first. Release them by
 * recovery_free_found. */
RecoveryFound *recovery_find(const Recovery *recovery, size_t *count);
void recovery_free_found(RecoveryFound *found, size_t count);

/* Takes a found recovery file over as this process's own (false: it is gone); removes one for good. */
bool recovery_adopt(Recovery *recovery, const RecoveryFound *found);
void recovery_forget(const RecoveryFound *found);
