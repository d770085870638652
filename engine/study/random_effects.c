#include "study/random_effects.h"

#include <math.h>

#include "base/memory.h"

RandomEffects random_effects_of(const double *values, const size_t *group, size_t count) {
    RandomEffects found = {.within = NAN, .between = NAN};
    double *sums = memory_zeroed(2 * count + 1, sizeof *sums), *sizes = sums + count;
    double all = 0, inside = 0, among = 0, squares = 0, n = (double)count;
    for (size_t i = 0; i < count; i++) {
        sums[group[i]] += values[i];
        sizes[group[i]]++;
        all += values[i] / n;
    }
    for (size_t i = 0; i < count; i++) {
        double off = values[i] - sums[group[i]] / sizes[group[i]];
        inside += off * off;
    }
    for (size_t g = 0; g < count; g++) {
        if (!(sizes[g] > 0))
            continue;
        double off = sums[g] / sizes[g] - all;
        found.groups++;
        among += sizes[g] * off * off;
        squares += sizes[g] * sizes[g];
    }
    memory_free(sums);
    if (count > found.groups) {
        double k = (double)found.groups, mean_inside = inside / (n - k);
        found.within = sqrt(mean_inside);
        if (found.groups > 1)
            found.between = sqrt(fmax(0, (among / (k - 1) - mean_inside) / ((n - squares / n) / (k - 1))));
    }
    return found;
}
