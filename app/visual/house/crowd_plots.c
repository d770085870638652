#include "visual/house/crowd_plots.h"

#include <math.h>
#include <stdlib.h>

#include "base/text.h"
#include "result/census.h"
#include "result/headline.h"
#include "visual/house/people_scene.h"

#define LINE_WIDTH 3.0 /* design points */
#define THIN_WIDTH 1.6

#define WINDOW 10.0      /* s, over which the flow is a mean */
#define SAMPLES 400.0    /* of a curve, at most, besides its steps */
#define LEAST_STEP 0.5   /* s, between two of them */
#define FLOW_OF_EXIT 1.3 /* 1/(m s), specific flow of a crowd through an exit (Fruin; SFPE handbook: 1.32) */

enum { GUIDES = 3 };

static int by_size(const void *a, const void *b) {
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

/* Lists when people left, s, in rising order: by one exit, or by any (SIZE_MAX). Returns their number. */
static size_t list_times(const Observation *observation, size_t exit, double *times) {
    size_t count = 0;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        if (person->took_part && person->completed && (exit == SIZE_MAX || person->exit == exit))
            times[count++] = person->time;
    }
    if (count > 1)
        qsort(times, count, sizeof *times, by_size);
    return count;
}

static size_t taking_part(const Observation *observation) {
    size_t count = 0;
    for (size_t i = 0; i < observation->person_count; i++)
        count += observation->people[i].took_part;
    return count;
}

/* People out ------------------------------------------------------------------------------------------------------- */

static double end_of(const Observation *observation, const double *times, size_t count) {
    return fmax(observation->time, count ? times[count - 1] : 0);
}

/* Returns the time between two samples, s. */
static double sample_of(double end) {
    return fmax(LEAST_STEP, end / SAMPLES);
}

/* Adds the steps of people leaving, up to the end of the run. Samples between them let the line go on while nobody
 * leaves. */
static PlotSeries *add_steps(Plot *plot, const Observation *observation, const double *times, size_t count,
                             Arena *arena) {
    double end = end_of(observation, times, count), sample = sample_of(end);
    size_t most = 2 * count + (size_t)(end / sample) + 2, points = 0;
    double *x = arena_allocate(arena, most * sizeof *x), *y = arena_allocate(arena, most * sizeof *y);
    x[points] = 0;
    y[points++] = 0;
    for (size_t i = 0; i <= count; i++) {
        double next = i < count ? times[i] : end;
        for (; x[points - 1] + sample < next; points++) {
            x[points] = x[points - 1] + sample;
            y[points] = (double)i;
        }
        for (size_t step = 0; step < (i < count ? 2 : 1); step++) {
            x[points] = next;
            y[points++] = (double)(i + step);
        }
    }
    PlotSeries *series = &plot->series[plot->series_count++];
    *series = (PlotSeries){.x = x, .y = y, .count = points, .stride = 1, .role = ROLE_CHAIR, .width = LINE_WIDTH};
    return series;
}

/* Marks when half, 95 of 100 and all people are out. */
static void add_marks(Plot *plot, const double *times, size_t count, size_t people, Arena *arena) {
    static const struct {
        double part;
        const char *name;
    } marks[GUIDES] = {{0.5, "half"}, {0.95, "95 %"}, {1, "all"}};
    for (int m = 0; m < GUIDES && people > CENSUS_ROWS; m++) {
        size_t needed = (size_t)ceil(marks[m].part * (double)people - 1e-9);
        bool is_all = marks[m].part < 1 && needed == people;
        if (count >= needed && !is_all)
            plot->guides[plot->guide_count++] = (PlotGuide){
                .upright = true,
                .at = times[needed - 1],
                .name = text_in_arena(arena, "%s %s", marks[m].name, headline_duration(times[needed - 1], arena)),
                .role = ROLE_DIM_TEXT,
                .style = LINE_DASHED};
    }
}

/* Marks when exits close, up to the end of the run. */
static void add_closings(Plot *plot, const House *house, double end, Arena *arena) {
    for (size_t e = 0; e < house->plan.exit_count; e++)
        if (house->plan.exits[e].closes < end)
            plot->guides[plot->guide_count++] =
                (PlotGuide){.upright = true,
                            .at = house->plan.exits[e].closes,
                            .name = text_in_arena(arena, "%s closes", house->plan.exits[e].id),
                            .role = ROLE_ERROR,
                            .style = LINE_DASHED};
}

