#include "visual/house/shake_plots.h"

#include <math.h>
#include <stdlib.h>

#include "base/order.h"
#include "base/text.h"
#include "experiment/house_experiment.h"
#include "visual/house/people_scene.h"
#include "visual/study/study_axes.h"

#define ALL_WIDTH 3.5 /* design points */
#define ONE_WIDTH 2.0

enum {
    PEOPLE_MOST = 4,     /* parties with a curve of their own */
    STEPS_MOST = 100000, /* shakes that are drawn one by one */
};

/* Returns the end of the time axis, s: a little behind the last evacuation. */
static double end_of(const ShakeFindings *findings) {
    double first = HUGE_VAL, last = -HUGE_VAL;
    for (size_t p = 0; p <= findings->party_count; p++) {
        const Distribution *time = p < findings->party_count ? &findings->parties[p].time : &findings->time;
        first = time->count ? fmin(first, time->least) : first;
        last = time->count ? fmax(last, time->greatest) : last;
    }
    return last + 0.05 * fmax(last - first, 1);
}

/* The shares at STEPS_MOST times between the first and the last. */
static PlotSeries cumulated_at_steps(const ShakeFindings *findings, const Numbers *times, Arena *arena) {
    double first = HUGE_VAL, last = -HUGE_VAL;
    for (size_t i = 0; i < times->count; i++) {
        double time = numbers_at(times, i);
        first = isfinite(time) ? fmin(first, time) : first;
        last = isfinite(time) ? fmax(last, time) : last;
    }
    double *x = arena_allocate(arena, (STEPS_MOST + 2) * sizeof *x),
           *y = arena_allocate(arena, (STEPS_MOST + 2) * sizeof *y);
    double width = (last - first) / STEPS_MOST;
    for (size_t i = 0; i < times->count; i++) {
        double time = numbers_at(times, i);
        if (isfinite(time))
            y[width > 0 ? (size_t)fmin(ceil((time - first) / width), STEPS_MOST) : 0]++;
    }
    for (size_t s = 0; s <= STEPS_MOST; s++) {
        x[s] = first + width * (double)s;
        y[s] += s ? y[s - 1] : 0;
    }
    x[STEPS_MOST + 1] = end_of(findings);
    y[STEPS_MOST + 1] = y[STEPS_MOST];
    for (size_t s = 0; s <= STEPS_MOST + 1; s++)
        y[s] *= 100 / (double)findings->shakes;
    return (PlotSeries){.x = x, .y = y, .count = STEPS_MOST + 2};
}

/* Steps up at each time, and continues to the end. */
static PlotSeries cumulated(const ShakeFindings *findings, size_t observable, Arena *arena) {
    const StudyRuns runs = {findings->study, 0, 0, observable};
    Numbers all = study_axes_runs(&runs);
    if (all.count > STEPS_MOST)
        return cumulated_at_steps(findings, &all, arena);
    double *times = arena_allocate(arena, all.count * sizeof *times);
    size_t count = 0;
    for (size_t i = 0; i < all.count; i++) {
        times[count] = numbers_at(&all, i);
        count += isfinite(times[count]);
    }
    qsort(times, count, sizeof *times, order_rising);
    double *x = arena_allocate(arena, (2 * count + 1) * sizeof *x);
    double *y = arena_allocate(arena, (2 * count + 1) * sizeof *y);
    for (size_t i = 0; i < count; i++) {
        x[2 * i] = x[2 * i + 1] = times[i];
        y[2 * i] = 100 * (double)i / (double)findings->shakes;
        y[2 * i + 1] = 100 * (double)(i + 1) / (double)findings->shakes;
    }
    x[2 * count] = end_of(findings);
    y[2 * count] = 100 * (double)count / (double)findings->shakes;
    return (PlotSeries){.x = x, .y = y, .count = 2 * count + 1};
}

static void add_guide(Plot *plot, double at, const char *name, LineStyle style) {
    plot->guides[plot->guide_count++] =
        (PlotGuide){.upright = true, .at = at, .name = name, .role = ROLE_DIM_TEXT, .style = style};
}

static void add_people(Plot *plot, const ShakeFindings *findings, Arena *arena) {
    for (size_t p = 0; p < findings->party_count && findings->party_count <= PEOPLE_MOST; p++) {
        if (!findings->parties[p].time.count)
            continue;
        LocusLook look = people_scene_nth_look(p);
        PlotSeries *series = &plot->series[plot->series_count++];
        *series = cumulated(findings, findings->parties[p].observable, arena);
        series->name = findings->parties[p].id;
        series->role = look.role;
        series->style = look.style;
        series->width = ONE_WIDTH;
    }
}

bool shake_plots_times(Plot *plot, const ShakeFindings *findings, Arena *arena) {
    const Distribution *time = &findings->time;
    bool several = findings->party_count > 1;
    *plot = (Plot){.x = {.title = "time", .unit = "s"},
                   .y = {.title = "share of shakes", .unit = "%", .low = 0, .high = 100}};
    plot->series = arena_allocate(arena, (PEOPLE_MOST + 1) * sizeof *plot->series);
    plot->guides = arena_allocate(arena, 3 * sizeof *plot->guides);
    plot->title = text_in_arena(arena, "Out within a time, of %zu shakes", findings->shakes);
    if (several)
        add_people(plot, findings, arena);
    if (time->count) {
        PlotSeries *all = &plot->series[plot->series_count++];
        *all = cumulated(findings, HOUSE_TIME, arena);
        all->name = several ? "all people" : NULL;
        all->role = ROLE_WALL;
        all->width = ALL_WIDTH;
        plot->note = text_in_arena(arena, "all people: median %.1f s, quartiles %.1f and %.1f s, 95 %% within %.1f s",
                                   time->median, time->quarters[0], time->quarters[1], time->high);
        add_guide(plot, time->median, "median", LINE_DASHED);
        add_guide(plot, time->high, "95 %", LINE_DOTTED);
    }
    if (findings->calm == SHAKE_CALM_OUT)
        add_guide(plot, findings->calm_time, "without a shake", LINE_SOLID);
    return plot->series_count;
}
