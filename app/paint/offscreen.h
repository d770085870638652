/* OpenGL without a display, a window or a graphics card: Mesa's software renderer by OSMesa, or else by EGL without a
 * surface. Both are looked for when needed, so that the program starts without them. */
#pragma once

#include "paint/gl.h"

typedef struct Offscreen Offscreen;

typedef enum OffscreenKind { OFFSCREEN_ANY, OFFSCREEN_OSMESA, OFFSCREEN_EGL } OffscreenKind;

enum { OFFSCREEN_MESSAGE = 512 };

/* Makes a context of OpenGL 3.3 core and makes it current on this thread, which must have no other current context,
 * until offscreen_destroy. ANY takes the first kind that works; the environment variable CLEARANCE_GL=osmesa or =egl
 * selects one kind. NULL on failure: `message` then holds one line with the reason and the remedy. */
Offscreen *offscreen_create(OffscreenKind kind, char message[OFFSCREEN_MESSAGE]);
void offscreen_destroy(Offscreen *offscreen);

/* Returns the kind that was made. */
OffscreenKind offscreen_kind(const Offscreen *offscreen);

const Gl *offscreen_gl(const Offscreen *offscreen);
