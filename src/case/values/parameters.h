/// Named parameters, and values that follow from them.
#ifndef CASE_PARAMETERS_H
#define CASE_PARAMETERS_H

#include "arena.h"
#include "expression.h"
#include "quantity.h"
#include "tree.h"
#include "whirl/engine/case.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// Evaluating expressions is the longest part of reading a case, hence the second bound.
enum { PARAMETERS_MAX = 256, EXPRESSIONS_MAX_BYTES = 1 << 16 };

/// A set of parameters, by their indices.
typedef struct parameter_set {
    uint64_t bits[PARAMETERS_MAX / 64];
} parameter_set;

/// A number in SI, or an expression that gives one.
typedef struct number_formula {
    double number;
    const char *expression; ///< used if not NULL
    parameter_set uses;     ///< parameters that the expression uses
    bool settled;           ///< its value with all parameters as the case has them is `number`
} number_formula;

typedef struct parameter {
    const char *name;
    const char *text; ///< as written
    const file_node *place;
    number_formula value;
    const char *unit;     ///< SI unit, "1" for a plain number, "" for an expression (unknown)
    const char *taken_as; ///< unit of the first key whose value is this parameter alone, "" if there is none
} parameter;

typedef struct parameter_table {
    size_t count;
    parameter *items;
    const char **names; ///< [count]
    size_t *order;      ///< [count] indices in order of dependence
} parameter_table;

/// A parameter set from outside ("--set").
typedef struct parameter_override {
    const char *name, *text;
} parameter_override;

/// A wrong name that was reported, so that it is not reported again elsewhere.
typedef struct reported_name {
    const char *name, *what;
    struct reported_name *next;
} reported_name;

/// State of reading a part of a case.
typedef struct case_reader {
    memory_arena *arena;
    whirl_problems *problems;
    const parameter_table *parameters; ///< parameters that expressions may use
    size_t expression_bytes;           ///< characters of expressions so far
    bool no_memory;
    reported_name *reported;
} case_reader;

/// Returns true the first time a wrong name is found: `what` it should be ("parameter", "station", or a unit).
/// Compilers do the same with undeclared names.
bool reader_reports(case_reader *reader, const char *what, const char *name);

/// Returns the status of a finished reading: the first problem, or WHIRL_NO_MEMORY. `name` is the file's.
whirl_status reader_outcome(const case_reader *reader, const char *name);

/// Reads `parameters:`; `where` may be NULL. Names of overrides must exist in the case.
void parameters_read(case_reader *reader, const file_node *where, const parameter_override *overrides,
                     size_t override_count, parameter_table *result);

/// Returns the index of a parameter; `count` if there is none.
size_t parameters_find(const parameter_table *parameters, const char *name);

/// Reads a number of `key` at a place of the file: with a unit, plain, or an expression. Returns false after a problem.
bool formula_read(case_reader *reader, const file_node *where, const whirl_key *key, number_formula *result);

/// Returns the parameter that is the whole of a formula, or NULL.
const parameter *formula_parameter(const parameter_table *parameters, const number_formula *formula);

/// Checks the value of a formula as whirl_key_check_number does. The message for a single parameter has its written
/// unit: "is -100 rpm, expected a number above 0 rpm".
whirl_status formula_check(const parameter_table *parameters, const whirl_key *key, const number_formula *formula,
                           double value);

/// Returns true if a number has a unit: its own, or that of the parameter that is its whole expression.
bool formula_has_unit(const case_reader *reader, const char *text);

/// Returns the unit that values of a parameter must have: its own or, for an expression, that of the key that uses it.
/// "" if both are unknown.
const char *parameter_expected_unit(const parameter *item);

/// Returns the unit of an expression that is only the name of a parameter ("1" for a plain parameter); "" for others.
const char *expression_unit(const parameter_table *parameters, const char *expression);

/// Returns the unit in which a number is written (its own, or that of the parameter that is its whole expression), and
/// the unit's size in SI; `expected` as in quantity_read. Size 0 if there is none, or it has an offset, like degrees
/// Celsius.
whirl_unit formula_unit(const parameter_table *parameters, const char *text, const char *expected);

/// Rejects plain numbers for angles beyond a full turn: they would be radians, and degrees were probably meant. Then
/// `why` is "is 270 rad without a unit, ...".
bool angle_is_likely(const whirl_key *key, double number, char why[WHY_SIZE]);

/// Values of all parameters for one machine. Cheap; one for every thread.
typedef struct valuation {
    const parameter_table *parameters;
    expression_evaluator *evaluator; ///< made when it is first needed
    double values[PARAMETERS_MAX];
    parameter_set changed; ///< parameters that may differ from the case
    size_t culprit;        ///< the parameter whose value failed in valuation_open, or PARAMETERS_MAX
} valuation;

/// Writes a value of a parameter, "90 um", in the unit in which the case writes it, else in SI.
void value_text(const parameter_table *parameters, const char *name, double value, char *text, size_t size);

/// Writes the given values as "a = 1 mm, b = 2 and c = 3".
void given_text(const parameter_table *parameters, const whirl_given *given, size_t count, char *text, size_t size);

/// Evaluates all parameters, with those `given` [count] at their values, the others as in the case. WHIRL_BAD_INPUT for
/// an unknown name or a value that is not finite. Close it with valuation_close, after a failure too.
whirl_status valuation_open(valuation *v, const parameter_table *parameters, const whirl_given *given, size_t count);
void valuation_close(valuation *v);

/// Evaluates a formula.
whirl_status valuation_number(valuation *v, const number_formula *formula, double *number);

/// Stores the values that formulas have with the case's own parameters, so that machines that do not change these
/// parameters need no evaluation.
void formula_settle(valuation *v, number_formula *formula);
void parameters_settle(valuation *v, parameter_table *parameters);

#endif
