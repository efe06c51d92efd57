// Roller bearings, oblique contacts, rows and dents: equilibria by other programs, forces and their derivatives against
// the equations as the literature writes them in complex numbers, and a motion by another program.
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
#include "whirl/engine.h"

typedef long double complex number;

static const double pi = 3.14159265358979323846;

enum { MAX_SETTINGS = 20 };

/// Makes a mass in a bearing under a weight along x.
static whirl_rotor *make(const char *kind, double speed, double scale, double mass, double weight,
                         const whirl_setting *keys) {
    const whirl_setting station[] = {{"mass", mass, NULL}},
                        down[] = {{"acceleration", weight / mass, NULL}, {"direction", 0.0, NULL}};
    size_t count = 0;
    whirl_design *design;
    whirl_rotor *built;
    while (keys[count].key) count++;
    require_ok(whirl_design_new(speed, scale, &design));
    require_ok(whirl_design_station(design, "rotor", station, 1));
    require_ok(whirl_design_element(design, kind, keys, count));
    require_ok(whirl_design_element(design, "gravity", down, 2));
    require_ok(whirl_rotor_new(design, &built));
    whirl_design_free(design);
    return built;
}

// ---------------------------------------------------------------- equilibria of rollers

/// Returns the position of rest under a weight along x, in length scales.
static double rest_of(const whirl_system *system, double low, double high) {
    double x[8] = {0}, slope[8];
    for (int i = 0; i < 200; i++) {
        x[0] = 0.5 * (low + high);
        evaluate_rhs(system, 0.0, x, slope);
        *(slope[2] > 0.0 ? &low : &high) = x[0];
    }
    return x[0];
}

/// 14 rollers, 2e8 N/m^(10/9), 5 um, 3000 N along x.
static void rollers_under_a_load(void **unused) {
    (void)unused;
    static const char *const expected[2][3] = {{"2.130053050427e-5", "216731506", "98230696"},
                                               {"2.122235089419e-5", "221570716", "146491485"}};
    static const char *const places[] = {"a roller under the load", "the load between two"};
    for (int i = 0; i < 2; i++) {
        const whirl_setting keys[] = {
            {"at", 0, "rotor"},  {"rollers", 14, NULL},          {"stiffness", 2e8, NULL}, {"clearance", 5e-6, NULL},
            {"cage", 0.4, NULL}, {"angle", i * pi / 14.0, NULL}, {NULL, 0, NULL}};
        const double speed = 100.0, scale = 1e-5, mass = 10.0, force = mass * speed * speed;
        whirl_rotor *rotor = make("roller_bearing", speed, scale, mass, 3000.0, keys);
        const whirl_system *system = whirl_rotor_system(rotor);
        double x[5] = {rest_of(system, 0.5, 10.0)}, matrix[25];
        exact_jacobian(system, 0.0, x, matrix);
        check_digits("rolling", words("%s: x, m", places[i]), expected[i][0], x[0] * scale);
        check_digits("rolling", words("%s: kxx, N/m", places[i]), expected[i][1], -force * matrix[5 * 2]);
        check_digits("rolling", words("%s: kyy, N/m", places[i]), expected[i][2], -force * matrix[5 * 3 + 1]);
        whirl_rotor_free(rotor);
    }
}

/// Returns the weight that 9 rollers of 1e9 N/m^(10/9) carry at a displacement, averaged over their angles.
static double carried(double displacement, double clearance) {
    enum { ANGLES = 20000 };
    double sum = 0.0;
    for (int i = 0; i < ANGLES; i++) {
        const double cosine = cos(2.0 * pi * (i + 0.5) / ANGLES), approach = displacement * cosine - clearance;
        if (approach > 0.0) sum += 1e9 * pow(approach, 10.0 / 9.0) * cosine;
    }
    return 9.0 * sum / ANGLES;
}

