/// Peaks of responses over the speed, and the separation margins and screening of API 617.
#ifndef WHIRL_RESPONSE_PEAKS_H
#define WHIRL_RESPONSE_PEAKS_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Methods of finding an amplification factor.
typedef enum whirl_amplification_way {
    WHIRL_BY_HALF_POWER, ///< speed/(high - low)
    WHIRL_BY_ONE_SIDE,   ///< speed over twice the distance of the only half-power point
    WHIRL_BY_PHASE_SLOPE ///< half of the speed times the slope of the lag: there is no half-power point
} whirl_amplification_way;

/// A peak of a response over the speed.
typedef struct whirl_response_peak {
    double speed, amplitude;     ///< its maximum, by cubic interpolation
    double low, high;            ///< speeds with 1/sqrt(2) of the amplitude; NaN if it rises again before
    double amplification;        ///< amplification factor
    whirl_amplification_way way; ///< method by which it was found
    double points;               ///< points of the response in the width speed/amplification: few give a rough value
} whirl_response_peak;

/// Finds the peaks of a response [count] at rising speeds, at most `most` of them, by rising speed; returns their
/// number. lags: degrees by which its phase is behind. Ends are not peaks. (Amplification by half power: API 617, API
/// 684; closed form of a damped rotor: docs/theory.md.)
size_t whirl_response_peaks(size_t count, const double *speeds, const double *amplitudes, const double *lags,
                            size_t most, whirl_response_peak *peaks);

/// Returns the maximum of a response [count] at rising speeds from `low` to `high`: at points, at peaks between them
/// and at both ends of that range, by cubic interpolation; NaN if the points do not cover it.
double whirl_response_largest(size_t count, const double *speeds, const double *amplitudes, double low, double high);

/// Returns the critical speed ratio above which a machine with that mean gas density (kg/m3) is in region B of the
/// screening diagram of API 617: 2.5 up to 16.53 kg/m3, from there falling to 2.0 at 60 kg/m3, 0 beyond. The ratio is
/// the speed over the first critical speed on rigid supports. Check the edition that applies.
double whirl_screening_ratio(double density);

/// Returns the separation margin required for a peak of that amplification A, in percent of the lowest (or, `above`,
/// the highest) running speed: 17 (1 - 1/(A - 1.5)), and 10 more above; 0 below A = 2.5. After API 617; check the
/// edition that applies, and its caps.
double whirl_margin_required(double amplification, bool above);

#ifdef __cplusplus
}
#endif
#endif
