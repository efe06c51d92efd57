// Rotors side by side as vectors: accelerations, perturbations by the Jacobian, its trace, switching functions, normal
// forces, forcing. Compiled once for every instruction set.
//
// Stations come first, then the linear terms, then the elements in the registry's order. Vectors are innermost.
#include "../machine.h"

#include "block.h"
#include "body_kernel.h"
#include "elements/shafts/station_kernel.h"
#include "pair_kernel.h"

static block block_of(const lanes_view *view) {
    const whirl_rotor *rotor = view->model;
    const size_t rates = view->rates > 0 ? view->rates : rotor->lanes.degrees + rotor->lanes.states;
    // A shaft's phase that is a state acts on all perturbations.
    const size_t *unit = rotor->phase ? NULL : view->columns;
    return (block){.stride = view->stride,
                   .vectors = view->vectors,
                   .perturbations = view->tangents,
                   .next = rotor->lanes.degrees * view->stride,
                   .next_v = rates * view->stride,
                   .unit_q = unit,
                   .unit_v = unit ? unit + rotor->lanes.degrees : NULL,
                   .forcing_stride = view->stride,
                   .forcing = view->forcing,
                   .q = view->q,
                   .v = view->v,
                   .a = view->a,
                   .divergence = view->divergence,
                   .numbers = view->numbers,
                   .places = view->places,
                   .sides = view->sides,
                   .coupled = rotor->coupled.count > 0 ? &rotor->coupled : NULL};
}

static const vec *station_numbers(const block *b, size_t station) {
    return b->numbers + (b->places ? b->places[station] : station * STATION_NUMBERS) * b->stride;
}

/// Computes the accelerations of the stations that move in x and y, which come first. The block is a copy, so that
/// compilers know that no write changes it.
VECTOR_INLINE void add_stations(block at, size_t station_count) {
    const vec *cosine = at.forcing + COS_TAU * at.forcing_stride, *sine = at.forcing + SIN_TAU * at.forcing_stride;
    for (size_t s = 0; s < station_count; s++) {
        const vec *number = station_numbers(&at, s);
        const size_t row = 2 * s * at.stride;
        for (size_t k = 0; k < at.vectors; k++)
            station_kernel(cosine[k], sine[k], at.stride, number + k, at.v + row + k, at.a + row + k);
    }
}

static void pass_stations(const block *b, size_t station_count) {
    if (b->stride > 1)
        add_stations(*b, station_count);
    else
        add_stations(single(b), station_count);
}

/// Computes the stations' effect on unit perturbations.
static void pass_station_units(const block *b, size_t station_count) {
    for (size_t row = 0; row < 2 * station_count; row++) {
        const vec *damping = station_numbers(b, row / 2) + STATION_DAMPING * b->stride;
        vec *a = column_of(b, b->unit_v[row]) + row * b->stride;
        for (size_t k = 0; k < b->vectors; k++) a[k] = v_sub(v_set(0.0), damping[k]);
    }
}

/// Computes the stations' effect on perturbations.
static void pass_station_tangents(const block *b, size_t station_count) {
    if (b->unit_v) {
        pass_station_units(b, station_count);
        return;
    }
    for (size_t s = 0; s < station_count; s++)
        for (size_t k = 0; k < b->vectors; k++) {
            const vec *own = station_numbers(b, s) + k;
            size_t at = 2 * s * b->stride + k;
            for (size_t n = 0; n < b->perturbations; n++) {
                at += b->next_v;
                station_tangent(b->stride, own, b->v + at, b->a + at);
            }
            if (!b->divergence) continue;
            const vec part =
                v_add(of_trace(b, 2 * s, 2 * s, v_set(1.0)), of_trace(b, 2 * s + 1, 2 * s + 1, v_set(1.0)));
            b->divergence[k] = v_fnma(part, own[STATION_DAMPING * b->stride], b->divergence[k]);
        }
}

/// Returns the numbers that a term multiplies, of the state or of perturbation n; NULL if the term does not act on
/// perturbations.
static const vec *machine_column(const linear_term *term, const block *b, size_t n) {
    switch (term->source) {
    case SOURCE_PLACE:
        return b->q + n * b->next + term->column * b->stride;
    case SOURCE_VELOCITY:
        return b->v + n * b->next_v + term->column * b->stride;
    case SOURCE_FORCING:
        return n == 0 ? b->forcing + term->column * b->forcing_stride : NULL;
    default:
        return NULL;
    }
}

