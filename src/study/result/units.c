// Units for people: a case in rpm and mm is answered in rpm and mm, whatever unit a result stores.
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/engine/result.h"

static const whirl_parameter *find_parameter(const whirl_result *result, const char *name) {
    for (size_t i = 0; i < result->parameter_count; i++)
        if (strcmp(result->parameters[i].name, name) == 0) return &result->parameters[i];
    return NULL;
}

/// Reads the unit after the number of "6000 rpm" and finds its size from the value in SI. False if the text is no
/// number with a unit, or if the value is zero.
static bool unit_as_written(const whirl_parameter *parameter, whirl_unit *unit) {
    char *end;
    const double number = strtod(parameter->text, &end);
    if (end == parameter->text || number == 0.0 || !isfinite(number)) return false;
    end += strspn(end, " ");
    size_t length = strlen(end);
    while (length > 0 && end[length - 1] == ' ') length--;
    const double size = parameter->value / number;
    // Temperature scales have an offset, which a factor cannot express.
    if (length == 0 || length >= sizeof unit->name || !(size > 0.0) || !isfinite(size)) return false;
    if (strcmp(parameter->unit, "K") == 0) return false;
    memcpy(unit->name, end, length);
    unit->name[length] = '\0';
    unit->size = size;
    return true;
}

/// Reads the unit in which a sweep writes the parameter, from the fact "unit of gap": "mm = 0.001 m".
static bool unit_of_sweep(const whirl_result *result, const char *name, whirl_unit *unit) {
    char fact[WHIRL_NAME_SIZE + 8];
    snprintf(fact, sizeof fact, "unit of %s", name);
    const char *const said = whirl_result_fact(result, fact), *const equals = strstr(said, " = ");
    const double size = equals ? strtod(equals + 3, NULL) : 0.0;
    if (!(size > 0.0) || !isfinite(size) || (size_t)(equals - said) >= sizeof unit->name) return false;
    memcpy(unit->name, said, (size_t)(equals - said));
    unit->name[equals - said] = '\0';
    unit->size = size;
    return true;
}

static bool find_unit(const whirl_result *result, const whirl_parameter *parameter, int depth, whirl_unit *unit);

/// Finds the unit of the first parameter of the same kind in an expression, "= 1.5*c".
static bool unit_of_names(const whirl_result *result, const whirl_parameter *parameter, int depth, whirl_unit *unit) {
    const char *at = parameter->text + strspn(parameter->text, " \t");
    if (*at != '=') return false;
    while (*at) {
        char name[WHIRL_NAME_SIZE];
        size_t length = 0;
        while (isalnum((unsigned char)at[length]) || at[length] == '_') length++;
        snprintf(name, sizeof name, "%.*s", (int)length, at);
        const whirl_parameter *const other = length > 0 && length < sizeof name ? find_parameter(result, name) : NULL;
        if (other && strcmp(other->unit, parameter->unit) == 0 && find_unit(result, other, depth - 1, unit))
            return true;
        at += length > 0 ? length : 1;
    }
    return false;
}

/// Finds the unit of a parameter; false if none is written. Expressions are followed `depth` deep: a file may contain
/// cycles.
static bool find_unit(const whirl_result *result, const whirl_parameter *parameter, int depth, whirl_unit *unit) {
    return unit_of_sweep(result, parameter->name, unit) || unit_as_written(parameter, unit) ||
           (depth > 0 && unit_of_names(result, parameter, depth, unit));
}

enum { DEPTH = 4 };

whirl_unit whirl_result_unit(const whirl_result *result, const char *name) {
    const whirl_parameter *parameter = find_parameter(result, name);
    whirl_unit unit = {.name = "", .size = 1.0};
    if (!parameter || strcmp(parameter->unit, "1") == 0 || find_unit(result, parameter, DEPTH, &unit)) return unit;
    snprintf(unit.name, sizeof unit.name, "%s", parameter->unit);
    return unit;
}

whirl_unit whirl_result_length_unit(const whirl_result *result) {
    static const whirl_unit units[] = {{"m", 1.0}, {"mm", 1e-3}, {"um", 1e-6}};
    const double scale = result->length_scale;
    for (size_t i = 0; i < result->parameter_count; i++) {
        const whirl_parameter *candidate = &result->parameters[i];
        if (strcmp(candidate->unit, "m") != 0 || fabs(candidate->value - scale) > 1e-12 * scale) continue;
        whirl_unit unit;
        if (find_unit(result, candidate, DEPTH, &unit)) return unit;
    }
    size_t i = 0;
    while (i < 2 && scale < 0.0999 * units[i].size) i++;
    return units[i];
}

whirl_unit whirl_result_si(const whirl_result *result, const whirl_table *table, const char *unit) {
    const double two_pi = 2.0 * acos(-1.0);
    const double clock = table && table->clock_of ? (double)NAN : whirl_result_clock(result);
    const double length = table && table->length_scales ? (double)NAN : result->length_scale;
    whirl_unit si = {.size = 1.0};
    if (strcmp(unit, "length") == 0) return (whirl_unit){"m", length};
    if (strcmp(unit, "force") == 0) return (whirl_unit){"N", result->force_scale};
    if (strcmp(unit, "revolution") == 0) return (whirl_unit){"s", two_pi / clock};
    if (strcmp(unit, "1/revolution") == 0) return (whirl_unit){"1/s", clock / two_pi};
    if (strcmp(unit, "order") == 0) return (whirl_unit){"Hz", clock / two_pi};
    snprintf(si.name, sizeof si.name, "%s", unit);
    return si;
}

const char *whirl_result_parameter_unit(const whirl_result *result, const char *parameter) {
    for (size_t i = 0; i < result->parameter_count; i++)
        if (strcmp(result->parameters[i].name, parameter) == 0) return result->parameters[i].unit;
    return "1";
}

whirl_unit whirl_field_si(const whirl_result *result, const whirl_table *table, const whirl_field *field) {
    whirl_unit si = whirl_result_si(result, table, field->unit);
    const char *parameter = NULL;
    if (table && strcmp(field->name, WHIRL_FIELD_MAP_SECOND) == 0) parameter = table->second;
    if (table && strcmp(field->name, WHIRL_FIELD_MAP_THIRD) == 0) parameter = table->third;
    if (parameter) snprintf(si.name, sizeof si.name, "%s", whirl_result_parameter_unit(result, parameter));
    return si;
}
