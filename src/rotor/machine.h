/// The built rotor, for its equations of motion.
#ifndef ROTOR_MACHINE_H
#define ROTOR_MACHINE_H

#include "between.h"
#include "coupling.h"
#include "element.h"
#include "lanes.h"
#include "whirl/engine/rotor.h"
#include "whirl/engine/system.h"
#include "whirl/internal/model.h"

/// The twist of a station: its coordinate, NO_COORDINATE if the station does not twist; and the ratio of the twist to
/// it.
typedef struct station_twist {
    size_t coordinate;
    double share;
} station_twist;

/// A rigid pair of gears: the twist of the second station is `ratio` times that of the first.
typedef struct rigid_pair {
    size_t first, second;
    double ratio;
} rigid_pair;

/// A shaft of a machine with several ones, for the torques of a run: stations between which no gear is.
typedef struct rotor_shaft {
    size_t station; ///< its first station
    size_t spool;   ///< its number among those with a speed of their own, from 1; 0: none of these
    double turns;   ///< in a rigid turn: the ratio of its angle to that of the rotor, positive about z with that; of a
                    ///< shaft with a speed of its own 1
    double polar;   ///< kg m2, inertia of its stations and segments; 0: not known
} rotor_shaft;

/// A part of a shaft that twists: a station, or a node between stations.
typedef struct rotor_part {
    size_t shaft;
    station_twist twist;
    double polar; ///< kg m2
} rotor_part;

struct whirl_rotor {
    double speed, clock, length;
    double cross_coupling; ///< sum of the cross couplings of all stages, N/m
    /// 1, or -1 for a clockwise shaft, with which unbalances and other parts turn by -tau (if the phase is a state,
    /// `way` is 1, and the slope of the phase has the sign); 0: the shaft stands still.
    double way;
    char keyphasor[WHIRL_NAME_SIZE + 16]; ///< name of the phase that defines sections; "": the shaft's
    /// If the shaft's phase is a state: its row among the rates. The last of the machine's numbers is then its slope.
    /// Otherwise 0.
    size_t phase;
    whirl_system system;
    whirl_lanes lanes;
    int pair_laws[2];                  ///< laws of shaft and rub, if the machine is a pair (pair.h)
    size_t station_count, plane_count; ///< stations, and those that move in x and y
    size_t term_count, element_count, contact_count;
    linear_term *terms;
    coupling coupled; ///< mass coupling; the same in all machines of a block
    /// Terms of shafts of finite elements; the same in all machines of a block.
    body_panels body;  ///< numbers, scaled except for their rates
    size_t first_rate; ///< index of the machine's rates among its numbers
    size_t begun;      ///< first coordinate whose acceleration the body sets; those before it are set by stations or
                       ///< cleared
    between_term *between; ///< [between_count] displacements of nodes between stations as functions of those of the
                           ///< stations
    size_t between_count;
    double *frequencies; ///< [frequency_count] as in whirl_system
    size_t frequency_count;
    element *elements;   ///< [element_count] elements with kernels, in the registry's order
    double *numbers;     ///< [plane_count][STATION_NUMBERS] numbers of stations, then those of the terms, then those of
                         ///< the elements
    size_t *places;      ///< [plane_count + element_count] as in whirl_lanes
    whirl_probe *probes; ///< [3 station_count] those of stations, then those of axial displacements and of twists
    size_t extra_count;  ///< probes of these
    whirl_extra *extras; ///< [2 station_count]
    double (*radians)[4];            ///< [station_count] units of the probes of twists
    whirl_runout *runouts;           ///< runouts of the probes, station after station
    size_t *groups;                  ///< [lanes.group_count + 1]
    double *turns;                   ///< [dimension] as in whirl_system
    bool turning;                    ///< some of `turns` are not 0
    size_t repeats;                  ///< as in whirl_system
    bool kinked;                     ///< as in whirl_system
    size_t held;                     ///< number of elements, the first ones, whose `hold` succeeded
    bool mute;                       ///< there is friction whose power is unknown
    double *inertia, *unit;          ///< [degrees] inertia of coordinates, kg or kg m2; size of their unit, m or rad
    size_t twist_count, first_twist; ///< as in the assembly
    size_t axial_count, first_axial; ///< likewise
    station_twist *twists;           ///< [station_count]
    size_t *axials;                  ///< [station_count] axial coordinates, or NO_COORDINATE
    size_t turning_count;
    turning_inertia *turnings; ///< [turning_count] as in the assembly
    turning_inertia guided[2]; ///< as in the assembly
    double pull[2];            ///< m/s2, gravity across the shafts
    double *weight;            ///< [2][degrees] force by a pull of 1 m/s2 along x, then along y: kg, of a tilt kg m
    shaft_drive drive;         ///< as in the assembly
    size_t spool_count;
    whirl_spool spools[WHIRL_MAX_SPOOLS];       ///< [spool_count] as in whirl_system
    shaft_drive spool_drives[WHIRL_MAX_SPOOLS]; ///< [spool_count] as in the assembly
    size_t *spool_of;                           ///< [station_count] spool that carries a station, from 1; 0: none
    double *housing_turns;                      ///< [station_count] as assembly_housing_ratio
    size_t shaft_count;                         ///< shafts whose torques a run tells apart; 0: there is only one
    rotor_shaft shafts[WHIRL_MAX_RUN_SHAFTS];   ///< [shaft_count] that of the motor or of the rotor's speed comes first
    size_t *shaft_of;                           ///< [station_count] index among them
    size_t part_count;
    rotor_part *parts; ///< [part_count] what twists of these shafts
    size_t torque_count;
    shaft_torque *torques; ///< [torque_count] as in the assembly
    size_t link_count;
    twist_link *links; ///< [link_count] as in the assembly
    /// [degrees] In a rigid turn of the shaft: the ratio of each twist to the shaft's angle, positive about z; and the
    /// angular momentum per speed, kg m2 (NULL: nothing twists).
    double *rigid, *momentum;
    bool grounded; ///< a spring holds a twist to the ground
    size_t hold_count, harmonic_count, pair_count;
    twist_link *holds;          ///< [hold_count] as in the assembly
    harmonic_torque *harmonics; ///< [harmonic_count] likewise
    size_t fatigue_count;
    twist_fatigue *fatigues; ///< [fatigue_count] likewise
    rigid_pair *pairs;       ///< [pair_count] rigid gears
    double *polar;           ///< [station_count] inertia of the stations against twist, kg m2
    size_t excitation_count;
    whirl_excitation *excitations; ///< [excitation_count]
    whirl_torsion torsion;
    size_t driver; ///< station of the motor, whose turn is that of the shaft; the number of stations: none twists
    /// A station whose twist nothing joins to those of the others; NO_STATION: all turn together.
    size_t aside;
    size_t *contacts; ///< [contact_count] indices of elements
    char (*contact_text)[WHIRL_NAME_SIZE + 32];
    const char **contact_names;
};

