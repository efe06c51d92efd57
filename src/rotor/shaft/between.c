#include "between.h"
#include "mesh.h"
#include "reduction.h"

#include <stdlib.h>
#include <string.h>

#include "matrix.h"

/// A plane of a shaft: the displacements of its stations are given, its other coordinates follow.
typedef struct plane {
    size_t count, given;
    size_t coordinate[AXES * WHIRL_MAX_STATIONS]; ///< [count] given ones first
    double *stiffness, *mass;                     ///< [count][count]
    double *inner, *follow;                       ///< [rest][rest]; [given][rest]
} plane;

static void between_mark(plane *p, size_t coordinate) {
    size_t at = p->given;
    while (p->coordinate[at] != coordinate) at++;
    p->coordinate[at] = p->coordinate[p->given];
    p->coordinate[p->given++] = coordinate;
}

/// Lists the coordinates of a shaft. Returns how many of the given ones are displacements.
static size_t find_coordinates(const mesh *from, const assembly *of, size_t shaft, const reduction *made, plane *p) {
    const assembly_station *last = NULL;
    p->given = 0;
    p->count = reduction_nodes(from, of, shaft, p->coordinate);
    for (size_t k = 0; from->shafts[shaft].reduced && k < made->kept; k++)
        p->coordinate[p->count++] = made->first + 2 * k;
    for (size_t i = 0; i < from->node_count; i++) {
        const assembly_station *at = &of->stations[from->nodes[i].station];
        if (at->shaft != shaft || at->hidden) continue;
        between_mark(p, (last = at)->coordinate[AXIS_X]);
    }
    const size_t displacements = p->given;
    if (displacements == 1)
        between_mark(p, last->coordinate[AXIS_TILT_X]); // with one displacement alone, the shaft
                                                        // could tilt freely
    return displacements;
}

/// Copies K_II and -K_IB from the stiffness.
static void split(plane *p) {
    const size_t rest = p->count - p->given;
    for (size_t i = 0; i < rest; i++) {
        const double *row = p->stiffness + (p->given + i) * p->count;
        for (size_t c = 0; c < p->given; c++) p->follow[c * rest + i] = -row[c];
        memcpy(p->inner + i * rest, row + p->given, rest * sizeof *row);
    }
}

static whirl_status add_shaft(const mesh *from, const assembly *of, size_t shaft, const reduction *made, plane *p,
                              between_term *terms, size_t *count) {
    const size_t displacements = find_coordinates(from, of, shaft, made, p), rest = p->count - p->given;
    if (displacements == 0 || rest == 0) return whirl_ok();
    reduction_matrices(of, p->count, p->coordinate, p->stiffness, p->mass);
    split(p);
    if (!matrix_solve(rest, p->inner, p->given, p->follow))
        return whirl_fail(WHIRL_BAD_INPUT, "shaft %zu gives way between its stations: its axial force buckles it",
                          shaft + 1);
    for (size_t i = 0; i < rest; i++)
        for (size_t c = 0; c < displacements; c++) {
            const size_t row = p->coordinate[p->given + i], column = p->coordinate[c];
            const double share = p->follow[c * rest + i] * of->unit[column] / of->unit[row];
            if (share != 0.0) terms[(*count)++] = (between_term){row, column, share};
        }
    return whirl_ok();
}

whirl_status between_stations(const mesh *from, const assembly *of, const reduction *made, between_term **terms,
                              size_t *count) {
    const size_t most = of->degrees / 2; // in a plane
    *terms = NULL;
    *count = 0;
    if (from->node_count == 0) return whirl_ok();
    plane *p = calloc(1, sizeof *p);
    double *block = calloc(4 * most * most + 1, sizeof *block);
    *terms = calloc(most * most + 1, sizeof **terms);
    whirl_status status = p && block && *terms ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for shafts");
    if (status.code == WHIRL_OK) {
        p->stiffness = block;
        p->mass = p->stiffness + most * most;
        p->inner = p->mass + most * most;
        p->follow = p->inner + most * most;
    }
    for (size_t s = 0; s < from->shaft_count && status.code == WHIRL_OK; s++)
        if (from->shafts[s].meshed) status = add_shaft(from, of, s, &made[s], p, *terms, count);
    free(block);
    free(p);
    return status;
}
