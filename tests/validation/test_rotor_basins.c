// Coexisting motions of the paper's rotor: the shares of starts that lead to each, against brute force of independently
// written equations (bench/equations.h has the film), by plain RK4.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "equations.h"
#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/case.h"

enum {
    N = 8,
    COARSE = 512,
    FINE = 1024,
    SETTLE = 800,
    LONG = 3000,
    WATCH = 28,
    MAX_ATTRACTORS = 8,
    SOME = 9,
    MORE = 21
};

static const double pi = 3.14159265358979323846, width = 1.1;

// ---------------------------------------------------------------- brute force

/// Computes the slope in the calibrated reading: load coefficient 0.0042, gravity 10.584 m/s2 over c omega^2.
static void slope(double r_k, const double *turn, const double *z, double *dz) {
    const double c = turn[0], s = turn[1], c2 = c * c - s * s, s2 = 2.0 * s * c;
    const double load = 0.0042, gravity = 10.584 / (0.2e-3 * 650.0 * 650.0);
    const double a = r_k + 1.0, b = r_k - 1.0, dx = z[0] - z[2], dy = z[1] - z[3];
    const double sx = (a + b * c2) * dx + b * s2 * dy;
    const double sy = (a + b * c2) * dy + b * s2 * dx; // as the paper prints it
    const double push = ROTOR_PUSH * fmax(1.0 - rotor_r_delta / sqrt(z[0] * z[0] + z[1] * z[1]), 0.0);
    double px, py;
    equations_film(z[2], z[3], z[6], z[7], &px, &py);
    memcpy(dz, z + 4, 4 * sizeof *dz);
    dz[4] = -rotor_xi1 * z[4] - ROTOR_K1 * sx + rotor_rho * c - push * (z[0] - rotor_f * z[1]);
    dz[5] = -rotor_xi1 * z[5] - ROTOR_K1 * sy + rotor_rho * s - push * (z[1] + rotor_f * z[0]) - gravity;
    dz[6] = -0.5 * rotor_xi2 * z[6] + ROTOR_K2 * sx + load * px;
    dz[7] = -0.5 * rotor_xi2 * z[7] + ROTOR_K2 * sy + load * py - gravity;
}

/// Cosine and sine of every half of the shortest step.
static double turns[2 * FINE + 1][2];

static int tabulate(void **state) {
    (void)state;
    for (int i = 0; i <= 2 * FINE; i++) {
        turns[i][0] = cos(pi * i / FINE);
        turns[i][1] = sin(pi * i / FINE);
    }
    return 0;
}

/// Carries z over one revolution by RK4 in `steps` steps; returns the disc's largest radius.
static double revolve(double r_k, double *z, int steps) {
    const double h = 2.0 * pi / steps;
    const int half = FINE / steps;
    double k[4][N], y[N], largest = 0.0;
    for (int n = 0; n < steps; n++) {
        slope(r_k, turns[2 * n * half], z, k[0]);
        for (int s = 1; s < 4; s++) {
            const double part = s < 3 ? 0.5 * h : h;
            for (int i = 0; i < N; i++) y[i] = z[i] + part * k[s - 1][i];
            slope(r_k, turns[(2 * n + (s < 3 ? 1 : 2)) * half], y, k[s]);
        }
        for (int i = 0; i < N; i++) z[i] += h / 6.0 * (k[0][i] + 2.0 * k[1][i] + 2.0 * k[2][i] + k[3][i]);
        largest = fmax(largest, z[0] * z[0] + z[1] * z[1]);
    }
    return sqrt(largest);
}

/// Returns the disc's largest radius in 28 revolutions (whole orbits of 1, 4 and 7), after a transient.
static double radius_after(double r_k, double *z, int steps, int revolutions) {
    double largest = 0.0;
    for (int n = 0; n < revolutions; n++) revolve(r_k, z, steps);
    for (int n = 0; n < WATCH; n++) largest = fmax(largest, revolve(r_k, z, steps));
    return largest;
}

// ---------------------------------------------------------------- the library

/// The starts x0, y0 of the disc: a grid of `side` x `side` points.
typedef struct grid {
    size_t side, count;
    double *x, *y;
} grid;

static grid make_grid(void) {
    const size_t side = getenv("WHIRL_SOAK") ? MORE : SOME;
    grid g = {side, side * side, malloc(side * side * sizeof(double)), malloc(side * side * sizeof(double))};
    assert_true(g.x && g.y);
    for (size_t i = 0; i < g.count; i++) {
        g.x[i] = width * (2.0 * (double)(i % side) / (double)(side - 1) - 1.0);
        g.y[i] = width * (2.0 * (double)(i / side) / (double)(side - 1) - 1.0);
    }
    return g;
}

static void free_grid(grid *g) {
    free(g->x);
    free(g->y);
}

