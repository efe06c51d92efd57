// Claims compared with known results: agreement, partial agreement, disagreement, and the messages.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "sample.h"
#include "whirl/engine/claims.h"

/// Compares one claim with the sample result; what was found goes to `found` [600].
static whirl_agreement compare(const whirl_claim *claim, char *found) {
    const whirl_claims claims = {.parameter = "r_k", .station = "disc"};
    whirl_result *result = sample_result();
    const whirl_agreement agreement = whirl_claim_compare(&claims, claim, result, found, 600);
    whirl_result_free(result);
    return agreement;
}

static void assert_contains(const char *text, const char *part) {
    if (!strstr(text, part)) fail_msg("'%s' is not in '%s'", part, text);
}

static void point_claims(void **state) {
    (void)state;
    char found[600];
    whirl_claim claim = {.from = 0.6, .to = 0.6, .has_regime = true, .regime = WHIRL_PERIODIC, .period = 1};
    assert_int_equal(compare(&claim, found), WHIRL_AGREES);
    assert_string_equal(found, "P-1");
    claim.period = 2;
    assert_int_equal(compare(&claim, found), WHIRL_DISAGREES);
    claim.period = 0; // any
    assert_int_equal(compare(&claim, found), WHIRL_AGREES);
    claim.regime = WHIRL_CHAOTIC;
    assert_int_equal(compare(&claim, found), WHIRL_DISAGREES);
    claim.has_contact = true; // no contact is claimed and found
    assert_int_equal(compare(&claim, found), WHIRL_AGREES_PARTLY);
    assert_string_equal(found, "P-1; no rub");
}

static void low_confidence_is_reported(void **state) {
    (void)state;
    char found[600];
    const whirl_claims claims = {.parameter = "r_k", .station = "disc"};
    const whirl_claim claim = {.from = 0.6, .to = 0.6, .has_regime = true, .regime = WHIRL_PERIODIC, .period = 1};
    whirl_result *result = sample_result();
    *sample_field(&result->tables[1], 0, "regime/confidence", 0) = WHIRL_LOW;
    assert_int_equal(whirl_claim_compare(&claims, &claim, result, found, sizeof found), WHIRL_AGREES);
    assert_string_equal(found, "P-1, of low confidence");
    *sample_field(&result->tables[1], 0, "regime/confidence", 0) = WHIRL_FAIR;
    assert_int_equal(whirl_claim_compare(&claims, &claim, result, found, sizeof found), WHIRL_AGREES);
    assert_string_equal(found, "P-1");
    whirl_result_free(result);
}

static void point_comes_from_detail_or_nearest(void **state) {
    (void)state;
    char found[600];
    // 0.25 is in the detail table (chaotic); in the sweep its neighbours 0.3 and 0.2 are quasi-periodic.
    whirl_claim claim = {.from = 0.25, .to = 0.25, .has_regime = true, .regime = WHIRL_CHAOTIC};
    assert_int_equal(compare(&claim, found), WHIRL_AGREES);
    claim.from = claim.to = 0.42; // not computed: the sweep's 0.4 is P-2
    claim.regime = WHIRL_PERIODIC;
    claim.period = 2;
    assert_int_equal(compare(&claim, found), WHIRL_AGREES);
    assert_contains(found, "r_k = 0.4");
    claim.from = claim.to = 7.0; // far from everything
    assert_int_equal(compare(&claim, found), WHIRL_NOT_COMPARED);
}

