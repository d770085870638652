#include "command/frames.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "command/movie.h"
#include "command/output.h"
#include "command/plot_strip.h"
#include "draw/offscreen.h"
#include "draw/paint_gl.h"
#include "draw/png.h"
#include "laboratory/film.h"

enum {
    FRAMES_MOST = 1000000,
    WRITERS_MOST = 8,    /* threads: what one draws, no more can write, and each keeps pictures */
    RAISED_WIDTH = 1920, /* pixels, of a report's picture */
    RAISED_HEIGHT = 1200,
};

#define FPS_USUAL 30.0

/* All that a picture takes. */
typedef struct Studio {
    const Options *options;
    Film *film;
    Layout still, added, moving;
    Offscreen *offscreen;
    PaintGl *paint;
    PlotStrip strip;
} Studio;

bool frames_wanted(const Options *options) {
    bool raised = options->out && options->camera.kind == VIEW_RAISED;
    return options->frames > 0 || options->movie || raised || options->plots.count;
}

/* Kinds of film that are small and that everything plays. */
static bool is_film(const char *path) {
    static const char *const endings[] = {".mp4", ".mkv", ".mov", ".webm"};
    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof endings / sizeof *endings; i++)
        if (strcmp(dot, endings[i]) == 0)
            return true;
    return false;
}

int frames_check(const Options *options) {
    char message[PLOT_CHOICE_FAULT];
    if (options->frames > 0 && !options->out)
        fprintf(stderr, "clearance: --frames needs --out DIR, where they are written\n");
    else if (options->plot_words && !house_plots_choose(&(PlotChoice){.count = 0}, options->plot_words, message))
        fprintf(stderr, "clearance: --plots %s: %s\n", options->plot_words, message);
    else if (options->measured)
        fprintf(stderr, "clearance: --measured is for beams, %s is a house\n", options->files[0]);
    else if (options->plots.count && !options->out && !options->movie)
        fprintf(stderr, "clearance: --plots needs --out DIR, where they are written\n");
    else if (options->movie && !is_film(options->movie))
        fprintf(stderr, "clearance: --movie %s: its name must end in .mp4, .mkv, .mov or .webm\n", options->movie);
    else if (options->from >= 0 && options->to >= 0 && options->from > options->to)
        fprintf(stderr, "clearance: --from %g is after --to %g\n", options->from, options->to);
    else
        return 0;
    return EXIT_WRONG_INPUT;
}

/* A painter for pictures of the options' size; NULL: said on standard error. */
static PaintGl *create_painter(Studio *studio) {
    const Options *options = studio->options;
    char message[OFFSCREEN_MESSAGE];
    studio->offscreen = offscreen_create(OFFSCREEN_ANY, message);
    if (!studio->offscreen) {
        fprintf(stderr, "clearance: %s\n", message);
        return NULL;
    }
    PaintGl *paint = paint_gl_create(offscreen_gl(studio->offscreen), options->width, options->height, options->theme);
    if (!paint) {
        fprintf(stderr, "clearance: OpenGL has no room for pictures of %d x %d pixels: smaller ones would do\n",
                options->width, options->height);
        offscreen_destroy(studio->offscreen);
    }
    return paint;
}

/* Takes the plots. */
static bool open_studio(Studio *studio, const House *house, const Observation *observation, const FilmOptions *film,
                        HousePlots plots) {
    const Options *options = studio->options;
    studio->paint = create_painter(studio);
    if (!studio->paint) {
        house_plots_free(&plots);
        return false;
    }
    studio->film = film_create(house, observation, film);
    double unit = layout_unit(options->width, options->height);
    layout_make(&studio->still, film_still(studio->film), vec2(options->width / unit, options->height / unit));
    paint_gl_still(studio->paint, (Layer){film_still(studio->film), &studio->still});
    plot_strip_open(&studio->strip, plots, &studio->still, studio->paint, options);
    return true;
}

static void close_studio(Studio *studio) {
    plot_strip_close(&studio->strip);
    film_destroy(studio->film);
    layout_clear(&studio->still);
    layout_clear(&studio->added);
    layout_clear(&studio->moving);
    paint_gl_destroy(studio->paint);
    offscreen_destroy(studio->offscreen);
}

static void draw(Studio *studio, double time, unsigned char *pixels) {
    film_show(studio->film, time);
    layout_make_over(&studio->added, &studio->still, film_added(studio->film));
    layout_make_over(&studio->moving, &studio->still, film_moving(studio->film));
    paint_gl_add(studio->paint, (Layer){film_added(studio->film), &studio->added});
    plot_strip_show(&studio->strip, time, studio->paint, &studio->moving);
    paint_gl_frame(studio->paint, (Layer){film_moving(studio->film), &studio->moving});
    paint_gl_read(studio->paint, pixels);
}

/* The times that are shown: every 1 / fps s from the first on, and the end. */
typedef struct Times {
    double first, last, fps;
    size_t count;
} Times;

static Times times_of(const Options *options, double end) {
    Times times = {.first = fmin(fmax(options->from, 0), end),
                   .fps = options->frames > 0 ? options->frames : FPS_USUAL};
    times.last = options->to >= 0 ? fmin(options->to, end) : end;
    times.count = (size_t)fmax(0, ceil((times.last - times.first) * times.fps - 1e-9)) + 1;
    return times;
}

