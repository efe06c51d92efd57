// The method of Dormand and Prince for x'' = f(t, x, x') over vector lanes, compiled once for every instruction set.
//
// Flags are 0 or 1. Quantities outermost, vectors of the group inside, slopes innermost.
#include "dop853_lanes.h"
#include "../../rotor/pair_kernel.h"
#include "bernstein.h"

#define VECTORS(array) ((vec *)(lanes->array))

/// For all vectors k; for all degrees d as well, with the index i of their vector; for all degrees of vector k.
#define FOR_VECTORS for (size_t k = 0; k < lanes->stride; k++)
#define FOR_DEGREES                                                                                                    \
    for (size_t d = 0; d < lanes->degrees; d++)                                                                        \
        for (size_t k = 0, i = d * lanes->stride; k < lanes->stride; k++, i++)

#define FOR_DEGREES_OF(k) for (size_t d = 0, i = (k); d < lanes->degrees; d++, i += lanes->stride)

static inline vec flag(vec_mask mask) {
    return v_select(mask, v_set(1.0), v_set(0.0));
}
static inline vec_mask is_set(vec flags) {
    return v_less(v_set(0.5), flags);
}

// ---------------------------------------------------------------- slopes

/// Vectors of the group, one after the other.
typedef struct vectors {
    size_t first, count;
} vectors;

static inline vectors all_of(const dop853_lanes *lanes) {
    return (vectors){0, lanes->stride};
}
static inline vectors only(size_t k) {
    return (vectors){k, 1};
}

static lanes_view view_of(const dop853_lanes *lanes, vectors of, const double *q, const double *v, double *a) {
    return (lanes_view){.model = lanes->model,
                        .stride = lanes->stride,
                        .vectors = of.count,
                        .numbers = VECTORS(numbers) + of.first,
                        .forcing = VECTORS(forcing) + of.first,
                        .sides = lanes->switch_count > 0 ? VECTORS(sides) + of.first : NULL,
                        .q = (const vec *)q + of.first,
                        .v = (const vec *)v + of.first,
                        .a = a ? (vec *)a + of.first : NULL};
}

/// The forcing at t + c h.
static void take_forcing(const dop853_lanes *lanes, vectors of, double c, const double *h) {
    vec *time = VECTORS(time) + of.first;
    for (size_t i = 0; i < of.count; i++)
        time[i] = v_fma(v_set(c), ((const vec *)h)[of.first + i], VECTORS(t)[of.first + i]);
    lanes->forcing_at(lanes->model, lanes->stride, of.count, time, VECTORS(forcing) + of.first);
}

static void take_slope(const dop853_lanes *lanes, vectors of, const double *q, const double *v, double *a) {
    const lanes_view view = view_of(lanes, of, q, v, a);
    lanes->flow(&view);
}

static void take_switches(const dop853_lanes *lanes, vectors of, const double *q, const double *v, double *a,
                          double *value, double *rate) {
    const lanes_view view = view_of(lanes, of, q, v, a);
    lanes->switches(&view, (vec *)value + of.first, rate ? (vec *)rate + of.first : NULL);
}

/// Vectors in the sums of slopes at a time: those of a pair, or two.
enum { SUMMED_TOGETHER = 2 };

