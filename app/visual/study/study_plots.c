#include "visual/study/study_plots.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "visual/study/basin_plots.h"
#include "visual/study/measured_marks.h"
#include "visual/study/study_axes.h"
#include "visual/study/study_maps.h"
#include "visual/study/type_bands.h"
#include "study/montecarlo.h"
#include "study/summary.h"

/* Design points. */
#define LINE_WIDTH 2.0
#define SIGN 5.0
#define RANK_SIGN 9.0
#define PASS_GROWTH 4.0 /* of the symbols of a class, per pass painted over them */

/* Quantiles of the values, shown for many runs. */

enum {
    BARS_LEAST = 5,
    BARS_MOST = 40,
    DOTS_MOST = 2000000, /* of a pass of a large study */
    GUIDES_MOST = 4,     /* of a plot, besides a band for every other step */
    MARKS_MOST = 8,      /* measured series of one plot */
    RANKS_MOST = 6,      /* ranks whose points are marked */
    SIGNS_MOST = 60      /* points of a line */
};

/* The look of a pass. */
static const struct {
    const char *name;
    Role role;
    Symbol symbol;
} looks[] = {[STUDY_RESET] = {"each from rest", ROLE_WALL, SYMBOL_DISC},
             [STUDY_UP] = {"upwards", ROLE_LOCUS, SYMBOL_TRIANGLE},
             [STUDY_DOWN] = {"downwards", ROLE_GHOST, SYMBOL_BOX}};

/* Dots across: 3 design points are 0.5 mm on a page. Later passes have smaller dots, so that equal ones all stay
 * visible. */
static const double DOT = 3.0, DOT_GROWTH = 0.8;
/* Part of the area of a plot, in square design points, that the dots of a pass may cover: more of them shine through,
 * down to the faintest. */
static const double DOTS_COVER = 0.15 * 900 * 380, FAINTEST = 0.15;

/* The plot over one parameter that is being made. */
typedef struct Sweep {
    const Study *study;
    const Measured *measured;
    Arena *arena;
    StudyScale scale; /* of the parameter */
    Plot *plot;
} Sweep;

static Plot *add_plot(StudyPlots *plots, const Study *study, const char *name, size_t areas) {
    StudyPlot *added = &plots->plots[plots->count++];
    size_t bands = study->axis_count ? study->axes[0].steps / 2 + 1 : 0;
    added->name = name;
    added->plot.series =
        arena_allocate(&plots->arena, (2 * study->pass_count + MARKS_MOST + RANKS_MOST) * sizeof(PlotSeries));
    added->plot.guides = arena_allocate(&plots->arena, (GUIDES_MOST + bands) * sizeof(PlotGuide));
    added->plot.areas = arena_allocate(&plots->arena, (areas + 1 + TYPE_BANDS) * sizeof(PlotArea));
    return &added->plot;
}

static void add_guide(Plot *plot, PlotGuide guide) {
    plot->guides[plot->guide_count++] = guide;
}

static size_t steps_of(const Study *study) {
    return study->axes[0].steps;
}

/* Orbit diagram ---------------------------------------------------------------------------------------------------- */

