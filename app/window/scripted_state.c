#include "window/scripted_state.h"

#include <math.h>
#include <stdio.h>

#include "live/house/house_live.h"
#include "window/edit.h"
#include "window/files.h"

static json_t *json_box(const Window *window, Box box) {
    double unit = window->unit;
    return json_pack("[f,f,f,f]", box.low.x * unit, box.low.y * unit, box.high.x * unit, box.high.y * unit);
}

/* JSON has no number for what is none. */
static json_t *number_or_null(double value) {
    return isfinite(value) ? json_real(value) : json_null();
}

static json_t *frame_state(const Window *window) {
    const Frame *frame = &window->frame;
    const Charts *charts = &window->rooms[window->current].charts;
    json_t *state = json_object(), *plots = json_object();
    json_object_set_new(state, "menu", json_box(window, frame->menu));
    json_object_set_new(state, "answer", json_box(window, frame->answer));
    json_object_set_new(state, "view", json_box(window, frame->view));
    json_object_set_new(state, "rail", json_box(window, frame->rail));
    json_object_set_new(state, "panel", json_box(window, frame->panel));
    json_object_set_new(state, "timeline", json_box(window, frame->timeline));
    json_object_set_new(state, "strip", json_box(window, frame->strip));
    for (size_t i = 0; i < frame->chart_count && i < charts->count; i++)
        json_object_set_new(plots, charts->charts[i].live.name, json_box(window, frame->charts[i]));
    json_object_set_new(state, "plots", plots);
    return state;
}

/* Of each plot that is shown: its axes, and where its cursor stands. */
static json_t *charts_state(const Charts *charts) {
    json_t *state = json_object();
    for (size_t i = 0; i < charts->count; i++) {
        const Chart *chart = &charts->charts[i];
        if (!chart->canvas)
            continue;
        ChartAxes axes = charts_axes(chart);
        json_t *one = json_pack("{s:[f,f],s:[f,f],s:i,s:i}", "x", axes.x[0], axes.x[1], "y", axes.y[0], axes.y[1],
                                "views", (int)chart->view_count, "corner", chart->box.corner);
        json_object_set_new(one, "cursor", number_or_null(chart->live.cursor));
        json_object_set_new(one, "own_cursor", number_or_null(chart->cursor));
        json_object_set_new(state, chart->live.name, one);
    }
    return state;
}

static json_t *parameters_state(const Room *room) {
    json_t *state = json_object();
    size_t count;
    const LiveParameter *parameters = room->kind->parameters(room->live, &count);
    for (size_t i = 0; i < count; i++)
        json_object_set_new(state, parameters[i].name, number_or_null(parameters[i].value));
    return state;
}

static json_t *choices_state(const Room *room) {
    json_t *state = json_object();
    size_t count;
    const LiveChoice *choices = room->kind->choices(room->live, &count);
    for (size_t i = 0; i < count; i++)
        json_object_set_new(state, choices[i].name, json_string(choices[i].words[choices[i].chosen]));
    return state;
}

/* What the panel lists, cell by cell. */
static json_t *rows_state(const Room *room) {
    size_t count;
    const LiveRow *rows = room->kind->rows(room->live, &count);
    json_t *state = json_array();
    for (size_t i = 0; i < count; i++) {
        json_t *cells = json_array();
        for (size_t c = 0; c < sizeof rows[i].row.cells / sizeof *rows[i].row.cells; c++)
            json_array_append_new(cells, json_string(rows[i].row.cells[c] ? rows[i].row.cells[c] : ""));
        json_array_append_new(state, cells);
    }
    return state;
}

static json_t *answer_state(const Room *room) {
    LiveAnswer answer = room->kind->answer(room->live);
    json_t *state = json_pack("{s:s,s:b}", "title", answer.title, "stale", answer.stale);
    json_object_set_new(state, "detail", answer.detail ? json_string(answer.detail) : json_null());
    json_object_set_new(state, "doing", answer.doing ? json_string(answer.doing) : json_null());
    return state;
}

static json_t *command_state(const Room *room) {
    size_t count;
    const char *const *words = room->kind->command(room->live, &count);
    char *command = export_command(words, count);
    json_t *state = json_string(command);
    memory_free(command);
    return state;
}

