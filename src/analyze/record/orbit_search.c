#include "orbit_search.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "archive.h"
#include "matrix.h"
#include "turns.h"
#include "whirl/engine/ensemble.h"

// ---------------------------------------------------------------- one orbit_search

orbit_search *orbit_search_new(const whirl_system *system, size_t revolutions, const double *x) {
    const size_t d = system->dimension;
    size_t n = 0;
    for (size_t i = 0; i < d; i++) n += !turns_on(system->turns, i);
    orbit_search *s = calloc(1, sizeof *s + n * sizeof *s->values + revolutions * (d + n * n) * sizeof(double));
    if (!s) return NULL;
    *s = (orbit_search){.system = system, .dimension = d, .kept = n, .revolutions = revolutions, .residual = INFINITY};
    s->values = (whirl_multiplier *)(s + 1);
    s->nodes = (double *)(s->values + n);
    s->factors = s->nodes + revolutions * d;
    if (x) memcpy(s->nodes, x, d * sizeof *x);
    return s;
}

void orbit_search_archive(orbit_search *s, archive *a) {
    archive_part(a, s->nodes, s->revolutions * s->dimension * sizeof *s->nodes);
    archive_part(a, s->factors, s->revolutions * s->kept * s->kept * sizeof *s->factors);
    archive_part(a, s->values, s->kept * sizeof *s->values);
    archive_part(a, &s->residual, sizeof s->residual);
    archive_part(a, &s->volume, sizeof s->volume);
    archive_part(a, &s->carried, sizeof s->carried);
    archive_part(a, &s->found, sizeof s->found);
}

void orbit_search_monodromy(const orbit_search *s, double *matrix, double *work) {
    const size_t n = s->kept;
    memcpy(matrix, s->factors, n * n * sizeof *matrix);
    for (size_t r = 1; r < s->revolutions; r++) {
        const double *factor = s->factors + r * n * n;
        memcpy(work, matrix, n * n * sizeof *work);
        memset(matrix, 0, n * n * sizeof *matrix);
        for (size_t i = 0; i < n; i++)
            for (size_t k = 0; k < n; k++)
                for (size_t j = 0; j < n; j++) matrix[i * n + j] += factor[i * n + k] * work[k * n + j];
    }
}

static void searches_difference(const orbit_search *s, const double *a, const double *b, double *out) {
    for (size_t i = 0; i < s->dimension; i++)
        if (!turns_on(s->system->turns, i)) *out++ = short_way(s->system->angles, i, a[i] - b[i]);
}

void orbit_search_difference(const orbit_search *s, const double *x, double *out) {
    searches_difference(s, x, s->nodes, out);
}

double orbit_search_distance(const orbit_search *s, const double *x) {
    double sum = 0.0;
    for (size_t i = 0; i < s->dimension; i++) {
        const double away = part_apart(s->system->turns, s->system->angles, i, x, s->nodes);
        sum += away * away;
    }
    return sqrt(sum);
}

/// Returns the largest modulus of the coordinates that do not turn.
static double searches_largest(const orbit_search *s, const double *x) {
    double most = 0.0;
    for (size_t i = 0; i < s->dimension; i++)
        if (!turns_on(s->system->turns, i)) most = fmax(most, fabs(x[i]));
    return most;
}

static double largest_of(size_t n, const double *values) {
    double most = 0.0;
    for (size_t i = 0; i < n; i++) most = fmax(most, fabs(values[i]));
    return most;
}

// ---------------------------------------------------------------- many

/// A search in a lane.
typedef struct lane_search {
    orbit_search *of;
    size_t revolution;
    int steps; ///< Newton steps
} lane_search;

struct orbit_searches {
    whirl_ensemble *ensemble;
    size_t dimension, lanes;
    double tolerance;          ///< largest residual of a closed orbit, relative to its largest coordinate
    whirl_perturbations *sets; ///< [lanes]
    double *vectors;           ///< [lanes][dimension][dimension]
    lane_search *in_lanes;     ///< [lanes]
    size_t used;               ///< lanes, at the front
};

/// Returns the options for searches. The tolerance of an adaptive method is reduced, so that Newton's method sees a
/// smooth map and the orbit is two digits more exact than the motion.
static whirl_integrate_options searches_exact(const whirl_integrate_options *integrate, double *tolerance) {
    whirl_integrate_options own = *integrate;
    const double finest = strcmp(own.method, "dop853") == 0 ? 1e-13 : 1e-11; // order 8 and 5
    *tolerance = 1e-12;
    if (!whirl_method_is_adaptive(own.method)) return own;
    own.rtol = fmax(fmin(1e-2 * own.rtol, 1e-10), fmin(own.rtol, finest));
    own.atol = fmin(own.atol, 1e-2 * own.rtol);
    *tolerance = 10.0 * own.rtol;
    return own;
}

