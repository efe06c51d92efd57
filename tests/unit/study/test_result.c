// Results in memory: finding tables, fields and facts.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../store/synthetic.h"

static int setup(void **state) {
    *state = synthetic_result();
    return 0;
}

static int teardown(void **state) {
    whirl_result_free(*state);
    return 0;
}

static void tables_have_names(void **state) {
    const whirl_result *result = *state;
    assert_ptr_equal(whirl_result_table(result, "sweep"), &result->tables[0]);
    assert_ptr_equal(whirl_result_table(result, "detail"), &result->tables[1]);
    assert_null(whirl_result_table(result, "response"));
}

// made/array is [3][2] for each of two stations, made/column [3] for one contact: the block of the detail is
// array(disc) 0 to 5, array(journal) 6 to 11, column 12 to 14, row 15 to 16, number 17 and 18.
static void fields_lie_where_the_layout_says(void **state) {
    const whirl_table *detail = &((whirl_result *)*state)->tables[1];
    assert_int_equal(detail->layout.size, 19);
    assert_ptr_equal(whirl_table_field(detail, 0, "made/array", 0), detail->blocks);
    assert_ptr_equal(whirl_table_field(detail, 0, "made/array", 1), detail->blocks + 6);
    assert_ptr_equal(whirl_table_field(detail, 0, "made/column", 0), detail->blocks + 12);
    assert_ptr_equal(whirl_table_field(detail, 0, "made/row", 0), detail->blocks + 15);
    assert_ptr_equal(whirl_table_field(detail, 0, "made/number", 1), detail->blocks + 18);
    const whirl_table *sweep = &((whirl_result *)*state)->tables[0];
    assert_int_equal(whirl_table_field(sweep, 2, "regime/code", 0) - whirl_table_field(sweep, 1, "regime/code", 0),
                     sweep->layout.size);
}

static void missing_fields_are_null(void **state) {
    const whirl_table *detail = &((whirl_result *)*state)->tables[1];
    assert_null(whirl_table_field(detail, 0, "made/none", 0));
    assert_null(whirl_table_field(detail, 1, "made/array", 0));
    assert_null(whirl_table_field(detail, 0, "made/array", 2));
    assert_null(whirl_table_field(detail, 0, "made/row", 1));
}

/// A case in rpm and mm has results in them; 2 pi/60 and 25.4e-6 are the definitions.
static void parameters_are_shown_in_the_units_of_the_case(void **state) {
    (void)state;
    whirl_parameter parameters[] = {{"omega", "rad/s", "6000 rpm", 6000 * 2 * 3.14159265358979323846 / 60},
                                    {"c", "m", " 8mil ", 8 * 25.4e-6},
                                    {"speed", "rad/s", "= 2*omega", 1200.0},
                                    {"zero", "m", "0 mm", 0.0},
                                    {"gap", "m", "= 1.5*c", 12 * 25.4e-6},
                                    {"wide", "m", "= 2*gap + rho*c", 24 * 25.4e-6},
                                    {"round", "m", "= other", 1.0},
                                    {"other", "m", "= round", 1.0},
                                    {"rho", "1", "0.08", 0.08},
                                    {"bare", "kg", "12", 12.0}};
    const whirl_result result = {.length_scale = 8 * 25.4e-6, .parameter_count = 10, .parameters = parameters};
    static const struct {
        const char *name, *unit;
        double size;
    } expected[] = {{"omega", "rpm", 0.10471975511965977},
                    {"c", "mil", 25.4e-6},
                    {"speed", "rpm", 0.10471975511965977},
                    {"gap", "mil", 25.4e-6},
                    {"wide", "mil", 25.4e-6},
                    {"round", "m", 1.0},
                    {"zero", "m", 1.0},
                    {"rho", "", 1.0},
                    {"bare", "kg", 1.0},
                    {"none", "", 1.0}};
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        const whirl_unit unit = whirl_result_unit(&result, expected[i].name);
        assert_string_equal(unit.name, expected[i].unit);
        assert_true(fabs(unit.size / expected[i].size - 1.0) < 1e-14);
    }
    assert_string_equal(whirl_result_length_unit(&result).name, "mil");
    static const struct {
        double scale;
        const char *unit;
    } scales[] = {{1.0, "m"}, {0.1, "m"}, {2e-3, "mm"}, {1e-4, "mm"}, {5e-5, "um"}};
    for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
        const whirl_result plain = {.length_scale = scales[i].scale};
        assert_string_equal(whirl_result_length_unit(&plain).name, scales[i].unit);
    }
}

static void verdicts_come_from_the_block(void **state) {
    const whirl_table *sweep = &((whirl_result *)*state)->tables[0];
    const whirl_verdict first = whirl_table_verdict(sweep, 0), last = whirl_table_verdict(sweep, 2);
    assert_int_equal(first.regime, WHIRL_PERIODIC);
    assert_int_equal(first.period, 2);
    assert_int_equal(whirl_table_verdict(sweep, 1).regime, WHIRL_CHAOTIC);
    assert_int_equal(last.regime, WHIRL_DIVERGING);
    assert_true(last.diverged_at == 17.0);
    const whirl_verdict beyond = whirl_table_verdict(sweep, SYNTHETIC_POINTS);
    assert_int_equal(beyond.regime, WHIRL_NOT_JUDGED);
    assert_true(isnan(beyond.recurrence));
}

static void facts_are_added_or_replaced(void **state) {
    whirl_result *result = *state;
    const size_t before = result->fact_count;
    assert_int_equal(whirl_result_add_fact(result, "threads", "2").code, WHIRL_OK);
    assert_int_equal(whirl_result_add_fact(result, "threads", "16").code, WHIRL_OK);
    assert_int_equal(result->fact_count, before + 1);
    assert_string_equal(result->facts[before].name, "threads");
    assert_string_equal(result->facts[before].value, "16");
}

// A value of 300 letters is cut to the 255 that there is room for.
static void long_facts_are_cut(void **state) {
    whirl_result *result = *state;
    char value[301];
    memset(value, 'v', 300);
    value[300] = '\0';
    assert_int_equal(whirl_result_add_fact(result, "flags", value).code, WHIRL_OK);
    const whirl_fact *fact = &result->facts[result->fact_count - 1];
    assert_int_equal(strlen(fact->value), 255);
    assert_memory_equal(fact->value, value, 255);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(tables_have_names, setup, teardown),
        cmocka_unit_test_setup_teardown(fields_lie_where_the_layout_says, setup, teardown),
        cmocka_unit_test_setup_teardown(missing_fields_are_null, setup, teardown),
        cmocka_unit_test(parameters_are_shown_in_the_units_of_the_case),
        cmocka_unit_test_setup_teardown(verdicts_come_from_the_block, setup, teardown),
        cmocka_unit_test_setup_teardown(facts_are_added_or_replaced, setup, teardown),
        cmocka_unit_test_setup_teardown(long_facts_are_cut, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
