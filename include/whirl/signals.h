/// Measured signals: the analyses that whirl makes of computed motions, of arrays of numbers from a machine.
///
/// Pulses of a keyphasor tell when the shaft has turned once more; signals sampled in time become sections (a point a
/// revolution) and samples at equal angles, of which spectra have orders as their axis, also while the speed changes.
///
///     whirl_signals_pulses(time, voltage, count, threshold, hysteresis, true, instants, &pulses);
///     whirl_signals_section(time, values, count, 2, instants, pulses, 0.0, 7, section, &points);
///     whirl_signals_resample(time, values, count, 2, instants, pulses, 128, 7, turned);
///     whirl_signals_spectrum(turned, turned + turns, turns, 128, 10.0, bins, lines, &line_count, synchronous);
///
/// Units are the caller's: time in any unit (speeds are rad per unit of it), signals in any unit (amplitudes are in it,
/// zero to peak). Angles are in rad. Channels lie one after the other, values [channels][count]; points of a section
/// likewise, points [count][dimension]. All arrays belong to the caller. Samples, channels, pulses and points are
/// counted from 0. What is not finite (a gap), does not grow in time, is too short, or is more than
/// WHIRL_SIGNALS_MAX numbers gives WHIRL_BAD_INPUT with a sentence; then nothing was written that counts. Every
/// function may be called on several threads at once.
///
/// Stable interface: docs/abi.md says for how long.
#ifndef WHIRL_SIGNALS_H
#define WHIRL_SIGNALS_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Bounds of what is taken.
enum {
    WHIRL_SIGNALS_MAX = 1000000000,       ///< numbers of an array
    WHIRL_SIGNALS_HIGHEST_ORDER = 9,      ///< of the polynomials that interpolate
    WHIRL_SIGNALS_MIN_REVOLUTIONS = 4,    ///< of a spectrum
    WHIRL_SIGNALS_MAX_RECURRENCES = 20000 ///< points that whirl_signals_recurrence compares with one another
};

// ---------------------------------------------------------------- the keyphasor

/// Levels for whirl_signals_pulses: the threshold halfway between the least and the largest voltage [count], the
/// hysteresis a fifth of what is between them. WHIRL_BAD_INPUT where the voltage does not change.
whirl_status whirl_signals_threshold(const double *voltage, size_t count, double *threshold, double *hysteresis);

/// Instants at which the voltage [count] rises (or, `rising` false, falls) through the threshold, on the straight line
/// between the samples before and after. After a pulse the voltage has to go back beyond the threshold by more than the
/// hysteresis >= 0 before the next one counts; so it has before the first one. `time` [count] grows. Written to
/// `instants`, which has room for count/2 + 1; *pulses of them, which may be 0.
whirl_status whirl_signals_pulses(const double *time, const double *voltage, size_t count, double threshold,
                                  double hysteresis, bool rising, double *instants, size_t *pulses);

/// Mean speed between the pulses, rad per unit of time: speed [pulses - 1]. WHIRL_BAD_INPUT for fewer than 2 pulses and
/// for instants that do not grow, here and in all that follows.
whirl_status whirl_signals_speed(const double *instants, size_t pulses, double *speed);

// ---------------------------------------------------------------- by the angle of the shaft

/// The section: each channel at each pulse, or at the angle `phase` after it, 0 <= phase < 2 pi, where the next pulse
/// is there. Between pulses the angle is a monotone cubic of time (Fritsch and Carlson 1980) with the slopes of
/// parabolas through three pulses, so that a constant acceleration goes as Fyfe and Munck (1997) have it. Signals are
/// interpolated by polynomials of odd order, 1 to WHIRL_SIGNALS_HIGHEST_ORDER, through the order + 1 samples around an
/// instant: order 1 is the straight line. At the instant of a sample the sample itself is given. `section` has room for
/// [pulses][channels], of which [*points] are written. Pulses lie within the samples, whose time [count] grows.
whirl_status whirl_signals_section(const double *time, const double *values, size_t count, size_t channels,
                                   const double *instants, size_t pulses, double phase, int order, double *section,
                                   size_t *points);

/// Samples a revolution that lose none of the record's: as many as lie between those two neighbouring pulses between
/// which there are most, and one more where that is odd; 8 at least.
whirl_status whirl_signals_samples(const double *time, size_t count, const double *instants, size_t pulses,
                                   size_t *samples);

/// Samples at equal angles between the pulses (order tracking, Fyfe and Munck 1997), interpolated as
/// whirl_signals_section does: sample j of a revolution at the angle 2 pi (j + 1)/samples after its pulse, so that the
/// last one is at the next pulse, as in the waveforms of results. resampled [channels][(pulses - 1) samples]. Parts of
/// the signal above the order samples/2 fold to lower ones, as in any sampling: whirl_signals_samples says how many
/// there should be at least. WHIRL_BAD_INPUT for fewer than 3.
whirl_status whirl_signals_resample(const double *time, const double *values, size_t count, size_t channels,
                                    const double *instants, size_t pulses, size_t samples, int order,
                                    double *resampled);

