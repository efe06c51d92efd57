/// The oil of a film: its viscosity, dynamic or kinematic or by its temperature, and what inertia it has.
#ifndef ROTOR_OIL_H
#define ROTOR_OIL_H

#include "element.h"

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
        "at 100 degC, of an oil of that grade; absent: of viscosity index 100", "ASTM D2270"),                         \
    [(first) + OIL_TEMPERATURES] = CITED_NUMBERS_KEY("temperatures", "", "K", OPTIONAL, WHIRL_FROM_TO(233.15, 473.15), \
        "rising, at which viscosities are known, between them by Walther's law; in place of grade, with density",      \
        "Walther 1931; ASTM D341"),                                                                                    \
    [(first) + OIL_VISCOSITIES] = CITED_NUMBERS_KEY("viscosities", "", "Pa s", OPTIONAL, WHIRL_POSITIVE,               \
        "at these temperatures", ""),                                                                                  \
    [(first) + OIL_TEMPERATURE] = NUMBER_KEY("temperature", "", "K", OPTIONAL, WHIRL_FROM_TO(233.15, 473.15),          \
        "of the oil in the film, '50 degC'; with grade or temperatures")
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
