/* The sheets of paper that a document is set on, A4, from the top down; the texts on them, and where a new sheet
 * begins. Lengths are in points, 1/72 inch, y down. A sheet without a cairo context is only counted. */
#pragma once

#include <pango/pango.h>
#include <stdbool.h>

#include "document/document.h"

/* A4 and its margins, pt. */
#define SHEET_PAPER_WIDTH 595.276
#define SHEET_PAPER_HEIGHT 841.890
#define SHEET_LEFT 56.0
#define SHEET_TOP 54.0
#define SHEET_BOTTOM 784.0
#define SHEET_WIDTH (SHEET_PAPER_WIDTH - 2 * SHEET_LEFT)

typedef struct TextStyle {
    double size;    /* pt */
    double spacing; /* of lines, 1: the font's own */
    bool bold, typed;
    Role role;
} TextStyle;

typedef struct Sheet {
    struct _cairo *cairo; /* NULL: pages are only counted */
    const char *foot;     /* at the foot of every page */
    int page, pages;      /* the number, from 1; the total, 0: not known yet */
    double y;             /* pt, where the next block begins */
} Sheet;

/* Begins the first page; ends the last one. */
void sheet_begin(Sheet *sheet);
void sheet_end(Sheet *sheet);

/* Begins the next page if this height, pt, has no room; false if it has room. */
bool sheet_need(Sheet *sheet, double height);

/* Leaves a gap between two blocks, but not at the top of a page. */
void sheet_gap(Sheet *sheet, double height);

/* Returns a text set within a width, pt; the caller frees it with g_object_unref. With a height, pt, it is cut there;
 * 0: not cut. */
PangoLayout *sheet_text(const char *text, TextStyle style, double width, Align align, double height);
double sheet_text_height(PangoLayout *layout);

/* Shows a text with its top left corner at x, y. */
void sheet_show(const Sheet *sheet, PangoLayout *text, TextStyle style, double x, double y);

/* Sets a text line by line, from page to page, as a paragraph; `under` paints the ground of each piece, or is NULL. */
void sheet_flow(Sheet *sheet, PangoLayout *text, TextStyle style, double x,
                void (*under)(const Sheet *sheet, double top, double bottom));

void sheet_rule(const Sheet *sheet, double x, double width, double y, double weight, Role role);
void sheet_fill(const Sheet *sheet, double x, double y, double width, double height, Role role);

/* Tags the content in between, as PDF names it: "P", "H1", "Table" and so on. */
void sheet_tag(const Sheet *sheet, const char *tag, const char *attributes);
void sheet_untag(const Sheet *sheet, const char *tag);
