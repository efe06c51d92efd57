// Excitations of the twists of a rotor, and paths of torque from station to station, for the response to torques
// (whirl/engine/torsion.h).
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "machine.h"
#include "registry.h"
#include "table.h"

// ---------------------------------------------------------------- excitations

/// Returns the speed of a station in the rigid turn, rad/s.
static double torsion_speed(const void *model, size_t station) {
    const whirl_rotor *rotor = model;
    return rotor_turns(rotor, station) * fabs(rotor->speed);
}

static bool torsion_twists(const void *model, size_t station) {
    return ((const whirl_rotor *)model)->twists[station].coordinate != NO_COORDINATE;
}

/// Returns the torque of a table at the speed of its station, N m.
static double torsion_table(const whirl_rotor *rotor, const harmonic_torque *own) {
    if (own->count == 1) return own->torques[0];
    const double speed = torsion_speed(rotor, own->station);
    return table_value(own->count, own->speeds, own->torques,
                       fmin(fmax(speed, own->speeds[0]), own->speeds[own->count - 1]));
}

/// Returns 1; or -1 for a torque that is positive along the rotation of a station which turns against z.
static double torsion_sense(const whirl_rotor *rotor, const harmonic_torque *own) {
    const station_twist *at = &rotor->twists[own->station];
    return own->about_z ? 1.0 : copysign(1.0, rotor->rigid[at->coordinate] * at->share);
}

static whirl_excitation torsion_rate(const whirl_rotor *rotor, const harmonic_torque *own) {
    const double speed = fabs(rotor->speed);
    if (own->of == HARMONIC_FIXED)
        return (whirl_excitation){true, speed > 0.0 ? own->rate / speed : (double)NAN, own->rate};
    const double order = own->of == HARMONIC_BY_STATION ? own->rate * rotor_turns(rotor, own->station) : own->rate;
    return (whirl_excitation){false, order, order * speed};
}

/// Returns true if two excitations have the same frequency. Fixed frequencies and orders of the speed are kept apart.
static bool torsion_are_one(const whirl_excitation *a, const whirl_excitation *b) {
    static const double rounding = 1e-9;
    if (a->fixed != b->fixed) return false;
    const double one = a->fixed ? a->frequency : a->order, other = b->fixed ? b->frequency : b->order;
    return fabs(one - other) <= rounding * fmax(one, other);
}

static void torsion_add_excitation(whirl_rotor *rotor, whirl_excitation own) {
    for (size_t i = 0; i < rotor->excitation_count; i++)
        if (torsion_are_one(&rotor->excitations[i], &own)) return;
    rotor->excitations[rotor->excitation_count++] = own;
}

bool rotor_carries(const whirl_rotor *rotor, const element *own) {
    if (!own->type->carry || own->lumped) return false;
    for (size_t p = 0; p < MAX_PORTS; p++)
        if (own->port[p] != NO_COORDINATE && own->port[p] - rotor->first_twist < rotor->twist_count) return true;
    return false;
}

static const element_place at_centre;

/// Returns the excitation by the error of a mesh, with order 0 if there is none.
static whirl_excitation torsion_error(const whirl_rotor *rotor, const element *own) {
    element_carried carried;
    if (!rotor_carries(rotor, own)) return (whirl_excitation){.order = 0.0};
    own->type->carry(own, &at_centre, &carried);
    const double frequency = carried.error_order * rotor->clock, speed = fabs(rotor->speed);
    return (whirl_excitation){false, speed > 0.0 ? frequency / speed : carried.error_order, frequency};
}

static void torsion_excitation(const void *model, size_t index, whirl_excitation *out) {
    *out = ((const whirl_rotor *)model)->excitations[index];
}

static bool torsion_drives(const whirl_rotor *rotor, const harmonic_torque *own, size_t index) {
    if (own->of == HARMONIC_STEADY || index >= rotor->excitation_count)
        return own->of == HARMONIC_STEADY && index == rotor->excitation_count;
    const whirl_excitation rate = torsion_rate(rotor, own);
    return torsion_are_one(&rate, &rotor->excitations[index]);
}

