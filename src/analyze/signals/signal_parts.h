/// Measured signals and balancing, part by part.
#ifndef ANALYZE_SIGNAL_PARTS_H
#define ANALYZE_SIGNAL_PARTS_H

#include "whirl/engine/analyze.h"
#include "whirl/engine/balance.h"
#include "whirl/engine/spectrum.h"
#include "whirl/signals.h"

#include <complex.h>
#include <stddef.h>

// ---------------------------------------------------------------- balance_parts
// Shared by balancing: complex numbers, least squares, unknowns.

static inline double complex balance_number(const double of[2]) {
    return of[0] + of[1] * I;
}

static inline void balance_set(double out[2], double complex value) {
    out[0] = creal(value);
    out[1] = cimag(value);
}

/// Most unknowns: a vibration without weights, and one for every plane or set.
enum { BALANCE_UNKNOWNS = WHIRL_MAX_PLANES + 1 };

/// Complex least squares: unknowns x [n] of weighted rows a x = b, by their normal equations; b in side.
typedef struct balance_normal {
    size_t n;
    double complex matrix[BALANCE_UNKNOWNS][BALANCE_UNKNOWNS], side[BALANCE_UNKNOWNS];
} balance_normal;

void balance_add(balance_normal *of, const double complex *a, double complex b, double weight);

/// Solves for the unknowns, into `side`; false if the rows do not determine them.
bool balance_unknowns(balance_normal *of);

/// Moves amounts [n], the solution, to the least squares with |amount| within limits [n]. As a function of one amount
/// the goal is a circular bowl, so the nearest amount within its limit is the best one while the others stay: amounts
/// are moved in turn until none changes (Tseng 2001).
void balance_within(const balance_normal *of, const double *limits, double complex *amounts);

/// Returns the ratio of the largest singular value of the rows to the smallest; significance [n] as in
/// whirl_correction. NaN without memory.
double balance_condition(const balance_normal *of, double *significance);

/// Number of a correction's unknowns: planes, or sets if there are modes.
size_t balance_unknown_count(const whirl_balance *of);

/// Index of the mode that readings at a speed belong to: the one of the nearest speed.
size_t balance_mode_of(const whirl_balance *of, double speed);

/// Effect of a kg m of an unknown at a row, by influence coefficients of planes.
double complex balance_effect(const whirl_correction *of, const double (*influence)[2], size_t planes, size_t unknown);

// ---------------------------------------------------------------- balance_limits
// Best weights within limits, for goals that coordinate-wise moves do not minimize.

/// Goal of a correction: rows before + effect x, with moments share x of at most limits in the planes.
typedef struct balance_goal {
    size_t n, rows, planes;       ///< unknowns; readings; planes with a limit
    const double complex *effect; ///< [rows][n] times the root of a row's weight
    const double complex *before; ///< [rows] times the same
    const double complex *share;  ///< [planes][n]
    const double *limits;         ///< [planes] kg m, above 0
    bool least_max;               ///< minimize the largest |row|; false: the sum of squares
} balance_goal;

/// Finds the best unknowns x [n]: to 1e-11 of the largest |row|, or of the largest |before|^2 for squares. The rows
/// must determine all unknowns. False without memory.
bool balance_best_within(const balance_goal *goal, double complex *amounts);

// ---------------------------------------------------------------- balance_sets
// Sets of weights that excite one mode alone.

/// Finds the weight sets of the modes: whirl_correction.sets.
whirl_status balance_find_sets(const whirl_balance *of, const whirl_balance_model *model, whirl_correction *out);

// ---------------------------------------------------------------- balance_trials
// Trial weights that a model proposes.

/// Proposes trial weights for all unknowns, by the model.
void balance_propose(const whirl_balance *of, const whirl_balance_model *model, whirl_correction *out);

// ---------------------------------------------------------------- transform
// Transform of two windowed coordinates at any frequency, also between bins.

typedef struct wave_transform wave_transform;

/// Makes one of x and y [count]; `window_sum` is the sum of their window. NULL without memory. Freed by
/// wave_transform_free.
wave_transform *wave_transform_new(const double *x, const double *y, size_t count, double window_sum);
void wave_transform_free(wave_transform *transform);

/// Number of samples.
size_t wave_transform_count(const wave_transform *transform);

/// Sums of x and of y times exp(-2 pi i bin j/count), over the window's sum: the amplitude a of a sinusoid a e^(i
/// theta) + conj(a) e^(-i theta) at that frequency. Exact to 1e-14 of the largest amplitude.
typedef struct wave_amplitudes {
    double complex x, y;
} wave_amplitudes;
wave_amplitudes wave_transform_at(const wave_transform *transform, double bin); // bin >= 0

// ---------------------------------------------------------------- lines
// Lines of a spectrum: frequency and amplitude of the sinusoids in a Hann-windowed signal, between the bins.

/// Finds up to WHIRL_MAX_LINES lines of a Hann-windowed signal, largest first, with `order` in bins. `power` [bins] is
/// the squared amplitude at the whole bins 0, 1, ...; lines are searched from bin 2 (lower ones are indistinguishable
/// from the mean) to bins - 2. Returns how many there are.
size_t spectrum_lines(const wave_transform *wave, const double *power, size_t bins, whirl_line *lines);

/// Zero-to-peak amplitudes of the sinusoids of an order.
whirl_line spectrum_line(double order, wave_amplitudes at);

// ---------------------------------------------------------------- signal_check
// Checks of measured signals before any analysis.

/// Checks channels [channels][count] of numbers, at least `fewest` samples each.
whirl_status signal_check_channels(const double *values, size_t count, size_t channels, size_t fewest);

/// Checks points [count][dimension], at least `fewest`.
whirl_status signal_check_points(const double *points, size_t count, size_t dimension, size_t fewest);

/// Checks instants of samples [count], which grow and leave no gap.
whirl_status signal_check_time(const double *time, size_t count);

/// Checks at least two instants of pulses, which grow.
whirl_status signal_check_pulses(const double *instants, size_t pulses);

/// Checks pulses and samples: none of the pulses is before or after the samples, which are at least `fewest`.
whirl_status signal_check_turns(const double *time, size_t count, size_t fewest, const double *instants, size_t pulses);

/// Checks the size of a motion, against which distances are judged.
whirl_status signal_check_size(double size);

// ---------------------------------------------------------------- synchronous
// The synchronous (1X) part of a motion: amplitude and phase of the sinusoid that goes once round with the shaft.

/// Synchronous (1X) part of a record of `samples_per_revolution`, whose first sample is one step after the mark.
/// `size`: the largest displacement. An amplitude below 1e-12 of it is rounding and has no phase.
whirl_synchronous synchronous_part(const wave_transform *wave, size_t samples_per_revolution, double size);

/// Finds the synchronous part of a motion Re(x e^(i tau)), Re(y e^(i tau)); lags of parts below 1e-12 of `size` are
/// NaN.
whirl_synchronous synchronous_of(double complex x, double complex y, double size);

/// Synchronous part of a station at rest: no amplitudes, and no phases.
whirl_synchronous synchronous_none(void);

#endif
