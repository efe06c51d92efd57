// A linear bearing or seal: eight coefficients between a station and the ground, or another station, and the inertia of
// its fluid. They are constant, or tables over the speed and the frequency of whirl. In motions a rational function
// replaces a table over the frequency.
#define KERNEL_FILE "elements/supports/bearing_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 16 // two for each axis and pair
#define KERNEL_FEWER_STATES
#define KERNEL_NUMBERS BEARING_NUMBERS
#define KERNEL_SWITCHES 0

/// Numbers of a pair of poles: w and g divided by the clock; then E and F, newtons per length scale.
enum { PAIR_W, PAIR_G, PAIR_PLACE, PAIR_RATE = PAIR_PLACE + 4, PAIR_NUMBERS = PAIR_RATE + 4 };

/// The law is the number of pairs. Numbers: the bearing's offset in length scales; then for the report of the fit, its
/// error at the table's frequencies, its error at these and half way between, the frequency of that error in rad/s, and
/// the stiffness at rest, N/m.
enum {
    MAX_PAIRS = 4,
    BEARING_SIDEWAYS = 0,
    BEARING_ELEVATION,
    BEARING_PAIRS,
    BEARING_ERROR_AT = BEARING_PAIRS + MAX_PAIRS * PAIR_NUMBERS,
    BEARING_ERROR,
    BEARING_WORST,
    BEARING_REST,
    BEARING_NUMBERS = BEARING_REST + 4
};

#include "generic.h"
#include "rational_fit.h"
#include "registry.h"
#include "table.h"

const element_kernels ISA(bearing_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>
#include <stdio.h>
#include <string.h>

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
    SIDEWAYS,
    ROLE,
    POLES,
    FIT_ERROR,
    WHIRL_RATIO,
    KEY_COUNT
};

#define STIFFNESS(name, symbol, fallback, text)                                                                        \
    { name, symbol, "N/m", WHIRL_KEY_NUMBERS, false, fallback, WHIRL_ANY, NULL, text, "", NULL }
#define DAMPING(name, symbol, fallback, text)                                                                          \
    { name, symbol, "N s/m", WHIRL_KEY_NUMBERS, false, fallback, WHIRL_ANY, NULL, text, "", NULL }
#define INERTIA(name, symbol, fallback, text)                                                                          \
    { name, symbol, "kg", WHIRL_KEY_NUMBERS, false, fallback, WHIRL_ANY, NULL, text, "", NULL }

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station that it carries"),
    [FROM] = STATION_KEY("from", OPTIONAL, "station of the housing; absent: the ground"),
    [SPEEDS] = CITED_NUMBERS_KEY("speeds", "", "rad/s", OPTIONAL, WHIRL_NOT_NEGATIVE,
                                 "rising speeds of coefficients that are lists; monotone cubics between them",
                                 "Fritsch, Butland 1984"),
    [FREQUENCIES] = CITED_NUMBERS_KEY(
        "frequencies", "", "rad/s", OPTIONAL, WHIRL_NOT_NEGATIVE,
        "rising frequencies of whirl of coefficients that are lists; with speeds one list for each speed",
        "Parsell, Allaire, Barrett 1983"),
    [KXX] = STIFFNESS("kxx", "k_xx", "0", "stiffness along x"),
    [KXY] = STIFFNESS("kxy", "k_xy", "0", "force along -x by a displacement along y"),
    [KYX] = STIFFNESS("kyx", "k_yx", "0", "force along -y by a displacement along x"),
    [KYY] = STIFFNESS("kyy", "k_yy", "", "stiffness along y; absent: kxx"),
    [CXX] = DAMPING("cxx", "c_xx", "0", "damping along x"),
    [CXY] = DAMPING("cxy", "c_xy", "0", "force along -x by a velocity along y"),
    [CYX] = DAMPING("cyx", "c_yx", "0", "force along -y by a velocity along x"),
    [CYY] = DAMPING("cyy", "c_yy", "", "damping along y; absent: cxx"),
    [MXX] = INERTIA("mxx", "m_xx", "0", "inertia along x, as of a fluid; without weight or unbalance"),
    [MXY] = INERTIA("mxy", "m_xy", "0", "force along -x by an acceleration along y, and the other way round"),
    [MYY] = INERTIA("myy", "m_yy", "", "inertia along y; absent: mxx"),
    [ELEVATION] = NUMBER_KEY("elevation", "", "m", DEFAULT("0"), WHIRL_ANY,
                             "height of the bearing's centre above the line of the other bearings: alignment"),
    [SIDEWAYS] = NUMBER_KEY("sideways", "", "m", DEFAULT("0"), WHIRL_ANY,
                            "displacement of the bearing's centre from that line along x"),
    [ROLE] = CHOICE_KEY("role", DEFAULT("bearing"), "bearing|seal|impeller|other",
                        "kind of part: critical speed maps replace bearings by springs, leave out seals and impellers, "
                        "and keep others"),
    [POLES] = {"poles", "n", "1", WHIRL_KEY_WHOLE, false, "4", WHIRL_FROM_TO(0, 2 * MAX_PAIRS), NULL,
               "even number n of poles of the rational function that replaces tables over frequencies in motions; "
               "fewer if the table has fewer than n + 2 frequencies",
               "Gustavsen, Semlyen 1999", NULL},
    [FIT_ERROR] = NUMBER_KEY("fit_error", "", "1", DEFAULT("0.02"), WHIRL_POSITIVE,
                             "largest accepted error of that function relative to the table, at its frequencies and "
                             "half way between; beyond it motions are refused"),
    [WHIRL_RATIO] = NUMBER_KEY("whirl_ratio", "", "1", OPTIONAL, WHIRL_NOT_NEGATIVE,
                               "frequency of whirl over the speed at which the coefficients hold, for tilting pads; "
                               "studies at another ratio have a warning"),
};

