#include "document/document.h"

#include <assert.h>
#include <glib.h>
#include <string.h>

#include "base/text.h"
#include "paint/paint_cairo.h"
#include "draw/text.h"

Document document_begin(const char *creator) {
    Document document = {.title = "", .subject = ""};
    document.creator = arena_text(&document.arena, creator);
    return document;
}

void document_clear(Document *document) {
    for (size_t b = 0; b < document->count; b++) {
        Block *block = &document->blocks[b];
        for (size_t p = 0; p < block->picture_count; p++)
            if (block->pictures[p].release)
                block->pictures[p].release(block->pictures[p].context);
        memory_free(block->pictures);
        memory_free(block->table.cells);
        memory_free(block->table.quiet);
    }
    memory_free(document->blocks);
    arena_clear(&document->arena);
    *document = (Document){0};
}

static const char *plain(Document *document, const char *text) {
    char *label = text_plain(text);
    const char *copy = arena_text(&document->arena, label);
    memory_free(label);
    return copy;
}

/* True if the text begins with a unit and nothing longer. */
static bool is_unit(const char *text) {
    static const char *const units[] = {"s", "m", "N", "kg", "%"};
    for (size_t u = 0; u < sizeof units / sizeof *units; u++) {
        size_t length = strlen(units[u]);
        if (strncmp(text, units[u], length) == 0 && !g_ascii_isalnum(text[length]))
            return true;
    }
    return false;
}

/* Returns plain text without a line break between a number and its unit. */
static const char *prose(Document *document, const char *text) {
    const char *label = plain(document, text);
    char *copy = arena_allocate(&document->arena, 2 * strlen(label) + 1), *to = copy;
    for (const char *at = label; *at; at++) {
        bool joined = *at == ' ' && at > label && g_ascii_isdigit(at[-1]) && is_unit(at + 1);
        to += joined ? g_unichar_to_utf8(0xa0, to) : 1;
        if (!joined)
            to[-1] = *at;
    }
    return copy;
}

const char *document_text(Document *document, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    char *text = text_printed(format, arguments);
    va_end(arguments);
    const char *kept = plain(document, text);
    memory_free(text);
    return kept;
}

static Block *add_block(Document *document, BlockKind kind, const char *text) {
    document->blocks =
        memory_reserve(document->blocks, &document->capacity, document->count + 1, sizeof *document->blocks);
    Block *block = &document->blocks[document->count++];
    *block = (Block){.kind = kind, .text = kind == BLOCK_COMMAND ? plain(document, text) : prose(document, text)};
    return block;
}

static Block *last_block(Document *document, BlockKind kind) {
    assert(document->count && document->blocks[document->count - 1].kind == kind);
    (void)kind;
    return &document->blocks[document->count - 1];
}

void document_add_title(Document *document, const char *subject, const char *title) {
    Block *block = add_block(document, BLOCK_HEADING, title);
    block->level = 1;
    document->title = block->text;
    document->subject = prose(document, subject);
}

void document_add_heading(Document *document, int level, const char *text) {
    add_block(document, BLOCK_HEADING, text)->level = level;
}

void document_add_contents(Document *document) {
    add_block(document, BLOCK_CONTENTS, "");
}

void document_add_paragraph(Document *document, const char *text) {
    add_block(document, BLOCK_PARAGRAPH, text);
}

void document_add_note(Document *document, const char *text) {
    add_block(document, BLOCK_NOTE, text);
}

void document_add_command(Document *document, const char *text) {
    add_block(document, BLOCK_COMMAND, text);
}

void document_add_table(Document *document, const char *caption, const Column *columns, size_t count) {
    Column *copies = arena_allocate(&document->arena, count * sizeof *copies);
    for (size_t c = 0; c < count; c++)
        copies[c] = (Column){prose(document, columns[c].head), columns[c].align};
    Table *table = &add_block(document, BLOCK_TABLE, "")->table;
    *table = (Table){.caption = caption ? prose(document, caption) : NULL, .columns = copies, .column_count = count};
}

void document_add_row(Document *document, const char *const *cells) {
    Table *table = &last_block(document, BLOCK_TABLE)->table;
    size_t used = table->row_count++ * table->column_count;
    table->cells = memory_reserve(table->cells, &table->capacity, used + table->column_count, sizeof *table->cells);
    for (size_t c = 0; c < table->column_count; c++)
        table->cells[used + c] = cells[c] ? prose(document, cells[c]) : "-";
}

bool document_is_quiet(const Table *table, size_t row, size_t column) {
    size_t cell = row * table->column_count + column;
    return cell < table->quiet_capacity && table->quiet[cell];
}

void document_quieten_cell(Document *document, size_t column) {
    Table *table = &last_block(document, BLOCK_TABLE)->table;
    table->quiet = memory_reserve(table->quiet, &table->quiet_capacity, table->row_count * table->column_count,
                                  sizeof *table->quiet);
    table->quiet[(table->row_count - 1) * table->column_count + column] = true;
}

void document_add_figures(Document *document) {
    add_block(document, BLOCK_FIGURES, "");
}

Picture *document_add_picture(Document *document, DocumentPaint *paint, void *context, Vec2 size, const char *caption,
                              const char *alternative) {
    Block *block = last_block(document, BLOCK_FIGURES);
    block->pictures =
        memory_reserve(block->pictures, &block->picture_capacity, block->picture_count + 1, sizeof *block->pictures);
    Picture *picture = &block->pictures[block->picture_count++];
    *picture = (Picture){.paint = paint,
                         .context = context,
                         .size = size,
                         .caption = caption ? prose(document, caption) : NULL,
                         .alternative = prose(document, alternative)};
    return picture;
}

static void paint_scene(const void *context, struct _cairo *cairo, Vec2 size, Theme theme) {
    paint_cairo_scene(cairo, context, size, theme);
}

static void release_scene(void *context) {
    scene_clear(context);
    memory_free(context);
}

void document_add_scene(Document *document, Scene *scene, Vec2 size, const char *caption, const char *alternative) {
    Scene *kept = memory_zeroed(1, sizeof *kept);
    *kept = *scene;
    *scene = (Scene){0};
    document_add_picture(document, paint_scene, kept, size, caption, alternative)->release = release_scene;
}
