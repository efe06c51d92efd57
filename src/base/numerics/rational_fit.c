#include "rational_fit.h"

#include <complex.h>
#include <math.h>
#include <string.h>

#include "matrix.h"

/// Sizes of matrices. A set of samples has two rows for each sample, for its real and imaginary parts. Columns are the
/// partial fractions of all poles, 1 and s and, for each entry, the scaling function that moves the poles.
enum {
    MAX_POLES = 2 * RATIONAL_MAX_PAIRS,
    MAX_ROWS = 2 * RATIONAL_MAX_SAMPLES,
    MAX_COLUMNS = MAX_POLES + 2 + RATIONAL_ENTRIES * (MAX_POLES + 1)
};

/// Poles in units of the highest frequency; a complex pair is adjacent, that above the axis first.
typedef struct pole_set {
    size_t count;
    double real[MAX_POLES], imaginary[MAX_POLES];
} pole_set;

/// A fit, with frequencies in units of the highest one.
typedef struct fitting {
    size_t sets, count;
    double top;   ///< highest frequency, rad/s
    double least; ///< modulus of the slowest pole
    double w[RATIONAL_MAX_SAMPLES];
    const rational_sample *samples; ///< [sets][count]
    double weight[RATIONAL_MAX_SETS][RATIONAL_MAX_SAMPLES];
} fitting;

double rational_size(const rational_sample *of) {
    double sum = 0.0;
    for (int e = 0; e < RATIONAL_ENTRIES; e++)
        sum += of->entry[e][0] * of->entry[e][0] + of->entry[e][1] * of->entry[e][1];
    return sqrt(sum);
}

static double complex entry_of(const rational_sample *of, int e) {
    return of->entry[e][0] + of->entry[e][1] * I;
}

/// Computes 1/z with the same bits for all compilers, whose own divisions differ.
static double complex rational_fit_inverse(double complex z) {
    const double size = creal(z) * creal(z) + cimag(z) * cimag(z);
    return creal(z) / size - cimag(z) / size * I;
}

// ---------------------------------------------------------------- least squares

/// Triangularizes `count` columns of a [rows][stride] from column and row `first` on, by Householder's reflections,
/// which transform all columns up to `columns` (Golub, Van Loan 2013, 5.2).
static void rational_fit_triangularize(size_t rows, size_t first, size_t count, size_t columns, size_t stride,
                                       double *a) {
    for (size_t c = first; c < first + count && c < rows; c++) {
        double size = 0.0, sum[MAX_COLUMNS] = {0.0};
        for (size_t r = c; r < rows; r++) size += a[r * stride + c] * a[r * stride + c];
        size = a[c * stride + c] > 0.0 ? -sqrt(size) : sqrt(size);
        const double head = a[c * stride + c] - size, scale = size * head; // -|v|^2/2
        if (scale == 0.0) continue;
        a[c * stride + c] = head;
        for (size_t r = c; r < rows; r++)
            for (size_t k = c + 1; k < columns; k++) sum[k] += a[r * stride + c] * a[r * stride + k];
        for (size_t k = c + 1; k < columns; k++) sum[k] /= scale;
        for (size_t r = c; r < rows; r++)
            for (size_t k = c + 1; k < columns; k++) a[r * stride + k] += a[r * stride + c] * sum[k];
        a[c * stride + c] = size;
        for (size_t r = c + 1; r < rows; r++) a[r * stride + c] = 0.0;
    }
}

/// Finds the shortest x [n] for which a x is nearest to the last column of a [rows][n + 1].
static bool solve_nearest(size_t rows, size_t n, double *a, double *x) {
    double square[(MAX_POLES + 2) * (MAX_POLES + 2)];
    rational_fit_triangularize(rows, 0, n, n + 1, n + 1, a);
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < n; k++) square[i * n + k] = a[i * (n + 1) + k];
        x[i] = a[i * (n + 1) + n];
    }
    return matrix_solve_shortest(n, square, 1e-12, x, NULL);
}

