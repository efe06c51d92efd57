/// Systems: the interface of machines for integrators and analyses. Rotors provide one; users of the library can write
/// their own (see examples/duffing.c).
///
///     dx/dt = f(t, x),   f(t + period, x) = f(t, x)
///
/// A system is immutable and shared by all threads; the functions must depend on their arguments alone.
#ifndef WHIRL_SYSTEM_H
#define WHIRL_SYSTEM_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/descriptor.h"
#include "whirl/engine/stop.h"
#include "whirl/engine/torsion.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Limits of systems.
enum {
    WHIRL_MAX_FORCING = 256,   ///< values that depend on time alone
    WHIRL_MAX_SWITCHES = 4096, ///< switching functions
    WHIRL_MAX_CONTACTS = 1024, ///< unilateral contacts
    WHIRL_MAX_PROBES = 256,    ///< probes
    WHIRL_MAX_TILTING = 6,     ///< tilting pads of one bearing
    WHIRL_MAX_REPEATS = 128    ///< longest common period of forces that rotors detect, in revolutions
};

/// A harmonic of the runout of a shaft, which probes add to its motion: Re(v exp(i order tau)), tau the angle of the
/// system's time, in the state's units of length.
typedef struct whirl_runout {
    int order;                  ///< periods in a revolution
    double first[2], second[2]; ///< real and imaginary part of v, for the probes along x and along y
} whirl_runout;

/// A pair of displacement coordinates that is observed together, as a pair of proximity probes observes a shaft. `x`
/// and `y` index the state, `vx` and `vy` the derivatives. A station that moves along one axis only has y = x and vy =
/// vx; the axis is x, or y with `along_y`; with `twists` it only turns about the shaft's axis, and counts as along x.
typedef struct whirl_probe {
    char name[WHIRL_NAME_SIZE]; ///< name of the station
    size_t x, y, vx, vy;        ///< indices of coordinates
    /// Clearance of the journal bearing here in the state's units of length, 0 if there is none: radius / clearance is
    /// the eccentricity ratio.
    double clearance;
    /// Radius at which the station touches a stator, in the state's units of length; 0 if there is none.
    double gap;
    size_t shaft;    ///< number of the finite-element shaft of the station, from 1; 0: none
    double position; ///< along that shaft, m
    bool along_y;    ///< for y = x: the coordinate is along y
    /// For y = x: the coordinate is the twist about the shaft's axis, as the displacement of a point 1 m from the axis.
    bool twists;
    bool clockwise;             ///< the rotor turns from y to x, which is then forward whirl; false: from x to y
    size_t runout_count;        ///< number of harmonics of the runout
    const whirl_runout *runout; ///< [runout_count] borrowed from the system; NULL in results
    /// [4] Factors from x, y, vx and vy of the state to reported values, for coordinates with scales of their own
    /// (whirl_user_system_scale); NULL: 1. Borrowed from the system; NULL in results.
    const double *units;
} whirl_probe;

/// A motion of a station besides x and y, for which the system has one more probe: the displacement along the shaft, or
/// the twist of a station that does not only twist.
typedef struct whirl_extra {
    size_t station; ///< index of the station
    bool twists;    ///< the motion is the twist; otherwise the axial displacement
} whirl_extra;

/// Returns true if the probe measures displacements along x (which: 0) or y (1).
bool whirl_probe_sees(const whirl_probe *probe, size_t which);

/// Returns x, y, vx or vy (nth: 0 to 3) of a state, in reported units; 0 along an axis that the probe does not measure.
double whirl_probe_value(const whirl_probe *probe, const double *state, size_t nth);

/// Returns the runout that the probe adds along x (which: 0) or y (1) after this number of revolutions.
double whirl_probe_runout(const whirl_probe *probe, size_t which, double revolutions);

/// Returns the sense of rotation of the probe's rotor: 1, or -1 clockwise.
double whirl_probe_way(const whirl_probe *probe);

/// Returns the members of a probe. Members of part "initial" are indices of coordinates that an initial state can set.
/// Static, ended by a member without a part.
const whirl_member *whirl_probe_members(void);

/// A named order of a machine, shown next to its line in spectra ("BPFO 3.08X of ball_bearing at rear").
typedef struct whirl_named_order {
    double order;                   ///< periods in a revolution, above 0
    char name[8];                   ///< "BPFO"
    char part[2 * WHIRL_NAME_SIZE]; ///< the part that it belongs to: "ball_bearing at rear"
    size_t probe;                   ///< probe of that part
} whirl_named_order;

