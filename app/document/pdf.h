/* A document as PDF: A4, pictures in vectors, searchable text, headings as bookmarks, and tags for headings, tables
 * and pictures. The same document and time give the same bytes. */
#pragma once

#include <time.h>

#include "document/document.h"

/* Writes to a temporary file, then renames it to `path`; `created` is stored in the file's properties. Returns 0, or
 * errno. */
int pdf_write(const Document *document, const char *path, time_t created);