/// A journal in a bearing with play, in its middle, touches nothing and has no stiffness: it falls until rollers carry
/// 98 N, however slowly the shaft turns.
static void loose_bearings_come_to_rest(void **unused) {
    static const double speeds[] = {0.0, 1e-9, 100.0}, clearances[] = {0.0, 1e-9, 1e-6};
    (void)unused;
    for (size_t c = 0; c < 3; c++) {
        double low = clearances[c], high = clearances[c] + 1e-5;
        for (int i = 0; i < 60; i++)
            *(carried(0.5 * (low + high), clearances[c]) < 98.0 ? &low : &high) = 0.5 * (low + high);
        for (size_t s = 0; s < 3; s++) {
            const whirl_setting keys[] = {{"at", 0, "rotor"},       {"rollers", 9, NULL},
                                          {"stiffness", 1e9, NULL}, {"clearance", clearances[c], NULL},
                                          {"cage", 0.4, NULL},      {NULL, 0, NULL}};
            whirl_rotor *rotor = make("roller_bearing", speeds[s], 1e-5, 10.0, 98.0, keys);
            double x[8] = {0};
            require_ok(whirl_equilibrium(whirl_rotor_system(rotor), x));
            check_within("rolling",
                         words("play of %g um at %g rad/s: place of rest, m", 1e6 * clearances[c], speeds[s]), low,
                         x[0] * 1e-5, 1e-3 * low);
            whirl_rotor_free(rotor);
        }
    }
}

// ---------------------------------------------------------------- forces

/// A bearing by its equations, in SI.
typedef struct rolling {
    const char *name, *kind;
    int balls, rows;
    bool staggered;
    double power, stiffness, clearance, inner, outer, start;
    double angle, centres, axial_load;
    double depth[3], width[3], place[2]; ///< of dents: inner race, outer race, ball
} rolling;

/// Returns axial displacement of the centred row under its load, by the secant method.
static long double axial_of(const rolling *b) {
    const long double radial = b->centres * cosl(b->angle) - b->clearance, zero = b->centres * sinl(b->angle);
    long double x[3] = {1e-4L, 2e-4L, 0.0L}, f[2];
    if (b->axial_load == 0.0) return 0.0L;
    for (int i = 0; i < 60; i++) {
        for (int k = 0; k < 2; k++) {
            const long double apart = hypotl(radial, zero + x[k]), deep = fmaxl(apart - b->centres, 0.0L);
            f[k] = b->balls * b->stiffness * powl(deep, 1.5L) * (zero + x[k]) / apart - b->axial_load;
        }
        if (f[1] == f[0] || fabsl(f[1]) < 1e-15L * b->axial_load) break;
        x[2] = x[1] - f[1] * (x[1] - x[0]) / (f[1] - f[0]);
        x[0] = x[1];
        x[1] = x[2];
    }
    return x[1];
}

static number dent_of(const rolling *b, int which, number angle) {
    const long double turns = roundl(creall(angle) / (2.0L * acosl(-1.0L)));
    const number off = angle - turns * 2.0L * acosl(-1.0L);
    if (b->depth[which] == 0.0 || fabsl(creall(off)) > 0.5L * b->width[which]) return 0.0L;
    return 0.5L * b->depth[which] * (1.0L + ccosl(2.0L * acosl(-1.0L) * off / b->width[which]));
}

/// Computes the force at a place, with the angles of cage, races and ball from their start.
static void force_of(const rolling *b, const number d[2], const number s[4], number force[2]) {
    const long double tau = 2.0L * acosl(-1.0L), axial = b->centres * sinl(b->angle) + axial_of(b);
    force[0] = force[1] = 0.0L;
    for (int row = 0; row < b->rows; row++)
        for (int j = 0; j < b->balls; j++) {
            const long double shift = b->staggered ? (long double)row / b->rows : 0.0L;
            const number theta = s[0] + b->start + tau * (j + shift) / b->balls, c = ccosl(theta), w = csinl(theta);
            const number r = d[0] * c + d[1] * w;
            number deep = r - b->clearance, lever = 1.0L;
            if (b->centres > 0.0) {
                const number reach = b->centres * cosl(b->angle) - b->clearance + r;
                const number apart = csqrtl(reach * reach + axial * axial);
                deep = apart - b->centres;
                lever = reach / apart;
            }
            for (int race = 0; race < 2; race++) deep -= dent_of(b, race, theta - s[1 + race] - b->place[race]);
            if (j == 0) deep -= dent_of(b, 2, s[3]) + dent_of(b, 2, s[3] + 0.5L * tau);
            if (creall(deep) <= 0.0L) continue;
            const number push = b->stiffness * cpowl(deep, (long double)b->power) * lever;
            force[0] -= push * c;
            force[1] -= push * w;
        }
}

