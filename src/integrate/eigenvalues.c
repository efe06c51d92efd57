#include "eigenvalues.h"

#include <float.h>
#include <math.h>

// ---------------------------------------------------------------- balance and norm

/// The sums of moduli of row and column i, without the diagonal.
static void off_diagonal_sums(size_t n, const double *a, size_t i, double *row, double *column) {
    *row = *column = 0.0;
    for (size_t k = 0; k < n; k++) {
        if (k == i) continue;
        *row += fabs(a[i * n + k]);
        *column += fabs(a[k * n + i]);
    }
}

void matrix_balance(size_t n, double *a) {
    enum { MOST_SWEEPS = 32 };
    bool changed = true;
    for (int sweep = 0; sweep < MOST_SWEEPS && changed; sweep++) {
        changed = false;
        for (size_t i = 0; i < n; i++) {
            double row, column;
            off_diagonal_sums(n, a, i, &row, &column);
            if (!(row > 0.0) || !(column > 0.0) || !isfinite(row) || !isfinite(column)) continue;
            // The power of two next to sqrt(row / column): column * factor and row / factor are alike.
            const double factor = exp2(round(0.5 * log2(row / column)));
            if (column * factor + row / factor >= 0.95 * (row + column)) continue;
            for (size_t k = 0; k < n; k++) {
                a[i * n + k] /= factor;
                a[k * n + i] *= factor;
            }
            changed = true;
        }
    }
}

double matrix_norm(size_t n, const double *a) {
    double largest_row = 0.0, largest_column = 0.0;
    for (size_t i = 0; i < n; i++) {
        double row, column;
        off_diagonal_sums(n, a, i, &row, &column);
        largest_row = fmax(largest_row, row + fabs(a[i * n + i]));
        largest_column = fmax(largest_column, column + fabs(a[i * n + i]));
    }
    return fmin(largest_row, largest_column);
}

// ---------------------------------------------------------------- Householder's reflections

enum { REFLECTED = 3 };

/// The reflection I - scale v v' that lays a vector of `count` <= REFLECTED numbers along the first axis.
typedef struct reflection {
    size_t count;
    double v[REFLECTED], scale; ///< scale 0: nothing is to be done
} reflection;

static reflection reflect_along_first(const double *vector, size_t count) {
    reflection r = {.count = count};
    double square = 0.0, largest = 0.0;
    for (size_t i = 0; i < count; i++) largest = fmax(largest, fabs(vector[i]));
    if (!(largest > 0.0)) return r;
    for (size_t i = 0; i < count; i++) {
        r.v[i] = vector[i] / largest;
        square += r.v[i] * r.v[i];
    }
    r.v[0] += copysign(sqrt(square), r.v[0]);
    square = 0.0;
    for (size_t i = 0; i < count; i++) square += r.v[i] * r.v[i];
    r.scale = 2.0 / square;
    return r;
}

/// Applies it to numbers that are `stride` apart.
static void reflect(const reflection *r, double *numbers, size_t stride) {
    double sum = 0.0;
    for (size_t i = 0; i < r->count; i++) sum += r->v[i] * numbers[i * stride];
    for (size_t i = 0; i < r->count; i++) numbers[i * stride] -= r->scale * sum * r->v[i];
}

/// The similarity by a reflection of rows and columns `first` and the following, within rows `top` to `bottom` and
/// columns from `left` to `bottom`.
static void transform(double *a, size_t n, const reflection *r, size_t first, size_t top, size_t left, size_t bottom) {
    const size_t last = first + REFLECTED < bottom ? first + REFLECTED : bottom;
    for (size_t k = left; k <= bottom; k++) reflect(r, a + first * n + k, n);
    for (size_t k = top; k <= last; k++) reflect(r, a + k * n + first, 1);
}

// ---------------------------------------------------------------- Hessenberg's form

