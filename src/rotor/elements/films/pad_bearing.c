// A journal bearing with fixed pads: two grooves, lobes, halves.
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
#include "elements/films/pads_drag.h"
#include "elements/films/pads_gap.h"

/// Returns the least film thickness over all pads with the journal at a place, in units of the pads' clearance.
static double thinnest(const element *own, const double journal[2]) {
    double least = INFINITY;
    for (size_t p = 0; p < (size_t)own->law; p++) {
        const double *pad = own->number + PADS_FIRST + p * PAD_NUMBERS;
        double at[2];
        pads_in_frame(pad, journal, at);
        least = fmin(least, pads_thinnest(pad, at[0], at[1]));
    }
    return least;
}

/// Implements element_type.film.
static void pad_bearing_film(const element *own, const double *q, const double *states, element_film *out) {
    const double unit = 1.0 / own->number[PADS_OVER_CLEARANCE];
    double journal[2], free = 0.0, touching = 4.0;
    (void)states;
    pads_journal(own, q, journal);
    const double radius = hypot(journal[0], journal[1]);
    const double along[2] = {radius > 0.0 ? journal[0] / radius : 0.0, radius > 0.0 ? journal[1] / radius : -1.0};
    for (int k = 0; k < 60; k++) {
        const double middle = 0.5 * (free + touching);
        *(thinnest(own, (const double[]){middle * along[0], middle * along[1]}) > 0.0 ? &free : &touching) = middle;
    }
    out->least = unit * thinnest(own, journal);
    out->wall = unit * free;
}

static const whirl_key keys[PADS_FIXED_KEYS] = {PADS_KEYS("two-groove|elliptical|three-lobe|four-lobe|offset-half")};

static whirl_status pad_bearing_build(const key_value *values, assembly *to, element *out) {
    return pads_build(values, false, to, out);
}

KERNELS_OF_EVERY_ISA(pad_bearing_kernels);

const element_type pad_bearing_element = {
    .group = {"pad_bearing", "a journal bearing of fixed pads of finite length, no pressure in its grooves",
              "Reynolds 1886; Swift 1932; Stieber 1933", keys, PADS_FIXED_KEYS, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .kernels = kernels,
    .build = pad_bearing_build,
    .carries = true,
    .drag = pads_drag,
    .bearing_clearance = pads_clearance,
    .film = pad_bearing_film,
    .hold = pads_hold,
    .release = pads_release,
    .note = pads_note,
    .doubt = pads_doubt,
};
#endif
