/// A system: what the integrators and the analyses know of a machine. Rotors give one; a user of the library
/// can write one by hand (see examples/duffing.c).
///
///     dx/dt = f(t, x),   f(t + period, x) = f(t, x)
///
/// A system is immutable and shared by all threads; the functions must depend on their arguments alone.
#ifndef WHIRL_SYSTEM_H
#define WHIRL_SYSTEM_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/descriptor.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Bounds of systems.
enum {
    WHIRL_MAX_FORCING = 256,   ///< most values that depend on time alone
    WHIRL_MAX_SWITCHES = 4096, ///< most switching functions
    WHIRL_MAX_CONTACTS = 1024, ///< most unilateral contacts
    WHIRL_MAX_PROBES = 256,    ///< most probes
    WHIRL_MAX_TILTING = 6,     ///< most pads of a bearing of a machine
    WHIRL_MAX_REPEATS = 128    ///< longest period of forces, in revolutions, that rotors look for
};

/// A harmonic of what probes see of a shaft that runs out, over its motion: Re(v exp(i order tau)), tau the angle of
/// the system's time, in the state's units of length.
typedef struct whirl_runout {
    int order;                  ///< how often it comes round in a revolution
    double first[2], second[2]; ///< real and imaginary part of v, of the probes along x and along y
} whirl_runout;

/// A pair of displacement coordinates that is observed together, as a pair of proximity probes sees a shaft.
/// `x` and `y` index the state; `vx` and `vy` their derivatives. What moves along one axis has y = x and vy = vx: it
/// moves along x, or with `along_y` along y, and not along the other.
typedef struct whirl_probe {
    char name[WHIRL_NAME_SIZE]; ///< of the station
    size_t x, y, vx, vy;        ///< indices of coordinates
    /// Clearance of the journal bearing here in the state's units of length, 0 where there is none:
    /// radius / clearance is the eccentricity ratio.
    double clearance;
    /// Radius at which the station touches a stator, in the state's units of length; 0 where there is none.
    double gap;
    size_t shaft;        ///< number of the shaft of finite elements that the station lies on, from 1; 0: on none
    double position;     ///< along that shaft, m
    bool along_y;        ///< where y = x: the one coordinate is that along y
    bool clockwise;      ///< the rotor turns from y to x, so that a whirl that way is forward; false: from x to y
    size_t runout_count; ///< of the shaft here
    const whirl_runout *runout; ///< [runout_count] borrowed from the system; results have none
    /// [4] What x, y, vx and vy of the state are multiplied by to be what is reported, where the coordinates of a
    /// system have scales of their own (whirl_user_system_scale); NULL: 1. Borrowed from the system; results have none.
    const double *units;
} whirl_probe;

/// Whether it sees a displacement along x (which: 0) or y (1).
bool whirl_probe_sees(const whirl_probe *probe, size_t which);

/// x, y, vx or vy (nth: 0 to 3) out of a state, in the units that are reported; 0 along an axis that it does not see.
double whirl_probe_value(const whirl_probe *probe, const double *state, size_t nth);

/// What it sees more along x (which: 0) or y (1) than the displacement, by the runout after so many revolutions.
double whirl_probe_runout(const whirl_probe *probe, size_t which, double revolutions);

/// Which way its rotor turns: 1, or -1 clockwise.
double whirl_probe_way(const whirl_probe *probe);

/// Its numbers, where the indices of coordinates are those that an initial state may be said of (part "initial");
/// static, ended by one without a part.
const whirl_member *whirl_probe_members(void);

/// An order that a machine names: lines of spectra there are told by that name ("BPFO 3.08X of ball_bearing at rear").
typedef struct whirl_named_order {
    double order;                   ///< how often it comes round in a revolution, above 0
    char name[8];                   ///< "BPFO"
    char part[2 * WHIRL_NAME_SIZE]; ///< whose it is: "ball_bearing at rear"
    size_t probe;                   ///< where that is
} whirl_named_order;

/// What a motion, or a place of rest, came to.
typedef struct whirl_extremes {
    const double *low, *high; ///< [dimension] of coordinates at any instant
    const double *max_radius; ///< [probe_count] largest distances from the centre
} whirl_extremes;

/// A quantity of a part, and how far the part's law is for: beyond it the motion is not that of such a part.
typedef struct whirl_law_range {
    char part[2 * WHIRL_NAME_SIZE]; ///< "film at journal"
    const char *quantity, *unit;    ///< "eccentricity ratio", "1"
    const char *limit;              ///< what ends there: "that its coefficients are known for"
    double most;                    ///< the law is for up to that
    double reached;                 ///< the most that it came to; NaN where the extremes do not tell
    size_t probe;                   ///< where the part is
} whirl_law_range;

