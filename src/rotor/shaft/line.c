// The bent centre lines of shafts between their nodes, from the shape functions of elements and the reduction of
// shafts.
#include "whirl/internal/line.h"

#include <stdlib.h>
#include <string.h>

#include "building.h"
#include "held.h"
#include "shaft_places.h"

/// Least number of places on a shaft.
enum { LINE_PLACES = 96 };

static whirl_status line_no_memory(void) {
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for the line of a shaft");
}

/// Returns the piece to the right of a node (of several layers, the first), or NULL at the end of a shaft.
static const mesh_piece *piece_behind(const mesh *from, size_t node) {
    for (size_t i = 0; i < from->piece_count; i++)
        if (from->pieces[i].node[0] == node) return &from->pieces[i];
    return NULL;
}

/// Spreads places over the pieces of all shafts; places [out->count], in the order of `out`.
static whirl_status line_lay(const mesh *from, whirl_shaft_line *out, line_place **places) {
    const size_t most = from->node_count * (LINE_PLACES + 1) + 1;
    out->shaft = calloc(most, sizeof *out->shaft);
    out->position = calloc(most, sizeof *out->position);
    *places = calloc(most, sizeof **places);
    if (!out->shaft || !out->position || !*places) return line_no_memory();
    for (size_t n = 0; n < from->node_count; n++) {
        const mesh_piece *piece = piece_behind(from, n);
        const held_shaft own = held_find(from, from->nodes[n].shaft);
        if (!piece) continue;
        const size_t parts = (LINE_PLACES + own.nodes - 2) / (own.nodes - 1);
        const bool last = n + 2 == own.first + own.nodes;
        for (size_t k = 0; k < parts + last; k++) {
            const double at = (double)k / (double)parts;
            out->shaft[out->count] = from->nodes[n].shaft + 1;
            out->position[out->count] = from->nodes[n].z + at * piece->piece.length;
            (*places)[out->count].node = n;
            piece_shape(&piece->piece, at, (*places)[out->count++].moved);
        }
    }
    return whirl_ok();
}

/// A place moves by `moved` per unit of `coordinate`, a coordinate of the unreduced shaft. Adds to `share` [degrees]
/// how far each coordinate of the rotor moves the place. `follow` [unreduced][degrees]: unreduced coordinates by those
/// of the rotor; NULL: the shaft is not reduced.
static void line_add(const assembly *of, const double *follow, size_t coordinate, double moved, double *share) {
    if (coordinate == NO_COORDINATE) return;
    if (!follow) share[coordinate] += moved * of->unit[coordinate];
    for (size_t d = 0; d < of->degrees && follow; d++)
        share[d] += moved * follow[coordinate * of->degrees + d] * of->unit[d];
}

/// Computes the contribution of each coordinate to the line's displacement. The building must be assembled, but not
/// finished.
static whirl_status line_share(building *b, const line_place *places, whirl_shaft_line *out) {
    double *follow = NULL;
    size_t(*nodes)[2] = calloc(b->mesh.node_count + 1, sizeof *nodes); // x and tilt_x
    if (!nodes) return line_no_memory();
    for (size_t n = 0; n < b->mesh.node_count; n++) {
        const size_t *coordinate = b->assembly.stations[b->mesh.nodes[n].station].coordinate;
        nodes[n][0] = coordinate[AXIS_X];
        nodes[n][1] = coordinate[AXIS_TILT_X];
    }
    whirl_status status = reduction_make(&b->mesh, &b->assembly, b->elements, b->element_count, b->reductions, &follow);
    out->degrees = b->assembly.degrees;
    if (status.code == WHIRL_OK) out->share = calloc(out->count * out->degrees + 1, sizeof *out->share);
    if (status.code == WHIRL_OK && !out->share) status = line_no_memory();
    for (size_t p = 0; p < out->count && status.code == WHIRL_OK; p++)
        for (size_t k = 0; k < 4; k++)
            line_add(&b->assembly, follow, nodes[places[p].node + k / 2][k % 2], places[p].moved[k],
                     out->share + p * out->degrees);
    free(nodes);
    free(follow);
    return status;
}

whirl_status whirl_design_line(const whirl_design *design, const char *couplings, whirl_shaft_line *out) {
    building b = {0};
    line_place *places = NULL;
    *out = (whirl_shaft_line){0};
    whirl_status status = building_assemble(&b, design, NULL);
    if (status.code == WHIRL_OK) status = line_lay(&b.mesh, out, &places);
    if (status.code == WHIRL_OK) status = line_share(&b, places, out);
    if (status.code == WHIRL_OK && couplings) status = statics_line(design, couplings, places, out);
    if (status.code != WHIRL_OK) whirl_shaft_line_free(out);
    free(places);
    building_end(&b);
    return status;
}

double whirl_shaft_line_at(const whirl_shaft_line *line, size_t place, int across, const double *state, size_t stride) {
    const double *share = line->share + place * line->degrees;
    double sum = 0.0;
    for (size_t d = 0; d < line->degrees; d++)
        if (share[d] != 0.0) sum += share[d] * state[stride * (d + (size_t)across)];
    return sum;
}

void whirl_shaft_line_free(whirl_shaft_line *line) {
    free(line->shaft);
    free(line->position);
    free(line->share);
    free(line->sag);
    *line = (whirl_shaft_line){0};
}
