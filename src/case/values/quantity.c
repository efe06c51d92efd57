// Units by UDUNITS-2.
//
// UDUNITS treats the radian as dimensionless and reciprocals as convertible: 50 Hz would count as 50 rad/s, and 1 s as
// 1 Hz. Here a unit fits only when its quotient with the expected one is dimensionless and both or neither hold
// radians. UDUNITS keeps state of its own and is not thread-safe, hence the lock; the unit system is read once.
#include "quantity.h"

#include <ctype.h>
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <udunits2.h>

#include "exhausted.h"
#include "lock.h"
#include "number_text.h"
#include "problem.h"
#include "whirl/status.h"

enum { LONGEST_NUMBER = 60, LONGEST_UNIT = 60 };

static lock units_lock = LOCK_OPEN;
static ut_system *units; // guarded by units_lock

/// UDUNITS-2 reports missing memory by errno alone, and its lexer resets errno: failures are noted at once.
static bool no_memory; // guarded by units_lock

/// Notes a failure for lack of memory; returns `well`.
static bool note_memory(bool well) {
    if (!well && errno == ENOMEM) no_memory = true;
    return well;
}

/// A unit that engineers write and UDUNITS does not know, or not as they mean it.
typedef struct trade_unit {
    const char *name;
    double factor;
    const char *of;
} trade_unit;

/// UDUNITS reads "oz" as a fluid ounce, and has only 6 or 7 digits of ounces, slugs, horsepowers, poundals and gallons.
static const trade_unit trade_units[] = {
    {"deg", 1.0, "degree"},          {"cP", 1.0, "mPa.s"},
    {"lbm", 1.0, "pound"},           {"oz", 0.0625, "pound"},
    {"ozm", 0.0625, "pound"},        {"blob", 1.0, "lbf.s2/in"},
    {"thou", 1e-3, "inch"},          {"reyn", 1.0, "lbf.s/in2"},
    {"gpm", 231.0, "in3/minute"},    {"ips", 1.0, "in/s"},
    {"cpm", 1.0, "1/minute"},        {"slug", 1.0, "lbf.s2/ft"},
    {"slugs", 1.0, "lbf.s2/ft"},     {"ozf", 0.0625, "lbf"},
    {"hp", 550.0, "ft.lbf/s"},       {"horsepower", 550.0, "ft.lbf/s"},
    {"poundal", 1.0, "pound.ft/s2"}, {"gallon", 231.0, "in3"},
    {"gallons", 231.0, "in3"},
};

static void add_trade_unit(const trade_unit *own) {
    ut_unit *of = ut_parse(units, own->of, UT_ASCII), *unit = of ? ut_scale(own->factor, of) : NULL;
    ut_unmap_name_to_unit(units, own->name, UT_ASCII);
    if (unit) ut_map_name_to_unit(own->name, UT_ASCII, unit);
    ut_free(unit);
    ut_free(of);
}

static bool units_ready(void) {
    if (units) return true;
    ut_set_error_message_handler(ut_ignore);
    units = ut_read_xml(NULL);
    if (!note_memory(units != NULL)) return false;
    for (size_t i = 0; i < sizeof trade_units / sizeof *trade_units; i++) add_trade_unit(&trade_units[i]);
    return true;
}

/// Returns true if a text consists of products of names and powers. UDUNITS also reads numbers, dates and logarithms as
/// units, and overlooks a superfluous ')'.
static bool looks_like_unit(const char *text) {
    const size_t length = strlen(text);
    int open = 0;
    if (length == 0 || length > LONGEST_UNIT) return false;
    for (size_t i = 0; i < length; i++) {
        const unsigned char c = (unsigned char)text[i], before = i > 0 ? (unsigned char)text[i - 1] : ' ';
        const unsigned char after = (unsigned char)text[i + 1];
        // After a superscript or a raised dot UDUNITS reads digits as a factor.
        const bool raised = i > 1 && (unsigned char)text[i - 2] == 0xC2 && before && strchr("\xB2\xB3\xB7\xB9", before);
        const bool after_name = isalnum(before) || (before >= 0x80 && !raised) || before == '^' || before == '-';
        const bool whole = text[0] == '1' && text[1] == '/'; // "1/s"
        if (isdigit(c) && !after_name && !(whole && i == 0)) return false;
        if (c == '-' && !(after_name && !isdigit(before) && isdigit(after))) return false;
        if (!isalnum(c) && c < 0x80 && !strchr(" ./^*-()%", c)) return false;
        open += (c == '(') - (c == ')');
        if (open < 0) return false;
    }
    return strncmp(text, "lg(", 3) != 0 && strncmp(text, "ln(", 3) != 0 && strncmp(text, "lb(", 3) != 0 &&
           !strstr(text, " since") && !strstr(text, " after") && !strstr(text, " from") && !strstr(text, " ref");
}

