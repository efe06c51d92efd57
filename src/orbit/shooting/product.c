// Eigenvalues of a product of matrices that is never multiplied out.
//
// Uses orthogonal iteration: A_j Q_j = Q_j+1 R_j through all factors, repeatedly. The first columns of Q converge to
// the fastest growing subspace. Then Q_0' M Q_0 = H R, where R = R_m ... R_1 is upper triangular, and H = Q_0' Q_m is
// upper triangular except for blocks of eigenvalues of similar modulus. The diagonal blocks of R are products of those
// of the factors: each block has its own scale, and large eigenvalues do not drown small ones.
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"
#include "whirl/engine/orbit.h"

/// MAX_ROUNDS: rounds through all factors, after which moduli that differ by a factor of two are separated to rounding.
/// Moduli within a factor of 2^LIKE need not be separated.
enum { MAX_ROUNDS = 60, LIKE = 8 };

typedef struct product {
    size_t n, count;
    const double *factors;
    double *r;     ///< [count][n][n] triangular
    double *basis; ///< [n][n] columns Q_0 of the last round
    double *now;   ///< [n][n] columns Q_j
    double *work;  ///< [n][n]
} product;

/// Computes out = a b, of n by n.
static void product_multiply(size_t n, const double *a, const double *b, double *out) {
    memset(out, 0, n * n * sizeof *out);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++)
            for (size_t j = 0; j < n; j++) out[i * n + j] += a[i * n + k] * b[k * n + j];
}

static bool go_round(product *p) {
    const size_t n = p->n, size = n * n;
    memcpy(p->basis, p->now, size * sizeof *p->now);
    for (size_t j = 0; j < p->count; j++) {
        product_multiply(n, p->factors + j * size, p->now, p->work);
        if (!matrix_orthogonal(n, p->work, p->now, p->r + j * size)) return false;
    }
    return true;
}

/// Computes H = Q_0' Q_m into the workspace, and sets rounding errors to zero.
static void turn_of(product *p) {
    const size_t n = p->n;
    memset(p->work, 0, n * n * sizeof *p->work);
    for (size_t d = 0; d < n; d++)
        for (size_t i = 0; i < n; i++)
            for (size_t k = 0; k < n; k++) p->work[i * n + k] += p->basis[d * n + i] * p->now[d * n + k];
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < i; k++)
            if (fabs(p->work[i * n + k]) <= 8.0 * DBL_EPSILON * (double)n) p->work[i * n + k] = 0.0;
}

/// Returns the end of the block that begins at `first`: no entry below the diagonal couples it to later rows.
static size_t end_of_block(const product *p, size_t first) {
    const size_t n = p->n;
    size_t end = first + 1;
    for (size_t k = first; k < end; k++)
        for (size_t i = n; i-- > end;)
            if (p->work[i * n + k] != 0.0) {
                end = i + 1;
                break;
            }
    return end;
}

/// Computes the block of H R, divided by 2^*scale, so that nothing in the product under- or overflows.
static void product_block_of(const product *p, size_t first, size_t size, double *block, double *other, int *scale) {
    const size_t n = p->n;
    *scale = 0;
    for (size_t i = 0; i < size * size; i++) block[i] = i % (size + 1) == 0 ? 1.0 : 0.0;
    for (size_t j = 0; j <= p->count; j++) {
        const double *from = j < p->count ? p->r + j * n * n : p->work;
        double *factor = other, *result = other + size * size, largest = 0.0;
        int power = 0;
        for (size_t i = 0; i < size; i++)
            memcpy(factor + i * size, from + (first + i) * n + first, size * sizeof *factor);
        product_multiply(size, factor, block, result);
        for (size_t i = 0; i < size * size; i++) largest = fmax(largest, fabs(result[i]));
        (void)frexp(largest, &power);
        for (size_t i = 0; i < size * size; i++) block[i] = ldexp(result[i], -power);
        *scale += power;
    }
}

static bool read_block(const product *p, size_t first, size_t size, double *memory, whirl_multiplier *values) {
    double *real = memory + 3 * size * size, *imaginary = real + size;
    int scale;
    product_block_of(p, first, size, memory, memory + size * size, &scale);
    if (!matrix_eigen(size, memory, real, imaginary, NULL)) return false;
    for (size_t i = 0; i < size; i++)
        values[first + i] = (whirl_multiplier){ldexp(real[i], scale), ldexp(imaginary[i], scale)};
    return true;
}

static int by_modulus(const void *a, const void *b) {
    const whirl_multiplier *p = a, *q = b;
    const double one = hypot(p->real, p->imaginary), other = hypot(q->real, q->imaginary);
    if (one != other) return one > other ? -1 : 1;
    if (p->real != q->real) return p->real > q->real ? -1 : 1;
    return p->imaginary > q->imaginary ? -1 : p->imaginary < q->imaginary;
}

/// Returns the exponent (a power of two) of a diagonal number of R.
static int size_of_row(const product *p, size_t i) {
    const size_t n = p->n;
    double rest = 1.0;
    int power = 0, all = 0;
    for (size_t j = 0; j < p->count; j++) {
        rest = frexp(rest * p->r[(j * n + i) * n + i], &power);
        all += power;
    }
    return rest == 0.0 ? INT_MIN / 2 : all;
}

/// Returns true if every block has eigenvalues of similar modulus only.
static bool is_apart(product *p) {
    turn_of(p);
    for (size_t first = 0, end; first < p->n; first = end) {
        int low = INT_MAX, high = INT_MIN;
        end = end_of_block(p, first);
        for (size_t i = first; i < end; i++) {
            const int size = size_of_row(p, i);
            if (size < low) low = size;
            if (size > high) high = size;
        }
        if (high - low > LIKE) return false;
    }
    return true;
}

static bool product_find(product *p, double *memory, whirl_multiplier *values) {
    const size_t n = p->n;
    for (size_t i = 0; i < n * n; i++) p->now[i] = i % (n + 1) == 0 ? 1.0 : 0.0;
    bool apart = false;
    for (int k = 0; k < MAX_ROUNDS && !apart; k++) {
        if (!go_round(p)) return false;
        apart = is_apart(p);
    }
    for (size_t first = 0, end; first < n; first = end) {
        end = end_of_block(p, first);
        if (!read_block(p, first, end - first, memory, values)) return false;
    }
    qsort(values, n, sizeof *values, by_modulus);
    return true;
}

bool whirl_product_eigenvalues(size_t n, size_t count, const double *factors, whirl_multiplier *values) {
    const size_t size = n * n;
    double *memory = calloc((count + 6) * size + 2 * n + 1, sizeof *memory);
    if (!memory) return false;
    product p = {.n = n, .count = count, .factors = factors, .r = memory};
    p.basis = memory + count * size;
    p.now = p.basis + size;
    p.work = p.now + size;
    const bool good = n == 0 || product_find(&p, p.work + size, values);
    free(memory);
    return good;
}
