// The system of a rotor, by the one-lane build of its kernels.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "machine.h"

static lanes_view view_of(const whirl_rotor *rotor, const double *forcing, const double *sides) {
    return (lanes_view){
        .model = rotor, .stride = 1, .vectors = 1, .numbers = rotor->numbers, .forcing = forcing, .sides = sides};
}

/// Returns a view of one state as a lane of the kernels.
static lanes_view view_at(const whirl_rotor *rotor, const double *forcing, const double *sides, const double *x) {
    lanes_view view = view_of(rotor, forcing, sides);
    view.q = x;
    view.v = x + rotor->lanes.degrees;
    return view;
}

void rotor_flow_with(const whirl_rotor *rotor, double *numbers, const double *forcing, const double *sides,
                     const double *x, double *dxdt) {
    const size_t degrees = rotor->lanes.degrees;
    lanes_view view = view_at(rotor, forcing, sides, x);
    view.numbers = numbers;
    view.a = dxdt + degrees;
    memcpy(dxdt, x + degrees, degrees * sizeof *dxdt);
    machine_flow_scalar(&view);
}

void rotor_switches_with(const whirl_rotor *rotor, double *numbers, const double *x, double *values) {
    lanes_view view = view_at(rotor, NULL, NULL, x);
    view.numbers = numbers;
    machine_switches_scalar(&view, values, NULL);
}

void rotor_contacts_with(const whirl_rotor *rotor, double *numbers, const double *x, double *normal_force,
                         double *friction) {
    lanes_view view = view_at(rotor, NULL, NULL, x);
    view.numbers = numbers;
    machine_contacts_scalar(&view, normal_force, friction);
}

static void forcing_at(const void *model, double t, double *forcing) {
    machine_forcing_scalar(model, 1, 1, &t, forcing);
}

static void rotor_rhs_on_sides(const void *model, double t, const double *forcing, const double *x, const double *sides,
                               double *dxdt) {
    const whirl_rotor *rotor = model;
    const size_t degrees = rotor->lanes.degrees;
    lanes_view view = view_at(rotor, forcing, sides, x);
    (void)t;
    view.a = dxdt + degrees;
    memcpy(dxdt, x + degrees, degrees * sizeof *dxdt);
    machine_flow_scalar(&view);
}

static void rotor_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    rotor_rhs_on_sides(model, t, forcing, x, NULL, dxdt);
}

static void rotor_switches(const void *model, double t, const double *x, double *values) {
    const lanes_view view = view_at(model, NULL, NULL, x);
    (void)t;
    machine_switches_scalar(&view, values, NULL);
}

static void rotor_contact_forces(const void *model, const double *x, double *normal_force) {
    const lanes_view view = view_at(model, NULL, NULL, x);
    machine_contacts_scalar(&view, normal_force, NULL);
}

static void rotor_friction(const void *model, const double *x, double *friction) {
    const lanes_view view = view_at(model, NULL, NULL, x);
    double normal_force[WHIRL_MAX_CONTACTS];
    machine_contacts_scalar(&view, normal_force, friction);
}

/// The state and as many perturbations as fit. Positions are separate from the other numbers, as lanes need them.
typedef struct group {
    double q[2 * MAX_DEGREES], v[2 * MAX_ROWS], a[2 * MAX_ROWS];
} group;

/// Copies the state or perturbation x to place n of the group: its positions to q, its other numbers to v.
static void rotor_put(const whirl_rotor *rotor, double *q, double *v, size_t n, const double *x) {
    const size_t degrees = rotor->lanes.degrees, rows = degrees + rotor->lanes.states;
    memcpy(q + n * degrees, x, degrees * sizeof *x);
    memcpy(v + n * rows, x + degrees, rows * sizeof *x);
}

static void rotor_get(const whirl_rotor *rotor, const group *g, size_t n, double *slope) {
    const size_t degrees = rotor->lanes.degrees, rows = degrees + rotor->lanes.states;
    memcpy(slope, g->v + n * rows, degrees * sizeof *slope);
    memcpy(slope + degrees, g->a + n * rows, rows * sizeof *slope);
}

