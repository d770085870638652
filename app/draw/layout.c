#include "draw/layout.h"

#include <stdio.h>
#include <string.h>

#include "draw/caption.h"
#include "draw/labels.h"
#include "draw/text.h"

/* Design points. The text sizes are legible from six picture heights away, that of the answer from eight. */
#define MARGIN 16.0
#define TITLE_TEXT 40.0
#define DETAIL_TEXT 20.0
#define NAME_TEXT 16.0
#define CLOCK_TEXT 24.0
#define BAND_HEIGHT 64.0
#define DETAIL_HEIGHT 32.0 /* of the detail's line when it stands below the answer */
#define NOTE_HEIGHT 32.0
#define FOOT_HEIGHT 44.0
#define LIST_WIDTH 356.0
#define PANEL_WIDTH 400.0
#define PANEL_HEIGHT 230.0 /* of panels below the plan */
#define PANEL_GAP 8.0
#define BARE_MARGIN 12.0
#define HEADING_TEXT 18.0
#define HEADING_HEIGHT 40.0
#define ROW_TEXT 16.0
#define ROW_HEIGHT 30.0
#define CELL_GAP 14.0
#define DISC_WIDTH 40.0   /* kept for a disc before a row's text */
#define LINE_WIDTH 54.0   /* kept for a line sample */
#define SYMBOL_WIDTH 46.0 /* kept for a line sample with a symbol */
#define LINE_SHOWN 14.0   /* of the line, and of the tag's own edge, on either side of the tag's text */
#define DISC_TEXT 16.0
#define BAR_LEAST 20.0    /* of the scale bar beside a plan */
#define BAR_SHORTEST 64.0 /* of the scale bar: room for "10 m" */
#define BAR_WIDTH 5.0
#define BAR_RIM 3.0       /* of paper around the bar: it may lie on something */
#define GRID_CLOSEST 14.0 /* design points: closer lines would look like a grey area */

/* A list goes below the plan only if that enlarges the plan by this factor. */
#define BELOW_GAIN 1.15

#define DESIGN_WIDTH 1280.0
#define DESIGN_HEIGHT 720.0

double layout_unit(int width, int height) {
    return fmin(width / DESIGN_WIDTH, height / DESIGN_HEIGHT);
}

static const double steps[] = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000};

/* Returns the first of 1, 2, 5, 10 ... that makes `unit` at least `least`. */
static double round_step(double unit, double least) {
    size_t i = 0;
    while (i + 1 < sizeof steps / sizeof *steps && steps[i] * unit < least)
        i++;
    return steps[i];
}

void layout_add_sample(Layout *layout, Sample sample) {
    layout->samples =
        memory_reserve(layout->samples, &layout->sample_capacity, layout->sample_count + 1, sizeof *layout->samples);
    layout->samples[layout->sample_count++] = sample;
}

/* Adds a text from `left`, shortened at `right`; returns the end of the text. */
static double add_text(Layout *layout, Role role, const char *text, double size, bool bold, double left, double right,
                       double y) {
    const char *label = caption_shortened(layout, text, size, bold, right - left);
    Caption *caption = caption_add(layout, label, size, bold, vec2(left, y));
    caption->centre.x += caption->extent.x / 2;
    caption->role = role;
    return left + caption->extent.x;
}

