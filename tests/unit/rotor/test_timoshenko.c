// The finite element of a shaft, against closed forms and ROSS's printed matrices.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "shafts.h"

static const double pi = 3.14159265358979323846;

static void near(double expected, double obtained, double tolerance) {
    if (fabs(expected - obtained) <= tolerance) return;
    print_error("%.15g is not %.15g: %.2g apart, expected %.2g\n", obtained, expected, fabs(expected - obtained),
                tolerance);
    fail();
}

/// Makes a steel cylinder of 250 mm and a diameter of 50 mm (Friswell et al. 2010, example 5.9.1).
static shaft_piece cylinder(void) {
    return (shaft_piece){.length = 0.25,
                         .outer = {0.05, 0.05},
                         .of = {.modulus = 211e9, .shear_modulus = 81.2e9, .density = 7810.0},
                         .rotary = true};
}

/// The matrices of the plane (x, beta) agree with those that ROSS's tests assert to five decimals.
static void ross_has_the_same_matrices(void **state) {
    static const double mass[4][4] = {{1.42051, 0.04932, 0.49635, -0.03055},
                                      {0.04932, 0.00231, 0.03055, -0.00178},
                                      {0.49635, 0.03055, 1.42051, -0.04932},
                                      {-0.03055, -0.00178, -0.04932, 0.00231}};
    static const double stiffness[4][4] = {{4.56964, 0.57121, -4.56964, 0.57121},
                                           {0.57121, 0.09729, -0.57121, 0.04551},
                                           {-4.56964, -0.57121, 4.56964, -0.57121},
                                           {0.57121, 0.04551, -0.57121, 0.09729}};
    static const double polar[4] = {19.43344, 0.22681, 0.1524, -0.04727};
    const shaft_piece piece = cylinder();
    piece_matrices m;
    (void)state;
    piece_fill(&piece, &m);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            near(mass[i][j], m.mass.at[i][j], 5e-6);
            near(stiffness[i][j], 1e-7 * m.stiffness[0].at[i][j], 5e-6);
        }
    near(polar[0], 1e3 * m.polar.at[0][0], 5e-6);
    near(polar[1], 1e3 * m.polar.at[0][1], 5e-6);
    near(polar[2], 1e3 * m.polar.at[1][1], 5e-5);
    near(polar[3], 1e3 * m.polar.at[1][3], 5e-6);
}

/// Without shear and rotary inertia the matrices are those of the same source and of every textbook.
static void a_slender_one_is_that_of_euler(void **state) {
    static const double mass[4] = {1.42395, 0.0502, 0.49291, -0.02967};
    shaft_piece piece = cylinder();
    piece_matrices m;
    (void)state;
    piece.shear = SHEAR_NONE;
    piece.rotary = false;
    piece_fill(&piece, &m);
    const double l = piece.length, area = pi / 4.0 * 0.05 * 0.05, ei = 211e9 * pi / 64.0 * pow(0.05, 4.0);
    const double first[4] = {12.0 * ei / (l * l * l), 6.0 * ei / (l * l), -12.0 * ei / (l * l * l), 6.0 * ei / (l * l)};
    const double row[4] = {156.0, 22.0 * l, 54.0, -13.0 * l};
    for (int j = 0; j < 4; j++) {
        near(mass[j], m.mass.at[0][j], 5e-6);
        near(first[j], m.stiffness[0].at[0][j], 1e-12 * first[0]);
        near(7810.0 * area * l / 420.0 * row[j], m.mass.at[0][j], 1e-12);
    }
    near(4.0 * ei / l, m.stiffness[0].at[1][1], 1e-6);
    near(2.0 * ei / l, m.stiffness[0].at[1][3], 1e-6);
}

/// Przemieniecki 1968, eq. 5.116: phi = 12 EI/(kappa G A L^2).
static void shear_makes_it_softer_as_it_should(void **state) {
    const shaft_piece piece = cylinder();
    piece_matrices m;
    (void)state;
    piece_fill(&piece, &m);
    const double nu = 211e9 / (2.0 * 81.2e9) - 1.0, kappa = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu);
    const double l = 0.25, area = pi / 4.0 * 0.05 * 0.05, ei = 211e9 * pi / 64.0 * pow(0.05, 4.0);
    const double phi = 12.0 * ei / (kappa * 81.2e9 * area * l * l), k = ei / ((1.0 + phi) * l * l * l);
    near(0.08795566, phi, 1e-8); // as ROSS asserts, in the last digit
    const double expected[4][4] = {
        {12.0, 6.0 * l, -12.0, 6.0 * l},
        {6.0 * l, (4.0 + phi) * l * l, -6.0 * l, (2.0 - phi) * l * l},
        {-12.0, -6.0 * l, 12.0, -6.0 * l},
        {6.0 * l, (2.0 - phi) * l * l, -6.0 * l, (4.0 + phi) * l * l},
    };
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) near(k * expected[i][j], m.stiffness[0].at[i][j], 1e-12 * 12.0 * k);
}

