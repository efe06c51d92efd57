// The regime of a point as fields, and verdicts read back from them.
#include "analysis.h"

#include <limits.h>
#include <math.h>

enum {
    CODE,
    PERIOD,
    CURVES,
    FREQUENCIES,
    DIVERGED_AT,
    LIMIT,
    LIMIT_COORDINATE,
    CONFIDENCE,
    AGREEMENT,
    ADVICE,
    ADVICE_FACTOR,
    OTHER_CODE,
    OTHER_PERIOD,
    FOLLOWED,
    LATER_CODE,
    LATER_PERIOD,
    RECURRENCE,
    RECURRENCE_PERIOD,
    LONGEST_PERIOD,
    RECURRENCE_TREND,
    REGULARITY,
    CHAOS,
    ROTATION,
    NEIGHBOURS,
    UNLOCKED,
    ROUND,
    EXPONENT,
    EXPONENT_ERROR,
    STEP_GROWTH,
    STEP_ERROR,
    SWELLING,
    COEXISTING,
    SURVIVED,
    ENDED,
    SETTLES,
    SETTLING,
    SETTLING_ERROR,
    LINE,
    LINE_SHARE,
    LINE_TREND,
    SECOND,
    SECOND_SHARE,
    SECOND_TREND,
    RESTS,
    REST_DISTANCE,
    REST_ORDER,
    REVOLUTIONS,
    FIELD_COUNT
};

_Static_assert((int)FIELD_COUNT <= (int)MAX_ANALYSIS_FIELDS, "a view has room for all fields of an analysis");