/// Maximum number of first-order states that the elements of a rotor have together; of coordinates; of rows of
/// accelerations.
enum {
    MAX_OWN_STATES = 2 * WHIRL_MAX_ELEMENTS,
    MAX_DEGREES = AXES * WHIRL_MAX_STATIONS,
    MAX_ROWS = MAX_DEGREES + MAX_OWN_STATES
};

/// Functions of rotors for lanes.h, one of each kind for every instruction set of vector.h (kernels/machine.c).
FOR_EVERY_ISA(lanes_flow, machine_flow);
FOR_EVERY_ISA(lanes_switches, machine_switches);
FOR_EVERY_ISA(lanes_forcing, machine_forcing);
FOR_EVERY_ISA(lanes_contacts, machine_contacts);

/// Fills in the functions and the remaining members of rotor->lanes (rotor_lanes.c). To be called when the rotor's
/// parts and the counts in rotor->lanes are filled in.
void rotor_lanes_fill(whirl_rotor *rotor);

/// Finds the rigid turn of a rotor whose stations twist, from its links and elements (turn.c).
void rotor_find_turn(whirl_rotor *rotor, const assembly *from);

/// Finds the shafts of a machine whose torques a run shows, one by one. To be called after rotor_find_turn
/// (rotor_shafts.c).
void rotor_find_shafts(whirl_rotor *rotor, const assembly *from);

/// Computes accelerations by time from forces [degrees], N or N m, including mass coupling: out [degrees] in units of
/// the coordinates.
void rotor_accelerate(const whirl_rotor *rotor, const double *force, double *out);

