// Multipliers and all exponents as the library finds them by its own Jacobians: cases A7, A8, B2, C2, C4, C5, D1, D3,
// D5.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "lorenz.h"
#include "support_cases.h"
#include "support_check.h"
#include "support_flow.h"
#include "support_record.h"
#include "support_rotor.h"

static const double pi = 3.14159265358979323846;

// ---------------------------------------------------------------- what the library is asked for

static whirl_integrator *follow(const whirl_system *system, double rtol) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    strcpy(options.method, "dop853");
    options.rtol = rtol;
    options.atol = 0.01 * rtol;
    require_ok(whirl_integrator_new(system, &options, &integrator));
    require_ok(whirl_integrator_follow(integrator, system->dimension));
    return integrator;
}

/// Computes d(x after the revolutions)/dx [n][n], row-major; returns the logarithm of its determinant according to the
/// library.
static double monodromy(whirl_integrator *integrator, size_t n, double *x, int revolutions, double *matrix) {
    double columns[MAX_DIMENSION * MAX_DIMENSION] = {0.0}, volume = 0.0;
    for (size_t i = 0; i < n; i++) columns[i * n + i] = 1.0;
    for (int k = 0; k < revolutions; k++) {
        whirl_perturbations set = {.count = n, .vectors = columns};
        assert_int_equal(whirl_integrator_carry(integrator, x, &set, NULL, NULL), WHIRL_BOUNDED);
        volume += set.volume;
    }
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) matrix[n * i + j] = columns[n * j + i];
    return volume;
}

/// Records with all exponents, by unit of time with `unit` of them in a revolution.
static void find_exponents(const whirl_system *system, const double *start, double rtol, int revolutions, double unit,
                           whirl_estimate *exponents, double *exact_sum) {
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    whirl_record *record;
    strcpy(integrate.method, "dop853");
    integrate.rtol = rtol;
    integrate.atol = 0.01 * rtol;
    integrate.steps_per_revolution = 64;
    options.transient = 200;
    options.record = options.watch = revolutions;
    options.waveform = false;
    options.growth = WHIRL_GROWTH_ALL;
    require_ok(whirl_record_motion(system, &integrate, &options, start, NULL, &record));
    assert_true(whirl_lyapunov_spectrum(record, exponents));
    const size_t first = record->growth_count / 10;
    *exact_sum = 0.0;
    for (size_t i = first; i < record->growth_count; i++)
        *exact_sum += record->volume[i] / (double)(record->growth_count - first) / unit;
    for (size_t k = 0; k < system->dimension; k++) {
        exponents[k].value /= unit;
        exponents[k].error /= unit;
    }
    whirl_record_free(record);
}

static double sum_of(const whirl_estimate *exponents, size_t count) {
    double sum = 0.0;
    for (size_t k = 0; k < count; k++) sum += exponents[k].value;
    return sum;
}

// ---------------------------------------------------------------- films

