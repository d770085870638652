/* Stores the results of studies in a file as they arrive, so that an interrupted study continues later. One SQLite
 * file holds any number of studies, each identified by its digest. Numbers are stored bit for bit. */
#pragma once

#include "base/fault.h"
#include "study/study.h"

typedef struct Store Store;

/* Who may use the file meanwhile. */
typedef enum StoreUse {
    STORE_ALONE,        /* nobody: the file of a whole study */
    STORE_WITH_READERS, /* programs that merge it: the file of a shard. A program that wants to write it is refused. */
} StoreUse;

/* Contents of the file. */
typedef struct StoreFound {
    size_t done;   /* trials of this study */
    size_t others; /* other studies: if none of this study's trials are stored, an input has changed since */
} StoreFound;

/* Opens or creates the file and reads the trials of the study with this digest into `study`, which has begun. NULL:
 * an error says why the file, left unchanged, is unusable. */
Store *store_open(const char *path, StoreUse use, Study *study, uint64_t digest, StoreFound *found, Fault *fault);

typedef enum StoreMerge {
    STORE_MERGED,
    STORE_REFUSED,  /* nothing was taken: a damaged file, or one of another study */
    STORE_CONFLICT, /* a trial has two results */
    STORE_FULL,     /* there is no room for all results */
} StoreMerge;

/* Takes the trials that another file, of a shard, has of this study into `study` and the store; what is there already
 * must be the same, bit for bit. A fault says why a file was refused, or which trial has which two results in which
 * files. The other file is only read, and may be written meanwhile. After a conflict, or where the study is full, the
 * store must be abandoned. */
StoreMerge store_merge(Store *store, Study *study, const char *path, Fault *fault);

/* Adds that the study is full. */
void store_add_full(const Study *study, Fault *fault);

/* Implements StudyOptions.keep with the store as keeper: writes the trials, and commits them about once per second. */
void store_write(void *store, const Study *study, const size_t *done, size_t count);

/* Deletes this study from the file: its results are invalid. */
void store_forget(Store *store);

/* Returns false, with an error, if anything was not written. */
bool store_close(Store *store, Fault *fault);

/* Closes it without what was written since the last commit; at least what was merged before the first run. */
void store_abandon(Store *store);
