// Influence coefficients by complex least squares, and corrections by least squares or by the least largest vibration.
#include "whirl/internal/balance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "balance_equations.h"
#include "balance_limits.h"
#include "balance_sets.h"
#include "balance_trials.h"
#include "two_pi.h"

// ---------------------------------------------------------------- rows

static bool is_row(const whirl_balance_row *row, const whirl_balance_vibration *seen) {
    return row->speed == seen->speed && strcmp(row->probe, seen->probe) == 0;
}

static const whirl_modelled_row *balance_modelled(const whirl_balance_model *model,
                                                  const whirl_balance_vibration *seen) {
    for (size_t i = 0; model && i < model->row_count; i++)
        if (model->rows[i].speed == seen->speed && strcmp(model->rows[i].probe, seen->probe) == 0)
            return &model->rows[i];
    return NULL;
}

static void find_rows(const whirl_balance *of, const whirl_balance_model *model, whirl_correction *out) {
    for (size_t i = 0; i < of->vibration_count; i++) {
        const whirl_balance_vibration *seen = &of->vibrations[i];
        size_t r = 0;
        while (r < out->row_count && !is_row(&out->rows[r], seen)) r++;
        if (r == out->row_count)
            out->rows[out->row_count++] = (whirl_balance_row){.speed = seen->speed,
                                                              .probe = seen->probe,
                                                              .weight = seen->weight,
                                                              .model = balance_modelled(model, seen),
                                                              .worst = NAN};
    }
}

// ---------------------------------------------------------------- influence

/// Lists the planes, or sets, that had trial weights; returns how many.
static size_t find_tried(const whirl_balance *of, bool by_set, size_t index[WHIRL_MAX_PLANES]) {
    size_t count = 0;
    for (size_t n = 0; n < (by_set ? of->mode_count : of->plane_count); n++) {
        bool tried = !by_set;
        for (size_t t = 0; t < of->trial_count && !tried; t++) tried = of->trials[t].mode == n;
        if (tried) index[count++] = n;
    }
    return count;
}

/// Fits the coefficients to the readings of runs, for the planes or sets at index [count].
static whirl_status balance_fit(const whirl_balance *of, whirl_balance_row *row, bool by_set, const size_t *index,
                                size_t count) {
    const double rpm = two_pi / 60.0;
    balance_normal equations = {.n = count + 1};
    size_t runs = 0;
    // Add each run of this probe and speed to the normal equations.
    for (size_t i = 0; i < of->vibration_count; i++) {
        double complex a[BALANCE_UNKNOWNS] = {1.0};
        if (!is_row(row, &of->vibrations[i])) continue;
        for (size_t t = 0; t < of->trial_count; t++)
            for (size_t n = 0; n < count && of->trials[t].run == of->vibrations[i].run; n++)
                if ((by_set ? of->trials[t].mode : of->trials[t].plane) == index[n])
                    a[1 + n] += balance_number(of->trials[t].moment);
        balance_add(&equations, a, balance_number(of->vibrations[i].vibration), 1.0);
        runs++;
    }
    // Solve: each unknown needs a run of its own.
    if (runs < count + 1 || !balance_unknowns(&equations))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "probe '%.63s' at %.6g rpm was read in %zu run%s that do not distinguish %zu %s%s, expected "
                          "one without and one more for every %s",
                          row->probe, row->speed / rpm, runs, runs == 1 ? "" : "s", count, by_set ? "set" : "plane",
                          count == 1 ? "" : "s", by_set ? "set" : "plane");
    balance_set(row->before, equations.side[0]);
    for (size_t n = 0; n < count; n++) balance_set(row->influence[index[n]], equations.side[1 + n]);
    return whirl_ok();
}

/// Takes the coefficients of a row from the file.
static whirl_status take_given(const whirl_balance *of, whirl_balance_row *row) {
    for (size_t p = 0; p < of->plane_count; p++) {
        size_t i = 0;
        while (i < of->coefficient_count &&
               !(of->coefficients[i].plane == p && of->coefficients[i].speed == row->speed &&
                 strcmp(of->coefficients[i].probe, row->probe) == 0))
            i++;
        if (i == of->coefficient_count)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "coefficients have none of plane '%.63s' for probe '%.63s' at %.6g rpm, expected one for "
                              "every plane, probe and speed of vibration",
                              of->planes[p].name, row->probe, row->speed * 60.0 / two_pi);
        memcpy(row->influence[p], of->coefficients[i].influence, sizeof row->influence[p]);
    }
    return whirl_ok();
}

