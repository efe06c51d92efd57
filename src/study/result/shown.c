// In which units numbers are shown: see whirl/engine/shown.h.
#include "whirl/engine/shown.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "words.h"

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

static void choose_length(whirl_shown_units *units, const unit_word *word) {
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

/// The unit that a word chooses; of size 0 where none does.
static whirl_unit chosen(const unit_word *word) {
    whirl_unit unit = {.size = word ? word->size : 0.0};
    if (word) snprintf(unit.name, sizeof unit.name, "%s", word->shown);
    return unit;
}

whirl_status whirl_result_shown_units(const whirl_result *result, const char *asked, whirl_shown_units *units) {
    unit_choice choice, own;
    const whirl_status status = unit_choice_read(asked ? asked : "", &choice);
    if (status.code != WHIRL_OK) return status;
    // A file may say anything; what is no choice chooses nothing.
    if (unit_choice_read(whirl_result_fact(result, "units"), &own).code != WHIRL_OK) own = (unit_choice){0};
    for (int kind = 0; kind < UNIT_KINDS; kind++)
        if (!choice.of[kind]) choice.of[kind] = own.of[kind];
    const unit_word *amplitude = choice.of[UNIT_AMPLITUDE], *frequency = choice.of[UNIT_FREQUENCY];
    *units = (whirl_shown_units){.result = result,
                                 .speed = chosen(choice.of[UNIT_SPEED]),
                                 .size = chosen(choice.of[UNIT_LENGTH]),
                                 .amplitude = amplitude ? amplitude->size : 1.0,
                                 .amplitude_name = amplitude ? amplitude->shown : "0-p",
                                 .frequency = frequency ? frequency->size : 0.0,
                                 .frequency_name = frequency ? frequency->shown : ""};
    choose_length(units, choice.of[UNIT_LENGTH]);
    return status;
}

const char *whirl_shown_counted(const whirl_shown_units *units, whirl_counting counting) {
    return counting == WHIRL_AMPLITUDE ? units->amplitude_name : counting == WHIRL_ZERO_TO_PEAK ? "0-p" : "";
}

bool whirl_shown_one_length(const whirl_shown_units *units, const whirl_table *table) {
    return units->ratio || !table || !table->length_scales;
}

double whirl_shown_length(const whirl_shown_units *units, const whirl_table *table, size_t point) {
    if (whirl_shown_one_length(units, table)) return units->length;
    return units->length * (whirl_result_length_scale(units->result, table, point) / units->result->length_scale);
}

whirl_unit whirl_shown_parameter(const whirl_shown_units *units, const char *name) {
    const char *si = whirl_result_parameter_unit(units->result, name);
    const whirl_unit *own = strcmp(si, "rad/s") == 0 ? &units->speed : strcmp(si, "m") == 0 ? &units->size : NULL;
    if (own && own->size > 0.0) return *own;
    whirl_unit unit = whirl_result_unit(units->result, name);
    if (strcmp(unit.name, "um") == 0) snprintf(unit.name, sizeof unit.name, "%s", shown_name("um"));
    return unit;
}
