/// Studies of the case files at values of the test's own.
#ifndef SUPPORT_STUDY_H
#define SUPPORT_STUDY_H

#include <stddef.h>

#include "whirl/engine/case.h"
#include "whirl/engine/study.h"

/// Runs the first of the `batches` of cases/FILE.yaml at the values [count], every verdict confirmed, with the evidence
/// added, after `change` had the batch in hand. Freed by whirl_result_free.
whirl_result *run_case_at(const char *file, size_t batches, const double *values, size_t count,
                          void (*change)(whirl_batch *batch, const void *context), const void *context);

/// The case of a text; fails the test with what is wrong with it. Freed by whirl_case_free.
whirl_case *case_of_text(const char *text);

/// Runs the case of a text on one thread and returns its result. Freed by whirl_result_free.
whirl_result *result_of_text(const char *text);

/// Number `which` of a field of a point; fails the test where the result has no such field.
double table_number(const whirl_table *table, size_t point, const char *field, size_t which);

/// Number `column` of a field of the first point of a result's first table, for its station, contact or row `which`;
/// fails the test where the result has no such field.
double first_number(const whirl_result *result, const char *field, size_t which, size_t column);

#endif
