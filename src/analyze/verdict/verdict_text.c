// Verdicts in words.
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "birkhoff.h"
#include "confidence.h"
#include "evidence.h"
#include "multiplier.h"
#include "recurrence.h"
#include "section.h"
#include "settling.h"
#include "steps.h"
#include "whirl/engine/analyze.h"

const char *whirl_regime_name(whirl_regime regime) {
    static const char *const names[] = {
        [WHIRL_UNDETERMINED] = "undetermined",
        [WHIRL_PERIODIC] = "periodic",
        [WHIRL_QUASI_PERIODIC] = "quasi-periodic",
        [WHIRL_CHAOTIC] = "chaotic",
        [WHIRL_DIVERGING] = "diverged",
        [WHIRL_NOT_JUDGED] = "not judged",
    };
    return (unsigned)regime < sizeof names / sizeof *names ? names[regime] : names[WHIRL_UNDETERMINED];
}

const char *whirl_confidence_name(whirl_confidence confidence) {
    static const char *const names[] = {[WHIRL_LOW] = "low", [WHIRL_FAIR] = "fair", [WHIRL_HIGH] = "high"};
    return (unsigned)confidence < sizeof names / sizeof *names ? names[confidence] : names[WHIRL_LOW];
}

static const char *verdict_text_plural(int count) {
    return count == 1 ? "" : "s";
}

static void quasi_periodic_name(const whirl_verdict *v, char *text, size_t size) {
    if (v->line > 0.0 && v->frequencies == 3)
        snprintf(text, size, "quasi-periodic (1X, %.4gX and %.4gX)", v->line, v->second);
    else if (v->line > 0.0)
        snprintf(text, size, "quasi-periodic (1X and %.4gX)", v->line);
    else if (v->curves > 0)
        snprintf(text, size, "quasi-periodic (%d curve%s)", v->curves, verdict_text_plural(v->curves));
    else if (v->frequencies == 2)
        snprintf(text, size, "quasi-periodic (forced)");
    else if (v->frequencies > 0)
        snprintf(text, size, "quasi-periodic (%d frequencies)", v->frequencies);
    else
        snprintf(text, size, "%s", whirl_regime_name(WHIRL_QUASI_PERIODIC));
}

void whirl_verdict_name(const whirl_verdict *verdict, char *text, size_t size) {
    switch (verdict->regime) {
    case WHIRL_PERIODIC:
        if (verdict->rests && verdict->period == 1)
            snprintf(text, size, "rests");
        else
            snprintf(text, size, "P-%d", verdict->period);
        return;
    case WHIRL_QUASI_PERIODIC:
        quasi_periodic_name(verdict, text, size);
        return;
    case WHIRL_DIVERGING:
        snprintf(text, size, "diverged at revolution %.0f", verdict->diverged_at);
        return;
    case WHIRL_CHAOTIC:
    case WHIRL_UNDETERMINED:
    case WHIRL_NOT_JUDGED:
        break;
    }
    snprintf(text, size, "%s", whirl_regime_name(verdict->regime));
}

/// Writes the exponent; its error is no smaller than the printed digits.
static void exponent_text(const whirl_verdict *v, char *text, size_t size) {
    const whirl_estimate exponent = v->exponent;
    if (v->exponents_failed) {
        snprintf(text, size, "the exponents failed: their sum is not what the equations give");
    } else if (isnan(exponent.value)) {
        snprintf(text, size, "no perturbation was followed");
    } else {
        snprintf(text, size, "largest exponent %.4f +- %.1g per revolution", exponent.value,
                 fmax(exponent.error, 1e-4));
    }
}

/// Writes the period up to which no return was found.
static void unreturned_text(const whirl_verdict *v, char *text, size_t size) {
    snprintf(text, size, "does not return within %d revolutions%s", v->longest_period,
             v->longest_period < WHIRL_MAX_PERIOD ? " (longer periods need three of them watched)" : "");
}

/// Explains a chaotic verdict. Escape times are exponential: a life of n revolutions excludes, at 95 %, mean lives
/// below n/3.
static void chaotic_reason(const whirl_verdict *v, const char *exponent, char *text, size_t size) {
    char coexisting[128] = "", lasting[128] = "";
    const double least = verdict_least_life(v);
    if (v->ended > 0)
        snprintf(lasting, sizeof lasting,
                 "; %d of its copies ended: chaos here lives %.0f revolutions on average, and then is something else",
                 v->ended, v->survived / v->ended);
    else if (least >= 1.0)
        snprintf(lasting, sizeof lasting, "; chaotic for at least %.0f revolutions on average (95 %%)", least);
    if (v->coexisting == WHIRL_COEXISTING_AT_REST)
        snprintf(coexisting, sizeof coexisting, "; a stable equilibrium is near the motion, which may end on it");
    else if (v->coexisting > 0)
        snprintf(coexisting, sizeof coexisting, "; a stable P-%d is near the motion, which may end on it",
                 v->coexisting);
    snprintf(text, size, "small perturbations grow: %s; averages of two halves agree to %.1f digits only%s%s%s",
             exponent, v->regularity, v->chaos <= 0.2 ? ", but the 0-1 test does not see chaos" : "", coexisting,
             lasting);
}

