/// A machine whose speed changes, as its equation of the shaft (running.c) and its kernels in lanes see it.
#ifndef ROTOR_RUNNING_ROTOR_H
#define ROTOR_RUNNING_ROTOR_H

#include "machine.h"
#include "whirl/engine/running.h"

/// Number of powers of the speed in a sum that represents a number, and the lowest of these powers.
enum { POWERS = 5, LOWEST_POWER = -2 };

/// Number of speeds at which machines are made to find the powers and to check the sum.
enum { POWER_SPEEDS = 11 };

/// Least speed, divided by the unit, at which numbers are evaluated, since laws divide by the speed. A slower shaft
/// counts as standing.
static const double slowest = 1e-6;

/// A number of the machine that changes with the speed w: the sum of power[k] w^(k - 2), or a spline over w^lift.
typedef struct number_of_speed {
    size_t index;
    double power[POWERS];
    double *value, *curvature; ///< [SPLINE_NODES] spline of w^lift times the number; NULL: the sum of powers holds
    int lift;                  ///< 0, 1 or 2: w^lift times the number has a limit at low speeds
} number_of_speed;

/// Nodes of a spline; speeds of its nodes, and of the checks between them; stored numbers of a spline.
enum { SPLINE_NODES = 33, SPLINE_SPEEDS = 2 * SPLINE_NODES - 1, SPLINE_NUMBERS = 2 * SPLINE_NODES };

/// The form of a number that depends on the speed W of a shaft with a speed of its own, by the rotor's speed w.
typedef enum spool_form {
    SPOOL_PRODUCT, ///< w^lift G(W)
    SPOOL_SUM,     ///< F(w) + w^lift (G(W) - G(highest)), with F as without such shafts
    SPOOL_RELATIVE ///< w^lift G(|s|), s = one speed of two shafts plus `sign` times the other; odd: times the sign of s
} spool_form;

/// A number of the machine that changes with the speed of a shaft whose speed is its own. Speeds are divided by the
/// unit. The member `by` is a function of W or |s|.
typedef struct spool_number {
    size_t index;
    spool_form form;
    int lift;                   ///< power of the rotor's speed
    size_t of[2];               ///< shafts: 0 the rotor's, from 1 those with a speed of their own; of[1]: W
    double sign;                ///< of a relative speed
    bool odd;                   ///< the number changes its sign with that of the relative speed
    double highest;             ///< G at the highest W
    number_of_speed by;         ///< G
    const number_of_speed *own; ///< F, if it varies; otherwise NULL, and `constant` is F
    double constant;
} spool_number;

/// A shaft with a speed of its own.
typedef struct running_spool {
    double highest; ///< speed over the unit at which numbers of other shafts are sampled, near its highest (the base)
    double top;     ///< highest speed over the unit
    double sense;   ///< as in whirl_spool
    double lowest_node, node_distance;        ///< of splines over its speed
    bool driven;                              ///< its drive turns it at some time
    double inertia;                           ///< kg m2, about axes through centres of mass
    double unbalance_inertia;                 ///< kg m2: what unbalances, with those of `lose`, add to it
    double *lever_force, *lever_acceleration; ///< [degrees] workspace: levers of its theta'' on a coordinate
    double guided_lever[2];                   ///< workspace: levers along x and y of what does not move that way
} running_spool;

/// Numbers of a machine for all coordinates on which unbalances act as levers, and for the shaft.
enum {
    LEVER_UNIT, ///< size of the coordinate's unit, m or rad
    LEVER_COS,
    LEVER_SIN, ///< as own_cos and own_sin, with the unbalances that have appeared
    LEVER_FORCE_COS,
    LEVER_FORCE_SIN,
    LEVER_LOST_COS,
    LEVER_LOST_SIN, ///< as own_cos and own_sin, for the unbalances that have appeared alone
    LEVER_NUMBERS
};
enum {
    SHAFT_UNIT,   ///< unit of speed, rad/s
    SHAFT_SQUARE, ///< its square
    SHAFT_RATE,   ///< given rate over the square of the unit
    SHAFT_DRIVEN, ///< 1: torques turn the shaft, 0: the rate does
    SHAFT_MOTOR,
    SHAFT_FALL, ///< torque of the motor at standstill, and its fall with the speed, N m and N m s
    SHAFT_LOAD,
    SHAFT_LINEAR,
    SHAFT_QUADRATIC,               ///< as in shaft_drive
    SHAFT_INERTIA,                 ///< kg m2, of all that turns
    SHAFT_PULL,                    ///< pull of gravity along x, then y, over the square of the unit
    SHAFT_GUIDED = SHAFT_PULL + 2, ///< cos and sin of turning_inertia along x, then y
    SHAFT_NUMBERS = SHAFT_GUIDED + 4
};

