#include "window/bars.h"

#include <math.h>
#include <string.h>

#include "base/stop.h"
#include "base/stopwatch.h"
#include "window/act.h"
#include "window/lesson.h"
#include "window/menu.h"
#include "window/menu_reason.h"
#include "window/notice.h"
#include "window/plan_input.h"
#include "window/toolbar.h"

/* Design points. */
#define TWO_LINES 1.8 /* widths that a text of two lines may take: lines break between words */
#define MARGIN 14.0
#define LINES_APART 0.75 /* times the height of a detail, from it to the note below it: lines have empty edges */
#define NOTE_ROOM 3.0    /* that a line of detail leaves below it */
#define GAP 12.0
#define BUTTON_PAD 20.0
#define SHOW_HEIGHT 38.0
#define PROGRESS_HEIGHT 4.0
#define MESSAGE_HEIGHT 34.0
#define SIGNS 90.0 /* of a fault: its sign, and how many there are */
#define KEY_PAD 5.0
#define STOP_AFTER 1.0 /* s */

/* Where the lines stand in a tall answer, of its height from its edges. */
#define TALL_HEAD 0.36
#define TALL_FOOT 0.24

enum { RING_POINTS = 24 };

static Vec2 middle_of(Box box) {
    return vec2_scale(vec2_add(box.low, box.high), 0.5);
}

/* Adds a button as wide as its label at `left`, and returns its right edge. */
static double add_button(Window *window, double left, Box bar, const UiButton *button, bool *pressed) {
    double width = ui_extent(window->ui, UI_BODY, button->label).x + BUTTON_PAD;
    ui_at(window->ui, (Box){{left, bar.low.y + 2}, {left + width, bar.high.y - 2}});
    *pressed = ui_button(window->ui, button);
    return left + width;
}

/* Shows a line of text, shortened by an ellipsis where it does not fit. */
static void show_text(Window *window, UiTextStyle size, Role role, double left, double right, double y,
                      const char *text) {
    double height = ui_extent(window->ui, size, text).y;
    if (right - left < height)
        return;
    ui_at(window->ui, (Box){{left, y - height / 2}, {right, y + height / 2}});
    ui_line(window->ui, size, role, text);
}

/* The menu --------------------------------------------------------------------------------------------------------- */

static double show_laboratories(Window *window, Box bar) {
    const char **labels = arena_allocate(&window->arena, laboratories_count * sizeof *labels);
    double width = 4;
    for (size_t i = 0; i < laboratories_count; i++) {
        const LaboratoryRow *row = &laboratories[i];
        labels[i] = text_in_arena(&window->arena, "%s %s", row->laboratory->name, row->key);
        width += ui_extent(window->ui, UI_BODY, labels[i]).x + BUTTON_PAD;
    }
    double left = bar.high.x - width, begin = left;
    for (size_t i = 0; i < laboratories_count; i++) {
        bool pressed;
        Action action = ACTION_LABORATORY + (Action)i;
        UiButton button = {.label = labels[i],
                           .plain = true,
                           .chosen = window->current == i,
                           .help = keys_help(&window->arena, action)};
        left = add_button(window, left, bar, &button, &pressed);
        if (pressed)
            act_do(window, action, 0, 0);
    }
    return begin;
}

/* Returns a title that fits: whole, without what stands in brackets at the end of the name, or only that it is edited;
 * the frame of the system has all of it. */
static const char *whole_title(Window *window, const char *title, double width) {
    const char *mark = strstr(title, " (edited)"), *bracket = strstr(title, " (");
    const char *tries[] = {
        title,
        bracket ? text_in_arena(&window->arena, "%.*s%s", (int)(bracket - title), title, mark ? mark : "") : title,
        mark ? mark + 1 : ""};
    size_t i = 0;
    while (i + 1 < sizeof tries / sizeof *tries && ui_extent(window->ui, UI_BOLD, tries[i]).x > width)
        i++;
    return tries[i];
}

