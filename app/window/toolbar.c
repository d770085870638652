#include "window/toolbar.h"

#include "window/act.h"
#include "window/plan_input.h"

#define GAP 6.0 /* design points */
#define HIGHEST 58.0

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