/// Extremes of a motion or of an equilibrium.
typedef struct whirl_extremes {
    const double *low, *high; ///< [dimension] bounds of coordinates over all instants
    const double *max_radius; ///< [probe_count] largest distances from the centre
} whirl_extremes;

/// Range of validity of a part's law in one quantity: beyond it the computed motion is not that of the part.
typedef struct whirl_law_range {
    char part[2 * WHIRL_NAME_SIZE]; ///< "film at journal"
    const char *quantity, *unit;    ///< "eccentricity ratio", "1"
    const char *limit;              ///< words printed after `most`: "to which its coefficients were found"
    double most;                    ///< upper end of the range
    double reached;                 ///< the largest value reached; NaN if the extremes do not determine it
    size_t probe;                   ///< probe of the part
} whirl_law_range;

/// The film of a bearing or seal with the journal at rest, in the state's units of length.
typedef struct whirl_film_gap {
    double least; ///< smallest radial thickness; pads without a film do not count
    double wall;  ///< distance from the centre at which the journal touches in the direction of its eccentricity
    size_t pads;  ///< number of tilting pads, else 0
    bool held[WHIRL_MAX_TILTING]; ///< [pads] true if a film carries the pad
    double clearance;             ///< radial clearance, as assembled
    double place[2];              ///< x and y of the journal, from its housing
    size_t housing;               ///< probe of the station that is the housing; probe_count: the ground
} whirl_film_gap;

/// Kinds of coordinates in whirl_system.settle.
typedef enum whirl_settled {
    WHIRL_NOT_SETTLED, ///< `settle` does not change the coordinate
    WHIRL_SETTLED,     ///< `settle` moved the coordinate to where the forces on it balance
    WHIRL_IDLE         ///< nothing holds it, and it acts on nothing (a pad without a film), or it only counts time
} whirl_settled;

/// A system's data for vector lanes; private to the library.
typedef struct whirl_lanes whirl_lanes;

