/* What a folder holds, to be chosen from: the folder above, folders, then JSON files, each in natural order (2 before
 * 10). What is hidden is left out. */
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
    size_t left_out; /* files beyond FOLDER_MOST */
    Arena arena;
} Folder;

enum { FOLDER_MOST = 5000 /* entries */ };

/* False: a fault says why it cannot be looked into, and the folder is as it was. */
bool folder_read(Folder *folder, const char *path, Fault *fault);
void folder_clear(Folder *folder);

/* As strcmp, with runs of digits compared as numbers, and capitals as small letters. */
int folder_compare(const char *a, const char *b);
