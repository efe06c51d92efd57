/// How a pad lies before a journal in the middle of its bearing.
#ifndef ROTOR_CENTRED_H
#define ROTOR_CENTRED_H

#include "whirl/engine/bearing.h"

/// The tilt, R delta/c, at which its film holds it, by a coarse grid; 0 where none does, or without memory.
double pad_centred_tilt(const whirl_pad *pad, double ratio, bool gumbel);

#endif
