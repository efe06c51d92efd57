/// Rolling bearings: definitions that both compilations of their kernel share (rolling_bearing.c, rolling_dents.c).
#ifndef ROTOR_ROLLING_H
#define ROTOR_ROLLING_H

#include "element.h"

/// Dents: of the inner race, of the outer race, of one rolling element.
enum { DENT_INNER, DENT_OUTER, DENT_BALL, DENTS };

/// Numbers: C in newtons by length scales to the power of the law; g_0 in length scales; theta_0; cosine and sine of
/// the angle between rolling elements.
///
/// For oblique contacts, in length scales and with the shaft in the middle: the distance A of the centres of both
/// grooves, its part along the radius, the square of its part along the axis, and the excess of the sum of both squares
/// over A^2.
///
/// By tau: the slopes of the states (the angle of the cage and, with dents, of the dented parts); then the speeds of
/// inner race, outer race and a rolling element about its own axis, relative to the cage (0: unknown).
///
/// For dents: depths in length scales, 2 pi divided by the widths, cosines of half the widths, and the angles of the
/// races' dents at the start. Last the compression of a rolling element at which it or its races begin to yield; 0 if
/// sizes are unknown.
enum {
    ROLLING_STIFFNESS,
    ROLLING_GAP,
    ROLLING_START,
    ROLLING_APART_COS,
    ROLLING_APART_SIN,
    ROLLING_CENTRES,
    ROLLING_RADIAL,
    ROLLING_AXIAL_SQUARE,
    ROLLING_SPARE,
    ROLLING_RATES,
    ROLLING_SPEEDS = ROLLING_RATES + 1 + DENTS,
    ROLLING_DEPTH = ROLLING_SPEEDS + DENTS,
    ROLLING_OVER_WIDTH = ROLLING_DEPTH + DENTS,
    ROLLING_EDGE = ROLLING_OVER_WIDTH + DENTS,
    ROLLING_DENT_START = ROLLING_EDGE + DENTS,
    ROLLING_YIELD = ROLLING_DENT_START + DENT_BALL,
    ROLLING_NUMBERS
};

/// The law: number of rolling elements in the cage, and bits: rollers, oblique contacts, a dent of a rolling element.
enum { ROLLING_COUNT = 0xfff, ROLLING_LINE = 0x1000, ROLLING_OBLIQUE = 0x2000, ROLLING_BALL_DENT = 0x4000 };

/// Number of states: the angle of the cage; with dents also the angles of the inner race, of the outer race and of a
/// rolling element.
enum { ROLLING_STATES = 1, DENTED_STATES = 4 };

extern const element_kernels *const dented_kernels[VECTOR_ISAS];

#endif
