#include "attractors.h"

#include <stdlib.h>
#include <string.h>

struct alike {
    const whirl_table *table;
    bool basin;
    int *labels;  ///< [count] regime and period of a point; 0: not read yet
    motion *held; ///< cached motion of point `of`, which is compared with several others; or NULL
    size_t of;
};

enum { IN_DOUBT = -1, PERIODS = 1 << 16 };

alike *alike_new(const whirl_table *table) {
    alike *labels = calloc(1, sizeof *labels);
    if (!labels) return NULL;
    labels->table = table;
    labels->basin = table->role == WHIRL_ROLE_BASIN;
    labels->labels = calloc(table->count + 1, sizeof *labels->labels);
    if (labels->labels) return labels;
    alike_free(labels);
    return NULL;
}

void alike_free(alike *labels) {
    if (!labels) return;
    free(labels->labels);
    free(labels->held);
    free(labels);
}

static int label_of(const alike *labels, size_t point) {
    int *label = &labels->labels[point];
    if (*label != 0) return *label;
    const whirl_verdict verdict = whirl_table_verdict(labels->table, point);
    const bool in_doubt = verdict.regime == WHIRL_UNDETERMINED || verdict.confidence == WHIRL_LOW;
    *label = in_doubt ? IN_DOUBT : 1 + (int)verdict.regime * PERIODS + verdict.period;
    return *label;
}

/// Returns the motion of a point and caches it.
static const motion *alike_hold(alike *labels, size_t point) {
    if (labels->held && labels->of == point) return labels->held;
    free(labels->held);
    labels->held = motion_read(labels->table, point);
    labels->of = point;
    return labels->held;
}

bool alike_are(alike *labels, size_t a, size_t b) {
    const int one = label_of(labels, a), other = label_of(labels, b);
    if (one == IN_DOUBT || one != other) return false;
    if (!labels->basin) return true;
    motion *second = motion_read(labels->table, b);
    const motion *first = second ? alike_hold(labels, a) : NULL;
    const bool same = first && motion_is_same(first, second);
    free(second);
    return same;
}
