// Rotors of ROSS with couplings: all eigenvalues of the imported case against those of matrices put together here.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_dense.h"
#include "support_import.h"

static const double pi = 3.14159265358979323846, speed = 300.0;

// ---------------------------------------------------------------- matrices

/// Coordinates of a node: displacements and slopes in both planes.
enum { X, SLOPE_X, Y, SLOPE_Y, PER_NODE };
enum { MAX_DEGREES = 9 * PER_NODE };

/// lambda^2 M + lambda C + K; C has the gyroscopic moments.
typedef struct pencil {
    size_t size;
    double mass[MAX_DEGREES][MAX_DEGREES], damping[MAX_DEGREES][MAX_DEGREES], stiffness[MAX_DEGREES][MAX_DEGREES];
} pencil;

/// Adds I_d phi'' - i I_p Omega phi' of phi = slope_x + i slope_y, or of displacements that lean sections.
static void add_gyroscopic(pencil *to, size_t x, size_t y, size_t by_x, size_t by_y, double polar) {
    to->damping[x][by_y] += speed * polar;
    to->damping[y][by_x] -= speed * polar;
}

/// Adds a steel cylinder with consistent mass and Cowper's shear factor (Friswell et al. 2010, sec. 5.4.3).
static void add_cylinder(pencil *to, size_t node, double l, double diameter) {
    const double e = 211e9, g = 81.2e9, nu = e / (2.0 * g) - 1.0, kappa = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu);
    const double area = pi / 4.0 * pow(diameter, 2.0), second = pi / 64.0 * pow(diameter, 4.0);
    const double phi = 12.0 * e * second / (kappa * g * area * l * l), p2 = phi * phi;
    const double k = e * second / ((1.0 + phi) * l * l * l);
    const double m = 7810.0 * area * l / (840.0 * (1.0 + phi) * (1.0 + phi));
    const double r = 7810.0 * second / (30.0 * l * (1.0 + phi) * (1.0 + phi));
    const double m1 = 312.0 + 588.0 * phi + 280.0 * p2, m2 = (44.0 + 77.0 * phi + 35.0 * p2) * l;
    const double m3 = 108.0 + 252.0 * phi + 140.0 * p2, m4 = (26.0 + 63.0 * phi + 35.0 * p2) * l;
    const double m5 = (8.0 + 14.0 * phi + 7.0 * p2) * l * l, m6 = (6.0 + 14.0 * phi + 7.0 * p2) * l * l;
    const double r1 = (3.0 - 15.0 * phi) * l, r2 = (4.0 + 5.0 * phi + 10.0 * p2) * l * l;
    const double r3 = (-1.0 - 5.0 * phi + 5.0 * p2) * l * l, k4 = (4.0 + phi) * l * l, k2 = (2.0 - phi) * l * l;
    const double moved[4][4] = {{m1, m2, m3, -m4}, {m2, m5, m4, -m6}, {m3, m4, m1, -m2}, {-m4, -m6, -m2, m5}};
    const double leant[4][4] = {{36.0, r1, -36.0, r1}, {r1, r2, -r1, r3}, {-36.0, -r1, 36.0, -r1}, {r1, r3, -r1, r2}};
    const double bent[4][4] = {{12.0, 6.0 * l, -12.0, 6.0 * l},
                               {6.0 * l, k4, -6.0 * l, k2},
                               {-12.0, -6.0 * l, 12.0, -6.0 * l},
                               {6.0 * l, k2, -6.0 * l, k4}};
    for (size_t i = 0; i < 4; i++)
        for (size_t j = 0; j < 4; j++) {
            const size_t row = (node + i / 2) * PER_NODE + i % 2, column = (node + j / 2) * PER_NODE + j % 2;
            for (size_t plane = 0; plane <= Y; plane += Y) {
                to->mass[row + plane][column + plane] += m * moved[i][j] + r * leant[i][j];
                to->stiffness[row + plane][column + plane] += k * bent[i][j];
            }
            add_gyroscopic(to, row, row + Y, column, column + Y, 2.0 * r * leant[i][j]);
        }
}

static void add_weight(pencil *to, size_t node, double mass, double diametral, double polar) {
    const size_t at = node * PER_NODE;
    for (size_t plane = 0; plane <= Y; plane += Y) {
        to->mass[at + plane + X][at + plane + X] += mass;
        to->mass[at + plane + SLOPE_X][at + plane + SLOPE_X] += diametral;
    }
    add_gyroscopic(to, at + SLOPE_X, at + SLOPE_Y, at + SLOPE_X, at + SLOPE_Y, polar);
}

