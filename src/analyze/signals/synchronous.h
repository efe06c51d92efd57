/// The synchronous (1X) part of a motion: amplitude and phase of the sinusoid that goes once round with the shaft.
#ifndef ANALYZE_SYNCHRONOUS_H
#define ANALYZE_SYNCHRONOUS_H

#include <stddef.h>

#include "transform.h"
#include "whirl/engine/analyze.h"

/// Of a record of `samples_per_revolution`, whose first sample stands one step after the mark. `size`: the largest
/// displacement that there is, below 1e-12 of which an amplitude is rounding and has no phase.
whirl_synchronous synchronous_part(const wave_transform *wave, size_t samples_per_revolution, double size);

/// Of a station that rests: no amplitudes, and no phases.
whirl_synchronous synchronous_none(void);

#endif
