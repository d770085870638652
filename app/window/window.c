#include "window/window.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "live/shipped.h"
#include "window/act.h"
#include "window/backdrop.h"
#include "window/bars.h"
#include "window/edit.h"
#include "window/files.h"
#include "window/outlook.h"
#include "window/pace_edit.h"
#include "window/panel.h"
#include "window/rail.h"
#include "window/scripted.h"
#include "window/sheet_gallery.h"
#include "window/sheets.h"
#include "window/timeline.h"
#include "window/window_state.h"

enum { WIDTH = 1280, HEIGHT = 720 /* pixels, of a window that is new */ };

#define PRESENT_TEXT 1.5   /* times the size of letters, in front of a class */
#define NOTE_STAY 6.0      /* s, that a line is seen which nobody has to act on: F7 keeps it */
#define IDLE_WAIT 0.05     /* s, for an event, while nothing moves */
#define LEAST_UNIT 0.75    /* pixels a design point: letters are read on the smallest window, too */
#define SOUND_MOST 4096    /* samples a frame */
#define BENCHMARK_WARM 3.0 /* s, before frames are counted */

/* Keys ------------------------------------------------------------------------------------------------------------- */

/* What kind of place has the focus. */
static KeyPlace place_of(const Window *window) {
    const char *pane = ui_focus_pane(window->ui);
    if (window->sheet != SHEET_NONE)
        return KEY_ANYWHERE;
    if (strncmp(pane, "plot:", 5) == 0)
        return KEY_PLOT;
    if (strcmp(pane, "timeline") == 0 && ui_focus_is_pane(window->ui))
        return KEY_TIMELINE;
    if (*pane && strcmp(pane, "view") != 0)
        return KEY_ANYWHERE;
    return edit_of(&window->rooms[window->current]) ? KEY_PLAN : KEY_VIEW;
}

typedef struct WidgetKey {
    const char *name;
    UiKey key;
    bool control;
} WidgetKey;

/* The widgets' key, or UI_KEYS. */
static UiKey widget_key(const GlassEvent *event) {
    static const WidgetKey known[] = {
        {"Return", UI_KEY_ENTER, false},
        {"Keypad Enter", UI_KEY_ENTER, false},
        {"Space", UI_KEY_SPACE, false},
        {"Escape", UI_KEY_ESCAPE, false},
        {"Left", UI_KEY_LEFT, false},
        {"Right", UI_KEY_RIGHT, false},
        {"Up", UI_KEY_UP, false},
        {"Down", UI_KEY_DOWN, false},
        {"Home", UI_KEY_HOME, false},
        {"End", UI_KEY_END, false},
        {"PageUp", UI_KEY_PAGE_UP, false},
        {"PageDown", UI_KEY_PAGE_DOWN, false},
        {"Backspace", UI_KEY_BACKSPACE, false},
        {"Delete", UI_KEY_DELETE, false},
        {"A", UI_KEY_SELECT_ALL, true},
        {"C", UI_KEY_COPY, true},
        {"V", UI_KEY_PASTE, true},
        {"X", UI_KEY_CUT, true},
    };
    bool control = event->mods & GLASS_CONTROL, shift = event->mods & GLASS_SHIFT;
    if (event->key == glass_key("Tab"))
        return shift ? UI_KEY_PREVIOUS : UI_KEY_NEXT;
    if (event->key == glass_key("F6"))
        return shift ? UI_KEY_PANE_BACK : UI_KEY_PANE;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (event->key == glass_key(known[i].name) && known[i].control == control)
            return known[i].key;
    return UI_KEYS;
}

static bool give_to_widgets(Window *window, const GlassEvent *event) {
    UiKey key = widget_key(event);
    if (key == UI_KEYS || event->mods & GLASS_ALT)
        return false;
    return ui_key(window->ui, key, event->mods & GLASS_SHIFT, event->mods & GLASS_CONTROL);
}

