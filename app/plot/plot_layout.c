#include "plot/plot_layout.h"

#include <string.h>

#include "base/text.h"
#include "draw/caption.h"
#include "plot/plot_frame.h"
#include "plot/plot_key.h"
#include "plot/plot_names.h"
#include "draw/text.h"

/* Design points. */
#define TITLE_TEXT 18.0
#define AXIS_TEXT 16.0
#define NAME_TEXT 16.0
#define SOURCE_TEXT 11.0
#define SOURCE_HEIGHT 16.0
#define MARGIN 6.0
#define ROW_HEIGHT 23.0 /* of titles and names */
#define LOW_ROW 21.0    /* of further rows of a low plot */
#define ROW_GAP 7.0     /* below the titles: half of the topmost label */
#define LABEL_HEIGHT 18.0
#define LABEL_GAP 7.0    /* between an axis and its labels; the tick is within */
#define LABEL_APART 12.0 /* between the labels of the x axis */
#define ITEM_GAP 11.0
#define SAMPLE_LENGTH 26.0
#define SAMPLE_GAP 5.0
#define AREA_SAMPLE 14.0   /* the height of an area's sample */
#define UPRIGHT_LEAST 33.0 /* from tick to tick of the y axis */
#define ACROSS_LEAST 34.0  /* from tick to tick of the x axis */
#define LOW 200.0          /* a lower plot has its titles in shared rows */
#define LEAST_FRAME 0.4    /* share of the height: names that leave less to the lines are left out */

static Box include_shown(Box reach, const Plot *plot, Vec2 value) {
    bool shown = isfinite(value.x) && isfinite(value.y) && (!plot->x.logarithmic || value.x > 0) &&
                 (!plot->y.logarithmic || value.y > 0);
    return shown ? box_include(reach, value) : reach;
}

static Box include_guide(Box reach, const Plot *plot, const PlotGuide *guide) {
    double ends[] = {guide->at, guide->band ? guide->to : guide->at};
    for (int i = 0; i < 2; i++) {
        bool shown = isfinite(ends[i]) && (!(guide->upright ? &plot->x : &plot->y)->logarithmic || ends[i] > 0);
        double at = shown ? ends[i] : NAN;
        reach = box_include(reach, guide->upright ? vec2(at, NAN) : vec2(NAN, at));
    }
    return reach;
}

/* Returns the range of the series and the guides; ignores values that are not finite or not on the scale. */
static Box plot_reach(const Plot *plot) {
    Box reach = box_empty();
    for (size_t s = 0; s < plot->series_count; s++)
        for (size_t i = 0; i < plot->series[s].count; i++)
            reach = include_shown(reach, plot, plot_value(&plot->series[s], i));
    for (size_t a = 0; a < plot->area_count; a++)
        for (size_t i = 0; i < plot->areas[a].count; i++) {
            const PlotArea *area = &plot->areas[a];
            reach = include_shown(reach, plot, vec2(area->x[i], area->low[i]));
            reach = include_shown(reach, plot, vec2(area->x[i], area->high[i]));
        }
    for (size_t g = 0; g < plot->guide_count; g++)
        reach = include_guide(reach, plot, &plot->guides[g]);
    return reach;
}

/* Returns an axis; a raster fills its axes. */
static PlotAxis shown_axis(const Plot *plot, bool upright) {
    PlotAxis axis = upright ? plot->y : plot->x;
    if (plot->raster && axis.low == axis.high) {
        axis.low = upright ? plot->raster->box.low.y : plot->raster->box.low.x;
        axis.high = upright ? plot->raster->box.high.y : plot->raster->box.high.x;
    }
    return axis;
}

static PlotTicks axis_ticks(const PlotAxis *axis, double low, double high, int most) {
    bool fitted = axis->low == axis->high;
    if (axis->logarithmic)
        return plot_ticks_make_logarithmic(fitted ? low : axis->low, fitted ? high : axis->high, most, fitted);
    return plot_ticks_make(fitted ? low : axis->low, fitted ? high : axis->high, most, fitted);
}

