#include "laboratory/beam/traces.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "laboratory/machine/axis.h"

#define MILLI 1000.0 /* plots show m and s multiplied by this */

/* Width of a line in design points. */
#define LINE_WIDTH 1.6
#define THIN_WIDTH 1.2
#define DIAMOND 9.0
#define DOT 2.4

enum {
    SAMPLES = 256,       /* samples per cycle, so that a line through them looks smooth */
    PHASE_PAGE = 20,     /* cycles on a page of the phase plane, */
    PHASE_KEPT = 4,      /* plus the last cycles of the page before */
    FORCE_PAGE = 8,      /* cycles on a page of the force against time */
    FORCE_PEAKS = 8,     /* from this stride on only peaks are shown */
    POINTS_PAGE = 10000, /* cycles on a page of a Poincare map, which also shows the page before */
    SPECTRUM_PAGE = 16,  /* cycles between two updates of the spectrum */
    SPECTRUM_LEAST = 8,  /* least number of cycles for a spectrum */
    MULTIPLES = 10,      /* multiples of the drive's frequency in a spectrum */
    PLANE_CELLS = 8,     /* the axes of a Poincare map end at multiples of this part of the phase plane's axes */
};

/* The stride is at least this many times the cycles per frame, so that a page lasts a second or two. */
static const double STRIDES[BEAM_TRACES] = {
    [BEAM_TRACE_PHASE] = 4, [BEAM_TRACE_POINCARE] = 0, [BEAM_TRACE_FORCE] = 15, [BEAM_TRACE_SPECTRUM] = 2};

#define SPECTRUM_DEPTH 1e-6 /* 1, share of the largest amplitude: smaller amplitudes are not shown */

/* Plots -------------------------------------------------------------------------------------------------------------*/

enum { SERIES_KEPT, SERIES_LINE, SERIES_SECTION };

static void set_series(BeamTraces *traces, BeamTrace plot, size_t at, const MachineCurve *curve, PlotSeries looks) {
    traces->series[plot][at] = looks;
    traces->curves[plot][at] = curve;
    if (traces->plots[plot].series_count <= at)
        traces->plots[plot].series_count = at + 1;
}

/* Points the series to the curves' arrays, which may have moved or grown. */
static void take_curves(BeamTraces *traces) {
    for (size_t p = 0; p < BEAM_TRACES; p++)
        for (size_t s = 0; s < traces->plots[p].series_count; s++) {
            PlotSeries *series = &traces->series[p][s];
            series->x = traces->curves[p][s]->x;
            series->y = traces->curves[p][s]->y;
            series->count = traces->curves[p][s]->count;
        }
}

void beam_traces_open(BeamTraces *traces) {
    const PlotSeries line = {.role = ROLE_LOCUS, .width = LINE_WIDTH};
    static const Plot plots[BEAM_TRACES] = {
        [BEAM_TRACE_PHASE] = {.title = "Where the tip goes (phase plane)",
                              .x = {.title = "displacement", .unit = "mm"},
                              .y = {.title = "velocity", .unit = "m/s"}},
        [BEAM_TRACE_POINCARE] = {.title = "Once a cycle (Poincar\u00E9 map)",
                                 .x = {.title = "displacement at phase 0", .unit = "mm"},
                                 .y = {.title = "velocity at phase 0", .unit = "m/s"}},
        [BEAM_TRACE_FORCE] = {.title = "Force on the tip", .y = {.title = "force", .unit = "N"}},
        [BEAM_TRACE_SPECTRUM] = {.title = "Tones (spectrum)",
                                 .x = {.title = "frequency", .unit = "Hz"},
                                 .y = {.title = "amplitude", .unit = "mm", .logarithmic = true}}};
    *traces = (BeamTraces){.shown = -1};
    for (size_t p = 0; p < BEAM_TRACES; p++) {
        traces->plots[p] = plots[p];
        traces->plots[p].series = traces->series[p];
        traces->plots[p].guides = traces->guides[p];
        traces->strides[p] = traces->revisions[p] = 1;
    }
    set_series(traces, BEAM_TRACE_PHASE, SERIES_KEPT, &traces->stored,
               (PlotSeries){.role = ROLE_GHOST, .width = LINE_WIDTH, .style = LINE_DASHED});
    set_series(traces, BEAM_TRACE_PHASE, SERIES_LINE, &traces->phase, line);
    set_series(traces, BEAM_TRACE_PHASE, SERIES_SECTION, &traces->section,
               (PlotSeries){.role = ROLE_WALL, .symbol = SYMBOL_DIAMOND, .size = DIAMOND, .name = "once a cycle"});
    set_series(traces, BEAM_TRACE_POINCARE, 0, &traces->points,
               (PlotSeries){.role = ROLE_WALL, .symbol = SYMBOL_DISC, .size = DOT});
    set_series(traces, BEAM_TRACE_FORCE, 0, &traces->force, line);
    set_series(traces, BEAM_TRACE_SPECTRUM, 0, &traces->spectrum,
               (PlotSeries){.role = ROLE_LOCUS, .width = THIN_WIDTH});
    traces->whole[BEAM_TRACE_PHASE][SERIES_KEPT] = true;
}

