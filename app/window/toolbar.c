#include "window/toolbar.h"

#include <math.h>

#include "window/act.h"
#include "window/plan_input.h"

#define GAP 6.0 /* design points */
#define HIGHEST 58.0

/* The answer's buttons, design points. */
#define ANSWER_MARGIN 14.0
#define ANSWER_GAP 12.0
#define BUTTON_PAD 20.0
#define SHOW_HEIGHT 38.0
#define WORDS 0.62 /* of the bar's width: the words of an answer keep it before a second button is shown */

static Box box_of(const Frame *frame, size_t tool) {
    size_t columns = (size_t)frame->tool_columns, rows = (EDIT_TOOLS + columns - 1) / columns;
    Box toolbar = box_expand(frame->toolbar, -GAP / 2);
    double width = box_width(toolbar) / (double)columns, height = box_height(toolbar) / (double)rows;
    height = height < HIGHEST ? height : HIGHEST;
    Vec2 low = vec2_add(toolbar.low, vec2((double)(tool / rows) * width, (double)(tool % rows) * height));
    return box_expand((Box){low, vec2_add(low, vec2(width, height))}, -GAP / 2);
}

void toolbar_show(Window *window) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    const Frame *frame = &window->frame;
    if (!editor || box_width(frame->toolbar) <= 0)
        return;
    ui_pane_begin(window->ui, &(UiPane){.name = "rail", .box = frame->toolbar, .ground = ROLE_SHADE});
    EditTool taken = editor_tool(editor);
    for (size_t tool = 0; tool < EDIT_TOOLS; tool++) {
        Action action = ACTION_TOOL_SELECT + (Action)tool;
        const EditToolRow *row = editor_tool_row((EditTool)tool);
        const char *key = keys_row(action).key;
        UiButton button = {.id = row->name,
                           .label = frame->tool_labels ? text_in_arena(&window->arena, "%s\n%s", key, row->name) : key,
                           .help = text_in_arena(&window->arena, "%s (%s): %s", row->name, key, row->help),
                           .chosen = tool == (size_t)taken};
        ui_at(window->ui, box_of(frame, tool));
        if (ui_button(window->ui, &button))
            act_do(window, action, 0, 0);
    }
    ui_pane_end(window->ui);
}

/* The answer's buttons ----------------------------------------------------------------------------------------------
 */

static double width_of(const Window *window, const char *label) {
    return ui_extent(window->ui, UI_BOLD, label).x + BUTTON_PAD;
}

/* Shows a button that ends at `right`; true: it was pressed. */
static bool show_button(Window *window, Box bar, double right, const UiButton *button) {
    double y = (bar.low.y + bar.high.y) / 2, half = fmin(SHOW_HEIGHT, box_height(bar) - 8) / 2;
    ui_at(window->ui, (Box){{right - width_of(window, button->label), y - half}, {right, y + half}});
    return ui_button(window->ui, button);
}

/* Shows a button that goes on to what is missing. */
static double show_cure(Window *window, Tab *tab, Box bar, const Result *answer) {
    Action tool = ACTION_TOOL_SELECT + (Action)answer->tool;
    UiButton button = {.label = answer->cure, .chosen = true, .help = keys_help(&window->arena, tool)};
    double right = bar.high.x - ANSWER_MARGIN;
    if (show_button(window, bar, right, &button))
        act_cure(window, tab, answer);
    return right - width_of(window, button.label) - ANSWER_GAP;
}

/* Shows the button of the first place, and returns where the next one may end. */
static double show_place(Window *window, Tab *tab, Box bar, const Result *answer, double right) {
    UiButton button = {.label = "Show place",
                       .help = answer->last.kind ? "Show place: Select the worst jam and go to its worst time"
                                                 : "Show place: Select the tightest place and go to 2 s before it"};
    double width = width_of(window, button.label);
    if (!tab_first_place(tab) || bar.high.x < 3 * width)
        return right;
    if (show_button(window, bar, right, &button))
        act_show_place(window);
    return right - width - ANSWER_GAP;
}

/* Shows the button of the last person of a crowd where the words have enough room. */
static double show_last(Window *window, Tab *tab, Box bar, const Result *answer, double right) {
    UiButton button = {.label = "Show last", .help = "Show last: Select the last person out and go to 2 s before"};
    double width = width_of(window, button.label);
    if (!answer->last.kind || right - width - ANSWER_GAP < WORDS * bar.high.x)
        return right;
    if (show_button(window, bar, right, &button))
        act_show_last(window, tab, answer);
    return right - width - ANSWER_GAP;
}

double toolbar_show_answer(Window *window, Tab *tab, Box bar, const Result *answer, bool hides) {
    double right = bar.high.x - ANSWER_MARGIN;
    if (answer->cure && tab_editor(tab) && !answer->stale)
        return show_cure(window, tab, bar, answer);
    if (hides || window->frame.compact)
        return right;
    return show_last(window, tab, bar, answer, show_place(window, tab, bar, answer, right));
}
