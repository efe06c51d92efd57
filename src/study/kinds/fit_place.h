/// A motion of a fit at values of the unknowns: its machine, and the orbit on which it settles.
#ifndef STUDY_FIT_PLACE_H
#define STUDY_FIT_PLACE_H

#include "fit_motions.h"
#include "varied.h"
#include "whirl/engine/orbit.h"

/// A motion at values of the unknowns.
typedef struct fit_place {
    const fit_motions *of;
    const whirl_fit_motion *motion;
    const double *values; ///< [unknowns]
    whirl_batch batch;    ///< with which the machine of the place is made
    whirl_given given[WHIRL_MAX_GIVEN];
    whirl_orbit_options options;
} fit_place;

/// Sets the parameters of a motion: its own, then the unknowns.
void fit_place_make(fit_place *p, const fit_motions *of, size_t index, const double *values);

/// Makes the machine of a place, which the caller releases.
whirl_status fit_place_machine(const fit_place *p, whirl_machine *machine);

/// Finds the orbit on which the machine settles. Searches where the motion nearly repeats, and again after the whole
/// transient if there is no stable orbit there. x [dimension] is the start, and workspace.
whirl_status fit_place_begin(const fit_place *p, const whirl_system *system, double *x, whirl_orbit **orbit);

/// Notes the result at a place in *out: the state [dimension] of an orbit, or the number in its place, and its
/// derivatives [unknowns][dimension] (NULL: zeros). Frees the earlier result. WHIRL_NO_MEMORY.
whirl_status fit_place_note(const fit_place *p, size_t dimension, const double *node, const double *slopes,
                            fit_orbit *out);

/// Writes the unknowns at their values, by which numbers are derived: out [unknowns].
void fit_place_unknowns(const fit_place *p, varied_parameter out[WHIRL_MAX_UNKNOWNS]);

#endif
