// Statements on motions that are described together: how many come back, with which unbalances, how near they come to
// walls, and which contacts they close.
#include <math.h>

#include "found_motions.h"
#include "quantities.h"
#include "shown_kinds.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"
#include "whirl/engine/system.h"
#include "whirl/internal/shown.h"

/// Adds `before` and the parameter's value at a point, "5700 rpm"; adds nothing without a parameter.
static void add_place(const finder *of, whirl_phrase *found, const char *before, size_t point) {
    if (!*of->table->parameter) return;
    phrase_text(of, found, "%s", before);
    phrase_value(of, found, 6, of->table->values[point]);
}

// ---------------------------------------------------------------- number of motions

static void add_unbalances(const finder *of, whirl_phrase *found) {
    const whirl_record_options *record = &of->table->record;
    if (record->antinodes_of > 0)
        phrase_text(of, found, ", with unbalances by rule at the antinodes of forward mode %d", record->antinodes_of);
    else if (*record->placed_at)
        phrase_text(of, found, ", with an unbalance by rule at %s", record->placed_at);
    else
        phrase_text(of, found, ", with the machine's own unbalances");
    if (record->placed_factor != 1.0) phrase_text(of, found, ", %.4g times as large", record->placed_factor);
}

/// Adds the number of motions without a verdict, and their length.
static void add_count(const finder *of, whirl_phrase *found) {
    const whirl_table *table = of->table;
    size_t done = 0, first;
    for (size_t i = 0; i < table->count; i++) done += whirl_table_done(table, i);
    phrase_text(of, found, "%zu, not judged (analyze: regime): %d revolutions%s", done, table->record.record,
                table->record.transient == 0 ? " from the start" : " after a transient");
    if (done < whirl_table_planned(table)) phrase_text(of, found, " (of %zu points)", whirl_table_planned(table));
    const size_t lost = motions_lost(table, &first);
    if (lost > 0)
        phrase_text(of, found, "; %zu of them ended early (clearances and contacts are reported without %s)", lost,
                    lost == 1 ? "it" : "them");
}

/// Adds the number of starts without a verdict, and of points all of whose starts lack one: the table has no motion of
/// such points.
static void add_undetermined(const finder *of, whirl_phrase *found) {
    const whirl_table *const table = of->table, *const source = table->source;
    size_t done, undetermined;
    double with_motions = 0.0;
    starts_count(source, &done, &undetermined);
    if (done < whirl_table_planned(source))
        phrase_text(of, found, " (%zu of %zu starts are computed)", done, whirl_table_planned(source));
    if (undetermined == 0) return;
    phrase_text(of, found, ", %zu of %zu starts have no verdict", undetermined, done);
    for (size_t i = 0; i < table->count; i++) with_motions += 1.0 / (double)table->attractors[i].coexisting;
    const double places = (double)whirl_table_places(table), without = places - round(with_motions);
    if (done == whirl_table_planned(source) && without > 0.0)
        phrase_text(of, found, " (at %.0f of %.0f points none of them has one)", without, places);
}

/// Adds the number of motions that come back every revolution, diverge, or are in doubt.
static void add_regimes(const finder *of, whirl_phrase *found) {
    const whirl_table *table = of->table;
    size_t done = 0, periodic = 0, doubtful = 0, diverged = 0;
    for (size_t i = 0; i < table->count; i++) {
        if (!whirl_table_done(table, i)) continue;
        const whirl_verdict verdict = whirl_table_verdict(table, i);
        done++;
        periodic += verdict.regime == WHIRL_PERIODIC && verdict.period == 1;
        doubtful += verdict.regime == WHIRL_UNDETERMINED || verdict.confidence == WHIRL_LOW;
        diverged += verdict.regime == WHIRL_DIVERGING;
    }
    phrase_text(of, found, "%zu of %zu come back every revolution", periodic, done);
    if (diverged > 0)
        phrase_text(of, found,
                    ", %zu diverge (a station comes to the wall of a film or seal, or a coordinate beyond the limit: "
                    "clearances and contacts are reported without them)",
                    diverged);
    if (doubtful > 0) phrase_text(of, found, ", %zu are in doubt", doubtful);
    if (table->attractors)
        add_undetermined(of, found);
    else if (done < whirl_table_planned(table))
        phrase_text(of, found, " (of %zu points)", whirl_table_planned(table));
}

