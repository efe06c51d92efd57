// Claims of branches, compared with a branch and a curve whose points are known.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "sample.h"
#include "whirl/engine/claims.h"

typedef struct made_point {
    double value, number, special, angle, criticality, second;
} made_point;

static void add_table(whirl_result *result, const char *name, size_t count, const made_point *points) {
    static const char *const fields[] = {"trace/number", "trace/special", "trace/angle", "trace/criticality",
                                         "trace/second"};
    const whirl_system system = {
        .dimension = 8, .period = 6.283185307179586, .probe_count = 2, .probes = result->stations};
    whirl_table *table = &result->tables[result->table_count++];
    snprintf(table->name, sizeof table->name, "%s", name);
    table->role = strcmp(name, "branch") == 0 ? WHIRL_ROLE_BRANCHES : WHIRL_ROLE_CURVES;
    snprintf(table->parameter, sizeof table->parameter, "r_k");
    assert_true(whirl_analysis_add(&table->analyses, "trace"));
    table->integrate = whirl_integrate_default();
    table->record = whirl_record_default();
    assert_int_equal(whirl_layout_new(&system, &table->integrate, &table->record, table->analyses, &table->layout).code,
                     WHIRL_OK);
    table->count = count;
    table->values = sample_take(count, sizeof *table->values);
    table->branch = sample_take(count, sizeof *table->branch);
    table->blocks = sample_take(count * table->layout.size, sizeof *table->blocks);
    for (size_t i = 0; i < count; i++) {
        table->values[i] = points[i].value;
        for (size_t k = 0; k < 5; k++) *sample_field(table, i, fields[k], 0) = (&points[i].number)[k];
    }
}

/// Makes a branch from 0.1 to 0.8: Hopf points at 0.3, subcritical, and 0.6, a fold at 0.5; a curve of Hopf points in
/// two pieces from 0.3.
static whirl_result *branched(void) {
    static const made_point branch[] = {
        {0.1, 1, 0, NAN, NAN, NAN},           {0.6, 1, WHIRL_HOPF, 0.1, -2.0, NAN}, {0.5, 1, WHIRL_FOLD, NAN, NAN, NAN},
        {0.3, 1, WHIRL_HOPF, 0.48, 1.0, NAN}, {0.8, 1, 0, NAN, NAN, NAN},
    };
    static const made_point curve[] = {
        {0.3, 1, WHIRL_HOPF, 0.48, 1.0, 1.0},  {0.4, 1, WHIRL_HOPF, 0.48, NAN, 2.0},
        {0.5, 1, WHIRL_HOPF, 0.48, -1.0, 3.0}, {0.3, 2, WHIRL_HOPF, 0.48, 1.0, 1.0},
        {0.2, 2, WHIRL_HOPF, 0.48, 2.0, 0.5},  {0.1, 2, WHIRL_HOPF, 0.48, -2.0, 0.0},
    };
    whirl_result *result = sample_result();
    whirl_table *tables = sample_take(4, sizeof *tables);
    memcpy(tables, result->tables, 2 * sizeof *tables);
    free(result->tables);
    result->tables = tables;
    add_table(result, "branch", 5, branch);
    add_table(result, "curves", 6, curve);
    return result;
}

static void expect(whirl_claim claim, whirl_agreement agreement, const char *text) {
    const whirl_claims claims = {.parameter = "r_k", .station = "disc"};
    char found[600];
    whirl_result *result = branched();
    assert_int_equal(whirl_claim_compare(&claims, &claim, result, found, sizeof found), agreement);
    assert_string_equal(found, text);
    whirl_result_free(result);
}

static void changes_in_a_range(void **state) {
    (void)state;
    whirl_claim claim = {.from = 0.2, .to = 0.7, .changes = {1, {WHIRL_HOPF}}};
    expect(claim, WHIRL_AGREES, "Hopf at 0.6, 0.3");
    claim.changes = (whirl_claim_kinds){2, {WHIRL_FOLD, WHIRL_DOUBLING}};
    expect(claim, WHIRL_AGREES_PARTLY, "fold at 0.5, no period doubling");
    claim.to = 0.4;
    expect(claim, WHIRL_DISAGREES, "no fold, no period doubling");
    claim = (whirl_claim){.from = 0.505, .to = 0.505, .changes = {1, {WHIRL_FOLD}}}; // within 2 %
    expect(claim, WHIRL_AGREES, "fold at 0.5");
    claim.from = claim.to = 0.52;
    expect(claim, WHIRL_DISAGREES, "no fold");
}

