/// The passes of an element between two places, generated from its kernel: accelerations, and the effect on
/// perturbations by the kernel's derivative (dual numbers).
///
/// The including file defines
///
///     KERNEL_FILE      the header of the kernel, in quotes
///     KERNEL_AXES      number of its displacements: of its place, or of one place relative to another
///     KERNEL_STATES    number of its first-order states; with KERNEL_FEWER_STATES their maximum; an element then
///                      has own->states of them
///     KERNEL_NUMBERS   number of its numbers; they are followed by one for every port, which converts forces to
///                      accelerations
///     KERNEL_SWITCHES  number of switching functions, 0 if the force is smooth; they are affine in displacements,
///                      velocities and states, unless KERNEL_CURVED is defined and the type has a switch_curvature
///     KERNEL_PHASED    1 if it uses the forcing, n_phase(view, COS_TAU), ...; otherwise undefined
///     KERNEL_TILTS     defined if its axes may be tilts, whose units differ from station to station; then the numbers
///                      of the ports are followed by the ports' units divided by that of the element, which
///                      generic_tilts sets (with the shares of gears)
///
/// and the kernel's header, included twice, defines
///
///     KERNEL(force)(const element *own, const kernel_view *view, const num *d, const num *w, const num *s, num *force,
///                   num *slope)
///         computes the forces along the axes [KERNEL_AXES] at displacements d and velocities w, in any unit, and the
///         slopes of its states s;
///     KERNEL(switches)(const element *own, const kernel_view *view, const num *d, const num *w, num *values)
///         computes the switching functions, if KERNEL_SWITCHES is not 0; `force` then uses view->sides unless they are
///         NULL. If KERNEL_SWITCHES_BY_STATES is defined, the states are an argument before the values. If the macro
///         KERNEL_SWITCHES_OF(own) is defined, an element has that number of switches, at most KERNEL_SWITCHES.
///
/// An element has 2 KERNEL_AXES ports: the coordinates of its place, then those of the other place or NO_COORDINATE.
/// The force acts on the first place with its sign, and on the other place with the opposite sign.
#ifndef ROTOR_GENERIC_H
#define ROTOR_GENERIC_H

#include "block.h"

#ifndef KERNEL_PHASED
#define KERNEL_PHASED 0
#endif
#ifdef KERNEL_FEWER_STATES
#define STATES_OF(own) ((own)->states < KERNEL_STATES ? (int)(own)->states : KERNEL_STATES)
#else
#define STATES_OF(own) KERNEL_STATES
#endif

enum { KERNEL_PORTS = 2 * KERNEL_AXES, DUAL_INPUTS = 2 * KERNEL_AXES + KERNEL_STATES + KERNEL_PHASED };
_Static_assert(2 * KERNEL_AXES <= (int)MAX_PORTS, "an element sees at most MAX_PORTS coordinates");

/// Arguments of a kernel in addition to its motion.
typedef struct kernel_view {
    size_t stride;
    const vec *number;                               ///< number n of the element is number[n * stride]
    vec phase[FORCING_COUNT], turned[FORCING_COUNT]; ///< the forcing, and its derivatives by the shaft's phase
    const vec *sides;                                ///< side of switch s: sides[s * stride]; NULL: the state decides
} kernel_view;

#undef NUMBERS_DUAL
#include "numbers.h"
#define n_phase(view, value) (view)->phase[value]
#include KERNEL_FILE
#undef n_phase
#define NUMBERS_DUAL
#include "numbers.h"
#define n_phase phase_dual
static inline dual phase_dual(const kernel_view *view, int value) {
    dual out = dual_of(view->phase[value]);
    out.by[DUAL_INPUTS - 1] = view->turned[value];
    return out;
}
#include KERNEL_FILE

/// Inputs of an element, from a state or a perturbation.
typedef struct kernel_inputs {
    vec d[KERNEL_AXES], w[KERNEL_AXES], s[KERNEL_STATES + 1], phase;
} kernel_inputs;

/// Converts `value`, a displacement or velocity of a port's coordinate in vector k, to the unit of the element.
VECTOR_INLINE vec in_unit(const element *own, const block *b, size_t k, size_t port, vec value) {
#ifdef KERNEL_TILTS
    return v_mul(numbers_of(b, own)[(KERNEL_NUMBERS + KERNEL_PORTS + port) * b->stride + k], value);
#else
    (void)own, (void)b, (void)k, (void)port;
    return value;
#endif
}

