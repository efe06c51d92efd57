/// The synchronous (1X) part of a motion: amplitude and phase of the sinusoid that goes once round with the shaft.
#ifndef ANALYZE_SYNCHRONOUS_H
#define ANALYZE_SYNCHRONOUS_H

#include <stddef.h>

#include "transform.h"
#include "whirl/internal/spectrum.h"

/// Returns the synchronous (1X) part of a record with `samples_per_revolution`, whose first sample is one step after
/// the mark. size: the largest displacement. An amplitude below 1e-12 of it is rounding and has no phase.
whirl_synchronous synchronous_part(const wave_transform *wave, size_t samples_per_revolution, double size);

/// Finds the synchronous part of a motion Re(x e^(i tau)), Re(y e^(i tau)); lags of parts below 1e-12 of `size` are
/// NaN.
whirl_synchronous synchronous_of(double complex x, double complex y, double size);

/// Returns the synchronous part of a station at rest: no amplitudes, and no phases.
whirl_synchronous synchronous_none(void);

#endif
