// Springs with play, cubic springs and dry friction between any coordinates, along displacements and tilts: periods,
// amplitudes, and the places where motions stick.
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
#include "support_flow.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/rotor.h"

static const double pi = 3.14159265358979323846;

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))
enum { STATE = 16, DEGREES = 8, TILTS = 4 };

typedef struct part {
    const char *kind;
    whirl_setting settings[8];
} part;

/// Two stations whose tilts have units of their own (radii of gyration .5 m and 1 m), lengths in m; coordinates x, y of
/// both, then their tilts.
static const double inertia[2] = {1.0, 12.0}, mass[2] = {4.0, 12.0}, gyration[2] = {0.5, 1.0};

static whirl_rotor *make(double speed, const part *parts, size_t count) {
    static const char *const names[] = {"one", "other"};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(speed, 1.0, &design));
    for (int i = 0; i < 2; i++) {
        const whirl_setting body[] = {{"mass", mass[i], NULL}, {"diametral", inertia[i], NULL}};
        require_ok(whirl_design_station(design, names[i], body, 2));
    }
    for (size_t i = 0; i < count; i++) {
        size_t settings = 0;
        while (settings < 8 && parts[i].settings[settings].key) settings++;
        require_ok(whirl_design_element(design, parts[i].kind, parts[i].settings, settings));
    }
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Returns index of a tilt in the state, and the conversion of radians to the state's unit.
static size_t tilt(int station, int across) {
    return TILTS + 2 * (size_t)station + (size_t)across;
}
static double of_radians(int station, double radians) {
    return radians * gyration[station];
}

// ---------------------------------------------------------------- play between tilts

