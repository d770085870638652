#include "visual/study/study_maps.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "cycle/motion_class.h"
#include "study/summary.h"
#include "visual/study/measured_marks.h"
#include "visual/study/study_axes.h"

#define SAME 1e-3      /* of a measure: nearer values belong to one attractor */
#define CONSTANT 1e-6  /* of a ratio over the map: nearer values count as one */
#define EDGE_WIDTH 1.8 /* design points, of the lines round regions of types */

enum {
    CLASSES_MOST = 12,
    SIDE_MOST = 1000, /* cells of a map in a direction: about as many as a picture has pixels */
};

/* The map that is being made. */
typedef struct Map {
    const Study *study;
    size_t pass, columns, rows;
    size_t every[STUDY_AXES_MOST]; /* one of this many values of an axis is shown */
    StudyScale x, y;
    Arena *arena;
    StudyPlot *to;
    PlotRaster *raster;
    double *values; /* (rows x columns) */
    PlotClass *classes;
} Map;

size_t study_maps_most(const Study *study) {
    return study->axis_count == 2 ? study->pass_count * (study->experiment->observable_count + 1) : 0;
}

static const Trial *map_trial(const Map *map, size_t run, size_t cell) {
    return study_trial(map->study, map->pass, run, cell / map->columns * map->every[1],
                       cell % map->columns * map->every[0]);
}

/* Returns the mean of all runs. */
static double cell_value(const Map *map, size_t cell, size_t observable) {
    double sum = 0;
    for (size_t run = 0; run < map->study->runs; run++)
        sum += study_axes_value(map_trial(map, run, cell), observable);
    return sum / (double)map->study->runs;
}

/* Attractors ------------------------------------------------------------------------------------------------------- */

typedef struct Attractor {
    double outcome, measure;
    size_t trials, first; /* number of trials that lead there; in the order of discovery */
} Attractor;

static bool is_same(const Attractor *known, double outcome, double measure) {
    return known->outcome == outcome && fabs(known->measure - measure) <= SAME * fabs(known->measure);
}

static int compare_attractors(const void *a, const void *b) {
    const Attractor *p = a, *q = b;
    if (p->trials != q->trials)
        return (p->trials < q->trials) - (p->trials > q->trials);
    return (p->first > q->first) - (p->first < q->first);
}

/* Attractors of a map: regular trials of the same outcome whose measures agree within a thousandth. `found` (a cell)
 * gets the attractor of each trial, counted from 0, the one that most trials reach first; -1: not regular;
 * -2: unknown. Returns the number of attractors; the caller frees `list`. */
static size_t list_attractors(const Map *map, int *found, Attractor **list) {
    const Experiment *experiment = map->study->experiment;
    size_t settled = study_axes_find(map->study, "attractor_peak");
    size_t cells = map->columns * map->rows, count = 0, capacity = 0;
    Attractor *known = NULL;
    for (size_t c = 0; c < cells; c++) {
        const Trial *trial = map_trial(map, 0, c);
        double regular = study_axes_value(trial, experiment->regular);
        found[c] = isnan(regular) ? -2 : regular > 0 ? (int)count : -1;
        if (!(regular > 0))
            continue;
        double outcome = trial->observed[experiment->outcome], measure = trial->observed[experiment->measure];
        double peak = settled < experiment->observable_count ? trial->observed[settled] : (double)NAN;
        measure = isnan(peak) ? measure : peak;
        for (size_t a = count; a-- > 0;)
            if (is_same(&known[a], outcome, measure))
                found[c] = (int)a;
        if ((size_t)found[c] == count) {
            known = memory_reserve(known, &capacity, count + 1, sizeof *known);
            known[count] = (Attractor){outcome, measure, 0, count};
            count++;
        }
        known[found[c]].trials++;
    }
    if (count)
        qsort(known, count, sizeof *known, compare_attractors);
    int *place = memory_zeroed(count + 1, sizeof *place);
    for (size_t a = 0; a < count; a++)
        place[known[a].first] = (int)a;
    for (size_t c = 0; c < cells; c++)
        found[c] = found[c] < 0 ? found[c] : place[found[c]];
    memory_free(place);
    *list = known;
    return count;
}

/* Maps ------------------------------------------------------------------------------------------------------------- */