static const field_plan fields[FIELD_COUNT] = {
    [CODE] = {WHIRL_FIELD_REGIME_CODE, "1", "0 undetermined, 1 periodic, 2 quasi-periodic, 3 chaotic, 4 diverged",
              WHIRL_PER_POINT, 1, NULL},
    [PERIOD] = {WHIRL_FIELD_REGIME_PERIOD, "revolution", "k of P-k, else 0", WHIRL_PER_POINT, 1, NULL},
    [CURVES] = {WHIRL_FIELD_REGIME_CURVES, "1", "closed curves of a quasi-periodic motion's section, else 0",
                WHIRL_PER_POINT, 1, NULL},
    [FREQUENCIES] = {WHIRL_FIELD_REGIME_FREQUENCIES, "1",
                     "number of frequencies of a quasi-periodic motion, the shaft's included: 2 for closed curves or "
                     "forced by a phase, 3 for a surface and two exponents of zero, 0 if not known",
                     WHIRL_PER_POINT, 1, NULL},
    [DIVERGED_AT] = {WHIRL_FIELD_REGIME_DIVERGED_AT, "revolution",
                     "revolution in which the motion left its bounds, else 0", WHIRL_PER_POINT, 1, NULL},
    [LIMIT] = {WHIRL_FIELD_REGIME_LIMIT, "1",
               "the option `limit` of a diverging motion that passed it, in scales of coordinates, else 0",
               WHIRL_PER_POINT, 1, NULL},
    [LIMIT_COORDINATE] = {WHIRL_FIELD_REGIME_LIMIT_COORDINATE, "1", "coordinate that passed the limit, from 0, else 0",
                          WHIRL_PER_POINT, 1, NULL},
    [CONFIDENCE] = {WHIRL_FIELD_REGIME_CONFIDENCE, "1",
                    "0 low, 1 fair, 2 high (at most fair without a second tolerance)", WHIRL_PER_POINT, 1, NULL},
    [AGREEMENT] = {WHIRL_FIELD_REGIME_AGREEMENT, "1",
                   "confidence by the evidence of this tolerance alone: 0 low, 1 fair, 2 high", WHIRL_PER_POINT, 1,
                   NULL},
    [ADVICE] =
        {WHIRL_FIELD_REGIME_ADVICE, "1",
         "advice to settle the verdict: 0 nothing, 1 a longer run, 2 a longer watch, 3 a tighter tolerance, 4 more "
         "steps, 5 another start",
         WHIRL_PER_POINT, 1, NULL},
    [ADVICE_FACTOR] = {WHIRL_FIELD_REGIME_ADVICE_FACTOR, "1",
                       "factor of the advice: of the length, of the steps, or of a smaller error of a step",
                       WHIRL_PER_POINT, 1, NULL},
    [OTHER_CODE] = {WHIRL_FIELD_REGIME_OTHER_CODE, "1", "code at the second tolerance, missing without one",
                    WHIRL_PER_POINT, 1, NULL},
    [OTHER_PERIOD] = {WHIRL_FIELD_REGIME_OTHER_PERIOD, "revolution", "k of P-k at the second tolerance",
                      WHIRL_PER_POINT, 1, NULL},
    [FOLLOWED] = {WHIRL_FIELD_REGIME_FOLLOWED, "revolution",
                  "revolutions of all copies of a chaotic motion beyond its end, else 0", WHIRL_PER_POINT, 1, NULL},
    [LATER_CODE] = {WHIRL_FIELD_REGIME_LATER_CODE, "1", "code of these copies at their end, missing without copies",
                    WHIRL_PER_POINT, 1, NULL},
    [LATER_PERIOD] = {WHIRL_FIELD_REGIME_LATER_PERIOD, "revolution", "k of P-k of these copies at their end",
                      WHIRL_PER_POINT, 1, NULL},
    [RECURRENCE] = {WHIRL_FIELD_REGIME_RECURRENCE, "1", "evidence: return distance over the size of the motion",
                    WHIRL_PER_POINT, 1, NULL},
    [RECURRENCE_PERIOD] = {WHIRL_FIELD_REGIME_RECURRENCE_PERIOD, "revolution",
                           "evidence: revolutions from a point to its return", WHIRL_PER_POINT, 1, NULL},
    [LONGEST_PERIOD] = {WHIRL_FIELD_REGIME_LONGEST_PERIOD, "revolution", "evidence: longest period of the search",
                        WHIRL_PER_POINT, 1, NULL},
    [RECURRENCE_TREND] = {WHIRL_FIELD_REGIME_RECURRENCE_TREND, "1",
                          "evidence: return distance late over early, below 1 the motion settles", WHIRL_PER_POINT, 1,
                          NULL},
    [REGULARITY] = {WHIRL_FIELD_REGIME_REGULARITY, "1",
                    "evidence: decimal digits to which weighted averages of two halves agree", WHIRL_PER_POINT, 1,
                    NULL},
    [CHAOS] = {WHIRL_FIELD_REGIME_CHAOS, "1", "evidence: K of the 0-1 test, near 1 in chaos, near 0 for regular motion",
               WHIRL_PER_POINT, 1, NULL},
    [ROTATION] = {WHIRL_FIELD_REGIME_ROTATION, "1",
                  "turns of a quasi-periodic motion round its curve from one visit to the next", WHIRL_PER_POINT, 1,
                  NULL},
    [NEIGHBOURS] = {WHIRL_FIELD_REGIME_NEIGHBOURS, "revolution",
                    "evidence: median of the revolutions between visits of neighbours on a curve; the period of a "
                    "motion that locks",
                    WHIRL_PER_POINT, 1, NULL},
    [UNLOCKED] = {WHIRL_FIELD_REGIME_UNLOCKED, "revolution",
                  "evidence: a quasi-periodic motion is locked on no period up to this", WHIRL_PER_POINT, 1, NULL},
    [ROUND] = {WHIRL_FIELD_REGIME_ROUND, "revolution",
               "evidence: revolutions of one round of an undetermined motion that drifts along a closed curve",
               WHIRL_PER_POINT, 1, NULL},
    [EXPONENT] = {WHIRL_FIELD_REGIME_EXPONENT, "1/revolution",
                  "evidence: largest Lyapunov exponent, as the verdict uses it", WHIRL_PER_POINT, 1, NULL},
    [EXPONENT_ERROR] = {WHIRL_FIELD_REGIME_EXPONENT_ERROR, "1/revolution",
                        "evidence: error of that exponent, with the difference at a second tolerance", WHIRL_PER_POINT,
                        1, NULL},
    [STEP_GROWTH] = {WHIRL_FIELD_REGIME_STEP_GROWTH, "1",
                     "evidence: growth of a perturbation in one fixed step that the machine does not have: above 1 the "
                     "step is unstable",
                     WHIRL_PER_POINT, 1, NULL},
    [STEP_ERROR] =
        {WHIRL_FIELD_REGIME_STEP_ERROR, "1",
         "evidence: error of a revolution by fixed steps, or by an absolute tolerance that is coarse for the motion, "
         "over the size of the motion",
         WHIRL_PER_POINT, 1, NULL},
    [SWELLING] = {WHIRL_FIELD_REGIME_SWELLING, "1/revolution",
                  "evidence: rate at which the section grows from half to half of the watched revolutions",
                  WHIRL_PER_POINT, 1, NULL},
    [COEXISTING] =
        {WHIRL_FIELD_REGIME_COEXISTING, "revolution",
         "k of a stable P-k near the section of a chaotic motion, -1 for a stable equilibrium, 0 if none was "
         "found, missing without a search",
         WHIRL_PER_POINT, 1, NULL},
    [SURVIVED] = {WHIRL_FIELD_REGIME_SURVIVED, "revolution",
                  "revolutions of all copies of a chaotic motion: without an end they exclude mean lives below a third "
                  "of them; missing without copies",
                  WHIRL_PER_POINT, 1, NULL},
    [ENDED] = {WHIRL_FIELD_REGIME_ENDED, "1", "number of these copies that ended", WHIRL_PER_POINT, 1, NULL},
    [SETTLES] = {WHIRL_FIELD_REGIME_SETTLES, "1", "1: the motion is far from its P-1 and still settles on it; else 0",
                 WHIRL_PER_POINT, 1, NULL},
    [SETTLING] =
        {WHIRL_FIELD_REGIME_SETTLING, "1/revolution",
         "evidence: rate of the slowest multiplier of the linear map of the section, missing without such a map",
         WHIRL_PER_POINT, 1, NULL},
    [SETTLING_ERROR] = {WHIRL_FIELD_REGIME_SETTLING_ERROR, "1/revolution", "evidence: its error", WHIRL_PER_POINT, 1,
                        NULL},
    [LINE] = {WHIRL_FIELD_REGIME_LINE, "1",
              "order of the main line that is at no whole order, of a motion without a verdict by its section",
              WHIRL_PER_POINT, 1, NULL},
    [LINE_SHARE] = {WHIRL_FIELD_REGIME_LINE_SHARE, "1", "amplitude of the main line over the size of the motion",
                    WHIRL_PER_POINT, 1, NULL},
    [LINE_TREND] = {WHIRL_FIELD_REGIME_LINE_TREND, "1/revolution", "rate at which the amplitude of the main line grows",
                    WHIRL_PER_POINT, 1, NULL},
    [SECOND] = {WHIRL_FIELD_REGIME_SECOND, "1",
                "order of the largest line that is no combination of the main line and of whole orders",
                WHIRL_PER_POINT, 1, NULL},
    [SECOND_SHARE] = {WHIRL_FIELD_REGIME_SECOND_SHARE, "1", "amplitude of that second line over the size of the motion",
                      WHIRL_PER_POINT, 1, NULL},
    [SECOND_TREND] = {WHIRL_FIELD_REGIME_SECOND_TREND, "1/revolution",
                      "rate at which the amplitude of that second line grows", WHIRL_PER_POINT, 1, NULL},
    [RESTS] = {WHIRL_FIELD_REGIME_RESTS, "1", "1: the motion rests at a stable equilibrium; else 0", WHIRL_PER_POINT, 1,
               NULL},
    [REST_DISTANCE] = {WHIRL_FIELD_REGIME_REST_DISTANCE, "1",
                       "evidence: largest distance from that equilibrium over the largest coordinate", WHIRL_PER_POINT,
                       1, NULL},
    [REST_ORDER] = {WHIRL_FIELD_REGIME_REST_ORDER, "1",
                    "evidence: frequency of the mode about that equilibrium that decays most slowly, in orders",
                    WHIRL_PER_POINT, 1, NULL},
    [REVOLUTIONS] = {WHIRL_FIELD_REGIME_REVOLUTIONS, "revolution", "revolutions integrated", WHIRL_PER_POINT, 1, NULL},
};