static void add_bearing(pencil *to, size_t node, double kxx, double kyy, double cross, double cxx, double cyy) {
    const size_t x = node * PER_NODE + X, y = node * PER_NODE + Y;
    to->stiffness[x][x] += kxx;
    to->stiffness[y][y] += kyy;
    to->stiffness[x][y] += cross;
    to->stiffness[y][x] -= cross;
    to->damping[x][x] += cxx;
    to->damping[y][y] += cyy;
}

/// Springs and dampers between the same coordinates of two nodes, and what both ends weigh.
typedef struct coupling {
    size_t node;
    double mass[2], diametral[2], polar[2];
    double stiffness[PER_NODE], damping[PER_NODE]; ///< x, slope along x, y, slope along y
} coupling;

static void add_coupling(pencil *to, const coupling *from) {
    for (size_t end = 0; end < 2; end++)
        add_weight(to, from->node + end, from->mass[end], from->diametral[end], from->polar[end]);
    for (size_t c = 0; c < PER_NODE; c++) {
        const size_t one = from->node * PER_NODE + c, other = one + PER_NODE;
        const size_t place[4][2] = {{one, one}, {other, other}, {one, other}, {other, one}};
        for (size_t i = 0; i < 4; i++) {
            const double sign = i < 2 ? 1.0 : -1.0;
            to->stiffness[place[i][0]][place[i][1]] += sign * from->stiffness[c];
            to->damping[place[i][0]][place[i][1]] += sign * from->damping[c];
        }
    }
}

/// Adds the machine of tests/rotors/coupled.toml without its coupling.
static void add_machine(pencil *to) {
    for (size_t node = 0; node < 3; node++) add_cylinder(to, node, 0.2, 0.06);
    for (size_t node = 4; node < 7; node++) add_cylinder(to, node, 0.15, 0.05);
    add_weight(to, 1, 30.0, 0.3, 0.5);
    add_weight(to, 6, 12.0, 0.06, 0.1);
    add_bearing(to, 0, 3e7, 4e7, 0.0, 900.0, 1000.0);
    add_bearing(to, 2, 3e7, 4e7, 0.0, 900.0, 1000.0);
    add_bearing(to, 4, 2e7, 2.5e7, 3e6, 1500.0, 1600.0);
    add_bearing(to, 7, 2e7, 2.5e7, 3e6, 1500.0, 1600.0);
}

// ---------------------------------------------------------------- their eigenvalues

/// Returns the eigenvalue that Newton's method finds from a number near it (Ruhe 1973): y = P^-1 P' x, less x over y.
/// It stops before P is singular to the last bit.
static double complex eigenvalue_near(const pencil *of, double complex lambda) {
    static double complex a[MAX_DEGREES][MAX_DEGREES], x[MAX_DEGREES], y[MAX_DEGREES];
    const size_t n = of->size;
    double complex above = 1.0, below = 1e6 / lambda;
    for (size_t i = 0; i < n; i++) x[i] = 1.0 + 0.1 * (double)i;
    lambda *= 1.0 + 1e-6;
    for (int step = 0; step < 20 && cabs(above / below) > 1e-13 * cabs(lambda); step++) {
        above = below = 0.0;
        for (size_t i = 0; i < n; i++) {
            y[i] = 0.0;
            for (size_t j = 0; j < n; j++) {
                a[i][j] = (lambda * of->mass[i][j] + of->damping[i][j]) * lambda + of->stiffness[i][j];
                y[i] += (2.0 * lambda * of->mass[i][j] + of->damping[i][j]) * x[j];
            }
        }
        solve_dense(n, MAX_DEGREES, &a[0][0], y);
        for (size_t i = 0; i < n; i++) {
            above += conj(x[i]) * x[i];
            below += conj(x[i]) * y[i];
        }
        lambda -= above / below;
        double size = 0.0;
        for (size_t i = 0; i < n; i++) size = fmax(size, cabs(y[i]));
        for (size_t i = 0; i < n; i++) x[i] = y[i] / size;
    }
    return lambda;
}

// ---------------------------------------------------------------- the imported case

static char *read_rotor(const char *more) {
    FILE *const file = fopen(WHIRL_CASES "/../tests/rotors/coupled.toml", "r");
    char *const text = calloc(1, 1 << 16);
    assert_non_null(file);
    assert_true(fread(text, 1, 1 << 15, file) > 0);
    fclose(file);
    return strcat(text, more);
}

