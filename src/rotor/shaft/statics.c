// Static effects of the weight of shafts, each of which rests by itself on its bearings as supports.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "building.h"
#include "held.h"
#include "matrix.h"
#include "mesh.h"
#include "name_list.h"
#include "shaft_places.h"
#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

/// Gravity, m/s2, for which the effect of weight is solved. The effect is scaled to the design's gravity.
static const double standard_gravity = 9.80665;

/// The line whose sag is requested, and its places; both NULL if none is requested.
typedef struct asked_line {
    const line_place *places;
    whirl_shaft_line *out;
} asked_line;

/// A shaft in the plane of its weight: displacement upwards and slope of each node, node by node along it.
typedef struct beam {
    const building *b;
    size_t shaft, nodes, supports, unknowns; ///< unknowns: 2 for each node, then the load of every support
    size_t first;                            ///< first of its nodes in the mesh
    const size_t *support;                   ///< [supports] nodes, along the shaft
    double gravity, up; ///< gravity across the shaft, m/s2; component of y upwards, 1 if gravity pulls against y
    double solved;      ///< gravity for which the effect of the weight is solved, m/s2: standard gravity or 0
    double *matrix;     ///< [unknowns][unknowns]
    double *all;        ///< [1 + supports][unknowns] solutions for its weight, then for raising each support by 1 m
    asked_line line;
} beam;

static whirl_status statics_no_memory(void) {
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for the weight of shafts");
}

static const mesh_node *node_of(const beam *of, size_t node) {
    return &of->b->mesh.nodes[of->first + node];
}

static const assembly_station *station_of(const beam *of, size_t node) {
    return &of->b->assembly.stations[node_of(of, node)->station];
}

// ---------------------------------------------------------------- equations

/// Computes stiffness and weight of a piece.
static void piece_stiffness(const mesh_piece *own, matrix4 *stiffness, double weight[4]) {
    piece_matrices all;
    matrix4 axial;
    piece_fill(&own->piece, &all);
    held_piece(own, stiffness, &axial);
    for (size_t i = 0; i < 4; i++)
        weight[i] = !own->settings.lumped ? all.weight[i] : i % 2 == 0 ? all.lumped_mass[i / 2] : 0.0;
    for (size_t i = 0; i < 4; i++)
        for (size_t j = 0; j < 4; j++) stiffness->at[i][j] += axial.at[i][j];
}

static bool statics_solve(const beam *of) {
    for (size_t n = 0; n < of->nodes; n++) {
        of->all[2 * n] = -of->solved * station_of(of, n)->mass;
        of->all[2 * n + 1] = -of->solved * station_of(of, n)->pull_moment;
    }
    for (size_t s = 0; s < of->supports; s++) of->all[(1 + s) * of->unknowns + 2 * of->nodes + s] = 1.0;
    held_fill(&(held_shaft){&of->b->mesh, of->shaft, of->first, of->nodes, of->supports, of->support}, true,
              of->matrix);
    return matrix_solve(of->unknowns, of->matrix, 1 + of->supports, of->all);
}

// ---------------------------------------------------------------- within the shaft

/// Computes bending moment and shear next to a node, from the end forces of the pieces on that side (which: 0 left, 1
/// right), for the weight (by: 0) or for raising support by - 1. Both are 0 at an end of the shaft.
static void cut(const beam *of, size_t node, size_t which, size_t by, double *moment, double *shear) {
    const mesh *from = &of->b->mesh;
    const double *at = of->all + by * of->unknowns;
    double force[2] = {0.0, 0.0};
    for (size_t p = 0; p < from->piece_count; p++) {
        const mesh_piece *own = &from->pieces[p];
        matrix4 stiffness;
        double weight[4];
        if (own->node[1 - which] != of->first + node) continue;
        piece_stiffness(own, &stiffness, weight);
        for (size_t i = 0; i < 2; i++) {
            const size_t row = 2 * (1 - which) + i;
            for (size_t j = 0; j < 4; j++)
                force[i] += stiffness.at[row][j] * at[2 * (own->node[j / 2] - of->first) + j % 2];
            if (by == 0) force[i] += of->solved * weight[row];
        }
    }
    // The node is the right end of the pieces to its left, so that signs are opposite there.
    *shear = which == 0 ? -force[0] : force[0];
    *moment = which == 0 ? force[1] : -force[1];
}