/// Adds the matrix of one kind between two places, with the function `add`.
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

/// Adds the matrix of inertia, which is symmetric: a number stands for two places.
static void add_inertia(assembly *to, const size_t port[4], double xx, double xy, double yy) {
    const size_t *one = port, *other = port + 2;
    assembly_inerter(to, one[0], other[0], xx);
    assembly_inerter(to, one[1], other[1], yy);
    assembly_inertance(to, one[0], one[1], xy);
    assembly_inertance(to, other[0], other[1], xy);
    assembly_inertance(to, one[0], other[1], -xy);
    assembly_inertance(to, one[1], other[0], -xy);
}

/// Checks that an axis of the tables has at least two ascending places.
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

/// Checks that the rotor's speed is within the tables.
static whirl_status check_speed(const key_value *speeds, double speed) {
    if (!speeds->given) return whirl_ok();
    const double low = speeds->list[0], high = speeds->list[speeds->count - 1], rpm = 60.0 / 6.28318530717958647692;
    // The ends of tables are rounded: 4000 rpm may be outside by a part of 1e12.
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

/// Checks that the list of a coefficient fits the axes: along the only axis; or for every speed a row along the
/// frequencies.
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
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu %s at %zu %s, expected equal numbers", columns, name, last->count,
                          frequencies->given ? "frequencies" : "speeds");
    return whirl_ok();
}

/// Finds the coefficient at the rotor's speed and a frequency of whirl, from its list or its constant.
static whirl_status look_up(const key_value *values, int key, double speed, double frequency, double *out) {
    const key_value *value = &values[key], *speeds = &values[SPEEDS], *frequencies = &values[FREQUENCIES];
    double at_speeds[WHIRL_MAX_LIST] = {0.0};
    *out = value->number;
    if (value->count == 0) return whirl_ok();
    const whirl_status status = check_shape(values, key);
    if (status.code != WHIRL_OK) return status;
    const double *row = value->list;
    for (size_t i = 0; i < value->rows && frequencies->given; i++, row += frequencies->count)
        at_speeds[i] = table_value(frequencies->count, frequencies->list, row, within(frequencies, frequency));
    if (!speeds->given)
        *out = at_speeds[0];
    else
        *out = table_value(speeds->count, speeds->list, frequencies->given ? at_speeds : value->list,
                           within(speeds, speed));
    return whirl_ok();
}

/// Coefficients, row by row; the inertia is xx, xy, yy.
typedef struct coefficients {
    double stiffness[2][2], damping[2][2], inertia[3];
} coefficients;

