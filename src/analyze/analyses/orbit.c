// Extent of every station's motion, and its sense of whirl.
#include <math.h>

#include "analysis.h"

enum { WHIRL_WATCHED_OF_STATIONS(WATCHED_INDEX) ECCENTRICITY, LOW, HIGH, AXIAL, TWIST, FIELD_COUNT };

static const field_plan fields[FIELD_COUNT] = {
    [ECCENTRICITY] =
        {WHIRL_FIELD_ORBIT_ECCENTRICITY, "1",
         "largest eccentricity ratio of the journal (missing where there is no bearing, or its housing moves)",
         WHIRL_PER_STATION, 1, NULL},
    [LOW] = {WHIRL_FIELD_ORBIT_LOW, "length", "x, y (least at any instant, from the centre)", WHIRL_PER_STATION, 2,
             NULL},
    [HIGH] = {WHIRL_FIELD_ORBIT_HIGH, "length", "x, y (most at any instant, from the centre)", WHIRL_PER_STATION, 2,
              NULL},
    [AXIAL] =
        {WHIRL_FIELD_ORBIT_AXIAL, "length",
         "mean, least, largest (axial displacement at all instants, in the direction of growing positions; missing "
         "where the station does not move along its shaft)",
         WHIRL_PER_STATION, 3, rows_of_axial},
    [TWIST] = {WHIRL_FIELD_ORBIT_TWIST, "rad",
               "mean, least, largest (twist about the axis at all instants, positive from x towards y; missing where "
               "the station does not twist, or moves no other way)",
               WHIRL_PER_STATION, 3, rows_of_twist},
    // clang-format off
    WHIRL_WATCHED_OF_STATIONS(WATCHED_PLAN)
    // clang-format on
};

/// Returns true if a station moves no more than rounding.
static bool orbit_rests(const double *low, const double *high, double max_radius) {
    return hypot(high[0] - low[0], high[1] - low[1]) <= 2.0 * MIN_MOTION * max_radius;
}

static whirl_status orbit_compute(const whirl_record *record, const whirl_record_options *options,
                                  const block_view *view) {
    (void)options;
    for (size_t which = 0; which < record->probe_count; which++) {
        const whirl_probe *probe = &record->probes[which];
        const double radius = record->max_radius[which];
        WHIRL_WATCHED_OF_STATIONS(WATCHED_FILL)
        *view_numbers(view, ECCENTRICITY, which) = probe->clearance > 0.0 ? radius / probe->clearance : NAN;
        for (size_t c = 0; c < 2; c++) {
            double bounds[2];
            probe_bounds(probe, record->low, record->high, c, bounds);
            view_numbers(view, LOW, which)[c] = bounds[0];
            view_numbers(view, HIGH, which)[c] = bounds[1];
        }
        if (orbit_rests(view_numbers(view, LOW, which), view_numbers(view, HIGH, which), radius))
            *view_numbers(view, WATCHED_backward, which) = NAN;
    }
    // Probes of axial displacements and twists follow those of the stations.
    for (size_t i = 0; i < record->extra_count; i++) {
        const size_t which = record->probe_count + i;
        double *out = view_numbers(view, record->extras[i].twists ? TWIST : AXIAL, record->extras[i].station);
        out[0] = record->mean[2 * which];
        probe_bounds(&record->probes[which], record->low, record->high, 0, out + 1);
    }
    return whirl_ok();
}

const analysis_plan orbit_analysis = {.fields = fields, .field_count = FIELD_COUNT, .compute = orbit_compute};
