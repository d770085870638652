/* The state that the files of the widgets share, and the parts that all of them use: identities, colours and the mouse.
 * Lowest first: ui.cpp (the painter), ui_state, ui_stop (stops of the focus), ui_number, ui_editor (the text that is
 * being typed), ui_pane (panes and the flow in them), ui_text, ui_draw, ui_tip, then the widgets (ui_button, ui_card,
 * ui_field, ui_slider), ui_focus (keys) and ui_frame. Only the widgets include these headers. */
#pragma once

#include "base/memory.h"
#include "widgets/ui_painter.h"

#define UI_GAP 8.0
#define UI_BUTTON_HEIGHT 34.0
#define UI_LINE_HEIGHT 24.0 /* of a single line of text */
#define UI_SPACING 1.3      /* of lines of wrapped text, times the text size */
#define UI_EDGE 1.5
#define UI_FRAME 3.0 /* of the focus, and of the light rim inside it */
#define UI_RIM 2.0

typedef uint64_t UiId; /* a digest of the pane's name and the widget's; 0: none */

typedef enum UiKind { UI_IS_PANE, UI_IS_BUTTON, UI_IS_ROW, UI_IS_CARD, UI_IS_CHOICE, UI_IS_SLIDER, UI_IS_FIELD } UiKind;

/* A stop of the focus. */
typedef struct UiStop {
    UiId id, pane;
    UiKind kind;
    Box box;
    const char *text;       /* initial text of the field, or NULL: in the frame's arena */
    const UiSlider *number; /* the slider that checks a typed number, or NULL: in the same arena */
} UiStop;

/* An item that the mouse can point at. */
typedef struct UiItem {
    UiId id, pane;
    Box box; /* the visible part */
    bool canvas;
} UiItem;

/* A key on its way to the stop that had the focus when it was pressed. */
typedef struct UiPress {
    UiId id;
    UiKey key;
    bool shift;
} UiPress;

/* How typing ended. */
typedef enum UiEnd { UI_END_ENTERED, UI_END_LEFT, UI_END_ESCAPED } UiEnd;

/* A valid typed text on its way to its widget. */
typedef struct UiTyped {
    UiId id;
    UiEnd end;
    const char *text; /* in `typed_texts` */
} UiTyped;

/* The text that is being typed. */
typedef struct UiEditor {
    UiId id;
    bool wrong; /* Enter was pressed and the number is invalid */
    char *text, *original;
    size_t size, capacity, original_capacity; /* bytes, without the terminating 0 */
    size_t caret, anchor;                     /* the selection lies between them */
    double scroll;                            /* design points hidden to the left */
} UiEditor;

/* An invalid number that was typed. */
typedef struct UiDraft {
    UiId id;
    char *text;
} UiDraft;

/* The state of a pane that is kept from frame to frame. */
typedef struct UiPlace {
    UiId id;
    char *name;
    Box box;
    bool made, modal, stop, scrolls, unframed;
    int order;                           /* among the panes of a frame */
    double scroll, content, seen_scroll; /* design points */
    size_t subject;
    UiId anchor;          /* the stop that is in use, */
    double anchor_y;      /* and its place in the content, design points */
    double columns[2][2]; /* widths of the cells to the right: in the previous frame, and in this one */
} UiPlace;

/* The text of a tooltip and its place. */
typedef struct UiTip {
    UiId id, item; /* of the widget, and the item under the mouse */
    Box box, pane;
    char text[512];
} UiTip;

struct Ui {
    UiPainter *painter;
    Theme theme;
    UiClipboard clipboard;
    UiInput input;
    Box window;

    /* the mouse */
    Vec2 mouse, moved, pressed_at;
    bool pressed[3], released[3], was_down[3], twice;
    double clock, pressed_time;
    UiId hovered, held;
    double grip; /* design points from the middle of a slider's block to the grabbed point */
    UiPlace *hovered_pane;
    bool on_canvas;
    UiItem *items, *old_items;
    size_t item_count, item_capacity, old_item_count, old_item_capacity;

    int stirred; /* frames until the last change is visible */

    /* the focus */
    UiId focus, focus_pane;
    UiId kept, kept_pane; /* the focus before a modal pane was opened */
    bool keeps;
    UiId wants_number; /* the pane whose first number is to have the focus, in at most */
    int wants_frames;
    bool by_key; /* moved by a key: shows its tooltip */
    bool reveal; /* must be scrolled into view */
    Box focus_box;
    bool focus_made;
    UiStop *stops, *old_stops;
    size_t stop_count, stop_capacity, old_stop_count, old_stop_capacity;
    Arena stop_texts, old_stop_texts;
    UiPress *presses;
    size_t press_count, press_capacity;
    UiTyped *typed;
    size_t typed_count, typed_capacity;
    Arena typed_texts;
    UiEditor editor;
    UiDraft *drafts;
    size_t draft_count, draft_capacity;

    /* panes */
    UiPlace **places;
    size_t place_count, place_capacity;
    UiPlace *place; /* the pane that is being made */
    UiId modal;
    int order;
    Role ground;
    Box inner;                 /* the area of the flow, as if it had no end */
    double y, first_y, list_y; /* below the last row of a list */
    UiId pulled;               /* the choice whose options are listed below it; 0: none */
    int row_count, row_index;
    double row_height;
    bool at_given;
    Box at;
    size_t first_stop; /* of the pane that is being made */

    /* tooltips */
    UiTip hover_tip, focus_tip;
    UiId tip_hidden;
    UiId tip_pressed; /* button that was pressed by the mouse, which has not left it since */
    double hover_time, leave_time;
    Box tip_box;
    bool tip_shown;
};

typedef struct UiTouch {
    bool hovered, pressed, held, released, clicked, twice;
} UiTouch;

/* Requests two frames after a change. */
void ui_state_stir(Ui *ui);
UiId ui_state_id(const Ui *ui, const char *id);

/* Returns the id of a slider's track, which the mouse holds. */
static inline UiId ui_state_track(UiId slider) {
    return slider ^ 1;
}

/* Registers a box for the mouse and returns its state. */
UiTouch ui_state_touch(Ui *ui, UiId id, Box box, bool canvas);

UiInk ui_state_ink(const Ui *ui, Role role, double opacity);
UiInk ui_state_ink_on(const Ui *ui, Role role); /* black or white */
