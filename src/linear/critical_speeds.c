// Critical speeds without damping, all at once: the roots of K q = w^2 (M - i G) q.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "direction.h"
#include "equilibrium.h"
#include "exhausted.h"
#include "free_motions.h"
#include "linear_status.h"
#include "matrix.h"
#include "mean.h"
#include "modes.h"
#include "whirl/engine/linear.h"

/// A machine linearised at its equilibrium, in SI units: q'' = stiffness q + rates q' for its displacements q. Both
/// matrices are [count][count].
typedef struct matrices {
    size_t count;
    size_t *places; ///< [count] coordinates of the state
    double *stiffness, *rates;
    double *block; ///< all of these numbers
} matrices;

// ---------------------------------------------------------------- the matrices

/// Takes the matrices from a Jacobian [n][n] whose unit of time is 1/clock.
static whirl_status split(const double *jacobian, size_t n, const size_t *kept, double clock, matrices *out) {
    size_t *places = calloc(2 * n + 1, sizeof *places), *rates = places ? places + n : NULL, count = 0;
    if (!places) return whirl_fail(WHIRL_NO_MEMORY, "no memory for critical speeds of %zu coordinates", n);
    // Find the displacements and their rates.
    for (size_t i = 0; i < n; i++) {
        const size_t rate = mean_rate_of(jacobian, n, i);
        if (rate == n) continue;
        places[count] = i;
        rates[count++] = rate;
    }
    out->count = count;
    out->block = calloc(2 * count * count + 1, sizeof *out->block);
    out->places = places;
    if (!out->block) return whirl_fail(WHIRL_NO_MEMORY, "no memory for critical speeds of %zu coordinates", n);
    out->stiffness = out->block;
    out->rates = out->block + count * count;
    // Accelerations by displacements and by rates, in SI.
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < count; k++) {
            out->stiffness[i * count + k] = clock * clock * jacobian[rates[i] * n + places[k]];
            out->rates[i * count + k] = clock * jacobian[rates[i] * n + rates[k]];
        }
    for (size_t i = 0; i < count; i++) places[i] = kept[places[i]];
    if (2 * count == n) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT,
                      "%zu of %zu states are neither places nor their rates: expected a machine "
                      "without such states for critical speeds",
                      n - 2 * count, n);
}

static whirl_status critical_take(mean_system *m, const whirl_machine *machine, double *x, double *jacobian,
                                  matrices *out) {
    whirl_status status = rest_find(m, x);
    if (status.code != WHIRL_OK) return status;
    if (mean_is_modulated(m, x, jacobian))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "coefficients turn with the shaft: no single frequency is that of the shaft");
    mean_jacobian(m, x, jacobian);
    return split(jacobian, m->count, m->kept, machine->clock, out);
}

/// Makes the matrices of a machine. The caller frees them by matrices_free, after a failure too.
static whirl_status matrices_new(const whirl_machine *machine, matrices *out) {
    mean_system mean;
    void *block;
    const size_t d = machine->system->dimension;
    *out = (matrices){.count = 0};
    whirl_status status = mean_begin(&mean, machine->system, &block);
    if (status.code != WHIRL_OK) return status;
    double *x = malloc((d + d * d + 1) * sizeof *x);
    if (x) {
        memcpy(x, machine->start, d * sizeof *x);
        status = critical_take(&mean, machine, x, x + d, out);
    } else {
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for critical speeds of %zu coordinates", d);
    }
    free(x);
    free(block);
    return status;
}

static void matrices_free(matrices *m) {
    free(m->places);
    free(m->block);
}

// ---------------------------------------------------------------- the roots

/// The roots. The complex problem of order n is written as a real one of order 2n: its vectors are the real parts above
/// the imaginary parts, and every root appears twice.
typedef struct roots {
    size_t n, free;  ///< number of complex directions; number of those without stiffness, whose roots are 0
    double *values;  ///< [2n] w^2, rising
    double *vectors; ///< [2n][n][2] in their order
    double *block;   ///< all of these numbers, and workspace
} roots;

