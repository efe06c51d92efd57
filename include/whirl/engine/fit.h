/// Fits: values of parameters of a machine at which its motions are the measured ones (study `fit`).
///
/// Each measured motion is a periodic orbit of the machine at parameters of its own. Its displacements, and the orders
/// of them, are compared with the measured numbers. They may also be those of the machine while its speed changes
/// (whirl_fit_run). Further numbers are values at which the machine loses its stability, critical speeds, and
/// frequencies and damping ratios of modes. Levenberg and Marquardt's method minimizes the sum of squares of the
/// differences over their noise, with the exact derivatives of the orbits, and those of thresholds and modes
/// (whirl/engine/sensitivity.h).
#ifndef WHIRL_FIT_H
#define WHIRL_FIT_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/descriptor.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Limits of fits.
enum {
    WHIRL_MAX_UNKNOWNS = 8,         ///< unknown parameters
    WHIRL_MAX_FIT_SETS = 32,        ///< files of measured numbers
    WHIRL_MAX_FIT_MOTIONS = 1024,   ///< motions of a fit
    WHIRL_MAX_FIT_NUMBERS = 100000, ///< measured numbers
    WHIRL_MAX_FIT_RUN_ORDER = 4     ///< highest order of a run
};

/// Options of a fit.
typedef struct whirl_fit_options {
    int revolutions;              ///< revolutions of the orbits
    int transient;                ///< revolutions after which a motion is near its orbit
    char loss[WHIRL_NAME_SIZE];   ///< "squares", or "huber": squares up to huber standard deviations, then linear
    double huber;                 ///< limit of "huber", in standard deviations
    int most_steps;               ///< most evaluations of all motions
    double tolerance;             ///< relative change of the unknowns in a step below which the fit ends
    double rtol;                  ///< relative tolerance of the orbits' integration
    char method[WHIRL_NAME_SIZE]; ///< dop853 or rodas5p
    bool profile;                 ///< find profile intervals, too
    int record;                   ///< revolutions of the records of which statistics are taken
    double difference;            ///< relative change of an unknown for finite differences of statistics
    int unknowns;                 ///< number of unknown parameters
    int motions;                  ///< number of motions
    int numbers;                  ///< number of measured numbers
    double noise;                 ///< 1 if the noise of the numbers is given, else 0
    double data;                  ///< checksum of the measured numbers
} whirl_fit_options;

/// Returns the members of these options for cases (part "fit") and results; static, ended by a member without a part.
const whirl_member *whirl_fit_members(void);

/// A measured quantity of a motion x(theta), theta the angle of the shaft, or of the machine.
typedef enum whirl_fit_quantity {
    WHIRL_FIT_SAMPLE,      ///< displacement at an instant
    WHIRL_FIT_COS,         ///< a of a cos(n theta) + b sin(n theta), the part of order n
    WHIRL_FIT_SIN,         ///< b of the same part
    WHIRL_FIT_AMPLITUDE,   ///< sqrt(a^2 + b^2)
    WHIRL_FIT_WAVEFORM,    ///< displacement after a time, with the mark on the x axis at time 0; in a run at a time of
                           ///< its table
    WHIRL_FIT_ONSET,       ///< value of a parameter, or speed, above which the equilibrium is unstable
    WHIRL_FIT_ORBIT_ONSET, ///< value of a parameter, or speed, above which the periodic orbit is unstable, or ends
    WHIRL_FIT_CRITICAL,    ///< critical speed, or value of a parameter at which a mode whirls once a revolution
    WHIRL_FIT_FREQUENCY,   ///< damped frequency of a mode, rad/s
    WHIRL_FIT_DAMPING,     ///< damping ratio of a mode
    WHIRL_FIT_HIGHEST,     ///< largest displacement of a record
    WHIRL_FIT_LOWEST,      ///< smallest displacement of a record
    WHIRL_FIT_LINE,        ///< size of a spectral line of a record: of a whole order, else the largest near the order
    WHIRL_FIT_SHARE        ///< share of the time in which some contact is closed
} whirl_fit_quantity;

/// Returns true for statistics of a record, whose motion need not be periodic.
static inline bool whirl_fit_is_statistic(whirl_fit_quantity what) {
    return what >= WHIRL_FIT_HIGHEST;
}

/// Returns true for quantities that are displacements or parts of them, in m.
static inline bool whirl_fit_is_motion(whirl_fit_quantity what) {
    return what <= WHIRL_FIT_WAVEFORM || (what >= WHIRL_FIT_HIGHEST && what <= WHIRL_FIT_LINE);
}

/// A measured number.
typedef struct whirl_fit_number {
    size_t set;                  ///< file that it is from, from 0
    size_t motion;               ///< index of its motion
    size_t station;              ///< index of its probe
    double angle;                ///< rad, direction of the probe from the x axis towards y
    whirl_fit_quantity quantity; ///< the measured quantity
    /// Revolutions since the motion's beginning; seconds, for a waveform; for a part, its order n; for onsets and
    /// critical speeds, the index of the parameter among those of the case, -1 for the speed.
    double at;
    double value; ///< SI
    double noise; ///< SI, standard deviation; 1 if it is not given
} whirl_fit_number;

