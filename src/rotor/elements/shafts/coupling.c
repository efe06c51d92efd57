// A flexible coupling: stiffness and damping between the ends of two shafts, across and along them, against their tilts
// and against their twist.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

static const double pi = 3.14159265358979323846;

enum {
    BETWEEN,
    RADIAL,
    TILT,
    TWIST,
    AXIAL,
    RADIAL_DAMPING,
    TILT_DAMPING,
    TWIST_DAMPING,
    AXIAL_DAMPING,
    DIAMETER,
    BORE,
    RUNS_OFF,
    RUNS_OFF_ANGLE,
    KINK,
    KINK_ANGLE,
    KEY_COUNT
};

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] =
        STATIONS_KEY("between", REQUIRED, "the two stations that the coupling joins, at the ends of two shafts"),
    [RADIAL] =
        NUMBER_KEY("radial", "k_r", "N/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "stiffness against a parallel offset"),
    [TILT] = NUMBER_KEY("tilt", "k_t", "N m/rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                        "stiffness against an angle between both shafts"),
    [TWIST] = NUMBER_KEY("twist", "k_z", "N m/rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                         "stiffness against twist, between stations that twist"),
    [AXIAL] = NUMBER_KEY("axial", "k_a", "N/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                         "stiffness along the shafts, between stations with axial: yes"),
    [RADIAL_DAMPING] =
        NUMBER_KEY("radial_damping", "c_r", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "damping of a parallel offset"),
    [TILT_DAMPING] = NUMBER_KEY("tilt_damping", "c_t", "N m s/rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                                "damping of an angle between both shafts"),
    [TWIST_DAMPING] =
        NUMBER_KEY("twist_damping", "c_z", "N m s/rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "damping of twist"),
    [AXIAL_DAMPING] =
        NUMBER_KEY("axial_damping", "c_a", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "damping along the shafts"),
    [DIAMETER] = NUMBER_KEY("diameter", "d", "m", OPTIONAL, WHIRL_POSITIVE,
                            "outer diameter of the shaft that it represents, where that is weakest: for the shear "
                            "stress by its torque"),
    [BORE] = NUMBER_KEY("inner", "d_i", "m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "inner diameter there"),
    [RUNS_OFF] = NUMBER_KEY("bore_offset", "e", "m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                            "bores off centre: distance of the first shaft's axis from the second's, turning with "
                            "them, while no force bends the coupling"),
    [RUNS_OFF_ANGLE] = ANGLE_KEY("bore_angle", "beta", "bore_offset",
                                 "direction of that distance at t = 0, from the x axis towards y"),
    [KINK] = NUMBER_KEY("face_kink", "kappa", "rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                        "faces out of square: slope of the first shaft relative to the second, turning with them"),
    [KINK_ANGLE] = ANGLE_KEY("face_angle", "", "face_kink",
                             "direction in which the first shaft leans at t = 0, from the x axis towards y"),
};

/// Adds the rotating forces of an offset e on the first place, k e + c e' with e' = i omega e, and the opposite on the
/// second. The ports of the first place are port[0] and [1]; those of the second begin at port[next].
static void add_turning(assembly *to, const size_t *port, size_t next, double stiffness, double damping, double size,
                        double angle) {
    const double steady = stiffness * size, ahead = damping * size * to->speed, quarter = copysign(0.5 * pi, to->turn);
    for (size_t place = 0; place < 2; place++) {
        const size_t x = port[place * next], y = port[place * next + 1];
        const double sign = place == 0 ? 1.0 : -1.0;
        if (size > 0.0) assembly_turning(to, x, y, sign * steady, angle);
        if (size > 0.0 && damping > 0.0) assembly_turning(to, x, y, sign * ahead, angle + quarter);
    }
}

/// Checks that both shafts turn with the rotor if a bore offset or a face kink turns with them.
static whirl_status check_turning(const key_value *values, const assembly *to) {
    if (values[KINK].number > 0.0 && !(values[TILT].number > 0.0) && !(values[TILT_DAMPING].number > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "has a face_kink and no stiffness against tilts, expected tilt as well");
    if (values[RUNS_OFF].number > 0.0 && !(values[RADIAL].number > 0.0) && !(values[RADIAL_DAMPING].number > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "has a bore_offset and no stiffness against it, expected radial above 0");
    for (int i = 0; i < 2; i++) {
        const size_t station = values[BETWEEN].station[i];
        const bool aside = station != GROUND && to->stations[station].ratio != 1.0;
        if (aside && (values[RUNS_OFF].number > 0.0 || values[KINK].number > 0.0))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "has a bore_offset or face_kink that turns with the rotor, and '%s' is on a shaft of "
                              "another speed, expected none",
                              to->stations[station].name);
    }
    return whirl_ok();
}

/// Joins the twists or the axial displacements of both stations. WHIRL_BAD_INPUT if one of them does not move that way.
static whirl_status coupling_join(const key_value *values, assembly *to, axis along, const joining *by) {
    const size_t *station = values[BETWEEN].station;
    for (size_t i = 0; i < 2; i++) {
        size_t coordinate;
        if (station[i] == GROUND) continue;
        const whirl_status status = assembly_find(to, station[i], along, &coordinate);
        if (status.code != WHIRL_OK) return status;
    }
    assembly_link(to, along, station[0], station[1], by);
    return whirl_ok();
}

static whirl_status join_twists(const key_value *values, assembly *to) {
    const double outer = values[DIAMETER].number, inner = values[BORE].number;
    const joining by = {.stiffness = values[TWIST].number,
                        .damping = values[TWIST_DAMPING].number,
                        .modulus = values[DIAMETER].given ? joining_modulus(outer, inner) : 0.0};
    const whirl_status status = coupling_join(values, to, AXIS_TWIST, &by);
    if (status.code == WHIRL_OK && values[BORE].given && !(values[DIAMETER].given && inner < outer))
        return whirl_fail(WHIRL_BAD_INPUT, "has an inner diameter, expected a greater outer one (diameter)");
    return status;
}

static whirl_status join_axially(const key_value *values, assembly *to) {
    return coupling_join(values, to, AXIS_AXIAL,
                         &(joining){.stiffness = values[AXIAL].number, .damping = values[AXIAL_DAMPING].number});
}

static whirl_status coupling_build(const key_value *values, assembly *to, element *out) {
    enum { PLANE = 2 };
    static const axis axes[] = {AXIS_X, AXIS_Y, AXIS_TILT_X, AXIS_TILT_Y};
    const bool tilts = values[TILT].number > 0.0 || values[TILT_DAMPING].number > 0.0;
    const size_t count = tilts ? 2 * PLANE : PLANE;
    const bool across = tilts || values[RADIAL].number > 0.0 || values[RADIAL_DAMPING].number > 0.0;
    // Join the displacements, and the tilts if they have a stiffness.
    whirl_status status = check_turning(values, to);
    if (status.code == WHIRL_OK && !across && !values[TWIST].given && !values[RADIAL].given && !values[AXIAL].given)
        status = whirl_fail(WHIRL_BAD_INPUT, "has no stiffness, expected radial, tilt, twist or axial");
    if (status.code == WHIRL_OK && across) status = element_between(&values[BETWEEN], to, axes, count, out);
    for (size_t a = 0; a < count && across && status.code == WHIRL_OK; a++) {
        const size_t one = out->port[a], other = out->port[count + a];
        assembly_spring(to, one, other, values[a < PLANE ? RADIAL : TILT].number);
        assembly_damper(to, one, other, values[a < PLANE ? RADIAL_DAMPING : TILT_DAMPING].number);
    }
    // Join the twists and the axial displacements.
    if (status.code == WHIRL_OK && (values[TWIST].number > 0.0 || values[TWIST_DAMPING].number > 0.0))
        status = join_twists(values, to);
    if (status.code == WHIRL_OK && (values[AXIAL].number > 0.0 || values[AXIAL_DAMPING].number > 0.0))
        status = join_axially(values, to);
    if (status.code != WHIRL_OK || to->balanced) return status;
    // Add the forces of a bore offset and a face kink, which turn with the shaft.
    add_turning(to, out->port, count, values[RADIAL].number, values[RADIAL_DAMPING].number, values[RUNS_OFF].number,
                values[RUNS_OFF_ANGLE].number);
    if (tilts)
        add_turning(to, out->port + PLANE, count, values[TILT].number, values[TILT_DAMPING].number, values[KINK].number,
                    values[KINK_ANGLE].number);
    return status;
}

const element_type coupling_element = {
    .group = {"coupling", "a flexible coupling between the ends of two shafts; its bores and faces may run out",
              "Friswell et al. 2010, sec. 5.4", keys, KEY_COUNT, NULL, NULL},
    .build = coupling_build,
};
#endif
