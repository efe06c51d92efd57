// Fits: a point of the table is a fit from one start, with all of its motions computed side by side.
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "deal.h"
#include "fit_motions.h"
#include "fit_profile.h"
#include "kinds.h"
#include "least_squares.h"
#include "pass.h"
#include "run_journal.h"
#include "study_run.h"

/// One fit under way.
typedef struct fit_work {
    study_run *run;
    const pass *pass;
    const whirl_batch *batch;
    whirl_table *table;
    double *residuals, *derivatives; ///< [numbers], [numbers][unknowns]
    fit_motions motions;
    whirl_fit_solution solution;
} fit_work;

/// Sets the start of a point: the first is the case's, the others fill the bounds evenly.
static void fit_start(const whirl_fit *fit, size_t slot, double *values) {
    for (size_t u = 0; u < fit->unknown_count; u++) {
        const whirl_fit_unknown *own = &fit->unknowns[u];
        const bool bounded = isfinite(own->low) && isfinite(own->high);
        values[u] = slot > 0 && bounded ? own->low + (own->high - own->low) * whirl_halton(slot, u) : own->start;
    }
}

static bool fit_goes_on(void *of) {
    fit_work *w = of;
    return tracker_advance(&w->run->tracker, 0.0, 0);
}

/// Returns how well a parameter is determined, from its value, its error and half of its interval.
static whirl_fit_known fit_known(const whirl_fit_unknown *own, double value, double error, double half) {
    if (!isfinite(error)) return WHIRL_FIT_UNKNOWN;
    if (value <= own->low || value >= own->high) return WHIRL_FIT_AT_BOUND;
    return 2.0 * half >= own->high - own->low || half >= fabs(value) ? WHIRL_FIT_WEAK : WHIRL_FIT_DETERMINED;
}

/// Fills in errors, intervals and correlations at the minimum. Unknowns at a bound count as given there.
static whirl_status fit_describe(fit_work *w) {
    const whirl_fit *fit = w->motions.fit;
    const size_t count = fit->unknown_count, numbers = fit->number_count;
    whirl_fit_solution *s = &w->solution;
    size_t kept[WHIRL_MAX_UNKNOWNS], some = 0;
    for (size_t u = 0; u < count; u++)
        if (s->value[u] > fit->unknowns[u].low && s->value[u] < fit->unknowns[u].high) kept[some++] = u;
    // Compute errors and correlations of the unknowns that are not at a bound.
    double errors[WHIRL_MAX_UNKNOWNS], correlations[WHIRL_MAX_UNKNOWNS * WHIRL_MAX_UNKNOWNS];
    least_squares_facts facts = {0, INFINITY};
    double *columns = calloc(numbers * some + 1, sizeof *columns);
    for (size_t i = 0; columns && i < numbers; i++)
        for (size_t k = 0; k < some; k++) columns[i * some + k] = w->derivatives[i * count + kept[k]];
    const bool good =
        columns && (some == 0 || least_squares_describe(some, numbers, columns, errors, correlations, &facts));
    free(columns);
    if (!good) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the errors of a fit");
    s->rank = facts.rank;
    s->condition = facts.condition;
    s->degrees = numbers > some ? numbers - some : 0;
    s->deviation = s->degrees > 0 ? sqrt(s->sum / (double)s->degrees) : NAN;
    // With given noise errors are absolute; without it the deviation of the residuals scales them.
    const bool noise = w->batch->record.fit.noise > 0.0;
    // The scatter of statistics adds to their noise.
    double scatter = 0.0;
    for (size_t i = 0; i < fit->motion_count; i++)
        if (fit->motions[i].statistics) scatter = fmax(scatter, w->motions.kept[i].scatter);
    const double unit = noise ? hypot(1.0, scatter) : s->deviation;
    const double wide = noise ? least_squares_student(SIZE_MAX) : least_squares_student(s->degrees);
    for (size_t u = 0; u < WHIRL_MAX_UNKNOWNS; u++) {
        s->error[u] = s->half[u] = s->profile[u][0] = s->profile[u][1] = NAN;
        s->known[u] = WHIRL_FIT_AT_BOUND;
        for (size_t k = 0; k < WHIRL_MAX_UNKNOWNS; k++) s->correlation[u][k] = NAN;
    }
    for (size_t k = 0; k < some; k++) {
        const size_t u = kept[k];
        const double error = unit * errors[k];
        s->known[u] = fit_known(&fit->unknowns[u], s->value[u], error, wide * error);
        for (size_t j = 0; j < some; j++) s->correlation[u][kept[j]] = correlations[k * some + j];
        if (!isfinite(error)) continue;
        s->error[u] = error;
        s->half[u] = wide * error;
    }
    return whirl_ok();
}

