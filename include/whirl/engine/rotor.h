/// Rotors: stations joined by elements.
///
/// A *design* lists stations and elements with their parameters in SI. A *rotor* is built from it once and is
/// immutable. It provides the equations of motion, scaled: time tau = omega t (one revolution is 2 pi), lengths in
/// `length_scale`. If an element is the keyphasor, omega is the rate of that element's phase, by which sections are
/// taken and revolutions counted; the angle of the shaft is then the last number of the state. The state holds x and y
/// of every station in the order of the design, then their derivatives by tau: x1, y1, x2, y2, ..., x1', y1', x2', y2',
/// ... The shaft turns counter-clockwise (x towards y).
#ifndef WHIRL_ROTOR_H
#define WHIRL_ROTOR_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/descriptor.h"
#include "whirl/engine/stop.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Limits of a design.
enum {
    WHIRL_MAX_STATIONS = 256,  ///< stations of the design and nodes of its shafts
    WHIRL_MAX_ELEMENTS = 1024, ///< elements of a design, with segments of shafts
    WHIRL_MAX_SHAFTS = 16,     ///< shafts of finite elements
    WHIRL_MAX_MATERIALS = 64   ///< named materials
};

/// Returns the keys of a station (mass, damping, eccentricity, ...).
const whirl_group *whirl_station_keys(void);

/// Returns the keys of a shaft of finite elements (material, mesh_to, modes, ...).
const whirl_group *whirl_shaft_keys(void);

/// Returns the keys of a material (modulus, density, ...).
const whirl_group *whirl_material_keys(void);

/// Returns the keys of all elements, in the order in which they act; static, ended by NULL.
const whirl_group *const *whirl_element_groups(void);

/// Returns the element of that name, or NULL.
const whirl_group *whirl_element_group(const char *name);

/// One key of a station or an element with its value. `number` is in the key's SI unit. `text`, if it is not NULL,
/// replaces it: a choice, a name, a station, two stations "disc, journal", a list of numbers "1e7, 1.2e7" in the key's
/// SI unit, or lists of equal length, "1e7, 1.2e7; 2e7, 2.1e7". Borrowed.
typedef struct whirl_setting {
    const char *key;  ///< its name
    double number;    ///< in the SI unit
    const char *text; ///< a text, else NULL
} whirl_setting;

/// A list of stations and elements under construction.
typedef struct whirl_design whirl_design;

/// Starts a design. speed: omega in rad/s, below 0 clockwise, from y to x; length_scale in m, > 0. Angles go from x
/// towards y for both senses. A rotor at speed 0 has the second as its unit of time, and supports linear analyses, but
/// not motions in revolutions.
whirl_status whirl_design_new(double speed, double length_scale, whirl_design **design);

/// Adds a material ("steel" is built in). Names and errors as for whirl_design_station.
whirl_status whirl_design_material(whirl_design *design, const char *name, const whirl_setting *settings, size_t count);

/// Adds a shaft, after its material and before its stations and segments. Names and errors as for whirl_design_station.
whirl_status whirl_design_shaft(whirl_design *design, const char *name, const whirl_setting *settings, size_t count);

/// Adds a station. Its name must be new, a word of letters, digits, '_' and '-', and not "ground". WHIRL_BAD_INPUT with
/// a sentence for an unknown, missing, repeated or out-of-range key.
whirl_status whirl_design_station(whirl_design *design, const char *name, const whirl_setting *settings, size_t count);

/// A custom kind of element, written with the headers of whirl/element (docs/elements.md).
typedef struct whirl_element_type whirl_element_type;

/// Registers a custom kind of element with this design. Custom elements act after the library's, in the order in which
/// their kinds are added. `type` is borrowed and must outlive the design and its rotors. WHIRL_BAD_INPUT for a name in
/// use, and for more than 64 keys.
whirl_status whirl_design_add_type(whirl_design *design, const whirl_element_type *type);

/// Returns "run_up" for whirl_design_add_type: an unbalance while the speed rises or falls at a constant rate. Keys:
/// at, moment (kg m), angle (rad), speed (rad/s at t = 0, default 0), acceleration (rad/s^2). Its angle and the change
/// of its speed are the last two numbers of the rotor's state, 0 at t = 0. The design's speed is only the unit of time
/// and the speed of other parts that turn. The motion never repeats: use an integrator, not verdicts. Static. Lewis
/// 1932.
const whirl_element_type *whirl_run_up_type(void);

/// Adds an element of a kind of whirl_element_groups() or whirl_design_add_type(), after its stations. The first
/// segment of a design without shafts adds a shaft named "shaft". Errors as above.
whirl_status whirl_design_element(whirl_design *design, const char *kind, const whirl_setting *settings, size_t count);

/// Frees a design; accepts NULL.
void whirl_design_free(whirl_design *design);

