#include "reduction.h"
#include "inner_modes.h"
#include "mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"

// ---------------------------------------------------------------- new coordinates

/// A coordinate before the reduction as a sum of new ones.
typedef struct blend {
    size_t count;
    size_t *of;     ///< [count] new coordinates
    double *weight; ///< [count] m or rad for one m or rad of each new coordinate
} blend;

/// A reduction in progress.
typedef struct reducing {
    const mesh *mesh;
    assembly *of;
    bool *kept;             ///< [old degrees] coordinates that stay
    blend *old;             ///< [old degrees] each as a sum of new coordinates
    size_t degrees;         ///< number of the new coordinates so far
    double *inertia, *unit; ///< [old degrees] inertia and unit of the new coordinates, as in the assembly
} reducing;

static bool blend_reserve(blend *b, size_t count) {
    b->count = count;
    b->of = calloc(count + 1, sizeof *b->of);
    b->weight = calloc(count + 1, sizeof *b->weight);
    return b->of && b->weight;
}

static whirl_status reduction_no_memory(void) {
    return whirl_fail(WHIRL_NO_MEMORY, "no memory to reduce a shaft");
}

// ---------------------------------------------------------------- what stays

static void keep_pair(reducing *r, const assembly_station *at, axis along) {
    r->kept[at->coordinate[along]] = true;
    r->kept[at->coordinate[along + 1]] = true;
}

/// Keeps all coordinates that a kernel sees, and the coordinates along the other axis at the same nodes.
static void keep_ports(reducing *r, const element *elements, size_t count) {
    bool *seen = r->kept;
    for (size_t i = 0; i < count; i++)
        for (size_t p = 0; p < MAX_PORTS; p++)
            if (elements[i].port[p] != NO_COORDINATE) seen[elements[i].port[p]] = true;
    for (size_t s = 0; s < r->of->station_count; s++) {
        const assembly_station *at = &r->of->stations[s];
        if (at->shaft == NO_SHAFT) continue;
        for (axis along = AXIS_X; along <= AXIS_TILT_Y; along += 2)
            if (seen[at->coordinate[along]] || seen[at->coordinate[along + 1]]) keep_pair(r, at, along);
    }
}

/// Keeps the displacements of all stations. Of a shaft with a single station also keeps the tilts, since it could tilt
/// freely.
static void keep_stations(reducing *r) {
    for (size_t shaft = 0; shaft < r->mesh->shaft_count; shaft++) {
        const assembly_station *first = NULL;
        size_t count = 0;
        for (size_t s = 0; s < r->of->station_count; s++) {
            const assembly_station *at = &r->of->stations[s];
            if (at->shaft != shaft || at->hidden) continue;
            if (count++ == 0) first = at;
            keep_pair(r, at, AXIS_X);
        }
        if (count == 1) keep_pair(r, first, AXIS_TILT_X);
    }
}

static void find_kept(reducing *r, const element *elements, size_t count) {
    for (size_t d = 0; d < r->of->degrees; d++) r->kept[d] = true;
    for (size_t s = 0; s < r->of->station_count; s++) {
        const assembly_station *at = &r->of->stations[s];
        if (at->shaft == NO_SHAFT || !r->mesh->shafts[at->shaft].reduced) continue;
        for (axis along = AXIS_X; along <= AXIS_TILT_Y; along++) r->kept[at->coordinate[along]] = false;
    }
    keep_ports(r, elements, count);
    keep_stations(r);
}

static whirl_status number_kept(reducing *r) {
    for (size_t d = 0; d < r->of->degrees; d++) {
        if (!r->kept[d]) continue;
        if (!blend_reserve(&r->old[d], 1)) return reduction_no_memory();
        r->old[d].of[0] = r->degrees;
        r->old[d].weight[0] = 1.0;
        r->inertia[r->degrees] = r->of->inertia[d];
        r->unit[r->degrees++] = r->of->unit[d];
    }
    return whirl_ok();
}

// ---------------------------------------------------------------- one shaft

