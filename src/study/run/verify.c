// Verification: computes the points of a study by two methods at three tolerances each, and compares them.
#include "whirl/internal/verify.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// From level to level, tolerances shrink by the first ratio and steps by the second (RK4's error, of order 4, by the
/// third).
static const double tolerance_ratio = 10.0, step_ratio = 2.0, step_error_ratio = 16.0;

/// State differences from which an order can be estimated: smaller ones are rounding, larger ones another motion.
static const double least_difference = 1e-13, largest_difference = 0.1;

// ---------------------------------------------------------------- methods

static whirl_status second_method(const char *own, const char *wanted, char name[WHIRL_NAME_SIZE]) {
    const whirl_method *method = NULL;
    if (!*wanted) {
        for (size_t i = 0; (method = whirl_method_at(i)) != NULL; i++)
            if (method->adaptive && strcmp(method->name, own) != 0 && strcmp(method->name, "auto") != 0) break;
        if (!method) return whirl_fail(WHIRL_BAD_INPUT, "there is no second method to verify %s with", own);
    } else {
        const whirl_status status = whirl_method_find(wanted, &method);
        if (status.code != WHIRL_OK) return status;
        if (!method->adaptive || strcmp(method->name, own) == 0 || strcmp(method->name, "auto") == 0)
            return whirl_fail(WHIRL_BAD_INPUT, "%s can not verify %s, expected another method with a tolerance", wanted,
                              own);
    }
    snprintf(name, WHIRL_NAME_SIZE, "%s", method->name);
    return whirl_ok();
}

static void set_levels(whirl_integrate_options levels[WHIRL_VERIFY_LEVELS]) {
    const double factor = whirl_method_is_adaptive(levels[0].method) ? tolerance_ratio : step_error_ratio;
    for (int i = 1; i < WHIRL_VERIFY_LEVELS; i++) levels[i] = whirl_integrate_tighter(&levels[i - 1], factor);
}

// ---------------------------------------------------------------- verdicts

/// Computes the points by one method, with a batch for each level.
static whirl_status run_levels(const whirl_study *study, const whirl_integrate_options levels[WHIRL_VERIFY_LEVELS],
                               const whirl_run_options *run, whirl_result **result) {
    whirl_study all = {.batch_count = WHIRL_VERIFY_LEVELS, .machine = study->machine, .family = study->family};
    for (size_t i = 0; i < WHIRL_VERIFY_LEVELS; i++) {
        whirl_batch *batch = &all.batches[i];
        *batch = study->batches[0];
        batch->carry = WHIRL_CARRY_NONE;
        batch->starts = batch->neighbours = 0; // the first start of every point
        batch->confirm = false;
        batch->integrate = levels[i];
        batch->record.waveform = batch->record.spectra = false;
        batch->record.waveform_revolutions = 0;
        batch->record.growth = WHIRL_GROWTH_LARGEST;
        batch->analyses = 0;
        whirl_analysis_add(&batch->analyses, "poincare");
        whirl_analysis_add(&batch->analyses, "regime");
    }
    const whirl_status status = whirl_study_run(&all, run, result);
    if (status.code == WHIRL_STOPPED) {
        whirl_result_free(*result);
        *result = NULL;
    }
    return status;
}

/// Returns the last `period` rows of a station's section.
static const double *last_rows(const whirl_table *table, size_t point, size_t station, int period) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_POINCARE_SECTION);
    const double *rows = whirl_table_field(table, point, WHIRL_FIELD_POINCARE_SECTION, station);
    if (!rows || field->rows < (size_t)period) return NULL;
    return rows + (field->rows - (size_t)period) * field->columns;
}

