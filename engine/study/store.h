/* Stores the results of studies in a file as they arrive, so that an interrupted study continues later. One SQLite
 * file holds any number of studies, each identified by its digest. Numbers are stored bit for bit. */
#pragma once

#include "base/fault.h"
#include "study/study.h"

typedef struct Store Store;

/* Contents of the file. */
typedef struct StoreFound {
    size_t done;   /* trials of this study */
    size_t others; /* other studies: if none of this study's trials are stored, an input has changed since */
} StoreFound;

/* Opens or creates the file and reads the trials of the study with this digest into `study`, which has begun. NULL:
 * an error says why the file, left unchanged, is unusable. */
Store *store_open(const char *path, Study *study, uint64_t digest, StoreFound *found, Fault *fault);

/* Implements StudyOptions.keep with the store as keeper: writes the trials, and commits them about once per second. */
void store_write(void *store, const Study *study, const size_t *done, size_t count);

/* Deletes this study from the file: its results are invalid. */
void store_forget(Store *store);

/* Returns false, with an error, if anything was not written. */
bool store_close(Store *store, Fault *fault);
