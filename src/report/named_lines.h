/// Names lines of spectra by the orders that parts of the machine have.
#ifndef REPORT_NAMED_LINES_H
#define REPORT_NAMED_LINES_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/system.h"

enum { LINE_NAME_SIZE = 48 };

/// Finds the name of a line at a station, "BPFO", "2 BPFO" or "BPFI - 1X", and the part of the machine that has this
/// order (`of`). Of several names that fit it takes the simplest: an order itself, then its multiples, then a sideband
/// of one revolution; of equally simple ones the name of a part at the station. Returns false if the line has no name.
bool named_line(const whirl_system *system, double order, size_t station, char name[LINE_NAME_SIZE],
                whirl_named_order *of);

#endif