/// Returns the largest difference of a coordinate between row i of one section and row k of another.
static double row_distance(const whirl_table *a, const whirl_table *b, size_t point, int period, int i, int k) {
    const whirl_field *field = whirl_layout_field(&a->layout, WHIRL_FIELD_POINCARE_SECTION);
    double largest = 0.0;
    for (size_t station = 0; station < field->repeat; station++) {
        const double *one = last_rows(a, point, station, period), *other = last_rows(b, point, station, period);
        if (!one || !other) return (double)NAN;
        for (size_t c = 0; c < field->columns; c++)
            largest = fmax(largest, fabs(one[(size_t)i * field->columns + c] - other[(size_t)k * field->columns + c]));
    }
    return largest;
}

static double section_distance(const whirl_table *a, const whirl_table *b, size_t point, int period) {
    double largest = 0.0;
    if (!whirl_layout_field(&a->layout, WHIRL_FIELD_POINCARE_SECTION)) return (double)NAN;
    for (int i = 0; i < period; i++) {
        double nearest = (double)INFINITY;
        for (int k = 0; k < period; k++) nearest = fmin(nearest, row_distance(a, b, point, period, i, k));
        largest = fmax(largest, nearest);
    }
    return isfinite(largest) ? largest : (double)NAN;
}

static void take_verdicts(whirl_verification *v, whirl_result *const results[WHIRL_VERIFY_METHODS]) {
    const whirl_table *reference = &results[WHIRL_VERIFY_METHODS - 1]->tables[WHIRL_VERIFY_LEVELS - 1];
    for (size_t point = 0; point < v->count; point++) {
        const whirl_verdict best = whirl_table_verdict(reference, point);
        for (int m = 0; m < WHIRL_VERIFY_METHODS; m++)
            for (int level = 0; level < WHIRL_VERIFY_LEVELS; level++) {
                whirl_verify_run *run = &v->points[point].runs[m][level];
                const whirl_table *table = &results[m]->tables[level];
                run->verdict = whirl_table_verdict(table, point);
                const bool same = run->verdict.regime == WHIRL_PERIODIC && best.regime == WHIRL_PERIODIC &&
                                  run->verdict.period == best.period;
                run->section = same ? section_distance(table, reference, point, best.period) : (double)NAN;
            }
    }
}

/// Adds to an exponent's error its difference from the exponent at the next tolerance; at the last one, from the one
/// before.
static void compare_exponents(whirl_verification *v) {
    for (size_t point = 0; point < v->count; point++)
        for (int m = 0; m < WHIRL_VERIFY_METHODS; m++)
            for (int level = 0; level < WHIRL_VERIFY_LEVELS; level++) {
                whirl_verify_run *runs = v->points[point].runs[m];
                const int other = level + 1 < WHIRL_VERIFY_LEVELS ? level + 1 : level - 1;
                whirl_estimate *own = &runs[level].verdict.exponent;
                const double difference = own->value - runs[other].verdict.exponent.value;
                if (isfinite(difference)) own->error = hypot(own->error, difference);
            }
}

// ---------------------------------------------------------------- states

/// Computes the state after the revolutions, all NaN if the motion left its bounds.
static whirl_status state_after(const whirl_machine *machine, const whirl_integrate_options *how, int revolutions,
                                double *x) {
    const size_t dimension = machine->system->dimension;
    whirl_integrator *integrator;
    const whirl_status status = whirl_integrator_new(machine->system, how, &integrator);
    if (status.code != WHIRL_OK) return status;
    memcpy(x, machine->start, dimension * sizeof *x);
    whirl_motion motion = WHIRL_BOUNDED;
    for (int n = 0; n < revolutions && motion == WHIRL_BOUNDED; n++)
        motion = whirl_integrator_revolve(integrator, x, NULL, NULL);
    for (size_t i = 0; motion != WHIRL_BOUNDED && i < dimension; i++) x[i] = (double)NAN;
    whirl_integrator_free(integrator);
    return status;
}

static double verify_distance(const double *a, const double *b, size_t dimension) {
    double largest = 0.0;
    for (size_t i = 0; i < dimension; i++) {
        const double difference = fabs(a[i] - b[i]);
        if (!(difference <= largest)) largest = difference; // NaN is kept
        if (isnan(difference)) return (double)NAN;
    }
    return largest;
}

