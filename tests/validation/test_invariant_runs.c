// Reported numbers do not depend on the method of integration, nor on how a study is split: into single points, among
// threads, among shares. The tests compare all fields of the tables of one small machine for each element.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_machines.h"
#include "support_same.h"
#include "support_study.h"

// ---------------------------------------------------------------- methods

/// Fields that are not compared between methods: they describe how a method reached its result (recurrence, exponents,
/// steps, confidence).
static const char *const of_the_way[] = {"regime/recurrence", "regime/revolutions",  "regime/settl",
                                         "regime/exponent",   "regime/chaos",        "regime/advice",
                                         "regime/step",       "regime/agreement",    "regime/followed",
                                         "regime/rotation",   "regime/line",         "regime/longest",
                                         "regime/rest",       "floquet/residual",    "floquet/distance",
                                         "floquet/volume",    "floquet/revolutions", "floquet/set_at",
                                         "floquet/search",    "regime/confidence",   NULL};

static whirl_result *run_by(const element_machine *of, const char *method) {
    const bool soak = getenv("WHIRL_SOAK") != NULL;
    char study[1024], text[MACHINE_TEXT];
    snprintf(study, sizeof study,
             "  response: {}\n  integrate: {method: %s, %srtol: %s, atol: 1e-14, steps_per_revolution: 1024, "
             "transient: %d, record: 8}\n  keep: {highest_order: 3}\n"
             "  analyze: [poincare, orbit, rub, spectrum, regime, winding, floquet]\n",
             method, strcmp(method, "rk4") == 0 ? "contacts: located, " : "", soak ? "1e-11" : "1e-9", soak ? 150 : 40);
    machine_text(of, (machine_view){0}, study, text);
    return result_of_text(text);
}

static void methods(void **state) {
    static const char *const others[] = {"rk4", "rodas5p", NULL};
    size_t wrong = 0;
    (void)state;
    for (const element_machine *of = element_machines; of->name; of++) {
        whirl_result *one = run_by(of, "dop853");
        for (const char *const *method = others; *method; method++) {
            whirl_result *other = run_by(of, *method);
            const same_rule rule = {of->flags & MACHINE_SHARP ? 1e-3 : 1e-5, 1e-5, false, of_the_way};
            wrong += same_results(words("%s by %s", of->name, *method), one, other, &rule);
            whirl_result_free(other);
        }
        whirl_result_free(one);
    }
    assert_int_equal(wrong, 0);
}

// ---------------------------------------------------------------- splitting

/// Points that were kept, in memory.
typedef struct kept_point {
    size_t batch, slot, size, dimension;
    double *numbers; ///< block [size], end [dimension]
} kept_point;
enum { MAX_KEPT = 64 };
typedef struct kept_points {
    size_t count;
    kept_point points[MAX_KEPT];
} kept_points;

static whirl_status keep(void *context, size_t batch, size_t slot, const double *block, size_t size, const double *end,
                         size_t dimension) {
    kept_points *all = context;
    assert_true(all->count < MAX_KEPT);
    kept_point *own = &all->points[all->count++];
    *own = (kept_point){batch, slot, size, dimension, malloc((size + dimension + 1) * sizeof(double))};
    assert_non_null(own->numbers);
    memcpy(own->numbers, block, size * sizeof *block);
    if (dimension > 0) memcpy(own->numbers + size, end, dimension * sizeof *end);
    return whirl_ok();
}

static bool recall(void *context, size_t batch, size_t slot, double *block, size_t size, double *end,
                   size_t dimension) {
    const kept_points *all = context;
    for (size_t i = 0; i < all->count; i++) {
        const kept_point *own = &all->points[i];
        if (own->batch != batch || own->slot != slot || own->size != size || own->dimension != dimension) continue;
        memcpy(block, own->numbers, size * sizeof *block);
        if (dimension > 0) memcpy(end, own->numbers + size, dimension * sizeof *end);
        return true;
    }
    return false;
}

static whirl_result *run_with(const whirl_case *object, const whirl_run_options *options) {
    whirl_result *result = NULL;
    const whirl_status status = whirl_case_run(object, options, &result);
    if (options->share.count == 0 || status.code != WHIRL_STOPPED) require_ok(status);
    return result;
}

/// Runs the study in two shares, one after the other, and gathers them.
static whirl_result *run_in_shares(const whirl_case *object) {
    kept_points all = {.count = 0};
    const whirl_point_store store = {.keep = keep, .recall = recall, .context = &all};
    for (size_t number = 1; number <= 2; number++)
        whirl_result_free(run_with(object, &(whirl_run_options){.threads = 1, .store = &store, .share = {number, 2}}));
    whirl_result *result = run_with(object, &(whirl_run_options){.threads = 1, .store = &store, .gather = true});
    for (size_t i = 0; i < all.count; i++) free(all.points[i].numbers);
    return result;
}

static const char values[][8] = {"700", "800", "900"};
enum { VALUES = sizeof values / sizeof *values };

static whirl_case *case_at(const element_machine *of, const char *of_values) {
    char study[1024], text[MACHINE_TEXT];
    snprintf(study, sizeof study,
             "  sweep: {parameter: n, values: [%s], start: state}\n"
             "  integrate: {method: rk4, steps_per_revolution: 256, transient: 4, record: 3}\n"
             "  keep: {waveform: 1, samples: 16, highest_order: 3}\n"
             "  analyze: [poincare, orbit, rub, spectrum, lyapunov, regime, winding, floquet]\n",
             of_values);
    machine_text(of, (machine_view){0}, study, text);
    return case_of_text(text);
}

static void splitting(void **state) {
    const same_rule bits = {.tolerance = 0.0};
    size_t wrong = 0;
    (void)state;
    for (const element_machine *of = element_machines; of->name; of++) {
        whirl_case *object = case_at(of, "700, 800, 900");
        whirl_result *whole = run_with(object, &(whirl_run_options){.threads = 1}), *other;
        for (int threads = 2; threads <= 3; threads++) {
            other = run_with(object, &(whirl_run_options){.threads = threads});
            wrong += same_results(words("%s on %d threads", of->name, threads), whole, other, &bits);
            whirl_result_free(other);
        }
        other = run_in_shares(object);
        wrong += same_results(words("%s in shares", of->name), whole, other, &bits);
        whirl_result_free(other);
        whirl_case_free(object);
        for (size_t i = 0; i < VALUES; i++) {
            object = case_at(of, values[i]);
            other = run_with(object, &(whirl_run_options){.threads = 1});
            wrong += same_points(words("%s at %s alone", of->name, values[i]), whole, 0, i, other, 0, &bits);
            whirl_result_free(other);
            whirl_case_free(object);
        }
        whirl_result_free(whole);
    }
    assert_int_equal(wrong, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(methods), cmocka_unit_test(splitting)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
