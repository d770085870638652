#include "plot/plate.h"

#include <cairo.h>

#include "draw/layout.h"
#include "paint/paint_cairo.h"

static void paint_panel(cairo_t *cairo, const Plot *plot, Box panel, Theme theme) {
    cairo_save(cairo);
    cairo_translate(cairo, panel.low.x, panel.low.y);
    plot_paint(plot, cairo, vec2(box_width(panel), box_height(panel)), theme);
    cairo_restore(cairo);
}

void plate_paint(cairo_t *cairo, Vec2 page, const void *what) {
    const Plate *plate = what;
    Layout still, moving = {0};
    layout_make(&still, plate->still, page);
    layout_make_over(&moving, &still, plate->moving);
    paint_cairo_layers(cairo, (Layer[]){{plate->still, &still}, {plate->moving, &moving}}, 2, plate->theme);
    for (int i = 0; i < plate->still->panels; i++)
        paint_panel(cairo, &plate->plots[i], still.panels[i], plate->theme);
    layout_clear(&still);
    layout_clear(&moving);
}

int plate_write(CairoFileKind kind, const Plate *plate, const char *path, int width, int height) {
    return cairo_file_write(kind, path, width, height, layout_unit(width, height), plate_paint, plate);
}
