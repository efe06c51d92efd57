// Sections once a turn of a force or of another shaft: the machine is the same, time and what is said of it are counted
// by another phase.
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
#include "support_lanes.h"
#include "support_record.h"
#include "whirl/engine.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

static const double two_pi = 6.283185307179586476925;

/// An element with its settings.
typedef struct part {
    const char *kind;
    whirl_setting settings[9];
} part;

static void add(whirl_design *design, const part *parts, size_t count) {
    for (size_t i = 0; i < count; i++) {
        size_t settings = 0;
        while (settings < COUNT_OF(parts[i].settings) && parts[i].settings[settings].key) settings++;
        require_ok(whirl_design_element(design, parts[i].kind, parts[i].settings, settings));
    }
}

static whirl_rotor *finish(whirl_design *design) {
    whirl_rotor *rotor;
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

// ---------------------------------------------------------------- the same machine

enum { DEGREES = 9, STATES = 2 * DEGREES, OWN = 5, DIMENSION = STATES + OWN };
enum { FIRST_KINKED = 10, LAST_KINKED = 13 }; ///< of the elements below

/// Makes a machine with all elements that depend on the speed of the shaft, on its phase or on velocities, and a force
/// of `hertz`. Sections are by the force, or by the shaft at `speed`. No element has play or contacts.
static whirl_rotor *make_all(double speed, double hertz, bool keyphasor, bool smooth) {
    const whirl_setting disc[] = {{"mass", 2.0, NULL},       {"damping", 3.0, NULL}, {"eccentricity", 2e-5, NULL},
                                  {"diametral", 0.02, NULL}, {"polar", 0.03, NULL},  {"skew", 1e-3, NULL},
                                  {"skew_angle", 0.3, NULL}};
    const whirl_setting journal[] = {{"mass", 1.0, NULL}, {"eccentricity", 1e-5, NULL}};
    const whirl_setting housing[] = {{"mass", 3.0, NULL}};
    const whirl_setting pedestal[] = {{"mass", 4.0, NULL}, {"moves", 0.0, "y"}, {"eccentricity", 1e-5, NULL}};
    const part parts[] = {
        {"shaft", {{"between", 0, "disc, journal"}, {"k1", 2e5, NULL}, {"k2", 1.5e5, NULL}}},
        {"shaft", {{"between", 0, "journal, ground"}, {"k1", 1e5, NULL}, {"k2", 2e5, NULL}, {"signs", 0, "paper"}}},
        {"crack", {{"between", 0, "disc, ground"}, {"stiffness", 1e5, NULL}, {"loss", 0.4, NULL}}},
        {"crack",
         {{"between", 0, "disc, journal"}, {"stiffness", 5e4, NULL}, {"loss", 0.3, NULL}, {"law", 0, "square"}}},
        {"film",
         {{"at", 0, "journal"},
          {"clearance", 1.5e-4, NULL},
          {"viscosity", 0.02, NULL},
          {"radius", 0.02, NULL},
          {"length", 0.02, NULL}}},
        {"squeeze",
         {{"at", 0, "journal"},
          {"from", 0, "housing"},
          {"clearance", 2e-4, NULL},
          {"viscosity", 0.01, NULL},
          {"radius", 0.03, NULL},
          {"length", 0.02, NULL}}},
        {"seal",
         {{"at", 0, "disc"},
          {"clearance", 2e-4, NULL},
          {"stiffness", 1e4, NULL},
          {"damping", 40.0, NULL},
          {"mass", 0.3, NULL},
          {"ratio", 0.45, NULL},
          {"growth", 1.5, NULL},
          {"slowing", 0.5, NULL}}},
        {"bearing",
         {{"at", 0, "housing"}, {"speeds", 0, "50, 300, 600"}, {"kxx", 0, "1e5, 2e5, 5e5"}, {"cxx", 100.0, NULL}}},
        {"mount",
         {{"between", 0, "housing, ground"}, {"stiffness", 1e5, NULL}, {"branch", 5e4, NULL}, {"damping", 50.0, NULL}}},
        {"spring", {{"between", 0, "disc, ground"}, {"along", 0, "tilts"}, {"stiffness", 2e3, NULL}}},
        {"looseness", {{"between", 0, "pedestal, ground"}, {"stiffness", 1e5, NULL}, {"damping", 20.0, NULL}}},
        {"spring",
         {{"between", 0, "disc, housing"}, {"stiffness", 2e4, NULL}, {"damping", 10.0, NULL}, {"gap", 2e-5, NULL}}},
        {"ball_bearing",
         {{"at", 0, "journal"},
          {"from", 0, "housing"},
          {"balls", 7, NULL},
          {"stiffness", 1e9, NULL},
          {"cage", 0.41, NULL},
          {"damping", 30.0, NULL}}},
        {"rub",
         {{"at", 0, "disc"},
          {"gap", 1e-4, NULL},
          {"stiffness", 3e5, NULL},
          {"damping", 20.0, NULL},
          {"friction", 0.2, NULL},
          {"law", 0, "slip"},
          {"radius", 0.01, NULL},
          {"slip_speed", 0.1, NULL}}},
        {"gravity", {{"acceleration", 9.81, NULL}}},
        {"unbalance", {{"at", 0, "housing"}, {"moment", 1e-4, NULL}, {"ratio", -1.25, NULL}}},
        {"force", {{"at", 0, "pedestal"}, {"amplitude", 5.0, NULL}, {"angle", 1.2, NULL}}},
        {"force",
         {{"at", 0, "disc"},
          {"amplitude", 20.0, NULL},
          {"frequency", hertz, NULL},
          {"angle", 0.3, NULL},
          {"keyphasor", 0, keyphasor ? "yes" : "no"}}}};
    whirl_design *design;
    require_ok(whirl_design_new(speed, 1e-4, &design));
    require_ok(whirl_design_station(design, "disc", disc, COUNT_OF(disc)));
    require_ok(whirl_design_station(design, "journal", journal, COUNT_OF(journal)));
    require_ok(whirl_design_station(design, "housing", housing, COUNT_OF(housing)));
    require_ok(whirl_design_station(design, "pedestal", pedestal, COUNT_OF(pedestal)));
    for (size_t i = 0; i < COUNT_OF(parts); i++)
        if (!smooth || i < FIRST_KINKED || i > LAST_KINKED) add(design, &parts[i], 1);
    return finish(design);
}

static double uniform(uint64_t *seed, double low, double high) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

/// Draws a state within or outside of contacts and plays, with journals within their films.
static void draw_state(uint64_t *seed, double *x) {
    for (size_t i = 0; i < DIMENSION; i++) x[i] = i < DEGREES ? uniform(seed, -0.9, 0.9) : uniform(seed, -1.0, 1.0);
    for (size_t i = 2; i < 6; i++) x[i] *= 0.8; // journal and housing
}

/// Forces do not depend on the phase that counts time: accelerations and slopes per second at any state are the same.
static void same_forces(void **unused) {
    (void)unused;
    const double speed = 310.0, hertz = 77.7, clock = two_pi * hertz;
    whirl_rotor *by_shaft = make_all(speed, hertz, false, false), *by_force = make_all(speed, hertz, true, false);
    const whirl_system *one = whirl_rotor_system(by_shaft), *other = whirl_rotor_system(by_force);
    assert_int_equal(one->dimension, DIMENSION);
    assert_int_equal(other->dimension, DIMENSION + 1);
    assert_true(whirl_rotor_speed(by_force) == speed);
    assert_true(whirl_rotor_clock(by_force) == clock);
    assert_string_equal(whirl_rotor_keyphasor(by_force), "force at disc");
    assert_string_equal(whirl_rotor_keyphasor(by_shaft), "");
    double worst = 0.0;
    uint64_t seed = 3;
    for (int trial = 0; trial < 500; trial++) {
        double x[DIMENSION], y[DIMENSION + 1], dx[DIMENSION], dy[DIMENSION + 1], size = 0.0;
        const double phase = uniform(&seed, 0.0, two_pi);
        draw_state(&seed, x);
        for (size_t i = 0; i < DIMENSION; i++) y[i] = i < DEGREES || i >= STATES ? x[i] : x[i] * speed / clock;
        y[DIMENSION] = phase;
        evaluate_rhs(one, phase, x, dx);
        evaluate_rhs(other, uniform(&seed, 0.0, two_pi), y, dy);
        for (size_t i = 0; i < DIMENSION; i++) {
            const double ratio = i < DEGREES || i >= STATES ? clock / speed : clock / speed * clock / speed;
            size = fmax(size, fabs(dx[i]));
            worst = fmax(worst, fabs(dy[i] * ratio - dx[i]) / size);
        }
        assert_true(fabs(dy[DIMENSION] * clock - speed) < 1e-12 * speed);
    }
    check_within("Keyphasor", "slopes of all elements by either phase, part of the largest", 0.0, worst, 1e-13);
    whirl_rotor_free(by_shaft);
    whirl_rotor_free(by_force);
}

/// The Jacobian, with its column of the shaft's phase, against differences of the right-hand side.
static void the_jacobian(void **unused) {
    (void)unused;
    enum { N = DIMENSION, ALL = N * N }; // without the phase of the cage
    whirl_rotor *rotor = make_all(310.0, 77.7, true, true);
    const whirl_system *system = whirl_rotor_system(rotor);
    assert_int_equal(system->dimension, N);
    double worst = 0.0, column = 0.0, least = INFINITY;
    uint64_t seed = 8;
    for (int trial = 0; trial < 40; trial++) {
        double x[N], exact[N * N], differences[N * N], size = 0.0, by_phase = 0.0;
        draw_state(&seed, x);
        x[N - 1] = uniform(&seed, 0.0, two_pi);
        exact_jacobian(system, 0.0, x, exact);
        rhs_jacobian(system, 0.0, x, 1e-3, differences);
        for (size_t i = 0; i < ALL; i++) size = fmax(size, fabs(exact[i]));
        for (size_t i = 0; i < ALL; i++) worst = fmax(worst, fabs(exact[i] - differences[i]) / size);
        for (size_t i = 0; i < N; i++) by_phase = fmax(by_phase, fabs(exact[N * i + N - 1]));
        for (size_t i = 0; i < N; i++)
            column = fmax(column, fabs(exact[N * i + N - 1] - differences[N * i + N - 1]) / by_phase);
        least = fmin(least, by_phase / size);
    }
    check_within("Keyphasor", "Jacobian against differences, part of its largest entry", 0.0, worst, 1e-10);
    check_within("Keyphasor", "its column of the shaft's phase, part of that", 0.0, column, 1e-10);
    assert_true(least > 1e-5);
    whirl_rotor_free(rotor);
}

/// Five turns of the shaft are seven of the force: the motion after them is the same. Elements whose force has a kink
/// are left out, since steps cross it at other instants.
static void same_motion(void **unused) {
    (void)unused;
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    const double speed = 310.0, hertz = 1.4 * speed / two_pi;
    for (size_t m = 0; m < COUNT_OF(methods); m++) {
        whirl_rotor *rotors[2];
        double x[2][DIMENSION + 1] = {{0.0}}, worst = 0.0;
        for (int by = 0; by < 2; by++) {
            const part parts[] = {
                {"shaft", {{"between", 0, "disc, journal"}, {"k1", 2e5, NULL}, {"k2", 1.5e5, NULL}}},
                {"crack", {{"between", 0, "disc, ground"}, {"stiffness", 1e5, NULL}, {"loss", 0.4, NULL}}},
                {"film", {{"at", 0, "journal"}, {"clearance", 2e-4, NULL}, {"load", 30.0, NULL}}},
                {"gravity", {{"acceleration", 9.81, NULL}}},
                {"force",
                 {{"at", 0, "disc"},
                  {"amplitude", 4.0, NULL},
                  {"frequency", hertz, NULL},
                  {"keyphasor", 0, by ? "yes" : "no"}}}};
            const whirl_setting disc[] = {{"mass", 2.0, NULL},          {"damping", 60.0, NULL},
                                          {"eccentricity", 1e-5, NULL}, {"diametral", 0.02, NULL},
                                          {"polar", 0.03, NULL},        {"skew", 1e-3, NULL}};
            const part tilts[] = {{"spring",
                                   {{"between", 0, "disc, ground"},
                                    {"along", 0, "tilts"},
                                    {"stiffness", 4e3, NULL},
                                    {"damping", 2.0, NULL}}}};
            whirl_design *design;
            require_ok(whirl_design_new(speed, 1e-4, &design));
            require_ok(whirl_design_station(design, "disc", disc, COUNT_OF(disc)));
            require_ok(whirl_design_station(design, "journal", (whirl_setting[]){{"mass", 1.0, NULL}}, 1));
            add(design, parts, COUNT_OF(parts));
            add(design, tilts, 1);
            rotors[by] = finish(design);
            whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotors[by]), methods[m], 4096);
            revolve(integrator, x[by], by ? 28 : 20);
            whirl_integrator_free(integrator);
        }
        for (int i = 0; i < 12; i++) worst = fmax(worst, fabs(x[0][i] - x[1][i] * (i < 6 ? 1.0 : 1.4)));
        check_within("Keyphasor",
                     words("motion by %s after 20 turns of the shaft, by either phase, in length scales", methods[m]),
                     0.0, worst, 1e-10);
        for (int by = 0; by < 2; by++) whirl_rotor_free(rotors[by]);
    }
}

