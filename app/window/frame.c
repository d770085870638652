#include "window/frame.h"

#include <math.h>

#include "draw/layout.h"

/* Design points. */
#define MENU_HEIGHT 30.0
#define ANSWER_HEIGHT 64.0
#define PRESENT_ANSWER 77.0
#define PRESENT_TALL 103.0
#define TIMELINE_HEIGHT 52.0
#define STRIP_HEIGHT 30.0
#define PANEL_WIDTH 304.0
#define PANEL_WIDE 324.0   /* on pages of at least WIDE_PAGE, */
#define PANEL_WIDEST 340.0 /* of at least WIDEST_PAGE */
#define HANDLE_WIDTH 14.0
#define WIDEST_PAGE 2100.0
#define WIDE_PAGE 1500.0  /* Full HD at its own unit: plots have a place of their own */
#define PRESENT_TEXT 1.45 /* times the size of the text, in presentation mode, */
#define PRESENT_LEAST 0.7
#define PRESENT_WIDTH 800.0 /* which leaves a page of this size if the text is large */
#define PRESENT_HEIGHT 450.0
#define NAMED_WIDTH 600.0 /* a smaller view has no room for the names of a machine's parts */
#define NAMED_HEIGHT 220.0
#define GAP 6.0
#define HEAD_HEIGHT 44.0 /* of the words above each picture of a split view */
#define SPLIT_GAP 2.0

/* The toolbar. */
#define TOOL_WIDTH 78.0
#define TOOL_NARROW 40.0
#define TOOL_HEIGHT 42.0 /* least height of a key above a name; of a key alone */
#define TOOL_LEAST 28.0
#define LABELLED_WIDTH 1000.0 /* least width of a page that shows the tools' names */

/* Smaller pages are laid out compactly. */
#define COMPACT_WIDTH 900.0
#define COMPACT_HEIGHT 470.0
#define DRAWER_WIDTH 1100.0
#define COMPACT_ANSWER 48.0
#define COMPACT_TIMELINE 44.0
#define STRIP_PAGE 295.0 /* least height of a page with a strip */

/* Least size of a plot, and its best shape. */
#define PLOT_WIDTH 230.0
#define PLOT_HEIGHT 112.0
#define PLOT_ASPECT 1.6
#define FIRST_ROW 1.4     /* times the height of the other rows */
#define BESIDE_WIDTH 0.38 /* of the place, for plots to the right of the view */
#define BESIDE_MOST 352.0
#define PRESENT_PLOT 0.4 /* of the place: one plot as high as the view */
#define BELOW_HEIGHT 0.36
#define BELOW_MOST 144.0 /* of a drawer of plots, on pages that are not wide */
#define LESSON_PLOT 0.58 /* of the place, in presentation mode */
#define SAME_SCALE 0.95  /* plots open beside the view if its scale falls by less */
#define WIDE_VIEW 3.0    /* aspect above which a view gets only the height it needs, and the plots the rest */
#define WIDE_LEAST 150.0
#define WIDE_NEEDED 110.0 /* below it the labels of a wide view hide one another: the plots have no room */
#define WIDE_MOST 0.36    /* of the place */

double frame_unit(int width, int height, double density, double text, bool present) {
    double gain = layout_unit(width, height) / density, own = density * sqrt(fmax(gain, 1)) * text;
    double grown = density * PRESENT_TEXT * fmax(gain, PRESENT_LEAST) * text;
    return present ? fmax(own, fmin(grown, fmin(width / PRESENT_WIDTH, height / PRESENT_HEIGHT))) : own;
}

bool frame_hides_names(const Frame *frame, bool plan) {
    bool small = box_width(frame->view) < NAMED_WIDTH || box_height(frame->view) < NAMED_HEIGHT;
    return frame->compact && (plan || small);
}

bool frame_is_wide(Vec2 page) {
    return page.x >= WIDE_PAGE;
}

size_t frame_plots(Vec2 page) {
    enum { PLOTS = 2, PLOTS_WIDE, PLOTS_WIDEST };
    return page.x >= WIDEST_PAGE ? PLOTS_WIDEST : frame_is_wide(page) ? PLOTS_WIDE : PLOTS;
}

static bool is_there(Box box) {
    return box_width(box) > 0 && box_height(box) > 0;
}

