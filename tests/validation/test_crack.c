// A disc on a cracked shaft: Floquet multipliers of the gentle crack by the variational equations, of the switching one
// by matrix exponentials in the frame that turns with the shaft, where its two stiffnesses are constant.
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
#include "whirl/engine/ensemble.h"
#include "whirl/engine/rotor.h"

enum { N = 4 };

static const double pi = 3.14159265358979323846;

/// Mass and stiffness are 1; d2 = d1/6. `terms` of the square wave, 0: the cosine.
typedef struct cracked {
    double speed, zeta, loss, angle, opens;
    int terms;
    double gravity;
} cracked;

static whirl_rotor *make_cracked(const cracked *c) {
    const whirl_setting disc[] = {{"mass", 1.0, NULL}, {"damping", 2.0 * c->zeta, NULL}};
    const whirl_setting crack[] = {{"between", 0.0, "disc, ground"},
                                   {"stiffness", 1.0, NULL},
                                   {"loss", c->loss, NULL},
                                   {"loss_across", c->loss / 6.0, NULL},
                                   {"angle", c->angle, NULL},
                                   {"opens", c->opens, NULL},
                                   {"law", 0.0, c->terms > 0 ? "square" : "cosine"},
                                   {"terms", c->terms, NULL}};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(c->speed, 1.0, &design));
    require_ok(whirl_design_station(design, "disc", disc, 2));
    require_ok(whirl_design_element(design, "crack", crack, c->terms > 0 ? 8 : 7));
    if (c->gravity > 0.0)
        require_ok(whirl_design_element(design, "gravity", &(whirl_setting){"acceleration", c->gravity, NULL}, 1));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Computes the monodromy matrix by the variational equations over one revolution; returns the integral of the
/// divergence.
static double monodromy(const cracked *c, double matrix[N * N]) {
    double x[N] = {0.0}, columns[N * N] = {0.0};
    whirl_perturbations perturbations = {.count = N, .vectors = columns};
    whirl_rotor *rotor = make_cracked(c);
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
    for (int i = 0; i < N; i++) columns[(N + 1) * i] = 1.0;
    require_ok(whirl_integrator_follow(integrator, N));
    assert_int_equal(WHIRL_BOUNDED, whirl_integrator_carry(integrator, x, &perturbations, NULL, NULL));
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) matrix[N * i + j] = columns[N * j + i];
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
    return perturbations.volume;
}

/// Writes the multipliers above the real axis, the one with the larger imaginary part last.
static void upper_multipliers(const double matrix[N * N], double complex upper[2]) {
    double complex values[N];
    int count = 0;
    eigenvalues(N, matrix, values);
    for (int i = 0; i < N; i++)
        if (cimag(values[i]) > 0.0 && count < 2) upper[count++] = values[i];
    assert_int_equal(count, 2);
    if (cimag(upper[0]) > cimag(upper[1])) {
        const double complex first = upper[0];
        upper[0] = upper[1];
        upper[1] = first;
    }
}

static void stiffness_over_a_revolution(void **unused) {
    (void)unused;
    const cracked c = {.speed = 1.3, .loss = 0.4, .angle = 0.4, .opens = -1.1};
    whirl_rotor *rotor = make_cracked(&c);
    double worst = 0.0;
    for (double tau = 0.0; tau < 6.2; tau += 0.1) {
        // R diag(1 - d1 f, 1 - d2 f) R^T e_x as a complex number.
        const double open = 0.5 * (1.0 + cos(tau + c.angle - c.opens));
        const double complex turned = cexp(I * (tau + c.angle));
        const double complex expected = turned * ((1.0 - c.loss * open) * creal(conj(turned)) +
                                                  I * (1.0 - c.loss / 6.0 * open) * cimag(conj(turned)));
        double slope[N];
        evaluate_rhs(whirl_rotor_system(rotor), tau, (double[N]){1.0, 0.0, 0.0, 0.0}, slope);
        worst = fmax(worst, cabs(c.speed * c.speed * (slope[2] + I * slope[3]) + expected));
    }
    check_within("Crack", "Kxx, Kyx: largest difference over a revolution", 0.0, worst, 1e-14);
    whirl_rotor_free(rotor);
}

