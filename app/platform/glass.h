/* The window itself, by SDL: its pixels, its OpenGL context and what is done with mouse and keys. Without a display SDL
 * takes its offscreen driver by itself; everything works there but being seen. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "base/fault.h"
#include "base/vec2.h"
#include "paint/gl.h"

typedef struct Glass Glass;

/* What happened. */
typedef enum GlassKind {
    GLASS_NOTHING,
    GLASS_QUIT,
    GLASS_KEY,    /* went down, or repeats */
    GLASS_LET_GO, /* a key went up */
    GLASS_TEXT,   /* was typed */
    GLASS_MOUSE,  /* moved, at `at` */
    GLASS_BUTTON, /* of the mouse, at `at` */
    GLASS_WHEEL,
    GLASS_RESIZED,
    GLASS_EXPOSED,
    GLASS_FILE, /* was dropped: `text` */
} GlassKind;

enum { GLASS_SHIFT = 1, GLASS_CONTROL = 2, GLASS_ALT = 4 };
enum { GLASS_LEFT, GLASS_RIGHT, GLASS_MIDDLE };
enum { GLASS_TEXT_MOST = 4096 };

typedef struct GlassEvent {
    GlassKind kind;
    int32_t key; /* SDL's code: a letter's character, see glass_key */
    int mods;    /* GLASS_SHIFT, added up */
    bool repeat;
    Vec2 at; /* pixels */
    int button;
    bool down;
    bool twice;   /* it is the second press of a double click */
    double wheel; /* notches */
    char text[GLASS_TEXT_MOST];
} GlassEvent;

/* A window of width x height pixels, shown; NULL: a fault says why there is none. */
Glass *glass_create(int width, int height, Fault *fault);
void glass_destroy(Glass *glass);

/* Is anybody able to see it? */
bool glass_is_seen(const Glass *glass);

const Gl *glass_gl(const Glass *glass);

/* Pixels; and how many pixels the system makes of one of its points. */
void glass_size(const Glass *glass, int *width, int *height);
double glass_density(const Glass *glass);

/* Shift, Ctrl and Alt as they are held now; and as if they were, for scripts. */
int glass_mods(const Glass *glass);
void glass_hold(Glass *glass, int mods);

/* The next event; false: there is none. With `wait` it waits for one, up to so many s. */
bool glass_next(Glass *glass, GlassEvent *event, double wait);

/* As if it had been done; scripts do. */
void glass_push(Glass *glass, const GlassEvent *event);

/* Shows what was drawn. */
void glass_swap(Glass *glass);

void glass_set_title(Glass *glass, const char *title);
void glass_set_fullscreen(Glass *glass, bool fullscreen);
void glass_resize(Glass *glass, int width, int height);

/* Of the system; the text is good until the next call. */
const char *glass_clipboard(void *glass);
void glass_set_clipboard(void *glass, const char *text);

/* The code of a key by its name, "F1", "Space", "A", "Left", "Keypad +"; 0: there is none. */
int32_t glass_key(const char *name);

void glass_sleep(double seconds);