/// Adds terms to unit perturbations.
static void pass_terms_units(const whirl_rotor *rotor, const block *b) {
    for (size_t i = 0; i < rotor->term_count; i++) {
        const linear_term *term = &rotor->terms[i];
        if (term->source != SOURCE_PLACE && term->source != SOURCE_VELOCITY) continue;
        const vec *number = b->numbers + (rotor->plane_count * STATION_NUMBERS + i) * b->stride;
        const size_t *unit = term->source == SOURCE_PLACE ? b->unit_q : b->unit_v;
        vec *a = column_of(b, unit[term->column]) + term->row * b->stride;
        for (size_t k = 0; k < b->vectors; k++) a[k] = v_add(number[k], a[k]);
    }
}

/// Adds terms for all states at once. The terms of a row are adjacent, so that its sum stays in registers.
static void pass_terms(const whirl_rotor *rotor, const block *b) {
    for (size_t i = 0; i < rotor->term_count; i++) {
        const linear_term *term = &rotor->terms[i];
        const vec *number = b->numbers + (rotor->plane_count * STATION_NUMBERS + i) * b->stride;
        for (size_t n = 0; n <= (b->unit_q ? 0 : b->perturbations); n++) {
            const vec *column = machine_column(term, b, n);
            vec *a = b->a + n * b->next_v + term->row * b->stride;
            if (column)
                for (size_t k = 0; k < b->vectors; k++) a[k] = v_fma(number[k], column[k], a[k]);
            else if (n == 0)
                for (size_t k = 0; k < b->vectors; k++) a[k] = v_add(number[k], a[k]);
            else if (b->turned && term->source == SOURCE_FORCING)
                for (size_t k = 0; k < b->vectors; k++)
                    a[k] = v_fma(v_mul(number[k], b->turned[term->column * b->forcing_stride + k]), phase_of(b, n, k),
                                 a[k]);
        }
        if (b->divergence && term->source == SOURCE_VELOCITY)
            for (size_t k = 0; k < b->vectors; k++)
                b->divergence[k] = v_add(b->divergence[k], of_trace(b, term->row, term->column, number[k]));
    }
}

/// Adds the terms as pass_terms does, for one vector without perturbations.
static void pass_terms_alone(const whirl_rotor *rotor, const block *b) {
    const vec *const from[] = {[SOURCE_PLACE] = b->q, [SOURCE_VELOCITY] = b->v};
    const vec *number = b->numbers + rotor->plane_count * STATION_NUMBERS;
    const linear_term *term = rotor->terms, *end = term + rotor->term_count;
    while (term < end) {
        const size_t row = term->row;
        vec sum = b->a[row];
        for (; term < end && term->row == row; term++, number++) {
            if (term->source == SOURCE_ONE)
                sum = v_add(*number, sum);
            else if (term->source == SOURCE_FORCING)
                sum = v_fma(*number, b->forcing[term->column * b->forcing_stride], sum);
            else
                sum = v_fma(*number, from[term->source][term->column], sum);
        }
        b->a[row] = sum;
    }
}

/// Sets accelerations to 0 that neither the pass of stations nor that of shafts initializes.
static void clear(const whirl_rotor *rotor, const block *b) {
    const size_t first = 2 * rotor->plane_count, vectors = b->vectors, stride = b->stride;
    for (size_t k = 0; b->divergence && k < vectors; k++) b->divergence[k] = v_set(0.0);
    // All contributions to unit perturbations are added.
    if (b->unit_q && vectors == stride) memset(b->a + b->next_v, 0, b->perturbations * b->next_v * sizeof *b->a);
    for (size_t row = b->next_v; b->unit_q && vectors < stride && row < (1 + b->perturbations) * b->next_v;
         row += stride)
        for (size_t k = 0; k < vectors; k++) b->a[row + k] = v_set(0.0);
    for (size_t n = 0; n <= (b->unit_q ? 0 : b->perturbations); n++) {
        vec *a = b->a + n * b->next_v + first * stride;
        for (size_t d = first; d < rotor->begun; d++, a += stride)
            for (size_t k = 0; k < vectors; k++) a[k] = v_set(0.0);
    }
}

static const element_kernels *kernels_of(const element *own) {
    return own->type->kernels[VECTOR_ISA];
}

static void pass_all(const whirl_rotor *rotor, const block *b) {
    clear(rotor, b);
    pass_stations(b, rotor->plane_count);
    if (wants_tangent(b)) pass_station_tangents(b, rotor->plane_count);
    if (rotor->body.count > 0) pass_body(&rotor->body, b->numbers + rotor->first_rate * b->stride, b);
    if (b->stride == 1 && !b->divergence && (b->perturbations == 0 || b->unit_q))
        pass_terms_alone(rotor, b);
    else
        pass_terms(rotor, b);
    if (b->unit_q) pass_terms_units(rotor, b);
    for (const element *own = rotor->elements; own < rotor->elements + rotor->element_count; own += own->run)
        kernels_of(own)->flow(own, own->run, b);
    if (b->coupled) couple(b);
}