/// Computes moment and mean shear at a coupling.
static void cut_coupling(const beam *of, size_t node, size_t by, double out[2]) {
    double moment, shear[2];
    for (size_t which = 0; which < 2; which++) cut(of, node, which, by, &moment, &shear[which]);
    out[0] = moment;
    out[1] = 0.5 * (shear[0] + shear[1]);
}

// ---------------------------------------------------------------- alignment

enum { MAX_COUPLINGS = 8 };

/// Lists the nodes of those stations in the list that are on this shaft. Returns their number.
static size_t find_couplings(const beam *of, const char *list, size_t node[MAX_COUPLINGS]) {
    char name[WHIRL_NAME_SIZE];
    size_t count = 0;
    while (count < MAX_COUPLINGS && name_list_next(&list, name)) {
        size_t n = 0;
        while (n < of->nodes && (station_of(of, n)->hidden || strcmp(station_of(of, n)->name, name) != 0)) n++;
        node[count] = n;
        count += n < of->nodes;
    }
    return count;
}

/// Finds the least elevations [supports], of which the first two are 0, with which `count` couplings carry nothing.
static whirl_status align(const beam *of, size_t count, const size_t *node, double *elevation) {
    const size_t rows = 2 * count, free_ones = of->supports - 2;
    double *j = calloc(rows * (of->supports + rows + 2) + 1, sizeof *j), *square = j ? j + rows * of->supports : NULL;
    double *side = j ? square + rows * rows : NULL;
    if (!j) return statics_no_memory();
    // Compute moment and shear at the couplings by the weight (side), and by raising each free support (j).
    for (size_t c = 0; c < count; c++) {
        double at[2];
        cut_coupling(of, node[c], 0, at);
        memcpy(side + 2 * c, (double[]){-at[0], -at[1]}, sizeof at);
        for (size_t s = 0; s < free_ones; s++) {
            cut_coupling(of, node[c], 3 + s, at);
            for (size_t i = 0; i < 2; i++) j[(2 * c + i) * of->supports + s] = at[i];
        }
    }
    // Compute the elevations of least norm, J' (J J')^-1 side.
    for (size_t r = 0; r < rows; r++)
        for (size_t k = 0; k < rows; k++)
            for (size_t s = 0; s < free_ones; s++)
                square[r * rows + k] += j[r * of->supports + s] * j[k * of->supports + s];
    const bool good = free_ones >= rows && matrix_solve(rows, square, 1, side);
    for (size_t s = 0; s < free_ones && good; s++)
        for (size_t r = 0; r < rows; r++) elevation[2 + s] += j[r * of->supports + s] * side[r];
    free(j);
    return good ? whirl_ok()
                : whirl_fail(WHIRL_BAD_INPUT,
                             "no elevations of %zu bearings behind the first two relieve %zu coupling%s of moment and "
                             "shear, expected two a coupling at least",
                             free_ones, count, count == 1 ? "" : "s");
}

/// Raises the supports. The solution for the weight then includes their elevation.
static void raise_supports(const beam *of, const double *elevation) {
    for (size_t s = 0; s < of->supports; s++)
        for (size_t i = 0; i < of->unknowns; i++) of->all[i] += elevation[s] * of->all[(1 + s) * of->unknowns + i];
}

// ---------------------------------------------------------------- bearings

/// Counts the bearings at a station. *aside becomes true if one is shared with another shaft; *elevation becomes their
/// mean elevation.
static size_t count_bearings(const beam *of, size_t at, bool *aside, double *elevation) {
    const building *b = of->b;
    size_t count = 0;
    *elevation = 0.0;
    for (size_t i = 0; i < b->design->element_count; i++) {
        const design_element *own = &b->design->elements[i];
        if (!building_carries(own)) continue;
        const size_t place = building_value(own, "at")->station[0];
        const key_value *from = building_value(own, "from");
        const size_t other = from && from->given ? from->station[0] : GROUND;
        const size_t shafts[] = {b->assembly.stations[place].shaft,
                                 other == GROUND ? NO_SHAFT : b->assembly.stations[other].shaft};
        const bool both = shafts[0] != NO_SHAFT && shafts[1] != NO_SHAFT && shafts[0] != shafts[1];
        *aside = *aside || (both && (place == at || other == at));
        // Either end of a bearing may be the fixed one.
        if (place != at && (other != at || shafts[0] != NO_SHAFT)) continue;
        const key_value *raised = building_value(own, "elevation");
        if (raised) *elevation += place == at ? raised->number : -raised->number;
        count++;
    }
    if (count > 0) *elevation /= (double)count;
    return count;
}