/// Returns true if coefficients are known without trials.
static bool are_known(const whirl_balance *of) {
    return of->by_model || of->coefficient_count > 0;
}

/// Takes the vibration without any run's weights: the mean of all readings of a row, less the weights' effect by the
/// coefficients of the file or the model.
static void take_known(const whirl_balance *of, const whirl_correction *out, whirl_balance_row *row) {
    double complex sum = 0.0;
    double runs = 0.0;
    if (row->model && of->coefficient_count == 0) memcpy(row->influence, row->model->influence, sizeof row->influence);
    for (size_t i = 0; i < of->vibration_count; i++) {
        if (!is_row(row, &of->vibrations[i])) continue;
        sum += balance_number(of->vibrations[i].vibration);
        runs += 1.0;
        for (size_t t = 0; t < of->trial_count; t++) {
            const whirl_balance_trial *trial = &of->trials[t];
            if (trial->run != of->vibrations[i].run) continue;
            const double complex effect =
                trial->plane == WHIRL_BALANCE_SET
                    ? balance_effect(out, (const double(*)[2])row->influence, of->plane_count, trial->mode)
                    : balance_number(row->influence[trial->plane]);
            sum -= effect * balance_number(trial->moment);
        }
    }
    balance_set(row->before, sum / runs);
}

static whirl_status find_influence(const whirl_balance *of, whirl_correction *out) {
    size_t index[WHIRL_MAX_PLANES];
    whirl_status status = whirl_ok();
    const size_t count = find_tried(of, out->by_set, index);
    for (size_t r = 0; r < out->row_count && status.code == WHIRL_OK; r++) {
        if (of->coefficient_count > 0) status = take_given(of, &out->rows[r]);
        if (are_known(of) || of->trial_count == 0)
            take_known(of, out, &out->rows[r]);
        else
            status = balance_fit(of, &out->rows[r], out->by_set, index, count);
    }
    return status;
}

// ---------------------------------------------------------------- correction

/// Returns the effect of a kg m of an unknown on a row.
static double complex effect_of(const whirl_balance *of, const whirl_correction *out, const whirl_balance_row *row,
                                size_t unknown) {
    return out->by_set ? balance_number(row->influence[unknown])
                       : balance_effect(out, row->influence, of->plane_count, unknown);
}

/// Lists the unknowns of the correction: all planes, or those modes that had trials or readings near their speeds.
static size_t find_used(const whirl_balance *of, const whirl_correction *out, size_t index[WHIRL_MAX_PLANES]) {
    size_t count = 0;
    if (out->by_set) return find_tried(of, true, index);
    for (size_t n = 0; n < balance_unknown_count(of); n++) {
        bool used = of->mode_count == 0;
        for (size_t r = 0; r < out->row_count && !used; r++) used = balance_mode_of(of, out->rows[r].speed) == n;
        if (used) index[count++] = n;
    }
    return count;
}

/// Returns |vibration| of a row after the correction, computed with other influence coefficients.
static double after_with(const whirl_balance *of, const whirl_correction *out, const whirl_balance_row *row,
                         const double (*influence)[2]) {
    double complex sum = balance_number(row->before);
    for (size_t p = 0; p < of->plane_count; p++) sum += balance_number(influence[p]) * balance_number(out->moment[p]);
    return cabs(sum);
}

static void balance_predict(const whirl_balance *of, whirl_correction *out, const size_t *index, size_t count) {
    for (size_t r = 0; r < out->row_count; r++) {
        whirl_balance_row *row = &out->rows[r];
        double complex after = balance_number(row->before);
        for (size_t n = 0; n < count; n++)
            after += effect_of(of, out, row, index[n]) *
                     balance_number(of->mode_count > 0 ? out->amount[index[n]] : out->moment[index[n]]);
        balance_set(row->after, after);
        if (of->by_model && row->model)
            row->worst = fmax(cabs(after), fmax(after_with(of, out, row, row->model->shifted[0]),
                                                after_with(of, out, row, row->model->shifted[1])));
    }
}

