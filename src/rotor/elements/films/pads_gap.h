/// Gaps between pads and their journal. Included by the scalar builds of elements with pads.
#ifndef ROTOR_PADS_GAP_H
#define ROTOR_PADS_GAP_H

#include <math.h>

/// Returns the least film thickness of a pad in units of its clearance, with the journal at (x, y) in the frame of the
/// pad's middle. The film is thinnest at an edge or, if the direction of the journal's displacement is between the
/// edges, there.
static inline double pads_thinnest(const double *pad, double x, double y) {
    const double cosine = pad[PAD_HALF_COSINE], half = acos(cosine);
    const double edges = fmin(1.0 - x * cosine - y * sin(half), 1.0 - x * cosine + y * sin(half));
    return fabs(atan2(y, x)) < half ? fmin(edges, 1.0 - hypot(x, y)) : edges;
}

/// Computes the journal's position relative to its housing, in units of the pads' clearance, mirrored for a shaft that
/// turns clockwise.
static inline void pads_journal(const element *own, const double *q, double out[2]) {
    const double over = own->number[PADS_OVER_CLEARANCE];
    out[0] = over * (q[0] - q[2]);
    out[1] = own->number[PADS_SIGN] * over * (q[1] - q[3]);
}

/// Computes the journal's position in the frame of the middle of a pad that does not tilt.
static inline void pads_in_frame(const double *pad, const double journal[2], double out[2]) {
    const double c = pad[PAD_COSINE], s = pad[PAD_SINE];
    out[0] = c * journal[0] + s * journal[1] + pad[PAD_SHIFT_X];
    out[1] = c * journal[1] - s * journal[0] + pad[PAD_SHIFT_Y];
}

#endif
