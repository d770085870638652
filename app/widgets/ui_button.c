#include <assert.h>
#include <stdio.h>
#include <string.h>

#include "base/digest.h"
#include "widgets/ui_pane.h"
#include "widgets/ui_stop.h"
#include "widgets/ui_text.h"
#include "widgets/ui_tip.h"

#define PADDING 8.0
#define LINE 19.0 /* of several lines in a button */
#define FLAG_BOX 20.0
#define ROW_HEIGHT 32.0
#define ROW_PAD 8.0   /* above and below a name of several lines */
#define ROW_MARK 34.0 /* a disc or a line sample, and some room */
#define ROW_DISC_RADIUS 11.0
#define ROW_GAP 14.0
#define ROW_BAR 12.0 /* height of a bar */
#define CHOICE_GAP 4.0

enum { IN_ROW = 4 /* options side by side; more are listed below */ };

typedef struct Look {
    bool chosen, plain, disabled, hovered, held;
} Look;

/* Buttons ---------------------------------------------------------------------------------------------------------- */

static int count_lines(const char *text) {
    int count = 1;
    for (; *text; text++)
        count += *text == '\n';
    return count;
}

static UiInk text_ink(const Ui *ui, Look look) {
    return look.chosen ? ui_state_ink_on(ui, ROLE_CHAIR) : ui_state_ink(ui, look.disabled ? ROLE_ROOM : ROLE_TEXT, 1);
}

static void draw_button_ground(Ui *ui, Box box, Look look) {
    if (look.chosen)
        ui_painter_box(ui->painter, box, ui_state_ink(ui, ROLE_CHAIR, 1));
    else if (!look.disabled && (!look.plain || look.hovered))
        ui_painter_box(ui->painter, box, ui_state_ink(ui, look.hovered ? ROLE_SHADE : ROLE_PAPER, 1));
    if (look.hovered || look.held)
        ui_painter_frame(ui->painter, box, look.held ? 2 * UI_EDGE : UI_EDGE, ui_state_ink(ui, ROLE_TEXT, 1));
    else if (!look.plain)
        ui_painter_frame(ui->painter, box, UI_EDGE, ui_state_ink(ui, ROLE_ROOM, look.disabled ? 0.5 : 1));
}

/* Returns the larger style if the text has room in it, otherwise the small one. */
static UiTextStyle fitting_style(Ui *ui, UiTextStyle large, const char *text, double width) {
    return ui_extent(ui, large, text).x <= width ? large : UI_SMALL;
}

/* Draws several lines: the first is bold, as a key above its name. */
static void draw_lines(Ui *ui, Box box, UiInk ink, const char *label) {
    double height = LINE * count_lines(label), top = (box.low.y + box.high.y - height) / 2;
    UiTextStyle style = UI_BOLD;
    for (const char *line = label; line; style = UI_SMALL) {
        Box place = {{box.low.x + 2, top}, {box.high.x - 2, top + LINE}};
        ui_text_in(ui, style, ink, place, 0.5, line);
        top += LINE;
        line = strchr(line, '\n');
        line = line ? line + 1 : NULL;
    }
}

/* Draws the text behind a tab at the right. */
static void draw_plain(Ui *ui, Box box, UiInk ink, const char *label) {
    char first[256];
    size_t bytes = strcspn(label, "\t");
    snprintf(first, sizeof first, "%.*s", (int)bytes, label);
    double padding = ui_extent(ui, UI_BODY, label).x + 2 * PADDING <= box_width(box) ? PADDING : PADDING / 4;
    Box inside = {{box.low.x + padding, box.low.y}, {box.high.x - padding, box.high.y}};
    ui_text_in(ui, fitting_style(ui, UI_BODY, label, box_width(inside)), ink, inside, 0, first);
    if (label[bytes])
        ui_text_in(ui, UI_SMALL, ink, inside, 1, label + bytes + 1);
}

static void draw_label(Ui *ui, Box box, Look look, const char *label) {
    UiInk ink = text_ink(ui, look);
    Box inside = {{box.low.x + PADDING / 2, box.low.y}, {box.high.x - PADDING / 2, box.high.y}};
    if (strchr(label, '\n'))
        draw_lines(ui, box, ink, label);
    else if (look.plain)
        draw_plain(ui, box, ink, label);
    else
        ui_text_in(ui, fitting_style(ui, look.chosen ? UI_BOLD : UI_BODY, label, box_width(inside)), ink, inside, 0.5,
                   label);
}

