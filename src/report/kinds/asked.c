// What is asked of a machine, what was found and whether it holds: derived here alone, from the fields of a result.
//
// Clauses are told by what follows the number of the chapter, which editions have alike: SP6.8 of API RP 684 (2nd
// edition, 2005), 2.6 of API 617 (7th, 2002), 4.8 of its first part (8th, 2014). Which edition counts is for the user
// to check.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "shown_kinds.h"
#include "summary.h"

const double asked_decrement = 0.1;

static const char no_mode[] = "no mode was found that does not go backward";

const char *asked_verdict_name(asked_verdict verdict) {
    static const char *const names[] = {"none asked for", "holds", "not known", "fails"};
    return names[verdict];
}

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
        at.level_one = isnan(at.decrement) ? ASKED_UNKNOWN
                       : at.decrement >= asked_decrement && !(at.ratio < at.factor)
                           ? ASKED_HOLDS // not found: far above
                           : ASKED_FAILS;
    at.decides = at.level_one != ASKED_HOLDS;
    at.level_two = isnan(at.complete) ? ASKED_UNKNOWN : at.complete > asked_decrement ? ASKED_HOLDS : ASKED_FAILS;
    return at;
}

void asked_stability_told(const asked_stability *at, char text[ASKED_TEXT]) {
    const char *const with = at->level_one == ASKED_HOLDS ? "seals and impellers" : "them";
    char whole[ASKED_TEXT / 2];
    if (at->level_two == ASKED_UNKNOWN)
        snprintf(whole, sizeof whole, "with %s %s: not known", with, no_mode);
    else
        snprintf(whole, sizeof whole, "decrement %.3g with %s, above %g asked for: %s", at->complete, with,
                 asked_decrement, asked_verdict_name(at->level_two));
    if (isnan(at->decrement))
        snprintf(text, ASKED_TEXT, "%s: not known", no_mode);
    else if (!at->stages)
        snprintf(text, ASKED_TEXT, "no stages: seals and impellers decide; %s", whole);
    else if (at->level_one == ASKED_HOLDS && at->level_two == ASKED_HOLDS)
        snprintf(text, ASKED_TEXT, "decrement above %g and limit above %g times the anticipated: holds by Level I",
                 asked_decrement, at->factor);
    else if (at->level_one == ASKED_HOLDS)
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

/// Whether Level I lacks more at a point than at another one: less of the limit that is asked for there, or more asked
/// for where no limit was found at either.
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

// ---------------------------------------------------------------- rows

static asked_row *add_row(asked_rows *to, const char *what, const char *clause, asked_verdict verdict) {
    asked_row *row = &to->rows[to->count++];
    *row = (asked_row){.what = what, .clause = clause, .verdict = verdict};
    snprintf(row->told, ASKED_TEXT, "%s", asked_verdict_name(verdict));
    return row;
}

/// The peak that lacks most of its margin, or has least more than that.
static void add_margin(const whirl_shown_units *units, const whirl_table *table, asked_rows *to) {
    const whirl_result *result = units->result;
    const margin_tally all = margin_count(result, table, units);
    const margin_row *const peak = &all.worst;
    asked_row *row = add_row(to, "separation margin", "2.10", all.verdict);
    if (all.told > 0) {
        snprintf(row->asked, ASKED_TEXT, "%.3g %% (amplification %.3g)", peak->asked, peak->amplification);
        snprintf(row->found, ASKED_TEXT, isnan(peak->had) ? "peak within the running speeds" : "%.3g %% %s", peak->had,
                 peak->above ? "above" : "below");
        const size_t used = strlen(row->found);
        snprintf(row->found + used, ASKED_TEXT - used, ": %s at %.5g %s", result->stations[all.station].name,
                 peak->speed, margin_speed_unit(units).name);
    } else if (!all.lacks) {
        snprintf(row->found, ASKED_TEXT, "no amplification of 2.5 or more%s at the speeds that were looked at",
                 *table->record.probes_at ? " at a probe" : "");
    }
    if (all.verdict == ASKED_FAILS)
        snprintf(row->told, ASKED_TEXT, "fails: %zu of %zu peaks%s", all.told - all.held, all.told,
                 all.lacks ? " that were found" : "");
    else if (all.lacks)
        snprintf(row->told, ASKED_TEXT, "not known: %s", all.lacks);
}

static void add_vibration(const whirl_shown_units *units, const scaled *by, asked_rows *to) {
    const whirl_unit length = scaled_unit(units);
    asked_row *row = add_row(to, "vibration at probes where it runs", "2.11", by->beyond ? ASKED_FAILS : ASKED_HOLDS);
    snprintf(row->asked, ASKED_TEXT, "at most %.4g %s p-p", by->limit / length.size, length.name);
    snprintf(row->found, ASKED_TEXT, "%.4g %s p-p at %s", by->largest / length.size, length.name,
             units->result->stations[by->station].name);
}

/// The clearance of which scaled responses take most.
static void add_clearance(const whirl_shown_units *units, const whirl_table *table, const scaled *by, asked_rows *to) {
    const whirl_result *result = units->result;
    const whirl_unit speed = margin_speed_unit(units);
    scaled_row close;
    if (!scaled_tightest(result, table, by, &close)) return;
    asked_row *row = add_row(to, "close clearances", "2.12", close.holds ? ASKED_HOLDS : ASKED_FAILS);
    snprintf(row->asked, ASKED_TEXT, "at most 75 %% of the diametral clearance");
    snprintf(row->found, ASKED_TEXT, "%.3g %% at %s, %.5g %s, scaled by %.4g", 100.0 * close.axis / close.clearance,
             result->stations[close.station].name, close.speed / speed.size, speed.name, by->factor);
    snprintf(row->told, ASKED_TEXT, "%s", scaled_verdict(by, &close));
}

static void ask_response(const whirl_shown_units *units, const whirl_table *table, asked_rows *to) {
    scaled by;
    if (!margin_asked(table)) return;
    add_margin(units, table, to);
    if (scaled_of(units->result, table, &by)) {
        add_vibration(units, &by, to);
        add_clearance(units, table, &by, to);
    } else {
        asked_row *row = add_row(to, "vibration at probes, clearances", "2.11", ASKED_UNKNOWN);
        snprintf(row->told, ASKED_TEXT, "not known: %s", scaled_lacks);
    }
}

static void ask_stability(const whirl_table *table, asked_rows *to) {
    const asked_stability_tally all = asked_stability_count(table);
    if (all.coupled.stages) {
        asked_row *one = add_row(to, "stability, Level I", "5", all.level_one);
        snprintf(one->asked, ASKED_TEXT,
                 "limit of the cross coupling at least %g times the anticipated, decrement at least %g",
                 all.coupled.factor, asked_decrement);
        if (isnan(all.decrement))
            snprintf(one->found, ASKED_TEXT, "%s", no_mode);
        else
            snprintf(one->found, ASKED_TEXT,
                     isfinite(all.coupled.ratio) ? "decrement %.3g, limit %.3g times"
                                                 : "decrement %.3g, no limit below 1000 times",
                     all.decrement, all.coupled.ratio);
        if (all.level_one != ASKED_HOLDS) snprintf(one->told, ASKED_TEXT, "not enough: Level II decides");
    }
    asked_row *two = add_row(to, "stability, Level II", "6", all.level_two);
    snprintf(two->asked, ASKED_TEXT, "decrement above %g with seals and impellers", asked_decrement);
    if (all.without < all.points) snprintf(two->found, ASKED_TEXT, "decrement %.3g", all.least.complete);
    if (all.level_two == ASKED_UNKNOWN)
        snprintf(two->told, ASKED_TEXT, "not known: %s at %zu of %zu points", no_mode, all.without, all.points);
    else if (all.level_two == ASKED_FAILS && !all.least.decides)
        snprintf(two->told, ASKED_TEXT, "fails, though Level I holds there");
}

asked_rows asked_of(const whirl_shown_units *units, const whirl_table *table) {
    asked_rows rows = {.count = 0};
    if (table->count == 0) return rows;
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_UNBALANCE_PROBE)) ask_response(units, table, &rows);
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_STABILITY_COMPLETE)) ask_stability(table, &rows);
    return rows;
}
