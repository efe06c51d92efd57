// Orbits: how far every station moves, and in which sense it whirls.
#include <math.h>

#include "analysis.h"

enum { MAX_RADIUS, MIN_RADIUS, MEAN, ECCENTRICITY, LOW, HIGH, BACKWARD, FIELD_COUNT };

static const field_plan fields[FIELD_COUNT] = {
    [MAX_RADIUS] = {"max_radius", "length", "largest distance from the centre", WHIRL_PER_STATION, 1, NULL},
    [MIN_RADIUS] = {"min_radius", "length", "smallest distance from the centre", WHIRL_PER_STATION, 1, NULL},
    [MEAN] = {"mean", "length", "x, y", WHIRL_PER_STATION, 2, NULL},
    [ECCENTRICITY] = {"eccentricity", "1",
                      "largest eccentricity ratio of the journal (missing where there is no bearing)",
                      WHIRL_PER_STATION, 1, NULL},
    [LOW] = {"low", "length", "x, y", WHIRL_PER_STATION, 2, NULL},
    [HIGH] = {"high", "length", "x, y", WHIRL_PER_STATION, 2, NULL},
    [BACKWARD] = {"backward", "1", "share of the time of whirl against the rotation", WHIRL_PER_STATION, 1, NULL},
};

static whirl_status compute(const whirl_record *record, const whirl_record_options *options, const block_view *view) {
    (void)options;
    for (size_t s = 0; s < record->probe_count; s++) {
        const whirl_probe *probe = &record->probes[s];
        *view_numbers(view, MAX_RADIUS, s) = record->max_radius[s];
        *view_numbers(view, MIN_RADIUS, s) = record->min_radius[s];
        *view_numbers(view, ECCENTRICITY, s) = probe->clearance > 0.0 ? record->max_radius[s] / probe->clearance : NAN;
        *view_numbers(view, BACKWARD, s) = record->backward[s];
        const size_t coordinates[2] = {probe->x, probe->y};
        for (size_t c = 0; c < 2; c++) {
            view_numbers(view, MEAN, s)[c] = record->mean[2 * s + c];
            view_numbers(view, LOW, s)[c] = record->low[coordinates[c]];
            view_numbers(view, HIGH, s)[c] = record->high[coordinates[c]];
        }
    }
    return whirl_ok();
}

const analysis_plan orbit_analysis = {.fields = fields, .field_count = FIELD_COUNT, .compute = compute};