/* What an open field has a meaning of its own for. */
static bool is_of_field(Action action) {
    return action == ACTION_COPY_COMMAND || action == ACTION_UNDO || action == ACTION_REDO;
}

/* An open field has the letters; then what the focus is on; then the table; then the widgets again. */
static void do_key(Window *window, const GlassEvent *event) {
    KeyPlace place = place_of(window);
    bool view = place == KEY_VIEW || place == KEY_PLAN;
    bool walks = view && event->key == glass_key("Tab"), types = ui_types(window->ui);
    bool escapes = event->key == glass_key("Escape") && !types && window->sheet != SHEET_NONE;
    if (!walks && !escapes && (types || place == KEY_ANYWHERE || place == KEY_TIMELINE) &&
        give_to_widgets(window, event))
        return;
    bool letters = !types && place != KEY_ANYWHERE && window->settings.likes.letters;
    const KeyRow *row = keys_find(event->key, event->mods, place, letters);
    if (row && !(types && is_of_field(row->action)))
        act_do(window, row->action, event->key, event->mods);
    else
        give_to_widgets(window, event);
}

/* What is in the hand comes first. */
static void take_key(Window *window, const GlassEvent *event) {
    if (place_of(window) == KEY_PLAN && (edit_key(window, event) || edit_keep_key(window, event)))
        return;
    window->edit.done = true;
    do_key(window, event);
}

/* The letters of the key that waited, or NULL: it types none. */
static void end_waiting(Window *window, const char *letters) {
    if (!edit_take_letters(window, letters))
        do_key(window, &window->edit.key);
}

/* Events ----------------------------------------------------------------------------------------------------------- */

/* A field that is open has what is typed, otherwise what is in the hand. */
static void type(Window *window, const char *letters) {
    bool fresh = !window->edit.done && place_of(window) == KEY_PLAN && !ui_types(window->ui);
    window->edit.done = false;
    if (!fresh || !edit_type(window, letters))
        ui_type(window->ui, letters);
}

static void take(Window *window, const GlassEvent *event) {
    window->dirty |= event->kind != GLASS_NOTHING;
    window->edit.done &= event->kind == GLASS_TEXT || event->kind == GLASS_NOTHING;
    if (window->edit.waits && event->kind == GLASS_TEXT) {
        end_waiting(window, event->text);
        return;
    }
    if (window->edit.waits && event->kind == GLASS_KEY)
        end_waiting(window, NULL);
    switch (event->kind) {
    case GLASS_QUIT:
        files_leave(window, LEAVE_QUIT, NULL);
        break;
    case GLASS_KEY:
        take_key(window, event);
        break;
    case GLASS_TEXT:
        type(window, event->text);
        break;
    case GLASS_MOUSE:
        window->mouse = event->at;
        break;
    case GLASS_BUTTON:
        window->mouse = event->at;
        window->input.down[event->button] = event->down;
        window->input.twice |= event->twice && event->button == GLASS_LEFT;
        break;
    case GLASS_WHEEL:
        window->input.wheel += event->wheel;
        break;
    case GLASS_FILE:
        files_leave(window, LEAVE_OPEN, event->text);
        break;
    default:
        break;
    }
}

/* A press and its release must be seen in two frames: the second waits. */
static void take_events(Window *window, double wait) {
    GlassEvent event;
    bool waited = window->edit.waits;
    for (; glass_next(window->glass, &event, wait); wait = 0) {
        take(window, &event);
        if (event.kind == GLASS_BUTTON || event.kind == GLASS_KEY)
            return;
    }
    if (waited && window->edit.waits) {
        end_waiting(window, NULL);
        window->edit.done = true; /* should its letters come late, they are done */
    }
}

/* Frames ----------------------------------------------------------------------------------------------------------- */

/* On whole pixels, so that pictures are copied and not blurred. */
static Box snapped(const Window *window, Box box) {
    double unit = window->unit;
    return (Box){{round(box.low.x * unit) / unit, round(box.low.y * unit) / unit},
                 {round(box.high.x * unit) / unit, round(box.high.y * unit) / unit}};
}

