/// Integrators: carry a state over whole revolutions. They know systems, not rotors.
#ifndef WHIRL_INTEGRATE_H
#define WHIRL_INTEGRATE_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/descriptor.h"
#include "whirl/engine/stop.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Bounds of options.
enum {
    WHIRL_MAX_STEPS = 1 << 24 ///< of a revolution, and samples of one: what cases and result files may say
};

/// By what method, and how finely, motions are computed.
typedef struct whirl_integrate_options {
    /// A name of whirl_method_at(). "auto": studies choose for each of their batches (whirl_study_choose_methods);
    /// integrators, ensembles and recorders that are given it as it stands take dop853.
    char method[WHIRL_NAME_SIZE];
    bool chosen; ///< the method was chosen by "auto": results tell; it changes nothing
    /// Instants of a revolution at which an observer is called, equally spaced; for a fixed-step method also its steps.
    int steps_per_revolution;
    double rtol; ///< relative tolerance of adaptive methods
    double atol; ///< absolute tolerance of adaptive methods, in the state's units
    /// rk4: split steps at the zeros of the switching functions, located inside the step; other methods always do.
    bool located;
    double limit; ///< a state with a coordinate beyond +-limit counts as diverged, in the state's units
    /// NULL, or becomes true, for good, when motions shall end at once, within their revolutions: what is computed from
    /// then on means nothing, and is to be thrown away. Borrowed; no part of what is computed.
    const whirl_stop *stop;
} whirl_integrate_options;

/// Whether motions by these options shall end. Asked after a revolution, it tells whether that means anything.
bool whirl_integrate_stopped(const whirl_integrate_options *options);

/// Its members, as cases say them (part "integrate") and results have them; static, ended by one without a part.
const whirl_member *whirl_integrate_members(void);

/// The defaults of whirl_integrate_members, but the method rk4 with the 1024 steps of the 2015 paper.
whirl_integrate_options whirl_integrate_default(void);

/// WHIRL_BAD_INPUT with a sentence for a system without motions in time (whirl_system.frequencies).
whirl_status whirl_integrate_check(const whirl_system *system);

/// A method as it describes itself.
typedef struct whirl_method {
    const char *name;    ///< as written in a case file
    const char *meaning; ///< one line
    bool adaptive;       ///< uses rtol and atol, and finds the zeros of the switching functions
    bool follows;        ///< takes perturbations along (whirl_integrator_follow), as many as there are coordinates
    /// Takes one along, and needs to: its steps and orders are chosen so abruptly that a second trajectory would differ
    /// by them, not by a small perturbation.
    bool follows_one;
} whirl_method;

/// The methods that this build has, by index from 0; NULL past the last. Static.
const whirl_method *whirl_method_at(size_t index);

/// The method of that name. WHIRL_BAD_INPUT that names the nearest one when there is none.
whirl_status whirl_method_find(const char *name, const whirl_method **method);

/// Whether there is a method of that name, and it is adaptive.
bool whirl_method_is_adaptive(const char *name);

/// Called at the end of each of the steps_per_revolution equal parts of a revolution: t in (0, period], x the state.
typedef void (*whirl_observe_fn)(void *observer, double t, const double *x);

/// How a revolution went.
typedef enum whirl_motion {
    WHIRL_BOUNDED = 0, ///< within the limit
    WHIRL_DIVERGED,    ///< not finite, or beyond the limit: a result, not a failure
    WHIRL_STUCK        ///< the solver could not go on (step size underflow, endless switching)
} whirl_motion;

/// A method with its workspace for one system; not to be shared between threads.
typedef struct whirl_integrator whirl_integrator;

/// Makes an integrator; `system` is borrowed and must outlive it. WHIRL_BAD_INPUT with a sentence for an unknown
/// method, steps_per_revolution < 1, or tolerances that are not positive. Freed by whirl_integrator_free.
whirl_status whirl_integrator_new(const whirl_system *system, const whirl_integrate_options *options,
                                  whirl_integrator **integrator);

/// Carries x [dimension] over one period, from t = 0 to t = period. `observe` may be NULL.
/// A pure function of x: nothing is remembered from one call to the next, so calls for several states may alternate.
/// After anything but WHIRL_BOUNDED x is what was reached and must not be continued.
whirl_motion whirl_integrator_revolve(whirl_integrator *integrator, double *x, whirl_observe_fn observe,
                                      void *observer);

