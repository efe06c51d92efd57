#include "unit_words.h"
#include "whirl/status.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "whirl/engine/descriptor.h"

enum { LONGEST_WORD = 31 };

/// Pound (0.45359237 kg), inch, the pound's weight at 9.80665 m/s2, and the US gallon (NIST SP 811, 2008, appendix B).
#define POUND 0.45359237
#define INCH 25.4e-3
#define POUND_FORCE (POUND * 9.80665)
#define GALLON (231.0 * INCH * INCH * INCH)

static const unit_word words[] = {
    {"scale", "", UNIT_LENGTH, 0.0},
    {"m", "m", UNIT_LENGTH, 1.0},
    {"mm", "mm", UNIT_LENGTH, 1e-3},
    {"um", "\u00b5m", UNIT_LENGTH, 1e-6},
    {"in", "in", UNIT_LENGTH, 25.4e-3},
    {"mil", "mil", UNIT_LENGTH, 25.4e-6},
    {"rad/s", "rad/s", UNIT_SPEED, 1.0},
    {"rpm", "rpm", UNIT_SPEED, 0.10471975511965977462}, // 2 pi/60
    {"order", "", UNIT_FREQUENCY, 0.0},
    {"Hz", "Hz", UNIT_FREQUENCY, 1.0},
    {"cpm", "cpm", UNIT_FREQUENCY, 1.0 / 60.0},
    {"0-p", "0-p", UNIT_AMPLITUDE, 1.0},
    {"p-p", "p-p", UNIT_AMPLITUDE, 2.0},
    {"rms", "rms", UNIT_AMPLITUDE, 0.70710678118654752440},
    {"N", "N", UNIT_FORCE, 1.0},
    {"kN", "kN", UNIT_FORCE, 1e3},
    {"lbf", "lbf", UNIT_FORCE, POUND_FORCE},
    {"kg", "kg", UNIT_MASS, 1.0},
    {"lbm", "lbm", UNIT_MASS, POUND},
    {"N/m", "N/m", UNIT_STIFFNESS, 1.0},
    {"N/mm", "N/mm", UNIT_STIFFNESS, 1e3},
    {"MN/m", "MN/m", UNIT_STIFFNESS, 1e6},
    {"lbf/in", "lbf/in", UNIT_STIFFNESS, POUND_FORCE / INCH},
    {"N s/m", "N s/m", UNIT_DAMPING, 1.0},
    {"kN s/m", "kN s/m", UNIT_DAMPING, 1e3},
    {"lbf s/in", "lbf s/in", UNIT_DAMPING, POUND_FORCE / INCH},
    {"N m", "N m", UNIT_MOMENT, 1.0},
    {"lbf in", "lbf in", UNIT_MOMENT, POUND_FORCE *INCH},
    {"kg m2", "kg m2", UNIT_INERTIA, 1.0},
    {"lbm in2", "lbm in2", UNIT_INERTIA, POUND *INCH *INCH},
    {"kg mm", "kg mm", UNIT_UNBALANCE, 1e-3},
    {"g mm", "g mm", UNIT_UNBALANCE, 1e-6},
    {"oz in", "oz in", UNIT_UNBALANCE, POUND / 16.0 * INCH},
    {"kg/m3", "kg/m3", UNIT_DENSITY, 1.0},
    {"lbm/ft3", "lbm/ft3", UNIT_DENSITY, POUND / (12.0 * INCH * 12.0 * INCH * 12.0 * INCH)},
    {"Pa", "Pa", UNIT_PRESSURE, 1.0},
    {"MPa", "MPa", UNIT_PRESSURE, 1e6},
    {"bar", "bar", UNIT_PRESSURE, 1e5},
    {"psi", "psi", UNIT_PRESSURE, POUND_FORCE / (INCH * INCH)},
    {"l/min", "l/min", UNIT_FLOW, 1e-3 / 60.0},
    {"gpm", "gpm", UNIT_FLOW, GALLON / 60.0},
    {"W", "W", UNIT_POWER, 1.0},
    {"kW", "kW", UNIT_POWER, 1e3},
    {"hp", "hp", UNIT_POWER, 550.0 * 12.0 * INCH *POUND_FORCE}, // 550 ft lbf/s
    {"K", "K", UNIT_TEMPERATURE, 1.0},
    {"degC", "degC", UNIT_TEMPERATURE, 1.0},
    {"degF", "degF", UNIT_TEMPERATURE, 5.0 / 9.0},
    {"mPa s", "mPa s", UNIT_VISCOSITY, 1e-3},
    {"cP", "cP", UNIT_VISCOSITY, 1e-3},
    {"reyn", "reyn", UNIT_VISCOSITY, POUND_FORCE / (INCH * INCH)}, // lbf s/in2
    {"g", "g", UNIT_WEIGHT, 1e-3},
    {"oz", "oz", UNIT_WEIGHT, POUND / 16.0},
    {"SI", "SI", UNIT_SYSTEM, 0.0},
    {"US", "US", UNIT_SYSTEM, 0.0},
    {NULL, NULL, UNIT_KINDS, 0.0},
};

