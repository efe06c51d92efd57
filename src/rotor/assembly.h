/// Assembly of a rotor: its coordinates, their inertia, and the sum of the linear terms of stations and elements.
///
/// Stations that move in x and y have their coordinates first, in pairs. Stations that move along one axis, twists,
/// tilts and the nodes of shafts follow. All inputs are in SI units. The assembly scales them: time by 1/clock;
/// displacements by the length scale; tilts by the length scale divided by the station's radius of gyration (so that
/// tilts and displacements weigh alike in errors and distances); twists by the length scale divided by 1 m.
///
/// Axial displacements are those along the shaft, in the direction in which positions grow.
#ifndef ROTOR_ASSEMBLY_H
#define ROTOR_ASSEMBLY_H

#include <stdbool.h>
#include <stddef.h>

#include "body.h"
#include "drive.h"
#include "whirl/engine/rotor.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

// Symbols that elements outside the library use have names that begin with whirl_.
#define assembly_find whirl_assembly_find
#define assembly_find_plane whirl_assembly_find_plane
#define assembly_inertia whirl_assembly_inertia
#define assembly_stiffness_scale whirl_assembly_stiffness_scale
#define assembly_force_scale whirl_assembly_force_scale
#define assembly_stiffness whirl_assembly_stiffness
#define assembly_damping whirl_assembly_damping
#define assembly_spring whirl_assembly_spring
#define assembly_share whirl_assembly_share
#define assembly_join whirl_assembly_join
#define assembly_link whirl_assembly_link
#define assembly_torque whirl_assembly_torque
#define assembly_turns whirl_assembly_turns
#define assembly_harmonic whirl_assembly_harmonic
#define assembly_fatigue whirl_assembly_fatigue
#define assembly_damper whirl_assembly_damper
#define assembly_inertance whirl_assembly_inertance
#define assembly_inerter whirl_assembly_inerter
#define assembly_forcing whirl_assembly_forcing
#define assembly_turning whirl_assembly_turning
#define assembly_gyroscopic whirl_assembly_gyroscopic
#define assembly_unbalance whirl_assembly_unbalance
#define assembly_inertial whirl_assembly_inertial
#define assembly_frequencies whirl_assembly_frequencies
#define assembly_runout whirl_assembly_runout
#define assembly_pull whirl_assembly_pull
#define assembly_weigh whirl_assembly_weigh
#define assembly_ground_damping whirl_assembly_ground_damping

/// NO_COORDINATE: a motion without a coordinate. NO_SHAFT: a station that is on no shaft.
#define NO_COORDINATE ((size_t)-1)
#define NO_SHAFT ((size_t)-1)
#define NO_STATION ((size_t)-1)

/// Directions in which a station can move: along x and y; the slopes dx/dz and dy/dz of its axis, where z is along the
/// shaft; the twist about z, from x towards y, without the steady rotation; and the displacement along z.
typedef enum axis { AXIS_X, AXIS_Y, AXIS_TILT_X, AXIS_TILT_Y, AXIS_TWIST, AXIS_AXIAL, AXES } axis;

/// Numbers of a station that moves in x and y, for the station pass (station_kernel.h). Forces that depend on its
/// displacement are linear terms or elements.
enum { STATION_DAMPING, STATION_UNBALANCE_COS, STATION_UNBALANCE_SIN, STATION_PULL_X, STATION_PULL_Y, STATION_NUMBERS };

/// Indices of the forcing (whirl_system.forcing): cosine and sine of tau and of 2 tau.
enum { COS_TAU, SIN_TAU, COS_2TAU, SIN_2TAU, FORCING_COUNT };

/// A term of the acceleration of a coordinate: its number times a coordinate, a velocity, a number of the forcing, or
/// 1.
typedef enum source { SOURCE_PLACE, SOURCE_VELOCITY, SOURCE_FORCING, SOURCE_ONE } source;
typedef struct linear_term {
    size_t row;
    source source;
    size_t column; ///< coordinate, or index of the forcing
    double number;
} linear_term;

/// Coupling of accelerations by mass, in addition to the coordinates' own inertia: kg, kg m or kg m2.
typedef struct mass_term {
    size_t row, by;
    double mass;
} mass_term;