/// Returns the kg m in a plane per kg m of an unknown.
static double complex share_of(const whirl_balance *of, const whirl_correction *out, size_t unknown, size_t plane) {
    return of->mode_count > 0 ? balance_number(out->sets[unknown][plane]) : (double)(unknown == plane);
}

/// Adds the unknowns' weights in the planes.
static void balance_place(const whirl_balance *of, const whirl_correction *found, const double complex *amounts,
                          const size_t *index, size_t count, double (*moment)[2]) {
    for (size_t n = 0; n < count; n++)
        for (size_t p = 0; p < of->plane_count; p++) {
            const double complex share = share_of(of, found, index[n], p);
            if (share != 0.0) balance_set(moment[p], balance_number(moment[p]) + share * amounts[n]);
        }
}

/// Makes the normal equations of the unknowns at index.
static balance_normal equations_of(const whirl_balance *of, const whirl_correction *out, const size_t *index,
                                   size_t count) {
    balance_normal equations = {.n = count};
    for (size_t r = 0; r < out->row_count; r++) {
        const whirl_balance_row *row = &out->rows[r];
        double complex a[BALANCE_UNKNOWNS];
        for (size_t n = 0; n < count; n++) a[n] = effect_of(of, out, row, index[n]);
        balance_add(&equations, a, -balance_number(row->before), row->weight);
    }
    return equations;
}

/// Returns true if amounts take the weight in a plane beyond its limit.
static bool are_beyond(const whirl_balance *of, const whirl_correction *out, const size_t *index, size_t count,
                       const double complex *amounts) {
    for (size_t p = 0; p < of->plane_count; p++) {
        double complex moment = 0.0;
        for (size_t n = 0; n < count; n++) moment += share_of(of, out, index[n], p) * amounts[n];
        if (cabs(moment) > of->planes[p].limit) return true;
    }
    return false;
}

/// Finds the weights of the unknowns at index by an interior-point method.
static whirl_status find_within(const whirl_balance *of, const whirl_correction *out, const size_t *index, size_t count,
                                double complex *amounts) {
    // Allocate one block, and divide it.
    double limits[WHIRL_MAX_PLANES];
    const size_t lines = out->row_count + of->plane_count;
    double complex *block = calloc(lines * count + out->row_count + 1, sizeof *block);
    if (!block) return whirl_fail(WHIRL_NO_MEMORY, "no memory to balance a rotor");
    double complex *share = block + out->row_count * count, *before = block + lines * count;
    balance_goal goal = {
        .n = count, .effect = block, .before = before, .share = share, .limits = limits, .least_max = of->least_max};
    // Write the vibrations that are to become small, each times the root of its weight.
    for (size_t r = 0; r < out->row_count; r++) {
        const double root = sqrt(out->rows[r].weight);
        if (root == 0.0) continue;
        before[goal.rows] = root * balance_number(out->rows[r].before);
        for (size_t n = 0; n < count; n++)
            block[goal.rows * count + n] = root * effect_of(of, out, &out->rows[r], index[n]);
        goal.rows++;
    }
    // Write the planes that have a limit.
    for (size_t p = 0; p < of->plane_count; p++) {
        if (!isfinite(of->planes[p].limit)) continue;
        for (size_t n = 0; n < count; n++) share[goal.planes * count + n] = share_of(of, out, index[n], p);
        limits[goal.planes++] = of->planes[p].limit;
    }
    const bool found = balance_best_within(&goal, amounts);
    free(block);
    return found ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory to balance a rotor");
}