static whirl_status torsion_check(const void *model) {
    static const double rounding = 1e-9; // as for tables over the speed (bearing.c)
    const whirl_rotor *rotor = model;
    for (size_t i = 0; i < rotor->harmonic_count; i++) {
        const harmonic_torque *own = &rotor->harmonics[i];
        const char *name = rotor->probes[own->station].name;
        const double speed = torsion_speed(rotor, own->station);
        if (own->of == HARMONIC_BY_STATION && speed == 0.0 && rotor->speed != 0.0)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "nothing joins the twist of station '%s' to the shaft whose speed is given, so that "
                              "orders of its own speed are not known, expected a coupling, a gear or a spring",
                              name);
        if (own->count > 1 &&
            (speed < own->speeds[0] * (1.0 - rounding) || speed > own->speeds[own->count - 1] * (1.0 + rounding)))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "the torques at station '%s' are known from %g to %g rad/s, and it turns at %g rad/s",
                              name, own->speeds[0], own->speeds[own->count - 1], speed);
    }
    return whirl_ok();
}

// ---------------------------------------------------------------- steady torques

/// Returns the torque of the drive's load, along the rotation of its station. *station becomes that station, or
/// NO_STATION if there is no load.
static double torsion_load(const whirl_rotor *rotor, size_t *station) {
    *station = rotor->drive.given ? rotor->drive.load_at : NO_STATION;
    if (*station == NO_STATION || rotor->twists[*station].coordinate == NO_COORDINATE) *station = NO_STATION;
    return *station == NO_STATION ? 0.0 : -drive_load(&rotor->drive, torsion_speed(rotor, *station), 0.0);
}

/// Returns the sum of the steady torques that the equations do not contain, without the motor of the drive, referred to
/// the rotor's speed, along its rotation.
static double torsion_sum(const whirl_rotor *rotor, double *size) {
    size_t loaded;
    const double load = torsion_load(rotor, &loaded);
    double sum = loaded == NO_STATION ? 0.0 : load * rotor_turns(rotor, loaded);
    *size = fabs(sum);
    for (size_t i = 0; i < rotor->harmonic_count; i++) {
        const harmonic_torque *own = &rotor->harmonics[i];
        if (own->of != HARMONIC_STEADY || own->felt) continue;
        const double part = torsion_table(rotor, own) * rotor_turns(rotor, own->station);
        sum += part;
        *size += fabs(part);
    }
    return sum;
}

/// Returns the torque of the motor, which balances the other torques: the first motor, or that of the drive. *station
/// becomes its station, or NO_STATION if there is no motor.
static double torsion_motor(const whirl_rotor *rotor, size_t *station) {
    bool driven = rotor->drive.given;
    double size;
    for (size_t i = 0; i < rotor->torque_count; i++) driven = driven || rotor->torques[i].law->motor;
    *station = driven && rotor->driver < rotor->station_count ? rotor->driver : NO_STATION;
    return *station == NO_STATION ? 0.0 : -torsion_sum(rotor, &size) / rotor_turns(rotor, *station);
}

static double torsion_unbalanced(const void *model, double *size) {
    size_t motor;
    const double sum = torsion_sum(model, size);
    torsion_motor(model, &motor);
    return motor == NO_STATION ? sum : 0.0;
}

/// Adds the complex torque of an excitation on a station, about z. felt: includes steady torques that the equations
/// contain.
static void torsion_at(const whirl_rotor *rotor, size_t station, size_t index, bool felt, double torque[2]) {
    for (size_t i = 0; i < rotor->harmonic_count; i++) {
        const harmonic_torque *own = &rotor->harmonics[i];
        if (own->station != station || (own->felt && !felt) || !torsion_drives(rotor, own, index)) continue;
        const double size = torsion_sense(rotor, own) * torsion_table(rotor, own);
        torque[0] += size * cos(own->phase);
        torque[1] += size * sin(own->phase);
    }
    if (index < rotor->excitation_count) return;
    const double sense = copysign(1.0, rotor->rigid[rotor->twists[station].coordinate] * rotor->twists[station].share);
    size_t loaded, driven;
    const double load = torsion_load(rotor, &loaded), motor = torsion_motor(rotor, &driven);
    if (loaded == station) torque[0] += sense * load;
    if (driven == station) torque[0] += sense * motor;
}

