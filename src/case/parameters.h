/// Named parameters, and values that follow from them.
#ifndef CASE_PARAMETERS_H
#define CASE_PARAMETERS_H

#include <stddef.h>

#include "arena.h"
#include "expression.h"
#include "tree.h"
#include "whirl/case.h"
#include "whirl/descriptor.h"

enum { PARAMETERS_MAX = 256 };

/// A number in SI, or an expression that gives one.
typedef struct formula {
    double number;
    const char *expression; ///< where not NULL it counts
} formula;

typedef struct parameter {
    const char *name;
    const char *text;   ///< as written
    const node *place;
    formula value;
    const char *unit; ///< SI unit, "1" for a plain number, "" for an expression, whose unit is not known
} parameter;

typedef struct parameters {
    size_t count;
    parameter *items;
    const char **names; ///< [count]
    size_t *order;      ///< [count] indices so that everything stands after what it depends on
} parameters;

/// A parameter set from outside ("--set").
typedef struct override {
    const char *name, *text;
} override;

/// What reading a part of a case needs.
typedef struct reader {
    arena *arena;
    whirl_problems *problems;
    const parameters *parameters; ///< NULL while they are being read
    bool no_memory;
} reader;

/// Reads `parameters:`; `where` may be NULL. Overrides come with names that the case has.
void parameters_read(reader *reader, const node *where, const override *overrides, size_t override_count,
                     parameters *result);

/// The index of a parameter, or `count`.
size_t parameters_find(const parameters *parameters, const char *name);

/// Reads a number of `key` at a place of the file: with a unit, plain, or an expression. false after a problem.
bool formula_read(reader *reader, const node *where, const whirl_key *key, formula *result);

/// Values of all parameters for one machine. Cheap; one for every thread.
typedef struct valuation {
    const parameters *parameters;
    evaluator *evaluator;
    double values[PARAMETERS_MAX];
    size_t culprit; ///< the parameter that valuation_open failed at, or PARAMETERS_MAX
} valuation;

/// Evaluates all parameters with `name` at `value` (NULL: as they are). WHIRL_BAD_INPUT when one has no finite value.
/// Closed by valuation_close, after a failure too.
whirl_status valuation_open(valuation *valuation, const parameters *parameters, const char *name, double value);
void valuation_close(valuation *valuation);

/// The value of a formula.
whirl_status valuation_number(valuation *valuation, const formula *formula, double *number);

#endif
