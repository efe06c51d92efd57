/// Doubts about values that several kinds of elements share.
#ifndef ROTOR_DOUBTS_H
#define ROTOR_DOUBTS_H

#include "element.h"

/// Raises a doubt about an oil film's clearance that is far from a thousandth of the radius, and about a radius that no
/// machine has.
void doubt_clearance(const doubt_teller *to, const char *key, double clearance, double radius);

/// Raises a doubt about a film longer than its radius whose law ignores circumferential flow. `instead` ends the
/// sentence.
void doubt_length(const doubt_teller *to, const char *key, double length, double radius, const char *instead);

/// Raises a doubt about a film whose law is for laminar flow while the Reynolds number rho Omega R c/mu indicates
/// turbulent flow, or the reverse. Returns true if the flow is turbulent.
bool doubt_flow(const doubt_teller *to, double reynolds, double radius, double clearance, bool turbulent_law);

#endif
