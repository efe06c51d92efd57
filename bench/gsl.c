// The peer GSL odeiv2, rk4 with a fixed step. Its rk4 takes every step twice, whole and as two halves, and goes on with
// the halves; 512 of its steps are therefore 1024 of RK4, and counted as such.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdlib.h>

#include "equations.h"
#include "peer.h"

typedef struct machine {
    gsl_odeiv2_driver *driver;
    double z[ROTOR_DIMENSION];
} machine;

static int slope(double t, const double z[], double dz[], void *context) {
    (void)context;
    equations(ROTOR_R_K, cos(t), sin(t), z, dz);
    return GSL_SUCCESS;
}

static void revolve(void *context) {
    machine *m = context;
    double t = 0.0;
    const int status =
        gsl_odeiv2_driver_apply_fixed_step(m->driver, &t, 4.0 * ROTOR_PI / ROTOR_STEPS, ROTOR_STEPS / 2, m->z);
    if (status != GSL_SUCCESS) abort();
}

static double x1(void *context) {
    return ((machine *)context)->z[0];
}

int main(int argc, char **argv) {
    gsl_odeiv2_system system = {slope, NULL, ROTOR_DIMENSION, NULL};
    // The tolerances are not used: the step is fixed.
    machine m = {gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk4, 1e-3, 1e3, 1e3), ROTOR_START};
    if (!m.driver) return 1;
    peer_measure(&(peer){"GSL odeiv2 rk4", 1, revolve, x1, &m}, peer_seconds(argc, argv));
    gsl_odeiv2_driver_free(m.driver);
    return 0;
}