/// Adds the forces of a mesh's error on coordinates, N or N m: real parts [degrees], then imaginary parts.
static void torsion_add_error(const whirl_rotor *rotor, const element *own, size_t index, double *force) {
    const whirl_excitation rate = torsion_error(rotor, own);
    if (!(rate.order > 0.0) || index >= rotor->excitation_count || !torsion_are_one(&rate, &rotor->excitations[index]))
        return;
    element_carried by;
    own->type->carry(own, &at_centre, &by);
    const double w = by.error_order, pressed[2] = {by.stiffness * by.error[0] - w * by.damping * by.error[1],
                                                   by.stiffness * by.error[1] + w * by.damping * by.error[0]};
    for (size_t p = 0; p < MAX_PORTS; p++) {
        const size_t c = own->port[p];
        if (c == NO_COORDINATE) continue;
        for (size_t k = 0; k < 2; k++)
            force[k * rotor->lanes.degrees + c] += pressed[k] * by.closing[p] * by.unit / rotor->unit[c];
    }
}

static void torsion_drive(const void *model, size_t index, double *slope) {
    const whirl_rotor *rotor = model;
    const size_t n = rotor->lanes.degrees;
    memset(slope, 0, 2 * rotor->system.dimension * sizeof *slope);
    // Write generalized forces to the places of the displacements, real parts first, then convert them to
    // accelerations.
    for (size_t s = 0; s < rotor->station_count; s++) {
        const station_twist *own = &rotor->twists[s];
        double torque[2] = {0.0, 0.0};
        if (own->coordinate == NO_COORDINATE) continue;
        torsion_at(rotor, s, index, false, torque);
        for (size_t k = 0; k < 2; k++) slope[k * n + own->coordinate] += own->share * torque[k];
    }
    for (size_t i = 0; i < rotor->element_count; i++) torsion_add_error(rotor, &rotor->elements[i], index, slope);
    double *const acceleration = slope + 2 * n;
    for (size_t k = 0; k < 2; k++) rotor_accelerate(rotor, slope + k * n, acceleration + k * n);
    memcpy(slope, acceleration, 2 * n * sizeof *slope);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < 2; k++) acceleration[2 * i + k] = slope[k * n + i] / (rotor->clock * rotor->clock);
    memset(slope, 0, 2 * n * sizeof *slope);
}

static void torsion_turn(const void *model, double *turn) {
    const whirl_rotor *rotor = model;
    memset(turn, 0, rotor->system.dimension * sizeof *turn);
    for (size_t i = rotor->first_twist; i < rotor->first_twist + rotor->twist_count; i++)
        turn[i] = rotor->rigid[i] / rotor->unit[i];
}

// ---------------------------------------------------------------- paths

/// A motion about the equilibrium by an excitation, or the displacement by steady torques.
typedef struct torsion_motion {
    const whirl_rotor *rotor;
    size_t index;
    bool steady;
    double w; ///< frequency in the system's unit of time
    const double *rest, *v;
} torsion_motion;

/// Adds `factor` times the twist of a coordinate to `out`: its complex amplitude; or, for steady torques, the
/// displacement with that at rest.
static void torsion_twist(const torsion_motion *m, size_t coordinate, double factor, double out[2]) {
    if (coordinate == NO_COORDINATE) return;
    const double unit = factor * m->rotor->unit[coordinate];
    out[0] += unit * (m->v[2 * coordinate] + (m->steady ? m->rest[coordinate] : 0.0));
    if (!m->steady) out[1] += unit * m->v[2 * coordinate + 1];
}

