#include "window/edit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "window/act.h"

#define REACH 10.0 /* design points: what is nearer than this is meant */

/* m; degrees. */
#define NUDGE 0.01
#define NUDGE_FAR 0.1
#define NUDGE_LITTLE 0.001
#define TURN 15.0
#define TURN_LITTLE 1.0

const LiveEditor *edit_of(const Room *room) {
    return room->live ? room->kind->editor : NULL;
}

/* Has a handle the focus of the keys? Then Enter, or a number, takes it up. */
static bool has_handle(const LiveGesture *gesture) {
    bool held = false;
    for (size_t i = 0; i < gesture->mark_count; i++)
        held |= gesture->marks[i].kind == MARK_HANDLE && gesture->marks[i].held;
    return held;
}

bool edit_listens(const Window *window) {
    const Room *room = &window->rooms[window->current];
    const LiveEditor *editor = edit_of(room);
    if (!editor || editor->tool(room->live) != TOOL_SELECT)
        return editor;
    const LiveGesture *gesture = editor->gesture(room->live);
    return gesture->active || has_handle(gesture);
}

/* The hand --------------------------------------------------------------------------------------------------------- */

static Vec2 floor_at(const Window *window, const Room *room, Vec2 at) {
    return scenery_floor(&room->scenery, vec2_sub(at, window->frame.view.low));
}

/* The hand at a point of the window. */
static LiveHand hand_at(const Window *window, const Room *room, Vec2 at) {
    int mods = glass_mods(window->glass);
    Vec2 floor = floor_at(window, room, at);
    return (LiveHand){.at = floor,
                      .reach = vec2_distance(floor, floor_at(window, room, vec2_add(at, vec2(REACH, 0)))),
                      .free = window->edit.free || mods & GLASS_CONTROL,
                      .straight = mods & GLASS_SHIFT,
                      .more = mods & GLASS_SHIFT};
}

static bool same_hand(const LiveHand *a, const LiveHand *b) {
    return a->at.x == b->at.x && a->at.y == b->at.y && a->reach == b->reach && a->free == b->free &&
           a->straight == b->straight && a->nowhere == b->nowhere;
}

/* Says where it is, unless it is there already. */
static void tell(Window *window, Room *room, const LiveHand *hand) {
    if (window->edit.told && same_hand(&window->edit.hand, hand))
        return;
    window->edit.hand = *hand;
    window->edit.told = true;
    edit_of(room)->point(room->live, hand);
    window->dirty = true;
}

/* Without a pointer the middle of the view is meant. */
static void tell_where(Window *window, Room *room) {
    Vec2 at = vec2_scale(window->mouse, 1 / window->unit);
    Box view = window->frame.view;
    if (!room->scenery.painted)
        return;
    bool nowhere = !box_holds(view, at);
    if (nowhere)
        at = vec2_scale(vec2_add(view.low, view.high), 0.5);
    LiveHand hand = hand_at(window, room, at);
    hand.nowhere = nowhere;
    tell(window, room, &hand);
}

void edit_mouse(Window *window, const UiGrab *grab) {
    Room *room = window_room(window);
    const LiveEditor *editor = edit_of(room);
    if (!grab->hovered && !grab->held && !grab->released)
        return;
    LiveHand hand = hand_at(window, room, grab->at);
    tell(window, room, &hand);
    if (grab->pressed) {
        ui_focus(window->ui, "view");
        editor->press(room->live, &hand, grab->twice);
    }
    if (grab->released)
        editor->release(room->live, &hand);
    window->dirty |= grab->pressed || grab->released;
}

/* Keys ------------------------------------------------------------------------------------------------------------- */

/* Lets go what is in the hand, then the tool. */
static bool escape(const LiveEditor *editor, void *live) {
    if (editor->escape(live))
        return true;
    bool tool = editor->tool(live) != TOOL_SELECT;
    if (tool)
        editor->take(live, TOOL_SELECT);
    return tool;
}

bool edit_key(Window *window, const GlassEvent *event) {
    Room *room = window_room(window);
    const LiveEditor *editor = edit_of(room);
    int32_t key = event->key;
    if (!edit_listens(window) || event->mods & (GLASS_CONTROL | GLASS_ALT))
        return false;
    tell_where(window, room);
    if (key == glass_key("Return") || key == glass_key("Keypad Enter"))
        return editor->enter(room->live);
    if (key == glass_key("Backspace"))
        return editor->back(room->live);
    if (key == glass_key("Tab"))
        return editor->tab(room->live, event->mods & GLASS_SHIFT ? -1 : 1);
    return key == glass_key("Escape") && escape(editor, room->live);
}

static bool types_something(const GlassEvent *event) {
    static const char *const pad[] = {"Keypad 0", "Keypad 1", "Keypad 2", "Keypad 3", "Keypad 4", "Keypad 5",
                                      "Keypad 6", "Keypad 7", "Keypad 8", "Keypad 9", "Keypad .", "Keypad -"};
    for (size_t i = 0; i < sizeof pad / sizeof *pad; i++)
        if (event->key == glass_key(pad[i]))
            return true;
    return event->key >= ' ' && event->key < 0x7f;
}

