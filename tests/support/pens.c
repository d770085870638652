#include "pens.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "check.h"
#include "result/json.h"
#include "result/page.h"
#include "result/panel.h"
#include "result/text.h"

const Block *pens_table(const Document *document, size_t index) {
    for (size_t b = 0; b < document->count; b++)
        if (document->blocks[b].kind == BLOCK_TABLE && index-- == 0)
            return &document->blocks[b];
    return NULL;
}

/* A document keeps numbers and units on one line: returns its words with ordinary spaces. */
static const char *with_spaces(const char *words, Arena *arena) {
    static const char together[] = "\u00a0";
    size_t size = strlen(words) + 1;
    char *copy = memcpy(arena_allocate(arena, size), words, size), *at = copy;
    for (char *found; (found = strstr(at, together)); at = found + 1) {
        *found = ' ';
        memmove(found + 1, found + sizeof together - 1, strlen(found + sizeof together - 1) + 1);
    }
    return copy;
}

/* The cell of the first record under a head, in any table of the document; NULL: there is none. */
static const char *cell_under(const Document *document, const char *head, Arena *arena) {
    const Block *block;
    for (size_t t = 0; (block = pens_table(document, t)); t++)
        for (size_t c = 0; c < block->table.column_count; c++)
            if (strcmp(with_spaces(block->table.columns[c].head, arena), head) == 0)
                return block->table.cells[c] ? with_spaces(block->table.cells[c], arena) : NULL;
    return NULL;
}

/* The text of the row's fact stands on the terminal, in JSON, on the panel and on the page. */
static void check_fact(const ResultRow *row, const char *text, const json_t *json, const Document *document) {
    Arena arena = {0};
    SceneRow line;
    const char *value = result_value(row, &arena);
    const char *label = row->head ? row->head : row->label;
    const char *head = row->unit ? text_in_arena(&arena, "%s %s", label, row->unit) : label;
    CHECK(strstr(text, document ? head : row->label) && strstr(text, value));
    const char *capital = text_in_arena(&arena, "%c%s", toupper((unsigned char)label[0]), label + 1);
    const char *page_head = row->unit ? text_in_arena(&arena, "%s, %s", capital, row->unit) : capital;
    const char *cell = document ? cell_under(document, page_head, &arena) : NULL;
    if (document)
        CHECK_TEXT(cell ? cell : "", value);
    CHECK(result_panel_row(&line, row, &arena));
    CHECK_TEXT(line.cells[0], row->label);
    bool rounded = row->unit && (strcmp(row->unit, "m") == 0 || strcmp(row->unit, "s") == 0);
    if (!rounded) /* the panel has its own digits of lengths and times */
        CHECK_TEXT(line.cells[1], row->unit ? text_in_arena(&arena, "%s %s", value, row->unit) : value);
    if (row->key) {
        char key[64];
        snprintf(key, sizeof key, "%s", row->key);
        char *point = strchr(key, '.');
        const json_t *at = json;
        if (point) {
            *point = 0;
            at = json_object_get(json, key);
        }
        const json_t *found = json_object_get(at, point ? point + 1 : key);
        CHECK(found);
        if (row->kind == RESULT_NUMBER || row->kind == RESULT_COUNT)
            CHECK_NEAR(json_number_value(found), row->number, 1e-6);
        else if (row->kind == RESULT_TEXT)
            CHECK_TEXT(json_string_value(found), value);
    }
    arena_clear(&arena);
}

void pens_check_facts(const ResultTable *table, size_t least, const char *text, const json_t *json,
                      const Document *document) {
    size_t facts = 0;
    Arena arena = {0};
    for (size_t r = 0; r < table->row_count; r++) {
        const ResultRow *row = result_at(table, 0, r);
        if (!row->label || !result_value(row, &arena))
            continue;
        check_fact(row, text, json, document);
        facts++;
    }
    CHECK(facts >= least);
    arena_clear(&arena);
}

void pens_check(const ResultTable *table, size_t least) {
    Text text = {0};
    Document document = document_begin("clearance 9");
    json_t *list = result_json_list(table);
    result_text_table(&text, table);
    result_page_table(&document, "caption", table);
    pens_check_facts(table, least, text.text, json_array_get(list, 0), &document);
    json_decref(list);
    document_clear(&document);
    memory_free(text.text);
}
