// The monotone cubic between points, and bearings whose coefficients follow from it.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "table.h"
#include "whirl/engine/rotor.h"

static void near(double found, double expected) {
    if (!(fabs(found - expected) <= 1e-13 * fmax(1.0, fabs(expected))))
        fail_msg("%.17g, expected %.17g", found, expected);
}

/// A table on a straight line gives the line, also with two points; every table passes through its points.
static void test_lines(void **state) {
    static const double x[] = {1.0, 1.5, 4.0, 4.25, 9.0};
    double y[5];
    (void)state;
    for (int i = 0; i < 5; i++) y[i] = 3.0 - 2.0 * x[i];
    for (double at = 1.0; at <= 9.0; at += 0.125) {
        near(table_value(5, x, y, at), 3.0 - 2.0 * at);
        near(table_value(2, (double[]){1.0, 9.0}, (double[]){1.0, -15.0}, at), 3.0 - 2.0 * at);
    }
    for (int i = 0; i < 5; i++) {
        const double wild[] = {2.0, -1.0, 5.0, 5.0, 0.5};
        near(table_value(5, x, wild, x[i]), wild[i]);
    }
}

/// The slopes are those computed by hand. Points (0, 0), (1, 1), (2, 3): rises 1 and 2; in the middle 2 1 2/(1 + 2) =
/// 4/3, at the ends (3 1 - 2)/2 = 1/2 and (3 2 - 1)/2 = 5/2. Half-way a cubic is (y0 + y1)/2 + h (m0 - m1)/8.
static void test_slopes_by_hand(void **state) {
    static const double x[] = {0.0, 1.0, 2.0}, y[] = {0.0, 1.0, 3.0};
    (void)state;
    near(table_value(3, x, y, 0.5), 0.5 + (0.5 - 4.0 / 3.0) / 8.0);
    near(table_value(3, x, y, 1.5), 2.0 + (4.0 / 3.0 - 2.5) / 8.0);
    // Unequal steps 1 and 3 with rises 1 and 2: (a + b)/(a/1 + b/2), a = 2 3 + 1, b = 3 + 2 1; ends (5 1 - 2)/4 and
    // (7 2 - 3 1)/4.
    static const double wide[] = {0.0, 1.0, 4.0}, high[] = {0.0, 1.0, 7.0};
    const double middle = 12.0 / (7.0 + 5.0 / 2.0);
    near(table_value(3, wide, high, 0.5), 0.5 + (0.75 - middle) / 8.0);
    near(table_value(3, wide, high, 2.5), 4.0 + 3.0 * (middle - 2.75) / 8.0);
}

/// Between rising points the table never falls, and no value exceeds the extremes of the points.
static void test_monotone(void **state) {
    static const double x[] = {0.0, 1.0, 1.1, 3.0, 3.2, 7.0}, y[] = {0.0, 0.01, 5.0, 5.1, 40.0, 40.0};
    double before = 0.0;
    (void)state;
    for (int i = 0; i <= 7000; i++) {
        const double value = table_value(6, x, y, i / 1000.0);
        assert_true(value >= before - 1e-13 && value <= 40.0 + 1e-13);
        before = value;
    }
}

// ---------------------------------------------------------------- bearings

static whirl_status build(double speed, const whirl_setting *bearing, size_t count, whirl_rotor **rotor) {
    whirl_design *design;
    *rotor = NULL;
    whirl_status status = whirl_design_new(speed, 1.0, &design);
    assert_int_equal(status.code, WHIRL_OK);
    status = whirl_design_station(design, "disc", (whirl_setting[]){{"mass", 2.0, NULL}}, 1);
    if (status.code == WHIRL_OK) status = whirl_design_element(design, "bearing", bearing, count);
    if (status.code == WHIRL_OK) status = whirl_rotor_new(design, rotor);
    whirl_design_free(design);
    return status;
}

/// Accelerations at x = 1, y = 2, x' = 3, y' = 4 times mass and speed squared: forces in newtons.
static void test_bearing(void **state) {
    static const double x[] = {10.0, 20.0, 40.0};
    static const double kxx[] = {4.0, 8.0, 9.0}, kxy[] = {-1.0, 0.0, 3.0}, cxx[] = {7.0, 5.0, 4.0};
    const whirl_setting settings[] = {{"at", 0, "disc"},      {"speeds", 0, "10, 20, 40"}, {"kxx", 0, "4,8, 9"},
                                      {"kxy", 0, "-1, 0, 3"}, {"kyy", 2.5, NULL},          {"cxx", 0, "7 , 5 ,4"}};
    (void)state;
    for (double speed = 10.0; speed <= 40.0; speed += 2.5) {
        const double start[] = {1.0, 2.0, 3.0, 4.0};
        double forcing[WHIRL_MAX_FORCING] = {0}, slope[4];
        whirl_rotor *rotor;
        assert_int_equal(build(speed, settings, 6, &rotor).code, WHIRL_OK);
        const whirl_system *system = whirl_rotor_system(rotor);
        system->rhs(system->model, 0.0, forcing, start, slope);
        const double c = table_value(3, x, cxx, speed);
        const double fx = -table_value(3, x, kxx, speed) - 2.0 * table_value(3, x, kxy, speed) - 3.0 * c * speed;
        near(slope[2] * 2.0 * speed * speed, fx);
        near(slope[3] * 2.0 * speed * speed, -2.0 * 2.5 - 4.0 * c * speed);
        whirl_rotor_free(rotor);
    }
}

