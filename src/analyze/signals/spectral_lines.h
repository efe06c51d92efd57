/// Lines of a spectrum: frequency and amplitude of the sinusoids in a Hann-windowed signal, between the bins.
#ifndef ANALYZE_SPECTRAL_LINES_H
#define ANALYZE_SPECTRAL_LINES_H

#include <stddef.h>

#include "transform.h"
#include "whirl/internal/spectrum.h"

/// Finds up to WHIRL_MAX_LINES lines of a Hann-windowed signal, largest first, with `order` in bins. `power` [bins] is
/// the squared amplitude at the whole bins 0, 1, ...; lines are searched from bin 2 (lower ones are indistinguishable
/// from the mean) to bins - 2. Returns their number.
size_t spectrum_lines(const wave_transform *wave, const double *power, size_t bins, whirl_line *lines);

/// Returns the zero-to-peak amplitudes of the sinusoids of an order.
whirl_line spectrum_line(double order, wave_amplitudes at);

#endif
