// Run-ups that are carried together, in vector lanes where these take their machines: every point has the same bits
// alone, among others, at any place among them, and in all instruction sets that fuse, and in all that do not.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <stdio.h>

#include "support_check.h"
#include "support_runs.h"
#include "support_study.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/case.h"
#include "whirl/engine/result.h"

/// A rotor in a film with a rub at its disc, whose speed has a rate: p is the stiffness of its shaft.
#define PAIR                                                                                                           \
    "  length_scale: 0.2 mm\n"                                                                                         \
    "  stations:\n"                                                                                                    \
    "    disc:    {mass: 420 kg, damping: 4300 N.s/m, eccentricity: 16 um}\n"                                          \
    "    journal: {mass: 100 kg, damping: 9300 N.s/m}\n"                                                               \
    "  elements:\n"                                                                                                    \
    "    - shaft:   {between: [disc, journal], k1: = p*300e6, k2: 528 MN/m, signs: paper}\n"                           \
    "    - film:    {at: journal, count: 2, clearance: 0.2 mm, load: 1900 N}\n"                                        \
    "    - rub:     {at: disc, gap: 0.24 mm, stiffness: 5 GN/m, friction: 0.1}\n"                                      \
    "    - gravity\n"

/// A motor that drives a disc through its critical speed, with events: p is its torque.
#define MOTOR                                                                                                          \
    "  length_scale: 0.1 mm\n"                                                                                         \
    "  stations:\n"                                                                                                    \
    "    disc: {mass: 2 kg, damping: 40 N.s/m, eccentricity: 20 um}\n"                                                 \
    "  elements:\n"                                                                                                    \
    "    - spring:  {between: [disc, ground], stiffness: = k}\n"                                                       \
    "    - gravity: 9.81 m/s2\n"                                                                                       \
    "    - rub:     {at: disc, gap: 0.2 mm, stiffness: 1e6 N/m, friction: = friction, radius: 40 mm}\n"                \
    "    - drive:   {inertia: 0.004 kg.m2, torque: = 0.8*p, no_load_speed: 9000 rpm, load_quadratic: 1e-7 N.m.s2}\n"

/// A shaft of finite elements with discs that tilt, driven by a motor.
#define TURBINE                                                                                                        \
    "  length_scale: 0.1 mm\n"                                                                                         \
    "  shafts: {shaft: {mesh_to: 1 kHz, modes: 6}}\n"                                                                  \
    "  stations:\n"                                                                                                    \
    "    left:  {position: 0 m}\n"                                                                                     \
    "    wheel: {position: 0.3 m}\n"                                                                                   \
    "    right: {position: 0.5 m}\n"                                                                                   \
    "  elements:\n"                                                                                                    \
    "    - segment: {length: 0.5 m, outer: 40 mm}\n"                                                                   \
    "    - disc:    {at: wheel, outer: 0.3 m, width: 30 mm}\n    - unbalance: {at: wheel, moment: = p*1e-4}\n"         \
    "    - spring:  {between: [left, ground], stiffness: 1e7, damping: 2000}\n"                                        \
    "    - cubic_spring: {between: [right, ground], stiffness: 1e7, cubic: 1e15, damping: 2000}\n"                     \
    "    - gravity\n"                                                                                                  \
    "    - drive:   {inertia: 0.3 kg.m2, torque: 40 N.m, load_linear: 0.01 N.m.s}\n"

/// A rotor that a motor drives, in a film without drag: p is the torque.
#define DRIVEN                                                                                                         \
    "  length_scale: 0.1 mm\n"                                                                                         \
    "  stations:\n"                                                                                                    \
    "    left: {mass: 4 kg}\n    fan:  {mass: 40 kg, eccentricity: 30 um}\n"                                           \
    "  elements:\n"                                                                                                    \
    "    - shaft:   {between: [left, fan], k1: 8e6 N/m, k2: 9e6 N/m}\n"                                                \
    "    - spring:  {between: [fan, ground], stiffness: 6e6 N/m, damping: 200 N.s/m}\n"                                \
    "    - film:    {at: left, law: short, clearance: 0.1 mm, radius: 30 mm, length: 15 mm, viscosity: 20 mPa.s}\n"    \
    "    - gravity: 9.81 m/s2\n"                                                                                       \
    "    - drive:   {inertia: 0.6 kg.m2, torque: = 60*p, no_load_speed: 9000 rpm, load_quadratic: 5e-5 N.m.s2}\n"