/// A system: the interface of a machine for integrators and analyses.
typedef struct whirl_system {
    size_t dimension; ///< length of x
    double period;    ///< period of the forcing, and of Poincare sections, in units of t ("one revolution")

    /// Number of values that depend on time alone (cos t, sin t, ...), so that an integrator may tabulate them. 0:
    /// none.
    size_t forcing_count;
    /// Writes these values at t to forcing [forcing_count]; NULL if there are none.
    void (*forcing)(const void *model, double t, double *forcing);

    /// Computes the right-hand side. t runs from 0 to period in every revolution; `forcing` holds the values at t.
    void (*rhs)(const void *model, double t, const double *forcing, const double *x, double *dxdt);

    /// Optional: [dimension] the period of angles that turn for ever at a rate that no state changes (the phase of a
    /// cage or of a second shaft; not the angle of a pendulum), 0 for all other coordinates; borrowed. They are brought
    /// back between 0 and their period at the end of every revolution. Analyses skip them: a motion is periodic if its
    /// other coordinates return, and exponents leave them out.
    const double *turns;

    /// Number of revolutions after which all angles of `turns` return, and with them forces with these phases; 0:
    /// never.
    size_t repeats;

    /// True if the right-hand side has kinks without a switching function (Hertz contacts). Adaptive steps of two
    /// neighbouring motions then have different errors, so that perturbations are followed by the Jacobian, and motions
    /// do not run in lanes.
    bool kinked;

    /// Optional: number of switching functions, smooth in (t, x), whose zeros are the points where rhs is not smooth
    /// (contact, release, slip reversal). Integrators with root finding stop there.
    size_t switch_count;
    /// Writes the values of the switching functions [switch_count].
    void (*switches)(const void *model, double t, const double *x, double *values);

    /// Optional: computes the right-hand side with its laws kept on given sides of the switches: sides [switch_count],
    /// each -1 or +1, replaces the sign of the switching function. Smooth in (t, x), continued beyond the switch.
    void (*rhs_on_sides)(const void *model, double t, const double *forcing, const double *x, const double *sides,
                         double *dxdt);

    /// Optional: applies the derivative J = df/dx of the right-hand side to `count` perturbations: dx and ddxdt are
    /// [count][dimension]. With sides NULL, x selects the sides of the switches.
    void (*tangent)(const void *model, double t, const double *forcing, const double *x, const double *sides,
                    size_t count, const double *dx, double *ddxdt);

    /// Optional: returns the trace of J. Its mean along a motion is the sum of all Lyapunov exponents if f is
    /// continuous.
    double (*divergence)(const void *model, double t, const double *forcing, const double *x, const double *sides);

    /// Optional: computes the derivatives of switch `index` by x, gradient [dimension], and by t.
    void (*switch_gradient)(const void *model, double t, const double *x, size_t index, double *gradient,
                            double *by_time);

    /// Optional: applies the second derivative by x of switch `index` to u: out [dimension].
    void (*switch_curvature)(const void *model, double t, const double *x, size_t index, const double *u, double *out);

    /// Optional: returns true if a contact begins when switch `index` becomes positive; false if only the law changes
    /// (a slip reverses, a damped contact releases). NULL: contacts begin at all switches.
    bool (*switch_touches)(const void *model, size_t index);

    /// Optional: number of unilateral contacts.
    size_t contact_count;
    /// Writes the normal force of each contact [contact_count], 0 while open, in the model's unit of force; rotors use
    /// newtons.
    void (*contacts)(const void *model, const double *x, double *normal_force);

    /// Optional: writes for each contact [contact_count][2] the torque of its friction on the shaft against its
    /// rotation, N m, and the power that it dissipates, W; NaN for a contact of unknown radius.
    void (*friction)(const void *model, const double *x, double *friction);

    /// Number of frequencies of a machine whose coefficients depend on the frequency of whirl. The system is then the
    /// machine at one frequency, valid for linear analyses only. 0: no such coefficients.
    size_t frequency_count;
    const double *frequencies; ///< [frequency_count] at which the coefficients are known, rad/s, rising; borrowed

    size_t probe_count;        ///< number of probes, one a station
    const whirl_probe *probes; ///< [probe_count + extra_count] borrowed; lives as long as the system

    const void *model; ///< passed to every function; borrowed

    const whirl_lanes *lanes; ///< NULL for systems that are not rotors; borrowed

    /// Optional: [dimension] the period of angles that the state drives (a pendulum), 0 for all other coordinates;
    /// borrowed. The right-hand side has that period in them. The angles are brought to within half a period of 0 at
    /// the end of every revolution, and states that differ by whole periods are equal: a pendulum that goes over the
    /// top in every revolution moves periodically. 0 for coordinates with a period in `turns`.
    const double *angles;

    /// Optional: writes named order number `index`, from 0; false past the last.
    bool (*named_order)(const void *model, size_t index, whirl_named_order *out);

    /// Optional: number of control loops, as of magnetic bearings.
    size_t loop_count;
    /// Linearizes loop `index` at x: input [dimension] is the derivative of dx/dt by a signal that is added to that of
    /// the loop's sensor, and sensed [dimension] the gradient of the sensor's signal by the state.
    void (*loop)(const void *model, const double *x, size_t index, double *input, double *sensed);

    /// Optional: writes range number `index` of the machine's laws, from 0; the number of ranges is the same for all
    /// machines of a structure. False past the last. `seen` NULL: `reached` is NaN.
    bool (*range)(const void *model, size_t index, const whirl_extremes *seen, whirl_law_range *out);

    /// Optional: moves coordinates such as tilts of pads to where the forces on them balance, with all others as in x
    /// [dimension], and writes the kind of each coordinate to kinds [dimension]. Of several balances it takes the one
    /// to which the coordinates move from x; for NaN in x, one that is not idle. False if there is no such balance.
    /// Searches for equilibria then vary only the other coordinates.
    bool (*settle)(const void *model, double *x, whirl_settled *kinds);

    /// Optional: describes the film whose journal is a probe, with the machine at rest at x; the thinnest of several
    /// films. False if there is none.
    bool (*film)(const void *model, const double *x, size_t probe, whirl_film_gap *out);

    /// Optional: copies internal coordinates of parts (tilts of pads, currents) from the state y of another system with
    /// the same parts.
    void (*adopt)(const void *model, double *x, const struct whirl_system *other, const double *y);

    /// Optional, for machines with stations that twist: writes the twist of each probe's station, rad, in a small
    /// motion Re(v exp(i w t)), v [dimension][2], to shape [probe_count][2]. Returns the share of all twists in the
    /// kinetic energy, with masses lumped: 1 for a torsional mode.
    double (*twist)(const void *model, const double *v, double *shape);

    /// Optional, for machines with stations that move along their shafts: likewise, with axial displacements, m, in
    /// place of twists: 1 for an axial mode.
    double (*axial)(const void *model, const double *v, double *shape);

    size_t extra_count; ///< motions of stations besides x and y: each has a probe after those of all stations, whose x
                        ///< is the axial displacement in the state's units of length, or the twist in rad
    const whirl_extra *extras; ///< [extra_count] axial displacements first, stations rising; borrowed

    size_t spool_count;               ///< shafts whose speed does not depend on the rotor's
    const struct whirl_spool *spools; ///< [spool_count] borrowed

    size_t torque_count; ///< number of torques that are recorded in run-ups in which a drive turns the shaft
                         ///< (whirl_running.watch)

    size_t shaft_count; ///< shafts whose torques run-ups tell apart, since gears join them or they have speeds of their
                        ///< own (whirl_running.shaft_torques); 0: there is only one

    /// Optional, for machines with stations that twist: what excites them and what carries torque; borrowed.
    const whirl_torsion *torsion;

    /// NULL, or a flag that becomes true, for good, when motions of the machine shall end at once, within a revolution:
    /// discard everything computed from then on. Borrowed; no part of the equations. Motions in lanes end by the flag
    /// of the system for which their ensemble was made.
    const whirl_stop *stop;
} whirl_system;

