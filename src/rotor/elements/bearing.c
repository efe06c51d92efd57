// A linear bearing or seal: eight coefficients between a station and the ground, or another station.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR

enum { AT, FROM, KXX, KXY, KYX, KYY, CXX, CXY, CYX, CYY, KEY_COUNT };

#define STIFFNESS(name, symbol, fallback, text)                                                                        \
    { name, symbol, "N/m", WHIRL_KEY_NUMBER, false, fallback, WHIRL_ANY, NULL, text, "" }
#define DAMPING(name, symbol, fallback, text)                                                                          \
    { name, symbol, "N s/m", WHIRL_KEY_NUMBER, false, fallback, WHIRL_ANY, NULL, text, "" }

static const whirl_key keys[KEY_COUNT] = {
    [AT] = {"at", "", "", WHIRL_KEY_STATION, true, "", WHIRL_ANY, NULL, "station that it carries", ""},
    [FROM] = {"from", "", "", WHIRL_KEY_STATION, false, "", WHIRL_ANY, NULL,
              "station of its housing; the ground where absent", ""},
    [KXX] = STIFFNESS("kxx", "k_xx", "0", "stiffness along x"),
    [KXY] = STIFFNESS("kxy", "k_xy", "0", "force along -x by a displacement along y"),
    [KYX] = STIFFNESS("kyx", "k_yx", "0", "force along -y by a displacement along x"),
    [KYY] = STIFFNESS("kyy", "k_yy", "", "stiffness along y; kxx where absent"),
    [CXX] = DAMPING("cxx", "c_xx", "0", "damping along x"),
    [CXY] = DAMPING("cxy", "c_xy", "0", "force along -x by a velocity along y"),
    [CYX] = DAMPING("cyx", "c_yx", "0", "force along -y by a velocity along x"),
    [CYY] = DAMPING("cyy", "c_yy", "", "damping along y; cxx where absent"),
};

/// The block of one kind, by `add`, between the places one and other.
static void add_block(assembly *to, void (*add)(assembly *, size_t, size_t, double), const size_t one[2],
                      const size_t other[2], const double matrix[2][2]) {
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            add(to, one[i], one[j], matrix[i][j]);
            add(to, one[i], other[j], -matrix[i][j]);
            add(to, other[i], one[j], -matrix[i][j]);
            add(to, other[i], other[j], matrix[i][j]);
        }
}

static whirl_status build(const key_value *values, assembly *to, element *out) {
    const double kxx = values[KXX].number, kyy = values[KYY].given ? values[KYY].number : kxx;
    const double cxx = values[CXX].number, cyy = values[CYY].given ? values[CYY].number : cxx;
    const double stiffness[2][2] = {{kxx, values[KXY].number}, {values[KYX].number, kyy}};
    const double damping[2][2] = {{cxx, values[CXY].number}, {values[CYX].number, cyy}};
    size_t one[2], other[2] = {NO_COORDINATE, NO_COORDINATE};
    (void)out;
    whirl_status status = assembly_find_plane(to, values[AT].station[0], one);
    if (status.code == WHIRL_OK && values[FROM].given) status = assembly_find_plane(to, values[FROM].station[0], other);
    if (status.code != WHIRL_OK) return status;
    if (values[FROM].given && values[FROM].station[0] == values[AT].station[0])
        return whirl_fail(WHIRL_BAD_INPUT, "stands between a station and itself, expected another station");
    add_block(to, assembly_stiffness, one, other, stiffness);
    add_block(to, assembly_damping, one, other, damping);
    return whirl_ok();
}

const element_type bearing_element = {
    .group = {"bearing", "a linear bearing or seal by its eight coefficients", "Lund 1964; ISO 7902", keys, KEY_COUNT,
              NULL},
    .build = build,
};
#endif
