/// Shafts that are bent and turn so.
#ifndef ROTOR_BOW_H
#define ROTOR_BOW_H

#include "mesh.h"

/// Adds the forces that turn with a shaft whose stations have a bow: those that bend a straight one so. WHIRL_BAD_INPUT
/// where a station with a bow lies on no shaft of finite elements, a shaft has too few of them, another speed, flats or
/// hysteresis.
whirl_status bow_build(const mesh *from, const whirl_design *design, assembly *to);

#endif