void beam_traces_close(BeamTraces *traces) {
    MachineCurve *const curves[] = {&traces->phase, &traces->section,  &traces->points,
                                    &traces->force, &traces->spectrum, &traces->stored};
    for (size_t i = 0; i < sizeof curves / sizeof *curves; i++)
        machine_curve_clear(curves[i]);
    arena_clear(&traces->arena);
}

static void renew(BeamTraces *traces, BeamTrace plot) {
    traces->revisions[plot]++;
}

/* Extends the axes to everything recorded since the last clearing: they grow in round steps, ahead of the drawn
 * lines. */
static void stretch_axes(BeamTraces *traces, const BeamTape *tape) {
    if (traces->seen_to > tape->front)
        traces->seen_to = tape->front;
    for (size_t cycle = traces->seen_to > tape->first ? traces->seen_to : tape->first; cycle < tape->front; cycle++) {
        const BeamExtent *extent = &beam_tape_cycle(tape, cycle)->extent;
        traces->seen = (BeamExtent){.tip_reach = fmax(traces->seen.tip_reach, extent->tip_reach),
                                    .speed = fmax(traces->seen.speed, extent->speed),
                                    .force = fmax(traces->seen.force, extent->force)};
    }
    traces->seen_to = tape->front;
    Plot *phase = &traces->plots[BEAM_TRACE_PHASE], *force = &traces->plots[BEAM_TRACE_FORCE];
    bool wider = machine_axis_stretch(&phase->x, MILLI * traces->seen.tip_reach, true),
         higher = machine_axis_stretch(&phase->y, traces->seen.speed, true);
    if (wider || higher)
        renew(traces, BEAM_TRACE_PHASE);
    if (machine_axis_stretch(&force->y, traces->seen.force, true))
        renew(traces, BEAM_TRACE_FORCE);
}

/* Pages -------------------------------------------------------------------------------------------------------------*/

/* Stores the number of cycles between consecutive frames, and adapts the strides. */
static void note_step(BeamTraces *traces, const BeamPart *part, double time) {
    double step = traces->shown >= 0 ? (time - traces->shown) / part->rig.period : 0;
    traces->shown = time;
    if (step == 0)
        return;
    traces->steps[1] = traces->steps[0];
    traces->steps[0] = fmax(0, step);
    double cycles = fmin(traces->steps[0], traces->steps[1]);
    for (size_t p = 0; p < BEAM_TRACES; p++) {
        size_t *stride = &traces->strides[p];
        while ((double)*stride < STRIDES[p] * cycles && *stride < BEAM_TAPE_CYCLES)
            *stride *= 2;
        while (*stride > 1 && (double)*stride >= 4 * STRIDES[p] * cycles)
            *stride /= 2;
    }
}

/* Turns to the page of a cycle. A page has `length` drawn cycles and includes the last `kept` ones of the page before,
 * but none from before a change of the beam or its drive. True: the page is new, and its curves are empty. */
static bool turn_page(BeamTraces *traces, BeamTrace plot, const BeamTape *tape, size_t cycle, size_t length,
                      size_t kept) {
    const BeamPart *part = beam_tape_part(tape, cycle);
    size_t stride = traces->strides[plot], number = (cycle - part->first) / (stride * length);
    size_t begin = part->first + number * length * stride, back = kept * stride;
    begin = begin > back + tape->first ? begin - back : tape->first;
    begin = begin > part->first ? begin : part->first;
    bool cut = begin < traces->cleared && traces->cleared <= cycle;
    BeamPage *page = &traces->pages[plot];
    if (page->next < tape->first)
        page->next = tape->first;
    if (page->serial == part->serial && page->version == tape->version && page->stride == stride &&
        page->number == number && page->cut == cut)
        return false;
    *page = (BeamPage){part->serial, tape->version, stride, number, cut, cut ? traces->cleared : begin};
    renew(traces, plot);
    return true;
}

