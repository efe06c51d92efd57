// Steps shared by beginning a branch of tori and following it.
#include "torus_follower.h"
#include "torus_describe.h"
#include "torus_equations.h"
#include "torus_options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

whirl_status torus_follower_begin(torus_follower *f, const whirl_family *family, size_t revolutions, size_t dimension,
                                  const double *at, double value, const whirl_torus_branch_options *options) {
    *f = (torus_follower){.options = options};
    const curve_way way = {options->from, options->to, options->least_step, options->step, options->most_step};
    whirl_status status = curve_check(&way, value);
    if (status.code == WHIRL_OK) status = torus_check_options(&options->torus);
    if (status.code == WHIRL_OK)
        status = torus_equations_make(&f->equations, NULL, family, value, &options->torus, revolutions, dimension, at);
    if (status.code != WHIRL_OK) return status;
    f->equations.reach = 0x1p-12 * (options->to - options->from);
    f->capacity = options->torus.most_nodes * f->equations.n + 2;
    f->trial = calloc(3 * f->capacity, sizeof *f->trial);
    if (!f->trial) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a branch of tori");
    f->direction = f->trial + f->capacity;
    f->forward = f->direction + f->capacity;
    return status;
}

void torus_follower_end(torus_follower *f) {
    curve_end(&f->curve);
    torus_equations_free(&f->equations);
    free(f->trial);
    f->trial = NULL;
}

whirl_status torus_waypoint_new(const torus_follower *f, torus_waypoint *out) {
    *out = (torus_waypoint){.u = calloc(2 * f->capacity, sizeof(double))};
    if (!out->u) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a branch of tori");
    out->tangent = out->u + f->capacity;
    return whirl_ok();
}

void torus_waypoint_free(torus_waypoint *p) {
    whirl_torus_free(p->torus);
    free(p->u);
    *p = (torus_waypoint){.u = NULL};
}

bool torus_follower_resize(torus_follower *f, size_t count, const double *u) {
    torus_equations *e = &f->equations;
    if (count != e->count || !f->curve.matrix) {
        curve_end(&f->curve);
        if (!torus_equations_resize(e, count)) return false;
        f->curve = (curve){.count = torus_equations_count(e),
                           .context = e,
                           .evaluate = torus_equations_evaluate,
                           .size = torus_equations_size,
                           .tolerance = f->options->torus.tolerance};
        if (!curve_begin(&f->curve)) return false;
    }
    torus_equations_scale(e, u, fabs(f->options->to - f->options->from), f->curve.scale);
    return true;
}

/// Changes to more nodes. The search continues from the curve that was found.
static bool torus_follower_refine(torus_follower *f, size_t wanted, const double *found) {
    const torus_equations *e = &f->equations;
    const size_t before = e->count;
    const bool good = torus_resample(e, before, found, wanted, f->trial) &&
                      torus_resample(e, before, f->direction, wanted, f->direction) &&
                      torus_resample(e, before, f->forward, wanted, f->forward);
    return good && torus_follower_resize(f, wanted, f->trial);
}

whirl_status torus_follower_find(torus_follower *f, torus_waypoint *out) {
    torus_equations *e = &f->equations;
    for (;;) {
        whirl_torus_free(out->torus);
        out->torus = NULL;
        out->rough = false;
        out->count = e->count;
        memcpy(out->u, f->trial, (f->curve.count + 1) * sizeof *out->u);
        const newton_result result = curve_correct(&f->curve, f->direction, out->u);
        out->pace = curve_pace(&result);
        if (!result.found || !curve_tangent(&f->curve, f->forward, f->forward, out->tangent)) return whirl_ok();
        const whirl_status status = torus_describe(e, out->u, result.size, &out->torus);
        if (status.code != WHIRL_OK || torus_is_accurate(e, out->u, out->torus)) return status;
        const size_t wanted = torus_nodes_wanted(e, out->u, out->torus->error);
        out->rough = wanted <= e->count;
        if (out->rough) return status;
        if (!torus_follower_refine(f, wanted, out->u))
            return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu nodes", wanted);
        torus_equations_refer(e, f->trial);
    }
}