/// Column by column, what stands below the subdiagonal is cleared by planar reflections from the bottom up.
static void reduce(size_t n, double *a) {
    for (size_t column = 0; column + 2 < n; column++)
        for (size_t row = n - 1; row > column + 1; row--) {
            double *upper = a + (row - 1) * n + column;
            if (upper[n] == 0.0) continue;
            const reflection r = reflect_along_first((const double[]){upper[0], upper[n]}, 2);
            for (size_t k = column; k < n; k++) reflect(&r, a + (row - 1) * n + k, n);
            for (size_t k = 0; k < n; k++) reflect(&r, a + k * n + row - 1, 1);
            upper[n] = 0.0;
        }
}

// ---------------------------------------------------------------- Francis' steps

/// Trace and determinant of the last two rows of the active block, which give its two shifts.
typedef struct shifts {
    double trace, determinant;
} shifts;

static shifts take_shifts(const double *a, size_t n, size_t high, int tries) {
    const double *d = a + (high - 1) * n + high - 1; // d[0], d[1]; d[n], d[n + 1]
    if (tries % 10 == 9) {                           // a shift out of turn, where the usual ones go round in circles
        const double size = fabs(d[n]) + fabs(d[1]);
        return (shifts){1.5 * size, size * size};
    }
    return (shifts){d[0] + d[n + 1], d[0] * d[n + 1] - d[1] * d[n]};
}

/// One double step on rows and columns `low` to `high`.
static void francis_step(double *a, size_t n, size_t low, size_t high, shifts s) {
    const double *d = a + low * n + low;
    double bulge[REFLECTED] = {d[0] * d[0] + d[1] * d[n] - s.trace * d[0] + s.determinant,
                               d[n] * (d[0] + d[n + 1] - s.trace), d[n] * d[2 * n + 1]};
    for (size_t k = low; k < high; k++) {
        const size_t count = k + 1 < high ? 3 : 2;
        const reflection r = reflect_along_first(bulge, count);
        transform(a, n, &r, k, low, k > low ? k - 1 : low, high);
        if (k > low)
            for (size_t i = 1; i < count; i++) a[(k + i) * n + k - 1] = 0.0;
        for (size_t i = 0; i < REFLECTED; i++) bulge[i] = k + 1 + i <= high ? a[(k + 1 + i) * n + k] : 0.0;
    }
}

/// The first row of the block that ends with row `high` and hangs together; a subdiagonal that is nothing beside its
/// neighbours is cleared.
static size_t block_begin(double *a, size_t n, size_t high) {
    size_t low = high;
    for (; low > 0; low--) {
        double *below = a + low * n + low - 1;
        const double beside = fabs(a[(low - 1) * n + low - 1]) + fabs(a[low * n + low]);
        if (fabs(*below) <= DBL_EPSILON * beside || fabs(*below) < DBL_MIN) {
            *below = 0.0;
            break;
        }
    }
    return low;
}

/// Of a block of two, whose first row begins at `d`.
static void take_pair(const double *d, size_t n, double *real, double *imaginary) {
    const double middle = 0.5 * (d[0] + d[n + 1]), half = 0.5 * (d[0] - d[n + 1]);
    const double square = half * half + d[1] * d[n];
    if (square < 0.0) {
        real[0] = real[1] = middle;
        imaginary[0] = sqrt(-square);
        imaginary[1] = -imaginary[0];
        return;
    }
    // The larger one first; the other by the determinant, which does not cancel.
    const double larger = middle + copysign(sqrt(square), middle);
    const double determinant = d[0] * d[n + 1] - d[1] * d[n];
    real[0] = larger;
    real[1] = larger != 0.0 ? determinant / larger : 0.0;
    imaginary[0] = imaginary[1] = 0.0;
}

bool matrix_eigenvalues(size_t n, double *a, double *real, double *imaginary) {
    enum { MOST_TRIES = 60 };
    int tries = 0;
    reduce(n, a);
    for (size_t left = n; left > 0;) {
        const size_t high = left - 1, low = block_begin(a, n, high);
        if (low == high) {
            real[high] = a[high * n + high];
            imaginary[high] = 0.0;
            left -= 1;
            tries = 0;
        } else if (low + 1 == high) {
            take_pair(a + low * n + low, n, real + low, imaginary + low);
            left -= 2;
            tries = 0;
        } else {
            if (++tries > MOST_TRIES) return false;
            francis_step(a, n, low, high, take_shifts(a, n, high, tries));
        }
    }
    return true;
}
