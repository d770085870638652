#include "visual/study/measured_marks.h"

#define SIZE 11.0 /* design points, across a mark */

bool measured_marks_add(Plot *plot, const Measured *measured, MeasuredAxis x, MeasuredAxis y, const char *name,
                        size_t shape, Arena *arena) {
    static const Symbol symbols[] = {SYMBOL_DISC, SYMBOL_BOX, SYMBOL_TRIANGLE, SYMBOL_DIAMOND};
    const double *across = measured_find(measured, x.name), *upright = measured_find(measured, y.name);
    if (!across || !upright)
        return false;
    double *values = arena_allocate(arena, 2 * measured->count * sizeof *values);
    for (size_t i = 0; i < measured->count; i++) {
        values[2 * i] = across[i] * x.factor;
        values[2 * i + 1] = upright[i] * y.factor;
    }
    plot->series[plot->series_count++] = (PlotSeries){.name = name,
                                                      .x = values,
                                                      .y = values + 1,
                                                      .count = measured->count,
                                                      .stride = 2,
                                                      .role = ROLE_IMPACT,
                                                      .symbol = symbols[shape % (sizeof symbols / sizeof *symbols)],
                                                      .size = SIZE,
                                                      .open = true};
    return true;
}
