#include "reynolds.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "turbulence.h"

/// MIN_AROUND, MIN_ALONG: finest grid that needs no coarser first guess. MAX_PASSES: most passes; the cavity changes by
/// few volumes in a pass.
enum { MIN_AROUND = 24, MIN_ALONG = 3, MAX_PASSES = 200 };

struct pad_workspace {
    int around, along;   ///< capacity
    double *band;        ///< [(around - 1) along][along + 1] lower half of the matrix, row by row of the diagonal
    double *pressure;    ///< [(around - 1) along]
    double *source;      ///< [(around - 1) along] right-hand side
    double *cubes;       ///< [2][around + 2] of the film's thickness, at nodes and between them
    double *edge;        ///< [along] pressure at the leading and the trailing edge of the pad
    unsigned char *rest; ///< [(around - 1) along] 1 in the cavity
    unsigned char *coarse;
};

/// A grid of nodes: `around` - 1 inside the pad by `along` from the middle on. Each has a volume around it.
typedef struct grid {
    int around, along;
    double step, rise;     ///< steps of p and zeta
    double first;          ///< p of the edge
    const double *middle;  ///< [around + 1] H^3 at nodes, for the flow along the axis
    const double *between; ///< [around] H^3 between node i and i + 1, for the flow around
    const double *edge;    ///< [along] P at nodes 0 and `around`
} grid;

static size_t unknowns(int around, int along) {
    return (size_t)(around - 1) * (size_t)along;
}

void pad_workspace_free(pad_workspace *work) {
    if (!work) return;
    free(work->band);
    free(work->pressure);
    free(work->source);
    free(work->cubes);
    free(work->edge);
    free(work->rest);
    free(work->coarse);
    free(work);
}

whirl_status pad_workspace_new(int around, int along, pad_workspace **out) {
    const size_t count = unknowns(around, along);
    pad_workspace *work = calloc(1, sizeof *work);
    *out = work;
    if (work) {
        *work = (pad_workspace){.around = around,
                                .along = along,
                                .band = malloc(count * (size_t)(along + 1) * sizeof(double)),
                                .pressure = malloc(count * sizeof(double)),
                                .source = malloc(count * sizeof(double)),
                                .cubes = malloc(2 * (size_t)(around + 2) * sizeof(double)),
                                .edge = malloc((size_t)along * sizeof(double)),
                                .rest = malloc(count),
                                .coarse = malloc(count)};
        if (work->band && work->pressure && work->source && work->cubes && work->edge && work->rest && work->coarse)
            return whirl_ok();
    }
    pad_workspace_free(work);
    *out = NULL;
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for the film of a pad");
}

static double thickness(const pad_place *at, double p) {
    return 1.0 - at->x * cos(p) - at->y * sin(p);
}

// ---------------------------------------------------------------- one grid

/// Returns the width of the volume of node j along the axis.
static double width(const grid *g, int j) {
    return j == 0 ? 0.5 * g->rise : g->rise;
}

/// Computes the source: - int (A sin p - B cos p) over every volume, plus the flow from the grooves into the
/// neighbouring volumes.
static void fill_source(const grid *g, const pad_place *at, double *source) {
    for (int i = 1; i < g->around; i++) {
        const double west = g->first + (i - 0.5) * g->step, east = west + g->step;
        const double inside = at->b * (sin(east) - sin(west)) - at->a * (cos(west) - cos(east));
        for (int j = 0; j < g->along; j++) source[(i - 1) * g->along + j] = inside * width(g, j);
    }
    double *last = source + (size_t)(g->around - 2) * (size_t)g->along;
    for (int j = 0; j < g->along; j++) {
        source[j] += g->between[0] * width(g, j) / g->step * g->edge[j];
        last[j] += g->between[g->around - 1] * width(g, j) / g->step * g->edge[j];
    }
}

/// Coefficients of node (i, j) with its neighbours: before and after it around the journal (west, east), and towards
/// the middle and the end (in, out).
typedef struct links {
    double west, east, in, out;
} links;

static links links_of(const grid *g, double ratio, int i, int j) {
    const double around = width(g, j) / g->step, along = ratio * g->middle[i] * g->step / g->rise;
    return (links){g->between[i - 1] * around, g->between[i] * around, j > 0 ? along : 0.0, along};
}

