#include "window/act_plot.h"

#include <math.h>
#include <stdio.h>

#include "window/autosave.h"
#include "window/lesson.h"
#include "window/notice.h"

#define BOX_STEP 0.02    /* of the axes: how far a key moves a corner */
#define CURSOR_STEP 0.01 /* of the axis */
#define TENFOLD 10.0
#define FRAMES_RATE "30"

enum { PLOT_WIDTH = 1280, PLOT_HEIGHT = 720 /* pixels, of a plot's picture */ };

/* Boxes and cursors ------------------------------------------------------------------------------------------------ */

static double clamped(double part) {
    return fmin(fmax(part, 0), 1);
}

static void move_corner(PlotPaneBox *box, Action action, double step) {
    Vec2 *corner = box->corner == 1 ? &box->from : &box->to;
    double x = action == ACTION_PAN_LEFT || action == ACTION_CURSOR_LEFT     ? -step
               : action == ACTION_PAN_RIGHT || action == ACTION_CURSOR_RIGHT ? step
                                                                             : 0;
    double y = action == ACTION_PAN_DOWN ? -step : action == ACTION_PAN_UP ? step : 0;
    *corner = vec2(clamped(corner->x + x), clamped(corner->y + y));
    if (box->corner == 1)
        box->to = box->from;
}

static Vec2 value_at(const PlotPane *pane, Vec2 part) {
    return plot_canvas_value(pane->canvas, plot_panes_place(plot_canvas_frame(pane->canvas), part));
}

/* Begins a box, goes to its second corner, or zooms to it. */
static void set_corner(PlotPane *pane) {
    PlotPaneBox *box = &pane->box;
    if (!box->corner)
        *box = (PlotPaneBox){.corner = 1, .from = {0.25, 0.25}, .to = {0.25, 0.25}};
    else if (box->corner == 1)
        *box = (PlotPaneBox){
            .corner = 2, .from = box->from, .to = {clamped(box->from.x + 0.25), clamped(box->from.y + 0.25)}};
    else {
        plot_panes_zoom(pane, value_at(pane, box->from), value_at(pane, box->to));
        box->corner = 0;
    }
}

void act_plot_use(Window *window, const PlotPane *pane, Vec2 value) {
    const LaboratoryPlot source = pane->source;
    Fault fault = {0};
    if (source.cursor_parameter && !isnan(value.x))
        tab_set(window_tab(window), source.cursor_parameter, value.x / source.cursor_factor, &fault);
    if (source.cursor_y_parameter && !isnan(value.y))
        tab_set(window_tab(window), source.cursor_y_parameter, value.y / source.cursor_y_factor, &fault);
    notice_fault(window, &fault, NAN);
}

/* Moves the line of a diagram, and with it the number that it stands for. */
static void move_cursor(Window *window, PlotPane *pane, double direction, double times) {
    if (!pane->source.cursor_parameter || isnan(pane->source.cursor))
        return;
    PlotPaneAxes axes = plot_panes_axes(pane);
    double to = pane->source.cursor + direction * times * CURSOR_STEP * (axes.x[1] - axes.x[0]);
    pane->source.cursor = fmin(fmax(to, axes.x[0]), axes.x[1]); /* also for a second key in the same frame */
    act_plot_use(window, pane, vec2(pane->source.cursor, NAN));
}

/* Moves the level line of a plot over two parameters, and with it the second number. */
static void move_cursor_y(Window *window, PlotPane *pane, double direction, double times) {
    if (isnan(pane->source.cursor_y))
        return;
    PlotPaneAxes axes = plot_panes_axes(pane);
    double to = pane->source.cursor_y + direction * times * CURSOR_STEP * (axes.y[1] - axes.y[0]);
    pane->source.cursor_y = fmin(fmax(to, axes.y[0]), axes.y[1]);
    act_plot_use(window, pane, vec2(NAN, pane->source.cursor_y));
}

