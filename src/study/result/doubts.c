// Why motions of a table are undetermined, and what would decide them.
#include <math.h>
#include <stdio.h>

#include "whirl/engine/result.h"

size_t whirl_table_doubts(const whirl_table *table, whirl_doubt doubts[WHIRL_REMEDIES]) {
    size_t count = 0;
    for (size_t remedy = 0; remedy < WHIRL_REMEDIES; remedy++) {
        whirl_doubt found = {.points = 0};
        double *const factor = &found.verdict.advice.factor;
        for (size_t point = 0; point < table->count; point++) {
            if (!whirl_table_done(table, point)) continue;
            const whirl_verdict verdict = whirl_table_verdict(table, point);
            if (verdict.regime != WHIRL_UNDETERMINED || verdict.advice.remedy != remedy) continue;
            if (found.points == 0) found = (whirl_doubt){.first = point, .verdict = verdict};
            found.points++;
            *factor = fmax(*factor, verdict.advice.factor);
        }
        if (found.points > 0) doubts[count++] = found;
    }
    return count;
}

// ---------------------------------------------------------------- ranges
// Describes the points of a table that left the range of a law, or rest against a contact.

const char *whirl_result_law_range(const whirl_result *result, size_t index) {
    char name[WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, "range %zu", index + 1);
    return whirl_result_fact(result, name);
}

size_t whirl_table_held(const whirl_table *table, size_t contact, whirl_left *out) {
    *out = (whirl_left){.reached = 0.0};
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_RANGES_HELD);
    for (size_t point = 0; field && point < table->count; point++) {
        const double force = whirl_table_number(table, point, field->name, contact);
        if (!whirl_table_done(table, point) || !(force > 0.0)) continue;
        if (out->points++ == 0) out->first = point;
        out->reached = fmax(out->reached, force);
    }
    return out->points;
}

size_t whirl_table_unfound(const whirl_table *table, whirl_left *out) {
    *out = (whirl_left){.reached = 1.0, .most = 1.0};
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_RANGES_REST);
    for (size_t point = 0; field && point < table->count; point++) {
        const double share = whirl_table_number(table, point, field->name, 0);
        if (!whirl_table_done(table, point) || share >= 1.0) continue;
        if (out->points++ == 0) out->first = point;
        if (!(share > out->reached)) out->reached = share;
    }
    return out->points;
}

size_t whirl_table_elsewhere(const whirl_table *table, whirl_left *out) {
    *out = (whirl_left){.reached = 0.0, .most = NAN};
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_RANGES_ELSEWHERE);
    for (size_t point = 0; field && point < table->count; point++) {
        double distance = 0.0;
        if (!whirl_table_done(table, point)) continue;
        for (size_t s = 0; s < field->repeat; s++) {
            const double *const at = whirl_table_field(table, point, field->name, s);
            distance = fmax(distance, hypot(at[0], at[1]));
        }
        if (!(distance > 0.0)) continue;
        if (out->points++ == 0) {
            out->first = point;
            out->most = whirl_table_number(table, point, WHIRL_FIELD_RANGES_ELSEWHERE_GROWTH, 0);
        }
        out->reached = fmax(out->reached, distance);
    }
    return out->points;
}

size_t whirl_table_left(const whirl_table *table, size_t index, whirl_left *out) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_RANGES_REACHED);
    *out = (whirl_left){.points = 0, .reached = NAN, .most = NAN};
    for (size_t point = 0; field && index < field->rows && point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const double *at = whirl_table_field(table, point, WHIRL_FIELD_RANGES_REACHED, 0) + 2 * index;
        if (!(at[0] > at[1] * (1.0 + 1e-9))) continue;
        if (out->points == 0) out->first = point;
        if (out->points == 0 || at[0] / at[1] > out->reached / out->most) {
            out->reached = at[0];
            out->most = at[1];
        }
        out->points++;
    }
    return out->points;
}
