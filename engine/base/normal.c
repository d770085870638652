#include "base/normal.h"

#include <math.h>

#include "base/real.h"

static double ratio(const double *above, const double *below, double x) {
    double a = above[0], b = below[0];
    for (int i = 1; i < 6; i++)
        a = a * x + above[i];
    for (int i = 1; i < 6; i++)
        b = b * x + below[i];
    return a / b;
}

double normal_quantile(double share) {
    static const double middle[6] = {-3.969683028665376e+01, 2.209460984245205e+02,  -2.759285104469687e+02,
                                     1.383577518672690e+02,  -3.066479806614716e+01, 2.506628277459239e+00};
    static const double under[6] = {-5.447609879822406e+01, 1.615858368580409e+02,  -1.556989798598866e+02,
                                    6.680131188771972e+01,  -1.328068155288572e+01, 1};
    static const double tail[6] = {-7.784894002430293e-03, -3.223964580411365e-01, -2.400758277161838e+00,
                                   -2.549732539343734e+00, 4.374664141464968e+00,  2.938163982698783e+00};
    static const double below[6] = {
        0, 7.784695709041462e-03, 3.224671290700398e-01, 2.445134137142996e+00, 3.754408661907416e+00, 1};
    const double edge = 0.02425;
    if (share < edge)
        return ratio(tail, below, sqrt(-2 * real_log(share)));
    if (share > 1 - edge)
        return -ratio(tail, below, sqrt(-2 * real_log1p(-share)));
    double off = share - 0.5, square = off * off;
    return off * ratio(middle, under, square);
}
