/// The equilibrium of the bearings alone, on stations of 1 kg (WHIRL_BEARINGS_OF_IT).
#ifndef ANALYZE_CRITICAL_SPEEDS_H
#define ANALYZE_CRITICAL_SPEEDS_H

#include "whirl/engine/system.h"

/// Sets x to the machine's equilibrium `rest`: places of stations and states of its bearings, for a system of the
/// bearings alone.
void bearings_place(const whirl_system *alone, double *x, const whirl_system *machine, const double *rest);

#endif