/// `count` vectors from the first, `step` apart, of the state at which slope `number` is taken. The last slope counts
/// for velocities alone.
VECTOR_INLINE void take_stage(const dop853_lanes *lanes, int number, size_t first, size_t step, size_t count,
                              vec *out_q, vec *out_v) {
    const slope_sums *sums = &lanes->sums.stage[number];
    const vec *q = VECTORS(q), *v = VECTORS(v), *h = VECTORS(lengths), c = v_set(dop853_c[number]);
    const vec *slopes = VECTORS(k[0]);
    const size_t last = sums->count - 1;
    vec position[PAIR_DEGREES], velocity[PAIR_DEGREES];
    for (size_t r = 0; r < count; r++) position[r] = velocity[r] = v_set(0.0);
    for (size_t j = 0; j < last; j++) {
        const vec *slope = slopes + sums->place[j] + first;
        const vec by_position = v_set(sums->weight[j][POSITION]), by_velocity = v_set(sums->weight[j][VELOCITY]);
        for (size_t r = 0; r < count; r++) {
            position[r] = v_fma(by_position, slope[r * step], position[r]);
            velocity[r] = v_fma(by_velocity, slope[r * step], velocity[r]);
        }
    }
    const vec *slope = slopes + sums->place[last], weight = v_set(sums->weight[last][VELOCITY]);
    for (size_t r = 0; r < count; r++) {
        const size_t i = first + r * step;
        const vec total = v_fma(weight, slope[i], velocity[r]);
        out_q[i] = v_fma(h[i], v_fma(h[i], position[r], v_mul(c, v[i])), q[i]);
        out_v[i] = v_fma(h[i], total, v[i]);
    }
}

static void take_slopes_by_stages(const dop853_lanes *lanes, int from, int to) {
    const size_t all = lanes->degrees * lanes->stride, even = all - all % SUMMED_TOGETHER;
    for (int number = from; number < to; number++) {
        const bool end = number == DOP853_STAGES;
        double *q = end ? lanes->end_q : lanes->stage_q, *v = end ? lanes->end_v : lanes->stage_v;
        // The result's slope is taken at the time of the last stage.
        if (!end) take_forcing(lanes, all_of(lanes), dop853_c[number], lanes->length);
        for (size_t i = 0; i < even; i += SUMMED_TOGETHER)
            take_stage(lanes, number, i, 1, SUMMED_TOGETHER, (vec *)q, (vec *)v);
        if (even < all) take_stage(lanes, number, even, 1, 1, (vec *)q, (vec *)v);
        take_slope(lanes, all_of(lanes), q, v, lanes->k[number]);
    }
}

#include "dop853_pair.inc"

/// Slopes from <= number < to; the last stage's before the result's.
static void take_slopes(const dop853_lanes *lanes, int from, int to) {
    if (!take_slopes_of_pairs(lanes, from, to)) take_slopes_by_stages(lanes, from, to);
}

// ---------------------------------------------------------------- error

/// The largest of the coordinates from <= d < to of vector k, displacement or velocity, in both states.
VECTOR_INLINE vec group_size(const vec *q, const vec *v, const vec *end_q, const vec *end_v, size_t stride, size_t k,
                             size_t from, size_t to) {
    vec size = v_set(0.0);
    for (size_t d = from, i = from * stride + k; d < to; d++, i += stride) {
        const vec one = v_max(v_abs(q[i]), v_abs(v[i])), other = v_max(v_abs(end_q[i]), v_abs(end_v[i]));
        size = v_max(size, v_max(one, other));
    }
    return size;
}

/// The error of a degree, of its position times h, and of its velocity: the square, without tolerance.
static inline vec square_of(vec h, vec position, vec velocity) {
    const vec q = v_mul(h, position);
    return v_fma(q, q, v_mul(velocity, velocity));
}

/// Errors of `count` vectors from the first, `step` apart, by the four sums.
VECTOR_INLINE void sum_errors(const dop853_lanes *lanes, size_t first, size_t step, size_t count, vec *q5, vec *v5,
                              vec *q3, vec *v3) {
    const slope_sums *sums = &lanes->sums.error;
    const vec *slopes = VECTORS(k[0]);
    vec total[MAX_SUMS][PAIR_DEGREES];
    for (size_t s = 0; s < MAX_SUMS; s++)
        for (size_t r = 0; r < count; r++) total[s][r] = v_set(0.0);
    for (size_t j = 0; j < sums->count; j++) {
        const vec *slope = slopes + sums->place[j] + first;
        for (size_t s = 0; s < MAX_SUMS; s++) {
            const vec weight = v_set(sums->weight[j][s]);
            for (size_t r = 0; r < count; r++) total[s][r] = v_fma(weight, slope[r * step], total[s][r]);
        }
    }
    for (size_t r = 0; r < count; r++) {
        const size_t i = first + r * step;
        q5[i] = total[0][r];
        v5[i] = total[1][r];
        q3[i] = total[2][r];
        v3[i] = total[3][r];
    }
}

