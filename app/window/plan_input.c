#include "window/plan_input.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "window/notice.h"

#define REACH 10.0 /* design points: items within this distance are hit */

#define ZOOM_OUT 1.25
#define PAN_LEAST 4.0 /* design points: a shorter way of the mouse is a click */

/* m; degrees. */
#define NUDGE 0.01
#define NUDGE_FAR 0.1
#define NUDGE_LITTLE 0.001
#define TURN 15.0
#define TURN_LITTLE 1.0

/* True if a handle has the keyboard focus: then Enter or a number grabs it. */
static bool has_handle(const GestureView *gesture) {
    bool held = false;
    for (size_t i = 0; i < gesture->mark_count; i++)
        held |= gesture->marks[i].kind == MARK_HANDLE && gesture->marks[i].active;
    return held;
}

bool plan_input_listens(const Window *window) {
    const Tab *tab = &window->tabs[window->current];
    Editor *editor = tab_editor(tab);
    if (!editor || editor_tool(editor) != TOOL_SELECT)
        return editor;
    const GestureView *gesture = editor_gesture(editor);
    return gesture->active || has_handle(gesture);
}

/* The pointer ------------------------------------------------------------------------------------------------------ */

static Vec2 floor_at(const Window *window, const Tab *tab, Vec2 at) {
    return view_layers_floor(&tab->view_layers, vec2_sub(at, window->frame.view.low));
}

/* Returns the pointer at a point of the window. */
static Pointer pointer_at(const Window *window, const Tab *tab, Vec2 at) {
    int mods = sdl_window_mods(window->sdl_window);
    Vec2 floor = floor_at(window, tab, at);
    return (Pointer){.at = floor,
                     .reach = vec2_distance(floor, floor_at(window, tab, vec2_add(at, vec2(REACH, 0)))),
                     .free = window->plan_input.free || mods & SDL_WINDOW_EVENT_CONTROL,
                     .straight = mods & SDL_WINDOW_EVENT_SHIFT,
                     .more = mods & SDL_WINDOW_EVENT_SHIFT};
}

static bool same_pointer(const Pointer *a, const Pointer *b) {
    return a->at.x == b->at.x && a->at.y == b->at.y && a->reach == b->reach && a->free == b->free &&
           a->straight == b->straight && a->nowhere == b->nowhere;
}

/* Sends the pointer to the editor, unless it has not changed. */
static void send_pointer(Window *window, Tab *tab, const Pointer *pointer) {
    if (window->plan_input.pointer_known && same_pointer(&window->plan_input.pointer, pointer))
        return;
    window->plan_input.pointer = *pointer;
    window->plan_input.pointer_known = true;
    editor_point(tab_editor(tab), pointer);
    window->dirty = true;
}

/* Sends the present pointer, or the middle of the view if the pointer is elsewhere. */
static void send_pointer_now(Window *window, Tab *tab) {
    Vec2 at = vec2_scale(window->mouse, 1 / window->unit);
    Box view = window->frame.view;
    if (!tab->view_layers.painted)
        return;
    bool nowhere = !box_holds(view, at);
    if (nowhere)
        at = vec2_scale(vec2_add(view.low, view.high), 0.5);
    Pointer pointer = pointer_at(window, tab, at);
    pointer.nowhere = nowhere;
    send_pointer(window, tab, &pointer);
}

void plan_input_look_at(Window *window, Tab *tab, Vec2 at) {
    tab_look_at(tab, at);
    if (box_holds(window->frame.view, vec2_scale(window->mouse, 1 / window->unit)))
        return;
    Pointer pointer = window->plan_input.pointer;
    pointer.at = at;
    pointer.nowhere = true;
    send_pointer(window, tab, &pointer);
}

static void say_fixed(Window *window, const char *fixed) {
    notice_post(window, "%s are fixed while watching: Edit plan (W)", fixed);
}

/* Moves the view while the left button is held that was pressed on the floor, unless the plan is edited. If it has not
 * moved the view, the editor sees a click when it is released. Returns false if the mouse does something else. */
