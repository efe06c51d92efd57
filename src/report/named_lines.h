/// Lines of spectra by the names that the machine has for their orders.
#ifndef REPORT_NAMED_LINES_H
#define REPORT_NAMED_LINES_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/system.h"

enum { LINE_NAME_SIZE = 48 };

/// Finds the name of a line at a station, "BPFO", "2 BPFO" or "BPFI - 1X", and its part. Among equal orders parts at
/// the station come first, then plain orders, multiples, and sidebands of one revolution. Returns false if it has no
/// name.
bool named_line(const whirl_system *system, double order, size_t station, char name[LINE_NAME_SIZE],
                whirl_named_order *of);

#endif