static void make_frame(Window *window) {
    const Room *room = window_room(window);
    glass_size(window->glass, &window->width, &window->height);
    double letters = window->text * (window->present ? PRESENT_TEXT : 1);
    window->unit =
        fmax(layout_unit(window->width, window->height), LEAST_UNIT * glass_density(window->glass)) * letters;
    FrameWish wish = {.panel = window->panel,
                      .plots = window->plots,
                      .present = window->present,
                      .plot_count = room->charts_wait && room->live && !room->charts.count
                                        ? room->kind->plot_count(room->live)
                                        : room->charts.count,
                      .tool_count = edit_of(room) ? LIVE_TOOLS : 0,
                      .aspect = room->aspect};
    Vec2 page = {window->width / window->unit, window->height / window->unit};
    window->frame = frame_make(page, &wish);
    if (window->frame.drawer && !window->drawer) {
        wish.panel = false;
        window->frame = frame_make(page, &wish);
    }
    window->frame.view = snapped(window, window->frame.view);
    for (size_t i = 0; i < window->frame.chart_count; i++)
        window->frame.charts[i] = snapped(window, window->frame.charts[i]);
}

static void fill_input(Window *window, double seconds) {
    UiInput *input = &window->input;
    input->width = window->width;
    input->height = window->height;
    input->unit = window->unit;
    input->seconds = seconds;
    input->mouse = window->mouse;
}

static void show_panes(Window *window) {
    bars_show_menu(window);
    bars_show_answer(window);
    outlook_show(window);
    panel_show(window);
    rail_show(window);
    timeline_show(window);
    bars_show_strip(window);
    bars_show_message(window);
    sheets_show(window);
}

static void draw(Window *window, double seconds) {
    Room *room = window_room(window);
    arena_clear(&window->words);
    make_frame(window);
    room_cramp(room, window->frame.compact);
    outlook_paint(window);
    paint_gl_screen_begin(window->screen, window->width, window->height, palette_colour(window->theme, ROLE_PAPER));
    if (room->live && room->scenery.paint)
        paint_gl_screen_show(window->screen, room->scenery.paint, (int)lround(window->frame.view.low.x * window->unit),
                             (int)lround(window->frame.view.low.y * window->unit));
    fill_input(window, seconds);
    ui_begin(window->ui, &window->input);
    show_panes(window);
    edit_hold_clock(window); /* behind the sliders, which still move in the frame in which they are let go */
    ui_end(window->ui);
    window->input.wheel = 0;
    window->input.twice = false;
}

/* Whether what is shown moves by itself. */
static bool is_lively(Window *window, const Scripted *scripted) {
    const Room *room = window_room(window);
    bool draws = window->sheet == SHEET_GALLERY && !gallery_complete(window->gallery);
    return window->dirty || ui_is_busy(window->ui) || scripted_is_busy(scripted) || window->pace.counting ||
           window->options->benchmark_edit > 0 || window->export || draws || (room->live && room->player.playing) ||
           edit_animation(room);
}

/* Between frames --------------------------------------------------------------------------------------------------- */

static void hear_trouble(Window *window, Room *room) {
    double time = NAN;
    const char *trouble = room->kind->trouble(room->live, &time);
    if (!trouble)
        return;
    messages_say(&window->messages, MESSAGE_FAULT, time, "%s", trouble);
    if (isnan(time))
        return;
    LiveSpan span = room->kind->span(room->live);
    player_pause(&room->player, &span);
    player_seek(&room->player, time, &span);
}

static void make_sound(Window *window, const Room *room, double before) {
    float samples[SOUND_MOST];
    size_t wanted = window->sound ? sound_room(window->sound) : 0;
    wanted = wanted < SOUND_MOST ? wanted : SOUND_MOST;
    if (!wanted)
        return;
    if (room->player.playing && room->player.time > before &&
        room->kind->sound(room->live, before, room->player.time, samples, wanted))
        sound_feed(window->sound, samples, wanted);
    else
        sound_hush(window->sound);
}

