/// RK4 over vector lanes, with perturbations: the block of memory that a kernel works on.
#ifndef INTEGRATE_RK4_LANES_H
#define INTEGRATE_RK4_LANES_H

#include <stdbool.h>
#include <stddef.h>

#include "lanes.h"
#include "whirl/engine/stop.h"
#include "whirl/engine/system.h"
#include "whirl/engine/watched.h"

/// Observations. Every array of numbers has a last dimension, not shown below, of `stride` vectors.
typedef struct lanes_observe {
    size_t probe_count, contact_count;
    const whirl_probe *probes;   ///< [probe_count]
    const size_t *contact_probe; ///< [contact_count]
    double *low, *high;          ///< [degrees + rates]
    WHIRL_WATCHED_ARRAYS
    double *gap, *touching; ///< [contact_count]
    /// NULL if the gap alone decides contact, and friction is not reported.
    lanes_contacts *contacts;
    bool by_force;    ///< normal forces decide contact
    bool rubs;        ///< friction is reported
    double *force;    ///< [contact_count]
    double *friction; ///< [contact_count][2]
} lanes_observe;

/// Location of contacts. Steps of lanes that pass or come near a switch are taken again, one lane at a time.
typedef struct lanes_located {
    lanes_switches *switches; ///< NULL: contacts are not located
    size_t switch_count;
    bool needs_slopes;             ///< the switches' derivatives by time depend on accelerations
    double *begin_q, *begin_v;     ///< [degrees], [rates] the states at the step's beginning
    double *value[2], *rate[2];    ///< [switch_count] switching functions and their rates, at the step's beginning and
                                   ///< end
    struct stepper *stepper;       ///< takes these steps
    const whirl_system **machines; ///< [lane] NULL: empty lane
    double *ended;                 ///< [lane] whirl_motion
} lanes_located;

typedef struct rk4_lanes {
    const void *model; ///< machine that defines the structure of all lanes
    lanes_flow *flow;
    const int *pair_laws; ///< as in whirl_lanes
    size_t stride;        ///< number of vectors
    size_t vectors;       ///< vectors in use
    size_t lane_count;    ///< number of lanes
    size_t used;          ///< lanes in use, from the first on; other lanes of the last vector are computed and ignored
    size_t degrees, forcing_count;
    size_t rates; ///< velocities, and states of first order after them
    int steps;
    double step;
    const whirl_stop *stop;  ///< stop of the system
    const double *forcing;   ///< [2 steps + 1][forcing_count]
    size_t perturbations;    ///< perturbations carried: all states, slopes and stages are [1 + perturbations][...]
    size_t *places;          ///< places of numbers, as in lanes_view
    double *numbers, *q, *v; ///< [degrees], [rates]
    double *k[3], *stage_q, *stage_v; ///< [rates], [degrees], [rates] workspace
    double *now;                      ///< [forcing_count] workspace
    double *divergence[4], *volume;   ///< [1] divergence at the stages of a step, and its integral over time
    /// [perturbations] lengths: products of the perturbations' lengths since the last logarithm was taken; growth: sums
    /// of these logarithms. NULL: perturbations are not made orthonormal.
    double *lengths, *growth;
    void (*note)(const struct rk4_lanes *lanes);
    lanes_located located;
    lanes_observe observe;
    int observing;
    size_t sample_stride;
    void (*sample)(void *context);
    void *context;
} rk4_lanes;

/// Returns the number of steps between two orthonormalisations of perturbations. A revolution has at most 64 of them,
/// one at its end: often enough that fast decays are not lost in rounding.
static inline int rk4_orthonormal_steps(int steps) {
    enum { TIMES = 64 };
    return (steps + TIMES - 1) / TIMES;
}

/// Takes step n of a lane again from its beginning, split at the switches that it meets.
void rk4_redo(const rk4_lanes *lanes, int n, size_t lane);

/// One lane of any system, all coordinates of which count as states of first order.
typedef struct rk4_one {
    rk4_lanes lanes;
    double divergence[4], volume;
} rk4_one;

/// Returns lanes without perturbations. Members that depend on the steps and on the forcing are not set.
rk4_one rk4_one_of(lanes_flow *flow, const void *model, size_t dimension);

/// Number of rows of the lane's memory, and a function that assigns them. `row` is the number of doubles in each row.
/// The first row holds the state, then its perturbations.
enum { RK4_ROWS = 5 };
void rk4_one_place(rk4_one *one, double *rows, size_t row);

typedef void rk4_lanes_revolve(const rk4_lanes *lanes);

/// One function for every instruction set of vector.h; NULL if it is not built.
extern rk4_lanes_revolve *const rk4_lanes_revolves[];
rk4_lanes_revolve rk4_lanes_scalar, rk4_lanes_128, rk4_lanes_fma, rk4_lanes_avx2, rk4_lanes_avx512;

#endif