static double widest_label(const PlotTicks *ticks) {
    double widest = 0;
    for (int i = 0; i < ticks->count; i++) {
        char label[PLOT_TICKS_LABEL];
        plot_ticks_label(ticks, i, label);
        widest = fmax(widest, text_extent(label, AXIS_TEXT, false).x);
    }
    return widest;
}

/* Returns the most ticks of the x axis whose labels have room between them. */
static PlotTicks ticks_across(const PlotAxis *axis, Box reach, double width) {
    PlotTicks ticks;
    int most = (int)(fmax(0, width) / ACROSS_LEAST) + 1;
    do
        ticks = axis_ticks(axis, reach.low.x, reach.high.x, most);
    while (--most >= 2 &&
           widest_label(&ticks) + LABEL_APART > width * (plot_ticks_part(&ticks, plot_ticks_at(&ticks, 1)) -
                                                         plot_ticks_part(&ticks, plot_ticks_at(&ticks, 0))));
    return ticks;
}

static Caption *add_text(PlotLayout *layout, const char *text, double size, bool bold, Vec2 centre) {
    Layout *sheet = &layout->sheet;
    return caption_add(sheet, arena_text(&sheet->arena, text), size, bold, centre);
}

/* The parts of the rows above the frame, besides title and note. */
typedef struct Above {
    bool names;  /* of the series, */
    bool listed; /* and of those guides that are to stand among them */
    bool across; /* the title of the x axis, */
    bool bare;   /* which shares the first row, or is left out but for its unit */
} Above;

/* Rows of text above the frame, filled from left to right. */
typedef struct Rows {
    PlotLayout *layout;
    double left, middle; /* design points, where the next text begins */
} Rows;

static void begin_row(Rows *rows) {
    rows->left = MARGIN;
    rows->middle += rows->layout->sheet.page.y < LOW ? LOW_ROW : ROW_HEIGHT;
}

/* Returns a text, or what stands before its colon, its bracket or "of the" if only that fits. */
static const char *shorter_title(Layout *sheet, const char *text, double size, bool bold, double width) {
    const char *colon = strstr(text, ": "), *bracket = strstr(text, " ("),
               *end = colon     ? colon
                      : bracket ? bracket
                                : strstr(text, " of the ");
    return end && text_extent(text, size, bold).x > width
               ? text_in_arena(&sheet->arena, "%.*s", (int)(end - text), text)
               : text;
}

/* Returns the whole title, or a shorter one where the units of both axes need the rest of the row. */
static const char *bare_title(Layout *sheet, const Plot *plot, const char *upright) {
    double right = sheet->page.x - MARGIN, units = text_extent(upright, AXIS_TEXT, false).x + 2 * ITEM_GAP;
    if (plot->x.unit)
        units += text_extent(text_in_arena(&sheet->arena, "over %s", plot->x.unit), AXIS_TEXT, false).x;
    double whole = text_extent(plot->title, TITLE_TEXT, true).x, fits = right - MARGIN - units;
    const char *brief = shorter_title(sheet, plot->title, TITLE_TEXT, true, fits);
    return whole > fits && text_extent(brief, TITLE_TEXT, true).x <= fits ? brief : plot->title;
}

/* Adds a text, `before` design points to its left kept free, to this row or the next. */
static Caption *add_item(Rows *rows, const char *text, double size, bool bold, double before) {
    Layout *sheet = &rows->layout->sheet;
    double right = sheet->page.x - MARGIN, rounding = 0.5;
    const char *whole = shorter_title(sheet, text, size, bold, right - MARGIN - before);
    const char *label = caption_shortened(sheet, whole, size, bold, right - MARGIN - before);
    double width = before + text_extent(label, size, bold).x;
    if (rows->left > MARGIN && rows->left + width > right + rounding)
        begin_row(rows);
    Caption *caption = add_text(rows->layout, label, size, bold, vec2(rows->left + before, rows->middle));
    caption->centre.x += caption->extent.x / 2;
    rows->left += width + ITEM_GAP;
    return caption;
}

