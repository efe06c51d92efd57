// An unbalance while the speed runs up or down evenly, for designs of programs that use the library. Speed and angle
// are states; the rotor's own speed is only the unit of time.
#define KERNEL_FILE "elements/loads/run_up_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 2
#define KERNEL_NUMBERS RUN_UP_NUMBERS
#define KERNEL_SWITCHES 0

/// Numbers: U omega^2 in newtons; the speed at t = 0 divided by the rotor's speed; the acceleration divided by the
/// square of the rotor's speed; the angle at t = 0.
enum { RUN_UP_SIZE, RUN_UP_SPEED, RUN_UP_ACCELERATION, RUN_UP_ANGLE, RUN_UP_NUMBERS };

#include "generic.h"
#include "harmonic.h"
#include "registry.h"

const element_kernels ISA(run_up_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include "whirl/engine/rotor.h"

enum { AT, MOMENT, ANGLE, SPEED, ACCELERATION, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    UNBALANCE_KEYS,
    [SPEED] = NUMBER_KEY("speed", "", "rad/s", DEFAULT("0"), WHIRL_ANY, "at t = 0"),
    [ACCELERATION] =
        CITED_NUMBER_KEY("acceleration", "alpha", "rad/s2", REQUIRED, WHIRL_ANY,
                         "angular acceleration of the rotation; against the speed for a run-down", "Lewis 1932"),
};

static whirl_status run_up_build(const key_value *values, assembly *to, element *out) {
    element_on(&values[AT], to, AXIS_X, out);
    out->number[RUN_UP_SIZE] = values[MOMENT].number * to->clock * to->clock;
    out->number[RUN_UP_SPEED] = values[SPEED].number / to->clock;
    out->number[RUN_UP_ACCELERATION] = values[ACCELERATION].number / (to->clock * to->clock);
    out->number[RUN_UP_ANGLE] = values[ANGLE].number;
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

KERNELS_OF_EVERY_ISA(run_up_kernels);

static const element_type run_up_element = {
    .group = {"run_up", "an unbalance while the speed runs up or down evenly", "Lewis 1932", keys, KEY_COUNT, NULL,
              NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .turning = 1,
    .kernels = kernels,
    .build = run_up_build,
};

const whirl_element_type *whirl_run_up_type(void) {
    return &run_up_element;
}
#endif
