// Cases A5 to A8: rotors in the short-bearing film.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "support_record.h"
#include "support_rotor.h"
#include "whirl/engine/analyze.h"

static const double pi = 3.14159265358979323846;

/// Finds the place at eccentricity ratio e where a load along -y holds the journal (A3). Returns sigma = F0/W there.
static double place_journal(double e, double position[2]) {
    const double phi = atan2(pi * sqrt(1.0 - e * e), 4.0 * e);
    double force[2];
    position[0] = e * sin(phi);
    position[1] = -e * cos(phi);
    whirl_film_force(position[0], position[1], 0.0, 0.0, force);
    return 1.0 / hypot(force[0], force[1]);
}

/// Steps for differences: the film has a kink at the centre and a pole at the wall.
static double difference_step(double e) {
    return 5e-3 * fmin(e, 1.0 - e);
}

/// Returns largest real part of the eigenvalues about the resting journal of a rigid rotor at speed s.
static double rigid_growth(double e, double s, double *whirl_ratio) {
    double position[2], matrix[16];
    const double sigma = place_journal(e, position);
    const double state[4] = {position[0], position[1], 0.0, 0.0};
    whirl_rotor *rotor = make_film_rotor(sigma / (s * s), 1.0 / (s * s), 0.0);
    rhs_jacobian(whirl_rotor_system(rotor), 0.0, state, difference_step(e), matrix);
    whirl_rotor_free(rotor);
    return largest_real_part(4, matrix, whirl_ratio);
}

/// Returns the speed at which the rotor loses its stability, by bisection between a stable and an unstable speed.
static double rigid_threshold(double e, double *whirl_ratio) {
    double low = 1.0, high = 1e4;
    for (int i = 0; i < 100; i++) {
        const double middle = 0.5 * (low + high);
        *(rigid_growth(e, middle, whirl_ratio) > 0.0 ? &high : &low) = middle;
    }
    return 0.5 * (low + high);
}

/// Extrapolates values[count] at abscissae at[count] to 0 (Neville).
static double extrapolate(const double *at, double *values, int count) {
    for (int level = 1; level < count; level++)
        for (int i = 0; i < count - level; i++)
            values[i] = (at[i] * values[i + 1] - at[i + level] * values[i]) / (at[i] - at[i + level]);
    return values[0];
}

static void a5_threshold_speed(void **unused) {
    (void)unused;
    double nu;
    // The coefficients are even in e or odd in e, the threshold is even.
    const double squares[4] = {0.0064, 0.0016, 0.0004, 0.0001};
    double speeds[4], ratios[4];
    for (int i = 0; i < 4; i++) speeds[i] = rigid_threshold(sqrt(squares[i]), &ratios[i]);
    check_digits("A5", "threshold speed, e -> 0", "2.763953196", extrapolate(squares, speeds, 4));
    check_within("A5", "whirl ratio, e -> 0", 0.5, extrapolate(squares, ratios, 4), 1e-9);
    static const struct {
        double e;
        const char *speed, *ratio;
    } rows[] = {{0.1, "2.741278636", ".50293839"},
                {0.3, "2.605785828", ".51941739"},
                {0.45697072, "2.531705709", ".52106604"},
                {0.5, "2.541730858", ".51464014"}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        check_digits("A5", words("threshold speed at e = %.8g", rows[i].e), rows[i].speed,
                     rigid_threshold(rows[i].e, &nu));
        check_digits("A5", words("whirl ratio at e = %.8g", rows[i].e), rows[i].ratio, nu);
    }
}

/// Returns d(threshold speed)/de by central differences of tenth order.
static double threshold_slope(double e) {
    static const double weights[5] = {5.0 / 6.0, -5.0 / 21.0, 5.0 / 84.0, -5.0 / 504.0, 1.0 / 1260.0};
    const double step = 0.01;
    double slope = 0.0, nu;
    for (int k = 1; k <= 5; k++)
        slope += weights[k - 1] * (rigid_threshold(e + k * step, &nu) - rigid_threshold(e - k * step, &nu)) / step;
    return slope;
}

static void a5_smallest_threshold_speed(void **unused) {
    (void)unused;
    double low = 0.4, high = 0.52;
    for (int i = 0; i < 40; i++) {
        const double middle = 0.5 * (low + high);
        *(threshold_slope(middle) < 0.0 ? &low : &high) = middle;
    }
    check_digits("A5", "e of the smallest threshold speed", ".45697072", 0.5 * (low + high));
}

/// Returns sign of nu^2 as the formula of case A5 has it, with coefficients by differences: no whirl is possible below
/// 0.
static double whirl_ratio_squared(double e) {
    double position[2], m[16];
    const double sigma = place_journal(e, position);
    const double state[4] = {position[0], position[1], 0.0, 0.0};
    whirl_rotor *rotor = make_film_rotor(sigma, 1.0, 0.0);
    rhs_jacobian(whirl_rotor_system(rotor), 0.0, state, difference_step(e), m);
    whirl_rotor_free(rotor);
    const double kxx = -m[8], kxy = -m[9], kyx = -m[12], kyy = -m[13];
    const double cxx = -m[10], cxy = -m[11], cyx = -m[14], cyy = -m[15];
    const double keq = (kxx * cyy + kyy * cxx - kxy * cyx - kyx * cxy) / (cxx + cyy);
    return ((keq - kxx) * (keq - kyy) - kxy * kyx) / (cxx * cyy - cxy * cyx);
}

