#include "window/act.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "laboratory/import_file.h"
#include "window/act_plot.h"
#include "window/act_view.h"
#include "window/dialog_pane.h"
#include "window/files.h"
#include "window/lesson.h"
#include "window/menu_reason.h"
#include "window/notice.h"
#include "window/opening.h"
#include "window/plan_input.h"

#define TEXT_STEP 0.25

/* Dialogs ---------------------------------------------------------------------------------------------------------- */

static void show_menu(Window *window) {
    window->menu = MENU_FILE;
    dialog_pane_show(window, DIALOG_MENU);
}

static void show_gallery(Window *window, bool lessons) {
    if (!window->gallery)
        window->gallery = gallery_create(window->theme);
    window->lessons_only = lessons;
    *window->field = 0;
    dialog_pane_show(window, DIALOG_GALLERY);
}

static void show_open(Window *window) {
    Fault fault = {0};
    const char *folder = files_open_folder(window);
    if (folder_read(&window->folder, folder, import_file_knows, &fault) ||
        folder_read(&window->folder, ".", import_file_knows, &fault)) {
        *window->field = 0;
        window->refusal = 0;
        dialog_pane_show(window, DIALOG_OPEN);
    }
    notice_fault(window, &fault, NAN);
}

static void explain(Window *window) {
    const char *help = ui_focus_help(window->ui);
    snprintf(window->hold, sizeof window->hold, "%s",
             help ? help : "Press Tab for the next control, F6 for the next pane, F1 for all keys");
    dialog_pane_show(window, DIALOG_EXPLAIN);
}

/* Appearance ------------------------------------------------------------------------------------------------------- */

static void set_text(Window *window, double size) {
    window->text = fmin(fmax(size, SETTINGS_TEXT_LEAST), SETTINGS_TEXT_MOST);
    window->settings.preferences.text = window->text;
    notice_post(window, "Text size: %.0f %%", 100 * window->text);
}

static void set_theme(Window *window) {
    window->theme = window->theme == THEME_PAPER ? THEME_BOARD : THEME_PAPER;
    window->settings.preferences.theme = (int)window->theme;
    ui_set_theme(window->ui, window->theme);
    if (window->gallery)
        gallery_set_theme(window->gallery, window->theme);
}

/* As a drawer over the view the panel is closed at first; it opens even if it was hidden beside a larger view. */
static void toggle_panel(Window *window) {
    if (window->frame.drawer) {
        window->drawer = !(window->panel && window->drawer);
        window->panel |= window->drawer;
    } else {
        window->panel = !window->panel;
    }
}

/* Opens the toolbar, or closes it and puts the tool down. */
static void edit_plan(Window *window) {
    Editor *editor = tab_editor(window_tab(window));
    window->editing = editor && !window->editing;
    if (editor && !window->editing)
        editor_set_tool(editor, TOOL_SELECT);
    ui_focus(window->ui, "view");
}

static void set_fullscreen(Window *window) {
    window->fullscreen = !window->fullscreen;
    window->settings.preferences.full_screen = window->fullscreen;
    sdl_window_set_fullscreen(window->sdl_window, window->fullscreen);
}

static void next_word(Window *window, Tab *tab, const char *name) {
    size_t count;
    const PanelChoice *choices = tab->laboratory->choices(tab->session, &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(choices[i].name, name) == 0) {
            size_t word = (choices[i].chosen + 1) % choices[i].count;
            notice_post(window, "%s: %s", name, choices[i].options[word]);
            tab->laboratory->choose(tab->session, i, word);
            return;
        }
    notice_post(window, "This laboratory has no choice \"%s\".", name);
}

static void toggle_sound(Window *window) {
    char message[SOUND_MESSAGE] = "Sound: off";
    if (window->sound) {
        sound_close(window->sound);
        window->sound = NULL;
    } else {
        window->sound = sound_open(message);
    }
    window->settings.preferences.sound = window->sound;
    notice_post(window, "%s",
                window->sound ? "Sound: on. The motion of the tip is audible while a beam plays." : message);
}

/* Transport -------------------------------------------------------------------------------------------------------- */

enum { STEPS_MANY = 10 };

/* Plays, steps or goes to another time; ignores any other action. */
static void do_transport(Tab *tab, Action action) {
    Player *player = &tab->player;
    RecordSpan span = tab_span(tab);
    double second = span.pace;
    switch (action) {
    case ACTION_PLAY:
        player_toggle(player, &span);
        break;
    case ACTION_STEP:
    case ACTION_STEP_BACK:
        player_step(player, action == ACTION_STEP ? 1 : -1, &span);
        break;
    case ACTION_STEP_TEN:
    case ACTION_STEP_BACK_TEN:
        player_step(player, action == ACTION_STEP_TEN ? STEPS_MANY : -STEPS_MANY, &span);
        break;
    case ACTION_SECOND:
    case ACTION_SECOND_BACK:
        player_seek(player, player->time + (action == ACTION_SECOND ? second : -second), &span);
        break;
    case ACTION_SLOWER:
    case ACTION_FASTER:
        player_change_speed(player, action == ACTION_FASTER ? 1 : -1, &span);
        break;
    case ACTION_NORMAL_SPEED:
        player_normal_speed(player);
        break;
    case ACTION_START:
        player_seek(player, span.begin, &span);
        break;
    case ACTION_NOW:
        player_seek(player, span.end, &span);
        break;
    case ACTION_LOOP:
        player->loops = !player->loops;
        break;
    case ACTION_MARK_IN:
        player->in = player->time;
        player->loops = true;
        break;
    case ACTION_MARK_OUT:
        player->out = player->time;
        player->loops = true;
        break;
    default:
        break;
    }
}

