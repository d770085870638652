#include "widgets/ui_editor.h"
#include "widgets/ui_number.h"
#include "widgets/ui_pane.h"
#include "widgets/ui_stop.h"
#include "widgets/ui_text.h"
#include "widgets/ui_tip.h"

#define LABEL_HEIGHT 24.0
#define TRACK_ROW 24.0 /* the part that reacts to the mouse */
#define TRACK 7.0
#define BLOCK 12.0
#define BLOCK_HEIGHT 20.0
#define MARK_HEIGHT 15.0
#define FIELD_WIDTH 130.0
#define REASON_HEIGHT 22.0

/* Numbers ---------------------------------------------------------------------------------------------------------- */

static double part_of(const UiSlider *slider, double value) {
    double part = slider->logarithmic ? log(value / slider->low) / log(slider->high / slider->low)
                                      : (value - slider->low) / (slider->high - slider->low);
    return isfinite(part) ? real_clamp(part, 0, 1) : 0;
}

/* Returns the value at a share of the track, rounded to the displayed digits. */
static double value_at(const UiSlider *slider, double part) {
    part = real_clamp(part, 0, 1);
    if (part <= 0 || part >= 1)
        return part <= 0 ? slider->low : slider->high;
    double value = slider->logarithmic ? slider->low * pow(slider->high / slider->low, part)
                                       : slider->low + part * (slider->high - slider->low);
    double grain = slider->whole ? 1 : pow(10, -slider->digits);
    return real_clamp(round(value / grain) * grain, slider->low, slider->high);
}

/* Keys ------------------------------------------------------------------------------------------------------------- */

/* Returns the value one step further: a share of the range, but at least one unit of the last displayed digit. */
static double stepped(const UiSlider *slider, double step) {
    double grain = slider->whole ? 1 : pow(10, -slider->digits);
    double value = value_at(slider, part_of(slider, slider->value) + step);
    if (fabs(value - slider->value) < grain / 2)
        value = real_clamp(round(slider->value / grain) * grain + copysign(grain, step), slider->low, slider->high);
    return value;
}

static double value_by_key(const UiSlider *slider, UiPress press) {
    double step = press.shift ? 0.01 : 0.05;
    switch (press.key) {
    case UI_KEY_LEFT:
    case UI_KEY_DOWN:
        return stepped(slider, -step);
    case UI_KEY_RIGHT:
    case UI_KEY_UP:
        return stepped(slider, step);
    case UI_KEY_PAGE_DOWN:
        return stepped(slider, -0.1);
    case UI_KEY_PAGE_UP:
        return stepped(slider, 0.1);
    case UI_KEY_HOME:
        return slider->low;
    case UI_KEY_END:
        return slider->high;
    default:
        return slider->initial;
    }
}

/* Parts ------------------------------------------------------------------------------------------------------------ */

typedef struct Parts {
    UiId id, hand; /* of the value, which can be typed, and of the track */
    Box label, value, track;
    char text[96];
    bool changed, typing;
    UiDraft *draft;
} Parts;

static void draw_track(Ui *ui, const UiSlider *slider, Box box, UiTouch touch) {
    double middle = round((box.low.y + box.high.y) / 2), left = box.low.x, width = box_width(box) - BLOCK;
    double at = left + BLOCK / 2 + part_of(slider, slider->value) * width;
    double initial = left + BLOCK / 2 + part_of(slider, slider->initial) * width;
    Box track = {{left, middle - TRACK / 2}, {box.high.x, middle + TRACK / 2}};
    ui_painter_box(ui->painter, track, ui_state_ink(ui, ROLE_ROOM, 0.4));
    track.high.x = at;
    ui_painter_box(ui->painter, track, ui_state_ink(ui, ROLE_CHAIR, 1));
    Box mark = {{initial - 1, middle - MARK_HEIGHT / 2}, {initial + 1, middle + MARK_HEIGHT / 2}};
    ui_painter_box(ui->painter, mark, ui_state_ink(ui, ROLE_TEXT, 1));
    Box block = {{at - BLOCK / 2, middle - BLOCK_HEIGHT / 2}, {at + BLOCK / 2, middle + BLOCK_HEIGHT / 2}};
    ui_painter_box(ui->painter, block, ui_state_ink(ui, ROLE_CHAIR, 1));
    if (touch.hovered || touch.held)
        ui_painter_frame(ui->painter, block, 2, ui_state_ink(ui, ROLE_TEXT, 1));
}

