/// Branches of periodic orbits and equilibria along a parameter, and curves of their special points over two.
#ifndef WHIRL_BRANCH_H
#define WHIRL_BRANCH_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/orbit.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Machines that differ in one parameter.
typedef struct whirl_family {
    /// Makes the machine for a value of the parameter, in SI. All have the same coordinates and switches.
    whirl_status (*machine)(const void *context, double value, whirl_machine *machine);
    const void *context; ///< borrowed
} whirl_family;

/// Kinds of points of a branch.
typedef enum whirl_special {
    WHIRL_REGULAR = 0,    ///< an ordinary point
    WHIRL_FOLD,           ///< the branch turns back: a multiplier is 1
    WHIRL_BRANCHING,      ///< another branch crosses it (a symmetry breaks): a multiplier is 1
    WHIRL_DOUBLING,       ///< a branch of twice the period begins: a multiplier is -1
    WHIRL_NEIMARK_SACKER, ///< a torus begins: a pair of complex multipliers is on the unit circle
    WHIRL_HOPF,           ///< an equilibrium begins to whirl: a pair of its eigenvalues is imaginary
    WHIRL_GRAZE           ///< a contact begins, ends, parts or joins: a switching function has an extreme at 0
} whirl_special;

/// A point of a branch.
typedef struct whirl_branch_point {
    double value;          ///< value of the parameter
    double second;         ///< value of the second parameter on a curve over two; else NaN
    whirl_special special; ///< located to 1e-10 of the branch's span, or regular
    double angle; ///< angle of the multipliers at a Neimark-Sacker point, rad; the torus turns by it in a period
    /// Cubic coefficient of the normal form at doublings, Neimark-Sacker and Hopf points (Kuznetsov 2004, 5.4, with
    /// eigenvectors of length 1; for doublings with the other sign). Below 0 (supercritical) the new motion exists
    /// where the orbit is unstable, and is stable unless another multiplier is outside the unit circle. Above 0
    /// (subcritical) it exists where the orbit is stable, and stability is lost suddenly. NaN if unknown: at other
    /// points, near a third or a fourth of a turn, and on curves except those of Hopf points.
    double criticality;
    size_t touch;       ///< index of the touch of the orbit that grazes
    whirl_orbit *orbit; ///< the orbit there; owned by the branch
} whirl_branch_point;

/// Reasons for the end of a branch.
typedef enum whirl_branch_end {
    WHIRL_END_OF_RANGE = 0, ///< the parameter left its bounds
    WHIRL_END_OF_POINTS,    ///< it has the requested number of points
    WHIRL_END_CLOSED,       ///< it returned to its first point
    WHIRL_END_LOST,         ///< the shortest step found no orbit: the branch may end there
    WHIRL_END_HALVED,       ///< its orbits close after half their period there: at a doubling of another branch
    WHIRL_END_STOPPED,      ///< whirl_branch_options.found returned false, or .stop became true
    WHIRL_END_MIRRORED      ///< its orbits become their own mirror images there: at a pitchfork of a symmetric branch
} whirl_branch_end;

/// A branch, in the order in which it was followed; freed by whirl_branch_free.
typedef struct whirl_branch {
    size_t count;               ///< number of points
    whirl_branch_point *points; ///< [count]
    whirl_branch_end end;       ///< reason for its end
} whirl_branch;

/// Options of following a branch.
typedef struct whirl_branch_options {
    whirl_orbit_options orbit; ///< options of finding its orbits
    double from, to;           ///< bounds of the parameter
    double step; ///< first step along the branch. A length of 1 is a change of the parameter by to - from, or of the
                 ///< orbit by its own size
    double least_step;  ///< shortest step
    double most_step;   ///< longest step
    size_t most_points; ///< most points of the branch
    bool special;       ///< locate special points
    /// Receives every point as it is found; false ends the branch with that point. May be NULL.
    bool (*found)(void *context, const whirl_branch_point *point);
    void *context; ///< borrowed
    /// NULL, or a flag that ends the branch when it becomes true, for good; orbits found since are discarded. Machines
    /// of the family have it, too (whirl_system.stop). Borrowed.
    const whirl_stop *stop;
} whirl_branch_options;

/// Returns the defaults: steps of at most 0.05, at most 1000 points, special points located.
whirl_branch_options whirl_branch_default(double from, double to);

/// Follows the branch of an orbit or equilibrium of the family at `value` by pseudo-arclength continuation (Keller
/// 1977). `direction` (+1, -1) is the first direction of the parameter. WHIRL_BAD_INPUT if there is no such orbit near
/// the given one, and for invalid bounds and steps; WHIRL_NO_MEMORY.
whirl_status whirl_branch_follow(const whirl_family *family, const whirl_orbit *start, double value, int direction,
                                 const whirl_branch_options *options, whirl_branch **branch);

/// Frees a branch with its orbits; accepts NULL.
void whirl_branch_free(whirl_branch *branch);

/// Finds the first orbit of the branch that begins at a doubling, branching or Hopf point, at a distance of `step` (as
/// in whirl_branch_options) from it; *value is its parameter. WHIRL_BAD_INPUT if none is found, and for points of other
/// kinds.
whirl_status whirl_branch_switch(const whirl_family *family, const whirl_branch_point *point, double step,
                                 const whirl_branch_options *options, whirl_orbit **orbit, double *value);

/// Machines that differ in two parameters.
typedef struct whirl_plane {
    /// Makes the machine for two values.
    whirl_status (*machine)(const void *context, double value, double second, whirl_machine *machine);
    const void *context; ///< borrowed
} whirl_plane;

/// Follows a special point (fold, doubling, Neimark-Sacker, Hopf or graze) over two parameters, as a curve of points of
/// the same kind. The curve begins at `start`, which was found at the value `second` of the second parameter;
/// `direction` is the first direction of that parameter. It ends where either parameter leaves its bounds: those of the
/// options, and bounds[0] < bounds[1]. Freed by whirl_branch_free. Errors as whirl_branch_follow.
whirl_status whirl_curve_follow(const whirl_plane *plane, const whirl_branch_point *start, double second, int direction,
                                const double bounds[2], const whirl_branch_options *options, whirl_branch **out);

#ifdef __cplusplus
}
#endif
#endif
