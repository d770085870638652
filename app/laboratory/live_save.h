/* What is shown, with its changed numbers, as a file: the file that was opened, read again with the settings of the
 * laboratory's command, and written to where no file is yet. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"

/* `words` (count) are the command's: "run", FILE, "--set", NAME=VALUE and so on. False: a fault says why not. */
bool live_save_house(const char *const *words, size_t count, const char *path, Fault *fault);
bool live_save_beam(const char *const *words, size_t count, const char *path, Fault *fault);
