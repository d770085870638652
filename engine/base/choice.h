/* Words to choose from, written in one: "open|closed|locked". */
#pragma once

#include <stddef.h>

size_t choice_count(const char *choices);

/* The place of a word, from 0, or -1. */
int choice_place(const char *choices, const char *word);

/* The word at a place, not ended by 0 but `length` bytes long; NULL: there are not so many. */
const char *choice_word(const char *choices, int place, size_t *length);

/* "open, closed or locked", as far as it fits. */
void choice_list(const char *choices, char *list, size_t size);