/// A bearing with masses between a disc of 2 kg and the ground: (M + m) a = f, by Cramer's rule; at 10 rad/s where m_xx
/// has a table.
static void test_inertia_on_the_ground(void **state) {
    const whirl_setting settings[] = {{"at", 0, "disc"},   {"speeds", 0, "0, 10, 40"}, {"mxx", 0, "9, 3, 1"},
                                      {"mxy", -0.5, NULL}, {"myy", 1.5, NULL},         {"kxx", 7.0, NULL},
                                      {"kyy", 11.0, NULL}};
    const double start[] = {1.0, 2.0, 0.0, 0.0}, speed = 10.0;
    const double a = 2.0 + 3.0, b = -0.5, d = 2.0 + 1.5, fx = -7.0, fy = -22.0;
    double forcing[WHIRL_MAX_FORCING] = {0}, slope[4];
    whirl_rotor *rotor;
    (void)state;
    assert_int_equal(build(speed, settings, 7, &rotor).code, WHIRL_OK);
    const whirl_system *system = whirl_rotor_system(rotor);
    system->rhs(system->model, 0.0, forcing, start, slope);
    near(slope[2] * speed * speed * (a * d - b * b), d * fx - b * fy);
    near(slope[3] * speed * speed * (a * d - b * b), a * fy - b * fx);
    whirl_rotor_free(rotor);
}

/// Between a disc and its housing the forces are opposite, and the mass of the bearing resists m (a - a').
static void test_inertia_in_a_housing(void **state) {
    const whirl_setting settings[] = {{"at", 0, "disc"},  {"from", 0, "housing"}, {"mxx", 3.0, NULL},
                                      {"mxy", 0.7, NULL}, {"myy", 1.2, NULL},     {"kxx", 7.0, NULL},
                                      {"kyy", 11.0, NULL}};
    const double start[8] = {1.0, 2.0, 0.25, -0.5}, speed = 1.0;
    double forcing[WHIRL_MAX_FORCING] = {0}, slope[8];
    whirl_design *design;
    whirl_rotor *rotor;
    (void)state;
    assert_int_equal(whirl_design_new(speed, 1.0, &design).code, WHIRL_OK);
    assert_int_equal(whirl_design_station(design, "disc", (whirl_setting[]){{"mass", 2.0, NULL}}, 1).code, WHIRL_OK);
    assert_int_equal(whirl_design_station(design, "housing", (whirl_setting[]){{"mass", 5.0, NULL}}, 1).code, WHIRL_OK);
    assert_int_equal(whirl_design_element(design, "bearing", settings, 7).code, WHIRL_OK);
    assert_int_equal(whirl_rotor_new(design, &rotor).code, WHIRL_OK);
    whirl_design_free(design);
    const whirl_system *system = whirl_rotor_system(rotor);
    system->rhs(system->model, 0.0, forcing, start, slope);
    const double *a = slope + 4;
    const double rx = a[0] - a[2], ry = a[1] - a[3];
    for (int axis = 0; axis < 2; axis++) near(2.0 * a[axis], -5.0 * a[2 + axis]);
    near(2.0 * a[0], -7.0 * (1.0 - 0.25) - 3.0 * rx - 0.7 * ry);
    near(2.0 * a[1], -11.0 * (2.0 + 0.5) - 0.7 * rx - 1.2 * ry);
    whirl_rotor_free(rotor);
}

