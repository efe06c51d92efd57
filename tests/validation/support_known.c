#include "support_known.h"

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

/// Motions judged: right, undetermined, another by low confidence (which says that it may be so), wrong; of the right
/// ones those with high confidence, of the undetermined ones those that are right when the advice is followed; missed:
/// motions that the advice could not decide.
typedef struct tally {
    int judged, right, certain, open, settled, doubtful, fairly_wrong, surely_wrong, missed;
} tally;

static tally total;

typedef struct run_options {
    whirl_integrate_options integrate;
    whirl_record_options record;
} run_options;

/// Returns options as sweeps use them.
static run_options usual_options(const known_motion *motion, int steps) {
    run_options run = {whirl_integrate_default(), whirl_record_default()};
    snprintf(run.integrate.method, sizeof run.integrate.method, "%s", steps > 0 ? "rk4" : "dop853");
    if (steps > 0) run.integrate.steps_per_revolution = steps;
    if (motion->transient > 0) run.record.transient = motion->transient;
    run.record.watch = 650;
    run.record.waveform = false;
    return run;
}

/// Computes the derivative of the slopes by differences, as for systems of users.
static void tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                    size_t count, const double *dx, double *ddxdt) {
    const known_motion *motion = (const known_motion *)((const char *)model - offsetof(known_motion, p));
    const size_t n = motion->system.dimension;
    double beside[KNOWN_DIMENSION], lower[KNOWN_DIMENSION], size = 1e-3, length = 0.0;
    (void)sides;
    for (size_t k = 0; k < n; k++) size = fmax(size, fabs(x[k]));
    for (; count-- > 0; dx += n, ddxdt += n, length = 0.0) {
        for (size_t k = 0; k < n; k++) length = fmax(length, fabs(dx[k]));
        const double step = length > 0.0 ? 6e-6 * size / length : 1.0;
        for (size_t k = 0; k < n; k++) beside[k] = x[k] - step * dx[k];
        motion->system.rhs(model, t, forcing, beside, lower);
        for (size_t k = 0; k < n; k++) beside[k] = x[k] + step * dx[k];
        motion->system.rhs(model, t, forcing, beside, ddxdt);
        for (size_t k = 0; k < n; k++) ddxdt[k] = (ddxdt[k] - lower[k]) / (2.0 * step);
    }
}

/// Returns the verdict; with `seeks` the search for attractors on which chaos may end is included.
static whirl_verdict judge(const known_motion *motion, const run_options *run, bool seeks) {
    whirl_system system = motion->rotor ? *whirl_rotor_system(motion->rotor) : motion->system;
    whirl_record *record;
    require_ok(whirl_record_motion(&system, &run->integrate, &run->record, motion->start, NULL, &record));
    whirl_verdict verdict = whirl_judge(record);
    if (seeks && verdict.regime == WHIRL_CHAOTIC && verdict.agreement >= WHIRL_FAIR) {
        if (!motion->rotor) system.tangent = tangent;
        // Not where phases turn: fair at most then, as studies have it.
        verdict.sought =
            whirl_record_coexisting(&system, &run->integrate, record, &verdict.coexisting).code == WHIRL_OK;
        whirl_survival copies = {0};
        if (verdict.agreement == WHIRL_HIGH && verdict.coexisting == 0 &&
            whirl_record_survival(&system, &run->integrate, record, verdict.exponent.value, &copies).code == WHIRL_OK) {
            verdict.survived = copies.revolutions;
            verdict.ended = copies.ended;
        }
    }
    whirl_record_free(record);
    return verdict;
}

/// Returns the verdict, confirmed at a second tolerance.
static whirl_verdict judge_twice(const known_motion *motion, const run_options *run) {
    run_options second = *run;
    second.integrate = whirl_integrate_tighter(&run->integrate, 16.0);
    whirl_verdict verdict = judge(motion, run, false);
    const whirl_verdict other = judge(motion, &second, true);
    whirl_verdict_confirm(&verdict, &other);
    return verdict;
}

whirl_verdict judge_known(const known_motion *motion, int steps) {
    const run_options run = usual_options(motion, steps);
    return judge_twice(motion, &run);
}

/// Follows the advice of the verdicts until one decides, or the run takes too many revolutions.
static whirl_verdict follow_advice(const known_motion *motion, run_options run, whirl_verdict verdict) {
    const int most_revolutions = 60000;
    while (verdict.regime == WHIRL_UNDETERMINED && verdict.advice.remedy != WHIRL_NO_REMEDY) {
        whirl_advice_apply(verdict.advice, &run.integrate, &run.record);
        if (run.record.transient + run.record.record > most_revolutions) break;
        verdict = judge_twice(motion, &run);
    }
    return verdict;
}

