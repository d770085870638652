#include "window/timeline.h"

#include <math.h>
#include <string.h>

#include "window/act.h"
#include "window/lesson.h"

/* Design points. */
#define MARGIN 8.0
#define GAP 6.0
#define BUTTON_PAD 18.0
#define TRACK_HEIGHT 10.0
#define HEAD_WIDTH 10.0
#define HEAD_HEIGHT 26.0
#define TICK_HEIGHT 16.0
#define LEAST_TRACK 90.0
#define LEAST_BUTTON 30.0
#define LABELLED_BAR 560.0 /* least width of a bar whose button for editing has a word */
#define NOTE_STEP 10.0
#define CLOCK_WIDEST "00000.0 s"

static Vec2 middle_of(Box box) {
    return vec2_scale(vec2_add(box.low, box.high), 0.5);
}

typedef struct Row {
    Window *window;
    Box bar;
    double left, right; /* edges of the free part */
    bool stale;         /* the answer is being worked out: there is nothing to play */
} Row;

/* Adds a button for an action at the left or right end of the free part. */
static void add_button(Row *row, Action action, const char *label, bool chosen, bool at_right) {
    bool waits = action == ACTION_PLAY && row->stale;
    double pad = row->window->frame.compact ? BUTTON_PAD / 2 : BUTTON_PAD;
    const char *widest = action == ACTION_PLAY ? "Ready soon" : label; /* the width does not change with the label */
    double width = fmax(ui_extent(row->window->ui, UI_BOLD, widest).x + pad, LEAST_BUTTON);
    double left = at_right ? row->right - width : row->left;
    ui_at(row->window->ui, (Box){{left, row->bar.low.y + MARGIN}, {left + width, row->bar.high.y - MARGIN}});
    UiButton button = {.id = keys_row(action).name,
                       .label = label,
                       .help = keys_help(&row->window->arena, action),
                       .chosen = chosen && !waits,
                       .disabled = waits};
    if (ui_button(row->window->ui, &button))
        act_do(row->window, action, 0, 0);
    if (at_right)
        row->right = left - GAP;
    else
        row->left = left + width + GAP;
}

/* Returns the label of the button that opens and closes the tools: the view of a small window has no room for it. */
static const char *edit_label(const Row *row) {
    bool narrow = box_width(row->bar) < LABELLED_BAR;
    return row->window->editing ? narrow ? "\u2713" : "\u2713 Done" : narrow ? "\u270e" : "\u270e Edit";
}

/* Adds a text whose place does not depend on its length. */
static void add_text(Row *row, UiTextStyle size, const char *text, const char *widest, bool at_right) {
    double width = fmax(ui_extent(row->window->ui, size, text).x, ui_extent(row->window->ui, size, widest).x);
    double left = at_right ? row->right - width : row->left, y = middle_of(row->bar).y;
    double at = at_right ? left + width / 2 : left;
    ui_draw_text(row->window->ui, size, ROLE_TEXT, vec2(at, y), at_right ? 0.5 : 0, text);
    if (at_right)
        row->right = left - GAP;
    else
        row->left = left + width + 2 * GAP;
}

/* Adds the clock, smaller where it has no room, and then without its first parts: the time, which comes last, is whole.
 */
static void add_clock(Row *row, const char *clock) {
    Ui *ui = row->window->ui;
    const UiTextStyle sizes[] = {row->window->frame.compact ? UI_BOLD : UI_CLOCK, UI_BODY, UI_SMALL};
    double room = row->right - row->left;
    size_t i = 0;
    while (i + 1 < sizeof sizes / sizeof *sizes && ui_extent(ui, sizes[i], clock).x > room)
        i++;
    for (const char *rest = strstr(clock, ", "); rest && ui_extent(ui, sizes[i], clock).x > room;
         rest = strstr(clock, ", "))
        clock = rest + strlen(", ");
    add_text(row, sizes[i], clock, row->window->note_crowded ? "" : CLOCK_WIDEST, false);
}

