// The method of Dormand and Prince for x'' = f(t, x, x') over vector lanes, compiled once for every instruction set.
//
// A sum of slopes is computed for a few rows at a time: the partial sums stay in registers, and a slope's weight is
// loaded once for these rows.
#include "adaptive_lanes.inc"

/// SUMMED_TOGETHER: vectors for which slopes are summed at a time. A structure with its own loops sums all of its
/// vectors, at most MAX_TOGETHER.
enum { SUMMED_TOGETHER = 2, MAX_TOGETHER = 4 };

/// First rows of a set: of the state (set 0), or of a perturbation.
typedef struct set_place {
    size_t q, v;
} set_place;

static inline set_place place_of_set(const adaptive_lanes *lanes, size_t set) {
    return (set_place){set * lanes->degrees * lanes->stride, set * lanes->rates * lanes->stride};
}

/// Computes the state, or a perturbation, at which slope `number` is taken: `count` vectors from `first` on, `step`
/// apart. The last slope contributes to velocities only.
VECTOR_INLINE void take_stage(const adaptive_lanes *lanes, int number, set_place set, size_t first, size_t step,
                              size_t count, vec *out_q, vec *out_v) {
    const slope_sums *sums = &lanes->dop853.sums.stage[number];
    const vec *q = VECTORS(q) + set.q, *v = VECTORS(v) + set.v, *h = VECTORS(lengths), c = v_set(dop853_c[number]);
    const vec *slopes = VECTORS(dop853.k[0]) + set.v;
    const size_t last = sums->count - 1;
    vec position[MAX_TOGETHER], velocity[MAX_TOGETHER];
    // Sum the slopes for all rows of the group.
    for (size_t r = 0; r < count; r++) position[r] = velocity[r] = v_set(0.0);
    for (size_t j = 0; j < last; j++) {
        const vec *slope = slopes + sums->place[j] + first;
        const vec by_position = v_set(sums->weight[j][POSITION]), by_velocity = v_set(sums->weight[j][VELOCITY]);
        for (size_t r = 0; r < count; r++) {
            position[r] = v_fma(by_position, slope[r * step], position[r]);
            velocity[r] = v_fma(by_velocity, slope[r * step], velocity[r]);
        }
    }
    // Add the last slope, and step from the beginning.
    const vec *slope = slopes + sums->place[last], weight = v_set(sums->weight[last][VELOCITY]);
    for (size_t r = 0; r < count; r++) {
        const size_t i = first + r * step;
        const vec total = v_fma(weight, slope[i], velocity[r]);
        out_q[set.q + i] = v_fma(h[i], v_fma(h[i], position[r], v_mul(c, v[i])), q[i]);
        out_v[set.v + i] = v_fma(h[i], total, v[i]);
    }
}

/// Computes one of the sums of slopes, for up to MAX_TOGETHER vectors of the rates from `first` on.
VECTOR_INLINE void sum_rates(const adaptive_lanes *lanes, const slope_sums *sums, size_t which, size_t first,
                             size_t count, vec *sum) {
    for (size_t r = 0; r < count; r++) sum[r] = v_set(0.0);
    for (size_t j = 0; j < sums->count; j++) {
        const vec *slope = VECTORS(dop853.k[0]) + sums->place[j] + first, weight = v_set(sums->weight[j][which]);
        for (size_t r = 0; r < count; r++) sum[r] = v_fma(weight, slope[r], sum[r]);
    }
}

/// Computes `out` for all first-order states of a set: `from` plus h times one of the sums; `from` may be NULL.
static void sum_states(const adaptive_lanes *lanes, const slope_sums *sums, set_place set, const vec *from, vec *out) {
    const size_t last = set.v + lanes->rates * lanes->stride;
    const vec *h = VECTORS(length), zero = v_set(0.0);
    for (size_t i = set.v + lanes->degrees * lanes->stride; i < last; i += MAX_TOGETHER) {
        vec sum[MAX_TOGETHER];
        const size_t count = last - i < MAX_TOGETHER ? last - i : MAX_TOGETHER;
        if (count == MAX_TOGETHER)
            sum_rates(lanes, sums, VELOCITY, i, MAX_TOGETHER, sum);
        else
            sum_rates(lanes, sums, VELOCITY, i, count, sum);
        for (size_t r = 0; r < count; r++) {
            const size_t k = lanes->stride == 1 ? 0 : (i + r) % lanes->stride; // divisions are slow
            out[i + r] = v_fma(h[k], sum[r], from ? from[i + r] : zero);
        }
    }
}

