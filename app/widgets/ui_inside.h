/* What the files of the widgets share; nobody else includes it. ui.cpp is the pencil, that is, Dear ImGui; ui_frame.c
 * the frame and the mouse; ui_focus.c the stops and the keys; ui_pane.c panes and where things go in them; ui_editor.c
 * the one text that is being typed; the others the widgets. */
#pragma once

#include <stdint.h>

#include "base/memory.h"
#include "widgets/ui.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Sizes, design points --------------------------------------------------------------------------------------------- */

#define UI_GAP 8.0
#define UI_BUTTON_HEIGHT 34.0
#define UI_LINE_HEIGHT 24.0 /* of one line of words that stand alone */
#define UI_SPACING 1.3      /* of lines of wrapped words, times the size of the letters */
#define UI_EDGE 1.5
#define UI_FRAME 3.0 /* of the focus, and of the light rim inside it */
#define UI_RIM 2.0

/* The pencil: ui.cpp ----------------------------------------------------------------------------------------------- */

typedef struct UiPencil UiPencil;

enum { UI_REASON = 256 /* bytes of what is wrong with a number */ };

typedef uint32_t UiInk; /* red, green, blue, opacity: bytes from the lowest */

/* Later layers lie over earlier ones whatever is drawn first. */
typedef enum UiLayer { UI_LAYER_PANES, UI_LAYER_MODAL, UI_LAYER_TIP, UI_LAYER_COUNT } UiLayer;

UiPencil *ui_pencil_create(PaintGlScreen *screen);
void ui_pencil_destroy(UiPencil *pencil);
void ui_pencil_begin(UiPencil *pencil, int width, int height, double unit, double seconds);
void ui_pencil_end(UiPencil *pencil);
bool ui_pencil_is_stale(const UiPencil *pencil); /* the next frame has other letters */
void ui_pencil_layer(UiPencil *pencil, UiLayer layer);

/* Nothing is seen outside the box and those around it, until ui_pencil_unclip. */
void ui_pencil_clip(UiPencil *pencil, Box box);
void ui_pencil_unclip(UiPencil *pencil);

/* Design points, of the letters. */
double ui_pencil_size(UiLetters letters);

Vec2 ui_pencil_extent(UiPencil *pencil, UiLetters letters, const char *words, size_t bytes);

/* How many bytes of the words are one line no wider than that; they end before a space or the end of a line. */
size_t ui_pencil_wrap(UiPencil *pencil, UiLetters letters, const char *words, double width);

/* Boxes lie on whole pixels. at.y is the middle of the capitals. */
void ui_pencil_words(UiPencil *pencil, UiLetters letters, UiInk ink, Vec2 at, const char *words, size_t bytes);
void ui_pencil_ground(UiPencil *pencil, Box box, Colour colour); /* large and opaque: the quick way */
void ui_pencil_box(UiPencil *pencil, Box box, UiInk ink);
void ui_pencil_frame(UiPencil *pencil, Box box, double width, UiInk ink);
void ui_pencil_polyline(UiPencil *pencil, const Vec2 *points, size_t count, bool closed, double width, UiInk ink);
void ui_pencil_convex(UiPencil *pencil, const Vec2 *points, size_t count, UiInk ink);
void ui_pencil_disc(UiPencil *pencil, Vec2 middle, double radius, UiInk ink);
void ui_pencil_image(UiPencil *pencil, const ScreenTexture *texture, Box box);
void ui_pencil_picture(UiPencil *pencil, const ScreenTexture *texture, const Vec2 corners[4], double opacity);

/* State ------------------------------------------------------------------------------------------------------------ */

typedef uint64_t UiId; /* a digest of the pane's name and the widget's; 0: none */

typedef enum UiKind { UI_IS_PANE, UI_IS_BUTTON, UI_IS_ROW, UI_IS_CHOICE, UI_IS_SLIDER, UI_IS_FIELD } UiKind;

/* A stop of the focus. */
typedef struct UiStop {
    UiId id, pane;
    UiKind kind;
    const char *text;       /* what typing begins with, or NULL: in the frame's arena */
    const UiSlider *number; /* of which kind what is typed must be, or NULL: there, too */
} UiStop;

/* What the mouse can be over. */
typedef struct UiItem {
    UiId id, pane;
    Box box; /* as far as it is seen */
    bool canvas;
} UiItem;

/* A key on its way to the stop that had the focus when it was pressed. */
typedef struct UiPress {
    UiId id;
    UiKey key;
    bool shift;
} UiPress;

/* How typing has ended. */
typedef enum UiEnd { UI_END_ENTERED, UI_END_LEFT, UI_END_ESCAPED } UiEnd;

/* What was typed and can be used, on its way to its widget. */
typedef struct UiTyped {
    UiId id;
    UiEnd end;
    const char *text; /* in `typed_texts` */
} UiTyped;

/* The text that is being typed. */
typedef struct UiEditor {
    UiId id;
    bool wrong; /* Enter was pressed and it could not be used */
    char *text, *original;
    size_t size, capacity, original_capacity; /* bytes, without the end */
    size_t caret, anchor;                     /* what is selected lies between them */
    double scroll;                            /* design points that are hidden to the left */
} UiEditor;

/* A number that was typed and could not be used. */
typedef struct UiDraft {
    UiId id;
    char *text;
} UiDraft;

/* What is remembered of a pane from frame to frame. */
typedef struct UiPlace {
    UiId id;
    char *name;
    Box box;
    bool made, modal, stop, scrolls;
    int order;                           /* among the panes of a frame */
    double scroll, content, seen_scroll; /* design points */
    double columns[2][2];                /* widths of the cells to the right: as they were, as they become */
} UiPlace;

