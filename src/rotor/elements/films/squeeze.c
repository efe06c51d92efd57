// A squeeze film damper, short or long, with half a film (pi) or a full one.
#define KERNEL_FILE "elements/films/squeeze_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 0
#define KERNEL_NUMBERS SQUEEZE_NUMBERS
#define KERNEL_SWITCHES 0

/// Numbers: 1 divided by the clearance in length scales; the scale of the force in newtons.
enum { SQUEEZE_OVER_CLEARANCE, SQUEEZE_STRENGTH, SQUEEZE_NUMBERS };

/// Bits of the law; without them it is the short damper with half a film.
enum { SQUEEZE_LONG = 1, SQUEEZE_FULL = 2 };

#include "doubts.h"
#include "generic.h"
#include "oil.h"
#include "registry.h"

const element_kernels ISA(squeeze_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR

enum { AT, FROM, COUNT, LAW, FILM, CLEARANCE, OIL, RADIUS = OIL + OIL_KEYS, LENGTH, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station of the damper"),
    [FROM] = STATION_KEY("from", OPTIONAL, "station of the housing; absent: the ground"),
    [COUNT] = WHOLE_KEY("count", "", DEFAULT("1"), WHIRL_FROM_TO(1, 1000),
                        "number of equal dampers, or lands of one, at this station"),
    [LAW] = CITED_CHOICE_KEY("law", DEFAULT("short"), "short|long",
                             "short: open ends, oil flows along the axis; long: sealed ends, oil flows around",
                             "Vance, Zeidan, Murphy 2010"),
    [FILM] = CITED_CHOICE_KEY(
        "film", DEFAULT("half"), "half|full",
        "half: no pressure below that of the surroundings (pi film); full: negative pressures, too (2 pi film)",
        "Vance, Zeidan, Murphy 2010"),
    [CLEARANCE] = NUMBER_KEY("clearance", "c", "m", REQUIRED, WHIRL_POSITIVE, "radial clearance"),
    OIL_ROWS(OIL, "dynamic viscosity of the oil; required without kinematic_viscosity"),
    [RADIUS] = NUMBER_KEY("radius", "R", "m", REQUIRED, WHIRL_POSITIVE, "radius of the damper"),
    [LENGTH] = NUMBER_KEY("length", "L", "m", REQUIRED, WHIRL_POSITIVE, "length of the film"),
};

static oil oil_of(const key_value *values) {
    return (oil){&values[OIL]};
}

/// Returns the scale of the force, mu omega R L^3/c^2 or 12 mu omega L R^3/c^2, N.
static double strength(const key_value *values, double viscosity, double speed) {
    const double radius = values[RADIUS].number, length = values[LENGTH].number, clearance = values[CLEARANCE].number;
    const double shape = values[LAW].choice ? 12.0 * radius * radius : length * length;
    return values[COUNT].number * viscosity * speed * radius * length * shape / (clearance * clearance);
}

static whirl_status squeeze_build(const key_value *values, assembly *to, element *out) {
    out->law = (values[LAW].choice ? SQUEEZE_LONG : 0) | (values[FILM].choice ? SQUEEZE_FULL : 0);
    double viscosity;
    const oil own = oil_of(values);
    whirl_status status = oil_viscosity(&own, &viscosity);
    if (status.code == WHIRL_OK) status = element_in_housing(&values[AT], &values[FROM], to, out);
    if (status.code != WHIRL_OK) return status;
    out->number[SQUEEZE_OVER_CLEARANCE] = to->length / values[CLEARANCE].number;
    out->number[SQUEEZE_STRENGTH] = strength(values, viscosity, to->clock);
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

/// Raises doubts about the values. The long law, with sealed ends, holds for any length.
static void squeeze_doubt(const key_value *values, double speed, const doubt_teller *to) {
    const oil own = oil_of(values);
    const double reynolds = oil_reynolds(&own, speed, values[CLEARANCE].number), most = 1.0; // San Andres 2010
    if (values[LAW].choice == 0) doubt_length(to, keys[LENGTH].name, values[LENGTH].number, values[RADIUS].number, "");
    doubt_clearance(to, keys[CLEARANCE].name, values[CLEARANCE].number, values[RADIUS].number);
    if (reynolds > most)
        doubt_value(
            to, keys[OIL + OIL_DENSITY].name,
            "is so high that the oil's inertia counts, which the law leaves out: squeeze Reynolds number %.3g, up "
            "to %g",
            reynolds, most);
}

static double squeeze_clearance(const element *own) {
    return 1.0 / own->number[SQUEEZE_OVER_CLEARANCE];
}

KERNELS_OF_EVERY_ISA(squeeze_kernels);

const element_type squeeze_element = {
    .group = {"squeeze", "a squeeze film damper between a station and its housing", "Vance, Zeidan, Murphy 2010", keys,
              KEY_COUNT, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .kernels = kernels,
    .build = squeeze_build,
    .bearing_clearance = squeeze_clearance,
    .doubt = squeeze_doubt,
};
#endif
