#include "identity.h"
#include "crc32c.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "build.h"
#include "isa.h"
#include "mapped.h"
#include "number_text.h"
#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

enum { SHOWN = 90 };

// ---------------------------------------------------------------- writing

static const char *exact(double value, char text[NUMBER_SIZE]) {
    if (isfinite(value))
        number_text(value, text);
    else
        snprintf(text, NUMBER_SIZE, "%g", value);
    return text;
}

static void put_case(FILE *out, const char *text) {
    for (int line = 1; *text; ++line) {
        const size_t length = strcspn(text, "\n");
        fprintf(out, "line %d of the case\t%.*s\n", line, (int)length, text);
        text += length + (text[length] == '\n');
    }
}

static void put_parameters(FILE *out, const whirl_result *outline) {
    char number[NUMBER_SIZE];
    for (size_t i = 0; i < outline->parameter_count; ++i) {
        const whirl_parameter *one = &outline->parameters[i];
        fprintf(out, "parameter %s\t%s%s%s\n", one->name, exact(one->value, number),
                strcmp(one->unit, "1") == 0 ? "" : " ", strcmp(one->unit, "1") == 0 ? "" : one->unit);
    }
}

/// Writes the facts that change points: the budget of refinement, which decides which points are computed, and a user's
/// equations, which only facts describe.
static void put_facts(FILE *out, const whirl_result *outline) {
    for (size_t i = 0; i < outline->fact_count; ++i) {
        const whirl_fact *fact = &outline->facts[i];
        if (strcmp(fact->name, "refine") == 0)
            fprintf(out, "budget of refinement\t%s\n", fact->value);
        else if (strncmp(fact->name, "equations", strlen("equations")) == 0)
            fprintf(out, "%s\t%s\n", fact->name, fact->value);
    }
}

/// Returns true for points that are known before the run. Not known are those that follow from results: points of a
/// refined map other than the corners of its first squares, starts from neighbours, and points of branches, curves and
/// tori.
static bool is_planned(const whirl_table *table, size_t point) {
    if (whirl_analysis_kind(table->analyses)->found || whirl_table_from_neighbour(table, point)) return false;
    if (table->refine == 0) return true;
    const size_t slot = whirl_table_slot(table, point), x = slot % table->row, y = slot / table->row;
    return (x % table->refine == 0 || x + 1 == table->row) &&
           (y % table->refine == 0 || y + 1 == whirl_table_rows(table));
}

/// Writes what differs between the records of a data set, and its channels.
static void put_dataset(FILE *out, const whirl_result *outline) {
    fputs(", of", out);
    for (size_t i = 0; i < outline->fact_count; ++i)
        if (strncmp(outline->facts[i].name, "dataset ", 8) == 0)
            fprintf(out, " (%s: %s)", outline->facts[i].name, outline->facts[i].value);
}

/// Writes the parameters by which numbers are differentiated, and the numbers.
static void put_derivatives(FILE *out, const whirl_result *outline) {
    fputs(", with derivatives", out);
    for (size_t i = 0; i < outline->fact_count; ++i)
        if (strncmp(outline->facts[i].name, "sensitivity ", 12) == 0 ||
            strncmp(outline->facts[i].name, "derived ", 8) == 0)
            fprintf(out, " (%s: %s)", outline->facts[i].name, outline->facts[i].value);
}

