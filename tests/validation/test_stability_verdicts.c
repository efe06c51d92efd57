// Verdicts of stability: of 200 random machines against eigenvalues in extended precision of matrices that are set up
// here, and against the growth of motions; of fine shafts on soft springs against closed forms.
#include <complex.h>
#include <float.h>
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
#include "whirl/engine/case.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/rotor.h"

typedef long double real;
typedef long double complex number;

enum { STATIONS = 3, MAX_SIZE = 40, TEXT = 4096 };

// ---------------------------------------------------------------- eigenvalues

/// Scales rows and columns by powers of two until their sums are alike.
static void balance(size_t n, real a[MAX_SIZE][MAX_SIZE]) {
    bool changed = true;
    for (int sweep = 0; sweep < 100 && changed; sweep++) {
        changed = false;
        for (size_t i = 0; i < n; i++) {
            real row = 0, column = 0;
            for (size_t k = 0; k < n; k++) {
                row += i == k ? 0 : fabsl(a[i][k]);
                column += i == k ? 0 : fabsl(a[k][i]);
            }
            if (row == 0 || column == 0) continue;
            const real factor = exp2l(roundl(0.5L * log2l(row / column)));
            if (factor == 1) continue;
            for (size_t k = 0; k < n; k++) a[i][k] /= factor, a[k][i] *= factor;
            changed = true;
        }
    }
}

static void make_hessenberg(size_t n, number a[MAX_SIZE][MAX_SIZE]) {
    for (size_t m = 1; m + 1 < n; m++) {
        size_t pivot = m;
        for (size_t i = m; i < n; i++)
            if (cabsl(a[i][m - 1]) > cabsl(a[pivot][m - 1])) pivot = i;
        if (a[pivot][m - 1] == 0) continue;
        for (size_t k = 0; k < n; k++) {
            const number moved = a[m][k];
            a[m][k] = a[pivot][k];
            a[pivot][k] = moved;
        }
        for (size_t k = 0; k < n; k++) {
            const number moved = a[k][m];
            a[k][m] = a[k][pivot];
            a[k][pivot] = moved;
        }
        for (size_t i = m + 1; i < n; i++) {
            const number factor = a[i][m - 1] / a[m][m - 1];
            for (size_t k = 0; k < n; k++) a[i][k] -= factor * a[m][k];
            for (size_t k = 0; k < n; k++) a[k][m] += factor * a[k][i];
        }
    }
}

/// Computes the eigenvalues of a [n][n] by QR steps with Wilkinson's shifts (Golub, Van Loan 2013, 7.5).
static void find_eigenvalues(size_t n, real matrix[MAX_SIZE][MAX_SIZE], number *values) {
    static number a[MAX_SIZE][MAX_SIZE];
    balance(n, matrix);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) a[i][k] = matrix[i][k];
    make_hessenberg(n, a);
    for (size_t end = n, step = 0; end > 0; step++) {
        size_t low = end - 1;
        for (; low > 0; low--)
            if (cabsl(a[low][low - 1]) <= LDBL_EPSILON * (cabsl(a[low][low]) + cabsl(a[low - 1][low - 1]))) break;
        if (low == end - 1) {
            values[--end] = a[low][low];
            step = 0;
            continue;
        }
        assert_true(step < 300);
        const number p = a[end - 2][end - 2], q = a[end - 2][end - 1], r = a[end - 1][end - 2], s = a[end - 1][end - 1];
        const number root = csqrtl(0.25L * (p - s) * (p - s) + q * r), middle = 0.5L * (p + s);
        number shift = cabsl(middle + root - s) < cabsl(middle - root - s) ? middle + root : middle - root;
        if (step % 11 == 10) shift = cabsl(r) + cabsl(s);
        number c[MAX_SIZE], sine[MAX_SIZE];
        for (size_t i = low; i < end; i++) a[i][i] -= shift;
        for (size_t i = low; i + 1 < end; i++) {
            const real size = hypotl(cabsl(a[i][i]), cabsl(a[i + 1][i]));
            c[i] = size > 0 ? a[i][i] / size : 1;
            sine[i] = size > 0 ? a[i + 1][i] / size : 0;
            for (size_t k = i; k < end; k++) {
                const number one = a[i][k], other = a[i + 1][k];
                a[i][k] = conjl(c[i]) * one + conjl(sine[i]) * other;
                a[i + 1][k] = c[i] * other - sine[i] * one;
            }
        }
        for (size_t i = low; i + 1 < end; i++)
            for (size_t k = low; k <= i + 1; k++) {
                const number one = a[k][i], other = a[k][i + 1];
                a[k][i] = one * c[i] + other * sine[i];
                a[k][i + 1] = other * conjl(c[i]) - one * conjl(sine[i]);
            }
        for (size_t i = low; i < end; i++) a[i][i] += shift;
    }
}

