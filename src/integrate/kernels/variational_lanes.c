// RK4 in Nystrom's form for x'' = f(t, x, x') and its variational equations over vector lanes, compiled once for every
// instruction set: the steps of rk4_lanes.c and their exact derivative.
#include "variational_lanes.h"
#include "vector.h"

enum { NOTE = 8 }; ///< orthonormalisations whose lengths are multiplied before a logarithm is taken

/// Numbers of vectors in an array of the state and all disturbances.
static size_t size_of(const variational_lanes *lanes) {
    return (1 + lanes->disturbances) * lanes->degrees * lanes->stride;
}

static void take_slope(const variational_lanes *lanes, const double *forcing, const vec *q, const vec *v, int stage) {
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
                             .a = lanes->k[stage],
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

static void take_step(const variational_lanes *lanes, const double *forcing) {
    const double *middle = forcing + lanes->forcing_count, *end = middle + lanes->forcing_count;
    const size_t size = size_of(lanes);
    vec *restrict q = (vec *)lanes->q, *restrict v = (vec *)lanes->v;
    vec *restrict k1 = (vec *)lanes->k[0], *restrict k2 = (vec *)lanes->k[1];
    vec *restrict k3 = (vec *)lanes->k[2], *restrict k4 = (vec *)lanes->k[3];
    vec *restrict sq = (vec *)lanes->stage_q, *restrict sv = (vec *)lanes->stage_v;
    const double h = lanes->step;
    const vec whole = v_set(h), half = v_set(0.5 * h), quarter_square = v_set(0.25 * h * h);
    const vec half_square = v_set(0.5 * h * h), sixth_square = v_set(h * h / 6.0), sixth = v_set(h / 6.0);
    take_slope(lanes, forcing, q, v, 0);
    for (size_t i = 0; i < size; i++) {
        sq[i] = v_fma(half, v[i], q[i]);
        sv[i] = v_fma(half, k1[i], v[i]);
    }
    take_slope(lanes, middle, sq, sv, 1);
    for (size_t i = 0; i < size; i++) {
        sq[i] = v_fma(quarter_square, k1[i], sq[i]);
        sv[i] = v_fma(half, k2[i], v[i]);
    }
    take_slope(lanes, middle, sq, sv, 2);
    for (size_t i = 0; i < size; i++) {
        q[i] = v_fma(whole, v[i], q[i]);
        sq[i] = v_fma(half_square, k2[i], q[i]);
        sv[i] = v_fma(whole, k3[i], v[i]);
    }
    take_slope(lanes, end, sq, sv, 3);
    for (size_t i = 0; i < size; i++) {
        const vec inner = v_add(k2[i], k3[i]);
        q[i] = v_fma(sixth_square, v_add(k1[i], inner), q[i]);
        v[i] = v_fma(sixth, v_fma(v_set(2.0), inner, v_add(k1[i], k4[i])), v[i]);
    }
    add_divergence(lanes);
}

// ---------------------------------------------------------------- orthonormal disturbances, as orthonormal.c makes
// them

/// Adds up the products of parts a and b, [degrees], of vector k.
static vec add_products(const variational_lanes *lanes, const vec *a, const vec *b, vec sum) {
    for (size_t d = 0; d < lanes->degrees; d++) sum = v_fma(a[d * lanes->stride], b[d * lanes->stride], sum);
    return sum;
}

static void take_off(const variational_lanes *lanes, vec *a, const vec *b, vec along) {
    for (size_t d = 0; d < lanes->degrees; d++)
        a[d * lanes->stride] = v_fnma(along, b[d * lanes->stride], a[d * lanes->stride]);
}

static void scale_by(const variational_lanes *lanes, vec *a, vec factor) {
    for (size_t d = 0; d < lanes->degrees; d++) a[d * lanes->stride] = v_mul(a[d * lanes->stride], factor);
}

static void make_orthonormal_lane(const variational_lanes *lanes, size_t k) {
    const size_t next = lanes->degrees * lanes->stride;
    vec *q = (vec *)lanes->q + k, *v = (vec *)lanes->v + k, *lengths = (vec *)lanes->lengths + k;
    for (size_t n = 1; n <= lanes->disturbances; n++) {
        vec *own_q = q + n * next, *own_v = v + n * next;
        for (int turn = 0; turn < 2; turn++)
            for (size_t m = 1; m < n; m++) {
                vec along = add_products(lanes, own_q, q + m * next, v_set(0.0));
                along = add_products(lanes, own_v, v + m * next, along);
                take_off(lanes, own_q, q + m * next, along);
                take_off(lanes, own_v, v + m * next, along);
            }
        const vec square = add_products(lanes, own_v, own_v, add_products(lanes, own_q, own_q, v_set(0.0)));
        const vec length = v_max(v_sqrt(square), v_set(0x1p-500)), factor = v_div(v_set(1.0), length);
        scale_by(lanes, own_q, factor);
        scale_by(lanes, own_v, factor);
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
