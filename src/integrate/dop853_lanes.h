/// The method of Dormand and Prince over vector lanes, each at its own time, with its own step and on its own sides of
/// the switches: what a kernel works on.
///
/// Few vectors of slots, which stay in the first cache, serve the many lanes of an ensemble: a lane takes a slot for a
/// revolution, and slots that have become free are given to the next lanes. A step is tried for all slots together;
/// each takes or rejects its own. Slots near a switch are few: they are looked at one by one (dop853_special.c), by
/// functions that are compiled once, so that widths cannot differ.
#ifndef INTEGRATE_DOP853_LANES_H
#define INTEGRATE_DOP853_LANES_H

#include "dop853_sums.h"
#include "isa.h"
#include "lanes.h"
#include "rk4_lanes.h"
#include "stepper.h"

enum {
    MAX_ATTEMPTS = 1000000, ///< steps tried in a revolution
    MAX_GROUP = 4,          ///< vectors
    MAX_SLOTS = 64,
    MAX_LANE_ROWS = 16
};
#define NO_LANE ((size_t)-1)

/// Rows of an ensemble and the slots' own.
typedef struct lane_rows {
    double *own, *theirs;
    size_t rows;
    bool constant; ///< need not go back
} lane_rows;

/// The lanes that wait for a slot.
typedef struct lane_queue {
    size_t next, count;
    size_t slot_lane[MAX_SLOTS]; ///< who is in a slot; NO_LANE
} lane_queue;

/// Arrays are [...][stride vectors] of slots.
typedef struct dop853_lanes {
    const void *model;             ///< whose structure all lanes have
    const struct lanes_pair *pair; ///< the laws of the structure of pair_kernel.h; NULL: another, or another group
    lanes_flow *flow;
    lanes_switches *switches;
    lanes_forcing *forcing_at;
    size_t stride, slots; ///< vectors, and slots in them
    size_t degrees, number_count, forcing_count, switch_count;
    size_t group_count;
    const size_t *groups; ///< coordinates whose sizes are measured together
    double period, rtol, atol, limit;
    dop853_sums sums;
    // One machine a lane.
    double *numbers, *q, *v;
    double *ended; ///< whirl_motion; lanes that have ended are not carried on
    // Of the revolution.
    double *starting;     ///< 1 where it begins
    double *attempts;     ///< steps tried
    double *t, *h;        ///< time, and length of step to try next
    double *running;      ///< 1 until its revolution is over
    double *before;       ///< (error of the step before)^(1/16)
    double *rejected;     ///< 1 after a step that was rejected
    double *sides, *held; ///< [switch_count] as a stepper has them
    double *switchings;
    double *landing;          ///< 1 + the switch that the step is to end at, 0: none
    double *whole, *tries;    ///< the step within which it is, and steps taken to find it
    double *value, *rate;     ///< [switch_count] switching functions and their derivatives at t
    double *k[DOP853_SLOPES]; ///< [degrees]
    // Of the step.
    double *length, *lengths;     ///< tried; [degrees] the same for every degree
    double *error;                ///< square of the error, in tolerances
    double *size;                 ///< largest coordinate
    double *special;              ///< 1 where the step needs to be looked at
    double *fresh;                ///< 1 where slope and switches at t must be taken anew
    double *stage_q, *stage_v;    ///< [degrees]
    double *end_q, *end_v;        ///< [degrees] the state at its end
    double *end_value, *end_rate; ///< [switch_count]
    double *time, *forcing;       ///< workspace; [forcing_count]
    double *base;                 ///< cos and sin of t
    // What is observed: the step taken, as polynomials.
    bool observing;
    double *begin, *taken;          ///< its beginning and length; 0: none was taken
    double *dense[1 + DENSE];       ///< [2 degrees] its first state, then the polynomials
    double *instant, *seen, *theta; ///< number of the next instant, 1 where it lies in the step, and its place there
    int instants;                   ///< of a revolution
    lanes_observe observe;
    size_t sample_stride; ///< instants from one sample to the next, 0: no samples
    double *samples;      ///< [sample_room][2 degrees][lane_count]
    size_t sample_room;
    // The ensemble that is served.
    size_t lane_count;
    const whirl_system *const *machines; ///< [lane_count] NULL: nobody is there
    lane_rows exchanged[MAX_LANE_ROWS];  ///< what goes with a lane into its slot and back
    size_t exchanged_count;
    lane_queue *queue;
    stepper *stepper; ///< for slots that are looked at one by one
    double *block;    ///< all arrays
} dop853_lanes;

/// A workspace for systems of that structure with that instruction set; the ensemble is set for every revolution. NULL
/// where there is no memory.
dop853_lanes *dop853_lanes_new(const whirl_system *system, const whirl_integrate_options *options, const isa *set);

/// Room for the samples of a revolution; false where there is no memory.
bool dop853_lanes_make_room(dop853_lanes *lanes, size_t samples, size_t lane_count);
void dop853_lanes_free(dop853_lanes *lanes);

/// Takes lanes that are through out of their slots and fills free ones. True where revolutions begin.
bool dop853_fill(const dop853_lanes *lanes);

/// Looks at the step of a slot near a switch, or at its end.
void dop853_special(const dop853_lanes *lanes, size_t slot);

/// The sides of a slot whose revolution begins on or near a switch.
void dop853_find_sides(const dop853_lanes *lanes, size_t slot);

typedef void dop853_lanes_revolve(const dop853_lanes *lanes);

/// One for every instruction set of vector.h; NULL where it is not built.
extern dop853_lanes_revolve *const dop853_lanes_revolves[];
dop853_lanes_revolve dop853_lanes_scalar, dop853_lanes_128, dop853_lanes_fma, dop853_lanes_avx2, dop853_lanes_avx512;

#endif
