/* Pictures of whole plans in a report: their sizes, alone and side by side. */
#pragma once

#include "document/document.h"

/* Adds a picture of page width or, for a high plan, of the largest height. Takes the scene over. */
void report_pictures_add(Document *document, Scene *scene, const char *caption, const char *alternative);

/* Adds pictures of one box, m, all at the same scale: two side by side or, if they are very wide, one below the other.
 * Takes the scenes over. */
void report_pictures_add_beside(Document *document, Scene *scenes, size_t count, Box box, const char *const *captions);

/* Returns the smallest box that holds both. */
Box report_pictures_box(Box a, Box b);
