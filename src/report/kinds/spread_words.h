/// Names and units of numbers whose spread over samples is shown (whirl/engine/spread.h).
#ifndef REPORT_SPREAD_WORDS_H
#define REPORT_SPREAD_WORDS_H

#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"
#include "whirl/engine/spread.h"

enum { SPREAD_NAME = 5 * WHIRL_NAME_SIZE, SPREAD_VERDICTS = 32 };

/// Writes the name of a number: "major of unbalance axes at disc".
void spread_name(const whirl_table *table, const whirl_spread_of *of, char text[SPREAD_NAME]);

/// Returns the unit in which a number is shown: shown number = number in SI / size of the unit.
whirl_unit spread_unit(const whirl_shown_units *units, const whirl_table *table, const whirl_spread_of *of);

/// Lists the different verdicts of a table, in the order of their first points; returns their number.
size_t spread_verdicts(const whirl_table *table, whirl_verdict verdicts[SPREAD_VERDICTS]);

#endif
