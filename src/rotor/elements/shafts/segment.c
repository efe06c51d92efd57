// A segment of a shaft of finite elements: a cylinder or a cone, from which mesh.c makes nodes and elements.
#include "shafts.h"

#include "registry.h"
#include "whirl/engine/rotor.h"

#if VECTOR_ISA == VECTOR_SCALAR

static const whirl_key keys[SEGMENT_KEYS] = {
    [SEGMENT_LENGTH] = NUMBER_KEY("length", "L", "m", REQUIRED, WHIRL_POSITIVE, "length"),
    [SEGMENT_OUTER] = NUMBER_KEY("outer", "d_o", "m", REQUIRED, WHIRL_POSITIVE, "outer diameter"),
    [SEGMENT_INNER] = NUMBER_KEY("inner", "d_i", "m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "diameter of the bore"),
    [SEGMENT_OUTER_END] = NUMBER_KEY("outer_end", "", "m", OPTIONAL, WHIRL_POSITIVE,
                                     "outer diameter at the other end, of a cone; absent: outer"),
    [SEGMENT_INNER_END] = NUMBER_KEY("inner_end", "", "m", OPTIONAL, WHIRL_NOT_NEGATIVE,
                                     "diameter of the bore at the other end; absent: inner"),
    [SEGMENT_FLATS] =
        NUMBER_KEY("flats", "", "m", OPTIONAL, WHIRL_POSITIVE,
                   "distance of two flats along the segment, which make its stiffness unequal; absent: round"),
    [SEGMENT_FLATS_ANGLE] =
        ANGLE_KEY("flats_angle", "", "flats", "direction of the flats' normal at t = 0, from the x axis towards y"),
    [SEGMENT_SHAFT] =
        NAME_KEY("shaft", OPTIONAL, "shafts", "name of its shaft in `shafts`; required if there are several"),
    [SEGMENT_START] =
        NUMBER_KEY("start", "", "m", OPTIONAL, WHIRL_ANY,
                   "position of its beginning on the shaft; absent: the end of the segment before it in the list"),
    [SEGMENT_FROM] = STATION_KEY("from", OPTIONAL, "station at its beginning, in place of that station's position"),
    [SEGMENT_TO] = STATION_KEY("to", OPTIONAL, "station at its other end, in place of that station's position"),
    [SEGMENT_MATERIAL] = NAME_KEY("material", OPTIONAL, "materials", "name in `materials`; absent: that of the shaft"),
    [SEGMENT_ELEMENTS] = WHOLE_KEY("elements", "n", DEFAULT("1"), WHIRL_FROM_TO(1, WHIRL_MAX_STATIONS),
                                   "least number of equal finite elements of the segment"),
    [SEGMENT_AXIAL_FORCE] =
        NUMBER_KEY("axial_force", "N", "N", DEFAULT("0"), WHIRL_ANY, "axial force, above 0 for tension"),
    [SEGMENT_SHEAR] =
        CHOICE_KEY("shear", OPTIONAL, "cowper|hutchinson|none", "as for shafts; absent: that of the shaft"),
    [SEGMENT_ROTARY] = CHOICE_KEY("rotary_inertia", OPTIONAL, "yes|no", "as for shafts; absent: that of the shaft"),
    [SEGMENT_GYROSCOPIC] = CHOICE_KEY("gyroscopic", OPTIONAL, "yes|no", "as for shafts; absent: that of the shaft"),
    [SEGMENT_MASS_DAMPING] = NUMBER_KEY("mass_damping", "alpha", "1/s", OPTIONAL, WHIRL_NOT_NEGATIVE,
                                        "as for shafts; absent: that of the shaft"),
    [SEGMENT_STIFFNESS_DAMPING] = NUMBER_KEY("stiffness_damping", "beta", "s", OPTIONAL, WHIRL_NOT_NEGATIVE,
                                             "as for shafts; absent: that of the shaft"),
};

/// Does nothing: the mesh adds the mass and stiffness.
static whirl_status segment_build(const key_value *values, assembly *to, element *out) {
    (void)values, (void)to, (void)out;
    return whirl_ok();
}

const element_type segment_element = {
    .group = {"segment", "a piece of a shaft of finite elements: a cylinder or a cone", "Nelson 1980", keys,
              SEGMENT_KEYS, NULL, NULL},
    .build = segment_build,
};
#endif