static UiChange slide(Ui *ui, UiSlider *slider, const Parts *parts, UiTouch touch) {
    if (touch.twice) {
        slider->value = slider->initial;
        ui->held = 0;
        return UI_CHANGED;
    }
    double left = parts->track.low.x + BLOCK / 2, width = fmax(1, box_width(parts->track) - BLOCK);
    if (touch.pressed)
        ui_editor_drop_draft(ui, parts->id);
    if (touch.pressed) { /* pressed next to the block, it moves to the mouse; pressed on it, it keeps its offset */
        double off = ui->mouse.x - left - width * part_of(slider, slider->value);
        ui->grip = fabs(off) <= BLOCK / 2 ? off : 0;
        if (ui->grip == 0)
            slider->value = value_at(slider, (ui->mouse.x - left) / width);
    } else if ((touch.held || touch.released) && ui->moved.x != 0) {
        slider->value = value_at(slider, (ui->mouse.x - ui->grip - left) / width);
    }
    return touch.released ? UI_CHANGED : touch.held ? UI_MOVING : UI_SAME;
}

static UiChange use_keys(Ui *ui, UiSlider *slider, UiId id) {
    double before = slider->value;
    for (UiPress press; ui_stop_next_key(ui, id, &press);) {
        slider->value = value_by_key(slider, press);
        ui_editor_drop_draft(ui, id);
    }
    const UiTyped *typed = ui_editor_ended(ui, id);
    char reason[UI_REASON];
    if (typed)
        ui_number_is_wrong(slider, typed->text, &slider->value, reason);
    return slider->value != before ? UI_CHANGED : UI_SAME;
}

/* Draws the reason in place of the track: nothing else moves. */
static void draw_reason(Ui *ui, Box box, const char *reason) {
    UiInk ink = ui_state_ink(ui, ROLE_ERROR, 1);
    double middle = (box.low.y + box.high.y) / 2;
    ui_painter_disc(ui->painter, vec2(box.low.x + 9, middle), 9, ink);
    Box sign = {{box.low.x, box.low.y}, {box.low.x + 18, box.high.y}};
    ui_text_in(ui, UI_BOLD, ui_state_ink_on(ui, ROLE_ERROR), sign, 0.5, "!");
    ui_text_in(ui, UI_SMALL, ink, (Box){{box.low.x + 24, box.low.y}, box.high}, 0, reason);
}

static void draw_field(Ui *ui, const Parts *parts, bool wrong, UiTouch touch) {
    Box box = parts->value;
    ui_painter_box(ui->painter, box, ui_state_ink(ui, ROLE_PAPER, 1));
    ui_painter_frame(ui->painter, box, wrong ? 2.5 : UI_EDGE, ui_state_ink(ui, wrong ? ROLE_ERROR : ROLE_TEXT, 1));
    if (parts->typing)
        ui_editor_draw(ui, box, touch);
    else
        ui_text_in(ui, UI_BODY, ui_state_ink(ui, ROLE_TEXT, 1), (Box){{box.low.x + 7, box.low.y}, box.high}, 0,
                   parts->draft->text);
}

