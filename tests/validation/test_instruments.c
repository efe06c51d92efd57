// Cases D1 to D4: exponents, verdicts and flow maps on systems that a user of the library writes.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "lorenz.h"
#include "support_cases.h"
#include "support_check.h"
#include "support_flow.h"
#include "support_record.h"
#include "support_tangent.h"

static const double pi = 3.14159265358979323846;

/// x'' + damping x' + stiffness x + cubic x^3 + pendulum sin x = force cos(frequency t).
typedef struct oscillator {
    double damping, stiffness, cubic, pendulum, force, frequency;
} oscillator;

static const whirl_probe oscillator_probe = {.name = "x", .vx = 1, .vy = 1};

static void oscillator_forcing(const void *model, double t, double *forcing) {
    const oscillator *o = model;
    forcing[0] = o->force * cos(o->frequency * t);
}

static void oscillator_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const oscillator *o = model;
    (void)t;
    dxdt[0] = x[1];
    dxdt[1] = forcing[0] - o->damping * x[1] - o->stiffness * x[0] - o->cubic * x[0] * x[0] * x[0];
    if (o->pendulum != 0.0) dxdt[1] -= o->pendulum * sin(x[0]);
}

static void oscillator_jacobian(const void *parameters, double t, const double *x, double *jacobian) {
    const oscillator *o = parameters;
    (void)t;
    jacobian[0] = 0.0;
    jacobian[1] = 1.0;
    jacobian[2] = -o->stiffness - 3.0 * o->cubic * x[0] * x[0] - o->pendulum * cos(x[0]);
    jacobian[3] = -o->damping;
}

static whirl_system make_oscillator(const oscillator *o) {
    return (whirl_system){.dimension = 2,
                          .period = 2.0 * pi / o->frequency,
                          .forcing_count = 1,
                          .forcing = oscillator_forcing,
                          .rhs = oscillator_rhs,
                          .probe_count = 1,
                          .probes = &oscillator_probe,
                          .model = o};
}

static void lorenz_jacobian(const void *parameters, double t, const double *x, double *jacobian) {
    const double matrix[9] = {-10.0, 10.0, 0.0, 28.0 - x[2], -1.0, -x[0], x[1], x[0], -8.0 / 3.0};
    (void)parameters, (void)t;
    for (int i = 0; i < 9; i++) jacobian[i] = matrix[i];
}

static const whirl_probe lorenz_probe = {.name = "x", .y = 1, .vy = 1};
static const double lorenz_r = 28.0;
/// One unit of time stands for a revolution.
static const whirl_system lorenz = {
    .dimension = 3, .period = 1.0, .rhs = lorenz_rhs, .probe_count = 1, .probes = &lorenz_probe, .model = &lorenz_r};

/// A flow with its printed exponent and error.
typedef struct d1_row {
    const char *name;
    whirl_system system;
    jacobian_fn jacobian;
    double start[3];
    int steps, revolutions;
    double exponent, tolerance, sum;
    bool doubtful; ///< the printed error is taken for a standard error: see docs/verification-manual.md
} d1_row;

/// Computes all exponents [n] per unit of time by variational equations, from the end of the record.
static void find_spectrum(const d1_row *row, const whirl_record *record, int steps, int revolutions,
                          double *exponents) {
    double state[3];
    const tangent_model model = {&row->system, row->jacobian, row->system.model};
    const whirl_system joint = make_tangent_system(&model);
    whirl_integrator *integrator = make_integrator(&joint, "rk4", steps);
    for (size_t i = 0; i < row->system.dimension; i++) state[i] = record->end[i];
    lyapunov_spectrum(integrator, row->system.dimension, state, 20, revolutions, exponents);
    for (size_t i = 0; i < row->system.dimension; i++) exponents[i] /= row->system.period;
    whirl_integrator_free(integrator);
}