static bool pan(Window *window, Tab *tab, const UiGrab *grab) {
    PlanInput *input = &window->plan_input;
    Editor *editor = tab_editor(tab);
    Vec2 at = floor_at(window, tab, grab->at);
    if (grab->pressed) {
        bool selects = editor_tool(editor) == TOOL_SELECT && !editor_gesture(editor)->active;
        Item under = tab->laboratory->pick(tab->session, at, tab_time(tab), (Item){0});
        input->pans = !window->editing && selects && !under.kind;
        input->panned = false;
        input->pressed_at = grab->at;
        input->twice = grab->twice;
    }
    if (!input->pans || !(grab->held || grab->released))
        return false;
    ui_focus(window->ui, "view");
    if (input->panned || vec2_distance(grab->at, input->pressed_at) > PAN_LEAST) {
        Vec2 from = input->panned ? vec2_sub(grab->at, grab->delta) : input->pressed_at;
        tab_pan(tab, vec2_sub(floor_at(window, tab, from), at));
        input->panned = window->dirty = true;
    }
    if (grab->released && !input->panned) {
        Pointer pointer = pointer_at(window, tab, grab->at);
        editor_press(editor, &pointer, input->twice);
    }
    input->pans = !grab->released;
    return input->pans || input->panned;
}

void plan_input_mouse(Window *window, const UiGrab *grab) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    editor_fix(editor, !window->editing);
    if ((!grab->hovered && !grab->held && !grab->released) || pan(window, tab, grab))
        return;
    Pointer pointer = pointer_at(window, tab, grab->at);
    send_pointer(window, tab, &pointer);
    if (grab->pressed) {
        ui_focus(window->ui, "view");
        editor_press(editor, &pointer, grab->twice);
    }
    if (grab->released)
        editor_release(editor, &pointer);
    window->dirty |= grab->pressed || grab->released;
    const char *fixed = editor_fixed_dragged(editor);
    if (!fixed == !window->plan_input.refused)
        return;
    window->plan_input.refused = fixed;
    sdl_window_refuse(window->sdl_window, fixed);
    if (fixed)
        say_fixed(window, fixed);
}

/* Keys ------------------------------------------------------------------------------------------------------------- */

/* Cancels the gesture, then the tool. */
static bool escape(Editor *editor) {
    if (editor_escape(editor))
        return true;
    bool tool = editor_tool(editor) != TOOL_SELECT;
    if (tool)
        editor_set_tool(editor, TOOL_SELECT);
    return tool;
}

/* Zooms out until all marks of the gesture are in the view: places that are typed may lie beyond it. */
static void keep_in_view(Window *window, Tab *tab) {
    enum { STEPS = 40 };
    const GestureView *gesture = editor_gesture(tab_editor(tab));
    Box view = window->frame.view;
    Vec2 middle = floor_at(window, tab, vec2_scale(vec2_add(view.low, view.high), 0.5));
    for (int step = 0; step < STEPS && tab->view_layers.painted; step++) {
        bool inside = true;
        for (size_t i = 0; i < gesture->mark_count; i++)
            for (size_t p = 0; p < gesture->marks[i].count; p++) {
                Vec2 at = vec2_scale(vec2_sub(gesture->marks[i].points[p], middle), pow(ZOOM_OUT, -step));
                at = vec2_add(view.low, view_layers_point(&tab->view_layers, vec2_add(middle, at)));
                inside &= box_holds(box_expand(view, -REACH), at);
            }
        if (!inside)
            continue;
        if (step)
            tab_zoom(tab, pow(ZOOM_OUT, -step), middle);
        return;
    }
}

