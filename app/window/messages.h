/* What has been said, for the log: the last MESSAGES_MOST lines, oldest first. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"

enum { MESSAGES_MOST = 200 };

typedef enum MessageKind { MESSAGE_NOTE, MESSAGE_FAULT } MessageKind;

typedef struct Message {
    size_t number; /* from 1, of all that was ever said */
    MessageKind kind;
    char *text;  /* one line */
    double time; /* s, simulated, to which choosing it goes; NAN: none */
} Message;

/* Zero is empty; messages_clear releases it. */
typedef struct Messages {
    Message ring[MESSAGES_MOST];
    size_t total; /* ever said */
} Messages;

/* Adds a line; one that says the same as the last, of the same kind and time, is not said twice. */
void messages_add(Messages *messages, MessageKind kind, double time, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Adds all lines of a fault, and releases it. */
void messages_add_fault(Messages *messages, Fault *fault, double time);

/* How many are kept, and the i-th of them, from the oldest, below that. */
size_t messages_count(const Messages *messages);
const Message *messages_at(const Messages *messages, size_t i);
const Message *messages_last(const Messages *messages); /* NULL: none */
void messages_clear(Messages *messages);
