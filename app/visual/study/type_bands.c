#include "visual/study/type_bands.h"

#include <math.h>

#define SHARE 0.045 /* of the largest value of a plot */

static const struct {
    const char *name;
    Role role;
} looks[TYPE_BANDS] = {{"type I", ROLE_TYPE_FIRST}, {"type II", ROLE_TYPE_SECOND}, {"type III", ROLE_TYPE_THIRD}};

/* Keeps a value on the axis, if that has ends. */
static double within(const PlotAxis *axis, double value) {
    return axis->low < axis->high ? fmax(axis->low, fmin(axis->high, value)) : value;
}

void type_bands_add(Plot *plot, const double *values, const double *types, size_t count, double step, double height,
                    Arena *arena) {
    for (int type = 1; type <= TYPE_BANDS; type++) {
        size_t room = 3 * count + 1, points = 0;
        double *x = arena_allocate(arena, room * sizeof *x), *low = arena_allocate(arena, room * sizeof *low),
               *high = arena_allocate(arena, room * sizeof *high);
        for (size_t i = 0; i < count; i++) {
            if (types[i] != type)
                continue;
            for (int end = 0; end < 2; end++) {
                x[points] = within(&plot->x, values[i] + (end ? step : -step) / 2);
                low[points] = 0;
                high[points++] = height * type / TYPE_BANDS;
            }
            x[points] = low[points] = high[points] = (double)NAN;
            points++;
        }
        if (points)
            plot->areas[plot->area_count++] = (PlotArea){.name = looks[type - 1].name,
                                                         .x = x,
                                                         .low = low,
                                                         .high = high,
                                                         .count = points,
                                                         .role = looks[type - 1].role};
    }
}

double type_bands_height(const Plot *plot) {
    double most = 0;
    for (size_t s = 0; s < plot->series_count; s++)
        for (size_t i = 0; i < plot->series[s].count; i++)
            most = fmax(most, plot_value(&plot->series[s], i).y);
    return SHARE * most;
}