/// Computes the basin of cases/paper-basin.yaml at another ratio of stiffness and on the grid's starts.
static whirl_result *run(double r_k, const grid *g) {
    whirl_case *object;
    whirl_study study;
    whirl_result *result;
    const whirl_run_options options = {.threads = 2};
    require_ok(whirl_case_load(WHIRL_CASES "/paper-basin.yaml", NULL, &object));
    require_ok(whirl_case_set(object, words("r_k=%.17g", r_k)));
    require_ok(whirl_case_study(object, &study));
    whirl_batch *batch = &study.batches[0];
    batch->count = g->count;
    batch->row = g->side;
    batch->values = g->x;
    batch->second_values = g->y;
    require_ok(whirl_study_run(&study, &options, &result));
    whirl_case_free(object);
    return result;
}

/// Computes the last state of a point.
static void end_of(const whirl_table *table, size_t point, double *z) {
    const whirl_field *field = whirl_layout_field(&table->layout, "poincare/section");
    assert_non_null(field);
    for (size_t s = 0; s < 2; s++) {
        const double *last = whirl_table_field(table, point, "poincare/section", s) + 4 * (field->rows - 1);
        memcpy(z + 2 * s, last, 2 * sizeof *z);
        memcpy(z + 4 + 2 * s, last + 2, 2 * sizeof *z);
    }
}

// ---------------------------------------------------------------- tests

/// Motions of a ratio of stiffness.
typedef struct expected {
    double r_k;
    const char *what;
    int periods[2]; ///< of the two that most starts lead to
} expected;

/// Checks that brute force stays on a found orbit, and returns to it after a perturbation.
static void check_orbit(const expected *at, const whirl_table *table, const whirl_attractor *found) {
    double z[N], first[N], away = 0.0;
    const int period = whirl_table_verdict(table, found->first).period;
    const double radius = table_number(table, found->first, "orbit/max_radius", 0);
    end_of(table, found->first, z);
    z[0] += 1e-4;
    const double again = radius_after(at->r_k, z, FINE, LONG);
    check_within("rotor-basins", words("%s: P-%d, brute force displaced by 1e-4: largest radius", at->what, period),
                 radius, again, 1e-4);
    memcpy(first, z, sizeof first);
    for (int n = 0; n < period; n++) revolve(at->r_k, z, FINE);
    for (size_t i = 0; i < N; i++) away = fmax(away, fabs(z[i] - first[i]));
    check_within("rotor-basins", words("... after %d revolutions it is back", period), 0.0, away, 1e-3);
}

/// Returns the number, from 1, of the attractor with the nearest radius; 0 if none is as near as slow motions have
/// come.
static size_t nearest_of(const double *radii, size_t count, double radius) {
    size_t nearest = 0;
    for (size_t k = 1; k < count; k++)
        if (fabs(radii[k] - radius) < fabs(radii[nearest] - radius)) nearest = k;
    return fabs(radii[nearest] - radius) < 5e-4 ? nearest + 1 : 0;
}

/// Checks that the shares of the two main motions are those of brute force.
static void check_shares(const expected *at, const whirl_table *table, const whirl_attractor *found, size_t attractors,
                         const grid *g) {
    double radii[MAX_ATTRACTORS];
    size_t reached[MAX_ATTRACTORS + 1] = {0};
    for (size_t k = 0; k < attractors; k++) radii[k] = table_number(table, found[k].first, "orbit/max_radius", 0);
    for (size_t i = 0; i < g->count; i++) {
        double z[N] = {g->x[i], g->y[i], [7] = -1e-12}; // the film's angle wants a journal that moves
        reached[nearest_of(radii, attractors, radius_after(at->r_k, z, COARSE, SETTLE))]++;
    }
    for (size_t k = 0; k < 2; k++) {
        const double share = (double)reached[k + 1] / (double)g->count;
        check_within("rotor-basins", words("%s: share of the %s motion, brute force", at->what, k ? "other" : "main"),
                     share, found[k].share,
                     2.0 * hypot(found[k].error, sqrt(share * (1.0 - share) / (double)g->count)));
    }
    check_within("rotor-basins", words("... starts of brute force that lead to none of those found"), 0.0,
                 (double)reached[0], 2.0);
}

static void basins_agree_with_brute_force(void **state) {
    static const expected values[] = {
        {0.58, "r_k = .58", {1, 7}}, {0.493, "r_k = .493", {5, 5}}, {0.300123, "r_k = .300123", {4, 4}}};
    grid g = make_grid();
    (void)state;
    for (size_t v = 0; v < sizeof values / sizeof *values; v++) {
        whirl_attractor found[MAX_ATTRACTORS];
        size_t attractors;
        whirl_result *result = run(values[v].r_k, &g);
        const whirl_table *table = &result->tables[0];
        require_ok(whirl_table_attractors(table, NULL, found, MAX_ATTRACTORS, &attractors));
        assert_in_range(attractors, 2, MAX_ATTRACTORS);
        for (size_t k = 0; k < 2; k++)
            assert_int_equal(values[v].periods[k], whirl_table_verdict(table, found[k].first).period);
        for (size_t k = 0; k < attractors; k++) check_orbit(&values[v], table, &found[k]);
        check_shares(&values[v], table, found, attractors, &g);
        whirl_result_free(result);
    }
    free_grid(&g);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(basins_agree_with_brute_force)};
    return cmocka_run_group_tests(tests, tabulate, NULL);
}
