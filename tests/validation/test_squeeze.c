// Squeeze film dampers: circular orbits, any motion, the derivative, and a rotor on one.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/rotor.h"

typedef long double complex number;

static const long double pi = 3.14159265358979323846264L;

/// The four dampers.
static const struct law {
    const char *name, *law, *film;
    bool is_long, is_full;
} laws[4] = {{"short, half film", "short", "half", false, false},
             {"short, full film", "short", "full", false, true},
             {"long, half film", "long", "half", true, false},
             {"long, full film", "long", "full", true, true}};

static double uniform(uint64_t *seed, double low, double high) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

/// Makes a damper of clearance, viscosity, radius and length 1 between two masses of 1 at speed 1, so that
/// accelerations are forces over mu omega R L^3/c^2.
static whirl_rotor *make_damper(const struct law *law) {
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(1.0, 1.0, &design));
    require_ok(whirl_design_station(design, "journal", (whirl_setting[]){{"mass", 1.0, NULL}}, 1));
    require_ok(whirl_design_station(design, "housing", (whirl_setting[]){{"mass", 1.0, NULL}}, 1));
    const whirl_setting damper[] = {{"at", 0.0, "journal"},   {"from", 0.0, "housing"}, {"law", 0.0, law->law},
                                    {"film", 0.0, law->film}, {"clearance", 1.0, NULL}, {"viscosity", 1.0, NULL},
                                    {"radius", 1.0, NULL},    {"length", 1.0, NULL}};
    require_ok(whirl_design_element(design, "squeeze", damper, 8));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Computes the force at (x, y, x', y') of the journal from a housing that also moves, over 12 for long dampers.
static void damper_force(const whirl_rotor *rotor, bool is_long, const double s[4], double force[2]) {
    static const double moved[4] = {0.25, -0.5, 0.125, 0.375};
    const double state[8] = {s[0] + moved[0], s[1] + moved[1], moved[0], moved[1],
                             s[2] + moved[2], s[3] + moved[3], moved[2], moved[3]};
    double slope[8];
    evaluate_rhs(whirl_rotor_system(rotor), 0.0, state, slope);
    for (int i = 0; i < 2; i++) {
        force[i] = slope[4 + i] / (is_long ? 12.0 : 1.0);
        // The force on the housing is the opposite.
        assert_true(slope[6 + i] == -slope[4 + i]);
    }
}

// ---------------------------------------------------------------- circular centred orbits

/// Computes the radial (inward) and tangential force on a circular centred orbit, in closed form.
static void circular_force(const struct law *law, double e, double force[2]) {
    const double q = 1.0 - e * e, ring = 2.0 + e * e;
    const double radial = law->is_long ? 2.0 * e * e / (ring * q) : 2.0 * e * e / (q * q);
    const double tangential = law->is_long ? (double)pi * e / (ring * sqrt(q)) : (double)pi * e / (2.0 * pow(q, 1.5));
    force[0] = law->is_full ? 0.0 : radial;
    force[1] = law->is_full ? 2.0 * tangential : tangential;
}

static void circular_orbits(void **unused) {
    (void)unused;
    static const char *const digits[4][2] = {{"0.888888888889", "1.209199576156"},
                                             {"0.000000000000", "2.418399152312"},
                                             {"0.296296296296", "0.806133050771"},
                                             {"0.000000000000", "1.612266101542"}};
    for (int k = 0; k < 4; k++) {
        whirl_rotor *rotor = make_damper(&laws[k]);
        double worst = 0.0, force[2], expected[2];
        damper_force(rotor, laws[k].is_long, (double[]){0.5, 0.0, 0.0, 0.5}, force);
        check_digits("squeeze-orbit", words("%s, e = .5: radial force", laws[k].name), digits[k][0], fabs(-force[0]));
        check_digits("squeeze-orbit", words("%s, e = .5: tangential force", laws[k].name), digits[k][1], -force[1]);
        for (int i = 1; i <= 99; i++) {
            const double e = 0.01 * i, turn = 0.7 * i, c = cos(turn), s = sin(turn);
            circular_force(&laws[k], e, expected);
            damper_force(rotor, laws[k].is_long, (double[]){e * c, e * s, -e * s, e * c}, force);
            const double radial = -(force[0] * c + force[1] * s), tangential = force[0] * s - force[1] * c;
            worst =
                fmax(worst, hypot(radial - expected[0], tangential - expected[1]) / hypot(expected[0], expected[1]));
        }
        check_within("squeeze-orbit", words("%s, e = .01 to .99: largest relative difference", laws[k].name), 0.0,
                     worst, 1e-13);
        whirl_rotor_free(rotor);
    }
}

