/// Lines of a spectrum: frequency and amplitude of the sinusoids in a Hann-windowed signal, between the bins.
#ifndef ANALYZE_LINES_H
#define ANALYZE_LINES_H

#include <stddef.h>

#include "whirl/analyze.h"

/// Two coordinates [count], the mean removed, times the Hann window sin^2(pi j/count).
typedef struct windowed_pair {
    size_t count;
    const double *x, *y;
} windowed_pair;

/// Finds up to WHIRL_MAX_LINES lines, largest first, with `order` in bins. `power` [bins] is the squared amplitude at
/// the whole bins 0, 1, ...; lines are looked for from bin 2 (below, they cannot be told from the mean) to bins - 2.
/// Returns how many there are.
size_t spectrum_lines(const windowed_pair *signal, const double *power, size_t bins, whirl_line *lines);

#endif
