// Misalignment in its three senses: bearings off line, bores and faces of a coupling that run out, shafts at an angle
// or with parallel axes that do not turn; and their effect on a machine.
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
#include "support_study.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/case.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/rotor.h"

static const double pi = 3.14159265358979323846;

enum { STATE = 16, DEGREES = 8, DRIVING_TILT = 4, DRIVEN_TILT = 6 };

/// Makes two stations of 1 kg and 1 kg m2 on springs, at `speed`, lengths in m: accelerations are forces over the
/// square of the speed. Coordinates are x, y of the first and the second, then their tilts.
static whirl_rotor *make(double speed, double spring, double turning, const char *kind, const whirl_setting *settings,
                         size_t count) {
    const whirl_setting body[] = {{"mass", 1.0, NULL}, {"diametral", 1.0, NULL}, {"polar", 0.0, NULL}};
    static const char *const names[] = {"driving", "driven"};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(speed, 1.0, &design));
    for (int i = 0; i < 2; i++) require_ok(whirl_design_station(design, names[i], body, 3));
    for (int i = 0; i < 2; i++) {
        char between[64];
        snprintf(between, sizeof between, "%s, ground", names[i]);
        const whirl_setting flat[] = {{"between", 0.0, between}, {"stiffness", spring, NULL}},
                            tilted[] = {
                                {"between", 0.0, between}, {"along", 0.0, "tilts"}, {"stiffness", turning, NULL}};
        require_ok(whirl_design_element(design, "spring", flat, 2));
        require_ok(whirl_design_element(design, "spring", tilted, 3));
    }
    require_ok(whirl_design_element(design, kind, settings, count));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Computes forces and moments at rest in the middle, for each coordinate, with the shaft turned by tau.
static void forces_at(const whirl_rotor *rotor, double tau, double *force) {
    double x[STATE] = {0}, slope[STATE];
    evaluate_rhs(whirl_rotor_system(rotor), tau, x, slope);
    memcpy(force, slope + DEGREES, DEGREES * sizeof *force);
}

// ---------------------------------------------------------------- a joint at an angle

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++) out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Moments about x and y on the driving and about x2 and y2 on the driven shaft, which leans to x, and the torque that
/// comes out: pins of the cross at p1 and, by the exact angle p2 of the driven shaft, at p2 + 90 degrees.
static void cross_of_two_pins(double p1, double b, double torque, double driving[2], double driven[2], double *out) {
    const double z2[3] = {sin(b), 0.0, cos(b)}, x2[3] = {cos(b), 0.0, -sin(b)}, y2[3] = {0.0, 1.0, 0.0};
    const double p2 = atan2(sin(p1), cos(p1) * cos(b)), a1[3] = {cos(p1), sin(p1), 0.0};
    double a2[3], normal[3];
    for (int i = 0; i < 3; i++) a2[i] = -sin(p2) * x2[i] + cos(p2) * y2[i];
    assert_true(fabs(dot(a1, a2)) < 1e-15);
    cross(a1, a2, normal);
    const double size = torque / normal[2];
    for (int i = 0; i < 2; i++) driving[i] = -size * normal[i];
    driven[0] = size * dot(normal, x2);
    driven[1] = size * dot(normal, y2);
    *out = size * dot(normal, z2);
}

/// Returns the amplitude of sin 2n p1 in p2 - p1 by sums over a turn.
static double harmonic(double b, int n) {
    enum { INSTANTS = 64 };
    double sum = 0.0;
    for (int k = 0; k < INSTANTS; k++) {
        const double p = 2.0 * pi * (k + 0.5) / INSTANTS, ahead = atan2(sin(p), cos(p) * cos(b)) - p;
        sum += remainder(ahead, 2.0 * pi) * sin(2.0 * n * p) * 2.0 / INSTANTS;
    }
    return sum;
}

