// A segment of a shaft of finite elements: a cylinder or a cone; the mesh (mesh.c) makes nodes and elements of it.
#include "shafts.h"

#include "registry.h"
#include "whirl/rotor.h"

#if VECTOR_ISA == VECTOR_SCALAR

static const whirl_key keys[SEGMENT_KEYS] = {
    [SEGMENT_LENGTH] = {"length", "L", "m", WHIRL_KEY_NUMBER, true, "", WHIRL_POSITIVE, NULL, "length", ""},
    [SEGMENT_OUTER] = {"outer", "d_o", "m", WHIRL_KEY_NUMBER, true, "", WHIRL_POSITIVE, NULL, "outer diameter", ""},
    [SEGMENT_INNER] = {"inner", "d_i", "m", WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
                       "diameter of the bore", ""},
    [SEGMENT_OUTER_END] = {"outer_end", "", "m", WHIRL_KEY_NUMBER, false, "", WHIRL_POSITIVE, NULL,
                           "outer diameter at its other end, of a cone; outer where absent", ""},
    [SEGMENT_INNER_END] = {"inner_end", "", "m", WHIRL_KEY_NUMBER, false, "", WHIRL_NOT_NEGATIVE, NULL,
                           "diameter of the bore at its other end; inner where absent", ""},
    [SEGMENT_FLATS] = {"flats", "", "m", WHIRL_KEY_NUMBER, false, "", WHIRL_POSITIVE, NULL,
                       "distance of two flats cut along it, which makes its stiffness unequal; round where absent", ""},
    [SEGMENT_FLATS_ANGLE] = {"flats_angle", "", "rad", WHIRL_KEY_NUMBER, false, "0", WHIRL_ANY, NULL,
                             "where the normal of the flats points at t = 0, from the x axis towards y", ""},
    [SEGMENT_SHAFT] = {"shaft", "", "", WHIRL_KEY_NAME, false, "", WHIRL_ANY, "shafts",
                       "name of `shafts` that it is a part of; required where there are several", ""},
    [SEGMENT_START] = {"start", "", "m", WHIRL_KEY_NUMBER, false, "", WHIRL_ANY, NULL,
                       "where on the shaft it begins; where the segment before it in the list ends where absent", ""},
    [SEGMENT_FROM] = {"from", "", "", WHIRL_KEY_STATION, false, "", WHIRL_ANY, NULL,
                      "station at its beginning, in place of that station's position", ""},
    [SEGMENT_TO] = {"to", "", "", WHIRL_KEY_STATION, false, "", WHIRL_ANY, NULL,
                    "station at its other end, in place of that station's position", ""},
    [SEGMENT_MATERIAL] = {"material", "", "", WHIRL_KEY_NAME, false, "", WHIRL_ANY, "materials",
                          "name of `materials`; that of the shaft where absent", ""},
    [SEGMENT_ELEMENTS] = {"elements", "n", "1", WHIRL_KEY_WHOLE, false, "1", WHIRL_FROM_TO(1, WHIRL_MAX_STATIONS), NULL,
                          "equal finite elements that it is cut into, at least", ""},
    [SEGMENT_AXIAL_FORCE] = {"axial_force", "N", "N", WHIRL_KEY_NUMBER, false, "0", WHIRL_ANY, NULL,
                             "axial force, positive where it pulls", ""},
    [SEGMENT_SHEAR] = {"shear", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "cowper|hutchinson|none",
                       "as for shafts; that of the shaft where absent", ""},
    [SEGMENT_ROTARY] = {"rotary_inertia", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "yes|no",
                        "as for shafts; that of the shaft where absent", ""},
    [SEGMENT_GYROSCOPIC] = {"gyroscopic", "", "", WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "yes|no",
                            "as for shafts; that of the shaft where absent", ""},
    [SEGMENT_MASS_DAMPING] = {"mass_damping", "alpha", "1/s", WHIRL_KEY_NUMBER, false, "", WHIRL_NOT_NEGATIVE, NULL,
                              "as for shafts; that of the shaft where absent", ""},
    [SEGMENT_STIFFNESS_DAMPING] = {"stiffness_damping", "beta", "s", WHIRL_KEY_NUMBER, false, "", WHIRL_NOT_NEGATIVE,
                                   NULL, "as for shafts; that of the shaft where absent", ""},
};

/// The mesh has its mass and stiffness.
static whirl_status build(const key_value *values, assembly *to, element *out) {
    (void)values, (void)to, (void)out;
    return whirl_ok();
}

const element_type segment_element = {
    .group = {"segment", "a piece of a shaft of finite elements: a cylinder or a cone", "Nelson 1980", keys,
              SEGMENT_KEYS, NULL, NULL},
    .build = build,
};
#endif