/// Returns true if the element's place moves along all axes, in their own units, and the other place is the ground.
/// This is the most frequent case, with fewer branches.
static inline bool is_grounded(const element *own) {
#ifdef KERNEL_TILTS
    bool grounded = false;
#else
    bool grounded = true;
#endif
    for (size_t a = 0; a < KERNEL_AXES; a++)
        grounded = grounded && own->port[a] != NO_COORDINATE && own->port[KERNEL_AXES + a] == NO_COORDINATE;
    return grounded;
}

/// Returns the difference of both places along axis a, for vector k of a row.
VECTOR_INLINE vec between(const element *own, const block *b, const vec *row, size_t k, size_t a) {
    const size_t one = own->port[a], other = own->port[KERNEL_AXES + a];
    const vec here = one == NO_COORDINATE ? v_set(0.0) : in_unit(own, b, k, a, row[one * b->stride + k]);
    if (other == NO_COORDINATE) return here;
    return v_sub(here, in_unit(own, b, k, KERNEL_AXES + a, row[other * b->stride + k]));
}

/// Collects the inputs for vector k of state or perturbation n.
VECTOR_INLINE void inputs_of(const element *own, const block *b, size_t n, size_t k, bool grounded, kernel_inputs *in) {
    const vec *q = b->q + n * b->next, *v = b->v + n * b->next_v;
    if (grounded)
        for (size_t a = 0; a < KERNEL_AXES; a++) {
            in->d[a] = q[own->port[a] * b->stride + k];
            in->w[a] = v[own->port[a] * b->stride + k];
        }
    else
        for (size_t a = 0; a < KERNEL_AXES; a++) {
            in->d[a] = between(own, b, q, k, a);
            in->w[a] = between(own, b, v, k, a);
        }
    in->s[0] = v_set(0.0);
    for (int s = 0; s < STATES_OF(own); s++) in->s[s] = v[(own->state + (size_t)s) * b->stride + k];
    if (KERNEL_PHASED) in->phase = phase_of(b, n, k);
}

VECTOR_INLINE kernel_view view_of(const element *own, const block *b, size_t k) {
    const vec *sides = sides_of(b, own);
    kernel_view view = {.stride = b->stride, .number = numbers_of(b, own) + k, .sides = sides ? sides + k : NULL};
    for (size_t i = 0; b->forcing && i < FORCING_COUNT; i++) {
        view.phase[i] = b->forcing[i * b->forcing_stride + k];
        view.turned[i] = KERNEL_PHASED && b->turned ? b->turned[i * b->forcing_stride + k] : v_set(0.0);
    }
    return view;
}

/// Adds forces to the accelerations, and the slopes of states, in vector k of state or perturbation n.
VECTOR_INLINE void spread(const element *own, const block *b, size_t n, size_t k, bool grounded, const vec *force,
                          const vec *slope) {
    const size_t stride = b->stride;
    const vec *scale = numbers_of(b, own) + KERNEL_NUMBERS * stride + k;
    vec *a = b->a + n * b->next_v + k;
    for (size_t i = 0; i < KERNEL_AXES; i++) {
        const size_t one = own->port[i], other = own->port[KERNEL_AXES + i];
        if (grounded || one != NO_COORDINATE) a[one * stride] = v_fma(scale[i * stride], force[i], a[one * stride]);
        if (!grounded && other != NO_COORDINATE)
            a[other * stride] = v_fnma(scale[(KERNEL_AXES + i) * stride], force[i], a[other * stride]);
    }
    for (int s = 0; s < STATES_OF(own); s++) a[(own->state + (size_t)s) * stride] = slope[s];
}

VECTOR_INLINE void add_plain(const element *own, const block *b, size_t k, bool grounded) {
    const kernel_view view = view_of(own, b, k);
    kernel_inputs in;
    inputs_of(own, b, 0, k, grounded, &in);
    vec force[KERNEL_AXES], slope[KERNEL_STATES + 1];
    force_plain(own, &view, in.d, in.w, in.s, force, slope);
    spread(own, b, 0, k, grounded, force, slope);
}