/* Adds the speed between its keys, if there is room. */
static void add_speed(Row *row, const Player *player) {
    Window *window = row->window;
    const char *widest = window->frame.compact ? "16x" : "16x (0.98x)";
    if (row->right - row->left < 2 * (LEAST_BUTTON + GAP) + ui_extent(window->ui, UI_BODY, widest).x)
        return;
    add_button(row, ACTION_FASTER, "+", false, true);
    add_text(row, UI_BODY, player_speed_text(player, &window->arena), widest, true);
    add_button(row, ACTION_SLOWER, "-", false, true);
}

/* The line --------------------------------------------------------------------------------------------------------- */

typedef struct Track {
    Box box;
    RecordSpan span;
} Track;

static double place_of(const Track *track, double time) {
    double length = track->span.end - track->span.begin;
    double part = length > 0 ? (time - track->span.begin) / length : 0;
    return track->box.low.x + fmin(fmax(part, 0), 1) * box_width(track->box);
}

static double time_at(const Track *track, double x) {
    double part = fmin(fmax((x - track->box.low.x) / box_width(track->box), 0), 1);
    return track->span.begin + part * (track->span.end - track->span.begin);
}

/* Draws the marks, which differ by shape: a contact is a line below, an exit a diamond, a change a box, an error a line
 * across. */
static void show_ticks(Ui *ui, const Track *track, const Tab *tab) {
    size_t count;
    const TimelineMark *ticks = tab->laboratory->marks(tab->session, &count);
    double y = middle_of(track->box).y;
    for (size_t i = 0; i < count; i++) {
        if (ticks[i].time < track->span.begin || ticks[i].time > track->span.end)
            continue;
        double x = place_of(track, ticks[i].time);
        if (ticks[i].kind == TIMELINE_CONTACT)
            ui_draw_line(ui, vec2(x, y + TRACK_HEIGHT / 2), vec2(x, y + TICK_HEIGHT), ROLE_IMPACT, 2);
        else if (ticks[i].kind == TIMELINE_EXIT)
            ui_draw_diamond(ui, vec2(x, y - TICK_HEIGHT + 2), 5, ROLE_EXIT_TAG);
        else if (ticks[i].kind == TIMELINE_CHANGE)
            ui_draw_box(ui, (Box){{x - 3, y - TICK_HEIGHT}, {x + 3, y - TICK_HEIGHT + 6}}, ROLE_LOCUS_SECOND, 1);
        else
            ui_draw_line(ui, vec2(x, y - TICK_HEIGHT), vec2(x, y + TICK_HEIGHT), ROLE_ERROR, 3);
    }
}

static void show_marks(Ui *ui, const Track *track, const Player *player) {
    if (!player->loops)
        return;
    double from = place_of(track, isnan(player->in) ? track->span.begin : player->in);
    double to = place_of(track, isnan(player->out) ? track->span.end : player->out), y = middle_of(track->box).y;
    ui_draw_line(ui, vec2(from, y + TICK_HEIGHT), vec2(to, y + TICK_HEIGHT), ROLE_LOCUS_SECOND, 3);
    ui_draw_line(ui, vec2(from, y - TICK_HEIGHT), vec2(from, y + TICK_HEIGHT), ROLE_LOCUS_SECOND, 2);
    ui_draw_line(ui, vec2(to, y - TICK_HEIGHT), vec2(to, y + TICK_HEIGHT), ROLE_LOCUS_SECOND, 2);
}

