// Cases C1 to C4: a Jeffcott rotor that rubs its stator. Lengths in the gap, time in 1/omega_n.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_cases.h"
#include "support_check.h"
#include "support_flow.h"
#include "support_record.h"
#include "support_rotor.h"
#include "support_tangent.h"

static const double pi = 3.14159265358979323846;

/// Computes d(dx/dtau)/dx of a rub_case with friction that never reverses: r = |z|, d[(1 - 1/r) x_i]/dx_j = (1 - 1/r)
/// delta_ij + x_i x_j/r^3.
static void rub_jacobian(const void *parameters, double t, const double *s, double *jacobian) {
    const rub_case *p = parameters;
    const double w2 = p->speed * p->speed, r = hypot(s[0], s[1]);
    const double k = r > 1.0 ? p->kappa : 0.0, push = 1.0 - 1.0 / fmax(r, 1e-9), r3 = fmax(r * r * r, 1e-27);
    const double xx = push + s[0] * s[0] / r3, xy = s[0] * s[1] / r3, yy = push + s[1] * s[1] / r3;
    const double f = p->friction, damping = 2.0 * p->zeta / p->speed;
    const double matrix[16] = {0.0,
                               0.0,
                               1.0,
                               0.0,
                               0.0,
                               0.0,
                               0.0,
                               1.0,
                               -(1.0 + k * (xx - f * xy)) / w2,
                               -k * (xy - f * yy) / w2,
                               -damping,
                               0.0,
                               -k * (xy + f * xx) / w2,
                               -(1.0 + k * (yy + f * xy)) / w2,
                               0.0,
                               -damping};
    (void)t;
    memcpy(jacobian, matrix, sizeof matrix);
}

/// Returns radius of the steady circle of the rotor while it does not touch.
static double free_radius(double speed) {
    const rub_case p = {.speed = speed, .zeta = 0.05, .eccentricity = 0.2};
    double state[4] = {0.0, 0.0, 0.0, 0.0}, slope[4], matrix[16], shift[4];
    whirl_rotor *rotor = make_rub_rotor(&p);
    // A circle z = R e^(i tau) is found from one instant: x' = -y, y' = x, and the accelerations -x, -y are linear in
    // R.
    evaluate_rhs(whirl_rotor_system(rotor), 0.0, state, slope);
    for (int j = 0; j < 2; j++) {
        double unit[4] = {j == 0, j == 1, j == 1 ? -1.0 : 0.0, j == 0 ? 1.0 : 0.0}, column[4];
        evaluate_rhs(whirl_rotor_system(rotor), 0.0, unit, column);
        for (int i = 0; i < 2; i++) matrix[2 * i + j] = column[2 + i] - slope[2 + i] + unit[i];
    }
    for (int i = 0; i < 2; i++) shift[i] = -slope[2 + i];
    solve_linear(2, matrix, shift);
    whirl_rotor_free(rotor);
    return hypot(shift[0], shift[1]);
}

static double find_grazing(double outside, double inside) {
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (outside + inside);
        *(free_radius(middle) < 1.0 ? &outside : &inside) = middle;
    }
    return 0.5 * (outside + inside);
}

/// Returns share of the time in contact when the rotor starts on the circle of the free rotor.
static double contact_share(double speed) {
    rub_case p = {.speed = speed, .zeta = 0.05, .eccentricity = 0.2, .friction = 0.1};
    double start[4];
    start_on_rub_circle(&p, 1.0, start);
    p.kappa = 2.0;
    whirl_rotor *rotor = make_rub_rotor(&p);
    whirl_record *record = record_motion(whirl_rotor_system(rotor), start, 1024, 200, 20);
    const double share = record->contact_share[0];
    whirl_record_free(record);
    whirl_rotor_free(rotor);
    return share;
}