static ut_unit *parse_unit(const char *text) {
    if (strcmp(text, "1") == 0) return ut_get_dimensionless_unit_one(units);
    ut_unit *unit = looks_like_unit(text) ? ut_parse(units, text, UT_UTF8) : NULL;
    note_memory(unit != NULL);
    return unit;
}

/// Reads the powers in "m2.kg.s-3"; other bases are ignored.
static void powers_of(const char *product, double powers[UNIT_BASES]) {
    static const char *const bases[UNIT_BASES] = {"m", "kg", "s"};
    for (const char *at = product; *at; at += strcspn(at, "."), at += *at == '.') {
        const size_t name = strspn(at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
        for (size_t i = 0; i < UNIT_BASES; i++)
            if (strlen(bases[i]) == name && strncmp(at, bases[i], name) == 0)
                powers[i] = at[name] == '.' || at[name] == '\0' ? 1.0 : strtod(at + name, NULL);
    }
}

static bool has_radian(const ut_unit *unit) {
    char text[256];
    const int length = ut_format(unit, text, sizeof text, UT_ASCII | UT_DEFINITION);
    note_memory(length >= 0);
    if (length < 0 || (size_t)length >= sizeof text) return false;
    return strstr(text, "rad") != NULL;
}

static bool same_dimension(const ut_unit *a, const ut_unit *b) {
    ut_unit *ratio = ut_divide(a, b);
    const bool same = note_memory(ratio != NULL) && ut_is_dimensionless(ratio);
    ut_free(ratio);
    return same && (ut_is_dimensionless(a) || has_radian(a) == has_radian(b));
}

/// Multiplies by 10^power by changing the decimal exponent of the text, so that 80 um, 0.08 mm and 8e-5 m become the
/// same double: a machine is the same to the bit in whichever of these units its lengths are written.
static double shift_decimals(double value, int power) {
    char text[NUMBER_SIZE], shifted[2 * NUMBER_SIZE];
    const char *end;
    number_text(value, text);
    char *exponent = strchr(text, 'e');
    const long own = exponent ? strtol(exponent + 1, NULL, 10) : 0;
    if (exponent) *exponent = '\0';
    snprintf(shifted, sizeof shifted, "%se%ld", text, own + power);
    return quantity_number(shifted, &value, &end) ? value : (double)NAN;
}

static bool convert(ut_unit *from, ut_unit *to, double *value) {
    cv_converter *converter = ut_get_converter(from, to);
    if (!note_memory(converter != NULL)) return false;
    const double one = cv_convert_double(converter, 1.0), exact = 4.0 * DBL_EPSILON;
    const int power = one > 0.0 ? (int)lround(log10(one)) : 0;
    const bool decimal = isfinite(*value) && cv_convert_double(converter, 0.0) == 0.0 && power != 0 &&
                         fabs(one / pow(10.0, power) - 1.0) <= exact;
    *value = decimal ? shift_decimals(*value, power) : cv_convert_double(converter, *value);
    cv_free(converter);
    return true;
}

/// SI units by the names that engineers know; others are written as products of base units. A torque is in N m: no
/// quantity of a rotor is an energy.
static const char *const si_units[] = {"m",    "kg", "s",     "rad",   "rad/s", "N",      "N/m",  "N s/m",
                                       "Pa s", "Pa", "m/s",   "m/s2",  "N m",   "W",      "kg m", "1/s",
                                       "m2",   "m3", "kg/m3", "kg m2", "m2/s",  "rad/s2", "V",    "ohm"};

static bool to_named_unit(ut_unit *unit, quantity *result) {
    for (size_t i = 0; i < sizeof si_units / sizeof *si_units; i++) {
        ut_unit *candidate = ut_parse(units, si_units[i], UT_ASCII);
        const bool fits = note_memory(candidate != NULL) && has_radian(candidate) == has_radian(unit) &&
                          same_dimension(unit, candidate);
        const bool done = fits && convert(unit, candidate, &result->value);
        ut_free(candidate);
        if (!done) continue;
        snprintf(result->unit, sizeof result->unit, "%s", si_units[i]);
        return true;
    }
    return false;
}

/// Divides a text such as "0.001 m2.kg.s-3" into the factor 0.001 and the SI unit "m2.kg.s-3".
static bool to_base_units(ut_unit *unit, quantity *result) {
    char text[256];
    const int length = ut_format(unit, text, sizeof text, UT_ASCII | UT_DEFINITION);
    if (length < 0 || (size_t)length >= sizeof text) return false;
    const char *base = text, *end;
    double factor;
    if (quantity_number(text, &factor, &end)) base = end + strspn(end, " ");
    text[strcspn(text, "@")] = '\0';
    for (size_t i = strlen(text); i > 0 && text[i - 1] == ' '; i--) text[i - 1] = '\0';
    ut_unit *si = ut_parse(units, base, UT_ASCII);
    const bool done = si && strlen(base) < sizeof result->unit && convert(unit, si, &result->value);
    if (done) snprintf(result->unit, sizeof result->unit, "%.63s", base);
    ut_free(si);
    return done;
}

static bool to_si(ut_unit *unit, quantity *result) {
    if (!ut_is_dimensionless(unit) || has_radian(unit))
        return to_named_unit(unit, result) || to_base_units(unit, result);
    ut_unit *one = ut_get_dimensionless_unit_one(units);
    const bool done = one && convert(unit, one, &result->value);
    ut_free(one);
    snprintf(result->unit, sizeof result->unit, "1");
    return done;
}

/// Writes the expectation: "a number in kg", "a plain number", "a number in rad/s or rpm", "a number, or a number and a
/// unit".
static void describe_expected(const char *expected, char text[WHY_SIZE / 2]) {
    if (expected[0] == '\0')
        snprintf(text, WHY_SIZE / 2, "a number, or a number and a unit");
    else if (strcmp(expected, "1") == 0)
        snprintf(text, WHY_SIZE / 2, "a plain number");
    else if (strcmp(expected, "rad/s") == 0)
        snprintf(text, WHY_SIZE / 2, "a number in rad/s or rpm");
    else
        snprintf(text, WHY_SIZE / 2, "a number in %.60s", expected);
}

/// Writes advice for a unit that does not fit. A frequency is no angular speed: the message proposes rpm.
static void describe_misfit(const ut_unit *unit, const char *expected, char text[WHY_SIZE / 2]) {
    ut_unit *hertz = ut_parse(units, "1/s", UT_ASCII), *kinematic = ut_parse(units, "m2/s", UT_ASCII);
    if (hertz && strcmp(expected, "rad/s") == 0 && same_dimension(unit, hertz))
        snprintf(text, WHY_SIZE / 2, "expected a unit of rad/s, such as rpm (1 Hz = 60 rpm)");
    else if (kinematic && strcmp(expected, "Pa s") == 0 && same_dimension(unit, kinematic))
        snprintf(text, WHY_SIZE / 2,
                 "expected a unit of Pa s: kinematic viscosities have their own key, next to density");
    else if (strcmp(expected, "1") == 0)
        snprintf(text, WHY_SIZE / 2, "expected a plain number");
    else
        snprintf(text, WHY_SIZE / 2, "expected a unit of %.60s", expected);
    ut_free(hertz);
    ut_free(kinematic);
}

bool quantity_number(const char *text, double *value, const char **end) {
    const char *c = text + (*text == '-' || *text == '+');
    const size_t whole = strspn(c, "0123456789");
    c += whole;
    size_t fraction = 0;
    if (*c == '.') {
        fraction = strspn(c + 1, "0123456789");
        c += 1 + fraction;
    }
    if (whole + fraction == 0) return false;
    if (*c == 'e' || *c == 'E') {
        const char *exponent = c + 1 + (c[1] == '-' || c[1] == '+');
        const size_t digits = strspn(exponent, "0123456789");
        if (digits > 0) c = exponent + digits;
    }
    const size_t length = (size_t)(c - text);
    char copy[LONGEST_NUMBER + 1];
    if (length > LONGEST_NUMBER) return false;
    memcpy(copy, text, length);
    copy[length] = '\0';
    *value = strtod(copy, NULL); // only the digits, so that strtod finds no hexadecimal number
    *end = c;
    return true;
}

/// Returns whirl's spelling of a common form of a unit, or "".
static const char *usual_spelling(const char *unit) {
    static const char *const spellings[][2] = {
        {"RPM", "rpm"},    {"Rpm", "rpm"},   {"rev/min", "rpm"},   {"r/min", "rpm"},   {"U/min", "rpm"},
        {"rev/s", "rps"},  {"r/s", "rps"},   {"RPS", "rps"},       {"Rad", "rad"},     {"Rad/s", "rad/s"},
        {"Ns/m", "N.s/m"}, {"Nsm", "N.s/m"}, {"N-s/m", "N.s/m"},   {"mPas", "mPa.s"},  {"Pas", "Pa.s"},
        {"Nm", "N.m"},     {"gmm", "g.mm"},  {"gcm", "g.cm"},      {"kgmm", "kg.mm"},  {"kgm", "kg.m"},
        {"Kg", "kg"},      {"KG", "kg"},     {"MM", "mm"},         {"n/m", "N/m"},     {"N/M", "N/m"},
        {"KN/m", "kN/m"},  {"lbs", "lb"},    {"lbs/in", "lbf/in"}, {"degs", "degree"}, {"hz", "Hz"},
        {"HZ", "Hz"},      {"KHz", "kHz"},
    };
    for (size_t i = 0; i < sizeof spellings / sizeof *spellings; i++)
        if (strcmp(unit, spellings[i][0]) == 0) return spellings[i][1];
    return "";
}

/// Reads the unit after a number, and checks both against the expected unit.
static bool read_unit(const char *text, const char *unit_text, const char *expected, quantity *result,
                      char why[WHY_SIZE]) {
    char shown[SHOWN_SIZE], expectation[WHY_SIZE / 2];
    if (!units_ready()) {
        snprintf(why, WHY_SIZE, "has a unit, but the unit database of UDUNITS-2 cannot be read");
        return false;
    }
    // Parse the unit, and the expected one.
    ut_unit *unit = parse_unit(unit_text);
    ut_unit *wanted = unit && expected[0] ? parse_unit(expected) : NULL;
    bool done = false;
    if (!unit) {
        // Explain a unit that does not exist.
        describe_expected(expected, expectation);
        const char *usual = usual_spelling(unit_text);
        snprintf(why, WHY_SIZE, "is %s, expected %s (no unit is called %.40s%s%s%s)", text_shown(text, shown),
                 expectation, unit_text, *usual ? ", did you mean " : "", usual, *usual ? "?" : "");
    } else if (!expected[0]) {
        // Without an expected unit, convert to SI.
        done = to_si(unit, result);
        if (!done) snprintf(why, WHY_SIZE, "is %s, expected a unit that converts to SI", text_shown(text, shown));
    } else if (wanted && same_dimension(unit, wanted) && convert(unit, wanted, &result->value)) {
        // The number is converted to the expected unit.
        snprintf(result->unit, sizeof result->unit, "%.63s", expected);
        done = true;
    } else {
        // Say why the unit does not fit.
        describe_misfit(unit, expected, expectation);
        snprintf(why, WHY_SIZE, "is in %.40s, %s", unit_text, expectation);
    }
    ut_free(unit);
    ut_free(wanted);
    return done;
}

static bool read_quantity(const char *text, const char *expected, quantity *result, char why[WHY_SIZE]) {
    char shown[SHOWN_SIZE], expectation[WHY_SIZE / 2];
    const char *end;
    *result = (quantity){.unit = "1"};
    describe_expected(expected, expectation);
    text_shown(text, shown);
    // Read the number.
    if (!quantity_number(text, &result->value, &end)) {
        snprintf(why, WHY_SIZE, "is %s, expected %s", text[0] ? shown : "empty", expectation);
        return false;
    }
    // Read the unit after a space.
    bool done = true;
    if (*end == ' ') {
        lock_take(&units_lock);
        no_memory = false;
        done = read_unit(text, end + strspn(end, " "), expected, result, why);
        if (no_memory) errno = ENOMEM;
        lock_leave(&units_lock);
    } else if (*end == ',' && isdigit((unsigned char)end[1])) {
        snprintf(why, WHY_SIZE, "is %s, expected %s, with a point in place of the comma", shown, expectation);
        done = false;
    } else if (*end) {
        snprintf(why, WHY_SIZE, "is %s, expected %s, with a space before the unit", shown, expectation);
        done = false;
    }
    if (done && !isfinite(result->value)) {
        snprintf(why, WHY_SIZE, "is %s, too large for a number", shown);
        done = false;
    }
    return done;
}

bool quantity_read(const char *text, const char *expected, quantity *result, char why[WHY_SIZE]) {
    const int before = exhausted_watch();
    const bool done = read_quantity(text, expected, result, why);
    if (!exhausted(before)) return done;
    snprintf(why, WHY_SIZE, "%s", problem_no_memory);
    return false;
}

whirl_status whirl_quantity_value(const char *text, const char *unit, double *value) {
    char plain[LONGEST_NUMBER + SHOWN_SIZE], why[WHY_SIZE];
    quantity read;
    snprintf(plain, sizeof plain, "%s", text + strspn(text, " "));
    for (size_t length = strlen(plain); length > 0 && plain[length - 1] == ' ';) plain[--length] = '\0';
    if (!quantity_read(plain, unit, &read, why)) return whirl_fail(WHIRL_BAD_INPUT, "the value %s", why);
    *value = read.value;
    return whirl_ok();
}

static bool fits_unit(const char *unit_text, const char *expected, char why[WHY_SIZE]) {
    lock_take(&units_lock);
    bool fits = true;
    no_memory = false;
    ut_unit *unit = units_ready() ? ut_parse(units, unit_text, UT_ASCII) : NULL;
    ut_unit *wanted = unit ? ut_parse(units, expected, UT_ASCII) : NULL;
    if (note_memory(unit != NULL) && note_memory(wanted != NULL)) fits = same_dimension(unit, wanted);
    char expectation[WHY_SIZE / 2];
    if (!fits) {
        describe_misfit(unit, expected, expectation);
        snprintf(why, WHY_SIZE, "is in %.40s, %s", unit_text, expectation);
    }
    ut_free(unit);
    ut_free(wanted);
    if (no_memory) errno = ENOMEM;
    lock_leave(&units_lock);
    return fits;
}

bool quantity_fits(const char *unit_text, const char *expected, char why[WHY_SIZE]) {
    const int before = exhausted_watch();
    const bool fits = fits_unit(unit_text, expected, why);
    if (!exhausted(before)) return fits;
    snprintf(why, WHY_SIZE, "%s", problem_no_memory);
    return false;
}

bool quantity_unit_powers(const char *unit_text, double powers[UNIT_BASES]) {
    char text[256];
    for (size_t i = 0; i < UNIT_BASES; i++) powers[i] = 0.0;
    if (!unit_text[0] || strcmp(unit_text, "1") == 0) return true;
    lock_take(&units_lock);
    ut_unit *unit = units_ready() ? ut_parse(units, unit_text, UT_ASCII) : NULL;
    const int length = unit ? ut_format(unit, text, sizeof text, UT_ASCII | UT_DEFINITION) : -1;
    ut_free(unit);
    lock_leave(&units_lock);
    if (length < 0 || (size_t)length >= sizeof text) return false;
    powers_of(text, powers);
    return true;
}
