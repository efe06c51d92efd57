// Confidence of a verdict: agreement between the pieces of evidence, and between two tolerances.
#include "confidence.h"

#include <limits.h>
#include <math.h>

#include "birkhoff.h"
#include "evidence.h"
#include "locks.h"
#include "mean_growth.h"
#include "multiplier.h"
#include "recurrence.h"
#include "section.h"

/// Largest remaining distance to the limit, over its size, of a settled motion.
static const double settled = 1e-6;

/// Numbers of standard errors. clear_sigmas: by which an exponent must at least differ from zero. steady_sigmas: by
/// which halves of a record may at most differ. line_sigmas: an exponent above these casts doubt on a motion of steady
/// lines.
static const double clear_sigmas = 6.0, steady_sigmas = 4.0, line_sigmas = 3.0;

/// regular_digits, irregular_digits: decimal digits to which averages at least agree on clear tori, and at most in
/// clear chaos. regular_walk, random_walk: K of the 0-1 test for regular motion and for chaos; middle: the value
/// between.
static const double regular_digits = 4.0, irregular_digits = 3.0, regular_walk = 0.2, random_walk = 0.8, middle = 0.5;

/// Revolutions that establish chaos, and the exponent that excludes a slow departure from another motion.
static const double enough_watched = 500.0, strong_exponent = 0.01;

/// Exponents that differ by less are equal.
static const double least_difference = 1e-3;

/// Least and largest factor by which a longer run is advised, and the factor without evidence.
static const double least_factor = 1.5, largest_factor = 100.0, usual_factor = 4.0;

static bool is_clear(whirl_estimate exponent) {
    return fabs(exponent.value) > clear_sigmas * exponent.error;
}

/// Returns the remaining distance of a returning motion from its limit, over the motion's size, as the exponent
/// predicts it.
static double left_to_go(const whirl_verdict *v, const evidence *e) {
    if (v->recurrence <= e->rounding) return 0.0;
    const double slowest = v->exponent.value + clear_sigmas * v->exponent.error;
    return slowest < 0.0 ? v->recurrence / -expm1(slowest * v->recurrence_period) : INFINITY;
}

/// Returns true if the motion visibly settles more slowly than the exponent implies.
static bool returns_contradict(const whirl_verdict *v, const evidence *e) {
    const multiplier m = multiplier_find(&e->points, v->period, e->size, e->rounding);
    const double rate = log(hypot(m.real, m.imaginary)) / v->period; // NaN if it is not visible
    return rate > v->exponent.value + 0.1 * fabs(v->exponent.value) + clear_sigmas * v->exponent.error;
}

/// Weighs returns and exponent alone.
static whirl_confidence weigh_returns(const whirl_verdict *v, const evidence *e) {
    const bool clear = is_clear(v->exponent) && left_to_go(v, e) <= settled && !returns_contradict(v, e);
    return clear && e->returns.separation >= 100.0 * left_to_go(v, e) ? WHIRL_HIGH : WHIRL_FAIR;
}

/// Returns true if the motion is on the P-k orbit that was found, within its domain of attraction.
static bool orbit_holds(const whirl_verdict *v, const evidence *e) {
    const double much = 100.0, at_rest = 10.0 * recurrence_tolerance, off = fmax(v->recurrence, v->orbit_distance);
    return v->orbit == WHIRL_ORBIT_STABLE && v->orbit_period == v->period && off <= at_rest &&
           e->returns.separation >= much * off && 1.0 - v->orbit_modulus > much * off;
}

/// Weighs a periodic verdict. A stable orbit at the motion raises its confidence. An orbit that is unstable, elsewhere
/// or of another period lowers the confidence to the least one. If no orbit was found, the confidence drops by a step.
static whirl_confidence weigh_periodic(const whirl_verdict *v, const evidence *e) {
    const whirl_confidence alone = v->settles ? WHIRL_FAIR : weigh_returns(v, e);
    switch (v->orbit) {
    case WHIRL_ORBIT_STABLE:
        if (orbit_holds(v, e)) return WHIRL_HIGH;
        return v->orbit_period == v->period ? alone : WHIRL_LOW;
    case WHIRL_ORBIT_UNSTABLE:
    case WHIRL_ORBIT_ELSEWHERE:
        return WHIRL_LOW;
    case WHIRL_ORBIT_NONE:
        return alone == WHIRL_HIGH ? WHIRL_FAIR : WHIRL_LOW;
    case WHIRL_ORBIT_UNSOUGHT:
        break;
    }
    return alone;
}

