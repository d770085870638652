/* The pen of standard output and standard error: all that the verbs print passes here, so that a name in a file cannot
 * act on the terminal. In JSON the shown form of a character means the same character. */
#pragma once

/* Shows characters that act by their number from here on; see base/visible.h. */
void terminal_show_all_characters(void);

/* Overwrites the line of progress on standard error with a text that begins with a carriage return; only lines printed
 * here return so. To be called by one thread at a time. */
void terminal_progress(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Clears the line of progress. */
void terminal_clear_progress(void);

/* Returns the first error (errno) of standard output; 0: none. A later call may have changed errno. */
int terminal_error(void);
