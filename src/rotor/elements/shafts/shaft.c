// A shaft of unequal stiffness: its pass over vectors, its keys, and the numbers of its kernel.
#include "block.h"
#include "registry.h"
#include "shaft_kernel.h"

/// Adds the force of one shaft, all vectors.
VECTOR_INLINE void add_shaft(int law, int grounded, const block *b, const vec *number, shaft_end here,
                             shaft_end there) {
    const size_t stride = b->stride, vectors = b->vectors;
    const vec *cosine = b->forcing + COS_2TAU * b->forcing_stride, *sine = b->forcing + SIN_2TAU * b->forcing_stride;
    for (size_t k = 0; k < vectors; k++)
        shaft_add(law, grounded, false, cosine[k], sine[k], stride, k, number, &here, &there);
}

/// Adds the shafts' forces for a state or a perturbation.
VECTOR_INLINE void add_shafts(const element *first, size_t count, block at, const vec *q, vec *a) {
    for (const element *own = first; own < first + count; own++) {
        const int grounded = own->port[2] == NO_COORDINATE;
        const size_t x = own->port[0] * at.stride, other = grounded ? x : own->port[2] * at.stride;
        const shaft_end here = {q + x, a + x}, there = {q + other, a + other};
        const vec *number = numbers_of(&at, own);
        // Each of these loops is free of branches.
        if (grounded)
            add_shaft(own->law, true, &at, number, here, there);
        else if (own->law == SHAFT_SIGNS_PAPER)
            add_shaft(SHAFT_SIGNS_PAPER, false, &at, number, here, there);
        else
            add_shaft(SHAFT_SIGNS_DERIVED, false, &at, number, here, there);
    }
}

static void shaft_add_vector(const element *first, size_t count, const block *b, const vec *q, vec *a) {
    if (b->stride > 1)
        add_shafts(first, count, *b, q, a);
    else
        add_shafts(first, count, single(b), q, a);
}

/// Adds the effect of the shaft's phase on perturbation n.
static void add_turned(const element *own, const block *b, size_t n) {
    const int grounded = own->port[2] == NO_COORDINATE;
    const size_t x = own->port[0] * b->stride, other = grounded ? x : own->port[2] * b->stride;
    vec *a = b->a + n * b->next_v;
    for (size_t k = 0; k < b->vectors; k++) {
        const vec change = phase_of(b, n, k);
        shaft_add(own->law, grounded, true, v_mul(b->turned[COS_2TAU * b->forcing_stride + k], change),
                  v_mul(b->turned[SIN_2TAU * b->forcing_stride + k], change), b->stride, k, numbers_of(b, own),
                  &(shaft_end){b->q + x, a + x}, &(shaft_end){b->q + other, a + other});
    }
}

static void shaft_flow(const element *first, size_t count, const block *b) {
    for (size_t n = 0; n <= b->perturbations; n++) {
        shaft_add_vector(first, count, b, b->q + n * b->next, b->a + n * b->next_v);
        for (size_t i = 0; b->turned && n > 0 && i < count; i++) add_turned(first + i, b, n);
    }
}

const element_kernels ISA(shaft_kernels) = {.flow = shaft_flow};

#if VECTOR_ISA == VECTOR_SCALAR

enum { BETWEEN, K1, K2, SIGNS, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED, "the two stations that it joins; one may be ground"),
    [K1] = NUMBER_KEY("k1", "k1", "N/m", REQUIRED, WHIRL_NOT_NEGATIVE,
                      "stiffness along the first principal axis, which is along x at t = 0"),
    [K2] = NUMBER_KEY("k2", "k2", "N/m", OPTIONAL, WHIRL_NOT_NEGATIVE,
                      "stiffness along the second principal axis; absent: k1"),
    [SIGNS] = CITED_CHOICE_KEY("signs", DEFAULT("derived"), "derived|paper",
                               "derived: a shaft that turns; paper: the equations of the 2015 paper as printed",
                               "Friswell et al. 2010, sec. 7.3; rub-impact paper 2015, eq. (2)"),
};

static whirl_status shaft_build(const key_value *values, assembly *to, element *out) {
    static const axis axes[] = {AXIS_X, AXIS_Y};
    key_value between = values[BETWEEN];
    size_t *station = between.station;
    // Make the other end the ground, or the station that is listed first: so the order of listing changes no bit.
    if (station[0] == GROUND ||
        (station[1] != GROUND && to->stations[station[1]].place < to->stations[station[0]].place)) {
        station[0] = values[BETWEEN].station[1];
        station[1] = values[BETWEEN].station[0];
    }
    whirl_status status = element_beside_none(&between, to);
    if (status.code == WHIRL_OK) status = element_between(&between, to, axes, 2, out);
    // The stiffness turns, so that the kernel requires both ends to move in the plane.
    for (size_t end = 0; end < 2 && status.code == WHIRL_OK; end++)
        if (station[end] != GROUND) status = assembly_find_plane(to, station[end], out->port + 2 * end);
    if (status.code != WHIRL_OK) return status;
    const double k1 = values[K1].number, k2 = values[K2].given ? values[K2].number : k1;
    const double mean = 0.5 * (k1 + k2), half = 0.5 * (k1 - k2);
    const double scale_a = assembly_stiffness_scale(to, station[0]);
    const double scale_b = station[1] == GROUND ? INFINITY : assembly_stiffness_scale(to, station[1]);
    out->law = values[SIGNS].choice;
    out->round = half == 0.0;
    out->number[SHAFT_MEAN_A] = mean / scale_a;
    out->number[SHAFT_HALF_A] = half / scale_a;
    out->number[SHAFT_MEAN_B] = mean / scale_b;
    out->number[SHAFT_HALF_B] = half / scale_b;
    return whirl_ok();
}

KERNELS_OF_EVERY_ISA(shaft_kernels);

const element_type shaft_element = {
    .group = {"shaft", "a massless shaft of unequal stiffness between two stations, or from a station to ground",
              "Friswell et al. 2010, sec. 7.3", keys, KEY_COUNT, NULL, NULL},
    .spun = true,
    .number_count = SHAFT_NUMBERS,
    .kernels = kernels,
    .build = shaft_build,
};
#endif