/// A harmonic of the runout at a station, m.
typedef struct station_runout {
    size_t station;
    whirl_runout seen;
} station_runout;

/// Effect of an inertia that turns with the shaft, an unbalance or a skew, on one coordinate. The force on the
/// coordinate is the square of the speed times (cos C + sin S), where C and S are the values COS_TAU and SIN_TAU of the
/// forcing.
typedef struct turning_inertia {
    size_t row;
    double cos, sin; ///< kg m, of tilts kg m2
} turning_inertia;

/// A spring between two twists. coordinate: those of the twists; share: ratio of each twist to its coordinate.
typedef struct twist_link {
    size_t coordinate[2];
    double share[2];
    double stiffness, damping, inertance; ///< N m/rad, N m s/rad and kg m2
    double modulus;                       ///< torsional section modulus of the weakest section, m3; 0: unknown
} twist_link;

/// Definition of the frequency of a harmonic torque.
typedef enum harmonic_rate {
    HARMONIC_STEADY,     ///< the torque is steady
    HARMONIC_BY_ROTOR,   ///< `rate` times the speed of the rotor
    HARMONIC_BY_STATION, ///< `rate` times the speed of its station
    HARMONIC_FIXED       ///< `rate` rad/s
} harmonic_rate;

/// A steady or harmonic torque on a station that twists, for its response to torques.
typedef struct harmonic_torque {
    size_t station;
    harmonic_rate of;
    double rate, phase; ///< phase: rad, at t = 0
    bool about_z;       ///< it is positive about z; otherwise along the rotation of its station
    bool felt;          ///< a steady torque that the machine's equations already contain
    size_t count;       ///< rows of its table over the speed of its station; 1: constant
    double speeds[WHIRL_MAX_LIST], torques[WHIRL_MAX_LIST]; ///< rad/s, N m
} harmonic_torque;

/// S-N curve of the torque between two stations, by ranges (peak to peak) of the torque or of the shear stress.
typedef struct twist_fatigue {
    size_t station[2];
    bool by_stress;       ///< ranges are in Pa; otherwise in N m
    double modulus;       ///< section modulus, m3; 0: that of the part which joins the stations
    double concentration; ///< factor of stress concentration in the section
    size_t count;         ///< points of the curve
    double ranges[WHIRL_MAX_LIST], lives[WHIRL_MAX_LIST]; ///< falling ranges, growing lives
    double slope, endurance;                              ///< as in whirl_signals_damage
} twist_fatigue;

/// An unbalance of a station on a shaft of another speed than the rotor's, kg m and rad: it turns with that shaft.
typedef struct aside_unbalance {
    size_t station;
    double moment, angle;
} aside_unbalance;

typedef struct assembly_station {
    const char *name;
    double mass, diametral, polar;  ///< kg, kg m2; a station with a diametral inertia tilts
    double shaft_polar;             ///< kg m2 of the shaft, against twist alone
    double turned_polar;            ///< kg m2 of the shaft, whether it twists or not
    double shaft_mass, shaft_axial; ///< kg: the shaft's part of `mass`; the shaft's inertia against axial motion, which
                                    ///< replaces shaft_mass there
    double fluid;                   ///< kg of fluid that is moved along; inertia without weight or unbalance
    bool moves_x, moves_y, twists, axial;
    size_t geared_to;        ///< station whose twist times `gear` is the twist of this station; NO_STATION: the twist
                             ///< has its own coordinate
    double gear;             ///< ratio of its twist to that coordinate; 1 without a rigid gear
    size_t shaft;            ///< shaft of finite elements of which it is a node; NO_SHAFT: none
    bool lumped;             ///< it is on a shaft without segments
    size_t carrier;          ///< number of the design's shaft that carries it, from 1; 0: none
    double ratio;            ///< ratio of its shaft's speed to the rotor's; 1 without a shaft
    size_t spool;            ///< number of its shaft among those with a speed of their own, from 1; 0: none of these
    double position;         ///< position along that shaft, m
    double pull_moment;      ///< moment of the shaft's weight between its nodes, divided by gravity, kg m
    bool hidden;             ///< a node of the mesh that is not a station of the design
    size_t place;            ///< index among the stations that move in x and y
    size_t coordinate[AXES]; ///< NO_COORDINATE for directions in which it does not move
} assembly_station;

