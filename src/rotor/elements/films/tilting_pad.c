// A journal bearing with pads that tilt; their tilts are states.
#define KERNEL_FILE "elements/films/pads_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES PADS_STATES
#define KERNEL_FEWER_STATES
#define KERNEL_NUMBERS PADS_NUMBERS
#define KERNEL_SWITCHES 0

#include "elements/films/pads_balance.h"
#include "generic.h"
#include "pads_build.h"
#include "registry.h"

const element_kernels ISA(tilting_pad_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include "elements/films/pads_drag.h"
#include "elements/films/pads_settle.h"

static const whirl_key keys[PADS_TILTING_KEYS] = {
    PADS_KEYS("tilting-4|tilting-5"),
    [PADS_INERTIA] =
        NUMBER_KEY("inertia", "I", "kg m2", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                   "moment of inertia of a pad about its pivot; 0: the film alone determines how fast it tilts"),
    [PADS_SPRING] = NUMBER_KEY("tilt_stiffness", "k", "N m/rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                               "stiffness of a pivot against tilting, which holds pads whose film carries nothing"),
    [PADS_DAMPER] = NUMBER_KEY("tilt_damping", "d", "N m s/rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                               "damping of a pivot against tilting; at least 3e-4 mu R^3 L (R/c)^2/c"),
    [PADS_PIVOT] = NUMBER_KEY("pivot_stiffness", "k_p", "N/m", OPTIONAL, WHIRL_POSITIVE,
                              "stiffness of a pivot along the radius; absent: rigid"),
    [PADS_PIVOT_DAMPER] = NUMBER_KEY("pivot_damping", "d_p", "N s/m", OPTIONAL, WHIRL_NOT_NEGATIVE,
                                     "damping of a pivot along the radius"),
    [PADS_MASS] = NUMBER_KEY("pad_mass", "m_p", "kg", OPTIONAL, WHIRL_POSITIVE, "mass of a pad; with pivot_stiffness"),
};

static whirl_status tilting_pad_build(const key_value *values, assembly *to, element *out) {
    return pads_build(values, true, to, out);
}

KERNELS_OF_EVERY_ISA(tilting_pad_kernels);

const element_type tilting_pad_element = {
    .group = {"tilting_pad", "a journal bearing of pads that tilt", "Lund 1964; Parsell, Allaire, Barrett 1983", keys,
              PADS_TILTING_KEYS, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .kernels = kernels,
    .build = tilting_pad_build,
    .begin = pads_begin,
    .settle = pads_settle,
    .paced = pads_paced,
    .film = pads_film,
    .variant = &tilting_pad_yielding_type,
    .carries = true,
    .drag = pads_drag,
    .bearing_clearance = pads_clearance,
    .hold = pads_hold,
    .release = pads_release,
    .note = pads_note,
    .doubt = pads_doubt,
};
#endif
