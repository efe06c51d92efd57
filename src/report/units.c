#include "units.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static bool near(double a, double b) {
    return fabs(a - b) <= 1e-12 * fabs(b);
}

/// Whether a parameter is the length scale of a table's points: where it varies it is that of every one, where another
/// one varies it must follow from that one if the scale does.
static bool is_scale_of(const whirl_result *result, const whirl_table *table, const whirl_parameter *candidate) {
    const bool expression = candidate->text[strspn(candidate->text, " \t")] == '=';
    if (strcmp(table->parameter, candidate->name) != 0) return !table->length_scales || expression;
    for (size_t i = 0; i < table->count; i++)
        if (!near(table->values[i], whirl_result_length_scale(result, table, i))) return false;
    return true;
}

/// The parameter that is the length scale, or NULL.
static const whirl_parameter *scale_parameter(const whirl_result *result) {
    for (size_t i = 0; i < result->parameter_count; i++) {
        const whirl_parameter *candidate = &result->parameters[i];
        bool is = strcmp(candidate->unit, "m") == 0 && near(candidate->value, result->length_scale);
        for (size_t t = 0; t < result->table_count && is; t++) is = is_scale_of(result, &result->tables[t], candidate);
        if (is) return candidate;
    }
    return NULL;
}

static const char *shown_name(const char *unit) {
    return strcmp(unit, "um") == 0 ? "\u00b5m" : unit;
}

static bool scale_changes(const whirl_result *result) {
    bool found = false;
    for (size_t t = 0; t < result->table_count; t++) found = found || result->tables[t].length_scales;
    return found;
}

static void choose_length(shown_units *units, const unit_word *word) {
    const whirl_parameter *scale = scale_parameter(units->result);
    const whirl_unit natural = whirl_result_length_unit(units->result);
    if (word && word->size > 0.0) {
        units->length = units->result->length_scale / word->size;
        snprintf(units->length_name, sizeof units->length_name, "%s", word->shown);
    } else if (scale) {
        units->length = 1.0;
        units->ratio = true;
        snprintf(units->length_name, sizeof units->length_name, "%s", scale->name);
    } else if (word && scale_changes(units->result)) {
        units->length = 1.0;
        units->ratio = true;
        snprintf(units->length_name, sizeof units->length_name, "(length scale)");
    } else if (word) {
        units->length = 1.0;
        units->ratio = true;
        snprintf(units->length_name, sizeof units->length_name, "(%.4g %s)", units->result->length_scale / natural.size,
                 shown_name(natural.name));
    } else {
        units->length = units->result->length_scale / natural.size;
        snprintf(units->length_name, sizeof units->length_name, "%s", shown_name(natural.name));
    }
}

shown_units units_shown(const whirl_result *result, const unit_choice *asked) {
    unit_choice choice;
    // A file may say anything; what is no choice chooses nothing.
    if (unit_choice_read(whirl_result_fact(result, "units"), &choice).code != WHIRL_OK) choice = (unit_choice){0};
    for (int kind = 0; kind < UNIT_KINDS; kind++)
        if (asked && asked->of[kind]) choice.of[kind] = asked->of[kind];
    const unit_word *amplitude = choice.of[UNIT_AMPLITUDE], *frequency = choice.of[UNIT_FREQUENCY];
    shown_units units = {.result = result,
                         .speed = choice.of[UNIT_SPEED],
                         .amplitude = amplitude ? amplitude->size : 1.0,
                         .amplitude_name = amplitude ? amplitude->shown : "",
                         .frequency = frequency ? frequency->size : 0.0,
                         .frequency_name = frequency ? frequency->shown : ""};
    choose_length(&units, choice.of[UNIT_LENGTH]);
    if (choice.of[UNIT_LENGTH] && choice.of[UNIT_LENGTH]->size > 0.0) units.size = choice.of[UNIT_LENGTH];
    return units;
}

bool units_one_length(const shown_units *units, const whirl_table *table) {
    return units->ratio || !table || !table->length_scales;
}

double units_length(const shown_units *units, const whirl_table *table, size_t point) {
    if (units_one_length(units, table)) return units->length;
    return units->length * (whirl_result_length_scale(units->result, table, point) / units->result->length_scale);
}

/// The SI unit of a parameter; "" where there is no such parameter.
static const char *si_unit(const whirl_result *result, const char *name) {
    for (size_t i = 0; i < result->parameter_count; i++)
        if (strcmp(result->parameters[i].name, name) == 0) return result->parameters[i].unit;
    return "";
}

whirl_unit units_parameter(const shown_units *units, const char *name) {
    const char *si = si_unit(units->result, name);
    const unit_word *word = strcmp(si, "rad/s") == 0 ? units->speed : strcmp(si, "m") == 0 ? units->size : NULL;
    whirl_unit unit = whirl_result_unit(units->result, name);
    if (word) {
        unit.size = word->size;
        snprintf(unit.name, sizeof unit.name, "%s", word->shown);
    } else if (strcmp(unit.name, "um") == 0) {
        snprintf(unit.name, sizeof unit.name, "%s", shown_name("um"));
    }
    return unit;
}

double units_order(const shown_units *units, double speed) {
    const double two_pi = 6.283185307179586476925;
    return units->frequency > 0.0 && speed > 0.0 ? speed / two_pi / units->frequency : (double)NAN;
}

void units_length_label(const shown_units *units, const char *quantity, char *label, size_t size) {
    snprintf(label, size, units->ratio ? "%s / %s" : "%s (%s)", quantity, units->length_name);
}

void units_amplitude_label(const shown_units *units, const char *quantity, char *label, size_t size) {
    const char *name = units->amplitude_name, *gap = *name ? " " : "";
    if (units->ratio)
        snprintf(label, size, *name ? "%s / %s (%s)" : "%s / %s%s", quantity, units->length_name, name);
    else
        snprintf(label, size, "%s (%s%s%s)", quantity, units->length_name, gap, name);
}

void units_parameter_label(const shown_units *units, const char *name, char *label, size_t size) {
    const whirl_unit unit = units_parameter(units, name);
    snprintf(label, size, *unit.name ? "%s (%s)" : "%s", name, unit.name);
}

void units_point_label(const shown_units *units, const whirl_table *table, size_t point, char *label, size_t size) {
    if (!*table->parameter) {
        if (table->attractors)
            snprintf(label, size, "%s, attractor %zu", table->name, table->attractors[point].number);
        else
            snprintf(label, size, "%s", table->name);
        return;
    }
    const whirl_unit unit = units_parameter(units, table->parameter);
    snprintf(label, size, "%s = %.6g%s%s", table->parameter, table->values[point] / unit.size, *unit.name ? " " : "",
             unit.name);
}