/// Displacements x, y [count] from what two probes of one plane measure, u and v [count], that stand at the angles
/// `first` and `second` from the x axis in the sense of rotation: u = x cos first + y sin first, v likewise.
/// WHIRL_BAD_INPUT where they are within 0.01 rad of one line.
whirl_status whirl_signals_axes(const double *u, const double *v, size_t count, double first, double second, double *x,
                                double *y);

// ---------------------------------------------------------------- spectra

/// Numbers of a row of a spectrum.
enum { WHIRL_SIGNALS_COLUMNS = 5, WHIRL_SIGNALS_LINES = 16 };

/// Orders that whirl_signals_spectrum gives: 0, 1/revolutions, 2/revolutions ... up to the highest order and below half
/// the samples of a revolution. 0 for what is no whole number of revolutions.
size_t whirl_signals_orders(size_t count, size_t samples, double highest_order);

/// Spectra of two displacements [count] at equal angles, `samples` a revolution (whirl_signals_resample), and their
/// full spectrum, which tells forward from backward whirl (Goldman and Muszynska 1999): what the analysis `spectrum`
/// gives of a computed motion. Hann window over all revolutions, the mean removed.
/// - `orders` [whirl_signals_orders][5]: order, amplitudes of x, of y, of the circular motions with the rotation and
///   against it. May be NULL.
/// - `lines` [WHIRL_SIGNALS_LINES][5], the same of the sinusoids that are found, also between the orders of the
///   resolution, largest first; *line_count of them.
/// - `synchronous` [2][4]: amplitudes of the part once a revolution of x, y, forward, backward; then the degrees by
///   which they lag behind the pulse, as whirl_synchronous has them, NaN where there is no amplitude.
/// `y` may be NULL: one signal alone, x. WHIRL_BAD_INPUT for no whole number of revolutions, fewer than
/// WHIRL_SIGNALS_MIN_REVOLUTIONS of them or fewer than 3 samples each, and for a highest order that is not above 0.
whirl_status whirl_signals_spectrum(const double *x, const double *y, size_t count, size_t samples,
                                    double highest_order, double *orders, double *lines, size_t *line_count,
                                    double *synchronous);

// ---------------------------------------------------------------- sections

/// Half the diagonal of the bounds of the channels: the size of a motion, against which the functions below judge
/// distances. Of all samples, not of a section alone: that of a periodic motion has no size but its noise.
whirl_status whirl_signals_size(const double *values, size_t count, size_t channels, double *size);

/// K of the 0-1 test for chaos (Gottwald and Melbourne 2009) over the last 4000 points: near 1 in chaos, near 0 for
/// regular motion (below 0 too), the median over 25 frequencies as for computed motions. NaN where no coordinate
/// spreads by more than 1e-6 of `size` > 0. WHIRL_BAD_INPUT for fewer than 100 points.
whirl_status whirl_signals_zero_one(const double *points, size_t count, size_t dimension, double size, double *k);

/// After how many revolutions the points come back: the smallest *period up to 64 (128 where three of them are there)
/// whose largest return distance |z(n + period) - z(n)|, over `size` > 0, is *distance <= tolerance; where none is, the
/// period up to 64 of the smallest distance, which is above the tolerance then. The last 20000 points are looked at.
/// The tolerance >= 0 has to be above the noise. WHIRL_BAD_INPUT for fewer than 5 points.
whirl_status whirl_signals_returns(const double *points, size_t count, size_t dimension, double size, double tolerance,
                                   int *period, double *distance);

/// Recurrence quantified (Marwan, Romano, Thiel and Kurths 2007, section 3.5): points i and j recur where their
/// Euclidean distance is at most `radius` >= 0, in the unit of the points. A point and itself are no recurrence, but
/// part of a vertical line. WHIRL_BAD_INPUT for fewer than 2 points or more than WHIRL_SIGNALS_MAX_RECURRENCES (the
/// work grows with their square), and for a `shortest` line below 2.
/// - *rate: share of the pairs that recur.
/// - *determinism: share of the recurring pairs in diagonal lines of `shortest` points or more; NaN without any.
/// - *laminarity: share of the recurring points in vertical lines of `shortest` points or more.
/// - *longest: points of the longest diagonal line, the main diagonal apart.
whirl_status whirl_signals_recurrence(const double *points, size_t count, size_t dimension, double radius,
                                      size_t shortest, double *rate, double *determinism, double *laminarity,
                                      size_t *longest);

#ifdef __cplusplus
}
#endif
#endif