/* Returns the range of `cells` cells along an axis, each with one of `every` values in its middle. */
static void axis_box(const StudyAxis *axis, size_t every, size_t cells, double factor, double *low, double *high) {
    double step = axis->steps > 1 ? (axis->to - axis->from) / (double)(axis->steps - 1) : 1;
    double width = step * (double)every, last = every > 1 ? axis->from + width * (double)(cells - 1) : axis->to;
    *low = factor * (axis->from - width / 2);
    *high = factor * (last + width / 2);
}

static size_t shown_of(size_t steps, size_t every) {
    return (steps + every - 1) / every;
}

static Map begin_map(StudyPlots *plots, const Study *study, size_t pass, const char *name) {
    Map map = {.study = study,
               .pass = pass,
               .x = study_axes_parameter(study, 0, &plots->arena),
               .y = study_axes_parameter(study, 1, &plots->arena),
               .arena = &plots->arena,
               .to = &plots->plots[plots->count]};
    for (size_t a = 0; a < STUDY_AXES_MOST; a++)
        map.every[a] = shown_of(study->axes[a].steps, SIDE_MOST);
    map.columns = shown_of(study->axes[0].steps, map.every[0]);
    map.rows = shown_of(study->axes[1].steps, map.every[1]);
    map.raster = arena_allocate(map.arena, sizeof *map.raster);
    map.values = arena_allocate(map.arena, map.columns * map.rows * sizeof *map.values);
    map.classes = arena_allocate(map.arena, CLASSES_MOST * sizeof *map.classes);
    *map.raster = (PlotRaster){.columns = map.columns, .rows = map.rows, .values = map.values};
    axis_box(&study->axes[0], map.every[0], map.columns, map.x.factor, &map.raster->box.low.x, &map.raster->box.high.x);
    axis_box(&study->axes[1], map.every[1], map.rows, map.y.factor, &map.raster->box.low.y, &map.raster->box.high.y);
    bool several = study->pass_count > 1;
    const char *way = several ? study_pass_name(study->passes[pass]) : NULL;
    *map.to = (StudyPlot){.name = text_in_arena(map.arena, "%s%s%s", name, way ? "-" : "", way ? way : ""),
                          .plot = {.x = map.x.axis, .y = map.y.axis, .raster = map.raster, .note = way}};
    map.to->plot.series = arena_allocate(map.arena, 2 * sizeof *map.to->plot.series);
    return map;
}

/* Gives each class that occurs in the map a place in the key, and renumbers the cells. */
static void store_classes(Map *map, const PlotClass *classes, size_t count) {
    int place[CLASSES_MOST];
    memset(place, -1, sizeof place);
    for (size_t c = 0; c < count; c++)
        for (size_t i = 0; i < map->columns * map->rows && place[c] < 0; i++)
            if (map->values[i] == (double)c) {
                place[c] = (int)map->raster->class_count;
                map->classes[map->raster->class_count++] = classes[c];
            }
    for (size_t i = 0; i < map->columns * map->rows; i++)
        if (isfinite(map->values[i]))
            map->values[i] = place[(size_t)map->values[i]];
    map->raster->classes = map->classes;
}

static bool is_house(const Map *map) {
    return strcmp(map->study->experiment->kind, "house") == 0;
}

/* True if the cell was run to the end: a missing value is then undecided. */
static bool was_run(const Map *map, size_t cell) {
    for (size_t run = 0; run < map->study->runs; run++)
        if (!map_trial(map, run, cell)->done || map_trial(map, run, cell)->fault)
            return false;
    return true;
}

/* Uses the classes of the first run where a place has several runs. */
static void note_first(Map *map) {
    if (map->study->runs > 1)
        map->to->plot.note = text_in_arena(map->arena, "first of %zu runs", map->study->runs);
}

#define UNDECIDED_CLASS                                                                                                \
    { "undecided", "?", ROLE_CLASS_NONE, PLOT_PATTERN_RISING }

static void classify_regular(Map *map) {
    bool house = is_house(map);
    const PlotClass classes[] = {
        {house ? "not all out" : "not periodic", house ? "no" : "n", ROLE_TYPE_THIRD, PLOT_PATTERN_PLAIN},
        {house ? "all out" : "periodic", house ? "out" : "p", ROLE_CLASS_FIRST, PLOT_PATTERN_PLAIN},
        UNDECIDED_CLASS};
    for (size_t i = 0; i < map->columns * map->rows; i++) {
        double regular = cell_value(map, i, map->study->experiment->regular);
        map->values[i] = !isnan(regular) ? regular >= 0.5 : was_run(map, i) ? 2 : NAN;
    }
    store_classes(map, classes, 3);
}

