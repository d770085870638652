#include "window/act.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "live/shipped.h"
#include "window/act_play.h"
#include "window/act_plot.h"
#include "window/act_view.h"
#include "window/edit.h"
#include "window/files.h"
#include "window/files_import.h"

#define TEXT_STEP 0.25
#define TEXT_MOST 3.0

#define DEFAULT_BEAM "ibs.json"

/* Saying ----------------------------------------------------------------------------------------------------------- */

void act_say(Window *window, const char *format, ...) {
    char words[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    messages_say(&window->messages, MESSAGE_SAID, NAN, "%s", words);
    window->dirty = true;
}

void act_complain(Window *window, Fault *fault, double time) {
    if (fault->count)
        messages_take(&window->messages, fault, time);
    window->dirty = true;
}

/* Opening ---------------------------------------------------------------------------------------------------------- */

static LiveOptions options_of(const Window *window, bool first) {
    const WindowOptions *given = window->options;
    LiveOptions options = {
        .profiles = shipped_places()->profiles, .driving = -1, .seed = given->seed, .jobs = given->jobs};
    if (first) {
        options.settings = given->settings;
        options.setting_count = given->setting_count;
        options.route = given->route;
        options.driving = given->driving;
    }
    return options;
}

static size_t room_of(const LiveKind *kind) {
    return kind == &beam_live ? ROOM_BEAM : ROOM_HOUSE;
}

static bool open_in(Window *window, size_t index, const char *path, const char *origin, bool remembered) {
    Fault fault = {0};
    Room *room = &window->rooms[index];
    const char *first = window->options->file ? window->options->file : shipped_places()->default_house;
    bool given = path && strcmp(path, first) == 0 && !room->live;
    LiveOptions options = options_of(window, given);
    options.origin = origin;
    bool opened = room_open(room, path, &options, window->screen, &fault);
    act_complain(window, &fault, NAN);
    if (opened) {
        files_begin(window, room);
        if (path && remembered)
            settings_add_recent(&window->settings, path);
    }
    return opened;
}

static void enter(Window *window, size_t index) {
    Room *left = window_room(window);
    if (window->current != index && left->live) {
        edit_let_go(window);
        LiveSpan span = left->kind->span(left->live);
        player_pause(&left->player, &span);
    }
    Room *entered = &window->rooms[index];
    window->current = index;
    entered->charts_wait = true;
    window->dirty = true;
}

bool act_open(Window *window, const char *path) {
    if (path && files_import_knows(path))
        return files_import_open(window, path);
    size_t index = path ? room_of(live_kind_of(path)) : ROOM_HOUSE;
    edit_let_go(window);
    if (!open_in(window, index, path, NULL, true))
        return false;
    enter(window, index);
    return true;
}

bool act_open_copy(Window *window, const char *path, const char *origin, const char *mark) {
    Room *room = &window->rooms[ROOM_HOUSE];
    edit_let_go(window);
    if (!open_in(window, ROOM_HOUSE, path, origin, false))
        return false;
    room->mark = mark;
    memory_free(room->path);
    room->path = NULL;
    enter(window, ROOM_HOUSE);
    return true;
}

void act_enter(Window *window, size_t index) {
    char path[WINDOW_PATH];
    const Shipped *shipped = shipped_places();
    snprintf(path, sizeof path, "%s/" DEFAULT_BEAM, shipped->beams);
    if (window->rooms[index].live ||
        open_in(window, index, index == ROOM_BEAM ? path : shipped->default_house, NULL, true))
        enter(window, index);
}

/* Numbers ---------------------------------------------------------------------------------------------------------- */

bool act_set(Window *window, const char *name, double value) {
    Room *room = window_room(window);
    Fault fault = {0};
    bool good = room->live && room->kind->set(room->live, name, value, &fault);
    act_complain(window, &fault, NAN);
    return good;
}

/* Sheets ----------------------------------------------------------------------------------------------------------- */

void act_show_sheet(Window *window, Sheet sheet) {
    window->sheet = sheet;
    window->dirty = true;
}

void act_close_sheet(Window *window) {
    window->sheet = SHEET_NONE;
    window->leave = LEAVE_NOTHING;
    window->dirty = true;
}

static void show_menu(Window *window) {
    window->menu = MENU_FILE;
    act_show_sheet(window, SHEET_MENU);
}

static void show_gallery(Window *window) {
    if (!window->gallery)
        window->gallery = gallery_create(window->theme);
    act_show_sheet(window, SHEET_GALLERY);
}

static void show_open(Window *window) {
    Fault fault = {0};
    const char *folder = *window->settings.state.folder ? window->settings.state.folder : ".";
    if (folder_read(&window->folder, folder, &fault) || folder_read(&window->folder, ".", &fault))
        act_show_sheet(window, SHEET_OPEN);
    act_complain(window, &fault, NAN);
}

char *act_folder(Window *window) {
    Fault fault = {0};
    char *folder = export_folder(&fault);
    act_complain(window, &fault, NAN);
    return folder;
}

static void explain(Window *window) {
    const char *help = ui_focus_help(window->ui);
    snprintf(window->hold, sizeof window->hold, "%s",
             help ? help : "Tab goes from widget to widget, F6 from pane to pane; F1 shows all keys");
    act_show_sheet(window, SHEET_EXPLAIN);
}

/* Looks ------------------------------------------------------------------------------------------------------------ */

static void set_text(Window *window, double size) {
    window->text = fmin(fmax(size, 1), TEXT_MOST);
    window->settings.likes.text = (int)lround(window->text);
    act_say(window, "letters: %.0f %%", 100 * window->text);
}

static void set_theme(Window *window) {
    window->theme = window->theme == THEME_PAPER ? THEME_BOARD : THEME_PAPER;
    window->settings.likes.theme = (int)window->theme;
    ui_set_theme(window->ui, window->theme);
    if (window->gallery)
        gallery_set_theme(window->gallery, window->theme);
}

/* Where it lies over the view it is closed at first. */
static void toggle_panel(Window *window) {
    if (window->frame.drawer)
        window->drawer = !window->drawer;
    else
        window->panel = !window->panel;
}

static void set_fullscreen(Window *window) {
    window->fullscreen = !window->fullscreen;
    window->settings.likes.full_screen = window->fullscreen;
    glass_set_fullscreen(window->glass, window->fullscreen);
}

static void next_word(Window *window, Room *room, const char *name) {
    size_t count;
    const LiveChoice *choices = room->kind->choices(room->live, &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(choices[i].name, name) == 0) {
            size_t word = (choices[i].chosen + 1) % choices[i].count;
            act_say(window, "%s: %s", name, choices[i].words[word]);
            room->kind->choose(room->live, i, word);
            return;
        }
    act_say(window, "there is no %s here", name);
}

static void toggle_sound(Window *window) {
    char message[SOUND_MESSAGE] = "sound is off";
    if (window->sound) {
        sound_close(window->sound);
        window->sound = NULL;
    } else {
        window->sound = sound_open(message);
    }
    window->settings.likes.sound = window->sound;
    act_say(window, "%s", window->sound ? "sound is on: the tip's motion is heard while a beam plays" : message);
}

/* Things ----------------------------------------------------------------------------------------------------------- */

/* Round the things of the view; past the last one the focus goes on. */
static void walk_things(Window *window, Room *room, int step) {
    LiveThing now = room->kind->selected(room->live), next = room->kind->next(room->live, now, step);
    LiveThing first = room->kind->next(room->live, (LiveThing){0}, step);
    if (!next.kind || (now.kind && live_same(next, first))) {
        room_select(room, (LiveThing){0});
        ui_key(window->ui, step > 0 ? UI_KEY_PANE : UI_KEY_PANE_BACK, false, false);
        return;
    }
    room_select(room, next);
}

/* One step back: what is open, then what is typed or chosen, then the selection. */
static void escape(Window *window, Room *room) {
    Chart *chart = act_focused_chart(window);
    if (window->sheet != SHEET_NONE)
        act_close_sheet(window);
    else if (chart && chart->box.corner)
        chart->box.corner = 0;
    else if (messages_last(&window->messages) && messages_last(&window->messages)->number > window->dismissed)
        window->dismissed = messages_last(&window->messages)->number;
    else if (room->live)
        room_select(room, (LiveThing){0});
}

Chart *act_focused_chart(Window *window) {
    const char *pane = ui_focus_pane(window->ui);
    Charts *charts = &window_room(window)->charts;
    if (strncmp(pane, "plot:", 5) != 0)
        return NULL;
    for (size_t i = 0; i < charts->count; i++)
        if (strcmp(charts->charts[i].live.name, pane + 5) == 0)
            return &charts->charts[i];
    return NULL;
}

const LiveRow *act_first_place(const Room *room) {
    size_t count;
    const LiveRow *rows = room->kind->rows(room->live, &count);
    for (size_t i = 0; i < count; i++)
        if (rows[i].place.kind)
            return &rows[i];
    return NULL;
}

void act_show_place(Window *window) {
    Room *room = window_room(window);
    const LiveRow *place = act_first_place(room);
    if (!place)
        return;
    double time = place->time;
    room_select(room, place->place);
    room_show_selected(room);
    if (!isnan(time))
        room_seek(room, time);
    window->dirty = true;
}

/* What opens and closes sheets. */
static bool do_sheet(Window *window, Action action) {
    switch (action) {
    case ACTION_OPEN:
        show_open(window);
        return true;
    case ACTION_GALLERY:
        show_gallery(window);
        return true;
    case ACTION_MENU:
        show_menu(window);
        return true;
    case ACTION_MESSAGES:
        act_show_sheet(window, SHEET_MESSAGES);
        return true;
    case ACTION_HELP:
        act_show_sheet(window, SHEET_KEYS);
        return true;
    case ACTION_EXPLAIN:
        explain(window);
        return true;
    case ACTION_ABOUT:
        act_show_sheet(window, SHEET_ABOUT);
        return true;
    case ACTION_ESCAPE:
        escape(window, window_room(window));
        return true;
    default:
        return false;
    }
}

/* What works without anything open. */
static bool do_window(Window *window, Action action) {
    switch (action) {
    case ACTION_QUIT:
        files_leave(window, LEAVE_QUIT, NULL);
        return true;
    case ACTION_NEW:
        files_leave(window, LEAVE_NEW, NULL);
        return true;
    case ACTION_PANEL:
        toggle_panel(window);
        return true;
    case ACTION_PLOTS:
        window->plots = !window->plots;
        return true;
    case ACTION_PRESENT:
        window->present = !window->present;
        return true;
    case ACTION_FULLSCREEN:
        set_fullscreen(window);
        return true;
    case ACTION_THEME:
        set_theme(window);
        return true;
    case ACTION_LARGER:
    case ACTION_SMALLER:
        set_text(window, window->text + (action == ACTION_LARGER ? TEXT_STEP : -TEXT_STEP));
        return true;
    case ACTION_NORMAL_SIZE:
        set_text(window, 1);
        return true;
    case ACTION_HOUSE:
    case ACTION_BEAM:
        act_enter(window, action == ACTION_HOUSE ? ROOM_HOUSE : ROOM_BEAM);
        return true;
    case ACTION_SOUND:
        toggle_sound(window);
        return true;
    default:
        return false;
    }
}

/* What concerns the laboratory: its files and its things. */
static bool do_room(Window *window, Room *room, Action action) {
    switch (action) {
    case ACTION_SAVE:
        files_save(window);
        return true;
    case ACTION_SAVE_COPY:
        files_ask_name(window);
        return true;
    case ACTION_EXPORT:
        act_show_sheet(window, SHEET_EXPORT);
        return true;
    case ACTION_UNDO_ALL:
        room->kind->reset(room->live);
        act_say(window, "everything is as in the file");
        return true;
    case ACTION_KEEP:
        act_say(window, "%s",
                room->kind->keep(room->live, room->player.time)
                    ? "kept as \"before\""
                    : "nothing is kept yet: the run is still being computed");
        return true;
    case ACTION_GHOST:
        next_word(window, room, "Ghost");
        return true;
    case ACTION_SWEEP:
        next_word(window, room, "Sweep");
        return true;
    case ACTION_CLEAR:
        room->kind->clear(room->live, room->player.time);
        return true;
    case ACTION_AGAIN:
        act_play_again(room);
        return true;
    case ACTION_NEXT_THING:
        walk_things(window, room, 1);
        return true;
    case ACTION_PREVIOUS_THING:
        walk_things(window, room, -1);
        return true;
    case ACTION_EDIT_NUMBERS:
        window->panel = window->drawer = true;
        ui_focus(window->ui, "panel");
        return true;
    default:
        return false;
    }
}

void act_do(Window *window, Action action, int32_t key, int mods) {
    Room *room = window_room(window);
    window->dirty = true;
    if (do_sheet(window, action) || do_window(window, action) || !room->live || act_plot_do(window, action, mods) ||
        edit_do(window, action, mods))
        return;
    if (!do_room(window, room, action) && !act_view_do(window, room, action, key))
        act_play_do(room, action);
}
