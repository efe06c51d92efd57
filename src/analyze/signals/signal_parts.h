/// Measured signals and balancing, part by part.
#ifndef ANALYZE_SIGNAL_PARTS_H
#define ANALYZE_SIGNAL_PARTS_H

#include "whirl/engine/analyze.h"
#include "whirl/engine/balance.h"
#include "whirl/signals.h"

#include <complex.h>
#include <stddef.h>

// ---------------------------------------------------------------- balance_parts
// What files on balancing share: complex numbers, least squares, what is unknown.

static inline double complex balance_number(const double of[2]) {
    return of[0] + of[1] * I;
}

static inline void balance_set(double out[2], double complex value) {
    out[0] = creal(value);
    out[1] = cimag(value);
}

/// The most unknowns: a vibration without weights, and one for every plane or set.
enum { BALANCE_UNKNOWNS = WHIRL_MAX_PLANES + 1 };

/// Complex least squares: unknowns x [n] of rows a x = b, each of its weight, by their normal equations; b in side.
typedef struct balance_normal {
    size_t n;
    double complex matrix[BALANCE_UNKNOWNS][BALANCE_UNKNOWNS], side[BALANCE_UNKNOWNS];
} balance_normal;

void balance_add(balance_normal *of, const double complex *a, double complex b, double weight);

/// The unknowns in `side`; false where the rows do not tell all of them.
bool balance_unknowns(balance_normal *of);

/// Moves amounts [n], the unknowns' solution, to the least squares with |amount| within limits [n]. The part of an
/// amount alone is a circular bowl, so that the nearest amount within its limit is the best one while the others stay:
/// amounts take turns until they stay (Tseng 2001).
void balance_within(const balance_normal *of, const double *limits, double complex *amounts);

/// The ratio of the largest singular value of the rows to the smallest; significance [n] as whirl_correction has it.
/// NaN without memory.
double balance_condition(const balance_normal *of, double *significance);

/// How many unknowns a correction has: planes, or sets where there are modes.
size_t balance_unknown_count(const whirl_balance *of);

/// Which mode readings at a speed are of: the one of the nearest speed.
size_t balance_mode_of(const whirl_balance *of, double speed);

/// What a kg m of an unknown does at a row, by influence coefficients of planes.
double complex balance_effect(const whirl_correction *of, const double (*influence)[2], size_t planes, size_t unknown);

// ---------------------------------------------------------------- balance_limits
// The best weights within limits, for goals that taking turns does not reach.

/// What weights are to do: rows before + effect x, with planes that have moments share x of at most limits.
typedef struct balance_goal {
    size_t n, rows, planes;       ///< unknowns; readings; planes that have a limit
    const double complex *effect; ///< [rows][n] times the root of a row's weight
    const double complex *before; ///< [rows] times the same
    const double complex *share;  ///< [planes][n]
    const double *limits;         ///< [planes] kg m, above 0
    bool least_max;               ///< the largest |row| is to be the least; false: the sum of their squares
} balance_goal;

/// Finds the unknowns x [n] that do that best: of the largest |row| to 1e-11, of the squares to 1e-11 of the largest
/// |before|^2. The rows tell all unknowns apart. False without memory.
bool balance_best_within(const balance_goal *goal, double complex *amounts);

// ---------------------------------------------------------------- balance_sets
// Sets of weights that excite one mode alone.

/// The sets of the modes: whirl_correction.sets.
whirl_status balance_find_sets(const whirl_balance *of, const whirl_balance_model *model, whirl_correction *out);

// ---------------------------------------------------------------- balance_trials
// Trial weights that a model proposes.

/// Trial weights of all unknowns, by the model.
void balance_propose(const whirl_balance *of, const whirl_balance_model *model, whirl_correction *out);

// ---------------------------------------------------------------- transform
// The transform of two windowed coordinates at any frequency, between bins too.

typedef struct wave_transform wave_transform;

/// Takes x and y [count]; `window_sum` is what their window sums to. NULL without memory. Freed by wave_transform_free.
wave_transform *wave_transform_new(const double *x, const double *y, size_t count, double window_sum);
void wave_transform_free(wave_transform *transform);

/// Samples that were taken.
size_t wave_transform_count(const wave_transform *transform);

/// The sums of x and of y times exp(-2 pi i bin j/count), over the window's sum: the amplitude a of a sinusoid
/// a e^(i theta) + conj(a) e^(-i theta) at that frequency. To 1e-14 of the largest one that there is.
typedef struct wave_amplitudes {
    double complex x, y;
} wave_amplitudes;
wave_amplitudes wave_transform_at(const wave_transform *transform, double bin); // bin >= 0

// ---------------------------------------------------------------- lines
// Lines of a spectrum: frequency and amplitude of the sinusoids in a Hann-windowed signal, between the bins.

/// Finds up to WHIRL_MAX_LINES lines of a Hann-windowed signal, largest first, with `order` in bins. `power` [bins] is
/// the squared amplitude at the whole bins 0, 1, ...; lines are looked for from bin 2 (below, they cannot be told from
/// the mean) to bins - 2. Returns how many there are.
size_t spectrum_lines(const wave_transform *wave, const double *power, size_t bins, whirl_line *lines);

/// Zero-to-peak amplitudes of the sinusoids of an order.
whirl_line spectrum_line(double order, wave_amplitudes at);

// ---------------------------------------------------------------- signal_check
// What measured signals have to be before anything is said of them.

/// Channels [channels][count] of numbers, at least `fewest` samples each.
whirl_status signal_check_channels(const double *values, size_t count, size_t channels, size_t fewest);

/// Points [count][dimension], at least `fewest`.
whirl_status signal_check_points(const double *points, size_t count, size_t dimension, size_t fewest);

/// Instants of samples [count], which grow and leave no gap.
whirl_status signal_check_time(const double *time, size_t count);

/// At least two instants of pulses, which grow.
whirl_status signal_check_pulses(const double *instants, size_t pulses);

/// The same, and no pulse lies before or after the samples, which are at least `fewest`.
whirl_status signal_check_turns(const double *time, size_t count, size_t fewest, const double *instants, size_t pulses);

/// A size of the motion against which distances can be judged.
whirl_status signal_check_size(double size);

// ---------------------------------------------------------------- synchronous
// The synchronous (1X) part of a motion: amplitude and phase of the sinusoid that goes once round with the shaft.

/// Of a record of `samples_per_revolution`, whose first sample stands one step after the mark. `size`: the largest
/// displacement that there is, below 1e-12 of which an amplitude is rounding and has no phase.
whirl_synchronous synchronous_part(const wave_transform *wave, size_t samples_per_revolution, double size);

/// Of a station that rests: no amplitudes, and no phases.
whirl_synchronous synchronous_none(void);

#endif
