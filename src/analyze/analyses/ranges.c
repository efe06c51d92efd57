// Ranges: how far a motion, or a machine at rest, leaves the range in which its laws are valid; and whether small
// motions about an equilibrium keep its contacts open or closed.
#include <math.h>
#include <stdlib.h>

#include "analysis.h"
#include "statics.h"

enum { REST, ELSEWHERE, ELSEWHERE_GROWTH, LEFT, REACHED, HELD, FIELD_COUNT };

static size_t every_range(const block_shape *shape) {
    return shape->range_count;
}

static size_t one_where_any(const block_shape *shape) {
    return shape->range_count > 0;
}

/// Returns the number of rows of the equilibrium's fields: 1 for machines at rest; 0 otherwise, and where springs
/// replace the bearings, since the machine then has another equilibrium.
static size_t one_at_rest(const block_shape *shape) {
    return shape->at_rest && !shape->options->bearings;
}

static size_t one_where_it_rests(const block_shape *shape) {
    return shape->at_rest;
}

static const field_plan fields[FIELD_COUNT] = {
    [REST] = {WHIRL_FIELD_RANGES_REST, "1",
              "largest share of the static load with a position of rest; 1: the whole load", WHIRL_PER_POINT, 1,
              one_where_it_rests},
    [ELSEWHERE] =
        {WHIRL_FIELD_RANGES_ELSEWHERE, "length",
         "x, y (from the equilibrium to another one, found from that of the previous or next value of the parameter; "
         "missing where none was found)",
         WHIRL_PER_STATION, 2, one_at_rest},
    [ELSEWHERE_GROWTH] = {WHIRL_FIELD_RANGES_ELSEWHERE_GROWTH, "1/s",
                          "largest real part of all eigenvalues at that other equilibrium: stable below 0",
                          WHIRL_PER_POINT, 1, one_at_rest},
    [LEFT] = {WHIRL_FIELD_RANGES_LEFT, "1", "number of laws whose ranges were left", WHIRL_PER_POINT, 1, one_where_any},
    [REACHED] = {WHIRL_FIELD_RANGES_REACHED, "1", "reached, most (of every range, in its unit)", WHIRL_PER_POINT, 2,
                 every_range},
    [HELD] = {WHIRL_FIELD_RANGES_HELD, "force", "normal force of the contact at rest, 0: open", WHIRL_PER_CONTACT, 1,
              one_at_rest},
};

static void ranges_fill(const whirl_system *system, const whirl_extremes *seen, const block_view *view) {
    whirl_law_range range;
    double left = 0.0;
    if (!view->fields[LEFT]) return;
    for (size_t i = 0; system->range(system->model, i, seen, &range); i++) {
        double *out = view_numbers(view, REACHED, 0) + 2 * i;
        out[0] = range.reached;
        out[1] = range.most;
        left += range.reached > range.most * (1.0 + 1e-9);
    }
    *view_numbers(view, LEFT, 0) = left;
}

static whirl_status fill_held(const whirl_system *system, const double *x, const block_view *view) {
    if (!view->fields[HELD]) return whirl_ok();
    double *force = calloc(system->contact_count, sizeof *force);
    if (!force) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the forces of contacts");
    const whirl_status status = whirl_rest_contacts(system, x, force);
    for (size_t c = 0; c < system->contact_count && status.code == WHIRL_OK; c++)
        *view_numbers(view, HELD, c) = force[c];
    free(force);
    return status;
}

static whirl_status ranges_compute(const whirl_record *record, const whirl_record_options *options,
                                   const block_view *view) {
    (void)options;
    ranges_fill(record->system, &(whirl_extremes){record->low, record->high, record->max_radius}, view);
    return whirl_ok();
}

static void fill_elsewhere(const whirl_resting *point, const block_view *view) {
    if (!view->fields[ELSEWHERE] || !point->elsewhere) return;
    for (size_t p = 0; p < point->system->probe_count; p++)
        for (size_t c = 0; c < 2; c++)
            view_numbers(view, ELSEWHERE, p)[c] = whirl_probe_value(&point->system->probes[p], point->elsewhere, c) -
                                                  whirl_probe_value(&point->system->probes[p], point->rest, c);
    *view_numbers(view, ELSEWHERE_GROWTH, 0) = point->clock * point->elsewhere_growth;
}

/// Writes the ranges at the equilibrium. If the search for it fails, writes the share of the load up to which the
/// equilibrium can be followed.
static whirl_status compute_resting(const whirl_resting *point, const whirl_record_options *options,
                                    const block_view *view) {
    const whirl_system *system = point->system;
    const size_t d = system->dimension, probes = system->probe_count;
    (void)options;
    *view_numbers(view, REST, 0) = 1.0;
    fill_elsewhere(point, view);
    if (!view->fields[LEFT] && !view->fields[HELD] && (point->modes || !films_any(system, point->start)))
        return whirl_ok();
    double *x = malloc((d + probes + 1) * sizeof *x), *radius = x ? x + d : NULL;
    if (!x) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the ranges of laws");
    memcpy(x, point->modes ? point->modes->rest : point->start, d * sizeof *x);
    whirl_status status = point->modes ? whirl_ok() : whirl_equilibrium(system, x);
    for (size_t p = 0; p < probes; p++)
        radius[p] = hypot(whirl_probe_value(&system->probes[p], x, 0), whirl_probe_value(&system->probes[p], x, 1));
    if (status.code == WHIRL_OK) {
        ranges_fill(system, &(whirl_extremes){x, x, radius}, view);
        status = fill_held(system, x, view);
    }
    free(x);
    if (status.code != WHIRL_NUMERICAL_FAILURE) return status;
    // At standstill films carry nothing, and the eccentricity has no meaning.
    if (point->speed != 0.0) *view_numbers(view, REST, 0) = whirl_equilibrium_share(system, point->start);
    return whirl_ok();
}

void whirl_unfound_at_rest(const whirl_layout *layout, double share, double *block) {
    const whirl_field *field = whirl_layout_field(layout, WHIRL_FIELD_RANGES_REST);
    for (size_t i = 0; i < layout->size; i++) block[i] = NAN;
    if (field && share < 1.0) block[field->offset] = share;
}

const analysis_plan ranges_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .compute = ranges_compute, .compute_resting = compute_resting};

const char *whirl_analysis_of_ranges(void) {
    return "ranges";
}
