/* Choices written as one string: "open|closed|locked". */
#pragma once

#include <stddef.h>

size_t choice_count(const char *choices);

/* Returns the index of a word, from 0, or -1. */
int choice_place(const char *choices, const char *word);

/* Returns the word at an index; it is `length` bytes long and not ended by 0. NULL: the index is past the last word. */
const char *choice_word(const char *choices, int place, size_t *length);

/* Writes "open, closed or locked", cut to `size`. */
void choice_list(const char *choices, char *list, size_t size);
