/// Bent shafts.
#ifndef ROTOR_BOW_H
#define ROTOR_BOW_H

#include "design.h"
#include "mesh.h"

/// Adds the rotating forces that bend a straight shaft to the bow at its stations. WHIRL_BAD_INPUT if a station with a
/// bow is on no shaft of finite elements, or if its shaft has too few of them, another speed, flats or hysteresis.
whirl_status bow_build(const mesh *from, const whirl_design *design, assembly *to);

#endif