/// Fills the matrices K + s (1 - i G) (left) and 1 - i G (right) of the real problem. K is minus the stiffness of
/// `slow`, and s the shift.
static void critical_fill(const matrices *slow, const double *gyroscopic, double shift, double *left, double *right) {
    const size_t n = slow->count, all = 2 * n;
    memset(right, 0, all * all * sizeof *right);
    for (size_t i = 0; i < n; i++) {
        right[i * all + i] = right[(n + i) * all + n + i] = 1.0;
        for (size_t k = 0; k < n; k++) {
            right[i * all + n + k] += gyroscopic[i * n + k];
            right[(n + i) * all + k] -= gyroscopic[i * n + k];
        }
    }
    for (size_t i = 0; i < all * all; i++) left[i] = shift * right[i];
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) {
            left[i * all + k] -= slow->stiffness[i * n + k];
            left[(n + i) * all + n + k] -= slow->stiffness[i * n + k];
        }
}

static int by_value(const void *a, const void *b) {
    const double *p = a, *q = b;
    return (p[0] > q[0]) - (p[0] < q[0]);
}

/// Copies the vectors of real roots in rising order, as complex numbers. order [all][2]: w^2 and the index of the
/// vector.
static void sort(roots *r, double (*order)[2], const double *found) {
    const size_t n = r->n, all = 2 * n;
    qsort(order, all, sizeof *order, by_value);
    for (size_t i = 0; i < all; i++) {
        // Rounding may turn a double root into a complex pair: then the real and the imaginary part are both vectors.
        const double *v = found + 2 * all * (size_t)order[i][1];
        r->values[i] = order[i][0];
        for (size_t k = 0; k < n; k++) {
            r->vectors[2 * (i * n + k)] = v[2 * k];
            r->vectors[2 * (i * n + k) + 1] = v[2 * (n + k)];
        }
    }
}

/// Transposes a matrix [all][all]: right-hand sides are stored row by row.
static void transpose(size_t all, double *a) {
    for (size_t i = 0; i < all; i++)
        for (size_t k = 0; k < i; k++) {
            const double moved = a[i * all + k];
            a[i * all + k] = a[k * all + i];
            a[k * all + i] = moved;
        }
}

/// Computes the roots from the inverse, in which low speeds are large. The shift makes the matrix invertible even with
/// rigid-body modes.
static whirl_status critical_solve(const matrices *slow, const double *gyroscopic, double shift, roots *r) {
    // Parts of one allocation.
    const size_t all = 2 * slow->count;
    double *left = r->block, *right = left + all * all, *real = right + all * all, *imaginary = real + all;
    double *found = imaginary + all, (*order)[2] = (double(*)[2])(found + 2 * all * all);
    // Invert, and find the roots.
    critical_fill(slow, gyroscopic, shift, left, right);
    transpose(all, right);
    if (!matrix_solve(all, left, all, right))
        return whirl_fail(WHIRL_BAD_INPUT, "the matrices of critical speeds are singular");
    transpose(all, right);
    if (!matrix_eigen(all, right, real, imaginary, found))
        return whirl_fail(WHIRL_BAD_INPUT, "the roots of critical speeds were not found");
    // Refuse complex roots, and undo the shift.
    double largest = 0.0;
    for (size_t i = 0; i < all; i++) largest = fmax(largest, fabs(real[i]));
    for (size_t i = 0; i < all; i++) {
        if (fabs(imaginary[i]) > 1e-6 * fabs(real[i]) + 1e-13 * largest)
            return whirl_fail(WHIRL_BAD_INPUT, "the stiffness is not symmetric (cross-coupled), expected a symmetric "
                                               "one for critical speeds without damping");
        order[i][0] = 1.0 / real[i] - shift;
        order[i][1] = (double)i;
    }
    sort(r, order, found);
    return whirl_ok();
}

/// Sets the range *first to before *last to the roots that are 0, and to all others whose modulus is below `most`.
static void roots_slowest(const roots *r, double most, size_t *first, size_t *last) {
    const size_t all = 2 * r->n;
    size_t low = 0;
    while (low < all && r->values[low] < 0.0) low++;
    size_t high = low;
    for (size_t zeros = 2 * r->free; zeros > 0; zeros--)
        if (high == all || (low > 0 && -r->values[low - 1] < r->values[high]))
            low--;
        else
            high++;
    while (low > 0 && -r->values[low - 1] < most) low--;
    while (high < all && r->values[high] < most) high++;
    *first = low;
    *last = high;
}

