#include "accuracy.h"

#include <float.h>
#include <math.h>

#include "base/real.h"

/* Marsaglia's xorshift. */
static uint64_t bits(uint64_t *state) {
    uint64_t s = *state * 0x9e3779b97f4a7c15u + 88172645463325252u;
    s ^= s << 13;
    s ^= s >> 7;
    s ^= s << 17;
    *state += 1;
    return s * 0xd1342543de82ef95u ^ s >> 32;
}

/* Between 0 and 1. */
static double part(uint64_t *state) {
    return (double)(bits(state) >> 11) * 0x1p-53;
}

double accuracy_spread(uint64_t *state, double low, double high) {
    double value = ldexp(1 + part(state), (int)(low + (high - low) * part(state)));
    return bits(state) >> 40 & 1 ? -value : value;
}

/* Arguments ------------------------------------------------------------------------------------------------------- */

static void turn(uint64_t *s, double *x, double *y) {
    *x = 20 * part(s) - 10;
    *y = 0;
}

/* Next to a multiple of an eighth of a turn. */
static void eighth(uint64_t *s, double *x, double *y) {
    *x = (double)((int)(bits(s) % 64) - 32) * M_PI_4 + accuracy_spread(s, -60, -20);
    *y = 0;
}

/* The numbers next to multiples of a quarter, where the sine or cosine is smallest. */
static void quarter(uint64_t *s, double *x, double *y) {
    *x = rint(4e6 * part(s)) * M_PI_2;
    *y = 0;
}

static void middling(uint64_t *s, double *x, double *y) {
    *x = accuracy_spread(s, -40, 21);
    *y = 0;
}

static void huge(uint64_t *s, double *x, double *y) {
    *x = accuracy_spread(s, 20, 1023);
    *y = 0;
}

static void square(uint64_t *s, double *x, double *y) {
    *x = 2 * part(s) - 1;
    *y = 2 * part(s) - 1;
}

/* Two of about the same size, of any size. */
static void two_like(uint64_t *s, double *x, double *y) {
    *x = accuracy_spread(s, -1070, 960);
    *y = ldexp(*x, (int)(bits(s) % 120) - 60) * (1 + part(s));
}

static void two_unlike(uint64_t *s, double *x, double *y) {
    *x = accuracy_spread(s, -1070, 1022);
    *y = accuracy_spread(s, -1070, 1022);
}

static void edge(uint64_t *s, double *x, double *y) {
    double near = 1 - fabs(accuracy_spread(s, -53, -1));
    *x = bits(s) >> 40 & 1 ? near : -near;
    *y = 0;
}

static void small(uint64_t *s, double *x, double *y) {
    *x = accuracy_spread(s, -70, -1);
    *y = 0;
}

static void growth(uint64_t *s, double *x, double *y) {
    *x = 1455 * part(s) - 745;
    *y = 0;
}

static void next_to_one(uint64_t *s, double *x, double *y) {
    *x = 1 + accuracy_spread(s, -52, -1);
    *y = 0;
}

static void positive(uint64_t *s, double *x, double *y) {
    *x = fabs(accuracy_spread(s, -1073, 1023));
    *y = 0;
}

/* Functions ------------------------------------------------------------------------------------------------------- */

#define ONE(name_)                                                                                                     \
    static double own_##name_(double x, double y) {                                                                    \
        (void)y;                                                                                                       \
        return real_##name_(x);                                                                                        \
    }                                                                                                                  \
    static long double reference_##name_(double x, double y) {                                                         \
        (void)y;                                                                                                       \
        return name_##l(x);                                                                                            \
    }                                                                                                                  \
    static double library_##name_(double x, double y) {                                                                \
        (void)y;                                                                                                       \
        return name_(x);                                                                                               \
    }

#define TWO(name_)                                                                                                     \
    static double own_##name_(double x, double y) {                                                                    \
        return real_##name_(y, x);                                                                                     \
    }                                                                                                                  \
    static long double reference_##name_(double x, double y) {                                                         \
        return name_##l(y, x);                                                                                         \
    }                                                                                                                  \
    static double library_##name_(double x, double y) {                                                                \
        return name_(y, x);                                                                                            \
    }

ONE(sin)
ONE(cos)
ONE(atan)
ONE(asin)
ONE(acos)
ONE(exp)
ONE(log)
ONE(log1p)
TWO(atan2)
TWO(hypot)

#define ROW(name_, draw_, of_)                                                                                         \
    { #name_ " " of_, draw_, own_##name_, reference_##name_, library_##name_ }

const AccuracyCase accuracy_list[] = {
    ROW(sin, turn, "within three turns"),
    ROW(sin, eighth, "next to eighths of a turn"),
    ROW(sin, quarter, "of quarters of a turn"),
    ROW(sin, middling, "up to 2^21"),
    ROW(sin, huge, "beyond 2^20"),
    ROW(cos, turn, "within three turns"),
    ROW(cos, eighth, "next to eighths of a turn"),
    ROW(cos, quarter, "of quarters of a turn"),
    ROW(cos, middling, "up to 2^21"),
    ROW(cos, huge, "beyond 2^20"),
    ROW(atan2, square, "of a square"),
    ROW(atan2, two_like, "of like numbers"),
    ROW(atan2, two_unlike, "of all numbers"),
    ROW(atan, middling, "up to 2^21"),
    ROW(asin, square, "evenly"),
    ROW(asin, edge, "next to 1"),
    ROW(asin, small, "next to 0"),
    ROW(acos, square, "evenly"),
    ROW(acos, edge, "next to 1"),
    ROW(hypot, square, "of a square"),
    ROW(hypot, two_like, "of like numbers"),
    ROW(exp, square, "within 1"),
    ROW(exp, growth, "from 0 to infinity"),
    ROW(exp, small, "next to 0"),
    ROW(log, next_to_one, "next to 1"),
    ROW(log, positive, "of all numbers"),
    ROW(log1p, small, "next to 0"),
    ROW(log1p, edge, "next to -1 and 1"),
    ROW(log1p, positive, "of all numbers"),
};
const size_t accuracy_count = sizeof accuracy_list / sizeof *accuracy_list;

/* In units in the last place of a double next to the reference. */
static double error_of(double got, long double reference) {
    int exponent;
    if ((double)reference == got && isinf(got))
        return 0;
    frexpl(reference, &exponent);
    if (exponent < DBL_MIN_EXP)
        exponent = DBL_MIN_EXP;
    return (double)(fabsl(reference - (long double)got) * ldexpl(1, DBL_MANT_DIG - exponent));
}

Accuracy accuracy_measure(const AccuracyCase *what, long arguments) {
    Accuracy found = {0, 0, 0};
    uint64_t state = 1;
    for (long i = 0; i < arguments; i++) {
        double x, y;
        what->draw(&state, &x, &y);
        double error = error_of(what->own(x, y), what->reference(x, y));
        if (!(error <= found.worst))
            found = (Accuracy){error, x, y};
        if (isnan(error))
            break;
    }
    return found;
}
