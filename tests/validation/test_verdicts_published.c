// Verdicts on flows whose regime was published, or is proved by shooting: an orbit that closes after k revolutions and
// whose multipliers lie inside the unit circle is an attracting P-k.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "lorenz.h"
#include "support_flow.h"
#include "support_known.h"

static const double two_pi = 6.28318530717958647693;

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

// ---------------------------------------------------------------- shooting

/// Returns the smallest k up to 16 for which the motion closes on an attracting orbit; 0: none.
static int shoot_period(const known_motion *m, int transient) {
    enum { MAX_PERIOD = 16 };
    whirl_system system = m->system;
    double x[KNOWN_DIMENSION], at[KNOWN_DIMENSION], matrix[KNOWN_DIMENSION * KNOWN_DIMENSION];
    int period = 0;
    system.model = m->p;
    whirl_integrator *integrator = make_integrator(&system, "rk4", 1024);
    memcpy(x, m->start, sizeof x);
    revolve(integrator, x, transient);
    memcpy(at, x, sizeof at);
    for (int k = 1; k <= MAX_PERIOD && period == 0; k++) {
        double distance = 0.0;
        revolve(integrator, at, 1);
        for (size_t i = 0; i < system.dimension; i++) distance = fmax(distance, fabs(at[i] - x[i]));
        if (distance < 1e-7) period = k;
    }
    if (period > 0) {
        double fixed[KNOWN_DIMENSION];
        memcpy(fixed, x, sizeof fixed);
        find_fixed_point(integrator, system.dimension, fixed, period);
        for (size_t i = 0; i < system.dimension; i++) assert_true(fabs(fixed[i] - x[i]) < 1e-6);
        flow_jacobian(integrator, system.dimension, fixed, period, 1e-3, matrix);
        assert_true(largest_modulus(system.dimension, matrix) < 0.995);
    }
    whirl_integrator_free(integrator);
    return period;
}

static void expect(known_motion *m, const char *expected) {
    snprintf(m->expected, sizeof m->expected, "%s", expected);
}

/// Expects what shooting finds, which must be a period.
static void expect_shot(known_motion *m) {
    const int period = shoot_period(m, 3000);
    if (period == 0) fail_msg("%s: no attracting orbit was found", m->label);
    snprintf(m->expected, sizeof m->expected, "P-%d", period);
}

// ---------------------------------------------------------------- x'' + d x' + a x + b x^3 = f cos(w t)

static void duffing_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const double *m = model; // d, a, b, f, w
    (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = m[3] * cos(m[4] * t) - m[0] * x[1] - m[1] * x[0] - m[2] * x[0] * x[0] * x[0];
}

static void set_duffing(known_motion *m, double d, double a, double b, double f, double w) {
    const double p[5] = {d, a, b, f, w};
    memcpy(m->p, p, sizeof p);
    m->system = (whirl_system){.dimension = 2, .period = two_pi / w, .rhs = duffing_rhs};
    m->start[0] = 1.0;
    snprintf(m->label, sizeof m->label, "d %g, a %g, b %g, f %g, w %g", d, a, b, f, w);
}

/// Makes case D2.
static bool make_d2(size_t index, known_motion *m) {
    static const struct {
        double force;
        const char *regime;
    } rows[] = {{0.20, "P-1"}, {0.28, "P-2"}, {0.29, "P-4"}, {0.37, "P-5"}, {0.50, "chaotic"}, {0.65, "P-2"}};
    if (index >= COUNT_OF(rows)) return false;
    set_duffing(m, 0.3, -1.0, 1.0, rows[index].force, 1.2);
    expect(m, rows[index].regime);
    return true;
}