/* What a help says, and where. */
typedef struct UiTip {
    UiId id, item; /* of the widget, and what of it the mouse is on */
    Box box, pane;
    char text[512];
} UiTip;

struct Ui {
    UiPencil *pencil;
    Theme theme;
    UiClipboard clipboard;
    UiInput input;
    Box window;

    /* the mouse */
    Vec2 mouse, moved, pressed_at;
    bool pressed[3], released[3], was_down[3], twice;
    double clock, pressed_time;
    UiId hovered, held;
    double grip; /* design points from the middle of a slider's block to where it is held */
    UiPlace *hovered_pane;
    bool on_canvas;
    UiItem *items, *old_items;
    size_t item_count, item_capacity, old_item_count, old_item_capacity;

    int stirred; /* frames until what was done is seen */

    /* the focus */
    UiId focus, focus_pane;
    UiId kept, kept_pane; /* what had it before a modal pane was opened */
    bool keeps;
    bool by_key; /* it came by a key: its help is seen */
    bool reveal; /* it is to be scrolled into view */
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
    UiPlace *place; /* the one that is being made */
    UiId modal;
    int order;
    Role ground;
    Box inner;                 /* where things flow, as if it had no end */
    double y, first_y, list_y; /* below the last row of a list */
    int row_count, row_index;
    double row_height;
    bool at_given;
    Box at;
    size_t first_stop; /* of the pane that is being made */

    /* tooltips */
    UiTip hover_tip, focus_tip;
    UiId tip_hidden;
    double hover_time, leave_time;
    Box tip_box;
    bool tip_shown;
};

/* ui_frame.c ------------------------------------------------------------------------------------------------------- */

typedef struct UiTouch {
    bool hovered, pressed, held, released, clicked, twice;
} UiTouch;

/* Something was done: the next two frames show it. */
void ui_frame_stir(Ui *ui);
UiId ui_frame_id(const Ui *ui, const char *id);

/* Makes a box that the mouse can use. */
UiTouch ui_frame_touch(Ui *ui, UiId id, Box box, bool canvas);

UiInk ui_frame_ink(const Ui *ui, Role role, double opacity);
UiInk ui_frame_ink_on(const Ui *ui, Role role); /* black or white */

/* ui_pane.c -------------------------------------------------------------------------------------------------------- */

/* The next box in the flow, or the one of ui_at; and how wide it will be. */
Box ui_pane_next(Ui *ui, double height);
double ui_pane_width(const Ui *ui);
UiPlace *ui_pane_find(const Ui *ui, UiId id);
void ui_pane_frame_begin(Ui *ui);
void ui_pane_frame_end(Ui *ui);
bool ui_pane_overflows(const UiPlace *place);

/* ui_focus.c ------------------------------------------------------------------------------------------------------- */

/* Makes a stop; true when it has the focus. */
bool ui_focus_stop(Ui *ui, UiId id, UiKind kind, Box box);

/* The same of one that is typed into. */
bool ui_focus_stop_typed(Ui *ui, UiId id, UiKind kind, Box box, const char *text, const UiSlider *number);
const UiStop *ui_focus_find(const Ui *ui, UiId id);

/* Takes the next key that was meant for the stop; false: none is left. */
bool ui_focus_take(Ui *ui, UiId id, UiPress *press);

/* Has Enter or Space been pressed on it? */
bool ui_focus_used(Ui *ui, UiId id);
void ui_focus_frame_begin(Ui *ui);
void ui_focus_frame_end(Ui *ui);
void ui_focus_draw(Ui *ui); /* the frame, in the pane that is being made */

/* ui_editor.c ------------------------------------------------------------------------------------------------------ */

/* Opens on all of the text. Closing with a number that cannot be used leaves it open (entered) or keeps it as a draft
 * (left). */
void ui_editor_open(Ui *ui, UiId id, const char *text);
void ui_editor_close(Ui *ui, UiEnd end);
void ui_editor_clear(Ui *ui);
void ui_editor_key(Ui *ui, UiKey key, bool shift, bool control);

/* Draws the text that is being typed in a field's box; the mouse moves the caret. */
void ui_editor_draw(Ui *ui, Box box, UiTouch touch);

/* How typing into it has ended since the last frame; NULL: it has not. */
const UiTyped *ui_editor_ended(const Ui *ui, UiId id);

/* ui_slider.c: is there a draft of it, what is wrong with a number (false: nothing) */
UiDraft *ui_slider_draft(const Ui *ui, UiId id);
void ui_slider_drop_draft(Ui *ui, UiId id);
void ui_slider_keep_draft(Ui *ui, UiId id, const char *text);
bool ui_slider_is_wrong(const UiSlider *slider, const char *text, double *value, char reason[UI_REASON]);

/* ui_words.c ------------------------------------------------------------------------------------------------------- */

/* One line in a box, in the middle of its height, shortened where it must be. */
void ui_words_in(Ui *ui, UiLetters letters, UiInk ink, Box box, double aligned, const char *words);

/* Wrapped words from the top of a box downwards; returns how high they are. Opacity 0 only measures. */
double ui_words_wrapped(Ui *ui, UiLetters letters, UiInk ink, Box box, const char *words);

/* ui_tip.c --------------------------------------------------------------------------------------------------------- */

/* Tells the help of a widget that was made. */
void ui_tip_offer(Ui *ui, UiId id, Box box, const char *help, bool hovered, bool focused);
void ui_tip_frame_begin(Ui *ui);
void ui_tip_draw(Ui *ui);
bool ui_tip_hide(Ui *ui);
bool ui_tip_comes(const Ui *ui); /* or goes, by itself */

#ifdef __cplusplus
}
#endif