/// Applies the derivative of `of` to the inputs of a perturbation.
VECTOR_INLINE vec along(const element *own, const dual *of, const kernel_inputs *in) {
    (void)own;
    vec sum = v_set(0.0);
    for (int a = 0; a < KERNEL_AXES; a++) {
        sum = v_fma(of->by[a], in->d[a], sum);
        sum = v_fma(of->by[KERNEL_AXES + a], in->w[a], sum);
    }
    for (int s = 0; s < STATES_OF(own); s++) sum = v_fma(of->by[2 * KERNEL_AXES + s], in->s[s], sum);
    return KERNEL_PHASED ? v_fma(of->by[DUAL_INPUTS - 1], in->phase, sum) : sum;
}

/// Returns the trace of the derivative.
VECTOR_INLINE vec trace_of(const element *own, const block *b, size_t k, const dual *force, const dual *slope) {
    vec trace = v_set(0.0);
    for (size_t port = 0; port < KERNEL_PORTS; port++) {
        const vec scale = numbers_of(b, own)[(KERNEL_NUMBERS + port) * b->stride + k];
        const size_t first = b->coupled ? 0 : port, last = b->coupled ? KERNEL_PORTS - 1 : port;
        for (size_t by = first; by <= last; by++) {
            if (own->port[port] == NO_COORDINATE || own->port[by] == NO_COORDINATE) continue;
            const vec derivative = in_unit(own, b, k, by, force[port % KERNEL_AXES].by[KERNEL_AXES + by % KERNEL_AXES]);
            const vec part = of_trace(b, own->port[port], own->port[by], scale);
            const bool same_place = port / KERNEL_AXES == by / KERNEL_AXES;
            trace = same_place ? v_fma(part, derivative, trace) : v_fnma(part, derivative, trace);
        }
    }
    for (int s = 0; s < STATES_OF(own); s++) trace = v_add(trace, slope[s].by[2 * KERNEL_AXES + s]);
    return trace;
}

/// Makes duals of the inputs.
VECTOR_INLINE void seed(const element *own, const kernel_inputs *in, dual *d, dual *w, dual *s) {
    (void)own;
    for (int a = 0; a < KERNEL_AXES; a++) {
        d[a] = dual_input(in->d[a], a);
        w[a] = dual_input(in->w[a], KERNEL_AXES + a);
    }
    s[0] = dual_set(0.0);
    for (int i = 0; i < STATES_OF(own); i++) s[i] = dual_input(in->s[i], 2 * KERNEL_AXES + i);
}

/// Adds the derivatives of forces and slopes to unit perturbations.
static void add_units(const element *own, const block *b, size_t k, const dual *force, const dual *slope) {
    vec values[KERNEL_AXES], slopes[KERNEL_STATES + 1];
    for (int i = 0; i <= KERNEL_STATES; i++) slopes[i] = v_set(0.0);
    for (int by = 0; by < 4 * KERNEL_AXES + STATES_OF(own); by++) {
        // Find the coordinate: displacements of the ports come first, then their velocities, then the states.
        const size_t port = (size_t)by % KERNEL_PORTS;
        const bool state = by >= 4 * KERNEL_AXES, rate = by >= 2 * KERNEL_AXES;
        const size_t row = state ? own->state + (size_t)(by - 4 * KERNEL_AXES) : own->port[port];
        if (row == NO_COORDINATE) continue;
        const size_t n = 1 + (rate ? b->unit_v : b->unit_q)[row];
        const int input = state ? by - 2 * KERNEL_AXES : (int)(port % KERNEL_AXES) + (rate ? KERNEL_AXES : 0);
        const vec unit = state ? v_set(1.0) : in_unit(own, b, k, port, v_set(port < KERNEL_AXES ? 1.0 : -1.0));
        for (int a = 0; a < KERNEL_AXES; a++) values[a] = v_mul(force[a].by[input], unit);
        for (int s = 0; s < STATES_OF(own); s++)
            slopes[s] = v_fma(slope[s].by[input], unit, b->a[n * b->next_v + (own->state + (size_t)s) * b->stride + k]);
        spread(own, b, n, k, false, values, slopes);
    }
}

