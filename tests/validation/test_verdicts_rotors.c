// Verdicts on rotors whose regime is known: thresholds by theory, orbits by the cases of the verification manual.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_flow.h"
#include "support_known.h"
#include "support_rotor.h"

static const double pi = 3.14159265358979323846;

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

static void expect(known_motion *m, const char *expected) {
    snprintf(m->expected, sizeof m->expected, "%s", expected);
}

/// Sets case A5: a rigid rotor that rests at eccentricity ratio e, at a share of its threshold speed; no unbalance.
static void set_a5(known_motion *m, double e, double threshold, double share) {
    const double s = share * threshold, phi = atan2(pi * sqrt(1.0 - e * e), 4.0 * e);
    const double sigma = (1.0 - e * e) * (1.0 - e * e) / (e * sqrt(16.0 * e * e + pi * pi * (1.0 - e * e)));
    m->rotor = make_film_rotor(sigma / (s * s), 1.0 / (s * s), 0.0);
    m->start[0] = e * sin(phi) + 0.02;
    m->start[1] = -e * cos(phi);
    snprintf(m->label, sizeof m->label, "e = %g, %g of the threshold speed", e, share);
}

/// Makes case A5. Below the threshold the journal comes to rest, near it slowly. Above, the film whirls at about half
/// the speed: a closed orbit that sections by the shaft show as a torus.
static bool make_a5(size_t index, known_motion *m) {
    static const double rows[][2] = {
        {0.3, 2.605785828}, {0.45697072, 2.531705709}, {0.5, 2.541730858}, {0.1, 2.741278636}};
    static const double shares[] = {0.5, 0.8, 0.95, 0.99, 1.01, 1.05, 1.2};
    if (index >= COUNT_OF(rows) * COUNT_OF(shares) - 1) return false; // the last: too_coarse
    const double share = shares[index % 7];
    set_a5(m, rows[index / 7][0], rows[index / 7][1], share);
    expect(m, share < 1.0 ? "P-1" : "quasi-periodic");
    m->trap = share > 0.94;
    return true;
}

/// At 1.2 of the threshold for e = .1 the journal comes so near the wall that RK4 fails: its noise looks like chaos, at
/// twice the steps as well, and no verdict on it may have confidence.
static void too_coarse(void **state) {
    (void)state;
    for (int steps = 128; steps <= 512; steps *= 2) {
        known_motion m = {0};
        set_a5(&m, 0.1, 2.741278636, 1.2);
        const whirl_verdict verdict = judge_known(&m, steps);
        whirl_rotor_free(m.rotor);
        assert_int_equal(verdict.confidence, WHIRL_LOW);
    }
}

/// Makes case A7: the circle of an unloaded rotor, multipliers .575 and .101.
static bool make_a7(size_t index, known_motion *m) {
    static const double rho[] = {.304206515539, .504787456190};
    if (index >= COUNT_OF(rho)) return false;
    m->rotor = make_film_rotor(0.2, 0.0, rho[index]);
    m->start[0] = index == 0 ? 0.25 : 0.45;
    expect(m, "P-1");
    snprintf(m->label, sizeof m->label, "rho = %g", rho[index]);
    return true;
}

static bool make_a8(size_t index, known_motion *m) {
    static const struct {
        double rho;
        const char *regime;
    } rows[] = {{0.2, "P-2"}, {0.3, "P-8"}, {0.4, "chaotic"}, {0.5, "P-1"}};
    if (index >= COUNT_OF(rows)) return false;
    m->rotor = make_film_rotor(0.3 / 9.0, 1.0 / 9.0, rows[index].rho);
    m->start[0] = 0.1;
    m->start[1] = -0.2;
    expect(m, rows[index].regime);
    snprintf(m->label, sizeof m->label, "rho = %g", rows[index].rho);
    return true;
}