static whirl_rotor *make_rolling(const rolling *b, double speed, double scale, double mass, double weight,
                                 double damping) {
    whirl_setting keys[MAX_SETTINGS + 4] = {{"at", 0, "rotor"}};
    size_t n = 1;
    const bool balls = b->power == 1.5;
    const struct {
        const char *key;
        double value, without;
    } all[] = {{balls ? "balls" : "rollers", b->balls, 0},
               {"stiffness", b->stiffness, 0},
               {"clearance", b->clearance, 0},
               {"inner", b->inner, 0},
               {"outer", b->outer, 0},
               {"angle", b->start, 0},
               {"rows", b->rows, 1},
               {"contact_angle", b->angle, 0},
               {"centres", b->centres, 0},
               {"axial_load", b->axial_load, 0},
               {"damping", damping, 0},
               {"inner_dent", b->depth[0], 0},
               {"inner_dent_width", b->width[0], 0},
               {"inner_dent_angle", b->place[0], 0},
               {"outer_dent", b->depth[1], 0},
               {"outer_dent_width", b->width[1], 0},
               {"outer_dent_angle", b->place[1], 0},
               {balls ? "ball_dent" : "roller_dent", b->depth[2], 0},
               {balls ? "ball_dent_width" : "roller_dent_width", b->width[2], 0}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (all[i].value != all[i].without || (strstr(all[i].key, "outer_dent") && b->width[1] > 0.0))
            keys[n++] = (whirl_setting){all[i].key, all[i].value, NULL};
    if (b->rows > 1) keys[n++] = (whirl_setting){"staggered", 0, b->staggered ? "yes" : "no"};
    return make(b->kind, speed, scale, mass, weight, keys);
}

/// Computes the rates, over the shaft's, of cage, races and a ball about its own axis: rolling, with the outer race at
/// rest.
static void rates_of(const rolling *b, double rates[4]) {
    const double cage = b->inner / (b->inner + b->outer);
    const double axial = b->centres * sin(b->angle) + (double)axial_of(b);
    const double angle = b->centres > 0.0 ? atan2(axial, b->centres * cos(b->angle) - b->clearance) : 0.0;
    rates[0] = cage;
    rates[1] = 1.0;
    rates[2] = 0.0;
    rates[3] = (1.0 - cage) * b->inner / ((b->outer - b->inner) / (2.0 * cos(angle)));
}

#define SIZES .stiffness = 1.2e10, .inner = 0.02, .outer = 0.032, .start = 0.3

static const rolling samples[] = {
    {"rollers", "roller_bearing", 11, 1, true, 10.0 / 9.0, 3e8, 4e-6, 0.02, 0.032, 0.3, 0, 0, 0, {0}, {0}, {0}},
    {"rollers, preload, two rows side by side",
     "roller_bearing",
     11,
     2,
     false,
     10.0 / 9.0,
     3e8,
     -4e-6,
     0.02,
     0.032,
     0.3,
     0,
     0,
     0,
     {0},
     {0},
     {0}},
    {"balls, preload", "ball_bearing", 9, 1, true, 1.5, .clearance = -3e-6, SIZES},
    {"balls, three staggered rows", "ball_bearing", 9, 3, true, 1.5, .clearance = 3e-6, SIZES},
    {"contact angle 25 degrees, 800 N", "ball_bearing", 9, 1, true, 1.5, SIZES, .angle = 0.4363323129985824,
     .centres = 6e-4, .axial_load = 800.0},
    {"deep grooves, clearance, 500 N", "ball_bearing", 9, 1, true, 1.5, .clearance = 6e-6, SIZES, .centres = 5e-4,
     .axial_load = 500.0},
    {"dents of both races", "ball_bearing", 9, 1, true, 1.5, .clearance = 2e-6, SIZES, .depth = {4e-6, 3e-6, 0},
     .width = {0.9, 0.7, 0}, .place = {1.2, -0.4}},
    {"all dents, oblique", "ball_bearing", 9, 1, true, 1.5, SIZES, .angle = 0.3, .centres = 6e-4, .axial_load = 300.0,
     .depth = {4e-6, 3e-6, 5e-6}, .width = {0.9, 0.7, 1.6}, .place = {1.2, -0.4}},
    {"rollers, all dents",
     "roller_bearing",
     11,
     1,
     true,
     10.0 / 9.0,
     3e8,
     -1e-6,
     0.02,
     0.032,
     0.3,
     0,
     0,
     0,
     {4e-6, 3e-6, 5e-6},
     {0.9, 0.7, 1.6},
     {1.2, -0.4}},
};

/// Computes accelerations and slopes of states by the equations, in the rotor's scales.
static void by_equations(const rolling *b, double speed, double scale, double mass, double weight, const number *x,
                         size_t states, number *slope) {
    double rates[4];
    number d[2] = {x[0] * scale, x[1] * scale}, s[4] = {0}, force[2];
    rates_of(b, rates);
    for (size_t i = 0; i < states; i++) {
        s[i] = x[4 + i];
        slope[4 + i] = i == 0 || b->depth[i - 1] > 0.0 ? rates[i] : 0.0;
    }
    force_of(b, d, s, force);
    force[0] += weight;
    for (int a = 0; a < 2; a++) {
        slope[a] = x[2 + a];
        slope[2 + a] = force[a] / (mass * speed * speed * scale);
    }
}

/// At 200 places each: the slopes, and their derivatives by complex steps.
static void forces_as_written(void **unused) {
    (void)unused;
    enum { PLACES = 200, ROWS = 8 };
    const double speed = 500.0, scale = 1e-6, mass = 4.0, weight = 40.0;
    for (size_t i = 0; i < sizeof samples / sizeof *samples; i++) {
        const rolling *b = &samples[i];
        whirl_rotor *rotor = make_rolling(b, speed, scale, mass, weight, 0.0);
        const whirl_system *system = whirl_rotor_system(rotor);
        const size_t n = system->dimension, states = n - 4;
        double worst = 0.0, worst_slope = 0.0, size = 0.0, size_slope = 0.0;
        assert_int_equal(states, b->depth[0] + b->depth[1] + b->depth[2] > 0.0 ? 4 : 1);
        for (int place = 0; place < PLACES; place++) {
            double x[ROWS] = {0}, slope[ROWS], matrix[ROWS * ROWS];
            for (size_t k = 0; k < n; k++) x[k] = (k < 2 ? 12.0 : 3.0) * sin(1.7 * place + 2.3 * (double)k + 0.4);
            evaluate_rhs(system, 0.0, x, slope);
            exact_jacobian(system, 0.0, x, matrix);
            for (size_t by = 0; by < n; by++) {
                number at[ROWS], out[ROWS];
                for (size_t k = 0; k < n; k++) at[k] = x[k] + (k == by ? 1e-25L * I : 0.0L);
                by_equations(b, speed, scale, mass, weight, at, states, out);
                for (size_t k = 0; k < n; k++) {
                    const double expected = (double)creall(out[k]), derivative = (double)(cimagl(out[k]) * 1e25L);
                    worst = fmax(worst, fabs(slope[k] - expected));
                    size = fmax(size, fabs(expected));
                    worst_slope = fmax(worst_slope, fabs(matrix[n * k + by] - derivative));
                    size_slope = fmax(size_slope, fabs(derivative));
                }
            }
        }
        check_within("rolling", words("%s: slopes, part of the largest", b->name), 0.0, worst / size, 1e-13);
        check_within("rolling", words("%s: derivatives, part of the largest", b->name), 0.0, worst_slope / size_slope,
                     1e-10);
        whirl_rotor_free(rotor);
    }
}

// ---------------------------------------------------------------- a motion, and what fits the revolution

/// Five revolutions with all dents, oblique contacts, from 5 um: by scipy's DOP853 (rtol 1e-13, steps of a 6000th of a
/// revolution at most; with a 2000th the displacements differ by 1e-11, the velocities by 2e-7).
static void motion_over_dents(void **unused) {
    (void)unused;
    static const char *const methods[] = {"dop853", "rk4"};
    static const double expected[4] = {4.25036434324789, 0.556946533425296, 2718.3858055316837, 3444.4503213682815};
    static const char *const names[4] = {"x, um", "y, um", "x', um/s", "y', um/s"};
    whirl_rotor *rotor = make_rolling(&samples[7], 500.0, 1e-6, 4.0, 400.0, 300.0);
    for (int m = 0; m < 2; m++) {
        whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), methods[m], 20000);
        double x[8] = {5.0};
        revolve(integrator, x, 5);
        for (int k = 0; k < 4; k++)
            check_within("rolling", words("over dents by %s: %s", methods[m], names[k]), expected[k],
                         x[k] * (k < 2 ? 1.0 : 500.0), k < 2 ? 1e-8 : 5e-5);
        whirl_integrator_free(integrator);
    }
    whirl_rotor_free(rotor);
}