/* Runs again from the beginning, and keeps playing if it was playing. */
static void run_again(Tab *tab) {
    RecordSpan span = tab_span(tab);
    bool plays = tab->player.playing || (span.complete && tab->player.time >= span.end);
    tab->laboratory->restart(tab->session);
    span = tab_span(tab);
    player_seek(&tab->player, span.begin, &span);
    tab->player.playing = plays;
}

/* Items ------------------------------------------------------------------------------------------------------------ */

/* Selects the next item of the view; after the last one the focus goes to the next pane. */
static void walk_items(Window *window, Tab *tab, int step) {
    bool hidden = lesson_hides_words(window); /* a dangerous place would tell the result */
    Item now = tab->laboratory->selected(tab->session), next = tab->laboratory->next(tab->session, now, step);
    Item first = tab->laboratory->next(tab->session, (Item){0}, step);
    if (hidden || !next.kind || (now.kind && item_same(next, first))) {
        tab_select(tab, (Item){0});
        ui_key(window->ui, step > 0 ? UI_KEY_PANE : UI_KEY_PANE_BACK, false, false);
        return;
    }
    tab_select(tab, next);
}

/* Goes one step back: closes the dialog, drops the zoom box, dismisses the message, clears the selection, or leaves the
 * lesson. */
static void escape(Window *window, Tab *tab) {
    PlotPane *pane = plot_panes_focused(&window_tab(window)->panes, window->ui);
    if (window->dialog != DIALOG_NONE)
        dialog_pane_close(window);
    else if (pane && pane->box.corner)
        pane->box.corner = 0;
    else if (window->present && window->drawer)
        lesson_close_panel(window);
    else if (!notice_dismiss(window) && tab->session) {
        bool chosen = tab->laboratory->selected(tab->session).kind, taught = lesson_is_shown(window);
        tab_select(tab, (Item){0});
        if (window->narrowing)
            ui_focus(window->ui, "view"); /* the width that had it is gone */
        window->narrowing = NARROWING_NONE;
        if (!chosen && window->present)
            window->present = false;
        else if (!chosen && taught)
            lesson_leave(window);
        else if (!chosen)
            ui_focus(window->ui, "view"); /* where the letters of the tools are keys */
    }
}

void act_show_place(Window *window) {
    Tab *tab = window_tab(window);
    const PanelRow *place = tab_first_place(tab);
    if (!place)
        return;
    double time = place->time;
    tab_select(tab, place->place);
    tab_show_selected(tab);
    if (!isnan(time))
        tab_seek(tab, time);
    window->dirty = true;
}

void act_show_last(Window *window, Tab *tab, const Result *answer) {
    tab_seek(tab, answer->last_time);
    tab_select(tab, answer->last);
    tab_show_selected(tab);
    window->dirty = true;
}

void act_set_scale(Window *window) {
    act_do(window, ACTION_TOOL_MEASURE, 0, 0);
    Editor *editor = tab_editor(window_tab(window));
    if (editor)
        editor_take_scale(editor);
}

/* Does an action that opens or closes a dialog; false: it is another action. */
static bool do_dialog(Window *window, Action action) {
    switch (action) {
    case ACTION_OPEN:
        show_open(window);
        return true;
    case ACTION_GALLERY:
    case ACTION_LESSONS:
        show_gallery(window, action == ACTION_LESSONS);
        return true;
    case ACTION_MENU:
        show_menu(window);
        return true;
    case ACTION_MESSAGES:
        dialog_pane_show(window, DIALOG_MESSAGES);
        return true;
    case ACTION_HISTORY:
        if (window_tab(window)->session && tab_editor(window_tab(window)))
            dialog_pane_show(window, DIALOG_HISTORY);
        return true;
    case ACTION_HELP:
        *window->field = 0;
        dialog_pane_show(window, DIALOG_KEYS);
        return true;
    case ACTION_EXPLAIN:
        explain(window);
        return true;
    case ACTION_TRY:
        window->settings.state.tried = 0;
        window->dirty = true;
        return true;
    case ACTION_ABOUT:
        dialog_pane_show(window, DIALOG_ABOUT);
        return true;
    case ACTION_ESCAPE:
        escape(window, window_tab(window));
        return true;
    default:
        return false;
    }
}