static void c1_grazing(void **unused) {
    (void)unused;
    check_digits("C1", "lower speed at which the gap is just filled", "0.92518172", find_grazing(0.8, 1.0));
    check_digits("C1", "upper speed", "1.10315704", find_grazing(1.3, 1.0));
    check_within("C1", "share of contact at w = .925", 0.0, contact_share(0.925), 0.0);
    check_within("C1", "share of contact at w = .926", 1.0, contact_share(0.926), 0.0);
    check_within("C1", "share of contact at w = 1.103", 1.0, contact_share(1.103), 0.0);
    check_within("C1", "share of contact at w = 1.104", 0.0, contact_share(1.104), 0.0);
}

static void c2_synchronous_rub(void **unused) {
    (void)unused;
    for (size_t i = 0; i < CASE_C2_ROWS; i++) {
        double state[4], matrix[16];
        const rub_case p = start_case_c2(i, state);
        whirl_rotor *rotor = make_rub_rotor(&p);
        const tangent_model model = {whirl_rotor_system(rotor), rub_jacobian, &p};
        const whirl_system joint = make_tangent_system(&model);
        whirl_integrator *plain = make_integrator(model.base, "rk4", 4096);
        whirl_integrator *integrator = make_integrator(&joint, "rk4", 4096);
        find_fixed_point(plain, 4, state, 1);
        check_digits("C2", words("radius at %s", case_c2[i].name), case_c2[i].radius, hypot(state[0], state[1]));
        carry_tangents(integrator, 4, state, 1, matrix);
        // From the modulus after one revolution to a rate by time.
        const double rate = log(largest_modulus(4, matrix)) * p.speed / (2.0 * pi);
        check_digits("C2", words("largest real part at %s", case_c2[i].name), case_c2[i].growth, rate);
        whirl_integrator_free(integrator);
        whirl_integrator_free(plain);
        whirl_rotor_free(rotor);
    }
}

/// Computes the residual of a backward circle of radius r at the shaft's own speed: acceleration + r along,
/// acceleration across.
static void backward_residual(const rub_case *p, double speed, double radius, double residual[2]) {
    rub_case at = *p;
    at.speed = speed;
    const double state[4] = {radius, 0.0, 0.0, -radius};
    double slope[4];
    whirl_rotor *rotor = make_rub_rotor(&at);
    evaluate_rhs(whirl_rotor_system(rotor), 0.0, state, slope);
    whirl_rotor_free(rotor);
    residual[0] = slope[2] + radius;
    residual[1] = slope[3];
}

/// Finds speed and radius of the backward circle by Newton's method. The friction does not depend on the shaft's speed
/// here, so the shaft may turn at the speed of the whirl: then the circle closes in one revolution.
static void find_backward_whirl(const rub_case *p, double *speed, double *radius) {
    for (int iteration = 0; iteration < 40; iteration++) {
        const double step = 1e-6;
        double here[2], faster[2], wider[2];
        backward_residual(p, *speed, *radius, here);
        backward_residual(p, *speed + step, *radius, faster);
        backward_residual(p, *speed, *radius + step, wider);
        const double matrix[4] = {(faster[0] - here[0]) / step, (wider[0] - here[0]) / step,
                                  (faster[1] - here[1]) / step, (wider[1] - here[1]) / step};
        solve_linear(2, matrix, here);
        *speed -= here[0];
        *radius -= here[1];
    }
}

/// Returns largest real part far outside the gap, where the rotor with its stator is linear.
static double far_growth(const rub_case *p, double friction) {
    rub_case far = *p;
    far.friction = friction;
    far.speed = 1.0;
    const double state[4] = {1e15, 0.0, 0.0, 0.0};
    double matrix[16];
    whirl_rotor *rotor = make_rub_rotor(&far);
    rhs_jacobian(whirl_rotor_system(rotor), 0.0, state, 1e13, matrix);
    whirl_rotor_free(rotor);
    return largest_real_part(4, matrix, NULL);
}

static double critical_friction(const rub_case *p) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        *(far_growth(p, middle) > 0.0 ? &high : &low) = middle;
    }
    return 0.5 * (low + high);
}

