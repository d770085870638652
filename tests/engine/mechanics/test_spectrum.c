#include "check.h"

#include <math.h>

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
