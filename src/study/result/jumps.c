// Jumps along a sweep. Where a motion depends continuously on the parameter, neighbouring points differ about as much
// as the points around them do. If one pair differs far more and yet has one regime, the sweep has moved to a
// coexisting motion, or the motion has changed suddenly (a crisis). The sweep alone does not decide which.
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "bounds.h"

enum {
    SIDE = 4,     ///< steps on either side that one is compared with
    MIN_STEPS = 4 ///< fewer steps on both sides together: no verdict
};

/// A jump changes more than this share of the motion's size, and this many times the change of the steps around it.
/// Near a fold the steps of a continuous branch grow as square roots do: the last one to 4 times the median of the 4
/// before it.
static const double MIN_CHANGE = 0.03, MIN_RATIO = 8.0;

/// Change from one point to the next.
typedef struct step {
    double change;  ///< relative to the motion's size; NaN unless both points have one regime
    size_t station; ///< station with the largest change
} step;

/// Returns the longer side of the motion's box, or a hundredth of the displacement if that is larger.
static double jumps_size_of(const double *bounds) {
    const double box = fmax(bounds[4] - bounds[2], bounds[5] - bounds[3]);
    double far = 0.0;
    for (size_t i = 0; i < BOUNDS; i++) far = fmax(far, fabs(bounds[i]));
    return fmax(box, 0.01 * far);
}

static step step_between(const double *before, const double *after, size_t stations) {
    step found = {0.0, 0};
    for (size_t s = 0; s < stations; s++) {
        const double *a = &before[BOUNDS * s], *b = &after[BOUNDS * s], size = fmax(jumps_size_of(a), jumps_size_of(b));
        double change = 0.0;
        for (size_t i = 0; i < BOUNDS; i++) change = fmax(change, fabs(a[i] - b[i]));
        if (size > 0.0 && change / size > found.change) found = (step){change / size, s};
    }
    return found;
}

static bool same_regime(const whirl_verdict *a, const whirl_verdict *b) {
    const bool known = a->regime == WHIRL_PERIODIC || a->regime == WHIRL_QUASI_PERIODIC || a->regime == WHIRL_CHAOTIC;
    return known && a->regime == b->regime && a->period == b->period;
}

/// Computes all steps of a table [count - 1]; `bounds` is scratch for two points.
static void find_steps(const whirl_table *table, size_t stations, double *bounds, step *steps) {
    double *before = bounds, *after = bounds + BOUNDS * stations;
    whirl_verdict last = {.regime = WHIRL_UNDETERMINED};
    bool known = false;
    for (size_t i = 0; i < table->count; i++) {
        const bool done = whirl_table_done(table, i) && bounds_read(table, i, stations, after);
        const whirl_verdict verdict = whirl_table_verdict(table, i);
        if (i > 0) {
            const bool neighbours = done && known && table->branch[i] == table->branch[i - 1];
            steps[i - 1] = neighbours && same_regime(&last, &verdict) ? step_between(before, after, stations)
                                                                      : (step){(double)NAN, 0};
        }
        double *const free_bounds = before;
        before = after;
        after = free_bounds;
        last = verdict;
        known = done;
    }
}

static int jumps_by_size(const void *left, const void *right) {
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

/// Returns the median of up to SIDE steps on either side within the regime, or NaN if they are too few.
static double usual_change(const step *steps, size_t count, size_t at) {
    double around[2 * SIDE];
    size_t found = 0;
    for (size_t i = at; i-- > 0 && at - i <= SIDE && !isnan(steps[i].change);) around[found++] = steps[i].change;
    for (size_t i = at + 1; i < count && i - at <= SIDE && !isnan(steps[i].change); i++)
        around[found++] = steps[i].change;
    if (found < MIN_STEPS) return (double)NAN;
    qsort(around, found, sizeof *around, jumps_by_size);
    return 0.5 * (around[(found - 1) / 2] + around[found / 2]);
}

whirl_status whirl_table_jumps(const whirl_table *table, whirl_jump *jumps, size_t most, size_t *count) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_ORBIT_MEAN);
    *count = 0;
    if (!field || table->count < 2 || table->row > 0) return whirl_ok(); // rows of a map begin anew
    step *steps = malloc(table->count * sizeof *steps);
    double *bounds = malloc((size_t)2 * BOUNDS * field->repeat * sizeof *bounds);
    const bool memory = steps && bounds;
    if (memory) find_steps(table, field->repeat, bounds, steps);
    for (size_t i = 0; memory && i + 1 < table->count; i++) {
        if (!(steps[i].change > MIN_CHANGE)) continue;
        const double usual = usual_change(steps, table->count - 1, i);
        if (!(steps[i].change > MIN_RATIO * usual)) continue;
        if (*count < most) jumps[*count] = (whirl_jump){i, i + 1, steps[i].station, steps[i].change, usual};
        ++*count;
    }
    free(steps);
    free(bounds);
    return memory ? whirl_ok()
                  : whirl_fail(WHIRL_NO_MEMORY, "no memory to look for jumps among %zu points", table->count);
}