void bars_show_menu(Window *window) {
    Box bar = window->frame.menu;
    window->noted_in_bar = false;
    if (box_height(bar) <= 0)
        return;
    ui_pane_begin(window->ui, &(UiPane){.name = "menu", .box = bar, .ground = ROLE_SHADE});
    double left = menu_show_bar(window, bar), right = show_laboratories(window, bar);
    const Tab *tab = window_tab(window);
    if (tab->session) {
        const char *title = whole_title(window, lesson_title(window), right - left - 2 * GAP);
        const char *note = tab->laboratory->note(tab->session);
        double width = ui_extent(window->ui, UI_BOLD, title).x + 2, more = ui_extent(window->ui, UI_BODY, note).x + 2;
        window->noted_in_bar = left + width + more + 4 * GAP < right;
        double all = window->noted_in_bar && *note ? width + GAP + more : width;
        double begin = fmin(fmax(left + GAP, middle_of(bar).x - all / 2), fmax(left + GAP, right - GAP - all));
        show_text(window, UI_BOLD, ROLE_TEXT, begin, right - GAP, middle_of(bar).y, title);
        if (window->noted_in_bar && *note)
            show_text(window, UI_BODY, ROLE_DIM_TEXT, begin + width + GAP, right, middle_of(bar).y, note);
    }
    ui_pane_end(window->ui);
}

/* The place of messages -------------------------------------------------------------------------------------------- */

/* True while a tool is in hand, whose next step the strip says. */
static bool has_tool(Window *window) {
    Editor *editor = tab_editor(window_tab(window));
    return editor && editor_tool(editor) != TOOL_SELECT;
}

/* Returns the width that a message needs, with its buttons. */
static double message_width(Window *window) {
    size_t faults;
    const Message *shown = notice_shown(window, &faults);
    double undo = ui_extent(window->ui, UI_BODY, "Undo").x + BUTTON_PAD;
    return shown ? MARGIN + ui_extent(window->ui, UI_BODY, shown->text).x + 2 * GAP + undo + 40 : HUGE_VAL;
}

/* Returns the box of messages: the strip, or what the message needs of its right half while a tool is in hand. In a
 * small window a message longer than the strip takes the timeline, too. Without a strip it is the row of the menu, or
 * of the menu and the answer for two lines; in a presentation, above the timeline. */
static Box message_box(Window *window, bool fault) {
    Box box = window->frame.strip, menu = window->frame.menu;
    size_t faults;
    if (box_height(box) <= 0 && box_height(menu) <= 0)
        return (Box){{window->frame.view.low.x, window->frame.timeline.low.y - MESSAGE_HEIGHT},
                     {window->frame.page.x, window->frame.timeline.low.y}};
    bool brief = !notice_shown(window, &faults) || message_width(window) + (fault ? SIGNS : 0) < box_width(menu);
    if (box_height(box) <= 0)
        return brief ? menu : (Box){menu.low, window->frame.answer.high};
    if (window->frame.compact && !brief)
        return (Box){window->frame.timeline.low, box.high};
    if (!fault && has_tool(window))
        box.low.x = fmax(middle_of(box).x, box.high.x - message_width(window));
    return box;
}

/* True in a window with a menu but without a strip: the texts of a tool take the place of the answer. */
static bool tells_above(const Window *window) {
    return box_height(window->frame.strip) <= 0 && box_height(window->frame.menu) > 0;
}

/* True while something else stands in the place of the answer. */
static bool answer_is_covered(Window *window) {
    size_t faults;
    bool says = notice_shown(window, &faults);
    return tells_above(window) && (plan_input_listens(window) || (says && box_height(message_box(window, faults > 0)) >
                                                                              box_height(window->frame.menu)));
}

/* The answer ------------------------------------------------------------------------------------------------------- */

