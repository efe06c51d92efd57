/// What an element is made of: its keys, the numbers that follow from them, and its kernels.
///
/// All is scaled: time by 1/clock, lengths by the rotor's length scale, forces on a coordinate by its inertia, so that
/// an element adds to accelerations. The physics itself is in elements/<element>_kernel.h, written once over the vector
/// type; elements/<element>.c is compiled once for every instruction set and tells all else in the first of them.
#ifndef ROTOR_ELEMENT_H
#define ROTOR_ELEMENT_H

#include <stdbool.h>
#include <stddef.h>

#include "assembly.h"
#include "keys.h"
#include "vector.h"
#include "whirl/engine/rotor.h"
#include "whirl/engine/stop.h"
#include "whirl/status.h"

// Elements outside the library find these by names of the library.
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
    size_t count; ///< of a list of numbers; 0: `number` is all there is
    size_t rows;  ///< of equal lists that it is made of, one after the other; 1: it is one list
    double *list; ///< [count]
} key_value;

/// The most that one element has: coordinates that it sees, keys; states that switches depend on.
enum { MAX_PORTS = 8, MAX_KEYS = 64, MAX_ELEMENT_STATES = 32 };

/// Until `build` says how many states an element has.
#define STATES_OF_TYPE ((size_t)-1)

/// An element as its kernels see it. The structure (ports, law) is shared by all machines of a block, the numbers are
/// not.
typedef struct element {
    const struct whirl_element_type *type;
    size_t run;          ///< how many of its type follow one another from here, itself the first
    size_t first_number; ///< where its numbers begin, in those of the machine
    size_t part;         ///< its number among the machine's parts: stations, then elements
    int law;
    bool lumped;            ///< it is part of the assembly alone
    size_t port[MAX_PORTS]; ///< the coordinates that it sees; NO_COORDINATE: the ground's
    size_t state;           ///< where its own first-order states begin, in the rows of the velocities
    size_t states;          ///< how many it has: those of its type, unless `build` makes them fewer
    size_t first_switch;    ///< where its switches begin, in those of the machine
    size_t station;         ///< where it sits
    double *number;         ///< [type->number_count]
} element;

struct block;

/// Who is told of doubts, and the element that they are in.
typedef struct doubt_teller {
    whirl_design_tell *tell;
    void *context;
    size_t element;
} doubt_teller;

/// What a motion came to where an element is: extremes of the places of its ports, in length scales (0 of the ground),
/// and of its states; the largest distance from a housing that stands, else NaN.
typedef struct element_seen {
    double low[MAX_PORTS], high[MAX_PORTS];
    const double *state_low, *state_high;
    double radius;
} element_seen;

/// A film, as whirl_film_gap: lengths in length scales.
typedef whirl_film_gap element_film;

/// A range of its law: as whirl_law_range.
typedef struct element_range {
    const char *quantity, *unit, *limit;
    double most, reached;
} element_range;

/// What an element sees of a state or a perturbation, or derivatives by that: places and velocities of its ports, 0 of
/// the ground, and its states.
typedef struct element_place {
    double q[MAX_PORTS], v[MAX_PORTS], s[MAX_ELEMENT_STATES];
} element_place;

/// What an element does in lanes; one for every instruction set. NULL for what it has not.
typedef struct element_kernels {
    /// Adds the accelerations of `count` elements of one type, one after the other, those of the perturbations by their
    /// derivatives, and the trace of these to the divergence.
    void (*flow)(const element *first, size_t count, const struct block *b);

    /// Writes its switching functions and, unless NULL, their derivatives by time: rows of the block's stride.
    void (*switches)(const element *own, const struct block *b, void *values, void *rates);

    /// Writes the normal force of its contact in newtons and, unless NULL, what its friction does: two rows of the
    /// block's stride, as whirl_system.friction has it.
    void (*contact)(const element *own, const struct block *b, void *force, void *friction);
} element_kernels;