/// The square of the error of vector k over the tolerance of all coordinates, as stepper.c has it; not a number where
/// the end is none. Its coordinates' errors are in q5 ... v3.
VECTOR_INLINE void take_error(const dop853_lanes *lanes, size_t group_count, const size_t *groups, size_t stride,
                              size_t k, const vec *q5, const vec *v5, const vec *q3, const vec *v3) {
    const size_t degrees = groups[group_count];
    const vec *q = VECTORS(q), *v = VECTORS(v), *end_q = VECTORS(end_q), *end_v = VECTORS(end_v);
    const vec *last = VECTORS(k[DOP853_STAGES]), h = VECTORS(length)[k];
    const vec rtol = v_set(lanes->rtol), atol = v_set(lanes->atol);
    vec square5 = v_set(0.0), square3 = v_set(0.0), most = v_set(0.0), nothing = v_set(0.0);
    for (size_t g = 0; g < group_count; g++) {
        const vec size = group_size(q, v, end_q, end_v, stride, k, groups[g], groups[g + 1]);
        const vec per = v_div(v_set(1.0), v_fma(rtol, size, atol));
        vec own5 = v_set(0.0), own3 = v_set(0.0);
        for (size_t d = groups[g], i = d * stride + k; d < groups[g + 1]; d++, i += stride) {
            own5 = v_add(own5, square_of(h, q5[i], v5[i]));
            own3 = v_add(own3, square_of(h, q3[i], v3[i]));
            nothing = v_add(nothing, v_sub(last[i], last[i]));
        }
        square5 = v_fma(v_mul(per, per), own5, square5);
        square3 = v_fma(v_mul(per, per), own3, square3);
        most = v_max(most, size);
    }
    const vec mixed = v_fma(v_set(0.01), square3, square5);
    const vec some = v_max(v_mul(v_set(2.0 * (double)degrees), mixed), v_set(0x1p-960));
    const vec error = v_div(v_mul(v_mul(h, h), v_mul(square5, square5)), some);
    VECTORS(error)[k] = v_add(error, v_add(nothing, v_sub(mixed, mixed)));
    VECTORS(size)[k] = most;
}

static const size_t pair_groups[] = {0, 2, 4};

static void take_errors(const dop853_lanes *lanes) {
    const size_t degrees = lanes->degrees, stride = lanes->stride;
    vec *q5 = VECTORS(stage_q), *v5 = VECTORS(stage_v);
    vec *q3 = VECTORS(k[DOP853_STAGES + 1]), *v3 = VECTORS(k[DOP853_STAGES + 2]);
    if (lanes->pair) {
        for (size_t k = 0; k < PAIR_STRIDE; k++) {
            sum_errors(lanes, k, PAIR_STRIDE, PAIR_DEGREES, q5, v5, q3, v3);
            take_error(lanes, PAIR_STATIONS, pair_groups, PAIR_STRIDE, k, q5, v5, q3, v3);
        }
        return;
    }
    const size_t all = degrees * stride, even = all - all % SUMMED_TOGETHER;
    for (size_t i = 0; i < even; i += SUMMED_TOGETHER) sum_errors(lanes, i, 1, SUMMED_TOGETHER, q5, v5, q3, v3);
    if (even < all) sum_errors(lanes, even, 1, 1, q5, v5, q3, v3);
    FOR_VECTORS take_error(lanes, lanes->group_count, lanes->groups, stride, k, q5, v5, q3, v3);
}

