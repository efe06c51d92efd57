/// The built rotor as its equations of motion see it.
#ifndef ROTOR_MACHINE_H
#define ROTOR_MACHINE_H

#include "element.h"
#include "lanes.h"
#include "pair.h"
#include "whirl/rotor.h"

struct whirl_rotor {
    double speed, length;
    whirl_system system;
    whirl_lanes lanes;
    struct lanes_pair pair; ///< where it is one
    size_t station_count, element_count, contact_count;
    element *elements; ///< [element_count] those that have a kernel, in the registry's order
    double *numbers;   ///< [station_count][STATION_NUMBERS], then those of the elements, one after the other
    whirl_probe *probes;
    double *mass;
    size_t *contacts; ///< [contact_count] indices of elements
    char (*contact_text)[WHIRL_NAME_SIZE + 16];
    const char **contact_names;
};

/// The elements of the structure of pair_kernel.h: a shaft from station 0 to station 1, a film there, a rub at station
/// 0.
enum { PAIR_SHAFT, PAIR_FILM, PAIR_RUB, PAIR_ELEMENTS };

/// What rotors give to lanes.h: one function of each kind for every instruction set of vector.h (machine_<isa>.c,
/// flow_<isa>.c).
extern lanes_accelerate *const machine_accelerate[];
extern lanes_flow *const machine_flow[];
extern lanes_switches *const machine_switches[];
extern lanes_forcing *const machine_forcing[];
extern lanes_contacts *const machine_contacts[];
lanes_accelerate machine_accelerate_scalar, machine_accelerate_128, machine_accelerate_fma, machine_accelerate_avx2,
    machine_accelerate_avx512;
lanes_flow machine_flow_scalar, machine_flow_128, machine_flow_fma, machine_flow_avx2, machine_flow_avx512;
lanes_switches machine_switches_scalar, machine_switches_128, machine_switches_fma, machine_switches_avx2,
    machine_switches_avx512;
lanes_forcing machine_forcing_scalar, machine_forcing_128, machine_forcing_fma, machine_forcing_avx2,
    machine_forcing_avx512;
lanes_contacts machine_contacts_scalar, machine_contacts_128, machine_contacts_fma, machine_contacts_avx2,
    machine_contacts_avx512;

/// What rotors give to whirl/system.h beyond the right-hand side (rotor_system.c).
void rotor_rhs_on_sides(const void *model, double t, const double *forcing, const double *x, const double *sides,
                        double *dxdt);
void rotor_tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                   size_t count, const double *dx, double *ddxdt);
double rotor_divergence(const void *model, double t, const double *forcing, const double *x, const double *sides);
void rotor_switch_gradient(const void *model, double t, const double *x, size_t index, double *gradient,
                           double *by_time);
void rotor_switch_curvature(const void *model, double t, const double *x, size_t index, const double *u, double *out);

#endif