/* Words of all marks, as they are seen. */
static json_t *marks_state(const LiveGesture *gesture) {
    static const char *const kinds[] = {
        [MARK_OUTLINE] = "outline", [MARK_LINE] = "line",     [MARK_GUIDE] = "guide", [MARK_DIMENSION] = "dimension",
        [MARK_SNAP] = "snap",       [MARK_HANDLE] = "handle", [MARK_GAP] = "gap"};
    json_t *state = json_array();
    for (size_t i = 0; i < gesture->mark_count; i++) {
        const LiveMark *mark = &gesture->marks[i];
        json_t *one = json_pack("{s:s,s:s*,s:b}", "kind", kinds[mark->kind], "words", mark->words, "held", mark->held);
        if (mark->count)
            json_object_set_new(one, "at", json_pack("[f,f]", mark->points[0].x, mark->points[0].y));
        json_array_append_new(state, one);
    }
    return state;
}

static json_t *gesture_state(const LiveGesture *gesture) {
    json_t *state = json_pack("{s:b,s:s,s:s*,s:s*,s:s*}", "active", gesture->active, "doing", gesture->doing, "refusal",
                              gesture->refusal, "typed", gesture->typed, "wrong", gesture->wrong);
    json_t *fields = json_object();
    for (size_t i = 0; i < gesture->field_count; i++)
        json_object_set_new(fields, gesture->fields[i].name, number_or_null(gesture->fields[i].value));
    json_object_set_new(state, "fields", fields);
    if (gesture->field < gesture->field_count)
        json_object_set_new(state, "field", json_string(gesture->fields[gesture->field].name));
    json_object_set_new(state, "marks", marks_state(gesture));
    return state;
}

static json_t *selection_state(const Room *room, const LiveEditor *editor) {
    json_t *state = json_array();
    size_t count;
    const LiveThing *things = editor->selection(room->live, &count);
    for (size_t i = 0; i < count; i++)
        json_array_append_new(state, json_string(room->kind->name_thing(room->live, things[i])));
    return state;
}

static json_t *text_or_null(const char *text) {
    return text ? json_string(text) : json_null();
}

static void add_editor(json_t *state, Window *window, const Room *room) {
    const LiveEditor *editor = edit_of(room);
    if (!editor)
        return;
    size_t count;
    const char *doing = NULL;
    json_object_set_new(state, "tool", json_string(editor->tools[editor->tool(room->live)].name));
    json_object_set_new(state, "gesture", gesture_state(editor->gesture(room->live)));
    json_object_set_new(state, "selection", selection_state(room, editor));
    json_object_set_new(state, "undo_name", text_or_null(editor->undo_name(room->live)));
    json_object_set_new(state, "redo_name", text_or_null(editor->redo_name(room->live)));
    json_object_set_new(state, "edits", json_integer((json_int_t)editor->edits(room->live)));
    json_object_set_new(state, "changed", json_boolean(editor->changed(room->live)));
    json_object_set_new(state, "unsaved", json_boolean(files_unsaved(room)));
    json_object_set_new(state, "shown_title", json_string(files_title(window, room)));
    json_object_set_new(state, "snaps", json_boolean(!window->edit.free));
    json_object_set_new(state, "held", json_boolean(window->edit.holds));
    json_object_set_new(state, "animation", text_or_null(edit_animation(room)));
    if (!editor->proposals)
        return;
    editor->proposals(room->live, &count, &doing);
    json_object_set_new(state, "proposals", json_integer((json_int_t)count));
    json_object_set_new(state, "proposing", text_or_null(doing));
}

/* Where 0, 0 is in the window, and how long a metre to the right and one up the plan: pixels. */
static json_t *floor_state(const Window *window, const Room *room) {
    Vec2 places[] = {{0, 0}, {1, 0}, {0, 1}};
    json_t *state = json_array();
    for (size_t i = 0; room->scenery.painted && i < 3; i++) {
        Vec2 at = vec2_add(window->frame.view.low, scenery_point(&room->scenery, places[i]));
        json_array_append_new(state, json_pack("[f,f]", at.x * window->unit, at.y * window->unit));
    }
    return state;
}

