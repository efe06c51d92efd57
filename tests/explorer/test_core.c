// The explorer's C interface, as the browser's worker calls it: points are those of a study, to the bit.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "core.h"

static const char text_of_case[] =
    "whirl: 1\n"
    "title: \"A \\\"rotor\\\" <b>\"\n"
    "parameters:\n"
    "  r: 0.4          # unbalance \\ \"eccentricity\"\n"
    "  sigma: 0.3\n"
    "rotor:\n"
    "  speed: 1 rad/s\n"
    "  length_scale: 1 m\n"
    "  stations: {journal: {mass: 1 kg, eccentricity: = r}}\n"
    "  elements:\n"
    "    - film: {at: journal, clearance: 1 m, load: = sigma/9}\n"
    "    - gravity: = 1/9\n"
    "study:\n"
    "  sweep: {parameter: r, from: 0.1, to: 0.5, points: 7, start: carry, direction: both}\n"
    "  initial: {journal: {x: 0.1, y: -0.2}}\n"
    "  integrate: {steps_per_revolution: 64, transient: 40, record: 20}\n"
    "  analyze: [poincare, orbit, rub, lyapunov, regime]\n";

static whirl_case *open_case(void) {
    whirl_case *object = explorer_case_new(text_of_case, strlen(text_of_case), "t.yaml");
    assert_non_null(object);
    return object;
}

static plan *open_plan(const whirl_case *object) {
    plan *p = explorer_plan_new(object, "sweep", NULL);
    assert_non_null(p);
    explorer_plan_diagram(p);
    assert_non_null(explorer_plan_layout(p, 0.1));
    return p;
}

/// Runs a job to its end and checks every point with the study's table, whose slots begin at `first`.
static void expect_table(const plan *p, job *j, const whirl_table *table, const size_t *slots) {
    double *block = calloc(explorer_block_size(p), sizeof *block), end[4];
    size_t taken = 0;
    assert_non_null(block);
    assert_int_equal(explorer_block_size(p), table->layout.size);
    for (double turned = 1.0; turned > 0.0;) {
        turned = explorer_job_turn(j);
        assert_true(turned >= 0.0);
        for (int index; (index = explorer_job_take(j, block, end)) >= 0; taken++)
            assert_memory_equal(block, table->blocks + slots[index] * table->layout.size,
                                table->layout.size * sizeof *block);
    }
    assert_int_equal(taken, 7);
    free(block);
}

static void points_are_those_of_a_study(void **state) {
    (void)state;
    whirl_case *object = open_case();
    whirl_result *result;
    const whirl_run_options options = {.threads = 1};
    assert_int_equal(whirl_case_run(object, &options, &result).code, WHIRL_OK);
    const whirl_table *table = &result->tables[0];
    plan *p = open_plan(object);
    size_t slots[7];
    double values[7];
    for (size_t direction = 0; direction < 2; direction++) { // there, and back in the order of the computation
        for (size_t i = 0; i < 7; i++) {
            slots[i] = direction == 0 ? i : 13 - i;
            values[i] = table->values[slots[i]];
        }
        job *j = explorer_job_new(p, values, 7, 1, NULL);
        assert_non_null(j);
        expect_table(p, j, table, slots);
        explorer_job_free(j);
    }
    explorer_plan_free(p);
    whirl_result_free(result);
    explorer_case_free(object);
}

static void a_job_may_end_at_any_time(void **state) {
    (void)state;
    whirl_case *object = open_case();
    plan *p = open_plan(object);
    const double values[40] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.11, 0.21, 0.31, 0.41, 0.51};
    for (int turns = 0; turns < 70; turns += 10)
        for (int carried = 0; carried < 2; carried++) {
            job *j = explorer_job_new(p, values, 10, carried, NULL);
            assert_non_null(j);
            for (int i = 0; i < turns; i++) assert_true(explorer_job_turn(j) > 0.0);
            explorer_job_free(j);
        }
    explorer_plan_free(p);
    explorer_case_free(object);
}

static void a_motion_goes_on_where_it_was(void **state) {
    (void)state;
    whirl_case *object = open_case();
    plan *p = open_plan(object);
    double states[2][32 * 4], middle[4];
    motion *m = explorer_motion_new(p, 0.3, NULL, 30);
    assert_non_null(m);
    assert_int_equal(explorer_motion_samples(m), 32); // the next divisor of the steps
    assert_int_equal(explorer_motion_contacts(m), 0);
    assert_true(explorer_motion_turn(m, states[0], NULL));
    memcpy(middle, explorer_motion_state(m), sizeof middle);
    assert_memory_equal(states[0] + 31 * 4, middle, sizeof middle);
    assert_true(explorer_motion_turn(m, states[0], NULL));
    motion *again = explorer_motion_new(p, 0.3, middle, 30);
    assert_non_null(again);
    assert_true(explorer_motion_turn(again, states[1], NULL));
    assert_memory_equal(states[0], states[1], sizeof states[0]);
    explorer_motion_free(again);
    explorer_motion_free(m);
    explorer_plan_free(p);
    explorer_case_free(object);
}

