#include "orbit_options.h"

#include <math.h>
#include <string.h>

whirl_orbit_options orbit_options_by(const char *method, double rtol) {
    whirl_orbit_options options = whirl_orbit_default();
    whirl_integrate_options *integrate = &options.integrate;
    if (strcmp(method, "rodas5p") == 0) strcpy(integrate->method, "rodas5p");
    integrate->atol *= rtol / integrate->rtol;
    integrate->rtol = rtol;
    options.tolerance = fmax(options.tolerance, 10.0 * rtol);
    return options;
}
