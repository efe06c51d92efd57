// A floating ring between a journal and its housing.
#define KERNEL_FILE "elements/films/floating_ring_kernel.h"
#define KERNEL_AXES 4 // x and y of the journal from the ring, of the ring from the housing
#define KERNEL_STATES 1
#define KERNEL_NUMBERS RING_NUMBERS
#define KERNEL_SWITCHES 0

/// The shaft's speed over the clock; the ring's with both in the middle; of both films one over the clearance in length
/// scales, the scale of the force in newtons, and what the drag is of the ring's angular acceleration by tau.
enum {
    RING_TURN,
    RING_SPEED,
    RING_INNER_OVER_CLEARANCE,
    RING_INNER_STRENGTH,
    RING_INNER_DRAG,
    RING_OUTER_OVER_CLEARANCE,
    RING_OUTER_STRENGTH,
    RING_OUTER_DRAG,
    RING_NUMBERS
};

#include "doubts.h"
#include "generic.h"
#include "registry.h"

const element_kernels ISA(floating_ring_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

enum {
    AT,
    RING,
    FROM,
    INERTIA,
    CLEARANCE,
    RADIUS,
    LENGTH,
    VISCOSITY,
    OUTER_CLEARANCE,
    OUTER_RADIUS,
    OUTER_LENGTH,
    OUTER_VISCOSITY,
    KEY_COUNT
};

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station of the journal"),
    [RING] = STATION_KEY("ring", REQUIRED, "station of the ring, with its mass"),
    [FROM] = STATION_KEY("from", OPTIONAL, "station of the housing; the ground where absent"),
    [INERTIA] = NUMBER_KEY("inertia", "J", "kg m2", REQUIRED, WHIRL_POSITIVE, "polar moment of inertia of the ring"),
    [CLEARANCE] = NUMBER_KEY("clearance", "c_i", "m", REQUIRED, WHIRL_POSITIVE, "radial clearance of the inner film"),
    [RADIUS] = NUMBER_KEY("radius", "R_i", "m", REQUIRED, WHIRL_POSITIVE, "radius of the inner film"),
    [LENGTH] = NUMBER_KEY("length", "L_i", "m", REQUIRED, WHIRL_POSITIVE, "length of the inner film"),
    [VISCOSITY] = NUMBER_KEY("viscosity", "mu_i", "Pa s", REQUIRED, WHIRL_POSITIVE,
                             "dynamic viscosity of the oil within the ring"),
    [OUTER_CLEARANCE] =
        NUMBER_KEY("outer_clearance", "c_o", "m", REQUIRED, WHIRL_POSITIVE, "radial clearance of the outer film"),
    [OUTER_RADIUS] = NUMBER_KEY("outer_radius", "R_o", "m", REQUIRED, WHIRL_POSITIVE, "radius of the outer film"),
    [OUTER_LENGTH] = NUMBER_KEY("outer_length", "L_o", "m", REQUIRED, WHIRL_POSITIVE, "length of the outer film"),
    [OUTER_VISCOSITY] = NUMBER_KEY("outer_viscosity", "mu_o", "Pa s", OPTIONAL, WHIRL_POSITIVE,
                                   "dynamic viscosity of the oil around it; as within where absent"),
};

typedef struct ring_side {
    double clearance, radius, length, viscosity;
} ring_side;

static ring_side side_of(const key_value *values, bool outer) {
    const double within = values[VISCOSITY].number;
    if (!outer) return (ring_side){values[CLEARANCE].number, values[RADIUS].number, values[LENGTH].number, within};
    return (ring_side){values[OUTER_CLEARANCE].number, values[OUTER_RADIUS].number, values[OUTER_LENGTH].number,
                       values[OUTER_VISCOSITY].given ? values[OUTER_VISCOSITY].number : within};
}

/// Three numbers of a film from `first` on.
static void build_side(const ring_side *of, double inertia, const assembly *to, double *first) {
    const double round = 6.28318530717958647692 * of->radius * of->radius * of->radius * of->length;
    const double size = of->viscosity * to->clock * of->radius * of->length * of->length * of->length;
    first[0] = to->length / of->clearance;
    first[1] = size / (4.0 * of->clearance * of->clearance);
    first[2] = of->viscosity * round / (of->clearance * inertia * to->clock);
}

static whirl_status build(const key_value *values, assembly *to, element *out) {
    const ring_side inner = side_of(values, false), outer = side_of(values, true);
    const double own = to->stations[values[AT].station[0]].ratio;
    element around = *out;
    if (values[RING].station[0] == values[AT].station[0])
        return whirl_fail(WHIRL_BAD_INPUT, "has journal and ring at one station, expected two");
    whirl_status status = element_in_housing(&values[AT], &values[RING], to, out);
    if (status.code == WHIRL_OK) status = element_in_housing(&values[RING], &values[FROM], to, &around);
    if (status.code != WHIRL_OK) return status;
    // Places: of the journal and the ring; from these: of the ring and the housing.
    for (int a = 0; a < 2; a++) {
        out->port[4 + a] = out->port[2 + a];
        out->port[2 + a] = around.port[a];
        out->port[6 + a] = around.port[2 + a];
    }
    build_side(&inner, values[INERTIA].number, to, out->number + RING_INNER_OVER_CLEARANCE);
    build_side(&outer, values[INERTIA].number, to, out->number + RING_OUTER_OVER_CLEARANCE);
    const double driven = out->number[RING_INNER_DRAG];
    out->number[RING_TURN] = own * to->turn;
    out->number[RING_SPEED] = own * to->turn * driven / (driven + out->number[RING_OUTER_DRAG]);
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

static void doubt(const key_value *values, double speed, const doubt_teller *to) {
    (void)speed;
    for (int outer = 0; outer < 2; outer++) {
        const ring_side side = side_of(values, outer);
        doubt_length(to, keys[outer ? OUTER_LENGTH : LENGTH].name, side.length, side.radius, "");
        doubt_clearance(to, keys[outer ? OUTER_CLEARANCE : CLEARANCE].name, side.clearance, side.radius);
    }
}

KERNELS_OF_EVERY_ISA(floating_ring_kernels);

const element_type floating_ring_element = {
    .group = {"floating_ring", "a ring that floats in oil between a journal and its housing", "Capone 1991", keys,
              KEY_COUNT, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .kernels = kernels,
    .build = build,
    .carries = true,
    .doubt = doubt,
};
#endif
