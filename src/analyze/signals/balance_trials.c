// Trial weights from a model: the usual tenth of the bearing load, within what readings resolve and what limits allow,
// at the angles at which they reduce the vibration.
#include "balance_trials.h"

#include <math.h>
#include <string.h>

#include "balance_equations.h"

static const double force_share = 0.1, least_change = 0.3, most_change = 1.0, clear = 5.0, gravity = 9.80665;

/// Effect of one unknown (the weight of a plane, or the factor of a weight set) on a row (a probe at a speed).
typedef struct view {
    double complex before, effect;
    double limit, repeatability;
    bool own; ///< true if readings at the row's speed determine the unknown
} view;

static view balance_trials_look(const whirl_balance *of, const whirl_correction *out, size_t r, size_t unknown) {
    const whirl_balance_row *row = &out->rows[r];
    view seen = {.before = balance_number(row->before), .limit = INFINITY};
    seen.own = of->mode_count == 0 || balance_mode_of(of, row->speed) == unknown;
    if (row->model) seen.effect = balance_effect(out, row->model->influence, of->plane_count, unknown);
    for (size_t i = 0; i < of->probe_count; i++)
        if (strcmp(of->probes[i].name, row->probe) == 0)
            seen.limit = of->probes[i].limit, seen.repeatability = of->probes[i].repeatability;
    return seen;
}

/// Returns the direction of a trial weight: that of the single weight which minimizes the vibration.
static double complex direction_of(const whirl_balance *of, const whirl_correction *out, size_t unknown) {
    double complex sum = 0.0;
    for (size_t r = 0; r < out->row_count; r++) {
        const view seen = balance_trials_look(of, out, r, unknown);
        if (seen.own) sum -= out->rows[r].weight * conj(seen.effect) * seen.before;
    }
    return cabs(sum) > 0.0 ? sum / cabs(sum) : 1.0;
}

/// Returns the plane whose bearing limits the force: that of the largest weight.
static size_t plane_of(const whirl_balance *of, const whirl_correction *out, size_t unknown) {
    size_t best = 0;
    if (of->mode_count == 0) return unknown;
    for (size_t p = 1; p < of->plane_count; p++)
        if (cabs(balance_number(out->sets[unknown][p])) > cabs(balance_number(out->sets[unknown][best]))) best = p;
    return best;
}

/// Returns a trial weight, kg m, from the bearing load at the largest speed of the rows, or 0 if it is unknown.
static double by_force(const whirl_balance *of, const whirl_balance_model *model, const whirl_correction *out,
                       size_t unknown, whirl_balance_proposal *own) {
    own->bearing = plane_of(of, out, unknown);
    own->load = model->load[own->bearing];
    if (isnan(own->load) && of->mass > 0.0) own->load = 0.5 * of->mass * gravity;
    for (size_t r = 0; r < out->row_count; r++)
        if (balance_trials_look(of, out, r, unknown).own) own->speed = fmax(own->speed, out->rows[r].speed);
    return own->load > 0.0 && own->speed > 0.0 ? force_share * own->load / (own->speed * own->speed) : 0.0;
}

/// Returns the largest weight in this direction with which a row stays within its limit; infinite if it has no limit.
static double balance_trials_within(const view *seen, double complex way) {
    const double complex effect = seen->effect * way;
    const double b = creal(conj(seen->before) * effect), a = creal(effect * conj(effect));
    const double c = creal(seen->before * conj(seen->before)) - seen->limit * seen->limit;
    if (!(a > 0.0) || isinf(seen->limit)) return INFINITY;
    return c > 0.0 ? 0.0 : (sqrt(b * b - a * c) - b) / a;
}

/// Bounds of a trial weight, kg m: least for a clear change of the readings, most for a change by most_change, and by
/// limits.
typedef struct bounds {
    double least, most, limit;
    size_t least_row, most_row, limit_row;
} bounds;