static void put_row(double *a, size_t stride, size_t k, size_t column, double complex value) {
    a[2 * k * stride + column] = creal(value);
    a[(2 * k + 1) * stride + column] = cimag(value);
}

// ---------------------------------------------------------------- functions of given poles

/// Function 0 or 1 of a pair at s = i w: w_j^2/(s^2 + g_j s + w_j^2), or w_j s over the same.
static double complex of_pair(const rational_pair *pair, double w, int which) {
    const double complex below = rational_fit_inverse(pair->w * pair->w - w * w + I * (pair->g * w));
    return which == 0 ? pair->w * pair->w * below : I * (pair->w * w) * below;
}

rational_sample rational_fit_value(const rational_fit *of, double w) {
    rational_sample out;
    for (int e = 0; e < RATIONAL_ENTRIES; e++) {
        double complex sum = of->constant[e] + I * w * of->slope[e];
        for (size_t j = 0; j < of->pair_count; j++)
            sum += of->pairs[j].place[e] * of_pair(&of->pairs[j], w, 0) +
                   of->pairs[j].rate[e] * of_pair(&of->pairs[j], w, 1);
        out.entry[e][0] = creal(sum);
        out.entry[e][1] = cimag(sum);
    }
    return out;
}

/// Writes the poles as pairs: complex ones as they are, real ones sorted by size, two by two.
static void pair_up(const pole_set *poles, rational_fit *out) {
    double real[MAX_POLES];
    size_t count = 0;
    out->pair_count = 0;
    for (size_t k = 0; k < poles->count; k++) {
        const double a = poles->real[k], b = poles->imaginary[k];
        if (b > 0.0) out->pairs[out->pair_count++] = (rational_pair){.w = sqrt(a * a + b * b), .g = -2.0 * a};
        if (b != 0.0) continue;
        size_t place = count++;
        for (; place > 0 && real[place - 1] > -a; place--) real[place] = real[place - 1];
        real[place] = -a;
    }
    for (size_t k = 0; k + 1 < count; k += 2)
        out->pairs[out->pair_count++] = (rational_pair){.w = sqrt(real[k] * real[k + 1]), .g = real[k] + real[k + 1]};
}

/// Writes the functions of all pairs at sample k, and 1, as columns.
static void put_functions(const fitting *f, const rational_fit *of, size_t k, double weight, size_t stride, double *a) {
    for (size_t j = 0; j < 2 * of->pair_count; j++)
        put_row(a, stride, k, j, weight * of_pair(&of->pairs[j / 2], f->w[k], (int)(j % 2)));
    put_row(a, stride, k, 2 * of->pair_count, weight);
}

/// Fits the only set by the functions of the pairs of io, in units of the highest frequency. A `held` slope stays.
static bool fit_numbers(const fitting *f, bool held, rational_fit *io) {
    double a[MAX_ROWS * (MAX_POLES + 3)] = {0.0}, x[MAX_POLES + 2];
    const size_t n = 2 * io->pair_count + (held ? 1 : 2), stride = n + 1;
    for (int e = 0; e < RATIONAL_ENTRIES; e++) {
        for (size_t k = 0; k < f->count; k++) {
            const double weight = f->weight[0][k];
            const double complex slope = I * (f->w[k] * weight), own = weight * entry_of(&f->samples[k], e);
            put_functions(f, io, k, weight, stride, a);
            if (!held) put_row(a, stride, k, n - 1, slope);
            put_row(a, stride, k, n, held ? own - slope * io->slope[e] : own);
        }
        if (!solve_nearest(2 * f->count, n, a, x)) return false;
        for (size_t j = 0; j < io->pair_count; j++) {
            io->pairs[j].place[e] = x[2 * j];
            io->pairs[j].rate[e] = x[2 * j + 1];
        }
        io->constant[e] = x[2 * io->pair_count];
        if (!held) io->slope[e] = x[n - 1];
    }
    return true;
}

