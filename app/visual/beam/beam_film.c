#include "visual/beam/beam_film.h"

#include <math.h>

#define MILLI 1000.0 /* in one metre */

/* Design points. */
#define LINE_WIDTH 1.6
#define DIAMOND 11.0
#define NOW 13.0

/* Design points, of each plot. */
enum { SERIES_LINE, SERIES_SECTION, SERIES_NOW, SERIES, GUIDES = 2 };
enum { PLOT_PHASE, PLOT_FORCE };

struct BeamFilm {
    const Beam *beam;
    BeamRecord *record;
    BeamScale scale;
    BeamShape shape;
    double time; /* s, displayed last; -1: none */
    Plot plots[BEAM_FILM_PLOTS];
    PlotSeries series[BEAM_FILM_PLOTS][SERIES];
    PlotGuide guides[BEAM_FILM_PLOTS][GUIDES];
    double now[BEAM_FILM_PLOTS][2]; /* the values at the displayed time */
    Scene still, added, moving;
};

double beam_film_slow(double frequency) {
    double wanted = BEAM_FILM_CYCLE_SECONDS * frequency, power = pow(10, floor(log10(wanted)));
    static const double steps[] = {1, 2, 5, 10};
    double nearest = steps[0];
    for (size_t i = 1; i < sizeof steps / sizeof *steps; i++)
        if (fabs(log(wanted / (steps[i] * power))) < fabs(log(wanted / (nearest * power))))
            nearest = steps[i];
    return nearest * power;
}

static PlotSeries line_series(const double *x, const double *y, size_t count) {
    return (PlotSeries){.x = x, .y = y, .count = count, .role = ROLE_LOCUS, .width = LINE_WIDTH};
}

static void make_phase(BeamFilm *film) {
    const BeamRecord *record = film->record;
    PlotSeries *series = film->series[PLOT_PHASE];
    double edge = MILLI * film->beam->clearance;
    series[SERIES_LINE] = line_series(record->displacement, record->velocity, record->sample_count);
    series[SERIES_SECTION] = (PlotSeries){.name = "once per cycle",
                                          .x = record->section_displacement,
                                          .y = record->section_velocity,
                                          .count = record->section_count,
                                          .role = ROLE_WALL,
                                          .symbol = SYMBOL_DIAMOND,
                                          .size = DIAMOND};
    for (int i = 0; i < GUIDES; i++)
        film->guides[PLOT_PHASE][i] =
            (PlotGuide){.upright = true, .at = i ? edge : -edge, .role = ROLE_WALL, .style = LINE_DASHED};
    film->plots[PLOT_PHASE] = (Plot){.title = "Phase plane of the tip",
                                     .note = "dashed: the stops",
                                     .x = {.title = "displacement", .unit = "mm"},
                                     .y = {.title = "velocity", .unit = "m/s"},
                                     .series = series,
                                     .guides = film->guides[PLOT_PHASE],
                                     .series_count = SERIES_SECTION + 1,
                                     .guide_count = film->scale.stops ? GUIDES : 0};
}

static void make_force(BeamFilm *film) {
    const BeamRecord *record = film->record;
    film->series[PLOT_FORCE][SERIES_LINE] = line_series(record->times, record->force, record->sample_count);
    film->guides[PLOT_FORCE][0] = (PlotGuide){.at = 0, .role = ROLE_ROOM, .style = LINE_SOLID};
    film->plots[PLOT_FORCE] = (Plot){.title = "Force on the tip",
                                     .note = "negative: by the upper stop",
                                     .x = {.title = "time", .unit = "ms"},
                                     .y = {.title = "force", .unit = "N"},
                                     .series = film->series[PLOT_FORCE],
                                     .guides = film->guides[PLOT_FORCE],
                                     .series_count = SERIES_LINE + 1,
                                     .guide_count = 1};
    film->plots[PLOT_FORCE].x.low = record->times[0];
    film->plots[PLOT_FORCE].x.high = record->times[record->sample_count - 1];
}

BeamFilm *beam_film_create(const Beam *beam, const Rig *rig, const Response *response, BeamRecord *record,
                           double slow) {
    BeamFilm *film = memory_zeroed(1, sizeof *film);
    *film = (BeamFilm){.beam = beam, .record = record, .time = -1};
    film->scale = beam_scene_scale(beam, record->reach, record->tip_reach);
    film->shape = beam_shape_create(rig);
    beam_scene_labels(&film->still, beam, rig, response, &film->scale, slow);
    beam_scene_still(&film->still, beam, &film->scale);
    film->still.panels = BEAM_FILM_PLOTS;
    make_phase(film);
    make_force(film);
    return film;
}

void beam_film_destroy(BeamFilm *film) {
    beam_shape_destroy(&film->shape);
    scene_clear(&film->still);
    scene_clear(&film->added);
    scene_clear(&film->moving);
    memory_free(film);
}

const Scene *beam_film_still(const BeamFilm *film) {
    return &film->still;
}

const Scene *beam_film_added(const BeamFilm *film) {
    return &film->added;
}

const Scene *beam_film_moving(const BeamFilm *film) {
    return &film->moving;
}

bool beam_film_show(BeamFilm *film, double time) {
    bool onwards = time >= film->time;
    const Beam *beam = film->beam;
    const Motion *motion = &film->record->motion;
    film->time = time;
    beam_record_seek(film->record, time);
    beam_shape_set(&film->shape, motion);
    BeamMoment moment = {.time = time,
                         .cycle = (size_t)beam->transient_cycles + motion->cycle + 1,
                         .drive = beam->force * motion->now.sine,
                         .force = motion_force(motion),
                         .largest = film->record->largest};
    for (int side = 0; side < 2; side++)
        moment.last[side] = beam_record_last_impact(film->record, time, side ? -1 : 1);
    film->now[PLOT_PHASE][0] = MILLI * motion_deflection(motion);
    film->now[PLOT_PHASE][1] = motion_velocity(motion);
    film->now[PLOT_FORCE][0] = MILLI * time;
    film->now[PLOT_FORCE][1] = moment.force;
    scene_reset(&film->moving);
    beam_scene_moving(&film->moving, beam, &film->scale, &film->shape, &moment);
    return onwards;
}

const Plot *beam_film_plots(const BeamFilm *film) {
    return film->plots;
}

size_t beam_film_until(const BeamFilm *film, size_t plot, size_t series, double time) {
    const BeamRecord *record = film->record;
    bool section = plot == PLOT_PHASE && series == SERIES_SECTION;
    const double *times = section ? record->section_times : record->times;
    size_t low = 0, high = section ? record->section_count : record->sample_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (times[middle] <= MILLI * time)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

void beam_film_mark(BeamFilm *film) {
    for (int p = 0; p < BEAM_FILM_PLOTS; p++) {
        Plot *plot = &film->plots[p];
        plot->series[plot->series_count++] = (PlotSeries){.x = &film->now[p][0],
                                                          .y = &film->now[p][1],
                                                          .count = 1,
                                                          .role = ROLE_DANGER_MIDDLE,
                                                          .symbol = SYMBOL_DISC,
                                                          .size = NOW};
    }
}
