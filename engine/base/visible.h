/* Names and notes of a file may hold characters that act instead of being seen: escapes of the terminal, characters
 * that reverse the direction of writing, or ones without width. They are shown by their number, as JSON writes them:
 * \u001b. Newline and tab are kept, except in a line. */
#pragma once

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* True if the character acts instead of being seen. */
bool visible_acts(uint32_t character);

enum { VISIBLE_LETTER = 16 /* bytes */ };

/* Takes the first character of `size` bytes and writes how it is shown, ended by 0. Returns its bytes; 0: the bytes end
 * within the character. Invalid bytes are shown as \x9b. */
size_t visible_letter(const char *bytes, size_t size, char shown[VISIBLE_LETTER]);

/* Returns a copy of the text in which each character is seen; memory_free it. */
char *visible_text(const char *text);

/* Returns such a copy as one line: newline and tab are shown by their number too. The copy is valid UTF-8, and a copy
 * of the copy is the same. memory_free it. */
char *visible_line(const char *text);

/* Returns text formatted as by vprintf as such a line; memory_free it. */
char *visible_printed(const char *format, va_list arguments) __attribute__((format(printf, 1, 0)));
