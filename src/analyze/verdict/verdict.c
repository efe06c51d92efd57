// Verdicts: the regime that the evidence supports. If pieces of evidence contradict each other, or a motion has not
// settled, the answer is "undetermined". See docs/theory.md, "Verdicts".
#include <math.h>
#include <stdbool.h>

#include "birkhoff.h"
#include "confidence.h"
#include "curves.h"
#include "evidence.h"
#include "locks.h"
#include "main_line.h"
#include "mean_growth.h"
#include "recurrence.h"
#include "rotation.h"
#include "section.h"
#include "settling.h"
#include "settling_map.h"
#include "steps.h"
#include "zero_one.h"

/// Standard errors by which an exponent must differ from zero.
static const double sigmas = 3.0;

/// Return distance that is required without a followed perturbation: near rounding.
static const double blind_tolerance = 1e-9;

/// Decimal digits to which the averages of a quasi-periodic motion must at least agree, and those of chaos may at most.
static const double regular_digits = 2.5, irregular_digits = 6.0;

/// Exponents of this size and below count as zero; largest error of a torus's zero exponent.
static const double least_exponent = 2e-3, neutral_error = 1e-2;

/// Resolution of a quasi-periodic exponent, limited by the finite size of the perturbation.
static const double neutral_rounding = 3e-7;

/// Largest K of the 0-1 test of regular motions.
static const double regular_walk = 0.2;

/// Largest change of size between the halves of the section for a steady motion.
static const double steady_factor = 1.6;

static bool is_negative(whirl_estimate exponent) {
    return exponent.value + sigmas * exponent.error < 0.0;
}

/// Returns the exponent of a motion that returns: over all recorded revolutions or, if the motion settled late, over
/// the revolutions whose returns were compared.
static whirl_estimate returning_exponent(const evidence *e) {
    if (e->growth_count == 0 || e->returns.period == 0) return (whirl_estimate){NAN, NAN};
    const size_t period = (size_t)e->returns.period;
    const whirl_estimate all = estimate_regular_mean(e->growth, e->growth_count, period);
    if (is_negative(all) || e->returns.window >= e->growth_count) return all;
    const size_t before = e->growth_count - e->returns.window;
    return estimate_regular_mean(e->growth + before, e->returns.window, period);
}

/// Returns true if perturbations decay at nearly the same rate in both halves, and enough over the whole record. A
/// drift that slows down near a lock fails: its distance to the lock shrinks as x' = -a x^2, and the rate of
/// perturbations, r = 2 a x, falls by the factor 1/(1 + r t/2).
static bool dies_out_evenly(const evidence *e, size_t period) {
    const double share = 0.2, folds = 2.0;
    const size_t half = e->growth_count / 2;
    if (half < 2 * period) return false;
    const whirl_estimate early = estimate_regular_mean(e->growth, half, period),
                         late = estimate_regular_mean(e->growth + e->growth_count - half, half, period);
    // The halves' errors are not used: they are large where a rate changes.
    return is_negative(early) && is_negative(late) && fabs(early.value - late.value) <= share * fabs(late.value) &&
           -late.value * (double)e->growth_count >= folds;
}

/// Returns true for P-k: the motion returns, perturbations decay, and the k points are clearly further apart than their
/// remaining distance to the limit. The last condition excludes a slow spiral seen stroboscopically: with multipliers r
/// e^(+-i 2 pi p/k) it returns after k revolutions to within 1 - r^k of its distance to the limit.
///
/// A motion that does not return so closely yet is P-k, too, under two conditions. First, a map which shortens all
/// distances at the same rate can move it no further than a small part of its size (Banach's fixed point theorem).
/// Second, the map is the same over this part: it shortens distances alike in both halves of the record. The second
/// condition is also required of a motion that returns and has far to go, since drifts past a nearby lock slow down as
/// if they settled, but shorten distances less and less.
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

/// Returns true if perturbations still grow, or at least do not clearly decay, in the last revolutions: a motion that
/// was chaotic and then settled on a periodic one is not chaotic.
static bool grows_to_the_end(const evidence *e) {
    const size_t window = e->returns.window < e->growth_count ? e->returns.window : e->growth_count;
    const whirl_estimate late = estimate_mean(e->growth + e->growth_count - window, window);
    return late.value + late.error > 0.0;
}