// ---------------------------------------------------------------- the beginning of a revolution

/// The mean square of a state's (q, v) parts over the tolerance at x.
static inline vec mean_square(const dop853_lanes *lanes, size_t k, const vec *q, const vec *v) {
    const vec *xq = VECTORS(q), *xv = VECTORS(v);
    vec sum = v_set(0.0);
    for (size_t g = 0; g < lanes->group_count; g++) {
        const size_t from = lanes->groups[g], to = lanes->groups[g + 1];
        const vec size = group_size(xq, xv, xq, xv, lanes->stride, k, from, to);
        const vec scale = v_fma(v_set(lanes->rtol), size, v_set(lanes->atol));
        vec own = v_set(0.0);
        for (size_t d = to; d > from; d--)
            own = v_fma(v[(d - 1) * lanes->stride + k], v[(d - 1) * lanes->stride + k], own);
        for (size_t d = to; d > from; d--)
            own = v_fma(q[(d - 1) * lanes->stride + k], q[(d - 1) * lanes->stride + k], own);
        sum = v_add(sum, v_div(own, v_mul(scale, scale)));
    }
    return v_div(sum, v_set(2.0 * (double)lanes->degrees));
}

/// A length for the first step of those of vector k that start, as stepper.c has it.
static void take_first_length(const dop853_lanes *lanes, size_t k) {
    const vec *first = VECTORS(k[0]), *second = VECTORS(k[1]);
    vec *change_q = VECTORS(end_q), *change_v = VECTORS(end_v);
    const vec small = v_set(1e-10), shortest = v_set(1e-6 * lanes->period), longest = v_set(lanes->period);
    const vec size = mean_square(lanes, k, VECTORS(q), VECTORS(v));
    const vec slope = mean_square(lanes, k, VECTORS(v), first);
    const vec guess = v_mul(v_set(0.01), v_sqrt(v_div(size, v_max(slope, small))));
    const vec trial = v_min(v_select(v_less(v_min(size, slope), small), shortest, guess), longest);
    VECTORS(theta)[k] = trial;
    FOR_DEGREES_OF(k) {
        VECTORS(stage_q)[i] = v_fma(trial, VECTORS(v)[i], VECTORS(q)[i]);
        VECTORS(stage_v)[i] = v_fma(trial, first[i], VECTORS(v)[i]);
    }
    take_forcing(lanes, only(k), 1.0, lanes->theta);
    take_slope(lanes, only(k), lanes->stage_q, lanes->stage_v, lanes->k[1]);
    FOR_DEGREES_OF(k) {
        change_q[i] = v_sub(VECTORS(stage_v)[i], VECTORS(v)[i]);
        change_v[i] = v_sub(second[i], first[i]);
    }
    const vec change = v_div(mean_square(lanes, k, change_q, change_v), v_mul(trial, trial));
    const vec most = v_sqrt(v_max(slope, change));
    const vec longer = v_sqrt(v_sqrt(v_sqrt(v_div(v_set(0.01), v_max(most, v_set(1e-15))))));
    const vec h = v_min(longer, v_mul(v_set(100.0), trial));
    VECTORS(h)[k] = v_select(is_set(VECTORS(starting)[k]), h, VECTORS(h)[k]);
}

/// The sides of the switches by the state, of those of vector k that start.
static void find_sides(const dop853_lanes *lanes, size_t k) {
    if (lanes->switch_count == 0) return;
    take_switches(lanes, only(k), lanes->q, lanes->v, lanes->k[0], lanes->end_value, NULL);
    for (size_t s = 0; s < lanes->switch_count; s++) {
        const size_t i = s * lanes->stride + k;
        const vec_mask starting = is_set(VECTORS(starting)[k]);
        const vec side = v_select(v_less(v_set(0.0), VECTORS(end_value)[i]), v_set(1.0), v_set(-1.0));
        VECTORS(sides)[i] = v_select(starting, side, VECTORS(sides)[i]);
        VECTORS(held)[i] = v_select(starting, v_set(0.0), VECTORS(held)[i]);
    }
    for (size_t s = 0; s < lanes->switch_count; s++)
        for (size_t slot = k * VECTOR_LANES; slot < (k + 1) * VECTOR_LANES; slot++)
            if (lanes->starting[slot] > 0.5 && fabs(lanes->end_value[s * lanes->slots + slot]) < 1e-6)
                dop853_find_sides(lanes, slot);
}

