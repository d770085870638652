/* Measures films in frames per second of clock time: drawing alone (static layer, moving layer, text, reading pixels
 * back), with scene and layout, and with PNG files: a house with four chairs, a hall of 1,000, and a beam with
 * plots. */

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "beam/beam_cycle.h"
#include "bench.h"
#include "command/studio.h"
#include "paint/offscreen.h"
#include "paint/paint_gl.h"
#include "paint/png.h"
#include "house/run.h"
#include "houses.h"
#include "visual/beam/beam_film.h"
#include "visual/house/film.h"

enum { TURNS = 7, FRAMES = 20 /* a turn */, SIZES = 2 };

static const int sizes[SIZES][2] = {{1280, 720}, {1920, 1080}};

typedef struct Show {
    const char *name;
    House house;
    Observation observation;
} Show;

/* A picture being made. */
typedef struct Screen {
    Film *film;
    PaintGl *paint;
    Layout still, added, moving;
    unsigned char *pixels;
} Screen;

/* Measures the times of making and of drawing a frame, s. */
static void show_frame(Screen *screen, double time, double *making, double *drawing) {
    double begin = bench_clock();
    film_show(screen->film, time);
    layout_make_over(&screen->added, &screen->still, film_added(screen->film));
    layout_make_over(&screen->moving, &screen->still, film_moving(screen->film));
    double made = bench_clock();
    paint_gl_add(screen->paint, (Layer){film_added(screen->film), &screen->added});
    paint_gl_frame(screen->paint, (Layer){film_moving(screen->film), &screen->moving});
    paint_gl_read(screen->paint, screen->pixels);
    *making += made - begin;
    *drawing += bench_clock() - made;
}

/* Measures the time per frame from the scene to a PNG file, s. */
static double write_frames(Screen *screen, const char *directory, int width, int height, double first, double step) {
    char path[64];
    unsigned char *own = screen->pixels;
    double begin = bench_clock();
    PngWriter *writer = png_writer_create(width, height, (int)sysconf(_SC_NPROCESSORS_ONLN));
    for (int frame = 0; frame < FRAMES; frame++) {
        screen->pixels = png_writer_room(writer);
        show_frame(screen, first + step * frame, &(double){0}, &(double){0});
        snprintf(path, sizeof path, "%s/%d.png", directory, frame);
        png_writer_put(writer, path);
    }
    png_writer_finish(writer);
    double seconds = (bench_clock() - begin) / FRAMES;
    screen->pixels = own;
    return seconds;
}

static void remove_frames(const char *directory) {
    char path[64];
    for (int frame = 0; frame < FRAMES; frame++) {
        snprintf(path, sizeof path, "%s/%d.png", directory, frame);
        unlink(path);
    }
    rmdir(directory);
}

static void measure(const Show *show, const Gl *gl, ViewKind view, int width, int height) {
    FilmOptions options = {.camera = {.kind = view, .azimuth = VIEW_AZIMUTH, .elevation = VIEW_ELEVATION}};
    double unit = layout_unit(width, height), drawing[TURNS] = {0}, making[TURNS] = {0}, whole[TURNS];
    double writing[TURNS] = {0};
    char directory[] = "/tmp/clearance-frames-XXXXXX";
    Screen screen = {.film = film_create(&show->house, &show->observation, &options),
                     .paint = paint_gl_create(gl, width, height, layout_unit(width, height), THEME_PAPER),
                     .pixels = memory_zeroed((size_t)width * (size_t)height, 4)};
    layout_make(&screen.still, film_still(screen.film), vec2(width / unit, height / unit));
    double begin = bench_clock();
    paint_gl_still(screen.paint, (Layer){film_still(screen.film), &screen.still});
    double first = bench_clock() - begin, step = show->observation.time / (TURNS * FRAMES + 1);
    show_frame(&screen, step, &(double){0}, &(double){0}); /* shaders are compiled when they are first used */
    for (int turn = 0; turn < TURNS; turn++) {
        for (int frame = 0; frame < FRAMES; frame++)
            show_frame(&screen, step * (turn * FRAMES + frame + 1), &making[turn], &drawing[turn]);
        making[turn] /= FRAMES;
        drawing[turn] /= FRAMES;
        whole[turn] = making[turn] + drawing[turn];
    }
    for (int turn = 0; turn < TURNS && (turn || mkdtemp(directory)); turn++) {
        paint_gl_still(screen.paint, (Layer){film_still(screen.film), &screen.still});
        writing[turn] = write_frames(&screen, directory, width, height, step * (turn * FRAMES + 1), step);
    }
    remove_frames(directory);
    double alone = bench_median(drawing, TURNS), both = bench_median(whole, TURNS), all = bench_median(writing, TURNS);
    printf("%-22s %-6s %4d x %-4d  %8.1f %9.0f   %8.1f %9.0f   %8.1f %9.0f   %8.0f\n", show->name,
           view == VIEW_RAISED ? "raised" : "plan", width, height, 1000 * alone, 1 / alone, 1000 * both, 1 / both,
           1000 * all, 1 / all, 1000 * first);
    layout_clear(&screen.still);
    layout_clear(&screen.added);
    layout_clear(&screen.moving);
    film_destroy(screen.film);
    paint_gl_destroy(screen.paint);
    memory_free(screen.pixels);
}

