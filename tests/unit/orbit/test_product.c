// Eigenvalues of products of matrices that are known beforehand: P_j = Q_j+1 T_j Q_j' with orthogonal Q_j and
// triangular T_j, so that the product is similar to that of the T_j.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "matrix.h"
#include "whirl/engine/orbit.h"

enum { N = 6 };

static uint64_t seed;

/// Returns numbers from -1 to 1, the same in every run.
static double next_number(void) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)seed * 0x1p-63;
}

static void make_orthogonal(double *q) {
    double a[N * N], r[N * N];
    for (size_t i = 0; i < (size_t)N * N; i++) a[i] = next_number();
    assert_true(matrix_orthogonal(N, a, q, r));
}

/// Computes out = left middle right'.
static void multiply(const double *left, const double *middle, const double *right, double *out) {
    memset(out, 0, sizeof(double) * N * N);
    for (size_t i = 0; i < N; i++)
        for (size_t a = 0; a < N; a++)
            for (size_t b = 0; b < N; b++)
                for (size_t k = 0; k < N; k++) out[i * N + k] += left[i * N + a] * middle[a * N + b] * right[k * N + b];
}

/// Makes factors whose product has the eigenvalues of diag(d), with the first two replaced by a pair r e^(+-i angle).
static void make_factors(size_t count, const double d[N], double angle, double above, double *factors) {
    double q[2][N * N], first[N * N];
    make_orthogonal(first);
    memcpy(q[0], first, sizeof first);
    for (size_t j = 0; j < count; j++) {
        double t[N * N] = {0.0};
        for (size_t i = 0; i < N; i++)
            for (size_t k = i; k < N; k++) t[i * N + k] = i == k ? d[i] : above * next_number() * d[i];
        t[0] = t[N + 1] = d[0] * cos(angle);
        t[1] = -d[0] * sin(angle);
        t[N] = d[0] * sin(angle);
        if (j + 1 < count)
            make_orthogonal(q[1]);
        else
            memcpy(q[1], first, sizeof first);
        multiply(q[1], t, q[0], factors + j * N * N);
        memcpy(q[0], q[1], sizeof first);
    }
}

/// Each eigenvalue is exact relative to its own size, from 2^40 to 1e-120, which the product would lose and a single
/// matrix cannot hold. The rows that couple them are as small as their diagonal.
static void each_is_exact_to_its_own_size(void **state) {
    enum { COUNT = 40 };
    static const double d[N] = {2.0, 2.0, 0.9, -0.6, 1e-1, 1e-3};
    static double factors[COUNT * N * N];
    whirl_multiplier values[N];
    (void)state;
    seed = 1;
    make_factors(COUNT, d, 0.1, 0.3, factors);
    assert_true(whirl_product_eigenvalues(N, COUNT, factors, values));
    const double largest = pow(2.0, COUNT), angle = 0.1 * COUNT;
    const double expected[N][2] = {{largest * cos(angle), largest * fabs(sin(angle))},
                                   {largest * cos(angle), -largest * fabs(sin(angle))},
                                   {pow(0.9, COUNT), 0.0},
                                   {pow(0.6, COUNT), 0.0},
                                   {pow(1e-1, COUNT), 0.0},
                                   {pow(1e-3, COUNT), 0.0}};
    for (size_t i = 0; i < N; i++) {
        const double size = hypot(expected[i][0], expected[i][1]);
        print_message("%g%+gi, off by %.2g of it\n", expected[i][0], expected[i][1],
                      hypot(values[i].real - expected[i][0], values[i].imaginary - expected[i][1]) / size);
        assert_true(hypot(values[i].real - expected[i][0], values[i].imaginary - expected[i][1]) <= 1e-11 * size);
    }
}

/// Eigenvalues that orthogonal iteration hardly separates, and equal ones, are found.
static void near_and_equal_ones(void **state) {
    enum { COUNT = 3 };
    static const double sets[][N] = {{1.0, 1.0, 0.99, 0.98, -0.97, 0.5}, {1.0, 1.0, 1.0, -1.0, 1.0, 1.0}};
    static double factors[COUNT * N * N];
    (void)state;
    for (size_t set = 0; set < 2; set++) {
        whirl_multiplier values[N];
        double sum = 0.0, expected = 2.0 * cos(0.3 * COUNT);
        seed = 7;
        make_factors(COUNT, sets[set], 0.3, 0.0, factors);
        assert_true(whirl_product_eigenvalues(N, COUNT, factors, values));
        for (size_t i = 2; i < N; i++) expected += pow(sets[set][i], COUNT);
        for (size_t i = 0; i < N; i++) sum += values[i].real;
        print_message("sum of %g is off by %.2g\n", expected, sum - expected);
        assert_true(fabs(sum - expected) <= 1e-13);
        for (size_t i = 0; i + 1 < N; i++)
            assert_true(hypot(values[i].real, values[i].imaginary) >=
                        hypot(values[i + 1].real, values[i + 1].imaginary));
    }
}

/// A singular factor makes an eigenvalue 0; with a factor that is not finite there is no answer.
static void singular_and_broken_factors(void **state) {
    static const double d[N] = {1.5, 1.5, 0.7, 0.4, 0.2, 0.0};
    double factors[2 * N * N];
    whirl_multiplier values[N];
    (void)state;
    seed = 3;
    make_factors(2, d, 0.2, 0.2, factors);
    assert_true(whirl_product_eigenvalues(N, 2, factors, values));
    assert_true(hypot(values[N - 1].real, values[N - 1].imaginary) <= 1e-14);
    assert_true(fabs(values[2].real - 0.49) <= 1e-13);
    factors[N] = NAN;
    assert_false(whirl_product_eigenvalues(N, 2, factors, values));
    assert_true(whirl_product_eigenvalues(0, 2, factors, values));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_is_exact_to_its_own_size),
                                       cmocka_unit_test(near_and_equal_ones),
                                       cmocka_unit_test(singular_and_broken_factors)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
