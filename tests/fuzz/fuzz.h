/* What the fuzz targets share. A target fails by stopping: the sanitizers, libFuzzer's limits and fuzz_expect do so. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/fault.h"

/* libFuzzer calls this with one input after the other. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* The path of a file in memory that holds the input; the next call writes over it. */
const char *fuzz_file(const uint8_t *data, size_t size);

/* Stops the program, and says so, unless `good`. */
void fuzz_expect(bool good, const char *what);

/* A reader says true and adds no fault, or false and at least one; each fault is one line of UTF-8 that begins with
 * `place` ("" : any) and, after a file's, with a line and a column. The faults are cleared. */
void fuzz_expect_faults(bool good, Fault *fault, const char *place);
