// A massless beam between two stations that tilt, or from one station to a clamp in the ground.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { BETWEEN, LENGTH, DIAMETER, INNER, MODULUS, BENDING, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = STATIONS_KEY("between", REQUIRED, "the two ends, along the shaft; ground is a clamp"),
    [LENGTH] = NUMBER_KEY("length", "L", "m", REQUIRED, WHIRL_POSITIVE, "length"),
    [DIAMETER] = NUMBER_KEY("diameter", "d", "m", OPTIONAL, WHIRL_POSITIVE, "outer diameter; required without bending"),
    [INNER] = NUMBER_KEY("inner", "d_i", "m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "diameter of the bore"),
    [MODULUS] = NUMBER_KEY("modulus", "E", "Pa", DEFAULT("2.11e11"), WHIRL_POSITIVE, "Young's modulus; absent: steel"),
    [BENDING] = NUMBER_KEY("bending", "E I", "N m2", OPTIONAL, WHIRL_POSITIVE,
                           "bending stiffness, in place of diameter, inner and modulus"),
};

static whirl_status bending_of(const key_value *values, double *bending) {
    const double outer = values[DIAMETER].number, inner = values[INNER].number;
    *bending = values[BENDING].number;
    if (values[BENDING].given != values[DIAMETER].given) {
        if (values[BENDING].given) return whirl_ok();
        if (!(inner < outer))
            return whirl_fail(WHIRL_BAD_INPUT, "has a bore of %g m in a diameter of %g m, expected a smaller one",
                              inner, outer);
        *bending = values[MODULUS].number * 3.14159265358979323846 / 64.0 *
                   (outer * outer * outer * outer - inner * inner * inner * inner);
        return whirl_ok();
    }
    return whirl_fail(WHIRL_BAD_INPUT, "has %s, expected one of diameter and bending",
                      values[BENDING].given ? "both diameter and bending" : "neither diameter nor bending");
}

/// Adds the stiffness matrix of Euler and Bernoulli (Przemieniecki 1968, sec. 5.6) in one plane. A slope is the
/// derivative of the displacement along the shaft, from the first end to the second. end: displacement and slope of the
/// first end, then of the second.
static void add_plane(assembly *to, const size_t end[4], double bending, double length) {
    const double k = bending / (length * length * length);
    const double matrix[4][4] = {{12.0, 6.0 * length, -12.0, 6.0 * length},
                                 {6.0 * length, 4.0 * length * length, -6.0 * length, 2.0 * length * length},
                                 {-12.0, -6.0 * length, 12.0, -6.0 * length},
                                 {6.0 * length, 2.0 * length * length, -6.0 * length, 4.0 * length * length}};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) assembly_stiffness(to, end[i], end[j], k * matrix[i][j]);
}

static whirl_status beam_build(const key_value *values, assembly *to, element *out) {
    static const axis plane[2][2] = {{AXIS_X, AXIS_TILT_X}, {AXIS_Y, AXIS_TILT_Y}};
    double bending;
    whirl_status status = bending_of(values, &bending);
    for (int i = 0; i < 2 && status.code == WHIRL_OK; i++) {
        status = element_between(&values[BETWEEN], to, plane[i], 2, out);
        if (status.code == WHIRL_OK) add_plane(to, out->port, bending, values[LENGTH].number);
    }
    return status;
}

const element_type beam_element = {
    .group = {"beam", "a massless round shaft that bends, between two stations that tilt, or from one to a clamp",
              "Friswell et al. 2010, sec. 5.4", keys, KEY_COUNT, NULL, NULL},
    .build = beam_build,
};
#endif