/// Finds the best weights of the unknowns at index, within the limits of planes: amounts [count].
/// *determined is false if the rows do not determine them; amounts are then not set. WHIRL_NO_MEMORY.
static whirl_status best_weights(const whirl_balance *of, const whirl_correction *out, const size_t *index,
                                 size_t count, double complex *amounts, bool *determined) {
    const balance_normal equations = equations_of(of, out, index, count);
    balance_normal solved = equations;
    double limits[BALANCE_UNKNOWNS];
    *determined = balance_unknowns(&solved);
    if (!*determined) return whirl_ok();
    memcpy(amounts, solved.side, count * sizeof *amounts);
    if (of->least_max || (of->mode_count > 0 && are_beyond(of, out, index, count, amounts)))
        return find_within(of, out, index, count, amounts);
    if (of->mode_count > 0) return whirl_ok();
    for (size_t n = 0; n < count; n++) limits[n] = of->planes[index[n]].limit;
    balance_within(&equations, limits, amounts);
    return whirl_ok();
}

/// Returns the vibration that remains with these weights: the root of the weighted mean square, or the largest
/// vibration if that is minimized.
static double left_with(const whirl_balance *of, const whirl_correction *out, const double complex *amounts,
                        const size_t *index, size_t count) {
    double sum = 0.0, weights = 0.0, largest = 0.0;
    for (size_t r = 0; r < out->row_count; r++) {
        const whirl_balance_row *row = &out->rows[r];
        double complex after = balance_number(row->before);
        for (size_t n = 0; n < count; n++) after += effect_of(of, out, row, index[n]) * amounts[n];
        sum += row->weight * creal(after * conj(after));
        weights += row->weight;
        if (row->weight > 0.0) largest = fmax(largest, cabs(after));
    }
    return of->least_max ? largest : sqrt(sum / weights);
}

/// Reports the significance of the unknowns. Tries the correction without each one that is hardly significant, and
/// keeps the trial that leaves the least vibration.
static whirl_status balance_reduce(const whirl_balance *of, whirl_correction *out, const size_t *index, size_t count) {
    double significance[BALANCE_UNKNOWNS];
    whirl_status status = whirl_ok();
    const balance_normal equations = equations_of(of, out, index, count);
    out->condition = balance_condition(&equations, significance);
    for (size_t n = 0; n < count; n++) out->significance[index[n]] = significance[n];
    for (size_t n = 0; n < count && count > 1 && status.code == WHIRL_OK; n++) {
        size_t others[WHIRL_MAX_PLANES], left = 0;
        double complex amounts[BALANCE_UNKNOWNS];
        bool determined;
        if (!(significance[n] < WHIRL_BALANCE_SIGNIFICANT)) continue;
        for (size_t k = 0; k < count; k++)
            if (k != n) others[left++] = index[k];
        status = best_weights(of, out, others, left, amounts, &determined);
        if (status.code != WHIRL_OK || !determined) continue;
        const double remains = left_with(of, out, amounts, others, left);
        if (out->reduced.there && remains >= out->reduced.left) continue;
        out->reduced = (whirl_balance_reduced){.there = true, .without = index[n], .left = remains};
        balance_place(of, out, amounts, others, left, out->reduced.moment);
    }
    return status;
}

static whirl_status balance_correct(const whirl_balance *of, whirl_correction *out) {
    size_t index[WHIRL_MAX_PLANES] = {0};
    double complex amounts[BALANCE_UNKNOWNS];
    bool determined;
    // Find the weights that leave the least vibration.
    const size_t count = find_used(of, out, index);
    const whirl_status status = best_weights(of, out, index, count, amounts, &determined);
    if (status.code != WHIRL_OK) return status;
    if (!determined)
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "%zu probe%s at a speed do not distinguish the weights of %zu %s%s, expected as many as %ss at least, with "
            "weights above 0, which each %s moves in a way of its own",
            out->row_count, out->row_count == 1 ? "" : "s", count, of->mode_count ? "set" : "plane",
            count == 1 ? "" : "s", of->mode_count ? "set" : "plane", of->mode_count ? "set" : "plane");
    // Distribute them over planes, predict the readings, and try the correction without each plane.
    for (size_t n = 0; n < count && of->mode_count > 0; n++) {
        out->used[index[n]] = true;
        balance_set(out->amount[index[n]], amounts[n]);
    }
    balance_place(of, out, amounts, index, count, out->moment);
    balance_predict(of, out, index, count);
    out->left = left_with(of, out, amounts, index, count);
    out->found = true;
    return balance_reduce(of, out, index, count);
}

