#include "window/scripted.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "laboratory/house_live.h"
#include "window/act.h"
#include "window/edit.h"
#include "window/files.h"

bool scripted_open(Scripted *scripted, const char *path, Fault *fault) {
    *scripted = (Scripted){.events = memory_allocate(SCRIPTED_EVENTS, sizeof *scripted->events)};
    if (script_read(&scripted->script, path, fault))
        return true;
    scripted_close(scripted);
    return false;
}

void scripted_close(Scripted *scripted) {
    script_free(&scripted->script);
    memory_free(scripted->events);
    *scripted = (Scripted){0};
}

bool scripted_is_busy(const Scripted *scripted) {
    return scripted->event_at < scripted->event_count || scripted->waits > 0 || scripted->until ||
           scripted->script.at < scripted->script.count;
}

/* The state -------------------------------------------------------------------------------------------------------- */

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

/* All that can be asked for; new, json_decref it. */
static json_t *state_of(Window *window) {
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

/* Events ----------------------------------------------------------------------------------------------------------- */

static void add_event(Scripted *scripted, GlassEvent event) {
    scripted->events[scripted->event_count++] = event;
}

static GlassEvent mouse_event(double x, double y) {
    return (GlassEvent){.kind = GLASS_MOUSE, .at = {x, y}};
}

static GlassEvent button_event(double x, double y, int button, bool down) {
    return (GlassEvent){.kind = GLASS_BUTTON, .at = {x, y}, .button = button, .down = down};
}

static void add_click(Scripted *scripted, const ScriptCommand *command) {
    double x = command->numbers[0], y = command->numbers[1];
    int button = command->choice == SCRIPT_RIGHT ? GLASS_RIGHT : GLASS_LEFT;
    add_event(scripted, mouse_event(x, y));
    for (int i = 0; i < (command->choice == SCRIPT_DOUBLE ? 2 : 1); i++) {
        add_event(scripted, button_event(x, y, button, true));
        scripted->events[scripted->event_count - 1].twice = i == 1;
        add_event(scripted, button_event(x, y, button, false));
    }
}

static void add_drag(Scripted *scripted, const double *numbers) {
    Vec2 from = {numbers[0], numbers[1]}, to = {numbers[2], numbers[3]}, half = vec2_scale(vec2_add(from, to), 0.5);
    add_event(scripted, mouse_event(from.x, from.y));
    add_event(scripted, button_event(from.x, from.y, GLASS_LEFT, true));
    add_event(scripted, mouse_event(half.x, half.y));
    add_event(scripted, mouse_event(to.x, to.y));
    add_event(scripted, button_event(to.x, to.y, GLASS_LEFT, false));
}

static void add_key(Scripted *scripted, const char *words) {
    GlassEvent event = {.kind = GLASS_KEY};
    keys_read(words, &event.key, &event.mods);
    add_event(scripted, event);
}

static void add_text(Scripted *scripted, const char *words) {
    GlassEvent event = {.kind = GLASS_TEXT};
    snprintf(event.text, sizeof event.text, "%s", words);
    add_event(scripted, event);
}

/* Commands --------------------------------------------------------------------------------------------------------- */

static void fail(Scripted *scripted, Window *window, Fault *fault) {
    for (size_t i = 0; i < fault->count; i++)
        fprintf(stderr, "clearance: %s\n", fault->lines[i]);
    fault_clear(fault);
    scripted->script.at = scripted->script.count;
    window->quit = true;
    window->code = 1;
}

static void say_error(Window *window, const char *path, int error) {
    if (error)
        act_say(window, "%s cannot be written: %s", path, strerror(error));
}

static void write_picture(Window *window, const char *path) {
    unsigned char *pixels = memory_allocate((size_t)window->width * (size_t)window->height, 4);
    paint_gl_screen_read(window->screen, pixels);
    say_error(window, path, snapshot_pixels(path, pixels, window->width, window->height));
    memory_free(pixels);
}

static void write_view(Window *window, const char *path) {
    const Scenery *scenery = &window_room(window)->scenery;
    if (!scenery->paint)
        return;
    unsigned char *pixels = memory_allocate((size_t)scenery->width * (size_t)scenery->height, 4);
    paint_gl_read(scenery->paint, pixels);
    say_error(window, path, snapshot_pixels(path, pixels, scenery->width, scenery->height));
    memory_free(pixels);
}

static void write_state(Window *window, const char *path) {
    json_t *state = state_of(window);
    FILE *file = fopen(path, "a");
    if (file) {
        json_dumpf(state, file, JSON_COMPACT | JSON_SORT_KEYS);
        fputc('\n', file);
        fclose(file);
    } else {
        say_error(window, path, errno);
    }
    json_decref(state);
}

static void expect(Scripted *scripted, Window *window, const ScriptCommand *command) {
    Fault fault = {0};
    json_t *state = state_of(window);
    if (!script_expect(&scripted->script, command, state, &fault))
        fail(scripted, window, &fault);
    json_decref(state);
}

static void set(Scripted *scripted, Window *window, const ScriptCommand *command) {
    Fault fault = {0};
    Room *room = window_room(window);
    if (isnan(command->numbers[0]))
        script_fault(&scripted->script, command, &fault, "%s is no number", command->words[1]);
    else
        room->kind->set(room->live, command->words[0], command->numbers[0], &fault);
    if (fault.count)
        act_complain(window, &fault, NAN);
}

static void set_speed(Room *room, double speed) {
    LiveSpan span = room->kind->span(room->live);
    player_normal_speed(&room->player);
    player_change_speed(&room->player, (int)lround(log2(speed)), &span);
}

static void set_playing(Room *room, bool playing) {
    LiveSpan span = room->kind->span(room->live);
    if (room->player.playing != playing)
        player_toggle(&room->player, &span);
}

/* As if by a hand; false: it is another command. */
static bool run_input(Scripted *scripted, const ScriptCommand *command) {
    const double *numbers = command->numbers;
    switch (command->kind) {
    case SCRIPT_KEY:
        add_key(scripted, command->words[0]);
        return true;
    case SCRIPT_TYPE:
        add_text(scripted, command->words[0]);
        return true;
    case SCRIPT_MOUSE:
        add_event(scripted, mouse_event(numbers[0], numbers[1]));
        return true;
    case SCRIPT_CLICK:
        add_click(scripted, command);
        return true;
    case SCRIPT_DRAG:
        add_drag(scripted, numbers);
        return true;
    case SCRIPT_WHEEL:
        add_event(scripted, (GlassEvent){.kind = GLASS_WHEEL, .wheel = numbers[0]});
        return true;
    default:
        return false;
    }
}

/* The mouse to a place on the floor. */
static void go_to(Scripted *scripted, Window *window, Vec2 floor) {
    const Room *room = window_room(window);
    if (!room->scenery.painted)
        return;
    Vec2 at = vec2_add(window->frame.view.low, scenery_point(&room->scenery, floor));
    add_event(scripted, mouse_event(at.x * window->unit, at.y * window->unit));
}

static int hold_mods(int choice) {
    static const int mods[] = {
        [SCRIPT_NOTHING] = 0, [SCRIPT_SHIFT] = GLASS_SHIFT, [SCRIPT_CTRL] = GLASS_CONTROL, [SCRIPT_ALT] = GLASS_ALT};
    return mods[choice];
}

static void run_in_room(Scripted *scripted, Window *window, const ScriptCommand *command) {
    Room *room = window_room(window);
    Fault fault = {0};
    if (!room->live) {
        script_fault(&scripted->script, command, &fault, "%s: nothing is open", script_word(command->kind));
        fail(scripted, window, &fault);
        return;
    }
    switch (command->kind) {
    case SCRIPT_SET:
        set(scripted, window, command);
        break;
    case SCRIPT_AT:
        go_to(scripted, window, vec2(command->numbers[0], command->numbers[1]));
        break;
    case SCRIPT_SEEK:
        room_seek(room, command->numbers[0]);
        break;
    case SCRIPT_SPEED:
        set_speed(room, command->numbers[0]);
        break;
    default:
        set_playing(room, command->kind == SCRIPT_PLAY);
    }
}

static void run(Scripted *scripted, Window *window, const ScriptCommand *command) {
    const double *numbers = command->numbers;
    window->dirty = true;
    if (run_input(scripted, command))
        return;
    switch (command->kind) {
    case SCRIPT_WAIT:
        scripted->waits = numbers[0];
        break;
    case SCRIPT_UNTIL:
        scripted->until = command;
        scripted->since = glass_now();
        break;
    case SCRIPT_OPEN:
        act_open(window, command->words[0]);
        break;
    case SCRIPT_LABORATORY:
        act_enter(window, (size_t)command->choice);
        break;
    case SCRIPT_SET:
    case SCRIPT_PLAY:
    case SCRIPT_PAUSE:
    case SCRIPT_SEEK:
    case SCRIPT_SPEED:
    case SCRIPT_AT:
        run_in_room(scripted, window, command);
        break;
    case SCRIPT_PRESS:
    case SCRIPT_RELEASE:
        add_event(scripted, button_event(window->mouse.x, window->mouse.y, GLASS_LEFT, command->kind == SCRIPT_PRESS));
        scripted->events[scripted->event_count - 1].twice = command->choice == 1;
        break;
    case SCRIPT_HOLD:
        glass_hold(window->glass, hold_mods(command->choice));
        break;
    case SCRIPT_RESIZE:
        glass_resize(window->glass, (int)numbers[0], (int)numbers[1]);
        break;
    case SCRIPT_PICTURE:
        write_picture(window, command->words[0]);
        break;
    case SCRIPT_VIEW:
        write_view(window, command->words[0]);
        break;
    case SCRIPT_STATE:
        write_state(window, command->words[0]);
        break;
    case SCRIPT_EXPECT:
        expect(scripted, window, command);
        break;
    default:
        window->quit = true;
    }
}

/* Has come what it waits for? */
static bool has_come(const Scripted *scripted, Window *window) {
    const Room *room = window_room(window);
    if (!room->live)
        return false;
    LiveAnswer answer = room->kind->answer(room->live);
    LiveSpan span = room->kind->span(room->live);
    switch (scripted->until->choice) {
    case SCRIPT_COMPLETE:
        return span.complete && !answer.stale;
    case SCRIPT_ANSWERED:
        return !answer.stale && (span.complete || span.endless);
    default:
        return !answer.stale && (span.complete || span.endless) && !answer.doing && !window->export;
    }
}

static bool waits(Scripted *scripted, Window *window) {
    if (scripted->waits > 0) {
        scripted->waits--;
        window->dirty = true;
        return true;
    }
    if (!scripted->until)
        return false;
    if (has_come(scripted, window)) {
        scripted->until = NULL;
        return false;
    }
    if (glass_now() - scripted->since > scripted->until->numbers[0]) {
        Fault fault = {0};
        script_fault(&scripted->script, scripted->until, &fault, "it has not come in %g s",
                     scripted->until->numbers[0]);
        scripted->until = NULL;
        fail(scripted, window, &fault);
    }
    return true;
}

void scripted_go_on(Scripted *scripted, Window *window) {
    if (scripted->event_at < scripted->event_count) {
        glass_push(window->glass, &scripted->events[scripted->event_at++]);
        window->dirty = true;
        return;
    }
    scripted->event_at = scripted->event_count = 0;
    const ScriptCommand *command = waits(scripted, window) || window->quit ? NULL : script_next(&scripted->script);
    if (command)
        run(scripted, window, command);
}
