// Compares two results; doubles must agree bit for bit.
#ifndef UNIT_STORE_SAME_H
#define UNIT_STORE_SAME_H

#include "whirl/engine/result.h"

#include <string.h>

static inline bool same_bits(const double *a, const double *b, size_t count) {
    return count == 0 || memcmp(a, b, count * sizeof *a) == 0;
}

static inline bool same_members(const whirl_member *member, const void *a, const void *b) {
    char one[WHIRL_NAME_SIZE], other[WHIRL_NAME_SIZE];
    for (; member->part; ++member) {
        whirl_member_text(member, a, one);
        whirl_member_text(member, b, other);
        if (strcmp(one, other) != 0) return false;
    }
    return true;
}

static inline bool same_layout(const whirl_layout *a, const whirl_layout *b) {
    if (a->field_count != b->field_count || a->size != b->size) return false;
    for (size_t i = 0; i < a->field_count; ++i) {
        const whirl_field *f = &a->fields[i], *g = &b->fields[i];
        if (strcmp(f->name, g->name) != 0 || strcmp(f->unit, g->unit) != 0 || strcmp(f->meaning, g->meaning) != 0 ||
            f->extent != g->extent || f->rows != g->rows || f->columns != g->columns || f->repeat != g->repeat ||
            f->offset != g->offset)
            return false;
    }
    return true;
}

static inline bool same_slots(const whirl_table *a, const whirl_table *b) {
    if (whirl_table_planned(a) != whirl_table_planned(b)) return false;
    for (size_t i = 0; i < a->count && i < b->count; ++i)
        if (whirl_table_slot(a, i) != whirl_table_slot(b, i)) return false;
    return true;
}

static inline bool same_table(const whirl_table *a, const whirl_table *b) {
    return strcmp(a->name, b->name) == 0 && strcmp(a->parameter, b->parameter) == 0 &&
           strcmp(a->second, b->second) == 0 && a->row == b->row && strcmp(a->third, b->third) == 0 &&
           a->plane == b->plane && a->count == b->count && a->clock_of == b->clock_of &&
           same_bits(&a->clock_factor, &b->clock_factor, 1) && same_slots(a, b) && a->analyses == b->analyses &&
           same_members(whirl_integrate_members(), &a->integrate, &b->integrate) &&
           same_members(whirl_record_members(), &a->record, &b->record) && same_layout(&a->layout, &b->layout) &&
           same_bits(a->values, b->values, a->count) && !a->length_scales == !b->length_scales &&
           (!a->length_scales || same_bits(a->length_scales, b->length_scales, a->count)) &&
           memcmp(a->branch, b->branch, a->count * sizeof *a->branch) == 0 &&
           same_bits(a->blocks, b->blocks, a->count * a->layout.size);
}

static inline bool same_case(const whirl_result *a, const whirl_result *b) {
    if (strcmp(a->title, b->title) != 0 || strcmp(a->case_text, b->case_text) != 0 ||
        strcmp(a->case_name, b->case_name) != 0 || !same_bits(&a->speed, &b->speed, 1) ||
        !same_bits(&a->length_scale, &b->length_scale, 1) || !same_bits(&a->force_scale, &b->force_scale, 1) ||
        a->parameter_count != b->parameter_count || a->station_count != b->station_count ||
        a->contact_count != b->contact_count || a->fact_count != b->fact_count)
        return false;
    for (size_t i = 0; i < a->parameter_count; ++i) {
        const whirl_parameter *p = &a->parameters[i], *q = &b->parameters[i];
        if (strcmp(p->name, q->name) != 0 || strcmp(p->unit, q->unit) != 0 || strcmp(p->text, q->text) != 0 ||
            !same_bits(&p->value, &q->value, 1))
            return false;
    }
    for (size_t i = 0; i < a->station_count; ++i) {
        const whirl_probe *p = &a->stations[i], *q = &b->stations[i];
        if (strcmp(p->name, q->name) != 0 || p->x != q->x || p->y != q->y || p->vx != q->vx || p->vy != q->vy ||
            p->shaft != q->shaft || !same_bits(&p->clearance, &q->clearance, 1) || !same_bits(&p->gap, &q->gap, 1) ||
            !same_bits(&p->position, &q->position, 1))
            return false;
    }
    for (size_t i = 0; i < a->contact_count; ++i)
        if (strcmp(a->contacts[i], b->contacts[i]) != 0) return false;
    for (size_t i = 0; i < a->fact_count; ++i)
        if (strcmp(a->facts[i].name, b->facts[i].name) != 0 || strcmp(a->facts[i].value, b->facts[i].value) != 0)
            return false;
    return true;
}

static inline bool same_result(const whirl_result *a, const whirl_result *b) {
    if (!same_case(a, b) || a->table_count != b->table_count) return false;
    for (size_t i = 0; i < a->table_count; ++i)
        if (!same_table(&a->tables[i], &b->tables[i])) return false;
    return true;
}

#endif