/* Shows the progress of the background work as a line that fills. */
static void show_progress(Window *window, Box bar, const Result *answer) {
    if (!answer->doing || isnan(answer->part))
        return;
    Box all = {{bar.low.x, bar.high.y - PROGRESS_HEIGHT}, bar.high};
    Box done = all;
    done.high.x = all.low.x + fmin(fmax(answer->part, 0), 1) * box_width(all);
    ui_draw_box(window->ui, all, ROLE_GRID, 1);
    ui_draw_box(window->ui, done, ROLE_CHAIR, 1);
}

/* Shows what is being worked out, and offers to give it up once it takes longer than a second. */
static void show_work(Window *window, Tab *tab, const Result *answer, double left, double right, double y) {
    double now = stopwatch_now();
    window->work_begun = window->work_begun > 0 ? window->work_begun : now;
    if (tab->laboratory->stop && now - window->work_begun > STOP_AFTER) {
        double width = ui_extent(window->ui, UI_BOLD, "Stop").x + BUTTON_PAD;
        ui_at(window->ui, (Box){{right - width, y - SHOW_HEIGHT / 2}, {right, y + SHOW_HEIGHT / 2}});
        if (ui_button(window->ui, &(UiButton){.label = "Stop", .help = "Stop: Undo the change and keep this answer"}))
            tab->laboratory->stop(tab->session);
        right -= width + GAP;
    }
    double radius = ui_extent(window->ui, UI_DETAIL, "x").y / 3, turn = fmod(now, 1);
    Vec2 ring[RING_POINTS], middle = {left + radius, y};
    for (int i = 0; i < RING_POINTS; i++)
        ring[i] = vec2_along(middle, radius, vec2_heading(2 * M_PI * (turn + 0.7 * i / (RING_POINTS - 1))));
    ui_draw_polyline(window->ui, ring, RING_POINTS, false, ROLE_CHAIR, 3);
    const char *doing = answer->doing ? answer->doing : "working it out";
    left += 2 * radius + GAP;
    UiTextStyle size = left + ui_extent(window->ui, UI_DETAIL, doing).x <= right ? UI_DETAIL : UI_BODY;
    if (left + ui_extent(window->ui, size, doing).x > right)
        doing = "working it out";
    show_text(window, size, ROLE_TEXT, left, right, y, doing);
}

/* Shows the clauses of a detail, which " \u00b7 " divides, each in a line of its own: as many as fit, whole ones from
 * the first on. False: one of the first two is too long. */
static bool show_clauses(Window *window, const char *detail, Role role, double left, double right, double y) {
    static const char between[] = " \u00b7 ";
    enum { LINES = 2 };
    const char *lines[LINES], *second = strstr(detail, between);
    double height = ui_extent(window->ui, UI_DETAIL, detail).y;
    if (!second || LINES * height > box_height(window->frame.answer))
        return false;
    lines[0] = text_in_arena(&window->arena, "%.*s", (int)(second - detail), detail);
    second += strlen(between);
    const char *end = strstr(second, between);
    lines[1] = end ? text_in_arena(&window->arena, "%.*s", (int)(end - second), second) : second;
    for (int i = 0; i < LINES; i++)
        if (left + ui_extent(window->ui, UI_DETAIL, lines[i]).x > right)
            return false;
    for (int i = 0; i < LINES; i++)
        show_text(window, UI_DETAIL, role, left, right, y + (i - 0.5) * height, lines[i]);
    return true;
}

/* Names the background work behind the numbers, so that nothing moves when it ends; where it does not fit, in the line
 * above its progress. It is never shortened. */
static void show_doing_note(Window *window, const char *doing, double left, double behind, double right, double y) {
    Vec2 extent = ui_extent(window->ui, UI_SMALL, doing);
    double below = window->frame.answer.high.y - PROGRESS_HEIGHT - extent.y / 2 + 1;
    if (behind + ui_extent(window->ui, UI_BODY, doing).x < right)
        show_text(window, UI_BODY, ROLE_DIM_TEXT, behind, right, y, doing);
    else if (left + extent.x < right && below - y > LINES_APART * ui_extent(window->ui, UI_DETAIL, doing).y)
        show_text(window, UI_SMALL, ROLE_DIM_TEXT, left, right, below, doing);
}