/* Phase plane -------------------------------------------------------------------------------------------------------*/

static void sample_phase(BeamTraces *traces, BeamTape *tape, size_t cycle, size_t stride) {
    double x[SAMPLES], y[SAMPLES], begin = beam_tape_begin(tape, cycle);
    double period = beam_tape_part(tape, cycle)->rig.period;
    beam_tape_sample(tape, cycle, &(BeamSamples){x, y, NULL, SAMPLES});
    for (size_t i = 0; i < SAMPLES; i++)
        machine_curve_add(&traces->phase, begin + period * (double)i / SAMPLES, MILLI * x[i], y[i]);
    machine_curve_add(&traces->section, begin, MILLI * x[0], y[0]);
    if (stride > 1)
        machine_curve_add(&traces->phase, begin + period, NAN, NAN);
}

/* Marks the edges of the clearance. */
static void set_stops(BeamTraces *traces, BeamTrace plot, const Beam *beam) {
    double edge = MILLI * beam->clearance;
    for (int i = 0; i < 2; i++)
        traces->guides[plot][i] =
            (PlotGuide){.upright = true, .at = i ? edge : -edge, .role = ROLE_FURNITURE_LINE, .style = LINE_DASHED};
    traces->plots[plot].guide_count = 2;
}

static void show_phase(BeamTraces *traces, BeamTape *tape, size_t cycle) {
    BeamPage *page = &traces->pages[BEAM_TRACE_PHASE];
    if (turn_page(traces, BEAM_TRACE_PHASE, tape, cycle, PHASE_PAGE, PHASE_KEPT)) {
        machine_curve_reset(&traces->phase);
        machine_curve_reset(&traces->section);
        set_stops(traces, BEAM_TRACE_PHASE, &beam_tape_part(tape, cycle)->beam);
    }
    for (; page->next <= cycle && page->next < tape->front; page->next += page->stride)
        sample_phase(traces, tape, page->next, page->stride);
}

/* Poincare map ------------------------------------------------------------------------------------------------------*/

/* Extends the axes to a point. They end at multiples of a part of the phase plane's axes, so that they are round and
 * grow seldom. */
static void include_point(BeamTraces *traces, Vec2 at) {
    Plot *plot = &traces->plots[BEAM_TRACE_POINCARE];
    const Plot *phase = &traces->plots[BEAM_TRACE_PHASE];
    if (at.x > plot->x.low && at.x < plot->x.high && at.y > plot->y.low && at.y < plot->y.high)
        return;
    Vec2 cell = vec2(phase->x.high / PLANE_CELLS, phase->y.high / PLANE_CELLS);
    Box need = {{cell.x * floor(at.x / cell.x - 0.5), cell.y * floor(at.y / cell.y - 0.5)},
                {cell.x * ceil(at.x / cell.x + 0.5), cell.y * ceil(at.y / cell.y + 0.5)}};
    traces->plane = box_include(box_include(traces->plane, need.low), need.high);
    plot->x.low = traces->plane.low.x;
    plot->x.high = traces->plane.high.x;
    plot->y.low = traces->plane.low.y;
    plot->y.high = traces->plane.high.y;
    renew(traces, BEAM_TRACE_POINCARE);
}

static void show_points(BeamTraces *traces, const BeamTape *tape, size_t cycle) {
    BeamPage *page = &traces->pages[BEAM_TRACE_POINCARE];
    if (turn_page(traces, BEAM_TRACE_POINCARE, tape, cycle, POINTS_PAGE, POINTS_PAGE)) {
        machine_curve_reset(&traces->points);
        traces->plane = box_empty();
        traces->plots[BEAM_TRACE_POINCARE].x = (PlotAxis){.title = "displacement at phase 0", .unit = "mm"};
        traces->plots[BEAM_TRACE_POINCARE].y = (PlotAxis){.title = "velocity at phase 0", .unit = "m/s"};
    }
    for (; page->next <= cycle; page->next++) {
        const BeamCycle *at = beam_tape_cycle(tape, page->next);
        machine_curve_add(&traces->points, beam_tape_begin(tape, page->next), MILLI * at->deflection, at->velocity);
        include_point(traces, vec2(MILLI * at->deflection, at->velocity));
    }
}

/* Force -------------------------------------------------------------------------------------------------------------*/

