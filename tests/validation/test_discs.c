// Discs that tilt: an overhung wheel against the closed form of Stodola and Green, and a rotor of three discs against
// equations written out and integrated by another method.
#include <complex.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "support.h"
#include "support_rotor.h"
#include "whirl/whirl.h"
