/* A document as one self-contained HTML file: pictures are inside, there is no script, and the fonts are those of the
 * system. The file is well-formed XML, too. The same document and theme give the same bytes. */
#pragma once

#include "base/text.h"
#include "document/document.h"

/* Writes to a temporary file, then renames it to `path`. Returns 0, or errno. */
int html_write(const Document *document, const char *path, Theme theme);

/* Adds a text with HTML's characters escaped, also for a quoted attribute. */
void html_add_escaped(Text *text, const char *plain);
