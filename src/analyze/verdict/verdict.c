// Verdicts: what regime the evidence supports. Where pieces of evidence contradict each other, or a motion has not
// settled, the answer is "undetermined". See docs/theory.md, "Verdicts".
#include <math.h>
#include <stdbool.h>

#include "analysis.h"
#include "record.h"
#include "section.h"

/// Standard errors by which an exponent must differ from zero.
static const double sigmas = 3.0;

/// Where no perturbation was followed, returns must be as good as rounding allows.
static const double blind_tolerance = 1e-9;

/// How closely the averages of a quasi-periodic motion must agree, and those of chaos may, in decimal digits.
static const double regular_digits = 2.5, irregular_digits = 6.0;

/// Exponents of this size and below are not told from zero; how well the exponent of a torus must be known to be zero.
static const double least_exponent = 2e-3, neutral_error = 1e-2;

/// A quasi-periodic exponent is zero within its error and this, to which a perturbation of finite size is followed.
static const double neutral_rounding = 3e-7;

/// K of the 0-1 test of motions that do not walk at random.
static const double regular_walk = 0.2;

/// A bound orbit may change its size by this factor between the halves of the section, unless it grows or settles.
static const double steady_factor = 1.6;

static bool is_negative(whirl_estimate exponent) {
    return exponent.value + sigmas * exponent.error < 0.0;
}

/// The exponent of a motion that returns: over all watched revolutions or, where the motion settled late, over those
/// whose returns were compared.
static whirl_estimate returning_exponent(const evidence *e) {
    if (e->growth_count == 0 || e->returns.period == 0) return (whirl_estimate){NAN, NAN};
    const size_t period = (size_t)e->returns.period;
    const whirl_estimate all = estimate_regular_mean(e->growth, e->growth_count, period);
    if (is_negative(all) || e->returns.window >= e->growth_count) return all;
    const size_t before = e->growth_count - e->returns.window;
    return estimate_regular_mean(e->growth + before, e->returns.window, period);
}

/// Whether perturbations die out alike in both halves, and by so much in all that those of a drift that slows down
/// would not: where the distance to a lock that is almost there shrinks as x' = -a x^2, their rate r = 2 a x falls by
/// 1/(1 + r t/2).
static bool dies_out_evenly(const evidence *e, size_t period) {
    const double share = 0.2, folds = 2.0;
    const size_t half = e->growth_count / 2;
    if (half < 2 * period) return false;
    const whirl_estimate early = estimate_regular_mean(e->growth, half, period),
                         late = estimate_regular_mean(e->growth + e->growth_count - half, half, period);
    // No share of their errors, which are large where a rate changes.
    return is_negative(early) && is_negative(late) && fabs(early.value - late.value) <= share * fabs(late.value) &&
           -late.value * (double)e->growth_count >= folds;
}

/// P-k: the motion returns, perturbations die out, and the k points stand clearly further apart than they still have to
/// go. The last tells a period from a slow spiral that is seen stroboscopically: with multipliers r e^(+-i 2 pi p/k)
/// it returns after k revolutions to within 1 - r^k of its distance to the limit.
///
/// A motion that does not return as well yet is P-k, too, where a map that shortens all distances by so much cannot
/// lead it further than this part of its size (Banach's fixed point), over which the map is the same: it shortens them
/// alike in both halves of what was watched. That is asked, too, of one that returns and has far to go: past a lock
/// that is almost there, drifts slow down as if they settled, and distances shorten less and less.
static bool is_periodic(const evidence *e, whirl_estimate exponent) {
    const double nearest = 1e-4;
    if (e->growth_count == 0) return e->returns.distance <= blind_tolerance;
    if (!(e->returns.distance <= nearest) || !is_negative(exponent)) return false;
    const double slowest = exponent.value + sigmas * exponent.error;
    const double left_to_go = e->returns.distance / -expm1(slowest * e->returns.period);
    const bool evenly = dies_out_evenly(e, (size_t)e->returns.period);
    if (e->returns.distance <= recurrence_tolerance)
        return e->returns.separation > 10.0 * left_to_go && (left_to_go <= nearest || evenly);
    return left_to_go <= nearest && e->returns.separation > 100.0 * left_to_go && evenly;
}

