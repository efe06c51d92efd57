#include "fit_special.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "derived.h"
#include "fit_turning.h"

/// Looks at the points of a branch until stability is lost.
typedef struct special_watch {
    whirl_special kind; ///< kind of point that is followed; WHIRL_REGULAR: any at which stability is lost
    bool stable, found;
} special_watch;

static bool special_is_onset(whirl_special kind) {
    return kind == WHIRL_FOLD || kind == WHIRL_DOUBLING || kind == WHIRL_NEIMARK_SACKER;
}

static bool special_look(void *context, const whirl_branch_point *point) {
    special_watch *w = context;
    if (point->special == WHIRL_REGULAR)
        w->stable = whirl_orbit_largest(point->orbit) < 1.0;
    else
        w->found = w->kind == WHIRL_REGULAR ? special_is_onset(point->special) && w->stable : point->special == w->kind;
    return !w->found;
}

static whirl_status special_machine(const void *context, double value, whirl_machine *machine) {
    const fit_turning *t = context;
    return t->study.machine(t->study.family, &t->batch, value, machine);
}

/// Follows the branch from the orbit at one value up to another one. *branch, to be freed, ends with the onset; NULL if
/// there is none.
static whirl_status special_follow(const fit_place *p, const fit_turning *t, whirl_special kind, double from, double to,
                                   const double *node, whirl_branch **branch) {
    enum { MAX_POINTS = 400 };
    whirl_machine machine = {.system = NULL};
    whirl_orbit *orbit = NULL;
    special_watch watch = {.kind = kind};
    *branch = NULL;
    whirl_status status = special_machine(t, from, &machine);
    double *x = status.code == WHIRL_OK ? malloc((machine.system->dimension + 1) * sizeof *x) : NULL;
    if (status.code == WHIRL_OK && !x) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for an onset of a fit");
    if (status.code == WHIRL_OK) {
        const size_t revolutions = (size_t)p->of->batch->record.fit.revolutions;
        memcpy(x, node ? node : machine.start, machine.system->dimension * sizeof *x);
        status = node ? whirl_orbit_find(machine.system, x, revolutions, &p->options, &orbit)
                      : fit_place_begin(p, machine.system, x, &orbit);
    }
    if (status.code == WHIRL_OK) {
        whirl_branch_options options = whirl_branch_default(fmin(from, to), fmax(from, to));
        options.orbit = p->options;
        options.most_points = MAX_POINTS;
        options.found = special_look;
        options.context = &watch;
        const whirl_family family = {special_machine, t};
        status = whirl_branch_follow(&family, orbit, from, to > from ? 1 : -1, &options, branch);
    }
    whirl_orbit_free(orbit);
    if (machine.release) machine.release(machine.owner);
    free(x);
    if (watch.found && status.code == WHIRL_OK) return status;
    whirl_branch_free(*branch);
    *branch = NULL;
    return status;
}

/// Returns the onset at which following a branch ended: its last special point. A regular one may come after it.
static const whirl_branch_point *special_point(const whirl_branch *branch) {
    size_t i = branch->count;
    while (i-- > 1)
        if (special_is_onset(branch->points[i].special)) break;
    return &branch->points[i];
}

/// Notes the onset, a point of a branch, as the one tried.
static whirl_status special_note(const fit_place *p, const whirl_branch_point *point, const double *slopes,
                                 fit_orbit *tried) {
    const whirl_status status = fit_place_note(p, point->orbit->dimension, point->orbit->nodes, NULL, tried);
    if (status.code != WHIRL_OK) return status;
    tried->speed = p->motion->along ? (double)NAN : point->value;
    tried->value = point->value;
    tried->special = point->special;
    memcpy(tried->by, slopes, p->of->fit->unknown_count * sizeof *slopes);
    return status;
}

whirl_status fit_orbit_onset(const fit_place *p, const fit_orbit *kept, fit_orbit *tried, double *model,
                             double *slopes) {
    static const double widths[] = {1e-4, 1e-3, 1e-2};
    const size_t count = p->of->fit->unknown_count;
    const bool known = kept->dimension > 0;
    fit_turning turning;
    whirl_branch *branch = NULL;
    fit_turning_make(&turning, p);
    // Follow the branch through the place at which the onset is expected. Near a fold orbits change with the root of
    // the distance, so that searches begin near it.
    whirl_status status = whirl_ok();
    double near = kept->value;
    for (size_t u = 0; u < count && known; u++) near += (p->values[u] - kept->at[u]) * kept->by[u];
    for (size_t i = 0; i < sizeof widths / sizeof *widths && known && !branch; i++) {
        const double width = widths[i] * fabs(near);
        status = special_follow(p, &turning, kept->special, near - width, near + width, kept->node, &branch);
        if (status.code == WHIRL_NO_MEMORY || status.code == WHIRL_STOPPED) return status;
    }
    // At first, and if the onset is not where it was expected, follow the branch from its beginning.
    if (!branch) status = special_follow(p, &turning, WHIRL_REGULAR, p->motion->from, p->motion->to, NULL, &branch);
    if (!branch && status.code == WHIRL_OK) status = whirl_fail(WHIRL_BAD_INPUT, "there is no onset");
    if (!branch) return status;
    // Derive it by the unknowns.
    const whirl_branch_point *point = special_point(branch);
    varied_parameter unknowns[WHIRL_MAX_UNKNOWNS];
    fit_place_unknowns(p, unknowns);
    turning.speed = point->value;
    status = derived_special_point(&turning.study, &turning.batch, point, &p->options, count, unknowns, slopes);
    for (size_t u = 0; u < count && status.code == WHIRL_OK; u++)
        if (!isfinite(slopes[u]))
            status = whirl_fail(WHIRL_BAD_INPUT, "it has no derivative by %s", p->of->fit->unknowns[u].name);
    if (status.code == WHIRL_OK) status = special_note(p, point, slopes, tried);
    if (status.code == WHIRL_OK) *model = point->value;
    whirl_branch_free(branch);
    return status;
}