/// Writes all modes, in rad/s, and returns their number.
static size_t all_modes(const char *rotor, double complex found[MAX_DEGREES]) {
    whirl_imported imported;
    double clock;
    require_ok(whirl_import_parse(rotor, strlen(rotor), "coupled.toml", &imported));
    char *const text = whole_case(&imported);
    whirl_case *const object = parse_case(text);
    whirl_modes *const modes = modes_at(object, speed, &clock);
    const size_t count = modes->count;
    assert_true(count <= MAX_DEGREES && modes->real_count == 0 && modes->free == 0);
    for (size_t i = 0; i < count; i++) found[i] = clock * (modes->modes[i].real + I * modes->modes[i].imaginary);
    whirl_modes_free(modes);
    whirl_case_free(object);
    free(text);
    return count;
}

/// Checks that every mode is an eigenvalue, no two are equal, and none is missing.
static void check_modes(const char *what, const char *text, const pencil *of) {
    double complex found[MAX_DEGREES], exact[MAX_DEGREES];
    double worst = 0.0;
    const size_t count = all_modes(text, found);
    check_within("Import", words("%s: modes", what), (double)of->size, (double)count, 0.0);
    for (size_t i = 0; i < count; i++) {
        exact[i] = eigenvalue_near(of, found[i]);
        assert_true(isfinite(cabs(exact[i])));
        worst = fmax(worst, cabs(found[i] / exact[i] - 1.0));
        for (size_t j = 0; j < i; j++) assert_true(cabs(exact[i] - exact[j]) > 1e-6 * cabs(exact[i]));
    }
    check_within("Import", words("%s: eigenvalues, largest relative difference", what), 0.0, worst, 1e-9);
}

// ---------------------------------------------------------------- machines

static const coupling plain = {.node = 3,
                               .mass = {4.0, 5.5},
                               .diametral = {0.012, 0.015},
                               .polar = {0.02, 0.03},
                               .stiffness = {2e7, 5e4, 2e7, 5e4},
                               .damping = {150.0, 2.0, 150.0, 2.0}};

static void test_coupled(void **state) {
    pencil matrices = {.size = 8 * PER_NODE};
    char *const text = read_rotor("");
    (void)state;
    add_machine(&matrices);
    add_coupling(&matrices, &plain);
    check_modes("coupled shafts", text, &matrices);
    free(text);
}

/// A coupling that differs in x and y becomes a bearing between both shafts. Its inertia about a diameter is half the
/// polar one if the file has none.
static void test_unequal(void **state) {
    pencil matrices = {.size = 8 * PER_NODE};
    coupling unequal = plain;
    char *text = replace_all(read_rotor(""), "kt_y = 20000000.0", "kt_y = 31000000.0");
    (void)state;
    text = replace_all(replace_all(text, "ct_x = 150.0", "ct_x = 0"), "Id_l = 0.012", "Id_l = 0");
    unequal.stiffness[Y] = 3.1e7;
    unequal.damping[X] = 0.0;
    unequal.diametral[0] = 0.01;
    add_machine(&matrices);
    add_coupling(&matrices, &unequal);
    check_modes("unequal coupling", text, &matrices);
    free(text);
}

/// Another coupling parallel to a piece of shaft, and one whose far end is free.
static void test_more_couplings(void **state) {
    static const coupling beside = {.node = 1, .stiffness = {3e6, 2e5, 3e6, 2e5}};
    static const coupling free_end = {.node = 7,
                                      .mass = {0.0, 2.0},
                                      .diametral = {0.0, 0.004},
                                      .polar = {0.0, 0.008},
                                      .stiffness = {4e6, 9e3, 4e6, 9e3},
                                      .damping = {20.0, 0.0, 20.0, 0.0}};
    pencil matrices = {.size = 9 * PER_NODE};
    char *const text = read_rotor("[CouplingElement_Sleeve]\nm_l = 0\nm_r = 0\nIp_l = 0\nIp_r = 0\nkt_x = 3e6\n"
                                  "kt_y = 3e6\nkr_x = 2e5\nkr_y = 2e5\nn = 1\n"
                                  "[CouplingElement_Half]\nm_l = 0\nm_r = 2\nIp_l = 0\nIp_r = 0.008\nkt_x = 4e6\n"
                                  "kt_y = 4e6\nkr_x = 9e3\nkr_y = 9e3\nct_x = 20\nct_y = 20\nn = 7\n");
    (void)state;
    add_machine(&matrices);
    add_coupling(&matrices, &plain);
    add_coupling(&matrices, &beside);
    add_coupling(&matrices, &free_end);
    check_modes("three couplings", text, &matrices);
    free(text);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_coupled), cmocka_unit_test(test_unequal),
                                       cmocka_unit_test(test_more_couplings)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
