// Reads and converts units without UDUNITS-2: products of the names in its database, with its numbers and rules.
//
// A unit is scale * (product of powers of base units) above an origin, as in the library. Products, powers and
// conversions are rounded in the library's order, so that both give the same numbers.
#include "udunits2.h"

#include <ctype.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { BASE_COUNT = 8, RADIAN = 7, MAX_DEPTH = 64, MAX_POWER = 255 };
static const char *const bases[BASE_COUNT] = {"m", "kg", "s", "A", "K", "mol", "cd", "rad"};

struct ut_unit {
    double scale, origin;
    int powers[BASE_COUNT];
    bool logarithmic; ///< a unit that is known only by its name and cannot be used
};

typedef struct known_unit {
    const char *name;
    ut_unit unit;
} known_unit;

typedef struct unit_prefix {
    const char *text;
    double value;
} unit_prefix;

#include "units.inc"

#define COUNT(array) (sizeof(array) / sizeof *(array))

struct ut_system {
    int unused;
};

struct cv_converter {
    double slope, intercept;
};

/// Sets a scale within rounding of 1 to 1, as the library does.
static double settle_scale(double scale) {
    return fabs(1.0 - scale) < 10.0 * DBL_EPSILON ? 1.0 : scale;
}

// ---------------------------------------------------------------- names

enum { MAX_ADDED = 32, ADDED_SIZE = 16 };
static struct {
    char name[ADDED_SIZE];
    ut_unit unit;
} added[MAX_ADDED];
static size_t added_count;

static const ut_unit *search(const known_unit *table, size_t count, const char *name,
                             int (*order)(const char *, const char *)) {
    size_t low = 0, high = count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        const int sign = order(name, table[middle].name);
        if (sign == 0) return &table[middle].unit;
        if (sign < 0)
            high = middle;
        else
            low = middle + 1;
    }
    return NULL;
}

/// Finds a unit by its name; names ignore the case of letters, symbols do not.
static const ut_unit *find_unit(const char *name) {
    for (size_t i = 0; i < added_count; i++)
        if (strcasecmp(added[i].name, name) == 0) return &added[i].unit;
    const ut_unit *unit = search(unit_names, COUNT(unit_names), name, strcasecmp);
    return unit ? unit : search(unit_symbols, COUNT(unit_symbols), name, strcmp);
}

/// Returns the longest prefix at the beginning of `text`, or NULL.
static const unit_prefix *find_prefix(const unit_prefix *table, size_t count, const char *text, bool any_case) {
    const unit_prefix *found = NULL;
    size_t longest = 0;
    for (size_t i = 0; i < count; i++) {
        const size_t length = strlen(table[i].text);
        const bool begins = (any_case ? strncasecmp : strncmp)(text, table[i].text, length) == 0;
        if (!begins || length <= longest) continue;
        found = &table[i];
        longest = length;
    }
    return found;
}

/// Reads a name after any number of spelled-out prefixes and at most one prefix symbol.
static bool units_read_name(const char *name, ut_unit *unit) {
    double factor = 1.0;
    bool symbol_seen = false;
    while (*name) {
        const ut_unit *known = find_unit(name);
        if (known) {
            *unit = *known;
            unit->scale = settle_scale(unit->scale * factor);
            if (factor != 1.0) unit->origin = known->scale * known->origin / unit->scale;
            return true;
        }
        const unit_prefix *prefix = find_prefix(name_prefixes, COUNT(name_prefixes), name, true);
        if (!prefix && !symbol_seen) {
            prefix = find_prefix(symbol_prefixes, COUNT(symbol_prefixes), name, false);
            symbol_seen = true;
        }
        if (!prefix) return false;
        factor *= prefix->value;
        name += strlen(prefix->text);
    }
    return false;
}

// ---------------------------------------------------------------- products and powers

static const ut_unit one = {.scale = 1.0};

/// Returns true if all powers are within limits, and the scale is not 0.
static bool is_sound(const ut_unit *unit) {
    for (size_t i = 0; i < BASE_COUNT; i++)
        if (abs(unit->powers[i]) > SHRT_MAX) return false;
    return unit->scale != 0.0;
}

static bool multiply(ut_unit *a, const ut_unit *b) {
    if (a->logarithmic || b->logarithmic) return false;
    a->scale = settle_scale(a->scale * b->scale);
    a->origin = 0.0;
    for (size_t i = 0; i < BASE_COUNT; i++) a->powers[i] += b->powers[i];
    return is_sound(a);
}

static bool raise_to(ut_unit *a, int power) {
    if (power == 1) return true;
    if (a->logarithmic || power < -MAX_POWER || power > MAX_POWER) return false;
    if (power == 0) {
        *a = one;
        return true;
    }
    a->scale = settle_scale(pow(a->scale, power));
    a->origin = 0.0;
    for (size_t i = 0; i < BASE_COUNT; i++) a->powers[i] *= power;
    return is_sound(a);
}

