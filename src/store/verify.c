// Comparing results: a file with what it was written from, and the studies of two results.
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "identity.h"

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

// NaN equals NaN, and 0 not -0.
static bool same_number(double a, double b) {
    uint64_t bits[2];
    memcpy(&bits[0], &a, sizeof a);
    memcpy(&bits[1], &b, sizeof b);
    return bits[0] == bits[1];
}

static bool same_facts(const whirl_result *a, const whirl_result *b) {
    if (a->fact_count != b->fact_count) return false;
    for (size_t i = 0; i < a->fact_count; ++i)
        if (strcmp(a->facts[i].name, b->facts[i].name) != 0 || strcmp(a->facts[i].value, b->facts[i].value) != 0)
            return false;
    return true;
}

static bool same_stations(const whirl_result *a, const whirl_result *b) {
    for (size_t i = 0; i < a->station_count; ++i) {
        const whirl_probe *p = &a->stations[i], *q = &b->stations[i];
        if (p->x != q->x || p->y != q->y || p->vx != q->vx || p->vy != q->vy ||
            !same_number(p->clearance, q->clearance) || !same_number(p->gap, q->gap))
            return false;
    }
    return true;
}

static bool same_contacts(const whirl_result *a, const whirl_result *b) {
    if (a->contact_count != b->contact_count) return false;
    for (size_t i = 0; i < a->contact_count; ++i)
        if (strcmp(a->contacts[i], b->contacts[i]) != 0) return false;
    return true;
}

static bool same_parameters(const whirl_result *a, const whirl_result *b) {
    for (size_t i = 0; i < a->parameter_count; ++i)
        if (!same_number(a->parameters[i].value, b->parameters[i].value) ||
            strcmp(a->parameters[i].text, b->parameters[i].text) != 0)
            return false;
    return true;
}

// What differs in the parts that belong to no table, or NULL.
static const char *head_difference(const whirl_result *a, const whirl_result *b) {
    if (strcmp(a->title, b->title) != 0) return "the title";
    if (strcmp(a->case_name, b->case_name) != 0) return "the name of the case";
    if (!same_number(a->speed, b->speed) || !same_number(a->length_scale, b->length_scale) ||
        !same_number(a->force_scale, b->force_scale))
        return "the scales";
    if (!same_parameters(a, b)) return "the parameters";
    if (!same_stations(a, b)) return "the stations";
    if (!same_contacts(a, b)) return "the contacts";
    return same_facts(a, b) ? NULL : "the provenance";
}

static whirl_status compare_table(const whirl_table *a, const whirl_table *b, const char *path) {
    const size_t size = a->layout.size;
    // Signs of zeros and the bits of a NaN are part of a result. Values need no bits: they are in the identity.
    for (size_t point = 0; point < a->count; ++point) {
        if (whirl_table_done(a, point) != whirl_table_done(b, point) ||
            memcmp(a->blocks + point * size, b->blocks + point * size, size * sizeof *a->blocks) != 0)
            return whirl_fail(WHIRL_IO_ERROR, "%.200s does not hold what was written: point %zu of the %s differs",
                              path, point + 1, a->name);
    }
    return whirl_ok();
}

whirl_status whirl_result_verify(const whirl_result *result, const char *path) {
    whirl_result *there = NULL;
    char difference[WHIRL_MESSAGE_SIZE];
    whirl_status status = whirl_result_read(path, &there);
    if (status.code != WHIRL_OK) return whirl_fail(WHIRL_IO_ERROR, "%s", status.message);
    const char *part = NULL;
    if (!whirl_result_same_study(result, there, difference, sizeof difference))
        status = whirl_fail(WHIRL_IO_ERROR, "%.100s does not hold what was written: %.280s", path, difference);
    else if ((part = head_difference(result, there)) != NULL)
        status = whirl_fail(WHIRL_IO_ERROR, "%.200s does not hold what was written: %s differ", path, part);
    for (size_t i = 0; i < result->table_count && status.code == WHIRL_OK; ++i)
        status = compare_table(&result->tables[i], &there->tables[i], path);
    whirl_result_free(there);
    return status;
}
