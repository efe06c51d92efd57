// Free motions: displacements without a restoring force. They are the null space of a Jacobian, and are found by
// elimination.
//
// The remainder of a subtraction counts as zero if it is small against the subtracted numbers. So neither units nor
// stiff parts elsewhere in the machine decide.
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "free_motions.h"

/// A sum below this part of its summands is doubtful: it may be rounding.
static const double doubtful = 1e-8;

/// Largest remainder that counts as rounding of the matrix, in units of the remainder that one rounding of each number
/// can leave.
static const double roundings = 100.0;

/// An elimination with exchange of rows and columns.
typedef struct elimination {
    size_t n, rank;
    double *matrix;       ///< [n][n] in scaled coordinates, rows and columns in their original order
    double *numbers;      ///< [n][n] the factors: upper triangle, and below the diagonal the multipliers of rows
    double *sums;         ///< [n][n] sum of the moduli of all summands of each number
    double *scale;        ///< [n] powers of two: a coordinate divided by the scaled coordinate
    size_t *row, *column; ///< [n] positions of rows and columns after the exchanges
    double *work;         ///< [3 n][n] for free shapes
} elimination;

/// Scales rows and columns until the largest number of each is near 1.
static void scale_numbers(elimination *e) {
    enum { SWEEPS = 8 };
    const size_t n = e->n;
    for (size_t i = 0; i < n; i++) e->scale[i] = 1.0;
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        for (size_t i = 0; i < n; i++) {
            double largest = 0.0;
            for (size_t k = 0; k < n; k++) largest = fmax(largest, fabs(e->matrix[i * n + k]));
            const double factor = largest > 0.0 ? exp2(-round(log2(largest))) : 1.0;
            for (size_t k = 0; k < n && factor != 1.0; k++) e->matrix[i * n + k] *= factor;
        }
        for (size_t k = 0; k < n; k++) {
            double largest = 0.0;
            for (size_t i = 0; i < n; i++) largest = fmax(largest, fabs(e->matrix[i * n + k]));
            const double factor = largest > 0.0 ? exp2(-round(log2(largest))) : 1.0;
            for (size_t i = 0; i < n && factor != 1.0; i++) e->matrix[i * n + k] *= factor;
            e->scale[k] *= factor;
        }
    }
}

/// Finds the largest number from row and column `rank` on that is clearly more than rounding.
static bool find_clear_pivot(const elimination *e, size_t *row, size_t *column) {
    const size_t n = e->n;
    double largest = 0.0;
    for (size_t i = e->rank; i < n; i++)
        for (size_t k = e->rank; k < n; k++) {
            const double size = fabs(e->numbers[i * n + k]);
            if (size <= largest || size <= doubtful * fmax(e->sums[i * n + k], 1.0)) continue;
            largest = size;
            *row = i;
            *column = k;
        }
    return largest > 0.0;
}

/// Computes the displacement to which only rows from `rank` on respond, with column `free` at 1, by back substitution.
/// out [rank] has its numbers for the pivots' columns.
static void follow_pivots(const elimination *e, size_t free, double *out) {
    const size_t n = e->n;
    for (size_t i = e->rank; i-- > 0;) {
        const double *row = e->numbers + i * n;
        double sum = -row[e->rank + free], sums = fabs(sum);
        for (size_t k = i + 1; k < e->rank; k++) {
            sum -= row[k] * out[k];
            sums += fabs(row[k] * out[k]);
        }
        out[i] = fabs(sum) <= 16.0 * DBL_EPSILON * sums ? 0.0 : sum / row[i];
    }
}

/// Computes the combination of rows that is 0 in columns before `rank`: row `free` once, and the rows of pivots out
/// [rank] times.
static void sum_rows(const elimination *e, size_t free, double *out) {
    const size_t n = e->n;
    const double *multipliers = e->numbers + (e->rank + free) * n;
    for (size_t i = e->rank; i-- > 0;) {
        double sum = -multipliers[i];
        for (size_t k = i + 1; k < e->rank; k++) sum -= e->numbers[k * n + i] * out[k];
        out[i] = sum;
    }
}

/// If no remainder is clear, finds the one that exceeds the rounding of the matrix most. A remainder is u' A v, where u
/// is the combination of rows and v the displacement. One rounding of each number of A changes the remainder by at most
/// |u|' |A| |v| times the rounding unit.
static bool find_doubtful_pivot(const elimination *e, size_t *row, size_t *column) {
    const size_t n = e->n, rank = e->rank, left = n - rank;
    double *pivots = e->work, *sums = pivots + left * rank, *moved = sums + left * rank, most = roundings;
    // Compute the displacement of each free column, and the combination of rows of each remainder.
    for (size_t k = 0; k < left; k++) {
        follow_pivots(e, k, pivots + k * rank);
        sum_rows(e, k, sums + k * rank);
    }
    // Compare every remainder with the bound of its rounding.
    for (size_t k = 0; k < left; k++) {
        for (size_t i = 0; i < n; i++) {
            const double *own = e->matrix + e->row[i] * n;
            moved[i] = fabs(own[e->column[rank + k]]);
            for (size_t j = 0; j < rank; j++) moved[i] += fabs(own[e->column[j]] * pivots[k * rank + j]);
        }
        for (size_t i = 0; i < left; i++) {
            double bound = moved[rank + i];
            for (size_t j = 0; j < rank; j++) bound += fabs(sums[i * rank + j]) * moved[j];
            const double size = fabs(e->numbers[(rank + i) * n + rank + k]);
            if (!(size > most * DBL_EPSILON * bound)) continue;
            most = size / (DBL_EPSILON * bound);
            *row = rank + i;
            *column = rank + k;
        }
    }
    return most > roundings;
}