/// Counts the directions without stiffness.
static whirl_status count_free(const matrices *slow, size_t *count) {
    const size_t n = slow->count;
    double *matrix = malloc((n * n + 1) * sizeof *matrix);
    bool *place = malloc((n + 1) * sizeof *place);
    free_step *zeros = NULL;
    size_t left;
    bool allocated = matrix && place;
    *count = 0;
    if (allocated) {
        memcpy(matrix, slow->stiffness, n * n * sizeof *matrix);
        for (size_t i = 0; i < n; i++) place[i] = true;
        allocated = free_motions_take_out(n, matrix, place, &left, count, &zeros);
    }
    free_motions_end(zeros);
    free(matrix);
    free(place);
    return allocated ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for critical speeds of %zu coordinates", n);
}

static whirl_status roots_new(const matrices *slow, const double *gyroscopic, double shift, roots *r) {
    const size_t n = slow->count, all = 2 * n;
    r->block = calloc(5 * all * all + 5 * all + 2 * n * all + 1, sizeof *r->block);
    if (!r->block) return whirl_fail(WHIRL_NO_MEMORY, "no memory for critical speeds of %zu coordinates", n);
    r->values = r->block + 4 * all * all + 4 * all;
    r->vectors = r->values + all;
    return critical_solve(slow, gyroscopic, shift, r);
}

/// Computes the smallest roots again with smaller shifts, since rounding of the shift hides roots that are far smaller
/// than it.
static whirl_status roots_sharpen(const matrices *slow, const double *gyroscopic, double shift, roots *r) {
    enum { MAX_ROUNDS = 4 };
    const double far_smaller = 1e-4, next_shift = 1e-8;
    whirl_status status = whirl_ok();
    for (int round = 0; round < MAX_ROUNDS && status.code == WHIRL_OK; round++) {
        roots sharper = {.n = r->n, .free = r->free};
        size_t first, last;
        roots_slowest(r, far_smaller * shift, &first, &last);
        if (last - first <= 2 * r->free) break;
        shift *= next_shift;
        status = roots_new(slow, gyroscopic, shift, &sharper);
        if (status.code == WHIRL_OK) {
            memcpy(r->values + first, sharper.values + first, (last - first) * sizeof *r->values);
            memcpy(r->vectors + 2 * r->n * first, sharper.vectors + 2 * r->n * first,
                   2 * r->n * (last - first) * sizeof *r->vectors);
        }
        free(sharper.block);
    }
    return status;
}

// ---------------------------------------------------------------- shapes

/// Subtracts from v [n][2] its part along the unit vector u. Returns the length of the rest.
static double without(size_t n, const double *u, double *v) {
    double real = 0.0, imaginary = 0.0, square = 0.0;
    for (size_t i = 0; i < n; i++) {
        real += u[2 * i] * v[2 * i] + u[2 * i + 1] * v[2 * i + 1];
        imaginary += u[2 * i] * v[2 * i + 1] - u[2 * i + 1] * v[2 * i];
    }
    for (size_t i = 0; i < n; i++) {
        v[2 * i] -= u[2 * i] * real - u[2 * i + 1] * imaginary;
        v[2 * i + 1] -= u[2 * i] * imaginary + u[2 * i + 1] * real;
        square += v[2 * i] * v[2 * i] + v[2 * i + 1] * v[2 * i + 1];
    }
    return sqrt(square);
}

static double length_of(size_t n, const double *v) {
    double square = 0.0;
    for (size_t i = 0; i < 2 * n; i++) square += v[i] * v[i];
    return sqrt(square);
}

/// Replaces 2m vectors [2m][n][2], which span m complex directions, by m orthonormal vectors at the front, the most
/// independent first.
static void make_independent(size_t n, size_t m, double *vectors) {
    for (size_t k = 0; k < m; k++) {
        size_t best = k;
        for (size_t i = k; i < 2 * m; i++)
            if (length_of(n, vectors + 2 * n * i) > (1.0 + 1e-9) * length_of(n, vectors + 2 * n * best)) best = i;
        double *own = vectors + 2 * n * k, *other = vectors + 2 * n * best;
        for (size_t i = 0; i < 2 * n && best != k; i++) {
            const double moved = own[i];
            own[i] = other[i];
            other[i] = moved;
        }
        const double length = length_of(n, own);
        for (size_t i = 0; i < 2 * n && length > 0.0; i++) own[i] /= length;
        for (size_t i = k + 1; i < 2 * m; i++) without(n, own, vectors + 2 * n * i);
    }
}

