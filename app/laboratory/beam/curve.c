#include "laboratory/beam/curve.h"

#include "base/memory.h"

void beam_curve_add(BeamCurve *curve, double time, double x, double y) {
    size_t at = curve->count++;
    curve->x = memory_reserve(curve->x, &curve->x_capacity, curve->count, sizeof *curve->x);
    curve->y = memory_reserve(curve->y, &curve->y_capacity, curve->count, sizeof *curve->y);
    curve->time = memory_reserve(curve->time, &curve->time_capacity, curve->count, sizeof *curve->time);
    curve->x[at] = x;
    curve->y[at] = y;
    curve->time[at] = time;
}

void beam_curve_clear(BeamCurve *curve) {
    memory_free(curve->x);
    memory_free(curve->y);
    memory_free(curve->time);
    *curve = (BeamCurve){0};
}

size_t beam_curve_count_until(const BeamCurve *curve, double time) {
    size_t low = 0, high = curve->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (curve->time[middle] <= time)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

void beam_curve_copy(BeamCurve *to, const BeamCurve *from, double time) {
    size_t count = beam_curve_count_until(from, time);
    beam_curve_reset(to);
    for (size_t i = 0; i < count; i++)
        beam_curve_add(to, from->time[i], from->x[i], from->y[i]);
}