/// A revolution over dents of other depths in lanes, and by the integrator.
static void dents_in_lanes(void **unused) {
    (void)unused;
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    enum { LANES = 5 };
    for (size_t m = 0; m < sizeof methods / sizeof *methods; m++) {
        whirl_rotor *rotors[LANES];
        double x[LANES][8], y[LANES][8], worst = 0.0;
        for (int l = 0; l < LANES; l++) {
            rolling b = samples[7];
            b.depth[1] = 1e-6 * l;
            rotors[l] = make_rolling(&b, 500.0, 1e-6, 4.0, 400.0, 300.0);
        }
        carry_both(methods[m], 2048, rotors, LANES, (double[8]){5.0, 0.5}, 1, y[0], x[0]);
        for (size_t l = 0; l < LANES; l++)
            for (int k = 0; k < 8; k++) { // a race has turned once: 0 or 2 pi, by rounding
                const double apart = x[l][k] - y[l][k];
                worst = fmax(worst, k < 4 ? fabs(apart) : fabs(2.0 * sin(0.5 * apart)));
            }
        check_within("rolling", words("dents in lanes by %s and by the integrator, um", methods[m]), 0.0, worst, 1e-8);
        for (int l = 0; l < LANES; l++) whirl_rotor_free(rotors[l]);
    }
}

