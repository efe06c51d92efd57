// A station: a lumped mass with damping to the ground, eccentricity, and inertia if it tilts.
#include "element.h"

#if VECTOR_ISA == VECTOR_SCALAR

enum {
    SHAFT = STATION_SHAFT,
    POSITION = STATION_POSITION,
    BOW = STATION_BOW,
    BOW_ANGLE = STATION_BOW_ANGLE,
    MASS,
    DAMPING,
    ECCENTRICITY,
    ECCENTRICITY_ANGLE,
    DIAMETRAL,
    POLAR,
    SKEW,
    SKEW_ANGLE,
    MOVES,
    AXIAL,
    KEY_COUNT
};

static const whirl_key keys[KEY_COUNT] = {
    [SHAFT] = NAME_KEY("shaft", OPTIONAL, "shafts", "name of its shaft in `shafts`; optional if there is one shaft"),
    [POSITION] = NUMBER_KEY("position", "z", "m", OPTIONAL, WHIRL_ANY,
                            "position on a shaft of finite elements, from the beginning of the shaft"),
    [BOW] = CITED_NUMBER_KEY("bow", "delta", "m", OPTIONAL, WHIRL_ANY,
                             "displacement of a bent shaft of finite elements, which turns with it; at three or more "
                             "of its stations, 0 where it is straight",
                             "Nicholas, Gunter, Allaire 1976"),
    [BOW_ANGLE] = ANGLE_KEY("bow_angle", "", "bow", "direction of the bow at t = 0, from the x axis towards y"),
    [MASS] = NUMBER_KEY("mass", "m", "kg", OPTIONAL, WHIRL_POSITIVE,
                        "mass lumped at the station; required without a disc or a shaft of finite elements"),
    [DAMPING] = NUMBER_KEY("damping", "c", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                           "viscous damping between the station and the ground"),
    [ECCENTRICITY] = NUMBER_KEY("eccentricity", "e", "m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                                "distance of the centre of mass from the shaft's centre (unbalance m e)"),
    [ECCENTRICITY_ANGLE] = ANGLE_KEY("eccentricity_angle", "beta", "eccentricity",
                                     "direction of the centre of mass at t = 0, from the x axis towards y"),
    [DIAMETRAL] = CITED_NUMBER_KEY("diametral", "I_d", "kg m2", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                                   "moment of inertia about a diameter; a station that has one tilts",
                                   "Friswell et al. 2010, sec. 3.5"),
    [POLAR] = CITED_NUMBER_KEY("polar", "I_p", "kg m2", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                               "moment of inertia about the shaft's axis, which causes gyroscopic moments and "
                               "resists twist",
                               "Friswell et al. 2010, sec. 3.5"),
    [SKEW] = CITED_NUMBER_KEY("skew", "chi", "rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                              "angle between the principal axis of inertia and the shaft's",
                              "Friswell et al. 2010, sec. 6.2"),
    [SKEW_ANGLE] = ANGLE_KEY("skew_angle", "", "skew",
                             "direction in which the principal axis leans at t = 0, from the x axis towards y"),
    [MOVES] = CHOICE_KEY("moves", DEFAULT("xy"), "xy|x|y|twist|all",
                         "xy: along both axes; x, y: along one, as a pedestal may; twist: about the shaft's axis alone "
                         "(torsion); all: along both axes and about the shaft's"),
    [AXIAL] = CHOICE_KEY("axial", DEFAULT("no"), "no|yes", "yes: it moves along the shaft, too; its mass resists"),
};

const whirl_group station_group = {"station",
                                   "a lumped mass on the shaft that moves along x and y, tilts where it has a "
                                   "diametral inertia, and may twist or move "
                                   "along the shaft",
                                   "",
                                   keys,
                                   KEY_COUNT,
                                   NULL,
                                   NULL};

whirl_status station_inertia(const key_value *values, assembly *to, size_t station) {
    enum { ALONG_XY, ALONG_X, ALONG_Y, TWIST, ALL };
    assembly_station *at = &to->stations[station];
    at->mass += values[MASS].number;
    at->diametral += values[DIAMETRAL].number;
    at->polar += values[POLAR].number;
    at->moves_x = values[MOVES].choice != ALONG_Y && values[MOVES].choice != TWIST;
    at->moves_y = values[MOVES].choice != ALONG_X && values[MOVES].choice != TWIST;
    at->twists = values[MOVES].choice >= TWIST;
    at->axial = values[AXIAL].choice == 1;
    return whirl_ok();
}

/// Builds a station. A skewed axis of inertia turns with the shaft: I_d phi'' - i I_p omega phi' = ... + (I_d - I_p)
/// omega^2 chi e^(i omega t).
void station_build(const key_value *values, assembly *to, size_t station) {
    const assembly_station *at = &to->stations[station];
    const double moment = (at->diametral - at->polar) * to->speed * to->speed * values[SKEW].number;
    assembly_ground_damping(to, station, values[DAMPING].number);
    assembly_eccentric(to, station, values[MASS].number * values[ECCENTRICITY].number,
                       values[ECCENTRICITY_ANGLE].number, values[ECCENTRICITY].given);
    if (at->coordinate[AXIS_TILT_X] == NO_COORDINATE) return;
    assembly_gyroscopic(to, station, at->polar);
    if (to->balanced) return;
    if (values[SKEW].number > 0.0 && assembly_is_aside(to, station)) to->aside = at->name;
    if (values[SKEW].given) {
        const size_t x = at->coordinate[AXIS_TILT_X], y = at->coordinate[AXIS_TILT_Y];
        assembly_turning(to, x, y, moment, values[SKEW_ANGLE].number);
        assembly_inertial(to, x, y, (at->diametral - at->polar) * values[SKEW].number, values[SKEW_ANGLE].number);
    }
}
#endif