bool edit_keep_key(Window *window, const GlassEvent *event) {
    if (!edit_listens(window) || event->mods & (GLASS_CONTROL | GLASS_ALT) || !types_something(event))
        return false;
    window->edit.key = *event;
    window->edit.waits = true;
    return true;
}

bool edit_take_letters(Window *window, const char *letters) {
    Room *room = window_room(window);
    const LiveEditor *editor = edit_of(room);
    const char own[] = {(char)window->edit.key.key, 0};
    window->edit.waits = false;
    if (!letters && window->edit.key.key < 0x7f && !window->edit.key.mods)
        letters = own;
    return letters && editor && *letters != ' ' && editor->type(room->live, letters);
}

bool edit_type(Window *window, const char *letters) {
    Room *room = window_room(window);
    bool used = edit_listens(window);
    for (const char *at = letters; used && *at; at++)
        used = edit_of(room)->type(room->live, (const char[]){*at, 0});
    return used;
}

/* Doing ------------------------------------------------------------------------------------------------------------ */

static bool is_selected(const Room *room) {
    size_t count;
    return room->kind->editor->selection(room->live, &count) && count > 0;
}

/* What cannot be done says why, or that there is nothing to do it to. */
static void tell_result(Window *window, bool done, const char *what, Fault *fault) {
    if (!done && !fault->count)
        act_say(window, "%s: nothing is selected that it could be done to", what);
    act_complain(window, fault, NAN);
}

static void copy(Window *window, Room *room) {
    char *text = room->kind->editor->copy(room->live);
    if (!text)
        return;
    glass_set_clipboard(window->glass, text);
    act_say(window, "copied");
    memory_free(text);
}

static bool do_clipboard(Window *window, Room *room, Action action) {
    const LiveEditor *editor = room->kind->editor;
    Fault fault = {0};
    switch (action) {
    case ACTION_COPY:
        if (is_selected(room))
            copy(window, room);
        else
            act_do(window, ACTION_COPY_COMMAND, 0, 0);
        return true;
    case ACTION_CUT:
        copy(window, room);
        tell_result(window, editor->remove(room->live, &fault), "Cut", &fault);
        return true;
    case ACTION_PASTE:
        tell_where(window, room);
        if (!editor->paste(room->live, glass_clipboard(window->glass), &fault) && !fault.count)
            act_say(window, "there is nothing in the clipboard that could be put here");
        act_complain(window, &fault, NAN);
        return true;
    default:
        return false;
    }
}

/* What is done to all that is selected. */
static bool do_pieces(Window *window, Room *room, Action action) {
    static const struct {
        Action action;
        size_t member;
    } known[] = {{ACTION_DELETE, offsetof(LiveEditor, remove)},
                 {ACTION_DUPLICATE, offsetof(LiveEditor, duplicate)},
                 {ACTION_SPLIT, offsetof(LiveEditor, split)},
                 {ACTION_TOPPLE, offsetof(LiveEditor, topple)},
                 {ACTION_SHAKE, offsetof(LiveEditor, shake)}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        if (known[i].action != action)
            continue;
        bool (*done)(void *, Fault *);
        memcpy(&done, (const char *)room->kind->editor + known[i].member, sizeof done);
        Fault fault = {0};
        tell_where(window, room);
        if (!done)
            return true;
        bool good = done(room->live, &fault);
        tell_result(window, good, keys_row(action)->name, &fault);
        if (good && action == ACTION_SHAKE)
            act_say(window, "%s", room->kind->editor->shaken(room->live));
        return true;
    }
    return false;
}

/* Arrows look about where nothing is selected. */
static bool nudge(Window *window, Room *room, Action action, int mods) {
    static const Vec2 ways[] = {{-1, 0}, {1, 0}, {0, 1}, {0, -1}};
    size_t way = (size_t)(action - ACTION_NUDGE_LEFT);
    double far = mods & GLASS_CONTROL ? NUDGE_LITTLE : mods & GLASS_SHIFT ? NUDGE_FAR : NUDGE;
    Fault fault = {0};
    if (!is_selected(room)) {
        act_do(window, ACTION_PAN_LEFT + (Action)way, 0, 0);
        return true;
    }
    tell_result(window, room->kind->editor->nudge(room->live, vec2_scale(ways[way], far), &fault), "Nudge", &fault);
    return true;
}

/* False: nothing is selected, and the view is meant. */
static bool turn(Window *window, Room *room, double degrees) {
    Fault fault = {0};
    if (!is_selected(room))
        return fabs(degrees) < TURN;
    tell_result(window, room->kind->editor->turn(room->live, degrees, &fault), "Turn", &fault);
    return true;
}

