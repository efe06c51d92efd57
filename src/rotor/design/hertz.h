/// Contacts of rolling elements of steel: the pressure up to which they count as elastic, and the load that causes this
/// pressure.
#ifndef ROTOR_HERTZ_H
#define ROTOR_HERTZ_H

/// Pressure in the middle of the contact, Pa, up to which it counts as elastic: the permanent dent is then at most 1e-4
/// of a rolling element's diameter. It is that of the static load ratings of ball and roller bearings, ISO 76.
#define HERTZ_MAX_BALL 4.2e9
#define HERTZ_MAX_ROLLER 4.0e9

/// Returns the load that causes this pressure between a ball and the inner race, N. Diameter of the ball and radius of
/// the race are in m; groove: radius of the race's groove divided by the ball's diameter (usually 0.52).
double hertz_ball_load(double diameter, double race, double groove);

/// Returns the load that causes this pressure on a roller, N. The roller's length follows from its stiffness between
/// both races, N/m^(10/9) (Palmgren 1959).
double hertz_roller_load(double diameter, double race, double stiffness);

#endif
