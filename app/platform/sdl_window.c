#include "platform/sdl_window.h"

#include <SDL2/SDL.h>
#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "base/memory.h"

enum { SMALLEST_WIDTH = 640, SMALLEST_HEIGHT = 400, USUAL_WIDTH = 1280, USUAL_HEIGHT = 720 /* pixels */ };

#define MOST_OF_SCREEN 0.8

struct SdlWindow {
    SDL_Window *window;
    SDL_GLContext context;
    Gl gl;
    SDL_Cursor *refusing; /* the pointer that can do nothing; NULL: not made yet */
    char *clipboard;      /* allocated by SDL */
    SDL_Keycode shortcut; /* of the key pressed last, if it was pressed with the left Alt key; otherwise 0 */
};

static GlFunction get_function(const char *name) {
    GlFunction function;
    void *address = SDL_GL_GetProcAddress(name);
    memcpy(&function, &address,
           sizeof function); /* ISO C has no conversion from object pointers to function pointers */
    return function;
}

static void ask_for_context(void) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
}

/* Returns the length of a window's side on a screen: as asked for, or, for 0, most of the screen, but at least `usual`
 * where that fits. */
static int fitting(int asked, int usual, int screen) {
    int most = (int)(MOST_OF_SCREEN * screen), wanted = asked > 0 ? asked : most > usual ? most : usual;
    return wanted < screen ? wanted : screen;
}

static void fit_screen(int *width, int *height) {
    SDL_Rect screen;
    if (!sdl_window_is_seen(NULL) || SDL_GetDisplayUsableBounds(0, &screen) != 0) {
        *width = *width > 0 ? *width : USUAL_WIDTH;
        *height = *height > 0 ? *height : USUAL_HEIGHT;
        return;
    }
    *width = fitting(*width, USUAL_WIDTH, screen.w);
    *height = fitting(*height, USUAL_HEIGHT, screen.h);
}

/* Opens the window step by step; the first step that fails adds a fault. */

static bool open_window(SdlWindow *sdl_window, int width, int height, Fault *fault) {
    SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
    SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
        fault_add(fault, "no window can be opened (%s); `clearance run FILE --out DIR` writes pictures without one",
                  SDL_GetError());
        return false;
    }
    fit_screen(&width, &height);
    ask_for_context();
    unsigned flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
    sdl_window->window =
        SDL_CreateWindow("clearance", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height, flags);
    sdl_window->context = sdl_window->window ? SDL_GL_CreateContext(sdl_window->window) : NULL;
    if (!sdl_window->context || !gl_load(&sdl_window->gl, get_function)) {
        fault_add(
            fault,
            "no window with OpenGL 3.3 can be opened (%s): the package libgl1-mesa-dri draws without a graphics card",
            SDL_GetError());
        return false;
    }
    SDL_SetWindowMinimumSize(sdl_window->window, SMALLEST_WIDTH, SMALLEST_HEIGHT);
    SDL_GL_SetSwapInterval(0); /* the loop times its frames itself: software rendering has no vertical retrace */
    SDL_StartTextInput();
    SDL_EventState(SDL_DROPFILE, SDL_ENABLE);
    return true;
}

SdlWindow *sdl_window_create(int width, int height, Fault *fault) {
    SdlWindow *sdl_window = memory_zeroed(1, sizeof *sdl_window);
    if (open_window(sdl_window, width, height, fault))
        return sdl_window;
    sdl_window_destroy(sdl_window);
    return NULL;
}

void sdl_window_destroy(SdlWindow *sdl_window) {
    SDL_free(sdl_window->clipboard);
    SDL_FreeCursor(sdl_window->refusing);
    if (sdl_window->context)
        SDL_GL_DeleteContext(sdl_window->context);
    if (sdl_window->window)
        SDL_DestroyWindow(sdl_window->window);
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    SDL_Quit();
    memory_free(sdl_window);
}

bool sdl_window_is_seen(const SdlWindow *sdl_window) {
    (void)sdl_window;
    const char *driver = SDL_GetCurrentVideoDriver();
    return driver && strcmp(driver, "offscreen") != 0 && strcmp(driver, "dummy") != 0;
}

const Gl *sdl_window_gl(const SdlWindow *sdl_window) {
    return &sdl_window->gl;
}

void sdl_window_size(const SdlWindow *sdl_window, int *width, int *height) {
    SDL_GL_GetDrawableSize(sdl_window->window, width, height);
}

double sdl_window_density(const SdlWindow *sdl_window) {
    int points = 1, height, width;
    SDL_GetWindowSize(sdl_window->window, &points, &height);
    SDL_GL_GetDrawableSize(sdl_window->window, &width, &height);
    return points > 0 ? (double)width / points : 1;
}

/* Events ----------------------------------------------------------------------------------------------------------- */

static int mods_of(unsigned mods) {
    return (mods & KMOD_SHIFT ? SDL_WINDOW_EVENT_SHIFT : 0) | (mods & KMOD_CTRL ? SDL_WINDOW_EVENT_CONTROL : 0) |
           (mods & KMOD_ALT ? SDL_WINDOW_EVENT_ALT : 0);
}

