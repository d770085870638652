/* Primitives with height in the raised view: prisms, sheets, cylinders, wheels and balls. Their tops have the role's
 * own colour, their sides are lit from the upper left: darker, or lighter where the role is too dark to show it. */
#pragma once

#include "paint/drawing.h"

void drawing_solid_add(Drawing *drawing, const Layout *layout, const Primitive *primitive);

/* The direction towards the light in the picture: x to the right, y down, z out of it. */
extern const float drawing_solid_light[3];