/* Draws label and value; a changed value is bold, with a diamond before its name. */
static void draw_head(Ui *ui, const UiSlider *slider, const Parts *parts, UiTouch touch) {
    Box label = parts->label;
    if (parts->changed) {
        ui_draw_diamond(ui, vec2(label.low.x + 5, (label.low.y + label.high.y) / 2), 5, ROLE_TEXT);
        label.low.x += 15;
    }
    ui_text_in(ui, parts->changed ? UI_BOLD : UI_BODY, ui_state_ink(ui, ROLE_TEXT, 1), label, 0, slider->label);
    if (parts->typing || parts->draft)
        return;
    if (touch.hovered)
        ui_painter_frame(ui->painter, parts->value, UI_EDGE, ui_state_ink(ui, ROLE_ROOM, 1));
    ui_text_in(ui, UI_BOLD, ui_state_ink(ui, ROLE_TEXT, 1), parts->value, 1, parts->text);
}

static Parts part(Ui *ui, const UiSlider *slider) {
    Parts parts = {.id = ui_state_id(ui, slider->id ? slider->id : slider->label)};
    Box box = ui_pane_next(ui, LABEL_HEIGHT + TRACK_ROW);
    parts.hand = ui_state_track(parts.id);
    parts.draft = ui_editor_draft(ui, parts.id);
    parts.typing = ui->editor.id == parts.id;
    parts.changed = slider->value != slider->initial;
    ui_number_print(slider, slider->value, parts.text, sizeof parts.text);
    double head = real_clamp(box_height(box) - TRACK_ROW, 0, LABEL_HEIGHT);
    double width = parts.typing || parts.draft ? FIELD_WIDTH : ui_extent(ui, UI_BOLD, parts.text).x;
    parts.track = (Box){{box.low.x, box.low.y + head}, box.high};
    parts.value = (Box){{box.high.x - fmin(width, box_width(box)), box.low.y}, {box.high.x, box.low.y + head}};
    parts.label = (Box){box.low, {parts.value.low.x - 4, box.low.y + head}};
    return parts;
}

static bool find_reason(Ui *ui, const UiSlider *slider, const Parts *parts, char reason[UI_REASON]) {
    double value;
    if (parts->typing)
        return (ui->editor.wrong || parts->draft) && ui_number_is_wrong(slider, ui->editor.text, &value, reason);
    return parts->draft && ui_number_is_wrong(slider, parts->draft->text, &value, reason);
}

UiChange ui_slider(Ui *ui, UiSlider *slider) {
    Parts parts = part(ui, slider);
    Box whole = {parts.label.low, parts.track.high};
    const char *text = parts.draft ? parts.draft->text : parts.text;
    bool focused = ui_stop_make_typed(ui, parts.id, UI_IS_SLIDER, whole, text, slider);
    UiChange typed = use_keys(ui, slider, parts.id);
    parts.draft = ui_editor_draft(ui, parts.id); /* which keys may have dropped */
    text = parts.draft ? parts.draft->text : parts.text;
    UiTouch field = ui_state_touch(ui, parts.id, parts.value, false), hand = {0};
    char reason[UI_REASON];
    bool wrong = find_reason(ui, slider, &parts, reason);
    if (!wrong)
        hand = ui_state_touch(ui, parts.hand, parts.track, false);
    if (field.clicked && !parts.typing && ui_stop_find(ui, parts.id))
        ui_editor_open(ui, parts.id, text);
    UiChange slid = wrong ? UI_SAME : slide(ui, slider, &parts, hand);
    parts.draft = ui_editor_draft(ui, parts.id);
    parts.changed = slider->value != slider->initial;
    ui_number_print(slider, slider->value, parts.text, sizeof parts.text);
    draw_head(ui, slider, &parts, field);
    if (parts.typing || parts.draft)
        draw_field(ui, &parts, wrong, field);
    if (wrong)
        draw_reason(ui, parts.track, reason);
    else
        draw_track(ui, slider, parts.track, hand);
    bool hovered = field.hovered || hand.hovered;
    if (hand.held) /* what it changes is looked at now */
        ui->tip_pressed = parts.id;
    else if (ui->tip_pressed == parts.id && !hovered)
        ui->tip_pressed = 0;
    ui_tip_offer(ui, parts.id, whole, slider->help, hovered && ui->tip_pressed != parts.id, focused);
    return slid != UI_SAME ? slid : typed;
}