static int button_of(int button) {
    return button == SDL_BUTTON_RIGHT    ? SDL_WINDOW_EVENT_RIGHT
           : button == SDL_BUTTON_MIDDLE ? SDL_WINDOW_EVENT_MIDDLE
                                         : SDL_WINDOW_EVENT_LEFT;
}

static void translate_text(SdlWindowEvent *event, SdlWindowKind kind, const char *text) {
    event->kind = kind;
    snprintf(event->text, sizeof event->text, "%s", text);
}

static void translate_window(SdlWindowEvent *event, int what) {
    event->kind = what == SDL_WINDOWEVENT_SIZE_CHANGED                                      ? SDL_WINDOW_EVENT_RESIZED
                  : what == SDL_WINDOWEVENT_EXPOSED || what == SDL_WINDOWEVENT_FOCUS_GAINED ? SDL_WINDOW_EVENT_EXPOSED
                  : what == SDL_WINDOWEVENT_LEAVE                                           ? SDL_WINDOW_EVENT_MOUSE
                                                                                            : SDL_WINDOW_EVENT_NOTHING;
    event->at = vec2(-1, -1);
}

/* Keeps the key that was pressed with the left Alt key; the right one types characters on many keyboards. */
static void keep_shortcut(SdlWindow *sdl_window, const SDL_Event *event) {
    if (event->type == SDL_KEYUP)
        sdl_window->shortcut = 0;
    if (event->type != SDL_KEYDOWN)
        return;
    unsigned mods = event->key.keysym.mod;
    bool alone = (mods & KMOD_LALT) && !(mods & (KMOD_RALT | KMOD_MODE));
    sdl_window->shortcut = alone ? event->key.keysym.sym : 0;
}

/* True if a text is the letter of a key like Alt+K, which X11 sends behind it. */
static bool is_letter_of_shortcut(const SdlWindow *sdl_window, const char *text) {
    return sdl_window->shortcut && text[0] && !text[1] && tolower((unsigned char)text[0]) == sdl_window->shortcut;
}

/* Translates an event of SDL; the kind is SDL_WINDOW_EVENT_NOTHING if the program has no use for it. */
static void translate(const SdlWindow *sdl_window, const SDL_Event *from, SdlWindowEvent *event) {
    double density = sdl_window_density(sdl_window);
    *event = (SdlWindowEvent){.kind = SDL_WINDOW_EVENT_NOTHING};
    switch (from->type) {
    case SDL_QUIT:
        event->kind = SDL_WINDOW_EVENT_QUIT;
        break;
    case SDL_KEYDOWN:
        event->kind = SDL_WINDOW_EVENT_KEY;
        event->key = from->key.keysym.sym;
        event->mods = mods_of(from->key.keysym.mod);
        event->repeat = from->key.repeat;
        break;
    case SDL_KEYUP:
        event->kind = SDL_WINDOW_EVENT_LET_GO;
        break;
    case SDL_TEXTINPUT:
        if (!is_letter_of_shortcut(sdl_window, from->text.text))
            translate_text(event, SDL_WINDOW_EVENT_TEXT, from->text.text);
        break;
    case SDL_MOUSEMOTION:
        event->kind = SDL_WINDOW_EVENT_MOUSE;
        event->at = vec2(from->motion.x * density, from->motion.y * density);
        break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        event->kind = SDL_WINDOW_EVENT_BUTTON;
        event->at = vec2(from->button.x * density, from->button.y * density);
        event->button = button_of(from->button.button);
        event->down = from->type == SDL_MOUSEBUTTONDOWN;
        event->twice = event->down && from->button.clicks == 2;
        event->mods = mods_of((unsigned)SDL_GetModState());
        break;
    case SDL_MOUSEWHEEL:
        event->kind = SDL_WINDOW_EVENT_WHEEL;
        event->wheel = (double)from->wheel.preciseY;
        event->mods = mods_of((unsigned)SDL_GetModState());
        break;
    case SDL_DROPFILE:
        translate_text(event, SDL_WINDOW_EVENT_FILE, from->drop.file);
        SDL_free(from->drop.file);
        break;
    case SDL_WINDOWEVENT:
        translate_window(event, from->window.event);
        break;
    default:
        break;
    }
}

int sdl_window_mods(const SdlWindow *sdl_window) {
    (void)sdl_window;
    return mods_of((unsigned)SDL_GetModState());
}

static Uint16 system_mods(int mods) {
    return (Uint16)((mods & SDL_WINDOW_EVENT_SHIFT ? KMOD_LSHIFT : 0) |
                    (mods & SDL_WINDOW_EVENT_CONTROL ? KMOD_LCTRL : 0) | (mods & SDL_WINDOW_EVENT_ALT ? KMOD_LALT : 0));
}

void sdl_window_hold(SdlWindow *sdl_window, int mods) {
    (void)sdl_window;
    SDL_SetModState((SDL_Keymod)system_mods(mods));
}

