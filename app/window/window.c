#include "window/window.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/stopwatch.h"
#include "laboratory/shipped.h"
#include "window/act.h"
#include "window/autosave.h"
#include "window/bars.h"
#include "window/benchmark.h"
#include "window/canvas.h"
#include "window/dialog_gallery.h"
#include "window/dialogs.h"
#include "window/files.h"
#include "window/lesson.h"
#include "window/menu.h"
#include "window/notice.h"
#include "window/opening.h"
#include "window/panel.h"
#include "window/plan_input.h"
#include "window/scripted.h"
#include "window/timeline.h"
#include "window/toolbar.h"
#include "window/trace_image.h"
#include "window/tries.h"
#include "window/window_state.h"

#define NOTE_STAY 6.0    /* s, that a note stays visible; the log (F7) keeps it */
#define IDLE_WAIT 0.05   /* s, for an event, while nothing moves */
#define ANSWER_WAIT 2e-3 /* s, if an answer is expected, too */
#define SOUND_MOST 4096  /* samples a frame */

/* Keys ------------------------------------------------------------------------------------------------------------- */

/* Returns the kind of place that has the focus. */
static KeyPlace place_of(const Window *window) {
    const char *pane = ui_focus_pane(window->ui);
    if (window->dialog != DIALOG_NONE)
        return KEY_ANYWHERE;
    if (strncmp(pane, "plot:", 5) == 0)
        return KEY_PLOT;
    if (strcmp(pane, "timeline") == 0 && ui_focus_is_pane(window->ui))
        return KEY_TIMELINE;
    if (*pane && strcmp(pane, "view") != 0)
        return KEY_ANYWHERE;
    return tab_editor(&window->tabs[window->current]) ? KEY_PLAN : KEY_VIEW;
}

typedef struct WidgetKey {
    const char *name;
    UiKey key;
    bool control;
} WidgetKey;

/* Returns the key for the widgets, or UI_KEYS if they have no use for it. */
static UiKey widget_key(const SdlWindowEvent *event) {
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
    bool control = event->mods & SDL_WINDOW_EVENT_CONTROL, shift = event->mods & SDL_WINDOW_EVENT_SHIFT;
    if (event->key == sdl_window_key("Tab"))
        return shift ? UI_KEY_PREVIOUS : UI_KEY_NEXT;
    if (event->key == sdl_window_key("F6"))
        return shift ? UI_KEY_PANE_BACK : UI_KEY_PANE;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (event->key == sdl_window_key(known[i].name) && known[i].control == control)
            return known[i].key;
    return UI_KEYS;
}

static bool give_to_widgets(Window *window, const SdlWindowEvent *event) {
    UiKey key = widget_key(event);
    if (key == UI_KEYS || event->mods & SDL_WINDOW_EVENT_ALT)
        return false;
    return ui_key(window->ui, key, event->mods & SDL_WINDOW_EVENT_SHIFT, event->mods & SDL_WINDOW_EVENT_CONTROL);
}

/* True for actions whose keys mean something else in a text field. */
static bool is_of_field(Action action) {
    return action == ACTION_COPY_COMMAND || action == ACTION_UNDO || action == ACTION_REDO;
}

/* Handles a key: first the open text field, then the focused widget, then the table of keys, then the widgets again. */
static void do_key(Window *window, const SdlWindowEvent *event) {
    KeyPlace place = place_of(window);
    bool view = place == KEY_VIEW || place == KEY_PLAN;
    bool walks = view && event->key == sdl_window_key("Tab"), types = ui_types(window->ui);
    bool escapes = event->key == sdl_window_key("Escape") && !types && window->dialog != DIALOG_NONE;
    if (!walks && !escapes && (types || place == KEY_ANYWHERE || place == KEY_TIMELINE) &&
        give_to_widgets(window, event))
        return;
    bool single_keys = !types && place != KEY_ANYWHERE && window->settings.preferences.single_keys;
    Action action = keys_find(event->key, event->mods, place, single_keys);
    if (!action && strcmp(ui_focus_pane(window->ui), "rail") == 0 && window->settings.preferences.single_keys)
        action = keys_find_tool(event->key, event->mods);
    if (action) {
        snprintf(window->echo, sizeof window->echo, "%s   %s", keys_row(action).key, keys_row(action).name);
        window->echo_at = stopwatch_now();
    }
    if (action && !(types && is_of_field(action)))
        act_do(window, action, event->key, event->mods);
    else
        give_to_widgets(window, event);
}