/// Returns the exponent by which a motion without a verdict settles, or NaN if the exponent is not sharp.
static double settling_exponent(const evidence *e) {
    if (e->growth_count == 0) return NAN;
    const whirl_estimate sharp = estimate_regular_mean(e->growth, e->growth_count, 1);
    return is_clear(sharp) && sharp.value < 0.0 ? sharp.value : NAN;
}

/// Weighs a verdict of rest. The equilibrium attracts the motion if a revolution shortens distances by a share of at
/// least 100 times the motion's relative distance from it. A perturbed copy that decays excludes a small cycle there.
/// (Rounding and errors of steps limit the visible decay.)
static whirl_confidence weigh_rest(const whirl_verdict *v, const evidence *e) {
    const double slowest = fmax(0.5 * v->exponent.value, -0.1), sharp = settling_exponent(e);
    const bool draws_in = -expm1(v->exponent.value) >= 100.0 * v->rest_distance;
    const bool dies_out = sharp < slowest || (is_clear(e->exponent) && e->exponent.value < slowest);
    return draws_in && dies_out ? WHIRL_HIGH : WHIRL_FAIR;
}

/// Returns true if the motion may be settling on a locked motion.
static bool slows_down(const whirl_verdict *v) {
    const double steady_trend = 0.95;
    return v->exponent.value < -v->exponent.error || v->recurrence_trend < steady_trend;
}

static whirl_confidence weigh_quasi_periodic(const whirl_verdict *v, const evidence *e) {
    const bool grows = v->exponent.value > line_sigmas * v->exponent.error + least_difference;
    if (v->line > 0.0) return v->chaos <= regular_walk && !grows ? WHIRL_FAIR : WHIRL_LOW;
    const bool forced = v->curves == 0 && v->frequencies == 2;
    if (forced) return v->chaos > middle ? WHIRL_LOW : WHIRL_FAIR;
    const bool may_lock = v->frequencies < 3 && v->unlocked < longest_lock(&e->points, v->curves);
    if (v->chaos > middle || (may_lock && slows_down(v))) return WHIRL_LOW;
    const bool regular = v->regularity >= regular_digits && v->chaos <= regular_walk && !isnan(v->rotation);
    return regular && !may_lock ? WHIRL_HIGH : WHIRL_FAIR;
}

/// Returns true if perturbations grow alike in both halves.
static bool grows_steadily(const evidence *e) {
    const size_t half = e->growth_count / 2;
    const whirl_estimate early = estimate_mean(e->growth, half), late = estimate_mean(e->growth + half, half);
    const double error = hypot(early.error, late.error);
    return early.value > 0.0 && late.value > 0.0 && fabs(early.value - late.value) <= steady_sigmas * error;
}

static whirl_confidence weigh_chaotic(const whirl_verdict *v, const evidence *e) {
    if (!(v->chaos > regular_walk)) return WHIRL_LOW;
    const bool strong = is_clear(v->exponent) && v->exponent.value >= strong_exponent && grows_steadily(e);
    const bool irregular = v->chaos >= random_walk && v->regularity < irregular_digits;
    return strong && irregular && (double)e->points.count >= enough_watched ? WHIRL_HIGH : WHIRL_FAIR;
}

static whirl_confidence confidence_weigh(const whirl_verdict *v, const evidence *e) {
    switch (v->regime) {
    case WHIRL_PERIODIC:
        return v->rests ? weigh_rest(v, e) : weigh_periodic(v, e);
    case WHIRL_QUASI_PERIODIC:
        return weigh_quasi_periodic(v, e);
    case WHIRL_CHAOTIC:
        return weigh_chaotic(v, e);
    case WHIRL_DIVERGING:
    case WHIRL_UNDETERMINED:
    case WHIRL_NOT_JUDGED:
        break;
    }
    return WHIRL_LOW;
}