/// Returns the observed order from three levels, each with `ratio` times smaller steps or tolerances.
static double observed_order(const double *states, size_t dimension, double ratio) {
    const double first = verify_distance(states, states + dimension, dimension);
    const double second = verify_distance(states + dimension, states + 2 * dimension, dimension);
    double size = 1.0;
    for (size_t i = 0; i < dimension; i++) size = fmax(size, fabs(states[i]));
    if (!(second > least_difference * size) || !(first < largest_difference * size)) return (double)NAN;
    return log(first / second) / log(ratio);
}

static whirl_status compare_states(const whirl_study *study, const whirl_stop *stop, whirl_verification *v,
                                   size_t point) {
    whirl_batch batch = study->batches[0];
    whirl_machine machine;
    batch.stop = stop;
    whirl_status status = whirl_study_machine(study, &batch, point, &machine);
    if (status.code != WHIRL_OK) return status;
    const size_t dimension = machine.system->dimension;
    double *states = calloc((size_t)WHIRL_VERIFY_METHODS * WHIRL_VERIFY_LEVELS * dimension, sizeof *states);
    if (!states) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for states");
    const size_t runs = (size_t)WHIRL_VERIFY_METHODS * WHIRL_VERIFY_LEVELS;
    for (size_t i = 0; i < runs && status.code == WHIRL_OK; i++)
        status = state_after(&machine, &v->integrate[i / WHIRL_VERIFY_LEVELS][i % WHIRL_VERIFY_LEVELS], v->revolutions,
                             states + i * dimension);
    for (size_t m = 0; m < WHIRL_VERIFY_METHODS && status.code == WHIRL_OK; m++) {
        const double *own = states + m * WHIRL_VERIFY_LEVELS * dimension, *reference = states + (runs - 1) * dimension;
        for (size_t level = 0; level < WHIRL_VERIFY_LEVELS; level++)
            v->points[point].runs[m][level].difference = verify_distance(own + level * dimension, reference, dimension);
        const bool adaptive = whirl_method_is_adaptive(v->integrate[m][0].method);
        v->points[point].order[m] = observed_order(own, dimension, adaptive ? tolerance_ratio : step_ratio);
    }
    free(states);
    if (machine.release) machine.release(machine.owner);
    return status;
}

static whirl_status compare_all_states(const whirl_study *study, const whirl_run_options *run, whirl_verification *v) {
    whirl_status status = whirl_ok();
    const int threads = run->threads > 0 ? run->threads : omp_get_num_procs();
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (size_t i = 0; i < v->count; i++) {
        whirl_status own = whirl_fail(WHIRL_STOPPED, "stopped");
        if (!whirl_stop_is_set(run->stop)) own = compare_states(study, run->stop, v, i);
        if (whirl_stop_is_set(run->stop)) own = whirl_fail(WHIRL_STOPPED, "stopped");
#pragma omp critical(whirl_verify)
        if (own.code != WHIRL_OK && status.code == WHIRL_OK) status = own;
    }
    return status;
}

// ---------------------------------------------------------------- agreement

static void judge_agreement(whirl_verify_point *point) {
    const whirl_verdict *first = &point->runs[0][0].verdict;
    double low = (double)INFINITY, high = -(double)INFINITY;
    bool known = true;
    point->agreed = first->regime != WHIRL_UNDETERMINED;
    for (int m = 0; m < WHIRL_VERIFY_METHODS; m++)
        for (int level = 0; level < WHIRL_VERIFY_LEVELS; level++) {
            const whirl_verdict *verdict = &point->runs[m][level].verdict;
            point->agreed = point->agreed && verdict->regime == first->regime && verdict->period == first->period;
            known = known && isfinite(verdict->exponent.value);
            low = fmin(low, verdict->exponent.value);
            high = fmax(high, verdict->exponent.value);
        }
    point->exponent_spread = known ? high - low : (double)NAN;
}

