/* Draws boxes, lines, pictures and texts by Dear ImGui; ui.cpp implements it. */
#pragma once

#include <stdint.h>

#include "widgets/ui.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct UiPainter UiPainter;

typedef uint32_t UiInk; /* red, green, blue, opacity: bytes from the lowest */

/* Later layers lie over earlier ones, whatever the drawing order. */
typedef enum UiLayer { UI_LAYER_PANES, UI_LAYER_MODAL, UI_LAYER_TIP, UI_LAYER_COUNT } UiLayer;

UiPainter *ui_painter_create(PaintGlScreen *screen);
void ui_painter_destroy(UiPainter *painter);
void ui_painter_begin(UiPainter *painter, int width, int height, double unit, double seconds);
void ui_painter_end(UiPainter *painter);
bool ui_painter_is_stale(const UiPainter *painter); /* the next frame has other glyphs */
void ui_painter_layer(UiPainter *painter, UiLayer layer);

/* Clips to the box and those around it, until ui_painter_unclip. */
void ui_painter_clip(UiPainter *painter, Box box);
void ui_painter_unclip(UiPainter *painter);

/* Returns the size of a style's text, design points. */
double ui_painter_size(UiTextStyle style);

Vec2 ui_painter_extent(UiPainter *painter, UiTextStyle style, const char *text, size_t bytes);

/* Returns how many bytes of the text are one line of at most that width; a line ends before a space or at a newline. */
size_t ui_painter_wrap(UiPainter *painter, UiTextStyle style, const char *text, double width);

/* Boxes lie on whole pixels. at.y is the middle of the capitals. */
void ui_painter_text(UiPainter *painter, UiTextStyle style, UiInk ink, Vec2 at, const char *text, size_t bytes);
const UiPainted *ui_painter_painted(UiPainter *painter, size_t *count); /* see ui_painted */
void ui_painter_ground(UiPainter *painter, Box box, Colour colour);     /* large and opaque: the quick way */
void ui_painter_box(UiPainter *painter, Box box, UiInk ink);
void ui_painter_frame(UiPainter *painter, Box box, double width, UiInk ink);
void ui_painter_polyline(UiPainter *painter, const Vec2 *points, size_t count, bool closed, double width, UiInk ink);
void ui_painter_convex(UiPainter *painter, const Vec2 *points, size_t count, UiInk ink);
void ui_painter_disc(UiPainter *painter, Vec2 middle, double radius, UiInk ink);
void ui_painter_image(UiPainter *painter, const ScreenTexture *texture, Box box);
void ui_painter_picture(UiPainter *painter, const ScreenTexture *texture, const Vec2 corners[4], double opacity);

#ifdef __cplusplus
}
#endif
