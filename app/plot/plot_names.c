#include "plot/plot_names.h"

#include "draw/caption.h"
#include "draw/mask.h"
#include "draw/text.h"
#include "plot/plot_frame.h"

/* Design points. */
#define TEXT_SIZE 16.0
#define AIR 3.0          /* kept free between a text and its surroundings */
#define STRIDE 4.0       /* between the points of a series that are marked */
#define APART 8.0        /* from other series, next to a name */
#define PLACE_STRIDE 6.0 /* between candidate places along a series */
#define MARK_HEIGHT 18.0 /* of a class' mark */

#define SERIES_WEIGHT 1.0
#define TEXT_WEIGHT 10.0
#define TEXT_CONTRAST 4.5 /* a name in a paler colour would be illegible */

enum { GUIDE_PLACES = 13 /* candidate places along a guide, on either side */ };

/* Returns the points of a series on the page, about STRIDE apart, with a NAN at each gap; `*count` of them. */
static Vec2 *series_points(const PlotLayout *layout, const PlotSeries *series, size_t *count) {
    Vec2 *points = memory_zeroed(series->count + 1, sizeof *points);
    *count = 0;
    for (size_t i = 0; i < series->count; i++) {
        Vec2 value = plot_value(series, i);
        bool whole = plot_frame_shows(layout, value);
        Vec2 at = whole ? plot_frame_point(layout, value) : vec2(NAN, NAN);
        if (*count && vec2_distance(points[*count - 1], at) < STRIDE && i + 1 < series->count)
            continue;
        points[(*count)++] = at;
    }
    return points;
}

static void mark_series(Mask *mask, const PlotLayout *layout, const PlotSeries *series) {
    size_t count;
    Vec2 *points = series_points(layout, series, &count);
    for (size_t i = 0; i < count; i++) {
        if (isnan(points[i].x))
            continue;
        if (series->symbol != SYMBOL_NONE)
            mask_mark_box(mask, box_around(points[i], series->size / 2 + series->ground), SERIES_WEIGHT);
        if (series->width > 0 && i && !isnan(points[i - 1].x))
            mask_mark_line(mask, points[i - 1], points[i], series->width + 2 * series->ground, SERIES_WEIGHT);
    }
    memory_free(points);
}

static void mark_guides(Mask *mask, const PlotLayout *layout, const Plot *plot) {
    Vec2 ends[2];
    for (size_t g = 0; g < plot->guide_count; g++)
        if (plot_frame_guide(layout, &plot->guides[g], ends))
            mask_mark_line(mask, ends[0], ends[1], 1, SERIES_WEIGHT);
}

/* Marks the parts of the plot that must stay visible. */
static void mark_plot(Mask *mask, const PlotLayout *layout, const Plot *plot) {
    mask_init(mask, layout->sheet.frame);
    for (size_t s = 0; s < plot->series_count; s++)
        mark_series(mask, layout, &plot->series[s]);
    mark_guides(mask, layout, plot);
    for (size_t i = 0; i < layout->sheet.caption_count; i++)
        mask_mark_box(mask, caption_box(&layout->sheet.captions[i]), TEXT_WEIGHT);
}

static Role text_role(Role role) {
    for (Theme theme = 0; theme < THEME_COUNT; theme++)
        if (palette_contrast(palette_colour(theme, role), palette_colour(theme, ROLE_PAPER)) < TEXT_CONTRAST)
            return ROLE_TEXT;
    return role;
}

/* Returns the middle of a text next to a point: right of it, above, below, left. */
static Vec2 beside(Vec2 at, Vec2 extent, int side, double gap) {
    static const Vec2 sides[] = {{1, 0}, {0, -1}, {0, 1}, {-1, 0}};
    return vec2(at.x + sides[side].x * (extent.x / 2 + gap), at.y + sides[side].y * (extent.y / 2 + gap));
}

/* Finds a free place next to the series, preferably near its end, where it runs apart from all others; false if there
 * is none. */
static bool find_place(const Mask *mask, const Mask *others, const PlotLayout *layout, const PlotSeries *series,
                       Vec2 extent, Vec2 *centre) {
    size_t count;
    Vec2 *points = series_points(layout, series, &count), last = vec2(HUGE_VAL, HUGE_VAL);
    Vec2 half = vec2_scale(extent, 0.5);
    bool found = false;
    for (size_t i = count; i-- > 0 && !found;) {
        if (isnan(points[i].x) || vec2_distance(points[i], last) < PLACE_STRIDE)
            continue;
        last = points[i];
        if (mask_cost(others, box_around(last, APART)) > 0)
            continue;
        for (int side = 0; side < 4 && !found; side++) {
            *centre = beside(last, extent, side, series->width / 2 + 2 * AIR);
            found = mask_cost(mask, box_expand((Box){vec2_sub(*centre, half), vec2_add(*centre, half)}, AIR)) == 0;
        }
    }
    memory_free(points);
    return found;
}