/// Finds the moment with which the first place of a link drives the second, about z. inertia: includes the inertia
/// between both. Returns the power of its damping.
static double torsion_link(const torsion_motion *m, const twist_link *own, bool inertia, double out[2]) {
    const double rate = m->w * m->rotor->clock; // rad/s
    double twist[2] = {0.0, 0.0};
    torsion_twist(m, own->coordinate[0], own->share[0], twist);
    torsion_twist(m, own->coordinate[1], -own->share[1], twist);
    const double real = own->stiffness - (inertia ? own->inertance * rate * rate : 0.0), damper = own->damping * rate;
    out[0] = real * twist[0] - damper * twist[1];
    out[1] = real * twist[1] + damper * twist[0];
    return 0.5 * own->damping * rate * rate * (twist[0] * twist[0] + twist[1] * twist[1]);
}

/// Finds the force that an element carries, and its levers. Returns the power of its damping.
static double torsion_carried(const torsion_motion *m, const element *own, element_carried *by, double force[2]) {
    const whirl_rotor *rotor = m->rotor;
    const element_place at = rotor_see(rotor, own, m->rest);
    double closing[2] = {0.0, 0.0};
    own->type->carry(own, &at, by);
    for (size_t p = 0; p < MAX_PORTS; p++)
        for (size_t k = 0; k < 2 && own->port[p] != NO_COORDINATE; k++)
            closing[k] += by->closing[p] * m->v[2 * own->port[p] + k];
    const whirl_excitation error = torsion_error(rotor, own);
    if (error.order > 0.0 && m->index < rotor->excitation_count &&
        torsion_are_one(&error, &rotor->excitations[m->index]))
        for (size_t k = 0; k < 2; k++) closing[k] -= by->error[k];
    const double damper = m->w * by->damping;
    force[0] = by->stiffness * closing[0] - damper * closing[1];
    force[1] = by->stiffness * closing[1] + damper * closing[0];
    if (m->steady) {
        // The force is without the error, and with the mean stiffness.
        double pressed = 0.0;
        for (size_t p = 0; p < MAX_PORTS; p++) pressed += by->closing[p] * at.q[p];
        force[0] = by->stiffness * (pressed - copysign(fmin(by->play, fabs(pressed)), pressed) + closing[0]);
    }
    return 0.5 * m->w * m->w * by->damping * (closing[0] * closing[0] + closing[1] * closing[1]) * by->unit *
           rotor->clock;
}

const element *rotor_carrier(const whirl_rotor *rotor, size_t index) {
    for (size_t i = 0; i < rotor->element_count; i++)
        if (rotor_carries(rotor, &rotor->elements[i]) && index-- == 0) return &rotor->elements[i];
    return NULL;
}

size_t rotor_watched_count(const whirl_rotor *rotor) {
    size_t count = rotor->torque_count, carriers = 0;
    for (size_t i = 0; i < rotor->link_count; i++) count += rotor->links[i].stiffness > 0.0;
    while (rotor_carrier(rotor, carriers)) carriers++;
    return count + carriers;
}

/// Returns the factor that converts the force which an element carries to its torque along the rotation: about the axis
/// of its first place or, if that is the ground, of its second place.
static double torsion_lever(const whirl_rotor *rotor, const element *own, const element_carried *by) {
    const size_t first = own->ends[0] == GROUND ? 1 : 0;
    const station_twist *at = &rotor->twists[own->ends[first]];
    return copysign(1.0, rotor->rigid[at->coordinate] * at->share) * -by->lever[first];
}

double rotor_carried(const whirl_rotor *rotor, const element *carrier, double *numbers, const double *x) {
    element own = *carrier;
    element_carried by;
    const element_place at = rotor_see(rotor, &own, x);
    own.number = numbers + own.first_number;
    own.type->carry(&own, &at, &by);
    return torsion_lever(rotor, carrier, &by) * by.force;
}

