// Compares results: a file with the result from which it was written, and the studies of two results.
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "finished.h"
#include "format.h"
#include "identity.h"
#include "mapped.h"
#include "read.h"

bool whirl_result_same_study(const whirl_result *earlier, const whirl_result *later, char *difference, size_t size) {
    char *was = NULL, *is = NULL;
    size_t length;
    bool same = false;
    snprintf(difference, size, "there is no memory to compare them");
    if (identity_text(earlier, false, &was, &length).code == WHIRL_OK &&
        identity_text(later, false, &is, &length).code == WHIRL_OK)
        same = !identity_difference(was, is, difference, size);
    free(was);
    free(is);
    return same;
}

/// Returns true if two numbers have the same bits: a NaN equals itself, 0 differs from -0.
static bool same_number(double a, double b) {
    uint64_t bits[2];
    memcpy(&bits[0], &a, sizeof a);
    memcpy(&bits[1], &b, sizeof b);
    return bits[0] == bits[1];
}

/// Returns true if two texts are equal once control characters are replaced, as reading does.
static bool same_text(const char *a, const char *b) {
    char one[256], other[256];
    snprintf(one, sizeof one, "%s", a);
    snprintf(other, sizeof other, "%s", b);
    whirl_make_plain(one);
    whirl_make_plain(other);
    return strcmp(one, other) == 0;
}

static bool same_facts(const whirl_result *a, const whirl_result *b) {
    if (a->fact_count != b->fact_count) return false;
    for (size_t i = 0; i < a->fact_count; ++i)
        if (!same_text(a->facts[i].name, b->facts[i].name) || !same_text(a->facts[i].value, b->facts[i].value))
            return false;
    return true;
}

static bool same_stations(const whirl_result *a, const whirl_result *b) {
    for (const whirl_member *member = whirl_probe_members(); member->part; ++member)
        for (size_t i = 0; i < a->station_count; ++i)
            if (!same_number(whirl_member_number(member, &a->stations[i]),
                             whirl_member_number(member, &b->stations[i])))
                return false;
    return true;
}

static bool same_contacts(const whirl_result *a, const whirl_result *b) {
    if (a->contact_count != b->contact_count) return false;
    for (size_t i = 0; i < a->contact_count; ++i)
        if (!same_text(a->contacts[i], b->contacts[i])) return false;
    return true;
}

static bool same_parameters(const whirl_result *a, const whirl_result *b) {
    for (size_t i = 0; i < a->parameter_count; ++i)
        if (!same_number(a->parameters[i].value, b->parameters[i].value) ||
            !same_text(a->parameters[i].text, b->parameters[i].text))
            return false;
    return true;
}

/// Returns the first difference outside of tables, or NULL.
static const char *head_difference(const whirl_result *a, const whirl_result *b) {
    if (!same_text(a->title, b->title)) return "the title";
    if (!same_text(a->case_name, b->case_name)) return "the name of the case";
    if (!same_number(a->speed, b->speed) || !same_number(a->length_scale, b->length_scale) ||
        !same_number(a->force_scale, b->force_scale))
        return "the scales";
    if (!same_parameters(a, b)) return "the parameters";
    if (!same_stations(a, b)) return "the stations";
    if (!same_contacts(a, b)) return "the contacts";
    return same_facts(a, b) ? NULL : "the provenance";
}

/// Comparison of a result with the file that was written.
typedef struct comparison {
    const whirl_result *result; ///< the written result
    whirl_result own;           ///< the part of the result that a file has: the same, but with the tables below
    whirl_table tables[FORMAT_MAX_TABLES];
    finished parts[FORMAT_MAX_TABLES];
    const char *path;
} comparison;

static whirl_status differs(const char *path, const whirl_table *table, size_t point) {
    return whirl_fail(WHIRL_IO_ERROR, "%.200s does not hold what was written: point %zu of the %s differs", path,
                      point + 1, table->name);
}