/* Returns the first line of a detail: of several faults the first, since the panel has them all. "": no detail. */
static const char *first_line(Window *window, const char *detail) {
    return detail ? text_in_arena(&window->arena, "%.*s", (int)strcspn(detail, "\n"), detail) : "";
}

/* Returns the first clauses of a text, whole ones, that fit into a width; "": none does. */
static const char *whole_clauses(Window *window, UiTextStyle size, const char *text, double width) {
    size_t length = strlen(text);
    while (length > 0 &&
           ui_extent(window->ui, size, text_in_arena(&window->arena, "%.*s", (int)length, text)).x > width) {
        size_t before = 0;
        for (size_t i = 1; i < length; i++) /* clauses end at "; ", ", " or " \u00b7 " */
            if (text[i] == ' ' && (text[i - 1] == ';' || text[i - 1] == ','))
                before = i - 1;
            else if (strncmp(text + i, " \u00b7 ", 4) == 0)
                before = i;
        length = before;
    }
    return text_in_arena(&window->arena, "%.*s", (int)length, text);
}

/* Returns the first clauses of a text that fit into a width; if none does, all of them, to be shortened. */
static const char *some_clauses(Window *window, UiTextStyle size, const char *text, double width) {
    const char *whole = whole_clauses(window, size, text, width);
    return *whole ? whole : text;
}

/* Shows a detail in two lines that break between clauses; the last ones are left out where they have no room. False: a
 * clause that begins a line is longer than it. */
static bool show_broken(Window *window, UiTextStyle size, Role role, Box lines, const char *detail) {
    static const char between[] = " ,;\u00b7";
    double width = box_width(lines), y = middle_of(lines).y, height = ui_extent(window->ui, size, detail).y;
    const char *first = whole_clauses(window, size, detail, width);
    const char *rest = detail + strlen(first);
    rest += strspn(rest, between);
    const char *second = whole_clauses(window, size, rest, width);
    if (!*first || !*second)
        return false;
    show_text(window, size, role, lines.low.x, lines.high.x, y - height / 2, first);
    show_text(window, size, role, lines.low.x, lines.high.x, y + height / 2, second);
    return true;
}

/* Shows the result's numbers in one line, or small in two. */
static void show_detail(Window *window, const Result *answer, double left, double right, double y) {
    const char *detail = first_line(window, answer->detail);
    Role role = answer->stale ? ROLE_DIM_TEXT : ROLE_TEXT;
    UiTextStyle size = left + ui_extent(window->ui, UI_DETAIL, detail).x > right ? UI_BODY : UI_DETAIL;
    if (size == UI_BODY && show_clauses(window, detail, role, left, right, y))
        return;
    y -= NOTE_ROOM;
    if (left + ui_extent(window->ui, size, detail).x > right &&
        show_broken(window, size, role, (Box){{left, y}, {right, y}}, detail))
        return;
    detail = whole_clauses(window, size, detail, TWO_LINES * (right - left));
    Vec2 extent = ui_extent(window->ui, size, detail);
    if (left + extent.x > right && extent.x < TWO_LINES * (right - left)) {
        double half = fmax(extent.y, ui_text_height(window->ui, size, detail, right - left) / 2);
        ui_at(window->ui, (Box){{left, y - half}, {right, y + half}});
        ui_text(window->ui, size, role, detail);
        return;
    }
    show_text(window, size, role, left, right, y, detail);
    if (answer->doing)
        show_doing_note(window, answer->doing, left, left + (*detail ? extent.x + GAP : 0), right, y);
}

/* Shows the numbers in one line below the title. */
static void show_detail_below(Window *window, const Result *answer, double right, double y) {
    const char *detail = first_line(window, answer->detail);
    bool fits = MARGIN + ui_extent(window->ui, UI_DETAIL, detail).x <= right;
    UiTextStyle size = fits ? UI_DETAIL : UI_BODY;
    show_text(window, size, ROLE_TEXT, MARGIN, right, y, whole_clauses(window, size, detail, right - MARGIN));
}

