/* `study --types`: types I, II and III of a house or a beam in a window of named parameters. */
#pragma once

#include "command/command.h"

/* Tells the type of the command line's file, prints it, writes --out. Returns the exit code. */
int study_types_answer(const Options *options);