/* Returns 0 without contact, 1 to 4, 5 for 5 to 8, 6 for more, 7 for none. */
static double period_class(double period, double force) {
    if (isnan(period) || force == 0)
        return isnan(period) ? NAN : 0;
    return period < 1 ? 7 : period <= 4 ? floor(period) : period <= 8 ? 5 : 6;
}

/* The look of each class of motion. */
static const PlotClass motions[MOTION_CLASSES] = {
    [MOTION_CLASS_FREE] = {"without contact", "free", ROLE_CLASS_NONE, PLOT_PATTERN_PLAIN},
    [MOTION_CLASS_PERIODIC] = {"periodic", "p", ROLE_CLASS_FIRST, PLOT_PATTERN_PLAIN},
    [MOTION_CLASS_QUASI_PERIODIC] = {"quasi-periodic", "q", ROLE_CLASS_FIFTH, PLOT_PATTERN_RISING},
    [MOTION_CLASS_CHAOTIC] = {"chaotic", "c", ROLE_TYPE_THIRD, PLOT_PATTERN_PLAIN},
    [MOTION_CLASS_TRANSIENT] = {"transient", "t", ROLE_TYPE_SECOND, PLOT_PATTERN_FALLING},
    [MOTION_CLASS_UNDETERMINED] = {"undetermined", "?", ROLE_CLASS_NONE, PLOT_PATTERN_RISING},
    [MOTION_CLASS_CHATTERS] = {"chatters", "!", ROLE_CLASS_SIXTH, PLOT_PATTERN_LEVEL},
    [MOTION_CLASS_DIVERGED] = {"diverged", "!!", ROLE_CLASS_SIXTH, PLOT_PATTERN_CROSSED},
    [MOTION_CLASS_NOT_PERIODIC] = {"not periodic (quick)", "n", ROLE_CLASS_FOURTH, PLOT_PATTERN_CROSSED},
};

static void classify_motion(Map *map) {
    for (size_t i = 0; i < map->columns * map->rows; i++)
        map->values[i] = study_axes_value(map_trial(map, 0, i), map->study->experiment->verdict);
    note_first(map);
    store_classes(map, motions, MOTION_CLASSES);
}

/* Returns the class of motion of a trial that was told thoroughly and is not periodic; MOTION_CLASSES: none. */
static size_t wild_class(const Map *map, const Trial *trial) {
    const Experiment *experiment = map->study->experiment;
    double value = experiment->verdict_count ? study_axes_value(trial, experiment->verdict) : (double)NAN;
    bool wild =
        value == MOTION_CLASS_QUASI_PERIODIC || value == MOTION_CLASS_CHAOTIC || value == MOTION_CLASS_TRANSIENT;
    return wild ? (size_t)value : MOTION_CLASSES;
}

static void classify_period(Map *map) {
    const PlotClass classes[] = {
        {"no contact", "free", ROLE_CLASS_NONE, PLOT_PATTERN_PLAIN},
        {"period 1", "1", ROLE_CLASS_FIRST, PLOT_PATTERN_PLAIN},
        {"period 2", "2", ROLE_CLASS_SECOND, PLOT_PATTERN_RISING},
        {"period 3", "3", ROLE_CLASS_THIRD, PLOT_PATTERN_FALLING},
        {"period 4", "4", ROLE_CLASS_FOURTH, PLOT_PATTERN_CROSSED},
        {"5 to 8", "5", ROLE_CLASS_FIFTH, PLOT_PATTERN_UPRIGHT},
        {"9 and more", "9", ROLE_CLASS_SIXTH, PLOT_PATTERN_LEVEL},
        {"not periodic", "n", ROLE_TYPE_THIRD, PLOT_PATTERN_PLAIN},
        motions[MOTION_CLASS_QUASI_PERIODIC],
        motions[MOTION_CLASS_CHAOTIC],
        motions[MOTION_CLASS_TRANSIENT],
        UNDECIDED_CLASS,
    };
    enum { WILD_FIRST = 8 };
    const double undecided = sizeof classes / sizeof *classes - 1;
    size_t period = study_axes_find(map->study, "period"), force = study_axes_find(map->study, "peak_max");
    bool known = force < map->study->experiment->observable_count;
    for (size_t i = 0; i < map->columns * map->rows; i++) {
        const Trial *trial = map_trial(map, 0, i);
        double class = period_class(study_axes_value(trial, period), known ? study_axes_value(trial, force) : NAN);
        size_t wild = wild_class(map, trial);
        map->values[i] = wild < MOTION_CLASSES             ? (double)(WILD_FIRST + wild - MOTION_CLASS_QUASI_PERIODIC)
                         : isnan(class) && was_run(map, i) ? undecided
                                                           : class;
    }
    note_first(map);
    store_classes(map, classes, sizeof classes / sizeof *classes);
}