static void rotor_tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                          size_t count, const double *dx, double *ddxdt) {
    const whirl_rotor *rotor = model;
    const size_t dimension = rotor->system.dimension;
    const size_t degrees = rotor->lanes.degrees, rows = degrees + rotor->lanes.states;
    const size_t by_q = (size_t)2 * MAX_DEGREES / degrees, by_v = (size_t)2 * MAX_ROWS / rows;
    const size_t most = (by_q < by_v ? by_q : by_v) - 1;
    lanes_view view = view_of(rotor, forcing, sides);
    group g;
    (void)t;
    view.q = g.q;
    view.v = g.v;
    view.a = g.a;
    rotor_put(rotor, g.q, g.v, 0, x);
    for (size_t first = 0; first < count; first += most) {
        view.tangents = count - first < most ? count - first : most;
        for (size_t k = 0; k < view.tangents; k++) rotor_put(rotor, g.q, g.v, k + 1, dx + (first + k) * dimension);
        machine_flow_scalar(&view);
        for (size_t k = 0; k < view.tangents; k++) rotor_get(rotor, &g, k + 1, ddxdt + (first + k) * dimension);
    }
}

static double divergence_at(const void *model, double t, const double *forcing, const double *x, const double *sides) {
    const whirl_rotor *rotor = model;
    double a[MAX_ROWS], divergence;
    lanes_view view = view_at(rotor, forcing, sides, x);
    (void)t;
    view.a = a;
    view.divergence = &divergence;
    machine_flow_scalar(&view);
    return divergence;
}

/// Returns the element that has switch *index. *index becomes the switch's index in that element.
static const element *owner_of(const whirl_rotor *rotor, size_t *index) {
    const element *own = rotor->elements;
    for (;; own++) {
        const size_t count = own->type->switch_count ? own->type->switch_count(own) : 0;
        if (*index < count) return own;
        *index -= count;
    }
}

/// Converts a derivative by the inputs of an element to one by the state.
static void spread(const whirl_rotor *rotor, const element *own, const element_place *by, double *out) {
    const size_t degrees = rotor->lanes.degrees;
    memset(out, 0, rotor->system.dimension * sizeof *out);
    for (size_t p = 0; p < MAX_PORTS; p++) {
        if (own->port[p] == NO_COORDINATE) continue;
        out[own->port[p]] = by->q[p];
        out[degrees + own->port[p]] = by->v[p];
    }
    memcpy(out + degrees + own->state, by->s, rotor_states_seen(own) * sizeof *out);
}

static void switch_gradient(const void *model, double t, const double *x, size_t index, double *gradient,
                            double *by_time) {
    const element *own = owner_of(model, &index);
    const element_place at = rotor_see(model, own, x);
    element_place by = {.q = {0.0}};
    (void)t;
    *by_time = 0.0;
    own->type->switch_gradient(own, &at, index, &by);
    spread(model, own, &by, gradient);
}

void rotor_gradient_with(const whirl_rotor *rotor, double *numbers, const double *x, size_t index, double *gradient) {
    element own = *owner_of(rotor, &index);
    const element_place at = rotor_see(rotor, &own, x);
    element_place by = {.q = {0.0}};
    own.number = numbers + own.first_number;
    own.type->switch_gradient(&own, &at, index, &by);
    spread(rotor, &own, &by, gradient);
}

static void switch_curvature(const void *model, double t, const double *x, size_t index, const double *u, double *out) {
    const element *own = owner_of(model, &index);
    const element_place at = rotor_see(model, own, x), along = rotor_see(model, own, u);
    element_place by = {.q = {0.0}};
    (void)t;
    own->type->switch_curvature(own, &at, index, &along, &by);
    spread(model, own, &by, out);
}

/// Returns true if a contact begins at a switch: at the first switch of elements with a gap all around, at each switch
/// of springs and looseness.
static bool switch_touches(const void *model, size_t index) {
    const element *own = owner_of(model, &index);
    if (own->type->touches) return own->type->touches(own, index);
    return !own->type->contact_gap || index == 0;
}

