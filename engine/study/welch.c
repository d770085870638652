#include "study/welch.h"

#include <math.h>
#include <stdbool.h>

#include "base/real.h"

/* Returns ln of the gamma function, x > 0: Stirling's series after a shift, good to 1e-12. */
static double log_gamma(double x) {
    double shift = 0;
    for (; x < 12; x++)
        shift += real_log(x);
    double z = 1 / (x * x);
    double series = (1.0 / 12 - z * (1.0 / 360 - z * (1.0 / 1260 - z / 1680))) / x;
    return (x - 0.5) * real_log(x) - x + 0.5 * real_log(2 * M_PI) + series - shift;
}

/* Returns the continued fraction of the incomplete beta function, by the method of Lentz. */
static double beta_fraction(double a, double b, double x) {
    const double tiny = 1e-300;
    double c = 1, d = 1 - (a + b) * x / (a + 1);
    d = 1 / (fabs(d) < tiny ? tiny : d);
    double result = d;
    for (int m = 1; m <= 300; m++) {
        double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        const double terms[2] = {even, odd};
        double factor = 1;
        for (int k = 0; k < 2; k++) {
            d = 1 + terms[k] * d;
            c = 1 + terms[k] / c;
            d = 1 / (fabs(d) < tiny ? tiny : d);
            c = fabs(c) < tiny ? tiny : c;
            factor = d * c;
            result *= factor;
        }
        if (fabs(factor - 1) < 1e-14)
            break;
    }
    return result;
}

/* Returns the regularised incomplete beta function. */
static double beta_share(double a, double b, double x) {
    if (x <= 0 || x >= 1)
        return x <= 0 ? 0 : 1;
    double front = real_exp(log_gamma(a + b) - log_gamma(a) - log_gamma(b) + a * real_log(x) + b * real_log(1 - x));
    bool swapped = x > (a + 1) / (a + b + 2);
    return swapped ? 1 - front * beta_fraction(b, a, 1 - x) / b : front * beta_fraction(a, b, x) / a;
}

/* Returns the probability that |t| is at least `t`. */
static double both_tails(double t, double degrees) {
    return beta_share(degrees / 2, 0.5, degrees / (degrees + t * t));
}

double welch_student(double p, double degrees) {
    double tails = 2 * fmin(p, 1 - p), low = 0, high = 1;
    while (high < 1e12 && both_tails(high, degrees) > tails)
        high *= 2;
    for (int step = 0; step < 100 && high - low > 1e-10 * high; step++) {
        double middle = (low + high) / 2;
        if (both_tails(middle, degrees) > tails)
            low = middle;
        else
            high = middle;
    }
    return p < 0.5 ? -(low + high) / 2 : (low + high) / 2;
}

Welch welch_compare(const WelchSample *measured, const WelchSample *simulated, double within) {
    Welch welch = {.verdict = WELCH_TOO_FEW, .low = NAN, .high = NAN, .degrees = NAN, .t = NAN};
    welch.difference = simulated->mean - measured->mean;
    if (measured->count < 2 || simulated->count < 2)
        return welch;
    double n = (double)measured->count, many = (double)simulated->count;
    double a = measured->deviation * measured->deviation / n, b = simulated->deviation * simulated->deviation / many;
    double error = sqrt(a + b);
    if (!(error > 0))
        return welch;
    welch.degrees = (a + b) * (a + b) / (a * a / (n - 1) + b * b / (many - 1));
    welch.t = welch.difference / error;
    double wide = welch_student(0.975, welch.degrees) * error, narrow = welch_student(0.95, welch.degrees) * error;
    welch.low = welch.difference - wide;
    welch.high = welch.difference + wide;
    bool agrees = fabs(welch.difference) + narrow <= within * measured->mean;
    welch.verdict = agrees ? WELCH_AGREES : welch.low > 0 || welch.high < 0 ? WELCH_DIFFERS : WELCH_CANNOT_TELL;
    return welch;
}

/* With F = x below / ((1 - x) above), x has the beta distribution. */
double welch_fisher(double p, double above, double below) {
    double low = 0, high = 1;
    for (int step = 0; step < 200 && high - low > 1e-16; step++) {
        double middle = (low + high) / 2;
        if (beta_share(above / 2, below / 2, middle) < p)
            low = middle;
        else
            high = middle;
    }
    double x = (low + high) / 2;
    return x * below / ((1 - x) * above);
}

WelchScatter welch_scatter(const WelchSample *measured, const WelchSample *simulated) {
    WelchScatter scatter = {NAN, NAN, NAN};
    if (measured->count < 2 || simulated->count < 2 || !(measured->deviation > 0) || !(simulated->deviation > 0))
        return scatter;
    double n = (double)measured->count - 1, many = (double)simulated->count - 1;
    scatter.ratio = simulated->deviation / measured->deviation;
    scatter.low = scatter.ratio / sqrt(welch_fisher(0.975, many, n));
    scatter.high = scatter.ratio / sqrt(welch_fisher(0.025, many, n));
    return scatter;
}
