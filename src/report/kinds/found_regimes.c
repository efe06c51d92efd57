// Findings on regimes: ranges of a parameter with one regime, numbers of points of each regime, confidence, motions in
// doubt, and jumps within a regime.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "found_motions.h"
#include "quantities.h"
#include "regimes.h"
#include "shown_kinds.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

/// A sentence names at most this many ranges; a sheet has all.
enum { MAX_RANGES = 12 };

/// Words for values on the way back of a sweep in both directions.
static const char back[] = "on the way back";

// ---------------------------------------------------------------- ranges

/// Adds the columns of a stretch of the parameter and its regime: from, to, way, attractor, regime.
static void sheet_stretch(const finder *of, whirl_sheet *sheet) {
    sheet_values(of, sheet, "from", 6);
    sheet_values(of, sheet, "to", 6);
    sheet_texts(of, sheet, "way", "way");
    sheet_column(of, sheet, "attractor", "attractor", WHIRL_QUANTITY_NUMBER, 6);
    sheet_texts(of, sheet, "regime", "regime");
}

/// Fills the cells of a stretch from one point to another that come before the cell of the regime.
static void cells_stretch(const finder *of, whirl_sheet *sheet, size_t from, size_t to) {
    const whirl_table *table = of->table;
    cell_number(of, sheet, table->values[from]);
    cell_number(of, sheet, table->values[to]);
    cell_text(of, sheet, table->branch[from] < 0 ? back : "");
    cell_number(of, sheet, table->attractors ? (double)table->attractors[from].number : (double)NAN);
}

/// Intervals of one regime along a parameter.
typedef struct regime_ranges {
    regime_interval *intervals; ///< [count]
    size_t count;
    bool merged;   ///< short intervals in a row are one range, since there are many
    size_t ranges; ///< number of ranges
} regime_ranges;

/// Returns the number of intervals from `first` on that are one range.
static size_t range_length(const regime_ranges *ranges, size_t first) {
    return ranges->merged ? regime_group(&ranges->intervals[first], ranges->count - first) : 1;
}

/// States the ranges: "P-1 from 1 to 3.25 rad/s; changing: P-3, chaotic from 3.3 to 3.5 rad/s".
static void state_ranges(const finder *of, const regime_ranges *ranges) {
    const double *values = of->table->values;
    if (ranges->ranges > MAX_RANGES || accompanying_motions(of->table)) return; // find_together describes these
    whirl_phrase *found = &find_statement(of, "regimes")->found;
    for (size_t i = 0, length; i < ranges->count; i += length) {
        char name[512];
        const regime_interval *own = &ranges->intervals[i];
        length = range_length(ranges, i);
        const size_t last = own[length - 1].last;
        regime_group_name(own, length, name, sizeof name);
        phrase_text(of, found, "%s%s %s ", i > 0 ? "; " : "", name, last > own->first ? "from" : "at");
        phrase_value(of, found, 6, values[own->first]);
        if (last > own->first) {
            phrase_text(of, found, " to ");
            phrase_value(of, found, 6, values[last]);
        }
        if (own->branch < 0) phrase_text(of, found, " %s", back);
        if (of->table->attractors) phrase_text(of, found, " (attractor %zu)", of->table->attractors[own->first].number);
    }
}

/// Adds a row for `length` intervals in a row.
static void range_row(const finder *of, whirl_sheet *sheet, const regime_interval *own, size_t length) {
    char name[512];
    size_t points = 0, rubbing = 0;
    for (size_t i = 0; i < length; i++) {
        points += own[i].count;
        rubbing += own[i].rubbing;
    }
    regime_group_name(own, length, name, sizeof name);
    sheet_row(of, sheet);
    cells_stretch(of, sheet, own->first, own[length - 1].last);
    cell_regime(of, sheet, name, own->kind);
    cell_number(of, sheet, (double)points);
    cell_number(of, sheet, of->result->contact_count > 0 ? (double)rubbing : (double)NAN);
    cell_number(of, sheet, length > 1 ? (double)length : (double)NAN);
}

/// Adds the rows of ranges, or of all intervals, to a sheet.
static void sheet_ranges(const finder *of, const regime_ranges *ranges, whirl_sheet *sheet, bool all) {
    sheet_stretch(of, sheet);
    sheet_column(of, sheet, "points", "points", WHIRL_QUANTITY_NUMBER, 9);
    sheet_column(of, sheet, "rubbing", "of these with rub", WHIRL_QUANTITY_NUMBER, 9);
    sheet_column(of, sheet, "windows", "windows", WHIRL_QUANTITY_NUMBER, 9);
    for (size_t i = 0, length; i < ranges->count; i += length) {
        length = all ? 1 : range_length(ranges, i);
        range_row(of, sheet, &ranges->intervals[i], length);
    }
}

