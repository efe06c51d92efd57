// Machines whose speed changes, side by side as vectors: the numbers at the present speeds, the rotors at these speeds,
// and the shafts' equations. Compiled once for every instruction set.
//
// The formulas are those of running.c for the angle as variable. Numbers that vary with the speed are written over
// those of the machine before each use.
#include "../running_rotor.h"

#include "vector.h"

/// The machines in one vector.
typedef struct running_vector {
    const running_rotor *r;
    size_t stride, k;
    vec *numbers;
    const vec *forcing, *v;
    vec *a;
} running_vector;

static running_vector running_vector_of(const lanes_view *view, size_t k) {
    return (running_vector){view->model, view->stride, k, view->numbers, view->forcing, view->v, view->a};
}

static inline vec *running_row(const running_vector *own, size_t row) {
    return own->numbers + row * own->stride + own->k;
}

static inline vec running_shaft_number(const running_vector *own, size_t number) {
    return *running_row(own, own->r->lanes.shaft + number);
}

static inline vec running_lever_number(const running_vector *own, size_t j, size_t number) {
    return *running_row(own, own->r->lanes.levers + j * LEVER_NUMBERS + number);
}

/// Returns the index of the shafts' speeds among the rates.
static inline size_t running_speed_row(const running_rotor *r) {
    return r->at_speed - r->rotor->lanes.degrees;
}

/// Returns the speeds, at least `slowest`, since laws divide by the speed.
static inline vec running_speed(const running_vector *own) {
    return v_max(v_set(slowest), own->v[running_speed_row(own->r) * own->stride + own->k]);
}

/// Relative distance of the speeds at which slopes are taken for their derivative by the speed, which is exact to 1e-8.
static const double running_apart = 0x1p-26;

enum { AT_ONCE = 4 }; ///< vectors whose numbers are evaluated together

/// Evaluates the numbers that vary with the speed, for `count` vectors from k on, at the present speeds times `share`.
VECTOR_INLINE void running_put_some_numbers(const lanes_view *view, size_t k, size_t count, vec share) {
    const running_rotor *r = view->model;
    vec powers[POWERS][AT_ONCE];
    VECTOR_FOR (i, count) {
        const running_vector own = running_vector_of(view, k + i);
        const vec w = v_mul(share, running_speed(&own)), inverse = v_div(v_set(1.0), w);
        powers[0][i] = v_mul(inverse, inverse);
        powers[1][i] = inverse;
        powers[2][i] = v_set(1.0);
        powers[3][i] = w;
        powers[4][i] = v_mul(w, w);
    }
    const vec *factor = (const vec *)view->numbers + r->lanes.powers * view->stride + k;
    for (const running_factor *of = r->lanes.factors, *end = of + r->lanes.factor_count; of < end; of++) {
        vec *number = (vec *)view->numbers + of->number * view->stride + k;
        const vec *power = powers[of->power];
        if (of->begins)
            VECTOR_FOR (i, count) number[i] = v_mul(factor[i], power[i]);
        else
            VECTOR_FOR (i, count) number[i] = v_fma(factor[i], power[i], number[i]);
        factor += view->stride;
    }
}

/// Evaluates the numbers that vary, at the present speeds times a share.
static void running_put_numbers(const lanes_view *view, double share) {
    size_t k = 0;
    for (; k + AT_ONCE <= view->vectors; k += AT_ONCE) running_put_some_numbers(view, k, AT_ONCE, v_set(share));
    for (; k < view->vectors; k++) running_put_some_numbers(view, k, 1, v_set(share));
}

/// Returns a view of the rotors alone.
static lanes_view running_rotor_view(const lanes_view *view) {
    const running_rotor *r = view->model;
    lanes_view rotors = *view;
    rotors.model = r->rotor;
    rotors.rates = r->form.degrees + r->form.states;
    return rotors;
}

/// Adds the forces of unbalances that have appeared, and notes the accelerations of all levers by a unit of theta''.
static void running_put_levers(const running_vector *own, vec c, vec s, vec way) {
    const running_rotor *r = own->r;
    const vec turned_c = v_mul(way, c), turned_s = v_mul(way, s);
    for (size_t j = 0; j < r->lanes.lever_count; j++) {
        vec *a = own->a + r->lanes.lever[j] * own->stride + own->k;
        *a = v_fma(running_lever_number(own, j, LEVER_LOST_COS), c,
                   v_fma(running_lever_number(own, j, LEVER_LOST_SIN), s, *a));
        *running_row(own, r->lanes.now + j) = v_fms(running_lever_number(own, j, LEVER_COS), turned_s,
                                                    v_mul(running_lever_number(own, j, LEVER_SIN), turned_c));
    }
}

