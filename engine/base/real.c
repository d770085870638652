/* Each function is computed in three steps: the argument is reduced exactly to a small one, a polynomial
 * approximates the function there, and the parts are added from the smallest to the largest, so only the last
 * addition's rounding error matters.
 *
 * The rounding error of a number is stored in a second one ("low"): the errors of a sum (Knuth, The Art of Computer
 * Programming 2, 4.2.2) and of a product (Dekker, Numerische Mathematik 18, 1971) are exact doubles.
 *
 * Sine and cosine: x = n pi/2 + y, |y| <= pi/4, by Cody and Waite (Software Manual for the Elementary Functions,
 * 1980): pi/2 is split into parts of 33 bits whose products with n are exact. If |x| is large, or y is small
 * compared with the error of this reduction, the method of Payne and Hanek (SIGNUM Newsletter 18, 1983) applies: x
 * is multiplied only by those bits of 2/pi that do not make whole turns.
 *
 * Angle of a point: with q = smaller / larger and the nearest c = k/16,
 *     atan q = atan c + atan t,  t = (q - c) / (1 + c q),  |t| <= 1/32, or 3/16 where c = 0,
 * then the eighth of a turn in which the point lies is added. asin x is the angle of the point (sqrt(1 - x^2), x).
 *
 * Exponential: x = n ln 2 + r, |r| <= ln 2 / 2, exp x = 2^n exp r. Logarithm: x = 2^k (1 + f), sqrt(1/2) < 1 + f <
 * sqrt 2, and with s = f / (2 + f), log(1 + f) = 2 atanh s = f - (f^2/2 - s (f^2/2 + R)), R = 2 (s^2/3 + s^4/5 +
 * ...).
 *
 * The polynomials minimise the largest relative error (Remez exchange with 70 digits, rounded once); the errors of
 * sine, cosine, arctangent, exponential and R are 2^-58, 2^-64, 2^-58, 2^-64 and 2^-58. */
#include "base/real.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

_Static_assert(FLT_EVAL_METHOD == 0, "results are rounded to double after each operation");

static const double NOT_A_NUMBER = NAN;
static const double PI_2 = 0x1.921fb54442d18p+0, PI_2_LOW = 0x1.1a62633145c07p-54;
/* Adding and subtracting this number rounds to the nearest integer, which is then in the last bits of the sum. */
static const double ROUNDER = 0x1.8p+52;

/* A number and its rounding error. */
typedef struct Pair {
    double high, low;
} Pair;

/* Returns a + b for arguments of any size. */
static inline Pair sum_of(double a, double b) {
    double high = a + b, part = high - a;
    return (Pair){high, (a - (high - part)) + (b - part)};
}

/* Returns a + b for |a| >= |b| or a = 0. */
static inline Pair quick_sum(double a, double b) {
    double high = a + b;
    return (Pair){high, (a - high) + b};
}

/* Returns a number's upper 26 bits; the remainder also has 26. */
static inline double upper_half(double a) {
    double shifted = a * 0x1.0000002p+27;
    return shifted - (shifted - a);
}

static inline Pair product_of(double a, double b) {
    double high = a * b, a1 = upper_half(a), a2 = a - a1, b1 = upper_half(b), b2 = b - b1;
    return (Pair){high, ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2};
}

