// Modes: eigenvalues of the Jacobian at the equilibrium, or Floquet exponents of a periodic motion.
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "linear_parts.h"
#include "matrix.h"
#include "numerics.h"

/// Eigenvalues below this part of the largest are zero but for rounding: a free motion's pair is off by its root.
static const double zero_part = 1e-7;

/// An eigenvalue of the matrix, as an exponent, and its place.
typedef struct root {
    double real, imaginary;
    size_t place;
} root;

// ---------------------------------------------------------------- sorting out

static int by_imaginary(const void *a, const void *b) {
    const root *p = a, *q = b;
    if (p->imaginary != q->imaginary) return p->imaginary < q->imaginary ? -1 : 1;
    if (p->real != q->real) return p->real > q->real ? -1 : 1;
    return p->place < q->place ? -1 : 1;
}

static int by_real(const void *a, const void *b) {
    const root *p = a, *q = b;
    if (p->real != q->real) return p->real > q->real ? -1 : 1;
    return p->place < q->place ? -1 : 1;
}

/// The logarithm of a multiplier over the period, an exponent; its frequency is from 0 to half of that of the period.
static void take_logarithm(double *real, double *imaginary, double period) {
    const double size = hypot(*real, *imaginary), angle = atan2(*imaginary == 0.0 ? 0.0 : *imaginary, *real);
    *real = log(size) / period;
    *imaginary = angle / period;
}

/// The shape of a root in all coordinates.
static void spread(const mean_system *m, const double *vector, double *out) {
    for (size_t i = 0; i < m->count; i++) memcpy(out + 2 * m->kept[i], vector + 2 * i, 2 * sizeof *out);
}

whirl_modes *modes_allocate(size_t dimension, size_t count) {
    const size_t numbers = dimension + 2 * count * dimension + count;
    whirl_modes *modes = calloc(1, sizeof *modes + count * sizeof(whirl_mode) + numbers * sizeof(double));
    if (!modes) return NULL;
    modes->dimension = dimension;
    modes->modes = (whirl_mode *)(modes + 1);
    modes->rest = (double *)(modes->modes + count);
    modes->vectors = modes->rest + dimension;
    modes->reals = modes->vectors + 2 * count * dimension;
    return modes;
}

/// Those with a frequency apart from those without; of a pair the positive one. Free motions are left out.
static whirl_modes *sort_out(const mean_system *m, root *roots, double period, const double *vectors) {
    const size_t n = m->count, d = m->system->dimension;
    size_t waves = 0, reals = 0;
    double largest = 0.0;
    root *other = roots + n;
    whirl_modes *modes = modes_allocate(d, n);
    if (!modes) return NULL;
    for (size_t i = 0; i < n; i++) largest = fmax(largest, hypot(roots[i].real, roots[i].imaginary));
    const double zero = period > 0.0 ? 1e-9 : zero_part * largest;
    modes->growth = -(double)INFINITY;
    for (size_t i = 0; i < n; i++) {
        const bool free_motion = period == 0.0 && hypot(roots[i].real, roots[i].imaginary) <= zero;
        if (free_motion) continue;
        modes->growth = fmax(modes->growth, roots[i].real);
        if (roots[i].imaginary > zero)
            roots[waves++] = roots[i];
        else if (roots[i].imaginary >= -zero)
            other[reals++] = roots[i];
    }
    qsort(roots, waves, sizeof *roots, by_imaginary);
    qsort(other, reals, sizeof *other, by_real);
    modes->count = waves;
    modes->real_count = reals;
    modes->period = period;
    for (size_t i = 0; i < reals; i++) modes->reals[i] = other[i].real;
    for (size_t i = 0; i < waves; i++) {
        double *shape = modes->vectors + 2 * i * d;
        spread(m, vectors + 2 * roots[i].place * n, shape);
        modes->modes[i] = (whirl_mode){roots[i].real, roots[i].imaginary, whirl_direction(m->system, shape)};
    }
    return modes;
}

// ---------------------------------------------------------------- solving

/// How many independent displacements no force answers: what the rank of the Jacobian [n][n] lacks, in coordinates of
/// like sizes. Each has the eigenvalue 0 twice, as a place and as a rate, or, with damping, once. The Jacobian is lost;
/// work [n]. False without memory.
static bool count_free(size_t n, double *jacobian, double *work, size_t *count) {
    size_t rank;
    memset(work, 0, n * sizeof *work);
    matrix_balance(n, jacobian, NULL);
    if (!matrix_solve_shortest(n, jacobian, zero_part, work, &rank)) return false;
    *count = n - rank;
    return true;
}

