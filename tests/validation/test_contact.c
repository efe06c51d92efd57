// Contacts by laws of impact and friction: impacts, bristles, sticking and slipping, an arc, a stator that moves.
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
#include "whirl/engine/ensemble.h"
#include "whirl/engine/rotor.h"

static const double pi = 3.14159265358979323846;

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

/// Makes a mass of 1 kg in a stator, in a case of that speed and length.
static whirl_rotor *make(double speed, double length, const whirl_setting *contact, size_t count, double pull) {
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(speed, length, &design));
    require_ok(whirl_design_station(design, "mass", (whirl_setting[]){{"mass", 1.0, NULL}}, 1));
    require_ok(whirl_design_element(design, "contact", contact, count));
    if (pull != 0.0)
        require_ok(whirl_design_element(design, "gravity",
                                        (whirl_setting[]){{"acceleration", pull, NULL}, {"direction", 0.0, NULL}}, 2));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

// ---------------------------------------------------------------- impacts

typedef struct impact {
    const char *name;
    double loss, speed;                ///< chi, v
    const char *back, *time, *deepest; ///< the last from K d^(n+1)/(n+1) = v/chi - ln(1 + chi v)/chi^2
} impact;

/// Computes the state after `time` of a mass that flies straight into a stator: gap, depth and length in mm.
static void fly(const impact *of, double time, double state[4]) {
    const whirl_setting contact[] = {{"at", 0.0, "mass"},
                                     {"gap", 1e-3, NULL},
                                     {"stiffness", 1e8, NULL},
                                     {"law", 0.0, "hunt_crossley"},
                                     {"loss", of->loss, NULL}};
    const double rate = 2.0 * pi / time;
    whirl_rotor *rotor = make(rate, 1e-3, contact, COUNT_OF(contact), 0.0);
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
    memcpy(state, (double[4]){1.0, 0.0, of->speed / (1e-3 * rate), 0.0}, 4 * sizeof *state);
    revolve(integrator, state, 1);
    state[2] *= 1e-3 * rate;
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

/// Returns the depth where the speed is zero, by the secant rule from two guesses of the time.
static double deepest(const impact *of, double one, double other) {
    double a[4], b[4];
    fly(of, one, a);
    for (int i = 0; i < 8 && one != other; i++) {
        fly(of, other, b);
        const double next = b[2] == a[2] ? other : other - b[2] * (other - one) / (b[2] - a[2]);
        one = other, other = next;
        memcpy(a, b, sizeof a);
    }
    return (a[0] - 1.0) * 1e-3;
}

static void impacts(void **unused) {
    (void)unused;
    static const impact impacts[] = {
        {"chi = .5, v = .2", 0.5, 0.2, ".937475579950", "2.82071250331e-3", "1.8555064869e-4"},
        {"chi = 1, v = 1", 1.0, 1.0, ".593624260040", "2.19300804849e-3", "5.6747672108e-4"}};
    for (int i = 0; i < 2; i++) {
        const impact *of = &impacts[i];
        double state[4];
        fly(of, 3e-3, state);
        const double e = -state[2] / of->speed, share = of->loss * of->speed;
        check_digits("contact-impact", words("%s: speed after over before", of->name), of->back, e);
        check_within("contact-impact", words("%s: the first integral, chi v (1 + e)", of->name),
                     log((1.0 + share) / (1.0 - share * e)), share * (1.0 + e), 1e-12);
        check_digits("contact-impact", words("%s: time in contact, s", of->name), of->time,
                     3e-3 + (state[0] - 1.0) * 1e-3 / (e * of->speed));
        check_digits(
            "contact-impact", words("%s: deepest, m", of->name), of->deepest,
            deepest(of, 0.45 * 2.8e-3 * pow(of->speed / 0.2, -0.2), 0.46 * 2.8e-3 * pow(of->speed / 0.2, -0.2)));
    }
}

/// Nothing lost: half of the energy K d^(n+1)/(n+1) is v^2/4 ..., whatever the power.
static void powers(void **unused) {
    (void)unused;
    for (int i = 0; i < 3; i++) {
        const double n = i == 0 ? 1.0 : i == 1 ? 10.0 / 9.0 : 2.5, depth = 0.3, K = 7.0;
        const whirl_setting contact[] = {
            {"at", 0.0, "mass"}, {"gap", 1.0, NULL}, {"stiffness", K, NULL}, {"power", n, NULL}};
        whirl_rotor *rotor = make(1.0, 1.0, contact, COUNT_OF(contact), 0.0);
        double slope[4];
        evaluate_rhs(whirl_rotor_system(rotor), 0.0, (double[]){0.0, -1.0 - depth, 0.0, 0.0}, slope);
        check_within("contact-impact", words("n = %.4g: force at a depth of .3", n), K * pow(depth, n), slope[3],
                     1e-14);
        whirl_rotor_free(rotor);
    }
}

/// Impacts by the law of Lankarani and Nikravesh: the rebound satisfies its first integral, and is near the coefficient
/// of restitution.
static void restitution(void **unused) {
    (void)unused;
    static const char *const digits[][2] = {{".9", NULL}, {".7", NULL}, {".5", NULL}};
    for (int i = 0; i < 3; i++) {
        const double e = strtod(digits[i][0], NULL), v = 0.3, share = 0.75 * (1.0 - e * e);
        const whirl_setting contact[] = {{"at", 0.0, "mass"},      {"gap", 1e-3, NULL},
                                         {"stiffness", 1e8, NULL}, {"law", 0.0, "lankarani_nikravesh"},
                                         {"restitution", e, NULL}, {"impact_speed", v, NULL}};
        const double rate = 2.0 * pi / 3e-3;
        whirl_rotor *rotor = make(rate, 1e-3, contact, COUNT_OF(contact), 0.0);
        whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
        double state[4] = {1.0, 0.0, v / (1e-3 * rate), 0.0};
        revolve(integrator, state, 1);
        const double back = -state[2] * 1e-3 * rate / v;
        check_within("contact-impact",
                     words("Lankarani-Nikravesh, e = %g: the first integral at the restitution found", e),
                     log((1.0 + share) / (1.0 - share * back)), share * (1.0 + back), 1e-12);
        check_within("contact-impact", words("Lankarani-Nikravesh, e = %g: restitution found, from the given one", e),
                     e, back,
                     i == 0   ? 0.014
                     : i == 1 ? 0.1
                              : 0.25);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

// ---------------------------------------------------------------- time in contact

/// Returns share of a revolution of `time` s in which a mass that flies into a stator touches it.
static double share_of(const whirl_setting *contact, size_t count, double speed, double time, const char *method,
                       double rtol) {
    const double rate = 2.0 * pi / time, state[4] = {0.999, 0.0, speed / (1e-3 * rate), 0.0};
    whirl_rotor *rotor = make(rate, 1e-3, contact, count, 0.0);
    whirl_integrate_options options = whirl_integrate_default();
    whirl_ensemble *lanes;
    double share = 0.0;
    snprintf(options.method, sizeof options.method, "%s", method);
    options.rtol = rtol;
    require_ok(whirl_ensemble_new(whirl_rotor_system(rotor), &options, 1, &lanes));
    require_ok(whirl_ensemble_load(lanes, 0, whirl_rotor_system(rotor), state));
    whirl_ensemble_revolve(lanes, 1, &(whirl_ensemble_observe){.extremes = true});
    whirl_ensemble_read(lanes, 0, &(whirl_ensemble_seen){.contact_share = &share});
    whirl_ensemble_free(lanes);
    whirl_rotor_free(rotor);
    return share / options.steps_per_revolution;
}

/// The time of contact is half a period of a spring, and that of the impacts above, at every tolerance (larger ones
/// have longer steps).
static void impacts_last(void **unused) {
    static const char *const by[] = {"dop853", "rodas5p"};
    static const double rtol[] = {1e-5, 1e-9};
    const whirl_setting spring[] = {{"at", 0.0, "mass"},
                                    {"gap", 1e-3, NULL},
                                    {"stiffness", pi * pi / 4e-6, NULL},
                                    {"power", 1.0, NULL},
                                    {"law", 0.0, "hertz"}};
    const whirl_setting lossy[] = {{"at", 0.0, "mass"},
                                   {"gap", 1e-3, NULL},
                                   {"stiffness", 1e8, NULL},
                                   {"loss", 1.0, NULL},
                                   {"law", 0.0, "hunt_crossley"}};
    (void)unused;
    for (int m = 0; m < 2; m++)
        for (int t = 0; t < 2; t++) {
            check_within("contact-share", words("a spring hit for 2 ms of 6 ms, by %s at rtol %g", by[m], rtol[t]),
                         1.0 / 3.0, share_of(spring, COUNT_OF(spring), 0.2, 6e-3, by[m], rtol[t]), 30.0 * rtol[t]);
            check_within("contact-share", words("chi = 1, v = 1: of 4 ms, by %s at rtol %g", by[m], rtol[t]),
                         2.19300804849e-3 / 4e-3, share_of(lossy, COUNT_OF(lossy), 1.0, 4e-3, by[m], rtol[t]),
                         30.0 * rtol[t] + 1e-9);
        }
}

/// Returns share, and times that contact began, of a rotor that strikes its stator, which moves, once a revolution.
static double struck_share(const char *stator, const char *method, double rtol, double *number) {
    char text[2048];
    snprintf(text, sizeof text,
             "whirl: 1\nrotor:\n  speed: 150 rad/s\n  length_scale: 1 mm\n  stations:\n"
             "    disc: {mass: 20 kg, damping: 1800 N.s/m, eccentricity: 0.5 mm}\n"
             "    stator: {mass: 5 kg, damping: 2000 N.s/m}\n  elements:\n"
             "    - spring: {between: [disc, ground], stiffness: 500 kN/m}\n"
             "    - spring: {between: [stator, ground], stiffness: 5 MN/m}\n    - gravity: {}\n    - %s\n"
             "study:\n  response: {}\n  integrate: {method: %s, rtol: %g, atol: 1e-12, steps_per_revolution: 4096, "
             "transient: 40, record: 4}\n  analyze: [rub]\n",
             stator, method, rtol);
    whirl_result *result = result_of_text(text);
    const double share = table_number(&result->tables[0], 0, WHIRL_FIELD_RUB_SHARE, 0);
    *number = table_number(&result->tables[0], 0, WHIRL_FIELD_RUB_NUMBER, 0);
    whirl_result_free(result);
    return share;
}

/// The share of contact of adaptive methods, which count steps, agrees with that of RK4, which counts instants, to an
/// instant at every end of a contact.
static void steps_count_as_instants(void **unused) {
    static const char *const stators[][2] = {
        {"hunt_crossley",
         "contact: {at: disc, gap: 0.3 mm, stiffness: 2e7, power: 1, law: hunt_crossley, loss: 0.2 s/m}"},
        {"lankarani_nikravesh in a stator that moves",
         "contact: {at: disc, from: stator, gap: 0.3 mm, stiffness: 1e9, law: lankarani_nikravesh, restitution: 0.9, "
         "impact_speed: 50 mm/s}"},
        {"hertz over an arc, with friction",
         "contact: {at: disc, gap: 0.3 mm, stiffness: 1e9, friction: 0.05, radius: 50 mm, arc: 200 deg, "
         "arc_middle: -90 deg}"},
        {"a damped rub", "rub: {at: disc, gap: 0.3 mm, stiffness: 20 MN/m, damping: 900 N.s/m, friction: 0.05}"},
        {"four blades", "blade_rub: {at: disc, from: stator, blades: 4, radius: 0.3 m, gap: 0.3 mm, stiffness: 2e6}"}};
    (void)unused;
    for (size_t s = 0; s < COUNT_OF(stators); s++) {
        static const char *const by[] = {"dop853", "rodas5p", "dop853"};
        static const double rtol[] = {1e-9, 1e-9, 1e-6};
        const char *name = stators[s][0], *stator = stators[s][1];
        double number, own;
        const double share = struck_share(stator, "rk4", 1e-9, &number), ends = 2.0 * number / (4.0 * 4096.0);
        check_holds("contact-share", words("%s: strikes and leaves", name), share > 0.01 && share < 0.99);
        for (int m = 0; m < 3; m++) {
            const double got = struck_share(stator, by[m], rtol[m], &own);
            check_within("contact-share", words("%s by %s, rtol %g, against rk4", name, by[m], rtol[m]), share, got,
                         ends);
            check_within("contact-share", words("%s by %s: contacts", name, by[m]), number, own, 0.0);
        }
    }
}

// ---------------------------------------------------------------- bristles

/// Makes an integrator by rodas5p, at a tolerance for displacements far from the centre of a flat surface.
static whirl_integrator *make_stiff(const whirl_rotor *rotor) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    snprintf(options.method, sizeof options.method, "rodas5p");
    options.limit = 1e12;
    options.rtol = 1e-15;
    options.atol = 1e-15;
    require_ok(whirl_integrator_new(whirl_rotor_system(rotor), &options, &integrator));
    return integrator;
}

/// s0 1e5, s1 sqrt(1e5), s2 .4, g from 1.5 to 1 about 1e-3 m/s, under a normal force of 1 N on a surface so wide that
/// it is flat: what moves along y slides at R omega + y'.
enum { BRISTLES = 13 };
static void bristles(double surface, whirl_setting contact[BRISTLES]) {
    const whirl_setting all[BRISTLES] = {{"at", 0.0, "mass"},
                                         {"gap", 1e10, NULL},
                                         {"stiffness", 1e-6, NULL},
                                         {"power", 1.0, NULL},
                                         {"friction_law", 0.0, "lugre"},
                                         {"friction", 1.0, NULL},
                                         {"static_friction", 1.5, NULL},
                                         {"stribeck_speed", 1e-3, NULL},
                                         {"viscous", 0.4, NULL},
                                         {"bristle_stiffness", 1e5, NULL},
                                         {"bristle_damping", sqrt(1e5), NULL},
                                         {"radius", surface, NULL}};
    memcpy(contact, all, sizeof all);
}

/// A surface that moves at constant speed meets a mass that only its inertia holds.
static void constant_sliding(void **unused) {
    (void)unused;
    static const struct {
        double v, time;
        const char *force;
    } rows[] = {{1e-4, 0.02, ".214902544348"}, {0.01, 2e-4, "2.774323217073"}};
    for (int i = 0; i < 2; i++) {
        const double rate = 2.0 * pi / rows[i].time, mass = 1e20;
        whirl_setting contact[BRISTLES];
        double state[5] = {1e10 + 1e6, 0.0, 0.0, 0.0, 0.0}, slope[5];
        whirl_design *design;
        whirl_rotor *rotor;
        bristles(rows[i].v / rate, contact);
        require_ok(whirl_design_new(rate, 1.0, &design));
        require_ok(whirl_design_station(design, "mass", (whirl_setting[]){{"mass", mass, NULL}}, 1));
        require_ok(whirl_design_element(design, "contact", contact, 12));
        require_ok(whirl_rotor_new(design, &rotor));
        whirl_design_free(design);
        whirl_integrator *integrator = make_stiff(rotor);
        revolve(integrator, state, 1);
        evaluate_rhs(whirl_rotor_system(rotor), 0.0, state, slope);
        check_digits("contact-friction", words("LuGre at a constant %g m/s: friction, N", rows[i].v), rows[i].force,
                     -slope[3] * mass * rate * rate);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

/// A mass of 1 kg on a spring of 2 N/m whose other end moves at .1 m/s, seen from that end: the ground slides by. The
/// surface is so wide that its curvature is but a spring N/r, which is taken off; a spring along x keeps N.
static void stick_slip(void **unused) {
    (void)unused;
    const double rate = 2.0 * pi / 10.0, gap = 1e4, depth = 1e5, hold = 100.0;
    whirl_setting contact[BRISTLES];
    whirl_design *design;
    whirl_rotor *rotor;
    bristles(0.1 / rate, contact);
    contact[1].number = gap;
    contact[2].number = 1.0 / depth;
    require_ok(whirl_design_new(rate, 1.0, &design));
    require_ok(whirl_design_station(design, "mass", (whirl_setting[]){{"mass", 1.0, NULL}}, 1));
    require_ok(whirl_design_element(design, "contact", contact, 12));
    const whirl_setting pull[] = {{"acceleration", 1.0 + hold * (gap + depth), NULL}, {"direction", 0.0, NULL}};
    require_ok(whirl_design_element(design, "gravity", pull, 2));
    const whirl_setting along[] = {{"between", 0.0, "mass, ground"}, {"along", 0.0, "x"}, {"stiffness", hold, NULL}};
    require_ok(whirl_design_element(design, "spring", along, 3));
    const whirl_setting spring[] = {
        {"between", 0.0, "mass, ground"}, {"along", 0.0, "y"}, {"stiffness", 2.0 - 1.0 / (gap + depth), NULL}};
    require_ok(whirl_design_element(design, "spring", spring, 3));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    whirl_integrator *integrator = make_stiff(rotor);
    double state[5] = {gap + depth, 0.0, 0.0, -0.1 / rate, 0.0};
    revolve(integrator, state, 1);
    check_digits("contact-friction", "LuGre stick-slip: place at 10 s, m", ".627583129", state[1] + 1.0);
    revolve(integrator, state, 1);
    check_within("contact-friction", "LuGre stick-slip: place at 20 s, m", 1.272596412, state[1] + 2.0, 1e-9);
    check_within("contact-friction", "LuGre stick-slip: deflection at 20 s, m", 1.453842909e-5, state[4], 1e-13);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- places, laws and derivatives

/// Contacts with a stator that moves, one for each law.
enum { LAWS = 5 };
static const struct law {
    const char *name;
    whirl_setting settings[12];
    size_t count, states;
} laws[LAWS] = {{"Hertz, sharp friction", {{"friction", 0.3, NULL}}, 1, 0},
                {"Hunt-Crossley, Stribeck, gradual",
                 {{"law", 0.0, "hunt_crossley"},
                  {"loss", 0.4, NULL},
                  {"friction_law", 0.0, "stribeck"},
                  {"friction", 0.2, NULL},
                  {"static_friction", 0.35, NULL},
                  {"stribeck_speed", 0.5, NULL},
                  {"viscous", 0.05, NULL},
                  {"slip_speed", 0.2, NULL}},
                 8,
                 0},
                {"Hunt-Crossley, Stribeck, sharp",
                 {{"law", 0.0, "hunt_crossley"},
                  {"loss", 0.4, NULL},
                  {"friction_law", 0.0, "stribeck"},
                  {"friction", 0.2, NULL},
                  {"static_friction", 0.35, NULL},
                  {"stribeck_speed", 0.5, NULL}},
                 6,
                 0},
                {"Lankarani-Nikravesh, an arc",
                 {{"law", 0.0, "lankarani_nikravesh"},
                  {"restitution", 0.8, NULL},
                  {"impact_speed", 1.5, NULL},
                  {"friction", 0.1, NULL},
                  {"slip_speed", 0.1, NULL},
                  {"arc", 2.0, NULL},
                  {"arc_middle", 0.7, NULL}},
                 7,
                 0},
                {"rollers, LuGre",
                 {{"power", 10.0 / 9.0, NULL},
                  {"friction_law", 0.0, "lugre"},
                  {"friction", 0.2, NULL},
                  {"static_friction", 0.35, NULL},
                  {"stribeck_speed", 0.5, NULL},
                  {"bristle_stiffness", 3.0, NULL},
                  {"bristle_damping", 0.7, NULL},
                  {"viscous", 0.05, NULL}},
                 8,
                 1}};

static whirl_rotor *make_law(const struct law *law) {
    whirl_design *design;
    whirl_rotor *rotor;
    whirl_setting settings[17] = {{"at", 0.0, "mass"},
                                  {"from", 0.0, "stator"},
                                  {"gap", 0.5, NULL},
                                  {"stiffness", 6.0, NULL},
                                  {"radius", 0.8, NULL}};
    memcpy(settings + 5, law->settings, law->count * sizeof *settings);
    require_ok(whirl_design_new(1.0, 1.0, &design));
    require_ok(whirl_design_station(design, "mass", (whirl_setting[]){{"mass", 1.0, NULL}}, 1));
    require_ok(whirl_design_station(design, "stator", (whirl_setting[]){{"mass", 4.0, NULL}}, 1));
    require_ok(whirl_design_element(design, "contact", settings, 5 + law->count));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

static double uniform(uint64_t *seed, double low, double high) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

/// Returns largest difference of a switch's gradient and curvature from differences of the switch and of the gradient.
static double compare_switches(const whirl_system *system, const double *x) {
    double worst = 0.0, largest;
    for (size_t which = 0; which < system->switch_count; which++)
        worst = fmax(worst, switch_apart(system, x, which, 1e-5, &largest));
    return worst;
}

static void derivatives(void **unused) {
    (void)unused;
    for (int k = 0; k < LAWS; k++) {
        whirl_rotor *rotor = make_law(&laws[k]);
        const whirl_system *system = whirl_rotor_system(rotor);
        const size_t n = system->dimension;
        uint64_t seed = 5;
        double worst = 0.0, switches = 0.0, action = 0.0;
        assert_int_equal(n, 8 + laws[k].states);
        for (int trial = 0; trial < 300; trial++) {
            double x[9], values[8], exact[81], differences[81], slope[9];
            const double angle = uniform(&seed, 0.0, 6.28), r = uniform(&seed, 0.3, 0.9);
            for (size_t i = 0; i < n; i++) x[i] = uniform(&seed, -1.0, 1.0);
            x[0] = x[2] + r * cos(angle);
            x[1] = x[3] + r * sin(angle);
            system->switches(system->model, 0.0, x, values);
            for (size_t i = 0; i < system->switch_count; i++)
                if (fabs(values[i]) < 0.02) goto next; // differences would go over it
            exact_jacobian(system, 0.0, x, exact);
            rhs_jacobian(system, 0.0, x, 1e-3, differences);
            for (size_t i = 0; i < n * n; i++) worst = fmax(worst, fabs(exact[i] - differences[i]));
            evaluate_rhs(system, 0.0, x, slope);
            for (int a = 0; a < 2; a++) action = fmax(action, fabs(slope[4 + a] + 4.0 * slope[6 + a]));
            switches = fmax(switches, compare_switches(system, x));
        next:;
        }
        check_within("contact-laws", words("%s: difference of the derivative from differences", laws[k].name), 0.0,
                     worst, 1e-8);
        check_within("contact-laws", words("%s: the same of switches, and of their derivatives", laws[k].name), 0.0,
                     switches, 1e-7);
        check_within("contact-laws", words("%s: force on the stator, from the opposite one", laws[k].name), 0.0, action,
                     1e-14);
        whirl_rotor_free(rotor);
    }
}

/// Makes a disc on a spring with unbalance, in a ring by one element or the other.
static whirl_rotor *make_ring(const char *kind) {
    const whirl_setting ring[] = {{"at", 0.0, "mass"},      {"gap", 1.0, NULL},    {"stiffness", 10.0, NULL},
                                  {"friction", 0.05, NULL}, {"radius", 3.0, NULL}, {"power", 1.0, NULL}};
    const whirl_setting slip = {"law", 0.0, "slip"};
    whirl_setting rub[6];
    whirl_design *design;
    whirl_rotor *rotor;
    memcpy(rub, ring, sizeof ring);
    rub[5] = slip;
    require_ok(whirl_design_new(3.3, 1.0, &design));
    const whirl_setting mass[] = {{"mass", 1.0, NULL}, {"damping", 0.2, NULL}, {"eccentricity", 0.9, NULL}};
    require_ok(whirl_design_station(design, "mass", mass, 3));
    const whirl_setting spring[] = {{"between", 0.0, "mass, ground"}, {"stiffness", 1.0, NULL}};
    require_ok(whirl_design_element(design, "spring", spring, 2));
    require_ok(whirl_design_element(design, kind, strcmp(kind, "rub") == 0 ? rub : ring, 6));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// With n = 1 and one coefficient a contact is a rub that follows the slip.
static void as_a_rub(void **unused) {
    (void)unused;
    double state[2][4] = {{0.1, -0.2, 0.0, -2.0}, {0.1, -0.2, 0.0, -2.0}}, worst = 0.0;
    whirl_rotor *rotors[2] = {make_ring("contact"), make_ring("rub")};
    whirl_integrator *integrators[2];
    for (int i = 0; i < 2; i++) integrators[i] = make_integrator(whirl_rotor_system(rotors[i]), "dop853", 64);
    for (int turn = 0; turn < 12; turn++) {
        for (int i = 0; i < 2; i++) revolve(integrators[i], state[i], 1);
        for (int i = 0; i < 4; i++) worst = fmax(worst, fabs(state[0][i] - state[1][i]));
    }
    check_within("contact-laws", "n = 1, Coulomb: largest difference from a rub over 12 revolutions", 0.0, worst, 1e-9);
    for (int i = 0; i < 2; i++) {
        whirl_integrator_free(integrators[i]);
        whirl_rotor_free(rotors[i]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(impacts),    cmocka_unit_test(impacts_last), cmocka_unit_test(steps_count_as_instants),
        cmocka_unit_test(powers),     cmocka_unit_test(restitution),  cmocka_unit_test(constant_sliding),
        cmocka_unit_test(stick_slip), cmocka_unit_test(derivatives),  cmocka_unit_test(as_a_rub)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
