// Films of finite length, compared with an independent solution of Reynolds' equation: in housings that move, between
// surfaces that both turn.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/rotor.h"

static const double pi = 3.14159265358979323846;

static double uniform(uint64_t *seed, double low, double high) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

// ---------------------------------------------------------------- finite volumes around, a cosine series along

enum { MAX_CELLS = 640, MODES = 10, POINTS = 10 };

/// Pressures at the cells from t = 0 to pi of one mode along the axis: that by A, odd in t, and that by B, even.
/// (h^3 p')' - (k/r)^2 h^3 p = s, h = 1 - e cos t, r = L/D, by elimination; less those of a short film, -(r/k)^2 s/h^3,
/// so that few modes are enough.
static void solve_mode(double e, double r, double k, size_t cells, double odd[], double even[]) {
    const double dt = pi / (double)cells;
    double *const by[2] = {odd, even}, share[MAX_CELLS];
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
    static double odd[POINTS][MAX_CELLS], even[POINTS][MAX_CELLS];
    double p[MAX_CELLS], q[MAX_CELLS];
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

/// Computes the same forces, extrapolated from two grids.
static void reynolds(double e, double r, size_t count, const double *angle, double f[][2]) {
    enum { MAX_PLACES = 16 };
    double coarse[MAX_PLACES][2];
    assert_true(count <= MAX_PLACES);
    forces_on_grid(e, r, 320, count, angle, coarse);
    forces_on_grid(e, r, 640, count, angle, f);
    for (size_t n = 0; n < count; n++)
        for (int i = 0; i < 2; i++) f[n][i] += (f[n][i] - coarse[n][i]) / 3.0;
}

// ---------------------------------------------------------------- whirl's

/// Makes a journal of mass 1 in a film of clearance, viscosity and radius 1 at speed 1: accelerations are forces in mu
/// omega R^3 L/c^2, over the length.
static whirl_rotor *make_film(double r, double speed, const whirl_setting *more, size_t count) {
    whirl_setting film[12] = {{"at", 0.0, "journal"}, {"clearance", 1.0, NULL},  {"viscosity", 1.0, NULL},
                              {"radius", 1.0, NULL},  {"length", 2.0 * r, NULL}, {"law", 0.0, "finite"}};
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

/// Computes the force on the journal at (x, y) for A and B.
static void film_force(const whirl_rotor *rotor, double r, double x, double y, double A, double B, double f[2]) {
    const double state[8] = {x, y, 0.0, 0.0, 0.5 * (B - y), 0.5 * (x - A), 0.0, 0.0};
    double slope[8];
    evaluate_rhs(whirl_rotor_system(rotor), 0.0, state, slope);
    for (int i = 0; i < 2; i++) f[i] = slope[4 + i] / (2.0 * r);
}

/// Computes the largest error over the force in random states, where e is up to .9 and up to .95.
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
    static const double lengths[] = {0.1, 0.14, 0.17, 0.25, 0.5, 0.6, 0.7, 1.0, 1.4, 2.0};
    uint64_t seed = 20270301u;
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        double worst[2] = {0.0, 0.0};
        compare(lengths[i], &seed, worst);
        check_within("film-reynolds",
                     words("L/D %.2f: force at 216 random states to e = .9, relative error", lengths[i]), 0.0, worst[0],
                     2e-4);
        check_within("film-reynolds",
                     words("L/D %.2f: force at 72 random states with e = .9 to .95, relative error", lengths[i]), 0.0,
                     worst[1], 1e-3);
    }
}

/// At rest at (e, 0) by the Galerkin solution of scripts/film-table.py with 14 modes along and 192 around: f in
/// mu omega R L (R/c)^2, K in that over c, C in that over c omega.
static const struct {
    double r, e, f[2], k[4], c[4];
} rows[] = {{0.5,
             0.2,
             {-0.033360770, 0.150081031},
             {0.35641842, 0.75040515, -0.82623869, 0.16680385},
             {1.6797454, -0.3336077, -0.418601, 1.5008103}},
            {0.5,
             0.6,
             {-0.576217090, 0.727142894},
             {3.6211698, 1.2119048, -2.781099, 0.96036182},
             {6.2757882, -1.9207236, -2.5237522, 2.4238096}},
            {0.5,
             0.8,
             {-2.463260156, 1.830831741},
             {22.317067, 2.2885397, -10.900505, 3.0790752},
             {26.84685, -6.1581504, -8.5551782, 4.5770794}},
            {1.0,
             0.6,
             {-1.255800455, 1.936351687},
             {7.1026459, 3.2272528, -6.1047394, 2.0930008},
             {15.308481, -4.1860015, -6.8211194, 6.4545056}}};

