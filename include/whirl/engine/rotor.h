/// Rotors: stations joined by elements.
///
/// A *design* lists stations and elements with their parameters in SI; a *rotor* is built from it once and is
/// immutable. It gives the equations of motion, scaled: time tau = omega t (one revolution is 2 pi), lengths in
/// `length_scale`. Where an element is the keyphasor, omega is the rate of its phase, by which sections are taken and
/// revolutions counted, and no longer the speed of the shaft, whose angle is then the last number of the state. The
/// state holds x and y of every station in the order of the design, then their derivatives by tau: x1, y1, x2, y2, ...,
/// x1', y1', x2', y2', ... The shaft turns counter-clockwise (x towards y).
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

/// Bounds of a design.
enum {
    WHIRL_MAX_STATIONS = 256,  ///< those of the design and the nodes of its shafts
    WHIRL_MAX_ELEMENTS = 1024, ///< of a design, segments of shafts too
    WHIRL_MAX_SHAFTS = 16,     ///< of finite elements
    WHIRL_MAX_MATERIALS = 64   ///< with names
};

/// The keys of a station (mass, damping, eccentricity, ...).
const whirl_group *whirl_station_keys(void);

/// The keys of a shaft of finite elements (material, mesh_to, modes, ...).
const whirl_group *whirl_shaft_keys(void);

/// The keys of a material (modulus, density, ...).
const whirl_group *whirl_material_keys(void);

/// The keys of all elements, in the order in which they act; static, ended by NULL.
const whirl_group *const *whirl_element_groups(void);

/// The element of that name, or NULL.
const whirl_group *whirl_element_group(const char *name);

/// One key of a station or an element with its value. `number` is in the key's SI unit; `text` is for words:
/// a choice, a name, a station, two stations "disc, journal", or a list of numbers "1e7, 1.2e7" in the key's SI unit,
/// or of equal lists, "1e7, 1.2e7; 2e7, 2.1e7". Where text is not NULL it counts. Borrowed.
typedef struct whirl_setting {
    const char *key;  ///< its name
    double number;    ///< in the SI unit
    const char *text; ///< a word, else NULL
} whirl_setting;

/// A list of stations and elements, being written.
typedef struct whirl_design whirl_design;

/// Starts a design. speed: omega in rad/s, below 0 clockwise, from y to x; length_scale in m, > 0. Angles go from x
/// towards y either way. A rotor that stands still has seconds for its unit of time: linear analyses are for it,
/// motions that revolutions are counted of are not.
whirl_status whirl_design_new(double speed, double length_scale, whirl_design **design);

/// Adds a material ("steel" is known by itself). Names and errors as of whirl_design_station.
whirl_status whirl_design_material(whirl_design *design, const char *name, const whirl_setting *settings, size_t count);

/// Adds a shaft, whose material must be there already; stations on it and its segments come later. Names and errors as
/// of whirl_design_station.
whirl_status whirl_design_shaft(whirl_design *design, const char *name, const whirl_setting *settings, size_t count);

/// Adds a station; its name must be new, a word of letters, digits, '_' and '-', and not "ground".
/// WHIRL_BAD_INPUT with a sentence for an unknown, missing, repeated or out-of-range key.
whirl_status whirl_design_station(whirl_design *design, const char *name, const whirl_setting *settings, size_t count);

/// A kind of element of one's own, written with the headers of whirl/element (docs/elements.md).
typedef struct whirl_element_type whirl_element_type;

/// Makes a kind of element known to this design; such elements act after the library's, in the order in which kinds are
/// added. `type` is borrowed and must outlive the design and its rotors. WHIRL_BAD_INPUT where there is one of that
/// name, or it has more than 64 keys.
whirl_status whirl_design_add_type(whirl_design *design, const whirl_element_type *type);

/// "run_up" for whirl_design_add_type: an unbalance while the speed runs up or down evenly. Its keys: at, moment (kg
/// m), angle (rad), speed (rad/s at t = 0, default 0), acceleration (rad/s^2). Its angle and what its speed has gained
/// are states, two numbers at the end of the rotor's, 0 at t = 0; the design's speed is but the unit of time, and that
/// at which what else turns goes on turning. A motion that never comes back: follow it by an integrator; verdicts are
/// not for it. Static. Lewis 1932.
const whirl_element_type *whirl_run_up_type(void);

/// Adds an element of a kind of whirl_element_groups() or of whirl_design_add_type(); its stations must be there
/// already. The first segment of a design without shafts adds one called "shaft". Errors as above.
whirl_status whirl_design_element(whirl_design *design, const char *kind, const whirl_setting *settings, size_t count);

/// Frees a design; NULL is none.
void whirl_design_free(whirl_design *design);

