// A floating ring between a journal and its housing.
#define KERNEL_FILE "elements/films/floating_ring_kernel.h"
#define KERNEL_AXES 4 // x and y of the journal from the ring, of the ring from the housing
#define KERNEL_STATES 1
#define KERNEL_NUMBERS RING_NUMBERS
#define KERNEL_SWITCHES 0

/// Numbers: the shaft's speed divided by the clock; the ring's speed with journal and ring centred; for each film 1
/// divided by the clearance in length scales, the scale of the force in newtons, and the angular acceleration of the
/// ring (by tau) by its drag. The unit of its state is the inner clearance in length scales, so that distances of
/// states do not depend on the length scale.
enum {
    RING_TURN,
    RING_SPEED,
    RING_STATE_UNIT,
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
#include "oil.h"
#include "registry.h"

const element_kernels ISA(floating_ring_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum {
    AT,
    RING,
    FROM,
    INERTIA,
    CLEARANCE,
    RADIUS,
    LENGTH,
    OIL,
    OUTER_CLEARANCE = OIL + OIL_KEYS,
    OUTER_RADIUS,
    OUTER_LENGTH,
    OUTER_VISCOSITY,
    OUTER_KINEMATIC,
    KEY_COUNT
};

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station of the journal"),
    [RING] = STATION_KEY("ring", REQUIRED, "station of the ring, with its mass"),
    [FROM] = STATION_KEY("from", OPTIONAL, "station of the housing; absent: the ground"),
    [INERTIA] = NUMBER_KEY("inertia", "J", "kg m2", REQUIRED, WHIRL_POSITIVE, "polar moment of inertia of the ring"),
    [CLEARANCE] = NUMBER_KEY("clearance", "c_i", "m", REQUIRED, WHIRL_POSITIVE, "radial clearance of the inner film"),
    [RADIUS] = NUMBER_KEY("radius", "R_i", "m", REQUIRED, WHIRL_POSITIVE, "radius of the inner film"),
    [LENGTH] = NUMBER_KEY("length", "L_i", "m", REQUIRED, WHIRL_POSITIVE, "length of the inner film"),
    OIL_ROWS(OIL, "dynamic viscosity of the oil of the inner film; required without kinematic_viscosity"),
    [OUTER_CLEARANCE] =
        NUMBER_KEY("outer_clearance", "c_o", "m", REQUIRED, WHIRL_POSITIVE, "radial clearance of the outer film"),
    [OUTER_RADIUS] = NUMBER_KEY("outer_radius", "R_o", "m", REQUIRED, WHIRL_POSITIVE, "radius of the outer film"),
    [OUTER_LENGTH] = NUMBER_KEY("outer_length", "L_o", "m", REQUIRED, WHIRL_POSITIVE, "length of the outer film"),
    [OUTER_VISCOSITY] = NUMBER_KEY("outer_viscosity", "mu_o", "Pa s", OPTIONAL, WHIRL_POSITIVE,
                                   "dynamic viscosity of the oil of the outer film; absent: as in the inner film"),
    [OUTER_KINEMATIC] =
        NUMBER_KEY("outer_kinematic_viscosity", "nu_o", "m2/s", OPTIONAL, WHIRL_POSITIVE,
                   "kinematic viscosity of the oil of the outer film, in place of outer_viscosity, with its density"),
};

typedef struct ring_side {
    double clearance, radius, length, viscosity;
} ring_side;

static whirl_status find_sides(const key_value *values, ring_side *inner, ring_side *outer) {
    const oil within = {&values[OIL]};
    const key_value *density = &values[OIL + OIL_DENSITY], *dynamic = &values[OUTER_VISCOSITY];
    const key_value *kinematic = &values[OUTER_KINEMATIC];
    *inner = (ring_side){values[CLEARANCE].number, values[RADIUS].number, values[LENGTH].number, 0.0};
    *outer = (ring_side){values[OUTER_CLEARANCE].number, values[OUTER_RADIUS].number, values[OUTER_LENGTH].number, 0.0};
    if (dynamic->given && kinematic->given)
        return whirl_fail(WHIRL_BAD_INPUT, "has both %s and %s, expected one of them", keys[OUTER_VISCOSITY].name,
                          keys[OUTER_KINEMATIC].name);
    if (kinematic->given && !density->given)
        return whirl_fail(WHIRL_BAD_INPUT, "has %s without a density, expected that of the oil, too",
                          keys[OUTER_KINEMATIC].name);
    const whirl_status status = oil_viscosity(&within, &inner->viscosity);
    outer->viscosity = dynamic->given     ? dynamic->number
                       : kinematic->given ? kinematic->number * density->number
                                          : inner->viscosity;
    return status;
}

/// Returns the drag of a film divided by the difference of its sides' speeds, N m s.
static double drag_of(const ring_side *of) {
    return 6.28318530717958647692 * of->viscosity * of->radius * of->radius * of->radius * of->length / of->clearance;
}

/// Writes the three numbers of a film.
static void build_side(const ring_side *of, double inertia, const assembly *to, double *first) {
    const double size = of->viscosity * to->clock * of->radius * of->length * of->length * of->length;
    first[0] = to->length / of->clearance;
    first[1] = size / (4.0 * of->clearance * of->clearance);
    first[2] = drag_of(of) / (inertia * to->clock);
}

static whirl_status floating_ring_build(const key_value *values, assembly *to, element *out) {
    ring_side inner, outer;
    const double own = to->stations[values[AT].station[0]].ratio;
    element around = *out;
    if (values[RING].station[0] == values[AT].station[0])
        return whirl_fail(WHIRL_BAD_INPUT, "has journal and ring at one station, expected two");
    whirl_status status = find_sides(values, &inner, &outer);
    if (status.code == WHIRL_OK) status = element_in_housing(&values[AT], &values[RING], to, out);
    if (status.code == WHIRL_OK) status = element_in_housing(&values[RING], &values[FROM], to, &around);
    if (status.code != WHIRL_OK) return status;
    // The ports are journal and ring, whose difference is the displacement of the first film; then ring and housing.
    for (int a = 0; a < 2; a++) {
        out->port[4 + a] = out->port[2 + a];
        out->port[2 + a] = around.port[a];
        out->port[6 + a] = around.port[2 + a];
    }
    build_side(&inner, values[INERTIA].number, to, out->number + RING_INNER_OVER_CLEARANCE);
    build_side(&outer, values[INERTIA].number, to, out->number + RING_OUTER_OVER_CLEARANCE);
    const double driven = out->number[RING_INNER_DRAG];
    out->number[RING_TURN] = own * to->turn;
    out->number[RING_STATE_UNIT] = inner.clearance / to->length;
    out->number[RING_SPEED] = own * to->turn * driven / (driven + out->number[RING_OUTER_DRAG]);
    out->fluid = (fluid_drag){.shear = drag_of(&inner),
                              .turns = {own, 0.0},
                              .housing = GROUND,
                              .spool = {to->stations[values[AT].station[0]].spool, 0}};
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

/// Raises doubts about both films. The speed of the ring is between those of journal and housing, by the drags of
/// centred films.
static void floating_ring_doubt(const key_value *values, double speed, const doubt_teller *to) {
    ring_side side[2];
    if (find_sides(values, &side[0], &side[1]).code != WHIRL_OK) return;
    const double drag[] = {drag_of(&side[0]), drag_of(&side[1])}, density = values[OIL + OIL_DENSITY].number;
    for (int outer = 0; outer < 2; outer++) {
        const ring_side *of = &side[outer];
        const double shear = fabs(speed) * drag[!outer] / (drag[0] + drag[1]);
        doubt_length(to, keys[outer ? OUTER_LENGTH : LENGTH].name, of->length, of->radius, "");
        doubt_clearance(to, keys[outer ? OUTER_CLEARANCE : CLEARANCE].name, of->clearance, of->radius);
        doubt_flow(to, density * shear * of->radius * of->clearance / of->viscosity, of->radius, of->clearance, false);
    }
}

/// Implements element_type.paced: the state represents the ratio of the ring's speed to the shaft's, which is written
/// in units of the state.
static void floating_ring_paced(const element *own, const double *states, double *out) {
    out[0] = states[0] + own->number[RING_STATE_UNIT] * own->number[RING_SPEED];
}

/// Implements element_type.drag with the inner film alone: the rest of the drag acts on the ring, whose speed is a
/// state.
static void floating_ring_drag(const element *own, const drag_view *in, double torque[2]) {
    const double *number = own->number, sense = copysign(1.0, number[RING_TURN]),
                 over = number[RING_INNER_OVER_CLEARANCE];
    const double ring = over * in->at->s[0] + number[RING_SPEED];
    const double d[2] = {in->at->q[0] - in->at->q[4], in->at->q[1] - in->at->q[5]};
    const double w[2] = {in->at->v[0] - in->at->v[4], in->at->v[1] - in->at->v[5]};
    double force[2], root;
    ring_film_plain(over, number[RING_INNER_STRENGTH], d, w, number[RING_TURN] + ring, force, &root);
    const double slip = in->spin[0] - sense * ring * in->speed;
    const double couple = 0.5 * sense * in->length * (d[0] * force[1] - d[1] * force[0]);
    torque[0] = -own->fluid.shear * slip / root - couple;
    torque[1] = 0.0;
}

static double floating_ring_clearance(const element *own) {
    return 1.0 / own->number[RING_INNER_OVER_CLEARANCE];
}

static double floating_ring_outer_clearance(const element *own) {
    return 1.0 / own->number[RING_OUTER_OVER_CLEARANCE];
}

KERNELS_OF_EVERY_ISA(floating_ring_kernels);

const element_type floating_ring_element = {
    .group = {"floating_ring", "a ring that floats in oil between a journal and its housing", "Capone 1991", keys,
              KEY_COUNT, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .kernels = kernels,
    .build = floating_ring_build,
    .carries = true,
    .drag = floating_ring_drag,
    .paced = floating_ring_paced,
    .bearing_clearance = floating_ring_clearance,
    .ring_clearance = floating_ring_outer_clearance,
    .doubt = floating_ring_doubt,
};
#endif
