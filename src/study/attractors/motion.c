#include "attractors.h"

#include <math.h>
#include <stdlib.h>

#include "bounds.h"

/// Sections of one orbit differ by less than `one_orbit` of its largest displacement. Bounds and means of one aperiodic
/// motion differ between records by less than `one_cloud` of its extent.
static const double one_orbit = 1e-3, one_cloud = 0.2;

// ---------------------------------------------------------------- reading

/// Reads the last period of the section.
static void read_section(const whirl_table *table, size_t point, const whirl_field *field, motion *m) {
    for (size_t s = 0; s < m->stations; s++) {
        const double *from = whirl_table_field(table, point, field->name, s);
        for (size_t k = 0; k < m->rows; k++)
            for (size_t c = 0; c < 2; c++)
                m->section[(k * m->stations + s) * 2 + c] =
                    from ? from[(field->rows - m->rows + k) * field->columns + c] : (double)NAN;
    }
}

motion *motion_read(const whirl_table *table, size_t point) {
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    const whirl_field *section = whirl_layout_field(&table->layout, WHIRL_FIELD_POINCARE_SECTION);
    const whirl_field *mean = whirl_layout_field(&table->layout, WHIRL_FIELD_ORBIT_MEAN);
    const size_t stations = section ? section->repeat : mean ? mean->repeat : 0, period = (size_t)verdict.period;
    const bool has_rows = section && verdict.regime == WHIRL_PERIODIC && period >= 1 && period <= section->rows;
    const size_t rows = has_rows ? period : 0;
    motion *m = malloc(sizeof *m + (2 * rows + BOUNDS) * stations * sizeof(double));
    if (!m) return NULL;
    *m = (motion){.regime = verdict.regime, .period = verdict.period, .stations = stations, .rows = rows};
    m->section = (double *)(m + 1);
    m->bounds = m->section + 2 * rows * stations;
    m->compared = mean != NULL;
    if (has_rows) read_section(table, point, section, m);
    m->placed = mean && bounds_read(table, point, stations, m->bounds);
    return m;
}

// ---------------------------------------------------------------- orbits

/// Returns the largest difference of a station's coordinate between row i of one section and row k of the other.
static double row_distance(const motion *a, size_t i, const motion *b, size_t k) {
    const size_t columns = 2 * a->stations;
    double away = 0.0;
    for (size_t c = 0; c < columns; c++) {
        const double difference = fabs(a->section[i * columns + c] - b->section[k * columns + c]);
        if (!(difference <= away)) away = difference; // NaN is kept
        if (isnan(difference)) return (double)NAN;
    }
    return away;
}

static double largest_place(const motion *m) {
    double size = 0.0;
    for (size_t i = 0; i < 2 * m->rows * m->stations; i++) size = fmax(size, fabs(m->section[i]));
    return size;
}

/// Returns true if one orbit may bifurcate into the other: equal periods, or one a multiple of the other.
static bool may_be_one_branch(const motion *a, const motion *b) {
    if (a->rows == 0 || b->rows == 0) return true;
    return a->rows % b->rows == 0 || b->rows % a->rows == 0;
}

/// Returns true if the sections of two orbits agree for some shift by whole revolutions. A motion that is still
/// converging may show a multiple of its period.
static bool are_one_orbit(const motion *a, const motion *b) {
    const double size = fmax(largest_place(a), largest_place(b));
    const size_t rows = a->rows > b->rows ? a->rows : b->rows;
    for (size_t skip = 0; skip < rows && may_be_one_branch(a, b); skip++) {
        size_t i = 0;
        while (i < rows && row_distance(a, i % a->rows, b, (i + skip) % b->rows) <= one_orbit * size) i++; // NaN: no
        if (i == rows) return true;
    }
    return false;
}

/// Returns the largest distance of a row of one section from the nearest row of the other.
static double farthest_row(const motion *a, const motion *b) {
    double farthest = 0.0;
    for (size_t i = 0; i < a->rows; i++) {
        double nearest = (double)INFINITY;
        for (size_t k = 0; k < b->rows; k++) nearest = fmin(nearest, row_distance(a, i, b, k));
        farthest = fmax(farthest, nearest);
    }
    return farthest;
}

// ---------------------------------------------------------------- all others

static double bounds_distance(const motion *a, const motion *b) {
    double away = 0.0;
    for (size_t i = 0; i < a->stations * BOUNDS; i++) away = fmax(away, fabs(a->bounds[i] - b->bounds[i]));
    return away;
}

/// Returns the largest width of any station's box, in x or y.
static double motion_extent(const motion *m) {
    double size = 0.0;
    for (size_t i = 0; i < m->stations * BOUNDS; i++)
        if (i % BOUNDS >= 2 && i % BOUNDS < 4) size = fmax(size, m->bounds[i + 2] - m->bounds[i]);
    return size;
}

/// Returns the extent, or a hundredth of the largest displacement if that is larger.
static double motion_size_of(const motion *m) {
    double far = 0.0;
    for (size_t i = 0; i < m->stations * BOUNDS; i++) far = fmax(far, fabs(m->bounds[i]));
    return fmax(motion_extent(m), 0.01 * far);
}

// ---------------------------------------------------------------- both

bool motion_is_same(const motion *a, const motion *b) {
    if (a->regime != b->regime) return false;
    if (a->regime == WHIRL_DIVERGING) return true;
    if (a->rows > 0 && b->rows > 0) return are_one_orbit(a, b);
    if (a->period != b->period) return false;
    if (!a->compared) return true;
    return a->placed && b->placed && bounds_distance(a, b) <= one_cloud * fmax(motion_extent(a), motion_extent(b));
}

double motion_distance(const motion *a, const motion *b) {
    if (a->regime == WHIRL_DIVERGING || b->regime == WHIRL_DIVERGING)
        return a->regime == b->regime ? 0.0 : (double)INFINITY;
    if (!a->placed || !b->placed || a->stations != b->stations || !may_be_one_branch(a, b)) return (double)INFINITY;
    const double away =
        a->rows > 0 && b->rows > 0 ? fmax(farthest_row(a, b), farthest_row(b, a)) : bounds_distance(a, b);
    const double size = fmax(motion_size_of(a), motion_size_of(b));
    return size > 0.0 ? away / size : away > 0.0 ? (double)INFINITY : 0.0;
}
