// Jacobians, sides and switches of a rotor with every element, against the same equations typed in from the literature
// in extended complex numbers, whose derivatives by complex steps have no truncation error.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "isa.h"
#include "lanes.h"
#include "settings.h"
#include "vector.h"
#include "whirl/engine/rotor.h"

typedef long double complex number;

enum { STATIONS = 3, DEGREES = 2 * STATIONS, DIMENSION = 2 * DEGREES, TRIALS = 400, SWITCHES = 64, CONTACTS = 64 };

/// A rub, as the reference equations of this file have it. All masses except the disc's, speed and length scale are 1.
typedef struct ring {
    int station;
    double gap, stiffness, damping, friction, radius, slip_speed; ///< damping < 0, radius 0: not given
} ring;

static const double disc_mass = 2.0, seal_mass = 0.15, disc_inertia = 2.15;
static const ring rings[] = {{0, 0.5, 40.0, 3.0, 0.3, 1.5, 0.0},
                             {1, 0.6, 25.0, -1.0, 0.2, 0.0, 0.0},
                             {2, 0.4, 30.0, 2.0, 0.25, 0.8, 0.3},
                             {2, 0.7, 50.0, -1.0, 0.4, 0.6, 0.0}};
enum { RINGS = sizeof rings / sizeof *rings };

static void add_ring(whirl_design *design, const ring *r) {
    static const char *const names[STATIONS] = {"disc", "left", "right"};
    whirl_setting settings[8] = {word("at", names[r->station]), value("gap", r->gap), value("stiffness", r->stiffness),
                                 value("friction", r->friction)};
    size_t count = 4;
    if (r->damping >= 0.0) settings[count++] = value("damping", r->damping);
    if (r->radius > 0.0) {
        settings[count++] = word("law", "slip");
        settings[count++] = value("radius", r->radius);
        settings[count++] = value("slip_speed", r->slip_speed);
    }
    check(whirl_design_element(design, "rub", settings, count));
}

static void add_cracks(whirl_design *design) {
    const whirl_setting gentle[] = {word("between", "right, disc"), value("stiffness", 3.0), value("loss", 0.4),
                                    value("loss_across", 0.1),      value("angle", 0.7),     value("opens", -0.4)};
    const whirl_setting square[] = {word("between", "left, ground"), value("stiffness", 2.0), value("loss", 0.3),
                                    word("law", "square"), value("terms", 5)};
    check(whirl_design_element(design, "crack", gentle, 6));
    check(whirl_design_element(design, "crack", square, 5));
}

