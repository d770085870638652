/* Widgets, by Dear ImGui, which only ui.cpp knows. All places and sizes are design points (1 = a pixel at 1280 x 720
 * and text size 1), y down; glyphs are as high as pango's of the same size.
 *
 * The keyboard is not ImGui's. Every widget that can be used is a stop of the focus, in the order in which the widgets
 * are made; Tab and Shift+Tab go round within all panes, F6 from pane to pane, and the stop that has the focus has a
 * frame. A click by mouse uses a widget without moving the focus, so that Space still plays. Nothing depends on how
 * quickly keys follow one another.
 *
 *     ui_begin; for each pane { ui_pane_begin; widgets; ui_pane_end }; ui_end */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/vec2.h"
#include "paint/paint_gl_screen.h"
#include "draw/palette.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct Ui Ui;

typedef enum UiTextStyle {
    UI_BODY,    /* 16 */
    UI_SMALL,   /* 16: nothing is smaller */
    UI_BOLD,    /* 16 bold */
    UI_HEADING, /* 18 bold */
    UI_CLOCK,   /* 24 bold */
    UI_DETAIL,  /* 20 */
    UI_ANSWER,  /* 40 bold */
    UI_TEXT_STYLES,
} UiTextStyle;

/* The user's input since the previous frame. */
typedef struct UiInput {
    int width, height; /* pixels of the window */
    double unit;       /* pixels per design point: layout_unit times the text size */
    double seconds;    /* since the previous frame */
    Vec2 mouse;        /* pixels; negative: not in the window */
    bool down[3];      /* left, right, middle: down now, or briefly since the previous frame */
    bool twice;        /* the left one went down for the second time of a double click */
    double wheel;      /* notches, up positive */
} UiInput;

/* Keys that widgets use; the window passes those that its own key table does not use. */
typedef enum UiKey {
    UI_KEY_NEXT,     /* Tab */
    UI_KEY_PREVIOUS, /* Shift+Tab */
    UI_KEY_PANE,     /* F6 */
    UI_KEY_PANE_BACK,
    UI_KEY_ENTER,
    UI_KEY_SPACE,
    UI_KEY_ESCAPE,
    UI_KEY_LEFT,
    UI_KEY_RIGHT,
    UI_KEY_UP,
    UI_KEY_DOWN,
    UI_KEY_HOME,
    UI_KEY_END,
    UI_KEY_PAGE_UP,
    UI_KEY_PAGE_DOWN,
    UI_KEY_BACKSPACE,
    UI_KEY_DELETE,
    UI_KEY_SELECT_ALL, /* Ctrl+A, C, V, X in a text field */
    UI_KEY_COPY,
    UI_KEY_PASTE,
    UI_KEY_CUT,
    UI_KEYS,
} UiKey;

/* The clipboard of the window. */
typedef struct UiClipboard {
    const char *(*get)(void *context);
    void (*set)(void *context, const char *text);
    void *context;
} UiClipboard;

Ui *ui_create(PaintGlScreen *screen, Theme theme, UiClipboard clipboard);
void ui_destroy(Ui *ui);
void ui_set_theme(Ui *ui, Theme theme);

/* Begins and ends a frame; ui_end draws it over the current framebuffer (row 0 at the bottom, as in a window). */
void ui_begin(Ui *ui, const UiInput *input);
void ui_end(Ui *ui);

/* True if the focused widget or an open field has used the key. Must be called before ui_begin. Escape closes an open
 * field, discards an invalid number, or hides a tooltip; over a modal pane with none of these it is not used, and the
 * caller closes the pane. */
bool ui_key(Ui *ui, UiKey key, bool shift, bool control);

/* Passes typed text, UTF-8, in order with the keys; ignored without an open field. */
void ui_type(Ui *ui, const char *text);

/* Hides the tooltip at the pointer until the pointer has left its widget: something is typed. */
void ui_hide_hover_tip(Ui *ui);

/* True if another frame would look different without input: something scrolls, a tooltip is due, or new glyphs are
 * ready. */
bool ui_is_busy(const Ui *ui);

/* True if a text field is open, which then uses all character keys. */
bool ui_types(const Ui *ui);

