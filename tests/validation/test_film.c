// Cases A1 to A4: the short-bearing oil film.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "support_rotor.h"

static const double pi = 3.14159265358979323846;

/// A uniform number in (0, 1), the same on every machine.
static double random_number(uint64_t *seed) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return ((double)(*seed >> 11) + 0.5) / 9007199254740992.0;
}

/// f = -2C int_alpha^(alpha+pi) sin(phi - alpha) (cos phi, sin phi)/h^3 dphi, by Gauss's rule of eight points.
static void integrate_pressure(const double s[4], double force[2]) {
    static const long double nodes[4] = {0.183434642495649804939L, 0.525532409916328985818L, 0.796666477413626739592L,
                                         0.960289856497536231684L};
    static const long double weights[4] = {0.362683783378361982965L, 0.313706645877887287338L, 0.222381034453374470544L,
                                           0.101228536290376259153L};
    const int panels = 200;
    const long double a = s[0] - 2.0L * s[3], b = s[1] + 2.0L * s[2];
    const long double alpha = atan2l(-b, -a), half = 0.5L * 3.14159265358979323846264L / panels;
    long double x = 0.0L, y = 0.0L;
    for (int panel = 0; panel < panels; panel++)
        for (int k = 0; k < 8; k++) {
            const long double angle = half * (2 * panel + 1 + (k < 4 ? nodes[k] : -nodes[k - 4]));
            const long double phi = alpha + angle;
            const long double h = 1.0L - s[0] * cosl(phi) - s[1] * sinl(phi);
            const long double part = half * weights[k % 4] * sinl(angle) / (h * h * h);
            x += part * cosl(phi);
            y += part * sinl(phi);
        }
    force[0] = (double)(-2.0L * hypotl(a, b) * x);
    force[1] = (double)(-2.0L * hypotl(a, b) * y);
}

static void a1_force_is_the_integral_of_the_pressure(void **unused) {
    (void)unused;
    uint64_t seed = 20150901u;
    double worst = 0.0;
    for (int i = 0; i < 1000; i++) {
        const double e = 0.9 * sqrt(random_number(&seed)), angle = 2.0 * pi * random_number(&seed);
        const double state[4] = {e * cos(angle), e * sin(angle), 2.0 * random_number(&seed) - 1.0,
                                 2.0 * random_number(&seed) - 1.0};
        double expected[2], obtained[2];
        integrate_pressure(state, expected);
        whirl_film_force(state[0], state[1], state[2], state[3], obtained);
        const double size = fmax(1.0, hypot(expected[0], expected[1]));
        worst = fmax(worst, hypot(obtained[0] - expected[0], obtained[1] - expected[1]) / size);
    }
    check_within("A1", "largest relative difference from quadrature at 1000 random states", 0.0, worst, 3e-13);
}

static void a1_force_at_the_cut_of_the_angle(void **unused) {
    (void)unused;
    // At B = y + 2x' = 0 an arc tangent of one argument is wrong by pi.
    const double states[2][4] = {{0.4, -0.2, 0.1, 0.5}, {0.4, -0.2, 0.1, -0.5}};
    for (int i = 0; i < 2; i++) {
        double expected[2], obtained[2];
        integrate_pressure(states[i], expected);
        whirl_film_force(states[i][0], states[i][1], states[i][2], states[i][3], obtained);
        check_within("A1", words("fx where y + 2x' = 0, y' = %g", states[i][3]), expected[0], obtained[0],
                     3e-13 * fabs(expected[0]));
        check_within("A1", words("fy where y + 2x' = 0, y' = %g", states[i][3]), expected[1], obtained[1],
                     3e-13 * fabs(expected[1]));
    }
}

/// A journal of 1000 N, R = 50 mm, L = 25 mm, c = 100 um, mu = .02 Pa s at 3000 rpm, as A3 has it; others alike.
typedef struct bearing {
    double radius, length, clearance, viscosity, weight, rpm;
} bearing;