bool sdl_window_next(SdlWindow *sdl_window, SdlWindowEvent *event, double wait) {
    SDL_Event from;
    bool got = wait > 0 ? SDL_WaitEventTimeout(&from, (int)(1000 * wait)) : SDL_PollEvent(&from);
    if (got) {
        keep_shortcut(sdl_window, &from);
        translate(sdl_window, &from, event);
    }
    return got;
}

static void push_key(const SdlWindowEvent *event) {
    SDL_Event to = {.key = {.type = SDL_KEYDOWN, .state = SDL_PRESSED, .keysym = {.sym = event->key}}};
    to.key.keysym.mod = system_mods(event->mods);
    SDL_PushEvent(&to);
}

/* SDL's event holds a short text: a long one is cut between two characters. */
static void push_text(const SdlWindowEvent *event) {
    const char *text = event->text;
    do {
        SDL_Event to = {.text = {.type = SDL_TEXTINPUT}};
        size_t length = strnlen(text, sizeof to.text.text - 1);
        while (length > 1 && ((unsigned char)text[length] & 0xC0) == 0x80)
            length--;
        memcpy(to.text.text, text, length);
        SDL_PushEvent(&to);
        text += length;
    } while (*text);
}

static void push_mouse(const SdlWindow *sdl_window, const SdlWindowEvent *event) {
    double density = sdl_window_density(sdl_window);
    int x = (int)(event->at.x / density), y = (int)(event->at.y / density);
    SDL_Event to = {.motion = {.type = SDL_MOUSEMOTION, .x = x, .y = y}};
    if (event->kind == SDL_WINDOW_EVENT_BUTTON) {
        static const Uint8 buttons[] = {SDL_BUTTON_LEFT, SDL_BUTTON_RIGHT, SDL_BUTTON_MIDDLE};
        to = (SDL_Event){.button = {.type = event->down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP,
                                    .button = buttons[event->button],
                                    .clicks = event->twice ? 2 : 1,
                                    .x = x,
                                    .y = y}};
    }
    SDL_PushEvent(&to);
}

static void push_file(const SdlWindowEvent *event) {
    SDL_Event to = {.drop = {.type = SDL_DROPFILE, .file = SDL_strdup(event->text)}};
    SDL_PushEvent(&to);
}

void sdl_window_push(SdlWindow *sdl_window, const SdlWindowEvent *event) {
    SDL_Event wheel = {.wheel = {.type = SDL_MOUSEWHEEL, .y = (int)event->wheel, .preciseY = (float)event->wheel}};
    SDL_Event quit = {.type = SDL_QUIT};
    switch (event->kind) {
    case SDL_WINDOW_EVENT_KEY:
        push_key(event);
        break;
    case SDL_WINDOW_EVENT_TEXT:
        push_text(event);
        break;
    case SDL_WINDOW_EVENT_MOUSE:
    case SDL_WINDOW_EVENT_BUTTON:
        push_mouse(sdl_window, event);
        break;
    case SDL_WINDOW_EVENT_WHEEL:
        SDL_PushEvent(&wheel);
        break;
    case SDL_WINDOW_EVENT_FILE:
        push_file(event);
        break;
    case SDL_WINDOW_EVENT_QUIT:
        SDL_PushEvent(&quit);
        break;
    default:
        break;
    }
}

/* The window ------------------------------------------------------------------------------------------------------- */

void sdl_window_swap(SdlWindow *sdl_window) {
    SDL_GL_SwapWindow(sdl_window->window);
}

void sdl_window_set_title(SdlWindow *sdl_window, const char *title) {
    SDL_SetWindowTitle(sdl_window->window, title);
}

void sdl_window_set_fullscreen(SdlWindow *sdl_window, bool fullscreen) {
    SDL_SetWindowFullscreen(sdl_window->window, fullscreen ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
}

void sdl_window_resize(SdlWindow *sdl_window, int width, int height) {
    double density = sdl_window_density(sdl_window);
    SDL_SetWindowSize(sdl_window->window, (int)(width / density), (int)(height / density));
}

const char *sdl_window_clipboard(void *context) {
    SdlWindow *sdl_window = context;
    SDL_free(sdl_window->clipboard);
    sdl_window->clipboard = SDL_GetClipboardText();
    return sdl_window->clipboard ? sdl_window->clipboard : "";
}

void sdl_window_set_clipboard(void *context, const char *text) {
    (void)context;
    SDL_SetClipboardText(text);
}

int32_t sdl_window_key(const char *name) {
    return SDL_GetKeyFromName(name);
}

void sdl_window_refuse(SdlWindow *sdl_window, bool refuses) {
    if (refuses && !sdl_window->refusing)
        sdl_window->refusing = SDL_CreateSystemCursor(SDL_SYSTEM_CURSOR_NO);
    SDL_Cursor *cursor = refuses ? sdl_window->refusing : SDL_GetDefaultCursor();
    if (cursor)
        SDL_SetCursor(cursor);
}

void sdl_window_sleep(double seconds) {
    struct timespec left = {.tv_sec = (time_t)seconds, .tv_nsec = (long)(1e9 * (seconds - (double)(time_t)seconds))};
    while (nanosleep(&left, &left) != 0)
        continue;
}