typedef struct assembly {
    double speed, length;              ///< speed of the shaft, rad/s, in either direction; length scale, m
    double clock;                      ///< rad/s of the phase that defines sections: tau = clock t
    double pace;                       ///< speed for the laws of sliding surfaces, rad/s: never 0
    double turn;                       ///< pace/clock, negative if the shaft turns clockwise, from y to x
    bool phased;                       ///< the shaft's phase is a state; forces that turn with the shaft are terms, not
                                       ///< numbers of stations
    size_t station_count, plane_count; ///< stations, and those that move in x and y
    assembly_station *stations;
    double (*numbers)[STATION_NUMBERS]; ///< [plane_count]
    size_t degrees;
    size_t twist_count, first_twist; ///< coordinates that are twists, and the first of them
    size_t axial_count, first_axial; ///< coordinates that are axial displacements, likewise
    double *inertia, *unit;          ///< [degrees] inertia of each coordinate, kg or kg m2; size of its unit, m or rad
    size_t term_count, term_capacity;
    linear_term *terms;
    size_t mass_count, mass_capacity;
    mass_term *masses;
    body body;           ///< shafts of finite elements
    bool in_time;        ///< frequency-dependent coefficients become transfer functions with states
    double frequency;    ///< frequency of whirl at which frequency-dependent coefficients are taken, rad/s
    double *frequencies; ///< [frequency_count] ascending frequencies of all tables over the frequency, rad/s
    size_t frequency_count;
    size_t runout_count, runout_capacity;
    station_runout *runouts; ///< runout of probes
    size_t turning_count, turning_capacity;
    turning_inertia *turnings; ///< inertias that turn with the rotor's own shaft
    turning_inertia guided[2]; ///< likewise, sums along x and y of the unbalances of stations that do not move along
                               ///< that axis
    size_t weight_count, weight_capacity;
    turning_inertia *weights; ///< forces by a pull of 1 m/s2 along x (cos) and along y (sin): kg, of tilts kg m
    double pull[2];           ///< gravity across the shafts, m/s2
    shaft_drive drive;        ///< motor and load of a shaft whose speed is a state
    bool spools_vary;         ///< shafts with a speed of their own change it: their forces depend on it as on a forcing
    size_t spool_count;
    whirl_spool spools[WHIRL_MAX_SPOOLS];       ///< [spool_count] shafts with a speed of their own
    shaft_drive spool_drives[WHIRL_MAX_SPOOLS]; ///< [spool_count] their drives
    size_t spool_of_shaft[WHIRL_MAX_SHAFTS];    ///< of every shaft of the design, from 1; 0: the rotor gives its speed
    size_t torque_count;
    shaft_torque *torques; ///< [torque_count] other torques on such a shaft
    size_t link_count, link_capacity;
    twist_link *links; ///< [link_count] joints between twists
    size_t hold_count, hold_capacity;
    twist_link *holds; ///< [hold_count] joints between twists and the ground; coordinate[1], that of the ground, is
                       ///< NO_COORDINATE
    size_t harmonic_count, harmonic_capacity;
    harmonic_torque *harmonics; ///< [harmonic_count] torques to which the twists respond
    size_t fatigue_count, fatigue_capacity;
    twist_fatigue *fatigues; ///< [fatigue_count] S-N curves of torques
    bool grounded;           ///< a spring holds a twist to the ground
    double stages;           ///< factor of the stages' cross couplings
    double cross_coupling;   ///< N/m, the sum of cross couplings, each counted once
    bool balanced;           ///< unbalance and skew are ignored
    const char *aside;       ///< station with an unbalance that turns with the rotor, on a shaft of another speed
    size_t aside_count, aside_capacity;
    aside_unbalance *asides; ///< [aside_count] unbalances of such stations themselves, which become elements
    bool no_memory;          ///< a term was lost
} assembly;

/// Makes an assembly of stations that move in x and y and have no mass yet. speed: negative (or -0.0) for a clockwise
/// shaft. At standstill the unit of time is a second, and laws take their limits for a speed that tends to 0: `pace`
/// and `turn` are those of a shaft that turns once in 2e11 years. WHIRL_NO_MEMORY. Freed by assembly_clear.
whirl_status assembly_begin(assembly *to, double speed, double length, size_t station_count);
void assembly_clear(assembly *to);

