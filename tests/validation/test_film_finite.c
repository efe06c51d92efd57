// Films of finite length beside an independent solution of Reynolds' equation, in housings that move, between surfaces
// that both turn.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "whirl/analyze.h"
#include "whirl/rotor.h"

static const double pi = 3.14159265358979323846;

static double uniform(uint64_t *seed, double low, double high) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

// ---------------------------------------------------------------- finite volumes around, a cosine series along

enum { MOST_CELLS = 640, MODES = 10, POINTS = 10 };

/// Pressures at the cells from t = 0 to pi of one mode along the axis: that by A, odd in t, and that by B, even.
/// (h^3 p')' - (k/r)^2 h^3 p = s, h = 1 - e cos t, r = L/D, by elimination; less those of a short film, -(r/k)^2 s/h^3,
/// so that few modes are enough.
static void solve_mode(double e, double r, double k, size_t cells, double odd[], double even[]) {
    const double dt = pi / (double)cells;
    double *const by[2] = {odd, even}, share[MOST_CELLS];
    for (int parity = 0; parity < 2; parity++) {
        double *p = by[parity], left = parity == 0 ? 2.0 * pow(1.0 - e, 3.0) : 0.0;
        for (size_t i = 0; i < cells; i++) {
            const double t = dt * ((double)i + 0.5), cube = pow(1.0 - e * cos(t), 3.0);
            double right = pow(1.0 - e * cos(t + 0.5 * dt), 3.0);
            if (i + 1 == cells) right = parity == 0 ? 2.0 * right : 0.0;
            double diagonal = -(left + right) - pow(k / r * dt, 2.0) * cube;
            double source = dt * dt * (parity == 0 ? sin(t) : -cos(t));
            if (i > 0) {
                diagonal -= left * share[i - 1];
                source -= left * p[i - 1];
            }
            share[i] = right / diagonal;
            p[i] = source / diagonal;
            left = right;
        }
        for (size_t i = cells - 1; i-- > 0;) p[i] -= share[i] * p[i + 1];
        for (size_t i = 0; i < cells; i++) {
            const double t = dt * ((double)i + 0.5);
            p[i] += pow(r / k, 2.0) * (parity == 0 ? sin(t) : -cos(t)) / pow(1.0 - e * cos(t), 3.0);
        }
    }
}

/// The moment of what is positive of a line through two neighbours, of weight `w` at these.
static double positive(double a, double b, double wa, double wb) {
    if (a <= 0.0 && b <= 0.0) return 0.0;
    if (a >= 0.0 && b >= 0.0) return 0.5 * (a * wa + b * wb);
    const double share = a > 0.0 ? a / (a - b) : b / (b - a), top = a > 0.0 ? a : b, w = a > 0.0 ? wa : wb;
    return 0.5 * share * top * w;
}

/// f of a journal at (e, 0), for all directions of (A, B) [count], in mu omega R L (R/c)^2.
static void forces_on_grid(double e, double r, size_t cells, size_t count, const double *angle, double f[][2]) {
    // Gauss' rule of ten points over 0 to 1.
    static const double node[5] = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244, 0.8650633666889845,
                                   0.9739065285171717};
    static const double weight[5] = {0.2955242247147529, 0.2692667193099963, 0.2190863625159820, 0.1494513491505806,
                                     0.0666713443086881};
    static double odd[POINTS][MOST_CELLS], even[POINTS][MOST_CELLS];
    double p[MOST_CELLS], q[MOST_CELLS];
    const double dt = pi / (double)cells;
    for (int z = 0; z < POINTS; z++)
        for (size_t i = 0; i < cells; i++) {
            const double place = 0.5 + (z % 2 ? -0.5 : 0.5) * node[z / 2], t = dt * ((double)i + 0.5);
            const double across = -0.5 * r * r * (1.0 - place * place) / pow(1.0 - e * cos(t), 3.0);
            odd[z][i] = across * sin(t);
            even[z][i] = -across * cos(t);
        }
    for (int m = 0; m < MODES; m++) {
        const double k = (m + 0.5) * pi;
        solve_mode(e, r, k, cells, p, q);
        for (int z = 0; z < POINTS; z++) {
            const double place = 0.5 + (z % 2 ? -0.5 : 0.5) * node[z / 2];
            const double factor = (m % 2 ? -2.0 : 2.0) / k * cos(k * place);
            for (size_t i = 0; i < cells; i++) {
                odd[z][i] += factor * p[i];
                even[z][i] += factor * q[i];
            }
        }
    }
    for (size_t n = 0; n < count; n++) {
        const double A = cos(angle[n]), B = sin(angle[n]);
        f[n][0] = f[n][1] = 0.0;
        for (int z = 0; z < POINTS; z++)
            for (size_t i = 0; i < 2 * cells; i++) {
                // From -pi to pi, and from the last cell to the first.
                const size_t j = (i + 1) % (2 * cells);
                const double t = -pi + dt * ((double)i + 0.5), s = t + dt;
                const double a = i < cells ? B * even[z][cells - 1 - i] - A * odd[z][cells - 1 - i]
                                           : B * even[z][i - cells] + A * odd[z][i - cells];
                const double b = j < cells ? B * even[z][cells - 1 - j] - A * odd[z][cells - 1 - j]
                                           : B * even[z][j - cells] + A * odd[z][j - cells];
                // From both halves of the axis.
                const double size = -3.0 * weight[z / 2] * dt;
                f[n][0] += size * positive(a, b, cos(t), cos(s));
                f[n][1] += size * positive(a, b, sin(t), sin(s));
            }
    }
}