// ---------------------------------------------------------------- one shaft

/// Returns a value, or 0 if it is rounding compared with `beside`, such as the shaft's weight.
static double rounded(double value, double beside) {
    return fabs(value) > 1e-12 * beside ? value : 0.0;
}

static double weight_of(const beam *of) {
    double mass = 0.0;
    for (size_t n = 0; n < of->nodes; n++) mass += station_of(of, n)->mass;
    return standard_gravity * mass;
}

/// Returns the factor that scales the solution to the machine.
static double scale_of(const beam *of) {
    return of->solved > 0.0 ? of->gravity / of->solved : 1.0;
}

/// Returns the axial force in the shaft next to a node; 0 at an end of the shaft.
static double axial_beside(const beam *of, size_t node, size_t which) {
    const mesh *from = &of->b->mesh;
    double force = 0.0;
    for (size_t p = 0; p < from->piece_count; p++)
        if (from->pieces[p].node[1 - which] == of->first + node) force += from->pieces[p].piece.axial[1 - which];
    return force;
}

/// Fills in the masses that both sides of a node carry.
static void fill_masses_beside(const beam *of, size_t node, whirl_station_statics *out) {
    const double weight = weight_of(of);
    double moment, shear[2], carried[2] = {0.0, 0.0}; // loads of the bearings to the left and to the right
    for (size_t which = 0; which < 2; which++) cut(of, node, which, 0, &moment, &shear[which]);
    for (size_t s = 0; s < of->supports; s++)
        if (of->support[s] != node) carried[of->support[s] > node] += of->all[2 * of->nodes + s];
    out->mass[0] = rounded(carried[0] - shear[0], weight) / standard_gravity;
    out->mass[1] = rounded(carried[1] + shear[1], weight) / standard_gravity;
}

static void fill_masses(const beam *of, whirl_station_statics *out) {
    for (size_t n = 0; n < of->nodes; n++)
        if (!station_of(of, n)->hidden) fill_masses_beside(of, n, &out[node_of(of, n)->station]);
    for (size_t s = 0; s < of->supports; s++)
        out[node_of(of, of->support[s])->station].carried =
            rounded(of->all[2 * of->nodes + s], weight_of(of)) / standard_gravity;
}

static void fill_station(const beam *of, size_t node, whirl_station_statics *out) {
    const double scale = scale_of(of), weight = weight_of(of);
    const double length = node_of(of, of->nodes - 1)->z - node_of(of, 0)->z;
    double moment[2], shear[2];
    for (size_t which = 0; which < 2; which++) cut(of, node, which, 0, &moment[which], &shear[which]);
    const bool end = node == 0 || node + 1 == of->nodes; // a free end
    out->deflection = scale * of->all[2 * node];
    out->slope = scale * of->all[2 * node + 1];
    out->moment = end ? 0.0 : scale * rounded(moment[0], weight * length);
    for (size_t which = 0; which < 2; which++) {
        out->shear[which] = scale * rounded(shear[which], weight);
        out->axial[which] = axial_beside(of, node, which);
    }
}

static void fill_line(const beam *of) {
    const whirl_shaft_line *line = of->line.out;
    for (size_t p = 0; p < line->count; p++) {
        const line_place *at = &of->line.places[p];
        if (line->shaft[p] != of->shaft + 1) continue;
        const double *node = of->all + 2 * (at->node - of->first);
        for (size_t k = 0; k < 4; k++) line->sag[p] += scale_of(of) * at->moved[k] * node[k];
    }
}