/// A rotor in a housing, with friction that sticks; p is the damping of the rotor, 0 at one of the points.
#define HOUSING                                                                                                        \
    "  length_scale: 0.1 mm\n"                                                                                         \
    "  stations:\n"                                                                                                    \
    "    rotor:  {mass: 10 kg, damping: = 300*(p - 0.8), eccentricity: 40 um}\n"                                       \
    "    stator: {mass: 2 kg, damping: 3 kN.s/m}\n"                                                                    \
    "  elements:\n"                                                                                                    \
    "    - spring: {between: [stator, ground], stiffness: 8 MN/m}\n"                                                   \
    "    - spring: {between: [rotor, ground], stiffness: 4 MN/m}\n"                                                    \
    "    - gravity\n"                                                                                                  \
    "    - rub: {at: rotor, gap: 0.15 mm, stiffness: 3e7, damping: 100, friction: 0.2, law: slip, radius: 40 mm}\n"    \
    "    - %s\n"

#define CASE(machine, speed, run)                                                                                      \
    "whirl: 1\nparameters: {p: 1, k: 2e5, friction: 0.1}\nrotor:\n  speed: " speed "\n" machine                        \
    "study:\n  runup: {parameter: p, from: 0.8, to: 1.2, points: 5, rows: 20, samples: 32, " run "}\n"

static const char *const cases[] = {
    CASE(PAIR, "650 rad/s",
         "rate: 900 rad/s2, speed_from: 350 rad/s, speed_to: 700 rad/s, orbits: 3, spectra: 2, "
         "spectrum_turns: 8"),
    CASE(PAIR, "650 rad/s", "rate: 3000 rad/s2, speed_from: 700 rad/s, speed_to: 300 rad/s, sensitivity: no"),
    CASE(TURBINE, "6000 rpm", "rate: 900 rad/s2, speed_from: 4000 rpm, speed_to: 5000 rpm, method: rodas5p"),
    CASE(DRIVEN, "6000 rpm",
         "duration: 0.7 s, drag: no, stationary: 0, speed_from: 3000 rpm, method: rodas5p, sensitivity: no, loss_at: "
         "fan, "
         "loss_moment: 2e-4 kg.m, loss_time: 0.3 s, trip_time: 0.5 s"),
    // Lanes do not take formulas of the rate, and leave them to each run.
    CASE(PAIR, "650 rad/s",
         "rate_law: = 2000 + 100*sin(9*time), speed_from: 350 rad/s, speed_to: 600 rad/s, duration: 0.1 s"),
    CASE(PAIR, "650 rad/s", "rate: 3000 rad/s2, speed_from: 350 rad/s, speed_to: 600 rad/s, method: rodas5p"),
    CASE(MOTOR, "6000 rpm",
         "duration: 2.4 s, drag: no, orbits: 3, waveform: 4, slow_roll: 600 rpm, events: [{name: touch, when: = "
         "disc_radius > "
         "0.21e-3, change: {friction: 0.05}}, {after: touch, time: 0.1 s, loss_at: disc, loss_moment: 2e-5 kg.m}, "
         "{time: 2.2 s, trip: yes, change: {k: 2.1e5}}]"),
    CASE(MOTOR, "6000 rpm",
         "duration: 1.5 s, speed_from: 2000 rpm, begin: steady, settle: 20, trip_speed: 3500 rpm, "
         "loss_at: disc, loss_moment: 3e-5 kg.m, loss_speed: 3200 rpm, stationary: 10"),
    CASE(TURBINE, "6000 rpm", "duration: 0.3 s, speed_from: 500 rpm"),
    CASE(TURBINE, "6000 rpm", "rate: 900 rad/s2, speed_from: 4000 rpm, speed_to: 5000 rpm, sensitivity: yes"),
};

