/// The built rotor as its equations of motion see it.
#ifndef ROTOR_MACHINE_H
#define ROTOR_MACHINE_H

#include "coupling.h"
#include "element.h"
#include "lanes.h"
#include "mesh.h"
#include "whirl/engine/rotor.h"
#include "whirl/engine/system.h"

struct whirl_rotor {
    double speed, clock, length;
    double cross_coupling; ///< N/m, of all stages
    /// -1: what turns with the shaft turns by -tau; with a phase that is a state this is in its slope. 0: it stands
    /// still.
    double way;
    char keyphasor[WHIRL_NAME_SIZE + 16]; ///< what sections are taken by; "": the shaft
    /// Row of the shaft's phase among the rates where it is a state, whose slope is the last number; else 0.
    size_t phase;
    whirl_system system;
    whirl_lanes lanes;
    lanes_instance instance;           ///< where it is one
    size_t station_count, plane_count; ///< stations, and those that move in x and y
    size_t term_count, element_count, contact_count;
    linear_term *terms;
    coupling coupled; ///< by masses; the same in all machines of a block
    /// Terms that shafts of finite elements are; the same in all machines of a block.
    body_panels body;      ///< numbers scaled but for their rates
    size_t first_rate;     ///< where the machine's rates are among its numbers
    size_t begun;          ///< coordinates from there on are begun by the body, those before by stations or at zero
    between_term *between; ///< [between_count] what lies between stations, of displacements of these
    size_t between_count;
    double *frequencies; ///< [frequency_count] as whirl_system has them
    size_t frequency_count;
    element *elements; ///< [element_count] those that have kernels, in the registry's order
    double *numbers;   ///< [plane_count][STATION_NUMBERS], those of the terms, then those of the elements
    size_t *places;    ///< [plane_count + element_count] as whirl_lanes has them
    whirl_probe *probes;
    whirl_runout *runouts; ///< of the probes, station after station
    size_t *groups;        ///< [lanes.group_count + 1]
    double *turns;         ///< [dimension] as whirl_system has them
    bool turning;          ///< some of them are not 0
    size_t repeats;        ///< as whirl_system has them
    bool kinked;           ///< as whirl_system has it
    size_t held;           ///< elements, the first ones, whose `hold` is behind them
    bool mute;             ///< there is friction whose power is not known
    size_t *contacts;      ///< [contact_count] indices of elements
    char (*contact_text)[WHIRL_NAME_SIZE + 32];
    const char **contact_names;
};

/// The most first-order states that the elements of a rotor have together.
enum { MAX_OWN_STATES = 2 * WHIRL_MAX_ELEMENTS };

enum { INSTANCE_STATIONS = 2 }; ///< most of one

/// Of every structure of instances.h: whether a machine is it when its stations' coordinates come in the order told,
/// and its laws [INSTANCE_LAWS].
typedef bool instance_find(const assembly *of, const element *elements, size_t count, size_t order[INSTANCE_STATIONS],
                           int *laws);
instance_find pair_find;

/// What rotors give to lanes.h: one function of each kind for every instruction set of vector.h (kernels/machine.c).
FOR_EVERY_ISA(lanes_flow, machine_flow);
FOR_EVERY_ISA(lanes_switches, machine_switches);
FOR_EVERY_ISA(lanes_forcing, machine_forcing);
FOR_EVERY_ISA(lanes_contacts, machine_contacts);

/// What rotors give to lanes.h besides (rotor_lanes.c), once their parts are there.
void rotor_lanes_fill(whirl_rotor *rotor);

/// What rotors give to whirl/engine/system.h (rotor_system.c): fills in the functions of the rotor's system.
void rotor_system_fill(whirl_rotor *rotor);

// ---------------------------------------------------------------- repeats
// After how many revolutions phases come back that turn at ratios of the speed.

/// The smallest q up to WHIRL_MAX_REPEATS for which q times `ratio` is whole, to rounding; 0 where there is none.
size_t repeats_of(double ratio);

/// For two phases that come back after a and b revolutions (0: never).
size_t repeats_of_both(size_t a, size_t b);

#endif
