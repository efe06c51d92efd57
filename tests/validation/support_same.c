#include "support_same.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { PRINTED = 3 }; ///< numbers of a field that are printed where they differ

/// A point of a table of a result, and the sizes by which its numbers are compared.
typedef struct place {
    const whirl_result *result;
    const whirl_table *table;
    size_t point;
    double length, fastest; ///< m per unit of length; rad/s, of the fastest rate
} place;

static double largest_of(const double *numbers, size_t count) {
    double largest = 0.0;
    for (size_t i = 0; i < count; i++)
        if (isfinite(numbers[i])) largest = fmax(largest, fabs(numbers[i]));
    return largest;
}

static size_t size_of(const whirl_field *field) {
    return field->repeat * field->rows * field->columns;
}

static bool is_rate(const whirl_field *field) {
    return strcmp(field->unit, "rad/s") == 0 || strcmp(field->unit, "1/s") == 0;
}

static place place_of(const whirl_result *result, const whirl_table *table, size_t point) {
    place p = {result, table, point, whirl_result_length_scale(result, table, point), 0.0};
    for (size_t f = 0; f < table->layout.field_count; f++) {
        const whirl_field *field = &table->layout.fields[f];
        const double *numbers = whirl_table_field(table, point, field->name, 0);
        if (is_rate(field)) p.fastest = fmax(p.fastest, largest_of(numbers, size_of(field)));
    }
    return p;
}

/// Returns true if a column holds orders; the field's unit is then that of its other columns.
static bool is_order(const whirl_field *field, size_t column) {
    return column == 0 && strncmp(field->meaning, "order, ", 7) == 0;
}

/// Returns the factor from a column's unit to SI.
static double factor_of(const place *p, const whirl_field *field, size_t column) {
    if (is_order(field, column)) return 1.0;
    return strcmp(field->unit, "length") == 0  ? p->length
           : strcmp(field->unit, "force") == 0 ? p->result->force_scale
                                               : 1.0;
}

/// Returns the station or contact of the other result that has the name of number `which` of this one.
static size_t partner(const place *one, const whirl_field *field, size_t which, const place *other) {
    if (field->extent == WHIRL_PER_STATION)
        for (size_t i = 0; i < other->result->station_count; i++)
            if (strcmp(one->result->stations[which].name, other->result->stations[i].name) == 0) return i;
    if (field->extent == WHIRL_PER_CONTACT)
        for (size_t i = 0; i < other->result->contact_count; i++)
            if (strcmp(one->result->contacts[which], other->result->contacts[i]) == 0) return i;
    if (field->extent != WHIRL_PER_POINT) fail_msg("%s: number %zu has no partner", field->name, which);
    return 0;
}

// ---------------------------------------------------------------- mirrors

static bool is_one_of(const char *name, const char *const *of) {
    for (; *of; of++)
        if (strcmp(*of, name) == 0) return true;
    return false;
}

/// Returns the number at the same place of another field of the same shape.
static double number_of_field(const place *p, const char *name, size_t which, size_t index) {
    return whirl_table_field(p->table, p->point, name, which)[index];
}

/// Returns what mirrored() returns, for a field of twists about the axis: they turn the other way, so that the least
/// one becomes the largest. Amplitudes stay.
static double mirrored_twist(const place *p, const whirl_field *field, size_t which, size_t index, double number) {
    static const char *const amplitudes[] = {
        WHIRL_FIELD_SPECTRUM_TWIST_LINES,  WHIRL_FIELD_SPECTRUM_TWIST_AMPLITUDE, WHIRL_FIELD_SPECTRUM_TWIST_SYNCHRONOUS,
        WHIRL_FIELD_RUNUP_TWIST_AMPLITUDE, WHIRL_FIELD_RUNUP_TWIST_SPECTRUM,     NULL};
    char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE];
    const char *column = whirl_field_column_names(field, names) ? names[index % field->columns] : "";
    if (strcmp(field->unit, "deg") == 0) return number + 180.0;
    if (is_one_of(field->name, amplitudes)) return number;
    const double sign = strcmp(field->unit, "rad") == 0 ? -1.0 : 1.0; // not of times and speeds of extremes
    if (strcmp(column, "least") == 0) index++;
    if (strcmp(column, "largest") == 0) index--;
    return sign * number_of_field(p, field->name, which, index);
}