static whirl_status make_ensemble(orbit_searches *s, const whirl_system *system,
                                  const whirl_integrate_options *options) {
    enum { ABREAST = 16 }; // two vectors of the widest kind
    if (whirl_ensemble_follows(system, options)) return whirl_ensemble_variational(system, options, &s->ensemble);
    if (whirl_ensemble_flows(system, options))
        return whirl_ensemble_flow(system, options, ABREAST, system->dimension, &s->ensemble);
    return whirl_ensemble_alone(system, options, 1, system->dimension, &s->ensemble);
}

whirl_status orbit_searches_new(const whirl_system *system, const whirl_integrate_options *integrate,
                                orbit_searches **out) {
    const whirl_method *method;
    *out = NULL;
    // Newton's method needs a Jacobian, and a method that carries perturbations.
    whirl_status status = whirl_method_find(integrate->method, &method);
    if (status.code == WHIRL_OK && (!system->tangent || !method->follows))
        status = whirl_fail(WHIRL_BAD_INPUT, "the system gives no Jacobian, or method %s takes no perturbations along",
                            integrate->method);
    orbit_searches *s = status.code == WHIRL_OK ? calloc(1, sizeof *s) : NULL;
    if (!s) return status.code == WHIRL_OK ? whirl_fail(WHIRL_NO_MEMORY, "no memory to look for orbits") : status;
    // Make an ensemble with tighter tolerances, and arrays for all its lanes.
    const whirl_integrate_options options = searches_exact(integrate, &s->tolerance);
    s->dimension = system->dimension;
    status = make_ensemble(s, system, &options);
    if (status.code == WHIRL_OK) {
        s->lanes = whirl_ensemble_lanes(s->ensemble);
        s->sets = calloc(s->lanes, sizeof *s->sets);
        s->vectors = calloc(s->lanes * s->dimension * s->dimension + 1, sizeof *s->vectors);
        s->in_lanes = calloc(s->lanes, sizeof *s->in_lanes);
        if (!s->sets || !s->vectors || !s->in_lanes)
            status = whirl_fail(WHIRL_NO_MEMORY, "no memory to look for orbits");
    }
    if (status.code == WHIRL_OK)
        *out = s;
    else
        orbit_searches_free(s);
    return status;
}

void orbit_searches_free(orbit_searches *s) {
    if (!s) return;
    whirl_ensemble_free(s->ensemble);
    free(s->vectors);
    free(s->sets);
    free(s->in_lanes);
    free(s);
}

size_t orbit_searches_lanes(const orbit_searches *s) {
    return s->lanes;
}

/// Attaches unit perturbations to a lane for the next revolution.
static void begin_revolution(orbit_searches *s, size_t lane) {
    const size_t d = s->dimension;
    double *vectors = s->vectors + lane * d * d;
    memset(vectors, 0, d * d * sizeof *vectors);
    for (size_t i = 0; i < d; i++) vectors[i * (d + 1)] = 1.0;
    s->sets[lane] = (whirl_perturbations){.count = d, .vectors = vectors};
    whirl_ensemble_carry(s->ensemble, lane, &s->sets[lane]);
}

/// Stores revolution r of a search: its derivative, and its end state. That is the next node; after the last revolution
/// it is written to `end`.
static void end_revolution(const orbit_searches *s, size_t lane, orbit_search *of, size_t r, double *end) {
    const size_t d = s->dimension, n = of->kept;
    const double *vectors = s->vectors + lane * d * d;
    double *factor = of->factors + r * n * n;
    for (size_t k = 0, column = 0; k < d; k++) {
        if (turns_on(of->system->turns, k)) continue;
        for (size_t i = 0, row = 0; i < d; i++)
            if (!turns_on(of->system->turns, i)) factor[row++ * n + column] = vectors[k * d + i];
        column++;
    }
    whirl_ensemble_state(s->ensemble, lane, r + 1 < of->revolutions ? of->nodes + (r + 1) * d : end);
    of->volume += s->sets[lane].volume;
    of->carried += 1.0;
}

enum { MAX_STEPS = 8 };

