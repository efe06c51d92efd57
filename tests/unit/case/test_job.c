// Cases, runs and results by handles have the numbers of the structs.
#include "case_support.h"

#include <math.h>

#include "whirl/handles.h"
#include "whirl/job.h"

enum { SIZE = 4096 };

static whirl_result *run_good(const whirl_case *object) {
    whirl_job *job;
    whirl_result *result;
    assert_int_equal(whirl_job_new(object, &job).code, WHIRL_OK);
    const whirl_status status = whirl_job_run(job, &result);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    whirl_job_free(job);
    return result;
}

static void all_problems_are_listed(void **state) {
    (void)state;
    char problems[SIZE], *first = edited(good_case, "mass: 4 kg", "mass: -4 kg");
    char *text = edited(first, "points: 5", "points: 0");
    whirl_case *object;
    const whirl_status status = whirl_case_check(text, strlen(text), "t.yaml", problems, sizeof problems, &object);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_null(object);
    assert_non_null(strstr(problems, "t.yaml:11:18: rotor.stations.disc.mass: is -4 kg"));
    assert_non_null(strstr(problems, "\nt.yaml:19:"));
    free(first);
    free(text);
}

static void problems_are_cut_at_the_buffers_end(void **state) {
    (void)state;
    char problems[16] = "no end in here!", *text = edited(good_case, "mass: 4 kg", "mass: -4 kg");
    whirl_case *object;
    assert_int_equal(whirl_case_check(text, strlen(text), "t.yaml", problems, 10, &object).code, WHIRL_BAD_INPUT);
    assert_string_equal(problems, "t.yaml:11");
    free(text);
}

static void the_text_follows_what_is_set(void **state) {
    (void)state;
    size_t length;
    char problems[SIZE];
    whirl_case *object;
    assert_int_equal(whirl_case_check(good_case, strlen(good_case), "t", problems, SIZE, &object).code, WHIRL_OK);
    assert_string_equal(problems, "");
    assert_string_equal(whirl_case_text(object, &length), good_case);
    assert_int_equal(length, strlen(good_case));
    assert_int_equal(whirl_case_set(object, "disc.mass=5 kg").code, WHIRL_OK);
    assert_non_null(strstr(whirl_case_text(object, &length), "{mass: 5 kg, damping"));
    whirl_case_free(object);
}

static void lists_are_those_of_the_struct(void **state) {
    (void)state;
    whirl_case *object = parse_good(good_case);
    whirl_result *result = run_good(object);
    assert_string_equal(whirl_result_title(result), "A rotor");
    assert_string_equal(whirl_result_case_text(result), good_case);
    assert_true(whirl_result_speed(result) == 100.0 && whirl_result_force_scale(result) == result->force_scale);
    assert_false(whirl_result_is_partial(result));
    assert_int_equal(whirl_result_count(result, WHIRL_LIST_PARAMETERS), 3);
    assert_string_equal(whirl_result_name(result, WHIRL_LIST_PARAMETERS, 2), "c");
    assert_string_equal(whirl_result_text(result, WHIRL_LIST_PARAMETERS, 2, "text"), "0.2 mm");
    assert_string_equal(whirl_result_text(result, WHIRL_LIST_PARAMETERS, 2, "unit"), "m");
    assert_true(whirl_result_number(result, WHIRL_LIST_PARAMETERS, 2, "value") == result->parameters[2].value);
    assert_string_equal(whirl_result_name(result, WHIRL_LIST_STATIONS, 1), "journal");
    assert_true(whirl_result_number(result, WHIRL_LIST_STATIONS, 1, "clearance") == 1.0);
    assert_string_equal(whirl_result_name(result, WHIRL_LIST_CONTACTS, 0), "rub at disc");
    assert_string_equal(whirl_result_name(result, WHIRL_LIST_TABLES, 0), "sweep");
    assert_int_equal(whirl_result_count(result, WHIRL_LIST_FACTS), result->fact_count);
    assert_string_equal(whirl_result_text(result, WHIRL_LIST_FACTS, 0, "value"), result->facts[0].value);
    assert_null(whirl_result_name(result, WHIRL_LIST_TABLES, 1));
    assert_null(whirl_result_text(result, WHIRL_LIST_CONTACTS, 0, "unit"));
    assert_true(isnan(whirl_result_number(result, WHIRL_LIST_STATIONS, 0, "name")));
    assert_true(isnan(whirl_result_number(result, WHIRL_LIST_STATIONS, 0, "weight")));
    whirl_result_free(result);
    whirl_case_free(object);
}

static void columns_are_those_of_the_blocks(void **state) {
    (void)state;
    whirl_case *object = parse_good(good_case);
    whirl_result *result = run_good(object);
    const whirl_table *table = whirl_result_table(result, "sweep");
    size_t numbers = 0;
    for (size_t field = 0; field < whirl_table_field_count(table); field++) {
        size_t shape[3], stride;
        const char *name = whirl_table_field_name(table, field);
        const double *column = whirl_table_column(table, field, shape, &stride);
        const size_t size = shape[0] * shape[1] * shape[2];
        double *copy = calloc(table->count * size + 1, sizeof *copy);
        assert_non_null(copy);
        assert_int_equal(whirl_table_field_index(table, name), field);
        assert_int_equal(whirl_table_copy(table, field, copy).code, WHIRL_OK);
        for (size_t point = 0; point < whirl_table_points(table); point++) {
            if (size == 0) continue;
            assert_ptr_equal(column + point * stride, whirl_table_field(table, point, name, 0));
            assert_memory_equal(copy + point * size, column + point * stride, size * sizeof *copy);
        }
        numbers += size;
        free(copy);
    }
    assert_int_equal(numbers, table->layout.size);
    whirl_result_free(result);
    whirl_case_free(object);
}

