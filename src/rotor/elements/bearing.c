// A linear bearing or seal: eight coefficients between a station and the ground, or another station, and the inertia of
// what moves in it; constant, or of the speed by a table.
#include "registry.h"
#include "table.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { AT, FROM, SPEEDS, KXX, KXY, KYX, KYY, CXX, CXY, CYX, CYY, MXX, MXY, MYY, ROLE, KEY_COUNT };

#define STIFFNESS(name, symbol, fallback, text)                                                                        \
    { name, symbol, "N/m", WHIRL_KEY_NUMBERS, false, fallback, WHIRL_ANY, NULL, text, "" }
#define DAMPING(name, symbol, fallback, text)                                                                          \
    { name, symbol, "N s/m", WHIRL_KEY_NUMBERS, false, fallback, WHIRL_ANY, NULL, text, "" }
#define INERTIA(name, symbol, fallback, text)                                                                          \
    { name, symbol, "kg", WHIRL_KEY_NUMBERS, false, fallback, WHIRL_ANY, NULL, text, "" }

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station that it carries"),
    [FROM] = STATION_KEY("from", OPTIONAL, "station of its housing; the ground where absent"),
    [SPEEDS] =
        CITED_NUMBERS_KEY("speeds", "", "rad/s", OPTIONAL, WHIRL_NOT_NEGATIVE,
                          "speeds, rising, at which coefficients are given as lists; between them monotone cubics",
                          "Fritsch, Butland 1984"),
    [KXX] = STIFFNESS("kxx", "k_xx", "0", "stiffness along x"),
    [KXY] = STIFFNESS("kxy", "k_xy", "0", "force along -x by a displacement along y"),
    [KYX] = STIFFNESS("kyx", "k_yx", "0", "force along -y by a displacement along x"),
    [KYY] = STIFFNESS("kyy", "k_yy", "", "stiffness along y; kxx where absent"),
    [CXX] = DAMPING("cxx", "c_xx", "0", "damping along x"),
    [CXY] = DAMPING("cxy", "c_xy", "0", "force along -x by a velocity along y"),
    [CYX] = DAMPING("cyx", "c_yx", "0", "force along -y by a velocity along x"),
    [CYY] = DAMPING("cyy", "c_yy", "", "damping along y; cxx where absent"),
    [MXX] = INERTIA("mxx", "m_xx", "0", "inertia along x, as of a fluid; without weight or unbalance"),
    [MXY] = INERTIA("mxy", "m_xy", "0", "force along -x by an acceleration along y, and the other way round"),
    [MYY] = INERTIA("myy", "m_yy", "", "inertia along y; mxx where absent"),
    [ROLE] = CHOICE_KEY(
        "role", DEFAULT("bearing"), "bearing|seal|impeller|other",
        "what its coefficients are of: critical speed maps have springs in the place of bearings, leave seals "
        "and impellers out, and keep others"),
};

/// The block of one kind, by `add`, between two places.
static void add_block(assembly *to, void (*add)(assembly *, size_t, size_t, double), const size_t port[4],
                      const double matrix[2][2]) {
    const size_t *one = port, *other = port + 2;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            add(to, one[i], one[j], matrix[i][j]);
            add(to, one[i], other[j], -matrix[i][j]);
            add(to, other[i], one[j], -matrix[i][j]);
            add(to, other[i], other[j], matrix[i][j]);
        }
}

/// The same of the inertia, which is symmetric, and of which an entry stands for its mirror image as well.
static void add_inertia(assembly *to, const size_t port[4], double xx, double xy, double yy) {
    const size_t *one = port, *other = port + 2;
    assembly_inerter(to, one[0], other[0], xx);
    assembly_inerter(to, one[1], other[1], yy);
    assembly_inertance(to, one[0], one[1], xy);
    assembly_inertance(to, other[0], other[1], xy);
    assembly_inertance(to, one[0], other[1], -xy);
    assembly_inertance(to, one[1], other[0], -xy);
}

