#include "document/pdf_table.h"

#include <math.h>
#include <stdint.h>

#define CELL_GAP 9.0     /* pt, between columns */
#define SHORT 62.0       /* pt, of a column */
#define CELL_PAD 2.6     /* pt, above and below a text */
#define STRETCH_MOST 1.7 /* 1, the largest factor by which columns that all fit are widened */
#define CAPTION_GAP 4.0
#define CELL_HIGHEST 500.0 /* pt: a higher cell is cut */

static const TextStyle CAPTION = {8.3, 1.15, false, false, ROLE_DIM_TEXT};
static const TextStyle HEAD = {8.1, 1.1, true, false, ROLE_TEXT};
static const TextStyle CELL = {8.1, 1.15, false, false, ROLE_TEXT};
static const TextStyle QUIET = {8.1, 1.15, false, false, ROLE_DIM_TEXT};

typedef struct Setting {
    const Table *table;
    double *widths; /* (column_count) pt */
    double *lefts;  /* (column_count) pt */
    double width;   /* pt, of the whole */
} Setting;

/* Returns the width of a text on one line, or of its longest word. */
static double natural_width(const char *text, TextStyle style, bool longest_word) {
    PangoLayout *layout = sheet_text(text, style, longest_word ? 0 : SHEET_WIDTH, ALIGN_LEFT, 0);
    if (longest_word)
        pango_layout_set_wrap(layout, PANGO_WRAP_WORD);
    PangoRectangle logical;
    pango_layout_get_extents(layout, NULL, &logical);
    g_object_unref(layout);
    return (double)logical.width / PANGO_SCALE + 0.1;
}

static const char *cell_text(const Table *table, size_t row, size_t column) {
    return table->cells[row * table->column_count + column];
}

/* Finds the width that a column needs for its longest word, and for its longest cell on one line. */
static void measure_column(const Table *table, size_t column, double *least, double *most) {
    *least = natural_width(table->columns[column].head, HEAD, true);
    *most = natural_width(table->columns[column].head, HEAD, false);
    for (size_t r = 0; r < table->row_count; r++) {
        *least = fmax(*least, natural_width(cell_text(table, r, column), CELL, true));
        *most = fmax(*most, natural_width(cell_text(table, r, column), CELL, false));
    }
}

/* Keeps the cells of short columns on one line, unless there are too many of these columns. */
static void protect_short(double *least, const double *most, size_t count, double room) {
    double sum = 0;
    for (size_t c = 0; c < count; c++)
        sum += most[c] < SHORT ? most[c] : least[c];
    for (size_t c = 0; c < count && sum < room; c++)
        least[c] = most[c] < SHORT ? most[c] : least[c];
}

/* If all columns fit, shares the rest by need, so far that the eye still follows a row; otherwise gives each its
 * longest word and a share of the rest. */
static void set_columns(Setting *setting) {
    const Table *table = setting->table;
    size_t count = table->column_count;
    double *least = memory_zeroed(count, sizeof *least), *most = memory_zeroed(count, sizeof *most);
    double room = SHEET_WIDTH - CELL_GAP * (double)(count - 1), sum_least = 0, sum_most = 0;
    for (size_t c = 0; c < count; c++) {
        measure_column(table, c, &least[c], &most[c]);
        sum_most += most[c];
    }
    protect_short(least, most, count, room);
    for (size_t c = 0; c < count; c++)
        sum_least += least[c];
    double part = sum_most > sum_least ? fmax(0, fmin(1, (room - sum_least) / (sum_most - sum_least))) : 1;
    double stretch = sum_least > room ? room / sum_least : fmax(1, fmin(room / sum_most, STRETCH_MOST));
    double left = SHEET_LEFT;
    for (size_t c = 0; c < count; c++) {
        setting->widths[c] = stretch * (least[c] + part * (most[c] - least[c]));
        setting->lefts[c] = left;
        left += setting->widths[c] + CELL_GAP;
    }
    setting->width = left - CELL_GAP - SHEET_LEFT;
    memory_free(least);
    memory_free(most);
}

