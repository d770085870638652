#include "plot/plot_key.h"

#include "draw/caption.h"
#include "draw/text.h"

/* Design points. */
#define TEXT_SIZE 16.0
#define GAP 12.0 /* from the plot */
#define PATCH_WIDTH 24.0
#define PATCH_HEIGHT 17.0
#define TEXT_GAP 6.0
#define ROW_HEIGHT 23.0
#define BAR_WIDTH 18.0
#define TITLE_ROW 18.5 /* from the top of the bar up to the middle of its title */

static double text_width(const PlotLayout *layout, const Plot *plot) {
    const PlotRaster *raster = plot->raster;
    double width = 0;
    for (size_t c = 0; c < raster->class_count; c++)
        width = fmax(width, text_extent(raster->classes[c].name, TEXT_SIZE, false).x);
    for (int i = 0; !raster->classes && i < layout->shades.count; i++) {
        char label[PLOT_TICKS_LABEL];
        plot_ticks_label(&layout->shades, i, label);
        width = fmax(width, text_extent(label, TEXT_SIZE, false).x);
    }
    return width;
}

/* Returns the raster's own range, or that of its values. */
static PlotTicks make_shades(const PlotRaster *raster, int most) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    const PlotAxis *axis = &raster->value;
    for (size_t i = 0; i < raster->columns * raster->rows; i++)
        if (isfinite(raster->values[i]) && (!axis->logarithmic || raster->values[i] > 0)) {
            low = fmin(low, raster->values[i]);
            high = fmax(high, raster->values[i]);
        }
    if (axis->low != axis->high) {
        low = axis->low;
        high = axis->high;
    }
    if (axis->logarithmic)
        return plot_ticks_make_logarithmic(low, high, most, false);
    return plot_ticks_make(low, high, most, false);
}

double plot_key_place(PlotLayout *layout, const Plot *plot, int most) {
    const PlotRaster *raster = plot->raster;
    layout->key = (Box){{0, 0}, {0, 0}};
    if (!raster)
        return 0;
    if (!raster->classes)
        layout->shades = make_shades(raster, most);
    double patch = raster->classes ? PATCH_WIDTH : BAR_WIDTH;
    double width = patch + TEXT_GAP + text_width(layout, plot);
    Box frame = layout->sheet.frame;
    double left = frame.high.x - width;
    layout->key = (Box){{left, frame.low.y}, {left + patch, frame.high.y}};
    if (raster->classes)
        layout->key.high.y = frame.low.y + ROW_HEIGHT * (double)raster->class_count;
    return width + GAP;
}

Box plot_key_class(const PlotLayout *layout, const Plot *plot, size_t index) {
    double row = box_height(layout->key) / (double)plot->raster->class_count;
    double middle = layout->key.low.y + ((double)index + 0.5) * row, half = fmin(PATCH_HEIGHT, 0.8 * row) / 2;
    return (Box){{layout->key.low.x, middle - half}, {layout->key.high.x, middle + half}};
}

static void add_text(PlotLayout *layout, const char *text, double y) {
    Layout *sheet = &layout->sheet;
    double left = layout->key.high.x + TEXT_GAP;
    Caption *caption = caption_add(sheet, arena_text(&sheet->arena, text), TEXT_SIZE, false, vec2(left, y));
    caption->centre.x += caption->extent.x / 2;
}

static void add_title(PlotLayout *layout, const PlotAxis *axis) {
    char title[PLOT_TICKS_TITLE];
    Layout *sheet = &layout->sheet;
    double right = sheet->page.x - TEXT_GAP;
    plot_ticks_title(&layout->shades, axis->title, axis->unit, title);
    if (text_extent(title, TEXT_SIZE, false).x > right - layout->key.low.x)
        plot_ticks_title(&layout->shades, NULL, axis->unit, title);
    Caption *caption = caption_add(sheet, arena_text(&sheet->arena, title), TEXT_SIZE, false,
                                   vec2(right, layout->key.low.y - TITLE_ROW));
    caption->centre.x -= caption->extent.x / 2;
}

void plot_key_add(PlotLayout *layout, const Plot *plot) {
    const PlotRaster *raster = plot->raster;
    if (!raster)
        return;
    for (size_t c = 0; c < raster->class_count; c++) {
        Box box = plot_key_class(layout, plot, c);
        add_text(layout, raster->classes[c].name, (box.low.y + box.high.y) / 2);
    }
    if (raster->classes)
        return;
    for (int i = 0; i < layout->shades.count; i++) {
        char label[PLOT_TICKS_LABEL];
        plot_ticks_label(&layout->shades, i, label);
        double part = plot_ticks_part(&layout->shades, plot_ticks_at(&layout->shades, i));
        add_text(layout, label, layout->key.high.y - part * box_height(layout->key));
    }
    add_title(layout, &raster->value);
}
