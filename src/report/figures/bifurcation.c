// Finds the ranges of a bifurcation diagram's axes, and the part of the parameter's axis that belongs to a point.
#include <math.h>
#include <stdlib.h>

#include "bifurcation.h"
#include "machine_at.h"
#include "quantities.h"
#include "regimes.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

static int by_value(const void *left, const void *right) {
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

/// Finds the range of the exponents, without the deep minima at superstable points that would flatten the curve.
static span exponent_span(const whirl_table *table) {
    span range = span_empty();
    double *sorted = malloc((table->count + 1) * sizeof *sorted);
    size_t count = 0;
    for (size_t i = 0; sorted && i < table->count; i++) {
        const double value = point_exponent(table, i).value;
        if (isfinite(value)) sorted[count++] = value;
    }
    if (count > 0) {
        qsort(sorted, count, sizeof *sorted, by_value);
        const double low = sorted[count / 20], high = sorted[count - 1 - count / 20], reach = 1.5 * (high - low);
        span_widen(&range, fmax(sorted[0], low - reach));
        span_widen(&range, fmin(sorted[count - 1], high + reach));
        span_widen(&range, 0.0);
    }
    free(sorted);
    return span_with_margin(range, 0.08, 0.01);
}

/// Returns the number of grid steps between two points of a table; 0 for points of different branches.
static double places_between(const whirl_table *table, size_t a, size_t b) {
    if (b >= table->count || table->branch[a] != table->branch[b]) return 0.0;
    return (double)whirl_table_slot(table, b) - (double)whirl_table_slot(table, a);
}

/// Returns true for a sweep with `scale: log`: ratios of neighbours are constant, differences are not.
static bool has_equal_ratios(const whirl_table *table) {
    const double *v = table->values;
    if (places_between(table, 0, 1) == 0.0 || places_between(table, 1, 2) == 0.0 || !(v[0] > 0.0)) return false;
    const double ratio = log(v[1] / v[0]) / places_between(table, 0, 1);
    for (size_t i = 1; i < table->count && places_between(table, i - 1, i) != 0.0; i++)
        if (!(v[i] > 0.0) ||
            !(fabs(log(v[i] / v[i - 1]) / places_between(table, i - 1, i) - ratio) < 1e-6 * fabs(ratio)))
            return false;
    const double first = (v[1] - v[0]) / places_between(table, 0, 1),
                 next = (v[2] - v[1]) / places_between(table, 1, 2);
    return fabs(next - first) > 1e-6 * fabs(first);
}

/// Returns the middle of two values on the axis, linear or logarithmic.
static double middle(const bifurcation *of, double a, double b) {
    return of->ratios ? sqrt(a * b) : 0.5 * (a + b);
}

/// Mirrors the value `b` at `a` (on a logarithmic axis by ratio).
static double mirrored(const bifurcation *of, double a, double b) {
    return of->ratios ? a * (a / b) : a + (a - b);
}

/// Returns the value of the next (side 1) or previous (-1) point; NaN if the table does not have it.
static double neighbour_value(const bifurcation *of, size_t i, int side) {
    const whirl_table *const table = of->table;
    if (side < 0 && i == 0) return NAN;
    const size_t other = side < 0 ? i - 1 : i + 1;
    const double apart = side < 0 ? places_between(table, other, i) : places_between(table, i, other);
    if (apart <= 0.0) return NAN;
    const double at = table->values[i], there = table->values[other];
    return of->ratios ? at * pow(there / at, 1.0 / apart) : at + (there - at) / apart;
}

/// Returns the value at a place of the study's grid; NaN if the table has no point there.
static double place_value(const whirl_table *all, size_t place) {
    if (!all->slots && place < whirl_table_places(all)) return all->values[place];
    for (size_t i = 0; all->slots && i < all->count; i++)
        if (whirl_table_place(all, i) == place) return all->values[i];
    return NAN;
}

/// Returns the value of the next or previous place of the study's grid, for an attractor that ends at this point.
static double value_of_study(const bifurcation *of, size_t i, int side) {
    const whirl_table *const table = of->table;
    if (!table->source || (side < 0 && table->slots[i] == 0)) return NAN;
    return place_value(table->source, side < 0 ? table->slots[i] - 1 : table->slots[i] + 1);
}

void bifurcation_edges(const bifurcation *of, size_t i, double *low, double *high) {
    const double at = of->table->values[i];
    double before = neighbour_value(of, i, -1), after = neighbour_value(of, i, 1);
    if (isnan(before)) before = value_of_study(of, i, -1);
    if (isnan(after)) after = value_of_study(of, i, 1);
    if (isnan(before)) before = isnan(after) ? at - 1.0 : mirrored(of, at, after);
    if (isnan(after)) after = mirrored(of, at, before);
    *low = fmin(middle(of, at, before), middle(of, at, after));
    *high = fmax(middle(of, at, before), middle(of, at, after));
}

/// Returns the walls around the station if they are the same at all points (up to 33 are compared); 0 for a wall that
/// changes.
static machine_walls lasting_walls(const bifurcation *of) {
    const size_t count = of->table->count, step = 1 + count / 32;
    machine_walls walls = machine_walls_at(of->machine, of->result, of->table, count - 1, of->station);
    for (size_t i = 0; i < count; i += step) {
        const machine_walls here = machine_walls_at(of->machine, of->result, of->table, i, of->station);
        if (fabs(here.gap - walls.gap) > 1e-9 * walls.gap) walls.gap = 0.0;
        if (fabs(here.clearance - walls.clearance) > 1e-9 * walls.clearance) walls.clearance = 0.0;
    }
    return walls;
}

size_t bifurcation_kinds(const bifurcation *of) {
    return of->attractors > 0 ? of->attractors : CLASS_COUNT;
}

size_t bifurcation_kind(const bifurcation *of, size_t point) {
    if (of->attractors > 0) return (of->table->attractors[point].number - 1) % ATTRACTOR_COLOURS;
    const whirl_verdict verdict = whirl_table_verdict(of->table, point);
    return (size_t)regime_class_of(&verdict);
}

const char *bifurcation_kind_colour(const bifurcation *of, size_t kind) {
    return of->attractors > 0 ? attractor_colour(kind + 1) : regime_class_colour((regime_class)kind);
}

void bifurcation_kind_name(const bifurcation *of, size_t kind, char text[WHIRL_NAME_SIZE]) {
    if (of->attractors == 0)
        snprintf(text, WHIRL_NAME_SIZE, "%s", regime_class_name((regime_class)kind));
    else
        snprintf(text, WHIRL_NAME_SIZE, "attractor %zu", kind + 1);
}

/// Returns the number of attractors, but at most the number of colours for them.
static size_t count_attractors(const whirl_table *table) {
    size_t most = 0;
    for (size_t i = 0; table->attractors && i < table->count; i++)
        if (table->attractors[i].number > most) most = table->attractors[i].number;
    return most < ATTRACTOR_COLOURS ? most : ATTRACTOR_COLOURS;
}

void bifurcation_survey(bifurcation *of) {
    const whirl_table *table = of->table;
    size_t done = 0, rubbing = 0;
    of->attractors = count_attractors(table);
    span parameter = span_empty(), x = span_empty(), y = span_empty(), radius = span_empty();
    // Ranges and flags over all computed points.
    for (size_t i = 0; i < table->count; i++) {
        if (!whirl_table_done(table, i)) continue;
        const numbers section = point_section(table, i, of->station);
        of->present[bifurcation_kind(of, i)] = true;
        of->both |= table->branch[i] < 0;
        span_widen(&parameter, of->value * table->values[i]);
        const double length = whirl_shown_length(of->units, table, i);
        span_widen(&radius, length * max_radius(table, i, of->station));
        const double share = rub_share(table, i, of->result->contact_count);
        of->share = fmax(of->share, 1.1 * share);
        rubbing += share > 0.0;
        done++;
        for (size_t k = 0; k < section.rows; k++) {
            span_widen(&x, length * section.at[4 * k]);
            span_widen(&y, length * section.at[4 * k + 1]);
        }
    }
    of->share = of->share > 0.0 ? of->share : 0.01;
    // The range of the parameter includes the parts of the axis of its end points.
    of->ratios = has_equal_ratios(table);
    for (size_t i = 0; i < table->count; i++) {
        double low, high;
        if (!whirl_table_done(table, i)) continue;
        bifurcation_edges(of, i, &low, &high);
        span_widen(&parameter, of->value * low);
        span_widen(&parameter, of->value * high);
    }
    of->parameter = of->ratios ? parameter : span_with_margin(parameter, 0.012, 0.0);
    of->x = span_with_margin(x, 0.04, 1e-6 * of->length);
    of->y = span_with_margin(y, 0.04, 1e-6 * of->length);
    // Walls around the station.
    const machine_walls walls =
        whirl_shown_one_length(of->units, table) ? lasting_walls(of) : (machine_walls){0.0, 0.0};
    of->gap = of->length * walls.gap;
    of->clearance = of->length * walls.clearance;
    if (of->gap > 2.0 * radius.high)
        of->gap = 0.0; // if the gap were on the axis, the curve of the radius would be flat
    if (of->gap > 0.0) span_widen(&radius, of->gap);
    of->radius = span_with_margin(radius, 0.08, 1e-6 * of->length);
    of->exponent = exponent_span(table);
    of->rub = has_rub(table, of->result->contact_count);
    of->shaded = rubbing > 0 && 2 * rubbing <= done;
    of->confidence = of->attractors == 0 && whirl_layout_field(&table->layout, WHIRL_FIELD_REGIME_CONFIDENCE) != NULL;
}