/// Models of the bearings of a design (bearing, film, ball_bearing, roller_bearing).
typedef enum whirl_bearings {
    WHIRL_BEARINGS_GIVEN,   ///< the bearings as given
    WHIRL_BEARINGS_SPRINGS, ///< springs without damping, and no seals, impellers and gravity, as in critical speed maps
    WHIRL_BEARINGS_HELD, ///< the same springs from both ends to the ground, except for ends on shafts: rigid supports
    WHIRL_BEARINGS_ALONE ///< the bearings as given, and no other element, to obtain their coefficients
} whirl_bearings;

/// Chooses the model of the bearings; stiffness: of every spring, N/m, >= 0.
void whirl_design_bearings(whirl_design *design, whirl_bearings what, double stiffness);

/// Choices of seals and impellers (seal, stage, and bearing with such a role).
typedef enum whirl_drag {
    WHIRL_DRAG_ALL,    ///< all of them
    WHIRL_DRAG_STAGES, ///< stages only
    WHIRL_DRAG_AT      ///< the seals and impellers at one station, no stages
} whirl_drag;

/// Chooses seals and impellers; `station` is the index for WHIRL_DRAG_AT, `stages` a factor of the cross couplings of
/// stages.
void whirl_design_drag(whirl_design *design, whirl_drag what, size_t station, double stages);

/// Sets the frequency of whirl, rad/s, at which coefficients that depend on it (`frequencies` of bearings) are taken,
/// or the nearest frequency within all their tables. The default is the speed of the shaft. Such a rotor is valid for
/// small motions of that frequency: linear analyses only (whirl_system.frequencies).
void whirl_design_frequency(whirl_design *design, double frequency);

/// Requests a rotor for motions in time: rational functions with states of their own replace coefficients that depend
/// on the frequency of whirl; whirl_rotor_note reports them. whirl_rotor_new returns WHIRL_BAD_INPUT if such a function
/// differs from its table by more than the bearing's fit_error.
void whirl_design_in_time(whirl_design *design);

/// Sets the speeds of the shafts that have a speed of their own (key `speed`), rad/s along their own rotations, in
/// their order: speeds [count]; more than there are such shafts are ignored. The sense of each rotation stays that of
/// its key. vary: the shafts change their speeds while the rotor runs (whirl_running_new); it is then valid there
/// alone.
void whirl_design_spools(whirl_design *design, size_t count, const double *speeds, bool vary);

/// Replaces all unbalances that turn with the rotor (of stations, discs and elements `unbalance`, and skew) by
/// unbalances [count] at stations of the design. Borrowed until the rotor is built. 0: the rotor keeps its own.
void whirl_design_unbalances(whirl_design *design, size_t count, const whirl_placed *placed);

/// Gravity of a machine: the sum of its elements `gravity`.
typedef struct whirl_weight {
    bool given;    ///< true if the machine has such an element
    bool stands;   ///< true if one acts along the shafts
    double across; ///< m/s2 across the shafts; 0: bearings carry no load
    double up;     ///< component of the upward direction along y; 1 if none acts across
    double along;  ///< m/s2 along standing shafts, the largest
} whirl_weight;

/// Sums the gravity of a design.
whirl_weight whirl_design_weight(const whirl_design *design);

/// Computes the effects of weight on the shafts of finite elements, each on its own bearings (bearing, film,
/// ball_bearing, roller_bearing) as rigid supports: out [stations of the design], and influence [stations][stations] as
/// in whirl_machine. Masses of stations and discs have weight, fluid has none; shafts with flats bend with their mean
/// stiffness. Only gravity across the shafts counts; without any, loads are those of elevations, and masses those of
/// lying shafts. couplings: names of stations, separated by blanks. The bearings after the first two of a shaft are
/// raised by the least elevations that leave neither moment nor shear at these stations (mean of both sides).
/// WHIRL_BAD_INPUT if there is no such shaft, one has fewer than two bearings or shares one with another shaft, a name
/// is not a station of a shaft, or no elevations make moment and shear vanish.
whirl_status whirl_design_statics(const whirl_design *design, const char *couplings, whirl_station_statics *out,
                                  double *influence);

/// Returns true for a kind of element that is a bearing.
bool whirl_element_is_bearing(const char *kind);

/// Receives a suspicious value: likely an error, or outside the range of the element's law. `sentence` continues after
/// the element and the key ("is 2 times the diameter: ..."). Arguments are borrowed for the call.
typedef void whirl_design_tell(void *context, size_t element, const char *key, const char *sentence);

/// Reports all such values. They are not errors: the machine is computed as given.
void whirl_design_doubts(const whirl_design *design, whirl_design_tell *tell, void *context);

/// Mesh and reduction of a shaft of finite elements.
typedef struct whirl_shaft_summary {
    char name[WHIRL_NAME_SIZE]; ///< name of the shaft
    double length, mass;        ///< m, kg
    size_t nodes, elements;     ///< numbers of its mesh
    bool reduced;               ///< true if it is reduced to a few modes
    size_t modes, all_modes;    ///< modes kept in a plane, and all modes between its stations
    double highest;             ///< rad/s of the highest mode kept; 0 if none is
    size_t compared;            ///< natural frequencies of the free shaft compared with the full model, at most three
    double frequency_error;     ///< largest error of these, relative to the full model; 0 below 1e-12
    /// Largest error of a station's displacement by a force at a station, over the largest displacement in the full
    /// model; each station is on a spring as stiff as the shaft there. 0 below 1e-12: rounding.
    double flexibility_error;
} whirl_shaft_summary;

