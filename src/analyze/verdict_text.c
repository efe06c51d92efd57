// Verdicts in words.
#include <math.h>
#include <stdio.h>

#include "section.h"
#include "whirl/analyze.h"

const char *whirl_regime_name(whirl_regime regime) {
    static const char *const names[] = {
        [WHIRL_UNDETERMINED] = "undetermined",
        [WHIRL_PERIODIC] = "periodic",
        [WHIRL_QUASI_PERIODIC] = "quasi-periodic",
        [WHIRL_CHAOTIC] = "chaotic",
        [WHIRL_DIVERGING] = "diverged",
    };
    return (unsigned)regime < sizeof names / sizeof *names ? names[regime] : names[WHIRL_UNDETERMINED];
}

const char *whirl_confidence_name(whirl_confidence confidence) {
    static const char *const names[] = {[WHIRL_LOW] = "low", [WHIRL_FAIR] = "fair", [WHIRL_HIGH] = "high"};
    return (unsigned)confidence < sizeof names / sizeof *names ? names[confidence] : names[WHIRL_LOW];
}

void whirl_verdict_name(const whirl_verdict *verdict, char *text, size_t size) {
    switch (verdict->regime) {
    case WHIRL_PERIODIC:
        snprintf(text, size, "P-%d", verdict->period);
        return;
    case WHIRL_QUASI_PERIODIC:
        snprintf(text, size, "quasi-periodic (%d curve%s)", verdict->curves, verdict->curves == 1 ? "" : "s");
        return;
    case WHIRL_DIVERGING:
        snprintf(text, size, "diverged at revolution %.0f", verdict->diverged_at);
        return;
    case WHIRL_CHAOTIC:
    case WHIRL_UNDETERMINED:
        break;
    }
    snprintf(text, size, "%s", whirl_regime_name(verdict->regime));
}

/// The error is not told below what the printed digits show.
static void exponent_text(whirl_estimate exponent, char *text, size_t size) {
    if (isnan(exponent.value)) {
        snprintf(text, size, "no disturbance was followed");
    } else {
        snprintf(text, size, "largest exponent %.4f +- %.1g per revolution", exponent.value,
                 fmax(exponent.error, 1e-4));
    }
}

static void undetermined_reason(const whirl_verdict *v, const char *exponent, char *text, size_t size) {
    if (isnan(v->recurrence)) {
        snprintf(text, size, "too few revolutions were watched to tell");
    } else if (v->recurrence <= recurrence_tolerance) {
        snprintf(text, size,
                 "returns after %d revolution%s to %.1e of its size, but it is not certain that it has settled (%s)",
                 v->recurrence_period, v->recurrence_period == 1 ? "" : "s", v->recurrence, exponent);
    } else if (v->recurrence_trend < 0.9) {
        snprintf(text, size,
                 "still settling: the distance of returns has shrunk to %.2g of what it was (best return %.1e of its "
                 "size, %s)",
                 v->recurrence_trend, v->recurrence, exponent);
    } else {
        snprintf(
            text, size,
            "the evidence is not clear: best return %.1e of its size, averages of two halves agree to %.1f digits, %s",
            v->recurrence, v->regularity, exponent);
    }
}

void whirl_verdict_reason(const whirl_verdict *verdict, char *text, size_t size) {
    char exponent[96];
    exponent_text(verdict->exponent, exponent, sizeof exponent);
    switch (verdict->regime) {
    case WHIRL_PERIODIC:
        snprintf(text, size, "returns after %d revolution%s to %.1e of its size; %s", verdict->period,
                 verdict->period == 1 ? "" : "s", verdict->recurrence, exponent);
        return;
    case WHIRL_QUASI_PERIODIC:
        snprintf(text, size,
                 "does not return (%.1e of its size at best) but draws %d closed curve%s; averages of two halves agree "
                 "to %.1f digits; %s",
                 verdict->recurrence, verdict->curves, verdict->curves == 1 ? "" : "s", verdict->regularity, exponent);
        return;
    case WHIRL_CHAOTIC:
        snprintf(text, size, "small disturbances grow: %s; averages of two halves agree to %.1f digits only", exponent,
                 verdict->regularity);
        return;
    case WHIRL_DIVERGING:
        snprintf(text, size, "the motion left its bounds in revolution %.0f", verdict->diverged_at);
        return;
    case WHIRL_UNDETERMINED:
        break;
    }
    undetermined_reason(verdict, exponent, text, size);
}

void whirl_verdict_advice(const whirl_verdict *verdict, char *text, size_t size) {
    const double factor = verdict->advice.factor;
    switch (verdict->advice.remedy) {
    case WHIRL_LONGER_TRANSIENT:
        snprintf(text, size, "let it run %.2g times as long", factor);
        return;
    case WHIRL_LONGER_WATCH:
        snprintf(text, size, "watch %.2g times as many revolutions", factor);
        return;
    case WHIRL_TIGHTER:
        snprintf(text, size, "integrate with errors of a step %.3g times smaller", factor);
        return;
    case WHIRL_NO_REMEDY:
        break;
    }
    snprintf(text, size, "%s", "");
}
