// Amplitude and phase once a revolution. With x = Re(X e^(i tau)) and y likewise, x + iy is the circular motion
// F e^(i tau) with the rotation and B e^(-i tau) against it, F = (X + iY)/2 and B = conj(X - iY)/2.
#include "synchronous.h"

#include <complex.h>
#include <math.h>

static const double pi = 3.141592653589793238463;

/// Degrees by which a sinusoid Re(z e^(i tau)) peaks after the mark, 0 <= ... < 360.
static double lag_of(double complex z) {
    const double lag = -carg(z) * 180.0 / pi, turned = lag < 0.0 ? lag + 360.0 : lag;
    return turned >= 360.0 - 1e-9 ? 0.0 : turned; // no lag but for rounding
}

whirl_synchronous synchronous_none(void) {
    return (whirl_synchronous){.lag = {NAN, NAN, NAN, NAN}};
}

whirl_synchronous synchronous_part(const wave_transform *wave, size_t samples_per_revolution, double size) {
    const size_t revolutions = wave_transform_count(wave) / samples_per_revolution;
    whirl_synchronous found = synchronous_none();
    if (samples_per_revolution < 3) {
        for (int i = 0; i < 4; i++) found.amplitude[i] = NAN; // so few do not tell 1X from the mean
        return found;
    }
    const wave_amplitudes at = wave_transform_at(wave, (double)revolutions);
    const double complex step = cexp(-2.0 * pi * I / (double)samples_per_revolution);
    const double complex x = 2.0 * at.x * step, y = 2.0 * at.y * step;
    // Backward, the motion stands at the angle -tau + arg B: it passes the x axis arg B after the mark.
    const double complex parts[4] = {x, y, 0.5 * (x + I * y), 0.5 * (x - I * y)};
    for (int i = 0; i < 4; i++) {
        found.amplitude[i] = cabs(parts[i]);
        if (found.amplitude[i] > 1e-12 * size) found.lag[i] = lag_of(parts[i]);
    }
    return found;
}
