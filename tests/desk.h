/* A window without a window: the widgets of a small laboratory, and what a person does with them. */
#pragma once

#include "draw/offscreen.h"
#include "window/ui.h"

enum { DESK_STOPS = 19, DESK_PANES = 5 /* with the modal pane closed */, DESK_CLIPBOARD = 256 };

typedef struct Desk {
    Offscreen *offscreen;
    PaintGlScreen *screen;
    Ui *ui;
    UiInput input;
    Vec2 page;             /* the window, design points */
    unsigned char *pixels; /* of the last desk_picture: blue, green, red, 255 */
    char *clipboard;       /* (DESK_CLIPBOARD) */
    Box canvas, pause;     /* a grab, and the button that counts in `pauses` */

    UiSlider width, damping;
    UiChange width_change;
    bool flag, modal, short_panel, entered;
    size_t choice;
    char name[32];
    int pauses, keeps, saves, rows;
    UiGrab grab;
} Desk;

/* Where there is no OpenGL the test is skipped. desk_end releases it. */
Desk desk_begin(int width, int height, double text, Theme theme);
void desk_end(Desk *desk);

void desk_frame(Desk *desk);
void desk_picture(Desk *desk);

/* The mouse, design points; each is a frame. */
void desk_move(Desk *desk, Vec2 to);
void desk_down(Desk *desk, Vec2 at);
void desk_up(Desk *desk, Vec2 at);

/* A key and a frame; returns whether the key was used. desk_type types, and Enter follows. */
bool desk_key(Desk *desk, UiKey key);
void desk_type(Desk *desk, const char *words);

/* The focus goes on until it is in the pane, so many stops behind its first. */
void desk_go(Desk *desk, const char *pane, int stops);
