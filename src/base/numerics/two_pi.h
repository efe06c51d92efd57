/// A full turn in radians.
#ifndef BASE_TWO_PI_H
#define BASE_TWO_PI_H

static const double two_pi = 6.283185307179586476925;

#endif