/// What stands for the bearings of a design (bearing, film, ball_bearing, roller_bearing).
typedef enum whirl_bearings {
    WHIRL_BEARINGS_GIVEN,   ///< they themselves
    WHIRL_BEARINGS_SPRINGS, ///< springs without damping, as in critical speed maps, which leave seals, impellers and
                            ///< gravity out
    WHIRL_BEARINGS_HELD,    ///< the same from both of their ends to the ground, but for ends on shafts: rigid supports
    WHIRL_BEARINGS_ALONE    ///< they themselves, and no other element: what their coefficients are derivatives of
} whirl_bearings;

/// Chooses it; stiffness: of every spring, N/m, >= 0.
void whirl_design_bearings(whirl_design *design, whirl_bearings what, double stiffness);

/// Which seals and impellers a machine has (seal, stage, and bearing of that role).
typedef enum whirl_drag {
    WHIRL_DRAG_ALL,    ///< all of them
    WHIRL_DRAG_STAGES, ///< stages alone
    WHIRL_DRAG_AT      ///< those at one station, without stages
} whirl_drag;

/// Chooses them: of WHIRL_DRAG_AT by the station's index; cross couplings of stages count `stages` times.
void whirl_design_drag(whirl_design *design, whirl_drag what, size_t station, double stages);

/// The frequency of whirl, rad/s, at which coefficients are looked up that depend on it (`frequencies` of bearings), or
/// the next one that all their tables know; that of the shaft where this is not called. Such a rotor stands for small
/// motions of that frequency: only linear analyses are for it (whirl_system.frequencies).
void whirl_design_frequency(whirl_design *design, double frequency);

/// The rotor is to move in time: for coefficients that depend on the frequency of whirl stand rational functions with
/// states of their own, which whirl_rotor_note tells of. WHIRL_BAD_INPUT of whirl_rotor_new where one differs from its
/// table by more than the bearing's fit_error.
void whirl_design_in_time(whirl_design *design);

/// Puts unbalances [count], at stations of the design, in the place of all that turn with the rotor: of stations, discs
/// and elements `unbalance`, and skew. Borrowed until the rotor is built. 0: the rotor has its own.
void whirl_design_unbalances(whirl_design *design, size_t count, const whirl_placed *placed);

/// How weight acts on a machine: the sum of its elements `gravity`.
typedef struct whirl_weight {
    bool given;    ///< it has such an element
    bool stands;   ///< one acts along the shafts
    double across; ///< m/s2 across the shafts; 0: bearings carry nothing
    double up;     ///< how far up the y axis points; 1 where nothing acts across
    double along;  ///< m/s2 along shafts that stand, the largest
} whirl_weight;

/// Finds it.
whirl_weight whirl_design_weight(const whirl_design *design);

/// What the weight does to the shafts of finite elements, each on its own bearings (bearing, film, ball_bearing,
/// roller_bearing), which hold it without giving way: out [stations of the design], and influence [stations][stations]
/// as whirl_machine has it. Masses of stations and discs weigh, fluid does not; shafts with flats bend by their mean
/// stiffness. Of gravity the acceleration across the shafts counts; without any, loads are those of elevations alone,
/// and masses those of shafts that lie. couplings: names of
/// stations, separated by blanks: the bearings behind the first two of a shaft are raised until it carries neither
/// moment nor shear there (the mean of both sides), by the least elevations that do so. WHIRL_BAD_INPUT where there is
/// no such shaft, one has fewer than two bearings or shares one with another shaft, a name is no station of a shaft, or
/// no elevations do that.
whirl_status whirl_design_statics(const whirl_design *design, const char *couplings, whirl_station_statics *out,
                                  double *influence);

/// Whether elements of that kind are bearings.
bool whirl_element_is_bearing(const char *kind);

/// Is told of a value that is likely not meant, or beyond what the law of its element is for: of which element, of
/// which key, and a sentence that begins behind these ("is 2 times the diameter: ..."). All borrowed for the call.
typedef void whirl_design_tell(void *context, size_t element, const char *key, const char *sentence);

/// Tells of all such values. They are no errors: the machine is computed as it is given.
void whirl_design_doubts(const whirl_design *design, whirl_design_tell *tell, void *context);

/// What a rotor makes of a shaft of finite elements.
typedef struct whirl_shaft_summary {
    char name[WHIRL_NAME_SIZE]; ///< of the shaft
    double length, mass;        ///< m, kg
    size_t nodes, elements;     ///< of its mesh
    bool reduced;               ///< to a few modes
    size_t modes, all_modes;    ///< kept in a plane, and how many there are between its stations
    double highest;             ///< rad/s of the highest mode that is kept; 0 where none is
    size_t compared;            ///< natural frequencies of the free shaft that were compared, at most three
    double frequency_error;     ///< the worst of these, over that of the full model
    double flexibility_error;   ///< the worst displacement of a station by a force on one, over the largest of the full
                                ///< model; each of them stands on a spring as stiff as the shaft is there
} whirl_shaft_summary;