/// Computes the residual of all sets with these poles: the root of the sum of squares.
static bool error_of(const fitting *f, const pole_set *poles, rational_fit *pairs, double *error) {
    double a[MAX_ROWS * MAX_COLUMNS];
    *pairs = (rational_fit){.pair_count = 0};
    *error = 0.0;
    pair_up(poles, pairs);
    const size_t n = 2 * pairs->pair_count + 2, stride = n + RATIONAL_ENTRIES;
    for (size_t set = 0; set < f->sets; set++) {
        for (size_t k = 0; k < f->count; k++) {
            put_functions(f, pairs, k, f->weight[set][k], stride, a);
            put_row(a, stride, k, n - 1, I * (f->w[k] * f->weight[set][k]));
            for (size_t e = 0; e < RATIONAL_ENTRIES; e++)
                put_row(a, stride, k, n + e, f->weight[set][k] * entry_of(&f->samples[set * f->count + k], (int)e));
        }
        rational_fit_triangularize(2 * f->count, 0, n, stride, stride, a);
        for (size_t r = n; r < 2 * f->count; r++)
            for (size_t c = n; c < stride; c++) *error += a[r * stride + c] * a[r * stride + c];
    }
    *error = sqrt(*error);
    return isfinite(*error);
}

// ---------------------------------------------------------------- poles

/// Returns the partial fraction of pole k at s = i w: 1/(s - p) for a real pole p; for a complex pair the sum of both
/// fractions at its first pole, and i times their difference at its second.
static double complex rational_fit_partial(const pole_set *poles, size_t k, double w) {
    const double b = poles->imaginary[k];
    const double a = poles->real[k];
    const double complex one = rational_fit_inverse(-a + I * (w - fabs(b))),
                         other = rational_fit_inverse(-a + I * (w + fabs(b)));
    return b == 0.0 ? one : b > 0.0 ? one + other : I * (one - other);
}

/// Returns the distance of the two samples around a frequency.
static double rational_fit_spacing(const fitting *f, double w) {
    size_t k = 1;
    while (k + 1 < f->count && f->w[k] < w) k++;
    return f->w[k] - f->w[k - 1];
}

/// Moves poles into the permitted range. Poles are stable, and neither far beyond the frequencies nor far below them,
/// where samples cannot distinguish them from constants. Resonances are no narrower than half the distance of samples:
/// narrower ones would fit the samples' errors.
static void rational_fit_tidy(const fitting *f, pole_set *poles) {
    const double fastest = 10.0;
    for (size_t k = 0; k < poles->count; k++) {
        double *a = &poles->real[k], *b = &poles->imaginary[k];
        double size = sqrt(*a * *a + *b * *b);
        const double kept = fmin(fmax(size, f->least), fastest);
        *a = size > 0.0 ? -fabs(*a) * (kept / size) : -kept;
        *b = size > 0.0 ? *b * (kept / size) : 0.0;
        if (*b != 0.0) *a = fmin(*a, -0.25 * rational_fit_spacing(f, fabs(*b)));
    }
}

/// Writes the equations of the common scaling function, which moves the poles: rows [entries][poles + 1] of one set.
/// The first columns, the partial fractions of the poles, 1 and s, are the same for all entries.
static void rows_of_set(const fitting *f, const pole_set *poles, size_t set, double *out) {
    double a[MAX_ROWS * MAX_COLUMNS], own[MAX_ROWS * (MAX_POLES + 1)];
    const size_t n = poles->count, before = n + 2, stride = before + RATIONAL_ENTRIES * (n + 1);
    const size_t rows = 2 * f->count - before;
    // Columns of the partial fractions and of the scaling function, with a row for the real and one for the imaginary
    // part.
    for (size_t k = 0; k < f->count; k++) {
        const double weight = f->weight[set][k];
        for (size_t j = 0; j <= n; j++) {
            const double complex value = j < n ? weight * rational_fit_partial(poles, j, f->w[k]) : weight;
            put_row(a, stride, k, j, value);
            for (size_t e = 0; e < RATIONAL_ENTRIES; e++)
                put_row(a, stride, k, before + e * (n + 1) + j,
                        -entry_of(&f->samples[set * f->count + k], (int)e) * value);
        }
        put_row(a, stride, k, n + 1, I * (f->w[k] * weight));
    }
    // Eliminate the partial fractions: the rows that remain have the scaling function of each entry alone.
    rational_fit_triangularize(2 * f->count, 0, before, stride, stride, a);
    for (size_t e = 0; e < RATIONAL_ENTRIES; e++, out += (n + 1) * (n + 2)) {
        for (size_t r = 0; r < rows; r++)
            for (size_t j = 0; j <= n; j++) own[r * (n + 1) + j] = a[(before + r) * stride + before + e * (n + 1) + j];
        rational_fit_triangularize(rows, 0, n + 1, n + 1, n + 1, own);
        for (size_t i = 0; i <= n; i++) {
            for (size_t j = 0; j <= n; j++) out[i * (n + 2) + j] = i < rows ? own[i * (n + 1) + j] : 0.0;
            out[i * (n + 2) + n + 1] = 0.0;
        }
    }
}

