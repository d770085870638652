/* Draws the pictures of a film by OpenGL without a screen, writes them as files and passes them to ffmpeg. */
#pragma once

#include "options/options.h"
#include "command/plot_strip.h"
#include "paint/offscreen.h"
#include "paint/paint_gl.h"

#define STUDIO_FPS 30.0 /* 1/s, pictures per second of a film without --frames */

/* Checks that the options for films fit together. Returns 0, or an exit code after an error on standard error. */
int studio_check(const Options *options);

/* The subject of a film, of any laboratory. */
typedef struct StudioFilm {
    void *film;
    bool (*show)(void *film, double time); /* sets `added` and `moving` to a time, s; see film.h */
    const Scene *still, *added, *moving;
    PlotStripSource plots; /* for the panels of `still` */
} StudioFilm;

/* The times of the pictures: every 1 / rate s from the first on, and the last. */
typedef struct StudioTimes {
    double first, last; /* s, simulated */
    double rate;        /* 1/s, pictures per simulated second */
    double fps;         /* 1/s, pictures per second of the film */
    size_t count;       /* pictures */
} StudioTimes;

StudioTimes studio_times(double first, double last, double rate, double fps);

/* True if the pictures are not too many; otherwise an error was printed. */
bool studio_can_take(const StudioTimes *times);

/* The painter, the layouts and the plots of a picture. */
typedef struct Studio {
    const Options *options;
    StudioFilm film;
    Layout still, added, moving;
    Offscreen *offscreen;
    PaintGl *paint;
    PlotStrip strip;
} Studio;

/* Opens a studio for pictures of the options' size and theme; film and options must outlive it. False: an error was
 * printed, and studio_close must not be called. */
bool studio_open(Studio *studio, const StudioFilm *film, const Options *options);
void studio_close(Studio *studio);

/* Draws one picture of width x height pixels of 4 bytes. Times must not fall, since plots only grow. */
void studio_draw(Studio *studio, double time, unsigned char *pixels);

/* Writes --out's frames/frame-00001.png and so on, and --movie, with progress. Ctrl-C keeps complete
 * files. False: an error was printed. */
bool studio_write(Studio *studio, const StudioTimes *times);
