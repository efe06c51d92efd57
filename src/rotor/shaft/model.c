// Description of a design's parts: sections of its shafts, masses of its stations, sums of both, and its elements.
#include "whirl/internal/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "building.h"
#include "machine.h"
#include "oil.h"
#include "pads_build.h"
#include "shafts.h"

static bool is_even(const shaft_piece *piece) {
    return piece->outer[0] == piece->outer[1] && piece->inner[0] == piece->inner[1];
}

static bool is_of_one(const material *one, const material *other) {
    return one->modulus == other->modulus && one->shear_modulus == other->shear_modulus &&
           one->density == other->density;
}

/// Returns true if a piece continues the previous one.
static bool goes_on(const mesh_piece *one, const mesh_piece *next) {
    const shaft_piece *a = &one->piece, *b = &next->piece;
    return one->shaft == next->shaft && one->node[1] == next->node[0] && is_even(a) && is_even(b) &&
           a->outer[0] == b->outer[0] && a->inner[0] == b->inner[0] && a->flats == b->flats &&
           is_of_one(&a->of, &b->of);
}

/// Adds a piece to the sections and to its shaft. Until all pieces are added, the shaft's centre holds the sum of
/// moments.
static void add_piece(const mesh *from, size_t index, whirl_model *out) {
    const mesh_piece *own = &from->pieces[index];
    const double start = from->nodes[own->node[0]].z, length = own->piece.length;
    // The mass per metre is a quadratic polynomial, so that Simpson's rule gives its integral and moment exactly.
    const double middle = 4.0 * piece_line_mass(&own->piece, 0.5), last = piece_line_mass(&own->piece, 1.0);
    const double mass = length / 6.0 * (piece_line_mass(&own->piece, 0.0) + middle + last);
    out->shafts[own->shaft].mass += mass;
    out->shafts[own->shaft].centre += mass * start + length * length / 6.0 * (0.5 * middle + last);
    if (index == 0 || !goes_on(own - 1, own)) {
        whirl_model_section *next = &out->sections[out->section_count++];
        next->shaft = own->shaft;
        next->from = start;
        memcpy(next->outer, own->piece.outer, sizeof next->outer);
        memcpy(next->inner, own->piece.inner, sizeof next->inner);
    }
    out->sections[out->section_count - 1].to = start + length;
    out->sections[out->section_count - 1].mass += mass;
}

/// Subtracts a part from a sum. A remainder within rounding becomes 0.
static void model_subtract(double *of, double part) {
    const double left = *of - part;
    *of = fabs(left) > 1e-12 * part ? left : 0.0;
}

/// Computes the masses of stations: those of the assembly minus those of the mesh at its nodes.
static void take_pieces(const building *b, whirl_model *out) {
    for (size_t n = 0; n < b->mesh.node_count; n++) {
        const size_t station = b->mesh.nodes[n].station;
        double mass = 0.0, diametral = 0.0;
        if (station >= out->station_count) continue;
        for (size_t i = 0; i < 2 * b->mesh.piece_count; i++) {
            const mesh_piece *own = &b->mesh.pieces[i / 2];
            piece_matrices all;
            if (own->node[i % 2] != n) continue;
            piece_fill(&own->piece, &all);
            mass += b->mesh.shafts[own->shaft].lumped ? all.lumped_mass[i % 2] : all.weight[2 * (i % 2)];
            diametral += all.lumped_diametral[i % 2];
        }
        model_subtract(&out->stations[station].mass, mass);
        model_subtract(&out->stations[station].diametral, diametral);
    }
}