static bool is_mean_stiffness(const body_term *term) {
    return body_compare_kinds(term->kind, (body_kind){BODY_PLACE, RATE_STATIC, BODY_STEADY}) == 0;
}

size_t reduction_nodes(const mesh *from, const assembly *of, size_t shaft, size_t *coordinate) {
    size_t n = 0;
    for (size_t i = 0; i < from->node_count; i++) {
        if (from->nodes[i].shaft != shaft) continue;
        const size_t *at = of->stations[from->nodes[i].station].coordinate;
        if (at[AXIS_X] != NO_COORDINATE) coordinate[n++] = at[AXIS_X];
        if (at[AXIS_TILT_X] != NO_COORDINATE) coordinate[n++] = at[AXIS_TILT_X];
    }
    return n;
}

void reduction_matrices(const assembly *of, size_t count, const size_t *coordinate, double *stiffness, double *mass) {
    const size_t n = count;
    size_t local[AXES * WHIRL_MAX_STATIONS];
    for (size_t d = 0; d < of->degrees; d++) local[d] = NO_COORDINATE;
    for (size_t i = 0; i < n; i++) local[coordinate[i]] = i;
    memset(stiffness, 0, n * n * sizeof *stiffness);
    memset(mass, 0, n * n * sizeof *mass);
    for (size_t i = 0; i < n; i++) mass[i * n + i] = of->inertia[coordinate[i]];
    for (size_t k = 0; k < of->body.count; k++) {
        const body_term *term = &of->body.terms[k];
        if (!is_mean_stiffness(term) || local[term->row] == NO_COORDINATE || local[term->column] == NO_COORDINATE)
            continue;
        stiffness[local[term->row] * n + local[term->column]] -= term->number;
    }
    for (size_t k = 0; k < of->mass_count; k++) {
        const mass_term *term = &of->masses[k];
        const size_t i = local[term->row], j = local[term->by];
        if (i == NO_COORDINATE || j == NO_COORDINATE) continue;
        mass[i * n + j] += term->mass;
        if (i != j) mass[j * n + i] += term->mass;
    }
}

/// Matrices of a plane, split by kept (b) and eliminated (i) coordinates.
typedef struct split {
    size_t n, kept, inner, modes;
    size_t *coordinate, *b, *i; ///< [n] coordinates of the assembly; [kept], [inner] indices in these
    double *stiffness, *mass;   ///< [n][n]
    double *k, *m;              ///< [inner][inner]
    double *squares, *shapes;   ///< [inner] w^2; [inner][inner] a mode in each row
    double *follow;             ///< [kept][inner] Psi, then Psi with the shift of the modal coordinates
    double *block;              ///< all of these numbers
} split;

static bool split_allocate(split *s, size_t nodes) {
    const size_t n = 2 * nodes;
    s->n = n;
    s->coordinate = calloc(3 * n + 1, sizeof *s->coordinate);
    s->block = calloc(6 * n * n + n + 1, sizeof *s->block);
    if (!s->coordinate || !s->block) return false;
    s->b = s->coordinate + n;
    s->i = s->b + n;
    s->stiffness = s->block;
    s->mass = s->stiffness + n * n;
    s->k = s->mass + n * n;
    s->m = s->k + n * n;
    s->shapes = s->m + n * n;
    s->follow = s->shapes + n * n;
    s->squares = s->follow + n * n;
    return true;
}

static void split_clear(split *s) {
    free(s->coordinate);
    free(s->block);
}

static void take_inner(split *s) {
    for (size_t a = 0; a < s->inner; a++)
        for (size_t c = 0; c < s->inner; c++) {
            s->k[a * s->inner + c] = s->stiffness[s->i[a] * s->n + s->i[c]];
            s->m[a * s->inner + c] = s->mass[s->i[a] * s->n + s->i[c]];
        }
}

static bool solve_modes(const inner_modes *of) {
    if (!matrix_symmetric_modes(of->inner, of->k, of->m, of->squares, of->shapes)) return false;
    if (of->inner > 0 && !(of->squares[0] > 0.0)) return false;
    return matrix_solve(of->inner, of->k, of->kept, of->follow);
}