// ---------------------------------------------------------------- the closed form

static const double mass = 2.0, damping = 120.0, stiffness = 2.2e5, scale = 1e-4;

/// Makes a disc under an unbalance of a shaft at 300 rad/s (0: none) and a force of `hertz`; sections by the force, or
/// by the shaft.
static whirl_rotor *make_disc(double unbalance, double hertz, bool keyphasor) {
    const part parts[] = {
        {"spring", {{"between", 0, "disc, ground"}, {"stiffness", stiffness, NULL}, {"damping", damping, NULL}}},
        {"unbalance", {{"at", 0, "disc"}, {"moment", unbalance, NULL}, {"angle", 0.3, NULL}}},
        {"force",
         {{"at", 0, "disc"},
          {"amplitude", 20.0, NULL},
          {"law", 0, "forward"},
          {"angle", 0.7, NULL},
          {"frequency", hertz, NULL},
          {"keyphasor", 0, keyphasor ? "yes" : "no"}}}};
    whirl_design *design;
    require_ok(whirl_design_new(300.0, scale, &design));
    require_ok(whirl_design_station(design, "disc", (whirl_setting[]){{"mass", mass, NULL}}, 1));
    add(design, parts, COUNT_OF(parts));
    return finish(design);
}

/// Returns z = x + i y at t = 0 under a force F e^(i nu t), in length scales.
static double complex response(double complex force, double nu) {
    return force / (stiffness - mass * nu * nu + I * damping * nu) / scale;
}

