#include "result/page.h"

#include <ctype.h>
#include <stdint.h>
#include <string.h>

#include "result/names.h"

enum { COLUMNS_MOST = 10 /* of a table that is read on a page */ };

static const char *capital(Document *document, const char *words) {
    return document_text(document, "%c%s", toupper((unsigned char)*words), words + (*words != 0));
}

static const char *head_of(Document *document, const ResultRow *row, const char *label) {
    const char *head = capital(document, label);
    return row->unit ? document_text(document, "%s, %s", head, row->unit) : head;
}

/* Returns a number's words, such as "5 % (2 to 11)", with spaces that keep them on one line. */
static const char *unbroken(Document *document, const char *words) {
    const char *kept = "";
    for (const char *word = words; *word;) {
        size_t length = strcspn(word, " ");
        kept = document_text(document, "%s%.*s%s", kept, (int)length, word, word[length] ? "\u00a0" : "");
        word += length + (word[length] != 0);
    }
    return kept;
}

/* Adds a table of `count` rows, of which the first names the record. */
static void add_part(Document *document, const char *caption, const ResultTable *table, const size_t *rows,
                     size_t count) {
    Column *columns = arena_allocate(&document->arena, count * sizeof *columns);
    const char *cells[COLUMNS_MOST];
    for (size_t c = 0; c < count; c++) {
        const ResultRow *row = result_at(table, 0, rows[c]);
        columns[c] = (Column){head_of(document, row, row->head ? row->head : row->label),
                              result_is_number(row) ? ALIGN_RIGHT : ALIGN_LEFT};
    }
    document_add_table(document, caption, columns, count);
    for (size_t record = 0; record < table->record_count; record++) {
        for (size_t c = 0; c < count; c++) {
            const ResultRow *row = result_at(table, record, rows[c]);
            const char *value = result_value(row, &document->arena);
            cells[c] = row->kind == RESULT_NUMBER && row->text ? unbroken(document, value) : value;
        }
        document_add_row(document, cells);
        for (size_t c = 0; c < count; c++)
            if (result_at(table, record, rows[c])->role == ROLE_DIM_TEXT)
                document_quieten_cell(document, c);
    }
}

void result_page_table(Document *document, const char *caption, const ResultTable *table) {
    size_t *rows = memory_zeroed(table->row_count, sizeof *rows), count = result_columns(table, rows);
    size_t others = count > 1 ? count - 1 : 0, each = COLUMNS_MOST - 1;
    size_t parts = (others + each - 1) / each;
    for (size_t p = 0; p < parts; p++) { /* of about the same width; the first row stands before each */
        size_t first = 1 + p * others / parts, end = 1 + (p + 1) * others / parts;
        size_t part[COLUMNS_MOST] = {rows[0]};
        for (size_t c = first; c < end; c++)
            part[1 + c - first] = rows[c];
        add_part(document, p ? NULL : caption, table, part, 1 + end - first);
    }
    memory_free(rows);
}

void result_page_take(Document *document, const char *caption, ResultTable table) {
    result_page_table(document, caption, &table);
    result_clear(&table);
}

void result_page_take_named(Document *document, const char *caption, const House *house, ResultTable table) {
    for (size_t record = 0; record < table.record_count; record++)
        for (size_t r = 0; r < table.row_count; r++) {
            ResultRow *row = &table.rows[record * table.row_count + r];
            if (row->label && row->text)
                row->text = names_text(house, row->text, &table.arena);
        }
    result_page_take(document, caption, table);
}

void result_page_list(Document *document, const char *caption, const ResultTable *const *tables, size_t count) {
    static const Column columns[] = {{"", ALIGN_LEFT}, {"", ALIGN_RIGHT}};
    document_add_table(document, caption, columns, 2);
    for (size_t t = 0; t < count; t++)
        for (size_t r = 0; r < tables[t]->row_count; r++) {
            const ResultRow *row = result_at(tables[t], 0, r);
            const char *value = row->label ? result_value_and_unit(row, &document->arena) : NULL;
            if (value)
                document_add_row(document, (const char *const[]){capital(document, row->label), value});
        }
}

void result_page_pair(Document *document, const char *const names[3], const ResultTable *a, const ResultTable *b,
                      bool both) {
    Column *columns = arena_allocate(&document->arena, 4 * sizeof *columns);
    columns[0] = (Column){"", ALIGN_LEFT};
    for (int n = 0; n < 3; n++)
        columns[1 + n] = (Column){names[n], ALIGN_RIGHT};
    document_add_table(document, NULL, columns, 4);
    for (size_t r = 0; r < a->row_count; r++) {
        const ResultRow *before = result_at(a, 0, r), *now = result_at(b, 0, r);
        ResultRow difference = result_difference(before, now, both);
        Arena *arena = &document->arena;
        const char *cells[] = {before->label ? head_of(document, before, before->label) : NULL,
                               result_value(before, arena), result_value(now, arena), result_value(&difference, arena)};
        if (cells[0])
            document_add_row(document, cells);
    }
}

void result_page_fact(Document *document, const char *caption, const ResultPair *pair, const char *key) {
    if (!pair->a->record_count)
        return;
    Column *columns = arena_allocate(&document->arena, 4 * sizeof *columns);
    columns[0] = (Column){capital(document, result_at(pair->a, 0, 0)->label), ALIGN_LEFT};
    for (int n = 0; n < 3; n++)
        columns[1 + n] = (Column){head_of(document, result_find(pair->a, 0, key), pair->names[n]), ALIGN_RIGHT};
    document_add_table(document, caption, columns, 4);
    for (size_t i = 0; i < pair->a->record_count; i++) {
        size_t j = result_partner(pair, i);
        const ResultRow *before = result_find(pair->a, i, key);
        const char *cells[4] = {result_at(pair->a, i, 0)->text, result_value(before, &document->arena)};
        if (j != SIZE_MAX) {
            const ResultRow *now = result_find(pair->b, j, key);
            ResultRow difference = result_difference(before, now, result_both_succeeded(pair, i, j));
            cells[2] = result_value(now, &document->arena);
            cells[3] = result_value(&difference, &document->arena);
        }
        document_add_row(document, cells);
    }
}
