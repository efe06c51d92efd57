// Bent shafts. A bent shaft turns with its bow u: M q'' + ... + K (q - u exp(i tau)) = ..., so that K u acts as a
// rotating force (Nicholas, Gunter, Allaire 1976). The bow is given at stations. Between them the shaft has the shape
// of one that is held at these stations only, so that all forces act there.
#include "bow.h"
#include "held.h"
#include "mesh.h"

#include <math.h>
#include <stdlib.h>

static const key_value *bow_value_of(const whirl_design *design, size_t station, int key) {
    return &design->stations[station].values[key];
}

static bool is_bent(const whirl_design *design, size_t station) {
    return station < design->station_count && bow_value_of(design, station, STATION_BOW)->given;
}

/// Adds the rotating forces at the stations of a shaft that bend it to its bow.
static whirl_status add_forces(const held_shaft *of, const mesh *from, const whirl_design *design, assembly *to) {
    double *influence = calloc(of->supports * of->supports + 1, sizeof *influence);
    if (!influence) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the bow of a shaft");
    const whirl_status status = held_influence(of, influence);
    for (size_t i = 0; i < of->supports && status.code == WHIRL_OK; i++) {
        const size_t *at = to->stations[from->nodes[of->first + of->support[i]].station].coordinate;
        double x = 0.0, y = 0.0;
        for (size_t k = 0; k < of->supports; k++) {
            const size_t station = from->nodes[of->first + of->support[k]].station;
            const double bow = bow_value_of(design, station, STATION_BOW)->number;
            const double angle = bow_value_of(design, station, STATION_BOW_ANGLE)->number;
            x += influence[i * of->supports + k] * bow * cos(angle);
            y += influence[i * of->supports + k] * bow * sin(angle);
        }
        assembly_turning(to, at[AXIS_X], at[AXIS_Y], hypot(x, y), atan2(y, x));
    }
    free(influence);
    return status;
}

static whirl_status bow_check(const held_shaft *of, const mesh *from, const whirl_design *design) {
    const char *name = design->shafts[of->shaft].name;
    const shaft_settings *shaft = &from->shafts[of->shaft];
    bool flats = false;
    for (size_t p = 0; p < from->piece_count; p++)
        flats = flats || (from->pieces[p].shaft == of->shaft && from->pieces[p].piece.flats != 0.0);
    if (of->supports < 3)
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "shaft '%s' has a bow at %zu station%s, expected it at three at least, 0 m where it is straight", name,
            of->supports, of->supports == 1 ? "" : "s");
    if (shaft->ratio == 1.0 && !shaft->spool && !flats && shaft->hysteretic == 0.0) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "shaft '%s' has a bow, expected one that turns with the rotor, without %s", name,
                      flats                 ? "flats"
                      : shaft->spool        ? "a speed of its own"
                      : shaft->ratio != 1.0 ? "a ratio of its own"
                                            : "hysteretic damping");
}

whirl_status bow_build(const mesh *from, const whirl_design *design, assembly *to) {
    whirl_status status = whirl_ok();
    for (size_t s = 0; s < design->station_count; s++)
        if (is_bent(design, s) && to->stations[s].shaft == NO_SHAFT)
            return whirl_fail(WHIRL_BAD_INPUT, "station '%s' has a bow and lies on no shaft of finite elements",
                              design->stations[s].name);
    size_t *support = calloc(from->node_count + 1, sizeof *support);
    if (!support) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the bow of a shaft");
    for (size_t shaft = 0; shaft < from->shaft_count && status.code == WHIRL_OK; shaft++) {
        if (!from->shafts[shaft].meshed) continue;
        held_shaft of = held_find(from, shaft);
        of.support = support;
        for (size_t n = 0; n < of.nodes; n++)
            if (is_bent(design, from->nodes[of.first + n].station)) support[of.supports++] = n;
        if (of.supports == 0) continue;
        status = bow_check(&of, from, design);
        // Unbalances that replace all rotating forces replace bows, too.
        if (status.code == WHIRL_OK && !to->balanced) status = add_forces(&of, from, design, to);
    }
    free(support);
    return status;
}