bool ui_button(Ui *ui, const UiButton *button) {
    UiId id = ui_state_id(ui, button->id ? button->id : button->label);
    int lines = count_lines(button->label);
    Box box = ui_pane_next(ui, lines > 1 ? LINE * lines + 2 * PADDING : UI_BUTTON_HEIGHT);
    UiTouch touch = ui_state_touch(ui, id, box, false);
    /* a button that becomes disabled keeps the focus until the focus moves */
    bool focused = (!button->disabled || ui->focus == id) && ui_stop_make(ui, id, UI_IS_BUTTON, box);
    bool used = ui_stop_used(ui, id) || touch.clicked;
    bool lives = !button->disabled;
    Look look = {button->chosen, button->plain, button->disabled, touch.hovered && lives,
                 touch.held && touch.hovered && lives};
    draw_button_ground(ui, box, look);
    draw_label(ui, box, look, button->label);
    if (touch.clicked && lives)
        ui->tip_pressed = id;
    else if (ui->tip_pressed == id && !touch.hovered)
        ui->tip_pressed = 0;
    ui_tip_offer(ui, id, box, button->help, touch.hovered && ui->tip_pressed != id, focused);
    return used && lives;
}

/* Flags ------------------------------------------------------------------------------------------------------------ */

bool ui_flag(Ui *ui, const char *id_text, const char *label, const char *help, bool *value) {
    UiId id = ui_state_id(ui, id_text ? id_text : label);
    Box box = ui_pane_next(ui, UI_BUTTON_HEIGHT - 4);
    UiTouch touch = ui_state_touch(ui, id, box, false);
    bool focused = ui_stop_make(ui, id, UI_IS_BUTTON, box);
    bool used = ui_stop_used(ui, id) || touch.clicked;
    if (used)
        *value = !*value;
    double middle = (box.low.y + box.high.y) / 2, left = box.low.x;
    Box square = {{left, middle - FLAG_BOX / 2}, {left + FLAG_BOX, middle + FLAG_BOX / 2}};
    draw_button_ground(ui, square, (Look){.chosen = *value, .hovered = touch.hovered, .held = touch.held});
    if (*value) {
        Vec2 tick[] = {{left + 4.5, middle}, {left + 8.5, middle + 4.5}, {left + 15.5, middle - 5}};
        ui_painter_polyline(ui->painter, tick, 3, false, 2.5, ui_state_ink_on(ui, ROLE_CHAIR));
    }
    Box text = {{square.high.x + PADDING, box.low.y}, box.high};
    ui_text_in(ui, UI_BODY, ui_state_ink(ui, ROLE_TEXT, 1), text, 0, label);
    ui_tip_offer(ui, id, box, help, touch.hovered, focused);
    return used;
}

/* Choices ---------------------------------------------------------------------------------------------------------- */

static void choose_by_keys(Ui *ui, UiId id, size_t count, size_t *chosen) {
    for (UiPress press; ui_stop_next_key(ui, id, &press);)
        switch (press.key) {
        case UI_KEY_LEFT:
        case UI_KEY_UP:
            *chosen -= *chosen > 0;
            break;
        case UI_KEY_RIGHT:
        case UI_KEY_DOWN:
            *chosen += *chosen + 1 < count;
            break;
        case UI_KEY_HOME:
            *chosen = 0;
            break;
        case UI_KEY_END:
            *chosen = count - 1;
            break;
        default:
            *chosen = (*chosen + 1) % count;
        }
}

/* Divides the width by what the labels need, and equally if that is enough. */
static void share_width(Ui *ui, const char *const *text, size_t count, double width, double *widths) {
    double equal = (width - CHOICE_GAP * (double)(count - 1)) / (double)count, sum = 0, widest = 0;
    for (size_t i = 0; i < count; i++) {
        widths[i] = ui_extent(ui, UI_BOLD, text[i]).x + 2 * PADDING;
        widest = fmax(widest, widths[i]);
        sum += widths[i];
    }
    for (size_t i = 0; i < count; i++)
        widths[i] = widest <= equal ? equal : widths[i] * equal * (double)count / sum;
}

