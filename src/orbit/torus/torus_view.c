// The view of a torus: the bounds of its motion and of its sections, and the strongest line of its second frequency in
// every coordinate.
//
// T is the time of k revolutions, and phi = theta + 2 pi rho t/T. The motions that begin at all angles theta are one
// function of phi and t, which repeats after a turn of phi and after T. Its harmonic exp(i phi) has lines at (rho +
// i)/T for whole numbers i.
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harmonics.h"
#include "turns.h"
#include "two_pi.h"
#include "whirl/engine/torus.h"

typedef double complex number;

enum { INSTANTS = 64, MIN_ANGLES = 128 };

/// Motions that begin at the nodes, at equally spaced instants of all revolutions. At each instant they lie on a closed
/// curve with as many harmonics as that of the nodes.
typedef struct grid {
    size_t dimension, nodes, instants, angles;
    double *states;   ///< [instants][nodes][dimension]; instant m is at (m + 1) T/instants
    size_t seen;      ///< states that were stored
    double *series;   ///< [nodes][dimension] scratch
    double *curve;    ///< [angles][dimension] scratch: the closed curve of an instant
    double *low;      ///< [instants][dimension] its bounds
    double *high;     ///< [instants][dimension]
    number *harmonic; ///< [instants][dimension] its first harmonic exp(i phi)
    number *turn;     ///< [2][instants] scratch
} grid;

static void put_state(void *context, double t, const double *x) {
    grid *g = context;
    const size_t node = g->seen / g->instants, instant = g->seen % g->instants;
    (void)t;
    memcpy(g->states + (instant * g->nodes + node) * g->dimension, x, g->dimension * sizeof *x);
    g->seen++;
}

// ---------------------------------------------------------------- bounds

/// Returns the largest (sign 1) or the smallest (sign -1) of values that lie around a cycle, `stride` apart, by the
/// parabola through it and its neighbours.
static double peak_of(const double *values, size_t count, size_t stride, double sign) {
    size_t at = 0;
    if (count == 0) return NAN;
    for (size_t j = 1; j < count; j++)
        if (sign * values[j * stride] > sign * values[at * stride]) at = j;
    const double top = values[at * stride], before = values[(at + count - 1) % count * stride],
                 after = values[(at + 1) % count * stride];
    const double bend = before - 2.0 * top + after, slope = after - before;
    return bend == 0.0 ? top : top - slope * slope / (8.0 * bend);
}

/// Computes the bounds and the first harmonic, (cosine - i sine)/2, of an instant's closed curve.
static void torus_view_look_at(grid *g, size_t instant) {
    const size_t d = g->dimension;
    harmonics_of(g->nodes, d, g->states + instant * g->nodes * d, g->series);
    harmonics_spread(g->nodes, d, g->series, 0.0, g->angles, g->curve, NULL);
    for (size_t i = 0; i < d; i++) {
        g->low[instant * d + i] = peak_of(g->curve + i, g->angles, d, -1.0);
        g->high[instant * d + i] = peak_of(g->curve + i, g->angles, d, 1.0);
        g->harmonic[instant * d + i] = 0.5 * (g->series[d + i] - I * g->series[2 * d + i]);
    }
}

static void find_bounds(const grid *g, size_t coordinate, whirl_torus_view *view) {
    const size_t d = g->dimension;
    view->low[coordinate] = peak_of(g->low + coordinate, g->instants, d, -1.0);
    view->high[coordinate] = peak_of(g->high + coordinate, g->instants, d, 1.0);
    for (size_t k = 0; k < view->revolutions; k++) {
        const size_t instant = (k > 0 ? k : view->revolutions) * INSTANTS - 1;
        view->section_low[k * d + coordinate] = g->low[instant * d + coordinate];
        view->section_high[k * d + coordinate] = g->high[instant * d + coordinate];
    }
}

// ---------------------------------------------------------------- lines

/// Returns the size of a coordinate's line at `whole` + rotation turns in all revolutions. turn[m] = exp(-2 pi i
/// m/instants); slow[m] = exp(-2 pi i rotation (m + 1)/instants).
static double size_at(const grid *g, size_t coordinate, size_t whole, const number *turn, const number *slow) {
    number line = 0.0;
    for (size_t m = 0; m < g->instants; m++)
        line += g->harmonic[m * g->dimension + coordinate] * slow[m] * turn[whole * (m + 1) % g->instants];
    return cabs(line) / (double)g->instants;
}

