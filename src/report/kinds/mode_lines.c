#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "mode_lines.h"
#include "shown_kinds.h"
#include "units.h"
#include "whirl/engine/analyze.h"

/// The last point of a line so far, which determines the line's name.
typedef struct line_end {
    size_t line, point;
    double frequency;
    int way;   ///< mode_way
    bool seen; ///< the line has an oscillating mode at some point
} line_end;

/// Orders lines: visible ones first, then by their last point (those that reach the end first), then by frequency.
static int by_end(const void *a, const void *b) {
    const line_end *p = a, *q = b;
    if (p->seen != q->seen) return p->seen ? -1 : 1;
    if (p->point != q->point) return p->point > q->point ? -1 : 1;
    if (p->frequency != q->frequency) return p->frequency < q->frequency ? -1 : 1;
    return p->line < q->line ? -1 : p->line > q->line;
}

/// Returns true if the previous row is the neighbouring point; partial results have gaps.
static bool follows(const whirl_table *table, size_t point) {
    return point > 0 && whirl_table_done(table, point - 1) &&
           whirl_table_slot(table, point) == whirl_table_slot(table, point - 1) + 1;
}

/// Assigns every mode of every point to a line, and finds the ends of the lines, ends [points x modes]. Modes whose
/// frequencies are known only modulo the speed are on no line, since frequencies fold.
static void mode_lines_follow(const whirl_table *table, mode_lines *out, line_end *ends) {
    const size_t modes = out->modes;
    // Find the modes of the point, and the modes of the preceding point that they continue.
    for (size_t point = 0; point < table->count; point++) {
        size_t *const own = out->line + point * modes;
        const double *frequency = whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0);
        const double *before = whirl_table_field(table, point, WHIRL_FIELD_MODES_BEFORE, 0);
        const bool folds = isfinite(whirl_table_number(table, point, WHIRL_FIELD_MODES_MODULO, 0));
        const bool joined = follows(table, point);
        // Give each mode the line of the mode that it continues, or a new one, and move the line's end there.
        for (size_t i = 0; i < modes; i++) {
            own[i] = SIZE_MAX;
            if (!whirl_table_done(table, point) || !isfinite(frequency[i]) || folds) continue;
            if (joined && before[i] >= 1.0 && before[i] <= (double)modes)
                own[i] = out->line[(point - 1) * modes + (size_t)before[i] - 1];
            if (own[i] == SIZE_MAX) {
                own[i] = out->count++;
                ends[own[i]].line = own[i];
            }
            if (!mode_is_overdamped(table, point, i))
                ends[own[i]] = (line_end){own[i], point, frequency[i], mode_way(table, point, i), true};
        }
    }
}

/// Names the lines with an oscillating mode, and removes all other lines and overdamped modes.
static void name_lines(const whirl_table *table, mode_lines *out, line_end *ends) {
    static const char letters[] = {'B', 'M', 'F', 'T', 'A'};
    unsigned counts[sizeof letters] = {0};
    size_t seen = 0;
    for (size_t line = 0; line < out->count; line++) ends[line].line = ends[line].seen ? seen++ : SIZE_MAX;
    for (size_t i = 0; i < table->count * out->modes; i++)
        if (out->line[i] != SIZE_MAX)
            out->line[i] =
                mode_is_overdamped(table, i / out->modes, i % out->modes) ? SIZE_MAX : ends[out->line[i]].line;
    qsort(ends, out->count, sizeof *ends, by_end);
    out->count = seen;
    for (size_t i = 0; i < seen; i++)
        snprintf(out->names[ends[i].line], MODE_NAME, "%u%c", ++counts[ends[i].way + 1], letters[ends[i].way + 1]);
}

int mode_way(const whirl_table *table, size_t point, size_t mode) {
    const double *torsion = whirl_table_field(table, point, WHIRL_FIELD_MODES_TORSION, 0);
    const double *axial = whirl_table_field(table, point, WHIRL_FIELD_MODES_AXIAL_SHARE, 0);
    const double *direction = whirl_table_field(table, point, WHIRL_FIELD_MODES_DIRECTION, 0);
    switch (whirl_mode_kind_of(torsion ? torsion[mode] : 0.0, axial ? axial[mode] : 0.0)) {
    case WHIRL_TORSIONAL_MODE:
        return MODE_TORSIONAL;
    case WHIRL_AXIAL_MODE:
        return MODE_AXIAL;
    default:
        return units_way(direction ? direction[mode] : 0.0);
    }
}

const char *mode_way_name(int way) {
    static const char *const names[] = {"backward", "to and fro", "forward", "torsional", "axial"};
    return names[way - MODE_BACKWARD];
}

bool mode_is_overdamped(const whirl_table *table, size_t point, size_t mode) {
    const double *ratio = whirl_table_field(table, point, WHIRL_FIELD_MODES_DAMPING_RATIO, 0);
    return ratio && ratio[mode] > WHIRL_OVERDAMPED_RATIO;
}

bool mode_lines_of(const whirl_table *table, mode_lines *out) {
    static const char *const needed[] = {WHIRL_FIELD_MODES_BEFORE, WHIRL_FIELD_MODES_FREQUENCY,
                                         WHIRL_FIELD_MODES_DIRECTION};
    *out = (mode_lines){.modes = SIZE_MAX};
    for (size_t i = 0; i < sizeof needed / sizeof *needed; i++) {
        const whirl_field *field =
            whirl_layout_field(&table->layout, needed[i]); // results of older versions may lack fields
        out->modes = !field ? 0 : field->rows < out->modes ? field->rows : out->modes;
    }
    const size_t most = table->count * out->modes;
    if (most == 0 || !*table->parameter) return false;
    line_end *ends = calloc(most, sizeof *ends);
    out->line = calloc(most, sizeof *out->line);
    out->names = calloc(most, sizeof *out->names);
    if (ends && out->line && out->names) {
        mode_lines_follow(table, out, ends);
        name_lines(table, out, ends);
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