static void put_verdict(const whirl_verdict *v, const block_view *view) {
    const double values[REVOLUTIONS] = {
        [CODE] = v->regime,
        [PERIOD] = v->period,
        [CURVES] = v->curves,
        [FREQUENCIES] = v->frequencies,
        [DIVERGED_AT] = v->diverged_at,
        [LIMIT] = v->limit,
        [LIMIT_COORDINATE] = v->limit_coordinate,
        [CONFIDENCE] = v->confidence,
        [AGREEMENT] = v->agreement,
        [ADVICE] = v->advice.remedy,
        [ADVICE_FACTOR] = v->advice.factor,
        [OTHER_CODE] = v->confirmed ? (double)v->other_regime : (double)NAN,
        [OTHER_PERIOD] = v->confirmed ? (double)v->other_period : (double)NAN,
        [FOLLOWED] = v->followed,
        [LATER_CODE] = v->followed > 0.0 ? (double)v->later_regime : (double)NAN,
        [LATER_PERIOD] = v->followed > 0.0 ? (double)v->later_period : (double)NAN,
        [RECURRENCE] = v->recurrence,
        [RECURRENCE_PERIOD] = v->recurrence_period,
        [LONGEST_PERIOD] = v->longest_period,
        [RECURRENCE_TREND] = v->recurrence_trend,
        [REGULARITY] = v->regularity,
        [CHAOS] = v->chaos,
        [ROTATION] = v->rotation,
        [NEIGHBOURS] = v->neighbours,
        [UNLOCKED] = v->unlocked,
        [ROUND] = v->round,
        [EXPONENT] = v->exponent.value,
        [EXPONENT_ERROR] = v->exponent.error,
        [STEP_GROWTH] = v->step_growth,
        [STEP_ERROR] = v->step_error,
        [SWELLING] = v->swelling,
        [COEXISTING] = v->sought ? (double)v->coexisting : (double)NAN,
        [SURVIVED] = v->survived > 0.0 ? v->survived : (double)NAN,
        [ENDED] = v->survived > 0.0 ? (double)v->ended : (double)NAN,
        [SETTLES] = v->settles,
        [SETTLING] = v->settling.value,
        [SETTLING_ERROR] = v->settling.error,
        [LINE] = v->line,
        [LINE_SHARE] = v->line_share,
        [LINE_TREND] = v->line_trend,
        [SECOND] = v->second,
        [SECOND_SHARE] = v->second_share,
        [SECOND_TREND] = v->second_trend,
        [RESTS] = v->rests,
        [REST_DISTANCE] = v->rest_distance,
        [REST_ORDER] = v->rest_order,
    };
    for (size_t f = 0; f < REVOLUTIONS; f++) {
        double *number = view_numbers(view, f, 0);
        if (number) *number = values[f];
    }
}