static void add_dual(const element *own, const block *b, size_t k) {
    const kernel_view view = view_of(own, b, k);
    kernel_inputs in;
    inputs_of(own, b, 0, k, false, &in);
    dual d[KERNEL_AXES], w[KERNEL_AXES], s[KERNEL_STATES + 1], force[KERNEL_AXES], slope[KERNEL_STATES + 1];
    vec values[KERNEL_AXES], slopes[KERNEL_STATES + 1];
    for (int i = 0; i <= KERNEL_STATES; i++) slopes[i] = v_set(0.0);
    seed(own, &in, d, w, s);
    force_dual(own, &view, d, w, s, force, slope);
    for (int a = 0; a < KERNEL_AXES; a++) values[a] = force[a].value;
    for (int i = 0; i < STATES_OF(own); i++) slopes[i] = slope[i].value;
    spread(own, b, 0, k, false, values, slopes);
    if (b->unit_q) add_units(own, b, k, force, slope);
    for (size_t n = 1; n <= (b->unit_q ? 0 : b->perturbations); n++) {
        kernel_inputs change;
        inputs_of(own, b, n, k, false, &change);
        for (int a = 0; a < KERNEL_AXES; a++) values[a] = along(own, &force[a], &change);
        for (int i = 0; i < STATES_OF(own); i++) slopes[i] = along(own, &slope[i], &change);
        spread(own, b, n, k, false, values, slopes);
    }
    if (b->divergence) b->divergence[k] = v_add(b->divergence[k], trace_of(own, b, k, force, slope));
}

/// Computes the accelerations of elements. Block and element are copied, so that compilers know that no write changes
/// them.
static void generic_flow(const element *first, size_t count, const block *b) {
    const block at = *b;
    for (size_t i = 0; i < count; i++) {
        const element own = first[i];
        const bool grounded = is_grounded(&own);
        if (wants_tangent(&at))
            for (size_t k = 0; k < at.vectors; k++) add_dual(&own, &at, k);
        else
            for (size_t k = 0; k < at.vectors; k++) add_plain(&own, &at, k, grounded);
    }
}

#if KERNEL_SWITCHES > 0
#ifdef KERNEL_SWITCHES_OF
#define SWITCHES_OF(own) ((size_t)KERNEL_SWITCHES_OF(own))
#else
#define SWITCHES_OF(own) ((size_t)KERNEL_SWITCHES)
#endif
#ifdef KERNEL_SWITCHES_BY_STATES
#define SWITCHES_AT(own, view, d, w, s, value) switches_dual(own, view, d, w, s, value)
#else
#define SWITCHES_AT(own, view, d, w, s, value) ((void)(s), switches_dual(own, view, d, w, value))
#endif

/// Computes the switching functions, and their derivatives by time along velocities, accelerations and the slopes of
/// states.
static void generic_switches(const element *own, const block *b, void *values, void *rates) {
    for (size_t k = 0; k < b->vectors; k++) {
        // Evaluate the switches with derivatives.
        const kernel_view view = view_of(own, b, k);
        kernel_inputs in;
        inputs_of(own, b, 0, k, false, &in);
        dual d[KERNEL_AXES], w[KERNEL_AXES], s[KERNEL_STATES + 1], value[KERNEL_SWITCHES];
        seed(own, &in, d, w, s);
        SWITCHES_AT(own, &view, d, w, s, value);
        // Sum the rate along the motion.
        for (size_t i = 0; i < SWITCHES_OF(own); i++) {
            vec rate = v_set(0.0);
            for (size_t a = 0; rates && a < KERNEL_AXES; a++) {
                rate = v_fma(value[i].by[a], in.w[a], rate);
                rate = v_fma(value[i].by[KERNEL_AXES + a], between(own, b, b->a, k, a), rate);
            }
#ifdef KERNEL_SWITCHES_BY_STATES
            for (int n = 0; rates && n < STATES_OF(own); n++)
                rate = v_fma(value[i].by[2 * KERNEL_AXES + n], b->a[(own->state + (size_t)n) * b->stride + k], rate);
#endif
            ((vec *)values)[i * b->stride + k] = value[i].value;
            if (rates) ((vec *)rates)[i * b->stride + k] = rate;
        }
    }
}

