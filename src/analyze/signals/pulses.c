// Pulses of a keyphasor, one a turn of the shaft.
#include <math.h>

#include "signal_check.h"
#include "two_pi.h"

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
