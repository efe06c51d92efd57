/// Measured signals: the analyses of computed motions, applied to arrays of numbers from a machine.
///
/// Pulses of a keyphasor mark each turn of the shaft; signals sampled in time become sections (a point a revolution)
/// and samples at equal angles, of which spectra have orders as their axis, also while the speed changes.
///
///     whirl_signals_pulses(time, voltage, count, threshold, hysteresis, true, instants, &pulses);
///     whirl_signals_section(time, values, count, 2, instants, pulses, 0.0, 7, section, &points);
///     whirl_signals_resample(time, values, count, 2, instants, pulses, 128, 7, turned);
///     whirl_signals_spectrum(turned, turned + turns, turns, 128, 10.0, bins, lines, &line_count, synchronous);
///
/// Units are the caller's: time in any unit (speeds are rad per unit of it), signals in any unit (amplitudes are in it,
/// zero to peak). Angles are in rad. Channels lie one after the other, values [channels][count]; points of a section
/// likewise, points [count][dimension]. All arrays belong to the caller. Samples, channels, pulses and points are
/// counted from 0. Functions return WHIRL_BAD_INPUT with a sentence for numbers that are not finite (gaps), times that
/// do not grow, records that are too short, and arrays of more than WHIRL_SIGNALS_MAX numbers; the outputs are then
/// meaningless. Every function may be called on several threads at once.
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

/// Limits of the arguments.
enum {
    WHIRL_SIGNALS_MAX = 1000000000,        ///< largest count of numbers of an array
    WHIRL_SIGNALS_HIGHEST_ORDER = 9,       ///< highest order of the interpolating polynomials
    WHIRL_SIGNALS_MIN_REVOLUTIONS = 4,     ///< fewest revolutions of a spectrum
    WHIRL_SIGNALS_MAX_RECURRENCES = 20000, ///< most points for whirl_signals_recurrence
    WHIRL_SIGNALS_MAX_TRACKED = 16         ///< most orders that whirl_signals_vold_kalman solves together
};

/// Finds levels for whirl_signals_pulses: the threshold halfway between the lowest and the highest voltage [count], the
/// hysteresis a fifth of their difference. WHIRL_BAD_INPUT if the voltage is constant.
whirl_status whirl_signals_threshold(const double *voltage, size_t count, double *threshold, double *hysteresis);

/// Finds the instants at which the voltage [count] rises (or, `rising` false, falls) through the threshold, by linear
/// interpolation between the two samples. Before each pulse, also the first, the voltage must have been beyond the
/// threshold by more than the hysteresis >= 0. `time` [count] grows. `instants` has room for count/2 + 1; *pulses of
/// them are written, which may be 0.
whirl_status whirl_signals_pulses(const double *time, const double *voltage, size_t count, double threshold,
                                  double hysteresis, bool rising, double *instants, size_t *pulses);

/// Computes the mean speed between pulses, rad per unit of time: speed [pulses - 1]. Here and in all functions below,
/// WHIRL_BAD_INPUT for fewer than 2 pulses and for instants that do not grow.
whirl_status whirl_signals_speed(const double *instants, size_t pulses, double *speed);

/// Takes the Poincare section: each channel at each pulse, or at the angle `phase` after it, 0 <= phase < 2 pi, if the
/// next pulse was recorded. Between pulses the angle is a monotone cubic of time (Fritsch and Carlson 1980) with the
/// slopes of parabolas through three pulses; a constant acceleration then follows Fyfe and Munck (1997). Signals are
/// interpolated by polynomials of odd order, 1 (the straight line) to WHIRL_SIGNALS_HIGHEST_ORDER, through the order +
/// 1 samples around an instant. At the instant of a sample the result is that sample. `section` has room for
/// [pulses][channels], of which [*points] are written. Pulses lie within the samples, whose time [count] grows.
whirl_status whirl_signals_section(const double *time, const double *values, size_t count, size_t channels,
                                   const double *instants, size_t pulses, double phase, int order, double *section,
                                   size_t *points);

