// The registry of kinds of points.
#include "kinds.h"

#include <string.h>

/// Motions are recorded by passes themselves (run/passes.c).
static const study_kind motion_kind = {.name = "motion", .piece = 1};

static const study_kind *const kinds[] = {&motion_kind, &rest_kind, &branch_kind, &torus_kind, &fit_kind};

const study_kind *study_kind_of(const whirl_batch *batch) {
    const char *name = whirl_analysis_kind(batch->analyses)->name;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strcmp(kinds[i]->name, name) == 0) return kinds[i];
    return &motion_kind;
}
