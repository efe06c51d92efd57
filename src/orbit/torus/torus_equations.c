#include "torus_equations.h"
#include "harmonics.h"
#include "section_map.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void torus_equations_release(whirl_machine *machine) {
    if (machine->release) machine->release(machine->owner);
    *machine = (whirl_machine){.system = NULL};
}

/// Makes the map of the family's machine at a value.
static whirl_status map_at(const torus_equations *e, double value, whirl_machine *machine, section_map **map) {
    *machine = (whirl_machine){.system = NULL};
    *map = NULL;
    whirl_status status = e->family->machine(e->family->context, value, machine);
    if (status.code == WHIRL_OK) status = section_map_new(machine->system, &e->options->integrate, e->revolutions, map);
    if (status.code == WHIRL_OK && e->map && (*map)->dimension != e->map->dimension)
        status = whirl_fail(WHIRL_BAD_INPUT, "machines of a family differ in their coordinates");
    if (status.code == WHIRL_OK && e->map) memcpy((*map)->rest, e->map->rest, e->map->dimension * sizeof *e->map->rest);
    if (status.code == WHIRL_OK) return status;
    section_map_free(*map);
    *map = NULL;
    torus_equations_release(machine);
    return status;
}

whirl_status torus_equations_make(torus_equations *e, const whirl_system *system, const whirl_family *family,
                                  double value, const whirl_torus_options *options, size_t revolutions,
                                  size_t dimension, const double *at) {
    *e = (torus_equations){.options = options, .family = family, .value = value, .revolutions = revolutions};
    const whirl_status status = family ? map_at(e, value, &e->machine, &e->map)
                                       : section_map_new(system, &options->integrate, revolutions, &e->map);
    if (status.code != WHIRL_OK) return status;
    if (dimension != e->map->dimension)
        return whirl_fail(WHIRL_BAD_INPUT, "a state of %zu coordinates, expected %zu of the machine", dimension,
                          e->map->dimension);
    e->n = e->map->count;
    memcpy(e->map->rest, at, e->map->dimension * sizeof *at);
    return status;
}

void torus_equations_free(torus_equations *e) {
    section_map_free(e->map);
    torus_equations_release(&e->machine);
    free(e->images);
    e->map = NULL;
    e->images = NULL;
}

bool torus_equations_resize(torus_equations *e, size_t count) {
    const size_t size = count * e->n;
    free(e->images);
    e->count = count;
    e->images = calloc(6 * size + size * e->n + 2 * count + 1, sizeof *e->images);
    if (!e->images) return false;
    e->along = e->images + size;
    e->series = e->along + size;
    e->workspace = e->series + size;
    e->matrices = e->workspace + 3 * size;
    e->weights = e->matrices + size * e->n;
    e->slopes = e->weights + count;
    return true;
}

size_t torus_equations_count(const torus_equations *e) {
    return e->count * e->n + 1;
}

size_t torus_equations_unknowns(const torus_equations *e) {
    return torus_equations_count(e) + (e->family != NULL);
}

void torus_equations_refer(torus_equations *e, const double *u) {
    harmonics_of(e->count, e->n, u, e->series);
    // The values go to `workspace`, which is unused here; only the slopes are needed.
    harmonics_spread(e->count, e->n, e->series, 0.0, e->count, e->workspace, e->along);
}

double torus_equations_reach(const torus_equations *e, const double *u) {
    double size = 0.0;
    for (size_t i = 0; i < e->count * e->n; i++) size = fmax(size, fabs(u[i]));
    return size;
}

double torus_equations_radius(const torus_equations *e, const double *u) {
    double radius = 0.0;
    for (size_t i = 0; i < e->n; i++) {
        double mean = 0.0;
        for (size_t j = 0; j < e->count; j++) mean += u[j * e->n + i] / (double)e->count;
        for (size_t j = 0; j < e->count; j++) radius = fmax(radius, fabs(u[j * e->n + i] - mean));
    }
    return radius;
}

void torus_equations_scale(const torus_equations *e, const double *u, double span, double *scale) {
    const size_t nodes = e->count * e->n;
    const double size = torus_equations_reach(e, u);
    for (size_t i = 0; i < nodes; i++) scale[i] = (size > 0.0 ? size : 1.0) * sqrt((double)e->count);
    scale[nodes] = 1.0;
    if (e->family) scale[nodes + 1] = span;
}

// ---------------------------------------------------------------- another machine

