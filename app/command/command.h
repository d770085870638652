/* The verbs of the command line: one file and one row in command.c each. */
#pragma once

#include "options/options.h"

/* Reads argv, runs the verb, returns the exit code. */
int command_main(int argc, char **argv);

/* The verbs. */
int command_run(const Options *options);
int command_ablate(const Options *options);
int command_check(const Options *options);
int command_cases(const Options *options);
int command_compare(const Options *options);
int command_export(const Options *options);
int command_fit(const Options *options);
int command_help(const Options *options);
int command_import(const Options *options);
int command_lesson(const Options *options);
int command_loci(const Options *options);
int command_open(const Options *options);
int command_rules(const Options *options);
int command_schema(const Options *options);
int command_study(const Options *options);