static void show_track(Window *window, Tab *tab, Box box) {
    Ui *ui = window->ui;
    Track track = {box, tab_span(tab)};
    double y = middle_of(box).y, head = place_of(&track, tab->player.time);
    Box line = {{box.low.x, y - TRACK_HEIGHT / 2}, {box.high.x, y + TRACK_HEIGHT / 2}};
    ui_draw_box(ui, line, ROLE_FURNITURE_LINE, 0.45);
    ui_draw_box(ui, (Box){line.low, {head, line.high.y}}, ROLE_CHAIR, 1);
    show_marks(ui, &track, &tab->player);
    show_ticks(ui, &track, tab);
    ui_draw_box(ui, (Box){{head - HEAD_WIDTH / 2, y - HEAD_HEIGHT / 2}, {head + HEAD_WIDTH / 2, y + HEAD_HEIGHT / 2}},
                ROLE_TEXT, 1);
    UiGrab grab = ui_grab(ui, "track", box_expand(box, HEAD_WIDTH / 2));
    if (grab.pressed || grab.held) {
        tab_seek(tab, time_at(&track, grab.at.x));
        window->dirty = true;
    }
}

/* Returns the width of the widest word of a text. */
static double widest_word(const Row *row, const char *text) {
    double widest = 0;
    for (const char *at = text; *at; at += strspn(at, " ")) {
        size_t length = strcspn(at, " ");
        const char *word = text_in_arena(&row->window->arena, "%.*s", (int)length, at);
        widest = fmax(widest, ui_extent(row->window->ui, UI_SMALL, word).x + 1);
        at += length;
    }
    return widest;
}

/* Shows the note that has no room in the view, in place of the speed, and as narrow as the bar's height allows, so that
 * the track keeps its place; false: it has no room here, either. */
static bool show_crowded_note(Row *row, const char *note) {
    Ui *ui = row->window->ui;
    double most = fmax(row->right - row->left - GAP, 1), least = widest_word(row, note), y = middle_of(row->bar).y;
    double width = fmin(least, most);
    while (width < most && ui_text_height(ui, UI_SMALL, note, width) > box_height(row->bar))
        width = fmin(width + NOTE_STEP, most);
    double height = ui_text_height(ui, UI_SMALL, note, width);
    if (height > box_height(row->bar))
        return false;
    ui_at(ui, (Box){{row->left, y - height / 2}, {row->left + width, y + height / 2}});
    ui_text(ui, UI_SMALL, ROLE_DIM_TEXT, note);
    row->left += width + GAP;
    return true;
}

void timeline_show(Window *window) {
    Tab *tab = window_tab(window);
    Row row = {window, window->frame.timeline, MARGIN, window->frame.timeline.high.x - MARGIN, false};
    /* a record that grows by itself can be played before its answer is known */
    row.stale = tab->session && tab->laboratory->answer(tab->session).stale && !tab_span(tab).endless;
    bool compact = window->frame.compact;
    ui_pane_begin(window->ui, &(UiPane){.name = "timeline", .box = row.bar, .ground = ROLE_SHADE, .stop = true});
    if (tab->session) {
        if (!compact)
            add_button(&row, ACTION_START, "|<", false, false);
        if (!compact)
            add_button(&row, ACTION_STEP_BACK, "<", false, false);
        add_button(&row, ACTION_PLAY,
                   lesson_hides(window)  ? "Guess first"
                   : row.stale           ? "Ready soon"
                   : tab->player.playing ? "Pause"
                                         : "Play",
                   true, false);
        if (!compact)
            add_button(&row, ACTION_STEP, ">", false, false);
        if (!compact)
            add_button(&row, ACTION_LOOP, "Loop", tab->player.loops, false);
        if (compact && tab_editor(tab))
            add_button(&row, ACTION_EDIT_PLAN, edit_label(&row), window->editing, false);
        add_clock(&row, tab->laboratory->clock(tab->session, tab->player.time));
        if (!compact)
            add_button(&row, ACTION_NOW, "Now", false, true);
        bool noted = window->note_crowded && show_crowded_note(&row, tab->laboratory->note(tab->session));
        if (!noted)
            add_speed(&row, &tab->player);
        if (row.right - row.left > LEAST_TRACK && !lesson_hides(window))
            show_track(window, tab, (Box){{row.left + GAP, row.bar.low.y}, {row.right - GAP, row.bar.high.y}});
    }
    ui_pane_end(window->ui);
}
