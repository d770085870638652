#include "laboratory/crank/traces.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "laboratory/machine/axis.h"
#include "mechanics/spectrum.h"

#define MILLI 1000.0 /* plots show m and s multiplied by this */

/* Design points. */
#define LINE_WIDTH 1.6
#define THIN_WIDTH 1.0
#define DIAMOND 8.0
#define DOT 2.6

/* Revolutions on a page. */
static const size_t pages[CRANK_TRACES] = {
    [CRANK_TRACE_PHASE] = 12,
    [CRANK_TRACE_POINCARE] = CRANK_TAPE_RETURNS,
    [CRANK_TRACE_ACROSS] = CRANK_TAPE_RETURNS,
    [CRANK_TRACE_FORCE] = 4,
    [CRANK_TRACE_SLIDER] = 8,
    [CRANK_TRACE_SPECTRUM] = 8,
};

enum {
    ROW_STEP = 2,        /* every so many-th row is drawn */
    SPECTRUM_TURNS = 16, /* revolutions in a spectrum */
    SPECTRUM_LEAST = 4,
    MULTIPLES = 30, /* of the speed in a spectrum, at least */
};

#define SPECTRUM_DEPTH 1e-4 /* 1, share of the largest amplitude: smaller amplitudes are not shown */

enum { SERIES_KEPT, SERIES_LINE, SERIES_SECTION };

static void set_series(CrankTraces *traces, CrankTrace plot, size_t at, PlotSeries looks) {
    traces->series[plot][at] = looks;
    if (traces->plots[plot].series_count <= at)
        traces->plots[plot].series_count = at + 1;
}

/* Points the series to the curves' arrays, which may have moved or grown. */
static void take_curves(CrankTraces *traces) {
    for (size_t p = 0; p < CRANK_TRACES; p++)
        for (size_t s = 0; s < traces->plots[p].series_count; s++) {
            PlotSeries *series = &traces->series[p][s];
            series->x = traces->curves[p][s].x;
            series->y = traces->curves[p][s].y;
            series->count = traces->curves[p][s].count;
        }
}

void crank_traces_open(CrankTraces *traces) {
    const PlotSeries line = {.role = ROLE_LOCUS, .width = LINE_WIDTH};
    const PlotSeries dots = {.role = ROLE_WALL, .symbol = SYMBOL_DISC, .size = DOT};
    static const Plot plots[CRANK_TRACES] = {
        [CRANK_TRACE_PHASE] = {.title = "Where the ball goes (phase plane)",
                               .x = {.title = "place along the coupler", .unit = "mm"},
                               .y = {.title = "velocity", .unit = "m/s"}},
        [CRANK_TRACE_POINCARE] = {.title = "Once a revolution (Poincar\u00E9 map)",
                                  .x = {.title = "place along the coupler at angle 0", .unit = "mm"},
                                  .y = {.title = "velocity at angle 0", .unit = "m/s"}},
        [CRANK_TRACE_ACROSS] = {.title = "Once a revolution, across (Poincar\u00E9 map)",
                                .x = {.title = "place across, level, at angle 0", .unit = "mm"},
                                .y = {.title = "upwards", .unit = "mm"}},
        [CRANK_TRACE_FORCE] = {.title = "Force of the joint", .y = {.title = "force", .unit = "N"}},
        [CRANK_TRACE_SLIDER] = {.title = "Error of the slider",
                                .x = {.title = "crank angle", .unit = "deg", .low = 0, .high = 360},
                                .y = {.title = "place beside the ideal one", .unit = "mm"}},
        [CRANK_TRACE_SPECTRUM] = {.title = "Tones of the force (spectrum)",
                                  .x = {.title = "frequency", .unit = "Hz"},
                                  .y = {.title = "amplitude", .unit = "N", .logarithmic = true}}};
    *traces = (CrankTraces){.cleared = 0};
    for (size_t p = 0; p < CRANK_TRACES; p++) {
        traces->plots[p] = plots[p];
        traces->plots[p].series = traces->series[p];
        traces->plots[p].guides = traces->guides[p];
        traces->revisions[p] = 1;
    }
    set_series(traces, CRANK_TRACE_PHASE, SERIES_KEPT,
               (PlotSeries){.role = ROLE_GHOST, .width = LINE_WIDTH, .style = LINE_DASHED});
    set_series(traces, CRANK_TRACE_PHASE, SERIES_LINE, line);
    set_series(traces, CRANK_TRACE_PHASE, SERIES_SECTION,
               (PlotSeries){.role = ROLE_WALL, .symbol = SYMBOL_DIAMOND, .size = DIAMOND, .name = "at angle 0"});
    set_series(traces, CRANK_TRACE_POINCARE, 0, dots);
    set_series(traces, CRANK_TRACE_ACROSS, 0, dots);
    set_series(traces, CRANK_TRACE_FORCE, 0, line);
    set_series(traces, CRANK_TRACE_SLIDER, 0, line);
    set_series(traces, CRANK_TRACE_SPECTRUM, 0, (PlotSeries){.role = ROLE_LOCUS, .width = THIN_WIDTH});
    traces->whole[CRANK_TRACE_PHASE][SERIES_KEPT] = traces->whole[CRANK_TRACE_SPECTRUM][0] = true;
}