/// Of the Jacobian, or of the monodromy matrix over a period > 0.
static whirl_status solve(const mean_system *m, double *matrix, double period, const double *rest, whirl_modes **out) {
    const size_t n = m->count;
    double *numbers = calloc(2 * n + 3 * n * n + 1, sizeof *numbers);
    root *roots = calloc(2 * n + 1, sizeof *roots);
    double *real = numbers, *imaginary = numbers ? numbers + n : NULL,
           *copy = numbers ? numbers + 2 * n * (n + 1) : NULL;
    const bool room = numbers && roots;
    if (room) memcpy(copy, matrix, n * n * sizeof *copy);
    errno = 0;
    const bool solved = room && matrix_eigen(n, matrix, real, imaginary, numbers + 2 * n);
    for (size_t i = 0; i < n && solved; i++) {
        if (period > 0.0) take_logarithm(&real[i], &imaginary[i], period);
        roots[i] = (root){real[i], imaginary[i], i};
    }
    whirl_modes *modes = solved ? sort_out(m, roots, period, numbers + 2 * n) : NULL;
    // All but free motions are sorted out.
    const bool frees = modes && 2 * modes->count + modes->real_count < n;
    if (frees && !count_free(n, copy, real, &modes->free)) {
        whirl_modes_free(modes);
        modes = NULL;
    }
    if (modes) memcpy(modes->rest, rest, m->system->dimension * sizeof *rest);
    free(numbers);
    free(roots);
    *out = modes;
    if (room && !solved && errno != ENOMEM)
        return whirl_fail(WHIRL_BAD_INPUT, "the eigenvalues of the Jacobian where the machine rests were not found");
    return modes ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for the modes of %zu coordinates", n);
}

/// About x, which, unless it is held, becomes the equilibrium, or the periodic motion at t = 0. matrix [count][count]
/// is workspace.
static whirl_status find(mean_system *m, bool held, double *x, double *matrix, whirl_modes **out) {
    double period = 0.0;
    whirl_status status = held ? whirl_ok() : rest_find(m, x);
    if (status.code != WHIRL_OK) return status;
    if (mean_is_modulated(m, x, matrix))
        status = periodic_find(m, x, false, matrix, &period);
    else
        mean_jacobian(m, x, matrix);
    return status.code == WHIRL_OK ? solve(m, matrix, period, x, out) : status;
}

whirl_status modes_about(const whirl_system *system, const double *start, bool held, whirl_modes **out) {
    mean_system mean;
    void *block;
    const size_t d = system->dimension;
    *out = NULL;
    whirl_status status = mean_begin(&mean, system, &block);
    if (status.code != WHIRL_OK) return status;
    double *x = malloc((d + d * d + 1) * sizeof *x);
    if (x) {
        memcpy(x, start, d * sizeof *x);
        status = find(&mean, held, x, x + d, out);
    } else {
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the modes of %zu coordinates", d);
    }
    free(x);
    free(block);
    return status;
}

whirl_status whirl_modes_new(const whirl_system *system, const double *start, whirl_modes **out) {
    return modes_about(system, start, false, out);
}

void whirl_modes_free(whirl_modes *modes) {
    free(modes);
}

// ---------------------------------------------------------------- direction

void direction_area(const whirl_system *system, const double *a, const double *b, double out[2]) {
    out[0] = out[1] = 0.0;
    for (size_t p = 0; p < system->probe_count; p++) {
        const whirl_probe *probe = &system->probes[p];
        const double *ax = a + 2 * probe->x, *ay = a + 2 * probe->y, *bx = b + 2 * probe->x, *by = b + 2 * probe->y;
        if (probe->x == probe->y) continue;
        // i (conj(ax) by - conj(ay) bx)
        const double way = whirl_probe_way(probe);
        out[0] += way * (-(ax[0] * by[1] - ax[1] * by[0]) + (ay[0] * bx[1] - ay[1] * bx[0]));
        out[1] += way * ((ax[0] * by[0] + ax[1] * by[1]) - (ay[0] * bx[0] + ay[1] * bx[1]));
    }
}

double whirl_direction(const whirl_system *system, const double *v) {
    double area[2], square = 0.0;
    direction_area(system, v, v, area);
    for (size_t p = 0; p < system->probe_count; p++) {
        const whirl_probe *probe = &system->probes[p];
        const double *x = v + 2 * probe->x, *y = v + 2 * probe->y;
        square += x[0] * x[0] + x[1] * x[1];
        if (probe->x != probe->y) square += y[0] * y[0] + y[1] * y[1];
    }
    return square > 0.0 ? area[0] / square : 0.0;
}