/// Returns true if the motion may be growing away from a nearby motion: the growth over the record is small enough to
/// have begun at the start, and K of the 0-1 test is that of regular motion.
static bool may_be_leaving(const evidence *e) {
    const double most_folds = 10.0;
    return e->exponent.value * (double)e->points.count < most_folds &&
           zero_one_test(&e->points, e->size) <= regular_walk;
}

/// Returns true for chaos: perturbations grow, faster than a slow departure from some other motion would explain over
/// the recorded revolutions, and the motion is steady but not regular.
static bool is_chaotic(const evidence *e) {
    const double least = fmax(least_exponent, 2.0 / (double)e->points.count);
    return e->growth_count > 0 && e->exponent.value > fmax(least, sigmas * e->exponent.error) &&
           e->returns.distance > recurrence_tolerance && e->averages.digits < irregular_digits &&
           fabs(log(e->averages.spread)) < log(steady_factor) && grows_to_the_end(e) && !may_be_leaving(e);
}

/// Returns true for a sharp exponent of zero.
static bool is_neutral(whirl_estimate exponent) {
    return fabs(exponent.value) <= sigmas * exponent.error + neutral_rounding && exponent.error <= neutral_error;
}

/// Returns true if the motion is quasi-periodic, without regard to curves: regular but never returning, with
/// perturbations that neither grow nor decay. They may decay if a phase drives the motion that does not repeat after
/// whole revolutions.
static bool may_be_quasi_periodic(const evidence *e) {
    if (e->growth_count == 0) return false;
    const whirl_estimate exponent = estimate_regular_mean(e->growth, e->growth_count, 1);
    return (is_neutral(exponent) || (e->forced && is_negative(exponent))) && e->averages.digits >= regular_digits &&
           e->returns.distance > recurrence_tolerance;
}

/// Returns the revolutions per round of a drift along a curve, on which perturbations certainly neither grow nor decay.
static double slow_round(const evidence *e, double chaos) {
    const bool neutral = fabs(e->exponent.value) <= fmax(sigmas * e->exponent.error, least_exponent);
    return neutral && chaos <= regular_walk ? drift_round(&e->points, &e->returns, e->size) : (double)NAN;
}

/// Starts a verdict from the returns of the section.
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
                           .second = NAN,
                           .second_share = NAN,
                           .second_trend = NAN,
                           .rest_distance = NAN,
                           .rest_order = NAN};
}

static whirl_verdict open_verdict(const evidence *e) {
    whirl_verdict v = verdict_on(e, WHIRL_UNDETERMINED, e->exponent);
    v.chaos = zero_one_test(&e->points, e->size);
    v.round = slow_round(e, v.chaos);
    return v;
}

/// Gives P-1 to a motion far from its limit whose section follows a linear map that leads there, unless the
/// perturbation contradicts it.
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

/// Judges a motion by its spectrum if the section is inconclusive. It is quasi-periodic if perturbations do not grow,
/// and the lines of one or two frequencies and of the shaft make up the whole motion and stay as they are over the
/// record; else undetermined.
static whirl_verdict line_verdict(const evidence *e, const whirl_record *record, whirl_verdict open) {
    const double clear = 0.01; // nearer returns may settle on a lock
    const main_line line = main_line_find(record);
    // Frequencies that change with amplitudes let perturbations of a torus grow in proportion to time: by n in n
    // revolutions.
    const double n = (double)e->points.count, least = fmax(least_exponent, log(n) / n);
    const bool grows = e->growth_count > 0 && e->exponent.value > fmax(least, sigmas * e->exponent.error);
    open.line = line.order;
    open.line_share = line.share;
    open.line_trend = line.trend;
    open.second = line.second;
    open.second_share = line.second_share;
    open.second_trend = line.second_trend;
    if (isnan(line.order) || grows || e->exponents_failed || !(e->returns.distance > clear)) return open;
    const bool moves = fabs(open.settling.value) > 2.0 * sigmas * open.settling.error;
    if (moves || !main_line_stays(&line, record)) return open;
    open.regime = WHIRL_QUASI_PERIODIC;
    open.frequencies = line.frequencies;
    return open;
}

