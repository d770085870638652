/* A page as data: headings, paragraphs, tables and pictures in reading order. A report is built as a document; html.h
 * and pdf.h write it. A document knows neither houses nor files.
 *
 * All texts are copied and made plain: invalid UTF-8 and codes that are not characters are replaced, so that every
 * writer can rely on valid text; except in commands, no line is broken between a number and its unit. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"
#include "base/vec2.h"
#include "draw/palette.h"
#include "draw/scene.h"

struct _cairo; /* cairo's own name of cairo_t */

typedef enum BlockKind {
    BLOCK_HEADING,
    BLOCK_CONTENTS, /* links to the headings of the second level */
    BLOCK_PARAGRAPH,
    BLOCK_NOTE,    /* a caveat that must be noticed */
    BLOCK_COMMAND, /* a command line, line by line */
    BLOCK_TABLE,
    BLOCK_FIGURES, /* pictures side by side */
} BlockKind;

typedef enum Align { ALIGN_LEFT, ALIGN_RIGHT } Align;

typedef struct Column {
    const char *head;
    Align align;
} Column;

typedef struct Table {
    const char *caption;   /* or NULL */
    const Column *columns; /* (column_count) the first one names the row */
    size_t column_count;
    const char **cells; /* (row_count x column_count) */
    size_t row_count, capacity;
    bool *quiet; /* (row_count x column_count) cells in the quiet colour; NULL: none */
    size_t quiet_capacity;
} Table;

/* Paints a picture of a size in design points from the origin of the context, whose unit is the design point. */
typedef void DocumentPaint(const void *context, struct _cairo *cairo, Vec2 size, Theme theme);

typedef struct Picture {
    DocumentPaint *paint;
    void *context;
    void (*release)(void *context); /* or NULL */
    Vec2 size;                      /* design points: its shape, and the scale of its text */
    const char *caption;            /* or NULL */
    const char *alternative;        /* describes the picture to readers who cannot see it */
} Picture;

typedef struct Block {
    BlockKind kind;
    int level;         /* of a heading: 1, once, 2 or 3 */
    const char *text;  /* "" where there is none */
    Table table;       /* of a table */
    Picture *pictures; /* (picture_count) of figures */
    size_t picture_count, picture_capacity;
} Block;

/* document_begin makes an empty document; document_clear releases it and the contexts of its pictures. */
typedef struct Document {
    const char *title;   /* of the window, and of the file's properties */
    const char *subject; /* the kind of document: the line above the title, and at the foot of every page */
    const char *creator; /* the program and its version */
    Block *blocks;       /* (count) */
    size_t count, capacity;
    Arena arena;
} Document;

Document document_begin(const char *creator);
void document_clear(Document *document);

/* Returns a plain text formatted as by printf; it lives as long as the document. */
const char *document_text(Document *document, const char *format, ...) __attribute__((format(printf, 2, 3), nonnull));

/* Adds the heading of the first level, once, with the subject above it. */
void document_add_title(Document *document, const char *subject, const char *title);
void document_add_heading(Document *document, int level, const char *text);
void document_add_contents(Document *document);
void document_add_paragraph(Document *document, const char *text);
void document_add_note(Document *document, const char *text);
void document_add_command(Document *document, const char *text);

/* True if a cell is in the quiet colour. */
bool document_is_quiet(const Table *table, size_t row, size_t column);

/* Adds a table; rows of as many cells as it has columns are added next. A NULL cell is printed as "-". */
void document_add_table(Document *document, const char *caption, const Column *columns, size_t count);
void document_add_row(Document *document, const char *const *cells);

/* Sets a cell of the last row in the quiet colour: a value to be relied on less than the others. */
void document_quieten_cell(Document *document, size_t column);

/* Adds a row of pictures; pictures are added next. Pictures of one size have the same size on the page. */
void document_add_figures(Document *document);
Picture *document_add_picture(Document *document, DocumentPaint *paint, void *context, Vec2 size, const char *caption,
                              const char *alternative);

/* Takes over the content of the scene, which is empty afterwards. */
void document_add_scene(Document *document, Scene *scene, Vec2 size, const char *caption, const char *alternative);