typedef struct c3_row {
    const char *name;
    rub_case p; ///< zeta, kappa, friction
    const char *whirl_speed, *radius, *critical, *rolling;
    double surface_speed; ///< R_d w
} c3_row;

static const c3_row c3_rows[2] = {
    {"zeta = .05",
     {.zeta = 0.05, .kappa = 25.0, .friction = 0.1},
     "1.618033988750",
     "1.069200083003",
     ".020396078054",
     "6.3838636",
     30.0},
    {"zeta = .02",
     {.zeta = 0.02, .kappa = 4.0, .friction = 0.1},
     "1.219803902719",
     "1.138926726602",
     ".022360679775",
     "4.0000000",
     8.0},
};

static void c3_backward_whirl(void **unused) {
    (void)unused;
    for (int i = 0; i < 2; i++) {
        const c3_row *row = &c3_rows[i];
        double speed = 1.5, radius = 1.1;
        find_backward_whirl(&row->p, &speed, &radius);
        check_digits("C3", words("whirl speed, %s", row->name), row->whirl_speed, speed);
        check_digits("C3", words("radius of the unstable whirl, %s", row->name), row->radius, radius);
        check_digits("C3", words("critical friction, %s", row->name), row->critical, critical_friction(&row->p));

        rub_case p = row->p;
        p.speed = speed;
        double state[4] = {radius, 0.0, 0.0, -radius};
        whirl_rotor *rotor = make_rub_rotor(&p);
        whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "rk4", 4096);
        revolve(integrator, state, 1);
        check_within("C3", words("distance of the whirl from its start after one turn, %s", row->name), 0.0,
                     hypot(state[0] - radius, state[1]), 1e-11);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

/// Records the motion from a backward circle of radius r, over 400 revolutions of a shaft at speed 3.
static whirl_record *record_from_circle(rub_case p, double radius, double whirl_speed, int steps) {
    p.speed = 3.0;
    const double start[4] = {radius, 0.0, 0.0, -radius * whirl_speed / p.speed};
    whirl_rotor *rotor = make_rub_rotor(&p);
    whirl_record *record = record_motion(whirl_rotor_system(rotor), start, steps, 380, 20);
    whirl_rotor_free(rotor);
    return record;
}

static void c3_friction_that_never_reverses(void **unused) {
    (void)unused;
    for (int i = 0; i < 2; i++) {
        const c3_row *row = &c3_rows[i];
        const double radius = strtod(row->radius, NULL), whirl = strtod(row->whirl_speed, NULL);
        whirl_record *record = record_from_circle(row->p, 1.02 * radius, whirl, 256);
        check_holds("C3", words("diverges from 1.02 r_u, %s", row->name), record->diverged_at > 0.0);
        check_text("C3", "verdict", "diverged", whirl_regime_name(whirl_judge(record).regime));
        whirl_record_free(record);

        record = record_from_circle(row->p, 0.98 * radius, whirl, 256);
        check_within("C3", words("decays from .98 r_u: largest radius after 380 revolutions, %s", row->name), 0.0,
                     record->max_radius[0], 1e-6);
        whirl_record_free(record);

        rub_case p = row->p;
        p.friction = 0.98 * strtod(row->critical, NULL);
        record = record_from_circle(p, 20.0, 1.0, 256);
        check_holds("C3", words("bounded with friction .98 mu_c, %s", row->name), record->diverged_at == 0.0);
        whirl_record_free(record);
    }
}

/// Returns mean radius at which the whirl settles when friction follows the slip.
static double settled_radius(const c3_row *row, double slip_speed, int steps, double *spread) {
    rub_case p = row->p;
    p.follows_slip = true;
    p.surface_radius = row->surface_speed / 3.0;
    p.slip_speed = slip_speed;
    whirl_record *record = record_from_circle(p, 1.5, strtod(row->whirl_speed, NULL), steps);
    assert_true(record->diverged_at == 0.0);
    const double middle = 0.5 * (record->max_radius[0] + record->min_radius[0]);
    *spread = record->max_radius[0] - record->min_radius[0];
    assert_true(record->backward[0] == 1.0);
    whirl_record_free(record);
    return middle;
}

static void c3_friction_that_follows_the_slip(void **unused) {
    (void)unused;
    for (int i = 0; i < 2; i++) {
        const c3_row *row = &c3_rows[i];
        // The radius of the smoothed law is smooth in the slip speed, whose limit 0 is the sharp law: Neville.
        double at[4] = {0.2, 0.1, 0.05, 0.025}, radius[4], spread;
        for (int k = 0; k < 4; k++) radius[k] = settled_radius(row, at[k], 2048, &spread);
        for (int level = 1; level < 4; level++)
            for (int k = 0; k < 4 - level; k++)
                radius[k] = (at[k] * radius[k + 1] - at[k + level] * radius[k]) / (at[k] - at[k + level]);
        check_digits("C3", words("radius of rolling, %s", row->name), row->rolling, radius[0]);
        const double sharp = settled_radius(row, 0.0, 2048, &spread);
        check_within("C3", words("the same by the sharp law, %s", row->name), strtod(row->rolling, NULL), sharp, 1e-3);
    }
}

static rub_case c4_case(double speed) {
    return (rub_case){.speed = speed, .zeta = 0.1, .kappa = 10.0, .eccentricity = 0.9, .friction = 0.05, .weight = 0.5};
}

static const double c4_start[4] = {0.1, -0.2, 0.0, 0.0};

/// Compares the multiplier that is nearest to each printed one; `imaginary` may be NULL for a real one.
static void check_multiplier(const char *what, const double *matrix, const char *real, const char *imaginary) {
    double complex values[4];
    const double complex printed = strtod(real, NULL) + I * (imaginary ? strtod(imaginary, NULL) : 0.0);
    size_t best = 0;
    eigenvalues(4, matrix, values);
    for (size_t i = 1; i < 4; i++)
        if (cabs(values[i] - printed) < cabs(values[best] - printed)) best = i;
    check_digits("C4", words("%s, real part of a multiplier", what), real, creal(values[best]));
    if (imaginary)
        check_digits("C4", words("%s, imaginary part of it", what), imaginary, cimag(values[best]));
    else
        check_within("C4", words("%s, imaginary part of it", what), 0.0, cimag(values[best]), 1e-12);
}

typedef struct c4_row {
    const char *name;
    double speed;
    int period;
    size_t count;
    printed_point points[4];
    const char *pair[2], *real[2]; ///< multipliers
} c4_row;

static void check_c4_periodic(const c4_row *row) {
    const rub_case p = c4_case(row->speed);
    double state[4], matrix[16];
    whirl_rotor *rotor = make_rub_rotor(&p);
    const tangent_model model = {whirl_rotor_system(rotor), rub_jacobian, &p};
    const whirl_system joint = make_tangent_system(&model);
    whirl_record *record = record_motion(model.base, c4_start, 1024, 400, 400);
    whirl_integrator *plain = make_integrator(model.base, "cvode-adams", 1);
    whirl_integrator *integrator = make_integrator(&joint, "cvode-adams", 1);
    check_regime("C4", words("regime at %s", row->name), words("P-%d", row->period), record);
    check_orbit("C4", row->name, record, plain, row->period, row->points, row->count, state);
    carry_tangents(integrator, 4, state, row->period, matrix);
    check_multiplier(row->name, matrix, row->pair[0], row->pair[1]);
    check_multiplier(row->name, matrix, row->real[0], NULL);
    check_multiplier(row->name, matrix, row->real[1], NULL);
    const double time = 2.0 * pi * row->period / p.speed;
    check_within("C4", words("%s, product of the multipliers", row->name), exp(-4.0 * p.zeta * time),
                 determinant(4, matrix), 1e-12);
    whirl_integrator_free(integrator);
    whirl_integrator_free(plain);
    whirl_record_free(record);
    whirl_rotor_free(rotor);
}

static void c4_periodic_orbits(void **unused) {
    (void)unused;
    static const c4_row rows[2] = {
        {"w = 1.5",
         1.5,
         1,
         1,
         {{"1.3284851484", "-.3705078967"}},
         {".54774858", ".61278587"},
         {"-.588909", "-.47058333"}},
        {"w = 3.8",
         3.8,
         4,
         4,
         {{"-1.0595706503", "-.5024893815"},
          {"-1.11500351", "-.01035513"},
          {"-1.00404859", "-.34789172"},
          {"-1.01494028", "-.03188894"}},
         {"-.42213556", ".4797482"},
         {".65282916", ".26620254"}},
    };
    for (int i = 0; i < 2; i++) check_c4_periodic(&rows[i]);
}

static void c4_permanent_contact(void **unused) {
    (void)unused;
    const rub_case p = c4_case(1.5);
    whirl_rotor *rotor = make_rub_rotor(&p);
    whirl_record *record = record_motion(whirl_rotor_system(rotor), c4_start, 1024, 200, 20);
    check_within("C4", "share of contact at w = 1.5", 1.0, record->contact_share[0], 0.0);
    whirl_record_free(record);
    whirl_rotor_free(rotor);
}

static void c4_chaos(void **unused) {
    (void)unused;
    const rub_case p = c4_case(3.3);
    double state[4], exponents[4];
    whirl_rotor *rotor = make_rub_rotor(&p);
    whirl_record *record = record_motion(whirl_rotor_system(rotor), c4_start, 512, 400, 60000);
    const double time = 2.0 * pi / p.speed;
    check_regime("C4", "regime at w = 3.3", "chaotic", record);
    check_exponent("C4", "largest exponent by time at w = 3.3", 0.180, 0.004, record, time);

    const tangent_model model = {whirl_rotor_system(rotor), rub_jacobian, &p};
    const whirl_system joint = make_tangent_system(&model);
    whirl_integrator *integrator = make_integrator(&joint, "rk4", 512);
    memcpy(state, record->end, sizeof state);
    lyapunov_spectrum(integrator, 4, state, 20, 20000, exponents);
    const double sum = exponents[0] + exponents[1] + exponents[2] + exponents[3];
    check_within("C4", "sum of the exponents by time at w = 3.3", -4.0 * p.zeta, sum / time, 1e-6);
    check_within("C4", "largest exponent by variational equations", 0.180, exponents[0] / time,
                 hypot(0.004, 3.0 * sqrt(3.0) * whirl_lyapunov_largest(record).error / time));
    whirl_integrator_free(integrator);
    whirl_record_free(record);
    whirl_rotor_free(rotor);
}

static void c4_without_contact(void **unused) {
    (void)unused;
    rub_case p = c4_case(3.3);
    p.eccentricity = 0.1;
    p.weight = 0.0;
    whirl_rotor *rotor = make_rub_rotor(&p);
    whirl_record *record = record_motion(whirl_rotor_system(rotor), c4_start, 256, 100, 20000);
    check_within("C4", "share of contact at e = .1, no weight", 0.0, record->contact_share[0], 0.0);
    check_within("C4", "largest exponent by time without contact", -p.zeta,
                 whirl_lyapunov_largest(record).value * p.speed / (2.0 * pi), 1e-4);
    whirl_record_free(record);
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(c1_grazing),
        cmocka_unit_test(c2_synchronous_rub),
        cmocka_unit_test(c3_backward_whirl),
        cmocka_unit_test(c3_friction_that_never_reverses),
        cmocka_unit_test(c3_friction_that_follows_the_slip),
        cmocka_unit_test(c4_periodic_orbits),
        cmocka_unit_test(c4_permanent_contact),
        cmocka_unit_test(c4_chaos),
        cmocka_unit_test(c4_without_contact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
