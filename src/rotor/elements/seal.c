// An annular seal with a turning fluid: its keys and the numbers of its kernel.
#define KERNEL_FILE "elements/seal_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 0
#define KERNEL_NUMBERS SEAL_NUMBERS
#define KERNEL_SWITCHES 0

/// K_0, D_0, m_f in newtons per length scale and radian; 1/c^2 in length scales; lambda_0 by tau, n and b.
enum {
    SEAL_STIFFNESS,
    SEAL_DAMPING,
    SEAL_MASS,
    SEAL_OVER_CLEARANCE_SQUARE,
    SEAL_RATIO,
    SEAL_GROWTH,
    SEAL_SLOWING,
    SEAL_NUMBERS
};

#include "generic.h"
#include "registry.h"

const element_kernels ISA(seal_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

enum { AT, FROM, CLEARANCE, STIFFNESS, DAMPING, MASS, RATIO, GROWTH, SLOWING, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station in the seal"),
    [FROM] = STATION_KEY("from", OPTIONAL, "station of its housing; the ground where absent"),
    [CLEARANCE] = NUMBER_KEY("clearance", "c", "m", REQUIRED, WHIRL_POSITIVE, "radial clearance"),
    [STIFFNESS] = NUMBER_KEY("stiffness", "K_0", "N/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "stiffness in the middle"),
    [DAMPING] = NUMBER_KEY("damping", "D_0", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                           "damping in the middle, of the motion against the turning fluid"),
    [MASS] = NUMBER_KEY("mass", "m_f", "kg", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                        "mass of the fluid that moves with the station"),
    [RATIO] = CITED_NUMBER_KEY(
        "ratio", "lambda_0", "1", REQUIRED, WHIRL_NOT_NEGATIVE,
        "mean speed of the turning fluid over that of the shaft, in the middle; below 0.5 as a rule", "Muszynska 1988"),
    [GROWTH] = CITED_NUMBER_KEY(
        "growth", "n", "1", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
        "power by which stiffness and damping grow with the eccentricity ratio e, as (1 - e^2)^-n", "Muszynska 1988"),
    [SLOWING] = CITED_NUMBER_KEY("slowing", "b", "1", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                                 "power by which the fluid slows down with it, as (1 - e)^b", "Muszynska 1988"),
};

static whirl_status inertia(const key_value *values, assembly *to) {
    if (!values[FROM].given) to->stations[values[AT].station[0]].fluid += values[MASS].number;
    return whirl_ok();
}

static whirl_status build(const key_value *values, assembly *to, element *out) {
    const double clearance = values[CLEARANCE].number / to->length;
    const whirl_status status = element_in_housing(&values[AT], &values[FROM], to, out);
    if (status.code != WHIRL_OK) return status;
    for (size_t a = 0; a < KERNEL_AXES && values[FROM].given; a++)
        assembly_inerter(to, out->port[a], out->port[KERNEL_AXES + a], values[MASS].number);
    out->number[SEAL_STIFFNESS] = values[STIFFNESS].number * to->length;
    out->number[SEAL_DAMPING] = values[DAMPING].number * to->clock * to->length;
    out->number[SEAL_MASS] = values[MASS].number * to->clock * to->clock * to->length;
    out->number[SEAL_OVER_CLEARANCE_SQUARE] = 1.0 / (clearance * clearance);
    out->number[SEAL_RATIO] = values[RATIO].number * to->turn;
    out->number[SEAL_GROWTH] = values[GROWTH].number;
    out->number[SEAL_SLOWING] = values[SLOWING].number;
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

/// Beyond what was measured (theory.md, "Annular seal").
static void doubt(const key_value *values, double speed, const doubt_teller *to) {
    static const struct {
        int key;
        double most;
    } known[] = {{RATIO, 0.5}, {GROWTH, 3.0}, {SLOWING, 1.0}};
    (void)speed;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (values[known[i].key].number > known[i].most)
            doubt_value(to, keys[known[i].key].name, "is %g, and seals have up to %g as a rule",
                        values[known[i].key].number, known[i].most);
}

static double bearing_clearance(const element *own) {
    return own->port[KERNEL_AXES] == NO_COORDINATE ? 1.0 / sqrt(own->number[SEAL_OVER_CLEARANCE_SQUARE]) : 0.0;
}

KERNELS_OF_EVERY_ISA(seal_kernels);

const element_type seal_element = {
    .group = {"seal", "an annular seal or lightly loaded bearing whose fluid turns with the shaft",
              "Muszynska 1988; Bently & Muszynska 1988", keys, KEY_COUNT, NULL, NULL},
    .spun = true,
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .kernels = kernels,
    .inertia = inertia,
    .build = build,
    .drags = true,
    .bearing_clearance = bearing_clearance,
    .doubt = doubt,
};
#endif
