/* The log: the last MESSAGES_MOST messages, oldest first. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"

enum { MESSAGES_MOST = 200 };

typedef enum MessageKind { MESSAGE_NOTE, MESSAGE_FAULT } MessageKind;

typedef struct Message {
    size_t number; /* from 1, counting all messages ever added */
    MessageKind kind;
    char *text;  /* one line */
    double time; /* s of simulated time to go to when it is chosen; NAN: none */
} Message;

/* Zero is empty; messages_clear releases it. */
typedef struct Messages {
    Message ring[MESSAGES_MOST];
    size_t total; /* ever added */
} Messages;

/* Adds a message, unless the last one has the same kind, time and text. */
void messages_add(Messages *messages, MessageKind kind, double time, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Adds all lines of a fault, and releases it. */
void messages_add_fault(Messages *messages, Fault *fault, double time);

/* Return the number of stored messages, and the i-th of them, from the oldest. */
size_t messages_count(const Messages *messages);
const Message *messages_at(const Messages *messages, size_t i);
const Message *messages_last(const Messages *messages); /* NULL: none */

/* Returns the oldest fault whose number is above `after`, and how many there are; NULL: none. */
const Message *messages_fault(const Messages *messages, size_t after, size_t *count);
void messages_clear(Messages *messages);