static void classify_type(Map *map) {
    static const PlotClass classes[] = {{"type I", "I", ROLE_TYPE_FIRST, PLOT_PATTERN_PLAIN},
                                        {"type II", "II", ROLE_TYPE_SECOND, PLOT_PATTERN_RISING},
                                        {"type III", "III", ROLE_TYPE_THIRD, PLOT_PATTERN_PLAIN},
                                        {"unresolved", "?", ROLE_CLASS_NONE, PLOT_PATTERN_RISING}};
    size_t type = study_axes_find(map->study, "type");
    for (size_t i = 0; i < map->columns * map->rows; i++) {
        double value = study_axes_value(map_trial(map, 0, i), type);
        map->values[i] = value >= 1 && value <= 3 ? value - 1 : was_run(map, i) ? 3 : NAN;
    }
    note_first(map);
    store_classes(map, classes, 4);
}

/* Shows the worst rank of each cell, and where there is none. */
static void classify_rank(Map *map, const char *name) {
    static const Role roles[] = {ROLE_CLASS_FIRST, ROLE_CLASS_SECOND, ROLE_CLASS_THIRD,
                                 ROLE_TYPE_SECOND, ROLE_CLASS_FOURTH, ROLE_CLASS_SIXTH};
    enum { ROLES = sizeof roles / sizeof *roles };
    const Experiment *experiment = map->study->experiment;
    PlotClass classes[ROLES + 1];
    size_t count = experiment->rank_count < ROLES ? experiment->rank_count : ROLES;
    for (size_t c = 0; c < count; c++)
        classes[c] = (PlotClass){text_in_arena(map->arena, "%s %s", name, experiment->ranks[c]), experiment->ranks[c],
                                 roles[c], (PlotPattern)(c % PLOT_PATTERNS)};
    for (size_t i = 0; i < map->columns * map->rows; i++) {
        const Trial *worst = summary_worst_rank(map->study, map->pass, i / map->columns * map->every[1],
                                                i % map->columns * map->every[0]);
        map->values[i] = worst ? worst->observed[experiment->rank] : was_run(map, i) ? (double)count : NAN;
    }
    classes[count] = (PlotClass){is_house(map) ? "not all out" : "none", "no", ROLE_CLASS_NONE, PLOT_PATTERN_PLAIN};
    store_classes(map, classes, count + 1);
}

static const char *attractor_name(const Map *map, const Attractor *attractor) {
    const Experiment *experiment = map->study->experiment;
    const Observable *outcome = &experiment->observables[experiment->outcome];
    const Observable *measure = &experiment->observables[experiment->measure];
    return text_in_arena(map->arena, "%s %g, %.4g %s", outcome->name, attractor->outcome, attractor->measure,
                         measure->unit);
}

static void classify_attractors(Map *map) {
    static const Role roles[] = {ROLE_CLASS_FIRST,  ROLE_CLASS_FOURTH, ROLE_TYPE_SECOND,
                                 ROLE_CLASS_SECOND, ROLE_CLASS_SIXTH,  ROLE_CLASS_THIRD};
    static const char *const marks[] = {"A", "B", "C", "D", "E", "F", "G", "H", "I"};
    enum { SHOWN = sizeof marks / sizeof *marks, REST = SHOWN, WILD, UNDECIDED, ROLES = sizeof roles / sizeof *roles };
    size_t cells = map->columns * map->rows;
    int *found = arena_allocate(map->arena, cells * sizeof *found);
    Attractor *list;
    size_t count = list_attractors(map, found, &list);
    PlotClass classes[CLASSES_MOST] = {[REST] = {"others", "+", ROLE_CLASS_NONE, PLOT_PATTERN_CROSSED},
                                       [WILD] = {"not regular", "n", ROLE_TYPE_THIRD, PLOT_PATTERN_PLAIN},
                                       [UNDECIDED] = UNDECIDED_CLASS};
    for (size_t a = 0; a < SHOWN && a < count; a++)
        classes[a] = (PlotClass){text_in_arena(map->arena, "%s: %s", marks[a], attractor_name(map, &list[a])), marks[a],
                                 roles[a % ROLES], (PlotPattern)(a % PLOT_PATTERNS)};
    for (size_t i = 0; i < cells; i++)
        map->values[i] = found[i] == -2     ? (was_run(map, i) ? UNDECIDED : NAN)
                         : found[i] == -1   ? WILD
                         : found[i] < SHOWN ? found[i]
                                            : REST;
    memory_free(list);
    note_first(map);
    store_classes(map, classes, UNDECIDED + 1);
}

