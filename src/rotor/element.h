/// Interface of elements: their keys, the numbers computed from them, and their kernels.
///
/// All quantities are scaled: time by 1/clock, lengths by the rotor's length scale, forces on a coordinate by its
/// inertia, so that an element adds to accelerations. The physics itself is in elements/<group>/<element>_kernel.h,
/// written once over the vector type. elements/<group>/<element>.c is compiled once for every instruction set; the
/// build for one lane also defines everything that does not depend on the instruction set.
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

// Symbols that elements outside the library use have names that begin with whirl_.
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
    size_t rows;  ///< number of rows of equal length in the list, one after the other; 1: a simple list
    double *list; ///< [count]
} key_value;

/// Maxima of one element: number of its ports (coordinates on which it acts), of its keys, and of its states.
enum { MAX_PORTS = 12, MAX_KEYS = 64, MAX_ELEMENT_STATES = 32 };

/// Placeholder until `build` sets the number of an element's states.
#define STATES_OF_TYPE ((size_t)-1)

/// Constants of the drag by an element's fluid on shafts whose speed is a state (drag.c). Contacts have a housing
/// alone.
typedef struct fluid_drag {
    double shear; ///< torque of the shear between centred surfaces divided by the difference of their speeds, N m s; 0:
                  ///< none
    double reynolds; ///< Reynolds number of the film divided by that difference, s
    int turbulence;  ///< whirl_turbulence
    double turns[2]; ///< ratios of the speeds of journal and housing to the shaft's
    size_t spool[2]; ///< shafts with a speed of their own that carry journal and housing, from 1; 0: none of these
    size_t housing;  ///< station of the housing; GROUND
} fluid_drag;

/// An element as its kernels see it. All machines of a block share the structure (ports, law), but not the numbers.
typedef struct element {
    const struct whirl_element_type *type;
    size_t run;          ///< number of successive elements of its type from this one on, itself included
    size_t first_number; ///< index of its first number among those of the machine
    size_t part;         ///< index among the machine's parts: stations, then elements
    int law;
    bool lumped;             ///< it is part of the assembly only
    bool round;              ///< its force does not depend on speed or angle of its shaft, though those of its type may
    size_t spool;            ///< shaft with a speed of its own with which it turns, from 1; 0: none of these
    size_t port[MAX_PORTS];  ///< coordinates on which it acts; NO_COORDINATE: the ground
    double share[MAX_PORTS]; ///< ratio of the motion of the place to its coordinate: 1, for twists the ratio of gears
    size_t state;            ///< index of its first first-order state, in the rows of the velocities
    size_t states;           ///< number of its states: those of its type, unless `build` sets fewer
    size_t first_switch;     ///< index of its first switch among those of the machine
    size_t station;          ///< index of its station
    size_t ends[2];          ///< stations of an element between two places (GROUND: the ground); otherwise 0
    fluid_drag fluid;        ///< drag of films and seals
    double *number;          ///< [type->number_count]
} element;

struct block;

/// Receiver of doubts (warnings about values), and the element to which they refer.
typedef struct doubt_teller {
    whirl_design_tell *tell;
    void *context;
    size_t element;
} doubt_teller;

/// Extent of a motion at an element: extremes of the displacements of its ports, in length scales (0 for the ground),
/// and of its states; and the largest distance from a fixed housing, NaN without one.
typedef struct element_seen {
    double low[MAX_PORTS], high[MAX_PORTS];
    const double *state_low, *state_high;
    double radius;
} element_seen;

/// A film, as whirl_film_gap, with lengths in length scales.
typedef whirl_film_gap element_film;

/// A range in which an element's law is valid, as whirl_law_range.
typedef struct element_range {
    const char *quantity, *unit, *limit;
    double most, reached;
} element_range;

/// The part of a state or a perturbation that an element sees, or derivatives by this part: displacements and
/// velocities of its ports (0 for the ground), and its states.
typedef struct element_place {
    double q[MAX_PORTS], v[MAX_PORTS], s[MAX_ELEMENT_STATES];
} element_place;