static void check_spectrum(const d1_row *row, const whirl_record *record) {
    const int share = row->doubtful ? 4 : 24; // of the record's length, with so much more error
    const whirl_estimate twin = whirl_lyapunov_largest(record);
    const double error = sqrt(1.0 + share) * twin.error / row->system.period;
    double exponents[3], sum = 0.0;
    find_spectrum(row, record, row->steps, row->revolutions / share, exponents);
    check_within("D1", words("%s: largest exponent, variational equations against the library's", row->name),
                 exponents[0], twin.value / row->system.period, 3.0 * error);
    if (row->system.dimension == 3)
        check_within("D1", words("%s: third exponent", row->name), -14.5722, exponents[2], 3.0 * error);

    // The flow contracts volumes exactly so; RK4 does so to the fourth power of its step.
    find_spectrum(row, record, 8 * row->steps, 200, exponents);
    for (size_t i = 0; i < row->system.dimension; i++) sum += exponents[i];
    check_within("D1", words("%s: sum of the exponents", row->name), row->sum, sum, 1e-7);
}

static void check_d1(const d1_row *row) {
    whirl_record *record = record_motion(&row->system, row->start, row->steps, 200, row->revolutions);
    check_regime("D1", words("%s: regime", row->name), "chaotic", record);
    const whirl_estimate own = whirl_lyapunov_largest(record);
    if (row->doubtful) {
        const double value = own.value / row->system.period, error = own.error / row->system.period;
        note_within("D1", words("%s: largest exponent", row->name), row->exponent, value, row->tolerance);
        check_within("D1", words("%s: largest exponent, both errors taken as standard errors", row->name),
                     row->exponent, value, 3.0 * hypot(row->tolerance, error));
    } else
        check_exponent("D1", words("%s: largest exponent", row->name), row->exponent, row->tolerance, record,
                       row->system.period);
    check_spectrum(row, record);
    whirl_record_free(record);
}

static void d1_lorenz(void **unused) {
    (void)unused;
    const d1_row row = {"Lorenz", lorenz, lorenz_jacobian, {1.0, 1.0, 20.0}, 100,
                        1500000,  0.9056, 0.0003,          -41.0 / 3.0,      false};
    check_d1(&row);
}

static void d1_ueda(void **unused) {
    (void)unused;
    const oscillator o = {.damping = 0.05, .cubic = 1.0, .force = 7.5, .frequency = 1.0};
    const d1_row row = {
        "Ueda", make_oscillator(&o), oscillator_jacobian, {1.0, 0.0}, 128, 900000, 0.1034, 0.0003, -0.05, false};
    check_d1(&row);
}

static void d1_two_wells(void **unused) {
    (void)unused;
    const oscillator o = {.damping = 0.3, .stiffness = -1.0, .cubic = 1.0, .force = 0.5, .frequency = 1.2};
    const d1_row row = {
        "two wells", make_oscillator(&o), oscillator_jacobian, {1.0, 0.0}, 128, 300000, 0.1044, 0.0005, -0.3, true};
    check_d1(&row);
}

static void d1_pendulum(void **unused) {
    (void)unused;
    const oscillator o = {.damping = 0.5, .pendulum = 1.0, .force = 1.15, .frequency = 2.0 / 3.0};
    static const double turns[] = {6.283185307179586476925, 0.0};
    d1_row row = {"pendulum", make_oscillator(&o), oscillator_jacobian, {1.0, 0.0}, 128, 540000, 0.0995, 0.0005, -0.5,
                  false};
    row.system.angles = turns;
    check_d1(&row);
}

static void d2_regimes(void **unused) {
    (void)unused;
    static const struct {
        double force;
        const char *regime;
    } rows[] = {{0.20, "P-1"}, {0.28, "P-2"}, {0.29, "P-4"}, {0.37, "P-5"}, {0.50, "chaotic"}, {0.65, "P-2"}};
    const double start[2] = {1.0, 0.0};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const oscillator o = {
            .damping = 0.3, .stiffness = -1.0, .cubic = 1.0, .force = rows[i].force, .frequency = 1.2};
        const whirl_system system = make_oscillator(&o);
        whirl_record *record = record_motion(&system, start, 256, 600, 600);
        check_regime("D2", words("regime at gam = %.2f", rows[i].force), rows[i].regime, record);
        if (i == 0) {
            const printed_point point = {".56838897", ".41272660"};
            double state[2];
            whirl_integrator *integrator = make_integrator(&system, "rk4", 4096);
            check_orbit("D2", "gam = .20", record, integrator, 1, &point, 1, state);
            whirl_integrator_free(integrator);
        }
        whirl_record_free(record);
    }
}

static void mathieu_forcing(const void *model, double t, double *forcing) {
    const mathieu *m = model;
    forcing[0] = m->a - 2.0 * m->q * cos(2.0 * t);
}