void crowd_plots_out(Plot *plot, const House *house, const Observation *observation, const Observation *before,
                     const char *name, Arena *arena) {
    size_t people = taking_part(observation), most = observation->person_count + (before ? before->person_count : 0);
    double *times = memory_zeroed(most + 1, sizeof *times);
    plot->x = (PlotAxis){.title = "time", .unit = "s"};
    plot->y = (PlotAxis){.title = "people out", .unit = "1"};
    plot->series = arena_allocate(arena, 2 * sizeof *plot->series);
    plot->guides = arena_allocate(arena, (GUIDES + house->plan.exit_count) * sizeof *plot->guides);
    if (before) {
        PlotSeries *ghost = add_steps(plot, before, times, list_times(before, SIZE_MAX, times), arena);
        ghost->name = name;
        ghost->role = ROLE_GHOST;
        ghost->style = LINE_DASHED;
        ghost->width = THIN_WIDTH;
    }
    size_t count = list_times(observation, SIZE_MAX, times);
    add_steps(plot, observation, times, count, arena)->heading = "people out";
    add_marks(plot, times, count, people, arena);
    add_closings(plot, house, end_of(observation, times, count), arena);
    plot->note = count ? text_in_arena(arena, "of %zu", people) : "nobody is out";
    memory_free(times);
}

/* Flow ------------------------------------------------------------------------------------------------------------- */

/* Adds how many people a second leave by an exit, a mean over the last WINDOW. */
static void add_flow(Plot *plot, const House *house, const Observation *observation, size_t exit, const double *times,
                     size_t count, Arena *arena) {
    double end = end_of(observation, times, count), step = sample_of(end);
    size_t samples = (size_t)(end / step) + 1, low = 0, high = 0;
    double *x = arena_allocate(arena, samples * sizeof *x), *y = arena_allocate(arena, samples * sizeof *y);
    for (size_t i = 0; i < samples; i++) {
        x[i] = (double)i * step;
        while (high < count && times[high] <= x[i])
            high++;
        while (low < high && times[low] <= x[i] - WINDOW)
            low++;
        y[i] = (double)(high - low) / WINDOW;
    }
    LocusLook look = people_scene_nth_look(exit);
    plot->series[plot->series_count++] = (PlotSeries){.name = arena_text(arena, house->plan.exits[exit].id),
                                                      .x = x,
                                                      .y = y,
                                                      .count = samples,
                                                      .stride = 1,
                                                      .role = look.role,
                                                      .style = look.style,
                                                      .width = exit < GUIDES + 1 ? LINE_WIDTH : THIN_WIDTH};
}

/* Adds what a crowd can push through the exits, by their widths, if they are few. */
static void add_capacities(Plot *plot, const Plan *plan, Arena *arena) {
    double widths[GUIDES];
    size_t count = 0;
    for (size_t e = 0; e < plan->exit_count; e++) {
        double width = vec2_distance(plan->exits[e].from, plan->exits[e].to);
        size_t same = 0;
        while (same < count && fabs(widths[same] - width) > 0.005)
            same++;
        if (same == GUIDES)
            return;
        widths[same] = width;
        count = same == count ? count + 1 : count;
    }
    for (size_t i = 0; i < count && i < 2; i++)
        plot->guides[plot->guide_count++] = (PlotGuide){.at = FLOW_OF_EXIT * widths[i],
                                                        .name = text_in_arena(arena, "capacity of %.2f m", widths[i]),
                                                        .listed = true,
                                                        .role = ROLE_DIM_TEXT,
                                                        .style = LINE_DASHED};
}

void crowd_plots_flow(Plot *plot, const House *house, const Observation *observation, Arena *arena) {
    const Plan *plan = &house->plan;
    double *times = memory_zeroed(observation->person_count + 1, sizeof *times);
    size_t out = 0;
    plot->x = (PlotAxis){.title = "time", .unit = "s"};
    plot->y = (PlotAxis){.title = "people out a second", .unit = "1/s"};
    plot->series = arena_allocate(arena, (plan->exit_count + 1) * sizeof *plot->series);
    plot->guides = arena_allocate(arena, GUIDES * sizeof *plot->guides);
    for (size_t e = 0; e < plan->exit_count; e++) {
        size_t count = list_times(observation, e, times);
        out += count;
        add_flow(plot, house, observation, e, times, count, arena);
    }
    if (taking_part(observation) > CENSUS_ROWS)
        add_capacities(plot, plan, arena);
    plot->note = out ? "mean over 10 s" : "nobody is out";
    memory_free(times);
}
