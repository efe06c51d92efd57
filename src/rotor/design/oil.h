/// Oil of a film: its dynamic or kinematic viscosity, or viscosity by temperature, and its density.
#ifndef ROTOR_OIL_H
#define ROTOR_OIL_H

#include "element.h"

/// Keys of an element for its oil, in this order.
enum {
    OIL_DYNAMIC,
    OIL_KINEMATIC,
    OIL_DENSITY,
    OIL_GRADE,
    OIL_HOT,
    OIL_TEMPERATURES,
    OIL_VISCOSITIES,
    OIL_TEMPERATURE,
    OIL_SUPPLY_TEMPERATURE, ///< this key and the next describe a bearing in documents; no force depends on them
    OIL_SUPPLY_PRESSURE,
    OIL_KEYS
};

/// Rows of the tables of keys. A viscosity in cSt requires the density. With a viscosity in Pa s the density is
/// optional, and serves to check that the film's inertia is negligible.
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

/// Returns true if the keys define a viscosity.
bool oil_given(const oil *of);

/// Computes the dynamic viscosity, Pa s. WHIRL_BAD_INPUT unless it is given in exactly one way.
whirl_status oil_viscosity(const oil *of, double *viscosity);

/// Returns the Reynolds number rho speed length^2/mu, or 0 without a density.
double oil_reynolds(const oil *of, double speed, double length);

#endif
