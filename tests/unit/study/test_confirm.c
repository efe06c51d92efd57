// Confirmation and refinement, on an equation that RK4 carries wrongly where its steps are too long (follower.h). With
// 64 steps in a period of 1 that is r > 178.3, with 128 r > 356.5.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <time.h>

#include <cmocka.h>

#include "follower.h"
#include "memory_store.h"
#include "sweep_study.h"

enum { POINTS = 9, WRONG = 4, STEPS = 64, REVOLUTIONS = 80 };

/// Four rates that 64 steps carry well, then four that only 128 do, and one that needs 256: both tolerances of the
/// first run lose it.
static const double rates[POINTS] = {20, 60, 100, 140, 200, 240, 280, 320, 420};

static whirl_study study(whirl_carry carry, double budget) {
    whirl_study s = sweep_study("r", rates, POINTS, STEPS);
    whirl_batch *batch = &s.batches[0];
    s.machine = make_follower;
    s.refine.revolutions = budget;
    batch->carry = carry;
    batch->confirm = true;
    batch->record.transient = 60;
    batch->record.record = REVOLUTIONS - batch->record.transient;
    assert_true(whirl_analysis_add(&batch->analyses, "poincare"));
    assert_true(whirl_analysis_add(&batch->analyses, "regime"));
    return s;
}

static double number(const whirl_result *result, size_t point, const char *field) {
    const double *found = whirl_table_field(result->tables, point, field, 0);
    assert_non_null(found);
    return *found;
}

static bool is_wrong(size_t point) {
    return rates[point] / STEPS > 2.7853;
}

/// Returns the number of steps that refinement takes: doubled until the method is stable.
static int refined_steps(size_t point) {
    int steps = STEPS;
    while (rates[point] / steps > 2.7853) steps *= 2;
    return steps;
}

static void test_verdicts_at_two_tolerances(void **state) {
    const whirl_study s = study(WHIRL_CARRY_NONE, 0);
    (void)state;
    whirl_result *result = run(&s, 2);
    for (size_t i = 0; i < POINTS - 1; i++) {
        const whirl_verdict verdict = whirl_table_verdict(result->tables, i);
        assert_true(verdict.confirmed);
        assert_int_equal(verdict.regime, is_wrong(i) ? WHIRL_UNDETERMINED : WHIRL_PERIODIC);
        assert_int_equal(verdict.other_regime, WHIRL_PERIODIC);
        assert_int_equal(verdict.other_period, 1);
        assert_int_equal(verdict.confidence, is_wrong(i) ? WHIRL_LOW : WHIRL_HIGH);
    }
    assert_null(whirl_table_field(result->tables, 0, "refine/rounds", 0));
    whirl_result_free(result);
}

/// Returns the exponent by RK4: it multiplies a perturbation of the follower by 1 + z + z^2/2 + z^3/6 + z^4/24 in a
/// step, z = -r h.
static double exponent_of_rk4(double rate, int steps) {
    const double z = -rate / steps;
    return steps * log(1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0);
}

static void test_errors_of_exponents_know_the_second_tolerance(void **state) {
    enum { FEW = 8 };
    static const double rate[] = {4.0};
    (void)state;
    for (int confirmed = 0; confirmed <= 1; confirmed++) {
        whirl_study s = study(WHIRL_CARRY_NONE, 0);
        s.batches[0].values = rate;
        s.batches[0].count = 1;
        s.batches[0].confirm = confirmed;
        s.batches[0].integrate.steps_per_revolution = FEW;
        assert_true(whirl_analysis_add(&s.batches[0].analyses, "lyapunov"));
        whirl_result *result = run(&s, 1);
        const double coarse = exponent_of_rk4(rate[0], FEW), fine = exponent_of_rk4(rate[0], 2 * FEW);
        const double difference = confirmed ? fabs(coarse - fine) : 0.0;
        static const char *const fields[][2] = {{"regime/exponent", "regime/exponent_error"},
                                                {"lyapunov/largest", "lyapunov/error"}};
        for (int i = 0; i < 2; i++) {
            const double value = number(result, 0, fields[i][0]), error = number(result, 0, fields[i][1]);
            assert_true(fabs(value - coarse) < 1e-5);
            assert_true(fabs(error - difference) < 1e-5);
            // The error of a method of order four is 16/15 of the difference.
            assert_int_equal(fabs(value + rate[0]) < 1.1 * error, confirmed);
        }
        whirl_result_free(result);
    }
}

/// x' = p - x^2: motions that start above -sqrt p come to rest at sqrt p, all others diverge.
static void parabola(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)t, (void)forcing;
    dxdt[0] = ((const follower *)model)->rate - x[0] * x[0];
}

static whirl_status parabola_machine(const void *family, const whirl_batch *batch, double value, whirl_machine *out) {
    const whirl_status status = make_follower(family, batch, value, out);
    follower *own = out->owner;
    own->start[0] = -1.5;
    own->system.rhs = parabola;
    return status;
}