/// Opens the case with a map in place of its sweep.
static whirl_case *open_map(void) {
    static const char map[] = "  map: {x: {parameter: r, from: 0.1, to: 0.5, points: 3},\n"
                              "        y: {parameter: sigma, values: [0.2, 0.4]}}\n";
    const char *sweep = strstr(text_of_case, "  sweep:"), *rest = strchr(sweep, '\n') + 1;
    char source[2048];
    const int length =
        snprintf(source, sizeof source, "%.*s%s%s", (int)(sweep - text_of_case), text_of_case, map, rest);
    whirl_case *object = explorer_case_new(source, (size_t)length, "t.yaml");
    assert_non_null(object);
    return object;
}

/// Computes a point of a map as the page does: the second parameter is assigned. The table has it in its block besides.
static void expect_cell(whirl_case *object, const whirl_table *table, size_t point) {
    char assigned[64];
    double end[4];
    snprintf(assigned, sizeof assigned, "sigma=%.17g", whirl_table_second(table, point));
    assert_true(explorer_assign(object, assigned));
    plan *p = explorer_plan_new(object, "map", NULL);
    assert_non_null(p);
    assert_non_null(explorer_plan_layout(p, table->values[point]));
    assert_int_equal(explorer_block_size(p) + 1, table->layout.size);
    double *block = calloc(table->layout.size, sizeof *block);
    job *j = explorer_job_new(p, &table->values[point], 1, 0, NULL);
    assert_true(block && j);
    while (explorer_job_turn(j) > 0.0) {
    }
    assert_int_equal(explorer_job_take(j, block, end), 0);
    assert_memory_equal(block, table->blocks + point * table->layout.size, explorer_block_size(p) * sizeof *block);
    explorer_job_free(j);
    free(block);
    explorer_plan_free(p);
}

static void cells_are_those_of_their_map(void **state) {
    (void)state;
    whirl_case *object = open_map();
    whirl_result *result;
    assert_int_equal(whirl_case_run(object, &(whirl_run_options){.threads = 1}, &result).code, WHIRL_OK);
    const whirl_table *table = &result->tables[0];
    assert_int_equal(table->count, 6);
    // A row of values is given, not the values of every point.
    const char *values = strstr(explorer_describe(object), "\"values\":[");
    assert_true(values && strcspn(values, "]") < 64);
    for (size_t point = 0; point < table->count; point++) expect_cell(object, table, point);
    whirl_result_free(result);
    explorer_case_free(object);
}

/// Follows the orbit of a row and checks its section and its bounds.
static void expect_row(const whirl_case *object, const whirl_table *table, size_t row) {
    const int revolutions = (int)*whirl_table_field(table, row, "trace/revolutions", 0);
    const double period = *whirl_table_field(table, row, "trace/period", 0);
    plan *p = explorer_plan_new(object, "branch", NULL);
    assert_non_null(p);
    explorer_plan_orbit(p, revolutions);
    assert_non_null(explorer_plan_layout(p, table->values[row]));
    assert_int_equal(explorer_orbit_size(p, revolutions, period), 2 * revolutions * 4);
    double *block = calloc(explorer_block_size(p), sizeof *block);
    assert_non_null(block);
    assert_true(explorer_orbit(p, table->values[row], revolutions, period,
                               whirl_table_field(table, row, "trace/nodes", 0), block));
    const double *section = block + whirl_layout_field(&p->layout, "poincare/section")->offset;
    const double *stored = whirl_table_field(table, row, "trace/section", 0);
    for (int n = 0; n < 4 * revolutions; n++) // the first row of the record is the end of the first revolution
        assert_true(fabs(section[n] - stored[(n + 4) % (4 * revolutions)]) < 1e-10);
    for (int c = 0; c < 2; c++) {
        const size_t low = whirl_layout_field(&p->layout, "orbit/low")->offset;
        const size_t high = whirl_layout_field(&p->layout, "orbit/high")->offset;
        assert_true(fabs(block[low + c] - whirl_table_field(table, row, "trace/low", 0)[c]) < 1e-10);
        assert_true(fabs(block[high + c] - whirl_table_field(table, row, "trace/high", 0)[c]) < 1e-10);
    }
    free(block);
    explorer_plan_free(p);
}