/// Writes a line about the points of a table: their number, range and checksum, and how they are arranged.
static void put_points(FILE *out, const whirl_result *outline, const whirl_table *table) {
    char first[NUMBER_SIZE], last[NUMBER_SIZE];
    uint32_t sum = 0;
    size_t count = 0, end = 0;
    // Checksum of the values of all planned points.
    for (size_t i = 0; i < table->count; ++i) {
        mapped_evict_often(table->mapped, i);
        if (!is_planned(table, i)) continue;
        ++count;
        end = i;
        char both[NUMBER_SIZE + 8];
        const int length = snprintf(both, sizeof both, "%a %d;", table->values[i], table->branch[i]);
        sum = crc32c(sum, both, (size_t)length);
    }
    // Number and range.
    fprintf(out, "points of the %s\t", table->name);
    if (whirl_analysis_kind(table->analyses)->found)
        fprintf(out, "those that are found along %s", table->parameter);
    else
        fprintf(out, "%zu", table->refine > 0 ? table->grid : count);
    if (table->parameter[0] && count > 0)
        fprintf(out, ", %s from %s to %s (%08x)", table->parameter, exact(table->values[0], first),
                exact(table->values[end], last), (unsigned)sum);
    // Arrangement: rows and planes of maps, samples, records, starts, squares.
    if (table->row > 0) fprintf(out, ", in rows of %zu, each with a %s of its own", table->row, table->second);
    if (table->plane > 0) fprintf(out, ", in planes of %zu, each with a %s of its own", table->plane, table->third);
    if (table->tolerances.samples > 0) fputs(", of samples of", out);
    for (int i = 0; i < table->tolerances.parameters; ++i) {
        char fact[WHIRL_NAME_SIZE];
        snprintf(fact, sizeof fact, "tolerance %d", i + 1);
        fprintf(out, " (%s)", whirl_result_fact(outline, fact));
    }
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_SENSITIVITY_SLOPES)) put_derivatives(out, outline);
    if (table->role == WHIRL_ROLE_RECORDS) put_dataset(out, outline);
    if (table->starts > 1) fprintf(out, ", from %zu starts each", table->starts);
    if (table->neighbours > 0) fprintf(out, ", and from neighbours in up to %zu rounds", table->neighbours);
    if (table->refine > 0) fprintf(out, ", refined from squares of %zu", table->refine);
    fputc('\n', out);
}

static void put_options(FILE *out, const char *table, const whirl_member *member, const void *options) {
    char text[WHIRL_NAME_SIZE];
    for (; member->part; ++member) {
        if (!member->name) continue;
        whirl_member_text(member, options, text);
        fprintf(out, "%s of the %s\t%s\n", member->name, table, text);
    }
}

static void put_fields(FILE *out, const whirl_table *table) {
    for (size_t i = 0; i < table->layout.field_count; ++i) {
        const whirl_field *field = &table->layout.fields[i];
        if (field->singles > 0)
            continue; // signals, which a result in memory does not have; their size follows from the options
        fprintf(out, "numbers of %s in the %s\t%zu x %zu x %zu\n", field->name, table->name, field->repeat, field->rows,
                field->columns);
    }
}

/// Returns a checksum of values of the C library's mathematical functions: other versions differ in last bits.
static uint32_t functions_sum(void) {
    uint32_t sum = 0;
    for (int i = 1; i <= 64; ++i) {
        const double x = i * 0.097, values[] = {sin(x), cos(x), tan(x), atan2(x, 1.3), exp(x), log(x), pow(x, 0.7)};
        sum = crc32c(sum, values, sizeof values);
    }
    return sum;
}

/// Writes the build. Its arithmetic is fused or not: points have the same bits on all processors with fused
/// multiply-adds, and on all without. Its sources count, not its revision: a changed document does not change the
/// program, an uncommitted change of sources does. Film tables come last, so that a difference of sources is reported
/// first.
static whirl_status put_build(FILE *out, const whirl_result *outline) {
    static const char *const wanted[] = {"version", "sources", "compiler", "flags", "libraries"};
    const isa *chosen;
    const whirl_status status = isa_choose(&chosen);
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; ++i)
        for (const build_fact *fact = build_facts(); fact->name; ++fact)
            if (strcmp(fact->name, wanted[i]) == 0) fprintf(out, "%s of whirl\t%s\n", fact->name, fact->value);
    if (status.code == WHIRL_OK)
        fprintf(out, "arithmetic\t%s\n", chosen->fused ? "fused multiply-add" : "without fused multiply-add");
    fprintf(out, "mathematical functions\t%08x\n", (unsigned)functions_sum());
    if (*whirl_result_film_tables(outline)) fprintf(out, "film tables\t%s\n", whirl_result_film_tables(outline));
    return status;
}

