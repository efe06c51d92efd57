#include <math.h>

#include "torus_options.h"

whirl_torus_options whirl_torus_default(void) {
    return (whirl_torus_options){.integrate = whirl_orbit_default().integrate,
                                 .tolerance = 1e-11,
                                 .accuracy = 1e-7,
                                 .most_steps = 15,
                                 .most_nodes = 127};
}

whirl_status torus_check_options(const whirl_torus_options *o) {
    if (!(o->tolerance > 0.0 && o->accuracy > o->tolerance && isfinite(o->accuracy)))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "a torus to %g at its nodes and %g between them, expected numbers above 0, the second one "
                          "larger",
                          o->tolerance, o->accuracy);
    if (o->most_nodes < WHIRL_MIN_TORUS_NODES || o->most_nodes > WHIRL_MAX_TORUS_NODES || o->most_nodes % 2 == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "a torus of at most %zu nodes, expected an odd number from %d to %d",
                          o->most_nodes, WHIRL_MIN_TORUS_NODES, WHIRL_MAX_TORUS_NODES);
    if (o->most_steps < 1)
        return whirl_fail(WHIRL_BAD_INPUT, "a torus in %d steps of Newton's method, expected 1 or more", o->most_steps);
    return whirl_ok();
}
