#include "window/act.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "laboratory/shipped.h"
#include "window/act_play.h"
#include "window/act_plot.h"
#include "window/act_view.h"
#include "window/plan_input.h"
#include "window/files.h"
#include "window/files_import.h"

#define TEXT_STEP 0.25
#define TEXT_MOST 3.0

#define DEFAULT_BEAM "ibs.json"

/* Saying ----------------------------------------------------------------------------------------------------------- */

void act_say(Window *window, const char *format, ...) {
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    messages_add(&window->messages, MESSAGE_NOTE, NAN, "%s", text);
    window->dirty = true;
}

void act_complain(Window *window, Fault *fault, double time) {
    if (fault->count)
        messages_add_fault(&window->messages, fault, time);
    window->dirty = true;
}

/* Opening ---------------------------------------------------------------------------------------------------------- */

static LaboratoryOptions options_of(const Window *window, bool first) {
    const WindowOptions *given = window->options;
    LaboratoryOptions options = {
        .profiles = shipped_places()->profiles, .driving = -1, .seed = given->seed, .jobs = given->jobs};
    if (first) {
        options.settings = given->settings;
        options.setting_count = given->setting_count;
        options.route = given->route;
        options.driving = given->driving;
    }
    return options;
}

static size_t tab_of(const Laboratory *kind) {
    return kind == &beam_laboratory ? TAB_BEAM : TAB_HOUSE;
}

static bool open_in(Window *window, size_t index, const char *path, const char *origin, bool remembered) {
    Fault fault = {0};
    Tab *tab = &window->tabs[index];
    const char *first = window->options->file ? window->options->file : shipped_places()->default_house;
    bool given = path && strcmp(path, first) == 0 && !tab->live;
    LaboratoryOptions options = options_of(window, given);
    options.origin = origin;
    bool opened = tab_open(tab, path, &options, window->screen, &fault);
    act_complain(window, &fault, NAN);
    if (opened) {
        files_begin(window, tab);
        if (path && remembered)
            settings_add_recent(&window->settings, path);
    }
    return opened;
}

static void enter(Window *window, size_t index) {
    Tab *left = window_tab(window);
    if (window->current != index && left->live) {
        plan_input_reset(window);
        RecordSpan span = left->kind->span(left->live);
        player_pause(&left->player, &span);
    }
    Tab *entered = &window->tabs[index];
    window->current = index;
    entered->plot_panes_stale = true;
    window->dirty = true;
}

bool act_open(Window *window, const char *path) {
    if (path && files_import_knows(path))
        return files_import_open(window, path);
    size_t index = path ? tab_of(laboratory_of(path)) : TAB_HOUSE;
    plan_input_reset(window);
    if (!open_in(window, index, path, NULL, true))
        return false;
    enter(window, index);
    return true;
}

bool act_open_copy(Window *window, const char *path, const char *origin, const char *mark) {
    Tab *tab = &window->tabs[TAB_HOUSE];
    plan_input_reset(window);
    if (!open_in(window, TAB_HOUSE, path, origin, false))
        return false;
    tab->mark = mark;
    memory_free(tab->path);
    tab->path = NULL;
    enter(window, TAB_HOUSE);
    return true;
}

void act_enter(Window *window, size_t index) {
    char path[WINDOW_PATH];
    const Shipped *shipped = shipped_places();
    snprintf(path, sizeof path, "%s/" DEFAULT_BEAM, shipped->beams);
    if (window->tabs[index].live ||
        open_in(window, index, index == TAB_BEAM ? path : shipped->default_house, NULL, true))
        enter(window, index);
}

/* Numbers ---------------------------------------------------------------------------------------------------------- */

bool act_set(Window *window, const char *name, double value) {
    Tab *tab = window_tab(window);
    Fault fault = {0};
    bool good = tab->live && tab->kind->set(tab->live, name, value, &fault);
    act_complain(window, &fault, NAN);
    return good;
}

/* Sheets ----------------------------------------------------------------------------------------------------------- */

void act_show_dialog(Window *window, Dialog dialog) {
    window->dialog = dialog;
    window->dirty = true;
}

void act_close_dialog(Window *window) {
    window->dialog = DIALOG_NONE;
    window->leave = LEAVE_NOTHING;
    window->dirty = true;
}

static void show_menu(Window *window) {
    window->menu = MENU_FILE;
    act_show_dialog(window, DIALOG_MENU);
}

static void show_gallery(Window *window) {
    if (!window->gallery)
        window->gallery = gallery_create(window->theme);
    act_show_dialog(window, DIALOG_GALLERY);
}

static void show_open(Window *window) {
    Fault fault = {0};
    const char *folder = *window->settings.state.folder ? window->settings.state.folder : ".";
    if (folder_read(&window->folder, folder, &fault) || folder_read(&window->folder, ".", &fault))
        act_show_dialog(window, DIALOG_OPEN);
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
    act_show_dialog(window, DIALOG_EXPLAIN);
}

/* Looks ------------------------------------------------------------------------------------------------------------ */

static void set_text(Window *window, double size) {
    window->text = fmin(fmax(size, 1), TEXT_MOST);
    window->settings.preferences.text = (int)lround(window->text);
    act_say(window, "letters: %.0f %%", 100 * window->text);
}