static whirl_status look_up_all(const key_value *values, double speed, double frequency, coefficients *out) {
    double at[KEY_COUNT];
    for (int key = KXX; key <= MYY; key++) {
        const whirl_status status = look_up(values, key, speed, frequency, &at[key]);
        if (status.code != WHIRL_OK) return status;
    }
    *out = (coefficients){.stiffness = {{at[KXX], at[KXY]}, {at[KYX], at[values[KYY].given ? KYY : KXX]}},
                          .damping = {{at[CXX], at[CXY]}, {at[CYX], at[values[CYY].given ? CYY : CXX]}},
                          .inertia = {at[MXX], at[MXY], at[values[MYY].given ? MYY : MXX]}};
    return whirl_ok();
}

/// Returns true if a coefficient varies with the frequency.
static bool whirls(const key_value *values) {
    const size_t columns = values[FREQUENCIES].count;
    bool varies = false;
    for (int key = KXX; key <= MYY && values[FREQUENCIES].given; key++)
        for (size_t i = 0; i < values[key].count; i++)
            varies = varies || values[key].list[i] != values[key].list[i - i % columns];
    return varies;
}

/// Checks the axes of the tables, and that the rotor's speed is within them.
static whirl_status check_tables(const key_value *values, assembly *to) {
    const key_value *frequencies = &values[FREQUENCIES];
    bool varies = false;
    whirl_status status = check_axis(&values[SPEEDS], "speeds");
    if (status.code == WHIRL_OK) status = check_axis(frequencies, "frequencies");
    if (status.code == WHIRL_OK) status = check_speed(&values[SPEEDS], to->speed);
    if (values[POLES].number != 2.0 * floor(0.5 * values[POLES].number))
        status = whirl_fail(WHIRL_BAD_INPUT, "has %g poles, expected an even number", values[POLES].number);
    if (status.code == WHIRL_OK && !frequencies->given && (values[POLES].given || values[FIT_ERROR].given))
        status = whirl_fail(WHIRL_BAD_INPUT,
                            "has %s and no frequencies, expected a table over frequencies, to which it applies",
                            values[POLES].given ? "poles" : "a fit_error");
    for (int key = KXX; key <= MYY; key++) varies = varies || values[key].count > 0;
    if (status.code == WHIRL_OK && !varies && (values[SPEEDS].given || frequencies->given))
        status = whirl_fail(WHIRL_BAD_INPUT, "has %s and no list of a coefficient over them, expected one",
                            frequencies->given ? "frequencies" : "speeds");
    if (status.code != WHIRL_OK || !frequencies->given || !varies || to->in_time) return status;
    return assembly_frequencies(to, frequencies->count, frequencies->list);
}

/// Checks that both ends are on shafts of the rotor's speed if coefficients are over speeds, since they are looked up
/// at the rotor's speed.
static whirl_status check_ends(const key_value *values, const assembly *to) {
    for (int end = AT; end <= FROM && values[SPEEDS].given; end++) {
        const size_t station = values[end].given ? values[end].station[0] : GROUND;
        if (station == GROUND || !assembly_is_aside(to, station)) continue;
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has speeds, which are the rotor's, and acts at station '%s' on a shaft of another speed, "
                          "expected coefficients without speeds",
                          to->stations[station].name);
    }
    return whirl_ok();
}

/// Adds the force K e with e = (sideways, elevation) on the station, and the opposite on the housing.
static void add_offset(assembly *to, const size_t port[4], const double matrix[2][2], const double offset[2]) {
    for (size_t i = 0; i < 4; i++) {
        const double *row = matrix[i % 2], force = row[0] * offset[0] + row[1] * offset[1];
        if (port[i] == NO_COORDINATE || force == 0.0) continue;
        const double term = (i < 2 ? force : -force) / assembly_force_scale(to, port[i]);
        assembly_term(to, (linear_term){port[i], SOURCE_ONE, 0, term});
    }
}

static void add_coefficients(const key_value *values, const coefficients *at, assembly *to, const element *out) {
    add_block(to, assembly_stiffness, out->port, at->stiffness);
    add_offset(to, out->port, at->stiffness, (const double[2]){values[SIDEWAYS].number, values[ELEVATION].number});
    add_block(to, assembly_damping, out->port, at->damping);
    add_inertia(to, out->port, at->inertia[0], at->inertia[1], at->inertia[2]);
}

