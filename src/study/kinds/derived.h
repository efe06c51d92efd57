/// Derivatives of a point's numbers by parameters of the case (whirl_derivatives).
#ifndef STUDY_DERIVED_H
#define STUDY_DERIVED_H

#include "kinds.h"
#include "varied.h"
#include "whirl/engine/sensitivity.h"
#include "whirl/engine/study.h"

/// Fills in the fields "sensitivity/..." in the block of a machine at rest, whose other fields are filled in: `own` is
/// the machine, with its modes if the analyses need them. Does nothing if the layout has no such fields. Derivatives
/// that cannot be found are NaN. WHIRL_NO_MEMORY, WHIRL_STOPPED.
whirl_status derived_at_rest(const whirl_study *study, const whirl_batch *batch, const resting_machine *own,
                             const whirl_layout *layout, double *block);

/// Does the same for a motion with a periodic verdict in `block`, which ends at state `end` of the section: the orbit
/// is found from there, with the verdict's period. Quasi-periodic and chaotic motions get differences of records if
/// whirl_derivatives.difference is given, and other motions no derivatives. `value` is the point's value of
/// the batch's parameter.
whirl_status derived_of_motion(const whirl_study *study, const whirl_batch *batch, double value,
                               const whirl_machine *machine, const double *end, const whirl_layout *layout,
                               double *block);

/// Does the same for a special point of a branch, whose parameter value is differentiated: a fold, doubling or
/// Neimark-Sacker point of forced orbits, or a Hopf point of equilibria. Other points get no derivatives. `system` is
/// any machine of the batch.
whirl_status derived_of_special(const whirl_study *study, const whirl_batch *batch, const whirl_system *system,
                                const whirl_branch_point *point, const whirl_layout *layout, double *block);

/// Derives the value of a critical speed or threshold, which critical_locate has found, by parameters [count, at most
/// WHIRL_MAX_SENSITIVITIES]: slopes [count], NaN where they cannot be found. WHIRL_NO_MEMORY, WHIRL_STOPPED.
whirl_status derived_threshold(const whirl_study *study, const whirl_batch *batch, const whirl_critical *at,
                               size_t count, const varied_parameter *parameters, double *slopes);

/// Derives the eigenvalue of a mode of a machine at rest, real and imaginary part in rad/s: slopes [count][2]. Errors
/// as those of derived_threshold.
whirl_status derived_mode(const whirl_study *study, const whirl_batch *batch, const resting_machine *own, size_t mode,
                          size_t count, const varied_parameter *parameters, double *slopes);

/// Derives the parameter value of a fold, doubling or Neimark-Sacker point of forced orbits: slopes [count]. The
/// machine of the point is the machine of the batch whose varied parameter has that value. Errors as those of
/// derived_threshold.
whirl_status derived_special_point(const whirl_study *study, const whirl_batch *batch, const whirl_branch_point *point,
                                   const whirl_orbit_options *options, size_t count, const varied_parameter *parameters,
                                   double *slopes);

#endif
