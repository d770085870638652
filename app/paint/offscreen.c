#include "paint/offscreen.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EGL_EGLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/osmesa.h>

#include "base/memory.h"

#define OSMESA_LIBRARY "libOSMesa.so.8"
#define EGL_LIBRARY "libEGL.so.1"
#define OFFSCREEN_VARIABLE "CLEARANCE_GL"

/* The functions of each library, by their names in its header; looked up at run time. */
#define OSMESA_FUNCTIONS(X)                                                                                            \
    X(OSMesaCreateContextAttribs)                                                                                      \
    X(OSMesaDestroyContext)                                                                                            \
    X(OSMesaGetProcAddress)                                                                                            \
    X(OSMesaMakeCurrent)

#define EGL_FUNCTIONS(X)                                                                                               \
    X(eglBindAPI)                                                                                                      \
    X(eglCreateContext)                                                                                                \
    X(eglDestroyContext)                                                                                               \
    X(eglGetPlatformDisplay)                                                                                           \
    X(eglGetProcAddress)                                                                                               \
    X(eglInitialize)                                                                                                   \
    X(eglMakeCurrent)

#define OFFSCREEN_MEMBER(name_) __typeof__(name_) *name_;

struct Offscreen {
    OffscreenKind kind;
    Gl gl;
    struct {
        OSMESA_FUNCTIONS(OFFSCREEN_MEMBER)
        OSMesaContext context;
        unsigned char pixel[4]; /* OSMesa needs a buffer; painters have a framebuffer of their own */
    } osmesa;
    struct {
        EGL_FUNCTIONS(OFFSCREEN_MEMBER)
        EGLDisplay display;
        EGLContext context;
    } egl;
};

/* Keeps a driver's library open: drivers do not survive being closed. */
static void *library_open(const char *name) {
    return dlopen(name, RTLD_NOW | RTLD_LOCAL);
}

static bool osmesa_load(Offscreen *offscreen) {
    void *library = library_open(OSMESA_LIBRARY);
    if (!library)
        return false;
    bool found = true;
#define OFFSCREEN_FIND(name_) found &= (offscreen->osmesa.name_ = dlsym(library, #name_)) != NULL;
    OSMESA_FUNCTIONS(OFFSCREEN_FIND)
#undef OFFSCREEN_FIND
    return found;
}

static void osmesa_end(Offscreen *offscreen) {
    if (!offscreen->osmesa.context)
        return;
    offscreen->osmesa.OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    offscreen->osmesa.OSMesaDestroyContext(offscreen->osmesa.context);
    offscreen->osmesa.context = NULL;
}

static bool osmesa_begin(Offscreen *offscreen) {
    static const int attributes[] = {OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     3,
                                     0};
    if (!osmesa_load(offscreen))
        return false;
    offscreen->osmesa.context = offscreen->osmesa.OSMesaCreateContextAttribs(attributes, NULL);
    if (offscreen->osmesa.context &&
        offscreen->osmesa.OSMesaMakeCurrent(offscreen->osmesa.context, offscreen->osmesa.pixel, GL_UNSIGNED_BYTE, 1,
                                            1) &&
        gl_load(&offscreen->gl, (GlGetFunction)offscreen->osmesa.OSMesaGetProcAddress))
        return true;
    osmesa_end(offscreen);
    return false;
}

static bool egl_load(Offscreen *offscreen) {
    void *library = library_open(EGL_LIBRARY);
    if (!library)
        return false;
    bool found = true;
#define OFFSCREEN_FIND(name_) found &= (offscreen->egl.name_ = dlsym(library, #name_)) != NULL;
    EGL_FUNCTIONS(OFFSCREEN_FIND)
#undef OFFSCREEN_FIND
    return found;
}

/* The display belongs to the process and stays open: closing it unloads the driver, whose threads may still run. */
static void egl_end(Offscreen *offscreen) {
    if (!offscreen->egl.display)
        return;
    offscreen->egl.eglMakeCurrent(offscreen->egl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (offscreen->egl.context)
        offscreen->egl.eglDestroyContext(offscreen->egl.display, offscreen->egl.context);
    offscreen->egl.display = NULL;
}

static bool egl_make_current(Offscreen *offscreen) {
    static const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLDisplay display = offscreen->egl.display;
    if (!offscreen->egl.eglInitialize(display, NULL, NULL) || !offscreen->egl.eglBindAPI(EGL_OPENGL_API))
        return false;
    offscreen->egl.context = offscreen->egl.eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    return offscreen->egl.context &&
           offscreen->egl.eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, offscreen->egl.context);
}

static bool egl_begin(Offscreen *offscreen) {
    if (!egl_load(offscreen))
        return false;
    offscreen->egl.display =
        offscreen->egl.eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (offscreen->egl.display && egl_make_current(offscreen) &&
        gl_load(&offscreen->gl, offscreen->egl.eglGetProcAddress))
        return true;
    egl_end(offscreen);
    return false;
}

/* Reads the kind that the environment asks for, which overrides the caller's; false if the environment names an
 * unknown kind. */
static bool choose_kind(OffscreenKind *kind, const char *name) {
    static const char *const names[] = {[OFFSCREEN_OSMESA] = "osmesa", [OFFSCREEN_EGL] = "egl"};
    if (*kind != OFFSCREEN_ANY || !name)
        return true;
    for (*kind = OFFSCREEN_OSMESA; *kind <= OFFSCREEN_EGL; (*kind)++)
        if (strcmp(name, names[*kind]) == 0)
            return true;
    return false;
}

static const char *kind_need(OffscreenKind kind) {
    static const char *const needs[] = {
        [OFFSCREEN_ANY] = "neither OSMesa nor EGL gives OpenGL 3.3: on Debian install libosmesa6, or libegl1, "
                          "libegl-mesa0 and libgl1-mesa-dri",
        [OFFSCREEN_OSMESA] = "OSMesa gives no OpenGL 3.3: on Debian install libosmesa6",
        [OFFSCREEN_EGL] =
            "EGL gives no OpenGL 3.3 without a display: on Debian install libegl1, libegl-mesa0 and libgl1-mesa-dri"};
    return needs[kind];
}

Offscreen *offscreen_create(OffscreenKind kind, char message[OFFSCREEN_MESSAGE]) {
    const char *name = getenv(OFFSCREEN_VARIABLE);
    if (!choose_kind(&kind, name)) {
        snprintf(message, OFFSCREEN_MESSAGE, "cannot draw: %s is \"%.40s\": osmesa or egl", OFFSCREEN_VARIABLE, name);
        return NULL;
    }
    Offscreen *offscreen = memory_zeroed(1, sizeof *offscreen);
    if (kind != OFFSCREEN_EGL && osmesa_begin(offscreen)) {
        offscreen->kind = OFFSCREEN_OSMESA;
        return offscreen;
    }
    if (kind != OFFSCREEN_OSMESA && egl_begin(offscreen)) {
        offscreen->kind = OFFSCREEN_EGL;
        return offscreen;
    }
    snprintf(message, OFFSCREEN_MESSAGE, "cannot draw: %s", kind_need(kind));
    memory_free(offscreen);
    return NULL;
}

void offscreen_destroy(Offscreen *offscreen) {
    osmesa_end(offscreen);
    egl_end(offscreen);
    memory_free(offscreen);
}

OffscreenKind offscreen_kind(const Offscreen *offscreen) {
    return offscreen->kind;
}

const Gl *offscreen_gl(const Offscreen *offscreen) {
    return &offscreen->gl;
}