/// The free end of a cone that is clamped at its thick end moves by (64 P L^3)/(3 pi E d_A d_B^3) (Gere, Timoshenko
/// 1984, 9.7); it weighs what a frustum does.
static void a_cone_is_a_cone(void **state) {
    shaft_piece piece = cylinder();
    piece_matrices m;
    (void)state;
    piece.shear = SHEAR_NONE;
    piece.outer[1] = 0.02;
    piece_fill(&piece, &m);
    // Clamped at its left end: K of the right end's two coordinates, inverted for a force.
    const double a = m.stiffness[0].at[2][2], b = m.stiffness[0].at[2][3], d = m.stiffness[0].at[3][3];
    const double moved = d / (a * d - b * b);
    const double expected = 64.0 * pow(0.25, 3.0) / (3.0 * pi * 211e9 * 0.02 * pow(0.05, 3.0));
    near(1.0, moved / expected, 1e-9);
    const double frustum = 7810.0 * pi / 12.0 * 0.25 * (0.05 * 0.05 + 0.05 * 0.02 + 0.02 * 0.02);
    near(frustum, m.weight[0] + m.weight[2], 1e-12);
    near(frustum, m.lumped_mass[0] + m.lumped_mass[1], 1e-12);
}

/// The inertia of a strip between two flats agrees with a sum over thin slices.
static void flats_take_away_what_they_cut(void **state) {
    enum { SLICES = 2000000 };
    shaft_piece piece = cylinder();
    piece_matrices m;
    double area = 0.0, along = 0.0, across = 0.0;
    (void)state;
    piece.shear = SHEAR_NONE;
    piece.flats = 0.04;
    piece.inner[0] = piece.inner[1] = 0.01;
    piece_fill(&piece, &m);
    for (int i = 0; i < SLICES; i++) {
        const double y = 0.04 * ((i + 0.5) / SLICES - 0.5), half = sqrt(0.025 * 0.025 - y * y), part = 0.04 / SLICES;
        area += 2.0 * half * part;
        along += 2.0 * half * y * y * part;
        across += 2.0 / 3.0 * half * half * half * part;
    }
    const double bore = pi / 64.0 * 1e-8, l = 0.25, k = 12.0 * 211e9 / (l * l * l);
    near(1.0, m.stiffness[0].at[0][0] / (k * (across - bore)), 1e-10);
    near(1.0, m.stiffness[1].at[0][0] / (k * (along - bore)), 1e-10);
    near(1.0, (m.weight[0] + m.weight[2]) / (7810.0 * l * (area - pi / 4.0 * 1e-4)), 1e-10);
}

/// The stiffness of a piece under tension is that of a string for displacements that lean it as a whole: N/L.
static void an_axial_force_pulls_it_straight(void **state) {
    shaft_piece piece = cylinder();
    piece_matrices m;
    (void)state;
    piece.shear = SHEAR_NONE;
    piece.axial[0] = piece.axial[1] = 3e4;
    piece_fill(&piece, &m);
    // 6N/(5L), N/10, 2NL/15, -NL/30 (Przemieniecki 1968, eq. 15.30)
    near(6.0 * 3e4 / (5.0 * 0.25), m.axial.at[0][0], 1e-9);
    near(3e4 / 10.0, m.axial.at[0][1], 1e-9);
    near(2.0 * 3e4 * 0.25 / 15.0, m.axial.at[1][1], 1e-9);
    near(-3e4 * 0.25 / 30.0, m.axial.at[1][3], 1e-9);
}

/// A cantilever bent by a force at its end: w = P (3 L z^2 - z^3)/(6 EI) + P z/(kappa G A), and its section turns by
/// P (L z - z^2/2)/EI. Without mass on it that is what the piece does between its ends.
static void it_bends_between_its_ends_as_a_cantilever(void **state) {
    const shaft_piece piece = cylinder();
    const double l = piece.length, second = pi / 64.0 * pow(0.05, 4.0), area = pi / 4.0 * 0.05 * 0.05, force = 1e3;
    const double nu = 211.0 / (2.0 * 81.2) - 1.0, factor = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu); // Cowper 1966
    const double bend = force / (211e9 * second), slip = force / (factor * 81.2e9 * area);
    const double end[4] = {0.0, 0.0, bend * l * l * l / 3.0 + slip * l, bend * l * l / 2.0};
    (void)state;
    for (int i = 0; i <= 10; i++) {
        const double z = 0.1 * i * l;
        double moved[4], sum = 0.0;
        piece_shape(&piece, 0.1 * i, moved);
        for (int k = 0; k < 4; k++) sum += moved[k] * end[k];
        near(bend * (3.0 * l * z * z - z * z * z) / 6.0 + slip * z, sum, 1e-12 * end[2]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_bends_between_its_ends_as_a_cantilever),
        cmocka_unit_test(ross_has_the_same_matrices),
        cmocka_unit_test(a_slender_one_is_that_of_euler),
        cmocka_unit_test(shear_makes_it_softer_as_it_should),
        cmocka_unit_test(a_cone_is_a_cone),
        cmocka_unit_test(flats_take_away_what_they_cut),
        cmocka_unit_test(an_axial_force_pulls_it_straight),
    };
    return cmocka_run_group_tests_name("timoshenko", tests, NULL, NULL);
}