/// Finds the stations of an element: those of its key `between`; or that of `at` and that of the ring or housing around
/// it.
static void model_stations(const design_element *own, size_t station[2]) {
    static const char *const others[] = {"ring", "from"};
    const key_value *between = building_value(own, "between"), *at = building_value(own, "at");
    station[0] = at && at->given ? at->station[0] : WHIRL_MODEL_NONE;
    station[1] = WHIRL_MODEL_NONE;
    if (between && between->given) memcpy(station, between->station, sizeof between->station);
    for (int k = 0; k < 2 && station[1] == WHIRL_MODEL_NONE; k++) {
        const key_value *value = building_value(own, others[k]);
        if (value && value->given) station[1] = value->station[0];
    }
}

static whirl_model_role model_role(const design_element *own, const size_t station[2]) {
    if (building_carries(own)) return WHIRL_ROLE_BEARING;
    if (building_drags(own)) return WHIRL_ROLE_DRAG;
    if (own->type->contact_gap) return WHIRL_ROLE_STATOR;
    if (!building_value(own, "between") && !building_value(own, "from")) return WHIRL_ROLE_OTHER;
    return station[0] == WHIRL_MODEL_NONE || station[1] == WHIRL_MODEL_NONE ? WHIRL_ROLE_SUPPORT : WHIRL_ROLE_LINK;
}

static bool is_above_zero(const key_value *value) {
    return value && value->number > 0.0;
}

/// Returns the viscosity of an element's oil or liquid in Pa s, or NaN if its keys give none.
static double model_viscosity(const design_element *own) {
    const key_value *const dynamic = building_value(own, "viscosity");
    const key_value *const kinematic = building_value(own, "kinematic_viscosity");
    const key_value *const density = building_value(own, "density");
    double viscosity = NAN;
    if (!dynamic || !kinematic || !density) return NAN;
    if (building_value(own, "grade")) {
        const oil liquid = {dynamic};
        return oil_viscosity(&liquid, &viscosity).code == WHIRL_OK ? viscosity : (double)NAN;
    }
    if (kinematic->given && density->given) return kinematic->number * density->number;
    return dynamic->given ? dynamic->number : (double)NAN;
}

static void model_add_values(const design_element *own, size_t *used, whirl_model *out, whirl_model_element *to) {
    const whirl_group *const group = &own->type->group;
    whirl_model_value *const values = out->values + *used;
    to->values = values;
    to->value_count = group->key_count;
    *used += group->key_count;
    for (size_t k = 0; k < group->key_count; k++) {
        const key_value *from = &own->values[k];
        const whirl_key *key = &group->keys[k];
        const bool any = from->given || *key->fallback;
        values[k] = (whirl_model_value){.key = key,
                                        .given = from->given,
                                        .number = from->count > 0 ? from->list[0]
                                                  : any           ? from->number
                                                                  : (double)NAN,
                                        .count = from->count,
                                        .choice = from->choice};
        values[k].last = from->count > 0 ? from->list[from->count - 1] : values[k].number;
    }
}

/// Adds the pads of a bearing if it has any.
static void model_add_pads(const building *b, const design_element *own, whirl_pads *pads, whirl_model_element *to) {
    const bool tilting = building_value(own, "pivot_stiffness") != NULL;
    if (!building_value(own, "pivots") || to->station[0] == WHIRL_MODEL_NONE) return;
    const double turn = b->assembly.turn * b->assembly.stations[to->station[0]].ratio;
    if (pads_of_keys(own->values, tilting, turn < 0.0, pads).code == WHIRL_OK) to->pads = pads;
}

static void model_add_element(const building *b, const design_element *own, size_t *used, whirl_model *out) {
    whirl_model_element *next = &out->elements[out->element_count];
    if (strcmp(own->type->group.name, "segment") == 0) return;
    next->kind = own->type->group.name;
    const bool weight = strcmp(next->kind, "gravity") == 0;
    if (weight && building_value(own, "axis")->choice != 0) {
        out->stands = true;
        out->rises = building_value(own, "top")->choice != 0;
    }
    model_stations(own, next->station);
    next->role = model_role(own, next->station);
    next->viscosity = model_viscosity(own);
    model_add_values(own, used, out, next);
    model_add_pads(b, own, &out->pads[out->element_count++], next);
    const bool unbalances = strncmp(next->kind, "unbalance", strlen("unbalance")) == 0;
    if ((unbalances || is_above_zero(building_value(own, "eccentricity"))) && next->station[0] < out->station_count)
        out->stations[next->station[0]].unbalanced = true;
}

