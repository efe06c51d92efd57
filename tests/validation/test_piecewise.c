// Cases L1 to L4: a mass on springs whose slope changes with the displacement (a seat that lifts, play). Within a piece
// the equation is linear and solved in closed form; a revolution is 2 pi s, masses are 1 kg, lengths in m.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/rotor.h"

static const double pi = 3.14159265358979323846;

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

// ---------------------------------------------------------------- machines

/// An element with its settings.
typedef struct part {
    const char *kind;
    whirl_setting settings[9];
} part;

static size_t count_settings(const part *of) {
    size_t count = 0;
    while (count < COUNT_OF(of->settings) && of->settings[count].key) count++;
    return count;
}

/// Makes stations that move along y, each with its mass, at 1 rad/s.
static whirl_rotor *make_rotor(const double *masses, size_t stations, const part *parts, size_t count) {
    static const char *const names[] = {"upper", "lower"};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(1.0, 1.0, &design));
    for (size_t s = 0; s < stations; s++) {
        const whirl_setting settings[] = {{"mass", masses[s], NULL}, {"moves", 0.0, "y"}};
        require_ok(whirl_design_station(design, names[s], settings, COUNT_OF(settings)));
    }
    for (size_t i = 0; i < count; i++)
        require_ok(whirl_design_element(design, parts[i].kind, parts[i].settings, count_settings(&parts[i])));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

static whirl_integrate_options options_of(const char *method) {
    whirl_integrate_options options = whirl_integrate_default();
    snprintf(options.method, sizeof options.method, "%s", method);
    options.steps_per_revolution = strcmp(method, "rk4") == 0 ? 8192 : 64;
    options.located = true;
    options.rtol = 1e-14;
    options.atol = 1e-15;
    return options;
}

static whirl_integrator *make(const whirl_rotor *rotor, const char *method) {
    const whirl_integrate_options options = options_of(method);
    whirl_integrator *integrator;
    require_ok(whirl_integrator_new(whirl_rotor_system(rotor), &options, &integrator));
    return integrator;
}

// ---------------------------------------------------------------- the closed form

/// y'' = p - k y - c y' + F sin t, 0 < c^2 < 4 k or c = 0, from `low` to `high`.
typedef struct piece {
    double low, high, k, c, p;
} piece;

typedef struct exact {
    piece pieces[3];
    double force; ///< F
} exact;

/// Computes (y, v) of the piece's equation `span` after (y, v) at t.
static void follow(const exact *of, const piece *on, double t, double span, const double from[2], double to[2]) {
    const double square = (on->k - 1.0) * (on->k - 1.0) + on->c * on->c, rest = on->p / on->k;
    const double a = of->force * (on->k - 1.0) / square, b = -of->force * on->c / square, end = t + span;
    const double d = 0.5 * on->c, w = sqrt(on->k - d * d);
    const double y = from[0] - rest - a * sin(t) - b * cos(t), v = from[1] - a * cos(t) + b * sin(t);
    const double s = sin(w * span), c = cos(w * span), decay = exp(-d * span), q = (v + d * y) / w;
    to[0] = rest + a * sin(end) + b * cos(end) + decay * (y * c + q * s);
    to[1] = a * cos(end) - b * sin(end) + decay * (v * c - (d * q + w * y) * s);
}

static int locate(const exact *of, const double x[2]) {
    int at = 0;
    while (x[0] > of->pieces[at].high || (x[0] == of->pieces[at].high && x[1] > 0.0)) at++;
    return at;
}

/// Returns the time at which (y, v) leaves the piece, by bisection; y is outside at `span`.
static double time_of_exit(const exact *of, const piece *on, double t, double span, const double x[2]) {
    double inside = 0.0, outside = span, y[2];
    for (int i = 0; i < 200; i++) {
        const double middle = 0.5 * (inside + outside);
        follow(of, on, t, middle, x, y);
        if (y[0] < on->low || y[0] > on->high)
            outside = middle;
        else
            inside = middle;
    }
    return outside;
}