/// From -1.5 motions come to rest only for p > 2.25. Carried from there all do, at both tolerances if both have the
/// same start.
static void test_carried_points_are_confirmed_from_their_own_start(void **state) {
    static const double values[] = {4, 3, 1, 0.5};
    (void)state;
    for (int carry = WHIRL_CARRY_NONE; carry <= WHIRL_CARRY_FORWARD; carry++) {
        whirl_study s = study((whirl_carry)carry, 0);
        s.machine = parabola_machine;
        s.batches[0].values = values;
        s.batches[0].count = 4;
        whirl_result *result = run(&s, 2);
        for (size_t i = 0; i < 4; i++) {
            const bool lost = carry == WHIRL_CARRY_NONE && values[i] < 2.25;
            assert_int_equal(number(result, i, "regime/code"), lost ? WHIRL_DIVERGING : WHIRL_PERIODIC);
            assert_int_equal(number(result, i, "regime/other_code"), lost ? WHIRL_DIVERGING : WHIRL_PERIODIC);
        }
        whirl_result_free(result);
    }
}

static void test_points_in_doubt_are_refined(void **state) {
    const whirl_study s = study(WHIRL_CARRY_NONE, 1e6);
    (void)state;
    whirl_result *result = run(&s, 2);
    for (size_t i = 0; i < POINTS; i++) {
        const whirl_verdict verdict = whirl_table_verdict(result->tables, i);
        const int times = refined_steps(i) / STEPS;
        assert_int_equal(verdict.regime, WHIRL_PERIODIC);
        assert_int_equal(verdict.confidence, WHIRL_HIGH);
        // One round refines an unstable point with a stable number of steps, and confirms it with twice as many.
        assert_int_equal(number(result, i, "refine/rounds"), is_wrong(i) ? 1 : 0);
        assert_int_equal(number(result, i, "refine/steps_per_revolution"), refined_steps(i));
        assert_int_equal(number(result, i, "refine/transient"), 60);
        assert_int_equal(number(result, i, "refine/revolutions"), is_wrong(i) ? 3 * times * REVOLUTIONS : 0);
        // The periodic motion is (r^2 cos + 2 pi r sin)/(r^2 + 4 pi^2) of 2 pi t: at t = 0 that is r^2/(r^2 + 4 pi^2).
        const double r = rates[i], exact = r * r / (r * r + 39.47841760435743);
        // (Close to the limit of stability steps are coarse.)
        const double section = *whirl_table_field(result->tables, i, "poincare/section", 0);
        assert_true(fabs(section - exact) < 5e-3);
    }
    whirl_result_free(result);
}

static void test_the_budget_is_not_exceeded(void **state) {
    const double each = 6.0 * REVOLUTIONS;
    const whirl_study s = study(WHIRL_CARRY_NONE, 2.5 * each);
    double spent = 0;
    (void)state;
    whirl_result *result = run(&s, 2);
    for (size_t i = 0; i < POINTS; i++) {
        assert_int_equal(number(result, i, "refine/rounds"), i == WRONG || i == WRONG + 1);
        spent += number(result, i, "refine/revolutions");
    }
    assert_true(spent == 2 * each);
    assert_string_equal(result->facts[0].name, "refine");
    assert_string_equal(result->facts[0].value, "1200 revolutions");
    whirl_result_free(result);
}

static void test_no_time_is_no_refinement(void **state) {
    whirl_study s = study(WHIRL_CARRY_NONE, 0);
    (void)state;
    s.refine.seconds = 1e-9;
    whirl_result *result = run(&s, 2);
    size_t done, total;
    assert_false(whirl_result_partial(result, &done, &total));
    for (size_t i = 0; i < POINTS; i++) assert_int_equal(number(result, i, "refine/rounds"), 0);
    whirl_result_free(result);
    s.refine.seconds = 1e6;
    result = run(&s, 2);
    for (size_t i = 0; i < POINTS; i++) assert_int_equal(number(result, i, "refine/rounds"), is_wrong(i));
    whirl_result_free(result);
}

