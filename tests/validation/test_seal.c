// A disc of mass M on a shaft of stiffness Ks with a seal: its threshold and its circles against closed forms in
// complex numbers, its weight and unbalance without the mass of the fluid.
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
#include "whirl/engine/rotor.h"

enum { N = 4 };

static const double pi = 3.14159265358979323846;
static const double M = 1.0, Ks = 1.0, Ds = 0.02, K0 = 0.2, D0 = 0.3, fluid = 0.02, ratio = 0.48, growth = 2.0,
                    slowing = 0.5, clearance = 0.5;

/// Makes a disc in a seal: weight along -y; eccentricity of the disc's centre of mass.
static whirl_rotor *make_sealed(double speed, bool nonlinear, double gravity, double eccentricity) {
    const whirl_setting disc[] = {{"mass", M, NULL}, {"damping", Ds, NULL}, {"eccentricity", eccentricity, NULL}};
    const whirl_setting shaft[] = {{"between", 0.0, "disc, ground"}, {"k1", Ks, NULL}};
    const whirl_setting seal[] = {{"at", 0.0, "disc"},      {"clearance", clearance, NULL}, {"stiffness", K0, NULL},
                                  {"damping", D0, NULL},    {"mass", fluid, NULL},          {"ratio", ratio, NULL},
                                  {"growth", growth, NULL}, {"slowing", slowing, NULL}};
    const whirl_setting weight = {"acceleration", gravity, NULL};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(speed, 1.0, &design));
    require_ok(whirl_design_station(design, "disc", disc, 3));
    require_ok(whirl_design_element(design, "shaft", shaft, 2));
    require_ok(whirl_design_element(design, "seal", seal, nonlinear ? 8 : 6));
    require_ok(whirl_design_element(design, "gravity", &weight, 1));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// The coefficients at an eccentricity ratio e.
typedef struct seal_at {
    double K, D, turn;
} seal_at;

static seal_at seal_law(double e, bool nonlinear) {
    const double grown = nonlinear ? pow(1.0 - e * e, -growth) : 1.0;
    return (seal_at){K0 * grown, D0 * grown, ratio * (nonlinear ? pow(1.0 - e, slowing) : 1.0)};
}

/// Returns the force, over the radius, that keeps a circle of ratio e at the whirl speed W: zero for a self-excited
/// whirl.
static double complex stiffness_of_circle(double e, double W, double speed, bool nonlinear) {
    const seal_at s = seal_law(e, nonlinear);
    const double against = W - s.turn * speed; // the fluid turns at s.turn speed
    return Ks + s.K - M * W * W - fluid * against * against + I * (Ds * W + s.D * against);
}

// ---------------------------------------------------------------- the threshold

/// Returns the largest exponent per radian of the balanced rotor at rest, and writes its speed of whirl.
static double growth_at_rest(double speed, double *whirl) {
    const double rest[N] = {0.0};
    double matrix[N * N], order;
    whirl_rotor *rotor = make_sealed(speed, true, 0.0, 0.0);
    exact_jacobian(whirl_rotor_system(rotor), 0.0, rest, matrix);
    const double real_part = largest_real_part(N, matrix, &order);
    *whirl = order * speed;
    whirl_rotor_free(rotor);
    return real_part;
}

static void threshold(void **unused) {
    double low = 1.0, high = 4.0, whirl;
    (void)unused;
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        *(growth_at_rest(middle, &whirl) < 0.0 ? &low : &high) = middle;
    }
    check_digits("Seal", "threshold speed", "2.434214292903", high);
    check_digits("Seal", "whirl there", "1.095396431806", whirl);
    check_within("Seal", "whirl over speed", ratio * D0 / (D0 + Ds), whirl / high, 1e-12);
}

// ---------------------------------------------------------------- circles

/// Returns the ratio e and writes the whirl speed of the circle above the threshold: W from the imaginary part, e from
/// the real one.
static double circle_at(double speed, double *whirl) {
    double low = 0.0, high = 0.999;
    for (int i = 0; i < 100; i++) {
        const double middle = 0.5 * (low + high);
        const seal_at s = seal_law(middle, true);
        *whirl = s.turn * speed * s.D / (s.D + Ds);
        *(creal(stiffness_of_circle(middle, *whirl, speed, true)) < 0.0 ? &low : &high) = middle;
    }
    return low;
}