/* Walks through the open menu; false: the key means something else. */
static bool walk_menu(Window *window, const SdlWindowEvent *event) {
    static const struct {
        const char *key;
        int across, down;
    } ways[] = {{"Left", -1, 0}, {"Right", 1, 0}, {"Up", 0, -1}, {"Down", 0, 1}};
    for (size_t i = 0; i < sizeof ways / sizeof *ways && window->dialog == DIALOG_MENU; i++)
        if (event->key == sdl_window_key(ways[i].key)) {
            menu_walk(window, ways[i].across, ways[i].down);
            return true;
        }
    bool letter = !event->mods && event->key >= 'a' && event->key <= 'z';
    return window->dialog == DIALOG_MENU && letter && menu_jump(window, (char)event->key);
}

/* Handles a key; a gesture comes first. */
static void handle_key(Window *window, const SdlWindowEvent *event) {
    if (lesson_key(window, event)) {
        window->plan_input.done = true;
        return;
    }
    if (walk_menu(window, event) || dialog_gallery_key(window, event))
        return;
    if (place_of(window) == KEY_PLAN && (plan_input_key(window, event) || plan_input_store_key(window, event)))
        return;
    window->plan_input.done = true;
    do_key(window, event);
}

/* Ends the wait of a stored key, with its text or NULL if it types none. */
static void end_waiting(Window *window, const char *text) {
    if (!plan_input_apply_text(window, text))
        do_key(window, &window->plan_input.key);
}

/* Events ----------------------------------------------------------------------------------------------------------- */

/* Passes typed text to the open text field, otherwise to the gesture. */
static void type(Window *window, const char *text) {
    ui_hide_hover_tip(window->ui);
    if (window->dialog == DIALOG_GALLERY && !ui_types(window->ui)) {
        dialog_gallery_type(window, text);
        return;
    }
    bool fresh = !window->plan_input.done && place_of(window) == KEY_PLAN && !ui_types(window->ui);
    window->plan_input.done = false;
    if (!fresh || !plan_input_type(window, text))
        ui_type(window->ui, text);
}

static void handle_event(Window *window, const SdlWindowEvent *event) {
    window->dirty |= event->kind != SDL_WINDOW_EVENT_NOTHING;
    window->inputs += (event->kind == SDL_WINDOW_EVENT_KEY && !event->repeat) ||
                      event->kind == SDL_WINDOW_EVENT_LET_GO || event->kind == SDL_WINDOW_EVENT_BUTTON;
    window->plan_input.done &= event->kind == SDL_WINDOW_EVENT_TEXT || event->kind == SDL_WINDOW_EVENT_NOTHING;
    if (window->plan_input.waits && event->kind == SDL_WINDOW_EVENT_TEXT) {
        end_waiting(window, event->text);
        return;
    }
    if (window->plan_input.waits && event->kind == SDL_WINDOW_EVENT_KEY)
        end_waiting(window, NULL);
    switch (event->kind) {
    case SDL_WINDOW_EVENT_QUIT:
        files_leave(window, LEAVE_QUIT, NULL);
        break;
    case SDL_WINDOW_EVENT_KEY:
        handle_key(window, event);
        break;
    case SDL_WINDOW_EVENT_TEXT:
        type(window, event->text);
        break;
    case SDL_WINDOW_EVENT_MOUSE:
        window->mouse = event->at;
        break;
    case SDL_WINDOW_EVENT_BUTTON:
        window->mouse = event->at;
        window->input.down[event->button] = event->down;
        window->input.twice |= event->twice && event->button == SDL_WINDOW_EVENT_LEFT;
        break;
    case SDL_WINDOW_EVENT_WHEEL:
        window->input.wheel += event->wheel;
        break;
    case SDL_WINDOW_EVENT_FILE:
        files_leave(window, LEAVE_OPEN, event->text);
        break;
    default:
        break;
    }
}

