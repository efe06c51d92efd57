/// Expressions over parameters: "r_k*k2", by muParser.
#ifndef CASE_EXPRESSION_H
#define CASE_EXPRESSION_H

#include <stdbool.h>
#include <stddef.h>

#include "quantity.h"

enum { EXPRESSION_MAX_LENGTH = 500, EXPRESSION_MAX_DEPTH = 50 };

/// Called with every name in an expression that is neither a function nor a constant; false for an unknown one.
typedef bool (*expression_name_fn)(void *context, const char *name, size_t length);

/// Checks all that can be checked without values: length, depth, characters, names. On false `why` says what is wrong;
/// after an unknown name `why` is left empty for the caller to fill.
bool expression_check(const char *text, expression_name_fn known, void *context, char why[WHY_SIZE]);

/// The functions and constants that expressions know; ended by NULL.
const char *const *expression_words(void);
bool expression_has_word(const char *name);

/// Evaluates expressions over variables. Not to be shared between threads; as many as one likes may be at work at once.
typedef struct expression_evaluator expression_evaluator;

/// `values` [count] are read when an expression is evaluated. NULL when memory ran out.
expression_evaluator *evaluator_new(const char *const *names, double *values, size_t count);

/// Value of an expression that expression_check has passed. false when it is no expression or not finite: `why` says
/// it.
bool evaluator_value(expression_evaluator *evaluator, const char *text, double *value, char why[WHY_SIZE]);
void evaluator_free(expression_evaluator *evaluator);

#endif