/// Copies a shape of displacements into all coordinates of the state. The rates stay 0.
static void spread(const matrices *of, const double *v, double *out) {
    for (size_t i = 0; i < of->count; i++) memcpy(out + 2 * of->places[i], v + 2 * i, 2 * sizeof *out);
}

/// Combines the m shapes of one speed. Any combination of them is a shape, too; the combinations with the most definite
/// directions of whirl are chosen, forward first. work: 8 m m + 2 m + 4 m n numbers.
static bool sort_directions(const whirl_system *system, size_t m, double *shapes, double *work) {
    if (m < 2) return true;
    const size_t d = system->dimension, all = 2 * m;
    double *form = work, *values = form + all * all, *mixed = values + all, *vectors = mixed + all * all;
    double *own = vectors + 2 * all * m;
    for (size_t i = 0; i < m; i++)
        for (size_t k = 0; k < m; k++) {
            double area[2];
            direction_area(system, shapes + 2 * d * i, shapes + 2 * d * k, area);
            form[i * all + k] = form[(m + i) * all + m + k] = area[0];
            form[(m + i) * all + k] = area[1];
            form[i * all + m + k] = -area[1];
        }
    if (!matrix_symmetric_modes(all, form, NULL, values, mixed)) return false;
    // The largest area, that is forward whirl, comes first.
    for (size_t i = 0; i < all; i++)
        for (size_t k = 0; k < m; k++) {
            vectors[2 * (i * m + k)] = mixed[(all - 1 - i) * all + k];
            vectors[2 * (i * m + k) + 1] = mixed[(all - 1 - i) * all + m + k];
        }
    make_independent(m, m, vectors);
    memset(own, 0, 2 * m * d * sizeof *own);
    for (size_t i = 0; i < m; i++)
        for (size_t k = 0; k < m; k++) {
            const double *c = vectors + 2 * (i * m + k), *shape = shapes + 2 * d * k;
            for (size_t j = 0; j < d; j++) {
                own[2 * (i * d + j)] += c[0] * shape[2 * j] - c[1] * shape[2 * j + 1];
                own[2 * (i * d + j) + 1] += c[0] * shape[2 * j + 1] + c[1] * shape[2 * j];
            }
        }
    memcpy(shapes, own, 2 * m * d * sizeof *own);
    return true;
}

/// Adds the critical speeds of the equal roots from `first` to before `after`. Leaves out torsional and axial modes,
/// which an unbalance does not excite.
static bool add_speed(const whirl_system *system, const matrices *of, roots *r, size_t first, size_t after,
                      whirl_critical_speeds *out) {
    const size_t m = (after - first) / 2, d = out->dimension;
    double *shapes = out->vectors + 2 * d * out->count;
    double *work = m > 1 ? calloc(14 * m * m + 4 * m + 2 * m * d + 1, sizeof *work) : NULL;
    if (m > 1 && !work) return false;
    make_independent(r->n, m, r->vectors + 2 * r->n * first);
    for (size_t i = 0; i < m; i++) spread(of, r->vectors + 2 * r->n * (first + i), shapes + 2 * d * i);
    const bool made = sort_directions(system, m, shapes, work);
    for (size_t i = 0; i < m && made; i++) {
        double *shape = shapes + 2 * d * i, torsion, axial;
        direction_drop_rounding(system, shape);
        modes_shares(system, shape, &torsion, &axial);
        if (whirl_mode_kind_of(torsion, axial) != WHIRL_LATERAL_MODE) continue;
        memmove(out->vectors + 2 * d * out->count, shape, 2 * d * sizeof *shape);
        out->directions[out->count] = whirl_direction(system, shape);
        out->speeds[out->count++] = sqrt(r->values[first + 2 * i]);
    }
    free(work);
    return made;
}

static whirl_critical_speeds *critical_allocate(size_t dimension, size_t count) {
    const size_t numbers = 2 * count + 2 * count * dimension;
    whirl_critical_speeds *speeds = calloc(1, sizeof *speeds + (numbers + 1) * sizeof(double));
    if (!speeds) return NULL;
    speeds->dimension = dimension;
    speeds->speeds = (double *)(speeds + 1);
    speeds->directions = speeds->speeds + count;
    speeds->vectors = speeds->directions + count;
    return speeds;
}