bool bars_answer_is_tall(Window *window) {
    const Tab *tab = window_tab(window);
    if (!window->present || !tab->session || lesson_hides_words(window))
        return false;
    Result answer = tab->laboratory->answer(tab->session);
    double room = window->frame.page.x - 2 * MARGIN, width = ui_extent(window->ui, UI_ANSWER, answer.title).x;
    double detail = answer.detail ? ui_extent(window->ui, UI_BODY, answer.detail).x : 0;
    return width <= room && detail > TWO_LINES * (room - width - 2 * GAP);
}

/* Returns the size of the title: large, unless the numbers would then not fit. */
static UiTextStyle title_size(Window *window, const Result *answer, double right) {
    double width = ui_extent(window->ui, UI_ANSWER, answer->title).x, rest = right - MARGIN - width - 2 * GAP;
    if (window->answer_tall)
        return rest < 0 ? UI_CLOCK : UI_ANSWER;
    double wanted = answer->detail ? ui_extent(window->ui, UI_BODY, answer->detail).x : 0;
    return rest < 0 || wanted > TWO_LINES * rest ? UI_CLOCK : UI_ANSWER;
}

/* Shows a question that is longer than a line. */
static void show_wrapped(Window *window, UiTextStyle size, double left, double right, double y, const char *text) {
    enum { LINES = 2 };
    double half = LINES * ui_extent(window->ui, size, text).y / 2;
    ui_at(window->ui, (Box){{left, y - half}, {right, y + half}});
    ui_text(window->ui, size, ROLE_TEXT, text);
}

/* True if the title would be cut off, or, in a small window, a part of its detail, so that it takes the first of two
 * small lines. */
static bool is_stacked(Window *window, const Result *answer, double right) {
    double rest = right - MARGIN - ui_extent(window->ui, UI_CLOCK, answer->title).x;
    const char *first = window->frame.compact && !answer->stale ? first_line(window, answer->detail) : "";
    double wanted = ui_extent(window->ui, UI_BODY, first).x;
    bool lacks = *first && wanted > TWO_LINES * (rest - 2 * GAP) && wanted <= right - MARGIN;
    return !window->answer_tall && !lesson_hides_words(window) && (rest < 0 || lacks);
}

/* Returns the middle of a title, at `y` or so far above it that the progress does not cut the feet of letters. */
static double above_progress(Window *window, Box bar, UiTextStyle size, double y, const char *title) {
    return fmin(y, bar.high.y - PROGRESS_HEIGHT - ui_extent(window->ui, size, title).y / 2);
}

void bars_show_answer(Window *window) {
    Box bar = window->frame.answer;
    Tab *tab = window_tab(window);
    ui_pane_begin(window->ui, &(UiPane){.name = "answer", .box = bar, .ground = ROLE_PAPER});
    if (tab->session && !answer_is_covered(window)) {
        Result answer = tab->laboratory->answer(tab->session);
        if (lesson_hides_words(window))
            answer = (Result){.title = lesson_question(window), .role = ROLE_TEXT};
        bool hides = answer.stale || lesson_hides_words(window);
        double right = toolbar_show_answer(window, tab, bar, &answer, hides);
        double y = middle_of(bar).y;
        UiTextStyle size = title_size(window, &answer, right);
        bool stacked = is_stacked(window, &answer, right);
        if (stacked)
            size = MARGIN + ui_extent(window->ui, UI_HEADING, answer.title).x > right ? UI_BOLD : UI_HEADING;
        double width = ui_extent(window->ui, size, answer.title).x, left = MARGIN + width + 2 * GAP, below = y + 2;
        if (window->answer_tall || stacked) {
            below = bar.high.y - TALL_FOOT * box_height(bar);
            y = bar.low.y + TALL_HEAD * box_height(bar);
            left = MARGIN;
        }
        if (lesson_hides_words(window) && MARGIN + width > right)
            show_wrapped(window, size, MARGIN, right, y, answer.title);
        else
            show_text(window, size, answer.stale ? ROLE_DIM_TEXT : answer.role, MARGIN, fmin(right, MARGIN + width + 2),
                      above_progress(window, bar, size, y, answer.title), answer.title);
        if (answer.stale) {
            show_work(window, tab, &answer, left, right, below);
        } else {
            window->work_begun = 0;
            if (window->answer_tall || stacked)
                show_detail_below(window, &answer, right, below);
            else
                show_detail(window, &answer, left, right, below);
        }
        show_progress(window, bar, &answer);
    }
    ui_pane_end(window->ui);
}