#if VECTOR_ISA == VECTOR_SCALAR
static size_t generic_switch_count(const element *own) {
    (void)own;
    return SWITCHES_OF(own);
}

static double unit_of(const element *own, int port) {
#ifdef KERNEL_TILTS
    return own->number[KERNEL_NUMBERS + KERNEL_PORTS + port];
#else
    (void)own, (void)port;
    return 1.0;
#endif
}

/// Computes the derivatives of a switching function by the inputs of the element.
static void generic_gradient(const element *own, const element_place *at, size_t index, element_place *by) {
    const kernel_view view = {.stride = 1, .number = own->number};
    dual d[KERNEL_AXES], w[KERNEL_AXES], s[KERNEL_STATES + 1], value[KERNEL_SWITCHES];
    for (int a = 0; a < KERNEL_AXES; a++) {
        const double here = unit_of(own, a), there = unit_of(own, KERNEL_AXES + a);
        d[a] = dual_input(here * at->q[a] - there * at->q[KERNEL_AXES + a], a);
        w[a] = dual_input(here * at->v[a] - there * at->v[KERNEL_AXES + a], KERNEL_AXES + a);
    }
    for (int i = 0; i < STATES_OF(own); i++) s[i] = dual_input(at->s[i], 2 * KERNEL_AXES + i);
    SWITCHES_AT(own, &view, d, w, s, value);
    for (int a = 0; a < KERNEL_AXES; a++) {
        const double here = unit_of(own, a), there = unit_of(own, KERNEL_AXES + a);
        by->q[a] = here * value[index].by[a];
        by->v[a] = here * value[index].by[KERNEL_AXES + a];
        by->q[KERNEL_AXES + a] = -there * value[index].by[a];
        by->v[KERNEL_AXES + a] = -there * value[index].by[KERNEL_AXES + a];
    }
    for (int i = 0; i < STATES_OF(own); i++) by->s[i] = value[index].by[2 * KERNEL_AXES + i];
}

#ifndef KERNEL_CURVED
/// Writes the second derivatives of affine functions: zero.
static void generic_curvature(const element *own, const element_place *at, size_t index, const element_place *along,
                              element_place *by) {
    (void)own, (void)at, (void)index, (void)along;
    *by = (element_place){.q = {0.0}};
}
#endif
#endif

#define GENERIC_KERNELS                                                                                                \
    { .flow = generic_flow, .switches = generic_switches }
#ifdef KERNEL_CURVED
#define GENERIC_SWITCHES .switch_count = generic_switch_count, .switch_gradient = generic_gradient
#else
#define GENERIC_SWITCHES                                                                                               \
    .switch_count = generic_switch_count, .switch_gradient = generic_gradient, .switch_curvature = generic_curvature
#endif
#else
#define GENERIC_KERNELS                                                                                                \
    { .flow = generic_flow }
#endif

#if VECTOR_ISA == VECTOR_SCALAR
/// Fills in the numbers that convert a force of `unit` newtons to accelerations; unit 1 is for forces in newtons.
static inline void generic_scale(element *own, const assembly *to, double unit) {
    for (size_t port = 0; port < KERNEL_PORTS; port++)
        own->number[KERNEL_NUMBERS + port] = own->port[port] == NO_COORDINATE
                                                 ? 0.0
                                                 : own->share[port] * unit / assembly_force_scale(to, own->port[port]);
}

#ifdef KERNEL_TILTS
/// Fills in the numbers that convert forces in N and moments in N m to accelerations, and the units of the ports
/// divided by the unit of the element. Returns the unit of the element, m or rad.
static double generic_tilts(element *own, const assembly *to) {
    double unit = 0.0;
    for (size_t port = KERNEL_PORTS; port-- > 0;)
        if (own->port[port] != NO_COORDINATE) unit = to->unit[own->port[port]];
    for (size_t port = 0; port < KERNEL_PORTS; port++)
        own->number[KERNEL_NUMBERS + KERNEL_PORTS + port] =
            own->port[port] == NO_COORDINATE ? 0.0 : own->share[port] * to->unit[own->port[port]] / unit;
    generic_scale(own, to, 1.0);
    return unit;
}
#endif
#endif

#endif
