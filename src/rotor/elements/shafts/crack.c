// A cracked shaft that breathes by its weight: its keys, and the numbers of its kernel.
#define KERNEL_FILE "elements/shafts/crack_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 0
#define KERNEL_NUMBERS CRACK_NUMBERS
#define KERNEL_SWITCHES 0
#define KERNEL_PHASED 1

/// Numbers: k, k (d1 + d2)/2 and k (d1 - d2)/2 in newtons per length scale; at tau = 0 cosine and sine of twice the
/// angle of the first axis, and of its angle from the load.
enum {
    CRACK_STIFFNESS,
    CRACK_MEAN_LOSS,
    CRACK_HALF_LOSS,
    CRACK_AXIS_COS,
    CRACK_AXIS_SIN,
    CRACK_LOAD_COS,
    CRACK_LOAD_SIN,
    CRACK_NUMBERS
};

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
    out->law = square ? (int)values[TERMS].number : 0;
    out->number[CRACK_STIFFNESS] = stiffness;
    out->number[CRACK_MEAN_LOSS] = stiffness * 0.5 * (loss + across);
    out->number[CRACK_HALF_LOSS] = stiffness * 0.5 * (loss - across);
    out->number[CRACK_AXIS_COS] = cos(2.0 * angle);
    out->number[CRACK_AXIS_SIN] = sin(2.0 * angle);
    out->number[CRACK_LOAD_COS] = cos(angle - values[OPENS].number);
    out->number[CRACK_LOAD_SIN] = sin(angle - values[OPENS].number);
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

/// Describes the range of the law, for a shaft end held by the ground: the weight alone must decide whether the crack
/// is open.
static bool crack_range(const element *own, size_t index, const element_seen *seen, element_range *out) {
    double sag[KERNEL_AXES], swing[KERNEL_AXES];
    (void)own;
    for (int a = 0; a < KERNEL_AXES; a++) {
        sag[a] = 0.5 * (seen->low[a] + seen->high[a] + seen->low[KERNEL_AXES + a] + seen->high[KERNEL_AXES + a]);
        swing[a] = 0.5 * (seen->high[a] - seen->low[a] + seen->high[KERNEL_AXES + a] - seen->low[KERNEL_AXES + a]);
    }
    const double reached = hypot(swing[0], swing[1]) / hypot(sag[0], sag[1]);
    *out = (element_range){"vibration over sag", "1", "at which it no longer opens by its weight alone", 1.0, reached};
    if (isnan(seen->radius)) out->reached = NAN;
    return index == 0;
}

KERNELS_OF_EVERY_ISA(crack_kernels);

const element_type crack_element = {
    .group = {"crack", "a massless shaft with a crack that opens and closes as its weight turns past it",
              "Mayes & Davies 1984; Gasch 1993", keys, KEY_COUNT, NULL, NULL},
    .spun = true,
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .modulated = true,
    .kernels = kernels,
    .build = crack_build,
    .range = crack_range,
};
#endif