static void a7_multipliers(void **unused) {
    (void)unused;
    static const struct {
        double e;
        const char *modulus;
    } rows[] = {{0.3, ".57499"}, {0.5, ".10099"}};
    const double gam = 0.2;
    for (size_t i = 0; i < 2; i++) {
        const double e = rows[i].e;
        double force[2], matrix[16];
        whirl_film_force(e, 0.0, 0.0, e, force);
        const double along = -e - gam * force[0], across = -gam * force[1];
        const double rho = hypot(along, across), psi = atan2(across, along);
        whirl_rotor *rotor = make_film_rotor(gam, 0.0, rho);
        whirl_integrator *integrator = follow(whirl_rotor_system(rotor), 1e-12);
        double state[4] = {e * cos(psi), -e * sin(psi), e * sin(psi), e * cos(psi)};
        const double volume = monodromy(integrator, 4, state, 1, matrix);
        check_digits("A7", words("largest Floquet modulus at e = %g by exact Jacobians", e), rows[i].modulus,
                     largest_modulus(4, matrix));
        // Its smallest multipliers drown in the rounding of the largest: the determinant is checked where it does not.
        if (volume > log(1e-6))
            check_within("A7", words("ln|det| at e = %g against the divergence", e), volume,
                         log(fabs(determinant(4, matrix))), 1e-8);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

static void a8_exponents(void **unused) {
    (void)unused;
    const double start[4] = {0.1, -0.2, 0.0, 0.0};
    whirl_estimate exponents[4];
    double exact;
    whirl_rotor *rotor = make_film_rotor(0.3 / 9.0, 1.0 / 9.0, 0.4);
    find_exponents(whirl_rotor_system(rotor), start, 1e-9, 4000, 1.0, exponents, &exact);
    check_within("A8", "largest of all exponents at rho = .4", 0.43, exponents[0].value, 0.03);
    check_within("A8", "sum of all exponents at rho = .4, against the divergence", exact, sum_of(exponents, 4), 1e-6);
    whirl_rotor_free(rotor);
}

/// A journal at rest under its weight: e = .5, s = 2.5, whose slowest eigenvalues by the linear coefficients of A4 are
/// a pair. By the default tolerance, from near the equilibrium and from far away.
static void equilibrium_film(void **unused) {
    (void)unused;
    const double e = 0.5, s = 2.5, real = -0.00246625; // per radian, to half a unit of the last digit
    const double phi = atan2(pi * sqrt(1.0 - e * e), 4.0 * e);
    const double sigma = pow(1.0 - e * e, 2) / (e * sqrt(16.0 * e * e + pi * pi * (1.0 - e * e)));
    const double starts[2][4] = {{e * sin(phi) + 1e-6, -e * cos(phi), 0.0, 0.0}, {0.75, 0.0, 0.37, 0.0}};
    whirl_rotor *rotor = make_film_rotor(sigma / (s * s), 1.0 / (s * s), 0.0);
    for (int far = 0; far < 2; far++) {
        const char *from = far ? "far" : "near";
        whirl_estimate exponents[4];
        double exact, state[4];
        whirl_integrator *integrator = follow(whirl_rotor_system(rotor), 1e-9);
        memcpy(state, starts[far], sizeof state);
        revolve(integrator, state, 1500);
        whirl_integrator_free(integrator);
        find_exponents(whirl_rotor_system(rotor), state, 1e-9, 600, 1.0, exponents, &exact);
        check_within("A5", words("journal at rest, e = .5, s = 2.5: mean of its two largest exponents, from %s", from),
                     2.0 * pi * real, 0.5 * (exponents[0].value + exponents[1].value), 2.0 * pi * 5e-9);
        check_within("A5", words("journal at rest: sum of all exponents against the divergence, from %s", from), exact,
                     sum_of(exponents, 4), 1e-8);
    }
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- shafts

/// At rest, with damping, by the default tolerance: the multiplier is that of B2's equations by an independent program.
static void equilibrium_exponents(void **unused) {
    (void)unused;
    const shaft_case p = {.speed = 1.0, .damping = 0.1, .k1 = 0.8, .k2 = 1.2};
    const double start[4] = {0.0};
    whirl_rotor *rotor = make_shaft_rotor(&p);
    whirl_estimate exponents[4];
    double exact;
    find_exponents(whirl_rotor_system(rotor), start, 1e-9, 400, 1.0, exponents, &exact);
    check_within("B2", "at rest, c = .1, w = 1: largest exponent", log(1.368505096442), exponents[0].value, 1e-9);
    check_within("B2", "at rest, c = .1, w = 1: sum of all exponents, -2 c T", -4.0 * pi * 0.1, sum_of(exponents, 4),
                 1e-8);
    whirl_rotor_free(rotor);
}

static void b2_multipliers(void **unused) {
    (void)unused;
    for (size_t i = 0; i < CASE_B2_ROWS; i++)
        for (int printed = 0; printed < 2; printed++) {
            const shaft_case p = {.speed = case_b2[i].speed, .k1 = 0.8, .k2 = 1.2, .printed_signs = printed == 1};
            double state[4] = {0.0}, matrix[16];
            whirl_rotor *rotor = make_shaft_rotor(&p);
            whirl_integrator *integrator = follow(whirl_rotor_system(rotor), 1e-15);
            monodromy(integrator, 4, state, 1, matrix);
            check_digits(
                "B2", words("by exact Jacobians, w = %g, %s signs", case_b2[i].speed, printed ? "printed" : "derived"),
                printed ? case_b2[i].printed : case_b2[i].derived, largest_modulus(4, matrix));
            whirl_integrator_free(integrator);
            whirl_rotor_free(rotor);
        }
}

// ---------------------------------------------------------------- rubs

static void c2_stability(void **unused) {
    (void)unused;
    for (size_t i = 0; i < CASE_C2_ROWS; i++) {
        double state[4], matrix[16];
        const rub_case p = start_case_c2(i, state);
        whirl_rotor *rotor = make_rub_rotor(&p);
        whirl_integrator *integrator = follow(whirl_rotor_system(rotor), 1e-12);
        monodromy(integrator, 4, state, 1, matrix);
        check_digits("C2", words("largest real part by exact Jacobians at %s", case_c2[i].name), case_c2[i].growth,
                     log(largest_modulus(4, matrix)) * p.speed / (2.0 * pi));
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

static rub_case c4_case(double speed) {
    return (rub_case){.speed = speed, .zeta = 0.1, .kappa = 10.0, .eccentricity = 0.9, .friction = 0.05, .weight = 0.5};
}

static void check_multiplier(const char *what, const double *matrix, const char *real, const char *imaginary) {
    double complex values[4];
    const double complex printed = strtod(real, NULL) + I * strtod(imaginary, NULL);
    size_t best = 0;
    eigenvalues(4, matrix, values);
    for (size_t i = 1; i < 4; i++)
        if (cabs(values[i] - printed) < cabs(values[best] - printed)) best = i;
    check_digits("C4", words("%s, real part of a multiplier by exact Jacobians", what), real, creal(values[best]));
    if (strtod(imaginary, NULL) != 0.0)
        check_digits("C4", words("%s, imaginary part of it", what), imaginary, cimag(values[best]));
}

static void c4_multipliers(void **unused) {
    (void)unused;
    static const struct {
        double speed, x, y;
        int period;
        const char *pair[2], *real[2], *name;
    } rows[] = {
        {1.5, 1.3284851484, -0.3705078967, 1, {".54774858", ".61278587"}, {"-.588909", "-.47058333"}, "w = 1.5"},
        {3.8, -1.0595706503, -0.5024893815, 4, {"-.42213556", ".4797482"}, {".65282916", ".26620254"}, "w = 3.8"}};
    for (size_t i = 0; i < 2; i++) {
        const rub_case p = c4_case(rows[i].speed);
        double state[4] = {0.1, -0.2, 0.0, 0.0}, matrix[16];
        whirl_rotor *rotor = make_rub_rotor(&p);
        whirl_integrator *integrator = follow(whirl_rotor_system(rotor), 1e-13);
        revolve(integrator, state, 400);
        for (int n = 0; n < 4 && hypot(state[0] - rows[i].x, state[1] - rows[i].y) > 1e-6; n++)
            revolve(integrator, state, 1);
        // The printed point and Newton's method from there, by the exact monodromy.
        for (int newton = 0; newton < 5; newton++) {
            double end[4], residual[4];
            memcpy(end, state, sizeof end);
            monodromy(integrator, 4, end, rows[i].period, matrix);
            for (int k = 0; k < 4; k++) {
                residual[k] = end[k] - state[k];
                matrix[5 * k] -= 1.0;
            }
            solve_linear(4, matrix, residual);
            for (int k = 0; k < 4; k++) state[k] -= residual[k];
        }
        const double volume = monodromy(integrator, 4, state, rows[i].period, matrix);
        check_multiplier(rows[i].name, matrix, rows[i].pair[0], rows[i].pair[1]);
        check_multiplier(rows[i].name, matrix, rows[i].real[0], "0");
        check_multiplier(rows[i].name, matrix, rows[i].real[1], "0");
        const double exact = -4.0 * p.zeta * 2.0 * pi * rows[i].period / p.speed;
        check_within("C4", words("%s, ln of the product of the multipliers", rows[i].name), exact,
                     log(fabs(determinant(4, matrix))), 1e-10);
        check_within("C4", words("%s, the same by the divergence", rows[i].name), exact, volume, 1e-12);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

static void c4_exponents(void **unused) {
    (void)unused;
    const double start[4] = {0.1, -0.2, 0.0, 0.0};
    const rub_case p = c4_case(3.3);
    whirl_estimate exponents[4];
    double exact;
    whirl_rotor *rotor = make_rub_rotor(&p);
    find_exponents(whirl_rotor_system(rotor), start, 1e-9, 12000, 2.0 * pi / p.speed, exponents, &exact);
    check_within("C4", "largest of all exponents by time at w = 3.3", 0.180, exponents[0].value,
                 hypot(0.004, 3.0 * exponents[0].error));
    check_within("C4", "sum of all exponents by time at w = 3.3", -4.0 * p.zeta, sum_of(exponents, 4), 1e-6);
    check_within("C4", "the same by the divergence", -4.0 * p.zeta, exact, 1e-12);
    whirl_rotor_free(rotor);
}

/// A disc alone in a stator with a damped contact.
static whirl_rotor *make_damped_rotor(double stiffness, double damping) {
    whirl_design *design;
    whirl_rotor *rotor;
    const whirl_setting mass[] = {{"mass", 1.0, NULL}};
    const whirl_setting rub[] = {
        {"at", 0.0, "disc"}, {"gap", 1.0, NULL}, {"stiffness", stiffness, NULL}, {"damping", damping, NULL}};
    require_ok(whirl_design_new(1.0, 1.0, &design));
    require_ok(whirl_design_station(design, "disc", mass, 1));
    require_ok(whirl_design_element(design, "rub", rub, 4));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Contact lasts until stiffness and damping together push no more: tan(wd t) = 2 z sqrt(1 - z^2)/(2 z^2 - 1).
static void c5_restitution(void **unused) {
    (void)unused;
    const double w = 5.0, speed = 0.2, start = 0.8;
    for (int i = 0; i < 3; i++) {
        const double z = (const double[]){0.05, 0.3, 0.65}[i], root = sqrt(1.0 - z * z);
        whirl_rotor *rotor = make_damped_rotor(w * w, 2.0 * z * w);
        const double lasts = (pi - atan(2.0 * z * root / (1.0 - 2.0 * z * z))) / (root * w);
        const double depth = speed / (root * w) * exp(-z * w * lasts) * sin(root * w * lasts);
        const double kept = exp(-z * w * lasts), away = speed * kept;
        const double free_flight = 2.0 * pi - (1.0 - start) / speed - lasts;
        whirl_integrator *integrator = follow(whirl_rotor_system(rotor), 1e-13);
        double x[4] = {start, 0.0, speed, 0.0}, matrix[16];
        const double volume = monodromy(integrator, 4, x, 1, matrix);
        check_within("C5", words("damping ratio %g: speed after the impact", z), -away, x[2], 1e-11);
        check_within("C5", words("damping ratio %g: place after the impact", z), 1.0 + depth - away * free_flight, x[0],
                     1e-11);
        // A later start meets the wall later with the same speed; a faster one earlier, with all lengths in proportion.
        check_within("C5", words("damping ratio %g: d place/d place at the start", z), -kept, matrix[0], 1e-10);
        check_within("C5", words("damping ratio %g: d speed/d place", z), 0.0, matrix[8], 1e-10);
        check_within("C5", words("damping ratio %g: d place/d speed", z),
                     depth / speed - kept * free_flight - kept * (1.0 - start) / speed, matrix[2], 1e-10);
        check_within("C5", words("damping ratio %g: d speed/d speed", z), -kept, matrix[10], 1e-10);
        check_within("C5", words("damping ratio %g: ln|det| against the divergence and ln|det S|", z), volume,
                     log(fabs(determinant(4, matrix))), 1e-10);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

// ---------------------------------------------------------------- flows that a user writes

typedef struct oscillator {
    double damping, stiffness, cubic, force, frequency;
} oscillator;

static void oscillator_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const oscillator *o = model;
    (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] =
        o->force * cos(o->frequency * t) - o->damping * x[1] - o->stiffness * x[0] - o->cubic * x[0] * x[0] * x[0];
}

static void oscillator_tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                               size_t count, const double *dx, double *ddxdt) {
    const oscillator *o = model;
    (void)t, (void)forcing, (void)sides;
    for (size_t k = 0; k < count; k++, dx += 2, ddxdt += 2) {
        ddxdt[0] = dx[1];
        ddxdt[1] = -(o->stiffness + 3.0 * o->cubic * x[0] * x[0]) * dx[0] - o->damping * dx[1];
    }
}

static double oscillator_divergence(const void *model, double t, const double *forcing, const double *x,
                                    const double *sides) {
    (void)t, (void)forcing, (void)x, (void)sides;
    return -((const oscillator *)model)->damping;
}

static void d1_lorenz(void **unused) {
    (void)unused;
    static const double r = 28.0;
    const whirl_system lorenz = {.dimension = 3,
                                 .period = 1.0,
                                 .rhs = lorenz_rhs,
                                 .tangent = lorenz_tangent,
                                 .divergence = lorenz_divergence,
                                 .model = &r};
    const double start[3] = {1.0, 1.0, 20.0};
    whirl_estimate exponents[3];
    double exact;
    find_exponents(&lorenz, start, 1e-9, 60000, 1.0, exponents, &exact);
    check_within("D1", "Lorenz, all exponents: largest", 0.9056, exponents[0].value,
                 hypot(0.0003, 3.0 * exponents[0].error));
    check_within("D1", "Lorenz, all exponents: second", 0.0, exponents[1].value, 3.0 * exponents[1].error + 1e-4);
    check_within("D1", "Lorenz, all exponents: third", -14.5722, exponents[2].value,
                 hypot(0.0003, 3.0 * exponents[2].error));
    check_within("D1", "Lorenz, all exponents: sum", -41.0 / 3.0, sum_of(exponents, 3), 1e-6);
    check_within("D1", "Lorenz: the same by the divergence", -41.0 / 3.0, exact, 1e-10);
    // 2 + (l1 + l2)/|l3|, 2.0621 with the printed exponents.
    check_within("D1", "Lorenz: Kaplan-Yorke dimension", 2.0 + 0.9056 / 14.5722, whirl_kaplan_yorke(exponents, 3),
                 5e-4);
}

static void d1_oscillators(void **unused) {
    (void)unused;
    static const struct {
        oscillator o;
        double exponent, tolerance;
        const char *name;
    } rows[] = {{{0.05, 0.0, 1.0, 7.5, 1.0}, 0.1034, 0.0003, "Ueda"},
                {{0.3, -1.0, 1.0, 0.5, 1.2}, 0.1044, 0.0005, "two wells"}};
    for (size_t i = 0; i < 2; i++) {
        const oscillator *o = &rows[i].o;
        const whirl_system system = {.dimension = 2,
                                     .period = 2.0 * pi / o->frequency,
                                     .rhs = oscillator_rhs,
                                     .tangent = oscillator_tangent,
                                     .divergence = oscillator_divergence,
                                     .model = o};
        const double start[2] = {1.0, 0.0};
        whirl_estimate exponents[2];
        double exact;
        find_exponents(&system, start, 1e-9, 20000, system.period, exponents, &exact);
        check_within("D1", words("%s, all exponents: largest", rows[i].name), rows[i].exponent, exponents[0].value,
                     3.0 * hypot(rows[i].tolerance, exponents[0].error));
        check_within("D1", words("%s, all exponents: sum", rows[i].name), -o->damping, sum_of(exponents, 2), 1e-6);
        check_within("D1", words("%s: the same by the divergence", rows[i].name), -o->damping, exact, 1e-10);
    }
}

static void mathieu_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const mathieu *m = model;
    (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = -(m->a - 2.0 * m->q * cos(2.0 * t)) * x[0];
}

static void mathieu_tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                            size_t count, const double *dx, double *ddxdt) {
    (void)x, (void)sides;
    for (size_t k = 0; k < count; k++) mathieu_rhs(model, t, forcing, dx + 2 * k, ddxdt + 2 * k);
}

static void d3_mathieu(void **unused) {
    (void)unused;
    for (size_t i = 0; i < 2 * CASE_D3_ROWS; i++) {
        const bool at_rest = i >= CASE_D3_ROWS;
        const size_t row = i % CASE_D3_ROWS;
        const whirl_system system = {
            .dimension = 2, .period = pi, .rhs = mathieu_rhs, .tangent = mathieu_tangent, .model = &case_d3[row].m};
        whirl_integrator *integrator = follow(&system, 1e-15);
        double state[2] = {at_rest ? 0.0 : 1.0, at_rest ? 0.0 : 0.5}, matrix[4];
        monodromy(integrator, 2, state, 1, matrix);
        check_digits("D3",
                     words("trace by the system's Jacobian, (a, q) = (%g, %g)%s", case_d3[row].m.a, case_d3[row].m.q,
                           at_rest ? ", at rest" : ""),
                     case_d3[row].trace, matrix[0] + matrix[3]);
        whirl_integrator_free(integrator);
    }
}

// ---------------------------------------------------------------- second trajectories

/// A disc that comes to rest under its weight, x'' + 3 x' + x = 0, has the exponents (-3 +- sqrt 5)/2 per radian. Then
/// neither the disc nor its perturbed copy moves, and no error of the state limits a step.
static void d1_disc_at_rest(void **unused) {
    (void)unused;
    static const char *const methods[] = {"rk4", "dop853", "rodas5p", "cvode-adams", "cvode-bdf"};
    const shaft_case p = {.speed = 1.0, .damping = 3.0, .k1 = 1.0, .k2 = 1.0, .gravity = 1.0};
    const double start[4] = {0.3, 0.0, 0.0, 0.0};
    whirl_rotor *rotor = make_shaft_rotor(&p);
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        whirl_integrate_options integrate = whirl_integrate_default();
        whirl_record_options options = whirl_record_default();
        whirl_record *record;
        strcpy(integrate.method, methods[i]);
        integrate.steps_per_revolution = 128;
        options.transient = 20;
        options.record = options.watch = 100;
        options.waveform = false;
        require_ok(whirl_record_motion(whirl_rotor_system(rotor), &integrate, &options, start, NULL, &record));
        check_within("D1", words("disc at rest under its weight: largest exponent by %s", methods[i]),
                     pi * (sqrt(5.0) - 3.0), whirl_lyapunov_largest(record).value, 1e-5);
        whirl_record_free(record);
    }
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- saltation

/// Largest difference between the monodromy and central differences of the flow, over the monodromy's size; the motion
/// goes on.
static double compare_with_flow(whirl_integrator *integrator, double *state, double step) {
    double theirs[16], ours[16], worst = 0.0, size = 0.0;
    flow_jacobian(integrator, 4, state, 1, step, theirs);
    monodromy(integrator, 4, state, 1, ours);
    for (int i = 0; i < 16; i++) {
        worst = fmax(worst, fabs(ours[i] - theirs[i]));
        size = fmax(size, fabs(ours[i]));
    }
    return worst / size;
}

static whirl_rotor *make_impact_rotor(double damping) {
    whirl_design *design;
    whirl_rotor *rotor;
    const whirl_setting disc[] = {{"mass", 1.0, NULL}, {"damping", 0.2, NULL}, {"eccentricity", 0.9, NULL}};
    const whirl_setting shaft[] = {{"between", 0.0, "disc, ground"}, {"k1", 1.0, NULL}};
    const whirl_setting rub[] = {{"at", 0.0, "disc"},
                                 {"gap", 1.0, NULL},
                                 {"stiffness", 10.0, NULL},
                                 {"friction", 0.05, NULL},
                                 {"damping", damping, NULL}};
    const whirl_setting gravity[] = {{"acceleration", 0.5, NULL}};
    require_ok(whirl_design_new(3.3, 1.0, &design));
    require_ok(whirl_design_station(design, "disc", disc, 3));
    require_ok(whirl_design_element(design, "shaft", shaft, 2));
    require_ok(whirl_design_element(design, "rub", rub, 5));
    require_ok(whirl_design_element(design, "gravity", gravity, 1));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

static void d5_impacts(void **unused) {
    (void)unused;
    for (int i = 0; i < 2; i++) {
        const double damping = i ? 1.5 : 0.3;
        whirl_rotor *rotor = make_impact_rotor(damping);
        whirl_integrator *integrator = follow(whirl_rotor_system(rotor), 1e-13);
        double state[4] = {0.1, -0.2, 0.0, 0.0}, worst = 0.0;
        revolve(integrator, state, 20);
        for (int n = 0; n < 20; n++) worst = fmax(worst, compare_with_flow(integrator, state, 1e-5));
        check_within(
            "D5",
            words("impacts with contact damping %g: monodromy of 20 revolutions against differences of the flow",
                  damping),
            0.0, worst, 1e-6);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

static void d5_reversals_of_the_slip(void **unused) {
    (void)unused;
    // A disc in backward whirl: the slip reverses at bounces, and at times the disc rolls.
    const rub_case p = {.speed = 3.0,
                        .zeta = 0.05,
                        .kappa = 25.0,
                        .friction = 0.1,
                        .eccentricity = 0.3,
                        .follows_slip = true,
                        .surface_radius = 1.0,
                        .weight = 0.2};
    whirl_rotor *rotor = make_rub_rotor(&p);
    whirl_integrator *integrator = follow(whirl_rotor_system(rotor), 1e-13);
    double state[4] = {1.3, 0.0, 0.3, -1.5}, worst = 0.0;
    int compared = 0;
    for (int n = 0; n < 10; n++) {
        const double r = hypot(state[0], state[1]);
        const double slip = p.surface_radius * r + state[0] * state[3] - state[1] * state[2];
        // If a revolution begins with rolling, neighbouring starts are drawn to it at once: their differences are
        // one-sided.
        const bool rolls = r > 1.0 && fabs(slip) < 1e-9;
        const double difference = compare_with_flow(integrator, state, 1e-5);
        if (rolls) continue;
        worst = fmax(worst, difference);
        compared++;
    }
    check_within(
        "D5",
        words("slip that reverses, rolling: monodromy of %d revolutions against differences of the flow", compared),
        0.0, worst, 1e-6);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equilibrium_film),
        cmocka_unit_test(a7_multipliers),
        cmocka_unit_test(a8_exponents),
        cmocka_unit_test(b2_multipliers),
        cmocka_unit_test(equilibrium_exponents),
        cmocka_unit_test(c2_stability),
        cmocka_unit_test(c4_multipliers),
        cmocka_unit_test(c4_exponents),
        cmocka_unit_test(c5_restitution),
        cmocka_unit_test(d1_lorenz),
        cmocka_unit_test(d1_oscillators),
        cmocka_unit_test(d1_disc_at_rest),
        cmocka_unit_test(d3_mathieu),
        cmocka_unit_test(d5_impacts),
        cmocka_unit_test(d5_reversals_of_the_slip),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