/// Carries x [2] over one revolution; *volume is increased by the integral of -c.
static void revolve_exactly(const exact *of, double x[2], double *volume) {
    enum { LOOKS = 4096 };
    int at = locate(of, x), crossings = 0;
    for (int i = 0; i < LOOKS; i++) {
        double t = 2.0 * pi * i / LOOKS, y[2];
        const double end = 2.0 * pi * (i + 1) / LOOKS;
        for (;;) {
            const piece *on = &of->pieces[at];
            follow(of, on, t, end - t, x, y);
            const bool left = y[0] < on->low || y[0] > on->high;
            const double span = left ? time_of_exit(of, on, t, end - t, x) : end - t;
            follow(of, on, t, span, x, y);
            memcpy(x, y, sizeof y);
            *volume -= on->c * span;
            if (!left) break;
            t += span;
            at += x[1] > 0.0 ? 1 : -1;
            if (++crossings > 1000) fail_msg("the closed form rattles");
        }
    }
}

// ---------------------------------------------------------------- L1

/// Two slopes k1 = 4, k2 = 4/9 N/m: the period is pi (1/w1 + 1/w2) = 2 pi, and amplitudes are as the frequencies.
static const whirl_setting two_slopes[] = {{"stiffness", 4.0, NULL}, {"loose_stiffness", 4.0 / 9.0, NULL}};

static void record_middle(void *observer, double t, const double *x) {
    if (fabs(t - pi) < 1e-9) memcpy(observer, x, 4 * sizeof *x);
}

static void l1_seat_on_ground(void **unused) {
    static const double one = 1.0;
    const part seat = {"looseness", {{"between", 0.0, "upper, ground"}, two_slopes[0], two_slopes[1]}};
    whirl_rotor *rotor = make_rotor(&one, 1, &seat, 1);
    (void)unused;
    for (int m = 0; m < 2; m++) {
        static const char *const methods[] = {"dop853", "rk4"};
        const char *method = methods[m];
        whirl_integrator *integrator = make(rotor, method);
        double x[2] = {0.9, 0.0}, middle[4] = {0.0}, y[2] = {0.0, 0.6};
        for (int i = 0; i < 10; i++) {
            assert_int_equal(whirl_integrator_revolve(integrator, x, record_middle, middle), WHIRL_BOUNDED);
            assert_int_equal(whirl_integrator_revolve(integrator, y, NULL, NULL), WHIRL_BOUNDED);
        }
        check_within("L1", words("%s, after 10 periods pi (1/w1 + 1/w2): y", method), 0.9, x[0], 1e-10);
        check_within("L1", words("%s, y'", method), 0.0, x[1], 1e-10);
        check_within("L1", words("%s, half a revolution earlier: y = -A2 w2/w1", method), -0.3, middle[0], 1e-10);
        check_within("L1", words("%s, from the switch itself: y", method), 0.0, y[0], 1e-10);
        check_within("L1", words("%s, from the switch itself: y'", method), 0.6, y[1], 1e-10);
        whirl_integrator_free(integrator);
    }
    whirl_rotor_free(rotor);
}

