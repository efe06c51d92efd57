// Results through accessors: see whirl/handles.h.
#include "whirl/handles.h"

#include "attractors.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------- results

const char *whirl_result_title(const whirl_result *result) {
    return result->title;
}

const char *whirl_result_case_name(const whirl_result *result) {
    return result->case_name;
}

const char *whirl_result_case_text(const whirl_result *result) {
    return result->case_text ? result->case_text : "";
}

double whirl_result_speed(const whirl_result *result) {
    return result->speed;
}

double whirl_result_force_scale(const whirl_result *result) {
    return result->force_scale;
}

bool whirl_result_is_partial(const whirl_result *result) {
    size_t done, total;
    return whirl_result_partial(result, &done, &total);
}

size_t whirl_result_count(const whirl_result *result, whirl_list list) {
    switch (list) {
    case WHIRL_LIST_PARAMETERS:
        return result->parameter_count;
    case WHIRL_LIST_STATIONS:
        return result->station_count;
    case WHIRL_LIST_CONTACTS:
        return result->contact_count;
    case WHIRL_LIST_FACTS:
        return result->fact_count;
    case WHIRL_LIST_TABLES:
        return result->table_count;
    }
    return 0;
}

const char *whirl_result_name(const whirl_result *result, whirl_list list, size_t index) {
    if (index >= whirl_result_count(result, list)) return NULL;
    switch (list) {
    case WHIRL_LIST_PARAMETERS:
        return result->parameters[index].name;
    case WHIRL_LIST_STATIONS:
        return result->stations[index].name;
    case WHIRL_LIST_CONTACTS:
        return result->contacts[index];
    case WHIRL_LIST_FACTS:
        return result->facts[index].name;
    case WHIRL_LIST_TABLES:
        return result->tables[index].name;
    }
    return NULL;
}

const char *whirl_result_text(const whirl_result *result, whirl_list list, size_t index, const char *what) {
    if (index >= whirl_result_count(result, list)) return NULL;
    if (list == WHIRL_LIST_FACTS && strcmp(what, "value") == 0) return result->facts[index].value;
    if (list != WHIRL_LIST_PARAMETERS) return NULL;
    if (strcmp(what, "unit") == 0) return result->parameters[index].unit;
    return strcmp(what, "text") == 0 ? result->parameters[index].text : NULL;
}

double whirl_result_number(const whirl_result *result, whirl_list list, size_t index, const char *what) {
    if (index >= whirl_result_count(result, list)) return NAN;
    if (list == WHIRL_LIST_PARAMETERS && strcmp(what, "value") == 0) return result->parameters[index].value;
    const whirl_member *member = list == WHIRL_LIST_STATIONS ? whirl_member_find(whirl_probe_members(), what) : NULL;
    return member && member->type != WHIRL_MEMBER_WORD ? whirl_member_number(member, &result->stations[index])
                                                       : (double)NAN;
}

whirl_status whirl_result_show_in(whirl_result *result, const char *units) {
    whirl_shown_units shown;
    const whirl_status status = whirl_result_shown_units(result, units, &shown);
    return status.code == WHIRL_OK ? whirl_result_add_fact(result, "units", units ? units : "") : status;
}

static whirl_shown_units handles_shown(const whirl_result *result) {
    whirl_shown_units units = {0};
    whirl_result_shown_units(result, NULL, &units); // no units were requested, so this cannot fail
    return units;
}

double whirl_result_shown_unit(const whirl_result *result, const char *parameter, char *name, size_t size) {
    const whirl_shown_units units = handles_shown(result);
    const whirl_unit unit = whirl_shown_parameter(&units, parameter);
    snprintf(name, size, "%s", unit.name);
    return unit.size;
}

double whirl_result_shown_length(const whirl_result *result, char *name, size_t size, bool *over) {
    const whirl_shown_units units = handles_shown(result);
    snprintf(name, size, "%s", units.length_name);
    *over = units.ratio;
    return units.length;
}

double whirl_result_shown_amplitude(const whirl_result *result, char *name, size_t size) {
    const whirl_shown_units units = handles_shown(result);
    snprintf(name, size, "%s", units.amplitude_name);
    return units.amplitude;
}

double whirl_result_shown_frequency(const whirl_result *result, char *name, size_t size) {
    const whirl_shown_units units = handles_shown(result);
    snprintf(name, size, "%s", units.frequency_name);
    return units.frequency;
}