// Orbits of a result, unstable ones too, go round as the result says.
static void orbits_are_those_of_their_branch(void **state) {
    (void)state;
    static const char rub[] =
        "whirl: 1\nparameters: {omega: 3 rad/s}\nrotor:\n  speed: = omega\n  length_scale: 1 m\n"
        "  stations: {disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: 0.9 m}}\n  elements:\n"
        "    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}\n"
        "    - rub: {at: disc, gap: 1 m, stiffness: 10 N/m, friction: 0.05, law: paper}\n    - gravity: 0.5 m/s2\n"
        "study:\n  initial: {disc: {x: 0.1, y: -0.2}}\n  integrate: {transient: 200, record: 20}\n"
        "  branch: {parameter: omega, from: 3.0, to: 3.3, at: [3.0], segments: 2}\n";
    whirl_case *object = explorer_case_new(rub, strlen(rub), "t.yaml");
    assert_non_null(object);
    whirl_result *result;
    const whirl_run_options options = {.threads = 1};
    assert_int_equal(whirl_case_run(object, &options, &result).code, WHIRL_OK);
    const whirl_table *table = whirl_result_table(result, "branch");
    size_t unstable = 0;
    for (size_t row = 0; row < table->count; row += 5) {
        expect_row(object, table, row);
        unstable += *whirl_table_field(table, row, "trace/unstable", 0) > 0.0 &&
                    *whirl_table_field(table, row, "trace/revolutions", 0) == 2.0;
    }
    assert_true(unstable > 0);
    whirl_result_free(result);
    explorer_case_free(object);
}

// A diagram has no spectra but where it is asked for them.
static void spectra_are_asked_for(void **state) {
    (void)state;
    whirl_case *object = open_case();
    for (int asked = 0; asked < 2; asked++) {
        plan *p = explorer_plan_new(object, "sweep", NULL);
        assert_non_null(p);
        explorer_plan_diagram(p);
        if (asked) explorer_plan_spectra(p);
        const char *layout = explorer_plan_layout(p, 0.1);
        assert_non_null(layout);
        assert_true((strstr(layout, "\"spectrum/synchronous\"") != NULL) == (asked == 1));
        explorer_plan_free(p);
    }
    explorer_case_free(object);
}

// The same motion of the same length has a verdict if that length was requested, and none if it is a first look.
static void a_first_look_has_no_verdict(void **state) {
    (void)state;
    whirl_case *object = open_case();
    const double value = 0.45;
    for (int asked = 0; asked < 2; asked++) {
        plan *p = explorer_plan_new(object, "sweep", NULL);
        assert_non_null(p);
        if (asked) {
            assert_true(explorer_plan_number(p, "transient", 10) && explorer_plan_number(p, "settle", 1));
            explorer_plan_look(p, 10, 20, 64); // leaves nothing out
        } else {
            explorer_plan_look(p, 10, 0, 0);
        }
        explorer_plan_diagram(p);
        assert_non_null(explorer_plan_layout(p, value));
        double *block = calloc(explorer_block_size(p), sizeof *block);
        job *j = explorer_job_new(p, &value, 1, 0, NULL);
        assert_true(block && j);
        while (explorer_job_turn(j) > 0.0) continue;
        assert_int_equal(explorer_job_take(j, block, NULL), 0);
        const char *json = explorer_verdict(p, block);
        assert_non_null(strstr(json, asked ? "\"provisional\":false" : "\"provisional\":true"));
        if (!asked) {
            assert_int_equal(whirl_block_verdict(&p->layout, block).regime, WHIRL_UNDETERMINED);
            assert_non_null(strstr(json, "10 + 20 revolutions; a verdict takes the 40 + 20 that"));
        }
        explorer_job_free(j);
        free(block);
        explorer_plan_free(p);
    }
    explorer_case_free(object);
}

// The text of a case may have any character; between quotes of JSON it is escaped.
static void texts_are_escaped(void **state) {
    (void)state;
    whirl_case *object = open_case();
    const char *json = explorer_describe(object);
    assert_non_null(strstr(json, "\"title\":\"A \\\"rotor\\\" <b>\""));
    assert_non_null(strstr(json, "\"comment\":\"unbalance \\\\ \\\"eccentricity\\\"\""));
    text t = {0};
    json_text(&t, "a\tb\x01\xC3\xA9");
    json_next(&t);
    json_number(&t, NAN);
    json_next(&t);
    json_number(&t, 0.1);
    assert_string_equal(text_bytes(&t), "\"a\\u0009b\\u0001\xC3\xA9\",null,0.10000000000000001");
    free(t.bytes);
    explorer_case_free(object);
}

