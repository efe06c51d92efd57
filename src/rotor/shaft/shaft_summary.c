// Summary of a design's shafts, and the error of their reduction.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "building.h"
#include "matrix.h"

/// A plane of a free shaft, with its stations' inertia.
typedef struct plane {
    size_t count;
    size_t *coordinate;
    double *stiffness, *mass; ///< [count][count]
    double *squares;          ///< [count] w^2
    double *bend;             ///< [stations][stations] displacements of stations by unit forces
} plane;

static void plane_clear(plane *p) {
    free(p->coordinate);
    free(p->stiffness);
    free(p->squares);
}

static bool plane_allocate(plane *p, size_t most, size_t stations) {
    p->coordinate = calloc(most + 1, sizeof *p->coordinate);
    p->stiffness = calloc(3 * most * most + 1, sizeof *p->stiffness);
    p->squares = calloc(most + stations * (most + stations) + 1, sizeof *p->squares);
    if (!p->coordinate || !p->stiffness || !p->squares) return false;
    p->mass = p->stiffness + most * most;
    p->bend = p->squares + most;
    return true;
}

static bool find_squares(const plane *p) {
    return matrix_symmetric_modes(p->count, p->stiffness, p->mass, p->squares, p->mass + p->count * p->count);
}

/// Computes displacements of stations [count] by unit forces on them; station: their indices among the coordinates. The
/// free shaft is held by a spring at each station, as stiff as the shaft is there.
static bool find_bend(const plane *p, size_t stations, const size_t *station, const double *spring, double *bend) {
    const size_t n = p->count;
    double *k = p->mass; // the mass matrix is no longer needed
    double *column = calloc(n * stations + 1, sizeof *column);
    if (!column) return false;
    memcpy(k, p->stiffness, n * n * sizeof *k);
    for (size_t i = 0; i < stations; i++) {
        k[station[i] * n + station[i]] += spring[i];
        column[i * n + station[i]] = 1.0;
    }
    const bool good = matrix_solve(n, k, stations, column);
    for (size_t i = 0; i < stations; i++)
        for (size_t j = 0; j < stations; j++) bend[i * stations + j] = column[i * n + station[j]];
    free(column);
    return good;
}

/// Lists the coordinates along x of a shaft's stations, and their indices among those of a plane.
static size_t find_stations(const building *b, size_t shaft, const plane *p, size_t *place) {
    size_t count = 0;
    for (size_t s = 0; s < b->design->station_count; s++) {
        if (b->assembly.stations[s].shaft != shaft) continue;
        for (size_t i = 0; i < p->count; i++)
            if (p->coordinate[i] == b->assembly.stations[s].coordinate[AXIS_X]) place[count++] = i;
    }
    return count;
}

/// Fills a plane from the present assembly: its nodes, and its modes if it is reduced.
static bool take_plane(const building *b, size_t shaft, const reduction *modes, plane *p, size_t stations,
                       const double *spring, size_t *place) {
    p->count = reduction_nodes(&b->mesh, &b->assembly, shaft, p->coordinate);
    for (size_t k = 0; modes && k < modes->kept; k++) p->coordinate[p->count++] = modes->first + 2 * k;
    reduction_matrices(&b->assembly, p->count, p->coordinate, p->stiffness, p->mass);
    find_stations(b, shaft, p, place);
    return find_squares(p) && find_bend(p, stations, place, spring, p->bend);
}

static void fill_summary(const building *b, size_t shaft, whirl_shaft_summary *out) {
    const mesh *from = &b->mesh;
    double low = INFINITY, high = -INFINITY;
    *out = (whirl_shaft_summary){.reduced = from->shafts[shaft].reduced};
    memcpy(out->name, b->design->shafts[shaft].name, sizeof out->name);
    for (size_t i = 0; i < from->node_count; i++) {
        if (from->nodes[i].shaft != shaft) continue;
        out->nodes++;
        low = fmin(low, from->nodes[i].z);
        high = fmax(high, from->nodes[i].z);
    }
    out->length = high - low;
    for (size_t i = 0; i < from->piece_count; i++) {
        if (from->pieces[i].shaft != shaft) continue;
        piece_matrices matrices;
        piece_fill(&from->pieces[i].piece, &matrices);
        out->elements++;
        out->mass += matrices.weight[0] + matrices.weight[2];
    }
}

/// Returns an error of the reduction, or 0 if it is so small that rounding alone causes it.
static double without_rounding(double error) {
    const double rounding = 1e-12;
    return error < rounding ? 0.0 : error;
}