/// mu omega R L^3/c^2 and 12 mu omega L R^3/c^2, twice, in the units of a machine.
static void force_in_newtons(void **unused) {
    (void)unused;
    const double speed = 600.0, mass = 3.0, scale = 3e-4, c = 1e-4, mu = 4e-3, radius = 0.05, length = 0.02, e = 0.5;
    for (int k = 0; k < 4; k += 2) {
        whirl_design *design;
        whirl_rotor *rotor;
        double slope[4], expected[2];
        require_ok(whirl_design_new(speed, scale, &design));
        require_ok(whirl_design_station(design, "journal", (whirl_setting[]){{"mass", mass, NULL}}, 1));
        const whirl_setting damper[] = {{"at", 0.0, "journal"},  {"law", 0.0, laws[k].law}, {"clearance", c, NULL},
                                        {"viscosity", mu, NULL}, {"radius", radius, NULL},  {"length", length, NULL},
                                        {"count", 2.0, NULL}};
        require_ok(whirl_design_element(design, "squeeze", damper, 7));
        require_ok(whirl_rotor_new(design, &rotor));
        const whirl_system *system = whirl_rotor_system(rotor);
        evaluate_rhs(system, 0.0, (double[]){e * c / scale, 0.0, 0.0, e * c / scale}, slope);
        circular_force(&laws[k], e, expected);
        const double shape = laws[k].is_long ? 12.0 * length * pow(radius, 3.0) : radius * pow(length, 3.0);
        const double newtons = 2.0 * mu * speed * shape / (c * c);
        check_within("squeeze-orbit", words("%s, two dampers in SI: tangential force, N", laws[k].name),
                     newtons * expected[1], -slope[3] * mass * speed * speed * scale, 1e-12 * newtons);
        // The clearance is that around the station.
        assert_true(fabs(system->probes[0].clearance - c / scale) < 1e-15);
        whirl_rotor_free(rotor);
    }
}

// ---------------------------------------------------------------- any motion

/// Gauss's rule of eight points on `panels` panels: the integral of f over (from, to), both parts.
typedef void (*integrand)(const double *s, long double constant, long double phi, long double value[2]);
static void integrate(integrand f, const double *s, long double constant, long double from, long double to, int panels,
                      long double sum[2]) {
    static const long double nodes[4] = {0.183434642495649804939L, 0.525532409916328985818L, 0.796666477413626739592L,
                                         0.960289856497536231684L};
    static const long double weights[4] = {0.362683783378361982965L, 0.313706645877887287338L, 0.222381034453374470544L,
                                           0.101228536290376259153L};
    const long double half = 0.5L * (to - from) / panels;
    sum[0] = sum[1] = 0.0L;
    for (int panel = 0; panel < panels; panel++)
        for (int k = 0; k < 8; k++) {
            long double value[2];
            const long double place = 2 * panel + 1 + (k < 4 ? nodes[k] : -nodes[k - 4]);
            f(s, constant, from + half * place, value);
            for (int i = 0; i < 2; i++) sum[i] += half * weights[k % 4] * value[i];
        }
}

static long double thickness(const double *s, long double phi) {
    return 1.0L - s[0] * cosl(phi) - s[1] * sinl(phi);
}

/// Computes the short damper's pressure along (cos, sin).
static void short_pressure(const double *s, long double constant, long double phi, long double value[2]) {
    const long double h = thickness(s, phi), pressure = (s[2] * cosl(phi) + s[3] * sinl(phi)) / (h * h * h);
    (void)constant;
    value[0] = pressure * cosl(phi);
    value[1] = pressure * sinl(phi);
}

static void short_force(const struct law *law, const double *s, double force[2]) {
    const long double middle = atan2l(s[3], s[2]), reach = law->is_full ? pi : 0.5L * pi;
    long double sum[2];
    integrate(short_pressure, s, 0.0L, middle - reach, middle + reach, 200, sum);
    for (int i = 0; i < 2; i++) force[i] = (double)-sum[i];
}

/// Computes the slope of the long damper's pressure: h^3 dp/dphi is the integral of dh/dt and a constant. Also writes
/// 1/h^3.
static void long_slope(const double *s, long double constant, long double phi, long double value[2]) {
    const long double h = thickness(s, phi);
    value[0] = (s[3] * cosl(phi) - s[2] * sinl(phi) + constant) / (h * h * h);
    value[1] = 1.0L / (h * h * h);
}