static bool rotor_named_order(const void *model, size_t index, whirl_named_order *out) {
    const whirl_rotor *rotor = model;
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i];
        const char *name;
        for (size_t k = 0; own->type->named_order && own->type->named_order(own, k, &out->order, &name); k++) {
            if (index-- > 0) continue;
            out->probe = own->station;
            snprintf(out->name, sizeof out->name, "%s", name);
            snprintf(out->part, sizeof out->part, "%s at %s", own->type->group.name, rotor->probes[own->station].name);
            return true;
        }
    }
    return false;
}

/// Returns the extremes as an element sees them; NaN for unknown ones.
static element_seen see_extremes(const whirl_rotor *rotor, const element *own, const whirl_extremes *of) {
    const size_t first = rotor->lanes.degrees + own->state;
    const whirl_probe *probe = &rotor->probes[own->station];
    element_seen seen = {.radius = NAN, .state_low = of->low + first, .state_high = of->high + first};
    bool grounded = true;
    for (size_t p = 0; p < MAX_PORTS; p++) {
        if (own->port[p] == NO_COORDINATE) continue;
        seen.low[p] = of->low[own->port[p]];
        seen.high[p] = of->high[own->port[p]];
        grounded = grounded && (own->port[p] == probe->x || own->port[p] == probe->y);
    }
    if (grounded) seen.radius = of->max_radius[own->station];
    return seen;
}

static bool rotor_range(const void *model, size_t index, const whirl_extremes *seen, whirl_law_range *out) {
    // Without extremes it is unknown what a part has reached.
    static const double none[MAX_OWN_STATES];
    const whirl_rotor *rotor = model;
    const element_seen nothing = {.radius = NAN, .state_low = none, .state_high = none};
    element_range found;
    // Count the ranges of all parts up to the requested one.
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i];
        const element_seen at = seen ? see_extremes(rotor, own, seen) : nothing;
        for (size_t k = 0; own->type->range; k++) {
            if (!own->type->range(own, k, &at, &found)) break;
            if (index-- > 0) continue;
            *out = (whirl_law_range){.quantity = found.quantity,
                                     .unit = found.unit,
                                     .limit = found.limit,
                                     .most = found.most,
                                     .reached = seen ? found.reached : NAN,
                                     .probe = own->station};
            snprintf(out->part, sizeof out->part, "%s at %s", own->type->group.name, rotor->probes[own->station].name);
            return true;
        }
    }
    return false;
}

static size_t count_loops(const whirl_rotor *rotor) {
    size_t count = 0;
    for (size_t i = 0; i < rotor->element_count; i++) count += rotor->elements[i].type->loops;
    return count;
}

static void rotor_loop(const void *model, const double *x, size_t index, double *input, double *sensed) {
    const whirl_rotor *rotor = model;
    const size_t degrees = rotor->lanes.degrees;
    const element *own = rotor->elements;
    for (; index >= own->type->loops; own++) index -= own->type->loops;
    const element_place at = rotor_see(rotor, own, x);
    double acceleration[MAX_PORTS] = {0}, seen[MAX_PORTS] = {0};
    memset(input, 0, rotor->system.dimension * sizeof *input);
    memset(sensed, 0, rotor->system.dimension * sizeof *sensed);
    own->type->loop(own, at.q, x + degrees + own->state, index, acceleration, input + degrees + own->state, seen);
    for (size_t p = 0; p < MAX_PORTS; p++) {
        if (own->port[p] == NO_COORDINATE) continue;
        sensed[own->port[p]] = seen[p];
        for (size_t row = 0; row < degrees; row++)
            if (row == own->port[p] || rotor->coupled.count > 0)
                input[degrees + row] +=
                    acceleration[p] *
                    (rotor->coupled.count > 0 ? coupling_share(&rotor->coupled, row, own->port[p]) : 1.0);
    }
}

static bool counts_time(const element *own) {
    return own->type->clock && own->type->clock(own) < own->states;
}

