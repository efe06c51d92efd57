// Loss of amplitude of a sinusoid whose frequency sweeps through a Hann window.
#include <math.h>

#include "whirl/signals.h"

static const double pi = 3.141592653589793238463;

/// Positive nodes and weights of Gauss and Legendre's rule of 8 points (Abramowitz and Stegun 1972, table 25.4).
static const double nodes[4] = {0.183434642495649805, 0.525532409916328986, 0.796666477413626740, 0.960289856497536232};
static const double shares[4] = {0.362683783378361983, 0.313706645877887287, 0.222381034453374471,
                                 0.101228536290376259};

whirl_status whirl_signals_sweep(double sweep, double *kept) {
    const double most = 1e6;
    if (!(fabs(sweep) <= most))
        return whirl_fail(WHIRL_BAD_INPUT, "the sweep is %g, expected at most %g: take shorter windows", sweep, most);
    // Integrate over half the window, with its duration as unit: int (1 + cos 2 pi u) e^(i pi sweep u^2) du. A panel
    // covers at most a quarter of a turn of the phase, whose slope is at most pi sweep.
    const size_t panels = 4 + (size_t)ceil(fabs(sweep));
    const double half = 0.25 / (double)panels;
    double re = 0.0, im = 0.0;
    for (size_t panel = 0; panel < panels; panel++) {
        const double middle = half * (double)(2 * panel + 1);
        for (int node = -4; node < 4; node++) {
            const int i = node < 0 ? -1 - node : node;
            const double u = middle + (node < 0 ? -half : half) * nodes[i], phase = pi * sweep * u * u;
            const double weight = half * shares[i] * (1.0 + cos(2.0 * pi * u));
            re += weight * cos(phase);
            im += weight * sin(phase);
        }
    }
    *kept = 2.0 * hypot(re, im);
    return whirl_ok();
}