/// Sections of a linear rotor under two incommensurate frequencies lie on a circle: its centre is the response to the
/// phase that they are taken by, its radius that to the other one, and from point to point the angle is that phase's
/// turn.
static void closed_curve(void **unused) {
    (void)unused;
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    enum { SETTLED = 150, SEEN = 50 };
    const double speed = 300.0, hertz = 31.0, shaker = two_pi * hertz, moment = 1e-4;
    const double complex of_force = response(20.0 * cexp(0.7 * I), shaker);
    const double complex of_shaft = response(moment * speed * speed * cexp(0.3 * I), speed);
    for (size_t m = 0; m < COUNT_OF(methods); m++)
        for (int by = 0; by < 2; by++) {
            const double complex centre = by ? of_force : of_shaft, other = by ? of_shaft : of_force;
            const double turn = two_pi * (by ? speed / shaker : shaker / speed);
            whirl_rotor *rotor = make_disc(moment, hertz, by);
            whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), methods[m], 2048);
            double x[6] = {0}, worst = 0.0, aside = 0.0;
            revolve(integrator, x, SETTLED);
            for (int i = 1; i <= SEEN; i++) {
                revolve(integrator, x, 1);
                const double complex z = x[0] + I * x[1], expected = centre + other * cexp(I * turn * (SETTLED + i));
                worst = fmax(worst, cabs(z - expected));
                aside = fmax(aside, fabs(cabs(z - centre) - cabs(other)));
            }
            const char *where = words("sections by the %s, %s", by ? "force" : "shaft", methods[m]);
            check_within("Keyphasor", words("%s: points of the closed curve", where), 0.0, worst / cabs(other), 1e-9);
            check_within("Keyphasor", words("%s: its radius", where), 0.0, aside / cabs(other), 1e-9);
            whirl_integrator_free(integrator);
            whirl_rotor_free(rotor);
        }
}