/// Fills in the inertias, speeds and joints of stations that twist. Errors as whirl_rotor_new (train.c).
whirl_status rotor_model_train(const whirl_design *design, whirl_model *out);

/// Checks that every S-N curve belongs to a torque. WHIRL_BAD_INPUT (torsion.c).
whirl_status rotor_check_fatigue(const whirl_rotor *rotor);

/// Finds what excites the twists, and what carries torque. To be called after rotor_find_turn (torsion.c).
void rotor_find_torsion(whirl_rotor *rotor, const assembly *from);

/// Returns the number of states that an element sees, at most MAX_ELEMENT_STATES.
size_t rotor_states_seen(const element *own);

/// Returns the displacements, velocities and states that an element sees in a state x [dimension].
element_place rotor_see(const whirl_rotor *rotor, const element *own, const double *x);

/// Returns true for an element that carries torque between two twists, or between a twist and the ground.
bool rotor_carries(const whirl_rotor *rotor, const element *own);

/// A path of torsion (whirl_torsion.path): one of the members, the others are NULL.
typedef struct rotor_path {
    const twist_link *link;
    const element *element;
    const rigid_pair *pair;
} rotor_path;

/// Returns path `index`: links with a stiffness come first, then elements that carry torque, then rigid pairs.
rotor_path rotor_path_at(const whirl_rotor *rotor, size_t index);

/// Returns the station whose twist is that of an end of a link, or the number of stations for a node between stations.
size_t rotor_link_station(const whirl_rotor *rotor, const twist_link *own, size_t end);

/// Returns element `index` of those that carry torque (rotor_carries), or NULL past the last.
const element *rotor_carrier(const whirl_rotor *rotor, size_t index);

/// Returns the torque, N m, that an element (rotor_carrier) carries in a state x [dimension]. `numbers` of a machine
/// replace the rotor's own, as in whirl_torque_path.
double rotor_carried(const whirl_rotor *rotor, const element *carrier, double *numbers, const double *x);

/// Returns the number of torques that a run-up observes: those of springs between twists, of meshes, and of springs
/// with play.
size_t rotor_watched_count(const whirl_rotor *rotor);

/// Returns the ratio of a station's speed in a rigid turn to that of the shaft, at least 0; 1 if the station does not
/// twist.
double rotor_turns(const whirl_rotor *rotor, size_t station);

/// Fills in the functions of the rotor's system (rotor_system.c).
void rotor_system_fill(whirl_rotor *rotor);

/// Functions of the rotor's system with other numbers [lanes.number_count], those of the machine at another speed.
void rotor_flow_with(const whirl_rotor *rotor, double *numbers, const double *forcing, const double *sides,
                     const double *x, double *dxdt);
void rotor_switches_with(const whirl_rotor *rotor, double *numbers, const double *x, double *values);
void rotor_contacts_with(const whirl_rotor *rotor, double *numbers, const double *x, double *normal_force,
                         double *friction);

/// Computes the torques of the fluid of an element (element_type.drag) on the shafts of its journal and housing, N m,
/// in the sense of the rotation of the rotor's shaft (drag.c). speed: speed of the shaft, rad/s; numbers, x: of the
/// machine at that speed, by the angle; spin: speeds of journal and housing in the same sense, rad/s.
void rotor_drag_with(const whirl_rotor *rotor, const element *own, double *numbers, const double *x, double speed,
                     const double spin[2], double torque[2]);

/// Computes the accelerations by one element alone, to the rows of its ports and states in view->a (kernels/machine.c).
void machine_element_flow(const lanes_view *view, const element *own);

/// Writes the derivatives of switch `index` by x, gradient [dimension], with such numbers.
void rotor_gradient_with(const whirl_rotor *rotor, double *numbers, const double *x, size_t index, double *gradient);

/// Returns the rotor of a system, or NULL if the system is not a rotor's.
const whirl_rotor *rotor_of_system(const whirl_system *system);

// ---------------------------------------------------------------- repeats
// Revolutions after which phases that turn at ratios of the speed repeat.

/// Returns the smallest q up to WHIRL_MAX_REPEATS for which q times `ratio` is a whole number, to rounding; 0 if there
/// is none.
size_t repeats_of(double ratio);

/// Returns the repeats of two phases together, from the repeats a and b of each (0: never).
size_t repeats_of_both(size_t a, size_t b);

#endif
