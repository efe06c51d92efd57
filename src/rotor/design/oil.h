/// The oil of a film: its viscosity, dynamic or kinematic, and what inertia it has.
#ifndef ROTOR_OIL_H
#define ROTOR_OIL_H

#include "element.h"

/// Rows of tables of keys. What is given in cSt needs the density; what is given in Pa s may have it, and the film is
/// looked at then whether its inertia may be left out.
#define OIL_DYNAMIC(text) NUMBER_KEY("viscosity", "mu", "Pa s", OPTIONAL, WHIRL_POSITIVE, text)
#define OIL_KINEMATIC                                                                                                  \
    {                                                                                                                  \
        "kinematic_viscosity", "nu", "m2/s", WHIRL_KEY_NUMBER, false, "", WHIRL_POSITIVE, NULL,                        \
            "kinematic viscosity of the oil, in place of viscosity; with its density", ""                              \
    }
#define OIL_DENSITY NUMBER_KEY("density", "rho", "kg/m3", OPTIONAL, WHIRL_POSITIVE, "density of the oil")

typedef struct oil {
    const key_value *dynamic, *kinematic, *density;
} oil;

/// mu in Pa s. WHIRL_BAD_INPUT where it is not given in one way.
whirl_status oil_viscosity(const oil *of, double *viscosity);

/// rho speed length^2/mu; 0 where the density is not known.
double oil_reynolds(const oil *of, double speed, double length);

#endif