/// What the film of a bearing or seal leaves to its journal, in the state's units of length.
typedef struct whirl_film_gap {
    double least;                 ///< radial thickness where it is thinnest; pads without a film do not count
    double wall;                  ///< how far from the centre the journal touches in the direction in which it lies
    size_t pads;                  ///< of pads that tilt how many there are, else 0
    bool held[WHIRL_MAX_TILTING]; ///< [pads] a film holds it
} whirl_film_gap;

/// Whether a coordinate has a balance of its own (whirl_system.settle).
typedef enum whirl_settled {
    WHIRL_NOT_SETTLED, ///< it has none
    WHIRL_SETTLED,     ///< it is where forces on it balance
    WHIRL_IDLE         ///< no force acts on it, and it acts on nothing: a pad without a film
} whirl_settled;

/// The form of a system that runs in vector lanes; private to the library.
typedef struct whirl_lanes whirl_lanes;

/// A system: all that integrators and analyses know of a machine.
typedef struct whirl_system {
    size_t dimension; ///< length of x
    double period;    ///< of the forcing, and from one Poincare section to the next, in units of t ("one revolution")

    /// Optional: the values that depend on time alone (cos t, sin t, ...), so that an integrator may tabulate them.
    /// Writes `forcing_count` numbers. NULL when forcing_count is 0.
    size_t forcing_count;
    /// Writes these values at t.
    void (*forcing)(const void *model, double t, double *forcing);

    /// The right-hand side. t runs from 0 to period in every revolution; `forcing` holds the values at t.
    void (*rhs)(const void *model, double t, const double *forcing, const double *x, double *dxdt);

    /// Optional: [dimension] the period of coordinates that are angles which turn on and on at a rate that nothing in
    /// the state changes (the phase of a cage, of a second shaft; not the angle of a pendulum), 0 of all others;
    /// borrowed. They are brought back between 0 and their period at the end of every revolution, and analyses do not
    /// look at them: a motion whose other coordinates return is periodic, and exponents leave them out.
    const double *turns;

    /// With turning coordinates: revolutions after which all of them have come back, so that what they force may
    /// return; 0: there is no such number, and what they force never does.
    size_t repeats;

    /// The right-hand side has kinks that no switch tells of (Hertz contacts): adaptive steps of two motions side by
    /// side err differently there, so that perturbations are followed by the Jacobian, and such motions go alone.
    bool kinked;

    /// Optional: switching functions, smooth in (t, x), whose zeros are where rhs is not smooth (contact,
    /// release, slip reversal). Writes `switch_count` values. Integrators with root finding stop there.
    size_t switch_count;
    /// Writes these values.
    void (*switches)(const void *model, double t, const double *x, double *values);

    /// Optional: the right-hand side with its laws held on given sides of the switches: sides [switch_count], each -1
    /// or +1, the sign of the switching function that is assumed, whatever x says; smooth in (t, x), continued beyond
    /// the switch.
    void (*rhs_on_sides)(const void *model, double t, const double *forcing, const double *x, const double *sides,
                         double *dxdt);

    /// Optional: the derivative J = df/dx of the right-hand side applied to `count` perturbations: dx and ddxdt are
    /// [count][dimension]. With sides NULL x decides on which side of the switches the laws are.
    void (*tangent)(const void *model, double t, const double *forcing, const double *x, const double *sides,
                    size_t count, const double *dx, double *ddxdt);

    /// Optional: the trace of J. Its mean along a motion is the sum of all Lyapunov exponents where f is continuous.
    double (*divergence)(const void *model, double t, const double *forcing, const double *x, const double *sides);

    /// Optional: the derivative of switch `index` by x, gradient [dimension], and by t.
    void (*switch_gradient)(const void *model, double t, const double *x, size_t index, double *gradient,
                            double *by_time);

    /// Optional: the second derivative by x of switch `index` applied to u: out [dimension].
    void (*switch_curvature)(const void *model, double t, const double *x, size_t index, const double *u, double *out);

    /// Optional: whether a contact begins where switch `index` becomes positive, or a motion only goes over to another
    /// law there (a slip that reverses, a damped contact that lets go). NULL: contacts begin at all of them.
    bool (*switch_touches)(const void *model, size_t index);

    /// Optional: unilateral contacts. Writes for each of `contact_count` the normal force, 0 while open,
    /// in the model's unit of force; rotors give newtons.
    size_t contact_count;
    /// Writes these forces [contact_count].
    void (*contacts)(const void *model, const double *x, double *normal_force);

    /// Optional: what the friction of contacts does, [contact_count][2]: the torque on the shaft against its rotation,
    /// N m, and the power that it takes, W; not a number of those whose radius is not known.
    void (*friction)(const void *model, const double *x, double *friction);

    /// Of a machine with coefficients that depend on the frequency of whirl: rad/s, rising, at which these are known.
    /// It is the machine at one frequency, whose linear analyses alone mean anything. 0: there are none.
    size_t frequency_count;
    const double *frequencies; ///< [frequency_count]; borrowed

    size_t probe_count;        ///< of probes
    const whirl_probe *probes; ///< borrowed; lives as long as the system

    const void *model; ///< handed to every function; borrowed

    const whirl_lanes *lanes; ///< NULL for systems that are not rotors; borrowed

    /// Optional: [dimension] the period of coordinates that are angles which the state drives (that of a pendulum), 0
    /// of all others; borrowed. Slopes have that period in them. They are brought to within half a period of 0 at the
    /// end of every revolution, and states that differ by whole periods are the same: a pendulum that goes round and
    /// round moves periodically. Of a coordinate that `turns` it is 0.
    const double *angles;

    /// Optional: order number `index`, from 0 on, that the machine names; false beyond the last.
    bool (*named_order)(const void *model, size_t index, whirl_named_order *out);

    /// Optional: loops of control, as magnetic bearings have them.
    size_t loop_count;
    /// Of loop `index` at x: what a signal that is added to its sensor's adds to the slope, by that signal, input
    /// [dimension], and the sensor's own signal by the state, sensed [dimension].
    void (*loop)(const void *model, const double *x, size_t index, double *input, double *sensed);

    /// Optional: range number `index` of a law of the machine, from 0 on, as many for all machines of a structure;
    /// false beyond the last. `seen` NULL: nothing is reached.
    bool (*range)(const void *model, size_t index, const whirl_extremes *seen, whirl_law_range *out);

    /// Optional: sets coordinates that have a balance of their own (the tilts of pads) to it, those that they depend on
    /// held as they are in x [dimension], and says of all in kinds [dimension] which these are. Of several balances it
    /// takes that to which they go from where they are in x, or where x has NaN, one that is not idle. False where
    /// there is no such balance. Searches for equilibria then go through the other coordinates alone.
    bool (*settle)(const void *model, double *x, whirl_settled *kinds);

    /// Optional: the film at a probe that has a clearance, with the machine at rest at x: of several the thinnest.
    /// False where there is none.
    bool (*film)(const void *model, const double *x, size_t probe, whirl_film_gap *out);

    /// Optional: sets coordinates of parts' own (tilts of pads, currents) to what they are in another system that has
    /// these parts, at y.
    void (*adopt)(const void *model, double *x, const struct whirl_system *other, const double *y);
} whirl_system;

