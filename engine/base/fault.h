/* What is wrong with the user's input: one line a fault, `file:line:column: what, and what would be right`.
 * A reader that fails returns false, leaves its target as it was and has put at least one line here; a file with
 * several mistakes gets several lines. Impersonal, no full stop, no exclamation. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* Zero is "no fault". Owned by the caller; fault_clear releases the lines. */
typedef struct Fault {
    size_t count, capacity;
    size_t total; /* found, also beyond FAULT_MOST: a reader has failed when this has grown */
    char **lines; /* (count) */
} Fault;

enum { FAULT_MOST = 50 /* lines kept; a file that is wrong everywhere is not listed to the end */ };

/* Adds one line, made as by snprintf. */
void fault_add(Fault *fault, const char *format, ...) __attribute__((format(printf, 2, 3)));

void fault_clear(Fault *fault);
