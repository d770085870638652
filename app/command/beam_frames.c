#include "command/beam_frames.h"

#include <stdio.h>

#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "command/studio.h"
#include "plot/plate.h"
#include "plot/plot_write.h"
#include "result/source_line.h"
#include "visual/beam/beam_film.h"
#include "visual/beam/beam_plots.h"

#define TAIL 0.25 /* cycles before the present that are drawn thick */

/* The beam that is drawn. */
typedef struct Subject {
    const Beam *beam;
    const Rig *rig;
    const Response *response;
    BeamRecord *record;
} Subject;

int beam_frames_check(const Options *options) {
    const char *foreign = options->camera.kind == VIEW_RAISED ? "--view raised" : options->show ? "--show" : NULL;
    if (foreign)
        fprintf(stderr, "clearance: %s is for houses, %s is a beam\n", foreign, options->files[0]);
    return foreign ? EXIT_WRONG_INPUT : studio_check(options);
}

/* Still pictures ----------------------------------------------------------------------------------------------------*/

static bool write_plate(const Plate *plate, const Options *options) {
    char path[OUTPUT_PATH];
    int error = 0;
    for (CairoFileKind kind = CAIRO_FILE_PNG; kind <= CAIRO_FILE_PDF && !error; kind++) {
        snprintf(path, sizeof path, "%s/beam.%s", options->out, cairo_file_endings[kind]);
        error = plate_write(kind, plate, path, options->width, options->height);
    }
    if (error)
        output_failed(path, error);
    return !error;
}

/* Centres some cycles on the moment of the largest force. */
static bool write_still(const Subject *subject, const Options *options) {
    BeamRecord *record = subject->record;
    double period = subject->rig->period, around = fmin(BEAM_FILM_CYCLES * period, record->time);
    double first = period * floor((record->hardest - around / 2) / period);
    first = fmax(0, fmin(first, record->time - around));
    beam_record_sample(record, (BeamSpan){first, first + around, 1 / period});
    BeamFilm *film = beam_film_create(subject->beam, subject->rig, subject->response, record, 0);
    beam_film_show(film, record->hardest);
    beam_film_mark(film);
    Plate plate = {beam_film_still(film), beam_film_moving(film), beam_film_plots(film), options->theme};
    bool written = write_plate(&plate, options);
    beam_film_destroy(film);
    return written;
}

/* Films -------------------------------------------------------------------------------------------------------------*/

static bool show_beam(void *film, double time) {
    return beam_film_show(film, time);
}

static size_t beam_until(const void *owner, size_t plot, size_t series, double time) {
    return beam_film_until(owner, plot, series, time);
}

/* Returns some cycles from --from on, or the time up to --to. */
static StudioTimes times_of(const Subject *subject, double slow, const Options *options) {
    double fps = options->frames > 0 ? options->frames : STUDIO_FPS, end = subject->record->time;
    double first = fmin(fmax(options->from, 0), end);
    double last = options->to >= 0 ? options->to : first + BEAM_FILM_CYCLES * subject->rig->period;
    return studio_times(first, fmin(last, end), fps * slow, fps);
}

static bool write_film(const Subject *subject, const Options *options) {
    BeamRecord *record = subject->record;
    double slow = options->slow > 0 ? options->slow : beam_film_slow(subject->beam->frequency);
    StudioTimes times = times_of(subject, slow, options);
    if (options->from > record->time)
        fprintf(stderr, "clearance: --from %g is after the end of the record at %g s: the end is shown\n",
                options->from, record->time);
    if (!studio_can_take(&times))
        return false;
    beam_record_sample(record, (BeamSpan){times.first, times.last, times.rate});
    BeamFilm *film = beam_film_create(subject->beam, subject->rig, subject->response, record, slow);
    StudioFilm filmed = {.film = film,
                         .show = show_beam,
                         .still = beam_film_still(film),
                         .added = beam_film_added(film),
                         .moving = beam_film_moving(film),
                         .plots = {beam_film_plots(film), BEAM_FILM_PLOTS, TAIL * subject->rig->period,
                                   ROLE_DANGER_MIDDLE, film, beam_until}};
    Studio studio;
    bool good = studio_open(&studio, &filmed, options);
    if (good) {
        good = studio_write(&studio, &times);
        studio_close(&studio);
    }
    beam_film_destroy(film);
    return good;
}

bool beam_frames_write(const Beam *beam, const Rig *rig, const Response *response, const Options *options) {
    bool film = options->frames > 0 || options->movie;
    BeamRecord record;
    Subject subject = {beam, rig, response, &record};
    if (!film && !options->out)
        return true;
    beam_record_make(&record, rig, response);
    bool good = true;
    if (!record.cycles)
        fprintf(stderr, "clearance: not one whole cycle was recorded: there is nothing to draw\n");
    if (record.cycles && options->out)
        good = write_still(&subject, options);
    if (record.cycles && good && film)
        good = write_film(&subject, options);
    beam_record_clear(&record);
    return good;
}

/* Plots ------------------------------------------------------------------------------------------------------------ */

bool beam_frames_plots_begin(BeamFrames *files, const Options *options) {
    char message[PLOT_CHOICE_FAULT];
    const char *words = options->plot_words ? options->plot_words : BEAM_PLOTS_USUAL;
    const char *needing = options->plot_words ? "--plots" : options->measured ? "--measured" : NULL;
    *files = (BeamFrames){.plots.count = 0};
    if (needing && !options->out) {
        fprintf(stderr, "clearance: %s needs --out DIR, where the plots are written\n", needing);
        return false;
    }
    if (!beam_plots_choose(&files->plots, words, message)) {
        fprintf(stderr, "clearance: --plots %s: %s\n", words, message);
        return false;
    }
    Fault fault = {0};
    size_t count;
    const MeasuredKind *kinds = beam_plots_kinds(&count);
    if (options->measured && !measured_read(&files->measured, options->measured, kinds, count, &fault)) {
        house_file_report(&fault);
        return false;
    }
    return true;
}

bool beam_frames_plots_write(const BeamFrames *files, const Response *response, const Beam *beam,
                             const Options *options) {
    if (!options->out)
        return true;
    char path[PLOT_WRITE_PATH];
    int error = 0;
    Arena arena = {0};
    PlotSheet sheet = output_sheet(options, source_line_beam(beam, &arena));
    BeamPlots plots = beam_plots_make(response, beam, &files->measured, &files->plots);
    for (size_t i = 0; i < plots.choice.count && !error; i++)
        error = plot_write_files(&plots.plots[i], beam_plots_name(plots.choice.indices[i]), options->out, &sheet, path);
    arena_clear(&arena);
    beam_plots_free(&plots);
    if (error)
        output_failed(path, error);
    return !error;
}

void beam_frames_plots_end(BeamFrames *files) {
    measured_free(&files->measured);
}