/* Panes. `name` is the identity of the pane; one with `scrolls` scrolls content that does not fit. A pane with `modal`
 * lies over the others, dims them and keeps the focus until Escape or its caller closes it. `stop`: the pane itself is
 * a stop of the focus, like the plan and each plot; so is a modal or overflowing pane without any other stop. */
typedef struct UiPane {
    const char *name;
    Box box;
    Role ground; /* ROLE_PANEL, ROLE_PAPER; ROLE_COUNT: none, transparent */
    bool scrolls, modal, stop;
    bool clear;     /* a modal pane that does not dim the others: a menu */
    bool unframed;  /* no frame while the pane itself has the focus */
    size_t subject; /* number of what the contents describe: another one is shown from its top */
} UiPane;

void ui_pane_begin(Ui *ui, const UiPane *pane);
void ui_pane_end(Ui *ui);

/* Returns the pane of the stop that has the focus, "" at first; and whether that stop is the pane itself. ui_focus
 * moves the focus to a pane (its own stop, or its first widget). */
const char *ui_focus_pane(const Ui *ui);
bool ui_focus_is_pane(const Ui *ui);
void ui_focus(Ui *ui, const char *pane);

/* Moves the focus to the first number or text of a pane, as soon as it is made; to the pane if it has none. */
void ui_focus_number(Ui *ui, const char *pane);

/* Moves the focus to a widget of a pane, by its id, as a key would; false: the last frame had none. And whether that
 * widget has the focus. */
bool ui_focus_on(Ui *ui, const char *pane, const char *id);
bool ui_focus_is_on(const Ui *ui, const char *pane, const char *id);

/* Returns the tooltip of the focused widget, for Shift+F1; NULL: none. */
const char *ui_focus_help(const Ui *ui);

/* Returns width and height of a text, design points. */
Vec2 ui_extent(Ui *ui, UiTextStyle style, const char *text);

/* Returns the height of a text in a box of that width, design points. */
double ui_text_height(Ui *ui, UiTextStyle style, const char *text, double width);

/* The flow: widgets stand below each other in the pane; ui_at puts the next one into a box of the window; ui_row puts
 * the next `count` side by side, equally wide. ui_gap leaves a gap. ui_space leaves one as well and returns its box,
 * for what is put there by ui_at or drawn, and scrolls with the pane. */
void ui_at(Ui *ui, Box box);
void ui_row(Ui *ui, int count);
void ui_gap(Ui *ui, double height);
Box ui_space(Ui *ui, double height);

/* Add text. In a flow it is wrapped at the pane's width (ui_text) or shortened by an ellipsis (ui_line). */
void ui_text(Ui *ui, UiTextStyle style, Role role, const char *text);
void ui_line(Ui *ui, UiTextStyle style, Role role, const char *text);

/* Adds the heading of a fold with a line above it; true if it was pressed, and *open has changed. `summary`: a few
 * words at the right, or NULL. */
bool ui_fold(Ui *ui, const char *title, const char *summary, bool *open);

/* Adds a heading with a line above it, wrapped in a narrow pane. */
void ui_heading(Ui *ui, const char *text);

/* For every widget, `id` must be unique in the pane; `help` is the tooltip: name, key and one sentence, or NULL. */
typedef struct UiButton {
    const char *id; /* NULL: the label */
    const char *label;
    const char *help;
    bool chosen; /* the selected one of several: filled */
    bool plain;  /* text only, for menus and rows */
    bool disabled;
} UiButton;

/* True if pressed, by mouse (on release) or key. */
bool ui_button(Ui *ui, const UiButton *button);

/* A row of a list: a mark, cells (NULL-ended, the first aligned left, the others right). True if chosen. */
typedef struct UiRow {
    const char *id;
    const char *mark; /* on a disc or a line sample, or NULL */
    Role role;
    int shape; /* RowKind of scene.h: ROW_DISC, ROW_LINE, ROW_PLAIN */
    int style; /* LineStyle */
    const char *cells[3];
    bool has_bar; /* a bar between the first cell, which is short, and the others */
    double bar;   /* 1, its filled part */
    const char *help;
    bool selected;
    bool dim;    /* of an older state: grey */
    bool usable; /* can be chosen: a stop of the focus */
} UiRow;
bool ui_list_row(Ui *ui, const UiRow *row);

