// Blades that pass a casing: many are a ring, orders of passing, single blades, the derivative.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "whirl/engine/rotor.h"

static const double pi = 3.14159265358979323846;
enum { STATES = 9 };

/// Makes a rotor with blades: radius 50, gap 1 and a mass of 1 at speed 1, in a casing of mass 2.
static whirl_rotor *make(double blades, double power, const char *stiffness, const char *extension, double friction) {
    const whirl_setting settings[] = {{"at", 0.0, "disc"},          {"from", 0.0, "casing"},
                                      {"blades", blades, NULL},     {"radius", 50.0, NULL},
                                      {"gap", 1.0, NULL},           {"power", power, NULL},
                                      {"friction", friction, NULL}, {"stiffness", 0.0, stiffness},
                                      {"extension", 0.0, extension}};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(1.0, 1.0, &design));
    require_ok(whirl_design_station(design, "disc", (whirl_setting[]){{"mass", 1.0, NULL}}, 1));
    require_ok(whirl_design_station(design, "casing", (whirl_setting[]){{"mass", 2.0, NULL}}, 1));
    require_ok(whirl_design_element(design, "blade_rub", settings, 9));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Computes the force on the disc, displaced by x from the casing, with the blades turned by an angle.
static void force_at(const whirl_rotor *rotor, double x, double angle, double force[2]) {
    const double state[STATES] = {0.3 + x, -0.2, 0.3, -0.2, 0.0, 0.0, 0.0, 0.0, angle};
    double slope[STATES];
    evaluate_rhs(whirl_rotor_system(rotor), 0.0, state, slope);
    for (int i = 0; i < 2; i++) {
        force[i] = slope[4 + i];
        assert_true(fabs(slope[4 + i] + 2.0 * slope[6 + i]) < 1e-12);
    }
}

/// Equal blades at all angles are a ring: n k/(2 pi) times the integral of (r cos t - gap) cos t where it is above 0.
static void many_blades(void **unused) {
    (void)unused;
    const double r = 1.8, k = 3.0, middle = acos(1.0 / r);
    const double ring = k / (2.0 * pi) * (r * middle - sin(middle));
    static const double ripples[4] = {0.05, 0.02, 5e-3, 1e-3};
    for (int n = 0; n < 4; n++) {
        enum { ANGLES = 64 };
        const int blades = 16 << n;
        whirl_rotor *rotor = make(blades, 1.0, "3", "0", 0.2);
        double mean = 0.0, low = INFINITY, high = 0.0, force[2];
        for (int i = 0; i < ANGLES; i++) {
            force_at(rotor, r, 2.0 * pi / blades * i / ANGLES, force);
            mean -= force[0] / ANGLES;
            low = fmin(low, -force[0]);
            high = fmax(high, -force[0]);
        }
        check_within("blade-rub", words("%d blades: ripple of the force over its mean", blades), 0.0,
                     (high - low) / mean, ripples[n]);
        whirl_rotor_free(rotor);
    }
    // Tips go round the disc's centre: angles at the casing differ by r/l, so that the ring is that of the law of 1/l.
    whirl_rotor *rotor = make(128, 1.0, "3", "0", 0.2);
    double mean[2] = {0.0}, force[2], exact[2] = {0.0};
    enum { FINE = 4096 };
    for (int i = 0; i < FINE; i++) {
        const double t = 2.0 * pi * (i + 0.5) / FINE, x = r + 50.0 * cos(t), y = 50.0 * sin(t),
                     depth = hypot(x, y) - 51.0;
        if (depth <= 0.0) continue;
        exact[0] -= 128.0 * k / FINE * depth * (x - 0.2 * y) / hypot(x, y);
        exact[1] -= 128.0 * k / FINE * depth * (y + 0.2 * x) / hypot(x, y);
    }
    for (int i = 0; i < 64; i++) {
        force_at(rotor, r, 2.0 * pi / 128.0 * i / 64.0, force);
        for (int a = 0; a < 2; a++) mean[a] += force[a] / 64.0;
    }
    check_within("blade-rub", "128 blades: mean force along the displacement, from the integral over the ring",
                 exact[0], mean[0], 1e-4 * fabs(exact[0]));
    check_within("blade-rub", "128 blades: mean friction, from the integral over the ring", exact[1], mean[1],
                 1e-4 * fabs(exact[1]));
    check_within("blade-rub", "128 blades: radial force over that of a ring of any radius", 1.0,
                 -mean[0] / (128.0 * ring), 0.03);
    whirl_rotor_free(rotor);
}