static void sample_force(BeamTraces *traces, BeamTape *tape, size_t cycle, double origin, size_t stride) {
    double force[SAMPLES], begin = beam_tape_begin(tape, cycle), period = beam_tape_part(tape, cycle)->rig.period;
    size_t count = SAMPLES / stride;
    beam_tape_sample(tape, cycle, &(BeamSamples){NULL, NULL, force, count});
    for (size_t i = 0; i < count; i++) {
        double time = begin + period * (double)i / (double)count;
        machine_curve_add(&traces->force, time, MILLI * (time - origin), force[i]);
    }
}

/* Adds the largest forces of a cycle, upwards and downwards. */
static void add_peaks(BeamTraces *traces, const BeamTape *tape, size_t cycle, double origin) {
    double begin = beam_tape_begin(tape, cycle), period = beam_tape_part(tape, cycle)->rig.period;
    const double *peak = beam_tape_cycle(tape, cycle)->peak;
    for (int i = 0; i < 2; i++) {
        double time = begin + period * (0.25 + 0.5 * i);
        machine_curve_add(&traces->force, time, MILLI * (time - origin), i ? -peak[0] : peak[1]);
    }
}

static void begin_force(BeamTraces *traces, const BeamTape *tape, size_t cycle) {
    BeamPage *page = &traces->pages[BEAM_TRACE_FORCE];
    const BeamPart *part = beam_tape_part(tape, cycle);
    Plot *plot = &traces->plots[BEAM_TRACE_FORCE];
    size_t first = part->first + page->number * FORCE_PAGE * page->stride;
    machine_curve_reset(&traces->force);
    arena_clear(&traces->arena);
    plot->x = (PlotAxis){.title = text_in_arena(&traces->arena, "time since cycle %zu", first + 1),
                         .unit = "ms",
                         .high = MILLI * FORCE_PAGE * (double)page->stride * part->rig.period};
    plot->title = page->stride < FORCE_PEAKS ? "Force on the tip" : "Hardest hits on the tip";
    traces->guides[BEAM_TRACE_FORCE][0] = (PlotGuide){.role = ROLE_ROOM, .style = LINE_SOLID};
    plot->guide_count = 1;
}

static void show_force(BeamTraces *traces, BeamTape *tape, size_t cycle) {
    BeamPage *page = &traces->pages[BEAM_TRACE_FORCE];
    if (turn_page(traces, BEAM_TRACE_FORCE, tape, cycle, FORCE_PAGE, 0))
        begin_force(traces, tape, cycle);
    const BeamPart *part = beam_tape_part(tape, cycle);
    double origin = part->begin + (double)(page->number * FORCE_PAGE * page->stride) * part->rig.period;
    for (; page->next <= cycle && page->next < tape->front; page->next++) {
        if (page->stride < FORCE_PEAKS)
            sample_force(traces, tape, page->next, origin, page->stride);
        else
            add_peaks(traces, tape, page->next, origin);
    }
}

/* Spectrum ----------------------------------------------------------------------------------------------------------*/

static const double *wave_of(BeamTraces *traces, BeamTape *tape, size_t cycle) {
    size_t at = cycle % BEAM_TRACE_SPECTRA;
    if (traces->waves_of[at] != cycle + 1) {
        beam_tape_sample(tape, cycle, &(BeamSamples){traces->waves[at], NULL, NULL, BEAM_TRACE_WAVES});
        traces->waves_of[at] = cycle + 1;
    }
    return traces->waves[at];
}

