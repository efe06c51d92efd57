// Converts numbers in sentences of the engine, such as warnings, to shown units. The engine writes every number with
// its unit, in SI or as in the case ("at T = 323.15 K and c = 0.1 mm"), so that a number to convert is one before a
// known unit. Differences of temperatures must not be written as "5 K".
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number_shown.h"
#include "number_text.h"
#include "unit_words.h"
#include "whirl/engine/result.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"

/// Units in sentences of the engine that the words of `--units` (unit_words) lack.
static const unit_word sentence_units[] = {{"Pa s", "Pa s", UNIT_VISCOSITY, 1.0}, {"kg m", "kg m", UNIT_UNBALANCE, 1.0},
                                           {"m3/s", "m3/s", UNIT_FLOW, 1.0},      {"m/s", "m/s", UNIT_SYSTEM, 1.0},
                                           {"m/s2", "m/s2", UNIT_SYSTEM, 1.0},    {NULL, NULL, UNIT_KINDS, 0.0}};

/// Quantity in whose unit numbers of each kind are shown.
static const whirl_quantity sentence_quantities[UNIT_KINDS] = {
    [UNIT_LENGTH] = WHIRL_QUANTITY_LENGTH,       [UNIT_SPEED] = WHIRL_QUANTITY_SPEED,
    [UNIT_FREQUENCY] = WHIRL_QUANTITY_FREQUENCY, [UNIT_FORCE] = WHIRL_QUANTITY_FORCE,
    [UNIT_MASS] = WHIRL_QUANTITY_MASS,           [UNIT_STIFFNESS] = WHIRL_QUANTITY_STIFFNESS,
    [UNIT_DAMPING] = WHIRL_QUANTITY_DAMPING,     [UNIT_MOMENT] = WHIRL_QUANTITY_MOMENT,
    [UNIT_INERTIA] = WHIRL_QUANTITY_INERTIA,     [UNIT_UNBALANCE] = WHIRL_QUANTITY_UNBALANCE,
    [UNIT_DENSITY] = WHIRL_QUANTITY_DENSITY,     [UNIT_PRESSURE] = WHIRL_QUANTITY_PRESSURE,
    [UNIT_FLOW] = WHIRL_QUANTITY_FLOW,           [UNIT_POWER] = WHIRL_QUANTITY_POWER,
    [UNIT_VISCOSITY] = WHIRL_QUANTITY_VISCOSITY, [UNIT_TEMPERATURE] = WHIRL_QUANTITY_TEMPERATURE,
    [UNIT_WEIGHT] = WHIRL_QUANTITY_WEIGHT,       [UNIT_SYSTEM] = WHIRL_QUANTITY_ACCELERATION};

/// Returns the length of `word` if it is the whole unit with which a text begins, else 0: "N m/rad" does not begin with
/// the unit "N".
static size_t sentence_begins(const char *text, const char *word) {
    const size_t length = strlen(word);
    if (length == 0 || strncmp(text, word, length) != 0) return 0;
    const char *next = text + length;
    if (isalnum((unsigned char)*next) || *next == '/' || *next == '^') return 0;
    // A further factor, such as "m/rad" or "s2", makes it another unit.
    const size_t further = *next == ' ' ? strcspn(next + 1, " ,;:)") : 0;
    for (size_t i = 1; i < further; i++)
        if (isalpha((unsigned char)next[1]) && (next[1 + i] == '/' || isdigit((unsigned char)next[1 + i]))) return 0;
    return length;
}

/// Finds the longest unit with which a text begins.
static const unit_word *sentence_unit(const char *text, size_t *length) {
    const unit_word *const lists[] = {unit_words(), sentence_units}, *found = NULL;
    *length = 0;
    for (size_t k = 0; k < 2; k++)
        for (const unit_word *one = lists[k]; one->word; one++) {
            if (!(one->size > 0.0) || one->kind == UNIT_AMPLITUDE) continue;
            const size_t word = sentence_begins(text, one->word), shown = sentence_begins(text, one->shown);
            const size_t own = word > shown ? word : shown;
            if (own <= *length) continue;
            *length = own;
            found = one;
        }
    return found;
}

/// Returns the offset of temperatures in a unit.
static double sentence_zero(const unit_word *from) {
    return strcmp(from->word, "degC") == 0 ? 273.15 : strcmp(from->word, "degF") == 0 ? 459.67 : 0.0;
}

/// Finds the shown unit for numbers in the unit `from`; returns false if numbers keep their unit.
static bool sentence_target(const whirl_shown_units *units, const unit_word *from, whirl_unit *to, double *zero) {
    const whirl_quantity quantity = sentence_quantities[from->kind];
    *to = units->of[quantity];
    *zero = from->kind == UNIT_TEMPERATURE ? units->zero : 0.0;
    if (from->kind == UNIT_TEMPERATURE) return true;
    if (from->kind == UNIT_SPEED) *to = units->speed;
    if (from->kind == UNIT_LENGTH) *to = units->size;
    if (from->kind == UNIT_FREQUENCY) {
        *to = (whirl_unit){.size = units->frequency};
        snprintf(to->name, sizeof to->name, "%s", units->frequency_name);
    }
    // Velocities take the unit of accelerations without its last "2": "in/s" of "in/s2".
    if (from->kind == UNIT_SYSTEM && strcmp(from->word, "m/s") == 0) to->name[strlen(to->name) - 1] = '\0';
    const bool own = from->kind == UNIT_SPEED || from->kind == UNIT_LENGTH || from->kind == UNIT_FREQUENCY;
    return to->size > 0.0 && (own || units->chosen[quantity]);
}

/// Returns the number of significant digits of a number as it is written.
static int sentence_digits(const char *number, size_t length) {
    int digits = 0;
    for (size_t i = 0; i < length && number[i] != 'e'; i++)
        if (isdigit((unsigned char)number[i]) && (digits > 0 || number[i] != '0')) digits++;
    return digits;
}

void whirl_shown_sentence(const whirl_shown_units *units, const char *sentence, char *text, size_t size) {
    static const int least_digits = 4, most_digits = 6;
    size_t used = 0;
    for (const char *at = sentence; *at && used + 1 < size;) {
        // Find a number with a known unit at this place.
        const bool begins = at == sentence || strchr(" (=,", at[-1]);
        char *end = NULL;
        const double number = begins && (isdigit((unsigned char)*at) || *at == '-') ? strtod(at, &end) : 0.0;
        size_t length = 0;
        double zero = 0.0;
        whirl_unit to;
        const unit_word *const from = end && end > at && *end == ' ' ? sentence_unit(end + 1, &length) : NULL;
        if (!from || !sentence_target(units, from, &to, &zero)) {
            // Copy a number without a known unit whole, so that no part of it is taken for a number.
            const size_t plain = end && end > at ? (size_t)(end - at) : 1;
            for (size_t i = 0; i < plain && used + 1 < size; i++) text[used++] = *at++;
            continue;
        }
        // Convert the number, and write it with as many digits as it had, within limits.
        const int digits = sentence_digits(at, (size_t)(end - at));
        char shown[NUMBER_SIZE];
        number_shown((number + sentence_zero(from)) * from->size / to.size - zero,
                     digits < least_digits  ? least_digits
                     : digits < most_digits ? digits
                                            : most_digits,
                     shown, sizeof shown);
        const int written = snprintf(text + used, size - used, "%s %s", shown, to.name);
        used += written > 0 && (size_t)written < size - used ? (size_t)written : size - used - 1;
        at = end + 1 + length;
    }
    text[used] = '\0';
}