/// Slopes and switching functions at t anew where vector k asks for it.
static void refresh(const dop853_lanes *lanes, size_t k) {
    const vec_mask fresh = is_set(VECTORS(fresh)[k]);
    if (!v_any(fresh)) return;
    take_forcing(lanes, only(k), 0.0, lanes->h);
    take_slope(lanes, only(k), lanes->q, lanes->v, lanes->stage_v);
    FOR_DEGREES_OF(k) VECTORS(k[0])[i] = v_select(fresh, VECTORS(stage_v)[i], VECTORS(k[0])[i]);
    if (lanes->switch_count > 0)
        take_switches(lanes, only(k), lanes->q, lanes->v, lanes->k[0], lanes->value, lanes->rate);
    VECTORS(fresh)[k] = v_set(0.0);
}

/// Begins the revolutions of those of vector k that start.
static void begin(const dop853_lanes *lanes, size_t k) {
    const vec zero = v_set(0.0), one = v_set(1.0);
    double *const zeros[] = {lanes->t,        lanes->rejected, lanes->landing, lanes->switchings,
                             lanes->attempts, lanes->taken,    lanes->h};
    double *const ones[] = {lanes->running, lanes->before, lanes->fresh, lanes->instant};
    const vec_mask starting = is_set(VECTORS(starting)[k]);
    if (!v_any(starting)) return;
    for (size_t r = 0; r < sizeof zeros / sizeof *zeros; r++)
        ((vec *)zeros[r])[k] = v_select(starting, zero, ((vec *)zeros[r])[k]);
    for (size_t r = 0; r < sizeof ones / sizeof *ones; r++)
        ((vec *)ones[r])[k] = v_select(starting, one, ((vec *)ones[r])[k]);
    find_sides(lanes, k);
    refresh(lanes, k);
    take_first_length(lanes, k);
    VECTORS(starting)[k] = zero;
}

// ---------------------------------------------------------------- a step

/// Lengths to try: not beyond the revolution's end, and no sliver before it.
static void choose_lengths(const dop853_lanes *lanes) {
    const vec end = v_set(lanes->period), most = v_set(lanes->switch_count > 0 ? lanes->period / 8.0 : lanes->period);
    FOR_VECTORS {
        const vec left = v_sub(end, VECTORS(t)[k]), h = v_min(VECTORS(h)[k], most);
        vec length = v_select(v_less(left, v_add(h, h)), v_mul(v_set(0.5), left), h);
        length = v_select(v_less(v_mul(v_set(1.01), h), left), length, left);
        length = v_select(is_set(VECTORS(landing)[k]), VECTORS(length)[k], length);
        VECTORS(length)[k] = v_select(is_set(VECTORS(running)[k]), length, v_set(0.0));
    }
    FOR_DEGREES VECTORS(lengths)[i] = VECTORS(length)[k];
}

