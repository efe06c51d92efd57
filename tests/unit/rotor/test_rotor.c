// The equations of motion that a rotor gives, against the same equations typed in from the literature.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "settings.h"
#include "whirl/engine/rotor.h"

/// Makes the 2015 paper's rotor in SI.
static whirl_rotor *paper_rotor(const char *signs, double r_k) {
    const double omega = 650.0, c = 0.2e-3, k2 = 50.0 * 3250.0 * 3250.0;
    whirl_design *design;
    whirl_rotor *rotor;
    check(whirl_design_new(omega, c, &design));
    check(whirl_design_station(
        design, "disc", (whirl_setting[]){value("mass", 420), value("damping", 4300), value("eccentricity", 0.08 * c)},
        3));
    check(whirl_design_station(design, "journal", (whirl_setting[]){value("mass", 100), value("damping", 9300)}, 2));
    check(whirl_design_element(design, "shaft",
                               (whirl_setting[]){word("between", "disc, journal"), value("k1", r_k * k2),
                                                 value("k2", k2), word("signs", signs)},
                               4));
    check(whirl_design_element(design, "film",
                               (whirl_setting[]){word("at", "journal"), value("count", 2), value("clearance", c),
                                                 value("load", 0.0042 * 50 * c * omega * omega)},
                               4));
    check(whirl_design_element(design, "rub",
                               (whirl_setting[]){word("at", "disc"), value("gap", 1.2 * c), value("stiffness", 10 * k2),
                                                 value("friction", 0.1)},
                               4));
    check(whirl_design_element(design, "gravity", (whirl_setting[]){value("acceleration", 9.8)}, 1));
    check(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Computes the force of Capone's film in its angles, as the literature writes it.
static void film(double x, double y, double vx, double vy, double f[2]) {
    const double a = x - 2 * vy, b = y + 2 * vx, q = 1 - x * x - y * y, alpha = atan2(-b, -a);
    const double across = y * cos(alpha) - x * sin(alpha), along = x * cos(alpha) + y * sin(alpha);
    const double G = 2 / sqrt(q) * (acos(-1.0) / 2 + atan(across / sqrt(q)));
    const double V = (2 + across * G) / q, S = along / (1 - along * along), K = -hypot(a, b) / q;
    f[0] = K * (3 * x * V - sin(alpha) * G - 2 * cos(alpha) * S);
    f[1] = K * (3 * y * V + cos(alpha) * G - 2 * sin(alpha) * S);
}

/// Computes the dimensionless equations; sign is +1 as printed, -1 as derived.
static void paper_equations(double r_k, double sign, double t, const double *z, double *dz) {
    const double r_m = 8.4, w = 0.2, K1 = 1 / (2 * r_m * w * w), K2 = 1 / (4 * w * w);
    const double xi1 = 4300 / (420 * 650.0), xi2 = 9300 / (50 * 650.0), G = 9.8 / (650.0 * 650.0 * 0.2e-3);
    const double a = r_k + 1, b = r_k - 1, dx = z[0] - z[2], dy = z[1] - z[3];
    const double sx = (a + b * cos(2 * t)) * dx + b * sin(2 * t) * dy;
    const double sy = (a + sign * b * cos(2 * t)) * dy + b * sin(2 * t) * dx;
    const double r = hypot(z[0], z[1]), push = r > 1.2 ? (1 - 1.2 / r) * 10 / (r_m * w * w) : 0.0;
    double p[2];
    film(z[2], z[3], z[6], z[7], p);
    for (int i = 0; i < 4; i++) dz[i] = z[4 + i];
    dz[4] = -xi1 * z[4] - K1 * sx + 0.08 * cos(t) - push * (z[0] - 0.1 * z[1]);
    dz[5] = -xi1 * z[5] - K1 * sy + 0.08 * sin(t) - push * (0.1 * z[0] + z[1]) - G;
    dz[6] = -xi2 / 2 * z[6] + K2 * sx + 0.0042 * p[0];
    dz[7] = -xi2 / 2 * z[7] + K2 * sy + 0.0042 * p[1] - G;
}

static void compare_with_paper(const char *signs, double sign) {
    whirl_rotor *rotor = paper_rotor(signs, 0.35);
    const whirl_system *system = whirl_rotor_system(rotor);
    uint64_t seed = 1;
    assert_int_equal(system->dimension, 8);
    for (int trial = 0; trial < 1000; trial++) {
        double z[8], ours[8], theirs[8], forcing[WHIRL_MAX_FORCING];
        for (int i = 0; i < 8; i++) z[i] = uniform(&seed, -0.6, 0.6);
        z[0] *= 2.5;
        const double t = uniform(&seed, 0.0, 6.28);
        system->forcing(system->model, t, forcing);
        system->rhs(system->model, t, forcing, z, ours);
        paper_equations(0.35, sign, t, z, theirs);
        for (int i = 0; i < 8; i++) assert_true(fabs(ours[i] - theirs[i]) <= 1e-12 * (1 + fabs(theirs[i])));
    }
    whirl_rotor_free(rotor);
}

static void test_equations_as_printed(void **state) {
    (void)state;
    compare_with_paper("paper", 1.0);
}

static void test_equations_as_derived(void **state) {
    (void)state;
    compare_with_paper("derived", -1.0);
}

static void test_film_at_rest_in_the_centre_is_still(void **state) {
    double f[2];
    (void)state;
    whirl_film_force(0, 0, 0, 0, f);
    assert_true(f[0] == 0.0 && f[1] == 0.0);
    whirl_film_force(0.8, 0.6, 0, 0, f);
    assert_false(isfinite(f[0]));
}

static void test_film_design_is_the_published_scale(void **state) {
    (void)state;
    // F0 = mu omega R L (R/c)^2 (L/2R)^2 for R = 14 mm, L = 12 mm, c = 0.2 mm, mu = 0.018 Pa s at 650 rad/s, and the
    // literal coefficient of the paper, F0/(m2 c omega^2) = 4.19e-4.
    const double R = 14e-3, L = 12e-3, c = 0.2e-3;
    const double load = 0.018 * 650 * R * L * pow(R / c, 2) * pow(L / (2 * R), 2);
    assert_true(fabs(load / (50 * c * 650 * 650) - 4.19e-4) < 0.005e-4);
    whirl_rotor *rotors[2];
    for (int i = 0; i < 2; i++) {
        whirl_design *design;
        check(whirl_design_new(650, c, &design));
        check(whirl_design_station(design, "journal", (whirl_setting[]){value("mass", 50)}, 1));
        const whirl_setting by_load[] = {word("at", "journal"), value("clearance", c), value("load", load)};
        const whirl_setting by_design[] = {word("at", "journal"), value("clearance", c), value("viscosity", 0.018),
                                           value("radius", R), value("length", L)};
        check(whirl_design_element(design, "film", i ? by_design : by_load, i ? 5 : 3));
        check(whirl_rotor_new(design, &rotors[i]));
        whirl_design_free(design);
    }
    const double z[4] = {0.3, -0.4, 0.1, -0.2};
    double forcing[WHIRL_MAX_FORCING] = {1, 0, 1, 0}, a[4], b[4];
    for (int i = 0; i < 2; i++) {
        const whirl_system *system = whirl_rotor_system(rotors[i]);
        system->rhs(system->model, 0, forcing, z, i ? b : a);
        assert_true(system->probes[0].clearance == 1.0);
    }
    // Table A2 of the film's validation: fx = -1.821529841236 at this state.
    assert_true(fabs(a[2] - load / (50 * c * 650 * 650) * -1.821529841236) < 1e-12);
    for (int i = 2; i < 4; i++) assert_true(fabs(a[i] - b[i]) <= 1e-14 * fabs(a[i]));
    whirl_rotor_free(rotors[0]);
    whirl_rotor_free(rotors[1]);
}

static void test_eccentricity_and_unbalance_are_the_same(void **state) {
    double forcing[WHIRL_MAX_FORCING], a[4], b[4];
    const double z[4] = {0};
    (void)state;
    for (int i = 0; i < 2; i++) {
        whirl_design *design;
        whirl_rotor *rotor;
        check(whirl_design_new(100, 1e-3, &design));
        const whirl_setting eccentric[] = {value("mass", 3), value("eccentricity", 2e-4),
                                           value("eccentricity_angle", 0.7)};
        check(whirl_design_station(design, "disc", eccentric, i ? 1 : 3));
        if (i)
            check(whirl_design_element(
                design, "unbalance", (whirl_setting[]){word("at", "disc"), value("moment", 6e-4), value("angle", 0.7)},
                3));
        check(whirl_rotor_new(design, &rotor));
        whirl_design_free(design);
        const whirl_system *system = whirl_rotor_system(rotor);
        system->forcing(system->model, 1.1, forcing);
        system->rhs(system->model, 1.1, forcing, z, i ? b : a);
        whirl_rotor_free(rotor);
    }
    assert_true(fabs(a[2] - 0.2 * cos(1.1 + 0.7)) < 1e-15 && fabs(a[3] - 0.2 * sin(1.1 + 0.7)) < 1e-15);
    assert_true(fabs(a[2] - b[2]) < 1e-16 && fabs(a[3] - b[3]) < 1e-16);
}

static void test_friction_follows_the_slip(void **state) {
    const double surface = 5.0;
    (void)state;
    for (int backward = 0; backward < 2; backward++) {
        whirl_design *design;
        whirl_rotor *rotor;
        check(whirl_design_new(1, 1, &design));
        check(whirl_design_station(design, "disc", (whirl_setting[]){value("mass", 1)}, 1));
        check(whirl_design_element(design, "rub",
                                   (whirl_setting[]){word("at", "disc"), value("gap", 1), value("stiffness", 4),
                                                     value("friction", 0.3), word("law", "slip"),
                                                     value("radius", surface)},
                                   6));
        check(whirl_rotor_new(design, &rotor));
        whirl_design_free(design);
        const whirl_system *system = whirl_rotor_system(rotor);
        // At (2, 0) with transverse velocity v the surface slips at 5 + v: the normal force is 4, friction 1.2.
        const double z[4] = {2, 0, 0, backward ? -6 : -4};
        double forcing[WHIRL_MAX_FORCING] = {1, 0, 1, 0}, dz[4], switches[WHIRL_MAX_SWITCHES],
               normal[WHIRL_MAX_CONTACTS];
        system->rhs(system->model, 0, forcing, z, dz);
        assert_true(fabs(dz[2] + 4.0) < 1e-15);
        assert_true(fabs(dz[3] - (backward ? 1.2 : -1.2)) < 1e-15);
        assert_int_equal(system->switch_count, 2);
        system->switches(system->model, 0, z, switches);
        assert_true(fabs(switches[0] - 1.0) < 1e-15);
        assert_true((switches[1] < 0) == (backward == 1));
        system->contacts(system->model, z, normal);
        assert_true(fabs(normal[0] - 4.0) < 1e-15);
        assert_string_equal(whirl_rotor_contact_names(rotor)[0], "rub at disc");
        whirl_rotor_free(rotor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_equations_as_printed),
        cmocka_unit_test(test_equations_as_derived),
        cmocka_unit_test(test_film_at_rest_in_the_centre_is_still),
        cmocka_unit_test(test_film_design_is_the_published_scale),
        cmocka_unit_test(test_eccentricity_and_unbalance_are_the_same),
        cmocka_unit_test(test_friction_follows_the_slip),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
