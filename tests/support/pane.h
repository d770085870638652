/* The widgets of a small laboratory without a window, and simulated input. */
#pragma once

#include "paint/offscreen.h"
#include "widgets/ui.h"

enum { PANE_STOPS = 19, PANE_PANES = 5 /* with the modal pane closed */, PANE_CLIPBOARD = 256 };

typedef struct Pane {
    Offscreen *offscreen;
    PaintGlScreen *screen;
    Ui *ui;
    UiInput input;
    Vec2 page;             /* the window, design points */
    unsigned char *pixels; /* of the last pane_picture: blue, green, red, 255 */
    char *clipboard;       /* (PANE_CLIPBOARD) */
    Box canvas, pause;     /* a grab, and the button that counts in `pauses` */

    UiSlider width, damping;
    UiChange width_change;
    bool flag, modal, short_panel, no_panel, entered;
    size_t choice;
    char name[32];
    int pauses, keeps, saves, rows;
    UiGrab grab;
} Pane;

/* Where there is no OpenGL the test is skipped. pane_end releases it. */
Pane pane_begin(int width, int height, double text, Theme theme);
void pane_end(Pane *pane);

void pane_frame(Pane *pane);
void pane_picture(Pane *pane);

/* The mouse, design points; each is a frame. */
void pane_move(Pane *pane, Vec2 to);
void pane_down(Pane *pane, Vec2 at);
void pane_up(Pane *pane, Vec2 at);

/* Sends a key and a frame; returns whether the key was used. pane_type types, followed by Enter. */
bool pane_key(Pane *pane, UiKey key);
void pane_type(Pane *pane, const char *words);

/* Moves the focus until it is in that pane, the given number of stops behind its first. */
void pane_go(Pane *pane, const char *name, int stops);
