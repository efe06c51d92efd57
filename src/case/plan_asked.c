// Numbers of every point that a part of the study asks for.
#include "plan_asked.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plan_names.h"
#include "problem.h"
#include "schema.h"
#include "tree.h"

/// Reads a limit, whose unit is checked when the field is known.
static double asked_limit(case_reader *reader, const setting_list *keys, const char *name, double none,
                          const char **unit) {
    const setting *given = settings_find(keys, name);
    char why[WHY_SIZE], shown[SHOWN_SIZE];
    quantity read;
    if (!given) return none;
    if (given->place->kind != NODE_TEXT)
        problem_at(reader->problems, given->place, "is %s, expected a number", node_shown(given->place, shown));
    else if (!quantity_read(given->place->text, "", &read, why))
        problem_at(reader->problems, given->place, "%s", why);
    else {
        *unit = arena_text(reader->arena, read.unit, strlen(read.unit));
        reader->no_memory = reader->no_memory || !*unit;
        return read.value;
    }
    return none;
}

static void asked_name(case_reader *reader, const setting_list *keys, const char *name, char text[WHIRL_NAME_SIZE]) {
    const setting *given = settings_find(keys, name);
    char shown[SHOWN_SIZE];
    if (!given) return;
    if (given->place->kind != NODE_TEXT || strlen(given->place->text) >= WHIRL_NAME_SIZE)
        problem_at(reader->problems, given->place, "is %s, expected a name", node_shown(given->place, shown));
    else
        snprintf(text, WHIRL_NAME_SIZE, "%s", given->place->text);
}

static void asked_read_one(case_reader *reader, const file_node *where, const whirl_group *group, asked_parts *parts) {
    setting_list keys = {.name = group->name, .group = group, .place = where};
    settings_read(reader, where, group, &keys);
    if (parts->count == PLAN_MAX_SPREADS) {
        problem_at(reader->problems, where, "asks for one more number than the %d that are possible", PLAN_MAX_SPREADS);
        return;
    }
    const size_t index = parts->count++;
    whirl_spread_of *of = &parts->spreads[index];
    const setting *row = settings_find(&keys, "row");
    *of = (whirl_spread_of){.row = row && row->good && row->value.number >= 1.0 ? (size_t)row->value.number - 1 : 0};
    parts->places[index] = where;
    parts->units[index] = "1";
    asked_name(reader, &keys, "field", of->field);
    asked_name(reader, &keys, "column", of->column);
    asked_name(reader, &keys, "at", of->at);
    of->above = asked_limit(reader, &keys, "above", -INFINITY, &parts->units[index]);
    of->below = asked_limit(reader, &keys, "below", INFINITY, &parts->units[index]);
    if (!(of->above < of->below))
        problem_at(reader->problems, settings_find(&keys, "below")->place,
                   "is not above the limit `above`, expected a larger number");
}

void asked_read(case_reader *reader, const setting *of, const whirl_group *group, asked_parts *out) {
    char shown[SHOWN_SIZE];
    if (of && (of->place->kind != NODE_LIST || of->place->count == 0))
        problem_at(reader->problems, of->place,
                   "is %s, expected a list of numbers: [{field: orbit/max_radius, at: disc}]",
                   of->place->kind == NODE_LIST ? "an empty list" : node_shown(of->place, shown));
    else
        for (const file_node *one = of ? of->place->first : NULL; one; one = one->next)
            asked_read_one(reader, one, group, out);
}

/// Returns true for the unit of numbers of which records at neighbouring values are compared.
static bool asked_has_records(const char *unit) {
    return strcmp(unit, "length") == 0 || strcmp(unit, "1") == 0;
}

void asked_check(case_reader *reader, asked_parts *asked, const whirl_batch *batch, const whirl_layout *layout,
                 const machine_parts *machine, const whirl_rotor *rotor, bool derived) {
    const whirl_system *system = whirl_rotor_system(rotor);
    char why[WHY_SIZE];
    for (size_t i = 0; i < asked->count; i++) {
        const whirl_spread_of *of = &asked->spreads[i];
        whirl_spread_at at;
        const char *lacks = whirl_spread_find(of, layout, machine->stations.names, machine->stations.count,
                                              whirl_rotor_contact_names(rotor), system->contact_count, &at);
        if (asked->found[i] || !whirl_layout_field(layout, of->field)) continue;
        asked->found[i] = true;
        const bool other =
            !lacks && derived && whirl_analysis_kind(batch->analyses)->moves && !whirl_motion_is_derived(of->field);
        const bool differs = batch->derivatives && batch->derivatives->difference > 0.0;
        if (other && !differs)
            lacks = "asks for a field of motions without derivatives, expected orbit/max_radius, orbit/min_radius, "
                    "orbit/mean, orbit/axial, orbit/twist, spectrum/synchronous, spectrum/synchronous_lag, "
                    "spectrum/axial_synchronous, spectrum/axial_lag, spectrum/twist_synchronous, "
                    "spectrum/twist_lag or floquet/modulus";
        if (other && differs && !asked_has_records(whirl_column_unit(at.field, at.index % at.field->columns)))
            lacks = "asks for a number of motions that has no derivative, expected a length or a number without a unit";
        if (!lacks && derived && whirl_analysis_kind(batch->analyses)->found &&
            strcmp(of->field, WHIRL_FIELD_TRACE_SPECIAL) != 0)
            lacks = "asks for a field of branches without derivatives, expected trace/special";
        const char *unit = lacks ? "1" : whirl_column_unit(at.field, at.index % at.field->columns);
        const char *si = strcmp(unit, "length") == 0 ? "m" : strcmp(unit, "force") == 0 ? "N" : unit;
        const bool plain = strcmp(asked->units[i], "1") == 0;
        if (lacks)
            problem_at(reader->problems, asked->places[i], "%s", lacks);
        else if (!plain && (strcmp(si, "1") == 0 || !quantity_fits(asked->units[i], si, why)))
            problem_at(reader->problems, asked->places[i], "has a limit in %.40s, expected the unit of %s: %s",
                       asked->units[i], of->field, si);
    }
}

void asked_report_unfound(case_reader *reader, const asked_parts *asked) {
    char shown[SHOWN_SIZE];
    for (size_t i = 0; i < asked->count; i++)
        if (!asked->found[i])
            problem_at(reader->problems, asked->places[i], "asks for %s, which is no field of the points of this study",
                       text_shown(asked->spreads[i].field, shown));
}