/* Handles events up to a press or release: a press and its release must fall in two frames. */
static void handle_events(Window *window, double wait) {
    SdlWindowEvent event;
    bool waited = window->plan_input.waits;
    for (; sdl_window_next(window->sdl_window, &event, wait); wait = 0) {
        handle_event(window, &event);
        if (event.kind == SDL_WINDOW_EVENT_BUTTON || event.kind == SDL_WINDOW_EVENT_KEY)
            return;
    }
    if (waited && window->plan_input.waits) {
        end_waiting(window, NULL);
        window->plan_input.done = true; /* text that comes later has been handled already */
    }
}

/* Frames ----------------------------------------------------------------------------------------------------------- */

/* Rounds a box to whole pixels, so that pictures are copied without blur. */
static Box snapped(const Window *window, Box box) {
    double unit = window->unit;
    return (Box){{round(box.low.x * unit) / unit, round(box.low.y * unit) / unit},
                 {round(box.high.x * unit) / unit, round(box.high.y * unit) / unit}};
}

static void make_frame(Window *window) {
    Tab *tab = window_tab(window);
    const Frame before = window->frame;
    sdl_window_size(window->sdl_window, &window->width, &window->height);
    window->unit = frame_unit(window->width, window->height, sdl_window_density(window->sdl_window), window->text,
                              window->present);
    Vec2 page = {window->width / window->unit, window->height / window->unit};
    bool plots = window->plots == PLOTS_AUTO ? tab_opens_plots(tab, frame_is_wide(page)) : window->plots == PLOTS_OPEN;
    tab_fit_plots(tab, frame_plots(page));
    window->answer_tall = bars_answer_is_tall(window);
    window->plots_shown = plots;
    bool teaches = lesson_is_shown(window), machine = tab->laboratory->numbers_first;
    bool panel = window->panel && lesson_has_panel(window) && (!window->present || window->drawer);
    plots = plots && !lesson_hides(window) && !tab->trial.session;
    FrameWish wish = {.panel = panel,
                      .handle = lesson_has_panel(window),
                      .card = lesson_width(window, page),
                      .card_line = lesson_line(window),
                      .plots = plots && (!window->present || window->plots == PLOTS_OPEN || (teaches && machine)),
                      .present = window->present,
                      .tall_answer = window->answer_tall,
                      .plot_count = tab->plot_panes_stale && tab->session && !tab->panes.count
                                        ? tab->laboratory->plot_count(tab->session)
                                        : tab->panes.count,
                      .tool_count = tab_editor(tab) && window->editing ? EDIT_TOOLS : 0,
                      .hidden_tools = tab_editor(tab) && !window->editing && !teaches ? EDIT_TOOLS : 0,
                      .split = tab->trial.session,
                      .aspect = tab->aspect};
    window->frame = frame_make(page, &wish);
    if (window->frame.drawer && !window->present && !window->drawer) {
        wish.panel = false;
        window->frame = frame_make(page, &wish);
    }
    tries_take_room(window);
    window->frame.view = snapped(window, window->frame.view);
    window->frame.beside = snapped(window, window->frame.beside);
    for (size_t i = 0; i < window->frame.pane_count; i++)
        window->frame.panes[i] = snapped(window, window->frame.panes[i]);
    canvas_hold_still(window, &before);
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
    lesson_show(window);
    canvas_show(window);
    panel_show(window);
    panel_show_handle(window);
    toolbar_show(window);
    tries_show(window);
    timeline_show(window);
    lesson_mark(window);
    bars_show_strip(window);
    bars_show_message(window);
    dialogs_show(window);
}