static void range_claims(void **state) {
    (void)state;
    char found[600];
    // Sweep: P-1 at 1.0 to 0.5, P-2 at 0.4, quasi-periodic at 0.3 and 0.2, chaos with rub at 0.1 and 0.
    whirl_claim claim = {.from = 0.5, .to = 1.0, .has_regime = true, .regime = WHIRL_PERIODIC, .period = 1};
    assert_int_equal(compare(&claim, found), WHIRL_AGREES);
    assert_string_equal(found, "P-1 at all 6 points");
    claim.from = 0.3; // 6 of 8 points
    assert_int_equal(compare(&claim, found), WHIRL_AGREES_PARTLY);
    assert_string_equal(found, "P-1 at 75 %, P-2 at 12.5 %, quasi-periodic at 12.5 % of 8 points");
    claim.from = 0.0;
    claim.to = 0.5; // 1 of 6
    assert_int_equal(compare(&claim, found), WHIRL_DISAGREES);
    const whirl_claim rub = {.from = 0.0, .to = 0.15, .has_contact = true, .contact = true};
    assert_int_equal(compare(&rub, found), WHIRL_AGREES);
    assert_string_equal(found, "rub at all 2 points");
    const whirl_claim some = {.from = 0.0, .to = 0.2, .has_contact = true, .contact = true};
    assert_int_equal(compare(&some, found), WHIRL_AGREES_PARTLY);
    assert_string_equal(found, "rub at 66.7 % of 3 points (r_k = 0 to 0.1)");
    const whirl_claim beyond = {.from = 2.0, .to = 3.0, .has_contact = true, .contact = true};
    assert_int_equal(compare(&beyond, found), WHIRL_NOT_COMPARED);
}

static void line_claims(void **state) {
    (void)state;
    char found[600];
    // 0.6: lines 1 and 3, of which 3 has 1 % of the largest and does not count.
    whirl_claim claim = {.from = 0.6, .to = 0.6, .line_count = 1, .lines = {1.0}, .only_lines = true};
    assert_int_equal(compare(&claim, found), WHIRL_AGREES);
    claim.lines[0] = 0.985; // within 0.02
    assert_int_equal(compare(&claim, found), WHIRL_AGREES);
    claim.lines[0] = 0.97;
    assert_int_equal(compare(&claim, found), WHIRL_DISAGREES);
    const whirl_claim third = {.from = 0.6, .to = 0.6, .line_count = 2, .lines = {1.0, 3.0}};
    assert_int_equal(compare(&third, found), WHIRL_DISAGREES);
    // 0.25: 1, 0.43, 0.40, 0.46.
    whirl_claim more = {.from = 0.25, .to = 0.25, .line_count = 1, .lines = {0.43}};
    assert_int_equal(compare(&more, found), WHIRL_AGREES);
    more.only_lines = true;
    assert_int_equal(compare(&more, found), WHIRL_DISAGREES);
    assert_string_equal(found, "lines 1, 0.43, 0.4, 0.46 X");
}

static void band_claims(void **state) {
    (void)state;
    char found[600];
    whirl_claim claim = {.from = 0.25, .to = 0.25, .has_band = true, .band = {0.3, 0.6}};
    assert_int_equal(compare(&claim, found), WHIRL_AGREES);
    // 0.43 and 0.46 hold 89 of 125 parts of the power, below three quarters.
    claim.band[0] = 0.425;
    assert_int_equal(compare(&claim, found), WHIRL_DISAGREES);
    assert_string_equal(found, "2 lines in 0.425 to 0.6 X with 71 % of the power below 1 X");
    claim.from = claim.to = 0.6; // nothing below the running speed
    claim.band[0] = 0.3;
    assert_int_equal(compare(&claim, found), WHIRL_DISAGREES);
}

static void curves_and_whirl_claims(void **state) {
    (void)state;
    char found[600];
    whirl_claim claim = {.from = 0.3, .to = 0.3, .has_regime = true, .regime = WHIRL_QUASI_PERIODIC, .curves = 2};
    assert_int_equal(compare(&claim, found), WHIRL_AGREES_PARTLY); // one curve
    assert_string_equal(found, "quasi-periodic; 1 closed curve");
    claim.curves = 1;
    assert_int_equal(compare(&claim, found), WHIRL_AGREES);
    whirl_claim whirl = {.from = 0.0, .to = 0.15, .has_whirl = true, .whirl = "diverging-backward"};
    assert_int_equal(compare(&whirl, found), WHIRL_DISAGREES); // backward a quarter of the time
    assert_string_equal(found, "bounded everywhere; against the rotation 25 % of the time");
    snprintf(whirl.whirl, sizeof whirl.whirl, "backward");
    assert_int_equal(compare(&whirl, found), WHIRL_DISAGREES);
    snprintf(whirl.whirl, sizeof whirl.whirl, "forward");
    assert_int_equal(compare(&whirl, found), WHIRL_AGREES);
}