/// Returns the shortest step that matters. Differences do not resolve more than a hundredth of their distance.
static double fit_tolerance(const whirl_fit *fit, const whirl_fit_options *options) {
    bool statistics = false;
    for (size_t i = 0; i < fit->motion_count; i++) statistics = statistics || fit->motions[i].statistics;
    return statistics ? fmax(options->tolerance, 0.01 * options->difference) : options->tolerance;
}

/// Fits from one start.
static whirl_status fit_solve(fit_work *w, size_t slot) {
    static const whirl_fit_end ends[] = {[LEAST_SQUARES_FOUND] = WHIRL_FIT_FOUND,
                                         [LEAST_SQUARES_STEPS] = WHIRL_FIT_STEPS,
                                         [LEAST_SQUARES_STUCK] = WHIRL_FIT_STUCK,
                                         [LEAST_SQUARES_NOWHERE] = WHIRL_FIT_NO_MOTION};
    const whirl_fit *fit = w->motions.fit;
    const whirl_fit_options *options = &w->batch->record.fit;
    double low[WHIRL_MAX_UNKNOWNS], high[WHIRL_MAX_UNKNOWNS], scale[WHIRL_MAX_UNKNOWNS];
    whirl_fit_solution *s = &w->solution;
    fit_start(fit, slot, s->start);
    memcpy(s->value, s->start, sizeof s->value);
    for (size_t u = 0; u < fit->unknown_count; u++) {
        low[u] = fit->unknowns[u].low;
        high[u] = fit->unknowns[u].high;
        scale[u] = isfinite(high[u] - low[u]) ? high[u] - low[u] : fabs(s->start[u]) + (s->start[u] == 0.0);
    }
    const least_squares problem = {.unknowns = fit->unknown_count,
                                   .count = fit->number_count,
                                   .context = &w->motions,
                                   .evaluate = fit_motions_evaluate,
                                   .accept = fit_motions_keep,
                                   .low = low,
                                   .high = high,
                                   .scale = scale,
                                   .tolerance = fit_tolerance(fit, options),
                                   .most_steps = options->most_steps};
    const least_squares_result found = least_squares_solve(&problem, s->value, w->residuals, w->derivatives);
    const whirl_status *status = &w->motions.status;
    if (found.end == LEAST_SQUARES_MEMORY) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
    if (status->code == WHIRL_NO_MEMORY || status->code == WHIRL_STOPPED) return *status;
    s->end = ends[found.end];
    s->steps = found.steps;
    s->sum = found.sum;
    s->lost = w->motions.lost;
    if (found.end == LEAST_SQUARES_NOWHERE) return whirl_ok();
    // The last evaluation may not have been at the minimum.
    if (!fit_motions_evaluate(&w->motions, s->value, w->residuals, w->derivatives))
        return w->motions.status.code == WHIRL_STOPPED ? w->motions.status
                                                       : whirl_fail(WHIRL_NUMERICAL_FAILURE, "a fit lost a motion");
    fit_motions_keep(&w->motions);
    const whirl_status described = fit_describe(w);
    if (described.code != WHIRL_OK || !options->profile) return described;
    // The sum rises by the square of the linear interval's half-width in standard errors.
    const double wide = least_squares_student(options->noise > 0.0 ? SIZE_MAX : s->degrees);
    const double unit = options->noise > 0.0 ? 1.0 : s->deviation;
    return fit_profile(&w->motions, &problem, wide * wide * unit * unit, s);
}