/// A run of the machine at a changing speed. Its orders over a turn are measured at speeds or times: each row of its
/// table is a motion of the fit, and all of them are computed together. Or its displacements are measured at times that
/// rise (WHIRL_FIT_WAVEFORM): the run is one motion.
typedef struct whirl_fit_run {
    size_t set;                                ///< entry of the data, from 0
    size_t first, count;                       ///< index of its first motion, and number of its motions
    bool by_time;                              ///< rows are at times (whirl_fit_motion.time), else at speeds
    bool delayed;                              ///< times count from another instant (whirl_machine.delay)
    bool waveform;                             ///< displacements at times, in place of orders
    double first_speed;                        ///< rad/s, of a record at its first sample; 0: not known
    bool sized;                                ///< the number of rows of the run is given, else every turn has a row
    const struct whirl_runup_options *options; ///< at the parameters of the case; borrowed
} whirl_fit_run;

/// A computation whose results are compared with measured numbers: a motion, or for a single number an onset, a
/// critical speed, or a mode.
typedef struct whirl_fit_motion {
    size_t given_count;              ///< number of parameters with values of their own
    const struct whirl_given *given; ///< [given_count] parameters with values of their own; borrowed
    double speed;                    ///< rad/s; 0: the machine's own
    const whirl_fit_run *run;        ///< run to which it belongs, or NULL; borrowed
    double time;                     ///< s since the beginning of that run, if its rows are at times
    size_t instants;                 ///< instants of a revolution at which displacements are needed
    const char *along; ///< for onsets and critical speeds: parameter that varies; NULL: the speed; borrowed
    bool statistics;   ///< its numbers are statistics of a record in time, not of a periodic orbit
    double from, to;   ///< for onsets and critical speeds: bounds of the first search, SI
    int whirl;         ///< for critical speeds and modes: 1 forward, -1 backward, 0 any
    size_t mode; ///< for modes: number at the start, from 1, by rising frequency; 0: the one nearest to the number
} whirl_fit_motion;

/// An unknown parameter.
typedef struct whirl_fit_unknown {
    const char *name;        ///< borrowed
    size_t index;            ///< index among the parameters of the case
    double start, low, high; ///< SI; infinite bounds: none
} whirl_fit_unknown;

/// A problem of a fit: unknown parameters, motions, and the measured numbers of the motions.
typedef struct whirl_fit {
    size_t unknown_count, motion_count, number_count; ///< lengths of the lists
    const whirl_fit_unknown *unknowns;                ///< [unknown_count] borrowed
    const whirl_fit_motion *motions;                  ///< [motion_count] borrowed
    const whirl_fit_number *numbers;                  ///< [number_count] borrowed
    const char *trouble;                              ///< NULL, or why the measured numbers could not be read; borrowed
} whirl_fit;

/// Reasons for the end of a fit.
typedef enum whirl_fit_end {
    WHIRL_FIT_FOUND,    ///< at a minimum of the sum of squares
    WHIRL_FIT_STEPS,    ///< after most_steps
    WHIRL_FIT_STUCK,    ///< no shorter step made the sum smaller
    WHIRL_FIT_NO_MOTION ///< at the start a motion did not settle on an orbit of the given number of revolutions, or
                        ///< there is no such onset, critical speed or mode
} whirl_fit_end;

/// Confidence in a fitted parameter.
typedef enum whirl_fit_known {
    WHIRL_FIT_DETERMINED, ///< its interval is narrower than its bounds and its value
    WHIRL_FIT_AT_BOUND,   ///< it is at one of its bounds
    WHIRL_FIT_WEAK,       ///< its 95 % interval is as wide as its bounds, or wider than twice its value
    WHIRL_FIT_UNKNOWN     ///< the measured numbers do not depend on it, or on a combination that it belongs to
} whirl_fit_known;

/// Result of a fit from one start.
typedef struct whirl_fit_solution {
    whirl_fit_end end;                ///< reason for its end
    size_t lost;                      ///< NO_MOTION: index of that motion
    int steps;                        ///< evaluations of all motions
    double sum;                       ///< sum of squares of residuals over noise
    double deviation;                 ///< standard deviation of residuals over noise; of residuals, m, without noise
    size_t degrees;                   ///< degrees of freedom: numbers less unknowns that are not held at a bound
    size_t rank;                      ///< combinations of parameters that the numbers depend on
    double condition;                 ///< condition of the derivatives with columns of length 1
    double start[WHIRL_MAX_UNKNOWNS]; ///< SI
    double value[WHIRL_MAX_UNKNOWNS]; ///< SI
    double error[WHIRL_MAX_UNKNOWNS]; ///< standard errors, SI; NaN if unknown
    double half[WHIRL_MAX_UNKNOWNS];  ///< half-widths of 95 % intervals, SI; NaN if unknown
    whirl_fit_known known[WHIRL_MAX_UNKNOWNS];                  ///< confidence in each
    double correlation[WHIRL_MAX_UNKNOWNS][WHIRL_MAX_UNKNOWNS]; ///< correlations of the unknowns
    double profile[WHIRL_MAX_UNKNOWNS][2]; ///< ends of 95 % profile intervals, SI; NaN if unknown or not asked for
    double *model;                         ///< [number_count] SI, the numbers of the machine
    double *largest; ///< [motion_count] largest modulus of the orbit's multipliers: stable below 1; NaN for others
    double *speeds;  ///< [motion_count] rad/s
    double *times;   ///< [motion_count] s since the beginning of its run, 0 if that is not known; NaN for others
    double *scatter; ///< [motion_count] of statistics: largest scatter of a number over its noise; NaN for others
} whirl_fit_solution;

#ifdef __cplusplus
}
#endif
#endif