/// Returns the torque of the friction of contacts, N m, against the rotation.
static vec running_friction(const running_vector *own) {
    const size_t contacts = own->r->rotor->contact_count;
    const vec *rubbing = running_row(own, own->r->lanes.contacts + contacts);
    vec sum = v_set(0.0);
    for (size_t c = 0; c < contacts; c++, rubbing += 2 * own->stride) {
        const vec_mask known = v_less(v_abs(*rubbing), v_set(INFINITY));
        sum = v_add(sum, v_select(known, *rubbing, v_set(0.0)));
    }
    return sum;
}

/// Returns the lever of unbalance j, with the cosine and sine of the shaft's angle.
static inline vec running_lever(const running_vector *own, size_t j, vec c, vec s) {
    return v_fms(running_lever_number(own, j, LEVER_FORCE_COS), s,
                 v_mul(running_lever_number(own, j, LEVER_FORCE_SIN), c));
}

/// Returns theta'' over the square of the unit of speed where torques drive the shafts, from the accelerations by the
/// angle without it. *by: the inertia by which torques are divided.
static vec running_by_torques(const running_vector *own, vec w, vec c, vec s, vec *by) {
    const running_rotor *r = own->r;
    const vec speed = v_mul(w, running_shaft_number(own, SHAFT_UNIT)), square = v_mul(w, w);
    const vec pull[3] = {running_shaft_number(own, SHAFT_PULL), running_shaft_number(own, SHAFT_PULL + 1), v_set(0.0)};
    // Sum the torques of the motor, its load, and friction.
    const vec motor = v_fnma(running_shaft_number(own, SHAFT_FALL), speed, running_shaft_number(own, SHAFT_MOTOR));
    const vec slope = v_fma(running_shaft_number(own, SHAFT_QUADRATIC), speed, running_shaft_number(own, SHAFT_LINEAR));
    const vec load = v_fma(speed, slope, running_shaft_number(own, SHAFT_LOAD));
    const vec whole = v_sub(v_sub(motor, load), running_friction(own));
    // Add the unbalances, which act as levers.
    vec reaction = v_set(0.0), inertia = running_shaft_number(own, SHAFT_INERTIA);
    for (size_t way = 0; way < 2; way++) {
        const vec lever = v_fms(running_shaft_number(own, SHAFT_GUIDED + 2 * way), s,
                                v_mul(running_shaft_number(own, SHAFT_GUIDED + 2 * way + 1), c));
        reaction = v_fnma(lever, pull[way], reaction);
    }
    for (size_t j = 0; j < r->lanes.lever_count; j++) {
        const size_t row = r->lanes.lever[j];
        const vec lever = running_lever(own, j, c, s);
        const vec unit = running_lever_number(own, j, LEVER_UNIT);
        const vec moved = v_fms(v_mul(unit, square), own->a[row * own->stride + own->k], pull[r->along[row]]);
        reaction = v_fma(lever, moved, reaction);
        inertia = v_fnma(v_mul(lever, unit), *running_row(own, r->lanes.now + j), inertia);
    }
    *by = inertia;
    return v_div(v_add(v_div(whole, running_shaft_number(own, SHAFT_SQUARE)), reaction), inertia);
}

/// Returns the derivative by the speed w of theta'' where torques drive the shafts, at constant accelerations.
static vec running_torques_by_speed(const running_vector *own, vec w, vec c, vec s, vec inertia) {
    const running_rotor *r = own->r;
    const vec unit = running_shaft_number(own, SHAFT_UNIT), speed = v_mul(w, unit);
    const vec twice = v_mul(v_set(2.0), running_shaft_number(own, SHAFT_QUADRATIC));
    const vec load = v_fma(twice, speed, running_shaft_number(own, SHAFT_LINEAR));
    const vec fall = v_mul(unit, v_add(running_shaft_number(own, SHAFT_FALL), load));
    vec sum = v_sub(v_set(0.0), v_div(fall, running_shaft_number(own, SHAFT_SQUARE)));
    for (size_t j = 0; j < r->lanes.lever_count; j++) {
        const vec a = own->a[r->lanes.lever[j] * own->stride + own->k];
        const vec by_speed = v_mul(v_mul(v_set(2.0), w), running_lever_number(own, j, LEVER_UNIT));
        sum = v_fma(running_lever(own, j, c, s), v_mul(by_speed, a), sum);
    }
    return v_div(sum, inertia);
}

