/* Exports what is shown by running the program's own command line in a child process: runs, frames, films and reports.
 * No file is ever overwritten: NAME, NAME-2, NAME-3 ... For files of the present view, see snapshot.h. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"

/* Where ------------------------------------------------------------------------------------------------------------ */

/* Returns the folder that exports go to, whether it is there or not. Release it by memory_free. */
char *export_place(void);

/* Returns the folder for exports and makes it if needed: out/clearance if the current folder has a writable out/,
 * otherwise $HOME/clearance, otherwise clearance/ in the current folder. NULL: none is writable, and a fault says so.
 * Release it by memory_free. */
char *export_folder(Fault *fault);

/* Returns FOLDER/NAME, or FOLDER/NAME-2, FOLDER/NAME-3 ..., such that no file with any of the `endings` (NULL-ended; ""
 * for a folder) exists yet. Characters of `name` that are awkward in file names become "-". Release it by memory_free.
 */
char *export_free_name(const char *folder, const char *name, const char *const *endings);

/* A command -------------------------------------------------------------------------------------------------------- */

/* Returns the arguments after "clearance", quoted for a shell: "clearance run 'my house.json' --set door.d1.width=0.8".
 * Release it by memory_free. */
char *export_command(const char *const *arguments, size_t count);

typedef struct Export Export;

typedef enum ExportStage { EXPORT_RUNNING, EXPORT_DONE, EXPORT_FAILED, EXPORT_CANCELLED } ExportStage;

typedef struct ExportStatus {
    ExportStage stage;
    double part;              /* 0 to 1; NAN: not known */
    const char *doing;        /* "picture 40 of 300", "simulated 12 s", "" */
    const char *reason;       /* the last line of a child that failed; "cancelled"; otherwise "" */
    const char *folder;       /* --out, or the movie's path if there is no --out */
    const char *const *files; /* (file_count) once it has ended: names within the folder, and the movie's path */
    size_t file_count;
    bool no; /* done, but the answer is no: a person does not leave the house */
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

/* Starts the child. NULL: a fault says why not. */
Export *export_begin(const ExportOrder *order, Fault *fault);

/* Reads what the child has written and returns its status, which is valid until the next call. Never waits; call it
 * between frames until the child has ended. */
const ExportStatus *export_update(Export *export);

/* Asks the child to end and to keep complete files; kills it if it has not ended within a few seconds. */
void export_cancel(Export *export);

/* Ends the child if it still runs, and releases the export. */
void export_end(Export *export);
