#include "window/act_plot.h"

#include <math.h>
#include <stdio.h>

#include "window/act.h"
#include "window/files.h"

#define BOX_STEP 0.02    /* of the axes, that a corner moves by a key */
#define CURSOR_STEP 0.01 /* of the axis */
#define TENFOLD 10.0
#define FRAMES_RATE "30"

enum { PLOT_WIDTH = 1280, PLOT_HEIGHT = 720 /* pixels, of a plot's picture */ };

/* Boxes and cursors ------------------------------------------------------------------------------------------------ */

static double clamped(double part) {
    return fmin(fmax(part, 0), 1);
}

static void move_corner(ChartBox *box, Action action, double step) {
    Vec2 *corner = box->corner == 1 ? &box->from : &box->to;
    double x = action == ACTION_PAN_LEFT || action == ACTION_CURSOR_LEFT     ? -step
               : action == ACTION_PAN_RIGHT || action == ACTION_CURSOR_RIGHT ? step
                                                                             : 0;
    double y = action == ACTION_PAN_DOWN ? -step : action == ACTION_PAN_UP ? step : 0;
    *corner = vec2(clamped(corner->x + x), clamped(corner->y + y));
    if (box->corner == 1)
        box->to = box->from;
}

static Vec2 value_at(const Chart *chart, Vec2 part) {
    return plot_canvas_value(chart->canvas, charts_place(plot_canvas_frame(chart->canvas), part));
}

/* From no box to its first corner, its second, and the axes it encloses. */
static void set_corner(Chart *chart) {
    ChartBox *box = &chart->box;
    if (!box->corner)
        *box = (ChartBox){.corner = 1, .from = {0.25, 0.25}, .to = {0.25, 0.25}};
    else if (box->corner == 1)
        *box = (ChartBox){
            .corner = 2, .from = box->from, .to = {clamped(box->from.x + 0.25), clamped(box->from.y + 0.25)}};
    else {
        charts_zoom(chart, value_at(chart, box->from), value_at(chart, box->to));
        box->corner = 0;
    }
}

static void move_cursor(Chart *chart, double direction, double times) {
    if (!chart->live.cursor_parameter)
        return;
    ChartAxes axes = charts_axes(chart);
    double from = isnan(chart->cursor) ? chart->live.cursor : chart->cursor;
    double to = from + direction * times * CURSOR_STEP * (axes.x[1] - axes.x[0]);
    chart->cursor = fmin(fmax(to, axes.x[0]), axes.x[1]);
}

void act_plot_use(Window *window, const Chart *chart, double x) {
    if (chart->live.cursor_parameter)
        act_set(window, chart->live.cursor_parameter, x / chart->live.cursor_factor);
}

static void zoom(Chart *chart, double times) {
    Vec2 low = value_at(chart, vec2(0.5 - 0.5 / times, 0.5 - 0.5 / times));
    Vec2 high = value_at(chart, vec2(0.5 + 0.5 / times, 0.5 + 0.5 / times));
    charts_zoom(chart, low, high);
}

static bool do_chart(Window *window, Chart *chart, Action action, int mods) {
    double step = mods & GLASS_SHIFT ? TENFOLD : 1;
    bool moves = action == ACTION_CURSOR_LEFT || action == ACTION_CURSOR_RIGHT;
    bool pans = action == ACTION_PAN_UP || action == ACTION_PAN_DOWN;
    if (chart->box.corner && (moves || pans)) {
        move_corner(&chart->box, action, step * BOX_STEP);
    } else if (moves) {
        move_cursor(chart, action == ACTION_CURSOR_LEFT ? -1 : 1, step);
    } else if (action == ACTION_BOX || (action == ACTION_USE_CURSOR && chart->box.corner)) {
        set_corner(chart);
    } else if (action == ACTION_USE_CURSOR && !isnan(chart->cursor)) {
        act_plot_use(window, chart, chart->cursor);
        chart->cursor = NAN;
    } else if (action == ACTION_BOX_BACK) {
        charts_zoom_back(chart);
    } else if (action == ACTION_FIT) {
        charts_fit(chart);
    } else if (action == ACTION_ZOOM_IN || action == ACTION_ZOOM_OUT) {
        zoom(chart, action == ACTION_ZOOM_IN ? 1.25 : 0.8);
    } else {
        return false;
    }
    return true;
}