/// Fills the matrix: the film's equations outside the cavity, and 1 on the diagonal inside.
static void fill_band(const grid *g, double ratio, const unsigned char *rest, double *band) {
    const int m = g->along, stride = m + 1;
    memset(band, 0, unknowns(g->around, m) * (size_t)stride * sizeof *band);
    for (int i = 1; i < g->around; i++)
        for (int j = 0; j < m; j++) {
            const int k = (i - 1) * m + j;
            double *row = band + (size_t)k * (size_t)stride;
            if (rest[k]) {
                row[0] = 1.0;
                continue;
            }
            const links own = links_of(g, ratio, i, j);
            row[0] = own.west + own.east + own.in + own.out;
            if (j + 1 < m && !rest[k + 1]) row[1] = -own.out;
            if (i + 1 < g->around && !rest[k + m]) row[m] = -own.east;
        }
}

/// Decomposes the matrix to L D L^T, in place.
static void decompose(double *band, size_t count, size_t width_of_band) {
    const size_t stride = width_of_band + 1;
    for (size_t k = 0; k < count; k++) {
        double *row = band + k * stride;
        const size_t most = count - 1 - k < width_of_band ? count - 1 - k : width_of_band;
        const double over = 1.0 / row[0];
        for (size_t i = 1; i <= most; i++) {
            if (row[i] == 0.0) continue;
            const double factor = row[i] * over;
            double *other = band + (k + i) * stride;
            for (size_t j = i; j <= most; j++) other[j - i] -= factor * row[j];
        }
        row[0] = over;
    }
}

/// Solves for one right-hand side x, which becomes the solution.
static void substitute(const double *band, size_t count, size_t width_of_band, double *x) {
    const size_t stride = width_of_band + 1;
    for (size_t k = 0; k < count; k++) {
        const double *row = band + k * stride;
        const size_t most = count - 1 - k < width_of_band ? count - 1 - k : width_of_band;
        const double own = x[k] * row[0];
        for (size_t i = 1; i <= most; i++) x[k + i] -= row[i] * own;
        x[k] = own;
    }
    for (size_t k = count; k-- > 0;) {
        const double *row = band + k * stride;
        const size_t most = count - 1 - k < width_of_band ? count - 1 - k : width_of_band;
        double sum = 0.0;
        for (size_t i = 1; i <= most; i++) sum += row[i] * x[k + i];
        x[k] -= row[0] * sum;
    }
}

/// Returns the flow that the film would press into volume (i, j) of the cavity. If it is positive the volume belongs to
/// the film.
static double surplus(const grid *g, double ratio, const double *source, const double *p, int i, int j) {
    const int m = g->along, k = (i - 1) * m + j;
    const links own = links_of(g, ratio, i, j);
    double sum = source[k];
    if (i > 1) sum += own.west * p[k - m];
    if (i + 1 < g->around) sum += own.east * p[k + m];
    if (j > 0) sum += own.in * p[k - 1];
    if (j + 1 < m) sum += own.out * p[k + 1];
    return sum;
}

/// Moves to the next cavity. Returns the number of volumes that change sides.
static size_t move_cavity(const grid *g, double ratio, const double *source, const double *p, unsigned char *rest) {
    size_t moved = 0;
    for (int i = 1; i < g->around; i++)
        for (int j = 0; j < g->along; j++) {
            const int k = (i - 1) * g->along + j;
            const bool empty = rest[k] ? !(surplus(g, ratio, source, p, i, j) > 0.0) : p[k] < 0.0;
            moved += empty != (bool)rest[k];
            rest[k] = empty;
        }
    return moved;
}

/// Changes the cavity until it is constant (a semismooth Newton method; Hintermueller, Ito, Kunisch 2003).
static whirl_status solve_grid(pad_workspace *work, const grid *g, const pad_film *film, const pad_place *at) {
    const double ratio = 1.0 / (film->ratio * film->ratio);
    const size_t count = unknowns(g->around, g->along);
    fill_source(g, at, work->source);
    for (int pass = 0; pass < MAX_PASSES; pass++) {
        fill_band(g, ratio, work->rest, work->band);
        decompose(work->band, count, (size_t)g->along);
        for (size_t k = 0; k < count; k++) work->pressure[k] = work->rest[k] ? 0.0 : work->source[k];
        substitute(work->band, count, (size_t)g->along, work->pressure);
        if (film->law == CAVITATION_GUMBEL) {
            for (size_t k = 0; k < count; k++) work->pressure[k] = fmax(work->pressure[k], 0.0);
            return whirl_ok();
        }
        if (move_cavity(g, ratio, work->source, work->pressure, work->rest) == 0) return whirl_ok();
    }
    return whirl_fail(WHIRL_NUMERICAL_FAILURE, "the cavity of a pad's film does not settle in %d passes", MAX_PASSES);
}

