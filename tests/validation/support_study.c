#include "support_study.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"

whirl_result *run_case_at(const char *file, size_t batches, const double *values, size_t count,
                          void (*change)(whirl_batch *batch, const void *context), const void *context) {
    double *own = malloc(count * sizeof *own);
    whirl_problems problems = {0};
    whirl_case *object;
    whirl_study study;
    whirl_result *result;
    assert_non_null(own);
    memcpy(own, values, count * sizeof *own);
    require_ok(whirl_case_load(words("%s/%s.yaml", WHIRL_CASES, file), &problems, &object));
    require_ok(whirl_case_study(object, &study));
    whirl_batch *batch = &study.batches[0];
    assert_int_equal(batches, study.batch_count);
    study.batch_count = 1;
    batch->count = count;
    batch->values = own;
    batch->confirm = true;
    assert_true(whirl_analysis_add(&batch->analyses, "evidence"));
    change(batch, context);
    const whirl_run_options options = {.threads = 2};
    require_ok(whirl_study_run(&study, &options, &result));
    whirl_case_free(object);
    whirl_problems_free(&problems);
    free(own);
    return result;
}

static double number_at(const whirl_table *table, size_t point, const char *field, size_t which, size_t column) {
    const double *value = whirl_table_field(table, point, field, which);
    if (!value) fail_msg("the result has no field %s", field);
    return value ? value[column] : NAN;
}

double table_number(const whirl_table *table, size_t point, const char *field, size_t which) {
    return number_at(table, point, field, which, 0);
}

double first_number(const whirl_result *result, const char *field, size_t which, size_t column) {
    return number_at(&result->tables[0], 0, field, which, column);
}

whirl_case *case_of_text(const char *text) {
    char problems[4096];
    whirl_case *object = NULL;
    if (whirl_case_check(text, strlen(text), "case.yaml", problems, sizeof problems, &object).code != WHIRL_OK)
        fail_msg("%s", problems);
    return object;
}

whirl_result *result_of_text(const char *text) {
    whirl_case *object = case_of_text(text);
    whirl_result *result;
    require_ok(whirl_case_run(object, &(whirl_run_options){.threads = 1}, &result));
    whirl_case_free(object);
    return result;
}
