// Rodas5P for x'' = f(t, x, x') over vector lanes, compiled once for every instruction set.
//
// With s = 1/(gamma h) the equations of a stage are
//
//     s u_q - u_v = r_q,      s u_v - A u_q - B u_v = r_v
//
// where A and B are the Jacobian of the accelerations by positions and by velocities. With u_q = (u_v + r_q)/s they
// become
//
//     (s^2 - s B - A) u_v = s r_v + A r_q,
//
// with one unknown for each degree. States of first order are velocities without positions: they have columns of B
// only. So the matrix has a row for each of the rates, which are velocities and states. It is decomposed without
// exchange of rows, in the same way for all lanes: as steps become short, s^2 on its diagonal outgrows all else. A
// pivot far below s^2 is a sign that the step is too long: its error is set to at least 1e8.
#include "adaptive_lanes.inc"

#include "sparsity.h"

enum { METHOD_DENSE = RODAS5P_DENSE };

/// Loops over some vectors k, and also over all degrees or rates, where i is the index of their vector.
#define FOR_SOME(of) for (size_t k = (of).first; k < (of).first + (of).count; k++)
#define FOR_ROWS_OF_SOME(of, rows)                                                                                     \
    for (size_t d = 0; d < (rows); d++)                                                                                \
        for (size_t k = (of).first, i = d * lanes->stride + k; k < (of).first + (of).count; k++, i++)
#define FOR_DEGREES_OF_SOME(of) FOR_ROWS_OF_SOME(of, lanes->degrees)
#define FOR_RATES_OF_SOME(of) FOR_ROWS_OF_SOME(of, lanes->rates)

// ---------------------------------------------------------------- derivatives

/// Computes the slope at t, and the Jacobian.
static void take_jacobian(const adaptive_lanes *lanes, vectors of) {
    memcpy(lanes->rodas5p.unit_q, lanes->q, lanes->degrees * lanes->stride * sizeof(vec));
    memcpy(lanes->rodas5p.unit_v, lanes->v, lanes->rates * lanes->stride * sizeof(vec));
    take_forcing(lanes, of, 0.0, lanes->length);
    lanes_view view = view_of(lanes, of, lanes->rodas5p.unit_q, lanes->rodas5p.unit_v, lanes->rodas5p.by);
    view.tangents = lanes->rodas5p.sparsity->perturbations;
    view.columns = lanes->rodas5p.sparsity->perturbation;
    lanes->flow(&view);
}

/// Places and weights of the forcing's time derivative, by a difference formula of fourth order. For cos 4t the error
/// of the formula is 1e-12, and that of rounding is as large.
static const struct {
    double offset, weight;
} beside[] = {{0x1p-11, 0x1p11 * 8.0 / 12.0},
              {-0x1p-11, -0x1p11 * 8.0 / 12.0},
              {0x1p-10, -0x1p11 / 12.0},
              {-0x1p-10, 0x1p11 / 12.0}};
enum { BESIDE = sizeof beside / sizeof *beside };

/// Computes the forcing at t + offset.
static void take_forcing_beside(const adaptive_lanes *lanes, vectors of, double offset) {
    FOR_SOME(of) VECTORS(time)[k] = v_add(VECTORS(t)[k], v_set(offset));
    lanes->forcing_at(lanes->model, lanes->stride, of.count, VECTORS(time) + of.first, VECTORS(forcing) + of.first);
}

/// Adds the forcing at t + offset, times a weight, to a sum.
static void add_forcing(const adaptive_lanes *lanes, vectors of, double offset, double weight) {
    vec *sum = VECTORS(rodas5p.ahead);
    take_forcing_beside(lanes, of, offset);
    for (size_t n = 0; n < lanes->forcing_count; n++) FOR_SOME(of) {
            const size_t i = n * lanes->stride + k;
            sum[i] = v_fma(v_set(weight), VECTORS(forcing)[i], sum[i]);
        }
}