/// Returns the shaft's speed, rad/s, negative for a clockwise shaft.
double assembly_spin(const assembly *of);

/// Returns the speed of a design for the laws of sliding surfaces, rad/s (assembly.pace).
double assembly_pace_of(double speed);

/// Returns the speed of a shaft whose speed is its own, rad/s, positive about z. spool: from 1.
double assembly_spool_spin(const assembly *of, size_t spool);

/// Returns the value for a body's term (body_kind.value) in proportion to that speed, and multiplies *factor by the
/// speed if it is constant.
int assembly_spool_value(const assembly *of, size_t spool, double *factor);

/// Returns true if a station is on a shaft that turns at another speed than the rotor, or may do so.
bool assembly_is_aside(const assembly *of, size_t station);

/// Returns the ratio of the speed of a housing to the rotor's: that of its shaft, 0 without a shaft.
double assembly_housing_ratio(const assembly *of, size_t station);

/// Returns true if the shaft stands still, at its angle of t = 0. Stiffness that turns with the shaft (flats, cracks)
/// stays at that angle. Forces that turn with the shaft count with their mean over a turn, which is 0.
bool assembly_stands(const assembly *of);

/// Numbers the coordinates, when all inertia is known. order [station_count]: order of the stations; NULL: as they are
/// listed. WHIRL_BAD_INPUT for a station without mass.
whirl_status assembly_number(assembly *to, const size_t *order);

/// Finds the coordinate of a station along an axis. If it has none, returns WHIRL_BAD_INPUT with a sentence.
whirl_status assembly_find(const assembly *of, size_t station, axis along, size_t *coordinate);

/// Returns the ratio of the motion of a station along an axis to its coordinate: 1, for twists the ratio of rigid
/// gears.
double assembly_share(const assembly *of, size_t station, axis along);

/// Ties the twist of `station` to `ratio` times the twist of `other` (rigid gears). To be called before coordinates are
/// numbered. WHIRL_BAD_INPUT if the station already follows another one.
whirl_status assembly_gear(assembly *to, size_t station, size_t other, double ratio);

/// Finds the coordinates of a station along x, port[0], and y, port[1].
whirl_status assembly_find_plane(const assembly *of, size_t station, size_t port[2]);

/// Returns the mass that a force on a station accelerates along x and y, kg: its own and that of the fluid.
double assembly_inertia(const assembly *of, size_t station);

/// Returns the scale of a stiffness on a station, kg rad^2/s^2.
double assembly_stiffness_scale(const assembly *of, size_t station);

/// Returns the divisor that turns a force (N or N m) on a coordinate into its acceleration.
double assembly_force_scale(const assembly *of, size_t coordinate);

/// Adds -stiffness times the coordinate `by`, or -damping times its velocity, to the force on `row`; nothing if one of
/// them is NO_COORDINATE. Units are N/m and N s/m; with tilts N, N m, N s and N m s.
void assembly_stiffness(assembly *to, size_t row, size_t by, double stiffness);
void assembly_damping(assembly *to, size_t row, size_t by, double damping);

/// Adds a spring or damper between two coordinates. One of them may be NO_COORDINATE, the ground.
void assembly_spring(assembly *to, size_t one, size_t other, double stiffness);
void assembly_damper(assembly *to, size_t one, size_t other, double damping);

/// Adds a number of the mass matrix: -mass times the acceleration of the coordinate `by` to the force on `row` and, if
/// these are two coordinates, -mass times the acceleration of `row` to the force on `by`. mass: kg, with tilts kg m or
/// kg m2. Adds nothing if one of them is NO_COORDINATE.
void assembly_inertance(assembly *to, size_t row, size_t by, double mass);

/// Adds a mass that resists the acceleration of one coordinate relative to another (an inerter: Smith 2002). One of
/// them may be NO_COORDINATE, the ground.
void assembly_inerter(assembly *to, size_t one, size_t other, double mass);

