// Dimension of an expression's value. It is measured: with every parameter in units half as large, lengths double and
// areas quadruple. A value that is neither a product of units nor a plain number ("1 + c" with a length c) changes by
// another factor.
#include "dimension.h"
#include "parameters.h"
#include "quantity.h"

#include <math.h>
#include <string.h>

/// Tolerance for powers: expressions are evaluated in double precision.
static const double TOLERANCE = 1e-6;

/// Evaluates the expression with one base unit half as large. Returns false if it has no value.
static bool value_in(const parameter_table *parameters, const char *expression, size_t base, double *value) {
    valuation v;
    bool done = valuation_open(&v, parameters, NULL, 0).code == WHIRL_OK;
    memset(&v.changed, 0xff, sizeof v.changed); // all parameters count as changed
    for (size_t i = 0; i < parameters->count && done; i++) {
        const parameter *item = &parameters->items[parameters->order[i]];
        double powers[UNIT_BASES];
        double *const number = &v.values[parameters->order[i]];
        if (item->value.expression) // it follows from earlier parameters
            done = valuation_number(&v, &item->value, number).code == WHIRL_OK;
        else if (base < UNIT_BASES && quantity_unit_powers(item->unit, powers))
            *number *= exp2(powers[base]);
    }
    const number_formula formula = {.expression = expression};
    done = done && valuation_number(&v, &formula, value).code == WHIRL_OK;
    valuation_close(&v);
    return done;
}

value_dimension expression_dimension(const parameter_table *parameters, const char *expression, const char *unit) {
    double wanted[UNIT_BASES], value, changed;
    bool plain = true, fits = quantity_unit_powers(unit, wanted);
    if (!value_in(parameters, expression, UNIT_BASES, &value) || value == 0.0) return DIMENSION_PLAIN;
    for (size_t base = 0; base < UNIT_BASES; base++) {
        if (!value_in(parameters, expression, base, &changed)) return DIMENSION_OTHER;
        const double power = log2(changed / value); // NaN where the sign changes
        plain = plain && fabs(power) < TOLERANCE;
        fits = fits && fabs(power - wanted[base]) < TOLERANCE;
    }
    return plain ? DIMENSION_PLAIN : fits ? DIMENSION_OF_UNIT : DIMENSION_OTHER;
}