static bool agrees(const char *expected, const whirl_verdict *verdict) {
    char name[64];
    whirl_verdict_name(verdict, name, sizeof name);
    if (verdict->rests && strcmp(expected, "P-1") == 0) return true; // a rest is a P-1
    if (strcmp(expected, "diverged") == 0) return verdict->regime == WHIRL_DIVERGING;
    if (strcmp(expected, "quasi-periodic") == 0) return verdict->regime == WHIRL_QUASI_PERIODIC;
    if (strcmp(name, "quasi-periodic") == 0)
        return strncmp(expected, name, strlen(name)) == 0; // the number of curves is not compared
    if (strncmp(expected, "not ", 4) == 0) return strcmp(expected + 4, name) != 0;
    return strcmp(expected, name) == 0;
}

static void report(const known_family *family, const known_motion *motion, const whirl_verdict *verdict) {
    char name[64], reason[256], advice[64];
    whirl_verdict_name(verdict, name, sizeof name);
    whirl_verdict_reason(verdict, reason, sizeof reason);
    whirl_verdict_advice(verdict, advice, sizeof advice);
    printf("  %s, %s: expected %s%s, obtained %s (%s); %s; %s\n", family->name, motion->label, motion->expected,
           motion->trap ? " (a trap)" : "", name, whirl_confidence_name(verdict->confidence), reason, advice);
}

static void judge_one(const known_family *family, const known_motion *motion, bool patient, tally *sum) {
    const run_options run = usual_options(motion, family->steps);
    whirl_verdict verdict = judge_twice(motion, &run);
    const bool open = verdict.regime == WHIRL_UNDETERMINED;
    if (open) {
        sum->open++;
        sum->missed += motion->trap ? 0 : 1;
        report(family, motion, &verdict);
        if (patient) verdict = follow_advice(motion, run, verdict);
    }
    if (verdict.regime == WHIRL_UNDETERMINED) return;
    if (open) report(family, motion, &verdict);
    if (agrees(motion->expected, &verdict)) {
        *(open ? &sum->settled : &sum->right) += 1;
        sum->certain += !open && verdict.confidence == WHIRL_HIGH;
        return;
    }
    int *const others[] = {&sum->doubtful, &sum->fairly_wrong, &sum->surely_wrong};
    *others[verdict.confidence] += 1;
    sum->missed += verdict.confidence == WHIRL_LOW && !motion->trap && !open;
    if (!open) report(family, motion, &verdict);
}

static void print(const char *what, const tally *sum) {
    printf("verdicts | %s | - | %d right (%d high), %d undetermined (%d by advice), %d of low confidence, %d wrong | - "
           "| -\n",
           what, sum->right, sum->certain, sum->open, sum->settled, sum->doubtful,
           sum->fairly_wrong + sum->surely_wrong);
    fflush(stdout);
}

static void check_family(const known_family *family, size_t stride) {
    const bool all = getenv("WHIRL_SOAK") != NULL;
    tally sum = {0};
    for (size_t i = 0;; i += all ? 1 : stride) {
        known_motion motion = {0};
        if (!family->make(i, &motion)) break;
        if (!motion.rotor) motion.system.model = motion.p;
        judge_one(family, &motion, all, &sum);
        whirl_rotor_free(motion.rotor);
        sum.judged++;
    }
    print(words("%s (%s), %d motions", family->name, family->source, sum.judged), &sum);
    total.judged += sum.judged;
    total.right += sum.right;
    total.certain += sum.certain;
    total.open += sum.open;
    total.settled += sum.settled;
    total.doubtful += sum.doubtful;
    total.fairly_wrong += sum.fairly_wrong;
    total.surely_wrong += sum.surely_wrong;
    assert_int_equal(sum.surely_wrong, 0);
    assert_int_equal(sum.missed, 0);
}

static void check_known_total(const char *what, int least) {
    print(words("%s, all %d", what, total.judged), &total);
    check_within("verdicts", words("%s: wrong with high confidence", what), 0.0, total.surely_wrong, 0.0);
    check_within("verdicts", words("%s: share wrong with fair confidence", what), 0.0,
                 (double)total.fairly_wrong / total.judged, 0.005);
    if (getenv("WHIRL_SOAK")) assert_true(total.right >= least);
}

// ---------------------------------------------------------------- all families

/// The families that a run judges: their name, the stride through their motions, the least number of right verdicts.
static struct {
    const char *what;
    size_t stride;
    int least;
} run;

static void family_is_judged(void **state) {
    check_family(*state, run.stride);
}

static void in_sum(void **state) {
    (void)state;
    check_known_total(run.what, run.least);
}

int run_families(const char *what, const known_family *families, size_t count, size_t stride,
                 const struct CMUnitTest *more, size_t more_count, int least) {
    enum { MAX_TESTS = 32 };
    struct CMUnitTest tests[MAX_TESTS];
    size_t used = 0;
    assert_true(count + more_count < MAX_TESTS);
    run.what = what;
    run.stride = stride;
    run.least = least;
    for (size_t i = 0; i < count; i++)
        tests[used++] =
            (struct CMUnitTest){families[i].name, family_is_judged, NULL, NULL, (void *)(uintptr_t)&families[i]};
    for (size_t i = 0; i < more_count; i++) tests[used++] = more[i];
    tests[used++] = (struct CMUnitTest)cmocka_unit_test(in_sum);
    return _cmocka_run_group_tests("verdicts", tests, used, NULL, NULL);
}