static void failures_leave_a_message(void **state) {
    (void)state;
    assert_null(explorer_case_new("whirl: 1\nx: 2\n", 14, "t.yaml"));
    assert_non_null(strstr(explorer_message(), "\"line\":2,\"column\":1,\"key\":\"x\""));
    whirl_case *object = open_case();
    assert_false(explorer_assign(object, "rr=2"));
    assert_non_null(strstr(explorer_message(), "no parameter is called rr"));
    assert_null(explorer_plan_new(object, "response", NULL));
    assert_null(explorer_edit(text_of_case, strlen(text_of_case), "rotor", "2"));
    plan *p = open_plan(object);
    assert_false(explorer_plan_number(p, "steps", 2.0));
    assert_false(explorer_plan_number(p, "transient", 1e10));
    assert_false(explorer_plan_number(p, "rtol", NAN));
    assert_true(explorer_plan_method(p, "euler"));
    const double value = 0.1;
    job *j = explorer_job_new(p, &value, 1, 0, NULL);
    assert_non_null(j);
    assert_true(explorer_job_turn(j) < 0.0);
    explorer_job_free(j);
    assert_non_null(strstr(explorer_message(), "no method is called 'euler'"));
    assert_null(explorer_motion_new(p, 0.1, NULL, 8));
    assert_null(explorer_machine(p, NAN));
    explorer_plan_free(p);
    explorer_case_free(object);
}

static const char text_of_runup[] = "whirl: 1\n"
                                    "rotor:\n"
                                    "  speed: 1 rad/s\n"
                                    "  length_scale: 1 m\n"
                                    "  stations: {disc: {mass: 1 kg, damping: 0.1 N.s/m, eccentricity: 1 m}}\n"
                                    "  elements:\n"
                                    "    - spring: {between: [disc, ground], stiffness: 1 N/m}\n"
                                    "    - rub: {at: disc, gap: 4 m, stiffness: 1 N/m, friction: 0.05, law: paper}\n"
                                    "    - rub: {at: disc, gap: 9 m, stiffness: 1 N/m, friction: 0.1, law: paper}\n"
                                    "study: {runup: {rate: 0.02 rad/s2, duration: 100 s, rows: 50, spectra: 5}}\n";

static void a_run_is_that_of_the_study(void **state) {
    (void)state;
    whirl_result *result;
    whirl_case *object = explorer_case_new(text_of_runup, strlen(text_of_runup), "t.yaml");
    assert_non_null(object);
    assert_true(explorer_assign(object, "runup.rate=0.03 rad/s2"));
    assert_int_equal(whirl_case_run(object, &(whirl_run_options){.threads = 1}, &result).code, WHIRL_OK);
    plan *p = explorer_plan_new(object, "", "");
    assert_non_null(p);
    assert_non_null(explorer_plan_layout(p, NAN));
    assert_int_equal(explorer_block_size(p), result->tables[0].layout.size);
    assert_float_equal(explorer_run_duration(p), 100.0, 0.0);
    double *block = calloc(explorer_block_size(p), sizeof *block);
    assert_non_null(block);
    assert_true(explorer_run(p, NAN, block));
    assert_memory_equal(block, result->tables[0].blocks, explorer_block_size(p) * sizeof *block);
    free(block);
    explorer_plan_free(p);
    whirl_result_free(result);
    explorer_case_free(object);
}

static void changed_numbers_are_named_as_the_command_takes_them(void **state) {
    (void)state;
    static const char *const names[] = {"runup.rate", "disc.eccentricity", "rub[1].friction", "rub[2].friction"};
    whirl_case *object = explorer_case_new(text_of_runup, strlen(text_of_runup), "t.yaml");
    assert_non_null(object);
    const char *levers = strstr(explorer_describe(object), "\"levers\":[");
    assert_non_null(levers);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char wanted[64];
        snprintf(wanted, sizeof wanted, "{\"name\":\"%s\"", names[i]);
        levers = strstr(levers, wanted);
        assert_non_null(levers);
    }
    assert_non_null(strstr(levers, "\"written\":\"0.1\",\"value\":0.1"));
    assert_null(strstr(levers, "stiffness"));
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char assignment[64];
        snprintf(assignment, sizeof assignment, "%s=0.04", names[i]);
        assert_true(explorer_assign(object, assignment));
    }
    assert_false(explorer_assign(object, "rub.friction=0.04"));
    explorer_case_free(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_those_of_a_study),
        cmocka_unit_test(spectra_are_asked_for),
        cmocka_unit_test(a_job_may_end_at_any_time),
        cmocka_unit_test(a_motion_goes_on_where_it_was),
        cmocka_unit_test(texts_are_escaped),
        cmocka_unit_test(failures_leave_a_message),
        cmocka_unit_test(a_first_look_has_no_verdict),
        cmocka_unit_test(orbits_are_those_of_their_branch),
        cmocka_unit_test(cells_are_those_of_their_map),
        cmocka_unit_test(a_run_is_that_of_the_study),
        cmocka_unit_test(changed_numbers_are_named_as_the_command_takes_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
