/// Long motions recorded by the library, and the results of its analyses.
#ifndef SUPPORT_RECORD_H
#define SUPPORT_RECORD_H

#include "whirl/engine/analyze.h"

/// Records `record` revolutions after `transient`, by RK4, without waveforms; all recorded revolutions are watched.
whirl_record *record_motion(const whirl_system *system, const double *start, int steps_per_revolution, int transient,
                            int record);

/// Compares the library's verdict in words: "P-2", "chaotic".
void check_regime(const char *id, const char *what, const char *expected, const whirl_record *record);

/// A point of a Poincare section (state 0, state 1) as printed.
typedef struct printed_point {
    const char *x, *y;
} printed_point;

/// Sharpens the P-`period` orbit that the record ended on by Newton's method with `integrator`, and compares its
/// section point nearest to each of the printed ones. *state [dimension] gets a section point of the orbit.
void check_orbit(const char *id, const char *what, const whirl_record *record, whirl_integrator *integrator, int period,
                 const printed_point *points, size_t count, double *state);

/// Compares the largest exponent, per unit of time with `unit_of_time` of them in a revolution, and demands a standard
/// error below half the tolerance.
void check_exponent(const char *id, const char *what, double expected, double tolerance, const whirl_record *record,
                    double unit_of_time);

#endif
