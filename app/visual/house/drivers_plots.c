#include "visual/house/drivers_plots.h"

#include <math.h>
#include <stdlib.h>

#include "plan/observed_times.h"
#include "visual/house/drivers_band.h"

#define BEYOND 1.08 /* 1: the edges of the fan lie within the frame, not on it */

static int by_value(const void *a, const void *b) {
    double one = *(const double *)a, other = *(const double *)b;
    return (one > other) - (one < other);
}

static void add_guide(Plot *plot, PlotGuide guide) {
    guide.upright = true;
    plot->guides[plot->guide_count++] = guide;
}

static bool is_alone(const House *house, size_t person) {
    size_t others = 0;
    for (size_t i = 0; i < house->person_count; i++)
        others += house->people[i].route == house->people[person].route;
    return others == 1;
}

static void add_measured(Plot *plot, const House *house, size_t person) {
    const PlanRoute *route = house->people[person].route;
    ObservedTimes observed = route ? observed_times_of(&route->observed) : (ObservedTimes){.runs = 0};
    if (!observed.runs || !is_alone(house, person))
        return;
    double mean = observed.mean, deviation = observed.runs > 1 ? observed.deviation : 0;
    if (deviation > 0)
        add_guide(plot, (PlotGuide){.band = true,
                                    .at = mean - deviation,
                                    .to = mean + deviation,
                                    .name = "measured (a) +- (b)",
                                    .role = ROLE_GRID});
    add_guide(plot, (PlotGuide){.at = mean, .name = "measured (a)", .role = ROLE_TEXT, .style = LINE_DASHED});
}

static void make_times(DriversPlot *of, const House *house, const Observation *nominal, const Drivers *drivers,
                       size_t person) {
    Plot *plot = &of->plot;
    size_t out = 0, all = 0;
    of->numbers = memory_zeroed(2 * drivers->count, sizeof *of->numbers);
    double *times = of->numbers, *shares = times + drivers->count;
    for (size_t k = 0; k < drivers->count; k++) {
        const DriverRun *run = &drivers->runs[k * drivers->person_count + person];
        all += run->varies;
        if (run->varies && run->completed)
            times[out++] = run->time;
    }
    qsort(times, out, sizeof *times, by_value);
    for (size_t k = 0; k < out; k++)
        shares[k] = 100 * (double)(k + 1) / (double)all;
    plot->x = (PlotAxis){.title = "time", .unit = "s"};
    plot->y = (PlotAxis){.title = "drivers who are out", .unit = "%", .low = 0, .high = 100};
    plot->series = arena_allocate(&of->arena, sizeof *plot->series);
    plot->series[plot->series_count++] =
        (PlotSeries){.x = times, .y = shares, .count = out, .role = ROLE_LOCUS, .symbol = SYMBOL_DISC, .size = 6};
    plot->guides = arena_allocate(&of->arena, 3 * sizeof *plot->guides);
    add_measured(plot, house, person);
    if (nominal->people[person].completed)
        add_guide(plot, (PlotGuide){.at = nominal->people[person].time, .name = "nominal driver", .role = ROLE_LOCUS});
}

static void make_speeds(DriversPlot *of, const Observation *nominal, const Drivers *drivers, size_t person) {
    Plot *plot = &of->plot;
    DriversBand band = drivers_band_make(drivers, &nominal->trace, person);
    enum { COLUMNS = 6 };
    of->numbers = memory_zeroed(COLUMNS * band.count, sizeof *of->numbers);
    double *column[COLUMNS];
    for (int c = 0; c < COLUMNS; c++)
        column[c] = of->numbers + (size_t)c * band.count;
    for (size_t s = 0; s < band.count; s++) {
        const BandStation *station = &band.stations[s];
        const double values[COLUMNS] = {station->way,       station->slow, station->speeds[0],
                                        station->speeds[1], station->fast, station->speed};
        for (int c = 0; c < COLUMNS; c++)
            column[c][s] = station->drivers >= BAND_LEAST || c == 0 || c == COLUMNS - 1 ? values[c] : (double)NAN;
    }
    plot->x = (PlotAxis){.title = "way", .unit = "m"};
    double low = 0, high = 0;
    for (size_t s = 0; s < band.count; s++)
        for (int c = 1; c < COLUMNS; c++) {
            low = isfinite(column[c][s]) ? fmin(low, column[c][s]) : low;
            high = isfinite(column[c][s]) ? fmax(high, column[c][s]) : high;
        }
    plot->y = (PlotAxis){.title = "speed", .unit = "m/s", .low = BEYOND * low, .high = BEYOND * high};
    plot->areas = arena_allocate(&of->arena, 2 * sizeof *plot->areas);
    plot->areas[plot->area_count++] = (PlotArea){"5 to 95 %", column[0], column[1], column[4], band.count, ROLE_GRID};
    plot->areas[plot->area_count++] = (PlotArea){"25 to 75 %", column[0], column[2], column[3], band.count, ROLE_BAND};
    plot->series = arena_allocate(&of->arena, sizeof *plot->series);
    plot->series[plot->series_count++] = (PlotSeries){
        .name = "nominal", .x = column[0], .y = column[5], .count = band.count, .role = ROLE_LOCUS, .width = 1.6};
    drivers_band_free(&band);
}

DriversPlot drivers_plot_make(DriversPlotKind kind, const House *house, const Observation *nominal,
                              const Drivers *drivers, size_t person) {
    DriversPlot of = {0};
    if (kind == DRIVERS_PLOT_TIMES)
        make_times(&of, house, nominal, drivers, person);
    else
        make_speeds(&of, nominal, drivers, person);
    return of;
}

void drivers_plot_free(DriversPlot *plot) {
    memory_free(plot->numbers);
    arena_clear(&plot->arena);
    *plot = (DriversPlot){0};
}