static whirl_status verify(const whirl_study *study, const whirl_run_options *run, whirl_verification *v) {
    whirl_result *results[WHIRL_VERIFY_METHODS] = {NULL};
    whirl_status status = compare_all_states(study, run, v);
    for (int m = 0; m < WHIRL_VERIFY_METHODS && status.code == WHIRL_OK; m++)
        status = run_levels(study, v->integrate[m], run, &results[m]);
    if (status.code == WHIRL_OK) {
        take_verdicts(v, results);
        compare_exponents(v);
        snprintf(v->film_tables, sizeof v->film_tables, "%s", whirl_result_film_tables(results[0]));
        for (size_t i = 0; i < v->count; i++) judge_agreement(&v->points[i]);
    }
    for (int m = 0; m < WHIRL_VERIFY_METHODS; m++) whirl_result_free(results[m]);
    return status;
}

static whirl_status verify_check(const whirl_study *study, const whirl_verify_options *options,
                                 const whirl_run_options *run) {
    if (study->batch_count != 1 || study->batches[0].count == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "the study has %zu batches, expected one with points", study->batch_count);
    if (!whirl_analysis_kind(study->batches[0].analyses)->moves)
        return whirl_fail(WHIRL_BAD_INPUT, "%s follow no motion by steps, expected a response or a sweep to verify",
                          study->batches[0].name);
    if (options->revolutions < 1)
        return whirl_fail(WHIRL_BAD_INPUT, "states are to be compared after %d revolutions, expected 1 or more",
                          options->revolutions);
    if (run->threads < 0) return whirl_fail(WHIRL_BAD_INPUT, "threads is %d, expected 0 or more", run->threads);
    return whirl_ok();
}

whirl_status whirl_study_verify(const whirl_study *study, const whirl_verify_options *options,
                                const whirl_run_options *run, whirl_verification **out) {
    whirl_study chosen = *study;
    *out = NULL;
    // Check the options, and choose the method of the study.
    whirl_status status = verify_check(study, options, run);
    if (status.code == WHIRL_OK) status = whirl_study_choose_methods(&chosen);
    if (status.code != WHIRL_OK) return status;
    const whirl_batch *batch = &chosen.batches[0];
    // Make memory for the points, and name them.
    whirl_verification *v = calloc(1, sizeof *v);
    if (v) v->points = calloc(batch->count, sizeof *v->points);
    if (!v || !v->points) {
        whirl_verification_free(v);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory to verify %zu points", batch->count);
    }
    memcpy(v->table, batch->name, sizeof v->table);
    memcpy(v->parameter, batch->parameter, sizeof v->parameter);
    v->revolutions = options->revolutions;
    v->count = batch->count;
    if (batch->second_values) memcpy(v->second, batch->second, sizeof v->second);
    if (batch->third_values) memcpy(v->third, batch->third, sizeof v->third);
    for (size_t i = 0; i < v->count; i++) {
        v->points[i].value = batch->values ? batch->values[i] : (double)NAN;
        v->points[i].second = batch->second_values ? batch->second_values[i] : (double)NAN;
        v->points[i].third = batch->third_values ? batch->third_values[i] : (double)NAN;
    }
    // Give each method its levels of accuracy.
    for (int m = 0; m < WHIRL_VERIFY_METHODS; m++) v->integrate[m][0] = batch->integrate;
    status = second_method(batch->integrate.method, options->method, v->integrate[1][0].method);
    for (int m = 0; m < WHIRL_VERIFY_METHODS; m++) set_levels(v->integrate[m]);
    // Compute and compare all of them.
    if (status.code == WHIRL_OK) status = verify(&chosen, run, v);
    if (status.code == WHIRL_OK)
        *out = v;
    else
        whirl_verification_free(v);
    return status;
}

void whirl_verification_free(whirl_verification *verification) {
    if (verification) free(verification->points);
    free(verification);
}