/// Explains an undetermined verdict: the first failed condition, in the order of the verdicts.
static void undetermined_reason(const whirl_verdict *v, const char *exponent, char *text, size_t size) {
    char unreturned[96];
    unreturned_text(v, unreturned, sizeof unreturned);
    const bool dies_out = v->exponent.value + 6.0 * v->exponent.error < 0.0;
    const bool regular = v->regularity >= 2.5 && v->chaos < 0.5;
    if (steps_reason(v, text, size)) return;
    if (v->diverged_at > 0.0) {
        snprintf(text, size, "the solver could not go on in revolution %.0f", v->diverged_at);
    } else if (isnan(v->recurrence)) {
        snprintf(text, size, "too few revolutions were watched to tell");
    } else if (v->advice.remedy == WHIRL_OTHER_START) {
        snprintf(text, size, "stays where it started, on an unstable motion that nothing pushes it off (%s)", exponent);
    } else if (weigh_swelling(v)) {
        snprintf(
            text, size,
            "grows: by %.4g per revolution, as perturbations do (%s); it leaves an unstable motion, and is lost or "
            "comes to another one",
            v->swelling, exponent);
    } else if (v->recurrence <= recurrence_tolerance) {
        snprintf(text, size,
                 "returns after %d revolution%s to %.1e of its size, but it is not certain that it has settled (%s)",
                 v->recurrence_period, verdict_text_plural(v->recurrence_period), v->recurrence, exponent);
    } else if (v->recurrence_trend < 0.9) {
        snprintf(text, size,
                 "still settling: the distance of returns has shrunk to %.2g of what it was (best return %.1e of its "
                 "size, %s)",
                 v->recurrence_trend, v->recurrence, exponent);
    } else if (dies_out) {
        snprintf(text, size,
                 "perturbations die out (%s), but it %s; best return %.1e of its size: it settles slowly or repeats "
                 "after more",
                 exponent, unreturned, v->recurrence);
    } else if (!isnan(v->round)) {
        snprintf(text, size,
                 "drifts evenly: it nearly returns after %d revolution%s (%.1e of its size), and goes once round its "
                 "curve in some %.0f revolutions, which must be watched a dozen times (%s)",
                 v->recurrence_period, verdict_text_plural(v->recurrence_period), v->recurrence, v->round, exponent);
    } else if (regular) {
        snprintf(text, size,
                 "regular, but its section does not fill a closed curve yet, and it %s; averages of two halves agree "
                 "to %.1f digits, %s",
                 unreturned, v->regularity, exponent);
    } else {
        char averages[64] = "", chaos[32] = ""; // unknown for few points
        if (!isnan(v->regularity))
            snprintf(averages, sizeof averages, "averages of two halves agree to %.1f digits, ", v->regularity);
        if (!isnan(v->chaos)) snprintf(chaos, sizeof chaos, "0-1 test %.2f, ", v->chaos);
        snprintf(text, size, "the evidence is not clear: best return %.1e of its size, %s%s%s", v->recurrence, averages,
                 chaos, exponent);
    }
}

/// Returns the change of the amplitude in a hundred revolutions, percent.
static double change_in_hundred(double rate) {
    return 100.0 * fabs(expm1(100.0 * rate));
}

/// Writes how the amplitude of a line changes; nothing below 1e-6 per revolution, which is rounding or noise.
static void trend_text(double trend, char *text, size_t size) {
    snprintf(text, size, "%s", "");
    if (fabs(trend) >= 1e-6)
        snprintf(text, size, ", which %s by %.2g %% in 100 revolutions", trend > 0.0 ? "grows" : "falls",
                 change_in_hundred(trend));
}

/// Describes the main line and the second line of a motion, both off whole orders, and how they change.
static void line_text(const whirl_verdict *v, char *text, size_t size) {
    char trend[96], other[96];
    trend_text(v->line_trend, trend, sizeof trend);
    trend_text(v->second_trend, other, sizeof other);
    snprintf(text, size, "a line at %.4g X has %.2g of the motion's size%s", v->line, v->line_share, trend);
    const size_t used = strlen(text);
    if (v->second > 0.0)
        snprintf(text + used, size - used, ", another one at %.4g X has %.2g%s", v->second, v->second_share, other);
}