/// Radii 1 to 3: the cage at a quarter of the speed, balls about themselves at three quarters.
static void common_periods(void **unused) {
    (void)unused;
    const rolling bearing = {"", "ball_bearing", 8, 1, true, 1.5, 1e10, 0, 0.01, 0.03, 0, 0, 0, 0, {0}, {0}, {0}};
    static const size_t expected[] = {1, 1, 1, 4};
    for (int dent = -1; dent < 3; dent++) {
        rolling b = bearing;
        if (dent >= 0) b.depth[dent] = 1e-6, b.width[dent] = 0.5;
        whirl_rotor *rotor = make_rolling(&b, 500.0, 1e-6, 4.0, 40.0, 0.0);
        assert_int_equal(whirl_rotor_system(rotor)->repeats, expected[dent + 1]);
        whirl_rotor_free(rotor);
    }
}

static void wrong_ones_are_refused(void **unused) {
    (void)unused;
    static const struct {
        whirl_setting key[3];
        const char *words;
    } rows[] = {
        {{{"inner_dent", 1e-6, NULL}}, "has inner_dent without inner_dent_width, expected both"},
        {{{"outer_dent_width", 0.1, NULL}}, "has outer_dent_width without outer_dent, expected both"},
        {{{"ball_dent", 1e-6, NULL}, {"ball_dent_width", 3.0, NULL}}, "at most 2.0944 rad, 120 degrees"},
        {{{"inner_dent", 1e-6, NULL}, {"inner_dent_width", 0.1, NULL}, {"rows", 2, NULL}}, "has dents and 2 rows"},
        {{{"axial_load", 100.0, NULL}}, "has axial_load without centres"},
        {{{"contact_angle", 0.3, NULL}}, "has contact_angle without centres"},
        {{{"centres", 1e-6, NULL}, {"clearance", 2e-6, NULL}},
         "has a clearance of 2e-06 m, expected less than 1e-06 m"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const whirl_setting mass = {"mass", 1.0, NULL};
        whirl_setting keys[8] = {{"at", 0, "rotor"},
                                 {"balls", 8, NULL},
                                 {"stiffness", 1e10, NULL},
                                 {"inner", 0.02, NULL},
                                 {"outer", 0.03, NULL}};
        size_t count = 5;
        whirl_design *design;
        whirl_rotor *rotor;
        for (int k = 0; k < 3 && rows[i].key[k].key; k++) keys[count++] = rows[i].key[k];
        require_ok(whirl_design_new(100.0, 1e-6, &design));
        require_ok(whirl_design_station(design, "rotor", &mass, 1));
        require_ok(whirl_design_element(design, "ball_bearing", keys, count));
        const whirl_status status = whirl_rotor_new(design, &rotor);
        if (status.code != WHIRL_BAD_INPUT || !strstr(status.message, rows[i].words))
            fail_msg("row %zu: %s", i, status.message);
        whirl_design_free(design);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rollers_under_a_load),  cmocka_unit_test(loose_bearings_come_to_rest),
        cmocka_unit_test(forces_as_written),     cmocka_unit_test(motion_over_dents),
        cmocka_unit_test(dents_in_lanes),        cmocka_unit_test(common_periods),
        cmocka_unit_test(wrong_ones_are_refused)};
    return cmocka_run_group_tests_name("rolling", tests, NULL, NULL);
}