/// Checks that the file has the same points of the study, with the same values and scales.
static whirl_status compare_slots(const comparison *with, const whirl_result *there) {
    for (size_t i = 0; i < there->table_count; ++i) {
        const whirl_table *own = &with->tables[i], *found = &there->tables[i];
        const size_t planned = whirl_table_planned(found);
        if (own->role != found->role || planned != own->planned || found->count != own->count ||
            found->grid != own->grid || found->refine != own->refine || found->neighbours != own->neighbours ||
            found->places != own->places || found->clock_of != own->clock_of ||
            !same_number(found->clock_factor, own->clock_factor))
            return differs(with->path, own, planned < own->planned ? planned : own->planned);
        for (size_t point = 0; point < own->count; ++point) {
            mapped_evict_often(own->mapped, point);
            mapped_evict_often(found->mapped, point);
            if (whirl_table_slot(own, point) != whirl_table_slot(found, point) || !whirl_table_done(found, point) ||
                !same_number(own->values[point], found->values[point]) || own->branch[point] != found->branch[point] ||
                !same_number(whirl_result_length_scale(with->result, own, point),
                             whirl_result_length_scale(there, found, point)))
                return differs(with->path, own, whirl_table_slot(own, point));
        }
    }
    return whirl_ok();
}

/// Compares a point's block, bit by bit. Indices are checked again: the file may have been replaced since its outline
/// was compared.
static whirl_status compare_block(void *context, const whirl_table *there, size_t table, size_t point,
                                  const double *block) {
    const comparison *with = context;
    const size_t index = table < with->result->table_count ? table : 0;
    const whirl_table *written = &with->result->tables[index], *own = &with->tables[index];
    const size_t size = written->layout.size;
    if (point >= own->count || there->layout.size != size) return differs(with->path, written, point);
    const double *expected = whirl_table_block(written, finished_point(&with->parts[index], point));
    const bool same = expected && memcmp(expected, block, size * sizeof *block) == 0;
    return same ? whirl_ok() : differs(with->path, written, whirl_table_slot(own, point));
}

/// Compares everything but the numbers of the points.
static whirl_status compare_outline(const comparison *with) {
    whirl_result *there = NULL;
    char difference[WHIRL_MESSAGE_SIZE];
    whirl_status status = whirl_result_read_outline(with->path, &there);
    if (status.code != WHIRL_OK) return status;
    const char *part = NULL;
    if (!whirl_result_same_study(&with->own, there, difference, sizeof difference))
        status = whirl_fail(WHIRL_IO_ERROR, "%.100s does not hold what was written: %.280s", with->path, difference);
    else if ((part = head_difference(with->result, there)) != NULL)
        status = whirl_fail(WHIRL_IO_ERROR, "%.200s does not hold what was written: %s differ", with->path, part);
    else
        status = compare_slots(with, there);
    whirl_result_free(there);
    return status;
}

static whirl_status compare(comparison *with) {
    whirl_result *there = NULL;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < with->result->table_count && status.code == WHIRL_OK; ++i) {
        status = finished_points(&with->result->tables[i], &with->parts[i]);
        with->tables[i] = with->parts[i].table;
    }
    // Numbers can be compared only if the outlines, and thus the layouts of the tables, are equal.
    if (status.code == WHIRL_OK) status = compare_outline(with);
    if (status.code == WHIRL_OK) status = read_file(with->path, &(block_taker){compare_block, with}, &there);
    whirl_result_free(there);
    return status;
}

whirl_status whirl_result_verify(const whirl_result *result, const char *path) {
    comparison *with = calloc(1, sizeof *with);
    if (!with) return whirl_fail(WHIRL_NO_MEMORY, "no memory to compare %.200s", path);
    with->result = result;
    with->own = *result;
    with->own.tables = with->tables;
    with->path = path;
    whirl_status status = result->table_count <= FORMAT_MAX_TABLES
                              ? compare(with)
                              : whirl_fail(WHIRL_IO_ERROR, "%.200s cannot hold %zu tables", path, result->table_count);
    for (size_t i = 0; i < FORMAT_MAX_TABLES; ++i) finished_free(&with->parts[i]);
    free(with);
    if (status.code == WHIRL_OK || status.code == WHIRL_NO_MEMORY) return status;
    return whirl_fail(WHIRL_IO_ERROR, "%s", status.message);
}