/// Tells of all shafts, at most WHIRL_MAX_SHAFTS, how far the reduced ones differ from their full models. Errors as
/// whirl_rotor_new.
whirl_status whirl_design_shafts(const whirl_design *design, whirl_shaft_summary out[WHIRL_MAX_SHAFTS], size_t *count);

/// A rotor that was built of a design.
typedef struct whirl_rotor whirl_rotor;

/// Index of an element in the order in which a design was given them; none.
#define WHIRL_NO_ELEMENT ((size_t)-1)

/// Is told of a problem, and of the element that it is with or WHIRL_NO_ELEMENT.
typedef void whirl_rotor_tell(void *context, size_t element, const whirl_status *status);

/// Tells all that keeps the design from being a rotor (keys that contradict each other, a station without mass, ...)
/// and gives how much it was. WHIRL_NO_MEMORY.
whirl_status whirl_rotor_check(const whirl_design *design, whirl_rotor_tell *tell, void *context, size_t *problems);

/// Builds the rotor. The design is not kept. WHIRL_BAD_INPUT for a design that is no machine (no station, ...).
/// Bearings of pads read tables of films, which may have to be made first, in some seconds.
whirl_status whirl_rotor_new(const whirl_design *design, whirl_rotor **rotor);

/// Builds a rotor to be looked at: what it has and what it is called is known, what its bearings of pads do is not, as
/// if they had no film, until whirl_rotor_hold. Errors as whirl_rotor_new.
whirl_status whirl_rotor_outline(const whirl_design *design, whirl_rotor **rotor);

/// Sees to it that the tables of films that a rotor reads are there as long as it lives; threads that want the same
/// ones make them together. Gives up where *stop becomes true (NULL: never). WHIRL_NO_MEMORY, WHIRL_STOPPED: then the
/// rotor is an outline still.
whirl_status whirl_rotor_hold(whirl_rotor *rotor, const whirl_stop *stop);

/// Frees a rotor; NULL is none.
void whirl_rotor_free(whirl_rotor *rotor);

/// The rotor as a system of first order; borrowed, lives as long as the rotor. One probe a station.
const whirl_system *whirl_rotor_system(const whirl_rotor *rotor);

/// Completes a state [dimension] that says displacements and velocities of stations: what shafts of finite elements
/// have between these (tilts, nodes, coordinates of modes) is written as the shaft gives way statically, so that a
/// straight one stays straight; pads that tilt lie as their films hold them before a journal in the middle, unless a
/// tilt is said; all else stays. With zeros there, the coordinates of modes would bend it
/// (docs/theory.md).
void whirl_rotor_complete(const whirl_rotor *rotor, double *x);

double whirl_rotor_speed(const whirl_rotor *rotor); ///< rad/s
/// rad/s of the phase that sections are taken by, once a turn: 2 pi of tau, a revolution. The speed but for a
/// keyphasor.
double whirl_rotor_clock(const whirl_rotor *rotor);

/// The element whose phase that is ("force at disc"), "" for the shaft; borrowed.
const char *whirl_rotor_keyphasor(const whirl_rotor *rotor);

/// What element number `index`, from 0 on, of those that have something to tell of themselves says ("seal at disc: in
/// the fluid K 3.686e+06 N/m, ..."); false beyond the last.
bool whirl_rotor_note(const whirl_rotor *rotor, size_t index, char text[WHIRL_MESSAGE_SIZE]);

/// N/m, the sum of the cross couplings of its stages, each once; 0 without any.
double whirl_rotor_cross_coupling(const whirl_rotor *rotor);

double whirl_rotor_length_scale(const whirl_rotor *rotor); ///< m

/// The equations of motion in SI, for programs that integrate on their own: x and dxdt are [4 stations], x and y of
/// every station in m, then their derivatives by t in m/s; t in s. WHIRL_BAD_INPUT for a rotor with other states
/// (tilts, phases that turn, nodes of shafts).
whirl_status whirl_rotor_rates(const whirl_rotor *rotor, double t, const double *x, double *dxdt);

/// Names of the contacts ("rub at disc"), as many as the system's contact_count; borrowed.
const char *const *whirl_rotor_contact_names(const whirl_rotor *rotor);

/// Short-bearing film force of Capone (1991) on a journal at (x, y) in clearances with velocity (vx, vy) in
/// clearances per radian, per unit of F0: validation formula of the film element.
/// A journal at or beyond the wall (x^2 + y^2 >= 1) gives NaN.
void whirl_film_force(double x, double y, double vx, double vy, double force[2]);

#ifdef __cplusplus
}
#endif
#endif
