// The peers SUNDIALS CVODE (Adams; every touch of the stator is found as a root, and the integration restarts there)
// and ARKODE (ERKStep with the pair of Dormand and Prince of orders 5 and 4).
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "adaptive.h"
#include "equations.h"
#include "peer.h"

typedef struct machine {
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
    (void)context;
    equations(ROTOR_R_K, cos(t), sin(t), N_VGetArrayPointer(z), N_VGetArrayPointer(dz));
    return 0;
}

static int gap(realtype t, N_Vector z, realtype *value, void *context) {
    const double *x = N_VGetArrayPointer(z);
    (void)t, (void)context;
    *value = sqrt(x[0] * x[0] + x[1] * x[1]) - rotor_r_delta;
    return 0;
}

static N_Vector start_state(SUNContext context) {
    const double start[ROTOR_DIMENSION] = ROTOR_START;
    N_Vector z = N_VNew_Serial(ROTOR_DIMENSION, context);
    for (int i = 0; i < ROTOR_DIMENSION; i++) N_VGetArrayPointer(z)[i] = start[i];
    return z;
}

static void state(void *context, double z[ROTOR_DIMENSION]) {
    const double *own = N_VGetArrayPointer(((machine *)context)->z);
    for (int i = 0; i < ROTOR_DIMENSION; i++) z[i] = own[i];
}

static void revolve_arkode(void *context) {
    machine *m = context;
    const realtype end = m->t + 2.0 * ROTOR_PI;
    must(ERKStepSetStopTime(m->solver, end), "ERKStepSetStopTime");
    must(ERKStepEvolve(m->solver, end, m->z, &m->t, ARK_NORMAL), "ERKStepEvolve");
    m->t = end;
}

static void measure_arkode(SUNContext context, double seconds) {
    machine m = {.z = start_state(context)};
    m.solver = ERKStepCreate(slope, 0.0, m.z, context);
    must(m.solver ? 0 : -1, "ERKStepCreate");
    must(ERKStepSetTableNum(m.solver, ARKODE_DORMAND_PRINCE_7_4_5), "ERKStepSetTableNum");
    must(ERKStepSStolerances(m.solver, ADAPTIVE_RTOL, ADAPTIVE_ATOL), "ERKStepSStolerances");
    must(ERKStepSetMaxNumSteps(m.solver, 100000), "ERKStepSetMaxNumSteps");
    adaptive_measure(&(adaptive_peer){"SUNDIALS ARKODE, Dormand-Prince 5(4)", 1, revolve_arkode, state, &m}, seconds);
    ERKStepFree(&m.solver);
    N_VDestroy(m.z);
}

static void revolve_cvode(void *context) {
    machine *m = context;
    const realtype end = m->t + 2.0 * ROTOR_PI;
    int code;
    must(CVodeSetStopTime(m->solver, end), "CVodeSetStopTime");
    while ((code = CVode(m->solver, end, m->z, &m->t, CV_NORMAL)) == CV_ROOT_RETURN) {
        must(CVodeReInit(m->solver, m->t, m->z), "CVodeReInit");
        must(CVodeSetStopTime(m->solver, end), "CVodeSetStopTime");
    }
    must(code, "CVode");
    m->t = end;
}

static void measure_cvode(SUNContext context, double seconds) {
    machine m = {.z = start_state(context)};
    SUNNonlinearSolver solver = SUNNonlinSol_FixedPoint(m.z, 0, context);
    m.solver = CVodeCreate(CV_ADAMS, context);
    must(m.solver && solver ? 0 : -1, "CVodeCreate");
    must(CVodeInit(m.solver, slope, 0.0, m.z), "CVodeInit");
    must(CVodeSStolerances(m.solver, ADAPTIVE_RTOL, ADAPTIVE_ATOL), "CVodeSStolerances");
    must(CVodeSetNonlinearSolver(m.solver, solver), "CVodeSetNonlinearSolver");
    must(CVodeSetMaxNumSteps(m.solver, 100000), "CVodeSetMaxNumSteps");
    must(CVodeRootInit(m.solver, 1, gap), "CVodeRootInit");
    must(CVodeSetNoInactiveRootWarn(m.solver), "CVodeSetNoInactiveRootWarn");
    adaptive_measure(&(adaptive_peer){"SUNDIALS CVODE Adams with roots", 1, revolve_cvode, state, &m}, seconds);
    CVodeFree(&m.solver);
    SUNNonlinSolFree(solver);
    N_VDestroy(m.z);
}

int main(int argc, char **argv) {
    const double seconds = peer_seconds(argc, argv);
    SUNContext context;
    must(SUNContext_Create(NULL, &context), "SUNContext_Create");
    measure_arkode(context, seconds);
    measure_cvode(context, seconds);
    SUNContext_Free(&context);
    return 0;
}
