/* The completion of command lines in a shell, made from the tables of verbs and options. */
#pragma once

#include <stdbool.h>

#include "base/text.h"

#define COMPLETION_SHELLS "bash|zsh|fish"

/* Adds the functions that complete command lines of clearance; false: the shell is not one of COMPLETION_SHELLS. */
bool completion_add(Text *text, const char *shell);
