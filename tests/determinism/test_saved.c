// Motions that were saved under way and continued in another run, and motions that had to wait for lanes, have the same
// bits as without the stop and as each motion alone.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "machines.h"

enum { MOTIONS = 5, CROWD = 24, MANY = 96, TRANSIENT = 20, RECORD = 10, SAVES = 512 };

/// Motions, their records, and their states after the save number `wanted`.
typedef struct motions {
    whirl_rotor *rotors[MANY];
    double start[8];
    whirl_task tasks[MANY];
    whirl_record *records[MANY];
    size_t count, given;
    int calls, wanted; ///< saves so far; number of the save whose states are stored, -1: none
    void *states[MANY];
    size_t sizes[MANY];
    double turned[MANY]; ///< revolutions at the last save
    bool waited[SAVES];  ///< whether a motion had not gone on since the save before
} motions;

/// Counts the save after a revolution, and stores the states of the save number `wanted`.
static void save_states(motions *m, const whirl_motion_state *states, size_t count) {
    const int call = m->calls++;
    for (size_t i = 0; i < count; i++) {
        const ptrdiff_t number = (const whirl_task *)states[i].task.tag - m->tasks;
        if (call > 0 && call < SAVES && states[i].revolutions == m->turned[number]) m->waited[call] = true;
        m->turned[number] = states[i].revolutions;
        if (call != m->wanted) continue;
        m->states[number] = malloc(states[i].size);
        assert_non_null(m->states[number]);
        memcpy(m->states[number], states[i].bytes, states[i].size);
        m->sizes[number] = states[i].size;
    }
}

/// Adds the next motion, from its state if it has one.
static void add_next(motions *m, whirl_recorder *recorder) {
    const size_t number = m->given++;
    must(whirl_recorder_add(recorder, &m->tasks[number], m->states[number], m->sizes[number]));
    m->states[number] = NULL;
}

static void prepare_some(motions *m, size_t count) {
    *m = (motions){.start = {0, -0.1, 0, -0.1}, .count = count, .wanted = -1};
    for (size_t i = 0; i < count; i++) {
        // With rub and without.
        m->rotors[i] = paper_rotor(1.0 - (double)i / (double)count);
        m->tasks[i] = (whirl_task){whirl_rotor_system(m->rotors[i]), m->start, &m->tasks[i]};
    }
}

static void prepare(motions *m) {
    prepare_some(m, MOTIONS);
}

static void forget(motions *m) {
    for (size_t i = 0; i < m->count; i++) {
        whirl_rotor_free(m->rotors[i]);
        whirl_record_free(m->records[i]);
        free(m->states[i]);
    }
}

/// Records all motions in `lanes` lanes or a few more (0: as many as the recorder likes), or stops after the wanted
/// save. Returns the revolutions that were computed.
static size_t record_in(motions *m, const char *method, const whirl_record_options *options, size_t lanes) {
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_recorder *recorder;
    size_t turned = 1, sum = 0;
    strcpy(integrate.method, method);
    integrate.located = options->settle && lanes == 0; // both in one of the kinds
    integrate.steps_per_revolution = 128;
    must(whirl_recorder_new(m->tasks[0].system, &integrate, options, lanes, &recorder));
    for (; turned > 0 && !(m->wanted >= 0 && m->calls > m->wanted); sum += turned) {
        whirl_task task;
        whirl_record *record;
        must(whirl_recorder_begin(recorder));
        while (m->given < m->count && whirl_recorder_has_room(recorder)) add_next(m, recorder);
        must(whirl_recorder_revolve(recorder, &turned));
        while (whirl_recorder_take(recorder, &task, &record))
            m->records[(const whirl_task *)task.tag - m->tasks] = record;
        size_t count;
        whirl_motion_state *states = whirl_recorder_save(recorder, &count);
        if (states) save_states(m, states, count);
        whirl_motion_states_free(states, count);
    }
    whirl_recorder_free(recorder);
    return sum;
}

static size_t record(motions *m, const char *method, const whirl_record_options *options) {
    return record_in(m, method, options, 0);
}

static void expect_same(const double *a, const double *b, size_t count) {
    assert_memory_equal(a, b, count * sizeof *a);
}

