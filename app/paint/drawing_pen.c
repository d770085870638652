#include "paint/drawing_pen.h"

#include "paint/paint_sizes.h"

#define CIRCLE_ERROR 0.2 /* pixels, the largest distance between the polygon and its circle */

enum { CIRCLE_FEWEST = 8 /* corners */ };

InkColour drawing_pen_colour(const Drawing *drawing, Role role, double opacity) {
    return (InkColour){palette_colour(drawing->theme, role), opacity};
}

InkPen drawing_pen_make(const Drawing *drawing, InkColour colour, LineStyle style, double width) {
    return (InkPen){.colour = colour,
                    .width = width * drawing->unit,
                    .style = style,
                    .dash = paint_dash_scale(width) * drawing->unit};
}

InkPoint drawing_pen_page(const Drawing *drawing, Vec2 at) {
    return (InkPoint){vec2_scale(at, drawing->unit), 0};
}

Box drawing_pen_box(const Drawing *drawing, Box box) {
    return (Box){vec2_scale(box.low, drawing->unit), vec2_scale(box.high, drawing->unit)};
}

void drawing_pen_segment(Drawing *drawing, Ink *ink, Vec2 from, Vec2 to, InkPen pen) {
    ink_add_line(ink, (InkPoint[]){drawing_pen_page(drawing, from), drawing_pen_page(drawing, to)}, 2, false, pen);
}

InkPoint drawing_pen_point(const Drawing *drawing, const Layout *layout, Vec2 at, double height) {
    return (InkPoint){vec2_scale(layout_raised(layout, at, height), drawing->unit),
                      view_depth(&layout->view, at, height)};
}

size_t drawing_pen_circle(double radius) {
    double turn = 2 * acos(1 - CIRCLE_ERROR / fmax(radius, 1));
    return (size_t)real_clamp(ceil(2 * M_PI / turn), CIRCLE_FEWEST, DRAWING_PEN_CORNERS);
}
