// A disc by its dimensions, which adds its mass and inertia to a station.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { AT, OUTER, INNER, WIDTH, DENSITY, ECCENTRICITY, ECCENTRICITY_ANGLE, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station that carries it"),
    [OUTER] = NUMBER_KEY("outer", "d_o", "m", REQUIRED, WHIRL_POSITIVE, "outer diameter"),
    [INNER] = NUMBER_KEY("inner", "d_i", "m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "diameter of the bore"),
    [WIDTH] = NUMBER_KEY("width", "h", "m", REQUIRED, WHIRL_POSITIVE, "width along the shaft"),
    [DENSITY] = NUMBER_KEY("density", "rho", "kg/m3", DEFAULT("7850"), WHIRL_POSITIVE, "density; absent: steel"),
    [ECCENTRICITY] = NUMBER_KEY("eccentricity", "e", "m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                                "distance of the disc's centre of mass from the shaft's centre"),
    [ECCENTRICITY_ANGLE] = ANGLE_KEY("eccentricity_angle", "beta", "eccentricity",
                                     "direction of the centre of mass at t = 0, from the x axis towards y"),
};

static const double pi = 3.14159265358979323846;

static double mass_of(const key_value *values) {
    const double outer = values[OUTER].number, inner = values[INNER].number;
    return values[DENSITY].number * values[WIDTH].number * pi / 4.0 * (outer - inner) * (outer + inner);
}

/// Adds the inertia: I_p = m (d_o^2 + d_i^2)/8, I_d = I_p/2 + m h^2/12.
static whirl_status disc_inertia(const key_value *values, assembly *to) {
    const double outer = values[OUTER].number, inner = values[INNER].number, width = values[WIDTH].number;
    if (!(inner < outer))
        return whirl_fail(WHIRL_BAD_INPUT, "has a bore of %g m in an outer diameter of %g m, expected a smaller one",
                          inner, outer);
    assembly_station *at = &to->stations[values[AT].station[0]];
    const double mass = mass_of(values), polar = mass * (outer * outer + inner * inner) / 8.0;
    at->mass += mass;
    at->polar += polar;
    at->diametral += 0.5 * polar + mass * width * width / 12.0;
    return whirl_ok();
}

static whirl_status disc_build(const key_value *values, assembly *to, element *out) {
    (void)out;
    assembly_eccentric(to, values[AT].station[0], mass_of(values) * values[ECCENTRICITY].number,
                       values[ECCENTRICITY_ANGLE].number, values[ECCENTRICITY].given);
    return whirl_ok();
}

const element_type disc_element = {
    .group = {"disc", "a disc by its dimensions: its mass and inertia are added to a station, which tilts",
              "Friswell et al. 2010, app. 1", keys, KEY_COUNT, NULL, NULL},
    .inertia = disc_inertia,
    .build = disc_build,
};
#endif
