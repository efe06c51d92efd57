/// Tilt of a pad around a centred journal.
#ifndef ROTOR_PAD_CENTRED_H
#define ROTOR_PAD_CENTRED_H

#include "whirl/internal/bearing.h"

#include <stdbool.h>

/// Returns the tilt R delta/c at which the film's moment on a pad vanishes, from a coarse grid; 0 if there is none, or
/// without memory.
double pad_centred_tilt(const whirl_pad *pad, double ratio, bool gumbel);

#endif