static bool rotor_settle(const void *model, double *x, whirl_settled *kinds) {
    const whirl_rotor *rotor = model;
    bool balanced = true;
    for (size_t i = 0; i < rotor->system.dimension; i++) kinds[i] = WHIRL_NOT_SETTLED;
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i];
        const size_t first = rotor->lanes.degrees + own->state;
        bool idle[MAX_ELEMENT_STATES] = {false};
        if (counts_time(own)) kinds[first + own->type->clock(own)] = WHIRL_IDLE;
        if (!own->type->settle) continue;
        const element_place at = rotor_see(rotor, own, x);
        balanced = own->type->settle(own, at.q, x + first, idle) && balanced;
        for (size_t k = 0; k < own->states; k++) kinds[first + k] = idle[k] ? WHIRL_IDLE : WHIRL_SETTLED;
    }
    return balanced;
}

/// Returns the station that moves with one of two ports, or station_count if none does.
static size_t station_of_ports(const whirl_rotor *rotor, const size_t port[2]) {
    size_t station = 0;
    for (; station < rotor->station_count; station++)
        for (size_t i = 0; i < 2; i++)
            if (port[i] == rotor->probes[station].x || port[i] == rotor->probes[station].y) return station;
    return station;
}

/// Returns the film of an element between its ports 2 index and 2 index + 1, which are the journal's, and the ports of
/// its housing.
static element_film film_of(const whirl_rotor *rotor, const element *own, const double *x, size_t index) {
    const element_type *type = own->type;
    const element_place at = rotor_see(rotor, own, x);
    const size_t journal = 2 * index, housing = journal + (type->ring_clearance ? 4 : 2);
    element_film out = {.clearance = index > 0 ? type->ring_clearance(own) : type->bearing_clearance(own)};
    out.least = out.wall = out.clearance;
    out.least -= hypot(at.q[journal] - at.q[housing], at.q[journal + 1] - at.q[housing + 1]);
    if (type->film) type->film(own, at.q, x + rotor->lanes.degrees + own->state, &out);
    for (size_t a = 0; a < 2; a++) out.place[a] = at.q[journal + a] - at.q[housing + a];
    out.housing = station_of_ports(rotor, own->port + housing);
    return out;
}

static bool film(const void *model, const double *x, size_t probe, whirl_film_gap *out) {
    const whirl_rotor *rotor = model;
    bool found = false;
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i];
        const size_t films = !own->type->bearing_clearance ? 0 : own->type->ring_clearance ? 2 : 1;
        for (size_t k = 0; k < films; k++) {
            if ((k == 0 ? own->station : station_of_ports(rotor, own->port + 2 * k)) != probe) continue;
            const element_film one = film_of(rotor, own, x, k);
            if (!found || one.least < out->least) *out = one;
            found = true;
        }
    }
    return found;
}

/// Finds the corresponding element of another rotor: the one of the same type, at the same station, and with the same
/// index among these.
static const element *counterpart(const whirl_rotor *rotor, const element *own, const whirl_rotor *other) {
    size_t before = 0;
    for (const element *e = rotor->elements; e < own; e++) before += e->type == own->type && e->station == own->station;
    for (size_t i = 0; i < other->element_count; i++) {
        const element *e = &other->elements[i];
        if (e->type == own->type && e->station == own->station && before-- == 0) return e;
    }
    return NULL;
}

static void rotor_adopt(const void *model, double *x, const whirl_system *other, const double *y) {
    const whirl_rotor *rotor = model, *from = other->model;
    if (other->adopt != rotor_adopt) return;
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i], *same = own->states > 0 ? counterpart(rotor, own, from) : NULL;
        if (!same || same->states != own->states) continue;
        memcpy(x + rotor->lanes.degrees + own->state, y + from->lanes.degrees + same->state, own->states * sizeof *x);
    }
}