/// Finds the samples per revolution that lose no sample of the record: the largest number of samples between two
/// neighbouring pulses, plus one if that is odd; at least 8.
whirl_status whirl_signals_samples(const double *time, size_t count, const double *instants, size_t pulses,
                                   size_t *samples);

/// Resamples at equal angles between the pulses (order tracking, Fyfe and Munck 1997), interpolated as in
/// whirl_signals_section. Sample j of a revolution is at the angle 2 pi (j + 1)/samples after its pulse, so that the
/// last one is at the next pulse, as in the waveforms of results. resampled [channels][(pulses - 1) samples]. Orders
/// above samples/2 alias to lower ones, as in any sampling: see whirl_signals_samples. WHIRL_BAD_INPUT for fewer than 3
/// samples.
whirl_status whirl_signals_resample(const double *time, const double *values, size_t count, size_t channels,
                                    const double *instants, size_t pulses, size_t samples, int order,
                                    double *resampled);

/// Tracks orders over the turns of a record: the complex amplitude a of the part Re a e^(i order angle) in every block
/// of `revolutions` turns, by the exact integral 2/angle int z e^(-i order angle) d angle. Other multiples of
/// 1/revolutions do not leak into it. For order 0 it is the mean, with imaginary part 0.
/// - `resampled` [channels][turns samples]: samples at equal angles of whirl_signals_resample.
/// - `orders` [count], 0 or multiples of 1/revolutions, below samples/2.
/// - `vectors` [channels][count][turns/revolutions][2], real and imaginary part, zero to peak: a peak lags behind the
///   pulse by -arg a. Turns at the end that make no full block are left out.
whirl_status whirl_signals_track(const double *resampled, size_t channels, size_t turns, size_t samples,
                                 const double *orders, size_t count, size_t revolutions, double *vectors);

/// Computes displacements x, y [count] from the readings u, v [count] of two probes in one plane, at the angles `first`
/// and `second` from the x axis in the sense of rotation: u = x cos first + y sin first, v likewise. WHIRL_BAD_INPUT if
/// the probes are within 0.01 rad of one line.
whirl_status whirl_signals_axes(const double *u, const double *v, size_t count, double first, double second, double *x,
                                double *y);

/// Finds the angle of the shaft at `time` [count], rad from the first pulse, by the cubic of whirl_signals_section: the
/// inverse of whirl_signals_resample. WHIRL_BAD_INPUT for a time outside of the pulses.
whirl_status whirl_signals_angle(const double *instants, size_t pulses, const double *time, size_t count,
                                 double *angle);

/// Finds the weight r of a Vold-Kalman filter with 1 or 2 `poles` whose gain is -3 dB at the edges of a full width
/// `bandwidth`: the gain at a distance f from the order is 1/(1 + r^2 (2 sin(pi f/rate))^(2 poles)) (Tuma 2005). The
/// bandwidth has the unit of the `rate` of samples. WHIRL_BAD_INPUT for a bandwidth that is not above 0 and below the
/// rate, or so narrow that rounding would cost more than seven digits.
whirl_status whirl_signals_vold_kalman_weight(double bandwidth, double rate, int poles, double *weight);