static void zoom(PlotPane *pane, double times) {
    Vec2 low = value_at(pane, vec2(0.5 - 0.5 / times, 0.5 - 0.5 / times));
    Vec2 high = value_at(pane, vec2(0.5 + 0.5 / times, 0.5 + 0.5 / times));
    plot_panes_zoom(pane, low, high);
}

static bool do_pane(Window *window, PlotPane *pane, Action action, int mods) {
    double step = mods & SDL_WINDOW_EVENT_SHIFT ? TENFOLD : 1;
    bool moves = action == ACTION_CURSOR_LEFT || action == ACTION_CURSOR_RIGHT;
    bool pans = action == ACTION_PAN_UP || action == ACTION_PAN_DOWN;
    if (pane->box.corner && (moves || pans)) {
        move_corner(&pane->box, action, step * BOX_STEP);
    } else if (moves) {
        move_cursor(window, pane, action == ACTION_CURSOR_LEFT ? -1 : 1, step);
    } else if (pans && pane->source.cursor_y_parameter) {
        move_cursor_y(window, pane, action == ACTION_PAN_DOWN ? -1 : 1, step);
    } else if (action == ACTION_BOX || (action == ACTION_USE_CURSOR && pane->box.corner)) {
        set_corner(pane);
    } else if (action == ACTION_BOX_BACK) {
        plot_panes_zoom_back(pane);
    } else if (action == ACTION_FIT) {
        plot_panes_fit(pane);
    } else if (action == ACTION_ZOOM_IN || action == ACTION_ZOOM_OUT) {
        zoom(pane, action == ACTION_ZOOM_IN ? 1.25 : 0.8);
    } else {
        return false;
    }
    return true;
}

/* Exports ---------------------------------------------------------------------------------------------------------- */

/* Returns the command that produces what is shown, or NULL if no file holds it yet. */
static const char *const *command_of(const Tab *tab, size_t *count) {
    const char *const *words = tab->laboratory->command(tab->session, count);
    return *count > 1 && !*words[1] ? NULL : words;
}

static SnapshotNote note_of(const Tab *tab) {
    SnapshotNote note = {.shows = tab->laboratory->title(tab->session), .time = tab->player.time};
    note.command = command_of(tab, &note.command_count);
    note.command_count = note.command ? note.command_count : 0;
    return note;
}

static char *write_view(Tab *tab, const char *folder, const char *name, Fault *fault) {
    const ViewLayers *view_layers = &tab->view_layers;
    unsigned char *pixels = memory_zeroed((size_t)view_layers->width * (size_t)view_layers->height, 4);
    paint_gl_read(view_layers->paint, pixels);
    RecordSpan span = tab_span(tab);
    tab->laboratory->show(tab->session, span.begin);
    tab->laboratory->show(tab->session, tab->player.time); /* from the beginning, so that `added` holds everything */
    SnapshotView view = {.still = tab->laboratory->still(tab->session),
                         .added = tab->laboratory->added(tab->session),
                         .moving = tab->laboratory->moving(tab->session),
                         .width = view_layers->width,
                         .height = view_layers->height,
                         .theme = view_layers->theme,
                         .pixels = pixels};
    SnapshotNote note = note_of(tab);
    bool raised = tab->camera.kind == VIEW_RAISED;
    char *path = snapshot_view(&view, raised ? SNAPSHOT_PNG : SNAPSHOT_PNG | SNAPSHOT_SVG, folder, name, &note, fault);
    memory_free(pixels);
    view_layers_invalidate(&tab->view_layers);
    return path;
}