void crank_traces_close(CrankTraces *traces) {
    for (size_t p = 0; p < CRANK_TRACES; p++)
        for (size_t s = 0; s < CRANK_TRACE_SERIES; s++)
            machine_curve_clear(&traces->curves[p][s]);
    arena_clear(&traces->arena);
}

/* Turns to the page of a revolution. True: the page is new, and its curves are empty. */
static bool turn_page(CrankTraces *traces, CrankTrace plot, const CrankTape *tape, size_t cycle, size_t first) {
    const CrankPart *part = crank_tape_part(tape, cycle);
    size_t number = (cycle - part->first) / pages[plot], begin = part->first + number * pages[plot];
    begin = begin > first ? begin : first;
    bool cut = begin < traces->cleared && traces->cleared <= cycle;
    CrankPage *page = &traces->pages[plot];
    if (page->serial == part->serial && page->version == tape->version && page->number == number && page->cut == cut &&
        page->next >= first)
        return false;
    *page = (CrankPage){part->serial, tape->version, number, cut, cut ? traces->cleared : begin};
    for (size_t s = 0; s < CRANK_TRACE_SERIES; s++)
        if (!traces->whole[plot][s] || plot == CRANK_TRACE_SPECTRUM)
            machine_curve_reset(&traces->curves[plot][s]);
    traces->revisions[plot]++;
    return true;
}

/* Adds a revolution's rows to a curve: two columns, or the time since `origin` if the first one is CRANK_TAPE_COLUMNS;
 * `x` and `y` scale them. */
static void add_rows(MachineCurve *curve, const CrankTape *tape, size_t cycle, size_t column, double x, size_t other,
                     double y, double origin) {
    const CrankTapeCycle *at = crank_tape_cycle(tape, cycle);
    double begin = crank_tape_return(tape, cycle)->begin;
    double interval = crank_tape_part(tape, cycle)->tree.period / CRANK_TAPE_ROWS;
    for (size_t r = 0; r < at->row_count; r += ROW_STEP) {
        const float *row = crank_tape_row(at, r);
        double time = begin + (double)r * interval;
        double first = column == CRANK_TAPE_COLUMNS ? time - origin : row[column];
        machine_curve_add(curve, time, x * first, y * row[other]);
    }
}

/* Sizes an axis for the largest value of a page; a saved curve keeps its room. */
static void size_axis(CrankTraces *traces, CrankTrace plot, PlotAxis *axis, double to, bool both) {
    if (machine_axis_stretch(axis, to, both))
        traces->revisions[plot]++;
}

static void size_to_curve(CrankTraces *traces, CrankTrace plot, size_t series, bool x, bool y) {
    const MachineCurve *curve = &traces->curves[plot][series];
    double wide = 0, high = 0;
    for (size_t i = 0; i < curve->count; i++) {
        wide = fmax(wide, fabs(curve->x[i]));
        high = fmax(high, fabs(curve->y[i]));
    }
    if (x)
        size_axis(traces, plot, &traces->plots[plot].x, wide, true);
    if (y)
        size_axis(traces, plot, &traces->plots[plot].y, high, plot != CRANK_TRACE_FORCE);
}

static void show_phase(CrankTraces *traces, const CrankTape *tape, size_t cycle) {
    CrankPage *page = &traces->pages[CRANK_TRACE_PHASE];
    MachineCurve *curves = traces->curves[CRANK_TRACE_PHASE];
    bool grown = turn_page(traces, CRANK_TRACE_PHASE, tape, cycle, tape->first);
    if (grown) {
        double edge = MILLI * crank_tape_part(tape, cycle)->crank.clearance;
        for (int i = 0; i < 2; i++)
            traces->guides[CRANK_TRACE_PHASE][i] =
                (PlotGuide){.upright = true, .at = i ? edge : -edge, .role = ROLE_FURNITURE_LINE, .style = LINE_DASHED};
        traces->plots[CRANK_TRACE_PHASE].guide_count = 2;
        size_axis(traces, CRANK_TRACE_PHASE, &traces->plots[CRANK_TRACE_PHASE].x, 1.05 * edge, true);
    }
    for (; page->next <= cycle && page->next < tape->front; page->next++, grown = true) {
        const CrankReturn *at = crank_tape_return(tape, page->next);
        add_rows(&curves[SERIES_LINE], tape, page->next, CRANK_TAPE_ALONG, MILLI, CRANK_TAPE_ALONG_RATE, 1, 0);
        machine_curve_add(&curves[SERIES_SECTION], at->begin, MILLI * at->along, at->along_rate);
    }
    if (grown)
        size_to_curve(traces, CRANK_TRACE_PHASE, SERIES_LINE, true, true);
}