/// Tracks orders by a Vold-Kalman filter of the second generation (Vold and Leuridan 1993): complex amplitudes a_k that
/// vary slowly, with values = Re sum_k a_k e^(i phase_k), for all orders together. Orders that cross are separated if
/// their distance is wider than the band in most of the record.
/// - `values` [count] at a constant `rate` of samples per unit of time.
/// - `phases` [tracked][count], rad: an order times the angle of its shaft at each sample, or any phase that is known,
///   2 pi f t for a fixed frequency. Slow oscillations of the shaft's angle belong into it.
/// - `bandwidths` [tracked], full widths at -3 dB in the unit of `rate`.
/// - `poles` 1 (amplitudes nearly constant) or 2 (nearly straight lines; flatter in its band, steeper outside).
/// - `amplitudes` [tracked][count][2], real and imaginary part of a_k, zero to peak: a peak lags behind the angle 0 by
///   -arg a_k.
///
/// Amplitudes are worse within about 1/bandwidth of the ends, where samples are on one side only: the error by noise
/// grows to 1.4 (1 pole) or 2 times (2 poles) that in the middle, and with 1 pole slopes are lost. They are wrong, up
/// to twice too large, while a frequency is below its bandwidth: the part and its mirror image at the negative
/// frequency are then one. A mean that is large next to the amplitudes leaks into slow orders: subtract it.
/// WHIRL_BAD_INPUT for a phase that turns by pi or more between samples (half the rate is the highest frequency), for
/// one that is never faster than its bandwidth, for orders that cannot be separated, and for count tracked^2 (poles +
/// 1) above 1e8, which would need 1.6 GB.
whirl_status whirl_signals_vold_kalman(const double *values, size_t count, double rate, const double *phases,
                                       size_t tracked, const double *bandwidths, int poles, double *amplitudes);

/// Columns of a row of a spectrum, and most lines of it.
enum { WHIRL_SIGNALS_COLUMNS = 5, WHIRL_SIGNALS_LINES = 16 };

/// Returns the number of orders that whirl_signals_spectrum gives: 0, 1/revolutions, 2/revolutions ... up to the
/// highest order and below half the samples of a revolution. 0 if the count is not a whole number of revolutions.
size_t whirl_signals_orders(size_t count, size_t samples, double highest_order);

/// Computes spectra of two displacements [count] at equal angles, `samples` a revolution (whirl_signals_resample), and
/// their full spectrum, which separates forward from backward whirl (Goldman and Muszynska 1999), as the analysis
/// `spectrum` does for a computed motion. Hann window over all revolutions, mean removed.
/// - `orders` [whirl_signals_orders][5]: order, amplitudes of x, of y, of the circular motions with the rotation and
///   against it. May be NULL.
/// - `lines` [WHIRL_SIGNALS_LINES][5]: the same columns for the sinusoids found, also between the orders of the
///   resolution, largest first; *line_count of them.
/// - `synchronous` [2][4]: amplitudes of the 1X part of x, y, forward, backward; then the degrees by which they lag
///   behind the pulse, as in whirl_synchronous, NaN where there is no amplitude.
///
/// `y` may be NULL: one signal, x. WHIRL_BAD_INPUT if the count is not a whole number of revolutions, for fewer than
/// WHIRL_SIGNALS_MIN_REVOLUTIONS of them or fewer than 3 samples each, and for a highest order that is not above 0.
whirl_status whirl_signals_spectrum(const double *x, const double *y, size_t count, size_t samples,
                                    double highest_order, double *orders, double *lines, size_t *line_count,
                                    double *synchronous);

/// Returns the frequencies that whirl_signals_spectrogram gives: j/window times the rate, below half the rate.
size_t whirl_signals_frequencies(size_t window);

/// Computes spectra of windows over time of samples at a constant rate: Hann window, its weighted mean removed. `rows`
/// [(count - window)/step + 1][whirl_signals_frequencies][4]: amplitudes, zero to peak, of x, of y, and of the circular
/// motions with the rotation and against it. Row i begins at sample i step. `y` may be NULL: one signal, x.
/// whirl_signals_sweep gives the loss of amplitude of an order whose frequency changes. WHIRL_BAD_INPUT for a window of
/// fewer than 8 samples or more than there are, and for a step of 0.
whirl_status whirl_signals_spectrogram(const double *x, const double *y, size_t count, size_t window, size_t step,
                                       double *rows);

/// Computes the share of a sinusoid's amplitude that remains in the spectrum of a Hann window w of the duration T, at
/// the frequency in the middle of the window, if the frequency changes by `rate` per unit of time. The share is |int w
/// e^(i pi rate t^2) dt|/int w dt, a function of `sweep`, rate T^2. For order k of a shaft the rate is k times that of
/// the turns. WHIRL_BAD_INPUT for |sweep| above 1e6.
whirl_status whirl_signals_sweep(double sweep, double *kept);