static void write_picture(Window *window) {
    Tab *tab = window_tab(window);
    Fault fault = {0};
    char *folder = tab->view_layers.painted ? notice_folder(window) : NULL, name[WINDOW_PATH], source[2 * WINDOW_TITLE],
         *path = NULL;
    if (!folder)
        return;
    const PlotPane *pane = plot_panes_focused(&window_tab(window)->panes, window->ui);
    SnapshotNote note = note_of(tab);
    snprintf(name, sizeof name, "%s%s%s", tab->laboratory->title(tab->session), pane ? " " : "",
             pane ? pane->source.name : "");
    if (pane) {
        const char *remark = tab->laboratory->note(tab->session);
        snprintf(source, sizeof source, "%s%s%s", tab->laboratory->title(tab->session), *remark ? ": " : "", remark);
        path = snapshot_plot(&pane->shown, &(PlotSheet){PLOT_WIDTH, PLOT_HEIGHT, window->theme, source},
                             SNAPSHOT_PNG | SNAPSHOT_SVG | SNAPSHOT_CSV, folder, name, &note, &fault);
    } else
        path = write_view(tab, folder, name, &fault);
    if (path)
        notice_post(window, "Written: %s.png%s%s and .json", path,
                    !pane && tab->camera.kind == VIEW_RAISED ? "" : ", .svg", pane ? ", .csv" : "");
    notice_fault(window, &fault, NAN);
    memory_free(path);
    memory_free(folder);
}

/* Writes frames in a child process, so that the view goes on. */
static void begin_frames(Window *window) {
    static const char *const options[] = {"--frames", FRAMES_RATE};
    static const char *const endings[] = {"", NULL};
    Tab *tab = window_tab(window);
    char name[WINDOW_PATH];
    if (window->export) {
        notice_post(window, "An export is running already. Cancel it or wait until it ends.");
        return;
    }
    char *folder = notice_folder(window);
    if (!folder)
        return;
    Fault fault = {0};
    snprintf(name, sizeof name, "%s frames", tab->laboratory->title(tab->session));
    char *out = export_free_name(folder, name, endings);
    ExportOrder order = {.options = options, .option_count = sizeof options / sizeof *options, .out = out};
    order.arguments = autosave_command(window, folder, &order.argument_count);
    window->export = export_begin(&order, &fault);
    if (window->export)
        notice_log(window, "Writing frames to %s", out);
    notice_fault(window, &fault, NAN);
    memory_free(out);
    memory_free(folder);
}

static void copy_command(Window *window) {
    Tab *tab = window_tab(window);
    size_t count;
    const char *const *words = command_of(tab, &count);
    if (!words) {
        notice_post(window, "Save the house first (Ctrl+S): the command line needs a file.");
        return;
    }
    char *command = export_command(words, count);
    sdl_window_set_clipboard(window->sdl_window, command);
    notice_post(window, "Copied: %s", command);
    memory_free(command);
}

bool act_plot_do(Window *window, Action action, int mods) {
    PlotPane *pane = plot_panes_focused(&window_tab(window)->panes, window->ui);
    if (pane && pane->canvas && do_pane(window, pane, action, mods))
        return true;
    switch (action) {
    case ACTION_PICTURE:
        write_picture(window);
        return true;
    case ACTION_FRAMES:
        begin_frames(window);
        return true;
    case ACTION_COPY_COMMAND:
        copy_command(window);
        return true;
    default:
        return false;
    }
}

void act_plot_toggle(Window *window) {
    bool seen = window->frame.pane_count > 0;
    window->plots = seen ? PLOTS_CLOSED : PLOTS_OPEN;
    window->plots_asked = !seen;
}

void act_plot_explain(Window *window) {
    const Tab *tab = window_tab(window);
    bool asked = window->plots_asked;
    window->plots_asked = false;
    if (!asked || window->frame.pane_count || !tab->session)
        return;
    if (lesson_hides(window))
        notice_post(window, "The class guesses first: the plots come with the next step (PgDn)");
    else if (tab->trial.session)
        notice_post(window, "Plots are hidden beside a suggested fix: Esc leaves it");
    else if (!tab->panes.count)
        notice_post(window, "There is nothing to plot");
    else
        notice_post(window, window->text > 1 ? "No room for plots: make the window larger, or the text smaller (Ctrl+-)"
                                             : "No room for plots: make the window larger");
}
