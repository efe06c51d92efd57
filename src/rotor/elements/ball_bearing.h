/// The numbers of a ball bearing's kernel (ball_bearing_kernel.h); its law is the number of balls.
#ifndef ROTOR_BALL_BEARING_H
#define ROTOR_BALL_BEARING_H

/// C in newtons by length scales to the power 3/2; g_0 in length scales; the cage's speed over the shaft's; theta_0;
/// the cosine and sine of the angle between balls.
enum { BALL_STIFFNESS, BALL_GAP, BALL_RATIO, BALL_START, BALL_APART_COS, BALL_APART_SIN, BALL_NUMBERS };

#endif