static void show_returns(CrankTraces *traces, const CrankTape *tape, size_t cycle, CrankTrace plot) {
    CrankPage *page = &traces->pages[plot];
    bool grown = turn_page(traces, plot, tape, cycle, crank_tape_first_return(tape));
    for (; page->next <= cycle && page->next < tape->front; page->next++, grown = true) {
        const CrankReturn *at = crank_tape_return(tape, page->next);
        bool across = plot == CRANK_TRACE_ACROSS;
        machine_curve_add(&traces->curves[plot][0], at->begin, MILLI * (across ? at->across : at->along),
                          across ? MILLI * at->up : at->along_rate);
    }
    if (!grown)
        return;
    double edge = 1.05 * MILLI * crank_tape_part(tape, cycle)->crank.clearance;
    size_axis(traces, plot, &traces->plots[plot].x, edge, true);
    if (plot == CRANK_TRACE_ACROSS)
        size_axis(traces, plot, &traces->plots[plot].y, edge, true);
    size_to_curve(traces, plot, 0, true, true);
}

static void show_force(CrankTraces *traces, const CrankTape *tape, size_t cycle) {
    CrankPage *page = &traces->pages[CRANK_TRACE_FORCE];
    Plot *plot = &traces->plots[CRANK_TRACE_FORCE];
    const CrankPart *part = crank_tape_part(tape, cycle);
    bool grown = turn_page(traces, CRANK_TRACE_FORCE, tape, cycle, tape->first);
    size_t first = part->first + page->number * pages[CRANK_TRACE_FORCE];
    if (grown) {
        arena_clear(&traces->arena);
        plot->x = (PlotAxis){.title = text_in_arena(&traces->arena, "time since revolution %zu", first + 1),
                             .unit = "ms",
                             .high = MILLI * (double)pages[CRANK_TRACE_FORCE] * part->tree.period};
    }
    double origin = crank_tape_return(tape, first > tape->first ? first : tape->first)->begin;
    for (; page->next <= cycle && page->next < tape->front; page->next++, grown = true)
        add_rows(&traces->curves[CRANK_TRACE_FORCE][0], tape, page->next, CRANK_TAPE_COLUMNS, MILLI, CRANK_TAPE_FORCE,
                 1, origin);
    if (grown)
        size_to_curve(traces, CRANK_TRACE_FORCE, 0, false, true);
}

static void show_slider(CrankTraces *traces, const CrankTape *tape, size_t cycle) {
    CrankPage *page = &traces->pages[CRANK_TRACE_SLIDER];
    MachineCurve *curve = &traces->curves[CRANK_TRACE_SLIDER][0];
    bool grown = turn_page(traces, CRANK_TRACE_SLIDER, tape, cycle, tape->first);
    for (; page->next <= cycle && page->next < tape->front; page->next++, grown = true) {
        add_rows(curve, tape, page->next, CRANK_TAPE_ANGLE, 180 / M_PI, CRANK_TAPE_SLIDER_OFF, MILLI, 0);
        if (curve->count)
            machine_curve_add(curve, curve->time[curve->count - 1], NAN, NAN);
    }
    if (grown)
        size_to_curve(traces, CRANK_TRACE_SLIDER, 0, false, true);
}

/* Spectrum ----------------------------------------------------------------------------------------------------------*/

static void mark(CrankTraces *traces, double frequency, const char *name) {
    Plot *plot = &traces->plots[CRANK_TRACE_SPECTRUM];
    if (frequency < plot->x.high && plot->guide_count < CRANK_TRACE_GUIDES)
        plot->guides[plot->guide_count++] =
            (PlotGuide){.upright = true, .at = frequency, .name = name, .role = ROLE_DIM_TEXT, .style = LINE_DASHED};
}

