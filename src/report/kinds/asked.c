// Judges results by acceptance criteria of standards: requirements, values found, and judgements. They are derived only
// here, from the fields of a result.
//
// Clauses are given by the number after the chapter, which is the same in all editions: SP6.8 of API RP 684 (2nd
// edition, 2005), 2.6 of API 617 (7th, 2002), 4.8 of its first part (8th, 2014). The user has to check which edition
// applies.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "asked.h"
#include "margins.h"
#include "scaled_response.h"

const double asked_decrement = 0.1;

static const char no_mode[] = "no mode was found that does not go backward";

// ---------------------------------------------------------------- stability

asked_stability asked_stability_at(const whirl_table *table, size_t point) {
    asked_stability at = {
        .anticipated = whirl_table_number(table, point, WHIRL_FIELD_STABILITY_ANTICIPATED, 0),
        .limit = whirl_table_number(table, point, WHIRL_FIELD_STABILITY_LIMIT, 0),
        .decrement = whirl_table_number(table, point, WHIRL_FIELD_STABILITY_DECREMENT, 0),
        .complete = whirl_table_number(table, point, WHIRL_FIELD_STABILITY_COMPLETE, 0),
        .region = whirl_table_number(table, point, WHIRL_FIELD_STABILITY_REGION, 0),
    };
    at.stages = at.anticipated > 0.0;
    at.ratio = at.stages ? at.limit / at.anticipated : (double)NAN;
    at.factor = at.region > 0.5 ? 10.0 : 2.0;
    if (at.stages)
        at.level_one = isnan(at.decrement) ? WHIRL_NOT_KNOWN
                       : at.decrement >= asked_decrement && !(at.ratio < at.factor)
                           ? WHIRL_HOLDS // limit not found: far above the requirement
                           : WHIRL_FAILS;
    at.decides = at.level_one != WHIRL_HOLDS;
    at.level_two = isnan(at.complete) ? WHIRL_NOT_KNOWN : at.complete > asked_decrement ? WHIRL_HOLDS : WHIRL_FAILS;
    return at;
}

void asked_stability_text(const asked_stability *at, char text[ASKED_TEXT]) {
    // Write the judgement with seals and impellers (Level II).
    const char *const with = at->level_one == WHIRL_HOLDS ? "seals and impellers" : "them";
    char whole[ASKED_TEXT / 2];
    if (at->level_two == WHIRL_NOT_KNOWN)
        snprintf(whole, sizeof whole, "with %s %s: not known", with, no_mode);
    else
        snprintf(whole, sizeof whole, "decrement %.3g with %s, above %g asked for: %s", at->complete, with,
                 asked_decrement, whirl_judgement_name(at->level_two));
    // Write the judgement without them (Level I), and what follows from it.
    if (isnan(at->decrement))
        snprintf(text, ASKED_TEXT, "%s: not known", no_mode);
    else if (!at->stages)
        snprintf(text, ASKED_TEXT, "no stages: seals and impellers decide; %s", whole);
    else if (at->level_one == WHIRL_HOLDS && at->level_two == WHIRL_HOLDS)
        snprintf(text, ASKED_TEXT, "decrement above %g and limit above %g times the anticipated: holds by Level I",
                 asked_decrement, at->factor);
    else if (at->level_one == WHIRL_HOLDS)
        snprintf(text, ASKED_TEXT,
                 "decrement above %g and limit above %g times the anticipated, as Level I asks for, but %s",
                 asked_decrement, at->factor, whole);
    else if (at->decrement < asked_decrement)
        snprintf(text, ASKED_TEXT, "decrement too small: seals and impellers are to be counted (Level II); %s", whole);
    else
        snprintf(text, ASKED_TEXT,
                 "%slimit below %g times the anticipated: seals and impellers are to be counted (Level II); %s",
                 at->region > 0.5 ? "region B and " : "", at->factor, whole);
}

/// Returns true if point `at` is worse by Level I than point `than`: its limit is a smaller share of the required one
/// or, at equal shares, more is required.
static bool lacks_more(const asked_stability *at, const asked_stability *than) {
    const double share = isnan(at->ratio) ? (double)INFINITY : at->ratio / at->factor;
    const double other = isnan(than->ratio) ? (double)INFINITY : than->ratio / than->factor;
    return share < other || (share == other && at->factor > than->factor);
}

asked_stability_tally asked_stability_count(const whirl_table *table) {
    asked_stability_tally all = {.least = {.complete = NAN, .decrement = NAN}, .decrement = NAN};
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const asked_stability at = asked_stability_at(table, point);
        all.points++;
        all.without += isnan(at.complete);
        all.screened += isfinite(at.region);
        all.dense += at.region > 0.5;
        if (at.level_one > all.level_one) all.level_one = at.level_one;
        if (at.level_two > all.level_two) all.level_two = at.level_two;
        if (at.stages && (!all.coupled.stages || lacks_more(&at, &all.coupled))) all.coupled = at;
        if (at.stages) all.decrement = fmin(all.decrement, at.decrement);
        if (isnan(all.least.complete) || at.complete < all.least.complete) all.least = at;
    }
    return all;
}

// ---------------------------------------------------------------- responses

