// Results in memory, which all layers above read.
#include "whirl/engine/result.h"

#include "journal_blocks.h"
#include "mapped.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void whirl_result_free(whirl_result *result) {
    if (!result) return;
    for (size_t i = 0; i < result->table_count; ++i) {
        whirl_table *table = &result->tables[i];
        void *const arrays[] = {table->slots,  table->values, table->length_scales,
                                table->branch, table->blocks, table->done};
        for (size_t k = 0; k < sizeof arrays / sizeof *arrays; ++k) mapped_drop(&table->mapped, arrays[k]);
        journal_blocks_free(table->journal_blocks);
    }
    free(result->tables);
    free(result->case_text);
    free(result->parameters);
    free(result->stations);
    free(result->contacts);
    free(result->facts);
    free(result);
}

const whirl_table *whirl_result_table(const whirl_result *result, const char *name) {
    for (size_t i = 0; i < result->table_count; ++i)
        if (strcmp(result->tables[i].name, name) == 0) return &result->tables[i];
    return NULL;
}

const whirl_table *whirl_result_role(const whirl_result *result, whirl_role role) {
    for (size_t i = 0; i < result->table_count; ++i)
        if (result->tables[i].role == role) return &result->tables[i];
    return NULL;
}

const double *whirl_table_block(const whirl_table *table, size_t point) {
    if (point >= table->count) return NULL;
    if (table->source) return whirl_table_block(table->source, table->chosen[point]);
    mapped_evict_often(table->mapped, point);
    if (table->journal_blocks) return journal_blocks_of(table, point);
    return table->blocks ? table->blocks + point * table->layout.size : NULL;
}

const double *whirl_table_field(const whirl_table *table, size_t point, const char *field, size_t which) {
    const whirl_field *found = whirl_layout_field(&table->layout, field);
    const double *block = found && which < found->repeat ? whirl_table_block(table, point) : NULL;
    return block ? block + found->offset + which * found->rows * found->columns : NULL;
}

double whirl_result_clock(const whirl_result *result) {
    const double rate = strtod(whirl_result_fact(result, "keyphasor rate"), NULL);
    return rate > 0.0 && isfinite(rate) ? rate : result->speed;
}

const char *whirl_result_keyphasor(const whirl_result *result) {
    return whirl_result_fact(result, "keyphasor");
}

const char *whirl_result_film_tables(const whirl_result *result) {
    return whirl_result_fact(result, "film tables");
}

double whirl_result_length_scale(const whirl_result *result, const whirl_table *table, size_t point) {
    return table && table->length_scales && point < table->count ? table->length_scales[point] : result->length_scale;
}

double whirl_table_clock(const whirl_result *result, const whirl_table *table, size_t point) {
    if (point >= table->count) return (double)NAN;
    switch (table->clock_of) {
    case 0:
        return whirl_result_clock(result);
    case 1:
        return table->clock_factor * table->values[point];
    case 2:
        return table->clock_factor * whirl_table_second(table, point);
    case 3:
        return table->clock_factor * whirl_table_third(table, point);
    default:
        return (double)NAN;
    }
}

size_t whirl_table_slot(const whirl_table *table, size_t point) {
    return table->slots && point < table->count ? table->slots[point] : point;
}

size_t whirl_table_places(const whirl_table *table) {
    const size_t planned = whirl_table_planned(table);
    if (table->source) return whirl_table_places(table->source);
    if (table->grid > 0) return table->grid;
    if (table->places > 0) return table->places;
    const size_t machines = whirl_tolerance_machines(&table->tolerances);
    if (machines > 0) return planned / machines;
    return table->starts > 1 ? planned / table->starts : planned;
}

size_t whirl_table_place(const whirl_table *table, size_t point) {
    const size_t places = whirl_table_places(table);
    return places > 0 ? whirl_table_slot(table, point) % places : 0;
}

bool whirl_table_from_neighbour(const whirl_table *table, size_t point) {
    return table->places > 0 && whirl_table_slot(table, point) >= table->places * table->starts;
}

double whirl_table_number(const whirl_table *table, size_t point, const char *field, size_t which) {
    const double *numbers = whirl_table_field(table, point, field, which);
    return numbers ? *numbers : (double)NAN;
}