static whirl_status critical_collect(const whirl_system *system, const matrices *of, roots *r,
                                     whirl_critical_speeds **out) {
    const double alike = 1e-7; // relative difference of w^2 that rounding leaves between equal roots
    whirl_critical_speeds *speeds = critical_allocate(system->dimension, r->n);
    bool made = speeds != NULL;
    size_t first, last;
    roots_slowest(r, 0.0, &first, &last);
    while (last < 2 * r->n && r->values[last] <= 0.0) last++;
    for (size_t after; last < 2 * r->n && isfinite(r->values[last]) && made; last = after) {
        const double value = r->values[last];
        for (after = last + 1; after < 2 * r->n && r->values[after] - value <= alike * value;) after++;
        // Every root appears twice, so an odd number of equal roots misses one.
        if ((after - last) % 2 != 0 && after < 2 * r->n) after++;
        made = add_speed(system, of, r, last, after, speeds);
    }
    if (made) speeds->free = r->free;
    if (made)
        *out = speeds;
    else
        whirl_critical_speeds_free(speeds);
    return made ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for critical speeds of %zu coordinates", r->n);
}

// ---------------------------------------------------------------- the whole

static double largest_of(size_t count, const double *a) {
    double largest = 0.0;
    for (size_t i = 0; i < count; i++) largest = fmax(largest, fabs(a[i]));
    return largest;
}

/// Sets `gyroscopic` to minus the increase of the rates per rad/s of the speed.
static whirl_status critical_compare(const matrices *slow, const matrices *fast, double gained, double *gyroscopic) {
    const size_t n = slow->count;
    if (fast->count != n || gained == 0.0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "there is no machine at another speed, from which gyroscopic moments follow");
    for (size_t i = 0; i < n * n; i++) {
        const double size = largest_of(n, slow->stiffness + i / n * n); // largest stiffness of the same coordinate
        if (fabs(fast->stiffness[i] - slow->stiffness[i]) > 1e-9 * size)
            return whirl_fail(WHIRL_BAD_INPUT, "the stiffness changes with the speed (films, tables over speed): the "
                                               "critical speeds of such machines are found by modes along the speed");
        gyroscopic[i] = (slow->rates[i] - fast->rates[i]) / gained;
    }
    return whirl_ok();
}

static whirl_status critical_find(const whirl_machine *machine, const matrices *slow, const matrices *fast,
                                  double gained, whirl_critical_speeds **out) {
    const size_t n = slow->count;
    double *gyroscopic = calloc(n * n + 1, sizeof *gyroscopic);
    if (!gyroscopic) return whirl_fail(WHIRL_NO_MEMORY, "no memory for critical speeds of %zu coordinates", n);
    const double shift = 1e-6 * largest_of(n * n, slow->stiffness);
    roots r = {.n = n};
    whirl_status status = critical_compare(slow, fast, gained, gyroscopic);
    if (status.code == WHIRL_OK) status = count_free(slow, &r.free);
    if (status.code == WHIRL_OK) status = roots_new(slow, gyroscopic, shift, &r);
    if (status.code == WHIRL_OK) status = roots_sharpen(slow, gyroscopic, shift, &r);
    if (status.code == WHIRL_OK) status = critical_collect(machine->system, slow, &r, out);
    free(r.block);
    free(gyroscopic);
    return status;
}

whirl_status whirl_critical_speeds_new(const whirl_machine *machine, const whirl_machine *faster,
                                       whirl_critical_speeds **out) {
    matrices slow = {.count = 0}, fast = {.count = 0};
    *out = NULL;
    const int before = exhausted_watch();
    whirl_status status = matrices_new(machine, &slow);
    if (status.code == WHIRL_OK) status = matrices_new(faster, &fast);
    if (status.code == WHIRL_OK) status = critical_find(machine, &slow, &fast, faster->speed - machine->speed, out);
    const size_t coordinates = slow.count;
    matrices_free(&slow);
    matrices_free(&fast);
    return linear_status(before, status, coordinates);
}

void whirl_critical_speeds_free(whirl_critical_speeds *speeds) {
    free(speeds);
}
