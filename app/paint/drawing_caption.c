#include "paint/drawing_caption.h"

#include "draw/caption.h"
#include "paint/drawing_pen.h"
#include "paint/paint_sizes.h"

static void add_tag(Drawing *drawing, Ink *ink, const Caption *caption) {
    Box box = caption_box(caption);
    InkColour fill = drawing_pen_colour(drawing, caption->fill, 1);
    InkPoint corners[] = {drawing_pen_page(drawing, box.low), drawing_pen_page(drawing, vec2(box.high.x, box.low.y)),
                          drawing_pen_page(drawing, box.high), drawing_pen_page(drawing, vec2(box.low.x, box.high.y))};
    ink_add_box(ink, drawing_pen_box(drawing, box), fill);
    /* round joints at the corners */
    ink_add_line(ink, corners, 4, true, drawing_pen_make(drawing, fill, LINE_SOLID, PAINT_TAG_ROUNDING));
}

static void add_disc(Drawing *drawing, Ink *ink, const Caption *caption) {
    double radius = (caption->extent.x - PAINT_DISC_RIM) / 2 * drawing->unit;
    InkPoint centre = drawing_pen_page(drawing, caption->centre);
    ink_add_disc(ink, centre, radius, drawing_pen_colour(drawing, caption->fill, 1));
    ink_add_ring(ink, centre, radius, PAINT_DISC_RIM * drawing->unit, drawing_pen_colour(drawing, ROLE_WALL, 1));
}

void drawing_caption_add_shape(Drawing *drawing, Ink *ink, const Caption *caption) {
    if (caption->shape == LABEL_TAG)
        add_tag(drawing, ink, caption);
    if (caption->shape == LABEL_DISC)
        add_disc(drawing, ink, caption);
}

void drawing_caption_add_leader(Drawing *drawing, Ink *ink, const Caption *caption) {
    Vec2 edge = paint_caption_edge(caption);
    InkColour halo = drawing_pen_colour(drawing, ROLE_PAPER, PAINT_HALO_OPACITY),
              line = drawing_pen_colour(drawing, ROLE_WALL, 1);
    drawing_pen_segment(drawing, ink, caption->pointed, edge,
                        drawing_pen_make(drawing, halo, LINE_SOLID, PAINT_LEADER_WIDTH + PAINT_HALO_WIDTH));
    drawing_pen_segment(drawing, ink, caption->pointed, edge,
                        drawing_pen_make(drawing, line, LINE_SOLID, PAINT_LEADER_WIDTH));
    ink_add_disc(ink, drawing_pen_page(drawing, caption->pointed), PAINT_LEADER_DOT * drawing->unit, line);
}

static void add_diamond(Drawing *drawing, Ink *ink, Vec2 at, InkColour colour) {
    static const bool borders[] = {true, true, false};
    Vec2 places[4];
    InkPoint corners[4];
    paint_diamond_corners(at, places);
    for (int i = 0; i < 4; i++)
        corners[i] = drawing_pen_page(drawing, places[i]);
    ink_add_triangle(ink, corners, borders, colour, NULL);
    ink_add_triangle(ink, (InkPoint[]){corners[2], corners[3], corners[0]}, borders, colour, NULL);
}

static void add_triangle(Drawing *drawing, Ink *ink, Vec2 at, InkColour colour) {
    Vec2 places[3];
    InkPoint corners[3];
    paint_triangle_corners(at, PAINT_SYMBOL_DIAMOND_HALF, places);
    for (int i = 0; i < 3; i++)
        corners[i] = drawing_pen_page(drawing, places[i]);
    ink_add_triangle(ink, corners, (bool[]){true, true, true}, colour, NULL);
}

void drawing_caption_add_sample(Drawing *drawing, Ink *ink, const Sample *sample) {
    InkColour colour = drawing_pen_colour(drawing, sample->role, 1);
    Vec2 middle = vec2_scale(vec2_add(sample->from, sample->to), 0.5);
    Vec2 half = {PAINT_SYMBOL_BOX_LENGTH / 2, PAINT_SYMBOL_HALF};
    if (sample->width > 0)
        drawing_pen_segment(drawing, ink, sample->from, sample->to,
                            drawing_pen_make(drawing, colour, sample->style, sample->width));
    if (sample->symbol == SYMBOL_DISC)
        ink_add_disc(ink, drawing_pen_page(drawing, middle), PAINT_SYMBOL_HALF * drawing->unit, colour);
    if (sample->symbol == SYMBOL_BOX)
        ink_add_box(ink, drawing_pen_box(drawing, (Box){vec2_sub(middle, half), vec2_add(middle, half)}), colour);
    if (sample->symbol == SYMBOL_DIAMOND)
        add_diamond(drawing, ink, middle, colour);
    if (sample->symbol == SYMBOL_TRIANGLE)
        add_triangle(drawing, ink, middle, colour);
}

Colour drawing_caption_ink(const Drawing *drawing, const Caption *caption) {
    return caption->shape == LABEL_BARE ? palette_colour(drawing->theme, caption->role)
                                        : palette_ink(drawing->theme, caption->fill);
}
