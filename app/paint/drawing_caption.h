/* What stands around words: tags, discs, leaders, and the list's pieces of line. */
#pragma once

#include "paint/drawing.h"

void drawing_caption_add_shape(Drawing *drawing, Ink *ink, const Caption *caption);
void drawing_caption_add_leader(Drawing *drawing, Ink *ink, const Caption *caption);
void drawing_caption_add_sample(Drawing *drawing, Ink *ink, const Sample *sample);

/* The colour of a caption's words. */
Colour drawing_caption_ink(const Drawing *drawing, const Caption *caption);
