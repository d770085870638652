#include "draw/caption.h"

#include <stdio.h>
#include <string.h>

#include "draw/text.h"

#define TAG_PADDING 5.0 /* design points, left and right of the text */
#define DISC_LEAST 14.0 /* design points, radius */

Caption *caption_add(Layout *layout, const char *text, double size, bool bold, Vec2 centre) {
    layout->captions = memory_reserve(layout->captions, &layout->caption_capacity, layout->caption_count + 1,
                                      sizeof *layout->captions);
    Caption *caption = &layout->captions[layout->caption_count++];
    *caption = (Caption){.text = arena_text(&layout->arena, text),
                         .centre = centre,
                         .extent = text_extent(text, size, bold),
                         .size = size,
                         .bold = bold,
                         .role = ROLE_TEXT};
    return caption;
}

Box caption_box(const Caption *caption) {
    Vec2 half = vec2_scale(caption->turned ? vec2(caption->extent.y, caption->extent.x) : caption->extent, 0.5);
    return (Box){vec2_sub(caption->centre, half), vec2_add(caption->centre, half)};
}

void caption_shape(Caption *caption, LabelShape shape, Role fill) {
    caption->shape = shape;
    caption->fill = fill;
    if (shape == LABEL_TAG)
        caption->extent.x += 2 * TAG_PADDING;
    if (shape == LABEL_DISC)
        caption->extent.x = caption->extent.y = 2 * fmax(DISC_LEAST, caption->extent.x / 2 + TAG_PADDING);
}

/* True if no character of UTF-8 begins with this byte. */
static bool is_within_character(char byte) {
    return ((unsigned char)byte & 0xC0) == 0x80;
}

const char *caption_shortened(Layout *layout, const char *text, double size, bool bold, double width) {
    static const char ellipsis[] = "\u2026";
    if (text_extent(text, size, bold).x <= width)
        return text;
    size_t fits = 0, too_long = strlen(text); /* bytes of the text */
    char *shorter = arena_allocate(&layout->arena, too_long + sizeof ellipsis);
    for (;;) {
        size_t middle = fits + (too_long - fits) / 2;
        while (middle > fits && is_within_character(text[middle]))
            middle--;
        middle += middle == fits;
        while (is_within_character(text[middle]))
            middle++;
        if (middle >= too_long)
            break;
        snprintf(shorter, middle + sizeof ellipsis, "%.*s%s", (int)middle, text, ellipsis);
        if (text_extent(shorter, size, bold).x <= width)
            fits = middle;
        else
            too_long = middle;
    }
    snprintf(shorter, fits + sizeof ellipsis, "%.*s%s", (int)fits, text, ellipsis);
    return shorter;
}

/* True if a clause ends before text[at]: at a mark that a space follows, outside brackets (`depth` of them are open).
 * The full stop after a single letter belongs to an abbreviation. */
static bool ends_clause(const char *text, size_t at, int depth) {
    return depth == 0 && at > 1 && text[at + 1] == ' ' && strchr(",;:.", text[at]) &&
           !(text[at] == '.' && text[at - 2] == ' ');
}

const char *caption_of_clauses(Layout *layout, const char *text, double size, bool bold, double width) {
    if (text_extent(text, size, bold).x <= width)
        return text;
    static const char more[] = " \u2026"; /* what is left out may qualify the rest */
    size_t length = strlen(text), fits = 0;
    char *shorter = arena_allocate(&layout->arena, length + sizeof more);
    int depth = 0;
    for (size_t at = 0; at < length; at++) {
        depth += (text[at] == '(') - (text[at] == ')');
        if (!ends_clause(text, at, depth))
            continue;
        snprintf(shorter, at + sizeof more, "%.*s%s", (int)at, text, more);
        if (text_extent(shorter, size, bold).x > width)
            break;
        fits = at;
    }
    snprintf(shorter, fits + sizeof more, "%.*s%s", (int)fits, text, more);
    return fits ? shorter : caption_shortened(layout, text, size, bold, width);
}
