/* A document as one HTML file that needs no other: pictures are inside, there is no script, and the letters are those
 * of the system. It is well-formed XML, too. The same document and theme give the same bytes. */
#pragma once

#include "base/text.h"
#include "document/document.h"

/* Writes beside `path` and renames. 0, or errno. */
int html_write(const Document *document, const char *path, Theme theme);

/* Adds words as HTML shows them, also within a quoted attribute. */
void html_add_escaped(Text *text, const char *plain);
