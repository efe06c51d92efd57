/// Contacts of rolling elements of steel: the pressure up to which they are elastic, and the load that causes it.
#ifndef ROTOR_HERTZ_H
#define ROTOR_HERTZ_H

/// Pa in the middle of the contact, at which rolling elements and races keep a dent of 1e-4 of a rolling element's
/// diameter: static load ratings of ball and roller bearings, ISO 76.
#define HERTZ_MAX_BALL 4.2e9
#define HERTZ_MAX_ROLLER 4.0e9

/// Returns the load, N, at that pressure between a ball and the inner race: diameter and radius of the race in m,
/// radius of its groove over the diameter (usually 0.52).
double hertz_ball_load(double diameter, double race, double groove);

/// Returns the load on a roller, whose length follows from its stiffness between both races, N/m^(10/9) (Palmgren
/// 1959).
double hertz_roller_load(double diameter, double race, double stiffness);

#endif
