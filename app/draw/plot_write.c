#include "draw/plot_write.h"

#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "draw/layout.h"

enum { CELL_LONGEST = 32 /* characters of a number */ };

static double picture_unit(int width, int height) {
    return fmax(1, 2 * layout_unit(width, height));
}

/* A plot in its colours, for cairo_file_write. */
typedef struct Picture {
    const Plot *plot;
    Theme theme;
} Picture;

static void paint_picture(struct _cairo *cairo, Vec2 page, const void *what) {
    const Picture *picture = what;
    plot_paint(picture->plot, cairo, page, picture->theme);
}

int plot_write_picture(CairoFileKind kind, const Plot *plot, const char *path, int width, int height, Theme theme) {
    return cairo_file_write(kind, path, width, height, picture_unit(width, height), paint_picture,
                            &(Picture){plot, theme});
}

/* Characters within a quoted field; a quote is doubled. */
static void add_quoted(Text *text, const char *characters) {
    for (; characters && *characters; characters++)
        text_add(text, *characters == '"' ? "\"\"" : (char[]){*characters, 0});
}

/* "name axis [unit]", quoted when something in it would end the field. */
static void add_heading(Text *text, const char *name, const PlotAxis *axis) {
    const char *parts[] = {name, name && axis->title ? " " : "", axis->title, " [", axis->unit ? axis->unit : "1", "]"};
    bool quoted = false;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        quoted = quoted || (parts[i] && strpbrk(parts[i], ",\"\r\n"));
    text_add(text, quoted ? "\"" : "");
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        if (quoted)
            add_quoted(text, parts[i]);
        else
            text_add(text, parts[i] ? parts[i] : "");
    text_add(text, quoted ? "\"" : "");
}

static void add_number(Text *text, double value) {
    char cell[CELL_LONGEST] = "";
    if (isfinite(value))
        snprintf(cell, sizeof cell, "%.9g", value);
    text_add(text, cell);
}

static void add_row(Text *text, const Plot *plot, size_t row) {
    for (size_t s = 0; s < plot->series_count; s++) {
        const PlotSeries *series = &plot->series[s];
        Vec2 value = row < series->count ? plot_value(series, row) : vec2(NAN, NAN);
        text_add(text, s ? "," : "");
        add_number(text, value.x);
        text_add(text, ",");
        add_number(text, value.y);
    }
    text_add(text, "\r\n");
}

int plot_write_csv(const Plot *plot, const char *path) {
    Text text = {0};
    size_t rows = 0;
    text_add(&text, "");
    for (size_t s = 0; s < plot->series_count; s++) {
        const char *heading = plot->series[s].heading ? plot->series[s].heading : plot->series[s].name;
        const char *name = plot->series_count > 1 ? heading : NULL;
        text_add(&text, s ? "," : "");
        add_heading(&text, name, &plot->x);
        text_add(&text, ",");
        add_heading(&text, name, &plot->y);
        rows = plot->series[s].count > rows ? plot->series[s].count : rows;
    }
    text_add(&text, "\r\n");
    for (size_t row = 0; row < rows; row++)
        add_row(&text, plot, row);
    int error = text_write_file(path, text.text, text.used);
    memory_free(text.text);
    return error;
}