static whirl_verdict periodic_verdict(const evidence *e, whirl_estimate exponent) {
    whirl_verdict v = verdict_on(e, WHIRL_PERIODIC, exponent);
    v.period = e->returns.period;
    return v;
}

/// Returns true at rest: the equilibrium attracts the motion, and no perturbed copy contradicts it. (Steps that do not
/// resolve perturbations may not resolve the motion either.)
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

/// Returns true if the averages over both halves agree as closely as only those of smooth tori (of any dimension),
/// nothing slows down, and the motion stays clear of its earlier points. Motions that almost return may be periodic or
/// drift past a lock.
static bool is_smooth(const whirl_verdict *v) {
    const double digits = 8.0, trend = 0.1, clear = 0.01;
    return v->regularity >= digits && v->chaos <= regular_walk && v->recurrence > clear &&
           fabs(log(v->recurrence_trend)) <= trend;
}

/// Judges a regular motion. If a phase that does not repeat after whole revolutions drives it, and perturbations decay,
/// it has two frequencies, that phase's and the shaft's. Closed curves with a rotation number are two frequencies, too.
/// Without a rotation number the second exponent decides. If it is zero, the section is a surface, and there are three
/// frequencies. If it is neither zero nor clearly negative, the number of frequencies stays open for a single curve,
/// and for averages that agree as only those of smooth tori do. In all other cases curves mean two frequencies, and
/// without curves the motion is undetermined.
static whirl_verdict regular_verdict(const evidence *e) {
    whirl_verdict verdict = open_verdict(e);
    verdict.exponent = estimate_regular_mean(e->growth, e->growth_count, 1);
    // A phase that does not repeat after whole revolutions drives the motion.
    if (e->forced && is_negative(verdict.exponent)) {
        verdict.regime = WHIRL_QUASI_PERIODIC;
        verdict.frequencies = 2;
        return verdict;
    }
    // Search closed curves, and the rotation number on them.
    const closed_curves found = curves_find(&e->points);
    verdict.curves = found.count;
    verdict.neighbours = found.neighbours;
    if (found.count > 0) {
        verdict.regime = WHIRL_QUASI_PERIODIC;
        verdict.rotation = rotation_number(&e->points, found.count);
        verdict.unlocked = locks_excluded(&e->points, &found, verdict.rotation);
        verdict.frequencies = 2;
    }
    // No rotation number: three frequencies, or an uncounted number of them.
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

/// Notes failed exponents: steps that do not resolve perturbations may not resolve the motion either.
static void verdict_distrust(whirl_verdict *verdict) {
    verdict->exponents_failed = true;
    verdict->agreement = verdict->confidence = WHIRL_LOW;
    verdict->advice = (whirl_advice){WHIRL_TIGHTER, 256.0};
}

/// Takes the result of an orbit search. The returns of a motion that was put on the orbit are only as good as the
/// closing error of the orbit.
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
    // Gather the evidence of the whole record and of its second half.
    const evidence all = evidence_gather(record), later = evidence_later_half(&all);
    const whirl_estimate returning = returning_exponent(&all);
    const evidence *e = &all;
    whirl_verdict verdict;
    // Take the first verdict whose conditions hold.
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
    // Use slower evidence if the fast evidence gives no regime.
    if (verdict.regime == WHIRL_UNDETERMINED) verdict = slow_verdict(&all, verdict);
    if (verdict.regime == WHIRL_UNDETERMINED) verdict = line_verdict(&all, record, verdict);
    // Weigh the verdict with the orbit that was found.
    take_orbit(&verdict, &record->orbit);
    weigh_verdict(&verdict, e, record);
    if (all.exponents_failed) verdict_distrust(&verdict);
    return verdict;
}

/// Weighs a divergence. A method with fixed steps that are far too long diverges at once; a later divergence is the
/// machine's.
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
                           .second = NAN,
                           .second_share = NAN,
                           .second_trend = NAN,
                           .rest_distance = NAN,
                           .rest_order = NAN};
}

whirl_verdict whirl_judge(const whirl_record *record) {
    whirl_verdict verdict = record->motion == WHIRL_BOUNDED ? judge_bounded(record) : judge_unbounded(record);
    steps_weigh(&verdict, &record->steps);
    verdict.revolutions = record->revolutions;
    return verdict;
}