/// The table `kernels` of those that the file has been compiled to, for its element_type.
#define KERNELS_OF_EVERY_ISA(name)                                                                                     \
    FOR_EVERY_ISA(const element_kernels, name);                                                                        \
    static const element_kernels *const kernels[VECTOR_ISAS] = EVERY_ISA(&, name)

typedef struct whirl_element_type {
    whirl_group group;
    size_t number_count;
    size_t state_count;                    ///< first-order states of its own, at most
    bool modulated;                        ///< its forces depend on the values of time in other ways than in proportion
    size_t turning;                        ///< of these, from the first on, are angles: 2 pi is 0
    bool spun;                             ///< its force goes with the speed of the shaft that it acts on
    bool kinked;                           ///< its force has kinks that no switch tells of
    const element_kernels *const *kernels; ///< by number of vector.h; NULL: it is part of the assembly alone
    const struct whirl_element_type *variant; ///< what `build` may make of it, as out->type: other kernels and numbers

    /// Optional: coordinates and inertia that it adds to stations, before any is built.
    whirl_status (*inertia)(const key_value *values, assembly *to);

    /// Its ports, law and numbers from values, or what it adds to the assembly. WHIRL_BAD_INPUT where keys contradict
    /// each other. It may change out->type to another one of its group with as many numbers, but other kernels and
    /// states of its own.
    whirl_status (*build)(const key_value *values, assembly *to, element *out);

    /// Optional: switching functions, which it has `switch_count(own)` of; their derivatives by the places and
    /// velocities of the ports and by its states, and the second ones applied to a perturbation.
    size_t (*switch_count)(const element *own);
    void (*switch_gradient)(const element *own, const element_place *at, size_t index, element_place *by);
    void (*switch_curvature)(const element *own, const element_place *at, size_t index, const element_place *along,
                             element_place *by);

    /// With switches of a contact with a gap: whether one begins at switch `index`. NULL: at the first one.
    bool (*touches)(const element *own, size_t index);

    /// Optional: rad/s of its phase where sections are to be taken by it, else 0; its first key is its station.
    double (*keyphasor)(const key_value *values, double speed);

    /// Optional: the states [own->states] that it has where its place rests in the middle; else 0.
    void (*begin)(const element *own, double *states);

    /// Optional: sets its states [own->states] to where they balance while the places of its ports, q [MAX_PORTS], are
    /// held, in a way that no small motion of the states alone leaves; of several balances as whirl_system.settle says.
    /// idle [own->states]: nothing holds them, and they act on nothing. False where there is no such balance (a wall is
    /// touched). Idle ones may stay where they are.
    bool (*settle)(const element *own, const double *q, double *states, bool *idle);

    /// Optional: which of its states only tells the time, from its start on; own->states: none does. Linear analyses
    /// leave it at its start.
    size_t (*clock)(const element *own);

    /// Optional: sees to it that what its kernels read beside its numbers is there until `release`; gives up where
    /// *stop becomes true (NULL: never). WHIRL_NO_MEMORY, WHIRL_STOPPED: then nothing is held.
    whirl_status (*hold)(const element *own, const whirl_stop *stop);
    void (*release)(const element *own);

    /// With states that turn at a constant rate: how often what follows from one comes round in a revolution. NULL:
    /// they never fit revolutions.
    double (*rounds)(const element *own, size_t state);

    /// With switches: whether motions can slide along one (friction that jumps where the slip reverses).
    bool (*slides)(const element *own);

    /// With switches, optional: whether its force may jump at one.
    bool (*jumps)(const element *own);

    /// For unilateral contacts: the gap in length scales around its station; 0 where the stator moves.
    double (*contact_gap)(const element *own);

    /// Whether its friction takes power, which its contact's kernel tells of; -1: it does, but its radius is not known.
    int (*rubs)(const element *own);

    /// Whether more than the gap tells of contact: a force that depends on the velocity, which jumps where `jumps` does
    /// not say otherwise, a stator that moves or is not all around.
    bool (*contact_damped)(const element *own);

    /// Optional: loops of control that it has, and of one of them what a signal added to its sensor's adds to the
    /// accelerations of the ports and to the slopes of its states, and the sensor's signal by the ports' places.
    size_t loops;
    void (*loop)(const element *own, const double *q, const double *states, size_t index, double *acceleration,
                 double *slope, double *sensed);

    /// What carries the rotor, and what drags it besides (seals, impellers). A key `role`, where there is one, says it
    /// of a single element: bearing, or another word.
    bool carries, drags;

    /// For bearings and seals: the radial clearance in length scales around its station, as assembled.
    double (*bearing_clearance)(const element *own);

    /// Optional: that around the ring whose ports are 2 and 3. The first film then lies between ports 0, 1 and 4, 5,
    /// this one between 2, 3 and 6, 7.
    double (*ring_clearance)(const element *own);

    /// What holds its journal moves, though the housing may stand: the journal has no wall in any place.
    bool yields;

    /// Optional, with a clearance: `least`, `wall` and pads of its film with the journal at rest where q [MAX_PORTS]
    /// and its states say. NULL: the wall is a circle of the clearance.
    void (*film)(const element *own, const double *q, const double *states, element_film *out);

    /// Optional: the order, from number 0 on, at which it may show in spectra, and its name; false beyond the last.
    /// What it has of another order too (a dent that is hit twice in a turn) follows from multiples.
    bool (*named_order)(const element *own, size_t index, double *order, const char **name);

    /// Optional: range `index` of its law, from 0 on, with what a motion reached of it; false beyond the last.
    bool (*range)(const element *own, size_t index, const element_seen *seen, element_range *out);

    /// Optional: what its numbers come to, in SI; "": nothing. Of the machine the length scale and the clock.
    void (*note)(const element *own, double length, double clock, char *text, size_t size);

    /// Optional: raises a doubt for every value that its law is not for, or that no such part has; speed in rad/s, of
    /// the shaft that its first station lies on.
    void (*doubt)(const key_value *values, double speed, const doubt_teller *to);
} element_type;

