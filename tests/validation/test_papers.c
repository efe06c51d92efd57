// Published studies as cases. Their claims are compared with whirl's results, and these with independent values where
// some exist. Each case and the verification manual say which parts of the paper were read.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/case.h"
#include "whirl/engine/claims.h"

/// Runs cases/FILE.yaml with the assignments, a list that NULL ends, without its first `skipped` batches.
static whirl_result *run_paper(const char *file, const char *assignments[], size_t skipped) {
    whirl_problems problems = {0};
    whirl_case *object;
    whirl_study study;
    whirl_result *result;
    require_ok(whirl_case_load(words("%s/%s.yaml", WHIRL_CASES, file), &problems, &object));
    for (; *assignments; assignments++) require_ok(whirl_case_assign(object, *assignments));
    require_ok(whirl_case_study(object, &study));
    study.batch_count -= skipped;
    memmove(study.batches, study.batches + skipped, study.batch_count * sizeof *study.batches);
    const whirl_run_options options = {.threads = 2};
    require_ok(whirl_study_run(&study, &options, &result));
    require_ok(whirl_case_describe_result(object, result));
    whirl_case_free(object);
    whirl_problems_free(&problems);
    return result;
}

/// Compares the claims of cases/FILE-claims.yaml with a result. `expected` has a letter for each claim: a(grees),
/// p(artly), d(isagrees), - (not compared).
static void check_claims(const char *file, const char *who, const whirl_result *result, const char *expected) {
    static const char letters[] = {
        [WHIRL_NOT_COMPARED] = '-', [WHIRL_AGREES] = 'a', [WHIRL_AGREES_PARTLY] = 'p', [WHIRL_DISAGREES] = 'd'};
    char verdicts[32] = "", found[1000];
    whirl_claims *claims;
    require_ok(whirl_claims_load(words("%s/%s-claims.yaml", WHIRL_CASES, file), NULL, &claims));
    assert_true(claims->count < sizeof verdicts);
    for (size_t i = 0; i < claims->count; i++) {
        verdicts[i] = letters[whirl_claim_compare(claims, &claims->items[i], result, found, sizeof found)];
        if (verdicts[i] != '-') printf("papers | %s: %s | - | %s | - | -\n", who, claims->items[i].says, found);
    }
    check_text("papers", words("%s: claims agree, partly, disagree", who), expected, verdicts);
    whirl_claims_free(claims);
}

/// Returns the parameter's value at the n-th special point of a kind, from 0, in the order of the branches.
static double special_value(const whirl_result *result, whirl_special kind, size_t n) {
    const whirl_table *branch = whirl_result_table(result, "branch");
    assert_non_null(branch);
    for (size_t i = 0; i < branch->count; i++)
        if (table_number(branch, i, "trace/special", 0) == (double)kind && n-- == 0) return branch->values[i];
    fail_msg("too few points of kind %d", kind);
    return NAN;
}

// ---------------------------------------------------------------- Wang and Khonsari 2006

/// Finds the points of a curve of Hopf points between super- and subcritical ones: values of the first and the second
/// parameter. Returns their number.
static size_t changes_of_sense(const whirl_result *result, double *seconds, double *values, size_t most) {
    const whirl_table *curves = whirl_result_table(result, "curves");
    size_t count = 0;
    assert_non_null(curves);
    for (size_t i = 0; i + 1 < curves->count; i++) {
        const double a = table_number(curves, i, "trace/criticality", 0);
        const double b = table_number(curves, i + 1, "trace/criticality", 0), share = a / (a - b);
        if (!(a * b < 0.0) ||
            table_number(curves, i, "trace/number", 0) != table_number(curves, i + 1, "trace/number", 0))
            continue;
        assert_true(count < most);
        const double from = table_number(curves, i, "trace/second", 0);
        seconds[count] = from + share * (table_number(curves, i + 1, "trace/second", 0) - from);
        values[count++] = curves->values[i] + share * (curves->values[i + 1] - curves->values[i]);
    }
    return count;
}

