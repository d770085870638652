#include "window/dialog_unit.h"

#include <math.h>
#include <string.h>

#include "base/quantity.h"
#include "window/act.h"
#include "window/dialog_pane.h"
#include "window/notice.h"
#include "window/opening.h"

/* Design points. */
#define WIDTH 700.0
#define HEIGHT 110.0
#define ROW 43.0
#define EDGE 24.0

/* Opens the plan in a unit; true if that succeeded. */
static bool open_in(Window *window, double metres) {
    const char *path = text_in_arena(&window->arena, "%s", window->import_ask.path);
    dialog_pane_close(window);
    return opening_import(window, path, metres);
}

/* Reads the typed width of the plan, and opens the plan in the unit that gives it. */
static void open_by_width(Window *window) {
    char reason[QUANTITY_REASON];
    double width;
    Fault fault = {0};
    if (quantity_read(window->field, "m", &width, reason) && width > 0)
        open_in(window, width / window->import_ask.width);
    else
        fault_add(&fault, "%s: type a length above 0, such as 12.40 m", window->field);
    notice_fault(window, &fault, NAN);
}

void dialog_unit_show(Window *window) {
    const ImportAsk *ask = &window->import_ask;
    const char *slash = strrchr(ask->path, '/');
    dialog_pane_begin(window, dialog_pane_centred(window, WIDTH, HEIGHT + ROW * ((double)ask->count + 2), EDGE));
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "How large is this plan?");
    ui_text(window->ui, UI_BODY, ROLE_TEXT,
            text_in_arena(&window->arena,
                          "Nothing in %s is sure of the unit in which it is drawn. The likeliest size comes first.",
                          slash ? slash + 1 : ask->path));
    for (size_t i = 0; i < ask->count; i++) {
        UiButton button = {.id = text_in_arena(&window->arena, "unit %zu", i),
                           .label = ask->choices[i].text,
                           .chosen = i == 0,
                           .help =
                               text_in_arena(&window->arena, "%s: Import the plan in this size", ask->choices[i].text)};
        if (ui_button(window->ui, &button)) {
            open_in(window, ask->choices[i].metres);
            ui_pane_end(window->ui);
            return;
        }
    }
    bool typed = ui_field(window->ui, "plan width", "or type how wide the whole plan is",
                          "plan width: Return imports the plan in this size", window->field, sizeof window->field);
    if (typed)
        open_by_width(window);
    UiButton measures = {.label = "Measure one length",
                         .help = "Measure one length: Import the plan in the likeliest size, then click two points and "
                                 "type how far apart they really are"};
    if (!typed && ui_button(window->ui, &measures) && open_in(window, ask->choices[0].metres))
        act_set_scale(window);
    ui_pane_end(window->ui);
}
