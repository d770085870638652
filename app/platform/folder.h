/* Lists a folder for the open dialog: the folder above, folders, then files that can be opened, each group in natural
 * order (2 before 10), without hidden entries. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"

typedef enum FolderKind { FOLDER_ABOVE, FOLDER_FOLDER, FOLDER_FILE } FolderKind;

typedef struct FolderEntry {
    const char *name; /* "..", "houses", "l-corridor.json" */
    const char *path; /* absolute */
    FolderKind kind;
    const char *format; /* "house" of a file whose first lines name the format "clearance-house"; otherwise NULL */
} FolderEntry;

/* Zero is empty; folder_clear releases it. */
typedef struct Folder {
    const char *path;     /* absolute */
    FolderEntry *entries; /* (count) */
    size_t count;
    size_t left_out; /* number of entries beyond FOLDER_MOST */
    Arena arena;
} Folder;

enum { FOLDER_MOST = 5000 /* entries */ };

/* Reads a folder. Besides JSON files it lists the files for whose names `also` is true (NULL: none). False: a fault
 * says why it cannot be read, and `folder` is unchanged. */
bool folder_read(Folder *folder, const char *path, bool (*also)(const char *name), Fault *fault);
void folder_clear(Folder *folder);

/* Compares like strcmp, but runs of digits as numbers and without regard to case. */
int folder_compare(const char *a, const char *b);