// ---------------------------------------------------------------- reading

typedef struct unit_reader {
    const char *at;
    bool after_name; ///< the last token was a name without a power
    int depth;
} unit_reader;

/// Superscripts in UTF-8: the digits in their order, then minus.
static const char *const superscripts[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹", "⁻"};
enum { RAISED_MINUS = 10 };

/// Returns the index of the superscript at `text`, or -1.
static int superscript(const char *text) {
    for (int i = 0; i < (int)COUNT(superscripts); i++)
        if (strncmp(text, superscripts[i], strlen(superscripts[i])) == 0) return i;
    return -1;
}

/// Reads a power in superscripts; above MAX_POWER if there is none.
static int read_superscripts(unit_reader *r) {
    const bool negative = superscript(r->at) == RAISED_MINUS;
    if (negative) r->at += strlen(superscripts[RAISED_MINUS]);
    int digit = superscript(r->at), power = digit >= 0 && digit < RAISED_MINUS ? 0 : MAX_POWER + 1;
    for (; digit >= 0 && digit < RAISED_MINUS; digit = superscript(r->at)) {
        power = power > MAX_POWER ? power : 10 * power + digit;
        r->at += strlen(superscripts[digit]);
    }
    return negative ? -power : power;
}

static int read_digits(unit_reader *r) {
    const bool negative = *r->at == '-';
    int power = 0;
    r->at += negative;
    for (; isdigit((unsigned char)*r->at); r->at++) power = power > MAX_POWER ? power : 10 * power + (*r->at - '0');
    return negative ? -power : power;
}

static bool has_digits(const char *text) {
    return isdigit((unsigned char)text[*text == '-']) != 0;
}

/// Reads a power: "m2", "m-1", "m^2", "m²"; without one it is 1.
static bool read_power(unit_reader *r, ut_unit *unit) {
    const bool caret = *r->at == '^';
    r->at += caret;
    if (has_digits(r->at)) {
        r->after_name = caret; // the library reads no name directly after "m^2"
        return raise_to(unit, read_digits(r));
    }
    if (caret) return false;
    if (superscript(r->at) < 0) return true;
    r->after_name = false;
    return raise_to(unit, read_superscripts(r));
}

static bool is_raised_dot(const char *text) {
    return strncmp(text, "·", strlen("·")) == 0;
}

/// Returns true if a character can be a part of a name. Of superscripts, ¹, ² and ³ are powers after a name; others
/// belong to it.
static bool is_name_part(const char *text) {
    const int index = superscript(text);
    if ((unsigned char)*text < 0x80) return isalpha((unsigned char)*text) || *text == '_';
    return !(index >= 1 && index <= 3) && !is_raised_dot(text);
}

/// Returns the length of a name: letters, and digits between letters; or a percent sign.
static size_t name_length(const char *text) {
    size_t length = 0, next = 0;
    if (*text == '%') return 1;
    while (text[next]) {
        if (is_name_part(text + next))
            length = ++next;
        else if (next > 0 && isdigit((unsigned char)text[next]))
            next++;
        else
            break;
    }
    return length;
}

static bool read_product(unit_reader *r, ut_unit *unit);

static bool read_factor(unit_reader *r, ut_unit *unit) {
    // A factor is a product in parentheses, a 1, or the name of a unit.
    char name[128];
    const size_t length = name_length(r->at);
    if (*r->at == '(') {
        r->at++;
        if (++r->depth > MAX_DEPTH || !read_product(r, unit) || *r->at != ')') return false;
        r->depth--;
        r->at++;
        r->after_name = false;
    } else if (*r->at == '1') {
        r->at++;
        *unit = one;
        return true;
    } else {
        if (length == 0 || length >= sizeof name) return false;
        memcpy(name, r->at, length);
        name[length] = '\0';
        if (!units_read_name(name, unit)) return false;
        r->at += length;
        r->after_name = true;
    }
    // A power may follow.
    return read_power(r, unit);
}

/// Returns the length of the word "per", which means division.
static size_t per_length(const char *text) {
    return strncasecmp(text, "per", 3) == 0 && !is_name_part(text + 3) ? 3 : 0;
}

typedef enum joint { JOINT_NONE, JOINT_TIMES, JOINT_OVER } joint;

/// Reads the operator between two factors: ".", "*" or a raised dot without spaces, "/" or "per" with or without them,
/// spaces alone, or nothing next to a parenthesis or after a power.
static joint read_joint(unit_reader *r) {
    const size_t spaces = strspn(r->at, " ");
    const char *sign = r->at + spaces;
    const size_t per = spaces > 0 ? per_length(sign) : 0;
    if (*sign == '/' || per > 0) {
        r->at = sign + (per > 0 ? per : 1);
        r->at += strspn(r->at, " ");
        return JOINT_OVER;
    }
    r->at = sign;
    if (spaces > 0) return JOINT_TIMES;
    if (*sign == '.' || *sign == '*') r->at = sign + 1;
    if (is_raised_dot(sign)) r->at = sign + strlen("·");
    return r->at > sign || *sign == '(' || (name_length(sign) > 0 && !r->after_name) ? JOINT_TIMES : JOINT_NONE;
}

static bool read_product(unit_reader *r, ut_unit *unit) {
    if (!read_factor(r, unit)) return false;
    for (joint kind; (kind = read_joint(r)) != JOINT_NONE;) {
        ut_unit next;
        if (!read_factor(r, &next)) return false;
        if (kind == JOINT_OVER && !raise_to(&next, -1)) return false;
        if (!multiply(unit, &next)) return false;
    }
    return true;
}

static ut_unit *unit_new(const ut_unit *from) {
    ut_unit *unit = malloc(sizeof *unit);
    if (unit) *unit = *from;
    return unit;
}

// ---------------------------------------------------------------- the functions of UDUNITS-2

int ut_ignore(const char *format, va_list arguments) {
    (void)format, (void)arguments;
    return 0;
}

ut_error_message_handler ut_set_error_message_handler(ut_error_message_handler handler) {
    return handler;
}

ut_system *ut_read_xml(const char *path) {
    static ut_system system;
    (void)path;
    return &system;
}

ut_unit *ut_parse(const ut_system *system, const char *text, ut_encoding encoding) {
    (void)system, (void)encoding;
    unit_reader reader = {.at = text};
    ut_unit unit;
    if (!read_product(&reader, &unit) || *reader.at) return NULL;
    return unit_new(&unit);
}

ut_unit *ut_get_dimensionless_unit_one(const ut_system *system) {
    (void)system;
    return unit_new(&one);
}

/// Does nothing, as added names are found before those of the database.
ut_status ut_unmap_name_to_unit(ut_system *system, const char *name, ut_encoding encoding) {
    (void)system, (void)name, (void)encoding;
    return UT_SUCCESS;
}

ut_status ut_map_name_to_unit(const char *name, ut_encoding encoding, const ut_unit *unit) {
    (void)encoding;
    if (added_count == MAX_ADDED || strlen(name) >= ADDED_SIZE) return UT_NO_MEMORY;
    strcpy(added[added_count].name, name);
    added[added_count++].unit = *unit;
    return UT_SUCCESS;
}

ut_unit *ut_divide(const ut_unit *numerator, const ut_unit *denominator) {
    ut_unit quotient = *numerator, inverse = *denominator;
    return raise_to(&inverse, -1) && multiply(&quotient, &inverse) ? unit_new(&quotient) : NULL;
}

ut_unit *ut_scale(double factor, const ut_unit *unit) {
    ut_unit scaled = *unit;
    scaled.scale *= factor;
    return unit_new(&scaled);
}

int ut_is_dimensionless(const ut_unit *unit) {
    for (size_t i = 0; i < BASE_COUNT; i++)
        if (i != RADIAN && unit->powers[i] != 0) return 0;
    return !unit->logarithmic;
}

int ut_format(const ut_unit *unit, char *text, size_t size, unsigned options) {
    (void)options;
    char product[160] = "", origin[40] = "", scale[40] = "";
    size_t used = 0;
    if (unit->logarithmic) return -1;
    for (size_t i = 0; i < BASE_COUNT && used < sizeof product; i++) {
        const int power = unit->powers[i];
        if (power == 0) continue;
        used += (size_t)snprintf(product + used, sizeof product - used, "%s%s", used > 0 ? "." : "", bases[i]);
        if (power != 1) used += (size_t)snprintf(product + used, sizeof product - used, "%d", power);
    }
    if (unit->scale != 1.0) snprintf(scale, sizeof scale, "%.*g ", DBL_DIG, unit->scale);
    if (unit->origin != 0.0) snprintf(origin, sizeof origin, " @ %.*g", DBL_DIG, unit->origin);
    return snprintf(text, size, "%s%s%s", scale, used > 0 ? product : "1", origin);
}

void ut_free(ut_unit *unit) {
    free(unit);
}

cv_converter *ut_get_converter(ut_unit *from, ut_unit *to) {
    for (size_t i = 0; i < BASE_COUNT; i++)
        if (i != RADIAN && from->powers[i] != to->powers[i]) return NULL;
    if (from->logarithmic || to->logarithmic) return NULL;
    cv_converter *converter = malloc(sizeof *converter);
    if (!converter) return NULL;
    const double back = 1.0 / to->scale;
    *converter =
        (cv_converter){.slope = from->scale * back, .intercept = from->scale * from->origin * back - to->origin};
    return converter;
}

double cv_convert_double(const cv_converter *converter, double value) {
    return converter->slope * value + converter->intercept;
}

void cv_free(cv_converter *converter) {
    free(converter);
}