/* Messages --------------------------------------------------------------------------------------------------------- */

static void show_export(Window *window, Box box) {
    const ExportStatus *status = export_update(window->export);
    const char *text = *status->doing
                           ? text_in_arena(&window->arena, "%s, written to %s", status->doing, status->folder)
                           : text_in_arena(&window->arena, "Writing to %s", status->folder);
    show_text(window, UI_BODY, ROLE_TEXT, box.low.x + MARGIN, box.high.x - 100, middle_of(box).y, text);
    ui_at(window->ui, (Box){{box.high.x - 94, box.low.y + 3}, {box.high.x - 6, box.high.y - 3}});
    if (ui_button(window->ui,
                  &(UiButton){.label = "Cancel", .help = "Cancel: Stop the export and keep complete files"}))
        export_cancel(window->export);
}

/* Shows a text in a box up to `right`, in several lines where one is too short and the box is high enough, and smaller
 * where these are too many. */
static void show_lines(Window *window, Role role, Box box, double right, const char *text) {
    double left = box.low.x + MARGIN, y = middle_of(box).y, room = box_height(box);
    double two = 2 * ui_extent(window->ui, UI_BODY, text).y;
    if (left + ui_extent(window->ui, UI_BODY, text).x <= right || two > room) {
        show_text(window, UI_BODY, role, left, right, y, text);
        return;
    }
    UiTextStyle size = ui_text_height(window->ui, UI_BODY, text, right - left) <= room ? UI_BODY : UI_SMALL;
    double half = fmin(ui_text_height(window->ui, size, text, right - left), room) / 2;
    ui_at(window->ui, (Box){{left, y - half}, {right, y + half}});
    ui_text(window->ui, size, role, text);
}

/* Shows why the gesture cannot be completed, or, in a window without a strip, its description. */
static bool show_gesture(Window *window, Box box) {
    const Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    if (!editor || !plan_input_listens(window))
        return false;
    const GestureView *gesture = editor_gesture(editor);
    if (!gesture->refusal && box_height(window->frame.strip) > 0)
        return false;
    if (tells_above(window)) /* the plan, where one draws, stays free */
        box = window->frame.answer;
    ui_pane_begin(window->ui, &(UiPane){.name = "gesture", .box = box, .ground = ROLE_PANEL});
    ui_draw_frame(window->ui, box, gesture->refusal ? ROLE_ERROR : ROLE_ROOM, 2);
    double width = box_width(box) - 2 * MARGIN, lines = box_height(box) > MESSAGE_HEIGHT ? TWO_LINES : 1;
    const char *text = gesture->refusal ? text_in_arena(&window->arena, "\u26a0 %s", gesture->refusal)
                                        : some_clauses(window, UI_BODY, gesture->doing, lines * width);
    show_lines(window, gesture->refusal ? ROLE_ERROR : ROLE_TEXT, box, box.high.x - MARGIN, text);
    ui_pane_end(window->ui);
    return true;
}

/* Returns half the height of a button of a message. */
static double button_half(Box box) {
    return fmin(SHOW_HEIGHT, box_height(box) - 4) / 2;
}

