/// Branches of tori along a parameter, from Neimark-Sacker points on.
#ifndef WHIRL_TORUS_BRANCH_H
#define WHIRL_TORUS_BRANCH_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/branch.h"
#include "whirl/engine/torus.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Options of following a branch of tori.
typedef struct whirl_torus_branch_options {
    whirl_torus_options torus; ///< options of finding each
    double from, to;           ///< bounds of the parameter
    double step; ///< first step along the branch. A length of 1 is a change of the parameter by to - from, or of the
                 ///< curve by its own size
    double least_step, most_step; ///< shortest and longest step
    size_t most_points;           ///< most points of the branch
    /// Receives every torus as it is found, which the branch owns; false ends the branch with that torus. May be NULL.
    bool (*found)(void *context, double value, const whirl_torus *torus);
    void *context; ///< borrowed
    /// NULL, or a flag that ends the branch when it becomes true, for good; tori found since are discarded. Machines of
    /// the family have it, too (whirl_system.stop). Borrowed.
    const whirl_stop *stop;
} whirl_torus_branch_options;

/// Returns the defaults: steps of 1e-4 to 0.05, at first 0.01, at most 200 points.
whirl_torus_branch_options whirl_torus_branch_default(double from, double to);

/// Finds the first torus of the branch that begins at a Neimark-Sacker point of the family. Its curve is an ellipse
/// around the orbit, at a mean distance of about `step` of the orbit's largest coordinate; *value is its parameter.
/// WHIRL_BAD_INPUT if none is found there, near strong resonances (orbits of up to four times the period), and for
/// points of other kinds; WHIRL_NO_MEMORY.
whirl_status whirl_torus_begin(const whirl_family *family, const whirl_branch_point *point, double step,
                               const whirl_torus_branch_options *options, whirl_torus **torus, double *value);

/// A point of a branch of tori.
typedef struct whirl_torus_point {
    double value;       ///< value of the parameter
    whirl_torus *torus; ///< the torus; owned by the branch
} whirl_torus_point;

/// Reasons for the end of a branch of tori.
typedef enum whirl_torus_end {
    WHIRL_TORUS_END_OF_RANGE = 0, ///< the parameter left its bounds
    WHIRL_TORUS_END_OF_POINTS,    ///< it has the requested number of points
    WHIRL_TORUS_SHRANK,           ///< it shrank to the orbit at its Neimark-Sacker point
    WHIRL_TORUS_ROUGH,            ///< the curve needs more nodes than allowed: it loses its smoothness, or locks
    WHIRL_TORUS_LOST,             ///< the shortest step found no curve
    WHIRL_TORUS_STOPPED           ///< whirl_torus_branch_options.found returned false, or .stop became true
} whirl_torus_end;

/// A branch of tori, in the order in which it was followed; freed by whirl_torus_branch_free.
typedef struct whirl_torus_branch {
    size_t count;              ///< number of points
    whirl_torus_point *points; ///< [count]
    whirl_torus_end end;       ///< reason for its end
    /// Value of the parameter at the end of the branch, extrapolated from its last two tori: where the radius of a
    /// shrinking torus vanishes, or where a rough torus near a resonance locks. The square of the radius, or of the
    /// rotation number's distance from the resonance, is taken as linear. NaN if the two tori do not converge.
    double limit;
    char why[WHIRL_MESSAGE_SIZE]; ///< the end in a sentence, with its place and numbers
} whirl_torus_branch;

/// Follows the branch of a torus of the family at `value` by pseudo-arclength continuation, with a variable rotation
/// number. `direction` (+1, -1) is the first direction of the parameter. Errors as whirl_branch_follow.
whirl_status whirl_torus_follow(const whirl_family *family, const whirl_torus *start, double value, int direction,
                                const whirl_torus_branch_options *options, whirl_torus_branch **branch);

/// Frees a branch with its tori; accepts NULL.
void whirl_torus_branch_free(whirl_torus_branch *branch);

#ifdef __cplusplus
}
#endif
#endif
