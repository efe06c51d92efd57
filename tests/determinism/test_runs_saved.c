// Run-ups that are stopped at random turns and continued from their saved state, in another machine of the same case,
// have the same bits as without the stops.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <math.h>

#include "support_check.h"
#include "support_runs.h"
#include "support_study.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/case.h"

/// A drive from rest through a critical speed, with a rub, a copy that follows, formulas, and events that change the
/// machine; spectra, orbits and waveforms.
static const char driven[] =
    "whirl: 1\n"
    "parameters: {k: 2e5, friction: 0.1}\n"
    "rotor:\n"
    "  speed: 6000 rpm\n"
    "  length_scale: 0.1 mm\n"
    "  stations:\n"
    "    disc: {mass: 2 kg, damping: 40 N.s/m, eccentricity: 20 um}\n"
    "  elements:\n"
    "    - spring:  {between: [disc, ground], stiffness: = k}\n"
    "    - gravity: 9.81 m/s2\n"
    "    - rub:     {at: disc, gap: 0.2 mm, stiffness: 1e6 N/m, friction: = friction, radius: 40 mm}\n"
    "    - drive:   {inertia: 0.004 kg.m2, torque: 0.8 N.m, no_load_speed: 9000 rpm, load_quadratic: 1e-7 N.m.s2}\n"
    "study:\n"
    "  runup:\n"
    "    duration: 2.6 s\n"
    "    rows: 50\n"
    "    samples: 32\n"
    "    spectra: 12\n"
    "    orbits: 5\n"
    "    waveform: 4\n"
    "    slow_roll: 600 rpm\n"
    "    ground_y: \"= time > 1 ? 3*sin(100*time) : 0\"\n"
    "    events:\n"
    "      - {name: touch, when: = disc_radius > 0.21e-3, change: {friction: 0.05}}\n"
    "      - {after: touch, time: 0.1 s, loss_at: disc, loss_moment: 2e-5 kg.m}\n"
    "      - {time: 2.2 s, trip: yes, change: {k: 2.1e5}}\n";

/// A motor on a shaft that twists, by time; its stiffness and inertia change.
static const char motor[] =
    "whirl: 1\n"
    "parameters: {k: 1500, inertia: 0.4}\n"
    "rotor:\n"
    "  speed: 1800 rpm\n"
    "  length_scale: 1 mm\n"
    "  stations:\n"
    "    motor: {polar: 0.089 kg.m2, moves: twist}\n"
    "    fan:   {polar: = inertia, moves: twist}\n"
    "  elements:\n"
    "    - coupling:        {between: [motor, fan], twist: = k, twist_damping: 0.2 N.m.s/rad}\n"
    "    - induction_motor: {at: motor, voltage: 220 V, frequency: 60 Hz, poles: 4, stator_resistance: 0.435 ohm,\n"
    "                        stator_reactance: 0.754 ohm, magnetizing_reactance: 26.13 ohm, rotor_reactance: 0.754 "
    "ohm,\n"
    "                        rotor_resistance: 0.816 ohm}\n"
    "    - short_circuit:   {at: motor, time: 1 s, torque: 30 N.m, frequency: 60 Hz, first: 4, second: -2,\n"
    "                        decay: 0.08 s}\n"
    "    - drive:           {at: fan, load_quadratic: 3.7e-4 N.m.s2}\n"
    "study:\n"
    "  runup: {duration: 1.5 s, rows: 60, samples: 32, orbits: 4, change: {k: 1400, inertia: 0.3}, change_time: 0.8 "
    "s}\n";

/// A rate after settling, and a dwell, of a disc that moves along its shaft, too.
static const char settled[] =
    "whirl: 1\n"
    "rotor:\n"
    "  speed: 1 rad/s\n"
    "  length_scale: 1 m\n"
    "  stations:\n"
    "    disc: {mass: 1 kg, damping: 0.1 N.s/m, eccentricity: 1 m, axial: yes}\n"
    "  elements:\n"
    "    - spring: {between: [disc, ground], along: axial, stiffness: 2 N/m, damping: 0.1}\n"
    "    - force:  {at: disc, axial: 1 N}\n"
    "    - spring: {between: [disc, ground], stiffness: 1 N/m}\n"
    "    - rub:    {at: disc, gap: 4 m, stiffness: 5 N/m, friction: 0.1, law: paper}\n"
    "study:\n"
    "  runup: {rate: 0.003 rad/s2, speed_from: 2 rad/s, speed_to: 0.5 rad/s, begin: steady, "
    "settle: 30, duration: 600 s,\n"
    "          rows: 40, samples: 32, waveform: 3, spectra: 8, spectrum_turns: 4, orbits: 5}\n";

/// Two shafts with speeds of their own that rub on each other: the turns of the second one go on over the stops.
static const char two_shafts[] =
    "whirl: 1\n"
    "rotor:\n"
    "  speed: 300 rad/s\n"
    "  length_scale: 1 mm\n"
    "  shafts: {low: {}, high: {speed: -420 rad/s}}\n"
    "  stations:\n"
    "    a: {shaft: low, mass: 10 kg, damping: 150 N.s/m, eccentricity: 0.3 mm}\n"
    "    b: {shaft: high, mass: 6 kg, damping: 90 N.s/m}\n"
    "  elements:\n"
    "    - shaft: {between: [a, ground], k1: 4e5 N/m}\n"
    "    - shaft: {between: [b, ground], k1: 3e5 N/m}\n"
    "    - unbalance: {at: b, moment: 1.2e-3 kg.m}\n"
    "    - contact: {at: a, from: b, gap: 1 mm, stiffness: 3e6, power: 1, friction: 0.2, radius: 60 mm, slip_speed: "
    "0.5 "
    "m/s}\n"
    "    - gravity: 9.81 m/s2\n"
    "    - drive: {inertia: 0.05 kg.m2, torque: 6 N.m, no_load_speed: 300 rad/s}\n"
    "    - drive: {shaft: high, inertia: 0.02 kg.m2, torque: 4 N.m, no_load_speed: 450 rad/s}\n"
    "study:\n"
    "  runup: {duration: 3 s, rows: 30, samples: 32, shafts: {high: {}}, events: [{shaft: high, speed: 100 rad/s, "
    "loss_at: "
    "b,\n"
    "          loss_moment: 5e-4 kg.m}, {shaft: high, speed: 130 rad/s, trip: yes}]}\n";

