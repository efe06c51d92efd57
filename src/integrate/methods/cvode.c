// SUNDIALS CVODE (Hindmarsh et al. 2005; CVODES: Serban, Hindmarsh 2005) with root finding: the independent reference.
//
// Every revolution is a new start at t = 0, and every zero of a switching function is a new start, so that no step goes
// over a contact. If the system can compute its laws on given sides of its switches, the sides are fixed between
// switches: CVODE, which steps past a switch before it locates it, never meets a law that changes within a step. What
// happens at a zero, sliding included, is decided as for dop853 (sides.c). For other systems the state decides.
//
// A perturbation is carried along by the variational equations, as CVODES carries sensitivities. Two separate
// trajectories would differ more by their steps and orders, which CVODE chooses for each, than by the perturbation.
#include <cvodes/cvodes.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "orthonormal.h"
#include "stepper.h"
#include "stepper_parts.h"

enum { MAX_STEPS_A_CALL = 100000, SHORTEST_TOUCH = 256 };

/// Tolerances of a perturbation: relative to its own length, and to its length 1 at the revolution's beginning.
static const double perturbation_rtol = 1e-7, perturbation_atol = 1e-9;

typedef struct cvode {
    const whirl_system *system;
    const whirl_integrate_options *options;
    stepper *sides; ///< holds the fixed sides, and the state at the last switch; NULL: no sides are fixed
    SUNContext context;
    void *memory;
    N_Vector state;
    SUNMatrix matrix;
    SUNLinearSolver linear;
    SUNNonlinearSolver nonlinear;
    N_Vector perturbation[1];            ///< [0] NULL until one was followed
    SUNNonlinearSolver for_perturbation; ///< for the method of Adams; NULL for BDF
    whirl_perturbations *set;            ///< perturbations of the present revolution, or NULL
    int *roots; ///< [switch_count] directions of roots that CVODE is to find, and the roots found
} cvode;

static int right_hand_side(realtype t, N_Vector x, N_Vector slope, void *data) {
    cvode *work = data;
    const whirl_system *system = work->system;
    double forcing[WHIRL_MAX_FORCING], *out = NV_DATA_S(slope);
    if (whirl_stop_is_set(system->stop)) return -1; // unrecoverable: CVODE ends
    if (work->sides) {
        stepper_slope(work->sides, t, NV_DATA_S(x), out);
    } else {
        if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
        system->rhs(system->model, t, forcing, NV_DATA_S(x), out);
    }
    for (size_t i = 0; i < system->dimension; i++)
        if (!isfinite(out[i])) return 1; // recoverable: CVODE tries a smaller step
    return 0;
}

static int switching(realtype t, N_Vector x, realtype *values, void *data) {
    const cvode *work = data;
    if (work->sides)
        stepper_guarded(work->sides, t, NV_DATA_S(x), values);
    else
        work->system->switches(work->system->model, t, NV_DATA_S(x), values);
    return 0;
}

static void silent(int code, const char *module, const char *function, char *message, void *data) {
    (void)code, (void)module, (void)function, (void)message, (void)data;
}

static void cvode_end(whirl_integrator *integrator) {
    cvode *work = integrator->workspace;
    if (!work) return;
    if (work->memory) CVodeFree(&work->memory);
    if (work->linear) SUNLinSolFree(work->linear);
    if (work->nonlinear) SUNNonlinSolFree(work->nonlinear);
    if (work->for_perturbation) SUNNonlinSolFree(work->for_perturbation);
    if (work->perturbation[0]) N_VDestroy(work->perturbation[0]);
    if (work->matrix) SUNMatDestroy(work->matrix);
    if (work->state) N_VDestroy(work->state);
    if (work->context) SUNContext_Free(&work->context);
    stepper_free(work->sides);
    free(work->roots);
    free(work);
}

