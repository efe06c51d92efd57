// Chooses positions and texts of axis ticks; they are the same for all renderers.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figure_build.h"

double tick_step(double width, int most) {
    const double least = width / most;
    if (!(least > 0.0) || !isfinite(least)) return 1.0;
    const double power = pow(10.0, floor(log10(least))), lead = least / power;
    return (lead <= 1.0 ? 1.0 : lead <= 2.0 ? 2.0 : lead <= 5.0 ? 5.0 : 10.0) * power;
}

/// Writes a power of ten, "10⁻⁵".
static void power_text(int power, char *text, size_t size) {
    static const char *const digits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                         "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    char plain[16];
    snprintf(plain, sizeof plain, "%d", abs(power));
    size_t used = (size_t)snprintf(text, size, "10%s", power < 0 ? "\u207b" : "");
    for (const char *at = plain; *at && used < size; at++)
        used += (size_t)snprintf(text + used, size - used, "%s", digits[*at - '0']);
}

/// Writes a number with a typographic minus sign; large and small numbers as powers of ten.
static void number_as_tick(double value, double step, char *text, size_t size) {
    const double size_of = fmax(fabs(value), step);
    const int decimals = step > 0.0 ? (int)fmax(0.0, -floor(log10(step) + 1e-9)) : 0;
    if (fabs(value) < 1e-6 * step) {
        snprintf(text, size, "0");
    } else if (size_of >= 1e5 || size_of < 1e-4) {
        char power[32];
        const int own = (int)floor(log10(fabs(value)) + 1e-12);
        power_text(own, power, sizeof power);
        snprintf(text, size, "%s%.4g\u00b7%s", value < 0.0 ? "\u2212" : "", fabs(value) / pow(10.0, own), power);
    } else {
        snprintf(text, size, "%s%.*f", value < 0.0 ? "\u2212" : "", decimals < 12 ? decimals : 12, fabs(value));
    }
}

/// Returns the step for at most `most` ticks; a smaller one if fewer than three ticks would be on the axis.
static double even_step(const whirl_axis *axis, int most) {
    const double width = axis->high - axis->low;
    for (double step = tick_step(width, most);; step = tick_step(width, ++most))
        if (floor(axis->high / step + 1e-9) - ceil(axis->low / step - 1e-9) >= 2.0 || most > 6) return step;
}

static void fill_even(whirl_figure *figure, whirl_axis *axis, double step) {
    enum { MAX_TICKS = 40 };
    char text[64];
    const double first = ceil(axis->low / step - 1e-9);
    // No ticks beyond 1e9 steps from 0, where their texts would be equal.
    for (int k = 0; k < MAX_TICKS && fabs(first) < 1e9 && (first + k) * step <= axis->high + 1e-9 * step; k++) {
        const double at = (first + k) * step;
        if (!isfinite(at)) return;
        number_as_tick(at, step, text, sizeof text);
        axis_tick(figure, axis, at, text);
    }
}

static void log_text(double value, int power, int digit, char *text, size_t size) {
    if (abs(power) <= 3) {
        snprintf(text, size, "%.10g", value);
        return;
    }
    char own[32];
    power_text(power, own, sizeof own);
    if (digit == 1)
        snprintf(text, size, "%s", own);
    else
        snprintf(text, size, "%d\u00b7%s", digit, own);
}

/// Adds ticks to a logarithmic axis: powers of ten, also 2 and 5 times these if there are few, even steps if there are
/// hardly any.
static void fill_powers(whirl_figure *figure, whirl_axis *axis, int most) {
    const int first = (int)floor(log10(axis->low)), last = (int)ceil(log10(axis->high));
    const int step = last - first > most ? (last - first + most - 1) / most : 1;
    const bool all = 3 * (last - first) <= most + 2;
    char text[64];
    if (axis->high < 5.0 * axis->low) {
        fill_even(figure, axis, even_step(axis, most > 4 ? 4 : most));
        return;
    }
    for (int k = first; k <= last; k++)
        for (int digit = 1; digit < 10; digit++) {
            const double at = digit * pow(10.0, k);
            const bool named = digit == 1 ? (k - first) % step == 0 : all && (digit == 2 || digit == 5);
            if (!named || !isfinite(at) || at < axis->low * (1.0 - 1e-9) || at > axis->high * (1.0 + 1e-9)) continue;
            log_text(at, k, digit, text, sizeof text);
            axis_tick(figure, axis, at, text);
        }
}

void axis_fill_ticks(whirl_figure *figure, whirl_axis *axis, int most) {
    if (axis->tick_count > 0) return;
    if (axis->logarithmic)
        fill_powers(figure, axis, most);
    else
        fill_even(figure, axis, even_step(axis, most));
}
