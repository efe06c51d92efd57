/// Interface of elements: their keys, the numbers that follow from them, and their kernels.
///
/// All is scaled: time by 1/clock, lengths by the rotor's length scale, forces on a coordinate by its inertia, so that
/// an element adds to accelerations. The physics itself is in elements/<element>_kernel.h, written once over the vector
/// type; elements/<element>.c is compiled once for every instruction set and defines everything else in the first of
/// these builds.
#ifndef ROTOR_ELEMENT_H
#define ROTOR_ELEMENT_H

#include <stdbool.h>
#include <stddef.h>

#include "assembly.h"
#include "keys.h"
#include "vector.h"
#include "whirl/engine/rotor.h"
#include "whirl/engine/stop.h"
#include "whirl/engine/torsion.h"
#include "whirl/status.h"

// Symbols that elements outside the library use have names of the library.
#define element_on whirl_element_on
#define element_between whirl_element_between
#define element_beside_none whirl_element_beside_none
#define element_in_housing whirl_element_in_housing
#define doubt_value whirl_doubt_value

/// Station index of the ground.
#define GROUND ((size_t)-1)

/// The value of one key, in the order of the group's table; in SI.
typedef struct key_value {
    bool given;
    double number;
    int choice;
    size_t station[2];
    size_t count; ///< length of a list; 0: `number` is the value
    size_t rows;  ///< number of equal lists in it, one after the other; 1: it is one list
    double *list; ///< [count]
} key_value;

/// Maxima of one element: coordinates that it sees, keys; states that switches depend on.
enum { MAX_PORTS = 8, MAX_KEYS = 64, MAX_ELEMENT_STATES = 32 };

/// Placeholder until `build` sets the number of an element's states.
#define STATES_OF_TYPE ((size_t)-1)

/// Constants of the drag of an element's fluid on shafts whose speed is a state (drag.c).
typedef struct fluid_drag {
    double shear; ///< N m s: torque of the shear between centred surfaces over the difference of their speeds; 0: none
    double reynolds; ///< s: Reynolds number of the film over that difference
    int turbulence;  ///< whirl_turbulence
    double turns[2]; ///< speeds of journal and housing over the shaft's
    size_t housing;  ///< station of the housing; GROUND
} fluid_drag;

/// An element as its kernels see it. The structure (ports, law) is shared by all machines of a block, the numbers are
/// not.
typedef struct element {
    const struct whirl_element_type *type;
    size_t run;          ///< number of elements of its type that follow one another from here, itself included
    size_t first_number; ///< index of its first number in those of the machine
    size_t part;         ///< index among the machine's parts: stations, then elements
    int law;
    bool lumped;             ///< it is part of the assembly only
    size_t port[MAX_PORTS];  ///< coordinates that it sees; NO_COORDINATE: the ground's
    double share[MAX_PORTS]; ///< motion of the place over that of the coordinate: 1, for twists the ratio of gears
    size_t state;            ///< index of its first first-order state, in the rows of the velocities
    size_t states;           ///< number of its states: those of its type, unless `build` sets fewer
    size_t first_switch;     ///< index of its first switch, in those of the machine
    size_t station;          ///< index of its station
    size_t ends[2];          ///< stations of an element between two places (GROUND: the ground); else 0
    fluid_drag fluid;        ///< drag of films and seals
    double *number;          ///< [type->number_count]
} element;

struct block;

/// Receiver of doubts, and the element to which they refer.
typedef struct doubt_teller {
    whirl_design_tell *tell;
    void *context;
    size_t element;
} doubt_teller;

/// Extent of a motion at an element: extremes of the places of its ports, in length scales (0 for the ground), and of
/// its states; the largest distance from a fixed housing, else NaN.
typedef struct element_seen {
    double low[MAX_PORTS], high[MAX_PORTS];
    const double *state_low, *state_high;
    double radius;
} element_seen;

/// A film, as in whirl_film_gap: lengths in length scales.
typedef whirl_film_gap element_film;

/// A range of its law, as in whirl_law_range.
typedef struct element_range {
    const char *quantity, *unit, *limit;
    double most, reached;
} element_range;

/// Part of a state or a perturbation that an element sees, or derivatives by it: places and velocities of its ports, 0
/// for the ground, and its states.
typedef struct element_place {
    double q[MAX_PORTS], v[MAX_PORTS], s[MAX_ELEMENT_STATES];
} element_place;

/// A film or seal in motion, as its drag sees it: SI, of the mirror image where the shaft turns clockwise.
typedef struct drag_view {
    const element_place *at;   ///< the state itself, with derivatives by the shaft's angle
    double length;             ///< m of one unit of displacement
    double force_scale;        ///< N of one unit of acceleration of the first port
    double speed;              ///< rad/s of the shaft
    double spin[2];            ///< rad/s of journal and housing
    double place[2], distance; ///< m, of the journal from its housing
    double force[2];           ///< N on the journal
} drag_view;