static void a5_end_of_instability(void **unused) {
    (void)unused;
    double low = 0.7, high = 0.8, nu;
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        *(whirl_ratio_squared(middle) > 0.0 ? &low : &high) = middle;
    }
    check_digits("A5", "e from which every speed is stable", ".756030386471", 0.5 * (low + high));
    check_holds("A5", "unstable at e = .7559, s = 1000", rigid_growth(0.7559, 1e3, &nu) > 0.0);
    bool stable = true;
    for (double s = 0.5; s < 2000.0; s *= 1.1) stable = stable && rigid_growth(0.7561, s, &nu) < 0.0;
    check_holds("A5", "stable at e = .7561 for s = .5 to 2000", stable);
}

/// Returns threshold speed with a journal of mass mj (of the disc's mass 1) and shaft stiffness k c/W = 2; W = (1 + mj)
/// g.
static double flexible_threshold(double e, double mj) {
    double low = 1.0, high = 2.5, position[2];
    const double sigma = place_journal(e, position), weight = 1.0 + mj, stiffness = 2.0 * weight;
    for (int i = 0; i < 60; i++) {
        const double s = 0.5 * (low + high);
        double matrix[64];
        whirl_rotor *rotor = make_flexible_film_rotor(s, mj, stiffness, sigma * weight);
        // The disc hangs below the journal by its own weight over k.
        const double state[8] = {position[0], position[1] - 1.0 / stiffness, position[0], position[1]};
        rhs_jacobian(whirl_rotor_system(rotor), 0.0, state, difference_step(e), matrix);
        *(largest_real_part(8, matrix, NULL) > 0.0 ? &high : &low) = s;
        whirl_rotor_free(rotor);
    }
    return 0.5 * (low + high);
}

static void a6_flexible_shaft(void **unused) {
    (void)unused;
    const double masses[5] = {0.04, 0.02, 0.01, 0.005, 0.0025};
    double thresholds[5];
    for (int i = 0; i < 5; i++) thresholds[i] = flexible_threshold(0.5, masses[i]);
    check_digits("A6", "threshold speed, mj -> 0", "1.865929769", extrapolate(masses, thresholds, 5));
    check_digits("A6", "threshold speed, mj = .1 m", "1.9285152416", flexible_threshold(0.5, 0.1));
}

static void a7_unloaded_rotor(void **unused) {
    (void)unused;
    static const struct {
        double e;
        const char *rho, *modulus;
    } rows[] = {{0.3, ".304206515539", ".57499"}, {0.5, ".504787456190", ".10099"}};
    const double gam = 0.2;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        // A circle of radius e at the angle tau - psi: -e = Gam f_r + rho cos psi, 0 = Gam f_t + rho sin psi.
        const double e = rows[i].e;
        double force[2], matrix[16];
        whirl_film_force(e, 0.0, 0.0, e, force);
        const double along = -e - gam * force[0], across = -gam * force[1];
        const double rho = hypot(along, across), psi = atan2(across, along);
        check_digits("A7", words("rho at e = %g", e), rows[i].rho, rho);

        whirl_rotor *rotor = make_film_rotor(gam, 0.0, rho);
        whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "rk4", 4096);
        double state[4] = {e * cos(psi), -e * sin(psi), e * sin(psi), e * cos(psi)};
        revolve(integrator, state, 30);
        check_within("A7", words("radius at e = %g after 30 revolutions", e), e, hypot(state[0], state[1]), 1e-11);
        flow_jacobian(integrator, 4, state, 1, 1e-3, matrix);
        check_digits("A7", words("largest Floquet modulus at e = %g", e), rows[i].modulus, largest_modulus(4, matrix));
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

static const double a8_start[4] = {0.1, -0.2, 0.0, 0.0};

/// Makes the rotor of case A8: sigma = .3, s = 3.
static whirl_rotor *make_a8_rotor(double rho) {
    return make_film_rotor(0.3 / 9.0, 1.0 / 9.0, rho);
}

static void check_a8_periodic(double rho, int period, size_t count, const printed_point *points) {
    double state[4];
    whirl_rotor *rotor = make_a8_rotor(rho);
    whirl_record *record = record_motion(whirl_rotor_system(rotor), a8_start, 512, 1000, 400);
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "rk4", 8192);
    check_regime("A8", words("regime at rho = %g", rho), words("P-%d", period), record);
    check_orbit("A8", words("rho = %g", rho), record, integrator, period, points, count, state);
    whirl_integrator_free(integrator);
    whirl_record_free(record);
    whirl_rotor_free(rotor);
}

static void a8_period_doubling(void **unused) {
    (void)unused;
    static const printed_point two[2] = {{".6705633835", "-.3675472557"}, {"-.7547030883", "-.0826070387"}};
    static const printed_point eight = {".3474009627", "-.6666234979"};
    static const printed_point one = {".2272208938", "-.8044475724"};
    check_a8_periodic(0.2, 2, 2, two);
    check_a8_periodic(0.3, 8, 1, &eight);
    check_a8_periodic(0.5, 1, 1, &one);
}

static void a8_chaos(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make_a8_rotor(0.4);
    whirl_record *record = record_motion(whirl_rotor_system(rotor), a8_start, 512, 1000, 20000);
    check_regime("A8", "regime at rho = 0.4", "chaotic", record);
    check_exponent("A8", "exponent per revolution at rho = 0.4", 0.43, 0.03, record, 1.0);
    whirl_record_free(record);
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a5_threshold_speed),
        cmocka_unit_test(a5_smallest_threshold_speed),
        cmocka_unit_test(a5_end_of_instability),
        cmocka_unit_test(a6_flexible_shaft),
        cmocka_unit_test(a7_unloaded_rotor),
        cmocka_unit_test(a8_period_doubling),
        cmocka_unit_test(a8_chaos),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