/* Does an action that works with nothing open; false: it is another action. */
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
        act_plot_toggle(window);
        return true;
    case ACTION_EDIT_PLAN:
        edit_plan(window);
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
    case ACTION_SOUND:
        toggle_sound(window);
        return true;
    default:
        if (lesson_do(window, action))
            return true;
        if (action < ACTION_LABORATORY)
            return false;
        if (window->dialog != DIALOG_LEAVE && window->dialog != DIALOG_SAVE) /* those ask about the shown tab */
            opening_tab(window, (size_t)(action - ACTION_LABORATORY));
        return true;
    }
}

/* True if something is selected whose texts the panel shows, like a room, which the laboratory itself does not know. */
static bool selects_texts(const Tab *tab) {
    static const char house[] = "house.";
    size_t count = 0;
    Editor *editor = tab_editor(tab);
    const EditText *texts = editor ? editor_texts(editor, &count) : NULL;
    for (size_t i = 0; i < count; i++)
        if (strncmp(texts[i].name, house, sizeof house - 1) != 0)
            return true;
    return false;
}

void act_cure(Window *window, Tab *tab, const Result *answer) {
    Vec2 at = answer->cure_at;
    act_do(window, ACTION_TOOL_SELECT + (Action)answer->tool, 0, 0);
    if (isfinite(at.x))
        plan_input_look_at(window, tab, at);
    editor_cure(tab_editor(tab));
}

/* Goes on to what a house lacks, as the button of the answer does; false: it lacks nothing. */
static bool take_missing(Window *window, Tab *tab) {
    Editor *editor = tab_editor(tab);
    Result answer = tab->laboratory->answer(tab->session);
    bool takes = editor && answer.cure && !answer.stale && !tab->laboratory->selected(tab->session).kind &&
                 editor_tool(editor) == TOOL_SELECT && !lesson_is_shown(window);
    if (takes)
        act_cure(window, tab, &answer);
    return takes;
}

/* Does an action on the laboratory's files and items; false: it is another action. */
static bool do_tab(Window *window, Tab *tab, Action action) {
    switch (action) {
    case ACTION_SAVE:
        files_save(window);
        return true;
    case ACTION_SAVE_COPY:
        files_ask_name(window);
        return true;
    case ACTION_EXPORT:
        dialog_pane_show(window, DIALOG_EXPORT);
        return true;
    case ACTION_UNDO_ALL:
        tab->laboratory->reset(tab->session);
        notice_post(window, "Everything is reset to the values in the file.");
        return true;
    case ACTION_KEEP:
        notice_post(window, "%s",
                    tab->laboratory->save_run(tab->session, tab->player.time)
                        ? "Saved for comparison"
                        : "Nothing to save yet: the run is still being computed");
        return true;
    case ACTION_GHOST:
        next_word(window, tab, "Compare with");
        return true;
    case ACTION_SWEEP:
        next_word(window, tab, "Sweep");
        return true;
    case ACTION_FOLLOW_ORBIT:
        if (tab->laboratory->follow)
            notice_post(window, tab->laboratory->follow(tab->session) ? "This orbit is being followed"
                                                                      : "The followed orbit is removed");
        return true;
    case ACTION_CLEAR:
        tab->laboratory->clear_runs(tab->session, tab->player.time);
        return true;
    case ACTION_AGAIN:
        run_again(tab);
        return true;
    case ACTION_NEXT_THING:
        walk_items(window, tab, 1);
        return true;
    case ACTION_PREVIOUS_THING:
        walk_items(window, tab, -1);
        return true;
    case ACTION_EDIT_NUMBERS:
        if (take_missing(window, tab))
            return true;
        window->panel = window->drawer = true;
        if (tab->laboratory->selected(tab->session).kind || lesson_is_shown(window) || selects_texts(tab))
            ui_focus_number(window->ui, "panel");
        else
            ui_focus(window->ui, "panel");
        return true;
    default:
        return false;
    }
}

/* Returns the meaning of an action on the selection when nothing is selected: arrows pan the view, and Copy copies the
 * command line. */
static Action without_selection(Action action) {
    if (action >= ACTION_NUDGE_LEFT && action <= ACTION_NUDGE_DOWN)
        return ACTION_PAN_LEFT + (action - ACTION_NUDGE_LEFT);
    return action == ACTION_COPY ? ACTION_COPY_COMMAND : action;
}

void act_do(Window *window, Action action, int32_t key, int mods) {
    Tab *tab = window_tab(window);
    const char *reason = menu_reason_to_guess(window, action);
    window->dirty = true;
    if (reason) {
        notice_post(window, "%s.", reason);
        return;
    }
    if (do_dialog(window, action) || do_window(window, action) || !tab->session || act_plot_do(window, action, mods) ||
        plan_input_do(window, action, mods))
        return;
    Action meant = without_selection(action);
    if (meant != action && act_plot_do(window, meant, 0))
        return;
    if (do_tab(window, tab, meant) || act_view_do(window, tab, meant, key))
        return;
    if (action == ACTION_PLAY && !tab_can_play(tab))
        notice_post(window, "%s.", menu_reason_of(window, action));
    else
        do_transport(tab, meant);
}