/* Uses the chosen proposal by Return, or drops all by Escape. */
static bool decide_proposals(Window *window, Editor *editor, int32_t key) {
    size_t count, chosen;
    const char *doing;
    Fault fault = {0};
    bool enter = key == sdl_window_key("Return"), asked = editor_proposals(editor, &count, &doing) || doing;
    if (editor_tool(editor) != TOOL_SELECT || editor_gesture(editor)->active || !asked)
        return false;
    if (key == sdl_window_key("Escape"))
        return editor_drop_proposals(editor);
    if (!enter || !count)
        return false;
    editor_chosen_proposal(editor, &chosen);
    editor_accept(editor, chosen, &fault);
    notice_fault(window, &fault, NAN);
    return true;
}

bool plan_input_key(Window *window, const SdlWindowEvent *event) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    int32_t key = event->key;
    if (editor && !event->mods && decide_proposals(window, editor, key))
        return true;
    if (!plan_input_listens(window) || event->mods & (SDL_WINDOW_EVENT_CONTROL | SDL_WINDOW_EVENT_ALT))
        return false;
    send_pointer_now(window, tab);
    if (key == sdl_window_key("Return") || key == sdl_window_key("Keypad Enter"))
        return editor_enter(editor) && (keep_in_view(window, tab), true);
    if (key == sdl_window_key("Backspace"))
        return editor_back(editor);
    if (key == sdl_window_key("Tab"))
        return editor_tab(editor, event->mods & SDL_WINDOW_EVENT_SHIFT ? -1 : 1);
    return key == sdl_window_key("Escape") && escape(editor);
}

static bool types_something(const SdlWindowEvent *event) {
    static const char *const pad[] = {"Keypad 0", "Keypad 1", "Keypad 2", "Keypad 3", "Keypad 4", "Keypad 5",
                                      "Keypad 6", "Keypad 7", "Keypad 8", "Keypad 9", "Keypad .", "Keypad -"};
    for (size_t i = 0; i < sizeof pad / sizeof *pad; i++)
        if (event->key == sdl_window_key(pad[i]))
            return true;
    return event->key >= ' ' && event->key < 0x7f;
}

bool plan_input_store_key(Window *window, const SdlWindowEvent *event) {
    if (!plan_input_listens(window) || event->mods & (SDL_WINDOW_EVENT_CONTROL | SDL_WINDOW_EVENT_ALT) ||
        !types_something(event))
        return false;
    window->plan_input.key = *event;
    window->plan_input.waits = true;
    return true;
}

bool plan_input_apply_text(Window *window, const char *text) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    const char own[] = {(char)window->plan_input.key.key, 0};
    window->plan_input.waits = false;
    if (!text && window->plan_input.key.key < 0x7f && !window->plan_input.key.mods)
        text = own;
    return text && editor && *text != ' ' && editor_type(editor, text);
}

bool plan_input_type(Window *window, const char *text) {
    Tab *tab = window_tab(window);
    bool used = plan_input_listens(window);
    for (const char *at = text; used && *at; at++)
        used = editor_type(tab_editor(tab), (const char[]){*at, 0});
    return used;
}

/* Actions ---------------------------------------------------------------------------------------------------------- */

static bool is_selected(const Tab *tab) {
    size_t count;
    return editor_selection(tab_editor(tab), &count) && count > 0;
}

/* Posts why an action failed, or that nothing suitable is selected. */
static void report_result(Window *window, bool done, const char *what, Fault *fault) {
    if (!done && !fault->count)
        notice_post(window, "%s: nothing suitable is selected", what);
    notice_fault(window, fault, NAN);
}

static void copy(Window *window, Editor *editor) {
    char *text = editor_copy(editor);
    if (!text)
        return;
    sdl_window_set_clipboard(window->sdl_window, text);
    notice_post(window, "Copied");
    memory_free(text);
}

