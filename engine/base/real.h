/* Elementary functions of real numbers whose bits are the same on every processor and in every build: each is a
 * fixed sequence of additions, multiplications, divisions and square roots, which IEEE 754 rounds correctly, without
 * fused operations. The C library chooses code by processor, which changes the last bits, so the engine uses only
 * its exact functions (sqrt, floor, fabs, remainder, frexp and similar ones). Errors are below 1 unit in the last
 * place over the whole range; special values are those of C's Annex F. Angles are in radians. The rounding mode must
 * be to nearest. */
#pragma once

typedef struct SineCosine {
    double sine, cosine;
} SineCosine;

/* Return NaN for an infinite angle. */
SineCosine real_sincos(double angle);
double real_sin(double angle);
double real_cos(double angle);

/* Returns the angle of the point (x, y), in [-pi, pi]; the signs decide for (0, 0). */
double real_atan2(double y, double x);
double real_atan(double x);
/* Return NaN outside [-1, 1]. */
double real_asin(double x);
double real_acos(double x);

/* Returns sqrt(x^2 + y^2), which overflows only if the result does. */
double real_hypot(double x, double y);

double real_exp(double x);
/* Returns -infinity for 0 and NaN below 0. */
double real_log(double x);
/* Returns log(1 + x), with full precision near 0. */
double real_log1p(double x);

/* Returns the double nearest to 10^exponent, for an exponent from -22 to 22. */
double real_power_of_ten(int exponent);

/* fmin and fmax without special treatment of NaN, which costs a call. */
static inline double real_min(double a, double b) {
    return a < b ? a : b;
}

static inline double real_max(double a, double b) {
    return a > b ? a : b;
}

static inline double real_clamp(double value, double low, double high) {
    return value < low ? low : value > high ? high : value;
}