/// Returns the amplitude of an order of the force on a disc that is held at a displacement.
static double order_of(const whirl_rotor *rotor, double x, int order) {
    enum { ANGLES = 2100 }; // a multiple of 7, so that orders fold onto those of its passing
    double complex sum = 0.0;
    double force[2];
    for (int i = 0; i < ANGLES; i++) {
        const double angle = 2.0 * pi * i / ANGLES;
        force_at(rotor, x, angle, force);
        sum += 2.0 / ANGLES * force[0] * cexp(-I * (order * angle));
    }
    return cabs(sum);
}

static void orders(void **unused) {
    (void)unused;
    whirl_rotor *alike = make(7, 1.5, "2", "0", 0.0);
    whirl_rotor *one = make(7, 1.5, "2", "0.1, 0, 0, 0, 0, 0, 0", 0.0);
    double others = 0.0;
    for (int order = 1; order < 14; order++)
        if (order != 7) others = fmax(others, order_of(alike, 1.4, order));
    check_within("blade-rub", "7 blades alike: force of orders 1 to 13 but 7", 0.0, others, 1e-12);
    check_holds("blade-rub", "7 blades alike: the order of their passing, 7X, is there",
                order_of(alike, 1.4, 7) > 1e-3);
    check_holds("blade-rub", "one blade longer: 1X is there, too", order_of(one, 1.4, 1) > 0.01);
    assert_int_equal(whirl_rotor_system(alike)->repeats, 1);
    // A single blade: Hertz's law at the depth x + e l - l - gap, exactly.
    whirl_rotor *single = make(1, 1.5, "2", "0.1", 0.3);
    double force[2];
    force_at(single, 1.4, 0.0, force);
    check_within("blade-rub", "one blade under the displacement: force", -2.0 * pow(0.5, 1.5), force[0], 1e-12);
    check_within("blade-rub", "one blade under the displacement: friction", -0.6 * pow(0.5, 1.5), force[1], 1e-12);
    whirl_rotor_free(alike);
    whirl_rotor_free(one);
    whirl_rotor_free(single);
}

static void derivative(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make(5, 2.0, "2, 3, 2.5, 4, 3", "0.1, 0, 0.2, -0.1, 0", 0.2);
    double worst = 0.0;
    int compared = 0;
    for (int i = 0; i < 400; i++) {
        const double angle = 0.1 * i;
        const double x[STATES] = {1.9 * cos(1.7 * i), 1.9 * sin(1.7 * i), 0.1, 0.2, 0.3, 0.1, -0.2, 0.4, angle};
        double exact[STATES * STATES], differences[STATES * STATES], size = 0.0, error = 0.0;
        exact_jacobian(whirl_rotor_system(rotor), 0.0, x, exact);
        rhs_jacobian(whirl_rotor_system(rotor), 0.0, x, 1e-4, differences);
        for (int k = 0; k < STATES * STATES; k++) {
            size = fmax(size, fabs(exact[k]));
            error = fmax(error, fabs(exact[k] - differences[k]));
        }
        if (error > 1e-3) continue; // a blade comes to the casing within the differences
        compared++;
        worst = fmax(worst, error / size);
    }
    assert_true(compared > 380);
    check_within("blade-rub", "largest difference of the derivative from differences, over its largest entry", 0.0,
                 worst, 1e-7);
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(many_blades), cmocka_unit_test(orders),
                                       cmocka_unit_test(derivative)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