/* Places the answer and its detail, which stands next to the answer or, without room there, below it. */
static void place_band(Layout *layout, const Scene *scene) {
    layout->band = (Box){{0, 0}, {layout->page.x, 0}};
    if (scene->bare || !scene->title)
        return;
    double right = layout->page.x - MARGIN, room = right - MARGIN;
    double width = text_extent(scene->title, TITLE_TEXT, true).x;
    double size = width > room ? fmax(TITLE_TEXT * room / width, DETAIL_TEXT) : TITLE_TEXT;
    double end = add_text(layout, scene->title_role, scene->title, size, true, MARGIN, right, BAND_HEIGHT / 2);
    const char *text = scene->detail ? scene->detail : "";
    double detail = text_extent(text, DETAIL_TEXT, false).x;
    bool beside = end + 2 * CELL_GAP + detail <= right;
    layout->band = (Box){{0, 0}, {layout->page.x, BAND_HEIGHT + (beside ? 0 : DETAIL_HEIGHT)}};
    add_text(layout, ROLE_TEXT, text, DETAIL_TEXT, false, beside ? end + 2 * CELL_GAP : MARGIN, right,
             beside ? BAND_HEIGHT / 2 + 4 : BAND_HEIGHT + DETAIL_HEIGHT / 2 - 8);
}

/* Returns the row behind the section that begins at `row`. */
static size_t section_end(const Scene *scene, size_t row) {
    do
        row++;
    while (row < scene->row_count && scene->rows[row].kind != ROW_HEADING);
    return row;
}

static double row_height(const SceneRow *row) {
    return row->kind == ROW_HEADING ? HEADING_HEIGHT : ROW_HEIGHT;
}

static double rows_height(const Scene *scene, size_t first, size_t end) {
    double height = 0;
    for (size_t i = first; i < end; i++)
        height += row_height(&scene->rows[i]);
    return height;
}

/* Returns the width of a row's mark: a disc, or a line sample that shows on both sides of its tag. */
static double mark_width(const SceneRow *row) {
    if (row->kind == ROW_DISC)
        return DISC_WIDTH;
    if (row->kind != ROW_LINE)
        return 0;
    if (row->symbol != SYMBOL_NONE)
        return SYMBOL_WIDTH;
    double tag = row->mark ? text_extent(row->mark, DISC_TEXT, true).x + 2 * LINE_SHOWN : 0;
    return fmax(LINE_WIDTH, tag + CELL_GAP);
}

/* Draws the mark of a row, `width` wide; returns the begin of the row's text. */
static double place_mark(Layout *layout, const SceneRow *row, double left, double width, double y) {
    if (row->kind != ROW_DISC && row->kind != ROW_LINE)
        return left;
    double end = left + width, right = end - CELL_GAP;
    if (row->kind == ROW_LINE)
        layout_add_sample(layout, (Sample){{left, y}, {right, y}, row->role, row->style, row->width, row->symbol});
    if (row->mark) {
        Caption *mark = caption_add(layout, row->mark, DISC_TEXT, true, vec2((left + right) / 2, y));
        caption_shape(mark, row->kind == ROW_DISC ? LABEL_DISC : LABEL_TAG, row->role);
    }
    return end;
}

/* Places the mark of a row, widths[0] wide, and its cells; all cells but the first are aligned right in their columns,
 * and the first one has the room before the row's own next one. */
static void place_row(Layout *layout, const SceneRow *row, Box column, const double *widths, double y) {
    double left = place_mark(layout, row, column.low.x, widths[0], y), right = column.high.x, room = right;
    for (size_t c = ROW_CELLS; c-- > 1;) {
        if (row->cells[c]) {
            double width = text_extent(row->cells[c], ROW_TEXT, false).x;
            add_text(layout, ROLE_TEXT, row->cells[c], ROW_TEXT, false, right - width, right, y);
            room = right - width - CELL_GAP;
        }
        right -= widths[c] > 0 ? widths[c] + CELL_GAP : 0;
    }
    add_text(layout, ROLE_TEXT, row->cells[0], ROW_TEXT, false, left, room, y);
}

