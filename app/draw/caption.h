/* The texts of a layout: their size, the box and the shape around each, and how a long text is shortened. */
#pragma once

#include "draw/layout.h"

/* Adds a text in the middle of a box of the text's own size; the pointer is valid until the next addition. */
Caption *caption_add(Layout *layout, const char *text, double size, bool bold, Vec2 centre);

/* Returns the box that holds the text, turned as the text is. */
Box caption_box(const Caption *caption);

/* Gives the caption a tag or a disc of `fill`, and enlarges its box by what the shape needs. */
void caption_shape(Caption *caption, LabelShape shape, Role fill);

/* Returns the text, or as much of its beginning as `width` holds, followed by an ellipsis; stored in the layout. */
const char *caption_shortened(Layout *layout, const char *text, double size, bool bold, double width);

/* Returns the text, or as many of its clauses as `width` holds, with an ellipsis in place of the mark that ends the
 * last of them; if it does not hold the first one, that is shortened. Stored in the layout. */
const char *caption_of_clauses(Layout *layout, const char *text, double size, bool bold, double width);
