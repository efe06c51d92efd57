// Dense matrices against closed forms and against LAPACK.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <lapacke.h>

#include "elimination.h"
#include "matrix.h"
#include "matrix_balance.h"

static const double pi = 3.14159265358979323846;

enum { MAX_SIZE = 100 };

static unsigned noise = 1;

/// Returns pseudo-random numbers between -1 and 1.
static double some_number(void) {
    noise = noise * 1664525u + 1013904223u;
    return (double)(noise >> 8) / (double)(1u << 23) - 1.0;
}

// ---------------------------------------------------------------- eigenvalues

typedef struct spectrum {
    double real[MAX_SIZE], imaginary[MAX_SIZE];
} spectrum;

static spectrum spectrum_of(size_t n, const double *matrix) {
    static double copy[MAX_SIZE * MAX_SIZE];
    spectrum s;
    memcpy(copy, matrix, n * n * sizeof *copy);
    assert_true(matrix_eigen(n, copy, s.real, s.imaginary, NULL));
    return s;
}

/// Checks that every expected value is found to `tolerance`, as often as it is expected.
static void expect_spectrum(size_t n, spectrum found, const spectrum *wanted, double tolerance) {
    for (size_t i = 0; i < n; i++) {
        size_t nearest = i;
        double least = INFINITY;
        for (size_t k = i; k < n; k++) {
            const double distance = hypot(found.real[k] - wanted->real[i], found.imaginary[k] - wanted->imaginary[i]);
            if (distance < least) least = distance, nearest = k;
        }
        if (!(least <= tolerance)) fail_msg("%g + %gi is off by %g", wanted->real[i], wanted->imaginary[i], least);
        found.real[nearest] = found.real[i];
        found.imaginary[nearest] = found.imaginary[i];
    }
}

/// Rows (0, 1, 0, ...), ..., last row c: x^n = c[0] + c[1] x + ...
static void test_companion_matrices(void **state) {
    // (x - 1)(x - 2)(x^2 - 2x + 5): 1, 2, 1 +- 2i. x^4 = -10 + 19 x - 13 x^2 + 5 x^3
    const double matrix[16] = {0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -10, 19, -13, 5};
    const spectrum wanted = {{1, 2, 1, 1}, {0, 0, 2, -2}};
    (void)state;
    expect_spectrum(4, spectrum_of(4, matrix), &wanted, 1e-12);
}

/// Cyclic shifts have the roots of unity: all moduli are equal, so that shifts of the QR algorithm may never converge.
static void test_cyclic_shifts(void **state) {
    static double matrix[MAX_SIZE * MAX_SIZE];
    (void)state;
    for (size_t n = 1; n <= MAX_SIZE; n = 2 * n + 1) {
        spectrum wanted;
        memset(matrix, 0, sizeof matrix);
        for (size_t i = 0; i < n; i++) {
            matrix[i * n + (i + 1) % n] = 1.0;
            wanted.real[i] = cos(2 * pi * (double)i / (double)n);
            wanted.imaginary[i] = sin(2 * pi * (double)i / (double)n);
        }
        expect_spectrum(n, spectrum_of(n, matrix), &wanted, 1e-12);
    }
}

/// A chain of 50 unit masses and springs k between walls, x'' = -k (2 x - neighbours): +- i 2 sqrt k sin(j pi / 102).
/// Positions and velocities are scales apart, which balancing evens out; the norm then bounds the largest within
/// sqrt 2.
static void test_a_chain_of_masses(void **state) {
    enum { MASSES = 50, N = 2 * MASSES };
    static double matrix[N * N];
    const double k = 1e8;
    spectrum wanted = {{0}, {0}};
    (void)state;
    for (size_t i = 0; i < MASSES; i++) {
        double *row = matrix + (MASSES + i) * N;
        matrix[i * N + MASSES + i] = 1.0;
        row[i] = -2 * k;
        if (i > 0) row[i - 1] = k;
        if (i + 1 < MASSES) row[i + 1] = k;
        wanted.imaginary[2 * i] = 2 * sqrt(k) * sin((double)(i + 1) * pi / (2 * (MASSES + 1)));
        wanted.imaginary[2 * i + 1] = -wanted.imaginary[2 * i];
    }
    expect_spectrum(N, spectrum_of(N, matrix), &wanted, 1e-9 * sqrt(k));
    assert_true(matrix_norm(N, matrix) >= 4 * k);
    matrix_balance(N, matrix, NULL);
    const double norm = matrix_norm(N, matrix);
    assert_true(norm >= 2 * sqrt(k) && norm <= 3 * sqrt(k));
}

