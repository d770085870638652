#include "widgets/ui_tip.h"

#include <stdio.h>
#include <string.h>

#include "widgets/ui_text.h"

#define DELAY 0.5 /* s of hovering */
#define GRACE 0.4 /* s, for the mouse to move from the widget to its tooltip */
#define WIDEST 330.0
#define LEAST 160.0 /* width of a tooltip between the window's left edge and a column at its right edge */
#define PADDING 9.0
#define EDGE 1.5
#define BAR_MOST 110.0 /* height of a bar: its tooltips are next to it, so that they hide no other widget */

static void set(Ui *ui, UiTip *tip, UiId id, Box box, const char *help) {
    tip->id = id;
    tip->item = ui->hovered;
    tip->box = box;
    tip->pane = ui->place ? ui->place->box : ui->window;
    snprintf(tip->text, sizeof tip->text, "%s", help);
}

void ui_tip_offer(Ui *ui, UiId id, Box box, const char *help, bool hovered, bool focused) {
    if (!help || !*help)
        return;
    if (hovered && !ui->held) {
        ui->hover_time = ui->hover_tip.id == id ? ui->hover_time + ui->input.seconds : 0;
        ui->leave_time = 0;
        set(ui, &ui->hover_tip, id, box, help);
    }
    if (focused)
        set(ui, &ui->focus_tip, id, box, help);
}

/* A visible tooltip stays while the mouse is on it or on its way to it. */
void ui_tip_frame_begin(Ui *ui) {
    bool kept = ui->tip_shown && box_holds(ui->tip_box, ui->mouse);
    ui->leave_time = kept ? 0 : ui->leave_time + ui->input.seconds;
    if (ui->pressed[0] && ui->hover_tip.id)
        ui->tip_hidden = ui->hover_tip.id; /* the click has found what it was for */
    else if (ui->leave_time > GRACE && !ui->held)
        ui->tip_hidden = 0;
    if (ui->leave_time > GRACE || ui->pressed[0] || (ui->hovered && ui->hovered != ui->hover_tip.item && !kept))
        ui->hover_tip.id = 0;
    if (!ui->hover_tip.id)
        ui->hover_time = 0;
    ui->focus_tip.id = 0;
}

bool ui_tip_comes(const Ui *ui) {
    bool waits = ui->hover_tip.id && ui->hover_tip.id != ui->tip_hidden && ui->hover_time < DELAY;
    bool leaves = ui->hover_tip.id && ui->leave_time > 0;
    return waits || leaves;
}

void ui_hide_hover_tip(Ui *ui) {
    ui->tip_hidden = ui->hover_tip.id;
}

bool ui_tip_hide(Ui *ui) {
    if (!ui->tip_shown)
        return false;
    ui->tip_hidden = ui->hover_tip.id && ui->hover_time >= DELAY ? ui->hover_tip.id : ui->focus_tip.id;
    ui->by_key = false;
    ui->tip_shown = false;
    return true;
}

/* True if the pane is a column at the right edge, even one that is lower than wide, with room for tooltips beside it.
 */
static bool is_right_column(const Ui *ui, Box pane) {
    return pane.low.x >= LEAST && pane.high.x >= ui->window.high.x && box_height(pane) > BAR_MOST;
}

/* Returns a place next to the widget's pane if that is a bar, a column or a sheet, so that the tooltip hides no other
 * widget; elsewhere, and without room there, below the widget. */
static Box place_tip(const Ui *ui, const UiTip *tip, double width, double height) {
    Box pane = tip->pane, window = ui->window, widget = tip->box;
    bool tall = box_height(pane) > box_width(pane) || is_right_column(ui, pane);
    double foot = tall ? fmax(pane.high.y, height) : window.high.y;
    bool across = !tall && (ui->modal || box_height(pane) <= BAR_MOST);
    Vec2 at = {widget.low.x, widget.low.y};
    if (tall && pane.high.x + width <= window.high.x)
        at.x = pane.high.x;
    else if (tall && pane.low.x - width >= 0)
        at.x = pane.low.x - width;
    else if (across && pane.high.y + height <= window.high.y)
        at.y = pane.high.y;
    else if (across && pane.low.y - height >= 0)
        at.y = pane.low.y - height;
    else
        at.y = widget.high.y + height <= window.high.y ? widget.high.y : widget.low.y - height;
    at.x = real_clamp(at.x, 0, fmax(0, window.high.x - width));
    at.y = real_clamp(at.y, 0, fmax(0, fmin(foot, window.high.y) - height));
    return (Box){at, vec2_add(at, vec2(width, height))};
}

/* Draws the text; the first of several lines is the name. */
static void draw_text(Ui *ui, const UiTip *tip, UiInk ink, Box inside, double *height) {
    size_t name = strcspn(tip->text, "\n");
    char first[sizeof tip->text];
    snprintf(first, sizeof first, "%.*s", (int)name, tip->text);
    bool several = tip->text[name] == '\n';
    *height = ui_text_wrapped(ui, several ? UI_BOLD : UI_BODY, ink, inside, first);
    inside.low.y += *height;
    if (several)
        *height += ui_text_wrapped(ui, UI_BODY, ink, inside, tip->text + name + 1);
}

void ui_tip_draw(Ui *ui) {
    bool hovering = ui->hover_tip.id && ui->hover_time >= DELAY && ui->hover_tip.id != ui->tip_hidden &&
                    !ui->editor.id; /* nothing covers the plan while one types */
    bool focused = ui->by_key && ui->focus_tip.id && ui->focus_tip.id == ui->focus && !ui->editor.id;
    ui->tip_shown = hovering || focused;
    if (!hovering && ui->hover_tip.id && ui->hover_tip.id != ui->tip_hidden)
        ui->tip_hidden = 0;
    if (!ui->tip_shown)
        return;
    const UiTip *tip = hovering ? &ui->hover_tip : &ui->focus_tip;
    double room = is_right_column(ui, tip->pane) ? tip->pane.low.x : box_width(ui->window);
    double width = fmin(WIDEST, room) - 2 * PADDING, height;
    draw_text(ui, tip, 0, (Box){{0, 0}, {width, 0}}, &height);
    width = fmin(width, ui_extent(ui, UI_BOLD, tip->text).x + 1);
    draw_text(ui, tip, 0, (Box){{0, 0}, {width, 0}}, &height);
    ui->tip_box = place_tip(ui, tip, width + 2 * PADDING, height + 2 * PADDING);
    ui_painter_layer(ui->painter, UI_LAYER_TIP);
    ui_painter_box(ui->painter, ui->tip_box, ui_state_ink(ui, ROLE_PAPER, 1));
    ui_painter_frame(ui->painter, ui->tip_box, EDGE, ui_state_ink(ui, ROLE_TEXT, 1));
    draw_text(ui, tip, ui_state_ink(ui, ROLE_TEXT, 1), box_expand(ui->tip_box, -PADDING), &height);
}
