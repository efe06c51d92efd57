#include "fit_rest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "derived.h"
#include "fit_turning.h"

/// Predicts number i of the kept ones at the values of a place.
static double rest_predict(const fit_place *p, const fit_orbit *kept, size_t i) {
    double value = kept->node[i];
    for (size_t u = 0; u < p->of->fit->unknown_count; u++)
        value += (p->values[u] - kept->at[u]) * kept->slopes[u * kept->dimension + i];
    return value;
}

/// Returns true for a mode of the requested direction, if one is requested. A straight mode, such as one of two with
/// equal frequencies, counts as forward and as backward.
static bool rest_whirls(const whirl_fit_motion *motion, double direction) {
    return motion->whirl == 0 || motion->whirl * direction > -1e-6;
}

// ---------------------------------------------------------------- onsets and critical speeds

/// A search for an onset or a critical speed.
typedef struct rest_search {
    const fit_place *place;
    const fit_turning *turning;
    bool onset;
    double near; ///< the result is the nearest to this value; -INFINITY: the first
    bool found;
    whirl_critical best;
} rest_search;

static void rest_take(rest_search *s, const whirl_critical *found, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const bool fits =
            s->onset ? found[i].kind == WHIRL_ONSET
                     : found[i].kind == WHIRL_CRITICAL_SPEED && rest_whirls(s->place->motion, found[i].direction);
        const bool nearer = isfinite(s->near) ? fabs(found[i].value - s->near) < fabs(s->best.value - s->near)
                                              : found[i].value < s->best.value;
        if (!fits || (s->found && !nearer)) continue;
        s->best = found[i];
        s->found = true;
    }
}

/// Searches between two values in intervals of equal ratios or, from 0 or less, of equal lengths. Values without an
/// equilibrium are passed over.
static whirl_status rest_look(rest_search *s, double from, double to, size_t intervals) {
    resting_machine before = {.modes = NULL};
    whirl_critical *found = NULL;
    size_t most = 0, count;
    whirl_status status = whirl_ok();
    for (size_t k = 0; k <= intervals; k++) {
        const double share = (double)k / (double)intervals;
        const double value = from > 0.0 ? from * pow(to / from, share) : from + share * (to - from);
        resting_machine own;
        status = resting_new(&s->turning->study, &s->turning->batch, value, &own);
        if (status.code == WHIRL_NO_MEMORY || status.code == WHIRL_STOPPED) break;
        if (status.code != WHIRL_OK) {
            resting_free(&before);
            continue;
        }
        if (!found) {
            most = 2 * own.modes->count + 2;
            found = calloc(most, sizeof *found);
            if (!found) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for thresholds of a fit");
        }
        if (status.code == WHIRL_OK && before.modes)
            status = critical_locate(&s->turning->study, &s->turning->batch, &before, &own, found, most, &count);
        if (status.code == WHIRL_OK && before.modes) rest_take(s, found, count);
        resting_free(&before);
        before = own;
        if (status.code == WHIRL_NO_MEMORY || status.code == WHIRL_STOPPED) break;
        if (s->found && s->onset && !isfinite(s->near)) break;
    }
    resting_free(&before);
    free(found);
    return status.code == WHIRL_NO_MEMORY || status.code == WHIRL_STOPPED ? status : whirl_ok();
}

static whirl_status rest_threshold(const fit_place *p, const whirl_fit_number *number, const fit_orbit *kept,
                                   fit_orbit *tried, double *model, double *slopes) {
    static const double widths[] = {1e-3, 1e-2, 1e-1};
    enum { INTERVALS = 32 };
    const bool known = kept->dimension > 0;
    fit_turning turning;
    fit_turning_make(&turning, p);
    rest_search s = {.place = p, .turning = &turning, .onset = number->quantity == WHIRL_FIT_ONSET};
    whirl_status status = whirl_ok();
    // Follow the number from where it was. At first take the lowest onset, or the critical speed nearest to the
    // measured one.
    s.near = known ? rest_predict(p, kept, 0) : s.onset ? 0.0 - (double)INFINITY : number->value;
    if (!known) status = rest_look(&s, p->motion->from, p->motion->to, INTERVALS);
    for (size_t i = 0; i < sizeof widths / sizeof *widths && known && !s.found && status.code == WHIRL_OK; i++) {
        const double width = widths[i] * fmax(fabs(s.near), fabs(kept->node[0]));
        status = rest_look(&s, s.near - width, s.near + width, 2);
    }
    if (status.code != WHIRL_OK) return status;
    if (!s.found) return whirl_fail(WHIRL_BAD_INPUT, "there is no %s", s.onset ? "onset" : "critical speed");
    // Derive it by the unknowns.
    varied_parameter unknowns[WHIRL_MAX_UNKNOWNS];
    fit_place_unknowns(p, unknowns);
    turning.speed = s.best.value;
    status = derived_threshold(&turning.study, &turning.batch, &s.best, p->of->fit->unknown_count, unknowns, slopes);
    if (status.code == WHIRL_OK) status = fit_place_note(p, 1, &s.best.value, slopes, tried);
    if (status.code != WHIRL_OK) return status;
    *model = s.best.value;
    tried->speed = s.best.speed;
    return status;
}