/// Whether switching function `s` keeps its sign by far. Of a function that begins at zero the first coefficient is
/// left out and the others divided by theta.
static vec clear_of(const dop853_lanes *lanes, size_t s, size_t k) {
    const size_t i = s * lanes->stride + k;
    const vec side = VECTORS(sides)[i], third = v_mul(v_set(1.0 / 3.0), v_mul(side, VECTORS(length)[k]));
    const vec b0 = v_mul(side, VECTORS(value)[i]), rise = v_mul(third, VECTORS(rate)[i]), b1 = v_add(b0, rise);
    const vec b3 = v_mul(side, VECTORS(end_value)[i]), b2 = v_fnma(third, VECTORS(end_rate)[i], b3);
    const vec free = bernstein_clear(b0, b1, b2, b3);
    const vec c0 = v_mul(v_set(3.0), rise), c1 = v_mul(v_set(1.5), b2);
    const vec bend = v_abs(v_add(v_sub(c0, v_add(c1, c1)), b3));
    const vec leaves = flag(v_less(bend, v_min(v_min(c0, c1), b3)));
    return v_select(is_set(VECTORS(held)[i]), leaves, free);
}

/// 1/sqrt(a) for a normal a > 0 to five digits: a seed from its bits, then one step of the series.
static inline vec rough_inverse_root(vec a) {
    const vec r = v_seed_half(0x5fe6eb50c7b537a9, a), e = v_fnma(v_mul(a, r), r, v_set(1.0));
    const vec series = v_fma(v_fma(v_set(0.3125), e, v_set(0.375)), e, v_set(0.5));
    return v_fma(v_mul(r, e), series, r);
}

/// Powers of the error that lengths of steps follow.
typedef struct error_powers {
    vec grow;   ///< err^(-3/32)
    vec shrink; ///< err^(-1/8)
    vec kept;   ///< err^(1/16)
} error_powers;

static inline error_powers powers_of(vec square) {
    vec p = v_max(v_min(square, v_set(1e16)), v_set(1e-16));
    for (int i = 0; i < 5; i++) p = rough_inverse_root(p); // err^-1, err^1/2, err^-1/4, err^1/8, err^-1/16
    const vec root = rough_inverse_root(p);
    return (error_powers){v_mul(v_mul(p, p), root), v_mul(p, p), v_mul(root, root)};
}

/// Judges the step of vector k: writes the next length and what is special, and gives the lanes that take the step.
static vec judge(const dop853_lanes *lanes, size_t k, error_powers power) {
    const vec zero = v_set(0.0), one = v_set(1.0), third = v_set(1.0 / 3.0), six = v_set(6.0), safety = v_set(0.92);
    const vec tried = VECTORS(length)[k], h = VECTORS(h)[k], running = VECTORS(running)[k];
    const vec square = VECTORS(error)[k], rejected = VECTORS(rejected)[k];
    const vec good = flag(v_less(square, one)), number = flag(v_less(square, v_set(INFINITY)));
    vec clear = flag(v_less(VECTORS(size)[k], v_set(lanes->limit)));
    for (size_t s = 0; s < lanes->switch_count; s++) clear = v_min(clear, clear_of(lanes, s, k));
    vec grow = v_max(third, v_min(six, v_mul(v_mul(safety, power.grow), VECTORS(before)[k])));
    grow = v_select(is_set(rejected), v_min(grow, one), grow);
    vec shrink = v_max(third, v_min(safety, v_mul(safety, power.shrink)));
    shrink = v_select(is_set(number), shrink, v_set(0.1));
    // A step that the revolution's end cut short says little of how long the next may be.
    const vec uncut = v_select(v_less(tried, h), v_select(is_set(rejected), zero, h), zero);
    const vec longer = v_max(uncut, v_mul(tried, grow)), shorter = v_mul(tried, shrink);
    const vec next = v_select(is_set(good), longer, shorter);
    const vec attempts = v_add(VECTORS(attempts)[k], running);
    const vec lost = v_max(v_min(v_sub(one, good), flag(v_less(next, v_set(0x1p-48 * lanes->period)))),
                           flag(v_less(v_set(MAX_ATTEMPTS), attempts)));
    VECTORS(attempts)[k] = attempts;
    const vec look = v_max(flag(v_less(zero, VECTORS(landing)[k])), v_max(lost, v_min(good, v_sub(one, clear))));
    const vec special = v_min(running, look), usual = v_min(running, v_sub(one, special));
    VECTORS(special)[k] = special;
    VECTORS(h)[k] = v_select(is_set(usual), next, h);
    VECTORS(before)[k] = v_select(is_set(v_min(usual, good)), v_max(power.kept, v_set(0.5623)), VECTORS(before)[k]);
    VECTORS(rejected)[k] = v_select(is_set(usual), v_sub(one, good), rejected);
    return v_min(usual, good);
}

