#include "command/studio.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "command/movie.h"
#include "command/output.h"
#include "command/progress.h"
#include "platform/terminal.h"
#include "paint/png.h"

enum {
    FRAMES_MOST = 1000000,
    WRITERS_MOST = 8, /* threads; more cannot be kept busy by one that draws, and each holds pictures in memory */
};

/* True if the ending is of a kind of film that is small and widely played. */
static bool is_film(const char *path) {
    static const char *const endings[] = {".mp4", ".mkv", ".mov", ".webm"};
    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof endings / sizeof *endings; i++)
        if (strcmp(dot, endings[i]) == 0)
            return true;
    return false;
}

int studio_check(const Options *options) {
    if (options->frames > 0 && !options->out)
        fprintf(stderr, "clearance: --frames needs --out DIR, the directory to write them to\n");
    else if (options->movie && !is_film(options->movie))
        fprintf(stderr, "clearance: --movie %s: the name must end in .mp4, .mkv, .mov or .webm\n", options->movie);
    else if (options->from >= 0 && options->to >= 0 && options->from > options->to)
        fprintf(stderr, "clearance: --from %g is after --to %g\n", options->from, options->to);
    else
        return 0;
    return EXIT_WRONG_INPUT;
}

/* Returns a painter for pictures of the options' size; NULL after an error on standard error. */
static PaintGl *create_painter(Studio *studio) {
    const Options *options = studio->options;
    char message[OFFSCREEN_MESSAGE];
    studio->offscreen = offscreen_create(OFFSCREEN_ANY, message);
    if (!studio->offscreen) {
        fprintf(stderr, "clearance: %s\n", message);
        return NULL;
    }
    PaintGl *paint = paint_gl_create(offscreen_gl(studio->offscreen), options->width, options->height,
                                     layout_unit(options->width, options->height), options->theme);
    if (!paint) {
        fprintf(stderr, "clearance: OpenGL cannot make pictures of %d x %d pixels; use a smaller --size\n",
                options->width, options->height);
        offscreen_destroy(studio->offscreen);
    }
    return paint;
}

bool studio_open(Studio *studio, const StudioFilm *film, const Options *options) {
    *studio = (Studio){.options = options, .film = *film};
    studio->paint = create_painter(studio);
    if (!studio->paint)
        return false;
    double unit = layout_unit(options->width, options->height);
    layout_make(&studio->still, film->still, vec2(options->width / unit, options->height / unit));
    paint_gl_still(studio->paint, (Layer){film->still, &studio->still});
    plot_strip_open(&studio->strip, &film->plots, &studio->still, studio->paint, options);
    return true;
}

void studio_close(Studio *studio) {
    plot_strip_close(&studio->strip);
    layout_clear(&studio->still);
    layout_clear(&studio->added);
    layout_clear(&studio->moving);
    paint_gl_destroy(studio->paint);
    offscreen_destroy(studio->offscreen);
}

void studio_draw(Studio *studio, double time, unsigned char *pixels) {
    const StudioFilm *film = &studio->film;
    film->show(film->film, time);
    layout_make_over(&studio->added, &studio->still, film->added);
    layout_make_over(&studio->moving, &studio->still, film->moving);
    paint_gl_add(studio->paint, (Layer){film->added, &studio->added});
    plot_strip_show(&studio->strip, time, studio->paint, &studio->moving);
    paint_gl_frame(studio->paint, (Layer){film->moving, &studio->moving});
    paint_gl_read(studio->paint, pixels);
}

StudioTimes studio_times(double first, double last, double rate, double fps) {
    StudioTimes times = {.first = first, .last = last, .rate = rate, .fps = fps};
    times.count = (size_t)fmax(0, ceil((last - first) * rate - 1e-9)) + 1;
    return times;
}

bool studio_can_take(const StudioTimes *times) {
    if (times->count > FRAMES_MOST)
        fprintf(stderr,
                "clearance: that makes %zu pictures, but at most %d are possible; use a smaller --frames, or --from "
                "and --to\n",
                times->count, FRAMES_MOST);
    return times->count <= FRAMES_MOST;
}

static void show_progress(size_t done, size_t count, bool shown) {
    if (shown && done % 10 == 0)
        terminal_progress("picture %zu of %zu ", done, count);
    if (shown && done == count)
        terminal_clear_progress();
}

/* Removes pictures that an earlier, longer film has left: they look like the end of this one. */
static void remove_later_frames(const char *out, size_t count) {
    char path[OUTPUT_PATH];
    do
        snprintf(path, sizeof path, "%s/frames/frame-%05zu.png", out, ++count);
    while (unlink(path) == 0);
}

/* Draws and writes the pictures. False: a file could not be written; the caller prints why. */
static bool write_frames(Studio *studio, const StudioTimes *times, PngWriter *writer, Movie *movie) {
    const Options *options = studio->options;
    bool shown = progress_is_shown(options);
    unsigned char *own = writer ? NULL : memory_zeroed((size_t)options->width * (size_t)options->height, 4);
    int error = 0;
    size_t done = 0;
    for (; done < times->count && !error && !progress_interrupted(); done++) {
        unsigned char *pixels = writer ? png_writer_room(writer) : own;
        studio_draw(studio, fmin(times->first + (double)done / times->rate, times->last), pixels);
        if (movie)
            error = movie_add(movie, pixels);
        if (writer) {
            char path[OUTPUT_PATH];
            snprintf(path, sizeof path, "%s/frames/frame-%05zu.png", options->out, done + 1);
            png_writer_put(writer, path);
            error = error ? error : png_writer_error(writer);
        }
        show_progress(done + 1, times->count, shown);
    }
    memory_free(own);
    if (writer)
        remove_later_frames(options->out, done);
    return !error;
}

bool studio_write(Studio *studio, const StudioTimes *times) {
    const Options *options = studio->options;
    char path[OUTPUT_PATH];
    snprintf(path, sizeof path, "%s/frames", options->out ? options->out : "");
    if (options->frames > 0 && !output_directory(path))
        return false;
    Movie *movie = options->movie ? movie_begin(options->movie, options->width, options->height, times->fps) : NULL;
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
