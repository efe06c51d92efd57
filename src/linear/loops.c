// The sensitivity of control loops, S(i w) = 1 + c (i w - J)^-1 b. b is the slope of the state per unit of a signal
// that is added to the sensor's signal; c is the sensor's signal per unit of the state.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"
#include "matrix_balance.h"
#include "mean.h"
#include "whirl/engine/linear.h"

/// A closed loop, and workspace for its equations. In its coordinates the Jacobian is upper Hessenberg, so that one
/// frequency takes n^2 operations (Laub 1981).
typedef struct closed_loop {
    size_t n;
    const double *jacobian; ///< [n][n]
    double *input, *sensed; ///< [n]
    double *matrix, *side;  ///< [n][n][2], [n][2]
} closed_loop;

/// Subtracts factor times b from a, complex numbers [count][2].
static void subtract(double *a, const double *factor, const double *b, size_t count) {
    for (size_t k = 0; k < count; k++) {
        a[2 * k] -= factor[0] * b[2 * k] - factor[1] * b[2 * k + 1];
        a[2 * k + 1] -= factor[0] * b[2 * k + 1] + factor[1] * b[2 * k];
    }
}

/// Divides a by b, which is not 0.
static void divide(const double *a, const double *b, double *out) {
    const double square = b[0] * b[0] + b[1] * b[1];
    const double real = (a[0] * b[0] + a[1] * b[1]) / square;
    out[1] = (a[1] * b[0] - a[0] * b[1]) / square;
    out[0] = real;
}

/// Solves matrix x = side by elimination with exchange of neighbouring rows; side becomes x. Returns false where a
/// pivot vanishes.
static bool solve_hessenberg(size_t n, double *matrix, double *side) {
    // Eliminate the subdiagonal; exchange a row with the next one if that has the larger pivot.
    for (size_t i = 0; i < n; i++) {
        double *own = matrix + 2 * (i * n + i), *below = own + 2 * n, factor[2];
        if (i + 1 < n && hypot(below[0], below[1]) > hypot(own[0], own[1])) {
            for (size_t k = 0; k < 2 * (n - i); k++) {
                const double moved = own[k];
                own[k] = below[k];
                below[k] = moved;
            }
            for (size_t c = 0; c < 2; c++) {
                const double moved = side[2 * i + c];
                side[2 * i + c] = side[2 * i + 2 + c];
                side[2 * i + 2 + c] = moved;
            }
        }
        if (own[0] == 0.0 && own[1] == 0.0) return false;
        if (i + 1 == n || (below[0] == 0.0 && below[1] == 0.0)) continue;
        divide(below, own, factor);
        subtract(below, factor, own, n - i);
        subtract(side + 2 * i + 2, factor, side + 2 * i, 1);
    }
    // Back substitution.
    for (size_t i = n; i-- > 0;) {
        const double *row = matrix + 2 * i * n;
        for (size_t k = i + 1; k < n; k++) subtract(side + 2 * i, row + 2 * k, side + 2 * k, 1);
        divide(side + 2 * i, row + 2 * i, side + 2 * i);
    }
    return true;
}

/// Returns the modulus of S at w; NaN if the equations are singular.
static double sensitivity(const closed_loop *of, double w) {
    const size_t n = of->n;
    double real = 1.0, imaginary = 0.0;
    for (size_t i = 0; i < n; i++) {
        for (size_t k = i > 0 ? i - 1 : 0; k < n; k++) {
            of->matrix[2 * (i * n + k)] = -of->jacobian[i * n + k];
            of->matrix[2 * (i * n + k) + 1] = i == k ? w : 0.0;
        }
        of->side[2 * i] = of->input[i];
        of->side[2 * i + 1] = 0.0;
    }
    if (!solve_hessenberg(n, of->matrix, of->side)) return (double)NAN;
    for (size_t i = 0; i < n; i++) {
        real += of->sensed[i] * of->side[2 * i];
        imaginary += of->sensed[i] * of->side[2 * i + 1];
    }
    return hypot(real, imaginary);
}

/// Finds the largest value between two frequencies by golden section, if a middle one exceeds both ends.
static void sharpen(const closed_loop *of, double low, double high, whirl_sensitivity_peak *out) {
    const double golden = 0.6180339887498949;
    double one = high - golden * (high - low), other = low + golden * (high - low);
    double at_one = sensitivity(of, one), at_other = sensitivity(of, other);
    while (high - low > 1e-9 * high) {
        const bool left = at_one > at_other;
        if (left)
            high = other, other = one, at_other = at_one, one = high - golden * (high - low);
        else
            low = one, one = other, at_one = at_other, other = low + golden * (high - low);
        if (left)
            at_one = sensitivity(of, one);
        else
            at_other = sensitivity(of, other);
    }
    const double w = 0.5 * (low + high), peak = sensitivity(of, w);
    if (!(peak > out->peak)) return;
    out->peak = peak;
    out->frequency = w;
}

