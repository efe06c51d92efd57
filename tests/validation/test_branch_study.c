// Branches of cases: thresholds, changes of a rotor that rubs compared with settled motions, and curves over a second
// parameter compared with branches.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/case.h"
#include "whirl/engine/rotor.h"

static const double pi = 3.14159265358979323846;

/// Returns the result of a case's study.
static whirl_result *run_text(const char *text) {
    whirl_problems problems = {0};
    whirl_case *object;
    whirl_study study;
    whirl_result *result;
    const whirl_run_options options = {.threads = 2};
    require_ok(whirl_case_parse(text, strlen(text), "t", &problems, &object));
    require_ok(whirl_case_study(object, &study));
    require_ok(whirl_study_run(&study, &options, &result));
    whirl_case_free(object);
    whirl_problems_free(&problems);
    return result;
}

static double number(const whirl_table *table, size_t point, const char *field) {
    return table_number(table, point, field, 0);
}

/// Returns the row of the special point number `which` (from 0) of a kind, on a branch (0: any); the test fails if
/// there is none.
static size_t special_row(const whirl_table *table, size_t branch, whirl_special kind, size_t which) {
    for (size_t i = 0; i < table->count; i++)
        if ((branch == 0 || number(table, i, "trace/number") == (double)branch) &&
            (int)number(table, i, "trace/special") == (int)kind && which-- == 0)
            return i;
    fail_msg("branch %zu has no further special point of kind %d", branch, kind);
    return 0;
}

static size_t count_kind(const whirl_table *table, whirl_special kind) {
    size_t count = 0;
    for (size_t i = 0; i < table->count; i++) count += (int)number(table, i, "trace/special") == (int)kind;
    return count;
}

// ---------------------------------------------------------------- oil whirl

/// Returns sigma = F0/W that holds a journal in the short film at eccentricity ratio e, at any speed.
static double load_of(double e) {
    const double phi = atan2(pi * sqrt(1.0 - e * e), 4.0 * e);
    double force[2];
    whirl_film_force(e * sin(phi), -e * cos(phi), 0.0, 0.0, force);
    return 1.0 / hypot(force[0], force[1]);
}

static void oil_whirl_from_a_case(void **state) {
    static const struct {
        double e;
        const char *speed, *ratio;
        bool sudden;
    } rows[] = {{0.1, "2.741278636", ".50293839", true}, {0.3, "2.605785828", ".51941739", false}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[1024];
        snprintf(text, sizeof text,
                 "whirl: 1\nparameters: {s: 1.5, sigma: %.17g}\nrotor:\n  speed: 1 rad/s\n  length_scale: 1 m\n"
                 "  stations: {journal: {mass: 1 kg}}\n  elements:\n"
                 "    - film: {at: journal, clearance: 1 m, load: = sigma/s^2}\n    - gravity: = 1/s^2\n"
                 "study:\n  branch: {parameter: s, from: 1.5, to: 3, rest: yes, points: 200, segments: 4}\n"
                 "  initial: {journal: {x: 0.1, y: -0.1}}\n",
                 load_of(rows[i].e));
        whirl_result *result = run_text(text);
        const whirl_table *table = whirl_result_table(result, "branch");
        assert_non_null(table);
        assert_int_equal(1, count_kind(table, WHIRL_HOPF));
        const size_t at = special_row(table, 1, WHIRL_HOPF, 0);
        check_digits("branch", words("A5 from a case, e = %g: Hopf point at s =", rows[i].e), rows[i].speed,
                     table->values[at]);
        check_digits("branch", "A5 from a case, whirl ratio", rows[i].ratio, number(table, at, "trace/angle"));
        // The whirl begins there, along a branch of its own.
        size_t whirl = at;
        while (whirl < table->count && number(table, whirl, "trace/parent") != 1.0) whirl++;
        assert_true(whirl < table->count);
        assert_true(number(table, whirl, "trace/revolutions") == 0.0 && number(table, whirl, "trace/period") > 0.0);
        assert_true(rows[i].sudden == (table->values[whirl] < table->values[at]));
        assert_true(number(table, whirl, "trace/unstable") == (rows[i].sudden ? 1.0 : 0.0));
        whirl_result_free(result);
    }
}

// ---------------------------------------------------------------- a rotor that rubs

static const char *const rotor =
    "whirl: 1\nparameters: {omega: 1.5 rad/s, zeta: %s, kappa: 10, e: 0.9, mu: 0.05, gamma: 0.5}\n"
    "rotor:\n  speed: = omega\n  length_scale: 1 m\n"
    "  stations: {disc: {mass: 1 kg, damping: = 2*zeta, eccentricity: = e}}\n  elements:\n"
    "    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}\n"
    "    - rub: {at: disc, gap: 1 m, stiffness: = kappa, friction: = mu, law: paper}\n    - gravity: = gamma\n"
    "study:\n  initial: {disc: {x: 0.1, y: -0.2}}\n  integrate: {transient: 400, record: 100}\n%s";

static whirl_result *run_rotor(const char *zeta, const char *study) {
    char text[2048];
    snprintf(text, sizeof text, rotor, zeta, study);
    return run_text(text);
}