/// Summarizes all shafts, at most WHIRL_MAX_SHAFTS, with the errors of reduced shafts against their full models. Errors
/// as whirl_rotor_new.
whirl_status whirl_design_shafts(const whirl_design *design, whirl_shaft_summary out[WHIRL_MAX_SHAFTS], size_t *count);

/// A rotor built from a design.
typedef struct whirl_rotor whirl_rotor;

/// Stands for "no element" in place of an element's index, which counts elements from 0 in the order in which the
/// design received them.
#define WHIRL_NO_ELEMENT ((size_t)-1)

/// Receives a problem, and the index of its element or WHIRL_NO_ELEMENT.
typedef void whirl_rotor_tell(void *context, size_t element, const whirl_status *status);

/// Reports everything that prevents building a rotor from the design (contradicting keys, a station without mass, ...)
/// and counts it in *problems. WHIRL_NO_MEMORY.
whirl_status whirl_rotor_check(const whirl_design *design, whirl_rotor_tell *tell, void *context, size_t *problems);

/// Builds a rotor. The rotor does not refer to the design. WHIRL_BAD_INPUT for a design that is not a machine (no
/// station, ...). Bearings with pads read film tables, which may have to be built first, in some seconds.
whirl_status whirl_rotor_new(const whirl_design *design, whirl_rotor **rotor);

/// Builds a rotor for inspection: its structure and names are complete, but bearings with pads act as if they had no
/// film until whirl_rotor_hold. Errors as whirl_rotor_new.
whirl_status whirl_rotor_outline(const whirl_design *design, whirl_rotor **rotor);

/// Loads the film tables that the rotor reads, for as long as it lives; threads that need the same tables build them
/// together. `stop` becomes that of the rotor's system (whirl_system.stop); NULL: none. WHIRL_NO_MEMORY, WHIRL_STOPPED:
/// the rotor is still an outline.
whirl_status whirl_rotor_hold(whirl_rotor *rotor, const whirl_stop *stop);

/// Frees a rotor; accepts NULL.
void whirl_rotor_free(whirl_rotor *rotor);

/// Returns the rotor as a system of first order, with one probe per station; borrowed, lives as long as the rotor.
const whirl_system *whirl_rotor_system(const whirl_rotor *rotor);

/// Completes a state [dimension] that has displacements and velocities of stations. Coordinates of finite-element
/// shafts between stations (tilts, nodes, modes) are set to the static deflection, so that a straight shaft stays
/// straight; zeros for coordinates of modes would bend it (docs/theory.md). Tilting pads are set to their balance with
/// a centred journal, unless a tilt is given. All other numbers stay.
void whirl_rotor_complete(const whirl_rotor *rotor, double *x);

double whirl_rotor_speed(const whirl_rotor *rotor); ///< rad/s
/// Returns the rate, rad/s, of the phase by which sections are taken once a turn (2 pi of tau, a revolution): the
/// speed, unless there is a keyphasor.
double whirl_rotor_clock(const whirl_rotor *rotor);

/// Returns the element of that phase ("force at disc"), "" for the shaft; borrowed.
const char *whirl_rotor_keyphasor(const whirl_rotor *rotor);

/// Writes note number `index`, from 0, of the elements ("seal at disc: in the fluid K 3.686e+06 N/m, ..."); false past
/// the last.
bool whirl_rotor_note(const whirl_rotor *rotor, size_t index, char text[WHIRL_MESSAGE_SIZE]);

/// Returns the sum of the cross couplings of the rotor's stages, N/m, each stage once; 0 without any.
double whirl_rotor_cross_coupling(const whirl_rotor *rotor);

double whirl_rotor_length_scale(const whirl_rotor *rotor); ///< m

/// Returns true if a rotor has a drive, and writes the motor's speed without load, or the last speed of its table
/// (rad/s; 0: it has no such speed).
bool whirl_rotor_drive(const whirl_rotor *rotor, double *highest);

/// Computes the equations of motion in SI, for programs with integrators of their own: x and dxdt are [4 stations], x
/// and y of every station in m, then their derivatives by t in m/s; t in s. WHIRL_BAD_INPUT for a rotor with other
/// states (tilts, phases that turn, nodes of shafts).
whirl_status whirl_rotor_rates(const whirl_rotor *rotor, double t, const double *x, double *dxdt);

/// Returns the names of the contacts ("rub at disc"), as many as the system's contact_count; borrowed.
const char *const *whirl_rotor_contact_names(const whirl_rotor *rotor);

/// Computes the short-bearing film force of Capone (1991) on a journal at (x, y) in clearances with velocity (vx, vy)
/// in clearances per radian, per unit of F0: validation formula of the film element. NaN for a journal at or beyond the
/// wall (x^2 + y^2 >= 1).
void whirl_film_force(double x, double y, double vx, double vy, double force[2]);

#ifdef __cplusplus
}
#endif
#endif
