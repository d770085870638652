/* A still picture of a moving one: the fixed part, one moment of the moving part, and plots in the panels next to it.
 */
#pragma once

#include "paint/cairo_file.h"
#include "draw/palette.h"
#include "plot/plot.h"
#include "draw/scene.h"

typedef struct Plate {
    const Scene *still, *moving;
    const Plot *plots; /* (still->panels) */
    Theme theme;
} Plate;

/* Paints for cairo_file_write: `plate` is a Plate. */
void plate_paint(struct _cairo *cairo, Vec2 page, const void *plate);

/* Writes a picture as paint_cairo_file does. */
int plate_write(CairoFileKind kind, const Plate *plate, const char *path, int width, int height);