/// Stations that are released at rest with the relative tilt A cross the play +-g at the rate w (A - g), where w^2 is k
/// (1/I1 + 1/I2). The period is 2 pi/w + 4 g/(w (A - g)).
static void play_between_tilts(void **unused) {
    (void)unused;
    const double k = 300.0, g = 0.01, a = 0.04, w = sqrt(k * (1.0 / inertia[0] + 1.0 / inertia[1]));
    const double period = 2.0 * pi / w + 4.0 * g / (w * (a - g)), share = inertia[1] / (inertia[0] + inertia[1]);
    const part spring = {
        "spring",
        {{"between", 0.0, "one, other"}, {"along", 0.0, "tilt_y"}, {"stiffness", k, NULL}, {"gap_angle", g, NULL}}};
    whirl_rotor *rotor = make(2.0 * pi / period, &spring, 1);
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
    double x[STATE] = {0}, start[STATE], worst = 0.0;
    x[tilt(0, 1)] = of_radians(0, a * share);
    x[tilt(1, 1)] = of_radians(1, -a * (1.0 - share));
    memcpy(start, x, sizeof x);
    revolve(integrator, x, 5);
    for (int i = 0; i < STATE; i++) worst = fmax(worst, fabs(x[i] - start[i]));
    check_within("Between", "play between the tilts of two stations: back after five periods, rad", 0.0, worst, 1e-12);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- cubic springs

/// Returns the period of x'' + (k1 + k3 x^2) x = 0, x the relative displacement, with the amplitude A:
///     4 K(m)/sqrt(k1 + k3 A^2),    m = k3 A^2/(2 (k1 + k3 A^2))
static double period_of(double k1, double k3, double a) {
    const double square = k1 + k3 * a * a;
    double x = 1.0, y = sqrt(1.0 - k3 * a * a / (2.0 * square));
    while (fabs(x - y) > 1e-15) {
        const double middle = 0.5 * (x + y);
        y = sqrt(x * y);
        x = middle;
    }
    return 2.0 * pi / (sqrt(square) * x);
}

static void cubes(void **unused) {
    (void)unused;
    static const char *const along[] = {"x", "y", "tilt_x", "tilt_y"};
    const double k1 = 30.0, k3 = 900.0, a = 0.2;
    for (int i = 0; i < 4; i++) {
        const bool tilts = i >= 2;
        const double *m = tilts ? inertia : mass, per = 1.0 / m[0] + 1.0 / m[1], share = m[1] / (m[0] + m[1]);
        const double period = period_of(k1 * per, k3 * per, a);
        const part spring = {
            "cubic_spring",
            {{"between", 0.0, "one, other"}, {"along", 0.0, along[i]}, {"stiffness", k1, NULL}, {"cubic", k3, NULL}}};
        whirl_rotor *rotor = make(2.0 * pi / period, &spring, 1);
        whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
        double x[STATE] = {0}, start[STATE], worst = 0.0;
        x[tilts ? tilt(0, i - 2) : (size_t)i] = a * share * (tilts ? gyration[0] : 1.0);
        x[tilts ? tilt(1, i - 2) : (size_t)i + 2] = -a * (1.0 - share) * (tilts ? gyration[1] : 1.0);
        memcpy(start, x, sizeof x);
        revolve(integrator, x, 5);
        for (int j = 0; j < STATE; j++) worst = fmax(worst, fabs(x[j] - start[j]));
        check_within("Between",
                     words("cubic spring along %s: back after five periods of the elliptic integral", along[i]), 0.0,
                     worst, 1e-12);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

/// A cubic spring along two axes is isotropic. A circular orbit of radius A has the angular speed w, with w^2 = (k1 +
/// k3 A^2)/m.
static void a_cube_all_around(void **unused) {
    (void)unused;
    for (int tilts = 0; tilts < 2; tilts++) {
        const double k1 = 30.0, k3 = 900.0, a = 0.2, m = tilts ? inertia[0] : mass[0], w = sqrt((k1 + k3 * a * a) / m);
        const part spring = {"cubic_spring",
                             {{"between", 0.0, "one, ground"},
                              {"along", 0.0, tilts ? "tilts" : "xy"},
                              {"stiffness", k1, NULL},
                              {"cubic", k3, NULL}}};
        whirl_rotor *rotor = make(w, &spring, 1);
        whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
        const size_t at = tilts ? tilt(0, 0) : 0;
        const double r = a * (tilts ? gyration[0] : 1.0);
        double x[STATE] = {0};
        x[at] = r * cos(0.3), x[at + 1] = r * sin(0.3);
        x[DEGREES + at] = -r * sin(0.3), x[DEGREES + at + 1] = r * cos(0.3);
        revolve(integrator, x, 3);
        check_within("Between", words("cubic spring along %s: once round a circle", tilts ? "tilts" : "xy"), 0.0,
                     hypot(x[at] - r * cos(0.3), x[at + 1] - r * sin(0.3)), 1e-12);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

// ---------------------------------------------------------------- friction

/// In every half period the mass swings about +-F/k, and its amplitude falls by 2 F/k. It sticks at a turning point
/// where |x| < F/k.
static void friction_stops_it(void **unused) {
    (void)unused;
    static const char *const along[] = {"x", "tilt_x"};
    for (int tilts = 0; tilts < 2; tilts++) {
        const double k = 100.0, f = 2.0, a = 0.13, m = tilts ? inertia[0] : mass[0], unit = tilts ? gyration[0] : 1.0;
        const part parts[] = {
            {"spring", {{"between", 0.0, "one, ground"}, {"along", 0.0, along[tilts]}, {"stiffness", k, NULL}}},
            {"friction",
             {{"between", 0.0, "one, ground"}, {"along", 0.0, along[tilts]}, {tilts ? "moment" : "force", f, NULL}}}};
        whirl_rotor *rotor = make(sqrt(k / m), parts, 2);
        whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
        const size_t at = tilts ? tilt(0, 0) : 0;
        double x[STATE] = {0};
        x[at] = a * unit;
        revolve(integrator, x, 1);
        check_within("Friction", words("along %s: amplitude after a turn, less 4 F/k", along[tilts]), a - 4.0 * f / k,
                     x[at] / unit, 1e-12);
        // Turning points are .13, -.09, .05 and -.01, where the spring has 1 N against 2 N of friction.
        revolve(integrator, x, 4);
        check_within("Friction", words("along %s: where it sticks", along[tilts]), 0.01, fabs(x[at] / unit), 1e-12);
        check_within("Friction", words("along %s: its velocity there", along[tilts]), 0.0, x[DEGREES + at], 1e-13);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

/// Den Hartog (1931): a forced motion without stops has the amplitude P/k sqrt(V^2 - (F/P)^2 U^2), where b is the speed
/// over the natural frequency, V = 1/(1 - b^2), and U = sin(pi/b)/(b (1 + cos(pi/b))). Spring and friction hold the
/// station to the ground.
static void forced_through_friction(void **unused) {
    (void)unused;
    static const double ratios[] = {0.7, 1.4};
    for (int i = 0; i < 2; i++) {
        const double k = 100.0, p = 5.0, f = 2.0, b = ratios[i], m = mass[0], w = b * sqrt(k / m);
        const double v = 1.0 / (1.0 - b * b), u = sin(pi / b) / (b * (1.0 + cos(pi / b)));
        const part parts[] = {
            {"spring", {{"between", 0.0, "one, ground"}, {"along", 0.0, "y"}, {"stiffness", k, NULL}}},
            {"friction", {{"between", 0.0, "one, ground"}, {"along", 0.0, "y"}, {"force", f, NULL}}},
            {"force", {{"at", 0.0, "one"}, {"amplitude", p, NULL}, {"angle", 0.5 * pi, NULL}}}};
        whirl_rotor *rotor = make(w, parts, 3);
        whirl_record *record;
        whirl_record_options options = whirl_record_default();
        whirl_integrate_options integrate = whirl_integrate_default();
        double start[STATE] = {0};
        snprintf(integrate.method, sizeof integrate.method, "dop853");
        integrate.rtol = 1e-12, integrate.atol = 1e-14;
        integrate.steps_per_revolution = 4096;
        options.transient = 200, options.record = 2, options.watch = 2, options.settle = false;
        require_ok(whirl_record_motion(whirl_rotor_system(rotor), &integrate, &options, start, NULL, &record));
        const size_t y = 1;
        check_within("Friction", words("forced at %g of the natural frequency: amplitude, m", b),
                     p / k * sqrt(v * v - f * f / (p * p) * u * u), record->high[y], 1e-7);
        check_within("Friction", words("at %g: the other way", b), -record->high[y], record->low[y], 1e-7);
        whirl_record_free(record);
        whirl_rotor_free(rotor);
    }
}

/// Smoothed friction along two axes acts against the relative velocity.
static void friction_points_back(void **unused) {
    (void)unused;
    const double f = 7.0, v0 = 0.1;
    const part parts[] = {
        {"friction", {{"between", 0.0, "one, other"}, {"force", f, NULL}, {"slip_speed", v0, NULL}}},
        {"friction",
         {{"between", 0.0, "one, other"}, {"along", 0.0, "tilts"}, {"moment", f, NULL}, {"slip_rate", v0, NULL}}}};
    whirl_rotor *rotor = make(1.0, parts, 2);
    double x[STATE] = {0}, slope[STATE];
    x[DEGREES] = 0.3, x[DEGREES + 1] = -0.2, x[DEGREES + 2] = 0.1, x[DEGREES + 3] = 0.25;
    for (int s = 0; s < 2; s++)
        for (int c = 0; c < 2; c++) x[DEGREES + tilt(s, c)] = x[DEGREES + 2 * s + c] * gyration[s];
    evaluate_rhs(whirl_rotor_system(rotor), 0.0, x, slope);
    const double w[] = {0.2, -0.45}, speed = sqrt(w[0] * w[0] + w[1] * w[1] + v0 * v0);
    double worst = 0.0;
    for (int s = 0; s < 2; s++)
        for (int c = 0; c < 2; c++) {
            const double expected = (s == 0 ? -f : f) * w[c] / speed;
            worst = fmax(worst, fabs(slope[DEGREES + 2 * s + c] * mass[s] - expected));
            worst = fmax(worst, fabs(slope[DEGREES + tilt(s, c)] / gyration[s] * inertia[s] - expected));
        }
    check_within("Friction", "smoothed along two axes: forces and moments, N and N m", 0.0, worst, 1e-14);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- derivatives

static void jacobians(void **unused) {
    (void)unused;
    static const part parts[] = {
        {"spring",
         {{"between", 0.0, "one, other"},
          {"along", 0.0, "tilts"},
          {"stiffness", 3.0, NULL},
          {"damping", 0.7, NULL},
          {"gap_angle", 0.05, NULL}}},
        {"cubic_spring",
         {{"between", 0.0, "one, other"}, {"stiffness", 3.0, NULL}, {"cubic", 5.0, NULL}, {"damping", 0.2, NULL}}},
        {"cubic_spring",
         {{"between", 0.0, "one, other"}, {"along", 0.0, "tilts"}, {"cubic", 5.0, NULL}, {"damping", 0.2, NULL}}},
        {"friction", {{"between", 0.0, "one, other"}, {"force", 3.0, NULL}, {"slip_speed", 0.5, NULL}}},
        {"friction",
         {{"between", 0.0, "one, other"}, {"along", 0.0, "tilts"}, {"moment", 3.0, NULL}, {"slip_rate", 0.5, NULL}}}};
    whirl_rotor *rotor = make(1.3, parts, COUNT_OF(parts));
    const whirl_system *system = whirl_rotor_system(rotor);
    double x[STATE], exact[STATE * STATE], differences[STATE * STATE], worst = 0.0, trace = 0.0;
    for (int i = 0; i < STATE; i++) x[i] = sin(2.0 * i + 1.0);
    exact_jacobian(system, 0.6, x, exact);
    rhs_jacobian(system, 0.6, x, 1e-2, differences);
    for (int i = 0; i < STATE * STATE; i++) worst = fmax(worst, fabs(exact[i] - differences[i]));
    check_within("Between", "derivatives of all against differences", 0.0, worst, 1e-8);
    for (int i = 0; i < STATE; i++) trace += exact[i * (STATE + 1)];
    check_holds("Between", "all of them lose energy: the trace is below 0", trace < 0.0);
    whirl_rotor_free(rotor);
}

/// ln |det| of the monodromy matrix of one revolution with located contacts and jumps: by the exact derivatives of
/// steps and switches, and by finite differences of the motion.
static void perturbations(void **unused) {
    (void)unused;
    static const part parts[] = {
        {"spring",
         {{"between", 0.0, "one, other"},
          {"along", 0.0, "tilt_x"},
          {"stiffness", 30.0, NULL},
          {"damping", 0.9, NULL},
          {"gap_angle", 0.02, NULL}}},
        {"cubic_spring",
         {{"between", 0.0, "one, ground"},
          {"along", 0.0, "tilts"},
          {"stiffness", 4.0, NULL},
          {"cubic", 9.0, NULL},
          {"damping", 0.3, NULL}}},
        {"friction", {{"between", 0.0, "other, ground"}, {"along", 0.0, "tilt_x"}, {"moment", 0.05, NULL}}}};
    enum { TURNS = 1 };
    whirl_rotor *rotor = make(1.0, parts, COUNT_OF(parts));
    const whirl_system *system = whirl_rotor_system(rotor);
    whirl_record *record;
    whirl_record_options options = whirl_record_default();
    whirl_integrate_options integrate = whirl_integrate_default();
    double start[STATE] = {0}, matrix[STATE * STATE], exact = 0.0;
    start[tilt(0, 0)] = 0.1, start[tilt(1, 0)] = -0.05, start[tilt(0, 1)] = 0.03, start[DEGREES + tilt(1, 0)] = 0.2;
    snprintf(integrate.method, sizeof integrate.method, "dop853");
    integrate.rtol = 1e-13, integrate.atol = 1e-15;
    options.transient = 0, options.record = options.watch = TURNS, options.settle = false;
    options.growth = WHIRL_GROWTH_ALL;
    require_ok(whirl_record_motion(system, &integrate, &options, start, NULL, &record));
    for (int i = 0; i < STATE; i++) exact += record->growths[i];
    whirl_integrator *integrator = make_integrator(system, "dop853", 64);
    flow_jacobian(integrator, STATE, start, TURNS, 1e-5, matrix);
    check_within("Between", "ln |det| of all perturbations over play, a cube and sharp friction", exact,
                 log(fabs(determinant(STATE, matrix))), 1e-7);
    whirl_integrator_free(integrator);
    whirl_record_free(record);
    whirl_rotor_free(rotor);
}

static void refusals(void **unused) {
    (void)unused;
    static const struct {
        part of;
        const char *sentence;
    } wrong[] = {
        {{"spring", {{"between", 0.0, "one, other"}, {"along", 0.0, "tilts"}, {"gap", 0.1, NULL}}},
         "has gap, in m, and acts along angles, expected along: xy, x, y or axial"},
        {{"friction", {{"between", 0.0, "one, other"}, {"along", 0.0, "x"}, {"moment", 0.1, NULL}}},
         "has moment, in N m, and acts along displacements, expected along: tilts, tilt_x, tilt_y or twist"},
        {{"friction", {{"between", 0.0, "one, other"}, {"along", 0.0, "x"}}}, "has no force, expected one in N"},
        {{"friction", {{"between", 0.0, "one, other"}, {"force", 1.0, NULL}}},
         "has no slip_speed, expected one along two axes, where friction is not sharp"}};
    for (size_t i = 0; i < COUNT_OF(wrong); i++) {
        whirl_design *design;
        whirl_rotor *rotor = NULL;
        size_t settings = 0;
        require_ok(whirl_design_new(1.0, 1.0, &design));
        const whirl_setting body[] = {{"mass", 1.0, NULL}, {"diametral", 1.0, NULL}};
        require_ok(whirl_design_station(design, "one", body, 2));
        require_ok(whirl_design_station(design, "other", body, 2));
        while (wrong[i].of.settings[settings].key) settings++;
        require_ok(whirl_design_element(design, wrong[i].of.kind, wrong[i].of.settings, settings));
        const whirl_status status = whirl_rotor_new(design, &rotor);
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        check_holds("Between", wrong[i].sentence, strstr(status.message, wrong[i].sentence) != NULL);
        whirl_design_free(design);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(play_between_tilts),
        cmocka_unit_test(cubes),
        cmocka_unit_test(a_cube_all_around),
        cmocka_unit_test(friction_stops_it),
        cmocka_unit_test(forced_through_friction),
        cmocka_unit_test(friction_points_back),
        cmocka_unit_test(jacobians),
        cmocka_unit_test(perturbations),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests_name("between", tests, NULL, NULL);
}