/// Units of the system US, by kind; under UNIT_SYSTEM the unit of places along shafts and of diameters. NULL: the same
/// unit as without a system.
static const char *const customary[UNIT_KINDS] = {
    [UNIT_LENGTH] = "mil",    [UNIT_SPEED] = "rpm",       [UNIT_FREQUENCY] = "cpm",    [UNIT_AMPLITUDE] = "p-p",
    [UNIT_FORCE] = "lbf",     [UNIT_MASS] = "lbm",        [UNIT_STIFFNESS] = "lbf/in", [UNIT_DAMPING] = "lbf s/in",
    [UNIT_MOMENT] = "lbf in", [UNIT_INERTIA] = "lbm in2", [UNIT_UNBALANCE] = "oz in",  [UNIT_DENSITY] = "lbm/ft3",
    [UNIT_PRESSURE] = "psi",  [UNIT_FLOW] = "gpm",        [UNIT_POWER] = "hp",         [UNIT_TEMPERATURE] = "degF",
    [UNIT_VISCOSITY] = "cP",  [UNIT_WEIGHT] = "oz",       [UNIT_SYSTEM] = "in"};

const unit_word *unit_words(void) {
    return words;
}

static const unit_word *unit_words_find(const char *word) {
    for (const unit_word *one = words; one->word; one++)
        if (strcmp(one->word, word) == 0) return one;
    return NULL;
}

const unit_word *unit_of_system(const unit_word *system, unit_kind kind) {
    const bool is_customary = system && strcmp(system->word, "US") == 0 && customary[kind];
    return is_customary ? unit_words_find(customary[kind]) : NULL;
}

static whirl_status unit_words_unknown(const char *word) {
    const char *names[sizeof words / sizeof *words];
    char list[512] = "";
    size_t count = 0, used = 0;
    for (; words[count].word; count++) {
        names[count] = words[count].word;
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", count ? ", " : "", words[count].word);
    }
    const char *nearest = whirl_nearest_name(word, names, count);
    if (nearest) return whirl_fail(WHIRL_BAD_INPUT, "'%s' is no unit of figures, did you mean %s?", word, nearest);
    return whirl_fail(WHIRL_BAD_INPUT, "'%s' is no unit of figures, expected some of %s", word, list);
}

static whirl_status unit_words_add(unit_choice *choice, const char *word) {
    static const char *const kinds[UNIT_KINDS] = {
        "lengths", "speeds",       "frequencies", "amplitudes",        "forces",          "masses",    "stiffness",
        "damping", "moments",      "inertia",     "unbalance",         "density",         "pressures", "flows",
        "powers",  "temperatures", "viscosities", "masses of weights", "systems of units"};
    const unit_word *found = unit_words_find(word);
    if (!found) return unit_words_unknown(word);
    const unit_word *other = choice->of[found->kind];
    if (other && other != found)
        return whirl_fail(WHIRL_BAD_INPUT, "%s and %s are both for %s, expected one of them", other->word, found->word,
                          kinds[found->kind]);
    choice->of[found->kind] = found;
    return whirl_ok();
}

whirl_status unit_choice_read(const char *text, unit_choice *choice) {
    *choice = (unit_choice){0};
    if (text[strspn(text, " ")] == '\0') return whirl_ok();
    for (const char *from = text; from;) {
        const size_t length = strcspn(from, ",");
        size_t first = strspn(from, " "), end = length;
        while (end > first && from[end - 1] == ' ') end--;
        first = first < end ? first : end;
        char word[LONGEST_WORD + 1];
        snprintf(word, sizeof word, "%.*s", (int)(end - first < LONGEST_WORD ? end - first : LONGEST_WORD),
                 from + first);
        const whirl_status status = unit_words_add(choice, word);
        if (status.code != WHIRL_OK) return status;
        from = from[length] == ',' ? from + length + 1 : NULL;
    }
    return whirl_ok();
}