static void the_angle_of_a_joint(void **unused) {
    (void)unused;
    static const struct {
        double degrees;
        const char *twice, *four;
    } angles[] = {
        {2.0, ".000304679291648", ""}, {5.0, ".00190627793566", "1.81694778399e-6"}, {10.0, ".00765426624555", ""}};
    for (int i = 0; i < 3; i++) {
        const double b = angles[i].degrees * pi / 180.0;
        const whirl_setting joint[] = {{"between", 0.0, "driving, driven"}, {"bend", b, NULL}, {"torque", 1.0, NULL}};
        whirl_rotor *rotor = make(1.0, 1.0, 1.0, "joint", joint, 3);
        char text[WHIRL_MESSAGE_SIZE];
        double twice, four, slow, fast;
        assert_true(whirl_rotor_note(rotor, 0, text));
        assert_int_equal(
            sscanf(text,
                   "joint at driving: the driven shaft runs ahead by %lf rad twice and %lf rad four times a "
                   "turn, at %lf to %lf",
                   &twice, &four, &slow, &fast),
            4);
        char of[32];
        snprintf(of, sizeof of, "bend %g deg", angles[i].degrees);
        check_digits("Joint", words("%s: runs ahead twice a turn by, rad", of), angles[i].twice, twice);
        if (*angles[i].four) check_digits("Joint", words("%s: four times a turn", of), angles[i].four, four);
        check_within("Joint", words("%s: twice, by sums over the exact angle", of), harmonic(b, 1), twice, 1e-14);
        check_within("Joint", words("%s: four times, by sums", of), harmonic(b, 2), four, 1e-14);
        check_within("Joint", words("%s: least speed over the driving one's", of), cos(b), slow, 1e-12);
        check_within("Joint", words("%s: largest speed", of), 1.0 / cos(b), fast, 1e-11);
        whirl_rotor_free(rotor);
    }
}

static void the_moments_of_a_joint(void **unused) {
    (void)unused;
    const double b = 25.0 * pi / 180.0, direction = 0.4, yoke = 0.9, torque = 300.0;
    const whirl_setting joint[] = {{"between", 0.0, "driving, driven"},
                                   {"bend", b, NULL},
                                   {"direction", direction, NULL},
                                   {"yoke", yoke, NULL},
                                   {"torque", torque, NULL}};
    for (int way = 1; way >= -1; way -= 2) {
        whirl_rotor *rotor = make(way, 1.0, 1.0, "joint", joint, 5);
        double worst = 0.0, largest[2] = {0.0, 0.0}, power = 0.0;
        for (int k = 0; k < 48; k++) {
            const double tau = 2.0 * pi * k / 48, p = way * tau + yoke - direction;
            double force[DEGREES], on[2][2], out;
            cross_of_two_pins(p, b, way * torque, on[0], on[1], &out);
            forces_at(rotor, tau, force);
            for (int place = 0; place < 2; place++) { // (M_y, -M_x), turned to where the shaft leans to
                const double complex turned = (on[place][1] - I * on[place][0]) * (cos(direction) + I * sin(direction));
                const double *found = force + (place == 0 ? DRIVING_TILT : DRIVEN_TILT);
                worst = fmax(worst, cabs(turned - found[0] - I * found[1]));
                largest[place] = fmax(largest[place], hypot(found[0], found[1]));
            }
            const double speed = cos(b) / (1.0 - sin(b) * sin(b) * cos(p) * cos(p));
            power = fmax(power, fabs(out * speed / (way * torque) - 1.0));
        }
        const char *turning = way > 0 ? "counter-clockwise" : "clockwise";
        check_within("Joint", words("%s: moments of a cross of two pins, N m", turning), 0.0, worst, 1e-12);
        check_within("Joint", words("%s: power out over power in, less 1", turning), 0.0, power, 1e-14);
        if (way > 0) { // p passes 0 and 90 degrees nearly
            check_within("Joint", "largest on the driving yoke, T tan b", torque * tan(b), largest[0], 0.2);
            check_within("Joint", "largest on the driven yoke, T sin b", torque * sin(b), largest[1], 0.2);
        }
        whirl_rotor_free(rotor);
    }
}