static void swap_places(size_t *places, size_t a, size_t b) {
    const size_t moved = places[a];
    places[a] = places[b];
    places[b] = moved;
}

/// Exchanges two rows or columns of a matrix [n][n]. a and b point to their first numbers; `next` is the distance to
/// the next number.
static void swap_numbers(double *a, double *b, size_t n, size_t next) {
    for (size_t i = 0; i < n * next && a != b; i += next) {
        const double moved = a[i];
        a[i] = b[i];
        b[i] = moved;
    }
}

static void exchange(elimination *e, size_t row, size_t column) {
    const size_t n = e->n, at = e->rank;
    double *const both[] = {e->numbers, e->sums};
    swap_places(e->row, at, row);
    swap_places(e->column, at, column);
    for (size_t i = 0; i < 2; i++) {
        swap_numbers(both[i] + at * n, both[i] + row * n, n, 1);
        swap_numbers(both[i] + at, both[i] + column, n, n);
    }
}

static void eliminate(elimination *e) {
    const size_t n = e->n;
    size_t row = 0, column = 0;
    for (size_t i = 0; i < n; i++) e->row[i] = e->column[i] = i;
    memcpy(e->numbers, e->matrix, n * n * sizeof *e->numbers);
    for (size_t i = 0; i < n * n; i++) e->sums[i] = fabs(e->numbers[i]);
    for (; e->rank < n && (find_clear_pivot(e, &row, &column) || find_doubtful_pivot(e, &row, &column)); e->rank++) {
        const size_t at = e->rank;
        const double *pivots = e->numbers + at * n;
        exchange(e, row, column);
        for (size_t i = at + 1; i < n; i++) {
            double *own = e->numbers + i * n, *sums = e->sums + i * n;
            if (own[at] == 0.0) continue;
            own[at] /= pivots[at];
            for (size_t k = at + 1; k < n; k++) {
                const double change = own[at] * pivots[k];
                own[k] -= change;
                sums[k] += fabs(change);
            }
        }
    }
}

// ---------------------------------------------------------------- one step

/// One replacement of coordinates. A free shape is given by its leading coordinates. The other coordinates follow them,
/// and are replaced by their motion relative to the free shapes.
struct free_step {
    size_t n, leading;
    size_t *lead, *follow; ///< [leading], [n - leading] coordinates, each rising
    double *shape;         ///< [n - leading][leading] motion of the followers in each free shape
    double *pull;          ///< [leading][n - leading] derivative of the leaders' slope by the followers
    struct free_step *next;
};

static bool step_new(size_t n, size_t leading, free_step **out) {
    const size_t others = n - leading, numbers = 2 * others * leading;
    free_step *step = calloc(1, sizeof *step + numbers * sizeof(double) + n * sizeof(size_t));
    if (!step) return false;
    step->n = n;
    step->leading = leading;
    step->shape = (double *)(step + 1);
    step->pull = step->shape + others * leading;
    step->lead = (size_t *)(step->shape + numbers);
    step->follow = step->lead + leading;
    *out = step;
    return true;
}

/// Sets the leading coordinates and the free shapes; `work` [n] and `order` [n] are workspace.
static void step_fill(const elimination *e, double *work, size_t *order, free_step *step) {
    const size_t n = e->n;
    size_t leads = 0, follows = 0;
    double *pivots = work;
    for (size_t i = 0; i < n; i++) order[e->column[i]] = i;
    for (size_t i = 0; i < n; i++)
        if (order[i] < e->rank)
            step->follow[follows++] = i;
        else
            step->lead[leads++] = i;
    for (size_t k = 0; k < leads; k++) {
        follow_pivots(e, order[step->lead[k]] - e->rank, pivots);
        for (size_t i = 0; i < follows; i++)
            step->shape[i * leads + k] =
                pivots[order[step->follow[i]]] * e->scale[step->follow[i]] / e->scale[step->lead[k]];
    }
}

