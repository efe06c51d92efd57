// Equilibria, modes and synchronous responses against closed forms.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "support_rotor.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/rotor.h"

static const double pi = 3.14159265358979323846;

static whirl_modes *modes_of(const whirl_rotor *rotor) {
    const whirl_system *system = whirl_rotor_system(rotor);
    double *start = calloc(system->dimension, sizeof *start);
    whirl_modes *modes;
    require_ok(whirl_modes_new(system, start, &modes));
    free(start);
    return modes;
}

static whirl_rotor *build(whirl_design *design) {
    whirl_rotor *rotor;
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

// ---------------------------------------------------------------- a disc on springs

/// Mass 2 kg, eccentricity 0.1 mm, on springs kx, ky and dampers cx, cy along the axes, under its weight.
typedef struct mounted {
    double speed, kx, ky, cx, cy;
} mounted;

enum { MASS = 2 };
static const double eccentricity = 1e-4, gravity = 9.81;

static whirl_rotor *make_massive(const mounted *m, double weight) {
    const whirl_setting disc[] = {{"mass", MASS, NULL}, {"eccentricity", eccentricity, NULL}};
    const whirl_setting along_x[] = {
        {"between", 0, "disc, ground"}, {"along", 0, "x"}, {"stiffness", m->kx, NULL}, {"damping", m->cx, NULL}};
    const whirl_setting along_y[] = {
        {"between", 0, "disc, ground"}, {"along", 0, "y"}, {"stiffness", m->ky, NULL}, {"damping", m->cy, NULL}};
    whirl_design *design;
    require_ok(whirl_design_new(m->speed, 1e-3, &design));
    require_ok(whirl_design_station(design, "disc", disc, 2));
    require_ok(whirl_design_element(design, "spring", along_x, 4));
    require_ok(whirl_design_element(design, "spring", along_y, 4));
    require_ok(whirl_design_element(design, "gravity", &(whirl_setting){"acceleration", weight, NULL}, 1));
    return build(design);
}

static whirl_rotor *make_mounted(const mounted *m) {
    return make_massive(m, gravity);
}

/// Along each axis lambda = (-c +- sqrt(c^2 - 4 k m))/2m; to and fro, so without a direction; at rest m g/k below.
static void modes_of_a_mounted_disc(void **unused) {
    const mounted m = {300, 8e4, 2e5, 40, 90};
    (void)unused;
    whirl_rotor *rotor = make_mounted(&m);
    whirl_modes *modes = modes_of(rotor);
    const double k[2] = {m.kx, m.ky}, c[2] = {m.cx, m.cy};
    assert_int_equal(modes->count, 2);
    assert_int_equal(modes->real_count, 0);
    assert_true(modes->period == 0.0);
    for (int a = 0; a < 2; a++) {
        const whirl_mode *mode = &modes->modes[a];
        const double decay = -c[a] / (2 * MASS), frequency = sqrt(k[a] / MASS - decay * decay);
        check_within("Linear", words("mounted disc: decay rate along %c, 1/s", "xy"[a]), decay, m.speed * mode->real,
                     1e-11);
        check_within("Linear", words("mounted disc: frequency along %c, rad/s", "xy"[a]), frequency,
                     m.speed * mode->imaginary, 1e-10);
        check_within("Linear", "mounted disc: direction of whirl", 0.0, mode->direction, 1e-12);
    }
    check_within("Linear", "mounted disc: where it rests, mm", -MASS * gravity / m.ky * 1e3, modes->rest[1], 1e-12);
    check_within("Linear", "mounted disc: growth, 1/s", -c[0] / (2 * MASS), m.speed * modes->growth, 1e-11);
    whirl_modes_free(modes);
    whirl_rotor_free(rotor);
}

/// Along each axis X = m e w^2 (1 or -i) / (k - m w^2 + i c w), below, near and above the critical speeds.
static void response_of_a_mounted_disc(void **unused) {
    (void)unused;
    double worst = 0.0, worst_rest = 0.0;
    for (double speed = 50; speed < 1000; speed *= 1.1) {
        const mounted m = {speed, 8e4, 2e5, 40, 90};
        whirl_rotor *rotor = make_mounted(&m);
        const double start[4] = {0};
        double rest[4], found[8];
        require_ok(whirl_forced_response(whirl_rotor_system(rotor), start, rest, found));
        const double force = MASS * eccentricity * speed * speed;
        const double complex x = force / (m.kx - MASS * speed * speed + I * m.cx * speed);
        const double complex y = -I * force / (m.ky - MASS * speed * speed + I * m.cy * speed);
        worst = fmax(worst, cabs(1e-3 * (found[0] + I * found[1]) - x) / cabs(x));
        worst = fmax(worst, cabs(1e-3 * (found[2] + I * found[3]) - y) / cabs(y));
        worst_rest = fmax(worst_rest, fabs(rest[1] * 1e-3 + MASS * gravity / m.ky));
        whirl_rotor_free(rotor);
    }
    check_within("Linear", "mounted disc: response over 32 speeds, largest relative difference", 0.0, worst, 1e-12);
    check_within("Linear", "mounted disc: mean position, m", 0.0, worst_rest, 1e-15);
}

/// Without damping there is no bounded response at the critical speed, and the study says so.
static void no_bounded_response(void **unused) {
    const mounted m = {200, 8e4, 2e5, 0, 0}; // sqrt(8e4 / 2)
    double rest[4], found[8];
    (void)unused;
    whirl_rotor *rotor = make_mounted(&m);
    assert_int_equal(whirl_forced_response(whirl_rotor_system(rotor), (double[4]){0}, rest, found).code,
                     WHIRL_BAD_INPUT);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- a disc that tilts

/// A disc on a tilting spring alone: Jd w^2 -+ Jp W w - k = 0, forward and backward circles.
static void gyroscopic_modes(void **unused) {
    const double speed = 400, diametral = 0.02, polar = 0.035, tilting = 900, stiffness = 5e4;
    const whirl_setting disc[] = {{"mass", MASS, NULL}, {"diametral", diametral, NULL}, {"polar", polar, NULL}};
    const whirl_setting places[] = {{"between", 0, "disc, ground"}, {"stiffness", stiffness, NULL}};
    const whirl_setting tilts[] = {{"between", 0, "disc, ground"}, {"along", 0, "tilts"}, {"stiffness", tilting, NULL}};
    whirl_design *design;
    (void)unused;
    require_ok(whirl_design_new(speed, 1e-3, &design));
    require_ok(whirl_design_station(design, "disc", disc, 3));
    require_ok(whirl_design_element(design, "spring", places, 2));
    require_ok(whirl_design_element(design, "spring", tilts, 3));
    whirl_rotor *rotor = build(design);
    whirl_modes *modes = modes_of(rotor);
    const double half = polar * speed / (2 * diametral), root = sqrt(half * half + tilting / diametral);
    const double expected[4] = {root - half, sqrt(stiffness / MASS), sqrt(stiffness / MASS), root + half};
    assert_int_equal(modes->count, 4);
    for (int i = 0; i < 4; i++)
        check_within("Linear", words("tilting disc: frequency %d, rad/s", i + 1), expected[i],
                     speed * modes->modes[i].imaginary, 1e-10);
    whirl_modes_free(modes);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- journals in films

/// Finds the place at eccentricity ratio e where a load along -y holds the journal (case A3). Returns sigma = F0/W
/// there.
static double place_journal(double e, double position[2]) {
    const double phi = atan2(pi * sqrt(1.0 - e * e), 4.0 * e);
    double force[2];
    position[0] = e * sin(phi);
    position[1] = -e * cos(phi);
    whirl_film_force(position[0], position[1], 0.0, 0.0, force);
    return 1.0 / hypot(force[0], force[1]);
}

/// The equilibrium is found from the centre of the bearing, lightly and heavily loaded.
static void journals_at_rest(void **unused) {
    static const double ratios[] = {1e-4, 0.02, 0.3, 0.7, 0.95, 0.99};
    (void)unused;
    for (size_t i = 0; i < sizeof ratios / sizeof *ratios; i++) {
        double place[2], x[4] = {0};
        const double sigma = place_journal(ratios[i], place), s = 2.0;
        whirl_rotor *rotor = make_film_rotor(sigma / (s * s), 1.0 / (s * s), 0.0);
        require_ok(whirl_equilibrium(whirl_rotor_system(rotor), x));
        check_within("Linear", words("journal at rest at e = %g", ratios[i]), 0.0,
                     hypot(x[0] - place[0], x[1] - place[1]), 1e-12);
        whirl_rotor_free(rotor);
    }
}

/// Returns largest growth at speed s about the journal at rest at e, and the mode it belongs to.
static double film_growth(double e, double s, double *ratio) {
    double place[2];
    const double sigma = place_journal(e, place);
    whirl_rotor *rotor = make_film_rotor(sigma / (s * s), 1.0 / (s * s), 0.0);
    whirl_modes *modes = modes_of(rotor);
    const double growth = modes->growth;
    for (size_t i = 0; i < modes->count; i++)
        if (modes->modes[i].real == growth) *ratio = modes->modes[i].imaginary;
    whirl_modes_free(modes);
    whirl_rotor_free(rotor);
    return growth;
}

/// The thresholds of case A5, where the coefficients of a short bearing by hand lead.
static void threshold_of_a_film(void **unused) {
    static const struct {
        double e;
        const char *speed, *ratio;
    } rows[] = {{0.1, "2.741278636", ".50293839"},
                {0.3, "2.605785828", ".51941739"},
                {0.45697072, "2.531705709", ".52106604"},
                {0.5, "2.541730858", ".51464014"}};
    (void)unused;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double low = 1.0, high = 10.0, ratio = NAN;
        for (int k = 0; k < 60; k++) {
            const double middle = 0.5 * (low + high);
            *(film_growth(rows[i].e, middle, &ratio) > 0.0 ? &high : &low) = middle;
        }
        check_digits("Linear", words("film: threshold speed at e = %.8g", rows[i].e), rows[i].speed,
                     0.5 * (low + high));
        check_digits("Linear", words("film: whirl ratio at e = %.8g", rows[i].e), rows[i].ratio, ratio);
    }
}

// ---------------------------------------------------------------- coefficients that turn

/// Makes a disc of mass 1 on a shaft of stiffnesses 1 +- delta that turn with it, damping 2 zeta that stands still.
static whirl_rotor *make_unequal(double speed, double delta, double zeta) {
    const whirl_setting disc[] = {{"mass", 1.0, NULL}, {"damping", 2 * zeta, NULL}, {"eccentricity", 0.01, NULL}};
    const whirl_setting shaft[] = {{"between", 0, "disc, ground"}, {"k1", 1 + delta, NULL}, {"k2", 1 - delta, NULL}};
    whirl_design *design;
    require_ok(whirl_design_new(speed, 1.0, &design));
    require_ok(whirl_design_station(design, "disc", disc, 3));
    require_ok(whirl_design_element(design, "shaft", shaft, 3));
    return build(design);
}

/// Computes the eigenvalues, over the speed, in the turning frame (u + i v = z e^(-i tau)), where coefficients are
/// constant.
static void turning_exponents(double w, double delta, double zeta, double complex values[4]) {
    const double matrix[16] = {0,
                               0,
                               1,
                               0,
                               0,
                               0,
                               0,
                               1,
                               w * w - 1 - delta,
                               2 * zeta * w,
                               -2 * zeta,
                               2 * w,
                               -2 * zeta * w,
                               w * w - 1 + delta,
                               -2 * w,
                               -2 * zeta};
    eigenvalues(4, matrix, values);
    for (int i = 0; i < 4; i++) values[i] /= w;
}

/// Exponents of the turning frame are those of the fixed frame, up to whole turns.
static void unequal_shaft(void **unused) {
    const double delta = 0.3, zeta = 0.02;
    double worst_growth = 0.0, worst = 0.0;
    (void)unused;
    for (double w = 0.3; w < 2.4; w += 0.1) {
        double complex expected[4];
        double growth = -INFINITY;
        turning_exponents(w, delta, zeta, expected);
        for (int i = 0; i < 4; i++) growth = fmax(growth, creal(expected[i]));
        whirl_rotor *rotor = make_unequal(w, delta, zeta);
        whirl_modes *modes = modes_of(rotor);
        assert_true(modes->period == whirl_rotor_system(rotor)->period);
        worst_growth = fmax(worst_growth, fabs(modes->growth - growth));
        for (size_t i = 0; i < modes->count; i++) {
            double nearest = INFINITY;
            for (int k = 0; k < 4; k++) {
                const double turns = fabs(fmod(cimag(expected[k]), 1.0));
                const double folded = fmin(turns, 1.0 - turns);
                nearest =
                    fmin(nearest, hypot(creal(expected[k]) - modes->modes[i].real, folded - modes->modes[i].imaginary));
            }
            worst = fmax(worst, nearest);
        }
        whirl_modes_free(modes);
        whirl_rotor_free(rotor);
    }
    check_within("Linear", "unequal shaft: growth at 21 speeds, largest difference", 0.0, worst_growth, 1e-11);
    check_within("Linear", "unequal shaft: exponents at 21 speeds, largest difference", 0.0, worst, 1e-10);
}

/// Unstable where (k1 - m w^2)(k2 - m w^2) + (c w)^2 < 0: between the two critical speeds but for damping.
static void unequal_shaft_s_range(void **unused) {
    const double delta = 0.3, zeta = 0.02;
    (void)unused;
    // x^2 - (2 - 4 zeta^2) x + 1 - delta^2 = 0 for x = w^2
    const double middle = 1 - 2 * zeta * zeta, half = sqrt(middle * middle - 1 + delta * delta);
    for (int end = 0; end < 2; end++) {
        const double wanted = sqrt(middle + (end ? half : -half));
        double low = wanted - 0.05, high = wanted + 0.05;
        for (int k = 0; k < 50; k++) {
            const double w = 0.5 * (low + high);
            whirl_rotor *rotor = make_unequal(w, delta, zeta);
            whirl_modes *modes = modes_of(rotor);
            const bool unstable = modes->growth > 0.0;
            *(unstable == (end == 0) ? &high : &low) = w;
            whirl_modes_free(modes);
            whirl_rotor_free(rotor);
        }
        check_within("Linear", words("unequal shaft: %s end of the unstable speeds", end ? "upper" : "lower"), wanted,
                     0.5 * (low + high), 1e-9);
    }
}

/// Its periodic response: at rest in the turning frame, (K - w^2 + i 2 zeta w) r = e w^2.
static void unequal_shaft_s_response(void **unused) {
    const double delta = 0.3, zeta = 0.02, w = 0.6, e = 0.01;
    double rest[4], found[8], right[2] = {e * w * w, 0};
    (void)unused;
    const double matrix[4] = {1 + delta - w * w, -2 * zeta * w, 2 * zeta * w, 1 - delta - w * w};
    solve_linear(2, matrix, right);
    whirl_rotor *rotor = make_unequal(w, delta, zeta);
    require_ok(whirl_forced_response(whirl_rotor_system(rotor), (double[4]){0}, rest, found));
    const double complex z = right[0] + I * right[1];
    check_within("Linear", "unequal shaft: response x", 0.0, cabs(found[0] + I * found[1] - z), 1e-12);
    check_within("Linear", "unequal shaft: response y", 0.0, cabs(found[2] + I * found[3] + I * z), 1e-12);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- what has no equilibrium, or any number

/// A disc that one spring and dampers hold has a rigid-body mode along the other axis, and a decay at c/m.
static void mounted_along_one_axis(void **unused) {
    const mounted m = {300, 8e4, 0, 40, 90};
    (void)unused;
    whirl_rotor *rotor = make_massive(&m, 0.0);
    whirl_modes *modes = modes_of(rotor);
    check_within("Linear", "held along one axis: rigid-body modes", 1.0, (double)modes->free, 0.0);
    assert_int_equal(modes->count, 1);
    assert_int_equal(modes->real_count, 1);
    check_within("Linear", "held along one axis: decay along the other, 1/s", -m.cy / MASS, m.speed * modes->reals[0],
                 1e-11);
    whirl_modes_free(modes);
    whirl_rotor_free(rotor);
}

/// A free disc is at rest anywhere; under its weight nowhere.
static void free_discs(void **unused) {
    double x[4] = {0.3, 0.1, 0, 0};
    (void)unused;
    for (int loaded = 0; loaded < 2; loaded++) {
        whirl_design *design;
        require_ok(whirl_design_new(100, 1.0, &design));
        require_ok(whirl_design_station(design, "disc", &(whirl_setting){"mass", 1.0, NULL}, 1));
        if (loaded)
            require_ok(whirl_design_element(design, "gravity", &(whirl_setting){"acceleration", 9.81, NULL}, 1));
        whirl_rotor *rotor = build(design);
        const whirl_status status = whirl_equilibrium(whirl_rotor_system(rotor), x);
        assert_int_equal(status.code, loaded ? WHIRL_NUMERICAL_FAILURE : WHIRL_OK);
        if (!loaded) assert_true(x[0] == 0.3 && x[1] == 0.1);
        whirl_rotor_free(rotor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(modes_of_a_mounted_disc),
        cmocka_unit_test(response_of_a_mounted_disc),
        cmocka_unit_test(no_bounded_response),
        cmocka_unit_test(gyroscopic_modes),
        cmocka_unit_test(journals_at_rest),
        cmocka_unit_test(threshold_of_a_film),
        cmocka_unit_test(unequal_shaft),
        cmocka_unit_test(unequal_shaft_s_range),
        cmocka_unit_test(unequal_shaft_s_response),
        cmocka_unit_test(mounted_along_one_axis),
        cmocka_unit_test(free_discs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