// ---------------------------------------------------------------- random machines

static uint64_t seed;

/// Returns numbers distributed evenly from 0 to 1.
static double even(void) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) / 9007199254740992.0;
}

/// Returns 10 to a random power between two bounds.
static double power(double low, double high) {
    return pow(10.0, low + (high - low) * even());
}

/// A machine as text, and its equations x' = a x in SI: displacements and tilts of the x and the y plane, their rates,
/// states of magnets.
typedef struct machine {
    char text[TEXT];
    size_t stations, per, states; ///< per: coordinates of a station in a plane, 1 or 2
    real stiffness[2 * 2 * STATIONS][2 * 2 * STATIONS], damping[2 * 2 * STATIONS][2 * 2 * STATIONS];
    real inertia[2 * 2 * STATIONS];
    struct loop {
        size_t coordinate;
        real by_current, proportional, integral, derivative, filter;
    } loops[2 * STATIONS];
    size_t loop_count;
    bool free;    ///< a pair of masses that nothing holds goes along
    real pair[3]; ///< its reduced mass, stiffness and damping
} machine;

static void add(machine *m, const char *format, ...) {
    const size_t used = strlen(m->text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(m->text + used, TEXT - used, format, arguments);
    va_end(arguments);
    assert_true(strlen(m->text) + 1 < TEXT);
}

static size_t coordinate_of(const machine *m, size_t plane, size_t station, size_t tilt) {
    return (plane * m->stations + station) * m->per + tilt;
}

/// Adds a spring from a station to another, or to the ground.
static void put_between(const machine *m, real matrix[2 * 2 * STATIONS][2 * 2 * STATIONS], size_t a, size_t b,
                        real added) {
    for (size_t plane = 0; plane < 2; plane++) {
        const size_t i = coordinate_of(m, plane, a, 0), k = coordinate_of(m, plane, b, 0);
        matrix[i][i] += added;
        if (a == b) continue;
        matrix[k][k] += added;
        matrix[i][k] -= added;
        matrix[k][i] -= added;
    }
}

static void add_stations(machine *m) {
    add(m, "whirl: 1\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 um\n  stations:\n");
    for (size_t s = 0; s < m->stations; s++) {
        const double mass = power(-4, 3), gyration = power(-3, -1);
        add(m, "    s%zu: {mass: %.17g", s, mass);
        if (m->per == 2) add(m, ", diametral: %.17g", mass * gyration);
        add(m, "}\n");
        for (size_t plane = 0; plane < 2; plane++) {
            m->inertia[coordinate_of(m, plane, s, 0)] = mass;
            if (m->per == 2) m->inertia[coordinate_of(m, plane, s, 1)] = mass * gyration;
        }
    }
    if (m->free) add(m, "    f0: {mass: 1}\n    f1: {mass: 3}\n");
    add(m, "  elements:\n");
}

static void add_beams(machine *m) {
    for (size_t s = 0; s + 1 < m->stations && m->per == 2; s++) {
        const double length = power(-1, 0.5), bending = power(0, 8);
        const real k = (real)bending / ((real)length * length * length), l = length;
        const real beam[4][4] = {{12 * k, 6 * k * l, -12 * k, 6 * k * l},
                                 {6 * k * l, 4 * k * l * l, -6 * k * l, 2 * k * l * l},
                                 {-12 * k, -6 * k * l, 12 * k, -6 * k * l},
                                 {6 * k * l, 2 * k * l * l, -6 * k * l, 4 * k * l * l}};
        add(m, "    - beam: {between: [s%zu, s%zu], length: %.17g, bending: %.17g}\n", s, s + 1, length, bending);
        for (size_t plane = 0; plane < 2; plane++)
            for (size_t i = 0; i < 4; i++)
                for (size_t j = 0; j < 4; j++)
                    m->stiffness[coordinate_of(m, plane, s + i / 2, i % 2)]
                                [coordinate_of(m, plane, s + j / 2, j % 2)] += beam[i][j];
    }
}

static void add_springs(machine *m) {
    for (size_t s = 0; s + 1 < m->stations && m->per == 1; s++) {
        const double k = power(-4, 8), c = even() < 0.5 ? 0.0 : power(-4, 6);
        add(m, "    - spring: {between: [s%zu, s%zu], stiffness: %.17g, damping: %.17g}\n", s, s + 1, k, c);
        put_between(m, m->stiffness, s, s + 1, k);
        put_between(m, m->damping, s, s + 1, c);
    }
    if (!m->free) return;
    const double k = power(-4, 8), c = power(-4, 6);
    add(m, "    - spring: {between: [f0, f1], stiffness: %.17g, damping: %.17g}\n", k, c);
    m->pair[0] = 0.75L;
    m->pair[1] = k;
    m->pair[2] = c;
}

static void add_bearing(machine *m, size_t s) {
    const double k = power(-4, 8), q = even() < 0.6 ? k * power(-3, 0.3) : 0.0, c = power(-4, 6);
    const size_t x = coordinate_of(m, 0, s, 0), y = coordinate_of(m, 1, s, 0);
    add(m, "    - bearing: {at: s%zu, kxx: %.17g, kxy: %.17g, kyx: %.17g, cxx: %.17g}\n", s, k, q, -q, c);
    put_between(m, m->stiffness, s, s, k);
    put_between(m, m->damping, s, s, c);
    m->stiffness[x][y] += q;
    m->stiffness[y][x] -= q;
}

static void add_magnet(machine *m, size_t s) {
    const double pull = power(-2, 6), by_current = power(-1, 3), proportional = pull / by_current * power(-0.3, 1);
    const double rate = power(0, 3), derivative = proportional / rate, filter = power(-2, -0.5) / rate;
    const double integral = proportional * rate * power(-6, 0) * (even() < 0.3 ? -1.0 : 1.0);
    add(m,
        "    - magnetic: {at: s%zu, law: linear, current_stiffness: %.17g, displacement_stiffness: %.17g, "
        "proportional: %.17g, derivative: %.17g, derivative_filter: %.17g, integral: %.17g}\n",
        s, by_current, pull, proportional, derivative, filter, integral);
    for (size_t plane = 0; plane < 2; plane++) {
        const size_t own = coordinate_of(m, plane, s, 0);
        m->stiffness[own][own] -= pull;
        m->loops[m->loop_count++] = (struct loop){own, by_current, proportional, integral, derivative, filter};
    }
}

static void make_machine(machine *m) {
    *m = (machine){.stations = 1 + (size_t)(STATIONS * even())};
    m->per = m->stations > 1 && even() < 0.5 ? 2 : 1;
    m->free = even() < 0.2;
    add_stations(m);
    add_beams(m);
    add_springs(m);
    for (size_t s = 0; s < m->stations; s++) {
        if (even() < 0.3)
            add_magnet(m, s);
        else
            add_bearing(m, s);
    }
    add(m, "study: {modes: {}}\n");
}

/// Writes the eigenvalues and returns their number; those of free coordinates are left out.
static size_t solve_machine(const machine *m, number *values) {
    static real a[MAX_SIZE][MAX_SIZE];
    const size_t n = 2 * m->stations * m->per, all = 2 * n + 2 * m->loop_count;
    memset(a, 0, sizeof a);
    for (size_t i = 0; i < n; i++) {
        a[i][n + i] = 1;
        for (size_t k = 0; k < n; k++) {
            a[n + i][k] = -m->stiffness[i][k] / m->inertia[i];
            a[n + i][n + k] = -m->damping[i][k] / m->inertia[i];
        }
    }
    for (size_t l = 0; l < m->loop_count; l++) {
        const struct loop *own = &m->loops[l];
        const size_t u = own->coordinate, sum = 2 * n + 2 * l, lag = sum + 1;
        const real f = own->by_current / m->inertia[u];
        a[sum][u] = 1;
        a[lag][u] = 1 / own->filter;
        a[lag][lag] = -1 / own->filter;
        a[n + u][u] -= f * (own->proportional + own->derivative / own->filter);
        a[n + u][lag] += f * own->derivative / own->filter;
        a[n + u][sum] -= f * own->integral;
    }
    find_eigenvalues(all, a, values);
    if (!m->free) return all;
    const real b = m->pair[2] / m->pair[0];
    const number root = csqrtl(0.25L * b * b - m->pair[1] / m->pair[0]);
    values[all] = -0.5L * b - root;
    values[all + 1] = m->pair[1] / m->pair[0] / values[all];
    return all + 2;
}

/// Returns the logarithm of the growth of a small motion about rest from four to eight times 1/|growth|; NaN if that
/// takes too long.
static double grow(const whirl_system *system, double growth, double fastest) {
    const double times = 8.0, most = 300.0;
    const double revolutions = ceil(times / (fabs(growth) * system->period));
    if (revolutions > most || fastest * revolutions * system->period > 2e4) return (double)NAN;
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    double x[MAX_SIZE], square[3] = {0, 0, 0};
    snprintf(options.method, sizeof options.method, "rodas5p");
    options.rtol = 1e-8;
    options.atol = 1e-30;
    require_ok(whirl_integrator_new(system, &options, &integrator));
    for (size_t i = 0; i < system->dimension; i++) x[i] = 1e-12 * (1.0 + 0.37 * (double)i);
    for (int part = 0; part < 2; part++) {
        for (int n = 0; n < (int)ceil(0.5 * revolutions); n++)
            if (whirl_integrator_revolve(integrator, x, NULL, NULL) != WHIRL_BOUNDED) return (double)NAN;
        for (size_t i = 0; i < system->dimension; i++) square[part] += x[i] * x[i];
    }
    whirl_integrator_free(integrator);
    return 0.5 * log(square[1] / square[0]);
}

static void two_hundred_machines(void **unused) {
    enum { MACHINES = 200 };
    int right = 0, unstable = 0, held = 0, moved = 0, grown = 0;
    (void)unused;
    seed = 41;
    for (int k = 0; k < MACHINES; k++) {
        static machine m;
        number values[MAX_SIZE];
        whirl_case *object;
        whirl_rotor *rotor;
        whirl_modes *modes;
        real growth = -INFINITY, fastest = 0;
        make_machine(&m);
        const size_t count = solve_machine(&m, values);
        for (size_t i = 0; i < count; i++) {
            growth = fmaxl(growth, creall(values[i]));
            fastest = fmaxl(fastest, cabsl(values[i]));
        }
        require_ok(whirl_case_parse(m.text, strlen(m.text), "machine", NULL, &object));
        require_ok(whirl_case_rotor(object, NULL, NAN, &rotor));
        const whirl_system *system = whirl_rotor_system(rotor);
        const double clock = whirl_rotor_clock(rotor);
        double start[MAX_SIZE] = {0};
        require_ok(whirl_modes_new(system, start, &modes));
        const bool same = (modes->growth > 0.0) == (growth > 0.0L) && modes->growth != 0.0;
        if (!same) printf("machine %d: growth %.6Lg, obtained %.6g\n%s", k, growth, clock * modes->growth, m.text);
        right += same;
        unstable += growth > 0.0L;
        held += modes->free == (m.free ? 2u : 0u);
        if (modes->free != (m.free ? 2u : 0u)) printf("machine %d: %zu free\n%s", k, modes->free, m.text);
        // A free pair drifts.
        const double gain = m.free ? (double)NAN : grow(system, (double)growth / clock, (double)fastest / clock);
        moved += isfinite(gain);
        grown += isfinite(gain) && (gain > 0.0) == (growth > 0.0L);
        whirl_modes_free(modes);
        whirl_rotor_free(rotor);
        whirl_case_free(object);
    }
    printf("%d unstable, %d motions\n", unstable, moved);
    check_within("Linear", "random machines: right verdicts of 200", MACHINES, right, 0);
    check_within("Linear", "random machines: right numbers of rigid-body modes", MACHINES, held, 0);
    check_within("Linear", "random machines: motions that do not grow or fall as eigenvalues predict", 0, moved - grown,
                 0);
    assert_true(unstable >= 40 && unstable <= 160 && moved >= 15);
}

// ---------------------------------------------------------------- all elements

static const char frame[] = "whirl: 1\n"
                            "rotor:\n"
                            "  speed: 9000 rpm\n"
                            "  length_scale: 0.1 mm\n"
                            "  stations:\n"
                            "    rotor:  {mass: 10 kg, damping: 900 N.s/m%s}\n"
                            "    stator: {mass: 2 kg, damping: 3 kN.s/m%s}\n"
                            "  elements:\n"
                            "    - spring: {between: [stator, ground], stiffness: 8 MN/m}\n"
                            "    - bearing: {at: rotor, kxx: 4 MN/m, kxy: %g, kyx: %g}\n"
                            "    - gravity\n"
                            "    - %s\n"
                            "study: {modes: {}}\n";

#define STATOR "at: rotor, from: stator, gap: 60 um, stiffness: 3e9, radius: 40 mm, friction: 0.1"
static const char *const elements[] = {
    "magnetic: {at: rotor, from: stator, gap: 0.5 mm, bias: 3 A, turns: 120, area: 4 cm2, proportional: 2e4, "
    "integral: 1e4, derivative: 40, derivative_filter: 0.2 ms, amplifier_bandwidth: 2 kHz}",
    "contact: {" STATOR ", law: hunt_crossley, loss: 0.5}",
    "rub: {at: rotor, gap: 60 um, stiffness: 3e7, friction: 0.1}",
    "blade_rub: {at: rotor, from: stator, blades: 5, radius: 0.3 m, gap: 60 um, stiffness: 2e7}",
    "pad_bearing: {at: rotor, from: stator, shape: offset-half, preload: 0.5, clearance: 0.2 mm, viscosity: 10 mPa.s, "
    "radius: 25 mm, length: 25 mm}",
    "tilting_pad: {at: rotor, from: stator, shape: tilting-5, preload: 0.5, clearance: 0.2 mm, viscosity: 10 mPa.s, "
    "radius: 25 mm, length: 25 mm, inertia: 1e-4 kg m2}",
    "film: {at: rotor, clearance: 0.2 mm, viscosity: 5 mPa.s, radius: 25 mm, length: 15 mm}",
    "floating_ring: {at: rotor, ring: stator, inertia: 1e-3 kg.m2, clearance: 0.1 mm, radius: 25 mm, length: 20 mm, "
    "viscosity: 5 mPa.s, outer_clearance: 0.2 mm, outer_radius: 35 mm, outer_length: 25 mm}",
    "squeeze: {at: rotor, clearance: 0.3 mm, viscosity: 10 mPa.s, radius: 60 mm, length: 15 mm}",
    "seal: {at: rotor, clearance: 0.4 mm, stiffness: 0.5 MN/m, damping: 600 N.s/m, ratio: 0.45}",
    "spring: {between: [rotor, stator], stiffness: 2 MN/m, damping: 30 N.s/m}",
    "cubic_spring: {between: [rotor, stator], stiffness: 1 MN/m, cubic: 1e15, damping: 300}",
    "friction: {between: [rotor, stator], force: 60, slip_speed: 50 mm/s}",
    "looseness: {between: [rotor, stator], stiffness: 20 MN/m, damping: 100 N.s/m}",
    "mount: {between: [rotor, ground], stiffness: 3 MN/m, branch: 2 MN/m, damping: 5 kN.s/m}",
    "ball_bearing: {at: rotor, balls: 9, stiffness: 1e9, clearance: -3 um, cage: 0.4}",
    "roller_bearing: {at: rotor, rollers: 14, stiffness: 5e6, clearance: -3 um, inner: 42 mm, outer: 58 mm}",
    "shaft: {between: [rotor, ground], k1: 1 MN/m, k2: 1.2 MN/m}",
    "crack: {between: [rotor, ground], stiffness: 1 MN/m, loss: 0.1}",
    "stage: {at: rotor, power: 4 MW, diameter: 400 mm, width: 20 mm}",
    "bearing: {at: rotor, from: stator, kxx: 1 MN/m, kyy: 2 MN/m, kxy: 0.2 MN/m, cxx: 40}",
    "disc: {at: rotor, outer: 0.2 m, width: 10 mm}\n    - spring: {between: [rotor, ground], along: tilts, "
    "stiffness: 3e4, damping: 9}",
    "beam: {between: [rotor, stator], length: 0.5 m, bending: 3e4}",
    "coupling: {between: [rotor, stator], radial: 1e5, tilt: 900}",
};

/// Forces by time alone, shafts of finite elements (tests of their own), what needs a misalignment, or twists.
static const char *const others[] = {
    "unbalance",     "force",         "gravity",   "segment", "runout",          "unbalance_grade",
    "joint",         "coupling_load", "drive",     "gear",    "induction_motor", "synchronous_start",
    "short_circuit", "timed_torque",  "pulsation", "fatigue"};

static double distance(const whirl_system *system, const double *a, const double *b) {
    double square = 0.0;
    for (size_t p = 0; p < system->probe_count; p++) {
        const whirl_probe *probe = &system->probes[p];
        const size_t places[] = {probe->x, probe->y, probe->vx, probe->vy};
        for (size_t i = 0; i < 4; i++) square += (a[places[i]] - b[places[i]]) * (a[places[i]] - b[places[i]]);
    }
    return sqrt(square);
}

/// Returns the logarithm of the gain of a small distance from the motion at rest in the second half of 8/|growth|.
static double gain_of(const whirl_system *system, const double *rest, double growth) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    double x[2][MAX_SIZE], was = 1.0, is = 1.0;
    const int half = (int)fmin(40.0, ceil(4.0 / (fabs(growth) * system->period)));
    snprintf(options.method, sizeof options.method, "rodas5p");
    options.rtol = 1e-8;
    options.atol = 1e-12;
    require_ok(whirl_integrator_new(system, &options, &integrator));
    for (size_t i = 0; i < system->dimension; i++) x[0][i] = x[1][i] = rest[i];
    for (size_t p = 0; p < system->probe_count; p++) {
        x[1][system->probes[p].x] += 1e-5;
        x[1][system->probes[p].vy] += 1e-5;
    }
    for (int n = 0; n < 2 * half; n++) {
        for (int i = 0; i < 2; i++) assert_int_equal(whirl_integrator_revolve(integrator, x[i], NULL, NULL), 0);
        is = distance(system, x[0], x[1]);
        if (n + 1 == half) was = is;
        if (is > 1e-3 || is < 1e-9) break;
    }
    whirl_integrator_free(integrator);
    return is > 1e-3 ? 1.0 : is < 1e-9 ? -1.0 : log(is / was);
}