static void gentle_crack(void **unused) {
    static const struct {
        double speed, zeta, loss;
        const char *re[2], *im[2]; ///< the one with the smaller imaginary part first
    } rows[] = {{0.5, 0.02, 0.2, {".7249467581", ".7165262410"}, {".2817352671", ".3025106754"}},
                {2.0, 0.01, 0.4, {"-.9606389669", "-.9541629383"}, {".1275701483", ".1693353319"}}};
    (void)unused;
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
        // Turned by a right angle with its load, the shaft is the same.
        for (int turned = 0; turned < 2; turned++) {
            const cracked c = {.speed = rows[r].speed,
                               .zeta = rows[r].zeta,
                               .loss = rows[r].loss,
                               .angle = turned ? -0.5 * pi : 0.0,
                               .opens = turned ? -0.5 * pi : 0.0};
            const char *where = turned ? ", load down" : "";
            double matrix[N * N];
            double complex upper[2];
            const double volume = monodromy(&c, matrix);
            upper_multipliers(matrix, upper);
            for (int i = 0; i < 2; i++) {
                check_digits("Crack", words("w = %g: Re of multiplier %d%s", c.speed, i + 1, where), rows[r].re[i],
                             creal(upper[i]));
                check_digits("Crack", words("w = %g: Im of multiplier %d%s", c.speed, i + 1, where), rows[r].im[i],
                             cimag(upper[i]));
            }
            const double product = exp(-8.0 * pi * c.zeta / c.speed);
            check_within("Crack", words("w = %g: product of all%s", c.speed, where), product, determinant(N, matrix),
                         1e-12);
            check_within("Crack", words("w = %g: by the divergence%s", c.speed, where), product, exp(volume), 1e-12);
        }
    }
}

// ---------------------------------------------------------------- the switching crack

static void multiply(const double a[N * N], const double b[N * N], double out[N * N]) {
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            out[N * i + j] = 0.0;
            for (int k = 0; k < N; k++) out[N * i + j] += a[N * i + k] * b[N * k + j];
        }
}

/// Computes exp(matrix t) by the power series over t/1024, squared ten times.
static void exponential(const double matrix[N * N], double t, double out[N * N]) {
    double scaled[N * N], power[N * N] = {0.0}, next[N * N];
    for (int i = 0; i < N * N; i++) scaled[i] = matrix[i] * t / 1024.0;
    for (int i = 0; i < N; i++) power[(N + 1) * i] = 1.0;
    memcpy(out, power, sizeof power);
    for (int n = 1; n < 16; n++) {
        multiply(power, scaled, next);
        for (int i = 0; i < N * N; i++) power[i] = next[i] / n;
        for (int i = 0; i < N * N; i++) out[i] += power[i];
    }
    for (int n = 0; n < 10; n++) {
        multiply(out, out, next);
        memcpy(out, next, sizeof next);
    }
}

/// Computes the matrix of the motion p in the turning frame, z = p e^(i tau): p'' + 2i p' - p + (2 zeta/w)(p' + i p) +
/// K p/w^2 = 0.
static void turning_frame(const cracked *c, double open, double out[N * N]) {
    const double g = 2.0 * c->zeta / c->speed, square = c->speed * c->speed;
    const double k1 = (1.0 - c->loss * open) / square, k2 = (1.0 - c->loss / 6.0 * open) / square;
    const double rows[N][N] = {{0, 0, 1, 0}, {0, 0, 0, 1}, {1.0 - k1, g, -g, 2.0}, {-g, 1.0 - k2, -2.0, -g}};
    memcpy(out, rows, sizeof rows);
}

/// Open for the quarter turn to either side of the load, closed for the rest: where the square wave jumps.
static void switching_monodromy(const cracked *c, double matrix[N * N]) {
    double frame[N * N], open[N * N], closed[N * N], half[N * N];
    turning_frame(c, 1.0, frame);
    exponential(frame, 0.5 * pi, open);
    turning_frame(c, 0.0, frame);
    exponential(frame, pi, closed);
    multiply(closed, open, half);
    multiply(open, half, matrix);
}

/// Returns the larger of the distances of both multipliers from those of the switching crack, with so many terms of the
/// square wave.
static double switching_error(const cracked *shape, int terms) {
    cracked c = *shape;
    double matrix[N * N];
    double complex sharp[2], smooth[2];
    switching_monodromy(&c, matrix);
    upper_multipliers(matrix, sharp);
    c.terms = terms;
    monodromy(&c, matrix);
    upper_multipliers(matrix, smooth);
    return fmax(cabs(sharp[0] - smooth[0]), cabs(sharp[1] - smooth[1]));
}