// ---------------------------------------------------------------- in time

/// Samples the table as K - w^2 (M - mean M) + i w C.
static whirl_status sample(const key_value *values, double speed, double frequency, const double inertia[3],
                           rational_sample *out) {
    coefficients at;
    const whirl_status status = look_up_all(values, speed, frequency, &at);
    for (size_t e = 0; e < RATIONAL_ENTRIES && status.code == WHIRL_OK; e++) {
        const size_t m = e / 2 + e % 2;
        out->entry[e][0] = at.stiffness[e / 2][e % 2] - frequency * frequency * (at.inertia[m] - inertia[m]);
        out->entry[e][1] = frequency * at.damping[e / 2][e % 2];
    }
    return status;
}

/// Computes the mean inertia over the frequencies.
static whirl_status mean_inertia(const key_value *values, double speed, double mean[3]) {
    const key_value *frequencies = &values[FREQUENCIES];
    whirl_status status = whirl_ok();
    mean[0] = mean[1] = mean[2] = 0.0;
    for (size_t i = 0; i < frequencies->count && status.code == WHIRL_OK; i++) {
        coefficients at;
        status = look_up_all(values, speed, frequencies->list[i], &at);
        for (size_t m = 0; m < 3 && status.code == WHIRL_OK; m++) mean[m] += at.inertia[m] / (double)frequencies->count;
    }
    return status;
}

/// Samples the table at all frequencies, out [frequencies].
static whirl_status sample_all(const key_value *values, double speed, double inertia[3], rational_sample *out) {
    const key_value *frequencies = &values[FREQUENCIES];
    whirl_status status = mean_inertia(values, speed, inertia);
    for (size_t i = 0; i < frequencies->count && status.code == WHIRL_OK; i++)
        status = sample(values, speed, frequencies->list[i], inertia, &out[i]);
    return status;
}

/// Computes the relative error of the function at the table's frequencies, and half way between them.
static whirl_status bearing_compare(const key_value *values, double speed, const rational_fit *fit,
                                    const double inertia[3], double *number) {
    const key_value *frequencies = &values[FREQUENCIES];
    whirl_status status = whirl_ok();
    number[BEARING_ERROR_AT] = number[BEARING_ERROR] = 0.0;
    number[BEARING_WORST] = frequencies->list[0];
    for (size_t i = 0; i + 1 < 2 * frequencies->count && status.code == WHIRL_OK; i++) {
        const double w = 0.5 * (frequencies->list[i / 2] + frequencies->list[(i + 1) / 2]);
        rational_sample table, apart = rational_fit_value(fit, w);
        status = sample(values, speed, w, inertia, &table);
        if (status.code != WHIRL_OK) break;
        for (int e = 0; e < RATIONAL_ENTRIES; e++)
            for (int part = 0; part < 2; part++) apart.entry[e][part] -= table.entry[e][part];
        const double size = rational_size(&table), part = size > 0.0 ? rational_size(&apart) / size : 0.0;
        const double own = isfinite(part) ? part : INFINITY;
        if (own > number[BEARING_ERROR]) number[BEARING_WORST] = w;
        number[BEARING_ERROR] = fmax(number[BEARING_ERROR], own);
        if (i % 2 == 0) number[BEARING_ERROR_AT] = fmax(number[BEARING_ERROR_AT], own);
    }
    return status;
}

/// Returns the number of pairs of poles: those wanted, but at most as many as the table can determine.
static size_t pair_count(const key_value *values) {
    const size_t wanted = (size_t)values[POLES].number / 2, most = values[FREQUENCIES].count / 2 - 1;
    return wanted < most ? wanted : most;
}

/// Checks that the table reaches the rotor's own speed.
static whirl_status check_top(const key_value *values, const assembly *to) {
    const key_value *frequencies = &values[FREQUENCIES];
    const double top = frequencies->list[frequencies->count - 1];
    if (to->speed <= top * (1.0 + 1e-9)) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT,
                      "is known at frequencies of whirl from %g to %g rad/s, and the rotor turns at %g rad/s, which is "
                      "the frequency of synchronous motions",
                      frequencies->list[0], top, to->speed);
}