/// Similar matrices have the same eigenvalues, whatever the similarity: diag(1, ..., n) in other coordinates.
static void test_full_matrices(void **state) {
    enum { N = 24 };
    double matrix[N * N] = {0};
    spectrum wanted = {{0}, {0}};
    unsigned seed = 1;
    (void)state;
    for (size_t i = 0; i < N; i++) matrix[i * N + i] = wanted.real[i] = (double)i + 1;
    for (int times = 0; times < 40; times++) { // I + f e_i e_k' and its inverse, by turns
        seed = seed * 1664525u + 1013904223u;
        const size_t i = (seed >> 8) % N, k = (i + 1 + (seed >> 20) % (N - 1)) % N;
        for (size_t c = 0; c < N; c++) matrix[i * N + c] += 0.5 * matrix[k * N + c];
        for (size_t r = 0; r < N; r++) matrix[r * N + k] -= 0.5 * matrix[r * N + i];
    }
    expect_spectrum(N, spectrum_of(N, matrix), &wanted, 1e-9);
}

/// A Jordan block of three, (x - 2)^3: rounding moves a triple root by its cube root, and no further.
static void test_a_defective_matrix(void **state) {
    const double matrix[9] = {0, 1, 0, 0, 0, 1, 8, -12, 6};
    const spectrum wanted = {{2, 2, 2}, {0, 0, 0}};
    (void)state;
    expect_spectrum(3, spectrum_of(3, matrix), &wanted, 1e-4);
}

/// diag(1, ..., n) in coordinates whose scales are up to 1e12 apart: balancing finds them, and rounding sees nothing.
static void test_bad_scales(void **state) {
    enum { N = 8 };
    double matrix[N * N];
    spectrum wanted = {{0}, {0}};
    (void)state;
    for (size_t i = 0; i < N; i++) {
        wanted.real[i] = (double)i + 1;
        for (size_t k = 0; k < N; k++) matrix[i * N + k] = i == k ? wanted.real[i] : k > i ? 1.0 : 0.0;
    }
    for (size_t k = 0; k < N; k++) matrix[(N - 1) * N + k] += 0.25 * matrix[k]; // I + f e_i e_k' ...
    for (size_t i = 0; i < N; i++) matrix[i * N] -= 0.25 * matrix[i * N + N - 1];
    for (size_t i = 0; i < N; i++)
        for (size_t k = 0; k < N; k++) matrix[i * N + k] *= pow(10.0, 12.0 * ((double)(i % 3) - (double)(k % 3)) / 2);
    expect_spectrum(N, spectrum_of(N, matrix), &wanted, 1e-10);
}