static void draw(Window *window, double seconds) {
    Tab *tab = window_tab(window);
    arena_clear(&window->arena);
    make_frame(window);
    bool plan = tab_editor(tab), taught = plan && lesson_is_shown(window); /* a lesson speaks of its names */
    tab_set_cramped(tab, frame_hides_names(&window->frame, plan) && !taught);
    canvas_paint(window);
    paint_gl_screen_begin(window->screen, window->width, window->height, palette_colour(window->theme, ROLE_PAPER));
    if (tab->session && tab->view_layers.paint)
        paint_gl_screen_show(window->screen, tab->view_layers.paint,
                             (int)lround(window->frame.view.low.x * window->unit),
                             (int)lround(window->frame.view.low.y * window->unit));
    if (tab->trial.session && tab->trial_layers.paint)
        paint_gl_screen_show(window->screen, tab->trial_layers.paint,
                             (int)lround(window->frame.beside.low.x * window->unit),
                             (int)lround(window->frame.beside.low.y * window->unit));
    fill_input(window, seconds);
    ui_begin(window->ui, &window->input);
    show_panes(window);
    plan_input_hold_clock(window); /* after the sliders, which still move in the frame of their release */
    ui_end(window->ui);
    window->menu_press.down = window->input.down[SDL_WINDOW_EVENT_LEFT];
    window->menu_press.opened &= window->menu_press.down;
    window->menu_press.mouse = window->mouse;
    window->input.wheel = 0;
    window->input.twice = false;
}

/* True if what is shown has changed or moves by itself. */
static bool is_lively(Window *window) {
    const Tab *tab = window_tab(window);
    bool draws = window->dialog == DIALOG_GALLERY && !gallery_complete(window->gallery);
    return window->dirty || ui_is_busy(window->ui) || benchmark_hurries(window) || window->export || draws ||
           (tab->session && window->plays) || plan_input_animation(tab);
}

/* Between frames --------------------------------------------------------------------------------------------------- */

static void report_trouble(Window *window, Tab *tab) {
    double time = NAN;
    const char *trouble = tab->laboratory->error(tab->session, &time);
    if (!trouble)
        return;
    messages_add(&window->messages, MESSAGE_FAULT, time, "%s", trouble);
    if (isnan(time))
        return;
    RecordSpan span = tab_span(tab);
    player_pause(&tab->player, &span);
    player_seek(&tab->player, time, &span);
}

static void make_sound(Window *window, const Tab *tab, double before) {
    float samples[SOUND_MOST];
    size_t wanted = window->sound ? sound_room(window->sound) : 0;
    wanted = wanted < SOUND_MOST ? wanted : SOUND_MOST;
    if (!wanted)
        return;
    if (tab->player.playing && tab->player.time > before &&
        tab->laboratory->sound(tab->session, before, tab->player.time, samples, wanted))
        sound_feed(window->sound, samples, wanted);
    else
        sound_hush(window->sound);
}

/* Ends an export when its child process has ended. */
static void end_export(Window *window) {
    if (!window->export)
        return;
    const ExportStatus *status = export_update(window->export);
    if (status->stage == EXPORT_RUNNING)
        return;
    if (status->stage == EXPORT_DONE)
        notice_post(window, status->file_count == 1 ? "Written: %s (%zu file)" : "Written: %s (%zu files)",
                    status->folder, status->file_count);
    else
        messages_add(&window->messages, MESSAGE_FAULT, NAN, "%s", status->reason);
    export_end(window->export);
    window->export = NULL;
}

/* Dismisses a note after a while; errors stay until a person dismisses them. */
static void dismiss_old_note(Window *window) {
    const Message *last = messages_last(&window->messages);
    if (last && last->number != window->noted) {
        window->noted = last->number;
        window->noted_at = stopwatch_now();
    }
    if (last && last->kind == MESSAGE_NOTE && last->number > window->dismissed &&
        stopwatch_now() - window->noted_at > NOTE_STAY) {
        window->dismissed = last->number;
        window->dirty = true;
    }
}