/* A picture with a name and a few lines below it: an item of a gallery, in a row of cards. True if chosen. */
typedef struct UiCard {
    const char *id, *name, *text;
    const ScreenTexture *picture; /* or NULL: not yet */
    double picture_height, text_height;
    bool whole;        /* the text is never cut: its lines take their place from the picture */
    const Vec2 *shape; /* (shape_count) instead of a picture: a closed line about its middle, design points, y down; its
                          first side is thick */
    size_t shape_count; /* 0: none */
    const char *help;
    bool chosen;
} UiCard;
bool ui_card(Ui *ui, const UiCard *card);

/* Adds a tick box; true if it was changed. */
bool ui_flag(Ui *ui, const char *id, const char *label, const char *help, bool *value);

/* Adds one of a few labels (count), as buttons side by side; true if *chosen has changed. */
bool ui_choice(Ui *ui, const char *id, const char *label, const char *help, const char *const *labels, size_t count,
               size_t *chosen);

/* A number: label, value with its unit, a track with a mark at the initial value. Keys: arrows change it by a
 * twentieth of the range, with Shift a hundredth, PageUp and PageDown a tenth; Home and End set the ends, Enter starts
 * typing, Delete sets the initial value, as a double click does. A typed text that is not a number within `least` and
 * `most` stays, with the reason below it, until it is corrected or Escape is pressed. A comma counts as a point, and
 * units of the same kind are converted (250cm, 2500 mm). */
typedef struct UiSlider {
    const char *id, *label, *unit, *help;
    double value, initial;
    double low, high;   /* of the track */
    double least, most; /* of typed values */
    bool logarithmic, whole;
    int digits;       /* behind the point */
    int digits_least; /* zeros behind these digits are not shown; 0: all are */
} UiSlider;

typedef enum UiChange { UI_SAME, UI_MOVING, UI_CHANGED } UiChange; /* MOVING: still being dragged */
UiChange ui_slider(Ui *ui, UiSlider *slider);

/* Adds a text field of `size` bytes; true on Enter. Opens by itself when it gets the focus. */
bool ui_field(Ui *ui, const char *id, const char *label, const char *help, char *text, size_t size);

/* Adds a picture that fills the box. */
void ui_image(Ui *ui, const ScreenTexture *texture, Box box);

/* Adds a picture on a piece of floor: its corners are lower left, lower right, upper right, upper left. */
void ui_draw_picture(Ui *ui, const ScreenTexture *texture, const Vec2 corners[4], double opacity);

/* Drawing without widgets: the timeline, a cursor on a plot, frames of the selection. */
void ui_draw_box(Ui *ui, Box box, Role role, double opacity);
void ui_draw_frame(Ui *ui, Box box, Role role, double width);
void ui_draw_line(Ui *ui, Vec2 from, Vec2 to, Role role, double width);
void ui_draw_polyline(Ui *ui, const Vec2 *points, size_t count, bool closed, Role role, double width);
void ui_draw_disc(Ui *ui, Vec2 middle, double radius, Role role);
void ui_draw_diamond(Ui *ui, Vec2 middle, double radius, Role role);

/* Adds one line: at.y is the middle of the capitals; at.x the left end (aligned 0), the middle (0.5) or the right one
 * (1). */
void ui_draw_text(Ui *ui, UiTextStyle style, Role role, Vec2 at, double aligned, const char *text);

/* A text as it was painted, and the box that it is clipped to, pixels of the window. Each line of a wrapped text is
 * one. */
typedef struct UiPainted {
    const char *text;
    Box box, clip;
} UiPainted;

/* Lists the texts of the last frame in the order of painting, for tests; valid until the next frame. */
const UiPainted *ui_painted(const Ui *ui, size_t *count);

/* A box that the mouse can drag: its state, in design points of the window. */
typedef struct UiGrab {
    bool hovered, pressed, held, released, right_pressed, twice;
    Vec2 at, delta;
    double wheel;
} UiGrab;
UiGrab ui_grab(Ui *ui, const char *id, Box box);

#ifdef __cplusplus
}
#endif
