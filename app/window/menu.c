#include "window/menu.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "window/act.h"
#include "window/dialog_pane.h"
#include "window/files.h"
#include "window/menu_reason.h"
#include "window/plan_input.h"

/* Design points. */
#define WIDTH 376.0
#define ROW 28.0
#define MARGIN 6.0
#define END_MARGIN 8.0 /* above the first and below the last row, as in every pane */
#define WORD_PAD 20.0
#define COMPACT_PAD 12.0 /* of a word in an open menu */
#define GROUP_GAP 9.0    /* with a line, between two groups of rows */

enum { RECENT_SHOWN = 5 };

/* True if the bar has the menu: that of the tools belongs to a toolbar. */
static bool has_menu(Window *window, KeyMenu menu) {
    return menu != MENU_TOOLS || (tab_editor(window_tab(window)) && window->editing) || window->frame.compact;
}

static double word_width(Window *window, KeyMenu menu) {
    return ui_extent(window->ui, UI_BODY, keys_menus[menu]).x + WORD_PAD;
}

static Box word_box(Window *window, KeyMenu wanted) {
    Box bar = window->frame.menu;
    double left = bar.low.x + 2;
    for (KeyMenu menu = MENU_FILE; menu < wanted && !window->frame.compact; menu++)
        left += has_menu(window, menu) ? word_width(window, menu) : 0;
    return (Box){{left, bar.low.y}, {left + word_width(window, wanted), bar.high.y}};
}

static void open_menu(Window *window, KeyMenu menu) {
    window->menu = menu;
    window->menu_seen = MENUS;
    dialog_pane_show(window, DIALOG_MENU);
}

static Vec2 pointer_of(const Window *window) {
    return vec2_scale(window->mouse, 1 / window->unit);
}

/* The bar ---------------------------------------------------------------------------------------------------------- */

/* Returns the menu whose word the pointer is on; MENUS: none. */
static KeyMenu pointed_menu(Window *window) {
    for (KeyMenu menu = MENU_FILE; menu < MENUS && !window->frame.compact; menu++)
        if (has_menu(window, menu) && box_holds(word_box(window, menu), pointer_of(window)))
            return menu;
    return MENUS;
}

double menu_show_bar(Window *window, Box bar) {
    double right = bar.low.x + 2;
    if (window->frame.compact) {
        UiButton button = {.label = "Menu", .help = keys_help(&window->arena, ACTION_MENU), .plain = true};
        right += ui_extent(window->ui, UI_BODY, button.label).x + WORD_PAD;
        ui_at(window->ui, (Box){{bar.low.x + 2, bar.low.y + 2}, {right, bar.high.y - 2}});
        if (ui_button(window->ui, &button))
            open_menu(window, MENU_FILE);
        return right;
    }
    for (KeyMenu menu = MENU_FILE; menu < MENUS; menu++) {
        if (!has_menu(window, menu))
            continue;
        Box box = word_box(window, menu);
        UiButton button = {
            .label = keys_menus[menu], .plain = true, .chosen = window->dialog == DIALOG_MENU && window->menu == menu};
        ui_at(window->ui, (Box){{box.low.x, box.low.y + 1}, {box.high.x, box.high.y - 1}});
        if (ui_button(window->ui, &button))
            open_menu(window, menu);
        right = box.high.x;
    }
    bool pressed = window->input.down[SDL_WINDOW_EVENT_LEFT] && !window->menu_press.down;
    if (pressed && window->dialog == DIALOG_NONE && pointed_menu(window) < MENUS) {
        open_menu(window, pointed_menu(window));
        window->menu_press.opened = true;
    }
    return right;
}

/* Rows ------------------------------------------------------------------------------------------------------------- */

static bool is_there(const KeyRow *row, KeyMenu menu) {
    return row->menu == menu && row->name;
}

/* True if the row's key has this meaning while the view has the focus. */
static bool is_meant(Window *window, const KeyRow *row) {
    int32_t key;
    int mods;
    keys_read(row->key, &key, &mods);
    if (row->place != KEY_CANVAS && row->place != KEY_TIMELINE)
        return true;
    return keys_find(key, mods, tab_editor(window_tab(window)) ? KEY_PLAN : KEY_VIEW, true) == row->action;
}

/* Returns the key of a row, with the place where it has this meaning if that is not the view; NULL: none. */
static const char *key_of(Window *window, const KeyRow *row) {
    if (is_meant(window, row))
        return row->key;
    return row->place == KEY_TIMELINE ? text_in_arena(&window->arena, "timeline: %s", row->key) : NULL;
}

