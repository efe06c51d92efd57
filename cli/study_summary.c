#include "study_summary.h"

#include <stdio.h>
#include <string.h>

static const char *plural(double count) {
    return count == 1 ? "" : "s";
}

/// Prints the limits of a batch that follows branches.
static void summary_print_limits(const whirl_batch *batch) {
    const double points = (double)batch->count;
    printf("%s%s: at most %d points, from ", *batch->second ? " and " : "", batch->second, batch->record.trace.points);
    const char *begins = whirl_analysis_kind(batch->analyses)->begins;
    if (begins)
        printf("%s on\n", begins);
    else
        printf("%.0f value%s on\n", points, plural(points));
}

/// Prints the points and starts of a batch: ": 25 points from 48 starts each, and from neighbours in up to 20 rounds,
/// 8100 revolutions a start".
static void summary_print_starts(const whirl_batch *batch, double revolutions) {
    printf(": %zu point%s from %zu starts each, ", batch->count, plural((double)batch->count), batch->starts);
    if (batch->neighbours > 0)
        printf("and from neighbours in up to %zu round%s, ", batch->neighbours, plural((double)batch->neighbours));
    printf("%.0f revolution%s a start", revolutions, plural(revolutions));
}

void summarize_study(const whirl_study *study) {
    for (size_t i = 0; i < study->batch_count; i++) {
        const whirl_batch *const batch = &study->batches[i];
        const char *const name = batch->integrate.method;
        const whirl_method *method = NULL;
        const int steps = batch->integrate.steps_per_revolution;
        const size_t copies = batch->starts > 1 ? batch->starts : batch->carry == WHIRL_CARRY_BOTH ? 2 : 1;
        const double points = (double)batch->count * (double)copies;
        const double revolutions = (double)batch->record.transient + batch->record.record;
        // Print the parameters and the number of points.
        printf("  %s", batch->name);
        if (batch->parameter[0]) printf(" of %s", batch->parameter);
        if (*batch->second && batch->row > 0) printf("%s%s", batch->plane > 0 ? ", " : " and ", batch->second);
        if (batch->plane > 0) printf(" and %s", batch->third);
        if (batch->tolerances.samples > 0) printf(" at %d samples", batch->tolerances.samples);
        if (batch->refine > 0) printf(", refined from squares of %zu", batch->refine);
        if (batch->fit) {
            const whirl_fit *fit = batch->fit;
            printf(": %zu unknown%s, %zu measured numbers of %zu motion%s, %.0f start%s\n", fit->unknown_count,
                   plural((double)fit->unknown_count), fit->number_count, fit->motion_count,
                   plural((double)fit->motion_count), points, plural(points));
            continue;
        }
        if (!whirl_analysis_kind(batch->analyses)->settles) {
            printf(": %.0f point%s %s\n", points, plural(points), whirl_analysis_kind(batch->analyses)->place);
            continue;
        }
        if (whirl_analysis_kind(batch->analyses)->found) {
            summary_print_limits(batch);
            continue;
        }
        if (batch->starts > 1)
            summary_print_starts(batch, revolutions);
        else
            printf(": %s%.0f point%s, %.0f revolution%s each", batch->refine > 0 ? "at most " : "", points,
                   plural(points), revolutions, plural(revolutions));
        // Print the method.
        if (strcmp(name, "auto") == 0) { // the method is not chosen yet
            printf(" by auto%s\n", batch->confirm ? ", confirmed" : "");
            continue;
        }
        if (whirl_method_find(name, &method).code == WHIRL_OK && method->adaptive) {
            printf(" by %s%s%s\n", name, batch->integrate.chosen ? " (chosen by auto)" : "",
                   batch->confirm ? ", confirmed at a tolerance 16 times smaller" : "");
            continue;
        }
        const double all = points * revolutions * steps * (batch->confirm ? 3 : 1);
        printf(" by %s of %d step%s", name, steps, plural(steps));
        if (batch->confirm) printf(", confirmed with %d", 2 * steps);
        printf(", %.3g step%s in all\n", all, plural(all));
    }
}