static bool show_beam(void *film, double time) {
    return beam_film_show(film, time);
}

static size_t beam_until(const void *owner, size_t plot, size_t series, double time) {
    return beam_film_until(owner, plot, series, time);
}

/* Measures a film of a beam with plots as a whole. */
static void film_beam(const StudioFilm *filmed, double last, const Options *options) {
    double drawn[TURNS], written[TURNS], step = last / (2 * TURNS * FRAMES);
    char directory[] = "/tmp/clearance-frames-XXXXXX", path[64];
    Studio studio;
    if (!mkdtemp(directory) || !studio_open(&studio, filmed, options))
        return;
    unsigned char *pixels = memory_zeroed((size_t)options->width * (size_t)options->height, 4);
    studio_draw(&studio, 0, pixels); /* shaders are compiled when they are first used */
    for (int turn = 0, frame = 0; turn < TURNS; turn++) {
        double begin = bench_clock();
        for (int i = 0; i < FRAMES; i++)
            studio_draw(&studio, step * ++frame, pixels);
        drawn[turn] = (bench_clock() - begin) / FRAMES;
        begin = bench_clock();
        PngWriter *writer = png_writer_create(options->width, options->height, (int)sysconf(_SC_NPROCESSORS_ONLN));
        for (int i = 0; i < FRAMES; i++) {
            studio_draw(&studio, step * ++frame, png_writer_room(writer));
            snprintf(path, sizeof path, "%s/%d.png", directory, i);
            png_writer_put(writer, path);
        }
        png_writer_finish(writer);
        written[turn] = (bench_clock() - begin) / FRAMES;
    }
    double both = bench_median(drawn, TURNS), all = bench_median(written, TURNS);
    printf("%-29s %4d x %-4d  %8s %9s   %8.1f %9.0f   %8.1f %9.0f\n", "beam with two plots", options->width,
           options->height, "", "", 1000 * both, 1 / both, 1000 * all, 1 / all);
    memory_free(pixels);
    studio_close(&studio);
    remove_frames(directory);
}

static void measure_beam(const char *source) {
    char path[4096];
    Beam beam = {0};
    Rig rig;
    Fault fault = {0};
    Response response;
    BeamRecord record;
    snprintf(path, sizeof path, "%s/assets/beams/ibs.json", source);
    if (!beam_read(&beam, path, NULL, 0, &fault) || !rig_build(&rig, &beam, path, &fault))
        return;
    beam_cycle_respond(&response, &rig, &beam, NULL, NULL);
    beam_record_make(&record, &rig, &response);
    double last = BEAM_FILM_CYCLES * rig.period;
    beam_record_sample(&record, (BeamSpan){0, last, 2 * TURNS * FRAMES / last});
    for (int size = 0; size < SIZES; size++) {
        BeamFilm *film = beam_film_create(&beam, &rig, &response, &record, beam_film_slow(beam.frequency));
        StudioFilm filmed = {film,
                             show_beam,
                             beam_film_still(film),
                             beam_film_added(film),
                             beam_film_moving(film),
                             {beam_film_plots(film), BEAM_FILM_PLOTS, rig.period / 4, ROLE_PAPER, film, beam_until}};
        film_beam(&filmed, last, &(Options){.width = sizes[size][0], .height = sizes[size][1]});
        beam_film_destroy(film);
    }
    beam_record_clear(&record);
    response_clear(&response);
    rig_clear(&rig);
    beam_free(&beam);
}

int main(int argc, char **argv) {
    const char *source = argc > 1 ? argv[1] : ".";
    char message[OFFSCREEN_MESSAGE];
    Offscreen *offscreen = offscreen_create(OFFSCREEN_ANY, message);
    if (!offscreen) {
        printf("%s\n", message);
        return 77;
    }
    Show shows[] = {{.name = "house, four chairs"}, {.name = "hall of 1,000 adults"}};
    houses_read_ube(&shows[0].house, source);
    houses_read_hall(&shows[1].house, source, "adult", 31.63, 1);
    shows[1].house.plan.run.until = 3;
    printf("software rendering by %s, %ld processors; median of %d turns of %d frames, by the clock\n\n",
           offscreen_kind(offscreen) == OFFSCREEN_OSMESA ? "OSMesa" : "EGL", sysconf(_SC_NPROCESSORS_ONLN), TURNS,
           FRAMES);
    printf("%-42s %8s %9s   %8s %9s   %8s %9s   %8s\n", "", "drawn ms", "frames/s", "made too", "frames/s", "PNG too",
           "frames/s", "static ms");
    for (size_t i = 0; i < sizeof shows / sizeof *shows; i++) {
        run_house(&shows[i].observation, &shows[i].house, &(RunOptions){.route = SIZE_MAX, .jobs = 2});
        for (ViewKind view = VIEW_PLAN; view <= VIEW_RAISED; view++)
            for (int size = 0; size < SIZES; size++)
                measure(&shows[i], offscreen_gl(offscreen), view, sizes[size][0], sizes[size][1]);
        observation_free(&shows[i].observation);
        house_free(&shows[i].house);
    }
    offscreen_destroy(offscreen);
    measure_beam(source);
    return 0;
}