static void divergence_is_diverging_backward(void **state) {
    (void)state;
    char found[600];
    const whirl_claims claims = {.parameter = "r_k", .station = "disc"};
    const whirl_claim claim = {.from = 0.0, .to = 0.15, .has_whirl = true, .whirl = "diverging-backward"};
    whirl_result *result = sample_result();
    for (size_t i = 9; i < 11; i++) {
        sample_verdict(&result->tables[0], i, WHIRL_DIVERGING, 0, 0);
        *sample_field(&result->tables[0], i, "orbit/backward", 0) = (double)NAN;
    }
    assert_int_equal(whirl_claim_compare(&claims, &claim, result, found, sizeof found), WHIRL_AGREES);
    assert_contains(found, "diverged at 2 of 2 points");
    whirl_result_free(result);
}

static void unknown_numbers_do_not_agree(void **state) {
    (void)state;
    char found[600];
    const whirl_claims claims = {.parameter = "r_k", .station = "disc"};
    const whirl_claim claim = {.from = 0.0, .to = 0.15, .has_contact = true, .contact = true};
    whirl_result *result = sample_result();
    *sample_field(&result->tables[0], 10, "rub/share", 0) = (double)NAN;
    assert_int_equal(whirl_claim_compare(&claims, &claim, result, found, sizeof found), WHIRL_AGREES_PARTLY);
    assert_contains(found, "unknown at 1 more");
    *sample_field(&result->tables[0], 9, "rub/share", 0) = (double)NAN;
    assert_int_equal(whirl_claim_compare(&claims, &claim, result, found, sizeof found), WHIRL_NOT_COMPARED);
    whirl_result_free(result);
}

/// Points that a stopped run has not computed agree with nothing and are not counted.
static void points_not_done_are_unknown(void **state) {
    (void)state;
    char found[600];
    const whirl_claims claims = {.parameter = "r_k", .station = "disc"};
    const whirl_claim claim = {.from = 0.5, .to = 1.0, .has_regime = true, .regime = WHIRL_PERIODIC, .period = 1};
    whirl_result *result = sample_result();
    whirl_table *sweep = &result->tables[0];
    sweep->done = sample_take(sweep->count, 1);
    memset(sweep->done, 1, 4);
    assert_int_equal(whirl_claim_compare(&claims, &claim, result, found, sizeof found), WHIRL_AGREES_PARTLY);
    assert_string_equal(found, "P-1 at all 4 points (unknown at 2 more)");
    whirl_result_free(result);
}

static void nothing_to_compare(void **state) {
    (void)state;
    char found[8];
    const whirl_claim claim = {.from = 0.6, .to = 0.6, .has_regime = true, .regime = WHIRL_PERIODIC};
    const whirl_claims strange = {.parameter = "r_k", .station = "impeller"};
    whirl_result *result = sample_result();
    assert_int_equal(whirl_claim_compare(&strange, &claim, result, found, sizeof found), WHIRL_NOT_COMPARED);
    assert_true(strlen(found) < sizeof found); // cut, and ended
    const whirl_claims other = {.parameter = "omega", .station = "disc"};
    assert_int_equal(whirl_claim_compare(&other, &claim, result, found, sizeof found), WHIRL_NOT_COMPARED);
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(point_claims),
        cmocka_unit_test(low_confidence_is_reported),
        cmocka_unit_test(point_comes_from_detail_or_nearest),
        cmocka_unit_test(range_claims),
        cmocka_unit_test(line_claims),
        cmocka_unit_test(band_claims),
        cmocka_unit_test(curves_and_whirl_claims),
        cmocka_unit_test(divergence_is_diverging_backward),
        cmocka_unit_test(unknown_numbers_do_not_agree),
        cmocka_unit_test(points_not_done_are_unknown),
        cmocka_unit_test(nothing_to_compare),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