/// Takes a Newton step after a search reached `end`; returns true if it continues, from a node that was moved.
static bool searches_step(const orbit_searches *s, orbit_search *of, const double *end, double *work) {
    const size_t n = of->kept;
    const double before = of->residual, size = searches_largest(of, of->nodes);
    double *gap = work, *matrix = work + n;
    searches_difference(of, end, of->nodes, gap);
    of->residual = largest_of(n, gap) / fmax(size, 1e-300);
    // The orbit closes, or only rounding is left, which no step reduces.
    of->found = of->residual <= s->tolerance || (of->residual <= 100.0 * s->tolerance && of->residual > 0.25 * before);
    if (of->found || !(of->residual < before)) return false;
    orbit_search_monodromy(of, matrix, matrix + n * n);
    for (size_t i = 0; i < n * n; i++) matrix[i] = (i % (n + 1) == 0 ? 1.0 : 0.0) - matrix[i];
    if (!matrix_solve(n, matrix, 1, gap) || !(largest_of(n, gap) <= size)) return false;
    for (size_t i = 0; i < of->dimension; i++)
        if (!turns_on(of->system->turns, i)) of->nodes[i] += *gap++;
    return true;
}

/// Shortens an orbit that closes after fewer revolutions.
static void searches_shorten(orbit_search *s, double tolerance) {
    const double same = 1e3 * tolerance * searches_largest(s, s->nodes);
    const size_t repeats = s->system->turns ? s->system->repeats : 1, d = s->dimension;
    for (size_t j = repeats; 2 * j <= s->revolutions; j += repeats) {
        double away = 0.0;
        for (size_t i = 0; i < d; i++)
            away = fmax(away, fabs(part_apart(s->system->turns, s->system->angles, i, s->nodes + j * d, s->nodes)));
        if (s->revolutions % j != 0 || away > same) continue;
        s->volume *= (double)j / (double)s->revolutions;
        s->revolutions = j;
    }
}

/// Puts a search at the beginning of its orbit.
static whirl_status searches_begin(const orbit_searches *s, size_t lane, lane_search *f) {
    f->revolution = 0;
    f->of->volume = 0.0;
    return whirl_ensemble_load(s->ensemble, lane, f->of->system, f->of->nodes);
}

/// Ends a revolution. *stays becomes true if the search stays in its lane. `end` has `dimension` numbers.
static whirl_status searches_advance(const orbit_searches *s, size_t lane, lane_search *f, double *end, double *work,
                                     bool *stays) {
    const bool bounded = whirl_ensemble_motion(s->ensemble, lane) == WHIRL_BOUNDED;
    end_revolution(s, lane, f->of, f->revolution++, end);
    *stays = bounded;
    if (!bounded || f->revolution < f->of->revolutions) return whirl_ok();
    *stays = searches_step(s, f->of, end, work) && ++f->steps < MAX_STEPS;
    return *stays ? searches_begin(s, lane, f) : whirl_ok();
}

/// Removes a search that is done; the last one moves to its lane.
static void searches_leave(orbit_searches *s, size_t lane) {
    orbit_search *of = s->in_lanes[lane].of;
    of->in_lane = false;
    of->done = true;
    if (of->found) {
        searches_shorten(of, s->tolerance);
        of->found = whirl_product_eigenvalues(of->kept, of->revolutions, of->factors, of->values);
    }
    whirl_ensemble_unload(s->ensemble, lane);
    if (lane < --s->used) whirl_ensemble_move(s->ensemble, s->used, lane);
    s->in_lanes[lane] = s->in_lanes[s->used];
}

/// Carries all searches in lanes over a revolution.
static whirl_status searches_revolve(orbit_searches *s, double *end) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < s->used; i++) begin_revolution(s, i);
    whirl_ensemble_revolve(s->ensemble, s->used, NULL);
    for (size_t i = s->used; i-- > 0 && status.code == WHIRL_OK;) {
        bool stays;
        status = searches_advance(s, i, &s->in_lanes[i], end, end + s->dimension, &stays);
        if (!stays) searches_leave(s, i);
    }
    return status;
}

whirl_status orbit_searches_run(orbit_searches *s, orbit_search *const *searches, size_t count, size_t least) {
    const size_t d = s->dimension;
    double *end = malloc((2 * d + 2 * d * d) * sizeof *end);
    whirl_status status = end ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory to look for %zu orbits", count);
    size_t next = 0;
    while (status.code == WHIRL_OK) {
        for (; s->used < s->lanes && next < count && status.code == WHIRL_OK; next++) {
            if (searches[next]->in_lane || searches[next]->done) continue;
            s->in_lanes[s->used] = (lane_search){.of = searches[next]};
            searches[next]->in_lane = true;
            status = searches_begin(s, s->used, &s->in_lanes[s->used]);
            s->used++;
        }
        if (s->used < least || s->used == 0 || status.code != WHIRL_OK) break;
        status = searches_revolve(s, end);
    }
    free(end);
    return status;
}