/// Computes the largest error of the first frequencies above the rigid body's, and of the displacements by unit forces.
static void shaft_summary_compare(const plane *full, const plane *now, size_t stations, whirl_shaft_summary *out) {
    enum { RIGID = 2, FIRST = 3 };
    double largest = 0.0, apart = 0.0;
    for (size_t i = RIGID; i < RIGID + FIRST && i < now->count; i++) {
        out->compared++;
        out->frequency_error = fmax(out->frequency_error, fabs(sqrt(now->squares[i] / full->squares[i]) - 1.0));
    }
    for (size_t i = 0; i < stations * stations; i++) {
        largest = fmax(largest, fabs(full->bend[i]));
        apart = fmax(apart, fabs(now->bend[i] - full->bend[i]));
    }
    out->frequency_error = without_rounding(out->frequency_error);
    out->flexibility_error = without_rounding(apart / largest);
}

static whirl_status summarize(building *b, whirl_shaft_summary *out, plane *full, plane *now, size_t *place,
                              double *spring) {
    const size_t count = b->mesh.shaft_count;
    bool good = true;
    // Compute the full matrices of each reduced shaft, and its response to forces at stations.
    for (size_t s = 0; s < count && good; s++) {
        fill_summary(b, s, &out[s]);
        good = plane_allocate(&full[s], 2 * out[s].nodes, b->design->station_count) &&
               plane_allocate(&now[s], 2 * out[s].nodes, b->design->station_count);
        if (!good || !out[s].reduced) continue;
        full[s].count = reduction_nodes(&b->mesh, &b->assembly, s, full[s].coordinate);
        reduction_matrices(&b->assembly, full[s].count, full[s].coordinate, full[s].stiffness, full[s].mass);
        const size_t stations = find_stations(b, s, &full[s], place);
        for (size_t i = 0; i < stations; i++)
            spring[s * WHIRL_MAX_STATIONS + i] = full[s].stiffness[place[i] * (full[s].count + 1)];
        good = take_plane(b, s, NULL, &full[s], stations, spring + s * WHIRL_MAX_STATIONS, place);
    }
    if (!good) return whirl_fail(WHIRL_NO_MEMORY, "no memory to compare a reduced shaft with its full model");
    // Reduce the shafts, and compare their responses.
    const whirl_status status = building_finish(b);
    for (size_t s = 0; s < count && status.code == WHIRL_OK && good; s++) {
        const reduction *made = &b->reductions[s];
        if (!out[s].reduced) continue;
        out[s].modes = made->kept;
        out[s].all_modes = made->all;
        out[s].highest = made->highest;
        now[s].count = reduction_nodes(&b->mesh, &b->assembly, s, now[s].coordinate);
        const size_t stations = find_stations(b, s, &now[s], place);
        good = take_plane(b, s, made, &now[s], stations, spring + s * WHIRL_MAX_STATIONS, place);
        if (good) shaft_summary_compare(&full[s], &now[s], stations, &out[s]);
    }
    if (!good) return whirl_fail(WHIRL_NO_MEMORY, "no memory to compare a reduced shaft with its full model");
    return status;
}

whirl_status whirl_design_shafts(const whirl_design *design, whirl_shaft_summary out[WHIRL_MAX_SHAFTS], size_t *count) {
    building b = {0};
    plane full[WHIRL_MAX_SHAFTS] = {{0}}, now[WHIRL_MAX_SHAFTS] = {{0}};
    size_t place[WHIRL_MAX_STATIONS];
    double *spring = calloc((size_t)WHIRL_MAX_SHAFTS * WHIRL_MAX_STATIONS, sizeof *spring);
    *count = 0;
    whirl_status status =
        spring ? building_assemble(&b, design, NULL) : whirl_fail(WHIRL_NO_MEMORY, "no memory to look at shafts");
    if (status.code == WHIRL_OK) status = summarize(&b, out, full, now, place, spring);
    // Shafts without segments have no mesh to summarize.
    for (size_t s = 0; s < b.mesh.shaft_count && status.code == WHIRL_OK; s++)
        if (b.mesh.shafts[s].meshed) out[(*count)++] = out[s];
    for (size_t s = 0; s < WHIRL_MAX_SHAFTS; s++) {
        plane_clear(&full[s]);
        plane_clear(&now[s]);
    }
    free(spring);
    building_end(&b);
    return status;
}