/* True if the action is a state that is on. */
static bool is_on(Window *window, Action action) {
    const Tab *tab = window_tab(window);
    switch (action) {
    case ACTION_PANEL:
        return box_width(window->frame.panel) > 0;
    case ACTION_PLOTS:
        return window->frame.pane_count > 0;
    case ACTION_EDIT_PLAN:
        return window->editing;
    case ACTION_PRESENT:
        return window->present;
    case ACTION_FULLSCREEN:
        return window->fullscreen;
    case ACTION_SNAP:
        return !window->plan_input.free;
    case ACTION_LOOP:
        return tab->player.loops;
    case ACTION_FOLLOW:
        return tab->follows;
    case ACTION_DRIVERS:
        return tab_layer(tab, "drivers") < tab->laboratory->layer_count &&
               tab_layers(tab) & 1u << tab_layer(tab, "drivers");
    case ACTION_RAISED:
        return tab->camera.kind == VIEW_RAISED;
    case ACTION_SOUND:
        return window->sound != NULL;
    default:
        return false;
    }
}

/* Returns the place of what is next in a menu, with the margins of its rows. */
static Box next_box(Window *window, Box pane, double height) {
    Box box = ui_space(window->ui, height);
    return (Box){{pane.low.x + 2 * MARGIN, box.low.y}, {pane.high.x - 2 * MARGIN, box.high.y}};
}

/* Draws the line between two groups. */
static void show_group_line(Window *window, Box pane) {
    Box box = next_box(window, pane, GROUP_GAP);
    double y = (box.low.y + box.high.y) / 2;
    ui_draw_line(window->ui, vec2(box.low.x, y), vec2(box.high.x, y), ROLE_GRID, 1.5);
}

/* Shows a row; true if it was chosen: by a click, a key, or where a press that opened the menu ends. */
static bool show_row(Window *window, Box box, const UiRow *row) {
    ui_at(window->ui, box);
    bool chosen = ui_list_row(window->ui, row);
    bool ends = window->menu_press.down && !window->input.down[SDL_WINDOW_EVENT_LEFT] && window->menu_press.opened;
    return row->usable && (chosen || (ends && box_holds(box, pointer_of(window))));
}

static bool show_action(Window *window, Box box, const KeyRow *row) {
    bool steps = row->action == ACTION_UNDO || row->action == ACTION_REDO;
    const char *reason = menu_reason_of(window, row->action);
    const char *name = steps ? plan_input_step_label(window, row->action) : row->name;
    UiRow shown = {
        .id = row->name,
        .shape = ROW_PLAIN,
        .cells = {text_in_arena(&window->arena, "%s%s", is_on(window, row->action) ? "\u2713 " : "    ", name),
                  key_of(window, row)},
        .help = reason,
        .dim = reason,
        .usable = !reason};
    if (!show_row(window, box, &shown))
        return false;
    dialog_pane_close(window);
    act_do(window, row->action, 0, 0);
    return true;
}

static bool show_recent(Window *window, Box box, const char *path) {
    const char *name = strrchr(path, '/');
    UiRow shown = {.id = path,
                   .shape = ROW_PLAIN,
                   .cells = {text_in_arena(&window->arena, "    %s", name ? name + 1 : path)},
                   .help = path,
                   .usable = true};
    if (!show_row(window, box, &shown))
        return false;
    dialog_pane_close(window);
    files_leave(window, LEAVE_OPEN, path);
    return true;
}

static size_t recent_files(Window *window, const char **paths) {
    size_t count = window->menu == MENU_FILE ? settings_recent(&window->settings, paths) : 0;
    return count < RECENT_SHOWN ? count : RECENT_SHOWN;
}

/* The open menu ---------------------------------------------------------------------------------------------------- */

static const char *pane_name(Window *window) {
    return text_in_arena(&window->arena, "menu %d", (int)window->menu);
}

/* Returns the height of the lines between the groups of a menu. */
static double gaps_of(KeyMenu menu, size_t recent) {
    bool any = false;
    double gaps = recent ? GROUP_GAP : 0;
    for (size_t i = 0; i < keys_count(); i++) {
        KeyRow row = keys_at(i);
        if (!is_there(&row, menu))
            continue;
        gaps += any && keys_begins_group(row.action) ? GROUP_GAP : 0;
        any = true;
    }
    return gaps;
}

static double height_of(Window *window) {
    const char *paths[SETTINGS_RECENT_MOST];
    size_t recent = recent_files(window, paths), rows = recent + window->frame.compact;
    for (size_t i = 0; i < keys_count(); i++) {
        KeyRow row = keys_at(i);
        rows += is_there(&row, window->menu);
    }
    return (double)rows * ROW + gaps_of(window->menu, recent) + 2 * END_MARGIN + (window->frame.compact ? MARGIN : 0);
}

