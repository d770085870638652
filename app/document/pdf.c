#include "document/pdf.h"

#include <cairo-pdf.h>
#include <errno.h>
#include <stdio.h>

#include "base/file_write.h"
#include "document/pdf_table.h"
#include "document/sheet.h"
#include "paint/cairo_file.h"

/* pt */
#define PARAGRAPH_GAP 6.0
#define BLOCK_GAP 11.0
#define NOTE_PAD 8.0
#define NOTE_BAR 4.0
#define PICTURE_GAP 14.0
#define CAPTION_GAP 4.0
#define CAPTION_HIGHEST 200.0
#define FIGURES_HIGHEST 560.0 /* of the pictures alone: heading and caption have room next to them */
#define ENTRY_GAP 14.0
#define ANNOUNCEMENT_HIGHEST 60.0

#define PICTURE_SCALE 0.47 /* pt per design point, at most: the smallest text is as large as the page's */
#define PICTURE_EDGE 0.5

static const TextStyle BODY = {9.4, 1.3, false, false, ROLE_TEXT};
static const TextStyle ABOVE = {9.4, 1.3, false, false, ROLE_DIM_TEXT};
static const TextStyle TYPED = {8.2, 1.3, false, true, ROLE_TEXT};
static const TextStyle UNDER = {8.3, 1.2, false, false, ROLE_DIM_TEXT};
static const TextStyle LINK = {9.4, 1.3, false, false, ROLE_LOCUS};
static const TextStyle HEADINGS[] = {
    {0}, {20, 1.15, true, false, ROLE_TEXT}, {14, 1.15, true, false, ROLE_TEXT}, {10.5, 1.15, true, false, ROLE_TEXT}};
static const double ABOVE_HEADING[] = {0, 0, 22, 14}, BELOW_HEADING[] = {0, 8, 6, 3};

/* Where the headings are: known once all pages are counted. */
typedef struct Press {
    const Document *document;
    Sheet sheet;
    int *page_of;             /* (count) of each block */
    cairo_surface_t *surface; /* NULL while pages are counted */
    int chapter;              /* the bookmark of the last heading of level 2 */
} Press;

static PangoLayout *layout_of(const char *text, TextStyle style) {
    return sheet_text(text, style, SHEET_WIDTH, ALIGN_LEFT, 0);
}

static double height_of(const char *text, TextStyle style) {
    PangoLayout *layout = layout_of(text, style);
    double height = sheet_text_height(layout);
    g_object_unref(layout);
    return height;
}

/* Figures -----------------------------------------------------------------------------------------------------------*/

/* Returns the pt per design point of all pictures of a row. */
static double figures_scale(const Block *block) {
    double width = 0, height = 0, gaps = PICTURE_GAP * (double)(block->picture_count - 1);
    for (size_t p = 0; p < block->picture_count; p++) {
        width += block->pictures[p].size.x;
        height = fmax(height, block->pictures[p].size.y);
    }
    return fmin(PICTURE_SCALE, fmin((SHEET_WIDTH - gaps) / width, FIGURES_HIGHEST / height));
}

static PangoLayout *caption_layout(const Picture *picture, double scale) {
    const char *caption = picture->caption ? picture->caption : "";
    return sheet_text(caption, UNDER, scale * picture->size.x, ALIGN_LEFT, CAPTION_HIGHEST);
}

static double figures_height(const Block *block) {
    double scale = figures_scale(block), height = 0;
    for (size_t p = 0; p < block->picture_count; p++) {
        PangoLayout *text = caption_layout(&block->pictures[p], scale);
        height = fmax(height, scale * block->pictures[p].size.y + CAPTION_GAP + sheet_text_height(text));
        g_object_unref(text);
    }
    return height;
}

static void paint_picture(cairo_t *cairo, const Picture *picture, double scale, double x, double y) {
    Vec2 size = picture->size;
    cairo_save(cairo);
    cairo_translate(cairo, x, y);
    cairo_scale(cairo, scale, scale);
    cairo_rectangle(cairo, 0, 0, size.x, size.y);
    cairo_clip(cairo);
    picture->paint(picture->context, cairo, size, THEME_PAPER);
    cairo_restore(cairo);
    Colour edge = palette_colour(THEME_PAPER, ROLE_GRID);
    cairo_set_source_rgb(cairo, edge.red, edge.green, edge.blue);
    cairo_set_line_width(cairo, PICTURE_EDGE);
    cairo_rectangle(cairo, x, y, scale * size.x, scale * size.y);
    cairo_stroke(cairo);
}

static void set_figures(Sheet *sheet, const Block *block) {
    double scale = figures_scale(block), height = figures_height(block), x = SHEET_LEFT;
    sheet_need(sheet, height);
    for (size_t p = 0; p < block->picture_count; p++) {
        const Picture *picture = &block->pictures[p];
        sheet_tag(sheet, "Figure", NULL);
        if (sheet->cairo)
            paint_picture(sheet->cairo, picture, scale, x, sheet->y);
        sheet_untag(sheet, "Figure");
        PangoLayout *text = caption_layout(picture, scale);
        sheet_tag(sheet, "Caption", NULL);
        sheet_show(sheet, text, UNDER, x, sheet->y + scale * picture->size.y + CAPTION_GAP);
        sheet_untag(sheet, "Caption");
        g_object_unref(text);
        x += scale * picture->size.x + PICTURE_GAP;
    }
    sheet->y += height;
}

