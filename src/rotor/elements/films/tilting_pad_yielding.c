// Variant of tilting_pad whose pivots yield along the radius, with two more states for each pad.
#define KERNEL_FILE "elements/films/pads_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES PADS_YIELDING_STATES
#define KERNEL_FEWER_STATES
#define KERNEL_NUMBERS PADS_NUMBERS
#define KERNEL_SWITCHES 0
#define PADS_YIELD 1

#include "elements/films/pads_balance.h"
#include "generic.h"
#include "pads_build.h"
#include "registry.h"

const element_kernels ISA(tilting_pad_yielding_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include "elements/films/pads_drag.h"
#include "elements/films/pads_settle.h"
KERNELS_OF_EVERY_ISA(tilting_pad_yielding_kernels);

const element_type tilting_pad_yielding_type = {
    .group = {"tilting_pad", "a journal bearing of pads that tilt on pivots that yield", "", NULL, 0, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .kernels = kernels,
    .begin = pads_begin,
    .settle = pads_settle,
    .paced = pads_paced,
    .film = pads_film,
    .drag = pads_drag,
    .bearing_clearance = pads_clearance,
    .yields = true,
    .hold = pads_hold,
    .release = pads_release,
    .note = pads_note,
};
#endif