/// Hands the solution to the analysis, which fills the block.
static whirl_status fit_write(const fit_work *w, double *block) {
    const whirl_fit *fit = w->motions.fit;
    double *motions = calloc(4 * fit->motion_count + 1, sizeof *motions);
    if (!motions) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the motions of a fit");
    whirl_fit_solution solution = w->solution;
    solution.model = w->motions.model;
    solution.largest = motions;
    solution.speeds = motions + fit->motion_count;
    solution.scatter = motions + 2 * fit->motion_count;
    solution.times = motions + 3 * fit->motion_count;
    for (size_t i = 0; i < fit->motion_count; i++) {
        const fit_orbit *orbit = &w->motions.kept[i];
        solution.largest[i] = orbit->node ? orbit->largest : NAN;
        solution.speeds[i] = orbit->node ? orbit->speed : NAN;
        solution.scatter[i] = orbit->node && fit->motions[i].statistics ? orbit->scatter : NAN;
        solution.times[i] = fit->motions[i].run ? orbit->time : NAN;
    }
    const whirl_resting point = {.fit = fit, .solution = &solution};
    whirl_analysis_set own = 0;
    whirl_analysis_add(&own, "fit");
    const whirl_status status = whirl_analyze_resting(&point, &w->pass->record, own, &w->table->layout, block);
    free(motions);
    return status;
}

/// Fits from the start of one slot, unless the journal has it.
static whirl_status fit_point(study_run *run, const pass *p, size_t slot) {
    // Make memory for the block, residuals and motions.
    const whirl_batch *batch = &run->study->batches[p->batch];
    const whirl_fit *fit = batch->fit;
    whirl_table *table = &run->result->tables[p->batch];
    fit_work w = {.run = run, .pass = p, .batch = batch, .table = table};
    double *own = table->blocks ? NULL : calloc(table->layout.size + 1, sizeof *own);
    double *block = table->blocks ? table->blocks + slot * table->layout.size : own;
    w.residuals = calloc(fit->number_count * (1 + fit->unknown_count) + 1, sizeof *w.residuals);
    w.derivatives = w.residuals + fit->number_count;
    w.motions = (fit_motions){
        .study = run->study, .batch = batch, .fit = fit, .threads = run->threads, .goes_on = fit_goes_on, .of = &w};
    whirl_status status = fit_motions_make(&w.motions);
    if (!block || !w.residuals) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
    // Take the block from the journal, or fit and write it there.
    const journal_entry entry = {.batch = p->batch, .slot = slot, .block = block, .size = table->layout.size};
    if (status.code == WHIRL_OK && run_journal_read(run->journal, &entry)) {
        table->done[slot] = 1;
        tracker_recall(&run->tracker, pass_revolutions(run, p), 1);
    } else if (status.code == WHIRL_OK && !run->gathering) {
        status = fit_solve(&w, slot);
        if (status.code == WHIRL_OK) status = fit_write(&w, block);
        if (status.code == WHIRL_OK) status = run_journal_write(run->journal, &entry);
        if (status.code == WHIRL_OK) status = run_journal_sync(run->journal);
        if (status.code == WHIRL_OK) {
            table->done[slot] = 1;
            tracker_advance(&run->tracker, pass_revolutions(run, p), 1);
        }
    }
    fit_motions_free(&w.motions);
    free(w.residuals);
    free(own);
    return status;
}

static whirl_status fit_work_points(study_run *run, const pass *p) {
    deal pieces = deal_begin(run, p, p->count);
    size_t piece;
    while (!atomic_load(&run->tracker.halt) && deal_take(&pieces, &piece)) {
        const whirl_status status = fit_point(run, p, p->slots ? p->slots[piece] : piece);
        if (status.code != WHIRL_OK && status.code != WHIRL_STOPPED) {
            tracker_fail(&run->tracker, &status);
            break;
        }
    }
    return whirl_ok();
}

const study_kind fit_kind = {.name = "fit", .piece = 1, .work = fit_work_points};