/// Returns the number that the mirrored machine (x -> -x, it turns the other way) should have here.
static double mirrored(const place *p, const whirl_field *field, size_t which, size_t index, double number) {
    static const char *const across[] = {"x", "vx", "x_cos", "x_sin", "kxy", "kyx", "cxy", "cyx", "along x", NULL};
    static const char *const late[] = {"x", "first", "forward", "backward", NULL};
    char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE];
    const char *column = whirl_field_column_names(field, names) ? names[index % field->columns] : "";
    if (strcmp(field->name, WHIRL_FIELD_UNBALANCE_INCLINATION) == 0) return 180.0 - number;
    if (strstr(field->name, "/twist") && strcmp(field->name, WHIRL_FIELD_MODES_TWIST) != 0)
        return mirrored_twist(p, field, which, index, number);
    if (strstr(field->name, "lag") && strcmp(field->unit, "deg") == 0)
        return is_one_of(column, late) ? number + 180.0 : number;
    if (strstr(field->meaning, "0-p amplitudes") || !is_one_of(column, across)) return number;
    if (strcmp(field->name, WHIRL_FIELD_ORBIT_LOW) == 0)
        return -number_of_field(p, WHIRL_FIELD_ORBIT_HIGH, which, index);
    if (strcmp(field->name, WHIRL_FIELD_ORBIT_HIGH) == 0)
        return -number_of_field(p, WHIRL_FIELD_ORBIT_LOW, which, index);
    return -number;
}

// ---------------------------------------------------------------- comparing

/// Returns the period of an angle in degrees, 180 for an axis without a sense; 0 for a field that is no angle.
static double turn_of(const whirl_field *field) {
    if (strcmp(field->unit, "deg") != 0) return 0.0;
    return strcmp(field->name, WHIRL_FIELD_UNBALANCE_INCLINATION) == 0 ? 180.0 : 360.0;
}

static double distance(const whirl_field *field, double a, double b) {
    const double turn = turn_of(field);
    return turn > 0.0 ? fabs(remainder(a - b, turn)) : fabs(a - b);
}

/// Returns the size that a difference is divided by: in general the largest number of the field that is no order.
static double scale_of(const place *p, const whirl_field *field, size_t column) {
    const double *numbers = whirl_table_field(p->table, p->point, field->name, 0);
    const bool plain = strcmp(field->unit, "1") == 0;
    double largest = plain ? 1.0 : 0.0;
    if (is_order(field, column)) return 1.0;
    if (turn_of(field) > 0.0) return 180.0;
    if (is_rate(field)) return p->fastest;
    for (size_t i = 0; i < size_of(field); i++)
        if (isfinite(numbers[i]) && !is_order(field, i % field->columns)) largest = fmax(largest, fabs(numbers[i]));
    return factor_of(p, field, column) * largest;
}

/// Fields that depend on the last digits of a motion that comes to rest, which any rounding changes.
static const char *const of_rounding[] = {WHIRL_FIELD_REGIME_RECURRENCE_TREND, WHIRL_FIELD_REGIME_REGULARITY,
                                          WHIRL_FIELD_REGIME_SETTLING_ERROR,   WHIRL_FIELD_REGIME_SWELLING,
                                          WHIRL_FIELD_EVIDENCE_SETTLING,       NULL};

/// Returns the allowed difference of fields that are measured on a perturbed copy of a motion, else 0. In a mirror the
/// copy begins elsewhere: there four standard errors are added.
static double allowed_of_growth(const place *one, const whirl_field *field, const place *other, const same_rule *rule) {
    static const char *const measured[] = {WHIRL_FIELD_LYAPUNOV_LARGEST,     WHIRL_FIELD_LYAPUNOV_ERROR,
                                           WHIRL_FIELD_REGIME_EXPONENT,      WHIRL_FIELD_REGIME_EXPONENT_ERROR,
                                           WHIRL_FIELD_REGIME_STEP_ERROR,    WHIRL_FIELD_REGIME_SETTLING,
                                           WHIRL_FIELD_EVIDENCE_MODULUS,     WHIRL_FIELD_EVIDENCE_MULTIPLIER,
                                           WHIRL_FIELD_REGIME_ADVICE_FACTOR, NULL};
    if (!is_one_of(field->name, measured)) return 0.0;
    if (!rule->mirrored) return rule->of_growth;
    return rule->of_growth + 4.0 * (whirl_table_number(one->table, one->point, WHIRL_FIELD_LYAPUNOV_ERROR, 0) +
                                    whirl_table_number(other->table, other->point, WHIRL_FIELD_LYAPUNOV_ERROR, 0));
}

static bool is_shape(const whirl_field *field) {
    return strcmp(field->name, WHIRL_FIELD_MODES_SHAPE) == 0 || strcmp(field->name, WHIRL_FIELD_MODES_TWIST) == 0 ||
           strcmp(field->name, WHIRL_FIELD_CRITICAL_SPEEDS_SHAPE) == 0;
}

