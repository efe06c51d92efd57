/// Doubts that several elements have, in the values of keys.
#ifndef ROTOR_DOUBTS_H
#define ROTOR_DOUBTS_H

#include "element.h"

/// Of what turns or moves in a film of oil: of a clearance that is far from a thousandth of the radius,
/// and of a radius that none has.
void doubt_clearance(const doubt_teller *to, const char *key, double clearance, double radius);

/// Of a film whose law leaves out the flow around it: of one that is longer than its radius. `instead` ends the
/// sentence.
void doubt_length(const doubt_teller *to, const char *key, double length, double radius, const char *instead);

/// Of a film by its Reynolds number rho Omega R c/mu, whose law is for laminar or for turbulent flow, and has the
/// other. Gives whether the flow is turbulent.
bool doubt_flow(const doubt_teller *to, double reynolds, double radius, double clearance, bool turbulent_law);

#endif