/// Elements of the machine in a housing; the last ones are left to each run.
static const char *const elements[] = {
    "cubic_spring: {between: [rotor, stator], stiffness: 1 MN/m, cubic: 1e15, damping: 300}",
    "contact: {at: rotor, from: stator, gap: 60 um, stiffness: 3e7, radius: 40 mm, friction: 0.1, law: hunt_crossley, "
    "loss: 0.5, friction_law: stribeck, static_friction: 0.2, stribeck_speed: 0.1 m/s}",
    "film: {at: rotor, from: stator, clearance: 0.3 mm, viscosity: 10 mPa.s, radius: 25 mm, length: 15 mm}",
    "seal: {at: rotor, from: stator, clearance: 0.3 mm, stiffness: 1e5, damping: 300, mass: 1, ratio: 0.4}",
    "magnetic: {at: rotor, from: stator, gap: 0.5 mm, bias: 3 A, turns: 120, area: 4 cm2, max_current: 5 A, "
    "proportional: 2e4, integral: 1e5, derivative: 40, derivative_filter: 0.2 ms}",
    "tilting_pad: {at: rotor, from: stator, shape: tilting-5, preload: 0.5, clearance: 0.2 mm, viscosity: 10 mPa.s, "
    "radius: 25 mm, length: 25 mm, inertia: 1e-4 kg m2}",
};
static const char housing[] =
    CASE(HOUSING, "6000 rpm",
         "rate: 2000 rad/s2, speed_from: 5000 rpm, speed_to: 6000 rpm, begin: steady, settle: 3, method: %s");

/// Index of the case that lanes do not carry; number of the elements that they do.
enum { CASE_FORMULA = 4, ELEMENTS_IN_LANES = 4 };

enum { POINTS = 5 };

// ---------------------------------------------------------------- computing points

static whirl_status make_running(const void *context, double lowest, double highest, bool is_driven,
                                 const whirl_spool_range *spools, size_t count, const unsigned char *happened,
                                 whirl_running **running) {
    run_point at = *(const run_point *)context;
    at.count = count;
    at.events = happened;
    return whirl_running_new(run_point_machine, &at, lowest, highest, is_driven, spools, running);
}

static whirl_status make_at_speed(const void *context, double speed, whirl_variant variant, double value,
                                  whirl_machine *machine) {
    (void)variant, (void)value;
    return run_point_machine(context, speed, NULL, machine);
}

/// Points of a case, and their blocks.
typedef struct fan {
    size_t size;            ///< bytes of a block
    double *blocks[POINTS]; ///< of point k
} fan;

static void fan_free(fan *of) {
    for (size_t k = 0; k < POINTS; k++) free(of->blocks[k]);
}

/// Computes points of a case together, in the order in which they are listed. Returns false if the processor lacks the
/// instruction set.
static bool compute(const char *text, size_t count, const size_t *which, fan *out) {
    whirl_case *object = case_of_text(text);
    whirl_study study;
    whirl_machine machines[POINTS];
    run_point at[POINTS];
    whirl_resting points[POINTS];
    whirl_status statuses[POINTS];
    double *blocks[POINTS];
    whirl_layout *layout = calloc(1, sizeof *layout);
    assert_non_null(layout);
    require_ok(whirl_case_study(object, &study));
    const whirl_batch *batch = &study.batches[0];
    for (size_t i = 0; i < count; i++) {
        statuses[i] = whirl_ok();
        at[i] = (run_point){.study = &study, .value = 0.8 + 0.1 * (double)which[i]};
        require_ok(run_point_machine(&at[i], 0.0, NULL, &machines[i]));
        points[i] = (whirl_resting){.system = machines[i].system,
                                    .start = machines[i].start,
                                    .clock = machines[i].clock,
                                    .speed = machines[i].speed,
                                    .at_speed = make_at_speed,
                                    .running = make_running,
                                    .context = &at[i],
                                    .drive_speed = machines[i].drive_speed,
                                    .course = machines[i].course};
    }
    require_ok(whirl_layout_new(machines[0].system, &batch->integrate, &batch->record, batch->analyses, layout));
    out->size = layout->size * sizeof(double);
    for (size_t i = 0; i < count; i++) {
        blocks[i] = out->blocks[which[i]] = malloc(out->size);
        assert_non_null(blocks[i]);
    }
    require_ok(
        whirl_analyze_resting_together(count, points, &batch->record, batch->analyses, layout, blocks, statuses));
    const bool has = statuses[0].code != WHIRL_BAD_INPUT || !strstr(statuses[0].message, "WHIRL_ISA");
    for (size_t i = 0; i < count; i++) {
        if (has) require_ok(statuses[i]);
        machines[i].release(machines[i].owner);
    }
    free(layout);
    whirl_case_free(object);
    return has;
}

// ---------------------------------------------------------------- comparisons

static void check_same(const fan *one, const fan *other, const char *text, const char *what) {
    assert_int_equal(one->size, other->size);
    for (size_t k = 0; k < POINTS; k++)
        if (one->blocks[k] && other->blocks[k] && memcmp(one->blocks[k], other->blocks[k], one->size) != 0)
            fail_msg("point %zu differs %s:\n%s", k, what, text);
}

