/// Motions of a fit: their orbits at given values of the unknowns, and the computed counterparts of the measured
/// numbers.
#ifndef STUDY_FIT_MOTIONS_H
#define STUDY_FIT_MOTIONS_H

#include "whirl/engine/fit.h"
#include "whirl/engine/study.h"

/// The orbit of a motion at values of the unknowns. For a threshold at rest the state is one coordinate, its value; for
/// a mode it is the eigenvalue in rad/s, real and imaginary part.
typedef struct fit_orbit {
    double at[WHIRL_MAX_UNKNOWNS]; ///< values of the unknowns
    size_t dimension;              ///< dimension of the state; 0: no orbit is known yet
    double *node;                  ///< [dimension] state at the beginning of the orbit
    double *slopes;                ///< [unknowns][dimension] derivatives of that state
    double largest, speed;         ///< largest modulus of its multipliers, and speed of the shaft, rad/s
    double value;                  ///< value of the onset of an orbit
    double by[WHIRL_MAX_UNKNOWNS]; ///< derivatives of `value` by the unknowns
    whirl_special special;         ///< kind of the point at the onset
    double scatter;                ///< largest scatter of a statistic, over its noise
    double time;                   ///< of a row of a run: s since its beginning; 0: not known
} fit_orbit;

/// All motions of a fit. `tried` are the orbits of the last evaluation, `kept` those of the best values so far.
typedef struct fit_motions {
    const whirl_study *study;
    const whirl_batch *batch;
    const whirl_fit *fit;
    int threads;
    fit_orbit *kept, *tried;   ///< [motions]
    double *model;             ///< [numbers] m, of the last evaluation
    bool (*goes_on)(void *of); ///< called by the first thread after every evaluation: false to end
    void *of;                  ///< argument of goes_on
    size_t lost;         ///< index of the motion without an orbit in the last evaluation, or the number of motions
    whirl_status status; ///< why that motion has no orbit; WHIRL_NO_MEMORY and WHIRL_STOPPED end the fit
} fit_motions;

/// Allocates the motions. WHIRL_NO_MEMORY. Freed by fit_motions_free, after a failure, too.
whirl_status fit_motions_make(fit_motions *m);
void fit_motions_free(fit_motions *m);

/// Makes motions with the same kept orbits. WHIRL_NO_MEMORY. Freed by fit_motions_free, after a failure, too.
whirl_status fit_motions_copy(const fit_motions *from, fit_motions *to);

/// Evaluates residuals [numbers], model less measured over noise, and their derivatives [numbers][unknowns], as
/// least_squares_solve requires; false if a motion has no orbit near the one kept.
bool fit_motions_evaluate(void *motions, const double *values, double *residuals, double *derivatives);

/// Keeps the orbits of the last evaluation.
void fit_motions_keep(void *motions);

#endif
