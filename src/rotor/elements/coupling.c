// A flexible coupling: what joins the ends of two shafts in the plane across them and against their tilts.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR

enum { BETWEEN, RADIAL, TILT, RADIAL_DAMPING, TILT_DAMPING, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = {"between", "", "", WHIRL_KEY_STATIONS, true, "", WHIRL_ANY, NULL,
                 "the two stations that it joins, at the ends of two shafts", ""},
    [RADIAL] = {"radial", "k_r", "N/m", WHIRL_KEY_NUMBER, true, "", WHIRL_NOT_NEGATIVE, NULL,
                "stiffness against a parallel offset", ""},
    [TILT] = {"tilt", "k_t", "N m/rad", WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
              "stiffness against an angle between both shafts", ""},
    [RADIAL_DAMPING] = {"radial_damping", "c_r", "N s/m", WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
                        "damping of a parallel offset", ""},
    [TILT_DAMPING] = {"tilt_damping", "c_t", "N m s/rad", WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
                      "damping of an angle between both shafts", ""},
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
