// A journal bearing of fixed pads: two grooves, lobes, halves.
#define KERNEL_FILE "elements/films/pads_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 0
#define KERNEL_NUMBERS PADS_NUMBERS
#define KERNEL_SWITCHES 0

#include "elements/films/pads_look_up.h"
#include "generic.h"
#include "pads_build.h"
#include "registry.h"

const element_kernels ISA(pad_bearing_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

static const whirl_key keys[PADS_FIXED_KEYS] = {PADS_KEYS("two-groove|elliptical|three-lobe|four-lobe|offset-half")};

static whirl_status build(const key_value *values, assembly *to, element *out) {
    return pads_build(values, false, to, out);
}

KERNELS_OF_EVERY_ISA(pad_bearing_kernels);

const element_type pad_bearing_element = {
    .group = {"pad_bearing", "a journal bearing of fixed pads of finite length, no pressure in its grooves",
              "Reynolds 1886; Swift 1932; Stieber 1933", keys, PADS_FIXED_KEYS, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .kernels = kernels,
    .build = build,
    .carries = true,
    .bearing_clearance = pads_clearance,
    .note = pads_note,
    .doubt = pads_doubt,
};
#endif
