#include "platform/glass.h"

#include <SDL2/SDL.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "base/memory.h"

enum { SMALLEST_WIDTH = 640, SMALLEST_HEIGHT = 400 /* pixels */ };

struct Glass {
    SDL_Window *window;
    SDL_GLContext context;
    Gl gl;
    char *clipboard; /* SDL's */
};

static GlFunction get_function(const char *name) {
    GlFunction function;
    void *address = SDL_GL_GetProcAddress(name);
    memcpy(&function, &address, sizeof function); /* ISO C converts no object pointer to a function's */
    return function;
}

static void ask_for_context(void) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
}

/* Each step of opening; the first that fails is said. */
static bool open_window(Glass *glass, int width, int height, Fault *fault) {
    SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
    SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
        fault_add(fault, "no window can be opened (%s): `clearance run FILE --out DIR` makes pictures without one",
                  SDL_GetError());
        return false;
    }
    ask_for_context();
    unsigned flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
    glass->window = SDL_CreateWindow("clearance", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height, flags);
    glass->context = glass->window ? SDL_GL_CreateContext(glass->window) : NULL;
    if (!glass->context || !gl_load(&glass->gl, get_function)) {
        fault_add(fault,
                  "no window with OpenGL 3.3 can be opened (%s): the package libgl1-mesa-dri draws without a "
                  "graphics card",
                  SDL_GetError());
        return false;
    }
    SDL_SetWindowMinimumSize(glass->window, SMALLEST_WIDTH, SMALLEST_HEIGHT);
    SDL_GL_SetSwapInterval(0); /* the loop paces itself: software rendering has no vertical retrace */
    SDL_StartTextInput();
    SDL_EventState(SDL_DROPFILE, SDL_ENABLE);
    return true;
}

Glass *glass_create(int width, int height, Fault *fault) {
    Glass *glass = memory_zeroed(1, sizeof *glass);
    if (open_window(glass, width, height, fault))
        return glass;
    glass_destroy(glass);
    return NULL;
}

void glass_destroy(Glass *glass) {
    SDL_free(glass->clipboard);
    if (glass->context)
        SDL_GL_DeleteContext(glass->context);
    if (glass->window)
        SDL_DestroyWindow(glass->window);
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    SDL_Quit();
    memory_free(glass);
}

bool glass_is_seen(const Glass *glass) {
    (void)glass;
    const char *driver = SDL_GetCurrentVideoDriver();
    return driver && strcmp(driver, "offscreen") != 0 && strcmp(driver, "dummy") != 0;
}

const Gl *glass_gl(const Glass *glass) {
    return &glass->gl;
}

void glass_size(const Glass *glass, int *width, int *height) {
    SDL_GL_GetDrawableSize(glass->window, width, height);
}

double glass_density(const Glass *glass) {
    int points = 1, height, width;
    SDL_GetWindowSize(glass->window, &points, &height);
    SDL_GL_GetDrawableSize(glass->window, &width, &height);
    return points > 0 ? (double)width / points : 1;
}

/* Events ----------------------------------------------------------------------------------------------------------- */

static int mods_of(unsigned mods) {
    return (mods & KMOD_SHIFT ? GLASS_SHIFT : 0) | (mods & KMOD_CTRL ? GLASS_CONTROL : 0) |
           (mods & KMOD_ALT ? GLASS_ALT : 0);
}

static int button_of(int button) {
    return button == SDL_BUTTON_RIGHT ? GLASS_RIGHT : button == SDL_BUTTON_MIDDLE ? GLASS_MIDDLE : GLASS_LEFT;
}

static void take_text(GlassEvent *event, GlassKind kind, const char *text) {
    event->kind = kind;
    snprintf(event->text, sizeof event->text, "%s", text);
}

static void take_window(GlassEvent *event, int what) {
    event->kind = what == SDL_WINDOWEVENT_SIZE_CHANGED                                      ? GLASS_RESIZED
                  : what == SDL_WINDOWEVENT_EXPOSED || what == SDL_WINDOWEVENT_FOCUS_GAINED ? GLASS_EXPOSED
                  : what == SDL_WINDOWEVENT_LEAVE                                           ? GLASS_MOUSE
                                                                                            : GLASS_NOTHING;
    event->at = vec2(-1, -1);
}

/* What of SDL's events concerns the program. */
static void translate(const Glass *glass, const SDL_Event *from, GlassEvent *event) {
    double density = glass_density(glass);
    *event = (GlassEvent){.kind = GLASS_NOTHING};
    switch (from->type) {
    case SDL_QUIT:
        event->kind = GLASS_QUIT;
        break;
    case SDL_KEYDOWN:
        event->kind = GLASS_KEY;
        event->key = from->key.keysym.sym;
        event->mods = mods_of(from->key.keysym.mod);
        event->repeat = from->key.repeat;
        break;
    case SDL_KEYUP:
        event->kind = GLASS_LET_GO;
        break;
    case SDL_TEXTINPUT:
        take_text(event, GLASS_TEXT, from->text.text);
        break;
    case SDL_MOUSEMOTION:
        event->kind = GLASS_MOUSE;
        event->at = vec2(from->motion.x * density, from->motion.y * density);
        break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        event->kind = GLASS_BUTTON;
        event->at = vec2(from->button.x * density, from->button.y * density);
        event->button = button_of(from->button.button);
        event->down = from->type == SDL_MOUSEBUTTONDOWN;
        event->twice = event->down && from->button.clicks == 2;
        event->mods = mods_of((unsigned)SDL_GetModState());
        break;
    case SDL_MOUSEWHEEL:
        event->kind = GLASS_WHEEL;
        event->wheel = (double)from->wheel.preciseY;
        event->mods = mods_of((unsigned)SDL_GetModState());
        break;
    case SDL_DROPFILE:
        take_text(event, GLASS_FILE, from->drop.file);
        SDL_free(from->drop.file);
        break;
    case SDL_WINDOWEVENT:
        take_window(event, from->window.event);
        break;
    default:
        break;
    }
}

