/// Spectra of samples at equal angles, of computed motions and of measured ones.
#ifndef ANALYZE_SPECTRUM_H
#define ANALYZE_SPECTRUM_H

#include "whirl/internal/spectrum.h"

#include <stdbool.h>
#include <stddef.h>

/// Columns of a row: order, x, y, forward, backward.
enum { SPECTRUM_COLUMNS = 5 };

/// Returns the number of bins of a record up to an order, and below half the sampling frequency.
size_t spectrum_bins(size_t revolutions, size_t samples_per_revolution, double highest_order);

/// Makes the spectrum of two coordinates [count] over whole revolutions; as whirl_spectrum_new. further: lines may lie
/// above the highest order.
whirl_status spectrum_of(const double *x, const double *y, size_t count, size_t samples_per_revolution,
                         double highest_order, bool further, whirl_spectrum **spectrum);

/// Writes a row for every line [line_count][SPECTRUM_COLUMNS] and, unless NULL, for every bin
/// [count][SPECTRUM_COLUMNS].
void spectrum_rows(const whirl_spectrum *spectrum, double *lines, double *bins);

#endif