/* Returns the number of plots in a row: later rows have one more if the number is uneven. */
static size_t in_row(size_t count, size_t rows, size_t row) {
    return count / rows + (row >= rows - count % rows);
}

/* Returns how far the plots would be from the best shape in that many rows; infinite: too small. */
static double misfit(Box place, size_t count, size_t rows) {
    double width = box_width(place) / (double)in_row(count, rows, rows - 1), height = box_height(place) / (double)rows;
    if (width < PLOT_WIDTH || height < PLOT_HEIGHT)
        return HUGE_VAL;
    return fabs(log(width / height / PLOT_ASPECT));
}

static void place_rows(Frame *frame, Box place, size_t count, size_t rows) {
    bool larger = rows > 1 && in_row(count, rows, 0) < in_row(count, rows, rows - 1);
    double parts = (double)rows + (larger ? FIRST_ROW - 1 : 0), y = place.low.y;
    for (size_t row = 0; row < rows; row++) {
        double height = box_height(place) / parts * (row == 0 && larger ? FIRST_ROW : 1);
        size_t here = in_row(count, rows, row);
        double width = box_width(place) / (double)here;
        for (size_t i = 0; i < here; i++) {
            Box box = {{place.low.x + (double)i * width, y}, {place.low.x + (double)(i + 1) * width, y + height}};
            frame->panes[frame->pane_count++] = box_expand(box, -FRAME_RIM);
        }
        y += height;
    }
}

/* Places as many plots as fit, the first ones first. */
static void place_panes(Frame *frame, Box place, size_t count) {
    for (; count > 0; count--) {
        size_t best = 0;
        double least = HUGE_VAL;
        for (size_t rows = 1; rows <= count; rows++)
            if (misfit(place, count, rows) < least) {
                least = misfit(place, count, rows);
                best = rows;
            }
        if (best) {
            place_rows(frame, place, count, best);
            return;
        }
    }
}

static double scale_of(Box place, double aspect) {
    return fmin(box_width(place) / aspect, box_height(place));
}

/* Divides the place between the view and its plots: to the right or below, whichever leaves the view larger. */
static void divide(Frame *frame, Box place, const FrameWish *wish) {
    size_t count = wish->plot_count < FRAME_PANES_MOST ? wish->plot_count : FRAME_PANES_MOST;
    bool teaches = wish->present && (wish->card > 0 || wish->card_line > 0);
    if (teaches)
        count = count ? 1 : 0; /* one that can be read from the last row */
    frame->view = place;
    if (!wish->plots || !count)
        return;
    Box beside = place, below = place;
    beside.low.x = place.high.x - fmin(BESIDE_WIDTH * box_width(place), BESIDE_MOST);
    bool wide = frame_is_wide(frame->page);
    double height = BELOW_HEIGHT * box_height(place);
    below.low.y = place.high.y - (teaches ? LESSON_PLOT * box_height(place) : wide ? height : fmin(height, BELOW_MOST));
    if (wish->aspect > WIDE_VIEW) {
        double whole = box_width(place) / wish->aspect;
        double share = fmin(fmax(whole, WIDE_LEAST), WIDE_MOST * box_height(place));
        below.low.y = place.low.y + fmax(share, fmin(whole, WIDE_NEEDED));
    }
    if (wish->present && !teaches) {
        beside.low.x = place.high.x - PRESENT_PLOT * box_width(place);
        place_panes(frame, beside, 1);
        if (frame->pane_count)
            frame->view.high.x = beside.low.x;
        return;
    }
    Box left = place, upper = place;
    left.high.x = beside.low.x;
    upper.high.y = below.low.y;
    double scale = scale_of(place, wish->aspect), beside_scale = scale_of(left, wish->aspect);
    bool is_below = wish->aspect > WIDE_VIEW || (!wide && beside_scale < SAME_SCALE * scale);
    place_panes(frame, is_below ? below : beside, count);
    if (!frame->pane_count) {
        is_below = !is_below;
        place_panes(frame, is_below ? below : beside, count);
    }
    if (frame->pane_count)
        frame->view = is_below ? upper : left;
}