static void expect_same_records(const whirl_record *a, const whirl_record *b) {
    assert_true(a->motion == b->motion && a->revolutions == b->revolutions && a->diverged_at == b->diverged_at);
    assert_true(a->section_count == b->section_count && a->growth_count == b->growth_count &&
                a->sample_count == b->sample_count);
    expect_same(a->section, b->section, a->section_count * a->dimension);
    expect_same(a->growth, b->growth, a->growth_count);
    assert_true((a->growths == NULL) == (b->growths == NULL));
    if (a->growths) expect_same(a->growths, b->growths, a->growth_count * a->dimension);
    if (a->volume) expect_same(a->volume, b->volume, a->growth_count);
    expect_same(a->waveform, b->waveform, 2 * a->probe_count * a->sample_count);
    expect_same(a->low, b->low, a->dimension);
    expect_same(a->high, b->high, a->dimension);
    expect_same(a->end, b->end, a->dimension);
#define SAME(array, extent, columns, ...)                                                                              \
    expect_same(a->array, b->array, WHIRL_WATCHED_SIZE(extent, columns, a->probe_count, a->contact_count));
    WHIRL_WATCHED(SAME)
#undef SAME
}

static whirl_record_options options_of(whirl_growth growth, bool settle) {
    whirl_record_options options = whirl_record_default();
    options.transient = TRANSIENT;
    options.record = RECORD;
    options.growth = growth;
    options.settle = settle;
    return options;
}

/// Saves after `wanted` + 1 revolutions (of the first motion, where they run one after the other), loads the states,
/// and checks that the end is the same.
static void expect_same_after(const motions *whole, size_t all, const char *method, const whirl_record_options *options,
                              int wanted) {
    motions first, second;
    prepare(&first);
    prepare(&second);
    first.wanted = wanted;
    record(&first, method, options);
    size_t states = 0;
    for (size_t i = 0; i < MOTIONS; i++) {
        states += first.states[i] != NULL;
        second.states[i] = first.states[i];
        second.sizes[i] = first.sizes[i];
        first.states[i] = NULL;
    }
    assert_true(states == MOTIONS || states == 1);
    const size_t computed = record(&second, method, options);
    assert_int_equal(computed, all - states * (size_t)(wanted + 1));
    for (size_t i = 0; i < MOTIONS; i++) expect_same_records(whole->records[i], second.records[i]);
    forget(&first);
    forget(&second);
}

static void every_moment(const char *method, const int *moments, size_t count) {
    const whirl_growth growths[] = {WHIRL_GROWTH_LARGEST, WHIRL_GROWTH_NONE, WHIRL_GROWTH_LARGEST, WHIRL_GROWTH_ALL};
    const int kinds = strncmp(method, "cvode", 5) == 0 ? 3 : 4; // CVODE takes no perturbations along
    for (int kind = 0; kind < kinds; kind++) {
        const whirl_record_options options = options_of(growths[kind], kind == 2);
        motions whole;
        prepare(&whole);
        const size_t all = record(&whole, method, &options);
        assert_int_equal(all, MOTIONS * (TRANSIENT + RECORD));
        for (size_t i = 0; i < count; i++) expect_same_after(&whole, all, method, &options, moments[i]);
        forget(&whole);
    }
}

/// Saved in the transient, before and after the perturbation begins (10), before and after the record begins (20).
static void side_by_side(void **state) {
    const int moments[] = {0, 4, 8, 9, 10, 15, 18, 19, 20, 21, 27, 28};
    (void)state;
    every_moment("rk4", moments, sizeof moments / sizeof *moments);
    every_moment("dop853", moments, sizeof moments / sizeof *moments);
}

static whirl_record_options options_of_orbits(void) {
    whirl_record_options options = options_of(WHIRL_GROWTH_LARGEST, true);
    options.transient = 400;
    options.orbits = true;
    return options;
}

/// Checks that the same motions and orbits follow if all is saved at this moment and loaded.
static void expect_same_orbits_after(const motions *whole, const char *method, const whirl_record_options *options,
                                     int wanted) {
    motions first, second;
    prepare_some(&first, whole->count);
    prepare_some(&second, whole->count);
    first.wanted = wanted;
    record(&first, method, options);
    for (size_t i = 0; i < whole->count; i++) {
        second.states[i] = first.states[i];
        second.sizes[i] = first.sizes[i];
        first.states[i] = NULL;
    }
    record(&second, method, options);
    for (size_t i = 0; i < whole->count; i++) {
        const whirl_record_orbit *a = &whole->records[i]->orbit, *b = &second.records[i]->orbit;
        expect_same_records(whole->records[i], second.records[i]);
        assert_true(a->set_at == b->set_at && a->residual == b->residual && a->revolutions == b->revolutions);
        expect_same(a->multipliers, b->multipliers, 2 * a->multiplier_count);
    }
    forget(&first);
    forget(&second);
}

