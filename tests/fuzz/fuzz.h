/* The common part of the fuzz targets. A target fails by stopping: through the sanitizers, libFuzzer's limits or
 * fuzz_expect. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/fault.h"

/* Called by libFuzzer with one input after another. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Returns the path of a file in memory that holds the input; the next call overwrites it. */
const char *fuzz_file(const uint8_t *data, size_t size);

/* Returns the path of a folder for the files of this process, which is removed at its end. */
const char *fuzz_folder(void);

/* Writes the input to a file in that folder, or removes the file if there is no input. `path` receives its path. */
enum { FUZZ_PATH = 512 };
void fuzz_write(char path[FUZZ_PATH], const char *name, const uint8_t *data, size_t size);

/* Returns the path of a file of the source tree; the next call overwrites it. */
const char *fuzz_source(const char *name);

/* Takes the next byte of the input, or 0 at its end. */
uint8_t fuzz_take(const uint8_t **data, size_t *size);

/* Stops the program with a message unless `good`. */
void fuzz_expect(bool good, const char *what);

/* Checks that a reader returns true without errors, or false with at least one; each error is a line of UTF-8 that
 * begins with `place` ("": any) and, for files, a line and a column. Clears the errors. */
void fuzz_expect_faults(bool good, Fault *fault, const char *place);