/* What is being written by a child has come to its end. */
static void end_export(Window *window) {
    if (!window->export)
        return;
    const ExportStatus *status = export_look(window->export);
    if (status->stage == EXPORT_RUNNING)
        return;
    if (status->stage == EXPORT_DONE)
        act_say(window, "written: %s (%zu files)", status->folder, status->file_count);
    else
        messages_say(&window->messages, MESSAGE_FAULT, NAN, "%s", status->reason);
    export_end(window->export);
    window->export = NULL;
}

/* What was merely said goes by itself; what went wrong stays until it is put away. */
static void forget_notes(Window *window) {
    const Message *last = messages_last(&window->messages);
    if (last && last->number != window->noted) {
        window->noted = last->number;
        window->noted_at = clock_now();
    }
    if (last && last->kind == MESSAGE_SAID && last->number > window->dismissed &&
        clock_now() - window->noted_at > NOTE_STAY) {
        window->dismissed = last->number;
        window->dirty = true;
    }
}

static void move_on(Window *window, double seconds) {
    Room *room = window_room(window);
    double before = room->player.time;
    for (size_t i = 0; i < ROOMS; i++) {
        unsigned changes = room_update(&window->rooms[i], i == window->current ? seconds : 0);
        if (changes & LIVE_TROUBLE)
            hear_trouble(window, &window->rooms[i]);
        window->dirty |= changes && i == window->current;
    }
    if (room->live)
        make_sound(window, room, before);
    end_export(window);
    files_watch(window);
    forget_notes(window);
}

/* One turn of the loop. */
static void turn(Window *window, Scripted *scripted) {
    bool lively = is_lively(window, scripted);
    bool hurried = (window->pace.counting && window->options->benchmark > 0) ||
                   (scripted_is_busy(scripted) && !scripted->until && !glass_is_seen(window->glass));
    double seconds = pace_wait(&window->pace, hurried), begun = clock_now();
    edit_animate(window, seconds);
    take_events(window, lively ? 0 : IDLE_WAIT);
    double worked = window_room(window)->worked;
    move_on(window, seconds);
    if (!is_lively(window, scripted))
        return;
    window->dirty = false;
    draw(window, seconds);
    scripted_go_on(scripted, window);
    glass_swap(window->glass);
    pace_note_first(&window->pace);
    pace_note(&window->pace, clock_now() - begun, window_room(window)->worked - worked);
}

/* Beginning and end ------------------------------------------------------------------------------------------------ */

static void take_likes(Window *window) {
    const WindowOptions *options = window->options;
    const SettingsLikes *likes = &window->settings.likes;
    window->theme = (Theme)(options->theme >= 0 ? options->theme : likes->theme);
    window->text = options->text > 0 ? options->text : likes->text;
    window->reduced = options->reduced_motion || likes->reduced_motion;
    window->panel = window->plots = true;
    window->rooms[ROOM_HOUSE] = room_make(&house_live);
    window->rooms[ROOM_BEAM] = room_make(&beam_live);
    for (size_t i = 0; i < ROOMS; i++) {
        const SettingsLaboratory *kept = settings_laboratory(&window->settings, window->rooms[i].kind->word);
        if (kept->layers >= 0)
            window->rooms[i].layers = (unsigned)kept->layers;
        if (*kept->plots)
            window->rooms[i].plots = kept->plots;
        window->rooms[i].player.power = kept->speed > 0 ? (int)lround(log2(kept->speed)) : 0;
    }
}

static void keep_likes(Window *window) {
    Fault notes = {0};
    for (size_t i = 0; i < ROOMS; i++) {
        const Room *room = &window->rooms[i];
        SettingsLaboratory *kept = settings_laboratory(&window->settings, room->kind->word);
        kept->layers = room->layers == room->kind->layers_at_first ? -1 : (int)room->layers;
        kept->plots = strcmp(room->plots, room->kind->plots_at_first) == 0 ? "" : room->plots;
        kept->speed = player_speed(&room->player);
    }
    if (!window->fullscreen) {
        window->settings.likes.width = window->width;
        window->settings.likes.height = window->height;
    }
    settings_save(&window->settings, &notes);
    fault_clear(&notes);
}

