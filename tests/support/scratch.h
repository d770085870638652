/* Files for tests: houses and the like written as text into a temporary file, and lists of the files of a directory. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "plan/plan.h"

/* Writes `text`, its ' turned into ", into a new temporary file; `path` takes its name. */
enum { SCRATCH_PATH = 64 };
void scratch_write(char path[SCRATCH_PATH], const char *text);

/* Reads a house of `members` besides format and version, in the same way. Faults are printed and fail the test. */
void scratch_plan(Plan *plan, const char *members);

/* The paths of the data files of a directory below the project's (.json, .csv, .script, .dxf and so on), sorted;
 * scratch_free_list releases them. */
char **scratch_list(const char *directory, size_t *count);
void scratch_free_list(char **paths, size_t count);

/* The project's `path` as one that can be opened; overwritten by the next call. */
const char *scratch_source(const char *path);

/* The whole file, "" if there is none; memory_free it. */
char *scratch_read(const char *path);

/* Reads every file of a directory; what is wrong with them must be its expected.txt, no line more or less. */
void scratch_check_faults(const char *directory, void (*read)(const char *path, Fault *fault));