static whirl_status check_error(const key_value *values, size_t pairs, double error, double worst) {
    if (error <= values[FIT_ERROR].number) return whirl_ok();
    return whirl_fail(
        WHIRL_BAD_INPUT,
        "differs from its table by %.3g %% at %.4g rad/s with the rational function of %zu poles that "
        "replaces the table in motions, expected at most fit_error, %.3g %%: more poles, closer frequencies or a "
        "larger fit_error",
        100.0 * error, worst, 2 * pairs, 100.0 * values[FIT_ERROR].number);
}

/// Fits the rational function. All speeds of the table (or a selection of them) share the poles of the function, so
/// that it is as smooth over the speed as the table. Its other numbers are fitted at the machine's own speed.
static whirl_status find_function(const key_value *values, double speed, double inertia[3], rational_fit *fit) {
    rational_sample samples[(size_t)RATIONAL_MAX_SETS * RATIONAL_MAX_SAMPLES];
    const key_value *frequencies = &values[FREQUENCIES], *speeds = &values[SPEEDS];
    const size_t pairs = pair_count(values), most = speeds->given ? speeds->count : 1;
    const size_t sets = most < RATIONAL_MAX_SETS ? most : RATIONAL_MAX_SETS, count = frequencies->count;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < sets && status.code == WHIRL_OK; i++)
        status = sample_all(values, speeds->given ? speeds->list[i * (most - 1) / (sets > 1 ? sets - 1 : 1)] : speed,
                            inertia, samples + i * count);
    if (status.code != WHIRL_OK) return status;
    bool found = rational_fit_poles(sets, count, frequencies->list, samples, pairs, fit);
    status = sample_all(values, speed, inertia, samples);
    if (status.code == WHIRL_OK && found) found = rational_fit_numbers(count, frequencies->list, samples, fit);
    if (status.code != WHIRL_OK || found) return status;
    return whirl_fail(WHIRL_BAD_INPUT, "has a table that no rational function of %zu poles comes near", 2 * pairs);
}

static whirl_status make_fit(const key_value *values, const assembly *to, coefficients *rest, rational_fit *fit,
                             element *out) {
    double *number = out->number;
    whirl_status status = check_top(values, to);
    if (status.code == WHIRL_OK) status = find_function(values, to->speed, rest->inertia, fit);
    if (status.code == WHIRL_OK) status = bearing_compare(values, to->speed, fit, rest->inertia, number);
    if (status.code == WHIRL_OK)
        status = check_error(values, fit->pair_count, number[BEARING_ERROR], number[BEARING_WORST]);
    for (size_t e = 0; e < RATIONAL_ENTRIES && status.code == WHIRL_OK; e++) {
        rest->stiffness[e / 2][e % 2] = number[BEARING_REST + e] = fit->constant[e];
        rest->damping[e / 2][e % 2] = fit->slope[e];
        for (size_t j = 0; j < fit->pair_count; j++) number[BEARING_REST + e] += fit->pairs[j].place[e];
    }
    return status;
}

