// Claims files: what they say, and what is wrong with them.
#include "case_support.h"

#include <math.h>

#include "claims_read.h"
#include "whirl/claims.h"

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

static void wrong_claims_are_told(void **state) {
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
                        "c:5:43: items[1].rub: is perhaps, expected one of true, false, yes, no");
    expect_item_problem("at: 1, curves: 4e35",
                        "c:5:46: items[1].curves: is 4e+35, expected a whole number from 1 to 64");
    expect_item_problem("at: 1, curves: = 2", "c:5:46: items[1].curves: is an expression, expected a number");
    expect_item_problem("at: 1, lnes: [1]", "c:5:38: items[1].lnes: claim has no key lnes, did you mean lines?");
    expect_item_problem("at: 1, lines: []", "c:5:38: items[1].lines: is a list of 0, expected a list of 1 to 8 orders");
    expect_item_problem("at: 1, lines: [-1]", "c:5:46: items[1].lines[1]: is -1, expected a number of at least 0");
    expect_item_problem("at: 1, band: [2, 1]", "c:5:38: items[1].band: expected the lower order first");
    expect_item_problem("at: 1, whirl: foward", "c:5:45: items[1].whirl: is foward, did you mean forward?");
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
        cmocka_unit_test(the_paper_s_claims_are_read), cmocka_unit_test(wrong_claims_are_told),
        cmocka_unit_test(ranges_are_ordered),          cmocka_unit_test(yes_is_true),
        cmocka_unit_test(other_files_are_refused),
    };
    return cmocka_run_group_tests_name("claims", tests, NULL, NULL);
}
