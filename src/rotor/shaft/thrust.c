// Axial force in shafts of finite elements by the weight of a vertical machine.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "building.h"
#include "held.h"
#include "mesh.h"
#include "registry.h"

whirl_weight whirl_design_weight(const whirl_design *design) {
    whirl_weight out = {.up = 1.0};
    double x = 0.0, y = 0.0;
    for (size_t i = 0; i < design->element_count; i++) {
        const design_element *own = &design->elements[i];
        if (own->type != &gravity_element) continue;
        const double size = own->values[GRAVITY_ACCELERATION].number;
        const double direction = own->values[GRAVITY_DIRECTION].number;
        out.given = true;
        if (own->values[GRAVITY_AXIS].choice == GRAVITY_VERTICAL) {
            out.along = fmax(out.along, size);
            out.stands = true;
            continue;
        }
        x += size * cos(direction);
        y += size * sin(direction);
    }
    out.across = hypot(x, y);
    if (out.across > 0.0) out.up = -y / out.across;
    return out;
}

/// Finds the node at which the shaft is held along its axis.
static whirl_status thrust_find(const whirl_design *design, const mesh *in, const key_value *values, size_t *node) {
    const size_t station = values[GRAVITY_HELD_AT].station[0];
    for (*node = 0; *node < in->node_count; ++*node)
        if (in->nodes[*node].station == station) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT,
                      "is held_at '%s', which lies on no shaft of finite elements, expected one of its "
                      "stations",
                      design->stations[station].name);
}

/// Returns the mass of a piece. The mass per metre is a quadratic polynomial, so that Simpson's rule is exact.
static double piece_mass(const shaft_piece *own) {
    return own->length / 6.0 *
           (piece_line_mass(own, 0.0) + 4.0 * piece_line_mass(own, 0.5) + piece_line_mass(own, 1.0));
}

/// Returns the mass of all pieces between two neighbouring nodes. *layers becomes their number.
static double stretch_mass(const mesh *in, size_t left, size_t *layers) {
    double mass = 0.0;
    *layers = 0;
    for (size_t p = 0; p < in->piece_count; p++) {
        if (in->pieces[p].node[0] != left) continue;
        mass += piece_mass(&in->pieces[p].piece);
        ++*layers;
    }
    return mass;
}

/// Adds an axial force at the left and the right end of all pieces between two neighbouring nodes, in equal shares.
static void stretch_pull(mesh *in, size_t left, size_t layers, const double force[2]) {
    for (size_t p = 0; p < in->piece_count; p++)
        for (size_t end = 0; end < 2 && in->pieces[p].node[0] == left; end++)
            in->pieces[p].piece.axial[end] += force[end] / (double)layers;
}

/// Adds the axial forces by the weight from one end of the shaft up to the node of its axial support: at every place
/// the weight beyond it pulls or presses. step: 1 from the start of the shaft, -1 from its end. Returns the mass that
/// this side puts on that node, kg.
static double thrust_weigh(mesh *in, const assembly *from, size_t first, size_t held, int step, double force_by_mass) {
    double mass = 0.0;
    for (size_t node = first; node != held; node = step > 0 ? node + 1 : node - 1) {
        const size_t left = step > 0 ? node : node - 1;
        size_t layers;
        mass += from->stations[in->nodes[node].station].mass;
        const double own = stretch_mass(in, left, &layers);
        const double near = force_by_mass * mass, far = force_by_mass * (mass + own);
        stretch_pull(in, left, layers, step > 0 ? (double[]){near, far} : (double[]){far, near});
        mass += own;
    }
    return mass;
}

static whirl_status thrust_add(building *b, const key_value *values) {
    mesh *in = &b->mesh;
    size_t node;
    const whirl_status status = thrust_find(b->design, in, values, &node);
    if (status.code != WHIRL_OK) return status;
    const held_shaft shaft = held_find(in, in->nodes[node].shaft);
    shaft_thrust *out = &b->thrust[shaft.shaft];
    if (out->held)
        return whirl_fail(WHIRL_BAD_INPUT, "holds shaft '%s' a second time, expected one gravity along each shaft",
                          b->design->shafts[shaft.shaft].name);
    const double g = values[GRAVITY_ACCELERATION].number, down = values[GRAVITY_TOP].choice == 0 ? 1.0 : -1.0;
    const size_t last = shaft.first + shaft.nodes - 1;
    // If the start is at the top, the part before the support stands on it, and the part after it hangs from it.
    out->mass = thrust_weigh(in, &b->assembly, shaft.first, node, 1, -down * g) +
                thrust_weigh(in, &b->assembly, last, node, -1, down * g) +
                b->assembly.stations[in->nodes[node].station].mass;
    out->held = true;
    out->station = in->nodes[node].station;
    out->load = g * out->mass;
    return whirl_ok();
}

whirl_status thrust_build(building *b, size_t *culprit) {
    const whirl_design *design = b->design;
    size_t last = WHIRL_NO_ELEMENT; // gravity along the axis
    if (b->mesh.shaft_count == 0) return whirl_ok();
    for (size_t i = 0; i < design->element_count; i++) {
        const design_element *own = &design->elements[i];
        if (own->type != &gravity_element || own->values[GRAVITY_AXIS].choice != GRAVITY_VERTICAL) continue;
        *culprit = last = i;
        if (!own->values[GRAVITY_HELD_AT].given) continue;
        const whirl_status status = thrust_add(b, own->values);
        if (status.code != WHIRL_OK) return status;
    }
    for (size_t s = 0; s < b->mesh.shaft_count && last != WHIRL_NO_ELEMENT; s++)
        if (b->mesh.shafts[s].meshed && !b->thrust[s].held)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "does not say which station holds shaft '%s' along its axis, expected held_at: a station "
                              "of it%s",
                              design->shafts[s].name,
                              b->mesh.shaft_count > 1 ? ", of another gravity for each shaft" : "");
    return whirl_ok();
}