/// Finds the modes of the eliminated coordinates, and Psi.
static bool find_modes(split *s) {
    const inner_modes all = {s->inner, s->kept, s->k, s->m, s->follow, s->squares, s->shapes};
    take_inner(s);
    for (size_t c = 0; c < s->kept; c++)
        for (size_t a = 0; a < s->inner; a++) s->follow[c * s->inner + a] = -s->stiffness[s->i[a] * s->n + s->b[c]];
    if (inner_modes_recall(&all)) return true;
    double *begun = inner_modes_begin(&all);
    const bool solved = solve_modes(&all);
    if (solved)
        inner_modes_keep(&all, begun);
    else
        free(begun);
    return solved;
}

/// Scales a mode to a largest coordinate of one length scale. A tilt counts as its displacement at the radius of
/// gyration.
static void scale_mode(const assembly *of, const split *s, double *shape) {
    double largest = 0.0;
    for (size_t a = 0; a < s->inner; a++) {
        const double moved = shape[a] * of->length / of->unit[s->coordinate[s->i[a]]];
        if (fabs(moved) > fabs(largest)) largest = moved;
    }
    for (size_t a = 0; a < s->inner; a++) shape[a] /= largest;
}

/// Computes shape' (M_II Psi + M_IB) of one column.
static double mass_beside(const split *s, const double *psi, const double *shape, size_t column) {
    double sum = 0.0;
    for (size_t a = 0; a < s->inner; a++) {
        double row = s->mass[s->i[a] * s->n + s->b[column]];
        for (size_t c = 0; c < s->inner; c++) row += s->mass[s->i[a] * s->n + s->i[c]] * psi[column * s->inner + c];
        sum += shape[a] * row;
    }
    return sum;
}

static double modal_mass(const split *s, const double *shape) {
    double sum = 0.0;
    for (size_t a = 0; a < s->inner; a++)
        for (size_t c = 0; c < s->inner; c++) sum += shape[a] * s->mass[s->i[a] * s->n + s->i[c]] * shape[c];
    return sum;
}

/// Adds the new coordinates of a shaft's modes, x and y of each, and expresses its nodes by the new coordinates.
static bool blend_nodes(reducing *r, split *s) {
    const size_t first = r->degrees;
    double *psi = s->k; // the matrix is no longer needed
    memcpy(psi, s->follow, s->inner * s->kept * sizeof *psi);
    for (size_t k = 0; k < s->modes; k++) {
        double *shape = s->shapes + k * s->inner;
        scale_mode(r->of, s, shape);
        const double mass = modal_mass(s, shape);
        for (int plane = 0; plane < 2; plane++) {
            r->inertia[r->degrees] = mass;
            r->unit[r->degrees++] = r->of->length;
        }
        for (size_t c = 0; c < s->kept; c++) {
            const double shift = mass_beside(s, psi, shape, c) / mass;
            for (size_t a = 0; a < s->inner; a++) s->follow[c * s->inner + a] -= shape[a] * shift;
        }
    }
    for (size_t a = 0; a < s->inner; a++)
        for (size_t plane = 0; plane < 2; plane++) {
            // The coordinate along y follows that along x, both for displacements and for tilts.
            blend *own = &r->old[s->coordinate[s->i[a]] + plane];
            if (!blend_reserve(own, s->kept + s->modes)) return false;
            for (size_t c = 0; c < s->kept; c++) {
                own->of[c] = r->old[s->coordinate[s->b[c]] + plane].of[0];
                own->weight[c] = s->follow[c * s->inner + a];
            }
            for (size_t k = 0; k < s->modes; k++) {
                own->of[s->kept + k] = first + 2 * k + plane;
                own->weight[s->kept + k] = s->shapes[k * s->inner + a];
            }
        }
    return true;
}

static size_t count_modes(const split *s, const shaft_settings *shaft) {
    size_t count = 0;
    if (shaft->modes_to == 0.0) return shaft->modes < s->inner ? shaft->modes : s->inner;
    while (count < s->inner && sqrt(s->squares[count]) <= 6.283185307179586476925 * shaft->modes_to) count++;
    return count;
}