/// Returns the period in revolutions, up to 4, on which a motion settles that begins at a row's orbit, displaced by
/// 1e-3 of it, at another speed; 0 if there is none.
static int settled_period(const whirl_table *table, size_t row, double omega) {
    enum { PASSED = 6000, D = 4 };
    char text[2048];
    whirl_problems problems = {0};
    whirl_case *object;
    whirl_rotor *machine;
    whirl_integrator *integrator;
    double x[D], z[5][D];
    snprintf(text, sizeof text, rotor, "0.1", "  response: {}\n");
    require_ok(whirl_case_parse(text, strlen(text), "t", &problems, &object));
    require_ok(whirl_case_rotor(object, "omega", omega, &machine));
    whirl_integrate_options options = whirl_integrate_default();
    strcpy(options.method, "dop853");
    require_ok(whirl_integrator_new(whirl_rotor_system(machine), &options, &integrator));
    const double *nodes = whirl_table_field(table, row, "trace/nodes", 0);
    for (int i = 0; i < D; i++) x[i] = 1.001 * nodes[i];
    for (int n = 0; n < PASSED; n++) {
        if (n >= PASSED - 5) memcpy(z[n - PASSED + 5], x, sizeof x);
        assert_int_equal(WHIRL_BOUNDED, whirl_integrator_revolve(integrator, x, NULL, NULL));
    }
    whirl_integrator_free(integrator);
    whirl_rotor_free(machine);
    whirl_case_free(object);
    whirl_problems_free(&problems);
    for (int k = 1; k <= 4; k++) {
        double away = 0.0;
        for (int i = 0; i < D; i++) away = fmax(away, fabs(z[4][i] - z[4 - k][i]));
        if (away < 1e-6) return k;
    }
    return 0;
}

static void changes_of_a_rotor_that_rubs(void **state) {
    (void)state;
    whirl_result *result =
        run_rotor("0.1", "  branch: {parameter: omega, from: 1, to: 4, at: [1.5, 1.8], switches: 1}\n");
    const whirl_table *table = whirl_result_table(result, "branch");
    // The settled motion at 1.8 lies on the branch that begins at 1.5, which is not followed again.
    double last = 0.0;
    for (size_t i = 0; i < table->count; i++) {
        const double branch = number(table, i, "trace/number");
        assert_true(branch >= last);
        assert_true(branch < 3.0 || number(table, i, "trace/parent") > 0.0);
        last = branch;
    }
    const size_t doubling = special_row(table, 1, WHIRL_DOUBLING, 0), fold = special_row(table, 1, WHIRL_FOLD, 1);
    const double at = table->values[doubling];
    assert_true(number(table, doubling, "trace/criticality") < 0.0);
    check_within("branch", "Jeffcott rotor with rub, doubling: P-1 settles .001 before", 1.0,
                 settled_period(table, doubling, at - 1e-3), 0.0);
    check_within("branch", "... and P-2 .001 beyond", 2.0, settled_period(table, doubling, at + 1e-3), 0.0);
    // Beyond the fold of the small orbit the motion jumps to the large one, which has no fold there.
    check_holds("branch", "before the fold of the small orbit P-1 settles far from it",
                settled_period(table, fold, table->values[fold] - 1e-3) == 1);
    // A branch of twice the period begins, stable, at the doubling.
    size_t twice = doubling;
    while (twice < table->count && number(table, twice, "trace/revolutions") != 2.0) twice++;
    assert_true(twice < table->count && number(table, twice, "trace/unstable") == 0.0);
    // First touch: the station's bounds reach the gap of 1 there.
    const size_t graze = special_row(table, 2, WHIRL_GRAZE, 0);
    const double *nearest = whirl_table_field(table, graze, "trace/touches", 0);
    check_within("branch", "... first touch: distance left", 0.0, nearest[2], 1e-10);
    whirl_result_free(result);
}

/// The last point of a curve over the damping is a special point of the rotor with that damping.
static void curves_of_a_rotor_that_rubs(void **state) {
    static const char *const ranges[] = {"from: 3.25, to: 3.3, at: [3.26]", "from: 1.05, to: 1.15, at: [1.14]"};
    static const whirl_special kinds[] = {WHIRL_FOLD, WHIRL_GRAZE};
    (void)state;
    for (int range = 0; range < 2; range++) {
        char study[256];
        snprintf(study, sizeof study,
                 "  branch: {parameter: omega, %s, switches: 0}\n  curves: {parameter: zeta, from: 0.09, to: 0.11}\n",
                 ranges[range]);
        whirl_result *result = run_rotor("0.1", study);
        const whirl_table *curves = whirl_result_table(result, "curves");
        size_t compared = 0;
        assert_string_equal("zeta", whirl_result_fact(result, "second parameter"));
        for (size_t i = 0; i < curves->count; i++) {
            if (isnan(number(curves, i, "trace/end"))) continue;
            char zeta[32];
            snprintf(zeta, sizeof zeta, "%.17g", number(curves, i, "trace/second"));
            *strstr(study, "  curves") = '\0';
            whirl_result *other = run_rotor(zeta, study);
            const whirl_table *branch = whirl_result_table(other, "branch");
            check_within("branch",
                         words("curve over zeta: %s at zeta = %.6g", whirl_special_name(kinds[range]),
                               number(curves, i, "trace/second")),
                         branch->values[special_row(branch, 0, kinds[range], 0)], curves->values[i], 1e-8);
            whirl_result_free(other);
            strcat(study, "  curves");
            compared++;
        }
        assert_int_equal(2, compared);
        whirl_result_free(result);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(oil_whirl_from_a_case),
        cmocka_unit_test(changes_of_a_rotor_that_rubs),
        cmocka_unit_test(curves_of_a_rotor_that_rubs),
    };
    return cmocka_run_group_tests_name("branch study", tests, NULL, NULL);
}