/// Attaches the solvers: BDF solves its equations by Newton's method with a dense matrix, Adams by fixed-point
/// iteration.
static int attach_solvers(cvode *work, int kind) {
    const sunindextype n = NV_LENGTH_S(work->state);
    if (kind == CV_ADAMS) {
        work->nonlinear = SUNNonlinSol_FixedPoint(work->state, 0, work->context);
        return work->nonlinear ? CVodeSetNonlinearSolver(work->memory, work->nonlinear) : CV_MEM_FAIL;
    }
    work->matrix = SUNDenseMatrix(n, n, work->context);
    work->linear = work->matrix ? SUNLinSol_Dense(work->state, work->matrix, work->context) : NULL;
    return work->linear ? CVodeSetLinearSolver(work->memory, work->linear, work->matrix) : CV_MEM_FAIL;
}

static int look_for_switches(cvode *work) {
    const int count = (int)work->system->switch_count;
    work->roots = calloc(work->system->switch_count, sizeof *work->roots);
    int code = work->roots ? CVodeRootInit(work->memory, count, switching) : CV_MEM_FAIL;
    if (code == CV_SUCCESS) code = CVodeSetNoInactiveRootWarn(work->memory);
    // CVODE sees a zero by the signs at the ends of a step. Long steps would miss two zeros in one step, which is a
    // short touch.
    if (code == CV_SUCCESS) code = CVodeSetMaxStep(work->memory, work->system->period / SHORTEST_TOUCH);
    // Functions on fixed sides are positive until a switch is met.
    for (int i = 0; work->roots && i < count; i++) work->roots[i] = -1;
    if (code == CV_SUCCESS && work->sides) code = CVodeSetRootDirection(work->memory, work->roots);
    return code;
}

static int configure(cvode *work, const whirl_integrator *integrator, int kind) {
    int code = CVodeInit(work->memory, right_hand_side, 0.0, work->state);
    if (code == CV_SUCCESS) code = CVodeSetErrHandlerFn(work->memory, silent, NULL);
    if (code == CV_SUCCESS) code = CVodeSStolerances(work->memory, integrator->options.rtol, integrator->options.atol);
    if (code == CV_SUCCESS) code = CVodeSetUserData(work->memory, work);
    if (code == CV_SUCCESS) code = CVodeSetMaxNumSteps(work->memory, MAX_STEPS_A_CALL);
    if (code == CV_SUCCESS) code = attach_solvers(work, kind);
    if (code == CV_SUCCESS && work->system->switch_count > 0) code = look_for_switches(work);
    return code;
}

/// Makes the stepper that holds the sides, if sides are fixed. Returns false without memory.
static bool prepare_sides(cvode *work, const whirl_integrate_options *options) {
    const whirl_system *system = work->system;
    if (system->switch_count == 0 || !system->rhs_on_sides) return true;
    work->sides = stepper_new(NULL, system, options);
    return work->sides != NULL;
}

static whirl_status cvode_start(whirl_integrator *integrator, int kind) {
    cvode *work = calloc(1, sizeof *work);
    if (!work) return whirl_fail(WHIRL_NO_MEMORY, "no memory for CVODE");
    integrator->workspace = work;
    work->system = integrator->system;
    work->options = &integrator->options;
    int code = prepare_sides(work, &integrator->options) ? SUNContext_Create(NULL, &work->context) : CV_MEM_FAIL;
    if (code == 0) work->state = N_VNew_Serial((sunindextype)integrator->system->dimension, work->context);
    if (work->state) work->memory = CVodeCreate(kind, work->context);
    code = work->memory ? configure(work, integrator, kind) : CV_MEM_FAIL;
    if (code == CV_SUCCESS) return whirl_ok();
    cvode_end(integrator);
    integrator->workspace = NULL;
    return whirl_fail(WHIRL_NUMERICAL_FAILURE, "CVODE could not be set up (code %d)", code);
}

static whirl_status start_adams(whirl_integrator *integrator) {
    return cvode_start(integrator, CV_ADAMS);
}
static whirl_status start_bdf(whirl_integrator *integrator) {
    return cvode_start(integrator, CV_BDF);
}

