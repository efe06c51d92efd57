// A flexible coupling: what joins the ends of two shafts in the plane across them and against their tilts.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR

enum { BETWEEN, RADIAL, TILT, RADIAL_DAMPING, TILT_DAMPING, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED, "the two stations that it joins, at the ends of two shafts"),
    [RADIAL] = NUMBER_KEY("radial", "k_r", "N/m", REQUIRED, WHIRL_NOT_NEGATIVE, "stiffness against a parallel offset"),
    [TILT] = NUMBER_KEY("tilt", "k_t", "N m/rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                        "stiffness against an angle between both shafts"),
    [RADIAL_DAMPING] =
        NUMBER_KEY("radial_damping", "c_r", "N s/m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "damping of a parallel offset"),
    [TILT_DAMPING] = NUMBER_KEY("tilt_damping", "c_t", "N m s/rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                                "damping of an angle between both shafts"),
};

static whirl_status build(const key_value *values, assembly *to, element *out) {
    enum { PLANE = 2 };
    static const axis axes[] = {AXIS_X, AXIS_Y, AXIS_TILT_X, AXIS_TILT_Y};
    const bool tilts = values[TILT].number > 0.0 || values[TILT_DAMPING].number > 0.0;
    const size_t count = tilts ? 2 * PLANE : PLANE;
    const whirl_status status = element_between(&values[BETWEEN], to, axes, count, out);
    for (size_t a = 0; a < count && status.code == WHIRL_OK; a++) {
        const size_t one = out->port[a], other = out->port[count + a];
        assembly_spring(to, one, other, values[a < PLANE ? RADIAL : TILT].number);
        assembly_damper(to, one, other, values[a < PLANE ? RADIAL_DAMPING : TILT_DAMPING].number);
    }
    return status;
}

const element_type coupling_element = {
    .group = {"coupling", "a flexible coupling between the ends of two shafts, by its stiffnesses and dampings",
              "Friswell et al. 2010, sec. 5.4", keys, KEY_COUNT, NULL, NULL},
    .build = build,
};
#endif
