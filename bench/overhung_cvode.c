// The peer SUNDIALS CVODE on the overhung rotor: BDF with dense Jacobians by differences.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <sunlinsol/sunlinsol_dense.h>

#include "overhung_equations.h"
#include "peer.h"

typedef struct machine {
    overhung_matrices of;
    overhung_scales scales;
    void *solver;
    N_Vector z;
    realtype t;
} machine;

static void must(int flag, const char *what) {
    if (flag >= 0) return;
    fprintf(stderr, "bench: SUNDIALS: %s gives %d\n", what, flag);
    exit(1);
}

static int slope(realtype t, N_Vector z, N_Vector dz, void *context) {
    const machine *m = context;
    overhung_slope(&m->of, &m->scales, t, N_VGetArrayPointer(z), N_VGetArrayPointer(dz));
    return 0;
}

static void revolve(void *context) {
    machine *m = context;
    const realtype end = m->t + 2.0 * M_PI;
    must(CVodeSetStopTime(m->solver, end), "CVodeSetStopTime");
    must(CVode(m->solver, end, m->z, &m->t, CV_NORMAL), "CVode");
}

static double left_y(void *context) {
    return N_VGetArrayPointer(((machine *)context)->z)[1];
}

int main(int argc, char **argv) {
    static machine m;
    SUNContext context;
    must(SUNContext_Create(NULL, &context), "SUNContext_Create");
    m.of = overhung_read(argc > 2 ? argv[2] : NULL);
    m.scales = overhung_scales_at(OVERHUNG_SPEED);
    m.z = N_VNew_Serial(OVERHUNG_DIMENSION, context);
    N_VConst(0.0, m.z);
    for (int i = 0; i < OVERHUNG_PORTS / 2; i++) N_VGetArrayPointer(m.z)[2 * i + 1] = overhung_start[i];
    SUNMatrix matrix = SUNDenseMatrix(OVERHUNG_DIMENSION, OVERHUNG_DIMENSION, context);
    SUNLinearSolver linear = SUNLinSol_Dense(m.z, matrix, context);
    m.solver = CVodeCreate(CV_BDF, context);
    must(m.solver && matrix && linear ? 0 : -1, "CVodeCreate");
    must(CVodeInit(m.solver, slope, 0.0, m.z), "CVodeInit");
    must(CVodeSStolerances(m.solver, OVERHUNG_RTOL, OVERHUNG_ATOL), "CVodeSStolerances");
    must(CVodeSetLinearSolver(m.solver, linear, matrix), "CVodeSetLinearSolver");
    must(CVodeSetUserData(m.solver, &m), "CVodeSetUserData");
    must(CVodeSetMaxNumSteps(m.solver, 1000000), "CVodeSetMaxNumSteps");
    peer_measure_steps(&(peer){PEER_NAME, 1, revolve, left_y, &m}, 1, peer_seconds(argc, argv));
    CVodeFree(&m.solver);
    SUNLinSolFree(linear);
    SUNMatDestroy(matrix);
    N_VDestroy(m.z);
    SUNContext_Free(&context);
    return 0;
}