Box menu_box(Window *window) {
    double left = fmin(word_box(window, window->menu).low.x, fmax(0, window->frame.page.x - WIDTH));
    double top = window->frame.menu.high.y, foot = top + height_of(window);
    return (Box){{left, top}, {fmin(left + WIDTH, window->frame.page.x), fmin(foot, window->frame.page.y)}};
}

bool menu_scrolls(Window *window) {
    return window->frame.menu.high.y + height_of(window) > window->frame.page.y;
}

/* In a small window the other menus are words at the top of the open one. */
static void show_words(Window *window, Box box) {
    Box row = next_box(window, box, ROW);
    double left = box.low.x + MARGIN;
    for (KeyMenu menu = MENU_FILE; menu < MENUS; menu++) {
        double right = left + ui_extent(window->ui, UI_BODY, keys_menus[menu]).x + COMPACT_PAD;
        ui_at(window->ui, (Box){{left, row.low.y}, {right, row.high.y}});
        if (ui_button(window->ui,
                      &(UiButton){.label = keys_menus[menu], .plain = true, .chosen = menu == window->menu}))
            window->menu = menu;
        left = right;
    }
    ui_gap(window->ui, MARGIN);
}

static bool show_rows(Window *window, Box box) {
    const char *paths[SETTINGS_RECENT_MOST];
    size_t recent = recent_files(window, paths), shown = 0;
    for (size_t i = 0; i < keys_count(); i++) {
        KeyRow row = keys_at(i);
        if (!is_there(&row, window->menu))
            continue;
        if (shown++ && keys_begins_group(row.action))
            show_group_line(window, box);
        if (show_action(window, next_box(window, box, ROW), &row))
            return true;
    }
    if (recent)
        show_group_line(window, box);
    for (size_t i = 0; i < recent; i++)
        if (show_recent(window, next_box(window, box, ROW), paths[i]))
            return true;
    ui_gap(window->ui, END_MARGIN);
    return false;
}

void menu_show(Window *window) {
    KeyMenu pointed = pointed_menu(window);
    if (pointed < MENUS && vec2_distance(window->mouse, window->menu_press.mouse) > 0) /* keys change it, too */
        window->menu = pointed;
    Box box = menu_box(window);
    UiPane pane = {
        .name = pane_name(window), .box = box, .ground = ROLE_PANEL, .scrolls = true, .modal = true, .clear = true};
    bool pressed = window->input.down[SDL_WINDOW_EVENT_LEFT] && !window->menu_press.down;
    bool inside = box_holds(box, pointer_of(window)), on_bar = pointed < MENUS;
    ui_pane_begin(window->ui, &pane);
    if (window->frame.compact)
        show_words(window, box);
    if (window->frame.compact && window->menu_seen != window->menu)
        ui_focus_on(window->ui, pane.name, keys_menus[window->menu]);
    window->menu_seen = window->menu;
    bool done = show_rows(window, box);
    ui_pane_end(window->ui);
    if (!done && pressed && !inside && !(on_bar && window->menu_press.opened))
        dialog_pane_close(window);
}

void menu_walk(Window *window, int across, int down) {
    if (down)
        ui_key(window->ui, down > 0 ? UI_KEY_NEXT : UI_KEY_PREVIOUS, false, false);
    for (KeyMenu menu = window->menu; across;) {
        menu = menu + across >= MENUS ? MENU_FILE : menu + across < MENU_FILE ? MENUS - 1 : menu + across;
        if (!has_menu(window, menu))
            continue;
        window->menu = menu;
        break;
    }
    window->dirty = true;
}

bool menu_jump(Window *window, char letter) {
    const char *pane = pane_name(window), *first = NULL, *next = NULL;
    bool behind = false;
    for (size_t i = 0; i < keys_count(); i++) {
        KeyRow row = keys_at(i);
        if (!is_there(&row, window->menu) || menu_reason_of(window, row.action))
            continue;
        if (tolower((unsigned char)*row.name) == letter) {
            first = first ? first : row.name;
            next = !next && behind ? row.name : next;
        }
        behind |= ui_focus_is_on(window->ui, pane, row.name);
    }
    next = next ? next : first;
    return next && ui_focus_on(window->ui, pane, next);
}

const char *menu_focused(Window *window) {
    for (size_t i = 0; i < keys_count(); i++) {
        KeyRow row = keys_at(i);
        if (is_there(&row, window->menu) && ui_focus_is_on(window->ui, pane_name(window), row.name))
            return row.name;
    }
    return "";
}
