#include "visual/crank/crank_plots.h"

#include <math.h>
#include <stdio.h>

#include "base/real.h"
#include "mechanics/spectrum.h"

/* Design points. */
#define LINE_WIDTH 2.0
#define TANGLE_WIDTH 0.8 /* of a line that crosses itself often */
#define DOT 4.0          /* of many */
#define SIGN 7.0         /* of few */

#define MILLI 1000.0 /* mm per m, ms per s */

enum {
    TURNS_SHOWN = 4,   /* against time */
    ANGLES_SHOWN = 8,  /* against the angle, one over the other */
    ORBITS_SHOWN = 16, /* in the phase plane: more would be a blot */
    FEW = 16,          /* points of the section that are shown as symbols */
    MULTIPLES = 30,    /* of the crank's speed, in a spectrum */
};

#define SPECTRUM_DEPTH 1e-4 /* 1, of the largest amplitude: smaller ones are not shown */

/* The inputs of all plots. */
typedef struct Given {
    const Response *response;
    const Crank *crank;
    Arena *arena;
} Given;

typedef struct CrankPlot {
    const char *name;
    void (*make)(Plot *plot, const Given *given);
} CrankPlot;

static const char *note_of(const Given *given) {
    char note[128];
    const Response *response = given->response;
    char verdict[32] = "";
    if (response->verdict == RESPONSE_PERIODIC)
        snprintf(verdict, sizeof verdict, "period %zu", response->orbit.period);
    snprintf(note, sizeof note, "%.4g rpm, clearance %g mm, all numbers assumed: %s", 60 * given->crank->frequency,
             MILLI * given->crank->clearance, *verdict ? verdict : response_verdict_name(response->verdict));
    return arena_text(given->arena, note);
}

/* Returns the first row of the last `turns` revolutions of the trace. */
static size_t last_rows(const Trace *trace, size_t turns, size_t *count) {
    size_t most = turns * CRANK_SAMPLES;
    *count = trace->rows < most ? trace->rows : most;
    return trace->rows - *count;
}

static double factor_of(size_t column) {
    return column == CRANK_ANGLE || column == CRANK_FORCE || column == CRANK_ALONG_RATE ? 1 : MILLI;
}

/* Copies a column of the trace from a row on, scaled for display; time starts at the first displayed revolution. */
static double *copy_column(const Given *given, size_t column, size_t from, size_t count) {
    const Trace *trace = &given->response->trace;
    double *values = arena_allocate(given->arena, (count + 1) * sizeof *values);
    double begin = column == CRANK_TIME && count ? trace_row(trace, from)[CRANK_TIME] : 0;
    for (size_t i = 0; i < count; i++)
        values[i] = factor_of(column) * (trace_row(trace, from + i)[column] - begin);
    return values;
}

static PlotSeries *add_line(Plot *plot, const double *x, const double *y, size_t count) {
    PlotSeries *series = &plot->series[plot->series_count++];
    *series = (PlotSeries){.x = x, .y = y, .count = count, .role = ROLE_LOCUS, .width = LINE_WIDTH};
    return series;
}

static void add_guide(Plot *plot, PlotGuide guide) {
    plot->guides[plot->guide_count++] = guide;
}

static void add_nought(Plot *plot) {
    add_guide(plot, (PlotGuide){.role = ROLE_ROOM, .style = LINE_SOLID});
}

/* Adds the edges of the clearance. */
static void add_clearance(Plot *plot, const Given *given) {
    double edge = MILLI * given->crank->clearance;
    for (int side = -1; side <= 1; side += 2)
        add_guide(plot, (PlotGuide){.upright = true,
                                    .at = side * edge,
                                    .name = side > 0 ? "clearance" : NULL,
                                    .role = ROLE_FURNITURE_LINE,
                                    .style = LINE_DASHED});
}

/* Adds the wall of the socket, seen along the coupler. */
static void add_wall(Plot *plot, const Given *given) {
    enum { CORNERS = 120 };
    double *x = arena_allocate(given->arena, 2 * (CORNERS + 1) * sizeof *x), edge = MILLI * given->crank->clearance;
    for (size_t i = 0; i <= CORNERS; i++) {
        SineCosine turn = real_sincos(2 * M_PI * (double)i / CORNERS);
        x[2 * i] = edge * turn.cosine;
        x[2 * i + 1] = edge * turn.sine;
    }
    PlotSeries *wall = add_line(plot, x, x + 1, CORNERS + 1);
    wall->stride = 2;
    wall->heading = wall->name = "clearance";
    wall->role = ROLE_FURNITURE_LINE;
    wall->style = LINE_DASHED;
}

static bool is_tangle(const Given *given) {
    return given->response->verdict != RESPONSE_PERIODIC;
}