static void quasi_periodic_reason(const whirl_verdict *v, const char *exponent, char *text, size_t size) {
    // A main line that keeps its place and size is evidence by itself.
    char what[200], line[320], frequencies[96];
    if (v->line > 0.0) {
        line_text(v, line, sizeof line);
        if (v->frequencies == 3)
            snprintf(frequencies, sizeof frequencies, "three frequencies, the shaft's, %.6g X and %.6g X", v->line,
                     v->second);
        else
            snprintf(frequencies, sizeof frequencies, "two frequencies, the shaft's and %.6g X", v->line);
        snprintf(text, size,
                 "all lines of its spectrum are of %s, and stay as they are from half to half of the record (%s); a "
                 "lock of a longer period is not excluded; %s",
                 frequencies, line, exponent);
        return;
    }
    // Otherwise name what was seen of the section.
    if (v->curves > 0)
        snprintf(what, sizeof what, "draws %d closed curve%s; locks up to P-%d are excluded, longer ones are not",
                 v->curves, verdict_text_plural(v->curves), v->unlocked);
    else if (v->frequencies == 2)
        snprintf(what, sizeof what, "is regular: a phase that fits no revolution forces it, and perturbations die out");
    else if (v->frequencies > 0)
        snprintf(what, sizeof what, "has two exponents of zero: its section is a surface");
    else
        snprintf(what, sizeof what,
                 "is regular; no smooth curve is seen, so that a torus of three frequencies is not excluded (the "
                 "analysis exponents decides it)");
    snprintf(text, size,
             "does not return (%.1e of its size at best) but %s; averages of two halves agree to %.1f digits; %s",
             v->recurrence, what, v->regularity, exponent);
}

/// Writes the result of Newton's method for a motion that returns.
static void orbit_text(const whirl_verdict *v, char *text, size_t size) {
    switch (v->orbit) {
    case WHIRL_ORBIT_STABLE:
    case WHIRL_ORBIT_UNSTABLE:
        snprintf(text, size, "; an orbit of %d revolution%s closes to %.0e, its largest multiplier is %.4g%s",
                 v->orbit_period, verdict_text_plural(v->orbit_period), v->orbit_residual, v->orbit_modulus,
                 v->orbit == WHIRL_ORBIT_UNSTABLE ? ": it is not stable" : "");
        return;
    case WHIRL_ORBIT_ELSEWHERE:
        snprintf(text, size, "; the nearest orbit is %.1e of its size away", v->orbit_distance);
        return;
    case WHIRL_ORBIT_NONE:
        snprintf(text, size, "; Newton's method finds no orbit there");
        return;
    case WHIRL_ORBIT_UNSOUGHT:
        break;
    }
    snprintf(text, size, "%s", "");
}

static void periodic_reason(const whirl_verdict *v, const char *exponent, char *text, size_t size) {
    char orbit[112];
    orbit_text(v, orbit, sizeof orbit);
    snprintf(text, size, "returns after %d revolution%s to %.1e of its size; %s%s", v->period,
             verdict_text_plural(v->period), v->recurrence, exponent, orbit);
}

static void rest_reason(const whirl_verdict *v, char *text, size_t size) {
    char order[48] = "";
    if (v->rest_order > 0.0) snprintf(order, sizeof order, " (at %.4g X)", v->rest_order);
    snprintf(text, size,
             "stays within %.1e of its largest coordinate at an equilibrium; the slowest mode about it%s dies out by "
             "%.4g per revolution",
             v->rest_distance, order, -v->exponent.value);
}

static void slow_reason(const whirl_verdict *v, const char *exponent, char *text, size_t size) {
    char orbit[112];
    orbit_text(v, orbit, sizeof orbit);
    snprintf(text, size,
             "settles on P-1: its distance from the orbit falls by %.3g %% in 100 revolutions (slowest multiplier of "
             "its section "
             "%.4g +- %.1g per revolution); it returns to %.1e of its size so far; %s%s",
             change_in_hundred(v->settling.value), v->settling.value, v->settling.error, v->recurrence, exponent,
             orbit);
}

/// Adds known facts to the reason of an undetermined verdict: how its settling changes, and its main line.
static void known_text(const whirl_verdict *v, char *text, size_t size) {
    char line[320];
    if (fabs(v->settling.value) > 6.0 * v->settling.error) {
        const size_t used = strlen(text);
        snprintf(text + used, size - used, "; its steps %s by %.3g %% in 100 revolutions",
                 v->settling.value > 0.0 ? "grow" : "shrink", change_in_hundred(v->settling.value));
    }
    if (!(v->line > 0.0)) return;
    const size_t used = strlen(text);
    line_text(v, line, sizeof line);
    snprintf(text + used, size - used, "; %s", line);
}