/* True if all labels can be read side by side. */
static bool fits_in_row(Ui *ui, const char *const *text, size_t count, double width) {
    double sum = CHOICE_GAP * (double)(count - 1);
    for (size_t i = 0; i < count; i++)
        sum += ui_extent(ui, UI_SMALL, text[i]).x + PADDING;
    return count <= IN_ROW && sum <= width;
}

static void name_choice(Ui *ui, Box box, const char *label) {
    if (label && *label)
        ui_text_in(ui, UI_BODY, ui_state_ink(ui, ROLE_TEXT, 1),
                   (Box){box.low, {box.high.x, box.low.y + UI_LINE_HEIGHT}}, 0, label);
}

/* Lists the options below; true if one was clicked. */
static bool list_options(Ui *ui, UiId id, const char *const *text, size_t count, size_t *chosen) {
    bool clicked = false;
    for (size_t i = 0; i < count; i++) {
        ui->y -= UI_GAP;
        Box part = ui_pane_next(ui, UI_BUTTON_HEIGHT - UI_GAP);
        part.low.x += 2 * PADDING;
        UiTouch touch = ui_state_touch(ui, digest_chain(id, i + 1), part, false);
        Look look = {.chosen = i == *chosen, .plain = true, .hovered = touch.hovered};
        draw_button_ground(ui, part, look);
        draw_label(ui, part, look, text[i]);
        clicked |= touch.clicked;
        *chosen = touch.clicked ? i : *chosen;
    }
    return clicked;
}

/* Shows the chosen option as a button that lists all of them below, where they have no room side by side. */
static bool pull_down(Ui *ui, UiId id, Box box, const char *label, const char *help, const char *const *text,
                      size_t count, size_t *chosen) {
    size_t before = *chosen;
    bool focused = ui_stop_make(ui, id, UI_IS_CHOICE, box), open = ui->pulled == id;
    name_choice(ui, box, label);
    Box button = {{box.low.x, box.high.y - UI_BUTTON_HEIGHT}, box.high};
    UiTouch touch = ui_state_touch(ui, digest_chain(id, 0), button, false);
    Look look = {.hovered = touch.hovered, .held = touch.held && touch.hovered};
    draw_button_ground(ui, button, look);
    ui_text_in(ui, UI_BODY, ui_state_ink(ui, ROLE_TEXT, 1),
               (Box){{button.low.x + PADDING, button.low.y}, {button.high.x - 3 * PADDING, button.high.y}}, 0,
               text[*chosen]);
    Vec2 sign = {button.high.x - 2 * PADDING, (button.low.y + button.high.y) / 2};
    Vec2 down[] = {{sign.x - 5, sign.y - 3}, {sign.x + 5, sign.y - 3}, {sign.x, sign.y + 4}};
    ui_painter_convex(ui->painter, down, 3, ui_state_ink(ui, ROLE_DIM_TEXT, 1));
    if (touch.clicked)
        open = !open;
    if (open && list_options(ui, id, text, count, chosen))
        open = false;
    choose_by_keys(ui, id, count, chosen);
    ui->pulled = open ? id : ui->pulled == id ? 0 : ui->pulled;
    ui_tip_offer(ui, id, box, help, touch.hovered, focused);
    return *chosen != before;
}

bool ui_choice(Ui *ui, const char *id_text, const char *label, const char *help, const char *const *text, size_t count,
               size_t *chosen) {
    enum { MOST = 12 };
    assert(count <= MOST);
    UiId id = ui_state_id(ui, id_text ? id_text : label);
    bool named = label && *label;
    size_t before = *chosen;
    Box box = ui_pane_next(ui, UI_BUTTON_HEIGHT + (named ? UI_LINE_HEIGHT : 0));
    if (!fits_in_row(ui, text, count, box_width(box)))
        return pull_down(ui, id, box, label, help, text, count, chosen);
    bool focused = ui_stop_make(ui, id, UI_IS_CHOICE, box), hovered = false;
    double widths[MOST];
    share_width(ui, text, count, box_width(box), widths);
    name_choice(ui, box, label);
    Vec2 at = {box.low.x, named ? box.low.y + UI_LINE_HEIGHT : box.low.y};
    for (size_t i = 0; i < count; at.x += widths[i] + CHOICE_GAP, i++) {
        Box part = {at, {at.x + widths[i], box.high.y}};
        UiTouch touch = ui_state_touch(ui, digest_chain(id, i + 1), part, false);
        if (touch.clicked)
            *chosen = i;
        hovered = hovered || touch.hovered;
        Look look = {.chosen = i == *chosen, .hovered = touch.hovered, .held = touch.held && touch.hovered};
        draw_button_ground(ui, part, look);
        draw_label(ui, part, look, text[i]);
    }
    choose_by_keys(ui, id, count, chosen);
    ui_tip_offer(ui, id, box, help, hovered, focused);
    return *chosen != before;
}

