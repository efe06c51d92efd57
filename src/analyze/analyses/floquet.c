// The orbit that a motion has settled on, and its Floquet multipliers, as fields.
#include <math.h>

#include "analysis.h"

enum {
    SEARCH,
    PERIOD,
    RESIDUAL,
    DISTANCE,
    MODULUS,
    UNSTABLE,
    MULTIPLIERS,
    VOLUME_ERROR,
    REVOLUTIONS,
    SET_AT,
    FIELD_COUNT
};

static const field_plan fields[FIELD_COUNT] = {
    [SEARCH] = {WHIRL_FIELD_FLOQUET_SEARCH, "1",
                "0 no search for an orbit, 1 the motion is on a stable one, 2 on an unstable one, 3 the nearest one is "
                "elsewhere, 4 none found",
                WHIRL_PER_POINT, 1, NULL},
    [PERIOD] = {WHIRL_FIELD_FLOQUET_PERIOD, "revolution", "revolutions after which the orbit closes", WHIRL_PER_POINT,
                1, NULL},
    [RESIDUAL] = {WHIRL_FIELD_FLOQUET_RESIDUAL, "1", "error by which the orbit closes, over its largest coordinate",
                  WHIRL_PER_POINT, 1, NULL},
    [DISTANCE] = {WHIRL_FIELD_FLOQUET_DISTANCE, "1",
                  "distance of the motion's last state from the orbit, over the size of the motion", WHIRL_PER_POINT, 1,
                  NULL},
    [MODULUS] = {WHIRL_FIELD_FLOQUET_MODULUS, "1", "modulus of its largest multiplier", WHIRL_PER_POINT, 1, NULL},
    [UNSTABLE] = {WHIRL_FIELD_FLOQUET_UNSTABLE, "1", "multipliers beyond the unit circle", WHIRL_PER_POINT, 1, NULL},
    [MULTIPLIERS] = {WHIRL_FIELD_FLOQUET_MULTIPLIERS, "1", "real, imaginary", WHIRL_PER_POINT, 2, rows_per_coordinate},
    [VOLUME_ERROR] =
        {WHIRL_FIELD_FLOQUET_VOLUME_ERROR, "1",
         "sum of the multipliers' logarithms less that by the divergence; missing where the smallest is below 1e-12",
         WHIRL_PER_POINT, 1, NULL},
    [REVOLUTIONS] = {WHIRL_FIELD_FLOQUET_REVOLUTIONS, "revolution",
                     "revolutions that Newton's method took, with all perturbations", WHIRL_PER_POINT, 1, NULL},
    [SET_AT] = {WHIRL_FIELD_FLOQUET_SET_AT, "revolution",
                "revolution from which the motion continues on the orbit (0: never)", WHIRL_PER_POINT, 1, NULL},
};

/// Writes the fields that follow from the multipliers.
static void put_multipliers(const whirl_record_orbit *orbit, const block_view *view) {
    const double slight = 1e-9;
    const double lost = 1e-12; // a smaller multiplier is lost in the rounding of a derivative's largest numbers
    double sum = 0.0, *unstable = view_numbers(view, UNSTABLE, 0);
    *unstable = 0.0;
    for (size_t i = 0; i < orbit->multiplier_count; i++) {
        const double *value = orbit->multipliers + 2 * i, modulus = hypot(value[0], value[1]);
        view_numbers(view, MULTIPLIERS, 0)[2 * i] = value[0];
        view_numbers(view, MULTIPLIERS, 0)[2 * i + 1] = value[1];
        *unstable += modulus > 1.0 + slight;
        sum += log(modulus);
    }
    *view_numbers(view, PERIOD, 0) = orbit->period;
    *view_numbers(view, RESIDUAL, 0) = orbit->residual;
    *view_numbers(view, DISTANCE, 0) = orbit->distance;
    *view_numbers(view, MODULUS, 0) = orbit->modulus;
    const double *least = orbit->multipliers + 2 * (orbit->multiplier_count - 1);
    if (hypot(least[0], least[1]) > lost) *view_numbers(view, VOLUME_ERROR, 0) = sum - orbit->volume;
}

static whirl_status floquet_compute(const whirl_record *record, const whirl_record_options *options,
                                    const block_view *view) {
    const whirl_record_orbit *orbit = &record->orbit;
    (void)options;
    *view_numbers(view, SEARCH, 0) = orbit->search;
    *view_numbers(view, REVOLUTIONS, 0) = orbit->revolutions;
    *view_numbers(view, SET_AT, 0) = orbit->set_at;
    if (orbit->multiplier_count > 0) put_multipliers(orbit, view);
    return whirl_ok();
}

const analysis_plan floquet_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .uses_orbits = true, .compute = floquet_compute};
