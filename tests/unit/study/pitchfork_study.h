/// Studies of a line of points of a pitchfork, carried or not. Include after cmocka.h.
#ifndef STUDY_PITCHFORK_STUDY_H
#define STUDY_PITCHFORK_STUDY_H

#include <stdlib.h>

#include "sweep_study.h"

enum { POINTS = 41 };

/// x' = p + x - x^3: for |p| < 2/(3 sqrt 3) two stable equilibria, which a carried sweep follows until they vanish.
typedef struct pitchfork {
    double p, start[1];
    whirl_system system;
} pitchfork;

static inline void slope(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)t, (void)forcing;
    dxdt[0] = ((const pitchfork *)model)->p + x[0] - x[0] * x[0] * x[0];
}

static inline whirl_status machine(const void *family, const whirl_batch *batch, double value, whirl_machine *out) {
    static const whirl_probe probe = {.name = "rest"};
    (void)family, (void)batch;
    pitchfork *own = malloc(sizeof *own);
    assert_non_null(own);
    *own = (pitchfork){.p = value, .start = {0.1}};
    own->system =
        (whirl_system){.dimension = 1, .period = 1, .rhs = slope, .probe_count = 1, .probes = &probe, .model = own};
    *out = (whirl_machine){.system = &own->system, .start = own->start, .owner = own, .release = free};
    return whirl_ok();
}

static inline whirl_study study(double values[POINTS], whirl_carry carry, bool confirm) {
    whirl_study s = sweep_study("p", values, POINTS, 64);
    whirl_batch *batch = &s.batches[0];
    for (int i = 0; i < POINTS; i++) values[i] = -1 + 2.0 * i / (POINTS - 1);
    s.machine = machine;
    batch->carry = carry;
    batch->confirm = confirm;
    batch->record.transient = 60;
    batch->record.record = 20;
    assert_true(whirl_analysis_add(&batch->analyses, "poincare"));
    assert_true(whirl_analysis_add(&batch->analyses, "regime"));
    return s;
}

static inline size_t slots_of(const whirl_study *s) {
    return s->batches[0].carry == WHIRL_CARRY_BOTH ? 2 * POINTS : POINTS;
}

#endif
