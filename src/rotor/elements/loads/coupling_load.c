// Reactions of a flexible coupling on the ends of two misaligned shafts, after Gibbons.
#define KERNEL_FILE "elements/loads/coupling_load_kernel.h"
#define KERNEL_AXES 4
#define KERNEL_STATES 0
#define KERNEL_NUMBERS REACTION_NUMBERS
#define KERNEL_SWITCHES 0
#define KERNEL_PHASED 1

enum { MAX_ORDERS = 8 };

/// Numbers: the coefficients of the time function (constant, of cos tau, of sin tau, of cos 2 tau, ...); then, in SI,
/// FX and FY on the driving shaft, and MX and MY on both shafts.
enum { REACTION_PARTS, REACTION_FORCES = 2 * MAX_ORDERS + 1, REACTION_NUMBERS = REACTION_FORCES + 6 };

#include "generic.h"
#include "registry.h"

const element_kernels ISA(coupling_load_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>
#include <stdio.h>

enum { BETWEEN, DISTANCE, X1, Y1, X2, Y2, STIFFNESS, TORQUE, ORDERS, PHASE, KEY_COUNT };

#define OFFSET(name, symbol, meaning)                                                                                  \
    CITED_NUMBER_KEY(name, symbol, "m", DEFAULT("0"), WHIRL_ANY, meaning, "Gibbons 1976")

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED, "the ends of the driving and of the driven shaft; they tilt"),
    [DISTANCE] = CITED_NUMBER_KEY("distance", "Z", "m", REQUIRED, WHIRL_POSITIVE,
                                  "distance of the two planes in which the coupling bends", "Gibbons 1976"),
    [X1] = OFFSET("x1", "dX_1", "offset along x of the far plane from the axis of the driving shaft"),
    [Y1] = OFFSET("y1", "dY_1", "offset along y of the far plane from the axis of the driving shaft"),
    [X2] = OFFSET("x2", "dX_2", "offset along x of the far plane from the axis of the driven shaft"),
    [Y2] = OFFSET("y2", "dY_2", "offset along y of the far plane from the axis of the driven shaft"),
    [STIFFNESS] = CITED_NUMBER_KEY("bending_stiffness", "K_b", "N m/rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                                   "moment of one plane over its angle", "Gibbons 1976"),
    [TORQUE] =
        NUMBER_KEY("torque", "T", "N m", DEFAULT("0"), WHIRL_ANY, "torque that it transmits, along the rotation"),
    [ORDERS] = CITED_NUMBERS_KEY("orders", "", "1", DEFAULT("1"), WHIRL_ANY,
                                 "parts of the reactions that are constant, that come once a turn, twice a turn, ...; "
                                 "1 alone: all are constant, as in the derivation",
                                 "Sekhar, Prabhu 1995"),
    [PHASE] = ANGLE_KEY("phase", "", "orders",
                        "phase of the orders from the first on at t = 0: part n varies as cos n (tau + phase)"),
};

static whirl_status coupling_load_check(const key_value *values) {
    for (int key = X1; key <= Y2; key++)
        if (!(fabs(values[key].number) < values[DISTANCE].number))
            return whirl_fail(WHIRL_BAD_INPUT, "has %s of %g m at a distance of %g m, expected less", keys[key].name,
                              values[key].number, values[DISTANCE].number);
    if (values[BETWEEN].station[0] == GROUND || values[BETWEEN].station[1] == GROUND)
        return whirl_fail(WHIRL_BAD_INPUT, "joins the ground, expected two stations");
    if (values[ORDERS].count > MAX_ORDERS + 1)
        return whirl_fail(WHIRL_BAD_INPUT, "has orders up to %zu, expected at most %d", values[ORDERS].count - 1,
                          MAX_ORDERS);
    return whirl_ok();
}