/// Returns true if an element acts on the twist of a station in a way that is unknown here.
static bool torsion_unknown(const whirl_rotor *rotor, size_t coordinate) {
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i];
        if (own->lumped || own->type == &force_element || rotor_carries(rotor, own)) continue;
        for (size_t p = 0; p < MAX_PORTS; p++)
            if (own->port[p] == coordinate) return true;
    }
    return false;
}

/// Adds the moments about z on a station from links, meshes, springs to the ground and external torques. Those of rigid
/// gears are left out.
static void torsion_moments(const torsion_motion *m, size_t station, double sum[2]) {
    const whirl_rotor *rotor = m->rotor;
    const station_twist *at = &rotor->twists[station];
    double own[2];
    // Add external torques, and the moments of links and of springs to the ground.
    torsion_at(rotor, station, m->index, true, sum);
    for (size_t i = 0; i < rotor->link_count + rotor->hold_count; i++) {
        const twist_link *link = i < rotor->link_count ? &rotor->links[i] : &rotor->holds[i - rotor->link_count];
        torsion_link(m, link, true, own);
        for (size_t end = 0; end < 2; end++)
            for (size_t k = 0; k < 2; k++)
                if (link->coordinate[end] == at->coordinate && link->share[end] == at->share)
                    sum[k] += end == 0 ? -own[k] : own[k];
    }
    // Add the moments of meshes.
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *e = &rotor->elements[i];
        element_carried by;
        if (!rotor_carries(rotor, e)) continue;
        torsion_carried(m, e, &by, own);
        for (size_t end = 0; end < 2; end++)
            for (size_t k = 0; k < 2; k++)
                if (e->ends[end] == station) sum[k] += by.lever[end] * own[k];
    }
}

/// Finds the moment about z by which the first gear of a rigid pair acts on the second, from the balance of the second.
static void torsion_pair(const torsion_motion *m, const rigid_pair *pair, double out[2]) {
    const whirl_rotor *rotor = m->rotor;
    const station_twist *at = &rotor->twists[pair->second];
    const double rate = m->w * rotor->clock;
    double sum[2] = {0.0, 0.0}, twist[2] = {0.0, 0.0};
    torsion_moments(m, pair->second, sum);
    for (size_t i = 0; i < rotor->pair_count; i++) {
        double next[2];
        if (rotor->pairs[i].first != pair->second) continue;
        torsion_pair(m, &rotor->pairs[i], next);
        for (size_t k = 0; k < 2; k++) sum[k] -= rotor->pairs[i].ratio * next[k];
    }
    torsion_twist(m, at->coordinate, at->share, twist);
    for (size_t k = 0; k < 2; k++)
        out[k] = (m->steady ? 0.0 : -rotor->polar[pair->second] * rate * rate * twist[k]) - sum[k];
}

size_t rotor_link_station(const whirl_rotor *rotor, const twist_link *own, size_t end) {
    size_t found = rotor->station_count;
    for (size_t s = rotor->station_count; s-- > 0;)
        if (rotor->twists[s].coordinate == own->coordinate[end] && rotor->twists[s].share == own->share[end]) found = s;
    return found;
}

/// Returns the link that continues from an end of another link at a node between stations, and its far end; NULL if
/// there is none.
static const twist_link *torsion_next(const whirl_rotor *rotor, const twist_link *own, size_t end, size_t *far) {
    for (size_t i = 0; i < rotor->link_count; i++)
        for (size_t k = 0; k < 2; k++)
            if (&rotor->links[i] != own && rotor->links[i].coordinate[k] == own->coordinate[end]) {
                *far = 1 - k;
                return &rotor->links[i];
            }
    return NULL;
}

/// Returns the first station that is reached from an end of a link along the pieces of its shaft.
static size_t torsion_end(const whirl_rotor *rotor, const twist_link *own, size_t end) {
    size_t found = rotor_link_station(rotor, own, end);
    for (size_t steps = 0; own && found == rotor->station_count && steps < rotor->link_count; steps++) {
        own = torsion_next(rotor, own, end, &end);
        if (own) found = rotor_link_station(rotor, own, end);
    }
    return found;
}

