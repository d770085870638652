/* The shapes around texts: tags, discs, leaders, and the list's line samples. */
#pragma once

#include "paint/drawing.h"

void drawing_caption_add_shape(Drawing *drawing, Ink *ink, const Caption *caption);
void drawing_caption_add_leader(Drawing *drawing, Ink *ink, const Caption *caption);
void drawing_caption_add_sample(Drawing *drawing, Ink *ink, const Sample *sample);

/* Returns the colour of a caption's text. */
Colour drawing_caption_ink(const Drawing *drawing, const Caption *caption);