/// Whether perturbations still grow, or at least do not clearly die out, in the last revolutions: a motion that was
/// chaotic and then fell onto a periodic one is not chaotic.
static bool grows_to_the_end(const evidence *e) {
    const size_t window = e->returns.window < e->growth_count ? e->returns.window : e->growth_count;
    const whirl_estimate late = estimate_mean(e->growth + e->growth_count - window, window);
    return late.value + late.error > 0.0;
}

/// Whether a motion may grow away from one that it was close to, by a factor that a start can explain: it walks at
/// random no more than regular motions do.
static bool may_be_leaving(const evidence *e) {
    const double most_folds = 10.0;
    return e->exponent.value * (double)e->points.count < most_folds &&
           zero_one_test(&e->points, e->size) <= regular_walk;
}

/// Chaos: perturbations grow, faster than a slow departure from some other motion would explain over the watched
/// revolutions, and the motion is steady but not regular.
static bool is_chaotic(const evidence *e) {
    const double least = fmax(least_exponent, 2.0 / (double)e->points.count);
    return e->growth_count > 0 && e->exponent.value > fmax(least, sigmas * e->exponent.error) &&
           e->returns.distance > recurrence_tolerance && e->averages.digits < irregular_digits &&
           fabs(log(e->averages.spread)) < log(steady_factor) && grows_to_the_end(e) && !may_be_leaving(e);
}

/// A sharp exponent of zero.
static bool is_neutral(whirl_estimate exponent) {
    return fabs(exponent.value) <= sigmas * exponent.error + neutral_rounding && exponent.error <= neutral_error;
}

/// Quasi-periodic, up to the curves: the motion is regular but never returns, and perturbations neither grow nor die
/// out; where a phase forces it that fits no revolution they may die out.
static bool may_be_quasi_periodic(const evidence *e) {
    if (e->growth_count == 0) return false;
    const whirl_estimate exponent = estimate_regular_mean(e->growth, e->growth_count, 1);
    return (is_neutral(exponent) || (e->forced && is_negative(exponent))) && e->averages.digits >= regular_digits &&
           e->returns.distance > recurrence_tolerance;
}

/// Revolutions once round the curve of what drifts along one: perturbations neither grow nor die out for certain.
static double slow_round(const evidence *e, double chaos) {
    const bool neutral = fabs(e->exponent.value) <= fmax(sigmas * e->exponent.error, least_exponent);
    return neutral && chaos <= regular_walk ? drift_round(&e->points, &e->returns, e->size) : (double)NAN;
}

/// What the returns of the section tell, as part of a verdict.
static whirl_verdict verdict_on(const evidence *e, whirl_regime regime, whirl_estimate exponent) {
    return (whirl_verdict){.regime = regime,
                           .exponent = exponent,
                           .recurrence = e->returns.distance,
                           .recurrence_period = e->returns.period,
                           .longest_period = e->returns.longest,
                           .recurrence_trend = e->returns.trend,
                           .regularity = e->averages.digits,
                           .chaos = NAN,
                           .round = NAN,
                           .rotation = NAN,
                           .swelling = log(e->averages.spread) / (0.5 * (double)e->points.count),
                           .settling = {NAN, NAN},
                           .line = NAN,
                           .line_share = NAN,
                           .line_trend = NAN,
                           .rest_distance = NAN,
                           .rest_order = NAN};
}

static whirl_verdict open_verdict(const evidence *e) {
    whirl_verdict v = verdict_on(e, WHIRL_UNDETERMINED, e->exponent);
    v.chaos = zero_one_test(&e->points, e->size);
    v.round = slow_round(e, v.chaos);
    return v;
}

/// P-1 where the motion still has far to go, but the section follows a linear map that leads there. What the
/// perturbation says must not contradict it.
static whirl_verdict slow_verdict(const evidence *e, whirl_verdict open) {
    const settling_map map = settling_map_find(&e->points, e->size, e->rounding);
    const bool grows = e->growth_count > 0 && e->exponent.value > sigmas * e->exponent.error + least_exponent;
    open.settling = map.rate;
    if (e->forced || e->exponents_failed || grows || !settling_map_leads_to_rest(&map)) return open;
    open.regime = WHIRL_PERIODIC;
    open.period = 1;
    open.settles = true;
    return open;
}