/* True if a text of an axis has room in the present row. */
static bool has_room(const Rows *rows, const char *text) {
    return rows->left + text_extent(text, AXIS_TEXT, false).x <= rows->layout->sheet.page.x - MARGIN;
}

static double name_width(const char *name, double before) {
    return name ? before + SAMPLE_LENGTH + SAMPLE_GAP + text_extent(name, NAME_TEXT, false).x : 0;
}

static bool is_listed(const PlotGuide *guide, Above wanted) {
    return wanted.listed && guide->listed && guide->name;
}

static double names_width(const Plot *plot, Above wanted) {
    double width = 0;
    for (size_t a = 0; a < plot->area_count; a++)
        width += name_width(plot->areas[a].name, width > 0 ? ITEM_GAP : 0);
    for (size_t s = 0; s < plot->series_count; s++)
        width += name_width(plot->series[s].name, width > 0 ? ITEM_GAP : 0);
    for (size_t g = 0; g < plot->guide_count; g++)
        if (is_listed(&plot->guides[g], wanted))
            width += name_width(plot->guides[g].name, width > 0 ? ITEM_GAP : 0);
    return width;
}

/* Adds a name; returns the middle of the room for its sample. */
static Vec2 add_name(Rows *rows, const char *name) {
    Caption *caption = add_item(rows, name, NAME_TEXT, false, SAMPLE_LENGTH + SAMPLE_GAP);
    return vec2(caption->centre.x - caption->extent.x / 2 - SAMPLE_GAP - SAMPLE_LENGTH / 2, caption->centre.y);
}

/* Adds a sample of a line around a middle. */
static void add_line_sample(Layout *sheet, Vec2 middle, Role role, LineStyle style, double width) {
    layout_add_sample(sheet, (Sample){.from = vec2(middle.x - SAMPLE_LENGTH / 2, middle.y),
                                      .to = vec2(middle.x + SAMPLE_LENGTH / 2, middle.y),
                                      .role = role,
                                      .style = style,
                                      .width = width});
}

static void add_series_name(Rows *rows, const PlotSeries *series) {
    PlotLayout *layout = rows->layout;
    Vec2 middle = add_name(rows, series->name);
    if (series->width > 0)
        add_line_sample(&layout->sheet, middle, series->role, series->style, series->width);
    if (series->symbol != SYMBOL_NONE)
        layout->marks[layout->mark_count++] = (PlotMark){series, middle};
}

/* Returns the width of the second axis for y. */
static double right_width(const PlotLayout *layout, const Plot *plot) {
    char title[PLOT_TICKS_TITLE];
    if (plot->right_factor == 0)
        return 0;
    plot_ticks_title(&layout->right, plot->right.title, plot->right.unit, title);
    return fmax(LABEL_GAP + widest_label(&layout->right), text_extent(title, AXIS_TEXT, false).x + LABEL_GAP);
}

/* Adds the names at the right end of a row if one row holds them all. */
static void add_names(Rows *rows, const Plot *plot, Above wanted) {
    Layout *sheet = &rows->layout->sheet;
    double right = sheet->page.x - MARGIN, width = names_width(plot, wanted);
    if (rows->left > MARGIN && rows->left + width > right)
        begin_row(rows);
    rows->left = fmax(rows->left, right - width);
    for (size_t a = 0; a < plot->area_count; a++)
        if (plot->areas[a].name) {
            Vec2 middle = add_name(rows, plot->areas[a].name);
            add_line_sample(sheet, middle, plot->areas[a].role, LINE_SOLID, AREA_SAMPLE);
        }
    for (size_t s = 0; s < plot->series_count; s++)
        if (plot->series[s].name)
            add_series_name(rows, &plot->series[s]);
    for (size_t g = 0; g < plot->guide_count; g++) {
        const PlotGuide *guide = &plot->guides[g];
        if (is_listed(guide, wanted))
            add_line_sample(sheet, add_name(rows, guide->name), guide->role, guide->style, PLOT_LAYOUT_GUIDE);
    }
}

