#include "window/tries.h"

#include <string.h>

#include "laboratory/house_items.h"
#include "window/act.h"
#include "window/lesson.h"
#include "window/notice.h"
#include "window/plan_input.h"

/* Design points. */
#define HEIGHT 46.0
#define GAP 6.0
#define HEAD_WIDTH 84.0
#define CROSS_WIDTH 34.0
#define LEAST_VIEW 220.0 /* height of the view that remains */
#define LEAST_WIDTH 860.0
#define BUTTON_PAD 24.0
#define SMALL_EDGE 2.0 /* above and below a button in the strip of keys */

#define WATCHED 3.0 /* s, until which somebody has watched */

enum { TRY_WATCH = 1, TRY_NARROW = 2, TRY_SHAKE = 4, TRY_ALL = 7, TRIES = 3 };

typedef struct Try {
    int bit;
    const char *label, *help;
} Try;

static const Try tries[TRIES] = {
    {TRY_WATCH, "1  Watch them leave (Space)", "Watch them leave (Space): Play the run"},
    {TRY_NARROW, "2  Make a door narrower", "Make a door narrower: Select the tightest door and open its width"},
    {TRY_SHAKE, "3  Shake the house (Shift+T)", "Shake the house (Shift+T): Make an earthquake; some furniture falls"},
};

/* The parts of the third that follow the earthquake. */
static const Try try_fix = {
    TRY_SHAKE, "3  Fix one piece to the wall",
    "Fix one piece to the wall: Fix the piece that blocks the way most often, then shake again"};
static const Try try_again = {TRY_SHAKE, "3  Shake again (Shift+T)",
                              "Shake again (Shift+T): Make another earthquake; the fixed piece stays where it is"};

/* True where the strip belongs: in a house from a file, where there is something to try, in a window that a person
 * sees. */
static bool is_due(Window *window) {
    const Tab *tab = window_tab(window);
    bool unseen = window->options->script && !sdl_window_is_seen(window->sdl_window);
    return tab->session && tab->path && tab_editor(tab) && !lesson_is_shown(window) && !window->present && !unseen &&
           window->settings.state.tried != TRY_ALL;
}

/* True if the strip of keys, in a small window, is free for the next thing to try. */
static bool has_free_strip(Window *window) {
    size_t faults;
    return window->frame.compact && box_height(window->frame.strip) > 0 && !plan_input_listens(window) &&
           !window->export && !notice_shown(window, &faults);
}

/* True if a piece that falls in the file's house is fixed to the wall. */
static bool has_fixed(const Tab *tab) {
    size_t count;
    const PanelParameter *parameters = tab->laboratory->parameters(tab->session, &count);
    for (size_t i = 0; i < count; i++) {
        const char *end = strrchr(parameters[i].name, '.');
        if (end && strcmp(end, ".topples") == 0 && parameters[i].value != parameters[i].initial &&
            parameters[i].value == TOPPLE_NO)
            return true;
    }
    return false;
}

/* Returns the button of the panel that fixes a piece to the wall; NULL: there is none. `known`: the panel tells which
 * pieces stop somebody. */
static const PanelRow *fix_row(const Tab *tab, bool *known) {
    size_t count;
    const PanelRow *rows = tab->laboratory->rows(tab->session, &count);
    *known = false;
    for (size_t i = 0; i < count; i++) {
        *known |= rows[i].row.kind == ROW_HEADING && strcmp(rows[i].row.cells[0], HOUSE_FIX_HEADING) == 0;
        if (rows[i].act == ROW_ACT_FIX)
            return &rows[i];
    }
    return NULL;
}

/* Returns a thing to try, in the part that is due. */
static const Try *try_now(const Window *window, const Tab *tab, int index) {
    EditorShake shake;
    if (tries[index].bit != TRY_SHAKE || window->settings.state.tried & TRY_SHAKE)
        return &tries[index];
    if (tab->fixed_in)
        return &try_again;
    return editor_last_shake(tab_editor(tab), &shake) ? &try_fix : &tries[index];
}

/* Returns the width that the button of a thing to try needs. */
static double button_width(Window *window, const Try *try) {
    return ui_extent(window->ui, UI_BOLD, try->label).x + BUTTON_PAD;
}