/* Shows the same title in the system's frame as in the menu. */
static void show_title(Window *window) {
    char title[WINDOW_TITLE];
    snprintf(title, sizeof title, "%s - clearance", lesson_title(window));
    if (strcmp(title, window->title) == 0)
        return;
    snprintf(window->title, sizeof window->title, "%s", title);
    sdl_window_set_title(window->sdl_window, title);
    window->dirty = true;
}

static void update(Window *window, double seconds) {
    Tab *tab = window_tab(window);
    Player before = tab->player;
    for (size_t i = 0; i < laboratories_count; i++) {
        unsigned changes = tab_update(&window->tabs[i], i == window->current ? seconds : 0);
        if (changes & LABORATORY_ERROR)
            report_trouble(window, &window->tabs[i]);
        window->dirty |= changes && i == window->current;
    }
    window->plays = player_looks_other(&before, &tab->player);
    if (tab->session)
        make_sound(window, tab, before.time);
    end_export(window);
    lesson_update(window);
    if (tab->session)
        show_title(window);
    notice_edit(window);
    notice_search(window);
    autosave_update(window);
    dismiss_old_note(window);
}

/* One turn of the loop. Without a display a script gets a frame in each turn, except while it waits for something to
 * come; on a display it gets the frames that a user would get. */
static void turn(Window *window, Scripted *scripted) {
    bool busy = scripted_is_busy(scripted), lively = is_lively(window);
    bool framed = busy && !scripted->until && !sdl_window_is_seen(window->sdl_window);
    bool hurried = benchmark_hurries(window) || framed;
    bool rests = !lively && !busy, awaits = rests && tab_awaits_answer(window_tab(window));
    double seconds = frame_timer_wait(&window->frame_timer, hurried || awaits), begun = stopwatch_now();
    plan_input_animate(window, seconds);
    handle_events(window, awaits ? ANSWER_WAIT : rests ? IDLE_WAIT : 0);
    double worked = window_tab(window)->worked, time = window_tab(window)->player.time;
    update(window, seconds);
    bool paints = is_lively(window) || framed;
    if (paints) {
        window->dirty = false;
        draw(window, seconds);
    }
    scripted_advance(scripted, window);
    if (!paints)
        return;
    sdl_window_swap(window->sdl_window);
    frame_timer_note(&window->frame_timer, stopwatch_now() - begun, window_tab(window)->worked - worked,
                     window_tab(window)->player.time != time || benchmark_moves(window));
}

/* Beginning and end ------------------------------------------------------------------------------------------------ */

static void apply_preferences(Window *window) {
    const WindowOptions *options = window->options;
    const SettingsPreferences *preferences = &window->settings.preferences;
    window->theme = (Theme)(options->theme >= 0 ? options->theme : preferences->theme);
    window->text = options->text > 0 ? options->text : preferences->text;
    window->reduced = options->reduced_motion || preferences->reduced_motion;
    window->panel = true;
    window->plots = PLOTS_AUTO;
    panel_read_folds(window);
    window->tabs = memory_zeroed(laboratories_count, sizeof *window->tabs);
    for (size_t i = 0; i < laboratories_count; i++) {
        window->tabs[i] = tab_make(laboratories[i].laboratory);
        const SettingsLaboratory *kept = settings_laboratory(&window->settings, window->tabs[i].laboratory->word);
        if (kept->layers >= 0)
            window->tabs[i].layers = (unsigned)kept->layers;
        if (*kept->plots)
            window->tabs[i].plots = kept->plots;
        window->tabs[i].player.power = kept->speed > 0 ? (int)lround(log2(kept->speed)) : 0;
    }
}

