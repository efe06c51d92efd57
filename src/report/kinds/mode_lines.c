#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "shown_kinds.h"

/// Where a line was seen last, by which its name goes.
typedef struct line_end {
    size_t line, point;
    double frequency;
    int way; ///< units_way
} line_end;

/// Those that go on to the last point first, by rising frequency.
static int by_end(const void *a, const void *b) {
    const line_end *p = a, *q = b;
    if (p->point != q->point) return p->point > q->point ? -1 : 1;
    if (p->frequency != q->frequency) return p->frequency < q->frequency ? -1 : 1;
    return p->line < q->line ? -1 : p->line > q->line;
}

/// Whether the row before holds the value before: results that are not whole have gaps.
static bool follows(const whirl_table *table, size_t point) {
    return point > 0 && whirl_table_done(table, point - 1) &&
           whirl_table_slot(table, point) == whirl_table_slot(table, point - 1) + 1;
}

/// Gives every mode of every point its line; ends [points x modes] are those of lines. None where frequencies are known
/// but for multiples of the speed: these fold.
static void follow(const whirl_table *table, mode_lines *out, line_end *ends) {
    const size_t modes = out->modes;
    for (size_t point = 0; point < table->count; point++) {
        size_t *const own = out->line + point * modes;
        const double *frequency = whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0);
        const double *direction = whirl_table_field(table, point, WHIRL_FIELD_MODES_DIRECTION, 0);
        const double *before = whirl_table_field(table, point, WHIRL_FIELD_MODES_BEFORE, 0);
        const bool folds = isfinite(whirl_table_number(table, point, WHIRL_FIELD_MODES_MODULO, 0));
        const bool follow = follows(table, point);
        for (size_t i = 0; i < modes; i++) {
            own[i] = SIZE_MAX;
            if (!whirl_table_done(table, point) || !isfinite(frequency[i]) || folds) continue;
            if (follow && before[i] >= 1.0 && before[i] <= (double)modes)
                own[i] = out->line[(point - 1) * modes + (size_t)before[i] - 1];
            if (own[i] == SIZE_MAX) own[i] = out->count++;
            ends[own[i]] = (line_end){own[i], point, frequency[i], units_way(direction[i])};
        }
    }
}

static void name_lines(mode_lines *out, line_end *ends) {
    static const char letters[] = {'B', 'M', 'F'};
    unsigned counts[3] = {0, 0, 0};
    qsort(ends, out->count, sizeof *ends, by_end);
    for (size_t i = 0; i < out->count; i++)
        snprintf(out->names[ends[i].line], MODE_NAME, "%u%c", ++counts[ends[i].way + 1], letters[ends[i].way + 1]);
}

bool mode_lines_of(const whirl_table *table, mode_lines *out) {
    static const char *const needed[] = {WHIRL_FIELD_MODES_BEFORE, WHIRL_FIELD_MODES_FREQUENCY,
                                         WHIRL_FIELD_MODES_DIRECTION};
    *out = (mode_lines){.modes = SIZE_MAX};
    for (size_t i = 0; i < sizeof needed / sizeof *needed; i++) {
        const whirl_field *field = whirl_layout_field(&table->layout, needed[i]); // results of old have not all
        out->modes = !field ? 0 : field->rows < out->modes ? field->rows : out->modes;
    }
    const size_t most = table->count * out->modes;
    if (most == 0 || !*table->parameter) return false;
    line_end *ends = calloc(most, sizeof *ends);
    out->line = calloc(most, sizeof *out->line);
    out->names = calloc(most, sizeof *out->names);
    if (ends && out->line && out->names) {
        follow(table, out, ends);
        name_lines(out, ends);
    }
    free(ends);
    if (out->count == 0) mode_lines_free(out);
    return out->count > 0;
}

const char *mode_lines_name(const mode_lines *lines, size_t point, size_t mode) {
    const size_t line = lines->line ? lines->line[point * lines->modes + mode] : SIZE_MAX;
    return line == SIZE_MAX ? "" : lines->names[line];
}

void mode_lines_free(mode_lines *lines) {
    free(lines->line);
    free(lines->names);
    *lines = (mode_lines){.line = NULL};
}
