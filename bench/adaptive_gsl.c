// The peer GSL odeiv2, rk8pd: Prince and Dormand's pair of orders 8 and 9, with the driver's step control.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "adaptive.h"
#include "equations.h"
#include "peer.h"

typedef struct machine {
    gsl_odeiv2_driver *driver;
    double t, z[ROTOR_DIMENSION];
} machine;

static int slope(double t, const double z[], double dz[], void *context) {
    (void)context;
    equations(ROTOR_R_K, cos(t), sin(t), z, dz);
    return GSL_SUCCESS;
}

static void revolve(void *context) {
    machine *m = context;
    if (gsl_odeiv2_driver_apply(m->driver, &m->t, m->t + 2.0 * ROTOR_PI, m->z) != GSL_SUCCESS) abort();
}

static void state(void *context, double z[ROTOR_DIMENSION]) {
    memcpy(z, ((machine *)context)->z, ROTOR_DIMENSION * sizeof *z);
}

int main(int argc, char **argv) {
    gsl_odeiv2_system system = {slope, NULL, ROTOR_DIMENSION, NULL};
    machine m = {.z = ROTOR_START};
    m.driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, ADAPTIVE_ATOL, ADAPTIVE_RTOL);
    if (!m.driver) return 1;
    adaptive_measure(&(adaptive_peer){"GSL odeiv2 rk8pd", 1, revolve, state, &m}, peer_seconds(argc, argv));
    gsl_odeiv2_driver_free(m.driver);
    return 0;
}