static void store_preferences(Window *window) {
    Fault notes = {0};
    for (size_t i = 0; i < laboratories_count; i++) {
        const Tab *tab = &window->tabs[i];
        SettingsLaboratory *kept = settings_laboratory(&window->settings, tab->laboratory->word);
        kept->layers = tab->layers == tab->laboratory->layers_at_first ? -1 : (int)tab->layers;
        kept->plots = tab->plots == tab->laboratory->plots_at_first ? "" : tab->plots;
        kept->speed = player_speed(&tab->player);
    }
    if (!window->fullscreen) {
        window->settings.preferences.width = window->width;
        window->settings.preferences.height = window->height;
    }
    settings_save(&window->settings, &notes);
    fault_clear(&notes);
}

static bool create_sdl_window(Window *window, Fault *fault) {
    const WindowOptions *options = window->options;
    const SettingsPreferences *preferences = &window->settings.preferences;
    bool known = preferences->width >= SETTINGS_WIDTH_LEAST && preferences->height >= SETTINGS_HEIGHT_LEAST;
    int width = options->width > 0 ? options->width : known ? preferences->width : 0;
    int height = options->height > 0 ? options->height : known ? preferences->height : 0;
    window->sdl_window = sdl_window_create(width, height, fault);
    if (!window->sdl_window)
        return false;
    window->screen = paint_gl_screen_create(sdl_window_gl(window->sdl_window));
    if (!sdl_window_is_seen(window->sdl_window))
        paint_gl_screen_leave_window(
            window->screen); /* without a display the window's own framebuffer keeps its first size */
    window->ui = ui_create(window->screen, window->theme,
                           (UiClipboard){sdl_window_clipboard, sdl_window_set_clipboard, window->sdl_window});
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
    dialog_gallery_clear(window);
    files_end(window);
    trace_image_clear(window);
    for (size_t i = 0; i < laboratories_count; i++)
        tab_close(&window->tabs[i], window->screen);
    ui_destroy(window->ui);
    paint_gl_screen_destroy(window->screen);
    sdl_window_destroy(window->sdl_window);
    folder_clear(&window->folder);
    arena_clear(&window->arena);
    frame_timer_clear(&window->frame_timer);
    benchmark_clear(window);
}

static void loop(Window *window, Scripted *scripted) {
    double begun = stopwatch_now();
    while (!window->quit) {
        turn(window, scripted);
        if (benchmark_advance(window, begun))
            window->quit = true;
    }
}

/* Opens the requested file, or the default one. */
static void open_first(Window *window) {
    files_start(window);
    const char *file = window->options->file;
    if (!file || !lesson_open_any(window, file)) {
        size_t dismissed = window->fault_dismissed;
        opening_file(window, laboratory_file(0, &window->arena));
        if (file)
            window->fault_dismissed = dismissed; /* the requested file's faults are shown with the default one */
    }
    if (shipped_places()->missing)
        notice_post(window, "%s", shipped_places()->missing);
}

static int fail(Fault *fault) {
    for (size_t i = 0; i < fault->count; i++)
        fprintf(stderr, "clearance: %s\n", fault->lines[i]);
    fault_clear(fault);
    return 2;
}

int window_run(const WindowOptions *options) {
    memory_return_freed();
    Window *window = memory_zeroed(1, sizeof *window);
    Scripted scripted = {0};
    Fault fault = {0};
    window->options = options;
    settings_open(&window->settings, &fault);
    notice_fault(window, &fault, NAN);
    bool good = !options->script || scripted_open(&scripted, options->script, &fault);
    apply_preferences(window);
    good = good && create_sdl_window(window, &fault);
    int code = good ? 0 : fail(&fault);
    if (good) {
        if (window->settings.preferences.full_screen)
            act_do(window, ACTION_FULLSCREEN, 0, 0);
        open_first(window);
        loop(window, &scripted);
        lesson_close(window); /* its view is not a preference */
        store_preferences(window);
        close_all(window);
        code = window->code;
    }
    scripted_close(&scripted);
    messages_clear(&window->messages);
    settings_close(&window->settings);
    memory_free(window->tabs);
    memory_free(window);
    return code;
}