/// A factor of a power of the speed in a number that varies.
typedef struct running_factor {
    size_t number, power; ///< indices of the number, and of the power from LOWEST_POWER on
    bool begins;          ///< the first factor of its number
} running_factor;

/// Rows of the numbers of a machine in lanes. The first are those of the rotor: constant ones, and workspace for those
/// that vary with the speed.
typedef struct running_lanes {
    size_t powers;   ///< first of the factors of powers: of every varying number those that are not 0, by rising
                     ///< power
    size_t shaft;    ///< first of [SHAFT_NUMBERS]
    size_t levers;   ///< first of [lever_count][LEVER_NUMBERS]
    size_t now;      ///< first of [lever_count] workspace: accelerations by a unit of theta''
    size_t contacts; ///< first of [3][contact_count] workspace
    size_t switches; ///< first of [2][switch_count] workspace
    size_t nearby;   ///< first of [degrees + states] workspace: slopes of the rotor at a speed nearby
    size_t lever_count;
    size_t *lever;           ///< [lever_count] coordinates
    size_t factor_count;     ///< number of factors of powers
    running_factor *factors; ///< [factor_count]
} running_lanes;

/// A rotor whose speed changes.
typedef struct running_rotor {
    whirl_running shown;   ///< the public part, which is first, so that a pointer to it also points to this struct
    whirl_machine machine; ///< the machine at the unit of speed; machines of all speeds have its structure
    const whirl_rotor *rotor;
    double unit;
    whirl_turning how;
    double *numbers; ///< [number_count] workspace: numbers at the speed *at
    double *at;
    size_t varying_count;
    number_of_speed *varying;
    double *splines; ///< all of them
    double lowest_node, node_distance;
    /// [degrees] Effect of turning unbalances on each coordinate, by the values C and S of the forcing: accelerations
    /// at a speed of 1 unit (own_), and forces divided by the square of the speed, kg m, of tilts kg m2 (force_).
    /// Arrays lost_ have the effect of the unbalances of `lose`.
    double *own_cos, *own_sin, *force_cos, *force_sin;
    double *lost_cos, *lost_sin, *lost_force_cos, *lost_force_sin;
    double *lever_force, *lever_acceleration;   ///< [degrees] workspace: levers of theta'' on a coordinate
    double *geared_force, *geared_acceleration; ///< [degrees] workspace: levers of unbalances at ratios of the speed
    turning_inertia lost_guided[2];             ///< rotor->guided and the unbalances of `lose`
    double *guided_lever; ///< [2] workspace: levers along x and y of stations that do not move along that axis
    double *alone;      ///< [degrees] share of a row in the square of its station's unbalance: 1/2, or 1 if the station
                        ///< moves along one axis only
    double own_inertia; ///< kg m2: what unbalances add to the inertia about the shaft's axis
    double lost_inertia;   ///< kg m2: the same with those of `lose`
    size_t geared_count;   ///< unbalances at ratios of the speed
    double geared_inertia; ///< kg m2: what these add to the inertia about the shaft's axis
    unsigned char *along;  ///< [degrees] 0 for displacements of stations along x, 1 along y, 2 for all other
                           ///< coordinates
    double *block;         ///< all arrays from own_cos on
    double *place, *slope; ///< [dimension] workspace
    double *friction;      ///< [contact_count][3] workspace
    /// [degrees] workspace: torques on twists, N m, and the accelerations by these torques.
    double *torque, *torque_acceleration;
    double *shaken;      ///< [2][degrees] accelerations of coordinates by a pull of 1 m/s2 along x, then along y
    double *shake;       ///< [2] workspace: acceleration of the ground along x and y, m/s2
    size_t own;          ///< number of states of torques
    size_t at_speed;     ///< index of the speed among the states; it follows the rotor's states and those of torques
    double turn_inertia; ///< inertia of all turning parts, kg m2
    double slip; ///< speed below which the dry friction of the load falls to 0, rad/s; 0: it never does (drive_load)
    bool driven; ///< torques drive the machine
    whirl_system by_angle, by_time;
    whirl_lanes form;             ///< form of `together`
    whirl_system together;        ///< by_angle in vector lanes, with the angle as time
    running_lanes lanes;          ///< rows of the numbers that the kernels of `together` read (running_lanes.c)
    double from;                  ///< angle at which the current part of a revolution begins
    size_t spool_count, at_spool; ///< shafts with a speed of their own, and index of the first one's angle in states
    running_spool *spools;        ///< [spool_count] workspace in parts
    double *spool_place;          ///< [dimension] workspace
    size_t lost_spool_count;
    whirl_placed lost_spools[WHIRL_MAX_EVENTS + 2]; ///< [lost_spool_count] unbalances of `lose` on these shafts
    size_t spooled_count;
    spool_number *spooled; ///< [spooled_count] numbers that change with their speeds
    double *spool_splines; ///< all splines of these
    double *spool_at;      ///< [spool_count] workspace: their speeds for which `numbers` hold
    /// [shaft_count + 1] workspace: torques by shafts; those on the machine as a whole come last.
    whirl_shaft_torques *ledger;
} running_rotor;

