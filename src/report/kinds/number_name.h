/// Names and units of the numbers of points that tolerances and sensitivities show (whirl/engine/spread.h).
#ifndef REPORT_NUMBER_NAME_H
#define REPORT_NUMBER_NAME_H

#include "whirl/engine/result.h"
#include "whirl/engine/spread.h"
#include "whirl/internal/shown.h"

enum { NUMBER_NAME_SIZE = 5 * WHIRL_NAME_SIZE };

/// Writes the name of a number: "major of unbalance axes at disc".
void number_name(const whirl_table *table, const whirl_spread_of *of, char text[NUMBER_NAME_SIZE]);

/// Returns the unit in which a number is shown: shown number = number in SI / size of the unit.
whirl_unit number_unit(const whirl_shown_units *units, const whirl_table *table, const whirl_spread_of *of);

#endif
