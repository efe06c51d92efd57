// Sets of weights that excite one mode alone (Bishop, Gladwell 1959; Kellenberger 1972; as trial sets of the unified
// approach: Darlow, Smalley, Parkinson 1981).
#include "balance_sets.h"

#include <math.h>

#include "balance_equations.h"

/// Excitation of the modes by weights in the planes and, if these are kept, resultant and couple.
typedef struct conditions {
    size_t count, planes;
    double complex row[WHIRL_MAX_PLANES][WHIRL_MAX_PLANES]; ///< [count][planes]
} conditions;

static whirl_status add_modes(const whirl_balance *of, const whirl_balance_model *model, conditions *out) {
    for (size_t n = 0; n < of->mode_count; n++) {
        if (!of->modes[n].shaped && !model)
            return whirl_fail(WHIRL_BAD_INPUT, "mode %zu has no shape, and there is no model to compute it", n + 1);
        for (size_t p = 0; p < of->plane_count; p++)
            out->row[n][p] = of->modes[n].shaped ? of->modes[n].shape[p] : balance_number(model->shape[n][p]);
    }
    out->count = of->mode_count;
    return whirl_ok();
}

static whirl_status add_rigid(const whirl_balance *of, const whirl_balance_model *model, conditions *out) {
    double mean = 0.0, place[WHIRL_MAX_PLANES];
    for (size_t p = 0; p < of->plane_count; p++) {
        place[p] = isnan(of->planes[p].position) && model ? model->position[p] : of->planes[p].position;
        mean += place[p] / (double)of->plane_count;
        if (isnan(place[p]))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "plane '%.63s' has no position, by which sets without a couple are found",
                              of->planes[p].name);
    }
    for (size_t p = 0; p < of->plane_count; p++) {
        out->row[out->count][p] = 1.0;
        out->row[out->count + 1][p] = place[p] - mean;
    }
    out->count += 2;
    return whirl_ok();
}

/// Finds the shortest weights that excite mode n and give 0 for all other conditions; the largest is 1. False without a
/// solution.
static bool find_set(const conditions *on, size_t n, double (*weights)[2]) {
    balance_normal equations = {.n = on->count};
    double complex largest = 0.0, own[WHIRL_MAX_PLANES];
    for (size_t p = 0; p < on->planes; p++) {
        double complex column[BALANCE_UNKNOWNS];
        for (size_t i = 0; i < on->count; i++) column[i] = conj(on->row[i][p]);
        balance_add(&equations, column, 0.0, 1.0);
    }
    equations.side[n] = 1.0;
    if (!balance_unknowns(&equations)) return false;
    for (size_t p = 0; p < on->planes; p++) {
        own[p] = 0.0;
        for (size_t i = 0; i < on->count; i++) own[p] += conj(on->row[i][p]) * equations.side[i];
        if (cabs(own[p]) > cabs(largest) * (1.0 + 1e-9)) largest = own[p];
    }
    for (size_t p = 0; p < on->planes; p++) balance_set(weights[p], own[p] / largest);
    return true;
}

whirl_status balance_find_sets(const whirl_balance *of, const whirl_balance_model *model, whirl_correction *out) {
    const size_t needed = of->mode_count + (of->keep_rigid ? 2 : 0);
    conditions on = {.planes = of->plane_count};
    if (of->plane_count < needed)
        return whirl_fail(WHIRL_BAD_INPUT, "there are %zu plane%s, expected %zu for %zu mode%s%s", of->plane_count,
                          of->plane_count == 1 ? "" : "s", needed, of->mode_count, of->mode_count == 1 ? "" : "s",
                          of->keep_rigid ? " and the rigid rotor, which is to be kept" : "");
    whirl_status status = add_modes(of, model, &on);
    if (status.code == WHIRL_OK && of->keep_rigid) status = add_rigid(of, model, &on);
    for (size_t n = 0; n < of->mode_count && status.code == WHIRL_OK; n++)
        if (!find_set(&on, n, out->sets[n]))
            status = whirl_fail(WHIRL_BAD_INPUT,
                                "the planes do not distinguish the %zu mode%s%s: in them two shapes are alike, or one "
                                "moves none",
                                of->mode_count, of->mode_count == 1 ? "" : "s",
                                of->keep_rigid ? " and the rigid rotor" : "");
    out->set_count = of->mode_count;
    return status;
}