/// A run that is stopped after some turns, and the state that was saved there.
typedef struct stopping {
    int turns, at; ///< turns so far, and after how many to save and stop; -1: never
    whirl_stop stop;
    void *bytes;
    size_t size;
} stopping;

static bool stopping_due(void *context) {
    stopping *own = context;
    return own->turns++ == own->at;
}

static void stopping_save(void *context, double turns, const void *bytes, size_t size) {
    stopping *own = context;
    (void)turns;
    free(own->bytes);
    own->bytes = malloc(size);
    assert_non_null(own->bytes);
    memcpy(own->bytes, bytes, own->size = size);
    own->stop = true;
}

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

/// Computes the run of a case, from a state unless that is NULL, to its end or where it is stopped. Returns its block
/// [*size], to be freed; NULL: stopped.
static double *compute(const char *text, void *state, size_t bytes, stopping *how, size_t *size) {
    whirl_case *object = case_of_text(text);
    whirl_study study;
    whirl_machine machine;
    whirl_layout *layout = calloc(1, sizeof *layout);
    require_ok(whirl_case_study(object, &study));
    const whirl_batch *batch = &study.batches[0];
    const run_point at = {.study = &study, .value = NAN, .stop = &how->stop};
    require_ok(run_point_machine(&at, 0.0, NULL, &machine));
    assert_non_null(layout);
    require_ok(whirl_layout_new(machine.system, &batch->integrate, &batch->record, batch->analyses, layout));
    double *block = malloc(layout->size * sizeof *block);
    const whirl_saving saving = {state, bytes, stopping_due, stopping_save, how};
    const whirl_resting point = {.system = machine.system,
                                 .start = machine.start,
                                 .clock = machine.clock,
                                 .speed = machine.speed,
                                 .at_speed = make_at_speed,
                                 .at_speeds = run_point_machine,
                                 .running = make_running,
                                 .context = &at,
                                 .drive_speed = machine.drive_speed,
                                 .course = machine.course,
                                 .saving = &saving,
                                 .stop = &how->stop};
    assert_non_null(block);
    const whirl_status status = whirl_analyze_resting(&point, &batch->record, batch->analyses, layout, block);
    *size = layout->size * sizeof *block;
    machine.release(machine.owner);
    whirl_case_free(object);
    free(layout);
    if (status.code == WHIRL_STOPPED) {
        free(block);
        return NULL;
    }
    require_ok(status);
    return block;
}

/// Computes the run in pieces: it is killed after 0 to `most` turns, again and again.
static double *compute_in_pieces(const char *text, unsigned *seed, int most, int *kills, size_t *size) {
    stopping how = {.at = -1};
    void *state = NULL;
    size_t bytes = 0;
    double *block = NULL;
    while (!block) {
        *seed = *seed * 1664525u + 1013904223u;
        how = (stopping){.at = (int)(*seed >> 8) % (most + 1)};
        block = compute(text, state, bytes, &how, size);
        if (!block) {
            assert_non_null(how.bytes);
            free(state);
            state = how.bytes;
            bytes = how.size;
            ++*kills;
        } else {
            free(how.bytes);
        }
    }
    free(state);
    return block;
}

static void runs_in_pieces(void **state) {
    static const char *const cases[] = {driven, motor, settled, two_shafts};
    unsigned seed = 20261130u;
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        stopping never = {.at = -1};
        size_t size, own;
        double *whole = compute(cases[i], NULL, 0, &never, &size);
        for (int tries = 0; tries < 3; tries++) {
            static const int most[] = {20, 8, 3};
            int kills = 0;
            double *pieces = compute_in_pieces(cases[i], &seed, most[tries], &kills, &own);
            assert_true(kills >= 2);
            assert_int_equal(size, own);
            assert_memory_equal(whole, pieces, size);
            free(pieces);
        }
        free(whole);
    }
}

/// With a state that is cut or too long, or that of another run, the point begins again.
static void states_that_do_not_fit(void **state) {
    stopping how = {.at = -1}, other = {.at = 10};
    size_t size, own;
    (void)state;
    double *whole = compute(settled, NULL, 0, &how, &size);
    assert_null(compute(driven, NULL, 0, &other, &own));
    for (size_t cut = 0; cut < 3; cut++) {
        how = (stopping){.at = -1};
        double *again = compute(settled, other.bytes,
                                cut == 0   ? other.size
                                : cut == 1 ? other.size / 2
                                           : 0,
                                &how, &own);
        assert_int_equal(size, own);
        assert_memory_equal(whole, again, size);
        free(again);
    }
    free(other.bytes);
    free(whole);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(runs_in_pieces), cmocka_unit_test(states_that_do_not_fit)};
    return cmocka_run_group_tests_name("runs that are saved", tests, NULL, NULL);
}
