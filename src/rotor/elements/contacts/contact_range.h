/// Range of the laws of contact, which hold for small contacts.
#ifndef ROTOR_CONTACT_RANGE_H
#define ROTOR_CONTACT_RANGE_H

#include "element.h"

/// Describes the range of a stator at `gap` around a surface of `radius` (0: unknown, no range). By Hertz the ratio of
/// the contact's width to the radius is sqrt(depth/radius): a tenth at the limit.
static inline bool contact_range(double gap, double radius, size_t index, const element_seen *seen,
                                 element_range *out) {
    const double depth = seen->radius - gap;
    *out = (element_range){"depth over radius", "1", "to which a contact is small", 0.01, 0.0};
    out->reached = depth < 0.0 ? 0.0 : depth / radius;
    return index == 0 && radius > 0.0;
}

#endif