static bounds find_bounds(const whirl_balance *of, const whirl_correction *out, size_t unknown, double complex way) {
    bounds found = {.least = INFINITY, .most = INFINITY, .limit = INFINITY};
    for (size_t r = 0; r < out->row_count; r++) {
        const view seen = balance_trials_look(of, out, r, unknown);
        const double effect = cabs(seen.effect), limit = balance_trials_within(&seen, way);
        if (limit < found.limit && cabs(seen.before) <= seen.limit) found.limit = limit, found.limit_row = r;
        if (!seen.own || !(effect > 0.0)) continue;
        const double least = fmax(least_change * cabs(seen.before), clear * seen.repeatability) / effect;
        if (least < found.least) found.least = least, found.least_row = r;
        const double most = most_change * cabs(seen.before) / effect;
        if (most > 0.0 && most < found.most) found.most = most, found.most_row = r;
    }
    if (isinf(found.least)) found.least = 0.0;
    return found;
}

/// Returns true if there is a reading at the speed that an unknown is for.
static bool was_read(const whirl_balance *of, const whirl_correction *out, size_t unknown) {
    for (size_t r = 0; r < out->row_count; r++)
        if (balance_trials_look(of, out, r, unknown).own) return true;
    return false;
}

static double balance_trials_choose(double force, const bounds *on, whirl_balance_proposal *own) {
    double size = force;
    own->reason = size > 0.0 ? WHIRL_TRIAL_BY_FORCE : WHIRL_TRIAL_BY_NOTHING;
    own->row = on->most_row;
    if (size > on->most) size = on->most, own->reason = WHIRL_TRIAL_BY_MAX;
    if (size < on->least) size = on->least, own->reason = WHIRL_TRIAL_BY_MIN, own->row = on->least_row;
    if (size > on->limit) size = on->limit, own->reason = WHIRL_TRIAL_BY_LIMIT, own->row = on->limit_row;
    own->unclear = size < on->least * (1.0 - 1e-12);
    return size;
}

static void balance_trials_propose(const whirl_balance *of, const whirl_balance_model *model,
                                   const whirl_correction *out, size_t unknown, whirl_balance_proposal *own) {
    own->over = out->row_count;
    own->reason = WHIRL_TRIAL_BY_NOTHING;
    own->load = own->change = NAN;
    if (!was_read(of, out, unknown)) return;
    // Choose the size by the force on bearings, within the bounds.
    const double complex way = direction_of(of, out, unknown);
    const bounds on = find_bounds(of, out, unknown, way);
    const double size = balance_trials_choose(by_force(of, model, out, unknown, own), &on, own);
    double beyond = 1.0 + 1e-9; // times its limit
    balance_set(own->moment, size * way);
    // Predict the readings, and note the one that is farthest over its limit.
    for (size_t r = 0; r < out->row_count; r++) {
        const view seen = balance_trials_look(of, out, r, unknown);
        const double complex after = seen.before + size * way * seen.effect;
        if (r == own->row) {
            own->change = size * cabs(seen.effect) / cabs(seen.before);
            if (own->over == out->row_count) balance_set(own->predicted, after);
        }
        if (cabs(after) > beyond * seen.limit) {
            beyond = cabs(after) / seen.limit;
            own->over = r;
            balance_set(own->predicted, after);
        }
    }
}

void balance_propose(const whirl_balance *of, const whirl_balance_model *model, whirl_correction *out) {
    out->proposal_count = balance_unknown_count(of);
    for (size_t n = 0; n < out->proposal_count; n++) balance_trials_propose(of, model, out, n, &out->proposals[n]);
}

void whirl_balance_proposed(const whirl_correction *correction, size_t proposal, size_t plane, double moment[2]) {
    const double complex own = balance_number(correction->proposals[proposal].moment);
    if (correction->set_count > 0)
        balance_set(moment, own * balance_number(correction->sets[proposal][plane]));
    else
        balance_set(moment, plane == proposal ? own : 0.0);
}