/// Returns the number of all probes of a system: those of its stations, and those of axial displacements and twists.
size_t whirl_watched_probes(const whirl_system *system);

/// Maximum number of shafts of a rotor whose speed does not depend on the rotor's.
enum { WHIRL_MAX_SPOOLS = 3 };

/// Maximum number of shafts whose torques a run tells apart; a machine with more has no such torques.
enum { WHIRL_MAX_RUN_SHAFTS = 12 };

/// A shaft whose speed does not depend on the rotor's. Its speeds and torques are positive along its own rotation.
typedef struct whirl_spool {
    char name[WHIRL_NAME_SIZE]; ///< name of the shaft
    double speed;               ///< rad/s, of machines at constant speeds
    double sense;               ///< 1: it turns with the rotor, -1: against it
    bool driven;                ///< it has a drive of its own
    double drive_speed;         ///< rad/s, of the motor of that drive without load; 0: there is no such speed
} whirl_spool;

/// An unbalance that turns with the rotor.
typedef struct whirl_placed {
    size_t station;       ///< index of its probe
    double moment, angle; ///< kg m; rad from the x axis towards y, with the mark on the x axis
} whirl_placed;

/// Effects of the weight of a finite-element shaft at a station, positive upwards. NaN at stations that are on no
/// shaft; load and elevation are NaN at stations without a bearing.
typedef struct whirl_station_statics {
    double deflection; ///< m, of the shaft from the straight line through bearings without elevations
    double slope;      ///< rad, > 0 where it rises along the shaft
    double moment;     ///< N m, bending moment, > 0 where the shaft sags
    double shear[2];   ///< N, just left and just right of the station: sum of all forces on the shaft to the left
    double load;       ///< N, of the shaft on the bearings here
    /// kg, that load over the acceleration of gravity across the shafts; if there is none, the load of the same shaft
    /// lying.
    double carried;
    double bearings; ///< number of bearings here
    double mass[2];  ///< kg of the shaft and its masses to the left and to the right, without the station's own
    /// m, of the bearings here, at which the named couplings carry neither moment nor shear; 0 if no couplings are
    /// named.
    double elevation;
    double axial[2];    ///< N, in the shaft to the left and to the right, > 0 in tension; 0 beyond its ends
    double thrust;      ///< N, of the axial support of a standing shaft, if it is here; else NaN
    double thrust_mass; ///< kg, of that shaft with everything on it
} whirl_station_statics;

/// One machine of a family, with its initial state. `release(owner)` frees all of it.
typedef struct whirl_machine {
    const whirl_system *system;   ///< equations of motion
    const double *start;          ///< [system->dimension]
    void *owner;                  ///< owner of the system and the start
    void (*release)(void *owner); ///< frees them; may be NULL
    /// rad/s: rate of the system's time (whirl_rotor_clock), and speed of the shaft; for machines at rest.
    double clock, speed;
    double length;                         ///< m of one unit of displacement
    double cross_coupling;                 ///< N/m, sum over all stages
    double drive_speed;                    ///< rad/s, of the motor of its drive without load; 0: it has no such speed
    const struct whirl_run_course *course; ///< events and laws of a run (running.h), or NULL; not shared by threads
    const struct whirl_runup_options *run; ///< options of its run (record.h), in place of those of the study, or NULL
    double delay;                          ///< s, time at which its run begins in the table of a fit; 0 without one
    /// [probe_count] if requested (WHIRL_WITH_STATICS), else NULL; then also `influence`.
    const whirl_station_statics *statics;
    /// [probe_count][probe_count] N/m, change of the load of bearings at the first station by raising those at the
    /// second; 0: no bearings there.
    const double *influence;
} whirl_machine;

#ifdef __cplusplus
}
#endif
#endif
