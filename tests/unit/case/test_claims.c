// Claims files: what they say, and what is wrong with them.
#include "case_support.h"

#include <math.h>

#include "claims.h"
#include "whirl/engine/claims.h"

static whirl_claims *load_paper(void) {
    whirl_claims *claims = NULL;
    const whirl_status status = whirl_claims_load(WHIRL_CASES "/paper-claims.yaml", NULL, &claims);
    if (status.code != WHIRL_OK) print_error("%s\n", status.message);
    assert_int_equal(status.code, WHIRL_OK);
    return claims;
}

static const whirl_claim *claim_on(const whirl_claims *claims, const char *where) {
    for (size_t i = 0; i < claims->count; i++)
        if (strcmp(claims->items[i].where, where) == 0) return &claims->items[i];
    return NULL;
}

static void the_paper_s_claims_are_read(void **state) {
    (void)state;
    whirl_claims *claims = load_paper();
    assert_string_equal(claims->parameter, "r_k");
    assert_string_equal(claims->station, "disc");
    assert_int_equal(claims->count, 12);
    const whirl_claim *figure = claim_on(claims, "Fig. 6");
    assert_non_null(figure);
    assert_true(figure->from == 0.46 && figure->to == 0.46);
    assert_true(figure->has_regime && figure->regime == WHIRL_QUASI_PERIODIC);
    assert_int_equal(figure->period, 0);
    assert_int_equal(figure->curves, 2);
    assert_int_equal(figure->line_count, 3);
    assert_true(figure->lines[1] == 0.667);
    assert_false(figure->has_contact || figure->has_band || figure->has_whirl || figure->only_lines);
    figure = claim_on(claims, "Fig. 9");
    assert_non_null(figure);
    assert_true(figure->regime == WHIRL_PERIODIC && figure->period == 4 && figure->has_contact && !figure->contact);
    figure = claim_on(claims, "Fig. 10");
    assert_non_null(figure);
    assert_true(figure->regime == WHIRL_CHAOTIC && figure->contact && figure->has_band);
    assert_true(figure->band[0] == 0.2 && figure->band[1] == 0.5);
    assert_true(claim_on(claims, "Fig. 4")->only_lines);
    figure = claim_on(claims, "Conclusions");
    assert_non_null(figure);
    assert_true(figure->has_whirl && !figure->has_regime);
    assert_string_equal(figure->whirl, "diverging-backward");
    whirl_claims_free(claims);
}

static whirl_status parse_item(const char *item, whirl_problems *problems, whirl_claims **claims) {
    char text[800];
    snprintf(text, sizeof text, "claims: 1\nparameter: p\nstation: s\nitems:\n  - {where: Fig. 1, says: it, %s}\n",
             item);
    return claims_parse(text, strlen(text), "c", problems, claims);
}

static void expect_item_problem(const char *item, const char *expected) {
    char found[sizeof(whirl_problem)];
    whirl_problems problems = {0};
    whirl_claims *claims;
    assert_int_equal(parse_item(item, &problems, &claims).code, WHIRL_BAD_INPUT);
    assert_null(claims);
    whirl_problem_text(&problems, 0, found, sizeof found);
    assert_string_equal(found, expected);
    assert_int_equal(problems.count, 1);
    whirl_problems_free(&problems);
}

static void wrong_claims_are_refused(void **state) {
    (void)state;
    expect_item_problem("at: 1, regime: P-0", "c:5:46: items[1].regime: is P-0, did you mean P-1?");
    expect_item_problem(
        "at: 1, regime: P-129",
        "c:5:46: items[1].regime: is P-129, expected one of P-1, periodic, quasi-periodic, chaotic, diverged");
    expect_item_problem("at: 1, regime: chaotik", "c:5:46: items[1].regime: is chaotik, did you mean chaotic?");
    expect_item_problem("at: 1, to: 2", "c:5:5: items[1]: expected either at, or from and to");
    expect_item_problem("from: 1", "c:5:5: items[1]: expected either at, or from and to");
    expect_item_problem("rub: true", "c:5:5: items[1]: expected either at, or from and to");
    expect_item_problem("at: x", "c:5:35: items[1].at: is x, expected a number, or a number and a unit");
    expect_item_problem("at: 1, rub: perhaps",
                        "c:5:43: items[1].rub: is perhaps, expected one of true, false, yes, no, always, at_times");
    expect_item_problem("at: 1, curves: 4e35",
                        "c:5:46: items[1].curves: is 4e+35, expected a whole number from 1 to 64");
    expect_item_problem("at: 1, curves: = 2", "c:5:46: items[1].curves: is an expression, expected a number");
    expect_item_problem("at: 1, lnes: [1]", "c:5:38: items[1].lnes: claim has no key lnes, did you mean lines?");
    expect_item_problem("at: 1, lines: []", "c:5:38: items[1].lines: is a list of 0, expected a list of 1 to 8 orders");
    expect_item_problem("at: 1, lines: [-1]", "c:5:46: items[1].lines[1]: is -1, expected a number of at least 0");
    expect_item_problem("at: 1, band: [2, 1]", "c:5:38: items[1].band: expected the lower order first");
    expect_item_problem("at: 1, whirl: foward", "c:5:45: items[1].whirl: is foward, did you mean forward?");
    expect_item_problem("at: 1, largest: [2, 1]", "c:5:38: items[1].largest: expected the lower order first");
}

