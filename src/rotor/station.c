// A station: a lumped mass with damping to ground, and the eccentricity of its centre of mass.
#include <math.h>

#include "element.h"

enum { MASS, DAMPING, ECCENTRICITY, ECCENTRICITY_ANGLE, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [MASS] = {"mass", "m", "kg", WHIRL_KEY_NUMBER, true, "", WHIRL_POSITIVE, NULL, "mass lumped at the station", ""},
    [DAMPING] = {"damping", "c", "N s/m", WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
                 "viscous damping between the station and the ground", ""},
    [ECCENTRICITY] = {"eccentricity", "e", "m", WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
                      "distance of the centre of mass from the shaft's centre (unbalance m e)", ""},
    [ECCENTRICITY_ANGLE] = {"eccentricity_angle", "beta", "rad", WHIRL_KEY_NUMBER, false, "0", WHIRL_ANY, NULL,
                            "where the centre of mass lies at t = 0, from the x axis towards y", ""},
};

const whirl_group station_group = {
    "station", "a lumped mass on the shaft, free to move in x and y", "", keys, KEY_COUNT, NULL};

double station_mass(const key_value *values) {
    return values[MASS].number;
}

void add_unbalance(const scales *scale, size_t station, double moment, double angle, double numbers[STATION_NUMBERS]) {
    const double acceleration = moment / (scale->mass[station] * scale->length);
    numbers[STATION_UNBALANCE_COS] += acceleration * cos(angle);
    numbers[STATION_UNBALANCE_SIN] += acceleration * sin(angle);
}

void station_lump(const key_value *values, const scales *scale, size_t station, double numbers[STATION_NUMBERS]) {
    const double mass = values[MASS].number;
    numbers[STATION_DAMPING] += values[DAMPING].number / (mass * scale->speed);
    add_unbalance(scale, station, mass * values[ECCENTRICITY].number, values[ECCENTRICITY_ANGLE].number, numbers);
}