/// Adds the effect of theta'' to the accelerations by the angle, and writes the slopes of speed and time.
static void running_add_turn(const running_vector *own, vec w, vec all) {
    const running_rotor *r = own->r;
    const size_t degrees = r->rotor->lanes.degrees, at = running_speed_row(r) * own->stride + own->k;
    const vec inverse = v_div(v_set(1.0), w), slope = v_mul(all, inverse), share = v_mul(slope, inverse);
    for (size_t i = own->k; i < degrees * own->stride; i += own->stride)
        own->a[i] = v_fnma(share, own->v[i], own->a[i]);
    for (size_t j = 0; j < r->lanes.lever_count; j++) {
        vec *a = own->a + r->lanes.lever[j] * own->stride + own->k;
        *a = v_fma(share, *running_row(own, r->lanes.now + j), *a);
    }
    own->a[at] = slope;
    own->a[at + own->stride] = inverse;
}

/// Evaluates the slopes of the rotors with the numbers at the present speeds times `share`, for the state alone.
static void running_slopes_near(const lanes_view *view, double share, vec *slopes) {
    lanes_view rotors = running_rotor_view(view);
    rotors.tangents = 0;
    rotors.columns = NULL;
    rotors.a = slopes;
    running_put_numbers(view, share);
    ISA(machine_flow)(&rotors);
}

/// Adds the derivative of the rotor's slopes by the speed, through numbers, to the unit perturbation of the speed.
static void running_add_numbers(const lanes_view *view, const running_vector *own) {
    const running_rotor *r = own->r;
    const size_t degrees = r->rotor->lanes.degrees, stride = own->stride, k = own->k;
    const size_t next = (r->form.degrees + r->form.states) * stride;
    const vec *nearby = running_row(own, r->lanes.nearby);
    vec *by_speed = own->a + (1 + view->columns[degrees + running_speed_row(r)]) * next + k;
    const vec apart = v_div(v_set(1.0 / running_apart), running_speed(own));
    for (size_t i = 0; i < (degrees + r->rotor->lanes.states) * stride; i += stride)
        by_speed[i] = v_fma(v_sub(nearby[i], own->a[i + k]), apart, by_speed[i]);
}

/// The turn of the shafts in one vector: theta'' over the square of the unit of speed, the speed, cosine and sine of
/// the angle, and the inertia by which torques are divided.
typedef struct running_turn {
    vec all, w, c, s, inertia;
} running_turn;

/// Writes the derivative of theta'' by every unit perturbation to the row of the speed, which is 0 before, where
/// torques drive the shafts. Slopes are still without theta''.
static void running_derive_torques(const lanes_view *view, const running_vector *own, const running_turn *turn) {
    const running_rotor *r = own->r;
    const size_t stride = own->stride, at = running_speed_row(r);
    const size_t next = (r->form.degrees + r->form.states) * stride;
    const vec driven = running_shaft_number(own, SHAFT_DRIVEN), square = v_mul(turn->w, turn->w);
    vec *first = own->a + next + own->k, *all = first + at * stride;
    // Sum the torques of unbalances on the shafts.
    for (size_t j = 0; j < r->lanes.lever_count; j++) {
        const vec lever = v_mul(running_lever(own, j, turn->c, turn->s), running_lever_number(own, j, LEVER_UNIT));
        const vec weight = v_mul(lever, square), *a = first + r->lanes.lever[j] * stride;
        for (size_t n = 0; n < view->tangents; n++) all[n * next] = v_fma(weight, a[n * next], all[n * next]);
    }
    for (size_t n = 0; n < view->tangents; n++) all[n * next] = v_div(all[n * next], turn->inertia);
    // Add the effect of the speed on torques.
    vec *by_speed = all + view->columns[r->rotor->lanes.degrees + at] * next;
    *by_speed = v_add(*by_speed, running_torques_by_speed(own, turn->w, turn->c, turn->s, turn->inertia));
    for (size_t n = 0; n < view->tangents; n++) all[n * next] = v_mul(driven, all[n * next]);
}

