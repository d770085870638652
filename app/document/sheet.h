/* The sheets of paper that a document is set on, A4, from the top down; words on them, and where a new one begins.
 * Lengths are in points, 1/72 inch, y down. A sheet without a cairo context is only counted. */
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
    double spacing; /* of lines, 1: as the font has it */
    bool bold, typed;
    Role role;
} TextStyle;

typedef struct Sheet {
    struct _cairo *cairo; /* NULL: pages are only counted */
    const char *foot;     /* at the foot of every page */
    int page, pages;      /* from 1; how many there are, 0: not known yet */
    double y;             /* pt, where the next thing begins */
} Sheet;

/* Begins the first page; ends the last one. */
void sheet_begin(Sheet *sheet);
void sheet_end(Sheet *sheet);

/* Begins the next page where there is no room for so much, pt; false: it fits here. */
bool sheet_need(Sheet *sheet, double height);

/* Leaves room between two things, but not at the top of a page. */
void sheet_gap(Sheet *sheet, double height);

/* Words set within a width, pt; g_object_unref them. Those with a height, pt, are cut where they would be higher; 0:
 * as high as they are. */
PangoLayout *sheet_text(const char *text, TextStyle style, double width, Align align, double height);
double sheet_text_height(PangoLayout *layout);

/* Shows them with the top left corner there. */
void sheet_show(const Sheet *sheet, PangoLayout *text, TextStyle style, double x, double y);

/* Sets words line by line, from page to page, as a paragraph; `under` paints the ground of each piece, or is NULL. */
void sheet_flow(Sheet *sheet, PangoLayout *text, TextStyle style, double x,
                void (*under)(const Sheet *sheet, double top, double bottom));

void sheet_rule(const Sheet *sheet, double x, double width, double y, double weight, Role role);
void sheet_fill(const Sheet *sheet, double x, double y, double width, double height, Role role);

/* Tags what is shown in between, as PDF names it: "P", "H1", "Table" and so on. */
void sheet_tag(const Sheet *sheet, const char *tag, const char *attributes);
void sheet_untag(const Sheet *sheet, const char *tag);