/// A film or seal in motion, as its drag sees it, in SI. If the shaft turns clockwise, all quantities are mirrored.
typedef struct drag_view {
    const element_place *at;   ///< the state itself, with derivatives by the shaft's angle
    double length;             ///< m of one unit of displacement
    double force_scale;        ///< force that gives the first port one unit of acceleration, N
    double speed;              ///< rad/s of the shaft
    double spin[2];            ///< speeds of journal and housing, rad/s
    double place[2], distance; ///< position of the journal relative to its housing, and distance from it, m
    double force[2];           ///< N on the journal
} drag_view;

/// Load of an element between two twists. Its closing is a weighted sum of the displacements of its ports; a positive
/// one compresses the element.
typedef struct element_carried {
    double closing[MAX_PORTS]; ///< weight of each port's displacement in the closing
    double unit;               ///< m or rad of one unit of closing
    double lever[2];           ///< torque on each place about z by one unit of force, N m; 0: the place does not twist
    double force;              ///< force (N) or moment (N m) that compresses the element in this state
    double play;               ///< closing in either direction up to which no force acts
    double stiffness, damping; ///< derivatives of the force by the closing and by its rate, beyond the play; averaged
                               ///< over phases that turn
    bool open;                 ///< the state is within its play
    double error_order, error[2]; ///< the force depends on the closing minus Re(error exp(i error_order tau)); 0: no
                                  ///< error
} element_carried;

/// Kernels of an element in lanes, for one instruction set; NULL if the element has none of a kind.
typedef struct element_kernels {
    /// Adds the accelerations by `count` adjacent elements of one type; those of the perturbations by their
    /// derivatives; and the trace of the derivatives to the divergence.
    void (*flow)(const element *first, size_t count, const struct block *b);

    /// Writes the element's switching functions and, unless NULL, their derivatives by time: rows of the block's
    /// stride.
    void (*switches)(const element *own, const struct block *b, void *values, void *rates);

    /// Writes the normal force of the element's contact in newtons and, unless NULL, the torque and the power of its
    /// friction: two rows of the block's stride, as in whirl_system.friction.
    void (*contact)(const element *own, const struct block *b, void *force, void *friction);
} element_kernels;

/// Defines the table `kernels` of an element_type: the kernels of the including file, one for every instruction set for
/// which the file is compiled.
#define KERNELS_OF_EVERY_ISA(name)                                                                                     \
    FOR_EVERY_ISA(const element_kernels, name);                                                                        \
    static const element_kernels *const kernels[VECTOR_ISAS] = EVERY_ISA(&, name)

