// Modes: eigenvalues of the Jacobian at the equilibrium, or Floquet exponents of a periodic motion.
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "direction.h"
#include "equilibrium.h"
#include "exhausted.h"
#include "free_motions.h"
#include "matrix.h"
#include "mean.h"
#include "modes.h"
#include "periodic.h"

/// Real and imaginary parts below this share of an eigenvalue are rounding.
static const double rounding = 1e-13;

/// Imaginary parts below this share of an eigenvalue are rounding: two equal real eigenvalues became a pair.
static const double split = 1e-7;

/// Real parts up to this many times their rounding count as 0.
static const double roundings = 16.0;

/// An eigenvalue of the matrix as an exponent, and its index.
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

/// Converts a multiplier to an exponent, its logarithm divided by the period. The imaginary part is at most pi/period
/// in magnitude.
static void take_logarithm(double *real, double *imaginary, double period) {
    const double size = hypot(*real, *imaginary), angle = atan2(*imaginary == 0.0 ? 0.0 : *imaginary, *real);
    *real = log(size) / period;
    *imaginary = angle / period;
}

/// Copies the shape of a root into all coordinates of the state.
static void spread(const mean_system *m, const double *vector, double *out) {
    for (size_t i = 0; i < m->count; i++) memcpy(out + 2 * m->kept[i], vector + 2 * i, 2 * sizeof *out);
}

