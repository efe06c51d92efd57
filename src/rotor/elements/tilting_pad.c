// A journal bearing of pads that tilt, with their tilts as states.
#define KERNEL_FILE "elements/pads_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES (2 * MAX_PADS)
#define KERNEL_FEWER_STATES
#define KERNEL_NUMBERS PADS_NUMBERS
#define KERNEL_SWITCHES 0

#include "elements/pads_look_up.h"
#include "generic.h"
#include "pads_build.h"
#include "registry.h"

const element_kernels ISA(tilting_pad_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

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

/// The force of a pad's film along it on its pivot, before a journal at rest in the middle, at a tilt.
static double along_pad(const kernel_view *view, const vec *pad, double tilt) {
    const vec x = pad[PAD_SHIFT_X] - tilt * pad[PAD_ALONG_X], y = pad[PAD_SHIFT_Y] - tilt * pad[PAD_ALONG_Y];
    vec force[2];
    pads_film_plain(view, pad, x, y, x, y, force);
    return pad[PAD_ALONG_X] * force[0] + pad[PAD_ALONG_Y] * force[1];
}

/// The first tilt at which the film holds a pad: the force along it rises through 0 with the tilt; 0 where none does.
static double held_tilt(const kernel_view *view, const vec *pad) {
    const double widest = 3.0, step = 0.05;
    double low = -widest;
    while (low < widest && !(along_pad(view, pad, low) < 0.0 && along_pad(view, pad, low + step) >= 0.0)) low += step;
    double high = low + step;
    if (low >= widest) return 0.0;
    for (int k = 0; k < 50; k++) {
        const double middle = 0.5 * (low + high);
        *(along_pad(view, pad, middle) < 0.0 ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

static void begin(const element *own, double *states) {
    const kernel_view view = {.stride = 1, .number = own->number};
    for (int p = 0; p < own->law; p++) states[2 * p] = held_tilt(&view, own->number + PADS_FIRST + p * PAD_NUMBERS);
}

KERNELS_OF_EVERY_ISA(tilting_pad_kernels);

const element_type tilting_pad_element = {
    .group = {"tilting_pad", "a journal bearing of pads that tilt", "Lund 1964; Parsell, Allaire, Barrett 1983", keys,
              PADS_TILTING_KEYS, NULL, NULL},
    .spun = true,
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .kernels = kernels,
    .build = build,
    .begin = begin,
    .carries = true,
    .bearing_clearance = pads_clearance,
    .doubt = pads_doubt,
};
#endif