/// Computes the whole state at which slope `number` is taken, and the perturbations.
static void enter_stage(const adaptive_lanes *lanes, int number, vec *q, vec *v) {
    const size_t all = lanes->degrees * lanes->stride;
    for (size_t n = 0; n <= lanes->tangents; n++) {
        const set_place set = place_of_set(lanes, n);
        size_t i = 0;
        for (; i + MAX_TOGETHER <= all; i += MAX_TOGETHER) take_stage(lanes, number, set, i, 1, MAX_TOGETHER, q, v);
        for (; i < all; i++) take_stage(lanes, number, set, i, 1, 1, q, v);
        sum_states(lanes, &lanes->dop853.sums.stage[number], set, VECTORS(v), v);
    }
}

/// Returns the memory for the divergence of slope `number`.
static inline double *divergence_of(const adaptive_lanes *lanes, int number) {
    return lanes->dop853.divergence + (size_t)number * lanes->slots;
}

static void take_slopes_by_stages(const adaptive_lanes *lanes, int from, int to) {
    for (int number = from; number < to; number++) {
        const bool end = number == DOP853_STAGES;
        double *q = end ? lanes->end_q : lanes->stage_q, *v = end ? lanes->end_v : lanes->stage_v;
        // The slope of the result is taken at the time of the last stage.
        if (!end) take_forcing(lanes, all_of(lanes), dop853_c[number], lanes->length);
        enter_stage(lanes, number, (vec *)q, (vec *)v);
        if (number <= DOP853_STAGES)
            take_all_slopes(lanes, all_of(lanes), q, v, lanes->dop853.k[number], divergence_of(lanes, number));
        else
            take_slope(lanes, all_of(lanes), q, v, lanes->dop853.k[number]);
    }
}

// ---------------------------------------------------------------- error

