// Verdicts: what regime the evidence supports. Where pieces of evidence contradict each other, or a motion has not
// settled, the answer is "undetermined". See docs/theory.md, "Verdicts".
#include <math.h>
#include <stdbool.h>

#include "lyapunov.h"
#include "section.h"

/// Standard errors by which an exponent must differ from zero.
static const double sigmas = 3.0;

/// Where no disturbance was followed, returns must be as good as rounding allows.
static const double blind_tolerance = 1e-9;

/// How closely the averages of a quasi-periodic motion must agree, and those of chaos may, in decimal digits.
static const double regular_digits = 3.0, irregular_digits = 4.0;

/// Exponents of quasi-periodic motions are zero within this, or within their error.
static const double neutral_exponent = 2e-3;

/// A bound orbit may change its size by this factor between the halves of the section, unless it grows or settles.
static const double steady_factor = 1.6;

/// What whirl_judge weighs.
typedef struct evidence {
    section points;
    size_t record_count;
    recurrence returns;
    regularity averages;
    whirl_estimate exponent; ///< over all watched revolutions
    whirl_estimate late;     ///< over the window of the returns
} evidence;

static evidence gather(const whirl_record *record) {
    evidence e = {.points = {record->section_count, record->dimension, record->section},
                  .record_count = record->record_count,
                  .exponent = whirl_lyapunov_largest(record),
                  .late = {NAN, NAN}};
    e.returns = recurrence_find(&e.points, record->record_count, motion_size(record));
    e.averages = regularity_find(&e.points);
    if (record->growth_count > 0) {
        const size_t window = e.returns.window < record->growth_count ? e.returns.window : record->growth_count;
        e.late = estimate_mean(record->growth + record->growth_count - window, window);
    }
    return e;
}

static bool is_negative(whirl_estimate exponent) {
    return exponent.value + sigmas * exponent.error < 0.0;
}

/// P-k: the motion returns, disturbances die out, and the k points stand clearly further apart than they still have to
/// go. The last tells a period from a slow spiral that is seen stroboscopically: with multipliers mu = r e^(i 2 pi p/k)
/// it returns after k revolutions to within 1 - r^k of its distance to the limit.
static bool is_periodic(const evidence *e, whirl_estimate exponent) {
    if (!(e->returns.distance <= recurrence_tolerance)) return false;
    if (isnan(exponent.value)) return e->returns.distance <= blind_tolerance;
    if (!is_negative(exponent)) return false;
    const double slowest = exponent.value + sigmas * exponent.error;
    const double left_to_go = e->returns.distance / -expm1(slowest * e->returns.period);
    return e->returns.separation > 10.0 * left_to_go;
}

/// The least exponent that the watched revolutions can tell from a slow growth away from some other motion.
static double least_exponent(const evidence *e) {
    return fmax(neutral_exponent, 2.0 / (double)e->points.count);
}

static bool is_chaotic(const evidence *e) {
    return e->exponent.value - sigmas * e->exponent.error > 0.0 && e->exponent.value > least_exponent(e) &&
           e->averages.digits < irregular_digits && e->averages.spread < steady_factor &&
           e->averages.spread > 1.0 / steady_factor && e->returns.distance > recurrence_tolerance;
}

static bool is_neutral(whirl_estimate exponent) {
    return fabs(exponent.value) <= fmax(sigmas * exponent.error, neutral_exponent);
}

static bool may_be_quasi_periodic(const evidence *e) {
    return is_neutral(e->exponent) && e->averages.digits >= regular_digits &&
           e->returns.distance > recurrence_tolerance;
}

whirl_verdict whirl_judge(const whirl_record *record) {
    whirl_verdict verdict = {.exponent = {NAN, NAN}, .recurrence = NAN, .recurrence_trend = NAN, .regularity = NAN};
    if (record->motion != WHIRL_BOUNDED) {
        if (record->motion == WHIRL_DIVERGED) verdict.regime = WHIRL_DIVERGING;
        verdict.diverged_at = record->diverged_at;
        return verdict;
    }
    const evidence e = gather(record);
    verdict.exponent = e.exponent;
    verdict.recurrence = e.returns.distance;
    verdict.recurrence_period = e.returns.period;
    verdict.recurrence_trend = e.returns.trend;
    verdict.regularity = e.averages.digits;
    if (is_periodic(&e, e.late)) {
        verdict.regime = WHIRL_PERIODIC;
        verdict.period = e.returns.period;
        verdict.exponent = is_negative(e.exponent) ? e.exponent : e.late;
    } else if (is_chaotic(&e)) {
        verdict.regime = WHIRL_CHAOTIC;
    } else if (may_be_quasi_periodic(&e)) {
        verdict.curves = curves_count(&e.points);
        if (verdict.curves > 0) verdict.regime = WHIRL_QUASI_PERIODIC;
    }
    return verdict;
}
