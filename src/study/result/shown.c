// Units in which numbers are shown: see whirl/internal/shown.h.
#include "whirl/internal/shown.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "unit_words.h"
#include "whirl/status.h"

static bool shown_near(double a, double b) {
    return fabs(a - b) <= 1e-12 * fabs(b);
}

/// Returns true if a parameter is the length scale of a table's points. If the parameter varies along the table, its
/// values must equal the scales; if the scale varies with another one, the parameter must be an expression of that.
static bool is_scale_of(const whirl_result *result, const whirl_table *table, const whirl_parameter *candidate) {
    const bool expression = candidate->text[strspn(candidate->text, " \t")] == '=';
    if (strcmp(table->parameter, candidate->name) != 0) return !table->length_scales || expression;
    for (size_t i = 0; i < table->count; i++)
        if (!shown_near(table->values[i], whirl_result_length_scale(result, table, i))) return false;
    return true;
}

/// Returns the parameter that is the length scale, or NULL.
static const whirl_parameter *scale_parameter(const whirl_result *result) {
    for (size_t i = 0; i < result->parameter_count; i++) {
        const whirl_parameter *candidate = &result->parameters[i];
        bool is = strcmp(candidate->unit, "m") == 0 && shown_near(candidate->value, result->length_scale);
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
    // A requested unit comes first, then the parameter that is the scale, then the scale itself.
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

/// Returns the unit that a word names, of size 0 if none.
static whirl_unit shown_chosen(const unit_word *word) {
    whirl_unit unit = {.size = word ? word->size : 0.0};
    if (word) snprintf(unit.name, sizeof unit.name, "%s", word->shown);
    return unit;
}

/// Units of quantities in documents by default, and the kind of choice that overrides them.
static const struct {
    const char *name;
    double size;
    unit_kind kind; ///< UNIT_KINDS: no choice overrides this unit
} shown_quantities[WHIRL_QUANTITIES] = {
    [WHIRL_QUANTITY_NUMBER] = {"", 1.0, UNIT_KINDS},
    [WHIRL_QUANTITY_PERCENT] = {"%", 1.0, UNIT_KINDS},
    [WHIRL_QUANTITY_DEGREES] = {"deg", 1.0, UNIT_KINDS},
    [WHIRL_QUANTITY_SPEED] = {"rpm", 0.104719755119659774, UNIT_SPEED},
    [WHIRL_QUANTITY_FREQUENCY] = {"Hz", 6.283185307179586477, UNIT_FREQUENCY},
    [WHIRL_QUANTITY_ANGULAR] = {"rad/s", 1.0, UNIT_KINDS},
    [WHIRL_QUANTITY_RATE] = {"1/s", 1.0, UNIT_KINDS},
    [WHIRL_QUANTITY_TIME] = {"s", 1.0, UNIT_KINDS},
    [WHIRL_QUANTITY_LENGTH] = {"", 1.0, UNIT_LENGTH},
    [WHIRL_QUANTITY_SIZE] = {"", 1.0, UNIT_LENGTH},
    [WHIRL_QUANTITY_SPAN] = {"\u00b5m p-p", 1e-6, UNIT_LENGTH},
    [WHIRL_QUANTITY_POSITION] = {"m", 1.0, UNIT_SYSTEM},
    [WHIRL_QUANTITY_DIAMETER] = {"mm", 1e-3, UNIT_SYSTEM},
    [WHIRL_QUANTITY_SLOPE] = {"mrad", 1e-3, UNIT_KINDS},
    [WHIRL_QUANTITY_FORCE] = {"N", 1.0, UNIT_FORCE},
    [WHIRL_QUANTITY_MOMENT] = {"N m", 1.0, UNIT_MOMENT},
    [WHIRL_QUANTITY_MASS] = {"kg", 1.0, UNIT_MASS},
    [WHIRL_QUANTITY_INERTIA] = {"kg m2", 1.0, UNIT_INERTIA},
    [WHIRL_QUANTITY_UNBALANCE] = {"kg mm", 1e-3, UNIT_UNBALANCE},
    [WHIRL_QUANTITY_STIFFNESS] = {"MN/m", 1e6, UNIT_STIFFNESS},
    [WHIRL_QUANTITY_CROSS] = {"N/m", 1.0, UNIT_STIFFNESS},
    [WHIRL_QUANTITY_DAMPING] = {"kN s/m", 1e3, UNIT_DAMPING},
    [WHIRL_QUANTITY_DENSITY] = {"kg/m3", 1.0, UNIT_DENSITY},
    [WHIRL_QUANTITY_PRESSURE] = {"MPa", 1e6, UNIT_PRESSURE},
    [WHIRL_QUANTITY_FLOW] = {"l/min", 1e-3 / 60.0, UNIT_FLOW},
    [WHIRL_QUANTITY_POWER] = {"kW", 1e3, UNIT_POWER},
    [WHIRL_QUANTITY_TEMPERATURE] = {"degC", 1.0, UNIT_TEMPERATURE},
    [WHIRL_QUANTITY_VISCOSITY] = {"mPa s", 1e-3, UNIT_VISCOSITY},
    [WHIRL_QUANTITY_WEIGHT] = {"g", 1e-3, UNIT_WEIGHT},
    [WHIRL_QUANTITY_RESIDUAL] = {"g mm", 1e-6, UNIT_UNBALANCE},
    [WHIRL_QUANTITY_ACCELERATION] = {"m/s2", 1.0, UNIT_SYSTEM},
};

/// Fills in the unit of every quantity.
static void choose_quantities(whirl_shown_units *units, const unit_choice *choice) {
    // Take for each quantity the requested unit, or its usual one.
    const whirl_unit length = units->size.size > 0.0 ? units->size : whirl_result_length_unit(units->result);
    for (int quantity = 0; quantity < WHIRL_QUANTITIES; quantity++) {
        const unit_kind kind = shown_quantities[quantity].kind;
        const unit_word *word = kind == UNIT_SYSTEM ? unit_of_system(choice->of[UNIT_SYSTEM], kind)
                                : kind < UNIT_KINDS ? choice->of[kind]
                                                    : NULL;
        whirl_unit *unit = &units->of[quantity];
        unit->size = shown_quantities[quantity].size;
        snprintf(unit->name, sizeof unit->name, "%s", shown_quantities[quantity].name);
        units->chosen[quantity] = word && word->size > 0.0;
        if (units->chosen[quantity]) {
            unit->size = word->size * (kind == UNIT_FREQUENCY ? shown_quantities[quantity].size : 1.0);
            snprintf(unit->name, sizeof unit->name,
                     quantity == WHIRL_QUANTITY_SPAN           ? "%s p-p"
                     : quantity == WHIRL_QUANTITY_ACCELERATION ? "%s/s2"
                                                               : "%s",
                     word->shown);
        }
    }
    // Set the zero of temperatures, and the chosen unit of lengths.
    const char *const degrees = units->of[WHIRL_QUANTITY_TEMPERATURE].name;
    units->zero = strcmp(degrees, "degC") == 0 ? 273.15 : strcmp(degrees, "degF") == 0 ? 459.67 : 0.0;
    units->of[WHIRL_QUANTITY_LENGTH] = length;
    units->of[WHIRL_QUANTITY_SIZE].size = length.size / units->amplitude;
    snprintf(units->of[WHIRL_QUANTITY_SIZE].name, sizeof units->of->name, "%.40s %s", length.name,
             units->amplitude_name);
}

whirl_status whirl_result_shown_units(const whirl_result *result, const char *asked, whirl_shown_units *units) {
    unit_choice choice, own;
    const whirl_status status = unit_choice_read(asked ? asked : "", &choice);
    if (status.code != WHIRL_OK) return status;
    // A file may contain anything; an invalid choice is ignored.
    if (unit_choice_read(whirl_result_fact(result, "units"), &own).code != WHIRL_OK) own = (unit_choice){0};
    // A requested system replaces the case's words entirely.
    const bool whole = choice.of[UNIT_SYSTEM] != NULL;
    for (int kind = 0; kind < UNIT_KINDS && !whole; kind++)
        if (!choice.of[kind]) choice.of[kind] = own.of[kind];
    for (int kind = 0; kind < UNIT_SYSTEM; kind++)
        if (!choice.of[kind]) choice.of[kind] = unit_of_system(choice.of[UNIT_SYSTEM], (unit_kind)kind);
    const unit_word *amplitude = choice.of[UNIT_AMPLITUDE], *frequency = choice.of[UNIT_FREQUENCY];
    *units = (whirl_shown_units){.result = result,
                                 .speed = shown_chosen(choice.of[UNIT_SPEED]),
                                 .size = shown_chosen(choice.of[UNIT_LENGTH]),
                                 .amplitude = amplitude ? amplitude->size : 1.0,
                                 .amplitude_name = amplitude ? amplitude->shown : "0-p",
                                 .frequency = frequency ? frequency->size : 0.0,
                                 .frequency_name = frequency ? frequency->shown : ""};
    choose_length(units, choice.of[UNIT_LENGTH]);
    choose_quantities(units, &choice);
    return status;
}

whirl_status whirl_shown_units_alone(const char *asked, whirl_shown_units *units) {
    static const whirl_result none = {.length_scale = 1e-6};
    return whirl_result_shown_units(&none, asked, units);
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

/// SI units of parameters, and the quantities whose choice of a unit they follow.
static const struct {
    const char *si;
    whirl_quantity quantity;
} shown_parameters[] = {
    {"rad/s", WHIRL_QUANTITY_SPEED},    {"m", WHIRL_QUANTITY_LENGTH},    {"N", WHIRL_QUANTITY_FORCE},
    {"N m", WHIRL_QUANTITY_MOMENT},     {"kg", WHIRL_QUANTITY_MASS},     {"kg m2", WHIRL_QUANTITY_INERTIA},
    {"kg m", WHIRL_QUANTITY_UNBALANCE}, {"N/m", WHIRL_QUANTITY_CROSS},   {"N s/m", WHIRL_QUANTITY_DAMPING},
    {"kg/m3", WHIRL_QUANTITY_DENSITY},  {"Pa", WHIRL_QUANTITY_PRESSURE}, {"m3/s", WHIRL_QUANTITY_FLOW},
    {"Pa s", WHIRL_QUANTITY_VISCOSITY}, {"W", WHIRL_QUANTITY_POWER}};

const char *whirl_shown_si(const whirl_shown_units *units, size_t index, whirl_unit *unit) {
    if (index >= sizeof shown_parameters / sizeof *shown_parameters) return NULL;
    const whirl_quantity quantity = shown_parameters[index].quantity;
    *unit = quantity == WHIRL_QUANTITY_SPEED    ? units->speed
            : quantity == WHIRL_QUANTITY_LENGTH ? units->size
            : units->chosen[quantity]           ? units->of[quantity]
                                                : (whirl_unit){.size = 0.0};
    return shown_parameters[index].si;
}

whirl_unit whirl_shown_chosen(const whirl_shown_units *units, const char *si) {
    const char *own;
    whirl_unit unit;
    for (size_t i = 0; (own = whirl_shown_si(units, i, &unit)) != NULL; i++)
        if (strcmp(own, si) == 0) return unit;
    return (whirl_unit){.size = 0.0};
}

whirl_unit whirl_shown_parameter(const whirl_shown_units *units, const char *name) {
    whirl_unit unit = whirl_shown_chosen(units, whirl_result_parameter_unit(units->result, name));
    if (unit.size > 0.0) return unit;
    unit = whirl_result_unit(units->result, name);
    if (strcmp(unit.name, "um") == 0) snprintf(unit.name, sizeof unit.name, "%s", shown_name("um"));
    return unit;
}
