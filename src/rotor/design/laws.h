/// Laws that elements use when a machine is designed: seals, contacts, oils, tables, ranges.
#ifndef ROTOR_LAWS_H
#define ROTOR_LAWS_H

#include "element.h"

// ---------------------------------------------------------------- black
// A plain annular seal by its geometry, short and turbulent (Black 1969; Black, Jenssen 1970).

/// Geometry of the seal, SI. `pressure` is the drop over the seal, `loss` that at its inlet over rho V^2/2 (without the
/// velocity head itself), `swirl` the circumferential speed of the entering fluid over that of the shaft's surface.
typedef struct black_seal {
    double radius, length, clearance, density, viscosity, pressure, loss, swirl;
} black_seal;

/// Coefficients in a frame that turns with the fluid, at `ratio` of the shaft's speed; mean axial velocity; Reynolds
/// number 2 rho c |velocity|/mu of that and half the surface's speed; torque of the walls' shear on the shaft.
typedef struct black_coefficients {
    double stiffness, damping, mass, ratio, velocity, reynolds, shear;
} black_coefficients;

/// Computes the coefficients at a speed of the shaft, rad/s, >= 0.
black_coefficients black_find(const black_seal *seal, double speed);

// ---------------------------------------------------------------- doubts
// Doubts about values that several elements share.

/// Doubts an oil film's clearance that is far from a thousandth of the radius, and a radius that no machine has.
void doubt_clearance(const doubt_teller *to, const char *key, double clearance, double radius);

/// Doubts the length of a film, longer than its radius, whose law ignores circumferential flow. `instead` ends the
/// sentence.
void doubt_length(const doubt_teller *to, const char *key, double length, double radius, const char *instead);

/// Doubts a film whose law is for laminar or turbulent flow while the Reynolds number rho Omega R c/mu indicates the
/// other. Returns true if the flow is turbulent.
bool doubt_flow(const doubt_teller *to, double reynolds, double radius, double clearance, bool turbulent_law);

// ---------------------------------------------------------------- hertz
// Contacts of rolling elements of steel: the pressure up to which they are elastic, and the load that causes it.

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

// ---------------------------------------------------------------- oil
// Oil of a film: dynamic or kinematic viscosity, or viscosity by temperature; and density.

/// Keys of oil of an element, in this order.
enum {
    OIL_DYNAMIC,
    OIL_KINEMATIC,
    OIL_DENSITY,
    OIL_GRADE,
    OIL_HOT,
    OIL_TEMPERATURES,
    OIL_VISCOSITIES,
    OIL_TEMPERATURE,
    OIL_SUPPLY_TEMPERATURE, ///< this and the following describe a bearing in documents; no force depends on them
    OIL_SUPPLY_PRESSURE,
    OIL_KEYS
};

/// Rows of tables of keys. A value in cSt requires the density; with one in Pa s it is optional, and is used to check
/// that the film's inertia is negligible.
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
        "temperature of the oil in the film, '50 degC'; with grade or temperatures"),                                  \
    [(first) + OIL_SUPPLY_TEMPERATURE] = NUMBER_KEY("supply_temperature", "", "K", OPTIONAL,                           \
        WHIRL_FROM_TO(233.15, 473.15), "temperature at which oil is supplied; for documents: no force depends on it"), \
    [(first) + OIL_SUPPLY_PRESSURE] = NUMBER_KEY("supply_pressure", "", "Pa", OPTIONAL, WHIRL_NOT_NEGATIVE,            \
        "pressure above ambient at which oil is supplied; for documents: no force depends on it")
// clang-format on

/// The values of these keys.
typedef struct oil {
    const key_value *keys;
} oil;

/// Returns true if they define a viscosity.
bool oil_given(const oil *of);

/// Computes mu in Pa s. WHIRL_BAD_INPUT unless it is given in exactly one way.
whirl_status oil_viscosity(const oil *of, double *viscosity);

/// Returns rho speed length^2/mu; 0 without a density.
double oil_reynolds(const oil *of, double speed, double length);

#endif