/// Adds the findings on ranges along a parameter. Returns true if a sentence has all ranges.
static bool find_intervals(const finder *of) {
    const whirl_table *table = of->table;
    if (!*table->parameter || table->row > 0) return false;
    regime_ranges ranges = {.intervals = malloc((table->count + 1) * sizeof *ranges.intervals)};
    if (!ranges.intervals) {
        of->findings->failed = true;
        return false;
    }
    // Find the intervals, and merge short ones if there are many.
    ranges.count = regime_intervals(table, of->result->contact_count, ranges.intervals, table->count);
    ranges.merged = ranges.count > MAX_RANGES;
    for (size_t i = 0; i < ranges.count; i += range_length(&ranges, i)) ranges.ranges++;
    if (ranges.count > 0) {
        state_ranges(of, &ranges);
        whirl_sheet *sheet = find_sheet(of, "regimes", "Regimes along the sweep");
        sheet->unsummarized = ranges.ranges <= MAX_RANGES;
        sheet_ranges(of, &ranges, sheet, false);
    }
    if (ranges.ranges < ranges.count) {
        whirl_sheet *sheet = find_sheet(of, "windows", "All intervals of one regime along the sweep");
        sheet->looked_up = true;
        sheet_ranges(of, &ranges, sheet, true);
    }
    free(ranges.intervals);
    return ranges.ranges <= MAX_RANGES;
}

// ---------------------------------------------------------------- numbers of points

/// Numbers of points of a table: all, those that rub, those with failed exponents, those of each confidence, and those
/// of each regime in the order of their first points.
typedef struct regime_counts {
    size_t all, rubbing, failed, sure[WHIRL_HIGH + 1], count;
    struct {
        char name[LABEL_SIZE];
        regime_class kind;
        size_t points;
    } regimes[WHIRL_MAX_PERIOD + 8];
} regime_counts;

/// Counts the points of a table; for a refined map the points of its grid.
static void regimes_count(const finder *of, regime_counts *counts) {
    enum { MAX_REGIMES = sizeof counts->regimes / sizeof *counts->regimes };
    const whirl_table *table = of->table;
    size_t *weights;
    *counts = (regime_counts){.all = 0};
    const bool weighed = motions_weights(of, &weights);
    for (size_t point = 0; weighed && point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const size_t weight = weights ? weights[point] : 1;
        const whirl_verdict verdict = whirl_table_verdict(table, point);
        char name[LABEL_SIZE];
        counts->all += weight;
        counts->rubbing += rub_share(table, point, of->result->contact_count) > 0.0 ? weight : 0;
        counts->failed += verdict.exponents_failed ? weight : 0;
        counts->sure[verdict.confidence] += weight;
        regime_name(&verdict, name, sizeof name);
        size_t i = 0;
        while (i < counts->count && strcmp(counts->regimes[i].name, name) != 0) i++;
        if (i == MAX_REGIMES) continue;
        if (i == counts->count) {
            memcpy(counts->regimes[i].name, name, sizeof name);
            counts->regimes[counts->count++].kind = regime_class_of(&verdict);
        }
        counts->regimes[i].points += weight;
    }
    free(weights);
}

static void sheet_counts(const finder *of, const regime_counts *counts) {
    whirl_sheet *sheet = find_sheet(of, "counts", "Points of each regime");
    sheet_texts(of, sheet, "regime", "regime");
    sheet_column(of, sheet, "points", "points", WHIRL_QUANTITY_NUMBER, 9);
    sheet_column(of, sheet, "share", "share", WHIRL_QUANTITY_PERCENT, 3);
    for (size_t i = 0; i < counts->count; i++) {
        sheet_row(of, sheet);
        cell_regime(of, sheet, counts->regimes[i].name, counts->regimes[i].kind);
        cell_number(of, sheet, (double)counts->regimes[i].points);
        cell_number(of, sheet, 100.0 * (double)counts->regimes[i].points / (double)counts->all);
    }
    find_sheet_end(of);
}

/// States the number of motions that rub, and of verdicts by confidence.
static void state_counts(const finder *of, const regime_counts *counts) {
    if (of->result->contact_count > 0 && !accompanying_motions(of->table))
        phrase_text(of, &find_statement(of, "rub")->found, "at %zu of %zu points", counts->rubbing, counts->all);
    if (counts->failed > 0)
        phrase_text(of, &find_statement(of, "exponents")->found,
                    "failed at %zu points: take a smaller tolerance, or more steps", counts->failed);
    phrase_text(of, &find_statement(of, "confidence")->found, "%zu high, %zu fair, %zu low", counts->sure[WHIRL_HIGH],
                counts->sure[WHIRL_FAIR], counts->sure[WHIRL_LOW]);
}

// ---------------------------------------------------------------- motions in doubt