/* Adds the titles and, if they stand above, the names of the series; returns how far down they reach. */
static double add_rows(PlotLayout *layout, const Plot *plot, Above wanted) {
    char title[PLOT_TICKS_TITLE], across[PLOT_TICKS_TITLE];
    bool names = wanted.names;
    plot_ticks_title(&layout->y, plot->y.title, plot->y.unit, title);
    Rows rows = {layout, MARGIN, ROW_HEIGHT / 2 + 2};
    bool low = layout->sheet.page.y < LOW;
    if (plot->title)
        add_item(&rows, wanted.bare ? bare_title(&layout->sheet, plot, title) : plot->title, TITLE_TEXT, true, 0);
    if (*title && (low || !plot->title))
        add_item(&rows, title, plot->title ? AXIS_TEXT : TITLE_TEXT - 2, !plot->title, 0);
    if (wanted.across && plot->x.title) {
        plot_ticks_title(&layout->x, plot->x.title, plot->x.unit, across);
        const char *whole = text_in_arena(&layout->sheet.arena, "over %s", across);
        const char *brief =
            plot->x.unit && layout->x.power == 0 ? text_in_arena(&layout->sheet.arena, "over %s", plot->x.unit) : whole;
        const char *over = !wanted.bare || has_room(&rows, whole) ? whole : has_room(&rows, brief) ? brief : NULL;
        if (over)
            add_item(&rows, over, AXIS_TEXT, false, 0);
        layout->across = over != NULL;
    }
    if (plot->note)
        add_item(&rows, plot->note, AXIS_TEXT, false, 0)->role = ROLE_DIM_TEXT;
    bool above =
        names && plot->right_factor != 0 && names_width(plot, wanted) > 0; /* both titles stand in the last row */
    if (above) {
        begin_row(&rows);
        add_names(&rows, plot, wanted);
    }
    if ((*title || above) && !low && plot->title) {
        begin_row(&rows);
        add_item(&rows, title, AXIS_TEXT, false, 0);
    }
    if (names && !above)
        add_names(&rows, plot, wanted);
    return rows.middle + ROW_HEIGHT / 2;
}

static void add_grid(PlotLayout *layout) {
    Box frame = layout->sheet.frame;
    for (int i = 0; i < layout->x.count; i++) {
        double x = plot_frame_point(layout, vec2(plot_ticks_at(&layout->x, i), 0)).x;
        layout_add_grid_line(&layout->sheet, vec2(x, frame.low.y), vec2(x, frame.high.y));
    }
    for (int i = 0; i < layout->y.count; i++) {
        double y = plot_frame_point(layout, vec2(0, plot_ticks_at(&layout->y, i))).y;
        layout_add_grid_line(&layout->sheet, vec2(frame.low.x, y), vec2(frame.high.x, y));
    }
}

static void add_upright_labels(PlotLayout *layout) {
    double right = layout->sheet.frame.low.x - LABEL_GAP;
    for (int i = 0; i < layout->y.count; i++) {
        char label[PLOT_TICKS_LABEL];
        plot_ticks_label(&layout->y, i, label);
        double y = plot_frame_point(layout, vec2(0, plot_ticks_at(&layout->y, i))).y;
        Caption *caption = add_text(layout, label, AXIS_TEXT, false, vec2(right, y));
        caption->centre.x -= caption->extent.x / 2;
    }
}