static void add_room(json_t *state, Window *window) {
    const Room *room = window_room(window);
    const Player *player = &room->player;
    LiveSpan span = room->kind->span(room->live);
    LiveThing thing = room->kind->selected(room->live);
    char digest[32];
    snprintf(digest, sizeof digest, "%016llx",
             room->kind == &house_live ? (unsigned long long)house_live_digest(room->live) : 0ull);
    json_object_set_new(state, "file", room->path ? json_string(room->path) : json_null());
    json_object_set_new(state, "title", json_string(room->kind->title(room->live)));
    json_object_set_new(state, "digest", json_string(digest));
    json_object_set_new(state, "time", number_or_null(player->time));
    json_object_set_new(state, "begin", number_or_null(span.begin));
    json_object_set_new(state, "end", number_or_null(span.end));
    json_object_set_new(state, "step", number_or_null(span.step));
    json_object_set_new(state, "complete", json_boolean(span.complete));
    json_object_set_new(state, "playing", json_boolean(player->playing));
    json_object_set_new(state, "speed", number_or_null(player_speed(player)));
    json_object_set_new(state, "achieved", number_or_null(player->achieved));
    json_object_set_new(state, "loops", json_boolean(player->loops));
    json_object_set_new(state, "follows", json_boolean(room->follows));
    json_object_set_new(state, "raised", json_boolean(room->camera.kind == VIEW_RAISED));
    json_object_set_new(state, "zoom", number_or_null(room->camera.zoom));
    json_object_set_new(state, "azimuth", number_or_null(room->camera.azimuth));
    json_object_set_new(state, "layers", json_integer(room_layers(room)));
    json_object_set_new(state, "clock", json_string(room->kind->clock(room->live, player->time)));
    json_object_set_new(state, "selected",
                        thing.kind ? json_string(room->kind->name_thing(room->live, thing)) : json_null());
    json_object_set_new(state, "floor", floor_state(window, room));
    json_object_set_new(state, "answer", answer_state(room));
    json_object_set_new(state, "rows", rows_state(room));
    json_object_set_new(state, "parameters", parameters_state(room));
    json_object_set_new(state, "choices", choices_state(room));
    json_object_set_new(state, "charts", charts_state(&room->charts));
    json_object_set_new(state, "command", command_state(room));
    add_editor(state, window, room);
}

json_t *scripted_state_of(Window *window) {
    static const char *const sheets[SHEETS] = {"none",   "menu",     "keys",    "gallery", "open",  "save",
                                               "export", "messages", "explain", "about",   "leave", "recovered"};
    const Message *last = messages_last(&window->messages);
    json_t *state = json_object();
    json_object_set_new(state, "laboratory", json_string(window_room(window)->kind->word));
    json_object_set_new(state, "width", json_integer(window->width));
    json_object_set_new(state, "height", json_integer(window->height));
    json_object_set_new(state, "text", number_or_null(window->text));
    json_object_set_new(state, "theme", json_string(window->theme == THEME_BOARD ? "board" : "paper"));
    json_object_set_new(state, "sheet", json_string(sheets[window->sheet]));
    json_object_set_new(state, "panel", json_boolean(window->panel));
    json_object_set_new(state, "plots", json_boolean(window->plots));
    json_object_set_new(state, "present", json_boolean(window->present));
    json_object_set_new(state, "fullscreen", json_boolean(window->fullscreen));
    json_object_set_new(state, "sound", json_boolean(window->sound != NULL));
    json_object_set_new(state, "writing", json_boolean(window->export != NULL));
    json_object_set_new(state, "focus", json_string(ui_focus_pane(window->ui)));
    json_object_set_new(state, "focus_help", text_or_null(ui_focus_help(window->ui)));
    json_object_set_new(state, "focus_is_pane", json_boolean(ui_focus_is_pane(window->ui)));
    json_object_set_new(state, "types", json_boolean(ui_types(window->ui)));
    json_object_set_new(state, "message", last ? json_string(last->text) : json_null());
    json_object_set_new(state, "messages", json_integer((json_int_t)window->messages.total));
    json_object_set_new(state, "frame", frame_state(window));
    if (window_room(window)->live)
        add_room(state, window);
    return state;
}