/// Makes case B2: an asymmetric shaft is unstable where (w^2 - w1^2)(w2^2 - w^2) > (c w)^2, else it comes to rest.
static bool make_b2(size_t index, known_motion *m) {
    static const double speeds[] = {0.5, 0.8, 0.88, 0.92, 0.96, 1.0, 1.05, 1.08, 1.12, 1.2, 1.6, 2.0},
                        damping[] = {0.05, 0.15};
    if (index >= COUNT_OF(speeds) * COUNT_OF(damping)) return false;
    const double w = speeds[index / 2], c = damping[index % 2], w1 = 0.8, w2 = 1.2; // squares of the criticals
    const bool unstable = (w * w - w1) * (w2 - w * w) > c * w * c * w;
    const shaft_case p = {.speed = w, .damping = c, .k1 = w1, .k2 = w2};
    m->rotor = make_shaft_rotor(&p);
    m->start[0] = 0.1;
    expect(m, unstable ? "diverged" : "P-1");
    snprintf(m->label, sizeof m->label, "w = %g, c = %g", w, c);
    return true;
}

/// Makes case B3: gravity at twice the speed on a stable asymmetric shaft is P-1.
static bool make_b3(size_t index, known_motion *m) {
    static const double speeds[] = {0.3, 0.45, 0.489898, 0.6, 0.7, 1.5};
    if (index >= COUNT_OF(speeds)) return false;
    const shaft_case p = {
        .speed = speeds[index], .damping = 0.1, .k1 = 0.8, .k2 = 1.2, .gravity = 0.05, .eccentricity = 0.02};
    m->rotor = make_shaft_rotor(&p);
    expect(m, "P-1");
    snprintf(m->label, sizeof m->label, "w = %g", speeds[index]);
    return true;
}

/// Makes case C2: the annular rub, which is stable on the upper branch; the motion starts near it.
static bool make_c2(size_t index, known_motion *m) {
    static const double rows[][2] = {{1.0, 1.078622962500}, {1.2, 1.381926301669}};
    if (index >= COUNT_OF(rows)) return false;
    const double w = rows[index][0], radius = rows[index][1], kappa = 2.0, mu = 0.1, zeta = 0.05;
    const rub_case p = {.speed = w, .zeta = zeta, .kappa = kappa, .eccentricity = 0.2, .friction = mu};
    const double push = kappa * (1.0 - 1.0 / radius);
    const double psi = atan2(2.0 * zeta * w + mu * push, 1.0 + push - w * w);
    m->rotor = make_rub_rotor(&p);
    m->start[0] = radius * cos(psi);
    m->start[1] = -radius * sin(psi);
    m->start[2] = radius * sin(psi) + 0.01;
    m->start[3] = radius * cos(psi);
    expect(m, "P-1");
    snprintf(m->label, sizeof m->label, "w = %g", w);
    return true;
}

/// Makes case C3: from outside the unstable backward whirl, friction that never reverses makes the motion grow; from
/// inside it comes to rest.
static bool make_c3(size_t index, known_motion *m) {
    static const struct {
        double zeta, kappa, whirl, radius;
    } rows[] = {{0.05, 25.0, 1.618033988750, 1.069200083003}, {0.02, 4.0, 1.219803902719, 1.138926726602}};
    if (index >= 8) return false;
    const double ratio[] = {0.9, 0.98, 1.02, 1.2};
    const double radius = ratio[index % 4] * rows[index / 4].radius;
    const rub_case p = {.speed = 3.0, .zeta = rows[index / 4].zeta, .kappa = rows[index / 4].kappa, .friction = 0.1};
    m->rotor = make_rub_rotor(&p);
    m->start[0] = radius;
    m->start[3] = -radius * rows[index / 4].whirl / p.speed;
    expect(m, index % 4 < 2 ? "P-1" : "diverged");
    snprintf(m->label, sizeof m->label, "zeta = %g, from %g r_u", p.zeta, ratio[index % 4]);
    return true;
}

