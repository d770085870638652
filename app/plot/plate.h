/* A still picture of a moving one: what stays, what is there at one moment, and plots in the panels beside it. */
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

/* For cairo_file_write: `plate` is a Plate. */
void plate_paint(struct _cairo *cairo, Vec2 page, const void *plate);

/* As paint_cairo_file. */
int plate_write(CairoFileKind kind, const Plate *plate, const char *path, int width, int height);
