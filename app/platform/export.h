/* Handing on what is shown, by the program's own command line in a child process: runs, frames, films and reports. No
 * file is ever written over: NAME, NAME-2, NAME-3 ... For files of what is seen now, see snapshot.h. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"

/* Where ------------------------------------------------------------------------------------------------------------ */

/* The folder for what is handed on, made if needed: out/clearance when there is a folder out/ here that can be written
 * to, otherwise $HOME/clearance, otherwise clearance/ here. NULL: none can be written to, a fault says so. memory_free
 * it. */
char *export_folder(Fault *fault);

/* FOLDER/NAME.ENDING, or with -2, -3 ... behind the name, such that none of the `endings` (NULL-ended; "" for a folder)
 * is there yet: without the ending. Characters of `name` that are awkward in a file's name become "-". memory_free
 * it. */
char *export_free_name(const char *folder, const char *name, const char *const *endings);

/* A command -------------------------------------------------------------------------------------------------------- */

/* The arguments behind "clearance", quoted for a shell: "clearance run 'my house.json' --set door.d1.width=0.8".
 * memory_free it. */
char *export_command(const char *const *arguments, size_t count);

typedef struct Export Export;

typedef enum ExportStage { EXPORT_RUNNING, EXPORT_DONE, EXPORT_FAILED, EXPORT_CANCELLED } ExportStage;

typedef struct ExportStatus {
    ExportStage stage;
    double part;              /* 0 to 1; NAN: not known */
    const char *doing;        /* "picture 40 of 300", "simulated 12 s", "" */
    const char *reason;       /* of what failed: its last line; of what was cancelled: that; otherwise "" */
    const char *folder;       /* --out, or "" */
    const char *const *files; /* (file_count) there, once it is over: names within the folder, and the movie's path */
    size_t file_count;
    bool no; /* done, but the answer is no: somebody does not get out */
} ExportStatus;

typedef struct ExportOrder {
    const char *program;          /* NULL: this one */
    const char *const *arguments; /* (argument_count) Laboratory.command */
    size_t argument_count;
    const char *const *options; /* (option_count) "--frames", "30", ... without --out */
    size_t option_count;
    const char *out;   /* for --out; made by the child */
    const char *movie; /* for --movie, or NULL */
} ExportOrder;

/* Starts it. NULL: a fault says why not. */
Export *export_begin(const ExportOrder *order, Fault *fault);

/* Where it is; never waits. Good until the next call. To be called now and then until it is over. */
const ExportStatus *export_update(Export *export);

/* Asks it to end, keeping what is complete; one that does not within a few seconds is ended. */
void export_cancel(Export *export);

/* Ends it, if need be, and releases it. */
void export_end(Export *export);
