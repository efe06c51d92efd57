/// Expressions over parameters: "r_k*k2", by muParser.
#ifndef CASE_EXPRESSION_H
#define CASE_EXPRESSION_H

#include "quantity.h"

#include <stdbool.h>
#include <stddef.h>

enum { EXPRESSION_MAX_LENGTH = 500, EXPRESSION_MAX_DEPTH = 50 };

/// Callback for every name in an expression that is neither a function nor a constant; returns false for an unknown
/// name.
typedef bool (*expression_name_fn)(void *context, const char *name, size_t length);

/// Checks all that needs no values: length, depth, characters, names. On failure `why` is the reason; after an unknown
/// name it is empty, for the caller to fill.
bool expression_check(const char *text, expression_name_fn known, void *context, char why[WHY_SIZE]);

/// Returns the functions and constants that expressions know; ended by NULL.
const char *const *expression_words(void);
bool expression_has_word(const char *name);

/// Evaluates expressions over variables. Each thread needs its own.
typedef struct expression_evaluator expression_evaluator;

/// Makes an evaluator; `values` [count] are read when an expression is evaluated. Values whose name is NULL have none.
/// NULL without memory.
expression_evaluator *evaluator_new(const char *const *names, double *values, size_t count);

/// Evaluates an expression that expression_check has passed. Returns false if it is invalid or not finite; `why` is the
/// reason.
bool evaluator_value(expression_evaluator *evaluator, const char *text, double *value, char why[WHY_SIZE]);
void evaluator_free(expression_evaluator *evaluator);

/// Takes an expression that evaluator_again evaluates. Returns false if it is invalid; `why` is the reason.
bool evaluator_take(expression_evaluator *evaluator, const char *text, char why[WHY_SIZE]);

/// Returns the value of the expression with the present values; NaN if it has none.
double evaluator_again(expression_evaluator *evaluator);

#endif
