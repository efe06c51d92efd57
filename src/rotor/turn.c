// The rigid turn of a rotor whose stations twist: how far each station turns while the shaft turns, by its gears; and
// the angular momentum of this turn.
#include <math.h>

#include "machine.h"

static bool turn_twists(const whirl_rotor *rotor, size_t coordinate) {
    return coordinate != NO_COORDINATE && coordinate - rotor->first_twist < rotor->twist_count;
}

/// Passes a turn on from one of two joined coordinates to the other: both places turn by the same angle. Returns true
/// if it did so.
static bool turn_pass(whirl_rotor *rotor, const size_t coordinate[2], const double share[2]) {
    for (size_t i = 0; i < 2; i++) {
        const size_t from = coordinate[i], to = coordinate[1 - i];
        if (rotor->rigid[from] == 0.0 || rotor->rigid[to] != 0.0 || share[1 - i] == 0.0) continue;
        rotor->rigid[to] = rotor->rigid[from] * share[i] / share[1 - i];
        return true;
    }
    return false;
}

/// Passes a turn on through an element, between its first two ports that twist.
static bool turn_pass_element(whirl_rotor *rotor, const element *own) {
    size_t coordinate[2], count = 0;
    double share[2];
    for (size_t p = 0; p < MAX_PORTS && count < 2; p++) {
        if (!turn_twists(rotor, own->port[p])) continue;
        coordinate[count] = own->port[p];
        share[count++] = own->share[p];
    }
    return count == 2 && turn_pass(rotor, coordinate, share);
}

/// Returns the station whose turn is that of the shaft: of the first motor, of the drive, of the first torque, or the
/// first station that twists.
static size_t turn_begins_at(const whirl_rotor *rotor) {
    const size_t motor = rotor->drive.given ? rotor->drive.at : NO_STATION;
    size_t first = NO_STATION;
    for (size_t i = 0; i < rotor->torque_count && first == NO_STATION; i++)
        if (rotor->torques[i].law->motor) first = rotor->torques[i].station;
    if (first == NO_STATION) first = motor;
    for (size_t i = 0; i < rotor->torque_count && first == NO_STATION; i++) first = rotor->torques[i].station;
    for (size_t s = 0; s < rotor->station_count && first == NO_STATION; s++)
        if (rotor->twists[s].coordinate != NO_COORDINATE) first = s;
    return first;
}

void rotor_find_turn(whirl_rotor *rotor, const assembly *from) {
    rotor->aside = NO_STATION;
    rotor->grounded = from->grounded;
    rotor->driver = rotor->station_count;
    if (rotor->twist_count == 0) return;
    const size_t first = turn_begins_at(rotor), root = from->stations[first].coordinate[AXIS_TWIST];
    if (root == NO_COORDINATE) {
        rotor->aside = first;
        return;
    }
    rotor->driver = first;
    // Begin at the first station, and pass the turn on along all joints of twists until no further station turns.
    rotor->rigid[root] =
        copysign(1.0, from->turn) * from->stations[first].ratio / assembly_share(from, first, AXIS_TWIST);
    for (bool passed = true; passed;) {
        passed = false;
        for (size_t i = 0; i < rotor->link_count; i++)
            passed = turn_pass(rotor, rotor->links[i].coordinate, rotor->links[i].share) || passed;
        for (size_t i = 0; i < rotor->element_count; i++)
            passed = turn_pass_element(rotor, &rotor->elements[i]) || passed;
    }
    for (size_t s = 0; s < rotor->station_count && rotor->aside == NO_STATION; s++) {
        const size_t own = rotor->twists[s].coordinate;
        if (own != NO_COORDINATE && rotor->rigid[own] == 0.0) rotor->aside = s;
    }
    // Compute the angular momentum: the mass matrix times the turn.
    for (size_t d = 0; d < rotor->twist_count; d++) {
        const size_t own = rotor->first_twist + d;
        rotor->momentum[own] = rotor->inertia[own] * rotor->rigid[own];
    }
    for (size_t i = 0; i < from->mass_count; i++) {
        const mass_term *term = &from->masses[i];
        if (!turn_twists(rotor, term->row) || !turn_twists(rotor, term->by)) continue;
        rotor->momentum[term->row] += term->mass * rotor->rigid[term->by];
        if (term->row != term->by) rotor->momentum[term->by] += term->mass * rotor->rigid[term->row];
    }
}

void rotor_accelerate(const whirl_rotor *rotor, const double *force, double *out) {
    const coupling *by = &rotor->coupled;
    const size_t degrees = rotor->lanes.degrees;
    for (size_t d = 0; d < degrees; d++) out[d] = force[d] / (rotor->inertia[d] * rotor->unit[d]);
    if (by->count == 0) return;
    for (size_t i = 0; i < degrees; i++) {
        double sum = 0.0;
        if (by->place[i] == NO_COORDINATE) continue;
        for (size_t j = 0; j < by->count; j++)
            sum += by->share[by->place[i] * by->count + j] * force[by->row[j]] /
                   (rotor->inertia[by->row[j]] * rotor->unit[by->row[j]]);
        out[i] = sum;
    }
}

double rotor_turns(const whirl_rotor *rotor, size_t station) {
    if (rotor->twist_count == 0 || station == NO_STATION) return 1.0;
    const station_twist *own = &rotor->twists[station];
    return own->coordinate == NO_COORDINATE ? 1.0 : fabs(rotor->rigid[own->coordinate] * own->share);
}
