// The peer "compiler-vectorised loop" of the overhung rotor: PEER_MACHINES machines side by side, whose matrices differ
// only in the scale of K; no branch; cosines tabulated, since all machines share tau; RK4 in Nystrom's form; four rows
// of a matrix at a time. With PEER_STEP 1 the whole matrices are used. With 2 their zeros are skipped: coordinates
// along x and along y alternate, K couples only coordinates of one direction, and G only those of different ones.
#include <math.h>

#include "overhung_equations.h"
#include "peer.h"

enum { N = OVERHUNG_DEGREES, M = PEER_MACHINES, ROWS = 4, BLOCK = ROWS * PEER_STEP, ROOM = (N + 7) / 8 * 8 };

typedef double lanes[M];

typedef double matrix[ROOM][N]; ///< with rows of zeros at the end

typedef struct machines {
    matrix K, G;
    double P[ROOM][OVERHUNG_PORTS], g[ROOM], u[ROOM], w[ROOM];
    lanes stiffness, film[2], push, damping;
    lanes q[N], v[N];                                ///< state
    lanes qs[N], vs[N], a[ROOM], first[N], other[N]; ///< state at a stage; its accelerations, their sums
    double table[2 * OVERHUNG_STEPS + 1][2];         ///< cosine and sine at every half step
} machines;

/// Multiplies four rows of a matrix, PEER_STEP apart, by z.
static inline void multiply(const matrix m, int first, int column, const lanes *restrict z, lanes *restrict sum) {
    for (int r = 0; r < ROWS; r++)
        for (int l = 0; l < M; l++) sum[r][l] = 0.0;
    for (int j = column; j < N; j += PEER_STEP)
        for (int r = 0; r < ROWS; r++)
            for (int l = 0; l < M; l++) sum[r][l] += m[first + r * PEER_STEP][j] * z[j][l];
}

static void forces(const machines *m, const lanes *restrict q, const lanes *restrict v, lanes *restrict F) {
#pragma omp simd
    for (int l = 0; l < M; l++) overhung_film(m->film[0][l], q[0][l], q[1][l], v[0][l], v[1][l], &F[0][l], &F[1][l]);
#pragma omp simd
    for (int l = 0; l < M; l++) overhung_film(m->film[1][l], q[2][l], q[3][l], v[2][l], v[3][l], &F[2][l], &F[3][l]);
#pragma omp simd
    for (int l = 0; l < M; l++)
        overhung_rub(m->push[l], m->damping[l], q[4][l], q[5][l], v[4][l], v[5][l], &F[4][l], &F[5][l]);
}

static void accelerations(const machines *restrict m, const double *wave, const lanes *restrict q,
                          const lanes *restrict v, lanes *restrict a) {
    lanes F[OVERHUNG_PORTS], place[ROWS], rate[ROWS];
    forces(m, q, v, F);
    for (int block = 0; block < ROOM; block += BLOCK)
        for (int plane = 0; plane < PEER_STEP; plane++) {
            multiply(m->K, block + plane, plane, q, place);
            multiply(m->G, block + plane, PEER_STEP - 1 - plane, v, rate);
            for (int r = 0; r < ROWS; r++) {
                const int row = block + plane + r * PEER_STEP;
                const double shaking = m->u[row] * wave[0] + m->w[row] * wave[1];
#pragma omp simd
                for (int l = 0; l < M; l++) {
                    double sum = shaking - rate[r][l] - m->stiffness[l] * (place[r][l] + m->g[row]);
                    for (int p = 0; p < OVERHUNG_PORTS; p++) sum += m->P[row][p] * F[p][l];
                    a[row][l] = sum;
                }
            }
        }
}

/// Carries all machines over one step. `first` gathers a1 + a2 + a3, `other` a1 + 2 a2 + 2 a3.
static void step(machines *m, const double *start, const double *middle, const double *end) {
    const double h = 2.0 * M_PI / OVERHUNG_STEPS, g = 0.5 * h;
    double *restrict q = m->q[0], *restrict v = m->v[0], *restrict qs = m->qs[0], *restrict vs = m->vs[0];
    double *restrict a = m->a[0], *restrict first = m->first[0], *restrict other = m->other[0];
    accelerations(m, start, m->q, m->v, m->a);
    for (int i = 0; i < N * M; i++) {
        first[i] = other[i] = a[i];
        qs[i] = q[i] + g * v[i];
        vs[i] = v[i] + g * a[i];
    }
    accelerations(m, middle, m->qs, m->vs, m->a);
    for (int i = 0; i < N * M; i++) {
        qs[i] = q[i] + g * v[i] + g * g * first[i];
        vs[i] = v[i] + g * a[i];
        first[i] += a[i];
        other[i] += 2.0 * a[i];
    }
    accelerations(m, middle, m->qs, m->vs, m->a);
    for (int i = 0; i < N * M; i++) {
        qs[i] = q[i] + h * v[i] + h * g * (other[i] - first[i]);
        vs[i] = v[i] + h * a[i];
        first[i] += a[i];
        other[i] += 2.0 * a[i];
    }
    accelerations(m, end, m->qs, m->vs, m->a);
    for (int i = 0; i < N * M; i++) {
        q[i] += h * v[i] + h * h / 6.0 * first[i];
        v[i] += h / 6.0 * (other[i] + a[i]);
    }
}

static void revolve(void *context) {
    machines *m = context;
    const double(*wave)[2] = m->table;
    for (int n = 0; n < OVERHUNG_STEPS; n++, wave += 2) step(m, wave[0], wave[1], wave[2]);
}

static double left_y(void *context) {
    return ((machines *)context)->q[1][0];
}

int main(int argc, char **argv) {
    static machines m;
    const overhung_matrices of = overhung_read(argc > 2 ? argv[2] : NULL);
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) m.K[i][j] = of.K[i][j], m.G[i][j] = of.G[i][j];
        for (int p = 0; p < OVERHUNG_PORTS; p++) m.P[i][p] = of.P[p][i];
        m.g[i] = of.g[i], m.u[i] = of.u[i], m.w[i] = of.w[i];
    }
    for (int l = 0; l < M; l++) {
        const overhung_scales scales = overhung_scales_at(overhung_speed(l, M));
        m.stiffness[l] = scales.stiffness, m.push[l] = scales.push, m.damping[l] = scales.damping;
        for (int i = 0; i < 2; i++) m.film[i][l] = scales.film[i];
        for (int i = 0; i < OVERHUNG_PORTS / 2; i++) m.q[2 * i + 1][l] = overhung_start[i];
    }
    for (int n = 0; n <= 2 * OVERHUNG_STEPS; n++) {
        m.table[n][0] = cos(M_PI * n / OVERHUNG_STEPS);
        m.table[n][1] = sin(M_PI * n / OVERHUNG_STEPS);
    }
    peer_measure_steps(&(peer){PEER_NAME, PEER_MACHINES, revolve, left_y, &m}, OVERHUNG_STEPS,
                       peer_seconds(argc, argv));
    return 0;
}
