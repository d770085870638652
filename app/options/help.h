/* The texts of --help, made from the tables of verbs and options. No line is longer than HELP_COLUMNS. */
#pragma once

#include "base/text.h"
#include "options/verb.h"

enum { HELP_COLUMNS = 100 };

/* Adds the text of `clearance --help`: the verbs, first examples, the exit codes. */
void help_add(Text *text);

/* Adds the text of `clearance VERB --help`: usage, examples, the options by use. */
void help_add_verb(Text *text, VerbId verb);

/* Adds the text of `clearance help options`: all options by use, each with the verbs that take it. */
void help_add_options(Text *text);

/* Adds words that begin at `column`, with further lines indented as far, and a line break. */
void help_add_wrapped(Text *text, const char *words, size_t column);
