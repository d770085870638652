#include "command/frames.h"

#include <stdio.h>

#include "command/output.h"
#include "command/studio.h"
#include "paint/png.h"
#include "result/source_line.h"
#include "visual/house/film.h"

enum {
    RAISED_WIDTH = 1920, /* pixels, of a picture in a report */
    RAISED_HEIGHT = 1200,
};

bool frames_wanted(const Options *options) {
    bool raised = options->out && options->camera.kind == VIEW_RAISED;
    return options->frames > 0 || options->movie || raised || options->plots.count;
}

int frames_check(const Options *options) {
    char message[PLOT_CHOICE_FAULT];
    if (options->slow > 0)
        fprintf(stderr, "clearance: --slow is for beams, %s is a house\n", options->files[0]);
    else if (options->plot_words && !house_plots_choose(&(PlotChoice){.count = 0}, options->plot_words, message))
        fprintf(stderr, "clearance: --plots %s: %s\n", options->plot_words, message);
    else if (options->measured)
        fprintf(stderr, "clearance: --measured is for beams, %s is a house\n", options->files[0]);
    else if (options->plots.count && !options->out && !options->movie)
        fprintf(stderr, "clearance: --plots needs --out DIR, the directory to write them to\n");
    else
        return studio_check(options);
    return EXIT_WRONG_INPUT;
}

static bool show_house(void *film, double time) {
    return film_show(film, time);
}

static size_t house_until(const void *owner, size_t plot, size_t series, double time) {
    return house_plots_until(owner, plot, series, time);
}

/* Returns a film of a house with plots next to it. */
static StudioFilm film_of_house(Film *film, const HousePlots *plots) {
    return (StudioFilm){.film = film,
                        .show = show_house,
                        .still = film_still(film),
                        .added = film_added(film),
                        .moving = film_moving(film),
                        .plots = {plots->plots, plots->choice.count, 0, ROLE_PAPER, plots, house_until}};
}

/* Returns the times from --from to --to, by default of the whole run. */
static StudioTimes times_of(const Options *options, double end) {
    double fps = options->frames > 0 ? options->frames : STUDIO_FPS;
    return studio_times(fmin(fmax(options->from, 0), end), options->to >= 0 ? fmin(options->to, end) : end, fps, fps);
}

/* Writes the last picture in the raised view, next to plan.png. */
static bool write_raised(Studio *studio, double time) {
    const Options *options = studio->options;
    char path[OUTPUT_PATH];
    snprintf(path, sizeof path, "%s/raised.png", options->out);
    unsigned char *pixels = memory_zeroed((size_t)options->width * (size_t)options->height, 4);
    studio_draw(studio, time, pixels);
    int error = png_write(path, pixels, options->width, options->height);
    if (error)
        output_failed(path, error);
    memory_free(pixels);
    return !error;
}

/* Writes the pictures that need OpenGL. */
static bool write_pictures(Film *film, const HousePlots *plots, const StudioTimes *times, const Options *options) {
    StudioFilm filmed = film_of_house(film, plots);
    Studio studio;
    if (!studio_open(&studio, &filmed, options))
        return false;
    bool good = true;
    if (options->frames > 0 || options->movie)
        good = studio_write(&studio, times);
    if (good && options->out && options->camera.kind == VIEW_RAISED)
        good = write_raised(&studio, times->last);
    studio_close(&studio);
    return good;
}

bool frames_write(const House *house, const Observation *observation, Before before, const FramesFacts *facts,
                  const Options *options) {
    FilmOptions wish = {.camera = options->camera,
                        .changed = options->setting_count > 0,
                        .panels = (int)options->plots.count,
                        .shown = options->show,
                        .before = before,
                        .letters = facts->letters,
                        .drivers = facts->drivers};
    StudioTimes times = times_of(options, observation->time);
    if (options->from > observation->time)
        fprintf(stderr, "clearance: --from %g is after the end of the run at %.1f s: the end is shown\n", options->from,
                observation->time);
    if (!studio_can_take(&times))
        return false;
    HousePlots plots = house_plots_make(house, observation, before.house, before.observation, &options->plots);
    Arena arena = {0};
    bool good = !options->out || plot_strip_write(&plots, source_line_house(&house->plan, &arena), options);
    arena_clear(&arena);
    if (good && (options->frames > 0 || options->movie || options->camera.kind == VIEW_RAISED)) {
        Film *film = film_create(house, observation, &wish);
        good = write_pictures(film, &plots, &times, options);
        film_destroy(film);
    }
    house_plots_free(&plots);
    return good;
}

bool frames_draw_raised(const House *house, const Observation *observation, const Options *options,
                        RaisedPicture *picture) {
    Options own = *options;
    own.width = RAISED_WIDTH;
    own.height = RAISED_HEIGHT;
    own.theme = THEME_PAPER;
    own.camera.kind = VIEW_RAISED;
    FilmOptions wish = {.camera = own.camera, .bare = true, .shown = own.show};
    Film *film = film_create(house, observation, &wish);
    StudioFilm filmed = film_of_house(film, &(HousePlots){.choice.count = 0});
    Studio studio;
    bool good = studio_open(&studio, &filmed, &own);
    if (good) {
        *picture = (RaisedPicture){memory_zeroed((size_t)own.width * (size_t)own.height, 4), own.width, own.height};
        studio_draw(&studio, observation->time, picture->pixels);
        studio_close(&studio);
    }
    film_destroy(film);
    return good;
}
