/// Adaptive methods over vector lanes: the data of a kernel. Each lane has its own time, its own step, and its own
/// sides of the switches.
///
/// The many lanes of an ensemble share a few vectors of slots, which stay in the first cache. A lane occupies a slot
/// for a revolution; then the slot is given to the next lane. A step is tried for all slots together, and accepted or
/// rejected for each. Slots near a switch are few: they are handled one by one (adaptive_special.c), by functions that
/// are compiled once, so that results do not differ between vector widths.
///
/// A method consists of a kernel for its step and a table (lanes_method). The kernel kernels/<method>_lanes.c includes
/// kernels/adaptive_lanes.inc for what all kernels share, and kernels/adaptive_revolve.inc for the way through a
/// revolution.
#ifndef INTEGRATE_ADAPTIVE_LANES_H
#define INTEGRATE_ADAPTIVE_LANES_H

#include "dop853_sums.h"
#include "isa.h"
#include "lanes.h"
#include "method.h"
#include "rk4_lanes.h"
#include "rodas5p_tableau.h"
#include "sparsity.h"
#include "stepper.h"
#include "vector.h"

#define LANE_ROWS(...) +1
enum {
    MAX_ATTEMPTS = 1000000, ///< steps tried in a revolution
    MAX_GROUP = 4,          ///< most vectors of a group
    PAIR_STRIDE = 4,        ///< vectors in a group of pairs
    MAX_SLOTS = 64,
    MAX_LANE_ROWS = 9 WHIRL_WATCHED(LANE_ROWS)
};
#undef LANE_ROWS
#define NO_LANE ((size_t)-1)

/// Rows of an ensemble, and the same rows of the slots.
typedef struct lane_rows {
    double *own, *theirs;
    size_t rows;
    bool constant; ///< the row is not copied back from the slot to the lane
    bool observed; ///< exchanged for observed lanes only
} lane_rows;

/// The lanes that wait for a slot.
typedef struct lane_queue {
    size_t next, count;
    const size_t *order;         ///< [count] the lanes, observed ones first
    size_t observed;             ///< number of observed lanes
    size_t slot_lane[MAX_SLOTS]; ///< lane in every slot; NO_LANE
} lane_queue;

/// Workspace of the steps of dop853.
typedef struct dop853_work {
    dop853_sums sums;
    double *k[DOP853_SLOPES]; ///< [rates] slopes in adjacent rows
    double *base;             ///< cos and sin of t
    double *divergence;       ///< [DOP853_STAGES + 1] at the states at which slopes were taken
} dop853_work;

/// Workspace of the steps of rodas5p (kernels/rodas5p_lanes.c).
typedef struct rodas5p_work {
    double *u_q[RODAS5P_STAGES], *u_v[RODAS5P_STAGES]; ///< [degrees], [rates] increments of the stages
    sparsity *sparsity;
    double *unit_q, *unit_v;       ///< [1 + perturbations][degrees], [rates] the state, then the perturbations that
                                   ///< find the Jacobian: sums of unit perturbations
    double *by;                    ///< [1 + perturbations][rates] slope, then sums of columns of the Jacobian
    double *matrix;                ///< [rates][rates] rows, decomposed; dense: both factors and a column
    double *pivot;                 ///< [rates] reciprocals
    double *doubtful;              ///< 1 if a pivot is too small
    double *shift;                 ///< 1/(gamma h)
    double *rate;                  ///< [rates] derivative of the slope by time alone
    double *right_q;               ///< [degrees] workspace: right-hand sides of positions
    double *between_q, *between_v; ///< [degrees], [rates] error of the interpolant in the middle
    double *ahead;                 ///< [forcing_count] workspace
} rodas5p_work;

