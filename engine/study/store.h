/* The results of studies in a file, as they come, so that a study that was stopped, or whose computer was switched off,
 * goes on where it was. One SQLite file holds any number of studies, each known by its digest. Numbers are kept bit for
 * bit. */
#pragma once

#include "base/fault.h"
#include "study/study.h"

typedef struct Store Store;

/* What was in the file. */
typedef struct StoreFound {
    size_t done;   /* trials of this study */
    size_t others; /* studies: with none of this one's trials there, something was changed since */
} StoreFound;

/* Opens the file, makes it when it is not there, and takes the trials of the study with this digest into `study`, which
 * has begun. NULL: a fault says why the file, which stays as it was, is of no use. */
Store *store_open(const char *path, Study *study, uint64_t digest, StoreFound *found, Fault *fault);

/* As StudyOptions.keep, the keeper being the store: writes them, and about once a second makes sure that they stay. */
void store_keep(void *store, const Study *study, const size_t *done, size_t count);

/* Takes this study out of the file: its results are worth nothing. */
void store_forget(Store *store);

/* False: a fault says that not everything could be written. */
bool store_close(Store *store, Fault *fault);
