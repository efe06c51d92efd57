// Torques on each shaft of a machine with several, while its speed changes.
//
// The inertia of a shaft times its acceleration is the sum of the torques on it. Of shafts that gears join, the torques
// of these follow from the balance of each shaft: they are what is left.
#include <math.h>
#include <string.h>

#include "running_rotor.h"

/// Turns the accelerations by the angle a [degrees] into those by time over the square of the unit of speed, in units
/// of the coordinates, with all that theta'' adds.
static void shafts_accelerate(const running_rotor *r, const running_state *s, const faster *by, double *a) {
    const whirl_rotor *rotor = r->rotor;
    for (size_t d = 0; d < rotor->lanes.degrees; d++) {
        a[d] = s->w * s->w * a[d] + by->all * r->lever_acceleration[d];
        for (size_t k = 0; k < r->spool_count; k++) a[d] += by->spools[k] * r->spools[k].lever_acceleration[d];
    }
    for (size_t d = rotor->first_twist; d < rotor->first_twist + rotor->twist_count; d++)
        a[d] += (by->all - by->twisted) * rotor->rigid[d] / rotor->unit[d];
}

/// Returns the torque of unbalances on their shaft: levers u [degrees] and guided [2] of its theta'', which is `rate`
/// over the square of the unit; `inertia`: what they add to the inertia about its axis.
static double shafts_react(const running_rotor *r, const double *a, const double *u, const double guided[2],
                           double inertia, double rate) {
    const double square = r->unit * r->unit;
    double torque = -square * inertia * rate;
    for (size_t way = 0; way < 2; way++) torque -= guided[way] * running_pull(r, way);
    for (size_t d = 0; d < r->rotor->lanes.degrees; d++)
        if (u[d] != 0.0) torque += u[d] * (square * r->rotor->unit[d] * a[d] - running_pull(r, r->along[d]));
    return torque;
}

/// Returns the torque of the unbalances that turn with shaft `shaft`, whose speed is a ratio of the rotor's, and, with
/// ratios of their own, on the rotor's shaft. Overwrites the levers of such unbalances.
static double shafts_react_geared(const running_rotor *r, const running_state *s, const double *a, size_t shaft,
                                  double rate) {
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees;
    const double by = 1.0 / fabs(rotor->shafts[shaft].turns);
    double guided[2] = {0.0, 0.0}, inertia = 0.0;
    memset(r->geared_force, 0, n * sizeof *r->geared_force);
    for (size_t i = 0; i < rotor->element_count && r->geared_count > 0; i++) {
        const element *own = &rotor->elements[i];
        double lever[2] = {0.0, 0.0};
        if (rotor->shaft_of[own->station] != shaft) continue;
        const double moment = by * running_geared_lever(r, i, s->w, s->x + n + own->state, lever);
        if (moment == 0.0) continue;
        for (size_t p = 0; p < 2; p++)
            if (own->port[p] != NO_COORDINATE)
                r->geared_force[own->port[p]] += by * own->share[p] * lever[p];
            else
                guided[p] += by * lever[p];
        const size_t at = own->port[0] != NO_COORDINATE ? own->port[0] : own->port[1];
        if (at != NO_COORDINATE) inertia += moment * moment / rotor->inertia[at];
    }
    return shafts_react(r, a, r->geared_force, guided, inertia, rate);
}

/// Fills in what gears leave, as the rest of the balance.
static void shafts_add_rest(whirl_shaft_torques *to) {
    to->gears = to->inertia - (to->motor + to->load + to->friction + to->rotor + to->drag);
}

static const whirl_shaft_torques shafts_unknown = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};

