/* Texts of old programs, in the letters of one part of the world, as UTF-8. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* Is all of it UTF-8? */
bool code_page_is_utf8(const char *text, size_t size);

/* A copy of a text of a Windows code page ("932", "1252"), ended by 0; what that does not have becomes a question mark.
 * A page that is not known is taken for 1252. New, memory_free it; `*size` becomes that of the copy. */
char *code_page_convert(const char *text, size_t *size, const char *page);
