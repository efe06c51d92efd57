#include "oil.h"

whirl_status oil_viscosity(const oil *of, double *viscosity) {
    if (of->dynamic->given && of->kinematic->given)
        return whirl_fail(WHIRL_BAD_INPUT, "has both viscosity and kinematic_viscosity, expected one of them");
    if (of->kinematic->given && !of->density->given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has a kinematic_viscosity without a density, expected that of the oil, too");
    if (!of->kinematic->given && !of->dynamic->given)
        return whirl_fail(WHIRL_BAD_INPUT, "has no viscosity, expected one, or kinematic_viscosity and density");
    *viscosity = of->kinematic->given ? of->kinematic->number * of->density->number : of->dynamic->number;
    return whirl_ok();
}

double oil_reynolds(const oil *of, double speed, double length) {
    double viscosity;
    if (!of->density->given || oil_viscosity(of, &viscosity).code != WHIRL_OK) return 0.0;
    return of->density->number * speed * length * length / viscosity;
}