static PangoLayout *cell_layout(const Setting *setting, const char *text, size_t column, TextStyle style) {
    return sheet_text(text, style, setting->widths[column], setting->table->columns[column].align, CELL_HIGHEST);
}

/* Sets a row of the table; SIZE_MAX: its head. */
static const char *text_at(const Table *table, size_t row, size_t column) {
    return row == SIZE_MAX ? table->columns[column].head : cell_text(table, row, column);
}

static double row_height(const Setting *setting, size_t row) {
    double height = 0;
    for (size_t c = 0; c < setting->table->column_count; c++) {
        PangoLayout *text = cell_layout(setting, text_at(setting->table, row, c), c, row == SIZE_MAX ? HEAD : CELL);
        height = fmax(height, sheet_text_height(text));
        g_object_unref(text);
    }
    return height + 2 * CELL_PAD;
}

static void set_row(Sheet *sheet, const Setting *setting, size_t row, double height) {
    bool head = row == SIZE_MAX;
    sheet_tag(sheet, "TR", NULL);
    for (size_t c = 0; c < setting->table->column_count; c++) {
        const char *tag = head || c == 0 ? "TH" : "TD";
        TextStyle style = head ? HEAD : document_is_quiet(setting->table, row, c) ? QUIET : CELL;
        PangoLayout *text = cell_layout(setting, text_at(setting->table, row, c), c, style);
        double top = head ? sheet->y + height - CELL_PAD - sheet_text_height(text) : sheet->y + CELL_PAD;
        sheet_tag(sheet, tag, NULL);
        sheet_show(sheet, text, style, setting->lefts[c], top);
        sheet_untag(sheet, tag);
        g_object_unref(text);
    }
    sheet_untag(sheet, "TR");
    sheet->y += height;
    sheet_rule(sheet, SHEET_LEFT, setting->width, sheet->y, head ? 1 : 0.5, head ? ROLE_TEXT : ROLE_GRID);
}

static void set_caption(Sheet *sheet, const Table *table) {
    if (!table->caption)
        return;
    PangoLayout *text = sheet_text(table->caption, CAPTION, SHEET_WIDTH, ALIGN_LEFT, CELL_HIGHEST);
    sheet_tag(sheet, "Caption", NULL);
    sheet_show(sheet, text, CAPTION, SHEET_LEFT, sheet->y);
    sheet_untag(sheet, "Caption");
    sheet->y += sheet_text_height(text) + CAPTION_GAP;
    g_object_unref(text);
}

static Setting make_setting(const Table *table) {
    Setting setting = {.table = table,
                       .widths = memory_zeroed(table->column_count, sizeof *setting.widths),
                       .lefts = memory_zeroed(table->column_count, sizeof *setting.lefts)};
    set_columns(&setting);
    return setting;
}

static void clear_setting(Setting *setting) {
    memory_free(setting->widths);
    memory_free(setting->lefts);
}

void pdf_table_set(Sheet *sheet, const Table *table) {
    Setting setting = make_setting(table);
    double head = row_height(&setting, SIZE_MAX);
    sheet_tag(sheet, "Table", NULL);
    set_caption(sheet, table);
    set_row(sheet, &setting, SIZE_MAX, head);
    for (size_t r = 0; r < table->row_count; r++) {
        double height = row_height(&setting, r);
        if (sheet_need(sheet, height))
            set_row(sheet, &setting, SIZE_MAX, head);
        set_row(sheet, &setting, r, height);
    }
    sheet_untag(sheet, "Table");
    clear_setting(&setting);
}

double pdf_table_least(const Table *table) {
    Setting setting = make_setting(table);
    Sheet nowhere = {.y = 0};
    set_caption(&nowhere, table);
    double height = nowhere.y + row_height(&setting, SIZE_MAX);
    for (size_t r = 0; r < table->row_count && r < 2; r++)
        height += row_height(&setting, r);
    clear_setting(&setting);
    return height;
}