/// Computes the slope's time derivative by a difference of fourth order, at times within the revolution.
static void take_rate_of_slopes(const adaptive_lanes *lanes, vectors of) {
    static const double weights[] = {-25.0, 48.0, -36.0, 16.0, -3.0};
    const vec step = v_set(0x1p-13 * lanes->period), end = v_set(lanes->period);
    vec *rate = VECTORS(rodas5p.rate), *slope = VECTORS(rodas5p.between_v), apart[MAX_GROUP];
    FOR_SOME(of) {
        const vec last = v_fma(v_set(4.0), step, VECTORS(t)[k]);
        apart[k] = v_select(v_less(last, end), step, v_sub(v_set(0.0), step));
    }
    FOR_RATES_OF_SOME(of) rate[i] = v_mul(v_set(weights[0]), VECTORS(rodas5p.by)[i]);
    for (int n = 1; n <= 4; n++) {
        take_forcing(lanes, of, n, (const double *)apart);
        take_slope(lanes, of, lanes->q, lanes->v, lanes->rodas5p.between_v);
        FOR_RATES_OF_SOME(of) rate[i] = v_fma(v_set(weights[n]), slope[i], rate[i]);
    }
    FOR_RATES_OF_SOME(of) rate[i] = v_div(rate[i], v_mul(v_set(12.0), apart[k]));
    take_forcing(lanes, of, 0.0, lanes->length);
}

/// Computes the partial derivative of the slope by time. Usually the slope depends on time through the forcing, and
/// linearly: then it is the slope with the forcing plus the forcing's derivative, minus the slope.
static void take_rate(const adaptive_lanes *lanes, vectors of) {
    const size_t forcings = lanes->forcing_count * lanes->stride;
    vec *ahead = VECTORS(rodas5p.ahead);
    if (lanes->modulated) {
        take_rate_of_slopes(lanes, of);
        return;
    }
    for (size_t i = 0; i < forcings; i++) ahead[i] = v_set(0.0);
    for (int n = 0; n < BESIDE; n++) add_forcing(lanes, of, beside[n].offset, beside[n].weight);
    add_forcing(lanes, of, 0.0, 1.0);
    lanes_view view = view_of(lanes, of, lanes->q, lanes->v, lanes->rodas5p.rate);
    view.forcing = ahead + of.first;
    lanes->flow(&view);
    FOR_RATES_OF_SOME(of) VECTORS(rodas5p.rate)[i] = v_sub(VECTORS(rodas5p.rate)[i], VECTORS(rodas5p.by)[i]);
}

// ---------------------------------------------------------------- equations of a stage

/// Calls `what` for some vectors: for all of them together, so that they hide each other's latency, or one by one.
#define TOGETHER(what, of)                                                                                             \
    do {                                                                                                               \
        if ((of).count == 4 && lanes->stride == 4)                                                                     \
            what(4, 0, 4);                                                                                             \
        else if ((of).count == 2 && lanes->stride == 2)                                                                \
            what(2, 0, 2);                                                                                             \
        else if (lanes->stride == 1)                                                                                   \
            what(1, 0, 1);                                                                                             \
        else                                                                                                           \
            FOR_SOME(of) what(lanes->stride, k, 1);                                                                    \
    } while (0)

