#include "result/text.h"

static int length_of(const char *text) {
    int length = 0;
    for (; *text; text++)
        length += ((unsigned char)*text & 0xc0) != 0x80; /* bytes that begin a character of UTF-8 */
    return length;
}

static void add_padded(Text *text, const char *words, int width, bool right, bool last) {
    int pad = width - length_of(words);
    if (right)
        text_format(text, "%*s%s", pad, "", words);
    else if (last)
        text_add(text, words);
    else
        text_format(text, "%s%*s", words, pad, "");
    text_add(text, last ? "\n" : "  ");
}

static const char *head_of(const ResultRow *row, Arena *arena) {
    const char *head = row->head ? row->head : row->label;
    return row->unit ? text_in_arena(arena, "%s %s", head, row->unit) : head;
}

static const char *cell_of(const ResultTable *table, size_t record, size_t row, Arena *arena) {
    const char *value = result_value(result_at(table, record, row), arena);
    return value ? value : "-";
}

static int width_of(const ResultTable *table, size_t row, Arena *arena) {
    int width = length_of(head_of(result_at(table, 0, row), arena));
    for (size_t record = 0; record < table->record_count; record++) {
        int length = length_of(cell_of(table, record, row, arena));
        width = length > width ? length : width;
    }
    return width;
}

void result_text_table(Text *text, const ResultTable *table) {
    Arena arena = {0};
    size_t *rows = memory_zeroed(table->row_count, sizeof *rows), count = result_columns(table, rows);
    int *widths = memory_zeroed(count, sizeof *widths);
    for (size_t c = 0; c < count; c++) {
        const ResultRow *row = result_at(table, 0, rows[c]);
        widths[c] = width_of(table, rows[c], &arena);
        add_padded(text, head_of(row, &arena), widths[c], result_is_number(row), c + 1 == count);
    }
    for (size_t record = 0; record < table->record_count; record++)
        for (size_t c = 0; c < count; c++)
            add_padded(text, cell_of(table, record, rows[c], &arena), widths[c],
                       result_is_number(result_at(table, record, rows[c])), c + 1 == count);
    memory_free(rows);
    memory_free(widths);
    arena_clear(&arena);
}

void result_text_take(Text *text, const char *heading, ResultTable table) {
    Text lines = {0};
    result_text_table(&lines, &table);
    if (lines.text)
        text_format(text, "\n%s%s", heading, lines.text);
    memory_free(lines.text);
    result_clear(&table);
}

/* Returns the width of the longest label in a record, at least `width`. */
static int label_width(const ResultTable *table, size_t record, int width, Arena *arena) {
    for (size_t r = 0; r < table->row_count; r++) {
        const ResultRow *row = result_at(table, record, r);
        if (row->label && length_of(row->label) > width && result_value(row, arena))
            width = length_of(row->label);
    }
    return width;
}

static void add_lines(Text *text, const ResultTable *table, size_t record, int width, Arena *arena) {
    for (size_t r = 0; r < table->row_count; r++) {
        const ResultRow *row = result_at(table, record, r);
        const char *value = row->label ? result_value_and_unit(row, arena) : NULL;
        if (!value)
            continue;
        add_padded(text, row->label, width, false, false);
        text_format(text, "%s\n", value);
    }
}

void result_text_list(Text *text, const ResultTable *const *tables, size_t count) {
    Arena arena = {0};
    int width = 0;
    for (size_t t = 0; t < count; t++)
        width = label_width(tables[t], 0, width, &arena);
    for (size_t t = 0; t < count; t++)
        add_lines(text, tables[t], 0, width, &arena);
    arena_clear(&arena);
}

void result_text_record(Text *text, const ResultTable *table, size_t record) {
    Arena arena = {0};
    add_lines(text, table, record, label_width(table, record, 0, &arena), &arena);
    arena_clear(&arena);
}
