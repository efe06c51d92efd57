// The peer "straightforward C" of the overhung rotor: one machine, its matrices as they are, RK4 on an array of 44.
// Compiled twice, with different flags; PEER_NAME says with which.
#include "overhung_equations.h"
#include "peer.h"

enum { N = OVERHUNG_DEGREES };

typedef struct machine {
    overhung_matrices of;
    overhung_scales scales;
    double z[2 * N];
} machine;

static void revolve(void *context) {
    machine *m = context;
    const double h = 2.0 * M_PI / OVERHUNG_STEPS;
    double *z = m->z, k1[2 * N], k2[2 * N], k3[2 * N], k4[2 * N], y[2 * N];
    for (int n = 0; n < OVERHUNG_STEPS; n++) {
        const double t = n * h;
        overhung_slope(&m->of, &m->scales, t, z, k1);
        for (int i = 0; i < 2 * N; i++) y[i] = z[i] + 0.5 * h * k1[i];
        overhung_slope(&m->of, &m->scales, t + 0.5 * h, y, k2);
        for (int i = 0; i < 2 * N; i++) y[i] = z[i] + 0.5 * h * k2[i];
        overhung_slope(&m->of, &m->scales, t + 0.5 * h, y, k3);
        for (int i = 0; i < 2 * N; i++) y[i] = z[i] + h * k3[i];
        overhung_slope(&m->of, &m->scales, t + h, y, k4);
        for (int i = 0; i < 2 * N; i++) z[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    }
}

static double left_y(void *context) {
    return ((machine *)context)->z[1];
}

int main(int argc, char **argv) {
    static machine m;
    m.of = overhung_read(argc > 2 ? argv[2] : NULL);
    m.scales = overhung_scales_at(OVERHUNG_SPEED);
    for (int i = 0; i < OVERHUNG_PORTS / 2; i++) m.z[2 * i + 1] = overhung_start[i];
    peer_measure_steps(&(peer){PEER_NAME, 1, revolve, left_y, &m}, OVERHUNG_STEPS, peer_seconds(argc, argv));
    return 0;
}