/// What the spectrum says of a motion whose section does not tell what it is: quasi-periodic where one line and the
/// shaft's make up all of it, as they are from half to half, and perturbations do not grow; else it stays open.
static whirl_verdict line_verdict(const evidence *e, const whirl_record *record, whirl_verdict open) {
    const double clear = 0.01; // of where it was: nearer it may come to rest on a lock
    const main_line line = main_line_find(record);
    const bool grows = e->growth_count > 0 && e->exponent.value > fmax(least_exponent, sigmas * e->exponent.error);
    open.line = line.order;
    open.line_share = line.share;
    open.line_trend = line.trend;
    if (isnan(line.order) || grows || e->exponents_failed || !(e->returns.distance > clear)) return open;
    const bool moves = fabs(open.settling.value) > 2.0 * sigmas * open.settling.error;
    if (moves || !main_line_stays(&line, record)) return open;
    open.regime = WHIRL_QUASI_PERIODIC;
    open.frequencies = 2;
    return open;
}

static whirl_verdict periodic_verdict(const evidence *e, whirl_estimate exponent) {
    whirl_verdict v = verdict_on(e, WHIRL_PERIODIC, exponent);
    v.period = e->returns.period;
    return v;
}

/// Rest: the equilibrium draws in what is so near, and no perturbation beside the motion says otherwise. (Steps
/// that do not carry perturbations may carry the motion no better.)
static bool is_at_rest(const evidence *e, const whirl_record_rest *rest) {
    const bool grows = e->growth_count > 0 && e->exponent.value > sigmas * e->exponent.error;
    return rest->found && !e->exponents_failed && !grows && -expm1(rest->growth) > 10.0 * rest->distance;
}

static whirl_verdict resting_verdict(const evidence *e, const whirl_record_rest *rest) {
    const double rounding = 1e-9; // of eigenvalues
    whirl_verdict v = verdict_on(e, WHIRL_PERIODIC, (whirl_estimate){rest->growth, rounding * fabs(rest->growth)});
    v.period = 1;
    v.rests = true;
    v.rest_distance = rest->distance;
    v.rest_order = rest->order;
    return v;
}

/// Whether averages over both halves agree as they do on smooth tori alone, of whatever dimension, nothing slows down,
/// and the motion stays clear of where it was: what all but returns may do so, or drift past a lock.
static bool is_smooth(const whirl_verdict *v) {
    const double digits = 8.0, trend = 0.1, clear = 0.01;
    return v->regularity >= digits && v->chaos <= regular_walk && v->recurrence > clear &&
           fabs(log(v->recurrence_trend)) <= trend;
}

/// What a phase forces that fits no revolution, and perturbations die out, is a torus of at least that phase and the
/// shaft's. Else closed curves are looked for; without them it stays open, but for a torus of three frequencies: its
/// section is a surface, and two exponents are zero, or averages agree as on nothing else. What goes round a single
/// curve that is not smooth may be such a torus, unless a second exponent is clearly below zero: then it is not
/// counted. Several that are visited in turn are.
static whirl_verdict regular_verdict(const evidence *e) {
    whirl_verdict verdict = open_verdict(e);
    verdict.exponent = estimate_regular_mean(e->growth, e->growth_count, 1);
    if (e->forced && is_negative(verdict.exponent)) {
        verdict.regime = WHIRL_QUASI_PERIODIC;
        verdict.frequencies = 2;
        return verdict;
    }
    const closed_curves found = curves_find(&e->points);
    verdict.curves = found.count;
    verdict.neighbours = found.neighbours;
    if (found.count > 0) {
        verdict.regime = WHIRL_QUASI_PERIODIC;
        verdict.rotation = rotation_number(&e->points, found.count);
        verdict.unlocked = locks_excluded(&e->points, &found, verdict.rotation);
        verdict.frequencies = 2;
    }
    if (!isnan(verdict.rotation) || is_negative(e->second)) return verdict;
    if (is_neutral(e->second)) {
        verdict.regime = WHIRL_QUASI_PERIODIC;
        verdict.curves = 0;
        verdict.frequencies = 3;
    } else if (verdict.curves == 1 || (verdict.curves == 0 && is_smooth(&verdict))) {
        verdict.regime = WHIRL_QUASI_PERIODIC;
        verdict.curves = 0;
        verdict.frequencies = 0;
    }
    return verdict;
}