/// Workspace of an adaptive method. Arrays are [...][stride vectors] of slots.
typedef struct adaptive_lanes {
    const struct lanes_method *method;
    const void *model;    ///< machine that defines the structure of all lanes
    const int *pair_laws; ///< laws of pairs (whirl_lanes.pair_laws) in groups of PAIR_STRIDE; otherwise NULL
    lanes_flow *flow;
    lanes_switches *switches;
    lanes_forcing *forcing_at;
    void (*depends)(const void *model,
                    bool *table); ///< as in whirl_lanes; NULL: every rate depends on every coordinate
    const whirl_stop *stop;       ///< stop of the system
    size_t stride, slots;         ///< vectors, and slots in them
    size_t degrees;
    size_t rates;     ///< velocities, and states of first order after them: the rows of every v and slope
    size_t dimension; ///< degrees + rates; rates follow their positions in memory
    size_t number_count, forcing_count, switch_count;
    size_t group_count;
    const size_t *groups; ///< coordinates whose sizes are measured together
    const size_t *mates;  ///< [rates] for one slot: the next state whose size is measured with this one's; NULL: none
    bool modulated;       ///< accelerations are not linear in the forcing
    bool slides;          ///< motions can slide along a switch
    size_t followed;      ///< most perturbations
    size_t tangents;      ///< perturbations carried in this revolution
    double period, rtol, atol, limit;
    // Machine and state, one a lane.
    double *numbers, *q, *v;
    double *ended; ///< whirl_motion; lanes that have ended are not carried on
    // State of the revolution.
    double *from, *until;           ///< beginning and end of the part of the revolution to be carried
    double *starting;               ///< 1 where the revolution begins
    double *attempts;               ///< steps tried
    double *t, *h;                  ///< time, and length of the step to try next
    double *running;                ///< 1 until the lane's revolution is over
    double *before;                 ///< (error of the step before)^(1/16)
    double *rejected;               ///< 1 after a step that was rejected
    double *sides, *held, *sliding; ///< [switch_count] sides, held and sliding of a stepper
    double *alone;                  ///< 1 while the motion slides along a switch: its steps are taken by the stepper
    double *switchings;
    double *landing;       ///< 1 + the switch that the step is to end at, 0: none
    double *whole, *tries; ///< length of the step that contains the switch, and steps tried to find it
    double *value, *rate;  ///< [switch_count] switching functions and their derivatives at t
    double *slope;         ///< [rates] slopes of v at t
    double *divergence;    ///< divergence at t, if perturbations are carried
    double *volume;        ///< integral of the divergence
    // State of the step.
    double *length, *lengths;     ///< length tried; [degrees] the same for every degree
    double *error;                ///< square of the error, in tolerances
    double *size;                 ///< largest coordinate
    double *special;              ///< 1 if the step needs special treatment
    double *fresh;                ///< 1 where slope and switches at t must be computed again
    double *stage_q, *stage_v;    ///< [degrees], [rates]
    double *end_q, *end_v;        ///< [degrees], [rates] the state at the step's end
    double *end_slope;            ///< [rates] slopes at the step's end
    double *end_divergence;       ///< the divergence at the step's end
    double *gained;               ///< integral of the divergence over the step
    double *later;                ///< [rates] workspace for the length of the first step
    double *end_value, *end_rate; ///< [switch_count]
    double *time, *forcing;       ///< workspace; [forcing_count] forcing at `time`
    dop853_work dop853;
    rodas5p_work rodas5p;
    // Observation: the step taken, as polynomials.
    bool observing;
    double *watched;          ///< 1 where the lane is observed
    double *begin, *taken;    ///< beginning and length of the step; length 0: no step was taken
    double *dense[1 + DENSE]; ///< [dimension] state at the step's beginning, then the method's polynomials, in adjacent
                              ///< rows
    double *instant, *seen, *theta; ///< number of the next instant; 1 if it lies in the step; its theta in the step
    int instants;                   ///< instants of a revolution
    lanes_observe observe;
    size_t sample_stride; ///< instants from one sample to the next, 0: no samples
    double *samples;      ///< [sample_capacity][dimension][lane_count]
    size_t sample_capacity;
    // The ensemble whose lanes are carried.
    size_t lane_count;
    const double *parts; ///< [lane_count][2] beginning and end of the part of the period over which a lane is carried;
                         ///< NULL: the whole period
    const whirl_system *const *machines; ///< [lane_count] NULL: empty lane
    lane_rows exchanged[MAX_LANE_ROWS];  ///< rows that are exchanged between a lane and its slot
    size_t exchanged_count;
    lane_queue *queue;
    stepper *stepper;               ///< the ensemble's stepper, for slots with special steps
    whirl_perturbations *alongside; ///< perturbations of such a slot
    double *block;                  ///< all arrays
} adaptive_lanes;