static bool do_clipboard(Window *window, Tab *tab, Action action) {
    Editor *editor = tab_editor(tab);
    Fault fault = {0};
    switch (action) {
    case ACTION_COPY:
        if (is_selected(tab))
            copy(window, editor);
        return is_selected(tab);
    case ACTION_CUT:
        copy(window, editor);
        report_result(window, editor_remove(editor, &fault), "Cut", &fault);
        return true;
    case ACTION_PASTE:
        send_pointer_now(window, tab);
        if (!editor_paste(editor, sdl_window_clipboard(window->sdl_window), &fault) && !fault.count)
            notice_post(window, "The clipboard has nothing that can be pasted here.");
        notice_fault(window, &fault, NAN);
        return true;
    default:
        return false;
    }
}

/* Does an action on the whole selection; false: it is another action. */
static bool do_pieces(Window *window, Tab *tab, Action action) {
    static const struct {
        Action action;
        bool (*done)(Editor *editor, Fault *fault);
    } known[] = {{ACTION_DELETE, editor_remove},
                 {ACTION_DUPLICATE, editor_duplicate},
                 {ACTION_SPLIT, editor_split},
                 {ACTION_TOPPLE, editor_topple},
                 {ACTION_SHAKE, editor_shake}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        if (known[i].action != action)
            continue;
        Fault fault = {0};
        send_pointer_now(window, tab);
        bool good = known[i].done(tab_editor(tab), &fault);
        report_result(window, good, keys_row(action).name, &fault);
        if (good && action == ACTION_SHAKE)
            notice_post(window, "%s", editor_shake_result(tab_editor(tab)));
        return true;
    }
    return false;
}

/* Returns false if nothing is selected; the action then concerns the view. */
static bool nudge(Window *window, Tab *tab, Action action, int mods) {
    static const Vec2 ways[] = {{-1, 0}, {1, 0}, {0, 1}, {0, -1}};
    size_t way = (size_t)(action - ACTION_NUDGE_LEFT);
    double far = mods & SDL_WINDOW_EVENT_CONTROL ? NUDGE_LITTLE : mods & SDL_WINDOW_EVENT_SHIFT ? NUDGE_FAR : NUDGE;
    Fault fault = {0};
    if (editor_move_gesture(tab_editor(tab), vec2_scale(ways[way], far))) {
        keep_in_view(window, tab);
        return true;
    }
    if (!is_selected(tab))
        return false;
    const char *fixed = editor_fixed_selected(tab_editor(tab));
    if (fixed)
        say_fixed(window, fixed);
    else
        report_result(window, editor_nudge(tab_editor(tab), vec2_scale(ways[way], far), &fault), "Nudge", &fault);
    return true;
}

/* Returns false if nothing is selected; the action then concerns the view. */
static bool turn(Window *window, Tab *tab, double degrees) {
    Fault fault = {0};
    if (!is_selected(tab))
        return fabs(degrees) < TURN;
    report_result(window, editor_turn(tab_editor(tab), degrees, &fault), "Turn", &fault);
    return true;
}

static void step(Window *window, Tab *tab, Action action) {
    Editor *editor = tab_editor(tab);
    bool undoes = action == ACTION_UNDO;
    const char *name = undoes ? editor_undo_name(editor) : editor_redo_name(editor);
    name = text_in_arena(&window->arena, "%s", name ? name : "");
    bool done = undoes ? editor_undo(editor) : editor_redo(editor);
    if (done)
        notice_post(window, undoes ? "Undone: %s" : "Redone: %s", name);
    else
        notice_post(window, undoes ? "There is nothing to undo." : "There is nothing to redo.");
}

static void toggle_snapping(Window *window) {
    window->plan_input.free = !window->plan_input.free;
    notice_post(window, window->plan_input.free ? "Snapping: off" : "Snapping: on");
}