/* Rows of a list --------------------------------------------------------------------------------------------------- */

static void draw_mark(Ui *ui, Box box, const UiRow *row) {
    Vec2 middle = {box.low.x + ROW_DISC_RADIUS + 1, (box.low.y + box.high.y) / 2};
    UiInk ink = ui_state_ink_on(ui, row->role), fill = ui_state_ink(ui, row->role, 1);
    if (row->shape == ROW_DISC) {
        ui_painter_disc(ui->painter, middle, ROW_DISC_RADIUS, ui_state_ink(ui, ROLE_WALL, 1));
        ui_painter_disc(ui->painter, middle, ROW_DISC_RADIUS - 2, fill);
    } else if (row->shape == ROW_LINE) {
        static const double dashes[LINE_STYLES][2] = {{26, 0}, {7, 4}, {3, 3}, {10, 3}};
        const double *dash = dashes[row->style];
        for (double x = 0; x < 26; x += dash[0] + dash[1])
            ui_painter_box(ui->painter,
                           (Box){{box.low.x + x, middle.y - 2}, {box.low.x + fmin(26, x + dash[0]), middle.y + 2}},
                           fill);
        if (row->mark)
            ui_painter_box(ui->painter, box_expand((Box){middle, middle}, ROW_DISC_RADIUS - 2), fill);
    }
    if (row->mark)
        ui_text_in(ui, UI_SMALL, row->shape == ROW_DISC || row->shape == ROW_LINE ? ink : fill,
                   box_expand((Box){middle, middle}, 14), 0.5, row->mark);
}

/* Draws the cells; if there are several columns, those at the right are as wide as their widest cell of the previous
 * frame. */
static double draw_cells(Ui *ui, Box box, UiTextStyle style, const char *const *cells) {
    double right = box.high.x;
    int count = !cells[0] ? 0 : !cells[1] ? 1 : !cells[2] ? 2 : 3;
    for (int column = count - 1; column >= 1; column--) {
        double width = ui_extent(ui, style, cells[column]).x;
        double *columns[] = {ui->place ? &ui->place->columns[0][column - 1] : &width,
                             ui->place ? &ui->place->columns[1][column - 1] : &width};
        *columns[1] = count > 2 ? fmax(*columns[1], width) : *columns[1];
        ui_text_in(ui, style, ui_state_ink(ui, ROLE_TEXT, 1), (Box){{right - width, box.low.y}, {right, box.high.y}}, 1,
                   cells[column]);
        right -= (count > 2 ? fmax(width, *columns[0]) : width) + ROW_GAP;
    }
    return right;
}

/* Draws a bar in the room that the cells leave. */
static void draw_bar(Ui *ui, const UiRow *row, Box room) {
    double middle = (room.low.y + room.high.y) / 2, width = row->cells[0] ? ui_extent(ui, UI_BODY, row->cells[0]).x : 0;
    Box bar = {{room.low.x + (width > 0 ? width + ROW_GAP : 0), middle - ROW_BAR / 2},
               {room.high.x, middle + ROW_BAR / 2}};
    if (box_width(bar) <= 0)
        return;
    ui_painter_box(ui->painter, bar, ui_state_ink(ui, ROLE_SHADE, 1));
    bar.high.x = bar.low.x + row->bar * box_width(bar);
    if (row->bar > 0)
        ui_painter_box(ui->painter, bar, ui_state_ink(ui, row->dim ? ROLE_DIM_TEXT : ROLE_EXIT_TAG, 1));
}

static bool is_marked(const UiRow *row) {
    return row->mark || row->shape == ROW_DISC || row->shape == ROW_LINE;
}

static UiTextStyle style_of(const UiRow *row) {
    return row->selected ? UI_BOLD : UI_BODY;
}

/* How a row is laid out. */
typedef struct RowFit {
    double height, cells; /* of the row, and of its cells to the right, at its foot */
} RowFit;

