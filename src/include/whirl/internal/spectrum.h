/// Spectra of a recorded motion: amplitudes over orders, lines, the synchronous part.
#ifndef WHIRL_SPECTRUM_H
#define WHIRL_SPECTRUM_H

#include <stddef.h>

#include "whirl/engine/record.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Maximum number of lines of a spectrum.
enum { WHIRL_MAX_LINES = 16 };

/// A line of a spectrum. Amplitudes are zero to peak.
typedef struct whirl_line {
    double order;             ///< frequency over the running speed, > 0
    double x, y;              ///< amplitudes of the two coordinates
    double forward, backward; ///< amplitudes of its two circular motions (full spectrum of x + iy)
} whirl_line;

/// The synchronous (1X) part of a motion: of x, of y, and of its circular motions with the rotation (forward) and
/// against it (backward), in this order. Phases count from the mark on the shaft, which is on the x axis at tau = 0, 2
/// pi, ...: an unbalance at angle 0 then points along x. x is amplitude[0] cos(tau - lag[0]), y likewise; forward is
/// the vector at the angle tau - lag[2], backward at -(tau - lag[3]).
typedef struct whirl_synchronous {
    double amplitude[4]; ///< zero to peak
    /// Lag behind the mark in degrees, 0 <= ... < 360, of the peak, or of the vector's passage through the x axis; NaN
    /// for an amplitude below 1e-12 of the largest displacement.
    double lag[4];
} whirl_synchronous;

/// Spectra of one probe over the record: Hann window over all samples, mean removed, resolution 1/record orders.
typedef struct whirl_spectrum {
    size_t count;                       ///< orders 0 .. highest
    double resolution;                  ///< orders between two bins
    double *x, *y, *forward, *backward; ///< [count] amplitudes, zero to peak; one block, freed by whirl_spectrum_free
    size_t line_count;                  ///< number of lines
    whirl_line lines[WHIRL_MAX_LINES];  ///< interpolated peaks, largest first
    double line_share;                  ///< share of the lines in the variance of the motion; NaN if nothing moves
    whirl_synchronous synchronous;      ///< NaN for fewer than 3 samples per revolution
} whirl_spectrum;

/// Computes the spectrum of probe `probe` up to `highest_order`; from probe_count on: of axial displacements, as x.
/// Searches lines above that order, too, if the spectrum up to it holds less than 99 % of the motion's mean square.
/// WHIRL_BAD_INPUT if the record has no waveform.
whirl_status whirl_spectrum_new(const whirl_record *record, size_t probe, double highest_order,
                                whirl_spectrum **spectrum);

/// Frees a spectrum; accepts NULL.
void whirl_spectrum_free(whirl_spectrum *spectrum);

#ifdef __cplusplus
}
#endif
#endif
