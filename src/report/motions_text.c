#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "machine_at.h"
#include "motions_text.h"
#include "quantities.h"
#include "regimes.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/findings.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"
#include "whirl/engine/system.h"

bool motions_beside(const whirl_table *table) {
    return table->role == WHIRL_ROLE_MOTIONS;
}

/// A paragraph that is being written, and what it describes.
typedef struct paragraph {
    const whirl_case *machine;
    const whirl_shown_units *units;
    const whirl_result *view;
    const whirl_table *table;
    whirl_unit unit; ///< unit of the parameter
    char *text;
} paragraph;

static void paragraph_add(const paragraph *p, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

static void paragraph_add(const paragraph *p, const char *format, ...) {
    const size_t used = strlen(p->text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(p->text + used, MOTIONS_TEXT_SIZE - used, format, arguments);
    va_end(arguments);
}

/// Adds `before` and the parameter's value at a point, "5700 rpm"; adds nothing without a parameter.
static void add_place(const paragraph *p, const char *before, size_t point) {
    if (!*p->table->parameter) return;
    paragraph_add(p, "%s%.6g%s%s", before, p->table->values[point] / p->unit.size, *p->unit.name ? " " : "",
                  p->unit.name);
}

// ---------------------------------------------------------------- kinds of motion

static void add_unbalances(const paragraph *p) {
    const whirl_record_options *record = &p->table->record;
    if (record->antinodes_of > 0)
        paragraph_add(p, "with unbalances by rule at the antinodes of forward mode %d", record->antinodes_of);
    else if (*record->placed_at)
        paragraph_add(p, "with an unbalance by rule at %s", record->placed_at);
    else
        paragraph_add(p, "with the machine's own unbalances");
    if (record->placed_factor != 1.0) paragraph_add(p, ", %.4g times as large", record->placed_factor);
}

/// Adds the number of motions without a verdict, and their length.
static void add_count(const paragraph *p) {
    size_t done = 0;
    for (size_t i = 0; i < p->table->count; i++) done += whirl_table_done(p->table, i);
    paragraph_add(p, "%zu motion%s, not judged (analyze: regime): %d revolutions%s", done, done == 1 ? "" : "s",
                  p->table->record.record, p->table->record.transient == 0 ? " from the start" : " after a transient");
    if (done < whirl_table_planned(p->table)) paragraph_add(p, " (of %zu points)", whirl_table_planned(p->table));
}

/// Adds the number of motions without a verdict that ended early.
static void add_lost(const paragraph *p) {
    size_t first;
    const size_t lost = motions_lost(p->table, &first);
    if (lost > 0)
        paragraph_add(p, "; %zu of them ended early (clearances and contacts are reported without %s)", lost,
                      lost == 1 ? "it" : "them");
}

/// Adds the number of starts without a verdict, and of points all of whose starts lack one: the table has no motion of
/// these.
static void add_untold(const paragraph *p) {
    const whirl_table *const source = p->table->source;
    size_t done = 0, untold = 0;
    double told_places = 0.0;
    for (size_t i = 0; i < source->count; i++) {
        if (!whirl_table_done(source, i)) continue;
        done++;
        untold += whirl_table_verdict(source, i).regime == WHIRL_UNDETERMINED;
    }
    if (done < whirl_table_planned(source))
        paragraph_add(p, " (%zu of %zu starts are computed)", done, whirl_table_planned(source));
    if (untold == 0) return;
    paragraph_add(p, ", %zu of %zu starts have no verdict", untold, done);
    for (size_t i = 0; i < p->table->count; i++) told_places += 1.0 / (double)p->table->attractors[i].beside;
    const double places = (double)whirl_table_places(p->table), without = places - round(told_places);
    if (done == whirl_table_planned(source) && without > 0.0)
        paragraph_add(p, " (at %.0f of %.0f points none of them has one)", without, places);
}

static void add_regimes(const paragraph *p) {
    size_t done = 0, periodic = 0, doubtful = 0, diverged = 0;
    for (size_t i = 0; i < p->table->count; i++) {
        if (!whirl_table_done(p->table, i)) continue;
        const whirl_verdict verdict = whirl_table_verdict(p->table, i);
        done++;
        periodic += verdict.regime == WHIRL_PERIODIC && verdict.period == 1;
        doubtful += verdict.regime == WHIRL_UNDETERMINED || verdict.confidence == WHIRL_LOW;
        diverged += verdict.regime == WHIRL_DIVERGING;
    }
    paragraph_add(p, "%zu of %zu motions come back every revolution", periodic, done);
    if (diverged > 0)
        paragraph_add(p,
                      ", %zu diverge (a station comes to the wall of a film or seal, or a coordinate beyond the limit: "
                      "clearances "
                      "and contacts are reported without them)",
                      diverged);
    if (doubtful > 0) paragraph_add(p, ", %zu are in doubt", doubtful);
    if (p->table->attractors)
        add_untold(p);
    else if (done < whirl_table_planned(p->table))
        paragraph_add(p, " (of %zu points)", whirl_table_planned(p->table));
}

// ---------------------------------------------------------------- clearances

/// Closest approach of motions to a wall.
typedef struct nearest {
    double share;
    size_t station, point;
    bool film; ///< the wall belongs to a bearing
} nearest;

static void look_at(const paragraph *p, size_t point, nearest *found) {
    whirl_machine own;
    const bool made = machine_at(p->machine, p->table, point, &own);
    const whirl_probe *probes = made ? own.system->probes : p->view->stations;
    for (size_t s = 0; s < p->view->station_count; s++) {
        const double radius = max_radius(p->table, point, s), walls[] = {probes[s].clearance, probes[s].gap};
        for (int k = 0; k < 2; k++)
            if (walls[k] > 0.0 && radius / walls[k] > found->share)
                *found = (nearest){.share = radius / walls[k], .station = s, .point = point, .film = k == 0};
    }
    if (made) own.release(own.owner);
}

static void add_clearance(const paragraph *p) {
    nearest found = {.share = -1.0};
    for (size_t i = 0; i < p->table->count; i++)
        if (whirl_table_done(p->table, i)) look_at(p, i, &found);
    if (found.share < 0.0) return;
    paragraph_add(p, "; they come nearest to the wall at %s, to %.3g %% of its radial %s",
                  p->view->stations[found.station].name, 100.0 * found.share, found.film ? "clearance" : "gap");
    add_place(p, ", at ", found.point);
}

/// Adds the place, duration and force of a contact.
static void add_contact(const paragraph *p, size_t contact) {
    size_t touching = 0, done = 0, first = 0, last = 0, hardest = 0;
    double share = 0.0, force = 0.0;
    // Count the motions that touch, and find the longest and the hardest contact.
    for (size_t i = 0; i < p->table->count; i++) {
        const double own = whirl_table_number(p->table, i, WHIRL_FIELD_RUB_SHARE, contact);
        const double strength = whirl_table_number(p->table, i, WHIRL_FIELD_RUB_MAX_FORCE, contact);
        if (!whirl_table_done(p->table, i) || isnan(own)) continue; // unknown for a motion that diverges
        done++;
        if (!(own > 0.0)) continue;
        if (touching++ == 0) first = i;
        last = i;
        share = fmax(share, own);
        if (strength > force) force = strength, hardest = i;
    }
    // State how many touch, and where.
    if (done == 0) return;
    paragraph_add(p, "; %s ", p->view->contacts[contact]);
    if (touching == 0) {
        paragraph_add(p, "never touches");
        return;
    }
    paragraph_add(p, "touches in %zu of %zu motions", touching, done);
    add_place(p, touching > 1 ? ", from " : ", at ", first);
    if (touching > 1) add_place(p, " to ", last);
    // State the longest contact and the largest force.
    const whirl_unit *const unit = &p->units->of[WHIRL_QUANTITY_FORCE];
    paragraph_add(p, ", at most %.3g %% of the time and with %.4g %s", 100.0 * share,
                  force * p->view->force_scale / unit->size, unit->name);
    add_place(p, " (at ", hardest);
    if (*p->table->parameter) paragraph_add(p, ")");
}

// ---------------------------------------------------------------- coexisting motions

static void add_beside(const paragraph *p) {
    // Without starts, other motions were not searched for.
    const whirl_table *table = p->table;
    double several = 0.0;
    size_t first = table->count;
    if (!table->attractors) {
        paragraph_add(p, ". Coexisting motions were not searched for (starts).");
        return;
    }
    // Count the places with several attractors, and find the first such place.
    for (size_t i = 0; i < table->count; i++) {
        if (table->attractors[i].beside < 2) continue;
        several += 1.0 / (double)table->attractors[i].beside;
        if (first == table->count || table->attractors[i].place < table->attractors[first].place) first = i;
    }
    // State the number of places, and name the attractors of the first.
    if (first == table->count) {
        paragraph_add(p, ". From %zu starts a place no other motion was found", table->source->starts);
    } else {
        paragraph_add(
            p, ". At %.0f of %zu places other motions stand side by side with them, found from %zu starts a place: ",
            several, whirl_table_places(table), table->source->starts);
        add_place(p, "first at ", first);
        const char *before = *table->parameter ? ", " : "";
        for (size_t i = 0; i < table->count; i++) {
            char name[128];
            if (table->attractors[i].place != table->attractors[first].place) continue;
            const whirl_verdict verdict = whirl_table_verdict(table, i);
            regime_name(&verdict, name, sizeof name);
            paragraph_add(p, "%s%s (%.3g %% of the starts)", before, name, 100.0 * table->attractors[i].share);
            before = " and ";
        }
    }
    // State what the search can miss.
    paragraph_add(p, "; one that fewer than %.2g %% of starts lead to may be missed.",
                  100.0 * whirl_missed_share(table->source->starts));
}

void motions_text(const whirl_shown_units *units, const whirl_result *view, const whirl_case *machine,
                  const whirl_table *table, char text[MOTIONS_TEXT_SIZE]) {
    const paragraph p = {machine, units, view, table, whirl_shown_parameter(units, table->parameter), text};
    *text = '\0';
    const bool judged = whirl_layout_has_verdict(&table->layout);
    judged ? add_regimes(&p) : add_count(&p);
    paragraph_add(&p, ", ");
    add_unbalances(&p);
    if (!judged) add_lost(&p);
    add_clearance(&p);
    for (size_t c = 0; c < view->contact_count; c++)
        if (whirl_layout_field(&table->layout, WHIRL_FIELD_RUB_SHARE)) add_contact(&p, c);
    if (judged)
        add_beside(&p);
    else
        paragraph_add(&p, ".");
}