static void mark_frequencies(CrankTraces *traces, const Tree *tree) {
    Plot *plot = &traces->plots[CRANK_TRACE_SPECTRUM];
    double bending = tree->bending ? tree_bending_frequency(tree, 0) : 0;
    double x = tree_support_frequency(tree, 0), y = tree_support_frequency(tree, 1),
           z = tree_support_frequency(tree, 2);
    plot->x.low = 0;
    plot->x.high = machine_axis_round_up(fmax(MULTIPLES * tree->omega / (2 * M_PI), 1.2 * bending));
    plot->guide_count = 0;
    if (tree->bending)
        mark(traces, bending, "bending");
    mark(traces, x, "support x");
    mark(traces, y, fabs(z - y) < 1e-9 ? "support y, z" : "support y");
    if (fabs(z - y) >= 1e-9)
        mark(traces, z, "support z");
}

static void show_spectrum(CrankTraces *traces, const CrankTape *tape, size_t cycle) {
    if (!turn_page(traces, CRANK_TRACE_SPECTRUM, tape, cycle, tape->first))
        return;
    CrankPage *page = &traces->pages[CRANK_TRACE_SPECTRUM];
    const CrankPart *part = crank_tape_part(tape, cycle);
    Plot *plot = &traces->plots[CRANK_TRACE_SPECTRUM];
    MachineCurve *curve = &traces->curves[CRANK_TRACE_SPECTRUM][0];
    mark_frequencies(traces, &part->tree);
    size_t to = part->first + page->number * pages[CRANK_TRACE_SPECTRUM];
    size_t from = to > part->first + SPECTRUM_TURNS ? to - SPECTRUM_TURNS : part->first;
    from = from > tape->first ? from : tape->first;
    page->next = SIZE_MAX;
    if (to < from + SPECTRUM_LEAST || part->tree.turns) /* a motor's revolutions are not of one length */
        return;
    double *samples = memory_zeroed((to - from) * CRANK_TAPE_ROWS, sizeof *samples), largest = 0;
    size_t count = 0;
    for (size_t c = from; c < to; c++) {
        const CrankTapeCycle *at = crank_tape_cycle(tape, c);
        for (size_t r = 0; r < CRANK_TAPE_ROWS && r < at->row_count; r += ROW_STEP)
            samples[count++] = crank_tape_row(at, r)[CRANK_TAPE_FORCE];
    }
    Spectrum spectrum = spectrum_make(samples, count, 1, ROW_STEP * part->tree.period / CRANK_TAPE_ROWS);
    for (size_t k = 1; k < spectrum.count && spectrum.frequency[k] <= plot->x.high; k++) {
        machine_curve_add(curve, 0, spectrum.frequency[k], spectrum.amplitude[k]);
        largest = fmax(largest, spectrum.amplitude[k]);
    }
    spectrum_clear(&spectrum);
    memory_free(samples);
    if (largest > 0) {
        plot->y.high = fmax(plot->y.high, pow(10, ceil(log10(largest))));
        plot->y.low = SPECTRUM_DEPTH * plot->y.high;
    }
}

/* -------------------------------------------------------------------------------------------------------------------*/

void crank_traces_show(CrankTraces *traces, const CrankTape *tape, double time) {
    size_t row, cycle = crank_tape_cycle_at(tape, time, &row);
    show_phase(traces, tape, cycle);
    show_returns(traces, tape, cycle, CRANK_TRACE_POINCARE);
    show_returns(traces, tape, cycle, CRANK_TRACE_ACROSS);
    show_force(traces, tape, cycle);
    show_slider(traces, tape, cycle);
    show_spectrum(traces, tape, cycle);
    take_curves(traces);
}

size_t crank_traces_until(const CrankTraces *traces, size_t plot, size_t series, double time) {
    const MachineCurve *curve = &traces->curves[plot][series];
    return traces->whole[plot][series] ? curve->count : machine_curve_count_until(curve, time);
}

void crank_traces_store(CrankTraces *traces, double time) {
    MachineCurve *curves = traces->curves[CRANK_TRACE_PHASE];
    machine_curve_copy(&curves[SERIES_KEPT], &curves[SERIES_LINE], time);
    bool some = curves[SERIES_KEPT].count > 0;
    traces->series[CRANK_TRACE_PHASE][SERIES_KEPT].name = some ? "before" : NULL;
    traces->series[CRANK_TRACE_PHASE][SERIES_LINE].name = some ? "now" : NULL;
    traces->revisions[CRANK_TRACE_PHASE]++;
    take_curves(traces);
}

void crank_traces_forget(CrankTraces *traces, size_t cycle) {
    traces->cleared = cycle;
    for (size_t p = 0; p < CRANK_TRACES; p++) {
        traces->pages[p].serial = 0;
        traces->plots[p].y.high = traces->plots[p].y.low = 0;
        if (p != CRANK_TRACE_SLIDER)
            traces->plots[p].x.high = traces->plots[p].x.low = 0;
    }
}