/// Loops over the listed columns of row i.
#define FOR_ENTRIES(c, rows, i)                                                                                        \
    for (const size_t *r_##c = (rows).run + 2 * (rows).begin[i], *last_##c = (rows).run + 2 * (rows).begin[(i) + 1];   \
         r_##c < last_##c; r_##c += 2)                                                                                 \
        for (size_t c = r_##c[0], end_##c = r_##c[1]; c < end_##c; c++)
#define FOR_COUNT for (size_t c = 0; c < count; c++)

/// Returns the number in row i of the Jacobian of vector k, in the column that perturbation d determines.
VECTOR_INLINE const vec *by_perturbation(const vec *by, size_t d, size_t rates, size_t stride, size_t i) {
    return by + ((1 + d) * rates + i) * stride;
}

/// Fills row i of the matrix of `count` vectors from k on.
VECTOR_INLINE void fill_row(const adaptive_lanes *lanes, size_t i, size_t stride, size_t k, size_t count, vec *row) {
    const sparsity at = *lanes->rodas5p.sparsity;
    const size_t n = lanes->rates, *by_q = at.perturbation, *by_v = by_q + lanes->degrees;
    const vec *shift = VECTORS(rodas5p.shift) + k, *slopes = VECTORS(rodas5p.by) + k;
    FOR_COUNT row[i * stride + c] = v_set(0.0);
    FOR_ENTRIES(j, at.lower, i) FOR_COUNT row[j * stride + c] = v_set(0.0);
    FOR_ENTRIES(j, at.upper, i) FOR_COUNT row[j * stride + c] = v_set(0.0);
    FOR_ENTRIES(j, at.by_q, i) {
        const vec *by = by_perturbation(slopes, by_q[j], n, stride, i);
        FOR_COUNT row[j * stride + c] = v_sub(v_set(0.0), by[c]);
    }
    FOR_ENTRIES(j, at.by_v, i) {
        const vec *by = by_perturbation(slopes, by_v[j], n, stride, i);
        FOR_COUNT row[j * stride + c] = v_fnma(shift[c], by[c], row[j * stride + c]);
    }
    FOR_COUNT row[i * stride + c] = v_fma(shift[c], shift[c], row[i * stride + c]);
}

/// Decomposes the matrices of `count` vectors from k on, row by row. The factors replace the matrices.
VECTOR_INLINE void decompose_some(const adaptive_lanes *lanes, size_t stride, size_t k, size_t count) {
    const size_t n = lanes->rates;
    const sparsity at = *lanes->rodas5p.sparsity; // a copy, so that compilers know that no write changes it
    vec *matrix = VECTORS(rodas5p.matrix) + k, *pivot = VECTORS(rodas5p.pivot) + k;
    vec least[MAX_GROUP], doubt[MAX_GROUP], factor[MAX_GROUP];
    // Pivots below `least` are doubtful, and so are all pivots of a lane whose shift is 0.
    FOR_COUNT {
        const vec s = VECTORS(rodas5p.shift)[k + c];
        least[c] = v_mul(v_set(0x1p-8), v_mul(s, s));
        doubt[c] = v_select(v_less(v_set(0.0), least[c]), v_set(0.0), v_set(1.0));
    }
    // Fill a row, eliminate it with the rows above, and invert its pivot.
    for (size_t i = 0; i < n; i++) {
        vec *row = matrix + i * n * stride, *diagonal = row + i * stride;
        fill_row(lanes, i, stride, k, count, row);
        FOR_ENTRIES(m, at.lower, i) {
            const vec *above = matrix + m * n * stride;
            FOR_COUNT row[m * stride + c] = factor[c] = v_mul(row[m * stride + c], pivot[m * stride + c]);
            FOR_ENTRIES(j, at.upper, m)
            FOR_COUNT row[j * stride + c] = v_fnma(factor[c], above[j * stride + c], row[j * stride + c]);
        }
        FOR_COUNT doubt[c] = v_select(v_less(least[c], diagonal[c]), doubt[c], v_set(1.0));
        FOR_COUNT pivot[i * stride + c] = v_div(v_set(1.0), diagonal[c]);
    }
    FOR_COUNT VECTORS(rodas5p.doubtful)[k + c] = doubt[c];
}

#if VECTOR_QUADS
/// Subtracts two columns from x, each times its factor. Loops go over whole quads of rows, so that compilers make
/// vectors without a rest.
VECTOR_INLINE void subtract_two(double *restrict x, const double *restrict first, double by_first,
                                const double *restrict second, double by_second, size_t from, size_t to) {
    for (size_t i = 4 * from; i < 4 * to; i++) x[i] = v_fnma(second[i], by_second, v_fnma(first[i], by_first, x[i]));
}

VECTOR_INLINE void subtract_one(double *restrict x, const double *restrict column, double by, size_t from, size_t to) {
    for (size_t i = 4 * from; i < 4 * to; i++) x[i] = v_fnma(column[i], by, x[i]);
}

/// The factors of the dense matrix of one machine, column by column, with zeros up to whole quads of rows; and a
/// column.
typedef struct dense_factors {
    size_t n, quads, rows; ///< rows: distance of columns, 4 * quads
    double *lower, *upper; ///< [n][rows]
    double *pivot;         ///< [n] reciprocals
    double *x;             ///< [rows] workspace
} dense_factors;

static dense_factors dense_factors_of(const adaptive_lanes *lanes) {
    const size_t n = lanes->rates, quads = (n + 3) / 4, rows = 4 * quads;
    double *lower = lanes->rodas5p.matrix, *upper = lower + n * rows;
    return (dense_factors){n, quads, rows, lower, upper, lanes->rodas5p.pivot, upper + n * rows};
}

/// Eliminates x by the first `count` columns of the lower factor.
static void eliminate(const dense_factors *of, size_t count) {
    double *x = of->x;
    size_t m = 0;
    for (; m + 2 <= count; m += 2) {
        const double *first = of->lower + m * of->rows, *second = first + of->rows, by = x[m];
        subtract_two(x, first, by, second, v_fnma(first[m + 1], by, x[m + 1]), (m + 1) / 4, of->quads);
    }
    if (m < count) subtract_one(x, of->lower + m * of->rows, x[m], (m + 1) / 4, of->quads);
}

/// Solves for x with the upper factor.
static void substitute_back(const dense_factors *of) {
    double *x = of->x;
    size_t j = of->n;
    for (; j >= 2; j -= 2) {
        const double *last = of->upper + (j - 1) * of->rows, *before = last - of->rows,
                     by = x[j - 1] * of->pivot[j - 1], next = v_fnma(last[j - 2], by, x[j - 2]) * of->pivot[j - 2];
        subtract_two(x, last, by, before, next, 0, (j + 2) / 4);
        x[j - 1] = by;
        x[j - 2] = next;
    }
    if (j > 0) x[0] *= of->pivot[0];
}

/// Decomposes the dense matrix of one machine. Each number takes the operations of decompose_some, in its order.
static void decompose_alone(const adaptive_lanes *lanes) {
    const dense_factors of = dense_factors_of(lanes);
    const size_t n = of.n, degrees = lanes->degrees;
    const double s = *lanes->rodas5p.shift, least = 0x1p-8 * (s * s);
    double *restrict x = of.x;
    const double *by_q = lanes->rodas5p.by + n, *by_v = by_q + degrees * n;
    bool doubtful = !(0.0 < least);
    for (size_t j = 0; j < n; j++) {
        // Fill a column, and eliminate it with the columns before.
        double *below = of.lower + j * of.rows, *above = of.upper + j * of.rows;
        const double *restrict from_q = by_q + j * n, *restrict from_v = by_v + j * n;
        if (j < degrees)
            for (size_t i = 0; i < n; i++) x[i] = v_fnma(s, from_v[i], 0.0 - from_q[i]);
        else
            for (size_t i = 0; i < n; i++) x[i] = v_fnma(s, from_v[i], 0.0);
        x[j] = v_fma(s, s, x[j]);
        eliminate(&of, j);
        // Invert its pivot, and store the factors.
        doubtful = doubtful || !(least < x[j]);
        of.pivot[j] = 1.0 / x[j];
        for (size_t i = 0; i < j; i++) above[i] = x[i];
        for (size_t i = j; i < 4 * (j / 4 + 1); i++) above[i] = 0.0;
        for (size_t i = 4 * (j / 4); i <= j; i++) below[i] = 0.0;
        for (size_t i = j + 1; i < n; i++) below[i] = x[i] * of.pivot[j];
        for (size_t i = n; i < of.rows; i++) below[i] = x[i] = 0.0;
    }
    *lanes->rodas5p.doubtful = doubtful ? 1.0 : 0.0;
}

/// Solves the equations of a stage for one machine with the factors of decompose_alone.
static void solve_alone(const adaptive_lanes *lanes, double *u_q, double *u_v) {
    const dense_factors of = dense_factors_of(lanes);
    const size_t n = of.n, degrees = lanes->degrees;
    const double *by_q = lanes->rodas5p.by + n, *right_q = lanes->rodas5p.right_q, s = *lanes->rodas5p.shift;
    double *restrict x = of.x;
    // Compute the right-hand side s r_v + A r_q.
    for (size_t i = 0; i < n; i++) x[i] = s * u_v[i];
    size_t j = 0;
    for (; j + 4 <= degrees; j += 4) {
        const double *restrict a = by_q + j * n, *restrict b = a + n, *restrict c = b + n, *restrict d = c + n;
        const double by_a = right_q[j], by_b = right_q[j + 1], by_c = right_q[j + 2], by_d = right_q[j + 3];
        for (size_t i = 0; i < n; i++)
            x[i] = v_fma(by_d, d[i], v_fma(by_c, c[i], v_fma(by_b, b[i], v_fma(by_a, a[i], x[i]))));
    }
    for (; j < degrees; j++)
        for (size_t i = 0; i < n; i++) x[i] = v_fma(right_q[j], by_q[j * n + i], x[i]);
    // Substitute forward and back.
    for (size_t i = n; i < of.rows; i++) x[i] = 0.0;
    eliminate(&of, n);
    substitute_back(&of);
    for (size_t i = 0; i < n; i++) u_v[i] = x[i];
    for (size_t i = 0; i < degrees; i++) u_q[i] = rodas5p_gamma * *lanes->length * (x[i] + right_q[i]);
}
#endif

static void decompose(const adaptive_lanes *lanes, vectors of) {
#if VECTOR_QUADS
    if (lanes->rodas5p.sparsity->dense) {
        decompose_alone(lanes);
        return;
    }
#endif
#define DECOMPOSE(stride, k, count) decompose_some(lanes, stride, k, count)
    TOGETHER(DECOMPOSE, of);
#undef DECOMPOSE
}

/// Solves the equations of a stage for `count` vectors from k on, with the right-hand sides in right_q and u_v.
VECTOR_INLINE void solve_some(const adaptive_lanes *lanes, size_t stride, size_t k, size_t count, vec *u_q, vec *u_v) {
    const size_t n = lanes->rates;
    const sparsity at = *lanes->rodas5p.sparsity;
    const vec *slopes = VECTORS(rodas5p.by) + k;
    const vec *shift = VECTORS(rodas5p.shift) + k, *right_q = VECTORS(rodas5p.right_q) + k;
    const vec *matrix = VECTORS(rodas5p.matrix) + k, *pivot = VECTORS(rodas5p.pivot) + k;
    vec x[MAX_GROUP];
    u_q += k;
    u_v += k;
    // Compute the right-hand side s r_v + A r_q, and substitute forward.
    for (size_t i = 0; i < n; i++) {
        const vec *row = matrix + i * n * stride;
        FOR_COUNT x[c] = v_mul(shift[c], u_v[i * stride + c]);
        FOR_ENTRIES(j, at.by_q, i) {
            const vec *by = by_perturbation(slopes, at.perturbation[j], n, stride, i);
            FOR_COUNT x[c] = v_fma(right_q[j * stride + c], by[c], x[c]);
        }
        FOR_ENTRIES(j, at.lower, i) FOR_COUNT x[c] = v_fnma(row[j * stride + c], u_v[j * stride + c], x[c]);
        FOR_COUNT u_v[i * stride + c] = x[c];
    }
    // Substitute back.
    for (size_t i = n; i-- > 0;) {
        const vec *row = matrix + i * n * stride;
        FOR_COUNT x[c] = u_v[i * stride + c];
        for (size_t r = at.upper.begin[i + 1]; r-- > at.upper.begin[i];)
            for (size_t j = at.upper.run[2 * r + 1], first = at.upper.run[2 * r]; j-- > first;)
                FOR_COUNT x[c] = v_fnma(row[j * stride + c], u_v[j * stride + c], x[c]);
        FOR_COUNT u_v[i * stride + c] = v_mul(x[c], pivot[i * stride + c]);
    }
    // Compute the increments of positions, u_q = (u_v + r_q)/s.
    for (size_t i = 0; i < lanes->degrees; i++) FOR_COUNT {
            const vec gamma_h = v_mul(v_set(rodas5p_gamma), VECTORS(length)[k + c]);
            u_q[i * stride + c] = v_mul(gamma_h, v_add(u_v[i * stride + c], right_q[i * stride + c]));
        }
}

static void rodas5p_solve(const adaptive_lanes *lanes, vectors of, vec *u_q, vec *u_v) {
#if VECTOR_QUADS
    if (lanes->rodas5p.sparsity->dense) {
        solve_alone(lanes, u_q, u_v);
        return;
    }
#endif
#define SOLVE(stride, k, count) solve_some(lanes, stride, k, count, u_q, u_v)
    TOGETHER(SOLVE, of);
#undef SOLVE
}

/// Returns 1/h.
static inline vec per_length(const adaptive_lanes *lanes, size_t k) {
    return v_mul(VECTORS(rodas5p.shift)[k], v_set(rodas5p_gamma));
}

/// Returns x plus the weighted increments before stage `number`. u is the first increment; increments are `apart`
/// vectors apart. *right becomes their sum with the weights of the stage's equations. Each of the last states is the
/// previous one plus its increment.
VECTOR_INLINE vec add_increments(int number, const vec *u, size_t apart, vec x, vec *right) {
    *right = v_set(0.0);
    for (int j = 0; j < number; j++, u += apart) {
        if (number <= RODAS5P_LAST_SUM || j == number - 1) x = v_fma(v_set(rodas5p_a[number][j]), *u, x);
        *right = v_fma(v_set(rodas5p_g[number][j]), *u, *right);
    }
    return x;
}

/// Computes the state at which the slope of stage `number` is taken, and in right_q and u_v the contribution of earlier
/// increments to its equations. The slopes of positions are the velocities of the stage.
VECTOR_INLINE void enter_stage(const adaptive_lanes *lanes, vectors of, int number) {
    const rodas5p_work *own = &lanes->rodas5p;
    const bool follows = number > RODAS5P_LAST_SUM;
    const size_t apart = lanes->dimension * lanes->stride;
    const vec *q = follows ? VECTORS(stage_q) : VECTORS(q), *v = follows ? VECTORS(stage_v) : VECTORS(v);
    const vec *u_q = (const vec *)own->u_q[0], *u_v = (const vec *)own->u_v[0];
    vec *stage_q = VECTORS(stage_q), *stage_v = VECTORS(stage_v), *right_q = VECTORS(rodas5p.right_q);
    vec *right_v = (vec *)own->u_v[number], right;
    if (lanes->stride == 1) { // one loop, which compilers vectorize for one machine
        const vec per = per_length(lanes, 0);
        for (size_t i = 0; i < lanes->rates; i++) {
            stage_v[i] = add_increments(number, u_v + i, apart, v[i], &right);
            right_v[i] = v_mul(per, right);
        }
        for (size_t i = 0; i < lanes->degrees; i++) {
            stage_q[i] = add_increments(number, u_q + i, apart, q[i], &right);
            right_q[i] = v_fma(per, right, stage_v[i]);
        }
        return;
    }
    FOR_RATES_OF_SOME(of) {
        stage_v[i] = add_increments(number, u_v + i, apart, v[i], &right);
        right_v[i] = v_mul(per_length(lanes, k), right);
    }
    FOR_DEGREES_OF_SOME(of) {
        stage_q[i] = add_increments(number, u_q + i, apart, q[i], &right);
        right_q[i] = v_fma(per_length(lanes, k), right, stage_v[i]);
    }
}

/// Computes the state of a stage. Calls enter_stage with constants, so that its loops have no branches.
static void take_stage(const adaptive_lanes *lanes, vectors of, int number) {
    _Static_assert(RODAS5P_STAGES == 8, "a case for every stage");
#define STAGE(n)                                                                                                       \
    case n:                                                                                                            \
        enter_stage(lanes, of, n);                                                                                     \
        break;
    switch (number) { STAGE(0) STAGE(1) STAGE(2) STAGE(3) STAGE(4) STAGE(5) STAGE(6) STAGE(7) }
#undef STAGE
}

/// Computes the increment of stage `number`, where a is its slope.
static void take_increment(const adaptive_lanes *lanes, vectors of, int number, const vec *a) {
    const vec *rate = VECTORS(rodas5p.rate);
    vec *u_q = (vec *)lanes->rodas5p.u_q[number], *u_v = (vec *)lanes->rodas5p.u_v[number];
    FOR_RATES_OF_SOME(of) {
        const vec by_time = v_mul(v_set(rodas5p_d[number]), VECTORS(length)[k]);
        u_v[i] = v_fma(by_time, rate[i], v_add(u_v[i], a[i]));
    }
    rodas5p_solve(lanes, of, u_q, u_v);
}

// ---------------------------------------------------------------- the step

/// Computes the three sums of the interpolant for vector i of the increments u.
VECTOR_INLINE void sum_polynomials(double *const *u, size_t i, vec e[RODAS5P_DENSE - 1]) {
    for (int p = 0; p < RODAS5P_DENSE - 1; p++) e[p] = v_set(0.0);
    for (int n = 0; n < RODAS5P_STAGES; n++)
        for (int p = 0; p < RODAS5P_DENSE - 1; p++) e[p] = v_fma(v_set(rodas5p_h[p][n]), ((const vec *)u[n])[i], e[p]);
}

/// Computes the interpolant in the middle of the step. Returns its derivative by theta there.
VECTOR_INLINE vec take_middle(double *const *u, const vec *begin, const vec *end, size_t i, vec *place) {
    vec e[RODAS5P_DENSE - 1];
    const vec half = v_set(0.5), quarter = v_set(0.25), way = v_sub(end[i], begin[i]);
    sum_polynomials(u, i, e);
    place[i] = v_fma(quarter, v_fma(quarter, e[2], v_fma(half, e[1], e[0])), v_fma(half, way, begin[i]));
    return v_fma(quarter, v_add(e[1], e[2]), way);
}

/// Estimates the error of the interpolant in the middle of the step, in between_q and between_v: (1/(gamma h) - J)^-1
/// times the residual of the equations there. In stiff systems the error at the step's end does not show it.
static void take_error_between(const adaptive_lanes *lanes, vectors of) {
    const rodas5p_work *own = &lanes->rodas5p;
    vec *right_q = VECTORS(rodas5p.right_q), *right_v = VECTORS(rodas5p.between_v);
    const vec *q = VECTORS(q), *v = VECTORS(v), *end_q = VECTORS(end_q), *end_v = VECTORS(end_v);
    FOR_RATES_OF_SOME(of)
    right_v[i] = v_mul(per_length(lanes, k), take_middle(own->u_v, v, end_v, i, VECTORS(stage_v)));
    FOR_DEGREES_OF_SOME(of) {
        const vec speed = take_middle(own->u_q, q, end_q, i, VECTORS(stage_q));
        right_q[i] = v_fms(per_length(lanes, k), speed, VECTORS(stage_v)[i]);
    }
    take_forcing(lanes, of, 0.5, lanes->length);
    take_slope(lanes, of, lanes->stage_q, lanes->stage_v, own->rate);
    FOR_RATES_OF_SOME(of) right_v[i] = v_sub(right_v[i], VECTORS(rodas5p.rate)[i]);
    rodas5p_solve(lanes, of, VECTORS(rodas5p.between_q), right_v);
}

/// Computes the squared error of vector k, divided by the tolerance of all coordinates: at the end or in the middle,
/// whichever is larger. It is NaN if the state at the end is, and large if a pivot of the stages' equations is too
/// small.
static void take_error(const adaptive_lanes *lanes, size_t k) {
    const vec *q = VECTORS(q), *v = VECTORS(v), *end_q = VECTORS(end_q), *end_v = VECTORS(end_v);
    const vec *u_q = VECTORS(rodas5p.u_q[RODAS5P_STAGES - 1]), *u_v = VECTORS(rodas5p.u_v[RODAS5P_STAGES - 1]);
    const vec *m_q = VECTORS(rodas5p.between_q), *m_v = VECTORS(rodas5p.between_v);
    const vec *last = VECTORS(end_slope), one = v_set(1.0);
    vec end = v_set(0.0), middle = v_set(0.0), most = v_set(0.0), nothing = v_set(0.0);
    // Degrees, group by group, with the tolerance by the group's size. `nothing` is 0, or NaN if a slope is.
    for (size_t g = 0; g < lanes->group_count; g++) {
        const size_t from = lanes->groups[g], to = lanes->groups[g + 1], stride = lanes->stride;
        const vec size = group_size(q, v, end_q, end_v, stride, k, from, to);
        const vec per = v_div(one, v_fma(v_set(lanes->rtol), size, v_set(lanes->atol)));
        vec own = v_set(0.0), between = v_set(0.0);
        for (size_t d = from, i = d * stride + k; d < to; d++, i += stride) {
            own = v_add(own, square_of(one, u_q[i], u_v[i]));
            between = v_add(between, square_of(one, m_q[i], m_v[i]));
            nothing = v_add(nothing, v_sub(last[i], last[i]));
        }
        end = v_fma(v_mul(per, per), own, end);
        middle = v_fma(v_mul(per, per), between, middle);
        most = v_max(most, size);
    }
    // The states of first order.
    FOR_STATES_OF(k) {
        const vec size = state_size(lanes, v, end_v, i);
        const vec per = v_div(one, v_fma(v_set(lanes->rtol), size, v_set(lanes->atol)));
        end = v_fma(v_mul(per, u_v[i]), v_mul(per, u_v[i]), end);
        middle = v_fma(v_mul(per, m_v[i]), v_mul(per, m_v[i]), middle);
        nothing = v_add(nothing, v_sub(last[i], last[i]));
        most = v_max(most, size);
    }
    // Take the larger error: at least 1e8 if a pivot was too small, NaN if any number is.
    const vec error = v_div(v_max(end, middle), v_set((double)lanes->dimension));
    const vec trusted = v_select(is_set(VECTORS(rodas5p.doubtful)[k]), v_max(error, v_set(1e8)), error);
    VECTORS(error)[k] = v_add(v_add(trusted, nothing), v_add(v_sub(end, end), v_sub(middle, middle)));
    VECTORS(size)[k] = most;
}

/// Tries the step: computes the state at its end, the slope there and the error.
static void try_step(const adaptive_lanes *lanes) {
    const vec *last_q = VECTORS(rodas5p.u_q[RODAS5P_STAGES - 1]), *last_v = VECTORS(rodas5p.u_v[RODAS5P_STAGES - 1]);
    const vectors of = running(lanes);
    FOR_SOME(of) VECTORS(rodas5p.shift)[k] = v_div(v_set(1.0 / rodas5p_gamma), VECTORS(length)[k]);
    take_jacobian(lanes, of);
    take_rate(lanes, of);
    decompose(lanes, of);
    for (int number = 0; number < RODAS5P_STAGES; number++) {
        double *slope = number == 0 ? lanes->rodas5p.by : lanes->end_slope;
        take_stage(lanes, of, number);
        if (number > 0) {
            if (rodas5p_c[number] != rodas5p_c[number - 1]) take_forcing(lanes, of, rodas5p_c[number], lanes->length);
            take_slope(lanes, of, lanes->stage_q, lanes->stage_v, slope);
        }
        take_increment(lanes, of, number, (const vec *)slope);
    }
    FOR_DEGREES_OF_SOME(of) VECTORS(end_q)[i] = v_add(VECTORS(stage_q)[i], last_q[i]);
    FOR_RATES_OF_SOME(of) VECTORS(end_v)[i] = v_add(VECTORS(stage_v)[i], last_v[i]);
    take_slope(lanes, of, lanes->end_q, lanes->end_v, lanes->end_slope);
    take_error_between(lanes, of);
    FOR_SOME(of) take_error(lanes, k);
}

/// Computes the interpolant of rows from their values at both ends and their increments u, and writes it to rows from
/// `first` on.
static void take_polynomials_of(const adaptive_lanes *lanes, size_t first, size_t rows, double *const *u,
                                const vec *begin, const vec *end) {
    for (size_t i = 0, j = first * lanes->stride; i < rows * lanes->stride; i++, j++) {
        vec e[RODAS5P_DENSE - 1];
        sum_polynomials(u, i, e);
        VECTORS(dense[0])[j] = begin[i];
        VECTORS(dense[1])[j] = v_sub(end[i], begin[i]);
        VECTORS(dense[2])[j] = e[0];
        VECTORS(dense[3])[j] = v_add(e[1], e[2]);
        VECTORS(dense[4])[j] = v_sub(v_set(0.0), e[2]);
    }
}

/// Computes the interpolant of the step tried, a nested product of theta and 1 - theta in turn.
static void take_polynomials(const adaptive_lanes *lanes) {
    const size_t n = lanes->degrees;
    take_polynomials_of(lanes, 0, n, lanes->rodas5p.u_q, VECTORS(q), VECTORS(end_q));
    take_polynomials_of(lanes, n, lanes->rates, lanes->rodas5p.u_v, VECTORS(v), VECTORS(end_v));
}

/// Returns the powers for errors of order 5. The step grows by err^(-1/8) times err_before^(1/16) times 0.92, so that
/// errors settle at 0.92^16 = 0.26 of the tolerance.
static inline error_powers powers_of(vec square) {
    vec p = v_max(v_min(square, v_set(1e16)), v_set(1e-16));
    for (int i = 0; i < 5; i++) p = rough_inverse_root(p); // err^-1, err^1/2, err^-1/4, err^1/8, err^-1/16
    const vec root = rough_inverse_root(p);
    return (error_powers){v_mul(p, p), v_mul(v_mul(p, p), p), v_mul(root, root)};
}

#if VECTOR_ISA == VECTOR_SCALAR
static void take_stage_of_slot(const adaptive_lanes *slot, int number) {
    double *increment = slot->rodas5p.u_v[number], *kept = slot->rodas5p.between_v;
    memcpy(kept, increment, slot->rates * sizeof *kept); // a stage overwrites its increment
    take_stage(slot, only(0), number);
    memcpy(increment, kept, slot->rates * sizeof *kept);
}
static void solve_slot(const adaptive_lanes *slot, double *x) {
    rodas5p_solve(slot, only(0), x, x);
}
#endif

#define METHOD_REVOLVE ISA(rodas5p_lanes)
#define METHOD_SLOT rodas5p_slot
#define SOLVE_SLOT solve_slot
#include "adaptive_revolve.inc"