static void circles(void **unused) {
    (void)unused;
    const double speeds[] = {2.6, 3.5, 6.0};
    for (int i = 0; i < 3; i++) {
        const double speed = speeds[i];
        double whirl;
        const double e = circle_at(speed, &whirl), turns = 2.0 * pi * whirl / speed;
        whirl_rotor *rotor = make_sealed(speed, true, 0.0, 0.0);
        whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
        double x[N] = {e * clearance, 0.0, 0.0, e * clearance * whirl / speed};
        revolve(integrator, x, 10);
        const double complex end = e * clearance * cexp(10.0 * I * turns);
        check_within("Seal", words("whirl at speed %g, e = %.6f: distance after 10 revolutions", speed, e), 0.0,
                     cabs(x[0] + I * x[1] - end), 1e-11);
        // From close to the middle.
        double y[N] = {0.02, 0.01, 0.0, 0.0};
        revolve(integrator, y, 4000);
        check_within("Seal", words("whirl at speed %g: eccentricity ratio reached from the middle", speed), e,
                     hypot(y[0], y[1]) / clearance, 1e-10);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

// ---------------------------------------------------------------- the fluid has inertia alone

/// The weight M g that holds the disc at a ratio e, by the circle of no speed.
static void weight(void **unused) {
    (void)unused;
    const double speed = 1.7, ratios[] = {0.1, 0.5, 0.9};
    double worst = 0.0;
    for (int i = 0; i < 3; i++) {
        const double r = ratios[i] * clearance;
        const double complex stiffness = stiffness_of_circle(ratios[i], 0.0, speed, true);
        const double force = cabs(stiffness) * r;
        const double complex z = -I * force / stiffness; // |z| = r
        const double x[N] = {creal(z), cimag(z), 0.0, 0.0};
        double slope[N];
        whirl_rotor *rotor = make_sealed(speed, true, force / M, 0.0);
        evaluate_rhs(whirl_rotor_system(rotor), 0.0, x, slope);
        worst = fmax(worst, hypot(slope[2], slope[3]) * speed * speed * (M + fluid) / force);
        whirl_rotor_free(rotor);
    }
    check_within("Seal", "force left over at rest under weight, over the weight", 0.0, worst, 1e-14);
}

/// M eps w^2 over the stiffness of the circle at w, of a seal whose law is linear.
static void unbalance(void **unused) {
    (void)unused;
    const double speed = 1.3, eccentricity = 0.01;
    const double complex z = M * eccentricity * speed * speed / stiffness_of_circle(0.0, speed, speed, false);
    double x[N] = {creal(z), cimag(z), -cimag(z), creal(z)};
    whirl_rotor *rotor = make_sealed(speed, false, 0.0, eccentricity);
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
    revolve(integrator, x, 10);
    check_within("Seal", "unbalance response: relative distance after 10 revolutions", 0.0,
                 cabs(x[0] + I * x[1] - z) / cabs(z), 1e-12);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

/// At the wall and beyond the force is NaN, also for a linear law.
static void the_wall(void **unused) {
    (void)unused;
    bool nowhere = true, inside = true;
    for (int nonlinear = 0; nonlinear < 2; nonlinear++) {
        whirl_rotor *rotor = make_sealed(1.0, nonlinear, 0.0, 0.0);
        const double at[] = {clearance, 1.2 * clearance, 1e6}, within = 0.999999 * clearance;
        double slope[N];
        for (int i = 0; i < 3; i++) {
            evaluate_rhs(whirl_rotor_system(rotor), 0.0, (double[N]){0.0, at[i], 0.0, 0.0}, slope);
            nowhere = nowhere && isnan(slope[2]) && isnan(slope[3]);
        }
        evaluate_rhs(whirl_rotor_system(rotor), 0.0, (double[N]){0.0, within, 0.0, 0.0}, slope);
        inside = inside && isfinite(slope[2]) && isfinite(slope[3]);
        whirl_rotor_free(rotor);
    }
    check_holds("Seal", "no force at the wall and beyond, one before it", nowhere && inside);
}

// ---------------------------------------------------------------- by the geometry

/// Makes a seal of 50 mm with water at 1 MPa at 3000 rpm, on a disc of that mass; without the pressure drop the flow is
/// not turbulent.
static whirl_rotor *make_black(double mass, double swirl) {
    const whirl_setting disc[] = {{"mass", mass, NULL}};
    const whirl_setting seal[] = {{"at", 0, "disc"},         {"law", 0, "black"},     {"clearance", 2e-4, NULL},
                                  {"radius", 0.05, NULL},    {"length", 0.05, NULL},  {"density", 1000.0, NULL},
                                  {"viscosity", 1e-3, NULL}, {"pressure", 1e6, NULL}, {"loss", 0.5, NULL},
                                  {"swirl", swirl, NULL}};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(100.0 * acos(-1.0), 1e-4, &design));
    require_ok(whirl_design_station(design, "disc", disc, 1));
    require_ok(whirl_design_element(design, "seal", seal, 10));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Computes kxx, kxy, cxx, cxy over the mass that moves with the disc, 1/s2 and 1/s.
static void black_over_mass(double mass, double swirl, double out[4]) {
    const double rest[N] = {0.0}, speed = 100.0 * acos(-1.0);
    double matrix[N * N];
    whirl_rotor *rotor = make_black(mass, swirl);
    exact_jacobian(whirl_rotor_system(rotor), 0.0, rest, matrix);
    for (int i = 0; i < 4; i++) out[i] = -matrix[2 * N + i] * (i < 2 ? speed * speed : speed);
    whirl_rotor_free(rotor);
}

/// By the closed form, and by the first-order flow in the seal integrated and differentiated with 30 digits, which
/// agree to 12 digits. The fluid's mass by discs of two masses: what is over 1 kg + M and over 4 kg + M.
static void black(void **unused) {
    (void)unused;
    static const char *const names[] = {"kxx, N/m", "kxy, N/m", "cxx, N s/m", "cxy, N s/m"};
    static const char *const expected[] = {"3477798.856", "4133952.62", "26317.55976", "2650.673312"};
    double light[4], heavy[4];
    black_over_mass(1.0, 0.5, light);
    black_over_mass(4.0, 0.5, heavy);
    const double moved = (4.0 * heavy[2] - light[2]) / (light[2] - heavy[2]), turn = 50.0 * acos(-1.0);
    for (int i = 0; i < 4; i++)
        check_digits("Seal", words("by geometry: %s", names[i]), expected[i], light[i] * (1.0 + moved));
    check_digits("Seal", "by geometry: M, kg", "8.437355202", moved);
    check_digits("Seal", "by geometry: K, N/m", "3685982.251", light[0] * (1.0 + moved) + moved * turn * turn);
}

/// Swirl at the inlet: kxx, kxy, cxx, cxy by the first-order flow whose speed around the shaft tends to half the
/// surface's along the seal, integrated in 4000 steps (trapezoidal rule), against its mean here.
static void inlet_swirl(void **unused) {
    (void)unused;
    static const double swirls[] = {0.0, 0.25, 0.7, 1.0};
    static const double flow[][4] = {{3601090, 2575850, 26335.1, 1677.17},
                                     {3546840, 3355210, 26331.1, 2163.38},
                                     {3412000, 4757660, 26321.7, 3039.19},
                                     {3295540, 5692450, 26314.1, 3623.56}};
    static const char *const names[] = {"kxx", "kxy", "cxx", "cxy"};
    for (int s = 0; s < 4; s++) {
        double light[4], heavy[4];
        black_over_mass(1.0, swirls[s], light);
        black_over_mass(4.0, swirls[s], heavy);
        const double moved = (4.0 * heavy[2] - light[2]) / (light[2] - heavy[2]);
        for (int i = 0; i < 4; i++)
            check_within(
                "Seal",
                words("by geometry, swirl %g: %s over that of a swirl that changes along it", swirls[s], names[i]), 1.0,
                light[i] * (1.0 + moved) / flow[s][i], 0.05);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(threshold),  cmocka_unit_test(circles),
                                       cmocka_unit_test(weight),     cmocka_unit_test(unbalance),
                                       cmocka_unit_test(the_wall),   cmocka_unit_test(black),
                                       cmocka_unit_test(inlet_swirl)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