static void mathieu_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)t;
    dxdt[0] = x[1];
    dxdt[1] = -forcing[0] * x[0];
}

static void d3_mathieu(void **unused) {
    (void)unused;
    for (size_t i = 0; i < CASE_D3_ROWS; i++) {
        const whirl_system system = {.dimension = 2,
                                     .period = pi,
                                     .forcing_count = 1,
                                     .forcing = mathieu_forcing,
                                     .rhs = mathieu_rhs,
                                     .model = &case_d3[i].m};
        whirl_integrator *integrator = make_integrator(&system, "rk4", 4096);
        double first[2] = {1.0, 0.0}, second[2] = {0.0, 1.0};
        revolve(integrator, first, 1);
        revolve(integrator, second, 1);
        check_digits("D3", words("trace of the monodromy, (a, q) = (%g, %g)", case_d3[i].m.a, case_d3[i].m.q),
                     case_d3[i].trace, first[0] + second[1]);
        check_within("D3", "determinant", 1.0, first[0] * second[1] - first[1] * second[0], 1e-12);
        whirl_integrator_free(integrator);
    }
}

/// x'' - mu (1 - x^2) x' + x = 0 in time by its period: t = period s.
typedef struct van_der_pol {
    double mu, period;
} van_der_pol;

static void van_der_pol_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const van_der_pol *v = model;
    (void)t, (void)forcing;
    dxdt[0] = v->period * x[1];
    dxdt[1] = v->period * (v->mu * (1.0 - x[0] * x[0]) * x[1] - x[0]);
}

/// Computes end - start after one period for a start at x = 0 with that velocity.
static void period_residual(van_der_pol v, double velocity, double residual[2]) {
    const whirl_system system = {.dimension = 2, .period = 1.0, .rhs = van_der_pol_rhs, .model = &v};
    whirl_integrator *integrator = make_integrator(&system, "rk4", 65536);
    residual[0] = 0.0;
    residual[1] = velocity;
    revolve(integrator, residual, 1);
    residual[1] -= velocity;
    whirl_integrator_free(integrator);
}

/// Finds the velocity at which x passes 0 upwards after a transient, and the time between two passes, to a hundredth.
static void approach_orbit(double mu, double *velocity, double *period) {
    const double step = 0.01;
    const van_der_pol v = {mu, step};
    const whirl_system system = {.dimension = 2, .period = 1.0, .rhs = van_der_pol_rhs, .model = &v};
    whirl_integrator *integrator = make_integrator(&system, "rk4", 16);
    double x[2] = {1.0, 0.0}, before = 1.0, passed = 0.0;
    for (int i = 0; i < 10000; i++) {
        revolve(integrator, x, 1);
        if (before <= 0.0 && x[0] > 0.0) {
            *velocity = x[1];
            *period = i * step - passed;
            passed = i * step;
        }
        before = x[0];
    }
    whirl_integrator_free(integrator);
}

/// Returns the period of the closed orbit, by Newton's method for (velocity, period).
static double van_der_pol_period(double mu) {
    double velocity = 0.0, period = 0.0;
    approach_orbit(mu, &velocity, &period);
    for (int i = 0; i < 12; i++) {
        const double step = 1e-6;
        double here[2], faster[2], longer[2];
        period_residual((van_der_pol){mu, period}, velocity, here);
        period_residual((van_der_pol){mu, period}, velocity + step, faster);
        period_residual((van_der_pol){mu, period + step}, velocity, longer);
        const double matrix[4] = {(faster[0] - here[0]) / step, (longer[0] - here[0]) / step,
                                  (faster[1] - here[1]) / step, (longer[1] - here[1]) / step};
        solve_linear(2, matrix, here);
        velocity -= here[0];
        period -= here[1];
    }
    return period;
}

static void d4_van_der_pol(void **unused) {
    (void)unused;
    check_digits("D4", "period at mu = 1", "6.6632868593", van_der_pol_period(1.0));
    check_digits("D4", "period at mu = 5", "11.6122306677", van_der_pol_period(5.0));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(d1_lorenz),      cmocka_unit_test(d1_ueda),    cmocka_unit_test(d1_two_wells),
        cmocka_unit_test(d1_pendulum),    cmocka_unit_test(d2_regimes), cmocka_unit_test(d3_mathieu),
        cmocka_unit_test(d4_van_der_pol),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
