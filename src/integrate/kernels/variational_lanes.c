// RK4 in Nystrom's form for x'' = f(t, x, x') and its variational equations over vector lanes, compiled once for every
// instruction set: the steps of rk4_lanes.c and their exact derivative.
#include "variational_lanes.h"
#include "rk4_scheme.h"

enum { NOTE = 8 }; ///< orthonormalisations whose lengths are multiplied before a logarithm is taken

static void take_slope(const variational_lanes *lanes, const double *forcing, const vec *q, const vec *v, int stage,
                       vec *slope) {
    vec *now = (vec *)lanes->now;
    for (size_t i = 0; i < lanes->forcing_count; i++)
        for (size_t k = 0; k < lanes->stride; k++) now[i * lanes->stride + k] = v_set(forcing[i]);
    const lanes_view view = {.model = lanes->model,
                             .stride = lanes->stride,
                             .vectors = lanes->stride,
                             .numbers = lanes->numbers,
                             .forcing = now,
                             .tangents = lanes->disturbances,
                             .q = q,
                             .v = v,
                             .a = slope,
                             .divergence = lanes->divergence[stage]};
    lanes->flow(&view);
}

static void add_divergence(const variational_lanes *lanes) {
    const vec sixth = v_set(lanes->step / 6.0), two = v_set(2.0);
    vec *volume = (vec *)lanes->volume;
    vec *const *d = (vec *const *)lanes->divergence;
    for (size_t k = 0; k < lanes->stride; k++)
        volume[k] = v_fma(sixth, v_fma(two, v_add(d[1][k], d[2][k]), v_add(d[0][k], d[3][k])), volume[k]);
}

/// Lets the scheme's stage or end enter for the state and all disturbances, which lie in a line where there are no
/// states of first order.
#define ENTER(stage)                                                                                                   \
    for (size_t n = 0; n < (even ? 1 : sets); n++) {                                                                   \
        const scheme s = scheme_of_set(&all, n * places, n * rates);                                                   \
        for (size_t i = 0; i < (even ? sets : 1) * places; i++) stage(&s, i);                                          \
        for (size_t i = places; i < rates; i++) stage##_state(&s, i);                                                  \
    }

/// The scheme with the arrays of one of them, so many vectors of positions and of rates behind the state's.
static inline scheme scheme_of_set(const scheme *all, size_t places, size_t rates) {
    scheme s = *all;
    s.q += places;
    s.stage_q += places;
    vec **const behind[] = {&s.v, &s.k1, &s.k2, &s.k3, &s.stage_v};
    for (size_t i = 0; i < sizeof behind / sizeof *behind; i++) *behind[i] += rates;
    return s;
}

static void take_step(const variational_lanes *lanes, const double *forcing) {
    const double *middle = forcing + lanes->forcing_count, *end = middle + lanes->forcing_count;
    const size_t places = lanes->degrees * lanes->stride, rates = lanes->rates * lanes->stride;
    const size_t sets = 1 + lanes->disturbances;
    const bool even = places == rates;
    scheme all = scheme_of(lanes->step);
    all.q = (vec *)lanes->q;
    all.v = (vec *)lanes->v;
    all.k1 = (vec *)lanes->k[0];
    all.k2 = (vec *)lanes->k[1];
    all.k3 = (vec *)lanes->k[2];
    all.stage_q = (vec *)lanes->stage_q;
    all.stage_v = (vec *)lanes->stage_v;
    take_slope(lanes, forcing, all.q, all.v, 0, all.k1);
    ENTER(enter_second)
    take_slope(lanes, middle, all.stage_q, all.stage_v, 1, all.k2);
    ENTER(enter_third)
    take_slope(lanes, middle, all.stage_q, all.stage_v, 2, all.k3);
    ENTER(enter_fourth)
    take_slope(lanes, end, all.stage_q, all.stage_v, 3, all.k3);
    ENTER(enter_end)
    add_divergence(lanes);
}

// ---------------------------------------------------------------- orthonormal disturbances, as orthonormal.c makes
// them

/// Disturbances of vector k.
typedef struct disturbance {
    vec *q, *v;
} disturbance;

static inline disturbance disturbance_of(const variational_lanes *lanes, size_t n, size_t k) {
    return (disturbance){(vec *)lanes->q + n * lanes->degrees * lanes->stride + k,
                         (vec *)lanes->v + n * lanes->rates * lanes->stride + k};
}

static vec product_of(const variational_lanes *lanes, disturbance a, disturbance b) {
    vec sum = v_set(0.0);
    for (size_t i = 0; i < lanes->degrees * lanes->stride; i += lanes->stride) sum = v_fma(a.q[i], b.q[i], sum);
    for (size_t i = 0; i < lanes->rates * lanes->stride; i += lanes->stride) sum = v_fma(a.v[i], b.v[i], sum);
    return sum;
}

static void take_off(const variational_lanes *lanes, disturbance a, disturbance b, vec along) {
    for (size_t i = 0; i < lanes->degrees * lanes->stride; i += lanes->stride) a.q[i] = v_fnma(along, b.q[i], a.q[i]);
    for (size_t i = 0; i < lanes->rates * lanes->stride; i += lanes->stride) a.v[i] = v_fnma(along, b.v[i], a.v[i]);
}

static void scale_by(const variational_lanes *lanes, disturbance a, vec factor) {
    for (size_t i = 0; i < lanes->degrees * lanes->stride; i += lanes->stride) a.q[i] = v_mul(a.q[i], factor);
    for (size_t i = 0; i < lanes->rates * lanes->stride; i += lanes->stride) a.v[i] = v_mul(a.v[i], factor);
}

static void make_orthonormal_lane(const variational_lanes *lanes, size_t k) {
    vec *lengths = (vec *)lanes->lengths + k;
    for (size_t n = 1; n <= lanes->disturbances; n++) {
        const disturbance own = disturbance_of(lanes, n, k);
        for (int turn = 0; turn < 2; turn++)
            for (size_t m = 1; m < n; m++) {
                const disturbance before = disturbance_of(lanes, m, k);
                take_off(lanes, own, before, product_of(lanes, own, before));
            }
        const vec length = v_max(v_sqrt(product_of(lanes, own, own)), v_set(0x1p-500));
        scale_by(lanes, own, v_div(v_set(1.0), length));
        lengths[(n - 1) * lanes->stride] = v_mul(lengths[(n - 1) * lanes->stride], length);
    }
}

void ISA(variational_lanes)(variational_lanes *lanes) {
    int since = 0;
    for (int n = 0; n < lanes->steps; n++) {
        take_step(lanes, lanes->forcing + (size_t)n * 2 * lanes->forcing_count);
        const int last = n + 1 == lanes->steps;
        if ((n + 1) % lanes->often != 0 && !last) continue;
        for (size_t k = 0; k < lanes->stride; k++) make_orthonormal_lane(lanes, k);
        if (++since < NOTE && !last) continue;
        lanes->note(lanes);
        since = 0;
    }
}