/// Load of an element between two twists. A closing, a sum of its ports' places, presses it together.
typedef struct element_carried {
    double closing[MAX_PORTS]; ///< closing by the place of each port, in the state's units
    double unit;               ///< m or rad of one unit of closing
    double lever[2];           ///< torque on each place about z, N m, by one unit of force; 0: the place does not twist
    double force;              ///< force (N) or moment (N m) that presses it together, in this state
    double play;               ///< closing to either side within which no force acts
    double stiffness, damping; ///< its derivatives by the closing and its rate beyond, means over turning phases
    bool open;                 ///< the state is within its play
    double error_order, error[2]; ///< closing less Re(error exp(i error_order tau)) counts; 0: no error
} element_carried;

/// Kernels of an element in lanes, for one instruction set. NULL for those that it does not have.
typedef struct element_kernels {
    /// Adds the accelerations of `count` elements of one type, one after the other, those of the perturbations by their
    /// derivatives, and the trace of these to the divergence.
    void (*flow)(const element *first, size_t count, const struct block *b);

    /// Writes its switching functions and, unless NULL, their derivatives by time: rows of the block's stride.
    void (*switches)(const element *own, const struct block *b, void *values, void *rates);

    /// Writes the normal force of its contact in newtons and, unless NULL, the effect of its friction: two rows of the
    /// block's stride, as in whirl_system.friction.
    void (*contact)(const element *own, const struct block *b, void *force, void *friction);
} element_kernels;

/// The table `kernels` of those that the file has been compiled to, for its element_type.
#define KERNELS_OF_EVERY_ISA(name)                                                                                     \
    FOR_EVERY_ISA(const element_kernels, name);                                                                        \
    static const element_kernels *const kernels[VECTOR_ISAS] = EVERY_ISA(&, name)

typedef struct whirl_element_type {
    whirl_group group;
    size_t number_count;
    size_t state_count;                    ///< most first-order states of its own
    bool modulated;                        ///< its forces are not linear in the values of time
    size_t turning;                        ///< number of these, from the first on, that are angles: 2 pi is 0
    bool spun;                             ///< its force depends on the speed of its shaft
    bool kinked;                           ///< its force has kinks without a switch
    const element_kernels *const *kernels; ///< by number of vector.h; NULL: it is part of the assembly only
    const struct whirl_element_type
        *variant; ///< type with other kernels and numbers to which `build` may set out->type

    /// Optional: coordinates and inertia that it adds to stations, before any is built.
    whirl_status (*inertia)(const key_value *values, assembly *to);

    /// Sets its ports, law and numbers from values, or adds to the assembly. WHIRL_BAD_INPUT for contradicting keys. It
    /// may change out->type to another one of its group with as many numbers, but other kernels and states.
    whirl_status (*build)(const key_value *values, assembly *to, element *out);

    /// Optional: switching functions, which it has `switch_count(own)` of; their derivatives by the places and
    /// velocities of the ports and by its states, and the second ones applied to a perturbation.
    size_t (*switch_count)(const element *own);
    void (*switch_gradient)(const element *own, const element_place *at, size_t index, element_place *by);
    void (*switch_curvature)(const element *own, const element_place *at, size_t index, const element_place *along,
                             element_place *by);

    /// With switches of a contact with a gap: returns true if a contact begins at switch `index`. NULL: at the first
    /// one.
    bool (*touches)(const element *own, size_t index);

    /// Optional: returns the rad/s of its phase if that defines sections, else 0; its first key is its station.
    double (*keyphasor)(const key_value *values, double speed);

    /// Optional: sets its states [own->states] for a centred station; the default is 0.
    void (*begin)(const element *own, double *states);

    /// Optional: sets its states [own->states] to a stable balance for given places of its ports, q [MAX_PORTS]; of
    /// several balances as in whirl_system.settle. idle [own->states]: states without restoring force or effect, which
    /// may stay. False without such a balance (a wall is touched).
    bool (*settle)(const element *own, const double *q, double *states, bool *idle);

    /// Optional: returns the index of a state that is only a clock; own->states if no state is. Linear analyses leave
    /// it at its start.
    size_t (*clock)(const element *own);

    /// Optional: provides tables that its kernels read in addition to its numbers, until `release`; gives up if *stop
    /// becomes true (NULL: never). WHIRL_NO_MEMORY, WHIRL_STOPPED: then nothing needs `release`.
    whirl_status (*hold)(const element *own, const whirl_stop *stop);
    void (*release)(const element *own);

    /// Optional, of states that stand for derivatives by the shaft's angle: writes, of every state [own->states], what
    /// it stands for times the power of the speed by which it falls; 0 for others.
    void (*paced)(const element *own, const double *states, double *out);

    /// With states that turn at a constant rate: rounds per revolution after which a state's effects repeat. NULL:
    /// never in whole revolutions.
    double (*rounds)(const element *own, size_t state);

    /// With switches: returns true if motions can slide along one (friction that jumps where the slip reverses).
    bool (*slides)(const element *own);

    /// With switches, optional: returns true if its force may jump at one.
    bool (*jumps)(const element *own);

    /// Optional, for films and seals: computes the torques, N m, of its fluid on journal and housing.
    void (*drag)(const element *own, const drag_view *in, double torque[2]);

    /// For unilateral contacts: returns the gap in length scales around its station; 0 if the stator moves.
    double (*contact_gap)(const element *own);

    /// Returns 1 if its friction takes power, which its contact's kernel reports; -1 if the radius is unknown; else 0.
    int (*rubs)(const element *own);

    /// Optional, for elements that may join two twists: finds what it carries in a state. The play of a spring or mesh
    /// is open where no force acts.
    void (*carry)(const element *own, const element_place *at, element_carried *out);
    whirl_torque_kind carries_as; ///< kind of that torque

    /// Returns true if contact does not follow from the gap alone: a force that depends on velocity (and jumps, unless
    /// `jumps` denies it), a stator that moves or is not all around.
    bool (*contact_damped)(const element *own);

    /// Optional: number of control loops and, for one of them, the effect of a signal added to its sensor's on the
    /// accelerations of the ports and the slopes of its states, and the sensor's signal by the ports' places.
    size_t loops;
    void (*loop)(const element *own, const double *q, const double *states, size_t index, double *acceleration,
                 double *slope, double *sensed);

    /// carries: elements of this type are bearings; drags: they are seals or impellers. A key `role` can decide this
    /// for a single element: bearing, or another word.
    bool carries, drags;

    /// For bearings and seals: the radial clearance in length scales around its station, as assembled.
    double (*bearing_clearance)(const element *own);

    /// Optional: the radial clearance around the ring whose ports are 2 and 3. The inner film then lies between ports
    /// 0, 1 and 4, 5, the outer one between 2, 3 and 6, 7.
    double (*ring_clearance)(const element *own);

    /// A part between journal and housing moves (a ring, a damper), so that no fixed wall limits the journal.
    bool yields;

    /// Optional, with a clearance: sets `least`, `wall` and pads of its film for a journal at rest at q [MAX_PORTS]
    /// with these states. NULL: the wall is a circle of the clearance.
    void (*film)(const element *own, const double *q, const double *states, element_film *out);

    /// Optional: returns order `index` (from 0) that may show in spectra, and its name; false beyond the last. Its
    /// other orders (a dent that is hit twice in a turn) are multiples.
    bool (*named_order)(const element *own, size_t index, double *order, const char **name);

    /// Optional: describes range `index` of its law, from 0 on, and how far a motion used it; false beyond the last.
    bool (*range)(const element *own, size_t index, const element_seen *seen, element_range *out);

    /// Optional: describes its numbers in SI; "": nothing. `length` and `clock` are the machine's length scale and
    /// clock.
    void (*note)(const element *own, double length, double clock, char *text, size_t size);

    /// Optional: raises a doubt for every value outside of its law's range, or unlike real parts; speed in rad/s, of
    /// the shaft of its first station.
    void (*doubt)(const key_value *values, double speed, const doubt_teller *to);
} element_type;