static whirl_rotor *make_bearing_rotor(const bearing *b) {
    const double mass = b->weight / 10.0;
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(b->rpm * 2.0 * pi / 60.0, b->clearance, &design));
    const whirl_setting station[] = {{"mass", mass, NULL}};
    require_ok(whirl_design_station(design, "journal", station, 1));
    const whirl_setting film[] = {{"at", 0.0, "journal"},
                                  {"clearance", b->clearance, NULL},
                                  {"viscosity", b->viscosity, NULL},
                                  {"radius", b->radius, NULL},
                                  {"length", b->length, NULL}};
    require_ok(whirl_design_element(design, "film", film, 5));
    const whirl_setting gravity[] = {{"acceleration", 10.0, NULL}};
    require_ok(whirl_design_element(design, "gravity", gravity, 1));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

static void a1_scale_of_the_force(void **unused) {
    (void)unused;
    const bearing b = {0.05, 0.025, 1e-4, 0.02, 1000.0, 3000.0};
    const double omega = 100.0 * pi;
    whirl_rotor *rotor = make_bearing_rotor(&b);
    const double state[4] = {0.3, -0.4, 0.1, -0.2};
    double slope[4];
    evaluate_rhs(whirl_rotor_system(rotor), 0.0, state, slope);
    // Table A2 gives fx there; mass 100 kg.
    const double newtons = slope[2] * 100.0 * b.clearance * omega * omega;
    const double scale = b.viscosity * omega * b.radius * b.length * pow(b.radius / b.clearance, 2.0) *
                         pow(b.length / (2.0 * b.radius), 2.0);
    check_within("A1", "F0 in N from viscosity, radius, length and clearance", scale, newtons / -1.821529841236, 1e-9);
    whirl_rotor_free(rotor);
}

static void a2_forces(void **unused) {
    (void)unused;
    static const struct {
        const char *name;
        double state[4], force[2];
    } rows[] = {{"(.5, 0, 0, 0)", {0.5, 0.0, 0.0, 0.0}, {-1.777777777778, 2.418399152312}},
                {"(.3, -.4, 0, 0)", {0.3, -0.4, 0.0, 0.0}, {0.868052655183, 2.873261713610}},
                {"(.3, -.4, .1, -.2)", {0.3, -0.4, 0.1, -0.2}, {-1.821529841236, 9.029516486066}}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double force[2];
        whirl_film_force(rows[i].state[0], rows[i].state[1], rows[i].state[2], rows[i].state[3], force);
        check_within("A2", words("fx at %s", rows[i].name), rows[i].force[0], force[0], 1e-10);
        check_within("A2", words("fy at %s", rows[i].name), rows[i].force[1], force[1], 1e-10);
    }
}

static void a3_forces_of_a_resting_journal(void **unused) {
    (void)unused;
    double worst = 0.0;
    for (double e = 0.01; e < 0.985; e += 0.01) {
        double force[2];
        const double p = 1.0 - e * e, radial = -4.0 * e * e / (p * p), tangential = pi * e / pow(p, 1.5);
        whirl_film_force(e, 0.0, 0.0, 0.0, force);
        worst = fmax(worst, hypot(force[0] - radial, force[1] - tangential) / hypot(radial, tangential));
    }
    check_within("A3", "largest relative difference from f_r, f_t for e = .01 to .98", 0.0, worst, 1e-13);
}

/// Finds the position of rest of a rotor's journal, by Newton's method on the equations of motion.
static void find_equilibrium(const whirl_system *system, double position[2]) {
    double state[4] = {position[0], position[1], 0.0, 0.0};
    for (int i = 0; i < 30; i++) {
        double slope[4], full[16];
        evaluate_rhs(system, 0.0, state, slope);
        rhs_jacobian(system, 0.0, state, 1e-3, full);
        const double matrix[4] = {full[8], full[9], full[12], full[13]};
        double step[2] = {slope[2], slope[3]};
        solve_linear(2, matrix, step);
        state[0] -= step[0];
        state[1] -= step[1];
    }
    position[0] = state[0];
    position[1] = state[1];
}

