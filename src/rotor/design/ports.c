// Ports of elements: the coordinates of their stations.
#include "element.h"

/// Finds the coordinates `port` [count] of a place along axes [count], and the ratios `share` of its motion to them.
/// The ground and the axis AXES have no coordinate; a station that does not move along x or y counts as ground there.
static whirl_status find_place(const assembly *to, size_t station, const axis *axes, size_t count, size_t *port,
                               double *share) {
    for (size_t a = 0; a < count; a++) {
        port[a] = NO_COORDINATE;
        if (station == GROUND || axes[a] == AXES) continue;
        const whirl_status status = assembly_find(to, station, axes[a], &port[a]);
        const bool held = axes[a] == AXIS_X || axes[a] == AXIS_Y;
        if (status.code != WHIRL_OK && !held) return status;
        share[a] = status.code == WHIRL_OK ? assembly_share(to, station, axes[a]) : 1.0;
    }
    return whirl_ok();
}

/// Rejects ports [2 count] of which none moves: the element would have no effect.
static whirl_status check_moving(const assembly *to, size_t station, const axis *axes, size_t count,
                                 const size_t *port) {
    size_t none = NO_COORDINATE;
    for (size_t p = 0; p < 2 * count; p++)
        if (port[p] != NO_COORDINATE) return whirl_ok();
    for (size_t a = 0; a < count; a++)
        if (axes[a] != AXES) return assembly_find(to, station, axes[a], &none);
    return whirl_ok();
}

void element_on(const key_value *at, const assembly *to, axis first, element *out) {
    const size_t *coordinate = to->stations[at->station[0]].coordinate;
    out->station = at->station[0];
    out->port[0] = coordinate[first];
    out->port[1] = coordinate[first + 1];
}

whirl_status element_between(const key_value *between, const assembly *to, const axis *axes, size_t count,
                             element *out) {
    const size_t one = between->station[0], other = between->station[1];
    if (one == other) return whirl_fail(WHIRL_BAD_INPUT, "between names one station twice, expected two");
    out->station = one == GROUND ? other : one;
    out->ends[0] = one;
    out->ends[1] = other;
    whirl_status status = find_place(to, one, axes, count, out->port, out->share);
    if (status.code == WHIRL_OK) status = find_place(to, other, axes, count, out->port + count, out->share + count);
    return status.code == WHIRL_OK ? check_moving(to, out->station, axes, count, out->port) : status;
}

whirl_status element_beside_none(const key_value *between, const assembly *to) {
    const size_t one = between->station[0], other = between->station[1];
    if (one == GROUND || other == GROUND || to->stations[one].shaft == NO_SHAFT ||
        to->stations[one].shaft != to->stations[other].shaft)
        return whirl_ok();
    return whirl_fail(
        WHIRL_BAD_INPUT,
        "would lie parallel to the segments that join '%s' and '%s' and add its stiffness to theirs, expected "
        "stations that no shaft of finite elements joins (segments have flats and diameters of their own)",
        to->stations[one].name, to->stations[other].name);
}

whirl_status element_in_housing(const key_value *at, const key_value *from, const assembly *to, element *out) {
    static const axis plane[] = {AXIS_X, AXIS_Y};
    const size_t housing = from->given ? from->station[0] : GROUND;
    out->station = at->station[0];
    if (housing == out->station)
        return whirl_fail(WHIRL_BAD_INPUT, "is between a station and itself, expected another station");
    const whirl_status status = find_place(to, out->station, plane, 2, out->port, out->share);
    return status.code == WHIRL_OK ? find_place(to, housing, plane, 2, out->port + 2, out->share + 2) : status;
}