/// The motion twice a turn, by the balance of moments: (k - 4 I w^2) X = M_2.
static void a_motion_by_a_joint(void **unused) {
    (void)unused;
    static const char *const methods[] = {"dop853", "rodas5p"};
    const double b = 0.1, torque = 50.0, speed = 20.0, turning = 9000.0, t = 0.5 * torque * tan(b);
    const whirl_setting joint[] = {{"between", 0.0, "driving, driven"}, {"bend", b, NULL}, {"torque", torque, NULL}};
    whirl_rotor *rotor = make(speed, 1e4, turning, "joint", joint, 3);
    for (int m = 0; m < 2; m++) {
        whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), methods[m], 64);
        const double across = t / turning, twice = t / (turning - 4.0 * speed * speed);
        double x[STATE] = {0}, start[STATE] = {0};
        // x: t sin 2 tau, y: t - t cos 2 tau; in units of the tilt, which is 1 rad.
        start[DRIVING_TILT + 1] = across - twice;
        start[DEGREES + DRIVING_TILT] = 2.0 * twice;
        const double s = 0.5 * torque * sin(b);
        start[DRIVEN_TILT + 1] = s / turning + s / (turning - 4.0 * speed * speed);
        start[DEGREES + DRIVEN_TILT] = -2.0 * twice;
        memcpy(x, start, sizeof x);
        revolve(integrator, x, 3);
        double worst = 0.0;
        for (int i = 0; i < STATE; i++) worst = fmax(worst, fabs(x[i] - start[i]));
        check_within("Joint", words("by %s: the motion comes back after three turns", methods[m]), 0.0, worst, 1e-14);
        whirl_integrator_free(integrator);
    }
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- a coupling between parallel shafts

static const whirl_setting gibbons[] = {{"between", 0.0, "driving, driven"},
                                        {"distance", 0.05, NULL},
                                        {"x1", 1e-4, NULL},
                                        {"x2", 2e-4, NULL},
                                        {"y1", 5e-5, NULL},
                                        {"y2", -1e-4, NULL},
                                        {"bending_stiffness", 150.0, NULL},
                                        {"torque", 200.0, NULL},
                                        {"orders", 0.0, "1"},
                                        {"phase", 0.0, NULL}};
enum { GIBBONS = sizeof gibbons / sizeof *gibbons };
static const char *const printed[] = {"-2.00002800022", "33.0000045", ".550000025",
                                      "-.1000002",      "1.1000002",  ".200001600012"};
static const char *const reactions[] = {"FX1", "FY1", "MX1", "MY1", "MX2", "MY2"};

/// Writes reactions FX1, FY1, ... as the forces on x, y of both places and the moments on their tilts.
static void as_forces(const double *of, double *force) {
    const double all[DEGREES] = {of[0], of[1], -of[0], -of[1], -of[3], of[2], -of[5], of[4]};
    memcpy(force, all, sizeof all);
}

static void the_reactions_of_gibbons(void **unused) {
    (void)unused;
    double of[6], expected[DEGREES], found[DEGREES], worst = 0.0;
    whirl_rotor *still = make(1.0, 1.0, 1.0, "coupling_load", gibbons, GIBBONS - 2);
    char text[WHIRL_MESSAGE_SIZE];
    assert_true(whirl_rotor_note(still, 0, text));
    assert_int_equal(sscanf(text,
                            "coupling_load at driving: reactions FX1 %lf, FY1 %lf N and against them FX2, FY2; MX1 "
                            "%lf, MY1 %lf, MX2 %lf, MY2 %lf",
                            &of[0], &of[1], &of[2], &of[3], &of[4], &of[5]),
                     6);
    for (int i = 0; i < 6; i++) check_digits("Gibbons", reactions[i], printed[i], of[i]);
    as_forces(of, expected);
    forces_at(still, 0.7, found);
    for (int i = 0; i < DEGREES; i++) worst = fmax(worst, fabs(found[i] - expected[i]));
    check_within("Gibbons", "forces and moments that do not turn, N and N m", 0.0, worst, 1e-9);
    // Nothing holds the coupling but both shafts: all moments about the middle are in balance.
    check_within("Gibbons", "moments on it along x, N m", 0.0, found[4] + found[6] - 0.05 * found[0], 1e-12);
    check_within("Gibbons", "moments on it along y", 0.0, found[5] + found[7] - 0.05 * found[1], 1e-12);
    whirl_rotor_free(still);
}