static whirl_rotor *make_rotor(void) {
    whirl_design *design;
    whirl_rotor *rotor;
    check(whirl_design_new(1.0, 1.0, &design));
    check(whirl_design_station(design, "disc", (whirl_setting[]){value("mass", disc_mass), value("damping", 0.3)}, 2));
    check(whirl_design_station(design, "left", (whirl_setting[]){value("mass", 1.0), value("eccentricity", 0.1)}, 2));
    check(whirl_design_station(design, "right", (whirl_setting[]){value("mass", 1.0), value("damping", 0.1)}, 2));
    const char *const shafts[][2] = {{"disc, left", "paper"}, {"disc, right", "derived"}, {"left, ground", "derived"}};
    for (int i = 0; i < 3; i++)
        check(whirl_design_element(design, "shaft",
                                   (whirl_setting[]){word("between", shafts[i][0]), value("k1", 1.0 + i),
                                                     value("k2", 2.5), word("signs", shafts[i][1])},
                                   4));
    check(whirl_design_element(design, "film",
                               (whirl_setting[]){word("at", "left"), value("clearance", 1.0), value("load", 0.02)}, 3));
    check(whirl_design_element(
        design, "film", (whirl_setting[]){word("at", "right"), value("clearance", 0.8), value("load", 0.05)}, 3));
    for (int i = 0; i < RINGS; i++) add_ring(design, &rings[i]);
    add_cracks(design);
    const whirl_setting seal[] = {word("at", "disc"),    value("clearance", 1.1),  value("stiffness", 0.7),
                                  value("damping", 0.4), value("mass", seal_mass), value("ratio", 0.48),
                                  value("growth", 1.7),  value("slowing", 0.6)};
    check(whirl_design_element(design, "seal", seal, 8));
    check(whirl_design_element(design, "gravity", (whirl_setting[]){value("acceleration", 0.1)}, 1));
    check(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

// ---------------------------------------------------------------- the equations, in complex numbers

static void shaft(double k1, double k2, double sign, double t, const number d[2], number f[2]) {
    const long double mean = 0.5L * (k1 + k2), half = 0.5L * (k1 - k2);
    const long double c = cosl(2.0L * t), s = sinl(2.0L * t);
    f[0] = -((mean + half * c) * d[0] + half * s * d[1]);
    f[1] = -(half * s * d[0] + (mean + sign * half * c) * d[1]);
}

/// Computes the force of Capone's film at z = (x, y, x', y'), in clearances.
static void film(const number z[4], number f[2]) {
    const number x = z[0], y = z[1], A = x - 2.0L * z[3], B = y + 2.0L * z[2], C = csqrtl(A * A + B * B);
    const number ca = -A / C, sa = -B / C, q = 1.0L - x * x - y * y, root = csqrtl(q);
    const number across = y * ca - x * sa, along = x * ca + y * sa;
    const number G = 2.0L / root * (acosl(-1.0L) / 2.0L + catanl(across / root));
    const number V = (2.0L + across * G) / q, S = along / (1.0L - along * along), K = -C / q;
    f[0] = K * (3.0L * x * V - sa * G - 2.0L * ca * S);
    f[1] = K * (3.0L * y * V + ca * G - 2.0L * sa * S);
}

/// Computes the force of a shaft of stiffness k with a crack at `angle` under a load along `load`. `terms`: number of
/// terms of the square wave; 0: a cosine.
static void crack(double k, double loss, double across, double angle, double load, int terms, double t,
                  const number d[2], number f[2]) {
    const long double c = cosl(t + angle), s = sinl(t + angle), phi = t + angle - load;
    long double open = 0.5L * (1.0L + cosl(phi));
    if (terms > 0) open = 0.5L;
    for (int i = 0; i < terms; i++)
        open += (i % 2 ? -2.0L : 2.0L) / acosl(-1.0L) * cosl((2 * i + 1) * phi) / (2 * i + 1);
    const number along = k * (1.0L - loss * open) * (c * d[0] + s * d[1]);
    const number aside = k * (1.0L - across * open) * (c * d[1] - s * d[0]);
    f[0] = -(c * along - s * aside);
    f[1] = -(s * along + c * aside);
}

/// Computes the force of the seal at the disc, without the term of its fluid's inertia (in disc_inertia).
static void seal(const number *z, number f[2]) {
    const number x = z[0], y = z[1], vx = z[DEGREES], vy = z[DEGREES + 1], e = csqrtl(x * x + y * y) / 1.1L;
    const number turn = 0.48L * cpowl(1.0L - e, 0.6L), grown = cpowl(1.0L - e * e, -1.7L);
    const number K = 0.7L * grown, D = 0.4L * grown, m = seal_mass;
    // m (d/dt - i turn)^2 z + D (d/dt - i turn) z + K z without m z''.
    f[0] = -(m * (2.0L * turn * vy - turn * turn * x) + D * (vx + turn * y) + K * x);
    f[1] = -(m * (-2.0L * turn * vx - turn * turn * y) + D * (vy - turn * x) + K * y);
}

/// Computes the switching functions of a ring; returns their number.
static int ring_switches(const ring *r, const number *z, number *values) {
    const number *q = z + 2 * r->station, *v = z + DEGREES + 2 * r->station;
    const long double mass = r->station == 0 ? disc_inertia : 1.0L;
    const number radius = csqrtl(q[0] * q[0] + q[1] * q[1]);
    int count = 0;
    values[count++] = radius - r->gap;
    if (r->damping >= 0.0)
        values[count++] = (r->stiffness * (radius - r->gap) + r->damping * (q[0] * v[0] + q[1] * v[1]) / radius) / mass;
    if (r->radius > 0.0 && r->slip_speed <= 0.0) values[count++] = r->radius * radius + q[0] * v[1] - q[1] * v[0];
    return count;
}

/// Computes the ring's force on given sides of its switches; returns their number.
static int ring_force(const ring *r, const number *z, const double *sides, number f[2]) {
    number values[3];
    const int count = ring_switches(r, z, values);
    f[0] = f[1] = 0.0L;
    if (sides[0] < 0.0 || (r->damping >= 0.0 && sides[1] < 0.0)) return count;
    const number *q = z + 2 * r->station, *v = z + DEGREES + 2 * r->station;
    const number radius = csqrtl(q[0] * q[0] + q[1] * q[1]);
    const number normal =
        r->stiffness * (radius - r->gap) + fmaxl(r->damping, 0.0L) * (q[0] * v[0] + q[1] * v[1]) / radius;
    number sign = 1.0L;
    if (r->radius > 0.0) {
        const number slip = r->radius + (q[0] * v[1] - q[1] * v[0]) / radius;
        sign =
            r->slip_speed > 0.0 ? slip / csqrtl(slip * slip + r->slip_speed * r->slip_speed) : (number)sides[count - 1];
    }
    f[0] = -normal / radius * (q[0] - sign * r->friction * q[1]);
    f[1] = -normal / radius * (sign * r->friction * q[0] + q[1]);
    return count;
}

static void add(number *a, int station, const number f[2], long double factor) {
    a[2 * station] += factor * f[0];
    a[2 * station + 1] += factor * f[1];
}

static void add_shafts(double t, const number *z, number *a) {
    number f[2];
    shaft(1.0, 2.5, 1.0, t, (number[]){z[0] - z[2], z[1] - z[3]}, f);
    add(a, 0, f, 1.0L / disc_inertia);
    add(a, 1, f, -1.0L);
    shaft(2.0, 2.5, -1.0, t, (number[]){z[0] - z[4], z[1] - z[5]}, f);
    add(a, 0, f, 1.0L / disc_inertia);
    add(a, 2, f, -1.0L);
    shaft(3.0, 2.5, -1.0, t, z + 2, f);
    add(a, 1, f, 1.0L);
    const double down = -1.57079632679489661923;
    crack(3.0, 0.4, 0.1, 0.7, -0.4, 0, t, (number[]){z[0] - z[4], z[1] - z[5]}, f);
    add(a, 0, f, 1.0L / disc_inertia);
    add(a, 2, f, -1.0L);
    crack(2.0, 0.3, 0.0, 0.0, down, 5, t, z + 2, f);
    add(a, 1, f, 1.0L);
}

static void equations(double t, const number *z, const double *sides, number *dz) {
    static const long double damping[STATIONS] = {0.3L / 2.15L, 0.0L, 0.1L};
    number f[2], *a = dz + DEGREES;
    for (int i = 0; i < DEGREES; i++) {
        dz[i] = z[DEGREES + i];
        a[i] = -damping[i / 2] * z[DEGREES + i] - (i % 2 ? 0.1L : 0.0L) * (i < 2 ? disc_mass / disc_inertia : 1.0L);
    }
    seal(z, f);
    add(a, 0, f, 1.0L / disc_inertia);
    a[2] += 0.1L * cosl(t);
    a[3] += 0.1L * sinl(t);
    add_shafts(t, z, a);
    film((number[]){z[2], z[3], z[8], z[9]}, f);
    add(a, 1, f, 0.02L);
    film((number[]){z[4] / 0.8L, z[5] / 0.8L, z[10] / 0.8L, z[11] / 0.8L}, f);
    add(a, 2, f, 0.05L);
    for (int i = 0; i < RINGS; i++) {
        sides += ring_force(&rings[i], z, sides, f);
        add(a, rings[i].station, f, rings[i].station == 0 ? 1.0L / disc_inertia : 1.0L);
    }
}

static int equations_switches(const number *z, number *values) {
    int count = 0;
    for (int i = 0; i < RINGS; i++) count += ring_switches(&rings[i], z, values + count);
    return count;
}

// ---------------------------------------------------------------- states

/// Draws a state: journals as near as 1e-3 of the clearance to the wall, the disc inside or outside of its ring.
static void draw_state(uint64_t *seed, double *z) {
    for (int s = 0; s < STATIONS; s++) {
        const double most = s == 0 ? 1.0 : s == 1 ? 1.0 : 0.8;
        const double radius = most * (1.0 - exp2(uniform(seed, -10.0, 0.0))), angle = uniform(seed, 0.0, 6.28);
        z[2 * s] = radius * cos(angle);
        z[2 * s + 1] = radius * sin(angle);
        const double fast = s == 0 ? 4.0 : 1.0;
        for (int i = 0; i < 2; i++) z[DEGREES + 2 * s + i] = uniform(seed, -fast, fast);
    }
}

static void to_complex(const double *z, number *out) {
    for (int i = 0; i < DIMENSION; i++) out[i] = z[i];
}

static void sides_of(const whirl_system *system, const double *z, double *sides) {
    system->switches(system->model, 0.0, z, sides);
    for (size_t i = 0; i < system->switch_count; i++) sides[i] = sides[i] > 0.0 ? 1.0 : -1.0;
}

/// Computes column `by` of the Jacobian from the reference equations, by a complex step.
static void reference_column(double t, const double *z, const double *sides, int by, double *column) {
    const long double step = 1e-24L;
    number w[DIMENSION], dw[DIMENSION];
    to_complex(z, w);
    w[by] += step * I;
    equations(t, w, sides, dw);
    for (int i = 0; i < DIMENSION; i++) column[i] = (double)(cimagl(dw[i]) / step);
}

static double largest(const double *values, int count) {
    double most = 0.0;
    for (int i = 0; i < count; i++) most = fmax(most, fabs(values[i]));
    return most;
}

static void identity(double *columns) {
    memset(columns, 0, DIMENSION * DIMENSION * sizeof *columns);
    for (int i = 0; i < DIMENSION; i++) columns[i * DIMENSION + i] = 1.0;
}

/// Returns a bound for the rounding errors of the films' forces (power 2.5) or their derivatives (3.5). Where a film
/// widens, terms of the size C/q^power cancel, as large as in a film of the same thickness that narrows.
static double film_rounding(const double *z, double power) {
    const double clearance[2] = {1.0, 0.8}, load[2] = {0.02, 0.05};
    double worst = 0.0;
    for (int i = 0; i < 2; i++) {
        const double *q = z + 2 + 2 * i, *v = z + DEGREES + 2 + 2 * i;
        const double x = q[0] / clearance[i], y = q[1] / clearance[i];
        const double C = hypot(x - 2.0 * v[1] / clearance[i], y + 2.0 * v[0] / clearance[i]);
        worst = fmax(worst, load[i] / clearance[i] * C * pow(1.0 - x * x - y * y, -power));
    }
    return 2e-14 * worst;
}

static int near_enough(double ours, double theirs, double scale, double rounding) {
    return fabs(ours - theirs) <= 1e-12 * fmax(1.0, scale) + rounding;
}

// ---------------------------------------------------------------- tests

/// Compares Jacobian and divergence with the reference: on the state's own sides, or on sides drawn at random.
static void compare_jacobians(int at_random) {
    whirl_rotor *rotor = make_rotor();
    const whirl_system *system = whirl_rotor_system(rotor);
    double unit[DIMENSION * DIMENSION], ours[DIMENSION * DIMENSION], theirs[DIMENSION], sides[SWITCHES];
    uint64_t seed = 5;
    identity(unit);
    assert_int_equal(system->switch_count, 8);
    for (int trial = 0; trial < TRIALS; trial++) {
        double z[DIMENSION], forcing[WHIRL_MAX_FORCING], trace = 0.0, size = 0.0;
        const double t = uniform(&seed, 0.0, 6.28);
        draw_state(&seed, z);
        sides_of(system, z, sides);
        for (size_t i = 0; at_random && i < system->switch_count; i++)
            sides[i] = uniform(&seed, 0.0, 1.0) < 0.5 ? -1.0 : 1.0;
        system->forcing(system->model, t, forcing);
        system->tangent(system->model, t, forcing, z, at_random ? sides : NULL, DIMENSION, unit, ours);
        const double rounding = film_rounding(z, 3.5);
        for (int by = 0; by < DIMENSION; by++) {
            reference_column(t, z, sides, by, theirs);
            const double *column = ours + by * DIMENSION;
            for (int i = 0; i < DIMENSION; i++)
                assert_true(near_enough(column[i], theirs[i], largest(theirs, DIMENSION), rounding));
            trace += theirs[by];
            size = fmax(size, largest(theirs, DIMENSION));
        }
        const double sum = system->divergence(system->model, t, forcing, z, at_random ? sides : NULL);
        assert_true(near_enough(sum, trace, size, rounding));
    }
    whirl_rotor_free(rotor);
}

static void test_jacobian_where_the_state_decides(void **state) {
    (void)state;
    compare_jacobians(0);
}

static void test_jacobian_on_given_sides(void **state) {
    (void)state;
    compare_jacobians(1);
}

static void test_many_perturbations_are_one_after_the_other(void **state) {
    // More perturbations than a rotor takes at once.
    enum { MANY = 3000 };
    static double dx[MANY][DIMENSION], together[MANY][DIMENSION];
    whirl_rotor *rotor = make_rotor();
    const whirl_system *system = whirl_rotor_system(rotor);
    double z[DIMENSION], forcing[WHIRL_MAX_FORCING], alone[DIMENSION];
    uint64_t seed = 31;
    (void)state;
    draw_state(&seed, z);
    for (int k = 0; k < MANY; k++)
        for (int i = 0; i < DIMENSION; i++) dx[k][i] = uniform(&seed, -1.0, 1.0);
    system->forcing(system->model, 1.0, forcing);
    system->tangent(system->model, 1.0, forcing, z, NULL, MANY, dx[0], together[0]);
    for (int k = 0; k < MANY; k++) {
        system->tangent(system->model, 1.0, forcing, z, NULL, 1, dx[k], alone);
        assert_memory_equal(alone, together[k], sizeof alone);
    }
    whirl_rotor_free(rotor);
}

static void test_sides_hold_the_laws(void **state) {
    whirl_rotor *rotor = make_rotor();
    const whirl_system *system = whirl_rotor_system(rotor);
    uint64_t seed = 6;
    (void)state;
    for (int trial = 0; trial < TRIALS; trial++) {
        double z[DIMENSION], forcing[WHIRL_MAX_FORCING], sides[SWITCHES], ours[DIMENSION], free[DIMENSION];
        number w[DIMENSION], dw[DIMENSION];
        const double t = uniform(&seed, 0.0, 6.28);
        draw_state(&seed, z);
        to_complex(z, w);
        system->forcing(system->model, t, forcing);
        sides_of(system, z, sides);
        system->rhs(system->model, t, forcing, z, free);
        system->rhs_on_sides(system->model, t, forcing, z, sides, ours);
        for (int i = 0; i < DIMENSION; i++) assert_true(fabs(ours[i] - free[i]) <= 1e-15 * fabs(free[i]));
        for (size_t i = 0; i < system->switch_count; i++) sides[i] = uniform(&seed, 0.0, 1.0) < 0.5 ? -1.0 : 1.0;
        system->rhs_on_sides(system->model, t, forcing, z, sides, ours);
        equations(t, w, sides, dw);
        for (int i = 0; i < DIMENSION; i++)
            assert_true(near_enough(ours[i], (double)creall(dw[i]), largest(ours, DIMENSION), film_rounding(z, 2.5)));
    }
    whirl_rotor_free(rotor);
}

static void test_switches_and_their_gradients(void **state) {
    whirl_rotor *rotor = make_rotor();
    const whirl_system *system = whirl_rotor_system(rotor);
    uint64_t seed = 7;
    (void)state;
    for (int trial = 0; trial < TRIALS; trial++) {
        double z[DIMENSION], values[SWITCHES], gradient[DIMENSION], by_time;
        const long double step = 1e-24L;
        number w[DIMENSION], reference[SWITCHES];
        draw_state(&seed, z);
        to_complex(z, w);
        system->switches(system->model, 0.0, z, values);
        assert_int_equal(equations_switches(w, reference), system->switch_count);
        for (size_t k = 0; k < system->switch_count; k++) {
            assert_true(fabs(values[k] - (double)creall(reference[k])) <= 1e-13 * (1.0 + fabs(values[k])));
            system->switch_gradient(system->model, 0.0, z, k, gradient, &by_time);
            assert_true(by_time == 0.0);
            for (int i = 0; i < DIMENSION; i++) {
                to_complex(z, w);
                w[i] += step * I;
                equations_switches(w, reference);
                const double truth = (double)(cimagl(reference[k]) / step);
                assert_true(fabs(gradient[i] - truth) <= 1e-12 * fmax(1.0, largest(gradient, DIMENSION)));
            }
        }
    }
    whirl_rotor_free(rotor);
}

/// Returns the derivative of switch k by coordinate i at z + shift u, by a complex step.
static long double slope_at(const double *z, const double *u, long double shift, size_t k, int i) {
    const long double step = 1e-24L;
    number w[DIMENSION], values[SWITCHES];
    for (int j = 0; j < DIMENSION; j++) w[j] = z[j] + shift * u[j];
    w[i] += step * I;
    equations_switches(w, values);
    return cimagl(values[k]) / step;
}

static void test_curvatures_of_switches(void **state) {
    whirl_rotor *rotor = make_rotor();
    const whirl_system *system = whirl_rotor_system(rotor);
    uint64_t seed = 8;
    (void)state;
    for (int trial = 0; trial < TRIALS; trial++) {
        double z[DIMENSION], u[DIMENSION], out[DIMENSION];
        draw_state(&seed, z);
        double near = 1.0; // how close a station is to the middle, where the normal turns fast
        for (int s = 0; s < STATIONS; s++) near = fmin(near, hypot(z[2 * s], z[2 * s + 1]));
        for (int i = 0; i < DIMENSION; i++) u[i] = uniform(&seed, -1.0, 1.0);
        for (size_t k = 0; k < system->switch_count; k++) {
            system->switch_curvature(system->model, 0.0, z, k, u, out);
            for (int i = 0; i < DIMENSION; i++) {
                // Central differences of order four of exact slopes, in extended precision.
                const long double h = 1e-4L * near;
                const long double one = slope_at(z, u, h, k, i) - slope_at(z, u, -h, k, i);
                const long double two = slope_at(z, u, 2 * h, k, i) - slope_at(z, u, -2 * h, k, i);
                const double truth = (double)((8.0L * one - two) / (12.0L * h));
                assert_true(fabs(out[i] - truth) <= 1e-10 * fmax(1.0, largest(out, DIMENSION)));
            }
        }
    }
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- lanes

enum { VECTORS = 5, LANES = VECTORS * 8, TANGENTS = 3, ROWS = (1 + TANGENTS) * DEGREES, NUMBERS = 128 };

/// Arrays of lanes, aligned for the widest vectors.
typedef struct block {
    _Alignas(64) double numbers[NUMBERS * LANES], forcing[WHIRL_MAX_FORCING * LANES];
    _Alignas(64) double sides[SWITCHES * LANES], t[LANES];
    _Alignas(64) double q[ROWS * LANES], v[ROWS * LANES], a[ROWS * LANES], divergence[LANES];
    _Alignas(64) double values[SWITCHES * LANES], rates[SWITCHES * LANES];
    _Alignas(64) double normal[CONTACTS * LANES];
} block;

/// Draws all lanes of a block, the same ones for every width.
static void draw_lanes(const whirl_system *system, size_t lanes, size_t width, block *b) {
    double one[NUMBERS];
    uint64_t seed = 99;
    system->lanes->numbers(system->model, one);
    assert_true(system->lanes->number_count <= NUMBERS);
    for (size_t l = 0; l < lanes; l++) {
        double z[DIMENSION];
        for (size_t i = 0; i < system->lanes->number_count; i++) b->numbers[i * width + l] = one[i];
        b->t[l] = uniform(&seed, 0.0, 6.28);
        for (int k = 0; k <= TANGENTS; k++) {
            if (k == 0) draw_state(&seed, z);
            for (int i = 0; k > 0 && i < DIMENSION; i++) z[i] = uniform(&seed, -1.0, 1.0);
            for (int i = 0; i < DEGREES; i++) {
                b->q[(size_t)(k * DEGREES + i) * width + l] = z[i];
                b->v[(size_t)(k * DEGREES + i) * width + l] = z[DEGREES + i];
            }
        }
        for (size_t i = 0; i < system->switch_count; i++)
            b->sides[i * width + l] = uniform(&seed, 0.0, 1.0) < 0.5 ? -1.0 : 1.0;
    }
}

static void run_lanes(const whirl_system *system, int set, size_t lanes, int sided, block *b) {
    const size_t vectors = lanes / isa_at(set)->lanes;
    draw_lanes(system, lanes, lanes, b);
    lanes_view view = {.model = system->model,
                       .stride = vectors,
                       .vectors = vectors,
                       .numbers = b->numbers,
                       .forcing = b->forcing,
                       .sides = sided ? b->sides : NULL,
                       .tangents = TANGENTS,
                       .q = b->q,
                       .v = b->v,
                       .a = b->a,
                       .divergence = b->divergence};
    system->lanes->forcing[set](system->model, vectors, vectors, b->t, b->forcing);
    system->lanes->flow[set](&view);
    system->lanes->switches[set](&view, b->values, b->rates);
    system->lanes->contacts[set](&view, b->normal, NULL);
}

/// Collects x [DIMENSION] of state or perturbation k of a lane.
static void gather(const double *q, const double *v, size_t lanes, int k, size_t lane, double *x) {
    for (int i = 0; i < DEGREES; i++) {
        x[i] = q[(size_t)(k * DEGREES + i) * lanes + lane];
        x[DEGREES + i] = v[(size_t)(k * DEGREES + i) * lanes + lane];
    }
}

/// Compares one lane of a block with the functions of the system.
static void compare_lane(const whirl_system *system, const block *b, size_t lanes, size_t lane, int sided) {
    double x[DIMENSION], slope[DIMENSION], forcing[WHIRL_MAX_FORCING], sides[SWITCHES];
    double dx[TANGENTS * DIMENSION], ddx[TANGENTS * DIMENSION], got[DIMENSION], normal[CONTACTS];
    gather(b->q, b->v, lanes, 0, lane, x);
    const double rounding = film_rounding(x, 3.5);
    for (size_t i = 0; i < system->switch_count; i++) sides[i] = b->sides[i * lanes + lane];
    system->forcing(system->model, b->t[lane], forcing);
    for (size_t i = 0; i < system->forcing_count; i++)
        assert_true(fabs(forcing[i] - b->forcing[i * lanes + lane]) <= 1e-15);
    if (sided)
        system->rhs_on_sides(system->model, b->t[lane], forcing, x, sides, slope);
    else
        system->rhs(system->model, b->t[lane], forcing, x, slope);
    gather(b->v, b->a, lanes, 0, lane, got);
    const double size = fmax(1.0, largest(slope, DIMENSION));
    for (int i = 0; i < DIMENSION; i++) assert_true(near_enough(got[i], slope[i], size, rounding));
    for (int k = 0; k < TANGENTS; k++) gather(b->q, b->v, lanes, k + 1, lane, dx + k * DIMENSION);
    system->tangent(system->model, b->t[lane], forcing, x, sided ? sides : NULL, TANGENTS, dx, ddx);
    const double steep = fmax(1.0, largest(ddx, TANGENTS * DIMENSION));
    for (int k = 0; k < TANGENTS; k++) {
        gather(b->v, b->a, lanes, k + 1, lane, got);
        for (int i = 0; i < DIMENSION; i++) assert_true(near_enough(got[i], ddx[k * DIMENSION + i], steep, rounding));
    }
    const double trace = system->divergence(system->model, b->t[lane], forcing, x, sided ? sides : NULL);
    assert_true(near_enough(b->divergence[lane], trace, fmax(steep, fabs(trace)), rounding));
    double values[SWITCHES];
    system->switches(system->model, b->t[lane], x, values);
    for (size_t k = 0; k < system->switch_count; k++) {
        double gradient[DIMENSION], rate;
        system->switch_gradient(system->model, b->t[lane], x, k, gradient, &rate);
        for (int i = 0; i < DIMENSION; i++) rate += gradient[i] * slope[i];
        assert_true(fabs(b->values[k * lanes + lane] - values[k]) <= 1e-12 * (1.0 + fabs(values[k])));
        const double steepest = fmax(1.0, largest(gradient, DIMENSION));
        assert_true(near_enough(b->rates[k * lanes + lane], rate, size * steepest, rounding * steepest));
    }
    system->contacts(system->model, x, normal);
    for (size_t k = 0; k < system->contact_count; k++)
        assert_true(fabs(b->normal[k * lanes + lane] - normal[k]) <= 1e-11 * (1.0 + normal[k]));
}

static void test_lanes_of_every_instruction_set(void **state) {
    static block blocks[VECTOR_ISAS];
    whirl_rotor *rotor = make_rotor();
    const whirl_system *system = whirl_rotor_system(rotor);
    (void)state;
    for (int sided = 0; sided < 2; sided++) {
        const block *fused = NULL, *unfused = NULL;
        for (int set = 0; set < VECTOR_ISAS; set++) {
            if (!isa_at(set)) continue;
            const size_t lanes =
                LANES; // whole vectors of every width, and a number that groups of the film's kernel do not divide
            run_lanes(system, set, lanes, sided, &blocks[set]);
            for (size_t lane = 0; lane < lanes; lane++) compare_lane(system, &blocks[set], lanes, lane, sided);
            const block **same = isa_at(set)->fused ? &fused : &unfused;
            if (!*same) *same = &blocks[set];
            assert_memory_equal((*same)->a, blocks[set].a, sizeof blocks[set].a);
            assert_memory_equal((*same)->divergence, blocks[set].divergence, sizeof blocks[set].divergence);
            assert_memory_equal((*same)->rates, blocks[set].rates, sizeof blocks[set].rates);
            assert_memory_equal((*same)->forcing, blocks[set].forcing, sizeof blocks[set].forcing);
        }
    }
    whirl_rotor_free(rotor);
}

static void test_a_damped_contact_never_pulls(void **state) {
    whirl_rotor *rotor = make_rotor();
    const whirl_system *system = whirl_rotor_system(rotor);
    double z[DIMENSION] = {0.6, 0.0, 0.1, 0.0, 0.1, 0.0}, normal[CONTACTS], dz[2][DIMENSION];
    double forcing[WHIRL_MAX_FORCING];
    (void)state;
    // 40 (0.6 - 0.5) + 3 x': 7 inwards at x' = 1, and 0 if the disc leaves the ring faster than 4/3.
    const double speeds[] = {1.0, 0.0, -1.0, -4.0 / 3.0 - 1e-9, -2.0}, forces[] = {7.0, 4.0, 1.0, 0.0, 0.0};
    for (int i = 0; i < 5; i++) {
        z[DEGREES] = speeds[i];
        system->contacts(system->model, z, normal);
        assert_true(fabs(normal[0] - forces[i]) < 1e-12);
        system->forcing(system->model, 0.0, forcing);
        system->rhs(system->model, 0.0, forcing, z, dz[0]);
        double sides[SWITCHES];
        sides_of(system, z, sides);
        sides[0] = -1.0;
        system->rhs_on_sides(system->model, 0.0, forcing, z, sides, dz[1]);
        assert_true(fabs(dz[0][DEGREES] - dz[1][DEGREES] + forces[i] / disc_inertia) < 1e-12);
    }
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_jacobian_where_the_state_decides),
        cmocka_unit_test(test_jacobian_on_given_sides),
        cmocka_unit_test(test_many_perturbations_are_one_after_the_other),
        cmocka_unit_test(test_sides_hold_the_laws),
        cmocka_unit_test(test_switches_and_their_gradients),
        cmocka_unit_test(test_curvatures_of_switches),
        cmocka_unit_test(test_lanes_of_every_instruction_set),
        cmocka_unit_test(test_a_damped_contact_never_pulls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