/// Computes FX, FY, MX and MY on the driving shaft, then MX and MY on the driven shaft, with the signs of Gibbons.
static void gibbons(const key_value *values, double torque, double out[6]) {
    const double z = values[DISTANCE].number, k = values[STIFFNESS].number;
    const double theta[2] = {asin(values[X1].number / z), asin(values[X2].number / z)};
    const double phi[2] = {asin(values[Y1].number / z), asin(values[Y2].number / z)};
    for (int i = 0; i < 2; i++) {
        const double bending = i == 0 ? k : -k;
        out[2 + 2 * i] = torque * sin(theta[i]) + bending * phi[i];
        out[3 + 2 * i] = torque * sin(phi[i]) - bending * theta[i];
    }
    out[0] = -(out[3] + out[5]) / z;
    out[1] = (out[2] + out[4]) / z;
}

/// Writes c_0, then c_n cos(n phase) and -c_n sin(n phase), which are 0 for a shaft that stands still. For clockwise
/// rotation tau is negative.
static int fill_orders(const key_value *values, double phase, bool stands, double *number) {
    const key_value *orders = &values[ORDERS];
    const size_t count = orders->count > 0 ? orders->count : 1;
    const double *part = orders->count > 0 ? orders->list : &orders->number;
    number[0] = part[0];
    for (size_t n = 1; n < count; n++) {
        number[2 * n - 1] = stands ? 0.0 : part[n] * cos((double)n * phase);
        number[2 * n] = stands ? 0.0 : -part[n] * sin((double)n * phase);
    }
    return (int)count - 1;
}

/// Builds the element. Its forces balance the moments that bend coupling and shafts. z is from the driving to the
/// driven shaft; MX turns dy/dz, and -MY turns dx/dz.
static whirl_status coupling_load_build(const key_value *values, assembly *to, element *out) {
    static const axis axes[] = {AXIS_X, AXIS_Y, AXIS_TILT_X, AXIS_TILT_Y};
    whirl_status status = coupling_load_check(values);
    if (status.code == WHIRL_OK) status = element_between(&values[BETWEEN], to, axes, KERNEL_AXES, out);
    if (status.code != WHIRL_OK) return status;
    double *force = out->number + REACTION_FORCES;
    const double way = copysign(1.0, to->turn);
    gibbons(values, way * values[TORQUE].number, force);
    out->law = fill_orders(values, way * values[PHASE].number, assembly_stands(to), out->number + REACTION_PARTS);
    // The kernel applies the forces on the second places with the opposite sign.
    const double on[KERNEL_PORTS] = {force[0], force[1], -force[3], force[2], force[0], force[1], force[5], -force[4]};
    generic_scale(out, to, 1.0);
    for (size_t port = 0; port < KERNEL_PORTS; port++) out->number[KERNEL_NUMBERS + port] *= on[port];
    return status;
}

/// Returns the last of its orders if that exceeds 1.
static bool coupling_load_named_order(const element *own, size_t index, double *order, const char **name) {
    if (index > 0 || own->law < 2) return false;
    *order = own->law;
    *name = "coupl.";
    return true;
}

static void coupling_load_note(const element *own, double length, double clock, char *text, size_t size) {
    const double *of = own->number + REACTION_FORCES;
    (void)length, (void)clock;
    snprintf(
        text, size,
        "reactions FX1 %.12g, FY1 %.12g N and against them FX2, FY2; MX1 %.12g, MY1 %.12g, MX2 %.12g, MY2 %.12g N m",
        of[0], of[1], of[2], of[3], of[4], of[5]);
}

static void coupling_load_doubt(const key_value *values, double speed, const doubt_teller *to) {
    const double most = 0.0873; // sin 5 degrees
    (void)speed;
    for (int key = X1; key <= Y2; key++)
        if (fabs(values[key].number) > most * values[DISTANCE].number)
            doubt_value(to, keys[key].name, "is %.3g times the distance, and flexible couplings bend by a few degrees",
                        fabs(values[key].number) / values[DISTANCE].number);
}

KERNELS_OF_EVERY_ISA(coupling_load_kernels);

const element_type coupling_load_element = {
    .group = {"coupling_load", "reactions of a flexible coupling between two shafts off line",
              "Gibbons 1976; Sekhar, Prabhu 1995", keys, KEY_COUNT, NULL, NULL},
    .spun = true,
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .modulated = true,
    .kernels = kernels,
    .build = coupling_load_build,
    .named_order = coupling_load_named_order,
    .note = coupling_load_note,
    .doubt = coupling_load_doubt,
};
#endif