/// Perturbations, infinitely small, that go with a motion.
typedef struct whirl_perturbations {
    size_t count;    ///< 1 to dimension
    double *vectors; ///< [count][dimension]
    /// [count] With it the vectors stay orthonormal, and these are the natural logarithms of what their lengths were
    /// before, summed over a revolution: their means over many are the Lyapunov exponents, largest first (Benettin et
    /// al. 1980). NULL: the vectors are carried as they are, and unit vectors become the columns of the monodromy
    /// matrix.
    double *growth;
    /// Integral of the divergence of the right-hand side over a revolution, and ln|det| of what happened at switches:
    /// the sum of the growth of all perturbations. Not a number where the system gives no divergence or the motion slid
    /// along a switch.
    double volume;
} whirl_perturbations;

/// Makes room for up to `most` perturbations. WHIRL_BAD_INPUT with a sentence where the system gives no Jacobian or the
/// method takes not so many along; WHIRL_NO_MEMORY.
whirl_status whirl_integrator_follow(whirl_integrator *integrator, size_t most);

/// whirl_integrator_revolve with perturbations by the variational equations: the exact derivative of the method's steps
/// and, at switches where the right-hand side jumps, the saltation matrix. There must be room for them. With fixed
/// steps the motion is the same to the bit. Steps of an adaptive method are as long as both tolerate: the state's error
/// its own tolerance, that of every perturbation rtol of its length, which an equilibrium would leave to steps of any
/// length. By CVODE the equations of the perturbation are integrated beside the motion, and volume stays unknown.
whirl_motion whirl_integrator_carry(whirl_integrator *integrator, double *x, whirl_perturbations *perturbations,
                                    whirl_observe_fn observe, void *observer);

/// Frees an integrator; NULL is none.
void whirl_integrator_free(whirl_integrator *integrator);

// ---------------------------------------------------------------- which method

/// What a revolution costs, in right-hand sides.
typedef struct whirl_method_cost {
    double dop853; ///< by its steps where they are bounded by stability; 0 where they are not
    /// By rodas5p, whose Jacobian and equations count as well; NaN where dop853 is bounded by its tolerance alone,
    /// infinite where the motion could not go on.
    double rodas5p;
} whirl_method_cost;

/// Counts what a machine costs, after a probe of a few revolutions from `start` [dimension]: a pure function of its
/// arguments, no time is measured. WHIRL_NO_MEMORY, and WHIRL_BAD_INPUT as whirl_integrator_new.
whirl_status whirl_method_probe(const whirl_system *system, const whirl_integrate_options *options, const double *start,
                                whirl_method_cost *cost);

// ---------------------------------------------------------------- whether fixed steps are short enough

/// What a revolution says of the steps of a fixed-step method.
typedef struct whirl_step_check {
    /// Largest factor by which one step multiplies a perturbation, over what the machine itself makes of it where that
    /// grows: |R(h lambda)| / max(1, |exp(h lambda)|) over the eigenvalues lambda of the Jacobian, where it is
    /// stiffest. The step is unstable above 1.
    double growth;
    double steps; ///< a revolution, that would be stable there: the method's own where they are
    /// Euclidean distance of `end` from where the equations lead from `start` in a revolution; NaN where that is not
    /// known.
    double error;
    double reach; ///< largest modulus of a coordinate where the equations lead; NaN where that is not known
} whirl_step_check;

/// growth that counts as unstable: 1 and what rounding and the truncation of a growing mode may add.
bool whirl_step_is_unstable(const whirl_step_check *check);

/// Follows the equations over a revolution from `start` [dimension], by dop853 within `tolerance` (absolute, in the
/// state's units), and looks at the steps of a fixed-step method at 17 equally spaced phases: whether they are stable,
/// and how far the method's own end of that revolution, `end` [dimension] or NULL, lies off. Where they are unstable
/// from the beginning the revolution is not followed. For methods with a tolerance there is nothing to look at: growth
/// 1 and NaN. WHIRL_NO_MEMORY; WHIRL_BAD_INPUT as whirl_integrator_new.
whirl_status whirl_step_check_revolution(const whirl_system *system, const whirl_integrate_options *options,
                                         const double *start, const double *end, double tolerance,
                                         whirl_step_check *check);

#ifdef __cplusplus
}
#endif
#endif
