#include "mechanics/spectrum.h"

#include <complex.h>
#include <fftw3.h>
#include <math.h>
#include <pthread.h>
#include <stdbool.h>

#include "base/memory.h"
#include "base/real.h"

/* Serialises planning: FFTW keeps its plans in memory that all threads share. */
static pthread_mutex_t planning = PTHREAD_MUTEX_INITIALIZER;

/* Transforms real samples; `out` has count / 2 + 1 elements. FFTW_ESTIMATE always chooses the same plan. */
static void transform(double *samples, fftw_complex *out, size_t count) {
    pthread_mutex_lock(&planning);
    fftw_plan plan = fftw_plan_dft_r2c_1d((int)count, samples, out, FFTW_ESTIMATE | FFTW_UNALIGNED);
    pthread_mutex_unlock(&planning);
    fftw_execute(plan);
    pthread_mutex_lock(&planning);
    fftw_destroy_plan(plan);
    pthread_mutex_unlock(&planning);
}

Spectrum spectrum_make(const double *samples, size_t count, size_t stride, double interval) {
    Spectrum spectrum = {.count = 0};
    if (count < 2)
        return spectrum;
    size_t half = count / 2 + 1;
    double *weighted = memory_zeroed(count, sizeof *weighted), sum = 0;
    fftw_complex *out = memory_zeroed(half, sizeof *out);
    for (size_t i = 0; i < count; i++) {
        double weight = (1 - real_cos(2 * M_PI * (double)i / (double)count)) / 2;
        weighted[i] = weight * samples[i * stride];
        sum += weight;
    }
    transform(weighted, out, count);
    spectrum.count = half;
    spectrum.frequency = memory_zeroed(half, sizeof *spectrum.frequency);
    spectrum.amplitude = memory_zeroed(half, sizeof *spectrum.amplitude);
    for (size_t k = 0; k < half; k++) {
        bool single = k == 0 || 2 * k == count; /* these have no negative frequency */
        spectrum.frequency[k] = (double)k / ((double)count * interval);
        spectrum.amplitude[k] = (single ? 1 : 2) * real_hypot(creal(out[k]), cimag(out[k])) / sum;
    }
    memory_free(weighted);
    memory_free(out);
    return spectrum;
}

void spectrum_clear(Spectrum *spectrum) {
    memory_free(spectrum->frequency);
    memory_free(spectrum->amplitude);
    *spectrum = (Spectrum){.count = 0};
}