static whirl_status reduce_shaft(reducing *r, size_t shaft, reduction *out) {
    size_t nodes = 0;
    split s = {0};
    for (size_t i = 0; i < r->mesh->node_count; i++) nodes += r->mesh->nodes[i].shaft == shaft;
    whirl_status status = split_allocate(&s, nodes) ? whirl_ok() : reduction_no_memory();
    // Split the matrices of a plane by kept and eliminated coordinates, and find the modes of the latter.
    if (status.code == WHIRL_OK) {
        reduction_nodes(r->mesh, r->of, shaft, s.coordinate);
        reduction_matrices(r->of, s.n, s.coordinate, s.stiffness, s.mass);
        for (size_t d = 0; d < s.n; d++) {
            if (r->kept[s.coordinate[d]])
                s.b[s.kept++] = d;
            else
                s.i[s.inner++] = d;
        }
        if (!find_modes(&s))
            status = whirl_fail(WHIRL_BAD_INPUT, "shaft %zu gives way between its stations: its axial force buckles it",
                                shaft + 1);
    }
    // Make new coordinates from the kept modes.
    if (status.code == WHIRL_OK) {
        s.modes = count_modes(&s, &r->mesh->shafts[shaft]);
        *out = (reduction){s.modes, s.inner, s.modes > 0 ? sqrt(s.squares[s.modes - 1]) : 0.0, r->degrees};
        if (!blend_nodes(r, &s)) status = reduction_no_memory();
    }
    split_clear(&s);
    return status;
}

// ---------------------------------------------------------------- all that is linear

/// Adds `number`, which is at a row and a column, to the matrix of the new coordinates.
static void spread_over(const blend *row, const blend *column, double number, size_t degrees, double *out) {
    for (size_t a = 0; a < row->count; a++)
        for (size_t c = 0; c < column->count; c++)
            out[row->of[a] * degrees + column->of[c]] += row->weight[a] * column->weight[c] * number;
}

/// Returns true if a number is the remainder of sums that cancel: it is negligible against the largest numbers of its
/// row and of its column.
static bool is_rounding(double number, double row, double column) {
    return fabs(number) <= 2e-12 * sqrt(row * column);
}

static void find_largest(const double *matrix, size_t n, double *largest) {
    for (size_t i = 0; i < n; i++) {
        largest[i] = 0.0;
        for (size_t j = 0; j < n; j++)
            largest[i] = fmax(largest[i], fmax(fabs(matrix[i * n + j]), fabs(matrix[j * n + i])));
    }
}

/// Transforms the terms of one kind, and sets `done` [count] for them.
static void reduce_kind(const reducing *r, const body *old, body_kind kind, bool *done, double *matrix,
                        double *largest) {
    const size_t n = r->degrees;
    size_t zero = 0;
    double whole = 1.0;
    const blend one = {1, &zero, &whole};
    memset(matrix, 0, n * n * sizeof *matrix);
    for (size_t k = 0; k < old->count; k++) {
        const body_term *term = &old->terms[k];
        if (done[k] || body_compare_kinds(term->kind, kind) != 0) continue;
        done[k] = true;
        spread_over(&r->old[term->row], kind.source == BODY_ONE ? &one : &r->old[term->column], term->number, n,
                    matrix);
    }
    find_largest(matrix, n, largest);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++)
            if (kind.source == BODY_ONE || !is_rounding(matrix[i * n + j], largest[i], largest[j]))
                body_add(&r->of->body, i, j, kind, matrix[i * n + j]);
}

static void reduce_body(reducing *r, double *matrix, double *largest) {
    body old = r->of->body;
    bool *done = calloc(old.count + 1, sizeof *done);
    r->of->body = (body){.no_memory = !done};
    for (size_t i = 0; i < old.count && done; i++)
        if (!done[i]) reduce_kind(r, &old, old.terms[i].kind, done, matrix, largest);
    r->of->body.no_memory = r->of->body.no_memory || old.no_memory;
    free(done);
    body_clear(&old);
}