static double bounded_factor(double factor) {
    return fmin(fmax(factor, least_factor), largest_factor);
}

/// Returns a factor for the run's length which reduces the remaining transient to a tenth of what counts as settled.
/// The transient is taken to shrink with the rate of the returns or with the exponent, whichever is slower.
static double settling_factor(const whirl_verdict *v, const evidence *e, const whirl_record *record) {
    const double by_returns = settling_rate(e);
    const double by_exponent = settling_exponent(e);
    double rate = by_returns < 0.0 ? by_returns : by_exponent;
    if (by_exponent > rate) rate = by_exponent;
    if (!(rate < 0.0)) return usual_factor;
    const double left = v->recurrence / -expm1(rate * fmax(v->recurrence_period, 1.0));
    const double needed = log(fmax(left / (0.1 * settled), 1.0)) / -rate;
    return bounded_factor(1.0 + needed / record->revolutions);
}

/// Returns a factor for the length of a run that settles by the linear map of its section, at the map's rate. The
/// remaining distance is taken to be as large as the motion.
static double slow_factor(const whirl_verdict *v, const whirl_record *record) {
    return bounded_factor(1.0 + log(1.0 / (0.1 * settled)) / -v->settling.value / record->revolutions);
}

/// Returns true if the motion still settles: its returns shrink, or perturbations decay.
static bool still_settles(const whirl_verdict *v, const evidence *e) {
    return v->recurrence_trend < 0.9 || v->recurrence <= recurrence_tolerance || !isnan(settling_exponent(e));
}

/// Returns a factor for a slow drift: a torus is recognized after a few rounds.
static double drift_factor(const whirl_verdict *v, const evidence *e) {
    return isnan(v->round) ? usual_factor : bounded_factor(enough_rounds * v->round / (double)e->points.count);
}

/// Returns a factor that makes the exponent clear: errors of means shrink with the square root of the revolutions.
static double exponent_factor(whirl_estimate exponent) {
    const double short_of = clear_sigmas * exponent.error / fabs(exponent.value);
    return short_of > 1.0 ? bounded_factor(short_of * short_of) : usual_factor;
}

/// Returns true if the motion stays, to rounding, on an unstable motion, as a balanced rotor does that starts at rest.
static bool stays_on_unstable(const whirl_verdict *v, const evidence *e) {
    return v->recurrence <= e->rounding && v->exponent.value > 0.0 && is_clear(v->exponent);
}

bool weigh_swelling(const whirl_verdict *v) {
    const double share = 0.2, sigmas = 3.0, error = sigmas * v->exponent.error;
    return v->exponent.value > error && fabs(v->swelling - v->exponent.value) <= share * v->exponent.value + error;
}

static whirl_advice confidence_advise(const whirl_verdict *v, const evidence *e, const whirl_record *record) {
    if (v->agreement == WHIRL_HIGH) return (whirl_advice){WHIRL_NO_REMEDY, 1.0};
    if (v->regime == WHIRL_CHAOTIC) return (whirl_advice){WHIRL_LONGER_WATCH, exponent_factor(v->exponent)};
    if (v->regime == WHIRL_QUASI_PERIODIC) return (whirl_advice){WHIRL_LONGER_WATCH, usual_factor};
    if (v->rests) return (whirl_advice){WHIRL_LONGER_WATCH, usual_factor};
    if (v->settles) return (whirl_advice){WHIRL_LONGER_TRANSIENT, slow_factor(v, record)};
    if (stays_on_unstable(v, e)) return (whirl_advice){WHIRL_OTHER_START, 1.0};
    if (weigh_swelling(v)) return (whirl_advice){WHIRL_LONGER_TRANSIENT, usual_factor};
    if (isnan(v->round) && still_settles(v, e))
        return (whirl_advice){WHIRL_LONGER_TRANSIENT, settling_factor(v, e, record)};
    return (whirl_advice){WHIRL_LONGER_WATCH, drift_factor(v, e)};
}