// ---------------------------------------------------------------- modes

/// Chooses the mode: the one whose eigenvalue is nearest to the predicted one or, at first, the requested one; SIZE_MAX
/// if there is none.
static size_t rest_choose(const fit_place *p, const whirl_fit_number *number, const fit_orbit *kept,
                          const resting_machine *own) {
    size_t best = SIZE_MAX, count = 0;
    double nearest = INFINITY;
    for (size_t i = 0; i < own->modes->count; i++) {
        const whirl_mode *mode = &own->modes->modes[i];
        const double real = own->machine.clock * mode->real, imaginary = own->machine.clock * mode->imaginary;
        double away;
        if (kept->dimension > 0) {
            away = hypot(real - rest_predict(p, kept, 0), imaginary - rest_predict(p, kept, 1));
        } else {
            if (!rest_whirls(p->motion, mode->direction) || whirl_mode_is_overdamped(mode)) continue;
            count++;
            away = p->motion->mode > 0 ? count != p->motion->mode : fabs(imaginary - number->value);
            if (p->motion->mode > 0 && away > 0.0) continue;
        }
        if (away < nearest) best = i;
        nearest = fmin(nearest, away);
    }
    return best;
}

static whirl_status rest_mode(const fit_place *p, const whirl_fit_number *number, const fit_orbit *kept,
                              fit_orbit *tried, double *model, double *slopes) {
    const size_t count = p->of->fit->unknown_count;
    double by[2 * WHIRL_MAX_UNKNOWNS] = {0.0};
    varied_parameter unknowns[WHIRL_MAX_UNKNOWNS];
    resting_machine own;
    whirl_status status = resting_new(p->of->study, &p->batch, NAN, &own);
    if (status.code != WHIRL_OK) return status;
    const size_t index = own.modes->period > 0.0 ? SIZE_MAX : rest_choose(p, number, kept, &own);
    fit_place_unknowns(p, unknowns);
    if (index == SIZE_MAX)
        status = whirl_fail(WHIRL_BAD_INPUT, "there is no such mode");
    else
        status = derived_mode(p->of->study, &p->batch, &own, index, count, unknowns, by);
    if (status.code == WHIRL_OK) {
        // The damping ratio is -real/|lambda|.
        const whirl_mode *mode = &own.modes->modes[index];
        const double lambda[2] = {own.machine.clock * mode->real, own.machine.clock * mode->imaginary};
        const double size = hypot(lambda[0], lambda[1]);
        const bool damping = number->quantity == WHIRL_FIT_DAMPING;
        *model = damping ? 0.0 - lambda[0] / size : lambda[1];
        for (size_t u = 0; u < count; u++)
            slopes[u] = damping ? lambda[1] * (lambda[0] * by[2 * u + 1] - lambda[1] * by[2 * u]) / (size * size * size)
                                : by[2 * u + 1];
        status = fit_place_note(p, 2, lambda, by, tried);
        if (status.code == WHIRL_OK) tried->speed = own.machine.speed;
    }
    resting_free(&own);
    return status;
}

whirl_status fit_at_rest(const fit_place *p, const whirl_fit_number *number, const fit_orbit *kept, fit_orbit *tried,
                         double *model, double *slopes) {
    const bool mode = number->quantity == WHIRL_FIT_FREQUENCY || number->quantity == WHIRL_FIT_DAMPING;
    const whirl_status status =
        mode ? rest_mode(p, number, kept, tried, model, slopes) : rest_threshold(p, number, kept, tried, model, slopes);
    if (status.code != WHIRL_OK) return status;
    // A number without a derivative would count as one that depends on nothing.
    for (size_t u = 0; u < p->of->fit->unknown_count; u++)
        if (!isfinite(slopes[u]))
            return whirl_fail(WHIRL_BAD_INPUT, "it has no derivative by %s", p->of->fit->unknowns[u].name);
    return status;
}