/// Finds the strongest line. Tries the whole numbers from -instants/2 to instants/2 - 1, since a discrete transform
/// does not distinguish whole numbers that differ by `instants`.
static void find_strongest(const grid *g, size_t coordinate, const whirl_torus *torus, whirl_torus_view *view) {
    const number *turn = g->turn, *slow = turn + g->instants;
    const size_t half = g->instants / 2;
    double largest = -1.0;
    for (size_t i = 0; i < g->instants; i++) {
        const double turns = torus->rotation + (double)i - (double)half;
        const double size = size_at(g, coordinate, (i + half) % g->instants, turn, slow);
        if (size > largest) view->frequency[coordinate] = fabs(turns) / (double)torus->revolutions;
        largest = fmax(largest, size);
    }
    view->amplitude[coordinate] = 2.0 * largest;
}

static void find_turns(const grid *g, double rotation) {
    for (size_t m = 0; m < g->instants; m++) {
        g->turn[m] = cexp(-I * two_pi * (double)m / (double)g->instants);
        g->turn[g->instants + m] = cexp(-I * two_pi * rotation * (double)(m + 1) / (double)g->instants);
    }
}

// ---------------------------------------------------------------- a view

static whirl_torus_view *torus_view_allocate(const whirl_torus *torus) {
    const size_t d = torus->dimension, sections = torus->revolutions * d;
    whirl_torus_view *view = calloc(1, sizeof *view + (4 * d + 2 * sections) * sizeof(double));
    if (!view) return NULL;
    *view = (whirl_torus_view){.dimension = d, .revolutions = torus->revolutions, .low = (double *)(view + 1)};
    view->high = view->low + d;
    view->frequency = view->high + d;
    view->amplitude = view->frequency + d;
    view->section_low = view->amplitude + d;
    view->section_high = view->section_low + sections;
    for (size_t i = 0; i < 4 * d + 2 * sections; i++) view->low[i] = NAN;
    return view;
}

void whirl_torus_view_free(whirl_torus_view *view) {
    free(view);
}

static bool grid_new(const whirl_torus *torus, grid *g) {
    const size_t d = torus->dimension;
    *g = (grid){.dimension = d,
                .nodes = torus->node_count,
                .instants = INSTANTS * torus->revolutions,
                .angles = torus->node_count > MIN_ANGLES ? torus->node_count : MIN_ANGLES};
    g->states = calloc((g->instants + 1) * g->nodes * d + (g->angles + 2 * g->instants) * d + 1, sizeof *g->states);
    g->harmonic = calloc(g->instants * (d + 2) + 1, sizeof *g->harmonic);
    if (!g->states || !g->harmonic) return false;
    g->series = g->states + g->instants * g->nodes * d;
    g->curve = g->series + g->nodes * d;
    g->low = g->curve + g->angles * d;
    g->high = g->low + g->instants * d;
    g->turn = g->harmonic + g->instants * d;
    return true;
}

static whirl_status torus_view_look(const whirl_system *system, const whirl_torus *torus,
                                    const whirl_torus_options *options, grid *g, whirl_torus_view *view) {
    const whirl_status status = whirl_torus_observe(system, torus, options, g->nodes, INSTANTS, put_state, g);
    if (status.code != WHIRL_OK) return status;
    for (size_t m = 0; m < g->instants; m++) torus_view_look_at(g, m);
    find_turns(g, torus->rotation);
    for (size_t i = 0; i < g->dimension; i++) {
        if (turns_on(system->turns, i)) continue;
        find_bounds(g, i, view);
        find_strongest(g, i, torus, view);
    }
    return status;
}

whirl_status whirl_torus_look(const whirl_system *system, const whirl_torus *torus, const whirl_torus_options *options,
                              whirl_torus_view **out) {
    grid g;
    whirl_torus_view *view = torus_view_allocate(torus);
    whirl_status status = grid_new(torus, &g) && view ? torus_view_look(system, torus, options, &g, view)
                                                      : whirl_fail(WHIRL_NO_MEMORY, "no memory for a view of a torus");
    free(g.states);
    free(g.harmonic);
    *out = status.code == WHIRL_OK ? view : NULL;
    if (status.code != WHIRL_OK) whirl_torus_view_free(view);
    return status;
}

whirl_status whirl_torus_line(const whirl_system *system, const whirl_torus *torus, const whirl_torus_options *options,
                              size_t coordinate, double *frequency, double *amplitude) {
    whirl_torus_view *view = NULL;
    *frequency = *amplitude = NAN;
    if (coordinate >= system->dimension || turns_on(system->turns, coordinate))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "a line of coordinate %zu, expected one below %zu that is no angle of a turning part",
                          coordinate, system->dimension);
    const whirl_status status = whirl_torus_look(system, torus, options, &view);
    if (status.code != WHIRL_OK) return status;
    *frequency = view->frequency[coordinate];
    *amplitude = view->amplitude[coordinate];
    whirl_torus_view_free(view);
    return status;
}