double whirl_table_second(const whirl_table *table, size_t point) {
    const bool map = whirl_layout_field(&table->layout, WHIRL_FIELD_MAP_SECOND) != NULL;
    return whirl_table_number(table, point, map ? WHIRL_FIELD_MAP_SECOND : WHIRL_FIELD_TRACE_SECOND, 0);
}

double whirl_table_third(const whirl_table *table, size_t point) {
    return whirl_table_number(table, point, WHIRL_FIELD_MAP_THIRD, 0);
}

size_t whirl_table_planned(const whirl_table *table) {
    if (table->source) return table->planned;
    return table->planned > table->count ? table->planned : table->count;
}

size_t whirl_table_grid(const whirl_table *table) {
    return table->grid > 0 ? table->grid : whirl_table_planned(table);
}

size_t whirl_table_rows(const whirl_table *table) {
    if (table->row == 0) return 0;
    return (table->plane > 0 ? table->plane : whirl_table_places(table)) / table->row;
}

size_t whirl_table_planes(const whirl_table *table) {
    if (table->row == 0) return 0;
    return table->plane > 0 ? whirl_table_places(table) / table->plane : 1;
}

bool whirl_table_done(const whirl_table *table, size_t point) {
    return point < table->count && (!table->done || table->done[point]);
}

bool whirl_result_partial(const whirl_result *result, size_t *done, size_t *total) {
    *done = *total = 0;
    for (size_t i = 0; i < result->table_count; ++i) {
        const whirl_table *table = result->tables[i].source ? result->tables[i].source : &result->tables[i];
        *total += whirl_table_planned(table);
        for (size_t point = 0; point < table->count; ++point) {
            mapped_evict_often(table->mapped, point);
            *done += whirl_table_done(table, point);
        }
    }
    return result->partial || *done < *total;
}

whirl_verdict whirl_table_verdict(const whirl_table *table, size_t point) {
    const whirl_layout nothing = {0};
    const double *block = whirl_table_block(table, point);
    return block ? whirl_block_verdict(&table->layout, block) : whirl_block_verdict(&nothing, NULL);
}

whirl_status whirl_table_trace(const whirl_table *table, size_t point, whirl_trace *trace) {
    const double *block = whirl_table_block(table, point);
    *trace = (whirl_trace){.branch = 0};
    return block ? whirl_block_trace(&table->layout, block, table->values[point], &table->record, trace)
                 : whirl_fail(WHIRL_BAD_INPUT, "point %zu of the %s is not there", point + 1, table->name);
}

// Copies what fits and terminates it. Command lines and host names are arbitrary text.
static void copy_text(char *target, size_t size, const char *source) {
    const size_t length = strnlen(source, size - 1);
    memcpy(target, source, length);
    memset(target + length, 0, size - length);
    whirl_make_plain(target);
}

const char *whirl_result_fact(const whirl_result *result, const char *name) {
    for (size_t i = 0; i < result->fact_count; ++i)
        if (strncmp(result->facts[i].name, name, sizeof result->facts[i].name - 1) == 0) return result->facts[i].value;
    return "";
}

/// Returns the fact "warning 1", "warning 2", ...
static const char *result_numbered(const whirl_result *result, const char *word, size_t index) {
    char name[WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, "%s %zu", word, index + 1);
    return whirl_result_fact(result, name);
}

const char *whirl_result_warning(const whirl_result *result, size_t index) {
    return result_numbered(result, "warning", index);
}

const char *whirl_result_fit(const whirl_result *result, size_t index) {
    return result_numbered(result, "fit", index);
}

whirl_status whirl_result_add_fact(whirl_result *result, const char *name, const char *value) {
    for (size_t i = 0; i < result->fact_count; ++i)
        if (strncmp(result->facts[i].name, name, sizeof result->facts[i].name - 1) == 0) {
            copy_text(result->facts[i].value, sizeof result->facts[i].value, value);
            return whirl_ok();
        }
    whirl_fact *facts = realloc(result->facts, (result->fact_count + 1) * sizeof *facts);
    if (!facts) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the fact %s", name);
    whirl_fact *fact = &facts[result->fact_count];
    copy_text(fact->name, sizeof fact->name, name);
    copy_text(fact->value, sizeof fact->value, value);
    result->facts = facts;
    ++result->fact_count;
    return whirl_ok();
}