static void coefficients_at_rest(void **unused) {
    (void)unused;
    static const char *const names[] = {"XX", "XY", "YX", "YY"};
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        whirl_rotor *rotor = make_film(rows[n].r, 1.0, NULL, 0);
        const double state[8] = {rows[n].e}, over = 1.0 / (2.0 * rows[n].r);
        double slope[8], matrix[64], largest[2] = {0.0, 0.0}, f[2];
        evaluate_rhs(whirl_rotor_system(rotor), 0.0, state, slope);
        exact_jacobian(whirl_rotor_system(rotor), 0.0, state, matrix);
        reynolds(rows[n].e, rows[n].r, 1, (double[]){0.0}, (double(*)[2])f);
        char at[64];
        snprintf(at, sizeof at, "L/D %g, e %g", rows[n].r, rows[n].e);
        for (int i = 0; i < 2; i++) {
            const double size = hypot(rows[n].f[0], rows[n].f[1]);
            check_within("film-rest", words("%s: f%s", at, i ? "Y" : "X"), rows[n].f[i], slope[4 + i] * over,
                         5e-5 * size);
            check_within("film-rest", words("%s: f%s by finite volumes", at, i ? "Y" : "X"), rows[n].f[i],
                         rows[n].e * f[i], 5e-7 * size);
        }
        for (int i = 0; i < 4; i++) {
            largest[0] = fmax(largest[0], fabs(rows[n].k[i]));
            largest[1] = fmax(largest[1], fabs(rows[n].c[i]));
        }
        for (int i = 0; i < 8; i++) {
            const double *const expected = i < 4 ? rows[n].k : rows[n].c;
            const size_t at_row = 8 * (4 + (size_t)(i % 4) / 2) + (size_t)(i % 2) + (i < 4 ? 0 : 4);
            check_within("film-rest", words("%s: %s%s", at, i < 4 ? "K" : "C", names[i % 4]), expected[i % 4],
                         -matrix[at_row] * over, 1e-4 * largest[i / 4]);
        }
        whirl_rotor_free(rotor);
    }
}

/// Returns the largest difference of the exact Jacobian from central differences, over the largest entry of a row, and
/// of the divergence from the trace.
static double worst_of_jacobian(const whirl_rotor *rotor, uint64_t *seed) {
    const whirl_system *system = whirl_rotor_system(rotor);
    double worst = 0.0;
    for (int trial = 0; trial < 40; trial++) {
        const double e = trial % 4 ? uniform(seed, 0.05, 0.93) : uniform(seed, 0.951, 0.97);
        const double at = uniform(seed, 0.0, 2.0 * pi);
        double state[8], exact[64], differences[64];
        for (int i = 0; i < 8; i++) state[i] = uniform(seed, -0.4, 0.4);
        state[0] = state[2] + e * cos(at);
        state[1] = state[3] + e * sin(at);
        exact_jacobian(system, 0.0, state, exact);
        rhs_jacobian(system, 0.0, state, 2e-3 * (1.0 - e), differences);
        for (int i = 4; i < 8; i++) {
            double largest = 0.0;
            for (int j = 0; j < 8; j++) largest = fmax(largest, fabs(exact[8 * i + j]));
            for (int j = 0; j < 8 && largest > 0.0; j++)
                worst = fmax(worst, fabs(exact[8 * i + j] - differences[8 * i + j]) / largest);
        }
        double trace = 0.0;
        for (int i = 0; i < 8; i++) trace += exact[9 * i];
        const double sum = system->divergence(system->model, 0.0, (double[16]){1.0}, state, NULL);
        worst = fmax(worst, fabs(sum - trace) / fabs(trace));
    }
    return worst;
}

static const whirl_setting moved[] = {
    {"from", 0.0, "housing"}, {"journal_ratio", 0.7, NULL}, {"housing_ratio", -0.2, NULL}};

