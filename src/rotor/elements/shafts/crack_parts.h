/// Numbers of a crack.
#ifndef ROTOR_CRACK_PARTS_H
#define ROTOR_CRACK_PARTS_H

#include "element.h"

/// Numbers: k, k (d1 + d2)/2 and k (d1 - d2)/2 in newtons per length scale; at tau = 0 cosine and sine of twice the
/// angle of the first axis, and of its angle from the load; in the variant that turns with a shaft of another speed the
/// rate of the phase by tau.
enum {
    CRACK_STIFFNESS,
    CRACK_MEAN_LOSS,
    CRACK_HALF_LOSS,
    CRACK_AXIS_COS,
    CRACK_AXIS_SIN,
    CRACK_LOAD_COS,
    CRACK_LOAD_SIN,
    CRACK_NUMBERS,
    CRACK_RATE = CRACK_NUMBERS,
    CRACK_TURNING_NUMBERS
};

/// The variant that turns with a shaft of another speed.
extern const element_type crack_turning;

/// Sets the numbers of the variant that convert forces to accelerations.
void crack_turning_scale(element *own, const assembly *to);

/// Implements element_type.range of cracks.
bool crack_range(const element *own, size_t index, const element_seen *seen, element_range *out);

#endif
