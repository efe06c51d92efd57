// Elastomer mounts, which have states of their own, against their complex stiffness.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "whirl/engine.h"

static const double speed = 200.0, scale = 1e-3, mass = 3.0, eccentricity = 2e-5;
static const double stiffness = 2e5, branch = 3e5, damping = 900.0;

static whirl_rotor *make_mounted(void) {
    const whirl_setting disc[] = {{"mass", mass, NULL}, {"eccentricity", eccentricity, NULL}};
    const whirl_setting mount[] = {{"between", 0, "disc, ground"},
                                   {"stiffness", stiffness, NULL},
                                   {"branch", branch, NULL},
                                   {"damping", damping, NULL}};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(speed, scale, &design));
    require_ok(whirl_design_station(design, "disc", disc, 2));
    require_ok(whirl_design_element(design, "mount", mount, 4));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Returns z = m e w^2/(K - m w^2), K = k + k_m i w c/(k_m + i w c).
static double complex mounted_response(void) {
    const double complex dashpot = I * speed * damping;
    return mass * eccentricity * speed * speed /
           (stiffness + branch * dashpot / (branch + dashpot) - mass * speed * speed);
}

static void the_mount_s_response(void **unused) {
    (void)unused;
    static const char *const methods[] = {"dop853", "rk4", "cvode-bdf"};
    whirl_rotor *rotor = make_mounted();
    const whirl_system *system = whirl_rotor_system(rotor);
    const double complex expected = mounted_response() / scale;
    assert_int_equal(system->dimension, 6);
    for (size_t m = 0; m < sizeof methods / sizeof *methods; m++) {
        whirl_integrator *integrator = make_integrator(system, methods[m], 4096);
        double x[6] = {0};
        revolve(integrator, x, 200);
        check_within("Mount", words("unbalance response by %s, part of its size", methods[m]), 0.0,
                     cabs(x[0] + I * x[1] - expected) / cabs(expected), m == 2 ? 1e-8 : 1e-9);
        whirl_integrator_free(integrator);
    }
    whirl_rotor_free(rotor);
}