static void a3_statics(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make_film_rotor(0.3331640497, 1.0, 0.0);
    double at[2] = {0.4, -0.3};
    find_equilibrium(whirl_rotor_system(rotor), at);
    check_within("A3", "e at sigma = 0.3331640497", 0.5, hypot(at[0], at[1]), 5e-11);
    check_digits("A3", "phi at e = .5, degrees", "53.68020", atan2(at[0], -at[1]) * 180.0 / pi);
    whirl_rotor_free(rotor);

    double force[2];
    whirl_film_force(0.5, 0.0, 0.0, 0.0, force);
    check_digits("A3", "sigma at e = .5", "0.3331640497", 1.0 / hypot(force[0], force[1]));

    const bearing b = {0.05, 0.025, 1e-4, 0.02, 1000.0, 3000.0};
    rotor = make_bearing_rotor(&b);
    find_equilibrium(whirl_rotor_system(rotor), at);
    check_digits("A3", "e of the bearing of 1000 N at 3000 rpm", ".6757879254", hypot(at[0], at[1]));
    check_digits("A3", "phi of it, degrees", "40.58502207", atan2(at[0], -at[1]) * 180.0 / pi);
    whirl_rotor_free(rotor);
}

/// Stiffness and damping matrices -dF/d(x, y), -dF/d(x', y') of the film alone at (x, y), per unit of F0.
static void differentiate_film(double x, double y, double stiffness[4], double damping[4]) {
    const double state[4] = {x, y, 0.0, 0.0};
    double matrix[16];
    whirl_rotor *rotor = make_film_rotor(1.0, 0.0, 0.0);
    // The force has a kink where the journal rests at the centre and a pole at the wall.
    rhs_jacobian(whirl_rotor_system(rotor), 0.0, state, 5e-3 * fmin(hypot(x, y), 1.0 - hypot(x, y)), matrix);
    whirl_rotor_free(rotor);
    for (int i = 0; i < 4; i++) {
        stiffness[i] = -matrix[4 * (2 + i / 2) + i % 2];
        damping[i] = -matrix[4 * (2 + i / 2) + 2 + i % 2];
    }
}

/// The closed forms, K in W/c and C in W/(c omega).
static void closed_coefficients(double e, double k[4], double c[4]) {
    const double p = 1.0 - e * e, root = sqrt(p), e2 = e * e, pi2 = pi * pi;
    const double h = pow(pi2 * p + 16.0 * e2, -1.5);
    k[0] = 4.0 * h * (pi2 * (2.0 - e2) + 16.0 * e2);
    k[1] = pi * h * (pi2 * p * p - 16.0 * e2 * e2) / (e * root);
    k[2] = -pi * h * (pi2 * p * (1.0 + 2.0 * e2) + 32.0 * e2 * (1.0 + e2)) / (e * root);
    k[3] = 4.0 * h * (pi2 * (1.0 + 2.0 * e2) + 32.0 * e2 * (1.0 + e2) / p);
    c[0] = 2.0 * pi * h * root * (pi2 * (1.0 + 2.0 * e2) - 16.0 * e2) / e;
    c[1] = c[2] = -8.0 * h * (pi2 * (1.0 + 2.0 * e2) - 16.0 * e2);
    c[3] = 2.0 * pi * h * (pi2 * p * p + 48.0 * e2) / (e * root);
}

/// Finds the place at eccentricity ratio e where a load along -y holds the journal, and returns sigma = F0/W there.
static double place_journal(double e, double position[2]) {
    const double phi = atan2(pi * sqrt(1.0 - e * e), 4.0 * e);
    double force[2];
    position[0] = e * sin(phi);
    position[1] = -e * cos(phi);
    whirl_film_force(position[0], position[1], 0.0, 0.0, force);
    return 1.0 / hypot(force[0], force[1]);
}

