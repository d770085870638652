/* Colours, pens and points of a drawing: what both its flat and its solid primitives, and the texts around them, use.
 */
#pragma once

#include "paint/drawing.h"

/* For the texts around a picture: design points, not in perspective. */
InkColour drawing_pen_colour(const Drawing *drawing, Role role, double opacity);
InkPen drawing_pen_make(const Drawing *drawing, InkColour colour, LineStyle style, double width);
InkPoint drawing_pen_page(const Drawing *drawing, Vec2 at);
Box drawing_pen_box(const Drawing *drawing, Box box);
void drawing_pen_segment(Drawing *drawing, Ink *ink, Vec2 from, Vec2 to, InkPen pen);

/* Returns a point of the scene at this height above the floor, m. */
InkPoint drawing_pen_point(const Drawing *drawing, const Layout *layout, Vec2 at, double height);

/* Returns how many corners make a polygon look round at this radius, pixels; at most DRAWING_PEN_CORNERS. */
enum { DRAWING_PEN_CORNERS = 96 };
size_t drawing_pen_circle(double radius);
