/* Errors in the user's input: one line per error, `file:line:column: what is wrong, and what must be`. A reader that
 * fails returns false, leaves its target unchanged and adds at least one line; a file with several errors gets several
 * lines. The lines are impersonal, without a full stop or an exclamation mark. Characters that act instead of being
 * seen are shown by their number, \u001b, also a newline: a line stays one line. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* A zeroed value holds no error. Owned by the caller; fault_clear releases the lines. */
typedef struct Fault {
    size_t count, capacity;
    size_t total; /* errors found, including those beyond FAULT_MOST: a reader has failed when this has grown */
    char **lines; /* (count) */
} Fault;

enum { FAULT_MOST = 50 /* lines stored; a file with errors everywhere is not listed to its end */ };

/* Adds one line, formatted as by snprintf. */
void fault_add(Fault *fault, const char *format, ...) __attribute__((format(printf, 2, 3)));

void fault_clear(Fault *fault);