typedef struct whirl_element_type {
    whirl_group group;
    size_t number_count;
    size_t state_count;                    ///< most first-order states of an element
    bool modulated;                        ///< its forces are not linear in the forcing
    size_t turning;                        ///< number of its states, from the first on, that are angles
    bool spun;                             ///< its force depends on the speed of its shaft
    bool follows;                          ///< its force depends on the shaft of the stations of its first key
    bool slides_by_shaft;                  ///< it knows the speeds of shafts that are their own (whirl_spool)
    bool kinked;                           ///< its force has kinks without a switch
    const element_kernels *const *kernels; ///< [VECTOR_ISAS]; NULL: the element is part of the assembly only
    const struct whirl_element_type
        *variant; ///< type with other kernels and numbers to which `build` may set out->type

    /// Optional: adds coordinates and inertia to stations, before any element is built.
    whirl_status (*inertia)(const key_value *values, assembly *to);

    /// Sets the element's ports, law and numbers from values, or adds to the assembly. WHIRL_BAD_INPUT for
    /// contradicting keys. It may set out->type to the type's variant, which has other kernels and may have more
    /// numbers and other states.
    whirl_status (*build)(const key_value *values, assembly *to, element *out);

    /// Optional, for `switch_count(own)` switching functions: their derivatives by the displacements and velocities of
    /// the ports and by the element's states; and the second derivatives applied to a perturbation.
    size_t (*switch_count)(const element *own);
    void (*switch_gradient)(const element *own, const element_place *at, size_t index, element_place *by);
    void (*switch_curvature)(const element *own, const element_place *at, size_t index, const element_place *along,
                             element_place *by);

    /// For switches of a contact with a gap: returns true if a contact begins at switch `index`. NULL: at the first
    /// switch.
    bool (*touches)(const element *own, size_t index);

    /// Optional: returns the rate of the element's phase, rad/s, if that defines sections, otherwise 0. The element's
    /// first key must be its station.
    double (*keyphasor)(const key_value *values, double speed);

    /// Optional: sets the element's states [own->states] for a centred station. Without it they are 0.
    void (*begin)(const element *own, double *states);

    /// Optional: sets the element's states [own->states] to a stable balance for given displacements of its ports, q
    /// [MAX_PORTS]. If there are several, the choice is that of whirl_system.settle. idle [own->states]: states without
    /// restoring force or effect, which may stay. Returns false if there is no such balance (a wall is touched).
    bool (*settle)(const element *own, const double *q, double *states, bool *idle);

    /// Optional: returns the index of a state that is only a clock, own->states if no state is one. Linear analyses
    /// leave the clock at its start.
    size_t (*clock)(const element *own);

    /// Optional: provides tables that the kernels read in addition to the element's numbers, until `release`. Gives up
    /// if *stop becomes true (NULL: never). After WHIRL_NO_MEMORY and WHIRL_STOPPED nothing needs `release`.
    whirl_status (*hold)(const element *own, const whirl_stop *stop);
    void (*release)(const element *own);

    /// Optional, for states that represent derivatives by the shaft's angle, of order p, which are proportional to
    /// 1/speed^p: writes p times the represented quantity for every state, out [own->states]; 0 for other states.
    void (*paced)(const element *own, const double *states, double *out);

    /// Optional, for an unbalance that turns at a fixed ratio of the shaft's speed: computes the force on each of its
    /// first two ports by a unit of the shaft's acceleration, lever [2], kg m. speed: speed of the shaft for which its
    /// numbers hold, rad/s. Returns its moment times that ratio, kg m; 0 if it does not turn with the shaft.
    double (*lever)(const element *own, double speed, const double *states, double lever[2]);

    /// For states that turn at a constant rate: returns how many periods a state's effects have in a revolution (twice
    /// its turns if they repeat after half a turn). NULL: the effects never repeat after whole revolutions.
    double (*rounds)(const element *own, size_t state);

    /// For switches: returns true if motions can slide along a switch of the element (friction that jumps where the
    /// slip reverses).
    bool (*slides)(const element *own);

    /// Optional, for switches: returns true if the element's force may jump at a switch.
    bool (*jumps)(const element *own);

    /// Optional, for films and seals: computes the torques of the fluid on journal and housing, N m.
    void (*drag)(const element *own, const drag_view *in, double torque[2]);

    /// For unilateral contacts: returns the gap around the station in length scales, or 0 if the stator moves.
    double (*contact_gap)(const element *own);

    /// Returns 1 if the element's friction takes power, which its contact's kernel reports; -1 if this power is unknown
    /// since the radius is not given; otherwise 0.
    int (*rubs)(const element *own);

    /// Optional, for elements that may join two twists: finds the load that the element carries in a state. The play of
    /// a spring or mesh is open where no force acts.
    void (*carry)(const element *own, const element_place *at, element_carried *out);
    whirl_torque_kind carries_as; ///< kind of the torque that it carries

    /// Returns true if the gap alone does not determine contact: the force depends on velocity (and jumps, unless
    /// `jumps` denies it), or the stator moves or does not surround the rotor.
    bool (*contact_damped)(const element *own);

    /// Optional: number of control loops; and the input and output of one of them. acceleration, slope: derivatives of
    /// the accelerations of the ports and of the slopes of the states by a signal that is added to the sensor's.
    /// sensed: derivatives of the sensor's signal by the displacements of the ports.
    size_t loops;
    void (*loop)(const element *own, const double *q, const double *states, size_t index, double *acceleration,
                 double *slope, double *sensed);

    /// carries: elements of this type are bearings; drags: they are seals or impellers. A key `role` can decide this
    /// for a single element: bearing, or another word.
    bool carries, drags;

    /// For bearings and seals: returns the radial clearance around the station in length scales, as assembled.
    double (*bearing_clearance)(const element *own);

    /// Optional: returns the radial clearance around the ring whose ports are 2 and 3. The inner film is then between
    /// ports 0, 1 and 4, 5, the outer film between 2, 3 and 6, 7.
    double (*ring_clearance)(const element *own);

    /// A part between journal and housing moves (a ring, a damper): no fixed wall limits the journal.
    bool yields;

    /// Optional, with a clearance: sets `least`, `wall` and the pads of the film for a journal at rest at q [MAX_PORTS]
    /// with these states. NULL: the wall is a circle with the clearance as radius.
    void (*film)(const element *own, const double *q, const double *states, element_film *out);

    /// Optional: returns order `index` (from 0) that may appear in spectra, and its name. Returns false beyond the
    /// last. Other orders of the element (a dent that is hit twice in a turn) are multiples of these.
    bool (*named_order)(const element *own, size_t index, double *order, const char **name);

    /// Optional: describes range `index` (from 0) of the element's law, and which part of it a motion used. Returns
    /// false beyond the last.
    bool (*range)(const element *own, size_t index, const element_seen *seen, element_range *out);

    /// Optional: describes the element's numbers in SI; an empty text if there is nothing to say. `length` and `clock`
    /// are the machine's length scale and clock.
    void (*note)(const element *own, double length, double clock, char *text, size_t size);

    /// Optional: raises a doubt for every value outside of its law's range, or unlike real parts. speed: that of the
    /// shaft of the element's first station, rad/s.
    void (*doubt)(const key_value *values, double speed, const doubt_teller *to);
} element_type;