static whirl_confidence confidence_lesser(whirl_confidence a, whirl_confidence b) {
    return a < b ? a : b;
}

/// Limits the confidence of a verdict that no second tolerance has confirmed.
static whirl_confidence confidence_unconfirmed(whirl_confidence agreement) {
    return confidence_lesser(agreement, WHIRL_FAIR);
}

void weigh_verdict(whirl_verdict *verdict, const evidence *e, const whirl_record *record) {
    verdict->agreement = confidence_weigh(verdict, e);
    verdict->confidence = confidence_unconfirmed(verdict->agreement);
    verdict->advice = confidence_advise(verdict, e, record);
}

double verdict_least_life(const whirl_verdict *v) {
    const double chances = 3.0; // exp(-3) is 5 %
    return (v->revolutions + v->followed + v->survived) / chances;
}

/// Returns true if two exponents differ by more than their errors, and by more than a fifth of the larger one.
static bool exponents_differ(whirl_estimate a, whirl_estimate b) {
    const double difference = fabs(a.value - b.value);
    return difference > clear_sigmas * hypot(a.error, b.error) &&
           difference > 0.2 * fmax(fabs(a.value), fabs(b.value)) + least_difference;
}

/// Returns true if two motions diverge in about the same revolution.
static bool leave_alike(const whirl_verdict *a, const whirl_verdict *b) {
    return fabs(a->diverged_at - b->diverged_at) <= fmax(1.0, 0.1 * a->diverged_at);
}

/// Returns the confidence of two verdicts with the same regime. Different exponents of chaos are artefacts of the
/// steps; different exponents of periodic motions may belong to two coexisting motions.
static whirl_confidence joint_confidence(const whirl_verdict *a, const whirl_verdict *b) {
    const whirl_confidence both = confidence_lesser(a->agreement, b->agreement);
    if (a->regime == WHIRL_DIVERGING) return leave_alike(a, b) ? both : WHIRL_LOW;
    if (exponents_differ(a->exponent, b->exponent))
        return a->regime == WHIRL_CHAOTIC ? WHIRL_LOW : confidence_lesser(both, WHIRL_FAIR);
    return a->curves == b->curves ? both : confidence_lesser(both, WHIRL_FAIR);
}

/// Returns true if no attractor is known on which the chaos may end, and if its copies stayed chaotic for long.
static bool lives_long(const whirl_verdict *v) {
    if (v->regime != WHIRL_CHAOTIC) return true;
    return v->sought && v->coexisting == 0 && v->survived > 0.0 && v->ended == 0;
}

void whirl_verdict_confirm(whirl_verdict *verdict, const whirl_verdict *other) {
    const whirl_advice tighter = {WHIRL_TIGHTER, 256.0};
    // Take over the second motion's regime, and what was found about lasting chaos.
    verdict->confirmed = true;
    verdict->other_regime = other->regime;
    verdict->other_period = other->period;
    verdict->rests = verdict->rests && other->rests;
    verdict->sought = other->sought;
    verdict->coexisting = other->coexisting;
    verdict->survived = other->survived;
    verdict->ended = other->ended;
    if (verdict->regime == WHIRL_UNDETERMINED) return;
    // Equal regimes confirm each other, except chaos that may end.
    if (other->regime == verdict->regime && other->period == verdict->period) {
        verdict->confidence = joint_confidence(verdict, other);
        const bool ends = verdict->coexisting != 0 || verdict->ended > 0;
        if (ends || (verdict->confidence == WHIRL_HIGH && !lives_long(verdict))) {
            verdict->confidence = ends ? WHIRL_LOW : WHIRL_FAIR;
            verdict->advice = (whirl_advice){WHIRL_LONGER_TRANSIENT, usual_factor};
            return;
        }
        if (verdict->confidence == WHIRL_HIGH || verdict->confidence == verdict->agreement) return;
        verdict->advice = other->agreement == WHIRL_HIGH ? tighter : other->advice;
    } else {
        verdict->confidence = WHIRL_LOW;
        verdict->advice = other->regime == WHIRL_UNDETERMINED ? other->advice : tighter;
    }
}