/// Raises a doubt in the value of a key, in a sentence that begins behind its name: "is 2 times the diameter: ...".
void doubt_value(const doubt_teller *to, const char *key, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/// The ports of an element at the station of its key `at`: its coordinates along x and y (`first` is AXIS_X) or both
/// tilts (AXIS_TILT_X), NO_COORDINATE where it does not move so.
void element_on(const key_value *at, const assembly *to, axis first, element *out);

/// The ports of an element between the two stations of its key `between`, one of them perhaps the ground: the first
/// one's coordinates along `axes` [count], then the other's (AXES: none), with NO_COORDINATE for the ground's and for
/// those along which a station does not move (`moves`), where it is held as the ground is; and the station where it
/// sits. WHIRL_BAD_INPUT where both are one, a station does not tilt along one of the axes, or neither moves along any.
whirl_status element_between(const key_value *between, const assembly *to, const axis *axes, size_t count,
                             element *out);

/// WHIRL_BAD_INPUT where both stations of `between` lie on one shaft of finite elements: what stands for a shaft
/// between them would be one beside it, and add its stiffness.
whirl_status element_beside_none(const key_value *between, const assembly *to);

/// The same in x and y of an element at a station, in a housing that is the station of `from`, or else the ground.
whirl_status element_in_housing(const key_value *at, const key_value *from, const assembly *to, element *out);

/// Returns whether the housing of an element with the ports of element_in_housing moves along neither axis.
static inline bool element_housing_stands(const element *own) {
    return own->port[2] == NO_COORDINATE && own->port[3] == NO_COORDINATE;
}

/// The library's elements in the order in which they act (the order fixes the last bits of a sum); ended by NULL.
extern const element_type *const element_types[];

/// Keys of a station that shafts look at.
enum { STATION_SHAFT, STATION_POSITION, STATION_BOW, STATION_BOW_ANGLE };

/// The station's own keys, its inertia, and what it adds to the assembly.
extern const whirl_group station_group;
whirl_status station_inertia(const key_value *values, assembly *to, size_t station);
void station_build(const key_value *values, assembly *to, size_t station);

#endif