/// Moves the poles to the zeros of the scaling function.
static bool rational_fit_relocate(const fitting *f, pole_set *poles) {
    enum { MAX_ENTRIES = RATIONAL_MAX_SETS * RATIONAL_ENTRIES };
    double a[(MAX_ENTRIES * (MAX_POLES + 1) + 1) * (MAX_POLES + 2)] = {0.0}, x[MAX_POLES + 2];
    double matrix[MAX_POLES * MAX_POLES] = {0.0};
    const size_t n = poles->count, rows = f->sets * RATIONAL_ENTRIES * (n + 1) + 1;
    // Least squares for the scaling function; the last row sets its mean to 1.
    for (size_t set = 0; set < f->sets; set++)
        rows_of_set(f, poles, set, a + set * RATIONAL_ENTRIES * (n + 1) * (n + 2));
    double *last = a + (rows - 1) * (n + 2);
    for (size_t j = 0; j < n; j++) {
        last[j] = 0.0;
        for (size_t k = 0; k < f->count; k++)
            last[j] += creal(rational_fit_partial(poles, j, f->w[k])) / (double)f->count;
    }
    last[n] = last[n + 1] = 1.0;
    if (!solve_nearest(rows, n + 1, a, x)) return false;
    // The zeros of the scaling function are the eigenvalues of the poles' matrix minus a matrix of rank one.
    const double smallest = 1e-8, constant = fabs(x[n]) > smallest ? x[n] : copysign(smallest, x[n]);
    for (size_t i = 0; i < n; i++) {
        const double b = poles->imaginary[i], drive = b > 0.0 ? 2.0 : b < 0.0 ? 0.0 : 1.0;
        matrix[i * n + i] = poles->real[i];
        if (b > 0.0) matrix[i * n + i + 1] = b;
        if (b < 0.0) matrix[i * n + i - 1] = b;
        for (size_t j = 0; j < n; j++) matrix[i * n + j] -= drive * x[j] / constant;
    }
    if (!matrix_eigen(n, matrix, poles->real, poles->imaginary, NULL)) return false;
    rational_fit_tidy(f, poles);
    return true;
}

/// Returns the poles to start from: well-damped pairs, spread over the frequencies.
static pole_set first_poles(const fitting *f, size_t pair_count) {
    pole_set out = {.count = 2 * pair_count};
    for (size_t j = 0; j < pair_count; j++) {
        const double w = ((double)j + 0.5) / (double)pair_count;
        out.real[2 * j] = out.real[2 * j + 1] = -0.2 * w;
        out.imaginary[2 * j] = w;
        out.imaginary[2 * j + 1] = -w;
    }
    rational_fit_tidy(f, &out);
    return out;
}

static fitting rational_fit_begin(size_t sets, size_t count, const double *w, const rational_sample *samples) {
    fitting f = {.sets = sets, .count = count, .top = w[count - 1], .samples = samples};
    double largest = 0.0;
    for (size_t i = 0; i < sets * count; i++) largest = fmax(largest, rational_size(&samples[i]));
    for (size_t k = 0; k < count; k++) {
        f.w[k] = w[k] / f.top;
        if (f.least == 0.0) f.least = 1e-2 * f.w[k];
        for (size_t set = 0; set < sets; set++) {
            const double size = fmax(rational_size(&samples[set * count + k]), 1e-9 * largest);
            f.weight[set][k] = size > 0.0 ? 1.0 / size : 1.0;
        }
    }
    return f;
}