rotor_path rotor_path_at(const whirl_rotor *rotor, size_t index) {
    for (size_t i = 0; i < rotor->link_count; i++)
        if (rotor->links[i].stiffness > 0.0 && index-- == 0) return (rotor_path){.link = &rotor->links[i]};
    const element *own = rotor_carrier(rotor, index);
    if (own) return (rotor_path){.element = own};
    for (size_t i = 0; i < rotor->element_count; i++) index -= rotor_carries(rotor, &rotor->elements[i]);
    return (rotor_path){.pair = &rotor->pairs[index]};
}

static void torsion_path(const void *model, size_t index, whirl_torque_path *out) {
    const whirl_rotor *rotor = model;
    const rotor_path own = rotor_path_at(rotor, index);
    *out = (whirl_torque_path){.kind = WHIRL_TORQUE_BETWEEN};
    for (size_t end = 0; end < 2; end++) {
        if (own.link) out->station[end] = torsion_end(rotor, own.link, end);
        if (own.element)
            out->station[end] = own.element->ends[end] == GROUND ? rotor->station_count : own.element->ends[end];
    }
    if (own.link) out->modulus = own.link->modulus;
    if (own.element) out->kind = own.element->type->carries_as;
    if (!own.pair) return;
    out->kind = WHIRL_TORQUE_RIGID_GEAR;
    out->station[0] = own.pair->first;
    out->station[1] = own.pair->second;
}

/// Returns the S-N curve of a path, or NULL if it has none.
static const twist_fatigue *torsion_fatigue(const whirl_rotor *rotor, const whirl_torque_path *path) {
    for (size_t i = 0; i < rotor->fatigue_count; i++) {
        const size_t *station = rotor->fatigues[i].station;
        if ((station[0] == path->station[0] && station[1] == path->station[1]) ||
            (station[0] == path->station[1] && station[1] == path->station[0]))
            return &rotor->fatigues[i];
    }
    return NULL;
}

/// Returns the section modulus for which a curve of stresses holds, m3; 0 if it is unknown.
static double torsion_section(const twist_fatigue *own, const whirl_torque_path *path) {
    return own->modulus > 0.0 ? own->modulus : path->modulus;
}

static bool torsion_curve(const void *model, size_t path, whirl_torque_curve *out) {
    const whirl_rotor *rotor = model;
    whirl_torque_path at;
    torsion_path(model, path, &at);
    const twist_fatigue *own = torsion_fatigue(rotor, &at);
    if (!own) return false;
    const double factor = own->by_stress ? torsion_section(own, &at) / own->concentration : 1.0;
    *out = (whirl_torque_curve){.count = own->count, .slope = own->slope, .endurance = factor * own->endurance};
    for (size_t i = 0; i < own->count; i++) {
        out->ranges[i] = factor * own->ranges[i];
        out->lives[i] = own->lives[i];
    }
    return true;
}

whirl_status rotor_check_fatigue(const whirl_rotor *rotor) {
    // An element that is checked alone has nothing that joins its stations.
    for (size_t i = 0; i < rotor->fatigue_count && rotor->torsion.path_count > 0; i++) {
        const twist_fatigue *own = &rotor->fatigues[i];
        const char *name[2] = {rotor->probes[own->station[0]].name, rotor->probes[own->station[1]].name};
        bool found = false;
        for (size_t k = 0; k < rotor->torsion.path_count && !found; k++) {
            whirl_torque_path path;
            torsion_path(rotor, k, &path);
            if (torsion_fatigue(rotor, &path) != own) continue;
            found = true;
            if (own->by_stress && !(torsion_section(own, &path) > 0.0))
                return whirl_fail(WHIRL_BAD_INPUT,
                                  "the diameter of the shaft from '%s' to '%s' is not known, and fatigue has "
                                  "stress_ranges, expected the diameter of one of them",
                                  name[0], name[1]);
        }
        if (!found)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "fatigue is between '%s' and '%s', and no single shaft, coupling or gear joins their "
                              "twists, expected two stations that one of these joins, and one curve for them",
                              name[0], name[1]);
    }
    return whirl_ok();
}