static void a4_closed_forms(void **unused) {
    (void)unused;
    double worst = 0.0;
    for (double e = 0.1; e < 0.95; e += 0.05) {
        double at[2], k[4], c[4], stiffness[4], damping[4];
        const double sigma = place_journal(e, at);
        differentiate_film(at[0], at[1], stiffness, damping);
        closed_coefficients(e, k, c);
        for (int i = 0; i < 4; i++) {
            worst = fmax(worst, fabs(sigma * stiffness[i] - k[i]) / fmax(1.0, fabs(k[i])));
            worst = fmax(worst, fabs(sigma * damping[i] - c[i]) / fmax(1.0, fabs(c[i])));
        }
    }
    check_within("A4", "largest relative difference from the closed forms for e = .1 to .9", 0.0, worst, 1e-10);
}

/// K and C are those of the rotor's Jacobian at the equilibrium under a load of one.
static void a4_exact_jacobian(void **unused) {
    (void)unused;
    double worst = 0.0;
    for (double e = 0.01; e < 0.995; e += 0.01) {
        double state[4] = {0.0}, k[4], c[4], matrix[16];
        whirl_rotor *rotor = make_film_rotor(place_journal(e, state), 1.0, 0.0);
        exact_jacobian(whirl_rotor_system(rotor), 0.0, state, matrix);
        closed_coefficients(e, k, c);
        for (int i = 0; i < 4; i++) {
            const double stiffness = -matrix[4 * (2 + i / 2) + i % 2], damping = -matrix[4 * (2 + i / 2) + 2 + i % 2];
            worst = fmax(worst, fabs(stiffness - k[i]) / fmax(1.0, fabs(k[i])));
            worst = fmax(worst, fabs(damping - c[i]) / fmax(1.0, fabs(c[i])));
        }
        whirl_rotor_free(rotor);
    }
    check_within("A4", "exact Jacobian against the closed forms for e = .01 to .99, largest relative difference", 0.0,
                 worst, 1e-12);
}

static void a4_bearing(void **unused) {
    (void)unused;
    static const char *const names[4] = {"xx", "xy", "yx", "yy"};
    static const char *const stiffness_digits[4] = {"12.80795958", "16.39359325", "-25.06039328", "8.815302741"};
    static const char *const damping_digits[4] = {"232.8969299", "-81.92437052", "-81.92437052", "294.9116194"};
    const bearing b = {0.05, 0.03, 1e-4, 0.1, 525.0, 1500.0};
    const double omega = 50.0 * pi;
    whirl_rotor *rotor = make_bearing_rotor(&b);
    double at[2] = {0.2, -0.1}, state[4] = {0.0}, matrix[16];
    find_equilibrium(whirl_rotor_system(rotor), at);
    check_digits("A4", "e of the bearing of 525 N at 1500 rpm", ".266297509", hypot(at[0], at[1]));
    state[0] = at[0];
    state[1] = at[1];
    rhs_jacobian(whirl_rotor_system(rotor), 0.0, state, 1e-3, matrix);
    for (int i = 0; i < 4; i++) {
        const double scale = b.weight / 10.0 * omega * omega; // accelerations per clearance to N/m
        const double stiffness = -matrix[4 * (2 + i / 2) + i % 2] * scale;
        const double damping = -matrix[4 * (2 + i / 2) + 2 + i % 2] * scale / omega;
        check_digits("A4", words("K%s, MN/m", names[i]), stiffness_digits[i], stiffness / 1e6);
        check_digits("A4", words("C%s, kN s/m", names[i]), damping_digits[i], damping / 1e3);
    }
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a1_force_is_the_integral_of_the_pressure),
        cmocka_unit_test(a1_force_at_the_cut_of_the_angle),
        cmocka_unit_test(a1_scale_of_the_force),
        cmocka_unit_test(a2_forces),
        cmocka_unit_test(a3_forces_of_a_resting_journal),
        cmocka_unit_test(a3_statics),
        cmocka_unit_test(a4_closed_forms),
        cmocka_unit_test(a4_exact_jacobian),
        cmocka_unit_test(a4_bearing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