// ---------------------------------------------------------------- what follows from the pressure

/// Returns the shear of a film, 1/H if laminar.
static double shear_at(const pad_film *film, double h) {
    return turbulent_shear(film->turbulence, film->reynolds * h) / h;
}

/// Returns the shear around the pad at node j. In the cavity it is the shear of streams that together are as wide as
/// the film at its rupture.
static double shear(const grid *g, const pad_film *film, const pad_place *at, const double *p, int j) {
    double broke = thickness(at, g->first), sum = 0.5 * shear_at(film, broke);
    for (int i = 1; i < g->around; i++) {
        const double h = thickness(at, g->first + i * g->step), here = p[(i - 1) * g->along + j];
        if (here > 0.0) broke = h;
        sum += (here > 0.0 ? 1.0 : fmin(1.0, broke / h)) * shear_at(film, h);
    }
    const double last = thickness(at, -g->first);
    return sum + 0.5 * (g->edge[j] > 0.0 ? 1.0 : fmin(1.0, broke / last)) * shear_at(film, last);
}

/// Adds the effect of the pressures [along] from west to east of node i, on the given share of a volume.
static void add_column(const grid *g, const pad_place *at, double ratio, int i, double share, const double *p,
                       pad_answer *out) {
    const double west = g->first + (i - (i > 0 ? 0.5 : 0.0)) * g->step, east = west + share * g->step;
    double sum = 0.0;
    for (int j = 0; j < g->along; j++) {
        sum += p[j] * width(g, j);
        out->highest = fmax(out->highest, p[j]);
    }
    out->force[0] -= 6.0 * sum * (sin(east) - sin(west));
    out->force[1] -= 6.0 * sum * (cos(west) - cos(east));
    // Integrate H dP/dp by parts.
    out->drag -= 3.0 * sum * (at->x * (cos(west) - cos(east)) - at->y * (sin(east) - sin(west)));
    if (i == 0 || i == g->around) out->drag += 3.0 * sum * (i == 0 ? -1.0 : 1.0) * thickness(at, i ? east : west);
    // Compute the slope at the end from the last two nodes, to second order.
    const double slope = (4.0 * p[g->along - 1] - p[g->along - 2]) / (2.0 * g->rise);
    out->leaving += 0.5 * ratio * g->middle[i] * slope * share * g->step;
    out->thinnest = fmin(out->thinnest, thickness(at, g->first + i * g->step));
}

static pad_answer answer_of(const grid *g, const pad_film *film, const pad_place *at, const double *pressure) {
    const double ratio = 1.0 / (film->ratio * film->ratio);
    pad_answer out = {.thinnest = INFINITY};
    for (int i = 1; i < g->around; i++)
        add_column(g, at, ratio, i, 1.0, pressure + (size_t)(i - 1) * (size_t)g->along, &out);
    for (int side = 0; side < 2; side++) add_column(g, at, ratio, side * g->around, 0.5, g->edge, &out);
    // The stream of the last volume continues to the end.
    for (int j = 0; j < g->along; j++)
        out.drag +=
            shear(g, film, at, pressure, j) * g->step * (width(g, j) + (j + 1 == g->along ? 0.5 * g->rise : 0.0));
    return out;
}

static double extrapolate(double fine, double coarse) {
    return fine + (fine - coarse) / 3.0;
}

// ---------------------------------------------------------------- from grid to grid

/// Returns H^3 divided by the factor of turbulence, for flow around or along.
static double conductance(const pad_film *film, const pad_place *at, double p, bool along) {
    const double h = thickness(at, p), cube = pow(h, 3.0);
    if (film->turbulence == WHIRL_LAMINAR) return cube;
    const turbulent_factors by = turbulent_resistance(film->turbulence, film->reynolds * h);
    return cube / (along ? by.along : by.around);
}

