/// Interface of a system whose machines run side by side in vector lanes.
///
/// All machines of a block have the same structure (coordinates, elements, laws) and each its own numbers. Arrays hold
/// for every quantity `stride` vectors: quantity k of lane l is at [k * stride * VECTOR_LANES + l].
#ifndef BASE_LANES_H
#define BASE_LANES_H

#include <stdbool.h>
#include <stddef.h>

/// Machines side by side, each lane at its own time and on its own sides of the switches, with perturbations. All
/// arrays are vectors of the function's instruction set.
typedef struct lanes_view {
    const void *model;
    size_t stride, vectors;
    void *numbers;        ///< constants of each machine; a system may have further rows there that it computes from the
                          ///< state in every call
    const size_t *places; ///< [part_count] start of each part's numbers; NULL: parts follow each other, unshared
    const void *forcing;  ///< [forcing_count]
    const void *sides;    ///< [switch_count] -1 or +1, as whirl_system.rhs_on_sides takes them; NULL: the state decides
    size_t tangents;      ///< perturbations that follow the state
    size_t rates;         ///< rows of v and a for the state and each perturbation; 0: degrees + states of the model
    const size_t *columns; ///< [degrees + rates] number, from 0, of the perturbation that is 1 in each coordinate; each
                           ///< perturbation is 0 in all other coordinates. NULL: perturbations are any vectors
    const void *q, *v;     ///< [1 + tangents][degrees] and [degrees + states] of the state, then of the perturbations
    void *a;               ///< [1 + tangents][degrees + states]
    void *divergence;      ///< one quantity: trace of the Jacobian; NULL: not requested
} lanes_view;

/// Writes the accelerations of the state and those of the perturbations by the Jacobian, with the slopes of the states
/// of first order after them, and the divergence. Accelerations are sums of terms in proportion to the forcing and of
/// others that do not depend on it, unless the system is `modulated`.
typedef void lanes_flow(const lanes_view *view);

/// Writes the switching functions at (q, v) and, unless NULL, their derivatives by time along (v, a): [switch_count].
typedef void lanes_switches(const lanes_view *view, void *values, void *rates);

/// Writes the values that depend on time alone: forcing [forcing_count] at the times t.
typedef void lanes_forcing(const void *model, size_t stride, size_t vectors, const void *t, void *forcing);

/// Writes the normal forces [contact_count] at (q, v), 0 while open, in the model's unit of force; and, unless NULL,
/// the torque and power of friction, [contact_count][2] as in whirl_system.friction.
typedef void lanes_contacts(const lanes_view *view, void *normal_force, void *friction);

/// A state is degrees positions, then their derivatives, then first-order states.
struct whirl_lanes {
    size_t degrees, states;
    size_t number_count;                               ///< numbers of one machine
    void (*numbers)(const void *model, double *out);   ///< [number_count]
    bool (*alike)(const void *one, const void *other); ///< same structure
    /// Sharing: parts whose numbers are equal in all machines of a block use the numbers of the first machine,
    /// [part_count], so that caches hold more. `part` gives a part its own numbers if it differs in a machine, and
    /// returns how many numbers are in use.
    size_t part_count;
    const size_t *places;
    size_t (*part)(const void *model, size_t *places);
    /// Sets the entries of [degrees + states][2 degrees + states] by which accelerations, and slopes of first-order
    /// states, may depend on positions, velocities and these states.
    void (*depends)(const void *model, bool *table);
    size_t switch_count, contact_count;
    /// Writes the probe at which contact `index` acts, and its gap.
    void (*contact)(const void *model, size_t index, size_t *probe, double *gap);
    /// Groups of consecutive coordinates whose sizes are measured together: group g has groups[g] up to groups[g + 1],
    /// [group_count + 1].
    size_t group_count;
    const size_t *groups;
    bool modulated; ///< accelerations are not linear in the forcing
    bool slides;    ///< motions can slide along a switch
    bool jumps;     ///< accelerations may jump at a switch
    bool damped;    ///< normal forces depend on velocities too: `contacts` defines contact, not the closed gap
    bool lags;      ///< switches depend on first-order states, so that their time derivatives need slopes
    bool rubs;      ///< friction takes power, which `contacts` reports
    /// Tables of functions, one for every instruction set of vector.h; NULL for sets that are not built.
    lanes_flow *const *flow;
    lanes_switches *const *switches;
    lanes_forcing *const *forcing;
    lanes_contacts *const *contacts;
    /// Laws of a pair, for which integrators have loops of their own (rotor/pair.h); otherwise NULL.
    const int *pair_laws;
};

#endif
