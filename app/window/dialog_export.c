#include "window/dialog_export.h"

#include <math.h>
#include <string.h>

#include "window/act.h"
#include "window/autosave.h"
#include "window/dialog_pane.h"
#include "window/files.h"
#include "window/lesson.h"
#include "window/notice.h"
#include "window/plan_input.h"

#define WIDTH 760.0 /* design points */
#define HEIGHT 596.0
#define EDGE 16.0

/* A kind of export that the program's own command line makes. */
typedef struct Making {
    const char *label, *meaning;
    const char *options[12]; /* NULL-ended; appended to the command of what is shown */
    const char *name;        /* of the exported folder or file */
    bool movie;
    bool of_houses;
    const char *ending; /* of a single file that is made from the plan alone, or NULL */
} Making;

static const Making makings[] = {
    {.label = "Data",
     .meaning = "summary.json, trace.csv, and the final state as PNG, SVG and PDF",
     .options = {NULL},
     .name = "data"},
    {.label = "Plots",
     .meaning = "Every plot as PNG, SVG, PDF and CSV, with units",
     .options = {"--plots", NULL},
     .name = "plots"},
    {.label = "Report",
     .meaning = "A report as HTML and PDF",
     .options = {"--report", NULL},
     .name = "report",
     .of_houses = true},
    {.label = "Frames",
     .meaning = "30 pictures per simulated second, 1280 x 720",
     .options = {"--frames", "30", NULL},
     .name = "frames"},
    {.label = "Frames, raised",
     .meaning = "30 pictures per simulated second, raised view",
     .options = {"--frames", "30", "--view", "raised", NULL},
     .name = "frames",
     .of_houses = true},
    {.label = "Film",
     .meaning = "film.mp4, 1280 x 720; needs ffmpeg",
     .options = {NULL},
     .name = "film",
     .movie = true},
    {.label = "Film, 1920 x 1080",
     .meaning = "film.mp4, 1920 x 1080; needs ffmpeg",
     .options = {"--size", "1920x1080", NULL},
     .name = "film",
     .movie = true},
    {.label = "Walkable area",
     .meaning = "The free area between walls and furniture, as WKT",
     .options = {"--to", "wkt", NULL},
     .name = "area",
     .of_houses = true,
     .ending = "wkt"},
    {.label = "Plan",
     .meaning = "The plan alone, as SVG",
     .options = {"--to", "svg", NULL},
     .name = "plan",
     .of_houses = true,
     .ending = "svg"},
};
enum { MAKINGS = sizeof makings / sizeof *makings, OPTIONS_MOST = 16 };

static void make(Window *window, const Making *making) {
    static const char *const folders[] = {"", NULL}, *const films[] = {"mp4", NULL};
    Tab *tab = window_tab(window);
    Fault fault = {0};
    const char *options[OPTIONS_MOST];
    size_t count = 0;
    for (size_t i = 0; making->options[i]; i++) {
        options[count++] = making->options[i];
        if (strcmp(making->options[i], "--plots") == 0)
            options[count++] = laboratories[window->current].plots;
    }
    if (!making->ending || strcmp(making->ending, "wkt") != 0) {
        options[count++] = "--theme";
        options[count++] = window->theme == THEME_BOARD ? "board" : "paper";
    }
    if (window->export) {
        notice_post(window, "An export is running already. Cancel it or wait until it ends.");
        return;
    }
    char *folder = notice_folder(window);
    if (!folder)
        return;
    const char *name = text_in_arena(&window->arena, "%s %s", tab->laboratory->title(tab->session), making->name);
    const char *const alone[] = {making->ending, NULL};
    char *free_name = export_free_name(folder, name, making->ending ? alone : making->movie ? films : folders);
    const char *out = making->ending ? text_in_arena(&window->arena, "%s.%s", free_name, making->ending) : free_name;
    const char *movie = making->movie ? text_in_arena(&window->arena, "%s.mp4", out) : NULL;
    ExportOrder order = {.options = options, .option_count = count, .out = making->movie ? NULL : out, .movie = movie};
    order.arguments = autosave_command(window, folder, &order.argument_count);
    const char *const plan[] = {"export", order.arguments[1]};
    if (making->ending) {
        order.arguments = plan;
        order.argument_count = sizeof plan / sizeof *plan;
    }
    window->export = export_begin(&order, &fault);
    if (window->export)
        notice_log(window, "Writing %s", movie ? movie : out);
    notice_fault(window, &fault, NAN);
    memory_free(free_name);
    memory_free(folder);
}