/// Orders and their phase, and clockwise the mirror image.
static void orders_of_reactions(void **unused) {
    (void)unused;
    static const double parts[] = {0.3, 1.0, 0.5, 0.25, 0.2};
    double of[6], still[DEGREES];
    for (int i = 0; i < 6; i++) of[i] = strtod(printed[i], NULL);
    as_forces(of, still);
    char text[2048], problems[2048];
    const char *frame =
        "whirl: 1\nrotor:\n  speed: 1 rad/s\n  length_scale: 1 m\n  stations:\n"
        "    driving: {mass: 1 kg, diametral: 1 kg m2}\n    driven: {mass: 1 kg, diametral: 1 kg m2}\n"
        "  elements:\n    - coupling_load: {between: [driving, driven], distance: 50 mm, x1: 0.1 mm, "
        "x2: 0.2 mm, y1: 0.05 mm, y2: -0.1 mm, bending_stiffness: 150, torque: 200, phase: 0.4, orders: "
        "[0.3, 1, 0.5, 0.25, 0.2]}\nstudy: {response: {}}\n";
    snprintf(text, sizeof text, "%s", frame);
    whirl_case *object;
    if (whirl_case_check(text, strlen(text), "case.yaml", problems, sizeof problems, &object).code != WHIRL_OK)
        fail_msg("%s", problems);
    whirl_rotor *rotor;
    require_ok(whirl_case_rotor(object, NULL, NAN, &rotor));
    double worst = 0.0;
    for (int k = 0; k < 17; k++) {
        const double tau = 0.37 * k;
        double found[DEGREES], part = parts[0];
        for (int n = 1; n < 5; n++) part += parts[n] * cos(n * (tau + 0.4));
        forces_at(rotor, tau, found);
        for (int i = 0; i < DEGREES; i++) worst = fmax(worst, fabs(found[i] - part * still[i]));
    }
    check_within("Gibbons", "four orders with a phase, over a turn: N and N m", 0.0, worst, 1e-9);
    whirl_rotor_free(rotor);
    whirl_case_free(object);
}

// ---------------------------------------------------------------- bores and faces that run out

/// Solves (K + i w C - w^2 M) X = (k + i w c) e of two masses on springs with a coupling between them.
static void answer(double speed, double inertia, const double ground[2], double stiffness, double damping,
                   double complex off, double complex out[2]) {
    const double complex k = stiffness + I * speed * damping, force = k * off;
    const double complex a = ground[0] + k - inertia * speed * speed, d = ground[1] + k - inertia * speed * speed;
    const double complex determinant = a * d - k * k;
    out[0] = (force * d - k * force) / determinant;
    out[1] = (-force * a + k * force) / determinant;
}

