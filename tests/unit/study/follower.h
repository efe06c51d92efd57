/// A family of machines for tests: x' = -r (x - cos t), stable for every r > 0 and known exactly, but RK4 grows without
/// bound where r h > 2.7853 (Hairer, Wanner: Solving Ordinary Differential Equations II, IV.2). Include after cmocka.h.
#ifndef TEST_FOLLOWER_H
#define TEST_FOLLOWER_H

#include <math.h>
#include <stdlib.h>

#include "whirl/engine/study.h"

typedef struct follower {
    double rate, start[1];
    whirl_system system;
} follower;

static void follower_slope(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)forcing;
    dxdt[0] = -((const follower *)model)->rate * (x[0] - cos(6.283185307179586 * t));
}

/// Makes the follower of rate `value`, from 0.5 (whirl_study.machine).
static whirl_status make_follower(const void *family, const whirl_batch *batch, double value, whirl_machine *out) {
    static const whirl_probe probe = {.name = "follower"};
    (void)family, (void)batch;
    follower *own = malloc(sizeof *own);
    assert_non_null(own);
    *own = (follower){.rate = value, .start = {0.5}};
    own->system = (whirl_system){
        .dimension = 1, .period = 1, .rhs = follower_slope, .probe_count = 1, .probes = &probe, .model = own};
    *out = (whirl_machine){.system = &own->system, .start = own->start, .owner = own, .release = free};
    return whirl_ok();
}

#endif
