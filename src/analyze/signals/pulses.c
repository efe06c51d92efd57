// Amplitude and phase once a revolution. With x = Re(X e^(i tau)) and y likewise, x + iy is the sum of the forward
// motion F e^(i tau) and the backward one B e^(-i tau), F = (X + iY)/2 and B = conj(X - iY)/2.
#include <complex.h>
#include <math.h>

#include "signal_check.h"
#include "synchronous.h"
#include "transform.h"
#include "two_pi.h"

static const double pi = 3.141592653589793238463;

/// Degrees by which a sinusoid Re(z e^(i tau)) peaks after the mark, 0 <= ... < 360.
static double lag_of(double complex z) {
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
        if (found.amplitude[i] > 1e-12 * size) found.lag[i] = lag_of(parts[i]);
    }
    return found;
}

// ---------------------------------------------------------------- pulses
// Pulses of a keyphasor, one a turn of the shaft.

whirl_status whirl_signals_threshold(const double *voltage, size_t count, double *threshold, double *hysteresis) {
    const whirl_status status = signal_check_channels(voltage, count, 1, 2);
    if (status.code != WHIRL_OK) return status;
    double low = voltage[0], high = voltage[0];
    for (size_t i = 1; i < count; i++) {
        low = fmin(low, voltage[i]);
        high = fmax(high, voltage[i]);
    }
    if (!(high > low))
        return whirl_fail(WHIRL_BAD_INPUT, "the keyphasor is %g all the time, expected a voltage with pulses", low);
    *threshold = 0.5 * (low + high);
    *hysteresis = 0.2 * (high - low);
    return whirl_ok();
}

whirl_status whirl_signals_pulses(const double *time, const double *voltage, size_t count, double threshold,
                                  double hysteresis, bool rising, double *instants, size_t *pulses) {
    *pulses = 0;
    whirl_status status = signal_check_time(time, count);
    if (status.code == WHIRL_OK) status = signal_check_channels(voltage, count, 1, 2);
    if (status.code != WHIRL_OK) return status;
    if (!(fabs(threshold) <= 1e100)) return whirl_fail(WHIRL_BAD_INPUT, "the threshold is %g", threshold);
    if (!(hysteresis >= 0.0 && hysteresis <= 1e100))
        return whirl_fail(WHIRL_BAD_INPUT, "the hysteresis is %g, expected 0 or more", hysteresis);
    const double sense = rising ? 1.0 : -1.0;
    bool armed = false; // the voltage has gone back far enough
    for (size_t i = 0; i < count; i++) {
        const double above = sense * (voltage[i] - threshold);
        if (armed && above >= 0.0) {
            const double before = sense * (voltage[i - 1] - threshold), share = -before / (above - before);
            instants[(*pulses)++] = time[i - 1] + share * (time[i] - time[i - 1]);
            armed = false;
        }
        armed = armed || above < -hysteresis;
    }
    return whirl_ok();
}

whirl_status whirl_signals_speed(const double *instants, size_t pulses, double *speed) {
    const whirl_status status = signal_check_pulses(instants, pulses);
    if (status.code != WHIRL_OK) return status;
    for (size_t k = 0; k + 1 < pulses; k++) speed[k] = two_pi / (instants[k + 1] - instants[k]);
    return whirl_ok();
}
