// The peer SUNDIALS ARKODE: ERKStep with a fixed step and Zonneveld's table, which is the classical RK4 with a fifth
// stage for an error estimate. A table of RK4 alone gives wrong results here: ERKStep of SUNDIALS 6.4 takes the slope
// of a last stage at c = 1 for that of the next step's beginning, and ends 2e-6 off.
#include <arkode/arkode_erkstep.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>

#include "equations.h"
#include "peer.h"

typedef struct machine {
    void *solver;
    N_Vector z;
} machine;

static void must(int flag, const char *what) {
    if (flag >= 0) return;
    fprintf(stderr, "bench: ARKODE: %s gives %d\n", what, flag);
    exit(1);
}

static int slope(realtype t, N_Vector z, N_Vector dz, void *context) {
    (void)context;
    equations(ROTOR_R_K, cos(t), sin(t), N_VGetArrayPointer(z), N_VGetArrayPointer(dz));
    return 0;
}

static void revolve(void *context) {
    machine *m = context;
    const double end = 2.0 * ROTOR_PI;
    realtype t = 0.0;
    must(ERKStepReset(m->solver, 0.0, m->z), "ERKStepReset");
    must(ERKStepSetStopTime(m->solver, end), "ERKStepSetStopTime");
    must(ERKStepEvolve(m->solver, end, m->z, &t, ARK_NORMAL), "ERKStepEvolve");
}

static double x1(void *context) {
    return N_VGetArrayPointer(((machine *)context)->z)[0];
}

int main(int argc, char **argv) {
    const double start[ROTOR_DIMENSION] = ROTOR_START;
    SUNContext context;
    machine m;
    must(SUNContext_Create(NULL, &context), "SUNContext_Create");
    m.z = N_VNew_Serial(ROTOR_DIMENSION, context);
    for (int i = 0; i < ROTOR_DIMENSION; i++) N_VGetArrayPointer(m.z)[i] = start[i];
    m.solver = ERKStepCreate(slope, 0.0, m.z, context);
    if (!m.solver) return 1;
    must(ERKStepSetTableNum(m.solver, ARKODE_ZONNEVELD_5_3_4), "ERKStepSetTableNum");
    must(ERKStepSetFixedStep(m.solver, 2.0 * ROTOR_PI / ROTOR_STEPS), "ERKStepSetFixedStep");
    must(ERKStepSetInterpolantDegree(m.solver, 1), "ERKStepSetInterpolantDegree");
    must(ERKStepSetMaxNumSteps(m.solver, 2 * ROTOR_STEPS), "ERKStepSetMaxNumSteps");
    peer_measure(&(peer){"SUNDIALS ARKODE", 1, revolve, x1, &m}, peer_seconds(argc, argv));
    ERKStepFree(&m.solver);
    N_VDestroy(m.z);
    SUNContext_Free(&context);
    return 0;
}