static int loops_by_size(const void *a, const void *b) {
    const double p = *(const double *)a, q = *(const double *)b;
    return p < q ? -1 : p > q;
}

enum { EVEN = 240, AROUND = 9 };

/// Writes the ascending frequencies at which S is evaluated: evenly over the logarithm, in and around the range of all
/// eigenvalues, and densely around each mode that may cause a peak.
static size_t frequencies(const whirl_modes *modes, double *out) {
    double low = INFINITY, high = 0.0;
    size_t count = 0;
    for (size_t i = 0; i < modes->count + modes->real_count; i++) {
        const bool wave = i < modes->count;
        const whirl_mode *mode = &modes->modes[wave ? i : 0];
        const double size = wave ? hypot(mode->real, mode->imaginary) : fabs(modes->reals[i - modes->count]);
        if (!(size > 0.0)) continue;
        low = fmin(low, size);
        high = fmax(high, size);
        for (int k = 0; wave && !whirl_mode_is_overdamped(mode) && k < AROUND; k++)
            out[count++] = fabs(mode->imaginary + 0.5 * mode->real * (k - AROUND / 2));
    }
    if (!(high > 0.0)) return 0;
    low = fmax(0.1 * low, 1e-8 * high);
    for (int k = 0; k < EVEN; k++) out[count++] = low * pow(10.0 * high / low, k / (EVEN - 1.0));
    qsort(out, count, sizeof *out, loops_by_size);
    return count;
}

static void search(const closed_loop *of, const double *w, size_t count, whirl_sensitivity_peak *out) {
    double before = 0.0, here = count > 0 ? sensitivity(of, w[0]) : 0.0;
    for (size_t i = 0; i < count; i++) {
        const double next = i + 1 < count ? sensitivity(of, w[i + 1]) : 0.0;
        if (here >= before && here >= next && here > 0.9 * out->peak)
            sharpen(of, i > 0 ? w[i - 1] : 0.0, i + 1 < count ? w[i + 1] : w[i], out);
        before = here;
        here = next;
    }
}

/// Writes the transposed matrix [n][n] times the vector [n] to out.
static void turn(size_t n, const double *matrix, const double *vector, double *out) {
    memset(out, 0, n * sizeof *out);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) out[k] += matrix[i * n + k] * vector[i];
}

static whirl_status search_loops(mean_system *m, const whirl_modes *modes, double *numbers,
                                 whirl_sensitivity_peak *out) {
    const size_t n = m->count, d = m->system->dimension;
    // Parts of one allocation.
    double *jacobian = numbers, *turned = jacobian + n * n, *input = turned + n * n, *sensed = input + d;
    double *scale = sensed + d, *own = scale + n, *matrix = own + 2 * n, *side = matrix + 2 * n * n, *w = side + 2 * n;
    const closed_loop of = {n, jacobian, own, own + n, matrix, side};
    const size_t count = frequencies(modes, w);
    // Make the Jacobian a Hessenberg matrix once for all frequencies and loops.
    mean_jacobian(m, modes->rest, jacobian);
    matrix_balance(n, jacobian, scale);
    if (!matrix_hessenberg(n, jacobian, turned))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the sensitivity of %zu coordinates", n);
    // Search each loop, in the coordinates of that matrix.
    for (size_t k = 0; k < m->system->loop_count; k++) {
        const double peak = out->peak;
        m->system->loop(m->system->model, modes->rest, k, input, sensed);
        for (size_t i = 0; i < n; i++) {
            input[i] = input[m->kept[i]] / scale[i]; // rising, so that none is overwritten before it is read
            sensed[i] = sensed[m->kept[i]] * scale[i];
        }
        turn(n, turned, input, of.input);
        turn(n, turned, sensed, of.sensed);
        search(&of, w, count, out);
        if (out->peak > peak) out->loop = k;
    }
    return whirl_ok();
}

whirl_status whirl_loops_peak(const whirl_system *system, const whirl_modes *modes, whirl_sensitivity_peak *out) {
    *out = (whirl_sensitivity_peak){(double)NAN, (double)NAN, 0};
    if (system->loop_count == 0 || modes->period > 0.0) return whirl_ok();
    mean_system mean;
    void *block;
    whirl_status status = mean_begin(&mean, system, &block);
    if (status.code != WHIRL_OK) return status;
    const size_t n = mean.count, d = system->dimension;
    double *numbers = calloc(4 * n * n + 5 * n + 2 * d + EVEN + AROUND * modes->count, sizeof *numbers);
    out->peak = 0.0;
    if (numbers)
        status = search_loops(&mean, modes, numbers, out);
    else
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the sensitivity of %zu coordinates", n);
    if (!(out->peak > 0.0)) out->peak = (double)NAN;
    free(numbers);
    free(block);
    return status;
}
