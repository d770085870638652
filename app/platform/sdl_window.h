/* The window of the system, by SDL: its pixels, its OpenGL context, and the events of mouse and keyboard. Without a
 * display SDL selects its offscreen driver; everything works there, but nobody sees it. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "base/fault.h"
#include "base/vec2.h"
#include "paint/gl.h"

typedef struct SdlWindow SdlWindow;

/* The kind of an event. */
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
    int mods;    /* sum of SDL_WINDOW_EVENT_SHIFT, _CONTROL and _ALT */
    bool repeat;
    Vec2 at; /* pixels */
    int button;
    bool down;
    bool twice;   /* the second press of a double click */
    double wheel; /* notches */
    char text[SDL_WINDOW_EVENT_TEXT_MOST];
} SdlWindowEvent;

/* Opens and shows a window of width x height pixels, at most as large as the screen; 0: most of the screen. NULL: a
 * fault says why not. */
SdlWindow *sdl_window_create(int width, int height, Fault *fault);
void sdl_window_destroy(SdlWindow *sdl_window);

/* True if the window is on a display. */
bool sdl_window_is_seen(const SdlWindow *sdl_window);

const Gl *sdl_window_gl(const SdlWindow *sdl_window);

/* Returns the size in pixels, and how many pixels one point of the system has. */
void sdl_window_size(const SdlWindow *sdl_window, int *width, int *height);
double sdl_window_density(const SdlWindow *sdl_window);

/* Returns which of Shift, Ctrl and Alt are held; holds them as if they were pressed, for scripts. */
int sdl_window_mods(const SdlWindow *sdl_window);
void sdl_window_hold(SdlWindow *sdl_window, int mods);

/* Fetches the next event, and waits for it up to `wait` s. False: there is none. */
bool sdl_window_next(SdlWindow *sdl_window, SdlWindowEvent *event, double wait);

/* Adds an event as if a person had caused it, for scripts. */
void sdl_window_push(SdlWindow *sdl_window, const SdlWindowEvent *event);

/* Shows the frame that was drawn. */
void sdl_window_swap(SdlWindow *sdl_window);

void sdl_window_set_title(SdlWindow *sdl_window, const char *title);
void sdl_window_set_fullscreen(SdlWindow *sdl_window, bool fullscreen);

/* Shows the pointer as one that can do nothing here, or as usual. */
void sdl_window_refuse(SdlWindow *sdl_window, bool refuses);

void sdl_window_resize(SdlWindow *sdl_window, int width, int height);

/* Read and write the system's clipboard; the text is valid until the next call. */
const char *sdl_window_clipboard(void *sdl_window);
void sdl_window_set_clipboard(void *sdl_window, const char *text);

/* Returns the code of a key by its name, "F1", "Space", "A", "Left", "Keypad +"; 0: there is none. */
int32_t sdl_window_key(const char *name);

void sdl_window_sleep(double seconds);