static inline uint64_t bits_of(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline double of_bits(uint64_t bits) {
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Returns 2^exponent for an exponent from -1022 to 1023. */
static inline double power_of_two(int exponent) {
    return of_bits((uint64_t)(1023 + exponent) << 52);
}

/* Sine and cosine ------------------------------------------------------------------------------------------------- */

/* An angle as a number of quarter turns and a remainder of at most pi/4. */
typedef struct Quarters {
    Pair rest;
    uint64_t count; /* modulo 4 */
} Quarters;

typedef unsigned __int128 Wide;

/* The bits of 2/pi after the binary point, preceded by 64 zero bits. */
static const uint64_t TWO_OVER_PI[22] = {0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041,
                                         0xfe5163abdebbc561, 0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e,
                                         0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b,
                                         0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
                                         0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab,
                                         0xf0cfbc209af4361d, 0xa9e391615ee61b08};
/* pi/2 in units of 2^-127 */
static const uint64_t PI_2_UPPER = 0xc90fdaa22168c234, PI_2_LOWER = 0xc4c6628b80dc1cd1;

/* Returns the 64 bits of 2/pi starting at the bit of weight 2^-first. */
static uint64_t window(int first) {
    int place = first + 63, word = place / 64, shift = place % 64;
    uint64_t upper = TWO_OVER_PI[word];
    return shift ? upper << shift | TWO_OVER_PI[word + 1] >> (64 - shift) : upper;
}

/* Returns 128 of 256 bits, starting at the highest bit that is set, and the number of zero bits before them; `words`
 * begins with the highest word. */
static Wide leading(const uint64_t words[4], int *zeros) {
    int word = 0;
    while (word < 2 && words[word] == 0)
        word++;
    if (words[word] == 0) {
        *zeros = 256;
        return 0;
    }
    int shift = __builtin_clzll(words[word]);
    *zeros = 64 * word + shift;
    Wide both = (Wide)words[word] << 64 | words[word + 1];
    uint64_t below = word + 2 < 4 ? words[word + 2] : 0;
    return shift ? both << shift | below >> (64 - shift) : both;
}

/* Reduces an angle by Payne and Hanek, |x| >= 2^-10. With x = m 2^e, m an integer, the bits of 2/pi of weight 2^(2 -
 * e) and more make whole turns; the 256 bits after them are multiplied by m, modulo 4 quarters: two bits of
 * quarters, 254 after the binary point. */
static __attribute__((noinline)) Quarters reduce_exactly(double x) {
    uint64_t bits = bits_of(x), m = (bits & 0xfffffffffffff) | 0x10000000000000;
    int e = (int)(bits >> 52 & 0x7ff) - 1075;
    uint64_t words[4], carry = 0;
    for (int i = 3; i >= 0; i--) {
        Wide part = (Wide)m * window(e - 1 + 64 * i) + carry;
        words[i] = (uint64_t)part;
        carry = (uint64_t)(part >> 64);
    }
    Quarters quarters = {.count = words[0] >> 62};
    bool above = words[0] >> 61 & 1; /* more than a half: the next quarter is nearer */
    words[0] &= 0x3fffffffffffffff;
    if (above) {
        quarters.count++;
        for (int i = 3, borrow = 1; i >= 0; i--) { /* 1 - fraction: all bits inverted, and 1 added */
            words[i] = ~words[i] + (uint64_t)borrow;
            borrow = borrow && words[i] == 0;
        }
        words[0] &= 0x3fffffffffffffff;
    }
    int zeros;
    Wide fraction = leading(words, &zeros); /* in units of 2^(2 - zeros - 128) quarters */
    uint64_t upper = (uint64_t)(fraction >> 64), lower = (uint64_t)fraction;
    Wide rest = (Wide)upper * PI_2_UPPER + ((Wide)upper * PI_2_LOWER >> 64) + ((Wide)lower * PI_2_UPPER >> 64);
    double unit = power_of_two(2 - zeros - 127); /* the unit of `rest`, the weight of the product of the upper words */
    quarters.rest = quick_sum((double)(uint64_t)(rest >> 75) * 0x1p+75 * unit,
                              (double)(uint64_t)(rest >> 22 & 0x1fffffffffffff) * 0x1p+22 * unit);
    bool negative = above != (bool)signbit(x);
    if (negative)
        quarters.rest = (Pair){-quarters.rest.high, -quarters.rest.low};
    if (signbit(x))
        quarters.count = -quarters.count;
    return quarters;
}

static inline Quarters reduce(double x) {
    static const double PART[3] = {0x1.921fb54400000p+0, 0x1.0b4611a600000p-34, 0x1.3198a2e037073p-69};
    static const double MOST = 0x1p+20;  /* quarters whose products with 33 bits are exact */
    static const double EXACT = 0x1p-57; /* the error of the remainder is 2^-123 per quarter */
    static const double SMALL = 0.785;   /* below pi/4 the angle is its own remainder */
    if (fabs(x) <= SMALL)
        return (Quarters){{x, 0}, 0};
    double shifted = x * 0x1.45f306dc9c883p-1 + ROUNDER, count = shifted - ROUNDER;
    if (!(fabs(count) < MOST))
        return reduce_exactly(x);
    Pair first = sum_of(x - count * PART[0], -(count * PART[1]));
    Pair second = quick_sum(first.high, first.low - count * PART[2]);
    if (fabs(second.high) < fabs(count) * EXACT)
        return reduce_exactly(x);
    return (Quarters){second, bits_of(shifted)};
}

/* sin(high + low) = sin high + low cos high, |high| <= pi/4 */
static inline double sine_of(Pair y) {
    double z = y.high * y.high, z2 = z * z, cube = z * y.high;
    double p = (0x1.111111110f87ap-7 + z * -0x1.a01a019c11944p-13) +
               z2 * ((0x1.71de3577b386dp-19 + z * -0x1.ae5e6638dc824p-26) + z2 * 0x1.5d9300a432317p-33);
    return y.high + (y.low * (1 - z * 0.5) + (cube * -0x1.5555555555549p-3 + cube * (z * p)));
}

static inline double cosine_of(Pair y) {
    double z = y.high * y.high, z2 = z * z, half = 0.5 * z;
    double p = (0x1.555555555554cp-5 + z * -0x1.6c16c16c1517ep-10) +
               z2 * ((0x1.a01a019cb1bfbp-16 + z * -0x1.27e4f809f1dd8p-22) +
                     z2 * (0x1.1ee9ebe9f32a2p-29 + z * -0x1.8fae9cd86ebabp-37));
    Pair top = quick_sum(1, -half);
    return top.high + (top.low + (z2 * p - y.high * y.low));
}

static inline double signed_by(double x, uint64_t negative) {
    return of_bits(bits_of(x) ^ negative << 63);
}

SineCosine real_sincos(double angle) {
    if (fabs(angle) < 0x1p-27)
        return (SineCosine){angle, 1};
    if (!(fabs(angle) <= DBL_MAX))
        return (SineCosine){NOT_A_NUMBER, NOT_A_NUMBER};
    Quarters quarters = reduce(angle);
    double sine = sine_of(quarters.rest), cosine = cosine_of(quarters.rest);
    bool odd = quarters.count & 1;
    return (SineCosine){signed_by(odd ? cosine : sine, quarters.count >> 1 & 1),
                        signed_by(odd ? sine : cosine, (quarters.count + 1) >> 1 & 1)};
}

double real_sin(double angle) {
    if (fabs(angle) < 0x1p-27)
        return angle;
    if (!(fabs(angle) <= DBL_MAX))
        return NOT_A_NUMBER;
    Quarters quarters = reduce(angle);
    double size = quarters.count & 1 ? cosine_of(quarters.rest) : sine_of(quarters.rest);
    return signed_by(size, quarters.count >> 1 & 1);
}

double real_cos(double angle) {
    return real_sincos(angle).cosine;
}

/* Angles of points ------------------------------------------------------------------------------------------------ */

/* atan(k / 16) */
static const Pair ARCTANGENT[17] = {
    {0, 0},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};

/* Below this slope an angle equals its slope: the next term, a third of the cube, is less than half a unit in the
 * last place. */
static const double FLAT = 0x1p-30;

/* Returns atan(small / large) for 0 <= small <= large, large within 2^500 of 1, and a slope of at least FLAT. */
static inline Pair angle_of_slope(Pair small, Pair large) {
    double inverse = 1 / large.high, guess = small.high * inverse;
    Pair back = product_of(guess, large.high);
    Pair q = quick_sum(guess, (((small.high - back.high) - back.low) + (small.low - guess * large.low)) * inverse);
    int k = q.high < 3. / 16 ? 0 : (int)(q.high * 16 + 0.5);
    double c = k * (1. / 16), t = ((q.high - c) + q.low) / (1 + c * q.high), z = t * t, z2 = z * z;
    double p =
        ((-0x1.55555555554b1p-2 + z * 0x1.999999995efb3p-3) + z2 * (-0x1.249248ec179f5p-3 + z * 0x1.c71c3e1deef90p-4)) +
        (z2 * z2) * ((-0x1.74506cfd3fb5bp-4 + z * 0x1.395cbd874437ep-4) + z2 * -0x1.e3c68d2b93c5fp-5);
    double rest = t * (z * p) + ARCTANGENT[k].low;
    return k ? quick_sum(ARCTANGENT[k].high, t + rest) : quick_sum(t, rest + q.low);
}

/* Returns the angle of the point (x, y) for x, y >= 0; `left`: the sign of x is negative. */
static inline double angle_of(Pair y, Pair x, bool left) {
    bool steep = y.high > x.high;
    Pair small = steep ? x : y, large = steep ? y : x, angle;
    double base = steep ? PI_2 : left ? 2 * PI_2 : 0, base_low = steep ? PI_2_LOW : left ? 2 * PI_2_LOW : 0;
    if (small.high < FLAT * large.high) {
        angle = (Pair){small.high / large.high, 0};
        if (base == 0)
            return angle.high;
    } else {
        angle = angle_of_slope(small, large);
    }
    double sign = steep != left ? -1 : 1;
    Pair sum = quick_sum(base, sign * angle.high);
    return sum.high + (sum.low + (base_low + sign * angle.low));
}

/* Returns a power of two that brings the larger of two numbers within 2^500 of 1. */
static inline double scale_for(double large) {
    return large > 0x1p+500 ? 0x1p-600 : large < 0x1p-500 ? 0x1p+600 : 1;
}

double real_atan2(double y, double x) {
    double up = fabs(y), along = fabs(x), large = real_max(up, along);
    bool left = signbit(x);
    if (isnan(x) || isnan(y))
        return x + y;
    if (large == 0)
        return copysign(left ? 2 * PI_2 : 0, y);
    if (isinf(large)) {
        up = isinf(up);
        along = isinf(along);
    } else {
        double scale = scale_for(large);
        if (scale != 1 && real_min(up, along) >= FLAT * large) {
            up *= scale;
            along *= scale;
        }
    }
    return copysign(angle_of((Pair){up, 0}, (Pair){along, 0}, left), y);
}

double real_atan(double x) {
    return real_atan2(x, 1);
}

/* Returns sqrt(1 - x^2) for |x| <= 1. */
static Pair other_side(double x) {
    Pair square = product_of(x, x), rest = quick_sum(1, -square.high);
    double root = sqrt(rest.high);
    Pair back = product_of(root, root);
    return (Pair){root, root > 0 ? (((rest.high - back.high) - back.low) + (rest.low - square.low)) / (2 * root) : 0};
}

double real_asin(double x) {
    if (!(fabs(x) <= 1))
        return NOT_A_NUMBER;
    return copysign(angle_of((Pair){fabs(x), 0}, other_side(x), false), x);
}

double real_acos(double x) {
    if (!(fabs(x) <= 1))
        return NOT_A_NUMBER;
    return angle_of(other_side(x), (Pair){fabs(x), 0}, signbit(x));
}

/* Lengths --------------------------------------------------------------------------------------------------------- */

double real_hypot(double x, double y) {
    double large = real_max(fabs(x), fabs(y)), small = real_min(fabs(x), fabs(y));
    if (isinf(x) || isinf(y))
        return HUGE_VAL;
    if (isnan(x) || isnan(y))
        return x + y;
    if (small <= large * 0x1p-54)
        return large;
    double scale = scale_for(large);
    large *= scale;
    small *= scale;
    Pair a = product_of(large, large), b = product_of(small, small), sum = quick_sum(a.high, b.high);
    double root = sqrt(sum.high);
    Pair back = product_of(root, root);
    double lacks = ((sum.high - back.high) - back.low) + (sum.low + (a.low + b.low));
    return (root + lacks / (2 * root)) / scale;
}

/* Exponential and logarithms -------------------------------------------------------------------------------------- */

/* ln 2; the first part is short enough for its product with an exponent to be exact. */
static const double LN_2 = 0x1.62e42fefa3000p-1, LN_2_LOW = 0x1.3de6af278ece6p-42;

double real_exp(double x) {
    static const double MOST = 709.8, LEAST = -745.2; /* outside this range the result is infinity or 0 */
    if (isnan(x))
        return x;
    if (x > MOST)
        return HUGE_VAL;
    if (x < LEAST)
        return 0;
    double shifted = x * 0x1.71547652b82fep+0 + ROUNDER, count = shifted - ROUNDER;
    Pair r = quick_sum(x - count * LN_2, -(count * LN_2_LOW));
    double z = r.high * r.high, z2 = z * z;
    double p = ((0.5 + r.high * 0x1.555555555555cp-3) + z * (0x1.555555555555ep-5 + r.high * 0x1.111111110ebb3p-7)) +
               z2 * (((0x1.6c16c16c13536p-10 + r.high * 0x1.a01a01b3bb229p-13) +
                      z * (0x1.a01a01b466ba0p-16 + r.high * 0x1.71ddef93d54c1p-19)) +
                     z2 * ((0x1.27e4bf1553ad1p-22 + r.high * 0x1.af6cccbb650cfp-26) + z * 0x1.1f9e10ed84ee8p-29));
    Pair top = quick_sum(1, r.high);
    double grown = top.high + (top.low + (r.low * (1 + r.high) + z * p));
    int exponent = (int)count, first = exponent / 2;
    return grown * power_of_two(first) * power_of_two(exponent - first);
}

/* Returns log(2^k (1 + f)) + low for sqrt(1/2) < 1 + f < sqrt 2. */
static inline double log_of(double k, double f, double low) {
    double s = f / (2 + f), z = s * s, z2 = z * z, half = 0.5 * f * f;
    double p =
        ((0x1.5555555555592p-1 + z * 0x1.999999997fd76p-2) + z2 * (0x1.24924941f503fp-2 + z * 0x1.c71c520603f16p-3)) +
        (z2 * z2) * ((0x1.74663fa2c3ec2p-3 + z * 0x1.39a1a6e6fd3a8p-3) + z2 * 0x1.2f06354ea43bdp-3);
    Pair near = quick_sum(f, -half), top = quick_sum(k * LN_2, near.high);
    return top.high + (top.low + (near.low + (s * (half + z * p) + (k * LN_2_LOW + low))));
}

/* Splits a positive number into 2^k (1 + f), f exact; returns k. */
static inline double split(double x, double *f) {
    static const double SQRT_2 = 0x1.6a09e667f3bcdp+0;
    uint64_t bits = bits_of(x);
    double mantissa = of_bits((bits & 0xfffffffffffff) | (uint64_t)1023 << 52), k = (double)(bits >> 52) - 1023;
    bool high = mantissa > SQRT_2;
    *f = (high ? mantissa * 0.5 : mantissa) - 1;
    return high ? k + 1 : k;
}

double real_log(double x) {
    if (isnan(x) || x == HUGE_VAL)
        return x;
    if (x <= 0)
        return x == 0 ? -HUGE_VAL : NOT_A_NUMBER;
    bool tiny = x < DBL_MIN;
    double f, k = split(tiny ? x * 0x1p+54 : x, &f);
    return log_of(tiny ? k - 54 : k, f, 0);
}

double real_log1p(double x) {
    static const double NEAR_LOW = -0.29,
                        NEAR_HIGH = 0.41; /* within this range 1 + x is between sqrt(1/2) and sqrt 2 */
    if (isnan(x) || x == HUGE_VAL || fabs(x) < 0x1p-54)
        return x;
    if (x <= -1)
        return x == -1 ? -HUGE_VAL : NOT_A_NUMBER;
    if (x > NEAR_LOW && x < NEAR_HIGH)
        return log_of(0, x, 0);
    Pair sum = sum_of(1, x);
    double f, k = split(sum.high, &f);
    return log_of(k, f, sum.low / sum.high);
}

double real_power_of_ten(int exponent) {
    static const double POWER[23] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                     1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    assert(exponent >= -22 && exponent <= 22);
    return exponent < 0 ? 1 / POWER[-exponent] : POWER[exponent];
}
