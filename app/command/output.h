/* The directory of --out. */
#pragma once

#include <stdbool.h>

/* Makes the directory and those above it, before the work is done; says so on standard error when that cannot be. */
bool output_directory(const char *path);
