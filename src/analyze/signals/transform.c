// The transform between bins, by Gaussian gridding (Greengard and Lee 2004, SIAM Review 46, 443).
// The transform between bins is interpolated in a longer FFT. The samples, numbered n from their middle, are multiplied
// by exp(+t n^2) and padded with zeros to twice their number or more. In the FFT of these the factor is undone by a
// convolution with the transform of exp(-t n^2). This is a Gaussian, so only the nearest places count. The longer
// transform's length is a power of two, so that a number of samples with large prime factors costs no more than its
// neighbours.
#include "transform.h"

#include <math.h>
#include <stdlib.h>

enum { REACH = 16 }; // places on either side: the rest is below e^-36 for twice the samples, less for more

static const double pi = 3.141592653589793238463;

struct wave_transform {
    size_t count, size;     ///< samples, and places of the longer transform
    double narrowness;      ///< c: a place at distance d counts e^(-c d^2)
    double bell[REACH + 1]; ///< e^(-c m^2)
    double scale;
    double *re, *im; ///< [size] of x + iy
};

/// Fills in exp(-2 pi i p/size) for p < size/2. Each is the product of the one at the largest power of two up to p and
/// the one at the rest of p.
static void fill_turns(size_t size, double *re, double *im) {
    re[0] = 1.0;
    im[0] = 0.0;
    for (size_t known = 1; known < size / 2; known *= 2) {
        const double angle = -2.0 * pi * (double)known / (double)size, c = cos(angle), s = sin(angle);
        for (size_t p = 0; p < known; p++) {
            re[known + p] = re[p] * c - im[p] * s;
            im[known + p] = re[p] * s + im[p] * c;
        }
    }
}

/// Carries out a stage of the transform: pairs that are `half` groups apart, in groups of `stride`.
static void transform_stage(size_t half, size_t stride, const double *turn_re, const double *turn_im,
                            const double *restrict re, const double *restrict im, double *restrict to_re,
                            double *restrict to_im) {
    for (size_t p = 0; p < half; p++) {
        const double c = turn_re[p * stride], s = turn_im[p * stride];
        const size_t first = p * stride, second = (p + half) * stride, to = 2 * p * stride;
        for (size_t q = 0; q < stride; q++) {
            const double dr = re[first + q] - re[second + q], di = im[first + q] - im[second + q];
            to_re[to + q] = re[first + q] + re[second + q];
            to_im[to + q] = im[first + q] + im[second + q];
            to_re[to + stride + q] = dr * c - di * s;
            to_im[to + stride + q] = dr * s + di * c;
        }
    }
}

/// Transforms a power of two of numbers by Stockham's algorithm, which sorts them without a bit reversal. `work` has
/// space for three times `size` numbers.
static void transform_in_place(double *re, double *im, size_t size, double *work) {
    double *turn_re = work + 2 * size, *turn_im = turn_re + size / 2;
    double *from_re = re, *from_im = im, *to_re = work, *to_im = work + size;
    fill_turns(size, turn_re, turn_im);
    for (size_t half = size / 2, stride = 1; half > 0; half /= 2, stride *= 2) {
        transform_stage(half, stride, turn_re, turn_im, from_re, from_im, to_re, to_im);
        double *const was_re = from_re, *const was_im = from_im;
        from_re = to_re, from_im = to_im;
        to_re = was_re, to_im = was_im;
    }
    if (from_re == re) return;
    for (size_t i = 0; i < size; i++) re[i] = from_re[i], im[i] = from_im[i];
}

/// Spreads the samples around place 0: the later half from there on, the earlier half at the end.
static void transform_spread(wave_transform *t, const double *x, const double *y, double widening) {
    const size_t middle = t->count / 2;
    for (size_t j = 0; j < t->count; j++) {
        const double n = (double)j - (double)middle, factor = exp(widening * n * n);
        const size_t place = j >= middle ? j - middle : t->size - (middle - j);
        t->re[place] = factor * x[j];
        t->im[place] = factor * y[j];
    }
}