static void put_judgement(const whirl_record *record, const block_view *view) {
    const whirl_verdict verdict = whirl_judge(record);
    put_verdict(&verdict, view);
    *view_numbers(view, REVOLUTIONS, 0) = record->revolutions;
}

static whirl_status regime_compute(const whirl_record *record, const whirl_record_options *options,
                                   const block_view *view) {
    (void)options;
    put_judgement(record, view);
    return whirl_ok();
}

const analysis_plan regime_analysis = {.fields = fields,
                                       .field_count = FIELD_COUNT,
                                       .uses_growth = WHIRL_GROWTH_LARGEST,
                                       .compute = regime_compute,
                                       .compute_diverged = put_judgement};

/// Reads a number of a field of this analysis, NaN if the block has none.
static double regime_stored(const whirl_layout *layout, const double *block, const char *name) {
    const whirl_field *field = whirl_layout_field(layout, name);
    return field ? block[field->offset] : NAN;
}

static int regime_whole(double value, int most) {
    return value >= 0.0 && value <= (double)most ? (int)value : 0;
}

const char *whirl_analysis_of_verdicts(void) {
    return "regime";
}

bool whirl_layout_has_verdict(const whirl_layout *layout) {
    return whirl_layout_field(layout, WHIRL_FIELD_REGIME_CODE) != NULL;
}

