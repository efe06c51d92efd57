// The peer "straightforward C" of pads.h: one machine by these equations, its table read from a file, RK4 on arrays.
// Compiled twice, with different flags; PEER_NAME says with which.
//
//   bench_pads_c SECONDS FILE        the file of bench_pads_table
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "pads.h"
#include "peer.h"
#include "rotor.h"

// Nodes of the table along t, w and alpha; the first node and the distance of nodes along t and w.
enum { T_NODES = 28, W_NODES = 27, ALPHA_NODES = 48, OWN = 4 + 2 * PADS_COUNT, N = PADS_JOURNALS * OWN };
static const double first_t = 0.14, step_t = 1.46 / (T_NODES - 1), first_w = -0.92, step_w = 1.84 / (W_NODES - 1);
static double table[T_NODES + 2][W_NODES + 2][ALPHA_NODES + 3][2];

typedef struct machine {
    double z[N]; ///< of every journal x, y, x', y', then s and s' of every pad
} machine;

static double cosines[PADS_COUNT], sines[PADS_COUNT], half_cosine, half_sine, journal_force, tilt_force, weight;

static void prepare(void) {
    const double share = PADS_RADIUS / PADS_CLEARANCE, clock = PADS_SPEED * PADS_SPEED * PADS_CLEARANCE;
    const double strength = PADS_VISCOSITY * PADS_SPEED * PADS_RADIUS * PADS_LENGTH * share * share;
    for (int i = 0; i < PADS_COUNT; i++) {
        cosines[i] = cos(PADS_FIRST_PIVOT + PADS_BETWEEN * i);
        sines[i] = sin(PADS_FIRST_PIVOT + PADS_BETWEEN * i);
    }
    half_cosine = cos(0.5 * PADS_ARC);
    half_sine = sin(0.5 * PADS_ARC);
    journal_force = strength / (PADS_MASS * clock);
    tilt_force = PADS_RADIUS * PADS_RADIUS * strength / (PADS_INERTIA * clock);
    weight = PADS_GRAVITY / clock;
}

/// Finds the cell of a place on an axis, and the four splines there.
static int splines(double at, double first, double step, int cells, double value[4]) {
    double place = (at - first) / step;
    if (place < 0.0) place = 0.0;
    if (place > cells) place = cells;
    const int cell = place < cells ? (int)place : cells - 1;
    const double u = place - cell, m = 1.0 - u;
    value[0] = m * m * m / 6.0;
    value[1] = 2.0 / 3.0 + u * u * (0.5 * u - 1.0);
    value[2] = 2.0 / 3.0 + m * m * (0.5 * m - 1.0);
    value[3] = u * u * u / 6.0;
    return cell;
}

/// Computes the force of one pad, in its frame.
static void film(double x, double y, double a, double b, double f[2]) {
    const double h = 1.0 - x, most = x < half_cosine ? (1.0 - half_cosine * x) / half_sine : sqrt(1.0 - x * x);
    const double v = y / most, rest = 1.0 - v * v, w = v / (1.0 + sqrt(rest)), V = sqrt(a * a + b * b);
    double by_t[4], by_w[4], by_alpha[4], sum[2] = {0.0, 0.0};
    const int i = splines(sqrt(h), first_t, step_t, T_NODES - 1, by_t);
    const int j = splines(w, first_w, step_w, W_NODES - 1, by_w);
    const int k = splines(atan2(b, a), -ROTOR_PI, 2.0 * ROTOR_PI / ALPHA_NODES, ALPHA_NODES, by_alpha);
    for (int p = 0; p < 4; p++)
        for (int q = 0; q < 4; q++)
            for (int r = 0; r < 4; r++)
                for (int n = 0; n < 2; n++) sum[n] += by_t[p] * by_w[q] * by_alpha[r] * table[i + p][j + q][k + r][n];
    for (int n = 0; n < 2; n++) f[n] = V / (rest * h * h) * sum[n];
}

static void slope(const double *z, double *out) {
    for (int j = 0; j < PADS_JOURNALS; j++, z += OWN, out += OWN) {
        out[0] = z[2];
        out[1] = z[3];
        out[2] = 0.0;
        out[3] = -weight;
        for (int i = 0; i < PADS_COUNT; i++) {
            const double c = cosines[i], s = sines[i], tilt = z[4 + 2 * i], rate = z[5 + 2 * i];
            const double x = c * z[0] + s * z[1] + PADS_PRELOAD, y = c * z[1] - s * z[0] - tilt;
            const double vx = c * z[2] + s * z[3], vy = c * z[3] - s * z[2] - rate;
            double f[2];
            film(x, y, x - 2.0 * vy, y + 2.0 * vx, f);
            out[2] += journal_force * (c * f[0] - s * f[1]);
            out[3] += journal_force * (s * f[0] + c * f[1]);
            out[4 + 2 * i] = rate;
            out[5 + 2 * i] = -tilt_force * f[1];
        }
    }
}

static void revolve(void *context) {
    double *z = ((machine *)context)->z, k1[N], k2[N], k3[N], k4[N], y[N];
    const double h = 2.0 * ROTOR_PI / ROTOR_STEPS;
    for (int n = 0; n < ROTOR_STEPS; n++) {
        slope(z, k1);
        for (int i = 0; i < N; i++) y[i] = z[i] + 0.5 * h * k1[i];
        slope(y, k2);
        for (int i = 0; i < N; i++) y[i] = z[i] + 0.5 * h * k2[i];
        slope(y, k3);
        for (int i = 0; i < N; i++) y[i] = z[i] + h * k3[i];
        slope(y, k4);
        for (int i = 0; i < N; i++) z[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    }
}

static double x1(void *context) {
    return ((machine *)context)->z[0];
}

int main(int argc, char **argv) {
    static machine m;
    FILE *from = argc > 2 ? fopen(argv[2], "rb") : NULL;
    if (!from || fread(table, sizeof table, 1, from) != 1) {
        fprintf(stderr, "bench: %s does not hold the table of a pad\n", argc > 2 ? argv[2] : "no file");
        return 1;
    }
    fclose(from);
    prepare();
    for (int j = 0; j < PADS_JOURNALS; j++) m.z[j * OWN + 1] = -0.1;
    peer_measure(&(peer){"pads: " PEER_NAME, 1, revolve, x1, &m}, peer_seconds(argc, argv));
    return 0;
}