/// Eigenvectors of length 1 fulfil A v = lambda v to rounding, and the eigenvalues are LAPACK's.
static void test_eigenvectors(void **state) {
    enum { N = 30 };
    static double matrix[N * N], copy[N * N], vectors[N * N * 2];
    double real[N], imaginary[N];
    spectrum other;
    (void)state;
    for (size_t i = 0; i < N * N; i++) matrix[i] = some_number();
    memcpy(copy, matrix, sizeof matrix);
    assert_true(matrix_eigen(N, copy, real, imaginary, vectors));
    for (size_t mode = 0; mode < N; mode++) {
        const double *v = vectors + 2 * N * mode;
        double worst = 0.0, square = 0.0, largest = 0.0, at_largest = 0.0;
        for (size_t i = 0; i < N; i++) {
            double re = -real[mode] * v[2 * i] + imaginary[mode] * v[2 * i + 1];
            double im = -real[mode] * v[2 * i + 1] - imaginary[mode] * v[2 * i];
            for (size_t k = 0; k < N; k++) {
                re += matrix[i * N + k] * v[2 * k];
                im += matrix[i * N + k] * v[2 * k + 1];
            }
            const double size = hypot(v[2 * i], v[2 * i + 1]);
            worst = fmax(worst, hypot(re, im));
            square += size * size;
            if (size > largest) largest = size, at_largest = v[2 * i] / size;
        }
        assert_true(worst < 1e-12);
        assert_true(fabs(square - 1) < 1e-13 && at_largest > 0.99999);
    }
    memcpy(copy, matrix, sizeof matrix);
    assert_int_equal(
        LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', N, copy, N, other.real, other.imaginary, NULL, N, NULL, N), 0);
    expect_spectrum(N, spectrum_of(N, matrix), &other, 1e-12);
}

// ---------------------------------------------------------------- symmetric modes

/// The second difference, 2 on and -1 next to the diagonal: 4 sin^2(j pi / 2 (n + 1)), sin(i j pi / (n + 1)).
static void test_a_string(void **state) {
    enum { N = 40 };
    static double k[N * N], m[N * N], values[N], vectors[N * N];
    (void)state;
    for (size_t i = 0; i < N; i++) {
        k[i * N + i] = 2;
        m[i * N + i] = 4; // which divides the values by 4 and the vectors by 2
        if (i > 0) k[i * N + i - 1] = k[(i - 1) * N + i] = -1;
    }
    for (int with_mass = 0; with_mass < 2; with_mass++) {
        const double mass = with_mass ? 4 : 1;
        assert_true(matrix_symmetric_modes(N, k, with_mass ? m : NULL, values, vectors));
        for (size_t j = 0; j < N; j++) {
            const double angle = pi * (double)(j + 1) / (N + 1), half = 2 * sin(0.5 * angle);
            double sign = 0;
            assert_true(fabs(values[j] - half * half / mass) < 1e-14);
            for (size_t i = 0; i < N; i++) {
                const double shape = sqrt(2.0 / (N + 1) / mass) * sin(angle * (double)(i + 1));
                if (sign == 0 && fabs(shape) > 1e-3) sign = shape * vectors[j * N + i] > 0 ? 1 : -1;
                assert_true(fabs(sign * vectors[j * N + i] - shape) < 1e-12);
            }
        }
    }
}

/// K and M full: the equation, the norm, the sign; and LAPACK's values.
static void test_full_modes(void **state) {
    enum { N = 25 };
    static double k[N * N], m[N * N], values[N], vectors[N * N], others[N];
    double root[N * N];
    (void)state;
    for (size_t i = 0; i < N * N; i++) root[i] = some_number();
    for (size_t i = 0; i < N; i++)
        for (size_t j = 0; j < N; j++) {
            m[i * N + j] = i == j ? 1 : 0;
            for (size_t c = 0; c < N; c++) m[i * N + j] += root[i * N + c] * root[j * N + c];
            k[i * N + j] = j <= i ? 1e6 * some_number() : k[i * N + j];
            k[j * N + i] = k[i * N + j];
        }
    assert_true(matrix_symmetric_modes(N, k, m, values, vectors));
    for (size_t mode = 0; mode < N; mode++) {
        const double *v = vectors + N * mode;
        double norm = 0, largest = 0, most = 0;
        for (size_t i = 0; i < N; i++) {
            double kv = 0, mv = 0;
            for (size_t c = 0; c < N; c++) {
                kv += k[i * N + c] * v[c];
                mv += m[i * N + c] * v[c];
            }
            assert_true(fabs(kv - values[mode] * mv) < 1e-7);
            norm += v[i] * mv;
            most = fmax(most, fabs(v[i]));
            if (v[i] > largest) largest = v[i];
        }
        assert_true(fabs(norm - 1) < 1e-12 && largest == most);
        assert_true(mode == 0 || values[mode] >= values[mode - 1]);
    }
    assert_int_equal(LAPACKE_dsygv(LAPACK_ROW_MAJOR, 1, 'N', 'L', N, k, N, m, N, others), 0);
    for (size_t i = 0; i < N; i++) assert_true(fabs(values[i] - others[i]) < 1e-8);
}

// ---------------------------------------------------------------- equations

/// Hilbert's matrix and a right-hand side of ones: the solution is whole, (-1)^(n-1-i) (n+i)! / (i!^2 (n-1-i)!).
static void test_hilbert(void **state) {
    enum { N = 6 };
    double h[N * N], solution[2][N], wanted[N];
    (void)state;
    for (size_t i = 0; i < N; i++)
        for (size_t k = 0; k < N; k++) h[i * N + k] = 1.0 / (double)(i + k + 1);
    for (size_t i = 0; i < N; i++) {
        wanted[i] = (N - 1 - i) % 2 ? -1 : 1;
        for (size_t f = i + 1; f <= N + i; f++) wanted[i] *= (double)f; // (n + i)! / i!
        for (size_t f = 1; f <= i; f++) wanted[i] /= (double)f;
        for (size_t f = 1; f <= N - 1 - i; f++) wanted[i] /= (double)f;
        solution[0][i] = 1;
        solution[1][i] = 2;
    }
    assert_true(matrix_solve(N, h, 2, solution[0]));
    for (size_t i = 0; i < N; i++) {
        assert_true(fabs(solution[0][i] / wanted[i] - 1) < 1e-9);
        assert_true(fabs(solution[1][i] / (2 * wanted[i]) - 1) < 1e-9);
        solution[0][i] = 1;
    }
    assert_true(matrix_solve_definite(N, h, 1, solution[0]));
    for (size_t i = 0; i < N; i++) assert_true(fabs(solution[0][i] / wanted[i] - 1) < 1e-9);
}

/// Matrices like those of an orbit's segments: blocks on the diagonal and next to it, one in the corner, with pivots
/// below the diagonal. The solution has whole numbers.
static void test_blocks_in_a_ring(void **state) {
    enum { N = 3, BLOCKS = 5, ALL = N * BLOCKS };
    double a[ALL * ALL] = {0}, b[ALL] = {0};
    size_t order[ALL];
    (void)state;
    for (size_t j = 0; j < BLOCKS; j++)
        for (size_t i = 0; i < N; i++) {
            double *row = a + (j * N + i) * ALL;
            for (size_t k = 0; k < N; k++) row[j * N + k] = i == k ? 0.0 : (double)(i + 2 * k + j);
            row[(j + 1) % BLOCKS * N + i] -= 1.0;
        }
    for (size_t i = 0; i < ALL; i++)
        for (size_t k = 0; k < ALL; k++) b[i] += a[i * ALL + k] * ((double)k - 4.0);
    assert_true(elimination_decompose(ALL, a, order));
    elimination_solve(ALL, a, order, b);
    for (size_t k = 0; k < ALL; k++) assert_true(fabs(b[k] - ((double)k - 4.0)) < 1e-12);
    double singular[4] = {1, 2, 2, 4}, nowhere[4] = {1, NAN, 0, 1};
    assert_false(elimination_decompose(2, singular, order));
    assert_false(elimination_decompose(2, nowhere, order));
}

/// A driven chain in complex numbers: the matrix times the solution is the right-hand side.
static void test_complex_equations(void **state) {
    enum { N = 20, SIDES = 3 };
    static double a[N * N * 2], b[SIDES * N * 2], x[SIDES * N * 2];
    (void)state;
    for (size_t i = 0; i < N * N * 2; i++) a[i] = some_number();
    for (size_t i = 0; i < SIDES * N * 2; i++) x[i] = b[i] = some_number();
    assert_true(matrix_solve_complex(N, a, SIDES, x));
    for (size_t c = 0; c < SIDES; c++)
        for (size_t i = 0; i < N; i++) {
            double re = -b[2 * (c * N + i)], im = -b[2 * (c * N + i) + 1];
            for (size_t k = 0; k < N; k++) {
                const double *p = a + 2 * (i * N + k), *q = x + 2 * (c * N + k);
                re += p[0] * q[0] - p[1] * q[1];
                im += p[0] * q[1] + p[1] * q[0];
            }
            assert_true(hypot(re, im) < 1e-12);
        }
}

/// Of all solutions of x + y = 2 (twice) the shortest is (1, 1). If no x solves x = 1 and x = 3, the nearest is 2.
static void test_the_shortest_solution(void **state) {
    const double free[4] = {1, 1, 1, 1}, torn[4] = {1, 0, 1, 0};
    double both[2] = {2, 2}, nearest[2] = {1, 3};
    size_t rank;
    (void)state;
    assert_true(matrix_solve_shortest(2, free, 1e-12, both, &rank));
    assert_true(rank == 1 && fabs(both[0] - 1) < 1e-15 && fabs(both[1] - 1) < 1e-15);
    assert_true(matrix_solve_shortest(2, torn, 1e-12, nearest, &rank));
    assert_true(rank == 1 && fabs(nearest[0] - 2) < 1e-15 && fabs(nearest[1]) < 1e-15);
}

/// The solver reports that a problem without an answer has none.
static void test_problems_without_an_answer(void **state) {
    const double singular[4] = {1, 2, 2, 4}, indefinite[4] = {1, 2, 2, 1}, one[4] = {1, 0, 0, 1};
    double nowhere[4] = {1, NAN, 0, 1}, values[2], more[2], vectors[8], side[4] = {1, 1, 1, 1};
    (void)state;
    assert_false(matrix_solve(2, singular, 1, side));
    assert_false(matrix_solve_definite(2, indefinite, 1, side));
    assert_false(matrix_symmetric_modes(2, one, indefinite, values, vectors));
    assert_false(matrix_symmetric_modes(2, nowhere, NULL, values, vectors));
    assert_false(matrix_solve(2, nowhere, 1, side));
    assert_false(matrix_solve_definite(2, nowhere, 1, side));
    assert_false(matrix_solve_shortest(2, nowhere, 1e-12, side, NULL));
    assert_false(matrix_eigen(2, nowhere, values, more, vectors));
    assert_true(matrix_eigen(0, NULL, NULL, NULL, NULL) && matrix_solve(0, NULL, 1, NULL));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_companion_matrices),
        cmocka_unit_test(test_cyclic_shifts),
        cmocka_unit_test(test_a_chain_of_masses),
        cmocka_unit_test(test_full_matrices),
        cmocka_unit_test(test_a_defective_matrix),
        cmocka_unit_test(test_bad_scales),
        cmocka_unit_test(test_eigenvectors),
        cmocka_unit_test(test_a_string),
        cmocka_unit_test(test_full_modes),
        cmocka_unit_test(test_hilbert),
        cmocka_unit_test(test_complex_equations),
        cmocka_unit_test(test_the_shortest_solution),
        cmocka_unit_test(test_problems_without_an_answer),
        cmocka_unit_test(test_blocks_in_a_ring),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