static void show_progress(size_t done, size_t count, bool shown) {
    if (shown && done % 10 == 0)
        fprintf(stderr, "\rpicture %zu of %zu ", done, count);
    if (shown && done == count)
        fprintf(stderr, "\r%*s\r", 40, "");
}

/* Those that an earlier, longer film has left: they would be taken for the end of this one. */
static void remove_later_frames(const char *out, size_t count) {
    char path[OUTPUT_PATH];
    do
        snprintf(path, sizeof path, "%s/frames/frame-%05zu.png", out, ++count);
    while (unlink(path) == 0);
}

/* False: a file could not be written; whoever ends writer and film says why. */
static bool write_frames(Studio *studio, Times times, PngWriter *writer, Movie *movie) {
    const Options *options = studio->options;
    bool shown = !options->quiet && isatty(STDERR_FILENO);
    unsigned char *own = writer ? NULL : memory_allocate((size_t)options->width * (size_t)options->height, 4);
    int error = 0;
    size_t done = 0;
    for (; done < times.count && !error && !command_interrupted; done++) {
        unsigned char *pixels = writer ? png_writer_room(writer) : own;
        draw(studio, fmin(times.first + (double)done / times.fps, times.last), pixels);
        if (movie)
            error = movie_add(movie, pixels);
        if (writer) {
            char path[OUTPUT_PATH];
            snprintf(path, sizeof path, "%s/frames/frame-%05zu.png", options->out, done + 1);
            png_writer_put(writer, path);
            error = error ? error : png_writer_error(writer);
        }
        show_progress(done + 1, times.count, shown);
    }
    memory_free(own);
    if (writer)
        remove_later_frames(options->out, done);
    return !error;
}

static bool write_all(Studio *studio, Times times) {
    const Options *options = studio->options;
    char path[OUTPUT_PATH];
    snprintf(path, sizeof path, "%s/frames", options->out ? options->out : "");
    if (options->frames > 0 && !output_directory(path))
        return false;
    Movie *movie = options->movie ? movie_begin(options->movie, options->width, options->height, times.fps) : NULL;
    if (options->movie && !movie)
        return false;
    int writers = options->jobs < WRITERS_MOST ? options->jobs : WRITERS_MOST;
    PngWriter *writer = options->frames > 0 ? png_writer_create(options->width, options->height, writers) : NULL;
    bool drawn = write_frames(studio, times, writer, movie);
    int error = writer ? png_writer_finish(writer) : 0;
    if (error)
        output_failed(path, error);
    bool filmed = !movie || movie_end(movie);
    return drawn && filmed && !error;
}

/* The last picture, in the raised view, beside plan.png. */
static bool write_raised(Studio *studio, double time) {
    const Options *options = studio->options;
    char path[OUTPUT_PATH];
    snprintf(path, sizeof path, "%s/raised.png", options->out);
    unsigned char *pixels = memory_allocate((size_t)options->width * (size_t)options->height, 4);
    draw(studio, time, pixels);
    int error = png_write(path, pixels, options->width, options->height);
    if (error)
        output_failed(path, error);
    memory_free(pixels);
    return !error;
}

/* All that is asked for and needs OpenGL; takes the plots. */
static bool write_pictures(const House *house, const Observation *observation, const FilmOptions *film,
                           HousePlots plots, Times times, const Options *options) {
    Studio studio = {.options = options};
    if (!open_studio(&studio, house, observation, film, plots))
        return false;
    bool good = true;
    if (options->frames > 0 || options->movie)
        good = write_all(&studio, times);
    if (good && options->out && options->camera.kind == VIEW_RAISED)
        good = write_raised(&studio, times.last);
    close_studio(&studio);
    return good;
}

bool frames_write(const House *house, const Observation *observation, Before before, const Options *options) {
    FilmOptions film = {
        .camera = options->camera, .panels = (int)options->plots.count, .shown = options->show, .before = before};
    Times times = times_of(options, observation->time);
    if (options->from > observation->time)
        fprintf(stderr, "clearance: --from %g is after the end of the run at %.1f s: the end is shown\n", options->from,
                observation->time);
    if (times.count > FRAMES_MOST) {
        fprintf(stderr, "clearance: these would be %zu pictures, at most %d: take fewer a second, or --from and --to\n",
                times.count, FRAMES_MOST);
        return false;
    }
    HousePlots plots = house_plots_make(house, observation, before.house, before.observation, &options->plots);
    if (options->out && !plot_strip_write(&plots, options)) {
        house_plots_free(&plots);
        return false;
    }
    if (options->frames > 0 || options->movie || options->camera.kind == VIEW_RAISED)
        return write_pictures(house, observation, &film, plots, times, options);
    house_plots_free(&plots);
    return true;
}

bool frames_draw_raised(const House *house, const Observation *observation, const Options *options,
                        RaisedPicture *picture) {
    Options own = *options;
    own.width = RAISED_WIDTH;
    own.height = RAISED_HEIGHT;
    own.theme = THEME_PAPER;
    own.camera.kind = VIEW_RAISED;
    own.plots.count = 0;
    Studio studio = {.options = &own};
    FilmOptions film = {.camera = own.camera, .bare = true, .shown = own.show};
    if (!open_studio(&studio, house, observation, &film, (HousePlots){.choice.count = 0}))
        return false;
    *picture = (RaisedPicture){memory_allocate((size_t)own.width * (size_t)own.height, 4), own.width, own.height};
    draw(&studio, observation->time, picture->pixels);
    close_studio(&studio);
    return true;
}