/// An unbalance that turns with the rotor.
typedef struct whirl_placed {
    size_t station;       ///< index of its probe
    double moment, angle; ///< kg m; rad from the x axis towards y at the mark
} whirl_placed;

/// What the weight of a shaft of finite elements does at a station, upwards where it has a sense. NaN where a station
/// lies on no shaft, and loads and elevations of stations without a bearing.
typedef struct whirl_station_statics {
    double deflection; ///< of the shaft, m, from the straight line that bearings without elevations lie on
    double slope;      ///< rad, > 0 where it rises along the shaft
    double moment;     ///< N m, bending moment, > 0 where the shaft sags
    double shear[2];   ///< N, all forces on the shaft to the left of it, this end and the other end of its own
    double load;       ///< N, of the bearings here, that carry the shaft
    double carried;   ///< kg, that load over the acceleration of gravity; where the machine has none across its shafts,
                      ///< what the bearings would carry, did the shaft lie
    double bearings;  ///< how many there are here
    double mass[2];   ///< kg of the shaft and what it carries to the left and to the right, without its own
    double elevation; ///< m, of the bearings here, with which couplings carry neither moment nor shear; 0 without them
    double axial[2];  ///< N, in the shaft to the left and to the right, > 0 where it is pulled; 0 beyond its ends
    double thrust;    ///< N, of what holds a shaft that stands here along its axis; NaN where nothing does
    double thrust_mass; ///< kg, of that shaft with all that is on it
} whirl_station_statics;

/// One of a family of machines, with the state it starts from. `release(owner)` frees all of it.
typedef struct whirl_machine {
    const whirl_system *system;   ///< how it moves
    const double *start;          ///< [system->dimension]
    void *owner;                  ///< of the system and the start
    void (*release)(void *owner); ///< frees them; may be NULL
    double clock, speed;   ///< rad/s: of the system's time (whirl_rotor_clock), and of the shaft; for machines at rest
    double length;         ///< m of one unit of displacement
    double cross_coupling; ///< N/m, the sum of those of all stages
    /// [probe_count] where they were asked for (WHIRL_WITH_STATICS), else NULL; with them
    const whirl_station_statics *statics;
    /// [probe_count][probe_count] N/m, the load of the bearings at the first by raising those at the second; 0: none.
    const double *influence;
} whirl_machine;

#ifdef __cplusplus
}
#endif
#endif