/// A joint between two places: stiffness, damping and inertance in N/m, N s/m and kg; between angles in N m/rad, N m
/// s/rad and kg m2.
typedef struct joining {
    double stiffness, damping, inertance;
    double modulus; ///< as in twist_link
} joining;

/// Returns the torsional section modulus of a round shaft, m3, by which a torque is divided to give the shear stress.
static inline double joining_modulus(double outer, double inner) {
    const double share = inner / outer;
    return 0.19634954084936207740 * outer * outer * outer * (1.0 - share * share * share * share); // pi/16
}

/// Joins two places. One of them may be the ground, whose coordinate is NO_COORDINATE. share: ratio of the motion of
/// each place to its coordinate (assembly_share).
void assembly_join(assembly *to, const size_t coordinate[2], const double share[2], const joining *by);

/// Joins two stations along an axis. One of them may be NO_STATION, the ground. Does nothing if neither moves that way.
void assembly_link(assembly *to, axis along, size_t one, size_t other, const joining *by);

/// Adds a torque to which the twists respond.
void assembly_harmonic(assembly *to, const harmonic_torque *torque);

/// Adds the S-N curve of a torque.
void assembly_fatigue(assembly *to, const twist_fatigue *curve);

/// Checks that a torque on a station, or on the shaft as a whole (NO_STATION), acts on the rotor's own shaft or on a
/// station that twists. WHIRL_BAD_INPUT if its shaft has another speed and does not twist.
whirl_status assembly_turns(const assembly *of, size_t station);

/// Adds a torque that acts while the speed of the shaft is a state. WHIRL_BAD_INPUT for one torque too many, and as
/// assembly_turns.
whirl_status assembly_torque(assembly *to, const shaft_torque *torque);

/// Adds a term that is already scaled.
void assembly_term(assembly *to, linear_term term);

/// Adds a force (N or N m) times a value of the forcing to the coordinate; nothing if the shaft stands still.
void assembly_forcing(assembly *to, size_t row, size_t value, double force);

/// Adds a force on a pair of coordinates that turns with the shaft, from `angle` (rad) at tau = 0.
void assembly_turning(assembly *to, size_t x, size_t y, double force, double angle);

/// Adds the gyroscopic moments of a polar inertia (kg m2) at a station that tilts: I_d phi'' - i I_p omega phi' = M
/// with phi = tilt_x + i tilt_y.
void assembly_gyroscopic(assembly *to, size_t station, double polar);

/// Notes an inertia (kg m, of tilts kg m2) at `angle` (rad) that turns with the shaft, for machines whose speed
/// changes. Its force at the constant speed must be added separately.
void assembly_inertial(assembly *to, size_t x, size_t y, double moment, double angle);

/// Adds an unbalance of `moment` (kg m) at `angle` (rad, from the x axis at tau = 0).
void assembly_unbalance(assembly *to, size_t station, double moment, double angle);

/// Adds the eccentricity of a station or disc, kg m, which turns with the shaft of its station. given: by its key.
void assembly_eccentric(assembly *to, size_t station, double moment, double angle, bool given);

/// Registers ascending frequencies of whirl [count] of a table of coefficients. Of several tables, the frequencies that
/// all of them cover are kept. WHIRL_BAD_INPUT if they have no common range.
whirl_status assembly_frequencies(assembly *to, size_t count, const double *frequencies);

/// Adds a harmonic (m) of the runout at a station to what probes see there.
void assembly_runout(assembly *to, size_t station, whirl_runout seen);

/// Adds a uniform acceleration (m/s2), such as gravity, that acts on the own masses of all stations.
void assembly_pull(assembly *to, double x, double y);

/// Adds a pull along z (m/s2), in the direction in which positions grow, on the masses of a shaft and its stations;
/// NO_SHAFT: on those of all stations.
void assembly_pull_axially(assembly *to, size_t shaft, double pull);

/// Lists the forces of a gravity of 1 m/s2 along x and along y on all masses (`weights`). To be called once, when all
/// inertia is known.
void assembly_weigh(assembly *to);

/// Adds damping (N s/m) between a station and the ground.
void assembly_ground_damping(assembly *to, size_t station, double damping);

/// Sorts the terms by row, and merges terms of one row, column and kind. Returns false if a term was lost for lack of
/// memory.
bool assembly_finish(assembly *to);

#endif