static bool make_periodic_duffing(size_t index, known_motion *m) {
    static const double rows[][5] = {
        {0.3, -1.0, 1.0, 0.10, 1.2}, {0.3, -1.0, 1.0, 0.15, 1.2},  {0.3, -1.0, 1.0, 0.24, 1.2},
        {0.3, -1.0, 1.0, 0.27, 1.2}, {0.3, -1.0, 1.0, 0.285, 1.2}, {0.3, -1.0, 1.0, 0.73, 1.2},
        {0.3, -1.0, 1.0, 0.80, 1.2}, {0.2, 1.0, 1.0, 0.5, 0.7},    {0.2, 1.0, 1.0, 0.5, 1.5},
        {0.2, 1.0, 1.0, 2.0, 1.0},   {0.1, 1.0, 0.3, 0.3, 0.5},    {0.1, 1.0, 0.3, 0.3, 1.4},
        {0.1, 1.0, 0.3, 0.3, 3.0},   {0.05, 0.0, 1.0, 0.2, 1.0},   {0.2, 0.0, 1.0, 3.0, 1.0},
        {0.2, 0.0, 1.0, 5.5, 1.0},   {0.5, 1.0, 1.0, 10.0, 1.0},   {0.5, -1.0, 1.0, 0.3, 0.6},
        {0.5, -1.0, 1.0, 0.2, 2.0},  {0.25, -1.0, 1.0, 0.22, 1.0}, {0.15, -1.0, 1.0, 0.1, 1.0},
        {0.6, 0.2, 2.0, 1.0, 1.3},
    };
    if (index >= COUNT_OF(rows)) return false;
    set_duffing(m, rows[index][0], rows[index][1], rows[index][2], rows[index][3], rows[index][4]);
    expect_shot(m);
    return true;
}

/// Makes case D1, with exponents by Sprott 2003, appendix A.4.
static bool make_chaotic_duffing(size_t index, known_motion *m) {
    static const double rows[][5] = {
        {0.05, 0.0, 1.0, 7.5, 1.0}, {0.3, -1.0, 1.0, 0.5, 1.2}, {0.25, -1.0, 1.0, 0.4, 1.0}};
    if (index >= COUNT_OF(rows)) return false;
    set_duffing(m, rows[index][0], rows[index][1], rows[index][2], rows[index][3], rows[index][4]);
    expect(m, "chaotic");
    return true;
}

// ---------------------------------------------------------------- pendulum x'' + d x' + sin x = f cos(w t)

static void pendulum_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const double *m = model; // d, f, w
    (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = m[1] * cos(m[2] * t) - m[0] * x[1] - sin(x[0]);
}

/// Makes the pendulum of Baker and Gollub, "Chaotic dynamics" (1990): f = .9 swings, 1.07 swings with twice the period,
/// 1.15 is chaotic (D1); 1.35 turns once a period, 1.45 with twice, 1.47 with four times the period; 1.5 is chaotic.
static bool make_pendulum(size_t index, known_motion *m) {
    static const struct {
        double force;
        const char *regime;
    } rows[] = {{0.5, "P-1"},  {0.9, "P-1"},  {1.07, "P-2"}, {1.15, "chaotic"},
                {1.35, "P-1"}, {1.45, "P-2"}, {1.47, "P-4"}, {1.5, "chaotic"}};
    static const double turns[] = {6.283185307179586476925, 0.0};
    if (index >= COUNT_OF(rows)) return false;
    m->p[0] = 0.5;
    m->p[1] = rows[index].force;
    m->p[2] = 2.0 / 3.0;
    m->system = (whirl_system){.dimension = 2, .period = two_pi / m->p[2], .rhs = pendulum_rhs, .angles = turns};
    m->start[0] = 0.2;
    snprintf(m->label, sizeof m->label, "f = %g", m->p[1]);
    expect(m, rows[index].regime);
    return true;
}

// ---------------------------------------------------------------- Sprott's flows (Phys. Rev. E 50 (1994) R647)

typedef void sprott_rhs(double x, double y, double z, double *d);

#define FLOW(name, dx, dy, dz)                                                                                         \
    static void sprott_##name(double x, double y, double z, double *d) {                                               \
        (void)x, (void)y, (void)z;                                                                                     \
        d[0] = dx;                                                                                                     \
        d[1] = dy;                                                                                                     \
        d[2] = dz;                                                                                                     \
    }