/* Adds a path of the ball and its points at angle 0. */
static void add_path(Plot *plot, const Given *given, size_t across, size_t up) {
    size_t count, from = last_rows(&given->response->trace, ORBITS_SHOWN, &count);
    const double *x = copy_column(given, across, from, count), *y = copy_column(given, up, from, count);
    add_line(plot, x, y, count)->width = is_tangle(given) ? TANGLE_WIDTH : LINE_WIDTH;
    plot->series[0].heading = plot->series[0].name = "ball";
    PlotSeries *section = add_line(plot, x, y, count ? (count - 1) / CRANK_SAMPLES + 1 : 0);
    section->stride = CRANK_SAMPLES;
    section->heading = section->name = "at crank angle 0";
    section->role = ROLE_WALL;
    section->width = 0;
    section->symbol = SYMBOL_DIAMOND;
    section->size = is_tangle(given) ? SIGN / 1.4 : SIGN;
}

static void make_phase(Plot *plot, const Given *given) {
    plot->title = "Phase plane of the ball in its socket";
    plot->x = (PlotAxis){.title = "place along the coupler", .unit = "mm"};
    plot->y = (PlotAxis){.title = "velocity along the coupler", .unit = "m/s"};
    add_clearance(plot, given);
    add_nought(plot);
    add_path(plot, given, CRANK_ALONG, CRANK_ALONG_RATE);
}

static void make_across(Plot *plot, const Given *given) {
    plot->title = "Path of the ball, seen along the coupler";
    plot->x = (PlotAxis){.title = "place across the coupler, level", .unit = "mm"};
    plot->y = (PlotAxis){.title = "place across the coupler, upwards", .unit = "mm"};
    add_path(plot, given, CRANK_ACROSS, CRANK_UP);
    add_wall(plot, given);
}

/* Plots every revolution on which the verdict rests. */
static void make_poincare(Plot *plot, const Given *given) {
    const Section *section = &given->response->analysed;
    double *x = arena_allocate(given->arena, (section->count + 1) * sizeof *x);
    double *y = arena_allocate(given->arena, (section->count + 1) * sizeof *y);
    for (size_t i = 0; i < section->count; i++) {
        x[i] = MILLI * section->deflection[i];
        y[i] = section->velocity[i];
    }
    char title[96];
    snprintf(title, sizeof title, "Poincar\u00E9 map, %zu revolutions", section->count);
    plot->title = arena_text(given->arena, title);
    plot->x = (PlotAxis){.title = "place along the coupler at crank angle 0", .unit = "mm"};
    plot->y = (PlotAxis){.title = "velocity at crank angle 0", .unit = "m/s"};
    PlotSeries *series = add_line(plot, x, y, section->count);
    bool few = !is_tangle(given) && given->response->orbit.period <= FEW;
    series->width = 0;
    series->symbol = few ? SYMBOL_DIAMOND : SYMBOL_DISC;
    series->size = few ? SIGN : DOT;
    series->role = ROLE_WALL;
    if (few) /* a few points say nothing about the size of the motion */
        add_clearance(plot, given);
    add_nought(plot);
}

static const char *force_title(const Given *given, const char *what) {
    char title[96];
    const SectionPeaks *peaks = &given->response->peaks;
    if (peaks->count && peaks->max - peaks->min < 1)
        snprintf(title, sizeof title, "%s, peaks %.0f N", what, peaks->max);
    else if (peaks->count)
        snprintf(title, sizeof title, "%s, peaks %.0f to %.0f N", what, peaks->min, peaks->max);
    else
        snprintf(title, sizeof title, "%s, no contact", what);
    return arena_text(given->arena, title);
}

static void make_force(Plot *plot, const Given *given) {
    size_t count, from = last_rows(&given->response->trace, TURNS_SHOWN, &count);
    plot->title = force_title(given, "Force of the joint");
    plot->x = (PlotAxis){.title = "time since crank angle 0", .unit = "ms"};
    plot->x.high = MILLI * TURNS_SHOWN / given->crank->frequency;
    plot->y = (PlotAxis){.title = "force of the joint", .unit = "N"};
    add_nought(plot);
    add_line(plot, copy_column(given, CRANK_TIME, from, count), copy_column(given, CRANK_FORCE, from, count), count)
        ->width = LINE_WIDTH / 1.4;
}

/* The earlier revolutions are thin, the last one is thick. */
static void make_against_angle(Plot *plot, const Given *given, size_t column) {
    const Trace *trace = &given->response->trace;
    size_t all = trace->rows / CRANK_SAMPLES, shown = all < ANGLES_SHOWN ? all : ANGLES_SHOWN;
    plot->x = (PlotAxis){.title = "crank angle", .unit = "deg", .low = 0, .high = 360};
    add_nought(plot);
    for (size_t k = 0; k < shown; k++) {
        size_t from = (all - shown + k) * CRANK_SAMPLES;
        bool last = k + 1 == shown;
        PlotSeries *series = add_line(plot, copy_column(given, CRANK_ANGLE, from, CRANK_SAMPLES),
                                      copy_column(given, column, from, CRANK_SAMPLES), CRANK_SAMPLES);
        series->role = last ? ROLE_LOCUS : ROLE_LOCUS_SECOND;
        series->width = last ? LINE_WIDTH : TANGLE_WIDTH;
        series->name = last ? "last revolution" : k == 0 ? "the ones before" : NULL;
        series->heading = last ? "last revolution" : "an earlier revolution";
    }
}