/* Returns the first thing that has not been tried; TRIES: all have. */
static int next_try(const Window *window) {
    int next = 0;
    while (next < TRIES && window->settings.state.tried & tries[next].bit)
        next++;
    return next;
}

static void cut(Box *box, double foot) {
    box->high.y = box->high.y > foot && box->low.y < foot ? foot : box->high.y;
}

void tries_take_room(Window *window) {
    Frame *frame = &window->frame;
    double foot = frame->timeline.low.y - HEIGHT, right = real_max(frame->view.high.x, frame->beside.high.x);
    window->tries = (Box){{0, 0}, {0, 0}};
    for (size_t i = 0; i < frame->pane_count; i++)
        right = real_max(right, frame->panes[i].high.x);
    if (!is_due(window))
        return;
    if (right < LEAST_WIDTH || foot - frame->view.low.y < LEAST_VIEW) {
        const Try *due = try_now(window, window_tab(window), next_try(window));
        double width = 2 * GAP + HEAD_WIDTH + button_width(window, due) + GAP + CROSS_WIDTH;
        if (has_free_strip(window) && width <= box_width(frame->strip))
            window->tries = (Box){frame->strip.low, {frame->strip.low.x + width, frame->strip.high.y}};
        return;
    }
    cut(&frame->view, foot);
    cut(&frame->beside, foot);
    cut(&frame->toolbar, foot);
    if (frame->drawer) {
        cut(&frame->panel, foot);
        cut(&frame->handle, foot);
        right = frame->page.x;
    }
    for (size_t i = 0; i < frame->pane_count; i++)
        cut(&frame->panes[i], foot);
    window->tries = (Box){{0, foot}, {right, frame->timeline.low.y}};
}

/* True if the parameter is the width of a door. */
static bool is_door_width(const PanelParameter *parameter) {
    const char *end = strrchr(parameter->name, '.');
    return strncmp(parameter->name, "door.", 5) == 0 && end && strcmp(end, ".width") == 0;
}

/* True if a door is narrower than in the file. */
static bool has_narrowed(const Tab *tab) {
    size_t count;
    const PanelParameter *parameters = tab->laboratory->parameters(tab->session, &count);
    for (size_t i = 0; i < count; i++)
        if (is_door_width(&parameters[i]) && parameters[i].value < parameters[i].initial)
            return true;
    return false;
}

/* Selects the door that the headline names, else the narrowest one, and gives its width the focus. */
static void select_door(Window *window, Tab *tab) {
    size_t count, index = 0;
    Item chosen = {0};
    double least = HUGE_VAL;
    const PanelRow *first = tab_first_place(tab);
    const char *told = text_in_arena(&window->arena, "%s", first && first->row.cells[0] ? first->row.cells[0] : "");
    const PanelParameter *parameters = tab->laboratory->parameters(tab->session, &count);
    for (size_t i = 0; i < count; i++) {
        if (!is_door_width(&parameters[i]))
            continue;
        Item door = {HOUSE_DOOR, index++};
        bool named = strcmp(tab->laboratory->item_name(tab->session, door), told) == 0;
        if (named || parameters[i].value < least)
            chosen = door;
        least = named ? -HUGE_VAL : fmin(least, parameters[i].value);
    }
    if (!chosen.kind) {
        notice_post(window, "This house has no door: add one with the door tool (D), or open the default house");
        ui_focus(window->ui, "view");
        return;
    }
    tab_select(tab, chosen);
    window->panel = window->drawer = true;
    window->narrowing = NARROWING_OPEN;
    ui_focus_number(window->ui, "panel");
}

/* Fixes the piece to the wall that the panel names, which it shows. */
static void fix_piece(Window *window, Tab *tab) {
    bool known;
    Fault fault = {0};
    const PanelRow *row = fix_row(tab, &known);
    window->panel = window->drawer = true;
    ui_focus(window->ui, "view");
    if (row)
        editor_fix_to_wall(tab_editor(tab), row->item, &fault);
    else
        notice_post(window, known
                                ? "No piece is worth fixing to the wall: in no earthquake does one stop anybody"
                                : "100 earthquakes are being worked out: wait until the panel names the piece to fix");
    notice_fault(window, &fault, NAN);
}