/// Two speeds or more that rise, and the rotor's between them.
static whirl_status check_speeds(const key_value *speeds, double speed) {
    if (!speeds->given) return whirl_ok();
    if (speeds->count < 2) return whirl_fail(WHIRL_BAD_INPUT, "has one speed, expected a list of two or more");
    for (size_t i = 1; i < speeds->count; i++)
        if (!(speeds->list[i - 1] < speeds->list[i]))
            return whirl_fail(WHIRL_BAD_INPUT, "has speeds that do not rise: %g rad/s after %g rad/s", speeds->list[i],
                              speeds->list[i - 1]);
    const double low = speeds->list[0], high = speeds->list[speeds->count - 1], rpm = 60.0 / 6.28318530717958647692;
    // The ends of tables are rounded: 4000 rpm may lie beyond one by a part of 1e12.
    static const double rounding = 1e-9;
    if (speed < low * (1.0 - rounding) || speed > high * (1.0 + rounding))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "is known from %g to %g rad/s (%g to %g rpm), and the rotor turns at %g rad/s (%g rpm)", low,
                          high, low * rpm, high * rpm, speed, speed * rpm);
    return whirl_ok();
}

/// The coefficient at the rotor's speed: out of its list, or the same at all.
static whirl_status find_at_speed(const key_value *values, int key, double speed, double *out) {
    const key_value *value = &values[key], *speeds = &values[SPEEDS];
    *out = value->number;
    if (value->count == 0) return whirl_ok();
    if (!speeds->given)
        return whirl_fail(WHIRL_BAD_INPUT, "has a list of %s without speeds, expected the speeds as well",
                          keys[key].name);
    if (value->count != speeds->count)
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu %s at %zu speeds, expected as many", value->count, keys[key].name,
                          speeds->count);
    const double low = speeds->list[0], high = speeds->list[speeds->count - 1];
    *out = table_value(speeds->count, speeds->list, value->list, fmin(fmax(speed, low), high));
    return whirl_ok();
}

/// Coefficients over speeds are looked up at the rotor's.
static whirl_status check_ends(const key_value *values, const assembly *to) {
    for (int end = AT; end <= FROM && values[SPEEDS].given; end++) {
        const size_t station = values[end].given ? values[end].station[0] : GROUND;
        if (station == GROUND || to->stations[station].ratio == 1.0) continue;
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has speeds, which are the rotor's, and acts at station '%s' on a shaft of another speed, "
                          "expected coefficients without speeds",
                          to->stations[station].name);
    }
    return whirl_ok();
}

static whirl_status build(const key_value *values, assembly *to, element *out) {
    double at[KEY_COUNT];
    whirl_status status = check_speeds(&values[SPEEDS], to->speed);
    for (int key = KXX; key <= MYY && status.code == WHIRL_OK; key++)
        status = find_at_speed(values, key, to->speed, &at[key]);
    if (status.code != WHIRL_OK) return status;
    const double stiffness[2][2] = {{at[KXX], at[KXY]}, {at[KYX], at[values[KYY].given ? KYY : KXX]}};
    const double damping[2][2] = {{at[CXX], at[CXY]}, {at[CYX], at[values[CYY].given ? CYY : CXX]}};
    status = check_ends(values, to);
    if (status.code == WHIRL_OK) status = element_in_housing(&values[AT], &values[FROM], to, out);
    if (status.code != WHIRL_OK) return status;
    add_block(to, assembly_stiffness, out->port, stiffness);
    add_block(to, assembly_damping, out->port, damping);
    add_inertia(to, out->port, at[MXX], at[MXY], at[values[MYY].given ? MYY : MXX]);
    return whirl_ok();
}

const element_type bearing_element = {
    .group = {"bearing", "a linear bearing or seal by its eight coefficients and inertia", "Lund 1964; ISO 7902", keys,
              KEY_COUNT, NULL, NULL},
    .build = build,
    .carries = true,
};
#endif
