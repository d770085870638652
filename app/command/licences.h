/* `clearance --version`: the program's version, and on request the libraries in it with their licences. */
#pragma once

/* Prints the answer to `--version [--licences] [--json]`; returns the exit code. The words from argv[first] on are
 * the options behind --version. */
int licences_answer(int argc, char **argv, int first);