static whirl_verdict chaotic_verdict(const evidence *e) {
    whirl_verdict verdict = open_verdict(e);
    verdict.regime = WHIRL_CHAOTIC;
    return verdict;
}

/// Steps that do not carry perturbations may carry the motion no better.
static void distrust(whirl_verdict *verdict) {
    verdict->exponents_failed = true;
    verdict->agreement = verdict->confidence = WHIRL_LOW;
    verdict->advice = (whirl_advice){WHIRL_TIGHTER, 256.0};
}

/// What a search for the orbit says; returns of a motion that was set upon it are no better than it closes.
static void take_orbit(whirl_verdict *verdict, const whirl_record_orbit *orbit) {
    const bool found = orbit->multiplier_count > 0;
    verdict->orbit = orbit->search;
    verdict->orbit_period = found ? orbit->period : 0;
    verdict->orbit_residual = found ? orbit->residual : (double)NAN;
    verdict->orbit_distance = found ? orbit->distance : (double)NAN;
    verdict->orbit_modulus = found ? orbit->modulus : (double)NAN;
    if (orbit->set_at > 0.0) verdict->recurrence = fmax(verdict->recurrence, orbit->distance);
}

static whirl_verdict judge_bounded(const whirl_record *record) {
    const evidence all = evidence_gather(record), later = evidence_later_half(&all);
    const whirl_estimate returning = returning_exponent(&all);
    const evidence *e = &all;
    whirl_verdict verdict;
    if (is_at_rest(&all, &record->rest)) {
        verdict = resting_verdict(&all, &record->rest);
    } else if (is_periodic(&all, returning)) {
        verdict = periodic_verdict(&all, returning);
    } else if (is_chaotic(&all)) {
        verdict = chaotic_verdict(&all);
    } else if (may_be_quasi_periodic(&all)) {
        verdict = regular_verdict(&all);
    } else if (is_chaotic(&later)) {
        e = &later;
        verdict = chaotic_verdict(&later);
    } else {
        verdict = open_verdict(&all);
    }
    if (verdict.regime == WHIRL_UNDETERMINED) verdict = slow_verdict(&all, verdict);
    if (verdict.regime == WHIRL_UNDETERMINED) verdict = line_verdict(&all, record, verdict);
    take_orbit(&verdict, &record->orbit);
    weigh_verdict(&verdict, e, record);
    if (all.exponents_failed) distrust(&verdict);
    return verdict;
}

/// A method with fixed steps that are far too long throws a motion out at once; only what takes longer to leave has
/// shown that the machine does it.
static whirl_confidence weigh_diverged(const whirl_record *record) {
    const double at_once = 2.0;
    return record->diverged_at > at_once ? WHIRL_HIGH : WHIRL_FAIR;
}

static whirl_verdict judge_unbounded(const whirl_record *record) {
    const bool diverged = record->motion == WHIRL_DIVERGED;
    return (whirl_verdict){.regime = diverged ? WHIRL_DIVERGING : WHIRL_UNDETERMINED,
                           .diverged_at = record->diverged_at,
                           .limit = record->limit,
                           .limit_coordinate = (int)record->limit_coordinate,
                           .confidence = diverged ? WHIRL_FAIR : WHIRL_LOW,
                           .agreement = diverged ? weigh_diverged(record) : WHIRL_LOW,
                           .advice =
                               diverged ? (whirl_advice){WHIRL_NO_REMEDY, 1.0} : (whirl_advice){WHIRL_TIGHTER, 16.0},
                           .exponent = {NAN, NAN},
                           .recurrence = NAN,
                           .recurrence_trend = NAN,
                           .regularity = NAN,
                           .chaos = NAN,
                           .round = NAN,
                           .rotation = NAN,
                           .swelling = NAN,
                           .settling = {NAN, NAN},
                           .line = NAN,
                           .line_share = NAN,
                           .line_trend = NAN,
                           .rest_distance = NAN,
                           .rest_order = NAN};
}

whirl_verdict whirl_judge(const whirl_record *record) {
    whirl_verdict verdict = record->motion == WHIRL_BOUNDED ? judge_bounded(record) : judge_unbounded(record);
    steps_weigh(&verdict, &record->steps);
    verdict.revolutions = record->revolutions;
    return verdict;
}