/* Fills the map with a quantity; false if it is constant or unknown. */
static bool fill_quantity(Map *map, size_t observable) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (size_t i = 0; i < map->columns * map->rows; i++) {
        map->values[i] = cell_value(map, i, observable);
        low = fmin(low, isfinite(map->values[i]) ? map->values[i] : low);
        high = fmax(high, isfinite(map->values[i]) ? map->values[i] : high);
    }
    const Observable *shown = &map->study->experiment->observables[observable];
    map->raster->value = study_axes_observable(shown).axis;
    return low < high;
}

/* Marks over a map ------------------------------------------------------------------------------------------------- */

/* Adds the ratio of clearance and static deflection if it depends on the clearance alone. */
static void add_ratio(Map *map) {
    size_t ratio = study_axes_find(map->study, "clearance_ratio");
    if (ratio == map->study->experiment->observable_count || strcmp(map->study->axes[1].name, "joint.clearance") != 0)
        return;
    double factor = NAN;
    for (size_t i = 0; i < map->columns * map->rows; i++) {
        const Trial *trial = map_trial(map, 0, i);
        double own = study_axes_value(trial, ratio) / (map->y.factor * trial->at[1]);
        if (!isfinite(own))
            continue;
        if (isfinite(factor) && fabs(own - factor) > CONSTANT * fabs(factor))
            return;
        factor = own;
    }
    if (isfinite(factor)) {
        const char *symbol = strrchr(map->study->experiment->observables[ratio].meaning, ' '); /* at its end: "g/a" */
        map->to->plot.right = (PlotAxis){.title = symbol ? symbol + 1 : NULL};
        map->to->plot.right_factor = factor;
    }
}

/* Adds the line between a cell and its neighbour to the right or above if their types differ. */
static void add_edge(const Map *map, size_t type, size_t cell, size_t neighbour, Vec2 *ends, size_t *count) {
    double own = study_axes_value(map_trial(map, 0, cell), type);
    double other = study_axes_value(map_trial(map, 0, neighbour), type);
    if (isnan(own) || isnan(other) || own == other)
        return;
    Vec2 low = map->raster->box.low, step = vec2(box_width(map->raster->box) / (double)map->columns,
                                                 box_height(map->raster->box) / (double)map->rows);
    size_t column = neighbour % map->columns, row = neighbour / map->columns;
    Vec2 from = vec2(low.x + step.x * (double)column, low.y + step.y * (double)row);
    Vec2 to = neighbour == cell + 1 ? vec2(from.x, from.y + step.y) : vec2(from.x + step.x, from.y);
    ends[(*count)++] = from;
    ends[(*count)++] = to;
    ends[(*count)++] = vec2(NAN, NAN);
}

static PlotSeries edges_series(const Map *map, const Vec2 *ends, size_t count) {
    Vec2 *own = arena_allocate(map->arena, count * sizeof *own);
    memcpy(own, ends, count * sizeof *own);
    return (PlotSeries){.name = "between types",
                        .x = &own[0].x,
                        .y = &own[0].y,
                        .count = count,
                        .stride = sizeof *own / sizeof(double),
                        .role = ROLE_IMPACT,
                        .width = EDGE_WIDTH};
}

/* Adds the borders of type regions to the map of another observable. */
static void add_types(Map *map) {
    size_t type = study_axes_find(map->study, "type"), cells = map->columns * map->rows, count = 0;
    if (type == map->study->experiment->observable_count)
        return;
    size_t capacity = 0;
    Vec2 *ends = NULL;
    for (size_t i = 0; i < cells; i++) {
        ends = memory_reserve(ends, &capacity, count + 6, sizeof *ends);
        if (i % map->columns + 1 < map->columns)
            add_edge(map, type, i, i + 1, ends, &count);
        if (i + map->columns < cells)
            add_edge(map, type, i, i + map->columns, ends, &count);
    }
    if (count)
        map->to->plot.series[map->to->plot.series_count++] = edges_series(map, ends, count);
    memory_free(ends);
}