/// States the separation margin of the worst peak: that with the largest deficit or, without deficits, the least
/// surplus.
static void ask_margin(const finder *of) {
    const margin_tally all = margin_count(of->result, of->table);
    const margin_row *const peak = &all.worst;
    whirl_statement *own = find_judgement(of, "separation margin", "SP6.8.2.10", all.verdict);
    // State requirement and margin of the worst peak.
    if (all.judged > 0) {
        phrase_number(of, &own->asked, WHIRL_QUANTITY_PERCENT, 3, peak->asked);
        phrase_text(of, &own->asked, " (amplification %.3g)", peak->amplification);
        if (isnan(peak->had)) {
            phrase_text(of, &own->found, "peak within the running speeds");
        } else {
            phrase_number(of, &own->found, WHIRL_QUANTITY_PERCENT, 3, peak->had);
            phrase_text(of, &own->found, " %s", peak->side);
        }
        phrase_text(of, &own->found, ": %s at ", of->result->stations[all.station].name);
        phrase_number(of, &own->found, WHIRL_QUANTITY_SPEED, 5, peak->speed);
    } else if (!all.lacks) {
        phrase_text(of, &own->found, "no amplification of 2.5 or more%s at the computed speeds",
                    *of->table->record.probes_at ? " at a probe" : "");
    }
    // State the reason of the judgement.
    if (all.verdict == WHIRL_FAILS)
        phrase_text(of, &own->judged, ": %zu of %zu peaks%s", all.judged - all.held, all.judged,
                    all.lacks ? " that were found" : "");
    else if (all.verdict == WHIRL_HOLDS)
        phrase_text(of, &own->judged, ": %zu of %zu peaks", all.held, all.judged);
    if (all.lacks) phrase_text(of, &own->judged, "%s %s", all.verdict == WHIRL_FAILS ? ";" : ":", all.lacks);
    if (all.unjudged > 0)
        phrase_text(of, &own->judged, "; %zu peak%s of that amplification at stations without a probe not judged",
                    all.unjudged, all.unjudged == 1 ? "" : "s");
}

static void ask_vibration(const finder *of, const response_scale *by) {
    whirl_statement *own =
        find_judgement(of, "vibration at probes where it runs", "SP6.8.2.11", by->beyond ? WHIRL_FAILS : WHIRL_HOLDS);
    phrase_text(of, &own->asked, "at most ");
    phrase_number(of, &own->asked, WHIRL_QUANTITY_SPAN, 4, by->limit);
    phrase_number(of, &own->found, WHIRL_QUANTITY_SPAN, 4, by->largest);
    phrase_text(of, &own->found, " at %s", of->result->stations[by->station].name);
}

/// States the station whose scaled response takes the largest share of its clearance.
static void ask_clearance(const finder *of, const response_scale *by) {
    scaled_response close;
    if (!scaled_response_tightest(of->result, of->table, by, &close)) return;
    whirl_statement *own =
        find_judgement(of, "close clearances", "SP6.8.2.12", close.holds ? WHIRL_HOLDS : WHIRL_FAILS);
    phrase_text(of, &own->asked, "at most 75 %% of the diametral clearance");
    phrase_number(of, &own->found, WHIRL_QUANTITY_PERCENT, 3, 100.0 * close.axis / close.clearance);
    phrase_text(of, &own->found, " at %s, ", of->result->stations[close.station].name);
    phrase_number(of, &own->found, WHIRL_QUANTITY_SPEED, 5, close.speed);
    phrase_text(of, &own->found, ", scaled by %.4g", by->factor);
    if (close.holds && by->trip > 0.0 && !by->reaches)
        phrase_text(of, &own->judged, ", but points do not reach the trip speed");
}

void ask_response(const finder *of) {
    response_scale by;
    if (!margin_asked(of->table)) return;
    ask_margin(of);
    if (scaled_response_scale(of->result, of->table, &by)) {
        ask_vibration(of, &by);
        ask_clearance(of, &by);
    } else {
        whirl_statement *own = find_judgement(of, "vibration at probes, clearances", "SP6.8.2.11", WHIRL_NOT_KNOWN);
        phrase_text(of, &own->judged, ": %s", scaled_response_lacks);
    }
}

// ---------------------------------------------------------------- the table of stability

void ask_stability(const finder *of) {
    const asked_stability_tally all = asked_stability_count(of->table);
    if (all.points == 0) return;
    // Level I, if a cross coupling is anticipated.
    if (all.coupled.stages) {
        whirl_statement *one = find_judgement(of, "stability, Level I", "SP6.8.5", all.level_one);
        phrase_text(of, &one->asked,
                    "limit of the cross coupling at least %g times the anticipated, decrement at least %g",
                    all.coupled.factor, asked_decrement);
        if (isnan(all.decrement)) {
            phrase_text(of, &one->found, "%s", no_mode);
        } else {
            phrase_text(of, &one->found, "decrement ");
            phrase_number(of, &one->found, WHIRL_QUANTITY_NUMBER, 3, all.decrement);
            phrase_text(of, &one->found, isfinite(all.coupled.ratio) ? ", limit " : ", no limit below 1000 times");
            if (isfinite(all.coupled.ratio)) {
                phrase_number(of, &one->found, WHIRL_QUANTITY_NUMBER, 3, all.coupled.ratio);
                phrase_text(of, &one->found, " times");
            }
        }
        if (all.screened > 0)
            phrase_text(of, &one->found, "; %zu of %zu points in region B of the screening diagram", all.dense,
                        all.screened);
        if (all.level_one != WHIRL_HOLDS) phrase_text(of, &one->judged, ": Level II decides");
    }
    // Level II.
    whirl_statement *two = find_judgement(of, "stability, Level II", "SP6.8.6", all.level_two);
    phrase_text(of, &two->asked, "decrement above %g with seals and impellers", asked_decrement);
    if (all.without < all.points) {
        phrase_text(of, &two->found, "decrement ");
        phrase_number(of, &two->found, WHIRL_QUANTITY_NUMBER, 3, all.least.complete);
    }
    if (all.level_two == WHIRL_NOT_KNOWN)
        phrase_text(of, &two->judged, ": %s at %zu of %zu points", no_mode, all.without, all.points);
    else if (all.level_two == WHIRL_FAILS && !all.least.decides)
        phrase_text(of, &two->judged, ", though Level I holds there");
}
