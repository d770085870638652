/* Writes the displayed house or beam, with its changes, to a new file. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"

/* A house's text. False: a fault says why not. */
bool save_file_house(const char *text, const char *path, Fault *fault);

/* The file that was opened, read again with the settings of the laboratory's command, whose `words` (count) are "run",
 * FILE, "--set", NAME=VALUE and so on. */
bool save_file_beam(const char *const *words, size_t count, const char *path, Fault *fault);