/// Prepares the stepper `sides`, which carries the perturbation across switches.
static void set_variation(const whirl_integrator *integrator, stepper *sides) {
    const cvode *work = integrator->workspace;
    sides->variation.set = work->set;
    if (!work->set) return;
    sides->variation.upper = integrator->slopes;
    sides->variation.spare = integrator->slopes + integrator->system->dimension;
}

/// Finds the sides at the beginning of a revolution. If the motion slides along a switch, the state is moved onto it.
static void find_sides(const cvode *work) {
    stepper *c = work->sides;
    const size_t bytes = c->dimension * sizeof *c->x;
    stepper_place(c, work->system, 0.0);
    memcpy(c->x, NV_DATA_S(work->state), bytes);
    stepper_find_sides(c);
    stepper_vary_begin(c);
    memcpy(NV_DATA_S(work->state), c->x, bytes);
}

// ---------------------------------------------------------------- a perturbation

static int vary(int count, realtype t, N_Vector x, N_Vector slope, N_Vector *perturbation, N_Vector *change, void *data,
                N_Vector spare, N_Vector other) {
    const cvode *work = data;
    const whirl_system *system = work->system;
    double forcing[WHIRL_MAX_FORCING], *out = NV_DATA_S(change[0]);
    const double *vector = NV_DATA_S(perturbation[0]);
    (void)count, (void)slope, (void)spare, (void)other;
    if (work->sides) {
        stepper_apply_jacobian(work->sides, t, NV_DATA_S(x), 1, vector, out);
    } else {
        if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
        system->tangent(system->model, t, forcing, NV_DATA_S(x), NULL, 1, vector, out);
    }
    for (size_t i = 0; i < system->dimension; i++)
        if (!isfinite(out[i])) return 1;
    return 0;
}

/// Allocates memory for a perturbation at its first use.
static int prepare_perturbation(cvode *work) {
    double tolerance[] = {perturbation_atol};
    work->perturbation[0] = N_VClone(work->state);
    if (!work->perturbation[0]) return CV_MEM_FAIL;
    N_VConst(0.0, work->perturbation[0]);
    int code = CVodeSensInit(work->memory, 1, CV_STAGGERED, vary, work->perturbation);
    if (code == CV_SUCCESS) code = CVodeSensSStolerances(work->memory, perturbation_rtol, tolerance);
    if (code == CV_SUCCESS) code = CVodeSetSensErrCon(work->memory, SUNTRUE);
    if (code != CV_SUCCESS || !work->nonlinear) return code;
    work->for_perturbation = SUNNonlinSol_FixedPointSens(1, work->state, 0, work->context);
    return work->for_perturbation ? CVodeSetNonlinearSolverSensStg(work->memory, work->for_perturbation) : CV_MEM_FAIL;
}

/// Reads the present perturbation, at a switch or at the end. Returns false if CVODES fails to provide it.
static bool fetch_perturbation(const cvode *work) {
    realtype t;
    N_Vector at[] = {work->perturbation[0]};
    if (!work->set) return true;
    if (CVodeGetSens(work->memory, &t, at) != CV_SUCCESS) return false;
    memcpy(work->set->vectors, NV_DATA_S(at[0]), work->system->dimension * sizeof *work->set->vectors);
    return true;
}

/// Restarts CVODE at t, with the perturbation or without it.
static int restart(cvode *work, double t) {
    int code = CVodeReInit(work->memory, t, work->state);
    if (code != CV_SUCCESS) return code;
    if (!work->set) return work->perturbation[0] ? CVodeSensToggleOff(work->memory) : CV_SUCCESS;
    const size_t bytes = work->system->dimension * sizeof(double);
    if (!work->perturbation[0]) code = prepare_perturbation(work);
    if (code != CV_SUCCESS) return code;
    memcpy(NV_DATA_S(work->perturbation[0]), work->set->vectors, bytes);
    return CVodeSensReInit(work->memory, CV_STAGGERED, work->perturbation);
}

// ---------------------------------------------------------------- switches

