// Units for people: a case that says 6000 rpm and 0.2 mm is answered in rpm and mm, whatever a result holds in SI.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/result.h"

static const whirl_parameter *find_parameter(const whirl_result *result, const char *name) {
    for (size_t i = 0; i < result->parameter_count; i++)
        if (strcmp(result->parameters[i].name, name) == 0) return &result->parameters[i];
    return NULL;
}

/// The unit behind the number of "6000 rpm" and how large it is, known from the value in SI. False where the text is no
/// number with a unit, or where zero says nothing of its size.
static bool unit_as_written(const whirl_parameter *parameter, whirl_unit *unit) {
    char *end;
    const double number = strtod(parameter->text, &end);
    if (end == parameter->text || number == 0.0 || !isfinite(number)) return false;
    end += strspn(end, " ");
    size_t length = strlen(end);
    while (length > 0 && end[length - 1] == ' ') length--;
    const double size = parameter->value / number;
    // Temperatures have zeros of their own, which no factor tells.
    if (length == 0 || length >= sizeof unit->name || !(size > 0.0) || !isfinite(size)) return false;
    if (strcmp(parameter->unit, "K") == 0) return false;
    memcpy(unit->name, end, length);
    unit->name[length] = '\0';
    unit->size = size;
    return true;
}

whirl_unit whirl_result_unit(const whirl_result *result, const char *name) {
    const whirl_parameter *parameter = find_parameter(result, name);
    whirl_unit unit = {.name = "", .size = 1.0};
    if (!parameter || strcmp(parameter->unit, "1") == 0 || unit_as_written(parameter, &unit)) return unit;
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
        if (unit_as_written(candidate, &unit)) return unit;
    }
    size_t i = 0;
    while (i < 2 && scale < 0.0999 * units[i].size) i++;
    return units[i];
}