whirl_verdict whirl_block_verdict(const whirl_layout *layout, const double *block) {
    const double factor = regime_stored(layout, block, WHIRL_FIELD_REGIME_ADVICE_FACTOR);
    const double diverged_at = regime_stored(layout, block, WHIRL_FIELD_REGIME_DIVERGED_AT);
    return (whirl_verdict){
        .regime =
            whirl_layout_has_verdict(layout)
                ? (whirl_regime)regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_CODE), WHIRL_DIVERGING)
                : WHIRL_NOT_JUDGED,
        .period = regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_PERIOD), WHIRL_MAX_PERIOD),
        .curves = regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_CURVES), WHIRL_MAX_PERIOD),
        .frequencies = regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_FREQUENCIES), 3),
        .diverged_at = isnan(diverged_at) ? 0.0 : diverged_at,
        .limit = fmax(regime_stored(layout, block, WHIRL_FIELD_REGIME_LIMIT), 0.0),
        .limit_coordinate = regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_LIMIT_COORDINATE), INT_MAX),
        .confidence =
            (whirl_confidence)regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_CONFIDENCE), WHIRL_HIGH),
        .agreement =
            (whirl_confidence)regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_AGREEMENT), WHIRL_HIGH),
        .advice = {(whirl_remedy)regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_ADVICE),
                                              WHIRL_OTHER_START),
                   factor >= 1.0 ? factor : 1.0},
        .confirmed = !isnan(regime_stored(layout, block, WHIRL_FIELD_REGIME_OTHER_CODE)),
        .other_regime =
            (whirl_regime)regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_OTHER_CODE), WHIRL_DIVERGING),
        .other_period = regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_OTHER_PERIOD), WHIRL_MAX_PERIOD),
        .followed = fmax(regime_stored(layout, block, WHIRL_FIELD_REGIME_FOLLOWED), 0.0),
        .later_regime =
            (whirl_regime)regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_LATER_CODE), WHIRL_DIVERGING),
        .later_period = regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_LATER_PERIOD), WHIRL_MAX_PERIOD),
        .exponent = {regime_stored(layout, block, WHIRL_FIELD_REGIME_EXPONENT),
                     regime_stored(layout, block, WHIRL_FIELD_REGIME_EXPONENT_ERROR)},
        .exponents_failed = regime_stored(layout, block, WHIRL_FIELD_EXPONENTS_FAILED) > 0.5,
        .recurrence = regime_stored(layout, block, WHIRL_FIELD_REGIME_RECURRENCE),
        .recurrence_period =
            regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_RECURRENCE_PERIOD), WHIRL_MAX_PERIOD),
        .longest_period =
            regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_LONGEST_PERIOD), WHIRL_MAX_PERIOD),
        .recurrence_trend = regime_stored(layout, block, WHIRL_FIELD_REGIME_RECURRENCE_TREND),
        .regularity = regime_stored(layout, block, WHIRL_FIELD_REGIME_REGULARITY),
        .chaos = regime_stored(layout, block, WHIRL_FIELD_REGIME_CHAOS),
        .rotation = regime_stored(layout, block, WHIRL_FIELD_REGIME_ROTATION),
        .neighbours = regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_NEIGHBOURS), INT_MAX),
        .unlocked = regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_UNLOCKED), INT_MAX),
        .round = regime_stored(layout, block, WHIRL_FIELD_REGIME_ROUND),
        .orbit = (whirl_orbit_search)regime_whole(regime_stored(layout, block, WHIRL_FIELD_FLOQUET_SEARCH),
                                                  WHIRL_ORBIT_NONE),
        .orbit_period = regime_whole(regime_stored(layout, block, WHIRL_FIELD_FLOQUET_PERIOD), WHIRL_MAX_PERIOD),
        .orbit_residual = regime_stored(layout, block, WHIRL_FIELD_FLOQUET_RESIDUAL),
        .orbit_distance = regime_stored(layout, block, WHIRL_FIELD_FLOQUET_DISTANCE),
        .orbit_modulus = regime_stored(layout, block, WHIRL_FIELD_FLOQUET_MODULUS),
        .step_growth = regime_stored(layout, block, WHIRL_FIELD_REGIME_STEP_GROWTH),
        .step_error = regime_stored(layout, block, WHIRL_FIELD_REGIME_STEP_ERROR),
        .revolutions = fmax(regime_stored(layout, block, WHIRL_FIELD_REGIME_REVOLUTIONS), 0.0),
        .swelling = regime_stored(layout, block, WHIRL_FIELD_REGIME_SWELLING),
        .sought = !isnan(regime_stored(layout, block, WHIRL_FIELD_REGIME_COEXISTING)),
        .coexisting = regime_stored(layout, block, WHIRL_FIELD_REGIME_COEXISTING) == WHIRL_COEXISTING_AT_REST
                          ? WHIRL_COEXISTING_AT_REST
                          : regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_COEXISTING), WHIRL_MAX_PERIOD),
        .survived = fmax(regime_stored(layout, block, WHIRL_FIELD_REGIME_SURVIVED), 0.0),
        .ended = regime_whole(regime_stored(layout, block, WHIRL_FIELD_REGIME_ENDED), INT_MAX),
        .settles = regime_stored(layout, block, WHIRL_FIELD_REGIME_SETTLES) > 0.5,
        .settling = {regime_stored(layout, block, WHIRL_FIELD_REGIME_SETTLING),
                     regime_stored(layout, block, WHIRL_FIELD_REGIME_SETTLING_ERROR)},
        .line = regime_stored(layout, block, WHIRL_FIELD_REGIME_LINE),
        .line_share = regime_stored(layout, block, WHIRL_FIELD_REGIME_LINE_SHARE),
        .line_trend = regime_stored(layout, block, WHIRL_FIELD_REGIME_LINE_TREND),
        .second = regime_stored(layout, block, WHIRL_FIELD_REGIME_SECOND),
        .second_share = regime_stored(layout, block, WHIRL_FIELD_REGIME_SECOND_SHARE),
        .second_trend = regime_stored(layout, block, WHIRL_FIELD_REGIME_SECOND_TREND),
        .rests = regime_stored(layout, block, WHIRL_FIELD_REGIME_RESTS) > 0.5,
        .rest_distance = regime_stored(layout, block, WHIRL_FIELD_REGIME_REST_DISTANCE),
        .rest_order = regime_stored(layout, block, WHIRL_FIELD_REGIME_REST_ORDER),
    };
}

