// The keys of a shaft of unequal stiffness, and the numbers of its kernel.
#define VECTOR_ISA 0
#include "shaft_kernel.h"

enum { BETWEEN, K1, K2, SIGNS, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = {"between", "", "", WHIRL_KEY_STATIONS, true, "", WHIRL_ANY, NULL,
                 "the two stations that it joins; one may be ground", ""},
    [K1] = {"k1", "k1", "N/m", WHIRL_KEY_NUMBER, true, "", WHIRL_NOT_NEGATIVE, NULL,
            "stiffness along the first principal axis, which lies along x at t = 0", ""},
    [K2] = {"k2", "k2", "N/m", WHIRL_KEY_NUMBER, false, "", WHIRL_NOT_NEGATIVE, NULL,
            "stiffness along the second principal axis; k1 where absent", ""},
    [SIGNS] = {"signs", "", "", WHIRL_KEY_CHOICE, false, "derived", WHIRL_ANY, "derived|paper",
               "derived: a shaft that turns; paper: the equations of the 2015 paper as printed",
               "Friswell et al. 2010, sec. 7.3; rub-impact paper 2015, eq. (2)"},
};

static whirl_status build(const key_value *values, const scales *scale, element *out) {
    size_t a = values[BETWEEN].station[0], b = values[BETWEEN].station[1];
    if (a == b) return whirl_fail(WHIRL_BAD_INPUT, "between names one station twice, expected two");
    if (a == GROUND) {
        a = b;
        b = GROUND;
    }
    const double k1 = values[K1].number, k2 = values[K2].given ? values[K2].number : k1;
    const double mean = 0.5 * (k1 + k2), half = 0.5 * (k1 - k2);
    const double scale_a = stiffness_scale(scale, a), scale_b = b == GROUND ? INFINITY : stiffness_scale(scale, b);
    out->station[0] = a;
    out->station[1] = b;
    out->law = values[SIGNS].choice;
    out->number[SHAFT_MEAN_A] = mean / scale_a;
    out->number[SHAFT_HALF_A] = half / scale_a;
    out->number[SHAFT_MEAN_B] = mean / scale_b;
    out->number[SHAFT_HALF_B] = half / scale_b;
    return whirl_ok();
}

const element_type shaft_element = {
    .group = {"shaft", "a massless shaft of unequal stiffness between two stations, or from a station to ground",
              "Friswell et al. 2010, sec. 7.3", keys, KEY_COUNT, NULL},
    .kernel = KERNEL_SHAFT,
    .number_count = SHAFT_NUMBERS,
    .build = build,
};