static whirl_status balance_solve(const whirl_balance *of, const whirl_balance_model *model, whirl_correction *out) {
    whirl_status status = whirl_ok();
    if (of->by_model && !model)
        return whirl_fail(WHIRL_BAD_INPUT, "influence is to be the model's, and there is no model");
    find_rows(of, model, out);
    out->by_set = !are_known(of) && of->trial_count > 0 && of->trials[0].plane == WHIRL_BALANCE_SET;
    if (of->mode_count > 0) status = balance_find_sets(of, model, out);
    if (status.code == WHIRL_OK) status = find_influence(of, out);
    if (status.code == WHIRL_OK && (of->trial_count > 0 || are_known(of))) status = balance_correct(of, out);
    if (status.code == WHIRL_OK && !out->found && model) balance_propose(of, model, out);
    return status;
}

whirl_status whirl_balance_solve(const whirl_balance *balance, const whirl_balance_model *model,
                                 whirl_correction **correction) {
    whirl_correction *out = calloc(1, sizeof *out);
    *correction = NULL;
    if (out) out->rows = calloc(balance->vibration_count + 1, sizeof *out->rows);
    for (size_t n = 0; out && n < WHIRL_MAX_PLANES; n++) out->significance[n] = NAN;
    const whirl_status status = out && out->rows ? balance_solve(balance, model, out)
                                                 : whirl_fail(WHIRL_NO_MEMORY, "no memory to balance a rotor");
    if (status.code == WHIRL_OK)
        *correction = out;
    else
        whirl_correction_free(out);
    return status;
}

void whirl_correction_free(whirl_correction *correction) {
    if (correction) free(correction->rows);
    free(correction);
}

// ---------------------------------------------------------------- what else is said

double whirl_balance_difference(const whirl_balance *balance, const whirl_correction *correction) {
    double largest = 0.0, difference = 0.0;
    bool modelled = false;
    if (balance->by_model || (balance->trial_count == 0 && balance->coefficient_count == 0)) return NAN;
    for (size_t r = 0; r < correction->row_count; r++) {
        const whirl_balance_row *row = &correction->rows[r];
        const size_t count = correction->by_set ? balance->mode_count : balance->plane_count;
        for (size_t n = 0; row->model && n < count; n++) {
            if (correction->by_set && !correction->used[n]) continue;
            const double complex own = balance_number(row->influence[n]),
                                 other = correction->by_set ? balance_effect(correction, row->model->influence,
                                                                             balance->plane_count, n)
                                                            : balance_number(row->model->influence[n]);
            modelled = true;
            largest = fmax(largest, cabs(own));
            difference = fmax(difference, cabs(own - other));
        }
    }
    return modelled ? difference / largest : (double)NAN;
}

void whirl_balance_split(const whirl_balance *balance, size_t plane, const double moment[2], int hole[2],
                         double moments[2]) {
    const whirl_balance_plane *own = &balance->planes[plane];
    const double way = balance->against ? -1.0 : 1.0, step = two_pi / own->holes, size = hypot(moment[0], moment[1]);
    double place = way * (atan2(moment[1], moment[0]) - own->first_hole) / step;
    place -= own->holes * floor(place / own->holes);
    const double near = floor(place + 0.5), beyond = floor(place);
    const bool at_hole = fabs(place - near) < 1e-6 || own->holes < 3;
    hole[0] = 1 + (int)(at_hole ? near : beyond) % own->holes;
    hole[1] = 1 + hole[0] % own->holes;
    const double angle = (place - beyond) * step;
    moments[0] = at_hole ? size : size * sin(step - angle) / sin(step);
    moments[1] = at_hole ? 0.0 : size * sin(angle) / sin(step);
}

double whirl_balance_allowed(const whirl_balance *balance) {
    if (!(balance->mass > 0.0 && balance->grade > 0.0 && balance->service_speed > 0.0)) return NAN;
    return 1e-3 * balance->grade * balance->mass / balance->service_speed;
}