/// Returns the rank of the end of a copy, highest first: settled, lost, undetermined, still chaotic.
static int end_rank(whirl_regime regime) {
    static const int ranks[] = {[WHIRL_CHAOTIC] = 0,   [WHIRL_UNDETERMINED] = 1,   [WHIRL_NOT_JUDGED] = 1,
                                [WHIRL_DIVERGING] = 2, [WHIRL_QUASI_PERIODIC] = 3, [WHIRL_PERIODIC] = 4};
    return ranks[regime];
}

/// Returns the verdict at a copy's end: a motion that returns has settled, even if its record is mostly chaotic.
static whirl_verdict confidence_end_of(const whirl_verdict *later) {
    whirl_verdict end = *later;
    if (end.regime == WHIRL_UNDETERMINED && end.recurrence <= recurrence_tolerance) {
        end.regime = WHIRL_PERIODIC;
        end.period = end.recurrence_period;
    }
    return end;
}

void whirl_verdict_follow(whirl_verdict *verdict, const whirl_verdict *copy, double revolutions, double all) {
    const whirl_verdict end = confidence_end_of(copy), *later = &end;
    if (verdict->regime != WHIRL_CHAOTIC) return;
    const whirl_regime before = verdict->followed > 0.0 ? verdict->later_regime : WHIRL_CHAOTIC;
    const int period = verdict->followed > 0.0 ? verdict->later_period : 0;
    const int gain = end_rank(later->regime) - end_rank(before);
    const bool counts = gain > 0 || (gain == 0 && later->period < period);
    verdict->followed += revolutions;
    verdict->later_regime = counts ? later->regime : before;
    verdict->later_period = counts ? later->period : period;
    if (verdict->later_regime == WHIRL_CHAOTIC) return;
    const bool ended = verdict->later_regime != WHIRL_UNDETERMINED;
    verdict->confidence = confidence_lesser(verdict->confidence, ended ? WHIRL_LOW : WHIRL_FAIR);
    verdict->advice = (whirl_advice){WHIRL_LONGER_TRANSIENT, bounded_factor(1.0 + verdict->followed / all)};
}

static int confidence_times(int count, double factor) {
    const double product = ceil(count * factor * (1.0 - 1e-12));
    return product < INT_MAX / 2 ? (int)product : INT_MAX / 2;
}

whirl_integrate_options whirl_integrate_tighter(const whirl_integrate_options *options, double factor) {
    const double least_tolerance = 1e-14;
    whirl_integrate_options tighter = *options;
    if (whirl_method_is_adaptive(options->method)) {
        tighter.rtol = fmin(options->rtol, fmax(options->rtol / factor, least_tolerance));
        tighter.atol = options->atol / factor;
    } else {
        tighter.steps_per_revolution = confidence_times(options->steps_per_revolution, sqrt(sqrt(factor)));
    }
    return tighter;
}

void whirl_advice_apply(whirl_advice advice, whirl_integrate_options *integrate, whirl_record_options *record) {
    const int all = record->transient + record->record, watched = whirl_record_watch(record);
    const int room = INT_MAX - all;
    switch (advice.remedy) {
    case WHIRL_LONGER_TRANSIENT:
        record->watch = watched;
        record->transient = confidence_times(all, advice.factor) - record->record;
        break;
    case WHIRL_LONGER_WATCH:
        record->watch = watched + (int)fmin(confidence_times(watched, advice.factor) - watched, room);
        record->transient += record->watch - watched;
        break;
    case WHIRL_TIGHTER:
        record->samples_per_revolution = whirl_record_samples(record, integrate->steps_per_revolution);
        *integrate = whirl_integrate_tighter(integrate, advice.factor);
        break;
    case WHIRL_MORE_STEPS:
        record->samples_per_revolution = whirl_record_samples(record, integrate->steps_per_revolution);
        integrate->steps_per_revolution = confidence_times(integrate->steps_per_revolution, advice.factor);
        break;
    case WHIRL_OTHER_START:
    case WHIRL_NO_REMEDY:
        break;
    }
}
