/* Pictures of a film, drawn by OpenGL without a screen, one after the other: as files, and handed to ffmpeg. */
#pragma once

#include "options/options.h"
#include "command/plot_strip.h"
#include "paint/offscreen.h"
#include "paint/paint_gl.h"

#define STUDIO_FPS 30.0 /* pictures a s of a film, where --frames does not say */

/* Says on standard error what of the options for films does not go together; 0 or an exit code. */
int studio_check(const Options *options);

/* What is filmed, of whatever laboratory. */
typedef struct StudioFilm {
    void *film;
    bool (*show)(void *film, double time); /* makes `added` and `moving` those of a time, s; see film.h */
    const Scene *still, *added, *moving;
    PlotStripSource plots; /* in the panels of `still` */
} StudioFilm;

/* The times that are shown: every 1 / rate s from the first on, and the last. */
typedef struct StudioTimes {
    double first, last; /* s, simulated */
    double rate;        /* pictures a simulated s */
    double fps;         /* pictures a s of the film */
    size_t count;       /* pictures */
} StudioTimes;

StudioTimes studio_times(double first, double last, double rate, double fps);

/* False: they are too many, said on standard error. */
bool studio_can_take(const StudioTimes *times);

/* All that a picture takes. */
typedef struct Studio {
    const Options *options;
    StudioFilm film;
    Layout still, added, moving;
    Offscreen *offscreen;
    PaintGl *paint;
    PlotStrip strip;
} Studio;

/* For pictures of the options' size and theme; film and options must outlive it. False: said on standard error, and
 * there is nothing to close. */
bool studio_open(Studio *studio, const StudioFilm *film, const Options *options);
void studio_close(Studio *studio);

/* One picture, width x height pixels of 4 bytes; plots grow, they do not go back. */
void studio_draw(Studio *studio, double time, unsigned char *pixels);

/* Writes --out's frames/frame-00001.png and so on, and --movie, with progress on standard error when that is a
 * terminal. Ctrl-C keeps what is complete. False: said on standard error. */
bool studio_write(Studio *studio, const StudioTimes *times);
