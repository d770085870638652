/* What is edited and not saved yet, for the next time when the program ends otherwise than it should. It lies in
 *
 *     $XDG_STATE_HOME/clearance/recovery/PID-START.json    the house, a file that can be opened by itself
 *     $XDG_STATE_HOME/clearance/recovery/PID-START.about   of which file it is, its name, how many edits, when
 *
 * both written beside and renamed, the house first, so that at every moment what is there is whole. The file that is
 * edited is never touched. PID and START, when it began, tell a process from all others: what one that still lives has
 * left is not offered to another. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct Recovery Recovery;

typedef struct RecoveryAbout {
    const char *origin; /* path of the file; NULL: it has none yet */
    const char *name;
    size_t edits;
    int64_t when; /* s since 1970 */
} RecoveryAbout;

/* What was left behind. */
typedef struct RecoveryFound {
    char *path, *about_path; /* of the house, and of what is about it, which need not be there */
    char *origin, *name;     /* origin: NULL: none */
    size_t edits;
    int64_t when, origin_when; /* s since 1970; 0: not known, the file is gone */
} RecoveryFound;

/* Of this process. NULL: there is no place to write to. */
Recovery *recovery_create(void);
void recovery_destroy(Recovery *recovery); /* what has been written stays */

/* 0, or errno: then what was written before is still there. */
int recovery_write(Recovery *recovery, const char *text, const RecoveryAbout *about);
void recovery_remove(Recovery *recovery);

/* Where it is written to. */
const char *recovery_path(const Recovery *recovery);

/* What processes that do not live any more have left, the newest first; `*count` of them. recovery_free_found releases
 * it. */
RecoveryFound *recovery_find(const Recovery *recovery, size_t *count);
void recovery_free_found(RecoveryFound *found, size_t count);

/* Takes it over as this process's own; false: it is gone. And puts it away for good. */
bool recovery_adopt(Recovery *recovery, const RecoveryFound *found);
void recovery_forget(const RecoveryFound *found);