/// Computes the size of a motion: half the diagonal of the bounding box of the channels. The functions below compare
/// distances with it. Pass all samples, not a section: the section of a periodic motion has only the size of its noise.
whirl_status whirl_signals_size(const double *values, size_t count, size_t channels, double *size);

/// Computes K of the 0-1 test for chaos (Gottwald and Melbourne 2009) over the last 4000 points: near 1 in chaos, near
/// 0 (also below) for regular motion; the median over 25 frequencies, as for computed motions. NaN if no coordinate
/// spreads by more than 1e-6 of `size` > 0. WHIRL_BAD_INPUT for fewer than 100 points.
whirl_status whirl_signals_zero_one(const double *points, size_t count, size_t dimension, double size, double *k);

/// Finds the period in revolutions: the smallest *period up to 64 (128 if three such periods were recorded) whose
/// largest return distance |z(n + period) - z(n)|, over `size` > 0, is *distance <= tolerance. If there is none: the
/// period up to 64 with the smallest distance, which then exceeds the tolerance. Uses the last 20000 points. The
/// tolerance >= 0 must exceed the noise. WHIRL_BAD_INPUT for fewer than 5 points.
whirl_status whirl_signals_returns(const double *points, size_t count, size_t dimension, double size, double tolerance,
                                   int *period, double *distance);

/// Quantifies recurrence (Marwan, Romano, Thiel and Kurths 2007, section 3.5). Points i and j recur if their Euclidean
/// distance is at most `radius` >= 0, in the unit of the points. A point with itself is not a recurrence, but part of a
/// vertical line. WHIRL_BAD_INPUT for fewer than 2 points, more than WHIRL_SIGNALS_MAX_RECURRENCES (the work grows with
/// their square), and a `shortest` line below 2.
/// - *rate: share of all pairs that recur.
/// - *determinism: share of the recurring pairs in diagonal lines of `shortest` points or more; NaN without any.
/// - *laminarity: share of the recurring points in vertical lines of `shortest` points or more.
/// - *longest: points of the longest diagonal line other than the main diagonal.
whirl_status whirl_signals_recurrence(const double *points, size_t count, size_t dimension, double radius,
                                      size_t shortest, double *rate, double *determinism, double *laminarity,
                                      size_t *longest);

/// Numbers of a row of whirl_signals_rain_flow.
enum { WHIRL_SIGNALS_CYCLE = 3 };

/// Counts the cycles of a load history [count] by rain flow, three points (ASTM E1049-85, 5.4.4): `cycles` [*rows][3],
/// in the order in which they close: range, mean, and 1 for a whole cycle or 0.5 for a half one. Ranges that are open
/// at the end are half cycles. `cycles` has room for [count][3]; a constant history has no rows.
whirl_status whirl_signals_rain_flow(const double *values, size_t count, double *cycles, size_t *rows);

/// Sums the damage sum n/N of cycles [rows][3] of whirl_signals_rain_flow (Palmgren 1924, Miner 1945); failure is
/// expected at 1. N is the number of cycles to failure at a range, whatever the mean, by an S-N curve of ranges (twice
/// the amplitudes):
/// - one point and a `slope` m > 0: N = lives[0] (ranges[0]/range)^m;
/// - several points, of falling `ranges` and growing `lives`: straight lines over logarithms; the last one goes on to
///   smaller ranges. `slope` has no effect.
///
/// Ranges up to `endurance` do no damage; 0: no such limit. WHIRL_BAD_INPUT for a range above the first of several
/// points, where the curve says nothing.
whirl_status whirl_signals_damage(const double *cycles, size_t rows, const double *ranges, const double *lives,
                                  size_t points, double slope, double endurance, double *damage);

#ifdef __cplusplus
}
#endif
#endif