/// Adds the effect of theta'' to the slopes of unit perturbations. Those of the state are still without it.
static void running_add_units(const lanes_view *view, const running_vector *own, const running_turn *turn) {
    const running_rotor *r = own->r;
    const size_t degrees = r->rotor->lanes.degrees, stride = own->stride, k = own->k, at = running_speed_row(r);
    const size_t next = (r->form.degrees + r->form.states) * stride;
    const size_t *const unit_v = view->columns + degrees;
    const vec inverse = v_div(v_set(1.0), turn->w), square = v_mul(inverse, inverse);
    const vec slope = v_mul(turn->all, inverse), share = v_mul(slope, inverse);
    if (r->driven) running_derive_torques(view, own, turn);
    // Add the derivative of theta''/w^2, the factor of all effects of theta''. If theta'' is given only the speed has
    // one.
    const size_t first = r->driven ? 1 : 1 + unit_v[at], last = r->driven ? view->tangents : first;
    for (size_t n = first; n <= last; n++) {
        vec *a = own->a + n * next + k;
        const vec moved = own->v[n * next + at * stride + k], all = a[at * stride]; // moved: of the speed
        const vec by = v_mul(square, v_fnma(v_mul(v_set(2.0), slope), moved, all));
        for (size_t i = 0; i < degrees; i++) a[i * stride] = v_fnma(by, own->v[i * stride + k], a[i * stride]);
        for (size_t j = 0; j < r->lanes.lever_count; j++) {
            vec *lever = a + r->lanes.lever[j] * stride;
            *lever = v_fma(by, *running_row(own, r->lanes.now + j), *lever);
        }
        a[at * stride] = v_mul(inverse, v_fnma(slope, moved, all));
        a[(at + 1) * stride] = v_mul(square, v_sub(v_set(0.0), moved));
    }
    // The slopes of velocities fall by theta''/w^2 times the velocities.
    for (size_t i = 0; i < degrees; i++) {
        vec *a = own->a + (1 + unit_v[i]) * next + i * stride + k;
        *a = v_sub(*a, share);
    }
}

void ISA(running_flow)(const lanes_view *view) {
    const running_rotor *r = view->model;
    const lanes_view rotors = running_rotor_view(view);
    const vec way = v_set(r->rotor->way);
    // Compute the slopes of the rotors at constant speeds, and for perturbations at a speed nearby.
    if (view->tangents > 0)
        running_slopes_near(view, 1.0 + running_apart, (vec *)view->numbers + r->lanes.nearby * view->stride);
    running_put_numbers(view, 1.0);
    ISA(machine_flow)(&rotors);
    if (r->driven && r->rotor->contact_count > 0) {
        vec *force = (vec *)view->numbers + r->lanes.contacts * view->stride;
        ISA(machine_contacts)(&rotors, force, force + r->rotor->contact_count * view->stride);
    }
    // Compute the slopes of the shafts' speeds and times.
    for (size_t k = 0; k < view->vectors; k++) {
        const running_vector own = running_vector_of(view, k);
        const vec w = running_speed(&own);
        const vec c = own.forcing[COS_TAU * own.stride + k], s = own.forcing[SIN_TAU * own.stride + k];
        running_turn turn = {running_shaft_number(&own, SHAFT_RATE), w, v_mul(way, c), v_mul(way, s), v_set(1.0)};
        if (view->tangents > 0) running_add_numbers(view, &own);
        running_put_levers(&own, c, s, way);
        if (r->driven) {
            const vec_mask driven = v_less(v_set(0.5), running_shaft_number(&own, SHAFT_DRIVEN));
            const vec all = running_by_torques(&own, w, turn.c, turn.s, &turn.inertia);
            turn.all = v_select(driven, all, turn.all);
        }
        if (view->tangents > 0) running_add_units(view, &own, &turn);
        running_add_turn(&own, w, turn.all);
    }
}

/// Evaluates the switches with the numbers at the speeds times a share.
static void running_switches_near(const lanes_view *view, double share, vec *values) {
    const lanes_view rotors = running_rotor_view(view);
    running_put_numbers(view, share);
    ISA(machine_switches)(&rotors, values, NULL);
}

/// Writes the switches, and their derivatives by the angle. The part of these by the speed, on which switches depend
/// through the numbers, is a difference quotient.
void ISA(running_switches)(const lanes_view *view, void *values, void *rates) {
    const running_rotor *r = view->model;
    const lanes_view rotors = running_rotor_view(view);
    const size_t switches = r->rotor->lanes.switch_count, stride = view->stride;
    const double apart = 1e-6;
    vec *high = (vec *)view->numbers + r->lanes.switches * stride, *low = high + switches * stride;
    running_put_numbers(view, 1.0);
    ISA(machine_switches)(&rotors, values, rates);
    if (!rates) return;
    running_switches_near(view, 1.0 + apart, high);
    running_switches_near(view, 1.0 - apart, low);
    for (size_t k = 0; k < view->vectors; k++) {
        const running_vector own = running_vector_of(view, k);
        const vec slope = own.a[running_speed_row(r) * stride + k];
        const vec by_share = v_div(slope, v_mul(v_set(2.0 * apart), running_speed(&own)));
        for (size_t i = k; i < switches * stride; i += stride)
            ((vec *)rates)[i] = v_fma(v_sub(high[i], low[i]), by_share, ((vec *)rates)[i]);
    }
}

void ISA(running_forcing)(const void *model, size_t stride, size_t vectors, const void *t, void *forcing) {
    ISA(machine_forcing)(((const running_rotor *)model)->rotor, stride, vectors, t, forcing);
}
