/// What laws of elements need when a machine is designed: seals, contacts, oils, tables, ranges.
#ifndef ROTOR_LAWS_H
#define ROTOR_LAWS_H

#include "element.h"

// ---------------------------------------------------------------- black
// A plain annular seal by its geometry, short and turbulent (Black 1969; Black, Jenssen 1970).

/// SI. `pressure` is what drops over the seal, `loss` that at its inlet over rho V^2/2 (without the velocity head
/// itself), `swirl` the speed around the shaft with which fluid enters over that of the shaft's surface.
typedef struct black_seal {
    double radius, length, clearance, density, viscosity, pressure, loss, swirl;
} black_seal;

/// What seen from the fluid, which turns at `ratio` of the shaft's speed, is a spring, a damper and a mass; the mean
/// axial velocity, and the Reynolds number 2 rho c |velocity|/mu of that and half the surface's speed.
typedef struct black_coefficients {
    double stiffness, damping, mass, ratio, velocity, reynolds;
} black_coefficients;

/// At a speed of the shaft, rad/s, >= 0.
black_coefficients black_find(const black_seal *seal, double speed);

// ---------------------------------------------------------------- doubts
// Doubts that several elements have, in the values of keys.

/// Of what turns or moves in a film of oil: of a clearance that is far from a thousandth of the radius,
/// and of a radius that none has.
void doubt_clearance(const doubt_teller *to, const char *key, double clearance, double radius);

/// Of a film whose law leaves out the flow around it: of one that is longer than its radius. `instead` ends the
/// sentence.
void doubt_length(const doubt_teller *to, const char *key, double length, double radius, const char *instead);

/// Of a film by its Reynolds number rho Omega R c/mu, whose law is for laminar or for turbulent flow, and has the
/// other. Gives whether the flow is turbulent.
bool doubt_flow(const doubt_teller *to, double reynolds, double radius, double clearance, bool turbulent_law);

// ---------------------------------------------------------------- hertz
// Contacts of rolling elements of steel: the pressure up to which they are elastic, and the load that causes it.

/// Pa in the middle of the contact, at which rolling elements and races keep a dent of 1e-4 of a rolling element's
/// diameter: static load ratings of ball and roller bearings, ISO 76.
#define HERTZ_MAX_BALL 4.2e9
#define HERTZ_MAX_ROLLER 4.0e9

/// The load, N, at that pressure between a ball and the inner race: diameter and radius of the race in m, radius of its
/// groove over the diameter (0.52 as a rule).
double hertz_ball_load(double diameter, double race, double groove);

/// The same of a roller, whose length follows from its stiffness between both races, N/m^(10/9) (Palmgren 1959).
double hertz_roller_load(double diameter, double race, double stiffness);

// ---------------------------------------------------------------- oil
// The oil of a film: its viscosity, dynamic or kinematic or by its temperature, and what inertia it has.

/// An element's keys of oil, from the first on in this order.
enum {
    OIL_DYNAMIC,
    OIL_KINEMATIC,
    OIL_DENSITY,
    OIL_GRADE,
    OIL_HOT,
    OIL_TEMPERATURES,
    OIL_VISCOSITIES,
    OIL_TEMPERATURE,
    OIL_KEYS
};

/// Rows of tables of keys. What is given in cSt needs the density; what is given in Pa s may have it, and the film is
/// looked at then whether its inertia may be left out.
// clang-format off
#define OIL_ROWS(first, text)                                                                                          \
    [(first) + OIL_DYNAMIC] = NUMBER_KEY("viscosity", "mu", "Pa s", OPTIONAL, WHIRL_POSITIVE, text),                   \
    [(first) + OIL_KINEMATIC] = NUMBER_KEY("kinematic_viscosity", "nu", "m2/s", OPTIONAL, WHIRL_POSITIVE,              \
        "kinematic viscosity of the oil, in place of viscosity; with its density"),                                    \
    [(first) + OIL_DENSITY] = NUMBER_KEY("density", "rho", "kg/m3", OPTIONAL, WHIRL_POSITIVE, "density of the oil"),   \
    [(first) + OIL_GRADE] = CITED_NUMBER_KEY("grade", "ISO VG", "1", OPTIONAL, WHIRL_FROM_TO(6.5, 1500),               \
        "viscosity class of the oil, mm2/s at 40 degC, in place of viscosity; with temperature and density",           \
        "ISO 3448; Walther 1931"),                                                                                     \
    [(first) + OIL_HOT] = CITED_NUMBER_KEY("kinematic_100", "", "m2/s", OPTIONAL, WHIRL_POSITIVE,                      \
        "kinematic viscosity at 100 degC of an oil of that grade; absent: that of viscosity index 100", "ASTM D2270"), \
    [(first) + OIL_TEMPERATURES] = CITED_NUMBERS_KEY("temperatures", "", "K", OPTIONAL, WHIRL_FROM_TO(233.15, 473.15), \
        "rising temperatures of known viscosities, with Walther's law between them; in place of grade, with density",  \
        "Walther 1931; ASTM D341"),                                                                                    \
    [(first) + OIL_VISCOSITIES] = CITED_NUMBERS_KEY("viscosities", "", "Pa s", OPTIONAL, WHIRL_POSITIVE,               \
        "viscosities at these temperatures", ""),                                                                      \
    [(first) + OIL_TEMPERATURE] = NUMBER_KEY("temperature", "", "K", OPTIONAL, WHIRL_FROM_TO(233.15, 473.15),          \
        "temperature of the oil in the film, '50 degC'; with grade or temperatures")
// clang-format on

/// The values of these keys.
typedef struct oil {
    const key_value *keys;
} oil;

/// Whether they say a viscosity.
bool oil_given(const oil *of);

/// mu in Pa s. WHIRL_BAD_INPUT where it is not given in one way.
whirl_status oil_viscosity(const oil *of, double *viscosity);

/// rho speed length^2/mu; 0 where the density is not known.
double oil_reynolds(const oil *of, double speed, double length);

#endif
