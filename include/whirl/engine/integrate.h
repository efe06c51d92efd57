/// Integrators: carry a state over whole revolutions. They depend on systems, not on rotors.
#ifndef WHIRL_INTEGRATE_H
#define WHIRL_INTEGRATE_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/descriptor.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Limits of options.
enum {
    WHIRL_MAX_STEPS = 1 << 24 ///< steps of a revolution, and samples of one, in cases and result files
};

/// Method and accuracy of computed motions.
typedef struct whirl_integrate_options {
    /// A name of whirl_method_at(). With "auto", studies choose one for each batch (whirl_study_choose_methods);
    /// integrators, ensembles and recorders use dop853.
    char method[WHIRL_NAME_SIZE];
    bool chosen; ///< the method was chosen by "auto": recorded in results, without effect on motions
    /// Equally spaced instants of a revolution at which an observer is called; for a fixed-step method also its steps.
    int steps_per_revolution;
    double rtol; ///< relative tolerance of adaptive methods
    double atol; ///< absolute tolerance of adaptive methods, in the state's units
    /// rk4: split steps at the zeros of the switching functions, located inside the step; other methods always do so.
    bool located;
    double limit; ///< bound of a coordinate, in the state's units; a motion beyond it has diverged
} whirl_integrate_options;

/// Returns the members of the options for cases (part "integrate") and results; static, ended by a member without a
/// part.
const whirl_member *whirl_integrate_members(void);

/// Returns the defaults of whirl_integrate_members, except for the method rk4 with the 1024 steps of the 2015 paper.
whirl_integrate_options whirl_integrate_default(void);

/// Returns WHIRL_BAD_INPUT with a sentence for a system that has no motions in time (whirl_system.frequencies).
whirl_status whirl_integrate_check(const whirl_system *system);

/// Description of a method.
typedef struct whirl_method {
    const char *name;    ///< as written in a case file
    const char *meaning; ///< one line
    bool adaptive;       ///< true if it uses rtol and atol, and finds the zeros of the switching functions
    bool follows;        ///< true if it carries perturbations (whirl_integrator_follow), up to the dimension
    /// True if it carries a single perturbation by the variational equations. A second trajectory cannot replace them:
    /// the method's steps and orders change so abruptly that two trajectories differ more by these than by the
    /// perturbation.
    bool follows_one;
} whirl_method;

/// Returns a method of this build by index from 0; NULL past the last. Static.
const whirl_method *whirl_method_at(size_t index);

/// Finds the method of that name. WHIRL_BAD_INPUT with the nearest name if there is none.
whirl_status whirl_method_find(const char *name, const whirl_method **method);

/// Returns true if there is a method of that name and it is adaptive.
bool whirl_method_is_adaptive(const char *name);

/// Called at the end of each of the steps_per_revolution equal parts of a revolution: t in (0, period], x the state.
typedef void (*whirl_observe_fn)(void *observer, double t, const double *x);

/// Outcome of a revolution.
typedef enum whirl_motion {
    WHIRL_BOUNDED = 0, ///< within the limit
    WHIRL_DIVERGED,    ///< not finite, or beyond the limit: a result, not a failure
    WHIRL_STUCK        ///< the solver could not go on (step size underflow, endless switching)
} whirl_motion;

/// A method with its workspace for one system; not to be shared between threads.
typedef struct whirl_integrator whirl_integrator;

/// Creates an integrator; `system` is borrowed and must outlive it. WHIRL_BAD_INPUT with a sentence for an unknown
/// method, steps_per_revolution < 1, or tolerances that are not positive. Freed by whirl_integrator_free.
whirl_status whirl_integrator_new(const whirl_system *system, const whirl_integrate_options *options,
                                  whirl_integrator **integrator);

/// Carries x [dimension] over one period, from t = 0 to t = period. `observe` may be NULL. The result depends on x
/// alone, not on earlier calls, so that calls for several states may alternate. After anything but WHIRL_BOUNDED, x is
/// the last state reached and must not be continued.
whirl_motion whirl_integrator_revolve(whirl_integrator *integrator, double *x, whirl_observe_fn observe,
                                      void *observer);