static bool do_selection(Window *window, Tab *tab, Action action, int mods) {
    Editor *editor = tab_editor(tab);
    switch (action) {
    case ACTION_UNDO:
    case ACTION_REDO:
        step(window, tab, action);
        return true;
    case ACTION_SELECT_ALL:
        editor_select_all(editor);
        return true;
    case ACTION_SNAP:
        toggle_snapping(window);
        return true;
    case ACTION_HANDLE:
    case ACTION_HANDLE_BACK:
        editor_focus_handle(editor, action == ACTION_HANDLE ? 1 : -1);
        return true;
    case ACTION_NUDGE_LEFT:
    case ACTION_NUDGE_RIGHT:
    case ACTION_NUDGE_UP:
    case ACTION_NUDGE_DOWN:
        return nudge(window, tab, action, mods);
    case ACTION_TURN_LEFT:
    case ACTION_TURN_RIGHT:
        return turn(window, tab, action == ACTION_TURN_LEFT ? TURN : -TURN);
    case ACTION_TURN_LITTLE_LEFT:
    case ACTION_TURN_LITTLE_RIGHT:
        return turn(window, tab, action == ACTION_TURN_LITTLE_LEFT ? TURN_LITTLE : -TURN_LITTLE);
    default:
        return false;
    }
}

bool plan_input_do(Window *window, Action action, int mods) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    if (!editor)
        return false;
    editor_fix(editor, !window->editing);
    if (action >= ACTION_TOOL_SELECT && action <= ACTION_TOOL_IMAGE) {
        editor_set_tool(editor, (EditTool)(action - ACTION_TOOL_SELECT));
        window->editing |= action != ACTION_TOOL_SELECT;
        bool asks = action == ACTION_TOOL_IMAGE && !editor_image(editor).path;
        window->panel |= asks;
        window->drawer |= asks;
        ui_focus(window->ui, asks ? "panel" : "view");
        return true;
    }
    return do_clipboard(window, tab, action) || do_pieces(window, tab, action) ||
           do_selection(window, tab, action, mods);
}

const char *plan_input_step_label(Window *window, Action action) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    bool undoes = action == ACTION_UNDO;
    const char *name = !editor ? NULL : undoes ? editor_undo_name(editor) : editor_redo_name(editor);
    if (!name)
        return undoes ? "Can't undo" : "Can't redo";
    return text_in_arena(&window->arena, "%s: %s", undoes ? "Undo" : "Redo", name);
}

/* The clock -------------------------------------------------------------------------------------------------------- */

void plan_input_hold_number(Window *window, const char *name) {
    Tab *tab = window_tab(window);
    if (!tab->session || !tab->laboratory->begin_number || window->plan_input.number)
        return;
    window->plan_input.number = true;
    tab->laboratory->begin_number(tab->session, name);
}

void plan_input_hold_clock(Window *window) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    PlanInput *input = &window->plan_input;
    if (!editor)
        return;
    if (input->number && !window->input.down[SDL_WINDOW_EVENT_LEFT]) {
        input->number = false;
        tab->laboratory->end_number(tab->session);
    }
    bool hold = input->number || editor_gesture(editor)->active;
    if (hold && !input->holds)
        input->plays_on = tab->player.playing;
    if (hold)
        tab->player.playing = false;
    else if (input->holds)
        tab->player.playing = input->plays_on;
    input->holds = hold;
}

/* Animation -------------------------------------------------------------------------------------------------------- */

void plan_input_animate(Window *window, double seconds) {
    const Tab *tab = window_tab(window);
    bool unseen = window->options->script && !sdl_window_is_seen(window->sdl_window);
    if (!tab->session || !tab->laboratory->animate || window->reduced)
        return;
    window->dirty |= tab->laboratory->animation(tab->session) != NULL; /* it may end now */
    tab->laboratory->animate(tab->session, unseen ? 1 / FRAME_TIMER_RATE : seconds);
}

const char *plan_input_animation(const Tab *tab) {
    return tab->session && tab->laboratory->animation ? tab->laboratory->animation(tab->session) : NULL;
}

void plan_input_reset(Window *window) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    if (!editor)
        return;
    if (window->plan_input.number)
        tab->laboratory->end_number(tab->session);
    editor_set_tool(editor, TOOL_SELECT);
    if (window->plan_input.holds)
        tab->player.playing = window->plan_input.plays_on;
    window->plan_input = (PlanInput){.free = window->plan_input.free};
}
