/* A window without a window: the widgets of a small laboratory, and what a person does with them. */
#pragma once

#include "draw/offscreen.h"
#include "window/ui.h"

enum { DESK_STOPS = 19, DESK_PANES = 5 /* with the modal pane closed */, DESK_CLIPBOARD = 256 };

typedef struct Pane {
    Offscreen *offscreen;
    PaintGlScreen *screen;
    Ui *ui;
    UiInput input;
    Vec2 page;             /* the window, design points */
    unsigned char *pixels; /* of the last pane_picture: blue, green, red, 255 */
    char *clipboard;       /* (DESK_CLIPBOARD) */
    Box canvas, pause;     /* a grab, and the button that counts in `pauses` */

    UiSlider width, damping;
    UiChange width_change;
    bool flag, modal, short_panel, entered;
    size_t choice;
    char name[32];
    int pauses, keeps, saves, rows;
    UiGrab grab;
} Pane;

/* Where there is no OpenGL the test is skipped. pane_end releases it. */
Pane pane_begin(int width, int height, double text, Theme theme);
void pane_end(Pane *desk);

void pane_frame(Pane *desk);
void pane_picture(Pane *desk);

/* The mouse, design points; each is a frame. */
void pane_move(Pane *desk, Vec2 to);
void pane_down(Pane *desk, Vec2 at);
void pane_up(Pane *desk, Vec2 at);

/* A key and a frame; returns whether the key was used. pane_type types, and Enter follows. */
bool pane_key(Pane *desk, UiKey key);
void pane_type(Pane *desk, const char *words);

/* The focus goes on until it is in the pane, so many stops behind its first. */
void pane_go(Pane *desk, const char *pane, int stops);