static double now(void) {
    struct timespec time;
    timespec_get(&time, TIME_UTC);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/// A point that takes longer than the time left is given up within a revolution, and its earlier result stays.
static void test_time_is_kept(void **state) {
    static const double slow[] = {1e-6, 2e-6}; // these need runs a hundred times as long, some ten seconds
    whirl_study s = study(WHIRL_CARRY_NONE, 0);
    (void)state;
    s.batches[0].values = slow;
    s.batches[0].count = 2;
    s.batches[0].confirm = false;
    s.batches[0].record.transient = 30000;
    const double begun = now();
    whirl_result *plain = run(&s, 2);
    const double computed = now();
    s.refine.seconds = 0.2;
    whirl_result *result = run(&s, 2);
    assert_true(now() - computed < 4.0 * (computed - begun) + 1.0);
    for (size_t i = 0; i < 2; i++) {
        const size_t size = plain->tables->layout.size;
        assert_true(whirl_table_verdict(plain->tables, i).settles); // in doubt: it is not there yet
        assert_int_equal(number(result, i, "refine/rounds"), 0);
        assert_memory_equal(result->tables->blocks + i * result->tables->layout.size, plain->tables->blocks + i * size,
                            size * sizeof(double));
    }
    whirl_result_free(plain);
    whirl_result_free(result);
}

static void test_threads_change_no_bit(void **state) {
    (void)state;
    for (int carry = WHIRL_CARRY_NONE; carry <= WHIRL_CARRY_BOTH; carry++) {
        const whirl_study s = study((whirl_carry)carry, 1e6);
        whirl_result *one = run(&s, 1), *seven = run(&s, 7);
        expect_same_blocks(one, seven);
        whirl_result_free(one);
        whirl_result_free(seven);
    }
}

/// For any set of points that a store knows, the result is that of a run without known points.
static void test_recalled_points_change_no_bit(void **state) {
    (void)state;
    for (int carry = WHIRL_CARRY_NONE; carry <= WHIRL_CARRY_BOTH; carry++) {
        const whirl_study s = study((whirl_carry)carry, 1e6);
        whirl_result *whole = run(&s, 1);
        memory_store *memory = store_new(2 * POINTS, 1);
        whirl_result_free(run_with_store(&s, memory, WHIRL_OK));
        for (unsigned step = 2; step <= 16; step *= 2) {
            int known = 0;
            for (unsigned p = 0; p < MAX_PASSES; p++)
                for (unsigned i = 0; i < MAX_SLOTS; i++) {
                    memory->known[p][i] = memory->known[p][i] && (7 * p + 3 * i) % step != 1;
                    known += memory->known[p][i];
                }
            whirl_result *resumed = run_with_store(&s, memory, WHIRL_OK);
            assert_int_equal(memory->recalled, known);
            assert_true(memory->written > 0);
            expect_same_blocks(whole, resumed);
            whirl_result_free(resumed);
        }
        whirl_result_free(whole);
        free(memory);
    }
}

/// Asks for a stop as soon as a point of a pass is kept.
typedef struct stopper {
    size_t pass;
    whirl_stop stop;
} stopper;

static whirl_status stop_at_pass(void *context, size_t pass, size_t slot, const double *block, size_t size,
                                 const double *end, size_t dimension) {
    stopper *own = context;
    (void)slot, (void)block, (void)size, (void)end, (void)dimension;
    own->stop = own->stop || pass == own->pass;
    return whirl_ok();
}

static bool recall_nothing(void *context, size_t pass, size_t slot, double *block, size_t size, double *end,
                           size_t dimension) {
    (void)context, (void)pass, (void)slot, (void)block, (void)size, (void)end, (void)dimension;
    return false;
}

/// Checks that the result is partial although all points are done.
static void expect_partial(double budget, size_t pass, const char *sentence) {
    const whirl_study s = study(WHIRL_CARRY_NONE, budget);
    stopper own = {.pass = pass};
    const whirl_point_store store = {.keep = stop_at_pass, .recall = recall_nothing, .context = &own};
    const whirl_run_options options = {.threads = 1, .stop = &own.stop, .store = &store};
    whirl_result *result;
    size_t done, total;
    const whirl_status status = whirl_study_run(&s, &options, &result);
    assert_int_equal(status.code, WHIRL_STOPPED);
    assert_string_equal(status.message, sentence);
    assert_true(whirl_result_partial(result, &done, &total));
    assert_true(done == total && total == POINTS);
    whirl_result_free(result);
}

static void test_a_stop_while_confirming_is_reported(void **state) {
    (void)state;
    expect_partial(0, 1, "stopped after 1 of 9 points were confirmed");
}

static void test_a_stop_while_refining_is_reported(void **state) {
    (void)state;
    expect_partial(1e6, 4, "stopped after 1 of 5 points of a round of refinement");
}

static void test_verdicts_are_needed(void **state) {
    whirl_study s = study(WHIRL_CARRY_NONE, 0);
    whirl_result *result;
    (void)state;
    s.batches[0].analyses = 0;
    assert_true(whirl_analysis_add(&s.batches[0].analyses, "poincare"));
    whirl_status status = whirl_study_outline(&s, &result);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message,
                        "verdicts of the sweep cannot be confirmed: the analysis 'regime' is not chosen");
    s.batches[0].confirm = false;
    s.refine.revolutions = 1;
    status = whirl_study_outline(&s, &result);
    assert_string_equal(status.message, "verdicts of the sweep cannot be refined: the analysis 'regime' is not chosen");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_verdicts_at_two_tolerances),
        cmocka_unit_test(test_errors_of_exponents_know_the_second_tolerance),
        cmocka_unit_test(test_carried_points_are_confirmed_from_their_own_start),
        cmocka_unit_test(test_points_in_doubt_are_refined),
        cmocka_unit_test(test_the_budget_is_not_exceeded),
        cmocka_unit_test(test_no_time_is_no_refinement),
        cmocka_unit_test(test_time_is_kept),
        cmocka_unit_test(test_threads_change_no_bit),
        cmocka_unit_test(test_recalled_points_change_no_bit),
        cmocka_unit_test(test_a_stop_while_confirming_is_reported),
        cmocka_unit_test(test_a_stop_while_refining_is_reported),
        cmocka_unit_test(test_verdicts_are_needed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