/// Completes the torques of shafts that do not twist. The first one is the rotor's own.
static void shafts_complete_rigid(const running_rotor *r, const running_state *s, const double *forcing,
                                  const double *a, const faster *by, const whirl_torques *spools,
                                  whirl_shaft_torques *out) {
    const whirl_rotor *rotor = r->rotor;
    const double square = r->unit * r->unit;
    double left = r->turn_inertia;
    size_t geared = 0;
    for (size_t k = 0; k < rotor->shaft_count; k++) {
        const rotor_shaft *own = &rotor->shafts[k];
        const double ratio = fabs(own->turns);
        whirl_shaft_torques *to = &out[k];
        if (own->spool > 0) { // a shaft with a speed of its own
            const size_t index = own->spool - 1;
            const running_spool *spool = &r->spools[index];
            *to = (whirl_shaft_torques){.motor = spools[index].motor,
                                        .load = spools[index].load,
                                        .friction = spools[index].friction,
                                        .drag = spools[index].drag};
            to->rotor = shafts_react(r, a, spool->lever_force, spool->guided_lever, spool->unbalance_inertia,
                                     by->spools[index]);
            to->inertia = square * spool->inertia * by->spools[index];
            if (r->how.spools[index].law != WHIRL_SPOOL_DRIVEN) *to = shafts_unknown;
            to->speed = r->unit * s->x[r->at_spool + 2 * index + 1];
            continue;
        }
        *to = r->how.driven ? r->ledger[k] : shafts_unknown;
        to->speed = ratio * r->unit * s->exact;
        if (k == 0) continue;
        to->rotor = shafts_react_geared(r, s, a, k, ratio * by->all);
        to->inertia = own->polar > 0.0 ? square * own->polar * ratio * by->all : (double)NAN;
        left -= ratio * ratio * (own->polar > 0.0 ? own->polar : (double)NAN);
        geared++;
        shafts_add_rest(to);
    }
    // The rotor's own shaft: gears have torque only where other shafts follow it.
    const double by_ratios = shafts_react_geared(r, s, a, 0, by->all);
    running_find_levers(r, forcing);
    out[0].rotor = by_ratios + shafts_react(r, a, r->lever_force, r->guided_lever,
                                            r->how.lost ? r->lost_inertia : r->own_inertia, by->all);
    out[0].inertia = square * left * by->all;
    out[0].gears = 0.0;
    if (geared > 0 || !r->how.driven) shafts_add_rest(&out[0]);
}

/// Completes the torques of shafts between gears in a machine whose stations twist.
static void shafts_complete_twisting(const running_rotor *r, const running_state *s, const double *a, const faster *by,
                                     whirl_shaft_torques *out) {
    const whirl_rotor *rotor = r->rotor;
    const double square = r->unit * r->unit;
    const size_t n = rotor->lanes.degrees;
    // Torques on the machine as a whole act on its mean turn.
    const whirl_shaft_torques *whole = &r->ledger[rotor->shaft_count];
    const double all = square * r->turn_inertia * (by->all - by->twisted);
    for (size_t k = 0; k < rotor->shaft_count; k++) {
        const rotor_shaft *own = &rotor->shafts[k];
        const double share = own->polar * fabs(own->turns) / r->turn_inertia;
        out[k] = r->ledger[k];
        out[k].friction += share * whole->friction;
        out[k].drag += share * whole->drag;
        out[k].rotor = share * (all - whole->friction - whole->drag);
    }
    // Sum up the parts of each shaft.
    for (size_t i = 0; i < rotor->part_count; i++) {
        const rotor_part *part = &rotor->parts[i];
        const size_t d = part->twist.coordinate;
        const double way =
            copysign(part->polar * part->twist.share, part->twist.share * rotor->shafts[part->shaft].turns);
        const double turn = rotor->rigid[d] * s->exact + rotor->unit[d] * s->x[n + d] * s->w;
        out[part->shaft].inertia += square * way * rotor->unit[d] * a[d];
        out[part->shaft].speed += r->unit * way * turn;
    }
    for (size_t k = 0; k < rotor->shaft_count; k++) {
        const rotor_shaft *own = &rotor->shafts[k];
        out[k].speed = own->polar > 0.0 ? out[k].speed / own->polar : r->unit * fabs(own->turns) * s->exact;
        shafts_add_rest(&out[k]);
    }
}

void running_complete_shafts(const running_rotor *r, const running_state *s, const double *forcing, double *a,
                             const faster *by, const whirl_torques *spools, whirl_shaft_torques *out) {
    if (r->rotor->shaft_count == 0) return;
    shafts_accelerate(r, s, by, a);
    if (r->rotor->twist_count > 0)
        shafts_complete_twisting(r, s, a, by, out);
    else
        shafts_complete_rigid(r, s, forcing, a, by, spools, out);
}
