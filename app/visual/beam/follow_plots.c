#include "visual/beam/follow_plots.h"

#include <math.h>
#include <string.h>

/* Design points. */
#define LINE 2.0
#define GROUND 1.2 /* of a curve, over a map */
#define SIGN 8.0
#define SMALL 5.0
#define DOT 3.0 /* 0.5 mm on a page */
#define VEIL 0.2

enum { KINDS = FOLLOW_TOUCH + 1, SERIES = 1 + 2 * FOLLOW_PLOTS_BRANCHES + KINDS };

static const struct {
    const char *name;
    Symbol symbol;
    Role role;
} signs[KINDS] = {[FOLLOW_FOLD] = {"fold", SYMBOL_DISC, ROLE_IMPACT},
                  [FOLLOW_FLIP] = {"flip", SYMBOL_BOX, ROLE_IMPACT},
                  [FOLLOW_PITCHFORK] = {"pitchfork", SYMBOL_DIAMOND, ROLE_LOCUS},
                  [FOLLOW_NEIMARK] = {"Neimark-Sacker", SYMBOL_TRIANGLE, ROLE_IMPACT},
                  [FOLLOW_TOUCH] = {"touching", SYMBOL_BOX, ROLE_DIM_TEXT}};

/* Adds the parts of a branch that are stable, or those that are not. A located point belongs to both. */
static void add_line(FollowPlot *to, const FollowBranch *branch, bool stable, bool main, double factor) {
    double *x = arena_allocate(&to->arena, (branch->count + 1) * sizeof *x);
    double *y = arena_allocate(&to->arena, (branch->count + 1) * sizeof *y);
    size_t shown = 0;
    for (size_t i = 0; i < branch->count; i++) {
        const FollowPoint *point = &branch->points[i];
        bool in = point->kind != FOLLOW_STEP || point->stable == stable;
        x[i] = factor * point->value;
        y[i] = in ? point->peak : (double)NAN;
        shown += point->kind == FOLLOW_STEP && in;
    }
    if (!shown)
        return;
    const char *words = !main ? "an orbit that begins there" : stable ? "stable" : "unstable";
    for (size_t i = 0; i < to->plot.series_count && words; i++)
        if (to->plot.series[i].name && strcmp(to->plot.series[i].name, words) == 0)
            words = NULL;
    words = main || stable ? words : NULL;
    to->plot.series[to->plot.series_count++] = (PlotSeries){.name = words,
                                                            .x = x,
                                                            .y = y,
                                                            .count = branch->count,
                                                            .role = main ? ROLE_LOCUS : ROLE_GHOST,
                                                            .style = stable ? LINE_SOLID : LINE_DASHED,
                                                            .width = LINE};
}

static void add_signs(FollowPlot *to, const FollowBranch *branches, size_t count, FollowKind kind, double factor) {
    size_t all = 0, found = 0;
    for (size_t b = 0; b < count; b++)
        all += branches[b].count;
    double *x = arena_allocate(&to->arena, (all + 1) * sizeof *x),
           *y = arena_allocate(&to->arena, (all + 1) * sizeof *y);
    for (size_t b = 0; b < count; b++)
        for (size_t i = 0; i < branches[b].count; i++)
            if (branches[b].points[i].kind == kind) {
                x[found] = factor * branches[b].points[i].value;
                y[found++] = branches[b].points[i].peak;
            }
    if (found)
        to->plot.series[to->plot.series_count++] = (PlotSeries){.name = signs[kind].name,
                                                                .x = x,
                                                                .y = y,
                                                                .count = found,
                                                                .role = signs[kind].role,
                                                                .symbol = signs[kind].symbol,
                                                                .size = kind == FOLLOW_TOUCH ? SMALL : SIGN,
                                                                .open = kind == FOLLOW_TOUCH};
}

/* Scales the dots, which lie below the lines. */
static void add_dots(FollowPlot *to, const FollowDots *dots, double factor) {
    double *x = arena_allocate(&to->arena, (dots->count + 1) * sizeof *x);
    for (size_t i = 0; i < dots->count; i++)
        x[i] = factor * dots->value[i];
    if (dots->count)
        to->plot.series[to->plot.series_count++] = (PlotSeries){.name = "simulated from rest",
                                                                .x = x,
                                                                .y = dots->peak,
                                                                .count = dots->count,
                                                                .role = ROLE_DIM_TEXT,
                                                                .symbol = SYMBOL_DISC,
                                                                .size = DOT,
                                                                .veil = VEIL};
}

FollowPlot follow_plots_make(const FollowBranch *branches, size_t count, PlotAxis axis, double factor,
                             const FollowDots *dots) {
    FollowPlot made = {
        .plot = {.title = "An orbit that is followed", .x = axis, .y = {.title = "largest force", .unit = "N"}}};
    made.plot.series = arena_allocate(&made.arena, SERIES * sizeof *made.plot.series);
    add_dots(&made, dots, factor);
    for (size_t b = count; b-- > 0;) {
        add_line(&made, &branches[b], false, b == 0, factor);
        add_line(&made, &branches[b], true, b == 0, factor);
    }
    for (FollowKind kind = FOLLOW_TOUCH; kind > FOLLOW_STEP; kind--)
        add_signs(&made, branches, count, kind, factor);
    return made;
}

void follow_plots_add_curves(Plot *plot, const FollowCurve *curves, size_t count, double x_factor, double y_factor,
                             Arena *arena) {
    static const struct {
        const char *name;
        LineStyle style;
        Role role;
    } looks[KINDS] = {[FOLLOW_FOLD] = {"fold", LINE_SOLID, ROLE_TEXT},
                      [FOLLOW_FLIP] = {"flip", LINE_DASHED, ROLE_TEXT},
                      [FOLLOW_PITCHFORK] = {"pitchfork", LINE_DASH_DOT, ROLE_LOCUS},
                      [FOLLOW_NEIMARK] = {"Neimark-Sacker", LINE_SOLID, ROLE_IMPACT},
                      [FOLLOW_TOUCH] = {"end of the motion without contact", LINE_DOTTED, ROLE_TEXT}};
    bool named[KINDS] = {false};
    for (size_t c = 0; c < count && c < FOLLOW_PLOTS_CURVES; c++) {
        const FollowCurve *curve = &curves[c];
        double *x = arena_allocate(arena, curve->count * sizeof *x),
               *y = arena_allocate(arena, curve->count * sizeof *y);
        for (size_t i = 0; i < curve->count; i++) {
            x[i] = x_factor * curve->value[i];
            y[i] = y_factor * curve->other[i];
        }
        plot->series[plot->series_count++] = (PlotSeries){.name = named[curve->kind] ? NULL : looks[curve->kind].name,
                                                          .x = x,
                                                          .y = y,
                                                          .count = curve->count,
                                                          .role = looks[curve->kind].role,
                                                          .style = looks[curve->kind].style,
                                                          .width = LINE,
                                                          .ground = plot->raster ? GROUND : 0};
        named[curve->kind] = true;
    }
}

FollowPlot follow_plots_make_curves(const FollowCurve *curves, size_t count, PlotAxis x, double x_factor, PlotAxis y,
                                    double y_factor) {
    FollowPlot made = {.plot = {.title = "Where the orbit changes its stability", .x = x, .y = y}};
    made.plot.series = arena_allocate(&made.arena, FOLLOW_PLOTS_CURVES * sizeof *made.plot.series);
    follow_plots_add_curves(&made.plot, curves, count, x_factor, y_factor, &made.arena);
    return made;
}

void follow_plots_free(FollowPlot *plot) {
    arena_clear(&plot->arena);
}