/// A term of order m that is left out is of the size 1/m, and moves a multiplier by its product with the term of order
/// m of products of motions. Their second derivatives jump with the force, so that this is of the size m^-3, and the
/// sum of m^-4 over all that are left out falls with the cube of their number.
static void switching_crack(void **unused) {
    (void)unused;
    const cracked shapes[] = {{.speed = 0.5, .zeta = 0.02, .loss = 0.2}, {.speed = 2.0, .zeta = 0.01, .loss = 0.4}};
    for (int i = 0; i < 2; i++) {
        const double few = switching_error(&shapes[i], 18), many = switching_error(&shapes[i], 72);
        const char *where = words("w = %g, switching", shapes[i].speed);
        check_within("Crack", words("%s: multipliers with 18 terms, distance from those of jumps", where), 0.0, few,
                     1e-6);
        check_within("Crack", words("%s: with 72 terms", where), 0.0, many, 1e-6 / 64.0);
        check_within("Crack", words("%s: order by which the distance falls", where), 3.0, log(few / many) / log(4.0),
                     0.05);
    }
}

// ---------------------------------------------------------------- in lanes

/// Carries x, which begins at 0, over some revolutions under weight, by the ensemble of a method.
static void carry_in_lanes(const whirl_system *system, const char *method, double rtol, int revolutions, double *x) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_ensemble *ensemble;
    strcpy(options.method, method);
    options.rtol = rtol;
    options.atol = 1e-3 * rtol;
    assert_true(whirl_ensemble_takes(system, &options));
    require_ok(whirl_ensemble_new(system, &options, 1, &ensemble));
    require_ok(whirl_ensemble_load(ensemble, 0, system, x));
    for (int i = 0; i < revolutions; i++) whirl_ensemble_revolve(ensemble, 1, NULL);
    assert_int_equal(whirl_ensemble_motion(ensemble, 0), WHIRL_BOUNDED);
    whirl_ensemble_state(ensemble, 0, x);
    whirl_ensemble_free(ensemble);
}

/// Carries x by an integrator of the same method.
static void carry_alone(const whirl_system *system, const char *method, double rtol, int revolutions, double *x) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    strcpy(options.method, method);
    options.rtol = rtol;
    options.atol = 1e-3 * rtol;
    require_ok(whirl_integrator_new(system, &options, &integrator));
    revolve(integrator, x, revolutions);
    whirl_integrator_free(integrator);
}

static double distance(const double *x, const double *y) {
    double most = 0.0;
    for (int i = 0; i < N; i++) most = fmax(most, fabs(x[i] - y[i]));
    return most;
}

/// Rosenbrock's methods need the derivative of the forces by time, of products of values of time too. Alone they take
/// it from differences of the whole slope; a less accurate one in lanes would lower the order and change the steps.
static void methods_in_lanes(void **unused) {
    enum { REVOLUTIONS = 5 };
    static const char *const methods[] = {"dop853", "rodas5p"};
    (void)unused;
    for (int terms = 0; terms <= 5; terms += 5) {
        const cracked c = {
            .speed = 0.7, .zeta = 0.05, .loss = 0.5, .angle = 0.3, .opens = -0.5 * pi, .terms = terms, .gravity = 1.0};
        const char *law = terms > 0 ? "5 terms" : "cosine";
        whirl_rotor *rotor = make_cracked(&c);
        const whirl_system *system = whirl_rotor_system(rotor);
        double truth[N] = {0.0};
        carry_alone(system, "dop853", 1e-15, REVOLUTIONS, truth);
        for (int m = 0; m < 2; m++) {
            double fine[N] = {0.0}, lanes[N] = {0.0}, alone[N] = {0.0};
            carry_in_lanes(system, methods[m], 1e-10, REVOLUTIONS, fine);
            carry_in_lanes(system, methods[m], 1e-5, REVOLUTIONS, lanes);
            carry_alone(system, methods[m], 1e-5, REVOLUTIONS, alone);
            check_within("Crack", words("%s in lanes, %s: error at rtol 1e-10", methods[m], law), 0.0,
                         distance(fine, truth), 1e-9);
            check_within("Crack",
                         words("%s in lanes, %s: from the method alone over its error, at rtol 1e-5", methods[m], law),
                         0.0, distance(lanes, alone) / distance(alone, truth), 0.05);
        }
        whirl_rotor_free(rotor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(stiffness_over_a_revolution), cmocka_unit_test(gentle_crack),
                                       cmocka_unit_test(switching_crack), cmocka_unit_test(methods_in_lanes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