/* Says that not all cells are shown. */
static void note_thinned(Map *map) {
    const char *note = map->to->plot.note;
    map->to->plot.note = text_in_arena(map->arena, "%s%sone cell of %zu x %zu", note ? note : "", note ? ", " : "",
                                       map->every[0], map->every[1]);
}

/* Stores a finished map among the plots. */
static void end_map(StudyPlots *plots, Map *map, const Measured *measured, bool types) {
    add_ratio(map);
    if (types)
        add_types(map);
    bool laid = measured_marks_add(&map->to->plot, measured, (MeasuredAxis){map->study->axes[0].name, map->x.factor},
                                   (MeasuredAxis){map->study->axes[1].name, map->y.factor}, "measured", 0, map->arena);
    if (laid && map->to->plot.series_count == 1)
        map->to->plot.note = "rings: measured";
    if (map->every[0] > 1 || map->every[1] > 1)
        note_thinned(map);
    plots->count++;
}

/* Returns a heading, which begins with a capital. */
static const char *capital(Arena *arena, const char *text) {
    char *heading = (char *)arena_text(arena, text);
    heading[0] = (char)toupper((unsigned char)heading[0]);
    return heading;
}

/* Makes the map of an observable. */
static bool fill_map(Map *map, size_t observable) {
    const Experiment *experiment = map->study->experiment;
    const Observable *shown = &experiment->observables[observable];
    map->to->plot.title = capital(map->arena, shown->meaning);
    map->raster->value.title = shown->name;
    if (strcmp(shown->name, "type") == 0) {
        map->to->plot.title = "Regions of types";
        classify_type(map);
    } else if (strcmp(shown->name, "period") == 0) {
        map->to->plot.title =
            text_in_arena(map->arena, "Periodic or not, and the period in %ss", experiment_cycle(experiment));
        classify_period(map);
    } else if (experiment->verdict_count && observable == experiment->verdict) {
        classify_motion(map);
    } else if (observable == experiment->regular) {
        map->to->plot.title = is_house(map) ? "Are all people out?" : "Periodic or not";
        classify_regular(map);
    } else if (experiment->rank_count && observable == experiment->rank) {
        classify_rank(map, shown->name);
    } else {
        return fill_quantity(map, observable);
    }
    return map->raster->class_count > 0;
}

/* True if another map tells more: that of the motion. */
static bool is_coarse(const Experiment *experiment, size_t observable) {
    return experiment->verdict_count && observable == experiment->regular;
}

static bool is_start(const StudyAxis *axis) {
    return strncmp(axis->name, "start.", strlen("start.")) == 0;
}

/* Says what basins show: where a start leads, or where quick runs saw it last. */
static const char *basins_title(const Study *study, Arena *arena) {
    const Experiment *experiment = study->experiment;
    bool quick = false;
    for (size_t t = 0; t < study->trial_count && experiment->verdict_count; t++)
        quick |= study_axes_value(study_nth(study, t), experiment->verdict) >= (double)experiment->verdict_quick;
    if (!quick)
        return "Basins: where each start leads";
    double cycles = experiment->nominal(experiment->given, "run.transient_cycles") +
                    experiment->nominal(experiment->given, "run.cycles");
    return text_in_arena(arena, "Basins: where each start is after %.0f %ss", cycles, experiment_cycle(experiment));
}

static void add_basins(StudyPlots *plots, const Study *study, size_t pass, const Measured *measured) {
    if (!is_start(&study->axes[0]) || !is_start(&study->axes[1]))
        return;
    Map map = begin_map(plots, study, pass, "basins");
    map.to->plot.title = basins_title(study, &plots->arena);
    map.raster->value.title = "attractor";
    classify_attractors(&map);
    end_map(plots, &map, measured, false);
}

void study_maps_add(StudyPlots *plots, const Study *study, const Measured *measured, size_t nth) {
    const Experiment *experiment = study->experiment;
    size_t each = experiment->observable_count + 1, pass = nth / each, o = nth % each;
    if (o == experiment->observable_count) {
        add_basins(plots, study, pass, measured);
        return;
    }
    if (is_coarse(experiment, o) || study_axes_is_mark(study, o))
        return;
    const char *name = experiment->observables[o].name;
    Map map = begin_map(plots, study, pass, text_in_arena(&plots->arena, "map-%s", name));
    if (fill_map(&map, o))
        end_map(plots, &map, measured, strcmp(name, "type") != 0);
}