/// A motion that repeats with the phase is P-k of it, and one that does not is a forced torus either way.
static void verdicts(void **unused) {
    (void)unused;
    static const struct {
        double unbalance, ratio; ///< of the force over the shaft
        const char *by_shaft, *by_force;
    } rows[] = {{1e-4, 0.6180339887498949, "quasi-periodic (forced)", "quasi-periodic (forced)"},
                {0.0, 0.6180339887498949, "quasi-periodic (forced)", "P-1"},
                {1e-4, 1.5, "P-2", "P-3"},
                {1e-4, 0.8, "P-5", "P-4"},
                {0.0, 0.8, "P-5", "P-1"}};
    for (size_t i = 0; i < COUNT_OF(rows); i++)
        for (int by = 0; by < 2; by++) {
            whirl_rotor *rotor = make_disc(rows[i].unbalance, rows[i].ratio * 300.0 / two_pi, by);
            const whirl_system *system = whirl_rotor_system(rotor);
            const double start[6] = {0};
            whirl_record *record = record_motion(system, start, 256, 150, 300);
            check_regime("Keyphasor",
                         words("a force at %g of the speed, %s, by sections of the %s", rows[i].ratio,
                               rows[i].unbalance > 0.0 ? "an unbalance" : "no unbalance", by ? "force" : "shaft"),
                         by ? rows[i].by_force : rows[i].by_shaft, record);
            // Perturbations die out at the same rate a second.
            const double period = by ? two_pi / 300.0 / rows[i].ratio : two_pi / 300.0;
            check_within("Keyphasor", words("its largest exponent per revolution, row %zu", i + 1),
                         -damping / (2.0 * mass) * period, whirl_lyapunov_largest(record).value, 1e-3);
            whirl_record_free(record);
            whirl_rotor_free(rotor);
        }
}