static bool add_name(PlotLayout *layout, Mask *mask, const Plot *plot, const PlotSeries *series) {
    Mask others;
    mask_init(&others, box_expand(layout->sheet.frame, APART));
    for (size_t s = 0; s < plot->series_count; s++)
        if (&plot->series[s] != series)
            mark_series(&others, layout, &plot->series[s]);
    Caption *caption = caption_add(&layout->sheet, series->name, TEXT_SIZE, true, vec2(0, 0));
    caption->role = text_role(series->role);
    bool found = find_place(mask, &others, layout, series, caption->extent, &caption->centre);
    mask_mark_box(mask, caption_box(caption), TEXT_WEIGHT);
    mask_clear(&others);
    return found;
}

bool plot_names_series(PlotLayout *layout, const Plot *plot) {
    Mask mask;
    size_t before = layout->sheet.caption_count;
    bool good = true;
    mark_plot(&mask, layout, plot);
    for (size_t s = 0; s < plot->series_count && good; s++)
        good = !plot->series[s].name || add_name(layout, &mask, plot, &plot->series[s]);
    if (!good)
        layout->sheet.caption_count = before;
    mask_clear(&mask);
    return good;
}

/* Returns the middle of a text on one side of a guide, at a share of its length from its first place: the right end,
 * or the upper end of an upright guide. */
static Vec2 beside_guide(const PlotLayout *layout, const PlotGuide *guide, Vec2 extent, int side, double part) {
    Box frame = box_expand(layout->sheet.frame, -AIR);
    Vec2 at = plot_frame_point(layout, vec2(guide->at, guide->at)), half = vec2_scale(extent, 0.5);
    Vec2 room = vec2(box_width(frame) - extent.x, box_height(frame) - extent.y);
    if (guide->upright)
        return vec2(at.x + side * (half.x + AIR), frame.low.y + half.y + part * fmax(0, room.y));
    return vec2(frame.high.x - half.x - part * fmax(0, room.x), at.y - side * (half.y + 1));
}

static Vec2 best_beside_guide(const Mask *mask, const PlotLayout *layout, const PlotGuide *guide, Vec2 extent) {
    Vec2 best = vec2(0, 0), half = vec2_scale(extent, 0.5);
    double least = HUGE_VAL;
    for (int i = 0; i < GUIDE_PLACES; i++)
        for (int side = 1; side >= -1; side -= 2) {
            Vec2 centre = beside_guide(layout, guide, extent, side, (double)i / (GUIDE_PLACES - 1));
            double cost = mask_cost(mask, (Box){vec2_sub(centre, half), vec2_add(centre, half)});
            if (cost < least) {
                least = cost;
                best = centre;
            }
        }
    return best;
}

/* Finds the best place within a band, in the middle across it. */
static Vec2 best_within_band(const Mask *mask, Box band, bool upright, Vec2 extent) {
    Vec2 best = vec2(0, 0), half = vec2_scale(extent, 0.5);
    Vec2 room = vec2(fmax(0, box_width(band) - extent.x - 2 * AIR), fmax(0, box_height(band) - extent.y - 2 * AIR));
    double least = HUGE_VAL;
    for (int i = 0; i < GUIDE_PLACES; i++) {
        double part = (double)i / (GUIDE_PLACES - 1);
        Vec2 centre = upright ? vec2((band.low.x + band.high.x) / 2, band.low.y + AIR + half.y + part * room.y)
                              : vec2(band.high.x - AIR - half.x - part * room.x, (band.low.y + band.high.y) / 2);
        centre.x = real_clamp(centre.x, mask->box.low.x + half.x, mask->box.high.x - half.x);
        double cost = mask_cost(mask, (Box){vec2_sub(centre, half), vec2_add(centre, half)});
        if (cost < least) {
            least = cost;
            best = centre;
        }
    }
    return best;
}

/* True if the last caption overlaps another one. */
static bool hits_a_caption(const Layout *sheet) {
    Box last = caption_box(&sheet->captions[sheet->caption_count - 1]);
    for (size_t i = 0; i + 1 < sheet->caption_count; i++) {
        Box other = caption_box(&sheet->captions[i]);
        if (last.low.x < other.high.x && other.low.x < last.high.x && last.low.y < other.high.y &&
            other.low.y < last.high.y)
            return true;
    }
    return false;
}