/// Computes the slope along (-sin, cos). Its integral is that of the pressure along (cos, sin), by parts, if the
/// pressure vanishes at both ends.
static void long_push(const double *s, long double constant, long double phi, long double value[2]) {
    long double slope[2];
    long_slope(s, constant, phi, slope);
    value[0] = -sinl(phi) * slope[0];
    value[1] = cosl(phi) * slope[0];
}

/// Solves Reynolds' equation on the circumference by quadrature; the constant follows from equal pressures after one
/// turn. The half film begins where the pressure is that of the opposite side, found by halving.
static void long_force(const struct law *law, const double *s, double force[2]) {
    long double sum[2], opposite[2], constant;
    integrate(long_slope, s, 0.0L, 0.0L, 2.0L * pi, 200, sum);
    constant = -sum[0] / sum[1];
    long double from = 0.0L, to = pi;
    integrate(long_slope, s, constant, from, from + pi, 100, opposite);
    const bool rises = opposite[0] > 0.0L;
    for (int i = 0; i < 70; i++) {
        const long double middle = 0.5L * (from + to);
        integrate(long_slope, s, constant, middle, middle + pi, 100, sum);
        if ((sum[0] > 0.0L) == rises)
            from = middle;
        else
            to = middle;
    }
    long double slope[2];
    long_slope(s, constant, from, slope);
    // The pressure is above that of both ends where it rises from the first.
    if (slope[0] < 0.0L) from += pi;
    integrate(long_push, s, constant, from, from + (law->is_full ? 2.0L : 1.0L) * pi, 200, sum);
    for (int i = 0; i < 2; i++) force[i] = (double)-sum[i];
}

static void draw(uint64_t *seed, double most, double s[4]) {
    const double e = most * sqrt(uniform(seed, 0.0, 1.0)), angle = uniform(seed, 0.0, 6.28);
    s[0] = e * cos(angle);
    s[1] = e * sin(angle);
    s[2] = uniform(seed, -1.0, 1.0);
    s[3] = uniform(seed, -1.0, 1.0);
}

static void any_motion(void **unused) {
    (void)unused;
    for (int k = 0; k < 4; k++) {
        whirl_rotor *rotor = make_damper(&laws[k]);
        uint64_t seed = 1923;
        double worst = 0.0;
        for (int trial = 0; trial < (laws[k].is_long ? 50 : 500); trial++) {
            double s[4], expected[2], obtained[2];
            draw(&seed, 0.9, s);
            (laws[k].is_long ? long_force : short_force)(&laws[k], s, expected);
            damper_force(rotor, laws[k].is_long, s, obtained);
            const double size = fmax(1.0, hypot(expected[0], expected[1]));
            worst = fmax(worst, hypot(obtained[0] - expected[0], obtained[1] - expected[1]) / size);
        }
        check_within("squeeze-motion",
                     words("%s: largest relative difference from quadrature at random states", laws[k].name), 0.0,
                     worst, 3e-13);
        whirl_rotor_free(rotor);
    }
}