/* Texts -------------------------------------------------------------------------------------------------------------*/

static void set_text(Sheet *sheet, const char *text, TextStyle style) {
    PangoLayout *layout = layout_of(text, style);
    sheet_flow(sheet, layout, style, SHEET_LEFT, NULL);
    g_object_unref(layout);
}

static void paint_note(const Sheet *sheet, double top, double bottom) {
    double height = bottom - top + NOTE_PAD;
    sheet_fill(sheet, SHEET_LEFT, top - NOTE_PAD / 2, SHEET_WIDTH, height, ROLE_PANEL);
    sheet_fill(sheet, SHEET_LEFT, top - NOTE_PAD / 2, NOTE_BAR, height, ROLE_DANGER_MIDDLE);
}

static void paint_command(const Sheet *sheet, double top, double bottom) {
    sheet_fill(sheet, SHEET_LEFT, top - NOTE_PAD / 2, SHEET_WIDTH, bottom - top + NOTE_PAD, ROLE_PANEL);
}

static void set_panel(Sheet *sheet, const char *text, TextStyle style,
                      void (*under)(const Sheet *sheet, double top, double bottom)) {
    double inset = NOTE_BAR + NOTE_PAD;
    PangoLayout *layout = sheet_text(text, style, SHEET_WIDTH - inset - NOTE_PAD, ALIGN_LEFT, 0);
    sheet->y += NOTE_PAD / 2;
    sheet_tag(sheet, "P", NULL);
    sheet_flow(sheet, layout, style, SHEET_LEFT + inset, under);
    sheet_untag(sheet, "P");
    sheet->y += NOTE_PAD / 2;
    g_object_unref(layout);
}

/* Sets the entries one after the other, in as many lines as needed: "Dangerous points 3". */
static void set_contents(Press *press) {
    Sheet *sheet = &press->sheet;
    double x = SHEET_LEFT, height = 0;
    for (size_t b = 0; b < press->document->count; b++) {
        const Block *block = &press->document->blocks[b];
        if (block->kind != BLOCK_HEADING || block->level != 2)
            continue;
        char text[256], attributes[64];
        snprintf(text, sizeof text, "%.200s  %d", block->text, press->page_of[b]);
        snprintf(attributes, sizeof attributes, "dest='s%zu'", b);
        PangoLayout *layout = sheet_text(text, LINK, -1, ALIGN_LEFT, 0);
        pango_layout_set_width(layout, -1);
        PangoRectangle logical;
        pango_layout_get_extents(layout, NULL, &logical);
        double width = (double)logical.width / PANGO_SCALE;
        height = (double)logical.height / PANGO_SCALE;
        if (x > SHEET_LEFT && x + width > SHEET_LEFT + SHEET_WIDTH) {
            x = SHEET_LEFT;
            sheet->y += height;
        }
        sheet_tag(sheet, CAIRO_TAG_LINK, attributes);
        sheet_show(sheet, layout, LINK, x, sheet->y);
        sheet_untag(sheet, CAIRO_TAG_LINK);
        g_object_unref(layout);
        x += width + ENTRY_GAP;
    }
    sheet->y += height;
}

/* Headings ----------------------------------------------------------------------------------------------------------*/

static double least_height(const Document *document, size_t index);

/* True if a paragraph is short: it then announces the table or the pictures below it and must stay with them. */
static double paragraph_least(const Document *document, size_t index) {
    double height = height_of(document->blocks[index].text, BODY);
    bool announces = index + 1 < document->count && (document->blocks[index + 1].kind == BLOCK_TABLE ||
                                                     document->blocks[index + 1].kind == BLOCK_FIGURES ||
                                                     document->blocks[index + 1].kind == BLOCK_COMMAND);
    if (!announces || height > ANNOUNCEMENT_HIGHEST)
        return fmin(height, 2 * BODY.size * BODY.spacing);
    return height + least_height(document, index + 1);
}

/* Returns the height, pt, of the blocks from `index` that must stand together: a heading stays with the next block. */
static double least_height(const Document *document, size_t index) {
    if (index >= document->count)
        return 0;
    const Block *block = &document->blocks[index];
    switch (block->kind) {
    case BLOCK_HEADING:
        return ABOVE_HEADING[block->level] + height_of(block->text, HEADINGS[block->level]) +
               BELOW_HEADING[block->level] + least_height(document, index + 1);
    case BLOCK_TABLE:
        return BLOCK_GAP + pdf_table_least(&block->table);
    case BLOCK_FIGURES:
        return BLOCK_GAP + figures_height(block);
    case BLOCK_PARAGRAPH:
        return PARAGRAPH_GAP + paragraph_least(document, index);
    case BLOCK_CONTENTS:
    case BLOCK_NOTE:
    case BLOCK_COMMAND:
        return 3 * BODY.size * BODY.spacing + BLOCK_GAP;
    }
    return 0;
}

