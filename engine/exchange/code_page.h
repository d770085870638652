/* Converts text in a Windows code page to UTF-8. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* True if the whole text is valid UTF-8. */
bool code_page_is_utf8(const char *text, size_t size);

/* Returns a copy of a text in a Windows code page ("932", "1252") as UTF-8, ended by 0. Bytes that the page does not
 * define become question marks; an unknown page is read as 1252. The caller releases the copy with memory_free;
 * `*size` becomes the size of the copy. */
char *code_page_convert(char *text, size_t *size, const char *page);