static void fields_have_units_and_words(void **state) {
    (void)state;
    char unit[WHIRL_NAME_SIZE], name[WHIRL_MESSAGE_SIZE], reason[WHIRL_MESSAGE_SIZE], value[WHIRL_NAME_SIZE];
    whirl_case *object = parse_good(good_case);
    whirl_result *result = run_good(object);
    const whirl_table *table = whirl_result_table(result, "sweep");
    const size_t section = whirl_table_field_index(table, "poincare/section");
    assert_string_equal(whirl_table_parameter(table), "kappa");
    assert_string_equal(whirl_table_field_unit(table, section), "length");
    assert_string_equal(whirl_table_field_extent(table, section), "station");
    assert_true(whirl_table_field_si(result, table, section, unit, sizeof unit) == 0.2e-3);
    assert_string_equal(unit, "m");
    assert_true(whirl_result_shown_unit(result, "c", unit, sizeof unit) == 1e-3);
    assert_string_equal(unit, "mm");
    const whirl_verdict verdict = whirl_table_verdict(table, 0);
    char expected[WHIRL_MESSAGE_SIZE];
    whirl_verdict_name(&verdict, expected, sizeof expected);
    whirl_table_words(table, 0, name, reason, sizeof name);
    assert_string_equal(name, expected);
    assert_true(strlen(reason) > 0);
    size_t found = 0;
    const char *option;
    for (size_t i = 0; (option = whirl_table_option(table, i, value, sizeof value)); i++)
        found += (strcmp(option, "steps_per_revolution") == 0 && strcmp(value, "64") == 0) ||
                 (strcmp(option, "record") == 0 && strcmp(value, "10") == 0);
    assert_int_equal(found, 2);
    assert_null(whirl_table_field_name(table, whirl_table_field_count(table)));
    whirl_result_free(result);
    whirl_case_free(object);
}

static void a_stopped_job_says_so(void **state) {
    (void)state;
    whirl_job *job;
    whirl_result *result;
    // Enough points that the run does not end before it checks for a stop.
    char *text = edited(good_case, "points: 5", "points: 5000"),
         *longer = edited(text, "transient: 20", "transient: 200000");
    whirl_case *object = parse_good(longer);
    assert_int_equal(whirl_job_new(object, &job).code, WHIRL_OK);
    assert_int_equal(whirl_job_threads(job, -1).code, WHIRL_BAD_INPUT);
    assert_int_equal(whirl_job_threads(job, 1).code, WHIRL_OK);
    whirl_job_stop(job);
    assert_int_equal(whirl_job_run(job, &result).code, WHIRL_STOPPED);
    assert_true(!result || whirl_result_is_partial(result));
    whirl_result_free(result);
    whirl_job_free(job);
    whirl_case_free(object);
    free(longer);
    free(text);
}

static void record_stage(void *context, const char *stage, double done, double total, double revolutions, double all,
                         double seconds) {
    double *last = context;
    assert_string_equal(stage, "compute");
    assert_true(revolutions <= all && seconds >= 0.0);
    last[0] = done;
    last[1] = total;
}

static void progress_ends_with_all_points(void **state) {
    (void)state;
    double last[2] = {0.0};
    whirl_job *job;
    whirl_result *result;
    whirl_case *object = parse_good(good_case);
    assert_int_equal(whirl_job_new(object, &job).code, WHIRL_OK);
    whirl_job_progress(job, record_stage, last);
    assert_int_equal(whirl_job_run(job, &result).code, WHIRL_OK);
    assert_true(last[0] == 5.0 && last[1] == 5.0);
    whirl_result_free(result);
    whirl_job_free(job);
    whirl_case_free(object);
}

static void budgets_are_numbers(void **state) {
    (void)state;
    whirl_study study;
    whirl_case *object = parse_good(good_case);
    assert_int_equal(whirl_case_spend(object, -1.0, 0.0).code, WHIRL_BAD_INPUT);
    assert_int_equal(whirl_case_spend(object, (double)NAN, 0.0).code, WHIRL_BAD_INPUT);
    assert_int_equal(whirl_case_spend(object, 0.0, 0.0).code, WHIRL_OK);
    assert_int_equal(whirl_case_study(object, &study).code, WHIRL_OK);
    assert_true(study.refine.revolutions == whirl_study_revolutions(&study));
    whirl_case_free(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_problems_are_listed),
        cmocka_unit_test(problems_are_cut_at_the_buffers_end),
        cmocka_unit_test(the_text_follows_what_is_set),
        cmocka_unit_test(lists_are_those_of_the_struct),
        cmocka_unit_test(columns_are_those_of_the_blocks),
        cmocka_unit_test(fields_have_units_and_words),
        cmocka_unit_test(a_stopped_job_says_so),
        cmocka_unit_test(progress_ends_with_all_points),
        cmocka_unit_test(budgets_are_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
