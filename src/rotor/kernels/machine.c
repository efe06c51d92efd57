// Rotors side by side as vectors: accelerations, what the Jacobian makes of disturbances, its trace, switching
// functions, normal forces, values of time. Compiled once for every instruction set.
//
// Stations first, then the linear terms, then the elements in the registry's order; vectors innermost.
#include "../machine.h"

#include "block.h"
#include "elements/station_kernel.h"
#include "pair_kernel.h"

static block block_of(const lanes_view *view) {
    const whirl_rotor *rotor = view->model;
    return (block){.stride = view->stride,
                   .vectors = view->vectors,
                   .disturbances = view->tangents,
                   .next = rotor->lanes.degrees * view->stride,
                   .next_v = (rotor->lanes.degrees + rotor->lanes.states) * view->stride,
                   .forcing_count = rotor->system.forcing_count,
                   .forcing = view->forcing,
                   .q = view->q,
                   .v = view->v,
                   .a = view->a,
                   .divergence = view->divergence,
                   .number = view->numbers,
                   .sides = view->sides};
}

/// The stations that move in x and y, which come first.
static void pass_stations(const block *b, size_t station_count) {
    const vec *cosine = b->forcing + COS_TAU * b->stride, *sine = b->forcing + SIN_TAU * b->stride;
    for (size_t s = 0; s < station_count; s++)
        for (size_t k = 0; k < b->vectors; k++) {
            const vec *own = b->number + s * STATION_NUMBERS * b->stride + k;
            size_t at = 2 * s * b->stride + k;
            station_kernel(cosine[k], sine[k], b->stride, own, b->v + at, b->a + at);
            for (size_t n = 0; n < b->disturbances; n++) {
                at += b->next_v;
                station_tangent(b->stride, own, b->v + at, b->a + at);
            }
            if (b->divergence)
                b->divergence[k] = v_fnma(v_set(2.0), own[STATION_DAMPING * b->stride], b->divergence[k]);
        }
}

/// What a term multiplies, of the state or of disturbance n; NULL: nothing of a disturbance.
static const vec *column_of(const linear_term *term, const block *b, size_t n) {
    switch (term->source) {
    case SOURCE_PLACE:
        return b->q + n * b->next + term->column * b->stride;
    case SOURCE_VELOCITY:
        return b->v + n * b->next_v + term->column * b->stride;
    case SOURCE_FORCING:
        return n == 0 ? b->forcing + term->column * b->stride : NULL;
    default:
        return NULL;
    }
}

/// All states at once: a row's terms follow one another, so that its sum stays at hand.
static void pass_terms(const whirl_rotor *rotor, const block *b) {
    for (size_t i = 0; i < rotor->term_count; i++) {
        const linear_term *term = &rotor->terms[i];
        const vec *number = b->number + i * b->stride;
        for (size_t n = 0; n <= b->disturbances; n++) {
            const vec *column = column_of(term, b, n);
            vec *a = b->a + n * b->next_v + term->row * b->stride;
            if (column)
                for (size_t k = 0; k < b->vectors; k++) a[k] = v_fma(number[k], column[k], a[k]);
            else if (n == 0)
                for (size_t k = 0; k < b->vectors; k++) a[k] = v_add(number[k], a[k]);
        }
        if (b->divergence && term->source == SOURCE_VELOCITY && term->column == term->row)
            for (size_t k = 0; k < b->vectors; k++) b->divergence[k] = v_add(b->divergence[k], number[k]);
    }
}

/// Coordinates that no station's pass writes begin at zero.
static void clear(const whirl_rotor *rotor, const block *b) {
    const size_t first = 2 * rotor->plane_count;
    for (size_t k = 0; b->divergence && k < b->vectors; k++) b->divergence[k] = v_set(0.0);
    for (size_t n = 0; n <= b->disturbances; n++)
        for (size_t d = first; d < rotor->lanes.degrees; d++)
            for (size_t k = 0; k < b->vectors; k++) b->a[n * b->next_v + d * b->stride + k] = v_set(0.0);
}

/// The block of the first element; next_element goes on.
static block first_element(const whirl_rotor *rotor, const lanes_view *view) {
    block b = block_of(view);
    b.number += (rotor->plane_count * STATION_NUMBERS + rotor->term_count) * b.stride;
    return b;
}

static size_t switches_of(const element *own) {
    return own->type->switch_count ? own->type->switch_count(own) : 0;
}

static void next_element(const element *own, block *b) {
    b->number += own->type->number_count * b->stride;
    if (b->sides) b->sides += switches_of(own) * b->stride;
}

static const element_kernels *kernels_of(const element *own) {
    return own->type->kernels[VECTOR_ISA];
}

void ISA(machine_flow)(const lanes_view *view) {
    const whirl_rotor *rotor = view->model;
    block b = block_of(view);
    if (rotor->lanes.pair && b.stride == 1 && !wants_tangent(&b)) {
        pair_alone(rotor->lanes.pair, 1, b.number, b.forcing, false, b.sides, b.q, b.v, b.a);
        return;
    }
    clear(rotor, &b);
    pass_stations(&b, rotor->plane_count);
    b.number += rotor->plane_count * STATION_NUMBERS * b.stride;
    pass_terms(rotor, &b);
    b = first_element(rotor, view);
    for (const element *own = rotor->elements; own < rotor->elements + rotor->element_count; own++) {
        kernels_of(own)->flow(own, &b);
        next_element(own, &b);
    }
}

void ISA(machine_switches)(const lanes_view *view, void *values, void *rates) {
    const whirl_rotor *rotor = view->model;
    block b = first_element(rotor, view);
    vec *value = values, *rate = rates;
    for (const element *own = rotor->elements; own < rotor->elements + rotor->element_count; own++) {
        if (kernels_of(own)->switches) {
            kernels_of(own)->switches(own, &b, value, rate);
            value += switches_of(own) * b.stride;
            if (rate) rate += switches_of(own) * b.stride;
        }
        next_element(own, &b);
    }
}

void ISA(machine_contacts)(const lanes_view *view, void *normal_force) {
    const whirl_rotor *rotor = view->model;
    block b = first_element(rotor, view);
    vec *out = normal_force;
    for (const element *own = rotor->elements; own < rotor->elements + rotor->element_count; own++) {
        if (kernels_of(own)->contact) {
            kernels_of(own)->contact(own, &b, out);
            out += b.stride;
        }
        next_element(own, &b);
    }
}

void ISA(machine_forcing)(const void *model, size_t stride, size_t vectors, const void *t, void *forcing) {
    const whirl_rotor *rotor = model;
    const vec *time = t;
    vec *out = forcing;
    for (size_t k = 0; k < vectors; k++) {
        vec s, c;
        v_sincos(time[k], &s, &c);
        out[COS_TAU * stride + k] = c;
        out[SIN_TAU * stride + k] = s;
        out[COS_2TAU * stride + k] = v_mul(v_sub(c, s), v_add(c, s));
        out[SIN_2TAU * stride + k] = v_mul(v_mul(v_set(2.0), c), s);
        if (rotor->system.forcing_count > TAU) out[TAU * stride + k] = time[k];
    }
}