static void derivatives_are_exact(void **unused) {
    (void)unused;
    static const double speeds[] = {1.0, -1.0};
    uint64_t seed = 11u;
    for (int i = 0; i < 2; i++)
        for (size_t count = 0; count <= 3; count += 3) {
            whirl_rotor *rotor = make_film(0.6, speeds[i], moved, count);
            check_within("film-derivatives",
                         words("turning %s, %s: exact Jacobian and divergence from differences",
                               i ? "clockwise" : "counter-clockwise",
                               count ? "in a housing that moves and turns" : "on the ground"),
                         0.0, worst_of_jacobian(rotor, &seed), 1e-8);
            whirl_rotor_free(rotor);
        }
    whirl_setting law[4];
    memcpy(law, moved, sizeof moved);
    law[3] = (whirl_setting){"law", 0.0, "capone"};
    whirl_design *design;
    whirl_rotor *rotor;
    const whirl_setting mass = {"mass", 1.0, NULL};
    const whirl_setting film[] = {{"at", 0.0, "journal"}, moved[0], moved[1], moved[2], {"clearance", 1.0, NULL},
                                  {"load", 1.0, NULL},    law[3]};
    require_ok(whirl_design_new(1.0, 1.0, &design));
    require_ok(whirl_design_station(design, "journal", &mass, 1));
    require_ok(whirl_design_station(design, "housing", &mass, 1));
    require_ok(whirl_design_element(design, "film", film, 7));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    check_within("film-derivatives",
                 "short, in a housing that moves and turns: exact Jacobian and divergence from differences", 0.0,
                 worst_of_jacobian(rotor, &seed), 1e-8);
    whirl_rotor_free(rotor);
}

/// In its housing's frame a film does what it does on the ground; in half the wedge, at half the velocity, half of it;
/// in the mirror what its mirror image does.
static void frames(void **unused) {
    (void)unused;
    const double s[8] = {0.35, -0.4, 0.1, 0.2, 0.3, 0.15, -0.2, 0.1};
    const double alone[8] = {0.25, -0.6, 0.0, 0.0, 0.5, 0.05}, half[8] = {0.25, -0.6, 0.0, 0.0, 1.0, 0.1};
    const double image[8] = {0.25, 0.6, 0.0, 0.0, 0.5, -0.05};
    double ground[8], housed[8], halved[8], mirrored[8];
    whirl_rotor *rotors[] = {make_film(0.8, 1.0, NULL, 0), make_film(0.8, 1.0, moved, 1), make_film(0.8, 1.0, moved, 3),
                             make_film(0.8, -1.0, NULL, 0)};
    evaluate_rhs(whirl_rotor_system(rotors[0]), 0.0, alone, ground);
    evaluate_rhs(whirl_rotor_system(rotors[1]), 0.0, s, housed);
    for (int i = 0; i < 2; i++) {
        const char *const axis = i ? "y" : "x";
        check_within("film-frames", words("f%s in a housing that moves", axis), ground[4 + i], housed[4 + i], 1e-14);
        check_within("film-frames", words("f%s on that housing", axis), -ground[4 + i], housed[6 + i], 1e-14);
    }
    evaluate_rhs(whirl_rotor_system(rotors[0]), 0.0, half, ground);
    evaluate_rhs(whirl_rotor_system(rotors[2]), 0.0, s, halved);
    for (int i = 0; i < 2; i++)
        check_within("film-frames", words("f%s with journal and housing at .7 and -.2 of the speed", i ? "y" : "x"),
                     0.5 * ground[4 + i], halved[4 + i], 1e-14);
    evaluate_rhs(whirl_rotor_system(rotors[0]), 0.0, alone, ground);
    evaluate_rhs(whirl_rotor_system(rotors[3]), 0.0, image, mirrored);
    for (int i = 0; i < 2; i++)
        check_within("film-frames", words("f%s of the mirror image", i ? "y" : "x"), i ? -ground[5] : ground[4],
                     mirrored[4 + i], 1e-14);
    for (int i = 0; i < 4; i++) whirl_rotor_free(rotors[i]);
}

