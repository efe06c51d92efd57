// A cracked shaft that breathes by its weight: its keys, and the numbers of its kernel.
#define KERNEL_FILE "elements/shafts/crack_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 0
#define KERNEL_NUMBERS CRACK_NUMBERS
#define KERNEL_SWITCHES 0
#define KERNEL_PHASED 1

#include "crack_parts.h"
#include "elements/loads/harmonic.h"
#include "generic.h"
#include "registry.h"

const element_kernels ISA(crack_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

enum { BETWEEN, STIFFNESS, LOSS, LOSS_ACROSS, ANGLE, OPENS, LAW, TERMS, KEY_COUNT };
enum { LAW_COSINE, LAW_SQUARE };

#define PART                                                                                                           \
    { 0.0, 1.0, false, false }

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED, "the two stations that it joins; one may be ground"),
    [STIFFNESS] =
        NUMBER_KEY("stiffness", "k", "N/m", REQUIRED, WHIRL_NOT_NEGATIVE, "stiffness while the crack is closed"),
    [LOSS] = CITED_NUMBER_KEY("loss", "d1", "1", REQUIRED, PART,
                              "part of the stiffness along the crack's direction that is lost while it is open",
                              "Gasch 1993"),
    [LOSS_ACROSS] =
        CITED_NUMBER_KEY("loss_across", "d2", "1", DEFAULT("0"), PART,
                         "part of the stiffness across the crack that is lost while it is open", "Gasch 1993"),
    [ANGLE] = ANGLE_KEY("angle", "beta", NULL, "direction of the crack at t = 0, from the x axis towards y"),
    [OPENS] =
        NUMBER_KEY("opens", "", "rad", DEFAULT("-1.5707963267948966"), WHIRL_ANY,
                   "direction of the static load, which opens a crack in this direction; absent: down, against y"),
    [LAW] =
        CITED_CHOICE_KEY("law", DEFAULT("cosine"), "cosine|square",
                         "cosine: opens and closes gently; square: switches, as the first terms of its Fourier series",
                         "Mayes & Davies 1984; Gasch 1993"),
    [TERMS] = WHOLE_KEY("terms", "n", DEFAULT("18"), WHIRL_FROM_TO(1, 100),
                        "terms of the square wave, of the orders 1, 3, ... 2n - 1"),
};

/// Turns the crack with the shaft of its stations if that has another speed than the rotor: its phase is then a state,
/// as that of an unbalance there.
static whirl_status crack_turn(const key_value *at, const assembly *to, element *out) {
    const size_t first = at->station[at->station[0] == GROUND], last = at->station[at->station[1] != GROUND];
    const assembly_station *one = &to->stations[first], *other = &to->stations[last];
    if (one->ratio != other->ratio || one->spool != other->spool)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "joins stations '%s' and '%s', whose shafts turn at speeds of their own, expected one shaft",
                          one->name, other->name);
    if (!assembly_is_aside(to, first)) return whirl_ok();
    const whirl_status status = harmonic_check_rate(to, one->ratio);
    out->type = &crack_turning;
    out->spool = one->spool;
    out->number[CRACK_RATE] = one->ratio * to->turn;
    return status;
}

static whirl_status crack_build(const key_value *values, assembly *to, element *out) {
    static const axis axes[KERNEL_AXES] = {AXIS_X, AXIS_Y};
    const double stiffness = values[STIFFNESS].number * to->length;
    const double loss = values[LOSS].number, across = values[LOSS_ACROSS].number;
    const double angle = values[ANGLE].number;
    const bool square = values[LAW].choice == LAW_SQUARE;
    if (values[TERMS].given && !square)
        return whirl_fail(WHIRL_BAD_INPUT, "has terms, which only law square uses, expected law: square, or no terms");
    whirl_status status = element_beside_none(&values[BETWEEN], to);
    if (status.code == WHIRL_OK) status = element_between(&values[BETWEEN], to, axes, KERNEL_AXES, out);
    if (status.code != WHIRL_OK) return status;
    status = crack_turn(&values[BETWEEN], to, out);
    if (status.code != WHIRL_OK) return status;
    out->law = square ? (int)values[TERMS].number : 0;
    out->number[CRACK_STIFFNESS] = stiffness;
    out->number[CRACK_MEAN_LOSS] = stiffness * 0.5 * (loss + across);
    out->number[CRACK_HALF_LOSS] = stiffness * 0.5 * (loss - across);
    out->number[CRACK_AXIS_COS] = cos(2.0 * angle);
    out->number[CRACK_AXIS_SIN] = sin(2.0 * angle);
    out->number[CRACK_LOAD_COS] = cos(angle - values[OPENS].number);
    out->number[CRACK_LOAD_SIN] = sin(angle - values[OPENS].number);
    if (out->type == &crack_turning)
        crack_turning_scale(out, to);
    else
        generic_scale(out, to, 1.0);
    return whirl_ok();
}

KERNELS_OF_EVERY_ISA(crack_kernels);

const element_type crack_element = {
    .group = {"crack", "a massless shaft with a crack that opens and closes as its weight turns past it",
              "Mayes & Davies 1984; Gasch 1993", keys, KEY_COUNT, NULL, NULL},
    .spun = true,
    .follows = true,
    .variant = &crack_turning,
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .modulated = true,
    .kernels = kernels,
    .build = crack_build,
    .range = crack_range,
};
#endif
