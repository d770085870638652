/* The transform, by products of matrices.
 *
 * Let N = R C, j = C r + c and k = p + R q, with r, p < R and c, q < C. Then
 *
 *     X_(p + R q) = sum_c exp(-2 pi i q c / C) [ exp(-2 pi i p c / N) sum_r exp(-2 pi i p r / R) x_(C r + c) ]
 *
 * For each p the inner sum is a row of cosines and a row of sines times the samples, which are a matrix of R x C. The
 * outer sum is that product, turned by the factors in front of it, times the matrix of the C-th roots of unity. The
 * samples are real, so X_(N - k) is the conjugate of X_k, and p goes only to R / 2.
 *
 * With C near sqrt(N / 2) this takes 3 N sqrt(N) multiplications; for a prime N it takes N^2. All factors come from one
 * table of N-th roots by whole exponents modulo N, so no angle grows. The reference BLAS multiplies: it has the same
 * code for every processor, so the bits are the same everywhere.
 *
 * Cooley and Tukey (1965), An algorithm for the machine calculation of complex Fourier series; Bailey (1990), FFTs in
 * external or hierarchical memory. */
#include "mechanics/spectrum.h"

#include <cblas-netlib.h>
#include <math.h>
#include <stdbool.h>

#include "base/memory.h"
#include "base/real.h"

typedef struct Roots {
    double *cosine, *sine; /* (count) of 2 pi n / count */
    size_t count;
} Roots;

typedef struct Parts {
    double *real, *imaginary;
} Parts;

static double *doubles(size_t count) {
    return memory_zeroed(count, sizeof(double));
}

static Roots make_roots(size_t count) {
    Roots roots = {doubles(count), doubles(count), count};
    for (size_t n = 0; n < count; n++) {
        SineCosine turned = real_sincos(2 * M_PI * (double)n / (double)count);
        roots.cosine[n] = turned.cosine;
        roots.sine[n] = turned.sine;
    }
    return roots;
}

/* Writes the first `length` powers of the root of this index. */
static void fill_powers(const Roots *roots, size_t index, double *cosine, double *sine, size_t length) {
    for (size_t power = 0, at = 0; power < length; power++, at = (at + index) % roots->count) {
        cosine[power] = roots->cosine[at];
        sine[power] = roots->sine[at];
    }
}

/* Returns the largest divisor of `count` that is at most sqrt(count / 2), or 1. */
static size_t divisor(size_t count) {
    size_t found = 1;
    for (size_t d = 2; 2 * d * d <= count; d++)
        if (count % d == 0)
            found = d;
    return found;
}

/* out = scale matrix^T row + keep out, for a matrix of rows x columns. */
static void multiply(double scale, const double *matrix, size_t rows, size_t columns, const double *row, double keep,
                     double *out) {
    cblas_dgemv(CblasRowMajor, CblasTrans, (int)rows, (int)columns, scale, matrix, (int)columns, row, 1, keep, out, 1);
}

/* Turns element c by exp(-2 pi i p c / count). */
static void turn(const Roots *roots, size_t p, Parts row, size_t columns) {
    for (size_t c = 0; c < columns; c++) {
        double cosine = roots->cosine[p * c], sine = roots->sine[p * c], real = row.real[c];
        row.real[c] = real * cosine + row.imaginary[c] * sine;
        row.imaginary[c] = row.imaginary[c] * cosine - real * sine;
    }
}

/* Writes the elements k = 0 ... count / 2 of the transform of real samples. */
static void transform(const Roots *roots, const double *samples, Parts out) {
    size_t count = roots->count, columns = divisor(count), rows = count / columns;
    Parts powers = {doubles(rows), doubles(rows)}, inner = {doubles(columns), doubles(columns)};
    Parts outer = {doubles(columns), doubles(columns)};
    Parts matrix = {doubles(columns * columns), doubles(columns * columns)};
    for (size_t q = 0; q < columns; q++)
        fill_powers(roots, rows * q, matrix.real + q * columns, matrix.imaginary + q * columns, columns);
    for (size_t p = 0; p <= rows / 2; p++) {
        fill_powers(roots, columns * p, powers.real, powers.imaginary, rows);
        multiply(1, samples, rows, columns, powers.real, 0, inner.real);
        multiply(-1, samples, rows, columns, powers.imaginary, 0, inner.imaginary);
        turn(roots, p, inner, columns);
        multiply(1, matrix.real, columns, columns, inner.real, 0, outer.real);
        multiply(1, matrix.imaginary, columns, columns, inner.imaginary, 1, outer.real);
        multiply(1, matrix.real, columns, columns, inner.imaginary, 0, outer.imaginary);
        multiply(-1, matrix.imaginary, columns, columns, inner.real, 1, outer.imaginary);
        for (size_t q = 0; q < columns; q++) {
            size_t k = p + rows * q, mirrored = k ? count - k : 0;
            size_t at = k < mirrored ? k : mirrored;
            out.real[at] = outer.real[q];
            out.imaginary[at] = at == k ? outer.imaginary[q] : -outer.imaginary[q];
        }
    }
    Parts parts[] = {powers, inner, outer, matrix};
    for (int i = 0; i < 4; i++) {
        memory_free(parts[i].real);
        memory_free(parts[i].imaginary);
    }
}

Spectrum spectrum_make(const double *samples, size_t count, size_t stride, double interval) {
    Spectrum spectrum = {.count = 0};
    if (count < 2)
        return spectrum;
    size_t half = count / 2 + 1;
    double *weighted = doubles(count), sum = 0;
    Parts out = {doubles(half), doubles(half)};
    Roots roots = make_roots(count);
    for (size_t i = 0; i < count; i++) {
        double weight = (1 - roots.cosine[i]) / 2;
        weighted[i] = weight * samples[i * stride];
        sum += weight;
    }
    transform(&roots, weighted, out);
    spectrum.count = half;
    spectrum.frequency = doubles(half);
    spectrum.amplitude = doubles(half);
    for (size_t k = 0; k < half; k++) {
        bool single = k == 0 || 2 * k == count; /* these have no negative frequency */
        spectrum.frequency[k] = (double)k / ((double)count * interval);
        spectrum.amplitude[k] = (single ? 1 : 2) * real_hypot(out.real[k], out.imaginary[k]) / sum;
    }
    double *blocks[] = {weighted, out.real, out.imaginary, roots.cosine, roots.sine};
    for (int i = 0; i < 5; i++)
        memory_free(blocks[i]);
    return spectrum;
}

void spectrum_clear(Spectrum *spectrum) {
    memory_free(spectrum->frequency);
    memory_free(spectrum->amplitude);
    *spectrum = (Spectrum){.count = 0};
}