enum { BY_PHASE = 8 }; ///< vectors at a time

/// Computes vectors from k on, with the forcing of the shaft's phase, which is a state.
static void pass_by_phase(const whirl_rotor *rotor, const block *all, size_t k) {
    vec values[FORCING_COUNT][BY_PHASE], turned[FORCING_COUNT][BY_PHASE];
    const vec *number = all->numbers + (rotor->lanes.number_count - 1) * all->stride + k, nothing = v_set(0.0);
    block b = *all;
    b.vectors = all->vectors - k < BY_PHASE ? all->vectors - k : BY_PHASE;
    b.q += k, b.v += k, b.a += k, b.numbers += k;
    b.sides = b.sides ? b.sides + k : NULL;
    b.divergence = b.divergence ? b.divergence + k : NULL;
    b.forcing = values[0], b.turned = turned[0], b.forcing_stride = BY_PHASE, b.phase = rotor->phase;
    ISA(machine_forcing)(rotor, BY_PHASE, b.vectors, b.v + b.phase * b.stride, values);
    for (size_t i = 0; i < b.vectors; i++) {
        turned[COS_TAU][i] = v_sub(nothing, values[SIN_TAU][i]);
        turned[SIN_TAU][i] = values[COS_TAU][i];
        turned[COS_2TAU][i] = v_mul(v_set(-2.0), values[SIN_2TAU][i]);
        turned[SIN_2TAU][i] = v_mul(v_set(2.0), values[COS_2TAU][i]);
        for (size_t n = 0; n <= b.perturbations; n++)
            b.a[n * b.next_v + b.phase * b.stride + i] = n == 0 ? number[i] : nothing;
    }
    pass_all(rotor, &b);
}

void ISA(machine_flow)(const lanes_view *view) {
    const whirl_rotor *rotor = view->model;
    const block b = block_of(view);
    if (b.stride == 1 && !wants_tangent(&b) && rotor->lanes.pair_laws) {
        pair_alone(rotor->lanes.pair_laws, 1, b.numbers, b.forcing, false, b.sides, b.q, b.v, b.a);
        return;
    }
    if (!rotor->phase) pass_all(rotor, &b);
    for (size_t k = 0; rotor->phase && k < b.vectors; k += BY_PHASE) pass_by_phase(rotor, &b, k);
}

#if VECTOR_ISA == VECTOR_SCALAR
void machine_element_flow(const lanes_view *view, const element *own) {
    const block b = block_of(view);
    kernels_of(own)->flow(own, 1, &b);
}
#endif

void ISA(machine_switches)(const lanes_view *view, void *values, void *rates) {
    const whirl_rotor *rotor = view->model;
    const block b = block_of(view);
    for (const element *own = rotor->elements; own < rotor->elements + rotor->element_count; own++) {
        const size_t row = own->first_switch * b.stride;
        if (kernels_of(own)->switches)
            kernels_of(own)->switches(own, &b, (vec *)values + row, rates ? (vec *)rates + row : NULL);
    }
}

void ISA(machine_contacts)(const lanes_view *view, void *normal_force, void *friction) {
    const whirl_rotor *rotor = view->model;
    const block b = block_of(view);
    for (size_t c = 0; c < rotor->contact_count; c++) {
        const element *own = &rotor->elements[rotor->contacts[c]];
        vec *rubbing = friction ? (vec *)friction + 2 * c * b.stride : NULL;
        kernels_of(own)->contact(own, &b, (vec *)normal_force + c * b.stride, rubbing);
    }
}

void ISA(machine_forcing)(const void *model, size_t stride, size_t vectors, const void *t, void *forcing) {
    const vec *time = t;
    vec *out = forcing;
    const vec way = v_set(((const whirl_rotor *)model)->way);
    const vec_mask stands = v_less(v_abs(way), v_set(0.5));
    for (size_t k = 0; k < vectors; k++) {
        vec s, c;
        v_sincos(time[k], &s, &c);
        s = v_mul(way, s);
        c = v_select(stands, v_set(1.0), c);
        out[COS_TAU * stride + k] = c;
        out[SIN_TAU * stride + k] = s;
        out[COS_2TAU * stride + k] = v_mul(v_sub(c, s), v_add(c, s));
        out[SIN_2TAU * stride + k] = v_mul(v_mul(v_set(2.0), c), s);
    }
}