static void a_coupling_that_runs_out(void **unused) {
    (void)unused;
    const double speed = 30.0, spring = 5000.0, turning = 3000.0, e = 2e-3, kink = 3e-3;
    const whirl_setting coupling[] = {{"between", 0.0, "driving, driven"}, {"radial", 700.0, NULL},
                                      {"radial_damping", 9.0, NULL},       {"tilt", 400.0, NULL},
                                      {"tilt_damping", 5.0, NULL},         {"bore_offset", e, NULL},
                                      {"bore_angle", 0.5, NULL},           {"face_kink", kink, NULL},
                                      {"face_angle", -0.8, NULL}};
    const double ground[] = {spring, spring}, tilted[] = {turning, turning};
    double complex flat[2], leaning[2];
    answer(speed, 1.0, ground, 700.0, 9.0, e * cexp(0.5 * I), flat);
    answer(speed, 1.0, tilted, 400.0, 5.0, kink * cexp(-0.8 * I), leaning);
    for (int way = 1; way >= -1; way -= 2) {
        whirl_rotor *rotor = make(way * speed, spring, turning, "coupling", coupling, 9);
        double start[STATE] = {0}, rest[STATE], response[2 * STATE], worst = 0.0, x[STATE];
        require_ok(whirl_forced_response(whirl_rotor_system(rotor), start, rest, response));
        for (int place = 0; place < 2; place++) {
            // Clockwise all turns the other way from the same angles: the conjugate of what conjugate angles give.
            const double complex z[] = {flat[place], leaning[place]};
            const double angles[] = {0.5, -0.8};
            for (int i = 0; i < 2; i++) {
                const double complex own = way > 0 ? z[i] : conj(z[i] * cexp(-2.0 * I * angles[i]));
                const double *at = response + 2 * (i == 0 ? 2 * place : DRIVING_TILT + 2 * place);
                const double complex along_x = at[0] + I * at[1], along_y = at[2] + I * at[3];
                // x + iy = own exp(+-i tau) where no whirl goes the other way.
                const double complex forward = 0.5 * (along_x + I * along_y), back = 0.5 * (along_x - I * along_y);
                worst = fmax(worst, cabs((way > 0 ? forward : conj(back)) - own) / cabs(own));
                worst = fmax(worst, cabs(way > 0 ? back : forward) / cabs(own));
            }
        }
        check_within("Coupling",
                     words("response to bores and faces that run out, %s, part of its size",
                           way > 0 ? "counter-clockwise" : "clockwise"),
                     0.0, worst, 1e-12);
        // The motion itself, from where the response says, comes back after a turn.
        for (int i = 0; i < DEGREES; i++) {
            x[i] = response[2 * i];
            x[DEGREES + i] = -response[2 * i + 1];
        }
        memcpy(start, x, sizeof x);
        whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
        revolve(integrator, x, 2);
        worst = 0.0;
        for (int i = 0; i < STATE; i++) worst = fmax(worst, fabs(x[i] - start[i]));
        check_within("Coupling", words("the motion comes back, %s", way > 0 ? "counter-clockwise" : "clockwise"), 0.0,
                     worst, 1e-13);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

// ---------------------------------------------------------------- bearings off line

/// A mass on a cubic spring to the ground and a bearing that stands off line by e, up and sideways: at rest k1 r + k3
/// r^3
/// + K (r - e) = 0 that way.
static void a_raised_bearing_preloads(void **unused) {
    (void)unused;
    const double k1 = 2e5, k3 = 4e11, stiffness = 3e5, raised = 1e-3;
    char text[2048], problems[2048];
    snprintf(
        text, sizeof text,
        "whirl: 1\nrotor:\n  speed: 300 rad/s\n  length_scale: 1 mm\n  stations:\n    disc: {mass: 2 kg}\n"
        "  elements:\n    - cubic_spring: {between: [disc, ground], stiffness: %g N/m, cubic: %g N/m3, damping: 300 "
        "N.s/m}\n    - bearing: {at: disc, kxx: %g N/m, cxx: 200 N.s/m, elevation: %g m, sideways: %g m}\nstudy:\n  "
        "response: {}\n"
        "  integrate: {transient: 100, record: 10, rtol: 1e-12}\n  analyze: [orbit]\n",
        k1, k3, stiffness, 0.8 * raised, -0.6 * raised);
    whirl_case *object;
    whirl_result *result;
    if (whirl_case_check(text, strlen(text), "case.yaml", problems, sizeof problems, &object).code != WHIRL_OK)
        fail_msg("%s", problems);
    require_ok(whirl_case_run(object, &(whirl_run_options){.threads = 1}, &result));
    double r = raised;
    for (int i = 0; i < 50; i++)
        r -= (k1 * r + k3 * r * r * r + stiffness * (r - raised)) / (k1 + 3.0 * k3 * r * r + stiffness);
    const double *mean = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_ORBIT_MEAN, 0);
    check_within("Off-line", "cubic spring and bearing off line in time: y at rest, mm", 0.8e3 * r, mean[1], 1e-9);
    check_within("Off-line", "and x", -0.6e3 * r, mean[0], 1e-9);
    whirl_result_free(result);
    whirl_case_free(object);
}

// ---------------------------------------------------------------- derivatives

static void jacobians(void **unused) {
    (void)unused;
    const whirl_setting joint[] = {{"between", 0.0, "driving, driven"}, {"bend", 0.2, NULL}, {"torque", 9.0, NULL}};
    whirl_rotor *rotors[] = {make(1.0, 1.0, 1.0, "joint", joint, 3),
                             make(1.0, 1.0, 1.0, "coupling_load", gibbons, GIBBONS - 2)};
    for (int r = 0; r < 2; r++) {
        double x[STATE], exact[STATE * STATE], differences[STATE * STATE], worst = 0.0;
        for (int i = 0; i < STATE; i++) x[i] = 0.1 * sin(i + 1.0);
        exact_jacobian(whirl_rotor_system(rotors[r]), 0.6, x, exact);
        rhs_jacobian(whirl_rotor_system(rotors[r]), 0.6, x, 1e-3, differences);
        for (int i = 0; i < STATE * STATE; i++) worst = fmax(worst, fabs(exact[i] - differences[i]));
        check_within("Joint", words("derivatives against differences, %s", r == 0 ? "joint" : "misaligned coupling"),
                     0.0, worst, 1e-10);
        whirl_rotor_free(rotors[r]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_angle_of_a_joint),      cmocka_unit_test(the_moments_of_a_joint),
        cmocka_unit_test(a_motion_by_a_joint),       cmocka_unit_test(the_reactions_of_gibbons),
        cmocka_unit_test(orders_of_reactions),       cmocka_unit_test(a_coupling_that_runs_out),
        cmocka_unit_test(a_raised_bearing_preloads), cmocka_unit_test(jacobians),
    };
    return cmocka_run_group_tests_name("misalignment", tests, NULL, NULL);
}
