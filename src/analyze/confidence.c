// How far a verdict can be trusted: agreement between the pieces of evidence, and between two tolerances.
#include "confidence.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "section.h"

/// A verdict is certain of a record's evidence when returns are this good, averages this regular or this irregular.
static const double good_return = 1e-8, regular_digits = 4.0, irregular_digits = 3.0;

/// Revolutions that make an exponent of chaos trustworthy, and the standard errors it must be from zero.
static const double enough_watched = 500.0, clear_sigmas = 8.0;

/// Most by which a run is advised to be lengthened at once.
static const double least_factor = 1.5, largest_factor = 100.0, watch_factor = 4.0;

static whirl_confidence weigh_periodic(const whirl_verdict *v) {
    const bool sharp = v->exponent.value + 10.0 * v->exponent.error < 0.0;
    return v->recurrence <= good_return && sharp ? WHIRL_HIGH : WHIRL_FAIR;
}

static whirl_confidence weigh_chaotic(const whirl_verdict *v, double watched) {
    const bool clear = v->exponent.value > clear_sigmas * v->exponent.error;
    return clear && v->regularity < irregular_digits && watched >= enough_watched ? WHIRL_HIGH : WHIRL_FAIR;
}

static whirl_confidence weigh(const whirl_verdict *v, double watched) {
    switch (v->regime) {
    case WHIRL_PERIODIC:
        return weigh_periodic(v);
    case WHIRL_QUASI_PERIODIC:
        return v->regularity >= regular_digits ? WHIRL_HIGH : WHIRL_FAIR;
    case WHIRL_CHAOTIC:
        return weigh_chaotic(v, watched);
    case WHIRL_DIVERGING:
        return WHIRL_HIGH;
    case WHIRL_UNDETERMINED:
        break;
    }
    return WHIRL_LOW;
}

static double bounded_factor(double factor) {
    return fmin(fmax(factor, least_factor), largest_factor);
}

/// Rate at which returns shrink, natural logarithm per revolution (below 0 while the motion settles). The trend
/// compares two quarters of the watched revolutions, three quarters apart.
static double settling_rate(const whirl_verdict *v, double watched) {
    return log(v->recurrence_trend) / (0.75 * watched);
}

/// How many times as long the run must be for what is left of the transient to shrink below the tolerance of a return.
static double settling_factor(const whirl_verdict *v, const whirl_record *record) {
    const double rate = settling_rate(v, (double)record->section_count);
    const double left = v->recurrence / -expm1(rate * fmax(v->recurrence_period, 1.0));
    const double needed = log(fmax(left / (0.1 * recurrence_tolerance), 1.0)) / -rate;
    return bounded_factor(1.0 + needed / fmax(record->revolutions, 1.0));
}

static whirl_advice advise(const whirl_verdict *v, const whirl_record *record) {
    if (record->motion == WHIRL_STUCK) return (whirl_advice){WHIRL_TIGHTER, 16.0};
    if (v->regime != WHIRL_UNDETERMINED) {
        if (v->agreement == WHIRL_HIGH) return (whirl_advice){WHIRL_NO_REMEDY, 1.0};
        return (whirl_advice){v->regime == WHIRL_PERIODIC ? WHIRL_LONGER_TRANSIENT : WHIRL_LONGER_WATCH, 2.0};
    }
    if (v->recurrence_trend < 0.9) return (whirl_advice){WHIRL_LONGER_TRANSIENT, settling_factor(v, record)};
    return (whirl_advice){WHIRL_LONGER_WATCH, watch_factor};
}

static whirl_confidence lesser(whirl_confidence a, whirl_confidence b) {
    return a < b ? a : b;
}

/// One tolerance alone earns no more than this.
static whirl_confidence unconfirmed(whirl_confidence agreement) {
    return lesser(agreement, WHIRL_FAIR);
}

void weigh_verdict(whirl_verdict *verdict, const whirl_record *record) {
    verdict->agreement = weigh(verdict, (double)record->section_count);
    verdict->confidence = unconfirmed(verdict->agreement);
    verdict->advice = advise(verdict, record);
}

void whirl_verdict_confirm(whirl_verdict *verdict, const whirl_verdict *other) {
    verdict->confirmed = true;
    verdict->other_regime = other->regime;
    verdict->other_period = other->period;
    if (verdict->regime == WHIRL_UNDETERMINED) return;
    if (other->regime == verdict->regime && other->period == verdict->period) {
        verdict->confidence = lesser(verdict->agreement, other->agreement);
        if (other->curves != verdict->curves) verdict->confidence = lesser(verdict->confidence, WHIRL_FAIR);
    } else if (other->regime == WHIRL_UNDETERMINED) {
        verdict->confidence = WHIRL_LOW;
        if (verdict->advice.remedy == WHIRL_NO_REMEDY) verdict->advice = other->advice;
    } else {
        verdict->confidence = WHIRL_LOW;
        verdict->advice = (whirl_advice){WHIRL_TIGHTER, 256.0};
    }
}

static int times(int count, double factor) {
    const double product = ceil(count * factor * (1.0 - 1e-12));
    return product < INT_MAX / 2 ? (int)product : INT_MAX / 2;
}

static bool is_adaptive(const char *name) {
    const whirl_method *method = whirl_method_at(0);
    for (size_t i = 0; method && strcmp(method->name, name) != 0; i++) method = whirl_method_at(i + 1);
    return method && method->adaptive;
}

whirl_integrate_options whirl_integrate_tighter(const whirl_integrate_options *options, double factor) {
    const double least_tolerance = 1e-14;
    whirl_integrate_options tighter = *options;
    if (is_adaptive(options->method)) {
        tighter.rtol = fmin(options->rtol, fmax(options->rtol / factor, least_tolerance));
        tighter.atol = options->atol / factor;
    } else {
        tighter.steps_per_revolution = times(options->steps_per_revolution, sqrt(sqrt(factor)));
    }
    return tighter;
}

void whirl_advice_apply(whirl_advice advice, whirl_integrate_options *integrate, whirl_record_options *record) {
    const int all = record->transient + record->record, watched = whirl_record_watch(record);
    const int room = INT_MAX - all;
    switch (advice.remedy) {
    case WHIRL_LONGER_TRANSIENT:
        record->watch = watched;
        record->transient = times(all, advice.factor) - record->record;
        break;
    case WHIRL_LONGER_WATCH:
        record->watch = watched + (int)fmin(times(watched, advice.factor) - watched, room);
        record->transient += record->watch - watched;
        break;
    case WHIRL_TIGHTER:
        record->samples_per_revolution = whirl_record_samples(record, integrate->steps_per_revolution);
        *integrate = whirl_integrate_tighter(integrate, advice.factor);
        break;
    case WHIRL_NO_REMEDY:
        break;
    }
}