/// Computes all points of a case with an instruction set; returns false if the processor lacks it.
static bool compute_with(const char *set, const char *text, fan *out) {
    static const size_t all[POINTS] = {0, 1, 2, 3, 4};
    setenv("WHIRL_ISA", set, 1);
    const bool has = compute(text, POINTS, all, out);
    unsetenv("WHIRL_ISA");
    if (!has) fan_free(out);
    return has;
}

static void check_case(const char *text) {
    static const size_t all[POINTS] = {0, 1, 2, 3, 4}, mixed[POINTS] = {3, 0, 4, 2, 1};
    fan together = {0}, other = {0};
    compute(text, POINTS, all, &together);
    compute(text, POINTS, mixed, &other);
    check_same(&together, &other, text, "at another place");
    fan_free(&other);
    other = (fan){0};
    for (size_t k = 0; k < POINTS; k++) compute(text, 1, &k, &other);
    check_same(&together, &other, text, "alone");
    fan_free(&other);
    fan_free(&together);
}

static void check_sets(const char *text) {
    static const char *const families[][3] = {{"fma", "avx2", "avx512"}, {"scalar", "simd128", ""}};
    for (size_t f = 0; f < 2; f++) {
        fan first = {0};
        bool any = false;
        for (size_t s = 0; s < 3 && *families[f][s]; s++) {
            fan own = {0};
            if (!compute_with(families[f][s], text, &own)) continue;
            if (any) check_same(&first, &own, text, families[f][s]);
            if (any)
                fan_free(&own);
            else
                first = own;
            any = true;
        }
        fan_free(&first);
    }
}

static void runs_depend_on_no_neighbour(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) check_case(cases[i]);
}

static void elements_depend_on_no_neighbour(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof elements / sizeof *elements; i++) {
        char text[sizeof housing + 512];
        for (int m = 0; m < (i < ELEMENTS_IN_LANES ? 2 : 1); m++) {
            snprintf(text, sizeof text, housing, elements[i], m == 0 ? "dop853" : "rodas5p");
            check_case(text);
        }
    }
}

static void instruction_sets_agree(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        if (i != CASE_FORMULA) check_sets(cases[i]);
}

/// Returns true if lanes take the machine of a case, at a given rate.
static bool goes_in_lanes(const char *text) {
    whirl_case *object = case_of_text(text);
    whirl_study study;
    whirl_running *running;
    require_ok(whirl_case_study(object, &study));
    const run_point at = {.study = &study, .value = 1.0};
    require_ok(whirl_running_new(run_point_machine, &at, 300.0, 700.0, false, NULL, &running));
    const bool goes = running->in_lanes(running, true) != NULL;
    running->release(running);
    whirl_case_free(object);
    return goes;
}

/// The machines above are carried in lanes, but those with states that stand for derivatives by the angle.
static void lanes_take_most_machines(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) assert_true(goes_in_lanes(cases[i]));
    for (size_t i = 0; i < sizeof elements / sizeof *elements; i++) {
        char text[sizeof housing + 512];
        snprintf(text, sizeof text, housing, elements[i], "dop853");
        assert_int_equal(goes_in_lanes(text), i < ELEMENTS_IN_LANES);
    }
}

/// The points of a fan by all threads are those of one thread.
static void threads_change_nothing(void **state) {
    whirl_result *results[2];
    (void)state;
    for (int k = 0; k < 2; k++) {
        whirl_case *object = case_of_text(cases[0]);
        require_ok(whirl_case_run(object, &(whirl_run_options){.threads = k == 0 ? 1 : 3}, &results[k]));
        whirl_case_free(object);
    }
    const whirl_table *one = &results[0]->tables[0], *three = &results[1]->tables[0];
    for (size_t i = 0; i < POINTS * one->layout.size; i++)
        assert_memory_equal(&one->blocks[i], &three->blocks[i], sizeof *one->blocks);
    for (size_t k = 0; k < 2; k++) whirl_result_free(results[k]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runs_depend_on_no_neighbour), cmocka_unit_test(elements_depend_on_no_neighbour),
        cmocka_unit_test(instruction_sets_agree), cmocka_unit_test(lanes_take_most_machines),
        cmocka_unit_test(threads_change_nothing)};
    return cmocka_run_group_tests_name("runs that are carried together", tests, NULL, NULL);
}