/* Places the rows of one section in a column of the page; `pitch` scales the row heights. */
static void place_section(Layout *layout, const Scene *scene, size_t first, size_t end, Box column, double pitch) {
    double widths[ROW_CELLS] = {0};
    for (size_t i = first; i < end; i++) {
        widths[0] = fmax(widths[0], mark_width(&scene->rows[i]));
        for (size_t c = 1; c < ROW_CELLS && scene->rows[i].cells[c]; c++)
            widths[c] = fmax(widths[c], text_extent(scene->rows[i].cells[c], ROW_TEXT, false).x);
    }
    double y = column.low.y;
    for (size_t i = first; i < end; i++) {
        const SceneRow *row = &scene->rows[i];
        double middle = y + row_height(row) * pitch / 2;
        if (row->kind == ROW_HEADING)
            add_text(layout, ROLE_TEXT, row->cells[0], HEADING_TEXT, true, column.low.x, column.high.x, middle);
        else
            place_row(layout, row, column, widths, middle);
        y += row_height(row) * pitch;
    }
}

/* Places the sections below each other, compressed when there are too many rows. */
static void place_list_beside(Layout *layout, const Scene *scene) {
    double height = rows_height(scene, 0, scene->row_count);
    double pitch = fmin(1, (box_height(layout->list) - MARGIN) / height);
    Box column = box_expand(layout->list, -MARGIN);
    column.low.y = layout->list.low.y + MARGIN / 2;
    for (size_t first = 0, end; first < scene->row_count; first = end) {
        end = section_end(scene, first);
        place_section(layout, scene, first, end, column, pitch);
        column.low.y += rows_height(scene, first, end) * pitch;
    }
}

static size_t section_count(const Scene *scene) {
    size_t count = 0;
    for (size_t first = 0; first < scene->row_count; first = section_end(scene, first))
        count++;
    return count;
}

static void place_list_below(Layout *layout, const Scene *scene) {
    double width = box_width(layout->list) / (double)section_count(scene);
    Box column = {{MARGIN, layout->list.low.y + MARGIN / 2}, {width - MARGIN, layout->list.high.y}};
    for (size_t first = 0, end; first < scene->row_count; first = end) {
        end = section_end(scene, first);
        place_section(layout, scene, first, end, column, 1);
        column.low.x += width;
        column.high.x += width;
    }
}

static double list_height_below(const Scene *scene) {
    double highest = 0;
    for (size_t first = 0, end; first < scene->row_count; first = end) {
        end = section_end(scene, first);
        highest = fmax(highest, rows_height(scene, first, end));
    }
    return highest + MARGIN;
}

static double metre_that_fits(const Scene *scene, Box plan) {
    return fmin(box_width(plan) / box_width(scene->box), box_height(plan) / box_height(scene->box));
}

/* Returns the room of the plan when the name stands above and the clock and the scale below it. */
static Box plan_within(const Scene *scene, Box frame) {
    if (scene->bare)
        return box_expand(frame, -BARE_MARGIN);
    return (Box){{frame.low.x + MARGIN, frame.low.y + NOTE_HEIGHT},
                 {frame.high.x - MARGIN, frame.high.y - FOOT_HEIGHT}};
}

/* Returns the height of panels below the plan: the scene's wish, or all the height that a plan of full page width
 * leaves, at most squares. */
static double panels_height(const Scene *scene, Box frame) {
    Box plan = plan_within(scene, frame);
    double left = box_height(plan) - box_width(plan) * box_height(scene->box) / box_width(scene->box);
    return fmax(scene->panel_height, fmin(left, box_width(frame) / scene->panels));
}

/* Divides the page below the band between the plan and the list or panels; true if these go below the plan. */
static bool divide_page(Layout *layout, const Scene *scene) {
    Box frame = {{0, layout->band.high.y}, layout->page};
    layout->frame = frame;
    layout->plan = plan_within(scene, frame);
    layout->list = (Box){layout->page, layout->page};
    if (scene->bare || (!scene->row_count && !scene->panels))
        return false;
    Box left = frame, upper = frame;
    bool panels_below = scene->panels && scene->panel_height > 0;
    left.high.x -= scene->panels ? PANEL_WIDTH : LIST_WIDTH;
    upper.high.y -= panels_below    ? panels_height(scene, frame)
                    : scene->panels ? PANEL_HEIGHT
                                    : list_height_below(scene);
    Box beside = plan_within(scene, left), above = plan_within(scene, upper);
    bool below = panels_below || metre_that_fits(scene, above) > BELOW_GAIN * metre_that_fits(scene, beside);
    layout->frame = below ? upper : left;
    layout->plan = below ? above : beside;
    layout->list = (Box){below ? vec2(0, upper.high.y) : vec2(left.high.x, frame.low.y), layout->page};
    return below;
}