static void nothing_in_a_range(void **state) {
    (void)state;
    whirl_claim claim = {.from = 0.2, .to = 0.7, .unchanged = {1, {WHIRL_DOUBLING}}};
    expect(claim, WHIRL_AGREES, "no period doubling");
    claim.unchanged.list[0] = WHIRL_FOLD;
    expect(claim, WHIRL_DISAGREES, "fold at 0.5");
    claim.from = 0.7;
    claim.to = 0.9;
    expect(claim, WHIRL_AGREES_PARTLY, "no fold (branches were followed over 50 % of the range)");
    claim.from = 0.85;
    expect(claim, WHIRL_NOT_COMPARED, "no fold (branches were followed over 0 % of the range)");
}

static void sense_and_order_of_the_first(void **state) {
    (void)state;
    whirl_claim claim = {.from = 0.2, .to = 0.7, .changes = {1, {WHIRL_HOPF}}, .sense = 1};
    expect(claim, WHIRL_AGREES, "Hopf at 0.6, 0.3; subcritical");
    claim.sense = -1;
    expect(claim, WHIRL_AGREES_PARTLY, "Hopf at 0.6, 0.3; subcritical");
    claim = (whirl_claim){.from = 0.2, .to = 0.7, .order_count = 2, .orders = {0.9, 0.5}}; // within 5 %
    expect(claim, WHIRL_AGREES, "whirl of 0.48 orders begins first, at 0.3");
    claim.orders[1] = 0.51;
    expect(claim, WHIRL_DISAGREES, "whirl of 0.48 orders begins first, at 0.3");
    claim.from = 0.7;
    expect(claim, WHIRL_DISAGREES, "no whirl begins");
}

static void regions_of_a_curve(void **state) {
    (void)state;
    whirl_claim claim = {.from = 0.0, .to = 1.0, .regions = 3};
    static const char text[] =
        "3: supercritical from r_k = 0.1, subcritical from r_k = 0.2, supercritical from r_k = 0.5";
    expect(claim, WHIRL_AGREES, text);
    claim.regions = 2;
    expect(claim, WHIRL_DISAGREES, text);
}

static void results_of_other_values_are_left_out(void **state) {
    (void)state;
    whirl_claim claim = {
        .from = 0.2, .to = 0.7, .changes = {1, {WHIRL_FOLD}}, .given = "c", .given_from = 1e-4, .given_to = 2e-4};
    expect(claim, WHIRL_AGREES, "fold at 0.5");
    claim.given_to = 1.5e-4;
    expect(claim, WHIRL_NOT_COMPARED, "of c = 0.0001 to 0.00015, here it is 0.0002");
    strcpy(claim.given, "d");
    expect(claim, WHIRL_NOT_COMPARED, "the case has no parameter d");
}

static void results_without_branches(void **state) {
    (void)state;
    const whirl_claims claims = {.parameter = "r_k", .station = "disc"};
    const whirl_claim claim = {.from = 0.2, .to = 0.7, .changes = {1, {WHIRL_FOLD}}, .regions = 2};
    char found[600];
    whirl_result *result = sample_result();
    assert_int_equal(whirl_claim_compare(&claims, &claim, result, found, sizeof found), WHIRL_NOT_COMPARED);
    assert_string_equal(found, "the result has no curve of Hopf points; the result has no branches over r_k");
    whirl_result_free(result);
}

/// In the sweep there is chaos with rub 4 % of the time at 0.1 and 0, and P-1 with lines 1 and 0.5 at 0.6.
static void how_long_and_the_largest_line(void **state) {
    (void)state;
    whirl_claim claim = {.from = 0.0, .to = 0.15, .has_contact = true, .contact = WHIRL_CONTACT_AT_TIMES};
    expect(claim, WHIRL_AGREES, "rub at all 2 points, always at 0 of them");
    claim.contact = WHIRL_CONTACT_ALWAYS;
    expect(claim, WHIRL_DISAGREES, "rub at all 2 points, always at 0 of them");
    claim = (whirl_claim){.from = 0.0, .to = 0.15, .has_largest = true, .largest = {0.9, 2.0}};
    expect(claim, WHIRL_AGREES, "largest line 1 to 1 X");
    claim.largest[0] = 1.1;
    expect(claim, WHIRL_DISAGREES, "largest line 1 to 1 X");
    claim = (whirl_claim){.from = 0.0, .to = 0.15, .has_dry_whip = true, .dry_whip = false}; // not analysed
    expect(claim, WHIRL_NOT_COMPARED, "dry whip not computed");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(changes_in_a_range),
        cmocka_unit_test(nothing_in_a_range),
        cmocka_unit_test(sense_and_order_of_the_first),
        cmocka_unit_test(regions_of_a_curve),
        cmocka_unit_test(results_of_other_values_are_left_out),
        cmocka_unit_test(results_without_branches),
        cmocka_unit_test(how_long_and_the_largest_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