/// Fits the sign of a row of shapes, of which each is as good as its negative: 1 or -1.
static double sign_of_shape(const place *one, const whirl_field *field, size_t row, const place *other,
                            const same_rule *rule) {
    double product = 0.0;
    for (size_t which = 0; which < field->repeat; which++) {
        const double *a = whirl_table_field(one->table, one->point, field->name, which);
        const double *b = whirl_table_field(other->table, other->point, field->name, partner(one, field, which, other));
        for (size_t i = row * field->columns; i < (row + 1) * field->columns; i++)
            product += (rule->mirrored ? mirrored(one, field, which, i, a[i]) : a[i]) * b[i];
    }
    return product < 0.0 ? -1.0 : 1.0;
}

/// Returns true for a field whose rows may be in another order: multipliers of one modulus.
static bool is_set(const whirl_field *field, const same_rule *rule) {
    return rule->tolerance > 0.0 && strcmp(field->name, WHIRL_FIELD_FLOQUET_MULTIPLIERS) == 0;
}

/// Returns the number of `b` that belongs to number i of `a`: at the same place, or for a set in the nearest row.
static double counterpart(const whirl_field *field, const double *a, const double *b, size_t i, bool set) {
    const size_t row = i / field->columns * field->columns;
    size_t nearest = row;
    for (size_t k = 0; set && k < field->rows * field->columns; k += field->columns)
        if (hypot(a[row] - b[k], a[row + 1] - b[k + 1]) < hypot(a[row] - b[nearest], a[row + 1] - b[nearest + 1]))
            nearest = k;
    return b[nearest + i % field->columns];
}

/// Returns the least tolerance of a field: the place of a maximum is known to the square root of rounding only.
static double least_tolerance(const whirl_field *field, const same_rule *rule) {
    return rule->tolerance > 0.0 && strcmp(field->name, WHIRL_FIELD_MODES_SENSITIVITY_FREQUENCY) == 0 ? 1e-7 : 0.0;
}

static size_t same_field(const char *what, const place *one, const whirl_field *field, const place *other,
                         const same_rule *rule) {
    const double of_growth = allowed_of_growth(one, field, other, rule);
    size_t wrong = 0;
    for (size_t which = 0; which < field->repeat; which++) {
        const size_t there = partner(one, field, which, other);
        const double *a = whirl_table_field(one->table, one->point, field->name, which);
        const double *b = whirl_table_field(other->table, other->point, field->name, there);
        assert_non_null(b);
        for (size_t i = 0; i < field->rows * field->columns; i++) {
            const size_t column = i % field->columns;
            const double scale = scale_of(one, field, column);
            const double allowed = fmax(of_growth, fmax(rule->tolerance, least_tolerance(field, rule)) * scale);
            double expected = rule->mirrored ? mirrored(one, field, which, i, a[i]) : a[i];
            if (is_shape(field)) expected *= sign_of_shape(one, field, i / field->columns, other, rule);
            const double found = counterpart(field, a, b, i, is_set(field, rule));
            const double there_si = factor_of(other, field, column) * found;
            const double difference = distance(field, factor_of(one, field, column) * expected, there_si);
            if ((isnan(expected) && isnan(found)) || difference <= allowed) continue;
            if (wrong++ < PRINTED)
                print_message("%s: %s %s[%zu][%zu] is %.15g, expected %.15g, differs by %.1e of %.4g\n", what,
                              one->table->name, field->name, which, i, there_si,
                              factor_of(one, field, column) * expected, difference / scale, scale);
        }
    }
    return wrong;
}

static bool is_left_out(const char *name, const char *const *left_out) {
    for (; left_out && *left_out; left_out++)
        if (strncmp(*left_out, name, strlen(*left_out)) == 0) return true;
    return false;
}

size_t same_points(const char *what, const whirl_result *one, size_t table, size_t at, const whirl_result *other,
                   size_t there, const same_rule *rule) {
    const whirl_table *own = &one->tables[table], *partner_table = NULL;
    size_t wrong = 0;
    for (size_t t = 0; t < other->table_count; t++)
        if (strcmp(other->tables[t].name, own->name) == 0) partner_table = &other->tables[t];
    assert_non_null(partner_table);
    assert_int_equal(own->layout.field_count, partner_table->layout.field_count);
    const place a = place_of(one, own, at), b = place_of(other, partner_table, there);
    for (size_t f = 0; f < own->layout.field_count; f++) {
        const whirl_field *field = &own->layout.fields[f];
        if (is_one_of(field->name, of_rounding) && rule->tolerance > 0.0) continue;
        if (!is_left_out(field->name, rule->left_out)) wrong += same_field(what, &a, field, &b, rule);
    }
    return wrong;
}

size_t same_results(const char *what, const whirl_result *one, const whirl_result *other, const same_rule *rule) {
    size_t wrong = 0;
    assert_int_equal(one->table_count, other->table_count);
    for (size_t t = 0; t < one->table_count; t++)
        for (size_t i = 0; i < one->tables[t].count; i++) wrong += same_points(what, one, t, i, other, i, rule);
    return wrong;
}