/// Beyond what the fit is for the force stays between nothing and the short film's, in much its direction, without
/// jumps in value or slope.
static void near_the_wall(void **unused) {
    (void)unused;
    static const double lengths[] = {0.1, 0.3, 1.0, 2.0};
    double largest = 0.0, least = 1.0, kink = 0.0;
    for (int n = 0; n < 4; n++) {
        whirl_rotor *rotor = make_film(lengths[n], 1.0, NULL, 0);
        const whirl_system *system = whirl_rotor_system(rotor);
        for (int direction = 0; direction < 32; direction++) {
            const double a = 2.0 * pi * direction / 32.0, A = cos(a), B = sin(a);
            for (double w = 0.35; w > 0.01; w -= 0.005) {
                const double e = sqrt(1.0 - w * w), share = 4.0 * lengths[n] * lengths[n];
                double f[2], s[2];
                film_force(rotor, lengths[n], e, 0.0, A, B, f);
                whirl_film_force(e, 0.0, 0.5 * B, 0.5 * (e - A), s);
                const double over = 4.0 / share / (s[0] * s[0] + s[1] * s[1]);
                largest = fmax(largest, hypot(f[0], f[1]) * 4.0 / share / hypot(s[0], s[1]));
                least = fmin(least, (f[0] * s[0] + f[1] * s[1]) * over);
            }
            double before[64], after[64];
            const double e = 0.95, state[8] = {e - 1e-9, 0.0, 0.0, 0.0, 0.5 * B, 0.5 * (e - A)};
            const double beyond[8] = {e + 1e-9, 0.0, 0.0, 0.0, 0.5 * B, 0.5 * (e - A)};
            exact_jacobian(system, 0.0, state, before);
            exact_jacobian(system, 0.0, beyond, after);
            for (int i = 32; i < 48; i++) kink = fmax(kink, fabs(after[i] - before[i]) / (1.0 + fabs(before[i])));
        }
        whirl_rotor_free(rotor);
    }
    check_within("film-wall", "force over the short film's, e = .94 to .99995, L/D .1 to 2: largest", 1.0, largest,
                 0.02);
    check_holds("film-wall", words("its part along the short film's is positive, at least %.1g", least), least > 0.0);
    check_within("film-wall", "jump of the derivative where the fit ends, e = .95", 0.0, kink, 1e-5);
}

/// Lanes of different lengths have the bits of lanes of equal lengths, whose coefficients are read in another way.
static void lanes_of_different_lengths(void **unused) {
    (void)unused;
    enum { LANES = 8 };
    whirl_integrate_options options = whirl_integrate_default();
    snprintf(options.method, sizeof options.method, "rk4");
    options.steps_per_revolution = 256;
    bool same = true;
    double mixed[LANES][8], alone[8];
    whirl_rotor *rotors[LANES];
    for (int alike = 0; alike <= LANES; alike++) { // all of one length, then all different
        whirl_ensemble *lanes;
        for (int i = 0; i < LANES; i++) rotors[i] = make_film(0.2 + 0.2 * (alike < LANES ? alike : i), 1.0, moved, 1);
        require_ok(whirl_ensemble_new(whirl_rotor_system(rotors[0]), &options, LANES, &lanes));
        for (size_t i = 0; i < LANES; i++)
            require_ok(whirl_ensemble_load(lanes, i, whirl_rotor_system(rotors[i]), (double[8]){0.3, -0.4, 0.1}));
        for (int i = 0; i < 5; i++) whirl_ensemble_revolve(lanes, LANES, NULL);
        whirl_ensemble_state(lanes, 0, alone);
        if (alike < LANES) memcpy(mixed[alike], alone, sizeof alone);
        for (size_t i = 0; alike == LANES && i < LANES; i++) {
            whirl_ensemble_state(lanes, i, alone);
            same = same && memcmp(alone, mixed[i], sizeof alone) == 0;
        }
        whirl_ensemble_free(lanes);
        for (int i = 0; i < LANES; i++) whirl_rotor_free(rotors[i]);
    }
    check_holds("film-lanes", "lanes of eight lengths have the bits of lanes of one", same);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(force_is_that_of_reynolds),
                                       cmocka_unit_test(coefficients_at_rest),
                                       cmocka_unit_test(derivatives_are_exact),
                                       cmocka_unit_test(frames),
                                       cmocka_unit_test(near_the_wall),
                                       cmocka_unit_test(lanes_of_different_lengths)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