static void fill_stations(const beam *of, const double *elevation, whirl_station_statics *out, double *influence) {
    const size_t stations = of->b->design->station_count;
    const shaft_thrust *thrust = &of->b->thrust[of->shaft];
    for (size_t n = 0; n < of->nodes; n++)
        if (!station_of(of, n)->hidden) fill_station(of, n, &out[node_of(of, n)->station]);
    for (size_t s = 0; s < of->supports; s++) {
        const size_t at = node_of(of, of->support[s])->station;
        out[at].load = scale_of(of) * rounded(of->all[2 * of->nodes + s], weight_of(of));
        out[at].elevation = out[at].deflection = scale_of(of) * elevation[s]; // without rounding
        out[at].bearings = (double)count_bearings(of, at, &(bool){false}, &(double){0.0});
        for (size_t k = 0; k < of->supports; k++)
            influence[at * stations + node_of(of, of->support[k])->station] =
                of->all[(1 + k) * of->unknowns + 2 * of->nodes + s];
    }
    if (of->line.out) fill_line(of);
    if (!thrust->held) return;
    out[thrust->station].thrust = thrust->load;
    out[thrust->station].thrust_mass = thrust->mass;
}

/// Raises bearings by the elevations in their keys, in the scale of the solution.
static void raise_given(const beam *of, double *elevation) {
    for (size_t s = 0; s < of->supports; s++) {
        double own = 0.0;
        count_bearings(of, node_of(of, of->support[s])->station, &(bool){false}, &own);
        elevation[s] = own != 0.0 ? own * of->up / scale_of(of) : 0.0;
    }
    raise_supports(of, elevation);
}

/// Raises the bearings after the first two of the shaft so that its couplings carry nothing. elevation [2][supports]:
/// elevations of all bearings, then workspace.
static whirl_status raise_aligned(const beam *of, const char *couplings, double *elevation) {
    size_t node[MAX_COUPLINGS];
    const size_t count = find_couplings(of, couplings, node);
    double *further = elevation + of->supports;
    const whirl_status status = count > 0 ? align(of, count, node, further) : whirl_ok();
    if (status.code != WHIRL_OK) return status;
    raise_supports(of, further);
    for (size_t s = 0; s < of->supports; s++) elevation[s] += further[s];
    return status;
}

/// Removes the weight from the solution. Bearings then carry only what their elevations cause.
static void take_weight(beam *of, double *elevation) {
    of->solved = 0.0;
    memset(of->all, 0, of->unknowns * sizeof *of->all);
    memset(elevation, 0, 2 * of->supports * sizeof *elevation);
}

static whirl_status fill_shaft(beam *of, const char *couplings, double *elevation, whirl_station_statics *out,
                               double *influence) {
    const bool weightless = of->gravity == 0.0;
    of->solved = standard_gravity;
    if (!statics_solve(of))
        return whirl_fail(WHIRL_BAD_INPUT, "shaft '%s' does not rest on its bearings",
                          of->b->design->shafts[of->shaft].name);
    if (!weightless) raise_given(of, elevation);
    whirl_status status = raise_aligned(of, couplings, elevation);
    if (status.code != WHIRL_OK) return status;
    // Masses are those that bearings would carry if the shaft were horizontal.
    fill_masses(of, out);
    if (weightless) {
        take_weight(of, elevation);
        raise_given(of, elevation);
        status = raise_aligned(of, couplings, elevation);
    }
    if (status.code == WHIRL_OK) fill_stations(of, elevation, out, influence);
    return status;
}

static whirl_status take_shaft(beam *of, const char *couplings, whirl_station_statics *out, double *influence) {
    of->unknowns = 2 * of->nodes + of->supports;
    of->matrix = calloc(of->unknowns * of->unknowns + 1, sizeof *of->matrix);
    of->all = calloc((1 + of->supports) * of->unknowns + 2 * of->supports + 1, sizeof *of->all);
    const whirl_status status =
        of->matrix && of->all ? fill_shaft(of, couplings, of->all + (1 + of->supports) * of->unknowns, out, influence)
                              : statics_no_memory();
    free(of->matrix);
    free(of->all);
    return status;
}

// ---------------------------------------------------------------- all shafts

