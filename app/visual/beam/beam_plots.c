#include "visual/beam/beam_plots.h"

#include <stdio.h>
#include <string.h>

#include "beam/beam_cycle.h"
#include "visual/study/measured_marks.h"
#include "mechanics/spectrum.h"

/* Design points. */
#define LINE_WIDTH 2.0
#define TANGLE_WIDTH 0.8 /* of a line that crosses itself often */
#define DOT 3.0          /* of many: 0.5 mm on a page */
#define SIGN 7.0         /* of few */

#define MILLI 1000.0 /* mm per m, ms per s */

enum {
    CYCLES_SHOWN = 8,  /* against time */
    ORBITS_SHOWN = 60, /* cycles in the phase plane: more would be a blot */
    FEW = 16,          /* points of the section that are shown as symbols */
    PATH_STEPS = 400,  /* of a cycle in the phase plane, at least */
    MULTIPLES = 10,    /* of the drive's frequency, in a spectrum */
};

#define SPECTRUM_DEPTH 1e-6 /* 1, of the largest amplitude: smaller ones are not shown */

/* The inputs of all plots. */
typedef struct Given {
    const Response *response;
    const Beam *beam;
    const Measured *measured;
    Arena *arena;
} Given;

typedef struct BeamPlot {
    const char *name;
    void (*make)(Plot *plot, const Given *given);
} BeamPlot;

static const char *note_of(const Given *given) {
    char note[96];
    const Response *response = given->response;
    char verdict[32] = "";
    if (response->verdict == RESPONSE_PERIODIC && response->peaks.count)
        snprintf(verdict, sizeof verdict, "period %zu", response->orbit.period);
    snprintf(note, sizeof note, "%g Hz, clearance \u00B1%g mm: %s", given->beam->frequency,
             MILLI * given->beam->clearance, *verdict ? verdict : response_name(response));
    return arena_text(given->arena, note);
}

/* Returns the first row of the last `cycles` cycles of the trace. */
static size_t last_rows(const Trace *trace, size_t cycles, size_t *count) {
    size_t most = cycles * BEAM_SAMPLES;
    *count = trace->rows < most ? trace->rows : most;
    return trace->rows - *count;
}

static double factor_of(size_t column) {
    return column == BEAM_TIME || column == BEAM_DEFLECTION ? MILLI : 1;
}