/// Finds the fewest powers whose sum is y at all speeds w [count]. Returns false if there is no such sum.
bool running_find_powers(size_t count, const double *w, const double *y, double power[POWERS]);

/// Chooses the speeds w [POWER_SPEEDS] at which machines are made, from `highest` down. Speeds below 0.17 of it add
/// nothing to the fit, since sums of powers hold there, too.
void running_sample_speeds(double lowest, double highest, double *w);

/// Fits the spline of a number from samples at the speeds w [SPLINE_SPEEDS], which are half the `distance` of nodes
/// apart: y[i * stride + own->index] / divisor. *next is memory [SPLINE_NUMBERS] for it and moves behind it. Returns
/// the largest error half way between nodes, divided by the largest value.
double running_fit_spline(number_of_speed *own, double lowest, double distance, const double *w, const double *y,
                          size_t stride, double divisor, double **next);

/// Returns a number at a speed, over nodes of splines from `lowest` at distances `distance`.
double running_number_at(const number_of_speed *of, double lowest, double distance, double w);

/// Checks that a machine at another speed can run, and has the structure of r->rotor. WHIRL_BAD_INPUT with a sentence.
whirl_status running_check_machine(const running_rotor *r, const whirl_machine *machine);

/// Makes the machine at speeds w [count], divided by the unit, and writes its numbers, out [count][number_count].
/// spools [count][spool_count]: speeds of the shafts with a speed of their own over the unit; NULL: the highest.
whirl_status running_sample(const running_rotor *r, whirl_machine_at *make, const void *context, size_t count,
                            const double *w, const double *spools, double *out);

/// Finds how numbers depend on the speeds of shafts with a speed of their own (running_spools.c). y
/// [POWER_SPEEDS][number_count]: numbers at the speeds w of the rotor and the base of these shafts. Removes numbers
/// from r->varying that are no sums, and counts their splines off *splines.
whirl_status running_find_spooled(running_rotor *r, whirl_machine_at *make, const void *context, const double *w,
                                  const double *y, size_t *splines);

/// Evaluates these numbers at a speed of the rotor, in the workspace; spools [spool_count]: their speeds over the unit.
void running_put_spooled(const running_rotor *r, double w, const double *spools);

/// Makes the shafts with a speed of their own, with unbalances on them. WHIRL_NO_MEMORY.
whirl_status running_add_spools(running_rotor *r);

/// Returns a shaft with a speed of its own by its highest speed over the unit, and its sense.
running_spool running_spool_of(double highest, double sense);