// ---------------------------------------------------------------- walls

/// Closest approach of motions to a wall.
typedef struct nearest_wall {
    double share;
    size_t station, point;
    bool film; ///< the wall belongs to a bearing
} nearest_wall;

static void nearest_look(const finder *of, size_t point, nearest_wall *found) {
    point_machine own;
    const whirl_probe *probes = point_probes(of, point, &own);
    for (size_t s = 0; s < of->result->station_count; s++) {
        const double radius = max_radius(of->table, point, s), walls[] = {probes[s].clearance, probes[s].gap};
        for (int k = 0; k < 2; k++)
            if (walls[k] > 0.0 && radius / walls[k] > found->share)
                *found = (nearest_wall){.share = radius / walls[k], .station = s, .point = point, .film = k == 0};
    }
    point_release(&own);
}

static void state_nearest(const finder *of) {
    nearest_wall nearest = {.share = -1.0};
    for (size_t i = 0; i < of->table->count; i++)
        if (whirl_table_done(of->table, i)) nearest_look(of, i, &nearest);
    if (nearest.share < 0.0) return;
    whirl_statement *own = find_statement(of, "nearest to a wall");
    own->station = find_text(of->findings, "%s", of->result->stations[nearest.station].name);
    phrase_number(of, &own->found, WHIRL_QUANTITY_PERCENT, 3, 100.0 * nearest.share);
    phrase_text(of, &own->found, " of its radial %s", nearest.film ? "clearance" : "gap");
    add_place(of, &own->found, ", at ", nearest.point);
}

/// States where a contact is closed, for how long at most, and with which force.
static void state_contact(const finder *of, size_t contact) {
    const whirl_table *table = of->table;
    size_t touching = 0, done = 0, first = 0, last = 0, hardest = 0;
    double share = 0.0, force = 0.0;
    // Count the motions that touch, and find the longest and the hardest contact.
    for (size_t i = 0; i < table->count; i++) {
        const double own = whirl_table_number(table, i, WHIRL_FIELD_RUB_SHARE, contact);
        const double strength = whirl_table_number(table, i, WHIRL_FIELD_RUB_MAX_FORCE, contact);
        if (!whirl_table_done(table, i) || isnan(own)) continue; // unknown for a motion that diverges
        done++;
        if (!(own > 0.0)) continue;
        if (touching++ == 0) first = i;
        last = i;
        share = fmax(share, own);
        if (strength > force) force = strength, hardest = i;
    }
    // State how many touch, and where.
    if (done == 0) return;
    whirl_phrase *found = &find_statement(of, find_text(of->findings, "%s", of->result->contacts[contact]))->found;
    if (touching == 0) {
        phrase_text(of, found, "never touches");
        return;
    }
    phrase_text(of, found, "touches in %zu of %zu motions", touching, done);
    add_place(of, found, touching > 1 ? ", from " : ", at ", first);
    if (touching > 1) add_place(of, found, " to ", last);
    // State the longest contact and the largest force.
    phrase_text(of, found, ", at most ");
    phrase_number(of, found, WHIRL_QUANTITY_PERCENT, 3, 100.0 * share);
    phrase_text(of, found, " of the time and with ");
    phrase_number(of, found, WHIRL_QUANTITY_FORCE, 4, force * of->result->force_scale);
    add_place(of, found, " (at ", hardest);
    if (*table->parameter) phrase_text(of, found, ")");
}

void find_together(const finder *of) {
    if (!find_described_together(of->table) || of->table->row > 0) return;
    whirl_phrase *found = &find_statement(of, "motions")->found;
    const bool judged = whirl_layout_has_verdict(&of->table->layout);
    judged ? add_regimes(of, found) : add_count(of, found);
    add_unbalances(of, found);
    state_nearest(of);
    for (size_t c = 0; c < of->result->contact_count; c++)
        if (whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUB_SHARE)) state_contact(of, c);
    if (judged && !of->table->attractors)
        phrase_text(of, &find_statement(of, "other motions")->found, "not searched for (starts)");
}