/// Transforms the mass matrix without the own inertia of the kept coordinates. Modal coordinates have no such terms.
static void reduce_masses(reducing *r, double *matrix) {
    assembly *of = r->of;
    const size_t n = r->degrees, count = of->mass_count;
    memset(matrix, 0, n * n * sizeof *matrix);
    size_t kept = 0;
    for (size_t d = 0; d < of->degrees; d++) kept += r->kept[d];
    for (size_t d = 0; d < of->degrees; d++)
        if (!r->kept[d]) spread_over(&r->old[d], &r->old[d], of->inertia[d], n, matrix);
    for (size_t i = 0; i < count; i++) {
        const mass_term *term = &of->masses[i];
        spread_over(&r->old[term->row], &r->old[term->by], term->mass, n, matrix);
        if (term->row != term->by) spread_over(&r->old[term->by], &r->old[term->row], term->mass, n, matrix);
    }
    of->mass_count = 0;
    for (size_t i = 0; i < kept; i++)
        for (size_t j = i; j < kept; j++) assembly_inertance(of, i, j, 0.5 * (matrix[i * n + j] + matrix[j * n + i]));
}

/// Rescales terms of accelerations from the former inertia and unit to the new ones.
static void reduce_terms(reducing *r) {
    assembly *of = r->of;
    const size_t count = of->term_count;
    linear_term *old = of->terms;
    of->terms = NULL;
    of->term_count = of->term_capacity = 0;
    for (size_t t = 0; t < count; t++) {
        const linear_term *term = &old[t];
        const bool by_place = term->source == SOURCE_PLACE || term->source == SOURCE_VELOCITY;
        const blend *row = &r->old[term->row], *column = by_place ? &r->old[term->column] : NULL;
        const double force =
            term->number * of->inertia[term->row] * of->unit[term->row] / (by_place ? of->unit[term->column] : 1.0);
        for (size_t a = 0; a < row->count; a++)
            for (size_t c = 0; c < (column ? column->count : 1); c++) {
                const size_t i = row->of[a], j = column ? column->of[c] : term->column;
                const double by = column ? column->weight[c] * r->unit[j] : 1.0;
                assembly_term(
                    of, (linear_term){i, term->source, j, row->weight[a] * force * by / (r->inertia[i] * r->unit[i])});
            }
    }
    free(old);
}

/// Transforms loads [*count] of rows in the way of forces: the inertia that turns with the shaft, or the weights.
/// Returns false without memory.
static bool reduce_loads(const reducing *r, turning_inertia **loads, size_t *count, size_t *capacity) {
    size_t made = 0;
    for (size_t t = 0; t < *count; t++) made += r->old[(*loads)[t].row].count;
    turning_inertia *reduced = calloc(made + 1, sizeof *reduced), *next = reduced;
    if (!reduced) return false;
    for (size_t t = 0; t < *count; t++) {
        const turning_inertia *old = &(*loads)[t];
        const blend *row = &r->old[old->row];
        for (size_t a = 0; a < row->count; a++)
            *next++ = (turning_inertia){row->of[a], row->weight[a] * old->cos, row->weight[a] * old->sin};
    }
    free(*loads);
    *loads = reduced;
    *count = *capacity = made;
    return true;
}

static size_t renamed(const reducing *r, size_t coordinate) {
    if (coordinate == NO_COORDINATE || !r->kept[coordinate]) return NO_COORDINATE;
    return r->old[coordinate].of[0];
}

