// Attractors of a basin: which points came to rest on the same motion. Periodic motions are compared by their orbits'
// sections, all others by where they go; a motion without a verdict is not told.
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "bounds.h"

enum { MOST = 64 };

/// Sections of one orbit differ by less than this share of its largest displacement; the bounds and means of a motion
/// that is not periodic, from record to record, by less than this share of its extent.
static const double one_orbit = 1e-3, one_cloud = 0.2;

static bool is_told(const whirl_table *table, size_t point) {
    return whirl_table_done(table, point) && whirl_table_verdict(table, point).regime != WHIRL_UNDETERMINED;
}

// ---------------------------------------------------------------- orbits

/// Two orbits of k revolutions whose sections are compared.
typedef struct two_orbits {
    const double *a, *b;     ///< the last k rows of one station
    size_t k, columns, skip; ///< rows of b are taken from this one on
    double away, size;
} two_orbits;

static void compare_rows(two_orbits *o) {
    for (size_t i = 0; i < o->k; i++) {
        const double *a = o->a + i * o->columns, *b = o->b + (i + o->skip) % o->k * o->columns;
        for (size_t c = 0; c < 2; c++) {
            o->away = fmax(o->away, fabs(a[c] - b[c]));
            o->size = fmax(o->size, fmax(fabs(a[c]), fabs(b[c])));
        }
    }
}

/// Whether the sections of two orbits of k revolutions agree, whichever revolution they begin with.
static bool are_one_orbit(const whirl_table *table, const whirl_field *section, size_t a, size_t b, size_t k) {
    const size_t first = section->rows - k;
    for (size_t skip = 0; skip < k; skip++) {
        two_orbits o = {.k = k, .columns = section->columns, .skip = skip};
        for (size_t s = 0; s < section->repeat; s++) {
            o.a = whirl_table_field(table, a, section->name, s) + first * o.columns;
            o.b = whirl_table_field(table, b, section->name, s) + first * o.columns;
            compare_rows(&o);
        }
        if (o.away <= one_orbit * o.size) return true; // NaN: no
    }
    return false;
}

// ---------------------------------------------------------------- all others

/// Whether two motions go about the same places; not where these are not known.
static bool are_one_cloud(const whirl_table *table, size_t stations, size_t a, size_t b) {
    double away = 0.0, size = 0.0, one[WHIRL_MAX_PROBES * BOUNDS], other[WHIRL_MAX_PROBES * BOUNDS];
    if (!bounds_read(table, a, stations, one) || !bounds_read(table, b, stations, other)) return false;
    for (size_t i = 0; i < stations * BOUNDS; i++) {
        away = fmax(away, fabs(one[i] - other[i]));
        if (i % BOUNDS < 2) size = fmax(size, one[i + 4] - one[i + 2]); // from the least to the largest x, and y
    }
    return away <= one_cloud * size;
}

/// Whether two points have come to rest on one attractor, by all that the table has of them.
static bool are_one(const whirl_table *table, size_t a, size_t b) {
    const whirl_verdict one = whirl_table_verdict(table, a), other = whirl_table_verdict(table, b);
    const whirl_field *section = whirl_layout_field(&table->layout, "poincare/section");
    const whirl_field *mean = whirl_layout_field(&table->layout, "orbit/mean");
    const size_t k = (size_t)one.period;
    if (one.regime != other.regime || one.period != other.period) return false;
    if (one.regime == WHIRL_DIVERGING) return true;
    if (one.regime == WHIRL_PERIODIC && section && k >= 1 && k <= section->rows)
        return are_one_orbit(table, section, a, b, k);
    return !mean || are_one_cloud(table, mean->repeat, a, b);
}

// ---------------------------------------------------------------- all points

static int by_points(const void *left, const void *right) {
    const whirl_attractor *a = left, *b = right;
    if (a->points != b->points) return a->points < b->points ? 1 : -1;
    return (a->first > b->first) - (a->first < b->first);
}

/// Gives every point the index of its attractor, SIZE_MAX for none; *count attractors are found.
static void tell_apart(const whirl_table *table, size_t *of, whirl_attractor *found, size_t *count) {
    for (size_t i = 0; i < table->count; i++) {
        size_t k = 0;
        of[i] = MOST;
        if (!is_told(table, i)) continue;
        while (k < *count && !are_one(table, found[k].first, i)) k++;
        if (k == MOST) continue;
        if (k == *count) found[(*count)++] = (whirl_attractor){.first = i};
        found[k].points++;
        of[i] = k;
    }
}

/// The standard error of a share is that of as many starts drawn at random.
static void take_shares(whirl_attractor *found, size_t count, size_t done) {
    for (size_t k = 0; k < count; k++) {
        const double share = (double)found[k].points / (double)done;
        found[k].share = share;
        found[k].error = sqrt(share * (1.0 - share) / (double)done);
    }
}

whirl_status whirl_table_attractors(const whirl_table *table, size_t *labels, whirl_attractor *attractors, size_t most,
                                    size_t *count) {
    whirl_attractor found[MOST] = {{.points = 0}};
    size_t *of = malloc((table->count + 1) * sizeof *of), done = 0, number[MOST + 1] = {0};
    *count = 0;
    if (!of) return whirl_fail(WHIRL_NO_MEMORY, "no memory to tell the attractors of %zu points apart", table->count);
    tell_apart(table, of, found, count);
    for (size_t i = 0; i < table->count; i++) done += whirl_table_done(table, i);
    qsort(found, *count, sizeof *found, by_points);
    take_shares(found, *count, done);
    for (size_t k = 0; k < *count; k++) number[of[found[k].first]] = k + 1;
    for (size_t i = 0; labels && i < table->count; i++) labels[i] = number[of[i]];
    for (size_t k = 0; k < *count && k < most; k++) attractors[k] = found[k];
    free(of);
    return whirl_ok();
}