/// Crosses the switches that CVODE has found at t, or slides along them.
static void cross(const cvode *work, double t) {
    int *found = work->roots;
    stepper *c = work->sides;
    const size_t bytes = c->dimension * sizeof *c->x;
    if (CVodeGetRootInfo(work->memory, found) != CV_SUCCESS) return;
    stepper_place(c, work->system, t);
    memcpy(c->x, NV_DATA_S(work->state), bytes);
    if (c->sliding_count > 0) stepper_project(c, c->x);
    for (size_t i = 0; i < work->system->switch_count; i++)
        if (found[i]) stepper_cross_varied(c, i);
    memcpy(NV_DATA_S(work->state), c->x, bytes);
}

/// Integrates from *t to `target`, with a new start wherever a switching function passes zero.
static whirl_motion advance(const whirl_integrator *integrator, double *t, double target, int *switches) {
    cvode *work = integrator->workspace;
    for (;;) {
        const int code = CVode(work->memory, target, work->state, t, CV_NORMAL);
        if (code == CV_ROOT_RETURN) {
            if (++*switches > MAX_SWITCHINGS) return WHIRL_STUCK;
            if (!fetch_perturbation(work)) return WHIRL_STUCK;
            if (work->sides) cross(work, *t);
            if (restart(work, *t) != CV_SUCCESS) return WHIRL_STUCK;
            CVodeSetStopTime(work->memory, integrator->system->period);
            // Closer than CVODE can step: this counts as reached.
            if (target - *t <= 1e-14 * integrator->system->period) return WHIRL_BOUNDED;
            continue;
        }
        if (code == CV_SUCCESS || code == CV_TSTOP_RETURN) return WHIRL_BOUNDED;
        return state_motion(integrator, NV_DATA_S(work->state)) == WHIRL_DIVERGED ? WHIRL_DIVERGED : WHIRL_STUCK;
    }
}

static whirl_motion revolve(whirl_integrator *integrator, double *x, whirl_perturbations *perturbations,
                            whirl_observe_fn observe, void *observer) {
    cvode *work = integrator->workspace;
    const double period = integrator->system->period;
    const int samples = observe ? integrator->options.steps_per_revolution : 1;
    const size_t bytes = integrator->system->dimension * sizeof *x;
    // Begin at x, on the sides of the switches there.
    memcpy(NV_DATA_S(work->state), x, bytes);
    work->set = perturbations;
    if (work->sides) set_variation(integrator, work->sides);
    if (work->sides) find_sides(work);
    if (restart(work, 0.0) != CV_SUCCESS) return WHIRL_STUCK;
    CVodeSetStopTime(work->memory, period);
    // Advance from sample to sample.
    double t = 0.0;
    int switches = 0;
    whirl_motion motion = WHIRL_BOUNDED;
    for (int i = 1; i <= samples && motion == WHIRL_BOUNDED; i++) {
        const double target = period * ((double)i / samples);
        motion = advance(integrator, &t, target, &switches);
        if (motion == WHIRL_BOUNDED) motion = state_motion(integrator, NV_DATA_S(work->state));
        if (motion == WHIRL_BOUNDED && observe) observe(observer, target, NV_DATA_S(work->state));
    }
    // Store the state, and the perturbation scaled to length 1.
    memcpy(x, NV_DATA_S(work->state), bytes);
    if (perturbations && motion == WHIRL_BOUNDED) {
        if (!fetch_perturbation(work)) return WHIRL_STUCK;
        perturbations->volume = (double)NAN; // CVODES does not integrate the divergence
        if (perturbations->growth)
            make_orthonormal(integrator->system->dimension, 1, perturbations->vectors, perturbations->growth);
    }
    return motion;
}

const method cvode_adams_method = {
    .about = {"cvode-adams", "SUNDIALS CVODE, Adams-Moulton of order 1 to 12, contacts located", true, false, true},
    .start = start_adams,
    .revolve = revolve,
    .rows = 1,
    .end = cvode_end,
};

const method cvode_bdf_method = {
    .about = {"cvode-bdf", "SUNDIALS CVODE, backward differentiation of order 1 to 5 for stiff films, contacts located",
              true, false, true},
    .start = start_bdf,
    .revolve = revolve,
    .rows = 1,
    .end = cvode_end,
};
