#include "draw/text.h"

#include <pango/pangocairo.h>
#include <string.h>

#include "base/digest.h"
#include "base/memory.h"
#include "base/visible.h"

enum {
    MEASURED_LONGEST = 96, /* bytes */
    MEASURED_KEPT = 512,   /* texts */
};

static bool is_character(gunichar code) {
    return (code & 0xfffe) != 0xfffe && !(code >= 0xfdd0 && code <= 0xfdef);
}

char *text_plain(const char *text) {
    char *utf8 = g_utf8_make_valid(text, -1), *valid = visible_text(utf8);
    char *copy = memory_zeroed(3 * strlen(valid) + 1, 1), *to = copy; /* a replacement has three bytes */
    for (const char *at = valid; *at; at = g_utf8_next_char(at)) {
        gunichar code = g_utf8_get_char(at);
        to += g_unichar_to_utf8(code == '\t' ? ' ' : is_character(code) ? code : 0xfffd, to);
    }
    g_free(utf8);
    memory_free(valid);
    return copy;
}

/* Lets glyphs be drawn without hints. Ends the program without memory: pango would draw them with hints. */
static void set_font_options(PangoContext *context) {
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    pango_cairo_context_set_font_options(context, options);
    if (!cairo_font_options_equal(pango_cairo_context_get_font_options(context), options))
        memory_end();
    cairo_font_options_destroy(options);
}

PangoLayout *text_layout(double size, bool bold, bool typed) {
    PangoContext *context = pango_font_map_create_context(pango_cairo_font_map_get_default());
    pango_context_set_round_glyph_positions(context, FALSE);
    set_font_options(context);
    PangoFontDescription *font = pango_font_description_new();
    pango_font_description_set_family_static(font, typed ? "DejaVu Sans Mono" : "DejaVu Sans");
    pango_font_description_set_absolute_size(font, size * PANGO_SCALE);
    pango_font_description_set_weight(font, bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    PangoLayout *layout = pango_layout_new(context);
    g_object_unref(context);
    pango_layout_set_font_description(layout, font);
    pango_font_description_free(font);
    return layout;
}

static PangoLayout *line_of(const char *text, double size, bool bold) {
    PangoLayout *layout = text_layout(size, bold, false);
    pango_layout_set_single_paragraph_mode(layout, TRUE);
    char *plain = text_plain(text);
    pango_layout_set_text(layout, plain, -1);
    memory_free(plain);
    return layout;
}

bool text_has_fonts(void) {
    PangoLayout *layout = line_of("A", 17, false);
    bool found = pango_layout_get_unknown_glyphs_count(layout) == 0;
    g_object_unref(layout);
    return found;
}

/* Without any font pango measures a line by numbers that mean nothing: its height is limited. */
static Vec2 layout_extent(PangoLayout *layout, double size) {
    const double highest = 4; /* parts of the size; the highest scripts need 2.5 */
    PangoRectangle logical;
    pango_layout_get_extents(layout, NULL, &logical);
    double height = (double)logical.height / PANGO_SCALE;
    bool means_nothing = height < 0 || height > highest * size;
    return vec2((double)logical.width / PANGO_SCALE, means_nothing ? size : height);
}

static Vec2 measure(const char *text, double size, bool bold) {
    PangoLayout *layout = line_of(text, size, bold);
    Vec2 extent = layout_extent(layout, size);
    g_object_unref(layout);
    return extent;
}

/* Pictures that follow one another measure the same texts: each thread keeps those of its last ones that are short, by
 * their digest, and another text of the same place replaces them. */
typedef struct Measured {
    char text[MEASURED_LONGEST]; /* "": no text is kept here */
    double size;
    bool bold;
    Vec2 extent;
} Measured;

Vec2 text_extent(const char *text, double size, bool bold) {
    static _Thread_local Measured kept[MEASURED_KEPT];
    size_t length = strlen(text);
    if (length == 0 || length >= MEASURED_LONGEST)
        return measure(text, size, bold);
    Measured *measured = &kept[(digest_mix(digest_text(DIGEST_START, text), size) >> 7) % MEASURED_KEPT];
    if (measured->size != size || measured->bold != bold || strcmp(measured->text, text) != 0) {
        memcpy(measured->text, text, length + 1);
        measured->size = size;
        measured->bold = bold;
        measured->extent = measure(text, size, bold);
    }
    return measured->extent;
}

/* Returns a layout of the text that begins at the current point of the cairo context. */
static PangoLayout *text_begin(cairo_t *cairo, const char *text, double size, bool bold, Vec2 centre) {
    PangoLayout *layout = line_of(text, size, bold);
    Vec2 extent = layout_extent(layout, size);
    cairo_move_to(cairo, centre.x - extent.x / 2, centre.y - extent.y / 2);
    return layout;
}

void text_show(cairo_t *cairo, const char *text, double size, bool bold, Vec2 centre) {
    PangoLayout *layout = text_begin(cairo, text, size, bold, centre);
    pango_cairo_show_layout(cairo, layout);
    cairo_new_path(cairo);
    g_object_unref(layout);
}

void text_path(cairo_t *cairo, const char *text, double size, bool bold, Vec2 centre) {
    PangoLayout *layout = text_begin(cairo, text, size, bold, centre);
    pango_cairo_layout_path(cairo, layout);
    g_object_unref(layout);
}
