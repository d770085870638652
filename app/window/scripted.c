#include "window/scripted.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/file_write.h"
#include "base/stopwatch.h"
#include "window/lesson.h"
#include "window/lesson_view.h"
#include "window/notice.h"
#include "window/opening.h"
#include "window/plan_input.h"
#include "window/scripted_state.h"

bool scripted_open(Scripted *scripted, const char *path, Fault *fault) {
    *scripted = (Scripted){.events = memory_zeroed(SCRIPTED_EVENTS, sizeof *scripted->events)};
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

/* Events ----------------------------------------------------------------------------------------------------------- */

static void add_event(Scripted *scripted, SdlWindowEvent event) {
    scripted->events[scripted->event_count++] = event;
}

static SdlWindowEvent mouse_event(double x, double y) {
    return (SdlWindowEvent){.kind = SDL_WINDOW_EVENT_MOUSE, .at = {x, y}};
}

static SdlWindowEvent button_event(double x, double y, int button, bool down) {
    return (SdlWindowEvent){.kind = SDL_WINDOW_EVENT_BUTTON, .at = {x, y}, .button = button, .down = down};
}

static void add_click(Scripted *scripted, const ScriptCommand *command) {
    double x = command->numbers[0], y = command->numbers[1];
    int button = command->choice == SCRIPT_RIGHT ? SDL_WINDOW_EVENT_RIGHT : SDL_WINDOW_EVENT_LEFT;
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
    add_event(scripted, button_event(from.x, from.y, SDL_WINDOW_EVENT_LEFT, true));
    add_event(scripted, mouse_event(half.x, half.y));
    add_event(scripted, mouse_event(to.x, to.y));
    add_event(scripted, button_event(to.x, to.y, SDL_WINDOW_EVENT_LEFT, false));
}

static void add_key(Scripted *scripted, const char *words) {
    SdlWindowEvent event = {.kind = SDL_WINDOW_EVENT_KEY};
    keys_read(words, &event.key, &event.mods);
    add_event(scripted, event);
}

static void add_text(Scripted *scripted, const char *words) {
    SdlWindowEvent event = {.kind = SDL_WINDOW_EVENT_TEXT};
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
        notice_post(window, "%s cannot be written: %s", path, file_write_reason(error));
}

static void write_picture(Window *window, const char *path) {
    unsigned char *pixels = memory_zeroed((size_t)window->width * (size_t)window->height, 4);
    paint_gl_screen_read(window->screen, pixels);
    say_error(window, path, snapshot_pixels(path, pixels, window->width, window->height));
    memory_free(pixels);
}

static void write_view(Window *window, const char *path) {
    const ViewLayers *view_layers = &window_tab(window)->view_layers;
    if (!view_layers->paint)
        return;
    unsigned char *pixels = memory_zeroed((size_t)view_layers->width * (size_t)view_layers->height, 4);
    paint_gl_read(view_layers->paint, pixels);
    say_error(window, path, snapshot_pixels(path, pixels, view_layers->width, view_layers->height));
    memory_free(pixels);
}

/* Adds a line to a file, and releases what it says. */
static void write_line(Window *window, const char *path, json_t *state) {
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
    json_t *state = scripted_state_of(window);
    if (!script_expect(&scripted->script, command, state, &fault))
        fail(scripted, window, &fault);
    json_decref(state);
}

static void set(Scripted *scripted, Window *window, const ScriptCommand *command) {
    Fault fault = {0};
    Tab *tab = window_tab(window);
    if (isnan(command->numbers[0]))
        script_fault(&scripted->script, command, &fault, "%s is not a number", command->words[1]);
    else
        tab->laboratory->set(tab->session, command->words[0], command->numbers[0], &fault);
    if (fault.count)
        notice_fault(window, &fault, NAN);
}

static void select_named(Scripted *scripted, Window *window, const ScriptCommand *command) {
    Tab *tab = window_tab(window);
    Fault fault = {0};
    Item item = lesson_view_find(tab, command->words[0]);
    if (item.kind)
        tab_select(tab, item);
    else
        script_fault(&scripted->script, command, &fault, "nothing is called \"%s\"", command->words[0]);
    if (fault.count)
        fail(scripted, window, &fault);
}

static void set_speed(Tab *tab, double speed) {
    RecordSpan span = tab_span(tab);
    player_normal_speed(&tab->player);
    player_change_speed(&tab->player, (int)lround(log2(speed)), &span);
}

static void set_playing(Tab *tab, bool playing) {
    RecordSpan span = tab_span(tab);
    if (tab->player.playing != playing)
        player_toggle(&tab->player, &span);
}

/* Runs a command of mouse or keyboard; false: it is another command. */
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
        add_event(scripted, (SdlWindowEvent){.kind = SDL_WINDOW_EVENT_WHEEL, .wheel = numbers[0]});
        return true;
    default:
        return false;
    }
}

/* Moves the mouse to a place on the floor. */
static void go_to(Scripted *scripted, Window *window, Vec2 floor) {
    const Tab *tab = window_tab(window);
    if (!tab->view_layers.painted)
        return;
    Vec2 at = vec2_add(window->frame.view.low, view_layers_point(&tab->view_layers, floor));
    add_event(scripted, mouse_event(at.x * window->unit, at.y * window->unit));
}