/// Returns true if a station moves along x (way: 0) or along y (way: 1).
static inline bool running_probe_moves(const whirl_probe *probe, size_t way) {
    return probe->x != probe->y || (way == 1) == probe->along_y;
}

/// Returns what the unbalances of shaft k with a speed of its own, with those of `lose`, add to its inertia about its
/// axis: of each place the square of its moment over its mass, kg m2. It overwrites the levers.
double running_spool_unbalance_inertia(const running_rotor *r, size_t k);

/// Computes their levers in a state x by the angle.
void running_find_spool_levers(const running_rotor *r, const double *x);

/// A shaft's part of the equation of all shafts.
typedef struct shaft_row {
    bool driven;                        ///< torques turn it; otherwise `all` is given
    double torque;                      ///< N m, without the rotor's reaction
    double inertia;                     ///< kg m2 about its axis
    const double *force, *acceleration; ///< [degrees] levers of its theta''
    const double *guided;               ///< [2] likewise along x and y of what does not move that way
    double by_first;                    ///< of a given theta'': derivative by that of the first shaft
    double all;      ///< theta'' over the square of the unit of speed; computed where torques turn it
    double reaction; ///< computed: torque of its unbalances on it, over the square of the unit, at theta'' = 0
} shaft_row;

/// Solves the equation of all shafts, rows [count] of which the first is the rotor's own. a [degrees]: accelerations by
/// the angle without theta'', at the speed w; pull [3]: that of gravity less the ground's acceleration along x and y,
/// m/s2, and 0.
void running_solve_shafts(const running_rotor *r, double w, const double *a, const double pull[3], size_t count,
                          shaft_row *rows);

/// theta'' divided by the square of the unit of speed: all of it, and the part by torques on twists; and that of shafts
/// with a speed of their own.
typedef struct faster {
    double all, twisted, spools[WHIRL_MAX_SPOOLS];
} faster;

/// A state whose derivatives are by the angle: the exact speed of the shaft; the speed w by which derivatives by the
/// angle were taken (at least `slowest`); the angle; and the state.
typedef struct running_state {
    double exact, w, angle;
    const double *x;
} running_state;

/// Computes the lever of element `index` if it is an unbalance that turns at a fixed ratio of the shaft's speed, with
/// the numbers of the speed w and the states [own->states]. Returns what element_type.lever returns, 0 for other
/// elements.
double running_geared_lever(const running_rotor *r, size_t index, double w, const double *states, double lever[2]);

/// Computes the levers of the unbalances that turn with the shaft, at the values C and S of the forcing. The levers of
/// a coordinate are the force on it and its acceleration by a unit of theta''.
void running_find_levers(const running_rotor *r, const double *forcing);

/// Returns the pull of gravity along x (way: 0) or y (way: 1) minus the acceleration of the ground, m/s2; 0 otherwise
/// (these three: running_levers.c).
double running_pull(const running_rotor *r, size_t way);

/// Completes the torques of the shafts in r->ledger, whose motors, loads, friction and drag are filled in: out
/// [shaft_count]. a [degrees]: accelerations by the angle without theta'', with the levers of the same state in
/// workspace, which are overwritten. spools [spool_count]: torques on shafts with a speed of their own
/// (running_shafts.c).
void running_complete_shafts(const running_rotor *r, const running_state *s, const double *forcing, double *a,
                             const faster *by, const whirl_torques *spools, whirl_shaft_torques *out);

/// Fills in `lanes`, `form` and `together` when all other members are filled in. Returns false without memory
/// (running_lanes.c).
bool running_lanes_fill(running_rotor *r);

/// Frees what running_lanes_fill allocated.
void running_lanes_free(running_rotor *r);

/// Returns true if lanes can carry the machine as it turns now.
bool running_goes_in_lanes(const running_rotor *r);

/// Functions of machines whose speed changes for lanes.h, one of each kind for every instruction set
/// (kernels/running.c).
FOR_EVERY_ISA(lanes_flow, running_flow);
FOR_EVERY_ISA(lanes_switches, running_switches);
FOR_EVERY_ISA(lanes_forcing, running_forcing);

#endif
