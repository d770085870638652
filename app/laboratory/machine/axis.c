#include "laboratory/machine/axis.h"

#include <math.h>

double machine_axis_round_up(double value) {
    static const double steps[] = {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10};
    if (!(value > 0))
        return 1;
    double power = pow(10, floor(log10(value)));
    size_t i = 0;
    while (i + 1 < sizeof steps / sizeof *steps && steps[i] * power < value)
        i++;
    return steps[i] * power;
}

bool machine_axis_stretch(PlotAxis *axis, double to, bool both) {
    if (to <= axis->high)
        return false;
    axis->high = machine_axis_round_up(to);
    axis->low = both ? -axis->high : 0;
    return true;
}