/// The same from two grids.
static void reynolds(double e, double r, size_t count, const double *angle, double f[][2]) {
    enum { MOST = 16 };
    double coarse[MOST][2];
    assert_true(count <= MOST);
    forces_on_grid(e, r, 320, count, angle, coarse);
    forces_on_grid(e, r, 640, count, angle, f);
    for (size_t n = 0; n < count; n++)
        for (int i = 0; i < 2; i++) f[n][i] += (f[n][i] - coarse[n][i]) / 3.0;
}

// ---------------------------------------------------------------- whirl's

/// A journal of mass 1 in a film of clearance, viscosity and radius 1 at speed 1: accelerations are forces in
/// mu omega R^3 L/c^2, over the length.
static whirl_rotor *make_film(double r, double speed, const whirl_setting *more, size_t count) {
    whirl_setting film[12] = {{"at", 0.0, "journal"},  {"clearance", 1.0, NULL}, {"viscosity", 1.0, NULL},
                              {"radius", 1.0, NULL},   {"length", 2.0 * r, NULL}, {"law", 0.0, "finite"}};
    const whirl_setting mass = {"mass", 1.0, NULL};
    whirl_design *design;
    whirl_rotor *rotor;
    memcpy(film + 6, more, count * sizeof *more);
    require_ok(whirl_design_new(speed, 1.0, &design));
    require_ok(whirl_design_station(design, "journal", &mass, 1));
    require_ok(whirl_design_station(design, "housing", &mass, 1));
    require_ok(whirl_design_element(design, "film", film, 6 + count));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// The force on the journal at (x, y) for A and B.
static void film_force(const whirl_rotor *rotor, double r, double x, double y, double A, double B, double f[2]) {
    const double state[8] = {x, y, 0.0, 0.0, 0.5 * (B - y), 0.5 * (x - A), 0.0, 0.0};
    double slope[8];
    evaluate_rhs(whirl_rotor_system(rotor), 0.0, state, slope);
    for (int i = 0; i < 2; i++) f[i] = slope[4 + i] / (2.0 * r);
}

/// Random states: largest error over the force where e is up to .9, and up to .95.
static void compare(double r, uint64_t *seed, double worst[2]) {
    enum { PLACES = 36, DIRECTIONS = 8 };
    whirl_rotor *rotor = make_film(r, 1.0, NULL, 0);
    for (int i = 0; i < PLACES; i++) {
        const bool near = i % 4 == 3;
        const double e = near ? uniform(seed, 0.9, 0.95) : 0.9 * sqrt(uniform(seed, 0.0, 1.0));
        const double at = uniform(seed, 0.0, 2.0 * pi), c = cos(at), s = sin(at);
        double angle[DIRECTIONS], expected[DIRECTIONS][2];
        for (int n = 0; n < DIRECTIONS; n++) angle[n] = uniform(seed, 0.0, 2.0 * pi);
        reynolds(e, r, DIRECTIONS, angle, expected);
        for (int n = 0; n < DIRECTIONS; n++) {
            double f[2];
            film_force(rotor, r, e * c, e * s, cos(angle[n] + at), sin(angle[n] + at), f);
            const double fx = c * expected[n][0] - s * expected[n][1], fy = s * expected[n][0] + c * expected[n][1];
            worst[near] = fmax(worst[near], hypot(f[0] - fx, f[1] - fy) / hypot(fx, fy));
        }
    }
    whirl_rotor_free(rotor);
}

static void force_is_that_of_reynolds(void **unused) {
    (void)unused;
    static const double lengths[] = {0.1, 0.17, 0.25, 0.5, 0.7, 1.0, 1.4, 2.0};
    uint64_t seed = 20270301u;
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        double worst[2] = {0.0, 0.0};
        compare(lengths[i], &seed, worst);
        check_within("F1", words("L/D %.2f: force at 216 random states to e = .9, relative error", lengths[i]), 0.0,
                     worst[0], 2e-4);
        check_within("F1", words("L/D %.2f: force at 72 random states with e = .9 to .95, relative error", lengths[i]),
                     0.0, worst[1], 1e-3);
    }
}

static void debug(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make_film(0.5, 1.0, NULL, 0);
    double f[2], g[2][2], a[2] = {0.0, 1.0};
    reynolds(0.6, 0.5, 2, a, g);
    film_force(rotor, 0.5, 0.6, 0.0, 1.0, 0.0, f);
    print_message("%g %g | %.9f %.9f\n", f[0]*.6, f[1]*.6, g[0][0]*.6, g[0][1]*.6);
    film_force(rotor, 0.5, 0.6, 0.0, cos(1.0), sin(1.0), f);
    print_message("%g %g | %g %g\n", f[0], f[1], g[1][0], g[1][1]);
    film_force(rotor, 0.5, 0.0, 0.6, -sin(1.0), cos(1.0), f);
    print_message("%g %g | %g %g\n", f[0], f[1], g[1][0], g[1][1]);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(debug), cmocka_unit_test(force_is_that_of_reynolds)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