FLOW(b, y *z, x - y, 1.0 - x * y)
FLOW(c, y *z, x - y, 1.0 - x * x)
FLOW(d, -y, x + z, x *z + 3.0 * y * y)
FLOW(e, y *z, x *x - y, 1.0 - 4.0 * x)
FLOW(f, y + z, -x + 0.5 * y, x *x - z)
FLOW(g, 0.4 * x + z, x *z - y, y - x)
FLOW(h, -y + z * z, x + 0.5 * y, x - z)
FLOW(i, -0.2 * y, x + z, x + y * y - z)
FLOW(j, 2.0 * z, -2.0 * y + z, -x + y + y * y)
FLOW(k, x *y - z, x - y, x + 0.3 * z)
FLOW(l, y + 3.9 * z, 0.9 * x * x - y, 1.0 - x)
FLOW(m, -z, -x *x - y, 1.7 + 1.7 * x + y)
FLOW(n, -2.0 * y, x + z * z, 1.0 + y - 2.0 * z)
FLOW(o, y, x - z, x + x * z + 2.7 * y)
FLOW(p, 2.7 * y + z, -x + y * y, x + y)
FLOW(q, -z, x - y, 3.1 * x + y * y + 0.5 * z)
FLOW(r, 0.9 - y, 0.4 + z, x *y - z)
FLOW(s, -x - 4.0 * y, x + z * z, 1.0 + x)

static const struct {
    const char *name;
    sprott_rhs *flow;
    double exponent; ///< as printed there
} sprott_flows[] = {{"B", sprott_b, 0.210}, {"C", sprott_c, 0.163}, {"D", sprott_d, 0.103}, {"E", sprott_e, 0.078},
                    {"F", sprott_f, 0.117}, {"G", sprott_g, 0.034}, {"H", sprott_h, 0.117}, {"I", sprott_i, 0.012},
                    {"J", sprott_j, 0.076}, {"K", sprott_k, 0.038}, {"L", sprott_l, 0.061}, {"M", sprott_m, 0.044},
                    {"N", sprott_n, 0.076}, {"O", sprott_o, 0.049}, {"P", sprott_p, 0.087}, {"Q", sprott_q, 0.109},
                    {"R", sprott_r, 0.062}, {"S", sprott_s, 0.188}};

static void sprott_flow_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const double *m = model; // which
    (void)t, (void)forcing;
    sprott_flows[(size_t)m[0]].flow(x[0], x[1], x[2], dxdt);
}

static bool make_sprott(size_t index, known_motion *m) {
    if (index >= COUNT_OF(sprott_flows)) return false;
    m->p[0] = (double)index;
    m->system = (whirl_system){.dimension = 3, .period = 4.0, .rhs = sprott_flow_rhs};
    for (int i = 0; i < 3; i++) m->start[i] = 0.05;
    snprintf(m->label, sizeof m->label, "%s, exponent %g by time", sprott_flows[index].name,
             sprott_flows[index].exponent);
    expect(m, "chaotic");
    m->trap = sprott_flows[index].exponent < 0.03;
    return true;
}

// ---------------------------------------------------------------- Lorenz and Rossler

/// Makes Lorenz' system (Sparrow, "The Lorenz equations", 1982): equilibria attract all up to r = 24.06 (with chaos on
/// the way from 13.926), chaos from there to about 30 and again, closed orbits in 99.52 < r < 100.8, 145 < r < 166 and
/// for r > 214.4.
static bool make_lorenz(size_t index, known_motion *m) {
    static const struct {
        double r;
        const char *regime;
        bool trap;
    } rows[] = {{0.5, "P-1", false},
                {5.0, "P-1", false},
                {12.0, "P-1", false},
                {18.0, "P-1", true},
                {22.0, "P-1", true},
                {23.5, "P-1", true},
                {28.0, "chaotic", false},
                {35.0, "chaotic", false},
                {45.0, "chaotic", false},
                {60.0, "chaotic", false},
                {100.5, "quasi-periodic (1 curve)", true},
                {155.0, "quasi-periodic (1 curve)", true},
                {160.0, "quasi-periodic (1 curve)", true},
                {220.0, "quasi-periodic (1 curve)", true},
                {350.0, "quasi-periodic (1 curve)", true}};
    if (index >= COUNT_OF(rows)) return false;
    m->p[0] = rows[index].r;
    m->system = (whirl_system){.dimension = 3, .period = 1.0, .rhs = lorenz_rhs};
    m->start[0] = m->start[1] = 1.0;
    m->start[2] = 20.0;
    m->trap = rows[index].trap;
    expect(m, rows[index].regime);
    snprintf(m->label, sizeof m->label, "r = %g", m->p[0]);
    return true;
}