/// Writes a changed verdict to its block.
static void store_verdict(const whirl_layout *layout, double *block, const whirl_verdict *verdict) {
    const block_view view = view_of(&regime_analysis, layout, block);
    put_verdict(verdict, &view);
}

whirl_status whirl_block_seek_coexisting(const whirl_layout *layout, double *block, const whirl_system *system,
                                         const whirl_integrate_options *integrate, const whirl_record *record) {
    whirl_verdict verdict = whirl_block_verdict(layout, block);
    if (verdict.regime != WHIRL_CHAOTIC || verdict.agreement < WHIRL_FAIR) return whirl_ok();
    const whirl_status status = whirl_record_coexisting(system, integrate, record, &verdict.coexisting);
    if (status.code != WHIRL_OK) return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
    verdict.sought = true;
    store_verdict(layout, block, &verdict);
    return status;
}

whirl_status whirl_block_survive(const whirl_layout *layout, double *block, const whirl_system *system,
                                 const whirl_integrate_options *integrate, const whirl_record *record) {
    whirl_verdict verdict = whirl_block_verdict(layout, block);
    whirl_survival found;
    if (verdict.regime != WHIRL_CHAOTIC || verdict.agreement < WHIRL_HIGH || verdict.coexisting != 0) return whirl_ok();
    const whirl_status status = whirl_record_survival(system, integrate, record, verdict.exponent.value, &found);
    if (status.code != WHIRL_OK) return status.code == WHIRL_BAD_INPUT ? whirl_ok() : status;
    verdict.survived = found.revolutions;
    verdict.ended = found.ended;
    store_verdict(layout, block, &verdict);
    const block_view view = view_of(&regime_analysis, layout, block);
    *view_numbers(&view, REVOLUTIONS, 0) += found.cost;
    return status;
}

void whirl_block_confirm(const whirl_layout *layout, double *block, const whirl_verdict *other) {
    whirl_verdict verdict = whirl_block_verdict(layout, block);
    whirl_verdict_confirm(&verdict, other);
    store_verdict(layout, block, &verdict);
}

void whirl_block_follow(const whirl_layout *layout, double *block, const whirl_verdict *later, double revolutions) {
    whirl_verdict verdict = whirl_block_verdict(layout, block);
    whirl_verdict_follow(&verdict, later, revolutions,
                         fmax(regime_stored(layout, block, WHIRL_FIELD_REGIME_REVOLUTIONS), 1.0));
    store_verdict(layout, block, &verdict);
}
