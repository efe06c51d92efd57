/// Integrators: carry a state over whole revolutions. They know systems, not rotors.
#ifndef WHIRL_INTEGRATE_H
#define WHIRL_INTEGRATE_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/status.h"
#include "whirl/system.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    WHIRL_MAX_STEPS = 1 << 24 ///< of a revolution, and samples of one: what cases and result files may say
};

typedef struct whirl_integrate_options {
    char method[WHIRL_NAME_SIZE]; ///< a name of whirl_method_at()
    /// Instants of a revolution at which an observer is called, equally spaced; for a fixed-step method also its steps.
    int steps_per_revolution;
    double rtol; ///< relative tolerance of adaptive methods
    double atol; ///< absolute tolerance of adaptive methods, in the state's units
    /// rk4: split steps at the zeros of the switching functions, located inside the step; other methods always do.
    bool located;
    double limit; ///< a state with a coordinate beyond +-limit counts as diverged, in the state's units
} whirl_integrate_options;

/// rk4, 1024 steps a revolution (the 2015 paper's), rtol 1e-9, atol 1e-12, limit 1e6.
whirl_integrate_options whirl_integrate_default(void);

/// A method as it describes itself.
typedef struct whirl_method {
    const char *name;
    const char *meaning;
    bool adaptive; ///< uses rtol and atol, and finds the zeros of the switching functions
    bool follows;  ///< takes disturbances along (whirl_integrator_follow)
} whirl_method;

/// The methods that this build has, by index from 0; NULL past the last. Static.
const whirl_method *whirl_method_at(size_t index);

/// The method of that name. WHIRL_BAD_INPUT that names the nearest one when there is none.
whirl_status whirl_method_find(const char *name, const whirl_method **method);

/// Whether there is a method of that name, and it is adaptive.
bool whirl_method_is_adaptive(const char *name);

/// Called at the end of each of the steps_per_revolution equal parts of a revolution: t in (0, period], x the state.
typedef void (*whirl_observe_fn)(void *observer, double t, const double *x);

typedef enum whirl_motion {
    WHIRL_BOUNDED = 0,
    WHIRL_DIVERGED, ///< not finite, or beyond the limit: a result, not a failure
    WHIRL_STUCK     ///< the solver could not go on (step size underflow, endless switching)
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

/// Disturbances, infinitely small, that go with a motion.
typedef struct whirl_disturbances {
    size_t count;    ///< 1 to dimension
    double *vectors; ///< [count][dimension]
    /// [count] With it the vectors stay orthonormal, and these are the natural logarithms of what their lengths were before, summed
    /// over a revolution: their means over many are the Lyapunov exponents, largest first (Benettin et al. 1980). NULL: the
    /// vectors are carried as they are, and unit vectors become the columns of the monodromy matrix.
    double *growth;
    /// Integral of the divergence of the right-hand side over a revolution, and ln|det| of what happened at switches: the sum
    /// of the growth of all disturbances. Not a number where the system gives no divergence or the motion slid along a switch.
    double volume;
} whirl_disturbances;

/// Makes room for up to `most` disturbances. WHIRL_BAD_INPUT with a sentence where the system gives no Jacobian or the method
/// takes no disturbances along; WHIRL_NO_MEMORY.
whirl_status whirl_integrator_follow(whirl_integrator *integrator, size_t most);

/// whirl_integrator_revolve, to the bit, with disturbances by the variational equations: the exact derivative of the method's
/// steps and, at switches where the right-hand side jumps, the saltation matrix. There must be room for them.
whirl_motion whirl_integrator_carry(whirl_integrator *integrator, double *x, whirl_disturbances *disturbances,
                                    whirl_observe_fn observe, void *observer);

void whirl_integrator_free(whirl_integrator *integrator);

#ifdef __cplusplus
}
#endif
#endif