/// Computes the errors of `count` vectors of a set from `first` on, `step` apart, by the four sums.
VECTOR_INLINE void sum_errors(const adaptive_lanes *lanes, set_place set, size_t first, size_t step, size_t count,
                              vec *q5, vec *v5, vec *q3, vec *v3) {
    const slope_sums *sums = &lanes->dop853.sums.error;
    const vec *slopes = VECTORS(dop853.k[0]) + set.v;
    vec total[MAX_SUMS][MAX_TOGETHER];
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

/// Computes the squared error of vector k, divided by the tolerance of all coordinates, from both embedded formulas as
/// DOP853 weighs them. It is NaN if the state at the end is. The errors of the coordinates are in q5, v5, q3 and v3.
VECTOR_INLINE void take_error(const adaptive_lanes *lanes, size_t group_count, const size_t *groups, size_t states,
                              size_t stride, size_t k, const vec *q5, const vec *v5, const vec *q3, const vec *v3) {
    const size_t degrees = groups[group_count];
    const vec *q = VECTORS(q), *v = VECTORS(v), *end_q = VECTORS(end_q), *end_v = VECTORS(end_v);
    const vec *last = VECTORS(end_slope), h = VECTORS(length)[k];
    const vec rtol = v_set(lanes->rtol), atol = v_set(lanes->atol);
    vec square5 = v_set(0.0), square3 = v_set(0.0), most = v_set(0.0), nothing = v_set(0.0);
    // Degrees, group by group, with the tolerance by the group's size. `nothing` is 0, or NaN if a slope is.
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
    // The states of first order.
    for (size_t i = degrees * stride + k; i < (degrees + states) * stride; i += stride) {
        const slope_sums *sums = &lanes->dop853.sums.error;
        const vec size = state_size(lanes, v, end_v, i), per = v_div(v_set(1.0), v_fma(rtol, size, atol));
        vec own5, own3;
        sum_rates(lanes, sums, 1, i, 1, &own5);
        sum_rates(lanes, sums, 3, i, 1, &own3);
        own5 = v_mul(per, own5);
        own3 = v_mul(per, own3);
        square5 = v_fma(own5, own5, square5);
        square3 = v_fma(own3, own3, square3);
        nothing = v_add(nothing, v_sub(last[i], last[i]));
        most = v_max(most, size);
    }
    // The error of DOP853 from both formulas: h^2 e5^4/(e5^2 + 0.01 e3^2), NaN if any number is.
    const vec mixed = v_fma(v_set(0.01), square3, square5);
    const vec some = v_max(v_mul(v_set((double)(2 * degrees + states)), mixed), v_set(0x1p-960));
    const vec error = v_div(v_mul(v_mul(h, h), v_mul(square5, square5)), some);
    VECTORS(error)[k] = v_add(error, v_add(nothing, v_sub(mixed, mixed)));
    VECTORS(size)[k] = most;
}

static void sum_all_errors(const adaptive_lanes *lanes, set_place set, vec *q5, vec *v5, vec *q3, vec *v3) {
    const size_t all = lanes->degrees * lanes->stride, even = all - all % SUMMED_TOGETHER;
    for (size_t i = 0; i < even; i += SUMMED_TOGETHER) sum_errors(lanes, set, i, 1, SUMMED_TOGETHER, q5, v5, q3, v3);
    if (even < all) sum_errors(lanes, set, even, 1, 1, q5, v5, q3, v3);
}

/// Returns the squared length of the rows of a set in vector k.
static inline vec square_length(const adaptive_lanes *lanes, set_place set, size_t k, const vec *q, const vec *v) {
    vec sum = v_set(0.0);
    FOR_DEGREES_OF(k) sum = v_fma(q[set.q + i], q[set.q + i], sum);
    FOR_RATES_OF(k) sum = v_fma(v[set.v + i], v[set.v + i], sum);
    return sum;
}

/// Tolerance of a perturbation, in units of rtol times its length. It is so loose that it does not change the steps of
/// a motion of ordinary size, in which the perturbation's error follows the state's. It limits the steps of a
/// negligible motion, for which the state alone would allow any length.
enum { LOOSER = 100 };

/// Returns the squared error of a perturbation divided by its tolerance. The equations of perturbations are linear, so
/// that there is no absolute tolerance.
static vec error_of_perturbation(const adaptive_lanes *lanes, set_place set, size_t k, const vec *q5, const vec *v5,
                                 const vec *q3, const vec *v3) {
    const slope_sums *sums = &lanes->dop853.sums.error;
    const vec h = VECTORS(length)[k];
    vec square5 = v_set(0.0), square3 = v_set(0.0);
    FOR_DEGREES_OF(k) {
        square5 = v_add(square5, square_of(h, q5[i], v5[i]));
        square3 = v_add(square3, square_of(h, q3[i], v3[i]));
    }
    FOR_STATES_OF(k) {
        vec own5, own3;
        sum_rates(lanes, sums, 1, set.v + i, 1, &own5);
        sum_rates(lanes, sums, 3, set.v + i, 1, &own3);
        square5 = v_fma(own5, own5, square5);
        square3 = v_fma(own3, own3, square3);
    }
    const vec before = square_length(lanes, set, k, VECTORS(q), VECTORS(v));
    const vec size = v_max(before, square_length(lanes, set, k, VECTORS(end_q), VECTORS(end_v)));
    const double tolerance = LOOSER * lanes->rtol;
    const vec some = v_mul(v_mul(v_set(tolerance * tolerance), size), v_fma(v_set(0.01), square3, square5));
    return v_div(v_mul(v_mul(h, h), v_mul(square5, square5)), v_max(some, v_set(0x1p-960)));
}

/// Raises each step's error to that of the worst perturbation, whose tolerance is looser (LOOSER). The NaN of a
/// perturbation is ignored.
static void take_errors_of_perturbations(const adaptive_lanes *lanes, vec *q5, vec *v5, vec *q3, vec *v3) {
    for (size_t n = 1; n <= lanes->tangents; n++) {
        const set_place set = place_of_set(lanes, n);
        sum_all_errors(lanes, set, q5, v5, q3, v3);
        FOR_VECTORS {
            const vec own = error_of_perturbation(lanes, set, k, q5, v5, q3, v3), error = VECTORS(error)[k];
            VECTORS(error)[k] = v_select(v_less(error, own), own, error);
        }
    }
}

static void take_errors_by_stages(const adaptive_lanes *lanes, vec *q5, vec *v5, vec *q3, vec *v3) {
    const size_t degrees = lanes->degrees, stride = lanes->stride;
    sum_all_errors(lanes, place_of_set(lanes, 0), q5, v5, q3, v3);
    FOR_VECTORS
    take_error(lanes, lanes->group_count, lanes->groups, lanes->rates - degrees, stride, k, q5, v5, q3, v3);
    take_errors_of_perturbations(lanes, q5, v5, q3, v3);
}

/// Integrates the divergence over the step, with the weights of the step's result.
static void take_volume(const adaptive_lanes *lanes) {
    FOR_VECTORS {
        vec sum = v_set(0.0);
        for (int i = 0; i < DOP853_STAGES; i++)
            sum = v_fma(v_set(dop853_a[DOP853_STAGES][i]), ((vec *)divergence_of(lanes, i))[k], sum);
        VECTORS(gained)[k] = v_mul(VECTORS(length)[k], sum);
    }
}

// ---------------------------------------------------------------- pairs

/// Computes cos and sin of t, from which add_angle computes the forcing.
static void take_base(const adaptive_lanes *lanes) {
    vec *base = VECTORS(dop853.base);
    FOR_VECTORS v_sincos(VECTORS(t)[k], &base[PAIR_STRIDE + k], &base[k]);
}

/// Computes the forcing at t + c h of vector k, for h up to an eighth of a revolution.
VECTOR_INLINE void add_angle(const adaptive_lanes *lanes, double c, size_t k) {
    const vec *base = VECTORS(dop853.base), cosine = base[k], sine = base[PAIR_STRIDE + k];
    const size_t apart = PAIR_STRIDE;
    vec *forcing = VECTORS(forcing) + k, s, co;
    v_sincos_small(v_mul(v_set(c), VECTORS(length)[k]), &s, &co);
    const vec x = v_fms(cosine, co, v_mul(sine, s)), y = v_fma(sine, co, v_mul(cosine, s));
    forcing[COS_TAU * apart] = x;
    forcing[SIN_TAU * apart] = y;
    forcing[COS_2TAU * apart] = v_mul(v_sub(x, y), v_add(x, y));
    forcing[SIN_2TAU * apart] = v_mul(v_add(x, x), y);
}

/// Returns the positions at which slope `number` is taken: the step's end for the result, otherwise the stage.
static inline vec *dop853_place(const adaptive_lanes *lanes, int number) {
    return number == DOP853_STAGES ? VECTORS(end_q) : VECTORS(stage_q);
}
static inline vec *speed_of(const adaptive_lanes *lanes, int number) {
    return number == DOP853_STAGES ? VECTORS(end_v) : VECTORS(stage_v);
}

#include "dop853_pair.inc"

/// Computes the slopes from <= number < to.
static void take_slopes(const adaptive_lanes *lanes, int from, int to) {
    if (lanes->pair_laws)
        pair_take_slopes(lanes, from, to);
    else
        take_slopes_by_stages(lanes, from, to);
}

static void take_errors(const adaptive_lanes *lanes) {
    vec *q5 = VECTORS(stage_q), *v5 = VECTORS(stage_v);
    vec *q3 = VECTORS(dop853.k[DOP853_STAGES + 1]), *v3 = VECTORS(dop853.k[DOP853_STAGES + 2]);
    if (lanes->pair_laws)
        pair_take_errors(lanes, q5, v5, q3, v3);
    else
        take_errors_by_stages(lanes, q5, v5, q3, v3);
}

/// Tries the step: computes the state at its end, the slope there and the error.
static void try_step(const adaptive_lanes *lanes) {
    take_slopes(lanes, 1, DOP853_STAGES + 1);
    take_errors(lanes);
    if (lanes->tangents > 0) take_volume(lanes);
}

// ---------------------------------------------------------------- interpolant

enum { METHOD_DENSE = DENSE };

/// Computes the cubic of row and vector j of the state from values and slopes at both ends of a step of length h.
VECTOR_INLINE void take_cubic(const adaptive_lanes *lanes, size_t j, vec h, vec begin, vec end, vec first, vec last) {
    const vec way = v_sub(end, begin);
    VECTORS(dense[0])[j] = begin;
    VECTORS(dense[1])[j] = way;
    VECTORS(dense[2])[j] = v_fms(h, first, way);
    VECTORS(dense[3])[j] = v_fnma(h, v_add(first, last), v_mul(v_set(2.0), way));
}

/// Computes the interpolant of the step tried: a cubic, and the polynomials that DOP853 adds with three more slopes
/// (Hairer, Norsett, Wanner 1993, II.6).
static void take_polynomials(const adaptive_lanes *lanes) {
    const size_t after = lanes->degrees * lanes->stride;
    const vec *q = VECTORS(q), *v = VECTORS(v), *end_q = VECTORS(end_q), *end_v = VECTORS(end_v);
    const vec *first = VECTORS(slope), *last = VECTORS(end_slope), *h = VECTORS(length);
    // Compute three more slopes, and the cubic.
    take_slopes(lanes, DOP853_STAGES + 1, DOP853_SLOPES);
    FOR_DEGREES take_cubic(lanes, i, h[k], q[i], end_q[i], v[i], end_v[i]);
    FOR_ROWS(0, lanes->rates) take_cubic(lanes, after + i, h[k], v[i], end_v[i], first[i], last[i]);
    // Compute the polynomials of positions, which drift with the velocity, and of velocities.
    for (size_t p = 0; p < DOP853_DENSE; p++) {
        const slope_sums *sums = &lanes->dop853.sums.dense[p];
        const vec *slopes = VECTORS(dop853.k[0]), drift = v_set(lanes->dop853.sums.dense_drift[p]);
        vec *out_q = VECTORS(dense[4 + p]), *out_v = out_q + after;
        FOR_DEGREES {
            vec position = v_set(0.0), velocity = v_set(0.0);
            for (size_t j = 0; j < sums->count; j++) {
                const vec slope = slopes[sums->place[j] + i];
                position = v_fma(v_set(sums->weight[j][POSITION]), slope, position);
                velocity = v_fma(v_set(sums->weight[j][VELOCITY]), slope, velocity);
            }
            out_q[i] = v_mul(h[k], v_fma(h[k], position, v_mul(drift, v[i])));
            out_v[i] = v_mul(h[k], velocity);
        }
        sum_states(lanes, sums, place_of_set(lanes, 0), NULL, out_v);
    }
}

// ---------------------------------------------------------------- lengths of steps

/// Returns the powers for errors of order 8, for proportional and integral control (Gustafsson 1991). The step grows by
/// err^(-3/32) times err_before^(1/16) times 0.92, so that errors settle at 0.92^32 = 0.07 of the tolerance. Only
/// square roots are used, no pow(), so that the result has the same bits on every platform.
static inline error_powers powers_of(vec square) {
    vec p = v_max(v_min(square, v_set(1e16)), v_set(1e-16));
    for (int i = 0; i < 5; i++) p = rough_inverse_root(p); // err^-1, err^1/2, err^-1/4, err^1/8, err^-1/16
    const vec root = rough_inverse_root(p);
    return (error_powers){v_mul(v_mul(p, p), root), v_mul(p, p), v_mul(root, root)};
}

#if VECTOR_ISA == VECTOR_SCALAR
static void take_stage_of_slot(const adaptive_lanes *slot, int number) {
    if (number > 0)
        enter_stage(slot, number, slot->stage_q, slot->stage_v);
    else
        memcpy(slot->stage_v, slot->v, slot->rates * sizeof(double));
}
#endif

#define METHOD_REVOLVE ISA(dop853_lanes)
#define METHOD_SLOT dop853_slot
#define SOLVE_SLOT NULL
#include "adaptive_revolve.inc"
