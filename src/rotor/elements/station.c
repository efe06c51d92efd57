// A station: a lumped mass with damping to ground, and the eccentricity of its centre of mass.
#include "element.h"

#if VECTOR_ISA == VECTOR_SCALAR

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

whirl_status station_inertia(const key_value *values, assembly *to, size_t station) {
    to->stations[station].mass += values[MASS].number;
    return whirl_ok();
}

void station_build(const key_value *values, assembly *to, size_t station) {
    assembly_ground_damping(to, station, values[DAMPING].number);
    assembly_unbalance(to, station, values[MASS].number * values[ECCENTRICITY].number,
                       values[ECCENTRICITY_ANGLE].number);
}
#endif