void plot_names_guides(PlotLayout *layout, const Plot *plot, bool listed) {
    Mask mask;
    if (!plot->guide_count)
        return;
    mark_plot(&mask, layout, plot);
    for (size_t g = 0; g < plot->guide_count; g++) {
        const PlotGuide *guide = &plot->guides[g];
        Vec2 ends[2];
        Box band;
        bool shown = guide->band ? plot_frame_band(layout, guide, &band) : plot_frame_guide(layout, guide, ends);
        if (!guide->name || !shown || (listed && guide->listed))
            continue;
        Caption *caption = caption_add(&layout->sheet, guide->name, TEXT_SIZE, false, vec2(0, 0));
        caption->centre = guide->band ? best_within_band(&mask, band, guide->upright, caption->extent)
                                      : best_beside_guide(&mask, layout, guide, caption->extent);
        caption->role = guide->band ? ROLE_TEXT : text_role(guide->role);
        caption->halo = true;
        caption->fill = ROLE_PAPER;
        if (hits_a_caption(&layout->sheet)) {
            layout->sheet.caption_count--; /* a name on a name tells neither */
            continue;
        }
        mask_mark_box(&mask, caption_box(caption), TEXT_WEIGHT);
    }
    mask_clear(&mask);
}

/* The largest square of cells of a class: its upper right corner and its side in cells, 0: none. */
typedef struct Square {
    size_t column, row, side;
} Square;

/* Finds the square; `sides` has room for a row of the raster. */
static Square largest_square(const PlotRaster *raster, double class, size_t *sides) {
    Square best = {0, 0, 0};
    for (size_t row = 0; row < raster->rows; row++)
        for (size_t column = 0, before = 0; column < raster->columns; column++) {
            size_t above = row ? sides[column] : 0, left = column ? sides[column - 1] : 0, side = 0;
            if (raster->values[row * raster->columns + column] == class) {
                side = above < left ? above : left;
                side = 1 + (before < side ? before : side);
            }
            before = above;
            sides[column] = side;
            if (side > best.side)
                best = (Square){column, row, side};
        }
    return best;
}

/* Returns the place of a text in a box that is nearest to its middle and covers nothing of a mask; false: there is
 * none.
 */
static bool find_free(const Mask *mask, Box box, Vec2 extent, Vec2 *centre) {
    Vec2 middle = vec2_scale(vec2_add(box.low, box.high), 0.5), half = vec2_scale(extent, 0.5);
    int across = (int)floor((box_width(box) - extent.x) / 2 / STRIDE);
    int along = (int)floor((box_height(box) - extent.y) / 2 / STRIDE);
    double nearest = HUGE_VAL;
    for (int row = -along; row <= along && across >= 0; row++)
        for (int column = -across; column <= across; column++) {
            Vec2 at = vec2(middle.x + STRIDE * column, middle.y + STRIDE * row);
            double away = vec2_distance(at, middle);
            if (away < nearest && mask_cost(mask, (Box){vec2_sub(at, half), vec2_add(at, half)}) == 0) {
                nearest = away;
                *centre = at;
            }
        }
    return isfinite(nearest);
}

static void add_mark(PlotLayout *layout, const Mask *mask, const PlotRaster *raster, const PlotClass *marked,
                     Square square) {
    Vec2 cell = vec2(box_width(raster->box) / (double)raster->columns, box_height(raster->box) / (double)raster->rows);
    Vec2 high = vec2(raster->box.low.x + cell.x * (double)(square.column + 1),
                     raster->box.low.y + cell.y * (double)(square.row + 1));
    Vec2 low = vec2_along(high, -(double)square.side, cell), centre;
    Vec2 from = plot_frame_point(layout, low), to = plot_frame_point(layout, high);
    Vec2 extent = vec2(text_extent(marked->mark, TEXT_SIZE, true).x, MARK_HEIGHT);
    if (!find_free(mask, (Box){{from.x, to.y}, {to.x, from.y}}, extent, &centre))
        return;
    Caption *caption = caption_add(&layout->sheet, marked->mark, TEXT_SIZE, true, centre);
    caption->extent.y = MARK_HEIGHT;
    caption->shape = LABEL_TAG;
    caption->fill = marked->role;
}

void plot_names_classes(PlotLayout *layout, const Plot *plot) {
    const PlotRaster *raster = plot->raster;
    if (!raster || !raster->classes)
        return;
    Mask mask;
    mask_init(&mask, layout->sheet.frame);
    for (size_t i = 0; i < plot->series_count; i++)
        mark_series(&mask, layout, &plot->series[i]);
    size_t *sides = memory_zeroed(raster->columns, sizeof *sides);
    for (size_t c = 0; c < raster->class_count; c++) {
        Square square = largest_square(raster, (double)c, sides);
        if (square.side && raster->classes[c].mark)
            add_mark(layout, &mask, raster, &raster->classes[c], square);
    }
    memory_free(sides);
    mask_clear(&mask);
}
