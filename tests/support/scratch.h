/* Temporary files for tests (houses and others, written as text) and lists of the files of a directory. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "check.h"
#include "plan/plan.h"

/* Writes `text`, its ' turned into ", into a new temporary file; `path` takes its name. */
enum { SCRATCH_PATH = CHECK_PATH };
void scratch_write(char path[SCRATCH_PATH], const char *text);

/* Reads a house from `members`, without format and version, in the same way. Errors are printed and fail the test. */
void scratch_plan(Plan *plan, const char *members);

/* Returns the sorted paths of the data files in a directory of the project (.json, .csv, .script, .dxf and so on);
 * scratch_free_list releases them. */
char **scratch_list(const char *directory, size_t *count);
void scratch_free_list(char **paths, size_t count);

/* Returns the absolute name of a path in the project; overwritten by the next call. */
const char *scratch_source(const char *path);

/* Returns the whole file, or "" if there is none; memory_free it. */
char *scratch_read(const char *path);

/* Reads every file of a directory and compares the errors with its expected.txt, line by line. */
void scratch_check_faults(const char *directory, void (*read)(const char *path, Fault *fault));
