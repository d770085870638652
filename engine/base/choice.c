#include "base/choice.h"

#include <stdio.h>
#include <string.h>

/* Returns the text after the first word, at the end if no word follows. */
static const char *after_word(const char *at) {
    at += strcspn(at, "|");
    return at + (*at == '|');
}

size_t choice_count(const char *choices) {
    size_t count = 0;
    for (const char *at = choices; *at; at = after_word(at))
        count++;
    return count;
}

int choice_place(const char *choices, const char *word) {
    size_t length = strlen(word);
    int place = 0;
    for (const char *at = choices; *at; at = after_word(at), place++)
        if (strcspn(at, "|") == length && memcmp(at, word, length) == 0)
            return place;
    return -1;
}

const char *choice_word(const char *choices, int place, size_t *length) {
    const char *at = choices;
    for (int i = 0; i < place && *at; i++)
        at = after_word(at);
    *length = strcspn(at, "|");
    return place >= 0 && *at ? at : NULL;
}

void choice_list(const char *choices, char *list, size_t size) {
    size_t used = 0;
    for (const char *at = choices; *at && used < size;) {
        const char *next = after_word(at);
        const char *before = at == choices ? "" : *next ? ", " : " or ";
        used += (size_t)snprintf(list + used, size - used, "%s%.*s", before, (int)strcspn(at, "|"), at);
        at = next;
    }
}
