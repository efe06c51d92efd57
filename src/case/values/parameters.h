/// Named parameters, and values that follow from them.
#ifndef CASE_PARAMETERS_H
#define CASE_PARAMETERS_H

#include "arena.h"
#include "tree.h"
#include "whirl/engine/case.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/engine/system.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// ---------------------------------------------------------------- quantity
// Numbers with units: "12 mm", "6207 rpm", "18 mPa.s". Everything inside whirl is in SI.

enum { WHY_SIZE = 240 };

typedef struct quantity {
    double value;               ///< in SI
    char unit[WHIRL_NAME_SIZE]; ///< the SI unit, "1" without one
} quantity;

/// Reads a number, or a number, a space and a unit. `expected` is the unit it must convert to ("1": a plain number), or
/// "" for any. Plain numbers are in SI. On failure `why` is the reason: "is 3 kg, expected a number in N s/m".
bool quantity_read(const char *text, const char *expected, quantity *result, char why[WHY_SIZE]);

/// Returns true if a value in SI unit `unit` is allowed where `expected` is required; if not, `why` continues "is in
/// s-1, ".
bool quantity_fits(const char *unit, const char *expected, char why[WHY_SIZE]);

/// Powers of m, kg and s in an SI unit ("N/m": 0, 1, -2). Returns false if it is no unit; all powers are 0 for "1" and
/// "".
enum { UNIT_BASES = 3 };
bool quantity_unit_powers(const char *unit, double powers[UNIT_BASES]);

/// Reads a plain number that ends at *end. No hexadecimal, no nan, no inf, no locale. Returns false if there is none;
/// overflow gives an infinite value.
bool quantity_number(const char *text, double *value, const char **end);

// ---------------------------------------------------------------- expression
// Expressions over parameters: "r_k*k2", by muParser.

enum { EXPRESSION_MAX_LENGTH = 500, EXPRESSION_MAX_DEPTH = 50 };

/// Callback for every name in an expression that is neither a function nor a constant; returns false for an unknown
/// name.
typedef bool (*expression_name_fn)(void *context, const char *name, size_t length);

/// Checks all that needs no values: length, depth, characters, names. On failure `why` is the reason; after an unknown
/// name it is empty, for the caller to fill.
bool expression_check(const char *text, expression_name_fn known, void *context, char why[WHY_SIZE]);

/// The functions and constants that expressions know; ended by NULL.
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

// ---------------------------------------------------------------- dimension
// Dimension of an expression's value.

typedef enum value_dimension {
    DIMENSION_PLAIN,   ///< the same in all units; also 0, and expressions without a value
    DIMENSION_OF_UNIT, ///< the dimension of the unit in question
    DIMENSION_OTHER
} value_dimension;

/// Finds the dimension of an expression over parameters that were read without a problem, compared with an SI unit.
value_dimension expression_dimension(const parameter_table *parameters, const char *expression, const char *unit);

#endif
