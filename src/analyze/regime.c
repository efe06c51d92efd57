// The regime of a point as fields, and verdicts read back from them.
#include "analysis.h"

#include <math.h>

enum {
    CODE,
    PERIOD,
    CURVES,
    DIVERGED_AT,
    RECURRENCE,
    RECURRENCE_PERIOD,
    RECURRENCE_TREND,
    REGULARITY,
    EXPONENT,
    EXPONENT_ERROR,
    REVOLUTIONS,
    FIELD_COUNT
};

static const field_plan fields[FIELD_COUNT] = {
    [CODE] = {"code", "1", "0 undetermined, 1 periodic, 2 quasi-periodic, 3 chaotic, 4 diverged", WHIRL_PER_POINT, 1,
              NULL},
    [PERIOD] = {"period", "revolution", "k of P-k, else 0", WHIRL_PER_POINT, 1, NULL},
    [CURVES] = {"curves", "1", "closed curves of a quasi-periodic motion's section, else 0", WHIRL_PER_POINT, 1, NULL},
    [DIVERGED_AT] = {"diverged_at", "revolution", "revolution in which the motion left its bounds, else 0",
                     WHIRL_PER_POINT, 1, NULL},
    [RECURRENCE] = {"recurrence", "1", "evidence: return distance over the size of the motion", WHIRL_PER_POINT, 1,
                    NULL},
    [RECURRENCE_PERIOD] = {"recurrence_period", "revolution", "evidence: revolutions from a point to its return",
                           WHIRL_PER_POINT, 1, NULL},
    [RECURRENCE_TREND] = {"recurrence_trend", "1", "evidence: return distance late over early, below 1 it settles",
                          WHIRL_PER_POINT, 1, NULL},
    [REGULARITY] = {"regularity", "1", "evidence: decimal digits to which weighted averages of two halves agree",
                    WHIRL_PER_POINT, 1, NULL},
    [EXPONENT] = {"exponent", "1/revolution", "evidence: largest Lyapunov exponent that the verdict rests on",
                  WHIRL_PER_POINT, 1, NULL},
    [EXPONENT_ERROR] = {"exponent_error", "1/revolution", "evidence: its standard error", WHIRL_PER_POINT, 1, NULL},
    [REVOLUTIONS] = {"revolutions", "revolution", "revolutions integrated", WHIRL_PER_POINT, 1, NULL},
};

static void put_verdict(const whirl_record *record, const block_view *view) {
    const whirl_verdict v = whirl_judge(record);
    const double values[FIELD_COUNT] = {
        [CODE] = v.regime,
        [PERIOD] = v.period,
        [CURVES] = v.curves,
        [DIVERGED_AT] = v.diverged_at,
        [RECURRENCE] = v.recurrence,
        [RECURRENCE_PERIOD] = v.recurrence_period,
        [RECURRENCE_TREND] = v.recurrence_trend,
        [REGULARITY] = v.regularity,
        [EXPONENT] = v.exponent.value,
        [EXPONENT_ERROR] = v.exponent.error,
        [REVOLUTIONS] = record->revolutions,
    };
    for (size_t f = 0; f < FIELD_COUNT; f++) *view_numbers(view, f, 0) = values[f];
}

static whirl_status compute(const whirl_record *record, const whirl_record_options *options, const block_view *view) {
    (void)options;
    put_verdict(record, view);
    return whirl_ok();
}

const analysis_plan regime_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .compute = compute, .compute_diverged = put_verdict};

/// The number of a field of this analysis, NaN where the block has none.
static double stored(const whirl_layout *layout, const double *block, const char *name) {
    const whirl_field *field = whirl_layout_field(layout, name);
    return field ? block[field->offset] : NAN;
}

static int whole(double value, int most) {
    return value >= 0.0 && value <= (double)most ? (int)value : 0;
}

whirl_verdict whirl_block_verdict(const whirl_layout *layout, const double *block) {
    const double diverged_at = stored(layout, block, "regime/diverged_at");
    return (whirl_verdict){
        .regime = (whirl_regime)whole(stored(layout, block, "regime/code"), WHIRL_DIVERGING),
        .period = whole(stored(layout, block, "regime/period"), WHIRL_MAX_PERIOD),
        .curves = whole(stored(layout, block, "regime/curves"), WHIRL_MAX_PERIOD),
        .diverged_at = isnan(diverged_at) ? 0.0 : diverged_at,
        .exponent = {stored(layout, block, "regime/exponent"), stored(layout, block, "regime/exponent_error")},
        .recurrence = stored(layout, block, "regime/recurrence"),
        .recurrence_period = whole(stored(layout, block, "regime/recurrence_period"), WHIRL_MAX_PERIOD),
        .recurrence_trend = stored(layout, block, "regime/recurrence_trend"),
        .regularity = stored(layout, block, "regime/regularity"),
    };
}