/* Shares the place evenly among the panels: one below the other or, below the plan, side by side. */
static void place_panels(Layout *layout, const Scene *scene, bool below) {
    Box place = box_expand(layout->list, -PANEL_GAP);
    double room = below ? box_width(place) : box_height(place);
    double size = (room - (scene->panels - 1) * PANEL_GAP) / scene->panels;
    for (int i = 0; i < scene->panels; i++) {
        double from = i * (size + PANEL_GAP);
        Box *panel = &layout->panels[i];
        *panel = place;
        if (below)
            panel->high.x = (panel->low.x += from) + size;
        else
            panel->high.y = (panel->low.y += from) + size;
    }
}

static void place_plan(Layout *layout, const Scene *scene) {
    Vec2 middle = vec2_add(vec2_scale(vec2_add(scene->box.low, scene->box.high), 0.5), scene->camera.pan);
    if (scene->camera.kind == VIEW_RAISED) {
        layout->view = view_raised(scene->camera, scene->box, scene->top, layout->plan);
        layout->metre = view_scale(&layout->view, middle, 0);
        return;
    }
    double zoom = scene->camera.zoom > 0 ? scene->camera.zoom : 1;
    layout->metre = zoom * metre_that_fits(scene, layout->plan);
    Vec2 centre = vec2_scale(vec2_add(layout->plan.low, layout->plan.high), 0.5);
    layout->view =
        view_plan(layout->metre, vec2(centre.x - layout->metre * middle.x, centre.y + layout->metre * middle.y));
}

void layout_add_grid_line(Layout *layout, Vec2 from, Vec2 to) {
    layout->grid =
        memory_reserve(layout->grid, &layout->grid_capacity, 2 * (layout->grid_count + 1), sizeof *layout->grid);
    layout->grid[2 * layout->grid_count] = from;
    layout->grid[2 * layout->grid_count + 1] = to;
    layout->grid_count++;
}

/* Cuts a line from `part[0]` to `part[1]`, 0 to 1, to the side where `at` + part x `way` exceeds `low`. */
static void cut_part(double part[2], double at, double way, double low) {
    double meets = (low - at) / way;
    if (way > 0)
        part[0] = fmax(part[0], meets);
    else if (way < 0)
        part[1] = fmin(part[1], meets);
    else if (at < low)
        part[1] = -1;
}

/* Adds the part of a line that lies within the frame. */
static void add_metre_line(Layout *layout, Vec2 from, Vec2 to) {
    Box frame = layout->frame;
    Vec2 at = layout_point(layout, from), way = vec2_sub(layout_point(layout, to), at);
    double part[2] = {0, 1};
    cut_part(part, at.x, way.x, frame.low.x);
    cut_part(part, -at.x, -way.x, -frame.high.x);
    cut_part(part, at.y, way.y, frame.low.y);
    cut_part(part, -at.y, -way.y, -frame.high.y);
    if (part[0] < part[1])
        layout_add_grid_line(layout, vec2_along(at, part[0], way), vec2_along(at, part[1], way));
}

/* Returns the distance between grid lines, m. */
static double grid_step(const Layout *layout, const Scene *scene) {
    return scene->grid * round_step(scene->grid * layout->metre, GRID_CLOSEST);
}