static double widest_word(Ui *ui, UiTextStyle style, const char *text) {
    double widest = 0;
    for (size_t length; *text; text += length + strspn(text + length, " ")) {
        length = strcspn(text, " ");
        widest = fmax(widest, ui_painter_extent(ui->painter, style, text, length).x);
    }
    return widest;
}

/* A name that is too long for its column breaks between words; where a word is longer, the name has lines of its own
 * above the other cells. */
static RowFit fit_row(Ui *ui, const UiRow *row) {
    double all = ui_pane_width(ui) - (is_marked(row) ? ROW_MARK : 0), room = all;
    UiTextStyle style = style_of(row);
    int count = !row->cells[0] ? 0 : !row->cells[1] ? 1 : !row->cells[2] ? 2 : 3;
    for (int column = 1; column < count; column++) {
        double width = ui_extent(ui, style, row->cells[column]).x;
        room -= (count > 2 && ui->place ? fmax(width, ui->place->columns[0][column - 1]) : width) + ROW_GAP;
    }
    if (!count || ui_extent(ui, style, row->cells[0]).x <= room)
        return (RowFit){ROW_HEIGHT, ROW_HEIGHT};
    bool stacks = count > 1 && widest_word(ui, style, row->cells[0]) > room;
    double name = ui_text_height(ui, style, row->cells[0], stacks ? all : room);
    if (stacks)
        return (RowFit){name + ROW_HEIGHT, ROW_HEIGHT - ROW_PAD / 2};
    double height = fmax(ROW_HEIGHT, name + ROW_PAD);
    return (RowFit){height, height};
}

/* Returns the box of a row: rows of a list have no gap between them. */
static Box next_row(Ui *ui, double height) {
    if (!ui->at_given && ui->row_count <= 1 && ui->y == ui->list_y)
        ui->y -= UI_GAP;
    Box box = ui_pane_next(ui, height);
    ui->list_y = ui->y;
    return box;
}

static void draw_name(Ui *ui, const UiRow *row, Box box) {
    UiInk ink = ui_state_ink(ui, row->dim ? ROLE_DIM_TEXT : ROLE_TEXT, 1);
    if (ui_extent(ui, style_of(row), row->cells[0]).x <= box_width(box)) {
        ui_text_in(ui, style_of(row), ink, box, 0, row->cells[0]);
        return;
    }
    double height = ui_text_height(ui, style_of(row), row->cells[0], box_width(box));
    box.low.y = (box.low.y + box.high.y - height) / 2;
    ui_text_wrapped(ui, style_of(row), ink, box, row->cells[0]);
}

bool ui_list_row(Ui *ui, const UiRow *row) {
    UiId id = ui_state_id(ui, row->id ? row->id : row->cells[0]);
    RowFit fit = fit_row(ui, row);
    Box box = next_row(ui, fit.height);
    UiTouch touch = row->usable || row->help ? ui_state_touch(ui, id, box, false) : (UiTouch){0};
    Box wide = {{box.low.x - 6, box.low.y}, {box.high.x + 6, box.high.y}};
    /* keeps the frame of the focus off the neighbouring rows */
    bool focused = row->usable && ui_stop_make(ui, id, UI_IS_ROW, box_expand(wide, -UI_FRAME - UI_RIM));
    bool used = row->usable && (ui_stop_used(ui, id) || touch.clicked);
    if (row->selected || (touch.hovered && row->usable))
        ui_painter_box(ui->painter, wide, ui_state_ink(ui, ROLE_SHADE, row->selected ? 1 : 0.6));
    if (row->selected)
        ui_painter_box(ui->painter, (Box){wide.low, {wide.low.x + 4, wide.high.y}}, ui_state_ink(ui, ROLE_CHAIR, 1));
    Box inside = box;
    if (is_marked(row)) {
        draw_mark(ui, box, row);
        inside.low.x += ROW_MARK;
    }
    Box foot = {{inside.low.x, inside.high.y - fit.cells}, inside.high};
    double right = draw_cells(ui, foot, style_of(row), row->cells);
    if (fit.cells < fit.height)
        inside.high.y = foot.low.y;
    else
        inside.high.x = right;
    if (row->has_bar)
        draw_bar(ui, row, inside);
    if (row->cells[0])
        draw_name(ui, row, inside);
    ui_tip_offer(ui, id, box, row->help, touch.hovered, focused);
    return used;
}