/* Returns the width of a toolbar as high as the place. */
static double toolbar_width(Frame *frame, Box place, size_t count) {
    double each = (box_height(place) - GAP) / (double)count;
    frame->tool_labels = frame->page.x >= LABELLED_WIDTH && each >= TOOL_HEIGHT;
    frame->tool_columns = each < TOOL_LEAST ? 2 : 1;
    return (frame->tool_labels ? TOOL_WIDTH : TOOL_NARROW) * frame->tool_columns + 2 * GAP;
}

/* Places the toolbar left of the view, and returns the rest of the place. */
static Box place_toolbar(Frame *frame, Box place, const FrameWish *wish) {
    if (!wish->tool_count || wish->present)
        return place;
    double width = toolbar_width(frame, place, wish->tool_count);
    frame->toolbar = (Box){place.low, {place.low.x + width, place.high.y}};
    place.low.x += width;
    return place;
}

/* Splits the view into two pictures of the same size, each below a line of words. */
static void split(Frame *frame) {
    Box view = frame->view;
    double middle = round((view.low.x + view.high.x) / 2), top = view.low.y + HEAD_HEIGHT;
    frame->heads[0] = (Box){view.low, {middle - SPLIT_GAP / 2, top}};
    frame->heads[1] = (Box){{middle + SPLIT_GAP / 2, view.low.y}, {view.high.x, top}};
    frame->view = (Box){{view.low.x, top}, {frame->heads[0].high.x, view.high.y}};
    frame->beside = (Box){{frame->heads[1].low.x, top}, view.high};
}

Frame frame_make(Vec2 page, const FrameWish *wish) {
    Frame frame = {.page = page};
    frame.compact = page.x < COMPACT_WIDTH || page.y < COMPACT_HEIGHT;
    frame.drawer = page.x < DRAWER_WIDTH;
    double menu = wish->present ? 0 : MENU_HEIGHT;
    double answer = wish->present   ? wish->tall_answer ? PRESENT_TALL : PRESENT_ANSWER
                    : frame.compact ? COMPACT_ANSWER
                                    : ANSWER_HEIGHT;
    double timeline = frame.compact ? COMPACT_TIMELINE : TIMELINE_HEIGHT;
    double strip = wish->present || page.y < STRIP_PAGE ? 0 : STRIP_HEIGHT;
    double width = page.x >= WIDEST_PAGE ? PANEL_WIDEST : frame_is_wide(page) ? PANEL_WIDE : PANEL_WIDTH;
    bool covers = wish->present && wish->card > 0; /* the panel takes the place of the card */
    double panel = !wish->panel || (wish->present && !covers) ? 0 : covers ? wish->card : fmin(width, page.x);
    bool handle = wish->handle && !wish->present && (frame.drawer || !wish->panel);
    if (handle)
        panel = fmin(panel, page.x - HANDLE_WIDTH);
    frame.menu = (Box){{0, 0}, {page.x, menu}};
    frame.answer = (Box){{0, menu}, {page.x, menu + answer}};
    frame.strip = (Box){{0, page.y - strip}, {page.x, page.y}};
    frame.timeline = (Box){{0, frame.strip.low.y - timeline}, {page.x, frame.strip.low.y}};
    Box place = {{0, frame.answer.high.y}, {page.x, frame.timeline.low.y}};
    frame.panel = (Box){{page.x - panel, place.low.y}, place.high};
    if (covers)
        frame.panel = (Box){place.low, {panel, place.high.y}};
    else if (!frame.drawer)
        place.high.x = frame.panel.low.x;
    if (handle) {
        frame.handle = (Box){{frame.panel.low.x - HANDLE_WIDTH, place.low.y}, {frame.panel.low.x, place.high.y}};
        place.high.x = page.x - HANDLE_WIDTH;
    }
    frame.card = (Box){place.low, {place.low.x + (covers && panel > 0 ? 0 : wish->card), place.high.y}};
    place.low.x += wish->card;
    if (wish->card_line > 0) {
        frame.card = (Box){{place.low.x, place.high.y - wish->card_line}, place.high};
        place.high.y = frame.panel.high.y = frame.handle.high.y = frame.card.low.y;
    }
    place = place_toolbar(&frame, place, wish);
    if (is_there(place))
        divide(&frame, place, wish);
    if (wish->hidden_tools && !wish->present && frame_is_wide(page))
        frame.still_from = toolbar_width(&frame, place, wish->hidden_tools);
    if (wish->split)
        split(&frame);
    return frame;
}