static void set_theme(Window *window) {
    window->theme = window->theme == THEME_PAPER ? THEME_BOARD : THEME_PAPER;
    window->settings.preferences.theme = (int)window->theme;
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
    window->settings.preferences.full_screen = window->fullscreen;
    sdl_window_set_fullscreen(window->sdl_window, window->fullscreen);
}

static void next_word(Window *window, Tab *tab, const char *name) {
    size_t count;
    const PanelChoice *choices = tab->kind->choices(tab->live, &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(choices[i].name, name) == 0) {
            size_t word = (choices[i].chosen + 1) % choices[i].count;
            act_say(window, "%s: %s", name, choices[i].words[word]);
            tab->kind->choose(tab->live, i, word);
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
    window->settings.preferences.sound = window->sound;
    act_say(window, "%s", window->sound ? "sound is on: the tip's motion is heard while a beam plays" : message);
}

/* Things ----------------------------------------------------------------------------------------------------------- */

/* Round the things of the view; past the last one the focus goes on. */
static void walk_things(Window *window, Tab *tab, int step) {
    Item now = tab->kind->selected(tab->live), next = tab->kind->next(tab->live, now, step);
    Item first = tab->kind->next(tab->live, (Item){0}, step);
    if (!next.kind || (now.kind && item_same(next, first))) {
        tab_select(tab, (Item){0});
        ui_key(window->ui, step > 0 ? UI_KEY_PANE : UI_KEY_PANE_BACK, false, false);
        return;
    }
    tab_select(tab, next);
}

/* One step back: what is open, then what is typed or chosen, then the selection. */
static void escape(Window *window, Tab *tab) {
    PlotPane *pane = act_focused_pane(window);
    if (window->dialog != DIALOG_NONE)
        act_close_dialog(window);
    else if (pane && pane->box.corner)
        pane->box.corner = 0;
    else if (messages_last(&window->messages) && messages_last(&window->messages)->number > window->dismissed)
        window->dismissed = messages_last(&window->messages)->number;
    else if (tab->live)
        tab_select(tab, (Item){0});
}

PlotPane *act_focused_pane(Window *window) {
    const char *pane = ui_focus_pane(window->ui);
    PlotPanes *panes = &window_tab(window)->panes;
    if (strncmp(pane, "plot:", 5) != 0)
        return NULL;
    for (size_t i = 0; i < panes->count; i++)
        if (strcmp(panes->panes[i].live.name, pane + 5) == 0)
            return &panes->panes[i];
    return NULL;
}

const PanelRow *act_first_place(const Tab *tab) {
    size_t count;
    const PanelRow *rows = tab->kind->rows(tab->live, &count);
    for (size_t i = 0; i < count; i++)
        if (rows[i].place.kind)
            return &rows[i];
    return NULL;
}

void act_show_place(Window *window) {
    Tab *tab = window_tab(window);
    const PanelRow *place = act_first_place(tab);
    if (!place)
        return;
    double time = place->time;
    tab_select(tab, place->place);
    tab_show_selected(tab);
    if (!isnan(time))
        tab_seek(tab, time);
    window->dirty = true;
}

/* What opens and closes sheets. */
static bool do_dialog(Window *window, Action action) {
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
        act_show_dialog(window, DIALOG_MESSAGES);
        return true;
    case ACTION_HELP:
        act_show_dialog(window, DIALOG_KEYS);
        return true;
    case ACTION_EXPLAIN:
        explain(window);
        return true;
    case ACTION_ABOUT:
        act_show_dialog(window, DIALOG_ABOUT);
        return true;
    case ACTION_ESCAPE:
        escape(window, window_tab(window));
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
        act_enter(window, action == ACTION_HOUSE ? TAB_HOUSE : TAB_BEAM);
        return true;
    case ACTION_SOUND:
        toggle_sound(window);
        return true;
    default:
        return false;
    }
}

/* What concerns the laboratory: its files and its things. */
static bool do_tab(Window *window, Tab *tab, Action action) {
    switch (action) {
    case ACTION_SAVE:
        files_save(window);
        return true;
    case ACTION_SAVE_COPY:
        files_ask_name(window);
        return true;
    case ACTION_EXPORT:
        act_show_dialog(window, DIALOG_EXPORT);
        return true;
    case ACTION_UNDO_ALL:
        tab->kind->reset(tab->live);
        act_say(window, "everything is as in the file");
        return true;
    case ACTION_KEEP:
        act_say(window, "%s",
                tab->kind->keep(tab->live, tab->player.time) ? "kept as \"before\""
                                                             : "nothing is kept yet: the run is still being computed");
        return true;
    case ACTION_GHOST:
        next_word(window, tab, "Ghost");
        return true;
    case ACTION_SWEEP:
        next_word(window, tab, "Sweep");
        return true;
    case ACTION_CLEAR:
        tab->kind->clear(tab->live, tab->player.time);
        return true;
    case ACTION_AGAIN:
        act_play_again(tab);
        return true;
    case ACTION_NEXT_THING:
        walk_things(window, tab, 1);
        return true;
    case ACTION_PREVIOUS_THING:
        walk_things(window, tab, -1);
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
    Tab *tab = window_tab(window);
    window->dirty = true;
    if (do_dialog(window, action) || do_window(window, action) || !tab->live || act_plot_do(window, action, mods) ||
        plan_input_do(window, action, mods))
        return;
    if (!do_tab(window, tab, action) && !act_view_do(window, tab, action, key))
        act_play_do(tab, action);
}