// ---------------------------------------------------------------- a rub under a shaker

/// Makes case C4, a disc that rubs, with a force that turns at w in place of its unbalance, in a machine that turns at
/// `speed`: by sections of the force it is the same.
static whirl_rotor *make_shaken_rub(double speed, double w) {
    const part parts[] = {
        {"shaft", {{"between", 0, "disc, ground"}, {"k1", 1.0, NULL}}},
        {"rub", {{"at", 0, "disc"}, {"gap", 1.0, NULL}, {"stiffness", 10.0, NULL}, {"friction", 0.05, NULL}}},
        {"gravity", {{"acceleration", 0.5, NULL}}},
        {"force",
         {{"at", 0, "disc"},
          {"amplitude", 0.9 * w * w, NULL},
          {"law", 0, "forward"},
          {"frequency", w / two_pi, NULL},
          {"keyphasor", 0, "yes"}}}};
    whirl_design *design;
    require_ok(whirl_design_new(speed, 1.0, &design));
    require_ok(whirl_design_station(design, "disc", (whirl_setting[]){{"mass", 1.0, NULL}, {"damping", 0.2, NULL}}, 2));
    add(design, parts, COUNT_OF(parts));
    return finish(design);
}

/// By the shaft's sections every motion that is not chaotic is a forced torus.
static void regimes_under_a_shaker(void **unused) {
    (void)unused;
    static const struct {
        double w;
        const char *regime;
    } rows[] = {{1.5, "P-1"}, {3.8, "P-4"}, {3.3, "chaotic"}};
    for (size_t i = 0; i < COUNT_OF(rows); i++)
        for (int s = 0; s < 2; s++) {
            const double speed = s ? 3.0 : 0.7320508075688773, start[6] = {0.1, -0.2};
            whirl_rotor *rotor = make_shaken_rub(speed, rows[i].w);
            assert_int_equal(whirl_rotor_system(rotor)->repeats, 1);
            whirl_record *record = record_motion(whirl_rotor_system(rotor), start, 1024, 400, 400);
            check_regime("Keyphasor", words("case C4 under a force at %g, the shaft at %.3g", rows[i].w, speed),
                         rows[i].regime, record);
            whirl_record_free(record);
            whirl_rotor_free(rotor);
        }
}