/// Saved before an orbit is searched, after it is found, and on it.
static void looking_for_orbits(void **state) {
    const whirl_record_options options = options_of_orbits();
    motions whole;
    (void)state;
    prepare(&whole);
    record(&whole, "rk4", &options);
    size_t ended = 0;
    for (size_t i = 0; i < MOTIONS; i++) ended += whole.records[i]->orbit.set_at > 0.0;
    assert_true(ended > 0);
    for (int wanted = 24; wanted < 64; wanted += 3) expect_same_orbits_after(&whole, "rk4", &options, wanted);
    forget(&whole);
}

/// Saved while motions wait for the result of Newton's method: with dop853 many others go on meanwhile.
static void waiting_for_orbits(void **state) {
    enum { EVERY = 48 };
    whirl_record_options options = options_of_orbits();
    motions whole;
    int moments = 0;
    (void)state;
    options.growth = WHIRL_GROWTH_NONE;
    prepare_some(&whole, CROWD);
    record(&whole, "dop853", &options);
    for (int call = 0; call < SAVES; call++)
        if (whole.waited[call] && moments++ % EVERY == 0) expect_same_orbits_after(&whole, "dop853", &options, call);
    assert_true(moments > 0);
    forget(&whole);
}

/// Motions settle and move to their orbits after different numbers of revolutions. With few lanes perturbed copies take
/// lanes and return them while other motions are recorded. Every record is that of the motion alone: sections,
/// waveforms, bounds and all watched sums.
static void waiting_for_lanes(void **state) {
    whirl_record_options options = options_of_orbits();
    motions alone, crowd;
    (void)state;
    options.transient = 88;
    options.watch = 35;
    prepare_some(&alone, MANY);
    for (alone.count = 1; alone.count <= MANY; alone.count++) record_in(&alone, "dop853", &options, 1);
    alone.count = MANY;
    for (size_t lanes = 8; lanes <= 32; lanes += 8) {
        prepare_some(&crowd, MANY);
        record_in(&crowd, "dop853", &options, lanes);
        for (size_t i = 0; i < MANY; i++) expect_same_records(alone.records[i], crowd.records[i]);
        forget(&crowd);
    }
    forget(&alone);
}

static void one_after_the_other(void **state) {
    const int moments[] = {9, 19, 20};
    (void)state;
    every_moment("cvode-adams", moments, sizeof moments / sizeof *moments);
}

/// States with other options, and incomplete states, are not used.
static void states_that_do_not_fit(void **state) {
    const whirl_record_options options = options_of(WHIRL_GROWTH_LARGEST, false);
    whirl_record_options other = options;
    motions whole, first, second;
    (void)state;
    other.record = RECORD + 1;
    prepare(&whole);
    const size_t all = record(&whole, "rk4", &options);
    for (int kind = 0; kind < 3; kind++) {
        prepare(&first);
        prepare(&second);
        first.wanted = 24;
        record(&first, kind == 0 ? "dop853" : "rk4", kind == 1 ? &other : &options);
        for (size_t i = 0; i < MOTIONS; i++) {
            second.states[i] = first.states[i];
            second.sizes[i] = kind == 2 ? first.sizes[i] - 1 - 100 * i : first.sizes[i];
            first.states[i] = NULL;
        }
        assert_int_equal(record(&second, "rk4", &options), all);
        for (size_t i = 0; i < MOTIONS; i++) expect_same_records(whole.records[i], second.records[i]);
        forget(&first);
        forget(&second);
    }
    forget(&whole);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(side_by_side),       cmocka_unit_test(looking_for_orbits),
        cmocka_unit_test(waiting_for_orbits), cmocka_unit_test(one_after_the_other),
        cmocka_unit_test(waiting_for_lanes),  cmocka_unit_test(states_that_do_not_fit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
