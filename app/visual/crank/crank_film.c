#include "visual/crank/crank_film.h"

#include <math.h>

#include "base/memory.h"

#define LINE_WIDTH 1.6 /* design points */
#define MILLI 1000.0   /* mm per m, ms per s */

enum { ROOM_TURNS = 8 /* revolutions whose displacements the picture has room for */ };

struct CrankFilm {
    const Crank *crank;
    const Tree *tree;
    const Response *response;
    CrankScale scale;
    Scene still, added, moving;
    Plot plots[CRANK_FILM_PLOTS];
    PlotSeries series[CRANK_FILM_PLOTS];
    PlotGuide guides[CRANK_FILM_PLOTS][2];
    double *x[CRANK_FILM_PLOTS], *y[CRANK_FILM_PLOTS]; /* (count) of the rows from `first` on */
    size_t first, count;
};

static size_t row_at(const Trace *trace, double time) {
    size_t low = 0, high = trace->rows - 1;
    while (low < high) {
        size_t middle = low + (high - low + 1) / 2;
        if (trace_row(trace, middle)[CRANK_TIME] <= time)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

/* Returns the largest displacement in some recorded revolutions, m. */
static double reach_of(Scene *scene, const Tree *tree, const Response *response) {
    size_t turns = response->trace.rows / CRANK_SAMPLES;
    double reach = 0;
    for (size_t k = 0; k < turns && k < ROOM_TURNS; k++) {
        Turn turn;
        double now;
        crank_scene_moment(scene, tree, response, (k + 1) * CRANK_SAMPLES - 1, &turn, &now);
        reach = fmax(reach, now);
        scene_reset(scene);
    }
    return reach;
}

static void make_plots(CrankFilm *film, size_t last) {
    const Trace *trace = &film->response->trace;
    double edge = MILLI * film->crank->clearance;
    film->count = last + 1 - film->first;
    for (size_t p = 0; p < CRANK_FILM_PLOTS; p++) {
        film->x[p] = memory_zeroed(film->count, sizeof *film->x[p]);
        film->y[p] = memory_zeroed(film->count, sizeof *film->y[p]);
        for (size_t i = 0; i < film->count; i++) {
            const double *row = trace_row(trace, film->first + i);
            film->x[p][i] = MILLI * (p ? row[CRANK_TIME] : row[CRANK_ALONG]);
            film->y[p][i] = p ? row[CRANK_FORCE] : row[CRANK_ALONG_RATE];
        }
        film->series[p] = (PlotSeries){
            .x = film->x[p], .y = film->y[p], .count = film->count, .role = ROLE_LOCUS, .width = LINE_WIDTH};
    }
    for (int i = 0; i < 2; i++)
        film->guides[0][i] =
            (PlotGuide){.upright = true, .at = i ? edge : -edge, .role = ROLE_FURNITURE_LINE, .style = LINE_DASHED};
    film->plots[0] = (Plot){.title = "Phase plane of the ball",
                            .x = {.title = "place along the coupler", .unit = "mm"},
                            .y = {.title = "velocity", .unit = "m/s"},
                            .series = &film->series[0],
                            .guides = film->guides[0],
                            .series_count = 1,
                            .guide_count = 2};
    film->plots[1] = (Plot){.title = "Force of the joint",
                            .x = {.title = "time", .unit = "ms"},
                            .y = {.title = "force", .unit = "N"},
                            .series = &film->series[1],
                            .series_count = 1};
}

CrankFilm *crank_film_create(const Crank *crank, const Tree *tree, const Response *response, double first,
                             double last) {
    CrankFilm *film = memory_zeroed(1, sizeof *film);
    *film = (CrankFilm){.crank = crank, .tree = tree, .response = response, .first = row_at(&response->trace, first)};
    film->scale = crank_scene_scale(crank, tree, reach_of(&film->moving, tree, response), response->peaks.max);
    make_plots(film, row_at(&response->trace, last));
    film->still.box = film->scale.box;
    film->still.panels = CRANK_FILM_PLOTS;
    crank_scene_still(&film->still, crank, tree, &film->scale);
    crank_scene_labels(&film->still, crank, response, film->first);
    film->still.clock = NULL;
    crank_film_show(film, first);
    return film;
}

void crank_film_destroy(CrankFilm *film) {
    scene_clear(&film->still);
    scene_clear(&film->added);
    scene_clear(&film->moving);
    for (size_t p = 0; p < CRANK_FILM_PLOTS; p++) {
        memory_free(film->x[p]);
        memory_free(film->y[p]);
    }
    memory_free(film);
}

const Scene *crank_film_still(const CrankFilm *film) {
    return &film->still;
}

const Scene *crank_film_added(const CrankFilm *film) {
    return &film->added;
}

const Scene *crank_film_moving(const CrankFilm *film) {
    return &film->moving;
}

bool crank_film_show(CrankFilm *film, double time) {
    Turn turn;
    double reach;
    size_t row = row_at(&film->response->trace, time);
    const double *at = trace_row(&film->response->trace, row);
    scene_reset(&film->moving);
    CrankMoment moment = crank_scene_moment(&film->moving, film->tree, film->response, row, &turn, &reach);
    crank_scene_moving(&film->moving, film->tree, &film->scale, &moment);
    film->moving.clock = scene_text(&film->moving, "revolution %zu, %.0f\u00b0, %.0f N", row / CRANK_SAMPLES + 1,
                                    at[CRANK_ANGLE], at[CRANK_FORCE]);
    return true;
}

const Plot *crank_film_plots(const CrankFilm *film) {
    return film->plots;
}

size_t crank_film_until(const CrankFilm *film, size_t plot, size_t series, double time) {
    (void)plot, (void)series;
    const Trace *trace = &film->response->trace;
    if (time < trace_row(trace, film->first)[CRANK_TIME])
        return 0;
    size_t count = row_at(trace, time) + 1 - film->first;
    return count < film->count ? count : film->count;
}
