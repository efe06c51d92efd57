// The S-N curve of the torque between two stations, for the cycles of a run. It causes no force.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR

enum {
    BETWEEN,
    TORQUES,
    STRESSES,
    LIVES,
    SLOPE,
    ENDURANCE_TORQUE,
    ENDURANCE_STRESS,
    DIAMETER,
    INNER,
    CONCENTRATION,
    KEY_COUNT
};

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] =
        STATIONS_KEY("between", REQUIRED,
                     "the two stations that are joined by the shaft, coupling or gear to which the curve applies"),
    [TORQUES] = CITED_NUMBERS_KEY("torque_ranges", "", "N m", OPTIONAL, WHIRL_POSITIVE,
                                  "points of the curve: ranges of the torque, peak to peak, the largest first; one "
                                  "point with slope, or several, between and below which the curve is straight over "
                                  "logarithms",
                                  "Miner 1945"),
    [STRESSES] = CITED_NUMBERS_KEY("stress_ranges", "", "Pa", OPTIONAL, WHIRL_POSITIVE,
                                   "in place of torque_ranges: ranges of the shear stress, with its concentration", ""),
    [LIVES] = CITED_NUMBERS_KEY("cycles", "N", "1", REQUIRED, WHIRL_POSITIVE,
                                "cycles to failure at these ranges, independent of the mean", ""),
    [SLOPE] = NUMBER_KEY("slope", "m", "1", OPTIONAL, WHIRL_ABOVE_TO(0.0, 1000.0),
                         "exponent of a curve with one point: N is proportional to 1/range to this power"),
    [ENDURANCE_TORQUE] = NUMBER_KEY("endurance_torque", "", "N m", OPTIONAL, WHIRL_POSITIVE,
                                    "range up to which cycles do no damage; absent: every cycle counts"),
    [ENDURANCE_STRESS] = NUMBER_KEY(
        "endurance_stress", "", "Pa", OPTIONAL, WHIRL_POSITIVE,
        "range of the stress up to which cycles do no damage, with stress_ranges; absent: every cycle counts"),
    [DIAMETER] = NUMBER_KEY("diameter", "d", "m", OPTIONAL, WHIRL_POSITIVE,
                            "outer diameter of the section whose stress counts; absent: that of the weakest section of "
                            "the shaft or coupling"),
    [INNER] = NUMBER_KEY("inner", "d_i", "m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "inner diameter there"),
    [CONCENTRATION] = NUMBER_KEY("stress_concentration", "K_f", "1", DEFAULT("1"), WHIRL_FROM_TO(1.0, 100.0),
                                 "factor of the stress there, as of a keyway or a fillet"),
};

/// Returns how many numbers a key has. A single number is not a list.
static size_t fatigue_count(const key_value *of) {
    return of->count > 0 ? of->count : 1;
}

static whirl_status fatigue_check(const key_value *values) {
    const key_value *ranges = &values[values[STRESSES].given ? STRESSES : TORQUES], *lives = &values[LIVES];
    const int endurance = values[STRESSES].given ? ENDURANCE_TORQUE : ENDURANCE_STRESS;
    if (values[TORQUES].given == values[STRESSES].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has %s, expected either torque_ranges or stress_ranges",
                          values[TORQUES].given ? "both" : "no ranges");
    if (values[endurance].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has %s and %s, expected a limit of the same kind", keys[endurance].name,
                          values[STRESSES].given ? "stress_ranges" : "torque_ranges");
    if (values[TORQUES].given && (values[DIAMETER].given || values[CONCENTRATION].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has %s and torque_ranges, expected stress_ranges",
                          values[DIAMETER].given ? "a diameter" : "a stress_concentration");
    if (values[INNER].given && !(values[DIAMETER].given && values[INNER].number < values[DIAMETER].number))
        return whirl_fail(WHIRL_BAD_INPUT, "has an inner diameter, expected a greater outer one (diameter)");
    if (fatigue_count(ranges) != fatigue_count(lives) || ranges->rows > 1 || lives->rows > 1)
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu ranges and %zu cycles, expected as many of both",
                          fatigue_count(ranges), fatigue_count(lives));
    for (size_t i = 1; i < fatigue_count(ranges); i++)
        if (!(ranges->list[i] < ranges->list[i - 1] && lives->list[i] > lives->list[i - 1]))
            return whirl_fail(WHIRL_BAD_INPUT, "has a curve that does not fall, expected smaller ranges with more "
                                               "cycles in turn");
    if ((fatigue_count(ranges) == 1) != values[SLOPE].given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has %s, expected a slope with one point of the curve, and none with "
                          "several",
                          values[SLOPE].given ? "a slope and several points" : "one point and no slope");
    return whirl_ok();
}

static whirl_status fatigue_build(const key_value *values, assembly *to, element *out) {
    const key_value *ranges = &values[values[STRESSES].given ? STRESSES : TORQUES];
    const int endurance = values[STRESSES].given ? ENDURANCE_STRESS : ENDURANCE_TORQUE;
    // Both stations must twist.
    whirl_status status = fatigue_check(values);
    size_t coordinate;
    for (size_t i = 0; i < 2 && status.code == WHIRL_OK; i++)
        status = values[BETWEEN].station[i] == GROUND
                     ? whirl_fail(WHIRL_BAD_INPUT, "is between a station and the ground, expected two stations that "
                                                   "twist")
                     : assembly_find(to, values[BETWEEN].station[i], AXIS_TWIST, &coordinate);
    if (status.code != WHIRL_OK) return status;
    // Copy the curve to the assembly.
    out->lumped = true;
    twist_fatigue own = {
        .station = {values[BETWEEN].station[0], values[BETWEEN].station[1]},
        .by_stress = values[STRESSES].given,
        .modulus = values[DIAMETER].given ? joining_modulus(values[DIAMETER].number, values[INNER].number) : 0.0,
        .concentration = values[CONCENTRATION].number,
        .count = fatigue_count(ranges),
        .slope = values[SLOPE].given ? values[SLOPE].number : 0.0,
        .endurance = values[endurance].given ? values[endurance].number : 0.0};
    for (size_t i = 0; i < own.count; i++) {
        own.ranges[i] = ranges->count > 0 ? ranges->list[i] : ranges->number;
        own.lives[i] = values[LIVES].count > 0 ? values[LIVES].list[i] : values[LIVES].number;
    }
    assembly_fatigue(to, &own);
    return whirl_ok();
}

const element_type fatigue_element = {
    .group = {"fatigue", "the S-N curve of a torque between two stations, for the cycles of a run", "Miner 1945", keys,
              KEY_COUNT, NULL, NULL},
    .build = fatigue_build,
};
#endif