/// Raises a doubt about the value of a key, in a sentence that continues its name: "is 2 times the diameter: ...".
void doubt_value(const doubt_teller *to, const char *key, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/// Sets the ports of an element at the station of its key `at`: the station's coordinates along x and y (`first` is
/// AXIS_X), or both tilts (AXIS_TILT_X). A port is NO_COORDINATE for a direction in which the station does not move.
void element_on(const key_value *at, const assembly *to, axis first, element *out);

/// Sets the station of an element between the two stations of its key `between`, and its ports: the first station's
/// coordinates along `axes` [count], then the other's (AXES: none). A port is NO_COORDINATE for the ground, and for an
/// axis along which a station does not move (`moves`). WHIRL_BAD_INPUT if both stations are the same, if a station does
/// not tilt along one of the axes, or if neither moves along any axis.
whirl_status element_between(const key_value *between, const assembly *to, const axis *axes, size_t count,
                             element *out);

/// Checks that the stations of `between` are not on one shaft of finite elements: the element would add a second shaft.
/// WHIRL_BAD_INPUT.
whirl_status element_beside_none(const key_value *between, const assembly *to);

/// Sets the ports in x and y of an element at a station, in a housing. The housing is the station of `from`, or the
/// ground.
whirl_status element_in_housing(const key_value *at, const key_value *from, const assembly *to, element *out);

/// Returns true if the housing of an element with the ports of element_in_housing moves along neither axis.
static inline bool element_housing_stands(const element *own) {
    return own->port[2] == NO_COORDINATE && own->port[3] == NO_COORDINATE;
}

/// Implements element_type.drag for an oil film with a clearance in m: the shear by the mean of 1/h, as if the film
/// were full, and half of the couple of the film's force on either side.
void drag_of_film(const element *own, const drag_view *in, double clearance, double torque[2]);

/// Elements of the library in the order in which they act, terminated by NULL. The order fixes the last bits of a sum.
extern const element_type *const element_types[];

/// Keys of a station that shafts use.
enum { STATION_SHAFT, STATION_POSITION, STATION_BOW, STATION_BOW_ANGLE };

/// The keys of a station, its inertia, and its contribution to the assembly.
extern const whirl_group station_group;
whirl_status station_inertia(const key_value *values, assembly *to, size_t station);
void station_build(const key_value *values, assembly *to, size_t station);

#endif