/// Replaces the present machine by the one at another value.
static bool turn_to(torus_equations *e, double value) {
    whirl_machine machine;
    section_map *map;
    if (value == e->value) return true;
    if (map_at(e, value, &machine, &map).code != WHIRL_OK) return false;
    section_map_free(e->map);
    torus_equations_release(&e->machine);
    e->map = map;
    e->machine = machine;
    e->value = value;
    return true;
}

static bool images_at(torus_equations *e, double value, const double *u, double *images) {
    whirl_machine machine;
    section_map *map;
    if (map_at(e, value, &machine, &map).code != WHIRL_OK) return false;
    const bool good = section_map_carry(map, e->count, u, images, NULL, NULL);
    section_map_free(map);
    torus_equations_release(&machine);
    return good;
}

/// Computes the derivative of the images by the parameter, by central differences. The error of a difference is of the
/// order of the square of its step, 2^-12 of the span. So small an error costs Newton's method no step, and does not
/// move its zeros.
static bool by_parameter(torus_equations *e, const double *u) {
    const size_t size = e->count * e->n;
    double *above = e->workspace, *below = above + size;
    if (!images_at(e, e->value + e->reach, u, above) || !images_at(e, e->value - e->reach, u, below)) return false;
    for (size_t i = 0; i < size; i++) above[i] = (above[i] - below[i]) / (2.0 * e->reach);
    return true;
}

// ---------------------------------------------------------------- values and derivatives

/// Returns the index of node k's weight in the curve at theta_j + angle.
static size_t torus_equations_place(const torus_equations *e, size_t j, size_t k) {
    return (k + e->count - j) % e->count;
}

static void write_values(const torus_equations *e, const double *u, double *value) {
    const size_t n = e->n, size = e->count * n;
    double square = 0.0, shift = 0.0;
    memcpy(value, e->images, size * sizeof *value);
    for (size_t j = 0; j < e->count; j++)
        for (size_t k = 0; k < e->count; k++)
            for (size_t i = 0; i < n; i++)
                value[j * n + i] -= e->weights[torus_equations_place(e, j, k)] * u[k * n + i];
    for (size_t i = 0; i < size; i++) {
        square += e->along[i] * e->along[i];
        shift += e->along[i] * u[i];
    }
    value[size] = shift / square;
}

static void write_by_nodes(const torus_equations *e, size_t columns, double *out) {
    const size_t n = e->n, size = e->count * n;
    double square = 0.0;
    for (size_t j = 0; j < e->count; j++)
        for (size_t i = 0; i < n; i++) {
            double *row = out + (j * n + i) * columns;
            for (size_t k = 0; k < e->count; k++) row[k * n + i] = -e->weights[torus_equations_place(e, j, k)];
            for (size_t k = 0; k < n; k++) row[j * n + k] += e->matrices[(j * n + i) * n + k];
        }
    for (size_t i = 0; i < size; i++) square += e->along[i] * e->along[i];
    for (size_t i = 0; i < size; i++) out[size * columns + i] = e->along[i] / square;
}

static void write_by_angle(const torus_equations *e, const double *u, size_t columns, double *out) {
    const size_t n = e->n, size = e->count * n;
    for (size_t j = 0; j < e->count; j++)
        for (size_t k = 0; k < e->count; k++)
            for (size_t i = 0; i < n; i++)
                out[(j * n + i) * columns + size] -= e->slopes[torus_equations_place(e, j, k)] * u[k * n + i];
}

bool torus_equations_evaluate(void *context, const double *u, double *value, double *derivative) {
    torus_equations *e = context;
    const size_t size = e->count * e->n, columns = torus_equations_unknowns(e);
    if (!isfinite(u[size]) || (e->family && !turn_to(e, u[columns - 1]))) return false;
    if (!section_map_carry(e->map, e->count, u, e->images, derivative ? e->matrices : NULL, &e->volume)) return false;
    harmonics_weights(e->count, u[size], e->weights, e->slopes);
    write_values(e, u, value);
    if (!derivative) return true;
    memset(derivative, 0, (size + 1) * columns * sizeof *derivative);
    write_by_nodes(e, columns, derivative);
    write_by_angle(e, u, columns, derivative);
    if (!e->family) return true;
    if (!by_parameter(e, u)) return false;
    for (size_t i = 0; i < size; i++) derivative[(i + 1) * columns - 1] = e->workspace[i];
    return true;
}

double torus_equations_size(void *context, const double *u, const double *value) {
    const torus_equations *e = context;
    const double size = torus_equations_reach(e, u);
    double largest = 0.0;
    for (size_t i = 0; i < e->count * e->n; i++) largest = fmax(largest, fabs(value[i]));
    return size > 0.0 ? largest / size : largest;
}