// ---------------------------------------------------------------- tables

const char *whirl_table_name(const whirl_table *table) {
    return table->name;
}

const char *whirl_table_parameter(const whirl_table *table) {
    return table->parameter;
}

const char *whirl_table_varied(const whirl_table *table) {
    return table->second;
}

const char *whirl_table_stacked(const whirl_table *table) {
    return table->third;
}

const char *whirl_table_role(const whirl_table *table) {
    return whirl_role_name(table->role);
}

size_t whirl_table_points(const whirl_table *table) {
    return table->count;
}

size_t whirl_table_row(const whirl_table *table) {
    const bool plain = table->row > 0 && table->refine == 0 && table->starts <= 1;
    return plain && table->count == whirl_table_planned(table) && table->count % table->row == 0 ? table->row : 0;
}

const double *whirl_table_values(const whirl_table *table) {
    return table->values;
}

const int *whirl_table_branch(const whirl_table *table) {
    return table->branch;
}

// ---------------------------------------------------------------- fields

static const whirl_field *field_at(const whirl_table *table, size_t field) {
    return field < table->layout.field_count ? &table->layout.fields[field] : NULL;
}

size_t whirl_table_field_count(const whirl_table *table) {
    return table->layout.field_count;
}

size_t whirl_table_field_index(const whirl_table *table, const char *name) {
    size_t field = 0;
    while (field < table->layout.field_count && strcmp(table->layout.fields[field].name, name) != 0) field++;
    return field;
}

const char *whirl_table_field_name(const whirl_table *table, size_t field) {
    const whirl_field *found = field_at(table, field);
    return found ? found->name : NULL;
}

const char *whirl_table_field_unit(const whirl_table *table, size_t field) {
    const whirl_field *found = field_at(table, field);
    return found ? found->unit : NULL;
}

const char *whirl_table_field_meaning(const whirl_table *table, size_t field) {
    const whirl_field *found = field_at(table, field);
    return found ? found->meaning : NULL;
}

const char *whirl_table_field_extent(const whirl_table *table, size_t field) {
    static const char *const extents[] = {
        [WHIRL_PER_POINT] = "point", [WHIRL_PER_STATION] = "station", [WHIRL_PER_CONTACT] = "contact"};
    const whirl_field *found = field_at(table, field);
    return found ? extents[found->extent] : NULL;
}

size_t whirl_table_field_singles(const whirl_table *table, size_t field) {
    const whirl_field *found = field_at(table, field);
    return found ? found->singles : 0;
}

bool whirl_field_has_rows(const char *name) {
    return whirl_analysis_has_rows(name);
}

double whirl_table_field_si(const whirl_result *result, const whirl_table *table, size_t field, char *name,
                            size_t size) {
    const whirl_field *found = field_at(table, field);
    const whirl_unit si = found ? whirl_field_si(result, table, found) : (whirl_unit){.size = NAN};
    snprintf(name, size, "%s", si.name);
    return si.size;
}

const double *whirl_table_column(const whirl_table *table, size_t field, size_t shape[3], size_t *stride) {
    const whirl_field *found = field_at(table, field);
    if (!found) return NULL;
    shape[0] = found->repeat;
    shape[1] = found->rows;
    shape[2] = found->columns;
    *stride = table->layout.size;
    return table->blocks && !table->source ? table->blocks + found->offset : NULL;
}

whirl_status whirl_table_copy(const whirl_table *table, size_t field, double *numbers) {
    const whirl_field *found = field_at(table, field);
    if (!found) return whirl_fail(WHIRL_BAD_INPUT, "the table '%s' has no field number %zu", table->name, field);
    const size_t size = found->repeat * found->rows * found->columns;
    for (size_t point = 0; point < table->count; point++) {
        const double *block = whirl_table_block(table, point);
        if (!block) return whirl_fail(WHIRL_IO_ERROR, "point %zu of the table '%s' is lost", point + 1, table->name);
        memcpy(numbers + point * size, block + found->offset, size * sizeof *numbers);
    }
    return whirl_ok();
}

void whirl_table_words(const whirl_table *table, size_t point, char *name, char *reason, size_t size) {
    if (size > 0) name[0] = reason[0] = '\0';
    if (!whirl_layout_has_verdict(&table->layout) || !whirl_table_done(table, point)) return;
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    whirl_verdict_name(&verdict, name, size);
    whirl_verdict_reason(&verdict, reason, size);
}