static void rossler_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const double *m = model; // a, b, c
    (void)t, (void)forcing;
    dxdt[0] = -x[1] - x[2];
    dxdt[1] = x[0] + m[0] * x[1];
    dxdt[2] = m[1] + x[2] * (x[0] - m[2]);
}

/// Makes Rossler's system, a = b = .2: closed orbits at c = 2.5 and 3.5 (Rossler 1976; Peitgen, Jurgens, Saupe 1992),
/// chaos at 5.7.
static bool make_rossler(size_t index, known_motion *m) {
    static const struct {
        double c;
        const char *regime;
    } rows[] = {
        {2.5, "quasi-periodic (1 curve)"}, {3.5, "quasi-periodic (1 curve)"}, {5.7, "chaotic"}, {9.0, "chaotic"}};
    if (index >= COUNT_OF(rows)) return false;
    m->p[0] = m->p[1] = 0.2;
    m->p[2] = rows[index].c;
    m->system = (whirl_system){.dimension = 3, .period = 5.0, .rhs = rossler_rhs};
    m->start[0] = m->start[1] = 1.0;
    m->trap = index != 2;
    expect(m, rows[index].regime);
    snprintf(m->label, sizeof m->label, "c = %g", m->p[2]);
    return true;
}

// ---------------------------------------------------------------- van der Pol, forced: x'' - mu (1 - x^2) x' + x = f
// cos w t

static void forced_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const double *m = model; // mu, f, w
    (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = m[0] * (1.0 - x[0] * x[0]) * x[1] - x[0] + m[1] * cos(m[2] * t);
}

static bool make_entrained(size_t index, known_motion *m) {
    static const double rows[][3] = {{0.2, 0.5, 1.0}, {0.2, 0.5, 0.95},        {0.5, 1.0, 0.9}, {1.0, 1.5, 1.2},
                                     {1.0, 1.0, 2.8}, {5.0, 5.0, 2.466 * 1.1}, {3.0, 5.0, 2.2}, {0.5, 4.0, 3.0}};
    if (index >= COUNT_OF(rows)) return false;
    memcpy(m->p, rows[index], sizeof rows[index]);
    m->system = (whirl_system){.dimension = 2, .period = two_pi / m->p[2], .rhs = forced_rhs};
    m->start[0] = 1.0;
    snprintf(m->label, sizeof m->label, "mu %g, f %g, w %g", m->p[0], m->p[1], m->p[2]);
    expect_shot(m);
    return true;
}

static const known_family families[] = {
    {"two-well Duffing, case D2", "cases.md", 128, make_d2},
    {"Duffing, periodic", "shooting", 128, make_periodic_duffing},
    {"Duffing, chaotic", "Ueda 1979, case D1, Sprott 2003", 128, make_chaotic_duffing},
    {"pendulum", "Baker, Gollub 1990, case D1", 128, make_pendulum},
    {"Sprott's flows", "Sprott 1994", 128, make_sprott},
    {"Lorenz", "Sparrow 1982", 256, make_lorenz},
    {"Rossler", "Rossler 1976", 128, make_rossler},
    {"van der Pol, entrained", "shooting", 128, make_entrained},
};

int main(void) {
    return run_families("published flows", families, COUNT_OF(families), 3, NULL, 0, 70);
}