/// Infinitesimal perturbations that are carried along with a motion.
typedef struct whirl_perturbations {
    size_t count;    ///< number of perturbations, 1 to dimension
    double *vectors; ///< [count][dimension]
    /// [count] If not NULL, the vectors are kept orthonormal, and these are the natural logarithms of their lengths
    /// before normalization, summed over a revolution: their means over many are the Lyapunov exponents, largest first
    /// (Benettin et al. 1980). NULL: the vectors are carried unchanged, and unit vectors become the columns of the
    /// monodromy matrix.
    double *growth;
    /// Integral of the divergence of the right-hand side over a revolution, plus ln|det| of the jumps at switches: the
    /// sum of the growth of all perturbations. NaN if the system has no divergence or the motion slid along a switch.
    double volume;
    /// Steps end at every instant at which `observe` is called, so that the vectors are those of that instant. False:
    /// the vectors are meaningful at the end of the revolution only.
    bool at_instants;
} whirl_perturbations;

/// Allocates up to `most` perturbations. WHIRL_BAD_INPUT with a sentence if the system has no Jacobian or the method
/// does not carry as many; WHIRL_NO_MEMORY.
whirl_status whirl_integrator_follow(whirl_integrator *integrator, size_t most);

/// Does whirl_integrator_revolve with perturbations by the variational equations: the exact derivative of the method's
/// steps and, at switches at which the right-hand side jumps, the saltation matrix. Call whirl_integrator_follow first.
/// With fixed steps the motion is to the bit the same as without perturbations. The steps of an adaptive method satisfy
/// two tolerances: the state's own, and rtol of the length of every perturbation (at an equilibrium the state's alone
/// would allow steps of any length). CVODE integrates the equations of the perturbation with the motion, and volume
/// stays NaN.
whirl_motion whirl_integrator_carry(whirl_integrator *integrator, double *x, whirl_perturbations *perturbations,
                                    whirl_observe_fn observe, void *observer);

/// Returns the number of steps that an adaptive method has tried since the integrator was made; 0 for other methods.
size_t whirl_integrator_steps(const whirl_integrator *integrator);

/// Frees an integrator; accepts NULL.
void whirl_integrator_free(whirl_integrator *integrator);

/// Cost of a revolution, in evaluations of the right-hand side.
typedef struct whirl_method_cost {
    double dop853; ///< cost of dop853 if stability bounds its steps; else 0
    /// Cost of rodas5p, with its Jacobians and linear systems; NaN if only the tolerance bounds the steps of dop853,
    /// infinite if the motion could not continue.
    double rodas5p;
} whirl_method_cost;

/// Counts the cost of a machine in a probe of a few revolutions from `start` [dimension]: a function of its arguments
/// alone, no time is measured. WHIRL_NO_MEMORY, and WHIRL_BAD_INPUT as whirl_integrator_new.
whirl_status whirl_method_probe(const whirl_system *system, const whirl_integrate_options *options, const double *start,
                                whirl_method_cost *cost);

/// Check of the steps of a fixed-step method over a revolution.
typedef struct whirl_step_check {
    /// Largest factor by which one step multiplies a perturbation, over the factor of the equations if that exceeds 1:
    /// |R(h lambda)| / max(1, |exp(h lambda)|) over the eigenvalues lambda of the Jacobian at the stiffest phase. Above
    /// 1 the step is unstable.
    double growth;
    double steps; ///< steps per revolution that would be stable there: the method's own if they are
    /// Euclidean distance of `end` from the exact end of the revolution from `start`; NaN if that is not known.
    double error;
    double reach; ///< largest modulus of a coordinate at the exact end; NaN if that is not known
} whirl_step_check;

/// Returns true if `growth` exceeds 1 by more than rounding and the truncation of a growing mode may add.
bool whirl_step_is_unstable(const whirl_step_check *check);

/// Checks the steps of a fixed-step method at 17 equally spaced phases of the revolution from `start` [dimension]:
/// their stability, and the error of the method's own end of that revolution, `end` [dimension] or NULL. dop853
/// computes the exact revolution within `tolerance` (absolute, in the state's units), unless the steps are unstable at
/// its beginning. For methods with a tolerance growth is 1, and error and reach are NaN. WHIRL_NO_MEMORY;
/// WHIRL_BAD_INPUT as whirl_integrator_new.
whirl_status whirl_step_check_revolution(const whirl_system *system, const whirl_integrate_options *options,
                                         const double *start, const double *end, double tolerance,
                                         whirl_step_check *check);

#ifdef __cplusplus
}
#endif
#endif
