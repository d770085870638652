/* Elementary functions of real numbers whose bits are the same on every processor and in every build: each is a fixed
 * sequence of additions, multiplications, divisions and square roots, which IEEE 754 rounds correctly, without fused
 * operations. The C library picks code of other last bits by processor, so the engine uses only what is exact of it
 * (sqrt, floor, fabs, remainder, frexp and such). Errors are below 1 unit in the last place over the whole range;
 * special values are those of C's Annex F. Angles are in radians. Rounding has to be to nearest. */
#pragma once

typedef struct SineCosine {
    double sine, cosine;
} SineCosine;

/* Of any finite angle; of an infinite one: NaN. */
SineCosine real_sincos(double angle);
double real_sin(double angle);
double real_cos(double angle);

/* The angle of the point (x, y), in [-pi, pi]; of (0, 0) as signs say. */
double real_atan2(double y, double x);
double real_atan(double x);
/* Outside [-1, 1]: NaN. */
double real_asin(double x);
double real_acos(double x);

/* sqrt(x^2 + y^2), which overflows only if the result does. */
double real_hypot(double x, double y);

double real_exp(double x);
/* Of 0: -infinity; below: NaN. */
double real_log(double x);
/* log(1 + x), to full precision near 0. */
double real_log1p(double x);

/* 10^exponent, the nearest number there is, of an exponent from -22 to 22. */
double real_power_of_ten(int exponent);

/* fmin and fmax without their care for NaN, which costs a call. */
static inline double real_min(double a, double b) {
    return a < b ? a : b;
}

static inline double real_max(double a, double b) {
    return a > b ? a : b;
}

static inline double real_clamp(double value, double low, double high) {
    return value < low ? low : value > high ? high : value;
}