/// The characteristic equation (m s^2 + k)(c s + k_m) + k_m c s = 0 in each plane.
static void the_mount_s_eigenvalues(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make_mounted();
    double rest[6] = {0}, matrix[36], worst = 0.0;
    double complex values[6];
    exact_jacobian(whirl_rotor_system(rotor), 0.3, rest, matrix);
    eigenvalues(6, matrix, values);
    for (int i = 0; i < 6; i++) {
        const double complex s = values[i] * speed;
        const double complex left = (mass * s * s + stiffness) * (damping * s + branch) + branch * damping * s;
        const double size = (mass * cabs(s) * cabs(s) + stiffness) * (damping * cabs(s) + branch);
        worst = fmax(worst, cabs(left) / size);
    }
    check_within("Mount", "characteristic equation at the six eigenvalues, largest part", 0.0, worst, 1e-13);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- in lanes

enum { LANES = 9, DIMENSION = 6, PLANE = 5 };
static const char *const in_lanes[] = {"rk4", "dop853", "rodas5p"};
enum { IN_LANES = sizeof in_lanes / sizeof *in_lanes };
static const double start[DIMENSION] = {0.03, -0.02, 0.01, 0.04, -0.01, 0.02};

/// Fills M [5][5] of z' = M z along each axis with z = (x, x', s, c, -c'), where c'' = -c is the direction of the
/// unbalance.
static void fill_matrix(double m[PLANE][PLANE]) {
    const double inertia = mass * speed * speed;
    memset(m, 0, PLANE * sizeof *m);
    m[0][1] = m[4][3] = 1.0;
    m[3][4] = -1.0;
    m[1][0] = -(stiffness + branch) / inertia;
    m[1][2] = branch / inertia;
    m[1][3] = eccentricity / scale;
    m[2][0] = branch / (damping * speed);
    m[2][2] = -m[2][0];
}

/// Applies exp(M tau) to z, by the series over sixteenths.
static void carry_plane(double tau, double z[PLANE]) {
    enum { PARTS = 16, TERMS = 40 };
    double m[PLANE][PLANE];
    fill_matrix(m);
    for (int part = 0; part < PARTS; part++) {
        double term[PLANE], next[PLANE];
        memcpy(term, z, sizeof term);
        for (int n = 1; n < TERMS; n++) {
            for (int i = 0; i < PLANE; i++) {
                next[i] = 0.0;
                for (int j = 0; j < PLANE; j++) next[i] += m[i][j] * term[j] * tau / (PARTS * n);
            }
            memcpy(term, next, sizeof term);
            for (int i = 0; i < PLANE; i++) z[i] += term[i];
        }
    }
}

/// Computes the state at tau of one that starts at `from`.
static void exact_state(const double *from, double tau, double x[DIMENSION]) {
    for (int axis = 0; axis < 2; axis++) { // the unbalance pulls as the cosine along x and as the sine along y
        double z[PLANE] = {from[axis], from[2 + axis], from[4 + axis], axis == 0, axis == 0 ? 0 : -1};
        const int turns = (int)(tau / 6.283185307179586);
        for (int i = 0; i < turns; i++) carry_plane(6.283185307179586, z);
        carry_plane(tau - turns * 6.283185307179586, z);
        for (int i = 0; i < 3; i++) x[2 * i + axis] = z[i];
    }
}

static whirl_integrate_options options_of(const char *method) {
    whirl_integrate_options options = whirl_integrate_default();
    strcpy(options.method, method);
    options.rtol = 1e-13;
    options.atol = 1e-16;
    return options;
}

/// Carries seven revolutions in lanes of that width, with one lane saved and loaded into another; `out` gets the state
/// that all lanes must have. Returns false if the processor lacks that width.
static bool carry_in_lanes(const whirl_system *system, const char *method, const char *set, double out[DIMENSION]) {
    const whirl_integrate_options options = options_of(method);
    double lane[DIMENSION], numbers[512];
    whirl_ensemble *ensemble;
    setenv("WHIRL_ISA", set, 1);
    const whirl_status status = whirl_ensemble_new(system, &options, LANES, &ensemble);
    unsetenv("WHIRL_ISA");
    if (status.code != WHIRL_OK) return false;
    for (size_t l = 0; l < LANES; l++) require_ok(whirl_ensemble_load(ensemble, l, system, start));
    for (int i = 0; i < 3; i++) whirl_ensemble_revolve(ensemble, LANES, NULL);
    assert_true(whirl_ensemble_numbers(ensemble) <= sizeof numbers / sizeof *numbers);
    whirl_ensemble_save(ensemble, 2, numbers);
    require_ok(whirl_ensemble_load(ensemble, 5, system, (double[DIMENSION]){0}));
    whirl_ensemble_restore(ensemble, 5, numbers);
    for (int i = 3; i < 7; i++) whirl_ensemble_revolve(ensemble, LANES, NULL);
    whirl_ensemble_state(ensemble, 0, out);
    for (size_t l = 1; l < LANES; l++) {
        whirl_ensemble_state(ensemble, l, lane);
        assert_memory_equal(lane, out, sizeof lane);
    }
    whirl_ensemble_free(ensemble);
    return true;
}

/// Every lane of every width with fused multiply-adds has the same bits, and the right numbers.
static void mounts_in_lanes(void **unused) {
    (void)unused;
    static const char *const sets[] = {"scalar", "fma", "avx2", "avx512"};
    whirl_rotor *rotor = make_mounted();
    const whirl_system *system = whirl_rotor_system(rotor);
    double exact[DIMENSION];
    exact_state(start, 7 * system->period, exact);
    for (int m = 0; m < IN_LANES; m++) {
        double fused[DIMENSION], found[DIMENSION], worst = 0.0;
        bool any = false;
        for (size_t s = 0; s < sizeof sets / sizeof *sets; s++) {
            if (!carry_in_lanes(system, in_lanes[m], sets[s], found)) continue; // this processor has it not
            for (int i = 0; i < DIMENSION; i++) worst = fmax(worst, fabs(found[i] - exact[i]));
            if (s == 0) continue;
            if (any) assert_memory_equal(found, fused, sizeof fused);
            memcpy(fused, found, sizeof fused);
            any = true;
        }
        check_within("Mount", words("in lanes by %s after seven revolutions, against its exponential", in_lanes[m]),
                     0.0, worst, 1e-11);
    }
    whirl_rotor_free(rotor);
}

static whirl_record *record_by(const whirl_system *system, const char *method, int growth) {
    const whirl_integrate_options integrate = options_of(method);
    whirl_record_options options = whirl_record_default();
    whirl_record *record;
    options.transient = 1;
    options.record = 12;
    options.watch = 13;
    options.growth = growth;
    options.samples_per_revolution = 16;
    options.settle = false;
    require_ok(whirl_record_motion(system, &integrate, &options, start, NULL, &record));
    return record;
}

/// Sections, samples and bounds of a record in lanes.
static void watched_in_lanes(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make_mounted();
    const whirl_system *system = whirl_rotor_system(rotor);
    for (int m = 0; m < IN_LANES; m++) {
        const whirl_integrate_options options = options_of(in_lanes[m]);
        whirl_record *record = record_by(system, in_lanes[m], WHIRL_GROWTH_LARGEST);
        double x[DIMENSION], low[DIMENSION], high[DIMENSION], section = 0.0, sample = 0.0;
        assert_true(whirl_ensemble_takes(system, &options));
        assert_int_equal(record->section_count, 13);
        assert_int_equal(record->sample_count, 12 * 16);
        for (size_t n = 0; n < record->section_count; n++) {
            exact_state(start, (double)(n + 1) * system->period, x);
            for (int i = 0; i < DIMENSION; i++)
                section = fmax(section, fabs(x[i] - record->section[n * DIMENSION + i]));
        }
        for (int i = 0; i < DIMENSION; i++) low[i] = INFINITY, high[i] = -INFINITY;
        for (size_t n = 0; n < record->sample_count; n++) {
            exact_state(start, (1.0 + (double)(n + 1) / 16.0) * system->period, x);
            for (size_t i = 0; i < 2; i++)
                sample = fmax(sample, fabs(x[i] - record->waveform[i * record->sample_count + n]));
            for (int i = 0; i < DIMENSION; i++) {
                low[i] = fmin(low[i], x[i]);
                high[i] = fmax(high[i], x[i]);
            }
        }
        // Bounds are those of 1024 instants per revolution; between the samples a state goes a little further.
        for (int i = 0; i < DIMENSION; i++) {
            const double room = 0.05 * (high[i] - low[i]);
            assert_true(record->low[i] <= low[i] + 1e-11 && record->low[i] > low[i] - room);
            assert_true(record->high[i] >= high[i] - 1e-11 && record->high[i] < high[i] + room);
        }
        check_within("Mount", words("sections by %s, against the exponential", in_lanes[m]), 0.0, section, 1e-11);
        check_within("Mount", words("waveform by %s, against the exponential", in_lanes[m]), 0.0, sample, 1e-11);
        whirl_record_free(record);
    }
    whirl_rotor_free(rotor);
}

/// Once perturbations lie along the planes of their modes, the four of the pair of modes and the two of the creep of
/// the dampers grow by their real parts in every revolution.
static void all_exponents(void **unused) {
    (void)unused;
    const double tau = 6.283185307179586;
    whirl_rotor *rotor = make_mounted();
    const whirl_system *system = whirl_rotor_system(rotor);
    double plane[9], m[PLANE][PLANE];
    double complex values[3];
    fill_matrix(m);
    for (int i = 0; i < 9; i++) plane[i] = m[i / 3][i % 3];
    eigenvalues(3, plane, values);
    double creep = INFINITY, sum = 0.0;
    for (int i = 0; i < 3; i++) {
        creep = fmin(creep, creal(values[i]));
        sum += creal(values[i]);
    }
    for (int k = 0; k < IN_LANES; k++) {
        const whirl_integrate_options options = options_of(in_lanes[k]);
        whirl_record *record = record_by(system, in_lanes[k], WHIRL_GROWTH_ALL);
        const double *last = record->growths + (record->growth_count - 1) * DIMENSION;
        assert_int_equal(whirl_ensemble_follows(system, &options), k == 0);
        check_within("Mount", words("four exponents of its modes by %s, together", in_lanes[k]),
                     2.0 * tau * (sum - creep), last[0] + last[1] + last[2] + last[3], 1e-8);
        check_within("Mount", words("two of its dampers by %s, together", in_lanes[k]), 2.0 * tau * creep,
                     last[4] + last[5], 1e-8);
        check_within("Mount", words("the sum of all by %s", in_lanes[k]), -2.0 * tau * branch / (damping * speed),
                     record->volume[record->growth_count - 1], 1e-11);
        whirl_record_free(record);
    }
    whirl_rotor_free(rotor);
}

/// Makes a disc on a mount whose friction on a stator follows the slip sharply: it strikes, slides and rolls.
static whirl_rotor *make_rubbing(double friction) {
    const whirl_setting disc[] = {{"mass", 1, NULL}, {"damping", 0.1, NULL}, {"eccentricity", 0.5, NULL}};
    const whirl_setting mount[] = {
        {"between", 0, "disc, ground"}, {"stiffness", 0.6, NULL}, {"branch", 0.6, NULL}, {"damping", 1.5, NULL}};
    const whirl_setting rub[] = {{"at", 0, "disc"},       {"gap", 0.5, NULL},
                                 {"stiffness", 20, NULL}, {"friction", friction, NULL},
                                 {"law", 0, "slip"},      {"radius", 0.3, NULL}};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(1, 1, &design));
    require_ok(whirl_design_station(design, "disc", disc, 3));
    require_ok(whirl_design_element(design, "mount", mount, 4));
    require_ok(whirl_design_element(design, "rub", rub, 6));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

static void carry_rubbing(const whirl_integrate_options *options, whirl_rotor *const *rotors, size_t count,
                          double (*ends)[DIMENSION]) {
    whirl_ensemble *lanes;
    require_ok(whirl_ensemble_new(whirl_rotor_system(rotors[0]), options, count, &lanes));
    for (size_t l = 0; l < count; l++)
        require_ok(whirl_ensemble_load(lanes, l, whirl_rotor_system(rotors[l]), (double[DIMENSION]){0.6, 0, 0, -1.2}));
    for (int i = 0; i < 8; i++) whirl_ensemble_revolve(lanes, count, NULL);
    for (size_t l = 0; l < count; l++) whirl_ensemble_state(lanes, l, ends[l]);
    whirl_ensemble_free(lanes);
}

/// Contacts are located, and motions slide along them, with states of their elements: among other lanes, in a lane
/// alone, and by the integrator, which chooses its own steps.
static void rubbing_on_mounts(void **unused) {
    (void)unused;
    enum { ROTORS = 5 };
    whirl_rotor *rotors[ROTORS];
    for (int l = 0; l < ROTORS; l++) rotors[l] = make_rubbing(0.1 + 0.1 * l);
    for (int m = 1; m < IN_LANES; m++) {
        double together[ROTORS][DIMENSION], alone[1][DIMENSION], worst = 0.0;
        whirl_integrate_options options = options_of(in_lanes[m]);
        options.rtol = 1e-11;
        options.atol = 1e-14;
        carry_rubbing(&options, rotors, ROTORS, together);
        for (int l = 0; l < ROTORS; l++) {
            double x[DIMENSION] = {0.6, 0, 0, -1.2};
            whirl_integrator *integrator;
            carry_rubbing(&options, &rotors[l], 1, alone);
            assert_memory_equal(together[l], alone[0], sizeof alone[0]);
            require_ok(whirl_integrator_new(whirl_rotor_system(rotors[l]), &options, &integrator));
            revolve(integrator, x, 8);
            whirl_integrator_free(integrator);
            for (int d = 0; d < DIMENSION; d++) worst = fmax(worst, fabs(x[d] - alone[0][d]));
        }
        check_within("Mount", words("with a rub in lanes by %s and by the integrator", in_lanes[m]), 0.0, worst, 1e-9);
    }
    for (int l = 0; l < ROTORS; l++) whirl_rotor_free(rotors[l]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_mount_s_response), cmocka_unit_test(the_mount_s_eigenvalues),
        cmocka_unit_test(mounts_in_lanes),      cmocka_unit_test(watched_in_lanes),
        cmocka_unit_test(all_exponents),        cmocka_unit_test(rubbing_on_mounts),
    };
    return cmocka_run_group_tests_name("mounts", tests, NULL, NULL);
}
