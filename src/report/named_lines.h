// Lines of spectra by the names that the machine has for their orders.
#ifndef REPORT_NAMED_LINES_H
#define REPORT_NAMED_LINES_H

#include "whirl/engine/system.h"

enum { LINE_NAME_SIZE = 48 };

/// The name of a line at a station, "BPFO", "2 BPFO" or "BPFI - 1X", and whose it is; of equal orders those of parts at
/// the station come first, then single ones, multiples, and sidebands of one revolution. False where it has none.
bool named_line(const whirl_system *system, double order, size_t station, char name[LINE_NAME_SIZE],
                whirl_named_order *of);

#endif