static void torsion_carry(const void *model, size_t path, size_t index, const double *rest, const double *v,
                          double torque[2], double *power) {
    const whirl_rotor *rotor = model;
    const rotor_path own = rotor_path_at(rotor, path);
    const bool steady = index == rotor->excitation_count;
    const torsion_motion m = {rotor, index, steady, steady ? 0.0 : rotor->excitations[index].frequency / rotor->clock,
                              rest,  v};
    double sense = 1.0;
    *power = 0.0;
    // Distinguish a link, a mesh, and a pair of rigid gears.
    if (own.link) {
        sense = rotor->rigid[own.link->coordinate[0]] * own.link->share[0];
        *power = torsion_link(&m, own.link, false, torque);
    } else if (own.element) {
        element_carried by;
        *power = torsion_carried(&m, own.element, &by, torque);
        for (size_t k = 0; k < 2; k++) torque[k] *= torsion_lever(rotor, own.element, &by);
    } else {
        const station_twist *at = &rotor->twists[own.pair->first];
        torsion_pair(&m, own.pair, torque);
        sense = rotor->rigid[at->coordinate] * at->share;
        for (size_t k = 0; k < 2; k++) torque[k] *= own.pair->ratio;
        if (torsion_unknown(rotor, at->coordinate)) torque[0] = torque[1] = NAN;
    }
    // Make the torque positive if the first station drives the second along the rotation.
    for (size_t k = 0; k < 2; k++) torque[k] = copysign(1.0, sense) * torque[k];
}

static const char *torsion_open(const void *model, const double *rest) {
    const whirl_rotor *rotor = model;
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i];
        if (!rotor_carries(rotor, own)) continue;
        const element_place at = rotor_see(rotor, own, rest);
        element_carried by;
        own->type->carry(own, &at, &by);
        if (by.open) return rotor->probes[own->station].name;
    }
    return NULL;
}

// ---------------------------------------------------------------- the machine

void rotor_find_torsion(whirl_rotor *rotor, const assembly *from) {
    size_t paths = 0;
    // Find the rigid pairs of gears.
    for (size_t s = 0; s < rotor->station_count; s++) {
        rotor->polar[s] = from->stations[s].polar + from->stations[s].shaft_polar;
        if (from->stations[s].geared_to != NO_STATION)
            rotor->pairs[rotor->pair_count++] = (rigid_pair){from->stations[s].geared_to, s, from->stations[s].gear};
    }
    // Find the excitations by torques and by errors of meshes.
    for (size_t i = 0; i < rotor->harmonic_count; i++)
        if (rotor->harmonics[i].of != HARMONIC_STEADY)
            torsion_add_excitation(rotor, torsion_rate(rotor, &rotor->harmonics[i]));
    // Count the parts that carry torque.
    for (size_t i = 0; i < rotor->element_count; i++) {
        const whirl_excitation error = torsion_error(rotor, &rotor->elements[i]);
        if (error.order > 0.0) torsion_add_excitation(rotor, error);
        paths += rotor_carries(rotor, &rotor->elements[i]);
    }
    for (size_t i = 0; i < rotor->link_count; i++) paths += rotor->links[i].stiffness > 0.0;
    rotor->torsion = (whirl_torsion){.excitation_count = rotor->excitation_count,
                                     .path_count = paths + rotor->pair_count,
                                     .excitation = torsion_excitation,
                                     .check = torsion_check,
                                     .drive = torsion_drive,
                                     .unbalanced = torsion_unbalanced,
                                     .turn = torsion_turn,
                                     .path = torsion_path,
                                     .curve = torsion_curve,
                                     .carry = torsion_carry,
                                     .open = torsion_open,
                                     .twists = torsion_twists,
                                     .speed = torsion_speed};
}