/* Shows the button that undoes the edit which the message tells of; returns the left edge of what is taken. */
static double show_undo(Window *window, Box box, double right) {
    double width = ui_extent(window->ui, UI_BODY, "Undo").x + BUTTON_PAD, y = middle_of(box).y, half = button_half(box);
    ui_at(window->ui, (Box){{right - width, y - half}, {right, y + half}});
    if (ui_button(window->ui, &(UiButton){.label = "Undo", .help = keys_help(&window->arena, ACTION_UNDO)}))
        act_do(window, ACTION_UNDO, 0, 0);
    return right - width - GAP;
}

void bars_show_message(Window *window) {
    size_t faults;
    const Message *shown = notice_shown(window, &faults);
    bool fault = shown && shown->kind == MESSAGE_FAULT;
    if (shown && !fault && window->present)
        return; /* nothing may lie over the plan and its scale; the key is named, and F7 keeps the message */
    Box box = message_box(window, fault);
    if (show_gesture(window, box) || (!shown && !window->export))
        return;
    ui_pane_begin(window->ui, &(UiPane){.name = "message", .box = box, .ground = ROLE_PANEL});
    ui_draw_frame(window->ui, box, fault ? ROLE_ERROR : ROLE_GRID, 2);
    if (shown) {
        Editor *editor = tab_editor(window_tab(window));
        bool undoes = shown->number == window->undo_message && editor && editor_undo_name(editor);
        const char *text = fault ? text_in_arena(&window->arena, "\u26a0 %s", shown->text) : shown->text;
        double right = box.high.x - 40;
        if (faults > 1) {
            const char *count = text_in_arena(&window->arena, "1 of %zu", faults);
            ui_draw_text(window->ui, UI_BODY, ROLE_DIM_TEXT, vec2(right, middle_of(box).y), 1, count);
            right -= ui_extent(window->ui, UI_BODY, count).x + GAP;
        }
        if (undoes)
            right = show_undo(window, box, right);
        show_lines(window, fault ? ROLE_ERROR : ROLE_TEXT, box, right, text);
        double y = middle_of(box).y, half = button_half(box);
        ui_at(window->ui, (Box){{box.high.x - 34, y - half}, {box.high.x - 6, y + half}});
        if (ui_button(window->ui, &(UiButton){.id = "dismiss",
                                              .label = "\u00d7",
                                              .help = "Dismiss (Escape): Hide this message; F7 shows all messages"}))
            notice_dismiss(window);
    } else {
        show_export(window, box);
    }
    ui_pane_end(window->ui);
}

/* The strip -------------------------------------------------------------------------------------------------------- */

static double show_key(Window *window, double left, double y, const KeyRow *row) {
    Vec2 key = ui_extent(window->ui, UI_SMALL, row->key);
    Box cap = {{left, y - key.y / 2 - 2}, {left + key.x + 2 * KEY_PAD, y + key.y / 2 + 2}};
    ui_draw_frame(window->ui, cap, ROLE_ROOM, 1.5);
    ui_draw_text(window->ui, UI_SMALL, ROLE_TEXT, vec2(left + KEY_PAD, y), 0, row->key);
    double text = cap.high.x + KEY_PAD;
    ui_draw_text(window->ui, UI_SMALL, ROLE_TEXT, vec2(text, y), 0, row->strip);
    return text + ui_extent(window->ui, UI_SMALL, row->strip).x + GAP;
}