whirl_status identity_text(const whirl_result *outline, bool build, char **text, size_t *size) {
    whirl_status status = whirl_ok();
    *text = NULL;
    FILE *out = open_memstream(text, size);
    if (!out) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the text of a case");
    // The case: text, parameters, facts, stations.
    put_case(out, outline->case_text ? outline->case_text : "");
    put_parameters(out, outline);
    put_facts(out, outline);
    for (size_t i = 0; i < outline->station_count; ++i)
        fprintf(out, "station %zu\t%s\n", i + 1, outline->stations[i].name);
    // The tables: points, options, analyses and fields.
    for (size_t i = 0; i < outline->table_count; ++i) {
        const whirl_table *table = &outline->tables[i];
        put_points(out, outline, table);
        const whirl_member *members;
        for (size_t group = 0, at; (members = whirl_table_options(table, group, &at)) != NULL; group++)
            put_options(out, table->name, members, (const char *)table + at);
        fprintf(out, "analyses of the %s\t%x\n", table->name, table->analyses);
        put_fields(out, table);
    }
    // The build; then hand over the text, or free it after a failure.
    if (build) status = put_build(out, outline);
    const bool well = !ferror(out);
    if (fclose(out) != 0 || !well) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the text of a case");
    if (status.code == WHIRL_OK) return status;
    free(*text);
    *text = NULL;
    return status;
}

// ---------------------------------------------------------------- comparing

/// A line: its label, and its value without the end of the line.
typedef struct entry {
    const char *label, *value;
    int label_length, value_length;
} entry;

static entry entry_at(const char *line) {
    const int length = (int)strcspn(line, "\n"), label = (int)strcspn(line, "\t\n");
    const int value = label < length ? label + 1 : length;
    return (entry){line, line + value, label, length - value};
}

static bool same_label(entry a, entry b) {
    return a.label_length == b.label_length && memcmp(a.label, b.label, (size_t)a.label_length) == 0;
}

/// Returns true if a text has a line with that label.
static bool has_label(const char *text, entry wanted) {
    while (*text) {
        const entry here = entry_at(text);
        if (same_label(here, wanted)) return true;
        text = here.value + here.value_length;
        text += *text == '\n';
    }
    return false;
}

/// Returns the length of a value to show in a sentence: at most SHOWN bytes, no letter of UTF-8 cut.
static int shown(entry one) {
    int length = one.value_length < SHOWN ? one.value_length : SHOWN;
    while (length > 0 && length < one.value_length && ((unsigned char)one.value[length] & 0xc0u) == 0x80u) --length;
    return length;
}

bool identity_difference(const char *earlier, const char *later, char *difference, size_t size) {
    const char *a = earlier, *b = later;
    // Go to the beginning of the first line that differs.
    for (size_t i = 0; earlier[i] && earlier[i] == later[i]; ++i)
        if (earlier[i] == '\n') a = earlier + i + 1, b = later + i + 1;
    if (strcmp(a, b) == 0) return false;
    const entry was = entry_at(a), is = entry_at(b);
    if (same_label(was, is))
        snprintf(difference, size, "%.*s was '%.*s' and is '%.*s'", was.label_length, was.label, shown(was), was.value,
                 shown(is), is.value);
    else if (*a && !has_label(later, was))
        snprintf(difference, size, "%.*s was '%.*s' and is no longer there", was.label_length, was.label, shown(was),
                 was.value);
    else
        snprintf(difference, size, "%.*s is new: '%.*s'", is.label_length, is.label, shown(is), is.value);
    return true;
}
