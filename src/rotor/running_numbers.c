// Functions of a speed by which numbers of a machine are represented: sums of powers, and splines.
#include <math.h>
#include <string.h>

#include "matrix.h"
#include "running_rotor.h"

/// Largest error of a number that counts as a sum of powers, divided by the number's largest value.
static const double power_error = 2e-12;

/// Solves for the factors out [count] of the powers `of` [count] of w [count] whose sum is y [count]. Returns false if
/// the equations are singular.
static bool running_fit_powers(size_t count, const int *of, const double *w, const double *y, double *out) {
    double a[POWERS * POWERS];
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; j < count; j++) a[i * count + j] = pow(w[i], of[j]);
    memcpy(out, y, count * sizeof *out);
    return matrix_solve(count, a, 1, out);
}

bool running_find_powers(size_t speeds, const double *w, const double *y, double power[POWERS]) {
    double largest = 0.0;
    for (size_t i = 0; i < speeds; i++) largest = fmax(largest, fabs(y[i]));
    for (size_t count = 1; count <= POWERS; count++)
        for (unsigned set = 1; set < 1u << POWERS; set++) {
            int of[POWERS];
            double found[POWERS], at[POWERS], value[POWERS];
            size_t size = 0;
            bool holds;
            for (int k = 0; k < POWERS; k++)
                if (set >> k & 1) of[size++] = k + LOWEST_POWER;
            if (size != count) continue;
            // Fit at about every second speed, over the whole range. The other speeds check the fit.
            for (size_t i = 0; i < count; i++) {
                const size_t pick = count == 1 ? 0 : i * (speeds - 1) / (count - 1);
                at[i] = w[pick];
                value[i] = y[pick];
            }
            holds = running_fit_powers(count, of, at, value, found);
            for (size_t i = 0; i < speeds && holds; i++) {
                double sum = 0.0;
                for (size_t j = 0; j < count; j++) sum += found[j] * pow(w[i], of[j]);
                holds = fabs(sum - y[i]) <= power_error * largest;
            }
            if (!holds) continue;
            memset(power, 0, POWERS * sizeof *power);
            for (size_t j = 0; j < count; j++) power[of[j] - LOWEST_POWER] = found[j];
            return true;
        }
    return false;
}

/// Computes the second derivatives of the cubic spline through y [SPLINE_NODES] at equal distances h, with parabolas at
/// its ends.
static void running_spline_bend(double h, const double *y, double *curvature) {
    double diagonal[SPLINE_NODES], right[SPLINE_NODES];
    const size_t last = SPLINE_NODES - 1;
    for (size_t i = 1; i < last; i++) {
        diagonal[i] = i == 1 || i + 1 == last ? 5.0 : 4.0;
        right[i] = 6.0 * (y[i - 1] - 2.0 * y[i] + y[i + 1]) / (h * h);
    }
    for (size_t i = 2; i < last; i++) {
        const double share = 1.0 / diagonal[i - 1];
        diagonal[i] -= share;
        right[i] -= share * right[i - 1];
    }
    curvature[last - 1] = right[last - 1] / diagonal[last - 1];
    for (size_t i = last - 1; i-- > 1;) curvature[i] = (right[i] - curvature[i + 1]) / diagonal[i];
    curvature[0] = curvature[1];
    curvature[last] = curvature[last - 1];
}

/// Returns the spline of a number, which is that of w^lift times the number, at a speed.
static double running_spline_at(const number_of_speed *of, double lowest, double distance, double w) {
    const double place = (w - lowest) / distance;
    const double bounded = fmin(fmax(place, 0.0), SPLINE_NODES - 1.0);
    const size_t i = bounded >= SPLINE_NODES - 1 ? SPLINE_NODES - 2 : (size_t)bounded;
    const double b = bounded - (double)i, a = 1.0 - b, h = distance;
    return a * of->value[i] + b * of->value[i + 1] +
           ((a * a * a - a) * of->curvature[i] + (b * b * b - b) * of->curvature[i + 1]) * h * h / 6.0;
}

/// Returns w^lift.
static double running_spline_grown(int lift, double w) {
    return lift == 0 ? 1.0 : lift == 1 ? w : w * w;
}

double running_number_at(const number_of_speed *of, double lowest, double distance, double w) {
    const double *c = of->power;
    if (of->value) return running_spline_at(of, lowest, distance, w) / running_spline_grown(of->lift, w);
    return ((c[0] / w + c[1]) / w + c[2]) + w * (c[3] + w * c[4]);
}

/// Returns the lift of a number: the power of w by which it is multiplied before the spline is fitted. The lift follows
/// from the values at the two lowest speeds, w [2]: towards low speeds stiffnesses grow as 1/w^2, dampings as 1/w, and
/// ratios do not grow. Below its first node a spline keeps its value, so that with another lift a number would vanish
/// or grow without limit there.
static int running_spline_lift(const double *w, double lowest, double next) {
    const double growth = log(fabs(lowest / next)) / log(w[1] / w[0]);
    return growth > 1.5 ? 2 : growth > 0.5 ? 1 : 0; // 0 also where it is not a number
}

double running_fit_spline(number_of_speed *own, double lowest, double distance, const double *w, const double *y,
                          size_t stride, double divisor, double **next) {
    double lifted[SPLINE_SPEEDS], largest = 0.0, error = 0.0;
    own->value = *next;
    own->curvature = *next + SPLINE_NODES;
    *next += SPLINE_NUMBERS;
    own->lift = running_spline_lift(w, y[own->index], y[stride + own->index]);
    for (size_t i = 0; i < SPLINE_SPEEDS; i++) {
        lifted[i] = running_spline_grown(own->lift, w[i]) * y[i * stride + own->index] / divisor;
        largest = fmax(largest, fabs(lifted[i]));
    }
    for (size_t i = 0; i < SPLINE_NODES; i++) own->value[i] = lifted[2 * i];
    running_spline_bend(distance, own->value, own->curvature);
    for (size_t i = 1; i < SPLINE_SPEEDS; i += 2)
        error = fmax(error, fabs(running_spline_at(own, lowest, distance, w[i]) - lifted[i]) / largest);
    return error;
}

void running_sample_speeds(double lowest, double highest, double *w) {
    static const double share[POWER_SPEEDS] = {1.0, 0.91, 0.78, 0.65, 0.55, 0.42, 0.33, 0.24, 0.15, 0.08, 0.0};
    const double low = fmax(lowest, 0.17 * highest);
    for (size_t i = 0; i < POWER_SPEEDS; i++) w[i] = low + share[i] * (highest - low);
}
