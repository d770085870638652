/* The window itself, by SDL: its pixels, its OpenGL context and what is done with mouse and keys. Without a display SDL
 * takes its offscreen driver by itself; everything works there but being seen. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "base/fault.h"
#include "base/vec2.h"
#include "paint/gl.h"

typedef struct SdlWindow SdlWindow;

/* What happened. */
typedef enum SdlWindowKind {
    SDL_WINDOW_EVENT_NOTHING,
    SDL_WINDOW_EVENT_QUIT,
    SDL_WINDOW_EVENT_KEY,    /* went down, or repeats */
    SDL_WINDOW_EVENT_LET_GO, /* a key went up */
    SDL_WINDOW_EVENT_TEXT,   /* was typed */
    SDL_WINDOW_EVENT_MOUSE,  /* moved, at `at` */
    SDL_WINDOW_EVENT_BUTTON, /* of the mouse, at `at` */
    SDL_WINDOW_EVENT_WHEEL,
    SDL_WINDOW_EVENT_RESIZED,
    SDL_WINDOW_EVENT_EXPOSED,
    SDL_WINDOW_EVENT_FILE, /* was dropped: `text` */
} SdlWindowKind;

enum { SDL_WINDOW_EVENT_SHIFT = 1, SDL_WINDOW_EVENT_CONTROL = 2, SDL_WINDOW_EVENT_ALT = 4 };
enum { SDL_WINDOW_EVENT_LEFT, SDL_WINDOW_EVENT_RIGHT, SDL_WINDOW_EVENT_MIDDLE };
enum { SDL_WINDOW_EVENT_TEXT_MOST = 4096 };

typedef struct SdlWindowEvent {
    SdlWindowKind kind;
    int32_t key; /* SDL's code: a letter's character, see sdl_window_key */
    int mods;    /* SDL_WINDOW_EVENT_SHIFT, added up */
    bool repeat;
    Vec2 at; /* pixels */
    int button;
    bool down;
    bool twice;   /* it is the second press of a double click */
    double wheel; /* notches */
    char text[SDL_WINDOW_EVENT_TEXT_MOST];
} SdlWindowEvent;

/* A window of width x height pixels, shown; NULL: a fault says why there is none. */
SdlWindow *sdl_window_create(int width, int height, Fault *fault);
void sdl_window_destroy(SdlWindow *sdl_window);

/* Is anybody able to see it? */
bool sdl_window_is_seen(const SdlWindow *sdl_window);

const Gl *sdl_window_gl(const SdlWindow *sdl_window);

/* Pixels; and how many pixels the system makes of one of its points. */
void sdl_window_size(const SdlWindow *sdl_window, int *width, int *height);
double sdl_window_density(const SdlWindow *sdl_window);

/* Shift, Ctrl and Alt as they are held now; and as if they were, for scripts. */
int sdl_window_mods(const SdlWindow *sdl_window);
void sdl_window_hold(SdlWindow *sdl_window, int mods);

/* The next event; false: there is none. With `wait` it waits for one, up to so many s. */
bool sdl_window_next(SdlWindow *sdl_window, SdlWindowEvent *event, double wait);

/* As if it had been done; scripts do. */
void sdl_window_push(SdlWindow *sdl_window, const SdlWindowEvent *event);

/* Shows what was drawn. */
void sdl_window_swap(SdlWindow *sdl_window);

void sdl_window_set_title(SdlWindow *sdl_window, const char *title);
void sdl_window_set_fullscreen(SdlWindow *sdl_window, bool fullscreen);
void sdl_window_resize(SdlWindow *sdl_window, int width, int height);

/* Of the system; the text is good until the next call. */
const char *sdl_window_clipboard(void *sdl_window);
void sdl_window_set_clipboard(void *sdl_window, const char *text);

/* The code of a key by its name, "F1", "Space", "A", "Left", "Keypad +"; 0: there is none. */
int32_t sdl_window_key(const char *name);

void sdl_window_sleep(double seconds);