static void add_multiples(BeamTraces *traces, double frequency) {
    static const char *const names[MULTIPLES] = {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10"};
    Plot *plot = &traces->plots[BEAM_TRACE_SPECTRUM];
    plot->guide_count = MULTIPLES;
    for (int m = 0; m < MULTIPLES; m++)
        plot->guides[m] = (PlotGuide){
            .upright = true, .at = (m + 1) * frequency, .name = names[m], .role = ROLE_DIM_TEXT, .style = LINE_DOTTED};
    plot->x.low = 0;
    plot->x.high = (MULTIPLES + 0.5) * frequency;
}

/* Computes the spectrum of the cycles from one cycle up to but excluding another. */
static void make_spectrum(BeamTraces *traces, BeamTape *tape, size_t from, size_t to) {
    static const double least = 1e-9; /* mm */
    double samples[BEAM_TRACE_SPECTRA * BEAM_TRACE_WAVES], largest = least;
    const BeamPart *part = beam_tape_part(tape, from);
    Plot *plot = &traces->plots[BEAM_TRACE_SPECTRUM];
    for (size_t cycle = from; cycle < to; cycle++)
        memcpy(samples + (cycle - from) * BEAM_TRACE_WAVES, wave_of(traces, tape, cycle), sizeof traces->waves[0]);
    Spectrum spectrum = spectrum_make(samples, (to - from) * BEAM_TRACE_WAVES, 1, part->rig.period / BEAM_TRACE_WAVES);
    for (size_t k = 1; k < spectrum.count && spectrum.frequency[k] <= plot->x.high; k++) {
        machine_curve_add(&traces->spectrum, 0, spectrum.frequency[k], MILLI * spectrum.amplitude[k]);
        largest = fmax(largest, MILLI * spectrum.amplitude[k]);
    }
    spectrum_clear(&spectrum);
    plot->y.high = fmax(plot->y.high, pow(10, ceil(log10(largest))));
    plot->y.low = SPECTRUM_DEPTH * plot->y.high;
}

static void show_spectrum(BeamTraces *traces, BeamTape *tape, size_t cycle) {
    const BeamPart *part = beam_tape_part(tape, cycle);
    const BeamPage *page = &traces->pages[BEAM_TRACE_SPECTRUM];
    bool onwards = traces->waves_serial == part->serial && traces->version == tape->version;
    if (!onwards)
        memset(traces->waves_of, 0, sizeof traces->waves_of);
    traces->waves_serial = part->serial;
    if (turn_page(traces, BEAM_TRACE_SPECTRUM, tape, cycle, SPECTRUM_PAGE, 0)) {
        size_t to = part->first + page->number * SPECTRUM_PAGE * page->stride;
        size_t first = part->first > tape->first ? part->first : tape->first;
        machine_curve_reset(&traces->spectrum);
        add_multiples(traces, part->beam.frequency);
        if (to >= first + SPECTRUM_LEAST)
            make_spectrum(traces, tape, to > first + BEAM_TRACE_SPECTRA ? to - BEAM_TRACE_SPECTRA : first, to);
    }
    size_t end = part->first + (page->number + 1) * SPECTRUM_PAGE * page->stride, from = cycle + 1;
    if (onwards && traces->last < cycle && cycle - traces->last < BEAM_TRACE_SPECTRA)
        from = traces->last + 1;
    if (from < tape->first)
        from = tape->first;
    for (; from <= cycle && cycle < tape->front; from++)
        if (from + BEAM_TRACE_SPECTRA >= end) /* samples for the next spectrum: a few with each frame */
            wave_of(traces, tape, from);
}

/* -------------------------------------------------------------------------------------------------------------------*/

void beam_traces_show(BeamTraces *traces, BeamTape *tape, double time) {
    double phase;
    size_t cycle = beam_tape_cycle_at(tape, time, &phase);
    note_step(traces, beam_tape_part(tape, cycle), time);
    stretch_axes(traces, tape);
    show_phase(traces, tape, cycle);
    show_points(traces, tape, cycle);
    show_force(traces, tape, cycle);
    show_spectrum(traces, tape, cycle);
    traces->version = tape->version;
    traces->last = cycle;
    take_curves(traces);
}

size_t beam_traces_until(const BeamTraces *traces, size_t plot, size_t series, double time) {
    const MachineCurve *curve = traces->curves[plot][series];
    return traces->whole[plot][series] ? curve->count : machine_curve_count_until(curve, time);
}

void beam_traces_store(BeamTraces *traces, double time) {
    machine_curve_copy(&traces->stored, &traces->phase, time);
    bool some = traces->stored.count > 0;
    traces->series[BEAM_TRACE_PHASE][SERIES_KEPT].name = some ? "before" : NULL;
    traces->series[BEAM_TRACE_PHASE][SERIES_LINE].name = some ? "now" : NULL;
    renew(traces, BEAM_TRACE_PHASE);
    take_curves(traces);
}

void beam_traces_forget(BeamTraces *traces, size_t cycle) {
    traces->cleared = traces->seen_to = cycle;
    traces->seen = (BeamExtent){0};
    for (size_t p = 0; p < BEAM_TRACES; p++) {
        traces->pages[p].serial = 0;
        traces->plots[p].y.high = traces->plots[p].y.low = 0;
    }
    traces->plots[BEAM_TRACE_PHASE].x.high = traces->plots[BEAM_TRACE_PHASE].x.low = 0;
}