static void step(Window *window, Room *room, Action action) {
    const LiveEditor *editor = room->kind->editor;
    bool undoes = action == ACTION_UNDO;
    const char *name = undoes ? editor->undo_name(room->live) : editor->redo_name(room->live);
    name = text_in_arena(&window->words, "%s", name ? name : "");
    bool done = undoes ? editor->undo(room->live) : editor->redo(room->live);
    const char *word = undoes ? "undone" : "done again";
    if (done)
        act_say(window, "%s: %s", word, name);
    else
        act_say(window, "there is nothing to be %s", word);
}

static void toggle_snapping(Window *window) {
    window->edit.free = !window->edit.free;
    act_say(window, "snapping is %s", window->edit.free ? "off: the hand is free" : "on");
}

static bool do_hand(Window *window, Room *room, Action action, int mods) {
    const LiveEditor *editor = room->kind->editor;
    switch (action) {
    case ACTION_UNDO:
    case ACTION_REDO:
        step(window, room, action);
        return true;
    case ACTION_SELECT_ALL:
        editor->select_all(room->live);
        return true;
    case ACTION_SNAP:
        toggle_snapping(window);
        return true;
    case ACTION_HANDLE:
    case ACTION_HANDLE_BACK:
        editor->handle(room->live, action == ACTION_HANDLE ? 1 : -1);
        return true;
    case ACTION_NUDGE_LEFT:
    case ACTION_NUDGE_RIGHT:
    case ACTION_NUDGE_UP:
    case ACTION_NUDGE_DOWN:
        return nudge(window, room, action, mods);
    case ACTION_TURN_LEFT:
    case ACTION_TURN_RIGHT:
        return turn(window, room, action == ACTION_TURN_LEFT ? TURN : -TURN);
    case ACTION_TURN_LITTLE_LEFT:
    case ACTION_TURN_LITTLE_RIGHT:
        return turn(window, room, action == ACTION_TURN_LITTLE_LEFT ? TURN_LITTLE : -TURN_LITTLE);
    default:
        return false;
    }
}

bool edit_do(Window *window, Action action, int mods) {
    Room *room = window_room(window);
    const LiveEditor *editor = edit_of(room);
    if (!editor)
        return false;
    if (action >= ACTION_TOOL_SELECT && action <= ACTION_TOOL_IMAGE) {
        editor->take(room->live, (LiveTool)(action - ACTION_TOOL_SELECT));
        bool asks = action == ACTION_TOOL_IMAGE && !editor->image(room->live).path;
        window->panel |= asks;
        window->drawer |= asks;
        ui_focus(window->ui, asks ? "panel" : "view");
        return true;
    }
    return do_clipboard(window, room, action) || do_pieces(window, room, action) || do_hand(window, room, action, mods);
}

const char *edit_step_words(Window *window, Action action) {
    Room *room = window_room(window);
    const LiveEditor *editor = edit_of(room);
    bool undoes = action == ACTION_UNDO;
    const char *name = !editor ? NULL : undoes ? editor->undo_name(room->live) : editor->redo_name(room->live);
    if (!name)
        return undoes ? "Can't undo" : "Can't redo";
    return text_in_arena(&window->words, "%s: %s", undoes ? "Undo" : "Redo", name);
}

/* The clock -------------------------------------------------------------------------------------------------------- */

void edit_hold_number(Window *window, const char *name) {
    Room *room = window_room(window);
    const LiveEditor *editor = edit_of(room);
    if (!editor || window->edit.number)
        return;
    window->edit.number = true;
    editor->hold(room->live, name);
}

void edit_hold_clock(Window *window) {
    Room *room = window_room(window);
    const LiveEditor *editor = edit_of(room);
    Edit *edit = &window->edit;
    if (!editor)
        return;
    if (edit->number && !window->input.down[GLASS_LEFT]) {
        edit->number = false;
        editor->settle(room->live);
    }
    bool hold = edit->number || editor->gesture(room->live)->active;
    if (hold && !edit->holds)
        edit->plays_on = room->player.playing;
    if (hold)
        room->player.playing = false;
    else if (edit->holds)
        room->player.playing = edit->plays_on;
    edit->holds = hold;
}

/* What moves in the picture alone --------------------------------------------------------------------------------- */

void edit_animate(Window *window, double seconds) {
    const Room *room = window_room(window);
    const LiveEditor *editor = edit_of(room);
    bool unseen = window->options->script && !glass_is_seen(window->glass);
    if (!editor || window->reduced)
        return;
    window->dirty |= editor->animation(room->live) != NULL; /* it may come to its end now */
    editor->animate(room->live, unseen ? 1 / PACE_RATE : seconds);
}

const char *edit_animation(const Room *room) {
    const LiveEditor *editor = edit_of(room);
    return editor ? editor->animation(room->live) : NULL;
}

void edit_let_go(Window *window) {
    Room *room = window_room(window);
    const LiveEditor *editor = edit_of(room);
    if (!editor)
        return;
    if (window->edit.number)
        editor->settle(room->live);
    editor->take(room->live, TOOL_SELECT);
    if (window->edit.holds)
        room->player.playing = window->edit.plays_on;
    window->edit = (Edit){.free = window->edit.free};
}
