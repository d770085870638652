/* A document as PDF: A4, pictures in vectors, words that can be searched, headings as bookmarks, and tags that say what
 * is a heading, a table or a picture. The same document and time give the same bytes. */
#pragma once

#include <time.h>

#include "document/document.h"

/* Writes beside `path` and renames; `created` stands in the file's properties. 0, or errno. */
int pdf_write(const Document *document, const char *path, time_t created);