static grid grid_of(pad_workspace *work, const pad_film *film, const pad_place *at, int around, int along) {
    double *middle = work->cubes, *between = work->cubes + around + 2;
    const grid g = {around, along, film->arc / around, 1.0 / along, -0.5 * film->arc, middle, between, work->edge};
    for (int i = 0; i <= around; i++) {
        middle[i] = conductance(film, at, g.first + i * g.step, true);
        between[i] = conductance(film, at, g.first + (i + 0.5) * g.step, false);
    }
    for (int j = 0; j < along; j++)
        work->edge[j] =
            film->supply * (film->groove < 1.0 ? fmin(1.0, (1.0 - j * g.rise) / (1.0 - film->groove)) : 1.0);
    return g;
}

/// Copies the cavity of a grid half as fine, as a first guess.
static void refine_cavity(pad_workspace *work, int around, int along) {
    const int half = along / 2, last = around / 2 - 1;
    memcpy(work->coarse, work->rest, unknowns(around / 2, half));
    for (int i = 1; i < around; i++)
        for (int j = 0; j < along; j++) {
            const int from = i / 2 < 1 ? 1 : i / 2 > last ? last : i / 2;
            work->rest[(i - 1) * along + j] = work->coarse[(from - 1) * half + j / 2];
        }
}

/// Returns the least thickness of the film, which may be between nodes.
static double least_thickness(const pad_film *film, const pad_place *at) {
    const double angle = atan2(at->y, at->x), half = 0.5 * film->arc;
    const double least = fmin(thickness(at, -half), thickness(at, half));
    return fabs(angle) < half ? fmin(least, 1.0 - hypot(at->x, at->y)) : least;
}

whirl_status pad_solve(pad_workspace *work, const pad_film *film, const pad_place *place, pad_answer *answer) {
    int levels = 1;
    if (!(least_thickness(film, place) > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "the journal touches the pad: the film's thickness is %.3g clearances",
                          least_thickness(film, place));
    // Find the number of grids, each half as fine as the next.
    while ((film->around >> levels) >= MIN_AROUND && (film->along >> levels) >= MIN_ALONG &&
           (film->around >> (levels - 1)) % 2 == 0 && (film->along >> (levels - 1)) % 2 == 0)
        levels++;
    pad_answer last = {.thinnest = 0.0};
    memset(work->rest, 0, unknowns(work->around, work->along));
    // Solve from the coarsest grid on; the cavity of each is the first guess for the next.
    for (int level = levels - 1; level >= 0; level--) {
        const int around = film->around >> level, along = film->along >> level;
        if (level < levels - 1) refine_cavity(work, around, along);
        const grid g = grid_of(work, film, place, around, along);
        const whirl_status status = solve_grid(work, &g, film, place);
        if (status.code != WHIRL_OK) return status;
        *answer = answer_of(&g, film, place, work->pressure);
        if (level > 0) last = *answer;
    }
    answer->thinnest = least_thickness(film, place);
    // Extrapolate the last two grids.
    if (levels == 1) return whirl_ok();
    for (int i = 0; i < 2; i++) answer->force[i] = extrapolate(answer->force[i], last.force[i]);
    answer->leaving = extrapolate(answer->leaving, last.leaving);
    answer->drag = extrapolate(answer->drag, last.drag);
    return whirl_ok();
}

// ---------------------------------------------------------------- turbulence

turbulent_factors turbulent_resistance(whirl_turbulence law, double reynolds) {
    static const struct {
        double around[2], along[2]; // 12 + a Re^b
    } laws[] = {
        [WHIRL_LAMINAR] = {{0.0, 1.0}, {0.0, 1.0}},
        [WHIRL_NG_PAN] = {{0.0136, 0.90}, {0.0043, 0.96}},
        [WHIRL_CONSTANTINESCU] = {{0.0260, 0.8265}, {0.0198, 0.741}},
    };
    const double *around = laws[law].around, *along = laws[law].along;
    return (turbulent_factors){1.0 + around[0] * pow(reynolds, around[1]) / 12.0,
                               1.0 + along[0] * pow(reynolds, along[1]) / 12.0};
}

double turbulent_shear(whirl_turbulence law, double reynolds) {
    return law == WHIRL_LAMINAR ? 1.0 : 1.0 + 0.0012 * pow(reynolds, 0.94);
}