/// Lets the lanes that take the step go on at its end.
VECTOR_INLINE void commit(const dop853_lanes *lanes, size_t degrees, size_t stride, size_t k, vec take) {
    const vec_mask taken = is_set(take);
    const vec length = VECTORS(length)[k], t = VECTORS(t)[k], end = v_set(lanes->period);
    const vec after = v_select(v_less(length, v_sub(end, t)), v_add(t, length), end);
    VECTORS(begin)[k] = t;
    VECTORS(taken)[k] = v_select(taken, length, v_set(0.0));
    VECTORS(t)[k] = v_select(taken, after, t);
    VECTORS(running)[k] = v_min(VECTORS(running)[k], flag(v_less(VECTORS(t)[k], end)));
    for (size_t d = 0; d < degrees; d++) {
        const size_t i = d * stride + k;
        VECTORS(q)[i] = v_select(taken, VECTORS(end_q)[i], VECTORS(q)[i]);
        VECTORS(v)[i] = v_select(taken, VECTORS(end_v)[i], VECTORS(v)[i]);
        VECTORS(k[0])[i] = v_select(taken, VECTORS(k[DOP853_STAGES])[i], VECTORS(k[0])[i]);
    }
    for (size_t s = 0; s < lanes->switch_count; s++) {
        const size_t i = s * stride + k;
        VECTORS(value)[i] = v_select(taken, VECTORS(end_value)[i], VECTORS(value)[i]);
        VECTORS(rate)[i] = v_select(taken, VECTORS(end_rate)[i], VECTORS(rate)[i]);
        VECTORS(held)[i] = v_select(taken, v_set(0.0), VECTORS(held)[i]);
    }
}

#include "dop853_observe.inc"

/// Tries one step in all slots.
static void take_step(const dop853_lanes *lanes) {
    choose_lengths(lanes);
    take_slopes(lanes, 1, DOP853_STAGES + 1);
    take_errors(lanes);
    if (lanes->switch_count > 0)
        take_switches(lanes, all_of(lanes), lanes->end_q, lanes->end_v, lanes->k[DOP853_STAGES], lanes->end_value,
                      lanes->end_rate);
    if (lanes->observing) take_polynomials(lanes);
    error_powers power[MAX_GROUP]; // apart, so that they hide each other's latency
    FOR_VECTORS power[k] = powers_of(VECTORS(error)[k]);
    FOR_VECTORS {
        const vec take = judge(lanes, k, power[k]);
        if (lanes->pair)
            commit(lanes, PAIR_DEGREES, PAIR_STRIDE, k, take);
        else
            commit(lanes, lanes->degrees, lanes->stride, k, take);
        if (!v_any(is_set(VECTORS(special)[k]))) continue;
        for (size_t slot = k * VECTOR_LANES; slot < (k + 1) * VECTOR_LANES; slot++)
            if (lanes->special[slot] > 0.5) dop853_special(lanes, slot);
    }
    if (lanes->observing) observe(lanes);
    FOR_VECTORS refresh(lanes, k);
}

static bool any_runs(const dop853_lanes *lanes) {
    vec run = v_set(0.0);
    FOR_VECTORS run = v_max(run, VECTORS(running)[k]);
    return v_any(is_set(run));
}

void ISA(dop853_lanes)(const dop853_lanes *lanes) {
    for (;;) {
        if (dop853_fill(lanes)) FOR_VECTORS begin(lanes, k);
        if (!any_runs(lanes)) return;
        take_step(lanes);
    }
}
