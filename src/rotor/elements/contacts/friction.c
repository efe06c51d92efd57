// Dry friction between two stations, or between a station and the ground: a force of constant size against their
// sliding.
#define KERNEL_FILE "elements/contacts/friction_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 0
#define KERNEL_NUMBERS FRICTION_NUMBERS
#define KERNEL_SWITCHES 1
#define KERNEL_TILTS

/// Numbers: the force in newtons, and the square of the smoothing speed in length scales by tau. For tilts: the moment
/// in N m, and the square of the smoothing speed in units of the first tilt by tau.
enum { FRICTION_FORCE, FRICTION_SLIP_SQUARE, FRICTION_NUMBERS };
enum { FRICTION_SMOOTH, FRICTION_SHARP };

#include "elements/along.h"
#include "generic.h"
#include "registry.h"

const element_kernels ISA(friction_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

enum { BETWEEN, ALONG, FORCE, MOMENT, SLIP_SPEED, SLIP_RATE, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED, "the two stations that slide on each other; one may be ground"),
    [ALONG] = ALONG_KEY,
    [FORCE] = CITED_NUMBER_KEY("force", "F", "N", OPTIONAL, WHIRL_NOT_NEGATIVE,
                               "force against the sliding, independent of its speed; required except along tilts",
                               "Coulomb 1785; den Hartog 1931"),
    [MOMENT] = NUMBER_KEY("moment", "M", "N m", OPTIONAL, WHIRL_NOT_NEGATIVE,
                          "moment against the sliding along tilts or twist, in place of force"),
    [SLIP_SPEED] = NUMBER_KEY("slip_speed", "v_0", "m/s", OPTIONAL, WHIRL_POSITIVE,
                              "friction grows as v/sqrt(v^2 + v_0^2); absent: sharp, with motions that stick; required "
                              "along xy, where friction points against the velocity"),
    [SLIP_RATE] = NUMBER_KEY("slip_rate", "", "rad/s", OPTIONAL, WHIRL_POSITIVE,
                             "v_0 along tilts or twist, in place of slip_speed"),
};

static whirl_status friction_check(const key_value *values) {
    static const int in_tilts[KEY_COUNT] = {[MOMENT] = 1, [SLIP_RATE] = 1};
    const int along = values[ALONG].choice, tilts = along_tilts(along);
    for (int key = FORCE; key < KEY_COUNT; key++) {
        const whirl_status status = check_along(&keys[key], &values[key], in_tilts[key], along);
        if (status.code != WHIRL_OK) return status;
    }
    const int size = tilts ? MOMENT : FORCE, slip = tilts ? SLIP_RATE : SLIP_SPEED;
    if (!values[size].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has no %s, expected one in %s", keys[size].name, keys[size].unit);
    if ((along == ALONG_XY || along == ALONG_TILTS) && !values[slip].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has no %s, expected one along two axes, where friction is not sharp",
                          keys[slip].name);
    return whirl_ok();
}

static whirl_status friction_build(const key_value *values, assembly *to, element *out) {
    const int along = values[ALONG].choice, tilts = along_tilts(along);
    const axis first = axes_along[along][0] == AXES ? axes_along[along][1] : axes_along[along][0];
    const axis axes[KERNEL_AXES] = {first, along == ALONG_XY || along == ALONG_TILTS ? axes_along[along][1] : AXES};
    whirl_status status = friction_check(values);
    if (status.code == WHIRL_OK) status = element_between(&values[BETWEEN], to, axes, KERNEL_AXES, out);
    if (status.code != WHIRL_OK) return status;
    const key_value *slip = &values[tilts ? SLIP_RATE : SLIP_SPEED];
    const double smooth = slip->number / (generic_tilts(out, to) * to->clock);
    out->law = slip->given ? FRICTION_SMOOTH : FRICTION_SHARP;
    out->number[FRICTION_FORCE] = values[tilts ? MOMENT : FORCE].number;
    out->number[FRICTION_SLIP_SQUARE] = smooth * smooth;
    return whirl_ok();
}

/// Returns false: at this switch sliding reverses, and no contact begins.
static bool friction_touches(const element *own, size_t index) {
    (void)own, (void)index;
    return false;
}

static bool sharp(const element *own) {
    return own->law == FRICTION_SHARP;
}

KERNELS_OF_EVERY_ISA(friction_kernels);

const element_type friction_element = {
    .group = {"friction", "dry friction between two stations or a station and the ground, with stick and slip",
              "den Hartog 1931", keys, KEY_COUNT, NULL, NULL},
    .number_count = KERNEL_NUMBERS + 2 * KERNEL_PORTS,
    .kernels = kernels,
    .build = friction_build,
    GENERIC_SWITCHES,
    .touches = friction_touches,
    .slides = sharp,
    .jumps = sharp,
};
#endif
