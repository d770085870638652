/* What tests ask of the captions of a layout. */
#pragma once

#include <stdbool.h>

#include "draw/caption.h"
#include "draw/layout.h"

bool captions_overlap(Box a, Box b);

/* Returns the first caption with a text, or NULL. */
const Caption *captions_find(const Layout *layout, const char *text);
