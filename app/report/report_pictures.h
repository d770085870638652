/* Pictures of whole plans in a report: how large they are, alone and side by side. */
#pragma once

#include "document/document.h"

/* Adds a picture as wide as a page or, of a plan that would be higher than is good, as high. Takes the scene over. */
void report_pictures_add(Document *document, Scene *scene, const char *caption, const char *alternative);

/* Adds pictures of one box, m, so that a metre is as long in all of them: two and two side by side or, where they are
 * far wider than high, one below the other. Takes the scenes over. */
void report_pictures_add_beside(Document *document, Scene *scenes, size_t count, Box box, const char *const *captions);

/* The smallest box that holds both. */
Box report_pictures_box(Box a, Box b);