/* Adds lines at whole multiples of the scene's grid: over all of the frame, or over the floor of a raised view. */
static void place_grid(Layout *layout, const Scene *scene) {
    if (scene->grid <= 0)
        return;
    double step = grid_step(layout, scene);
    Box box = scene->box;
    if (!layout->view.raised) {
        const double(*rows)[4] = layout->view.rows;
        box.low = vec2((layout->frame.low.x - rows[0][3]) / layout->metre,
                       (rows[1][3] - layout->frame.high.y) / layout->metre);
        box.high = vec2((layout->frame.high.x - rows[0][3]) / layout->metre,
                        (rows[1][3] - layout->frame.low.y) / layout->metre);
    }
    for (double x = ceil(box.low.x / step) * step; x <= box.high.x; x += step)
        add_metre_line(layout, vec2(x, box.low.y), vec2(x, box.high.y));
    for (double y = ceil(box.low.y / step) * step; y <= box.high.y; y += step)
        add_metre_line(layout, vec2(box.low.x, y), vec2(box.high.x, y));
}

/* True if a label that stands on its point has it in a box of the page, or nearly. */
static bool is_taken(const Layout *layout, const Scene *scene, Box box) {
    for (size_t i = 0; i < scene->count; i++) {
        const Primitive *label = &scene->primitives[i];
        if (label->kind != PRIMITIVE_LABEL || !label->fixed)
            continue;
        Vec2 half = vec2_add(vec2_scale(text_extent(label->text, label->size, label->bold), 0.5), vec2(MARGIN, 0));
        Vec2 at = layout_raised(layout, label->points[0], label->base);
        if (box.low.x < at.x + half.x && at.x - half.x < box.high.x && box.low.y < at.y + half.y &&
            at.y - half.y < box.high.y)
            return true;
    }
    return false;
}

/* Returns the right end on the page of what lies at the height of the scale bar: of a key, or of a plan that reaches
 * down to it; 0: nothing. */
static double end_beside_bar(const Layout *layout, const Scene *scene, double top) {
    if (scene->keyed)
        return layout_point(layout, vec2(scene->key_end, scene->box.low.y)).x;
    Vec2 corner = layout_point(layout, vec2(scene->box.high.x, scene->box.low.y));
    return corner.y > top ? corner.x : 0;
}

/* Returns the length of the scale bar, m: shorter than usual beside a key, or beside a plan if that leaves it long
 * enough to be read. */
static double bar_length(const Layout *layout, const Scene *scene, double top) {
    double usual = round_step(layout->metre, BAR_SHORTEST), length = usual;
    double room = layout->plan.high.x - end_beside_bar(layout, scene, top) - CELL_GAP;
    for (size_t i = sizeof steps / sizeof *steps; i-- > 0 && length * layout->metre > room;)
        if (steps[i] < length)
            length = steps[i];
    bool fits = length * layout->metre <= room && length * layout->metre >= BAR_LEAST;
    return scene->keyed || fits ? length : usual;
}

/* Adds the scale bar at the lower right; a raised view has no single scale and shows the size of the grid's squares
 * instead, there or at the lower left. */