/// Raises a doubt about the value of a key, in a sentence that continues its name: "is 2 times the diameter: ...".
void doubt_value(const doubt_teller *to, const char *key, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/// Sets the ports of an element at the station of its key `at`: its coordinates along x and y (`first` is AXIS_X) or
/// both tilts (AXIS_TILT_X), NO_COORDINATE for directions in which it does not move.
void element_on(const key_value *at, const assembly *to, axis first, element *out);

/// Sets the station of an element between the two stations of its key `between`, and its ports: the first station's
/// coordinates along `axes` [count], then the other's (AXES: none). A port is NO_COORDINATE for the ground, and for an
/// axis along which a station does not move (`moves`). WHIRL_BAD_INPUT if both stations are the same, a station does
/// not tilt along one of the axes, or neither moves along any.
whirl_status element_between(const key_value *between, const assembly *to, const axis *axes, size_t count,
                             element *out);

/// Checks that the stations of `between` are not on one shaft of finite elements, to which a second shaft would be
/// added. WHIRL_BAD_INPUT.
whirl_status element_beside_none(const key_value *between, const assembly *to);

/// Sets ports in x and y of an element at a station, in a housing that is the station of `from`, or else the ground.
whirl_status element_in_housing(const key_value *at, const key_value *from, const assembly *to, element *out);

/// Returns whether the housing of an element with the ports of element_in_housing moves along neither axis.
static inline bool element_housing_stands(const element *own) {
    return own->port[2] == NO_COORDINATE && own->port[3] == NO_COORDINATE;
}

/// Implements element_type.drag for an oil film of a clearance in m: shear over the mean of 1/h, as if the film were
/// full, and half of the couple of its force on either side.
void drag_of_film(const element *own, const drag_view *in, double clearance, double torque[2]);

/// The library's elements in the order in which they act (the order fixes the last bits of a sum); terminated by NULL.
extern const element_type *const element_types[];

/// Keys of a station that shafts use.
enum { STATION_SHAFT, STATION_POSITION, STATION_BOW, STATION_BOW_ANGLE };

/// The station's own keys, its inertia, and what it adds to the assembly.
extern const whirl_group station_group;
whirl_status station_inertia(const key_value *values, assembly *to, size_t station);
void station_build(const key_value *values, assembly *to, size_t station);

#endif
