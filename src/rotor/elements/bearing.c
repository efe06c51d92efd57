// A linear bearing or seal: eight coefficients between a station and the ground, or another station, and the inertia of
// what moves in it; constant, or of the speed and the frequency of whirl by a table.
#include "registry.h"
#include "table.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum {
    AT,
    FROM,
    SPEEDS,
    FREQUENCIES,
    KXX,
    KXY,
    KYX,
    KYY,
    CXX,
    CXY,
    CYX,
    CYY,
    MXX,
    MXY,
    MYY,
    ELEVATION,
    ROLE,
    KEY_COUNT
};

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
    [FREQUENCIES] = CITED_NUMBERS_KEY(
        "frequencies", "", "rad/s", OPTIONAL, WHIRL_NOT_NEGATIVE,
        "frequencies of whirl, rising, at which coefficients are given as lists; with speeds a list for each of these",
        "Parsell, Allaire, Barrett 1983"),
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
    [ELEVATION] = NUMBER_KEY("elevation", "", "m", DEFAULT("0"), WHIRL_ANY,
                             "of its centre along y, above where it would lie in line: what alignment changes"),
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

/// Two places or more of an axis of the tables, that rise.
static whirl_status check_axis(const key_value *along, const char *name) {
    if (!along->given) return whirl_ok();
    if (along->rows > 1) return whirl_fail(WHIRL_BAD_INPUT, "has lists of %s, expected a single list", name);
    if (along->count < 2)
        return whirl_fail(WHIRL_BAD_INPUT, "has a single number of %s, expected a list of two or more", name);
    for (size_t i = 1; i < along->count; i++)
        if (!(along->list[i - 1] < along->list[i]))
            return whirl_fail(WHIRL_BAD_INPUT, "has %s that do not rise: %g rad/s after %g rad/s", name, along->list[i],
                              along->list[i - 1]);
    return whirl_ok();
}

/// The rotor's speed lies between those of the tables.
static whirl_status check_speed(const key_value *speeds, double speed) {
    if (!speeds->given) return whirl_ok();
    const double low = speeds->list[0], high = speeds->list[speeds->count - 1], rpm = 60.0 / 6.28318530717958647692;
    // The ends of tables are rounded: 4000 rpm may lie beyond one by a part of 1e12.
    static const double rounding = 1e-9;
    if (speed < low * (1.0 - rounding) || speed > high * (1.0 + rounding))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "is known from %g to %g rad/s (%g to %g rpm), and the rotor turns at %g rad/s (%g rpm)", low,
                          high, low * rpm, high * rpm, speed, speed * rpm);
    return whirl_ok();
}

static double within(const key_value *along, double at) {
    return fmin(fmax(at, along->list[0]), along->list[along->count - 1]);
}

/// Lists that say a coefficient fit the axes: one over the only axis, or for every speed one over the frequencies.
static whirl_status check_shape(const key_value *values, int key) {
    const key_value *value = &values[key], *speeds = &values[SPEEDS], *frequencies = &values[FREQUENCIES];
    const char *name = keys[key].name;
    const key_value *last = frequencies->given ? frequencies : speeds;
    const size_t rows = speeds->given && frequencies->given ? speeds->count : 1, columns = value->count / value->rows;
    if (!last->given)
        return whirl_fail(WHIRL_BAD_INPUT, "has a list of %s without speeds, expected the speeds as well", name);
    if (value->rows != rows && rows > 1)
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu list%s of %s at %zu speeds, expected a list for each", value->rows,
                          value->rows == 1 ? "" : "s", name, rows);
    if (value->rows != rows)
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu lists of %s without %s, expected one list", value->rows, name,
                          speeds->given ? "frequencies" : "speeds");
    if (columns != last->count)
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu %s at %zu %s, expected as many", columns, name, last->count,
                          frequencies->given ? "frequencies" : "speeds");
    return whirl_ok();
}

/// The coefficient at the rotor's speed and the frequency of whirl: out of its list, or the same at all.
static whirl_status look_up(const key_value *values, int key, const assembly *to, double *out) {
    const key_value *value = &values[key], *speeds = &values[SPEEDS], *frequencies = &values[FREQUENCIES];
    double at_speeds[WHIRL_MAX_LIST] = {0.0};
    *out = value->number;
    if (value->count == 0) return whirl_ok();
    const whirl_status status = check_shape(values, key);
    if (status.code != WHIRL_OK) return status;
    const double *row = value->list;
    for (size_t i = 0; i < value->rows && frequencies->given; i++, row += frequencies->count)
        at_speeds[i] = table_value(frequencies->count, frequencies->list, row, within(frequencies, to->frequency));
    if (!speeds->given)
        *out = at_speeds[0];
    else
        *out = table_value(speeds->count, speeds->list, frequencies->given ? at_speeds : value->list,
                           within(speeds, to->speed));
    return whirl_ok();
}

/// The axes of the tables, and that the rotor is within them.
static whirl_status check_tables(const key_value *values, assembly *to) {
    const key_value *frequencies = &values[FREQUENCIES];
    bool varies = false;
    whirl_status status = check_axis(&values[SPEEDS], "speeds");
    if (status.code == WHIRL_OK) status = check_axis(frequencies, "frequencies");
    if (status.code == WHIRL_OK) status = check_speed(&values[SPEEDS], to->speed);
    for (int key = KXX; key <= MYY; key++) varies = varies || values[key].count > 0;
    if (status.code != WHIRL_OK || !frequencies->given || !varies) return status;
    return assembly_frequencies(to, frequencies->count, frequencies->list);
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

/// K e, e = (0, elevation), on the station, and against it on the housing.
static void add_elevation(assembly *to, const size_t port[4], const double matrix[2][2], double elevation) {
    for (size_t i = 0; i < 4 && elevation != 0.0; i++)
        if (port[i] != NO_COORDINATE) {
            const double force = (i < 2 ? elevation : -elevation) * matrix[i % 2][1];
            assembly_term(to, (linear_term){port[i], SOURCE_ONE, 0, force / assembly_force_scale(to, port[i])});
        }
}

static whirl_status build(const key_value *values, assembly *to, element *out) {
    double at[KEY_COUNT];
    whirl_status status = check_tables(values, to);
    for (int key = KXX; key <= MYY && status.code == WHIRL_OK; key++) status = look_up(values, key, to, &at[key]);
    if (status.code != WHIRL_OK) return status;
    const double stiffness[2][2] = {{at[KXX], at[KXY]}, {at[KYX], at[values[KYY].given ? KYY : KXX]}};
    const double damping[2][2] = {{at[CXX], at[CXY]}, {at[CYX], at[values[CYY].given ? CYY : CXX]}};
    status = check_ends(values, to);
    if (status.code == WHIRL_OK) status = element_in_housing(&values[AT], &values[FROM], to, out);
    if (status.code != WHIRL_OK) return status;
    add_block(to, assembly_stiffness, out->port, stiffness);
    add_elevation(to, out->port, stiffness, values[ELEVATION].number);
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