/// With (x' - y/2, y' + x/2) for the velocity the wedge of a journal bearing that turns is gone.
static void a_bearing_without_wedge(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make_damper(&laws[0]);
    uint64_t seed = 4;
    double worst = 0.0;
    for (int trial = 0; trial < 1000; trial++) {
        double s[4], film[2], obtained[2];
        draw(&seed, 0.95, s);
        whirl_film_force(s[0], s[1], s[2] - 0.5 * s[1], s[3] + 0.5 * s[0], film);
        damper_force(rotor, false, s, obtained);
        const double size = fmax(1.0, 0.25 * hypot(film[0], film[1]));
        worst = fmax(worst, hypot(obtained[0] - 0.25 * film[0], obtained[1] - 0.25 * film[1]) / size);
    }
    check_within("squeeze-motion",
                 "short, half film: largest relative difference from the journal bearing without wedge", 0.0, worst,
                 1e-13);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- the derivative

/// Computes the force in extended complex numbers, by angles: with alpha the angle of the motion, a and b the
/// displacement across and along it, and K = int 1/h over the film.
static void complex_force(const struct law *law, const number z[4], number f[2]) {
    number v[2] = {z[2], z[3]};
    const number square = z[0] * z[0] + z[1] * z[1], q = 1.0L - square, p = z[0] * z[2] + z[1] * z[3];
    for (int i = 0; law->is_long && i < 2; i++) v[i] = (2.0L * v[i] + z[i] * p) / (2.0L + square);
    const number fast = csqrtl(v[0] * v[0] + v[1] * v[1]), c = v[0] / fast, s = v[1] / fast, root = csqrtl(q);
    const number b = z[0] * c + z[1] * s, a = z[0] * s - z[1] * c;
    const number K = law->is_full ? 2.0L * pi / root : (pi + 2.0L * catanl(b / root)) / root;
    const number ends = law->is_full ? 0.0L : 2.0L;
    for (int i = 0; i < 2; i++) {
        const number along = i ? s : c, across = i ? c : -s;
        if (law->is_long)
            f[i] = -0.5L * fast * (K * along + z[i] * (K * b + ends) / q);
        else
            f[i] =
                -0.5L * fast / q * (3.0L * z[i] * (K * b + ends) / q + K * along + ends * a / (1.0L - a * a) * across);
    }
}

static void derivative(void **unused) {
    (void)unused;
    for (int k = 0; k < 4; k++) {
        whirl_rotor *rotor = make_damper(&laws[k]);
        uint64_t seed = 77;
        double worst = 0.0;
        for (int trial = 0; trial < 1000; trial++) {
            double s[4], matrix[64], theirs[8], size = 0.0, error = 0.0;
            draw(&seed, 0.9, s);
            exact_jacobian(whirl_rotor_system(rotor), 0.0, (double[]){s[0], s[1], 0.0, 0.0, s[2], s[3], 0.0, 0.0},
                           matrix);
            for (int by = 0; by < 4; by++) {
                number z[4] = {s[0], s[1], s[2], s[3]}, f[2];
                z[by] += 1e-24L * I;
                complex_force(&laws[k], z, f);
                const int column = by < 2 ? by : by + 2;
                for (int i = 0; i < 2; i++) {
                    theirs[2 * by + i] = (double)(cimagl(f[i]) / 1e-24L) * (laws[k].is_long ? 12.0 : 1.0);
                    size = fmax(size, fabs(theirs[2 * by + i]));
                    // Journal by journal, journal by housing, and the housing's.
                    error = fmax(error, fabs(matrix[8 * (4 + i) + column] - theirs[2 * by + i]));
                    error = fmax(error, fabs(matrix[8 * (4 + i) + column + 2] + theirs[2 * by + i]));
                    error = fmax(error, fabs(matrix[8 * (6 + i) + column] + theirs[2 * by + i]));
                }
            }
            worst = fmax(worst, error / fmax(1.0, size));
        }
        check_within("squeeze-derivative",
                     words("%s: largest relative difference from complex steps at 1000 states", laws[k].name), 0.0,
                     worst, 1e-12);
        whirl_rotor_free(rotor);
    }
}

/// At rest forces and derivatives are finite: the half film damps half as much as the whole one.
static void at_rest(void **unused) {
    (void)unused;
    for (int k = 0; k < 4; k += 2) {
        const double state[8] = {0.3, -0.4};
        double half[64], full[64], slope[8], worst = 0.0;
        whirl_rotor *rotors[2] = {make_damper(&laws[k]), make_damper(&laws[k + 1])};
        exact_jacobian(whirl_rotor_system(rotors[0]), 0.0, state, half);
        exact_jacobian(whirl_rotor_system(rotors[1]), 0.0, state, full);
        evaluate_rhs(whirl_rotor_system(rotors[0]), 0.0, state, slope);
        for (int i = 0; i < 8; i++) assert_true(fabs(slope[i]) < 1e-60);
        for (int i = 32; i < 64; i++) worst = fmax(worst, fabs(half[i] - 0.5 * full[i]) / fmax(1.0, fabs(full[i])));
        check_within("squeeze-derivative",
                     words("%s, at rest: difference of the derivative from half that of the full film", laws[k].name),
                     0.0, worst, 1e-14);
        whirl_rotor_free(rotors[0]);
        whirl_rotor_free(rotors[1]);
    }
}

// ---------------------------------------------------------------- a rotor on a damper

/// cases/squeeze-damper.yaml: a disc on a shaft to a journal in a damper with a centring spring; SI.
static const struct {
    double disc, journal, shaft, spring, drag, eccentricity, viscosity, radius, length, clearance;
} m = {20.0, 4.0, 15e6, 4e6, 400.0, 40e-6, 4e-3, 0.05, 0.02, 1e-4};

static whirl_rotor *make_rotor(double speed) {
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(speed, m.clearance, &design));
    const whirl_setting disc[] = {
        {"mass", m.disc, NULL}, {"damping", m.drag, NULL}, {"eccentricity", m.eccentricity, NULL}};
    require_ok(whirl_design_station(design, "disc", disc, 3));
    require_ok(whirl_design_station(design, "journal", (whirl_setting[]){{"mass", m.journal, NULL}}, 1));
    const whirl_setting shaft[] = {{"between", 0.0, "disc, journal"}, {"k1", m.shaft, NULL}};
    require_ok(whirl_design_element(design, "shaft", shaft, 2));
    const whirl_setting spring[] = {{"between", 0.0, "journal, ground"}, {"stiffness", m.spring, NULL}};
    require_ok(whirl_design_element(design, "spring", spring, 2));
    const whirl_setting damper[] = {{"at", 0.0, "journal"},
                                    {"clearance", m.clearance, NULL},
                                    {"viscosity", m.viscosity, NULL},
                                    {"radius", m.radius, NULL},
                                    {"length", m.length, NULL}};
    require_ok(whirl_design_element(design, "squeeze", damper, 5));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Computes a circular orbit of the journal: z. Returns how far the force that keeps it there differs from the disc's.
static double balance(double w, double e, double complex *disc, double complex *journal) {
    const double complex inertia = m.shaft - m.disc * w * w + I * w * m.drag;
    const double complex push = m.disc * m.eccentricity * w * w;
    double film[2];
    circular_force(&laws[0], e, film);
    const double scale = m.viscosity * w * m.radius * pow(m.length, 3.0) / (m.clearance * m.clearance);
    const double complex needed =
        (m.spring + m.shaft - m.journal * w * w - m.shaft * m.shaft / inertia) * e * m.clearance +
        scale * (film[0] + I * film[1]);
    *journal = m.shaft * push / inertia / needed * e; // in clearances, of modulus e
    *disc = (push / m.clearance + m.shaft * *journal) / inertia;
    return cabs(needed) - cabs(m.shaft * push / inertia);
}

/// Writes the roots e of the balance, smallest first; returns their number, at most three.
static int circles(double w, double roots[3]) {
    enum { CELLS = 2000 };
    double complex disc, journal;
    int count = 0;
    for (int i = 0; i < CELLS && count < 3; i++) {
        double low = (i + 1e-9) / CELLS, high = (i + 1.0 - 1e-9) / CELLS;
        const bool below = balance(w, low, &disc, &journal) < 0.0;
        if ((balance(w, high, &disc, &journal) < 0.0) == below) continue;
        for (int k = 0; k < 60; k++) {
            const double middle = 0.5 * (low + high);
            if ((balance(w, middle, &disc, &journal) < 0.0) == below)
                low = middle;
            else
                high = middle;
        }
        roots[count++] = low;
    }
    return count;
}

/// Computes the section point after 300 revolutions from a start that is off by 1 %.
static void settle(double w, double e, double state[8]) {
    whirl_rotor *rotor = make_rotor(w);
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
    double complex disc, journal;
    balance(w, e, &disc, &journal);
    const double complex z[2] = {1.01 * disc, 1.01 * journal};
    for (int i = 0; i < 2; i++) {
        state[2 * i] = creal(z[i]);
        state[2 * i + 1] = cimag(z[i]);
        state[4 + 2 * i] = -cimag(z[i]);
        state[5 + 2 * i] = creal(z[i]);
    }
    revolve(integrator, state, 300);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

static void rotor_orbits(void **unused) {
    (void)unused;
    static const double speeds[] = {400.0, 500.0, 600.0, 800.0, 1000.0};
    for (int i = 0; i < 5; i++) {
        double roots[3], state[8];
        const int count = circles(speeds[i], roots);
        assert_int_equal(count, speeds[i] == 600.0 ? 3 : 1);
        // The middle one of three circles is unstable (White 1972).
        for (int k = 0; k < count; k += 2) {
            settle(speeds[i], roots[k], state);
            const char *which = count == 1 ? "" : k ? ", large orbit" : ", small orbit";
            check_within("squeeze-rotor", words("eccentricity ratio at %g rad/s%s", speeds[i], which), roots[k],
                         hypot(state[2], state[3]), 1e-10);
        }
        if (count < 3) continue;
        settle(speeds[i], roots[1], state);
        check_within("squeeze-rotor", "eccentricity ratio at 600 rad/s, started at 1.01 times the middle orbit",
                     roots[2], hypot(state[2], state[3]), 1e-10);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(circular_orbits), cmocka_unit_test(force_in_newtons),
        cmocka_unit_test(any_motion),      cmocka_unit_test(a_bearing_without_wedge),
        cmocka_unit_test(derivative),      cmocka_unit_test(at_rest),
        cmocka_unit_test(rotor_orbits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