static void model_add_station(const building *b, size_t station, whirl_model *out) {
    const assembly_station *from = &b->assembly.stations[station];
    const key_value *values = b->design->stations[station].values;
    whirl_model_mass *to = &out->stations[station];
    *to = (whirl_model_mass){from->mass, from->polar, from->diametral, from->shaft, from->position, false, NAN, NAN};
    for (size_t k = 0; k < station_group.key_count; k++)
        if (strcmp(station_group.keys[k].name, "eccentricity") == 0) to->unbalanced = is_above_zero(&values[k]);
}

static void model_fill(const building *b, whirl_model *out) {
    const mesh *from = &b->mesh;
    size_t used = 0;
    for (size_t s = 0; s < out->station_count; s++) model_add_station(b, s, out);
    for (size_t i = 0; i < b->design->element_count; i++) model_add_element(b, &b->design->elements[i], &used, out);
    take_pieces(b, out);
    for (size_t i = 0; i < from->piece_count; i++) add_piece(from, i, out);
    for (size_t n = 0; n < from->node_count; n++) {
        const mesh_node *node = &from->nodes[n];
        if (node->station >= out->station_count) continue;
        out->shafts[node->shaft].mass += out->stations[node->station].mass;
        out->shafts[node->shaft].centre += out->stations[node->station].mass * node->z;
    }
    for (size_t s = 0; s < out->shaft_count; s++)
        if (from->shafts[s].meshed) out->shafts[s].centre /= out->shafts[s].mass;
}

whirl_status whirl_design_model(const whirl_design *design, whirl_model *out) {
    building b = {0};
    size_t keys = 0;
    for (size_t i = 0; i < design->element_count; i++) keys += design->elements[i].type->group.key_count;
    *out = (whirl_model){0};
    // Assemble the machine, and copy its parts.
    whirl_status status = building_assemble(&b, design, NULL);
    if (status.code == WHIRL_OK) {
        out->station_count = design->station_count;
        out->shaft_count = b.mesh.node_count > 0 ? b.mesh.shaft_count : 0;
        out->sections = calloc(b.mesh.piece_count + 1, sizeof *out->sections);
        out->stations = calloc(out->station_count + 1, sizeof *out->stations);
        out->shafts = calloc(out->shaft_count + 1, sizeof *out->shafts);
        out->elements = calloc(design->element_count + 1, sizeof *out->elements);
        out->values = calloc(keys + 1, sizeof *out->values);
        out->pads = calloc(design->element_count + 1, sizeof *out->pads);
        if (out->sections && out->stations && out->shafts && out->elements && out->values && out->pads)
            model_fill(&b, out);
        else
            status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the model of a machine");
    }
    // Machines that twist have a train.
    for (size_t s = 0; s < design->station_count && status.code == WHIRL_OK; s++)
        if (b.assembly.stations[s].twists) {
            status = rotor_model_train(design, out);
            break;
        }
    if (status.code != WHIRL_OK) whirl_model_free(out);
    building_end(&b);
    return status;
}

const whirl_model_value *whirl_model_value_of(const whirl_model_element *of, const char *key) {
    for (size_t k = 0; k < of->value_count; k++)
        if (strcmp(of->values[k].key->name, key) == 0) return &of->values[k];
    return NULL;
}

void whirl_model_free(whirl_model *model) {
    free(model->values);
    free(model->pads);
    free(model->sections);
    free(model->stations);
    free(model->shafts);
    free(model->elements);
    free(model->joints);
    *model = (whirl_model){0};
}