void modes_shares(const whirl_system *system, const double *shape, double *torsion, double *axial) {
    double moved[2 * WHIRL_MAX_PROBES];
    *torsion = system->twist ? system->twist(system->model, shape, moved) : 0.0;
    *axial = system->axial ? system->axial(system->model, shape, moved) : 0.0;
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

/// Sets real parts to 0 that are no larger than the rounding of the eigenvalue or of the matrix, noise [count].
static void drop_rounding(root *roots, size_t count, const double *noise) {
    for (size_t i = 0; i < count; i++)
        if (fabs(roots[i].real) <= fmax(rounding * fabs(roots[i].imaginary), roundings * noise[i])) roots[i].real = 0.0;
}

/// Makes modes from roots. Separates roots with a frequency from roots without; of a pair keeps the root with the
/// positive frequency. vectors [count][n][2] belong to the roots.
static whirl_modes *sort_out(const mean_system *m, root *roots, size_t count, double period, const double *vectors) {
    const size_t n = m->count, d = m->system->dimension;
    size_t waves = 0, reals = 0;
    root *other = roots + n;
    whirl_modes *modes = modes_allocate(d, n);
    if (!modes) return NULL;
    modes->growth = -(double)INFINITY;
    // Separate roots with a frequency from real roots.
    for (size_t i = 0; i < count; i++) {
        const root own = roots[i];
        const double least = period > 0.0 ? 1e-9 : split * hypot(own.real, own.imaginary);
        modes->growth = fmax(modes->growth, own.real);
        if (own.imaginary > least)
            roots[waves++] = own;
        else if (own.imaginary >= -least)
            other[reals++] = own;
    }
    qsort(roots, waves, sizeof *roots, by_imaginary);
    qsort(other, reals, sizeof *other, by_real);
    // Copy exponents and shapes in this order.
    modes->count = waves;
    modes->real_count = reals;
    modes->period = period;
    for (size_t i = 0; i < reals; i++) modes->reals[i] = other[i].real;
    for (size_t i = 0; i < waves; i++) {
        double *shape = modes->vectors + 2 * i * d;
        spread(m, vectors + 2 * roots[i].place * n, shape);
        direction_drop_rounding(m->system, shape);
        modes->modes[i] = (whirl_mode){
            .real = roots[i].real, .imaginary = roots[i].imaginary, .direction = whirl_direction(m->system, shape)};
        modes_shares(m->system, shape, &modes->modes[i].torsion, &modes->modes[i].axial);
    }
    return modes;
}

whirl_mode_kind whirl_mode_kind_of(double torsion, double axial) {
    const double lateral = 1.0 - torsion - axial;
    if (torsion > lateral && torsion >= axial) return WHIRL_TORSIONAL_MODE;
    return axial > lateral ? WHIRL_AXIAL_MODE : WHIRL_LATERAL_MODE;
}

bool whirl_mode_is_overdamped(const whirl_mode *mode) {
    return 0.0 - mode->real > WHIRL_OVERDAMPED_RATIO * hypot(mode->real, mode->imaginary);
}

whirl_status modes_put_overdamped_last(whirl_modes *modes) {
    const size_t d = modes->dimension, size = sizeof(whirl_mode) + 2 * d * sizeof(double);
    size_t seen = 0, behind = 0;
    char *memory = malloc(modes->count * size + 1);
    if (!memory) return whirl_fail(WHIRL_NO_MEMORY, "no memory to sort %zu modes", modes->count);
    whirl_mode *last = (whirl_mode *)memory;
    double *shapes = (double *)(last + modes->count);
    for (size_t i = 0; i < modes->count; i++) {
        const bool overdamped = whirl_mode_is_overdamped(&modes->modes[i]);
        whirl_mode *to = overdamped ? &last[behind] : &modes->modes[seen];
        double *shape = overdamped ? shapes + 2 * d * behind : modes->vectors + 2 * d * seen;
        *to = modes->modes[i];
        memmove(shape, modes->vectors + 2 * d * i, 2 * d * sizeof *shape);
        *(overdamped ? &behind : &seen) += 1;
    }
    memcpy(modes->modes + seen, last, behind * sizeof *last);
    memcpy(modes->vectors + 2 * d * seen, shapes, 2 * d * behind * sizeof *shapes);
    free(memory);
    return whirl_ok();
}

// ---------------------------------------------------------------- solving

/// Workspace for the matrices and roots of a system.
typedef struct solving {
    double *real, *imaginary, *noise; ///< [n]
    double *vectors, *work, *copy;    ///< [n][n][2], [n][2], [n][n]
    double *block;                    ///< all of these numbers
    root *roots;                      ///< [2n]
    bool *place;                      ///< [n] coordinates that have a rate; all true if none has
} solving;

static bool solving_begin(size_t n, solving *s) {
    s->block = calloc(5 * n + 3 * n * n + 1, sizeof *s->block);
    s->roots = calloc(2 * n + 1, sizeof *s->roots);
    s->place = calloc(n + 1, sizeof *s->place);
    if (!s->block || !s->roots || !s->place) return false;
    s->real = s->block;
    s->imaginary = s->real + n;
    s->noise = s->imaginary + n;
    s->work = s->noise + n;
    s->vectors = s->work + 2 * n;
    s->copy = s->vectors + 2 * n * n;
    return true;
}

static void solving_end(solving *s) {
    free(s->block);
    free(s->roots);
    free(s->place);
}

static void find_places(size_t n, const double *jacobian, bool *place) {
    bool any = false;
    for (size_t i = 0; i < n; i++) any = (place[i] = mean_rate_of(jacobian, n, i) < n) || any;
    for (size_t i = 0; i < n && !any; i++) place[i] = true;
}

/// Converts the vectors [left][left][2] of the reduced matrix to vectors [left][n][2] of the whole matrix.
static void put_back(size_t n, size_t left, const free_step *zeros, solving *s) {
    for (size_t i = left; i-- > 0 && left < n;) {
        double *to = s->vectors + 2 * n * i;
        memmove(to, s->vectors + 2 * left * i, 2 * left * sizeof *to);
        free_motions_put_back(zeros, s->real[i], s->imaginary[i], to, s->work);
    }
}

/// A root and its modulus.
typedef struct sized {
    double size;
    size_t place;
} sized;

static int modes_by_size(const void *a, const void *b) {
    const sized *p = a, *q = b;
    if (p->size != q->size) return p->size < q->size ? -1 : 1;
    return p->place < q->place ? -1 : p->place > q->place;
}

/// Sorts roots by modulus, the slowest first.
static void modes_sort_slowest(size_t n, const double *real, const double *imaginary, sized *order) {
    for (size_t i = 0; i < n; i++) order[i] = (sized){hypot(real[i], imaginary[i]), i};
    qsort(order, n, sizeof *order, modes_by_size);
}

/// Returns true if the roots before and from `count` on, sorted, share no pair.
static bool modes_is_apart(size_t n, const sized *order, size_t count) {
    return count == 0 || count == n || order[count].size > order[count - 1].size * (1.0 + 1e-12);
}

/// Replaces the slowest roots and their vectors by those of the inverse matrix: all up to the last root that rounding
/// of the matrix [n][n], s->copy, may change in the seventh digit. Keeps the roots of a matrix that is singular to
/// rounding. Returns false without memory.
static bool modes_sharpen_slowest(size_t n, solving *s) {
    static const double doubtful = 1e-6;
    double *block = calloc(2 * n * n + 3 * n + 1, sizeof *block);
    sized *order = calloc(2 * n + 1, sizeof *order), *sharp = order ? order + n : NULL;
    if (!block || !order) {
        free(block);
        free(order);
        return false;
    }
    double *real = block + 2 * n * n, *imaginary = real + n, *noise = imaginary + n;
    size_t count = 0;
    modes_sort_slowest(n, s->real, s->imaginary, order);
    for (size_t i = 0; i < n; i++)
        if (s->noise[order[i].place] > doubtful * order[i].size) count = i + 1;
    if (!modes_is_apart(n, order, count)) count++;
    const int before = exhausted_watch();
    bool good = count > 0 && matrix_eigen_by_inverse(n, s->copy, real, imaginary, block, noise);
    if (good) {
        modes_sort_slowest(n, real, imaginary, sharp);
        good = modes_is_apart(n, sharp, count);
        // A root within its rounding is 0 for all that is known: the matrix is singular, and its inverse means nothing.
        for (size_t i = 0; i < count; i++) good = good && sharp[i].size > noise[sharp[i].place];
    }
    for (size_t i = 0; i < count && good; i++) {
        const size_t to = order[i].place, from = sharp[i].place;
        s->real[to] = real[from];
        s->imaginary[to] = imaginary[from];
        s->noise[to] = noise[from] / roundings; // a bound, which needs no margin
        memcpy(s->vectors + 2 * n * to, block + 2 * n * from, 2 * n * sizeof *block);
    }
    free(block);
    free(order);
    return !exhausted(before);
}

/// Computes modes from the Jacobian (period 0), whose zero eigenvalues are removed, or from the monodromy matrix over a
/// period > 0.
static whirl_status modes_solve(const mean_system *m, double *matrix, double period, const double *rest,
                                whirl_modes **out) {
    const size_t n = m->count;
    size_t left = n, displaced = 0;
    free_step *zeros = NULL;
    solving s = {.block = NULL};
    bool allocated = solving_begin(n, &s), solved = allocated;
    // Remove zero eigenvalues first: their rounding could hide slow modes.
    if (allocated && period == 0.0) {
        find_places(n, matrix, s.place);
        allocated = solved = free_motions_take_out(n, matrix, s.place, &left, &displaced, &zeros);
    }
    if (solved) memcpy(s.copy, matrix, left * left * sizeof *matrix);
    // Compute the remaining eigenvalues, and the slowest of them again from the inverse.
    const int before = exhausted_watch();
    solved = solved && matrix_eigen_rounding(left, matrix, s.real, s.imaginary, s.vectors, s.noise);
    const bool no_memory = exhausted(before);
    if (solved && period == 0.0) allocated = solved = modes_sharpen_slowest(left, &s);
    if (solved) put_back(n, left, zeros, &s);
    // Convert eigenvalues to exponents, and make modes of them.
    for (size_t i = 0; i < left && solved; i++) {
        if (period > 0.0) take_logarithm(&s.real[i], &s.imaginary[i], period);
        s.roots[i] = (root){s.real[i], s.imaginary[i], i};
    }
    if (solved && period == 0.0) drop_rounding(s.roots, left, s.noise);
    whirl_modes *modes = solved ? sort_out(m, s.roots, left, period, s.vectors) : NULL;
    if (modes) {
        modes->free = displaced;
        memcpy(modes->rest, rest, m->system->dimension * sizeof *rest);
    }
    free_motions_end(zeros);
    solving_end(&s);
    *out = modes;
    if (allocated && !solved && !no_memory)
        return whirl_fail(WHIRL_BAD_INPUT, "the eigenvalues of the Jacobian where the machine rests were not found");
    return modes ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for the modes of %zu coordinates", n);
}

/// Finds the modes about x. Unless `held`, x becomes the equilibrium, or the state of the periodic motion at t = 0.
/// matrix [count][count] is workspace.
static whirl_status modes_find_all(mean_system *m, bool held, double *x, double *matrix, whirl_modes **out) {
    double period = 0.0;
    whirl_status status = held ? whirl_ok() : rest_find(m, x);
    if (status.code != WHIRL_OK) return status;
    if (mean_is_modulated(m, x, matrix)) {
        status = periodic_find(m, x, false, matrix, &period);
    } else {
        mean_leave_idle(m, x);
        mean_jacobian(m, x, matrix);
    }
    return status.code == WHIRL_OK ? modes_solve(m, matrix, period, x, out) : status;
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
        status = modes_find_all(&mean, held, x, x + d, out);
    } else {
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the modes of %zu coordinates", d);
    }
    free(x);
    free(block);
    return status;
}

whirl_status whirl_modes_new(const whirl_system *system, const double *start, whirl_modes **out) {
    whirl_status status = modes_about(system, start, false, out);
    if (status.code == WHIRL_OK) status = modes_put_overdamped_last(*out);
    if (status.code == WHIRL_OK) return status;
    whirl_modes_free(*out);
    *out = NULL;
    return status;
}

void whirl_modes_free(whirl_modes *modes) {
    free(modes);
}