static void rename_all(reducing *r, element *elements, size_t count) {
    if (r->of->twist_count > 0) r->of->first_twist = renamed(r, r->of->first_twist);
    if (r->of->axial_count > 0) r->of->first_axial = renamed(r, r->of->first_axial);
    for (size_t s = 0; s < r->of->station_count; s++)
        for (axis along = AXIS_X; along < AXES; along++)
            r->of->stations[s].coordinate[along] = renamed(r, r->of->stations[s].coordinate[along]);
    for (size_t i = 0; i < r->of->link_count; i++)
        for (size_t end = 0; end < 2; end++)
            r->of->links[i].coordinate[end] = renamed(r, r->of->links[i].coordinate[end]);
    for (size_t i = 0; i < r->of->hold_count; i++)
        r->of->holds[i].coordinate[0] = renamed(r, r->of->holds[i].coordinate[0]);
    for (size_t i = 0; i < count; i++)
        for (size_t p = 0; p < MAX_PORTS; p++) elements[i].port[p] = renamed(r, elements[i].port[p]);
}

// ---------------------------------------------------------------- all

static bool wants_reduction(const mesh *from) {
    bool any = false;
    for (size_t s = 0; s < from->shaft_count; s++) any = any || from->shafts[s].reduced;
    return any;
}

static whirl_status reduce_shafts(reducing *r, reduction *out) {
    whirl_status status = number_kept(r);
    for (size_t shaft = 0; shaft < r->mesh->shaft_count && status.code == WHIRL_OK; shaft++)
        if (r->mesh->shafts[shaft].reduced) status = reduce_shaft(r, shaft, &out[shaft]);
    return status;
}

static whirl_status reduce(reducing *r, element *elements, size_t element_count, reduction *out) {
    const size_t old_degrees = r->of->degrees;
    find_kept(r, elements, element_count);
    const whirl_status status = reduce_shafts(r, out);
    if (status.code != WHIRL_OK) return status;
    double *matrix = calloc(r->degrees * r->degrees + r->degrees + 1, sizeof *matrix);
    if (!matrix) return reduction_no_memory();
    reduce_body(r, matrix, matrix + r->degrees * r->degrees);
    reduce_masses(r, matrix);
    reduce_terms(r);
    assembly *of = r->of;
    if (!reduce_loads(r, &of->turnings, &of->turning_count, &of->turning_capacity) ||
        !reduce_loads(r, &of->weights, &of->weight_count, &of->weight_capacity))
        of->no_memory = true;
    rename_all(r, elements, element_count);
    memcpy(r->of->inertia, r->inertia, r->degrees * sizeof *r->inertia);
    memcpy(r->of->unit, r->unit, r->degrees * sizeof *r->unit);
    r->of->degrees = r->degrees;
    for (size_t i = 0; i < element_count; i++) elements[i].state -= old_degrees - r->degrees;
    free(matrix);
    return status;
}

/// Writes the old coordinates [old_degrees] as sums of the new ones.
static whirl_status note_blends(const reducing *r, size_t old_degrees, double **follow) {
    *follow = calloc(old_degrees * r->degrees + 1, sizeof **follow);
    if (!*follow) return reduction_no_memory();
    for (size_t d = 0; d < old_degrees; d++)
        for (size_t k = 0; k < r->old[d].count; k++) (*follow)[d * r->degrees + r->old[d].of[k]] = r->old[d].weight[k];
    return whirl_ok();
}

whirl_status reduction_make(const mesh *from, assembly *of, element *elements, size_t element_count, reduction *out,
                            double **follow) {
    const size_t degrees = of->degrees;
    reduction ignored[WHIRL_MAX_SHAFTS];
    if (!wants_reduction(from) || of->no_memory || of->body.no_memory) return whirl_ok();
    reducing r = {.mesh = from, .of = of};
    r.kept = calloc(degrees + 1, sizeof *r.kept);
    r.old = calloc(degrees + 1, sizeof *r.old);
    r.inertia = calloc(2 * degrees + 1, sizeof *r.inertia);
    r.unit = r.inertia + degrees;
    whirl_status status =
        r.kept && r.old && r.inertia ? reduce(&r, elements, element_count, out ? out : ignored) : reduction_no_memory();
    if (status.code == WHIRL_OK && follow) status = note_blends(&r, degrees, follow);
    for (size_t d = 0; d < degrees && r.old; d++) {
        free(r.old[d].of);
        free(r.old[d].weight);
    }
    free(r.kept);
    free(r.old);
    free(r.inertia);
    return status;
}