/// Tables over speed and frequency: along the frequencies at every speed, then along the speeds; beyond the frequencies
/// their ends, and the shaft's own where none is asked for.
static void test_two_axes(void **state) {
    static const double speeds[] = {10.0, 20.0, 40.0}, frequencies[] = {5.0, 15.0, 30.0, 50.0};
    static const double kxx[3][4] = {{4.0, 8.0, 9.0, 1.0}, {2.0, 3.0, 7.0, 7.5}, {1.0, 5.0, 2.0, 8.0}};
    const whirl_setting settings[] = {{"at", 0, "disc"},
                                      {"speeds", 0, "10, 20, 40"},
                                      {"frequencies", 0, "5, 15, 30, 50"},
                                      {"kxx", 0, "4, 8, 9, 1; 2, 3, 7, 7.5; 1, 5, 2, 8"}};
    const double start[] = {1.0, 0.0, 0.0, 0.0};
    (void)state;
    for (double speed = 10.0; speed <= 40.0; speed += 2.5)
        for (double frequency = 0.0; frequency <= 60.0; frequency += 2.5) {
            const bool own = frequency == 60.0; // the shaft's
            const double at = own ? speed : fmin(fmax(frequency, 5.0), 50.0);
            double forcing[WHIRL_MAX_FORCING] = {0}, slope[4], rows[3];
            whirl_design *design;
            whirl_rotor *rotor;
            assert_int_equal(whirl_design_new(speed, 1.0, &design).code, WHIRL_OK);
            assert_int_equal(whirl_design_station(design, "disc", (whirl_setting[]){{"mass", 2.0, NULL}}, 1).code,
                             WHIRL_OK);
            assert_int_equal(whirl_design_element(design, "bearing", settings, 4).code, WHIRL_OK);
            if (!own) whirl_design_frequency(design, frequency);
            assert_int_equal(whirl_rotor_new(design, &rotor).code, WHIRL_OK);
            whirl_design_free(design);
            const whirl_system *system = whirl_rotor_system(rotor);
            assert_int_equal(system->frequency_count, 4);
            near(system->frequencies[0], 5.0);
            near(system->frequencies[3], 50.0);
            system->rhs(system->model, 0.0, forcing, start, slope);
            for (size_t i = 0; i < 3; i++) rows[i] = table_value(4, frequencies, kxx[i], at);
            near(slope[2] * 2.0 * speed * speed, -table_value(3, speeds, rows, speed));
            whirl_rotor_free(rotor);
        }
}

static void test_refused(void **state) {
    static const struct {
        double speed;
        whirl_setting settings[3];
        size_t count;
        const char *words;
    } cases[] = {
        {9.0, {{"at", 0, "disc"}, {"speeds", 0, "10, 20"}, {"kxx", 0, "1, 2"}}, 3, "known from 10 to 20 rad/s"},
        {21.0, {{"at", 0, "disc"}, {"speeds", 0, "10, 20"}, {"kxx", 0, "1, 2"}}, 3, "turns at 21 rad/s"},
        {15.0, {{"at", 0, "disc"}, {"speeds", 0, "10, 20"}, {"kxx", 0, "1, 2, 3"}}, 3, "3 kxx at 2 speeds"},
        {15.0, {{"at", 0, "disc"}, {"speeds", 0, "20, 10"}, {"kxx", 0, "1, 2"}}, 3, "do not rise"},
        {15.0, {{"at", 0, "disc"}, {"speeds", 10, NULL}, {"kxx", 1, NULL}}, 3, "two or more"},
        {15.0, {{"at", 0, "disc"}, {"kxx", 0, "1, 2"}}, 2, "without speeds"},
        {15.0, {{"at", 0, "disc"}, {"kxx", 0, "1: 2"}}, 2, "no list"},
        {15.0, {{"at", 0, "disc"}, {"kxx", 0, "1, 2; 3"}}, 2, "lists of 2 and of 1 numbers"},
        {15.0, {{"at", 0, "disc"}, {"speeds", 0, "10, 20; 10, 20"}, {"kxx", 0, "1, 2"}}, 3, "expected a single list"},
        {15.0, {{"at", 0, "disc"}, {"speeds", 0, "10, 20"}, {"kxx", 0, "1, 2; 3, 4"}}, 3, "without frequencies"},
        {15.0, {{"at", 0, "disc"}, {"frequencies", 0, "10, 20"}, {"kxx", 0, "1, 2; 3, 4"}}, 3, "without speeds"},
        {15.0, {{"at", 0, "disc"}, {"frequencies", 0, "10, 20"}, {"kxx", 0, "1, 2, 3"}}, 3, "3 kxx at 2 frequencies"},
        {15.0,
         {{"at", 0, "disc"}, {"frequencies", 0, "20, 10"}, {"kxx", 0, "1, 2"}},
         3,
         "frequencies that do not rise"},
        {15.0, {{"at", 0, "disc"}, {"frequencies", 10, NULL}, {"kxx", 1, NULL}}, 3, "single number of frequencies"},
        {15.0, {{"at", 0, "disc"}, {"speeds", 0, "-1, 2"}}, 2, "at least 0 rad/s"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        whirl_rotor *rotor;
        const whirl_status status = build(cases[i].speed, cases[i].settings, cases[i].count, &rotor);
        assert_null(rotor);
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        if (!strstr(status.message, cases[i].words)) fail_msg("'%s' lacks '%s'", status.message, cases[i].words);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lines),
        cmocka_unit_test(test_slopes_by_hand),
        cmocka_unit_test(test_monotone),
        cmocka_unit_test(test_bearing),
        cmocka_unit_test(test_two_axes),
        cmocka_unit_test(test_refused),
        cmocka_unit_test(test_inertia_on_the_ground),
        cmocka_unit_test(test_inertia_in_a_housing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
