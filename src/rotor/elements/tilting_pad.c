// A journal bearing of pads that tilt, with their tilts as states.
#define KERNEL_FILE "elements/pads_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES PADS_STATES
#define KERNEL_FEWER_STATES
#define KERNEL_NUMBERS PADS_NUMBERS
#define KERNEL_SWITCHES 0

#include "elements/pads_look_up.h"
#include "generic.h"
#include "pads_build.h"
#include "registry.h"

const element_kernels ISA(tilting_pad_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

#include <math.h>

#include "centred.h"

static const whirl_key keys[PADS_TILTING_KEYS] = {
    PADS_KEYS("tilting-4|tilting-5"),
    [PADS_INERTIA] =
        NUMBER_KEY("inertia", "I", "kg m2", REQUIRED, WHIRL_POSITIVE, "moment of inertia of a pad about its pivot"),
    [PADS_SPRING] = NUMBER_KEY("tilt_stiffness", "k", "N m/rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                               "of a pivot against tilting: holds pads whose film carries nothing"),
    [PADS_DAMPER] =
        NUMBER_KEY("tilt_damping", "d", "N m s/rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "of a pivot against tilting"),
};

static whirl_status build(const key_value *values, assembly *to, element *out) {
    return pads_build(values, true, to, out);
}

/// All pads lie alike before a journal in the middle.
static void begin(const element *own, double *states) {
    const double *pad = own->number + PADS_FIRST;
    const pad_table_key key = pad_table_key_of(pad[PAD_TABLE]);
    const double lead = atan2(pad[PAD_ALONG_X], pad[PAD_ALONG_Y]);
    const whirl_pad alone = {
        .arc = key.arc, .offset = 0.5 - lead / key.arc, .preload = hypot(pad[PAD_SHIFT_X], pad[PAD_SHIFT_Y])};
    const double tilt = pad_centred_tilt(&alone, key.ratio, key.law == CAVITATION_GUMBEL);
    for (size_t p = 0; p < own->states / 2; p++) states[2 * p] = tilt;
}

KERNELS_OF_EVERY_ISA(tilting_pad_kernels);

const element_type tilting_pad_element = {
    .group = {"tilting_pad", "a journal bearing of pads that tilt", "Lund 1964; Parsell, Allaire, Barrett 1983", keys,
              PADS_TILTING_KEYS, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .kernels = kernels,
    .build = build,
    .begin = begin,
    .carries = true,
    .bearing_clearance = pads_clearance,
    .note = pads_note,
    .doubt = pads_doubt,
};
#endif
