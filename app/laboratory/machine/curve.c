#include "laboratory/machine/curve.h"

#include "base/memory.h"

void machine_curve_add(MachineCurve *curve, double time, double x, double y) {
    size_t at = curve->count++;
    curve->x = memory_reserve(curve->x, &curve->x_capacity, curve->count, sizeof *curve->x);
    curve->y = memory_reserve(curve->y, &curve->y_capacity, curve->count, sizeof *curve->y);
    curve->time = memory_reserve(curve->time, &curve->time_capacity, curve->count, sizeof *curve->time);
    curve->x[at] = x;
    curve->y[at] = y;
    curve->time[at] = time;
}

void machine_curve_clear(MachineCurve *curve) {
    memory_free(curve->x);
    memory_free(curve->y);
    memory_free(curve->time);
    *curve = (MachineCurve){0};
}

size_t machine_curve_count_until(const MachineCurve *curve, double time) {
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

void machine_curve_copy(MachineCurve *to, const MachineCurve *from, double time) {
    size_t count = machine_curve_count_until(from, time);
    machine_curve_reset(to);
    for (size_t i = 0; i < count; i++)
        machine_curve_add(to, from->time[i], from->x[i], from->y[i]);
}