/* The keys of the strip, few enough to be read: those of what has the focus. */
static const Action *strip_of(Window *window) {
    static const Action watching[STRIP_KEYS_MOST] = {ACTION_NEXT_THING, ACTION_RAISED, ACTION_GALLERY, ACTION_HELP};
    static const Action editing[STRIP_KEYS_MOST] = {ACTION_NEXT_THING, ACTION_TOPPLE, ACTION_UNDO, ACTION_HELP};
    static const Action machine[STRIP_KEYS_MOST] = {ACTION_PLAY, ACTION_KEEP, ACTION_GALLERY, ACTION_HELP};
    static const Action tool[STRIP_KEYS_MOST] = {ACTION_UNDO, ACTION_HELP, ACTION_NONE, ACTION_NONE};
    static const Action plot[STRIP_KEYS_MOST] = {ACTION_BOX, ACTION_BOX_BACK, ACTION_KEEP, ACTION_HELP};
    return strncmp(ui_focus_pane(window->ui), "plot:", 5) == 0 ? plot
           : !tab_editor(window_tab(window))                   ? machine
           : has_tool(window)                                  ? tool
           : window->editing                                   ? editing
                                                               : watching;
}

static double key_width(Window *window, const KeyRow *row) {
    return ui_extent(window->ui, UI_SMALL, row->key).x + 3 * KEY_PAD + ui_extent(window->ui, UI_SMALL, row->strip).x +
           GAP;
}

/* Returns the name of the selected item and the position of the pointer, m. */
static const char *place_text(Window *window, Tab *tab) {
    Vec2 at = vec2_scale(window->mouse, 1 / window->unit);
    Item item = tab->laboratory->selected(tab->session);
    const char *name = item.kind ? tab->laboratory->item_name(tab->session, item) : "";
    if (!tab_editor(tab) || !box_holds(window->frame.view, at) || !tab->view_layers.painted)
        return name;
    Vec2 floor = view_layers_floor(&tab->view_layers, vec2_sub(at, window->frame.view.low));
    return text_in_arena(&window->arena, "%s   x %.2f  y %.2f m", name, floor.x, floor.y);
}

/* Shows what the gesture does, or what the tool can do next. */
static double show_doing(Window *window, double left, double right, double y) {
    const Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    if (!tab->trial.session && (!editor || !plan_input_listens(window)))
        return left;
    const char *text = tab->trial.session
                           ? "The plan is unchanged until you use the fix: Return uses it, Escape goes back."
                           : editor_gesture(editor)->doing;
    text = some_clauses(window, UI_BOLD, text, right - left);
    double end = fmin(right, left + ui_extent(window->ui, UI_BOLD, text).x + 1);
    show_text(window, UI_BOLD, ROLE_TEXT, left, end, y, text);
    return end + GAP;
}

void bars_show_strip(Window *window) {
    Box bar = window->frame.strip;
    Tab *tab = window_tab(window);
    if (box_height(window->tries) > 0 && window->tries.low.y >= bar.low.y)
        bar.low.x = window->tries.high.x;
    if (box_height(bar) <= 0)
        return;
    ui_pane_begin(window->ui, &(UiPane){.name = "strip", .box = bar, .ground = ROLE_PAPER});
    size_t faults;
    bool says = notice_shown(window, &faults) || window->export;
    double end = says ? message_box(window, faults > 0).low.x : bar.high.x;
    double y = middle_of(bar).y, left = bar.low.x + MARGIN / 2, right = fmax(left, end - MARGIN);
    bool narrow = window->frame.compact && (bar.low.x > 0 || plan_input_listens(window));
    const char *place = tab->session && !says && !narrow ? place_text(window, tab) : "";
    ui_draw_text(window->ui, UI_SMALL, ROLE_DIM_TEXT, vec2(right, y), 1, place);
    right -= ui_extent(window->ui, UI_SMALL, place).x + GAP;
    left = show_doing(window, left, right, y);
    const Action *actions = strip_of(window);
    window->strip_count = 0;
    for (size_t i = 0; i < STRIP_KEYS_MOST; i++) {
        KeyRow row = keys_row(actions[i]);
        row.strip = row.strip ? row.strip : row.name;
        bool idle = actions[i] == ACTION_TOPPLE && menu_reason_of(window, ACTION_TOPPLE);
        if (!row.strip || idle || left + key_width(window, &row) >= right)
            continue;
        left = show_key(window, left, y, &row);
        window->strip_keys[window->strip_count++] = row.key;
    }
    ui_pane_end(window->ui);
}
