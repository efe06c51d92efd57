// Amplitude and phase once a revolution. With x = Re(X e^(i tau)) and y likewise, x + iy is the sum of the forward
// motion F e^(i tau) and the backward one B e^(-i tau), F = (X + iY)/2 and B = conj(X - iY)/2.
#include <complex.h>
#include <math.h>

#include "synchronous.h"
#include "transform.h"

static const double pi = 3.141592653589793238463;

/// Degrees by which a sinusoid Re(z e^(i tau)) peaks after the mark, 0 <= ... < 360.
static double synchronous_lag(double complex z) {
    const double lag = -carg(z) * 180.0 / pi, turned = lag < 0.0 ? lag + 360.0 : lag;
    return turned >= 360.0 - 1e-9 ? 0.0 : turned; // no lag within rounding
}

whirl_synchronous synchronous_none(void) {
    return (whirl_synchronous){.lag = {NAN, NAN, NAN, NAN}};
}

whirl_synchronous synchronous_part(const wave_transform *wave, size_t samples_per_revolution, double size) {
    const size_t revolutions = wave_transform_count(wave) / samples_per_revolution;
    whirl_synchronous found = synchronous_none();
    if (samples_per_revolution < 3) {
        for (int i = 0; i < 4; i++) found.amplitude[i] = NAN; // too few to separate 1X from the mean
        return found;
    }
    const wave_amplitudes at = wave_transform_at(wave, (double)revolutions);
    const double complex step = cexp(-2.0 * pi * I / (double)samples_per_revolution);
    return synchronous_of(2.0 * at.x * step, 2.0 * at.y * step, size);
}

whirl_synchronous synchronous_of(double complex x, double complex y, double size) {
    whirl_synchronous found = synchronous_none();
    // Backward, the motion is at the angle -tau + arg B: it passes the x axis arg B after the mark.
    const double complex parts[4] = {x, y, 0.5 * (x + I * y), 0.5 * (x - I * y)};
    for (int i = 0; i < 4; i++) {
        found.amplitude[i] = cabs(parts[i]);
        if (found.amplitude[i] > 1e-12 * size) found.lag[i] = synchronous_lag(parts[i]);
    }
    return found;
}