static void add_bookmark(Press *press, size_t index, const char *attributes) {
    const Block *block = &press->document->blocks[index];
    if (block->level == 1)
        return;
    int parent = block->level == 2 ? CAIRO_PDF_OUTLINE_ROOT : press->chapter;
    int id =
        cairo_pdf_surface_add_outline(press->surface, parent, block->text, attributes, CAIRO_PDF_OUTLINE_FLAG_OPEN);
    if (block->level == 2)
        press->chapter = id;
}

static void set_heading(Press *press, size_t index) {
    Sheet *sheet = &press->sheet;
    const Block *block = &press->document->blocks[index];
    const char *const tags[] = {"", "H1", "H2", "H3"};
    char name[64], place[64];
    sheet_need(sheet, least_height(press->document, index));
    sheet_gap(sheet, ABOVE_HEADING[block->level]);
    press->page_of[index] = sheet->page;
    snprintf(name, sizeof name, "name='s%zu'", index);
    snprintf(place, sizeof place, "dest='s%zu'", index);
    if (press->surface)
        add_bookmark(press, index, place);
    if (block->level == 1) {
        sheet_tag(sheet, "P", NULL);
        set_text(sheet, press->document->subject, ABOVE);
        sheet_untag(sheet, "P");
        sheet->y += BELOW_HEADING[3];
    }
    sheet_tag(sheet, tags[block->level], NULL);
    sheet_tag(sheet, CAIRO_TAG_DEST, name);
    set_text(sheet, block->text, HEADINGS[block->level]);
    sheet_untag(sheet, CAIRO_TAG_DEST);
    sheet_untag(sheet, tags[block->level]);
    sheet->y += BELOW_HEADING[block->level];
}

/* Pages -------------------------------------------------------------------------------------------------------------*/

static void set_block(Press *press, size_t index) {
    Sheet *sheet = &press->sheet;
    const Block *block = &press->document->blocks[index];
    switch (block->kind) {
    case BLOCK_HEADING:
        set_heading(press, index);
        return;
    case BLOCK_PARAGRAPH:
        sheet_need(sheet, least_height(press->document, index));
        sheet_tag(sheet, "P", NULL);
        set_text(sheet, block->text, BODY);
        sheet_untag(sheet, "P");
        sheet->y += PARAGRAPH_GAP;
        return;
    case BLOCK_CONTENTS:
        set_contents(press);
        break;
    case BLOCK_NOTE:
        set_panel(sheet, block->text, BODY, paint_note);
        break;
    case BLOCK_COMMAND:
        set_panel(sheet, block->text, TYPED, paint_command);
        break;
    case BLOCK_TABLE:
        sheet_need(sheet, pdf_table_least(&block->table));
        pdf_table_set(sheet, &block->table);
        break;
    case BLOCK_FIGURES:
        set_figures(sheet, block);
        break;
    }
    sheet->y += BLOCK_GAP;
}

static void set_all(Press *press) {
    sheet_begin(&press->sheet);
    sheet_tag(&press->sheet, "Document", NULL);
    for (size_t b = 0; b < press->document->count; b++)
        set_block(press, b);
    sheet_untag(&press->sheet, "Document");
    sheet_end(&press->sheet);
}

static void describe(cairo_surface_t *surface, const Document *document, time_t created) {
    char date[32];
    struct tm utc;
    gmtime_r(&created, &utc);
    strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &utc);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, document->title);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, document->subject);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_AUTHOR, document->creator);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, document->creator);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, date);
}

static cairo_status_t store_bytes(void *context, const unsigned char *data, unsigned length) {
    bytes_add(context, data, length);
    return CAIRO_STATUS_SUCCESS;
}

/* The first pass counts pages and finds headings, the second one paints. */
static int paint_pages(Bytes *bytes, const Document *document, time_t created) {
    Press press = {.document = document, .page_of = memory_zeroed(document->count, sizeof *press.page_of)};
    set_all(&press);
    press.surface = cairo_pdf_surface_create_for_stream(store_bytes, bytes, SHEET_PAPER_WIDTH, SHEET_PAPER_HEIGHT);
    describe(press.surface, document, created);
    press.sheet = (Sheet){.cairo = cairo_create(press.surface), .foot = document->subject, .pages = press.sheet.page};
    set_all(&press);
    cairo_status_t status = cairo_status(press.sheet.cairo);
    cairo_destroy(press.sheet.cairo);
    cairo_surface_finish(press.surface);
    status = status ? status : cairo_surface_status(press.surface);
    cairo_surface_destroy(press.surface);
    memory_free(press.page_of);
    if (status == CAIRO_STATUS_SUCCESS)
        return cairo_file_pdf_is_whole(bytes) ? 0 : ENOMEM;
    return status == CAIRO_STATUS_NO_MEMORY ? ENOMEM : EINVAL;
}

int pdf_write(const Document *document, const char *path, time_t created) {
    Bytes bytes = {0};
    int error = paint_pages(&bytes, document, created);
    if (!error)
        error = file_write_bytes(path, bytes.at, bytes.size);
    memory_free(bytes.at);
    return error;
}