bool rational_fit_poles(size_t sets, size_t count, const double *w, const rational_sample *samples, size_t pair_count,
                        rational_fit *out) {
    enum { MAX_STEPS = 40 };
    const fitting f = rational_fit_begin(sets, count, w, samples);
    pole_set poles = first_poles(&f, pair_count);
    double least, last;
    if (!error_of(&f, &poles, out, &least)) return false;
    last = least;
    // Keep the best of all iterates, until steps improve nothing.
    for (int step = 0; step < MAX_STEPS && pair_count > 0 && least > 1e-14; step++) {
        rational_fit next;
        double error;
        if (!rational_fit_relocate(&f, &poles) || !error_of(&f, &poles, &next, &error)) return false;
        if (error < least) *out = next;
        if (fabs(error - last) <= 1e-3 * last) break;
        least = fmin(least, error);
        last = error;
    }
    for (size_t j = 0; j < out->pair_count; j++) {
        out->pairs[j].w *= f.top;
        out->pairs[j].g *= f.top;
    }
    return true;
}

// ---------------------------------------------------------------- the slope

/// Symmetric part of a matrix: mean of its eigenvalues, half their difference, and cosine and sine of twice the
/// direction of the larger one's vector.
typedef struct symmetric {
    double mean, half, c, s;
} symmetric;

static symmetric symmetric_of(const double m[RATIONAL_ENTRIES]) {
    const double a = 0.5 * (m[0] - m[3]), b = 0.5 * (m[1] + m[2]), half = sqrt(a * a + b * b);
    return (symmetric){0.5 * (m[0] + m[3]), half, half > 0.0 ? a / half : 1.0, half > 0.0 ? b / half : 0.0};
}

/// Returns the least damping of the samples, if it is negative; else 0.
static double least_damping(const fitting *f) {
    double least = 0.0;
    for (size_t k = 0; k < f->count; k++) {
        double damping[RATIONAL_ENTRIES];
        if (f->w[k] == 0.0) continue;
        for (int e = 0; e < RATIONAL_ENTRIES; e++) damping[e] = f->samples[k].entry[e][1] / f->w[k];
        const symmetric own = symmetric_of(damping);
        least = fmin(least, own.mean - own.half);
    }
    return least;
}

/// Raises the eigenvalues of the slope's symmetric part to the least allowed; false if none is lower.
static bool raise_slope(double slope[RATIONAL_ENTRIES], double least) {
    const symmetric own = symmetric_of(slope);
    const double low = own.mean - own.half, high = own.mean + own.half, skew = 0.5 * (slope[1] - slope[2]);
    const double a = fmax(low, least), b = fmax(high, least), mean = 0.5 * (a + b), half = 0.5 * (b - a);
    if (!(low < least - 1e-9 * (own.half + fabs(own.mean)))) return false;
    slope[0] = mean + half * own.c;
    slope[3] = mean - half * own.c;
    slope[1] = half * own.s + skew;
    slope[2] = half * own.s - skew;
    return true;
}

bool rational_fit_numbers(size_t count, const double *w, const rational_sample *samples, rational_fit *io) {
    const fitting f = rational_fit_begin(1, count, w, samples);
    for (size_t j = 0; j < io->pair_count; j++) {
        io->pairs[j].w /= f.top;
        io->pairs[j].g /= f.top;
    }
    bool good = fit_numbers(&f, false, io);
    if (good && raise_slope(io->slope, least_damping(&f))) good = fit_numbers(&f, true, io);
    for (int e = 0; e < RATIONAL_ENTRIES; e++) io->slope[e] /= f.top;
    for (size_t j = 0; j < io->pair_count; j++) {
        io->pairs[j].w *= f.top;
        io->pairs[j].g *= f.top;
    }
    return good;
}
