// A seat that can lift (a loose pedestal): a spring and damper along one axis, whose force has two or three slopes.
#define KERNEL_FILE "elements/contacts/looseness_kernel.h"
#define KERNEL_AXES 1
#define KERNEL_STATES 0
#define KERNEL_NUMBERS LOOSENESS_NUMBERS
#define KERNEL_SWITCHES 2

enum { SEATED, LOOSE, HELD, PIECES };

/// Numbers in newtons and length scales.
enum {
    LOOSENESS_STIFFNESS,
    LOOSENESS_DAMPING = LOOSENESS_STIFFNESS + PIECES,
    LOOSENESS_GAP = LOOSENESS_DAMPING + PIECES,
    LOOSENESS_NUMBERS
};

#include "generic.h"
#include "registry.h"

const element_kernels ISA(looseness_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

enum {
    BETWEEN,
    ALONG,
    STIFFNESS,
    DAMPING,
    LOOSE_STIFFNESS,
    LOOSE_DAMPING,
    GAP,
    HELD_STIFFNESS,
    HELD_DAMPING,
    KEY_COUNT
};

#define STIFFNESS_KEY(name, symbol, required, fallback, meaning)                                                       \
    { name, symbol, "N/m", WHIRL_KEY_NUMBER, required, fallback, WHIRL_NOT_NEGATIVE, NULL, meaning, "", NULL }
#define DAMPING_KEY(name, symbol, fallback, meaning)                                                                   \
    { name, symbol, "N s/m", WHIRL_KEY_NUMBER, false, fallback, WHIRL_NOT_NEGATIVE, NULL, meaning, "", NULL }

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED,
                             "the station that lifts, then the station that it sits on; one may be ground"),
    [ALONG] = CHOICE_KEY("along", DEFAULT("y"), "x|y",
                         "axis of the lift: the first station moves along it, away from the second"),
    [STIFFNESS] = STIFFNESS_KEY("stiffness", "k_1", true, "", "stiffness of the seat, below the position of rest"),
    [DAMPING] = DAMPING_KEY("damping", "c_1", "0", "damping below the position of rest"),
    [LOOSE_STIFFNESS] =
        STIFFNESS_KEY("loose_stiffness", "k_2", false, "0", "stiffness once lifted; 0: nothing holds it"),
    [LOOSE_DAMPING] = DAMPING_KEY("loose_damping", "c_2", "0", "damping once lifted"),
    [GAP] = NUMBER_KEY("gap", "delta", "m", OPTIONAL, WHIRL_POSITIVE,
                       "lift at which a stop holds it from above; absent: no stop"),
    [HELD_STIFFNESS] = STIFFNESS_KEY("held_stiffness", "k_3", false, "", "stiffness beyond the gap; absent: k_1"),
    [HELD_DAMPING] = DAMPING_KEY("held_damping", "c_3", "", "damping beyond the gap; absent: c_1"),
};

/// Gap of seats without an upper stop, which no motion reaches.
static const double NEVER = 0x1p300;

static whirl_status looseness_build(const key_value *values, assembly *to, element *out) {
    const axis along = values[ALONG].choice == 0 ? AXIS_X : AXIS_Y;
    const key_value *stiffness[PIECES] = {&values[STIFFNESS], &values[LOOSE_STIFFNESS], &values[HELD_STIFFNESS]};
    const key_value *damping[PIECES] = {&values[DAMPING], &values[LOOSE_DAMPING], &values[HELD_DAMPING]};
    if (!values[GAP].given && (values[HELD_STIFFNESS].given || values[HELD_DAMPING].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has held_stiffness or held_damping without gap, expected the gap as well");
    if (!values[HELD_STIFFNESS].given) stiffness[HELD] = stiffness[SEATED];
    if (!values[HELD_DAMPING].given) damping[HELD] = damping[SEATED];
    const whirl_status status = element_between(&values[BETWEEN], to, &along, 1, out);
    if (status.code != WHIRL_OK) return status;
    for (int piece = 0; piece < PIECES; piece++) {
        out->number[LOOSENESS_STIFFNESS + piece] = stiffness[piece]->number * to->length;
        out->number[LOOSENESS_DAMPING + piece] = damping[piece]->number * to->length * to->clock;
    }
    out->number[LOOSENESS_GAP] = values[GAP].given ? values[GAP].number / to->length : NEVER;
    // The force jumps at a switch with different dampings on its sides.
    out->law = damping[SEATED]->number != damping[LOOSE]->number ||
               (values[GAP].given && damping[LOOSE]->number != damping[HELD]->number);
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

static bool looseness_jumps(const element *own) {
    return own->law != 0;
}

KERNELS_OF_EVERY_ISA(looseness_kernels);

const element_type looseness_element = {
    .group = {"looseness", "a seat that can lift: along one axis a spring and damper with two or three slopes",
              "Chu, Tang 2001; Ma et al. 2011", keys, KEY_COUNT, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .kernels = kernels,
    .build = looseness_build,
    .jumps = looseness_jumps,
    GENERIC_SWITCHES,
};
#endif
