#include "document/sheet.h"

#include <pango/pangocairo.h>
#include <stdio.h>

#include "draw/palette.h"
#include "draw/text.h"

#define FOOT_Y 800.0

static const TextStyle FOOT = {8, 1, false, false, ROLE_DIM_TEXT};

enum { LEAST_LINES = 2 /* of a paragraph, kept together at the end of a page */ };

static void use_role(const Sheet *sheet, Role role) {
    Colour colour = palette_colour(THEME_PAPER, role);
    cairo_set_source_rgb(sheet->cairo, colour.red, colour.green, colour.blue);
}

static void show_foot(const Sheet *sheet) {
    char number[64];
    snprintf(number, sizeof number, "page %d of %d", sheet->page, sheet->pages);
    PangoLayout *right = sheet_text(number, FOOT, SHEET_WIDTH, ALIGN_RIGHT, 0);
    PangoLayout *left = sheet_text(sheet->foot, FOOT, 0.8 * SHEET_WIDTH, ALIGN_LEFT, FOOT.size);
    sheet_rule(sheet, SHEET_LEFT, SHEET_WIDTH, FOOT_Y - 6, 0.5, ROLE_GRID);
    sheet_show(sheet, left, FOOT, SHEET_LEFT, FOOT_Y);
    sheet_show(sheet, right, FOOT, SHEET_LEFT, FOOT_Y);
    g_object_unref(left);
    g_object_unref(right);
}

void sheet_begin(Sheet *sheet) {
    sheet->page++;
    sheet->y = SHEET_TOP;
}

void sheet_end(Sheet *sheet) {
    if (!sheet->cairo)
        return;
    show_foot(sheet);
    cairo_show_page(sheet->cairo);
}

static void begin_next(Sheet *sheet) {
    sheet_end(sheet);
    sheet_begin(sheet);
}

bool sheet_need(Sheet *sheet, double height) {
    bool full = sheet->y + height > SHEET_BOTTOM && sheet->y > SHEET_TOP;
    if (full)
        begin_next(sheet);
    return full;
}

void sheet_gap(Sheet *sheet, double height) {
    if (sheet->y > SHEET_TOP)
        sheet->y += height;
}

PangoLayout *sheet_text(const char *text, TextStyle style, double width, Align align, double height) {
    PangoLayout *layout = text_layout(style.size, style.bold, style.typed);
    PangoAttrList *attributes = pango_attr_list_new(); /* ligatures confuse screen readers */
    pango_attr_list_insert(attributes, pango_attr_font_features_new("liga 0, clig 0"));
    pango_layout_set_attributes(layout, attributes);
    pango_attr_list_unref(attributes);
    pango_layout_set_line_spacing(layout, (float)style.spacing);
    pango_layout_set_width(layout, (int)(width * PANGO_SCALE));
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
    pango_layout_set_alignment(layout, align == ALIGN_RIGHT ? PANGO_ALIGN_RIGHT : PANGO_ALIGN_LEFT);
    if (height > 0) {
        pango_layout_set_height(layout, (int)(height * PANGO_SCALE));
        pango_layout_set_ellipsize(layout, PANGO_ELLIPSIZE_END);
    }
    pango_layout_set_text(layout, text, -1);
    return layout;
}

double sheet_text_height(PangoLayout *text) {
    PangoRectangle logical;
    pango_layout_get_extents(text, NULL, &logical);
    return (double)logical.height / PANGO_SCALE;
}

void sheet_show(const Sheet *sheet, PangoLayout *text, TextStyle style, double x, double y) {
    if (!sheet->cairo)
        return;
    use_role(sheet, style.role);
    cairo_move_to(sheet->cairo, x, y);
    pango_cairo_show_layout(sheet->cairo, text);
    cairo_new_path(sheet->cairo);
}

/* Returns how many lines from `first` fit on the page, and their height. */
static int lines_that_fit(const Sheet *sheet, PangoLayout *text, int first, double *height) {
    int count = pango_layout_get_line_count(text), fit = 0;
    *height = 0;
    for (int l = first; l < count; l++, fit++) {
        PangoRectangle logical;
        pango_layout_line_get_extents(pango_layout_get_line_readonly(text, l), NULL, &logical);
        double line = (double)logical.height / PANGO_SCALE;
        if (sheet->y + *height + line > SHEET_BOTTOM && (fit || sheet->y > SHEET_TOP))
            break;
        *height += line;
    }
    return fit;
}

static void show_lines(const Sheet *sheet, PangoLayout *text, TextStyle style, int first, int count, double x) {
    double top = sheet->y;
    use_role(sheet, style.role);
    for (int l = first; l < first + count; l++) {
        PangoLayoutLine *line = pango_layout_get_line_readonly(text, l);
        PangoRectangle logical;
        pango_layout_line_get_extents(line, NULL, &logical);
        cairo_move_to(sheet->cairo, x, top - (double)logical.y / PANGO_SCALE);
        pango_cairo_show_layout_line(sheet->cairo, line);
        top += (double)logical.height / PANGO_SCALE;
    }
    cairo_new_path(sheet->cairo);
}

void sheet_flow(Sheet *sheet, PangoLayout *text, TextStyle style, double x,
                void (*under)(const Sheet *sheet, double top, double bottom)) {
    int count = pango_layout_get_line_count(text);
    for (int first = 0, fit; first < count; first += fit) {
        double height;
        fit = lines_that_fit(sheet, text, first, &height);
        if (fit < LEAST_LINES && fit < count - first && sheet->y > SHEET_TOP) {
            begin_next(sheet);
            fit = lines_that_fit(sheet, text, first, &height);
        }
        if (sheet->cairo) {
            if (under)
                under(sheet, sheet->y, sheet->y + height);
            show_lines(sheet, text, style, first, fit, x);
        }
        sheet->y += height;
        if (first + fit < count)
            begin_next(sheet);
    }
}

void sheet_rule(const Sheet *sheet, double x, double width, double y, double weight, Role role) {
    sheet_fill(sheet, x, y - weight / 2, width, weight, role);
}

void sheet_fill(const Sheet *sheet, double x, double y, double width, double height, Role role) {
    if (!sheet->cairo)
        return;
    use_role(sheet, role);
    cairo_rectangle(sheet->cairo, x, y, width, height);
    cairo_fill(sheet->cairo);
}

void sheet_tag(const Sheet *sheet, const char *tag, const char *attributes) {
    if (sheet->cairo)
        cairo_tag_begin(sheet->cairo, tag, attributes);
}

void sheet_untag(const Sheet *sheet, const char *tag) {
    if (sheet->cairo)
        cairo_tag_end(sheet->cairo, tag);
}