/* Handing on ------------------------------------------------------------------------------------------------------- */

static SnapshotNote note_of(const Room *room) {
    SnapshotNote note = {.shows = room->kind->title(room->live), .time = room->player.time};
    note.command = room->kind->command(room->live, &note.command_count);
    return note;
}

static char *write_view(Room *room, const char *folder, const char *name, Fault *fault) {
    const Scenery *scenery = &room->scenery;
    unsigned char *pixels = memory_zeroed((size_t)scenery->width * (size_t)scenery->height, 4);
    paint_gl_read(scenery->paint, pixels);
    LiveSpan span = room->kind->span(room->live);
    room->kind->show(room->live, span.begin);
    room->kind->show(room->live, room->player.time); /* from the beginning: all that has been added */
    SnapshotView view = {.still = room->kind->still(room->live),
                         .added = room->kind->added(room->live),
                         .moving = room->kind->moving(room->live),
                         .width = scenery->width,
                         .height = scenery->height,
                         .theme = scenery->theme,
                         .pixels = pixels};
    SnapshotNote note = note_of(room);
    bool raised = room->camera.kind == VIEW_RAISED;
    char *path = snapshot_view(&view, raised ? SNAPSHOT_PNG : SNAPSHOT_PNG | SNAPSHOT_SVG, folder, name, &note, fault);
    memory_free(pixels);
    scenery_forget(&room->scenery);
    return path;
}

static void write_picture(Window *window) {
    Room *room = window_room(window);
    Fault fault = {0};
    char *folder = room->scenery.painted ? act_folder(window) : NULL, name[WINDOW_PATH], *path = NULL;
    if (!folder)
        return;
    const Chart *chart = act_focused_chart(window);
    SnapshotNote note = note_of(room);
    snprintf(name, sizeof name, "%s%s%s", room->kind->title(room->live), chart ? " " : "",
             chart ? chart->live.name : "");
    if (chart)
        path = snapshot_plot(&chart->shown, PLOT_WIDTH, PLOT_HEIGHT, window->theme,
                             SNAPSHOT_PNG | SNAPSHOT_SVG | SNAPSHOT_CSV, folder, name, &note, &fault);
    else
        path = write_view(room, folder, name, &fault);
    if (path)
        act_say(window, "written: %s.png%s%s and .json", path,
                !chart && room->camera.kind == VIEW_RAISED ? "" : ", .svg", chart ? ", .csv" : "");
    act_complain(window, &fault, NAN);
    memory_free(path);
    memory_free(folder);
}

/* In a child process, so that the picture goes on. */
static void begin_frames(Window *window) {
    static const char *const options[] = {"--frames", FRAMES_RATE};
    static const char *const endings[] = {"", NULL};
    Room *room = window_room(window);
    char name[WINDOW_PATH];
    if (window->export) {
        act_say(window, "something is being written already: when it is done, or cancelled, the next can begin");
        return;
    }
    char *folder = act_folder(window);
    if (!folder)
        return;
    Fault fault = {0};
    snprintf(name, sizeof name, "%s frames", room->kind->title(room->live));
    char *out = export_free_name(folder, name, endings);
    ExportOrder order = {.options = options, .option_count = sizeof options / sizeof *options, .out = out};
    order.words = files_command(window, &order.word_count);
    window->export = export_begin(&order, &fault);
    if (window->export)
        act_say(window, "writing frames to %s", out);
    act_complain(window, &fault, NAN);
    memory_free(out);
    memory_free(folder);
}

static void copy_command(Window *window) {
    Room *room = window_room(window);
    size_t count;
    const char *const *words = room->kind->command(room->live, &count);
    if (count > 1 && !*words[1]) {
        act_say(window, "no file holds what is shown yet: saved (Ctrl+S) it has a command");
        return;
    }
    char *command = export_command(words, count);
    glass_set_clipboard(window->glass, command);
    act_say(window, "copied: %s", command);
    memory_free(command);
}

bool act_plot_do(Window *window, Action action, int mods) {
    Chart *chart = act_focused_chart(window);
    if (chart && chart->canvas && do_chart(window, chart, action, mods))
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
