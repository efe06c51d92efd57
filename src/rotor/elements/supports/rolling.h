/// Rolling bearings: definitions shared by both compilations of their kernel (rolling_bearing.c, rolling_dents.c).
#ifndef ROTOR_ROLLING_H
#define ROTOR_ROLLING_H

#include "element.h"

/// Dents: of the inner race, the outer race, one rolling element.
enum { DENT_INNER, DENT_OUTER, DENT_BALL, DENTS };

/// C in newtons by length scales to the power of the law; g_0 in length scales; theta_0; the cosine and sine of the
/// angle between rolling elements. Of an oblique contact, in length scales: the distance A of the centres of both
/// grooves, its part along the radius, the square of that along the axis, and by how much the square of their sum
/// exceeds A^2, all with the shaft in the middle. By tau: the slopes of the states, which are the cage's and where
/// there is a dent that of what it is in; and the speeds themselves of inner race, outer race and a rolling element
/// about its own axis, seen from the cage (0: not known). Of dents: depths in length scales, 2 pi over the widths, the
/// cosine of half a width; where those of the races stand at the start. How far a rolling element is pressed in where
/// it or its races begin to yield, 0 where sizes are not known.
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

/// Law: number of rolling elements in the cage, and bits for other structure.
enum { ROLLING_COUNT = 0xfff, ROLLING_LINE = 0x1000, ROLLING_OBLIQUE = 0x2000, ROLLING_BALL_DENT = 0x4000 };

/// States: the angle of the cage; with dents those of the inner race, of the outer one and of a rolling element, too.
enum { ROLLING_STATES = 1, DENTED_STATES = 4 };

extern const element_kernels *const dented_kernels[VECTOR_ISAS];

#endif
