/// Spectra of samples at equal angles, of computed motions and of measured ones.
#ifndef ANALYZE_SPECTRUM_H
#define ANALYZE_SPECTRUM_H

#include <stddef.h>

#include "whirl/engine/analyze.h"

/// Numbers of a row: order, x, y, forward, backward.
enum { SPECTRUM_COLUMNS = 5 };

/// Bins 0 ... of a record up to an order, below half the sampling frequency.
size_t spectrum_bins(size_t revolutions, size_t samples_per_revolution, double highest_order);

/// The spectrum of two coordinates [count] over whole revolutions; as whirl_spectrum_new.
whirl_status spectrum_of(const double *x, const double *y, size_t count, size_t samples_per_revolution,
                         double highest_order, whirl_spectrum **spectrum);

/// A row for every line [line_count][SPECTRUM_COLUMNS], and for every bin [count][SPECTRUM_COLUMNS] unless NULL.
void spectrum_rows(const whirl_spectrum *spectrum, double *lines, double *bins);

#endif
