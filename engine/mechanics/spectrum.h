/* Frequencies in a recording, by the discrete Fourier transform.
 *
 *     X_k = sum_j w_j x_j exp(-2 pi i j k / N),  w_j = (1 - cos(2 pi j / N)) / 2 (Hann),  A_k = 2 |X_k| / sum_j w_j
 *
 * A sine of amplitude a that makes k whole cycles in the N samples gives A_k = a, A_(k-1) = A_(k+1) = a / 2 and nothing
 * elsewhere; between two frequencies its amplitude is shown up to 15 % too small. A constant c gives A_0 = |c|. */
#pragma once

#include <stddef.h>

typedef struct Spectrum {
    double *frequency; /* (count) Hz, from 0 to half of the samples' frequency */
    double *amplitude; /* (count) unit of the samples */
    size_t count;
} Spectrum;

/* Returns the spectrum of `count` samples, `stride` apart in the array, taken every `interval` s; it is empty for fewer
 * than 2 samples. 20,000 samples take about 10 ms; a prime number of that size takes seconds. spectrum_clear releases
 * the spectrum. */
Spectrum spectrum_make(const double *samples, size_t count, size_t stride, double interval);
void spectrum_clear(Spectrum *spectrum);