wave_transform *wave_transform_new(const double *x, const double *y, size_t count, double window_sum) {
    size_t size = 4 * (size_t)REACH;
    while (size < 2 * count) size *= 2;
    wave_transform *t = calloc(1, sizeof *t + 2 * size * sizeof(double));
    double *work = malloc(3 * size * sizeof *work);
    if (t && work) {
        const double length = (double)size, share = 1.0 - (double)count / length;
        // The truncation by the reach and the Gaussian's aliases are then equally small.
        const double width = pi * REACH / sqrt(share);
        *t = (wave_transform){.count = count, .size = size, .narrowness = pi * pi / width};
        t->re = (double *)(t + 1);
        t->im = t->re + size;
        t->scale = sqrt(pi / width) / window_sum;
        for (int m = 0; m <= REACH; m++) t->bell[m] = exp(-t->narrowness * m * m);
        transform_spread(t, x, y, width / (length * length));
        transform_in_place(t->re, t->im, size, work);
    } else {
        free(t);
        t = NULL;
    }
    free(work);
    return t;
}

void wave_transform_free(wave_transform *transform) {
    free(transform);
}

size_t wave_transform_count(const wave_transform *transform) {
    return transform->count;
}

/// A whole number and a remainder from 0 to 1, stored apart so that large numbers keep an exact remainder.
typedef struct position {
    size_t whole;
    double rest;
} position;

/// Returns the position of factor bin/count, reduced to 0 to `period`.
static position position_of(const wave_transform *t, double bin, size_t factor, size_t period) {
    const double floor_bin = floor(bin), broken = (bin - floor_bin) * (double)factor;
    const size_t turns = (size_t)fmod(floor_bin, (double)t->count); // factor times count is a whole period
    const double sum = ((double)(turns * factor % t->count) + broken) / (double)t->count, carry = floor(sum);
    return (position){(turns * factor / t->count + (size_t)carry) % period, sum - carry};
}

/// Returns the transform of x + iy about the middle of the samples, at a place between those of the grid.
static double complex transform_interpolate(const wave_transform *t, size_t at, double d) {
    const size_t mask = t->size - 1;
    // e^(-c (d - m)^2) is e^(-c d^2) (e^(2 c d))^m e^(-c m^2).
    const double step = exp(2.0 * t->narrowness * d), back = 1.0 / step;
    double above = exp(-t->narrowness * d * d), below = above, re = above * t->re[at], im = above * t->im[at];
    for (size_t m = 1; m <= REACH; m++) {
        const size_t right = (at + m) & mask, left = (at - m) & mask;
        above *= step;
        below *= back;
        re += t->bell[m] * (above * t->re[right] + below * t->re[left]);
        im += t->bell[m] * (above * t->im[right] + below * t->im[left]);
    }
    return t->scale * (re + I * im);
}

wave_amplitudes wave_transform_at(const wave_transform *t, double bin) {
    const position place = position_of(t, bin, t->size, t->size);
    const position turn = position_of(t, bin, t->count / 2, 1);
    const double c = cos(2.0 * pi * turn.rest), s = -sin(2.0 * pi * turn.rest);
    const double complex plus = transform_interpolate(t, place.whole, place.rest);
    const double complex minus = conj(transform_interpolate(t, (t->size - place.whole) & (t->size - 1), -place.rest));
    // With z = x + iy: X(k) = (Z(k) + conj Z(-k))/2, Y(k) = (Z(k) - conj Z(-k))/2i.
    const double complex x = 0.5 * (plus + minus), y = -0.5 * I * (plus - minus);
    return (wave_amplitudes){(creal(x) * c - cimag(x) * s) + I * (creal(x) * s + cimag(x) * c),
                             (creal(y) * c - cimag(y) * s) + I * (creal(y) * s + cimag(y) * c)};
}
