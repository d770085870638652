#include "plot/plot.h"

#include "plot/plot_ground.h"
#include "plot/plot_layout.h"
#include "plot/plot_pen.h"

void plot_paint(const Plot *plot, struct _cairo *cairo, Vec2 size, Theme theme) {
    PlotLayout layout;
    plot_layout_make(&layout, plot, size, PLOT_NAMES_BESIDE);
    plot_ground_paint(cairo, &layout, plot, theme);
    for (size_t s = 0; s < plot->series_count; s++) {
        PlotPen pen = plot_pen_make(cairo);
        plot_pen_draw(&pen, cairo, &layout, &plot->series[s], plot->series[s].count, theme);
        plot_pen_clear(&pen);
    }
    plot_ground_paint_text(cairo, &layout, theme);
    plot_layout_clear(&layout);
}