static bool make_c4(size_t index, known_motion *m) {
    static const struct {
        double speed;
        const char *regime;
    } rows[] = {{1.5, "P-1"}, {3.8, "P-4"}, {3.3, "chaotic"}};
    if (index >= COUNT_OF(rows)) return false;
    const rub_case p = {
        .speed = rows[index].speed, .zeta = 0.1, .kappa = 10.0, .eccentricity = 0.9, .friction = 0.05, .weight = 0.5};
    m->rotor = make_rub_rotor(&p);
    m->start[0] = 0.1;
    m->start[1] = -0.2;
    expect(m, rows[index].regime);
    snprintf(m->label, sizeof m->label, "w = %g", rows[index].speed);
    return true;
}

/// Makes a rotor that does not touch, which is linear: P-1.
static bool make_free_rub(size_t index, known_motion *m) {
    static const double speeds[] = {0.3, 0.6, 0.85, 1.3, 2.0, 4.0};
    if (index >= COUNT_OF(speeds)) return false;
    const rub_case p = {
        .speed = speeds[index], .zeta = 0.1, .kappa = 10.0, .eccentricity = 0.1, .friction = 0.05, .weight = 0.2};
    m->rotor = make_rub_rotor(&p);
    expect(m, "P-1");
    snprintf(m->label, sizeof m->label, "w = %g", speeds[index]);
    return true;
}

/// A rigid rotor in its film, sigma = .3, s = 3, rho = .31, is chaotic for some 5000 revolutions and then P-96: the
/// orbit closes after 96 revolutions and no sooner, and its multipliers lie inside the unit circle.
static void long_period(void **state) {
    enum { PERIOD = 96, STEPS = 256 };
    known_motion m = {.transient = 8000, .start = {0.1, -0.2}};
    char name[WHIRL_NAME_SIZE];
    double at[4], fixed[4], matrix[16], nearest = INFINITY;
    (void)state;
    m.rotor = make_film_rotor(0.3 / 9.0, 1.0 / 9.0, 0.31);
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(m.rotor), "rk4", STEPS);
    memcpy(at, m.start, sizeof at);
    revolve(integrator, at, m.transient);
    memcpy(fixed, at, sizeof fixed);
    find_fixed_point(integrator, 4, fixed, PERIOD);
    memcpy(at, fixed, sizeof at);
    for (int k = 1; k < PERIOD; k++) {
        revolve(integrator, at, 1);
        if (PERIOD % k == 0) nearest = fmin(nearest, hypot(at[0] - fixed[0], at[1] - fixed[1]));
    }
    flow_jacobian(integrator, 4, fixed, PERIOD, 1e-7, matrix);
    assert_true(nearest > 1e-6);
    assert_true(largest_modulus(4, matrix) < 0.9);
    const whirl_verdict verdict = judge_known(&m, STEPS);
    whirl_verdict_name(&verdict, name, sizeof name);
    assert_string_equal(name, "P-96");
    whirl_integrator_free(integrator);
    whirl_rotor_free(m.rotor);
}

static const known_family families[] = {
    {"rigid rotor in its film, case A5", "Routh", 512, make_a5},
    {"unloaded rotor, case A7", "cases.md", 256, make_a7},
    {"loaded rotor, case A8", "cases.md", 512, make_a8},
    {"asymmetric shaft, case B2", "Floquet", 128, make_b2},
    {"asymmetric shaft under gravity, case B3", "theory", 128, make_b3},
    {"annular rub, case C2", "theory", 256, make_c2},
    {"dry friction, case C3", "theory", 256, make_c3},
    {"rubbing rotor, case C4", "cases.md", 1024, make_c4},
    {"rotor that does not touch", "theory", 128, make_free_rub},
};

int main(void) {
    const struct CMUnitTest more[] = {cmocka_unit_test(too_coarse), cmocka_unit_test(long_period)};
    return run_families("rotors", families, COUNT_OF(families), 1, more, COUNT_OF(more), 60);
}