/* Writes the unit of the x axis between the labels of its last two ticks, if it has room there. */
static void add_unit(PlotLayout *layout, const Plot *plot, double row) {
    const Layout *sheet = &layout->sheet;
    const char *unit = plot->x.unit;
    if (!unit || !*unit || strcmp(unit, "1") == 0 || layout->x.power != 0 || layout->x.count < 2)
        return;
    const Caption *last = &sheet->captions[sheet->caption_count - 1], *before = last - 1;
    double left = before->centre.x + before->extent.x / 2, right = last->centre.x - last->extent.x / 2;
    if (right - left > text_extent(unit, AXIS_TEXT, false).x + LABEL_APART)
        add_text(layout, unit, AXIS_TEXT, false, vec2((left + right) / 2, row));
}

/* In a low plot the title takes the end of the labels' row. False: labels need that place. */
static bool add_across_labels(PlotLayout *layout, const Plot *plot, Above above) {
    char title[PLOT_TICKS_TITLE];
    Layout *sheet = &layout->sheet;
    bool complete = true;
    plot_ticks_title(&layout->x, plot->x.title, plot->x.unit, title);
    double row = sheet->frame.high.y + LABEL_GAP + LABEL_HEIGHT / 2, end = sheet->page.x;
    if (*title && !above.across) {
        bool low = sheet->page.y < LOW;
        Caption *caption = add_text(layout, title, AXIS_TEXT, false,
                                    vec2((sheet->frame.low.x + sheet->frame.high.x) / 2, row + LABEL_HEIGHT));
        if (low) {
            caption->centre = vec2(sheet->page.x - MARGIN - caption->extent.x / 2, row);
            end = caption->centre.x - caption->extent.x / 2 - LABEL_APART;
        }
    }
    for (int i = 0; i < layout->x.count; i++) {
        char label[PLOT_TICKS_LABEL];
        plot_ticks_label(&layout->x, i, label);
        double x = plot_frame_point(layout, vec2(plot_ticks_at(&layout->x, i), 0)).x;
        complete = complete && x + text_extent(label, AXIS_TEXT, false).x / 2 <= end;
        add_text(layout, label, AXIS_TEXT, false, vec2(x, row));
    }
    if (above.bare && !layout->across)
        add_unit(layout, plot, row);
    return complete;
}

/* Adds the labels of the second axis for y. */
static void add_right_labels(PlotLayout *layout, const Plot *plot) {
    char title[PLOT_TICKS_TITLE];
    Box frame = layout->sheet.frame;
    if (plot->right_factor == 0)
        return;
    for (int i = 0; i < layout->right.count; i++) {
        char label[PLOT_TICKS_LABEL];
        plot_ticks_label(&layout->right, i, label);
        double y = plot_frame_point(layout, vec2(0, plot_ticks_at(&layout->right, i) / plot->right_factor)).y;
        Caption *caption = add_text(layout, label, AXIS_TEXT, false, vec2(frame.high.x + LABEL_GAP, y));
        caption->centre.x += caption->extent.x / 2;
    }
    plot_ticks_title(&layout->right, plot->right.title, plot->right.unit, title);
    add_text(layout, title, AXIS_TEXT, false,
             vec2(frame.high.x + right_width(layout, plot) / 2, frame.low.y - ROW_GAP - ROW_HEIGHT / 2));
}

