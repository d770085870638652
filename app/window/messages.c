#include "window/messages.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"

static bool same_time(double a, double b) {
    return a == b || (isnan(a) && isnan(b));
}

static bool is_repeated(const Messages *messages, MessageKind kind, double time, const char *text) {
    const Message *last = messages_last(messages);
    return last && last->kind == kind && same_time(last->time, time) && strcmp(last->text, text) == 0;
}

/* Adds a message, which takes over the text. */
static void add(Messages *messages, MessageKind kind, double time, char *text) {
    if (is_repeated(messages, kind, time, text)) {
        memory_free(text);
        return;
    }
    Message *message = &messages->ring[messages->total++ % MESSAGES_MOST];
    memory_free(message->text);
    *message = (Message){messages->total, kind, text, time};
}

/* Joins lines to one, since a message is one line. */
static void join_lines(char *text) {
    for (char *end = text; (end = strpbrk(end, "\r\n"));)
        *end = ' ';
}

void messages_add(Messages *messages, MessageKind kind, double time, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    char *text = text_printed(format, arguments);
    va_end(arguments);
    join_lines(text);
    add(messages, kind, time, text);
}

void messages_add_fault(Messages *messages, Fault *fault, double time) {
    for (size_t i = 0; i < fault->count; i++)
        messages_add(messages, MESSAGE_FAULT, time, "%s", fault->lines[i]);
    if (fault->total > fault->count)
        messages_add(messages, MESSAGE_FAULT, time, "and %zu more", fault->total - fault->count);
    fault_clear(fault);
}

size_t messages_count(const Messages *messages) {
    return messages->total < MESSAGES_MOST ? messages->total : MESSAGES_MOST;
}

const Message *messages_at(const Messages *messages, size_t i) {
    return &messages->ring[(messages->total - messages_count(messages) + i) % MESSAGES_MOST];
}

const Message *messages_last(const Messages *messages) {
    return messages->total ? &messages->ring[(messages->total - 1) % MESSAGES_MOST] : NULL;
}

const Message *messages_fault(const Messages *messages, size_t after, size_t *count) {
    const Message *oldest = NULL;
    *count = 0;
    for (size_t i = messages_count(messages); i-- > 0 && messages_at(messages, i)->number > after;) {
        if (messages_at(messages, i)->kind != MESSAGE_FAULT)
            continue;
        oldest = messages_at(messages, i);
        ++*count;
    }
    return oldest;
}

void messages_clear(Messages *messages) {
    for (size_t i = 0; i < MESSAGES_MOST; i++)
        memory_free(messages->ring[i].text);
    *messages = (Messages){.total = 0};
}
