#include "plot/plot_write.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/file_write.h"
#include "base/text.h"
#include "base/visible.h"
#include "draw/layout.h"

enum { CELL_LONGEST = 32 /* characters of a number */ };

static double picture_unit(int width, int height) {
    return fmax(1, 2 * layout_unit(width, height));
}

/* A plot and its theme, for cairo_file_write. */
typedef struct Picture {
    Plot plot;
    Theme theme;
} Picture;

static void paint_picture(struct _cairo *cairo, Vec2 page, const void *what) {
    const Picture *picture = what;
    plot_paint(&picture->plot, cairo, page, picture->theme);
}

int plot_write_picture(CairoFileKind kind, const Plot *plot, const char *path, const PlotSheet *sheet) {
    Picture picture = {*plot, sheet->theme};
    picture.plot.source = sheet->source;
    return cairo_file_write(kind, path, sheet->width, sheet->height, picture_unit(sheet->width, sheet->height),
                            paint_picture, &picture);
}

/* Adds the parts of a field, quoted, with quotes doubled, if a character in them would end the field. */
static void add_field(Text *text, const char *const *parts, size_t count) {
    Text field = {0};
    for (size_t i = 0; i < count; i++)
        text_add(&field, parts[i] ? parts[i] : "");
    char *shown = visible_text(field.text ? field.text : "");
    bool quoted = strpbrk(shown, ",\"\r\n");
    text_add(text, quoted ? "\"" : "");
    for (const char *at = shown; *at; at++)
        text_add(text, quoted && *at == '"' ? "\"\"" : (char[]){*at, 0});
    text_add(text, quoted ? "\"" : "");
    memory_free(shown);
    memory_free(field.text);
}

static void add_number(Text *text, double value) {
    char cell[CELL_LONGEST] = "";
    if (isfinite(value))
        snprintf(cell, sizeof cell, "%.9g", value);
    text_add(text, cell);
}

/* A column of the table. */
typedef struct Column {
    const char *name;     /* or NULL */
    const PlotAxis *axis; /* of a class: the heading is its title alone */
    const double *values; /* (count x stride) */
    size_t count, stride;
    const PlotClass *classes; /* (class_count) or NULL: numbers */
    size_t class_count;
} Column;

typedef struct Table {
    Column *columns; /* (count) */
    size_t count;
    Arena arena;
} Table;

static void add_column(Table *table, const char *name, const PlotAxis *axis, const double *values, size_t count,
                       size_t stride) {
    table->columns[table->count++] = (Column){name, axis, values, count, stride ? stride : 1, NULL, 0};
}

/* Adds the middles of the cells, and their values. */
static void add_raster(Table *table, const Plot *plot) {
    const PlotRaster *raster = plot->raster;
    size_t count = raster->columns * raster->rows;
    double *x = arena_allocate(&table->arena, count * sizeof *x), *y = arena_allocate(&table->arena, count * sizeof *y);
    for (size_t i = 0; i < count; i++) {
        x[i] = raster->box.low.x +
               box_width(raster->box) * ((double)(i % raster->columns) + 0.5) / (double)raster->columns;
        y[i] =
            raster->box.low.y + box_height(raster->box) * ((double)(i / raster->columns) + 0.5) / (double)raster->rows;
    }
    add_column(table, NULL, &plot->x, x, count, 1);
    add_column(table, NULL, &plot->y, y, count, 1);
    add_column(table, NULL, &raster->value, raster->values, count, 1);
    table->columns[table->count - 1].classes = raster->classes;
    table->columns[table->count - 1].class_count = raster->class_count;
}

static const char *joined(Table *table, const char *first, const char *second) {
    size_t room = strlen(first) + strlen(second) + 2;
    char *text = arena_allocate(&table->arena, room);
    snprintf(text, room, "%s%s%s", first, *first ? " " : "", second);
    return text;
}

static void add_area(Table *table, const Plot *plot, const PlotArea *area) {
    const char *name = area->name ? area->name : "";
    add_column(table, *name ? name : NULL, &plot->x, area->x, area->count, 1);
    add_column(table, joined(table, name, "from"), &plot->y, area->low, area->count, 1);
    add_column(table, joined(table, name, "to"), &plot->y, area->high, area->count, 1);
}

/* Returns the content of the plot in columns. */
static void make_table(Table *table, const Plot *plot) {
    size_t most = 2 * plot->series_count + 3 * plot->area_count + 3;
    table->columns = arena_allocate(&table->arena, most * sizeof *table->columns);
    if (plot->raster)
        add_raster(table, plot);
    for (size_t a = 0; a < plot->area_count; a++)
        add_area(table, plot, &plot->areas[a]);
    bool several = plot->series_count + plot->area_count + (plot->raster != NULL) > 1;
    for (size_t s = 0; s < plot->series_count; s++) {
        const PlotSeries *series = &plot->series[s];
        const char *heading = series->heading ? series->heading : series->name;
        add_column(table, several ? heading : NULL, &plot->x, series->x, series->count, series->stride);
        add_column(table, several ? heading : NULL, &plot->y, series->y, series->count, series->stride);
    }
}

/* Prints "name axis [unit]". */
static void add_heading(Text *text, const Column *column) {
    const PlotAxis *axis = column->axis;
    const char *name = column->name;
    const char *parts[] = {name, name && axis->title ? " " : "", axis->title, " [", axis->unit ? axis->unit : "1", "]"};
    add_field(text, parts, column->classes ? 3 : sizeof parts / sizeof *parts);
}

static void add_cell(Text *text, const Column *column, size_t row) {
    double value = row < column->count ? column->values[row * column->stride] : NAN;
    if (column->classes && value >= 0 && value < (double)column->class_count)
        add_field(text, (const char *const[]){column->classes[(size_t)value].name}, 1);
    else if (!column->classes)
        add_number(text, value);
}

int plot_write_csv(const Plot *plot, const char *path) {
    Text text = {0};
    Table table = {0};
    size_t rows = 0;
    make_table(&table, plot);
    text_add(&text, "");
    for (size_t c = 0; c < table.count; c++) {
        const Column *column = &table.columns[c];
        text_add(&text, c ? "," : "");
        add_heading(&text, column);
        rows = column->count > rows ? column->count : rows;
    }
    text_add(&text, "\r\n");
    for (size_t row = 0; row < rows; row++) {
        for (size_t c = 0; c < table.count; c++) {
            text_add(&text, c ? "," : "");
            add_cell(&text, &table.columns[c], row);
        }
        text_add(&text, "\r\n");
    }
    int error = file_write_bytes(path, text.text, text.used);
    arena_clear(&table.arena);
    memory_free(text.text);
    return error;
}

int plot_write_files(const Plot *plot, const char *name, const char *out, const PlotSheet *sheet,
                     char path[PLOT_WRITE_PATH]) {
    int error = 0;
    for (size_t e = 0; e <= CAIRO_FILE_PDF + 1 && !error; e++) {
        bool table = e > CAIRO_FILE_PDF;
        const char *ending = table ? "csv" : cairo_file_endings[e];
        if (snprintf(path, PLOT_WRITE_PATH, "%s/plot-%s.%s", out, name, ending) >= PLOT_WRITE_PATH)
            error = ENAMETOOLONG;
        else
            error = table ? plot_write_csv(plot, path) : plot_write_picture((CairoFileKind)e, plot, path, sheet);
    }
    return error;
}