/// Builds the function. Its constant and slope are ordinary coefficients; pairs of poles have states.
static whirl_status build_in_time(const key_value *values, assembly *to, element *out) {
    rational_fit fit;
    coefficients rest;
    _Static_assert((int)MAX_PAIRS == (int)RATIONAL_MAX_PAIRS && (int)WHIRL_MAX_LIST <= (int)RATIONAL_MAX_SAMPLES &&
                       KERNEL_STATES == 2 * KERNEL_AXES * (int)MAX_PAIRS,
                   "a fit has room for a table");
    const whirl_status status = make_fit(values, to, &rest, &fit, out);
    if (status.code != WHIRL_OK) return status;
    // Add the constant and slope of the function to the assembly, as ordinary coefficients.
    add_coefficients(values, &rest, to, out);
    out->lumped = false;
    out->law = (int)fit.pair_count;
    out->states = fit.pair_count * 2 * KERNEL_AXES;
    out->number[BEARING_SIDEWAYS] = values[SIDEWAYS].number / to->length;
    out->number[BEARING_ELEVATION] = values[ELEVATION].number / to->length;
    // Convert the pairs of poles to units of the clock and the length scale.
    for (size_t j = 0; j < fit.pair_count; j++) {
        double *own = out->number + BEARING_PAIRS + j * PAIR_NUMBERS;
        own[PAIR_W] = fit.pairs[j].w / to->clock;
        own[PAIR_G] = fit.pairs[j].g / to->clock;
        for (size_t e = 0; e < RATIONAL_ENTRIES; e++) {
            own[PAIR_PLACE + e] = fit.pairs[j].place[e] * to->length;
            own[PAIR_RATE + e] = fit.pairs[j].rate[e] * to->length;
        }
    }
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

static whirl_status bearing_build(const key_value *values, assembly *to, element *out) {
    coefficients at = {.inertia = {0.0}};
    out->lumped = true;
    out->states = 0;
    whirl_status status = check_tables(values, to);
    if (status.code == WHIRL_OK) status = look_up_all(values, to->speed, to->frequency, &at);
    if (status.code == WHIRL_OK) status = check_ends(values, to);
    if (status.code == WHIRL_OK) status = element_in_housing(&values[AT], &values[FROM], to, out);
    if (status.code != WHIRL_OK) return status;
    if (to->in_time && whirls(values)) return build_in_time(values, to, out);
    // No coefficient varies with the frequency. Use the first frequency of the table, at which nothing is interpolated.
    if (to->in_time && values[FREQUENCIES].given)
        status = look_up_all(values, to->speed, values[FREQUENCIES].list[0], &at);
    add_coefficients(values, &at, to, out);
    return status;
}

static void bearing_doubt(const key_value *values, double speed, const doubt_teller *to) {
    (void)speed;
    if (values[WHIRL_RATIO].given && !values[FREQUENCIES].given)
        doubt_value(
            to, keys[WHIRL_RATIO].name,
            "is %g: tilting pads respond differently at other frequencies, so that modes, thresholds of "
            "stability and motions with another frequency than %g times the speed are those of another bearing; "
            "whirl bearing --table --over-frequency writes coefficients for all, and tilting_pad has them",
            values[WHIRL_RATIO].number, values[WHIRL_RATIO].number);
}

/// Writes the poles of a pair: "-120 +- 400i" or "-30, -900".
static void tell_poles(const double *pair, double clock, char *text, size_t size) {
    const double w = clock * pair[PAIR_W], half = 0.5 * clock * pair[PAIR_G], square = half * half - w * w;
    const double root = sqrt(fabs(square));
    if (square < 0.0)
        snprintf(text, size, "%.4g +- %.4gi", -half, root);
    else
        snprintf(text, size, "%.4g, %.4g", -w * w / (half + root), -half - root);
}

static void bearing_note(const element *own, double length, double clock, char *text, size_t size) {
    const double *number = own->number, *rest = number + BEARING_REST;
    const double turn = 6.283185307179586476925;
    size_t used = (size_t)snprintf(
        text, size,
        "in time %d poles, off its table by %.2g %% at its frequencies, %.2g %% half way between (at %.4g Hz)",
        2 * own->law, 100.0 * number[BEARING_ERROR_AT], 100.0 * number[BEARING_ERROR], number[BEARING_WORST] / turn);
    (void)length;
    for (size_t j = 0; j < (size_t)own->law && used < size; j++) {
        char poles[64];
        tell_poles(number + BEARING_PAIRS + j * PAIR_NUMBERS, clock, poles, sizeof poles);
        used += (size_t)snprintf(text + used, size - used, "%s%s%s", j == 0 ? ": " : ", ", poles,
                                 j + 1 == (size_t)own->law ? " 1/s" : "");
    }
    if (used < size)
        snprintf(text + used, size - used, "; at rest kxx %.4g N/m, kxy %.4g N/m, kyx %.4g N/m, kyy %.4g N/m", rest[0],
                 rest[1], rest[2], rest[3]);
}

KERNELS_OF_EVERY_ISA(bearing_kernels);

const element_type bearing_element = {
    .group = {"bearing", "a linear bearing or seal by its eight coefficients and inertia", "Lund 1964; ISO 7902", keys,
              KEY_COUNT, NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .kernels = kernels,
    .build = bearing_build,
    .carries = true,
    .note = bearing_note,
    .doubt = bearing_doubt,
};
#endif
