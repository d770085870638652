/* OpenGL without a display, a window or a graphics card: Mesa's software renderer by OSMesa, or else by EGL without a
 * surface. Both are looked for when they are needed, so that the program starts without them. */
#pragma once

#include "paint/gl.h"

typedef struct Offscreen Offscreen;

typedef enum OffscreenKind { OFFSCREEN_ANY, OFFSCREEN_OSMESA, OFFSCREEN_EGL } OffscreenKind;

enum { OFFSCREEN_MESSAGE = 512 };

/* A context of OpenGL 3.3 core, current on this thread, on which no other may be current, until offscreen_destroy. ANY
 * takes the first that works; the environment's CLEARANCE_GL=osmesa or =egl takes just one. NULL: `message` says in one
 * line why there is none, and what would help. */
Offscreen *offscreen_create(OffscreenKind kind, char message[OFFSCREEN_MESSAGE]);
void offscreen_destroy(Offscreen *offscreen);

/* Which one it became. */
OffscreenKind offscreen_kind(const Offscreen *offscreen);

const Gl *offscreen_gl(const Offscreen *offscreen);