/* Places the frame between the texts around it. */
static void place_frame(PlotLayout *layout, const Plot *plot, Box reach, Above above) {
    Layout *sheet = &layout->sheet;
    bool low = sheet->page.y < LOW;
    double foot = LABEL_GAP + LABEL_HEIGHT * (low || above.across || !plot->x.title ? 1 : 2) + MARGIN / 2 +
                  (plot->source ? SOURCE_HEIGHT : 0);
    sheet->frame = (Box){{0, 0}, {sheet->page.x - MARGIN, sheet->page.y - foot}};
    PlotAxis across = shown_axis(plot, false), upright = shown_axis(plot, true);
    layout->y = axis_ticks(&upright, reach.low.y, reach.high.y, 2);
    layout->x = axis_ticks(&across, reach.low.x, reach.high.x, 2);
    sheet->frame.low.y = add_rows(layout, plot, above) + ROW_GAP;
    int most = (int)(fmax(0, box_height(sheet->frame)) / UPRIGHT_LEAST) + 1;
    layout->y = axis_ticks(&upright, reach.low.y, reach.high.y, most);
    if (plot->right_factor != 0)
        layout->right =
            plot_ticks_make(layout->y.low * plot->right_factor, layout->y.high * plot->right_factor, most, false);
    sheet->frame.high.x -= plot_key_place(layout, plot, most) + right_width(layout, plot);
    sheet->frame.low.x = MARGIN + widest_label(&layout->y) + LABEL_GAP;
    layout->x = ticks_across(&across, reach, box_width(sheet->frame));
    double half = widest_label(&layout->x) / 2; /* of a label that extends beyond either end */
    sheet->frame.low.x = fmax(sheet->frame.low.x, MARGIN + half);
    double beside = sheet->page.x - MARGIN - sheet->frame.high.x;
    sheet->frame.high.x -= fmax(0, half - beside);
    layout->x = ticks_across(&across, reach, box_width(sheet->frame));
}

/* Marks and areas have no line that a name could stand next to. */
static bool has_lines_only(const Plot *plot) {
    bool lines = !plot->area_count;
    for (size_t s = 0; s < plot->series_count; s++)
        lines = lines && plot->series[s].width > 0 && !plot->series[s].stems && !plot->series[s].open;
    return lines;
}

/* Adds the origin of the numbers at the foot of the page. */
static void add_source(PlotLayout *layout, const Plot *plot) {
    Layout *sheet = &layout->sheet;
    const char *line = caption_shortened(sheet, plot->source, SOURCE_TEXT, false, sheet->page.x - 2 * MARGIN);
    Caption *caption =
        add_text(layout, line, SOURCE_TEXT, false, vec2(MARGIN, sheet->page.y - MARGIN / 2 - SOURCE_HEIGHT / 2));
    caption->centre.x += caption->extent.x / 2;
    caption->role = ROLE_DIM_TEXT;
}

static void lay_out(PlotLayout *layout, const Plot *plot, Vec2 page, Above above) {
    plot_layout_clear(layout);
    layout->sheet.page = page;
    layout->marks = arena_allocate(&layout->sheet.arena, (plot->series_count + 1) * sizeof *layout->marks);
    place_frame(layout, plot, plot_reach(plot), above);
    add_grid(layout);
    add_upright_labels(layout);
    if (!add_across_labels(layout, plot, above)) {
        above.across = true;
        lay_out(layout, plot, page, above);
        return;
    }
    add_right_labels(layout, plot);
    plot_key_add(layout, plot);
    plot_names_classes(layout, plot);
    plot_names_guides(layout, plot, above.listed);
    if (plot->source)
        add_source(layout, plot);
}

void plot_layout_make(PlotLayout *layout, const Plot *plot, Vec2 page, PlotNames names) {
    *layout = (PlotLayout){0};
    bool several = plot->series_count + plot->area_count > 1, listed = false;
    bool beside = names == PLOT_NAMES_BESIDE && has_lines_only(plot);
    for (size_t g = 0; g < plot->guide_count; g++)
        listed = listed || (several && plot->guides[g].listed);
    lay_out(layout, plot, page, (Above){.names = several && !beside, .listed = listed && !beside});
    if (several && beside && !plot_names_series(layout, plot))
        lay_out(layout, plot, page, (Above){.names = true, .listed = listed});
    if (listed && box_height(layout->sheet.frame) < LEAST_FRAME * page.y)
        lay_out(layout, plot, page, (Above){.names = true});
    if (box_height(layout->sheet.frame) < LEAST_FRAME * page.y)
        lay_out(layout, plot, page, (Above){.names = false});
    if (box_height(layout->sheet.frame) < LEAST_FRAME * page.y)
        lay_out(layout, plot, page, (Above){.across = true, .bare = true});
}

void plot_layout_clear(PlotLayout *layout) {
    layout_clear(&layout->sheet);
    *layout = (PlotLayout){0};
}