static void regime_reason(const whirl_verdict *v, const char *exponent, char *text, size_t size) {
    switch (v->regime) {
    case WHIRL_PERIODIC:
        if (v->rests && v->period == 1)
            rest_reason(v, text, size);
        else if (v->settles)
            slow_reason(v, exponent, text, size);
        else
            periodic_reason(v, exponent, text, size);
        return;
    case WHIRL_QUASI_PERIODIC:
        quasi_periodic_reason(v, exponent, text, size);
        return;
    case WHIRL_CHAOTIC:
        chaotic_reason(v, exponent, text, size);
        return;
    case WHIRL_DIVERGING:
        if (v->limit > 0.0)
            snprintf(text, size,
                     "the motion left its bounds in revolution %.0f: coordinate %d passed the limit of %.4g times its "
                     "scale (the option limit, and the scales of a custom system, set it)",
                     v->diverged_at, v->limit_coordinate, v->limit);
        else
            snprintf(text, size, "the motion left its bounds in revolution %.0f", v->diverged_at);
        return;
    case WHIRL_NOT_JUDGED:
        snprintf(text, size, "no verdict was asked for: the analyses have no regime");
        return;
    case WHIRL_UNDETERMINED:
        break;
    }
    undetermined_reason(v, exponent, text, size);
    known_text(v, text, size);
}

/// Names a regime, with the period if it has one, for a motion other than the verdict's own.
static void name_kind(whirl_regime regime, int period, char name[WHIRL_NAME_SIZE]) {
    const whirl_verdict there = {.regime = regime, .period = period};
    if (regime == WHIRL_PERIODIC)
        whirl_verdict_name(&there, name, WHIRL_NAME_SIZE);
    else
        snprintf(name, WHIRL_NAME_SIZE, "%s", whirl_regime_name(regime));
}

/// Writes how the second tolerance contradicts.
static void verdict_text_contradiction(const whirl_verdict *v, char *text, size_t size) {
    char other[WHIRL_NAME_SIZE];
    name_kind(v->other_regime, v->other_period, other);
    if (v->other_regime != v->regime || v->other_period != v->period)
        snprintf(text, size, "; at the second tolerance it is %s", other);
    else if (v->confidence < v->agreement)
        snprintf(text, size, "; at the second tolerance the evidence is weaker or different");
}

/// Writes the results of copies of a chaotic motion that continued it.
static void later_text(const whirl_verdict *v, char *text, size_t size) {
    char name[WHIRL_NAME_SIZE];
    name_kind(v->later_regime, v->later_period, name);
    if (v->later_regime == WHIRL_CHAOTIC)
        snprintf(text, size, "; so it stays for %.0f revolutions more", v->followed);
    else
        snprintf(text, size, "; within %.0f revolutions more it is %s: the chaos may be a transient", v->followed,
                 name);
}

void whirl_verdict_reason(const whirl_verdict *verdict, char *text, size_t size) {
    char exponent[96], reason[768], second[WHIRL_NAME_SIZE + 64] = "", later[WHIRL_NAME_SIZE + 96] = "";
    exponent_text(verdict, exponent, sizeof exponent);
    regime_reason(verdict, exponent, reason, sizeof reason);
    const bool ended = verdict->followed > 0.0 && verdict->later_regime != WHIRL_CHAOTIC;
    if (verdict->confirmed && !ended) verdict_text_contradiction(verdict, second, sizeof second);
    if (verdict->followed > 0.0) later_text(verdict, later, sizeof later);
    snprintf(text, size, "%s%s%s", reason, second, later);
}

void whirl_verdict_advice(const whirl_verdict *verdict, char *text, size_t size) {
    const double factor = verdict->advice.factor;
    switch (verdict->advice.remedy) {
    case WHIRL_LONGER_TRANSIENT:
        snprintf(text, size, "let it run %.3g times as long", factor);
        return;
    case WHIRL_LONGER_WATCH:
        snprintf(text, size, "watch %.3g times as many revolutions", factor);
        return;
    case WHIRL_TIGHTER:
        snprintf(text, size, "integrate with errors of a step %.3g times smaller", factor);
        return;
    case WHIRL_MORE_STEPS:
        snprintf(text, size, "take at least %.3g times as many steps, or a method with a tolerance (dop853, rodas5p)",
                 factor);
        return;
    case WHIRL_OTHER_START:
        snprintf(text, size, "start near this motion (initial)");
        return;
    case WHIRL_NO_REMEDY:
        break;
    }
    snprintf(text, size, "%s", "");
}