static whirl_status find_supports(const beam *of, size_t *support, size_t *count) {
    const char *name = of->b->design->shafts[of->shaft].name;
    bool aside = false;
    *count = 0;
    for (size_t n = 0; n < of->nodes; n++) {
        const size_t at = node_of(of, n)->station;
        if (!station_of(of, n)->hidden && count_bearings(of, at, &aside, &(double){0.0}) > 0) support[(*count)++] = n;
    }
    if (aside)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "shaft '%s' shares a bearing with another shaft: the loads of its bearings are "
                          "unknown",
                          name);
    if (*count >= 2) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "shaft '%s' lies on %zu bearing%s, expected two at least for its weight", name,
                      *count, *count == 1 ? "" : "s");
}

static whirl_status statics_fill(const building *b, const char *couplings, size_t *support, asked_line line,
                                 whirl_station_statics *out, double *influence) {
    const whirl_weight weight = whirl_design_weight(b->design);
    whirl_status status = whirl_ok();
    if (b->mesh.node_count == 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "there is no shaft of finite elements, expected segments for the analysis of weight");
    for (size_t shaft = 0; shaft < b->mesh.shaft_count && status.code == WHIRL_OK; shaft++) {
        if (!b->mesh.shafts[shaft].meshed) continue;
        const held_shaft own = held_find(&b->mesh, shaft);
        beam of = {.b = b, .shaft = shaft, .first = own.first, .nodes = own.nodes, .support = support};
        of.gravity = weight.across;
        of.up = weight.up;
        of.line = line;
        status = find_supports(&of, support, &of.supports);
        if (status.code == WHIRL_OK) status = take_shaft(&of, couplings, out, influence);
    }
    return status;
}

/// Checks that every name in a list is a station of a shaft.
static whirl_status check_couplings(const building *b, const char *list) {
    char name[WHIRL_NAME_SIZE];
    while (name_list_next(&list, name)) {
        size_t station = 0;
        while (station < b->design->station_count && strcmp(b->design->stations[station].name, name) != 0) station++;
        if (station == b->design->station_count)
            return whirl_fail(WHIRL_BAD_INPUT, "coupling: '%s' is no station", name);
        if (b->assembly.stations[station].shaft == NO_SHAFT)
            return whirl_fail(WHIRL_BAD_INPUT, "coupling: station '%s' lies on no shaft of finite elements", name);
    }
    return whirl_ok();
}

static whirl_status statics_make(const whirl_design *design, const char *couplings, asked_line line,
                                 whirl_station_statics *out, double *influence) {
    building b = {0};
    const double none = NAN;
    size_t *support = calloc(design->station_count + 1, sizeof *support);
    for (size_t s = 0; s < design->station_count; s++)
        out[s] = (whirl_station_statics){.deflection = none,
                                         .slope = none,
                                         .moment = none,
                                         .shear = {none, none},
                                         .load = none,
                                         .carried = none,
                                         .mass = {none, none},
                                         .elevation = none,
                                         .axial = {none, none},
                                         .thrust = none,
                                         .thrust_mass = none};
    memset(influence, 0, design->station_count * design->station_count * sizeof *influence);
    whirl_status status = support ? building_assemble(&b, design, NULL) : statics_no_memory();
    if (status.code == WHIRL_OK) status = check_couplings(&b, couplings);
    if (status.code == WHIRL_OK) status = statics_fill(&b, couplings, support, line, out, influence);
    free(support);
    building_end(&b);
    return status;
}

whirl_status whirl_design_statics(const whirl_design *design, const char *couplings, whirl_station_statics *out,
                                  double *influence) {
    return statics_make(design, couplings, (asked_line){NULL, NULL}, out, influence);
}

whirl_status statics_line(const whirl_design *design, const char *couplings, const line_place *places,
                          whirl_shaft_line *out) {
    const size_t stations = design->station_count;
    whirl_station_statics *at = calloc(stations + 1, sizeof *at);
    double *influence = calloc(stations * stations + 1, sizeof *influence);
    out->sag = calloc(out->count + 1, sizeof *out->sag);
    const whirl_status status = at && influence && out->sag
                                    ? statics_make(design, couplings, (asked_line){places, out}, at, influence)
                                    : statics_no_memory();
    free(at);
    free(influence);
    return status;
}