/* Copies a column of the trace from a row on, scaled for display; time starts at the first displayed cycle. */
static double *copy_column(const Given *given, size_t column, size_t from, size_t count) {
    const Trace *trace = &given->response->trace;
    double *values = arena_allocate(given->arena, (count + 1) * sizeof *values);
    double begin = column == BEAM_TIME && count ? trace_row(trace, from)[BEAM_TIME] : 0;
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

static void add_nought(Plot *plot, bool upright) {
    add_guide(plot, (PlotGuide){.upright = upright, .role = ROLE_ROOM, .style = LINE_SOLID});
}

/* Adds the edges of the clearance, and the stops beyond them. */
static void add_clearance(Plot *plot, const Given *given, bool upright) {
    double edge = MILLI * given->beam->clearance;
    add_guide(plot, (PlotGuide){.upright = upright, .band = true, .at = edge, .to = HUGE_VAL, .role = ROLE_FURNITURE});
    add_guide(plot,
              (PlotGuide){.upright = upright, .band = true, .at = -edge, .to = -HUGE_VAL, .role = ROLE_FURNITURE});
    for (int side = -1; side <= 1; side += 2)
        add_guide(plot,
                  (PlotGuide){.upright = upright, .at = side * edge, .role = ROLE_FURNITURE_LINE, .style = LINE_SOLID});
}

static void lay_measured(Plot *plot, const Given *given, size_t x, size_t y) {
    size_t count;
    const MeasuredKind *kinds = beam_plots_kinds(&count);
    bool laid = measured_marks_add(plot, given->measured, (MeasuredAxis){kinds[x].name, factor_of(x)},
                                   (MeasuredAxis){kinds[y].name, factor_of(y)}, "measured", 0, given->arena);
    if (laid && !plot->series[0].name)
        plot->series[0].name = "simulated";
}

/* The tip's way through the phase plane: a point at each step and switch of the motion. */
typedef struct Path {
    double *x, *y; /* (count) mm, m/s */
    size_t count, x_capacity, y_capacity;
} Path;

static void add_to_path(Path *path, const Motion *motion) {
    path->x = memory_reserve(path->x, &path->x_capacity, path->count + 1, sizeof *path->x);
    path->y = memory_reserve(path->y, &path->y_capacity, path->count + 1, sizeof *path->y);
    path->x[path->count] = MILLI * motion_deflection(motion);
    path->y[path->count++] = motion_velocity(motion);
}

/* Repeats the recorded cycles from `first` to `last`, each from its recorded state. Returns false if the beam cannot be
 * built. */
static bool find_path(Path *path, const Given *given, size_t first, size_t last) {
    const Section *section = &given->response->section;
    Rig rig;
    Fault fault = {0};
    if (!rig_build(&rig, given->beam, given->beam->name, &fault)) {
        fault_clear(&fault);
        return false;
    }
    Motion motion = motion_create(&rig, 0);
    bool same = section->states == rig.free.states;
    for (size_t cycle = first; same && cycle < last; cycle++) {
        motion_set_state(&motion, cycle ? section->state + (cycle - 1) * section->states : given->response->start);
        if (cycle == first)
            add_to_path(path, &motion);
        while (motion.status == CYCLE_GOOD && motion.phase < rig.period) {
            motion_step(&motion, fmin(rig.period - motion.phase, rig.period / PATH_STEPS));
            add_to_path(path, &motion);
        }
    }
    motion_destroy(&motion);
    rig_clear(&rig);
    return same;
}

/* Adds the line of the last cycles; where it cannot be computed, from sample to sample. */
static void add_path(Plot *plot, const Given *given, size_t from, size_t count, const double *x, const double *y,
                     double width) {
    Path path = {0};
    size_t first = from / BEAM_SAMPLES, last = (from + count) / BEAM_SAMPLES;
    bool found = last <= given->response->section.count && find_path(&path, given, first, last) && path.count;
    double *own = arena_allocate(given->arena, (2 * path.count + 1) * sizeof *own);
    if (found) {
        memcpy(own, path.x, path.count * sizeof *own);
        memcpy(own + path.count, path.y, path.count * sizeof *own);
        add_line(plot, own, own + path.count, path.count)->width = width;
    } else {
        add_line(plot, x, y, count)->width = width;
    }
    memory_free(path.x);
    memory_free(path.y);
}

static void make_phase(Plot *plot, const Given *given) {
    const Trace *trace = &given->response->trace;
    size_t count, from = last_rows(trace, ORBITS_SHOWN, &count);
    const double *x = copy_column(given, BEAM_DEFLECTION, from, count),
                 *y = copy_column(given, BEAM_VELOCITY, from, count);
    bool tangle = given->response->verdict != RESPONSE_PERIODIC;
    plot->title = "Phase plane of the tip";
    plot->x = (PlotAxis){.title = "deflection", .unit = "mm"};
    plot->y = (PlotAxis){.title = "velocity", .unit = "m/s"};
    add_clearance(plot, given, true);
    plot->guides[0].name = "contact";
    add_nought(plot, false);
    add_path(plot, given, from, count, x, y, tangle ? TANGLE_WIDTH : LINE_WIDTH);
    add_line(plot, x, y, count ? (count - 1) / BEAM_SAMPLES + 1 : 0);
    PlotSeries *section = &plot->series[plot->series_count - 1];
    section->stride = BEAM_SAMPLES;
    section->heading = section->name = "at phase 0 of the drive";
    section->role = ROLE_WALL;
    section->width = 0;
    section->symbol = SYMBOL_DIAMOND;
    section->size = tangle ? SIGN / 1.4 : 1.4 * SIGN;
    plot->series[0].heading = plot->series[0].name = "tip";
    lay_measured(plot, given, BEAM_DEFLECTION, BEAM_VELOCITY);
}

/* A few points say nothing about the size of the motion: they are shown on the axes of the phase plane. */
static void show_whole_plane(Plot *plot, const Given *given) {
    const Trace *trace = &given->response->trace;
    double edge = MILLI * given->beam->clearance;
    Box reach = {{-edge, 0}, {edge, 0}};
    for (size_t i = 0; i < trace->rows; i++)
        reach =
            box_include(reach, vec2(MILLI * trace_row(trace, i)[BEAM_DEFLECTION], trace_row(trace, i)[BEAM_VELOCITY]));
    plot->x.low = 1.1 * reach.low.x;
    plot->x.high = 1.1 * reach.high.x;
    plot->y.low = 1.1 * reach.low.y;
    plot->y.high = 1.1 * reach.high.y;
}

/* Plots every cycle on which the verdict rests. */
static void make_poincare(Plot *plot, const Given *given) {
    const Section *section = &given->response->analysed;
    double *x = arena_allocate(given->arena, (section->count + 1) * sizeof *x);
    double *y = arena_allocate(given->arena, (section->count + 1) * sizeof *y);
    for (size_t i = 0; i < section->count; i++) {
        x[i] = MILLI * section->deflection[i];
        y[i] = section->velocity[i];
    }
    char title[96];
    snprintf(title, sizeof title, "Poincar\u00E9 map, %zu cycles", section->count);
    plot->title = arena_text(given->arena, title);
    plot->x = (PlotAxis){.title = "deflection at phase 0", .unit = "mm"};
    plot->y = (PlotAxis){.title = "velocity at phase 0", .unit = "m/s"};
    PlotSeries *series = add_line(plot, x, y, section->count);
    bool few = given->response->verdict == RESPONSE_PERIODIC && given->response->orbit.period <= FEW;
    series->width = 0;
    series->symbol = few ? SYMBOL_DIAMOND : SYMBOL_DISC;
    series->size = few ? SIGN : DOT;
    series->role = ROLE_WALL;
    if (few)
        show_whole_plane(plot, given);
    add_clearance(plot, given, true);
    add_nought(plot, false);
    lay_measured(plot, given, BEAM_DEFLECTION, BEAM_VELOCITY);
}

static void make_against_time(Plot *plot, const Given *given, size_t column) {
    size_t count, from = last_rows(&given->response->trace, CYCLES_SHOWN, &count);
    plot->x = (PlotAxis){.title = "time since phase 0 of the drive", .unit = "ms"};
    plot->x.high = MILLI * (double)CYCLES_SHOWN / given->beam->frequency;
    add_nought(plot, false);
    add_line(plot, copy_column(given, BEAM_TIME, from, count), copy_column(given, column, from, count), count);
    lay_measured(plot, given, BEAM_TIME, column);
}

static void make_force(Plot *plot, const Given *given) {
    char title[96] = "Force of the joint, no contact";
    const SectionPeaks *peaks = &given->response->peaks;
    if (peaks->count && peaks->max - peaks->min < 1)
        snprintf(title, sizeof title, "Force of the joint, peaks %.0f N", peaks->max);
    else if (peaks->count)
        snprintf(title, sizeof title, "Force of the joint, peaks %.0f to %.0f N", peaks->min, peaks->max);
    plot->title = arena_text(given->arena, title);
    plot->y = (PlotAxis){.title = "force on the tip, upwards", .unit = "N"};
    make_against_time(plot, given, BEAM_FORCE);
}

static void make_displacement(Plot *plot, const Given *given) {
    plot->title = "Deflection of the tip";
    plot->y = (PlotAxis){.title = "deflection", .unit = "mm"};
    add_clearance(plot, given, false);
    make_against_time(plot, given, BEAM_DEFLECTION);
}

static void make_velocity(Plot *plot, const Given *given) {
    plot->title = "Velocity of the tip";
    plot->y = (PlotAxis){.title = "velocity", .unit = "m/s"};
    make_against_time(plot, given, BEAM_VELOCITY);
}

static void add_multiples(Plot *plot, const Given *given) {
    for (int m = 1; m <= MULTIPLES; m++) {
        char name[16];
        snprintf(name, sizeof name, "%d", m);
        add_guide(plot, (PlotGuide){.upright = true,
                                    .at = m * given->beam->frequency,
                                    .name = arena_text(given->arena, name),
                                    .role = ROLE_DIM_TEXT,
                                    .style = LINE_DOTTED});
    }
}

static void make_spectrum(Plot *plot, const Given *given) {
    Spectrum spectrum = response_spectrum(given->response, BEAM_DEFLECTION, BEAM_SAMPLES, given->beam->frequency);
    double end = (MULTIPLES + 0.5) * given->beam->frequency, largest = 0;
    double *values = arena_allocate(given->arena, 2 * (spectrum.count + 1) * sizeof *values);
    size_t count = 0;
    for (size_t k = 1; k < spectrum.count && spectrum.frequency[k] <= end; k++, count++) {
        values[2 * count] = spectrum.frequency[k];
        values[2 * count + 1] = MILLI * spectrum.amplitude[k];
        largest = fmax(largest, MILLI * spectrum.amplitude[k]);
    }
    spectrum_clear(&spectrum);
    plot->title = "Spectrum of the deflection";
    plot->x = (PlotAxis){.title = "frequency (dotted: multiples of the drive frequency)", .unit = "Hz", .high = end};
    plot->y = (PlotAxis){.title = "amplitude", .unit = "mm", .logarithmic = true};
    if (largest > 0) {
        plot->y.high = pow(10, ceil(log10(largest)));
        plot->y.low = plot->y.high * SPECTRUM_DEPTH;
    }
    add_multiples(plot, given);
    add_line(plot, values, values + 1, count)->stride = 2;
    plot->series[0].width = LINE_WIDTH / 1.4;
}

static const BeamPlot known[BEAM_PLOTS_KNOWN] = {
    {"phase", make_phase},       {"poincare", make_poincare},
    {"force", make_force},       {"displacement", make_displacement},
    {"velocity", make_velocity}, {"spectrum", make_spectrum},
};

bool beam_plots_choose(PlotChoice *choice, const char *text, char fault[PLOT_CHOICE_FAULT]) {
    const char *names[BEAM_PLOTS_KNOWN];
    for (size_t i = 0; i < BEAM_PLOTS_KNOWN; i++)
        names[i] = known[i].name;
    return plot_choice_read(choice, text, names, BEAM_PLOTS_KNOWN, fault);
}

const char *beam_plots_name(size_t index) {
    return known[index].name;
}

const MeasuredKind *beam_plots_kinds(size_t *count) {
    static const MeasuredKind kinds[] = {[BEAM_TIME] = {"time", "t", "s"},
                                         [BEAM_DEFLECTION] = {"deflection", "displacement", "m"},
                                         [BEAM_VELOCITY] = {"velocity", "v", "m/s"},
                                         [BEAM_FORCE] = {"force", "F", "N"}};
    *count = sizeof kinds / sizeof *kinds;
    return kinds;
}

BeamPlots beam_plots_make(const Response *response, const Beam *beam, const Measured *measured,
                          const PlotChoice *choice) {
    enum { SERIES_MOST = 4, GUIDES_MOST = MULTIPLES + 6 };
    BeamPlots plots = {.choice = *choice};
    Given given = {response, beam, measured, &plots.arena};
    for (size_t i = 0; i < choice->count; i++) {
        Plot *plot = &plots.plots[i];
        plot->series = arena_allocate(&plots.arena, SERIES_MOST * sizeof *plot->series);
        plot->guides = arena_allocate(&plots.arena, GUIDES_MOST * sizeof *plot->guides);
        plot->note = note_of(&given);
        known[choice->indices[i]].make(plot, &given);
    }
    return plots;
}

void beam_plots_free(BeamPlots *plots) {
    arena_clear(&plots->arena);
    *plots = (BeamPlots){.choice = {.count = 0}};
}