/// States the reasons of undetermined motions, their numbers, and the changes that would settle them.
static void find_doubts(const finder *of) {
    const whirl_table *table = of->table;
    whirl_doubt doubts[WHIRL_REMEDIES];
    const size_t count = whirl_table_doubts(table, doubts);
    bool remedied = false;
    for (size_t i = 0; i < count; i++) {
        char text[WHIRL_MESSAGE_SIZE];
        whirl_phrase *found = &find_statement(of, "undetermined")->found;
        phrase_text(of, found, "at %zu point%s", doubts[i].points, doubts[i].points == 1 ? "" : "s");
        if (*table->parameter) {
            phrase_text(of, found, ", first at ");
            phrase_value(of, found, 6, table->values[doubts[i].first]);
        }
        whirl_verdict_reason(&doubts[i].verdict, text, sizeof text);
        phrase_text(of, found, ": %s", text);
        whirl_verdict_advice(&doubts[i].verdict, text, sizeof text);
        if (*text) phrase_text(of, found, "; to settle it, %s", text);
        const whirl_remedy remedy = doubts[i].verdict.advice.remedy;
        remedied = remedied || (remedy != WHIRL_NO_REMEDY && remedy != WHIRL_OTHER_START);
    }
    if (remedied)
        phrase_text(of, &find_statement(of, "undetermined points")->found, "whirl run --refine does them again so");
}

/// States the number of points that refinement computed again.
static void find_refined(const finder *of) {
    const whirl_table *table = of->table->source ? of->table->source : of->table;
    size_t refined = 0, doubtful = 0;
    if (!whirl_layout_field(&table->layout, WHIRL_FIELD_REFINE_ROUNDS)) return;
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        refined += point_number(table, point, WHIRL_FIELD_REFINE_ROUNDS) > 0;
        doubtful += whirl_table_verdict(table, point).confidence == WHIRL_LOW;
    }
    phrase_text(of, &find_statement(of, "refined")->found, "%zu point%s, %zu still in doubt", refined,
                refined == 1 ? "" : "s", doubtful);
}

/// States how many points of its grid a refined map computed.
static void find_grid(const finder *of) {
    const whirl_table *table = of->table;
    size_t done = 0;
    if (table->refine == 0) return;
    for (size_t point = 0; point < table->count; point++) done += whirl_table_done(table, point);
    phrase_text(of, &find_statement(of, "refined")->found,
                "from squares of %zu: %zu of %zu points computed (%.1f %%), %.0f revolutions each; all would have "
                "taken about %.3g revolutions",
                table->refine, done, table->grid, 100.0 * (double)done / (double)table->grid,
                whirl_table_revolutions(table), whirl_table_grid_revolutions(table));
}

// ---------------------------------------------------------------- jumps

static void find_jumps(const finder *of) {
    enum { MAX_JUMPS = 24 };
    const whirl_table *table = of->table;
    whirl_jump jumps[MAX_JUMPS];
    size_t count;
    if (!*table->parameter || whirl_table_jumps(table, jumps, MAX_JUMPS, &count).code != WHIRL_OK || count == 0) return;
    // State their number and the first.
    whirl_phrase *found = &find_statement(of, "jumps within a regime")->found;
    phrase_text(of, found, "%zu%s between ", count, count > 1 ? ", the first" : ",");
    phrase_value(of, found, 5, table->values[jumps[0].from]);
    phrase_text(of, found, " and ");
    phrase_value(of, found, 5, table->values[jumps[0].to]);
    phrase_text(of, found, ": two coexisting motions, or one that changes suddenly");
    // List them.
    whirl_sheet *sheet = find_sheet(of, "jumps", "Jumps within a regime");
    sheet->unsummarized = true;
    sheet->about = find_text(
        of->findings,
        "Between these neighbouring points the regime stays, but the motion changes far more than between the points "
        "around. Two motions may coexist there, and the start decides between them; or one motion changes suddenly. A "
        "sweep with start: carry and direction: both, or other initial states, may decide.%s",
        count > MAX_JUMPS ? find_text(of->findings, " These are the first %d of %zu.", MAX_JUMPS, count) : "");
    sheet_stretch(of, sheet);
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "change", "change, of the motion's size", WHIRL_QUANTITY_PERCENT, 2);
    sheet_column(of, sheet, "usual", "from point to point around", WHIRL_QUANTITY_PERCENT, 2);
    for (size_t i = 0; i < count && i < MAX_JUMPS; i++) {
        const whirl_verdict verdict = whirl_table_verdict(table, jumps[i].from);
        char name[LABEL_SIZE];
        regime_name(&verdict, name, sizeof name);
        sheet_row(of, sheet);
        cells_stretch(of, sheet, jumps[i].from, jumps[i].to);
        cell_regime(of, sheet, name, regime_class_of(&verdict));
        cell_station(of, sheet, jumps[i].station);
        cell_number(of, sheet, 100.0 * jumps[i].change);
        cell_number(of, sheet, 100.0 * jumps[i].usual);
    }
}

void find_regimes(const finder *of) {
    const whirl_table *table = of->table;
    find_grid(of);
    if (whirl_layout_has_verdict(&table->layout) && !find_alone(of)) {
        regime_counts counts;
        // Points in detail are no ranges: their verdicts are listed.
        const bool stated = table->role == WHIRL_ROLE_DETAIL || find_intervals(of);
        regimes_count(of, &counts);
        if (!stated) sheet_counts(of, &counts);
        if (counts.all > 0) state_counts(of, &counts);
        find_doubts(of);
    }
    find_refined(of);
    find_jumps(of);
}