static size_t common_divisor(size_t a, size_t b) {
    while (b) {
        size_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

/* The n-th trial of a pass. */
static const Trial *nth_of(const Study *study, size_t pass, size_t n) {
    return study_trial(study, pass, n / steps_of(study), 0, n % steps_of(study));
}

/* Adds the values that the runs of a pass list, over the parameter; of a large study so many values as a picture can
 * show, of every so many-th run. */
static void add_dots(Sweep *sweep, size_t pass) {
    const Study *study = sweep->study;
    size_t count = 0, runs = study->runs * steps_of(study), passes = study->pass_count, shown = 0;
    for (size_t i = 0; i < runs; i++)
        count += nth_of(study, pass, i)->series_count;
    size_t apart = study->large ? count / DOTS_MOST + 1 : 1;
    while (apart > 1 && common_divisor(apart, steps_of(study)) > 1)
        apart++; /* so that some run of every step is shown */
    count = 0;
    for (size_t i = 0; i < runs; i += apart, shown++)
        count += nth_of(study, pass, i)->series_count;
    if (apart > 1)
        sweep->plot->note = text_in_arena(sweep->arena, "%zu of %zu runs of each pass", shown, runs);
    double *values = arena_allocate(sweep->arena, 2 * (count + 1) * sizeof *values), *next = values;
    for (size_t i = 0; i < runs; i += apart) {
        const Trial *trial = nth_of(study, pass, i);
        for (size_t s = 0; s < trial->series_count; s++) {
            *next++ = sweep->scale.factor * trial->at[0];
            *next++ = trial->series[s];
        }
    }
    double size = DOT + DOT_GROWTH * (double)(passes - 1 - pass),
           cover = DOTS_COVER / ((double)(count + 1) * size * size);
    sweep->plot->series[sweep->plot->series_count++] = (PlotSeries){.name = looks[study->passes[pass]].name,
                                                                    .x = values,
                                                                    .y = values + 1,
                                                                    .count = count,
                                                                    .stride = 2,
                                                                    .role = looks[study->passes[pass]].role,
                                                                    .symbol = looks[study->passes[pass]].symbol,
                                                                    .size = size,
                                                                    .veil = cover < 1 ? fmax(cover, FAINTEST) : 0};
}

/* Adds measured points of the listed values, and of observables derived from them: "peak_max" of "peak". */
static void lay_measured_series(Sweep *sweep) {
    const Experiment *experiment = sweep->study->experiment;
    const char *listed = experiment->series->name;
    MeasuredAxis x = {sweep->study->axes[0].name, sweep->scale.factor};
    size_t shape =
        measured_marks_add(sweep->plot, sweep->measured, x, (MeasuredAxis){listed, 1}, "measured", 0, sweep->arena);
    for (size_t o = 0; o < experiment->observable_count && shape < MARKS_MOST; o++) {
        const Observable *observable = &experiment->observables[o];
        if (strncmp(observable->name, listed, strlen(listed)) == 0 &&
            strcmp(observable->unit, experiment->series->unit) == 0)
            shape +=
                measured_marks_add(sweep->plot, sweep->measured, x, (MeasuredAxis){observable->name, 1},
                                   text_in_arena(sweep->arena, "measured %s", observable->name), shape, sweep->arena);
    }
}

/* Adds the types of the first run of each value, if they were classified. */
static void add_types(Sweep *sweep) {
    const Study *study = sweep->study;
    size_t type = study_axes_find(study, "type"), count = steps_of(study);
    if (type == study->experiment->observable_count)
        return;
    double *values = arena_allocate(sweep->arena, count * sizeof *values),
           *types = arena_allocate(sweep->arena, count * sizeof *types);
    for (size_t i = 0; i < count; i++) {
        values[i] = sweep->scale.factor * study_value(&study->axes[0], i);
        types[i] = study_axes_value(study_trial(study, 0, 0, 0, i), type);
    }
    double step = count > 1 ? (values[count - 1] - values[0]) / (double)(count - 1) : 1;
    type_bands_add(sweep->plot, values, types, count, step, type_bands_height(sweep->plot), sweep->arena);
}

static void add_orbit_diagram(StudyPlots *plots, Sweep sweep) {
    const Observable *listed = sweep.study->experiment->series;
    sweep.plot = add_plot(plots, sweep.study, text_in_arena(sweep.arena, "%ss", listed->name), 0);
    sweep.plot->title = "Orbit diagram";
    sweep.plot->x = sweep.scale.axis;
    sweep.plot->y = study_axes_observable(listed).axis;
    for (size_t pass = 0; pass < sweep.study->pass_count; pass++)
        add_dots(&sweep, pass);
    add_types(&sweep);
    lay_measured_series(&sweep);
}

/* Adds the shares of basins, where each value has several starts. */
static void add_basins(StudyPlots *plots, Sweep sweep) {
    sweep.plot = add_plot(plots, sweep.study, "basins", BASIN_PLOTS_BANDS);
    sweep.plot->title = "Basins: where random starts lead";
    sweep.plot->note = text_in_arena(sweep.arena, "%zu starts at each value", sweep.study->runs);
    sweep.plot->x = sweep.scale.axis;
    sweep.plot->y = (PlotAxis){.title = "share of the starts", .low = 0, .high = 1};
    basin_plots_add(sweep.plot, sweep.study, sweep.scale.factor, sweep.arena);
}

/* One observable --------------------------------------------------------------------------------------------------- */

/* Returns an array of a value for each step. */
static double *steps_array(const Sweep *sweep) {
    return arena_allocate(sweep->arena, steps_of(sweep->study) * sizeof(double));
}

/* Adds the area where `low` and `high` are known. */
static void add_area(const Sweep *sweep, const char *name, const double *x, const double *low, const double *high) {
    sweep->plot->areas[sweep->plot->area_count++] =
        (PlotArea){.name = name, .x = x, .low = low, .high = high, .count = steps_of(sweep->study), .role = ROLE_SHADE};
}

/* True for whole numbers that name something: they have no values in between. */
static bool is_class(const Study *study, size_t observable) {
    const char *name = study->experiment->observables[observable].name;
    return observable == study->experiment->regular || observable == study->experiment->outcome ||
           strcmp(name, "type") == 0 || strcmp(name, "period") == 0;
}

/* Adds the mean of the runs with the range between 5 and 95 % of them, or the only run with its standard error. */
static void add_curve(Sweep *sweep, size_t pass, size_t observable, size_t error) {
    const Study *study = sweep->study;
    size_t known_errors = study->experiment->observable_count;
    double *x = steps_array(sweep), *mean = steps_array(sweep), *low = steps_array(sweep), *high = steps_array(sweep);
    for (size_t i = 0; i < steps_of(study); i++) {
        const Trial *trial = study_trial(study, pass, 0, 0, i);
        x[i] = sweep->scale.factor * trial->at[0];
        Numbers runs = study_axes_runs(&(StudyRuns){study, pass, i, observable});
        Distribution of = montecarlo_of(&runs);
        mean[i] = of.mean;
        double apart = error < known_errors ? study_axes_value(trial, error) : 0;
        low[i] = study->runs > 1 ? of.low : mean[i] - apart;
        high[i] = study->runs > 1 ? of.high : mean[i] + apart;
    }
    if (study->runs > 1)
        add_area(sweep, pass ? NULL : "5 to 95 %", x, low, high);
    else if (error < known_errors)
        add_area(sweep, pass ? NULL : "\u00B1 standard error", x, low, high);
    const char *name = study->pass_count > 1 ? looks[study->passes[pass]].name : study->runs > 1 ? "mean" : NULL;
    bool class = is_class(study, observable), few = steps_of(study) <= SIGNS_MOST;
    double larger = class ? PASS_GROWTH * (double)(study->pass_count - 1 - pass) : 0;
    sweep->plot->series[sweep->plot->series_count++] =
        (PlotSeries){.name = name,
                     .x = x,
                     .y = mean,
                     .count = steps_of(study),
                     .role = looks[study->passes[pass]].role,
                     .symbol = class || few ? looks[study->passes[pass]].symbol : SYMBOL_NONE,
                     .size = SIGN + larger,
                     .width = class ? 0 : LINE_WIDTH};
}

/* True if runs exist at this point and none of them is regular. */
static bool is_blocked(const Study *study, size_t point) {
    bool seen = false;
    for (size_t pass = 0; pass < study->pass_count; pass++)
        for (size_t run = 0; run < study->runs; run++) {
            double regular = study_axes_value(study_trial(study, pass, run, 0, point), study->experiment->regular);
            seen = seen || isfinite(regular);
            if (regular > 0)
                return false;
        }
    return seen;
}

/* Adds bands where nobody gets out of a house: half a step beyond the first and the last such point. */
static void add_blocked(Sweep *sweep) {
    const Study *study = sweep->study;
    const StudyAxis *axis = &study->axes[0];
    double half = axis->steps > 1 ? (axis->to - axis->from) / (double)(axis->steps - 1) / 2 : 0;
    bool named = false;
    for (size_t from = 0, to; from < axis->steps; from = to + 1) {
        for (to = from; to < axis->steps && is_blocked(study, to);)
            to++;
        if (to == from)
            continue;
        add_guide(sweep->plot,
                  (PlotGuide){.upright = true,
                              .band = true,
                              .at = sweep->scale.factor * (study_trial(study, 0, 0, 0, from)->at[0] - half),
                              .to = sweep->scale.factor * (study_trial(study, 0, 0, 0, to - 1)->at[0] + half),
                              .name = named ? NULL : "not all people out",
                              .role = ROLE_FURNITURE});
        named = true;
    }
}

/* Marks the points of each rank: the last series is the only curve. */
static void add_ranks(Sweep *sweep) {
    enum { SHAPES = 4 /* later ranks have the same ones as outlines */ };
    static const Symbol shapes[SHAPES] = {SYMBOL_DISC, SYMBOL_BOX, SYMBOL_TRIANGLE, SYMBOL_DIAMOND};
    static const Role roles[RANKS_MOST] = {ROLE_CLASS_FIRST, ROLE_CLASS_SECOND, ROLE_CLASS_THIRD,
                                           ROLE_TYPE_SECOND, ROLE_CLASS_FOURTH, ROLE_CLASS_SIXTH};
    const Study *study = sweep->study;
    const Experiment *experiment = study->experiment;
    const PlotSeries curve = sweep->plot->series[sweep->plot->series_count - 1];
    for (size_t rank = 0; rank < experiment->rank_count && rank < RANKS_MOST; rank++) {
        double *y = steps_array(sweep);
        bool any = false;
        for (size_t i = 0; i < steps_of(study); i++) {
            const Trial *worst = summary_worst_rank(study, 0, 0, i);
            bool has = worst && worst->observed[experiment->rank] == (double)rank;
            y[i] = has ? curve.y[i] : (double)NAN;
            any |= has;
        }
        if (any)
            sweep->plot->series[sweep->plot->series_count++] = (PlotSeries){
                .name = text_in_arena(sweep->arena, "%s %s", experiment->observables[experiment->rank].name,
                                      experiment->ranks[rank]),
                .x = curve.x,
                .y = y,
                .count = curve.count,
                .role = roles[rank],
                .symbol = shapes[rank % SHAPES],
                .open = rank >= SHAPES,
                .size = RANK_SIGN};
    }
}

/* True if it is known somewhere and not constant. */
static bool is_varied(const Study *study, size_t observable) {
    double first = NAN;
    for (size_t t = 0; t < study->trial_count; t++) {
        double value = study_axes_value(study_nth(study, t), observable);
        if (isfinite(value) && isfinite(first) && value != first)
            return true;
        first = isfinite(first) ? first : value;
    }
    return false;
}

static bool is_error(const char *name) {
    const char *end = strrchr(name, '_');
    return end && strcmp(end, "_error") == 0;
}

/* Adds the zero line of an exponent, whose sign is the verdict. */
static bool is_exponent(const char *name) {
    return strcmp(name, "lyapunov") == 0 || strcmp(name, "exponent") == 0;
}

static void add_observable(StudyPlots *plots, Sweep sweep, size_t observable) {
    const Study *study = sweep.study;
    const Observable *shown = &study->experiment->observables[observable];
    size_t error = study_axes_find(study, text_in_arena(sweep.arena, "%s_error", shown->name));
    sweep.plot = add_plot(plots, study, shown->name, study->pass_count);
    sweep.plot->x = sweep.scale.axis;
    sweep.plot->y = study_axes_observable(shown).axis;
    if (is_exponent(shown->name))
        add_guide(sweep.plot, (PlotGuide){.at = 0, .role = ROLE_ROOM, .style = LINE_SOLID});
    if (strcmp(study->experiment->kind, "house") == 0 && observable != study->experiment->regular)
        add_blocked(&sweep);
    for (size_t pass = 0; pass < study->pass_count; pass++)
        add_curve(&sweep, pass, observable, error);
    if (observable == study->experiment->measure && study->pass_count == 1)
        add_ranks(&sweep);
    bool laid = measured_marks_add(sweep.plot, sweep.measured, (MeasuredAxis){study->axes[0].name, sweep.scale.factor},
                                   (MeasuredAxis){shown->name, 1}, "measured", 0, sweep.arena);
    if (laid && !sweep.plot->series[0].name)
        sweep.plot->series[0].name = "simulated";
}

/* No axis -----------------------------------------------------------------------------------------------------------
 */

/* Adds how many of the values each bar of equal width holds, as a curve with a step at each end. */
static void add_bars(Plot *plot, const Distribution *of, const Numbers *values, Arena *arena) {
    size_t bars = (size_t)real_clamp(ceil(sqrt((double)of->count)), BARS_LEAST, BARS_MOST);
    double low = of->least, width = (of->greatest - low) / (double)bars;
    double *x = arena_allocate(arena, 2 * bars * sizeof *x), *high = arena_allocate(arena, 2 * bars * sizeof *high);
    double *foot = arena_allocate(arena, 2 * bars * sizeof *foot);
    for (size_t b = 0; b < bars; b++) {
        x[2 * b] = low + width * (double)b;
        x[2 * b + 1] = low + width * (double)(b + 1);
    }
    for (size_t i = 0; i < values->count; i++) {
        double value = numbers_at(values, i);
        if (!isfinite(value))
            continue;
        size_t b = (size_t)fmin((double)(bars - 1), (value - low) / width);
        high[2 * b]++;
        high[2 * b + 1]++;
    }
    plot->areas[plot->area_count++] =
        (PlotArea){.x = x, .low = foot, .high = high, .count = 2 * bars, .role = ROLE_SHADE};
    plot->series[plot->series_count++] =
        (PlotSeries){.x = x, .y = high, .count = 2 * bars, .role = ROLE_LOCUS, .width = LINE_WIDTH};
}

static void add_histogram(StudyPlots *plots, const Study *study, size_t observable) {
    const Observable *shown = &study->experiment->observables[observable];
    Arena *arena = &plots->arena;
    const StudyRuns runs = {study, 0, 0, observable};
    Numbers values = study_axes_runs(&runs);
    Plot *plot = add_plot(plots, study, shown->name, 1);
    Distribution of = montecarlo_of(&values);
    plot->title = text_in_arena(arena, "%zu runs", of.count);
    plot->note = text_in_arena(arena, "mean %.4g, 5 to 95 %%: %.4g to %.4g %s", of.mean, of.low, of.high, shown->unit);
    plot->x = study_axes_observable(shown).axis;
    plot->y = (PlotAxis){.title = "runs"};
    add_bars(plot, &of, &values, arena);
    add_guide(plot,
              (PlotGuide){.upright = true, .at = of.mean, .name = "mean", .role = ROLE_WALL, .style = LINE_SOLID});
    add_guide(plot,
              (PlotGuide){.upright = true, .at = of.low, .name = "5 %", .role = ROLE_DIM_TEXT, .style = LINE_DASHED});
    add_guide(plot,
              (PlotGuide){.upright = true, .at = of.high, .name = "95 %", .role = ROLE_DIM_TEXT, .style = LINE_DASHED});
}

/* All -------------------------------------------------------------------------------------------------------------- */

StudyPlots study_plots_make(const Study *study, const Measured *measured) {
    StudyPlots plots = {.count = 0};
    const Experiment *experiment = study->experiment;
    size_t most = experiment->observable_count + 2 + study_maps_most(study);
    plots.plots = arena_allocate(&plots.arena, most * sizeof *plots.plots);
    Sweep sweep = {.study = study, .measured = measured, .arena = &plots.arena};
    if (study->axis_count == 1) {
        sweep.scale = study_axes_parameter(study, 0, &plots.arena);
        sweep.scale.axis.low = sweep.scale.factor * fmin(study->axes[0].from, study->axes[0].to);
        sweep.scale.axis.high = sweep.scale.factor * fmax(study->axes[0].from, study->axes[0].to);
        if (experiment->series)
            add_orbit_diagram(&plots, sweep);
        if (basins_exist(study))
            add_basins(&plots, sweep);
    }
    for (size_t o = 0; o < experiment->observable_count && study->axis_count < 2; o++) {
        bool words = (experiment->verdict_count && o == experiment->verdict) ||
                     (experiment->rank_count && o == experiment->rank);
        if (words || is_error(experiment->observables[o].name) || study_axes_is_mark(study, o) || !is_varied(study, o))
            continue;
        if (study->axis_count)
            add_observable(&plots, sweep, o);
        else
            add_histogram(&plots, study, o);
    }
    for (size_t map = 0; map < study_maps_most(study); map++)
        study_maps_add(&plots, study, measured, map);
    return plots;
}

void study_plots_free(StudyPlots *plots) {
    arena_clear(&plots->arena);
    *plots = (StudyPlots){.count = 0};
}

static int write_all(StudyPlots *plots, const char *out, const PlotSheet *sheet, char path[PLOT_WRITE_PATH]) {
    int error = 0;
    for (size_t i = 0; i < plots->count && !error; i++)
        error = plot_write_files(&plots->plots[i].plot, plots->plots[i].name, out, sheet, path);
    study_plots_free(plots);
    return error;
}

int study_plots_write(const Study *study, const Measured *measured, const char *out, const PlotSheet *sheet,
                      char path[PLOT_WRITE_PATH]) {
    size_t maps = study_maps_most(study);
    int error = 0;
    if (!maps) {
        StudyPlots plots = study_plots_make(study, measured);
        return write_all(&plots, out, sheet, path);
    }
    for (size_t map = 0; map < maps && !error; map++) { /* all of a large study at once need much memory */
        StudyPlots plots = {.count = 0};
        plots.plots = arena_allocate(&plots.arena, sizeof *plots.plots);
        study_maps_add(&plots, study, measured, map);
        error = write_all(&plots, out, sheet, path);
    }
    return error;
}

const MeasuredKind *study_plots_kinds(const Study *study, size_t *count, Arena *arena) {
    const Experiment *experiment = study->experiment;
    MeasuredKind *kinds = arena_allocate(arena, MEASURED_KINDS * sizeof *kinds);
    *count = 0;
    for (size_t a = 0; a < study->axis_count; a++) {
        const Parameter *row = experiment->parameter(experiment->given, study->axes[a].name);
        kinds[(*count)++] = (MeasuredKind){study->axes[a].name, NULL, row && row->unit ? row->unit : "1"};
    }
    if (experiment->series)
        kinds[(*count)++] = (MeasuredKind){experiment->series->name, NULL, experiment->series->unit};
    for (size_t o = 0; o < experiment->observable_count && *count < MEASURED_KINDS; o++)
        kinds[(*count)++] = (MeasuredKind){experiment->observables[o].name, NULL, experiment->observables[o].unit};
    return kinds;
}