int glass_mods(const Glass *glass) {
    (void)glass;
    return mods_of((unsigned)SDL_GetModState());
}

static Uint16 system_mods(int mods) {
    return (Uint16)((mods & GLASS_SHIFT ? KMOD_LSHIFT : 0) | (mods & GLASS_CONTROL ? KMOD_LCTRL : 0) |
                    (mods & GLASS_ALT ? KMOD_LALT : 0));
}

void glass_hold(Glass *glass, int mods) {
    (void)glass;
    SDL_SetModState((SDL_Keymod)system_mods(mods));
}

bool glass_next(Glass *glass, GlassEvent *event, double wait) {
    SDL_Event from;
    bool got = wait > 0 ? SDL_WaitEventTimeout(&from, (int)(1000 * wait)) : SDL_PollEvent(&from);
    if (got)
        translate(glass, &from, event);
    return got;
}

static void push_key(const GlassEvent *event) {
    SDL_Event to = {.key = {.type = SDL_KEYDOWN, .state = SDL_PRESSED, .keysym = {.sym = event->key}}};
    to.key.keysym.mod = system_mods(event->mods);
    SDL_PushEvent(&to);
}

static void push_text(const GlassEvent *event) {
    SDL_Event to = {.text = {.type = SDL_TEXTINPUT}};
    snprintf(to.text.text, sizeof to.text.text, "%.*s", (int)sizeof to.text.text - 1, event->text);
    SDL_PushEvent(&to);
}

static void push_mouse(const Glass *glass, const GlassEvent *event) {
    double density = glass_density(glass);
    int x = (int)(event->at.x / density), y = (int)(event->at.y / density);
    SDL_Event to = {.motion = {.type = SDL_MOUSEMOTION, .x = x, .y = y}};
    if (event->kind == GLASS_BUTTON) {
        static const Uint8 buttons[] = {SDL_BUTTON_LEFT, SDL_BUTTON_RIGHT, SDL_BUTTON_MIDDLE};
        to = (SDL_Event){.button = {.type = event->down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP,
                                    .button = buttons[event->button],
                                    .clicks = event->twice ? 2 : 1,
                                    .x = x,
                                    .y = y}};
    }
    SDL_PushEvent(&to);
}

static void push_file(const GlassEvent *event) {
    SDL_Event to = {.drop = {.type = SDL_DROPFILE, .file = SDL_strdup(event->text)}};
    SDL_PushEvent(&to);
}

void glass_push(Glass *glass, const GlassEvent *event) {
    SDL_Event wheel = {.wheel = {.type = SDL_MOUSEWHEEL, .y = (int)event->wheel, .preciseY = (float)event->wheel}};
    SDL_Event quit = {.type = SDL_QUIT};
    switch (event->kind) {
    case GLASS_KEY:
        push_key(event);
        break;
    case GLASS_TEXT:
        push_text(event);
        break;
    case GLASS_MOUSE:
    case GLASS_BUTTON:
        push_mouse(glass, event);
        break;
    case GLASS_WHEEL:
        SDL_PushEvent(&wheel);
        break;
    case GLASS_FILE:
        push_file(event);
        break;
    case GLASS_QUIT:
        SDL_PushEvent(&quit);
        break;
    default:
        break;
    }
}

/* The window ------------------------------------------------------------------------------------------------------- */

void glass_swap(Glass *glass) {
    SDL_GL_SwapWindow(glass->window);
}

void glass_set_title(Glass *glass, const char *title) {
    SDL_SetWindowTitle(glass->window, title);
}

void glass_set_fullscreen(Glass *glass, bool fullscreen) {
    SDL_SetWindowFullscreen(glass->window, fullscreen ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
}

void glass_resize(Glass *glass, int width, int height) {
    double density = glass_density(glass);
    SDL_SetWindowSize(glass->window, (int)(width / density), (int)(height / density));
}

const char *glass_clipboard(void *context) {
    Glass *glass = context;
    SDL_free(glass->clipboard);
    glass->clipboard = SDL_GetClipboardText();
    return glass->clipboard ? glass->clipboard : "";
}

void glass_set_clipboard(void *context, const char *text) {
    (void)context;
    SDL_SetClipboardText(text);
}

int32_t glass_key(const char *name) {
    return SDL_GetKeyFromName(name);
}

void glass_sleep(double seconds) {
    struct timespec left = {.tv_sec = (time_t)seconds, .tv_nsec = (long)(1e9 * (seconds - (double)(time_t)seconds))};
    while (nanosleep(&left, &left) != 0)
        continue;
}