static void every_element(void **unused) {
    static const double circulation[] = {0.0, 2e6, -2e6};
    int wrong = 0, count = 0, unstable = 0;
    (void)unused;
    for (size_t e = 0; e < sizeof elements / sizeof *elements; e++)
        for (size_t c = 0; c < 3; c++) {
            char text[TEXT];
            whirl_case *object;
            whirl_rotor *rotor;
            whirl_modes *modes;
            const bool tilts = strncmp(elements[e], "beam", 4) == 0 || strncmp(elements[e], "coupling", 8) == 0;
            const char *tilt = tilts ? ", diametral: 0.02" : "";
            snprintf(text, sizeof text, frame, tilt, tilt, circulation[c], -circulation[c], elements[e]);
            require_ok(whirl_case_parse(text, strlen(text), "element", NULL, &object));
            require_ok(whirl_case_rotor(object, NULL, NAN, &rotor));
            const whirl_system *system = whirl_rotor_system(rotor);
            double start[MAX_SIZE] = {0};
            assert_true(system->dimension <= MAX_SIZE);
            whirl_rotor_complete(rotor, start);
            require_ok(whirl_modes_new(system, start, &modes));
            const double gain = gain_of(system, modes->rest, modes->growth);
            count++;
            unstable += modes->growth > 0.0;
            if ((gain > 0.0) != (modes->growth > 0.0)) {
                printf("%.14s, %g N/m: growth %.6g, gain %.3g\n", elements[e], circulation[c], modes->growth, gain);
                wrong++;
            }
            whirl_modes_free(modes);
            whirl_rotor_free(rotor);
            whirl_case_free(object);
        }
    printf("%d of %d unstable\n", unstable, count);
    check_within("Linear", "every element, three circulations: verdicts against the growth of a motion", 0, wrong, 0);
    assert_true(4 * unstable > count && 4 * unstable < 3 * count);
    for (const whirl_group *const *group = whirl_element_groups(); *group && (*group)->name; group++) {
        bool found = false;
        const size_t length = strlen((*group)->name);
        for (size_t e = 0; e < sizeof elements / sizeof *elements; e++)
            found = found || (strncmp(elements[e], (*group)->name, length) == 0 && elements[e][length] == ':');
        for (size_t o = 0; o < sizeof others / sizeof *others; o++)
            found = found || strcmp(others[o], (*group)->name) == 0;
        if (!found) fail_msg("no verdict about %s is tested", (*group)->name);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(two_hundred_machines), cmocka_unit_test(every_element)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
