/// Doubts about values that several elements share.
#ifndef ROTOR_DOUBTS_H
#define ROTOR_DOUBTS_H

#include "element.h"

/// Doubts an oil film's clearance that is far from a thousandth of the radius, and a radius that no machine has.
void doubt_clearance(const doubt_teller *to, const char *key, double clearance, double radius);

/// Doubts the length of a film, longer than its radius, whose law ignores circumferential flow. `instead` ends the
/// sentence.
void doubt_length(const doubt_teller *to, const char *key, double length, double radius, const char *instead);

/// Doubts a film whose law is for laminar or turbulent flow while the Reynolds number rho Omega R c/mu indicates the
/// other. Returns true if the flow is turbulent.
bool doubt_flow(const doubt_teller *to, double reynolds, double radius, double clearance, bool turbulent_law);

#endif
