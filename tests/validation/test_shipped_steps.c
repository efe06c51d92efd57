// The fixed steps of the cases that ship are short enough for the machines where their sweeps begin and end: not for
// the first revolutions alone, but for what these grow into.
#include <glob.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/case.h"
#include "whirl/engine/study.h"

enum { GROWN = 64 }; ///< revolutions in which half-speed whirl grows from the rest of a film to its limit

/// Returns the growth that whirl's own check of steps finds at a point after `revolutions`; a stable method carries the
/// motion there.
static double growth_after(int revolutions, const whirl_study *study, const whirl_batch *batch, size_t point) {
    whirl_machine machine;
    whirl_step_check check;
    whirl_integrator *integrator;
    whirl_integrate_options stable = batch->integrate;
    memcpy(stable.method, "rodas5p", sizeof "rodas5p");
    stable.rtol = 1e-4;
    stable.atol = 1e-7;
    assert_int_equal(whirl_study_machine(study, batch, point, &machine).code, WHIRL_OK);
    const size_t dimension = machine.system->dimension;
    double *x = malloc(dimension * sizeof *x);
    assert_non_null(x);
    memcpy(x, machine.start, dimension * sizeof *x);
    assert_int_equal(whirl_integrator_new(machine.system, &stable, &integrator).code, WHIRL_OK);
    whirl_motion motion = WHIRL_BOUNDED;
    for (int i = 0; i < revolutions && motion == WHIRL_BOUNDED; i++)
        motion = whirl_integrator_revolve(integrator, x, NULL, NULL);
    assert_int_equal(motion, WHIRL_BOUNDED);
    assert_int_equal(whirl_step_check_revolution(machine.system, &batch->integrate, x, NULL, 1e-5, &check).code,
                     WHIRL_OK);
    whirl_integrator_free(integrator);
    free(x);
    machine.release(machine.owner);
    return check.growth;
}

/// Returns the largest growth at the ends of a case's sweeps by fixed steps; 0 where it has none.
static double worst_of(whirl_case *object) {
    whirl_study study;
    double worst = 0.0;
    assert_int_equal(whirl_case_study(object, &study).code, WHIRL_OK);
    for (size_t b = 0; b < study.batch_count; b++) {
        const whirl_batch *batch = &study.batches[b];
        if (whirl_method_is_adaptive(batch->integrate.method) || !whirl_analysis_kind(batch->analyses)->settles)
            continue;
        for (size_t point = 0; point<batch->count; point += batch->count> 1 ? batch->count - 1 : 1)
            worst = fmax(worst, growth_after(GROWN, &study, batch, point));
    }
    return worst;
}

static void steps_of_shipped_cases(void **state) {
    glob_t found;
    size_t fixed = 0;
    (void)state;
    assert_int_equal(glob(WHIRL_CASES "/*.yaml", 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        whirl_case *object;
        if (strstr(found.gl_pathv[i], "-claims.yaml")) continue; // is no case
        assert_int_equal(whirl_case_load(found.gl_pathv[i], NULL, &object).code, WHIRL_OK);
        const double worst = worst_of(object);
        whirl_case_free(object);
        fixed += worst > 0.0;
        if (worst > 1.0) print_error("%s: a step makes a perturbation %g times as large\n", found.gl_pathv[i], worst);
        assert_true(worst <= 1.0);
    }
    assert_true(fixed >= 5);
    globfree(&found);
}

/// The overhung rotor's films stiffen as the whirl grows: 1200 steps by rk4 look stable at first and are not.
static void steps_that_become_unstable(void **state) {
    whirl_case *object;
    whirl_study study;
    (void)state;
    assert_int_equal(whirl_case_load(WHIRL_CASES "/overhung-rotor.yaml", NULL, &object).code, WHIRL_OK);
    assert_int_equal(whirl_case_study(object, &study).code, WHIRL_OK);
    whirl_batch batch = study.batches[0];
    memcpy(batch.integrate.method, "rk4", sizeof "rk4");
    batch.integrate.steps_per_revolution = 1200;
    assert_true(growth_after(0, &study, &batch, batch.count - 1) <= 1.0);
    assert_true(growth_after(GROWN, &study, &batch, batch.count - 1) > 1.0);
    whirl_case_free(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(steps_of_shipped_cases),
                                       cmocka_unit_test(steps_that_become_unstable)};
    return cmocka_run_group_tests_name("shipped steps", tests, NULL, NULL);
}