typedef void adaptive_lanes_revolve(const adaptive_lanes *lanes);

/// Functions of a method's kernel for a stepper, which has a workspace of one slot.
typedef struct one_slot {
    void (*begin)(const adaptive_lanes *slot);            ///< computes the length of the first step from the slope
    void (*try_step)(const adaptive_lanes *slot);         ///< computes from (t, v) the end of the step, the slope
                                                          ///< there, and the error
    void (*take_polynomials)(const adaptive_lanes *slot); ///< computes the interpolant of the step tried
    /// Computes, in stage_v, the state at which slope `number` of the step tried was taken. For rodas5p it must be
    /// called for ascending numbers.
    void (*take_stage)(const adaptive_lanes *slot, int number);
    void (*solve)(const adaptive_lanes *slot, double *x); ///< computes (1/(gamma h) - J)^-1 x in place; NULL: an
                                                          ///< explicit method
    /// Returns true if the step is accepted. Otherwise the step is special, or must be tried again with the length h.
    bool (*judge)(const adaptive_lanes *slot);
} one_slot;

extern const one_slot dop853_slot, rodas5p_slot;

/// An adaptive method in lanes.
typedef struct lanes_method {
    /// One function for every instruction set of vector.h; NULL if it is not built.
    adaptive_lanes_revolve *const *revolves;
    const one_slot *one;
    bool implicit; ///< solves linear equations, and first finds the zeros of their matrix
    /// Tries the step of a stepper's state for its perturbations. Returns the norm of their estimated error, divided by
    /// the tolerance.
    double (*try_varied)(stepper *c);
    int dense;                     ///< number of polynomials of the interpolant
    size_t (*group)(size_t rates); ///< number of vectors of a group: enough to hide each other's latency, few enough
                                   ///< for the first cache
    /// Lays out the method's own arrays, and the arrays of the step that it owns, in a block of rows. Returns the
    /// number of rows. With a block of NULL it only counts them.
    size_t (*lay_out)(adaptive_lanes *lanes, double *block);
    void (*prepare)(adaptive_lanes *lanes); ///< writes the constants into the method's own arrays
} lanes_method;

FOR_EVERY_ISA(adaptive_lanes_revolve, dop853_lanes);
FOR_EVERY_ISA(adaptive_lanes_revolve, rodas5p_lanes);

/// Returns a row of the block, or NULL while rows are only counted.
static inline double *lanes_row(const adaptive_lanes *lanes, double *block, size_t row) {
    return block ? block + row * lanes->slots : NULL;
}

/// Makes a workspace of the given shape with its arrays. Returns NULL without memory.
adaptive_lanes *adaptive_lanes_make(const adaptive_lanes *shape);

/// Makes a workspace for systems of one structure and an instruction set, for `lane_count` lanes (0: many) with up to
/// `followed` perturbations. The ensemble is set for every revolution. Returns NULL without memory.
adaptive_lanes *adaptive_lanes_new(const lanes_method *own, const whirl_system *system,
                                   const whirl_integrate_options *options, const isa *set, size_t lane_count,
                                   size_t followed);

/// Allocates the samples of a revolution. Returns false without memory.
bool adaptive_lanes_make_room(adaptive_lanes *lanes, size_t samples, size_t lane_count);
void adaptive_lanes_free(adaptive_lanes *lanes);

/// Removes finished lanes from their slots, and fills free slots. Returns true if new revolutions begin.
bool adaptive_fill(const adaptive_lanes *lanes);

/// Handles the step of a slot near a switch, or at its end.
void adaptive_special(const adaptive_lanes *lanes, size_t slot);

/// Finds the sides of a slot whose revolution begins on or near a switch.
void adaptive_find_sides(const adaptive_lanes *lanes, size_t slot);

#endif