static int hold_mods(int choice) {
    static const int mods[] = {[SCRIPT_NOTHING] = 0,
                               [SCRIPT_SHIFT] = SDL_WINDOW_EVENT_SHIFT,
                               [SCRIPT_CTRL] = SDL_WINDOW_EVENT_CONTROL,
                               [SCRIPT_ALT] = SDL_WINDOW_EVENT_ALT};
    return mods[choice];
}

static void run_in_tab(Scripted *scripted, Window *window, const ScriptCommand *command) {
    Tab *tab = window_tab(window);
    Fault fault = {0};
    if (!tab->session) {
        script_fault(&scripted->script, command, &fault, "%s: nothing is open", script_word(command->kind));
        fail(scripted, window, &fault);
        return;
    }
    switch (command->kind) {
    case SCRIPT_SET:
        set(scripted, window, command);
        break;
    case SCRIPT_SELECT:
        select_named(scripted, window, command);
        break;
    case SCRIPT_AT:
        go_to(scripted, window, vec2(command->numbers[0], command->numbers[1]));
        break;
    case SCRIPT_SEEK:
        tab_seek(tab, command->numbers[0]);
        break;
    case SCRIPT_SPEED:
        set_speed(tab, command->numbers[0]);
        break;
    default:
        set_playing(tab, command->kind == SCRIPT_PLAY);
    }
}

static void run(Scripted *scripted, Window *window, const ScriptCommand *command) {
    const double *numbers = command->numbers;
    window->dirty |= command->kind != SCRIPT_WAIT && command->kind != SCRIPT_STATE && command->kind != SCRIPT_TEXTS;
    if (run_input(scripted, command))
        return;
    switch (command->kind) {
    case SCRIPT_WAIT:
        scripted->waits = numbers[0];
        break;
    case SCRIPT_UNTIL:
        scripted->until = command;
        scripted->since = stopwatch_now();
        break;
    case SCRIPT_OPEN:
        lesson_open_any(window, command->words[0]);
        break;
    case SCRIPT_LABORATORY:
        opening_tab(window, (size_t)command->choice);
        break;
    case SCRIPT_SET:
    case SCRIPT_SELECT:
    case SCRIPT_PLAY:
    case SCRIPT_PAUSE:
    case SCRIPT_SEEK:
    case SCRIPT_SPEED:
    case SCRIPT_AT:
        run_in_tab(scripted, window, command);
        break;
    case SCRIPT_PRESS:
    case SCRIPT_RELEASE:
        add_event(scripted,
                  button_event(window->mouse.x, window->mouse.y, SDL_WINDOW_EVENT_LEFT, command->kind == SCRIPT_PRESS));
        scripted->events[scripted->event_count - 1].twice = command->choice == 1;
        break;
    case SCRIPT_HOLD:
        sdl_window_hold(window->sdl_window, hold_mods(command->choice));
        break;
    case SCRIPT_RESIZE:
        sdl_window_resize(window->sdl_window, (int)numbers[0], (int)numbers[1]);
        break;
    case SCRIPT_PICTURE:
        write_picture(window, command->words[0]);
        break;
    case SCRIPT_VIEW:
        write_view(window, command->words[0]);
        break;
    case SCRIPT_STATE:
        write_line(window, command->words[0], scripted_state_of(window));
        break;
    case SCRIPT_TEXTS:
        write_line(window, command->words[0], scripted_state_texts(window));
        break;
    case SCRIPT_EXPECT:
        expect(scripted, window, command);
        break;
    default:
        window->quit = true;
    }
}

/* True if the condition of `until` is met. */
static bool has_come(const Scripted *scripted, Window *window) {
    const Tab *tab = window_tab(window);
    if (!tab->session)
        return false;
    Result answer = tab->laboratory->answer(tab->session);
    RecordSpan span = tab_span(tab);
    switch (scripted->until->choice) {
    case SCRIPT_COMPLETE:
        return span.complete && !answer.stale;
    case SCRIPT_ANSWERED:
        return !answer.stale && (span.complete || span.endless) && !lesson_works(window);
    case SCRIPT_SHAKEN:
        return !answer.stale && span.complete && !answer.shaking;
    default:
        return !answer.stale && (span.complete || span.endless) && !answer.doing && !answer.grading &&
               !window->export && !lesson_works(window) && !plan_input_animation(tab) &&
               !(tab_editor(tab) && editor_seeks_proposals(tab_editor(tab)));
    }
}

static bool waits(Scripted *scripted, Window *window) {
    if (scripted->waits > 0) {
        scripted->waits--;
        return true;
    }
    if (!scripted->until)
        return false;
    if (has_come(scripted, window)) {
        scripted->until = NULL;
        window->dirty = true; /* the next command is drawn in a frame of its own */
        return true;
    }
    if (stopwatch_now() - scripted->since > scripted->until->numbers[0]) {
        Fault fault = {0};
        script_fault(&scripted->script, scripted->until, &fault, "the condition was not met within %g s",
                     scripted->until->numbers[0]);
        scripted->until = NULL;
        fail(scripted, window, &fault);
    }
    return true;
}

void scripted_advance(Scripted *scripted, Window *window) {
    if (scripted->event_at < scripted->event_count) {
        sdl_window_push(window->sdl_window, &scripted->events[scripted->event_at++]);
        window->dirty = true;
        return;
    }
    scripted->event_at = scripted->event_count = 0;
    const ScriptCommand *command = waits(scripted, window) || window->quit ? NULL : script_next(&scripted->script);
    if (command)
        run(scripted, window, command);
}