static void place_scale_bar(Layout *layout, const Scene *scene, double foot) {
    double right = layout->plan.high.x, length = bar_length(layout, scene, foot - NAME_TEXT);
    double left = right - length * layout->metre;
    char text[32];
    if (layout->view.raised) {
        if (scene->grid <= 0)
            return;
        snprintf(text, sizeof text, "squares of %g m", grid_step(layout, scene));
        const char *label = arena_text(&layout->arena, text);
        double width = text_extent(label, NAME_TEXT, false).x;
        const double places[] = {right - width, layout->plan.low.x + MARGIN};
        for (size_t i = 0; i < sizeof places / sizeof *places; i++)
            if (!is_taken(layout, scene, (Box){{places[i], foot - NAME_TEXT}, {places[i] + width, foot + NAME_TEXT}})) {
                add_text(layout, ROLE_DIM_TEXT, label, NAME_TEXT, false, places[i], places[i] + width, foot);
                return;
            }
        return;
    }
    double y = foot + 10;
    Sample rim = {{left - BAR_RIM, y}, {right + BAR_RIM, y},    ROLE_PAPER,
                  LINE_SOLID,          BAR_WIDTH + 2 * BAR_RIM, SYMBOL_NONE};
    layout_add_sample(layout, rim);
    layout_add_sample(layout, (Sample){.from = {left, y}, .to = {right, y}, .role = ROLE_TEXT, .width = BAR_WIDTH});
    snprintf(text, sizeof text, "%g m", length);
    Caption *caption =
        caption_add(layout, arena_text(&layout->arena, text), NAME_TEXT, true, vec2((left + right) / 2, foot - 6));
    caption->halo = true;
    caption->fill = ROLE_PAPER;
}

/* Gives the captions from `first` on a rim: a picture seen from near may reach below them. */
static void rim_captions(Layout *layout, size_t first) {
    for (size_t i = first; i < layout->caption_count; i++) {
        layout->captions[i].halo = true;
        layout->captions[i].fill = ROLE_PAPER;
    }
}

static void place_clock(Layout *layout, const Layout *under, const char *clock) {
    size_t first = layout->caption_count;
    if (clock)
        add_text(layout, ROLE_TEXT, clock, CLOCK_TEXT, true, MARGIN, under->plan.high.x,
                 under->plan.high.y + FOOT_HEIGHT / 2);
    rim_captions(layout, first);
}

/* Places the name and the note above the plan, the clock and the scale below. */
static void place_margins(Layout *layout, const Scene *scene) {
    size_t first = layout->caption_count;
    double right = layout->plan.high.x, y = layout->plan.low.y - NOTE_HEIGHT / 2, end = MARGIN;
    if (scene->name)
        end = add_text(layout, ROLE_DIM_TEXT, scene->name, NAME_TEXT, true, MARGIN, right, y);
    if (scene->note && *scene->note)
        add_text(layout, ROLE_DIM_TEXT,
                 caption_of_clauses(layout, scene->note, NAME_TEXT, false, right - end - CELL_GAP), NAME_TEXT, false,
                 end + CELL_GAP, right, y);
    rim_captions(layout, first);
    place_clock(layout, layout, scene->clock);
    if (!scene->unscaled)
        place_scale_bar(layout, scene, layout->plan.high.y + FOOT_HEIGHT / 2);
}

void layout_make(Layout *layout, const Scene *scene, Vec2 page) {
    *layout = (Layout){.page = page, .taken = scene->taken};
    place_band(layout, scene);
    bool below = divide_page(layout, scene);
    place_plan(layout, scene);
    place_grid(layout, scene);
    if (!scene->bare)
        place_margins(layout, scene);
    else if (!scene->unscaled)
        place_scale_bar(layout, scene, layout->plan.high.y - FOOT_HEIGHT / 2);
    if (scene->panels && !scene->bare)
        place_panels(layout, scene, below);
    else if (below)
        place_list_below(layout, scene);
    else if (scene->row_count && !scene->bare)
        place_list_beside(layout, scene);
    labels_place(layout, NULL, scene);
}

void layout_make_over(Layout *layout, const Layout *under, const Scene *scene) {
    layout->page = under->page;
    layout->frame = under->frame;
    layout->plan = under->plan;
    layout->taken = under->taken;
    layout->view = under->view;
    layout->metre = under->metre;
    layout->caption_count = layout->sample_count = 0;
    arena_clear(&layout->arena);
    place_clock(layout, under, scene->clock);
    labels_place(layout, under, scene);
}

void layout_clear(Layout *layout) {
    memory_free(layout->grid);
    memory_free(layout->captions);
    memory_free(layout->samples);
    arena_clear(&layout->arena);
    *layout = (Layout){0};
}