/// The zeros of the first Lyapunov coefficient, for journals without mass, are from an independent program with 36
/// digits.
static void flexible_rotor(void **state) {
    static const struct {
        const char *stiffness, *claims;
        size_t count;
        double seconds[3], speeds[3];
    } rotors[] = {{"K=8", "a-", 1, {0.2681905}, {2.4741516}},
                  {"K=5", "d-", 3, {0.1974663, -0.6136387, -1.3284919}, {2.3382170, 2.1853619, 2.7285935}},
                  {"K=3.6", "-a", 2, {-0.2000347, -0.4182299}, {2.1694109, 2.1154096}}};
    (void)state;
    for (size_t r = 0; r < sizeof rotors / sizeof *rotors; r++) {
        double seconds[8], speeds[8];
        whirl_result *result = run_paper("flexible-rotor", (const char *[]){rotors[r].stiffness, NULL}, 0);
        char who[64];
        snprintf(who, sizeof who, "flexible rotor, %s", rotors[r].stiffness);
        check_claims("flexible-rotor", who, result, rotors[r].claims);
        const size_t count = changes_of_sense(result, seconds, speeds, 8);
        assert_int_equal(rotors[r].count, count);
        for (size_t i = 0; i < count; i++) {
            size_t nearest = 0;
            for (size_t k = 1; k < count; k++)
                if (fabs(seconds[k] - rotors[r].seconds[i]) < fabs(seconds[nearest] - rotors[r].seconds[i]))
                    nearest = k;
            check_within("papers", words("%s: sense changes at the logarithm", who), rotors[r].seconds[i],
                         seconds[nearest], 0.01);
            check_within("papers", words("%s: and at the speed", who), rotors[r].speeds[i], speeds[nearest], 0.01);
        }
        whirl_result_free(result);
    }
}

// ---------------------------------------------------------------- Boyaci, Seemann and Proppe 2007

static void floating_rings(void **state) {
    (void)state;
    whirl_result *result = run_paper("ring-whirl", (const char *[]){NULL}, 0);
    check_claims("ring-whirl", "floating rings", result, "aaaa");
    whirl_result_free(result);
    result = run_paper("ring-whirl", (const char *[]){"inner=10 um", "outer=100 um", NULL}, 1);
    check_claims("ring-whirl", "floating rings, the outer film first", result, "aa--");
    whirl_result_free(result);
}

// ---------------------------------------------------------------- Jiang and Ulbrich 2001, Jiang 2007

/// The circular orbit in lasting contact has its folds and losses of stability at values of a closed form.
static void annular_rub(void **state) {
    (void)state;
    whirl_result *result = run_paper("annular-rub", (const char *[]){NULL}, 0);
    check_claims("annular-rub", "annular rub, mu = .05", result, "aaa---");
    check_digits("papers", "annular rub, mu = .05: fold", "1.61785691", special_value(result, WHIRL_FOLD, 0));
    whirl_result_free(result);
    result = run_paper("annular-rub", (const char *[]){"mu=0.1", NULL}, 0);
    check_claims("annular-rub", "annular rub, mu = .1", result, "a--aap");
    check_digits("papers", "annular rub, mu = .1: torus begins", "1.44630234",
                 special_value(result, WHIRL_NEIMARK_SACKER, 0));
    check_digits("papers", "annular rub, mu = .1: fold", "1.58066700", special_value(result, WHIRL_FOLD, 0));
    whirl_result_free(result);
}

/// After the onset of dry whip the rotor rolls backward in its stator without slip:
///     R w = r W,    W^2 = 1 + kappa (1 - 1/r)
/// with the speed w and the whirl W over the natural frequency, the radii R = 20 of the rotor and r of the orbit over
/// the gap, and the stiffness kappa = 2 of the contact over that of the shaft. For w = 1.3, W/w = 1.303089.
static void dry_whip(void **state) {
    (void)state;
    whirl_result *result = run_paper("dry-whip", (const char *[]){NULL}, 0);
    const whirl_table *sweep = whirl_result_table(result, "sweep");
    check_claims("dry-whip", "dry whip", result, "aaaaa");
    check_digits("papers", "dry whip: full annular rub is lost at mu", "0.107390244",
                 special_value(result, WHIRL_NEIMARK_SACKER, 0));
    check_within("papers", "dry whip: turns backward in a revolution, rolling", 1.303089,
                 -table_number(sweep, sweep->count - 1, "winding/winding", 0), 2e-3);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- Zhao, Linnett and McLean 1994

static void eccentric_damper(void **state) {
    (void)state;
    whirl_result *result = run_paper("eccentric-damper", (const char *[]){NULL}, 0);
    check_claims("eccentric-damper", "eccentric damper", result, "aaaa-");
    whirl_result_free(result);
    result = run_paper("eccentric-damper", (const char *[]){"U=0.1", NULL}, 1);
    check_claims("eccentric-damper", "eccentric damper, little unbalance", result, "----a");
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(flexible_rotor), cmocka_unit_test(floating_rings),
                                       cmocka_unit_test(annular_rub), cmocka_unit_test(dry_whip),
                                       cmocka_unit_test(eccentric_damper)};
    return cmocka_run_group_tests_name("papers", tests, NULL, NULL);
}
