/* Writes the displayed house, beam or crank, with its changes, to a new file. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"

/* Writes a house's text. False: the fault gives the reason. */
bool save_file_house(const char *text, const char *path, Fault *fault);

/* Each reads the opened file, applies the settings of the laboratory's command, and writes the result; `words` (count)
 * are "run", FILE, "--set", NAME=VALUE and so on. */
bool save_file_beam(const char *const *words, size_t count, const char *path, Fault *fault);
bool save_file_crank(const char *const *words, size_t count, const char *path, Fault *fault);