/// Returns the share of coordinates in the kinetic energy of a small motion, with masses lumped.
static double rotor_energy_share(const whirl_rotor *rotor, const double *v, size_t first, size_t count) {
    double some = 0.0, all = 0.0;
    for (size_t d = 0; d < rotor->lanes.degrees; d++) {
        const double size = rotor->unit[d] * hypot(v[2 * d], v[2 * d + 1]), energy = rotor->inertia[d] * size * size;
        all += energy;
        if (d - first < count) some += energy;
    }
    return all > 0.0 ? some / all : 0.0;
}

static double rotor_twist(const void *model, const double *v, double *shape) {
    const whirl_rotor *rotor = model;
    for (size_t s = 0; s < rotor->station_count; s++)
        for (size_t c = 0; c < 2; c++) {
            const station_twist *own = &rotor->twists[s];
            shape[2 * s + c] = own->coordinate == NO_COORDINATE
                                   ? 0.0
                                   : own->share * rotor->unit[own->coordinate] * v[2 * own->coordinate + c];
        }
    return rotor_energy_share(rotor, v, rotor->first_twist, rotor->twist_count);
}

static double rotor_axial(const void *model, const double *v, double *shape) {
    const whirl_rotor *rotor = model;
    for (size_t s = 0; s < rotor->station_count; s++) {
        const size_t own = rotor->axials[s];
        for (size_t c = 0; c < 2; c++)
            shape[2 * s + c] = own == NO_COORDINATE ? 0.0 : rotor->unit[own] * v[2 * own + c];
    }
    return rotor_energy_share(rotor, v, rotor->first_axial, rotor->axial_count);
}

static bool rotor_settles(const whirl_rotor *rotor) {
    for (size_t i = 0; i < rotor->element_count; i++)
        if (rotor->elements[i].type->settle || counts_time(&rotor->elements[i])) return true;
    return false;
}

const whirl_rotor *rotor_of_system(const whirl_system *system) {
    return system->rhs == rotor_rhs ? system->model : NULL;
}

void rotor_system_fill(whirl_rotor *rotor) {
    rotor->system = (whirl_system){.dimension = 2 * rotor->lanes.degrees + rotor->lanes.states,
                                   .period = 6.283185307179586476925,
                                   .forcing_count = FORCING_COUNT,
                                   .kinked = rotor->kinked,
                                   .turns = rotor->turning ? rotor->turns : NULL,
                                   .repeats = rotor->repeats,
                                   .forcing = forcing_at,
                                   .rhs = rotor_rhs,
                                   .switch_count = rotor->lanes.switch_count,
                                   .switches = rotor_switches,
                                   .rhs_on_sides = rotor_rhs_on_sides,
                                   .tangent = rotor_tangent,
                                   .divergence = divergence_at,
                                   .switch_gradient = switch_gradient,
                                   .switch_curvature = switch_curvature,
                                   .switch_touches = switch_touches,
                                   .named_order = rotor_named_order,
                                   .contact_count = rotor->contact_count,
                                   .contacts = rotor_contact_forces,
                                   .friction = rotor->lanes.rubs || !rotor->mute ? rotor_friction : NULL,
                                   .frequency_count = rotor->frequency_count,
                                   .frequencies = rotor->frequencies,
                                   .probe_count = rotor->station_count,
                                   .probes = rotor->probes,
                                   .loop_count = count_loops(rotor),
                                   .loop = rotor_loop,
                                   .range = rotor_range,
                                   .settle = rotor_settles(rotor) ? rotor_settle : NULL,
                                   .film = film,
                                   .adopt = rotor_adopt,
                                   .twist = rotor->twist_count > 0 ? rotor_twist : NULL,
                                   .axial = rotor->axial_count > 0 ? rotor_axial : NULL,
                                   .extra_count = rotor->extra_count,
                                   .extras = rotor->extras,
                                   .torque_count = rotor_watched_count(rotor),
                                   .shaft_count = rotor->shaft_count,
                                   .spool_count = rotor->spool_count,
                                   .spools = rotor->spools,
                                   .torsion = rotor->twist_count > 0 ? &rotor->torsion : NULL,
                                   .model = rotor,
                                   .lanes = &rotor->lanes};
}