/// Replaces the matrix [n][n] by the matrix of the followers relative to the free shapes, [n - leading][n - leading].
static void step_take(free_step *step, double *matrix) {
    const size_t n = step->n, leads = step->leading, follows = n - leads;
    for (size_t k = 0; k < leads; k++)
        for (size_t i = 0; i < follows; i++) step->pull[k * follows + i] = matrix[step->lead[k] * n + step->follow[i]];
    for (size_t i = 0; i < follows; i++)
        for (size_t j = 0; j < follows; j++) {
            double number = matrix[step->follow[i] * n + step->follow[j]];
            for (size_t k = 0; k < leads; k++) number -= step->shape[i * leads + k] * step->pull[k * follows + j];
            // Rows and columns ascend, so that nothing is overwritten before it is read.
            matrix[i * follows + j] = number;
        }
}

/// Counts the independent free shapes in which a displacement (place true) moves.
static size_t count_displaced(const free_step *step, const bool *place) {
    size_t count = 0;
    for (size_t k = 0; k < step->leading; k++) {
        bool any = place[step->lead[k]];
        for (size_t i = 0; i < step->n - step->leading; i++)
            any = any || (place[step->follow[i]] && step->shape[i * step->leading + k] != 0.0);
        count += any;
    }
    return count;
}

// ---------------------------------------------------------------- all of them

void free_motions_end(free_step *first) {
    while (first) {
        free_step *const next = first->next;
        free(first);
        first = next;
    }
}

bool free_motions_take_out(size_t n, double *matrix, const bool *place, size_t *left, size_t *displaced,
                           free_step **first) {
    double *numbers = calloc(6 * n * n + n + 1, sizeof *numbers);
    size_t *places = calloc(3 * n + 1, sizeof *places);
    bool allocated = numbers && places;
    free_step **end = first;
    *first = NULL;
    *left = n;
    *displaced = 0;
    // Each pass removes the null space of the matrix; a Jordan chain takes several passes.
    while (allocated && *left > 0) {
        const size_t m = *left;
        elimination e = {.n = m, .matrix = numbers, .row = places, .column = places + m};
        e.numbers = e.matrix + m * m;
        e.sums = e.numbers + m * m;
        e.work = e.sums + m * m;
        e.scale = e.work + 3 * m * m;
        memcpy(e.matrix, matrix, m * m * sizeof *numbers);
        // Find the rank by elimination.
        scale_numbers(&e);
        eliminate(&e);
        if (e.rank == m) break;
        // Replace the matrix by that of the motion relative to the free shapes.
        allocated = step_new(m, m - e.rank, end);
        if (!allocated) break;
        step_fill(&e, e.work, places + 2 * m, *end);
        if (end == first) *displaced = count_displaced(*end, place);
        step_take(*end, matrix);
        *left = e.rank;
        end = &(*end)->next;
    }
    free(numbers);
    free(places);
    if (allocated) return true;
    free_motions_end(*first);
    *first = NULL;
    return false;
}

/// Converts a vector [followers][2] at the front of out [n][2] into a vector of all coordinates; `work` [n][2] is
/// workspace.
static void step_put_back(const free_step *step, double real, double imaginary, double *out, double *work) {
    const size_t leads = step->leading, follows = step->n - leads;
    const double square = real * real + imaginary * imaginary;
    for (size_t k = 0; k < leads; k++) {
        double pulled[2] = {0.0, 0.0};
        for (size_t j = 0; j < follows; j++)
            for (size_t c = 0; c < 2; c++) pulled[c] += step->pull[k * follows + j] * out[2 * j + c];
        work[2 * k] = (pulled[0] * real + pulled[1] * imaginary) / square;
        work[2 * k + 1] = (pulled[1] * real - pulled[0] * imaginary) / square;
    }
    for (size_t i = follows; i-- > 0;)
        for (size_t c = 0; c < 2; c++) {
            double moved = out[2 * i + c];
            for (size_t k = 0; k < leads; k++) moved += step->shape[i * leads + k] * work[2 * k + c];
            out[2 * step->follow[i] + c] = moved;
        }
    for (size_t k = 0; k < leads; k++) memcpy(out + 2 * step->lead[k], work + 2 * k, 2 * sizeof *out);
}

static void put_back(const free_step *step, double real, double imaginary, double *out, double *work) {
    if (!step) return;
    put_back(step->next, real, imaginary, out, work);
    step_put_back(step, real, imaginary, out, work);
}

void free_motions_put_back(const free_step *first, double real, double imaginary, double *vector, double *work) {
    double largest = 0.0, square = 0.0;
    if (!first) return;
    put_back(first, real, imaginary, vector, work);
    // Scale to length 1 in a way that does not overflow for slow eigenvalues.
    for (size_t i = 0; i < 2 * first->n; i++) largest = fmax(largest, fabs(vector[i]));
    for (size_t i = 0; i < 2 * first->n; i++) square += vector[i] / largest * (vector[i] / largest);
    const double length = largest * sqrt(square);
    for (size_t i = 0; i < 2 * first->n && length > 0.0; i++) vector[i] /= length;
}