static void wrong_claims_of_branches_are_refused(void **state) {
    (void)state;
    expect_item_problem("at: 1, changes: [hof]", "c:5:48: items[1].changes[1]: is hof, did you mean hopf?");
    expect_item_problem("at: 1, unchanged: hopf",
                        "c:5:49: items[1].unchanged: is hopf, expected a list of 1 to 6 kinds of special points");
    expect_item_problem("at: 1, sense: subcritical", "c:5:5: items[1]: has a sense and no changes, expected both");
    expect_item_problem("at: 1, given: q", "c:5:5: items[1]: expected given, given_from and given_to together");
    expect_item_problem("at: 1, regions: 0", "c:5:47: items[1].regions: is 0, expected a whole number from 1 to 99");
}

static void claims_of_branches_are_read(void **state) {
    (void)state;
    whirl_claims *claims;
    assert_int_equal(parse_item("from: 1, to: 2, changes: [hopf, neimark-sacker], unchanged: [fold], sense: "
                                "supercritical, orders: [0.5, 0.1], regions: 3, given: q, given_from: 2, given_to: 1, "
                                "rub: at_times, dry_whip: yes, largest: [0, 1]",
                                NULL, &claims)
                         .code,
                     WHIRL_OK);
    const whirl_claim *item = &claims->items[0];
    assert_int_equal(item->changes.count, 2);
    assert_int_equal(item->changes.list[1], WHIRL_NEIMARK_SACKER);
    assert_int_equal(item->unchanged.list[0], WHIRL_FOLD);
    assert_int_equal(item->sense, -1);
    assert_true(item->order_count == 2 && item->orders[1] == 0.1 && item->regions == 3);
    assert_string_equal(item->given, "q");
    assert_true(item->given_from == 1.0 && item->given_to == 2.0);
    assert_true(item->contact == WHIRL_CONTACT_AT_TIMES && item->has_dry_whip && item->dry_whip);
    assert_true(item->has_largest && item->largest[1] == 1.0);
    whirl_claims_free(claims);
}

static void ranges_are_ordered(void **state) {
    (void)state;
    whirl_claims *claims;
    assert_int_equal(parse_item("from: 2, to: 1, regime: P-64", NULL, &claims).code, WHIRL_OK);
    assert_true(claims->items[0].from == 1.0 && claims->items[0].to == 2.0);
    assert_int_equal(claims->items[0].period, 64);
    whirl_claims_free(claims);
}

static void yes_is_true(void **state) {
    (void)state;
    static const char *const words[] = {"yes", "true", "no", "false"};
    for (int i = 0; i < 4; i++) {
        char item[80];
        whirl_claims *claims;
        snprintf(item, sizeof item, "at: 1, rub: %s, only_lines: %s", words[i], words[i]);
        assert_int_equal(parse_item(item, NULL, &claims).code, WHIRL_OK);
        assert_true(claims->items[0].has_contact);
        assert_true(claims->items[0].contact == (i < 2));
        assert_true(claims->items[0].only_lines == (i < 2));
        whirl_claims_free(claims);
    }
}

static void other_files_are_refused(void **state) {
    (void)state;
    whirl_claims *claims;
    assert_int_equal(whirl_claims_load(WHIRL_CASES "/paper.yaml", NULL, &claims).code, WHIRL_BAD_INPUT);
    assert_null(claims);
    assert_int_equal(whirl_claims_load("/nowhere.yaml", NULL, &claims).code, WHIRL_BAD_INPUT);
    assert_int_equal(claims_parse("claims: 2\n", 10, "c", NULL, &claims).code, WHIRL_BAD_INPUT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_paper_s_claims_are_read), cmocka_unit_test(wrong_claims_are_refused),
        cmocka_unit_test(ranges_are_ordered),          cmocka_unit_test(yes_is_true),
        cmocka_unit_test(other_files_are_refused),     cmocka_unit_test(wrong_claims_of_branches_are_refused),
        cmocka_unit_test(claims_of_branches_are_read),
    };
    return cmocka_run_group_tests_name("claims", tests, NULL, NULL);
}
