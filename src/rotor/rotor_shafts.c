// Shafts whose torques a run shows one by one. Where stations twist these are the parts between gears; otherwise they
// are the shafts of the design that turn at another speed than the rotor.
#include <math.h>
#include <string.h>

#include "machine.h"

/// Returns the first of the stations that are joined to this one. Stations on the way point to it afterwards.
static size_t shafts_root(size_t *of, size_t station) {
    while (of[station] != station) station = of[station] = of[of[station]];
    return station;
}

static void shafts_join(size_t *of, size_t one, size_t other) {
    const size_t a = shafts_root(of, one), b = shafts_root(of, other);
    of[a > b ? a : b] = a > b ? b : a;
}

static bool shafts_twists_as(const assembly *from, size_t station, size_t coordinate, double share) {
    return from->stations[station].coordinate[AXIS_TWIST] == coordinate &&
           assembly_share(from, station, AXIS_TWIST) == share;
}

/// Joins all stations and nodes with the twists of two places.
static void shafts_join_twists(size_t *of, const assembly *from, const size_t coordinate[2], const double share[2]) {
    size_t first = NO_STATION;
    for (size_t s = 0; s < from->station_count; s++)
        for (size_t end = 0; end < 2; end++) {
            if (!shafts_twists_as(from, s, coordinate[end], share[end])) continue;
            if (first == NO_STATION) first = s;
            shafts_join(of, first, s);
        }
}

/// Joins what an element holds together, unless it is a mesh.
static void shafts_join_element(size_t *of, const whirl_rotor *rotor, const assembly *from, const element *own) {
    size_t coordinate[2], count = 0;
    double share[2];
    if (own->type->carry && own->type->carries_as == WHIRL_TORQUE_MESH) return;
    for (size_t p = 0; p < MAX_PORTS && count < 2; p++) {
        if (own->port[p] == NO_COORDINATE || own->port[p] - rotor->first_twist >= rotor->twist_count) continue;
        coordinate[count] = own->port[p];
        share[count++] = own->share[p];
    }
    if (count == 2) shafts_join_twists(of, from, coordinate, share);
}

/// Adds a shaft with its first station, or returns the one with this key.
static size_t shafts_add(whirl_rotor *rotor, size_t *keys, size_t key, const rotor_shaft *own) {
    for (size_t k = 0; k < rotor->shaft_count; k++)
        if (keys[k] == key) return k;
    if (rotor->shaft_count == WHIRL_MAX_RUN_SHAFTS) return WHIRL_MAX_RUN_SHAFTS;
    keys[rotor->shaft_count] = key;
    rotor->shafts[rotor->shaft_count] = *own;
    return rotor->shaft_count++;
}

/// Finds the shafts of a machine whose stations twist. Returns false if they are too many.
static bool shafts_find_twisting(whirl_rotor *rotor, const assembly *from) {
    size_t of[WHIRL_MAX_STATIONS], keys[WHIRL_MAX_RUN_SHAFTS] = {0};
    if (rotor->aside != NO_STATION || rotor->driver == rotor->station_count) return true;
    for (size_t s = 0; s < from->station_count; s++) of[s] = s;
    for (size_t i = 0; i < rotor->link_count; i++)
        shafts_join_twists(of, from, rotor->links[i].coordinate, rotor->links[i].share);
    for (size_t i = 0; i < rotor->element_count; i++) shafts_join_element(of, rotor, from, &rotor->elements[i]);
    // The shaft of the motor comes first. A station that does not twist counts as part of it.
    for (size_t i = 0; i <= from->station_count; i++) {
        const size_t s = i == 0 ? rotor->driver : i - 1;
        const assembly_station *at = &from->stations[s];
        const size_t own = at->coordinate[AXIS_TWIST];
        size_t shaft = 0;
        if (own != NO_COORDINATE) {
            const rotor_shaft made = {.station = s, .turns = rotor->rigid[own] * assembly_share(from, s, AXIS_TWIST)};
            shaft = shafts_add(rotor, keys, shafts_root(of, s), &made);
            if (shaft == WHIRL_MAX_RUN_SHAFTS) return false;
        }
        if (i == 0) continue;
        if (s < rotor->station_count) rotor->shaft_of[s] = shaft;
        if (own == NO_COORDINATE) continue;
        const double polar = at->polar + at->shaft_polar;
        rotor->shafts[shaft].polar += polar;
        rotor->parts[rotor->part_count++] = (rotor_part){shaft, {own, assembly_share(from, s, AXIS_TWIST)}, polar};
    }
    return true;
}

/// Finds the shafts of other speeds in a machine whose stations do not twist. Returns false if they are too many.
static bool shafts_find_rigid(whirl_rotor *rotor, const assembly *from) {
    enum { OWN = 0, SPOOLS = 1, GEARED = 1 + WHIRL_MAX_SPOOLS };
    size_t keys[WHIRL_MAX_RUN_SHAFTS] = {0};
    rotor_shaft made = {.turns = 1.0};
    shafts_add(rotor, keys, OWN, &made);
    for (size_t k = 0; k < rotor->spool_count; k++) {
        made.spool = k + 1;
        shafts_add(rotor, keys, SPOOLS + k, &made);
    }
    for (size_t s = 0; s < from->station_count; s++) {
        const assembly_station *at = &from->stations[s];
        const bool geared = at->spool == 0 && at->carrier > 0 && at->ratio != 1.0 && at->ratio != 0.0;
        made = (rotor_shaft){.station = s, .spool = at->spool, .turns = geared ? at->ratio : 1.0};
        const size_t key = at->spool > 0 ? SPOOLS + at->spool - 1 : geared ? GEARED + at->carrier : OWN;
        const size_t shaft = shafts_add(rotor, keys, key, &made);
        if (shaft == WHIRL_MAX_RUN_SHAFTS) return false;
        if (s < rotor->station_count) rotor->shaft_of[s] = shaft;
        rotor->shafts[shaft].polar += at->polar + at->turned_polar;
    }
    for (size_t s = rotor->station_count; s-- > 0;) rotor->shafts[rotor->shaft_of[s]].station = s;
    return true;
}

void rotor_find_shafts(whirl_rotor *rotor, const assembly *from) {
    const bool found = rotor->twist_count > 0 ? shafts_find_twisting(rotor, from) : shafts_find_rigid(rotor, from);
    if (found && rotor->shaft_count > 1) return;
    rotor->shaft_count = rotor->part_count = 0;
    memset(rotor->shaft_of, 0, rotor->station_count * sizeof *rotor->shaft_of);
}