/// Two masses of 2 kg: their distance moves as the one of 1 kg, their centre uniformly.
static void l1_seat_on_station(void **unused) {
    static const double masses[] = {2.0, 2.0};
    const part seat = {"looseness", {{"between", 0.0, "upper, lower"}, two_slopes[0], two_slopes[1]}};
    whirl_rotor *rotor = make_rotor(masses, 2, &seat, 1);
    whirl_integrator *integrator = make(rotor, "dop853");
    double x[4] = {0.45, -0.45, 0.01, 0.01};
    (void)unused;
    for (int i = 0; i < 10; i++) assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
    check_within("L1", "two stations, dop853, after 10 periods: distance", 0.9, x[0] - x[1], 1e-10);
    check_within("L1", "two stations: centre", 0.2 * pi, 0.5 * (x[0] + x[1]), 1e-10);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- L2, L3: forced, three pieces

/// Returns largest distance from the closed form at the ends of 10 revolutions.
static double compare_alone(const whirl_rotor *rotor, const exact *of, const char *method, const double start[2]) {
    whirl_integrator *integrator = make(rotor, method);
    double x[2] = {start[0], start[1]}, y[2] = {start[0], start[1]}, worst = 0.0, volume = 0.0;
    for (int i = 0; i < 10; i++) {
        assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
        revolve_exactly(of, y, &volume);
        worst = fmax(worst, hypot(x[0] - y[0], x[1] - y[1]));
    }
    whirl_integrator_free(integrator);
    return worst;
}

static const double starts[][2] = {{0.0, 0.0}, {0.8, 0.3}, {-0.3, -0.9}, {0.1, 0.7}, {-0.6, 0.4}, {1.2, 0.0}};
enum { STARTS = COUNT_OF(starts) };

/// Returns the same distance in lanes, all starts side by side.
static double compare_lanes(const whirl_rotor *rotor, const exact *of, const char *method) {
    const whirl_integrate_options options = options_of(method);
    const whirl_system *system = whirl_rotor_system(rotor);
    whirl_ensemble *ensemble;
    double x[2], y[STARTS][2], worst = 0.0, volume = 0.0;
    assert_true(whirl_ensemble_takes(system, &options));
    require_ok(whirl_ensemble_new(system, &options, STARTS, &ensemble));
    memcpy(y, starts, sizeof y);
    for (size_t s = 0; s < STARTS; s++) require_ok(whirl_ensemble_load(ensemble, s, system, starts[s]));
    for (int i = 0; i < 10; i++) {
        whirl_ensemble_revolve(ensemble, STARTS, NULL);
        for (size_t s = 0; s < STARTS; s++) {
            whirl_ensemble_state(ensemble, s, x);
            revolve_exactly(of, y[s], &volume);
            worst = fmax(worst, hypot(x[0] - y[s][0], x[1] - y[s][1]));
        }
    }
    whirl_ensemble_free(ensemble);
    return worst;
}

static void compare_all(const char *id, const char *what, const whirl_rotor *rotor, const exact *of) {
    static const char *const methods[] = {"dop853", "rk4", "cvode-adams"};
    for (size_t m = 0; m < COUNT_OF(methods); m++) {
        double worst = 0.0;
        for (size_t s = 0; s < STARTS; s++) worst = fmax(worst, compare_alone(rotor, of, methods[m], starts[s]));
        check_within(id, words("%s, %s, largest error in 10 revolutions", what, methods[m]), 0.0, worst, 1e-9);
    }
    for (size_t m = 0; m < 2; m++)
        check_within(id, words("%s, %s in lanes", what, methods[m]), 0.0, compare_lanes(rotor, of, methods[m]), 1e-9);
}

/// Mass 1 kg, unbalance .3 kg m, gravity .2 m/s2.
static const part unbalance = {"unbalance", {{"at", 0.0, "upper"}, {"moment", 0.3, NULL}}};
static const part gravity = {"gravity", {{"acceleration", 0.2, NULL}}};

static whirl_rotor *make_seat(double loose_damping, double held_damping) {
    static const double one = 1.0;
    const part parts[] = {{"looseness",
                           {{"between", 0.0, "upper, ground"},
                            {"stiffness", 4.0, NULL},
                            {"damping", 0.3, NULL},
                            {"loose_stiffness", 0.4, NULL},
                            {"loose_damping", loose_damping, NULL},
                            {"gap", 0.5, NULL},
                            {"held_stiffness", 6.0, NULL},
                            {"held_damping", held_damping, NULL}}},
                          unbalance,
                          gravity};
    return make_rotor(&one, 1, parts, COUNT_OF(parts));
}

static exact seat(double loose_damping, double held_damping) {
    return (exact){{{-INFINITY, 0.0, 4.0, 0.3, -0.2},
                    {0.0, 0.5, 0.4, loose_damping, -0.2},
                    {0.5, INFINITY, 6.0, held_damping, (6.0 - 0.4) * 0.5 - 0.2}},
                   0.3};
}

static void l2_three_slopes(void **unused) {
    (void)unused;
    static const struct {
        const char *what;
        double loose, held;
    } cases[] = {{"equal dampings", 0.3, 0.3}, {"dampings .3, .05, .5 N s/m", 0.05, 0.5}};
    for (size_t i = 0; i < COUNT_OF(cases); i++) {
        whirl_rotor *rotor = make_seat(cases[i].loose, cases[i].held);
        const exact of = seat(cases[i].loose, cases[i].held);
        compare_all("L2", cases[i].what, rotor, &of);
        whirl_rotor_free(rotor);
    }
}

static void l3_play(void **unused) {
    static const double one = 1.0;
    const part parts[] = {
        {"spring",
         {{"between", 0.0, "upper, ground"}, {"along", 0.0, "y"}, {"stiffness", 0.5, NULL}, {"damping", 0.1, NULL}}},
        {"spring",
         {{"between", 0.0, "upper, ground"},
          {"along", 0.0, "y"},
          {"stiffness", 7.0, NULL},
          {"damping", 0.25, NULL},
          {"gap", 0.4, NULL}}},
        unbalance,
        gravity};
    const exact of = {{{-INFINITY, -0.4, 7.5, 0.35, -7.0 * 0.4 - 0.2},
                       {-0.4, 0.4, 0.5, 0.1, -0.2},
                       {0.4, INFINITY, 7.5, 0.35, 7.0 * 0.4 - 0.2}},
                      0.3};
    whirl_rotor *rotor = make_rotor(&one, 1, parts, COUNT_OF(parts));
    (void)unused;
    compare_all("L3", "play of .4 m", rotor, &of);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- L4

/// Computes column j of d(end of the revolution)/d(start) of the closed form, by differences of fourth order.
static void differ(const exact *of, const double start[2], int j, double column[2]) {
    static const double offsets[4] = {-2.0, -1.0, 1.0, 2.0}, weights[4] = {1.0, -8.0, 8.0, -1.0};
    const double step = 4e-6;
    double volume = 0.0;
    column[0] = column[1] = 0.0;
    for (int k = 0; k < 4; k++) {
        double end[2] = {start[0], start[1]};
        end[j] += offsets[k] * step;
        revolve_exactly(of, end, &volume);
        for (int i = 0; i < 2; i++) column[i] += weights[k] * end[i] / (12.0 * step);
    }
}

static void l4_perturbations(void **unused) {
    static const char *const methods[] = {"dop853", "rk4"};
    const exact of = seat(0.05, 0.5);
    whirl_rotor *rotor = make_seat(0.05, 0.5);
    (void)unused;
    for (size_t m = 0; m < COUNT_OF(methods); m++) {
        whirl_integrator *integrator = make(rotor, methods[m]);
        double worst = 0.0, miss = 0.0;
        require_ok(whirl_integrator_follow(integrator, 2));
        for (size_t s = 1; s < STARTS; s++) {
            double vectors[4] = {1.0, 0.0, 0.0, 1.0}, x[2], column[2], volume = 0.0;
            whirl_perturbations perturbations = {.count = 2, .vectors = vectors};
            memcpy(x, starts[s], sizeof x);
            assert_int_equal(whirl_integrator_carry(integrator, x, &perturbations, NULL, NULL), WHIRL_BOUNDED);
            for (int j = 0; j < 2; j++) {
                differ(&of, starts[s], j, column);
                worst = fmax(worst, hypot(vectors[2 * j] - column[0], vectors[2 * j + 1] - column[1]));
            }
            memcpy(x, starts[s], sizeof x);
            revolve_exactly(&of, x, &volume);
            miss = fmax(miss, fabs(perturbations.volume - volume));
            miss = fmax(miss, fabs(log(vectors[0] * vectors[3] - vectors[1] * vectors[2]) - volume));
        }
        check_within("L4", words("%s, columns of the monodromy matrix, largest error", methods[m]), 0.0, worst, 1e-8);
        check_within("L4", words("%s, ln det and volume against -sum c_i t_i", methods[m]), 0.0, miss, 1e-9);
        whirl_integrator_free(integrator);
    }
    whirl_rotor_free(rotor);
}

/// Returns largest error of the columns of the monodromy matrix by rk4 in lanes, over some starts.
static double worst_in_lanes(const whirl_rotor *rotor, const exact *of, const whirl_integrate_options *options) {
    const whirl_system *system = whirl_rotor_system(rotor);
    whirl_ensemble *ensemble;
    double worst = 0.0;
    require_ok(whirl_ensemble_variational(system, options, &ensemble));
    for (size_t s = 1; s < STARTS; s++) {
        double vectors[4] = {1.0, 0.0, 0.0, 1.0}, column[2];
        whirl_perturbations perturbations = {.count = 2, .vectors = vectors};
        require_ok(whirl_ensemble_load(ensemble, 0, system, starts[s]));
        whirl_ensemble_carry(ensemble, 0, &perturbations);
        whirl_ensemble_revolve(ensemble, 1, NULL);
        for (int j = 0; j < 2; j++) {
            differ(of, starts[s], j, column);
            worst = fmax(worst, hypot(vectors[2 * j] - column[0], vectors[2 * j + 1] - column[1]));
        }
    }
    whirl_ensemble_free(ensemble);
    return worst;
}

/// Dampings that are equal on both sides of every switch make the force continuous: rk4 in lanes follows perturbations,
/// as it does without damping. A step over a switch takes its stiffness from a side for a step at most: columns are
/// wrong by a step times the change of the stiffness at each of up to four switches. Dampings that differ are refused.
static void l4_equal_dampings(void **unused) {
    static const double one = 1.0;
    const part seats[] = {{"looseness",
                           {{"between", 0.0, "upper, ground"},
                            {"stiffness", 4.0, NULL},
                            {"damping", 0.3, NULL},
                            {"loose_stiffness", 4.0, NULL},
                            {"loose_damping", 0.3, NULL}}},
                          unbalance,
                          gravity};
    const part play[] = {{"spring",
                          {{"between", 0.0, "upper, ground"},
                           {"along", 0.0, "y"},
                           {"stiffness", 7.0, NULL},
                           {"damping", 0.0, NULL},
                           {"gap", 0.4, NULL}}},
                         unbalance};
    const exact straight = {{{-INFINITY, INFINITY, 4.0, 0.3, -0.2}}, 0.3}, bent = seat(0.3, 0.3);
    whirl_integrate_options options = options_of("rk4");
    whirl_rotor *rotors[] = {make_rotor(&one, 1, seats, COUNT_OF(seats)), make_seat(0.3, 0.3),
                             make_rotor(&one, 1, play, COUNT_OF(play)), make_seat(0.05, 0.3), make_seat(0.3, 0.5)};
    (void)unused;
    options.located = false;
    for (size_t i = 0; i < COUNT_OF(rotors); i++)
        check_holds("L4", words("lanes %s perturbations of machine %zu", i < 3 ? "follow" : "refuse", i + 1),
                    whirl_ensemble_follows(whirl_rotor_system(rotors[i]), &options) == (i < 3));
    check_within("L4", "rk4 in lanes, equal slopes, columns of the monodromy matrix", 0.0,
                 worst_in_lanes(rotors[0], &straight, &options), 1e-8);
    check_within("L4", "rk4 in lanes, equal dampings, columns of the monodromy matrix", 0.0,
                 worst_in_lanes(rotors[1], &bent, &options),
                 4.0 * (6.0 - 0.4) * 2.0 * pi / options.steps_per_revolution);
    for (size_t i = 0; i < COUNT_OF(rotors); i++) whirl_rotor_free(rotors[i]);
}

// ---------------------------------------------------------------- L5: from rest on the seat

/// A mass at rest on its seat's switch, which moves only as a second, forced one pulls it: its distance begins like t^4
/// (no rate and no bend tell the side). With equal slopes it moves as on a spring; with unequal ones as from 1e-10
/// aside.
static void l5_from_rest_on_the_switch(void **unused) {
    static const double masses[] = {1.0, 1.0};
    static const char *const methods[] = {"dop853", "rodas5p", "rk4"};
    const part pull = {"spring", {{"between", 0.0, "upper, lower"}, {"along", 0.0, "y"}, {"stiffness", 1.0, NULL}}};
    const part force = {"unbalance", {{"at", 0.0, "lower"}, {"moment", 0.3, NULL}}};
    const part seats[] = {
        {"spring", {{"between", 0.0, "upper, ground"}, {"along", 0.0, "y"}, {"stiffness", 4.0, NULL}}},
        {"looseness", {{"between", 0.0, "upper, ground"}, {"stiffness", 4.0, NULL}, {"loose_stiffness", 4.0, NULL}}},
        {"looseness", {{"between", 0.0, "upper, ground"}, two_slopes[0], two_slopes[1]}}};
    double ends[3][3][4];
    (void)unused;
    for (size_t seat = 0; seat < 3; seat++) {
        const part parts[] = {seats[seat], pull, force};
        whirl_rotor *rotor = make_rotor(masses, 2, parts, 3);
        for (size_t m = 0; m < 3; m++) {
            whirl_integrator *integrator = make(rotor, methods[m]);
            double *x = ends[seat][m], aside[4] = {1e-10, 0.0, 0.0, 0.0}, apart = 0.0;
            memset(x, 0, sizeof ends[seat][m]);
            for (int i = 0; i < 3; i++) {
                assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
                assert_int_equal(whirl_integrator_revolve(integrator, aside, NULL, NULL), WHIRL_BOUNDED);
            }
            for (size_t d = 0; d < 4; d++) apart = fmax(apart, fabs(x[d] - aside[d]));
            check_within("L5", words("%s, seat %zu: from rest and from 1e-10 aside", methods[m], seat + 1), 0.0, apart,
                         2e-9);
            whirl_integrator_free(integrator);
        }
        whirl_rotor_free(rotor);
    }
    for (size_t m = 0; m < 3; m++) {
        double apart = 0.0;
        for (size_t d = 0; d < 4; d++) apart = fmax(apart, fabs(ends[1][m][d] - ends[0][m][d]));
        check_within("L5", words("%s, equal slopes and a spring", methods[m]), 0.0, apart, 1e-10);
    }
    check_holds("L5", "it moves", fabs(ends[2][0][0]) > 0.01);
}

/// A mass without forces stays where it is, on the switch.
static void l5_nothing_moves(void **unused) {
    static const double one = 1.0;
    const part seat = {"looseness", {{"between", 0.0, "upper, ground"}, two_slopes[0], two_slopes[1]}};
    whirl_rotor *rotor = make_rotor(&one, 1, &seat, 1);
    (void)unused;
    for (size_t m = 0; m < 2; m++) {
        whirl_integrator *integrator = make(rotor, m == 0 ? "dop853" : "rodas5p");
        double x[2] = {0.0};
        for (int i = 0; i < 10; i++)
            assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
        check_within("L5", "nothing moves it", 0.0, hypot(x[0], x[1]), 1e-300);
        whirl_integrator_free(integrator);
    }
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(l1_seat_on_ground),
        cmocka_unit_test(l1_seat_on_station),
        cmocka_unit_test(l2_three_slopes),
        cmocka_unit_test(l3_play),
        cmocka_unit_test(l4_perturbations),
        cmocka_unit_test(l4_equal_dampings),
        cmocka_unit_test(l5_from_rest_on_the_switch),
        cmocka_unit_test(l5_nothing_moves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