static void make_angle(Plot *plot, const Given *given) {
    plot->title = force_title(given, "Force over the crank angle");
    plot->y = (PlotAxis){.title = "force of the joint", .unit = "N"};
    make_against_angle(plot, given, CRANK_FORCE);
}

static void make_slider(Plot *plot, const Given *given) {
    plot->title = "Error of the slider";
    plot->y = (PlotAxis){.title = "place beside the ideal mechanism's", .unit = "mm"};
    make_against_angle(plot, given, CRANK_SLIDER_OFF);
}

static void mark_frequency(Plot *plot, double frequency, double end, const char *name) {
    if (frequency < end)
        add_guide(
            plot,
            (PlotGuide){.upright = true, .at = frequency, .name = name, .role = ROLE_DIM_TEXT, .style = LINE_DASHED});
}

static void make_spectrum(Plot *plot, const Given *given) {
    Spectrum spectrum = response_spectrum(given->response, CRANK_FORCE, CRANK_SAMPLES, given->crank->frequency);
    Tree tree = tree_of(given->crank);
    double end = fmax((MULTIPLES + 0.5) * given->crank->frequency, 1.2 * tree_bending_frequency(&tree, 0)), largest = 0;
    double *values = arena_allocate(given->arena, 2 * (spectrum.count + 1) * sizeof *values);
    size_t count = 0;
    for (size_t k = 1; k < spectrum.count && spectrum.frequency[k] <= end; k++, count++) {
        values[2 * count] = spectrum.frequency[k];
        values[2 * count + 1] = spectrum.amplitude[k];
        largest = fmax(largest, spectrum.amplitude[k]);
    }
    spectrum_clear(&spectrum);
    plot->title = "Spectrum of the force";
    plot->x = (PlotAxis){.title = "frequency (dashed: natural)", .unit = "Hz", .high = end};
    plot->y = (PlotAxis){.title = "amplitude", .unit = "N", .logarithmic = true};
    if (largest > 0) {
        plot->y.high = pow(10, ceil(log10(largest)));
        plot->y.low = plot->y.high * SPECTRUM_DEPTH;
    }
    if (tree.bending)
        mark_frequency(plot, tree_bending_frequency(&tree, 0), end, "bending");
    mark_frequency(plot, tree_support_frequency(&tree, 0), end, "support x");
    bool apart = fabs(tree_support_frequency(&tree, 2) - tree_support_frequency(&tree, 1)) > 1e-9;
    mark_frequency(plot, tree_support_frequency(&tree, 1), end, apart ? "support y" : "support y, z");
    if (apart)
        mark_frequency(plot, tree_support_frequency(&tree, 2), end, "support z");
    add_line(plot, values, values + 1, count)->stride = 2;
    plot->series[0].width = LINE_WIDTH / 1.4;
}

static const CrankPlot known[CRANK_PLOTS_KNOWN] = {
    {"phase", make_phase},   {"poincare", make_poincare}, {"force", make_force},       {"angle", make_angle},
    {"across", make_across}, {"slider", make_slider},     {"spectrum", make_spectrum},
};

bool crank_plots_choose(PlotChoice *choice, const char *text, char fault[PLOT_CHOICE_FAULT]) {
    const char *names[CRANK_PLOTS_KNOWN];
    for (size_t i = 0; i < CRANK_PLOTS_KNOWN; i++)
        names[i] = known[i].name;
    return plot_choice_read(choice, text, names, CRANK_PLOTS_KNOWN, fault);
}

const char *crank_plots_name(size_t index) {
    return known[index].name;
}

CrankPlots crank_plots_make(const Response *response, const Crank *crank, const PlotChoice *choice) {
    enum { SERIES_MOST = ANGLES_SHOWN, GUIDES_MOST = 8 };
    CrankPlots plots = {.choice = *choice};
    Given given = {response, crank, &plots.arena};
    for (size_t i = 0; i < choice->count; i++) {
        Plot *plot = &plots.plots[i];
        plot->series = arena_allocate(&plots.arena, SERIES_MOST * sizeof *plot->series);
        plot->guides = arena_allocate(&plots.arena, GUIDES_MOST * sizeof *plot->guides);
        plot->note = note_of(&given);
        known[choice->indices[i]].make(plot, &given);
    }
    return plots;
}

void crank_plots_free(CrankPlots *plots) {
    arena_clear(&plots->arena);
    *plots = (CrankPlots){.choice = {.count = 0}};
}
