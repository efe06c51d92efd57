// Aerodynamic cross coupling of a compressor or turbine stage, which drives whirl forward (Alford 1965; Wachel 1981).
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR

enum { AT, POWER, DIAMETER, WIDTH, DENSITY_RATIO, FACTOR, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station of the impeller"),
    [POWER] =
        NUMBER_KEY("power", "P", "W", REQUIRED, WHIRL_NOT_NEGATIVE, "power of the stage at the speed of its shaft"),
    [DIAMETER] = NUMBER_KEY("diameter", "D", "m", REQUIRED, WHIRL_POSITIVE, "outer diameter of the impeller"),
    [WIDTH] =
        NUMBER_KEY("width", "H", "m", REQUIRED, WHIRL_POSITIVE,
                   "least width of diffuser or impeller at its outlet; for an axial stage the height of the blades"),
    [DENSITY_RATIO] = NUMBER_KEY("density_ratio", "", "1", DEFAULT("1"), WHIRL_POSITIVE,
                                 "density of the gas at the outlet over that at the inlet; 1 for an axial stage"),
    [FACTOR] = NUMBER_KEY("factor", "B", "1", DEFAULT("3"), WHIRL_NOT_NEGATIVE,
                          "empirical factor: 3 for a centrifugal stage, 1.5 for an axial one"),
};

static whirl_status stage_build(const key_value *values, assembly *to, element *out) {
    // The torque is that of the shaft of its station.
    const double ratio = to->stations[values[AT].station[0]].ratio;
    const double speed = ratio == 1.0 ? to->speed : fabs(ratio) * to->speed;
    if (speed == 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "has no torque where the rotor stands still, expected a speed above 0");
    const double own = values[FACTOR].number * values[POWER].number * values[DENSITY_RATIO].number /
                       (speed * values[DIAMETER].number * values[WIDTH].number);
    const double forward = to->stages * own * (ratio * to->turn < 0.0 ? -1.0 : 1.0);
    const whirl_status status = assembly_find_plane(to, values[AT].station[0], out->port);
    if (status.code != WHIRL_OK) return status;
    to->cross_coupling += own;
    out->lumped = true;
    assembly_stiffness(to, out->port[0], out->port[1], forward);
    assembly_stiffness(to, out->port[1], out->port[0], -forward);
    return whirl_ok();
}

const element_type stage_element = {
    .group = {"stage", "cross coupling of a compressor or turbine stage by its torque", "Alford 1965; Wachel 1981",
              keys, KEY_COUNT, NULL, NULL},
    .drags = true,
    .spun = true,
    .follows = true,
    .build = stage_build,
};
#endif
