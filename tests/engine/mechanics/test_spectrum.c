#include "check.h"

#include <math.h>
#include <stdint.h>

#include "mechanics/spectrum.h"

enum { CYCLES = 96, SAMPLES = 200, COUNT = CYCLES * SAMPLES };

#define FREQUENCY 300.0 /* Hz */

static double samples[COUNT][2]; /* besides another one */

/* Offset + amplitude sin(2 pi share FREQUENCY t + 0.7). */
static Spectrum spectrum_of(double offset, double amplitude, double share) {
    for (int i = 0; i < COUNT; i++) {
        samples[i][0] = offset + amplitude * sin(2 * M_PI * share * i / SAMPLES + 0.7);
        samples[i][1] = 1e9;
    }
    return spectrum_make(&samples[0][0], COUNT, 2, 1 / (FREQUENCY * SAMPLES));
}

TEST(a_pure_sine_of_whole_cycles_has_its_amplitude_at_its_frequency) {
    static const double shares[] = {1, 2, 0.5, 1.0 / 3, 7.25};
    for (int s = 0; s < 5; s++) {
        Spectrum spectrum = spectrum_of(0, 0.127e-3, shares[s]);
        size_t k = (size_t)lround(shares[s] * CYCLES);
        CHECK(spectrum.count == COUNT / 2 + 1);
        CHECK_NEAR(spectrum.frequency[k], shares[s] * FREQUENCY, 1e-9);
        CHECK_NEAR(spectrum.amplitude[k], 0.127e-3, 1e-15);
        CHECK_NEAR(spectrum.amplitude[k - 1], 0.127e-3 / 2, 1e-15);
        CHECK_NEAR(spectrum.amplitude[k + 2], 0, 1e-15);
        spectrum_clear(&spectrum);
    }
}

TEST(between_two_frequencies_a_sine_is_at_most_fifteen_percent_too_small) {
    Spectrum spectrum = spectrum_of(0, 1, 1 + 0.5 / CYCLES);
    CHECK_NEAR(spectrum.amplitude[CYCLES], 8 / (3 * M_PI), 1e-3);
    CHECK_NEAR(spectrum.amplitude[CYCLES + 1], 8 / (3 * M_PI), 1e-3);
    spectrum_clear(&spectrum);
}

TEST(a_constant_is_at_frequency_0) {
    Spectrum spectrum = spectrum_of(-3, 0, 1);
    CHECK_NEAR(spectrum.frequency[0], 0, 0);
    CHECK_NEAR(spectrum.amplitude[0], 3, 1e-12);
    CHECK_NEAR(spectrum.amplitude[5], 0, 1e-12);
    spectrum_clear(&spectrum);
}

TEST(one_sample_has_no_spectrum) {
    CHECK(spectrum_make(&samples[0][0], 1, 2, 1).count == 0);
}

/* Returns the amplitude of element k by the defining sum, in extended precision. */
static double direct(const double *signal, size_t count, size_t k) {
    long double real = 0, imaginary = 0, sum = 0;
    for (size_t j = 0; j < count; j++) {
        long double weight = (1 - cosl(2 * M_PIl * j / count)) / 2, angle = 2 * M_PIl * (j * k % count) / count;
        real += weight * signal[j] * cosl(angle);
        imaginary -= weight * signal[j] * sinl(angle);
        sum += weight;
    }
    return (double)((k == 0 || 2 * k == count ? 1 : 2) * hypotl(real, imaginary) / sum);
}

TEST(each_element_is_that_of_the_defining_sum) {
    static const size_t counts[] = {2,  3,  4,  5,   6,   7,   8,   9,   12,   13,  16,
                                    25, 64, 97, 100, 128, 210, 243, 251, 1001, 1024};
    double signal[1024];
    uint64_t state = 7;
    for (size_t c = 0; c < sizeof counts / sizeof counts[0]; c++) {
        double largest = 0, off = 0;
        for (size_t j = 0; j < counts[c]; j++) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            signal[j] = (double)(int64_t)state / 9.3e18;
        }
        Spectrum spectrum = spectrum_make(signal, counts[c], 1, 1);
        CHECK(spectrum.count == counts[c] / 2 + 1);
        for (size_t k = 0; k < spectrum.count; k++) {
            double expected = direct(signal, counts[c], k);
            largest = fmax(largest, expected);
            off = fmax(off, fabs(spectrum.amplitude[k] - expected));
        }
        CHECK_NEAR(off / largest, 0, 1e-14 * sqrt((double)counts[c]));
        spectrum_clear(&spectrum);
    }
}