static void begin(Window *window, Tab *tab, const Try *try) {
    if (try->bit == TRY_WATCH) {
        tab_seek(tab, 0);
        tab->player.playing = true;
    } else if (try->bit == TRY_NARROW) {
        select_door(window, tab);
    } else if (try == &try_fix) {
        fix_piece(window, tab);
    } else {
        act_do(window, ACTION_SHAKE, 0, 0);
    }
    window->dirty = true;
}

/* True once a piece was fixed to the wall after an earthquake, and another earthquake followed; or after an earthquake
 * of a house in which no piece is worth fixing, or of one with so many people that none is named. */
static bool has_shaken(Tab *tab) {
    EditorShake shake;
    bool shaken = editor_last_shake(tab_editor(tab), &shake), known;
    tab->shaken_in = shaken ? shake.seed : 0;
    if (!has_fixed(tab))
        tab->fixed_in = 0;
    else if (!tab->fixed_in)
        tab->fixed_in = tab->shaken_in;
    if (!shaken || tab->fixed_in)
        return shaken && shake.seed > tab->fixed_in;
    return tab_opens_plots(tab, false) || (!fix_row(tab, &known) && known);
}

static void note_done(Window *window, Tab *tab) {
    int *tried = &window->settings.state.tried;
    if (tab->player.time > WATCHED && tab->player.playing)
        *tried |= TRY_WATCH;
    if (!(*tried & TRY_NARROW) && has_narrowed(tab))
        *tried |= TRY_NARROW;
    if (!(*tried & TRY_SHAKE) && has_shaken(tab))
        *tried |= TRY_SHAKE;
}

/* Gives the focus back to the view, where Shift+T is a key, once a width was typed or dragged. Arrow keys keep it,
 * since they may go on. */
static void end_narrowing(Window *window) {
    bool busy = ui_types(window->ui) || window->input.down[SDL_WINDOW_EVENT_LEFT];
    if (window->narrowing == NARROWING_OPEN && busy)
        window->narrowing = NARROWING_CHANGED;
    if (window->narrowing != NARROWING_CHANGED || busy || !(window->settings.state.tried & TRY_NARROW))
        return;
    window->narrowing = NARROWING_NONE;
    if (strcmp(ui_focus_pane(window->ui), "panel") == 0)
        ui_focus(window->ui, "view");
}

static void show_try(Window *window, Tab *tab, int index, Box box, bool due) {
    const Try *try = try_now(window, tab, index);
    bool done = window->settings.state.tried & try->bit;
    UiButton button = {.id = text_in_arena(&window->arena, "try %d", index),
                       .label = text_in_arena(&window->arena, "%s%s", done ? "\u2713 " : "", try->label),
                       .help = try->help,
                       .chosen = due && !done};
    ui_at(window->ui, box);
    if (ui_button(window->ui, &button))
        begin(window, tab, try);
}

static void show_strip(Window *window, Tab *tab, Box strip) {
    bool small = strip.low.y >= window->frame.strip.low.y;
    int due = next_try(window), count = small ? 1 : TRIES;
    double edge = small ? SMALL_EDGE : GAP, top = strip.low.y + edge, foot = strip.high.y - edge;
    double left = strip.low.x + 2 * GAP + HEAD_WIDTH, width = (strip.high.x - CROSS_WIDTH - GAP - left) / count;
    ui_pane_begin(window->ui, &(UiPane){.name = "tries", .box = strip, .ground = ROLE_SHADE});
    ui_draw_text(window->ui, UI_BOLD, ROLE_TEXT, vec2(strip.low.x + 2 * GAP, (strip.low.y + strip.high.y) / 2), 0,
                 "Try this");
    for (int i = 0; i < count; i++, left += width) {
        int index = small ? due : i;
        show_try(window, tab, index, (Box){{left, top}, {left + width - GAP, foot}}, index == due);
    }
    ui_at(window->ui, (Box){{strip.high.x - CROSS_WIDTH, top}, {strip.high.x - GAP, foot}});
    if (ui_button(window->ui, &(UiButton){.id = "no tries",
                                          .label = "\u00d7",
                                          .help = "Close: Hide these for good; Help > Try this brings them back"}))
        window->settings.state.tried = TRY_ALL;
    ui_pane_end(window->ui);
}

void tries_show(Window *window) {
    Tab *tab = window_tab(window);
    if (!is_due(window))
        return;
    if (box_width(window->tries) > 0)
        show_strip(window, tab, window->tries);
    note_done(window, tab);
    end_narrowing(window);
}