/// Numbers the attractors of a basin, in which all starts belong to one place.
static whirl_status number_basin(const whirl_table *table, size_t *numbers, double *shares, double *errors) {
    size_t *labels = numbers ? numbers : malloc((table->count + 1) * sizeof *labels), count;
    whirl_attractor found[MAX_ATTRACTORS];
    whirl_status status = labels ? whirl_table_attractors(table, labels, found, MAX_ATTRACTORS, &count)
                                 : whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", table->count);
    for (size_t i = 0; i < table->count && status.code == WHIRL_OK; i++) {
        const whirl_attractor *one = labels[i] > 0 ? &found[labels[i] - 1] : NULL;
        if (shares) shares[i] = one ? one->share : (double)NAN;
        if (errors) errors[i] = one ? one->error : (double)NAN;
    }
    if (!numbers) free(labels);
    return status;
}

/// Numbers the attractors of a table with several starts a place.
static whirl_status number_places(const whirl_table *table, size_t *numbers, double *shares, double *errors) {
    whirl_coexistence found;
    const whirl_status status = whirl_table_coexistence(table, &found);
    if (status.code != WHIRL_OK) return status;
    for (size_t i = 0; i < table->count; i++) {
        const whirl_coexisting *one = whirl_coexistence_at(&found, table, i);
        if (numbers) numbers[i] = found.labels[i];
        if (shares) shares[i] = one ? one->share : (double)NAN;
        if (errors) errors[i] = one ? one->error : (double)NAN;
    }
    whirl_coexistence_free(&found);
    return status;
}

whirl_status whirl_table_attractor_numbers(const whirl_table *table, size_t *numbers, double *shares, double *errors) {
    if (table->starts > 1) return number_places(table, numbers, shares, errors);
    if (table->role == WHIRL_ROLE_BASIN) return number_basin(table, numbers, shares, errors);
    for (size_t i = 0; i < table->count; i++) {
        if (numbers) numbers[i] = 0;
        if (shares) shares[i] = (double)NAN;
        if (errors) errors[i] = (double)NAN;
    }
    return whirl_ok();
}

const whirl_member *whirl_table_options(const whirl_table *table, size_t group, size_t *offset) {
    // List the options of a table, by groups of members.
    const struct {
        const whirl_member *members;
        size_t offset;
    } groups[] = {{whirl_integrate_members(), offsetof(whirl_table, integrate)},
                  {whirl_record_members(), offsetof(whirl_table, record)},
                  {whirl_trace_members(), offsetof(whirl_table, record.trace)},
                  {whirl_runup_members(), offsetof(whirl_table, record.runup)},
                  {whirl_fit_members(), offsetof(whirl_table, record.fit)},
                  {whirl_dataset_members(), offsetof(whirl_table, record.dataset)},
                  {whirl_tolerance_members(), offsetof(whirl_table, tolerances)}};
    // Find the nth group that tables of this kind have.
    const bool has[] = {true,
                        true,
                        whirl_analysis_kind(table->analyses)->found,
                        whirl_analysis_has(table->analyses, "runup"),
                        whirl_analysis_has(table->analyses, "fit"),
                        table->role == WHIRL_ROLE_RECORDS,
                        table->role == WHIRL_ROLE_TOLERANCES};
    for (size_t i = 0; i < sizeof groups / sizeof *groups; i++) {
        if (!has[i] || group-- > 0) continue;
        *offset = groups[i].offset;
        return groups[i].members;
    }
    return NULL;
}

/// Finds occurrence `*index` of a member with a name; *index is reduced by the occurrences that were passed.
static const whirl_member *named_member(const whirl_member *member, size_t *index) {
    for (; member->part; member++)
        if (member->name && (*index)-- == 0) return member;
    return NULL;
}

const char *whirl_table_option(const whirl_table *table, size_t index, char *text, size_t size) {
    char value[WHIRL_NAME_SIZE];
    const whirl_member *members, *member = NULL;
    size_t offset = 0;
    for (size_t group = 0; !member && (members = whirl_table_options(table, group, &offset)) != NULL; group++)
        member = named_member(members, &index);
    if (!member) return NULL;
    whirl_member_text(member, (const char *)table + offset, value);
    snprintf(text, size, "%s", value);
    return member->name;
}