// ---------------------------------------------------------------- lanes, and what is refused

/// Machines of different speeds in lanes: by every method all widths give the same bits, and those of each machine
/// alone.
static void in_lanes(void **unused) {
    (void)unused;
    enum { LANES = 11, REVOLUTIONS = 6 };
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    static const char *const sets[] = {"fma", "avx2", "avx512", NULL};
    // The same steps, but for rounding; by rodas5p also for derivatives by time, of the forcing in lanes and of the
    // accelerations alone, differences good to 1e-12 of what changes by up to 10 length scales a radian.
    static const double tolerances[] = {1e-13, 1e-11, 1e-10};
    whirl_rotor *rotors[LANES];
    for (size_t l = 0; l < LANES; l++) rotors[l] = make_disc(1e-4, 20.0 + 5.0 * (double)l, true);
    for (size_t m = 0; m < COUNT_OF(methods); m++)
        check_within("Keyphasor", words("in lanes and alone by %s, in length scales", methods[m]), 0.0,
                     compare_lanes_with_alone(methods[m], sets, rotors, LANES, REVOLUTIONS), tolerances[m]);
    for (size_t l = 0; l < LANES; l++) whirl_rotor_free(rotors[l]);
}

static void refused(void **unused) {
    (void)unused;
    const whirl_setting still[] = {
        {"at", 0, "disc"}, {"moment", 1e-4, NULL}, {"speed", 0.0, NULL}, {"keyphasor", 0, "yes"}};
    const whirl_setting turning[] = {
        {"at", 0, "disc"}, {"moment", 1e-4, NULL}, {"ratio", -2.0, NULL}, {"keyphasor", 0, "yes"}};
    for (int i = 0; i < 2; i++) {
        whirl_design *design;
        whirl_rotor *rotor;
        require_ok(whirl_design_new(300.0, scale, &design));
        require_ok(whirl_design_station(design, "disc", (whirl_setting[]){{"mass", mass, NULL}}, 1));
        require_ok(whirl_design_element(design, "unbalance", i ? turning : still, 4));
        if (i) require_ok(whirl_design_element(design, "unbalance", turning, 4));
        const whirl_status status = whirl_rotor_new(design, &rotor);
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        assert_string_equal(status.message, i ? "unbalance is a second keyphasor, expected one"
                                              : "unbalance does not turn, expected a speed above 0 of the phase that "
                                                "defines sections");
        whirl_design_free(design);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(same_forces), cmocka_unit_test(the_jacobian),
                                       cmocka_unit_test(same_motion), cmocka_unit_test(closed_curve),
                                       cmocka_unit_test(verdicts),    cmocka_unit_test(regimes_under_a_shaker),
                                       cmocka_unit_test(in_lanes),    cmocka_unit_test(refused)};
    return cmocka_run_group_tests_name("keyphasor", tests, NULL, NULL);
}