static void show_now(Window *window) {
    UiRow now = {.id = "now",
                 .shape = ROW_PLAIN,
                 .cells = {"The present view as PNG and SVG, with its command line", "F9"},
                 .usable = true};
    if (ui_list_row(window->ui, &now)) {
        dialog_pane_close(window);
        act_do(window, ACTION_PICTURE, 0, 0);
    }
}

void dialog_export_show(Window *window) {
    Tab *tab = window_tab(window);
    dialog_pane_begin(window, dialog_pane_centred(window, WIDTH, HEIGHT, EDGE));
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Export");
    size_t count;
    const char *const *words = tab->session ? tab->laboratory->command(tab->session, &count) : NULL;
    char *command = words ? export_command(words, count) : NULL;
    bool saved = words && (count < 2 || *words[1]);
    ui_text(window->ui, UI_BODY, ROLE_DIM_TEXT,
            saved ? command : "The command line stands here once the house is saved (Ctrl+S).");
    memory_free(command);
    char *place = export_place();
    ui_text(window->ui, UI_BODY, ROLE_TEXT,
            text_in_arena(&window->arena, "Files go to the folder %s; nothing there is overwritten.", place));
    memory_free(place);
    if (ui_button(window->ui,
                  &(UiButton){.label = "Copy command", .help = keys_help(&window->arena, ACTION_COPY_COMMAND)}))
        act_do(window, ACTION_COPY_COMMAND, 0, 0);
    ui_heading(window->ui, "Present view");
    show_now(window);
    ui_heading(window->ui, "Whole run, in the background");
    bool guesses = lesson_hides(window);
    if (guesses)
        ui_text(window->ui, UI_BODY, ROLE_TEXT,
                "The class guesses first: what the run tells can be written once you go on with PgDn.");
    for (size_t i = 0; i < MAKINGS && window->dialog == DIALOG_EXPORT; i++) {
        if ((makings[i].of_houses && !tab_editor(tab)) || (!makings[i].ending && guesses))
            continue;
        const char *label = text_in_arena(&window->arena, "%s: %s", makings[i].label, makings[i].meaning);
        if (ui_list_row(window->ui,
                        &(UiRow){.id = makings[i].label, .shape = ROW_PLAIN, .cells = {label}, .usable = true})) {
            dialog_pane_close(window);
            make(window, &makings[i]);
        }
    }
    ui_pane_end(window->ui);
}

/* Saving ----------------------------------------------------------------------------------------------------------- */

void dialog_export_show_save(Window *window) {
    Box box = dialog_pane_centred(window, WIDTH, HEIGHT, EDGE);
    box.high.y = box.low.y + 250;
    dialog_pane_begin(window, box);
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Save as");
    ui_text(window->ui, UI_BODY, ROLE_DIM_TEXT,
            "The original file stays unchanged. The new file holds the present state.");
    bool typed = ui_field(window->ui, "path", "path of the new file",
                          "Path: Type the path of the new file; Return saves", window->field, sizeof window->field);
    ui_row(window->ui, 2);
    bool pressed = ui_button(window->ui, &(UiButton){.label = "Save", .help = "Save: Write the file"});
    if (ui_button(window->ui, &(UiButton){.label = "Cancel", .help = "Cancel (Escape): Close without saving"}))
        dialog_pane_close(window);
    else if (typed || pressed)
        files_save_as(window, text_in_arena(&window->arena, "%s", window->field));
    ui_pane_end(window->ui);
}