static bool open_glass(Window *window, Fault *fault) {
    const WindowOptions *options = window->options;
    const SettingsLikes *likes = &window->settings.likes;
    int width = options->width > 0 ? options->width : likes->width > 0 ? likes->width : WIDTH;
    int height = options->height > 0 ? options->height : likes->height > 0 ? likes->height : HEIGHT;
    window->glass = glass_create(width, height, fault);
    if (!window->glass)
        return false;
    window->screen = paint_gl_screen_create(glass_gl(window->glass));
    if (!glass_is_seen(window->glass))
        paint_gl_screen_leave_window(
            window->screen); /* without a display a window's own picture keeps its first size */
    window->ui =
        ui_create(window->screen, window->theme, (UiClipboard){glass_clipboard, glass_set_clipboard, window->glass});
    window->mouse = vec2(-1, -1);
    return true;
}

static void close_all(Window *window) {
    if (window->export)
        export_end(window->export);
    if (window->sound)
        sound_close(window->sound);
    if (window->gallery)
        gallery_destroy(window->gallery);
    sheet_gallery_clear(window);
    files_end(window);
    backdrop_clear(window);
    for (size_t i = 0; i < ROOMS; i++)
        room_close(&window->rooms[i], window->screen);
    ui_destroy(window->ui);
    paint_gl_screen_destroy(window->screen);
    glass_destroy(window->glass);
    folder_clear(&window->folder);
    arena_clear(&window->words);
    pace_clear(&window->pace);
    pace_edit_clear(window);
}

static void loop(Window *window, Scripted *scripted) {
    double begun = clock_now();
    while (!window->quit) {
        turn(window, scripted);
        if (window->options->benchmark_edit > 0 && pace_edit_go_on(window, begun))
            window->quit = true;
        if (window->options->benchmark > 0 && !window->pace.counting && clock_now() - begun > BENCHMARK_WARM)
            pace_count(&window->pace);
        if (window->options->benchmark > 0 && window->pace.counting &&
            clock_now() - begun > BENCHMARK_WARM + window->options->benchmark)
            window->quit = true;
    }
    if (window->options->benchmark > 0 && window->pace.counting)
        pace_print(&window->pace, window_room(window)->kind->name, window->width, window->height);
}

/* The first file: what was asked for, or what is opened when nothing is. */
static void open_first(Window *window) {
    files_start(window);
    const char *file = window->options->file;
    if (!file || !act_open(window, file))
        act_open(window, shipped_places()->default_house);
    if (shipped_places()->missing)
        act_say(window, "%s", shipped_places()->missing);
}

static int fail(Fault *fault) {
    for (size_t i = 0; i < fault->count; i++)
        fprintf(stderr, "clearance: %s\n", fault->lines[i]);
    fault_clear(fault);
    return 2;
}

int window_run(const WindowOptions *options) {
    Window *window = memory_zeroed(1, sizeof *window);
    Scripted scripted = {0};
    Fault fault = {0};
    window->options = options;
    settings_open(&window->settings, &fault);
    act_complain(window, &fault, NAN);
    bool good = !options->script || scripted_open(&scripted, options->script, &fault);
    take_likes(window);
    good = good && open_glass(window, &fault);
    int code = good ? 0 : fail(&fault);
    if (good) {
        if (window->settings.likes.full_screen)
            act_do(window, ACTION_FULLSCREEN, 0, 0);
        open_first(window);
        loop(window, &scripted);
        keep_likes(window);
        close_all(window);
        code = window->code;
    }
    scripted_close(&scripted);
    messages_clear(&window->messages);
    settings_close(&window->settings);
    memory_free(window);
    return code;
}
